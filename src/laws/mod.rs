//! Pure functions that several models share: numbers in, numbers out.

pub mod approach;
pub mod elasto_plastic;
pub mod relaxation;
pub mod runge_kutta;
pub mod stopping;
pub mod stribeck;
pub mod vector;
