//! The unknowns of a model, and what determines them.

use std::collections::BTreeSet;

use stribeck::model::{ModelType, Role};

use crate::describe::dependencies::{self, Found};

/// The states whose derivatives are variables: those that an importer may integrate.
pub fn integrated(model: &ModelType) -> Vec<usize> {
    if model.model_exchange { model.continuous_states().collect() } else { Vec::new() }
}

/// Index of a variable in the model structure, from 1: columns that are shown, time, derivatives of the states.
pub fn index(model: &ModelType, place: usize) -> usize {
    let hidden = model.table.iter().take(place).filter(|variable| variable.is_hidden);
    place + 1 - hidden.count()
}

/// Unknowns of a model: columns and, behind them and time, the derivatives of its states.
pub struct Structure<'a> {
    model: &'a ModelType,
    found: Found,
    states: Vec<usize>,
}

impl Structure<'_> {
    /// The unknowns of a model.
    pub fn of(model: &ModelType) -> Structure<'_> {
        Structure { model, found: dependencies::of(model), states: integrated(model) }
    }

    /// The outputs.
    pub fn outputs(&self) -> Vec<usize> {
        let table = self.model.table;
        (0..table.len()).filter(|column| table.at(*column).role.is_output()).collect()
    }

    /// The derivatives of the states.
    pub fn derivatives(&self) -> Vec<usize> {
        (0..self.states.len()).map(|state| self.model.table.len() + 1 + state).collect()
    }

    /// The unknowns that an importer may compute before the first step.
    pub fn initial(&self) -> Vec<usize> {
        let calculated = self.outputs().into_iter().filter(|output| self.model.table.at(*output).role.is_computed());
        calculated.chain(self.derivatives()).collect()
    }

    /// The columns that determine an unknown and satisfy a condition; `None` for an unknown that depends on all.
    fn known(&self, unknown: usize, is_known: impl Fn(usize) -> bool) -> Option<BTreeSet<usize>> {
        let columns = self.model.table.len();
        let place = if unknown < columns { unknown } else { columns + self.states[unknown - columns - 1] };
        let found = self.found.as_ref()?;
        Some(found[place].iter().copied().filter(|column| is_known(*column)).collect())
    }

    /// The inputs and states that determine an unknown.
    pub fn while_stepping(&self, unknown: usize) -> Option<BTreeSet<usize>> {
        let is_input = |column: usize| self.model.table.at(column).role == Role::Input;
        let mut known = self.known(unknown, |column| is_input(column) || self.states.contains(&column))?;
        known.extend(Some(unknown).filter(|unknown| self.states.contains(unknown)));
        Some(known)
    }

    /// The variables that determine an unknown at any time, its own state included.
    pub fn at_any_time(&self, unknown: usize) -> Option<BTreeSet<usize>> {
        let mut known = self.initially(unknown)?;
        let is_state =
            |unknown: usize| unknown < self.model.table.len() && self.model.table.at(unknown).role.is_state();
        known.extend(Some(unknown).filter(|unknown| is_state(*unknown)));
        Some(known)
    }

    /// The variables that determine an unknown at the start.
    pub fn initially(&self, unknown: usize) -> Option<BTreeSet<usize>> {
        self.known(unknown, |column| !self.model.table.at(column).is_hidden)
    }
}
