//! Local polynomials: value, first and second derivative of a noisy signal at any time.
//!
//! # Equation
//! Around the time t the samples within half a window are fitted by a polynomial with equal weights, of third or of fifth
//! degree; its coefficients at t are value, derivative and half the second derivative. On evenly spaced samples this is the
//! filter of Savitzky and Golay: it has no delay, and it is exact for polynomials up to its degree.
//!
//! Of a sine of angular frequency w the slope in a window of length 2 h loses the part 0.00198 (w h)4 with the third degree
//! and 1.62e-5 (w h)6 with the fifth; noise is the same in a window 1.45 times as long with the fifth.
//!
//! In a window with many samples their weights in the slope of fifth degree are p(s) = 35 s - 126 s3 + 99 s5 over s from
//! -1 to 1, up to a factor. White noise then has slopes whose correlation at two times is
//!
//! ```text
//! r(t) = int p(s) p(s + t) ds / int p(s)2 ds
//!      = 1 - 3/2 t - 54/5 t2 + 55/4 t3 + 99/7 t4 - 351/16 t5 + 261/40 t7 - 297/256 t9 + 297/3584 t11         t <= 2
//! ```
//!
//! with the time t between them in halves of the window, and 0 from t = 2 on.
//!
//! # Source
//! A. Savitzky, M. J. E. Golay, "Smoothing and differentiation of data by simplified least squares procedures",
//! Analytical Chemistry 36 (1964), doi:10.1021/ac60214a047.

use nalgebra::{Const, DimMin, SMatrix, SVector};

/// Degree of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Degree {
    Third,
    Fifth,
}

/// Terms of polynomials of third and of fifth degree.
const CUBIC: usize = 4;
const QUINTIC: usize = 6;

/// Coefficients of the correlation of slopes of fifth degree, by powers.
const CORRELATION: [f64; 12] = [
    1.0,
    -1.5,
    -54.0 / 5.0,
    55.0 / 4.0,
    99.0 / 7.0,
    -351.0 / 16.0,
    0.0,
    261.0 / 40.0,
    0.0,
    -297.0 / 256.0,
    0.0,
    297.0 / 3584.0,
];

/// Correlation of the slopes of fifth degree of white noise at two times `apart`, s, in windows of length `window`, s.
pub fn correlation_of_slopes(apart: f64, window: f64) -> f64 {
    if window == 0.0 {
        return if apart == 0.0 { 1.0 } else { 0.0 };
    }
    let t = (2.0 * apart / window).abs();
    if t < 2.0 { CORRELATION.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient) } else { 0.0 }
}

/// A sampled signal and the window in which it is fitted.
#[derive(Clone, Copy, Debug)]
pub struct Local<'a> {
    time: &'a [f64],
    values: &'a [f64],
    /// Length of the window in s.
    window: f64,
    degree: Degree,
}

