//! What needs the probe: base types, enumerations, parts, panics. The rest is tested from outside in `tests/fmi.rs`.

use std::ffi::CString;
use std::process::Command;
use std::ptr::{null, null_mut};

use super::lifecycle::STATES;
use super::setup::*;
use super::step::*;
use super::types::*;
use super::values::*;
use crate::catalogue;

const CALLBACKS: fmi2CallbackFunctions = fmi2CallbackFunctions {
    logger: None,
    allocateMemory: None,
    freeMemory: None,
    stepFinished: None,
    componentEnvironment: null_mut(),
};

/// An instance of the probe, ready to step.
fn probe() -> fmi2Component {
    let guid = CString::new(catalogue::by_name("Probe").expect("the probe").guid()).expect("no zero byte");
    // SAFETY: valid texts and callbacks; the instance is used by one test only.
    unsafe {
        let c = fmi2Instantiate(
            c"probe".as_ptr(),
            fmi2CoSimulation,
            guid.as_ptr(),
            null(),
            &CALLBACKS,
            fmi2False,
            fmi2True,
        );
        assert!(!c.is_null());
        assert_eq!(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2Status::fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(c), fmi2Status::fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(c), fmi2Status::fmi2OK);
        c
    }
}

fn column(name: &str) -> fmi2ValueReference {
    catalogue::by_name("Probe").and_then(|model| model.find(name)).expect(name) as fmi2ValueReference
}

fn set_integer(c: fmi2Component, name: &str, value: fmi2Integer) -> fmi2Status {
    // SAFETY: one reference, one value.
    unsafe { fmi2SetInteger(c, &column(name), 1, &value) }
}

fn get_real(c: fmi2Component, name: &str) -> f64 {
    let mut value = f64::NAN;
    // SAFETY: one reference, one value.
    assert_eq!(unsafe { fmi2GetReal(c, &column(name), 1, &mut value) }, fmi2Status::fmi2OK);
    value
}

fn step(c: fmi2Component, t: f64) -> fmi2Status {
    // SAFETY: an instance of this test.
    unsafe { fmi2DoStep(c, t, 0.5, fmi2True) }
}

#[test]
fn integers_booleans_and_enumerations_have_their_own_functions_and_bounds() {
    let c = probe();
    for (value, status) in [(0, fmi2Status::fmi2OK), (9, fmi2Status::fmi2OK), (10, fmi2Status::fmi2Discard)] {
        assert_eq!(set_integer(c, "count", value), status, "{value}");
    }
    for (value, status) in [(1, fmi2Status::fmi2OK), (0, fmi2Status::fmi2Discard), (4, fmi2Status::fmi2Discard)] {
        assert_eq!(set_integer(c, "behaviour", value), status, "{value}");
    }
    // SAFETY: one reference, one value in each call.
    unsafe {
        for (value, status) in [(0, fmi2Status::fmi2OK), (1, fmi2Status::fmi2OK), (2, fmi2Status::fmi2Discard)] {
            assert_eq!(fmi2SetBoolean(c, &column("enabled"), 1, &value), status, "{value}");
        }
        let mut value = -1;
        assert_eq!(fmi2GetInteger(c, &column("count"), 1, &mut value), fmi2Status::fmi2OK);
        assert_eq!(value, 9, "the refused 10 has changed nothing");
        assert_eq!(fmi2GetBoolean(c, &column("enabled"), 1, &mut value), fmi2Status::fmi2OK);
        assert_eq!(value, fmi2True);
        assert_eq!(fmi2SetReal(c, &column("element[2].stiffness"), 1, &5.0), fmi2Status::fmi2OK);
        assert_eq!(get_real(c, "element[2].stiffness"), 5.0);
        assert_eq!(get_real(c, "element[3].stiffness"), 2.0);
        assert_eq!(fmi2GetReal(c, &column("count"), 1, &mut 0.0), fmi2Status::fmi2Error, "an Integer is no Real");
        fmi2FreeInstance(c);
    }
}

#[test]
fn a_step_that_would_overflow_is_an_error_and_changes_nothing() {
    let c = probe();
    // SAFETY: instances and arrays of this test.
    unsafe {
        assert_eq!(fmi2SetReal(c, &column("rate"), 1, &4.0), fmi2Status::fmi2OK);
        assert_eq!(step(c, 0.0), fmi2Status::fmi2OK);
        assert_eq!(set_integer(c, "behaviour", 3), fmi2Status::fmi2OK);
        assert_eq!(step(c, 0.5), fmi2Status::fmi2Error);
        assert_eq!(get_real(c, "doubled"), 4.0);
        assert_eq!(step(c, 0.5), fmi2Status::fmi2Error, "after an error only reset, free and restore lead on");
        assert_eq!(fmi2Reset(c), fmi2Status::fmi2OK);
        fmi2FreeInstance(c);
    }
}

const CHILD: &str = "STRIBECK_TEST_PANICS";

/// Run by the next test in a process of its own, whose output can be seen.
#[test]
fn child_panics() {
    if std::env::var_os(CHILD).is_none() {
        return;
    }
    let c = probe();
    assert_eq!(set_integer(c, "behaviour", 2), fmi2Status::fmi2OK);
    assert_eq!(step(c, 0.0), fmi2Status::fmi2Error);
    assert_eq!(get_real(c, "integral"), 0.0);
    let next = probe();
    assert_eq!(step(next, 0.0), fmi2Status::fmi2OK, "the next instance works");
    // SAFETY: instances of this test, each freed once.
    unsafe {
        fmi2FreeInstance(c);
        fmi2FreeInstance(next);
    }
}

#[test]
fn a_panic_becomes_an_error_and_prints_nothing() {
    let me = std::env::current_exe().expect("the test program");
    let run = |arguments: &[&str]| {
        let output = Command::new(&me).args(arguments).env(CHILD, "1").output().expect("run the test program again");
        (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (passed, said) = run(&["--exact", "fmi2::tests::child_panics", "--nocapture"]);
    assert!(passed && said.is_empty(), "{said}");
}

/// The rows of the table of section 4.2.4 are as many as the functions on an instance, and no state is without a way out.
#[test]
fn every_state_allows_reset_free_and_restore() {
    use super::lifecycle::Call;
    for state in STATES {
        assert!(Call::Reset.is_allowed(state) && Call::SetFMUstate.is_allowed(state), "{state:?}");
    }
}
