//! Exact derivatives of results.

use super::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::ModelType;
use crate::number::Dual;

/// Row and memory in dual numbers, and rates: workspace.
pub(super) struct Workspace {
    row: Box<[Dual]>,
    memory: Box<[Dual]>,
    rates: Box<[Dual]>,
    memory_rate: Box<[f64]>,
}

impl Workspace {
    pub fn of(model: &ModelType) -> Result<Workspace, OutOfMemory> {
        Ok(Workspace {
            row: memory::filled(Dual::default(), model.table.len())?,
            memory: memory::filled(Dual::default(), model.memory)?,
            rates: memory::filled(Dual::default(), model.table.len())?,
            memory_rate: memory::filled(0.0, model.memory)?,
        })
    }
}

impl Instance {
    /// Derivative of each column in the direction given by `seeds` (column, component); exact.
    pub fn derivative(&mut self, seeds: impl Iterator<Item = (usize, f64)>) -> &[Dual] {
        self.seed(seeds);
        self.find_dual_outputs()
    }

    /// As [`Instance::derivative`], and derivatives of the time derivatives of the states, in the columns of the states.
    /// For Model Exchange.
    pub fn derivatives(&mut self, seeds: impl Iterator<Item = (usize, f64)>) -> (&[Dual], &[Dual]) {
        self.seed(seeds);
        self.model.rate_dual(&self.duals.row, &mut self.duals.rates);
        self.find_dual_outputs();
        (&self.duals.row, &self.duals.rates)
    }

    /// Derivative of each column with respect to time at the present instant; exact.
    pub fn time_derivative(&mut self) -> &[Dual] {
        self.spread();
        self.find_rates();
        for ((dual, rate), slope) in self.duals.row.iter_mut().zip(&self.rate).zip(self.slopes.values()) {
            dual.slope = rate + slope;
        }
        for (dual, rate) in self.duals.memory.iter_mut().zip(&self.duals.memory_rate) {
            dual.slope = *rate;
        }
        self.find_dual_outputs()
    }

    pub(super) fn find_rates(&mut self) {
        let in_use = self.model.memory_in_use(&self.row);
        let (memory, memory_rate) = (&self.memory[..in_use], &mut self.duals.memory_rate[..in_use]);
        (self.model.rate_with)(&self.row, memory, &mut self.rate, memory_rate);
    }

    /// The values as dual numbers, without slopes.
    fn spread(&mut self) {
        for (dual, value) in self.duals.row.iter_mut().zip(&self.row) {
            *dual = Dual::from(*value);
        }
        let in_use = self.model.memory_in_use(&self.row);
        for (dual, value) in self.duals.memory.iter_mut().zip(&self.memory[..in_use]) {
            *dual = Dual::from(*value);
        }
    }

    fn seed(&mut self, seeds: impl Iterator<Item = (usize, f64)>) {
        self.spread();
        for (column, component) in seeds {
            self.duals.row[column].slope += component;
        }
    }

    fn find_dual_outputs(&mut self) -> &[Dual] {
        let in_use = self.model.memory_in_use(&self.row);
        (self.model.output_dual_with)(&mut self.duals.row, &self.duals.memory[..in_use]);
        &self.duals.row
    }
}
