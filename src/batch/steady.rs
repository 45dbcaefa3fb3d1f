//! Steady sliding at many points.

use std::ops::Range;

use super::{Batch, Registers};
use crate::instance::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::{ModelType, Role};

/// Points that are worked on together (chosen): their rows fit into the nearest cache.
const TOGETHER: usize = 64;

/// Inputs and results of points, wherever they are kept.
pub trait Points {
    /// Reads an input, by its number, at some points.
    fn read(&self, input: usize, points: Range<usize>, values: &mut [f64]);
    /// Keeps a result, by its number, at some points.
    fn write(&mut self, result: usize, points: Range<usize>, values: &[f64]);
}

/// Workspace for points of steady sliding in closed form: nothing is allocated while they are computed.
pub struct Steady<'a> {
    model: &'static ModelType,
    /// Columns of the inputs that differ, and of the results.
    inputs: &'a [usize],
    results: &'a [usize],
    batch: Option<Batch>,
    /// A contact before it slides, and while it does.
    start: Box<[f64]>,
    row: Box<[f64]>,
    values: Box<[f64]>,
}

impl<'a> Steady<'a> {
    /// For points that have the parameters of an instance, and its other inputs. None if they have no closed form, or if a
    /// result is not an output.
    pub fn of(
        instance: &Instance,
        registers: Registers,
        inputs: &'a [usize],
        results: &'a [usize],
    ) -> Result<Option<Steady<'a>>, OutOfMemory> {
        let (model, start) = (instance.model(), instance.row());
        let is_main = |column: &usize| {
            let variable = model.table.at(*column);
            variable.role == Role::Output && !variable.is_advice
        };
        if !(instance.uses_its_row_alone() && model.slides_steadily(start) && results.iter().all(is_main)) {
            return Ok(None);
        }
        let batch = Batch::new(model, registers, TOGETHER)?;
        let batch = batch.and_then(|mut batch| batch.load(0..TOGETHER, start).then_some(batch));
        let copy = || memory::copied(start);
        let values = memory::filled(0.0, TOGETHER * (inputs.len() + results.len()))?;
        Ok(Some(Steady { model, inputs, results, batch, start: copy()?, row: copy()?, values }))
    }

    /// Results at some points, in order. Ends early with the points among which one has to be looked at by itself: an input
    /// is not admitted there, or an output is not finite. Nothing has been kept of them.
    pub fn make(&mut self, points: Range<usize>, at: &mut impl Points) -> Result<(), Range<usize>> {
        for first in points.clone().step_by(TOGETHER) {
            let some = first..points.end.min(first + TOGETHER);
            if !self.make_together(some.clone(), at) {
                return Err(some);
            }
        }
        Ok(())
    }

    fn make_together(&mut self, points: Range<usize>, at: &mut impl Points) -> bool {
        let count = points.len();
        let (inputs, results) = self.values.split_at_mut(TOGETHER * self.inputs.len());
        let ports = self.model.ports;
        for (number, (column, values)) in self.inputs.iter().zip(inputs.chunks_exact_mut(TOGETHER)).enumerate() {
            at.read(number, points.clone(), &mut values[..count]);
            if !ports.takes_all(*column, &values[..count]) {
                return false;
            }
        }
        let is_finite = match &mut self.batch {
            Some(batch) => side_by_side(batch, count, (self.inputs, inputs), (self.results, results)),
            None => self.one_by_one(count),
        };
        if is_finite {
            let results = self.values[TOGETHER * self.inputs.len()..].chunks_exact(TOGETHER).enumerate();
            results.for_each(|(number, values)| at.write(number, points.clone(), &values[..count]));
        }
        is_finite
    }

    fn one_by_one(&mut self, count: usize) -> bool {
        let (inputs, results) = self.values.split_at_mut(TOGETHER * self.inputs.len());
        for point in 0..count {
            self.row.copy_from_slice(&self.start);
            for (column, values) in self.inputs.iter().zip(inputs.chunks_exact(TOGETHER)) {
                self.row[*column] = values[point];
            }
            if !(self.model.try_slide_steadily)(&mut self.row, &mut [], &mut []) {
                return false;
            }
            for (column, values) in self.results.iter().zip(results.chunks_exact_mut(TOGETHER)) {
                values[point] = self.row[*column];
            }
        }
        true
    }
}

/// Columns with a value for each point.
type Values<'a, V> = (&'a [usize], V);

fn side_by_side(batch: &mut Batch, count: usize, inputs: Values<&mut [f64]>, results: Values<&mut [f64]>) -> bool {
    for (column, values) in inputs.0.iter().zip(inputs.1.chunks_exact(TOGETHER)) {
        batch.set_from(*column, &values[..count]);
    }
    let is_finite = batch.slide_steadily();
    for (column, values) in results.0.iter().zip(results.1.chunks_exact_mut(TOGETHER)) {
        batch.read(*column, &mut values[..count]);
    }
    is_finite
}
