//! Windows of the filter of the motion: a longer one passes less noise and has more bias.
//!
//! # Equation
//! A derivative in a window of length w has the variance s2 g_w by white noise of variance s2 in the samples, and the bias
//! b_w. A least-squares estimate from more samples is not correlated with its difference from one of fewer samples, so
//! that with a shorter window u
//!
//! ```text
//! mean (d_w - d_u)2 = s2 (g_u - g_w) + mean (b_w - b_u)2
//! b_u = b_w (u/w)^p            p = 6 for the first derivative by the fifth degree, 2 for the second one by the third
//! ```
//!
//! s2 follows from the residuals in the shortest window; it is at least that of rounding to the resolution of the samples.
//! Velocity and acceleration have a window each, with the least s2 g + [`BIAS_WEIGHT`] b2.
//!
//! The means are weighted by |d2x/dt2|: the bias vanishes at rest and in steady motion, and friction changes where the
//! motion turns.
//!
//! # Source
//! Order of the bias: R. W. Schafer, "What is a Savitzky-Golay filter?", IEEE Signal Processing Magazine 28 (2011),
//! doi:10.1109/MSP.2011.941097.

use std::ops::Range;

use crate::polynomial::{Degree, Local};
use crate::quality::{GAP, rounding};

/// Candidate windows, in samples (chosen).
const WINDOWS: [f64; 24] = [
    5.0, 7.0, 9.0, 11.0, 13.0, 15.0, 18.0, 21.0, 25.0, 31.0, 37.0, 45.0, 54.0, 65.0, 77.0, 91.0, 109.0, 131.0, 158.0,
    191.0, 227.0, 271.0, 325.0, 391.0,
];

/// Weight of the squared bias against the variance (chosen): the bias is the same in all reversals and biases the
/// parameters of a law, while noise averages out.
const BIAS_WEIGHT: f64 = 10.0;

/// Places between two windows whose estimates are compared (chosen): neighbours hardly differ by anything but noise.
const APART: usize = 2;

/// Cost, relative to the least one, above which a window is too long, and how many such windows end the search (chosen).
const RISEN: f64 = 5.0;
const TOO_LONG: usize = 6;

/// Most samples at which windows are compared, and most at which speeds are (chosen).
const POINTS: usize = 4000;
const SPEEDS: usize = 20_000;

/// Longest window, relative to the record (chosen).
const LONGEST: f64 = 0.1;

/// Fraction of the largest speed below which a motion is near rest (chosen).
const SLOW: f64 = 0.1;

/// Power of the window with which the bias of the first derivative grows where a motion starts with a kink.
const ORDER_OF_KINK: i32 = 2;

/// Degree of the polynomials that give the first or the second derivative. Where the motion turns, slopes of third degree
/// lose so much in windows with little noise that the parameters of a law are biased.
pub(crate) fn degree(derivative: usize) -> Degree {
    if derivative == 1 { Degree::Fifth } else { Degree::Third }
}

/// Power of the window with which the bias of the first or the second derivative grows.
pub(crate) fn order(derivative: usize) -> i32 {
    match degree(derivative) {
        Degree::Third => 2,
        Degree::Fifth => 6,
    }
}

/// Candidate windows for a derivative, in samples.
fn candidates(derivative: usize) -> &'static [f64] {
    match degree(derivative) {
        Degree::Third => &WINDOWS,
        Degree::Fifth => &WINDOWS[1..],
    }
}

/// Length of a window, s, from its number of samples.
fn length(samples: f64, interval: f64) -> f64 {
    (samples - 0.5) * interval
}

/// Length of the shortest window for the first or the second derivative, s.
pub(crate) fn shortest(interval: f64, derivative: usize) -> f64 {
    length(candidates(derivative)[0], interval)
}

/// A signal to differentiate.
pub(crate) struct Signal<'a> {
    pub time: &'a [f64],
    pub values: &'a [f64],
    /// Median interval.
    pub interval: f64,
    /// Samples that the record uses.
    pub part: Range<usize>,
}

