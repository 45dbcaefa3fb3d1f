//! Few and independent rows.
//!
//! # Source
//! Quantiles of Student's distribution: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions (1964), 26.7.5.

/// Residuals in the order of velocity, in which a misfit is alike for neighbours.
pub(in crate::identify) fn by_velocity(velocity: &[f64], left: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..left.len()).collect();
    order.sort_by(|a, b| velocity[*a].total_cmp(&velocity[*b]));
    order.into_iter().map(|at| left[at]).collect()
}

/// Correlation of neighbours in a list.
pub(in crate::identify) fn neighbours(sorted: &[f64]) -> f64 {
    let square: f64 = sorted.iter().map(|one| one * one).sum();
    let pairs: f64 = sorted.windows(2).map(|pair| pair[0] * pair[1]).sum();
    if square > 0.0 { pairs / square } else { 0.0 }
}

/// Quantile of the distribution of Student with so many degrees of freedom, over that of the normal distribution, z.
pub(in crate::identify) fn student(z: f64, freedom: usize) -> f64 {
    let nu = freedom as f64;
    let square = z * z;
    let terms = [
        (square + 1.0) / 4.0,
        ((5.0 * square + 16.0) * square + 3.0) / 96.0,
        (((3.0 * square + 19.0) * square + 17.0) * square - 15.0) / 384.0,
        ((((79.0 * square + 776.0) * square + 1482.0) * square - 1920.0) * square - 945.0) / 92160.0,
    ];
    1.0 + terms.iter().rev().fold(0.0, |sum, term| (sum + term) / nu)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables of Student's t, two-sided 95 %.
    #[test]
    fn quantiles_are_those_of_tables() {
        let normal = 1.959_963_984_540_054;
        for (freedom, quantile) in [(3, 3.1824), (5, 2.5706), (7, 2.3646), (10, 2.2281), (30, 2.0423), (1000, 1.9623)] {
            let found = normal * student(normal, freedom);
            assert!((found / quantile - 1.0).abs() < 2e-3, "{freedom}: {found}");
        }
    }
}
