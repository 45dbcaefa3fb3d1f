//! Laws whose friction force depends on the past or on the acceleration: published numbers and closed forms.

use std::f64::consts::TAU;

use crate::common::thesis::{F_C, F_S, V_S, level as gaussian};
use crate::common::{Bench, Exchange, belt};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// v = V + A sin(2 pi t) for V = 2 mm/s and A = 1.5 mm/s.
fn oscillation(time: f64) -> f64 {
    2e-3 + 1.5e-3 * (TAU * time).sin()
}

/// Drives a law with the oscillation over `end`, with held velocities or with their slopes.
fn oscillate(bench: &mut Bench, h: f64, end: f64, slopes: bool) {
    let velocity = bench.column("velocity");
    let steps = (end / h).round() as i32;
    for k in 0..steps {
        let (now, next) = (oscillation(f64::from(k) * h), oscillation(f64::from(k + 1) * h));
        bench.instance.set_column(velocity, now).unwrap();
        if slopes {
            bench.instance.set_slope(velocity, (next - now) / h).unwrap();
        }
        bench.step(h);
    }
    bench.set("velocity", oscillation(f64::from(steps) * h));
}

/// Largest slope of the Gaussian curve, sqrt(2 / e) (f_s - f_C) / v_S, and derivatives of the oscillation.
const STEEPEST: f64 = 420.8;
const ACCELERATION: f64 = 1.5e-3 * TAU;
const JERK: f64 = ACCELERATION * TAU;

/// Friction at v = V: 1.02727822 N while accelerating (t = 1 s), 0.98213481 N while decelerating (t = 1.5 s). A held
/// velocity is late by up to one step. With slopes it is a polygon, with an error of h^2 / 8 of the second derivative,
/// and of (tau_L / 31)^2 / 8 where the delay holds more steps than it has pieces; where it holds whole steps, it has
/// none.
#[test]
fn lag_makes_friction_higher_while_accelerating() {
    for (end, expected) in [(1.0, 1.02727822), (1.5, 0.98213481)] {
        for h in [1e-5, 1e-4, 1e-3, 1e-2] {
            let chord = if h < 0.05 / 63.0 { JERK * ((0.05f64 / 31.0).powi(2) + h * h) / 8.0 } else { 0.0 };
            for (slopes, error) in [(true, chord), (false, chord + ACCELERATION * h)] {
                let mut law = Bench::new("FrictionalLag", &[("time_lag", 0.05)]);
                oscillate(&mut law, h, end, slopes);
                let found = law.get("friction_force");
                assert!(
                    abs_diff_eq!(found, expected, epsilon = 6e-9 + STEEPEST * error),
                    "{end} s, {h} s, {slopes}: {found}"
                );
            }
        }
    }
}

/// The filter's steady oscillation: amplitude A / sqrt(1 + (w tau)^2), late by the angle atan(w tau).
#[test]
fn first_order_lag_has_the_amplitude_and_the_phase_of_its_transfer_function() {
    let values = [("time_lag", 0.05), ("variant", 2.0)];
    let mut law = Bench::new("FrictionalLag", &values);
    let wt = TAU * 0.05;
    for (end, sign) in [(3.0, -1.0), (3.5, 1.0)] {
        law.instance.reset();
        for (name, value) in values {
            law.set(name, value);
        }
        oscillate(&mut law, 1e-4, end, true);
        let w = 2e-3 + sign * 1.5e-3 * wt.atan().sin() / (1.0 + wt * wt).sqrt();
        assert_abs_diff_eq!(law.get("lagged_velocity"), w, epsilon = 1e-9);
        assert_abs_diff_eq!(law.get("friction_force"), gaussian(w), epsilon = 1e-6);
    }
}

/// At communication steps of 1 us to 1 s, and with 50 000 of them in the delay, the loop is the same.
#[test]
fn any_step_from_1_us_to_1_s_runs() {
    let mut law = Bench::new("FrictionalLag", &[("time_lag", 0.05)]);
    let velocity = law.column("velocity");
    for h in [1e-6, 1e-5] {
        law.instance.reset();
        law.set("time_lag", 0.05);
        oscillate(&mut law, h, 0.25, false);
        let expected = gaussian(oscillation(0.2));
        let error = ACCELERATION * h + JERK * (0.05f64 / 31.0).powi(2) / 8.0;
        assert!(abs_diff_eq!(law.get("friction_force"), expected, epsilon = STEEPEST * error), "{h}");
    }
    for h in [0.1, 1.0] {
        law.instance.reset();
        law.set("time_lag", 0.05);
        for value in [1e-3, -4e-4, 2e-3, 0.0, 5e-4] {
            law.instance.set_column(velocity, value).unwrap();
            law.step(h);
            let sign = if value == 0.0 { 0.0 } else { value.signum() };
            assert!(
                abs_diff_eq!(law.get("friction_force"), gaussian(value) * sign, epsilon = 1e-15),
                "{h}: longer than the lag"
            );
        }
    }
}

