//! Laws of friction that several models share: numbers in, numbers out.

pub mod branches;
pub mod elasto_plastic;
pub mod passivity;
pub mod regularised;
pub mod specker;
pub mod stribeck;
pub mod viscous;
