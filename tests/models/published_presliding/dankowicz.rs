//! Dankowicz' law.

use super::{
    BLIMAN_SORINE_SECOND, DAHL, DAHL_ROW, F_C, FIRST_ORDER, Row, after, assert_bounded_at_coarse_steps, assert_close,
    assert_closed_cycles_dissipate, assert_identical, assert_passive,
};

/// At constant load Dankowicz' law is Dahl's with sigma_0 = f_C / delta_t; the default is that of Table 7.1.
#[test]
fn dankowicz_is_dahl() {
    assert_identical(("Dankowicz", &[]), ("Dahl", &[]), 1e-12);
    assert_identical(("Dankowicz", &[("delta_t", 3e-5)]), ("Dahl", &[("sigma_0", 0.981 / 3e-5)]), 1e-12);
    assert_identical(("Dankowicz", &[]), ("BlimanSorine", FIRST_ORDER), 1e-12);
}

#[test]
fn dankowicz_from_rest() {
    for ((velocity, time, _), force) in BLIMAN_SORINE_SECOND.into_iter().zip(DAHL) {
        assert_close("force", after("Dankowicz", &[], velocity, time).get("friction_force"), force, 2e-9);
    }
}

/// A symmetric loop of +-X: f_m = f_C tanh(X / delta_t), energy 4 f_C X - 4 f_C delta_t tanh(X / delta_t).
#[test]
fn dankowicz_loop_has_the_closed_form_peak_and_energy() {
    let (x, delta_t) = (2e-5, 9.81e-6);
    let mut bench = after("Dankowicz", &[], x, 1.0);
    let mut before = 0.0;
    for _ in 0..20 {
        before = bench.get("dissipated_energy");
        for velocity in [-2.0 * x, 2.0 * x] {
            bench.set("velocity", velocity);
            bench.step(1.0);
        }
    }
    assert_close("peak", bench.get("friction_force"), F_C * (x / delta_t).tanh(), 1e-12);
    let energy = 4.0 * F_C * (x - delta_t * (x / delta_t).tanh());
    assert_close("energy", bench.get("dissipated_energy") - before, energy, 1e-11);
}

#[test]
fn dankowicz_on_the_belt() {
    Row::simulated("Dankowicz", &[]).assert_close("co-simulation", &DAHL_ROW, 1e-2);
    assert_bounded_at_coarse_steps("Dankowicz", &[], |_| F_C + 1e-12);
}

#[test]
fn dankowicz_is_passive() {
    assert_passive("Dankowicz", &[]);
    assert_closed_cycles_dissipate("Dankowicz", &[]);
}
