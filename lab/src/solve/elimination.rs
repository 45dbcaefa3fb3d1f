//! Solution of small linear systems by elimination.

/// A matrix in triangular factors.
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
        Some(Factors { matrix, reciprocals, exchanged })
    }

    /// Solves the system for a right-hand side.
    #[inline]
    pub fn solve(&self, mut right: [f64; N]) -> [f64; N] {
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

    /// A x computed again, for matrices that need exchanges of rows.
    #[test]
    fn solutions_satisfy_their_equations() {
        let matrix = [[0.0, 2.0, -1.0], [1e-3, 1.0, 4.0], [5.0, -3.0, 0.5]];
        let right = [1.0, -2.0, 0.25];
        let solution = Factors::of(matrix).unwrap().solve(right);
        for (row, expected) in matrix.iter().zip(right) {
            let product: f64 = row.iter().zip(solution).map(|(a, x)| a * x).sum();
            assert!((product - expected).abs() < 1e-14, "{product} {expected}");
        }
    }

    #[test]
    fn singular_and_non_finite_matrices_have_no_factors() {
        assert!(Factors::of([[1.0, 2.0], [2.0, 4.0]]).is_none());
        assert!(Factors::of([[f64::NAN]]).is_none());
    }
}
