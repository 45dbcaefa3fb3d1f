//! Solution of small linear systems by elimination.

/// Largest number of rows for which the inverse is worth its time (chosen): the stages of a step wait for each other, and
/// the terms of a product with it do not. For matrices that small its errors are those of the substitution.
const SMALL: usize = 4;

/// Largest number of rows for which the inverse has a closed form here: one division instead of a chain of them.
const CLOSED: usize = 3;

/// The columns of the inverse of a matrix with up to three rows: its cofactors by its determinant. None if a number is
/// too large or too small for that.
#[inline(always)]
fn inverse<const N: usize>(matrix: &[[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let cofactor = |row: usize, column: usize| {
        let at = |i: usize, j: usize| matrix[(row + i) % N][(column + j) % N];
        match N {
            1 => 1.0,
            // Signs alternate where the order of the others does not turn with the row.
            2 => at(1, 1) * if row == column { 1.0 } else { -1.0 },
            _ => at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1),
        }
    };
    let cofactors: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| cofactor(i, j)));
    let determinant: f64 = matrix[0].iter().zip(&cofactors[0]).map(|(value, cofactor)| value * cofactor).sum();
    let reciprocal = 1.0 / determinant;
    // The columns of the inverse are the rows of the cofactors.
    (determinant.is_finite() && reciprocal.is_finite())
        .then(|| cofactors.map(|row| row.map(|value| value * reciprocal)))
}

/// A matrix in triangular factors, or the inverse of a small one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factors<const N: usize> {
    matrix: [[f64; N]; N],
    /// Reciprocals of the pivots.
    reciprocals: [f64; N],
    /// Row that was exchanged with each row.
    exchanged: [usize; N],
}

impl<const N: usize> Factors<N> {
    /// The inverse in closed form for up to three rows, otherwise elimination with partial pivoting. None if the matrix is
    /// singular or not finite.
    #[inline]
    pub fn of(matrix: [[f64; N]; N]) -> Option<Factors<N>> {
        let closed = if N <= CLOSED { inverse(&matrix) } else { None };
        match closed {
            Some(matrix) => Some(Factors { matrix, reciprocals: [0.0; N], exchanged: [0; N] }),
            None => Factors::eliminated(matrix),
        }
    }

