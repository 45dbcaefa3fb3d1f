//! Pure functions that several models share: numbers in, numbers out.

pub mod approach;
pub mod branches;
pub mod elasto_plastic;
pub mod end_velocity;
pub mod motion;
pub mod quadrature;
pub mod regularised;
pub mod relaxation;
pub mod root;
pub mod runge_kutta;
pub mod specker;
pub mod stopping;
pub mod stribeck;
pub mod table;
pub mod turning;
pub mod vector;
pub mod viscous;
