//! Exponential of a matrix.

/// Largest norm of a matrix whose series is summed up (chosen).
const SMALL: f64 = 0.5;

/// Terms of the series: those left out are below 0.5^16 / 16!, far less than rounding.
const TERMS: u32 = 15;

/// Most halvings of a matrix: no finite one needs more.
const MOST_HALVINGS: u32 = 1100;

/// Row by row.
pub type Matrix<const N: usize> = [[f64; N]; N];

/// e to the power of a matrix, minus the identity: what a linear motion adds to its state.
///
/// ```text
/// E(A) = A + A^2 / 2! + A^3 / 3! + ...,   E(2 A) = 2 E(A) + E(A)^2
/// ```
///
/// Without the identity small motions keep their digits. The series is summed up for a matrix that was halved until its
/// norm is at most 0.5: method 3 of C. Moler, C. Van Loan (2003), SIAM Review 45, 3-49,
/// doi:10.1137/S00361445024180. An element that is not finite gives NaN.
pub fn exp_m1<const N: usize>(matrix: &Matrix<N>) -> Matrix<N> {
    let norm = norm(matrix);
    let (mut scale, mut halvings) = (1.0, 0);
    while norm * scale > SMALL && halvings < MOST_HALVINGS {
        scale *= 0.5;
        halvings += 1;
    }
    let halved = matrix.map(|row| row.map(|element| element * scale));
    // Horner's form: A + A / 2 (A + A / 3 (A + ...)).
    let mut sum = halved;
    for k in (2..=TERMS).rev() {
        let part = halved.map(|row| row.map(|element| element / f64::from(k)));
        sum = multiplied(&part, &sum, &halved, 1.0);
    }
    for _ in 0..halvings {
        sum = multiplied(&sum, &sum, &sum, 2.0);
    }
    sum
}

/// Largest sum of the magnitudes in a row.
fn norm<const N: usize>(matrix: &Matrix<N>) -> f64 {
    matrix.iter().map(|row| row.iter().map(|element| element.abs()).sum()).fold(0.0, f64::max)
}

/// a b + factor c.
fn multiplied<const N: usize>(a: &Matrix<N>, b: &Matrix<N>, c: &Matrix<N>, factor: f64) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..N).fold(factor * c[i][j], |sum, k| sum + a[i][k] * b[k][j])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn and a decay at once: exp(-d t) times a rotation by w t.
    #[test]
    fn a_spiral_is_that_of_sine_and_cosine() {
        for (decay, turn) in [(0.0, 1e-9), (1e-7, 0.0), (0.3, 0.4), (2.0, 30.0), (40.0, 3.0)] {
            let found = exp_m1(&[[-decay, -turn], [turn, -decay]]);
            // e^x cos y - 1 without a difference of large numbers.
            let half = f64::sin(0.5 * turn);
            let along = f64::exp_m1(-decay) * f64::cos(turn) - 2.0 * half * half;
            let across = f64::exp(-decay) * f64::sin(turn);
            for (found, expected) in found.as_flattened().iter().zip([along, -across, across, along]) {
                assert!((found - expected).abs() <= 2e-14 * along.hypot(across), "{decay} {turn}: {found} {expected}");
            }
        }
    }

    /// A chain of integrals gives a polynomial, whatever its scale.
    #[test]
    fn nilpotent_matrices_give_polynomials() {
        for t in [1e-12, 1.0, 1e6] {
            let found = exp_m1(&[[0.0, t, 0.0], [0.0, 0.0, t], [0.0; 3]]);
            let expected = [[0.0, t, 0.5 * t * t], [0.0, 0.0, t], [0.0; 3]];
            for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
                assert!((found - expected).abs() <= 1e-14 * expected, "{t}: {found} {expected}");
            }
        }
    }

    #[test]
    fn what_is_not_finite_gives_no_number() {
        for element in [f64::NAN, f64::INFINITY, f64::MAX] {
            assert!(!exp_m1(&[[element, 1.0], [1.0, 0.0]])[0][0].is_finite(), "{element}");
        }
        assert_eq!(exp_m1(&[[-f64::MAX / 4.0]]), [[-1.0]]);
    }
}
