//! Measured friction: force and motion of a slider on a rig, and the friction that follows from them.
//!
//! A slider is dragged to and fro through a load cell. With the force F of the load cell on the slider, the mass m
//! between load cell and contact, and the acceleration a, in both strokes:
//!
//! ```text
//! f_f = F - m a
//! ```
//!
//! | symbol | unit | meaning                                                        |
//! |--------|------|----------------------------------------------------------------|
//! | F      | N    | force on the slider, positive in the direction of displacement |
//! | m      | kg   | mass between load cell and contact                             |
//! | a      | m/s2 | acceleration of the slider                                     |
//! | f_f    | N    | friction force, with the sign of the velocity when sliding     |
//!
//! # Sign
//! Force, displacement and velocity are positive in the same direction, so that friction takes energy out of the
//! motion; a file in which it adds energy is rejected.
//!
//! # Source
//! Rig and balance of forces: chapter 8 of F. Novais, "A critical analysis on friction force models in dynamical
//! systems", MSc thesis, University of Minho (2024).

mod clock;
mod columns;
mod cycle;
mod drive;
mod error;
mod matched_filter;
mod movement;
mod plausible;
mod polynomial;
mod quality;
mod record;
mod reduce;
mod statistics;
mod stencil;
#[cfg(test)]
mod tests;
mod units;
mod window;

pub use clock::Clocks;
pub use columns::Columns;
pub use cycle::{Cycle, average, interpolate};
pub use drive::Drive;
pub use error::MeasuredError;
pub use matched_filter::SLOW;
pub use movement::{Movement, Units};
pub use polynomial::correlation_of_slopes;
pub use quality::noise;
pub use record::{Channel, Delay, Direction, Gap, MatchedFilter, Quality, Record, Setup};
pub use reduce::load;
pub use statistics::extremes;
pub use statistics::{OF_MEDIAN, median, reversals};
