//! Saved states: restored, carried to other threads and instances, serialised, and rejected.

use std::ptr::null_mut;
use std::thread;

use crate::common::importer::Importer;
use crate::{drive, millisecond};
use stribeck::catalogue;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;

/// A saved state includes its experiment, and can be overwritten by a later one.
#[test]
fn a_state_holds_the_experiment_and_can_be_overwritten() {
    let importer = Importer::ready("LuGre");
    let mut saved = importer.save();
    assert_eq!(importer.set("velocity", 2e-3), fmi2OK);
    assert_eq!(importer.step(0.0, 0.01), fmi2OK);
    let deflection = importer.get("bristle_deflection");
    // SAFETY: an instance and a state of this test; the state is freed once.
    unsafe {
        assert_eq!(fmi2GetFMUstate(importer.c, &mut saved), fmi2OK);
        assert_eq!(fmi2Reset(importer.c), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2Error, "a reset forgets the experiment");
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.get("bristle_deflection"), deflection);
        assert_eq!(importer.step(0.01, 50.0), fmi2OK);
        assert_eq!(importer.step(50.01, 50.0), fmi2Error, "the stop time 100 s was restored");
        let earlier = Importer::ready("LuGre");
        let mut first = earlier.save();
        let bytes = earlier.bytes(first);
        assert_eq!(fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr(), bytes.len(), &mut saved), fmi2OK);
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.get("bristle_deflection"), 0.0, "read into the existing state");
        assert_eq!(fmi2FreeFMUstate(earlier.c, &mut first), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
    }
}

#[test]
fn an_error_is_left_by_reset_or_by_a_saved_state() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.set("velocity", 1e-3), fmi2OK);
    assert_eq!(importer.step(0.0, 0.01), fmi2OK);
    let force = importer.get("friction_force");
    let mut saved = importer.save();
    assert_eq!(importer.step(0.01, -1.0), fmi2Error);
    assert_eq!(importer.step(0.01, 0.01), fmi2Error);
    assert_eq!(importer.get("friction_force"), force, "values can be read for debugging");
    // SAFETY: a state of this instance, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.step(0.01, 0.01), fmi2OK, "time is part of the state");
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
        assert!(saved.is_null());
        assert_eq!(importer.step(0.5, 0.01), fmi2Error);
        assert_eq!(fmi2Reset(importer.c), fmi2OK);
        assert_eq!(fmi2SetupExperiment(importer.c, fmi2False, 0.0, 7.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(importer.c), fmi2OK);
    }
    assert_eq!((importer.get("velocity"), importer.get("bristle_deflection")), (0.0, 0.0));
    assert_eq!(importer.step(7.0, 200.0), fmi2OK, "the old stop time no longer holds");
}