    /// Of diagonal I - J.
    #[inline]
    pub fn of_shifted(diagonal: f64, jacobian: &[[f64; N]; N]) -> Option<Factors<N>> {
        Factors::of(std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { diagonal - jacobian[i][j] } else { -jacobian[i][j] })
        }))
    }

    fn eliminated(mut matrix: [[f64; N]; N]) -> Option<Factors<N>> {
        let (mut reciprocals, mut exchanged) = ([0.0; N], [0; N]);
        for column in 0..N {
            let mut pivot = column;
            for row in column + 1..N {
                if matrix[row][column].abs() > matrix[pivot][column].abs() {
                    pivot = row;
                }
            }
            exchanged[column] = pivot;
            matrix.swap(column, pivot);
            let reciprocal = 1.0 / matrix[column][column];
            if !reciprocal.is_finite() {
                return None;
            }
            reciprocals[column] = reciprocal;
            let above = matrix[column];
            for row in &mut matrix[column + 1..] {
                let factor = row[column] * reciprocal;
                row[column] = factor;
                for (value, above) in row.iter_mut().zip(&above).skip(column + 1) {
                    *value -= factor * above;
                }
            }
        }
        let factors = Factors { matrix, reciprocals, exchanged };
        Some(if N <= SMALL { factors.inverted() } else { factors })
    }

    /// The columns of the inverse instead of the factors.
    #[inline(always)]
    fn inverted(self) -> Factors<N> {
        let column = |j: usize| self.substitute(std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 }));
        Factors { matrix: std::array::from_fn(column), ..self }
    }

    /// Solves the system for a right-hand side.
    #[inline(always)]
    pub fn solve(&self, right: [f64; N]) -> [f64; N] {
        if N > SMALL {
            return self.substitute(right);
        }
        // Column by column, so that a processor works on all rows at once.
        let mut solution = [-0.0; N];
        for (column, right) in self.matrix.iter().zip(right) {
            for (sum, value) in solution.iter_mut().zip(column) {
                *sum += value * right;
            }
        }
        solution
    }

    #[inline(always)]
    fn substitute(&self, mut right: [f64; N]) -> [f64; N] {
        for row in 0..N {
            right.swap(row, self.exchanged[row]);
        }
        for row in 1..N {
            for k in 0..row {
                right[row] -= self.matrix[row][k] * right[k];
            }
        }
        for row in (0..N).rev() {
            for k in row + 1..N {
                right[row] -= self.matrix[row][k] * right[k];
            }
            right[row] *= self.reciprocals[row];
        }
        right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_solved<const N: usize>(matrix: [[f64; N]; N], right: [f64; N]) {
        let solution = Factors::of(matrix).unwrap().solve(right);
        for (row, expected) in matrix.iter().zip(right) {
            let product: f64 = row.iter().zip(solution).map(|(a, x)| a * x).sum();
            assert!((product - expected).abs() < 1e-14, "{product} {expected}");
        }
    }

    /// A x computed again, for matrices that need exchanges of rows, by the inverse and by substitution.
    #[test]
    fn solutions_satisfy_their_equations() {
        let small = [[0.0, 2.0, -1.0], [1e-3, 1.0, 4.0], [5.0, -3.0, 0.5]];
        assert_solved(small, [1.0, -2.0, 0.25]);
        let mut large = [[0.0; 6]; 6];
        for (i, row) in small.iter().enumerate() {
            large[i][..3].copy_from_slice(row);
            large[i + 3][3..].copy_from_slice(row);
            large[i + 3][2 - i] = 0.5;
        }
        assert_solved(large, [1.0, -2.0, 0.25, 3.0, 0.125, -1.0]);
    }

    /// A stiff bristle beside a slow body: entries of very different sizes.
    #[test]
    fn stiff_systems_are_solved_to_their_last_digits() {
        let matrix = [[40.0, -1.0, 0.0], [2.0, 356.0, 1e5], [0.0, -1e-9, 1e6]];
        let right = [3.0, -5.0, 7e-3];
        let determinant = 40.0 * (356.0 * 1e6 + 1e-4) + 2e6;
        // By Cramer's rule.
        let expected = [
            (3.0 * (356.0 * 1e6 + 1e-4) + (-5.0 * 1e6 - 7e-3 * 1e5)) / determinant,
            (40.0 * (-5.0 * 1e6 - 7e-3 * 1e5) - 3.0 * 2.0 * 1e6) / determinant,
        ];
        let solution = Factors::of(matrix).unwrap().solve(right);
        for (found, expected) in solution.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
        }
    }

    /// The matrices of steps: an oscillator with friction of either slope and a bristle, over ten decades of step sizes.
    #[test]
    fn closed_forms_agree_with_elimination() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut size = |least: f64, most: f64| 10f64.powf(least + (most - least) * random.f64());
        for number in 0..10_000 {
            let (c, slope) = (size(0.0, 10.0), if number % 3 == 0 { -1.0 } else { 1.0 } * size(-3.0, 5.0));
            let (spring, bristle, release) = (size(-2.0, 4.0), size(2.0, 7.0), size(-3.0, 6.0));
            let matrix = [[c, -1.0, 0.0], [spring, c + slope, bristle], [0.0, slope.signum() - 1.5, c + release]];
            let right = [size(-3.0, 3.0), -size(-3.0, 3.0), size(-3.0, 3.0)];
            let [closed, eliminated] = [Factors::of(matrix), Factors::eliminated(matrix)].map(|one| one.unwrap());
            let least = [closed.solve(right), eliminated.solve(right)];
            // What either leaves of the right-hand side, in parts of the terms in its rows.
            for found in least {
                for (row, right) in matrix.iter().zip(right) {
                    let terms = row.iter().zip(found).map(|(a, x)| a * x);
                    let size = terms.clone().map(f64::abs).sum::<f64>() + right.abs();
                    let left = (terms.sum::<f64>() - right).abs() / size;
                    assert!(left < 1e-9, "{matrix:?} {right:?}: {left:e}");
                }
            }
        }
        // The determinant of these would be too large or too small.
        for scale in [1e-160, 1e160] {
            assert_solved([[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale]], [scale, -scale, 2.0 * scale]);
        }
    }

    #[test]
    fn singular_and_non_finite_matrices_have_no_factors() {
        assert!(Factors::of([[1.0, 2.0], [2.0, 4.0]]).is_none());
        assert!(Factors::of([[f64::NAN]]).is_none());
    }
}
