//! State of a contact at a communication point and its motion over a step, shared by models.

pub mod branching;
pub(crate) mod conditions;
pub(crate) mod delay_line;
pub(crate) mod element_limits;
pub(crate) mod element_path;
pub(crate) mod element_slip;
pub(crate) mod elements;
pub mod end_velocity;
pub mod motion;
pub(crate) mod planar;
pub mod quantities;
pub mod stopping;
pub(crate) mod time_stepping;
pub mod turning;
pub(crate) mod unloading;

pub(crate) use time_stepping::ExchangeOrder;
