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
pub unsafe extern "C" fn stribeck_state_size(instance: *const stribeck_instance) -> usize {
    // SAFETY: the caller's promise.
    unsafe { instance.as_ref() }.map_or(0, |handle| serial::size(handle.instance.model()))
}

/// Writes the complete state of the instance, including parameters and time, as bytes that any process can read.
///
/// # Safety
/// As the module says of handles; `buffer` must be NULL or have `size` writable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_save(
    instance: *mut stribeck_instance,
    buffer: *mut libc::c_void,
    size: usize,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        let needed = serial::size(handle.instance.model());
        if buffer.is_null() {
            return Err(Null("buffer").into());
        }
        if size < needed {
            return refuse(STRIBECK_BAD_BUFFER, format_args!("buffer has {size} bytes, {needed} are needed"));
        }
        // SAFETY: the caller promises `size` bytes, of which there are enough.
        let bytes = unsafe { array_mut(buffer.cast::<u8>(), needed, "buffer") }?;
        serial::write(handle.instance.model(), &handle.instance.try_save()?, [0.0; serial::OWNERS], bytes);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Restores a saved state of this or of another instance of the same model. Foreign or damaged bytes are refused, and
/// so is a state that only events of Model Exchange can produce (`phase`).
///
/// # Safety
/// As the module says of handles; `buffer` must be NULL or have `size` readable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_restore(
    instance: *mut stribeck_instance,
    buffer: *const libc::c_void,
    size: usize,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        if buffer.is_null() {
            return Err(Null("buffer").into());
        }
        // SAFETY: the caller promises `size` bytes.
        let bytes = unsafe { array(buffer.cast::<u8>(), size, "buffer") }?;
        let (snapshot, _) = serial::read(handle.instance.model(), bytes).map_err(fault(STRIBECK_BAD_BUFFER))?;
        // The state may come from an FMU in Model Exchange.
        handle.instance.check_without_events(&snapshot).map_err(fault(STRIBECK_BAD_BUFFER))?;
        handle.instance.restore(&snapshot);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}
