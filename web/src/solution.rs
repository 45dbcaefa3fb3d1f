//! Runs of systems.

use serde::Serialize;
use stribeck_solve::run::{self, Check, Configuration, Outcome, run};
use stribeck_solve::solve;
use stribeck_solve::system::{Fault, Source, System};
use ts_rs::TS;

use crate::answer::{Answer, Text};

/// A run.
#[derive(Debug, Serialize, TS)]
pub struct Solved {
    law: Option<&'static str>,
    solver: String,
    reached: bool,
    end: String,
    /// Why the outcome is not what was asked for.
    fault: Option<String>,
    check: Option<Check>,
    statistics: Statistics,
    columns: Vec<Column>,
    /// The part that had each event; the times are the last array.
    events: Vec<String>,
}

/// What a run has cost.
#[derive(Debug, Serialize, TS)]
pub struct Statistics {
    steps: u64,
    rejected: u64,
    evaluations: u64,
    jacobians: u64,
}

/// A result of a run.
#[derive(Debug, Serialize, TS)]
pub struct Column {
    name: String,
    unit: String,
}

/// The system with one law of those that are chosen, and its description.
pub fn assembled(chosen: &Configuration, law: Option<&str>) -> Result<(System, Source), Fault> {
    if chosen.vary.is_some() {
        return Err(Fault::value("vary: the page has no studies; use `stribeck run`"));
    }
    let (mut systems, source) = chosen.systems()?;
    let known = || chosen.law.iter().map(String::as_str);
    let place = if known().len() == 0 && law.is_none() { Some(0) } else { known().position(|one| Some(one) == law) };
    let place = place.ok_or_else(|| Fault::unknown("law of the run", law.unwrap_or_default(), known()))?;
    Ok((systems.swap_remove(place), source))
}

/// Runs a system with one law of those that are chosen.
fn outcome(chosen: &Configuration, law: Option<&str>) -> Result<Outcome, Fault> {
    let (system, source) = assembled(chosen, law)?;
    run(&system, &chosen.settings(&system)?, &chosen.results(&source))
}

/// Times, results, events and what they have cost.
pub fn solve(chosen: &Configuration, law: Option<&str>) -> Result<Answer, Fault> {
    let outcome = outcome(chosen, law)?;
    let solve::Statistics { steps, rejected, evaluations, jacobians, .. } = outcome.statistics;
    let column = |column: &run::Column| Column { name: column.name.clone(), unit: column.unit.clone() };
    let described = Solved {
        law: outcome.law.map(|law| law.name),
        solver: outcome.solver.to_string(),
        reached: outcome.is_reached(),
        end: outcome.end.to_string(),
        fault: outcome.fault(),
        check: outcome.check,
        statistics: Statistics { steps, rejected, evaluations, jacobians },
        columns: outcome.columns.iter().map(column).collect(),
        events: outcome.events.iter().map(|event| event.part.clone()).collect(),
    };
    let mut arrays = vec![outcome.time];
    arrays.extend(outcome.columns.into_iter().map(|column| column.values));
    arrays.push(outcome.events.iter().map(|event| event.time).collect());
    Ok(Answer::with(described, arrays))
}

/// The table of results, which has no check.
pub fn csv(chosen: &Configuration, law: Option<&str>) -> Result<Answer, Fault> {
    let mut table = Vec::new();
    outcome(&Configuration { check: false, ..chosen.clone() }, law)?.write_csv(&mut table).map_err(Fault::value)?;
    let text = String::from_utf8(table).map_err(Fault::value)?;
    Ok(Answer::plain(Text { text }))
}

/// The file for the command line, if it can be run.
pub fn toml(chosen: &Configuration) -> Result<Answer, Fault> {
    // Without a law only what can be read is asked for.
    if chosen.law.is_empty() {
        chosen.source().map(|_| ())?
    } else {
        chosen.systems().map(|_| ())?
    }
    Ok(Answer::plain(Text { text: chosen.text() }))
}
