//! Robust least squares and monotone regression.

use nalgebra::{DMatrix, DVector};

use super::Estimate;
use stribeck_measured::median;

/// Coefficients of the columns with their standard deviations, by least squares with Tukey's bisquare weights. None if
/// there are no more rows than columns, or if the columns are not independent.
pub fn regress<const COLUMNS: usize>(rows: &[[f64; COLUMNS]], values: &[f64]) -> Option<[Estimate; COLUMNS]> {
    // Tukey's constant: 95 % efficiency on normal noise. 0.6745 makes the median deviation one standard deviation.
    const CUTOFF: f64 = 4.685;
    const ROUNDS: usize = 50;
    if rows.len() <= COLUMNS {
        return None;
    }
    let design = DMatrix::from_fn(rows.len(), COLUMNS, |row, column| rows[row][column]);
    let values = DVector::from_column_slice(values);
    let mut weights = DVector::from_element(rows.len(), 1.0);
    let mut coefficients = solve(&design, &values, &weights)?;
    for _ in 0..ROUNDS {
        let residuals = &values - &design * &coefficients;
        let scale = median(residuals.abs().as_mut_slice()) / 0.6745;
        if scale <= 1e-12 * values.amax() {
            break; // the majority is fitted exactly
        }
        weights = residuals.map(|residual| (1.0 - (residual / (CUTOFF * scale)).powi(2)).max(0.0).powi(2));
        let Some(next) = solve(&design, &values, &weights) else { break };
        let change = (&next - &coefficients).amax();
        coefficients = next;
        if change <= 1e-9 * coefficients.amax() {
            break;
        }
    }
    let deviations = deviations(&design, &values, &weights, &coefficients)?;
    Some(std::array::from_fn(|column| Estimate { value: coefficients[column], deviation: deviations[column] }))
}

/// Weighted least squares; None if the columns are not independent.
fn solve(design: &DMatrix<f64>, values: &DVector<f64>, weights: &DVector<f64>) -> Option<DVector<f64>> {
    let roots = weights.map(f64::sqrt);
    let svd = scaled_rows(design, &roots).svd(true, true);
    let singular = &svd.singular_values;
    if singular.min() <= 1e-9 * singular.max() {
        return None;
    }
    svd.solve(&roots.component_mul(values), 0.0).ok()
}

/// Standard deviations of the coefficients, from the weighted residuals.
fn deviations(
    design: &DMatrix<f64>,
    values: &DVector<f64>,
    weights: &DVector<f64>,
    coefficients: &DVector<f64>,
) -> Option<DVector<f64>> {
    let residuals = values - design * coefficients;
    let squares: f64 = residuals.iter().zip(weights).map(|(residual, weight)| weight * residual * residual).sum();
    let freedom = weights.sum() - design.ncols() as f64;
    let inverse = design.tr_mul(&scaled_rows(design, weights)).try_inverse()?;
    let variance = if freedom > 0.0 { squares / freedom } else { 0.0 };
    Some(inverse.diagonal().map(|entry| (entry * variance).max(0.0).sqrt()))
}

/// A matrix with each row multiplied by a factor.
fn scaled_rows(matrix: &DMatrix<f64>, factors: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| matrix[(row, column)] * factors[row])
}

/// Value of a polynomial through the samples at one abscissa: of degree 2, or 1 if they are few. None if they are too
/// few.
pub fn local(samples: &[(f64, f64)], at: f64) -> Option<Estimate> {
    const MANY: usize = 6; // chosen: twice the coefficients of degree 2
    let reach = samples.iter().map(|sample| (sample.0 - at).abs()).fold(0.0, f64::max);
    let scaled = samples.iter().map(|sample| (sample.0 - at) / reach);
    let values: Vec<f64> = samples.iter().map(|sample| sample.1).collect();
    if samples.len() < MANY {
        regress(&scaled.map(|u| [1.0, u]).collect::<Vec<_>>(), &values).map(|estimates| estimates[0])
    } else {
        regress(&scaled.map(|u| [1.0, u, u * u]).collect::<Vec<_>>(), &values).map(|estimates| estimates[0])
    }
}

