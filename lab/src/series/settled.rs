//! Results at held inputs, once they have settled.

use std::sync::atomic::{AtomicBool, Ordering};

use stribeck::instance::{Instance, Phase};

use super::Ended;

/// First step in s, factor of each step to the one before, and longest time in s (chosen).
const FIRST_STEP: f64 = 1e-4;
const GROWTH: f64 = 1.5;
const LONGEST: f64 = 1e12;

/// Least time in s and least way in m (chosen): beyond the dwell, the lag and the pre-sliding of all laws with usual
/// parameters.
const LEAST_TIME: f64 = 1.0;
const LEAST_WAY: f64 = 1e-2;

/// Change, as a part of the largest result, that counts as none (chosen).
const CHANGE: f64 = 1e-9;

/// Holds inputs from the present state until the results no longer change while the time grows tenfold. `speed` is the
/// magnitude of the velocities among the inputs. Refused if they keep fluctuating.
pub fn settle(
    instance: &mut Instance,
    inputs: &[(usize, f64)],
    speed: f64,
    results: &[usize],
    values: &mut [f64],
    cancel: &AtomicBool,
) -> Result<(), Ended> {
    instance.set_all(Phase::Stepping, inputs.iter().copied()).map_err(|refused| Ended::Setup(refused.to_string()))?;
    let least = if speed > 0.0 { f64::max(LEAST_TIME, LEAST_WAY / speed) } else { LEAST_TIME };
    let (mut time, mut step) = (0.0, FIRST_STEP);
    let mut history: Vec<(f64, Vec<f64>)> = Vec::new();
    while time < f64::max(LONGEST, 10.0 * least) {
        if cancel.load(Ordering::Relaxed) {
            return Err(Ended::Cancelled);
        }
        instance.step(step).map_err(|fault| Ended::Setup(fault.to_string()))?;
        time += step;
        step *= GROWTH;
        let read = results.iter().map(|column| instance.get_column(*column)).collect::<Result<Vec<f64>, _>>();
        history.push((time, read.map_err(|refused| Ended::Setup(refused.to_string()))?));
        history.retain(|(earlier, _)| *earlier >= 0.1 * time);
        if time >= least && is_settled(&history) {
            let last = history.last().map_or(&[][..], |(_, results)| results);
            values.copy_from_slice(last);
            return Ok(());
        }
    }
    let shown: Vec<String> =
        inputs.iter().filter_map(|(at, value)| Some(format!("{} = {value}", instance.variable(*at)?.path))).collect();
    Err(Ended::Unsettled(format!("the results do not settle at {}: they keep fluctuating", shown.join(", "))))
}

fn is_settled(history: &[(f64, Vec<f64>)]) -> bool {
    let Some((_, last)) = history.last() else { return false };
    let scale = last.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let is_same = |results: &Vec<f64>| results.iter().zip(last).all(|(a, b)| (a - b).abs() <= CHANGE * scale);
    history.iter().all(|(_, results)| is_same(results))
}
