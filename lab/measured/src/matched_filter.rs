//! Matched filtering of force and motion, for driven axes: both pass the same low-pass filter and decimation.
//!
//! # Equations
//! Displacement, velocity, acceleration and force at the same samples are averaged with the same weights around a time:
//!
//! ```text
//! y(t) = sum w_j y_j / sum w_j,   w_j = (1 - (2 (t_j - t) / L)^2)^4   for |t_j - t| < L / 2
//! ```
//!
//! so that F = M a + f_v v + f_c sgn(v) + b holds for the averages as for the samples, however fast the motion is,
//! wherever v keeps its sign within the window. A filter of the motion alone would attenuate its high frequencies but
//! not those of the force. Velocity and acceleration of the samples are finite differences, which attenuate nothing.
//! One average is kept every half window.
//!
//! The window is the one in which the regression of F on a, v, sgn(v), 1 and da/dt has the least error of the first four
//! coefficients (sum of the logarithms). The coefficient of da/dt is the mass times the residual delay of the motion. An
//! error has two parts: the standard deviation, and the bias caused by noise of the motion in a, v and da/dt. With the
//! noise fraction q_k of the part of a regressor that is orthogonal to the others, and the inverse C of the normal
//! equations, the bias is
//!
//! ```text
//! |shift_i| <= sum_k q_k |C_ik / C_kk| |p_k|
//! ```
//!
//! where p_k is the coefficient of the regressor; that of da/dt is the mass times the uncertainty of the delay, or times
//! the apparent delay that a controller causes by reacting to noise, whichever is larger. The noise fraction is removed
//! from the orthogonal part of da/dt, so that noise does not look like a delay; above a fraction of [`NOISY`] the whole
//! orthogonal part is removed, for a and v too, and the coefficient is not determined. The force of a controller is held
//! until the next sample, which averages it over an interval h; its samples are averaged in the same way,
//! y_j + (y_j-1 - 2 y_j + y_j+1) / 24.
//!
//! For an arm that gravity turns the regressors are also the averages of cos q and sin q, with its angle q.
//!
//! # Source
//! Parallel filtering of force and regressors, and its decimation: M. Brunot, A. Janot, P. C. Young, F. Carrillo, "An
//! improved instrumental variable method for industrial robot model identification", Control Engineering Practice 74
//! (2018), doi:10.1016/j.conengprac.2018.02.010. Weights and choice of the window are chosen here.

use nalgebra::{SMatrix, SVector};
use stribeck::number::Real;

use crate::clock::{Clocks, range_around};
use crate::movement::Movement;
use crate::quality::{GAP, noise};
use crate::record::{Direction, MatchedFilter, Record};
use crate::stencil::NODES;

/// Delay of the motion behind the force of a controller, least and largest, in samples of the motion (chosen): half a
/// sample for a force that is held until the next sample, one more if computing it takes that long.
const CONTROLLER_DELAY: [f64; 2] = [-0.5, 2.0];

/// Mean of the least and the largest delay of a controller, s.
pub(crate) fn delay_of_controller(interval: f64) -> f64 {
    0.5 * (CONTROLLER_DELAY[0] + CONTROLLER_DELAY[1]) * interval
}

/// Half the range of the delay of a controller, s.
pub(crate) fn tolerance_of_controller(interval: f64) -> f64 {
    0.5 * (CONTROLLER_DELAY[1] - CONTROLLER_DELAY[0]) * interval
}

/// Length of the shortest window, s.
pub(crate) fn shortest(interval: f64) -> f64 {
    WINDOWS[0] * interval
}

/// Candidate windows, in samples (chosen).
const WINDOWS: [f64; 10] = [9.0, 11.0, 15.0, 21.0, 31.0, 41.0, 61.0, 91.0, 131.0, 191.0];

/// Regressors: acceleration, velocity, its sign, 1 and jerk; the errors of the first four decide on the window.
pub(crate) const TERMS: usize = 5;
/// The same with cosine and sine of the angle of an arm that gravity turns.
pub(crate) const OF_ARM: usize = 7;
const DECISIVE: usize = 4;
const ACCELERATION: usize = 0;
const VELOCITY: usize = 1;
const JERK: usize = 4;

