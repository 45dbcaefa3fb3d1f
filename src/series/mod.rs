//! A model over given inputs: samples in, results out; and its results at held inputs, once they have settled. C, Python
//! and whoever else follows a series of samples do it here, with the same bits.

mod settled;
#[cfg(test)]
mod steady_tests;
#[cfg(test)]
mod tests;

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::instance::{Instance, Phase, Refused};
use crate::memory::OutOfMemory;
use crate::model::{Brief, Fault};

pub use settled::settle;

/// How inputs move between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// Along a straight line; inputs that are not real numbers are held.
    Linear,
    /// Held at the earlier sample, as FMI 2.0 does it without input derivatives.
    Held,
}

/// Samples of an input.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// Its column.
    pub column: usize,
    /// One value, or one per sample.
    pub samples: &'a [f64],
}

impl Input<'_> {
    #[inline]
    fn at(&self, sample: usize) -> f64 {
        self.samples[if self.samples.len() == 1 { 0 } else { sample }]
    }
}

/// Times of the samples.
#[derive(Clone, Copy, Debug)]
pub enum Times<'a> {
    /// The same interval, in s, between all of them.
    Every(f64),
    /// Each time, in s.
    At(&'a [f64]),
}

impl Times<'_> {
    /// Step from a sample to the next one.
    #[inline]
    pub(crate) fn step(&self, sample: usize) -> f64 {
        match self {
            Times::Every(dt) => *dt,
            Times::At(times) => times[sample + 1] - times[sample],
        }
    }

    /// Time of a sample.
    pub fn at(&self, sample: usize) -> f64 {
        match self {
            Times::Every(dt) => *dt * sample as f64,
            Times::At(times) => times[sample],
        }
    }
}

/// Inputs of a run and how they are followed.
#[derive(Clone, Copy, Debug)]
pub struct Course<'a> {
    /// The inputs.
    pub inputs: &'a [Input<'a>],
    /// When their samples are taken.
    pub times: Times<'a>,
    /// Number of samples.
    pub samples: usize,
    /// How inputs move between them.
    pub between: Between,
}

/// Why a run did not come to its end.
#[derive(Debug)]
pub enum Ended {
    /// A parameter was refused.
    Setup(Box<Refused>),
    /// A value was refused, or a result would not be finite.
    At {
        /// The sample, from 0.
        sample: usize,
        /// Its time in s.
        time: f64,
        /// The reason, with name, value and limit.
        reason: Box<Refused>,
    },
    /// The results do not settle.
    Unsettled(Fault),
    /// It was ended from outside.
    Cancelled,
    /// Memory has run out.
    OutOfMemory,
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Ended::Setup(reason) => reason.fmt(f),
            Ended::At { sample, time, reason } => write!(f, "sample {sample} (t = {} s): {reason}", Brief(*time)),
            Ended::Unsettled(reason) => reason.fmt(f),
            Ended::Cancelled => write!(f, "cancelled"),
            Ended::OutOfMemory => OutOfMemory.fmt(f),
        }
    }
}

impl std::error::Error for Ended {}

impl Ended {
    fn setup(reason: Refused) -> Ended {
        Ended::Setup(Box::new(reason))
    }
}

/// Sets parameters, all or none, and checks them against each other.
pub fn set_up(instance: &mut Instance, parameters: &[(usize, f64)]) -> Result<(), Ended> {
    let set = instance.set_all(Phase::Setup, parameters.iter().copied());
    set.and_then(|()| instance.check().map_err(Refused::Value)).map_err(Ended::setup)
}

/// Samples between two looks at the flag that ends a run.
pub(crate) const PATIENCE: usize = 1024;

/// Follows a course from the present state. The results at a sample are those with its inputs; `rows` has an array of one
/// value per sample for each of the columns `results`.
pub fn follow(
    instance: &mut Instance,
    course: &Course,
    results: &[usize],
    rows: &mut [&mut [f64]],
    cancel: &AtomicBool,
) -> Result<(), Ended> {
    follow_into(instance, course, results, rows, 0, cancel)
}

/// As [`follow`], with the value of the first sample at the place `first` of each array.
pub(crate) fn follow_into(
    instance: &mut Instance,
    course: &Course,
    results: &[usize],
    rows: &mut [&mut [f64]],
    first: usize,
    cancel: &AtomicBool,
) -> Result<(), Ended> {
    let Course { inputs, times, samples, between } = *course;
    check(instance, course)?;
    for sample in 0..samples {
        if sample % PATIENCE == 0 && cancel.load(Ordering::Relaxed) {
            return Err(Ended::Cancelled);
        }
        let at = |reason: Refused| Ended::At { sample, time: times.at(sample), reason: Box::new(reason) };
        // All have been checked.
        inputs.iter().for_each(|input| instance.write(input.column, input.at(sample)));
        for (column, row) in results.iter().zip(rows.iter_mut()) {
            row[first + sample] = instance.get_column(*column).map_err(at)?;
        }
        if sample + 1 < samples {
            let step = times.step(sample);
            if between == Between::Linear {
                incline(instance, inputs, sample, step).map_err(at)?;
            }
            instance.step(step).map_err(|fault| at(Refused::NotFinite(fault)))?;
        }
    }
    Ok(())
}

/// Refuses values of inputs before anything is run.
pub(crate) fn check(instance: &Instance, course: &Course) -> Result<(), Ended> {
    for input in course.inputs {
        let ports = instance.model().ports;
        if input.samples.iter().all(|value| ports.takes(input.column, *value)) {
            continue;
        }
        for (sample, value) in input.samples.iter().enumerate() {
            let checked = instance.check_value(Phase::Stepping, input.column, *value);
            let time = course.times.at(sample);
            checked.map_err(|reason| Ended::At { sample, time, reason: Box::new(reason) })?;
        }
    }
    Ok(())
}

/// Gives the inputs that move the slopes that lead them to the next sample.
fn incline(instance: &mut Instance, inputs: &[Input], sample: usize, step: f64) -> Result<(), Refused> {
    for input in inputs.iter().filter(|input| input.samples.len() > 1) {
        let change = input.at(sample + 1) - input.at(sample);
        if change != 0.0 && instance.model().ports.is_real_input(input.column) {
            instance.set_slope(input.column, change / step)?;
        }
    }
    Ok(())
}
