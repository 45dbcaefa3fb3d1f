//! Steps of co-simulation: their clock, their length and ramps to their end.

use crate::common::importer::Importer;
use crate::common::random::Random;
use crate::{drive, millisecond};
use stribeck::catalogue;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

#[test]
fn steps_that_make_no_sense_are_rejected() {
    for (t, h) in [
        (0.0, 0.0),
        (0.0, -1e-3),
        (0.0, f64::NAN),
        (0.0, f64::INFINITY),
        (f64::NAN, 1e-3),
        (f64::INFINITY, 1e-3),
        (5e-3, 1e-3),
        (-1e-3, 1e-3),
        (0.0, 100.1),
    ] {
        let importer = Importer::ready("LuGre");
        assert_eq!(importer.step(t, h), fmi2Error, "{t} {h}");
        importer.one_message();
        assert_eq!(importer.step(0.0, 1e-3), fmi2Error, "after an error");
    }
    let endless = Importer::new("LuGre");
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi2SetupExperiment(endless.c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(endless.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(endless.c), fmi2OK);
    }
    assert_eq!(endless.step(0.0, f64::INFINITY), fmi2Error, "an infinite step without a stop time");
}

/// Masters accumulate the time, multiply it, count nanoseconds, or make one tiny step at the end.
#[test]
fn communication_points_are_compared_with_a_relative_tolerance() {
    let h = 1e-3;
    let accumulated = Importer::ready("LuGre");
    let mut t = 0.0;
    for _ in 0..90_000 {
        assert_eq!(accumulated.step(t, h), fmi2OK);
        t += h;
    }
    let computed = Importer::ready("LuGre");
    for k in 0..90_000 {
        assert_eq!(computed.step(f64::from(k) * h, h), fmi2OK);
    }
    let counted = Importer::ready("LuGre");
    for k in 0..90_000i64 {
        let (t, next) = ((k * 1_000_000) as f64 * 1e-9, ((k + 1) * 1_000_000) as f64 * 1e-9);
        assert_eq!(counted.step(t, next - t), fmi2OK);
    }
    let ulp = Importer::ready("LuGre");
    let mut t: f64 = 0.0;
    for k in 0..90_000 {
        let t_off = if k % 2 == 0 { t.next_up() } else { t.next_down() };
        assert_eq!(ulp.step(t_off, h), fmi2OK);
        t = t_off + h;
    }
    assert_eq!(computed.step(90.0, 10.0 - 2e-13), fmi2OK);
    assert_eq!(computed.step(100.0 - 2e-13, 2e-13), fmi2OK, "a last step of 2e-13 s");
    assert_eq!(computed.step(100.0, 1e-3), fmi2Error, "past the stop time");
}

/// Equal steps give equal results, however a master computes the time, even with rounding errors.
#[test]
fn results_do_not_depend_on_how_the_time_is_computed() {
    let h = 1e-3;
    let mut accumulated = vec![0.0];
    (0..500).for_each(|k| accumulated.push(accumulated[k] + h));
    assert_ne!(accumulated[500], 500.0 * h, "accumulated rounding errors");
    for model in catalogue::models() {
        let run = |time: &dyn Fn(i32) -> f64| drive(&Importer::ready(model.name), 0..500, h, time);
        let computed = run(&millisecond);
        let clocks: [(&str, &dyn Fn(i32) -> f64); 3] = [
            ("accumulated", &|k| accumulated[k as usize]),
            ("an ulp late", &|k| millisecond(k).next_up()),
            ("an ulp early", &|k| if k == 0 { 0.0 } else { millisecond(k).next_down() }),
        ];
        for (which, clock) in clocks {
            assert_eq!(run(clock), computed, "{} with time {which}", model.name);
        }
    }
}

#[test]
fn a_ramp_out_of_a_bound_is_rejected_and_one_onto_it_is_not() {
    let importer = Importer::ready("LuGre");
    let slope = |value: f64| {
        // SAFETY: one reference, one value.
        let status = unsafe { fmi2SetRealInputDerivatives(importer.c, &importer.vr("normal_force"), 1, &1, &value) };
        assert_eq!(status, fmi2OK);
    };
    let (mut t, mut random) = (0.0, Random(1));
    for _ in 0..500 {
        let (load, h) = (16.0 * random.next() + 1e-3, (1000.0 * random.next()).ceil() / 30_000.0);
        assert_eq!(importer.set("normal_force", load), fmi2OK);
        slope(-load / h);
        assert_eq!(importer.step(t, h), fmi2OK, "{load} N to 0 in {h} s");
        assert!(importer.get("normal_force") < 1e-12);
        t += h;
    }
    assert_eq!(importer.set("normal_force", 1.0), fmi2OK);
    slope(-1001.0);
    assert_eq!(importer.step(t, 1e-3), fmi2Error);
    assert!(importer.one_message().2.contains("at the end of its ramp normal_force = -0.001"));
}

#[test]
fn the_clock_is_the_masters() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.step(0.0, 0.1), fmi2OK);
    let t = 0.1f64.next_up();
    assert_eq!(importer.step(t, 0.2), fmi2OK);
    let mut time = f64::NAN;
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2GetRealStatus(importer.c, fmi2LastSuccessfulTime, &mut time) }, fmi2OK);
    assert_eq!(time, t + 0.2);
    // A repeated or skipped step is detected however small it is.
    let tiny = Importer::ready("LuGre");
    assert_eq!(tiny.step(0.0, 99.0), fmi2OK);
    assert_eq!(tiny.step(99.0, 1e-6), fmi2OK);
    assert_eq!(tiny.step(99.0, 1e-6), fmi2Error);
}

/// Found by fuzzing: without a stop time, two steps of the longest length led to an infinite time.
#[test]
fn time_stays_finite() {
    let importer = Importer::new("EndStops");
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi2SetupExperiment(importer.c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(importer.c), fmi2OK);
    }
    assert_eq!(importer.step(0.0, f64::MAX), fmi2OK);
    assert_eq!(importer.step(f64::MAX, f64::MAX), fmi2Error);
    assert!(importer.one_message().2.contains("to inf s passes the stop time"));
}
