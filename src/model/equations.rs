//! Traits of a model: its row, its equations, how it moves in time.

use std::ffi::CStr;
use std::ops::Range;

use super::{Bonds, Evaluate, GivesBack, Kernels, Visitor};
use crate::reference::References;
use crate::table::{Fault, Ports, Table, Variable};

/// Number of columns of a field in a `model!` block: one for a number, those of its table for a part.
pub trait Width {
    /// Number of columns.
    const WIDTH: usize;
}

impl Width for f64 {
    const WIDTH: usize = 1;
}

impl<P: Width, const N: usize> Width for [P; N] {
    const WIDTH: usize = N * P::WIDTH;
}

/// A struct of columns: a model, or a part that models contain. Implemented by [`model!`](crate::model!) and
/// [`part!`](crate::part!).
///
/// # Safety
/// The type must be `#[repr(C)]` and consist of exactly `TABLE.len()` numbers, because rows are viewed as this type.
pub unsafe trait Columns: Copy + Width {
    /// The table: one entry per number, in the order of the fields.
    const TABLE: &'static [Variable];
}

/// A struct of numbers of one type: a model or a part in that number type. Implemented by [`part!`](crate::part!).
///
/// # Safety
/// The type must be `#[repr(C)]` and consist only of `Number`s, because numbers are viewed as this type.
pub unsafe trait Numbers: Copy {
    /// Type of the numbers.
    type Number: Copy;
}

/// The text of a model: the part of its doc comments that `model!` uses.
///
/// # Safety
/// `In<T>` must be the same struct in another number: `#[repr(C)]`, with a `T` for each f64.
pub unsafe trait Described: Columns {
    /// Name, also FMI's modelIdentifier.
    const NAME: &'static str;
    /// The name, for C.
    const C_NAME: &'static CStr;
    /// One line.
    const SUMMARY: &'static str;
    /// The documentation page, in Markdown.
    const DOCUMENTATION: &'static str;
    /// The table, as the library keeps it.
    const COLUMNS: Table;
    /// The facts about the columns that get and set need on every step.
    const PORTS: Ports;
    /// The numbers by which FMI and C know the columns.
    const REFERENCES: References;
    /// The same model in another number, such as dual numbers for exact derivatives.
    type In<T: Evaluate>: Law<Number = T>;
}

/// The equations of a model, written once for every number type.
pub trait Law: Numbers {
    /// Whether an importer may integrate the continuous states itself: [`ModelExchange`] or [`CoSimulation`].
    type Interface: Interface<Self>;

    /// Computes the [`Role::Output`](crate::table::Role::Output) columns from the others, except advice.
    fn output(&mut self);

    /// Brings the states, the energy apart, to where held inputs lead them in the end. The outputs after it are those of
    /// steady sliding or, at rest, of what the contact still holds. For a law with [`Model::STEADY_SLIDING`].
    #[inline(always)]
    fn slide_steadily(&mut self) {}

    /// [`Law::slide_steadily`] of a model with memory.
    #[inline(always)]
    fn slide_steadily_with(&mut self, _memory: &mut [Self::Number]) {
        self.slide_steadily();
    }

    /// Largest force without its viscous part, relative to the static level, of a law whose curve exceeds that.
    #[inline(always)]
    fn overshoot(&self) -> Option<Self::Number> {
        None
    }

    /// Computes the outputs that are [advice](crate::table::Column::advice), from the columns that are not outputs.
    fn advise(&mut self) {}

    /// Number of values of its [`Model::MEMORY`] that the model uses with its present parameters.
    #[inline(always)]
    fn memory_in_use(&self) -> usize {
        0
    }

    /// [`Law::output`] of a model with memory; like the other functions with memory, it gets the part in use.
    #[inline(always)]
    fn output_with(&mut self, _memory: &[Self::Number]) {
        self.output();
    }
}

