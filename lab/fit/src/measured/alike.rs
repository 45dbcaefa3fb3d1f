//! Force and motion smoothed alike, for bodies that a drive moves.
//!
//! # Equations
//! Displacement, velocity, acceleration and force at the same samples are averaged with the same weights around a time:
//!
//! ```text
//! y(t) = sum w_j y_j / sum w_j,   w_j = (1 - (2 (t_j - t) / L)^2)^4   for |t_j - t| < L / 2
//! ```
//!
//! so that F = M a + f_v v + f_c sgn(v) + b holds among the averages as it does among the samples, however fast the
//! motion is, wherever v keeps its sign within the window. A filter of the motion alone would damp what is fast in it and
//! not in the force. Velocity and acceleration of the samples are those of stencils, which damp nothing by themselves.
//! One average is kept every half window.
//!
//! The window is the one with which the regression of F on a, v, sgn(v), 1 and da/dt knows the first four coefficients
//! best: the sum of the logarithms of their errors is least. The coefficient of da/dt is the mass times the time by which
//! the motion is later than assumed. An error has two parts: the standard deviation, and what the noise of the motion in
//! a, v and da/dt shifts. With the share q_k of noise in what a term does not have in common with the others, and the
//! inverse C of the normal equations, that is
//!
//! ```text
//! |shift_i| <= sum_k q_k |C_ik / C_kk| |p_k|
//! ```
//!
//! where p_k is the coefficient of the term; that of da/dt is the mass times the doubt about the delay, or times the
//! delay that the reaction of a controller to noise feigns, whichever is larger. The share of noise is taken away from
//! what da/dt does not have in common with the others, so that noise does not look like a delay; from a share of
//! [`NOISY`], all of that is taken away, from a and v too, and the coefficient is not determined. The force of a
//! controller is held until the next sample, which averages it over an interval h; its samples are averaged likewise,
//! y_j + (y_j-1 - 2 y_j + y_j+1) / 24.
//!
//! # Source
//! Parallel filtering of force and regressors, and its decimation: M. Brunot, A. Janot, P. C. Young, F. Carrillo, "An
//! improved instrumental variable method for industrial robot model identification", Control Engineering Practice 74
//! (2018), doi:10.1016/j.conengprac.2018.02.010. Weights and choice of the window are chosen here.

use nalgebra::{SMatrix, SVector};
use stribeck::number::Real;

use super::clock::{Clocks, around};
use super::quality::{GAP, noise};
use super::record::{Alike, Record};
use super::stencil::NODES;

/// Samples of the motion by which that of a controller may be later than its force (chosen): half of one for a force
/// that is held until the next sample, one more if it takes that long to compute it.
const LATEST: [f64; 2] = [-0.5, 2.0];

/// Middle and half width of the same.
pub(super) fn middle(interval: f64) -> f64 {
    0.5 * (LATEST[0] + LATEST[1]) * interval
}

pub(super) fn doubt(interval: f64) -> f64 {
    0.5 * (LATEST[1] - LATEST[0]) * interval
}

/// Shortest window that is tried, s.
pub(super) fn shortest(interval: f64) -> f64 {
    WINDOWS[0] * interval
}

/// Samples in a window unless it is given (chosen).
const WINDOWS: [f64; 10] = [9.0, 11.0, 15.0, 21.0, 31.0, 41.0, 61.0, 91.0, 131.0, 191.0];

/// Terms of the regression: acceleration, velocity, its sign, 1 and jerk; the first four judge a window.
const TERMS: usize = 5;
const JUDGED: usize = 4;
const ACCELERATION: usize = 0;
const VELOCITY: usize = 1;
const JERK: usize = 4;

/// Part of the highest speed below which friction is more than Coulomb and viscous friction (chosen): the static level
/// and what is left of it, and pre-sliding.
pub const SLOW: f64 = 0.05;

/// Averages with which a regression is made at least (chosen).
const LEAST: usize = 4 * TERMS;

/// Errors of the velocity below which its sign is not known (chosen, as in [`crate::identify`]).
const UNKNOWN_SIGN: f64 = 3.0;

/// Share of noise in what a term has for itself from which that tells nothing (chosen). It was below 0.006 in records of
/// three frequencies, and from 0.10 to 0.33 in those of one, in which the reaction of a controller to rounding then looked
/// like 1 to 6 ms of delay.
const NOISY: f64 = 0.05;

