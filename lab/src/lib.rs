//! The bench of Stribeck: files of dampers and tyres, from which parameter sets are made.
//!
//! [`dyno`] makes a [`ParameterSet`](ssp::parameter_set::ParameterSet) from the measurements of a damper dynamometer,
//! [`tir`] from a tyre property file.

pub mod dyno;
pub mod tir;
