//! Runs of one model over given inputs: several side by side, or one after the other.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use super::{Batch, Registers};
use crate::instance::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::{Fit, Meaning, ModelType, Role};
use crate::series::{self, Between, Course, Ended, Input, PATIENCE, Times};

/// Runs that are made together (chosen): a few groups in any registers, whose rows fit into the nearest cache.
const TOGETHER: usize = 16;

/// Samples of one run that are made together (chosen): their rows still fit into it.
const SAMPLES: usize = 64;

/// Samples of runs that are made together whose values lie side by side (chosen): those of a run lie far from those of the
/// next one, often in the same place of the nearest cache.
const TILE: usize = 32;

/// Runs of which each is made along its samples, where its law has a state that relaxes: as few as leave most lanes of a
/// large register empty (chosen).
const FEW: usize = 3;

/// Beyond this, or below its inverse, a step may fail although the outputs before and after it are finite (chosen): no law
/// multiplies so many numbers within these bounds that the product comes near the largest number.
const LARGE: f64 = 1e20;

/// A variable with its values: a row of them for each run, or one for all runs.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// Its column.
    pub column: usize,
    /// Number of rows: 1, or one for each run.
    pub rows: usize,
    /// Values in a row: 1, or one per sample.
    pub width: usize,
    /// The values, row after row.
    pub values: &'a [f64],
}

impl<'a> Rows<'a> {
    /// The row of a run.
    #[inline]
    pub fn row(&self, run: usize) -> &'a [f64] {
        let first = if self.rows == 1 { 0 } else { run * self.width };
        &self.values[first..first + self.width]
    }

    #[inline]
    fn at(&self, run: usize, sample: usize) -> f64 {
        self.row(run)[if self.width == 1 { 0 } else { sample }]
    }
}

/// Runs over given inputs.
#[derive(Clone, Copy, Debug)]
pub struct Runs<'a> {
    /// The inputs.
    pub inputs: &'a [Rows<'a>],
    /// When their samples are taken.
    pub times: Times<'a>,
    /// Samples of each run.
    pub samples: usize,
    /// How inputs move between them.
    pub between: Between,
    /// Columns of the results.
    pub results: &'a [usize],
}

impl<'a> Runs<'a> {
    fn course<'b>(&self, inputs: &'b [Input<'a>]) -> Course<'b>
    where
        'a: 'b,
    {
        let Runs { times, samples, between, .. } = *self;
        Course { inputs, times, samples, between }
    }

    /// Whether no input moves within a step.
    fn are_held(&self) -> bool {
        self.between == Between::Held || self.inputs.iter().all(|rows| rows.width == 1)
    }
}

/// Brings an instance to the beginning of a run.
pub type Begin<'a> = &'a dyn Fn(usize, &mut Instance) -> Result<(), Ended>;

/// Why runs were not made side by side.
enum Not {
    /// They cannot be, or one of them does not come to its end.
    Together,
    Cancelled,
}

/// Workspace for runs of a model: nothing is allocated while they are made.
pub struct Worker<'a> {
    /// Rows of runs, and of samples of one.
    batch: Option<Batch>,
    samples: Option<Batch>,
    course: Vec<Input<'a>>,
    /// For each input, and for each result.
    tiles: [Vec<Tile>; 2],
}

/// Values of runs that are made together at some samples, sample after sample.
type Tile = [[f64; TOGETHER]; TILE];