/// Rounds in which the delay is found: each takes the motion from where the one before saw it.
const ROUNDS: usize = 4;

/// Motion at the samples of the force: displacement, velocity and acceleration without a filter.
pub(super) type Raw = Vec<[f64; 3]>;

/// Shift of mass or viscous friction by noise of the motion, as a part of them, that is warned of (chosen).
const SHIFTED: f64 = 3e-3;

/// Bandwidth in rad/s of a controller that passes noise of the motion on to the force (chosen, 16 Hz): the force then goes
/// with the noise, and the motion looks later by the share of noise in da/dt times this times the ratio of the variances
/// of the noise in a and da/dt.
const BANDWIDTH: f64 = 100.0;

/// A record with force and motion smoothed alike.
///
/// `record` is one with the motion smoothed, `raw` the motion at a delay; `window` is the length of the window, if it
/// is given. The delay is looked for by at most `doubt` around that of the record. None if no window leaves enough.
pub(super) fn alike(
    record: &Record,
    mass: f64,
    raw: &dyn Fn(f64) -> Raw,
    window: Option<f64>,
    doubt: f64,
    is_held: bool,
) -> Option<Record> {
    let about = record.clocks.delay;
    let force = if is_held { held(&record.force) } else { record.force.clone() };
    let mut moved = raw(about);
    let interval = record.quality.interval;
    let windows = window.map_or_else(|| WINDOWS.map(|samples| samples * interval).to_vec(), |one| vec![one]);
    let noise = noise_of_motion(record, &moved);
    let tried = windows.into_iter().filter_map(|window| {
        let averages = Averages::of(record, &force, &moved, window, doubt);
        Some((averages.are_few(record), averages.regression(record, noise, doubt)?.doubt(), window))
    });
    let (.., window) = tried.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)))?;
    let (range, mut delay) = (around(about, doubt), about);
    for _ in 0..if doubt > 0.0 { ROUNDS } else { 0 } {
        let averages = Averages::of(record, &force, &moved, window, doubt);
        delay = (delay + averages.regression(record, noise, doubt)?.late()).clamp(range[0], range[1]);
        moved = raw(delay);
    }
    let mut averages = Averages::of(record, &force, &moved, window, doubt);
    let regression = averages.regression(record, noise, doubt)?;
    averages.calibrate(&regression);
    let shifted: Vec<String> = [(ACCELERATION, "the mass"), (VELOCITY, "viscous friction")]
        .into_iter()
        .filter_map(|(term, name)| Some((name, regression.relative_shift(term)?)))
        .filter(|(_, shift)| *shift > SHIFTED)
        .map(|(name, shift)| format!("{name} by {:.1} %", 100.0 * shift))
        .collect();
    let mut found = averages.record(record, mass, Delayed { delay, range: (doubt > 0.0).then_some(range) }, window);
    if !shifted.is_empty() {
        found.quality.findings.push(format!(
            "noise of the motion may shift {}, more than the intervals say: measure the motion more finely, accelerate \
             more, or move with several frequencies",
            shifted.join(" and ")
        ));
    }
    Some(found)
}

/// A force that is held until the next sample, as it acts: see the equations.
fn held(force: &[f64]) -> Vec<f64> {
    let at = |at: usize| match force.get(at.wrapping_sub(1)..=at + 1) {
        Some([before, now, after]) => now + (before - 2.0 * now + after) / 24.0,
        _ => force[at],
    };
    (0..force.len()).map(at).collect()
}

/// Delay that was found, and the range in which it was looked for, s.
struct Delayed {
    delay: f64,
    range: Option<[f64; 2]>,
}

/// Averages of force and motion.
struct Averages {
    /// Samples in the middle of each.
    chosen: Vec<usize>,
    /// Displacement, velocity, acceleration, jerk, force and normal force.
    values: Vec<[f64; 6]>,
    least_speed: Vec<f64>,
    /// Standard deviation of the average, and of its first derivatives, for samples with that of 1.
    gains: [f64; 4],
}

/// Noise of a motion: its standard deviation, and the number of derivatives from what was measured to the velocity.
#[derive(Clone, Copy)]
struct Noise {
    deviation: f64,
    order: usize,
}