/// A step of any length has the same result as its parts, also with slopes.
#[test]
fn divisions_of_a_ramp_agree() {
    for variant in [1.0, 2.0] {
        let run = |n: i32| {
            let mut law = Bench::new("FrictionalLag", &[("variant", variant), ("time_lag", 0.013)]);
            law.set("velocity", -2e-3);
            law.step(0.02);
            let column = law.column("velocity");
            for _ in 0..n {
                law.instance.set_slope(column, 0.2).unwrap();
                law.step(0.03 / f64::from(n));
            }
            [law.get("friction_force"), law.get("dissipated_energy"), law.get("lagged_velocity")]
        };
        let one = run(1);
        for n in [2, 7, 60, 3000] {
            for (a, b) in one.into_iter().zip(run(n)) {
                assert!(abs_diff_eq!(a / b, 1.0, epsilon = 1e-8), "variant {variant}, {n} parts: {one:?} against {b}");
            }
        }
    }
}

/// With lag the loop dissipates more energy than the static law in the same motion, and the power is never negative.
#[test]
fn the_lag_is_passive() {
    for variant in [1.0, 2.0] {
        let mut law = Bench::new("FrictionalLag", &[("variant", variant), ("time_lag", 0.05)]);
        let mut energy = 0.0;
        for k in 0..5000 {
            law.set("velocity", 3e-3 * (f64::from(k) * 0.013).sin() + 1e-3 * (f64::from(k) * 0.17).cos());
            law.step(2e-3);
            assert!(law.get("dissipated_power") >= 0.0);
            let now = law.get("dissipated_energy");
            assert!(now >= energy);
            energy = now;
        }
        assert!(energy > 0.0);
    }
}

/// Rows of Hess and Soom's curve, which the slip branch becomes without lag and with an instant rise.
#[test]
fn armstrong_without_lag_slides_on_the_curve_of_hess_and_soom() {
    let rows = [
        (1e-5, 1.47145095),
        (2e-4, 1.45263462),
        (5e-4, 1.3734),
        (7.5e-4, 1.29492),
        (1e-3, 1.22625),
        (2e-3, 1.0791),
        (1e-2, 0.985856436),
    ];
    for (velocity, expected) in rows {
        for h in [1e-3, 1.0, 100.0] {
            let mut law = Bench::new("Armstrong", &[("time_lag", 0.0), ("gamma", 0.0), ("velocity", velocity)]);
            for _ in 0..(10.0 / h) as i32 + 1 {
                law.step(h);
            }
            let found = law.get("friction_force");
            assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 1e-8), "{velocity} {h}: {found}");
        }
    }
}

/// The same motion in steps of 1 us to 1 s: the times of breakaway and stop are the same, and so is the motion after
/// them.
#[test]
fn armstrong_events_do_not_depend_on_the_step() {
    let run = |h: f64| {
        let mut law = Bench::new("Armstrong", &[("gamma", 0.3)]);
        let mut found = Vec::new();
        for velocity in [0.0, 2e-5, 1e-3, -3e-4, 0.0, 4e-3] {
            law.set("velocity", velocity);
            for _ in 0..(1.0 / h).round() as i32 {
                law.step(h);
            }
            for name in ["friction_force", "dissipated_energy", "stribeck_coefficient", "sticking"] {
                found.push(law.get(name));
            }
        }
        found
    };
    let one = run(1.0);
    assert!(one.iter().step_by(4).all(|force| force.abs() <= F_S));
    for h in [0.5, 0.1, 1e-3, 1e-5, 1e-6] {
        for (&a, b) in one.iter().zip(run(h)) {
            // A million additions of h leave a time with a relative error of 1e-11.
            assert!(abs_diff_eq!(a, b, epsilon = 1e-10 * a.abs()), "{h}: {a} against {b}");
        }
    }
}

