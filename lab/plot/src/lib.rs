//! Pictures and reports.
//!
//! [`picture`] draws runs and curves in the colours of [`palette`]; [`report`] puts a run or an identification into one
//! file.

pub mod palette;
pub mod picture;
pub mod report;