/// Noise of the motion where it moves. Where it rests, that of an encoder cannot be seen.
fn noise_of_motion(record: &Record, moved: &[[f64; 3]]) -> Noise {
    let order = usize::from(record.is_differentiated);
    let is_moving = |at: usize| record.velocity[at].abs() > UNKNOWN_SIGN * record.velocity_error;
    let strokes = moved.iter().enumerate().filter(|(at, _)| is_moving(*at));
    Noise { deviation: noise(&strokes.map(|(_, one)| one[1 - order]).collect::<Vec<f64>>()), order }
}

impl Averages {
    fn of(record: &Record, force: &[f64], moved: &[[f64; 3]], window: f64, doubt: f64) -> Averages {
        let time = &record.time;
        let interval = record.quality.interval;
        let half = f64::max(0.5 * window, 1.5 * interval);
        let stencil = (NODES / 2) as f64 * interval;
        // Where the stencils of the samples of a window reach: at any delay, since none may end outside of the motion;
        // and at one that is little in doubt, since rest within a long doubt is hardly mixed with the average.
        let [widest, reach] = [doubt, doubt.min(stencil)].map(|doubt| half + stencil + doubt);
        let [first, last] = [time[0] + widest, time[time.len() - 1] - widest];
        let step = ((half / interval) as usize).max(1);
        let is_inside = |at: &usize| (first..=last).contains(&time[*at]) && is_whole(time, *at, widest, interval);
        let chosen: Vec<usize> = (0..time.len()).step_by(step).filter(is_inside).collect();
        let values = chosen.iter().map(|at| average(record, force, moved, *at, half)).collect();
        let least_speed = chosen.iter().map(|at| least_speed(record, time[*at], reach)).collect();
        Averages { chosen, values, least_speed, gains: gains(half, interval) }
    }

    /// Whether few are left without those that are slow.
    fn are_few(&self, record: &Record) -> bool {
        let slow = SLOW * record.quality.fastest;
        self.least_speed.iter().filter(|least| **least > slow).count() < LEAST
    }

    /// Regression of the force where the velocity keeps its sign; None if too little is left.
    fn regression(&self, record: &Record, noise: Noise, doubt: f64) -> Option<Regression> {
        let is_moving = |least: &f64| *least > UNKNOWN_SIGN * record.velocity_error && *least > 0.0;
        let moving = self.values.iter().zip(&self.least_speed).filter(|(_, least)| is_moving(least));
        let rows: Vec<(SVector<f64, TERMS>, f64)> = moving.map(|(values, _)| (terms(values), values[4])).collect();
        let mut found = Regression::of(&rows)?;
        let mass = found.values[ACCELERATION];
        let gain = |more: usize| self.gains[noise.order + more];
        let noise = |more: usize| noise.deviation * gain(more);
        let ratio = gain(1) / gain(2);
        let late = if doubt > 0.0 { doubt.max(BANDWIDTH * ratio * ratio) } else { 0.0 };
        found.noises = [
            (VELOCITY, noise(0), found.values[VELOCITY]),
            (ACCELERATION, noise(1), mass),
            (JERK, noise(2), mass * late),
        ];
        Some(found)
    }

    /// Takes the share of noise away from what the jerk does not have in common with the other terms. Of a term that has
    /// only noise for itself, what the others explain is left: its coefficient is then undetermined, not wrong.
    fn calibrate(&mut self, regression: &Regression) {
        let is_noisy = [ACCELERATION, VELOCITY, JERK].map(|term| regression.share(term) > NOISY);
        let noisy = [(ACCELERATION, 2), (VELOCITY, 1), (JERK, 3)].into_iter().zip(is_noisy).filter(|(_, it)| *it);
        let noisy: Vec<(usize, usize)> = noisy.map(|(one, _)| one).collect();
        let kept: Vec<usize> = (0..TERMS).filter(|term| noisy.iter().all(|(noisy, _)| noisy != term)).collect();
        let explained: Vec<_> = noisy.iter().map(|(term, _)| regression.explained(*term, &kept)).collect();
        let share = regression.share(JERK);
        for values in &mut self.values {
            let terms = terms(values);
            for ((_, column), weights) in noisy.iter().zip(&explained) {
                values[*column] = weights.dot(&terms);
            }
            if share <= NOISY {
                values[3] -= share * regression.alone(&terms, JERK);
            }
        }
    }

