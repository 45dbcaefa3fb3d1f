//! Files that people have, and what is found in them.
//!
//! [`sheet`] reads tables, [`tir`] tyre property files. [`dyno`] makes a
//! [`ParameterSet`](ssp::parameter_set::ParameterSet) from the measurements of a damper dynamometer, [`measured`] makes
//! friction of what a rig has recorded, and [`identify`] finds the parameters of a law in it. [`rig`] records what a law
//! would do, to try all this on. [`thesis`] has figures to compare with.

pub mod dyno;
pub mod identify;
pub mod measured;
pub mod rig;
pub mod sheet;
pub mod thesis;
pub mod tir;
