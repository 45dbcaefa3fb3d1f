//! Saving and restoring the complete state of an instance.

use std::ffi::c_void;

use super::{Component, Experiment, Lifecycle, Outcome, Purpose, Refusal, Version, refuse};
use crate::models;
use stribeck::guid::GuidText;
use stribeck::instance::Snapshot;
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::ModelType;
use stribeck::serial;

/// The state behind an importer's pointer to a saved state. The mark comes first, whatever the version.
#[repr(C)]
pub(crate) struct Saved<V: Version> {
    magic: u64,
    guid: GuidText,
    pub state: V::State,
    pub experiment: Experiment,
    sizes: Box<[usize]>,
    snapshot: Snapshot,
}

impl<V: Version> Saved<V> {
    fn of(component: &Component<V>) -> Result<Saved<V>, OutOfMemory> {
        Ok(Saved {
            magic: V::SAVED,
            guid: component.guid,
            state: component.state,
            experiment: component.experiment,
            sizes: memory::copied(V::sizes(&component.own))?,
            snapshot: component.instance.try_save()?,
        })
    }

    fn refill(&mut self, component: &Component<V>) {
        self.state = component.state;
        self.experiment = component.experiment;
        self.sizes.copy_from_slice(V::sizes(&component.own));
        component.instance.save_into(&mut self.snapshot);
    }

    fn put_back(&self, component: &mut Component<V>) -> Outcome {
        V::check_saved(component, self.state)?;
        if component.purpose == Purpose::CoSimulation {
            component.instance.check_without_events(&self.snapshot)?;
        }
        component.instance.restore(&self.snapshot);
        if self.state.is_between_events() {
            component.instance.continue_between_events();
        }
        // Whether an event was reported is not saved; reading the states again is never wrong.
        component.has_jumped = self.state.is_at_event();
        component.state = self.state;
        component.experiment = self.experiment;
        V::sizes_mut(&mut component.own).copy_from_slice(&self.sizes);
        Ok(())
    }

    /// The numbers that the FMI layer adds to a serialised instance.
    fn owners(&self) -> [f64; serial::OWNERS] {
        let Experiment { is_set_up, start, stop } = self.experiment;
        let number = V::State::ALL.iter().find(|(state, _)| *state == self.state);
        [number.map_or(f64::NAN, |(_, number)| *number), f64::from(u8::from(is_set_up)), start, stop]
    }

    /// Reads a state of `model` back, with sizes up to these.
    pub fn read(model: &'static ModelType, most: &[usize], bytes: &[u8]) -> Result<Saved<V>, Refusal> {
        let mut further = memory::filled(0.0, most.len())?;
        let (snapshot, [state, is_set_up, start, stop]) = serial::read_with(model, &mut further, bytes)?;
        let number = V::State::ALL.iter().find(|(_, number)| number.to_bits() == state.to_bits());
        let Some((state, _)) = number else { return refuse(format_args!("unknown state {state}")) };
        if !start.is_finite() || stop.is_nan() {
            return refuse(format_args!("start time {start} or stop time {stop} is not valid"));
        }
        let Some(is_set_up) = serial::flag(is_set_up) else {
            return refuse(format_args!("the flag of the experiment is {is_set_up}: must be 0 or 1"));
        };
        let mut sizes = memory::filled(0, most.len())?;
        for ((size, number), most) in sizes.iter_mut().zip(&*further).zip(most) {
            let found = (1..=*most).find(|size| (*size as f64).to_bits() == number.to_bits());
            let Some(found) = found else {
                return refuse(format_args!("the size of an array is {number}: must be from 1 to {most}"));
            };
            *size = found;
        }
        let experiment = Experiment { is_set_up, start, stop };
        Ok(Saved { magic: V::SAVED, guid: model.guid_text(), state: *state, experiment, sizes, snapshot })
    }
}

/// The saved state behind a pointer, if it belongs to the model of `component`.
///
/// # Safety
/// `state` must be NULL or a state made by this library and not yet freed.
unsafe fn saved<'a, V: Version>(component: &Component<V>, state: *mut c_void) -> Result<&'a Saved<V>, Refusal> {
    let name = V::NAME_OF_SAVED;
    let state = state.cast::<Saved<V>>();
    // SAFETY: the caller's promise. Only its mark is read before it is known to be one of this version.
    let is_one = !state.is_null() && unsafe { (&raw const (*state).magic).read() } == V::SAVED;
    // SAFETY: as above.
    match unsafe { state.as_ref() } {
        None => refuse(format_args!("{name} is NULL")),
        Some(_) if !is_one => refuse(format_args!("{name} is not a state of this library")),
        Some(saved) if saved.guid != component.guid => {
            let whose = models::by_guid(saved.guid).map_or("another version", |model| model.name);
            refuse(format_args!("{name} belongs to {whose}, not to {}", component.instance.model().name))
        }
        Some(saved) => Ok(saved),
    }
}

