//! A model is one row of `f64` with a declared table: the [`model!`](crate::model!) block writes both.
//!
//! Get, set, reset, save and restore work on rows and need not know the model; a model cannot have a state that its table
//! does not list. FMI and C identify a variable by a number that follows from its name: see [`reference`].

use std::ffi::CStr;
use std::fmt;

use crate::guid::{self, GuidText};
use crate::memory::{self, OutOfMemory};
use crate::number::Dual;
use crate::reference::{self, Place, Reference, References};
use crate::unit::{self, Unit};

/// Who writes a column, and when.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Set by the caller before each step.
    Input,
    /// Parameter, constant once the run has started.
    Fixed,
    /// Parameter that may be changed between steps.
    Tunable,
    /// State, advanced by `step`; its start value may be set before the run.
    State,
    /// State that is also a result, such as a position.
    StateOutput,
    /// Result, computed by `output` from the other columns.
    Output,
}

impl Role {
    /// Whether the column is a result that `output` computes.
    pub const fn is_computed(self) -> bool {
        matches!(self, Role::Output)
    }

    /// Whether the column is part of the state.
    pub const fn is_state(self) -> bool {
        matches!(self, Role::State | Role::StateOutput)
    }

    /// Whether the column is available to other models (FMI causality `output`).
    pub const fn is_output(self) -> bool {
        matches!(self, Role::Output | Role::StateOutput)
    }

    /// Whether the column is a parameter.
    pub const fn is_parameter(self) -> bool {
        matches!(self, Role::Fixed | Role::Tunable)
    }
}

/// Meaning of the number in a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A physical quantity with its unit.
    Real(&'static Unit),
    /// A whole number.
    Integer,
    /// 0 (false) or 1 (true).
    Boolean,
    /// One of several named choices, numbered from 1.
    Enumeration(&'static Enumeration),
}

/// The types that FMI distinguishes; enumerations are integers there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BaseType {
    /// Floating-point number.
    Real,
    /// Whole number or choice.
    Integer,
    /// True or false.
    Boolean,
}

impl Kind {
    /// The FMI type.
    #[inline(always)]
    pub const fn base_type(self) -> BaseType {
        match self {
            Kind::Real(_) => BaseType::Real,
            Kind::Integer | Kind::Enumeration(_) => BaseType::Integer,
            Kind::Boolean => BaseType::Boolean,
        }
    }
}

/// The choices of an enumeration column.
#[derive(Debug, PartialEq)]
pub struct Enumeration {
    /// Name of the type.
    pub name: &'static str,
    /// Choices in order; the first has the number 1.
    pub items: &'static [Item],
}

/// One choice of an enumeration.
#[derive(Debug, PartialEq)]
pub struct Item {
    /// Name of the choice.
    pub name: &'static str,
    /// One line with its meaning.
    pub help: &'static str,
}

/// The values a column admits. NaN and infinities are never admitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    // Both ends are admitted.
    low: f64,
    high: f64,
}

impl Bound {
    /// The smallest number admitted for values that must be > 0, such as a stiffness (chosen). FMI's `min` and `max`
    /// are themselves admitted values, so a description cannot exclude 0 as such. This number is short, far below any
    /// meaningful value, and has a finite reciprocal, unlike the smallest doubles.
    pub const SMALLEST_POSITIVE: f64 = 1e-300;

    /// Every finite number.
    pub const ANY: Bound = Bound { low: f64::MIN, high: f64::MAX };

    /// Whether the bound admits `value`.
    #[inline]
    pub const fn admits(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    /// The admitted value nearest to `value`.
    pub const fn nearest(&self, value: f64) -> f64 {
        value.clamp(self.low, self.high)
    }

    /// Lower end; `f64::MIN` if there is none.
    pub const fn min(&self) -> f64 {
        self.low
    }

    /// Upper end; `f64::MAX` if there is none.
    pub const fn max(&self) -> f64 {
        self.high
    }

    /// Admits the values of both bounds and everything between.
    pub(crate) const fn or(self, other: Bound) -> Bound {
        Bound { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The same up to `high`.
    pub(crate) const fn up_to(self, high: f64) -> Bound {
        Bound { high: self.high.min(high), ..self }
    }

    /// Whether values must be > 0, as for a stiffness.
    pub const fn is_positive(&self) -> bool {
        self.low == Bound::SMALLEST_POSITIVE
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (relation, low) = if self.is_positive() { (">", 0.0) } else { (">=", self.low) };
        let (low, high) = (Brief(low), Brief(self.high));
        match (self.low > f64::MIN, self.high < f64::MAX) {
            (false, false) => write!(f, "a finite number"),
            (true, false) => write!(f, "{relation} {low} and finite"),
            (false, true) => write!(f, "<= {high} and finite"),
            (true, true) => write!(f, "{relation} {low} and <= {high}"),
        }
    }
}

/// A number as messages show it: with an exponent if it would have many zeros.
pub(crate) struct Brief(pub f64);

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Brief(value) = *self;
        let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
        if plain { write!(f, "{value}") } else { write!(f, "{value:e}") }
    }
}

/// One step of a variable's name: `element[3]` has the name `element` and the index 3; index 0 means "no index".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Name.
    pub name: &'static str,
    /// Index from 1, or 0 for none.
    pub index: u16,
}

/// The name of a variable, such as `velocity` or `element[3].stiffness` (FMI's structured naming).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path {
    segments: [Segment; Path::DEPTH],
    depth: usize,
}

impl Path {
    /// Maximum depth of nested parts.
    const DEPTH: usize = 4;

    /// The name of a column outside any part.
    pub const fn root(name: &'static str) -> Path {
        Path { segments: [Segment { name, index: 0 }; Path::DEPTH], depth: 1 }
    }

    /// Its steps, outermost first.
    pub const fn segments(&self) -> &[Segment] {
        self.segments.split_at(self.depth).0
    }

    /// Whether both are the same name.
    pub(crate) const fn is(&self, other: &Path) -> bool {
        let mut at = 0;
        while at < self.depth && at < other.depth {
            let (a, b) = (self.segments[at], other.segments[at]);
            if a.index != b.index || !unit::same(a.name, b.name) {
                return false;
            }
            at += 1;
        }
        self.depth == other.depth
    }

