//! The bench of Stribeck: parameter sets and the files they come from.
//!
//! A [`parameter_set`] holds values for the variables of one model, checked against the model's table; [`dyno`] makes
//! one from what a damper dynamometer has measured, [`tir`] from a tyre property file.

pub mod dyno;
pub mod parameter_set;
pub mod tir;
