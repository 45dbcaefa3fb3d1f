//! Sliders with LuGre's law that move from rest along two sines, behind a load cell.

use std::fmt::Write;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, Waves, normal};

/// A slider and its motion.
pub struct Slider {
    /// Mass behind the load cell, kg.
    mass: f64,
    /// Normal force, N.
    load: f64,
    /// Kinetic coefficient, and what the static one is more.
    kinetic: f64,
    excess: f64,
    /// Speed at which the level has fallen, m/s.
    fall: f64,
    /// Stiffness, N/m, and damping, N s/m, of the bristles.
    stiffness: f64,
    damping: f64,
    viscous: f64,
    waves: Waves,
}

/// Of the samples, s; steps of the simulation in one of them; step of the encoder, m; noise as a part of the largest force.
const INTERVAL: f64 = 1e-3;
const PARTS: u32 = 50;
const ENCODER: f64 = 1e-7;
const NOISE: f64 = 0.01;
const DURATION: f64 = 4.0;

impl Slider {
    /// A slider whose longer stroke is 0.2 to 1.5 mm.
    pub fn drawn(random: &mut fastrand::Rng) -> Slider {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let [mass, load, kinetic] = [between(0.5, 5.0), between(5.0, 100.0), between(0.08, 0.4)];
        let excess = kinetic * between(0.15, 0.7);
        let waves = Waves([[between(2e-4, 1.5e-3), between(0.4, 1.5)], [between(5e-5, 2e-4), between(2.0, 5.0)]]);
        let speed = waves.fastest();
        let stiffness = kinetic * load / between(2e-6, 2e-5);
        let damping = 2.0 * (stiffness * mass).sqrt() * between(0.1, 1.0);
        let viscous = between(0.02, 0.5) * kinetic * load / speed;
        Slider { mass, load, kinetic, excess, fall: speed * between(0.05, 0.4), stiffness, damping, viscous, waves }
    }

    /// dz/dt at a velocity.
    fn yielding(&self, deflection: f64, v: f64) -> f64 {
        let level = self.load * (self.kinetic + self.excess * (-(v / self.fall).powi(2)).exp());
        v - self.stiffness * v.abs() * deflection / level
    }

    /// The deflection a short time later (Runge and Kutta).
    fn later(&self, z: f64, t: f64, step: f64) -> f64 {
        let v = [0.0, 0.5, 1.0].map(|part| self.waves.motion(t + part * step)[1]);
        let first = self.yielding(z, v[0]);
        let second = self.yielding(z + 0.5 * step * first, v[1]);
        let third = self.yielding(z + 0.5 * step * second, v[1]);
        let fourth = self.yielding(z + step * third, v[2]);
        z + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
    }

    /// Forces of the load cell without noise.
    fn forces(&self) -> Vec<f64> {
        let mut deflection = 0.0;
        let force = |at: u32| {
            let t = f64::from(at) * INTERVAL;
            let [_, v, a] = self.waves.motion(t);
            let friction = self.stiffness * deflection + self.damping * self.yielding(deflection, v) + self.viscous * v;
            let step = INTERVAL / f64::from(PARTS);
            for part in 0..PARTS {
                deflection = self.later(deflection, t + f64::from(part) * step, step);
            }
            self.mass * a + friction
        };
        (0..(DURATION / INTERVAL) as u32).map(force).collect()
    }
}

impl Simulated for Slider {
    fn asked(&self) -> Inquiry {
        let (mass, normal_force) = (Some(self.mass), Some(self.load));
        Inquiry { law: vec!["LuGre".to_owned()], mass, normal_force, ..Inquiry::default() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        let forces = self.forces();
        let most = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let zero = random.f64();
        let mut text = "time [s],force [N],displacement [m]\n".to_owned();
        for (at, force) in forces.iter().enumerate() {
            let t = at as f64 * INTERVAL;
            let place = (self.waves.motion(t)[0] / ENCODER + zero).round() * ENCODER;
            let _ = writeln!(text, "{t},{},{place}", force + NOISE * most * normal(random));
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        match one.name.as_str() {
            "mu_k" => Some(self.kinetic),
            "mu_s" => Some(self.kinetic + self.excess),
            "mu_s - mu_k" => Some(self.excess),
            "stribeck_velocity" => Some(self.fall),
            "sigma_0" => Some(self.stiffness),
            "sigma_1" => Some(self.damping),
            "viscous_coefficient" => Some(self.viscous),
            _ => None,
        }
    }
}