/// The first slip on the belt, integrated directly with an explicit scheme at 1 us and a past of 5000 samples:
/// time at which 1 mm/s is reached, highest position with its time, time and position of the stop.
fn first_slip() -> [f64; 5] {
    // The spring reaches the level when k v_b t = f_C + F_Sinf t / (t + gamma): 0.2 t^2 - 1.0715 t - 1.962 = 0.
    let begin = (1.0715 + f64::sqrt(1.0715 * 1.0715 + 0.8 * 1.962)) / 0.4;
    let excess = 0.2 * begin - F_C;
    let (mut past, mut x, mut v, h) = ([0.0; 5000], 0.1 * begin, 0.1, 1e-6);
    let (mut fast, mut highest) = (0.0, (0.0, 0.0));
    for k in 0.. {
        let time = begin + h * k as f64;
        if x > highest.1 {
            highest = (time, x);
        }
        if fast == 0.0 && v < 0.099 {
            fast = time;
        }
        let w: f64 = past[k % 5000];
        past[k % 5000] = v - 0.1;
        let next = v + h * (F_C + excess / (1.0 + (w / V_S).powi(2)) - 2.0 * x);
        x += 0.5 * h * (v + next);
        v = next;
        if v >= 0.1 && k > 10_000 {
            return [fast, highest.0, highest.1, time, x];
        }
    }
    unreachable!("the block stops")
}

#[test]
fn armstrong_on_the_belt_follows_a_direct_integration() {
    let [fast, time, highest, stop, position] = first_slip();
    let mut law = Bench::new("Armstrong", &[]);
    let samples = belt(&mut law, 1e-4, 10.0, Exchange::Sequential);
    let after = |from: f64| samples.iter().filter(move |s| s.time > from);
    let found = after(1.0).find(|s| s.velocity < -1e-3).expect("slip").time;
    assert!(abs_diff_eq!(found, fast, epsilon = 2e-3), "1 mm/s at {found}, {fast}");
    let top = after(1.0).max_by(|a, b| a.position.total_cmp(&b.position)).expect("samples");
    assert!(
        (top.position / highest - 1.0).abs() < 1e-3 && (top.time - time).abs() < 5e-3,
        "{top:?} {highest} at {time}"
    );
    let end = after(stop - 0.5).find(|s| s.velocity >= 0.0).expect("a stop");
    assert!(
        (end.time - stop).abs() < 5e-3 && (end.position / position - 1.0).abs() < 2e-3,
        "{end:?}: {position} at {stop}"
    );
}

/// Rows of Tustin's curve, which both curves become for f_l0 = f_s and a = b = 1 / v_S.
#[test]
fn non_reversible_with_equal_curves_is_tustin() {
    let rows = [
        (1e-5, 1.46661944),
        (2e-4, 1.38258743),
        (5e-4, 1.27850329),
        (7.5e-4, 1.21269579),
        (1e-3, 1.16144487),
        (2e-3, 1.04738196),
        (1e-2, 0.981022269),
    ];
    for (velocity, expected) in rows {
        for acceleration in [-5.0, 0.0, 5.0] {
            let values = [("mu_stop", 0.15), ("acceleration_decay", 1e3), ("deceleration_decay", 1e3)];
            let mut law = Bench::new("NonReversible", &values);
            law.set("velocity", velocity);
            law.set("acceleration", acceleration);
            let found = law.get("friction_force");
            assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 5e-9), "{velocity}: {found}");
        }
    }
}

/// A velocity that oscillates without reversing follows both curves, whether the master gives slopes or the
/// acceleration; by hand at v = V = 2 mm/s, where a v = 1: f_C + (f_s - f_C) / e upwards and f_C (1 - 1 / e) downwards.
#[test]
fn non_reversible_loop_is_the_same_with_slopes_and_with_the_acceleration() {
    let upper = F_C + (F_S - F_C) * (-1f64).exp();
    let lower = F_C * (1.0 - (-1f64).exp());
    for (end, expected, sign) in [(1.0, upper, 1.0), (1.5, lower, -1.0)] {
        let mut law = Bench::new("NonReversible", &[]);
        oscillate(&mut law, 1e-3, end, true);
        let found = law.get("friction_force");
        assert!(abs_diff_eq!(found, expected, epsilon = 1e-12), "{end}: {found}");
        let mut law = Bench::new("NonReversible", &[("acceleration", sign * 1e-9)]);
        oscillate(&mut law, 1e-3, end, false);
        assert!(abs_diff_eq!(law.get("friction_force"), expected, epsilon = 1e-12), "{end}");
    }
}

