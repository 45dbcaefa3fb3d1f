//! Checks of a record against what a rig can have measured.

use super::error::short;
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
    let energy = work(record, rig);
    if energy < 0.0 {
        let motion = if record.is_differentiated { "displacement" } else { "velocity" };
        let (fastest, mass) = (record.quality.fastest, rig.mass);
        return Err(MeasuredError::Drives { energy: -energy, fastest, motion, mass });
    }
    Ok(())
}

/// Work of the friction force, J: from turn to turn where a mass may be missing, since there it has no kinetic energy; 0 if
/// nothing can be said.
fn work(record: &Record, rig: &Rig) -> f64 {
    let (f, x) = (&record.friction_force, &record.displacement);
    let turns = || (1..x.len()).filter(|at| record.velocity[at - 1] * record.velocity[*at] <= 0.0);
    let part = match (turns().next(), turns().next_back()) {
        _ if rig.mass > 0.0 => 1..x.len(),
        (Some(first), Some(last)) if first < last => first + 1..last,
        _ if rig.is_axis => return 0.0,
        _ => 1..x.len(),
    };
    // Samples may be far apart, and the inertia of an unknown mass is in the force: its mean belongs to each way.
    part.map(|at| 0.5 * (f[at] + f[at - 1]) * (x[at] - x[at - 1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body that the force brakes gives energy back; without its mass that says nothing about signs, except from turn to
    /// turn.
    #[test]
    fn a_body_that_brakes_is_not_taken_for_friction_that_drives() {
        let text = |sign: f64, turns: f64| {
            let rows = (0..500).map(|k| f64::from(k) * 1e-3).map(|t| {
                let (sine, cosine) = (turns * (t + 0.3)).sin_cos();
                let [displacement, acceleration] = [0.1 * sine, -0.1 * turns * turns * sine];
                let force = 20.0 / turns * acceleration + 0.5 * cosine.signum();
                format!("{t},{},{displacement}\n", sign * force)
            });
            "time,force,displacement\n".to_owned() + &rows.collect::<String>()
        };
        let is_refused = |text: &str, is_axis: bool| {
            let rig = Rig { normal_force: Some(1.0), is_axis, ..Rig::default() };
            let sheet = crate::sheet::Sheet::parse(text).unwrap();
            matches!(Record::of(&sheet, None, &rig), Err(MeasuredError::Drives { .. }))
        };
        assert!(!is_refused(&text(1.0, 2.0), true), "one stroke that ends slower than it began");
        assert!(!is_refused(&text(1.0, 40.0), true) && !is_refused(&text(1.0, 40.0), false), "strokes to and fro");
        assert!(is_refused(&text(-1.0, 40.0), true) && is_refused(&text(-1.0, 40.0), false), "a wrong sign");
    }
}