    /// Whether this is the name, as spelled by [`Path`]'s `Display`.
    fn is_spelled(&self, name: &str) -> bool {
        struct Rest<'a>(&'a str);
        impl fmt::Write for Rest<'_> {
            fn write_str(&mut self, text: &str) -> fmt::Result {
                self.0 = self.0.strip_prefix(text).ok_or(fmt::Error)?;
                Ok(())
            }
        }
        let mut rest = Rest(name);
        fmt::write(&mut rest, format_args!("{self}")).is_ok() && rest.0.is_empty()
    }

    /// This name inside a part.
    pub(crate) const fn within(&self, part: Segment) -> Path {
        assert!(self.depth < Path::DEPTH, "parts are nested too deeply");
        let mut path = Path { segments: [part; Path::DEPTH], depth: self.depth + 1 };
        let mut at = 0;
        while at < self.depth {
            path.segments[at + 1] = self.segments[at];
            at += 1;
        }
        path
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (at, Segment { name, index }) in self.segments().iter().enumerate() {
            let dot = if at == 0 { "" } else { "." };
            match index {
                0 => write!(f, "{dot}{name}")?,
                _ => write!(f, "{dot}{name}[{index}]")?,
            }
        }
        Ok(())
    }
}

/// The right-hand side of a line in a `model!` block, without name and role.
///
/// Made by [`real`], [`integer`], [`boolean`] and [`choice`], restricted by the methods.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    kind: Kind,
    start: f64,
    bound: Bound,
    nominal: f64,
    display: Option<&'static str>,
    jumps: bool,
    reinit: bool,
    has_derivatives: bool,
    is_hidden: bool,
}

impl Column {
    const fn new(kind: Kind, start: f64, bound: Bound) -> Column {
        let jumps = !matches!(kind, Kind::Real(_));
        Column {
            kind,
            start,
            bound,
            nominal: 1.0,
            display: None,
            jumps,
            reinit: false,
            has_derivatives: true,
            is_hidden: false,
        }
    }

    /// Admits only values > 0, from [`Bound::SMALLEST_POSITIVE`] on.
    pub const fn positive(mut self) -> Column {
        self.bound.low = Bound::SMALLEST_POSITIVE;
        self
    }

    /// Admits only values >= `min`.
    pub const fn at_least(mut self, min: f64) -> Column {
        self.bound.low = min;
        self
    }

    /// Admits only values <= `max`.
    pub const fn at_most(mut self, max: f64) -> Column {
        self.bound.high = max;
        self
    }

    /// The usual magnitude of the value, for error control and for importers; 1 by default.
    pub const fn nominal(mut self, nominal: f64) -> Column {
        self.nominal = nominal;
        self
    }

    /// The display unit that an importer should show first; it must be one of the display units of the unit.
    pub const fn shown_in(mut self, display: &'static str) -> Column {
        self.display = Some(display);
        self
    }

    /// A state that changes only from step to step, not with time.
    pub const fn discrete(mut self) -> Column {
        self.jumps = true;
        self
    }

    /// A continuous state that [`Model::at_event`] may change.
    pub const fn reinit(mut self) -> Column {
        self.reinit = true;
        self
    }

    /// A result that is advice, computed by differences; it cannot be differentiated itself.
    pub const fn without_derivatives(mut self) -> Column {
        self.has_derivatives = false;
        self
    }

    /// A state that no importer needs by name. It is saved and restored like the others, but it is not a variable of the
    /// interfaces: what a model remembers may change without them.
    pub const fn hidden(mut self) -> Column {
        self.is_hidden = true;
        self
    }

    /// The finished variable. A start value outside its own bound does not compile.
    pub const fn named(self, path: Path, role: Role, help: &'static str) -> Variable {
        assert!(self.bound.admits(self.start), "the start value is outside its bound");
        Variable {
            path,
            role,
            kind: self.kind,
            start: self.start,
            bound: self.bound,
            nominal: self.nominal,
            display: self.display,
            jumps: self.jumps,
            reinit: self.reinit,
            has_derivatives: self.has_derivatives,
            is_hidden: self.is_hidden,
            help: help.trim_ascii(),
        }
    }
}

/// A physical quantity: unit (one of [`crate::unit::UNITS`]) and start value.
pub const fn real(unit: &str, start: f64) -> Column {
    Column::new(Kind::Real(unit::named(unit)), start, Bound::ANY)
}

/// A whole number within the range of FMI's 32-bit integers.
pub const fn integer(start: i32) -> Column {
    let bound = Bound { low: i32::MIN as f64, high: i32::MAX as f64 };
    Column::new(Kind::Integer, start as f64, bound)
}

/// True or false.
pub const fn boolean(start: bool) -> Column {
    let bound = Bound { low: 0.0, high: 1.0 };
    Column::new(Kind::Boolean, start as u8 as f64, bound)
}

/// One of the choices of an enumeration made with [`choices!`](crate::choices!), by its number.
pub const fn choice(items: &'static Enumeration, start: i32) -> Column {
    let bound = Bound { low: 1.0, high: items.items.len() as f64 };
    Column::new(Kind::Enumeration(items), start as f64, bound)
}

/// One column of a model's table.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// Name.
    pub path: Path,
    /// Who writes it, and when.
    pub role: Role,
    /// Meaning of the number.
    pub kind: Kind,
    /// Start value.
    pub start: f64,
    /// Values it admits.
    pub bound: Bound,
    /// Usual magnitude of the value.
    pub nominal: f64,
    /// Preferred display unit.
    pub display: Option<&'static str>,
    /// Whether it is piecewise constant (FMI variability `discrete`); always true for non-real kinds.
    pub jumps: bool,
    /// Whether it is a continuous state that an event of Model Exchange may change.
    pub reinit: bool,
    /// Whether it can be differentiated, if it is a result.
    pub has_derivatives: bool,
    /// Whether it is missing in the interfaces: see [`Column::hidden`].
    pub is_hidden: bool,
    /// Description: one line of ASCII text.
    pub help: &'static str,
}

impl Variable {
    /// Whether the column admits `value`. Integer columns admit integers only.
    #[inline]
    pub fn admits(&self, value: f64) -> bool {
        self.bound.admits(value) && (matches!(self.kind, Kind::Real(_)) || value.fract() == 0.0)
    }

    /// Whether it is a state that moves with time, as given by [`Law::derivatives`].
    pub const fn is_continuous_state(&self) -> bool {
        self.role.is_state() && !self.jumps
    }

