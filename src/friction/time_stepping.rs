//! What a law without memory needs in co-simulation: the mass of the body that the host moves.
//!
//! A host that integrates the body itself meets a force that is held over a step. A contact at rest then chatters, and
//! so does a steep regularised law, unless the force is that of the end of the step.

use crate::friction::unloading;
use crate::laws::end_velocity::{self, Landing};
use crate::laws::stopping::{force_to_stop, is_held};
use crate::model::{Fault, Model, real};
use crate::number::{Dual, Real};

crate::choices! {
    /// In which order the master exchanges values with the friction model.
    pub enum Exchange {
        /// The friction model steps first, and the host uses the force of that step (Gauss-Seidel).
        Sequential,
        /// All models step at once and exchange values afterwards, so the force acts one step later (Jacobi).
        Parallel,
    }
}

crate::choices! {
    /// What a contact does between two events of Model Exchange.
    pub enum Phase {
        /// What its velocity says: no event has settled it, as in co-simulation.
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
    fn sliding(direction: f64) -> Phase {
        if direction < 0.0 { Phase::Backward } else { Phase::Forward }
    }

    /// The direction in which it slides, if it is settled that it does.
    fn direction(self) -> Option<f64> {
        match self {
            Phase::Forward => Some(1.0),
            Phase::Backward => Some(-1.0),
            Phase::Free | Phase::Held => None,
        }
    }

    /// As the column holds it.
    pub(crate) fn number(self) -> f64 {
        f64::from(self as i32 + 1)
    }
}

crate::part! {
    /// Columns of a law that can move a body of known mass.
    TimeStepping {
        /// Effective mass of the host, if in doubt too small, to hold it in co-simulation; 0 = the printed law.
        mass: tunable = real("kg", 0.0).at_least(0.0),
        /// Order in which the master exchanges values; used with mass > 0.
        exchange: fixed = Exchange::Sequential.start(),
        /// Length of the last step; 0 before the first one.
        step_size: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms").discrete(),
        /// Step for which a parallel exchange plans: the longest of late.
        planning_step: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms").discrete(),
        /// Force planned for the coming step of a parallel exchange.
        planned_force: state = real("N", 0.0).discrete(),
        /// What the last event of Model Exchange has found the contact to do.
        phase: state = Phase::Free.start(),
    }
}

/// Part of the longest step that is remembered from one step to the next (chosen: half of it is left after 34 steps).
const PLANNING_MEMORY: f64 = 0.98;

/// The friction force over a step, and whether the body is at rest at its end.
#[derive(Clone, Copy)]
pub(crate) struct Outcome<T> {
    pub force: T,
    pub is_held: bool,
}

/// A contact at a communication point: a law with its inputs.
pub(crate) trait Contact<T: Real>: Copy {
    fn velocity(&self) -> T;
    fn external_force(&self) -> T;
    /// The same contact after the velocity has changed.
    fn moving_at(self, velocity: T) -> Self;
    /// The force of the law as it is printed.
    fn printed(&self) -> T;
    /// No force planned before may exceed this: the load may have fallen since.
    fn largest(&self) -> T;
    /// The force over a step of a body of that mass.
    fn stepped(&self, mass: T, step_size: T) -> Outcome<T>;
}

impl<T: Real> TimeStepping<T> {
    /// The friction force at a communication point.
    #[inline]
    pub(crate) fn force(&self, contact: &impl Contact<T>) -> T {
        if !self.is_active() {
            contact.printed()
        } else if self.is_parallel() {
            self.planned_force.limited(contact.largest())
        } else {
            contact.stepped(self.mass, self.step_size).force
        }
    }

    /// A body can be held as soon as its mass and the step are known.
    #[inline]
    pub(crate) fn is_active(&self) -> bool {
        self.mass.value() > 0.0 && self.step_size.value() > 0.0
    }

    /// What an event has found the contact to do.
    #[inline]
    pub(crate) fn phase(&self) -> Phase {
        Phase::of(self.phase.value())
    }

    fn is_parallel(&self) -> bool {
        Exchange::of(self.exchange.value()) == Exchange::Parallel
    }
}

/// A step as a law remembers it.
pub(crate) struct Done {
    /// Energy that the friction force took out of the motion.
    pub energy: f64,
    /// Is the contact stuck? Known with mass only.
    pub is_held: bool,
}

impl TimeStepping {
    /// A step goes by the velocity, whatever an event has found: to be called before its contact is made.
    #[inline]
    pub(crate) fn forget_event(&mut self) {
        self.phase = Phase::Free.number();
    }

    /// Advances by `dt` with held inputs.
    #[inline]
    pub(crate) fn step(&mut self, contact: &impl Contact<f64>, dt: f64) -> Done {
        if self.mass == 0.0 {
            *self = self.forgotten();
            return Done { energy: contact.printed() * contact.velocity() * dt, is_held: false };
        }
        self.step_with_mass(contact, dt)
    }

    /// Without what it remembers: a mass that is given later finds no old plan.
    #[inline]
    pub(crate) fn forgotten(self) -> TimeStepping {
        TimeStepping { step_size: 0.0, planning_step: 0.0, planned_force: 0.0, phase: Phase::Free.number(), ..self }
    }

    /// With mass the force is that of a whole step, which an importer that integrates the body itself does not make.
    pub(crate) fn check_exchange(&self) -> Result<(), Fault> {
        if self.mass > 0.0 {
            let text = format_args!("mass = {}: must be 0 in Model Exchange, which holds no force", self.mass);
            return Err(Fault::new(text));
        }
        Ok(())
    }

    fn step_with_mass(&mut self, contact: &impl Contact<f64>, dt: f64) -> Done {
        let is_first = self.step_size == 0.0;
        self.step_size = dt;
        // A force that stops the body in a short step throws it back in a long one, and the next step is not known yet.
        self.planning_step = dt.max(PLANNING_MEMORY * self.planning_step);
        if !self.is_parallel() {
            let Outcome { force, is_held } = contact.stepped(self.mass, dt);
            return Done { energy: self.work(contact, force, dt), is_held };
        }
        // The host still applies the force of the last exchange; the next one is planned for where that takes the body.
        let applied = if is_first { contact.printed() } else { self.planned_force };
        let next = contact.moving_at(self.velocity_after(contact, applied, dt));
        let Outcome { force, is_held } = next.stepped(self.mass, self.planning_step);
        self.planned_force = force;
        Done { energy: self.work(contact, applied, dt), is_held }
    }

    fn velocity_after(&self, contact: &impl Contact<f64>, force: f64, dt: f64) -> f64 {
        contact.velocity() + dt * (contact.external_force() - force) / self.mass
    }

    /// Force times the mean velocity over the step.
    fn work(&self, contact: &impl Contact<f64>, force: f64, dt: f64) -> f64 {
        let mean = 0.5 * (contact.velocity() + self.velocity_after(contact, force, dt));
        force * mean * dt
    }
}

/// A contact with two levels, f_C while sliding and f_s at rest, that remembers whether it is stuck.
#[derive(Clone, Copy)]
pub(crate) struct TwoLevels<T> {
    pub velocity: T,
    pub external_force: T,
    /// Level while sliding, f_C.
    pub kinetic: T,
    /// Level at rest, f_s.
    pub statical: T,
    /// The body counts as at rest up to this speed (0: at rest exactly).
    pub band: T,
    /// Is the contact stuck since the last step?
    pub stuck: bool,
    /// What the last event of Model Exchange has found.
    pub phase: Phase,
}

impl<T: Real> TwoLevels<T> {
    fn is_at_rest(&self) -> bool {
        self.velocity.abs() <= self.band
    }

    /// Does it rest, or is it within the band?
    fn rests(&self) -> bool {
        match self.phase {
            Phase::Free => self.stuck || self.is_at_rest(),
            phase => phase == Phase::Held,
        }
    }

    /// 1 if the contact is stuck, else 0.
    pub(crate) fn sticking(&self, time_stepping: &TimeStepping<T>) -> T {
        let sticking = if time_stepping.is_active() {
            self.stuck
        } else {
            self.rests() && self.external_force.abs() <= self.statical
        };
        truth(sticking && self.statical.value() > 0.0)
    }
}

/// A contact that is set-valued at rest, in Model Exchange. Between events it is held, or slides in one direction, whatever
/// its velocity: what a solver tries on the way beyond the instant of rest goes by the same smooth law.
struct Rest {
    phase: Phase,
    velocity: f64,
    external_force: f64,
    level: f64,
}

/// The force at rest. What an event has found held stays so until the next one, which the external force brings about.
#[inline]
fn resting<T: Real>(phase: Phase, external_force: T, level: T) -> T {
    if phase == Phase::Held { external_force } else { external_force.limited(level) }
}

/// Speed above which a held body is moved by something else, such as a velocity that is given (chosen).
const MOVED: f64 = 1e-6;

/// Part of it by which a body that comes to rest must have passed the rest (chosen): no event lies at a zero.
const PASSED: f64 = 1e-3;

/// Part of the level by which the external force must exceed it, or be below it (chosen).
const REACHED: f64 = 1e-9;

impl Rest {
    /// What the level leaves for more force in a direction, in parts of the larger of the two.
    fn reserve(&self, force: f64) -> f64 {
        let size = self.level.max(force.abs());
        if size > 0.0 { (self.level - force) / size } else { 0.0 }
    }

    /// Positive until the phase has to change.
    fn indicator(&self) -> f64 {
        let speed = self.velocity / MOVED;
        match self.phase.direction() {
            None => (self.reserve(self.external_force.abs()) + REACHED).min(1.0 - speed.abs()),
            // What drives a body on starts it again by itself, unless its velocity is given.
            Some(direction) => {
                let (along, drive) = (direction * speed, REACHED - self.reserve(direction * self.external_force));
                (along + PASSED).max(drive.min(along + 1.0))
            }
        }
    }

    /// At an event: what the contact does after it. The limits lie between those of the indicator, so that it is clearly
    /// positive then.
    fn settled(&self) -> Phase {
        let is_slow = self.velocity.abs() <= 0.5 * MOVED;
        let has_come_to_rest = self.phase.direction().is_none_or(|direction| direction * self.velocity <= 0.0);
        if !(is_slow && has_come_to_rest) {
            Phase::sliding(self.velocity)
        } else if self.reserve(self.external_force.abs()) > 0.5 * REACHED {
            Phase::Held
        } else if self.external_force == 0.0 {
            Phase::sliding(self.velocity)
        } else {
            Phase::sliding(self.external_force)
        }
    }
}

/// Width of the hysteresis at the edges of a band, in parts of it (chosen).
const EDGE: f64 = 1e-6;

/// A contact with a band around rest, in Model Exchange.
struct Band {
    phase: Phase,
    velocity: f64,
    width: f64,
}

impl Band {
    /// Positive until the phase has to change.
    fn indicator(&self) -> f64 {
        let speed = self.velocity / self.width;
        match self.phase.direction() {
            None => 1.0 + EDGE - speed.abs(),
            Some(direction) => direction * speed - (1.0 - EDGE),
        }
    }

    /// At an event: what the contact does after it.
    fn settled(&self) -> Phase {
        if self.velocity.abs() <= self.width { Phase::Held } else { Phase::sliding(self.velocity) }
    }
}

/// Event indicators of a contact with two levels: of its phase, of what it holds within its band, and of its load.
pub(crate) const EVENTS_OF_TWO_LEVELS: usize = 3;

impl TwoLevels<f64> {
    fn rest(&self) -> Rest {
        let TwoLevels { phase, velocity, external_force, statical, .. } = *self;
        Rest { phase, velocity, external_force, level: statical }
    }

    fn around_rest(&self) -> Band {
        Band { phase: self.phase, velocity: self.velocity, width: self.band }
    }

    pub(crate) fn write_indicators(&self, indicators: &mut [f64]) {
        let rest = self.rest();
        let [phase, reserve] = match (self.band > 0.0, self.phase) {
            (false, _) => [rest.indicator(), NO_EVENT],
            (true, Phase::Held) => [self.around_rest().indicator(), rest.reserve(self.external_force.abs()) + REACHED],
            (true, _) => [self.around_rest().indicator(), NO_EVENT],
        };
        indicators.copy_from_slice(&[phase, reserve, unloading::load(self.statical)]);
    }

    /// At an event: what the contact does after it.
    pub(crate) fn settled(&self) -> Phase {
        if self.band > 0.0 { self.around_rest().settled() } else { self.rest().settled() }
    }
}

impl<T: Real> Contact<T> for TwoLevels<T> {
    fn velocity(&self) -> T {
        self.velocity
    }

    fn external_force(&self) -> T {
        self.external_force
    }

    fn moving_at(self, velocity: T) -> Self {
        TwoLevels { velocity, ..self }
    }

    /// The law without memory: kinetic level outside the band; inside it the external force, up to the static level.
    fn printed(&self) -> T {
        if self.rests() {
            let phase = if self.band.value() > 0.0 { Phase::Free } else { self.phase };
            return resting(phase, self.external_force, self.statical);
        }
        self.kinetic * self.phase.direction().map_or(self.velocity.sign(), T::from)
    }

    fn largest(&self) -> T {
        self.statical
    }

    fn stepped(&self, mass: T, step_size: T) -> Outcome<T> {
        let TwoLevels { velocity, kinetic, statical, .. } = *self;
        let stopping = force_to_stop(velocity, self.external_force, mass, step_size);
        let is_held = is_held(stopping, velocity, self.stuck || self.is_at_rest(), kinetic, statical);
        let force = match (is_held, self.is_at_rest()) {
            (true, _) => stopping,
            (false, true) => stopping.limited(statical),
            (false, false) => stopping.limited(kinetic),
        };
        Outcome { force, is_held }
    }
}

/// A law whose force is a function of the velocity, odd and without memory: what it supplies, all else is shared.
pub(crate) trait Curve<T: Real> {
    /// The friction force at a velocity; if the law is set-valued at rest, at any velocity but 0.
    fn curve(&self, velocity: T) -> T;

    /// The static level or, without stiction, the Coulomb level.
    fn level(&self) -> T;

    /// Speed up to which a regularised contact counts as sticking. `None`: the law is set-valued at rest and holds up to
    /// its level.
    fn band(&self) -> Option<T>;

    /// Speeds, in rising order and 0 if there are fewer, at which the curve has a kink or a jump. Between them, outwards
    /// from rest, it must be rising, or first concave and then convex.
    fn kinks(&self) -> [T; 2] {
        [T::zero(); 2]
    }
}

/// The same law with its values as constants, in dual numbers: for the slope of its curve.
pub(crate) trait Lift {
    type Lifted: Curve<Dual>;
    fn lifted(&self) -> Self::Lifted;
}

/// A contact with a curve at a communication point.
pub(crate) struct OnCurve<'a, T, L> {
    pub law: &'a L,
    pub velocity: T,
    pub normal_force: T,
    pub external_force: T,
    /// What the last event of Model Exchange has found.
    pub phase: Phase,
}

