//! Saving and restoring the complete state of an instance, sizes of arrays included.

use super::component::{Component, enter};
use super::lifecycle::Call;
use super::types::*;
use crate::component::saved;
use crate::guard::pointer::{array, array_mut};

/// Saves the state. `*FMUState` must be NULL, to make a new one, or an earlier state, to overwrite it. The state must be
/// freed once with fmi3FreeFMUState.
///
/// # Safety
/// `instance` as for every call on an instance; `FMUState` must be NULL or point to NULL or to a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetFMUState(instance: fmi3Instance, FMUState: *mut fmi3FMUState) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe { enter(instance, Call::GetFMUState, |component: &mut Component| saved::save(component, FMUState)) }
}

/// Restores a saved state of this or of another instance of the same model. The state can be used again. Co-simulation
/// refuses a state that only events of Model Exchange can produce (`phase`).
///
/// # Safety
/// `instance` as for every call on an instance; `FMUState` must be NULL or a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetFMUState(instance: fmi3Instance, FMUState: fmi3FMUState) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe { enter(instance, Call::SetFMUState, |component: &mut Component| saved::restore(component, FMUState)) }
}

/// Frees a saved state and sets the pointer to NULL. A pointer to NULL is ignored, as is NULL.
///
/// # Safety
/// `instance` as for every call on an instance; `FMUState` must be NULL or point to NULL or to a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3FreeFMUState(instance: fmi3Instance, FMUState: *mut fmi3FMUState) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe { enter(instance, Call::FreeFMUState, |component: &mut Component| saved::free(component, FMUState)) }
}

/// Number of bytes that fmi3SerializeFMUState writes.
///
/// # Safety
/// `instance` as for every call on an instance; `FMUState` must be NULL or a state of this library; `size` NULL or
/// writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SerializedFMUStateSize(
    instance: fmi3Instance,
    FMUState: fmi3FMUState,
    size: *mut usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises.
        unsafe { saved::size(component, FMUState, size) }
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::SerializedFMUStateSize, body) }
}

/// Writes a saved state as bytes that another process, even on another platform, can read. Equal states give equal bytes.
///
/// # Safety
/// `instance` as for every call on an instance; `FMUState` must be NULL or a state of this library; `serializedState` must
/// have `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SerializeFMUState(
    instance: fmi3Instance,
    FMUState: fmi3FMUState,
    serializedState: *mut fmi3Byte,
    size: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises.
        unsafe { saved::write(component, FMUState, array_mut(serializedState, size, "serializedState")?) }
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::SerializeFMUState, body) }
}

/// Makes a saved state from bytes. Foreign, truncated and damaged bytes are refused, those of FMI 2.0 too.
///
/// # Safety
/// `instance` as for every call on an instance; `serializedState` must have `size` bytes; `FMUState` as for
/// fmi3GetFMUState.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3DeserializeFMUState(
    instance: fmi3Instance,
    serializedState: *const fmi3Byte,
    size: usize,
    FMUState: *mut fmi3FMUState,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises.
        unsafe { saved::read(component, array(serializedState, size, "serializedState")?, FMUState) }
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::DeserializeFMUState, body) }
}
