//! The workbench's systems and solvers.

use clap::ValueEnum;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_solve::run::{Configuration, Outcome, Settings, Solver, run};
use stribeck_solve::solve::End;
use stribeck_solve::system::{BUILT_IN, Description, System};

use crate::entries::described;
use crate::refused;
use crate::work::interruptible;

/// Names and titles of the built-in systems.
#[pyfunction]
pub fn systems() -> PyResult<Vec<(&'static str, String)>> {
    let title = |(name, text): &(&'static str, &str)| Ok((*name, Description::parse(text).map_err(refused)?.title));
    BUILT_IN.iter().map(title).collect()
}

/// Names of the solvers, with one line on each.
#[pyfunction]
pub fn solvers() -> Vec<(String, String)> {
    let values = Solver::value_variants().iter().filter_map(ValueEnum::to_possible_value);
    values
        .map(|value| (value.get_name().to_owned(), value.get_help().map_or(String::new(), ToString::to_string)))
        .collect()
}

/// Runs a system with each of several laws, or with its own; an outcome for each. The entries are those of a file of
/// `stribeck run`.
#[pyfunction]
pub fn solve<'py>(py: Python<'py>, entries: &Bound<'py, PyDict>) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let chosen: Configuration = described(entries)?;
    if chosen.vary.is_some() {
        return Err(refused("vary: use stribeck.study"));
    }
    let outcomes = interruptible(py, |cancel| {
        let source = chosen.source()?;
        let laws: Vec<Option<&str>> =
            if chosen.law.is_empty() { vec![None] } else { chosen.law.iter().map(|law| Some(law.as_str())).collect() };
        let values = chosen.values();
        let assembled = laws.iter().map(|law| System::assemble(&source, *law, &values));
        let systems = assembled.collect::<Result<Vec<System>, _>>()?;
        System::refuse_unused(&systems)?;
        let results = chosen.results(&source);
        let mut outcomes = Vec::new();
        for system in &systems {
            let settings = Settings { cancel: Some(cancel), ..chosen.settings(system)? };
            outcomes.push(run(system, &settings, &results)?);
        }
        Ok::<_, stribeck_solve::system::Fault>(outcomes)
    })?;
    outcomes.map_err(refused)?.into_iter().map(|outcome| as_dict(py, outcome)).collect()
}

fn as_dict<'py>(py: Python<'py>, outcome: Outcome) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("law", outcome.law.map(|law| law.name))?;
    dict.set_item("solver", outcome.solver.to_string())?;
    dict.set_item("end", outcome.end.to_string())?;
    dict.set_item("reached", outcome.end == End::Reached)?;
    dict.set_item("seconds", outcome.elapsed.as_secs_f64())?;
    let statistics = PyDict::new(py);
    for (name, count) in [
        ("steps", outcome.statistics.steps),
        ("rejected", outcome.statistics.rejected),
        ("evaluations", outcome.statistics.evaluations),
        ("jacobians", outcome.statistics.jacobians),
    ] {
        statistics.set_item(name, count)?;
    }
    dict.set_item("statistics", statistics)?;
    let events: Vec<(f64, String)> = outcome.events.into_iter().map(|event| (event.time, event.part)).collect();
    dict.set_item("events", events)?;
    dict.set_item("time", PyArray1::from_vec(py, outcome.time))?;
    let columns: Vec<_> = outcome
        .columns
        .into_iter()
        .map(|column| (column.name, column.unit, PyArray1::from_vec(py, column.values)))
        .collect();
    dict.set_item("columns", columns)?;
    Ok(dict)
}
