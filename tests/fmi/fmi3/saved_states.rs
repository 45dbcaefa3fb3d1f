//! Saved states, with sizes of arrays.

use std::ptr::null_mut;

use super::importer::{Choice, Importer};
use stribeck::catalogue;
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::values::*;

#[test]
fn a_restored_state_has_the_same_future() {
    for model in catalogue::models() {
        let importer = Importer::ready_with(model.name, &Choice::events());
        importer.step(0.0, 1e-3);
        let saved = importer.save();
        let bytes = importer.bytes(saved);
        let future = |importer: &Importer| {
            importer.step(1e-3, 1e-3);
            let state = importer.save();
            let bytes = importer.bytes(state);
            importer.free(state);
            bytes
        };
        let first = future(&importer);
        // SAFETY: a state of this instance.
        assert_eq!(unsafe { fmi3SetFMUState(importer.instance, saved) }, fmi3OK);
        assert_eq!(future(&importer), first, "{}", model.name);
        importer.free(saved);
        let other = Importer::with(model.name, Purpose::CoSimulation, &Choice::events());
        let mut state = null_mut();
        // SAFETY: bytes of a state of this model.
        unsafe {
            assert_eq!(fmi3DeserializeFMUState(other.instance, bytes.as_ptr(), bytes.len(), &mut state), fmi3OK);
            assert_eq!(fmi3SetFMUState(other.instance, state), fmi3OK);
        }
        assert_eq!(future(&other), first, "{} from bytes", model.name);
        other.free(state);
    }
}

/// A strut with a table of another size than usual, and its sizes.
fn resized() -> (Importer, Vec<u32>) {
    let strut = Importer::with("ShockAbsorber", Purpose::CoSimulation, &Choice::default());
    let arrays = stribeck::arrays::of(strut.model).expect("memory");
    let sizes: Vec<u32> = arrays.iter().filter_map(|array| array.size.map(|size| size.reference())).collect();
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi3EnterConfigurationMode(strut.instance), fmi3OK);
        assert_eq!(fmi3SetUInt64(strut.instance, &sizes[0], 1, &7, 1), fmi3OK);
        assert_eq!(fmi3ExitConfigurationMode(strut.instance), fmi3OK);
    }
    (strut, sizes)
}

fn sizes_of(importer: &Importer, sizes: &[u32]) -> Vec<u64> {
    let mut values = vec![0; sizes.len()];
    let (n, place) = (sizes.len(), values.as_mut_ptr());
    // SAFETY: as many references as values.
    assert_eq!(unsafe { fmi3GetUInt64(importer.instance, sizes.as_ptr(), n, place, n) }, fmi3OK);
    values
}

#[test]
fn the_sizes_of_arrays_are_part_of_a_state() {
    let (one, sizes) = resized();
    let other = Importer::with("ShockAbsorber", Purpose::CoSimulation, &Choice::default());
    let (expected, before) = (sizes_of(&one, &sizes), sizes_of(&other, &sizes));
    assert_ne!(expected, before);
    let saved = one.save();
    let bytes = one.bytes(saved);
    let mut state = null_mut();
    // SAFETY: states and bytes of this test.
    unsafe {
        assert_eq!(fmi3SetFMUState(other.instance, saved), fmi3OK);
        assert_eq!(sizes_of(&other, &sizes), expected);
        assert_eq!(fmi3Reset(other.instance), fmi3OK);
        assert_eq!(sizes_of(&other, &sizes), before);
        assert_eq!(fmi3DeserializeFMUState(other.instance, bytes.as_ptr(), bytes.len(), &mut state), fmi3OK);
        assert_eq!(fmi3SetFMUState(other.instance, state), fmi3OK);
        assert_eq!(sizes_of(&other, &sizes), expected);
    }
    one.free(saved);
    other.free(state);
}

/// The last numbers are the sizes, before the checksum.
#[test]
fn damaged_sizes_are_noticed() {
    let (one, sizes) = resized();
    let saved = one.save();
    let bytes = one.bytes(saved);
    one.free(saved);
    for at in bytes.len() - 8 - 8 * sizes.len() / 2..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        let importer = Importer::with("ShockAbsorber", Purpose::CoSimulation, &Choice::default());
        let (bytes, n) = (damaged.as_ptr(), damaged.len());
        // SAFETY: bytes of this test.
        let status = unsafe { fmi3DeserializeFMUState(importer.instance, bytes, n, &mut null_mut()) };
        assert_eq!(status, fmi3Error, "byte {at}");
        assert!(importer.one_message().2.contains("damaged"));
    }
}

/// A state of FMI 2.0, or of a kind of instance that this one is not.
#[test]
fn states_of_others_are_rejected() {
    let two = crate::Importer::ready("LuGre");
    let mut foreign = two.save();
    let bytes: Vec<u8> = two.bytes(foreign).iter().map(|byte| *byte as u8).collect();
    let event = Importer::in_state("LuGre", Purpose::CoSimulation, &Choice::events(), State::EventMode);
    let exchange = Importer::in_state("LuGre", Purpose::ModelExchange, &Choice::default(), State::ContinuousTimeMode);
    let dahl = Importer::ready("Dahl");
    let mut state = null_mut();
    let own = [event.save(), exchange.save(), dahl.save()];
    // SAFETY: states of living instances, and bytes.
    unsafe {
        for (foreign, text) in [
            (foreign, "FMUState is not a state of this library"),
            (own[0], "FMUState is in state EventMode, and eventModeUsed was fmi3False"),
            (own[1], "FMUState is in state ContinuousTimeMode, which CoSimulation does not have"),
            (own[2], "FMUState belongs to Dahl, not to LuGre"),
            (null_mut(), "FMUState is NULL"),
        ] {
            let importer = Importer::ready("LuGre");
            assert_eq!(fmi3SetFMUState(importer.instance, foreign), fmi3Error);
            assert_eq!(importer.one_message().2, format!("fmi3SetFMUState: {text}"));
        }
        let importer = Importer::ready("LuGre");
        assert_eq!(fmi3DeserializeFMUState(importer.instance, bytes.as_ptr(), bytes.len(), &mut state), fmi3Error);
        assert!(importer.one_message().2.contains("unknown state 2"));
        assert_eq!(stribeck_ffi::fmi2::snapshot::fmi2FreeFMUstate(two.c, &mut foreign), crate::fmi2OK);
    }
    for (owner, state) in [&event, &exchange, &dahl].into_iter().zip(own) {
        owner.free(state);
    }
}

/// Bytes of a state that only the callback within a step sees: an instance would never leave it.
#[test]
fn a_state_within_a_step_is_rejected() {
    let importer = Importer::ready("LuGre");
    let saved = importer.save();
    let mut bytes = importer.bytes(saved);
    importer.free(saved);
    // The fourth number after the head; that of the callback's state is the next one.
    let place = 50 + 8 * 3..50 + 8 * 4;
    assert_eq!(bytes[place.clone()], 21f64.to_le_bytes());
    bytes[place].copy_from_slice(&22f64.to_le_bytes());
    crate::saved_states::seal(&mut bytes);
    let mut read = null_mut();
    // SAFETY: bytes and a state of this test.
    unsafe {
        assert_eq!(fmi3DeserializeFMUState(importer.instance, bytes.as_ptr(), bytes.len(), &mut read), fmi3OK);
        assert_eq!(fmi3SetFMUState(importer.instance, read), fmi3Error);
    }
    assert!(
        importer.one_message().2.ends_with("FMUState is in state IntermediateUpdateMode, which only a step enters")
    );
    importer.free(read);
}
