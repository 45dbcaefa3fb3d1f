//! Numerical methods that several models share: roots, integrals, interpolation, relaxation, vectors.

pub mod approach;
pub mod interpolation;
pub mod quadrature;
pub mod relaxation;
pub mod root;
pub mod runge_kutta;
pub mod vector;
