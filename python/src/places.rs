//! Arrays of Python that results go into: arrays of the caller, or new ones.

use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{AsSliceError, PyReadwriteArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::numbers::Numbers;
use crate::refused;

/// An array of the caller, contiguous.
#[derive(FromPyObject)]
pub enum Given<'py> {
    Double(PyReadwriteArray1<'py, f64>),
    Single(PyReadwriteArray1<'py, f32>),
}

impl Given<'_> {
    fn values(&mut self) -> Result<Values<'_>, AsSliceError> {
        match self {
            Given::Double(array) => array.as_slice_mut().map(Values::Double),
            Given::Single(array) => array.as_slice_mut().map(Values::Single),
        }
    }
}

/// Arrays of the results of a call, one value of each per place.
pub enum Arrays<'py> {
    New(Vec<Numbers>),
    Given(Vec<Given<'py>>),
}

/// Values of one result, or a part of them, in the number that its array has.
pub enum Values<'a> {
    Double(&'a mut [f64]),
    Single(&'a mut [f32]),
}

impl<'py> Arrays<'py> {
    /// The arrays of the caller or, without them, new ones.
    pub fn of(given: Option<Vec<Given<'py>>>, results: usize, length: usize) -> PyResult<Arrays<'py>> {
        let Some(given) = given else {
            return (0..results).map(|_| Numbers::of(length)).collect::<PyResult<_>>().map(Arrays::New);
        };
        let fits = |array: &Given| match array {
            Given::Double(array) => array.len() == length,
            Given::Single(array) => array.len() == length,
        };
        if given.len() != results || !given.iter().all(fits) {
            return Err(refused(format_args!("out: must be {results} arrays of {length} numbers")));
        }
        Ok(Arrays::Given(given))
    }

    /// All values, a slice for each result.
    pub fn values(&mut self) -> PyResult<Vec<Values<'_>>> {
        match self {
            Arrays::New(arrays) => Ok(arrays.iter_mut().map(|array| Values::Double(array)).collect()),
            Arrays::Given(arrays) => Ok(arrays.iter_mut().map(Given::values).collect::<Result<_, _>>()?),
        }
    }
}

/// Work that fills arrays of f64, on arrays of either number. What another number has goes through the room.
pub fn in_doubles<E>(
    places: &mut [Values],
    room: &mut Vec<f64>,
    beyond: &[AtomicBool],
    work: impl FnOnce(&mut [&mut [f64]]) -> Result<(), E>,
    full: impl FnOnce() -> E,
) -> Result<(), E> {
    let singles = |values: &Values| if let Values::Single(values) = values { values.len() } else { 0 };
    let needed = places.iter().map(singles).sum::<usize>();
    if room.len() < needed {
        if room.try_reserve_exact(needed - room.len()).is_err() {
            return Err(full());
        }
        room.resize(needed, 0.0);
    }
    let mut rest = &mut room[..];
    let mut arrays: Vec<&mut [f64]> = Vec::with_capacity(places.len());
    for values in places.iter_mut() {
        arrays.push(match values {
            Values::Double(values) => values,
            Values::Single(values) => rest.split_off_mut(..values.len()).unwrap_or_default(),
        });
    }
    work(&mut arrays)?;
    let mut first = 0;
    for (values, beyond) in places.iter_mut().zip(beyond) {
        let count = singles(values);
        if count > 0 {
            values.write(0, &room[first..first + count], beyond);
            first += count;
        }
    }
    Ok(())
}

impl<'a> Values<'a> {
    /// Parts of this length; the last one may be shorter.
    pub fn parts(self, length: usize) -> Vec<Values<'a>> {
        match self {
            Values::Double(values) => values.chunks_mut(length.max(1)).map(Values::Double).collect(),
            Values::Single(values) => values.chunks_mut(length.max(1)).map(Values::Single).collect(),
        }
    }

    /// Writes numbers from a place on, and notes whether one of them is beyond the largest one that the array can hold.
    pub fn write(&mut self, first: usize, numbers: &[f64], is_beyond: &AtomicBool) {
        match self {
            Values::Double(values) => values[first..first + numbers.len()].copy_from_slice(numbers),
            Values::Single(values) => {
                let mut beyond = false;
                for (value, number) in values[first..].iter_mut().zip(numbers) {
                    *value = *number as f32;
                    beyond |= value.is_infinite();
                }
                if beyond {
                    is_beyond.store(true, Ordering::Relaxed);
                }
            }
        }
    }
}
