//! The FMI functions from an importer's point of view: one subject per file, and what they share.

#[path = "../common/mod.rs"]
mod common;

mod calls;
mod derivatives;
mod fmi3;
mod hosts;
mod model_exchange;
mod saved_states;
mod servo;
mod setup;
mod steps;
mod values;

use std::ops::Range;

use common::importer::Importer;
use stribeck::catalogue;
use stribeck::model::{Kind, Role, Variable};
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

impl Importer {
    /// The first variable of this kind.
    fn first(&self, is_wanted: impl Fn(&Variable) -> bool) -> Option<fmi2ValueReference> {
        let model = catalogue::by_name(self.model)?;
        model.variables().find(|(_, variable)| is_wanted(variable)).map(|(column, _)| model.reference(column))
    }

    /// The continuous states, of an instance for Model Exchange.
    fn states(&self) -> Vec<f64> {
        let model = catalogue::by_name(self.model).expect("a model");
        model.continuous_states().map(|column| model.table.at(column).start).collect()
    }

    /// fmi2EnterInitializationMode needs an experiment; in the state Instantiated the matrix sets one up.
    fn one_state_is_set_up(&self) -> bool {
        let mut state = self.save();
        let bytes = self.bytes(state);
        // SAFETY: a state of this instance, freed once.
        assert_eq!(unsafe { fmi2FreeFMUstate(self.c, &mut state) }, fmi2OK);
        // The first number behind head (50 bytes) and the three of the instance is the state.
        let number: Vec<u8> = bytes[50 + 24..50 + 32].iter().map(|byte| *byte as u8).collect();
        f64::from_le_bytes(number.try_into().expect("eight bytes")) == 0.0
    }
}

/// Makes steps of `h` with inputs that depend only on the number of the step, each at the time that `time` gives for
/// its number, and returns the bits of all readable values after each of them.
fn drive(importer: &Importer, steps: Range<i32>, h: f64, time: impl Fn(i32) -> f64) -> Vec<u64> {
    let model = catalogue::by_name(importer.model).expect("a model");
    let reals = |role: fn(Role) -> bool| {
        let table = model.table.iter().enumerate();
        table.filter(move |(_, variable)| role(variable.role) && matches!(variable.kind, Kind::Real(_)))
    };
    let outputs: Vec<u32> = reals(Role::is_output).map(|(column, _)| model.reference(column)).collect();
    let mut values = vec![f64::NAN; outputs.len()];
    let mut bits = Vec::new();
    for k in steps {
        for (column, variable) in reals(|role| role == Role::Input) {
            let swing = if variable.bound.admits(-1.0) { f64::from(k).sin() } else { 1.0 };
            let value = variable.start + 0.01 * swing;
            // SAFETY: one reference, one value.
            assert_eq!(unsafe { fmi2SetReal(importer.c, &model.reference(column), 1, &value) }, fmi2OK);
        }
        assert_eq!(importer.step(time(k), h), fmi2OK, "{} in step {k}", importer.model);
        // SAFETY: as many references as values.
        let status = unsafe { fmi2GetReal(importer.c, outputs.as_ptr(), outputs.len(), values.as_mut_ptr()) };
        assert_eq!(status, fmi2OK, "{}", importer.model);
        bits.extend(values.iter().map(|value| value.to_bits()));
    }
    bits
}

/// The time of a step of 1 ms.
fn millisecond(k: i32) -> f64 {
    f64::from(k) * 1e-3
}
