//! Systems of Stribeck's models, solved to a tolerance.
//!
//! [`system`] joins models, [`solve`] has the solvers, [`couple`] steps models together as importers do, [`run`] runs a
//! system once, [`study`] many times. [`job`] has what the descriptions of all jobs have in common, [`work`] the threads.
//!
//! Systems and solvers use the elementary functions of the models only: a run has the same bits on every platform and
//! in a browser.

#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod couple;
pub mod job;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod run;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod solve;
pub mod study;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod system;
pub mod work;

#[cfg(test)]
#[path = "../tests/common/stick_slip.rs"]
mod stick_slip;
