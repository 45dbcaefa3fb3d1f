//! A model instance: its row, its time and the code that both C interfaces share.

use std::fmt;

use crate::consistency::{Consistency, Sample};
use crate::memory::{self, OutOfMemory};
use crate::model::{Brief, Computed, Fault, ModelType, Role, Variable};

pub use access::{Phase, Refused};
pub use events::Trial;
pub use snapshot::Snapshot;

mod access;
mod derivative;
mod events;
mod exchange;
mod slopes;
mod snapshot;
#[cfg(test)]
mod tests;

use derivative::Workspace;
use exchange::Exchange;
use slopes::Slopes;

/// A model instance.
pub struct Instance {
    model: &'static ModelType,
    row: Box<[f64]>,
    /// Memory of the model beside the row.
    memory: Box<[f64]>,
    slopes: Slopes,
    /// Whether a parameter has been set since the parameters were last checked against each other.
    unchecked: bool,
    /// The outputs that do not lag behind the other columns.
    computed: Computed,
    time: f64,
    // Workspace, so that no call allocates and rows of many elements do not fill the stack of a host.
    room: Box<[f64]>,
    rate: Box<[f64]>,
    duals: Workspace,
    /// Columns of the states that an importer may integrate itself; none if the model is for co-simulation only.
    continuous: Box<[usize]>,
    /// For Model Exchange.
    exchange: Option<Box<Exchange>>,
    /// For a model with a length and its time derivative as inputs.
    consistency: Option<Box<Consistency>>,
}

impl Instance {
    /// A model at its start values, at time 0, that makes steps. Panics if memory runs out; see [`Instance::try_new`].
    pub fn new(model: &'static ModelType) -> Instance {
        Instance::try_new(model).unwrap_or_else(|error| panic!("{error}"))
    }

    /// As [`Instance::new`], if there is memory for it.
    pub fn try_new(model: &'static ModelType) -> Result<Instance, OutOfMemory> {
        Instance::of(model, None)
    }

    /// A model at its start values, at time 0, whose states a solver integrates between events. Panics if memory runs
    /// out; see [`Instance::try_for_model_exchange`].
    pub fn for_model_exchange(model: &'static ModelType) -> Instance {
        Instance::try_for_model_exchange(model).unwrap_or_else(|error| panic!("{error}"))
    }

    /// As [`Instance::for_model_exchange`], if there is memory for it.
    pub fn try_for_model_exchange(model: &'static ModelType) -> Result<Instance, OutOfMemory> {
        Instance::of(model, Some(memory::boxed(Exchange::of(model)?)?))
    }

    fn of(model: &'static ModelType, exchange: Option<Box<Exchange>>) -> Result<Instance, OutOfMemory> {
        let columns = model.table.len();
        let is_continuous = |variable: &Variable| model.model_exchange && variable.is_continuous_state();
        let mut instance = Instance {
            model,
            row: memory::filled(0.0, columns)?,
            memory: memory::filled(0.0, model.memory)?,
            slopes: Slopes::none(columns)?,
            unchecked: true,
            computed: Computed::Nothing,
            time: 0.0,
            room: memory::filled(0.0, columns + model.memory)?,
            rate: memory::filled(0.0, columns)?,
            duals: Workspace::of(model)?,
            continuous: exchange::columns_of(model, is_continuous)?,
            exchange,
            consistency: Consistency::of(model).map(memory::boxed).transpose()?,
        };
        instance.reset();
        Ok(instance)
    }

