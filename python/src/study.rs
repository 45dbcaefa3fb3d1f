//! Studies: many runs of a system, one table.

use std::path::PathBuf;

use lab::study::{Description, Shard, Study};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyList, PyTuple};

use crate::refused;
use crate::work::{interruptible, threads};

/// The study of a file, or of a dictionary with the same entries.
fn read(study: &Bound<PyAny>) -> PyResult<Study> {
    let Ok(dict) = study.cast::<PyDict>() else {
        let path: PathBuf = study.extract()?;
        let folder = path.parent().map(PathBuf::from).unwrap_or_default();
        return Study::new(Description::load(&path).map_err(refused)?, &folder).map_err(refused);
    };
    let description: Description = as_toml(dict)?.try_into().map_err(refused)?;
    Study::new(description, &PathBuf::new()).map_err(refused)
}

/// An entry of a study.
fn as_toml(value: &Bound<PyAny>) -> PyResult<toml::Value> {
    if let Ok(dict) = value.cast::<PyDict>() {
        let entries = dict.iter().map(|(name, value)| Ok((name.extract::<String>()?, as_toml(&value)?)));
        return Ok(toml::Value::Table(entries.collect::<PyResult<_>>()?));
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        let items = value.try_iter()?.map(|item| as_toml(&item?));
        return Ok(toml::Value::Array(items.collect::<PyResult<_>>()?));
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(toml::Value::Boolean(value.extract()?));
    }
    if value.is_instance_of::<PyInt>() {
        return Ok(toml::Value::Integer(value.extract()?));
    }
    match value.extract::<String>() {
        Ok(text) => Ok(toml::Value::String(text)),
        Err(_) => Ok(toml::Value::Float(value.extract()?)),
    }
}

/// Makes a study, or a part of it; rows run, rows found, rows that failed.
#[pyfunction]
#[pyo3(signature = (study, folder, *, shard, threads_asked))]
pub fn make_study(
    py: Python,
    study: &Bound<PyAny>,
    folder: PathBuf,
    shard: &str,
    threads_asked: Option<usize>,
) -> PyResult<(usize, usize, usize)> {
    let study = read(study)?;
    let shard: Shard = shard.parse().map_err(refused)?;
    let threads = threads(threads_asked, study.rows());
    let done = interruptible(py, |cancel| study.make(&folder, shard, threads, cancel, &|_| {}))?.map_err(refused)?;
    Ok((done.rows, done.found, done.failed))
}

/// Joins the chunks of a study in a folder; the path of the table.
#[pyfunction]
pub fn merge_study(study: &Bound<PyAny>, folder: PathBuf) -> PyResult<PathBuf> {
    let table = folder.join("study.csv");
    read(study)?.merge(&folder, &table).map_err(refused)?;
    Ok(table)
}
