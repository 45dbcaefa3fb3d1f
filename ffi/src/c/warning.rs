//! Warnings about accepted values.

use std::borrow::Cow;

use libc::c_char;

use super::{STRIBECK_OK, enter, stribeck_instance};
use stribeck::memory::{self, OUT_OF_MEMORY};

/// Warning about the present values, if some were accepted although they make no sense, such as an unconnected input at
/// 0, or if the model can give back more energy than it took with these parameters; otherwise an empty text. Best
/// called after the first step; the library does not report warnings by itself. The text lives until the next call of
/// this function on the handle. For NULL it says that the handle is NULL.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_warning(instance: *mut stribeck_instance) -> *const c_char {
    let mut text: *const c_char = c"the handle is NULL".as_ptr();
    let body = |handle: &mut stribeck_instance| {
        handle.warning = match handle.instance.warning_or_passivity() {
            None => Cow::Borrowed(c""),
            Some(warning) => memory::c_text(&warning.0).map_or(Cow::Borrowed(OUT_OF_MEMORY), Cow::Owned),
        };
        text = handle.warning.as_ptr();
        Ok(())
    };
    // SAFETY: the caller's promise.
    let status = unsafe { enter(instance, body) };
    // A model that panics has given the reason to stribeck_last_error.
    if status == STRIBECK_OK || instance.is_null() { text } else { c"".as_ptr() }
}

#[cfg(test)]
mod tests {
    use std::ffi::CStr;
    use std::ptr::null_mut;

    use super::*;
    use crate::c::*;

    fn text<'a>(instance: *mut stribeck_instance) -> &'a CStr {
        // SAFETY: NULL or a live handle; each text is compared before the next call.
        unsafe { CStr::from_ptr(stribeck_warning(instance)) }
    }

    #[test]
    fn a_warning_is_that_of_the_present_values() {
        let mut model = null_mut();
        // SAFETY: a handle of this test, freed once.
        unsafe {
            assert_eq!(stribeck_create(c"Probe".as_ptr(), &mut model), STRIBECK_OK);
            assert_eq!(text(model), c"");
            assert_eq!(stribeck_set_by_name(model, c"rate".as_ptr(), -7.0), STRIBECK_OK);
            assert_eq!(text(model), c"rate = -7: the probe counts up");
            assert_eq!(stribeck_step(model, 0.5), STRIBECK_OK, "the value is accepted");
            assert_eq!(stribeck_set_by_name(model, c"rate".as_ptr(), 1.0), STRIBECK_OK);
            assert_eq!(text(model), c"");
            assert_eq!(text(null_mut()), c"the handle is NULL");
            stribeck_free(model);
        }
    }
}
