//! Pure functions that several models share: numbers in, numbers out.

pub mod approach;
pub mod relaxation;
pub mod stopping;
pub mod stribeck;
pub mod vector;
