//! Sticking for a host that integrates the body itself: the friction force of a time-stepping scheme.
//!
//! A law that returns only a force cannot hold a body still in co-simulation: the body's velocity is never exactly zero
//! at a communication point, so the force alternates. If the law knows the body's mass m and the step h, it can return
//! the force that ends the step at rest,
//!
//! ```text
//! m (0 - v) / h = f_e - f      =>      f = f_e + m v / h
//! ```
//!
//! as long as that force is within the friction level. This is time stepping in the sense of J. J. Moreau, "Unilateral
//! contact and dry friction in finite freedom dynamics" (1988), doi:10.1007/978-3-7091-2624-0_1: friction is an impulse
//! over the step, chosen such that the velocity after it satisfies the law.

use crate::number::Real;

/// The force that stops a body of mass `mass` within `step_size`: f_e + m v / h.
#[inline]
pub fn force_to_stop<T: Real>(velocity: T, external_force: T, mass: T, step_size: T) -> T {
    external_force + mass * velocity / step_size
}

/// The friction force over a step, given the force that would stop the body in it.
///
/// * At rest: the stopping force, up to the static level.
/// * Sliding, and the kinetic level does not suffice to stop the body: the kinetic level, against the motion.
/// * Sliding, and the body comes to rest within the step: it is captured, and from then on held up to the static level.
#[inline]
pub fn friction<T: Real>(stopping: T, velocity: T, at_rest: bool, kinetic: T, statical: T) -> T {
    if is_held(stopping, velocity, at_rest, kinetic, statical) {
        stopping
    } else if at_rest {
        stopping.limited(statical)
    } else {
        stopping.limited(kinetic)
    }
}

/// Is the body at rest at the end of the step?
#[inline]
pub fn is_held<T: Real>(stopping: T, velocity: T, at_rest: bool, kinetic: T, statical: T) -> bool {
    let comes_to_rest = at_rest || stopping * velocity.sign() <= kinetic;
    comes_to_rest && stopping.abs() <= statical
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINETIC: f64 = 1.0;
    const STATIC: f64 = 1.5;

    /// Velocity after a step of 1 ms of a body of 2 kg.
    fn after(velocity: f64, external: f64, stuck: bool) -> (f64, f64) {
        let stopping = force_to_stop(velocity, external, 2.0, 1e-3);
        let force = friction(stopping, velocity, stuck, KINETIC, STATIC);
        (force, velocity + 1e-3 * (external - force) / 2.0)
    }

    #[test]
    fn a_held_body_stops_exactly() {
        for external in [-1.49, -0.3, 0.0, 1.2] {
            let (_, velocity) = after(1e-6, external, true);
            assert!(velocity.abs() < 1e-18, "{external}: {velocity}");
        }
    }

    #[test]
    fn a_fast_body_feels_the_kinetic_level() {
        assert_eq!(after(0.3, 0.2, false).0, KINETIC);
        assert_eq!(after(-0.3, 0.2, false).0, -KINETIC);
    }

    #[test]
    fn overload_breaks_away_at_the_static_level() {
        assert_eq!(after(0.0, 1.6, true).0, STATIC);
        assert_eq!(after(0.0, -1.6, true).0, -STATIC);
    }

    /// Between the levels: a body pushed back while it still moves is caught at rest and held by static friction.
    #[test]
    fn a_body_that_turns_is_caught_between_the_levels() {
        let (force, velocity) = after(1e-5, -1.3, false);
        assert!((force + 1.28).abs() < 1e-12 && velocity.abs() < 1e-18, "{force} {velocity}");
        // Above the static level it passes through rest and slides back.
        let (force, velocity) = after(1e-5, -1.9, false);
        assert!(force == -KINETIC && velocity < 0.0, "{force} {velocity}");
    }

    /// A body that keeps sliding is never captured by the static level.
    #[test]
    fn static_friction_does_not_catch_a_driven_body() {
        assert_eq!(after(1e-5, 1.3, false).0, KINETIC);
    }
}
