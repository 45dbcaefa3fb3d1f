//! `MaxwellSlip` with up to 1000 elements, of which 64 have variables: closed forms and saved states.

use crate::common::Bench;
use approx::{abs_diff_eq, assert_abs_diff_eq};

const F_S: f64 = 0.15 * 9.81;
const SIGMA_0: f64 = 1e5;
/// Speed at which the level is f_s to 1e-12.
const CREEP: f64 = 1e-9;
/// Number of states of an element without variables.
const NUMBERS: usize = 2;

fn uniform(count: u32, more: &[(&str, f64)]) -> Bench {
    Bench::new("MaxwellSlip", &[&[("distribution", 2.0), ("element_count", f64::from(count))], more].concat())
}

fn travel(law: &mut Bench, distance: f64) {
    law.set("velocity", CREEP * distance.signum());
    law.step(distance.abs() / CREEP);
}

/// The limit of evenly spaced elements when their number goes to infinity.
fn parabola(x: f64) -> f64 {
    F_S * (1.0 - (1.0 - SIGMA_0 * x / (2.0 * F_S)).max(0.0).powi(2))
}

/// To within f_s / (4 N^2), which is 2.5e-7 f_s for a thousand elements.
#[test]
fn virgin_curve_is_a_parabola() {
    for count in [2, 4, 63, 64, 65, 200, 1000] {
        let mut law = uniform(count, &[]);
        // For a thousand elements that is a quarter of a millionth of f_s.
        let bound = F_S / (4.0 * f64::from(count).powi(2)) + 1e-12;
        for k in 1..=33 {
            travel(&mut law, 1e-6);
            let error = law.get("friction_force") - parabola(1e-6 * f64::from(k));
            assert!(error.abs() < bound, "{count} elements, {k} um: {error}");
        }
        assert_eq!(law.get("sticking"), 0.0);
    }
}

/// Masing's rules, with inner loops that close; the steps are held, or ramps between them.
#[test]
fn branches_of_a_thousand_elements_follow_masing() {
    for is_ramp in [false, true] {
        let mut law = uniform(1000, &[]);
        let column = law.column("velocity");
        let travel = |law: &mut Bench, distance: f64| {
            law.set("velocity", CREEP * distance.signum());
            if is_ramp {
                // Up to twice the speed, and so 1.5 times as far.
                law.instance.set_slope(column, CREEP * distance.signum() * 1.5 * CREEP / distance.abs()).unwrap();
                law.step(distance.abs() / (1.5 * CREEP));
            } else {
                law.step(distance.abs() / CREEP);
            }
        };
        let top = 2e-5;
        travel(&mut law, top);
        let mut x = top;
        for _ in 0..9 {
            travel(&mut law, -4e-6);
            x -= 4e-6;
            let branch = parabola(top) - 2.0 * parabola(0.5 * (top - x));
            assert!(abs_diff_eq!(law.get("friction_force"), branch, epsilon = 1e-6 * F_S), "{is_ramp}, {x}");
            travel(&mut law, 1.3e-6);
            travel(&mut law, -1.3e-6);
            assert!(
                abs_diff_eq!(law.get("friction_force"), branch, epsilon = 1e-6 * F_S),
                "{is_ramp}, {x}, after an inner loop"
            );
        }
    }
}

/// The loss on the virgin curve up to slip is its integral, less the energy of the springs: sum_i (alpha_i f_s)^2 / (2
/// k_i).
#[test]
fn energy_of_a_thousand_elements_is_that_of_the_parabola() {
    let mut law = uniform(1000, &[]);
    let slip = 2.0 * F_S / SIGMA_0;
    for _ in 0..7 {
        travel(&mut law, slip / 7.0);
    }
    assert_abs_diff_eq!(law.get("dissipated_energy") / (2.0 / 3.0 * F_S * slip), 1.0, epsilon = 1e-6);
    assert_abs_diff_eq!(law.get("friction_force") / F_S, 1.0, epsilon = 1e-12);
}

