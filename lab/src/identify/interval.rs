//! Intervals that do not rely on straight lines: profile likelihood, and repetition with blocks of residuals.
//!
//! # Source
//! Profiles: D. J. Venzon, S. H. Moolgavkar, "A method for computing profile-likelihood-based confidence intervals",
//! Applied Statistics 37 (1988), doi:10.2307/2347496. Blocks: H. R. Kuensch, "The jackknife and the bootstrap for
//! general stationary observations", Annals of Statistics 17 (1989), doi:10.1214/aos/1176347265.

use std::sync::atomic::Ordering;

use super::problem::Problem;
use super::search::{Found, Watch, polish, polish_until};
use super::trust::{Residuals, Trust, Verdict, WIDTH};

/// Rise of the sum of squares, in variances, at the ends of an interval that holds in 95 % of cases.
const RISE: f64 = WIDTH * WIDTH;

/// Trials on the way to an end (chosen).
const TRIALS: usize = 12;

/// Interval of an unknown: as far as the sum of squares, at the best values of the others, rises by less than noise can
/// make it, and farther by the error of the velocity. An end at an end of the range is open.
pub(super) fn profile(problem: &Problem, best: &Found, seen: &Residuals, trust: &Trust, number: usize) -> [f64; 2] {
    let [value, slope] = problem.unknowns[number].value(best.places[number]);
    let step = (trust.by_noise(number) / slope.abs().max(f64::MIN_POSITIVE)).clamp(1e-9, 0.5);
    let variance = seen.rise();
    let gain = gain(best, seen);
    let end = |direction: f64| {
        let rise = |distance: f64| {
            let place = best.places[number] + direction * distance;
            let from = along(problem, best, trust, number, place);
            2.0 * (held(problem, &from, number, place, gain).cost - best.cost) / variance
        };
        let most = if direction > 0.0 { 1.0 - best.places[number] } else { best.places[number] };
        let distance = crossing(rise, WIDTH * step, most);
        problem.unknowns[number].value(best.places[number] + direction * distance)[0]
    };
    let blur = WIDTH * trust.blurs[number];
    let [low, high] = [end(-1.0), end(1.0)].map(|end| ((end - value).powi(2) + blur * blur).sqrt());
    [value - low, value + high]
}

/// The best place, with the others where straight lines expect them for an unknown at a place.
fn along(problem: &Problem, best: &Found, trust: &Trust, number: usize, place: f64) -> Found {
    let mut moved = best.clone();
    moved.places[number] = place.clamp(0.0, 1.0);
    let change = problem.values(&moved.places)[number] - problem.values(&best.places)[number];
    for other in (0..moved.places.len()).filter(|other| *other != number) {
        let [_, slope] = problem.unknowns[other].value(best.places[other]);
        let expected = change * trust.follows(other, number) / slope.abs().max(f64::MIN_POSITIVE);
        moved.places[other] = (moved.places[other] + expected).clamp(0.0, 1.0);
    }
    moved
}

/// The distance, at most `most`, at which the rise reaches its limit. The rise is about a parabola.
fn crossing(rise: impl Fn(f64) -> f64, first: f64, most: f64) -> f64 {
    let (mut inside, mut outside) = (0.0, None);
    let mut distance = first.min(most);
    for _ in 0..TRIALS {
        let found = rise(distance);
        if (found / RISE - 1.0).abs() < 0.02 {
            return distance;
        }
        if found < RISE {
            inside = distance;
            if distance >= most {
                return most;
            }
        } else {
            outside = Some(distance);
        }
        let guess = if found > 0.0 { distance * (RISE / found).sqrt() } else { 2.0 * distance };
        distance = match outside {
            Some(outside) if guess <= inside || guess >= outside => 0.5 * (inside + outside),
            Some(_) => guess,
            None => guess.clamp(1.2 * distance, 4.0 * distance).min(most),
        };
    }
    distance
}

/// Places, as parts of its range, at which an unknown that the data do not determine is held.
const ELSEWHERE: [f64; 4] = [0.1, 0.37, 0.63, 0.9];

