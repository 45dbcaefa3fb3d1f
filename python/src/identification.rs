//! Parameters of laws from measured friction.

use std::path::Path;

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_fit::identify::{Answer, Experiment, Files, Inquiry, Source, Watch};
use stribeck_sheet::{NORMAL_FORCE, Sheet, SheetError, TIME, VELOCITY};
use stribeck_solve::job::{Choice, options};
use stribeck_solve::system::Fault;

use crate::entries::described;
use crate::refused;
use crate::work::interruptible;

/// A column as it comes from Python.
enum Values {
    Array(Vec<f64>),
    /// The same number for all samples.
    Single(f64),
    /// Description of what is wrong with it, which matters only if the column is used.
    Wrong(String),
}

impl Values {
    fn of(values: &Bound<PyAny>) -> PyResult<Values> {
        if let Ok(text) = values.extract::<String>() {
            return Ok(Values::Wrong(text));
        }
        values.extract().map(Values::Array).or_else(|_| values.extract().map(Values::Single))
    }

    /// Numbers that stand for it in a table of so many rows.
    fn in_table(&self, rows: usize) -> Vec<f64> {
        match self {
            Values::Array(values) => values.clone(),
            Values::Single(value) => vec![*value; rows],
            Values::Wrong(_) => vec![0.0; rows],
        }
    }

    /// Description of what is wrong with it as the column of a quantity, in a table with this many samples.
    fn flaw(&self, quantity: &str, samples: usize, time: &str) -> Option<String> {
        match self {
            Values::Wrong(text) => Some(format!(" {text}")),
            Values::Single(_) if !quantity.eq_ignore_ascii_case(NORMAL_FORCE.name) => {
                Some(" is a single number: must be an array".to_owned())
            }
            Values::Single(value) => (!value.is_finite()).then(|| format!(" = {value}: must be a finite number")),
            Values::Array(values) if values.len() != samples => {
                Some(format!(" has {} values, {time} has {samples}", values.len()))
            }
            Values::Array(values) => {
                let at = values.iter().position(|value| !value.is_finite())?;
                Some(format!("[{at}] = {}: must be a finite number", values[at]))
            }
        }
    }
}

/// A table that was given as arrays, in the order of its columns.
struct Given {
    name: String,
    columns: Vec<(String, Values)>,
}

impl Given {
    fn new(name: String, columns: &Bound<PyDict>) -> PyResult<Given> {
        let read = columns.iter().map(|(name, values)| Ok((name.extract()?, Values::of(&values)?)));
        Ok(Given { name, columns: read.collect::<PyResult<_>>()? })
    }

    fn table(&self) -> Result<Sheet, SheetError> {
        let length = |values: &Values| if let Values::Array(all) = values { all.len() } else { 1 };
        let rows = self.columns.iter().map(|(_, values)| length(values)).max().unwrap_or(0);
        let filled = self.columns.iter().map(|(name, values)| (readable(name), values.in_table(rows)));
        Sheet::of_columns(&filled.collect::<Vec<_>>())
    }

    /// Refuses columns that are used and are not what they must be. Only when all have been given the names of their
    /// quantities is it known which are used; their order is still that in Python.
    fn check(&self, sheet: &Sheet, is_used: &dyn Fn(&str) -> bool) -> Result<(), Fault> {
        let columns = sheet.names().zip(&self.columns).map(|(now, (name, values))| (now, name, values));
        let columns: Vec<_> = columns.collect();
        let of = |quantity: &str| columns.iter().find(|(now, _, _)| now.eq_ignore_ascii_case(quantity));
        // A map has no time.
        let time = of(TIME.name).or_else(|| of(VELOCITY.name));
        let Some((_, time, values)) = time else { return Ok(()) };
        let samples = if let Values::Array(all) = values { all.len() } else { 1 };
        for (now, name, values) in &columns {
            if let Some(flaw) = values.flaw(now, samples, time).filter(|_| is_used(&now.to_lowercase())) {
                return Err(Fault::value(format_args!("{}: {name}{flaw}", self.name)));
            }
        }
        Ok(())
    }
}

