//! A contact whose force is a function of the velocity.

use super::phase::{Band, NO_EVENT, Phase, PhaseColumn, Rest, resting};
use super::{Contact, Outcome, TimeStepping};
use crate::contact::end_velocity::{self, Landing};
use crate::contact::unloading;
use crate::number::{Dual, Mask, Real, choose};

/// Methods supplied by a law without memory whose force is a function of the velocity and has its sign; everything else
/// is shared.
pub(crate) trait Curve<T: Real> {
    /// Friction force at a velocity; if the law is set-valued at rest, at any velocity except 0.
    fn curve(&self, velocity: T) -> T;

    /// Static level or, without stiction, Coulomb level; of a law that differs by direction the higher one.
    fn level(&self) -> T;

    /// Level up to which it holds an external force of that sign.
    #[inline(always)]
    fn level_against(&self, _force: T) -> T {
        self.level()
    }

    /// Speed up to which a regularised contact counts as sticking. `None`: the law is set-valued at rest and holds up
    /// to its level.
    fn band(&self) -> Option<T>;

    /// Speeds at which the curve has a kink or a jump, in ascending order, padded with 0. Between them, outwards from
    /// rest, it must be rising, or first concave and then convex.
    fn kinks(&self) -> [T; 2] {
        [T::zero(); 2]
    }

    /// Speed at which a curve with two humps, each concave and then convex, becomes concave again; 0 if it does not. Not
    /// for registers.
    fn turning_again(&self) -> f64 {
        0.0
    }
}

/// The same law with the values of one lane as constants, in dual numbers: for the slope of its curve.
pub(crate) trait Lift {
    type Lifted: Curve<Dual>;
    fn lifted(&self, lane: usize) -> Self::Lifted;
}

/// A contact with a curve at a communication point.
pub(crate) struct OnCurve<'a, T, L> {
    pub law: &'a L,
    pub velocity: T,
    pub normal_force: T,
    pub external_force: T,
    /// Motion as found by the last event of Model Exchange.
    pub phase: PhaseColumn<T>,
}

/// Speed next to rest in m/s (chosen) at which a contact that slides has its slope: at rest itself that of a falling level
/// with an exponent below 1 is infinite.
const LEAST: f64 = 1e-15;

impl<T: Copy, L> Clone for OnCurve<'_, T, L> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy, L> Copy for OnCurve<'_, T, L> {}

impl<T: Real, L: Curve<T>> OnCurve<'_, T, L> {
    /// Whether the velocity is within the band of a regularised law.
    #[inline(always)]
    fn is_within(&self, band: T) -> T::Mask {
        self.phase.is(Phase::Held) | self.phase.is_free() & self.velocity.abs().below(band)
    }

    /// Whether a set-valued law is at rest.
    #[inline(always)]
    pub(super) fn rests(&self) -> T::Mask {
        let is_free = self.phase.is_free();
        match self.law.band() {
            None => self.phase.is(Phase::Held) | is_free & self.velocity.vanishes(),
            Some(_) => T::Mask::from(false),
        }
    }

    /// The velocity of a contact that an event has found sliding: beyond rest the curve is extended at its last value.
    #[inline(always)]
    pub(crate) fn extended(&self) -> T {
        let direction = self.phase.direction();
        let (least, along) = (direction * T::from(LEAST), direction * self.velocity);
        // At rest itself the curve has the slope with which it leaves it.
        let near = choose!(along.below(T::from(LEAST)), self.velocity + least, self.velocity);
        along.below(T::zero()).select(least, near)
    }

    /// Whether a set-valued law is at rest and the external force is within its level.
    #[inline(always)]
    pub(crate) fn is_held(&self) -> T::Mask {
        self.rests() & self.external_force.abs().at_most(self.law.level_against(self.external_force))
    }
}