/// Movement, in standard deviations and as a part of a large change, from which an unknown depends on another (chosen).
const MOVED: [f64; 2] = [3.0, 0.1];

/// Unknowns that move when one that the data do not determine is held elsewhere, where the force is explained as well:
/// pairs of the one that moves and the one it depends on.
pub(super) fn dependent(problem: &Problem, best: &Found, seen: &Residuals, trust: &Trust) -> Vec<(usize, usize)> {
    let values = problem.values(&best.places);
    let variance = seen.rise();
    let gain = gain(best, seen);
    let mut found = Vec::new();
    let free = (0..values.len()).filter(|number| matches!(trust.verdicts[*number], Verdict::Undetermined(_)));
    for number in free {
        for place in ELSEWHERE {
            let end = held(problem, best, number, place, gain);
            if 2.0 * (end.cost - best.cost) / variance > RISE {
                continue;
            }
            for (other, (value, moved)) in values.iter().zip(problem.values(&end.places)).enumerate() {
                let change = (moved - value).abs();
                let is_far = change > MOVED[0] * trust.deviations[other]
                    && change > MOVED[1] * problem.unknowns[other].large(*value);
                if other != number && is_far && found.iter().all(|(known, _)| *known != other) {
                    found.push((other, number));
                }
            }
        }
    }
    found
}

/// Part of the rise at the end of an interval that a step of least squares on the way there need not gain (chosen).
const UNSEEN: f64 = 1e-3;

/// The same as a part of the cost.
fn gain(best: &Found, seen: &Residuals) -> f64 {
    UNSEEN * RISE * seen.rise() / (2.0 * best.cost).max(f64::MIN_POSITIVE)
}

/// The best place with an unknown held at a part of its range, from a place on.
fn held(problem: &Problem, from: &Found, number: usize, place: f64, gain: f64) -> Found {
    let mut pinned = problem.clone();
    pinned.pin(number, place);
    let mut from = from.clone();
    from.places[number] = place.clamp(0.0, 1.0);
    from.cost = f64::INFINITY;
    polish_until(&pinned, &from, gain)
}

/// Places of the unknowns in fits to the explained forces with blocks of residuals from random places, as long as ten
/// correlation times.
pub(super) fn repetitions(
    problem: &Problem,
    best: &Found,
    seen: &Residuals,
    count: usize,
    seed: u64,
    watch: Watch,
) -> Vec<Vec<f64>> {
    let Some(residuals) = problem.residuals(&best.places) else { return Vec::new() };
    let measured = problem.measured();
    // A fit takes a part of the noise away.
    let freedom = residuals.len() as f64 / (residuals.len() - problem.unknowns.len().min(residuals.len() - 1)) as f64;
    let length = ((10.0 * seen.correlation).ceil() as usize).clamp(1, residuals.len());
    let mut random = fastrand::Rng::with_seed(seed);
    let mut found = Vec::with_capacity(count);
    for _ in 0..count {
        if watch.cancel.load(Ordering::Relaxed) {
            break;
        }
        let mut noise = Vec::with_capacity(residuals.len() + length);
        while noise.len() < residuals.len() {
            // A usize of 32 bits, as in a browser, would take other numbers.
            let from = random.u64(0..=(residuals.len() - length) as u64) as usize;
            noise.extend_from_slice(&residuals[from..from + length]);
        }
        let forces = measured.iter().zip(&residuals).zip(&noise);
        let forces = forces.map(|((measured, residual), noise)| measured + residual + freedom.sqrt() * noise);
        let again = Problem { instead: Some(forces.collect()), ..problem.clone() };
        let from = Found { cost: f64::INFINITY, ..best.clone() };
        found.push(polish(&again, &from).places);
        (watch.progress)(seen.rms, best.evaluations);
    }
    // Some of the repetitions do not make an interval.
    if watch.cancel.load(Ordering::Relaxed) { Vec::new() } else { found }
}

/// Interval that holds 95 % of values.
pub(super) fn quantiles(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| values[((share * values.len() as f64) as usize).min(values.len() - 1)];
    [at(0.025), at(0.975)]
}
