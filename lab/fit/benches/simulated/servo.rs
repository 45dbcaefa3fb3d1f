//! Servo drives that are moved along two sines under forces of motor and load that swing by themselves: the friction of
//! model M5 of Duclusaud and others.

use std::f64::consts::TAU;
use std::fmt::Write;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, Waves, normal, truth, value};

/// A servo drive, its motion and its forces.
pub struct Servo {
    values: [(&'static str, f64); 8],
    waves: Waves,
    /// Mean and amplitude, N, and frequency, Hz, of the forces of motor and load.
    forces: [[f64; 3]; 2],
}

/// Of the samples, s; noise as a part of the largest force.
const INTERVAL: f64 = 2e-3;
const NOISE: f64 = 0.01;
const DURATION: f64 = 8.0;

/// Exponent of the Stribeck curve: the start value of the model, which a fit holds.
const EXPONENT: f64 = 1.323;

impl Servo {
    /// A drive whose Stribeck velocity is a part of its largest speed.
    pub fn drawn(random: &mut fastrand::Rng) -> Servo {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let waves = Waves([[between(0.02, 0.05), between(0.3, 0.6)], [between(3e-3, 8e-3), between(1.0, 3.0)]]);
        let fastest = waves.fastest();
        let values = [
            ("kinetic_force", between(2.0, 6.0)),
            ("excess_force", between(1.0, 3.0)),
            ("motor_coefficient", between(0.05, 0.3)),
            ("load_coefficient", between(0.05, 0.3)),
            ("motor_excess", between(0.05, 0.2)),
            ("load_excess", between(0.05, 0.2)),
            ("stribeck_velocity", fastest * between(0.1, 0.3)),
            ("viscous_coefficient", between(1.0, 4.0) / fastest),
        ];
        let forces = [
            [between(2.0, 10.0), between(10.0, 30.0), between(0.5, 1.5)],
            [-between(2.0, 10.0), between(10.0, 30.0), between(1.6, 3.0)],
        ];
        Servo { values, waves, forces }
    }

    fn value(&self, name: &str) -> f64 {
        value(&self.values, name)
    }

    /// The forces of motor and load.
    fn driven(&self, t: f64) -> [f64; 2] {
        self.forces.map(|[mean, amplitude, rate]| mean + amplitude * (TAU * rate * t).sin())
    }

    fn friction(&self, t: f64) -> f64 {
        let ([_, v, _], [motor, load]) = (self.waves.motion(t), self.driven(t));
        let carried = |of_load: &str, of_motor: &str| (self.value(of_load) * load - self.value(of_motor) * motor).abs();
        let kinetic = self.value("kinetic_force") + carried("load_coefficient", "motor_coefficient");
        let excess = self.value("excess_force") + carried("load_excess", "motor_excess");
        let falling = (-(v / self.value("stribeck_velocity")).abs().powf(EXPONENT)).exp();
        let sense = if v == 0.0 { 0.0 } else { v.signum() };
        (kinetic + falling * excess) * sense + self.value("viscous_coefficient") * v
    }
}

impl Simulated for Servo {
    fn asked(&self) -> Inquiry {
        Inquiry { law: vec!["ServoFriction".to_owned()], ..Inquiry::default() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        let times: Vec<f64> = (0..(DURATION / INTERVAL) as u32).map(|at| f64::from(at) * INTERVAL).collect();
        let most = times.iter().fold(0.0, |most: f64, t| most.max(self.friction(*t).abs()));
        let mut text = "time [s],force [N],displacement [m],motor_force [N],load_force [N]\n".to_owned();
        for t in times {
            let ([motor, load], place) = (self.driven(t), self.waves.motion(t)[0] + 1e-6 * normal(random));
            let force = self.friction(t) + NOISE * most * normal(random);
            let _ = writeln!(text, "{t},{force},{place},{motor},{load}");
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        truth(&self.values, one)
    }
}
