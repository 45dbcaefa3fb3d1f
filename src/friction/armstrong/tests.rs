//! Armstrong's law by hand: levels, instants, energies.

use approx::assert_abs_diff_eq;

use super::*;

const F_C: f64 = 0.981;
const F_SINF: f64 = 0.4905;

fn force(law: &mut Armstrong) -> f64 {
    law.output();
    law.friction_force
}

fn go(law: &mut Armstrong, velocity: f64, time: f64) -> f64 {
    law.velocity = velocity;
    law.step(time);
    force(law)
}

#[test]
fn a_stuck_contact_is_a_spring() {
    let mut law = Armstrong::default();
    assert_abs_diff_eq!(go(&mut law, 1e-6, 2.0), 0.2, epsilon = 1e-15);
    assert_abs_diff_eq!(go(&mut law, -3e-6, 1.0), -0.1, epsilon = 1e-15);
    assert_abs_diff_eq!(law.dissipated_energy, 0.1 * 0.1 / 2e5, epsilon = 1e-21);
    assert_eq!((law.sticking, law.dwell_time), (1.0, 3.0));
}

/// Hyperbolic rise: a half at gamma, a third at gamma / 2, three quarters at 3 gamma. A stiff contact breaks away
/// at once, and the force stays there for the lag.
#[test]
fn breakaway_rises_with_the_dwell_time() {
    for (dwell, share) in [(2.0, 0.5), (1.0, 1.0 / 3.0), (6.0, 0.75)] {
        let mut law = Armstrong { sigma_0: 1e12, ..Default::default() };
        go(&mut law, 0.0, dwell);
        let found = go(&mut law, -0.01, 0.0049);
        assert!((found + F_C + share * F_SINF).abs() < 1e-9, "{dwell}: {found}");
    }
}

/// The instant of breakaway by fixed-point iteration of sigma_0 v t = f_C + F_Sinf (1 + t) / (1 + t + gamma).
#[test]
fn breakaway_is_located_within_the_step() {
    let mut t = 0.0;
    for _ in 0..100 {
        t = (F_C + F_SINF * (1.0 + t) / (3.0 + t)) / (1e5 * 1e-5);
    }
    let (level, w) = (1e5 * 1e-5 * t, 1e-5 / 0.001);
    for pieces in [1, 2, 19, 4000] {
        let mut law = Armstrong::default();
        go(&mut law, 0.0, 1.0);
        for _ in 0..pieces {
            go(&mut law, 1e-5, 2.0 / f64::from(pieces));
        }
        let sliding = F_C + (level - F_C) / (1.0 + w * w);
        assert!((force(&mut law) - sliding).abs() < 1e-14, "{pieces}");
        let energy = 0.5 * level * 1e-5 * t + level * 1e-5 * 0.005 + sliding * 1e-5 * (2.0 - t - 0.005);
        assert!((law.dissipated_energy / energy - 1.0).abs() < 1e-12, "{pieces}");
    }
}

/// While the velocity of slip one lag earlier is 0, the force stays at the breakaway level; then it falls.
#[test]
fn force_stays_for_the_lag_after_breakaway() {
    let mut law = Armstrong { sigma_0: 1e9, gamma: 0.0, ..Default::default() };
    for k in 1..=60 {
        let found = go(&mut law, 0.002, 1e-4);
        let expected = if k <= 50 { F_C + F_SINF } else { F_C + F_SINF / 5.0 };
        assert!((found - expected).abs() < 1e-12, "after {k} steps of 0.1 ms: {found}");
    }
}

/// Without lag and with gamma = 0 the slip branch is the Lorentzian curve.
#[test]
fn no_lag_and_instant_rise_leave_the_curve_of_hess_and_soom() {
    let values = [(1e-5, 1.47145095), (2e-4, 1.45263462), (1e-3, 1.22625), (2e-3, 1.0791), (1e-2, 0.985856436)];
    let mut law = Armstrong { time_lag: 0.0, gamma: 0.0, ..Default::default() };
    for (velocity, expected) in values {
        for sign in [1.0, -1.0] {
            let found = go(&mut law, sign * velocity, 10.0);
            assert!((sign * found / expected - 1.0).abs() < 1e-8, "{velocity}: {found}");
        }
    }
}

/// Stopping from 2 mm/s: the level at the stop belongs to the velocity one lag earlier, and the next rise begins
/// there.
#[test]
fn the_stop_keeps_the_force_and_the_magnitude() {
    let mut law = Armstrong { gamma: 1.0, stribeck_coefficient: 0.05, ..Default::default() };
    go(&mut law, 0.002, 1.0);
    go(&mut law, 0.0, 1e-9);
    assert_abs_diff_eq!(force(&mut law) - F_C, F_SINF / 5.0, epsilon = 1e-12);
    assert_abs_diff_eq!(law.stribeck_coefficient, 0.01, epsilon = 1e-15);
    assert_eq!((law.sticking, law.slipping), (1.0, 0.0));
    // A second later half of the missing part has returned.
    go(&mut law, 0.0, 1.0);
    law.sigma_0 = 1e12;
    law.bristle_deflection = 0.0;
    assert_abs_diff_eq!(go(&mut law, 1e-3, 1e-3) - F_C, 0.6 * F_SINF, epsilon = 1e-8);
}

