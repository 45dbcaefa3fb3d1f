//! What is behind the pointers of a caller.

use std::ffi::{CStr, c_char};
use std::fmt;

/// A pointer that must not be NULL is NULL; its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Null(pub &'static str);

impl fmt::Display for Null {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} is NULL", self.0)
    }
}

/// The `n` elements at `pointer`. For n = 0 the pointer may be anything: FMI leaves it undefined.
///
/// # Safety
/// `pointer` must be NULL or point to `n` readable elements that are not written during the call.
#[inline(always)]
pub(crate) unsafe fn array<'a, T>(pointer: *const T, n: usize, name: &'static str) -> Result<&'a [T], Null> {
    if n == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Null(name));
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, n) })
}

/// As [`array`], mutable.
///
/// # Safety
/// `pointer` must be NULL or point to `n` writable elements that are not used elsewhere during the call.
#[inline(always)]
pub(crate) unsafe fn array_mut<'a, T>(pointer: *mut T, n: usize, name: &'static str) -> Result<&'a mut [T], Null> {
    if n == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return Err(Null(name));
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, n) })
}

/// The place for a result.
///
/// # Safety
/// `pointer` must be NULL or writable, and not be used elsewhere during the call.
#[inline(always)]
pub(crate) unsafe fn place<'a, T>(pointer: *mut T, name: &'static str) -> Result<&'a mut T, Null> {
    // SAFETY: the caller's promise.
    unsafe { pointer.as_mut() }.ok_or(Null(name))
}

/// A zero-terminated text, or `None` for NULL.
///
/// # Safety
/// `text` must be NULL or point to a zero-terminated text that lives as long as the result is used.
pub(crate) unsafe fn text<'a>(text: *const c_char) -> Option<&'a CStr> {
    // SAFETY: not NULL, and the caller promises a terminated text.
    (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) })
}

/// A text as Rust reads it. One that is not UTF-8 matches no name.
pub(crate) fn name(text: &CStr) -> &str {
    text.to_str().unwrap_or("(a text that is not UTF-8)")
}
