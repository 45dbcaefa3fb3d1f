//! A contact with a static and a kinetic level.

use super::phase::{Band, NO_EVENT, Phase, PhaseColumn, REACHED, Rest};
use super::{Contact, Outcome, TimeStepping};
use crate::contact::stopping::{force_to_stop, is_held};
use crate::contact::unloading;
use crate::number::{Real, choose};

/// A contact with two levels, f_C while sliding and f_s at rest, that remembers whether it is stuck.
#[derive(Clone, Copy)]
pub(crate) struct TwoLevels<T: Real> {
    pub velocity: T,
    pub external_force: T,
    /// Level while sliding, f_C.
    pub kinetic: T,
    /// Level at rest, f_s.
    pub breakaway: T,
    /// The body counts as at rest up to this speed (0: at rest exactly).
    pub band: T,
    /// Whether the contact has been stuck since the last step.
    pub stuck: T::Mask,
    /// Motion as found by the last event of Model Exchange.
    pub phase: PhaseColumn<T>,
}

impl<T: Real> TwoLevels<T> {
    #[inline(always)]
    fn is_at_rest(&self) -> T::Mask {
        self.velocity.abs().at_most(self.band)
    }

    /// Whether it is at rest or within the band.
    #[inline(always)]
    fn rests(&self) -> T::Mask {
        self.phase.is(Phase::Held) | self.phase.is_free() & (self.stuck | self.is_at_rest())
    }

    /// The force at rest; within a band no event holds it.
    #[inline(always)]
    fn resting(&self) -> T {
        let is_kept = self.phase.is(Phase::Held) & !self.band.is_positive();
        choose!(is_kept, self.external_force, self.external_force.limited(self.breakaway))
    }
}

/// Event indicators of a contact with two levels: of its phase, of its reserve within the band, and of its load.
pub(crate) const EVENTS_OF_TWO_LEVELS: usize = 3;

impl TwoLevels<f64> {
    fn rest(&self) -> Rest {
        let TwoLevels { velocity, external_force, breakaway, .. } = *self;
        Rest { phase: Phase::of(self.phase.0), velocity, external_force, levels: [breakaway; 2] }
    }

    fn around_rest(&self) -> Band {
        Band { phase: Phase::of(self.phase.0), velocity: self.velocity, width: self.band }
    }

    pub(crate) fn write_indicators(&self, indicators: &mut [f64]) {
        let rest = self.rest();
        let [phase, reserve] = match (self.band > 0.0, Phase::of(self.phase.0)) {
            (false, _) => [rest.indicator(), NO_EVENT],
            (true, Phase::Held) => [self.around_rest().indicator(), rest.reserve() + REACHED],
            (true, _) => [self.around_rest().indicator(), NO_EVENT],
        };
        indicators.copy_from_slice(&[phase, reserve, unloading::load(self.breakaway)]);
    }

    /// Phase of the contact after an event.
    pub(crate) fn settled(&self) -> Phase {
        if self.band > 0.0 { self.around_rest().settled() } else { self.rest().settled() }
    }
}

impl<T: Real> Contact<T> for TwoLevels<T> {
    /// The law without memory: kinetic level outside the band; inside it the external force, up to the static level.
    #[inline(always)]
    fn printed(&self) -> T {
        choose!(
            self.rests(),
            self.resting(),
            self.kinetic * choose!(self.phase.slides(), self.phase.direction(), self.velocity.sign())
        )
    }

    #[inline(always)]
    fn largest(&self) -> T {
        self.breakaway
    }

    fn stepped(&self, mass: T, step_size: T) -> Outcome<T> {
        let TwoLevels { velocity, kinetic, breakaway, .. } = *self;
        let stopping = force_to_stop(velocity, self.external_force, mass, step_size);
        let is_held = is_held(stopping, velocity, self.stuck | self.is_at_rest(), kinetic, breakaway);
        let force = choose!(
            is_held,
            stopping,
            choose!(self.is_at_rest(), stopping.limited(breakaway), stopping.limited(kinetic))
        );
        Outcome { force, is_held }
    }

