//! Tests that need the probe: panics, results that are not finite, arrays in parts. The rest is tested from outside in
//! `tests/fmi`.

use std::ffi::CString;
use std::ptr::{null, null_mut};

use super::lifecycle::{ALLOWED, Call, STATES, State, functions};
use super::setup::*;
use super::snapshot::*;
use super::step::*;
use super::types::fmi3Status::*;
use super::types::*;
use super::values::*;
use crate::models;

/// An instance of the probe, ready to step.
fn probe(event_mode: fmi3Boolean) -> fmi3Instance {
    let token = CString::new(models::by_name("Probe").expect("the probe").guid()).expect("no zero byte");
    // SAFETY: valid texts; the instance is used by one test only.
    unsafe {
        let (name, token, none) = (c"probe".as_ptr(), token.as_ptr(), null_mut());
        let c = fmi3InstantiateCoSimulation(name, token, null(), 0, 0, event_mode, 0, null(), 0, none, None, None);
        assert!(!c.is_null());
        assert_eq!(fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0), fmi3OK);
        assert_eq!(fmi3ExitInitializationMode(c), fmi3OK);
        if event_mode == fmi3True {
            assert_eq!(fmi3EnterStepMode(c), fmi3OK);
        }
        c
    }
}

fn reference(name: &str) -> fmi3ValueReference {
    let probe = models::by_name("Probe").expect("a model");
    probe.reference(probe.find(name).expect(name))
}

fn step(c: fmi3Instance, t: f64) -> fmi3Status {
    let ([mut event, mut end, mut early], mut time) = ([9; 3], f64::NAN);
    // SAFETY: an instance of this test, places for all answers.
    unsafe { fmi3DoStep(c, t, 0.5, fmi3True, &mut event, &mut end, &mut early, &mut time) }
}

fn behave(c: fmi3Instance, behaviour: i64) -> fmi3Status {
    // SAFETY: one reference, one value.
    unsafe { fmi3SetInt64(c, &reference("behaviour"), 1, &behaviour, 1) }
}

fn doubled(c: fmi3Instance) -> f64 {
    let mut value = f64::NAN;
    // SAFETY: one reference, one value.
    assert_eq!(unsafe { fmi3GetFloat64(c, &reference("doubled"), 1, &mut value, 1) }, fmi3OK);
    value
}

/// Nothing has changed, the host lives, and a reset helps; with trials of steps too.
#[test]
fn a_panic_or_an_overflow_in_a_step_is_an_error() {
    for event_mode in [fmi3False, fmi3True] {
        for behaviour in [2, 3] {
            let c = probe(event_mode);
            // SAFETY: an instance of this test, one value each.
            unsafe {
                assert_eq!(fmi3SetFloat64(c, &reference("rate"), 1, &4.0, 1), fmi3OK);
                assert_eq!(step(c, 0.0), fmi3OK);
                assert_eq!(behave(c, behaviour), fmi3OK);
                assert_eq!(step(c, 0.5), fmi3Error);
                assert_eq!(doubled(c), 4.0);
                assert_eq!(step(c, 0.5), fmi3Error, "after an error");
                assert_eq!(fmi3Reset(c), fmi3OK);
                fmi3FreeInstance(c);
            }
        }
    }
}

#[test]
fn integers_enumerations_and_booleans_have_their_own_functions_and_bounds() {
    let c = probe(fmi3False);
    for (value, status) in [(1, fmi3OK), (0, fmi3Discard), (4, fmi3Discard), (i64::MIN, fmi3Discard)] {
        assert_eq!(behave(c, value), status, "{value}");
    }
    // SAFETY: one reference, one value in each call.
    unsafe {
        for (value, status) in [(0, fmi3OK), (9, fmi3OK), (10, fmi3Discard), (-1, fmi3Discard)] {
            assert_eq!(fmi3SetInt32(c, &reference("count"), 1, &value, 1), status, "{value}");
        }
        for (value, status) in [(0, fmi3OK), (1, fmi3OK), (2, fmi3Discard), (255, fmi3Discard)] {
            assert_eq!(fmi3SetBoolean(c, &reference("enabled"), 1, &value, 1), status, "{value}");
        }
        let mut count = 7;
        assert_eq!(fmi3GetInt32(c, &reference("count"), 1, &mut count, 1), fmi3OK);
        assert_eq!(count, 9, "what is refused changes nothing");
        assert_eq!(fmi3GetInt32(c, &reference("behaviour"), 1, &mut count, 1), fmi3Error, "an enumeration is an Int64");
        fmi3FreeInstance(c);
    }
}

