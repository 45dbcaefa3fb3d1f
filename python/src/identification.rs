//! Parameters of laws from measured friction.

use std::path::{Path, PathBuf};

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck::model::ModelType;
use stribeck_fit::identify::{Experiment, Task, Watch, Wishes, as_json, axis, fit_all, held_out, laws_named, names};
use stribeck_fit::measured::{Columns, Delay, Record, Rig};
use stribeck_fit::sheet::{DISPLACEMENT, NORMAL_FORCE, Sheet, TIME, VELOCITY, tables};
use stribeck_solve::system::Fault;

use crate::refused;
use crate::work::interruptible;

/// Properties of a rig, and how laws are fitted to its records.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Known {
    mass: f64,
    normal_force: Option<f64>,
    window: Option<f64>,
    column: Vec<(String, String)>,
    scale: Vec<(String, f64)>,
    delay: Option<f64>,
    finds_delay: bool,
    longest_delay: Option<f64>,
    skip: f64,
    fix: Vec<(String, f64)>,
    fit: Vec<String>,
    range: Vec<(String, [f64; 2])>,
    budget: Option<u64>,
    seed: Option<u64>,
    repetitions: Option<usize>,
    is_robust: bool,
    folds: usize,
    rest: Option<f64>,
    axis: bool,
}

impl Known {
    fn split(self) -> PyResult<(Rig, Task)> {
        if let Some(longest) = self.longest_delay.filter(|_| !self.finds_delay) {
            let text =
                format_args!("longest_delay = {longest}: needs delay=\"find\", otherwise no delay is looked for");
            return Err(refused(text));
        }
        let mut wishes = Wishes { fixed: self.fix, fitted: self.fit, ranges: self.range };
        if self.axis {
            axis::fitted(&mut wishes, self.mass);
        }
        let delay = match self.delay {
            Some(delay) => Delay::Known(delay),
            None if self.finds_delay => Delay::Find(self.longest_delay.unwrap_or(Delay::LONGEST)),
            None if self.axis => Delay::OfController,
            None => Delay::Known(0.0),
        };
        let Known { mass, window, skip, .. } = self;
        let normal_force = self.normal_force.or(self.axis.then_some(axis::NORMAL_FORCE));
        let usual = Task::default();
        let task = Task {
            wishes,
            budget: self.budget.unwrap_or(usual.budget),
            seed: self.seed.unwrap_or(usual.seed),
            repetitions: self.repetitions.unwrap_or(usual.repetitions),
            mass,
            is_robust: self.is_robust,
            folds: self.folds,
            ..usual
        };
        Ok((Rig { mass, normal_force, window, delay, skip, is_axis: self.axis }, task))
    }
}

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

/// The columns that a table was made of; none for a file.
struct Given(Vec<(String, Values)>);

impl Given {
    /// A table from the path of a file, or from a dictionary of arrays.
    fn read(table: &Bound<PyAny>) -> PyResult<(Sheet, Given)> {
        if let Ok(columns) = table.cast::<PyDict>() {
            let read = columns.iter().map(|(name, values)| Ok((name.extract()?, Values::of(&values)?)));
            let columns: Vec<(String, Values)> = read.collect::<PyResult<_>>()?;
            let rows = columns.iter().map(|(_, values)| if let Values::Array(all) = values { all.len() } else { 1 });
            let rows = rows.max().unwrap_or(0);
            let filled: Vec<_> = columns.iter().map(|(name, values)| (readable(name), values.in_table(rows))).collect();
            return Ok((Sheet::of_columns(&filled).map_err(refused)?, Given(columns)));
        }
        let path = table.extract::<PathBuf>()?;
        let mut all = tables(&path).map_err(refused)?;
        if all.len() != 1 {
            let text = format!("{}: has tables of {} clocks: give the arrays of each", path.display(), all.len());
            return Err(refused(text));
        }
        Ok((all.swap_remove(0), Given(Vec::new())))
    }

    /// Refuses columns that are used and are not what they must be. Only when all have been given the names of their
    /// quantities is it known which are used; their order is still that in Python.
    fn check(&self, sheet: &Sheet, who: &str, is_used: impl Fn(&str) -> bool) -> PyResult<()> {
        let columns: Vec<_> = sheet.names().zip(&self.0).map(|(now, (name, values))| (now, name, values)).collect();
        let time = columns.iter().find(|(now, _, _)| now.eq_ignore_ascii_case(TIME.name));
        let Some((_, time, values)) = time else { return Ok(()) };
        let samples = if let Values::Array(all) = values { all.len() } else { 1 };
        for (now, name, values) in &columns {
            if let Some(flaw) = values.flaw(now, samples, time).filter(|_| is_used(&now.to_lowercase())) {
                return Err(refused(format_args!("{who}: {name}{flaw}")));
            }
        }
        Ok(())
    }
}

/// The name of a column without what would divide or end the heading of a table.
fn readable(name: &str) -> String {
    name.replace([';', '\t', '\n', '\r', '"', '#'], "_")
}

/// Whether a table of the motion has a quantity.
fn is_of_motion(quantity: &str) -> bool {
    [TIME, DISPLACEMENT, VELOCITY].iter().any(|known| known.name == quantity)
}

/// Reads records.
struct Reader<'py> {
    columns: Columns,
    rig: Rig,
    /// Table of the motion.
    motion: Option<Bound<'py, PyAny>>,
    rest: Option<f64>,
    laws: Vec<&'static ModelType>,
}

