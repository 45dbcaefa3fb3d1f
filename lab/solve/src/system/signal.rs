//! Signals: the course of an input over time.

use std::path::Path;

use serde::{Deserialize, Serialize};
use stribeck::number::elementary::{cos, sin};
use stribeck_sheet::{SheetError, TIME, of_file, table};

use super::Fault;

/// Course of an input over time.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Signal {
    /// A constant.
    Constant(f64),
    /// One of the other courses.
    Course(Course),
}

/// Course of a signal that moves.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Course {
    /// `from` until the time `start`, then it rises with `rate` per second until it has reached `to`.
    Ramp {
        /// First value.
        #[serde(default)]
        from: f64,
        /// Change per second.
        rate: f64,
        /// Time at which it begins to change.
        #[serde(default)]
        start: f64,
        /// Last value; none if it goes on.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        to: Option<f64>,
    },
    /// mean + amplitude sin(2 pi frequency t + phase).
    Sine {
        /// Mean value.
        #[serde(default)]
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// Frequency in Hz.
        frequency: f64,
        /// Phase in rad.
        #[serde(default)]
        phase: f64,
    },
    /// Straight lines between mean + amplitude and mean - amplitude; it begins at the mean and rises.
    Triangle {
        /// Mean value.
        #[serde(default)]
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// Frequency in Hz.
        frequency: f64,
    },
    /// The rate of a signal.
    #[serde(skip)]
    Derivative(Box<Signal>),
    /// The rate of the signal of another input, by its name.
    #[serde(rename = "rate-of")]
    RateOf(String),
    /// Points joined by straight lines; the first and last value hold before and after them.
    Points {
        /// Times, ascending.
        time: Vec<f64>,
        /// Values.
        value: Vec<f64>,
    },
    /// Two columns of a table, joined by straight lines.
    Csv {
        /// The file, relative to the system file.
        file: String,
        /// Heading of the column of times.
        #[serde(default = "time")]
        time: String,
        /// Heading of the column of values.
        column: String,
    },
}

fn time() -> String {
    "time".to_owned()
}

impl Signal {
    /// The numbers by which it moves, with their names: they can be set.
    pub fn properties(&mut self) -> Vec<(&'static str, &mut f64)> {
        match self {
            Signal::Course(Course::Ramp { from, rate, start, to }) => {
                let to = to.iter_mut().map(|to| ("to", to));
                [("from", from), ("rate", rate), ("start", start)].into_iter().chain(to).collect()
            }
            Signal::Course(Course::Sine { mean, amplitude, frequency, phase }) => {
                vec![("mean", mean), ("amplitude", amplitude), ("frequency", frequency), ("phase", phase)]
            }
            Signal::Course(Course::Triangle { mean, amplitude, frequency }) => {
                vec![("mean", mean), ("amplitude", amplitude), ("frequency", frequency)]
            }
            _ => Vec::new(),
        }
    }

    /// Its rate.
    pub fn rate(self) -> Signal {
        match self {
            Signal::Constant(_) => Signal::Constant(0.0),
            // The rate of the rate of a sine is a sine again; that of straight lines is 0.
            Signal::Course(Course::Derivative(inner)) => match *inner {
                Signal::Course(Course::Sine { amplitude, frequency, phase, .. }) => {
                    let omega = 2.0 * std::f64::consts::PI * frequency;
                    Signal::Course(Course::Sine { mean: 0.0, amplitude: -amplitude * omega * omega, frequency, phase })
                }
                _ => Signal::Constant(0.0),
            },
            moving => Signal::Course(Course::Derivative(Box::new(moving))),
        }
    }

    /// The same signal with its points read from its file; its values have the SI unit of the input that they are for.
    pub fn loaded(&self, folder: &Path, unit: &str) -> Result<Signal, Fault> {
        let signal = match self {
            Signal::Course(Course::Csv { file, time, column }) => {
                let (time, value) = read(&folder.join(file), time, [column, unit])?;
                Signal::Course(Course::Points { time, value })
            }
            other => other.clone(),
        };
        signal.check()?;
        Ok(signal)
    }

    fn check(&self) -> Result<(), Fault> {
        let numbers: Vec<f64> = match self {
            Signal::Constant(value) => vec![*value],
            Signal::Course(Course::Ramp { from, rate, start, to }) => vec![*from, *rate, *start, to.unwrap_or(0.0)],
            Signal::Course(Course::Sine { mean, amplitude, frequency, phase }) => {
                vec![*mean, *amplitude, *frequency, *phase]
            }
            Signal::Course(Course::Triangle { mean, amplitude, frequency }) => vec![*mean, *amplitude, *frequency],
            Signal::Course(Course::Points { time, value }) => {
                if time.len() != value.len() || time.is_empty() {
                    return Err(Fault::value(format_args!("{} times and {} values", time.len(), value.len())));
                }
                if let Some(at) = (1..time.len()).find(|at| time[*at] <= time[at - 1]) {
                    let (before, now) = (time[at - 1], time[at]);
                    return Err(Fault::value(format_args!("time {now} after time {before}: times must ascend")));
                }
                time.iter().chain(value).copied().collect()
            }
            Signal::Course(Course::Csv { .. } | Course::RateOf(_)) => Vec::new(),
            Signal::Course(Course::Derivative(signal)) => return signal.check(),
        };
        match numbers.iter().find(|number| !number.is_finite()) {
            Some(number) => Err(Fault::value(format_args!("{number} in a signal: must be a finite number"))),
            None => Ok(()),
        }
    }