impl<T: Real, L: Curve<T> + Lift> OnCurve<'_, T, L> {
    /// First point of the curve that the body reaches. Velocities are mirrored by `side`, so that it moves towards
    /// lower ones.
    fn landing(&self, lane: usize, inertia: f64, side: f64) -> Landing {
        let [velocity, load] = [side * self.velocity.lane(lane), side * self.external_force.lane(lane)];
        let marks = self.marks().map(|mark| mark.lane(lane));
        landing(&self.law.lifted(lane), marks, inertia, side, velocity, load)
    }

    /// The curve at a velocity; not inlined, since a step needs it at several places.
    #[inline(never)]
    fn curve_at(&self, velocity: T) -> T {
        self.law.curve(velocity)
    }

    /// Velocities of the kinks and of rest, in descending order.
    fn marks(&self) -> [T; 5] {
        let [near, far] = self.law.kinks();
        [far, near, T::zero(), -near, -far]
    }

    /// One Newton correction from the velocity at the end of the step, which gives it its derivatives.
    fn corrected(&self, velocity: T, inertia: T) -> T {
        let on = || [inertia, self.curve_at(velocity)];
        let [slope, _] = T::found(on, |lane| {
            let curve = self.law.lifted(lane).curve(Dual { value: velocity.lane(lane), slope: 1.0 });
            [inertia.lane(lane) + curve.slope, 0.0]
        });
        let residual = inertia * (velocity - self.velocity) + self.curve_at(velocity) - self.external_force;
        // Where two zeros meet there is no derivative.
        let has_slope = slope.above(T::from(f64::EPSILON) * inertia);
        choose!(has_slope, velocity - residual / slope, velocity)
    }

    /// Force over the step of a body that reaches a jump or a point of the curve, and 1 if it is then at rest.
    fn landed(&self, inertia: T, side: T) -> [T; 2] {
        let marks = self.marks();
        let on =
            || [inertia, side, self.velocity, self.external_force, self.curve_at(self.velocity), marks[0], marks[1]];
        let [mark, velocity] = T::found(on, |lane| match self.landing(lane, inertia.lane(lane), side.lane(lane)) {
            Landing::Curve(velocity) => [NO_MARK, velocity],
            Landing::Jump(mark) => [mark as f64, 0.0],
        });
        let at_jump = || {
            let is_at = |jump: usize| mark.equals(T::from(jump as f64));
            let found = (0..marks.len()).fold(T::zero(), |found, jump| choose!(is_at(jump), marks[jump], found));
            let velocity = side * found;
            [self.force_to_reach(velocity, inertia), T::truth(velocity.vanishes())]
        };
        let on_curve = || [self.curve_at(self.corrected(side * velocity, inertia)), T::zero()];
        mark.equals(T::from(NO_MARK)).choose_all(on_curve, at_jump)
    }

    /// Force that ends the step at that velocity.
    fn force_to_reach(&self, velocity: T, inertia: T) -> T {
        self.external_force + inertia * (self.velocity - velocity)
    }
}

/// [`OnCurve::landing`] for mirrored velocity and load.
#[inline(never)] // once for all numbers
fn landing(law: &impl Curve<Dual>, marks: [f64; 5], inertia: f64, side: f64, velocity: f64, load: f64) -> Landing {
    let residual = |w: f64| {
        let force = law.curve(Dual { value: side * w, slope: 1.0 });
        Dual { value: inertia * (w - velocity) + side * force.value - load, slope: inertia + force.slope }
    };
    // Below the last mark the curve has the sign of the velocity: at the velocity the body would reach without it, it is
    // not positive.
    let end = (velocity + load / inertia).min(marks[4].min(-f64::MIN_POSITIVE).next_down());
    let again = law.turning_again();
    if again == 0.0 {
        return end_velocity::first(&residual, &marks, velocity, end);
    }
    let mut all = [marks[0], marks[1], marks[2], marks[3], marks[4], again, -again];
    all.sort_by(|a, b| b.total_cmp(a));
    match end_velocity::first(&residual, &all, velocity, end) {
        // The curve is smooth where it turns.
        Landing::Jump(at) if all[at].abs() == again => Landing::Curve(all[at]),
        Landing::Jump(at) => Landing::Jump(marks.iter().filter(|mark| **mark > all[at]).count()),
        curve @ Landing::Curve(_) => curve,
    }
}

