//! A run and a finer one: what a tolerance is worth.

use stribeck::model::Meaning;

use super::progress::Share;
use super::{Check, Difference, FINE, Finer, Kind, LEAST_TOLERANCE, Outcome, Settings, of_run, of_steps, once};
use crate::couple::is_host;
use crate::solve::{End, Progress};
use crate::system::{Fault, Place, System};

/// Factor by which the second run is finer.
const FACTOR: f64 = 10.0;

/// Largest difference in tolerances of the range (chosen: errors add up over thousands of steps, and falling friction
/// amplifies them).
const SANE: f64 = 1000.0;

/// Largest difference in parts of the range, whatever the tolerance or the step (chosen).
const GROSS: f64 = 0.05;

/// Difference that is none, in tolerances of the state's nominal value (chosen): of a body at rest the range is tiny,
/// and the tolerance is that of the nominal value.
const AT_REST: f64 = 10.0;

/// Part of an interval up to which two times are the same.
const NEAR: f64 = 1e-9;

/// Refuses a tolerance of which no tenth can be asked for.
pub(super) fn can_be_finer(tolerance: f64) -> Result<(), Fault> {
    if tolerance < FACTOR * LEAST_TOLERANCE {
        return Err(Fault::value(format_args!(
            "tolerance = {tolerance:e}: a check needs a tenth of it, and that must be at least {LEAST_TOLERANCE:e}"
        )));
    }
    Ok(())
}

/// Runs a system twice. The outcome is that of the first run; it has a check if that came to its end.
pub(super) fn checked(system: &System, settings: &Settings, results: &[String]) -> Result<Outcome, Fault> {
    let bodies = states_of_bodies(system);
    let names = bodies.iter().map(|place| system.name(*place));
    let all: Vec<String> = results.iter().cloned().chain(names).collect();
    let half = |begin| settings.progress.map(|whole| Share { whole, begin, part: 0.5 });
    let halves = [half(0.0), half(0.5 * settings.until)];
    let [first, second] = halves.each_ref().map(|half| half.as_ref().map(|half| half as &dyn Progress));
    let mut outcome = once(system, &Settings { progress: first, ..*settings }, &all)?;
    if outcome.is_reached() {
        let finer = Settings { progress: second, ..finer(&outcome, settings) };
        finer.check()?;
        let other = once(system, &finer, &all)?;
        let nominal: Vec<f64> = bodies.iter().map(|place| system.variable(*place).nominal).collect();
        outcome.check = Some(compared(&outcome, &other, [settings, &finer], &nominal));
    }
    outcome.columns.truncate(results.len());
    Ok(outcome)
}

/// The states by which a run is judged: those of bodies. They are continuous. A force may jump, and is off by the whole
/// jump for as long as one of two runs has not jumped yet.
fn states_of_bodies(system: &System) -> Vec<Place> {
    let bodies = (0..system.parts.len()).filter(|part| is_host(system, *part));
    let states = bodies.flat_map(|part| {
        let states = system.parts[part].model.continuous_states();
        states.map(move |column| Place { part, column })
    });
    states.filter(|place| system.variable(*place).meaning != Meaning::Energy).collect()
}

/// The settings of the finer run. A master has results at communication points only: where those of the first run are
/// no output times, the second records as many as the first has steps.
fn finer<'a>(run: &Outcome, settings: &Settings<'a>) -> Settings<'a> {
    let mut finer = *settings;
    finer.is_checked = false;
    if run.solver.kind() != Kind::CoSimulation {
        finer.tolerance = finer_tolerance(run.solver.kind(), settings.tolerance);
        return finer;
    }
    let grid = settings.grid();
    let is_on_grid = |(number, time): (usize, &f64)| (grid.time(number) - time).abs() <= NEAR * settings.every;
    if run.time.len() != grid.len() || !run.time.iter().enumerate().all(is_on_grid) {
        finer.every = settings.every.min(settings.master.step);
    }
    finer.master.step = tenth(finer.master.step);
    finer
}

/// A tenth of a tolerance; for methods of ours that with which their steps have a tenth of theirs.
fn finer_tolerance(kind: Kind, tolerance: f64) -> f64 {
    if !matches!(kind, Kind::Own(_)) || tolerance <= FINE {
        return tenth(tolerance).max(LEAST_TOLERANCE);
    }
    let finer = of_run(of_steps(tolerance) / FACTOR);
    // Two digits are enough to repeat the run by hand.
    format!("{finer:.1e}").parse().unwrap_or(finer)
}

/// A tenth as a user would write it: of 1e-5 it is 1e-6, and not that with a last digit.
fn tenth(number: f64) -> f64 {
    let tenth = number / FACTOR;
    format!("{tenth:.14e}").parse().unwrap_or(tenth)
}

