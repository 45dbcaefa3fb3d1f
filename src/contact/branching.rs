//! The common part of the laws that distinguish acceleration from deceleration.

use crate::contact::motion::Motion;
use crate::model::{Meaning, real};
use crate::number::{Real, choose};

crate::choices! {
    /// How a law knows whether the contact speeds up or slows down.
    pub enum AccelerationSource {
        /// From the slope of the velocity or, without one, from the input acceleration.
        Input,
        /// From the balance of the external force and friction.
        Balance,
    }
}

crate::part! {
    /// Source of the acceleration of the contact.
    Branching {
        /// Acceleration of body 1 relative to body 2; used if the velocity has no slope.
        acceleration: input = real("m/s2", 0.0).odd().means(Meaning::Acceleration),
        /// Slope of the velocity over the last step; 0 if it was held.
        velocity_slope: state = real("m/s2", 0.0).discrete().odd(),
    }
}

impl<T: Real> Branching<T> {
    /// Slope of the velocity if there is one, otherwise the input.
    pub(crate) fn known_acceleration(&self) -> T {
        choose!(self.velocity_slope.vanishes(), self.acceleration, self.velocity_slope)
    }
}

impl Branching {
    /// Begins a step with these inputs.
    pub(crate) fn begin(&mut self, motion: &Motion) {
        self.velocity_slope = motion.acceleration;
    }
}
