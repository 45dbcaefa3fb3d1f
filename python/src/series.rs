//! Models over arrays of samples, and settled results over arrays of inputs.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use stribeck::instance::Instance;
use stribeck::model::ModelType;
use stribeck::series::{Between, Course, Ended, Input, Times, set_up};

use crate::catalogue::{column, find, preset as known_preset};
use crate::refused;
use crate::work::{interruptible, threads};

/// Names with rows of values: one row for all runs, or one for each.
type Named<'py> = Vec<(String, PyReadonlyArray2<'py, f64>)>;

/// A variable with its rows, copied: other threads of Python may write to the arrays meanwhile.
struct Rows {
    column: usize,
    rows: usize,
    width: usize,
    values: Vec<f64>,
}

impl Rows {
    fn row(&self, run: usize) -> &[f64] {
        let first = if self.rows == 1 { 0 } else { run * self.width };
        &self.values[first..first + self.width]
    }
}

fn rows(model: &'static ModelType, named: Named) -> PyResult<Vec<Rows>> {
    let copied = named.into_iter().map(|(name, array)| {
        let [rows, width] = [array.shape()[0], array.shape()[1]];
        let mut values = reserved(rows * width)?;
        match array.as_slice() {
            Ok(slice) => values.extend_from_slice(slice),
            Err(_) => values.extend(array.as_array().iter()),
        }
        Ok(Rows { column: column(model, &name)?, rows, width, values })
    });
    copied.collect()
}

fn reserved(length: usize) -> PyResult<Vec<f64>> {
    let mut values = Vec::new();
    values.try_reserve_exact(length).map_err(|_| PyMemoryError::new_err(format!("no memory for {length} numbers")))?;
    Ok(values)
}

fn filled(length: usize) -> PyResult<Vec<f64>> {
    let mut values = reserved(length)?;
    values.resize(length, f64::NAN);
    Ok(values)
}

fn columns(model: &'static ModelType, names: &[String]) -> PyResult<Vec<usize>> {
    names.iter().map(|name| column(model, name)).collect()
}

/// Settings shared by all runs.
struct Runs<'a> {
    model: &'static ModelType,
    preset: Option<&'a str>,
    parameters: Vec<Rows>,
    results: Vec<usize>,
    /// Word for one of them in a message.
    each: &'static str,
    count: usize,
    /// Samples of each.
    samples: usize,
    threads: usize,
}

impl Runs<'_> {
    /// Makes every run once, with an instance per thread; the first error ends them all. The slots hold what belongs to
    /// each run.
    fn make<S: Send>(
        &self,
        slots: Vec<S>,
        cancel: &AtomicBool,
        run: impl Fn(usize, &mut Instance, S) -> Result<(), Ended> + Sync,
    ) -> Result<(), (usize, Ended)> {
        let slots: Vec<Mutex<Option<S>>> = slots.into_iter().map(|slot| Mutex::new(Some(slot))).collect();
        let (next, failed) = (AtomicUsize::new(0), Mutex::new(None::<(usize, Ended)>));
        let work = || {
            let mut instance = Instance::new(self.model);
            loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some(slot) = slots.get(number) else { return };
                let slot = slot.lock().ok().and_then(|mut slot| slot.take());
                let Some(slot) = slot else { return };
                let done = self.begin(number, &mut instance).and_then(|()| run(number, &mut instance, slot));
                if let Err(ended) = done {
                    // The lowest run is the one that is reported, whichever thread is first.
                    if let Ok(mut failed) = failed.lock()
                        && failed.as_ref().is_none_or(|(other, _)| number < *other)
                    {
                        *failed = Some((number, ended));
                    }
                    next.store(usize::MAX / 2, Ordering::Relaxed);
                    return;
                }
                if cancel.load(Ordering::Relaxed) {
                    return;
                }
            }
        };
        thread::scope(|scope| {
            for _ in 1..self.threads {
                scope.spawn(work);
            }
            work();
        });
        failed.into_inner().ok().flatten().map_or(Ok(()), Err)
    }

    fn begin(&self, run: usize, instance: &mut Instance) -> Result<(), Ended> {
        instance.reset();
        if let Some(preset) = self.preset {
            instance.apply(preset);
        }
        let values: Vec<(usize, f64)> = self.parameters.iter().map(|rows| (rows.column, rows.row(run)[0])).collect();
        set_up(instance, &values)
    }

    /// Makes every run, without the interpreter's lock; one array per result, run after run.
    fn arrays<'py>(
        &self,
        py: Python<'py>,
        run: impl Fn(usize, &mut Instance, Vec<&mut [f64]>, &AtomicBool) -> Result<(), Ended> + Send + Sync,
    ) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
        let length = self.count * self.samples;
        let mut arrays = self.results.iter().map(|_| filled(length)).collect::<PyResult<Vec<_>>>()?;
        let done = interruptible(py, |cancel| {
            let slots = cut(&mut arrays, self.count, self.samples);
            self.make(slots, cancel, |number, instance, slot| run(number, instance, slot, cancel))
        })?;
        done.map_err(|failure| self.text(failure))?;
        Ok(arrays.into_iter().map(|array| PyArray1::from_vec(py, array)).collect())
    }

    /// The text of a failure; it names the run if there are several.
    fn text(&self, (run, ended): (usize, Ended)) -> PyErr {
        if self.count == 1 { refused(ended) } else { refused(format_args!("{} {run}: {ended}", self.each)) }
    }
}