/// A run beside a finer one, and the settings of both. The last columns are states of bodies, of which the nominal values
/// are given; where there are none, all results are judged.
fn compared(run: &Outcome, other: &Outcome, [settings, finer]: [&Settings; 2], nominal: &[f64]) -> Check {
    let tolerance = settings.tolerance;
    let (of, finer, limit) = if run.solver.kind() == Kind::CoSimulation {
        (Finer::Step, finer.master.step, GROSS)
    } else {
        (Finer::Tolerance, finer.tolerance, GROSS.min(SANE * tolerance))
    };
    let points = points(&run.time, &other.time, NEAR * settings.every);
    let mut differences: Vec<Difference> = Vec::new();
    for (column, finer) in run.columns.iter().zip(&other.columns) {
        let (name, unit) = (column.name.clone(), column.unit.clone());
        let [largest, part, time] = difference(&run.time, &column.values, &finer.values, &points);
        differences.push(Difference { name, unit, largest, part, time });
    }
    let results = differences.len() - nominal.len();
    let rest = nominal.iter().map(|nominal| AT_REST * tolerance * nominal);
    let judged = differences[results..].iter().zip(rest).filter(|(one, rest)| one.largest > *rest).map(|(one, _)| one);
    let judged: Vec<&Difference> = if nominal.is_empty() { differences.iter().collect() } else { judged.collect() };
    let worst = judged.into_iter().filter(|one| one.part > limit).max_by(|a, b| a.part.total_cmp(&b.part));
    let fault = fault(of, finer, &other.end, worst);
    differences.truncate(results);
    Check { of, finer, end: other.end.clone(), differences, fault }
}

/// Why a tolerance or step does not hold.
fn fault(of: Finer, finer: f64, end: &End, worst: Option<&Difference>) -> Option<String> {
    let (what, run) = (of.name(), of.run(finer));
    if matches!(end, End::Failed { .. }) {
        return Some(format!("the {what} does not hold: {run} {end}"));
    }
    let Difference { name, unit, largest, part, .. } = worst?;
    let (unit, part, time) = (if unit == "1" { "" } else { unit.as_str() }, 100.0 * part, worst?.shown_time());
    Some(format!(
        "the {what} does not hold: {run} differs by up to {largest:.2e} {unit} in {name}, {part:.2} % of its range, at \
         {time} s"
    ))
}

/// For each time the number of one at or before it in the finer run, and the part of the way from there to the next.
fn points(times: &[f64], finer: &[f64], near: f64) -> Vec<(usize, f64)> {
    let mut points = Vec::new();
    for time in times {
        let next = finer.partition_point(|other| *other < time - near);
        match (next.checked_sub(1), finer.get(next)) {
            (_, Some(other)) if (other - time).abs() <= near => points.push((next, 0.0)),
            (Some(before), Some(after)) => {
                points.push((before, (time - finer[before]) / (after - finer[before])));
            }
            _ => break,
        }
    }
    points
}

/// The largest difference, its part of the range, and its time.
fn difference(times: &[f64], values: &[f64], finer: &[f64], points: &[(usize, f64)]) -> [f64; 3] {
    let (mut largest, mut at) = (0.0, times.first().copied().unwrap_or(0.0));
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for ((time, value), (number, part)) in times.iter().zip(values).zip(points) {
        let before = finer[*number];
        let other = if *part > 0.0 { before + part * (finer[number + 1] - before) } else { before };
        (low, high) = (low.min(*value).min(other), high.max(*value).max(other));
        let apart = (value - other).abs();
        if apart > largest {
            (largest, at) = (apart, *time);
        }
    }
    [largest, if largest > 0.0 { largest / (high - low) } else { 0.0 }, at]
}

#[cfg(test)]
mod tests {
    use super::super::progress::Heard;
    use super::super::{Settings, Solver, run};
    use super::*;
    use crate::couple::Master;
    use crate::system::Source;

    use crate::stick_slip::StickSlip;

    const POSITION: &str = "rig.position";

    fn belt(law: &str) -> System {
        System::assemble(&Source::open("belt").unwrap(), Some(law), &[]).unwrap()
    }

    /// The belt with Coulomb friction and stiction, checked, and the largest error of its position in closed form.
    fn stick_slip(settings: &Settings) -> (Outcome, f64) {
        let settings = Settings { is_checked: true, ..*settings };
        let outcome = run(&belt("CoulombStiction"), &settings, &[POSITION.to_owned()]).unwrap();
        let exact = StickSlip::table_6_1();
        let points = outcome.time.iter().zip(outcome.values(POSITION).unwrap());
        let error = points.map(|(time, x)| (x - exact.position(*time)).abs()).fold(0.0, f64::max);
        (outcome, error)
    }

