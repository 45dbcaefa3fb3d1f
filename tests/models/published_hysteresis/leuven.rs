//! The Leuven law.

use super::{
    F_C, F_S, SIGMA_0, SIGMA_1, SIGMA_2, after, assert_belt, assert_bounded, assert_passive, assert_ramp, euler_belt,
    level,
};
use crate::common::Bench;
use crate::common::random::Random;
use approx::abs_diff_eq;

/// Identity: one element that is strong enough, n = 1, is LuGre.
#[test]
fn leuven_of_one_element_is_lugre() {
    let mut random = Random(5);
    let (mut law, mut lugre) = (Bench::new("Leuven", &[("element_count", 1.0)]), Bench::new("LuGre", &[]));
    for _ in 0..3000 {
        let (v, h) = (10f64.powf(-5.0 * random.next()) * random.signed(), 10f64.powf(-5.0 * random.next()));
        for bench in [&mut law, &mut lugre] {
            bench.set("velocity", v);
            bench.step(h);
        }
        for name in ["friction_force", "dissipated_energy"] {
            let (a, b) = (law.get(name), lugre.get(name));
            assert!(abs_diff_eq!(a, b, epsilon = 1e-12 * b.abs().max(1.0)), "{name}: {a} against {b} at {v} m/s");
        }
    }
}

/// Steady sliding: s(v) sgn v + sigma_2 v for every exponent.
#[test]
fn leuven_steady_force() {
    for exponent in [0.5, 1.0, 2.0, 7.0] {
        for velocity in [1e-4, 5e-4, -1e-3, 2e-3, -0.1] {
            let force = after("Leuven", &[("approach_exponent", exponent)], velocity, 1e3).get("friction_force");
            let expected = level(velocity) * f64::signum(velocity) + SIGMA_2 * velocity;
            assert!(abs_diff_eq!(force, expected, epsilon = 1e-11), "{exponent} {velocity}: {force}");
        }
    }
}

#[test]
fn leuven_without_damping_is_passive() {
    for exponent in [0.5, 1.0, 2.0] {
        assert_passive(
            "Leuven",
            &[("sigma_1", 0.0), ("viscous_coefficient", 0.0), ("approach_exponent", exponent)],
            1e-2,
        );
    }
}

/// With damping above sigma_2 f_C / (f_s - f_C) a jump to a high speed from full stiction returns power.
#[test]
fn leuven_is_active_above_the_stated_bound() {
    let bound = SIGMA_2 * F_C / (F_S - F_C);
    for (factor, active) in [(0.99, false), (1.2, true)] {
        let mut law = after("Leuven", &[("sigma_1", factor * bound)], 1e-9, 1e6);
        let mut lowest = f64::MAX;
        for k in 1..10_000 {
            law.set("velocity", f64::from(k));
            lowest = lowest.min(law.get("dissipated_power"));
        }
        assert_eq!(lowest < 0.0, active, "{factor}: {lowest} W");
    }
}

#[test]
fn leuven_with_ramped_inputs() {
    assert_ramp("Leuven", &[], 500, 1e-6);
    assert_ramp("Leuven", &[("approach_exponent", 2.0)], 500, 1e-6);
}

/// The benchmark against the equations with the deflections z and zeta_i, integrated together by Euler's method.
#[test]
fn leuven_on_the_belt() {
    let mut elements =
        [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)].map(|(k, w)| (k * SIGMA_0, w * 1.2 * F_S, 0.0));
    let mut z = 0.0f64;
    let expected = euler_belt(|v, h| {
        let hysteresis: f64 = elements.iter().map(|(k, _, zeta)| k * (z - zeta)).sum();
        let rate = v - v.abs() * hysteresis / level(v);
        z += h * rate;
        let mut force = SIGMA_1 * rate + SIGMA_2 * v;
        for (k, w, zeta) in &mut elements {
            let limit = *w / *k;
            *zeta = zeta.clamp(z - limit, z + limit);
            force += *k * (z - *zeta);
        }
        force
    });
    assert_belt("Leuven", &[], expected);
    assert_bounded("Leuven", &[]);
}
