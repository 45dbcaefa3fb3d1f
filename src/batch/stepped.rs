//! Runs that the caller steps, all at once.

use std::ops::Range;

use super::{Batch, Registers};
use crate::instance::{Instance, Phase, Refused, Snapshot};
use crate::memory::{self, OutOfMemory};
use crate::model::{Fault, Fit, ModelType, Role, Variable};
use crate::series::Ended;

/// Runs that are worked on together (chosen): their rows fit into the nearest cache.
const TOGETHER: usize = 64;

/// A run that was refused, and why. No run has changed then; results that were taken before it may be there.
pub type Stopped = (usize, Ended);

/// Values of a column: one for all runs, or one for each.
pub type Given<'a> = (usize, &'a [f64]);

/// Takes the results of some runs; an error names the place among them.
pub type Take<'a> = &'a mut dyn FnMut(Range<usize>, &[f64]) -> Result<(), (usize, Fault)>;

/// Runs of one model that the caller steps together. Each has the bits of an [`Instance`] of its own; nothing is allocated
/// but for the first values of each run in a column that had one for all of them.
///
/// ```
/// use stribeck::batch::{Registers, Stepped};
///
/// let law = stribeck::catalogue::by_name("Coulomb").expect("a law");
/// let columns = ["velocity", "normal_force", "friction_force"].map(|name| law.find(name).expect("a variable"));
/// let mut contacts = Stepped::new(law, Registers::best(), 3).expect("memory");
/// let mut forces = [0.0; 3];
/// let inputs = [(columns[0], &[-0.2, 0.1, 0.4][..]), (columns[1], &[10.0][..])];
/// let mut take = |runs: std::ops::Range<usize>, values: &[f64]| {
///     forces[runs].copy_from_slice(values);
///     Ok(())
/// };
/// contacts.step(1e-3, &inputs, columns[2], &mut take).expect("a step");
/// assert_eq!(forces, [-1.0, 1.0, 1.0]);
/// ```
pub struct Stepped {
    model: &'static ModelType,
    runs: usize,
    /// Each column, with one value for all runs, or one for each.
    columns: Box<[Vec<f64>]>,
    /// Values that are not in force yet: those that were given, and what a step leads to.
    next: Box<[Vec<f64>]>,
    /// The columns that were given.
    given: Box<[bool]>,
    /// Memory of each run beside its row, and what a step leads to.
    memory: Box<[f64]>,
    next_memory: Box<[f64]>,
    times: Box<[f64]>,
    /// Whether the parameters have still to be checked against each other.
    unchecked: bool,
    /// Rows of some runs, if there are registers for them, and whether all runs can be worked on there.
    batch: Option<Batch>,
    fits: bool,
    /// Bits of the value that all rows there have in a column, if they are known to have the same one.
    in_all: Box<[Option<u64>]>,
    /// Whether the parameters of a run ask for memory.
    uses_memory: bool,
    row: Box<[f64]>,
    results: Box<[f64]>,
    /// For checks, and for texts about what goes wrong.
    instance: Instance,
}

/// A step, or outputs without one, and the column that is wanted.
#[derive(Clone, Copy)]
struct Work {
    dt: Option<f64>,
    result: usize,
}

impl Stepped {
    /// Runs at their start values, at time 0.
    pub fn new(model: &'static ModelType, registers: Registers, runs: usize) -> Result<Stepped, OutOfMemory> {
        let columns = model.table.len();
        let values = runs.checked_mul(model.memory).ok_or(OutOfMemory)?;
        let mut stepped = Stepped {
            model,
            runs,
            columns: memory::each(0..columns, |_| Ok(Vec::new()))?.into(),
            next: memory::each(0..columns, |_| Ok(Vec::new()))?.into(),
            given: memory::filled(false, columns)?,
            memory: memory::filled(0.0, values)?,
            next_memory: memory::filled(0.0, values)?,
            times: memory::filled(0.0, runs)?,
            unchecked: true,
            batch: Batch::new(model, registers, TOGETHER.min(runs))?,
            fits: false,
            in_all: memory::filled(None, columns)?,
            uses_memory: false,
            row: memory::filled(0.0, columns)?,
            results: memory::filled(0.0, TOGETHER)?,
            instance: Instance::try_new(model)?,
        };
        for column in 0..columns {
            let room = if stepped.is_carried(column) { runs } else { 1 };
            for values in [&mut stepped.columns[column], &mut stepped.next[column]] {
                values.try_reserve_exact(room).map_err(|_| OutOfMemory)?;
                values.push(model.table.start(column));
            }
        }
        Ok(stepped)
    }

