//! Whether a step whose estimated error is small can be believed.
//!
//! L-stable methods damp whatever is fast, and their estimate of the error with it, even a motion that grows: a block that is
//! about to break away would go on sticking for as long as the step lasts. Two looks at the step find this out, with the rates
//! and the Jacobian at its end, which the next step needs anyway:
//!
//! ```text
//! growth   max Re lambda(J_0) h <= 1, max Re lambda(J_1) h <= 1
//! defect   (I / (h gamma) - J_1) e = f(x_1) - p'(1) / h,   |e| <= a part of the tolerance
//! ```
//!
//! A steep slope makes e small, whatever the defect d is. Where it does so a million times, the rates are asked once more
//! whether e takes the defect away:
//!
//! ```text
//! left   f(x_1 + e) - p'(1) / h - e / (h gamma),   |left| <= |d| / 2
//! ```
//!
//! p is the polynomial of the step. Of 349 blocks on belts with drawn parameters, at a tolerance of 1e-3, both leave 3 that are
//! off by more than a twentieth of their amplitude and say nothing, all of a law that amplifies every error; the growth alone
//! leaves 49, the defect alone 16 of 321, and without them it is 76 of 322.

use super::elimination::Factors;
use super::step::Beginning;

/// Factor by which a steep slope makes an error smaller from which on it is tried whether it does (chosen): slopes of the
/// laws that are resolved stay below.
pub(super) const STEEP: f64 = 1e6;

/// Tolerances to which defects may add up over a run without a look at them (chosen).
pub(super) const HARMLESS: f64 = 1e3;

/// Part of a defect that its correction may leave (chosen).
pub(super) const ILLUSION: f64 = 0.5;

/// Largest growth within a step, as an exponent (chosen).
const GROWTH: f64 = 1.0;

/// Norm of a power of a matrix from which on its powers have no limit, however far from normal it is (chosen).
const ENDLESS: f64 = 1e100;

/// Squarings of such a matrix (chosen): enough for eigenvalues that differ by a factor of a million.
const SQUARINGS: usize = 32;

/// Row by row.
type Matrix<const N: usize> = [[f64; N]; N];

/// Passes over a matrix that bring its rows and columns to the same size (chosen).
const BALANCING: usize = 3;

/// The correction e of the states at the end of a step, from the difference between the rates and the slopes of the polynomial
/// there. None if the matrix is singular.
pub(super) fn defect<const N: usize>(
    end: &Beginning<N>,
    slopes: &[f64; N],
    length: f64,
    gamma: f64,
) -> Option<[f64; N]> {
    let factors = Factors::of_shifted(1.0 / (length * gamma), &end.jacobian)?;
    Some(factors.solve(std::array::from_fn(|i| end.rates[i] - slopes[i] / length)))
}

/// Whether the linear equations have a motion that grows by more than a factor of e within a step of this length.
pub(super) fn grows<const N: usize>(jacobian: &Matrix<N>, length: f64) -> bool {
    let most = GROWTH / length;
    let at = |i: usize, j: usize| if i == j { jacobian[i][j] - most } else { jacobian[i][j] };
    let minor = |i: usize, j: usize| at(i, i) * at(j, j) - at(i, j) * at(j, i);
    // The conditions of Hurwitz for J - most I.
    let is_slow = match N {
        1 => at(0, 0) < 0.0,
        2 => at(0, 0) + at(1, 1) < 0.0 && minor(0, 1) > 0.0,
        3 => {
            let trace = at(0, 0) + at(1, 1) + at(2, 2);
            let minors = minor(0, 1) + minor(0, 2) + minor(1, 2);
            let cofactor = |i: usize, j: usize, k: usize| at(0, i) * (at(1, j) * at(2, k) - at(1, k) * at(2, j));
            let determinant = cofactor(0, 1, 2) + cofactor(1, 2, 0) + cofactor(2, 0, 1);
            trace < 0.0 && determinant < 0.0 && trace * minors < determinant
        }
        _ => {
            let matrix = balanced(jacobian);
            bound(&matrix) < most || decays(&matrix, most)
        }
    };
    !is_slow
}

/// Largest factor on a state in one pass of balancing (chosen): a coupling that is next to nothing shall not overflow.
const SCALING: f64 = 1e4;

/// The matrix with its states scaled so that rows and columns are of the same size; this keeps the eigenvalues.
pub(super) fn balanced<const N: usize>(jacobian: &Matrix<N>) -> Matrix<N> {
    let mut matrix = *jacobian;
    for i in (0..BALANCING).flat_map(|_| 0..N) {
        let row: f64 = others::<N>(i).map(|j| matrix[i][j].abs()).sum();
        let column: f64 = others::<N>(i).map(|j| matrix[j][i].abs()).sum();
        let factor = if row > 0.0 && column > 0.0 { (column / row).sqrt().clamp(1.0 / SCALING, SCALING) } else { 1.0 };
        for j in others::<N>(i) {
            matrix[i][j] *= factor;
            matrix[j][i] /= factor;
        }
    }
    matrix
}