/// The non-decreasing values >= 0 nearest to the given ones in the sense of least squares: neighbours that fall are
/// pooled (Ayer and others, "An empirical distribution function for sampling with incomplete information", Ann. Math.
/// Statist. 26, 1955).
pub fn isotonic(values: &[f64]) -> Vec<f64> {
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for value in values {
        let mut pool = (*value, 1);
        while let Some(last) = pools.last().copied().filter(|last| last.0 > pool.0) {
            pools.pop();
            let count = last.1 + pool.1;
            pool = ((last.0 * last.1 as f64 + pool.0 * pool.1 as f64) / count as f64, count);
        }
        pools.push(pool);
    }
    pools.into_iter().flat_map(|(value, count)| vec![value.max(0.0); count]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{abs_diff_eq, assert_abs_diff_eq};

    #[test]
    fn outliers_do_not_move_a_line() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut samples: Vec<(f64, f64)> = (0..200).map(|i| f64::from(i) * 0.01).map(|v| (v, 3.0 + 2.0 * v)).collect();
        for sample in &mut samples {
            sample.1 += 0.2 * (random.f64() - 0.5);
        }
        for sample in samples.iter_mut().step_by(10) {
            sample.1 += 50.0;
        }
        let rows: Vec<[f64; 2]> = samples.iter().map(|sample| [1.0, sample.0]).collect();
        let values: Vec<f64> = samples.iter().map(|sample| sample.1).collect();
        let [intercept, slope] = regress(&rows, &values).unwrap();
        assert!(abs_diff_eq!(intercept.value, 3.0, epsilon = 0.03), "{intercept:?}");
        assert!(abs_diff_eq!(slope.value, 2.0, epsilon = 0.03), "{slope:?}");
    }

    /// The standard deviation must be the spread of the estimate over many repetitions.
    #[test]
    fn standard_deviations_are_those_of_repetitions() {
        let mut random = fastrand::Rng::with_seed(11);
        let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        let rows: Vec<[f64; 2]> = (0..60).map(|i| [1.0, f64::from(i) / 60.0]).collect();
        let mut runs = Vec::new();
        for _ in 0..400 {
            let values: Vec<f64> = rows.iter().map(|row| 7.0 - row[1] + 0.5 * normal()).collect();
            runs.push(regress(&rows, &values).unwrap()[0]);
        }
        let count = runs.len() as f64;
        let mean = runs.iter().map(|run| run.value).sum::<f64>() / count;
        let spread = (runs.iter().map(|run| (run.value - mean).powi(2)).sum::<f64>() / count).sqrt();
        let claimed = runs.iter().map(|run| run.deviation).sum::<f64>() / count;
        assert_abs_diff_eq!(mean, 7.0, epsilon = 3.0 * spread / count.sqrt());
        assert!(abs_diff_eq!(claimed / spread, 1.0, epsilon = 0.2), "{claimed} {spread}");
    }

    #[test]
    fn exact_data_are_fitted_exactly_and_dependent_columns_rejected() {
        let parabola: Vec<(f64, f64)> =
            (1..20).map(|i| f64::from(i) * 0.1).map(|v| (v, 1.0 - v + 4.0 * v * v)).collect();
        let estimate = local(&parabola, 0.0).unwrap();
        assert!((estimate.value - 1.0).abs() < 1e-12 && estimate.deviation < 1e-9, "{estimate:?}");
        assert!(regress(&[[1.0, 2.0]; 9], &[1.0; 9]).is_none());
        assert!(local(&[(1.0, 2.0), (2.0, 3.0)], 0.0).is_none(), "two samples give no deviation");
        assert!(local(&[], 0.0).is_none());
    }

    /// Kuhn-Tucker: pools are means, and no monotone sequence of a fine grid is nearer.
    #[test]
    fn monotone_regression_pools_neighbours_that_fall() {
        assert_eq!(isotonic(&[1.0, 2.0, 5.0]), [1.0, 2.0, 5.0]);
        assert_eq!(isotonic(&[1.0, 4.0, 2.0, 5.0]), [1.0, 3.0, 3.0, 5.0]);
        assert_eq!(isotonic(&[3.0, 2.0, 1.0]), [2.0; 3]);
        assert_eq!(isotonic(&[-1.0, 2.0]), [0.0, 2.0]);
        assert!(isotonic(&[]).is_empty());
        let values = [1.5, 0.5, 2.0, -0.5];
        let distance = |fit: &[f64]| fit.iter().zip(values).map(|(fit, value)| (fit - value).powi(2)).sum::<f64>();
        let best = distance(&isotonic(&values));
        let grid: Vec<f64> = (0..=20).map(|i| f64::from(i) * 0.1).collect();
        for a in &grid {
            for b in grid.iter().filter(|b| *b >= a) {
                for c in grid.iter().filter(|c| *c >= b) {
                    for d in grid.iter().filter(|d| *d >= c) {
                        assert!(distance(&[*a, *b, *c, *d]) >= best - 1e-12);
                    }
                }
            }
        }
    }
}