impl<T: Real, L: Curve<T> + Lift> Contact<T> for OnCurve<'_, T, L> {
    #[inline(always)]
    fn printed(&self) -> T {
        choose!(
            self.rests(),
            resting(self.phase, self.external_force, self.law.level_against(self.external_force)),
            self.law.curve(match self.law.band() {
                None => choose!(self.phase.slides(), self.extended(), self.velocity),
                Some(_) => self.velocity,
            })
        )
    }

    #[inline(always)]
    fn largest(&self) -> T {
        self.law.level() + self.law.curve(self.velocity).abs()
    }

    fn stepped(&self, mass: T, step_size: T) -> Outcome<T> {
        let inertia = mass / step_size;
        // The body accelerates against the excess of the friction force over the external force.
        let printed = self.printed();
        let side = (printed - self.external_force).sign();
        let held = || [self.force_to_reach(T::zero(), inertia), T::from(1.0)];
        let printed = || [printed, T::zero()];
        let is_driven = !side.vanishes() & inertia.below(T::from(f64::INFINITY));
        let moving = || is_driven.choose_all(|| self.landed(inertia, side), printed);
        let [force, is_held] = self.is_held().choose_all(held, moving);
        Outcome { force, is_held: !is_held.vanishes() }
    }

    #[inline(always)]
    fn sticking(&self, steps: &TimeStepping<T>) -> T {
        let is_held = match self.law.band() {
            Some(band) => return T::truth(self.is_within(band) & self.normal_force.is_positive()),
            None if T::SEARCHES => {
                let stepped = || T::truth(self.stepped(steps.mass, steps.step_size).is_held);
                !steps.is_active().choose(stepped, || T::truth(self.is_held())).vanishes()
            }
            None => self.is_held(),
        };
        T::truth(is_held & !self.law.level().vanishes())
    }
}

/// Number of a mark for a body that reaches the curve, not a jump at a mark.
const NO_MARK: f64 = -1.0;

/// Event indicators of a law with a curve: of its phase, of its kinks, and of its load.
pub(crate) const EVENTS_ON_CURVE: usize = 4;

impl<L: Curve<f64>> OnCurve<'_, f64, L> {
    fn rest(&self) -> Rest {
        let OnCurve { velocity, external_force, .. } = *self;
        let levels = [1.0, -1.0].map(|direction| self.law.level_against(direction));
        Rest { phase: Phase::of(self.phase.0), velocity, external_force, levels }
    }

    fn around_rest(&self, width: f64) -> Band {
        Band { phase: Phase::of(self.phase.0), velocity: self.velocity, width }
    }

    /// Positive until the phase has to change.
    pub(crate) fn indicator_of_phase(&self) -> f64 {
        self.law.band().map_or_else(|| self.rest().indicator(), |width| self.around_rest(width).indicator())
    }

    pub(crate) fn write_indicators(&self, indicators: &mut [f64]) {
        let distance = |kink: f64| if kink > 0.0 { self.velocity.abs() / kink - 1.0 } else { NO_EVENT };
        let [near, far] = self.law.kinks().map(distance);
        indicators.copy_from_slice(&[self.indicator_of_phase(), near, far, unloading::load(self.normal_force)]);
    }

    /// Phase of the contact after an event.
    pub(crate) fn settled(&self) -> Phase {
        self.law.band().map_or_else(|| self.rest().settled(), |width| self.around_rest(width).settled())
    }
}

