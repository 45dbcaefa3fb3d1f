//! The inputs of a contact over an interval in which they move linearly.

/// Velocity and normal force over an interval that begins at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Velocity at the beginning.
    pub velocity: f64,
    /// Slope of the velocity.
    pub acceleration: f64,
    /// Normal force at the beginning.
    pub load: f64,
    /// Slope of the normal force.
    pub load_rate: f64,
    /// Length of the interval.
    pub duration: f64,
}

impl Motion {
    /// Constant inputs.
    pub fn held(velocity: f64, load: f64, duration: f64) -> Motion {
        Motion { velocity, acceleration: 0.0, load, load_rate: 0.0, duration }
    }

    /// Velocity at time `t`.
    pub fn velocity_at(&self, t: f64) -> f64 {
        self.velocity + self.acceleration * t
    }

    /// Normal force at time `t`; bodies that have separated do not pull.
    pub fn load_at(&self, t: f64) -> f64 {
        (self.load + self.load_rate * t).max(0.0)
    }

    /// Displacement from the beginning to time `t`.
    pub fn path(&self, t: f64) -> f64 {
        (self.velocity + 0.5 * self.acceleration * t) * t
    }

    /// Whether velocity and normal force are constant.
    pub fn is_steady(&self) -> bool {
        self.acceleration == 0.0 && self.load_rate == 0.0
    }

    /// Whether the velocity stays 0.
    pub fn is_at_rest(&self) -> bool {
        self.velocity == 0.0 && self.acceleration == 0.0
    }

    /// The interval from one instant to another; its own time begins at 0.
    pub fn part(&self, from: f64, to: f64) -> Motion {
        let (velocity, load) = (self.velocity_at(from), self.load_at(from));
        Motion { velocity, load, duration: to - from, ..*self }
    }

    /// Sign of the velocity (-1, 0 or 1), in an interval in which it does not change its sign.
    pub fn direction(&self) -> f64 {
        let middle = self.velocity_at(0.5 * self.duration);
        if middle == 0.0 { 0.0 } else { middle.signum() }
    }

    /// Whether the normal force is 0, in an interval in which it does not change its sign.
    pub fn is_unloaded(&self) -> bool {
        self.load_at(0.5 * self.duration) == 0.0
    }

    /// Parts in which neither velocity nor normal force changes its sign, in order.
    pub fn parts(self) -> impl Iterator<Item = Motion> {
        let end = self.duration;
        let zeros = [-self.velocity / self.acceleration, -self.load / self.load_rate];
        let [a, b] = zeros.map(|zero| if zero > 0.0 && zero < end { zero } else { end });
        let cuts = [0.0, a.min(b), a.max(b), end];
        (0..3).filter(move |k| cuts[k + 1] > cuts[*k]).map(move |k| self.part(cuts[k], cuts[k + 1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_end_where_an_input_passes_through_zero() {
        let motion = Motion { velocity: -1.0, acceleration: 2.0, load: 3.0, load_rate: -1.0, duration: 4.0 };
        let parts: Vec<Motion> = motion.parts().collect();
        assert_eq!(parts.iter().map(|part| part.duration).collect::<Vec<_>>(), [0.5, 2.5, 1.0]);
        assert_eq!(parts.iter().map(Motion::direction).collect::<Vec<_>>(), [-1.0, 1.0, 1.0]);
        assert_eq!(parts.iter().map(Motion::is_unloaded).collect::<Vec<_>>(), [false, false, true]);
        // The distance is the same: -1 * 4 + 2 * 4^2 / 2.
        assert_eq!(parts.iter().map(|part| part.path(part.duration)).sum::<f64>(), 12.0);
    }

    #[test]
    fn held_inputs_have_one_part() {
        for motion in [Motion::held(0.0, 0.0, 1e-300), Motion::held(-2.0, 5.0, 1e300)] {
            assert_eq!(motion.parts().collect::<Vec<_>>(), [motion]);
        }
        assert_eq!(Motion::held(0.0, 1.0, 1.0).direction(), 0.0);
        assert_eq!(Motion::held(-0.0, 1.0, 1.0).direction(), 0.0);
    }
}
