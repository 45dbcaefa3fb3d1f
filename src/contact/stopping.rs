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

/// Whether the body is at rest at the end of the step, given the force that would stop it within the step.
///
/// * At rest before: if the static level suffices.
/// * Sliding: if the kinetic level suffices to stop it, or if it would reverse; from then on the static level holds.
#[inline]
pub fn is_held<T: Real>(stopping: T, velocity: T, at_rest: T::Mask, kinetic: T, breakaway: T) -> T::Mask {
    let comes_to_rest = at_rest | (stopping * velocity.sign()).at_most(kinetic);
    comes_to_rest & stopping.abs().at_most(breakaway)
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINETIC: f64 = 1.0;
    const STATIC: f64 = 1.5;

    fn held(velocity: f64, external: f64, at_rest: bool) -> bool {
        let stopping = force_to_stop(velocity, external, 2.0, 1e-3);
        is_held(stopping, velocity, at_rest, KINETIC, STATIC)
    }

    /// The force is that of m (0 - v) / h = f_e - f.
    #[test]
    fn the_stopping_force_ends_the_step_at_rest() {
        for (velocity, external) in [(1e-6, -1.49), (-3e-4, 0.2), (0.0, 1.2)] {
            let force = force_to_stop(velocity, external, 2.0, 1e-3);
            let after: f64 = velocity + 1e-3 * (external - force) / 2.0;
            assert!(after.abs() < 1e-18, "{after}");
        }
    }

    #[test]
    fn a_body_at_rest_is_held_up_to_the_static_level() {
        assert!(held(0.0, 1.49, true) && held(1e-7, -1.49, true));
        assert!(!held(0.0, 1.51, true) && !held(0.0, -1.51, true));
    }

    #[test]
    fn a_fast_body_is_not_stopped() {
        assert!(!held(0.3, 0.2, false) && !held(-0.3, 0.2, false));
    }

    /// Between the levels: a body pushed back while it still moves is caught at rest and held by static friction.
    #[test]
    fn a_body_that_turns_is_caught_between_the_levels() {
        assert!(held(1e-5, -1.3, false));
        // Above the static level it passes through rest and slides back.
        assert!(!held(1e-5, -1.9, false));
    }

    /// A body that keeps sliding is never captured by the static level.
    #[test]
    fn static_friction_does_not_catch_a_driven_body() {
        assert!(!held(1e-5, 1.3, false));
    }
}