impl<T: Copy, L> Clone for OnCurve<'_, T, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy, L> Copy for OnCurve<'_, T, L> {}

impl<T: Real, L: Curve<T> + Lift> OnCurve<'_, T, L> {
    /// 1 if the contact is stuck, else 0.
    #[inline]
    pub(crate) fn sticking(&self, time_stepping: &TimeStepping<T>) -> T {
        truth(match self.law.band() {
            Some(band) => self.is_within(band) && self.normal_force.value() > 0.0,
            None if self.law.level().value() == 0.0 => false,
            None if time_stepping.is_active() => self.stepped(time_stepping.mass, time_stepping.step_size).is_held,
            None => self.is_held(),
        })
    }

    /// Is the velocity within the band of a regularised law?
    fn is_within(&self, band: T) -> bool {
        match self.phase {
            Phase::Free => self.velocity.abs() < band,
            phase => phase == Phase::Held,
        }
    }

    /// Does a set-valued law rest?
    #[inline]
    fn rests(&self) -> bool {
        self.law.band().is_none()
            && match self.phase {
                Phase::Free => self.velocity.value() == 0.0,
                phase => phase == Phase::Held,
            }
    }

    /// Does a set-valued law rest, and is the external force within its level?
    fn is_held(&self) -> bool {
        self.rests() && self.external_force.abs() <= self.law.level()
    }

    /// What the body meets first, in the direction `side` in which it is driven.
    fn landing(&self, inertia: f64, side: f64) -> Landing {
        let law = self.law.lifted();
        let [velocity, load] = [side * self.velocity.value(), side * self.external_force.value()];
        let residual = |w: f64| {
            let force = law.curve(Dual { value: side * w, slope: 1.0 });
            Dual { value: inertia * (w - velocity) + side * force.value - load, slope: inertia + force.slope }
        };
        let marks = self.marks().map(|mark| mark.value());
        // Below the last mark the curve has the sign of the velocity: at the velocity the body would reach without it,
        // it is not positive.
        let end = (velocity + load / inertia).min(marks[4].min(-f64::MIN_POSITIVE).next_down());
        end_velocity::first(residual, &marks, velocity, end)
    }

    /// Velocities of the kinks and of rest, in falling order.
    fn marks(&self) -> [T; 5] {
        let [near, far] = self.law.kinks();
        [far, near, T::zero(), -near, -far]
    }

    /// One Newton correction from the velocity at the end of the step, which gives it its derivatives.
    fn corrected(&self, velocity: f64, inertia: T) -> T {
        let law = self.law.lifted();
        let slope = inertia.value() + law.curve(Dual { value: velocity, slope: 1.0 }).slope;
        let velocity = T::from(velocity);
        let residual = inertia * (velocity - self.velocity) + self.law.curve(velocity) - self.external_force;
        // Where two zeros meet there is no derivative.
        if slope > f64::EPSILON * inertia.value() { velocity - residual / T::from(slope) } else { velocity }
    }

    /// The force that ends the step at that velocity.
    fn force_to_reach(&self, velocity: T, inertia: T) -> T {
        self.external_force + inertia * (self.velocity - velocity)
    }
}