    /// Whether only an event of Model Exchange sets it, as is the case for every choice that is a state. Steps have no
    /// events, so it keeps its start value there.
    pub const fn is_settled_by_events(&self) -> bool {
        self.role.is_state() && matches!(self.kind, Kind::Enumeration(_))
    }

    /// Rejects values that steps do not admit, with the message for the user.
    pub(crate) fn check_for_steps(&self, value: f64) -> Result<(), Fault> {
        if self.admits(value) { self.check_without_events(value) } else { Err(self.fault(value)) }
    }

    /// Rejects a value that only an event can produce.
    pub(crate) fn check_without_events(&self, value: f64) -> Result<(), Fault> {
        if self.is_settled_by_events() && value != self.start {
            let text = "without events, which only Model Exchange has";
            return Err(Fault::new(format_args!("{} = {}: must be {} {text}", self.path, Brief(value), self.start)));
        }
        Ok(())
    }

    /// Rejects differentiating a result that is advice.
    pub(crate) fn check_derivatives(&self) -> Result<(), Fault> {
        if self.has_derivatives { Ok(()) } else { Err(Fault::new(format_args!("{} has no derivatives", self.path))) }
    }

    /// Rejects `value`, with the message for the user.
    pub fn fault(&self, value: f64) -> Fault {
        let (path, shown, bound) = (self.path, Brief(value), self.bound);
        match self.kind {
            Kind::Boolean => Fault::new(format_args!("{path} = {shown}: must be 0 or 1")),
            Kind::Integer | Kind::Enumeration(_) if bound.admits(value) => {
                Fault::new(format_args!("{path} = {shown}: must be a whole number"))
            }
            _ if bound.is_positive() && value > 0.0 && value < bound.min() => {
                Fault::new(format_args!("{path} = {shown}: must be >= {}", Brief(bound.min())))
            }
            _ => Fault::new(format_args!("{path} = {shown}: must be {bound}")),
        }
    }
}

/// Why a value, or a set of parameters, was refused. The text names the variable, its value and the limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub(crate) String);

