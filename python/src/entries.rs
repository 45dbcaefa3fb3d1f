//! Dictionaries of Python as what a file would hold.

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyList, PyTuple};

/// A value as an entry of a TOML file.
pub fn as_toml(value: &Bound<PyAny>) -> PyResult<toml::Value> {
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
