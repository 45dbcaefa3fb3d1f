//! Co-simulation data of laws without memory: the mass of the body that the host moves.
//!
//! A host that integrates the body itself applies a force that is held over a step. A contact at rest then chatters,
//! and so does a steep regularised law, unless the force is that at the end of the step.

mod on_branches;
mod on_curve;
mod phase;
mod two_levels;

use crate::model::ramp;
use crate::model::{Fault, Fit, Meaning, Model, Numbers, either, real};
use crate::number::{Mask, Real, choose};

pub(crate) use on_branches::{Branches, EVENTS_ON_BRANCHES};
pub(crate) use on_curve::{Curve, EVENTS_ON_CURVE, Lift, OnCurve, memoryless};
pub(crate) use phase::{MOVED, NO_EVENT, PASSED, Phase, PhaseColumn, REACHED};
pub(crate) use two_levels::{EVENTS_OF_TWO_LEVELS, TwoLevels, two_levels};

crate::choices! {
    /// Order in which the master exchanges values with the friction model.
    pub enum ExchangeOrder {
        /// The friction model steps first, and the host uses the force of that step (Gauss-Seidel).
        Sequential,
        /// All models step at once and exchange values afterwards, so the force acts one step later (Jacobi).
        Parallel,
    }
}

crate::part! {
    /// Columns of a law that can hold a body of known mass.
    TimeStepping {
        /// Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
        mass: tunable = real("kg", 0.0).at_least(0.0).means(Meaning::Mass),
        /// Order in which the master exchanges values; used with mass > 0.
        exchange: fixed = ExchangeOrder::Sequential.start().means(Meaning::Exchange),
        /// Length of the last step; 0 before the first one.
        step_size: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms").discrete(),
        /// Step for which a parallel exchange plans: the longest recent one.
        planning_step: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms").discrete(),
        /// Force planned for the coming step of a parallel exchange.
        planned_force: state = real("N", 0.0).discrete().odd(),
        /// Velocity at the end of the last step.
        end_velocity: state = real("m/s", 0.0).shown_in("mm/s").discrete().odd(),
        /// External force at the end of the last step.
        end_external_force: state = real("N", 0.0).discrete().odd(),
        /// Normal force at the end of the last step.
        end_normal_force: state = real("N", 0.0).at_least(0.0).discrete(),
        /// Change of the velocity over the last step if the master gave its slope, else 0.
        velocity_change: state = real("m/s", 0.0).shown_in("mm/s").discrete().odd(),
        /// Change of the external force over the last step if the master gave its slope, else 0.
        external_force_change: state = real("N", 0.0).discrete().odd(),
        /// Change of the normal force over the last step if the master gave its slope, else 0.
        normal_force_change: state = real("N", 0.0).discrete(),
        /// Motion of the contact as found by the last event of Model Exchange.
        phase: state = Phase::Free.start(),
    }
}

/// Factor by which the remembered longest step decays from one step to the next (chosen: half of it is left after 34
/// steps).
const PLANNING_MEMORY: f64 = 0.98;

/// The friction force over a step, and whether the body is at rest at its end.
#[derive(Clone, Copy)]
pub(crate) struct Outcome<T: Real> {
    pub force: T,
    pub is_held: T::Mask,
}

/// A law with its inputs.
pub(crate) trait Contact<T: Real>: Copy {
    /// Force of the law as printed.
    fn printed(&self) -> T;
    /// Largest force now: a planned force may not exceed it, because the load may have fallen since.
    fn largest(&self) -> T;
    /// Force over a step of a body of that mass.
    fn stepped(&self, mass: T, step_size: T) -> Outcome<T>;
    /// 1 if the contact is stuck, else 0.
    fn sticking(&self, steps: &TimeStepping<T>) -> T;
}

/// Inputs of a contact: at an instant, or averaged over a step.
#[derive(Clone, Copy)]
pub(crate) struct Inputs<T> {
    pub velocity: T,
    pub external_force: T,
    pub normal_force: T,
}

/// A law that can hold a body of known mass.
pub(crate) trait Holding<T: Real>: Numbers<Number = T> {
    /// Its contact.
    type Contact<'a>: Contact<T>
    where
        Self: 'a;
    fn contact(&self) -> Self::Contact<'_>;
    fn time_stepping(&self) -> &TimeStepping<T>;
    fn time_stepping_mut(&mut self) -> &mut TimeStepping<T>;
    fn inputs(&self) -> Inputs<T>;
    /// The same law with other inputs.
    fn given(self, inputs: Inputs<T>) -> Self;
    /// Adds the result of a step to the states.
    fn remember(&mut self, done: Done<T>);