    /// Value and rate at a time; the rate is that after the time where there is a kink.
    pub fn at(&self, t: f64) -> (f64, f64) {
        match self {
            Signal::Constant(value) => (*value, 0.0),
            Signal::Course(Course::Ramp { from, rate, start, to }) => {
                let end = to.map_or(f64::INFINITY, |to| ramp_end(*from, *rate, *start, to));
                if t < *start {
                    (*from, 0.0)
                } else if t < end {
                    (from + rate * (t - start), *rate)
                } else {
                    (to.unwrap_or(*from), 0.0)
                }
            }
            Signal::Course(Course::Sine { mean, amplitude, frequency, phase }) => {
                let omega = 2.0 * std::f64::consts::PI * frequency;
                let angle = omega * t + phase;
                (mean + amplitude * sin(angle), amplitude * omega * cos(angle))
            }
            Signal::Course(Course::Triangle { mean, amplitude, frequency }) => {
                let turn = turns(t, *frequency);
                let rate = if turn % 2.0 == 0.0 { 4.0 } else { -4.0 } * amplitude * frequency;
                // At the turn the rate is that of the line that begins there.
                let middle = 0.5 * turn / frequency;
                if *frequency == 0.0 { (*mean, 0.0) } else { (mean + rate * (t - middle), rate) }
            }
            Signal::Course(Course::Points { time, value }) => {
                let after = time.partition_point(|at| *at <= t);
                if after == 0 {
                    (value[0], 0.0)
                } else if after == time.len() {
                    (value[after - 1], 0.0)
                } else {
                    let slope = (value[after] - value[after - 1]) / (time[after] - time[after - 1]);
                    (value[after - 1] + slope * (t - time[after - 1]), slope)
                }
            }
            Signal::Course(Course::Derivative(signal)) => (signal.at(t).1, signal.second_rate(t)),
            Signal::Course(Course::Csv { .. } | Course::RateOf(_)) => (f64::NAN, f64::NAN),
        }
    }

    /// Rate of the rate; that of straight lines is 0.
    fn second_rate(&self, t: f64) -> f64 {
        match self {
            Signal::Course(Course::Sine { amplitude, frequency, phase, .. }) => {
                let omega = 2.0 * std::f64::consts::PI * frequency;
                -amplitude * omega * omega * sin(omega * t + phase)
            }
            _ => 0.0,
        }
    }

    /// The next time after `t` at which the rate jumps.
    pub fn next_break(&self, t: f64) -> f64 {
        match self {
            Signal::Course(Course::Ramp { from, rate, start, to }) => {
                let end = to.map_or(f64::INFINITY, |to| ramp_end(*from, *rate, *start, to));
                [*start, end].into_iter().find(|at| *at > t).unwrap_or(f64::INFINITY)
            }
            Signal::Course(Course::Points { time, .. }) => {
                time.get(time.partition_point(|at| *at <= t)).copied().unwrap_or(f64::INFINITY)
            }
            Signal::Course(Course::Triangle { frequency, .. }) if *frequency > 0.0 => {
                (0.5 * turns(t, *frequency) + 0.25) / frequency
            }
            Signal::Course(Course::Derivative(signal)) => signal.next_break(t),
            _ => f64::INFINITY,
        }
    }
}

/// Turns of a triangle up to a time; the next one is at a quarter of a period after half of them.
fn turns(t: f64, frequency: f64) -> f64 {
    let count = (2.0 * frequency * t + 0.5).floor();
    // The time of the next turn, as a solver is told it, belongs to the line that begins there.
    if t >= (0.5 * count + 0.25) / frequency { count + 1.0 } else { count }
}

/// Time at which a ramp reaches its last value; it never does if it moves away from it.
fn ramp_end(from: f64, rate: f64, start: f64, to: f64) -> f64 {
    let end = start + (to - from) / rate;
    if end >= start { end } else { f64::INFINITY }
}

/// Times, and values in an SI unit, of a file of any format that records have.
fn read(file: &Path, time: &str, [column, unit]: [&str; 2]) -> Result<(Vec<f64>, Vec<f64>), Fault> {
    let columns = || {
        let sheet = table(file, None)?;
        if sheet.is_empty() {
            return Err(SheetError::Empty);
        }
        Ok((sheet.required(time, &TIME)?, sheet.values(column, unit)?))
    };
    columns().map_err(|error: SheetError| Fault::File(of_file(file, &error)))
}
