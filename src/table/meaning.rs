//! What a variable is for, whatever it is called.

/// The part that a variable plays in a law of friction, or where a model is connected to another. What is read of it
/// elsewhere (by a strut, in ramps of the inputs, in a fit, on a page, for a terminal of an FMU) is found by this, not by
/// its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Meaning {
    /// Nothing was declared.
    Undeclared,
    /// A quantity that only the law itself knows; others know its unit.
    Own,

    /// Input: sliding velocity; in the plane and in space its component along x.
    Velocity,
    /// Input: component of the velocity along y.
    VelocityY,
    /// Input: force that presses the surfaces together.
    NormalForce,
    /// Input: resultant of all other tangential forces.
    ExternalForce,
    /// Input: acceleration, for laws that differ as the contact speeds up or slows down.
    Acceleration,
    /// Force of a motor, before a gear that rubs.
    MotorForce,
    /// Force of a load, behind a gear that rubs.
    LoadForce,
    /// Mass of the body that is held at rest.
    Mass,
    /// Order in which a master exchanges values.
    Exchange,

    /// Length of a strut, eye to eye; its rate is its velocity.
    StrutLength,
    /// Force of a strut; positive pushes its eyes apart.
    StrutForce,
    /// Force of a strut without its friction.
    ForceWithoutFriction,
    /// Part of the force of a strut that moves its rod, and not what the rod's eye is mounted on.
    RodForce,
    /// Height of the ground under a wheel.
    GroundHeight,
    /// Rate of that height.
    GroundVelocity,

    /// Coefficient of the kinetic level of friction.
    KineticLevel,
    /// Coefficient of the static level of friction.
    StaticLevel,
    /// Coefficient of another level of friction.
    Level,
    /// Level of friction without load, a force.
    Preload,
    /// Viscous coefficient: force by velocity.
    Viscous,
    /// Coefficient of another part that grows with speed.
    GrowsWithSpeed,
    /// Speed at which friction falls from the static to the kinetic level.
    FallSpeed,
    /// Speed that sets the width of a regularised band around rest.
    TransitionSpeed,
    /// Speed to which a logarithmic law refers: another one is the same law with other levels, so that a fit holds it.
    ReferenceSpeed,
    /// Exponent, order or share: a shape of the law, which a fit holds unless it is asked to fit it.
    Shape,
    /// Condition of the surroundings, such as a temperature: a parameter that a record may have at each sample, so that a
    /// fit holds it.
    Condition,
    /// Coefficient of the effect of a condition, which a fit holds unless the condition changes in a record.
    EffectOfCondition,
    /// Stiffness of the contact.
    Stiffness,
    /// Damping of the contact.
    Damping,
    /// Total strength of the elements, as a multiple of the static level.
    Strength,
    /// Number of elements.
    ElementCount,
    /// Variant of the law.
    Variant,

    /// State: mean elastic deflection of the contact, whose force is carried.
    Deflection,
    /// State: strain of one of many bonds, which the motion strains alike.
    Strain,
    /// State: displacement of the host, from which a record begins.
    Displacement,
    /// State: energy taken out of the motion.
    Energy,
    /// State: value of a quantity a time lag ago, or filtered.
    Lagged,
    /// State: part of the past that steps keep; a solver with rates keeps its own.
    History,
    /// Output: friction force; in the plane and in space its component along x.
    FrictionForce,
    /// Output: whether the contact sticks.
    Sticking,
}