impl Fault {
    /// A fault with this text, truncated if memory runs out.
    pub fn new(text: impl fmt::Display) -> Fault {
        Fault(memory::text(text))
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

impl From<OutOfMemory> for Fault {
    fn from(error: OutOfMemory) -> Fault {
        Fault::new(error)
    }
}

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
/// `Dual` must be the same struct in dual numbers: `#[repr(C)]`, with a [`Dual`] for each f64.
pub unsafe trait Described: Columns {
    /// Name, also FMI's modelIdentifier.
    const NAME: &'static str;
    /// The name, for C.
    const C_NAME: &'static CStr;
    /// One line.
    const SUMMARY: &'static str;
    /// The documentation page, in Markdown.
    const DOCUMENTATION: &'static str;
    /// The facts about the columns that get and set need on every step.
    const PORTS: &'static [Port];
    /// The numbers by which FMI and C know the columns.
    const REFERENCES: References;
    /// The same model in dual numbers, for exact derivatives.
    type Dual: Law<Number = Dual>;
}

/// The equations of a model, written once for every number type.
pub trait Law: Numbers {
    /// Computes the [`Role::Output`] columns from the others.
    fn output(&mut self);

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

    /// Writes the time derivatives of the continuous states into their columns of `rate`.
    fn derivatives(&self, _rate: &mut Self) {}
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

/// The part of a model beside its table: how it moves in time.
pub trait Model: Described + Law<Number = f64> {
    /// Whether an importer may integrate the continuous states itself (FMI Model Exchange). Then they move only by
    /// [`Law::derivatives`], and the rest of the state either has no effect or changes only in [`Model::at_event`].
    const MODEL_EXCHANGE: bool = false;

    /// Number of event indicators.
    const EVENT_INDICATORS: usize = 0;

    /// Are the rates linear in the states, each in its own, and the power in all of them? Ramps need fewer of them then.
    const LINEAR: bool = false;

    /// Named parameter sets.
    const PRESETS: &'static [Preset] = &[];

    /// Values that an instance keeps beside the row: the part of the state that is too long for a table, such as the
    /// elements of a law that can have a thousand. They have no variables. They are 0 at the start, and saved and
    /// restored with the row.
    const MEMORY: usize = 0;

    /// Rejects parameters that are admitted one by one but not together.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Warning about values that are accepted although they make no sense here, such as an unconnected input at 0. The
    /// log of an FMU reports each text once; `stribeck_warning` returns it as long as it holds.
    fn warning(&self) -> Option<Fault> {
        None
    }

    /// Rejects inputs for which the equations give no number; called if a result is not finite, to name the limit.
    fn check_motion(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Rejects parameters with which the model is for co-simulation only.
    fn check_exchange(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// Writes functions that change sign where derivatives or outputs jump, so that an importer finds the instant. A
    /// model need not have one for every jump or kink of its curves: solvers cross those with smaller steps.
    fn event_indicators(&self, _indicators: &mut [f64]) {}

    /// Changes whatever changes at events only; the run begins with one. Model Exchange only.
    fn at_event(&mut self) {}

    /// Advances the states by `dt` > 0 while the inputs are held.
    fn step(&mut self, dt: f64);

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
        crate::ramp::advance(self, slope, dt);
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

    /// [`Law::derivatives`]; to be overridden by a model that has them only as plain numbers.
    #[inline(always)]
    fn rate(&self, rate: &mut Self) {
        self.derivatives(rate);
    }

    /// [`Model::rate`] of a model with memory, which moves as well.
    fn rate_with(&self, _memory: &[f64], rate: &mut Self, _memory_rate: &mut [f64]) {
        self.rate(rate);
    }
}

/// The per-column facts that get and set need on every step, packed for the cache.
#[derive(Clone, Copy, Debug)]
pub struct Port {
    low: f64,
    high: f64,
    /// Type of the column.
    pub base_type: BaseType,
}

impl Port {
    /// Whether `value` may be written while stepping, with no rule but its range. True for admitted values of Real
    /// inputs, false for all other columns.
    #[inline(always)]
    pub fn takes(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    const fn of(variable: &Variable) -> Port {
        let (low, high) = match (variable.role, variable.kind) {
            (Role::Input, Kind::Real(_)) => (variable.bound.low, variable.bound.high),
            _ => (f64::INFINITY, f64::NEG_INFINITY),
        };
        Port { low, high, base_type: variable.kind.base_type() }
    }
}

/// Arguments: row, memory, workspace for a copy, slopes and time.
type AdvanceRamp = fn(&mut [f64], &mut [f64], Room, &[f64], f64) -> bool;

/// Arguments: row, memory, and the rates of row and memory.
type Rate = fn(&[f64], &[f64], &mut [f64], &mut [f64]);

/// Everything the library knows about a model, in one record of plain data and functions.
pub struct ModelType {
    /// Name, also FMI's modelIdentifier.
    pub name: &'static str,
    /// The name, for C.
    pub c_name: &'static CStr,
    /// One-line description.
    pub summary: &'static str,
    /// Its columns.
    pub table: &'static [Variable],
    /// The facts about the columns that get and set need on every step.
    pub ports: &'static [Port],
    references: References,
    /// Its named parameter sets.
    pub presets: &'static [Preset],
    /// Whether it supports Model Exchange.
    pub model_exchange: bool,
    /// Number of its event indicators.
    pub event_indicators: usize,
    /// Number of values that an instance keeps beside the row: [`Model::MEMORY`].
    pub memory: usize,
    guid: GuidText,
    check: fn(&[f64]) -> Result<(), Fault>,
    check_motion: fn(&[f64]) -> Result<(), Fault>,
    warning: fn(&[f64]) -> Option<Fault>,
    memory_in_use: fn(&[f64]) -> usize,
    advance: fn(&mut [f64], &mut [f64], Room, f64) -> bool,
    advance_ramp: AdvanceRamp,
    output: fn(&mut [f64], &mut [f64], Room) -> bool,
    output_dual: fn(&mut [Dual], &[Dual]),
    rate: Rate,
    rate_dual: fn(&[Dual], &mut [Dual]),
    check_exchange: fn(&[f64]) -> Result<(), Fault>,
    indicate: fn(&[f64], &mut [f64]),
    at_event: fn(&mut [f64], &mut [f64], Room) -> bool,
}

impl ModelType {
    /// The record of a model.
    pub const fn of<M: Model>() -> ModelType {
        ModelType {
            name: M::NAME,
            c_name: M::C_NAME,
            summary: M::SUMMARY,
            table: M::TABLE,
            ports: M::PORTS,
            references: M::REFERENCES,
            presets: M::PRESETS,
            model_exchange: M::MODEL_EXCHANGE,
            event_indicators: M::EVENT_INDICATORS,
            memory: M::MEMORY,
            guid: guid::fingerprint(
                M::NAME,
                M::TABLE,
                if M::MODEL_EXCHANGE { Some(M::EVENT_INDICATORS) } else { None },
            ),
            check: |row| view::<M, f64>(row).check(),
            check_motion: |row| view::<M, f64>(row).check_motion(),
            warning: |row| view::<M, f64>(row).warning(),
            memory_in_use: |row| view::<M, f64>(row).memory_in_use(),
            advance: |row, memory, room, dt| {
                let advance = |model: &mut M, memory: &mut [f64]| model.step_and_output_with(memory, dt);
                commit::<M>(row, memory, room, first_result(M::TABLE), advance)
            },
            advance_ramp: |row, memory, room, slope, dt| {
                let slope = view::<M, f64>(slope);
                let advance = |model: &mut M, memory: &mut [f64]| {
                    model.step_ramp_with(memory, slope, dt);
                    model.output_with(memory);
                };
                // The inputs have moved as well.
                commit::<M>(row, memory, room, 0, advance)
            },
            output: |row, memory, room| {
                commit::<M>(row, memory, room, first_result(M::TABLE), |model, memory| model.output_with(memory))
            },
            output_dual: |row, memory| view_mut::<M::Dual, Dual>(row).output_with(memory),
            rate: |row, memory, rate, memory_rate| {
                rate.fill(0.0);
                view::<M, f64>(row).rate_with(memory, view_mut(rate), memory_rate);
            },
            rate_dual: |row, rate| {
                rate.fill(Dual::default());
                view::<M::Dual, Dual>(row).derivatives(view_mut(rate));
            },
            check_exchange: |row| view::<M, f64>(row).check_exchange(),
            indicate: |row, indicators| view::<M, f64>(row).event_indicators(indicators),
            at_event: |row, memory, room| commit::<M>(row, memory, room, 0, |model, _| model.at_event()),
        }
    }

    /// The guid that ties modelDescription.xml to this library.
    pub fn guid(&self) -> &str {
        // The fingerprint is spelled with ASCII digits only.
        std::str::from_utf8(&self.guid).unwrap_or_default()
    }

    /// The guid, for data that must not hold the address of the model.
    pub(crate) fn guid_text(&self) -> GuidText {
        self.guid
    }

    /// What a value reference stands for.
    #[inline(always)]
    pub fn place(&self, reference: Reference) -> Option<Place> {
        self.references.find(reference, self.table.len())
    }

    /// The value reference of a column.
    pub fn reference(&self, column: usize) -> Reference {
        reference::of(&self.table[column].path)
    }

    /// The value references of the time derivatives of the continuous states.
    pub fn derivative_references(&self) -> impl Iterator<Item = Reference> {
        self.continuous_states().map(|state| reference::of_derivative(&self.table[state].path))
    }

    /// The variables that the interfaces show, with their columns.
    pub fn variables(&self) -> impl Iterator<Item = (usize, &'static Variable)> {
        self.table.iter().enumerate().filter(|(_, variable)| !variable.is_hidden)
    }

    /// The column of the variable of this name.
    pub fn find(&self, name: &str) -> Option<usize> {
        // Full names are built only if they begin alike: a table can have hundreds of rows.
        let alike = |variable: &Variable| name.starts_with(variable.path.segments()[0].name);
        let mut variables = self.variables();
        variables.find(|(_, variable)| alike(variable) && variable.path.is_spelled(name)).map(|(column, _)| column)
    }

    /// Refuses parameters that are admitted one by one but not together.
    pub fn check(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check)(row)
    }

    /// Warning about values that are accepted although they make no sense here.
    pub fn warning(&self, row: &[f64]) -> Option<Fault> {
        (self.warning)(row)
    }

    /// Names the limit of an input for which a result is not finite.
    pub(crate) fn check_motion(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check_motion)(row)
    }

    /// Number of values of the memory beside the row that the parameters ask for. The functions that work on a row
    /// alone are for rows that need none.
    #[inline]
    pub fn memory_in_use(&self, row: &[f64]) -> usize {
        (self.memory_in_use)(row)
    }

    /// Advances by `dt` with held inputs and computes the outputs. False if a result is not finite; the row must not be
    /// used then.
    #[inline]
    pub fn advance(&self, row: &mut [f64], dt: f64) -> bool {
        (self.advance)(row, &mut [], &mut [], dt)
    }

    /// As [`ModelType::advance`], but row and memory are as they were if a result is not finite, or if the model
    /// panics.
    #[inline(always)]
    pub(crate) fn try_advance(&self, row: &mut [f64], memory: &mut [f64], room: Room, dt: f64) -> bool {
        (self.advance)(row, memory, room, dt)
    }

    /// As [`ModelType::advance`], with inputs that move linearly.
    pub fn advance_ramp(&self, row: &mut [f64], slope: &[f64], dt: f64) -> bool {
        (self.advance_ramp)(row, &mut [], &mut [], slope, dt)
    }

    /// As [`ModelType::try_advance`], with inputs that move linearly.
    pub(crate) fn try_advance_ramp(
        &self,
        row: &mut [f64],
        memory: &mut [f64],
        room: Room,
        slope: &[f64],
        dt: f64,
    ) -> bool {
        (self.advance_ramp)(row, memory, room, slope, dt)
    }

    /// Computes the outputs. False if one is not finite; the row must not be used then.
    #[inline]
    pub fn output(&self, row: &mut [f64]) -> bool {
        (self.output)(row, &mut [], &mut [])
    }

    /// As [`ModelType::output`], but the row is as it was if a result is not finite, or if the model panics.
    #[inline(always)]
    pub(crate) fn try_output(&self, row: &mut [f64], memory: &mut [f64], room: Room) -> bool {
        (self.output)(row, memory, room)
    }

    /// Computes the outputs with their derivatives in the direction that the other columns carry.
    pub fn output_dual(&self, row: &mut [Dual]) {
        self.output_dual_with(row, &[]);
    }

    /// As [`ModelType::output_dual`], with the part of the memory that is in use.
    pub(crate) fn output_dual_with(&self, row: &mut [Dual], memory: &[Dual]) {
        (self.output_dual)(row, memory);
    }

    /// Time derivatives of the states, in the columns of the states; 0 elsewhere.
    pub fn rate(&self, row: &[f64], rate: &mut [f64]) {
        self.rate_with(row, &[], rate, &mut []);
    }

    /// As [`ModelType::rate`], with the part of the memory that is in use.
    pub(crate) fn rate_with(&self, row: &[f64], memory: &[f64], rate: &mut [f64], memory_rate: &mut [f64]) {
        (self.rate)(row, memory, rate, memory_rate);
    }

    /// The same with their derivatives in the direction that the columns of `row` carry; for Model Exchange.
    pub fn rate_dual(&self, row: &[Dual], rate: &mut [Dual]) {
        (self.rate_dual)(row, rate);
    }

    /// The columns of the states that move with time.
    pub fn continuous_states(&self) -> impl Iterator<Item = usize> {
        let table = self.table;
        (0..table.len()).filter(|column| table[*column].is_continuous_state())
    }

    /// Refuses parameters with which the model is for co-simulation only.
    pub fn check_exchange(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check_exchange)(row)
    }

    /// Writes the event indicators.
    pub fn indicate(&self, row: &[f64], indicators: &mut [f64]) {
        (self.indicate)(row, indicators);
    }

    /// Changes whatever changes at events only. False if a result is not finite; the row must not be used then.
    pub fn at_event(&self, row: &mut [f64]) -> bool {
        (self.at_event)(row, &mut [], &mut [])
    }

    /// As [`ModelType::at_event`], but the row is as it was if a result is not finite, or if the model panics.
    pub(crate) fn try_at_event(&self, row: &mut [f64], memory: &mut [f64], room: Room) -> bool {
        (self.at_event)(row, memory, room)
    }
}

impl PartialEq for ModelType {
    fn eq(&self, other: &ModelType) -> bool {
        self.guid == other.guid
    }
}

impl fmt::Debug for ModelType {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", self.name, self.guid())
    }
}

/// The first column that a step or the outputs may change: those before it are inputs and parameters.
const fn first_result(table: &[Variable]) -> usize {
    let mut first = 0;
    while first < table.len() && (table[first].role.is_parameter() || matches!(table[first].role, Role::Input)) {
        first += 1;
    }
    first
}

/// Workspace for a copy of a row and its memory, or none: a row of many elements is too long for the stack of a host.
pub(crate) type Room<'a> = &'a mut [f64];

/// Works on row and memory and returns whether every number from column `first` on is finite. Otherwise, and if the
/// work panics, both are as before, provided that there is workspace for a copy. The work must not change anything
/// before that column. The part of the memory that is not in use costs nothing.
#[inline(always)]
fn commit<M: Model>(
    row: &mut [f64],
    memory: &mut [f64],
    room: Room,
    first: usize,
    work: impl FnOnce(&mut M, &mut [f64]),
) -> bool {
    let model = view_mut::<M, f64>(row);
    let in_use = model.memory_in_use();
    assert!(in_use <= memory.len(), "a row that asks for the memory of an instance");
    let memory = &mut memory[..in_use];
    let has_room = room.len() == M::TABLE.len() + M::MEMORY;
    if has_room {
        let (row_copy, memory_copy) = room.split_at_mut(M::TABLE.len());
        row_copy[first..].copy_from_slice(&row_of(model)[first..]);
        memory_copy[..memory.len()].copy_from_slice(memory);
    }
    let mut guard = RollBack::<M> { row: model, memory, room, first, keep: !has_room };
    work(guard.row, guard.memory);
    let is_finite = are_finite(&row_of(guard.row)[first..]) && are_finite(guard.memory);
    guard.keep |= is_finite;
    is_finite
}

/// x 0 is 0 for every finite x, and NaN for the others.
#[inline(always)]
fn are_finite(numbers: &[f64]) -> bool {
    numbers.iter().fold(0.0, |sum, value| sum + value * 0.0) == 0.0
}

/// Restores row and memory unless told to keep them. The work is done in place, not on a copy that is written back,
/// because processors stall where a vector copy reads numbers that were just written one by one.
struct RollBack<'a, M: Model> {
    row: &'a mut M,
    memory: &'a mut [f64],
    room: Room<'a>,
    first: usize,
    keep: bool,
}

impl<M: Model> Drop for RollBack<'_, M> {
    #[inline(always)]
    fn drop(&mut self) {
        if !self.keep {
            let (row, memory) = self.room.split_at(M::TABLE.len());
            row_of_mut(self.row)[self.first..].copy_from_slice(&row[self.first..]);
            self.memory.copy_from_slice(&memory[..self.memory.len()]);
        }
    }
}

