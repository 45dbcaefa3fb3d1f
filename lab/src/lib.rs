//! The bench of Stribeck: files of dampers and tyres, from which parameter sets are made, and systems of models, solved
//! to a tolerance.
//!
//! [`dyno`] makes a [`ParameterSet`](ssp::parameter_set::ParameterSet) from the measurements of a damper dynamometer,
//! [`tir`] from a tyre property file. [`measured`] makes friction of what a rig has recorded, and [`identify`] finds
//! the parameters of a law in it. [`system`] joins models, [`solve`] has the solvers, [`run`] runs them, [`study`] many
//! of them, [`picture`] draws what came of it in the colours of [`palette`], and [`report`] tells it all in one file.
//! [`thesis`] has figures to compare with.
//!
//! Systems and solvers use the elementary functions of the models only: a run has the same bits on every platform and
//! in a browser.

#[cfg(feature = "workbench")]
pub mod benchmark;
#[cfg(feature = "systems")]
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod couple;
pub mod dyno;
#[cfg(feature = "rigs")]
pub mod identify;
#[cfg(feature = "rigs")]
pub mod measured;
#[cfg(feature = "systems")]
pub mod palette;
#[cfg(feature = "workbench")]
pub mod picture;
#[cfg(feature = "workbench")]
pub mod report;
#[cfg(feature = "rigs")]
pub mod rig;
#[cfg(feature = "systems")]
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod run;
pub mod sheet;
#[cfg(feature = "systems")]
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod solve;
#[cfg(feature = "workbench")]
pub mod study;
#[cfg(feature = "systems")]
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod system;
#[cfg(feature = "systems")]
pub mod thesis;
pub mod tir;
