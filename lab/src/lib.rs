//! The bench of Stribeck: parameter sets and the files from which they are made.
//!
//! A [`parameter_set`] holds values for the variables of one model, checked against the model's table; [`dyno`] makes
//! one from the measurements of a damper dynamometer, [`tir`] from a tyre property file.

pub mod dyno;
pub mod parameter_set;
pub mod tir;
