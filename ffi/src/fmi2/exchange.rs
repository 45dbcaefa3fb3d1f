//! Model Exchange: the importer integrates the states, using their derivatives.

use super::component::{Component, Outcome, Refusal, enter, refuse};
use super::lifecycle::{Call, State};
use super::types::*;
use crate::component::Lifecycle;
use crate::guard::pointer::{array, array_mut};

/// Refuses an array of the wrong length.
fn check_length(given: usize, wanted: usize, what: &str) -> Outcome {
    if given == wanted { Ok(()) } else { refuse(format_args!("{given} {what}: must be {wanted}")) }
}

/// Enters event mode, in which inputs may jump.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2EnterEventMode(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        component.instance.enter_event();
        component.state = State::EventMode;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::EnterEventMode, body) }
}

/// Applies the changes of an event: one call is enough. No model knows the time of its next event or ends the
/// simulation.
///
/// # Safety
/// `c` as for every call on an instance; `eventInfo` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2NewDiscreteStates(c: fmi2Component, eventInfo: *mut fmi2EventInfo) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or a writable struct.
        let Some(info) = (unsafe { eventInfo.as_mut() }) else { return refuse("eventInfo is NULL") };
        component.check_parameters()?;
        let has_jumped = component.instance.at_event()? | std::mem::take(&mut component.has_jumped);
        *info = fmi2EventInfo {
            newDiscreteStatesNeeded: fmi2False,
            terminateSimulation: fmi2False,
            nominalsOfContinuousStatesChanged: fmi2False,
            valuesOfContinuousStatesChanged: fmi2Boolean::from(has_jumped),
            nextEventTimeDefined: fmi2False,
            nextEventTime: 0.0,
        };
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::NewDiscreteStates, body) }
}

/// Enters continuous-time mode, in which time and states move.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2EnterContinuousTimeMode(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        component.check_parameters()?;
        component.instance.leave_event()?;
        component.state = State::ContinuousTimeMode;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::EnterContinuousTimeMode, body) }
}

/// Completes a step of the importer's solver. Requests an event if a result that jumps has a new value.
///
/// # Safety
/// `c` as for every call on an instance; `enterEventMode` and `terminateSimulation` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2CompletedIntegratorStep(
    c: fmi2Component,
    _noSetFMUStatePriorToCurrentPoint: fmi2Boolean,
    enterEventMode: *mut fmi2Boolean,
    terminateSimulation: *mut fmi2Boolean,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or writable values.
        let answers = unsafe { (enterEventMode.as_mut(), terminateSimulation.as_mut()) };
        let (Some(event), Some(end)) = answers else { return refuse("enterEventMode or terminateSimulation is NULL") };
        // Results that would not be finite cannot be reported here: the solver is notified when it reads them.
        let wants_event = component.instance.wants_event().unwrap_or(false);
        (*event, *end) = (fmi2Boolean::from(wants_event), fmi2False);
        component.count_step();
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::CompletedIntegratorStep, body) }
}

/// Sets the present time.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetTime(c: fmi2Component, time: fmi2Real) -> fmi2Status {
    let body = |component: &mut Component| {
        if !time.is_finite() {
            return refuse(format_args!("time = {time}: must be finite"));
        }
        component.instance.set_time(time);
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetTime, body) }
}

/// Sets the states: all, or none with fmi2Discard if one is not finite.
///
/// # Safety
/// `c` as for every call on an instance; `x` must have `nx` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetContinuousStates(c: fmi2Component, x: *const fmi2Real, nx: usize) -> fmi2Status {
    let body = |component: &mut Component| {
        check_length(nx, component.instance.continuous_states().len(), "states")?;
        // SAFETY: the caller promises `nx` elements.
        let values = unsafe { array(x, nx, "x") }?;
        component.instance.set_continuous_states(values).map_err(|fault| Refusal::Discard(fault.0))
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetContinuousStates, body) }
}

/// Time derivatives of the states. If one is not finite: fmi2Discard at and between events, where the solver may try a
/// smaller step, otherwise fmi2Error.
///
/// # Safety
/// `c` as for every call on an instance; `derivatives` must have `nx` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetDerivatives(
    c: fmi2Component,
    derivatives: *mut fmi2Real,
    nx: usize,
) -> fmi2Status {
    let body = |component: &mut Component| {
        check_length(nx, component.instance.continuous_states().len(), "derivatives")?;
        // SAFETY: the caller promises `nx` elements.
        let values = unsafe { array_mut(derivatives, nx, "derivatives") }?;
        let model = component.instance.model();
        let rates =
            component.instance.rates().map_err(|fault| Refusal::out_of_domain(component.state.is_tried(), fault))?;
        for (value, column) in values.iter_mut().zip(model.continuous_states()) {
            *value = rates[column];
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetDerivatives, body) }
}

/// Functions that change sign where derivatives or outputs jump. If one is not finite: fmi2Discard at and between
/// events, otherwise fmi2Error.
///
/// # Safety
/// `c` as for every call on an instance; `eventIndicators` must have `ni` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetEventIndicators(
    c: fmi2Component,
    eventIndicators: *mut fmi2Real,
    ni: usize,
) -> fmi2Status {
    let body = |component: &mut Component| {
        check_length(ni, component.instance.model().event_indicators, "event indicators")?;
        // SAFETY: the caller promises `ni` elements.
        let values = unsafe { array_mut(eventIndicators, ni, "eventIndicators") }?;
        component.instance.indicate(values).map_err(|fault| component.out_of_domain(fault))
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetEventIndicators, body) }
}

/// The states.
///
/// # Safety
/// `c` as for every call on an instance; `x` must have `nx` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetContinuousStates(c: fmi2Component, x: *mut fmi2Real, nx: usize) -> fmi2Status {
    let body = |component: &mut Component| {
        check_length(nx, component.instance.continuous_states().len(), "states")?;
        // SAFETY: the caller promises `nx` elements.
        let values = unsafe { array_mut(x, nx, "x") }?;
        for (value, column) in values.iter_mut().zip(component.instance.continuous_states()) {
            *value = component.instance.row()[*column];
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetContinuousStates, body) }
}

/// The nominal values of the states.
///
/// # Safety
/// `c` as for every call on an instance; `x_nominal` must have `nx` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetNominalsOfContinuousStates(
    c: fmi2Component,
    x_nominal: *mut fmi2Real,
    nx: usize,
) -> fmi2Status {
    let body = |component: &mut Component| {
        check_length(nx, component.instance.continuous_states().len(), "nominal values")?;
        // SAFETY: the caller promises `nx` elements.
        let values = unsafe { array_mut(x_nominal, nx, "x_nominal") }?;
        let table = component.instance.model().table;
        for (value, column) in values.iter_mut().zip(component.instance.continuous_states()) {
            *value = table.nominal(*column);
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetNominalsOfContinuousStates, body) }
}
