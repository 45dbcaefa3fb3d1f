//! Hosts: the mechanical systems that carry friction models and struts in a test.

mod integrate;
pub mod vertical;

crate::model::family! {
    belt_rig::BeltRig,
    quarter_car::QuarterCar,
    four_post_car::FourPostCar,
    double_track_car::DoubleTrackCar,
    posts::Posts,
}

mod magic_formula;
pub use magic_formula::{Contact, MagicFormula, Side, Wrench};
