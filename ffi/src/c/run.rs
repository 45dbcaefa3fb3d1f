//! Many steps in one call.

use std::cell::RefCell;
use std::ptr::null;
use std::sync::atomic::AtomicBool;

use libc::c_int;

use super::stribeck_status::*;
use super::{Outcome, Refusal, enter, fault, refuse, stribeck_instance, stribeck_status};
use crate::guard::pointer::{Null, array, array_mut};
use stribeck::batch::{Registers, Rows, Runs, Worker};
use stribeck::instance::{Instance, Refused, Snapshot};
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::Brief;
use stribeck::series::{self, Between, Ended, Times};

/// Nobody ends a call from C early.
static NEVER: AtomicBool = AtomicBool::new(false);

impl From<Ended> for Refusal {
    fn from(ended: Ended) -> Refusal {
        let text = memory::text(&ended);
        let Refusal(status, _) = match ended {
            Ended::Setup(reason) | Ended::At { reason, .. } => Refusal::from(*reason),
            Ended::Unsettled(fault) => Refusal::from(Refused::NotFinite(fault)),
            Ended::OutOfMemory => Refusal::from(OutOfMemory),
            Ended::Cancelled => Refusal(STRIBECK_INTERNAL, String::new()),
        };
        Refusal(status, text)
    }
}

/// Variables with arrays of values, which stribeck_run reads. The arrays belong to the caller.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stribeck_samples {
    /// References of the variables.
    pub references: *const u32,
    /// An array for each of them.
    pub values: *const *const f64,
    /// Number of variables.
    pub count: usize,
}

/// Variables with arrays for their values, which stribeck_run writes. The arrays belong to the caller and do not overlap.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stribeck_results {
    /// References of the variables.
    pub references: *const u32,
    /// An array for each of them.
    pub values: *const *mut f64,
    /// Number of variables.
    pub count: usize,
}

/// Columns with the arrays that belong to them.
struct Arrays<T> {
    columns: Box<[usize]>,
    values: Box<[T]>,
}

impl<T> Arrays<T> {
    /// Looks the variables up. `at` makes an array of the pointer with this number.
    fn of(
        instance: &Instance,
        references: &[u32],
        at: impl Fn(usize) -> Result<T, Null>,
    ) -> Result<Arrays<T>, Refusal> {
        for (number, reference) in references.iter().enumerate() {
            instance.column(*reference)?;
            at(number)?;
        }
        // Both have just been found.
        let columns = memory::each(references.iter(), |reference| Ok(instance.column(*reference).unwrap_or(0)))?;
        let values = memory::each(0..references.len(), |number| at(number).map_err(|_| OutOfMemory))?;
        Ok(Arrays { columns: columns.into(), values: values.into() })
    }
}

/// The arrays behind pointers. `at` makes an array of a pointer.
///
/// # Safety
/// The pointers must be NULL or lead to `count` references and pointers.
unsafe fn arrays<P: Copy, T>(
    instance: &Instance,
    (references, pointers, count): (*const u32, *const P, usize),
    at: impl Fn(P) -> Result<T, Null>,
) -> Result<Arrays<T>, Refusal> {
    // SAFETY: the caller's promise.
    let (references, pointers) =
        unsafe { (array(references, count, "references")?, array(pointers, count, "values")?) };
    Arrays::of(instance, references, |number| at(pointers[number]))
}

impl stribeck_samples {
    /// The arrays, each with `length` values.
    ///
    /// # Safety
    /// The pointers must be NULL or lead to what the documentation of their owner says, and not be written to.
    unsafe fn arrays<'a>(this: *const Self, instance: &Instance, length: usize) -> Result<Arrays<&'a [f64]>, Refusal> {
        // SAFETY: the caller's promise.
        let of =
            unsafe { this.as_ref() }.map_or((null(), null(), 0), |this| (this.references, this.values, this.count));
        // SAFETY: the caller's promise.
        unsafe { arrays(instance, of, |values| array(values, length, "values")) }
    }
}

impl stribeck_results {
    /// The arrays, each with room for `length` values.
    ///
    /// # Safety
    /// As for stribeck_samples, and nothing else may use what the pointers lead to.
    unsafe fn arrays<'a>(
        this: *const Self,
        instance: &Instance,
        length: usize,
    ) -> Result<Arrays<&'a mut [f64]>, Refusal> {
        // SAFETY: the caller's promise.
        let of =
            unsafe { this.as_ref() }.map_or((null(), null(), 0), |this| (this.references, this.values, this.count));
        // SAFETY: the caller's promise.
        unsafe { arrays(instance, of, |values| array_mut(values, length, "values")) }
    }
}

/// How an instance is led.
#[derive(Clone, Copy)]
struct Way {
    dt: f64,
    samples: usize,
    runs: usize,
    between: Between,
}

