//! Steps of co-simulation by the clock of the importer.

use super::{Component, Outcome, Version, refuse};

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

/// Refuses a step of `h` > 0 that does not begin at the present time, or passes the stop time.
#[inline(always)]
pub(crate) fn check_step<V: Version>(component: &Component<V>, t: f64, h: f64) -> Outcome {
    let stop = component.experiment.stop;
    // The usual step first. Written so that NaN fails.
    if t == component.instance.time() && h > 0.0 && t + h <= stop && t + h < f64::INFINITY {
        return Ok(());
    }
    check_unusual_step(component, t, h)
}

/// A step that begins, or ends, a rounding error away from where it should; otherwise a wrong one.
#[inline(never)]
fn check_unusual_step<V: Version>(component: &Component<V>, t: f64, h: f64) -> Outcome {
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

/// Advances from `t` by `h`.
#[inline(always)]
pub(crate) fn step<V: Version>(component: &mut Component<V>, t: f64, h: f64) -> Outcome {
    component.instance.step(h)?;
    // The master's clock is the reference.
    component.instance.set_time(t + h);
    component.count_step();
    Ok(())
}
