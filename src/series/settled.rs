//! Results at held inputs, once they have settled.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::instance::{Instance, Phase, Refused};
use crate::model::{Fault, Kind, Role};

use super::Ended;

/// First step in s, factor of each step to the one before, and longest time in s (chosen).
const FIRST_STEP: f64 = 1e-4;
const GROWTH: f64 = 1.5;
const LONGEST: f64 = 1e12;

/// Least time in s and least way in m (chosen): beyond the dwell, the lag and the pre-sliding of all laws with usual
/// parameters.
const LEAST_TIME: f64 = 1.0;
const LEAST_WAY: f64 = 1e-2;

/// Change, as a part of the largest result, that counts as none (chosen).
const CHANGE: f64 = 1e-9;

/// Results at held inputs in the end: in closed form where the law has one. Otherwise the inputs are held from the present
/// state until the results no longer change while the time grows tenfold; refused if they keep fluctuating.
pub fn settle(
    instance: &mut Instance,
    inputs: &[(usize, f64)],
    results: &[usize],
    values: &mut [f64],
    cancel: &AtomicBool,
) -> Result<(), Ended> {
    instance.set_all(Phase::Stepping, inputs.iter().copied()).map_err(Ended::setup)?;
    // States do not always rest: energy grows on.
    let are_outputs = results.iter().all(|column| instance.model().table.role(*column) == Role::Output);
    let not_finite = |fault| Ended::setup(Refused::NotFinite(fault));
    if are_outputs && instance.slide_steadily().map_err(not_finite)? {
        for (column, value) in results.iter().zip(values) {
            *value = instance.get_column(*column).map_err(Ended::setup)?;
        }
        return Ok(());
    }
    by_steps(instance, inputs, results, values, cancel)
}

/// As [`settle`], step by step.
pub(super) fn by_steps(
    instance: &mut Instance,
    inputs: &[(usize, f64)],
    results: &[usize],
    values: &mut [f64],
    cancel: &AtomicBool,
) -> Result<(), Ended> {
    let speed = speed(instance, inputs);
    let way = if speed > 0.0 { LEAST_WAY / speed } else { 0.0 };
    // Nothing changes within a dead time: the last tenfold of the time must be longer.
    let lag = instance.model().past(instance.row()).map_or(0.0, |past| 10.0 * past.lag);
    let least = LEAST_TIME.max(way).max(lag);
    let (mut time, mut step) = (0.0, FIRST_STEP);
    let mut history: Vec<(f64, Vec<f64>)> = Vec::new();
    while time < f64::max(LONGEST, 10.0 * least) {
        if cancel.load(Ordering::Relaxed) {
            return Err(Ended::Cancelled);
        }
        instance.step(step).map_err(|fault| Ended::setup(Refused::NotFinite(fault)))?;
        time += step;
        step *= GROWTH;
        let read = results.iter().map(|column| instance.get_column(*column)).collect::<Result<Vec<f64>, _>>();
        history.push((time, read.map_err(Ended::setup)?));
        history.retain(|(earlier, _)| *earlier >= 0.1 * time);
        if time >= least && is_settled(&history) {
            let last = history.last().map_or(&[][..], |(_, results)| results);
            values.copy_from_slice(last);
            return Ok(());
        }
    }
    let shown = Shown { instance, inputs };
    Err(Ended::Unsettled(Fault::new(format_args!("the results do not settle at {shown}: they keep fluctuating"))))
}

/// Magnitude of the velocities among inputs, in m/s.
fn speed(instance: &Instance, inputs: &[(usize, f64)]) -> f64 {
    let is_velocity = |column: usize| {
        let kind = instance.variable(column).map(|variable| variable.kind);
        matches!(kind, Some(Kind::Real(unit)) if unit.name == "m/s")
    };
    inputs.iter().filter(|(column, _)| is_velocity(*column)).map(|(_, value)| value * value).sum::<f64>().sqrt()
}

/// Inputs as a message names them.
struct Shown<'a> {
    instance: &'a Instance,
    inputs: &'a [(usize, f64)],
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (number, (column, value)) in self.inputs.iter().enumerate() {
            let between = if number == 0 { "" } else { ", " };
            if let Some(variable) = self.instance.variable(*column) {
                write!(f, "{between}{} = {value}", variable.path)?;
            }
        }
        Ok(())
    }
}

fn is_settled(history: &[(f64, Vec<f64>)]) -> bool {
    let Some((_, last)) = history.last() else { return false };
    let scale = last.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let is_same = |results: &Vec<f64>| results.iter().zip(last).all(|(a, b)| (a - b).abs() <= CHANGE * scale);
    history.iter().all(|(_, results)| is_same(results))
}
