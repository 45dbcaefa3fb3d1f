//! Studies: many runs of a system, one table.

use std::path::PathBuf;

use lab::study::{Description, Shard, Study};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::entries::described;
use crate::refused;
use crate::work::{interruptible, threads};

/// The study of a file, or of a dictionary with the same entries.
fn read(study: &Bound<PyAny>) -> PyResult<Study> {
    if !study.is_instance_of::<PyDict>() {
        let path: PathBuf = study.extract()?;
        let folder = path.parent().map(PathBuf::from).unwrap_or_default();
        let description = lab::system::read(&path).map_err(refused)?;
        return Study::new(description, &folder).map_err(refused);
    }
    let description: Description = described(study)?;
    Study::new(description, &PathBuf::new()).map_err(refused)
}

/// Makes a study, or a part of it; rows run, rows found, rows that failed.
#[pyfunction]
#[pyo3(signature = (study, folder, *, shard, threads_asked, max_failures))]
pub fn make_study(
    py: Python,
    study: &Bound<PyAny>,
    folder: PathBuf,
    shard: &str,
    threads_asked: Option<usize>,
    max_failures: Option<usize>,
) -> PyResult<(usize, usize, usize)> {
    let study = read(study)?;
    let shard: Shard = shard.parse().map_err(refused)?;
    let threads = threads(threads_asked)?;
    let make = |cancel: &_| study.make(&folder, shard, threads, max_failures, cancel, &|_| {});
    let done = interruptible(py, make)?.map_err(refused)?;
    Ok((done.rows, done.found, done.failed))
}

/// Number of chunks of a study, and the numbers of those that are not in the folder yet.
#[pyfunction]
pub fn missing_chunks(study: &Bound<PyAny>, folder: PathBuf) -> PyResult<(usize, Vec<usize>)> {
    read(study)?.missing(&folder).map_err(refused)
}

/// Joins the chunks of a study in a folder; the path of the table.
#[pyfunction]
pub fn merge_study(study: &Bound<PyAny>, folder: PathBuf) -> PyResult<PathBuf> {
    let table = folder.join("study.csv");
    read(study)?.merge(&folder, &table).map_err(refused)?;
    Ok(table)
}