    fn of<'a>(outcome: &'a Outcome, name: &str) -> &'a Difference {
        outcome.check.as_ref().unwrap().differences.iter().find(|one| one.name == name).unwrap()
    }

    /// The error of a run at a tenth of the steps' tolerance, or of the step, is a small part of that of the run.
    #[test]
    fn difference_is_close_to_the_error() {
        let settings = Settings::of(&belt("CoulombStiction"));
        let of_method = |tolerance| Settings { solver: Solver::Rosenbrock23, tolerance, ..settings };
        let of_master = |step| {
            let master = Master { step, ..settings.master };
            Settings { solver: Solver::CoSimulation, master, ..settings }
        };
        // 7 ms do not divide the interval of the results.
        for settings in [of_method(1e-3), of_method(1e-5), of_master(1e-2), of_master(7e-3), of_master(1e-3)] {
            let (outcome, error) = stick_slip(&settings);
            let one = of(&outcome, POSITION);
            assert!(error > 1e-5 && (one.largest / error - 0.9).abs() < 0.2, "{one:?}, error {error:e}");
            assert!((one.part - one.largest / 0.746).abs() < 0.01 * one.part, "from 0 to 0.746 m: {one:?}");
            assert_eq!(outcome.fault(), None);
        }
        let (outcome, error) = stick_slip(&settings);
        let one = of(&outcome, POSITION);
        assert!(error < 1e-9 && one.largest < 1e-12, "straight lines are solved exactly: {one:?}, error {error:e}");
    }

    #[test]
    fn a_check_changes_nothing_else() {
        let (system, results) = (belt("LuGre"), [POSITION, "friction.friction_force"].map(str::to_owned));
        for solver in [Solver::Auto, Solver::CoSimulation] {
            let plain = Settings { solver, until: 12.0, ..Settings::of(&system) };
            let (once, twice) = (
                run(&system, &plain, &results).unwrap(),
                run(&system, &Settings { is_checked: true, ..plain }, &results).unwrap(),
            );
            assert_eq!(once.columns, twice.columns);
            assert_eq!((once.time, once.statistics, once.events), (twice.time, twice.statistics, twice.events));
            let names = twice.check.unwrap().differences.into_iter().map(|one| one.name);
            assert_eq!((once.check, names.collect::<Vec<String>>()), (None, results.to_vec()));
        }
    }

    /// Steps of 20 ms are far too long for bristles with a natural frequency of 50 Hz. By the force alone nothing is
    /// said.
    #[test]
    fn what_does_not_hold_is_said() {
        let system = belt("LuGre");
        let master = Master { step: 0.02, ..Settings::of(&system).master };
        let settings = Settings { solver: Solver::CoSimulation, master, is_checked: true, ..Settings::of(&system) };
        let outcome = run(&system, &settings, &["friction.friction_force".to_owned()]).unwrap();
        let fault = outcome.fault().unwrap();
        let begin = "the step does not hold: a run with steps of 0.002 s differs by up to ";
        assert!(outcome.is_reached() && fault.starts_with(begin) && fault.contains(" in rig."), "{fault}");
        let end = End::Failed { time: 3.5, reason: "friction chatters".to_owned() };
        let said = "the tolerance does not hold: a run at 1e-9 did not converge at 3.5 s: friction chatters";
        assert_eq!(fault_of(&end).as_deref(), Some(said));
        assert_eq!((fault_of(&End::Reached), fault_of(&End::Cancelled { time: 1.0 })), (None, None));
    }

    fn fault_of(end: &End) -> Option<String> {
        fault(Finer::Tolerance, 1e-9, end, None)
    }

    #[test]
    fn a_run_that_fails_is_not_repeated_and_no_tolerance_falls_below_the_least() {
        let source = Source::open("belt").unwrap();
        let printed = ["variant=Printed".parse().unwrap()];
        let system = System::assemble(&source, Some("RooneyDeravi"), &printed).unwrap();
        let settings = Settings { is_checked: true, ..Settings::of(&system) };
        let outcome = run(&system, &settings, &[POSITION.to_owned()]).unwrap();
        assert!(outcome.check.is_none() && outcome.fault().unwrap().contains("chatters"));
        let system = belt("CoulombStiction");
        let at = |tolerance| run(&system, &Settings { tolerance, until: 1.0, ..settings }, &[]);
        let text = "tolerance = 9e-14: a check needs a tenth of it, and that must be at least 1e-14";
        assert_eq!(at(9e-14).unwrap_err().to_string(), text);
        assert_eq!([1e-13, 1e-5].map(|tolerance| at(tolerance).unwrap().check.unwrap().finer), [1e-14, 3.2e-8]);
    }

    #[test]
    fn progress_is_that_of_both_runs() {
        let (system, heard) = (belt("LuGre"), Heard::default());
        let settings = Settings { is_checked: true, progress: Some(&heard), ..Settings::of(&system) };
        run(&system, &Settings { solver: Solver::CoSimulation, ..settings }, &[]).unwrap();
        let times = heard.0.into_inner().unwrap();
        assert!(times.is_sorted() && times[0] < 1.0 && times.contains(&20.0) && *times.last().unwrap() > 39.0);
    }
}