/// After a reversal the contact unloads elastically and breaks away after 2 f / sigma_0 on the other side.
#[test]
fn a_reversal_passes_through_the_spring() {
    let mut law = Armstrong { time_lag: 0.0, gamma: 0.0, ..Default::default() };
    go(&mut law, 1e-3, 1.0);
    let level = F_C + F_SINF;
    for k in 1..29 {
        let found = go(&mut law, -1e-3, 1e-3);
        assert!((found - (level - 0.1 * f64::from(k))).abs() < 1e-12, "{k}: {found}");
    }
    assert_abs_diff_eq!(go(&mut law, -1e-3, 5e-3), -1.22625, epsilon = 1e-12);
    assert_eq!(law.sticking, 0.0);
}

/// Sudden fall of the load: the force falls at once and stays low when the load is back.
#[test]
fn a_falling_load_cuts_the_force() {
    let mut law = Armstrong { gamma: 0.0, ..Default::default() };
    go(&mut law, 1e-5, 1.0);
    law.normal_force = 1.0;
    law.velocity = 0.0;
    assert_abs_diff_eq!(force(&mut law), 0.15, epsilon = 1e-15);
    law.step(1e-3);
    law.normal_force = 9.81;
    assert_abs_diff_eq!(force(&mut law), 0.15, epsilon = 1e-12);
}

/// Ramps of velocity and load through zero velocity against 100 000 short ramps, energy against the midpoint rule.
#[test]
fn ramps_do_not_depend_on_their_division_and_energy_is_the_integral_of_power() {
    for time_lag in [0.0, 0.003] {
        let mut law = Armstrong { time_lag, gamma: 0.01, viscous_coefficient: 2.0, ..Default::default() };
        go(&mut law, -2e-3, 0.1);
        let slope = Armstrong { velocity: 0.3, normal_force: -150.0, ..law };
        let (mut dense, n) = (law, 50_000);
        law.step_ramp(&slope, 0.04);
        let mut energy = dense.dissipated_energy;
        for _ in 0..n {
            dense.step_ramp(&slope, 0.02 / f64::from(n));
            energy += { force(&mut dense) * dense.velocity } * 0.04 / f64::from(n);
            dense.step_ramp(&slope, 0.02 / f64::from(n));
        }
        assert!((law.dissipated_energy / dense.dissipated_energy - 1.0).abs() < 1e-8, "{time_lag}");
        assert!((law.dissipated_energy / energy - 1.0).abs() < 1e-4, "{} {energy}", law.dissipated_energy);
        assert!((force(&mut law) - force(&mut dense)).abs() < 1e-8, "{time_lag}");
    }
}

fn noise(k: i32) -> f64 {
    (f64::from(k) * 12.9898).sin() * 3e-3 * (f64::from(k) * 0.7).cos()
}

/// At constant load the contact returns no more energy than was put in; if the load rises during slip, no more than
/// stated.
#[test]
fn passive_at_constant_load_and_within_the_stated_bound_else() {
    for time_lag in [0.0, 1e-3, 0.02] {
        let mut law = Armstrong { time_lag, gamma: 0.05, ..Default::default() };
        for k in 0..20_000 {
            go(&mut law, noise(k), 2e-3);
            assert!(law.dissipated_energy >= 0.0, "{time_lag} {k}: {}", law.dissipated_energy);
        }
    }
    let mut law = Armstrong { gamma: 0.0, time_lag: 0.0, normal_force: 1.0, ..Default::default() };
    go(&mut law, 1e-6, 1.500_001);
    law.normal_force = 1000.0;
    go(&mut law, 1e-9, 1e-6);
    go(&mut law, -1e-3, 1.5);
    let bound = 0.15f64.powi(2) * (1000f64.powi(2) - 1.0) / 2e5;
    assert!(law.dissipated_energy < -0.9 * bound && law.dissipated_energy > -bound, "{}", law.dissipated_energy);
}

#[test]
fn equal_levels_leave_spring_and_coulomb_level() {
    let mut law = Armstrong { mu_s: 0.1, ..Default::default() };
    for velocity in [1e-4, -0.2, 3.0] {
        let found = go(&mut law, velocity, 1.0);
        assert_abs_diff_eq!(found, F_C * velocity.signum(), epsilon = 1e-15);
    }
}

#[test]
fn release_sets_back_to_the_start() {
    let mut law = Armstrong::default();
    go(&mut law, 0.01, 1.0);
    law.normal_force = 0.0;
    law.step(1e-3);
    let fresh = Armstrong { velocity: 0.01, normal_force: 0.0, ..Default::default() };
    law.dissipated_energy = 0.0;
    law.output();
    let (mut a, mut b) = (law, fresh);
    b.output();
    (a.normal_force, b.normal_force) = (9.81, 9.81);
    assert_eq!(go(&mut a, 3e-3, 0.3), go(&mut b, 3e-3, 0.3));
    assert_eq!(crate::model::row_of(&a), crate::model::row_of(&b));
}
