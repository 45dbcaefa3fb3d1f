//! Saved states of an instance.

use super::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::{Computed, Fault, ModelType};

/// Everything that changes in an [`Instance`] during its life.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The row. Advice, which follows from the rest, has its start values.
    pub row: Box<[f64]>,
    /// Memory of the model beside the row.
    pub memory: Box<[f64]>,
    /// Slopes of the inputs.
    pub slope: Box<[f64]>,
    /// Whether the slopes belong to the next step.
    pub slopes_are_new: bool,
    /// Whether the outputs lag behind the other columns.
    pub stale: bool,
    /// Time of the instance.
    pub time: f64,
}

impl Snapshot {
    /// Whether advice was read makes no difference to a saved state.
    fn forget_advice(&mut self, model: &ModelType) {
        for column in model.advice() {
            self.row[column] = model.table.at(column).start;
        }
    }
}

impl Instance {
    /// Writes everything that changes into a snapshot made by [`Instance::save`] of the same model.
    pub fn save_into(&self, snapshot: &mut Snapshot) {
        snapshot.row.copy_from_slice(&self.row);
        snapshot.memory.copy_from_slice(&self.memory);
        snapshot.slope.copy_from_slice(self.slopes.values());
        snapshot.slopes_are_new = self.slopes.are_for_next_step();
        snapshot.stale = self.computed == Computed::Nothing;
        snapshot.time = self.time;
        snapshot.forget_advice(self.model);
    }

    /// Everything that changes, for [`Instance::restore`]. Panics if memory runs out; see [`Instance::try_save`].
    pub fn save(&self) -> Snapshot {
        self.try_save().unwrap_or_else(|error| panic!("{error}"))
    }

    /// As [`Instance::save`], if there is memory for it.
    pub fn try_save(&self) -> Result<Snapshot, OutOfMemory> {
        let mut snapshot = Snapshot {
            row: memory::copied(&self.row)?,
            memory: memory::copied(&self.memory)?,
            slope: memory::copied(self.slopes.values())?,
            slopes_are_new: self.slopes.are_for_next_step(),
            stale: self.computed == Computed::Nothing,
            time: self.time,
        };
        snapshot.forget_advice(self.model);
        Ok(snapshot)
    }

    /// Restores a snapshot of the same model; the caller must make sure that it is one.
    pub fn restore(&mut self, snapshot: &Snapshot) {
        self.row.copy_from_slice(&snapshot.row);
        self.memory.copy_from_slice(&snapshot.memory);
        self.slopes.restore(&snapshot.slope, snapshot.slopes_are_new);
        self.unchecked = true;
        if let Some(exchange) = &mut self.exchange {
            exchange.begin_event();
        }
        if let Some(consistency) = &mut self.consistency {
            consistency.give_up();
        }
        self.computed = if snapshot.stale { Computed::Nothing } else { Computed::Main };
        self.time = snapshot.time;
    }

    /// Rejects a saved state that only events of Model Exchange can produce, for an instance that continues with steps.
    pub fn check_without_events(&self, snapshot: &Snapshot) -> Result<(), Fault> {
        let mut columns = self.model.table.iter().zip(&snapshot.row);
        columns.try_for_each(|(variable, value)| variable.check_without_events(*value))
    }
}
