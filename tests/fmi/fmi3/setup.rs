//! Instantiation, log, and states without a way in.

use std::ffi::CStr;
use std::ptr::{null, null_mut};

use super::importer::{Choice, Importer, token};
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::types::*;

#[test]
fn the_version_is_that_of_the_standard() {
    // SAFETY: a constant text.
    assert_eq!(unsafe { CStr::from_ptr(fmi3GetVersion()) }, c"3.0");
}

/// The last message of the two functions below.
static LAST: std::sync::Mutex<String> = std::sync::Mutex::new(String::new());

unsafe extern "C-unwind" fn note(_: *mut std::ffi::c_void, status: fmi3Status, _: fmi3String, text: fmi3String) {
    assert_eq!(status, fmi3Error);
    // SAFETY: a text of the library.
    *LAST.lock().expect("one test") = unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned();
}

#[test]
fn instantiation_rejects_what_it_cannot_serve() {
    let good = token("LuGre");
    let make = |name: &CStr, token: *const _, required: &[u32]| {
        // SAFETY: valid texts and arrays.
        let instance = unsafe {
            let (required, count) = (required.as_ptr(), required.len());
            fmi3InstantiateCoSimulation(
                name.as_ptr(),
                token,
                null(),
                0,
                1,
                0,
                0,
                required,
                count,
                null_mut(),
                Some(note),
                None,
            )
        };
        assert!(instance.is_null());
        std::mem::take(&mut *LAST.lock().expect("one test"))
    };
    assert!(make(c" ", good.as_ptr(), &[]).contains("instanceName is NULL or blank"));
    assert!(make(c"a", null(), &[]).contains("instantiationToken is NULL"));
    assert!(make(c"a", c"{other}".as_ptr(), &[]).contains("instantiationToken {other} does not belong"));
    let mu_k = Importer::ready("LuGre").vr("mu_k");
    let text = make(c"a", good.as_ptr(), &[mu_k]);
    assert!(text.contains(&format!("required intermediate variable {mu_k} does not belong to a continuous")), "{text}");
}

#[test]
fn other_interface_types_are_rejected_with_a_reason() {
    let (name, none) = (c"a".as_ptr(), null_mut());
    let said = std::sync::Mutex::new(Vec::<String>::new());
    let exchange = |token: *const _| {
        let environment = (&raw const said).cast_mut().cast();
        // SAFETY: valid texts.
        unsafe { fmi3InstantiateModelExchange(name, token, null(), 0, 1, environment, Some(record)) }
    };
    assert!(exchange(c"{x}".as_ptr()).is_null());
    let only_steps = stribeck::catalogue::models().filter(|model| !model.model_exchange);
    let count = only_steps.map(|model| assert!(exchange(token(model.name).as_ptr()).is_null())).count();
    // SAFETY: valid texts.
    unsafe {
        let environment = (&raw const said).cast_mut().cast();
        let silent = fmi3InstantiateModelExchange(name, c"{x}".as_ptr(), null(), 0, 0, environment, Some(record));
        assert!(silent.is_null(), "and without loggingOn no word");
        let token = token("LuGre");
        let scheduled = fmi3InstantiateScheduledExecution(
            name,
            token.as_ptr(),
            null(),
            0,
            1,
            environment,
            Some(record),
            None,
            None,
            None,
        );
        assert!(scheduled.is_null());
        fmi3FreeInstance(none);
    }
    let said = said.into_inner().expect("one thread");
    assert_eq!(said.len(), count + 2, "one reason each");
    assert!(said[1].contains("has states that no solver can integrate"), "{}", said[1]);
    assert!(said[count + 1].starts_with("fmi3InstantiateScheduledExecution: no model has partitions"));
}

unsafe extern "C-unwind" fn record(said: *mut std::ffi::c_void, _: fmi3Status, _: fmi3String, text: fmi3String) {
    // SAFETY: the list of the test, and a text of the library.
    unsafe {
        let said = &*said.cast::<std::sync::Mutex<Vec<String>>>();
        said.lock().expect("one thread").push(CStr::from_ptr(text).to_string_lossy().into_owned());
    }
}

#[test]
fn a_model_without_arrays_has_no_configuration_mode() {
    let importer = Importer::with("Coulomb", Purpose::CoSimulation, &Choice::default());
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi3EnterConfigurationMode(importer.instance) }, fmi3Error);
    assert!(importer.one_message().2.contains("Coulomb has no structural parameters"));
}

#[test]
fn co_simulation_has_events_only_if_asked_for() {
    let importer = Importer::ready("LuGre");
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi3EnterEventMode(importer.instance) }, fmi3Error);
    assert!(importer.one_message().2.contains("eventModeUsed was fmi3False"));
}

#[test]
fn messages_can_be_switched_and_are_plain_text() {
    let importer = Importer::in_state("LuGre", Purpose::CoSimulation, &Choice::default(), State::Instantiated);
    assert_eq!(importer.set("mu_k", -1.0), fmi3Discard);
    let (status, category, text) = importer.one_message();
    assert_eq!((status, category.as_str()), (fmi3Discard, "logStatusDiscard"));
    assert_eq!(text, "fmi3SetFloat64: mu_k = -1: must be > 0 and finite");
    let category = c"100% #1".as_ptr();
    // SAFETY: valid texts.
    unsafe {
        assert_eq!(fmi3SetDebugLogging(importer.instance, 1, 1, &category), fmi3Error);
        assert_eq!(importer.one_message().2, "fmi3SetDebugLogging: unknown log category 100% ##1");
        assert_eq!(fmi3SetDebugLogging(importer.instance, 0, 0, null()), fmi3OK);
    }
    assert_eq!(importer.set("mu_k", -1.0), fmi3Error, "after the error");
    assert_eq!(importer.last_message(), "");
}

#[test]
fn experiments_that_make_no_sense_are_rejected() {
    for (tolerance, start, stop) in [(0.0, 0.0, 1.0), (1e-6, f64::NAN, 1.0), (1e-6, 1.0, 0.5), (1e-6, 0.0, f64::NAN)] {
        let importer = Importer::with("LuGre", Purpose::CoSimulation, &Choice::default());
        // SAFETY: an instance of this test.
        let status = unsafe { fmi3EnterInitializationMode(importer.instance, 1, tolerance, start, 1, stop) };
        assert_eq!(status, fmi3Error, "{tolerance} {start} {stop}");
        importer.one_message();
    }
}
