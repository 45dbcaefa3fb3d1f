//! fmi2DoStep and the queries about it.

use super::component::{Component, Outcome, Refusal, enter, refuse};
use super::lifecycle::Call;
use super::types::*;
use stribeck::memory;

/// Slack for communication points and the stop time (chosen, in s): masters accumulate h, compute i h, or count
/// nanoseconds.
const TIME_SLACK: f64 = 1e-9;

/// Slack relative to the time: some masters keep it in single precision, and two such times are off by half a digit
/// each. However far that clock drifts, each step begins where the last one ended by the same clock.
const RELATIVE_SLACK: f64 = f32::EPSILON as f64;

/// But never more than this part of the step (chosen), apart from rounding: a step that is repeated or skipped is off
/// by a whole step.
const STEP_SLACK: f64 = 0.4;

fn slack(t: f64, time: f64, h: f64) -> f64 {
    let largest = t.abs().max(time.abs());
    let rounding = 4.0 * f64::EPSILON * largest;
    rounding + (TIME_SLACK + RELATIVE_SLACK * largest).min(STEP_SLACK * h)
}

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
        check_step(component, t, h)?;
        component.instance.step(h)?;
        // The master's clock is the reference.
        component.instance.set_time(t + h);
        component.count_step();
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::DoStep, body) }
}

#[inline(always)]
fn check_step(component: &Component, t: f64, h: f64) -> Outcome {
    let stop = component.experiment.stop;
    // The usual step first. Written so that NaN fails.
    if t == component.instance.time() && h > 0.0 && t + h <= stop && t + h < f64::INFINITY {
        return Ok(());
    }
    check_unusual_step(component, t, h)
}

/// A step that begins, or ends, a rounding error away from where it should; otherwise a wrong one.
#[inline(never)]
fn check_unusual_step(component: &Component, t: f64, h: f64) -> Outcome {
    let (time, stop) = (component.instance.time(), component.experiment.stop);
    if !(h > 0.0 && h.is_finite()) {
        return refuse(format_args!("communicationStepSize = {h}: must be > 0 and finite"));
    }
    let slack = slack(t, time, h);
    if !(t.is_finite() && (t - time).abs() <= slack) {
        return refuse(format_args!("currentCommunicationPoint = {t}: must be {time}, where the last step ended"));
    }
    if t + h > stop + slack || !(t + h).is_finite() {
        return refuse(format_args!("the step from {t} s to {} s passes the stop time {stop} s", t + h));
    }
    Ok(())
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
