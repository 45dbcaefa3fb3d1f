//! Checks of a record against what a rig can have measured.

use super::{MeasuredError, Record, Rig};

/// Samples of the shortest window in which force and motion are smoothed alike.
const LEAST_ALIKE: f64 = 3.0;

/// Refuses a window that was not used because it is too short, and friction that drives the slider.
pub(super) fn check(record: &Record, rig: &Rig) -> Result<(), MeasuredError> {
    let shortest = if rig.is_axis { LEAST_ALIKE * record.quality.interval } else { record.acceleration_window };
    if let Some(value) = rig.window.filter(|window| *window > 0.0 && *window < (1.0 - 1e-9) * shortest) {
        let wanted = format!("at least {} s for the intervals of the file, or 0 for that", short(shortest));
        return Err(MeasuredError::Rig { name: "window", value, wanted });
    }
    let energy = work(record);
    if energy < 0.0 {
        let motion = if record.is_differentiated { "displacement" } else { "velocity" };
        return Err(MeasuredError::Drives { energy: -energy, fastest: record.quality.fastest, motion });
    }
    Ok(())
}

/// Work of the friction force, J.
fn work(record: &Record) -> f64 {
    let (f, x) = (&record.friction_force, &record.displacement);
    // Samples may be far apart, and the inertia of an unknown mass is in the force: its mean belongs to each way.
    (1..x.len()).map(|at| 0.5 * (f[at] + f[at - 1]) * (x[at] - x[at - 1])).sum()
}

/// A number with six digits at most, for a text.
pub(super) fn short(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_texts_are_short() {
        let numbers = [0.008_999_999_999_999_009, 3.9995].map(|value| short(value).to_string());
        assert_eq!(numbers, ["0.009", "3.9995"]);
        assert_eq!(short(-12_345_678.0), -12_345_700.0);
        assert_eq!([0.0, 1e-300].map(short), [0.0, 1e-300]);
    }
}