    /// The law as it was over the last step: with the velocity at its beginning, because a master's acceleration
    /// already contains a friction force, and with the mean forces, whose impulse acts on the body. Inputs that have
    /// been set since belong to the next step.
    fn over_last_step(self) -> Self {
        let (inputs, steps) = (self.inputs(), self.time_stepping());
        let is_at = |now: T, end: T, change: T| {
            let rounding = T::from(4.0 * f64::EPSILON) * (end.abs() + change.abs());
            (now - end).abs().at_most(rounding)
        };
        let are_old = is_at(inputs.velocity, steps.end_velocity, steps.velocity_change)
            & is_at(inputs.external_force, steps.end_external_force, steps.external_force_change)
            & is_at(inputs.normal_force, steps.end_normal_force, steps.normal_force_change);
        let back = |now: T, change: T| choose!(are_old, now - change, now);
        let half = T::from(0.5);
        let inputs = Inputs {
            velocity: back(inputs.velocity, steps.velocity_change),
            external_force: back(inputs.external_force, half * steps.external_force_change),
            normal_force: back(inputs.normal_force, half * steps.normal_force_change),
        };
        self.given(inputs)
    }
}

/// The friction force at a communication point.
#[inline(always)]
pub(crate) fn force<T: Real>(law: &impl Holding<T>) -> T {
    let steps = law.time_stepping();
    if !T::SEARCHES {
        return law.contact().printed();
    }
    choose!(steps.is_active(), over_a_step(law), law.contact().printed())
}

fn over_a_step<T: Real>(law: &impl Holding<T>) -> T {
    let steps = law.time_stepping();
    choose!(
        steps.is_parallel(),
        steps.planned_force.limited(law.contact().largest()),
        law.over_last_step().contact().stepped(steps.mass, steps.step_size).force
    )
}

/// 1 if the contact is stuck, else 0.
#[inline(always)]
pub(crate) fn sticking<T: Real>(law: &impl Holding<T>) -> T {
    let steps = law.time_stepping();
    if !T::SEARCHES {
        return law.contact().sticking(steps);
    }
    choose!(steps.is_active(), law.over_last_step().contact().sticking(steps), law.contact().sticking(steps))
}

impl<T: Real> TimeStepping<T> {
    /// A body can be held as soon as its mass and the step are known.
    #[inline(always)]
    pub(crate) fn is_active(&self) -> T::Mask {
        self.mass.is_positive() & self.step_size.is_positive()
    }

    /// Motion of the contact as found by an event.
    #[inline(always)]
    pub(crate) fn phase(&self) -> PhaseColumn<T> {
        PhaseColumn(self.phase)
    }

    #[inline(always)]
    fn is_parallel(&self) -> T::Mask {
        ExchangeOrder::Parallel.is(self.exchange)
    }

    /// A copy without memory, so that a mass set later finds no old plan.
    #[inline(always)]
    fn forgotten(self) -> TimeStepping<T> {
        let zero = T::zero();
        TimeStepping {
            mass: self.mass,
            exchange: self.exchange,
            step_size: zero,
            planning_step: zero,
            planned_force: zero,
            end_velocity: zero,
            end_external_force: zero,
            end_normal_force: zero,
            velocity_change: zero,
            external_force_change: zero,
            normal_force_change: zero,
            phase: T::from(Phase::Free.number()),
        }
    }

    /// Drops the memory, if there is one.
    #[inline(always)]
    pub(crate) fn forget(&mut self) {
        // Only a step makes a plan and changes of inputs.
        let has_nothing = self.step_size.vanishes() & Phase::Free.is(self.phase);
        either(self, has_nothing, |_| {}, |steps| *steps = steps.forgotten());
    }
}

impl TimeStepping {
    /// How the row of a law fits beside others. `is_function`: as printed, it is a function of its inputs.
    pub(crate) fn fit(&self, is_function: bool) -> Fit {
        if self.mass > 0.0 {
            return Fit::Alone;
        }
        let has_nothing = self.step_size == 0.0 && Phase::Free.is(self.phase);
        if is_function && has_nothing { Fit::Outputs } else { Fit::Steps }
    }

    /// With mass, the force belongs to a whole step, and an importer that integrates the body itself takes no such
    /// step.
    pub(crate) fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.mass > 0.0 {
            let text =
                format_args!("mass = {}: must be 0 in Model Exchange, where no force is held over a step", self.mass);
            return Err(Fault::new(text));
        }
        Ok(())
    }
}

/// Result of a step.
#[derive(Clone, Copy)]
pub(crate) struct Done<T: Real> {
    /// Energy that the friction force took out of the motion.
    pub energy: T,
    /// Whether the contact is stuck; known with mass only.
    pub is_held: T::Mask,
}

/// Advances a law by `dt` with held inputs.
#[inline(always)]
pub(crate) fn step<T: Real>(law: &mut impl Holding<T>, dt: T) {
    step_from(law, law.inputs(), dt);
}

/// Advances a law by `dt`, over which its inputs have moved linearly from `begin` to their present values.
#[inline(always)]
fn step_from<T: Real>(law: &mut impl Holding<T>, begin: Inputs<T>, dt: T) {
    // A step is determined by the velocity, regardless of what an event has found.
    law.time_stepping_mut().phase = T::from(Phase::Free.number());
    let is_printed = law.time_stepping().mass.vanishes();
    if T::SEARCHES {
        either(law, is_printed, |law| step_as_printed(law, dt), |law| step_with_mass(law, begin, dt));
    } else {
        step_as_printed(law, dt);
    }
}