impl<'a> Worker<'a> {
    /// Workspace for runs of a model.
    pub fn new(model: &'static ModelType, runs: &Runs<'a>, registers: Registers) -> Result<Worker<'a>, OutOfMemory> {
        let batch = Batch::new(model, registers, TOGETHER)?;
        let mut samples = if runs.samples < TOGETHER { None } else { Batch::new(model, registers, SAMPLES)? };
        samples.as_mut().map_or(Ok(()), Batch::make_room_to_relax)?;
        let course = memory::each(runs.inputs.iter(), |rows| Ok(Input { column: rows.column, samples: &[] }))?;
        let tiles = |columns: usize| memory::each(0..columns, |_| Ok([[0.0; TOGETHER]; TILE]));
        let tiles = [tiles(runs.inputs.len())?, tiles(runs.results.len())?];
        Ok(Worker { batch, samples, course, tiles })
    }

    /// The number of runs to be made in one call.
    pub fn together(model: &ModelType) -> usize {
        if model.kernels.is_some() { TOGETHER } else { 1 }
    }

    /// Makes some of the runs; where that leaves the instance is not said. `begin` brings the instance to the beginning of
    /// a run; `arrays` has a value per run and sample for each result, run after run. The first run that does not come to
    /// its end ends them all.
    pub fn make(
        &mut self,
        instance: &mut Instance,
        runs: &Runs<'a>,
        some: Range<usize>,
        begin: Begin,
        arrays: &mut [&mut [f64]],
        cancel: &AtomicBool,
    ) -> Result<(), (usize, Ended)> {
        // What goes wrong side by side is made again, for the text.
        match self.make_together(instance, runs, some.clone(), begin, arrays, cancel) {
            Ok(()) => return Ok(()),
            Err(Not::Together) => {}
            Err(Not::Cancelled) => return Err((some.start, Ended::Cancelled)),
        }
        self.make_alone(instance, runs, some, begin, arrays, cancel)
    }

    /// Makes runs by the steps of the instance, one after the other, which leaves it at the end of the last one.
    pub fn make_alone(
        &mut self,
        instance: &mut Instance,
        runs: &Runs<'a>,
        some: Range<usize>,
        begin: Begin,
        arrays: &mut [&mut [f64]],
        cancel: &AtomicBool,
    ) -> Result<(), (usize, Ended)> {
        for (number, run) in some.enumerate() {
            let done = begin(run, instance).and_then(|()| {
                set_course(&mut self.course, runs, run);
                let first = number * runs.samples;
                let course = runs.course(&self.course);
                series::follow_into(instance, &course, runs.results, arrays, first, cancel)
            });
            done.map_err(|ended| (run, ended))?;
        }
        Ok(())
    }

    /// Makes one run, all of whose results are outputs that do not depend on the steps before. False if they may.
    pub fn make_outputs(
        &mut self,
        instance: &mut Instance,
        runs: &Runs<'a>,
        begin: Begin,
        arrays: &mut [&mut [f64]],
        cancel: &AtomicBool,
    ) -> bool {
        let Some(mut batch) = self.samples.take() else { return false };
        let done = self.begin(instance, runs, 0, begin).is_ok_and(|is_memoryless| {
            is_memoryless
                && batch.load(0..SAMPLES, instance.row())
                && along(&mut batch, runs, 0, cancel, |batch, samples| read_outputs(batch, runs, arrays, samples))
                    .is_ok()
        });
        self.samples = Some(batch);
        done
    }

    /// Makes runs side by side, or the samples of each if no result depends on the steps before.
    fn make_together(
        &mut self,
        instance: &mut Instance,
        runs: &Runs<'a>,
        some: Range<usize>,
        begin: Begin,
        arrays: &mut [&mut [f64]],
        cancel: &AtomicBool,
    ) -> Result<(), Not> {
        if let Some(mut batch) = self.samples.take() {
            let done = self.make_samples(&mut batch, instance, runs, some.clone(), begin, arrays, cancel);
            self.samples = Some(batch);
            if let Some(done) = done {
                return done;
            }
        }
        let Some(mut batch) = self.batch.take() else { return Err(Not::Together) };
        let done = (|| {
            if some.len() == 1 {
                return Err(Not::Together);
            }
            let mut steps = false;
            for (place, run) in some.clone().enumerate() {
                steps |= !self.begin(instance, runs, run, begin)?;
                // Lanes without a run follow the last one.
                if !batch.load(place..TOGETHER, instance.row()) {
                    return Err(Not::Together);
                }
            }
            across(&mut batch, runs, &some, steps, &mut self.tiles, arrays, cancel)
        })();
        self.batch = Some(batch);
        done
    }

    /// Makes the samples of each run side by side. None if that cannot be done.
    #[allow(clippy::too_many_arguments, reason = "those of the caller")]
    fn make_samples(
        &mut self,
        batch: &mut Batch,
        instance: &mut Instance,
        runs: &Runs<'a>,
        some: Range<usize>,
        begin: Begin,
        arrays: &mut [&mut [f64]],
        cancel: &AtomicBool,
    ) -> Option<Result<(), Not>> {
        for (place, run) in some.clone().enumerate() {
            let is_memoryless = match self.begin(instance, runs, run, begin) {
                Ok(is_memoryless) => is_memoryless,
                Err(not) => return Some(Err(not)),
            };
            let mut chain =
                Chain::of(instance, runs).filter(|_| some.len() <= FEW && no_step_fails(instance, runs, &self.course));
            let is_loaded = (is_memoryless || chain.is_some()) && batch.load(0..SAMPLES, instance.row());
            if !is_loaded {
                return None;
            }
            let first = place * runs.samples;
            let done = along(batch, runs, run, cancel, |batch, samples| {
                let places = first + samples.start..first + samples.end;
                match &mut chain {
                    Some(chain) => chain.read(batch, runs, arrays, places, samples.end == runs.samples),
                    None => read_outputs(batch, runs, arrays, places),
                }
            });
            if done.is_err() {
                return Some(done);
            }
        }
        Some(Ok(()))
    }

    /// Brings the instance to the beginning of a run. Whether no result depends on the steps.
    fn begin(&mut self, instance: &mut Instance, runs: &Runs<'a>, run: usize, begin: Begin) -> Result<bool, Not> {
        begin(run, instance).map_err(|_| Not::Together)?;
        let Some(kernels) = instance.model().kernels.as_ref() else { return Err(Not::Together) };
        let table = &instance.model().table;
        let role = |column: &usize| table.role(*column);
        let is_input = runs.inputs.iter().all(|rows| role(&rows.column) == Role::Input);
        if !is_input || !instance.is_plain() || runs.results.iter().any(|column| table.at(*column).is_advice) {
            return Err(Not::Together);
        }
        set_course(&mut self.course, runs, run);
        series::check(instance, &runs.course(&self.course)).map_err(|_| Not::Together)?;
        let is_output = |column: &usize| !matches!(role(column), Role::State | Role::StateOutput);
        let fit = (kernels.fit)(instance.row());
        let is_memoryless =
            fit == Fit::Outputs && runs.results.iter().all(is_output) && no_step_fails(instance, runs, &self.course);
        if is_memoryless || fit != Fit::Alone && runs.are_held() && times_fit(runs) {
            Ok(is_memoryless)
        } else {
            Err(Not::Together)
        }
    }
}