/// The numbers of all states but one.
fn others<const N: usize>(state: usize) -> impl Iterator<Item = usize> {
    (0..N).filter(move |other| *other != state)
}

/// A bound of the growth: that of the symmetric part, by Gershgorin's circles.
fn bound<const N: usize>(matrix: &Matrix<N>) -> f64 {
    let circle = |i: usize| {
        let radius: f64 = others::<N>(i).map(|j| 0.5 * (matrix[i][j] + matrix[j][i]).abs()).sum();
        matrix[i][i] + radius
    };
    (0..N).map(circle).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether the real part of every eigenvalue is below `most`: those of B = (2 most I - J)^-1 J, lambda / (2 most - lambda),
/// are then within the unit circle, and the powers of B go to 0. True if that cannot be decided.
fn decays<const N: usize>(matrix: &Matrix<N>, most: f64) -> bool {
    let Some(factors) = Factors::of_shifted(2.0 * most, matrix) else { return false };
    let columns: Matrix<N> = std::array::from_fn(|j| factors.solve(std::array::from_fn(|i| matrix[i][j])));
    let mut power: Matrix<N> = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    for _ in 0..SQUARINGS {
        let norm = power.iter().map(|row| row.iter().map(|value| value.abs()).sum::<f64>()).fold(0.0, f64::max);
        if norm < 1.0 {
            return true;
        }
        if norm.is_nan() || norm > ENDLESS {
            return false;
        }
        power = std::array::from_fn(|i| std::array::from_fn(|j| (0..N).map(|k| power[i][k] * power[k][j]).sum()));
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrices with known eigenvalues, T D T^-1, whose entries differ by powers of ten: the largest growth lies a little below
    /// or above what a step can follow.
    fn check<const N: usize>(random: &mut fastrand::Rng) {
        let mut draw = || 2.0 * random.f64() - 1.0;
        let (size, pair) = (10f64.powf(3.0 * draw()), N >= 2 && draw() > 0.0);
        let mut matrix = [[0.0; N]; N];
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] = -size * (1.0 + draw().abs()) * 10f64.powf(2.0 * draw().abs());
        }
        matrix[N - 1][N - 1] = size;
        if pair {
            (matrix[N - 2][N - 2], matrix[N - 2][N - 1], matrix[N - 1][N - 2]) = (size, -30.0 * size, 30.0 * size);
        }
        // Shears and scalings keep the eigenvalues.
        for _ in 0..2 * N {
            let (i, j, factor) = (random.usize(0..N), random.usize(0..N), 0.5 * (2.0 * random.f64() - 1.0));
            if i != j {
                (0..N).for_each(|k| matrix[i][k] += factor * matrix[j][k]);
                (0..N).for_each(|k| matrix[k][j] -= factor * matrix[k][i]);
            }
            let scale = 10f64.powf(2.0 * random.f64() - 1.0);
            (0..N).for_each(|k| matrix[i][k] *= scale);
            (0..N).for_each(|k| matrix[k][i] /= scale);
        }
        assert!(!grows(&matrix, 0.999 * GROWTH / size), "{matrix:?}");
        assert!(grows(&matrix, 1.001 * GROWTH / size), "{matrix:?}");
        assert!(N < 2 || bound(&balanced(&matrix)) > (1.0 - 1e-9) * size, "{matrix:?}");
    }

    #[test]
    fn growth_is_that_of_the_eigenvalues() {
        let mut random = fastrand::Rng::with_seed(3);
        for _ in 0..500 {
            check::<1>(&mut random);
            check::<2>(&mut random);
            check::<3>(&mut random);
            check::<4>(&mut random);
            check::<8>(&mut random);
        }
    }

    /// A curve far beyond its fall has slopes such as 1e-215, which balance nothing.
    #[test]
    fn couplings_next_to_nothing_do_not_grow() {
        for tiny in [1e-12, 1e-100, 1e-215, 1e-308] {
            let matrix = [[0.0, 1.0, 0.0, 0.0], [0.0, -tiny, 0.0, tiny], [0.0, 0.0, 0.0, 1.0], [0.0, tiny, 0.0, -tiny]];
            assert!(!grows(&matrix, 1e-3) && !grows(&matrix, 0.1), "{tiny:e}");
        }
    }

    /// x' = l (x - sin t) + cos t with the solution sin t: the defect takes an error of the stiff state back.
    #[test]
    fn the_defect_is_the_error_of_a_stiff_state() {
        let (l, t, h) = (-1e6f64, 0.3f64, 0.1);
        let error = 1e-4;
        let end = Beginning {
            time: t + h,
            states: [(t + h).sin() + error],
            rates: [l * error + (t + h).cos()],
            jacobian: [[l]],
            by_time: [0.0],
        };
        let [found] = defect(&end, &[h * (t + h).cos()], h, 0.25).unwrap();
        assert!((found + error).abs() < 1e-4 * error, "{found}");
    }
}