/// As [`saved`], mutable.
///
/// # Safety
/// As for [`saved`]; the state must not be used elsewhere during the call.
unsafe fn saved_mut<'a, V: Version>(component: &Component<V>, state: *mut c_void) -> Result<&'a mut Saved<V>, Refusal> {
    // SAFETY: the caller's promise.
    unsafe { saved(component, state) }?;
    // SAFETY: `saved` has found a state there, and the caller promises that it is not used elsewhere.
    Ok(unsafe { &mut *state.cast::<Saved<V>>() })
}

/// Saves the state: in a new one if `place` points to NULL, otherwise in the one there.
///
/// # Safety
/// `place` must be NULL or point to NULL or to a state of this library.
pub(crate) unsafe fn save<V: Version>(component: &Component<V>, place: *mut *mut c_void) -> Outcome {
    // SAFETY: the caller promises NULL or a writable pointer.
    let Some(place) = (unsafe { place.as_mut() }) else { return refuse(format_args!("{} is NULL", V::NAME_OF_SAVED)) };
    if place.is_null() {
        *place = Box::into_raw(memory::boxed(Saved::of(component)?)?).cast();
    } else {
        // SAFETY: not NULL, so the caller promises a state of this library.
        unsafe { saved_mut(component, *place) }?.refill(component);
    }
    Ok(())
}

/// Restores a state. It can be used again.
///
/// # Safety
/// `state` must be NULL or a state of this library.
pub(crate) unsafe fn restore<V: Version>(component: &mut Component<V>, state: *mut c_void) -> Outcome {
    // SAFETY: the caller's promise.
    unsafe { saved(component, state) }?.put_back(component)
}

/// Frees a state and sets the pointer to NULL. A pointer to NULL is ignored, as is NULL.
///
/// # Safety
/// `place` must be NULL or point to NULL or to a state of this library.
pub(crate) unsafe fn free<V: Version>(component: &Component<V>, place: *mut *mut c_void) -> Outcome {
    // SAFETY: the caller promises NULL or a writable pointer.
    let Some(place) = (unsafe { place.as_mut() }) else { return Ok(()) };
    if !place.is_null() {
        // SAFETY: not NULL, so the caller promises a state of this library, which came from `Box::into_raw`.
        drop(unsafe { Box::from_raw(saved_mut(component, *place)?) });
        *place = std::ptr::null_mut();
    }
    Ok(())
}

/// Number of bytes of a state.
///
/// # Safety
/// `state` must be NULL or a state of this library; `size` NULL or writable.
pub(crate) unsafe fn size<V: Version>(component: &Component<V>, state: *mut c_void, size: *mut usize) -> Outcome {
    // SAFETY: the caller's promises.
    let (_, size) = unsafe { (saved(component, state)?, size.as_mut()) };
    let Some(size) = size else { return refuse("size is NULL") };
    *size = serial::size_with(component.instance.model(), V::sizes(&component.own).len());
    Ok(())
}

/// Writes a state as bytes.
///
/// # Safety
/// `state` must be NULL or a state of this library.
pub(crate) unsafe fn write<V: Version>(component: &Component<V>, state: *mut c_void, bytes: &mut [u8]) -> Outcome {
    // SAFETY: the caller's promise.
    let saved = unsafe { saved(component, state) }?;
    let model = component.instance.model();
    let (size, needed) = (bytes.len(), serial::size_with(model, saved.sizes.len()));
    if size < needed {
        return refuse(format_args!("serializedState has {size} bytes, {needed} are needed"));
    }
    let further = saved.sizes.iter().map(|size| *size as f64);
    serial::write_with(model, &saved.snapshot, saved.owners(), further, &mut bytes[..needed]);
    Ok(())
}

/// Makes a state from bytes, at `place` as for [`save`].
///
/// # Safety
/// As for [`save`].
pub(crate) unsafe fn read<V: Version>(component: &Component<V>, bytes: &[u8], place: *mut *mut c_void) -> Outcome {
    // SAFETY: the caller promises NULL or a writable pointer.
    let Some(place) = (unsafe { place.as_mut() }) else { return refuse(format_args!("{} is NULL", V::NAME_OF_SAVED)) };
    let read = Saved::<V>::read(component.instance.model(), V::largest_sizes(&component.own), bytes)?;
    if place.is_null() {
        *place = Box::into_raw(memory::boxed(read)?).cast();
    } else {
        // SAFETY: not NULL, so the caller promises a state of this library.
        *unsafe { saved_mut(component, *place) }? = read;
    }
    Ok(())
}
