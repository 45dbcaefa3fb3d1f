//! Systems: models of the catalogue joined by connections, with signals at their free inputs.
//!
//! A system comes from a TOML file or is built in; [`System::assemble`] checks it and joins the parts. [`Motion`] is its
//! equations of motion, for the solvers.

mod bonds;
mod error;
mod file;
mod influence;
mod motion;
mod mover;
mod order;
mod part;
mod past;
mod signal;
mod slot;
mod values;
mod wiring;

pub use error::Fault;
pub use file::{BUILT_IN, Description, Source, read};
pub use motion::Motion;
pub use part::{Part, Place, System, Wire, WireSource};
pub use signal::Signal;
pub use values::{Setting, closest, spelled};

#[cfg(test)]
mod bonds_tests;
#[cfg(test)]
mod cylinder_tests;
#[cfg(test)]
mod event_tests;
#[cfg(test)]
mod past_tests;
#[cfg(test)]
mod servo_arm_tests;
#[cfg(test)]
mod servo_tests;
#[cfg(test)]
mod slider_tests;
#[cfg(test)]
mod steep_tests;
#[cfg(test)]
mod strut_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod wiring_tests;