impl Signal<'_> {
    /// Lengths of the windows for the first and for the second derivative.
    pub fn windows(&self) -> [f64; 2] {
        let duration = self.time[self.part.end - 1] - self.time[self.part.start];
        let longest = f64::max(LONGEST * duration, length(WINDOWS[2 * APART], self.interval));
        let lengths_of = |derivative| {
            let lengths = candidates(derivative).iter().map(|samples| length(*samples, self.interval));
            lengths.filter(|length| *length <= longest).collect::<Vec<f64>>()
        };
        let points = Points::new(self, self.part.clone().collect(), lengths_of(2).into_iter().fold(0.0, f64::max));
        let noise = self.noise(&points);
        [1, 2].map(|derivative| {
            let lengths = lengths_of(derivative);
            let tried: Vec<Tried> =
                lengths.iter().map(|length| Tried::new(self, &points, *length, derivative)).collect();
            let costs = (0..tried.len()).map(|at| {
                let (shorter, longer) = if at < APART { (at, at + APART) } else { (at - APART, at) };
                let biases = tried[longer].biases(&tried[shorter], &points, noise, order(derivative));
                noise * tried[at].gain + BIAS_WEIGHT * biases[usize::from(at == longer)]
            });
            least(&lengths, costs)
        })
    }

    /// RMS error of the first derivative in a window near rest: noise and bias.
    pub fn error(&self, window: f64) -> f64 {
        // The shortest window has no shorter one beside it, but a longer one.
        let shortest = shortest(self.interval, 1);
        let lengths = if window > 1.4 * shortest { [0.7 * window, window] } else { [window, 1.4 * shortest] };
        let points = Points::new(self, self.slow(window), lengths[1]);
        let [shorter, longer] = lengths.map(|length| Tried::new(self, &points, length, 1));
        let noise = self.noise(&points);
        let biases = longer.biases(&shorter, &points, noise, ORDER_OF_KINK);
        let taken = usize::from(longer.length == window);
        (noise * [shorter, longer][taken].gain + biases[taken]).sqrt()
    }

    /// RMS noise of a derivative in a window: near its zeros the acceleration has hardly any other error.
    pub fn noise_in(&self, window: f64, derivative: usize) -> f64 {
        let shortest = shortest(self.interval, derivative);
        let points = Points::new(self, self.part.clone().collect(), window.max(shortest));
        (self.noise(&points) * Tried::new(self, &points, window, derivative).gain).sqrt()
    }

    /// Variance of the noise of the samples.
    fn noise(&self, points: &Points) -> f64 {
        let local = Local::new(self.time, self.values, length(WINDOWS[0], self.interval), Degree::Third);
        let gain = points.mean(|number| local.variances(self.time[points.at[number]])[0]);
        let residual = |at: usize| self.values[at] - local.at(self.time[at])[0];
        let values = &self.values[self.part.clone()];
        rounding(values).powi(2).max(points.mean(|number| residual(points.at[number]).powi(2)) / (1.0 - gain))
    }

    /// Samples at which the motion is near rest; all if it never is.
    fn slow(&self, window: f64) -> Vec<usize> {
        let local = Local::new(self.time, self.values, window, degree(1));
        let all = some(self.part.clone().collect(), SPEEDS);
        let speeds: Vec<f64> = all.iter().map(|at| local.at(self.time[*at])[1].abs()).collect();
        let fastest = speeds.iter().fold(0.0, |most: f64, speed| most.max(*speed));
        let slow: Vec<usize> =
            all.iter().zip(&speeds).filter(|(_, speed)| **speed < SLOW * fastest).map(|(at, _)| *at).collect();
        if slow.is_empty() { all } else { slow }
    }

    /// Whether a window around each time has samples at both sides and no gap.
    fn is_whole(&self, half: f64) -> impl Fn(f64) -> bool {
        let [first, last] = [self.time[0] + half, self.time[self.time.len() - 1] - half];
        let pairs = self.time.windows(2).filter(|pair| pair[1] - pair[0] > GAP * self.interval);
        let gaps: Vec<[f64; 2]> = pairs.map(|pair| [pair[0], pair[1]]).collect();
        move |t| {
            let next = gaps.partition_point(|[_, end]| *end <= t - half);
            (first..=last).contains(&t) && gaps.get(next).is_none_or(|[begin, _]| *begin >= t + half)
        }
    }
}

