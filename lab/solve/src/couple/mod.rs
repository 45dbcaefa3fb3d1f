//! Systems advanced by the steps of their own models: for laws that have no rates, and as a master of co-simulation does.

mod by_steps;
mod co_simulation;
mod train;

pub use by_steps::{by_steps, check_steps};
pub use co_simulation::{Exchange, Master, co_simulation, hold};
pub use train::{Recorded, Train, is_host};

#[cfg(test)]
mod tests;
