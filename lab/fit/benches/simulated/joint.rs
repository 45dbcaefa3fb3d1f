//! Joints in closed loop, with an encoder; every other one is an arm with gravity.

use std::f64::consts::TAU;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, normal};

/// A joint, the motion that its controller wants, and how it is measured.
pub struct Joint {
    inertia: f64,
    level: f64,
    viscous: f64,
    offset: f64,
    /// Gravity of an arm, N m, and the angle at which it is horizontal; 0 of other joints.
    gravity: [f64; 2],
    /// Size in rad, frequency in Hz and phase of each wave.
    waves: Vec<[f64; 3]>,
    interval: f64,
    encoder: f64,
    /// Noise of torque and velocity.
    noise: [f64; 2],
    has_velocity: bool,
}

/// Steps of the simulation in a sample.
const PARTS: u32 = 20;

impl Joint {
    /// A joint, an arm if the seed is even.
    pub fn drawn(seed: u64, random: &mut fastrand::Rng) -> Joint {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let [inertia, level, viscous] = [between(0.01, 1.0), between(0.1, 3.0), between(0.05, 1.0)];
        let gravity =
            if seed.is_multiple_of(2) { [between(0.3, 5.0), 6.0 * between(0.1, 1.0) - 3.0] } else { [0.0; 2] };
        let wave = |number: i32| [between(0.2, 1.2) / f64::from(1 + number), between(0.15, 0.6) * 1.9_f64.powi(number)];
        let waves: Vec<[f64; 2]> = (0..3).map(wave).collect();
        let noise = [level * between(0.005, 0.03), between(3e-4, 5e-3)];
        Joint {
            inertia,
            level,
            viscous,
            offset: 0.6 * random.f64() - 0.3,
            gravity,
            waves: waves.into_iter().map(|[size, rate]| [size, rate, TAU * random.f64()]).collect(),
            interval: [0.001, 0.002, 0.004][random.usize(0..3)],
            encoder: TAU / f64::from(1 << [14, 16, 18][random.usize(0..3)]),
            noise,
            has_velocity: seed % 4 < 2,
        }
    }

    /// Wanted angle and velocity.
    fn wanted(&self, t: f64) -> [f64; 2] {
        let part = |[size, rate, phase]: [f64; 3]| {
            let (sine, cosine) = (TAU * rate * t + phase).sin_cos();
            [size * sine, size * TAU * rate * cosine]
        };
        self.waves.iter().map(|wave| part(*wave)).fold([0.0; 2], |[q, v], [of_q, of_v]| [q + of_q, v + of_v])
    }

    /// Angle and velocity a short time later; it stops where its velocity changes its sign.
    fn moved(&self, [q, v]: [f64; 2], torque: f64, step: f64) -> [f64; 2] {
        let middle = q + 0.5 * step * v - self.gravity[1];
        let drive = torque - self.offset - self.gravity[0] * middle.cos();
        if v == 0.0 && drive.abs() <= self.level {
            return [q, v];
        }
        let direction = if v == 0.0 { drive.signum() } else { v.signum() };
        let rate = |v: f64| (drive - direction * self.level - self.viscous * v) / self.inertia;
        let next = v + step * rate(v + 0.5 * step * rate(v));
        if next * direction < 0.0 { [q, 0.0] } else { [q + 0.5 * step * (v + next), next] }
    }
}

impl Simulated for Joint {
    fn asked(&self) -> Inquiry {
        let fit = if self.gravity[0] > 0.0 { vec!["gravity".to_owned()] } else { Vec::new() };
        Inquiry { axis: true, fit, ..Inquiry::default() }
    }

    /// A record of 12 s under a controller that holds its torque between samples.
    fn record(&self, random: &mut fastrand::Rng) -> String {
        let (pole, mut state) = (TAU * 6.0, self.wanted(0.0));
        let stiffness = self.inertia * pole * pole + 10.0 * self.level;
        let damping = 1.6 * self.inertia * pole + 0.2 * self.viscous;
        let mut text = "time [s],position [rad],".to_owned() + if self.has_velocity { "velocity [rad/s]," } else { "" };
        text += "torque [N m]\n";
        for at in 0..(12.0 / self.interval) as u32 {
            let (t, rounded) = (f64::from(at) * self.interval, (state[0] / self.encoder).round() * self.encoder);
            let [q, v] = self.wanted(t);
            let ahead = self.level * (v / 0.05).tanh() + self.gravity[0] * (q - self.gravity[1]).cos();
            let torque = stiffness * (q - rounded) + damping * (v - state[1]) + ahead;
            let velocity = state[1] + self.noise[1] * normal(random);
            let velocity = if self.has_velocity { format!("{velocity},") } else { String::new() };
            text += &format!("{t},{rounded},{velocity}{}\n", torque + self.noise[0] * normal(random));
            for _ in 0..PARTS {
                state = self.moved(state, torque, self.interval / f64::from(PARTS));
            }
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        match one.name.as_str() {
            "mass" => Some(self.inertia),
            "mu_k" => Some(self.level),
            "viscous_coefficient" => Some(self.viscous),
            "offset" => Some(self.offset),
            "gravity" => Some(self.gravity[0]),
            // An angle may be one turn away.
            "gravity_angle" => Some(one.value + (self.gravity[1] - one.value + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU),
            _ => None,
        }
    }
}