/// Samples at which windows are compared.
struct Points {
    at: Vec<usize>,
    /// Their weights; the sum is 1.
    weights: Vec<f64>,
}

impl Points {
    /// Samples at which the longest window fits; any samples if it fits nowhere.
    fn new(signal: &Signal, all: Vec<usize>, longest: f64) -> Points {
        let is_whole = signal.is_whole(0.5 * longest);
        let whole: Vec<usize> = all.iter().copied().filter(|at| is_whole(signal.time[*at])).collect();
        let at = some(if whole.is_empty() { all } else { whole }, POINTS);
        let local = Local::new(signal.time, signal.values, longest, degree(2));
        let bends: Vec<f64> = at.iter().map(|at| local.at(signal.time[*at])[2].abs()).collect();
        let sum: f64 = bends.iter().sum();
        let even = 1.0 / at.len() as f64;
        let weights = bends.iter().map(|bend| if sum > 0.0 { bend / sum } else { even }).collect();
        Points { at, weights }
    }

    fn mean(&self, of: impl Fn(usize) -> f64) -> f64 {
        self.weights.iter().enumerate().map(|(number, weight)| weight * of(number)).sum()
    }
}

/// The window of least cost before the cost has clearly risen: the bias of windows far too long hardly differs.
fn least(lengths: &[f64], costs: impl Iterator<Item = f64>) -> f64 {
    let (mut best, mut too_long) = ((lengths[0], f64::INFINITY), 0);
    for (length, cost) in lengths.iter().zip(costs) {
        too_long = if cost > RISEN * best.1 { too_long + 1 } else { 0 };
        if too_long == TOO_LONG {
            break;
        }
        if cost < best.1 {
            best = (*length, cost);
        }
    }
    best.0
}

/// At most `most` of the samples, evenly.
fn some(all: Vec<usize>, most: usize) -> Vec<usize> {
    let step = all.len().div_ceil(most).max(1);
    all.into_iter().step_by(step).collect()
}

/// A derivative in a window at all points of comparison.
struct Tried {
    length: f64,
    estimates: Vec<f64>,
    /// Mean of the variances by white noise of variance 1.
    gain: f64,
}

impl Tried {
    fn new(signal: &Signal, points: &Points, length: f64, derivative: usize) -> Tried {
        let local = Local::new(signal.time, signal.values, length, degree(derivative));
        let times: Vec<f64> = points.at.iter().map(|at| signal.time[*at]).collect();
        let gain = points.mean(|number| local.variances(times[number])[derivative]);
        Tried { length, estimates: times.iter().map(|t| local.at(*t)[derivative]).collect(), gain }
    }

