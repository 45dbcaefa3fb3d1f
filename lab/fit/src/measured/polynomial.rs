//! Local polynomials: value, first and second derivative of a noisy signal at any time.
//!
//! # Equation
//! Around the time t the samples within half a window are fitted by a polynomial of third degree with equal weights;
//! its coefficients at t are value, derivative and half the second derivative. On evenly spaced samples this is the
//! filter of Savitzky and Golay: it has no delay, and it is exact for polynomials up to the third degree.
//!
//! In a window with many samples their weights in the slope are p(s) = 5 s - 7 s3 over s from -1 to 1, up to a factor.
//! White noise then has slopes whose correlation at two times is
//!
//! ```text
//! r(t) = int p(s) p(s + t) ds / int p(s)2 ds = 1 - 3/2 t - 21/5 t2 + 11/2 t3 - 21/16 t5 + 21/160 t7      t <= 2
//! ```
//!
//! with the time t between them in halves of the window, and 0 from t = 2 on.
//!
//! # Source
//! A. Savitzky, M. J. E. Golay, "Smoothing and differentiation of data by simplified least squares procedures",
//! Analytical Chemistry 36 (1964), doi:10.1021/ac60214a047.

use nalgebra::{SMatrix, SVector};

/// Degree of the polynomials plus one.
const TERMS: usize = 4;

/// Correlation of the slopes of white noise at two times `apart`, s, in windows of length `window`, s.
pub fn correlation_of_slopes(apart: f64, window: f64) -> f64 {
    if window == 0.0 {
        return if apart == 0.0 { 1.0 } else { 0.0 };
    }
    let t = (2.0 * apart / window).abs();
    let square = t * t;
    let r = 1.0 - 1.5 * t + square * (-4.2 + 5.5 * t + square * t * (-21.0 / 16.0 + 21.0 / 160.0 * square));
    if t < 2.0 { r } else { 0.0 }
}

/// A sampled signal and the window in which it is fitted.
#[derive(Clone, Copy, Debug)]
pub struct Local<'a> {
    time: &'a [f64],
    values: &'a [f64],
    /// Length of the window in s.
    window: f64,
}

