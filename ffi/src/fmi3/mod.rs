//! The functions of FMI 3.0 for co-simulation and Model Exchange, as the standard's headers declare them.
//!
//! Every call on an instance passes the same checks as in FMI 2.0: null pointer, state (the table in [`lifecycle`]), panic,
//! log. Scheduled execution, clocks, binary variables and texts are refused: no model has any.
//!
//! For every call on an instance `instance` must be NULL or an instance made by [`setup::fmi3InstantiateCoSimulation`] or
//! [`setup::fmi3InstantiateModelExchange`] and not yet freed; one instance must not be used by two threads at once, while
//! different instances may.
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals, reason = "the names of the standard")]

mod component;
pub mod derivatives;
pub mod exchange;
mod layout;
pub mod lifecycle;
mod log;
pub mod setup;
pub mod snapshot;
pub mod step;
pub mod types;
pub mod unused;
pub mod values;

#[cfg(test)]
mod tests;
