//! Windows of the filter of the motion: a longer one lets less noise pass, and swallows more of the motion.
//!
//! # Equation
//! A derivative in a window of length w has the variance s2 g_w by white noise of variance s2 in the samples, and misses
//! b_w of the motion. Least squares over more samples are not correlated with what fewer of them add, so that with the
//! next shorter window u
//!
//! ```text
//! mean (d_w - d_u)2 = s2 (g_u - g_w) + mean (b_w - b_u)2
//! b_u = b_w (u/w)^p                                      p = 4 for the first derivative of a cubic, 2 for the second
//! ```
//!
//! s2 follows from the residuals in the shortest window. Velocity and acceleration have a window each, with the least
//! s2 g + [`MISSED`] b2.
//!
//! # Source
//! Order of what is missed: R. W. Schafer, "What is a Savitzky-Golay filter?", IEEE Signal Processing Magazine 28 (2011),
//! doi:10.1109/MSP.2011.941097.

use super::polynomial::Local;

/// Samples in the windows that are tried (chosen).
pub(super) const WINDOWS: [f64; 11] = [5.0, 7.0, 9.0, 11.0, 15.0, 21.0, 31.0, 45.0, 65.0, 91.0, 131.0];

/// How much more the square of what is missed counts than that of noise (chosen): it is the same in all reversals, so
/// that parameters of a law take it over, while noise averages out.
const MISSED: f64 = 10.0;

/// Factor above the least cost from which longer windows are not looked at (chosen).
const RISEN: f64 = 5.0;

/// Most samples at which windows are compared, and longest window as a part of the record (chosen).
const PLACES: usize = 4000;
const LONGEST: f64 = 0.1;

/// Length of a window of so many samples.
pub(super) fn length(samples: f64, interval: f64) -> f64 {
    (samples - 0.5) * interval
}

/// Length of the window for the first and for the second derivative of samples at a median interval.
pub(super) fn windows(time: &[f64], values: &[f64], interval: f64) -> [f64; 2] {
    let [first, last] = [time[0], time[time.len() - 1]];
    let longest = f64::max(LONGEST * (last - first), length(WINDOWS[1], interval));
    let lengths = WINDOWS.map(|samples| length(samples, interval)).into_iter().filter(|one| *one <= longest);
    let lengths: Vec<f64> = lengths.collect();
    let margin = 0.5 * lengths[lengths.len() - 1];
    let inside = (0..time.len()).filter(|at| (first + margin..=last - margin).contains(&time[*at])).collect();
    let places = some(inside);
    let tried: Vec<Tried> = lengths.iter().map(|length| Tried::new(time, values, &places, *length)).collect();
    let noise = tried[0].noise(values, &places);
    [1, 2].map(|derivative| {
        let missed = |pair: &[Tried]| pair[1].missed(&pair[0], derivative, noise);
        let pairs: Vec<[f64; 2]> = tried.windows(2).map(missed).collect();
        let missed = pairs.iter().take(1).map(|[shorter, _]| shorter).chain(pairs.iter().map(|[_, longer]| longer));
        let costs = tried.iter().zip(missed).map(|(one, missed)| noise * one.gains[derivative] + MISSED * missed);
        least(&lengths, costs)
    })
}

/// The window of least cost, among those before the cost rises: windows that miss nearly all miss it alike.
fn least(lengths: &[f64], costs: impl Iterator<Item = f64>) -> f64 {
    let mut best = (lengths[0], f64::INFINITY);
    for (length, cost) in lengths.iter().zip(costs) {
        if cost > RISEN * best.1 {
            break;
        }
        if cost < best.1 {
            best = (*length, cost);
        }
    }
    best.0
}

