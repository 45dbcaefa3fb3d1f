//! The law of random bristles: renewal theory, breakaway, the belt and energy.

use super::{F_C, F_S, assert_bounded_at_coarse_steps, assert_close, assert_passive};
use crate::common::random::Random;
use crate::common::{Bench, Exchange, belt, extrema};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// N = 25 bristles with delta = Delta = 1 m and sigma = 1 N/m.
const UNIT_BRISTLES: [(&str, f64); 4] = [("normal_force", 25.0), ("mu_s", 1.0), ("mu_k", 2.0 / 3.0), ("delta", 1.0)];

/// Forces of `UNIT_BRISTLES` after a slide with the given displacements, for as many seeds.
fn bristle_forces(seeds: i32, start: f64, path: &[f64]) -> Vec<f64> {
    let one = |seed: i32| {
        let mut bench = Bench::new("Bristle", &UNIT_BRISTLES);
        bench.set("seed", f64::from(seed));
        bench.set("initial_bonds", start);
        for displacement in path {
            bench.set("velocity", *displacement);
            bench.step(1.0);
        }
        bench.get("friction_force")
    };
    (0..seeds).map(one).collect()
}

/// Renewal theory: mean N sigma (delta - Delta / 3) = 16.6667 N, deviation sigma Delta sqrt(N / 18) = 1.17851 N. For
/// slides simulated snap by snap, for a slide whose result is drawn, and for a stationary start; forwards and
/// backwards. 4 standard errors of 4000 seeds: 0.0745 N for the mean, 0.0527 N for the deviation.
#[test]
fn bristles_slide_with_the_mean_and_the_deviation_of_renewal_theory() {
    let followed = [2.0; 15];
    let backwards = [-2.5; 12];
    let cases: [(f64, &[f64]); 5] = [(1.0, &followed), (1.0, &backwards), (1.0, &[1e6]), (2.0, &[1e-9]), (2.0, &[3.3])];
    for (start, path) in cases {
        let forces = bristle_forces(4000, start, path);
        let n = forces.len() as f64;
        let mean = forces.iter().sum::<f64>() / n;
        let deviation = (forces.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
        let error = 1.17851 / n.sqrt();
        assert!(abs_diff_eq!(mean.abs(), 16.6667, epsilon = 4.0 * error), "{start} {path:?}: {mean}");
        assert!(abs_diff_eq!(deviation, 1.17851, epsilon = 4.0 * error / 2f64.sqrt()), "{start} {path:?}: {deviation}");
        assert_eq!(mean.is_sign_positive(), path[0] > 0.0);
    }
}

/// The missing strain d = delta - |x - b| has the distribution 1 - (1 - d / Delta)^2 on [0, Delta]. Test of Kolmogorov
/// and Smirnov with 25 bristles of 200 seeds: D sqrt(n) stays below 1.95 in all but one of a thousand cases.
#[test]
fn bristle_strains_have_the_stationary_density() {
    let mut missing = Vec::new();
    for seed in 0..200 {
        let mut bench = Bench::new("Bristle", &UNIT_BRISTLES);
        bench.set("seed", f64::from(seed));
        bench.set("velocity", 1.7);
        for _ in 0..20 {
            bench.step(1.0);
        }
        missing.extend((1..=25).map(|i| 1.0 - bench.get(&format!("bristle[{i}].strain"))));
    }
    missing.sort_by(f64::total_cmp);
    let n = missing.len() as f64;
    let gap = |(k, d): (usize, &f64)| ((k as f64 + 0.5) / n - (1.0 - (1.0 - d).powi(2))).abs() + 0.5 / n;
    let distance = missing.iter().enumerate().map(gap).fold(0.0, f64::max);
    assert!(missing[0] >= 0.0 && missing[missing.len() - 1] <= 1.0);
    assert!(distance * n.sqrt() < 1.95, "{}", distance * n.sqrt());
}

/// Also along one slide of 20 000 Delta: time mean and deviation at every 5 Delta, where neighbours are independent.
#[test]
fn one_long_slide_shows_the_same_mean_and_deviation() {
    let mut bench = Bench::new("Bristle", &UNIT_BRISTLES);
    bench.set("velocity", 5.0);
    let forces: Vec<f64> = (0..4000)
        .map(|_| {
            bench.step(1.0);
            bench.get("friction_force")
        })
        .skip(2)
        .collect();
    let n = forces.len() as f64;
    let mean = forces.iter().sum::<f64>() / n;
    let deviation = (forces.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    assert_abs_diff_eq!(mean, 16.6667, epsilon = 4.0 * 1.17851 / n.sqrt());
    assert_abs_diff_eq!(deviation, 1.17851, epsilon = 4.0 * 1.17851 / (2.0 * n).sqrt());
    // And the energy is the mean force times the distance: 4 standard errors, with a correlation length below Delta.
    let energy = bench.get("dissipated_energy") / 20_000.0;
    assert_abs_diff_eq!(energy, 16.6667, epsilon = 4.0 * 1.17851 / 20_000f64.sqrt() + 1e-3);
}

/// Bonded bristles are a spring N sigma up to delta, where the force is f_s; there all snap together.
#[test]
fn bonded_bristles_break_away_at_the_static_level() {
    for direction in [1.0, -1.0] {
        let mut bench = Bench::new("Bristle", &[]);
        for (displacement, force) in [(5e-6, 0.5), (5e-6, 1.0), (4.715e-6 * (1.0 - 1e-9), F_S)] {
            bench.set("velocity", direction * displacement);
            bench.step(1.0);
            assert_abs_diff_eq!(direction * bench.get("friction_force"), force, epsilon = 1e-8);
            assert_eq!(bench.get("sticking"), 1.0 - f64::from(u8::from(force > 0.5 * F_C && displacement > 0.0)));
        }
        bench.set("velocity", direction * 1e-9);
        bench.step(1.0);
        // Each has moved back by a uniform fraction of Delta = delta: f_s / 2 with a deviation of f_s / sqrt(12 N).
        let force = direction * bench.get("friction_force");
        assert_abs_diff_eq!(force, 0.5 * F_S, epsilon = 4.0 * F_S / 300f64.sqrt());
    }
}

#[test]
fn bristles_are_rate_independent() {
    let run = |rate: f64| {
        let mut bench = Bench::new("Bristle", &[]);
        for leg in [3e-5, -5e-6, 4e-5, -1e-4] {
            bench.set("velocity", rate * leg);
            bench.step(1.0 / rate);
        }
        [bench.get("friction_force"), bench.get("dissipated_energy")]
    };
    for rate in [1e-3, 1e5] {
        assert!(run(rate).into_iter().zip(run(1.0)).all(|(a, b)| (a / b - 1.0).abs() < 1e-10));
    }
}

/// A velocity that varies linearly through a reversal, compared with many short held steps.
#[test]
fn bristles_follow_a_ramped_velocity() {
    let mut ramp = Bench::new("Bristle", &[("velocity", -2e-3)]);
    ramp.instance.set_slope(ramp.column("velocity"), 0.5).unwrap();
    ramp.step(0.02);
    let mut dense = Bench::new("Bristle", &[]);
    for k in 0..20_000 {
        dense.set("velocity", -2e-3 + 0.5 * 1e-6 * (f64::from(k) + 0.5));
        dense.step(1e-6);
    }
    for name in ["friction_force", "dissipated_energy"] {
        assert_close(name, ramp.get(name), dense.get(name), 1e-9);
    }
    assert_close("velocity", ramp.get("velocity"), 8e-3, 1e-12);
}

/// The first slip starts from f_s as in the closed form of stick-slip (first maximum 0.745740 m); the bristles stay
/// spread, so that later the oscillation is that of Coulomb friction with f_C, with noise.
#[test]
fn bristles_on_the_belt() {
    let samples = belt(&mut Bench::new("Bristle", &[("bristle_count", 64.0)]), 1e-4, 40.0, Exchange::Sequential);
    let maxima: Vec<_> = extrema(&samples, 1.0).into_iter().filter(|(_, x)| *x > 0.52).collect();
    assert_close("first maximum", maxima[0].1, 0.745740, 1e-2);
    assert_close("time of the first maximum", maxima[0].0, 7.555990, 1e-2);
    let last = samples.iter().skip(200_000).map(|sample| sample.position).sum::<f64>() / 200_000.0;
    assert_close("middle of the later oscillation", last, F_C / 2.0, 3e-2);
    for seed in 0..3 {
        assert_bounded_at_coarse_steps("Bristle", &[("seed", f64::from(seed))], |_| F_S + 1e-12);
    }
}

#[test]
fn bristles_are_passive() {
    for values in [&[][..], &[("mu_s", 0.29), ("bristle_count", 2.0)], &[("seed", 9.0), ("bristle_count", 64.0)]] {
        assert_passive("Bristle", values);
    }
}

/// A stationary start may return its initial strain energy, N sigma delta^2 / 2 = f_s delta / 2, but no more.
#[test]
fn stationary_bristles_return_no_more_than_their_strain_energy() {
    let mut random = Random(41);
    let mut least: f64 = 0.0;
    for seed in 0..1000 {
        let mut bench = Bench::new("Bristle", &[("initial_bonds", 2.0), ("seed", f64::from(seed))]);
        for displacement in [1e-12, -1e-5 * random.next()] {
            bench.set("velocity", displacement);
            bench.step(1.0);
            least = least.min(bench.get("dissipated_energy"));
        }
    }
    assert!((-0.5 * F_S * 1.4715e-5..-1e-7).contains(&least), "{least}");
}