/// The rates of the continuous states, written once for every number type. A model offered for Model Exchange does not
/// compile without them:
///
/// ```compile_fail,E0277
/// use stribeck::model::{Law, Model, ModelExchange, real};
/// use stribeck::number::Real;
///
/// stribeck::model! {
///     /// Distance, without its rate.
///     Odometer: "Distance" {
///         /// Velocity.
///         velocity: input = real("m/s", 0.0),
///         /// Distance.
///         distance: state_output = real("m", 0.0),
///     }
/// }
///
/// impl<T: Real> Law for Odometer<T> {
///     type Interface = ModelExchange; // `CoSimulation` compiles
///
///     fn output(&mut self) {}
/// }
///
/// impl Model for Odometer {
///     fn step(&mut self, dt: f64) {
///         self.distance += self.velocity * dt;
///     }
/// }
/// ```
pub trait Derivatives: Law {
    /// Writes the time derivatives of the continuous states into their columns of `rate`.
    fn derivatives(&self, rate: &mut Self);

    /// [`Law::output`] and [`Derivatives::derivatives`], without memory. To be overridden if both need the same costly
    /// term: compilers do not find it where a law has branches.
    #[inline(always)]
    fn output_and_derivatives(&mut self, rate: &mut Self) {
        self.output_with(&[]);
        self.derivatives(rate);
    }
}

/// Interface type of FMI for which a model is offered beside its steps.
pub trait Interface<M> {
    /// Whether it is Model Exchange.
    const IS_MODEL_EXCHANGE: bool;

    /// Whether a solver that keeps the past of a model, and follows its bonds, finds the rates of all its states.
    const HAS_RATES: bool;

    /// Writes the time derivatives of the continuous states into their columns of `rate`, if there are any.
    fn rates(model: &M, rate: &mut M);

    /// Writes the outputs, advice apart, of a model without memory, and what [`Interface::rates`] writes.
    fn outputs_and_rates(model: &mut M, rate: &mut M);
}

/// A model whose continuous states may be integrated by an importer. They move only by their [`Derivatives`], and the
/// rest of the state either has no effect or changes only in [`Model::at_event`].
pub enum ModelExchange {}

impl<M: Derivatives> Interface<M> for ModelExchange {
    const IS_MODEL_EXCHANGE: bool = true;
    const HAS_RATES: bool = true;

    #[inline(always)]
    fn rates(model: &M, rate: &mut M) {
        model.derivatives(rate);
    }

    #[inline(always)]
    fn outputs_and_rates(model: &mut M, rate: &mut M) {
        model.output_and_derivatives(rate);
    }
}

/// A model as for [`ModelExchange`], but for a [`Past`] that no importer gives, or for [`Bonds`] that snap too often for the
/// events of an importer: for co-simulation, and for solvers that follow them.
pub enum WithHistory {}

impl<M: Derivatives> Interface<M> for WithHistory {
    const IS_MODEL_EXCHANGE: bool = false;
    const HAS_RATES: bool = true;

    #[inline(always)]
    fn rates(model: &M, rate: &mut M) {
        model.derivatives(rate);
    }

    #[inline(always)]
    fn outputs_and_rates(model: &mut M, rate: &mut M) {
        model.output_and_derivatives(rate);
    }
}

/// Past of a quantity, which a model follows a time lag later.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Past {
    /// The time lag in s; without one the quantity itself is followed.
    pub lag: f64,
    /// Present value of the quantity.
    pub now: f64,
    /// Value before the model began to remember.
    pub before: f64,
    /// Whether it remembers: without a load it has no past.
    pub is_kept: bool,
    /// Whether, until the next event, the quantity keeps its present value and no rate depends on its past.
    pub rests: bool,
}

/// A model that only its own steps advance.
pub enum CoSimulation {}

impl<M: Law> Interface<M> for CoSimulation {
    const IS_MODEL_EXCHANGE: bool = false;
    const HAS_RATES: bool = false;

    #[inline(always)]
    fn rates(_model: &M, _rate: &mut M) {}

    #[inline(always)]
    fn outputs_and_rates(model: &mut M, _rate: &mut M) {
        model.output_with(&[]);
    }
}

/// Whether a model is offered for Model Exchange.
pub(crate) const fn is_for_exchange<M: Law>() -> bool {
    <M::Interface as Interface<M>>::IS_MODEL_EXCHANGE
}