fn set_course<'a>(course: &mut [Input<'a>], runs: &Runs<'a>, run: usize) {
    for (input, rows) in course.iter_mut().zip(runs.inputs) {
        input.samples = rows.row(run);
    }
}

/// Whether all steps are times that a row by itself would be advanced by.
fn times_fit(runs: &Runs) -> bool {
    let last = runs.samples.saturating_sub(1);
    let fits = |step: f64| step > 0.0 && step.is_finite();
    let all_fit = match runs.times {
        Times::Every(dt) => fits(dt),
        Times::At(_) => (0..last).all(|sample| fits(runs.times.step(sample))),
    };
    all_fit && runs.times.at(last).is_finite()
}

/// Whether a run that is made without its steps would not have ended in one of them: no slope and no energy comes near the
/// largest number, if no input, parameter or time does, and no state at the start.
fn no_step_fails(instance: &Instance, runs: &Runs, course: &[Input]) -> bool {
    let is_small = |value: &f64| value.abs() <= LARGE;
    let is_usual = |value: f64| value == 0.0 || (1.0 / LARGE..=LARGE).contains(&value.abs());
    let is_fine = |(column, value): (usize, &f64)| match instance.model().table.role(column) {
        Role::Fixed | Role::Tunable => is_usual(*value),
        Role::Input | Role::State | Role::StateOutput => is_small(value),
        Role::Output => true,
    };
    let steps_are_usual = match runs.times {
        Times::Every(dt) => is_usual(dt),
        Times::At(times) => times.windows(2).all(|pair| is_usual(pair[1] - pair[0])),
    };
    steps_are_usual
        && is_small(&runs.times.at(runs.samples.saturating_sub(1)))
        && instance.row().iter().enumerate().all(is_fine)
        && course.iter().all(|input| input.samples.iter().all(is_small))
}