/// Fraction of the highest speed below which friction is more than Coulomb and viscous friction (chosen): Stribeck
/// effect and pre-sliding.
pub const SLOW: f64 = 0.05;

/// Least number of averages for a regression of so many terms (chosen).
const fn least(terms: usize) -> usize {
    4 * terms
}

/// Multiple of the velocity error below which the sign of the velocity is uncertain (chosen, as in the identification).
const UNKNOWN_SIGN: f64 = 3.0;

/// Noise fraction above which the orthogonal part of a regressor is discarded (chosen). It was below 0.006 in records of
/// three frequencies, and from 0.10 to 0.33 in those of one, in which the reaction of a controller to rounding then looked
/// like 1 to 6 ms of delay.
const NOISY: f64 = 0.05;

/// Iterations of the delay (chosen); each evaluates the motion at the delay of the previous one.
const ROUNDS: usize = 4;

/// Motion at the samples of the force: displacement, velocity and acceleration without a filter.
pub(crate) type Raw = Vec<[f64; 3]>;

/// Relative bias of mass or viscous friction by noise of the motion from which there is a warning (chosen).
const BIASED: f64 = 3e-3;

/// Bandwidth in rad/s of a controller that passes noise of the motion on to the force (chosen, 16 Hz): the force then
/// correlates with the noise, which looks like a delay of the noise fraction of da/dt times this bandwidth times the ratio
/// of the variances of the noise in a and da/dt.
const BANDWIDTH: f64 = 100.0;

/// The matched filter of one record, before its window is chosen.
pub(crate) struct Filter<'a, const N: usize> {
    /// Record with the motion smoothed alone.
    record: &'a Record,
    /// Force as it acts.
    force: Vec<f64>,
    /// Unfiltered motion at a delay.
    raw: &'a dyn Fn(f64) -> Raw,
    /// The same at the delay of the record.
    motion: Raw,
    /// Largest deviation of the delay from that of the record, s; 0 if it is known.
    tolerance: f64,
    noise: Noise,
}

impl<'a, const N: usize> Filter<'a, N> {
    /// `is_held`: the force is that of a controller which holds it until the next sample.
    pub fn new(record: &'a Record, raw: &'a dyn Fn(f64) -> Raw, tolerance: f64, is_held: bool) -> Filter<'a, N> {
        let force = if is_held { held(&record.force) } else { record.force.clone() };
        let motion = raw(record.clocks.delay);
        let noise = noise_of_motion(record, &motion);
        Filter { record, force, raw, motion, tolerance, noise }
    }

    /// The filtered record, in the given window or in the best one; None if no window leaves enough samples.
    pub fn apply(&self, mass: f64, window: Option<f64>) -> Option<Record> {
        let interval = self.record.quality.interval;
        let windows = window.map_or_else(|| WINDOWS.map(|samples| samples * interval).to_vec(), |one| vec![one]);
        let best = self.best(&windows)?;
        let delay = self.delay(best)?;
        let mut averages = self.averages(&(self.raw)(delay), best);
        let regression = self.regression(&averages)?;
        averages.calibrate(&regression);
        let range = (self.tolerance > 0.0).then(|| range_around(self.record.clocks.delay, self.tolerance));
        let mut record = averages.record(self.record, mass, Delayed { delay, range }, best);
        record.quality.findings.extend(regression.finding(self.record.movement));
        Some(record)
    }

    /// The window whose regression has the least error; windows that leave few averages come last.
    fn best(&self, windows: &[f64]) -> Option<f64> {
        let tried = windows.iter().filter_map(|window| {
            let averages = self.averages(&self.motion, *window);
            Some((averages.are_few(self.record, least(N)), self.regression(&averages)?.log_error(), *window))
        });
        tried.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(.., window)| window)
    }

    /// Delay of the motion, s: the coefficient of the jerk corrects it, round by round.
    fn delay(&self, window: f64) -> Option<f64> {
        let start = self.record.clocks.delay;
        let [least, most] = range_around(start, self.tolerance);
        let mut delay = start;
        for _ in 0..if self.tolerance > 0.0 { ROUNDS } else { 0 } {
            let averages = self.averages(&(self.raw)(delay), window);
            delay = (delay + self.regression(&averages)?.delay()).clamp(least, most);
        }
        Some(delay)
    }

    fn averages(&self, motion: &[[f64; 3]], window: f64) -> Averages {
        Averages::of(self.record, &self.force, motion, window, self.tolerance)
    }

    fn regression(&self, averages: &Averages) -> Option<Regression<N>> {
        averages.regression(self.record, self.noise, self.tolerance)
    }
}