impl<T: Real, L: Curve<T> + Lift> Contact<T> for OnCurve<'_, T, L> {
    fn velocity(&self) -> T {
        self.velocity
    }

    fn external_force(&self) -> T {
        self.external_force
    }

    fn moving_at(self, velocity: T) -> Self {
        OnCurve { velocity, ..self }
    }

    #[inline]
    fn printed(&self) -> T {
        if self.rests() {
            return resting(self.phase, self.external_force, self.law.level());
        }
        self.law.curve(match self.phase.direction() {
            // Beyond rest the curve goes on as it has ended.
            Some(direction) if self.law.band().is_none() && direction * self.velocity.value() <= 0.0 => {
                T::from(direction * f64::MIN_POSITIVE)
            }
            _ => self.velocity,
        })
    }

    fn largest(&self) -> T {
        self.law.level() + self.law.curve(self.velocity).abs()
    }

    fn stepped(&self, mass: T, step_size: T) -> Outcome<T> {
        let inertia = mass / step_size;
        // The body accelerates against the force that its present velocity lacks or has too much.
        let side = (self.printed() - self.external_force).sign().value();
        if self.is_held() {
            return Outcome { force: self.force_to_reach(T::zero(), inertia), is_held: true };
        }
        if side == 0.0 || !inertia.value().is_finite() {
            return Outcome { force: self.printed(), is_held: false };
        }
        match self.landing(inertia.value(), side) {
            Landing::Curve(velocity) => {
                let velocity = self.corrected(side * velocity, inertia);
                Outcome { force: self.law.curve(velocity), is_held: false }
            }
            Landing::Jump(mark) => {
                let velocity = T::from(side) * self.marks()[mark];
                Outcome { force: self.force_to_reach(velocity, inertia), is_held: velocity.value() == 0.0 }
            }
        }
    }
}

