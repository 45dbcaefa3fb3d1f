//! Gonthier's law.

use super::{
    F_C, F_S, SIGMA_0, SIGMA_1, SIGMA_2, V_S, after, assert_belt, assert_bounded, assert_passive, assert_ramp,
    euler_belt, level,
};
use crate::common::Bench;
use crate::common::random::Random;
use approx::abs_diff_eq;

/// Force, deflection and dwell state from rest at constant velocity, integrated independently (9 digits).
#[test]
fn gonthier_from_rest() {
    let rows = [
        (1e-4, 0.05, 0.635958197, 6.00857592e-6, 0.0244444175),
        (1e-4, 0.10, 1.00469394, 1.11424565e-5, 0.0482853002),
        (1e-4, 0.15, 1.01609917, 1.55289751e-5, 0.0715375493),
        (1e-4, 1.00, 1.17208636, 3.950004e-5, 0.389554255),
        (1e-3, 0.01, 0.981999973, 1.00719945e-5, 1.83480637e-3),
        (1e-2, 1e-3, 0.982, 2.65955561e-6, 0.0),
        (1e-2, 5e-3, 0.982, 7.79168411e-6, 0.0),
    ];
    for (velocity, time, force, deflection, dwell) in rows {
        let mut law = after("Gonthier", &[], velocity, time);
        for (name, expected) in [("friction_force", force), ("bristle_deflection", deflection), ("dwell", dwell)] {
            let found = law.get(name);
            assert!(
                abs_diff_eq!(found, expected, epsilon = 6e-9 * expected + 1e-15),
                "{velocity} {time} {name}: {found}"
            );
        }
    }
}

/// min{f_C + sigma_1 v / (exp(u^2) - 1), f_C + (f_s - f_C) exp(-u^2)} + sigma_2 v, u = v / v_S. For the defaults the
/// second is always the smaller one, by as little as 1.56697399 sigma_1 v_S / (f_s - f_C) = 1.0102; not so for half of
/// sigma_1.
#[test]
fn gonthier_steady_force() {
    let mut first_counts = 0;
    for sigma_1 in [SIGMA_1, 0.5 * SIGMA_1] {
        for velocity in [5e-4, 1e-3, -1.120_906_41e-3, 1.5e-3, 2e-3, -3e-3, 0.1] {
            let u: f64 = velocity / V_S;
            let bristle = F_C + sigma_1 * f64::abs(velocity) / (u * u).exp_m1();
            let expected = bristle.min(level(velocity)) * velocity.signum() + SIGMA_2 * velocity;
            let force = after("Gonthier", &[("sigma_1", sigma_1)], velocity, 1e3).get("friction_force");
            assert!(abs_diff_eq!(force, expected, epsilon = 1e-12), "{velocity}: {force} against {expected}");
            first_counts += i32::from(bristle < level(velocity));
            assert!(sigma_1 < SIGMA_1 || bristle > level(velocity) || u.abs() > 30.0);
        }
    }
    assert!(first_counts > 1);
}

/// Breakaway after a rest of t: f_C + (f_s - f_C) (1 - exp(-t / tau_d)).
#[test]
fn gonthier_breakaway_rises_with_the_time_of_rest() {
    for rest in [0.01, 0.5, 2.0, 20.0] {
        let mut law = after("Gonthier", &[("viscous_coefficient", 0.0), ("sigma_1", 1e4)], 0.0, rest);
        // Twice the distance to full stiction, too fast for the level to change.
        law.set("velocity", 1e-4);
        law.set("normal_force", 9.81);
        law.step(1e-9);
        law.set("bristle_deflection", 3e-5);
        let breakaway = F_C - (F_S - F_C) * f64::exp_m1(-rest / 2.0);
        assert!(
            abs_diff_eq!(law.get("friction_force"), breakaway, epsilon = 1e-9),
            "{rest}: {}",
            law.get("friction_force")
        );
    }
}

#[test]
fn gonthier_with_equal_levels_is_passive() {
    assert_passive("Gonthier", &[("mu_s", 0.1), ("viscous_coefficient", 0.0)], 1e-2);
    assert_passive("Gonthier", &[("mu_s", 0.1), ("viscous_coefficient", 0.0)], 1e-3);
}

/// With stiction the law is not passive; it returns at most (f_s - f_C) times the distance travelled.
#[test]
fn gonthier_returns_no_more_than_the_stated_bound() {
    let mut random = Random(29);
    let mut lowest = f64::MAX;
    for _ in 0..1000 {
        let mut law = Bench::new("Gonthier", &[("viscous_coefficient", 0.0)]);
        let mut distance = 0.0;
        for _ in 0..30 {
            let velocity = 5e-5 * random.signed();
            let time = random.next();
            law.set("velocity", velocity);
            law.step(time);
            distance += f64::abs(velocity) * time;
            law.set("velocity", 0.0);
            law.step(10.0 * random.next());
            let energy = law.get("dissipated_energy");
            assert!(energy >= -(F_S - F_C) * distance, "{energy} J after {distance} m");
            lowest = lowest.min(energy);
        }
    }
    assert!(lowest < 0.0, "{lowest}");
}

#[test]
fn gonthier_with_ramped_inputs() {
    assert_ramp("Gonthier", &[], 1, 1e-6);
}

/// The benchmark against the equations integrated together by Euler's method.
#[test]
fn gonthier_on_the_belt() {
    let (mut z, mut dwell) = (0.0, 0.0);
    let expected = euler_belt(|v, h| {
        let s = (-(v / V_S).powi(2)).exp();
        let u = f64::clamp(v / 1e-5, -1.0, 1.0);
        let rate = s * v + (1.0 - s) / SIGMA_1 * (F_C * (1.5 * u - 0.5 * u.powi(3)) - SIGMA_0 * z);
        z += h * rate;
        dwell += h * (s - dwell) / if s >= dwell { 2.0 } else { SIGMA_1 / SIGMA_0 };
        let limit = F_C + (F_S - F_C) * dwell;
        (SIGMA_0 * z + SIGMA_1 * rate).clamp(-limit, limit) + SIGMA_2 * v
    });
    assert_belt("Gonthier", &[], expected);
    assert_bounded("Gonthier", &[]);
}
