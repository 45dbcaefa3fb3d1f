//! Saving and restoring the complete state of an instance.

use super::component::{Component, Experiment, Outcome, Refusal, enter, refuse};
use super::lifecycle::{Call, Purpose, STATES, State};
use super::types::*;
use crate::guard::pointer::{array, array_mut};
use crate::models;
use stribeck::guid::GuidText;
use stribeck::instance::Snapshot;
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::ModelType;
use stribeck::serial;

/// The state behind an importer's `fmi2FMUstate`.
struct Saved {
    magic: u64,
    guid: GuidText,
    state: State,
    experiment: Experiment,
    snapshot: Snapshot,
}

/// Marks the memory of a saved state, so that a pointer to anything else is refused.
const MAGIC: u64 = u64::from_le_bytes(*b"STRISAVE");

impl Saved {
    fn of(component: &Component) -> Result<Saved, OutOfMemory> {
        Ok(Saved {
            magic: MAGIC,
            guid: component.guid,
            state: component.state,
            experiment: component.experiment,
            snapshot: component.instance.try_save()?,
        })
    }

    fn refill(&mut self, component: &Component) {
        self.state = component.state;
        self.experiment = component.experiment;
        component.instance.save_into(&mut self.snapshot);
    }

    fn put_back(&self, component: &mut Component) -> Outcome {
        if !self.state.is_for(component.purpose) {
            let text =
                format_args!("FMUstate is in state {:?}, which {:?} does not have", self.state, component.purpose);
            return refuse(text);
        }
        if component.purpose == Purpose::CoSimulation {
            component.instance.check_without_events(&self.snapshot)?;
        }
        component.instance.restore(&self.snapshot);
        if self.state == State::ContinuousTimeMode {
            component.instance.continue_between_events();
        }
        // Whether an event was reported is not saved; reading the states again is never wrong.
        component.has_jumped = self.state == State::EventMode;
        component.state = self.state;
        component.experiment = self.experiment;
        Ok(())
    }

    /// The numbers that the FMI layer adds to a serialised instance.
    fn owners(&self) -> [f64; serial::OWNERS] {
        let Experiment { is_set_up, start, stop } = self.experiment;
        let state = STATES.iter().position(|state| *state == self.state).unwrap_or_default();
        [state as f64, f64::from(u8::from(is_set_up)), start, stop]
    }

    fn read(model: &'static ModelType, bytes: &[u8]) -> Result<Saved, Refusal> {
        let (snapshot, [state, is_set_up, start, stop]) = serial::read(model, bytes)?;
        let number = STATES.iter().enumerate().find(|(index, _)| (*index as f64).to_bits() == state.to_bits());
        let Some((_, state)) = number else { return refuse(format_args!("unknown state {state}")) };
        if !start.is_finite() || stop.is_nan() {
            return refuse(format_args!("start time {start} or stop time {stop} is not valid"));
        }
        let Some(is_set_up) = serial::flag(is_set_up) else {
            return refuse(format_args!("the flag of the experiment is {is_set_up}: must be 0 or 1"));
        };
        let experiment = Experiment { is_set_up, start, stop };
        Ok(Saved { magic: MAGIC, guid: model.guid_text(), state: *state, experiment, snapshot })
    }
}

/// The saved state behind a pointer, if it belongs to the model of `component`.
///
/// # Safety
/// `state` must be NULL or a state made by this library and not yet freed.
unsafe fn saved<'a>(component: &Component, state: fmi2FMUstate) -> Result<&'a Saved, Refusal> {
    // SAFETY: the caller's promise.
    match unsafe { state.cast::<Saved>().as_ref() } {
        None => refuse("FMUstate is NULL"),
        Some(saved) if saved.magic != MAGIC => refuse("FMUstate is not a state of this library"),
        Some(saved) if saved.guid != component.guid => {
            let whose = models::by_guid(saved.guid).map_or("another version", |model| model.name);
            refuse(format_args!("FMUstate belongs to {whose}, not to {}", component.instance.model().name))
        }
        Some(saved) => Ok(saved),
    }
}

