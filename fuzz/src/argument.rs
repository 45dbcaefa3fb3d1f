//! Arguments: numbers, steps, points in time, columns.

use arbitrary::Arbitrary;
use stribeck::catalogue;
use stribeck::model::{ModelType, Role, Variable};
use stribeck::reference::{self, Place};

/// Numbers at the limits of plausible arguments.
const ODD: [f64; 16] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    1e308,
    -1e308,
    1e-310,
    -1e-310,
    f64::MIN_POSITIVE,
    f64::EPSILON,
    1e15,
    1.0,
    -1.0,
];

fn odd(which: u8) -> f64 {
    ODD[usize::from(which) % ODD.len()]
}

/// A power of ten from 1e-8 to 1e8.
fn decades(sixteenths: i8) -> f64 {
    10f64.powf(f64::from(sixteenths) / 16.0)
}

/// A model of the catalogue, by its index.
pub fn model(place: u8) -> &'static ModelType {
    let models: Vec<_> = catalogue::models().collect();
    models[usize::from(place) % models.len()]
}

/// A number for a variable.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Number {
    /// The start value.
    Start,
    /// The smallest value that the variable accepts.
    Least,
    /// The largest one.
    Most,
    /// The start value by a power of ten.
    Scaled(i8),
    /// Some thousandths of the usual size of the variable.
    Small(i16),
    /// A whole number.
    Whole(i8),
    /// One at the edges of floating point.
    Odd(u8),
    /// Any other.
    Any(f64),
}

impl Number {
    /// The number.
    pub fn of(self, variable: &Variable) -> f64 {
        match self {
            Number::Start => variable.start,
            Number::Least => variable.bound.min(),
            Number::Most => variable.bound.max(),
            Number::Scaled(by) => variable.start * decades(by),
            Number::Small(thousandths) => variable.nominal * f64::from(thousandths) * 1e-3,
            Number::Whole(number) => f64::from(number),
            Number::Odd(which) => odd(which),
            Number::Any(number) => number,
        }
    }

    /// The number, for an argument that does not belong to a variable.
    pub fn alone(self) -> f64 {
        match self {
            Number::Start => 0.0,
            Number::Least => f64::MIN,
            Number::Most => f64::MAX,
            Number::Scaled(by) => decades(by),
            Number::Small(thousandths) => f64::from(thousandths) * 1e-3,
            Number::Whole(number) => f64::from(number),
            Number::Odd(which) => odd(which),
            Number::Any(number) => number,
        }
    }
}

/// Length of a step in s.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Step {
    /// One that hosts make: some tenths of a millisecond.
    Usual(u8),
    /// A power of ten.
    Decades(i8),
    /// One at the edges of floating point.
    Odd(u8),
    /// Any other.
    Any(f64),
}

impl Step {
    /// The step.
    pub fn length(self) -> f64 {
        match self {
            Step::Usual(tenths) => (1.0 + f64::from(tenths)) * 1e-4,
            Step::Decades(by) => decades(by),
            Step::Odd(which) => odd(which),
            Step::Any(step) => step,
        }
    }
}

/// A point in time.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Instant {
    /// The present time of the instance.
    Present,
    /// Some units in the last place away.
    Near(i8),
    /// Some time away.
    Later(Number),
    /// Any.
    At(Number),
}

impl Instant {
    /// The time, for an instance at the present one.
    pub fn of(self, present: f64) -> f64 {
        match self {
            Instant::Present => present,
            Instant::Near(units) => present + f64::from(units) * f64::EPSILON * present.abs(),
            Instant::Later(by) => present + by.alone(),
            Instant::At(number) => number.alone(),
        }
    }
}

/// A column of a table, mostly one that exists.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Column {
    /// One of the table, or a few beyond it.
    Near(u16),
    /// One of those with this role.
    With(Wanted, u8),
    /// Any number.
    Any(u32),
}

/// Role of a column.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Wanted {
    /// Input.
    Input,
    /// Parameter.
    Parameter,
    /// State.
    State,
    /// Result.
    Output,
}

impl Wanted {
    fn is(self, role: Role) -> bool {
        match self {
            Wanted::Input => role == Role::Input,
            Wanted::Parameter => role.is_parameter(),
            Wanted::State => role.is_state(),
            Wanted::Output => role.is_output(),
        }
    }
}

/// The variable of a value reference, if there is one.
pub fn variable(model: &ModelType, reference: u32) -> Option<Variable> {
    column(model, reference).map(|column| model.table.at(column))
}

/// The column of a value reference, if there is one.
pub fn column(model: &ModelType, reference: u32) -> Option<usize> {
    match model.place(reference) {
        Some(Place::Column(column)) => Some(column),
        _ => None,
    }
}

impl Column {
    /// Its value reference.
    pub fn of(self, model: &ModelType) -> u32 {
        match self {
            Column::Near(number) => {
                let others = || model.derivative_references().chain([reference::TIME, 0]);
                let number = usize::from(number) % (model.table.len() + others().count());
                let behind = number.checked_sub(model.table.len());
                behind.map_or_else(|| model.reference(number), |at| others().nth(at).unwrap_or_default())
            }
            Column::With(wanted, which) => {
                let columns: Vec<usize> =
                    (0..model.table.len()).filter(|column| wanted.is(model.table.at(*column).role)).collect();
                columns.get(usize::from(which) % columns.len().max(1)).map_or(0, |column| model.reference(*column))
            }
            Column::Any(number) => number,
        }
    }
}
