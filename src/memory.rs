//! Memory that may run out: whatever the C interfaces allocate for their callers is allocated fallibly. A failed
//! allocation would otherwise end the process of the host.

use std::ffi::{CStr, CString};
use std::fmt::{self, Write};

/// Memory has run out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfMemory;

/// Message if memory runs out even for a message.
pub const OUT_OF_MEMORY: &CStr = c"out of memory";

impl fmt::Display for OutOfMemory {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("out of memory")
    }
}

impl std::error::Error for OutOfMemory {}

/// An empty vector with room for exactly `count` values, so that it becomes a box without being moved.
fn room<T>(count: usize) -> Result<Vec<T>, OutOfMemory> {
    let mut values = Vec::new();
    values.try_reserve_exact(count).map_err(|_| OutOfMemory)?;
    Ok(values)
}

/// `count` copies of a value.
pub fn filled<T: Clone>(value: T, count: usize) -> Result<Box<[T]>, OutOfMemory> {
    let mut values = room(count)?;
    values.resize(count, value);
    Ok(values.into_boxed_slice())
}

/// A copy of a slice.
pub fn copied<T: Copy>(slice: &[T]) -> Result<Box<[T]>, OutOfMemory> {
    let mut values = room(slice.len())?;
    values.extend_from_slice(slice);
    Ok(values.into_boxed_slice())
}

/// The elements of an iterator, which is run twice.
pub fn collected<T>(elements: impl Iterator<Item = T> + Clone) -> Result<Box<[T]>, OutOfMemory> {
    let mut values = room(elements.clone().count())?;
    values.extend(elements);
    Ok(values.into_boxed_slice())
}

/// The results of `make` for each element.
pub fn each<T, U>(
    elements: impl ExactSizeIterator<Item = T>,
    mut make: impl FnMut(T) -> Result<U, OutOfMemory>,
) -> Result<Vec<U>, OutOfMemory> {
    let mut made = room(elements.len())?;
    for element in elements {
        made.push(make(element)?);
    }
    Ok(made)
}

/// A value in its own box.
pub fn boxed<T>(value: T) -> Result<Box<T>, OutOfMemory> {
    let mut one = room(1)?;
    one.push(value);
    let one: Box<[T; 1]> = one.into_boxed_slice().try_into().map_err(|_| OutOfMemory)?;
    // SAFETY: an array of one value has the layout of the value, and the box is given up.
    Ok(unsafe { Box::from_raw(Box::into_raw(one).cast::<T>()) })
}

/// A text, truncated if memory runs out, in the worst case to nothing.
pub fn text(what: impl fmt::Display) -> String {
    let mut text = Text(String::new());
    // An error says that the text is truncated, as intended.
    let _ = write!(text, "{what}");
    text.0
}

/// A whole text.
pub fn whole_text(what: impl fmt::Display) -> Result<String, OutOfMemory> {
    let mut text = Text(String::new());
    write!(text, "{what}").map_err(|_| OutOfMemory)?;
    Ok(text.0)
}

/// A text that grows while memory lasts.
struct Text(String);

impl Write for Text {
    fn write_str(&mut self, more: &str) -> fmt::Result {
        self.0.try_reserve(more.len()).map_err(|_| fmt::Error)?;
        self.0.push_str(more);
        Ok(())
    }
}

/// A text for C, up to its first zero byte, if there is memory for it.
pub fn c_text(text: &str) -> Result<CString, OutOfMemory> {
    let text = text.split('\0').next().unwrap_or_default();
    let mut bytes = room(text.len() + 1)?;
    bytes.extend_from_slice(text.as_bytes());
    bytes.push(0);
    CString::from_vec_with_nul(bytes).map_err(|_| OutOfMemory)
}

/// A copy of a C text.
pub fn c_copy(text: &CStr) -> Result<CString, OutOfMemory> {
    let mut bytes = room(text.count_bytes() + 1)?;
    bytes.extend_from_slice(text.to_bytes_with_nul());
    CString::from_vec_with_nul(bytes).map_err(|_| OutOfMemory)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_made_is_what_was_asked_for() {
        assert_eq!(*filled(2.5, 3).expect("memory"), [2.5; 3]);
        assert_eq!(*copied(&[1, 2]).expect("memory"), [1, 2]);
        assert_eq!(*boxed("value".to_string()).expect("memory"), "value");
        assert_eq!(text(format_args!("{} {}", 1, "two")), "1 two");
        assert_eq!(c_text("cut\0here").expect("memory"), c"cut".to_owned());
        assert_eq!(c_copy(c"text").expect("memory"), c"text".to_owned());
        assert_eq!(each([1, 2].iter(), |n| Ok(n + 1)), Ok(vec![2, 3]));
        assert_eq!(each([1, 2].iter(), |n| if *n == 1 { Ok(*n) } else { Err(OutOfMemory) }), Err(OutOfMemory));
    }

    /// Miri aborts where a host would run out of memory.
    #[cfg(not(miri))]
    #[test]
    fn more_than_there_is_is_refused() {
        assert_eq!(filled(0u8, isize::MAX as usize), Err(OutOfMemory));
    }
}