    /// The record with the averages in place of the samples.
    fn record(self, record: &Record, mass: f64, Delayed { delay, range }: Delayed, window: f64) -> Record {
        let column = |number: usize| -> Vec<f64> { self.values.iter().map(|one| one[number]).collect() };
        let [displacement, velocity, acceleration, jerk, force, normal_force] = [0, 1, 2, 3, 4, 5].map(column);
        let friction_force = force.iter().zip(&acceleration).map(|(force, a)| force - mass * a).collect();
        let noise = record.quality.noise * self.gains[0];
        let clocks = Clocks { delay, ..record.clocks };
        Record {
            time: self.chosen.iter().map(|at| record.time[*at]).collect(),
            alike: Some(Alike { jerk, least_speed: self.least_speed, noise }),
            displacement,
            velocity,
            acceleration,
            force,
            normal_force,
            friction_force,
            window,
            clocks,
            delay_range: range,
            ..record.clone()
        }
    }
}

/// Terms of the regression for an average.
fn terms([_, v, a, jerk, ..]: &[f64; 6]) -> SVector<f64, TERMS> {
    SVector::from([*a, *v, v.signum(), 1.0, *jerk])
}

/// Part of the squares of the terms that is added to them, so that terms that are alike have a regression too.
const ROUNDING: f64 = 1e-12;

/// Regression of the force.
struct Regression {
    values: SVector<f64, TERMS>,
    /// Normal equations.
    gram: SMatrix<f64, TERMS, TERMS>,
    /// Their inverse.
    inverse: SMatrix<f64, TERMS, TERMS>,
    /// Variance of what is left.
    variance: f64,
    count: f64,
    /// Terms with noise of the motion in them, its standard deviation, and the coefficient that it shifts.
    noises: [(usize, f64, f64); 3],
}

impl Regression {
    fn of(rows: &[(SVector<f64, TERMS>, f64)]) -> Option<Regression> {
        if rows.len() < LEAST {
            return None;
        }
        let (mut gram, mut right) = (SMatrix::<f64, TERMS, TERMS>::zeros(), SVector::<f64, TERMS>::zeros());
        for (terms, force) in rows {
            gram += terms * terms.transpose();
            right += terms * *force;
        }
        let inverse = inverse(&gram)?;
        let values = inverse * right;
        let left: f64 = rows.iter().map(|(terms, force)| (force - terms.dot(&values)).powi(2)).sum();
        let variance = left / (rows.len() - TERMS) as f64;
        Some(Regression { values, gram, inverse, variance, count: rows.len() as f64, noises: [(0, 0.0, 0.0); 3] })
    }

    /// Share of noise of the motion in what a term does not have in common with the others.
    fn share(&self, term: usize) -> f64 {
        let of = |(noisy, deviation, _): &(usize, f64, f64)| if *noisy == term { deviation * deviation } else { 0.0 };
        self.noises.iter().map(of).sum::<f64>() * self.count * self.inverse[(term, term)]
    }

    /// Part of a term that the others do not have in common with it.
    fn alone(&self, terms: &SVector<f64, TERMS>, term: usize) -> f64 {
        (self.inverse.row(term) * terms)[0] / self.inverse[(term, term)]
    }

    /// Weights with which some terms explain another one.
    fn explained(&self, term: usize, by: &[usize]) -> SVector<f64, TERMS> {
        let is_used = |one: usize| by.contains(&one);
        let gram = SMatrix::<f64, TERMS, TERMS>::from_fn(|row, column| match (is_used(row), is_used(column)) {
            (true, true) => self.gram[(row, column)],
            _ => f64::from(u8::from(row == column)),
        });
        let right = SVector::<f64, TERMS>::from_fn(|row, _| if is_used(row) { self.gram[(row, term)] } else { 0.0 });
        inverse(&gram).map_or(SVector::zeros(), |inverse| inverse * right)
    }

    /// Amount by which the noise of the motion in some terms may shift a coefficient.
    fn shift(&self, term: usize, is_meant: impl Fn(usize) -> bool) -> f64 {
        let by = |(noisy, _, value): &(usize, f64, f64)| {
            self.share(*noisy) * (self.inverse[(term, *noisy)] / self.inverse[(*noisy, *noisy)] * value).abs()
        };
        self.noises.iter().filter(|(noisy, ..)| is_meant(*noisy)).map(by).sum()
    }

    /// The amount that the intervals do not say, as a part of the coefficient: that by terms that do not only have noise
    /// for themselves, of which the averages are free. None if the coefficient is within its own error, as viscous
    /// friction that there hardly is.
    fn relative_shift(&self, term: usize) -> Option<f64> {
        let value = self.values[term].abs();
        let is_told = |noisy: usize| self.share(noisy) <= NOISY;
        (value * value > self.error(term)).then(|| self.shift(term, is_told) / value)
    }