/// A named set of parameter values with its source.
#[derive(Debug, PartialEq)]
pub struct Preset {
    /// Name, in lower case with underscores.
    pub name: &'static str,
    /// One line: the source of the values. A set without a source begins with "Example".
    pub source: &'static str,
    /// Variables and their values; the other parameters get their start values.
    pub values: &'static [(&'static str, f64)],
}

/// Whether a table has a state that events settle.
const fn is_settled_by_events(table: &[Variable]) -> bool {
    let (mut found, mut column) = (false, 0);
    while column < table.len() {
        found |= table[column].is_settled_by_events();
        column += 1;
    }
    found
}

/// Fault of a model that [`Model::check_without_events`] rejects.
pub(crate) fn rests_at_events() -> Fault {
    Fault::new(format_args!("comes to rest at an event; without events it would never stick"))
}

/// The part of a model beside its table: how it moves in time.
pub trait Model: Described + Law<Number = f64> {
    /// Number of event indicators.
    const EVENT_INDICATORS: usize = 0;

    /// Whether each rate is linear in its own state, and the power in all of them: ramps then need fewer of them.
    const LINEAR: bool = false;

    /// Whether rates and outputs, energy and power apart, are linear in states and inputs between events, as long as a
    /// normal force does not move. For a solver that makes use of it and checks it.
    const PIECEWISE_LINEAR: bool = false;

    /// Named parameter sets.
    const PRESETS: &'static [Preset] = &[];

    /// Values that an instance keeps beside the row: the part of the state that is too long for a table, such as the
    /// elements of a law that can have a thousand. They have no variables. They are 0 at the start, and saved and
    /// restored with the row.
    const MEMORY: usize = 0;

    /// Whether the law has steady sliding in closed form: [`Law::slide_steadily`].
    const STEADY_SLIDING: bool = false;

    /// The functions of a law that runs on several rows at once.
    const KERNELS: Option<Kernels> = None;

    /// Whether there are idle columns: hidden states that nothing uses with the present parameters, such as the memory
    /// of a law that was not chosen. Steps and outputs must not change them; in return, they cost nothing.
    const HAS_IDLE: bool = false;

    /// [`Model::step_ramp`] with an error of 1e-6 of each state, which is enough to compare the force with a measured
    /// one. For models that integrate their rates: moving inputs cost them no more than held ones.
    const COARSE_RAMP: Option<fn(&mut Self, &Self, f64)> = None;

    /// The idle columns, in order, of a model that has some.
    #[inline(always)]
    fn idle(&self) -> [Range<usize>; 2] {
        [const { Self::TABLE.len()..Self::TABLE.len() }; 2]
    }

    /// Whether outputs after [`Law::slide_steadily`] are those at held inputs in the end, whatever the inputs. By default
    /// if the law has [`Model::STEADY_SLIDING`].
    #[inline(always)]
    fn slides_steadily(&self) -> bool {
        Self::STEADY_SLIDING
    }

    /// Rejects parameters that are admitted one by one but not together.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Warning about values that are accepted although they make no sense here, such as an unconnected input at 0. The
    /// log of an FMU reports each text once; `stribeck_warning` returns it as long as it holds.
    fn warning(&self) -> Option<Fault> {
        None
    }

    /// Names the parameter with which the law can give back more energy than it took from a motion at constant load, and
    /// the value that would keep it passive. None for a law that always is passive, or never: its page says which.
    fn passivity(&self) -> Option<GivesBack> {
        None
    }