    /// The model.
    pub fn model(&self) -> &'static ModelType {
        self.model
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.runs
    }

    /// Time of each run in s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Whether the states of all runs are variables: none is hidden, and none lies in memory beside the rows.
    pub fn shows_all_states(&mut self) -> Result<bool, Stopped> {
        self.forget_given();
        self.check()?;
        let is_state = |variable: &Variable| matches!(variable.role, Role::State | Role::StateOutput);
        Ok(!self.uses_memory && !self.model.table.iter().any(|variable| variable.is_hidden && is_state(&variable)))
    }

    /// Whether a step may change a column. Only models without lanes move their inputs.
    fn is_carried(&self, column: usize) -> bool {
        match self.model.table.role(column) {
            Role::State | Role::StateOutput => true,
            Role::Input => self.model.kernels.is_none(),
            Role::Fixed | Role::Tunable | Role::Output => false,
        }
    }

    /// Sets inputs, parameters and states: all, or none if one is refused.
    ///
    /// # Panics
    ///
    /// If a column has neither one value nor one for each run.
    pub fn set(&mut self, values: &[Given]) -> Result<(), Stopped> {
        self.prepare(values)?;
        for (column, _) in values {
            self.unchecked |= self.model.table.role(*column) != Role::Input;
        }
        self.take_given();
        Ok(())
    }

    /// Resets states to their start values, and times to 0, where `which` holds. Parameters and inputs stay.
    pub fn reset(&mut self, which: impl Fn(usize) -> bool) {
        let runs = self.runs;
        for column in 0..self.columns.len() {
            if matches!(self.model.table.role(column), Role::State | Role::StateOutput) {
                let (start, values) = (self.model.table.start(column), &mut self.columns[column]);
                if !matches!(values[..], [value] if value.to_bits() == start.to_bits()) {
                    spread(values, runs);
                    let values = values.iter_mut().enumerate();
                    values.filter(|(run, _)| which(*run)).for_each(|(_, value)| *value = start);
                }
            }
        }
        for run in (0..runs).filter(|run| which(*run)) {
            self.times[run] = 0.0;
            self.memory[run * self.model.memory..(run + 1) * self.model.memory].fill(0.0);
        }
    }

    /// Gives inputs values, advances all runs by `dt` while they are held, and hands over an output as it is then.
    ///
    /// # Panics
    ///
    /// If a given column is not an input, or has neither one value nor one for each run.
    pub fn step(&mut self, dt: f64, inputs: &[Given], result: usize, take: Take) -> Result<(), Stopped> {
        for (column, _) in inputs {
            assert!(self.model.table.role(*column) == Role::Input, "only inputs are given to a step");
        }
        self.prepare(inputs)?;
        let done = self.check().and_then(|()| {
            self.begin_next();
            self.check_step(dt)?;
            self.make(Work { dt: Some(dt), result }, take)
        });
        if done.is_err() {
            self.forget_given();
            return done;
        }
        for column in 0..self.columns.len() {
            self.given[column] |= self.is_carried(column);
        }
        self.take_given();
        if self.uses_memory {
            std::mem::swap(&mut self.memory, &mut self.next_memory);
        }
        self.times.iter_mut().for_each(|time| *time += dt);
        Ok(())
    }

    /// Hands over a column; an output is computed first.
    pub fn get(&mut self, column: usize, take: Take) -> Result<(), Stopped> {
        self.forget_given();
        if self.model.table.role(column) == Role::Output {
            self.check()?;
            return self.make(Work { dt: None, result: column }, take);
        }
        for runs in blocks(self.runs) {
            let (values, results) = (&self.columns[column], &mut self.results[..runs.len()]);
            match values[..] {
                [value] => results.fill(value),
                _ => results.copy_from_slice(&values[runs.clone()]),
            }
            hand_over(take, runs, results)?;
        }
        Ok(())
    }

    /// Checks values and keeps them apart.
    fn prepare(&mut self, values: &[Given]) -> Result<(), Stopped> {
        self.forget_given();
        for (column, values) in values {
            assert!(values.len() == 1 || values.len() == self.runs, "one value, or one for each run");
            if !self.model.ports.takes_all(*column, values) {
                for (run, value) in values.iter().enumerate() {
                    self.instance
                        .check_value(Phase::Setup, *column, *value)
                        .map_err(|reason| (run, refusal(reason)))?;
                }
            }
        }
        for (column, values) in values {
            let next = &mut self.next[*column];
            next.clear();
            if next.try_reserve_exact(values.len()).is_err() {
                self.forget_given();
                return Err((0, Ended::OutOfMemory));
            }
            next.extend_from_slice(values);
            self.given[*column] = true;
        }
        Ok(())
    }

    /// Makes room for what a step leads to. Where all runs have the same state, they mostly have the same one after it.
    fn begin_next(&mut self) {
        for column in 0..self.columns.len() {
            if self.is_carried(column) {
                match (self.given[column], self.columns[column].len()) {
                    (true, _) => spread(&mut self.next[column], self.runs),
                    (false, 1) => self.next[column].clear(),
                    (false, _) => self.next[column].resize(self.runs, 0.0),
                }
            }
        }
    }

    fn take_given(&mut self) {
        for (column, given) in self.given.iter_mut().enumerate() {
            if std::mem::take(given) {
                std::mem::swap(&mut self.columns[column], &mut self.next[column]);
            }
        }
    }

    /// Drops values that are not in force: those of a call that came to no end, even by a panic of its caller.
    pub(super) fn forget_given(&mut self) {
        self.given.fill(false);
    }

    /// Checks a step against the time of each run.
    pub(super) fn check_step(&mut self, dt: f64) -> Result<(), Stopped> {
        let late = |time: &f64| !(dt > 0.0 && time + dt < f64::INFINITY);
        // All of them are looked at without a way out first, which registers can do.
        if !self.times.iter().fold(false, |found, time| found | late(time)) {
            return Ok(());
        }
        self.times.iter().position(late).map_or(Ok(()), |run| Err((run, self.reason(run, Some(dt)))))
    }

    /// Checks the parameters of each run against each other, and whether all fit into lanes.
    pub(super) fn check(&mut self) -> Result<(), Stopped> {
        if !self.unchecked {
            return Ok(());
        }
        let (mut fits, mut uses_memory) = (true, false);
        for run in 0..self.runs {
            self.gather(run);
            uses_memory |= self.model.memory_in_use(&self.row) > 0;
            self.model.check(&self.row).map_err(|fault| (run, refusal(Refused::Value(fault))))?;
            fits &= self.model.kernels.as_ref().is_some_and(|kernels| (kernels.fit)(&self.row) != Fit::Alone);
        }
        (self.fits, self.uses_memory, self.unchecked) = (fits, uses_memory, false);
        Ok(())
    }

    /// The values of a column that a step begins with.
    fn source(&self, column: usize) -> &[f64] {
        if self.given[column] { &self.next[column] } else { &self.columns[column] }
    }

    /// Brings the row of a run together.
    fn gather(&mut self, run: usize) {
        for column in 0..self.row.len() {
            let values = self.source(column);
            self.row[column] = if let [value] = values { *value } else { values[run] };
        }
    }

    /// The row of a run, and the part of its memory that is in use.
    pub(super) fn row_of(&mut self, run: usize) -> (&[f64], &[f64]) {
        self.gather(run);
        let (first, in_use) = (run * self.model.memory, self.model.memory_in_use(&self.row));
        (&self.row, &self.memory[first..first + in_use])
    }

    fn make(&mut self, work: Work, take: Take) -> Result<(), Stopped> {
        let is_advice = self.model.table.at(work.result).is_advice;
        self.in_all.fill(None);
        for runs in blocks(self.runs) {
            if is_advice || !self.side_by_side(runs.clone(), work) {
                self.one_by_one(runs.clone(), work)?;
            }
            hand_over(take, runs.clone(), &self.results[..runs.len()])?;
        }
        Ok(())
    }

    /// Makes some runs in lanes. False if that cannot be done, or if a number is not finite.
    fn side_by_side(&mut self, runs: Range<usize>, work: Work) -> bool {
        let Some(mut batch) = self.batch.take_if(|_| self.fits) else { return false };
        self.load(&mut batch, runs.clone());
        let is_finite = match work.dt {
            Some(dt) => batch.advance_and_output(dt),
            None => batch.output(),
        };
        batch.read(work.result, &mut self.results[..runs.len()]);
        if work.dt.is_some() {
            self.keep(&batch, runs);
        }
        self.batch = Some(batch);
        is_finite
    }

    /// Writes what a step begins with into the lanes.
    fn load(&mut self, batch: &mut Batch, runs: Range<usize>) {
        for column in 0..self.columns.len() {
            if self.model.table.role(column) == Role::Output {
                continue;
            }
            match self.source(column) {
                // The runs before had the same value, and have left it.
                [value] if self.in_all[column] == Some(value.to_bits()) => {}
                values @ [value] => {
                    batch.set_from(column, values);
                    self.in_all[column] = Some(value.to_bits());
                }
                values => batch.set_from(column, &values[runs.clone()]),
            }
        }
    }

    /// Keeps what a step has led to.
    fn keep(&mut self, batch: &Batch, runs: Range<usize>) {
        for column in 0..self.columns.len() {
            if !self.is_carried(column) {
                continue;
            }
            let next = &mut self.next[column];
            let same = if next.len() < self.runs { batch.same(column) } else { None };
            self.in_all[column] = same.map(f64::to_bits);
            match (same, &next[..]) {
                (Some(value), []) => next.push(value),
                (Some(value), [before]) if value.to_bits() == before.to_bits() => {}
                _ => {
                    spread(next, self.runs);
                    batch.read(column, &mut next[runs.clone()]);
                }
            }
        }
    }

    fn one_by_one(&mut self, runs: Range<usize>, work: Work) -> Result<(), Stopped> {
        let model = self.model;
        for (place, run) in runs.enumerate() {
            self.gather(run);
            let of_run = if self.uses_memory { run * model.memory..(run + 1) * model.memory } else { 0..0 };
            let memory = &mut self.next_memory[of_run.clone()];
            memory.copy_from_slice(&self.memory[of_run]);
            let done = match work.dt {
                Some(dt) => (model.try_advance)(&mut self.row, memory, &mut [], dt),
                None => (model.try_output)(&mut self.row, memory, &mut []),
            };
            let is_advice = model.table.at(work.result).is_advice;
            if !(done && (!is_advice || model.try_advise(&mut self.row, &mut []))) {
                return Err((run, self.reason(run, work.dt)));
            }
            self.results[place] = self.row[work.result];
            if work.dt.is_some() {
                for column in 0..self.columns.len() {
                    if self.is_carried(column) {
                        spread(&mut self.next[column], self.runs);
                        self.next[column][run] = self.row[column];
                    }
                }
            }
        }
        Ok(())
    }

    /// Why a run does not go on, in the words of an instance.
    #[cold]
    fn reason(&mut self, run: usize, dt: Option<f64>) -> Ended {
        self.gather(run);
        let first = run * self.model.memory;
        let copies = || {
            let row = memory::copied(&self.row)?;
            let memory = memory::copied(&self.memory[first..first + self.model.memory])?;
            let slope = memory::filled(0.0, row.len())?;
            Ok(Snapshot { row, memory, slope, slopes_are_new: false, stale: true, time: self.times[run] })
        };
        let snapshot = match copies() {
            Ok(snapshot) => snapshot,
            Err(OutOfMemory) => return Ended::OutOfMemory,
        };
        self.instance.restore(&snapshot);
        let done = match dt {
            Some(dt) => self.instance.step(dt).and_then(|()| self.instance.refresh()),
            None => self.instance.refresh(),
        };
        let fault = done.err().unwrap_or_else(|| Fault::new(format_args!("a result would not be finite")));
        refusal(Refused::NotFinite(fault))
    }
}

/// Makes one value, or none yet, one for each run, for which there is room.
fn spread(values: &mut Vec<f64>, runs: usize) {
    let value = values.first().copied().unwrap_or(0.0);
    values.resize(runs, value);
}

/// Consecutive runs.
fn blocks(runs: usize) -> impl Iterator<Item = Range<usize>> {
    (0..runs).step_by(TOGETHER).map(move |first| first..runs.min(first + TOGETHER))
}

fn hand_over(take: Take, runs: Range<usize>, results: &[f64]) -> Result<(), Stopped> {
    let first = runs.start;
    take(runs, results).map_err(|(place, fault)| (first + place, refusal(Refused::Value(fault))))
}

pub(super) fn refusal(reason: Refused) -> Ended {
    Ended::Setup(Box::new(reason))
}
