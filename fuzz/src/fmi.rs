//! An instance as used by an importer, through the functions of FMI 2.0, and its results in some steps.

use std::cell::Cell;
use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};

use stribeck::model::{Kind, ModelType};
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, STATES, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::{fmi2OK, fmi2Warning};
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

use crate::saved::{self, TIME};

/// An instance.
pub struct Slave {
    /// Its handle in the library.
    pub c: fmi2Component,
    /// Its model.
    pub model: &'static ModelType,
    /// Its purpose.
    pub purpose: Purpose,
    messages: Box<Cell<u32>>,
}

impl Drop for Slave {
    fn drop(&mut self) {
        // SAFETY: made by `new`, freed once.
        unsafe { fmi2FreeInstance(self.c) };
    }
}

/// Counts the errors that an instance reports. Rust cannot define variadic functions, but on the platforms on which
/// this runs a function that names the first variadic argument receives it.
unsafe extern "C" fn listen(
    environment: *mut c_void,
    _name: fmi2String,
    status: fmi2Status,
    category: fmi2String,
    message: fmi2String,
    text: fmi2String,
) {
    // SAFETY: the environment is the count of a live `Slave`; the texts are those of the library.
    unsafe {
        let count = &*environment.cast::<Cell<u32>>();
        // A warning accompanies a call that succeeds.
        count.set(count.get() + u32::from(status != fmi2Warning));
        assert_eq!(CStr::from_ptr(message), c"%s", "the message is a format and must be constant");
        assert_ne!(status, fmi2OK);
        assert!(status != fmi2Warning || CStr::from_ptr(category) == c"logStatusWarning");
        assert!(CStr::from_ptr(category).to_bytes().starts_with(b"logStatus"));
        let text = CStr::from_ptr(text).to_string_lossy();
        assert!(!text.contains("internal error"), "a panic was caught: {text}");
    }
}

impl Slave {
    /// A new instance. Models that do not support Model Exchange are instantiated for co-simulation.
    pub fn new(model: &'static ModelType, exchange: bool) -> Slave {
        let exchange = exchange && model.model_exchange;
        let messages = Box::<Cell<u32>>::default();
        type Fixed = unsafe extern "C" fn(*mut c_void, fmi2String, fmi2Status, fmi2String, fmi2String, fmi2String);
        // SAFETY: see `listen`.
        let logger = unsafe { std::mem::transmute::<Fixed, fmi2CallbackLogger>(listen) };
        let callbacks = fmi2CallbackFunctions {
            logger,
            allocateMemory: None,
            freeMemory: None,
            stepFinished: None,
            componentEnvironment: std::ptr::from_ref(&*messages).cast_mut().cast(),
        };
        let guid = CString::new(model.guid()).expect("no zero byte");
        let (kind, purpose) = if exchange {
            (fmi2ModelExchange, Purpose::ModelExchange)
        } else {
            (fmi2CoSimulation, Purpose::CoSimulation)
        };
        let name = c"fuzz".as_ptr();
        // SAFETY: valid texts and callbacks.
        let c = unsafe { fmi2Instantiate(name, kind, guid.as_ptr(), null(), &callbacks, fmi2False, fmi2True) };
        assert!(!c.is_null());
        Slave { c, model, purpose, messages }
    }

    /// Number of messages since the last time.
    pub fn take_messages(&self) -> u32 {
        self.messages.replace(0)
    }

    /// The contents of a saved state of the instance.
    pub fn bytes(&self) -> Vec<u8> {
        let mut state = null_mut();
        // SAFETY: a live instance and a state of it, freed once.
        unsafe {
            assert_eq!(fmi2GetFMUstate(self.c, &mut state), fmi2OK);
            let bytes = self.bytes_of(state);
            assert_eq!(fmi2FreeFMUstate(self.c, &mut state), fmi2OK);
            bytes
        }
    }

    /// The bytes of a saved state of the instance's model.
    ///
    /// # Safety
    /// `state` must be a state that has not been freed.
    pub unsafe fn bytes_of(&self, state: fmi2FMUstate) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: a live instance, a live state, and a buffer of the required size.
        unsafe {
            assert_eq!(fmi2SerializedFMUstateSize(self.c, state, &mut size), fmi2OK);
            let mut bytes = vec![0u8; size];
            assert_eq!(fmi2SerializeFMUstate(self.c, state, bytes.as_mut_ptr().cast(), size), fmi2OK);
            bytes
        }
    }

    /// Restores a state from its bytes.
    pub fn read(&self, bytes: &[u8]) {
        let mut state = null_mut();
        // SAFETY: a live instance, as many bytes as given, and a state that is freed once.
        unsafe {
            let bytes: &[fmi2Byte] = std::slice::from_raw_parts(bytes.as_ptr().cast(), bytes.len());
            assert_eq!(fmi2DeSerializeFMUstate(self.c, bytes.as_ptr(), bytes.len(), &mut state), fmi2OK);
            assert_eq!(fmi2SetFMUstate(self.c, state), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(self.c, &mut state), fmi2OK);
        }
    }
}

/// The lifecycle state in the numbers of a saved state.
pub fn state(numbers: &[f64]) -> State {
    STATES[numbers[saved::STATE] as usize]
}

/// Results of an instance in some steps, bit by bit.
pub fn future(slave: &Slave, steps: u8, length: f64) -> Vec<u8> {
    let reals = slave.model.table.iter().enumerate().filter(|(_, variable)| matches!(variable.kind, Kind::Real(_)));
    let references: Vec<u32> = reals.map(|(column, _)| slave.model.reference(column)).collect();
    let mut values = vec![0.0; references.len()];
    let mut trace = Vec::new();
    for _ in 0..steps {
        let step = match slave.purpose {
            Purpose::CoSimulation => step_of_co_simulation(slave, length),
            Purpose::ModelExchange => step_of_model_exchange(slave, length),
        };
        trace.push(step as u8);
        // SAFETY: a live instance, and arrays of that length.
        let read = unsafe { fmi2GetReal(slave.c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        trace.push(read as u8);
        if step != fmi2OK || read != fmi2OK {
            break;
        }
        assert!(all_finite(&values));
        trace.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    }
    trace.extend(slave.bytes());
    trace
}

fn step_of_co_simulation(slave: &Slave, length: f64) -> fmi2Status {
    let time = saved::numbers(&slave.bytes())[TIME];
    // SAFETY: a live instance.
    unsafe { fmi2DoStep(slave.c, time, length, fmi2True) }
}

/// Euler's step.
fn step_of_model_exchange(slave: &Slave, length: f64) -> fmi2Status {
    let count = slave.model.continuous_states().count();
    let (mut states, mut rates) = (vec![0.0; count], vec![0.0; count]);
    // SAFETY: a live instance, and arrays of that length.
    unsafe {
        assert_eq!(fmi2GetContinuousStates(slave.c, states.as_mut_ptr(), count), fmi2OK);
        let status = fmi2GetDerivatives(slave.c, rates.as_mut_ptr(), count);
        if status != fmi2OK {
            return status;
        }
        for (state, rate) in states.iter_mut().zip(&rates) {
            *state += length * rate;
        }
        fmi2SetContinuousStates(slave.c, states.as_ptr(), count)
    }
}

/// Whether none of the values is infinite or not a number.
pub fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

/// Whether the numbers are the same, bit by bit.
pub fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}
