//! Magnetorheological dampers that are moved along two sines from rest under a voltage that swings, by the classical
//! Runge-Kutta method.

use std::f64::consts::TAU;
use std::fmt::Write;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, Waves, normal, truth, value};

/// A damper, its motion and its voltage.
pub struct Damper {
    /// Its parameters by their names; those of the form of the hysteresis are those of Spencer and others.
    pub values: [(&'static str, f64); 10],
    waves: Waves,
    /// Largest voltage, V, and its frequency, Hz.
    voltage: [f64; 2],
}

/// Of the samples, s; steps of the simulation in one of them; noise as a part of the largest force.
const INTERVAL: f64 = 4e-3;
const PARTS: u32 = 200;
const NOISE: f64 = 0.01;
const DURATION: f64 = 3.0;

/// Form of the hysteresis: A, and gamma and beta.
const SLOPE: f64 = 301.0;
const FORM: f64 = 3.63e6;

impl Damper {
    /// A damper with values around those of Spencer and others.
    pub fn drawn(random: &mut fastrand::Rng) -> Damper {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let printed = [
            ("c_0a", 2100.0),
            ("c_0b", 350.0),
            ("k_0", 4690.0),
            ("c_1a", 28_300.0),
            ("c_1b", 295.0),
            ("alpha_a", 14_000.0),
            ("alpha_b", 69_500.0),
            ("k_1", 500.0),
            ("x_0", 0.143),
            ("voltage_rate", 60.0),
        ];
        let values = printed.map(|(name, value)| (name, value * between(0.6, 1.6)));
        let waves = Waves([[between(5e-3, 1.5e-2), between(0.6, 1.2)], [between(1e-3, 3e-3), between(2.0, 4.0)]]);
        Damper { values, waves, voltage: [between(1.0, 2.0), between(1.0, 2.0)] }
    }

    fn value(&self, name: &str) -> f64 {
        value(&self.values, name)
    }

    fn voltage(&self, t: f64) -> f64 {
        let [most, rate] = self.voltage;
        0.5 * most * (1.0 - (TAU * rate * t).cos())
    }

    /// Rates of y, z and u, and the force.
    fn rates(&self, t: f64, [y, z, u]: [f64; 3]) -> ([f64; 3], f64) {
        let [x, v, _] = self.waves.motion(t);
        let by_voltage = |name: &str| self.value(&format!("{name}a")) + self.value(&format!("{name}b")) * u;
        let [alpha, c_0, c_1] = ["alpha_", "c_0", "c_1"].map(by_voltage);
        let dy = (alpha * z + c_0 * v + self.value("k_0") * (x - y)) / (c_0 + c_1);
        let slip = v - dy;
        let dz = SLOPE * slip - FORM * slip.abs() * z * z.abs() - FORM * slip * z * z;
        let du = self.value("voltage_rate") * (self.voltage(t) - u);
        ([dy, dz, du], c_1 * dy + self.value("k_1") * (x - self.value("x_0")))
    }

    /// Forces without noise.
    fn forces(&self) -> Vec<f64> {
        let (step, mut at) = (INTERVAL / f64::from(PARTS), [0.0; 3]);
        let mut found = Vec::new();
        for number in 0..(DURATION / INTERVAL) as u32 * PARTS {
            let t = f64::from(number) * step;
            let along = |rate: [f64; 3], part: f64| std::array::from_fn(|i| at[i] + part * step * rate[i]);
            let (first, force) = self.rates(t, at);
            let (second, _) = self.rates(t + 0.5 * step, along(first, 0.5));
            let (third, _) = self.rates(t + 0.5 * step, along(second, 0.5));
            let (fourth, _) = self.rates(t + step, along(third, 1.0));
            if number % PARTS == 0 {
                found.push(force);
            }
            at =
                std::array::from_fn(|i| at[i] + step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]));
        }
        found
    }
}

impl Simulated for Damper {
    fn asked(&self) -> Inquiry {
        Inquiry { law: vec!["MagnetorheologicalDamper".to_owned()], ..Inquiry::default() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        let forces = self.forces();
        let most = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let mut text = "time [s],force [N],displacement [m],voltage [V]\n".to_owned();
        for (at, force) in forces.iter().enumerate() {
            let t = at as f64 * INTERVAL;
            let place = self.waves.motion(t)[0] + 1e-6 * normal(random);
            let _ = writeln!(text, "{t},{},{place},{}", force + NOISE * most * normal(random), self.voltage(t));
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        truth(&self.values, one)
    }
}
