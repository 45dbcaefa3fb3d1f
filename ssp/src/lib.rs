//! Files of SSP 1.0 (System Structure and Parameterization) for the models of Stribeck.
//!
//! A [`parameter_set`] holds values for the variables of one model, checked against the model's table; a [`system`] is
//! models joined by connections.

pub mod parameter_set;
pub mod system;
mod units;
mod xml;
