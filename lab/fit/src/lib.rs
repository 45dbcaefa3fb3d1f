//! Measurement files, and the parameters that are identified from them.
//!
//! [`tir`] reads tyre property files; tables are read by [`stribeck_sheet`]. [`dyno`] computes a
//! [`ParameterSet`](ssp::parameter_set::ParameterSet) from a damper test, [`measured`] the friction in the records of a
//! rig, and [`identify`] fits a law to it. [`rig`] simulates such records, [`thesis`] has published figures to compare
//! with.

pub mod dyno;
pub mod identify;
pub mod measured;
pub mod rig;
pub mod thesis;
pub mod tir;