/// Event indicators of a law with a curve: of its phase, of its kinks, and of its load.
pub(crate) const EVENTS_ON_CURVE: usize = 4;

impl<L: Curve<f64>> OnCurve<'_, f64, L> {
    fn rest(&self) -> Rest {
        let OnCurve { phase, velocity, external_force, .. } = *self;
        Rest { phase, velocity, external_force, level: self.law.level() }
    }

    fn around_rest(&self, width: f64) -> Band {
        Band { phase: self.phase, velocity: self.velocity, width }
    }

    pub(crate) fn write_indicators(&self, indicators: &mut [f64]) {
        let distance = |kink: f64| if kink > 0.0 { self.velocity.abs() / kink - 1.0 } else { NO_EVENT };
        let [near, far] = self.law.kinks().map(distance);
        let phase = match self.law.band() {
            Some(width) => self.around_rest(width).indicator(),
            None => self.rest().indicator(),
        };
        indicators.copy_from_slice(&[phase, near, far, unloading::load(self.normal_force)]);
    }

    /// At an event: what the contact does after it.
    pub(crate) fn settled(&self) -> Phase {
        self.law.band().map_or_else(|| self.rest().settled(), |width| self.around_rest(width).settled())
    }
}

/// Event indicator of what does not happen.
pub(crate) const NO_EVENT: f64 = 1.0;