/// The row of a model, as plain numbers.
pub fn row_of<M: Columns>(model: &M) -> &[f64] {
    const { assert!(size_of::<M>() == M::TABLE.len() * size_of::<f64>()) };
    // SAFETY: `Columns` promises a `#[repr(C)]` struct of exactly this many f64, checked above for size.
    unsafe { std::slice::from_raw_parts(std::ptr::from_ref(model).cast::<f64>(), M::TABLE.len()) }
}

/// The row of a model, mutable.
pub fn row_of_mut<M: Columns>(model: &mut M) -> &mut [f64] {
    const { assert!(size_of::<M>() == M::TABLE.len() * size_of::<f64>()) };
    // SAFETY: as in `row_of`; every bit pattern is a valid f64, so no write can break the model.
    unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(model).cast::<f64>(), M::TABLE.len()) }
}

/// A row seen as the model it belongs to. `M` is the model in the number type `T`.
#[inline(always)]
fn view<M, T>(row: &[T]) -> &M {
    const { assert!(align_of::<M>() == align_of::<T>() && size_of::<M>().is_multiple_of(size_of::<T>())) };
    assert!(size_of_val(row) == size_of::<M>(), "a row of another model");
    // SAFETY: models are `#[repr(C)]` structs of T (the promise of `Columns`), T is a plain number for which every bit
    // pattern is valid, and size and alignment were just checked.
    unsafe { &*row.as_ptr().cast::<M>() }
}

