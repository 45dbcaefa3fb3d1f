//! Numerical methods that several models share: roots, integrals, interpolation, relaxation, exponentials of matrices,
//! random numbers, vectors.

pub mod approach;
pub mod exponential;
pub mod interpolation;
pub mod quadrature;
pub(crate) mod random;
pub mod relaxation;
pub mod root;
pub(crate) mod rosenbrock;
pub mod runge_kutta;
pub mod vector;