/// As [`saved`], mutable.
///
/// # Safety
/// As for [`saved`]; the state must not be used elsewhere during the call.
unsafe fn saved_mut<'a>(component: &Component, state: fmi2FMUstate) -> Result<&'a mut Saved, Refusal> {
    // SAFETY: the caller's promise.
    unsafe { saved(component, state) }?;
    // SAFETY: `saved` has found a state there, and the caller promises that it is not used elsewhere.
    Ok(unsafe { &mut *state.cast::<Saved>() })
}

/// Saves the state. `*FMUstate` must be NULL, to make a new one, or an earlier state, to overwrite it. The state must
/// be freed once with fmi2FreeFMUstate.
///
/// # Safety
/// `c` as for every call on an instance; `FMUstate` must be NULL or point to NULL or to a state of this library.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetFMUstate(c: fmi2Component, FMUstate: *mut fmi2FMUstate) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises NULL or a writable pointer.
        let Some(place) = (unsafe { FMUstate.as_mut() }) else { return refuse("FMUstate is NULL") };
        if place.is_null() {
            *place = Box::into_raw(memory::boxed(Saved::of(component)?)?).cast();
        } else {
            // SAFETY: not NULL, so the caller promises a state of this library.
            unsafe { saved_mut(component, *place) }?.refill(component);
        }
        Ok(())
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
        unsafe { saved(component, FMUstate) }?.put_back(component)
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
        // SAFETY: the caller promises NULL or a writable pointer.
        let Some(place) = (unsafe { FMUstate.as_mut() }) else { return Ok(()) };
        if !place.is_null() {
            // SAFETY: not NULL, so the caller promises a state of this library, which came from `Box::into_raw`.
            drop(unsafe { Box::from_raw(saved_mut(component, *place)?) });
            *place = std::ptr::null_mut();
        }
        Ok(())
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
        let (_, size) = unsafe { (saved(component, FMUstate)?, size.as_mut()) };
        let Some(size) = size else { return refuse("size is NULL") };
        *size = serial::size(component.instance.model());
        Ok(())
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
    let body = |component: &mut Component| -> Outcome {
        // SAFETY: the caller's promises; bytes are bytes, signed or not.
        let (saved, bytes) =
            unsafe { (saved(component, FMUstate)?, array_mut(serializedState.cast::<u8>(), size, "serializedState")?) };
        let needed = serial::size(component.instance.model());
        if size < needed {
            return refuse(format_args!("serializedState has {size} bytes, {needed} are needed"));
        }
        serial::write(component.instance.model(), &saved.snapshot, saved.owners(), &mut bytes[..needed]);
        Ok(())
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
    let body = |component: &mut Component| -> Outcome {
        // SAFETY: the caller's promises.
        let (bytes, place) =
            unsafe { (array(serializedState.cast::<u8>(), size, "serializedState")?, FMUstate.as_mut()) };
        let Some(place) = place else { return refuse("FMUstate is NULL") };
        let read = Saved::read(component.instance.model(), bytes)?;
        if place.is_null() {
            *place = Box::into_raw(memory::boxed(read)?).cast();
        } else {
            // SAFETY: not NULL, so the caller promises a state of this library.
            *unsafe { saved_mut(component, *place) }? = read;
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::DeSerializeFMUstate, body) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::instance::Instance;

    /// The checksum only shows that nothing was damaged: the values of the FMI layer are checked as well.
    #[test]
    fn owners_numbers_that_make_no_sense_are_refused() {
        let model = crate::models::by_name("LuGre").expect("a model of the catalogue");
        let snapshot = Instance::new(model).save();
        let read = |owners: [f64; serial::OWNERS]| {
            let mut bytes = vec![0; serial::size(model)];
            serial::write(model, &snapshot, owners, &mut bytes);
            Saved::read(model, &bytes)
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
