//! An arm that a servo holds against its weight, as two FMUs of a co-simulation.

use crate::common::importer::Importer;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

const H: f64 = 0.01;

/// An initialized FMU without a stop time.
fn initialized(model: &'static str, values: &[(&str, f64)], exchange: Option<i32>) -> Importer {
    let importer = Importer::new(model);
    for (name, value) in values {
        assert_eq!(importer.set(name, *value), fmi2OK, "{name}");
    }
    // SAFETY: an instance of this test; one reference, one value.
    unsafe {
        if let Some(number) = exchange {
            assert_eq!(fmi2SetInteger(importer.c, &importer.vr("exchange"), 1, &number), fmi2OK);
        }
        assert_eq!(fmi2SetupExperiment(importer.c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(importer.c), fmi2OK);
    }
    importer
}

/// For 1,000 s at a step of 10 ms, whether the values are exchanged in turn or all at once: a load at 0.8 rad of which the
/// motor carries 70 %, after a start with a small velocity.
#[test]
fn a_servo_holds_its_load_for_a_thousand_seconds() {
    // The torque of the motor at rest is 75.84 V/rad times 2.231 / 2.372 N.m/V.
    let target = 0.8 + 0.7 * 0.981 * f64::sin(0.8) / (75.84 * 2.231 / 2.372);
    for exchange in [1, 2] {
        let arm = initialized("ServoArm", &[("angle", 0.8), ("velocity", 0.05), ("target_angle", target)], None);
        let mass = arm.get("effective_mass");
        let begin = ["velocity", "motor_force", "load_force"].map(|name| (name, arm.get(name)));
        let values: Vec<_> = begin.into_iter().chain([("mass", mass)]).collect();
        let friction = initialized("ServoFriction", &values, Some(exchange));
        assert_eq!(arm.set("friction_force", friction.get("friction_force")), fmi2OK);
        let mut rested = f64::NAN;
        for step in 0..100_000 {
            let t = f64::from(step) * H;
            let exchange_values = || {
                assert_eq!(arm.set("friction_force", friction.get("friction_force")), fmi2OK);
            };
            for name in ["velocity", "motor_force", "load_force"] {
                assert_eq!(friction.set(name, arm.get(name)), fmi2OK);
            }
            if exchange == 1 {
                assert_eq!(friction.step(t, H), fmi2OK);
                exchange_values();
                assert_eq!(arm.step(t, H), fmi2OK);
            } else {
                assert_eq!(friction.step(t, H), fmi2OK);
                assert_eq!(arm.step(t, H), fmi2OK);
                exchange_values();
            }
            if step == 999 {
                rested = arm.get("angle");
            }
        }
        let [angle, velocity] = ["angle", "velocity"].map(|name| arm.get(name));
        // A parallel exchange overshoots in its first step, which has the printed force.
        assert!((rested - 0.8).abs() < 2e-3, "{exchange}: {rested} rad");
        assert!((angle - rested).abs() < 1e-12 && velocity.abs() < 1e-13, "{exchange}: {angle} {velocity} {rested}");
    }
}
