//! Plausibility of a record: time, window and energy.

use crate::error::{MeasuredError, short};
use crate::record::{Record, Setup};

/// Shortest window of a matched filter, in samples.
const SHORTEST_MATCHED: f64 = 3.0;

/// Longest time between two samples, s (chosen): longer ones are counts of nanoseconds, or ticks of a clock.
const LONGEST: f64 = 100.0;

/// Turns from which the longest way back to the same place is looked for (chosen).
const TURNS: usize = 8;

/// Rejects times that are not in s, a window that is too short for the samples, and friction that drives the slider.
pub(crate) fn check(record: &Record, setup: &Setup) -> Result<(), MeasuredError> {
    if record.quality.interval > LONGEST {
        return Err(MeasuredError::Interval { interval: record.quality.interval, longest: LONGEST });
    }
    let shortest = if setup.is_axis { SHORTEST_MATCHED * record.quality.interval } else { record.acceleration_window };
    if let Some(value) = setup.window.filter(|window| *window > 0.0 && *window < (1.0 - 1e-9) * shortest) {
        let wanted = format!("at least {} s for the intervals of the file, or 0 for that", short(shortest));
        return Err(MeasuredError::Setup { name: "window", value, wanted });
    }
    let energy = work(record, setup);
    if energy < 0.0 {
        let motion = if record.is_differentiated { "displacement" } else { "velocity" };
        let (fastest, mass) = (record.quality.fastest, setup.mass);
        let (inertia, units) = (record.movement.inertia(), ["m/s", "kg"].map(|unit| record.movement.unit(unit)));
        return Err(MeasuredError::Drives { energy: -energy, fastest, motion, mass, inertia, units });
    }
    Ok(())
}

/// Work of the friction force, J: from reversal to reversal where a mass may be missing, since it has no kinetic energy
/// there; 0 where the sign of the work is uncertain.
fn work(record: &Record, setup: &Setup) -> f64 {
    let (f, x) = (&record.friction_force, &record.displacement);
    let turns = || (1..x.len()).filter(|at| record.velocity[at - 1] * record.velocity[*at] <= 0.0);
    if setup.has_gravity || setup.is_elastic {
        // Both give their energy back where the body returns to the place of a turn; what it has of it is of the drive.
        let last = |first: usize| {
            let returns = |at: &usize| (x[at - 1] - x[first]) * (x[*at] - x[first]) <= 0.0;
            (first + 2..x.len()).rev().find(returns).unwrap_or(first + 1)
        };
        let ways = turns().take(TURNS).map(|first| (first, last(first)));
        let Some((first, last)) = ways.max_by_key(|(first, last)| last - first) else { return 0.0 };
        let work = (first + 1..last).map(|at| 0.5 * (f[at] + f[at - 1]) * (x[at] - x[at - 1])).sum::<f64>();
        // It returns between two samples.
        let most = f.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let is_certain = work.abs() > most * (x[last - 1] - x[first]).abs();
        return if is_certain { work } else { 0.0 };
    }
    let part = match (turns().next(), turns().next_back()) {
        _ if setup.mass > 0.0 => 1..x.len(),
        (Some(first), Some(last)) if first < last => first + 1..last,
        _ if setup.is_axis => return 0.0,
        _ => 1..x.len(),
    };
    // Trapezoids: samples may be far apart, and the inertia of an unknown mass is in the force.
    part.map(|at| 0.5 * (f[at] + f[at - 1]) * (x[at] - x[at - 1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the recorder of ROS writes them: without a unit, and with one.
    #[test]
    fn times_in_nanoseconds_are_not_taken_for_seconds() {
        let read = |heading: &str| {
            let rows = (0..200).map(|k| (k, 0.05 * f64::from(k)));
            let row = |(k, phase): (i32, f64)| {
                format!(
                    "{},{},{}\n",
                    1_600_000_000_000_000_000 + 2_000_000 * i64::from(k),
                    phase.cos().signum(),
                    phase.sin()
                )
            };
            let text = format!("{heading}\n{}", rows.map(row).collect::<String>());
            let setup = Setup { normal_force: Some(1.0), ..Setup::default() };
            Record::of(&stribeck_sheet::Sheet::parse(&text).unwrap(), None, &setup)
        };
        let refusal = read("time,force,displacement").unwrap_err().to_string();
        // The numbers of such times have a resolution of 256 ns.
        assert!(refusal.starts_with("time: samples are 2000"), "{refusal}");
        assert!(refusal.contains(" s apart, must be at most 100 s: "), "{refusal}");
        let interval = read("time [ns],force,displacement").unwrap().quality.interval;
        assert!((interval - 2e-3).abs() < 1e-6, "{interval}");
    }

    /// A spring that ends stretched less than it began gives energy back; where it is as long as before, friction has not.
    #[test]
    fn a_spring_that_gives_energy_back_is_not_taken_for_friction_that_drives() {
        let text = |sign: f64| {
            let rows = (0..2200).map(|k| 0.3 + f64::from(k) * 1e-3).map(|t| {
                let [(slow, sine), (fast, quick)] = [6.0 * t, 40.0 * t].map(|angle: f64| (angle.cos(), angle.sin()));
                let [x, v] = [3e-3 * (1.0 - slow) + 2e-4 * (1.0 - fast), 1.8e-2 * sine + 8e-3 * quick];
                format!("{t},{},{x}\n", 1e5 * x + sign * 20.0 * v.signum())
            });
            "time,force,displacement\n".to_owned() + &rows.collect::<String>()
        };
        let is_refused = |text: &str, is_elastic: bool| {
            let setup = Setup { normal_force: Some(0.0), is_elastic, ..Setup::default() };
            let sheet = stribeck_sheet::Sheet::parse(text).unwrap();
            matches!(Record::of(&sheet, None, &setup), Err(MeasuredError::Drives { .. }))
        };
        assert!(is_refused(&text(1.0), false) && !is_refused(&text(1.0), true));
        assert!(is_refused(&text(-1.0), true), "friction that drives");
    }

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
            let setup = Setup { normal_force: Some(1.0), is_axis, ..Setup::default() };
            let sheet = stribeck_sheet::Sheet::parse(text).unwrap();
            matches!(Record::of(&sheet, None, &setup), Err(MeasuredError::Drives { .. }))
        };
        assert!(!is_refused(&text(1.0, 2.0), true), "one stroke that ends slower than it began");
        assert!(!is_refused(&text(1.0, 40.0), true) && !is_refused(&text(1.0, 40.0), false), "strokes to and fro");
        assert!(is_refused(&text(-1.0, 40.0), true) && is_refused(&text(-1.0, 40.0), false), "a wrong sign");
    }
}
