//! Models over arrays of samples.

use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use stribeck::batch::{self, Registers, Runs, Worker};
use stribeck::instance::Instance;
use stribeck::model::ModelType;
use stribeck::series::{Between, Ended, Times, set_up};
use stribeck_solve::work::share;

use crate::catalogue::{column, find, preset as known_preset};
use crate::numbers::Numbers;
use crate::places::{Arrays, Given, Values, in_doubles};
use crate::refused;
use crate::work::{interruptible, threads};

/// Names with rows of values: one row for all runs, or one for each.
pub type Named<'py> = Vec<(String, PyReadonlyArray2<'py, f64>)>;

/// A variable with its rows, copied: other threads of Python may write to the arrays meanwhile.
pub struct Rows {
    column: usize,
    pub rows: usize,
    width: usize,
    values: Numbers,
}

impl Rows {
    fn row(&self, run: usize) -> &[f64] {
        let first = if self.rows == 1 { 0 } else { run * self.width };
        &self.values[first..first + self.width]
    }
}

pub fn rows(model: &'static ModelType, named: Named) -> PyResult<Vec<Rows>> {
    let copied = named.into_iter().map(|(name, array)| {
        let [rows, width] = [array.shape()[0], array.shape()[1]];
        let mut values = Numbers::with_room(rows * width)?;
        match array.as_slice() {
            Ok(slice) => values.extend(slice.iter().copied()),
            Err(_) => values.extend(array.as_array().iter().copied()),
        }
        Ok(Rows { column: column(model, &name)?, rows, width, values })
    });
    copied.collect()
}

fn columns(model: &'static ModelType, names: &[String]) -> PyResult<Vec<usize>> {
    names.iter().map(|name| column(model, name)).collect()
}

/// Settings shared by all runs.
pub struct Common<'a> {
    pub model: &'static ModelType,
    preset: Option<&'a str>,
    pub parameters: Vec<Rows>,
    pub results: Vec<usize>,
    /// Which of them had a value beyond the largest one of its array.
    pub beyond: Vec<AtomicBool>,
    /// Word for one of them in a message.
    each: &'static str,
    count: usize,
    /// Samples of each.
    samples: usize,
    /// Runs that are made in one call.
    pub together: usize,
    pub threads: usize,
}

/// Makes some of the runs with the instance of a thread.
pub type Make<'a> =
    dyn FnMut(Range<usize>, &mut Instance, &mut [Values], &AtomicBool) -> Result<(), (usize, Ended)> + 'a;

