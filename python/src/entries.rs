//! Dictionaries of Python as what a file would hold.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyList, PyTuple};
use serde::de::DeserializeOwned;
use stribeck_solve::job;

use crate::refused;

/// Levels of dictionaries and lists (chosen): far more than any file has, and far fewer than the stack holds. A dictionary
/// may contain itself.
const DEEPEST: usize = 32;

/// The value that a dictionary describes, as a file with its entries would.
pub fn described<T: DeserializeOwned>(value: &Bound<PyAny>) -> PyResult<T> {
    job::of_value(as_toml(value, DEEPEST)?).map_err(refused)
}

/// An error of a wrong type with the name of the entry; others are as they were.
fn named(py: Python, name: &str, error: PyErr) -> PyErr {
    if error.is_instance_of::<PyTypeError>(py) {
        return PyTypeError::new_err(format!("{name}: {}", error.value(py)));
    }
    error
}

/// A value as an entry of a TOML file.
fn as_toml(value: &Bound<PyAny>, levels: usize) -> PyResult<toml::Value> {
    let Some(levels) = levels.checked_sub(1) else {
        return Err(refused(format_args!("dictionaries and lists in more than {DEEPEST} levels")));
    };
    if let Ok(dict) = value.cast::<PyDict>() {
        let entries = dict.iter().map(|(name, value)| {
            let name: String = name.extract()?;
            let entry = as_toml(&value, levels).map_err(|error| named(value.py(), &name, error))?;
            Ok((name, entry))
        });
        return Ok(toml::Value::Table(entries.collect::<PyResult<_>>()?));
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        let items = value.try_iter()?.map(|item| as_toml(&item?, levels));
        return Ok(toml::Value::Array(items.collect::<PyResult<_>>()?));
    }
    // Numbers and arrays of numpy.
    match value.getattr_opt("tolist")? {
        Some(plain) => as_toml(&plain.call0()?, levels),
        None => one_as_toml(value),
    }
}

/// A value that is neither a dictionary nor a list.
fn one_as_toml(value: &Bound<PyAny>) -> PyResult<toml::Value> {
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
