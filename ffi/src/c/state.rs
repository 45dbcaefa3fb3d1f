//! Saved states.

use super::stribeck_status::*;
use super::{enter, fault, refuse, stribeck_instance, stribeck_status};
use crate::guard::pointer::{Null, array, array_mut};
use stribeck::serial;

/// Number of bytes that stribeck_save writes; 0 for NULL.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_state_size(model: *const stribeck_instance) -> usize {
    // SAFETY: the caller's promise.
    unsafe { model.as_ref() }.map_or(0, |model| serial::size(model.instance.model()))
}

/// Writes the complete state of the model, including parameters and time, as bytes that any process can read.
///
/// # Safety
/// As the module says of handles; `buffer` must be NULL or have `size` writable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_save(
    model: *mut stribeck_instance,
    buffer: *mut libc::c_void,
    size: usize,
) -> stribeck_status {
    let body = |model: &mut stribeck_instance| {
        let needed = serial::size(model.instance.model());
        if buffer.is_null() {
            return Err(Null("buffer").into());
        }
        if size < needed {
            return refuse(STRIBECK_BAD_BUFFER, format_args!("buffer has {size} bytes, {needed} are needed"));
        }
        // SAFETY: the caller promises `size` bytes, of which there are enough.
        let bytes = unsafe { array_mut(buffer.cast::<u8>(), needed, "buffer") }?;
        serial::write(model.instance.model(), &model.instance.try_save()?, [0.0; serial::OWNERS], bytes);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(model, body) }
}

/// Restores a saved state of this or of another instance of the same model. Foreign or damaged bytes are refused, and
/// so is a state that only events of Model Exchange can produce (`phase`).
///
/// # Safety
/// As the module says of handles; `buffer` must be NULL or have `size` readable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_restore(
    model: *mut stribeck_instance,
    buffer: *const libc::c_void,
    size: usize,
) -> stribeck_status {
    let body = |model: &mut stribeck_instance| {
        if buffer.is_null() {
            return Err(Null("buffer").into());
        }
        // SAFETY: the caller promises `size` bytes.
        let bytes = unsafe { array(buffer.cast::<u8>(), size, "buffer") }?;
        let (snapshot, _) = serial::read(model.instance.model(), bytes).map_err(fault(STRIBECK_BAD_BUFFER))?;
        // The state may come from an FMU in Model Exchange.
        model.instance.check_without_events(&snapshot).map_err(fault(STRIBECK_BAD_BUFFER))?;
        model.instance.restore(&snapshot);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(model, body) }
}
