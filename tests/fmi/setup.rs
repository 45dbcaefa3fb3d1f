//! Instances, their callbacks and messages, and experiments.

use std::ffi::CStr;
use std::ptr::{null, null_mut};

use crate::common::importer::{Heard, Importer, NAME, callbacks, guid};
use stribeck_ffi::fmi2::lifecycle::State;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;

#[test]
fn instantiation_rejects_what_it_cannot_serve() {
    let heard = Heard::default();
    let callbacks = callbacks(&heard);
    let (guid, bristle) = (guid("LuGre"), guid("Bristle"));
    let make = |name: fmi2String, kind, guid: fmi2String, callbacks: *const fmi2CallbackFunctions| {
        // SAFETY: valid texts and callbacks, or NULL.
        unsafe { fmi2Instantiate(name, kind, guid, null(), callbacks, fmi2False, fmi2False) }
    };
    let name = c"a".as_ptr();
    for (what, name, kind, guid) in [
        ("guid", name, fmi2CoSimulation, c"{00000000-0000-0000-0000-000000000000}".as_ptr()),
        ("fmuGUID is NULL", name, fmi2CoSimulation, null()),
        ("instanceName is NULL or blank", null(), fmi2CoSimulation, guid.as_ptr()),
        ("instanceName is NULL or blank", c" \t".as_ptr(), fmi2CoSimulation, guid.as_ptr()),
        ("fmuType is 0: Bristle has states that no solver", name, fmi2ModelExchange, bristle.as_ptr()),
        ("fmuType is 2: must be 0 (Model Exchange) or 1", name, 2, guid.as_ptr()),
    ] {
        let c = make(name, kind, guid, &callbacks);
        assert!(c.is_null(), "{what}");
        let (status, category, text) = heard.lock().expect("one thread").pop().expect("a message");
        assert_eq!((status, &*category), (fmi2Error, "logStatusError"));
        assert!(text.contains(what), "{text}");
    }
    assert!(make(name, fmi2CoSimulation, guid.as_ptr(), null()).is_null());
    // SAFETY: NULL is ignored.
    unsafe { fmi2FreeInstance(null_mut()) };
}

/// Texts of the importer are only valid during the call.
#[test]
fn the_name_of_an_instance_is_copied() {
    let heard = Heard::default();
    let callbacks = callbacks(&heard);
    let mut name = *b"first\0";
    // SAFETY: valid texts and callbacks; the instance is freed once.
    unsafe {
        let guid = guid("LuGre");
        let c = fmi2Instantiate(name.as_ptr().cast(), 1, guid.as_ptr(), null(), &callbacks, fmi2False, fmi2True);
        name.copy_from_slice(b"other\0");
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(NAME.take(), "first");
        fmi2FreeInstance(c);
    }
}

/// The struct of callbacks is only valid during fmi2Instantiate, and all its pointers may be NULL.
#[test]
fn callbacks_are_copied_and_optional() {
    let heard = Heard::default();
    let mut callbacks = callbacks(&heard);
    // SAFETY: valid texts and callbacks; the instance is freed once.
    unsafe {
        let name = c"a".as_ptr();
        let make = |callbacks: *const fmi2CallbackFunctions| {
            fmi2Instantiate(name, fmi2CoSimulation, guid("Dahl").as_ptr(), null(), callbacks, fmi2False, fmi2True)
        };
        let c = make(&callbacks);
        callbacks.logger = None;
        callbacks.componentEnvironment = null_mut();
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(heard.lock().expect("one thread").len(), 1);
        fmi2FreeInstance(c);
        let silent = make(&callbacks);
        assert_eq!(fmi2Terminate(silent), fmi2Error);
        fmi2FreeInstance(silent);
    }
}

#[test]
fn experiments_that_make_no_sense_are_rejected() {
    let cases = [
        (fmi2False, 0.0, 1.0, fmi2True, 0.5, "stopTime = 0.5: must be finite and >= startTime = 1"),
        (fmi2False, 0.0, f64::NAN, fmi2False, 0.0, "startTime = NaN"),
        (fmi2False, 0.0, 0.0, fmi2True, f64::INFINITY, "stopTime = inf"),
        (fmi2True, 0.0, 0.0, fmi2False, 0.0, "tolerance = 0"),
        (fmi2True, f64::NAN, 0.0, fmi2False, 0.0, "tolerance = NaN"),
        (fmi2True, f64::INFINITY, 0.0, fmi2False, 0.0, "tolerance = inf"),
    ];
    for (has_tolerance, tolerance, start, has_stop, stop, why) in cases {
        let importer = Importer::new("LuGre");
        // SAFETY: an instance of this test.
        let status = unsafe { fmi2SetupExperiment(importer.c, has_tolerance, tolerance, start, has_stop, stop) };
        assert_eq!(status, fmi2Error, "{why}");
        assert!(importer.one_message().2.contains(why));
    }
    let importer = Importer::new("LuGre");
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2EnterInitializationMode(importer.c) }, fmi2Error);
    assert!(importer.one_message().2.contains("fmi2SetupExperiment must be called first"));
}

#[test]
fn messages_can_be_switched_by_category_and_keep_percent_signs() {
    let importer = Importer::ready("LuGre");
    let switch = |category: &CStr, on| {
        // SAFETY: one category.
        assert_eq!(unsafe { fmi2SetDebugLogging(importer.c, on, 1, &category.as_ptr()) }, fmi2OK);
    };
    switch(c"logStatusDiscard", fmi2False);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    assert!(importer.heard.lock().expect("one thread").is_empty());
    switch(c"logAll", fmi2True);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    importer.one_message();
    switch(c"logStatusError", fmi2False);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    importer.one_message();
    let silent = Importer::in_state("LuGre", State::StepComplete);
    // SAFETY: one category.
    assert_eq!(unsafe { fmi2SetDebugLogging(silent.c, fmi2False, 1, &c"logStatusError".as_ptr()) }, fmi2OK);
    assert_eq!(silent.step(0.0, -1.0), fmi2Error);
    assert!(silent.heard.lock().expect("one thread").is_empty());
    switch(c"logStatusError", fmi2True);
    // SAFETY: one category.
    assert_eq!(unsafe { fmi2SetDebugLogging(importer.c, fmi2True, 1, &c"100%s#".as_ptr()) }, fmi2Error);
    assert!(importer.one_message().2.contains("unknown log category 100%s##"));
}