    /// Resets to the start values and to time 0.
    pub fn reset(&mut self) {
        for (column, value) in self.row.iter_mut().enumerate() {
            *value = self.model.table.start(column);
        }
        self.memory.fill(0.0);
        self.slopes.clear();
        self.unchecked = true;
        self.computed = Computed::Nothing;
        if let Some(exchange) = &mut self.exchange {
            exchange.begin_event();
        }
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
    pub fn variable(&self, column: usize) -> Option<Variable> {
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

    /// Whether row and model alone determine what comes: the parameters fit together, and no slope waits for a step.
    pub(crate) fn is_plain(&self) -> bool {
        self.memory.is_empty() && self.uses_its_row_alone()
    }

    /// The same for a model with memory whose parameters ask for none.
    pub(crate) fn uses_its_row_alone(&self) -> bool {
        let has_more = self.exchange.is_some() || self.consistency.is_some() || self.model.memory_in_use(&self.row) > 0;
        !(has_more || self.unchecked || self.slopes.are_for_next_step())
    }

    /// Writes the values of the named preset; the other parameters get their start values. False if the preset does not
    /// exist.
    pub fn apply(&mut self, preset: &str) -> bool {
        let Some(preset) = self.model.presets.iter().find(|known| known.name == preset) else { return false };
        for (column, variable) in self.model.table.iter().enumerate() {
            if variable.role.is_parameter() {
                self.write(column, variable.start);
            }
        }
        for (name, value) in preset.values {
            if let Some(column) = self.model.find(name) {
                self.write(column, *value);
            }
        }
        true
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
            if self.exchange.as_ref().is_some_and(|exchange| exchange.is_between_events()) {
                self.refresh_between_events()?;
            } else {
                self.compute_outputs()?;
            }
        }
        if wanted > self.computed { self.compute_advice() } else { Ok(()) }
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
        if !(self.model.try_output)(&mut self.row, &mut self.memory, &mut self.room) {
            return Err(self.not_finite(format_args!("the outputs")));
        }
        self.computed = Computed::Main;
        Ok(())
    }

    /// Brings states, the energy apart, and outputs to where the present inputs lead them in the end, without a step. False,
    /// with nothing changed, if that has no closed form.
    pub fn slide_steadily(&mut self) -> Result<bool, Fault> {
        let is_held = self.exchange.is_none() && !self.slopes.are_for_next_step();
        if !(is_held && self.model.slides_steadily(&self.row)) {
            return Ok(false);
        }
        self.check()?;
        if !(self.model.try_slide_steadily)(&mut self.row, &mut self.memory, &mut self.room) {
            return Err(self.not_finite(format_args!("the outputs of steady sliding")));
        }
        self.slopes.clear();
        self.computed = Computed::Main;
        Ok(true)
    }

    /// Advances by `dt` > 0. If it fails, nothing has changed.
    #[inline(always)]
    pub fn step(&mut self, dt: f64) -> Result<(), Fault> {
        // The usual step has held inputs and unchanged parameters.
        if self.unchecked || !self.slopes.are_none() || !(dt > 0.0 && self.time + dt < f64::INFINITY) {
            return self.step_with_care(dt);
        }
        if !(self.model.try_advance)(&mut self.row, &mut self.memory, &mut self.room, dt) {
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

    /// The same, or else a warning about parameters with which the model is not passive.
    pub fn warning_or_passivity(&self) -> Option<Fault> {
        self.warning().or_else(|| self.model.passivity(&self.row))
    }

    fn check_step(&self, dt: f64) -> Result<(), Fault> {
        let time = self.time;
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(Fault::new(format_args!("a step of {} s: must be > 0 and finite", Brief(dt))));
        }
        if !(time + dt).is_finite() {
            return Err(Fault::new(format_args!("a step of {dt} s from {time} s: the time must stay finite")));
        }
        Ok(())
    }

    #[inline(never)]
    fn step_with_care(&mut self, dt: f64) -> Result<(), Fault> {
        self.check_step(dt)?;
        self.check()?;
        let sample = self.sample(dt);
        let finite = if self.slopes.are_for_next_step() {
            self.check_ramps(dt)?;
            (self.model.try_advance_ramp)(&mut self.row, &mut self.memory, &mut self.room, self.slopes.values(), dt)
        } else {
            (self.model.try_advance)(&mut self.row, &mut self.memory, &mut self.room, dt)
        };
        if !finite {
            return Err(self.step_not_finite(dt));
        }
        self.observe(sample);
        self.slopes.use_up();
        self.computed = Computed::Main;
        self.time += dt;
        Ok(())
    }

    /// Rejects slopes that lead an input out of its bounds within the step, apart from rounding.
    fn check_ramps(&self, dt: f64) -> Result<(), Fault> {
        for (column, slope) in self.slopes.values().iter().enumerate().filter(|(_, slope)| **slope != 0.0) {
            let (variable, start, change) = (&self.model.table.at(column), self.row[column], slope * dt);
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
        let limit = (self.model.check_motion)(&self.row).and_then(|()| (self.model.check_step)(&self.row, dt));
        self.not_finite_by(limit, format_args!("a step of {dt} s"))
    }

    #[cold]
    fn not_finite(&self, what: fmt::Arguments) -> Fault {
        self.not_finite_by((self.model.check_motion)(&self.row), what)
    }

    fn not_finite_by(&self, limit: Result<(), Fault>, what: fmt::Arguments) -> Fault {
        let inputs = Inputs(self);
        match limit {
            Ok(()) => Fault::new(format_args!("{what} would not be finite{inputs}: nothing was changed")),
            Err(limit) => Fault::new(format_args!("{what} would not be finite{inputs}: {limit}: nothing was changed")),
        }
    }
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
