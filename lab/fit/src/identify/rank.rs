//! Ranking of laws by what they explain and what they cost.
//!
//! # Equation
//! ```text
//! BIC = (n / tau) ln(r'r / n) + k ln(n / tau)
//! ```
//! with r'r twice the loss if that is robust, and the correlation time tau of the residuals of the law that explains
//! most: samples of a rig are not independent, and who counts them as if they were prefers the law with more parameters.
//! Laws within [`APART`] of the best one cannot be told apart.
//!
//! # Source
//! G. Schwarz, "Estimating the dimension of a model", Annals of Statistics 6 (1978), doi:10.1214/aos/1176344136. Limit:
//! R. E. Kass, A. E. Raftery, "Bayes factors", Journal of the American Statistical Association 90 (1995),
//! doi:10.1080/01621459.1995.10476572, "very strong".

use stribeck::number::Real;

use super::Fit;

/// Difference of the criterion below which two laws cannot be told apart.
pub const APART: f64 = 10.0;

/// Place of a law in a ranking.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rank {
    /// Number of the fit in the list.
    pub fit: usize,
    /// Criterion above that of the best law.
    pub delta_bic: f64,
    /// Whether it cannot be told apart from the best one, which is tied with itself.
    pub is_tied: bool,
}

/// Ranks fits to the same experiments, the best first.
pub fn rank(fits: &[Fit]) -> Vec<Rank> {
    let least = fits.iter().min_by(|a, b| a.residuals.loss.total_cmp(&b.residuals.loss));
    let Some(least) = least else { return Vec::new() };
    let count = least.samples as f64 / least.residuals.correlation;
    // A law that explains everything leaves rounding.
    let floor = 1e-12 * least.level;
    let criterion = |fit: &Fit| {
        let n = fit.samples as f64;
        let freedom = (n - fit.parameters() as f64).max(1.0);
        let mean = fit.residuals.loss.max(floor).powi(2) * freedom / n;
        count * Real::ln(mean) + fit.parameters() as f64 * Real::ln(count)
    };
    let mut list: Vec<(usize, f64)> = fits.iter().map(criterion).enumerate().collect();
    list.sort_by(|a, b| a.1.total_cmp(&b.1));
    let best = list.first().map_or(0.0, |(_, criterion)| *criterion);
    let place = |(fit, criterion): (usize, f64)| {
        let delta_bic = criterion - best;
        Rank { fit, delta_bic, is_tied: delta_bic < APART }
    };
    list.into_iter().map(place).collect()
}