/// The slope of the outputs compared with a difference, while elements stick and slip.
#[test]
fn derivative_with_time_of_a_thousand_elements() {
    let mut law = uniform(1000, &[("sigma_1", 300.0)]);
    travel(&mut law, 1e-5);
    law.set("velocity", 1e-3);
    let (force, h) = (law.column("friction_force"), 1e-8);
    let before = law.get("friction_force");
    let slope = law.instance.time_derivative()[force].slope;
    law.step(h);
    let quotient = (law.get("friction_force") - before) / h;
    assert!(abs_diff_eq!(slope / quotient, 1.0, epsilon = 2e-3), "{slope} {quotient}");
}

/// A copy continues exactly as the original, and so does the restored original.
#[test]
fn saved_state_holds_all_elements() {
    let mut law = uniform(1000, &[]);
    travel(&mut law, 3.3e-5);
    travel(&mut law, -1.7e-5);
    let saved = law.instance.save();
    assert_eq!(saved.memory.len(), NUMBERS * (1000 - 64));
    let go_on = |law: &mut Bench| {
        [-1e-6, 2e-6, -2.3e-5].map(|distance| {
            travel(law, distance);
            ["friction_force", "dissipated_energy"].map(|name| law.get(name))
        })
    };
    let expected = go_on(&mut law);
    let mut copy = Bench::new("MaxwellSlip", &[]);
    copy.instance.restore(&saved);
    assert_eq!(go_on(&mut copy), expected);
    law.instance.restore(&saved);
    assert_eq!(go_on(&mut law), expected);
}

/// After a reset, and after a failed step, no element keeps anything of its past.
#[test]
fn reset_and_failed_steps_leave_no_trace() {
    let mut law = uniform(1000, &[]);
    let fresh = law.instance.save();
    travel(&mut law, 1e-5);
    let before = law.instance.save();
    law.set("velocity", 1e300);
    assert!(law.instance.step(1e100).is_err());
    assert_eq!(law.instance.save().memory, before.memory);
    assert_eq!(law.get("element[1].force"), before.row[law.column("element[1].force")]);
    law.instance.reset();
    assert_eq!(law.instance.save().memory, fresh.memory);
}

/// Unused elements are not even read, so a law with few elements costs no more than before.
#[test]
fn unused_elements_cost_nothing() {
    for (count, in_use) in [(4, 0), (64, 0), (65, NUMBERS), (100, 36 * NUMBERS)] {
        let mut law = uniform(count, &[]);
        let mut saved = law.instance.save();
        saved.memory[in_use..].fill(f64::NAN);
        law.instance.restore(&saved);
        travel(&mut law, 1e-5);
        assert!(law.instance.time_derivative().iter().all(|number| number.slope.is_finite()));
        assert!(law.instance.save().memory[in_use..].iter().all(|number| number.is_nan()), "{count}");
        if in_use > 0 {
            saved.memory[in_use - NUMBERS] = f64::NAN;
            law.instance.restore(&saved);
            assert!(law.instance.step(1e-3).is_err());
        }
    }
}

#[test]
fn shares_are_given_to_64_elements_at_most() {
    let refusal = |distribution: f64, count: f64| {
        let values = [("distribution", distribution), ("element_count", count)];
        Bench::new("MaxwellSlip", &values).instance.step(1e-3).err().map(|fault| fault.to_string())
    };
    assert_eq!(refusal(1.0, 64.0), None);
    assert_eq!(refusal(2.0, 65.0), None);
    assert_eq!(refusal(2.0, 1000.0), None);
    let text = "element_count = 65: must be <= 64 with distribution = Explicit, because only the first \
                64 elements have variables";
    assert_eq!(refusal(1.0, 65.0).as_deref(), Some(text));
    let law = Bench::new("MaxwellSlip", &[]);
    let count = law.instance.variable(law.column("element_count")).expect("a variable");
    assert!(count.admits(1000.0) && !count.admits(1001.0));
    assert_eq!(count.fault(1001.0).to_string(), "element_count = 1001: must be >= 1 and <= 1000");
    // No interface gives access to an element beyond the 64th.
    assert_eq!(law.instance.row().len(), law.instance.model().table.len());
    assert_eq!(law.instance.model().find("element[65].force"), None);
}
