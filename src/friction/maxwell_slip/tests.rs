//! Elements by hand: levels, slip, rest, energies.

use approx::assert_abs_diff_eq;

use super::*;

fn one_element() -> MaxwellSlip {
    MaxwellSlip { element_count: 1.0, ..Default::default() }
}

fn move_by(law: &mut MaxwellSlip, distance: f64, velocity: f64) {
    law.velocity = velocity * distance.signum();
    law.step(distance.abs() / velocity);
    law.output();
}

/// With one element and equal levels: an elastic, perfectly plastic contact, as Dahl's law with alpha = 0.
#[test]
fn one_element_with_equal_levels_is_elastic_and_perfectly_plastic() {
    let mut law = MaxwellSlip { mu_s: 0.1, attraction: 1e9, ..one_element() };
    let mut dahl = crate::friction::Dahl { alpha: 0.0, ..Default::default() };
    for velocity in [1e-3, 2e-2, -1e-3, -3e-3, 4e-3, -1e-3, 0.0, 2.0] {
        (law.velocity, dahl.velocity) = (velocity, velocity);
        law.step(5e-3);
        dahl.step(5e-3);
        law.output();
        dahl.output();
        assert!((law.friction_force - dahl.friction_force).abs() < 1e-15, "{velocity}");
        assert!((law.dissipated_energy - dahl.dissipated_energy).abs() < 1e-17, "{velocity}");
    }
}

/// Slip ends only when the velocity changes sign: slowing down raises the force with the time constant s / C. Backwards
/// the printed (7.36) would diverge; here it is the mirror image.
#[test]
fn a_slipping_element_follows_the_level_and_does_not_stick_again() {
    for direction in [1.0, -1.0] {
        let mut law = one_element();
        move_by(&mut law, direction * 1e-3, 0.1);
        assert_abs_diff_eq!(law.friction_force, direction * 0.981, epsilon = 1e-15);
        law.velocity = direction * 1e-9;
        law.step(1e-3);
        law.output();
        let by_hand = direction * (1.4715 - 0.4905 * (-1.0f64 / 1.4715).exp());
        assert!((law.friction_force - by_hand).abs() < 1e-12, "{}", law.friction_force);
        assert_eq!(law.sticking, 0.0);
        law.velocity = -direction * 1e-9;
        law.output();
        assert_eq!(law.sticking, 1.0);
    }
}

/// Rest holds the force, for any duration and any element.
#[test]
fn rest_holds_the_force() {
    let mut law = MaxwellSlip::default();
    move_by(&mut law, 1e-3, 0.1);
    law.velocity = 0.0;
    law.step(1e3);
    law.output();
    assert_abs_diff_eq!(law.friction_force, 0.981, epsilon = 1e-15);
    assert_eq!(law.sticking, 1.0);
}

/// Springs that stick are linear; those that slip follow a level that depends on the velocity, if its ends differ.
#[test]
fn elements_that_slip_are_linear_at_equal_levels_only() {
    let mut law = MaxwellSlip { velocity: 0.1, slip: Phase::Held.number(), ..one_element() };
    law.at_event();
    assert!(law.is_linear() && law.element[0].block.slipping == 0.0);
    law.element[0].block.force = 1.0;
    law.at_event();
    assert!(!law.is_linear() && law.element[0].block.slipping == 1.0);
    law.mu_s = law.mu_k;
    assert!(law.is_linear());
}

/// The energy against the trapezoidal sum of the power over many small steps.
#[test]
fn energy_is_the_integral_of_power() {
    let mut law = MaxwellSlip { sigma_1: 300.0, viscous_coefficient: 0.3, ..Default::default() };
    let mut integral = 0.0;
    for (velocity, time) in [(2e-3, 8e-3), (5e-4, 5e-3), (-1e-3, 2e-2), (3e-3, 1e-2)] {
        law.velocity = velocity;
        let mut fine = law;
        let n = 100_000;
        for _ in 0..n {
            fine.output();
            let before = fine.dissipated_power;
            fine.step(time / f64::from(n));
            fine.output();
            integral += 0.5 * (before + fine.dissipated_power) * time / f64::from(n);
        }
        law.step(time);
        assert!((law.dissipated_energy / integral - 1.0).abs() < 1e-4, "{} {integral}", law.dissipated_energy);
        assert_abs_diff_eq!(law.dissipated_energy / fine.dissipated_energy, 1.0, epsilon = 1e-11);
    }
}

/// The cycle of the docs: slip at speed, slow down, go back, speed up. It returns energy, and no more than stated.
#[test]
fn falling_level_makes_the_law_active_by_the_stated_amount() {
    let mut law = one_element();
    let back = 0.4905 / 1e5;
    move_by(&mut law, 1e-3, 1.0);
    let before = law.dissipated_energy;
    for _ in 0..10 {
        law.velocity = 1e-12;
        law.step(1.0);
        move_by(&mut law, -back, 1e-9);
        assert_abs_diff_eq!(law.friction_force, 0.981, epsilon = 1e-9);
        move_by(&mut law, back, 1.0);
    }
    let per_cycle = (law.dissipated_energy - before) / 10.0;
    assert!((per_cycle / (-0.4905f64.powi(2) / 2e5) - 1.0).abs() < 1e-5, "{per_cycle}");
}
