//! The functions of FMI 2.0 for co-simulation and Model Exchange, as the standard's headers declare them.
//!
//! Every call on an instance passes the same checks: null pointer, state (the table in [`lifecycle`]), panic, log. The
//! entry points are written out because cbindgen cannot see the output of macros.
//!
//! For every call on an instance `c` must be NULL or an instance made by [`setup::fmi2Instantiate`] and not yet freed;
//! one instance must not be used by two threads at once, while different instances may.
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals, reason = "the names of the standard")]

mod component;
pub mod exchange;
pub mod lifecycle;
pub mod log;
pub mod setup;
pub mod snapshot;
pub mod step;
pub mod types;
pub mod values;

#[cfg(test)]
mod tests;
