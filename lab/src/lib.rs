//! The bench of Stribeck: files of dampers and tyres, from which parameter sets are made, and systems of models, solved
//! to a tolerance.
//!
//! [`dyno`] makes a [`ParameterSet`](ssp::parameter_set::ParameterSet) from the measurements of a damper dynamometer,
//! [`tir`] from a tyre property file. [`measured`] makes friction of what a rig has recorded, and [`identify`] finds the
//! parameters of a law in it. [`system`] joins models, [`solve`] has the solvers, [`run`] runs them, [`study`] many of
//! them, [`picture`] draws what came of it, and [`report`] tells it all in one file.

#[cfg(feature = "workbench")]
pub mod benchmark;
#[cfg(feature = "workbench")]
pub mod couple;
pub mod dyno;
#[cfg(feature = "workbench")]
pub mod identify;
#[cfg(feature = "workbench")]
pub mod measured;
#[cfg(feature = "workbench")]
pub mod picture;
#[cfg(feature = "workbench")]
pub mod report;
#[cfg(feature = "workbench")]
pub mod rig;
#[cfg(feature = "workbench")]
pub mod run;
pub mod sheet;
#[cfg(feature = "workbench")]
pub mod solve;
#[cfg(feature = "workbench")]
pub mod study;
#[cfg(feature = "workbench")]
pub mod system;
pub mod tir;