/// A force that is held until the next sample, averaged over an interval.
fn held(force: &[f64]) -> Vec<f64> {
    let at = |at: usize| match force.get(at.wrapping_sub(1)..=at + 1) {
        Some([before, now, after]) => now + (before - 2.0 * now + after) / 24.0,
        _ => force[at],
    };
    (0..force.len()).map(at).collect()
}

/// Estimated delay and the range of the estimation, s.
struct Delayed {
    delay: f64,
    range: Option<[f64; 2]>,
}

/// A weighted average of displacement, velocity, acceleration, jerk, force, normal force, cosine and sine.
type Average = [f64; 8];

/// Weighted averages of force and motion.
struct Averages {
    /// Sample in the middle of each.
    chosen: Vec<usize>,
    /// Displacement, velocity, acceleration, jerk, force and normal force; cosine and sine of the angle of an arm.
    values: Vec<Average>,
    least_speed: Vec<f64>,
    /// Standard deviations of an average and of its first three derivatives, for white noise of 1 in the samples.
    gains: [f64; 4],
}

/// Noise of a motion: its standard deviation, and the order of the derivative from the measured signal to the velocity.
#[derive(Clone, Copy)]
struct Noise {
    deviation: f64,
    order: usize,
}

/// Noise of the motion while it moves: at rest an encoder shows none.
fn noise_of_motion(record: &Record, motion: &[[f64; 3]]) -> Noise {
    let order = usize::from(record.is_differentiated);
    let is_moving = |at: usize| record.velocity[at].abs() > UNKNOWN_SIGN * record.velocity_error;
    let strokes = motion.iter().enumerate().filter(|(at, _)| is_moving(*at));
    Noise { deviation: noise(&strokes.map(|(_, one)| one[1 - order]).collect::<Vec<f64>>()), order }
}

impl Averages {
    fn of(record: &Record, force: &[f64], motion: &[[f64; 3]], window: f64, tolerance: f64) -> Averages {
        let time = &record.time;
        let interval = record.quality.interval;
        let half = f64::max(0.5 * window, 1.5 * interval);
        let stencil = (NODES / 2) as f64 * interval;
        // Reach of the stencils of a window: at any delay, since none may leave the motion; and at a delay that is nearly
        // known, since rest within a wide range of delays hardly enters the average.
        let [widest, reach] = [tolerance, tolerance.min(stencil)].map(|tolerance| half + stencil + tolerance);
        let [first, last] = [time[0] + widest, time[time.len() - 1] - widest];
        let step = ((half / interval) as usize).max(1);
        let is_inside = |at: &usize| (first..=last).contains(&time[*at]) && is_whole(time, *at, widest, interval);
        let chosen: Vec<usize> = (0..time.len()).step_by(step).filter(is_inside).collect();
        let values = chosen.iter().map(|at| average(record, force, motion, *at, half)).collect();
        let least_speed = chosen.iter().map(|at| least_speed(record, time[*at], reach)).collect();
        Averages { chosen, values, least_speed, gains: gains(half, interval) }
    }

    /// Whether few averages are faster than [`SLOW`].
    fn are_few(&self, record: &Record, least: usize) -> bool {
        let slow = SLOW * record.quality.fastest;
        self.least_speed.iter().filter(|speed| **speed > slow).count() < least
    }