/// Advances a law by `dt` while its inputs move with `slope`. With mass its force belongs to the whole step.
pub(crate) fn step_ramp<M: Model>(law: &mut M, mass: f64, slope: &M, dt: f64) {
    if mass > 0.0 {
        crate::ramp::at_end(law, slope, dt);
    } else {
        crate::ramp::advance(law, slope, dt);
    }
}

/// 1 or 0, as a Boolean column holds it.
#[inline]
fn truth<T: Real>(is_true: bool) -> T {
    T::from(f64::from(u8::from(is_true)))
}

/// What all laws with a [`Curve`] share: outputs, step and energy. `memoryless!(Law)` gives the outputs,
/// `memoryless!();` inside `impl Model` the step.
macro_rules! memoryless {
    ($Law:ident) => {
        impl<T: Real> $Law<T> {
            #[inline]
            fn contact(&self) -> $crate::friction::time_stepping::OnCurve<'_, T, Self> {
                $crate::friction::time_stepping::OnCurve {
                    law: self,
                    velocity: self.velocity,
                    normal_force: self.normal_force,
                    external_force: self.external_force,
                    phase: self.time_stepping.phase(),
                }
            }
        }

        impl<T: Real> $crate::friction::time_stepping::Lift for $Law<T> {
            type Lifted = $Law<$crate::number::Dual>;

            fn lifted(&self) -> Self::Lifted {
                self.map(&|number| number.value().into())
            }
        }

        impl<T: Real> $crate::model::Law for $Law<T> {
            #[inline]
            fn output(&mut self) {
                let contact = self.contact();
                let (force, sticking) = (self.time_stepping.force(&contact), contact.sticking(&self.time_stepping));
                self.friction_force = force;
                self.dissipated_power = force * self.velocity;
                self.sticking = sticking;
            }

            fn derivatives(&self, rate: &mut Self) {
                rate.dissipated_energy = self.time_stepping.force(&self.contact()) * self.velocity;
            }
        }
    };

    () => {
        const MODEL_EXCHANGE: bool = true;
        const EVENT_INDICATORS: usize = $crate::friction::time_stepping::EVENTS_ON_CURVE;

        fn step(&mut self, dt: f64) {
            self.time_stepping.forget_event();
            let mut time_stepping = self.time_stepping;
            self.dissipated_energy += time_stepping.step(&self.contact(), dt).energy;
            self.time_stepping = time_stepping;
        }

        #[inline(always)]
        fn step_and_output(&mut self, dt: f64) {
            if self.time_stepping.mass == 0.0 {
                // The force over the step is the force after it.
                if self.time_stepping.step_size != 0.0
                    || self.time_stepping.phase != $crate::friction::Phase::Free.number()
                {
                    self.time_stepping = self.time_stepping.forgotten();
                }
                $crate::model::Law::output(self);
                self.dissipated_energy += self.dissipated_power * dt;
            } else {
                self.step(dt);
                $crate::model::Law::output(self);
            }
        }

        fn kinks(&self) -> [f64; 2] {
            $crate::friction::time_stepping::Curve::kinks(self)
        }

        fn step_ramp(&mut self, slope: &Self, dt: f64) {
            $crate::friction::time_stepping::step_ramp(self, self.time_stepping.mass, slope, dt);
        }

        fn check_exchange(&self) -> Result<(), $crate::model::Fault> {
            self.time_stepping.check_exchange()
        }

        fn event_indicators(&self, indicators: &mut [f64]) {
            self.contact().write_indicators(indicators);
        }

        fn at_event(&mut self) {
            self.time_stepping.phase = self.contact().settled().number();
        }
    };
}
pub(crate) use memoryless;