    /// Square of the error of a coefficient.
    fn error(&self, term: usize) -> f64 {
        self.variance * self.inverse[(term, term)].max(0.0) + self.shift(term, |_| true).powi(2)
    }

    /// Sum of the logarithms of the errors of mass, viscous and Coulomb friction, and offset.
    fn doubt(&self) -> f64 {
        (0..JUDGED).map(|term| 0.5 * Real::ln(self.error(term).max(f64::MIN_POSITIVE))).sum()
    }

    /// Time by which the motion is later than assumed, s; 0 if noise says so.
    fn late(&self) -> f64 {
        let mass = self.values[ACCELERATION];
        if mass > 0.0 && self.share(JERK) < NOISY { self.values[JERK] / mass } else { 0.0 }
    }
}

/// Inverse of normal equations. Terms are brought to a size of their own: the largest jerk is far above 1.
fn inverse(gram: &SMatrix<f64, TERMS, TERMS>) -> Option<SMatrix<f64, TERMS, TERMS>> {
    type Square = SMatrix<f64, TERMS, TERMS>;
    let size = gram.diagonal().map(|square| square.sqrt().max(f64::MIN_POSITIVE));
    let scaled = Square::from_fn(|row, column| gram[(row, column)] / (size[row] * size[column]));
    let inverse = (scaled + Square::identity() * ROUNDING).try_inverse()?;
    Some(Square::from_fn(|row, column| inverse[(row, column)] / (size[row] * size[column])))
}

/// Whether all samples within some time of one are there: a stencil cannot bridge a gap.
fn is_whole(time: &[f64], middle: usize, reach: f64, interval: f64) -> bool {
    // With a sample more at each end: a gap may begin within the reach and end outside.
    let from = time.partition_point(|t| *t < time[middle] - reach).saturating_sub(1);
    let to = (time.partition_point(|t| *t <= time[middle] + reach) + 1).min(time.len());
    time[from..to].windows(2).all(|pair| pair[1] - pair[0] < GAP * interval)
}

/// Weight of a sample at a part of half the window.
fn weight(part: f64) -> f64 {
    let square = (1.0 - part * part).max(0.0).powi(2);
    square * square
}

/// Standard deviation of the average of even samples of noise of 1, and of its first, second and third derivative.
fn gains(half: f64, interval: f64) -> [f64; 4] {
    let most = (half / interval) as i32 + 1;
    let mut weights: Vec<f64> =
        (-most - 3..=most + 3).map(|at| weight((f64::from(at) * interval / half).clamp(-1.0, 1.0))).collect();
    let total: f64 = weights.iter().sum();
    let mut unit = total;
    [(); 4].map(|()| {
        let gain = weights.iter().map(|one| one * one).sum::<f64>().sqrt() / unit;
        weights = weights.windows(2).map(|pair| pair[1] - pair[0]).collect();
        unit *= interval;
        gain
    })
}

/// Averages around a sample.
fn average(record: &Record, force: &[f64], moved: &[[f64; 3]], middle: usize, half: f64) -> [f64; 6] {
    let time = &record.time;
    let from = time.partition_point(|t| *t <= time[middle] - half);
    let to = time.partition_point(|t| *t < time[middle] + half);
    let (mut sums, mut total) = ([0.0; 6], 0.0);
    for at in from..to {
        let weight = weight((time[at] - time[middle]) / half);
        let [x, v, a] = moved[at];
        let [left, right] = [at.saturating_sub(1), (at + 1).min(time.len() - 1)];
        let jerk = (moved[right][2] - moved[left][2]) / (time[right] - time[left]);
        for (sum, value) in sums.iter_mut().zip([x, v, a, jerk, force[at], record.normal_force[at]]) {
            *sum += weight * value;
        }
        total += weight;
    }
    sums.map(|sum| sum / total)
}

/// Least speed within some time of another one; 0 where it turns.
fn least_speed(record: &Record, time: f64, reach: f64) -> f64 {
    let from = record.time.partition_point(|t| *t < time - reach);
    let to = record.time.partition_point(|t| *t <= time + reach);
    let velocity = &record.velocity[from..to];
    let turns = velocity.windows(2).any(|pair| pair[0] * pair[1] <= 0.0);
    if turns { 0.0 } else { velocity.iter().fold(f64::INFINITY, |least, v| least.min(v.abs())) }
}