/// Tables that were given as arrays; all others are in files.
struct Arrays(Vec<Given>);

impl Arrays {
    fn find(&self, record: &Path) -> Option<&Given> {
        self.0.iter().find(|given| Path::new(&given.name) == record)
    }
}

impl Source for Arrays {
    fn tables(&self, record: &Path, sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        self.find(record).map_or_else(|| Files.tables(record, sheet), |given| Ok(vec![given.table()?]))
    }

    fn check(&self, record: &Path, table: &Sheet, is_used: &dyn Fn(&str) -> bool) -> Result<(), Fault> {
        self.find(record).map_or(Ok(()), |given| given.check(table, is_used))
    }
}

/// The name of a column without what would divide or end the heading of a table.
fn readable(name: &str) -> String {
    name.replace([';', '\t', '\n', '\r', '"', '#'], "_")
}

/// Arrays of each record, by its name.
type Tables<'py> = Vec<(String, Bound<'py, PyDict>)>;

/// Fits laws to records as the entries describe it; `arrays` has the tables that are not in files, by name. The outcome
/// as JSON, and for each record a dictionary of arrays: time unless it is a map, velocity, normal_force, force, and the force that
/// the best law explains.
#[pyfunction]
pub fn identify<'py>(
    py: Python<'py>,
    entries: &Bound<'py, PyDict>,
    arrays: &Bound<'py, PyDict>,
) -> PyResult<(String, Tables<'py>)> {
    let inquiry: Inquiry = described(entries)?;
    let given = arrays.iter().map(|(name, columns)| Given::new(name.extract()?, columns.cast()?));
    let source = Arrays(given.collect::<PyResult<_>>()?);
    let outcome = interruptible(py, |cancel| {
        let data = inquiry.data(&source)?;
        let watch = Watch { cancel, progress: &|_, _| {} };
        let ranking = inquiry.fits(&data, &mut |_| {}, watch)?;
        let answer = serde_json::to_string(&Answer::of(&ranking, &data)).map_err(Fault::value)?;
        Ok::<_, Fault>((answer, ranking.best().clone(), data.experiments))
    })?;
    let (told, best, experiments) = outcome.map_err(refused)?;
    let found = best.predicted.into_iter().zip(best.fitted);
    let arrays = experiments.into_iter().zip(found).map(|(one, found)| Ok((one.name.clone(), table(py, one, found)?)));
    Ok((told, arrays.collect::<PyResult<_>>()?))
}

/// What the options mean, a line on each.
#[pyfunction]
pub fn identify_options() -> String {
    let own = ["records", "law", "motion", "hold_out"];
    let all = options::<Inquiry>().into_iter().filter(|option| !own.contains(&option.name.as_str()));
    let line = |Choice { name, help, choices, .. }: Choice| match choices.is_empty() {
        true => format!("`{name}`: {help}"),
        false => format!("`{name}`: {help} [{}]", choices.join(", ")),
    };
    all.map(line).collect::<Vec<String>>().join("\n    ")
}

/// An experiment with what the best law explains, and whether each sample was fitted.
fn table(
    py: Python<'_>,
    experiment: Experiment,
    (predicted, fitted): (Vec<f64>, Vec<bool>),
) -> PyResult<Bound<'_, PyDict>> {
    let table = PyDict::new(py);
    if experiment.map.is_none() {
        table.set_item("time", PyArray1::from_vec(py, experiment.time))?;
    }
    for (name, values) in [
        ("velocity", experiment.velocity),
        ("normal_force", experiment.normal_force),
        ("force", experiment.force),
        ("predicted", predicted),
    ] {
        table.set_item(name, PyArray1::from_vec(py, values))?;
    }
    table.set_item("fitted", PyArray1::from_vec(py, fitted))?;
    Ok(table)
}
