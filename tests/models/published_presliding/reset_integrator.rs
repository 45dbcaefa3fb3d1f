//! The reset integrator.

use super::{
    F_C, F_S, Row, SIGMA_0, after, assert_bounded_at_coarse_steps, assert_close, assert_closed_cycles_dissipate,
    assert_identical, assert_passive,
};
use crate::common::Bench;
use approx::abs_diff_eq;

const RESET: [(f64, f64, f64); 7] = [
    (1e-4, 0.05, 0.781622777),
    (1e-4, 0.10, 0.981),
    (1e-4, 0.15, 0.981),
    (1e-4, 1.00, 0.981),
    (1e-3, 0.01, 0.981),
    (1e-2, 1e-3, 0.981),
    (1e-2, 5e-3, 0.981),
];

#[test]
fn reset_integrator_from_rest() {
    for (velocity, time, force) in RESET {
        assert_close("force", after("ResetIntegrator", &[], velocity, time).get("friction_force"), force, 1e-9);
        assert_close("mirrored", after("ResetIntegrator", &[], -velocity, time).get("friction_force"), -force, 1e-9);
    }
}

/// Breakaway at (1 + a) sigma_0 z_m + sigma_1 v with a = 0.5, and at 1.49112 N with the 0.52 that the thesis prints.
#[test]
fn reset_integrator_breaks_away_at_the_static_level() {
    for (preset, breakaway) in [("thesis", F_S), ("thesis_printed", 1.49112)] {
        let highest = |velocity: f64| {
            let mut bench = Bench::new("ResetIntegrator", &[("velocity", velocity)]);
            assert!(bench.instance.apply(preset));
            let forces = (0..100_000).map(|_| {
                bench.step(1e-10 / velocity * 1.001);
                bench.get("friction_force")
            });
            forces.fold(0.0, f64::max)
        };
        // One of 98 000 steps up to z_m, and the damping.
        let damping = 1e5f64.sqrt() * 1e-6;
        assert!(abs_diff_eq!(highest(1e-6) - breakaway, damping, epsilon = 2e-5 * F_S), "{preset}: {}", highest(1e-6));
    }
}

/// Without stiction (a = 0) and damping the bond is elastic and perfectly plastic: Dahl's law with alpha = 0.
#[test]
fn reset_integrator_without_stiction_is_brittle_dahl() {
    assert_identical(("ResetIntegrator", &[("mu_s", 0.1), ("sigma_1", 0.0)]), ("Dahl", &[("alpha", 0.0)]), 1e-12);
}

/// RK4 at 2 us with a switch per step gives these numbers with about 1e-5.
#[test]
fn reset_integrator_on_the_belt() {
    let expected = Row {
        first_maximum: (7.558033, 0.745943),
        first_minimum: 0.235057,
        last_period: 7.52731,
        end: 0.238214,
        maxima: 5,
    };
    Row::simulated("ResetIntegrator", &[]).assert_close("co-simulation", &expected, 1e-2);
    // A contact that is bonded after a step has moved by 2 z_m at most, so sigma_1 v is not more than this.
    assert_bounded_at_coarse_steps("ResetIntegrator", &[], |h| F_S + 1e5f64.sqrt() * 2.0 * (F_C / SIGMA_0) / h);
}

#[test]
fn reset_integrator_is_passive() {
    for values in [&[][..], &[("sigma_1", 0.0)], &[("mu_s", 0.1)], &[("mu_s", 0.6), ("sigma_1", 0.0)]] {
        assert_passive("ResetIntegrator", values);
        assert_closed_cycles_dissipate("ResetIntegrator", values);
    }
}
