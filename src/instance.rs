//! A model instance: its row, its time and the code that both C interfaces share.

use std::fmt;

use crate::consistency::{Consistency, Sample};
use crate::memory::{self, OutOfMemory};
use crate::model::{Brief, Computed, Fault, ModelType, Role, Variable};
use crate::number::Dual;

/// A model instance.
pub struct Instance {
    model: &'static ModelType,
    row: Box<[f64]>,
    /// Memory of the model beside the row.
    memory: Box<[f64]>,
    /// Slopes of the inputs over the next step or, after it, over the step just made.
    slope: Box<[f64]>,
    /// Whether the slopes belong to the next step. They are given for one step and then used up.
    slopes_are_new: bool,
    /// Whether a slope is nonzero.
    has_slopes: bool,
    /// Whether a parameter has been set since the parameters were last checked against each other.
    unchecked: bool,
    /// The outputs that do not lag behind the other columns.
    computed: Computed,
    time: f64,
    // Workspace, so that no call allocates and rows of many elements do not fill the stack of a host.
    room: Box<[f64]>,
    rate: Box<[f64]>,
    duals: Box<[Dual]>,
    rate_duals: Box<[Dual]>,
    memory_rate: Box<[f64]>,
    memory_duals: Box<[Dual]>,
    /// Columns of the states that an importer may integrate itself; none if the model is for co-simulation only.
    continuous: Box<[usize]>,
    // Columns of the results that jump, and their present values; an importer that integrates sees those of the last
    // event.
    jumping: Box<[usize]>,
    latest: Box<[f64]>,
    latest_is_known: bool,
    is_between_events: bool,
    /// For a model with a length and its time derivative as inputs.
    consistency: Option<Box<Consistency>>,
}

/// Everything that changes in an [`Instance`] during its life.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The row. Advice, which follows from the rest, has its start values.
    pub row: Box<[f64]>,
    /// Memory of the model beside the row.
    pub memory: Box<[f64]>,
    /// Slopes of the inputs.
    pub slope: Box<[f64]>,
    /// See [`Instance`].
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
            self.row[column] = model.table[column].start;
        }
    }
}

impl Instance {
    /// A model at its start values, at time 0. Panics if memory runs out; see [`Instance::try_new`].
    pub fn new(model: &'static ModelType) -> Instance {
        Instance::try_new(model).unwrap_or_else(|error| panic!("{error}"))
    }

    /// A model at its start values, at time 0, if there is memory for it.
    pub fn try_new(model: &'static ModelType) -> Result<Instance, OutOfMemory> {
        let columns = model.table.len();
        let jumping = columns_of(model, |variable| variable.role.is_computed() && variable.jumps)?;
        let mut instance = Instance {
            model,
            row: memory::filled(0.0, columns)?,
            memory: memory::filled(0.0, model.memory)?,
            slope: memory::filled(0.0, columns)?,
            slopes_are_new: false,
            has_slopes: false,
            unchecked: true,
            computed: Computed::Nothing,
            time: 0.0,
            room: memory::filled(0.0, columns + model.memory)?,
            rate: memory::filled(0.0, columns)?,
            duals: memory::filled(Dual::default(), columns)?,
            rate_duals: memory::filled(Dual::default(), columns)?,
            memory_rate: memory::filled(0.0, model.memory)?,
            memory_duals: memory::filled(Dual::default(), model.memory)?,
            continuous: columns_of(model, |variable| variable.is_continuous_state())?,
            latest: memory::filled(0.0, jumping.len())?,
            latest_is_known: false,
            jumping,
            is_between_events: false,
            consistency: Consistency::of(model).map(memory::boxed).transpose()?,
        };
        instance.reset();
        Ok(instance)
    }

    /// Resets to the start values and to time 0.
    pub fn reset(&mut self) {
        for (value, variable) in self.row.iter_mut().zip(self.model.table) {
            *value = variable.start;
        }
        self.memory.fill(0.0);
        self.clear_slopes();
        self.slopes_are_new = false;
        self.unchecked = true;
        self.computed = Computed::Nothing;
        self.is_between_events = false;
        if let Some(consistency) = &mut self.consistency {
            consistency.begin();
        }
        self.time = 0.0;
    }

