//! The documentation page and the icon of an FMU.

pub mod curve;
pub mod diagrams;
pub mod figure;
pub mod html;
pub mod icon;
pub mod mathematics;
pub mod motion;
pub mod sweep;
pub mod texts;
pub mod typeset;
