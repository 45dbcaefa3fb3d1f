//! FMI 2.0.

use std::ffi::{CStr, CString, c_void};
use std::ptr::null;

use stribeck::model::{Kind, ModelType};
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Call, Purpose, STATES, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

use crate::version::{Answer, Calls, Ears, Version, hear};

/// FMI 2.0.
pub enum Fmi2 {}

impl From<fmi2Status> for Answer {
    fn from(status: fmi2Status) -> Answer {
        match status {
            fmi2OK => Answer::Ok,
            fmi2Discard => Answer::Discard,
            fmi2Error => Answer::Error,
            _ => panic!("{status:?} is never returned"),
        }
    }
}

/// The logger. Rust cannot define variadic functions, but on the platforms on which this runs a function that names the
/// first variadic argument receives it.
unsafe extern "C" fn listen(
    environment: *mut c_void,
    _name: fmi2String,
    status: fmi2Status,
    category: fmi2String,
    message: fmi2String,
    text: fmi2String,
) {
    assert_ne!(status, fmi2OK);
    // SAFETY: the environment belongs to a live `Slave`; the texts are those of the library.
    unsafe {
        assert_eq!(CStr::from_ptr(message), c"%s", "the message is a format and must be constant");
        let ears = &*environment.cast::<Ears<()>>();
        hear(&ears.messages, status == fmi2Warning, category, text);
    }
}

impl Version for Fmi2 {
    type Call = Call;
    type State = State;
    type Choice = ();
    type Callbacks = ();
    const PREFIX: &'static str = "fmi2";
    const CALLS: Calls<Call> = Calls {
        save: Call::GetFMUstate,
        restore: Call::SetFMUstate,
        free: Call::FreeFMUstate,
        size: Call::SerializedFMUstateSize,
        write: Call::SerializeFMUstate,
        read: Call::DeSerializeFMUstate,
        set_time: Call::SetTime,
        set_states: Call::SetContinuousStates,
        arrays: [
            Call::GetDerivatives,
            Call::GetEventIndicators,
            Call::GetContinuousStates,
            Call::GetNominalsOfContinuousStates,
        ],
        reset: Call::Reset,
    };
    const FAILED: State = State::Error;

    fn state(number: f64) -> State {
        STATES[number as usize]
    }

    fn is_allowed(call: Call, from: State, purpose: Purpose) -> bool {
        call.is_allowed(from) && call.is_for(purpose)
    }

    fn next(call: Call, from: State, (purpose, ()): (Purpose, ())) -> State {
        match (call, purpose) {
            (Call::EnterInitializationMode, _) => State::Initialization,
            (Call::ExitInitializationMode, Purpose::CoSimulation) => State::StepComplete,
            (Call::ExitInitializationMode, Purpose::ModelExchange) | (Call::EnterEventMode, _) => State::EventMode,
            (Call::EnterContinuousTimeMode, _) => State::ContinuousTimeMode,
            (Call::Terminate, _) => State::Terminated,
            (Call::Reset, _) => State::Instantiated,
            _ => from,
        }
    }

    fn can_be(state: State, (purpose, ()): (Purpose, ())) -> bool {
        state.is_for(purpose)
    }

    fn continuous_states(model: &'static ModelType) -> Vec<usize> {
        model.continuous_states().collect()
    }

    fn can_step(state: State) -> bool {
        matches!(state, State::StepComplete | State::ContinuousTimeMode)
    }

    fn make(model: &'static ModelType, purpose: Purpose, (): (), ears: &Ears<()>) -> *mut c_void {
        type Fixed = unsafe extern "C" fn(*mut c_void, fmi2String, fmi2Status, fmi2String, fmi2String, fmi2String);
        // SAFETY: see `listen`.
        let logger = unsafe { std::mem::transmute::<Fixed, fmi2CallbackLogger>(listen) };
        let callbacks = fmi2CallbackFunctions {
            logger,
            allocateMemory: None,
            freeMemory: None,
            stepFinished: None,
            componentEnvironment: ears.environment(),
        };
        let guid = CString::new(model.guid()).expect("no zero byte");
        let kind = match purpose {
            Purpose::ModelExchange => fmi2ModelExchange,
            Purpose::CoSimulation => fmi2CoSimulation,
        };
        // SAFETY: valid texts and callbacks.
        unsafe { fmi2Instantiate(c"fuzz".as_ptr(), kind, guid.as_ptr(), null(), &callbacks, fmi2False, fmi2True) }
    }

    unsafe fn drop(c: *mut c_void) {
        // SAFETY: the caller's promise.
        unsafe { fmi2FreeInstance(c) }
    }

    unsafe fn save(c: *mut c_void, state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2GetFMUstate(c, state) }.into()
    }

    unsafe fn restore(c: *mut c_void, state: *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2SetFMUstate(c, state) }.into()
    }

    unsafe fn free(c: *mut c_void, state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2FreeFMUstate(c, state) }.into()
    }

    unsafe fn size(c: *mut c_void, state: *mut c_void, size: &mut usize) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2SerializedFMUstateSize(c, state, size) }.into()
    }

    unsafe fn write(c: *mut c_void, state: *mut c_void, bytes: &mut [u8]) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2SerializeFMUstate(c, state, bytes.as_mut_ptr().cast(), bytes.len()) }.into()
    }

    unsafe fn read(c: *mut c_void, bytes: &[u8], state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2DeSerializeFMUstate(c, bytes.as_ptr().cast(), bytes.len(), state) }.into()
    }

    unsafe fn set_time(c: *mut c_void, time: f64) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2SetTime(c, time) }.into()
    }

    unsafe fn set_states(c: *mut c_void, values: &[f64]) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2SetContinuousStates(c, values.as_ptr(), values.len()) }.into()
    }

    unsafe fn get_array(c: *mut c_void, which: usize, values: &mut [f64]) -> Answer {
        type Get = unsafe extern "C-unwind" fn(fmi2Component, *mut fmi2Real, usize) -> fmi2Status;
        const FUNCTIONS: [Get; 4] =
            [fmi2GetDerivatives, fmi2GetEventIndicators, fmi2GetContinuousStates, fmi2GetNominalsOfContinuousStates];
        // SAFETY: the caller's promise.
        unsafe { FUNCTIONS[which](c, values.as_mut_ptr(), values.len()) }.into()
    }

    unsafe fn step(c: *mut c_void, _: &Ears<()>, time: f64, length: f64) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi2DoStep(c, time, length, fmi2True) }.into()
    }

    unsafe fn read_all(c: *mut c_void, model: &'static ModelType, _: &[f64]) -> (Answer, Vec<f64>) {
        let reals = model.table.iter().enumerate().filter(|(_, variable)| matches!(variable.kind, Kind::Real(_)));
        let references: Vec<u32> = reals.map(|(column, _)| model.reference(column)).collect();
        let mut values = vec![0.0; references.len()];
        // SAFETY: the caller's promise, and arrays of that length.
        let status = unsafe { fmi2GetReal(c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        (status.into(), values)
    }
}
