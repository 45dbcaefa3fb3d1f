//! A complete run of every model through both C interfaces: short, so that Miri can check each memory access.

#![allow(non_upper_case_globals, reason = "the names of the standard")]

mod common;

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use common::{NO_CALLBACKS, NO_EVENT};
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role, Variable};
use stribeck_ffi::c::stribeck_status::{STRIBECK_OK, STRIBECK_REFUSED_VALUE, STRIBECK_UNKNOWN_VARIABLE};
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// Value references of the selected Real variables.
fn reals(model: &ModelType, is_wanted: impl Fn(&Variable) -> bool) -> Vec<fmi2ValueReference> {
    let is_real = |variable: &Variable| matches!(variable.kind, Kind::Real(_));
    model
        .variables()
        .filter(|(_, variable)| is_real(variable) && is_wanted(variable))
        .map(|(column, _)| model.reference(column))
        .collect()
}

/// Whether it is an output that may be differentiated. The others are advice.
fn is_output(variable: &Variable) -> bool {
    variable.role.is_output() && !variable.is_advice
}

/// An initialised instance whose inputs have their start values.
///
/// # Safety
/// The instance must be freed.
unsafe fn begin(model: &ModelType, kind: fmi2Type) -> fmi2Component {
    let guid = CString::new(model.guid()).expect("no zero byte");
    let is_input = |variable: &Variable| variable.role == Role::Input;
    let inputs = reals(model, is_input);
    let is_real = |variable: &Variable| is_input(variable) && matches!(variable.kind, Kind::Real(_));
    let starts: Vec<f64> = model.table.iter().filter(is_real).map(|variable| variable.start).collect();
    // SAFETY: valid texts, callbacks and arrays.
    unsafe {
        let name = c"life".as_ptr();
        let c = fmi2Instantiate(name, kind, guid.as_ptr(), null(), &NO_CALLBACKS, fmi2False, fmi2True);
        assert!(!c.is_null(), "{}", model.name);
        assert_eq!(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(c), fmi2OK);
        assert_eq!(fmi2SetReal(c, inputs.as_ptr(), inputs.len(), starts.as_ptr()), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(c), fmi2OK);
        c
    }
}

/// Reads the outputs, and their derivatives with respect to the first input.
///
/// # Safety
/// `c` must be a live instance of the model.
unsafe fn look(model: &ModelType, c: fmi2Component) -> Vec<f64> {
    let (outputs, inputs) = (reals(model, is_output), reals(model, |variable| variable.role == Role::Input));
    let mut values = vec![f64::NAN; 2 * outputs.len()];
    let (found, slopes) = values.split_at_mut(outputs.len());
    let (count, known) = (outputs.len(), inputs.len().min(1));
    // SAFETY: arrays of as many elements as given.
    unsafe {
        assert_eq!(fmi2GetReal(c, outputs.as_ptr(), count, found.as_mut_ptr()), fmi2OK);
        let status =
            fmi2GetDirectionalDerivative(c, outputs.as_ptr(), count, inputs.as_ptr(), known, &1.0, slopes.as_mut_ptr());
        assert_eq!(status, fmi2OK);
    }
    values
}

#[test]
fn steps_and_states_of_co_simulation() {
    for model in catalogue::models() {
        // SAFETY: an instance and states of this test, each freed once; arrays of as many elements as given.
        unsafe {
            let c = begin(model, fmi2CoSimulation);
            assert_eq!(fmi2DoStep(c, 0.0, 1e-3, fmi2True), fmi2OK, "{}", model.name);
            let (mut state, mut copy, mut size) = (null_mut(), null_mut(), 0);
            assert_eq!(fmi2GetFMUstate(c, &mut state), fmi2OK);
            assert_eq!(fmi2SerializedFMUstateSize(c, state, &mut size), fmi2OK);
            let mut bytes = vec![0; size];
            assert_eq!(fmi2SerializeFMUstate(c, state, bytes.as_mut_ptr(), size), fmi2OK);
            for input in reals(model, |variable| variable.role == Role::Input) {
                assert_eq!(fmi2SetRealInputDerivatives(c, &input, 1, &1, &1e-6), fmi2OK);
            }
            assert_eq!(fmi2DoStep(c, 1e-3, 1e-6, fmi2True), fmi2OK, "{}: a ramp", model.name);
            for output in reals(model, is_output) {
                assert_eq!(fmi2GetRealOutputDerivatives(c, &output, 1, &1, &mut 0.0), fmi2OK);
            }
            let seen = look(model, c);
            assert_eq!(fmi2DoStep(c, f64::NAN, 1e-3, fmi2True), fmi2Error);
            assert_eq!(fmi2DeSerializeFMUstate(c, bytes.as_ptr(), size, &mut copy), fmi2OK);
            assert_eq!(fmi2SetFMUstate(c, copy), fmi2OK);
            assert_eq!(fmi2GetFMUstate(c, &mut state), fmi2OK, "overwritten");
            for input in reals(model, |variable| variable.role == Role::Input) {
                assert_eq!(fmi2SetRealInputDerivatives(c, &input, 1, &1, &1e-6), fmi2OK);
            }
            assert_eq!(fmi2DoStep(c, 1e-3, 1e-6, fmi2True), fmi2OK);
            assert_eq!(look(model, c), seen, "{}", model.name);
            assert_eq!(fmi2FreeFMUstate(c, &mut state), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(c, &mut copy), fmi2OK);
            assert_eq!(fmi2Terminate(c), fmi2OK);
            assert_eq!(fmi2Reset(c), fmi2OK);
            fmi2FreeInstance(c);
        }
    }
}

