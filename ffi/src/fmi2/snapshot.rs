//! Saving and restoring the complete state of an instance.

use super::component::{Component, enter};
use super::lifecycle::Call;
use super::types::*;
use crate::component::saved;
use crate::guard::pointer::{array, array_mut};

/// Saves the state. `*FMUstate` must be NULL, to make a new one, or an earlier state, to overwrite it. The state must
/// be freed once with fmi2FreeFMUstate.
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or point to NULL or to a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetFMUstate(c: fmi2Component, FMUstate: *mut fmi2FMUstate) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        unsafe { saved::save(component, FMUstate) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetFMUstate, body) }
}

/// Restores a saved state of this or of another instance of the same model. The state can be used again. Co-simulation
/// refuses a state that only events can produce (`phase`).
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetFMUstate(c: fmi2Component, FMUstate: fmi2FMUstate) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        unsafe { saved::restore(component, FMUstate) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetFMUstate, body) }
}

/// Frees a saved state and sets the pointer to NULL. A pointer to NULL is ignored, as is NULL.
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or point to NULL or to a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2FreeFMUstate(c: fmi2Component, FMUstate: *mut fmi2FMUstate) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promise.
        unsafe { saved::free(component, FMUstate) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::FreeFMUstate, body) }
}

/// Number of bytes that fmi2SerializeFMUstate writes.
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or a state of this library; `size` NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SerializedFMUstateSize(
    c: fmi2Component,
    FMUstate: fmi2FMUstate,
    size: *mut usize,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises.
        unsafe { saved::size(component, FMUstate, size) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SerializedFMUstateSize, body) }
}

/// Writes a saved state as bytes that another process, even on another platform, can read. Equal states give equal
/// bytes.
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or a state of this library; `serializedState` must
/// have `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SerializeFMUstate(
    c: fmi2Component,
    FMUstate: fmi2FMUstate,
    serializedState: *mut fmi2Byte,
    size: usize,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises; bytes are bytes, signed or not.
        unsafe {
            let bytes = array_mut(serializedState.cast::<u8>(), size, "serializedState")?;
            saved::write(component, FMUstate, bytes)
        }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SerializeFMUstate, body) }
}

/// Makes a saved state from bytes. Foreign, truncated and damaged bytes are refused.
///
/// # Safety
/// `c` as for every call on an instance; `serializedState` must have `size` bytes; `FMUstate` as for fmi2GetFMUstate.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2DeSerializeFMUstate(
    c: fmi2Component,
    serializedState: *const fmi2Byte,
    size: usize,
    FMUstate: *mut fmi2FMUstate,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller's promises.
        unsafe { saved::read(component, array(serializedState.cast::<u8>(), size, "serializedState")?, FMUstate) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::DeSerializeFMUstate, body) }
}

#[cfg(test)]
mod tests {
    use crate::component::Refusal;
    use crate::fmi2::component::Fmi2;
    use crate::fmi2::lifecycle::STATES;
    use stribeck::instance::Instance;
    use stribeck::serial;

    type Saved = crate::component::saved::Saved<Fmi2>;

    /// The checksum only shows that nothing was damaged: the values of the FMI layer are checked as well.
    #[test]
    fn owners_numbers_that_make_no_sense_are_refused() {
        let model = crate::models::by_name("LuGre").expect("a model of the catalogue");
        let snapshot = Instance::new(model).save();
        let read = |owners: [f64; serial::OWNERS]| {
            let mut bytes = vec![0; serial::size(model)];
            serial::write(model, &snapshot, owners, &mut bytes);
            Saved::read(model, &[], &bytes)
        };
        let sound = read([0.0, 1.0, 0.5, f64::INFINITY]).ok().expect("a valid state");
        assert!(sound.state == STATES[0] && sound.experiment.is_set_up && sound.experiment.start == 0.5);
        let states = STATES.len() as f64;
        for (owners, why) in [
            ([states, 1.0, 0.0, 1.0], format!("unknown state {states}")),
            ([0.5, 1.0, 0.0, 1.0], "unknown state 0.5".to_owned()),
            ([0.0, 1.0, f64::INFINITY, 1.0], "start time inf".to_owned()),
            ([0.0, 1.0, 0.0, f64::NAN], "stop time NaN".to_owned()),
            ([0.0, 0.5, 0.0, 1.0], "the flag of the experiment is 0.5".to_owned()),
            ([0.0, -0.0, 0.0, 1.0], "the flag of the experiment is -0".to_owned()),
        ] {
            let Err(Refusal::Error(text)) = read(owners) else { panic!("{owners:?} was accepted") };
            assert!(text.contains(&why), "{text}");
        }
    }
}