    /// Regression of the force where the velocity keeps its sign; None with fewer averages than [`least`].
    fn regression<const N: usize>(&self, record: &Record, noise: Noise, tolerance: f64) -> Option<Regression<N>> {
        let is_moving = |least: &f64| *least > UNKNOWN_SIGN * record.velocity_error && *least > 0.0;
        let moving = self.values.iter().zip(&self.least_speed).filter(|(_, least)| is_moving(least));
        let rows: Vec<(SVector<f64, N>, f64)> = moving.map(|(values, _)| (terms(values), values[4])).collect();
        let mut regression = Regression::of(&rows)?;
        let mass = regression.values[ACCELERATION];
        let gain = |order: usize| self.gains[noise.order + order];
        let deviation = |order: usize| noise.deviation * gain(order);
        let ratio = gain(1) / gain(2);
        let delay = if tolerance > 0.0 { tolerance.max(BANDWIDTH * ratio * ratio) } else { 0.0 };
        regression.noises = [
            (VELOCITY, deviation(0), regression.values[VELOCITY]),
            (ACCELERATION, deviation(1), mass),
            (JERK, deviation(2), mass * delay),
        ];
        Some(regression)
    }

    /// Removes the noise fraction of the orthogonal part of the jerk. A regressor whose orthogonal part is mostly noise is
    /// replaced by its projection on the others: its coefficient is then undetermined, not wrong.
    fn calibrate<const N: usize>(&mut self, regression: &Regression<N>) {
        let mut noisy = vec![(ACCELERATION, 2), (VELOCITY, 1), (JERK, 3)];
        noisy.retain(|(term, _)| regression.noise_fraction(*term) > NOISY);
        let kept: Vec<usize> = (0..N).filter(|term| noisy.iter().all(|(noisy, _)| noisy != term)).collect();
        let projections: Vec<_> = noisy.iter().map(|(term, _)| regression.projection(*term, &kept)).collect();
        let fraction = regression.noise_fraction(JERK);
        for values in &mut self.values {
            let terms = terms::<N>(values);
            for ((_, column), weights) in noisy.iter().zip(&projections) {
                values[*column] = weights.dot(&terms);
            }
            if fraction <= NOISY {
                values[3] -= fraction * regression.orthogonal(&terms, JERK);
            }
        }
    }

    /// The record with the averages in place of the samples.
    fn record(self, record: &Record, mass: f64, Delayed { delay, range }: Delayed, window: f64) -> Record {
        let column = |number: usize| -> Vec<f64> { self.values.iter().map(|one| one[number]).collect() };
        let [displacement, velocity, acceleration, jerk, force, normal_force] = [0, 1, 2, 3, 4, 5].map(column);
        let friction_force = force.iter().zip(&acceleration).map(|(force, a)| force - mass * a).collect();
        let noise = record.quality.noise * self.gains[0];
        let direction = record.direction.as_ref().map(|_| Direction { cosine: column(6), sine: column(7) });
        let clocks = Clocks { delay, ..record.clocks };
        let chosen = |all: &[f64]| self.chosen.iter().map(|at| all[*at]).collect::<Vec<f64>>();
        Record {
            time: chosen(&record.time),
            channels: record.channels.iter().map(|one| one.with(chosen(&one.values))).collect(),
            matched_filter: Some(MatchedFilter { jerk, least_speed: self.least_speed, noise }),
            displacement,
            velocity,
            acceleration,
            force,
            normal_force,
            friction_force,
            direction,
            window,
            clocks,
            delay_range: range,
            ..record.clone()
        }
    }
}

/// Regressors of an average.
fn terms<const N: usize>([_, v, a, jerk, _, _, cosine, sine]: &Average) -> SVector<f64, N> {
    let all = [*a, *v, v.signum(), 1.0, *jerk, *cosine, *sine];
    SVector::from_fn(|row, _| all[row])
}

/// Regularisation of the scaled normal equations (chosen): collinear regressors have a solution too.
const ROUNDING: f64 = 1e-12;