    /// Mean squared bias in a shorter window and in this one, with noise of a variance.
    fn biases(&self, shorter: &Tried, points: &Points, noise: f64, order: i32) -> [f64; 2] {
        let by_noise = noise * (shorter.gain - self.gain);
        let beyond_noise =
            points.mean(|number| (self.estimates[number] - shorter.estimates[number]).powi(2)) - by_noise;
        let ratio = (shorter.length / self.length).powi(order);
        let squared_bias = beyond_noise.max(0.0) / (1.0 - ratio).powi(2);
        [squared_bias * ratio * ratio, squared_bias]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A sine with noise, whose derivatives are known: where it turns, the windows that are taken are about as good as any, down to some
    /// hundred-thousandths of the derivative. Below, what the shortest one misses looks like noise.
    #[test]
    fn the_windows_have_about_the_least_error() {
        let mut random = fastrand::Rng::with_seed(2);
        let mut spread = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        let time: Vec<f64> = (0..6000).map(|k| f64::from(k) * 1e-3).collect();
        for (frequency, noise) in [(1.0, 1e-6), (10.0, 1e-6), (10.0, 1e-8), (40.0, 1e-5), (10.0, 1e-9)] {
            let rate = TAU * frequency;
            let clean = |t: f64| 1e-3 * (rate * t).sin();
            let values: Vec<f64> = time.iter().map(|t| clean(*t) + noise * spread()).collect();
            let exact: Vec<f64> = time.iter().map(|t| clean(*t)).collect();
            let found = signal(&time, &values).windows();
            for derivative in [1, 2] {
                // What is missed, of the sine without noise, and the noise alone.
                let cost = |window: f64| {
                    let [noisy, smooth] =
                        [&values, &exact].map(|values| Local::new(&time, values, window, degree(derivative)));
                    let truth = |t: f64| [0.0, rate * 1e-3 * (rate * t).cos(), -rate * rate * clean(t)][derivative];
                    (100..5900).step_by(7).map(|at| time[at]).fold(0.0, |sum, t| {
                        let [noisy, smooth] = [&noisy, &smooth].map(|local| local.at(t)[derivative]);
                        let size = 1e-3 * rate.powi(derivative as i32);
                        let square = (noisy - smooth).powi(2) + BIAS_WEIGHT * (smooth - truth(t)).powi(2);
                        sum + (square + (3e-5 * size).powi(2)) * clean(t).abs()
                    })
                };
                let costs = candidates(derivative).iter().map(|samples| cost(length(*samples, 1e-3)));
                let least = costs.fold(f64::INFINITY, f64::min);
                let taken = cost(found[derivative - 1]);
                assert!(taken <= 2.0 * least, "{frequency} Hz, {noise} m: {taken} instead of {least}, {found:?}");
            }
        }
    }
    fn signal<'a>(time: &'a [f64], values: &'a [f64]) -> Signal<'a> {
        Signal { time, values, interval: 1e-3, part: 0..time.len() }
    }

    /// Errors of the derivatives of a sine in a window and in one twice as long.
    #[test]
    fn the_bias_grows_with_its_power_of_the_window() {
        let time: Vec<f64> = (0..4001).map(|k| f64::from(k - 2000) * 1e-4).collect();
        for (derivative, phase) in [(1, 0.0), (2, 0.25 * TAU)] {
            let values: Vec<f64> = time.iter().map(|t| (10.0 * t + phase).sin()).collect();
            let exact = [0.0, 10.0, -100.0][derivative];
            let missed = |window| Local::new(&time, &values, window, degree(derivative)).at(0.0)[derivative] - exact;
            let power = (missed(0.08) / missed(0.04)).log2();
            assert!((power - f64::from(order(derivative))).abs() < 0.05, "{power}");
        }
    }

    /// To and fro by 10 mm with pauses of a length, sampled every ms for so many strokes, rounded: times and displacement,
    /// with the exact velocity and acceleration.
    fn strokes(pause: f64, count: u32, rounding: f64) -> (Vec<f64>, Vec<f64>, Vec<[f64; 2]>) {
        let period = 2.0 * (0.2 + pause);
        let samples = (f64::from(count) * period * 1e3) as u32;
        let at = |t: f64| {
            let (part, back) = (t % (0.5 * period), t % period >= 0.5 * period);
            let s = (part / 0.2).min(1.0);
            let x = 0.01 * s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
            let v = 0.05 * s * s * (30.0 - 60.0 * s + 30.0 * s * s);
            let a = 0.25 * s * (60.0 - 180.0 * s + 120.0 * s * s);
            if back { [0.01 - x, -v, -a] } else { [x, v, a] }
        };
        let time: Vec<f64> = (0..samples).map(|k| f64::from(k) * 1e-3).collect();
        let rounded = |x: f64| (x / rounding).round() * rounding;
        let (values, rates) = time.iter().map(|t| at(*t)).map(|[x, v, a]| (rounded(x), [v, a])).unzip();
        (time, values, rates)
    }

    /// Where an encoder stands still, its samples have no noise at all; windows are those of the strokes all the same, and
    /// the error is known within a factor of 2.5, by the exact velocity near rest where the motion turns.
    #[test]
    fn pauses_of_an_encoder_do_not_look_like_precision() {
        for rounding in [1e-5, 1e-6, 1e-7] {
            let [moving, resting] = [0.05, 4.0].map(|pause| {
                let (time, values, rates) = strokes(pause, 5, rounding);
                let signal = signal(&time, &values);
                let windows = signal.windows();
                let local = Local::new(&time, &values, windows[0], degree(1));
                let fastest = rates.iter().fold(0.0, |most: f64, [v, _]| most.max(v.abs()));
                let inside = time.iter().zip(&rates).skip(100).take(time.len() - 200);
                let (squares, weights) = inside.filter(|(_, [v, _])| v.abs() < SLOW * fastest).fold(
                    (0.0, 0.0),
                    |(squares, weights), (t, [v, a])| {
                        (squares + a.abs() * (local.at(*t)[1] - v).powi(2), weights + a.abs())
                    },
                );
                let ratio = signal.error(windows[0]) / f64::sqrt(squares / weights);
                assert!((0.4..1.3).contains(&ratio), "{rounding} m, {pause} s: {ratio}");
                windows
            });
            for (moving, resting) in moving.into_iter().zip(resting) {
                assert!((0.6..1.7).contains(&(resting / moving)), "{rounding} m: {moving} {resting}");
            }
        }
    }

    #[test]
    fn a_gap_does_not_change_the_windows() {
        let (time, values, _) = strokes(0.05, 20, 1e-6);
        let whole = signal(&time, &values);
        for length in [1.0, 50.0, 100.0, 1e5] {
            let apart: Vec<f64> = time.iter().map(|t| if *t > 5.0 { t + length } else { *t }).collect();
            let parted = signal(&apart, &values);
            assert_eq!(parted.windows(), whole.windows(), "{length}");
            assert!((parted.error(0.02) / whole.error(0.02) - 1.0).abs() < 0.1, "{length}");
        }
    }

    /// Against the exact acceleration where that passes through 0.
    #[test]
    fn the_error_of_the_acceleration_is_known() {
        let mut random = fastrand::Rng::with_seed(6);
        let mut spread = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        let time: Vec<f64> = (0..8000).map(|k| f64::from(k) * 1e-3).collect();
        let rate = 3.0 * TAU;
        for noise in [1e-6, 1e-7, 1e-8] {
            let values: Vec<f64> = time.iter().map(|t| 1e-3 * (rate * t).sin() + noise * spread()).collect();
            let signal = signal(&time, &values);
            let [_, window] = signal.windows();
            let local = Local::new(&time, &values, window, degree(2));
            let exact = |t: f64| -rate * rate * 1e-3 * (rate * t).sin();
            let near = time[400..7600].iter().filter(|t| (rate * **t).sin().abs() < SLOW);
            let squares: Vec<f64> = near.map(|t| (local.at(*t)[2] - exact(*t)).powi(2)).collect();
            let found = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
            let estimate = signal.noise_in(window, 2);
            assert!((0.8..1.25).contains(&(estimate / found)), "{noise} {estimate} {found}");
        }
    }

    #[test]
    fn a_motion_without_rest_has_an_error_too() {
        let time: Vec<f64> = (0..500).map(|k| f64::from(k) * 1e-3).collect();
        let values: Vec<f64> =
            time.iter().map(|t| ((0.1 * t + 0.001 * (60.0 * t).sin()) * 1e6).round() * 1e-6).collect();
        let error = signal(&time, &values).error(0.0105);
        assert!(error > 1e-5 && error < 1e-3, "{error}");
    }
}
