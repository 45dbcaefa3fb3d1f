//! fmi3DoStep, and the events of both interface types.

use super::component::{Component, Outcome, Refusal, enter, live, refuse};
use super::lifecycle::{Call, Purpose, State};
use super::types::*;
use crate::component::clock;
use crate::guard::pointer::{Null, place};

/// Number of points within a step, its end included, at which the importer's callback is called (chosen).
const POINTS: u32 = 4;

/// Where the results of a step go.
struct Answers<'a> {
    event: &'a mut fmi3Boolean,
    terminate: &'a mut fmi3Boolean,
    early: &'a mut fmi3Boolean,
    time: &'a mut fmi3Float64,
}

/// The importer's pointers to them.
#[derive(Clone, Copy)]
struct Places {
    event: *mut fmi3Boolean,
    terminate: *mut fmi3Boolean,
    early: *mut fmi3Boolean,
    time: *mut fmi3Float64,
}

impl Places {
    /// # Safety
    /// The pointers must be NULL or writable.
    unsafe fn answers<'a>(self) -> Result<Answers<'a>, Null> {
        // SAFETY: the caller's promise.
        unsafe {
            Ok(Answers {
                event: place(self.event, "eventHandlingNeeded")?,
                terminate: place(self.terminate, "terminateSimulation")?,
                early: place(self.early, "earlyReturn")?,
                time: place(self.time, "lastSuccessfulTime")?,
            })
        }
    }
}

/// A step as the importer asks for it, and as it is made.
#[derive(Clone, Copy)]
struct Step {
    begin: f64,
    /// Its length as asked for.
    wanted: f64,
    /// Its length up to an event or a request of the importer.
    length: f64,
    has_event: bool,
}

impl Step {
    /// The step up to its first event, if the importer handles it.
    fn find(component: &mut Component, begin: f64, wanted: f64) -> Step {
        let whole = Step { begin, wanted, length: wanted, has_event: false };
        let (instance, stepping) = (&component.instance, &mut component.own.stepping);
        let Some(trial) = stepping.trial.as_deref_mut().filter(|_| stepping.has_event_mode) else { return whole };
        if !stepping.may_return_early {
            return Step { has_event: instance.ends_changed(trial, wanted), ..whole };
        }
        let event = instance.first_event(trial, wanted);
        event.map_or(whole, |length| Step { length, has_event: true, ..whole })
    }

    /// Makes the step.
    fn make(self, component: &mut Component, answers: &mut Answers) -> Outcome {
        clock::step(component, self.begin, self.length)?;
        *answers.event = fmi3Boolean::from(self.has_event);
        *answers.terminate = fmi3False;
        *answers.early = fmi3Boolean::from(self.length < self.wanted);
        *answers.time = component.instance.time();
        Ok(())
    }
}

/// Advances the instance by `communicationStepSize` > 0 with held inputs. On an error nothing has changed.
///
/// With `eventModeUsed`, `eventHandlingNeeded` reports that a result that jumps has another value than at the beginning of
/// the step, or an event indicator another sign; with `earlyReturnAllowed` the step ends there, at `lastSuccessfulTime`.
/// The importer's callback is called at four points, the last one the end of the step, and may end the step at one of the
/// others.
/// If it throws, the instance stays within the step: the next call is an error, after which a reset helps.
///
/// # Safety
/// `instance` as for every call on an instance; the pointers must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3DoStep(
    instance: fmi3Instance,
    currentCommunicationPoint: fmi3Float64,
    communicationStepSize: fmi3Float64,
    _noSetFMUStatePriorToCurrentPoint: fmi3Boolean,
    eventHandlingNeeded: *mut fmi3Boolean,
    terminateSimulation: *mut fmi3Boolean,
    earlyReturn: *mut fmi3Boolean,
    lastSuccessfulTime: *mut fmi3Float64,
) -> fmi3Status {
    let (t, h) = (currentCommunicationPoint, communicationStepSize);
    let places = Places {
        event: eventHandlingNeeded,
        terminate: terminateSimulation,
        early: earlyReturn,
        time: lastSuccessfulTime,
    };
    let mut step = Step { begin: t, wanted: h, length: h, has_event: false };
    let mut update = None;
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        let mut answers = unsafe { places.answers() }?;
        clock::check_step(component, t, h)?;
        component.check_sizes()?;
        if component.own.stepping.trial.is_some() {
            component.check_parameters()?;
            step = Step::find(component, t, h);
            update = component.own.stepping.update.map(|update| (update, component.own.stepping.environment));
        }
        if update.is_some() { Ok(()) } else { step.make(component, &mut answers) }
    };
    // SAFETY: the caller's promise about `instance`.
    let status = unsafe { enter(instance, Call::DoStep, body) };
    match update {
        Some((update, environment)) if status == fmi3Status::fmi3OK => {
            let visitor = Visitor { instance, update, environment };
            // SAFETY: the caller's promises. Nothing borrows the instance here.
            unsafe { visitor.step(step, places) }
        }
        _ => status,
    }
}

