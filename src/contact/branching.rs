//! The common part of the laws that distinguish acceleration from deceleration.

use crate::contact::motion::Motion;
use crate::model::{Meaning, real};
use crate::number::{Real, choose};

crate::part! {
    /// Source of the acceleration of the contact.
    Branching {
        /// Acceleration of body 1 relative to body 2; used if the velocity has no slope.
        acceleration: input = real("m/s2", 0.0).odd().means(Meaning::Acceleration),
        /// Slope of the velocity over the last step; 0 if it was held.
        velocity_slope: state = real("m/s2", 0.0).odd(),
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
