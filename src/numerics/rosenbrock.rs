//! Integration of ordinary differential equations that are stiff.

/// Part of the size of a state over which differences are taken (chosen).
const DIFFERENCE: f64 = 1e-6;

/// The same of the time, in parts of the step (chosen).
const MOMENT: f64 = 1e-3;

/// One step of the method of order 2 of Shampine and Reichelt (1997), doi:10.1137/S1064827594276424, section 3, and its
/// difference to one of order 3. However fast states relax, longer steps follow them. The rates are functions of the time
/// since the beginning of the step and of the states, whose `sizes` are positive; their derivatives are differences. Numbers
/// are NaN where the rates are NaN, and where the linear equations of the step have no solution.
pub fn rosenbrock<const N: usize>(
    mut rates: impl FnMut(f64, [f64; N]) -> [f64; N],
    at: [f64; N],
    sizes: [f64; N],
    h: f64,
) -> ([f64; N], [f64; N]) {
    const D: f64 = 1.0 / (2.0 + std::f64::consts::SQRT_2);
    const E: f64 = 6.0 + std::f64::consts::SQRT_2;
    let first = rates(0.0, at);
    let by_state: [[f64; N]; N] = std::array::from_fn(|j| {
        let (mut moved, by) = (at, DIFFERENCE * sizes[j]);
        moved[j] += by;
        let there = rates(0.0, moved);
        std::array::from_fn(|i| (there[i] - first[i]) / by)
    });
    let later = rates(MOMENT * h, at);
    let by_time: [f64; N] = std::array::from_fn(|i| D * (later[i] - first[i]) / MOMENT);
    let matrix = |i: usize| std::array::from_fn(|j| f64::from(u8::from(i == j)) - h * D * by_state[j][i]);
    let solved: [[f64; N]; N] = inverse(std::array::from_fn(matrix));
    let solve = |right: [f64; N]| solved.map(|row| row.iter().zip(right).map(|(a, b)| a * b).sum::<f64>());
    let k_1 = solve(std::array::from_fn(|i| first[i] + by_time[i]));
    let middle = rates(0.5 * h, std::array::from_fn(|i| at[i] + 0.5 * h * k_1[i]));
    let change = solve(std::array::from_fn(|i| middle[i] - k_1[i]));
    let k_2: [f64; N] = std::array::from_fn(|i| k_1[i] + change[i]);
    let end: [f64; N] = std::array::from_fn(|i| at[i] + h * k_2[i]);
    let last = rates(h, end);
    let right = |i: usize| last[i] - E * (k_2[i] - middle[i]) - 2.0 * (k_1[i] - first[i]) + by_time[i];
    let k_3 = solve(std::array::from_fn(right));
    (end, std::array::from_fn(|i| h / 6.0 * (k_1[i] - 2.0 * k_2[i] + k_3[i])))
}

/// The inverse of a matrix, by elimination with partial pivoting; not finite if it has none.
fn inverse<const N: usize>(mut matrix: [[f64; N]; N]) -> [[f64; N]; N] {
    let mut found: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for column in 0..N {
        let larger = |a: usize, b: usize| if matrix[b][column].abs() > matrix[a][column].abs() { b } else { a };
        let pivot = (column..N).fold(column, larger);
        matrix.swap(column, pivot);
        found.swap(column, pivot);
        let scale = 1.0 / matrix[column][column];
        let rows = [matrix[column].map(|value| value * scale), found[column].map(|value| value * scale)];
        [matrix[column], found[column]] = rows;
        for row in (0..N).filter(|row| *row != column) {
            let factor = matrix[row][column];
            for (values, pivots) in [&mut matrix[row], &mut found[row]].into_iter().zip(rows) {
                values.iter_mut().zip(pivots).for_each(|(value, pivot)| *value -= factor * pivot);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_times_its_matrix_is_one() {
        let matrix = [[0.0, 2.0, 1.0], [1e-9, 1.0, -3.0], [4.0, 0.5, 0.0]];
        let found = inverse(matrix);
        for (i, row) in matrix.iter().enumerate() {
            let product: [f64; 3] = std::array::from_fn(|j| row.iter().zip(found).map(|(a, line)| a * line[j]).sum());
            for (j, value) in product.into_iter().enumerate() {
                assert!((value - f64::from(u8::from(i == j))).abs() < 1e-14, "{i} {j}: {value}");
            }
        }
        assert!(inverse([[1.0, 2.0], [2.0, 4.0]]).as_flattened().iter().any(|value| !value.is_finite()));
    }

    /// Half the step, 2^3 times less error: a rotation, whose solution is known.
    #[test]
    fn local_error_is_of_order_three() {
        let error = |h: f64| {
            let ([x, y], estimate) = rosenbrock(|_, [x, y]| [-y, x], [1.0, 0.0], [1.0; 2], h);
            let error = (x - h.cos()).hypot(y - h.sin());
            assert!(estimate.iter().all(|error| *error != 0.0 && error.abs() < h.powi(3)));
            error
        };
        let ratio = error(0.02) / error(0.01);
        assert!((ratio / 8.0 - 1.0).abs() < 0.05, "{ratio}");
    }

    /// A state that relaxes ten thousand times as fast as the step is long, to a target that moves: it lags by the ratio of
    /// both rates. Twice the work of the rest is a polynomial of time.
    #[test]
    fn a_stiff_state_follows_its_target() {
        let rate = 1e6;
        let rates = |t: f64, [x, _]: [f64; 2]| [-rate * (x - 2.0 - 3.0 * t), 4.0 * t];
        let ([x, y], error) = rosenbrock(rates, [2.0 - 3.0 / rate, 1.0], [2.0; 2], 0.01);
        assert!((x - (2.03 - 3.0 / rate)).abs() < 1e-9, "{x}");
        assert!((y - 1.0002).abs() < 1e-12, "{y}");
        assert!(error.iter().all(|error| error.abs() < 1e-9), "{error:?}");
        // From beside the target, the distance all but disappears: by the function of stability of the method.
        let ([x, _], _) = rosenbrock(rates, [5.0 - 3.0 / rate, 1.0], [2.0; 2], 0.01);
        let (d, z) = (1.0 - 0.5 * std::f64::consts::SQRT_2, -0.01 * rate);
        let left = 3.0 * (1.0 + (1.0 - 2.0 * d) * z) / (1.0 - d * z).powi(2);
        assert!((x - (2.03 - 3.0 / rate) - left).abs() < 1e-7 && left.abs() < 2e-3, "{x} {left}");
    }
}
