//! Stencils: value and derivatives of a sampled signal by the polynomial through the nearest samples.
//!
//! Nothing is smoothed: the derivatives of a sine are accurate to a few parts in a thousand up to a third of the sampling
//! rate, to some parts in a million up to a tenth. Noise has to be filtered afterwards.
//!
//! # Source
//! B. Fornberg, "Generation of finite difference formulas on arbitrarily spaced grids", Mathematics of Computation 51
//! (1988), doi:10.1090/S0025-5718-1988-0935077-0.

/// Samples of a stencil.
pub(crate) const NODES: usize = 7;

/// Value, first and second derivative, at a time, of a signal with at least [`NODES`] samples.
pub(crate) fn derivatives(time: &[f64], values: &[f64], at: f64) -> [f64; 3] {
    let nearest = time.partition_point(|t| *t < at);
    // Of the two samples around the time the nearer one is in the middle.
    let is_left = nearest > 0 && (nearest == time.len() || at - time[nearest - 1] < time[nearest] - at);
    let from = (nearest - usize::from(is_left)).saturating_sub(NODES / 2).min(time.len() - NODES);
    let weights = weights(&time[from..from + NODES], at);
    let mut found = [0.0; 3];
    for (value, weights) in values[from..from + NODES].iter().zip(weights) {
        for (sum, weight) in found.iter_mut().zip(weights) {
            *sum += weight * value;
        }
    }
    found
}

/// Weights of the samples for value, first and second derivative at a time.
fn weights(time: &[f64], at: f64) -> [[f64; 3]; NODES] {
    let mut found = [[0.0; 3]; NODES];
    found[0][0] = 1.0;
    let mut before = 1.0;
    for new in 1..NODES {
        let mut product = 1.0;
        let orders = (0..=new.min(2)).rev();
        let [ahead, behind] = [time[new] - at, time[new - 1] - at];
        for old in 0..new {
            let apart = time[new] - time[old];
            product *= apart;
            if old + 1 == new {
                for order in orders.clone() {
                    let lower = if order > 0 { order as f64 * found[old][order - 1] } else { 0.0 };
                    found[new][order] = before * (lower - behind * found[old][order]) / product;
                }
            }
            for order in orders.clone() {
                let lower = if order > 0 { order as f64 * found[old][order - 1] } else { 0.0 };
                found[old][order] = (ahead * found[old][order] - lower) / apart;
            }
        }
        before = product;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn polynomials_of_the_sixth_degree_are_differentiated_exactly_anywhere_between_uneven_samples() {
        let time: Vec<f64> = (0..12).map(|k| f64::from(k) * 0.1 + 0.02 * f64::sin(f64::from(k))).collect();
        let value = |t: f64| 1.0 - t + 2.0 * t.powi(3) - 3.0 * t.powi(6);
        let values: Vec<f64> = time.iter().map(|t| value(*t)).collect();
        for t in [0.0, 0.04, 0.333, time[5], 0.81, time[11]] {
            let [x, v, a] = derivatives(&time, &values, t);
            assert_relative_eq!(x, value(t), max_relative = 1e-10);
            assert_relative_eq!(v, -1.0 + 6.0 * t * t - 18.0 * t.powi(5), max_relative = 1e-8);
            assert_relative_eq!(a, 12.0 * t - 90.0 * t.powi(4), max_relative = 1e-7, epsilon = 1e-7);
        }
    }
}
