//! The MaxwellSlip law.

use super::{
    F_S, SIGMA_0, SIGMA_1, SIGMA_2, after, assert_belt, assert_bounded, assert_passive, assert_ramp, euler_belt, level,
    travel,
};
use crate::common::Bench;
use crate::common::random::Random;
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// Speed at which the level is f_s to 1e-12.
const CREEP: f64 = 1e-9;

/// y(x) = sum_i min(k_i x, alpha_i f_s), of the four default elements.
fn virgin_curve(x: f64) -> f64 {
    let elements = [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)];
    elements.iter().map(|(k, alpha)| f64::min(k * SIGMA_0 * x, alpha * F_S)).sum()
}

#[test]
fn maxwell_slip_virgin_curve() {
    for (x, force) in [(1e-5, 0.64715), (2e-5, 0.94145), (3e-5, 1.1829), (6e-5, 1.4715)] {
        let mut law = Bench::new("MaxwellSlip", &[]);
        travel(&mut law, x, CREEP);
        assert!(abs_diff_eq!(law.get("friction_force"), force, epsilon = 1e-11), "{x}: {}", law.get("friction_force"));
        assert_abs_diff_eq!(virgin_curve(x), force, epsilon = 1e-14);
    }
}

/// Masing's rules: branches are the virgin curve, doubled; inner loops close and are erased by the outer branch.
#[test]
fn maxwell_slip_branches_follow_masing() {
    let mut law = Bench::new("MaxwellSlip", &[]);
    let top = 3e-5;
    travel(&mut law, top, CREEP);
    let mut x = top;
    for _ in 0..24 {
        travel(&mut law, -2.5e-6, CREEP);
        x -= 2.5e-6;
        let branch = virgin_curve(top) - 2.0 * virgin_curve(0.5 * (top - x));
        assert!(abs_diff_eq!(law.get("friction_force"), branch, epsilon = 1e-12), "{x}");
        // An inner loop leaves no trace.
        if x < 0.0 {
            travel(&mut law, 1.3e-6, CREEP);
            travel(&mut law, -1.3e-6, CREEP);
            assert!(abs_diff_eq!(law.get("friction_force"), branch, epsilon = 1e-12), "{x}, after an inner loop");
        }
    }
    travel(&mut law, 2.0 * top, CREEP);
    assert_abs_diff_eq!(law.get("friction_force"), virgin_curve(top), epsilon = 1e-12);
}

/// Energy of the loop between -X and X: 8 int_0^X y dx - 4 X y(X).
#[test]
fn maxwell_slip_loop_energy() {
    let mut law = Bench::new("MaxwellSlip", &[]);
    travel(&mut law, 3e-5, CREEP);
    let mut before = law.get("dissipated_energy");
    for _ in 0..3 {
        travel(&mut law, -6e-5, CREEP);
        travel(&mut law, 6e-5, CREEP);
        let energy = law.get("dissipated_energy") - before;
        assert!(abs_diff_eq!(energy / 3.839025780e-5, 1.0, epsilon = 1e-9), "{energy}");
        before += energy;
    }
}

/// Steady sliding: s(v) sgn v + f_v v, whatever the distribution.
#[test]
fn maxwell_slip_steady_force() {
    for distribution in [1.0, 2.0] {
        for velocity in [1e-4, 5e-4, -1e-3, 2e-3, -0.1] {
            let values = [("distribution", distribution), ("element_count", 20.0), ("viscous_coefficient", SIGMA_2)];
            let force = after("MaxwellSlip", &values, velocity, 10.0).get("friction_force");
            let expected = level(velocity) * f64::signum(velocity) + SIGMA_2 * velocity;
            assert!(abs_diff_eq!(force, expected, epsilon = 1e-12), "{velocity}: {force}");
        }
    }
}

/// With one element, equal levels and instant attraction: Dahl's law with alpha = 0.
#[test]
fn maxwell_slip_of_one_element_is_elastic_and_perfectly_plastic() {
    let values = [("element_count", 1.0), ("mu_s", 0.1), ("attraction", 1e12)];
    let (mut law, mut dahl) = (Bench::new("MaxwellSlip", &values), Bench::new("Dahl", &[("alpha", 0.0)]));
    let mut random = Random(3);
    for _ in 0..2000 {
        let distance = 1e-5 * random.signed();
        travel(&mut law, distance, 1e-2);
        travel(&mut dahl, distance, 1e-2);
        assert_abs_diff_eq!(law.get("friction_force"), dahl.get("friction_force"), epsilon = 1e-12);
    }
    assert_abs_diff_eq!(law.get("dissipated_energy") / dahl.get("dissipated_energy"), 1.0, epsilon = 1e-12);
}

#[test]
fn maxwell_slip_with_equal_levels_is_passive() {
    for sigma_1 in [0.0, 300.0] {
        assert_passive("MaxwellSlip", &[("mu_s", 0.1), ("sigma_1", sigma_1)], 1e-2);
        let uniform = [("mu_s", 0.1), ("sigma_1", sigma_1), ("distribution", 2.0), ("element_count", 64.0)];
        assert_passive("MaxwellSlip", &uniform, 1e-2);
    }
}

#[test]
fn maxwell_slip_with_ramped_inputs() {
    assert_ramp("MaxwellSlip", &[], 500, 1e-6);
    assert_ramp("MaxwellSlip", &[("sigma_1", SIGMA_1), ("viscous_coefficient", SIGMA_2)], 500, 1e-6);
}

/// The benchmark against the equations integrated together by Euler's method, with and without damping.
#[test]
fn maxwell_slip_on_the_belt() {
    for (sigma_1, sigma_2) in [(SIGMA_1, SIGMA_2), (0.0, 0.0)] {
        let mut elements =
            [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)].map(|(k, a)| (k * SIGMA_0, a, 0.0, false));
        let mut last = 0.0;
        let expected = euler_belt(|v, h| {
            let s = level(v);
            let mut force = sigma_2 * v;
            for (k, alpha, f, slips) in &mut elements {
                *slips &= v * last > 0.0;
                *slips |= *f * v.signum() >= *alpha * s;
                let rate = if *slips { 1000.0 * (*alpha * v.signum() - *f / s) } else { *k * v };
                *f += h * rate;
                force += *f + sigma_1 / SIGMA_0 * rate;
            }
            last = v;
            force
        });
        assert_belt("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", sigma_2)], expected);
        assert_bounded("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", sigma_2)]);
    }
}

/// A stuck block on elements without damping vibrates with sqrt((k + sigma_0) / m) and keeps its amplitude; with the
/// damping of 2003 it comes to rest.
#[test]
fn maxwell_slip_needs_damping_to_bring_a_stuck_block_to_rest() {
    for (sigma_1, remains) in [(0.0, true), (SIGMA_1, false)] {
        let mut law = Bench::new("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", 0.0)]);
        let (h, mut x, mut v) = (1e-5, 0.0, 1e-4);
        let mut late = 0.0f64;
        for k in 0..100_000 {
            law.set("velocity", v);
            law.step(h);
            v -= h * law.get("friction_force");
            x += h * v;
            if k > 90_000 {
                late = late.max(f64::abs(v));
            }
        }
        let amplitude = 1e-4 / SIGMA_0.sqrt();
        assert!(x.abs() < 1.01 * amplitude);
        assert_eq!(late > 0.99e-4, remains, "{late}");
        assert_eq!(late < 1e-9, !remains, "{late}");
    }
}