    #[inline(always)]
    fn sticking(&self, steps: &TimeStepping<T>) -> T {
        let is_active = steps.is_active();
        let is_held = self.rests() & self.external_force.abs().at_most(self.breakaway);
        T::truth((is_active & self.stuck | !is_active & is_held) & self.breakaway.is_positive())
    }
}

/// Common code of the laws with a [`TwoLevels`] contact. The band is that of the law.
macro_rules! two_levels {
    ($Law:ident, |$law:ident| $band:expr) => {
        impl<T: Real> $crate::contact::time_stepping::Holding<T> for $Law<T> {
            type Contact<'a>
                = $crate::contact::time_stepping::TwoLevels<T>
            where
                T: 'a;

            #[inline(always)]
            fn contact(&self) -> $crate::contact::time_stepping::TwoLevels<T> {
                let $law = self;
                $crate::contact::time_stepping::TwoLevels {
                    velocity: self.velocity,
                    external_force: self.external_force,
                    kinetic: self.mu_k * self.normal_force,
                    breakaway: self.mu_s * self.normal_force,
                    band: $band,
                    stuck: !self.stuck.vanishes(),
                    phase: self.time_stepping.phase(),
                }
            }

            $crate::contact::time_stepping::holding!(T);

            #[inline(always)]
            fn remember(&mut self, done: $crate::contact::time_stepping::Done<T>) {
                self.dissipated_energy = self.dissipated_energy + done.energy;
                self.stuck = T::truth(done.is_held);
            }
        }

        impl<T: Real> $crate::model::Law for $Law<T> {
            type Interface = $crate::model::ModelExchange;

            #[inline(always)]
            fn output(&mut self) {
                self.friction_force = $crate::contact::time_stepping::force(self);
                self.dissipated_power = self.friction_force * self.velocity;
                self.sticking = $crate::contact::time_stepping::sticking(self);
            }

            #[inline(always)]
            fn slide_steadily(&mut self) {
                self.time_stepping.forget();
                self.stuck = T::zero();
            }
        }

        impl<T: Real> $crate::model::Derivatives for $Law<T> {
            #[inline(always)]
            fn derivatives(&self, rate: &mut Self) {
                rate.dissipated_energy = $crate::contact::time_stepping::force(self) * self.velocity;
            }
        }

        impl<T: Real> $crate::model::Steps for $Law<T> {
            #[inline(always)]
            fn advance(&mut self, dt: T) {
                $crate::contact::time_stepping::step(self, dt);
            }
        }

        $crate::model::in_lanes!($Law, |law| law.time_stepping.fit(false));
    };

    () => {
        const EVENT_INDICATORS: usize = $crate::contact::time_stepping::EVENTS_OF_TWO_LEVELS;
        const STEADY_SLIDING: bool = true;

        fn slides_steadily(&self) -> bool {
            self.time_stepping.mass == 0.0
        }

        fn check(&self) -> Result<(), $crate::model::Fault> {
            $crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
        }

        fn check_model_exchange(&self) -> Result<(), $crate::model::Fault> {
            self.time_stepping.check_model_exchange()
        }

        fn event_indicators(&self, indicators: &mut [f64]) {
            $crate::contact::time_stepping::Holding::contact(self).write_indicators(indicators);
        }

        fn at_event(&mut self) {
            let contact = $crate::contact::time_stepping::Holding::contact(self);
            self.time_stepping.phase = contact.settled().number();
            self.stuck = 0.0;
        }

        $crate::model::in_lanes!();

        fn step_ramp(&mut self, slope: &Self, dt: f64) {
            $crate::contact::time_stepping::step_ramp(self, slope, dt);
        }
    };
}
pub(crate) use two_levels;
