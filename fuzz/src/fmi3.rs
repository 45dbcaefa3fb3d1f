//! FMI 3.0.

use std::cell::Cell;
use std::collections::HashMap;
use std::ffi::{CString, c_void};
use std::ptr::{null, null_mut};
use std::sync::OnceLock;

use arbitrary::Arbitrary;
use stribeck::arrays::{self, Array};
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role};
use stribeck::reference;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::{Call, Purpose, STATES, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::values::*;

use crate::argument::{Column, Number, column};
use crate::slave::all_finite;
use crate::version::{Answer, Calls, Ears, Version, hear};

/// FMI 3.0.
pub enum Fmi3 {}

/// Abilities of an importer in co-simulation.
#[derive(Arbitrary, Clone, Copy, Debug, Default)]
pub struct Abilities {
    /// It handles events.
    pub event_mode: bool,
    /// It handles steps that end early.
    pub early_return: bool,
    /// It has a callback within steps.
    pub callback: bool,
}

/// Action of the importer within a step.
#[derive(Arbitrary, Clone, Copy, Debug, Default)]
pub enum Within {
    /// Nothing.
    #[default]
    Nothing,
    /// It reads an output.
    Read,
    /// It reads another variable.
    ReadOther(Column),
    /// It makes a call that is not allowed there.
    Misuse(u8),
    /// It wants the step to end.
    End(Number),
}

/// The callback within a step, and what it needs.
pub struct Callback {
    instance: Cell<fmi3Instance>,
    model: Cell<Option<&'static ModelType>>,
    /// Its action.
    pub within: Cell<Within>,
    /// How often it was called.
    pub visits: Cell<u32>,
}

impl Default for Callback {
    fn default() -> Callback {
        let (instance, model) = (Cell::new(null_mut()), Cell::default());
        Callback { instance, model, within: Cell::default(), visits: Cell::default() }
    }
}

impl From<fmi3Status> for Answer {
    fn from(status: fmi3Status) -> Answer {
        match status {
            fmi3OK => Answer::Ok,
            fmi3Discard => Answer::Discard,
            fmi3Error => Answer::Error,
            _ => panic!("{status:?} is never returned"),
        }
    }
}

unsafe extern "C-unwind" fn listen(
    environment: fmi3InstanceEnvironment,
    status: fmi3Status,
    category: fmi3String,
    message: fmi3String,
) {
    assert_ne!(status, fmi3OK);
    // SAFETY: the environment belongs to a live `Slave`; the texts are those of the library.
    unsafe {
        let ears = &*environment.cast::<Ears<Callback>>();
        hear(&ears.messages, status == fmi3Warning, category, message);
    }
}

unsafe extern "C-unwind" fn visit(
    environment: fmi3InstanceEnvironment,
    time: fmi3Float64,
    set: fmi3Boolean,
    get: fmi3Boolean,
    finished: fmi3Boolean,
    can_return: fmi3Boolean,
    requested: *mut fmi3Boolean,
    end: *mut fmi3Float64,
) {
    assert!(time.is_finite() && (set, get, finished) == (fmi3False, fmi3True, fmi3True));
    // SAFETY: the environment belongs to a live `Slave`, the pointers are those of the library.
    unsafe {
        let callback = &(*environment.cast::<Ears<Callback>>()).callbacks;
        callback.visits.set(callback.visits.get() + 1);
        let (c, model) = (callback.instance.get(), callback.model.get().expect("a model"));
        match callback.within.get() {
            Within::Nothing => {}
            Within::Read => assert_eq!(required(model).map(|known| read(c, known)), required(model).map(|_| fmi3OK)),
            Within::ReadOther(other) => _ = read(c, other.of(model)),
            Within::Misuse(which) => assert_eq!(misuse(c, which), fmi3Error),
            // Whether the step may end at that time, the library checks.
            Within::End(_) if can_return == fmi3False => {}
            Within::End(number) => (*requested, *end) = (fmi3True, number.alone()),
        }
    }
}

/// Reads a real variable.
unsafe fn read(c: fmi3Instance, reference: u32) -> fmi3Status {
    let mut value = f64::NAN;
    // SAFETY: the caller promises a live instance; room for one value.
    let status = unsafe { fmi3GetFloat64(c, &reference, 1, &mut value, 1) };
    assert!(status != fmi3OK || value.is_finite());
    status
}

/// Calls that are not allowed within a step.
unsafe fn misuse(c: fmi3Instance, which: u8) -> fmi3Status {
    let mut state = null_mut();
    // SAFETY: the caller promises a live instance; the other arguments are valid.
    unsafe {
        match which % 4 {
            0 => fmi3Reset(c),
            1 => fmi3Terminate(c),
            2 => fmi3GetFMUState(c, &mut state),
            _ => fmi3SetFloat64(c, null(), 0, null(), 0),
        }
    }
}

/// The output that the importer reads within steps.
fn required(model: &'static ModelType) -> Option<u32> {
    let is_required = |column: &usize| {
        let variable = model.table.at(*column);
        let is_real = matches!(variable.kind, Kind::Real(_)) && variable.path.without_index().is_none();
        is_real && variable.role.is_output() && !variable.jumps && !variable.is_advice
    };
    (0..model.table.len()).find(is_required).map(|column| model.reference(column))
}

/// Whether it is the reference of a continuous input or output.
pub fn is_port(model: &'static ModelType, reference: u32) -> bool {
    let array = arrays_of(model).iter().find(|array| array.reference() == reference).map(|array| array.columns[0]);
    let plain = column(model, reference).filter(|column| model.table.at(*column).path.without_index().is_none());
    array.or(plain).is_some_and(|column| {
        let variable = model.table.at(column);
        (variable.role == Role::Input || variable.role.is_output()) && !variable.jumps
    })
}

/// The arrays of a model. They are found once: that takes longer than most calls.
pub fn arrays_of(model: &'static ModelType) -> &'static [Array] {
    static FOUND: OnceLock<HashMap<&str, Box<[Array]>>> = OnceLock::new();
    let of = |model: &'static ModelType| (model.name, arrays::of(model).expect("memory"));
    &FOUND.get_or_init(|| catalogue::models().map(of).collect())[model.name]
}

/// The sizes of arrays that an importer can choose, in the order of their numbers in a saved state.
pub fn sizes_of(model: &'static ModelType) -> Vec<arrays::Size> {
    let mut sizes: Vec<arrays::Size> = Vec::new();
    for size in arrays_of(model).iter().filter_map(|array| array.size) {
        if !sizes.contains(&size) {
            sizes.push(size);
        }
    }
    sizes
}

/// Columns of a variable: one, or those of the elements of an array. None if there is no such variable.
pub fn columns(model: &'static ModelType, numbers: &[f64], reference: u32) -> Option<Vec<usize>> {
    if let Some(array) = arrays_of(model).iter().find(|array| array.reference() == reference) {
        let count = array.size.map_or(array.columns.len(), |size| size_in(model, numbers, size));
        return Some(array.columns[..count].to_vec());
    }
    let found = column(model, reference)?;
    model.table.at(found).path.without_index().is_none().then(|| vec![found])
}

/// The present size of an array, from the end of a saved state.
fn size_in(model: &'static ModelType, numbers: &[f64], wanted: arrays::Size) -> usize {
    let sizes = sizes_of(model);
    let place = sizes.iter().position(|size| *size == wanted).expect("a size");
    numbers[numbers.len() - sizes.len() + place] as usize
}

/// Number of values of a variable, whether it exists or not.
pub fn count(model: &'static ModelType, numbers: &[f64], reference: u32) -> usize {
    if reference == reference::EVENT_INDICATORS {
        return model.event_indicators;
    }
    let arrays = arrays_of(model);
    if let Some(array) = arrays.iter().find(|array| array.derivative_reference() == reference) {
        return array.columns.len();
    }
    columns(model, numbers, reference).map_or(1, |columns| columns.len())
}

impl Version for Fmi3 {
    type Call = Call;
    type State = State;
    type Choice = Abilities;
    type Callbacks = Callback;
    const PREFIX: &'static str = "fmi3";
    const CALLS: Calls<Call> = Calls {
        save: Call::GetFMUState,
        restore: Call::SetFMUState,
        free: Call::FreeFMUState,
        size: Call::SerializedFMUStateSize,
        write: Call::SerializeFMUState,
        read: Call::DeserializeFMUState,
        set_time: Call::SetTime,
        set_states: Call::SetContinuousStates,
        arrays: [
            Call::GetContinuousStateDerivatives,
            Call::GetEventIndicators,
            Call::GetContinuousStates,
            Call::GetNominalsOfContinuousStates,
        ],
        reset: Call::Reset,
    };
    const FAILED: State = State::Error;

    fn state(number: f64) -> State {
        // Those of FMI 2.0 have smaller numbers.
        STATES[number as usize - 16]
    }

    fn is_allowed(call: Call, from: State, purpose: Purpose) -> bool {
        call.is_allowed(from) && call.is_for(purpose)
    }

    fn next(call: Call, from: State, (purpose, abilities): (Purpose, Abilities)) -> State {
        match call {
            Call::EnterConfigurationMode => State::ConfigurationMode,
            Call::EnterInitializationMode => State::InitializationMode,
            Call::ExitInitializationMode if purpose == Purpose::ModelExchange || abilities.event_mode => {
                State::EventMode
            }
            Call::ExitInitializationMode | Call::EnterStepMode => State::StepMode,
            Call::EnterEventMode => State::EventMode,
            Call::EnterContinuousTimeMode => State::ContinuousTimeMode,
            Call::Terminate => State::Terminated,
            Call::Reset | Call::ExitConfigurationMode => State::Instantiated,
            _ => from,
        }
    }

    fn can_be(state: State, (purpose, abilities): (Purpose, Abilities)) -> bool {
        let has_events = purpose == Purpose::ModelExchange || abilities.event_mode;
        state.is_for(purpose) && state != State::IntermediateUpdateMode && (has_events || state != State::EventMode)
    }

    fn continuous_states(model: &'static ModelType) -> Vec<usize> {
        let arrays = arrays_of(model);
        let place = |column: usize| {
            let owner = arrays.iter().find(|array| array.columns.contains(&column));
            let index = owner.and_then(|array| array.columns.iter().position(|element| *element == column));
            (owner.map_or(column, |array| array.columns[0]), index)
        };
        let mut columns: Vec<usize> = model.continuous_states().collect();
        columns.sort_by_key(|column| place(*column));
        columns
    }

    fn can_step(state: State) -> bool {
        matches!(state, State::StepMode | State::ContinuousTimeMode)
    }

    fn make(model: &'static ModelType, purpose: Purpose, choice: Abilities, ears: &Ears<Callback>) -> *mut c_void {
        let token = CString::new(model.guid()).expect("no zero byte");
        let (name, token, environment) = (c"fuzz".as_ptr(), token.as_ptr(), ears.environment());
        let [event, early] = [choice.event_mode, choice.early_return].map(fmi3Boolean::from);
        let update: fmi3IntermediateUpdateCallback = if choice.callback { Some(visit) } else { None };
        let known: Vec<u32> = required(model).into_iter().collect();
        let (at, n) = (known.as_ptr(), known.len());
        // SAFETY: valid texts and callbacks, an array of that length.
        let c = unsafe {
            match purpose {
                Purpose::ModelExchange => {
                    fmi3InstantiateModelExchange(name, token, null(), 0, 1, environment, Some(listen))
                }
                Purpose::CoSimulation => {
                    let log = Some(listen as _);
                    fmi3InstantiateCoSimulation(
                        name,
                        token,
                        null(),
                        0,
                        1,
                        event,
                        early,
                        at,
                        n,
                        environment,
                        log,
                        update,
                    )
                }
            }
        };
        ears.callbacks.instance.set(c);
        ears.callbacks.model.set(Some(model));
        c
    }

    unsafe fn drop(c: *mut c_void) {
        // SAFETY: the caller's promise.
        unsafe { fmi3FreeInstance(c) }
    }

    unsafe fn save(c: *mut c_void, state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3GetFMUState(c, state) }.into()
    }

    unsafe fn restore(c: *mut c_void, state: *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3SetFMUState(c, state) }.into()
    }

    unsafe fn free(c: *mut c_void, state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3FreeFMUState(c, state) }.into()
    }

    unsafe fn size(c: *mut c_void, state: *mut c_void, size: &mut usize) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3SerializedFMUStateSize(c, state, size) }.into()
    }

    unsafe fn write(c: *mut c_void, state: *mut c_void, bytes: &mut [u8]) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3SerializeFMUState(c, state, bytes.as_mut_ptr(), bytes.len()) }.into()
    }

    unsafe fn read(c: *mut c_void, bytes: &[u8], state: &mut *mut c_void) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3DeserializeFMUState(c, bytes.as_ptr(), bytes.len(), state) }.into()
    }

    unsafe fn set_time(c: *mut c_void, time: f64) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3SetTime(c, time) }.into()
    }

    unsafe fn set_states(c: *mut c_void, values: &[f64]) -> Answer {
        // SAFETY: the caller's promise.
        unsafe { fmi3SetContinuousStates(c, values.as_ptr(), values.len()) }.into()
    }

    unsafe fn get_array(c: *mut c_void, which: usize, values: &mut [f64]) -> Answer {
        type Get = unsafe extern "C-unwind" fn(fmi3Instance, *mut fmi3Float64, usize) -> fmi3Status;
        const FUNCTIONS: [Get; 4] = [
            fmi3GetContinuousStateDerivatives,
            fmi3GetEventIndicators,
            fmi3GetContinuousStates,
            fmi3GetNominalsOfContinuousStates,
        ];
        // SAFETY: the caller's promise.
        unsafe { FUNCTIONS[which](c, values.as_mut_ptr(), values.len()) }.into()
    }

    unsafe fn step(c: *mut c_void, ears: &Ears<Callback>, time: f64, length: f64) -> Answer {
        ears.callbacks.within.set(Within::Nothing);
        let ([mut event, mut end, mut early], mut reached) = ([9; 3], f64::NAN);
        // SAFETY: the caller's promise, and places for the answers.
        unsafe { fmi3DoStep(c, time, length, fmi3True, &mut event, &mut end, &mut early, &mut reached) }.into()
    }

    unsafe fn read_all(c: *mut c_void, model: &'static ModelType, numbers: &[f64]) -> (Answer, Vec<f64>) {
        let is_real = |column: &usize| matches!(model.table.at(*column).kind, Kind::Real(_));
        let plain = (0..model.table.len()).filter(|column| model.table.at(*column).path.without_index().is_none());
        let mut references: Vec<u32> = plain.filter(is_real).map(|column| model.reference(column)).collect();
        let arrays = arrays_of(model);
        references.extend(arrays.iter().filter(|array| is_real(&array.columns[0])).map(Array::reference));
        let count = references.iter().map(|reference| count(model, numbers, *reference)).sum();
        let mut values = vec![0.0; count];
        // SAFETY: the caller's promise, and arrays of that length.
        let status =
            unsafe { fmi3GetFloat64(c, references.as_ptr(), references.len(), values.as_mut_ptr(), values.len()) };
        assert!(status != fmi3OK || all_finite(&values));
        (status.into(), values)
    }
}
