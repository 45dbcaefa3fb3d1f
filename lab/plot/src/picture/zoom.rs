//! The time range of a zoom.

use stribeck_draw::axis::tick_step;
use stribeck_draw::text::digits;
use stribeck_solve::run::Outcome;

/// Part of the longest run that a zoom shows before and after what it is about (chosen).
const HALF: f64 = 0.015;
/// Part of the longest run within which the other laws' breakaways are shown too (chosen).
const NEAR: f64 = 0.05;
/// The first change of force that has this part of the largest one counts as the largest: later ones of a cycle differ
/// from it by rounding.
const AS_LARGE: f64 = 0.9;

/// A range of time and what it is about.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    pub from: f64,
    pub to: f64,
    pub about: &'static str,
}

impl Range {
    /// A range that was asked for.
    pub fn given([from, to]: [f64; 2]) -> Range {
        Range { from, to, about: "" }
    }

    /// The range about the first breakaways of the laws; if none has one, about their largest changes of force.
    pub fn find(outcomes: &[(String, Outcome)], force: &str, velocity: Option<&str>) -> Option<Range> {
        let until = outcomes.iter().filter_map(|(_, outcome)| outcome.time.last()).copied().fold(0.0, f64::max);
        let outcomes = || outcomes.iter().map(|(_, outcome)| outcome);
        let mut times: Vec<f64> = outcomes().filter_map(|outcome| first_breakaway(outcome, velocity?)).collect();
        let mut about = "at the first breakaway";
        if times.is_empty() {
            times = outcomes().filter_map(|outcome| largest_change(outcome, force)).collect();
            about = "at its largest change";
        }
        times.sort_by(f64::total_cmp);
        let middle = *times.get(times.len() / 2)?;
        let near = times.iter().filter(|time| (*time - middle).abs() <= NEAR * until);
        let (first, last) = near.fold((middle, middle), |(first, last), time| (first.min(*time), last.max(*time)));
        // Ends that are easy to write down.
        let step = tick_step((last - first + 2.0 * HALF * until) / 20.0);
        let from = (((first - HALF * until) / step).floor() * step).max(0.0);
        let to = (((last + HALF * until) / step).ceil() * step).min(until);
        Some(Range { from, to, about })
    }

    /// The range in words.
    pub fn words(&self) -> String {
        let Range { from, to, about } = self;
        // As many digits as tell the ends apart, and three more.
        let size = from.abs().max(to.abs());
        let shown = 3 + (size / (to - from)).log10().ceil().clamp(0.0, 12.0) as usize;
        let space = if about.is_empty() { "" } else { ", " };
        format!("{about}{space}{} s to {} s", digits(*from, shown), digits(*to, shown))
    }
}

/// The first event after which a body moves faster than before: the capture of a sliding body is none.
fn first_breakaway(outcome: &Outcome, velocity: &str) -> Option<f64> {
    let velocity = outcome.values(velocity)?;
    let is_faster = |time: &f64| {
        let after = outcome.time.partition_point(|at| at <= time);
        let [before, after] = [after.checked_sub(2), Some(after + 1)];
        let [before, after] = [before, after].map(|row| row.and_then(|row| velocity.get(row)));
        matches!((before, after), (Some(before), Some(after)) if after.abs() > before.abs())
    };
    outcome.events.iter().map(|event| event.time).filter(|time| *time > 0.0).find(is_faster)
}

fn largest_change(outcome: &Outcome, force: &str) -> Option<f64> {
    let changes = outcome.values(force)?.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let changes: Vec<f64> = changes.collect();
    let largest = changes.iter().copied().fold(0.0, f64::max);
    let row = changes.iter().position(|change| largest > 0.0 && *change >= AS_LARGE * largest)?;
    Some(0.5 * (outcome.time[row] + outcome.time[row + 1]))
}
