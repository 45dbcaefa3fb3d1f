//! Numerical methods that several models share: roots, integrals, interpolation, relaxation, random numbers, vectors.

pub mod approach;
pub mod interpolation;
pub mod quadrature;
pub(crate) mod random;
pub mod relaxation;
pub mod root;
pub mod runge_kutta;
pub mod vector;