/// Regression of the force.
struct Regression<const N: usize> {
    values: SVector<f64, N>,
    /// Normal equations.
    gram: SMatrix<f64, N, N>,
    /// Their inverse.
    inverse: SMatrix<f64, N, N>,
    /// Variance of the residual.
    variance: f64,
    count: f64,
    /// Regressors with noise of the motion, its standard deviation, and the coefficient that it biases.
    noises: [(usize, f64, f64); 3],
}

impl<const N: usize> Regression<N> {
    fn of(rows: &[(SVector<f64, N>, f64)]) -> Option<Regression<N>> {
        if rows.len() < least(N) {
            return None;
        }
        let (mut gram, mut right) = (SMatrix::<f64, N, N>::zeros(), SVector::<f64, N>::zeros());
        for (terms, force) in rows {
            gram += terms * terms.transpose();
            right += terms * *force;
        }
        let inverse = inverse(&gram)?;
        let values = inverse * right;
        let squares: f64 = rows.iter().map(|(terms, force)| (force - terms.dot(&values)).powi(2)).sum();
        let variance = squares / (rows.len() - N) as f64;
        Some(Regression { values, gram, inverse, variance, count: rows.len() as f64, noises: [(0, 0.0, 0.0); 3] })
    }

    /// Fraction of noise of the motion in the orthogonal part of a regressor.
    fn noise_fraction(&self, term: usize) -> f64 {
        let of = |(noisy, deviation, _): &(usize, f64, f64)| if *noisy == term { deviation * deviation } else { 0.0 };
        self.noises.iter().map(of).sum::<f64>() * self.count * self.inverse[(term, term)]
    }

    /// Part of a regressor that is orthogonal to the others.
    fn orthogonal(&self, terms: &SVector<f64, N>, term: usize) -> f64 {
        (self.inverse.row(term) * terms)[0] / self.inverse[(term, term)]
    }

    /// Weights of the projection of a regressor on some others.
    fn projection(&self, term: usize, by: &[usize]) -> SVector<f64, N> {
        let is_used = |one: usize| by.contains(&one);
        let gram = SMatrix::<f64, N, N>::from_fn(|row, column| match (is_used(row), is_used(column)) {
            (true, true) => self.gram[(row, column)],
            _ => f64::from(u8::from(row == column)),
        });
        let right = SVector::<f64, N>::from_fn(|row, _| if is_used(row) { self.gram[(row, term)] } else { 0.0 });
        inverse(&gram).map_or(SVector::zeros(), |inverse| inverse * right)
    }

    /// Largest bias of a coefficient by noise of the motion in some regressors.
    fn bias(&self, term: usize, is_included: impl Fn(usize) -> bool) -> f64 {
        let bias_by = |(noisy, _, value): &(usize, f64, f64)| {
            self.noise_fraction(*noisy) * (self.inverse[(term, *noisy)] / self.inverse[(*noisy, *noisy)] * value).abs()
        };
        self.noises.iter().filter(|(noisy, ..)| is_included(*noisy)).map(bias_by).sum()
    }

    /// Relative bias of a coefficient that the intervals do not cover: that by the regressors which
    /// [`Averages::calibrate`] keeps. None if the coefficient is within its own error.
    fn relative_bias(&self, term: usize) -> Option<f64> {
        let value = self.values[term].abs();
        let is_kept = |noisy: usize| self.noise_fraction(noisy) <= NOISY;
        (value * value > self.squared_error(term)).then(|| self.bias(term, is_kept) / value)
    }

    /// Warning about biased coefficients.
    fn finding(&self, movement: Movement) -> Option<String> {
        let inertia = format!("the {}", movement.inertia());
        let biased: Vec<String> = [(ACCELERATION, inertia.as_str()), (VELOCITY, "viscous friction")]
            .into_iter()
            .filter_map(|(term, name)| Some((name, self.relative_bias(term)?)))
            .filter(|(_, bias)| *bias > BIASED)
            .map(|(name, bias)| format!("{name} by {:.1} %", 100.0 * bias))
            .collect();
        (!biased.is_empty()).then(|| {
            format!(
                "noise of the motion may shift {}, more than the intervals say: measure the motion more finely, \
                 accelerate more, or move with several frequencies",
                biased.join(" and ")
            )
        })
    }