type Update = unsafe extern "C-unwind" fn(
    fmi3InstanceEnvironment,
    fmi3Float64,
    fmi3Boolean,
    fmi3Boolean,
    fmi3Boolean,
    fmi3Boolean,
    *mut fmi3Boolean,
    *mut fmi3Float64,
);

/// The importer's callback within a step. It calls functions on the instance, which nothing may borrow meanwhile; it may
/// throw, so nothing may need to be dropped.
struct Visitor {
    instance: fmi3Instance,
    update: Update,
    environment: fmi3InstanceEnvironment,
}

impl Visitor {
    /// Makes a step, with visits on its way and at its end.
    ///
    /// # Safety
    /// As for fmi3DoStep.
    unsafe fn step(&self, step: Step, places: Places) -> fmi3Status {
        let mut step = step;
        for point in 1..POINTS {
            // SAFETY: the caller's promises.
            match unsafe { self.visit_within(step, step.length * (f64::from(point) / f64::from(POINTS))) } {
                Ok(None) => {}
                Ok(Some(length)) => {
                    step = Step { has_event: step.has_event && length == step.length, length, ..step };
                    break;
                }
                Err(status) => return status,
            }
        }
        let body = |component: &mut Component| {
            // SAFETY: the caller's promise.
            step.make(component, &mut unsafe { places.answers() }?)?;
            component.state = State::IntermediateUpdateMode;
            Ok(())
        };
        // SAFETY: the caller's promises.
        unsafe {
            let status = enter(self.instance, Call::DoStep, body);
            if status != fmi3Status::fmi3OK {
                return status;
            }
            self.call(step.begin + step.length, false);
            self.leave(false).err().unwrap_or(fmi3Status::fmi3OK)
        }
    }

    /// A visit after a part of the step; the length at which the importer wants the step to end.
    ///
    /// # Safety
    /// As for fmi3DoStep.
    unsafe fn visit_within(&self, step: Step, part: f64) -> Result<Option<f64>, fmi3Status> {
        let mut visited = None;
        let show = |component: &mut Component| {
            let stepping = &mut component.own.stepping;
            // Whatever makes a part of the step fail makes its end fail.
            if let Some(trial) = stepping.trial.as_deref_mut()
                && component.instance.show_future(trial, part)
            {
                visited = Some(stepping.may_return_early);
                component.state = State::IntermediateUpdateMode;
            }
            Ok(())
        };
        // SAFETY: the caller's promises.
        unsafe {
            let status = enter(self.instance, Call::DoStep, show);
            let Some(may_return_early) = visited.filter(|_| status == fmi3Status::fmi3OK) else { return Ok(None) };
            let asked = self.call(step.begin + part, may_return_early);
            self.leave(true)?;
            asked.map_or(Ok(None), |time| self.shorten(step, part, time))
        }
    }

    /// Calls the importer's function; the time at which it wants the step to end.
    ///
    /// # Safety
    /// As for fmi3DoStep; nothing may borrow the instance.
    unsafe fn call(&self, time: f64, may_return_early: bool) -> Option<f64> {
        let (mut is_asked, mut end) = (fmi3False, time);
        let can_return = fmi3Boolean::from(may_return_early);
        // SAFETY: the importer passed this function for this purpose.
        unsafe {
            (self.update)(self.environment, time, fmi3False, fmi3True, fmi3True, can_return, &mut is_asked, &mut end);
        }
        (may_return_early && is_asked != fmi3False).then_some(end)
    }

