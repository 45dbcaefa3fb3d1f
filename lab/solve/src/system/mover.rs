//! Parts of equations of motion: rows of their numbers, and the functions of their models in two kinds of them.

use stribeck::catalogue;
use stribeck::model::{Evaluate, Model, ModelType, Visitor, output_and_rate_in, output_in, rate_in};
use stribeck::number::Gradient;

use super::Place;
use super::order::indicators_move;
use super::part::{System, WireSource};

/// A part under way.
pub(super) struct Mover {
    pub model: &'static ModelType,
    functions: Functions<f64>,
    of_slopes: Functions<Gradient>,
    pub row: Vec<f64>,
    pub rate: Vec<f64>,
    /// The row with slopes, as far as it changes.
    pub inclined: Vec<Gradient>,
    pub inclined_rate: Vec<Gradient>,
    pub name: String,
    /// Whether one of its states is integrated.
    pub moves: bool,
    /// Number of its event indicators, if they change.
    pub indicators: usize,
    /// Columns that change in time, outputs apart.
    changing: Vec<usize>,
    /// Computed outputs that are passed on.
    passed: Vec<usize>,
    /// Whether a column that changes has a slope.
    pub has_slope: bool,
}

/// Functions of a model for a row.
#[derive(Clone, Copy)]
struct Functions<T> {
    /// Writes outputs.
    output: fn(&mut [T]),
    /// Writes outputs and rates.
    respond: fn(&mut [T], &mut [T]),
    /// Writes rates.
    rate: fn(&[T], &mut [T]),
}

impl<T: Evaluate> Functions<T> {
    fn of<M: Model>() -> Functions<T> {
        Functions {
            output: |row| output_in::<M, T>(row, &[]),
            respond: output_and_rate_in::<M, T>,
            rate: rate_in::<M, T>,
        }
    }
}

/// Search for the functions of a model.
struct Search {
    name: &'static str,
    found: Option<(Functions<f64>, Functions<Gradient>)>,
}

impl Visitor for Search {
    fn visit<M: Model>(&mut self) {
        // Models without rates need no code.
        if const { ModelType::of::<M>().has_rates } && M::NAME == self.name {
            self.found = Some((Functions::of::<M>(), Functions::of::<M>()));
        }
    }
}

impl Mover {
    /// A part of a system that integrates these states, with its columns that change. The model must have rates.
    pub fn new(system: &System, number: usize, states: &[Place], moving: &[usize]) -> Mover {
        let part = &system.parts[number];
        let mut search = Search { name: part.model.name, found: None };
        catalogue::visit(&mut search);
        let (functions, of_slopes) = search.found.expect("models with rates are in the catalogue");
        let zero = vec![Gradient::default(); part.row.len()];
        Mover {
            model: part.model,
            functions,
            of_slopes,
            rate: vec![0.0; part.row.len()],
            row: part.row.clone(),
            inclined: zero.clone(),
            inclined_rate: zero,
            name: part.name.clone(),
            moves: states.iter().any(|place| place.part == number),
            indicators: if indicators_move(part, moving) { part.model.event_indicators } else { 0 },
            changing: moving.to_vec(),
            passed: passed(system, number),
            has_slope: false,
        }
    }

    /// Computes the outputs.
    pub fn output(&mut self) {
        self.model.output(&mut self.row);
    }

    /// Computes outputs and rates.
    pub fn respond(&mut self) {
        (self.functions.respond)(&mut self.row, &mut self.rate);
    }

    /// Computes rates.
    pub fn find_rates(&mut self) {
        (self.functions.rate)(&self.row, &mut self.rate);
    }

    /// Takes the values of all columns over.
    pub fn spread(&mut self) {
        for (inclined, value) in self.inclined.iter_mut().zip(&self.row) {
            *inclined = Gradient::from(*value);
        }
    }

    /// Takes the values of those columns over that have changed since [`Mover::spread`], outputs apart.
    pub fn spread_changing(&mut self) {
        for column in &self.changing {
            self.inclined[*column] = Gradient::from(self.row[*column]);
        }
        self.has_slope = false;
    }

    /// Computes the outputs with their slopes.
    pub fn incline_outputs(&mut self) {
        if self.has_slope {
            (self.of_slopes.output)(&mut self.inclined);
        } else {
            self.output();
            self.pass_level();
        }
    }

    /// Computes outputs and rates with their slopes.
    pub fn incline_response(&mut self) {
        if self.has_slope {
            (self.of_slopes.respond)(&mut self.inclined, &mut self.inclined_rate);
        } else {
            self.respond();
            self.pass_level();
        }
    }

    /// Computes rates with their slopes.
    pub fn incline_rates(&mut self) {
        if self.has_slope {
            (self.of_slopes.rate)(&self.inclined, &mut self.inclined_rate);
        } else {
            self.find_rates();
        }
    }

    /// Outputs without slopes.
    fn pass_level(&mut self) {
        for column in &self.passed {
            self.inclined[*column] = Gradient::from(self.row[*column]);
        }
    }

    /// The rate in a column.
    pub fn inclined_rate(&self, column: usize) -> Gradient {
        if self.has_slope { self.inclined_rate[column] } else { Gradient::from(self.rate[column]) }
    }

    /// Gives a column a slope in a direction.
    pub fn incline(&mut self, column: usize, direction: usize, slope: f64) {
        self.inclined[column].slopes[direction] = slope;
        self.has_slope |= slope != 0.0;
    }

    /// Gives an input a value with slopes.
    pub fn take(&mut self, column: usize, value: Gradient) {
        self.row[column] = value.value;
        self.inclined[column] = value;
        self.has_slope |= value.has_slope();
    }
}

/// The computed outputs of a part that are passed on.
fn passed(system: &System, part: usize) -> Vec<usize> {
    let sources = system.wires.iter().filter_map(|wire| match wire.from {
        WireSource::Variable(from) => Some(from),
        WireSource::Derivative(_) => None,
    });
    let computed = sources.filter(|from| from.part == part && system.variable(*from).role.is_computed());
    computed.map(|from| from.column).collect()
}
