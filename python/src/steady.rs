//! Steady sliding over arrays of inputs.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use stribeck::batch::{Points, Registers, Steady};
use stribeck::instance::{Instance, Phase};
use stribeck::series::Ended;

use crate::catalogue::{column, find};
use crate::places::{Given, Values};
use crate::refused;
use crate::series::{Common, Named};

/// Points in one call, at most, and those in closed form that take longer than a thread needs to begin (chosen).
const TOGETHER: usize = 1 << 14;
const WORTH_A_THREAD: usize = 1 << 11;

/// An input: one value for all points, or one for each.
struct Input<'a> {
    column: usize,
    // Other threads of Python may write to the array meanwhile.
    values: &'a [AtomicU64],
}

impl<'a> Input<'a> {
    fn of(column: usize, name: &str, array: &'a PyReadonlyArray1<f64>, points: usize) -> PyResult<Input<'a>> {
        let values = array.as_slice()?;
        if values.len() != 1 && values.len() != points {
            return Err(refused(format_args!("{name} has {} values: must be 1 or {points}", values.len())));
        }
        let first = array.data().cast::<AtomicU64>();
        if !first.is_aligned() {
            return Err(refused(format_args!("{name}: its numbers must be aligned")));
        }
        // SAFETY: so many numbers of 64 bits, aligned, which the array keeps as long as it is borrowed.
        Ok(Input { column, values: unsafe { std::slice::from_raw_parts(first, array.len()) } })
    }

    fn at(&self, point: usize) -> f64 {
        let value = &self.values[if self.values.len() == 1 { 0 } else { point }];
        f64::from_bits(value.load(Ordering::Relaxed))
    }

    fn is_one(&self) -> bool {
        self.values.len() == 1
    }
}

/// Inputs that differ, and places for the results of points from the first one on.
struct Places<'a, 'b> {
    inputs: &'a [&'a Input<'a>],
    results: &'a mut [Values<'b>],
    beyond: &'a [AtomicBool],
    first: usize,
}

impl Points for Places<'_, '_> {
    fn read(&self, input: usize, points: Range<usize>, values: &mut [f64]) {
        for (value, number) in values.iter_mut().zip(&self.inputs[input].values[points]) {
            *value = f64::from_bits(number.load(Ordering::Relaxed));
        }
    }

    fn write(&mut self, result: usize, points: Range<usize>, values: &[f64]) {
        self.results[result].write(points.start - self.first, values, &self.beyond[result]);
    }
}

/// Work of a thread.
struct Sliding<'a> {
    common: &'a Common<'a>,
    inputs: &'a [Input<'a>],
    different: &'a [&'a Input<'a>],
    /// Columns of the inputs that differ.
    columns: &'a [usize],
    /// None before the first point, and for a law without a closed form.
    closed: Option<Option<Steady<'a>>>,
}

impl<'a> Sliding<'a> {
    /// The closed form, if all points have the same parameters.
    fn closed_form(&self, instance: &mut Instance) -> Result<Option<Steady<'a>>, Ended> {
        let common = self.common;
        let same = self.inputs.iter().filter(|input| input.is_one()).map(|input| (input.column, input.at(0)));
        // What is refused is told with the number of the point, below.
        let begun = common.parameters.iter().all(|rows| rows.rows == 1)
            && common.begin(0, instance).is_ok()
            && instance.set_all(Phase::Stepping, same).is_ok();
        if !begun {
            return Ok(None);
        }
        Steady::of(instance, Registers::best(), self.columns, &common.results).map_err(|_| Ended::OutOfMemory)
    }

    fn make(
        &mut self,
        points: Range<usize>,
        instance: &mut Instance,
        results: &mut [Values],
        cancel: &AtomicBool,
    ) -> Result<(), (usize, Ended)> {
        if self.closed.is_none() {
            self.closed = Some(self.closed_form(instance).map_err(|ended| (points.start, ended))?);
        }
        let (inputs, beyond, mut next) = (self.different, &self.common.beyond[..], points.start);
        let mut places = Places { inputs, results, beyond, first: points.start };
        while next < points.end {
            let mut one_by_one = next..points.end;
            if let Some(Some(steady)) = &mut self.closed {
                match steady.make(one_by_one, &mut places) {
                    Ok(()) => return Ok(()),
                    Err(some) => one_by_one = some,
                }
            }
            next = one_by_one.end;
            for point in one_by_one {
                let values = self.settled(point, instance, cancel).map_err(|ended| (point, ended))?;
                let values = values.iter().enumerate();
                values.for_each(|(result, value)| places.write(result, point..point + 1, &[*value]));
            }
        }
        Ok(())
    }

    /// The results at a point.
    fn settled(&self, point: usize, instance: &mut Instance, cancel: &AtomicBool) -> Result<Vec<f64>, Ended> {
        if cancel.load(Ordering::Relaxed) {
            return Err(Ended::Cancelled);
        }
        self.common.begin(point, instance)?;
        let held: Vec<(usize, f64)> = self.inputs.iter().map(|input| (input.column, input.at(point))).collect();
        let mut values = vec![0.0; self.common.results.len()];
        stribeck::series::settle(instance, &held, &self.common.results, &mut values, cancel)?;
        Ok(values)
    }
}

/// Results of steady sliding, or settled ones: one array per result, one value per point. None if they are given.
#[pyfunction]
#[pyo3(signature = (model, *, preset, parameters, inputs, results, points, threads_asked, out))]
#[allow(clippy::too_many_arguments, reason = "keywords of a call from Python")]
pub fn settle<'py>(
    py: Python<'py>,
    model: &str,
    preset: Option<String>,
    parameters: Named<'py>,
    inputs: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    results: Vec<String>,
    points: usize,
    threads_asked: Option<usize>,
    out: Option<Vec<Given<'py>>>,
) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
    let model = find(model)?;
    let given = inputs.iter().map(|(name, array)| Input::of(column(model, name)?, name, array, points));
    let inputs = given.collect::<PyResult<Vec<Input>>>()?;
    let different: Vec<&Input> = inputs.iter().filter(|input| !input.is_one()).collect();
    let columns: Vec<usize> = different.iter().map(|input| input.column).collect();
    let mut common = Common::of(model, preset.as_deref(), parameters, &results, ("point", points), threads_asked)?;
    // All threads have something to do, where that is worth a thread.
    let least = if model.slides_steadily(Instance::new(model).row()) { WORTH_A_THREAD } else { 1 };
    common.together = points.div_ceil(4 * common.threads).clamp(least, TOGETHER);
    common.threads = common.threads.min(points.div_ceil(common.together));
    let (common, inputs, different, columns) = (&common, &inputs[..], &different[..], &columns[..]);
    common.arrays(py, out, || {
        let mut sliding = Sliding { common, inputs, different, columns, closed: None };
        Box::new(move |some, instance, results, cancel| sliding.make(some, instance, results, cancel))
    })
}
