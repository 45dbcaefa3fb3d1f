//! Cost of a residual: its square, or less than that for outliers.
//!
//! # Equations
//! With the residual r and the bend c:
//!
//! ```text
//! rho(r) = c2 (sqrt(1 + (r/c)2) - 1)        r2 / 2 for small residuals, c |r| for large ones
//! psi(r) = rho'(r) = r / sqrt(1 + (r/c)2)
//! s2     = mean(psi2) / mean(psi')2         variance of the noise that counts
//! ```
//!
//! s2 takes the place of the mean square in the covariance of the parameters; the sum of 2 rho rises by
//! s2 mean(psi') where the sum of squares would rise by the variance of the noise. Plain squares are the limit of an
//! infinite c, with the same bits.
//!
//! # Source
//! P. J. Huber, "Robust estimation of a location parameter", Annals of Mathematical Statistics 35 (1964),
//! doi:10.1214/aoms/1177703732. The smooth form: P. Charbonnier, L. Blanc-Feraud, G. Aubert, M. Barlaud,
//! "Deterministic edge-preserving regularization in computed imaging", IEEE Transactions on Image Processing 6 (1997),
//! doi:10.1109/83.551699.

use super::Experiment;
use stribeck_measured::noise;

/// Bend in standard deviations of the noise: Huber's, which loses 5 % of precision if the noise is normal.
const BEND: f64 = 1.345;

/// Least noise, as a part of the largest force (chosen): forces of a computation have no noise.
const LEAST: f64 = 1e-6;

/// Loss of residuals, by its bend in N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Loss {
    bend: f64,
}

impl Loss {
    /// Half the squares.
    pub const SQUARES: Loss = Loss { bend: f64::INFINITY };

    /// Robust against outliers in experiments of this noise.
    pub fn robust(experiments: &[Experiment]) -> Loss {
        Loss { bend: BEND * Loss::noise(experiments) }
    }

    /// Noise of the forces of experiments, N.
    pub fn noise(experiments: &[Experiment]) -> f64 {
        let of = |one: &Experiment| match (&one.matched_filter, &one.map) {
            (Some(filter), _) => filter.noise,
            (None, Some(rows)) => rows.scatter,
            (None, None) => noise(&one.force),
        };
        let square = |one: &Experiment| of(one) * of(one);
        let noise = (experiments.iter().map(square).sum::<f64>() / experiments.len().max(1) as f64).sqrt();
        let forces = experiments.iter().flat_map(|one| &one.force);
        let level = forces.fold(f64::MIN_POSITIVE, |most, force| most.max(force.abs()));
        noise.max(LEAST * level)
    }

    /// sqrt(1 + (r/c)2).
    fn root(self, residual: f64) -> f64 {
        let part = residual / self.bend;
        (1.0 + part * part).sqrt()
    }

    /// The number whose half square is the loss, with the sign of the residual.
    pub fn root_of_loss(self, residual: f64) -> f64 {
        residual * (2.0 / (self.root(residual) + 1.0)).sqrt()
    }

    /// Its derivative.
    pub fn slope_of_root(self, residual: f64) -> f64 {
        let root = self.root(residual);
        (0.5 * (root + 1.0)).sqrt() / root
    }

    /// Sum of the losses.
    pub fn cost(self, residuals: &[f64]) -> f64 {
        0.5 * residuals.iter().map(|one| self.root_of_loss(*one).powi(2)).sum::<f64>()
    }

    /// psi / mean(psi'), of which the mean square is s2; and mean(psi').
    pub fn influence(self, residuals: &[f64]) -> (Vec<f64>, f64) {
        let slopes: f64 = residuals.iter().map(|one| 1.0 / self.root(*one).powi(3)).sum();
        let softness = slopes / residuals.len().max(1) as f64;
        (residuals.iter().map(|one| one / self.root(*one) / softness).collect(), softness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// c = 1 and r = 0.75: the root is 1.25, the loss 0.25, its slope 0.6, the slope of that 0.512.
    #[test]
    fn losses_and_their_slopes_are_those_of_a_hyperbola() {
        let loss = Loss { bend: 1.0 };
        assert_relative_eq!(loss.cost(&[0.75]), 0.25, epsilon = 1e-15);
        assert_relative_eq!(loss.root_of_loss(-0.75), -(0.5f64.sqrt()), epsilon = 1e-15);
        // The slope of the loss is that of half a square.
        assert_relative_eq!(loss.root_of_loss(0.75) * loss.slope_of_root(0.75), 0.6, epsilon = 1e-15);
        let (influence, softness) = loss.influence(&[0.75, -0.75]);
        assert_relative_eq!(softness, 0.512, epsilon = 1e-15);
        assert_relative_eq!(influence[1], -0.6 / 0.512, epsilon = 1e-15);
    }

    #[test]
    fn an_infinite_bend_gives_the_squares_to_the_last_bit() {
        for residual in [0.0, -3e-300, 0.1, 1e9] {
            assert_eq!(Loss::SQUARES.root_of_loss(residual), residual);
            assert_eq!(Loss::SQUARES.slope_of_root(residual), 1.0);
            assert_eq!(Loss::SQUARES.influence(&[residual]), (vec![residual], 1.0));
        }
    }
}
