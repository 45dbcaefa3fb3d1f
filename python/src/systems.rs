//! The workbench's systems and solvers.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_solve::run::{
    Check, Column, CommunicationSteps, Configuration, Difference, Outcome, Settings, Solver, communication_steps, run,
    words,
};
use stribeck_solve::solve::Statistics;
use stribeck_solve::system::{BUILT_IN, Description, Fault, System};

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
    words::<Solver>()
        .map(|word| (word.get_name().to_owned(), word.get_help().map_or(String::new(), ToString::to_string)))
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
        let (systems, source) = chosen.systems()?;
        let results = chosen.results(&source);
        let outcome = |system: &System| {
            let settings = Settings { cancel: Some(cancel), ..chosen.settings(system)? };
            run(system, &settings, &results)
        };
        systems.iter().map(outcome).collect::<Result<Vec<Outcome>, Fault>>()
    })?;
    outcomes.map_err(refused)?.into_iter().map(|outcome| as_dict(py, outcome)).collect()
}

/// Searches for the largest communication step of a system with one law, or with its own; the answer as JSON. The entries
/// are those of a file of `stribeck run`.
#[pyfunction]
pub fn find_step(py: Python, entries: &Bound<PyDict>) -> PyResult<String> {
    let chosen: Configuration = described(entries)?;
    if chosen.vary.is_some() {
        return Err(refused("vary: a search is for one system"));
    }
    let found = interruptible(py, |cancel| -> Result<CommunicationSteps, Fault> {
        let (systems, source) = chosen.systems()?;
        let [system] = systems.as_slice() else { return Err(Fault::value("law: a search is for one law")) };
        let (settings, search) = chosen.search(system)?;
        let settings = Settings { cancel: Some(cancel), ..settings };
        communication_steps(system, &settings, &chosen.results(&source), &search)
    })?;
    serde_json::to_string(&found.map_err(refused)?).map_err(refused)
}

fn as_dict<'py>(py: Python<'py>, outcome: Outcome) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("law", outcome.law.map(|law| law.name))?;
    dict.set_item("solver", outcome.solver.to_string())?;
    dict.set_item("end", outcome.end.to_string())?;
    dict.set_item("reached", outcome.is_reached())?;
    dict.set_item("fault", outcome.fault())?;
    dict.set_item("check", outcome.check.map(|check| check_as_dict(py, check)).transpose()?)?;
    dict.set_item("seconds", outcome.elapsed.as_secs_f64())?;
    let statistics = PyDict::new(py);
    let Statistics { steps, rejected, evaluations, jacobians, .. } = outcome.statistics;
    statistics.set_item("steps", steps)?;
    statistics.set_item("rejected", rejected)?;
    statistics.set_item("evaluations", evaluations)?;
    statistics.set_item("jacobians", jacobians)?;
    dict.set_item("statistics", statistics)?;
    let events: Vec<(f64, String)> = outcome.events.into_iter().map(|event| (event.time, event.part)).collect();
    dict.set_item("events", events)?;
    dict.set_item("time", PyArray1::from_vec(py, outcome.time))?;
    let column = |column: Column| (column.name, column.unit, PyArray1::from_vec(py, column.values));
    dict.set_item("columns", outcome.columns.into_iter().map(column).collect::<Vec<_>>())?;
    Ok(dict)
}

fn check_as_dict<'py>(py: Python<'py>, check: Check) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("of", check.of.name())?;
    dict.set_item("finer", check.finer)?;
    dict.set_item("end", check.end.to_string())?;
    dict.set_item("fault", check.fault)?;
    let difference = |Difference { name, largest, part, time, .. }| (name, (largest, part, time));
    dict.set_item("differences", check.differences.into_iter().map(difference).collect::<Vec<_>>())?;
    Ok(dict)
}
