//! Studies: many runs of a system, one table.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_solve::study::{Description, Shard, Study};

use crate::entries::described;
use crate::refused;
use crate::work::{threads, watched};

/// The study of a file, or of a dictionary with the same entries.
fn read(study: &Bound<PyAny>) -> PyResult<Study> {
    if !study.is_instance_of::<PyDict>() {
        let path: PathBuf = study.extract()?;
        let folder = path.parent().map(PathBuf::from).unwrap_or_default();
        let description = stribeck_solve::system::read(&path).map_err(refused)?;
        return Study::new(description, &folder).map_err(refused);
    }
    let description: Description = described(study)?;
    Study::new(description, &PathBuf::new()).map_err(refused)
}

/// Makes a study, or a part of it; rows run, rows found, rows that failed. `progress` is called with the number of rows
/// that are done, and of all.
#[pyfunction]
#[pyo3(signature = (study, folder, *, shard, threads_asked, max_failures, progress))]
pub fn make_study(
    py: Python,
    study: &Bound<PyAny>,
    folder: PathBuf,
    shard: &str,
    threads_asked: Option<usize>,
    max_failures: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(usize, usize, usize)> {
    let study = read(study)?;
    let shard: Shard = shard.parse().map_err(refused)?;
    let threads = threads(threads_asked)?;
    let (rows, count) = (study.rows_of(shard), AtomicUsize::new(0));
    let make = |cancel: &_| {
        study.make(&folder, shard, threads, max_failures, cancel, &|rows| {
            count.fetch_add(rows, Ordering::Relaxed);
        })
    };
    let tell = |py: Python| match &progress {
        Some(progress) => progress.call1(py, (count.load(Ordering::Relaxed), rows)).map(|_| ()),
        None => Ok(()),
    };
    let done = watched(py, make, tell)?.map_err(refused)?;
    Ok((done.rows, done.found, done.failed))
}

/// Number and rows of each chunk that is not in the folder yet.
type Missing = Vec<(usize, usize)>;

/// A study's number of rows, of chunks, and what is missing.
#[pyfunction]
pub fn missing_chunks(study: &Bound<PyAny>, folder: PathBuf) -> PyResult<(usize, usize, Missing)> {
    let study = read(study)?;
    let (count, missing) = study.missing(&folder).map_err(refused)?;
    Ok((study.rows(), count, missing))
}

/// Joins the chunks of a study in a folder; the path of the table.
#[pyfunction]
pub fn merge_study(study: &Bound<PyAny>, folder: PathBuf) -> PyResult<PathBuf> {
    let table = folder.join("study.csv");
    read(study)?.merge(&folder, &table).map_err(refused)?;
    Ok(table)
}
