//! Samples that are left out of a tyre test, and those that look as if they should be.
//!
//! Tyre machines begin with a conditioning of the tyre and repeat some sweeps with a cold one; sweeps of the load without
//! slip are for the vertical stiffness. What looks like warm-up is named, and fitted unless it is left out.

use stribeck_sheet::Sheet;
use stribeck_solve::job::Entry;

use super::super::uncertainty::digits;
use super::columns::{Sample, TyreTest, TyreTestError, times};
use stribeck_measured::{OF_MEDIAN, extremes, median};

/// Leaves out the rows within a time after the first one, in s, and those in which a column is outside of its range, in
/// the unit of the file; a note on their number.
pub(super) fn leave_out(
    sheet: &mut Sheet,
    skip: Option<f64>,
    only: &[Entry<[f64; 2]>],
) -> Result<Option<String>, TyreTestError> {
    let count = sheet.len();
    let mut kept = vec![true; count];
    if let Some(skip) = skip {
        let times = times(sheet)?;
        let first = times.first().copied().unwrap_or(0.0);
        kept.iter_mut().zip(times).for_each(|(kept, time)| *kept = time - first >= skip);
    }
    for Entry(name, [low, high]) in only {
        let values = sheet.numbers(name)?.ok_or_else(|| sheet.missing(name))?;
        kept.iter_mut().zip(values).for_each(|(kept, value)| *kept &= (*low..=*high).contains(&value));
    }
    let left = kept.iter().filter(|kept| **kept).count();
    sheet.keep(&kept);
    Ok((left < count).then(|| format!("{} of {count} samples are left out, as was asked for", count - left)))
}

/// Slips that count as 0 in a sweep of the load, its least number of samples, and least change of the load as a part of
/// the largest (chosen).
const NO_SLIP: f64 = 0.002;
const SWEEP: usize = 20;
const CHANGE: f64 = 0.2;

/// Takes sweeps of the load without slip out of the samples of a file; a note on each.
pub(super) fn without_load_sweeps(test: TyreTest) -> TyreTest {
    let TyreTest { samples, mut notes, .. } = test;
    let is_still = |one: &Sample| one.side_slip.abs() <= NO_SLIP && one.longitudinal_slip.abs() <= NO_SLIP;
    let mut kept = Vec::with_capacity(samples.len());
    for run in samples.chunk_by(|a, b| is_still(a) == is_still(b)) {
        let [low, high] = extremes(run.iter().map(|one| one.load));
        if !is_still(&run[0]) || run.len() < SWEEP || high - low < CHANGE * high {
            kept.extend(run);
            continue;
        }
        let [low, high] = [low, high].map(digits);
        notes.push(format!("{}: a sweep of the load from {low} to {high} N without slip, not fitted", place(run)));
    }
    TyreTest { samples: kept, notes, ..TyreTest::default() }
}

/// Lines and times of samples that follow each other.
fn place(run: &[Sample]) -> String {
    let [first, last] = [run[0], run[run.len() - 1]];
    let times = first.time.zip(last.time).map(|(from, to)| format!(" ({} to {} s)", digits(from), digits(to)));
    format!("lines {} to {}{}", first.line, last.line, times.unwrap_or_default())
}

/// Parts of a file of which each has a mean, their least length in samples, and the distance from the middle one, in
/// robust standard deviations, from which a mean is far from the rest (chosen).
const PARTS: usize = 40;
const SHORTEST: usize = 10;
const FAR: f64 = 4.0;

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Number of samples at the start and at the end whose values are far from the rest, and further than a least distance
/// that follows from the middle one.
fn far_ends(values: &[f64], least: impl Fn(f64) -> f64) -> [usize; 2] {
    if values.is_empty() {
        return [0, 0];
    }
    let length = values.len().div_ceil(PARTS).max(SHORTEST);
    let means: Vec<f64> = values.chunks(length).map(mean).collect();
    let middle = median(&mut means.clone());
    let spread = OF_MEDIAN * median(&mut means.iter().map(|one| (one - middle).abs()).collect::<Vec<f64>>());
    let is_far = |one: &f64| (one - middle).abs() > (FAR * spread).max(least(middle));
    let first = length * means.iter().take_while(|one| is_far(one)).count();
    let begin = length * (means.len() - means.iter().rev().take_while(|one| is_far(one)).count());
    // A part may be far by some of its samples.
    let end = values[..first.min(values.len())].iter().rposition(is_far).map_or(0, |at| at + 1);
    let rest = values.iter().skip(begin).position(is_far).map_or(values.len(), |at| begin + at);
    [end, values.len() - rest]
}

/// Samples at one end of a list, and the others.
fn split(count: usize, at_end: bool, all: usize) -> [std::ops::Range<usize>; 2] {
    if at_end { [all - count..all, 0..all - count] } else { [0..count, count..all] }
}

/// Advice on samples that look like warm-up.
const REMEDY: &str = "warm-up? They are fitted; --skip and --only leave samples out";

/// Difference of temperatures, in K, that is large (chosen).
const COLD: f64 = 5.0;

/// Temperature of 0 degC, K.
const FREEZING: f64 = 273.15;

/// Notes on samples at the start and the end of a file in which the tyre is much colder, or warmer, than in the rest.
pub(super) fn by_temperature(samples: &[Sample]) -> Vec<String> {
    let Some(all) = samples.iter().map(|one| one.temperature).collect::<Option<Vec<f64>>>() else { return Vec::new() };
    let note = |(count, at_end): (usize, bool)| {
        let [here, rest] = split(count, at_end, all.len());
        let [low, high] = extremes(all[here.clone()].iter().map(|one| one - FREEZING));
        let usual = median(&mut all[rest].to_vec()) - FREEZING;
        let place = place(&samples[here]);
        format!("{place}: the tyre has {low:.0} to {high:.0} degC, {usual:.0} degC in the rest: {REMEDY}")
    };
    let ends = far_ends(&all, |_| COLD);
    ends.into_iter().zip([false, true]).filter(|(count, _)| *count > 0).map(note).collect()
}

/// Residuals that are so much larger are far from the rest (chosen).
const LARGER: f64 = 2.0;

/// Notes on samples at the start and the end of a file whose residuals are much larger than those of the rest.
pub(super) fn by_residual(samples: &[Sample], residuals: &[f64], channel: &str) -> Vec<String> {
    let sizes: Vec<f64> = residuals.iter().map(|one| one.abs()).collect();
    let note = |(count, at_end): (usize, bool)| {
        let [here, rest] = split(count, at_end, sizes.len());
        let times = mean(&sizes[here.clone()]) / mean(&sizes[rest]);
        let place = place(&samples[here]);
        format!("{place}: residuals of {channel} are {times:.1} times those of the rest: {REMEDY}")
    };
    let ends = far_ends(&sizes, |middle| LARGER * middle);
    ends.into_iter().zip([false, true]).filter(|(count, _)| *count > 0).map(note).collect()
}
