//! fmi2DoStep and the queries about it.

use super::component::{Component, Refusal, enter, refuse};
use super::lifecycle::Call;
use super::types::*;
use crate::component::clock;
use stribeck::memory;

/// Advances the instance by `communicationStepSize` > 0. Inputs are held, or move with the slopes of
/// fmi2SetRealInputDerivatives. On an error nothing has changed.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2DoStep(
    c: fmi2Component,
    currentCommunicationPoint: fmi2Real,
    communicationStepSize: fmi2Real,
    _noSetFMUStatePriorToCurrentPoint: fmi2Boolean,
) -> fmi2Status {
    let body = |component: &mut Component| {
        let (t, h) = (currentCommunicationPoint, communicationStepSize);
        clock::check_step(component, t, h)?;
        clock::step(component, t, h)
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::DoStep, body) }
}

/// Always an error: steps are never pending.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2CancelStep(c: fmi2Component) -> fmi2Status {
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::CancelStep, |_| Ok(())) }
}

/// Answers a query about the last step: `answer` gives the value for a kind, if it has one.
///
/// # Safety
/// `c` as for every call on an instance; `value` must be NULL or writable.
unsafe fn status<T>(
    c: fmi2Component,
    call: Call,
    kind: fmi2StatusKind,
    value: *mut T,
    answer: impl FnOnce(&Component) -> Option<T>,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or a writable value.
        let Some(value) = (unsafe { value.as_mut() }) else { return refuse("value is NULL") };
        let text = || memory::text(format_args!("status kind {kind} is not available: steps are synchronous"));
        *value = answer(component).ok_or_else(|| Refusal::Trial(text()))?;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, call, body) }
}

/// Returns fmi2Discard: steps are never asynchronous.
///
/// # Safety
/// `c` as for every call on an instance; `value` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetStatus(
    c: fmi2Component,
    s: fmi2StatusKind,
    value: *mut fmi2Status,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { status(c, Call::GetStatus, s, value, |_| None) }
}

/// `fmi2LastSuccessfulTime`: the end of the last completed step. fmi2Discard for other kinds.
///
/// # Safety
/// As for fmi2GetStatus.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetRealStatus(
    c: fmi2Component,
    s: fmi2StatusKind,
    value: *mut fmi2Real,
) -> fmi2Status {
    let time = |component: &Component| (s == fmi2LastSuccessfulTime).then(|| component.instance.time());
    // SAFETY: the caller's promises.
    unsafe { status(c, Call::GetRealStatus, s, value, time) }
}

/// Returns fmi2Discard: FMI 2.0 defines no integer status.
///
/// # Safety
/// As for fmi2GetStatus.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetIntegerStatus(
    c: fmi2Component,
    s: fmi2StatusKind,
    value: *mut fmi2Integer,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { status(c, Call::GetIntegerStatus, s, value, |_| None) }
}

/// `fmi2Terminated`: no model ends the simulation, so fmi2False. fmi2Discard for other kinds.
///
/// # Safety
/// As for fmi2GetStatus.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetBooleanStatus(
    c: fmi2Component,
    s: fmi2StatusKind,
    value: *mut fmi2Boolean,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { status(c, Call::GetBooleanStatus, s, value, |_| (s == fmi2Terminated).then_some(fmi2False)) }
}

/// Returns fmi2Discard: steps are never asynchronous.
///
/// # Safety
/// As for fmi2GetStatus.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetStringStatus(
    c: fmi2Component,
    s: fmi2StatusKind,
    value: *mut fmi2String,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { status(c, Call::GetStringStatus, s, value, |_| None) }
}
