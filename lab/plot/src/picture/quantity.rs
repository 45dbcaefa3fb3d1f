//! Quantities that pictures show.

/// Quantity on an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Time.
    Time,
    /// Position of a body.
    Position,
    /// Displacement between two bodies.
    Displacement,
    /// Velocity between two bodies.
    Velocity,
    /// Acceleration of a body.
    Acceleration,
    /// Friction force.
    Force,
    /// Angle of a joint.
    Angle,
    /// Angular velocity of a joint.
    AngularVelocity,
    /// Angular acceleration of a joint.
    AngularAcceleration,
    /// Friction torque.
    Torque,
    /// Evaluations of the equations.
    Evaluations,
    /// Error of a motion.
    Error,
    /// Error of the times of switching.
    SwitchingError,
    /// Side slip of a tyre.
    SideSlip,
    /// Longitudinal slip of a tyre.
    LongitudinalSlip,
    /// Side force of a tyre.
    SideForce,
    /// Longitudinal force of a tyre.
    LongitudinalForce,
    /// Aligning moment of a tyre.
    AligningMoment,
}

impl Quantity {
    /// The quantity in a unit: that of a joint in the units of rotation.
    pub fn in_unit(self, unit: &str) -> Quantity {
        let turned = match self {
            Quantity::Position | Quantity::Displacement => Quantity::Angle,
            Quantity::Velocity => Quantity::AngularVelocity,
            Quantity::Acceleration => Quantity::AngularAcceleration,
            Quantity::Force => Quantity::Torque,
            other => other,
        };
        if turned.unit() == unit { turned } else { self }
    }

    /// SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::Time | Quantity::SwitchingError => "s",
            Quantity::Position | Quantity::Displacement | Quantity::Error => "m",
            Quantity::Velocity => "m/s",
            Quantity::Acceleration => "m/s2",
            Quantity::Force | Quantity::SideForce | Quantity::LongitudinalForce => "N",
            Quantity::AligningMoment | Quantity::Torque => "N.m",
            Quantity::SideSlip | Quantity::Angle => "rad",
            Quantity::AngularVelocity => "rad/s",
            Quantity::AngularAcceleration => "rad/s2",
            Quantity::Evaluations | Quantity::LongitudinalSlip => "1",
        }
    }

    /// Name, letter and index.
    pub fn names(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Quantity::Time => ("Time", "t", ""),
            Quantity::Position => ("Position", "x", ""),
            Quantity::Displacement => ("Displacement", "x", ""),
            Quantity::Velocity => ("Relative velocity", "v", ""),
            Quantity::Acceleration => ("Acceleration", "a", ""),
            Quantity::Force => ("Friction force", "f", "f"),
            Quantity::Angle => ("Angle", "\u{3c6}", ""),
            Quantity::AngularVelocity => ("Angular velocity", "\u{3c9}", ""),
            Quantity::AngularAcceleration => ("Angular acceleration", "\u{3b1}", ""),
            Quantity::Torque => ("Friction torque", "\u{3c4}", "f"),
            Quantity::Evaluations => ("Evaluations of the rates", "n", ""),
            Quantity::Error => ("Largest error of the position", "e", "x"),
            Quantity::SideSlip => ("Side slip", "\u{3b1}", ""),
            Quantity::LongitudinalSlip => ("Longitudinal slip", "\u{3ba}", ""),
            Quantity::SideForce => ("Side force", "F", "y"),
            Quantity::LongitudinalForce => ("Longitudinal force", "F", "x"),
            Quantity::AligningMoment => ("Aligning moment", "M", "z"),
            Quantity::SwitchingError => ("Largest error of a time of switching", "e", "t"),
        }
    }
}
