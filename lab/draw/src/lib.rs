//! Diagrams as SVG, without colours and fonts: axes with ticks and units, the frame, curves, numbers.
//!
//! The workbench draws its pictures with it, the documentation of the FMUs its figures.

pub mod axis;
pub mod curve;
pub mod frame;
pub mod text;