/// As [`view`], mutable.
#[inline(always)]
fn view_mut<M, T>(row: &mut [T]) -> &mut M {
    const { assert!(align_of::<M>() == align_of::<T>() && size_of::<M>().is_multiple_of(size_of::<T>())) };
    assert!(size_of_val(row) == size_of::<M>(), "a row of another model");
    // SAFETY: as in `view`; the borrow of `row` is exclusive and passes on to the result.
    unsafe { &mut *row.as_mut_ptr().cast::<M>() }
}

/// Numbers viewed as consecutive parts; a remainder is ignored.
pub(crate) fn parts<P: Numbers>(numbers: &[P::Number]) -> &[P] {
    const { assert!(align_of::<P>() == align_of::<P::Number>() && size_of::<P>() > 0) };
    let count = size_of_val(numbers) / size_of::<P>();
    // SAFETY: `Numbers` promises a `#[repr(C)]` struct that consists only of these numbers; the alignment was just
    // checked, and the slice contains this many parts.
    unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast::<P>(), count) }
}

/// As [`parts`], mutable.
pub(crate) fn parts_mut<P: Numbers>(numbers: &mut [P::Number]) -> &mut [P] {
    const { assert!(align_of::<P>() == align_of::<P::Number>() && size_of::<P>() > 0) };
    let count = size_of_val(numbers) / size_of::<P>();
    // SAFETY: as in `parts`; a part consists only of numbers, so no write can break the slice, and its borrow is
    // exclusive and passes on to the result.
    unsafe { std::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast::<P>(), count) }
}

/// Writes one variable into a table under construction and returns the next free column.
pub const fn place(table: &mut [Variable], at: usize, variable: Variable) -> usize {
    table[at] = variable;
    at + 1
}

/// Writes several variables of one name, with an index from 1, and returns the next free column.
pub const fn place_all<const N: usize>(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    role: Role,
    columns: &[Column; N],
    help: &'static str,
) -> usize {
    assert!(N <= u16::MAX as usize, "too many elements");
    let mut index = 0;
    while index < N {
        let place = Segment { name, index: index as u16 + 1 };
        let path = Path { segments: [place; Path::DEPTH], depth: 1 };
        table[at + index] = columns[index].named(path, role, help);
        index += 1;
    }
    at + N
}

/// Writes the table of a part under its own names and returns the next free column.
pub const fn inline(table: &mut [Variable], at: usize, part: &[Variable]) -> usize {
    let mut column = 0;
    while column < part.len() {
        table[at + column] = part[column];
        column += 1;
    }
    at + column
}

/// Writes the table of a part under its name in this table and returns the next free column.
pub const fn graft(table: &mut [Variable], at: usize, place: Segment, part: &[Variable]) -> usize {
    let mut column = 0;
    while column < part.len() {
        table[at + column] = part[column];
        table[at + column].path = part[column].path.within(place);
        column += 1;
    }
    at + column
}

/// Writes the table of a part `count` times, with an index from 1, and returns the next free column.
pub const fn graft_all(
    table: &mut [Variable],
    mut at: usize,
    name: &'static str,
    count: usize,
    part: &[Variable],
) -> usize {
    assert!(count <= u16::MAX as usize, "too many elements");
    let mut index = 1;
    while index <= count {
        at = graft(table, at, Segment { name, index: index as u16 }, part);
        index += 1;
    }
    at
}

/// The ports of a table.
pub const fn ports<const COLUMNS: usize>(table: &[Variable]) -> [Port; COLUMNS] {
    let mut ports = [Port::of(&BLANK); COLUMNS];
    let mut column = 0;
    while column < COLUMNS {
        ports[column] = Port::of(&table[column]);
        column += 1;
    }
    ports
}

/// Start values by column name: those of the first parts of an array, in order.
pub type Starts<'a> = &'a [(&'a str, &'a [f64])];

/// As [`graft_all`]; then the first parts get their own start values. A name that the part does not have, more values
/// than parts, or a value outside its bound does not compile.
pub const fn graft_with(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    count: usize,
    part: &[Variable],
    starts: Starts,
) -> usize {
    let end = graft_all(table, at, name, count, part);
    let mut entry = 0;
    while entry < starts.len() {
        let (column, values) = starts[entry];
        assert!(values.len() <= count, "more start values than parts");
        let mut index = 0;
        while index < values.len() {
            restart(table, at + index * part.len(), part, column, values[index]);
            index += 1;
        }
        entry += 1;
    }
    end
}

