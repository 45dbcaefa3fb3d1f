//! The telescopic shock absorber and its parts, one per file. Each part is also a model of its own.
//!
//! Sign: `length` is the distance of the eyes, `velocity` its time derivative, positive in extension; forces are
//! positive when they push the eyes apart. Friction forces and damper resistances have the sign of `velocity`.

crate::model::family! {
    shock_absorber::ShockAbsorber,
    telescopic_joint::TelescopicJoint,
    guide_contact::GuideContact,
    coil_spring::CoilSpring,
    gas_spring::GasSpring,
    end_stops::EndStops,
    hydraulic_damper::HydraulicDamper,
    damper_temperature::DamperTemperature,
}

mod advice;
mod coupling;
mod fluid_state;
mod geometry;
mod law;
mod law_list;
mod law_parameters;
mod law_plan;
mod memories;
mod mount;
mod mounted;
mod presets;
mod setting;

pub use law_list::{NO_LAW, choice_of_law};

/// Largest number of internal steps within a communication step (chosen); beyond it, they become longer than requested.
const MOST_SUBSTEPS: u32 = 10_000;

/// Number of equal internal steps of at most `largest` that make up a step. A step that is longer only by rounding does
/// not need another one.
fn substeps(dt: f64, largest: f64) -> u32 {
    ((dt / largest - 1e-6).ceil() as u32).clamp(1, MOST_SUBSTEPS)
}