/// Error of the first derivative in a window at samples: root mean square of noise and of what is missed.
pub(super) fn error(time: &[f64], values: &[f64], interval: f64, places: Vec<usize>, window: f64) -> f64 {
    let places = some(places);
    let shortest = length(WINDOWS[0], interval);
    // The shortest window has no shorter one beside it, but a longer one.
    let lengths = if window > 1.4 * shortest { [0.7 * window, window] } else { [window, 1.4 * shortest] };
    let [shorter, longer] = lengths.map(|length| Tried::new(time, values, &places, length));
    let noise = Tried::new(time, values, &places, shortest).noise(values, &places);
    let missed = longer.missed(&shorter, 1, noise);
    let taken = usize::from(longer.length == window);
    (noise * [shorter, longer][taken].gains[1] + missed[taken]).sqrt()
}

/// At most [`PLACES`] of the samples, evenly.
fn some(all: Vec<usize>) -> Vec<usize> {
    let step = all.len().div_ceil(PLACES).max(1);
    all.into_iter().step_by(step).collect()
}

/// Power of the window with which it misses value, first and second derivative.
const ORDERS: [i32; 3] = [4, 4, 2];

/// A window at all places.
struct Tried {
    length: f64,
    /// Value, first and second derivative.
    found: Vec<[f64; 3]>,
    /// Mean of their variances by noise of variance 1.
    gains: [f64; 3],
}

impl Tried {
    fn new(time: &[f64], values: &[f64], places: &[usize], length: f64) -> Tried {
        let local = Local::new(time, values, length);
        let found = places.iter().map(|at| local.at(time[*at])).collect();
        let sums = places.iter().fold([0.0; 3], |sums, at| {
            let one = local.variances(time[*at]);
            [0, 1, 2].map(|number| sums[number] + one[number])
        });
        Tried { length, found, gains: sums.map(|sum| sum / places.len() as f64) }
    }

    /// Mean square of what is missed of a derivative in a shorter window and in this one, with noise of this variance.
    fn missed(&self, shorter: &Tried, derivative: usize, noise: f64) -> [f64; 2] {
        let pairs = self.found.iter().zip(&shorter.found);
        let squares = pairs.map(|(one, other)| (one[derivative] - other[derivative]).powi(2));
        let change = squares.sum::<f64>() / self.found.len() as f64;
        let beyond_noise = change - noise * (shorter.gains[derivative] - self.gains[derivative]);
        let ratio = (shorter.length / self.length).powi(ORDERS[derivative]);
        let missed = beyond_noise.max(0.0) / (1.0 - ratio).powi(2);
        [missed * ratio * ratio, missed]
    }

    /// Variance of the noise of the samples.
    fn noise(&self, values: &[f64], places: &[usize]) -> f64 {
        let squares = places.iter().zip(&self.found).map(|(at, [value, ..])| (values[*at] - value).powi(2));
        squares.sum::<f64>() / places.len() as f64 / (1.0 - self.gains[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A sine with noise, whose derivatives are known: the windows that are taken are about as good as any, down to some
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
            let found = windows(&time, &values, 1e-3);
            for derivative in [1, 2] {
                // What is missed, of the sine without noise, and the noise alone.
                let cost = |window: f64| {
                    let [noisy, smooth] = [&values, &exact].map(|values| Local::new(&time, values, window));
                    let truth = |t: f64| [0.0, rate * 1e-3 * (rate * t).cos(), -rate * rate * clean(t)][derivative];
                    (100..5900).step_by(7).map(|at| time[at]).fold(0.0, |sum, t| {
                        let [noisy, smooth] = [&noisy, &smooth].map(|local| local.at(t)[derivative]);
                        let size = 1e-3 * rate.powi(derivative as i32);
                        sum + (noisy - smooth).powi(2) + MISSED * (smooth - truth(t)).powi(2) + (3e-5 * size).powi(2)
                    })
                };
                let least =
                    WINDOWS.map(|samples| cost(length(samples, 1e-3))).into_iter().fold(f64::INFINITY, f64::min);
                let taken = cost(found[derivative - 1]);
                assert!(taken <= 1.5 * least, "{frequency} Hz, {noise} m: {taken} instead of {least}, {found:?}");
            }
        }
    }
}
