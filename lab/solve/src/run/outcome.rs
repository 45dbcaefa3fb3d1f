//! What came of a run.

use std::fmt::Display;
use std::io::{self, Write};
use std::time::Duration;

use serde::{Serialize, Serializer};
use stribeck::model::{Brief, ModelType};
use ts_rs::TS;

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

/// The difference of a run from one at a tenth of its steps' tolerance, or of its communication step.
#[derive(Clone, Debug, PartialEq, Serialize, TS)]
pub struct Check {
    /// What was made finer.
    pub of: Finer,
    /// The tolerance of the finer run, or its communication step in s.
    pub finer: f64,
    /// How the finer run ended.
    #[serde(serialize_with = "shown")]
    #[ts(type = "string")]
    pub end: End,
    /// The largest difference of each recorded result.
    pub differences: Vec<Difference>,
    /// Why the tolerance or the step does not hold; none if it does.
    pub fault: Option<String>,
}

/// What sets the accuracy of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, TS)]
#[serde(rename_all = "kebab-case")]
pub enum Finer {
    /// The tolerance.
    Tolerance,
    /// The communication step.
    Step,
}

/// The largest difference of a result from that of the finer run, over the output times.
#[derive(Clone, Debug, PartialEq, Serialize, TS)]
pub struct Difference {
    /// Name of the result.
    pub name: String,
    /// Unit of the result.
    pub unit: String,
    /// The difference, without sign.
    pub largest: f64,
    /// The same in parts of the range, from the smallest to the largest value of both runs; 0 without a difference.
    pub part: f64,
    /// Output time of the difference, in s.
    pub time: f64,
}

impl Difference {
    /// The time with ten digits: output times such as 30.01 have an error in their last.
    pub fn shown_time(&self) -> String {
        let text = format!("{:.9e}", self.time);
        text.parse::<f64>().map_or(text, |time| time.to_string())
    }
}

/// Writes a text.
pub(super) fn shown<S: Serializer>(what: &impl Display, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(what)
}

impl Finer {
    /// The finer run in words.
    pub fn run(self, finer: f64) -> String {
        match self {
            Finer::Tolerance => format!("a run at {finer:e}"),
            Finer::Step => format!("a run with steps of {} s", Brief(finer)),
        }
    }

    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Finer::Tolerance => "tolerance",
            Finer::Step => "step",
        }
    }
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
    /// The difference from a finer run, if one was asked for and the run came to its end.
    pub check: Option<Check>,
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
