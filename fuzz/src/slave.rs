//! An instance as used by an importer, and its results in some steps.

use std::ffi::c_void;
use std::ptr::null_mut;

use stribeck::model::ModelType;
use stribeck_ffi::fmi2::lifecycle::Purpose;

use crate::saved::{self, TIME};
use crate::version::{Answer, Ears, Version};

/// An instance.
pub struct Slave<V: Version> {
    /// Its handle in the library.
    pub c: *mut c_void,
    /// Its model.
    pub model: &'static ModelType,
    /// Its purpose.
    pub purpose: Purpose,
    /// Abilities of its importer.
    pub choice: V::Choice,
    /// Its importer.
    pub ears: Box<Ears<V::Callbacks>>,
}

impl<V: Version> Drop for Slave<V> {
    fn drop(&mut self) {
        // SAFETY: made by `new`, freed once.
        unsafe { V::drop(self.c) };
    }
}

impl<V: Version> Slave<V> {
    /// A new instance. Models that do not support Model Exchange are instantiated for co-simulation.
    pub fn new(model: &'static ModelType, exchange: bool, choice: V::Choice) -> Slave<V> {
        let is_exchange = exchange && model.model_exchange;
        let purpose = if is_exchange { Purpose::ModelExchange } else { Purpose::CoSimulation };
        let ears = Box::default();
        let c = V::make(model, purpose, choice, &ears);
        assert!(!c.is_null());
        Slave { c, model, purpose, choice, ears }
    }

    /// Number of messages since the last time.
    pub fn take_messages(&self) -> u32 {
        self.ears.messages.replace(0)
    }

    /// The contents of a saved state of the instance.
    pub fn bytes(&self) -> Vec<u8> {
        let mut state = null_mut();
        // SAFETY: a live instance and a state of it, freed once.
        unsafe {
            assert_eq!(V::save(self.c, &mut state), Answer::Ok);
            let bytes = self.bytes_of(state);
            assert_eq!(V::free(self.c, &mut state), Answer::Ok);
            bytes
        }
    }

    /// The bytes of a saved state of the instance's model.
    ///
    /// # Safety
    /// `state` must be a state that has not been freed.
    pub unsafe fn bytes_of(&self, state: *mut c_void) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: a live instance, a live state, and a buffer of the required size.
        unsafe {
            assert_eq!(V::size(self.c, state, &mut size), Answer::Ok);
            let mut bytes = vec![0u8; size];
            assert_eq!(V::write(self.c, state, &mut bytes), Answer::Ok);
            bytes
        }
    }

    /// Restores a state from its bytes.
    pub fn read(&self, bytes: &[u8]) {
        let mut state = null_mut();
        // SAFETY: a live instance, and a state that is freed once.
        unsafe {
            assert_eq!(V::read(self.c, bytes, &mut state), Answer::Ok);
            assert_eq!(V::restore(self.c, state), Answer::Ok);
            assert_eq!(V::free(self.c, &mut state), Answer::Ok);
        }
    }

    /// Numbers in a saved state of the instance.
    pub fn numbers(&self) -> Vec<f64> {
        saved::numbers(&self.bytes())
    }

    /// Results in some steps, bit by bit.
    pub fn future(&self, steps: u8, length: f64) -> Vec<u8> {
        let mut trace = Vec::new();
        for _ in 0..steps {
            let step = match self.purpose {
                Purpose::CoSimulation => self.step(length),
                Purpose::ModelExchange => self.step_of_solver(length),
            };
            trace.push(step as u8);
            // SAFETY: a live instance.
            let (read, values) = unsafe { V::read_all(self.c, self.model, &self.numbers()) };
            trace.push(read as u8);
            if step != Answer::Ok || read != Answer::Ok {
                break;
            }
            assert!(all_finite(&values));
            trace.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        }
        trace.extend(self.bytes());
        trace
    }

    fn step(&self, length: f64) -> Answer {
        // SAFETY: a live instance.
        unsafe { V::step(self.c, &self.ears, self.numbers()[TIME], length) }
    }

    /// Euler's step.
    fn step_of_solver(&self, length: f64) -> Answer {
        let count = self.model.continuous_states().count();
        let (mut states, mut rates) = (vec![0.0; count], vec![0.0; count]);
        // SAFETY: a live instance, and arrays of that length.
        unsafe {
            assert_eq!(V::get_array(self.c, 2, &mut states), Answer::Ok);
            let status = V::get_array(self.c, 0, &mut rates);
            if status != Answer::Ok {
                return status;
            }
            for (state, rate) in states.iter_mut().zip(&rates) {
                *state += length * rate;
            }
            V::set_states(self.c, &states)
        }
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
