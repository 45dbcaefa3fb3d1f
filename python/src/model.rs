//! One instance of a model, stepped by the caller.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use stribeck::instance::{Instance as Row, Phase};
use stribeck::model::ModelType;
use stribeck::serial;

use crate::catalogue::{self, column, find};
use crate::refused;

/// An instance of a model.
#[pyclass(frozen, module = "stribeck._stribeck")]
pub struct Instance {
    model: &'static ModelType,
    row: Mutex<Row>,
}

impl Instance {
    /// The row; a failed call has changed nothing, so that it may be used after a panic.
    fn row(&self) -> MutexGuard<'_, Row> {
        self.row.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn columns(&self, values: Vec<(String, f64)>) -> PyResult<Vec<(usize, f64)>> {
        values.into_iter().map(|(name, value)| Ok((column(self.model, &name)?, value))).collect()
    }
}

#[pymethods]
impl Instance {
    /// A model at its start values or with a preset.
    #[new]
    fn new(model: &str, preset: Option<&str>) -> PyResult<Instance> {
        let model = find(model)?;
        let mut row = Row::new(model);
        if let Some(preset) = catalogue::preset(model, preset)? {
            row.apply(preset);
        }
        Ok(Instance { model, row: Mutex::new(row) })
    }

    /// Sets variables, all or none; after the first step only inputs and tunable parameters.
    fn set(&self, values: Vec<(String, f64)>) -> PyResult<()> {
        let values = self.columns(values)?;
        let mut row = self.row();
        let phase = if row.time() > 0.0 { Phase::Stepping } else { Phase::Setup };
        row.set_all(phase, values.into_iter()).map_err(refused)
    }

    /// A value; a result is computed first.
    fn get(&self, name: &str) -> PyResult<f64> {
        self.row().get_column(column(self.model, name)?).map_err(refused)
    }

    /// Advances by `dt`, with slopes of inputs over the step.
    fn step(&self, dt: f64, slopes: Vec<(String, f64)>) -> PyResult<()> {
        let slopes = self.columns(slopes)?;
        let mut row = self.row();
        slopes.iter().try_for_each(|(column, slope)| row.check_slope(*column, *slope)).map_err(refused)?;
        slopes.iter().try_for_each(|(column, slope)| row.set_slope(*column, *slope)).map_err(refused)?;
        row.step(dt).map_err(refused)
    }

    /// Resets to the start values and to time 0.
    fn reset(&self) {
        self.row().reset();
    }

    /// Everything that changes in its life, for `load`.
    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let snapshot = self.row().save();
        PyBytes::new_with(py, serial::size(self.model), |bytes| {
            serial::write(self.model, &snapshot, [0.0; serial::OWNERS], bytes);
            Ok(())
        })
    }

    /// Goes on from what an instance of the same model has saved.
    fn load(&self, saved: &[u8]) -> PyResult<()> {
        let (snapshot, _) = serial::read(self.model, saved).map_err(refused)?;
        self.row().restore(&snapshot);
        Ok(())
    }

    /// Time in s.
    #[getter]
    fn time(&self) -> f64 {
        self.row().time()
    }

    /// Warning about values that make no sense here, or with which the model is not passive.
    fn warning(&self) -> Option<String> {
        self.row().warning_or_passivity().map(|warning| warning.to_string())
    }
}
