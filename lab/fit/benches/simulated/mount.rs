//! Rubber mounts that are moved along two sines from rest: Berg's friction by its printed equation, with the turning
//! points as they come, and the damper by the classical Runge-Kutta method.

use std::f64::consts::TAU;
use std::fmt::Write;

use stribeck_fit::identify::{Estimate, Inquiry};

use super::{Simulated, Waves, normal};

/// A mount and its motion.
pub struct Mount {
    /// Elastic stiffness, and that in series with the damper, N/m.
    elastic: f64,
    series: f64,
    /// Coefficient of the damper, N s/m.
    damper: f64,
    /// Largest friction, N, and displacement for half of it, m.
    friction: f64,
    half: f64,
    waves: Waves,
}

/// Of the samples, s; steps of the simulation in one of them; noise as a part of the largest force.
const INTERVAL: f64 = 1e-3;
const PARTS: u32 = 50;
const NOISE: f64 = 0.01;
const DURATION: f64 = 3.0;

impl Mount {
    /// A mount whose longer stroke is 1 to 4 mm.
    pub fn drawn(random: &mut fastrand::Rng) -> Mount {
        let mut between = |low: f64, high: f64| low * f64::powf(high / low, random.f64());
        let waves = Waves([[between(1e-3, 4e-3), between(0.5, 1.5)], [between(3e-4, 1e-3), between(4.0, 9.0)]]);
        let elastic = between(1e5, 1e6);
        let series = elastic * between(0.1, 0.6);
        let [force, stroke] = [elastic * waves.stroke(), waves.stroke()];
        let (damper, friction, half) =
            (series / (TAU * between(2.0, 20.0)), force * between(0.05, 0.3), stroke * between(0.03, 0.2));
        Mount { elastic, series, damper, friction, half, waves }
    }

    /// Friction at a way from the last turning point, positive in the direction of the motion, where it was `start`.
    fn slid(&self, start: f64, way: f64) -> f64 {
        start + way * (self.friction - start) / (self.half * (1.0 - start / self.friction) + way)
    }

    /// The force of the damper a short time later.
    fn yielded(&self, force: f64, t: f64, step: f64) -> f64 {
        let rate = |force: f64, t: f64| self.series * (self.waves.motion(t)[1] - force / self.damper);
        let first = rate(force, t);
        let second = rate(force + 0.5 * step * first, t + 0.5 * step);
        let third = rate(force + 0.5 * step * second, t + 0.5 * step);
        let fourth = rate(force + step * third, t + step);
        force + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
    }

    /// Forces without noise.
    fn forces(&self) -> Vec<f64> {
        let step = INTERVAL / f64::from(PARTS);
        let (mut direction, mut turn, mut start, mut damper) = (1.0, 0.0, 0.0, 0.0);
        let mut found = Vec::new();
        for at in 0..(DURATION / INTERVAL) as u32 * PARTS {
            let t = f64::from(at) * step;
            let [x, next] = [t, t + step].map(|t| self.waves.motion(t)[0]);
            let friction = direction * self.slid(direction * start, direction * (x - turn));
            if at % PARTS == 0 {
                found.push(self.elastic * x + damper + friction);
            }
            if direction * (next - x) < 0.0 {
                (direction, turn, start) = (-direction, x, friction);
            }
            damper = self.yielded(damper, t, step);
        }
        found
    }
}

impl Simulated for Mount {
    fn asked(&self) -> Inquiry {
        Inquiry { law: vec!["RubberMount".to_owned()], ..Inquiry::default() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        let forces = self.forces();
        let most = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let mut text = "time [s],force [N],displacement [m]\n".to_owned();
        for (at, force) in forces.iter().enumerate() {
            let t = at as f64 * INTERVAL;
            let place = self.waves.motion(t)[0] + 1e-7 * normal(random);
            let _ = writeln!(text, "{t},{},{place}", force + NOISE * most * normal(random));
        }
        text
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        match one.name.as_str() {
            "k_e" => Some(self.elastic),
            "k_v" => Some(self.series),
            "c" => Some(self.damper),
            "F_max" => Some(self.friction),
            "x_2" => Some(self.half),
            _ => None,
        }
    }
}