    /// The model.
    pub fn model(&self) -> &'static ModelType {
        self.model
    }

    /// Replaces the model by the same one at another address.
    pub fn set_model(&mut self, model: &'static ModelType) {
        self.model = model;
    }

    /// The variable of a column, if the column exists.
    #[inline]
    pub fn variable(&self, column: usize) -> Option<&'static Variable> {
        self.model.table.get(column)
    }

    /// Present time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Sets the present time.
    pub fn set_time(&mut self, time: f64) {
        self.time = time;
    }

    /// All values. Outputs may lag behind, and advice does after every step: see [`Instance::refresh`] and
    /// [`Instance::get`].
    #[inline]
    pub fn row(&self) -> &[f64] {
        &self.row
    }

    /// Writes a column without a check. Check with [`Variable::admits`] first: a refused value must change nothing.
    #[inline]
    pub fn put(&mut self, column: usize, value: f64) {
        self.row[column] = value;
        self.computed = Computed::Nothing;
        self.unchecked |= self.model.table[column].role.is_parameter();
    }

    /// The row, for a caller that writes admitted values into columns that may be set; `parameters`: including
    /// parameters.
    #[inline(always)]
    pub fn row_to_set(&mut self, parameters: bool) -> &mut [f64] {
        self.computed = Computed::Nothing;
        self.unchecked |= parameters;
        &mut self.row
    }

    /// Writes the values of the named preset; the other parameters get their start values. False if the preset does not
    /// exist.
    pub fn apply(&mut self, preset: &str) -> bool {
        let Some(preset) = self.model.presets.iter().find(|known| known.name == preset) else { return false };
        for (column, variable) in self.model.table.iter().enumerate() {
            if variable.role.is_parameter() {
                self.put(column, variable.start);
            }
        }
        for (name, value) in preset.values {
            if let Some(column) = self.model.find(name) {
                self.put(column, *value);
            }
        }
        true
    }

    /// Gives an input a slope over the next step.
    pub fn put_slope(&mut self, column: usize, slope: f64) {
        if !self.slopes_are_new {
            self.clear_slopes();
        }
        self.slopes_are_new = true;
        self.has_slopes = true;
        self.slope[column] = slope;
    }

    fn clear_slopes(&mut self) {
        self.slope.fill(0.0);
        self.has_slopes = false;
    }

    /// Rejects parameters that are admitted one by one but not together.
    #[inline]
    pub fn check(&mut self) -> Result<(), Fault> {
        if self.unchecked {
            self.model.check(&self.row)?;
            self.unchecked = false;
        }
        Ok(())
    }

    /// The outputs that do not lag behind the other columns.
    #[inline(always)]
    pub fn computed(&self) -> Computed {
        self.computed
    }

    /// Makes all outputs follow the other columns.
    #[inline]
    pub fn refresh(&mut self) -> Result<(), Fault> {
        self.refresh_to(Computed::All)
    }

    /// Makes these outputs follow the other columns.
    #[inline]
    pub fn refresh_to(&mut self, wanted: Computed) -> Result<(), Fault> {
        if wanted > Computed::Nothing && self.computed == Computed::Nothing {
            if self.is_between_events {
                self.refresh_between_events()?;
            } else {
                self.compute_outputs()?;
            }
        }
        if wanted > self.computed { self.compute_advice() } else { Ok(()) }
    }

    /// The value of a column, computed first if it is an output that lags behind. An error if it would not be finite.
    #[inline]
    pub fn get(&mut self, column: usize) -> Result<f64, Fault> {
        self.refresh_to(self.model.table[column].needs())?;
        Ok(self.row[column])
    }

    /// Computes the advice that belongs to the other columns, even if other outputs lag behind.
    pub fn compute_advice(&mut self) -> Result<(), Fault> {
        if !self.model.try_advise(&mut self.row, &mut self.room) {
            return Err(self.not_finite(format_args!("the advice")));
        }
        if self.computed == Computed::Main {
            self.computed = Computed::All;
        }
        Ok(())
    }

    #[inline]
    fn compute_outputs(&mut self) -> Result<(), Fault> {
        if !self.model.try_output(&mut self.row, &mut self.memory, &mut self.room) {
            return Err(self.not_finite(format_args!("the outputs")));
        }
        self.computed = Computed::Main;
        Ok(())
    }

    /// Results that jump keep their values.
    fn refresh_between_events(&mut self) -> Result<(), Fault> {
        self.latest_is_known = false;
        for (value, column) in self.latest.iter_mut().zip(&self.jumping) {
            *value = self.row[*column];
        }
        self.compute_outputs()?;
        for (value, column) in self.latest.iter_mut().zip(&self.jumping) {
            std::mem::swap(value, &mut self.row[*column]);
        }
        self.latest_is_known = true;
        Ok(())
    }

    /// Rejects a saved state that only events of Model Exchange can produce, for an instance that continues with steps.
    pub fn check_without_events(&self, snapshot: &Snapshot) -> Result<(), Fault> {
        let mut columns = self.model.table.iter().zip(&snapshot.row);
        columns.try_for_each(|(variable, value)| variable.check_without_events(*value))
    }

    /// From here to the next event the results that jump keep their values.
    pub fn leave_event(&mut self) -> Result<(), Fault> {
        self.refresh_to(Computed::Main)?;
        self.go_on_between_events();
        Ok(())
    }

    /// As [`Instance::leave_event`], for a state that was saved after it.
    pub fn go_on_between_events(&mut self) {
        self.is_between_events = true;
        self.latest_is_known = false;
    }

    /// Sets all results to their present values.
    pub fn enter_event(&mut self) {
        self.is_between_events = false;
        self.computed = Computed::Nothing;
    }

    /// Whether an event would change results.
    pub fn wants_event(&mut self) -> Result<bool, Fault> {
        if !self.is_between_events {
            return Ok(false);
        }
        if self.computed == Computed::Nothing || !self.latest_is_known {
            self.refresh_between_events()?;
        }
        Ok(self.jumping.iter().zip(&self.latest).any(|(column, value)| self.row[*column] != *value))
    }

    /// Advances by `dt` > 0. If it fails, nothing has changed.
    #[inline(always)]
    pub fn step(&mut self, dt: f64) -> Result<(), Fault> {
        // The usual step has held inputs and unchanged parameters.
        if self.unchecked || self.has_slopes || !(dt > 0.0 && self.time + dt < f64::INFINITY) {
            return self.step_with_care(dt);
        }
        if !self.model.try_advance(&mut self.row, &mut self.memory, &mut self.room, dt) {
            return Err(self.step_not_finite(dt));
        }
        // The inputs of a held step are still those of its beginning.
        self.observe(self.sample(dt));
        self.computed = Computed::Main;
        self.time += dt;
        Ok(())
    }

    #[inline(always)]
    fn sample(&self, dt: f64) -> Option<Sample> {
        self.consistency.as_ref().map(|consistency| consistency.sample(&self.row, dt))
    }

    #[inline(always)]
    fn observe(&mut self, sample: Option<Sample>) {
        if let Some((consistency, sample)) = self.consistency.as_mut().zip(sample) {
            consistency.observe(sample);
        }
    }

    /// Warning about values that were accepted although they make no sense.
    pub fn warning(&self) -> Option<Fault> {
        let of_steps = || self.consistency.as_ref()?.warning();
        self.model.warning(&self.row).or_else(of_steps)
    }

    #[inline(never)]
    fn step_with_care(&mut self, dt: f64) -> Result<(), Fault> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(Fault::new(format_args!("a step of {dt} s: must be > 0 and finite")));
        }
        if !(self.time + dt).is_finite() {
            let time = self.time;
            return Err(Fault::new(format_args!("a step of {dt} s from {time} s: the time must stay finite")));
        }
        self.check()?;
        let sample = self.sample(dt);
        let finite = if self.slopes_are_new {
            self.check_ramps(dt)?;
            self.model.try_advance_ramp(&mut self.row, &mut self.memory, &mut self.room, &self.slope, dt)
        } else {
            self.model.try_advance(&mut self.row, &mut self.memory, &mut self.room, dt)
        };
        if !finite {
            return Err(self.step_not_finite(dt));
        }
        self.observe(sample);
        if !self.slopes_are_new {
            self.clear_slopes();
        }
        self.slopes_are_new = false;
        self.computed = Computed::Main;
        self.time += dt;
        Ok(())
    }

    /// Rejects slopes that lead an input out of its bounds within the step, apart from rounding.
    fn check_ramps(&self, dt: f64) -> Result<(), Fault> {
        for (column, slope) in self.slope.iter().enumerate().filter(|(_, slope)| **slope != 0.0) {
            let (variable, start, change) = (&self.model.table[column], self.row[column], slope * dt);
            let end = start + change;
            let rounding = 4.0 * f64::EPSILON * (start.abs() + change.abs());
            let is_outside = (end - variable.bound.nearest(end)).abs() > rounding;
            if is_outside || !end.is_finite() {
                return Err(Fault::new(format_args!("at the end of its ramp {}", variable.fault(end))));
            }
        }
        Ok(())
    }

    #[cold]
    fn step_not_finite(&self, dt: f64) -> Fault {
        self.not_finite(format_args!("a step of {dt} s"))
    }

    #[cold]
    fn not_finite(&self, what: fmt::Arguments) -> Fault {
        let inputs = Inputs(self);
        match self.model.check_motion(&self.row) {
            Ok(()) => Fault::new(format_args!("{what} would not be finite{inputs}: nothing was changed")),
            Err(limit) => Fault::new(format_args!("{what} would not be finite{inputs}: {limit}: nothing was changed")),
        }
    }

    /// Columns of the states that an importer may integrate itself, in the order of the table.
    pub fn continuous_states(&self) -> &[usize] {
        &self.continuous
    }

    /// Writes the states, whatever their bounds: a solver may try values beyond them on its way to a result.
    pub fn put_states(&mut self, values: &[f64]) {
        for (column, value) in self.continuous.iter().zip(values) {
            self.row[*column] = *value;
        }
        self.computed = Computed::Nothing;
    }

    /// Computes the time derivatives of the states, for [`Instance::rates`].
    pub fn compute_rates(&mut self) -> Result<(), Fault> {
        self.find_rates();
        if self.continuous.iter().all(|column| self.rate[*column].is_finite()) {
            Ok(())
        } else {
            Err(self.not_finite(format_args!("the derivatives")))
        }
    }

    fn find_rates(&mut self) {
        let in_use = self.model.memory_in_use(&self.row);
        let (memory, memory_rate) = (&self.memory[..in_use], &mut self.memory_rate[..in_use]);
        self.model.rate_with(&self.row, memory, &mut self.rate, memory_rate);
    }

    /// Time derivatives of the states, in the columns of the states: read them right after [`Instance::compute_rates`],
    /// because other calls reuse this workspace.
    pub fn rates(&self) -> &[f64] {
        &self.rate
    }

    /// Writes the event indicators.
    pub fn indicate(&self, indicators: &mut [f64]) -> Result<(), Fault> {
        self.model.indicate(&self.row, indicators);
        if indicators.iter().all(|indicator| indicator.is_finite()) {
            Ok(())
        } else {
            Err(self.not_finite(format_args!("the event indicators")))
        }
    }

    /// Changes whatever changes at events only. True if that includes a continuous state.
    pub fn at_event(&mut self) -> Result<bool, Fault> {
        self.rate.copy_from_slice(&self.row);
        if !self.model.try_at_event(&mut self.row, &mut self.memory, &mut self.room) {
            return Err(self.not_finite(format_args!("the states after an event")));
        }
        self.computed = Computed::Nothing;
        Ok(self.continuous.iter().any(|column| self.rate[*column] != self.row[*column]))
    }

    /// Derivative of the time derivative of each state in the direction given by `seeds`; exact. For Model Exchange.
    pub fn rate_derivative(&mut self, seeds: impl Iterator<Item = (usize, f64)>) -> &[Dual] {
        self.seed(seeds);
        self.model.rate_dual(&self.duals, &mut self.rate_duals);
        &self.rate_duals
    }

    /// Results of the last [`Instance::derivative`] or [`Instance::rate_derivative`].
    pub fn last_derivatives(&self) -> (&[Dual], &[Dual]) {
        (&self.duals, &self.rate_duals)
    }

    /// The values as dual numbers, without slopes.
    fn spread(&mut self) {
        for (dual, value) in self.duals.iter_mut().zip(&self.row) {
            *dual = Dual::from(*value);
        }
        let in_use = self.model.memory_in_use(&self.row);
        for (dual, value) in self.memory_duals.iter_mut().zip(&self.memory[..in_use]) {
            *dual = Dual::from(*value);
        }
    }

    fn find_dual_outputs(&mut self) -> &[Dual] {
        let in_use = self.model.memory_in_use(&self.row);
        self.model.output_dual_with(&mut self.duals, &self.memory_duals[..in_use]);
        &self.duals
    }

    fn seed(&mut self, seeds: impl Iterator<Item = (usize, f64)>) {
        self.spread();
        for (column, component) in seeds {
            self.duals[column].slope += component;
        }
    }

    /// Derivative of each column in the direction given by `seeds` (column, component); exact.
    pub fn derivative(&mut self, seeds: impl Iterator<Item = (usize, f64)>) -> &[Dual] {
        self.seed(seeds);
        self.find_dual_outputs()
    }

    /// Derivative of each column with respect to time at the present instant; exact.
    pub fn time_derivative(&mut self) -> &[Dual] {
        self.spread();
        self.find_rates();
        for ((dual, rate), slope) in self.duals.iter_mut().zip(&self.rate).zip(&self.slope) {
            dual.slope = rate + slope;
        }
        for (dual, rate) in self.memory_duals.iter_mut().zip(&self.memory_rate) {
            dual.slope = *rate;
        }
        self.find_dual_outputs()
    }

    /// Writes everything that changes into a snapshot made by [`Instance::save`] of the same model.
    pub fn save_into(&self, snapshot: &mut Snapshot) {
        snapshot.row.copy_from_slice(&self.row);
        snapshot.memory.copy_from_slice(&self.memory);
        snapshot.slope.copy_from_slice(&self.slope);
        snapshot.slopes_are_new = self.slopes_are_new;
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
            slope: memory::copied(&self.slope)?,
            slopes_are_new: self.slopes_are_new,
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
        self.slope.copy_from_slice(&snapshot.slope);
        self.slopes_are_new = snapshot.slopes_are_new;
        self.has_slopes = true;
        self.unchecked = true;
        self.is_between_events = false;
        if let Some(consistency) = &mut self.consistency {
            consistency.give_up();
        }
        self.computed = if snapshot.stale { Computed::Nothing } else { Computed::Main };
        self.time = snapshot.time;
    }
}

/// Columns that matter to an importer that integrates the states itself.
fn columns_of(model: &ModelType, is_wanted: fn(&Variable) -> bool) -> Result<Box<[usize]>, OutOfMemory> {
    let columns = || (0..model.table.len()).filter(|column| model.model_exchange && is_wanted(&model.table[*column]));
    let mut wanted = memory::filled(0, columns().count())?;
    for (place, column) in wanted.iter_mut().zip(columns()) {
        *place = column;
    }
    Ok(wanted)
}

/// The inputs and their values, as a message names them.
struct Inputs<'a>(&'a Instance);

impl fmt::Display for Inputs<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let columns = self.0.model.table.iter().zip(&self.0.row);
        for (index, (variable, value)) in columns.filter(|(variable, _)| variable.role == Role::Input).enumerate() {
            let before = if index == 0 { " at" } else { "," };
            write!(f, "{before} {} = {}", variable.path, Brief(*value))?;
        }
        Ok(())
    }
}
