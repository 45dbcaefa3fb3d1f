//! Data quality of a record, before any fit.

use crate::cycle::TURN;
use crate::movement::Movement;
use crate::record::{Gap, Quality, Record, Setup};
use crate::statistics::{extremes, median, reversals};

/// Distance of two samples, in median intervals, above which there is a gap between them (chosen).
pub(crate) const GAP: f64 = 3.0;

/// Fraction of the samples at a limit of the range above which it looks like saturation (chosen).
const SATURATED: f64 = 0.01;

/// Samples per reversal below which the approach to rest is not resolved (chosen).
const FEW: f64 = 10.0;

/// Range of the normal force, relative to its mean, below which its influence cannot be identified (chosen).
const ONE_LOAD: f64 = 0.1;

/// Assesses a record.
pub(crate) fn quality(record: &Record, setup: &Setup) -> Quality {
    let mut steps: Vec<f64> = record.time.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let interval = median(&mut steps);
    let fastest = record.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let slow = record.velocity.iter().filter(|v| v.abs() < 0.1 * fastest).count() as f64;
    let reversals = reversals(&record.velocity, TURN * fastest);
    let mut quality = Quality {
        samples: record.time.len(),
        duration: record.time[record.time.len() - 1] - record.time[0],
        interval,
        gaps: gaps(&record.time, interval),
        saturated: saturated(&record.force),
        noise: noise(&record.force),
        resolution: resolution(&record.displacement),
        fastest,
        slow: slow / (reversals.max(1)) as f64,
        reversals,
        loads: extremes(record.normal_force.iter().copied()),
        findings: Vec::new(),
    };
    // The normal force of an axis is only the unit of its friction.
    let one_load = if setup.is_axis { None } else { one_load(quality.loads, record.movement) };
    let findings = [gap(&quality.gaps), saturation(quality.saturated), few_reversals(&quality), one_load];
    quality.findings = findings.into_iter().flatten().collect();
    quality
}

fn gaps(time: &[f64], interval: f64) -> Vec<Gap> {
    let pairs = time.windows(2).filter(|pair| pair[1] - pair[0] > GAP * interval);
    pairs.map(|pair| Gap { time: pair[0], length: pair[1] - pair[0] }).collect()
}

fn gap(gaps: &[Gap]) -> Option<String> {
    let Gap { time, length } = gaps.first()?;
    let more = if gaps.len() > 1 { format!(" and {} more", gaps.len() - 1) } else { String::new() };
    Some(format!("a gap of {length:.3} s at {time:.3} s{more}: the law is driven across it on a straight line"))
}

fn saturation(saturated: f64) -> Option<String> {
    let percent = 100.0 * saturated;
    (saturated > SATURATED)
        .then(|| format!("{percent:.1} % of the forces are at an end of the range: is the load cell saturated?"))
}

fn few_reversals(quality: &Quality) -> Option<String> {
    if quality.reversals == 0 {
        Some(
            "no reversal: neither pre-sliding (stiffness and damping of bristles) nor an offset can be identified; drag \
             the slider to and fro"
                .to_owned(),
        )
    } else if quality.slow < FEW {
        Some(format!(
            "{:.1} samples per reversal below a tenth of the largest speed: they hardly determine the static level and \
             the Stribeck velocity; sample faster or turn more slowly",
            quality.slow
        ))
    } else {
        None
    }
}

fn one_load([low, high]: [f64; 2], movement: Movement) -> Option<String> {
    let unit = movement.unit("N");
    (high - low < ONE_LOAD * 0.5 * (high + low)).then(|| {
        format!("one normal force ({high} {unit}): this record alone does not show how friction depends on it")
    })
}

/// Fraction of the samples with exactly the lowest or highest value, if it occurs more than once in a row.
fn saturated(force: &[f64]) -> f64 {
    let [low, high] = extremes(force.iter().copied());
    let is_end = |value: &f64| *value == low || *value == high;
    let count = force.windows(2).filter(|pair| is_end(&pair[0]) && pair[0] == pair[1]).count();
    if low < high { count as f64 / force.len() as f64 } else { 0.0 }
}

/// Standard deviation of the noise of a signal, from third differences, whose variance is 20 times that of white noise. The
/// median of their magnitudes, 0.6745 standard deviations, is robust against the reversals.
pub fn noise(force: &[f64]) -> f64 {
    let mut third: Vec<f64> = force.windows(4).map(|f| (f[3] - 3.0 * f[2] + 3.0 * f[1] - f[0]).abs()).collect();
    median(&mut third) / (0.6745 * f64::sqrt(20.0))
}

/// Least change from one sample to the next; 0 if there is none.
pub(crate) fn resolution(values: &[f64]) -> f64 {
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|step| *step > 0.0);
    let least = steps.fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// Number of different steps from which values look quantised (chosen): a computed trapezoid has fewer.
const SIZES: usize = 5;

/// Largest distance of a change from a multiple of the least one, relative to that (chosen).
const OFF: f64 = 0.01;

/// Standard deviation of the quantisation error; 0 if the values do not look quantised: if changes are not multiples of
/// the least one, or if there are neither single steps between equal samples nor steps of many sizes.
pub(crate) fn rounding(values: &[f64]) -> f64 {
    let resolution = resolution(values);
    let is_alone = |of: &[f64]| of[0] == of[1] && of[1] != of[2] && of[2] == of[3];
    let mut sizes = Vec::with_capacity(SIZES);
    for pair in values.windows(2) {
        let change = (pair[1] - pair[0]).abs() / resolution;
        let size = change.round();
        if (change - size).abs() > OFF {
            return 0.0;
        }
        if size > 0.0 && sizes.len() < SIZES && !sizes.contains(&size) {
            sizes.push(size);
        }
    }
    let is_rounded = sizes.len() == SIZES || values.windows(4).any(is_alone);
    if is_rounded { resolution / f64::sqrt(12.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Rounding errors of a sine are even between -1/2 and 1/2; a trapezoid in whole steps has none.
    #[test]
    fn rounded_values_are_distinguished_from_computed_ones() {
        let sine = |step: f64| -> Vec<f64> {
            (0..2000).map(|k| ((0.01 * f64::from(k)).sin() / step).round() * step).collect()
        };
        for step in [1e-4, 0.01, 0.3] {
            let rounded = sine(step);
            let errors = rounded.iter().enumerate().map(|(k, value)| (value - (0.01 * k as f64).sin()).powi(2));
            let deviation = (errors.sum::<f64>() / 2000.0).sqrt();
            assert_relative_eq!(rounding(&rounded), deviation, max_relative = 0.1);
        }
        let trapezoid = |k: usize| [k.min(100), 100, 400 - k.clamp(300, 400)].into_iter().min().unwrap() as f64 * 1e-3;
        let values: Vec<f64> = (0..500).map(trapezoid).collect();
        assert!(resolution(&values) > 9e-4);
        assert_eq!(rounding(&values), 0.0);
        assert_eq!(rounding(&[1.0; 9]), 0.0);
    }
}
