//! Parameters from measurements.
//!
//! [`dyno`] computes a [`ParameterSet`](ssp::parameter_set::ParameterSet) from a damper test, and [`identify`] fits a
//! law to the friction in records, which [`stribeck_measured`] reads. [`tir`] reads tyre property files. [`rig`]
//! simulates records, [`thesis`] has published figures to compare with.

pub mod dyno;
pub mod identify;
pub mod rig;
pub mod thesis;
pub mod tir;
