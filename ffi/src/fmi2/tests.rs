//! Tests that need the probe: base types, enumerations, parts, panics. The rest is tested from outside in
//! `tests/fmi`.

use std::ffi::{CStr, CString, c_void};
use std::process::Command;
use std::ptr::{null, null_mut};
use std::sync::Mutex;

use super::lifecycle::STATES;
use super::setup::*;
use super::step::*;
use super::types::*;
use super::values::*;
use crate::models;
use stribeck::model::{Kind, Role};

const CALLBACKS: fmi2CallbackFunctions = fmi2CallbackFunctions {
    logger: None,
    allocateMemory: None,
    freeMemory: None,
    stepFinished: None,
    componentEnvironment: null_mut(),
};

/// An instance of the probe, ready to step.
fn probe() -> fmi2Component {
    probe_with(&CALLBACKS, fmi2True)
}

fn probe_with(callbacks: &fmi2CallbackFunctions, debug: fmi2Boolean) -> fmi2Component {
    let guid = CString::new(models::by_name("Probe").expect("the probe").guid()).expect("no zero byte");
    made(&guid, callbacks, debug)
}

fn made(guid: &CStr, callbacks: &fmi2CallbackFunctions, debug: fmi2Boolean) -> fmi2Component {
    // SAFETY: valid texts and callbacks; the instance is used by one test only.
    unsafe {
        let c =
            fmi2Instantiate(c"probe".as_ptr(), fmi2CoSimulation, guid.as_ptr(), null(), callbacks, fmi2False, debug);
        assert!(!c.is_null());
        assert_eq!(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2Status::fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(c), fmi2Status::fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(c), fmi2Status::fmi2OK);
        c
    }
}

/// The guid of the FMU with Real variables only makes an instance in which every variable is one, as it is in the row.
#[test]
fn in_a_plain_fmu_all_variables_are_real() {
    let model = models::by_name("Probe").expect("the probe");
    let plain = CString::new(model.plain_guid()).expect("no zero byte");
    let c = made(&plain, &CALLBACKS, fmi2True);
    for (column, variable) in model.variables().filter(|(_, variable)| !matches!(variable.kind, Kind::Real(_))) {
        let (reference, mut value) = (model.reference(column), f64::NAN);
        // SAFETY: one reference, one value.
        let status = unsafe { fmi2GetReal(c, &reference, 1, &mut value) };
        assert_eq!(status, fmi2Status::fmi2OK, "{}", variable.path);
        if !variable.role.is_computed() {
            assert_eq!(value, variable.start, "{}", variable.path);
        }
        if variable.role == Role::Tunable {
            // SAFETY: as above.
            let refused = unsafe { fmi2SetReal(c, &reference, 1, &0.5) };
            assert_eq!(refused, fmi2Status::fmi2Discard, "{}", variable.path);
            // SAFETY: as above.
            assert_eq!(unsafe { fmi2SetReal(c, &reference, 1, &variable.start) }, fmi2Status::fmi2OK);
        }
    }
    // SAFETY: made above, used no more.
    unsafe { fmi2FreeInstance(c) };
}

fn column(name: &str) -> fmi2ValueReference {
    let probe = models::by_name("Probe").expect("a model");
    probe.reference(probe.find(name).expect(name))
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
        assert_eq!(fmi2GetReal(c, &column("count"), 1, &mut 0.0), fmi2Status::fmi2Error, "an Integer is not a Real");
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
        assert_eq!(step(c, 0.5), fmi2Status::fmi2Error, "after an error only reset, free and restore are allowed");
        assert_eq!(fmi2Reset(c), fmi2Status::fmi2OK);
        fmi2FreeInstance(c);
    }
}

/// A message logged by the probe: the status, the category, and the beginning of the text.
static TOLD: Mutex<Vec<(fmi2Status, String, String)>> = Mutex::new(Vec::new());

/// Rust cannot define variadic functions; see `tests/common/importer.rs`.
unsafe extern "C" fn listen(
    _environment: *mut c_void,
    _name: fmi2String,
    status: fmi2Status,
    category: fmi2String,
    _message: fmi2String,
    argument: fmi2String,
) {
    // SAFETY: texts of the library.
    let text = |text| unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned();
    TOLD.lock().expect("one test").push((status, text(category), text(argument)));
}

/// Values that make no sense are accepted: the step returns fmi2OK, and the logger gets the reason, once for each text,
/// after the steps 1, 2, 4 and so on, even if logging is off.
#[test]
fn a_warning_is_told_once() {
    type Fixed = unsafe extern "C" fn(*mut c_void, fmi2String, fmi2Status, fmi2String, fmi2String, fmi2String);
    // SAFETY: see `listen`.
    let logger = unsafe { std::mem::transmute::<Fixed, fmi2CallbackLogger>(listen) };
    let c = probe_with(&fmi2CallbackFunctions { logger, ..CALLBACKS }, fmi2False);
    let told = || std::mem::take(&mut *TOLD.lock().expect("one test"));
    let set = |rate: f64| {
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi2SetReal(c, &column("rate"), 1, &rate) }, fmi2Status::fmi2OK);
    };
    let mut k = 0;
    let mut steps = |count: i32| {
        for _ in 0..count {
            assert_eq!(step(c, 0.5 * f64::from(k)), fmi2Status::fmi2OK);
            k += 1;
        }
    };
    steps(3);
    assert!(told().is_empty());
    set(-7.0);
    steps(1);
    let why = "rate = -7: the probe counts up".to_owned();
    assert_eq!(told(), [(fmi2Status::fmi2Warning, "logStatusWarning".to_owned(), why)]);
    steps(12);
    assert!(told().is_empty(), "once");
    set(-8.0);
    steps(15);
    assert!(told().is_empty(), "not before step 32");
    steps(1);
    assert_eq!(told().len(), 1, "another text");
    set(-7.0);
    steps(96);
    assert!(told().is_empty(), "told before");
    // SAFETY: an instance of this test, freed once.
    unsafe {
        assert_eq!(fmi2SetDebugLogging(c, fmi2False, 1, &c"logStatusWarning".as_ptr()), fmi2Status::fmi2OK);
        fmi2FreeInstance(c);
    }
}

const CHILD: &str = "STRIBECK_TEST_PANICS";

/// Run by the next test in a separate process, whose output can be seen.
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

/// The table of section 4.2.4 has one row per function on an instance, and no state is without a way out.
#[test]
fn every_state_allows_reset_free_and_restore() {
    use super::lifecycle::Call;
    for state in STATES {
        assert!(Call::Reset.is_allowed(state) && Call::SetFMUstate.is_allowed(state), "{state:?}");
    }
}
