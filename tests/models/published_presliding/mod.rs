//! Laws with pre-sliding displacement: numbers printed in papers, closed forms, identities between the laws, the belt
//! benchmark and passivity. One law per file, and what they share.

mod bliman_sorine;
mod bristle;
mod dankowicz;
mod elasto_plastic;
mod every_law;
mod reset_integrator;
mod specker_dynamic;

use crate::common::random::Random;
use crate::common::thesis::{F_C, F_S, SIGMA_0};
use crate::common::{Bench, Exchange, belt, extrema};
use approx::abs_diff_eq;

/// Bliman-Sorine of first order with the stiffness of Table 7.1.
const FIRST_ORDER: &[(&str, f64)] = &[("variant", 1.0), ("eps_f", 9.81e-6)];

fn after(model: &str, values: &[(&str, f64)], velocity: f64, time: f64) -> Bench {
    let mut bench = Bench::new(model, values);
    bench.set("velocity", velocity);
    bench.step(time);
    bench
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!(abs_diff_eq!(value / expected, 1.0, epsilon = relative), "{what}: {value}, expected {expected}");
}

/// A velocity of either sign, from 1 um/s to 1 m/s.
fn velocity(random: &mut Random) -> f64 {
    let speed = 10f64.powf(-6.0 * random.next());
    if random.next() < 0.5 { -speed } else { speed }
}

/// Runs the models on the same random path and compares their forces and energies after every step.
fn assert_identical(a: (&str, &[(&str, f64)]), b: (&str, &[(&str, f64)]), tolerance: f64) {
    let mut benches = [Bench::new(a.0, a.1), Bench::new(b.0, b.1)];
    let mut random = Random(5);
    for step in 0..2000 {
        let velocity = velocity(&mut random);
        // Paths of 0.1 um to 100 um, so that many of them stay below sliding.
        let dt = 10f64.powf(-7.0 + 3.0 * random.next()) / velocity.abs();
        let [a_found, b_found] = benches.each_mut().map(|bench| {
            bench.set("velocity", velocity);
            bench.step(dt);
            [bench.get("friction_force"), bench.get("dissipated_energy")]
        });
        for (x, y) in a_found.into_iter().zip(b_found) {
            assert!(
                abs_diff_eq!(x, y, epsilon = tolerance * y.abs().max(1.0)),
                "{} and {}, step {step}: {x} {y}",
                a.0,
                b.0
            );
        }
    }
}

/// From the start values no history extracts more energy from a passive contact than was put in. Histories of random
/// velocities, held for random times.
fn assert_passive(model: &str, values: &[(&str, f64)]) {
    let mut random = Random(23);
    for history in 0..1000 {
        let mut bench = Bench::new(model, values);
        for _ in 0..30 {
            bench.set("velocity", velocity(&mut random));
            bench.step(10f64.powf(-5.0 + 4.0 * random.next()));
            let energy = bench.get("dissipated_energy");
            assert!(energy >= -1e-18, "{model} {values:?}, history {history}: {energy} J");
        }
    }
}

/// The other half of passivity: a periodic closed cycle does not generate energy.
fn assert_closed_cycles_dissipate(model: &str, values: &[(&str, f64)]) {
    let mut random = Random(29);
    for history in 0..1000 {
        let legs: Vec<f64> = (0..3).map(|_| velocity(&mut random)).collect();
        let times: Vec<f64> = (0..3).map(|_| 10f64.powf(-5.0 + 3.0 * random.next())).collect();
        let mut bench = Bench::new(model, values);
        let mut energy = f64::NAN;
        for _ in 0..40 {
            let (before, last) = (bench.get("dissipated_energy"), energy);
            for (velocity, time) in legs.iter().zip(&times) {
                for (velocity, time) in [(*velocity, *time), (-0.5 * *velocity, 2.0 * *time)] {
                    bench.set("velocity", velocity);
                    bench.step(time);
                }
            }
            energy = bench.get("dissipated_energy") - before;
            if (energy - last).abs() < 1e-15 {
                break;
            }
        }
        assert!(energy >= -1e-15, "{model} {values:?}, history {history}: {energy} J per cycle");
    }
}

/// First maximum of the position, first minimum after it, last period, last position of a run of 40 s at 0.1 ms.
struct Row {
    first_maximum: (f64, f64),
    first_minimum: f64,
    last_period: f64,
    end: f64,
    maxima: usize,
}

impl Row {
    /// From the times and positions of the maxima above 0.5 m, the first minimum after them and the last position.
    fn of(maxima: &[(f64, f64)], minima: &[(f64, f64)], end: f64) -> Row {
        let maxima: Vec<_> = maxima.iter().copied().filter(|(_, position)| *position > 0.5).collect();
        let [.., before, last] = maxima[..] else { panic!("fewer than two maxima") };
        let minimum = minima.iter().find(|(time, _)| *time > maxima[0].0).expect("a minimum");
        Row {
            first_maximum: maxima[0],
            first_minimum: minimum.1,
            last_period: last.0 - before.0,
            end,
            maxima: maxima.len(),
        }
    }

