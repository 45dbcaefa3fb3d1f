//! The C interfaces of the models: FMI 2.0 ([`fmi2`]), FMI 3.0 ([`fmi3`]) and the functions of `stribeck.h` ([`c`]).
//!
//! Every call passes one guard, which checks the pointers, restores the floating-point mode of the host, and turns a
//! panic into a status with a message.

pub mod c;
mod component;
pub mod fmi2;
pub mod fmi3;
mod guard;
mod models;
#[cfg(test)]
mod probe;
