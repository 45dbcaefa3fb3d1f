//! The part of those laws that must hold a body at rest while a host integrates its motion.

use crate::laws::stopping::{force_to_stop, friction, is_held};
use crate::model::{boolean, real};
use crate::number::Real;

crate::choices! {
    /// In which order the master exchanges values with the friction model.
    pub enum Exchange {
        /// The host uses the force of the step just computed, or the force read after setting the inputs (Gauss-Seidel).
        Sequential,
        /// All models step at once and exchange values afterwards, so the force acts one step later (Jacobi).
        Parallel,
    }
}

crate::part! {
    /// Columns of a law that can hold a body of known mass.
    TimeStepping {
        /// Effective mass of the host, to hold it in co-simulation; 0 = the printed law.
        mass: tunable = real("kg", 0.0).at_least(0.0),
        /// Order in which the master exchanges values; used with mass > 0.
        exchange: fixed = Exchange::Sequential.start(),
        /// Is the contact stuck since the last step? Used with mass > 0.
        stuck: state = boolean(false),
        /// Length of the last step; 0 before the first one.
        step_size: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms"),
        /// Force planned for the coming step of a parallel exchange.
        planned_force: state = real("N", 0.0),
    }
}

/// What the law knows of the contact at a communication point.
#[derive(Clone, Copy)]
pub(crate) struct Contact<T> {
    pub velocity: T,
    pub external_force: T,
    /// Level while sliding, f_C.
    pub kinetic: T,
    /// Level at rest, f_s.
    pub statical: T,
    /// The body counts as at rest up to this speed (0: at rest exactly).
    pub band: T,
}

impl<T: Real> Contact<T> {
    fn is_at_rest(&self) -> bool {
        self.velocity.abs() <= self.band
    }

    /// The law without memory: kinetic level outside the band; inside it the external force, up to the static level.
    fn printed(&self) -> T {
        if self.is_at_rest() { self.external_force.limited(self.statical) } else { self.kinetic * self.velocity.sign() }
    }
}

impl<T: Real> TimeStepping<T> {
    /// The friction force at a communication point.
    pub(crate) fn force(&self, contact: &Contact<T>) -> T {
        if !self.is_active() {
            contact.printed()
        } else if self.is_parallel() {
            // The load may have fallen since the force was planned.
            self.planned_force.limited(contact.statical)
        } else {
            self.stepped(contact, self.step_size).0
        }
    }

    /// 1 if the contact is stuck, else 0.
    pub(crate) fn sticking(&self, contact: &Contact<T>) -> T {
        let sticking = if self.is_active() {
            self.stuck.value() != 0.0
        } else {
            contact.is_at_rest() && contact.external_force.abs() <= contact.statical
        };
        T::from(f64::from(u8::from(sticking && contact.statical.value() > 0.0)))
    }

    /// A body can be held as soon as its mass and the step are known.
    fn is_active(&self) -> bool {
        self.mass.value() > 0.0 && self.step_size.value() > 0.0
    }

    fn is_parallel(&self) -> bool {
        Exchange::of(self.exchange.value()) == Exchange::Parallel
    }

    /// The force over a step, and whether it holds the body.
    fn stepped(&self, contact: &Contact<T>, step_size: T) -> (T, bool) {
        let Contact { velocity, kinetic, statical, .. } = *contact;
        let at_rest = self.stuck.value() != 0.0 || contact.is_at_rest();
        let stopping = force_to_stop(velocity, contact.external_force, self.mass, step_size);
        (
            friction(stopping, velocity, at_rest, kinetic, statical),
            is_held(stopping, velocity, at_rest, kinetic, statical),
        )
    }
}

impl TimeStepping {
    /// Advances by `dt` with held inputs and returns the energy that the friction force took out of the motion.
    pub(crate) fn step(&mut self, contact: &Contact<f64>, dt: f64) -> f64 {
        if self.mass == 0.0 {
            return contact.printed() * contact.velocity * dt;
        }
        let is_first = self.step_size == 0.0;
        self.step_size = dt;
        if !self.is_parallel() {
            let (force, held) = self.stepped(contact, dt);
            self.stuck = f64::from(u8::from(held));
            return self.work(contact, force, dt);
        }
        // The host still applies the force of the last exchange; the next one is planned for where that takes the body.
        let applied = if is_first { contact.printed() } else { self.planned_force };
        let next = Contact { velocity: self.velocity_after(contact, applied, dt), ..*contact };
        let (force, held) = self.stepped(&next, dt);
        self.planned_force = force;
        self.stuck = f64::from(u8::from(held));
        self.work(contact, applied, dt)
    }

    fn velocity_after(&self, contact: &Contact<f64>, force: f64, dt: f64) -> f64 {
        contact.velocity + dt * (contact.external_force - force) / self.mass
    }

    /// Force times the mean velocity over the step.
    fn work(&self, contact: &Contact<f64>, force: f64, dt: f64) -> f64 {
        let mean = 0.5 * (contact.velocity + self.velocity_after(contact, force, dt));
        force * mean * dt
    }
}
