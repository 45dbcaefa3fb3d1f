//! The benchmark of the thesis: the belt with all laws and all classes of solvers, and how accuracy is paid for.

mod page;
mod precision;
mod printed;
mod reference;
mod table;

use std::time::Duration;

pub use page::page;
pub use precision::{Precision, work_precision};
pub use printed::section as karnopp_as_printed;
pub use reference::Reference;
pub use table::csv;

use stribeck_solve::run::{Outcome, Settings, Solver, run};
use stribeck_solve::solve::End;
use stribeck_solve::system::{Fault, Source, System};

/// Results that are compared.
const POSITION: &str = "rig.position";

/// Interval of the results of the thesis, in s: 400,001 rows over 40 s.
pub const EVERY: f64 = 1e-4;

/// Error of the position, in m, up to which a motion is right (chosen: a percent of the amplitude of a few decimetres).
pub const RIGHT: f64 = 2.5e-3;

/// Steps after which a solver is said not to come to its end (chosen): those of the models evaluate them many times.
pub const MOST_STEPS: [u64; 2] = [1_000_000, 200_000];

/// Most steps of a solver.
pub const fn most_steps(solver: Solver) -> u64 {
    MOST_STEPS[matches!(solver, Solver::Steps) as usize]
}

/// Time of a run that is not repeated (chosen).
const LONG: Duration = Duration::from_secs(1);

/// A run of a law with a solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// The solver.
    pub solver: Solver,
    /// Relative and absolute tolerance.
    pub tolerance: f64,
    /// Whether events are located.
    pub events: bool,
}

/// Outcome of a trial.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// Name of the law.
    pub law: String,
    /// The trial.
    pub trial: Trial,
    /// Steps, rejected steps, evaluations of the rates, Jacobians, events.
    pub counts: [u64; 5],
    /// Median time on the clock.
    pub time: Duration,
    /// Largest error of the position, in m; none if the run did not come to its end.
    pub error: Option<f64>,
    /// Whether the motion is known well enough to judge it.
    pub is_judged: bool,
    /// Largest error of a time of switching, in s; none if their number differs from that of the reference.
    pub switching: Option<f64>,
    /// How the run ended, or why there was none.
    pub end: Result<End, String>,
}

impl Measurement {
    /// The verdict of the thesis' tables; a run that was refused has none of theirs.
    pub fn verdict(&self) -> &'static str {
        match (&self.end, self.error) {
            (Err(_), _) => "refused",
            (Ok(_), None) => "DNC",
            (Ok(_), Some(_)) if !self.is_judged => "not judged",
            (Ok(_), Some(error)) if error <= RIGHT => "right",
            (Ok(_), Some(_)) => "wrong",
        }
    }

    /// The outcome of a finer run: if this one has too many steps, it has, too.
    pub fn for_finer(&self, trial: Trial) -> Option<Measurement> {
        let End::Failed { time, reason } = self.end.as_ref().ok()? else { return None };
        let Trial { solver, events, .. } = self.trial;
        if (solver, events) != (trial.solver, trial.events) || !reason.starts_with("more than ") {
            return None;
        }
        // The looser run says at which tolerance it was.
        let said = if reason.contains(", at ") { String::new() } else { format!(", at {:e}", self.trial.tolerance) };
        let end = Ok(End::Failed { time: *time, reason: format!("{reason}{said}") });
        Some(Measurement { law: self.law.clone(), trial, end, ..*self })
    }

    /// How it ended, in words.
    pub fn reason(&self) -> String {
        self.end.as_ref().map_or_else(Clone::clone, End::to_string)
    }

    /// A trial that was refused.
    fn refused(law: String, trial: Trial, fault: &Fault) -> Measurement {
        // The solver has a column of its own.
        let reason = fault.to_string().replacen(&format!("solver {}: ", trial.solver), "", 1);
        let (counts, time, end) = ([0; 5], Duration::ZERO, Err(reason));
        Measurement { law, trial, counts, time, error: None, is_judged: false, switching: None, end }
    }
}

/// Runs a law with a solver several times. What is refused is a result as well.
pub fn measure(system: &System, known: &Reference, trial: Trial, settings: &Settings, repeats: usize) -> Measurement {
    let Trial { solver, tolerance, events } = trial;
    let outcome = run_often(system, &Settings { solver, tolerance, events, ..*settings }, repeats);
    outcome.map_or_else(
        |fault| Measurement::refused(law(system), trial, &fault),
        |(outcome, time)| Measurement {
            law: law(system),
            trial,
            counts: counts(&outcome),
            time,
            error: outcome.is_reached().then(|| known.error(position(&outcome))),
            is_judged: known.is_certain(),
            switching: known.switching(&outcome.events),
            end: Ok(outcome.end),
        },
    )
}

fn law(system: &System) -> String {
    system.law.map_or(String::new(), |law| law.name.to_owned())
}

/// The outcome of several equal runs, and their median time.
fn run_often(system: &System, settings: &Settings, repeats: usize) -> Result<(Outcome, Duration), Fault> {
    let run = || run(system, settings, &[POSITION.to_owned()]);
    let mut outcome = run()?;
    let mut times = vec![outcome.elapsed];
    for _ in 1..if outcome.elapsed > LONG { 1 } else { repeats } {
        outcome = run()?;
        times.push(outcome.elapsed);
    }
    times.sort();
    Ok((outcome, times[times.len() / 2]))
}

/// Steps, rejected steps, evaluations, Jacobians, events.
fn counts(outcome: &Outcome) -> [u64; 5] {
    let statistics = &outcome.statistics;
    let (steps, rejected) = (statistics.steps, statistics.rejected);
    [steps, rejected, statistics.evaluations, statistics.jacobians, outcome.events.len() as u64]
}

fn position(outcome: &Outcome) -> &[f64] {
    outcome.values(POSITION).unwrap_or(&[])
}

/// The belt with a law.
pub fn belt(law: &str) -> Result<System, Fault> {
    System::assemble(&Source::open("belt")?, Some(law), &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run of `LuGre` that comes to its end.
    pub(super) fn trial(solver: Solver, tolerance: f64, evaluations: u64, error: f64) -> Measurement {
        Measurement {
            law: "LuGre".to_owned(),
            trial: Trial { solver, tolerance, events: true },
            counts: [0, 0, evaluations, 0, 0],
            time: Duration::ZERO,
            error: Some(error),
            is_judged: true,
            switching: None,
            end: Ok(End::Reached),
        }
    }

    /// Too many steps at a tolerance are too many at a finer one; whatever else ends a run may not.
    #[test]
    fn too_many_steps_are_too_many_at_a_finer_tolerance() {
        let loose = trial(Solver::Bdf, 1e-4, 1, 0.0);
        let failed = |reason: &str| {
            let end = Ok(End::Failed { time: 2.0, reason: reason.to_owned() });
            Measurement { error: None, end, ..loose.clone() }
        };
        let finer = Trial { tolerance: 1e-5, ..loose.trial };
        let found = failed("more than 9 steps").for_finer(finer).expect("an outcome");
        let finest = found.for_finer(Trial { tolerance: 1e-6, ..finer }).expect("an outcome");
        assert_eq!((found.trial.tolerance, finest.verdict()), (1e-5, "DNC"));
        assert!(finest.reason().ends_with("more than 9 steps, at 1e-4"), "{}", finest.reason());
        assert!(failed("friction chatters").for_finer(finer).is_none() && loose.for_finer(finer).is_none());
        assert!(failed("more than 9 steps").for_finer(Trial { solver: Solver::Dopri5, ..finer }).is_none());
    }
}
