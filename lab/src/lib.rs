//! The bench of Stribeck: parameter sets and the files they come from.
//!
//! A [`parameter_set`] holds values for the variables of one model, checked against the model's table.

pub mod parameter_set;
pub mod tir;
