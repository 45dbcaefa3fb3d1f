//! Runs of systems.

use serde::Serialize;
use stribeck_solve::run::{Configuration, Outcome, run};
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
    let source = chosen.source()?;
    let values = chosen.values();
    let mut laws: Vec<Option<&str>> = chosen.law.iter().map(|law| Some(law.as_str())).collect();
    if laws.is_empty() {
        laws.push(None);
    }
    let assembled = laws.iter().map(|law| System::assemble(&source, *law, &values));
    let systems = assembled.collect::<Result<Vec<System>, _>>()?;
    System::refuse_unused(&systems)?;
    let one = systems.into_iter().zip(laws).find(|(_, other)| *other == law);
    let (system, _) = one.ok_or_else(|| {
        Fault::unknown("law of the run", law.unwrap_or_default(), chosen.law.iter().map(String::as_str))
    })?;
    Ok((system, source))
}

/// Runs a system with one law of those that are chosen.
fn outcome(chosen: &Configuration, law: Option<&str>) -> Result<Outcome, Fault> {
    let (system, source) = assembled(chosen, law)?;
    run(&system, &chosen.settings(&system)?, &chosen.results(&source))
}

/// Times, results, events and what they have cost.
pub fn solve(chosen: &Configuration, law: Option<&str>) -> Result<Answer, Fault> {
    let outcome = outcome(chosen, law)?;
    let described = Solved {
        law: outcome.law.map(|law| law.name),
        solver: outcome.solver.to_string(),
        reached: outcome.is_reached(),
        end: outcome.end.to_string(),
        statistics: Statistics {
            steps: outcome.statistics.steps,
            rejected: outcome.statistics.rejected,
            evaluations: outcome.statistics.evaluations,
            jacobians: outcome.statistics.jacobians,
        },
        columns: outcome
            .columns
            .iter()
            .map(|column| Column { name: column.name.clone(), unit: column.unit.to_string() })
            .collect(),
        events: outcome.events.iter().map(|event| event.part.clone()).collect(),
    };
    let mut arrays = vec![outcome.time];
    arrays.extend(outcome.columns.into_iter().map(|column| column.values));
    arrays.push(outcome.events.iter().map(|event| event.time).collect());
    Ok(Answer::with(described, arrays))
}

/// The table of results.
pub fn csv(chosen: &Configuration, law: Option<&str>) -> Result<Answer, Fault> {
    let mut table = Vec::new();
    outcome(chosen, law)?.write_csv(&mut table).map_err(Fault::value)?;
    let text = String::from_utf8(table).map_err(Fault::value)?;
    Ok(Answer::plain(Text { text }))
}

/// The file for the command line, if it can be run.
pub fn toml(chosen: &Configuration) -> Result<Answer, Fault> {
    let source = chosen.source()?;
    let values = chosen.values();
    let laws = chosen.law.iter().map(|law| Some(law.as_str()));
    let assembled = laws.map(|law| System::assemble(&source, law, &values)).collect::<Result<Vec<_>, _>>()?;
    System::refuse_unused(&assembled)?;
    Ok(Answer::plain(Text { text: chosen.text() }))
}
