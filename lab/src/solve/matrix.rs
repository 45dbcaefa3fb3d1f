//! Small square matrices.

/// Row by row.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// A matrix of these elements.
#[inline(always)]
pub(super) fn from<const N: usize>(value: impl Fn(usize, usize) -> f64) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| value(i, j)))
}

/// A product.
#[inline(always)]
pub(super) fn product<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from(|i, j| (0..N).map(|k| a[i][k] * b[k][j]).sum())
}

/// Adds a multiple of the unit matrix.
#[inline(always)]
pub(super) fn with_diagonal<const N: usize>(a: &Matrix<N>, diagonal: f64) -> Matrix<N> {
    from(|i, j| if i == j { a[i][j] + diagonal } else { a[i][j] })
}

/// Product with a column.
#[inline(always)]
pub(super) fn apply<const N: usize>(a: &Matrix<N>, x: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i].iter().zip(x).map(|(a, x)| a * x).sum())
}

/// A sum.
#[inline(always)]
pub(super) fn plus<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] + b[i])
}