/// Energy over one period, compared with the midpoint rule over both branches of the loop.
#[test]
fn non_reversible_energy_per_period() {
    let mut law = Bench::new("NonReversible", &[]);
    oscillate(&mut law, 1e-4, 1.0, true);
    let level = |time: f64| {
        let fading = (-500.0 * oscillation(time)).exp();
        if (TAU * time).cos() > 0.0 { F_C + (F_S - F_C) * fading } else { F_C * (1.0 - fading) }
    };
    // A quarter of a period each, without the instants at which the acceleration is 0.
    let n = 4000;
    let mut energy = 0.0;
    for quarter in 0..4 {
        for k in 0..n {
            let time = 0.25 * (f64::from(quarter) + (f64::from(k) + 0.5) / f64::from(n));
            energy += level(time) * oscillation(time) * 0.25 / f64::from(n);
        }
    }
    let found = law.get("dissipated_energy");
    assert!(abs_diff_eq!(found / energy, 1.0, epsilon = 1e-6), "{found} against {energy}");
}

/// The first slip of Wojewoda's law on the belt, integrated directly at 1 us with the two curves: highest position with
/// its time, time and position of the stop. A block that can neither speed up nor slow down on its curves keeps its
/// velocity.
fn first_slip_on_two_curves() -> [f64; 4] {
    let (begin, h) = (F_S / 0.2, 1e-6);
    let (mut x, mut v, mut highest) = (0.1 * begin, 0.1 - 1e-9, (0.0, 0.0));
    for k in 0.. {
        let time = begin + h * f64::from(k);
        if x > highest.1 {
            highest = (time, x);
        }
        let fading = (F_S - F_C) * (-500.0 * (v - 0.1f64).abs()).exp();
        // Slip is backwards: the block speeds up as long as it can against the upper curve.
        let (upper, lower) = (F_C + fading - 2.0 * x, F_C - fading - 2.0 * x);
        let acceleration = if upper <= 0.0 { upper } else { lower.max(0.0) };
        let next = v + h * acceleration;
        x += 0.5 * h * (v + next);
        v = next;
        if v >= 0.1 {
            return [highest.0, highest.1, time, x];
        }
    }
    unreachable!("the block stops")
}

#[test]
fn wojewoda_on_the_belt_follows_a_direct_integration() {
    let [time, highest, stop, position] = first_slip_on_two_curves();
    let (mut rig, mut law, h) = (Bench::new("BeltRig", &[]), Bench::new("Wojewoda", &[]), 1e-4);
    let (mut force, mut top, mut end) = (0.0, (0.0, 0.0), None);
    for k in 0..120_000 {
        let now = h * f64::from(k);
        let (velocity, external_force) = (rig.get("velocity"), rig.get("external_force"));
        law.set("velocity", velocity);
        law.set("acceleration", external_force - force);
        law.step(h);
        force = law.get("friction_force");
        rig.set("friction_force", force);
        rig.step(h);
        if rig.get("position") > top.1 && end.is_none() {
            top = (now, rig.get("position"));
        }
        if now > stop - 0.5 && velocity >= 0.0 && end.is_none() {
            end = Some((now, rig.get("position")));
        }
    }
    let end = end.expect("a stop");
    assert!((top.0 - time).abs() < 5e-3 && (top.1 / highest - 1.0).abs() < 1e-3, "{top:?}: {highest} at {time}");
    assert!((end.0 - stop).abs() < 5e-3 && (end.1 / position - 1.0).abs() < 2e-3, "{end:?}: {position} at {stop}");
}

/// The same motion in steps of 1 us to 1 s: breakaway and stop happen at the same instants.
#[test]
fn wojewoda_events_do_not_depend_on_the_step() {
    let run = |h: f64| {
        let mut law = Bench::new("Wojewoda", &[]);
        let mut found = Vec::new();
        for velocity in [1.2e-5, 1e-3, -3e-4, 0.0, 4e-3] {
            law.set("velocity", velocity);
            for _ in 0..(1.0 / h).round() as i32 {
                law.step(h);
            }
            found.extend(["friction_force", "dissipated_energy", "sticking"].map(|name| law.get(name)));
        }
        found
    };
    let one = run(1.0);
    for h in [0.5, 0.1, 1e-3, 1e-5, 1e-6] {
        for (&a, b) in one.iter().zip(run(h)) {
            assert!(abs_diff_eq!(a, b, epsilon = 1e-10 * a.abs()), "{h}: {a} against {b}");
        }
    }
}

/// Its curves are those of the non-reversible law with f_l0 = 2 f_C - f_s.
#[test]
fn wojewoda_slides_on_the_mirrored_curves_of_the_non_reversible_law() {
    for velocity in [1e-4, -1e-3, 5e-3, -0.2] {
        for acceleration in [-1.0, 0.0, 1.0] {
            let values = [("velocity", velocity), ("acceleration", acceleration)];
            let mut law = Bench::new("Wojewoda", &values);
            law.step(1.0);
            let mut curves = Bench::new("NonReversible", &values);
            curves.set("mu_stop", 0.05);
            let (a, b) = (law.get("friction_force"), curves.get("friction_force"));
            assert!(abs_diff_eq!(a, b, epsilon = 1e-15), "{velocity} {acceleration}: {a} against {b}");
        }
    }
}

