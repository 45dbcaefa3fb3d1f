//! Cycles: the strokes to and fro, laid on top of each other.

use super::Record;
use crate::sheet::text;

/// A cycle: mean of all of them, over equal parts of the period.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cycle {
    /// Number of cycles.
    pub count: usize,
    /// Mean period, s.
    pub period: f64,
    /// Part of the period, from 0 to 1.
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
        text(&[
            ("phase", &self.phase),
            ("displacement [m]", &self.displacement),
            ("velocity [m/s]", &self.velocity),
            ("friction_force [N]", &self.friction_force),
            ("standard_deviation [N]", &self.deviation),
        ])
    }
}

/// Places of a cycle (chosen).
const PLACES: usize = 400;

/// Part of the largest speed that the slider must exceed between two turns: slower motion is noise (chosen).
pub(super) const TURN: f64 = 0.05;

/// Standard deviation of the displacement among cycles, as a part of the mean stroke, from which they are not the same
/// motion (chosen). The mean of strokes of different length is a friction that there never was.
const UNLIKE: f64 = 0.05;

/// Averages the whole cycles of a record; None if there are fewer than two, if they are different motions, or if
/// the samples are averages already, which mix both directions at the turns.
pub fn average(record: &Record) -> Option<Cycle> {
    let starts = starts(record);
    let periods: Vec<[f64; 2]> = starts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let count = periods.len();
    if count < 2 || record.alike.is_some() {
        return None;
    }
    let mean = |values: &[f64], phase: f64| {
        let at = periods.iter().map(|[from, to]| interpolate(&record.time, values, from + phase * (to - from)));
        let values: Vec<f64> = at.collect();
        let mean = values.iter().sum::<f64>() / count as f64;
        let spread = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1) as f64;
        (mean, spread.sqrt())
    };
    let mut cycle = Cycle { count, period: (starts[count] - starts[0]) / count as f64, ..Cycle::default() };
    let mut apart = 0.0;
    for place in 0..PLACES {
        let phase = place as f64 / (PLACES - 1) as f64;
        let (force, deviation) = mean(&record.friction_force, phase);
        cycle.phase.push(phase);
        let (displacement, unlike) = mean(&record.displacement, phase);
        apart += unlike * unlike / PLACES as f64;
        cycle.displacement.push(displacement);
        cycle.velocity.push(mean(&record.velocity, phase).0);
        cycle.friction_force.push(force);
        cycle.deviation.push(deviation);
    }
    let ends = |[low, high]: [f64; 2], x: &f64| [low.min(*x), high.max(*x)];
    let [low, high] = cycle.displacement.iter().fold([f64::INFINITY, f64::NEG_INFINITY], ends);
    (f64::sqrt(apart) <= UNLIKE * (high - low)).then_some(cycle)
}

/// Times at which the slider begins to move forwards.
pub(super) fn starts(record: &Record) -> Vec<f64> {
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