impl<'a> Local<'a> {
    /// A signal with ascending times.
    pub fn new(time: &'a [f64], values: &'a [f64], window: f64) -> Local<'a> {
        Local { time, values, window }
    }

    /// Value, first and second derivative at a time.
    pub fn at(&self, time: f64) -> [f64; 3] {
        let (gram, right, half) = self.equations(time);
        let [value, slope, bend, _] = gram.lu().solve(&right).map_or([f64::NAN; TERMS], |solution| solution.into());
        [value, slope / half, 2.0 * bend / (half * half)]
    }

    /// Variances of value, first and second derivative by white noise of variance 1.
    pub fn variances(&self, time: f64) -> [f64; 3] {
        let (gram, _, half) = self.equations(time);
        let factors = gram.lu();
        let of_inverse = |term: usize| {
            let unit = SVector::from_fn(|row, _| if row == term { 1.0 } else { 0.0 });
            factors.solve(&unit).map_or(f64::NAN, |column| column[term])
        };
        [of_inverse(0), of_inverse(1) / half.powi(2), 4.0 * of_inverse(2) / half.powi(4)]
    }

    /// Normal equations of the coefficients over the time in halves of the window, and that half.
    fn equations(&self, time: f64) -> (SMatrix<f64, TERMS, TERMS>, SVector<f64, TERMS>, f64) {
        let (from, to) = self.samples(time);
        let half = f64::max(0.5 * (self.time[to - 1] - self.time[from]), f64::MIN_POSITIVE);
        // Sums of the powers of the time, and of them times the values.
        let (mut sums, mut right) = ([0.0; 2 * TERMS - 1], SVector::<f64, TERMS>::zeros());
        for (t, value) in self.time[from..to].iter().zip(&self.values[from..to]) {
            let s = (t - time) / half;
            let mut power = 1.0;
            for (number, sum) in sums.iter_mut().enumerate() {
                *sum += power;
                if number < TERMS {
                    right[number] += power * value;
                }
                power *= s;
            }
        }
        (SMatrix::from_fn(|row, column| sums[row + column]), right, half)
    }

    /// The samples of the window around a time; at least one more than the polynomial has terms.
    fn samples(&self, time: f64) -> (usize, usize) {
        let first = self.time.partition_point(|t| *t < time - 0.5 * self.window);
        let past = self.time.partition_point(|t| *t <= time + 0.5 * self.window);
        let missing = (TERMS + 1).saturating_sub(past - first);
        let from = first.saturating_sub(missing.div_ceil(2));
        let to = (from + (past - first) + missing).min(self.time.len());
        (to.saturating_sub(usize::max(past - first, TERMS + 1)).min(from), to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Five samples at distance h: the weights of the value at the middle are (-3, 12, 17, 12, -3) / 35, those of the slope
    /// (1, -8, 0, 8, -1) / 12h, those of the second derivative (2, -1, -2, -1, 2) / 7h2.
    #[test]
    fn the_noise_of_derivatives_is_that_of_the_weights() {
        let time: Vec<f64> = (0..9).map(|k| f64::from(k) * 0.1).collect();
        let found = Local::new(&time, &[0.0; 9], 0.45).variances(0.4);
        for (found, expected) in found.into_iter().zip([17.0 / 35.0, 130.0 / 1.44, 14.0 / 49.0 * 1e4]) {
            assert_relative_eq!(found, expected, max_relative = 1e-9);
        }
    }

    /// Against the weights themselves: the slopes of a signal that is 0 but for one sample.
    #[test]
    fn the_correlation_of_slopes_is_that_of_the_weights() {
        let time: Vec<f64> = (0..801).map(|k| f64::from(k) * 1e-3).collect();
        let mut peak = vec![0.0; 801];
        peak[400] = 1.0;
        let local = Local::new(&time, &peak, 0.2005);
        let weights: Vec<f64> = time.iter().map(|t| local.at(*t)[1]).collect();
        let product = |lag: usize| weights.iter().zip(&weights[lag..]).map(|(a, b)| a * b).sum::<f64>();
        for lag in [0, 10, 31, 50, 77, 100, 140, 180, 205, 300] {
            let expected = product(lag) / product(0);
            let found = correlation_of_slopes(-1e-3 * lag as f64, 0.2005);
            assert!((found - expected).abs() < 0.02, "{lag}: {found} {expected}");
        }
        assert_eq!([0.0, 1e-9].map(|apart| correlation_of_slopes(apart, 0.0)), [1.0, 0.0]);
    }

    #[test]
    fn cubics_are_differentiated_exactly_also_between_uneven_samples_and_at_the_ends() {
        let time: Vec<f64> = (0..40).map(|k| f64::from(k) * 0.1 + 0.02 * f64::sin(f64::from(k))).collect();
        let cubic = |t: f64| 1.0 - 2.0 * t + 0.5 * t * t + 0.25 * t * t * t;
        let values: Vec<f64> = time.iter().map(|t| cubic(*t)).collect();
        for window in [0.0, 1.0] {
            for t in [0.0, 0.05, 1.234, 3.9] {
                let [value, slope, bend] = Local::new(&time, &values, window).at(t);
                assert_relative_eq!(value, cubic(t), max_relative = 1e-9, epsilon = 1e-9);
                assert_relative_eq!(slope, -2.0 + t + 0.75 * t * t, max_relative = 1e-8, epsilon = 1e-8);
                assert_relative_eq!(bend, 1.0 + 1.5 * t, max_relative = 1e-7, epsilon = 1e-7);
            }
        }
    }

    /// Equal weights in a window of n samples: the variance of the slope is 75 / (n^3 h^2) for large n.
    #[test]
    fn a_longer_window_reduces_the_noise_of_the_slope() {
        let mut random = fastrand::Rng::with_seed(1);
        let time: Vec<f64> = (0..20_000).map(|k| f64::from(k) * 1e-3).collect();
        let noise: Vec<f64> = time.iter().map(|_| (0..12).map(|_| random.f64()).sum::<f64>() - 6.0).collect();
        for n in [21.0, 41.0] {
            let local = Local::new(&time, &noise, (n - 0.5) * 1e-3);
            let slopes: Vec<f64> = (100..19_900).step_by(10).map(|k| local.at(time[k])[1]).collect();
            let found = slopes.iter().map(|slope| slope * slope).sum::<f64>() / slopes.len() as f64;
            let expected = 75.0 / (n * n * n * 1e-6);
            assert!((found / expected - 1.0).abs() < 0.1, "{n}: {found} instead of {expected}");
            let foreseen = local.variances(time[5000])[1];
            assert!((found / foreseen - 1.0).abs() < 0.07, "{n}: {found}, foreseen {foreseen}");
        }
    }
}
