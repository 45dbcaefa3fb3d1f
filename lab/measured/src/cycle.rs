//! The mean cycle of a periodic record.

use crate::movement::Movement;
use crate::record::Record;
use crate::statistics::extremes;
use stribeck_sheet::text;

/// Mean of the cycles of a record, over equal parts of the period.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cycle {
    /// Whether the body slides or turns.
    pub movement: Movement,
    /// Number of cycles.
    pub count: usize,
    /// Mean period, s.
    pub period: f64,
    /// Fraction of the period, from 0 to 1.
    pub phase: Vec<f64>,
    /// Displacement, m.
    pub displacement: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Friction force, N.
    pub friction_force: Vec<f64>,
    /// Standard deviation of the friction force among the cycles, N.
    pub deviation: Vec<f64>,
}

impl Cycle {
    /// The cycle as a table, with units in the heading.
    pub fn csv(&self) -> csv::Result<String> {
        let heading = |name, unit| self.movement.heading(name, unit);
        text(&[
            ("phase", &self.phase),
            (&heading("displacement", "m"), &self.displacement),
            (&heading("velocity", "m/s"), &self.velocity),
            (&heading("friction_force", "N"), &self.friction_force),
            (&heading("standard_deviation", "N"), &self.deviation),
        ])
    }
}

/// Points of a cycle (chosen).
const POINTS: usize = 400;

/// Fraction of the largest speed that the slider must exceed between two reversals: slower motion is noise (chosen).
pub(crate) const TURN: f64 = 0.05;

/// Standard deviation of the displacement among cycles, relative to the mean stroke, above which they are different
/// motions (chosen): the mean of strokes of different length has a friction that never occurred.
const DIFFERENT: f64 = 0.05;

/// Averages the complete cycles of a record; None with fewer than two, if they are different motions, or if the samples
/// are averages of a matched filter, which mix both directions at the reversals.
pub fn average(record: &Record) -> Option<Cycle> {
    let starts = starts(record);
    let count = starts.len().saturating_sub(1);
    if count < 2 || record.matched_filter.is_some() {
        return None;
    }
    let phase: Vec<f64> = (0..POINTS).map(|point| point as f64 / (POINTS - 1) as f64).collect();
    let statistics = |values: &[f64]| -> (Vec<f64>, Vec<f64>) {
        phase.iter().map(|phase| statistics(&record.time, values, &starts, *phase)).unzip()
    };
    let (displacement, spread) = statistics(&record.displacement);
    let variance = spread.iter().map(|spread| spread * spread / POINTS as f64).sum::<f64>();
    let [low, high] = extremes(displacement.iter().copied());
    let (friction_force, deviation) = statistics(&record.friction_force);
    let velocity = statistics(&record.velocity).0;
    let period = (starts[count] - starts[0]) / count as f64;
    let cycle =
        Cycle { movement: record.movement, count, period, phase, displacement, velocity, friction_force, deviation };
    (f64::sqrt(variance) <= DIFFERENT * (high - low)).then_some(cycle)
}

/// Mean and standard deviation of a quantity at a phase, over the cycles between some times.
fn statistics(time: &[f64], values: &[f64], starts: &[f64], phase: f64) -> (f64, f64) {
    let cycles = starts.windows(2).map(|pair| interpolate(time, values, pair[0] + phase * (pair[1] - pair[0])));
    let samples: Vec<f64> = cycles.collect();
    let count = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / count;
    let squares = samples.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    (mean, (squares / (count - 1.0)).sqrt())
}

/// Times at which the slider begins to move forwards.
pub(crate) fn starts(record: &Record) -> Vec<f64> {
    let threshold = TURN * record.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let (mut starts, mut crossing, mut was_back) = (Vec::new(), None, false);
    for (at, pair) in record.velocity.windows(2).enumerate() {
        let [before, now] = [pair[0], pair[1]];
        if before <= 0.0 && now > 0.0 {
            let share = before / (before - now);
            crossing = Some(record.time[at] + share * (record.time[at + 1] - record.time[at]));
        }
        if now < -threshold {
            was_back = true;
        }
        if now > threshold && was_back {
            starts.extend(crossing);
            was_back = false;
        }
    }
    starts
}

/// Value at a time, on a straight line between two samples.
pub fn interpolate(time: &[f64], values: &[f64], at: f64) -> f64 {
    let right = time.partition_point(|t| *t < at).clamp(1, time.len() - 1);
    let share = ((at - time[right - 1]) / (time[right] - time[right - 1])).clamp(0.0, 1.0);
    (1.0 - share) * values[right - 1] + share * values[right]
}