    /// Returns to Step Mode, unless a call within the callback was an error. Takes back the future that was shown.
    ///
    /// # Safety
    /// As for fmi3DoStep.
    unsafe fn leave(&self, was_future: bool) -> Result<(), fmi3Status> {
        // SAFETY: the caller's promise.
        let Some(component) = (unsafe { live(self.instance) }) else { return Err(fmi3Status::fmi3Error) };
        if let Some(trial) = component.own.stepping.trial.as_deref_mut().filter(|_| was_future) {
            component.instance.show_present(trial);
        }
        if component.state != State::IntermediateUpdateMode {
            return Err(fmi3Status::fmi3Error);
        }
        component.state = State::StepMode;
        Ok(())
    }

    /// The length of a step up to `time`, which must lie within it, but not before the part that the importer has seen.
    ///
    /// # Safety
    /// As for fmi3DoStep.
    unsafe fn shorten(&self, step: Step, part: f64, time: f64) -> Result<Option<f64>, fmi3Status> {
        let (begin, end) = (step.begin, step.begin + step.wanted);
        if time >= begin && time <= end {
            return Ok(Some((time - begin).max(part).min(step.length)));
        }
        let text = format_args!("earlyReturnTime = {time}: must be from {begin} to {end}");
        // SAFETY: the caller's promises.
        Err(unsafe { enter(self.instance, Call::DoStep, |_| Err(Refusal::error(text))) })
    }
}

/// Enters Event Mode, in which inputs may jump. In co-simulation only if `eventModeUsed`.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EnterEventMode(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| {
        if component.purpose == Purpose::CoSimulation && !component.own.stepping.has_event_mode {
            return refuse("eventModeUsed was fmi3False");
        }
        component.instance.enter_event();
        component.state = State::EventMode;
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::EnterEventMode, body) }
}

/// Does nothing: discrete states change in fmi3UpdateDiscreteStates only.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EvaluateDiscreteStates(instance: fmi3Instance) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::EvaluateDiscreteStates, |_| Ok(())) }
}

/// Applies the changes of an event: one call is enough. No model knows the time of its next event or ends the simulation;
/// in co-simulation the steps have made the changes.
///
/// # Safety
/// `instance` as for every call on an instance; the pointers must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3UpdateDiscreteStates(
    instance: fmi3Instance,
    discreteStatesNeedUpdate: *mut fmi3Boolean,
    terminateSimulation: *mut fmi3Boolean,
    nominalsOfContinuousStatesChanged: *mut fmi3Boolean,
    valuesOfContinuousStatesChanged: *mut fmi3Boolean,
    nextEventTimeDefined: *mut fmi3Boolean,
    nextEventTime: *mut fmi3Float64,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or writable values.
        let ([update, end, nominals, values, time_is_known], time) = unsafe {
            let flags = [
                place(discreteStatesNeedUpdate, "discreteStatesNeedUpdate")?,
                place(terminateSimulation, "terminateSimulation")?,
                place(nominalsOfContinuousStatesChanged, "nominalsOfContinuousStatesChanged")?,
                place(valuesOfContinuousStatesChanged, "valuesOfContinuousStatesChanged")?,
                place(nextEventTimeDefined, "nextEventTimeDefined")?,
            ];
            (flags, place(nextEventTime, "nextEventTime")?)
        };
        component.check_all()?;
        let has_jumped = match component.purpose {
            Purpose::CoSimulation => false,
            Purpose::ModelExchange => component.instance.at_event()? | std::mem::take(&mut component.has_jumped),
        };
        for flag in [update, end, nominals, time_is_known] {
            *flag = fmi3False;
        }
        (*values, *time) = (fmi3Boolean::from(has_jumped), 0.0);
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::UpdateDiscreteStates, body) }
}

/// Leaves Event Mode of co-simulation.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EnterStepMode(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| {
        component.check_all()?;
        component.state = State::StepMode;
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::EnterStepMode, body) }
}
