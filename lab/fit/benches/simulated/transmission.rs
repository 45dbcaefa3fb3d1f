//! Ropes over a drum and gears that are moved along two sines from rest, under a tension or force that swings: the state
//! in place of the direction by its closed form over the way, piece by piece.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, Waves, normal, truth, value};

/// A rope over half a turn, or a gear, and its motion.
pub struct Transmission {
    model: &'static str,
    /// The input that swings, its mean and amplitude, N, and its frequency, Hz.
    input: &'static str,
    swing: [f64; 3],
    values: Vec<(&'static str, f64)>,
    waves: Waves,
}

/// Of the samples, s; pieces of the way in one of them; noise as a part of the largest force.
const INTERVAL: f64 = 1e-3;
const PARTS: u32 = 20;
const NOISE: f64 = 0.01;
const DURATION: f64 = 3.0;

impl Transmission {
    /// A rope with a preload.
    pub fn rope(random: &mut fastrand::Rng) -> Transmission {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let values = vec![("mu_k", between(0.05, 0.4)), ("preload", between(2.0, 20.0))];
        let swing = [between(20.0, 60.0), between(5.0, 15.0), between(1.0, 3.0)];
        Transmission::moved("Capstan", "tension_1", values, swing, random)
    }

    /// A gear that drives and is driven back.
    pub fn gear(random: &mut fastrand::Rng) -> Transmission {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let driving = between(0.05, 0.4);
        let values = vec![("mu_driving", driving), ("mu_backdriving", driving * between(0.8, 2.5))];
        let swing = [between(5.0, 30.0), between(10.0, 40.0), between(1.0, 3.0)];
        Transmission::moved("GearEfficiency", "transmitted_force", values, swing, random)
    }

    /// With its motion and the distance over which the friction builds up.
    fn moved(
        model: &'static str,
        input: &'static str,
        mut values: Vec<(&'static str, f64)>,
        swing: [f64; 3],
        random: &mut fastrand::Rng,
    ) -> Transmission {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let waves = Waves([[between(1e-3, 4e-3), between(0.5, 1.5)], [between(3e-4, 1e-3), between(4.0, 9.0)]]);
        values.push(("relaxation_distance", waves.stroke() * between(0.03, 0.2)));
        Transmission { model, input, swing, values, waves }
    }

    fn value(&self, name: &str) -> f64 {
        value(&self.values, name)
    }

    fn displacement(&self, t: f64) -> f64 {
        self.waves.motion(t)[0]
    }

    fn driven(&self, t: f64) -> f64 {
        let [mean, amplitude, rate] = self.swing;
        mean + amplitude * (TAU * rate * t).sin()
    }

    /// The force at a part of the friction, by the equations of a rope or of a gear.
    fn force(&self, share: f64, driven: f64) -> f64 {
        if self.model == "Capstan" {
            let carried = self.value("preload") + driven;
            return carried * ((self.value("mu_k") * PI * share).exp() - 1.0);
        }
        let [driving, back] = [self.value("mu_driving"), self.value("mu_backdriving")];
        // Once it slides: one coefficient where the force drives, the other one where it is driven back.
        let [along, against] = if driven >= 0.0 { [driving, back] } else { [back, driving] };
        0.5 * driven.abs() * share * (along * (1.0 + share) + against * (1.0 - share))
    }

    /// Forces without noise.
    fn forces(&self) -> Vec<f64> {
        let (step, distance) = (INTERVAL / f64::from(PARTS), self.value("relaxation_distance"));
        let (mut share, mut found) = (0.0, Vec::new());
        for at in 0..(DURATION / INTERVAL) as u32 * PARTS {
            let [t, next] = [at, at + 1].map(|at| f64::from(at) * step);
            if at % PARTS == 0 {
                found.push(self.force(share, self.driven(t)));
            }
            let way = self.displacement(next) - self.displacement(t);
            share = way.signum() + (share - way.signum()) * (-way.abs() / distance).exp();
        }
        found
    }
}

impl Simulated for Transmission {
    fn asked(&self) -> Inquiry {
        Inquiry { law: vec![self.model.to_owned()], ..Inquiry::default() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        let forces = self.forces();
        let most = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let mut text = format!("time [s],force [N],displacement [m],{} [N]\n", self.input);
        for (at, force) in forces.iter().enumerate() {
            let t = at as f64 * INTERVAL;
            let place = self.displacement(t) + 1e-7 * normal(random);
            let _ = writeln!(text, "{t},{},{place},{}", force + NOISE * most * normal(random), self.driven(t));
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        truth(&self.values, one)
    }
}