/// Makes runs in lanes.
fn across(
    batch: &mut Batch,
    runs: &Runs,
    some: &Range<usize>,
    steps: bool,
    tiles: &mut [Vec<Tile>; 2],
    arrays: &mut [&mut [f64]],
    cancel: &AtomicBool,
) -> Result<(), Not> {
    let [inputs, results] = tiles;
    for rows in runs.inputs.iter().filter(|rows| rows.width == 1) {
        batch.set(rows.column, |place| rows.at((some.start + place).min(some.end - 1), 0));
    }
    for from in (0..runs.samples).step_by(TILE) {
        if cancel.load(Ordering::Relaxed) {
            return Err(Not::Cancelled);
        }
        let samples = from..runs.samples.min(from + TILE);
        gather(runs, some, samples.clone(), inputs);
        for (number, sample) in samples.clone().enumerate() {
            for (rows, tile) in runs.inputs.iter().zip(&*inputs).filter(|(rows, _)| rows.width > 1) {
                batch.set_from(rows.column, &tile[number]);
            }
            let mut is_finite = batch.output();
            for (column, tile) in runs.results.iter().zip(&mut *results) {
                batch.read(*column, &mut tile[number]);
            }
            if steps && sample + 1 < runs.samples {
                is_finite &= batch.advance(runs.times.step(sample));
            }
            if !is_finite {
                return Err(Not::Together);
            }
        }
        for (tile, array) in results.iter().zip(arrays.iter_mut()) {
            for place in 0..some.len() {
                let row = &mut array[place * runs.samples..][samples.clone()];
                row.iter_mut().zip(tile).for_each(|(value, values)| *value = values[place]);
            }
        }
    }
    Ok(())
}

/// Brings the values of inputs that move at some samples side by side; lanes without a run follow the last one.
fn gather(runs: &Runs, some: &Range<usize>, samples: Range<usize>, inputs: &mut [Tile]) {
    for (rows, tile) in runs.inputs.iter().zip(inputs).filter(|(rows, _)| rows.width > 1) {
        for place in 0..TOGETHER {
            let row = &rows.row((some.start + place).min(some.end - 1))[samples.clone()];
            row.iter().zip(&mut *tile).for_each(|(value, values)| values[place] = *value);
        }
    }
}

/// Drives a batch with a run, some samples at a time. `make` makes the results at these samples, and returns whether all
/// numbers are finite.
fn along(
    batch: &mut Batch,
    runs: &Runs,
    run: usize,
    cancel: &AtomicBool,
    mut make: impl FnMut(&mut Batch, Range<usize>) -> bool,
) -> Result<(), Not> {
    for rows in runs.inputs.iter().filter(|rows| rows.width == 1) {
        batch.fill(rows.column, rows.at(run, 0));
    }
    for from in (0..runs.samples).step_by(SAMPLES) {
        if from % PATIENCE == 0 && cancel.load(Ordering::Relaxed) {
            return Err(Not::Cancelled);
        }
        let samples = from..runs.samples.min(from + SAMPLES);
        for rows in runs.inputs.iter().filter(|rows| rows.width > 1) {
            batch.set_from(rows.column, &rows.row(run)[samples.clone()]);
        }
        if !make(batch, samples) {
            return Err(Not::Together);
        }
    }
    Ok(())
}

