//! Whether a law explains a map.
//!
//! # Equations
//! With the weighted residuals r of n rows in m settings, their means over each setting, and k parameters:
//!
//! ```text
//! F = (sum of n_i mean_i2 / (m - k)) / (sum of (r - mean_i)2 / (n - m))
//! z = ((1 - 2/(9 (n - m))) F^(1/3) - (1 - 2/(9 (m - k)))) / sqrt(2/(9 (m - k)) + F^(2/3) 2/(9 (n - m)))
//! ```
//!
//! If the law explains the map, z is nearly normal.
//!
//! # Source
//! F: N. R. Draper, H. Smith, Applied Regression Analysis (1998), doi:10.1002/9781118625590, section 2.1. z:
//! E. Paulson, "An approximate normalization of the analysis of variance distribution", Annals of Mathematical
//! Statistics 13 (1942), doi:10.1214/aoms/1177731608.

use serde::Serialize;
use stribeck::number::Real;
use ts_rs::TS;

use super::super::problem::Problem;
use super::few::by_velocity;
use super::scatter::RARE;

/// Misfit of a law, compared with the scatter of the repeats.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, TS)]
pub struct LackOfFit {
    /// Ratio of the variance of the means to that of the repeats.
    pub ratio: f64,
    /// Degrees of freedom of both.
    pub freedom: [usize; 2],
    /// Whether the scatter explains it.
    pub explained: bool,
}

impl LackOfFit {
    /// A line on it.
    pub fn text(&self) -> String {
        let [means, repeats] = self.freedom;
        let text = format!("misfit over the scatter of the repeats: F = {:.2} ({means}, {repeats})", self.ratio);
        let verdict = if self.explained { "explains" } else { "does not explain" };
        format!("{text}: the law {verdict} the map within the scatter")
    }

    fn of(means: f64, repeats: f64, freedom: [usize; 2]) -> LackOfFit {
        let [a, b] = freedom.map(|count| 2.0 / (9.0 * count as f64));
        let ratio = (means / freedom[0] as f64) / (repeats / freedom[1] as f64);
        let root = Real::exp(Real::ln(ratio.max(f64::MIN_POSITIVE)) / 3.0);
        let normal = ((1.0 - b) * root - (1.0 - a)) / (a + root * root * b).sqrt();
        LackOfFit { ratio, freedom, explained: normal <= RARE }
    }
}

/// Degrees of freedom of the repeats from which a law is judged by them (chosen: z is nearly normal).
const LEAST: usize = 3;

/// Sum and number of the residuals of each setting, and of the squares of all of them.
fn sums(problem: &Problem, left: &[f64]) -> Vec<[f64; 3]> {
    let mut found = Vec::new();
    let mut left = left.iter();
    for one in problem.experiments {
        let Some(rows) = &one.map else { continue };
        let count = rows.settings.iter().max().map_or(0, |most| most + 1);
        let mut sums = vec![[0.0; 3]; count];
        for (at, residual) in (0..one.time.len()).filter(|at| one.counts(*at)).zip(left.by_ref()) {
            let sum = &mut sums[rows.settings[at]];
            *sum = [sum[0] + residual, sum[1] + 1.0, sum[2] + residual * residual];
        }
        found.extend(sums.into_iter().filter(|sum| sum[1] > 0.0));
    }
    found
}

/// The misfit of weighted residuals; None for records, and without enough repeats or speeds.
pub(in crate::identify) fn lack_of_fit(problem: &Problem, left: &[f64]) -> Option<LackOfFit> {
    let scatter = problem.experiments.first()?.map.as_ref()?.scatter;
    let settings = sums(problem, left);
    let (count, unknown) = (settings.len(), problem.parameters.len());
    let freedom = [count.checked_sub(unknown)?, left.len() - count];
    if freedom[0] == 0 || freedom[1] < LEAST || scatter == 0.0 {
        return None;
    }
    let means: f64 = settings.iter().map(|[sum, count, _]| sum * sum / count).sum();
    let repeats: f64 = settings.iter().map(|[sum, count, square]| square - sum * sum / count).sum();
    Some(LackOfFit::of(means, repeats.max(f64::MIN_POSITIVE), freedom))
}

/// Standard deviations by which the pairs of the same sign exceed those of scatter where a law does not explain a map
/// (chosen: in one of 50 maps by chance).
const OFTEN: f64 = 2.0;

/// Pairs of neighbours in the order of speed whose residuals have the same sign, and all pairs.
fn runs(sorted: &[f64]) -> [usize; 2] {
    let same = sorted.windows(2).filter(|pair| pair[0] * pair[1] > 0.0).count();
    [same, sorted.len().saturating_sub(1)]
}

/// Warning that the law does not explain the map. Without repeats the signs of the residuals judge it: those of scatter
/// change between neighbours as often as they stay.
pub(in crate::identify) fn warnings(problem: &Problem, left: &[f64]) -> Option<String> {
    if let Some(found) = lack_of_fit(problem, left) {
        let after = "; the intervals may not hold";
        return (!found.explained).then(|| found.text() + after);
    }
    let [same, pairs] = runs(&by_velocity(&problem.velocities(), left));
    let normal = (2.0 * same as f64 - pairs as f64) / (pairs.max(1) as f64).sqrt();
    (normal > OFTEN).then(|| {
        format!(
            "the law does not explain the map: in the order of speed, {same} of {pairs} residuals have the sign of \
             the one before, so that they are not scatter, and the intervals may not hold; if the directions differ, \
             fit the offset too"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables of F at 1 %.
    #[test]
    fn limits_are_those_of_tables() {
        for (freedom, limit) in [([5, 10], 5.636), ([10, 20], 3.368), ([24, 60], 2.12), ([4, 30], 4.018)] {
            let judged = |ratio: f64| {
                let [a, b] = freedom.map(|count| count as f64);
                LackOfFit::of(ratio * a, b, freedom).explained
            };
            assert!(judged(0.98 * limit) && !judged(1.02 * limit), "{freedom:?}");
        }
    }
}