/// As [`graft`]; then columns get their own start values, as in [`graft_with`].
pub const fn graft_one_with(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    part: &[Variable],
    starts: &[(&str, f64)],
) -> usize {
    let end = graft(table, at, Segment { name, index: 0 }, part);
    let mut entry = 0;
    while entry < starts.len() {
        let (column, value) = starts[entry];
        restart(table, at, part, column, value);
        entry += 1;
    }
    end
}

/// Gives another start value to a column of the part that was written at `at`.
const fn restart(table: &mut [Variable], at: usize, part: &[Variable], column: &str, value: f64) {
    let mut offset = 0;
    while !unit::same(part[offset].path.segments()[0].name, column) {
        offset += 1;
    }
    let variable = &mut table[at + offset];
    assert!(variable.bound.admits(value), "the start value is outside its bound");
    variable.start = value;
}

/// A table entry to be overwritten by [`place`] or [`graft`].
pub const BLANK: Variable = real("1", 0.0).named(Path::root(""), Role::Output, "");

/// Declares an enumeration whose choices a column may take, numbered from 1 as in FMI.
///
/// ```
/// stribeck::choices! {
///     /// Mode of the test bench.
///     pub enum Bench {
///         /// Pulls at constant velocity.
///         Pull,
///         /// Moves to and fro.
///         Reciprocate,
///     }
/// }
/// assert_eq!(Bench::of(2.0), Bench::Reciprocate);
/// assert_eq!(Bench::CHOICES.items[0].help, "Pulls at constant velocity.");
/// ```
#[macro_export]
macro_rules! choices {
    ($(#[doc = $doc:literal])+ $vis:vis enum $Name:ident { $($(#[doc = $help:literal])+ $Item:ident,)+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        $vis enum $Name { $($(#[doc = $help])+ $Item,)+ }

        impl $Name {
            /// The choices, as a column declares them.
            pub const CHOICES: &'static $crate::model::Enumeration = &$crate::model::Enumeration {
                name: stringify!($Name),
                items: &[$($crate::model::Item {
                    name: stringify!($Item),
                    help: concat!($($help),+).trim_ascii(),
                },)+],
            };

            /// The column with this choice as its start value.
            pub const fn start(self) -> $crate::model::Column {
                $crate::model::choice(Self::CHOICES, self as i32 + 1)
            }

            /// The choice that a number stands for; numbers outside the bound of the column never get here.
            pub fn of(number: f64) -> $Name {
                const ALL: &[$Name] = &[$($Name::$Item),+];
                ALL[(number as usize).clamp(1, ALL.len()) - 1]
            }
        }
    };
}