impl Way {
    /// Checks the numbers of a call.
    fn of(handle: &mut stribeck_instance, dt: f64, samples: usize, runs: usize, held: c_int) -> Result<Way, Refusal> {
        if !(dt > 0.0 && dt.is_finite()) {
            return refuse(STRIBECK_REFUSED_VALUE, format_args!("dt = {}: must be > 0 and finite", Brief(dt)));
        }
        handle.instance.check().map_err(fault(STRIBECK_REFUSED_VALUE))?;
        let most = isize::MAX as usize / size_of::<f64>();
        if samples.checked_mul(runs).is_none_or(|length| length > most) {
            let text = format_args!("{runs} runs of {samples} samples: more than memory holds");
            return refuse(STRIBECK_REFUSED_VALUE, text);
        }
        let between = if held == 0 { Between::Linear } else { Between::Held };
        Ok(Way { dt, samples, runs, between })
    }

    /// Makes all runs from the present state, to which the instance returns after an error, or anyway if it `returns`.
    ///
    /// # Safety
    /// As the module says of pointers.
    unsafe fn lead(
        self,
        instance: &mut Instance,
        [parameters, inputs]: [*const stribeck_samples; 2],
        results: *const stribeck_results,
        returns: bool,
    ) -> Outcome {
        let length = self.samples * self.runs;
        // SAFETY: the caller's promises.
        let chosen = unsafe { stribeck_samples::arrays(parameters, instance, self.runs) }?;
        // SAFETY: the caller's promises.
        let given = unsafe { stribeck_samples::arrays(inputs, instance, length) }?;
        // SAFETY: the caller's promises.
        let found = unsafe { stribeck_results::arrays(results, instance, length) }?;
        let before = instance.try_save()?;
        let done = self.go(instance, [&chosen, &given], found, &before, returns);
        if returns || done.is_err() {
            instance.restore(&before);
        }
        done
    }

    /// Makes all runs from a state, with the instance led along them unless it `returns`. Only the first allocations are
    /// before them.
    fn go(
        self,
        instance: &mut Instance,
        [parameters, given]: [&Arrays<&[f64]>; 2],
        found: Arrays<&mut [f64]>,
        before: &Snapshot,
        returns: bool,
    ) -> Outcome {
        let Way { dt, samples, runs, between } = self;
        let chosen = memory::each(parameters.columns.iter(), |column| Ok((*column, 0.0)))?;
        let chosen = RefCell::new(chosen);
        let inputs = memory::each(given.columns.iter().zip(&given.values), |(column, values)| {
            Ok(Rows { column: *column, rows: runs, width: samples, values })
        })?;
        let all = Runs { inputs: &inputs, times: Times::Every(dt), samples, between, results: &found.columns };
        let mut worker = Worker::new(instance.model(), &all, Registers::best())?;
        let begin = |run: usize, instance: &mut Instance| {
            instance.restore(before);
            let mut chosen = chosen.borrow_mut();
            for (place, values) in chosen.iter_mut().zip(&parameters.values) {
                place.1 = values[run];
            }
            series::set_up(instance, &chosen)
        };
        let mut rest = found.values;
        let mut arrays = memory::each(0..rest.len(), |_| Ok(&mut [][..]))?;
        let together = Worker::together(instance.model());
        for first in (0..runs).step_by(together) {
            let some = first..runs.min(first + together);
            for (place, rest) in arrays.iter_mut().zip(&mut rest) {
                (*place, *rest) = std::mem::take(rest).split_at_mut(some.len() * samples);
            }
            let done = if returns {
                worker.make(instance, &all, some, &begin, &mut arrays, &NEVER)
            } else {
                worker.make_alone(instance, &all, some, &begin, &mut arrays, &NEVER)
            };
            done.map_err(|(_, ended)| ended)?;
        }
        Ok(())
    }
}

/// Leads the instance along samples of its inputs, `dt` seconds apart: at each of the `samples` it sets the inputs, reads the
/// results and, except at the last one, makes a step. Each array has a value per sample. With `held` = 0 the inputs move
/// along straight lines between the samples; otherwise they keep the earlier value, as with stribeck_step. The results are
/// the same, to the last bit, as those of single calls.
///
/// A refused call leaves the instance as it was, and stribeck_last_error names the sample; the arrays of `results` may have
/// been written to. Nothing is allocated between the samples. `inputs` and `results` may be NULL if there are none.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_run(
    instance: *mut stribeck_instance,
    dt: f64,
    samples: usize,
    held: c_int,
    inputs: *const stribeck_samples,
    results: *const stribeck_results,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        let way = Way::of(handle, dt, samples, 1, held)?;
        // SAFETY: the caller's promises.
        unsafe { way.lead(&mut handle.instance, [null(), inputs], results, false) }
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// As stribeck_run, for several runs that all begin with the present state of the instance, to which it returns at the end.
/// Each array of `parameters`, which may be any variables that can be set, has a value per run; each array of `inputs` and
/// `results` has `samples` values per run, run after run. Runs of laws without modes, over held inputs, are made side by
/// side in the registers of the processor, with the bits of each by itself.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_run_many(
    instance: *mut stribeck_instance,
    dt: f64,
    samples: usize,
    runs: usize,
    held: c_int,
    parameters: *const stribeck_samples,
    inputs: *const stribeck_samples,
    results: *const stribeck_results,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        let way = Way::of(handle, dt, samples, runs, held)?;
        // SAFETY: the caller's promises.
        unsafe { way.lead(&mut handle.instance, [parameters, inputs], results, true) }
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}