/// A model, its parameters and the velocity to look at.
type Case = (&'static str, &'static [(&'static str, f64)], f64);

/// Time derivatives of the outputs, compared with the changes over a short ramp, while stuck and while sliding.
#[test]
fn time_derivatives_of_outputs_agree_with_a_short_ramp() {
    let cases: [Case; 7] = [
        ("FrictionalLag", &[("time_lag", 0.01)], 2e-3),
        ("FrictionalLag", &[("time_lag", 0.01), ("variant", 2.0)], 2e-3),
        ("Armstrong", &[("gamma", 0.1)], 2e-3),
        ("Armstrong", &[("time_lag", 0.0)], 2e-3),
        ("Armstrong", &[], 1e-5),
        ("NonReversible", &[], 2e-3),
        ("Wojewoda", &[], 1e-5),
    ];
    for (model, values, velocity) in cases {
        let mut law = Bench::new(model, values);
        let (input, force) = (law.column("velocity"), law.column("friction_force"));
        // The slope of the step remains the slope of the input after it.
        let ramp = |law: &mut Bench, time: f64| {
            law.instance.set_slope(input, 20.0 * velocity).unwrap();
            law.step(time);
        };
        law.set("velocity", velocity);
        law.step(0.03);
        ramp(&mut law, 0.017);
        let (before, slope) = (law.get("friction_force"), law.instance.time_derivative()[force].slope);
        ramp(&mut law, 1e-7);
        let found = (law.get("friction_force") - before) / 1e-7;
        assert!((slope - found).abs() < 1e-3 * found.abs() && found != 0.0, "{model} {values:?}: {slope}, {found}");
    }
}

/// A motion that comes to rest while the load grows: the level is exceeded in the middle of the step, although at its
/// end the contact could hold again. Many short steps cannot miss this.
#[test]
fn a_breakaway_that_the_end_of_the_step_hides_is_found() {
    for (model, values) in [("Armstrong", [("gamma", 1.0), ("mu_s", 0.11)]), ("Wojewoda", [("mu_k", 0.1); 2])] {
        let run = |n: i32| {
            let mut law = Bench::new(model, &values);
            law.set("mu_s", 0.11);
            law.set("normal_force", 1.0);
            law.set("velocity", 2e-5);
            let (velocity, load) = (law.column("velocity"), law.column("normal_force"));
            for _ in 0..n {
                // To 1 % of the velocity, and from 1 N to 10.9 N.
                law.instance.set_slope(velocity, -2e-5).unwrap();
                law.instance.set_slope(load, 10.0).unwrap();
                law.step(0.99 / f64::from(n));
            }
            [law.get("slipping"), law.get("dissipated_energy"), law.get("friction_force")]
        };
        let [slipping, energy, force] = run(1);
        assert_eq!(slipping, 1.0, "{model}");
        for n in [2, 100, 1000] {
            let [other, b, c] = run(n);
            assert!(other == 1.0 && (energy / b - 1.0).abs() < 1e-7 && (force / c - 1.0).abs() < 1e-7, "{model} {n}");
        }
    }
}

/// A step of 20 000 lags: the filter reaches the new velocity within a few of them, but the energy of this transient
/// counts.
#[test]
fn a_step_much_longer_than_the_filter_keeps_the_energy_of_the_transient() {
    let run = |steps: &[f64]| {
        let mut law = Bench::new("FrictionalLag", &[("variant", 2.0), ("time_lag", 5e-6), ("velocity", -3e-3)]);
        law.step(1e-3);
        law.set("velocity", 4e-3);
        for h in steps {
            law.step(*h);
        }
        // The steady state would dissipate 4e-3 * 0.981 * time.
        law.get("dissipated_energy") - 4e-3 * gaussian(4e-3) * steps.iter().sum::<f64>()
    };
    let fine = run(&[1e-7; 2000]);
    let coarse = run(&[0.1 - 2e-4, 2e-4]);
    let start = 3e-3 * gaussian(3e-3) * 1e-3;
    assert!(
        abs_diff_eq!((coarse - start) / (fine - start), 1.0, epsilon = 1e-6),
        "{} against {}",
        coarse - start,
        fine - start
    );
}
