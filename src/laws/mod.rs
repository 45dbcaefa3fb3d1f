//! Pure functions that several models share: numbers in, numbers out.

pub mod end_velocity;
pub mod regularised;
pub mod relaxation;
pub mod stopping;
pub mod stribeck;
pub mod viscous;