#[inline(always)]
fn step_as_printed<T: Real>(law: &mut impl Holding<T>, dt: T) {
    let steps = law.time_stepping_mut();
    *steps = steps.forgotten();
    let power = law.contact().printed() * law.inputs().velocity;
    law.remember(Done { energy: power * dt, is_held: false.into() });
}

fn step_with_mass<T: Real>(law: &mut impl Holding<T>, begin: Inputs<T>, dt: T) {
    let (end, is_first) = (law.inputs(), law.time_stepping().step_size.vanishes());
    let steps = law.time_stepping_mut();
    steps.velocity_change = end.velocity - begin.velocity;
    steps.external_force_change = end.external_force - begin.external_force;
    steps.normal_force_change = end.normal_force - begin.normal_force;
    steps.end_velocity = end.velocity;
    steps.end_external_force = end.external_force;
    steps.end_normal_force = end.normal_force;
    steps.step_size = dt;
    // A force that stops the body in a short step reverses its motion in a long one, and the length of the next step is
    // not known yet.
    steps.planning_step = (T::from(PLANNING_MEMORY) * steps.planning_step).larger(dt);
    let (steps, over) = (*steps, law.over_last_step());
    let sequential = || {
        let Outcome { force, is_held } = over.contact().stepped(steps.mass, dt);
        [steps.planned_force, work(&over, force, dt), T::truth(is_held)]
    };
    let parallel = || {
        // The host still applies the force of the last exchange; the next one is planned for the velocity that results
        // from it.
        let applied = choose!(is_first, over.contact().printed(), steps.planned_force);
        let Outcome { force, is_held } = planned(law, &over, applied, dt);
        [force, work(&over, applied, dt), T::truth(is_held)]
    };
    let [planned_force, energy, is_held] = steps.is_parallel().choose_all(parallel, sequential);
    law.time_stepping_mut().planned_force = planned_force;
    law.remember(Done { energy, is_held: !is_held.vanishes() });
}

/// The force over the coming step of a parallel exchange. The forces of the inputs are extrapolated linearly.
fn planned<T: Real, L: Holding<T>>(law: &L, over: &L, applied: T, dt: T) -> Outcome<T> {
    let (steps, end) = (law.time_stepping(), law.inputs());
    let ahead = T::from(0.5) * steps.planning_step / dt;
    let coming = law.given(Inputs {
        velocity: velocity_after(over, applied, dt),
        external_force: end.external_force + ahead * steps.external_force_change,
        normal_force: (end.normal_force + ahead * steps.normal_force_change).larger(T::zero()),
    });
    coming.contact().stepped(steps.mass, steps.planning_step)
}

fn velocity_after<T: Real>(law: &impl Holding<T>, force: T, dt: T) -> T {
    let Inputs { velocity, external_force, .. } = law.inputs();
    velocity + dt * (external_force - force) / law.time_stepping().mass
}

/// Force times the mean velocity over the step.
fn work<T: Real>(law: &impl Holding<T>, force: T, dt: T) -> T {
    force * T::from(0.5) * (law.inputs().velocity + velocity_after(law, force, dt)) * dt
}

/// Advances a law by `dt` while its inputs change at the rates `slope`. With a mass in one step, because the force
/// belongs to the whole step.
pub(crate) fn step_ramp<M: Model + Holding<f64>>(law: &mut M, slope: &M, dt: f64) {
    if law.time_stepping().mass == 0.0 {
        return ramp::advance(law, slope, dt);
    }
    let begin = law.inputs();
    let row = ramp::Inputs::of(law);
    ramp::set_inputs(law, &row, slope, dt);
    step_from(law, begin, dt);
}

/// Methods of [`Holding`] that access the columns of a law: all of them, or only the inputs or the time stepping.
macro_rules! holding {
    ($T:ident) => {
        $crate::contact::time_stepping::holding!(time stepping, $T);
        $crate::contact::time_stepping::holding!(inputs of a contact, $T);
    };

    (time stepping, $T:ident) => {
        #[inline(always)]
        fn time_stepping(&self) -> &$crate::contact::time_stepping::TimeStepping<$T> {
            &self.time_stepping
        }

        #[inline(always)]
        fn time_stepping_mut(&mut self) -> &mut $crate::contact::time_stepping::TimeStepping<$T> {
            &mut self.time_stepping
        }
    };

    (inputs of a contact, $T:ident) => {
        #[inline(always)]
        fn inputs(&self) -> $crate::contact::time_stepping::Inputs<$T> {
            $crate::contact::time_stepping::Inputs {
                velocity: self.velocity,
                external_force: self.external_force,
                normal_force: self.normal_force,
            }
        }

        #[inline(always)]
        fn given(self, inputs: $crate::contact::time_stepping::Inputs<$T>) -> Self {
            let $crate::contact::time_stepping::Inputs { velocity, external_force, normal_force } = inputs;
            Self { velocity, external_force, normal_force, ..self }
        }
    };
}
pub(crate) use holding;