impl<'a> Local<'a> {
    /// A signal with ascending times.
    pub fn new(time: &'a [f64], values: &'a [f64], window: f64, degree: Degree) -> Local<'a> {
        Local { time, values, window, degree }
    }

    /// Value, first and second derivative at a time.
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self.degree {
            Degree::Third => self.fit::<CUBIC>(time),
            Degree::Fifth => self.fit::<QUINTIC>(time),
        }
    }

    /// Variances of value, first and second derivative by white noise of variance 1.
    pub fn variances(&self, time: f64) -> [f64; 3] {
        match self.degree {
            Degree::Third => self.spread::<CUBIC>(time),
            Degree::Fifth => self.spread::<QUINTIC>(time),
        }
    }

    fn fit<const TERMS: usize>(&self, time: f64) -> [f64; 3]
    where
        Const<TERMS>: DimMin<Const<TERMS>, Output = Const<TERMS>>,
    {
        let (gram, right, half) = self.equations::<TERMS>(time);
        let found = gram.lu().solve(&right).unwrap_or(SVector::repeat(f64::NAN));
        [found[0], found[1] / half, 2.0 * found[2] / (half * half)]
    }

    fn spread<const TERMS: usize>(&self, time: f64) -> [f64; 3]
    where
        Const<TERMS>: DimMin<Const<TERMS>, Output = Const<TERMS>>,
    {
        let (gram, _, half) = self.equations::<TERMS>(time);
        let factors = gram.lu();
        let of_inverse = |term: usize| {
            let unit = SVector::from_fn(|row, _| if row == term { 1.0 } else { 0.0 });
            factors.solve(&unit).map_or(f64::NAN, |column| column[term])
        };
        [of_inverse(0), of_inverse(1) / half.powi(2), 4.0 * of_inverse(2) / half.powi(4)]
    }

    /// Normal equations of the coefficients over the time in halves of the window, and that half.
    fn equations<const TERMS: usize>(&self, time: f64) -> (SMatrix<f64, TERMS, TERMS>, SVector<f64, TERMS>, f64) {
        let (from, to) = self.samples(time, TERMS + 1);
        let half = f64::max(0.5 * (self.time[to - 1] - self.time[from]), f64::MIN_POSITIVE);
        // Sums of the powers of the time, and of them times the values.
        let (mut sums, mut right) = ([0.0; 2 * QUINTIC - 1], SVector::<f64, TERMS>::zeros());
        for (t, value) in self.time[from..to].iter().zip(&self.values[from..to]) {
            let s = (t - time) / half;
            let mut power = 1.0;
            for (number, sum) in sums[..2 * TERMS - 1].iter_mut().enumerate() {
                *sum += power;
                if number < TERMS {
                    right[number] += power * value;
                }
                power *= s;
            }
        }
        (SMatrix::from_fn(|row, column| sums[row + column]), right, half)
    }

    /// The samples of the window around a time; at least so many.
    fn samples(&self, time: f64, least: usize) -> (usize, usize) {
        let first = self.time.partition_point(|t| *t < time - 0.5 * self.window);
        let past = self.time.partition_point(|t| *t <= time + 0.5 * self.window);
        let missing = least.saturating_sub(past - first);
        let from = first.saturating_sub(missing.div_ceil(2));
        let to = (from + (past - first) + missing).min(self.time.len());
        (to.saturating_sub(usize::max(past - first, least)).min(from), to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Five samples at distance h: the weights of the value at the middle are (-3, 12, 17, 12, -3) / 35, those of the slope
    /// (1, -8, 0, 8, -1) / 12h, those of the second derivative (2, -1, -2, -1, 2) / 7h2. Seven samples and the fifth degree:
    /// those of the slope are (-1, 9, -45, 0, 45, -9, 1) / 60h.
    #[test]
    fn the_noise_of_derivatives_is_that_of_the_weights() {
        let time: Vec<f64> = (0..9).map(|k| f64::from(k) * 0.1).collect();
        let found = Local::new(&time, &[0.0; 9], 0.45, Degree::Third).variances(0.4);
        for (found, expected) in found.into_iter().zip([17.0 / 35.0, 130.0 / 1.44, 14.0 / 49.0 * 1e4]) {
            assert_relative_eq!(found, expected, max_relative = 1e-9);
        }
        let slope = Local::new(&time, &[0.0; 9], 0.65, Degree::Fifth).variances(0.4)[1];
        assert_relative_eq!(slope, 4214.0 / 36.0, max_relative = 1e-9);
    }

    /// Against the weights themselves: the slopes of a signal that is 0 but for one sample.
    #[test]
    fn the_correlation_of_slopes_is_that_of_the_weights() {
        let time: Vec<f64> = (0..801).map(|k| f64::from(k) * 1e-3).collect();
        let mut peak = vec![0.0; 801];
        peak[400] = 1.0;
        let local = Local::new(&time, &peak, 0.2005, Degree::Fifth);
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
    fn polynomials_are_differentiated_exactly_also_between_uneven_samples_and_at_the_ends() {
        let time: Vec<f64> = (0..40).map(|k| f64::from(k) * 0.1 + 0.02 * f64::sin(f64::from(k))).collect();
        for (degree, fifth) in [(Degree::Third, 0.0), (Degree::Fifth, 0.1)] {
            let exact = |t: f64| {
                let value = 1.0 - 2.0 * t + 0.5 * t * t + 0.25 * t.powi(3) + fifth * t.powi(5);
                let slope = -2.0 + t + 0.75 * t * t + 5.0 * fifth * t.powi(4);
                [value, slope, 1.0 + 1.5 * t + 20.0 * fifth * t.powi(3)]
            };
            let values: Vec<f64> = time.iter().map(|t| exact(*t)[0]).collect();
            for window in [0.0, 1.0] {
                for t in [0.0, 0.05, 1.234, 3.9] {
                    let found = Local::new(&time, &values, window, degree).at(t);
                    for ((found, exact), tolerance) in found.into_iter().zip(exact(t)).zip([1e-9, 1e-8, 1e-7]) {
                        assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = tolerance);
                    }
                }
            }
        }
    }

    /// Of a sine of angular frequency w, in windows of half length h with many samples.
    #[test]
    fn slopes_of_a_sine_lose_what_their_degree_does_not_follow() {
        let time: Vec<f64> = (0..4001).map(|k| f64::from(k - 2000) * 1e-4).collect();
        let sine: Vec<f64> = time.iter().map(|t| (10.0 * t).sin()).collect();
        for (degree, lost, power) in [(Degree::Third, 0.00198, 4), (Degree::Fifth, 1.62e-5, 6)] {
            for half in [0.02, 0.05] {
                let found = 1.0 - Local::new(&time, &sine, 2.0 * half, degree).at(0.0)[1] / 10.0;
                assert_relative_eq!(found, lost * (10.0 * half).powi(power), max_relative = 0.03);
            }
        }
    }

    /// Equal weights in a window of n samples: the variance of the slope is 75 / (n^3 h^2) for large n with the third degree,
    /// and 3675 / 16 / (n^3 h^2) with the fifth.
    #[test]
    fn a_longer_window_reduces_the_noise_of_the_slope() {
        let mut random = fastrand::Rng::with_seed(1);
        let time: Vec<f64> = (0..20_000).map(|k| f64::from(k) * 1e-3).collect();
        let noise: Vec<f64> = time.iter().map(|_| (0..12).map(|_| random.f64()).sum::<f64>() - 6.0).collect();
        for (n, degree, factor) in
            [(21.0, Degree::Third, 75.0), (41.0, Degree::Third, 75.0), (61.0, Degree::Fifth, 3675.0 / 16.0)]
        {
            let local = Local::new(&time, &noise, (n - 0.5) * 1e-3, degree);
            let slopes: Vec<f64> = (100..19_900).step_by(10).map(|k| local.at(time[k])[1]).collect();
            let found = slopes.iter().map(|slope| slope * slope).sum::<f64>() / slopes.len() as f64;
            let expected = factor / (n * n * n * 1e-6);
            assert!((found / expected - 1.0).abs() < 0.1, "{n}: {found} instead of {expected}");
            let foreseen = local.variances(time[5000])[1];
            assert!((found / foreseen - 1.0).abs() < 0.07, "{n}: {found}, foreseen {foreseen}");
        }
    }
}