/// An array of parts has its elements in the order of their indices, and counts by them.
#[test]
fn an_array_is_one_variable() {
    let c = probe(fmi3False);
    let model = models::by_name("Probe").expect("a model");
    let arrays = stribeck::arrays::of(model).expect("memory");
    let stiffness = arrays.iter().find(|array| array.path.to_string() == "element.stiffness").expect("an array");
    let mut values = [f64::NAN; 3];
    // SAFETY: an instance of this test, arrays of the lengths given, a state freed once.
    unsafe {
        let reference = stiffness.reference();
        assert_eq!(fmi3GetFloat64(c, &reference, 1, values.as_mut_ptr(), 3), fmi3OK);
        assert_eq!(values, [5.0, 2.0, 2.0]);
        let mut state = null_mut();
        assert_eq!(fmi3GetFMUState(c, &mut state), fmi3OK);
        assert_eq!(fmi3SetFloat64(c, &reference, 1, [1.0, 7.0, 8.0].as_ptr(), 3), fmi3OK);
        assert_eq!(fmi3GetFloat64(c, &reference, 1, values.as_mut_ptr(), 3), fmi3OK);
        assert_eq!(values, [1.0, 7.0, 8.0]);
        assert_eq!(fmi3SetFloat64(c, &reference, 1, [1.0, -7.0, 8.0].as_ptr(), 3), fmi3Discard, "all or none");
        assert_eq!(fmi3SetFMUState(c, state), fmi3OK);
        assert_eq!(fmi3FreeFMUState(c, &mut state), fmi3OK);
        assert_eq!(fmi3GetFloat64(c, &reference, 1, values.as_mut_ptr(), 3), fmi3OK);
        assert_eq!(values, [5.0, 2.0, 2.0]);
        assert_eq!(fmi3GetFloat64(c, &reference, 1, values.as_mut_ptr(), 2), fmi3Error);
        fmi3FreeInstance(c);
    }
}

/// An instance that its importer reads within a step.
struct Visited {
    instance: fmi3Instance,
    seen: Vec<(f64, f64)>,
    end: Option<f64>,
}

unsafe extern "C-unwind" fn visit(
    environment: fmi3InstanceEnvironment,
    time: f64,
    _: fmi3Boolean,
    _: fmi3Boolean,
    _: fmi3Boolean,
    early: fmi3Boolean,
    requested: *mut fmi3Boolean,
    end: *mut f64,
) {
    // SAFETY: the environment is the `Visited` of the test, which nothing else uses meanwhile.
    unsafe {
        let visited = &mut *environment.cast::<Visited>();
        visited.seen.push((time, doubled(visited.instance)));
        if let Some(asked) = visited.end.filter(|_| early == fmi3True) {
            (*requested, *end) = (fmi3True, asked);
        }
    }
}

/// The integral of 4 over four parts of a step of 0.5 s, doubled; also one that the importer ends.
#[test]
fn an_importer_reads_within_a_step() {
    for (end, expected) in [(None, 0.5), (Some(0.3), 0.3)] {
        let mut visited = Visited { instance: null_mut(), seen: Vec::new(), end };
        let place = &raw mut visited;
        let token = CString::new(models::by_name("Probe").expect("the probe").guid()).expect("no zero byte");
        let ([mut event, mut stop, mut early], mut time) = ([9; 3], f64::NAN);
        let doubled = reference("doubled");
        // SAFETY: an instance of this test, used by its own callback while nothing else uses it.
        unsafe {
            let (name, token, update) = (c"probe".as_ptr(), token.as_ptr(), Some(visit as _));
            let c =
                fmi3InstantiateCoSimulation(name, token, null(), 0, 0, 0, 1, &doubled, 1, place.cast(), None, update);
            (*place).instance = c;
            assert_eq!(fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0), fmi3OK);
            assert_eq!(fmi3ExitInitializationMode(c), fmi3OK);
            assert_eq!(fmi3SetFloat64(c, &reference("rate"), 1, &4.0, 1), fmi3OK);
            assert_eq!(fmi3DoStep(c, 0.0, 0.5, 1, &mut event, &mut stop, &mut early, &mut time), fmi3OK);
            assert_eq!((event, stop, early, time), (0, 0, fmi3Boolean::from(end.is_some()), expected));
            fmi3FreeInstance(c);
            let times: Vec<f64> = (*place).seen.iter().map(|(time, _)| *time).collect();
            let all = [0.125, 0.25, 0.375, 0.5];
            assert_eq!(times, if end.is_some() { vec![0.125, 0.3] } else { all.to_vec() });
            assert!((*place).seen.iter().all(|(time, doubled)| (doubled - 8.0 * time).abs() < 1e-15));
        }
    }
}

#[test]
fn every_state_has_a_way_out() {
    for state in STATES.into_iter().filter(|state| *state != State::IntermediateUpdateMode) {
        assert!(Call::Reset.is_allowed(state) && Call::SetFMUState.is_allowed(state), "{state:?}");
    }
    assert_eq!(functions().count(), ALLOWED.len() + 5);
}