    /// The model in co-simulation.
    fn simulated(model: &str, values: &[(&str, f64)]) -> Row {
        let samples = belt(&mut Bench::new(model, values), 1e-4, 40.0, Exchange::Sequential);
        Row::of(&extrema(&samples, 1.0), &extrema(&samples, -1.0), samples[samples.len() - 1].position)
    }

    /// The closed system m x'' = -k x - f(v, z), z' = g(v, z), as a whole, by the classical Runge-Kutta method with 10
    /// us: independent of a master that holds the force over a step.
    fn integrated<const N: usize>(law: impl Fn(f64, &[f64; N]) -> (f64, [f64; N])) -> Row {
        let rate = |position: f64, velocity: f64, z: &[f64; N]| {
            let (force, z_rate) = law(velocity - 0.1, z);
            (velocity, -2.0 * position - force, z_rate)
        };
        let h = 1e-5;
        let along = |z: &[f64; N], k: &[f64; N], t: f64| std::array::from_fn(|i| z[i] + t * k[i]);
        let (mut x, mut v, mut z) = (0.0, 0.1, [0.0; N]);
        let (mut maxima, mut minima) = (Vec::new(), Vec::new());
        for step in 0..4_000_000 {
            let a = rate(x, v, &z);
            let b = rate(x + 0.5 * h * a.0, v + 0.5 * h * a.1, &along(&z, &a.2, 0.5 * h));
            let c = rate(x + 0.5 * h * b.0, v + 0.5 * h * b.1, &along(&z, &b.2, 0.5 * h));
            let d = rate(x + h * c.0, v + h * c.1, &along(&z, &c.2, h));
            let before = v;
            x += h / 6.0 * (a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0);
            v += h / 6.0 * (a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1);
            z = std::array::from_fn(|i| z[i] + h / 6.0 * (a.2[i] + 2.0 * b.2[i] + 2.0 * c.2[i] + d.2[i]));
            let list = if before > 0.0 && v <= 0.0 {
                &mut maxima
            } else if before < 0.0 && v >= 0.0 {
                &mut minima
            } else {
                continue;
            };
            list.push((h * f64::from(step + 1), x));
        }
        Row::of(&maxima, &minima, x)
    }

    fn assert_close(&self, what: &str, expected: &Row, relative: f64) {
        assert_eq!(self.maxima, expected.maxima, "{what}");
        let values =
            |row: &Row| [row.first_maximum.0, row.first_maximum.1, row.first_minimum, row.last_period, row.end];
        for (found, value) in values(self).into_iter().zip(values(expected)) {
            assert_close(what, found, value, relative);
        }
    }
}

/// The same row for Dahl, Bliman-Sorine of first order and Dankowicz (LSODA at 1e-10 and Radau at 1e-8 agree).
const DAHL_ROW: Row = Row {
    first_maximum: (6.016236, 0.560941),
    first_minimum: 0.420059,
    last_period: 4.442883,
    end: 0.448751,
    maxima: 8,
};

/// At 10 ms a law without mass does not reproduce the cycle, but it stays a friction force.
fn assert_bounded_at_coarse_steps(model: &str, values: &[(&str, f64)], limit: impl Fn(f64) -> f64) {
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        for h in [1e-3, 5e-3, 1e-2] {
            let samples = belt(&mut Bench::new(model, values), h, 40.0, exchange);
            let highest = samples.iter().map(|s| s.position.abs()).fold(0.0, f64::max);
            let force = samples.iter().map(|s| s.friction_force.abs()).fold(0.0, f64::max);
            assert!(highest < 0.76, "{model} {exchange:?} {h}: {highest} m");
            assert!(force <= limit(h), "{model} {exchange:?} {h}: {force} N");
        }
    }
}

/// Constant velocity from rest, integrated independently (9 digits): velocity, time, force.
const BLIMAN_SORINE_SECOND: [(f64, f64, f64); 7] = [
    (1e-4, 0.05, 0.435840542),
    (1e-4, 0.10, 0.762125697),
    (1e-4, 0.15, 1.00264892),
    (1e-4, 1.00, 1.24262938),
    (1e-3, 0.01, 0.762125697),
    (1e-2, 1e-3, 0.762125697),
    (1e-2, 5e-3, 1.46913055),
];
const DAHL: [f64; 7] = [0.391727654, 0.627032724, 0.768377037, 0.980963305, 0.627032724, 0.627032724, 0.975000162];
