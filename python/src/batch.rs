//! Many instances of one model, stepped together by the caller.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, TryLockError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use stribeck::batch::{Registers, Stepped, Stopped, Wanted};
use stribeck::memory::OutOfMemory;
use stribeck::model::{Fault, Kind, ModelType, Role};
use stribeck::series::Ended;

use crate::catalogue::{column, find, preset as known_preset};
use crate::places::Given;
use crate::refused;

/// Runs of a model.
#[pyclass(frozen, module = "stribeck._stribeck")]
pub struct Batch {
    model: &'static ModelType,
    runs: Mutex<Runs>,
}

struct Runs {
    stepped: Stepped,
    /// Inputs of a step: other threads of Python may write to their arrays meanwhile.
    copies: Vec<Vec<f64>>,
}

/// Columns with their values, one for all runs, or one for each.
type Named<'py> = Vec<(usize, PyReadonlyArray1<'py, f64>)>;

fn full(_: OutOfMemory) -> PyErr {
    PyMemoryError::new_err("out of memory")
}

fn stopped((run, ended): Stopped) -> PyErr {
    match ended {
        Ended::OutOfMemory => full(OutOfMemory),
        ended => refused(format_args!("run {run}: {ended}")),
    }
}

/// Slices of arrays.
fn slices<'a>(named: &'a Named) -> PyResult<Vec<(usize, &'a [f64])>> {
    named.iter().map(|(column, array)| Ok((*column, array.as_slice()?))).collect()
}

impl Batch {
    /// The runs, if no other thread works with them. A panic may have left them within a step.
    fn runs(&self) -> PyResult<MutexGuard<'_, Runs>> {
        match self.runs.try_lock() {
            Ok(runs) => Ok(runs),
            Err(TryLockError::Poisoned(_)) => Err(refused("an earlier call of this batch panicked: make a new one")),
            Err(TryLockError::WouldBlock) => Err(refused("another thread works with the batch")),
        }
    }
}

/// Writes results into an array of the caller.
fn writing<'a>(out: &'a mut Given, path: String) -> PyResult<Box<Writing<'a>>> {
    Ok(match out {
        Given::Double(array) => {
            let values = array.as_slice_mut()?;
            Box::new(move |runs, results| {
                values[runs].copy_from_slice(results);
                Ok(())
            })
        }
        Given::Single(array) => {
            let values = array.as_slice_mut()?;
            Box::new(move |runs, results| {
                for (place, (value, result)) in values[runs].iter_mut().zip(results).enumerate() {
                    *value = *result as f32;
                    if value.is_infinite() {
                        let text = format_args!("{path} = {result}: beyond the largest number of float32, 3.4e38");
                        return Err((place, Fault::new(text)));
                    }
                }
                Ok(())
            })
        }
    })
}

type Writing<'a> = dyn FnMut(Range<usize>, &[f64]) -> Result<(), (usize, Fault)> + Send + 'a;

#[pymethods]
impl Batch {
    /// Runs at the start values of a model, or with a preset.
    #[new]
    fn new(model: &str, preset: Option<&str>, runs: usize) -> PyResult<Batch> {
        let model = find(model)?;
        let mut stepped = Stepped::new(model, Registers::best(), runs).map_err(full)?;
        let preset = known_preset(model, preset)?;
        if let Some(preset) = model.presets.iter().find(|known| Some(known.name) == preset) {
            let values =
                preset.values.iter().map(|(name, value)| Ok((column(model, name)?, std::slice::from_ref(value))));
            stepped.set(&values.collect::<PyResult<Vec<_>>>()?).map_err(stopped)?;
        }
        Ok(Batch { model, runs: Mutex::new(Runs { stepped, copies: Vec::new() }) })
    }

    /// The column of a variable.
    fn column(&self, name: &str) -> PyResult<usize> {
        column(self.model, name)
    }

    /// Sets columns, all or none.
    fn set(&self, values: Named) -> PyResult<()> {
        self.runs()?.stepped.set(&slices(&values)?).map_err(stopped)
    }

    /// Advances all runs by `dt` with these inputs, and writes an output.
    fn step(&self, py: Python, dt: f64, inputs: Named, result: usize, mut out: Given) -> PyResult<()> {
        let mut runs = self.runs()?;
        let Runs { stepped, copies } = &mut *runs;
        copies.resize_with(copies.len().max(inputs.len()), Vec::new);
        for (copy, (_, values)) in copies.iter_mut().zip(slices(&inputs)?) {
            copy.clear();
            copy.extend_from_slice(values);
        }
        let columns = inputs.iter().map(|(column, _)| *column);
        let inputs: Vec<(usize, &[f64])> = columns.zip(copies.iter().map(Vec::as_slice)).collect();
        let mut write = writing(&mut out, self.model.table.at(result).path.to_string())?;
        py.detach(|| stepped.step(dt, &inputs, result, &mut *write)).map_err(stopped)
    }

    /// Writes a column.
    fn get(&self, py: Python, column: usize, mut out: Given) -> PyResult<()> {
        let mut runs = self.runs()?;
        let stepped = &mut runs.stepped;
        let mut write = writing(&mut out, self.model.table.at(column).path.to_string())?;
        py.detach(|| stepped.get(column, &mut *write)).map_err(stopped)
    }

    /// Resets the states of all runs, or of those with `mask`.
    fn reset(&self, mask: Option<PyReadonlyArray1<bool>>) -> PyResult<()> {
        let mut runs = self.runs()?;
        let stepped = &mut runs.stepped;
        match mask {
            Some(mask) => {
                let mask = mask.as_slice()?;
                stepped.reset(|run| mask[run]);
            }
            None => stepped.reset(|_| true),
        }
        Ok(())
    }

    /// Time of each run in s.
    fn times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_slice(py, self.runs()?.stepped.times()))
    }

    /// Whether the states of the runs are all variables.
    fn shows_all_states(&self) -> PyResult<bool> {
        self.runs()?.stepped.shows_all_states().map_err(stopped)
    }

    /// Derivatives of columns by others, present ones or over a step: for each pair an array.
    fn derivatives<'py>(
        &self,
        py: Python<'py>,
        of: Vec<usize>,
        by: Vec<usize>,
        dt: Option<f64>,
    ) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
        let mut runs = self.runs()?;
        let stepped = &mut runs.stepped;
        for column in of.iter().chain(&by) {
            let variable = self.model.table.at(*column);
            if !matches!(variable.kind, Kind::Real(_)) || variable.is_advice {
                return Err(refused(format_args!("{} has no derivative", variable.path)));
            }
        }
        if let Some(column) = by.iter().find(|column| self.model.table.at(**column).role == Role::Output) {
            let path = self.model.table.at(*column).path;
            return Err(refused(format_args!("{path} is computed: derivatives are by inputs, parameters and states")));
        }
        if dt.is_some() && !stepped.differentiates_steps() {
            let text = "has modes, whose steps have no derivatives: leave out dt for those of the present outputs";
            return Err(refused(format_args!("{} {text}", self.model.name)));
        }
        let count = stepped.runs();
        let mut found = vec![vec![0.0; count]; of.len() * by.len()];
        let pairs = by.len();
        let wanted = Wanted { of: &of, by: &by, dt };
        let mut take = |[of, by]: [usize; 2], run: usize, slope: f64| found[of * pairs + by][run] = slope;
        py.detach(|| stepped.derivatives(wanted, &mut take)).map_err(stopped)?;
        Ok(found.into_iter().map(|values| PyArray1::from_vec(py, values)).collect())
    }
}
