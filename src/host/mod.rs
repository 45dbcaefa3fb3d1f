//! Hosts: the mechanical systems that carry friction models and struts in a test.

mod oscillator;
pub mod vertical;

crate::model::family! {
    belt_rig::BeltRig,
    quarter_car::QuarterCar,
    four_post_car::FourPostCar,
    double_track_car::DoubleTrackCar,
    posts::Posts,
    belt_drive::BeltDrive,
    two_blocks::TwoBlocks,
    incline::Incline,
    pulled_mass::PulledMass,
    axis::Axis,
    servo_arm::ServoArm,
    top_mount::TopMount,
    position_control::PositionControl,
}

mod magic_formula;
mod magic_formula_5;
mod magic_formula_6;
mod tyre_radii;
mod tyre_spring;
pub use magic_formula::{Contact, FormulaVersion, MagicFormula, Side, Wrench};
pub use tyre_radii::{NoRadii, Radii, Rolling};
pub use tyre_spring::TyreSpring;
