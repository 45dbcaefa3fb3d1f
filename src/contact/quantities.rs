//! The dictionary of columns: one name, one quantity, in every law that has it. A law that deviates says so where it
//! declares its column.

use super::elements::{self, ElementDistribution};
use crate::model::{Column, Meaning, boolean, integer, real};

/// Declares columns: the comment is the help text as well.
macro_rules! quantities {
    ($($(#[doc = $help:literal])+ $NAME:ident = $column:expr;)+) => {
        $($(#[doc = $help])+ pub const $NAME: Column = $column.help(concat!($($help),+));)+
    };
}

quantities! {
    // Inputs.
    /// Sliding velocity of body 1 relative to body 2.
    VELOCITY = real("m/s", 0.0).shown_in("mm/s").odd().means(Meaning::Velocity);
    /// Velocity of body 1 relative to body 2, component x.
    VELOCITY_X = real("m/s", 0.0).shown_in("mm/s").odd().means(Meaning::Velocity);
    /// Velocity of body 1 relative to body 2, component y.
    VELOCITY_Y = real("m/s", 0.0).shown_in("mm/s").odd().means(Meaning::VelocityY);
    /// Normal force that presses the surfaces together.
    NORMAL_FORCE = real("N", 9.81).at_least(0.0).means(Meaning::NormalForce);
    /// Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates.
    EXTERNAL_FORCE = real("N", 0.0).odd().means(Meaning::ExternalForce);

    // Levels of friction.
    /// Kinetic coefficient of friction.
    MU_K = real("1", 0.1).at_least(0.0).means(Meaning::KineticLevel);
    /// Static coefficient of friction; not less than mu_k.
    MU_S = real("1", 0.15).at_least(0.0).means(Meaning::StaticLevel);
    /// Speed at which the excess of static over kinetic friction has fallen to 1/e.
    STRIBECK_VELOCITY = real("m/s", 0.001).positive().shown_in("mm/s").means(Meaning::FallSpeed);
    /// Exponent of the Stribeck curve.
    STRIBECK_EXPONENT = real("1", 2.0).positive().means(Meaning::Shape);
    /// Rate at which the excess of static over kinetic friction decays with speed (default chosen).
    STICTION_DECAY = real("s/m", 1000.0).positive().nominal(1e3).means(Meaning::Own);
    /// Viscous friction coefficient.
    VISCOUS_COEFFICIENT = real("N.s/m", 0.0).at_least(0.0).means(Meaning::Viscous);
    /// Time by which the level of friction lags behind the velocity (default chosen).
    TIME_LAG = real("s", 0.005).at_least(0.0).nominal(1e-3).shown_in("ms").means(Meaning::Own);

    // Regularised band around rest.
    /// Velocity that sets the width of the regularised band around rest.
    TRANSITION_VELOCITY = real("m/s", 0.001).positive().shown_in("mm/s").means(Meaning::TransitionSpeed);
    /// Slope of the force at rest, relative to the level there.
    TRANSITION_SLOPE = real("s/m", 10_000.0).positive().nominal(1e3).means(Meaning::Own);
    /// Velocity at which the kinetic level is reached.
    SLIDING_VELOCITY = real("m/s", 0.001).positive().shown_in("mm/s").means(Meaning::Own);
    /// Velocity at which the static level is reached (default chosen).
    PEAK_VELOCITY = real("m/s", 0.0005).positive().shown_in("mm/s").means(Meaning::Own);

    // Bristles.
    /// Stiffness of the bristles.
    SIGMA_0 = real("N/m", 1e5).positive().nominal(1e5).means(Meaning::Stiffness);
    /// Damping of the bristles.
    SIGMA_1 = real("N.s/m", 316.227_766_016_837_94).at_least(0.0).nominal(300.0).means(Meaning::Damping);
    /// Speed at which the damping of the bristles fades; 0 = constant damping.
    DAMPING_VELOCITY = real("m/s", 0.0).at_least(0.0).shown_in("mm/s").means(Meaning::Own);
    /// Part of the deflection of steady sliding up to which the contact is purely elastic.
    BREAKAWAY_RATIO = real("1", 0.7).positive().at_most(1.0).means(Meaning::Own);

    // Maxwell-slip elements.
    /// Where the shares of the elements come from.
    DISTRIBUTION = ElementDistribution::Explicit.start();
    /// Number of elements in use (default chosen).
    ELEMENT_COUNT = integer(4).at_least(1.0).at_most(elements::MOST as f64).means(Meaning::ElementCount);
    /// Force of the element.
    ELEMENT_FORCE = real("N", 0.0).odd();
    /// Is the element slipping?
    ELEMENT_SLIPPING = boolean(false);

    // States.
    /// Mean elastic deflection of the bristles.
    BRISTLE_DEFLECTION = real("m", 0.0).nominal(1e-5).shown_in("um").odd().means(Meaning::Deflection);
    /// Elastic deflection of the bristles, component x.
    BRISTLE_DEFLECTION_X = real("m", 0.0).nominal(1e-5).shown_in("um").odd();
    /// Elastic deflection of the bristles, component y.
    BRISTLE_DEFLECTION_Y = real("m", 0.0).nominal(1e-5).shown_in("um").odd();
    /// Velocity that determines the friction level: delayed by the time lag, or filtered.
    LAGGED_VELOCITY = real("m/s", 0.0).nominal(1e-3).shown_in("mm/s").odd().means(Meaning::Lagged);
    /// Has the contact broken away?
    SLIPPING = boolean(false);
    /// Is the contact stuck since the last step? Only with mass > 0; in Model Exchange see phase.
    STUCK = boolean(false);
    /// Energy taken out of the motion since the start.
    DISSIPATED_ENERGY = real("J", 0.0).nominal(1e-3).means(Meaning::Energy);

    // Outputs.
    /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
    FRICTION_FORCE = real("N", 0.0).odd().means(Meaning::FrictionForce);
    /// Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative.
    FRICTION_FORCE_X = real("N", 0.0).odd().means(Meaning::FrictionForce);
    /// Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative.
    FRICTION_FORCE_Y = real("N", 0.0).odd();
    /// Power taken out of the motion: friction force times velocity.
    DISSIPATED_POWER = real("W", 0.0);
    /// Is the contact sticking?
    STICKING = boolean(false).means(Meaning::Sticking);
}
