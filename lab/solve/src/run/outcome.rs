//! What came of a run.

use std::io::{self, Write};
use std::time::Duration;

use serde::Serialize;
use stribeck::model::ModelType;

use super::Solver;
use crate::solve::{End, Statistics};

/// A recorded quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, such as `rig.position`.
    pub name: String,
    /// Unit; `1` for a pure number.
    pub unit: String,
    /// Values at the output times.
    pub values: Vec<f64>,
}

/// An event of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Passed {
    /// When it occurred, in s.
    pub time: f64,
    /// The part that had it.
    pub part: String,
}

/// The outcome of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The friction law, if a part of the system can be any.
    pub law: Option<&'static ModelType>,
    /// The solver that was used.
    pub solver: Solver,
    /// Output times up to the end of the run, in s.
    pub time: Vec<f64>,
    /// The recorded quantities.
    pub columns: Vec<Column>,
    /// How the run ended.
    pub end: End,
    /// What it has cost.
    pub statistics: Statistics,
    /// The events.
    pub events: Vec<Passed>,
    /// Time on the clock; zero in a browser, where this library has none.
    pub elapsed: Duration,
}

impl Outcome {
    /// The values of a recorded quantity.
    pub fn values(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find(|column| column.name == name).map(|column| column.values.as_slice())
    }

    /// Headings of the table, with units.
    pub fn headings(&self) -> impl Iterator<Item = String> + '_ {
        let names = self.columns.iter().map(|column| format!("{} [{}]", column.name, column.unit));
        std::iter::once("time [s]".to_owned()).chain(names)
    }

    /// A row of the table.
    pub fn row(&self, number: usize) -> impl Iterator<Item = String> + '_ {
        let values = self.columns.iter().map(move |column| column.values[number].to_string());
        std::iter::once(self.time[number].to_string()).chain(values)
    }

    /// Writes the table: a heading with units, a row per output time.
    pub fn write_csv(&self, to: impl Write) -> io::Result<()> {
        let mut table = csv::Writer::from_writer(to);
        table.write_record(self.headings())?;
        (0..self.time.len()).try_for_each(|number| table.write_record(self.row(number)))?;
        table.flush()
    }
}