/// Save, 1000 steps, restore, 1000 steps: the same bits, also through bytes and in another instance.
#[test]
fn a_restored_state_has_the_same_future() {
    for model in catalogue::models() {
        let drive = |importer: &Importer, from| drive(importer, from..from + 1000, 1e-3, millisecond);
        let importer = Importer::ready(model.name);
        drive(&importer, 0);
        let mut saved = importer.save();
        let bytes = importer.bytes(saved);
        let future = drive(&importer, 1000);
        // SAFETY: states of this test, freed once.
        unsafe {
            assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
            assert_eq!(drive(&importer, 1000), future, "{}", model.name);

            let other = Importer::new(model.name);
            let mut read = null_mut();
            assert_eq!(fmi2DeSerializeFMUstate(other.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2OK);
            assert_eq!(fmi2SetFMUstate(other.c, read), fmi2OK, "an instance restores state and lifecycle");
            assert_eq!(drive(&other, 1000), future, "{} in another instance", model.name);
            assert_eq!(fmi2SetFMUstate(other.c, saved), fmi2OK);
            assert_eq!(other.bytes(read), bytes, "equal states give equal bytes");

            let mut garbage = vec![0x55; bytes.len()];
            assert_eq!(fmi2DeSerializeFMUstate(other.c, garbage.as_ptr(), garbage.len(), &mut read), fmi2Error);
            garbage.copy_from_slice(&bytes);
            garbage[60] ^= 1;
            assert_eq!(fmi2DeSerializeFMUstate(other.c, garbage.as_ptr(), garbage.len(), &mut read), fmi2Error);
            assert_eq!(fmi2FreeFMUstate(other.c, &mut read), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
        }
    }
}

/// A state saved by one thread is restored by another, in its own instance, and freed there.
#[test]
fn a_saved_state_continues_in_another_thread() {
    struct Carried(fmi2FMUstate);
    // SAFETY: a saved state belongs to no thread.
    unsafe impl Send for Carried {}
    for model in catalogue::models() {
        let importer = Importer::ready(model.name);
        drive(&importer, 0..100, 1e-3, millisecond);
        let carried = Carried(importer.save());
        let future = drive(&importer, 100..200, 1e-3, millisecond);
        let elsewhere = thread::spawn(move || {
            let Carried(mut saved) = { carried };
            let other = Importer::new(model.name);
            // SAFETY: a state of this library, freed once.
            unsafe {
                assert_eq!(fmi2SetFMUstate(other.c, saved), fmi2OK);
                assert_eq!(fmi2FreeFMUstate(other.c, &mut saved), fmi2OK);
            }
            drive(&other, 100..200, 1e-3, millisecond)
        });
        assert_eq!(elsewhere.join().expect("no panic"), future, "{}", model.name);
    }
}

/// FNV-1a of 64 bits, as in RFC 9923: it ends every serialised state.
pub fn seal(bytes: &mut [u8]) {
    let (body, checksum) = bytes.split_at_mut(bytes.len() - 8);
    let mut hash: u64 = 14_695_981_039_346_656_037;
    for byte in body {
        hash = (hash ^ u64::from(*byte)).wrapping_mul(1_099_511_628_211);
    }
    checksum.copy_from_slice(&hash.to_le_bytes());
}

/// States that are valid, but of another version of the model: the error says so, and nothing changes.
#[test]
fn states_of_other_versions_are_rejected_as_such() {
    let importer = Importer::ready("LuGre");
    let mut state = importer.save();
    let own: Vec<u8> = importer.bytes(state).iter().map(|byte| *byte as u8).collect();
    let (format, guid) = (8, 12..50);
    let changed = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = own.clone();
        change(&mut bytes);
        seal(&mut bytes);
        bytes
    };
    let of_format = |number: u8| changed(&|bytes| bytes[format] = number);
    let of_other_model = |length: usize| {
        changed(&|bytes| {
            bytes[guid.clone()].copy_from_slice(b"{00000000-0000-0000-0000-000000000000}");
            bytes.truncate(length);
        })
    };
    let short = |length: usize| changed(&|bytes| bytes.truncate(length));
    let (other_format, other_model) = ("another format by another version", "another model or another version of it");
    let cases = [
        (own.clone(), None),
        (of_format(0), Some(other_format)),
        (of_format(2), Some(other_format)),
        (of_other_model(own.len()), Some(other_model)),
        // An older one had fewer variables.
        (of_other_model(own.len() - 32), Some(other_model)),
        (short(own.len() - 8), Some("bytes, ")),
        (short(40), Some("not a state of this library")),
    ];
    for (bytes, why) in cases {
        assert_rejected(&importer, state, &bytes, why);
    }
    // SAFETY: freed once.
    unsafe { fmi2FreeFMUstate(importer.c, &mut state) };
}

/// These bytes are rejected for this reason, or accepted if there is none; a state of the instance remains of use.
fn assert_rejected(importer: &Importer, state: fmi2FMUstate, bytes: &[u8], why: Option<&str>) {
    let mut read = null_mut();
    // SAFETY: bytes of this test; states freed once.
    let status = unsafe { fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr().cast(), bytes.len(), &mut read) };
    match why {
        None => assert_eq!(status, fmi2OK),
        Some(why) => {
            assert_eq!(status, fmi2Error, "{why}");
            assert!(read.is_null());
            let text = importer.one_message().2;
            assert!(text.contains("serialised state of LuGre: ") && text.contains(why), "{text}");
            // SAFETY: a state of this instance.
            assert_eq!(unsafe { fmi2SetFMUstate(importer.c, state) }, fmi2OK, "the way out of an error");
        }
    }
    // SAFETY: freed once, or NULL.
    unsafe { fmi2FreeFMUstate(importer.c, &mut read) };
}

/// A solver may overshoot a bound; a state saved there can be read back.
#[test]
fn states_beyond_their_bounds_are_saved_too() {
    let importer = Importer::in_state_of("Gonthier", Purpose::ModelExchange, State::ContinuousTimeMode);
    let model = catalogue::by_name("Gonthier").expect("a model");
    let mut states = importer.states();
    let dwell = model.continuous_states().position(|column| model.table.at(column).path.to_string() == "dwell");
    states[dwell.expect("a state")] = 1.0 + 1e-9;
    // SAFETY: an instance of this test, as many states and bytes as given, states that are freed once.
    unsafe {
        assert_eq!(fmi2SetContinuousStates(importer.c, states.as_ptr(), states.len()), fmi2OK);
        let mut saved = importer.save();
        let bytes = importer.bytes(saved);
        let mut read = null_mut();
        assert_eq!(fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2OK);
        assert_eq!(importer.bytes(read), bytes);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut read), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
    }
}

#[test]
fn a_state_of_another_model_is_rejected() {
    let (lugre, dahl) = (Importer::ready("LuGre"), Importer::ready("Dahl"));
    let mut saved = lugre.save();
    // SAFETY: a live state, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(dahl.c, saved), fmi2Error);
        assert!(dahl.one_message().2.contains("FMUstate belongs to LuGre, not to Dahl"));
        let bytes = lugre.bytes(saved);
        let mut read = null_mut();
        assert_eq!(fmi2DeSerializeFMUstate(dahl.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2Error);
        assert!(read.is_null());
        assert_eq!(fmi2FreeFMUstate(lugre.c, &mut saved), fmi2OK);
    }
}

#[test]
fn states_of_stepping_and_of_integrating_instances_are_not_exchanged() {
    let stepping = Importer::ready("LuGre");
    let integrating = Importer::in_state_of("LuGre", Purpose::ModelExchange, State::ContinuousTimeMode);
    let mut saved = stepping.save();
    // SAFETY: an instance and a state of this test; the state is freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(integrating.c, saved), fmi2Error);
        assert!(integrating.one_message().2.contains("FMUstate is in state StepComplete"));
        assert_eq!(fmi2FreeFMUstate(stepping.c, &mut saved), fmi2OK);
    }
}