    /// Square of the error of a coefficient: variance and squared bias.
    fn squared_error(&self, term: usize) -> f64 {
        self.variance * self.inverse[(term, term)].max(0.0) + self.bias(term, |_| true).powi(2)
    }

    /// Sum of the logarithms of the errors of mass, viscous and Coulomb friction, and offset.
    fn log_error(&self) -> f64 {
        (0..DECISIVE).map(|term| 0.5 * Real::ln(self.squared_error(term).max(f64::MIN_POSITIVE))).sum()
    }

    /// Residual delay of the motion, s; 0 if the jerk is too noisy to determine it.
    fn delay(&self) -> f64 {
        let mass = self.values[ACCELERATION];
        if mass > 0.0 && self.noise_fraction(JERK) < NOISY { self.values[JERK] / mass } else { 0.0 }
    }
}

/// Inverse of normal equations, scaled to a unit diagonal: the largest jerk is far above 1.
fn inverse<const N: usize>(gram: &SMatrix<f64, N, N>) -> Option<SMatrix<f64, N, N>> {
    let size = gram.diagonal().map(|square| square.sqrt().max(f64::MIN_POSITIVE));
    let scaled = SMatrix::<f64, N, N>::from_fn(|row, column| gram[(row, column)] / (size[row] * size[column]));
    let inverse = (scaled + SMatrix::identity() * ROUNDING).try_inverse()?;
    Some(SMatrix::from_fn(|row, column| inverse[(row, column)] / (size[row] * size[column])))
}

/// Whether no sample is missing within some time of another: a stencil cannot bridge a gap.
fn is_whole(time: &[f64], middle: usize, reach: f64, interval: f64) -> bool {
    // With a sample more at each end: a gap may begin within the reach and end outside.
    let from = time.partition_point(|t| *t < time[middle] - reach).saturating_sub(1);
    let to = (time.partition_point(|t| *t <= time[middle] + reach) + 1).min(time.len());
    time[from..to].windows(2).all(|pair| pair[1] - pair[0] < GAP * interval)
}

/// Weight of a sample at a distance from the middle, in half windows.
fn weight(distance: f64) -> f64 {
    let square = (1.0 - distance * distance).max(0.0).powi(2);
    square * square
}

/// Standard deviations of the average of evenly spaced samples of white noise of 1, and of its first three derivatives.
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

/// Averages in the window around a sample.
fn average(record: &Record, force: &[f64], motion: &[[f64; 3]], middle: usize, half: f64) -> Average {
    let time = &record.time;
    let from = time.partition_point(|t| *t <= time[middle] - half);
    let to = time.partition_point(|t| *t < time[middle] + half);
    let (mut sums, mut total) = ([0.0; 8], 0.0);
    let is_arm = record.direction.is_some();
    for at in from..to {
        let weight = weight((time[at] - time[middle]) / half);
        let [x, v, a] = motion[at];
        let [left, right] = [at.saturating_sub(1), (at + 1).min(time.len() - 1)];
        let jerk = (motion[right][2] - motion[left][2]) / (time[right] - time[left]);
        let [cosine, sine] = if is_arm { [Real::cos(x), Real::sin(x)] } else { [0.0; 2] };
        let values = [x, v, a, jerk, force[at], record.normal_force[at], cosine, sine];
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += weight * value;
        }
        total += weight;
    }
    sums.map(|sum| sum / total)
}

/// Least speed within `reach` of a time; 0 if the motion turns there.
fn least_speed(record: &Record, time: f64, reach: f64) -> f64 {
    let from = record.time.partition_point(|t| *t < time - reach);
    let to = record.time.partition_point(|t| *t <= time + reach);
    let velocity = &record.velocity[from..to];
    let turns = velocity.windows(2).any(|pair| pair[0] * pair[1] <= 0.0);
    if turns { 0.0 } else { velocity.iter().fold(f64::INFINITY, |least, v| least.min(v.abs())) }
}
