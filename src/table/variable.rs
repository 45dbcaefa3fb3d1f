//! Columns of a model and their properties: role, kind, start value, bound.

use super::{Bound, Brief, Fault, Meaning, Path};
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
    /// Name of the kind in the interfaces, and its unit.
    pub const fn words(self) -> [&'static str; 2] {
        match self {
            Kind::Real(unit) => ["real", unit.name],
            Kind::Integer => ["integer", ""],
            Kind::Boolean => ["boolean", ""],
            Kind::Enumeration(_) => ["choice", ""],
        }
    }

    /// The choices, if it has some.
    pub const fn choices(self) -> &'static [Item] {
        if let Kind::Enumeration(choices) = self { choices.items } else { &[] }
    }

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
    is_advice: bool,
    is_hidden: bool,
    is_odd: bool,
    meaning: Meaning,
    help: &'static str,
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
            is_advice: false,
            is_hidden: false,
            is_odd: false,
            meaning: Meaning::Undeclared,
            help: "",
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

    /// A continuous state that [`Model::at_event`](crate::model::Model::at_event) may change.
    pub const fn reinit(mut self) -> Column {
        self.reinit = true;
        self
    }

    /// A result that is advice: [`Law::advise`](crate::model::Law::advise) computes it, only when it is read. It comes
    /// from differences and cannot be differentiated itself.
    pub const fn advice(mut self) -> Column {
        self.is_advice = true;
        self
    }

    /// A state that no importer needs by name. It is saved and restored like the others, but it is not a variable of
    /// the interfaces: the memory of a model may change without them.
    pub const fn hidden(mut self) -> Column {
        self.is_hidden = true;
        self
    }

    /// A quantity that changes its sign when the motion is mirrored.
    pub const fn odd(mut self) -> Column {
        self.is_odd = true;
        self
    }

    /// The part that it plays in a law of friction.
    pub const fn means(mut self, meaning: Meaning) -> Column {
        self.meaning = meaning;
        self
    }

    /// Another start value.
    pub const fn start(mut self, start: f64) -> Column {
        self.start = start;
        self
    }

    /// A help text that comes with the column.
    pub const fn help(mut self, help: &'static str) -> Column {
        self.help = help;
        self
    }

    /// The finished variable, with this help text or, if it is empty, with that of the column. A start value outside
    /// its own bound does not compile, nor does a column with two help texts.
    pub const fn named(self, path: Path, role: Role, help: &'static str) -> Variable {
        assert!(self.bound.admits(self.start), "the start value is outside its bound");
        assert!(help.is_empty() || self.help.is_empty(), "the column has a help text of its own");
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
            is_advice: self.is_advice,
            is_hidden: self.is_hidden,
            is_odd: self.is_odd,
            meaning: self.meaning,
            help: if help.is_empty() { self.help.trim_ascii() } else { help.trim_ascii() },
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
    /// Whether it is advice: see [`Column::advice`].
    pub is_advice: bool,
    /// Whether it is missing in the interfaces: see [`Column::hidden`].
    pub is_hidden: bool,
    /// Whether it changes its sign when the motion is mirrored.
    pub is_odd: bool,
    /// The part that it plays in a law of friction.
    pub meaning: Meaning,
    /// Description: one line of ASCII text.
    pub help: &'static str,
}

impl Variable {
    /// Whether the column admits `value`. Integer columns admit integers only.
    #[inline]
    pub fn admits(&self, value: f64) -> bool {
        self.bound.admits(value) && (matches!(self.kind, Kind::Real(_)) || value.fract() == 0.0)
    }

    /// Whether it is a state that moves with time, as given by [`Derivatives::derivatives`](crate::model::Derivatives::derivatives).
    pub const fn is_continuous_state(&self) -> bool {
        self.role.is_state() && !self.jumps
    }

    /// Whether only an event of Model Exchange sets it, as is the case for every choice that is a state. Steps have no
    /// events, so it keeps its start value there.
    pub const fn is_settled_by_events(&self) -> bool {
        self.role.is_state() && matches!(self.kind, Kind::Enumeration(_))
    }

    /// Outputs that must be computed before the column can be read.
    pub const fn needs(&self) -> Computed {
        Computed::before(self.role, self.is_advice)
    }

    /// Rejects values that steps do not admit, with the message for the user.
    pub fn check_for_steps(&self, value: f64) -> Result<(), Fault> {
        if self.admits(value) { self.check_without_events(value) } else { Err(self.fault(value)) }
    }

    /// Rejects a value that only an event can produce.
    pub fn check_without_events(&self, value: f64) -> Result<(), Fault> {
        if self.is_settled_by_events() && value != self.start {
            let text = "without events, which only Model Exchange has";
            return Err(Fault::new(format_args!("{} = {}: must be {} {text}", self.path, Brief(value), self.start)));
        }
        Ok(())
    }

    /// Rejects differentiating a result that is advice.
    pub fn check_derivatives(&self) -> Result<(), Fault> {
        if self.is_advice { Err(Fault::new(format_args!("{} has no derivatives", self.path))) } else { Ok(()) }
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

/// The outputs of a row that follow its other columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Computed {
    /// None.
    Nothing,
    /// All but advice.
    Main,
    /// All.
    All,
}

impl Computed {
    /// Outputs that must be computed before a column of that role can be read.
    pub(super) const fn before(role: Role, is_advice: bool) -> Computed {
        match role {
            Role::Output if is_advice => Computed::All,
            Role::Output => Computed::Main,
            _ => Computed::Nothing,
        }
    }
}

/// The column that plays a part, not within a part of the model.
pub const fn column_of(table: &[Variable], meaning: Meaning) -> Option<usize> {
    let mut column = 0;
    while column < table.len() {
        if table[column].meaning as u8 == meaning as u8 && table[column].path.segments().len() == 1 {
            return Some(column);
        }
        column += 1;
    }
    None
}

/// Whether each number among the parameters says what it is for.
pub const fn is_declared(table: &[Variable]) -> bool {
    let mut column = 0;
    while column < table.len() {
        let Variable { role, kind, meaning, .. } = &table[column];
        let is_parameter = matches!(role, Role::Fixed | Role::Tunable) && matches!(kind, Kind::Real(_) | Kind::Integer);
        if is_parameter && matches!(meaning, Meaning::Undeclared) {
            return false;
        }
        column += 1;
    }
    true
}
