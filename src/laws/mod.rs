//! Pure functions that several models share: numbers in, numbers out.

pub mod relaxation;
pub mod specker;
pub mod stopping;
pub mod stribeck;
