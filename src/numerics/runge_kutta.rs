//! Integration of ordinary differential equations that are not stiff.

use crate::number::elementary::pow;

/// Result of a step.
pub struct Done<const N: usize> {
    /// Result of order 5.
    pub end: [f64; N],
    /// Its difference to that of order 4.
    pub error: [f64; N],
    /// Rates at the end.
    pub rates: [f64; N],
}

/// One step of the method of Dormand and Prince (1980), doi:10.1016/0771-050X(80)90013-3: the result of order 5 and its
/// difference to that of order 4. The rates are functions of the time since the beginning of the step and of the state.
pub fn dormand_prince<const N: usize>(
    mut rates: impl FnMut(f64, [f64; N]) -> [f64; N],
    at: [f64; N],
    h: f64,
) -> ([f64; N], [f64; N]) {
    let done = dormand_prince_from(rates(0.0, at), rates, at, h);
    (done.end, done.error)
}

/// As [`dormand_prince`], with the rates at the beginning of the step: those at the end of the step before.
pub fn dormand_prince_from<const N: usize>(
    first: [f64; N],
    mut rates: impl FnMut(f64, [f64; N]) -> [f64; N],
    at: [f64; N],
    h: f64,
) -> Done<N> {
    const A_2: [f64; 1] = [1.0 / 5.0];
    const A_3: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
    const A_4: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
    const A_5: [f64; 4] = [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0];
    const A_6: [f64; 5] = [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0];
    const B: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
    const E: [f64; 7] =
        [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
    let mut k = [[0.0; N]; 7];
    k[0] = first;
    k[1] = rates(1.0 / 5.0 * h, along(at, &k, A_2, h));
    k[2] = rates(3.0 / 10.0 * h, along(at, &k, A_3, h));
    k[3] = rates(4.0 / 5.0 * h, along(at, &k, A_4, h));
    k[4] = rates(8.0 / 9.0 * h, along(at, &k, A_5, h));
    k[5] = rates(h, along(at, &k, A_6, h));
    let end = along(at, &k, B, h);
    k[6] = rates(h, end);
    Done { end, error: std::array::from_fn(|i| h * weighted(&k, E, i)), rates: k[6] }
}

/// A state that moves for the time h at the mean of the first rates with these weights.
#[inline(always)]
fn along<const S: usize, const N: usize>(at: [f64; N], k: &[[f64; N]; 7], weights: [f64; S], h: f64) -> [f64; N] {
    std::array::from_fn(|i| at[i] + h * weighted(k, weights, i))
}

/// The rate of state i, as the mean of the first rates with these weights.
#[inline(always)]
fn weighted<const S: usize, const N: usize>(k: &[[f64; N]; 7], weights: [f64; S], i: usize) -> f64 {
    (1..S).fold(weights[0] * k[0][i], |sum, stage| sum + weights[stage] * k[stage][i])
}

/// Factor from the length of a step to that of the next one, by the error as a multiple of the tolerated one. The
/// estimate is of fifth order; safety factor and limits are those usual in step-size control.
pub fn growth(error: f64) -> f64 {
    const LEAST: f64 = 0.2;
    const MOST: f64 = 5.0;
    // Far below the tolerance there is no need for the root.
    if error < 1e-4 {
        return MOST;
    }
    let factor = 0.9 * pow(error, -0.2);
    if factor.is_nan() { LEAST } else { factor.clamp(LEAST, MOST) }
}

/// The classical method of fourth order in equal steps: another road for tests.
#[cfg(test)]
pub(crate) fn classical<const N: usize>(
    rate: impl Fn([f64; N]) -> [f64; N],
    mut at: [f64; N],
    duration: f64,
    steps: u32,
) -> [f64; N] {
    let h = duration / f64::from(steps);
    for _ in 0..steps {
        let ahead = |k: [f64; N], share: f64| std::array::from_fn(|i| at[i] + share * h * k[i]);
        let k_1 = rate(at);
        let k_2 = rate(ahead(k_1, 0.5));
        let k_3 = rate(ahead(k_2, 0.5));
        let k_4 = rate(ahead(k_3, 1.0));
        at = std::array::from_fn(|i| at[i] + h / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]));
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half the step, 2^6 times less error: a rotation, whose solution is known.
    #[test]
    fn local_error_is_of_order_six() {
        let error = |h: f64| {
            let ([x, y], estimate) = dormand_prince(|_, [x, y]| [-y, x], [1.0, 0.0], h);
            assert!(estimate.iter().all(|error| *error != 0.0 && error.abs() < h.powi(5)));
            (x - h.cos()).hypot(y - h.sin())
        };
        let ratio = error(0.2) / error(0.1);
        assert!((ratio / 64.0 - 1.0).abs() < 0.1, "{ratio}");
    }

    /// A polynomial of order 5 in time is integrated exactly.
    #[test]
    fn rates_are_asked_for_at_their_instants() {
        let ([x], _) = dormand_prince(|t, _| [6.0 * t.powi(4) - 2.0 * t], [1.0], 0.7);
        assert!((x - (1.0 + 1.2 * 0.7f64.powi(5) - 0.49)).abs() < 1e-15, "{x}");
    }
}