/// Declares a part: columns that a model contains once (`stop: BumpStop`), several times (`element: [Element; 4]`), or
/// once and under the names of the part itself (`time_stepping: (TimeStepping)`). A part may have its own start values,
/// `rear: Axle = &[("stiffness", 2.0)]`, and so may the first parts of an array, `element: [Element; 4] =
/// &[("stiffness", &[3.0, 2.0])]`. Parameters and states may be arrays of numbers: `point: [tunable; 3] = [real("m",
/// 0.0); 3]`. The syntax of the fields is that of [`model!`](crate::model!).
#[macro_export]
macro_rules! part {
    ($(#[doc = $doc:expr])+ $Name:ident { $($(#[doc = $help:literal])+ $field:ident: $what:tt $(= $column:expr)?,)+ }) => {
        $(#[doc = $doc])+
        #[repr(C)]
        #[allow(non_snake_case, reason = "a symbol such as V0 is a name as well")]
        pub struct $Name<T = f64> { $($(#[doc = $help])+ pub $field: $crate::part!(@type $what T),)+ }

        impl<T: Copy> Clone for $Name<T> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<T: Copy> Copy for $Name<T> {}

        // SAFETY: `#[repr(C)]`, and every field is a number of this type or a part of such numbers.
        unsafe impl<T: Copy> $crate::model::Numbers for $Name<T> {
            type Number = T;
        }

        impl<T: Copy> $Name<T> {
            /// The same columns in another number type.
            #[allow(dead_code, reason = "not every model needs it")]
            pub fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> $Name<U> {
                $Name { $($field: $crate::part!(@map $what (self.$field) convert),)+ }
            }
        }

        impl std::fmt::Debug for $Name {
            fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                $crate::model::list(self, f)
            }
        }

        impl $crate::model::Width for $Name {
            const WIDTH: usize = 0 $(+ <$crate::part!(@type $what f64) as $crate::model::Width>::WIDTH)+;
        }

        // SAFETY: `#[repr(C)]`, and every field is a number or a part, so the struct is a run of numbers; the table has
        // one entry for each because both are written from the same list.
        unsafe impl $crate::model::Columns for $Name {
            const TABLE: &'static [$crate::model::Variable] = &const {
                let mut table = [$crate::model::BLANK; <$Name as $crate::model::Width>::WIDTH];
                let mut at = 0;
                $(at = $crate::part!(@place table at $field $what $(= $column)?, concat!($($help),+));)+
                assert!(at == table.len());
                table
            };
        }
    };

    (@type input $T:ident) => { $T };
    (@type fixed $T:ident) => { $T };
    (@type tunable $T:ident) => { $T };
    (@type state $T:ident) => { $T };
    (@type state_output $T:ident) => { $T };
    (@type output $T:ident) => { $T };
    (@type [fixed; $n:expr] $T:ident) => { [$T; $n] };
    (@type [tunable; $n:expr] $T:ident) => { [$T; $n] };
    (@type [state; $n:expr] $T:ident) => { [$T; $n] };
    (@type [$Part:ident; $n:expr] $T:ident) => { [$Part<$T>; $n] };
    (@type ($Part:ident) $T:ident) => { $Part<$T> };
    (@type $Part:ident $T:ident) => { $Part<$T> };

    (@map input $value:tt $convert:ident) => { $convert($value) };
    (@map fixed $value:tt $convert:ident) => { $convert($value) };
    (@map tunable $value:tt $convert:ident) => { $convert($value) };
    (@map state $value:tt $convert:ident) => { $convert($value) };
    (@map state_output $value:tt $convert:ident) => { $convert($value) };
    (@map output $value:tt $convert:ident) => { $convert($value) };
    (@map [fixed; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [tunable; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [state; $n:expr] $value:tt $convert:ident) => { $value.map($convert) };
    (@map [$Part:ident; $n:expr] $value:tt $convert:ident) => { $value.map(|part| part.map($convert)) };
    (@map ($Part:ident) $value:tt $convert:ident) => { $value.map($convert) };
    (@map $Part:ident $value:tt $convert:ident) => { $value.map($convert) };

    (@place $table:ident $at:ident $field:ident [fixed; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::Fixed, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [tunable; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::Tunable, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [state; $n:expr] = $columns:expr, $help:expr) => {
        $crate::model::place_all(&mut $table, $at, stringify!($field), $crate::model::Role::State, &$columns, $help)
    };
    (@place $table:ident $at:ident $field:ident [$Part:ident; $n:expr], $help:expr) => {
        $crate::model::graft_all(&mut $table, $at, stringify!($field), $n, <$Part as $crate::model::Columns>::TABLE)
    };
    (@place $table:ident $at:ident $field:ident [$Part:ident; $n:expr] = $starts:expr, $help:expr) => {
        $crate::model::graft_with(
            &mut $table, $at, stringify!($field), $n, <$Part as $crate::model::Columns>::TABLE, $starts)
    };
    (@place $table:ident $at:ident $field:ident ($Part:ident), $help:expr) => {
        $crate::model::inline(&mut $table, $at, <$Part as $crate::model::Columns>::TABLE)
    };
    (@place $table:ident $at:ident $field:ident $Part:ident, $help:expr) => {
        $crate::model::graft(
            &mut $table,
            $at,
            $crate::model::Segment { name: stringify!($field), index: 0 },
            <$Part as $crate::model::Columns>::TABLE,
        )
    };
    (@place $table:ident $at:ident $field:ident input = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Input $column, $help)
    };
    (@place $table:ident $at:ident $field:ident fixed = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Fixed $column, $help)
    };
    (@place $table:ident $at:ident $field:ident tunable = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Tunable $column, $help)
    };
    (@place $table:ident $at:ident $field:ident state = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field State $column, $help)
    };
    (@place $table:ident $at:ident $field:ident state_output = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field StateOutput $column, $help)
    };
    (@place $table:ident $at:ident $field:ident output = $column:expr, $help:expr) => {
        $crate::part!(@column $table $at $field Output $column, $help)
    };
    (@place $table:ident $at:ident $field:ident $Part:ident = $starts:expr, $help:expr) => {
        $crate::model::graft_one_with(
            &mut $table, $at, stringify!($field), <$Part as $crate::model::Columns>::TABLE, $starts)
    };

    (@column $table:ident $at:ident $field:ident $Role:ident $column:expr, $help:expr) => {
        $crate::model::place(&mut $table, $at, $column.named(
            $crate::model::Path::root(stringify!($field)), $crate::model::Role::$Role, $help))
    };
}

/// Declares a model: its struct, its table and its documentation, from one list.
///
/// A line reads `name: role = column` where the role is `input`, `fixed`, `tunable`, `state`, `state_output` or
/// `output`, and the column is made by [`real`], [`integer`], [`boolean`] or a choice; or it reads
/// `name: Part`, `name: [Part; count]` or `name: (Part)` for a [`part!`](crate::part!).
///
/// ```
/// use stribeck::model::{Columns, Law, Model, real};
/// use stribeck::number::Real;
///
/// stribeck::model! {
///     /// Coulomb friction without stiction, for the sake of the example.
///     Slider: "Coulomb friction" {
///         /// Sliding velocity.
///         velocity: input = real("m/s", 0.0),
///         /// Sliding friction force.
///         level: tunable = real("N", 1.0).at_least(0.0),
///         /// Friction force; has the sign of the velocity.
///         friction_force: output = real("N", 0.0),
///     }
/// }
///
/// impl<T: Real> Law for Slider<T> {
///     fn output(&mut self) {
///         self.friction_force = self.level * self.velocity.sign();
///     }
/// }
///
/// impl Model for Slider {
///     fn step(&mut self, _dt: f64) {}
/// }
///
/// let mut slider = Slider { velocity: -0.1, ..Slider::default() };
/// slider.output();
/// assert_eq!(slider.friction_force, -1.0);
/// assert_eq!(Slider::TABLE[1].path.to_string(), "level");
/// ```
#[macro_export]
macro_rules! model {
    ($(#[doc = $doc:expr])+ $Name:ident: $summary:literal { $($fields:tt)+ }) => {
        $crate::part! { $(#[doc = $doc])+ $Name { $($fields)+ } }

        // SAFETY: `Dual` is the same generic struct, for which `part!` makes the promise of `Columns`.
        unsafe impl $crate::model::Described for $Name {
            const NAME: &'static str = stringify!($Name);
            const C_NAME: &'static std::ffi::CStr = match std::ffi::CStr::from_bytes_with_nul(
                concat!(stringify!($Name), "\0").as_bytes(),
            ) {
                Ok(name) => name,
                Err(_) => panic!("a Rust name holds no zero byte"),
            };
            const SUMMARY: &'static str = $summary;
            const DOCUMENTATION: &'static str = concat!($($doc, "\n"),+);
            const PORTS: &'static [$crate::model::Port] =
                &$crate::model::ports::<{ <$Name as $crate::model::Width>::WIDTH }>(
                    <$Name as $crate::model::Columns>::TABLE);
            const REFERENCES: $crate::reference::References = $crate::reference::References::new(
                &$crate::reference::slots::<{
                    $crate::reference::slot_count(<$Name as $crate::model::Columns>::TABLE)
                }>(<$Name as $crate::model::Columns>::TABLE),
            );
            type Dual = $Name<$crate::number::Dual>;
        }

        impl Default for $Name {
            fn default() -> $Name {
                $crate::model::start()
            }
        }
    };
}

/// Writes a row as `name: value` pairs.
pub fn list<M: Columns>(model: &M, f: &mut fmt::Formatter) -> fmt::Result {
    let names = M::TABLE.iter().map(|variable| variable.path.to_string());
    f.debug_map().entries(names.zip(row_of(model))).finish()
}

/// A row of start values, as the struct.
pub fn start<M: Columns>() -> M {
    // A row of the right length is needed before it can be viewed; models are small, and this code is not critical for
    // speed.
    let row: Vec<f64> = M::TABLE.iter().map(|variable| variable.start).collect();
    *view::<M, f64>(&row)
}
