//! Power series of a motion under linear equations.
//!
//! ```text
//! x(s t) - x_0 = c_1 s + c_2 s^2 + ...,   c_1 = t f,   c_k = t J c_(k-1) / k
//! ```

/// Largest number of terms: those beyond are below rounding.
const TERMS: usize = 28;

/// Longest time, in parts of that of the fastest motion (chosen): no term is much larger than the sum of all of them.
const LONGEST: f64 = 2.5;

/// Size of a term, in parts of the largest one, that does not count.
const LEAST: f64 = 0.25 * f64::EPSILON;

/// 1 / (k + 1)
const RECIPROCALS: [f64; TERMS] = {
    let (mut reciprocals, mut k) = ([0.0; TERMS], 0);
    while k < TERMS {
        reciprocals[k] = 1.0 / (k + 1) as f64;
        k += 1;
    }
    reciprocals
};

/// The change of the states as a polynomial in the fraction of a time.
#[derive(Clone, Copy)]
pub(super) struct Series<const N: usize> {
    /// From the first power on.
    coefficients: [[f64; N]; TERMS],
    count: usize,
}

impl<const N: usize> Series<N> {
    /// The motion over a time, from the rates at its beginning. None if the time is too long for it.
    pub fn over(time: f64, rates: &[f64; N], jacobian: &[[f64; N]; N]) -> Option<Series<N>> {
        // Column by column, so that a processor works on all rows at once.
        let columns: [[f64; N]; N] = std::array::from_fn(|j| std::array::from_fn(|i| time * jacobian[i][j]));
        if size_of_square(&columns).is_none_or(|size| size > LONGEST * LONGEST) {
            return None;
        }
        let mut series = Series { coefficients: [[0.0; N]; TERMS], count: 1 };
        let mut last = rates.map(|rate| rate * time);
        series.coefficients[0] = last;
        let (mut largest, mut ends) = (last.map(f64::abs), false);
        while series.count < TERMS {
            let mut next = [0.0; N];
            add_product(&mut next, &columns, &last);
            next.iter_mut().for_each(|value| *value *= RECIPROCALS[series.count]);
            series.coefficients[series.count] = next;
            series.count += 1;
            let mut is_small = true;
            for (value, largest) in next.iter().zip(&mut largest) {
                *largest = if value.abs() > *largest { value.abs() } else { *largest };
                is_small &= value.abs() <= LEAST * *largest;
            }
            // A state may have every other term only.
            if is_small && ends {
                return Some(series);
            }
            (last, ends) = (next, is_small);
        }
        None
    }

    /// The change at a fraction of the time.
    #[inline(always)]
    pub fn at(&self, fraction: f64) -> [f64; N] {
        let mut change = [0.0; N];
        for coefficients in self.coefficients[..self.count].iter().rev() {
            for (change, c) in change.iter_mut().zip(coefficients) {
                *change = (*change + c) * fraction;
            }
        }
        change
    }
}

/// Adds a product of a matrix, given by its columns, with a column.
#[inline(always)]
fn add_product<const N: usize>(sum: &mut [f64; N], columns: &[[f64; N]; N], x: &[f64; N]) {
    for (column, x) in columns.iter().zip(x) {
        for (sum, value) in sum.iter_mut().zip(column) {
            *sum += value * x;
        }
    }
}

/// Norm of the square of a matrix: at least the square of each eigenvalue's size, whatever the units of the states. None if
/// it is not finite.
fn size_of_square<const N: usize>(columns: &[[f64; N]; N]) -> Option<f64> {
    let mut sums = [0.0; N];
    for column in columns {
        let mut square = [0.0; N];
        add_product(&mut square, columns, column);
        sums.iter_mut().zip(square).for_each(|(sum, value)| *sum += value.abs());
    }
    let norm = sums.into_iter().fold(0.0, f64::max);
    sums.iter().all(|sum| sum.is_finite()).then_some(norm)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An oscillation in units that differ by a factor of a million, up to the longest time; a state that drifts beside it,
    /// and one at rest.
    #[test]
    fn terms_add_up_to_a_cosine() {
        let (w, unit) = (300.0, 1e6);
        let jacobian =
            [[0.0, unit, 0.0, 0.0], [-w * w / unit, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]];
        let rates = [0.0, -w * w / unit, 7.0, 0.0];
        for time in [1e-9, 1e-4, 1e-3, 2.4 / w] {
            let series = Series::over(time, &rates, &jacobian).unwrap();
            for fraction in [0.0, 1e-6, 0.25, 0.6, 1.0] {
                let t: f64 = fraction * time;
                // cos - 1, without cancellation.
                let expected = [-2.0 * (0.5 * w * t).sin().powi(2), -w * (w * t).sin() / unit, 7.0 * t, 0.0];
                for (found, expected) in series.at(fraction).into_iter().zip(expected) {
                    assert!(
                        (found - expected).abs() <= 4e-15 * expected.abs(),
                        "{time} {fraction}: {found} {expected}"
                    );
                }
            }
        }
        assert!(Series::over(2.6 / w, &rates, &jacobian).is_none());
    }

    /// exp(-r t) - 1, and numbers that are too large to be squared.
    #[test]
    fn terms_add_up_to_a_decay() {
        for [rate, time] in [[3.0, 0.8], [1e5, 2.4e-5], [1e-200, 1.0]] {
            let change = Series::over(time, &[-rate], &[[-rate]]).unwrap().at(1.0)[0];
            let expected = (-rate * time).exp_m1();
            assert!((change - expected).abs() <= 5e-15 * expected.abs(), "{rate}: {change} {expected}");
        }
        assert!(Series::over(1.0, &[1.0], &[[1e200]]).is_none());
    }
}
