//! Slow strokes of a damper test: friction over time.

use super::{Damper, DynoError, ForceSign, Options, Test, centre_and_stroke, samples};
use stribeck::numerics::interpolation::Curve;
use stribeck_measured::reversals;

/// A part of a test that never leaves low speed and turns at least twice.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Time, s.
    pub time: Vec<f64>,
    /// Velocity, m/s, positive in extension.
    pub velocity: Vec<f64>,
    /// Resistance without damper table, gas force and its gradient, N.
    pub friction_force: Vec<f64>,
}

/// Least number of turns and of samples of a part (chosen).
const TURNS: usize = 2;
const SAMPLES: usize = 20;

/// Fraction of its largest speed that a part must exceed between two reversals: slower motion is noise (chosen).
const TURN: f64 = 0.1;

/// The slow strokes of the test in which a damper was found.
///
/// # Errors
/// A test without times or slow strokes.
pub fn slow_strokes(test: &Test, options: &Options, damper: &Damper) -> Result<Vec<Stroke>, DynoError> {
    let time = test.time.as_ref().ok_or(DynoError::NoTime)?;
    if let Some(at) = (1..time.len()).find(|at| time[*at] <= time[at - 1]) {
        return Err(DynoError::Time { row: at + 1, now: time[at], before: time[at - 1] });
    }
    let signs = signs(options, damper.force_sign);
    let centre = centre_and_stroke(&samples(test, options, damper.force_sign)).0;
    let friction = |at: usize| {
        let velocity = signs[0] * test.velocity[at];
        let displacement = test.displacement.as_ref().map_or(0.0, |all| signs[0] * all[at]);
        let gradient = damper.gradient.map_or(0.0, |gradient| gradient.value * (displacement - centre));
        let gas = damper.gas_force.map_or(0.0, |gas| gas.value);
        signs[1] * test.force[at] - Curve::from(&damper.table[..]).linear(velocity) - gradient + gas
    };
    let mut strokes = Vec::new();
    for (from, to) in slow(&test.velocity, options.low_speed) {
        let velocity: Vec<f64> = test.velocity[from..to].iter().map(|velocity| signs[0] * velocity).collect();
        if to - from >= SAMPLES && turns(&velocity) >= TURNS {
            let friction_force = (from..to).map(friction).collect();
            strokes.push(Stroke { time: time[from..to].to_vec(), velocity, friction_force });
        }
    }
    if strokes.is_empty() { Err(DynoError::NoSlowStrokes { low_speed: options.low_speed }) } else { Ok(strokes) }
}

/// Factors of motion and force from the signs of the file to those of this project.
pub(super) fn signs(options: &Options, force_sign: ForceSign) -> [f64; 2] {
    let motion = if options.compression_positive { -1.0 } else { 1.0 };
    [motion, if force_sign == ForceSign::Reaction { -motion } else { motion }]
}

/// Parts of a test up to a speed: first sample and the one after the last.
fn slow(velocity: &[f64], low_speed: f64) -> Vec<(usize, usize)> {
    let mut parts = Vec::new();
    let mut begin = None;
    for (at, velocity) in velocity.iter().enumerate() {
        match (velocity.abs() <= low_speed, begin) {
            (true, None) => begin = Some(at),
            (false, Some(from)) => {
                parts.push((from, at));
                begin = None;
            }
            _ => {}
        }
    }
    parts.extend(begin.map(|from| (from, velocity.len())));
    parts
}

/// Number of changes of direction.
fn turns(velocity: &[f64]) -> usize {
    reversals(velocity, TURN * velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs())))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts below 1 from the second to the fourth sample and from the sixth on.
    #[test]
    fn parts_are_below_the_speed() {
        assert_eq!(slow(&[2.0, 0.5, -1.0, 0.0, 3.0, -0.9, 1.0], 1.0), [(1, 4), (5, 7)]);
        assert_eq!(slow(&[2.0, -2.0], 1.0), []);
    }

    #[test]
    fn turns_are_counted_above_the_noise() {
        assert_eq!(turns(&[1.0, 0.05, -0.05, 0.05, -1.0, -0.5, 0.3]), 2);
        assert_eq!(turns(&[0.0; 5]), 0);
    }
}