/// Common code of all laws with a [`Curve`]: outputs, step and energy. `memoryless!(Law)` generates the outputs, with
/// `|law|` and a statement those that only this law has; `memoryless!();` inside `impl Model` generates the step. A part
/// that has other inputs than a contact gives `memoryless!(Law, { ... })` their methods of [`Holding`](super::Holding), and
/// `memoryless!(without events);` leaves the events to it.
macro_rules! memoryless {
    ($Law:ident) => {
        $crate::contact::time_stepping::memoryless!($Law, |_law| ());
    };

    ($Law:ident, |$law:ident| $others:expr) => {
        $crate::contact::time_stepping::memoryless!(
            $Law,
            { $crate::contact::time_stepping::holding!(inputs of a contact, T); },
            |$law| $others
        );
    };

    ($Law:ident, { $($inputs:tt)* }) => {
        $crate::contact::time_stepping::memoryless!($Law, { $($inputs)* }, |_law| ());
    };

    ($Law:ident, { $($inputs:tt)* }, |$law:ident| $others:expr) => {
        impl<T: Real> $crate::contact::time_stepping::Holding<T> for $Law<T> {
            type Contact<'a>
                = $crate::contact::time_stepping::OnCurve<'a, T, Self>
            where
                T: 'a;

            #[inline(always)]
            fn contact(&self) -> $crate::contact::time_stepping::OnCurve<'_, T, Self> {
                let inputs = $crate::contact::time_stepping::Holding::inputs(self);
                $crate::contact::time_stepping::OnCurve {
                    law: self,
                    velocity: inputs.velocity,
                    normal_force: inputs.normal_force,
                    external_force: inputs.external_force,
                    phase: self.time_stepping.phase(),
                }
            }

            $crate::contact::time_stepping::holding!(time stepping, T);
            $($inputs)*

            #[inline(always)]
            fn remember(&mut self, done: $crate::contact::time_stepping::Done<T>) {
                self.dissipated_energy = self.dissipated_energy + done.energy;
            }
        }

        impl<T: Real> $crate::contact::time_stepping::Lift for $Law<T> {
            type Lifted = $Law<$crate::number::Dual>;

            fn lifted(&self, lane: usize) -> Self::Lifted {
                self.map(&|number| number.lane(lane).into())
            }
        }

        impl<T: Real> $crate::model::Law for $Law<T> {
            type Interface = $crate::model::ModelExchange;

            #[inline(always)]
            fn output(&mut self) {
                let force = $crate::contact::time_stepping::force(self);
                let sticking = $crate::contact::time_stepping::sticking(self);
                self.friction_force = force;
                self.dissipated_power = force * self.velocity;
                self.sticking = sticking;
                let $law = self;
                $others;
            }
        }

        impl<T: Real> $crate::model::Derivatives for $Law<T> {
            #[inline(always)]
            fn derivatives(&self, rate: &mut Self) {
                rate.dissipated_energy = $crate::contact::time_stepping::force(self) * self.velocity;
            }
        }

        impl<T: Real> $crate::model::Steps for $Law<T> {
            const SHARED: $crate::model::Shared = $crate::model::Shared::All;

            #[inline(always)]
            fn advance(&mut self, dt: T) {
                $crate::contact::time_stepping::step(self, dt);
            }

            #[inline(always)]
            fn advance_and_output(&mut self, dt: T) {
                if !T::SEARCHES {
                    return self.advance_as_printed(dt);
                }
                let is_printed = self.time_stepping.mass.vanishes();
                $crate::model::either(self, is_printed, |law| law.advance_as_printed(dt), |law| {
                    $crate::model::Steps::advance(law, dt);
                    $crate::model::Law::output(law);
                });
            }
        }

        impl<T: Real> $Law<T> {
            /// A step whose force is the force after it, and the outputs.
            #[inline(always)]
            fn advance_as_printed(&mut self, dt: T) {
                self.time_stepping.forget();
                $crate::model::Law::output(self);
                self.dissipated_energy = self.dissipated_energy + self.dissipated_power * dt;
            }
        }

        $crate::model::in_lanes!($Law, |law| law.time_stepping.fit(true));
    };

    () => {
        const EVENT_INDICATORS: usize = $crate::contact::time_stepping::EVENTS_ON_CURVE;

        fn event_indicators(&self, indicators: &mut [f64]) {
            $crate::contact::time_stepping::Holding::contact(self).write_indicators(indicators);
        }

        $crate::contact::time_stepping::memoryless!(without events);
    };

    (without events) => {
        $crate::model::in_lanes!();

        fn slides_steadily(&self) -> bool {
            self.time_stepping.fit(true) == $crate::model::Fit::Outputs
        }

        fn kinks(&self) -> [f64; 2] {
            $crate::contact::time_stepping::Curve::kinks(self)
        }

        fn step_ramp(&mut self, slope: &Self, dt: f64) {
            $crate::contact::time_stepping::step_ramp(self, slope, dt);
        }

        fn check_model_exchange(&self) -> Result<(), $crate::model::Fault> {
            self.time_stepping.check_model_exchange()
        }

        fn check_without_events(&self) -> Result<(), $crate::model::Fault> {
            // A curve through rest is followed without; its phase only says whether it counts as sticking.
            let band = $crate::contact::time_stepping::Curve::band(self);
            band.map_or_else(|| Err($crate::model::rests_at_events()), |_| Ok(()))
        }

        fn at_event(&mut self) {
            let phase = $crate::contact::time_stepping::Holding::contact(self).settled();
            self.time_stepping.phase = phase.number();
        }
    };
}
pub(crate) use memoryless;
