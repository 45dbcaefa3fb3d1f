//! Components: machine parts with friction that no normal force presses together, one per file.
//!
//! Sign: `velocity` is that of body 1 relative to body 2, `friction_force` is the resistance to it, which body 1 feels
//! with a negative sign, as for the laws of friction.

crate::model::family! {
    magnetorheological_damper::MagnetorheologicalDamper,
    rubber_mount::RubberMount,
    gear_efficiency::GearEfficiency,
    servo_friction::ServoFriction,
    capstan::Capstan,
}

pub(crate) use magnetorheological_damper::{MagnetorheologicalFluid, MagnetorheologicalState};
pub(crate) use rubber_mount::{Rubber, RubberState};