#[test]
fn events_and_rates_of_model_exchange() {
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let states = model.continuous_states().count();
        let (mut x, mut rates, mut indicators) =
            (vec![0.0; states], vec![0.0; states], vec![0.0; model.event_indicators]);
        let (mut enters, mut ends) = (fmi2False, fmi2False);
        let mut event = NO_EVENT;
        // SAFETY: an instance of this test, freed once; arrays of as many elements as given.
        unsafe {
            let c = begin(model, fmi2ModelExchange);
            assert_eq!(fmi2NewDiscreteStates(c, &mut event), fmi2OK);
            assert_eq!(fmi2EnterContinuousTimeMode(c), fmi2OK);
            assert_eq!(fmi2GetNominalsOfContinuousStates(c, x.as_mut_ptr(), states), fmi2OK);
            assert!(x.iter().all(|nominal| *nominal > 0.0), "{}", model.name);
            assert_eq!(fmi2GetContinuousStates(c, x.as_mut_ptr(), states), fmi2OK);
            assert_eq!(fmi2SetTime(c, 1e-3), fmi2OK);
            assert_eq!(fmi2SetContinuousStates(c, x.as_ptr(), states), fmi2OK);
            assert_eq!(fmi2GetDerivatives(c, rates.as_mut_ptr(), states), fmi2OK, "{}", model.name);
            assert_eq!(fmi2GetEventIndicators(c, indicators.as_mut_ptr(), indicators.len()), fmi2OK);
            assert!(rates.iter().chain(&indicators).all(|value| value.is_finite()), "{}", model.name);
            assert_eq!(fmi2CompletedIntegratorStep(c, fmi2True, &mut enters, &mut ends), fmi2OK);
            look(model, c);
            assert_eq!(fmi2EnterEventMode(c), fmi2OK);
            fmi2FreeInstance(c);
        }
    }
}

#[test]
fn handles_of_the_c_interface() {
    for model in catalogue::models() {
        let name = CString::new(model.name).expect("no zero byte");
        let mut handle = null_mut();
        // SAFETY: a handle of this test, freed once; terminated texts, and a buffer of the given size.
        unsafe {
            assert_eq!(stribeck_create(name.as_ptr(), &mut handle), STRIBECK_OK);
            let mut variable = std::mem::zeroed();
            let (mut last, mut found, mut value) = (u32::MAX, u32::MAX, f64::NAN);
            assert_eq!(stribeck_reference(handle, stribeck_variable_count(handle) - 1, &mut last), STRIBECK_OK);
            assert_eq!(stribeck_describe(handle, last, &mut variable), STRIBECK_OK);
            assert_eq!(stribeck_find(handle, variable.name, &mut found), STRIBECK_OK);
            assert_eq!((found, stribeck_get(handle, found, &mut value)), (last, STRIBECK_OK));
            let mut bytes = vec![0u8; stribeck_state_size(handle)];
            assert_eq!(stribeck_save(handle, bytes.as_mut_ptr().cast(), bytes.len()), STRIBECK_OK);
            assert_eq!(stribeck_step(handle, 1e-3), STRIBECK_OK, "{}", model.name);
            assert_eq!(stribeck_step(handle, -1.0), STRIBECK_REFUSED_VALUE);
            assert!(CStr::from_ptr(stribeck_last_error(handle)).to_string_lossy().contains("dt = -1"));
            let mut value = 0.0;
            assert_eq!(stribeck_get_by_name(handle, c"\xff".as_ptr(), &mut value), STRIBECK_UNKNOWN_VARIABLE);
            assert!(CStr::from_ptr(stribeck_last_error(handle)).to_string_lossy().contains("not UTF-8"));
            let input = reals(model, |variable| variable.role != Role::Output)[0];
            // A few are enough: each computes all outputs, which is slow under Miri.
            for output in reals(model, is_output).into_iter().take(3) {
                assert_eq!(stribeck_derivative(handle, output, input, &mut 0.0), STRIBECK_OK);
            }
            assert_eq!(stribeck_restore(handle, bytes.as_ptr().cast(), bytes.len()), STRIBECK_OK);
            assert_eq!(stribeck_time(handle), 0.0);
            assert_eq!(stribeck_reset(handle), STRIBECK_OK);
            stribeck_free(handle);
        }
    }
}
