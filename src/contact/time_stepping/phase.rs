//! Motion of a contact between two events of Model Exchange, and its end.

use crate::number::{Real, choose};

crate::choices! {
    /// Motion of a contact between two events of Model Exchange.
    pub enum Phase {
        /// Determined by the velocity: no event has set it, as in co-simulation.
        Free,
        /// Held, or within the band around rest.
        Held,
        /// Slides with positive velocity.
        Forward,
        /// Slides with negative velocity.
        Backward,
    }
}

impl Phase {
    pub(crate) fn sliding(direction: f64) -> Phase {
        if direction < 0.0 { Phase::Backward } else { Phase::Forward }
    }

    /// Direction of sliding, if an event has found the contact sliding.
    pub(crate) fn direction(self) -> Option<f64> {
        match self {
            Phase::Forward => Some(1.0),
            Phase::Backward => Some(-1.0),
            Phase::Free | Phase::Held => None,
        }
    }
}

/// The phase in a column.
#[derive(Clone, Copy)]
pub(crate) struct PhaseColumn<T>(pub T);

impl<T: Real> PhaseColumn<T> {
    #[inline(always)]
    pub(crate) fn is(self, phase: Phase) -> T::Mask {
        phase.is(self.0)
    }

    /// Whether the velocity determines the motion.
    #[inline(always)]
    pub(crate) fn is_free(self) -> T::Mask {
        !(self.is(Phase::Held) | self.slides())
    }

    /// Whether an event has found the contact sliding.
    #[inline(always)]
    pub(crate) fn slides(self) -> T::Mask {
        self.is(Phase::Forward) | self.is(Phase::Backward)
    }

    /// Direction of a contact that an event has found sliding.
    #[inline(always)]
    pub(crate) fn direction(self) -> T {
        choose!(self.is(Phase::Forward), T::from(1.0), T::from(-1.0))
    }
}

/// A contact that is set-valued at rest, in Model Exchange. Between events it is held, or slides in one direction,
/// regardless of its velocity: trial steps of a solver beyond the instant of rest use the same smooth law.
pub(super) struct Rest {
    pub phase: Phase,
    pub velocity: f64,
    pub external_force: f64,
    /// Levels up to which it holds a force forward and backward.
    pub levels: [f64; 2],
}

/// The force at rest. A contact found held by an event stays so until the next event, which the external force
/// triggers.
#[inline(always)]
pub(super) fn resting<T: Real>(phase: PhaseColumn<T>, external_force: T, level: T) -> T {
    choose!(phase.is(Phase::Held), external_force, external_force.limited(level))
}

/// Speed above which something else moves a held body, such as a prescribed velocity (chosen).
pub(crate) const MOVED: f64 = 1e-6;

/// Part of it by which a body coming to rest must have passed zero velocity (chosen), so that no event lies at a zero.
pub(crate) const PASSED: f64 = 1e-6;

/// Part of the level by which the external force must exceed it, or fall below it (chosen).
pub(crate) const REACHED: f64 = 1e-12;

impl Rest {
    /// Remaining force up to the level in the direction of the force, in parts of the larger of force and level.
    pub(super) fn reserve(&self) -> f64 {
        self.reserve_along(self.external_force.signum())
    }

    /// The same in a direction.
    fn reserve_along(&self, direction: f64) -> f64 {
        let [forward, backward] = self.levels;
        let (force, level) = (direction * self.external_force, if direction < 0.0 { backward } else { forward });
        let size = level.max(force.abs());
        if size > 0.0 { (level - force) / size } else { 0.0 }
    }

    /// Positive until the phase has to change.
    pub(super) fn indicator(&self) -> f64 {
        let speed = self.velocity / MOVED;
        match self.phase.direction() {
            None => (self.reserve() + REACHED).min(1.0 - speed.abs()),
            // A force that drives the body on makes it move again by itself, unless its velocity is prescribed.
            Some(direction) => {
                let (along, drive) = (direction * speed, REACHED - self.reserve_along(direction));
                (along + PASSED).max(drive.min(along + 1.0))
            }
        }
    }

    /// Phase of the contact after an event. The limits lie between those of the indicator, so that the indicator is
    /// then clearly positive.
    pub(super) fn settled(&self) -> Phase {
        let is_slow = self.velocity.abs() <= 0.5 * MOVED;
        let has_come_to_rest = self.phase.direction().is_none_or(|direction| direction * self.velocity <= 0.0);
        if !(is_slow && has_come_to_rest) {
            Phase::sliding(self.velocity)
        } else if self.reserve() > 0.5 * REACHED {
            Phase::Held
        } else if self.external_force == 0.0 {
            Phase::sliding(self.velocity)
        } else {
            Phase::sliding(self.external_force)
        }
    }
}

/// Width of the hysteresis at the edges of a band, in parts of it (chosen).
const EDGE: f64 = 1e-10;

/// A contact with a band around rest, in Model Exchange.
pub(super) struct Band {
    pub phase: Phase,
    pub velocity: f64,
    pub width: f64,
}

impl Band {
    /// Positive until the phase has to change.
    pub(super) fn indicator(&self) -> f64 {
        let speed = self.velocity / self.width;
        match self.phase.direction() {
            None => 1.0 + EDGE - speed.abs(),
            Some(direction) => direction * speed - (1.0 - EDGE),
        }
    }

    /// Phase of the contact after an event.
    pub(super) fn settled(&self) -> Phase {
        if self.velocity.abs() <= self.width { Phase::Held } else { Phase::sliding(self.velocity) }
    }
}

/// Event indicator of an event that never occurs.
pub(crate) const NO_EVENT: f64 = 1.0;
