//! Parts of equations of motion: where their numbers stand, and the functions of their models in two kinds of them.

use std::ops::Range;

use stribeck::catalogue;
use stribeck::model::{Evaluate, Model, ModelType, Visitor, output_and_rate_in, output_in, rate_in};
use stribeck::number::Gradient;

use super::Place;
use super::order::indicators_move;
use super::part::{System, WireSource};

/// A part under way.
pub(super) struct Mover {
    pub model: &'static ModelType,
    /// Its functions for values.
    pub level: Functions<f64>,
    /// Its functions for values with slopes.
    pub inclined: Functions<Gradient>,
    /// Its place in the rows of all parts.
    pub columns: Range<usize>,
    pub name: String,
    /// Whether one of its states is integrated.
    pub moves: bool,
    /// Number of its event indicators, if they change.
    pub indicators: usize,
    /// Computed outputs that are passed on, in the rows of all parts.
    pub passed: Vec<usize>,
}

/// Functions of a model for a row.
#[derive(Clone, Copy)]
pub(super) struct Functions<T> {
    /// Writes outputs, but for advice, which no input can take.
    pub output: fn(&mut [T]),
    /// Writes outputs and rates.
    pub respond: fn(&mut [T], &mut [T]),
    /// Writes rates.
    pub rate: fn(&[T], &mut [T]),
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
    /// The parts of a system that integrates these states, each with its columns that change. Their models must have rates.
    pub fn all(system: &System, states: &[Place], moving: &[Vec<usize>]) -> Vec<Mover> {
        let mut first = 0;
        let mover = |(number, moving): (usize, &Vec<usize>)| {
            let mover = Mover::new(system, number, first, states, moving);
            first = mover.columns.end;
            mover
        };
        moving.iter().enumerate().map(mover).collect()
    }

    fn new(system: &System, number: usize, first: usize, states: &[Place], moving: &[usize]) -> Mover {
        let part = &system.parts[number];
        let mut search = Search { name: part.model.name, found: None };
        catalogue::visit(&mut search);
        let (level, inclined) = search.found.expect("models with rates are in the catalogue");
        Mover {
            model: part.model,
            level,
            inclined,
            columns: first..first + part.row.len(),
            name: part.name.clone(),
            moves: states.iter().any(|place| place.part == number),
            indicators: if indicators_move(part, moving) { part.model.event_indicators } else { 0 },
            passed: passed(system, number).map(|column| first + column).collect(),
        }
    }
}

/// The computed outputs of a part that are passed on.
fn passed(system: &System, part: usize) -> impl Iterator<Item = usize> {
    let sources = system.wires.iter().filter_map(|wire| match wire.from {
        WireSource::Variable(from) => Some(from),
        WireSource::Derivative(_) => None,
    });
    let computed = sources.filter(move |from| from.part == part && system.variable(*from).role.is_computed());
    computed.map(|from| from.column)
}
