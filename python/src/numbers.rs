//! Memory for arrays, which is used again: a system takes longer to give a process new memory than a cheap law takes to
//! fill it.

use std::alloc::{Layout, alloc_zeroed};
use std::ops::{Deref, DerefMut};
use std::sync::Mutex;

use numpy::PyArray1;
use numpy::ndarray::ArrayViewMut1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

/// Fewer numbers come from memory that a process keeps anyway (chosen: 128 kB).
const FEW: usize = 1 << 14;
/// Memory that is kept, in numbers (chosen: 64 MB).
const MOST: usize = 1 << 23;

/// Memory that nobody uses, the last one given back at the end.
static SPARE: Mutex<Vec<Vec<f64>>> = Mutex::new(Vec::new());

/// An array of numbers whose memory is kept for another one.
pub struct Numbers(Vec<f64>);

impl Numbers {
    /// Room for so many.
    pub fn with_room(length: usize) -> PyResult<Numbers> {
        if let Some(mut values) = spare(length) {
            values.clear();
            return Ok(Numbers(values));
        }
        let mut values = Vec::new();
        values.try_reserve_exact(length).map_err(|_| full(length))?;
        Ok(Numbers(values))
    }

    /// So many numbers, whatever they are: those of an array that is gone, or 0. All of them are to be written.
    pub fn of(length: usize) -> PyResult<Numbers> {
        if let Some(mut values) = spare(length) {
            values.resize(length, 0.0);
            return Ok(Numbers(values));
        }
        let layout = Layout::array::<f64>(length).map_err(|_| full(length))?;
        if layout.size() == 0 {
            return Ok(Numbers(Vec::new()));
        }
        // SAFETY: the layout has a size.
        let first = unsafe { alloc_zeroed(layout) }.cast::<f64>();
        if first.is_null() {
            return Err(full(length));
        }
        // SAFETY: memory of this allocator with the layout of so many numbers, each of which is 0. The system gives zeros
        // where they are first read or written; `resize` would write them before.
        Ok(Numbers(unsafe { Vec::from_raw_parts(first, length, length) }))
    }

    /// Appends numbers, for which there must be room.
    pub fn extend(&mut self, values: impl IntoIterator<Item = f64>) {
        self.0.extend(values);
    }

    /// The same memory as an array of Python.
    pub fn into_array(mut self, py: Python) -> PyResult<Bound<PyArray1<f64>>> {
        let (length, first) = (self.0.len(), self.0.as_mut_ptr());
        let owner = Bound::new(py, Owner(self))?;
        // SAFETY: the owner, which the array keeps, never moves its numbers and neither reads nor writes them before the
        // array is gone: until then only the array does.
        Ok(unsafe {
            let view = ArrayViewMut1::from_shape_ptr(length, first);
            PyArray1::borrow_from_array(&view, owner.into_any())
        })
    }
}

impl Deref for Numbers {
    type Target = [f64];
    fn deref(&self) -> &[f64] {
        &self.0
    }
}

impl DerefMut for Numbers {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl Drop for Numbers {
    fn drop(&mut self) {
        let values = std::mem::take(&mut self.0);
        if (FEW..=MOST).contains(&values.capacity())
            // Nobody waits: where another thread is at it, or a copy of a process was made meanwhile, the memory is freed.
            && let Ok(mut spare) = SPARE.try_lock()
        {
            spare.push(values);
            while spare.iter().map(Vec::capacity).sum::<usize>() > MOST {
                spare.remove(0);
            }
        }
    }
}

fn full(length: usize) -> PyErr {
    PyMemoryError::new_err(format!("no memory for {length} numbers"))
}

/// Memory for so many numbers, and not for many more, as it was left.
fn spare(length: usize) -> Option<Vec<f64>> {
    if length < FEW {
        return None;
    }
    let mut spare = SPARE.try_lock().ok()?;
    let fits = |values: &Vec<f64>| (length..=length + length / 4).contains(&values.capacity());
    let last = spare.iter().rposition(fits)?;
    Some(spare.remove(last))
}

/// Owner of the numbers of an array, which holds them for it and nothing else.
#[pyclass(frozen)]
struct Owner(#[expect(dead_code, reason = "given back when it is dropped")] Numbers);
