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
            (Ok(_), Some(error)) if error <= RIGHT => "right",
            (Ok(_), Some(_)) => "wrong",
        }
    }

    /// How it ended, in words.
    pub fn reason(&self) -> String {
        self.end.as_ref().map_or_else(Clone::clone, End::to_string)
    }

    /// The trial that a reference is.
    fn of_reference(law: String, trial: Trial, reference: &Reference) -> Measurement {
        let Reference { counts, time, uncertainty, .. } = *reference;
        Measurement { law, trial, counts, time, error: Some(uncertainty), switching: None, end: Ok(End::Reached) }
    }

    /// A trial that was refused.
    fn refused(law: String, trial: Trial, fault: &Fault) -> Measurement {
        let (counts, time, end) = ([0; 5], Duration::ZERO, Err(fault.to_string()));
        Measurement { law, trial, counts, time, error: None, switching: None, end }
    }
}

/// Runs a law with a solver several times. What is refused is a result as well. The reference of a law that steps
/// itself is not run again: its error is then its uncertainty.
pub fn measure(system: &System, known: &Reference, trial: Trial, settings: &Settings, repeats: usize) -> Measurement {
    if trial.solver == Solver::Steps && trial.tolerance == known.tolerance {
        return Measurement::of_reference(law(system), trial, known);
    }
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
    for _ in 1..repeats {
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