impl Common<'_> {
    /// The settings of a call; one sample each, and each in a call of its own.
    pub fn of<'a>(
        model: &'static ModelType,
        preset: Option<&'a str>,
        parameters: Named,
        results: &[String],
        (each, count): (&'static str, usize),
        asked: Option<usize>,
    ) -> PyResult<Common<'a>> {
        let preset = known_preset(model, preset)?;
        let (parameters, results) = (rows(model, parameters)?, columns(model, results)?);
        let beyond = results.iter().map(|_| AtomicBool::new(false)).collect();
        let threads = threads(asked)?.get();
        Ok(Common { model, preset, parameters, results, beyond, each, count, samples: 1, together: 1, threads })
    }

    /// Makes every run once, with an instance per thread; the first error ends them all. The slots hold what belongs to
    /// the runs that are made in one call.
    fn make<'a>(
        &self,
        slots: Vec<Vec<Values>>,
        cancel: &AtomicBool,
        worker: impl Fn() -> Box<Make<'a>> + Sync,
    ) -> Result<(), (usize, Ended)> {
        let slots: Vec<_> = slots.into_iter().map(|slot| Mutex::new(Some(slot))).collect();
        let failed = Mutex::new(None::<(usize, Ended)>);
        let worker = || {
            let (mut instance, mut make) = (Instance::new(self.model), worker());
            let (slots, failed) = (&slots, &failed);
            move |number: usize| {
                let Some(mut slot) = slots[number].lock().ok().and_then(|mut slot| slot.take()) else { return };
                let first = number * self.together;
                let some = first..self.count.min(first + self.together);
                if let Err((run, ended)) = make(some, &mut instance, &mut slot, cancel)
                    && let Ok(mut failed) = failed.lock()
                    // The lowest run is the one that is reported, whichever thread is first.
                    && failed.as_ref().is_none_or(|(other, _)| run < *other)
                {
                    *failed = Some((run, ended));
                }
            }
        };
        let goes_on = |number: usize| {
            let is_without_fault = failed.lock().is_ok_and(|failed| failed.is_none());
            is_without_fault && (number == 0 || !cancel.load(Ordering::Relaxed))
        };
        share(slots.len(), self.threads, goes_on, worker);
        failed.into_inner().ok().flatten().map_or(Ok(()), Err)
    }

    /// Brings an instance to the beginning of a run.
    pub fn begin(&self, run: usize, instance: &mut Instance) -> Result<(), Ended> {
        instance.reset();
        if let Some(preset) = self.preset {
            instance.apply(preset);
        }
        let values: Vec<(usize, f64)> = self.parameters.iter().map(|rows| (rows.column, rows.row(run)[0])).collect();
        set_up(instance, &values)
    }

    /// Makes every run, without the interpreter's lock, into the given arrays or new ones: one per result, run after run.
    /// Returns the new ones.
    pub fn arrays<'py, 'a>(
        &self,
        py: Python<'py>,
        out: Option<Vec<Given<'py>>>,
        worker: impl Fn() -> Box<Make<'a>> + Send + Sync,
    ) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
        let mut arrays = Arrays::of(out, self.results.len(), self.count * self.samples)?;
        let slots = cut(arrays.values()?, self.count.div_ceil(self.together), self.together * self.samples);
        interruptible(py, |cancel| self.make(slots, cancel, worker))?.map_err(|failure| self.text(failure))?;
        if let Some(number) = self.beyond.iter().position(|beyond| beyond.load(Ordering::Relaxed)) {
            let path = self.model.table.at(self.results[number]).path;
            return Err(refused(format_args!("{path} has values beyond the largest number of float32, 3.4e38")));
        }
        match arrays {
            Arrays::New(arrays) => arrays.into_iter().map(|array| array.into_array(py)).collect(),
            Arrays::Given(_) => Ok(Vec::new()),
        }
    }

    /// The text of a failure; it names the run if there are several.
    fn text(&self, (run, ended): (usize, Ended)) -> PyErr {
        if self.count == 1 { refused(ended) } else { refused(format_args!("{} {run}: {ended}", self.each)) }
    }
}

/// Values of each result, run after run, cut into what each call writes.
fn cut(arrays: Vec<Values<'_>>, calls: usize, length: usize) -> Vec<Vec<Values<'_>>> {
    let mut slots: Vec<Vec<Values>> = (0..calls).map(|_| Vec::with_capacity(arrays.len())).collect();
    for array in arrays {
        for (slot, part) in slots.iter_mut().zip(array.parts(length)) {
            slot.push(part);
        }
    }
    slots
}

/// The rows of variables, for the core.
fn of_core(rows: &[Rows]) -> Vec<batch::Rows<'_>> {
    rows.iter()
        .map(|Rows { column, rows, width, values }| batch::Rows { column: *column, rows: *rows, width: *width, values })
        .collect()
}

/// A model over samples: one flat array per result, run after run. None if they are given.
#[pyfunction]
#[pyo3(signature = (model, *, preset, parameters, inputs, dt, times, held, results, runs, samples, threads_asked, out))]
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
    out: Option<Vec<Given<'py>>>,
) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
    let model = find(model)?;
    let inputs = rows(model, inputs)?;
    let times: Option<Vec<f64>> = times.map(|times| times.as_array().iter().copied().collect());
    let between = if held { Between::Held } else { Between::Linear };
    let mut common = Common::of(model, preset.as_deref(), parameters, &results, ("run", runs), threads_asked)?;
    // All threads have something to do.
    common.together = Worker::together(model).min(runs.div_ceil(common.threads)).max(1);
    (common.samples, common.threads) = (samples, common.threads.min(runs.div_ceil(common.together)));
    let inputs = of_core(&inputs);
    let times = times.as_deref().map_or(Times::Every(dt), Times::At);
    let all = Runs { inputs: &inputs, times, samples, between, results: &common.results };
    common.arrays(py, out, || {
        let (mut worker, mut room) = (Worker::new(model, &all, Registers::best()), Vec::new());
        let (common, all) = (&common, &all);
        Box::new(move |some, instance, places, cancel| {
            let full = || (some.start, Ended::OutOfMemory);
            let Ok(worker) = &mut worker else { return Err(full()) };
            let begin = |run, instance: &mut Instance| common.begin(run, instance);
            let make = |arrays: &mut [&mut [f64]]| worker.make(instance, all, some.clone(), &begin, arrays, cancel);
            in_doubles(places, &mut room, &common.beyond, make, full)
        })
    })
}