/// Arrays of one value per result, run and sample, cut into what each run writes.
fn cut(arrays: &mut [Vec<f64>], runs: usize, samples: usize) -> Vec<Vec<&mut [f64]>> {
    let mut slots: Vec<Vec<&mut [f64]>> = (0..runs).map(|_| Vec::with_capacity(arrays.len())).collect();
    for array in arrays {
        for (slot, part) in slots.iter_mut().zip(array.chunks_mut(samples.max(1))) {
            slot.push(part);
        }
    }
    slots
}

/// A model over samples: one flat array per result, run after run.
#[pyfunction]
#[pyo3(signature = (model, *, preset, parameters, inputs, dt, times, held, results, runs, samples, threads_asked))]
#[allow(clippy::too_many_arguments, reason = "keywords of a call from Python")]
pub fn follow<'py>(
    py: Python<'py>,
    model: &str,
    preset: Option<String>,
    parameters: Named<'py>,
    inputs: Named<'py>,
    dt: f64,
    times: Option<PyReadonlyArray1<'py, f64>>,
    held: bool,
    results: Vec<String>,
    runs: usize,
    samples: usize,
    threads_asked: Option<usize>,
) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
    let model = find(model)?;
    let inputs = rows(model, inputs)?;
    let times: Option<Vec<f64>> = times.map(|times| times.as_array().iter().copied().collect());
    let between = if held { Between::Held } else { Between::Linear };
    let common = Runs {
        model,
        preset: known_preset(model, preset.as_deref())?,
        parameters: rows(model, parameters)?,
        results: columns(model, &results)?,
        each: "run",
        count: runs,
        samples,
        threads: threads(threads_asked)?.get().min(runs),
    };
    common.arrays(py, |run, instance, mut slot, cancel| {
        let given = inputs.iter().map(|rows| Input { column: rows.column, samples: rows.row(run) });
        let inputs: Vec<Input> = given.collect();
        let times = times.as_deref().map_or(Times::Every(dt), Times::At);
        let course = Course { inputs: &inputs, times, samples, between };
        stribeck::series::follow(instance, &course, &common.results, &mut slot, cancel)
    })
}

/// Settled results: one array per result, one value per point.
#[pyfunction]
#[pyo3(signature = (model, *, preset, parameters, inputs, results, points, threads_asked))]
#[allow(clippy::too_many_arguments, reason = "keywords of a call from Python")]
pub fn settle<'py>(
    py: Python<'py>,
    model: &str,
    preset: Option<String>,
    parameters: Named<'py>,
    inputs: Named<'py>,
    results: Vec<String>,
    points: usize,
    threads_asked: Option<usize>,
) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
    let model = find(model)?;
    let inputs = rows(model, inputs)?;
    let common = Runs {
        model,
        preset: known_preset(model, preset.as_deref())?,
        parameters: rows(model, parameters)?,
        results: columns(model, &results)?,
        each: "point",
        count: points,
        samples: 1,
        threads: threads(threads_asked)?.get().min(points),
    };
    common.arrays(py, |point, instance, mut slot, cancel| {
        let held: Vec<(usize, f64)> = inputs.iter().map(|rows| (rows.column, rows.row(point)[0])).collect();
        let mut values = vec![0.0; slot.len()];
        stribeck::series::settle(instance, &held, &common.results, &mut values, cancel)?;
        slot.iter_mut().zip(values).for_each(|(place, value)| place[0] = value);
        Ok(())
    })
}