    /// Rejects inputs for which the equations give no number; called if a result is not finite, to name the limit.
    fn check_motion(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Rejects a step in which there is too much to do; called if its result is not finite, to name the limit.
    fn check_step(&self, _dt: f64) -> Result<(), Fault> {
        Ok(())
    }

    /// Rejects parameters with which the model is for co-simulation only.
    fn check_model_exchange(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Rejects parameters with which the model comes to rest at events only: with a solver that has none it would never
    /// stick. By default a model with a state that events settle does.
    fn check_without_events(&self) -> Result<(), Fault> {
        // Answered when it is compiled: a table that is read at run time would be in the library as it was declared, with
        // pointers to all its texts.
        if const { is_settled_by_events(Self::TABLE) } { Err(rests_at_events()) } else { Ok(()) }
    }

    /// Whether a continuous state rests with the present parameters, such as that of a part that is switched off. Its rate
    /// is 0 then, and nothing depends on it.
    fn rests(&self, _column: usize) -> bool {
        false
    }

    /// Writes functions that change sign where derivatives or outputs jump, so that an importer finds the instant. A
    /// model need not have one for every jump or kink of its curves: solvers cross those with smaller steps.
    fn event_indicators(&self, _indicators: &mut [f64]) {}

    /// [`Model::PIECEWISE_LINEAR`] until the next event.
    fn is_linear(&self) -> bool {
        Self::PIECEWISE_LINEAR
    }

    /// Changes whatever changes at events only; the run begins with one. For models with rates.
    fn at_event(&mut self) {}

    /// The past that the rates need with the present parameters. Whoever integrates them fills the column that
    /// [lags](crate::table::Meaning::Lagged), unless the lag is 0.
    fn past(&self) -> Option<Past> {
        None
    }

    /// The bonds of the contact, if it has some: their [strains](crate::table::Meaning::Strain) and the energy change where
    /// one snaps. Whoever integrates the rates has to follow them.
    fn bonds(&self) -> Option<Bonds> {
        None
    }

    /// Takes the bonds over after a displacement in which none has snapped, and the energy dissipated before.
    fn put_bonds(&mut self, _bonds: &Bonds, _displacement: f64) {}

    /// Shows the model to a visitor, as one that runs in lanes if it does.
    fn accept(visitor: &mut impl Visitor) {
        visitor.visit::<Self>();
    }

    /// Whether [`Model::step`] leaves the inputs at other values, because it lets them move on.
    #[inline(always)]
    fn moves_inputs(&self) -> bool {
        false
    }

    /// Advances the states by `dt` > 0 while the inputs are held.
    fn step(&mut self, dt: f64);

    /// [`Model::step`] of a model with memory.
    #[inline(always)]
    fn step_with(&mut self, _memory: &mut [f64], dt: f64) {
        self.step(dt);
    }

    /// [`Model::step_with`] for those who ask for the force alone: the dissipated energy may stay as it is, everything else
    /// has the same bits. To be overridden if the energy is costly.
    #[inline(always)]
    fn step_without_energy(&mut self, memory: &mut [f64], dt: f64) {
        self.step_with(memory, dt);
    }

    /// [`Model::step`], and the outputs after it. To be overridden if both need the same costly term.
    #[inline(always)]
    fn step_and_output(&mut self, dt: f64) {
        self.step(dt);
        self.output();
    }

    /// [`Model::step_and_output`] of a model with memory.
    #[inline(always)]
    fn step_and_output_with(&mut self, _memory: &mut [f64], dt: f64) {
        self.step_and_output(dt);
    }

    /// Advances the states by `dt` while each input moves with the slope in its column of `slope`, and leaves the
    /// inputs at their final values. By default it uses the rates of the continuous states, with error control.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        crate::model::ramp::advance(self, slope, dt);
    }

    /// [`Model::step_ramp`] of a model with memory.
    fn step_ramp_with(&mut self, _memory: &mut [f64], slope: &Self, dt: f64) {
        self.step_ramp(slope, dt);
    }

    /// Speeds at which the law has a jump or kink in `velocity`; 0 for none. No piece of a ramp extends across them.
    fn kinks(&self) -> [f64; 2] {
        [0.0; 2]
    }

    /// Active branches of the equations of a model with rates, one bit each, such as a tyre on the ground. Its steps
    /// are divided where this changes.
    fn branches(&self) -> u32 {
        0
    }

    /// [`Derivatives::derivatives`]; to be overridden by a model for co-simulation only, which has its rates only as plain
    /// numbers.
    #[inline(always)]
    fn rate(&self, rate: &mut Self) {
        Self::Interface::rates(self, rate);
    }

    /// [`Model::rate`] of a model with memory, which moves as well.
    fn rate_with(&self, _memory: &[f64], rate: &mut Self, _memory_rate: &mut [f64]) {
        self.rate(rate);
    }
}