/// Writes results that do not depend on the samples before to these places. False if one is not finite.
fn read_outputs(batch: &mut Batch, runs: &Runs, arrays: &mut [&mut [f64]], places: Range<usize>) -> bool {
    let is_finite = batch.output();
    for (column, array) in runs.results.iter().zip(arrays.iter_mut()) {
        batch.read(*column, &mut array[places.clone()]);
    }
    is_finite
}

/// States that are all that a run carries from sample to sample: one that relaxes, and the energy.
struct Chain {
    state: usize,
    value: f64,
    /// If it is recorded.
    energy: Option<usize>,
    spent: f64,
    dt: f64,
}

impl Chain {
    /// That of a run at its beginning, if its law has a state that relaxes, and its results can be found so.
    fn of(instance: &Instance, runs: &Runs) -> Option<Chain> {
        let model = instance.model();
        let state = model.kernels.as_ref()?.relaxes?;
        let energy = model.table.of(Meaning::Energy).filter(|column| runs.results.contains(column));
        let Times::Every(dt) = runs.times else { return None };
        let row = instance.row();
        let spent = energy.map_or(0.0, |column| row[column]);
        runs.are_held().then_some(Chain { state, value: row[state], energy, spent, dt })
    }

    /// Writes results at some samples, whose inputs are there, to these places; `are_last` if no step follows. What a step
    /// does to the state, whatever that is, is found for all of them at once; then only that is left to be done one after
    /// the other. False if a number is not finite.
    fn read(
        &mut self,
        batch: &mut Batch,
        runs: &Runs,
        arrays: &mut [&mut [f64]],
        places: Range<usize>,
        are_last: bool,
    ) -> bool {
        let (mut values, mut value) = ([0.0; SAMPLES], self.value);
        batch.relax(self.dt, |place, relaxation| {
            values[place] = value;
            value = relaxation.after(value);
        });
        // Rows beyond the samples follow the last one, after which nothing comes.
        self.value = value;
        let values = &values[..places.len()];
        batch.set_from(self.state, values);
        let mut is_finite = batch.output();
        for (column, array) in runs.results.iter().zip(arrays.iter_mut()) {
            let places = &mut array[places.clone()];
            match *column {
                column if column == self.state => places.copy_from_slice(values),
                column if Some(column) == self.energy => {}
                column => batch.read(column, places),
            }
        }
        if let Some(energy) = self.energy {
            is_finite &= self.spend(batch, energy, runs, arrays, places, are_last);
        }
        is_finite
    }

    /// The energies at some samples: that of each step is added to that before. False if one is not finite.
    fn spend(
        &mut self,
        batch: &mut Batch,
        energy: usize,
        runs: &Runs,
        arrays: &mut [&mut [f64]],
        places: Range<usize>,
        are_last: bool,
    ) -> bool {
        let mut spent = [0.0; SAMPLES];
        let spent = &mut spent[..places.len()];
        batch.set_from(energy, &[0.0]);
        // The step after the last sample is not made.
        let is_finite = batch.advance(self.dt) || are_last;
        batch.read(energy, spent);
        for work in spent.iter_mut() {
            (*work, self.spent) = (self.spent, self.spent + *work);
        }
        for (column, array) in runs.results.iter().zip(arrays.iter_mut()) {
            if *column == energy {
                array[places.clone()].copy_from_slice(spent);
            }
        }
        is_finite && spent.iter().all(|value| value.is_finite())
    }
}
