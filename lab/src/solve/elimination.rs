//! Solution of small linear systems by elimination.

/// Largest number of rows for which the inverse is worth its time (chosen): the stages of a step wait for each other, and
/// the terms of a product with it do not. For matrices that small its errors are those of the substitution.
const SMALL: usize = 4;

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
    /// Eliminates with partial pivoting. None if the matrix is singular or not finite.
    #[inline]
    pub fn of(mut matrix: [[f64; N]; N]) -> Option<Factors<N>> {
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
        std::array::from_fn(|i| (0..N).map(|j| self.matrix[j][i] * right[j]).sum())
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

    #[test]
    fn singular_and_non_finite_matrices_have_no_factors() {
        assert!(Factors::of([[1.0, 2.0], [2.0, 4.0]]).is_none());
        assert!(Factors::of([[f64::NAN]]).is_none());
    }
}
