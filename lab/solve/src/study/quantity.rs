//! Numbers that are kept of a run.

use std::fmt;
use std::str::FromStr;

use crate::run::Outcome;
use crate::system::Fault;

/// A number that is kept of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// Largest value of a result at the output times.
    Max(String),
    /// Smallest value.
    Min(String),
    /// Mean over the time, by the trapezoidal rule.
    Mean(String),
    /// Value at the end.
    Last(String),
    /// Number of events.
    Events,
}

impl Quantity {
    /// The result it is taken from.
    pub fn result(&self) -> Option<&str> {
        match self {
            Quantity::Max(name) | Quantity::Min(name) | Quantity::Mean(name) | Quantity::Last(name) => Some(name),
            Quantity::Events => None,
        }
    }

    /// Its value.
    pub(super) fn of(&self, outcome: &Outcome) -> f64 {
        let values = self.result().and_then(|name| outcome.values(name)).unwrap_or(&[]);
        match self {
            Quantity::Max(_) => values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Quantity::Min(_) => values.iter().copied().fold(f64::INFINITY, f64::min),
            Quantity::Mean(_) => mean(&outcome.time, values),
            Quantity::Last(_) => values.last().copied().unwrap_or(f64::NAN),
            Quantity::Events => outcome.events.len() as f64,
        }
    }
}

fn mean(time: &[f64], values: &[f64]) -> f64 {
    let pieces = time.windows(2).zip(values.windows(2));
    let area: f64 = pieces.map(|(time, values)| 0.5 * (values[0] + values[1]) * (time[1] - time[0])).sum();
    let [first, .., last] = time else { return f64::NAN };
    area / (last - first)
}

impl FromStr for Quantity {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Quantity, Fault> {
        const KNOWN: [&str; 5] = ["max", "min", "mean", "last", "events"];
        match text.split_whitespace().collect::<Vec<&str>>().as_slice() {
            ["max", name] => Ok(Quantity::Max((*name).to_owned())),
            ["min", name] => Ok(Quantity::Min((*name).to_owned())),
            ["mean", name] => Ok(Quantity::Mean((*name).to_owned())),
            ["last", name] => Ok(Quantity::Last((*name).to_owned())),
            ["events"] => Ok(Quantity::Events),
            [word, _] if !KNOWN.contains(word) => Err(Fault::unknown("quantity", word, KNOWN)),
            _ => {
                let text = format_args!("keep '{text}': must be max, min, mean or last and a result, or events");
                Err(Fault::value(text))
            }
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Quantity::Max(name) => write!(f, "max {name}"),
            Quantity::Min(name) => write!(f, "min {name}"),
            Quantity::Mean(name) => write!(f, "mean {name}"),
            Quantity::Last(name) => write!(f, "last {name}"),
            Quantity::Events => write!(f, "events"),
        }
    }
}
