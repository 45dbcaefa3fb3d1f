//! Model Exchange: the importer integrates the states, using their derivatives. The states have the order of their
//! variables: an array stands at the place of its first element.

use super::component::{Component, Outcome, Refusal, enter, refuse};
use super::lifecycle::{Call, State};
use super::types::*;
use super::values::check_count;
use crate::component::Lifecycle;
use crate::guard::pointer::{array, array_mut, place};

/// Enters Continuous-Time Mode, in which time and states move.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EnterContinuousTimeMode(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| {
        component.check_all()?;
        component.instance.leave_event()?;
        component.state = State::ContinuousTimeMode;
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::EnterContinuousTimeMode, body) }
}

/// Completes a step of the importer's solver. Requests an event if a result that jumps has a new value.
///
/// # Safety
/// `instance` as for every call on an instance; `enterEventMode` and `terminateSimulation` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3CompletedIntegratorStep(
    instance: fmi3Instance,
    _noSetFMUStatePriorToCurrentPoint: fmi3Boolean,
    enterEventMode: *mut fmi3Boolean,
    terminateSimulation: *mut fmi3Boolean,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or writable values.
        let (event, end) =
            unsafe { (place(enterEventMode, "enterEventMode")?, place(terminateSimulation, "terminateSimulation")?) };
        // Results that would not be finite cannot be reported here: the solver is notified when it reads them.
        let wants_event = component.instance.wants_event().unwrap_or(false);
        (*event, *end) = (fmi3Boolean::from(wants_event), fmi3False);
        component.count_step();
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::CompletedIntegratorStep, body) }
}

/// Sets the present time.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetTime(instance: fmi3Instance, time: fmi3Float64) -> fmi3Status {
    let body = |component: &mut Component| {
        if !time.is_finite() {
            return refuse(format_args!("time = {time}: must be finite"));
        }
        component.instance.set_time(time);
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::SetTime, body) }
}

/// Sets the states: all, or none with fmi3Discard if one is not finite.
///
/// # Safety
/// `instance` as for every call on an instance; `continuousStates` must have `nContinuousStates` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetContinuousStates(
    instance: fmi3Instance,
    continuousStates: *const fmi3Float64,
    nContinuousStates: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        check_count(nContinuousStates, component.instance.continuous_states().len(), "states")?;
        // SAFETY: the caller promises that many elements.
        let values = unsafe { array(continuousStates, nContinuousStates, "continuousStates") }?;
        component.instance.set_continuous_states(values).map_err(|fault| Refusal::Discard(fault.0))
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::SetContinuousStates, body) }
}

/// Fills an array with one value for each state: `value` gets the column.
///
/// # Safety
/// As for [`enter`]; `values` must have `count` elements.
unsafe fn for_each_state(
    instance: fmi3Instance,
    call: Call,
    [values, what]: [&'static str; 2],
    (place, count): (*mut fmi3Float64, usize),
    value: impl Fn(&Component, usize) -> f64,
) -> fmi3Status {
    let body = |component: &mut Component| {
        let columns = component.instance.continuous_states();
        check_count(count, columns.len(), what)?;
        // SAFETY: the caller promises that many elements.
        for (place, column) in unsafe { array_mut(place, count, values) }?.iter_mut().zip(columns) {
            *place = value(component, *column);
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, call, body) }
}

/// Time derivatives of the states. If one is not finite: fmi3Discard at and between events, where the solver may try a
/// smaller step, otherwise fmi3Error.
///
/// # Safety
/// `instance` as for every call on an instance; `derivatives` must have `nContinuousStates` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetContinuousStateDerivatives(
    instance: fmi3Instance,
    derivatives: *mut fmi3Float64,
    nContinuousStates: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        check_count(nContinuousStates, component.instance.continuous_states().len(), "derivatives")?;
        // SAFETY: the caller promises that many elements.
        let values = unsafe { array_mut(derivatives, nContinuousStates, "derivatives") }?;
        let is_tried = component.state.is_tried();
        component.instance.rates().map_err(|fault| Refusal::out_of_domain(is_tried, fault))?;
        for (value, column) in values.iter_mut().zip(component.instance.continuous_states()) {
            *value = component.instance.latest_rates()[*column];
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetContinuousStateDerivatives, body) }
}

/// Functions that change sign where derivatives or outputs jump. If one is not finite: fmi3Discard at and between events,
/// otherwise fmi3Error.
///
/// # Safety
/// `instance` as for every call on an instance; `eventIndicators` must have `nEventIndicators` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetEventIndicators(
    instance: fmi3Instance,
    eventIndicators: *mut fmi3Float64,
    nEventIndicators: usize,
) -> fmi3Status {
    let body = |component: &mut Component| -> Outcome {
        check_count(nEventIndicators, component.instance.model().event_indicators, "event indicators")?;
        // SAFETY: the caller promises that many elements.
        let values = unsafe { array_mut(eventIndicators, nEventIndicators, "eventIndicators") }?;
        component.instance.indicate(values).map_err(|fault| component.out_of_domain(fault))
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetEventIndicators, body) }
}

/// The states.
///
/// # Safety
/// `instance` as for every call on an instance; `continuousStates` must have `nContinuousStates` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetContinuousStates(
    instance: fmi3Instance,
    continuousStates: *mut fmi3Float64,
    nContinuousStates: usize,
) -> fmi3Status {
    let names = ["continuousStates", "states"];
    let value = |component: &Component, column: usize| component.instance.row()[column];
    // SAFETY: the caller's promises.
    unsafe { for_each_state(instance, Call::GetContinuousStates, names, (continuousStates, nContinuousStates), value) }
}

/// The nominal values of the states.
///
/// # Safety
/// `instance` as for every call on an instance; `nominals` must have `nContinuousStates` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetNominalsOfContinuousStates(
    instance: fmi3Instance,
    nominals: *mut fmi3Float64,
    nContinuousStates: usize,
) -> fmi3Status {
    let names = ["nominals", "nominal values"];
    let value = |component: &Component, column: usize| component.instance.model().table.nominal(column);
    // SAFETY: the caller's promises.
    unsafe {
        for_each_state(instance, Call::GetNominalsOfContinuousStates, names, (nominals, nContinuousStates), value)
    }
}

/// Number of event indicators. It never changes.
///
/// # Safety
/// `instance` as for every call on an instance; `nEventIndicators` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetNumberOfEventIndicators(
    instance: fmi3Instance,
    nEventIndicators: *mut usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        *unsafe { place(nEventIndicators, "nEventIndicators") }? = component.instance.model().event_indicators;
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetNumberOfEventIndicators, body) }
}

/// Number of states. It never changes.
///
/// # Safety
/// `instance` as for every call on an instance; `nContinuousStates` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetNumberOfContinuousStates(
    instance: fmi3Instance,
    nContinuousStates: *mut usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        *unsafe { place(nContinuousStates, "nContinuousStates") }? = component.instance.continuous_states().len();
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetNumberOfContinuousStates, body) }
}