impl Reader<'_> {
    /// A record as it is fitted, and what is to be known of it.
    fn read(&self, name: &str, table: &Bound<PyAny>) -> PyResult<(Experiment, Vec<String>)> {
        let of = |error: &dyn std::fmt::Display| refused(format_args!("{name}: {error}"));
        let (own, given) = Given::read(table)?;
        let (mut other, motion): (Vec<Sheet>, Vec<Given>) =
            self.motion.iter().map(Given::read).collect::<PyResult<Vec<_>>>()?.into_iter().unzip();
        let mut own = [own];
        let mut said = self.columns.apply(&mut own, &mut other, &self.rig).map_err(|error| of(&error))?;
        let [own] = own;
        let is_elsewhere = |quantity: &str| !motion.is_empty() && quantity != TIME.name && is_of_motion(quantity);
        given.check(&own, name, |quantity| Columns::knows(quantity) && !is_elsewhere(quantity))?;
        for (given, sheet) in motion.iter().zip(&other) {
            given.check(sheet, "motion", is_of_motion)?;
        }
        let record = Record::of(&own, other.first(), &self.rig).map_err(|error| of(&error))?;
        said.extend(record.quality.findings.iter().cloned());
        let all = Experiment::new(name, &record);
        let experiment = match self.rest {
            Some(rest) => all.without_rest(rest),
            None if self.rig.is_axis => axis::in_motion(all, &self.laws),
            None => Ok(all),
        };
        let experiment = experiment.map_err(refused)?;
        said.insert(0, experiment.beginning().to_owned());
        Ok((experiment, said))
    }
}

/// Names of records. Two files that differ only in their endings have the same, and keep their whole paths: results are
/// found by these names.
fn different_names(files: &[&Path]) -> Vec<String> {
    let short = names(files);
    let is_alone = |name: &String| short.iter().filter(|other| *other == name).count() == 1;
    let of = |(name, file): (&String, &&Path)| if is_alone(name) { name.clone() } else { file.display().to_string() };
    short.iter().zip(files).map(of).collect()
}

/// Arrays of each record, by its name.
type Tables<'py> = Vec<(String, Bound<'py, PyDict>)>;

/// Fits laws to records, and holds them against records that are not fitted. The outcome as JSON, and for each record a
/// dictionary of arrays: time, velocity, normal_force, force, and the force that the best law explains.
#[pyfunction]
pub fn identify<'py>(
    py: Python<'py>,
    records: Vec<(String, Bound<'py, PyAny>)>,
    unseen: Vec<(String, Bound<'py, PyAny>)>,
    motion: Option<Bound<'py, PyAny>>,
    laws: Vec<String>,
    known: Known,
) -> PyResult<(String, Tables<'py>)> {
    let laws = if laws.is_empty() && known.axis { vec![axis::LAW.to_owned()] } else { laws };
    let laws = laws_named(&laws).map_err(refused)?;
    let columns = Columns { names: known.column.clone(), factors: known.scale.clone() };
    columns.check().map_err(refused)?;
    let rest = known.rest;
    let (rig, task) = known.split()?;
    if motion.is_some() && records.len() + unseen.len() > 1 {
        return Err(refused("motion: is for a single record"));
    }
    let reader = Reader { columns, rig, motion, rest, laws };
    let files: Vec<&Path> = records.iter().chain(&unseen).map(|(name, _)| Path::new(name)).collect();
    let mut names = different_names(&files).into_iter();
    let mut all = |tables: &[(String, Bound<'py, PyAny>)]| -> PyResult<(Vec<Experiment>, Vec<Vec<String>>)> {
        let read: PyResult<Vec<_>> =
            tables.iter().zip(names.by_ref()).map(|((_, table), name)| reader.read(&name, table)).collect();
        Ok(read?.into_iter().unzip())
    };
    let ((experiments, findings), (unseen, _)) = (all(&records)?, all(&unseen)?);
    let laws = &reader.laws;
    let outcome = interruptible(py, |cancel| {
        let watch = Watch { cancel, progress: &|_, _| {} };
        let mut ranking = fit_all(laws, &experiments, &task, &mut |_| {}, watch)?;
        for fit in &mut ranking.fits {
            let found = held_out(fit, &unseen)?;
            fit.saw(found);
        }
        Ok::<_, Fault>((as_json(&ranking), ranking.best().clone()))
    })?;
    let (mut told, best) = outcome.map_err(refused)?;
    for (one, said) in experiments.iter().zip(findings) {
        told["findings"][one.name.as_str()] = said.into();
    }
    let found = best.explained.into_iter().zip(best.fitted);
    let arrays = experiments.into_iter().zip(found).map(|(one, found)| Ok((one.name.clone(), table(py, one, found)?)));
    Ok((told.to_string(), arrays.collect::<PyResult<_>>()?))
}

/// An experiment with what the best law explains, and whether each sample was fitted.
fn table(
    py: Python<'_>,
    experiment: Experiment,
    (explained, fitted): (Vec<f64>, Vec<bool>),
) -> PyResult<Bound<'_, PyDict>> {
    let table = PyDict::new(py);
    for (name, values) in [
        ("time", experiment.time),
        ("velocity", experiment.velocity),
        ("normal_force", experiment.normal_force),
        ("force", experiment.force),
        ("explained", explained),
    ] {
        table.set_item(name, PyArray1::from_vec(py, values))?;
    }
    table.set_item("fitted", PyArray1::from_vec(py, fitted))?;
    Ok(table)
}
