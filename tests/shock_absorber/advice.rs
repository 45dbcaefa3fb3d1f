//! Advice is computed only when it is read, and nobody can see that from its values.

use crate::common::Bench;
use crate::common::importer::Importer;
use crate::{TABLE, law, laws, strut};
use stribeck::model::Computed;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

const ADVICE: [&str; 3] = ["dforce_dlength", "dforce_dvelocity", "step_limit"];

/// The advice of a strut, with all its bits.
fn read(strut: &mut Bench) -> [u64; 3] {
    ADVICE.map(|name| strut.get(name).to_bits())
}

/// The same from the row alone, for which everything is computed at once.
fn at_once(strut: &Bench) -> [u64; 3] {
    let mut row = strut.instance.row().to_vec();
    assert!(strut.instance.model().output(&mut row));
    ADVICE.map(|name| row[strut.column(name)].to_bits())
}

fn move_to(strut: &mut Bench, k: u32) {
    let phase = 0.05 * f64::from(k);
    strut.set("length", 0.1775 + 0.01 * phase.sin());
    strut.set("velocity", 0.1 * phase.cos());
}

/// Neither reading it in between, nor a saved state, nor the order of reading makes a difference.
#[test]
fn advice_has_the_same_bits_whenever_it_is_read() {
    for (law, name) in laws() {
        let set = [TABLE, ("friction.model", law), ("damper.k_series", 1e6), ("side_force_m", 50.0)];
        let (mut often, mut seldom) = (strut(&set), strut(&set));
        for k in 0..25 {
            for strut in [&mut often, &mut seldom] {
                move_to(strut, k);
                strut.step(1e-3);
            }
            let now = read(&mut often);
            assert_eq!(now, at_once(&often), "{name}, {k}");
            assert_eq!(often.get("force"), seldom.get("force"), "{name}, {k}");
            assert_eq!(often.instance.save(), seldom.instance.save(), "{name}, {k}");
        }
        let saved = often.instance.save();
        assert_eq!(read(&mut seldom), read(&mut often), "{name}");
        let mut restored = strut(&set);
        read(&mut restored);
        restored.instance.restore(&saved);
        assert_eq!(read(&mut restored), read(&mut often), "{name}");
        assert_eq!(restored.instance.save(), saved, "{name}");
    }
}

#[test]
fn only_reading_advice_computes_it() {
    let mut strut = strut(&[]);
    strut.step(1e-3);
    strut.get("length");
    strut.get("force");
    assert_eq!(strut.instance.computed(), Computed::Main);
    strut.get("step_limit");
    assert_eq!(strut.instance.computed(), Computed::All);
    move_to(&mut strut, 1);
    assert_eq!(strut.instance.computed(), Computed::Nothing);
    strut.instance.refresh().unwrap();
    assert_eq!(read(&mut strut), at_once(&strut));
    // A step that fails changes nothing: what was computed before it is still valid.
    let before = read(&mut strut);
    strut.instance.step(f64::NAN).unwrap_err();
    assert_eq!(strut.instance.computed(), Computed::All);
    assert_eq!(read(&mut strut), before);
}

/// At the last instant before the gas is gone the force is a number, its slope is not: steps and results continue,
/// reading the advice is an error that leaves everything as it was.
#[test]
fn advice_that_is_not_finite_is_an_error_of_its_own() {
    let edge = |strut: &Bench| {
        let row = strut.instance.row();
        let [extended, volume, rod] =
            ["geom.length_extended", "gas.V0", "gas.rod_diameter"].map(|name| row[strut.column(name)]);
        extended - volume / (std::f64::consts::PI / 4.0 * rod * rod) + 4e-9
    };
    let mut strut = strut(&[("gas.V0", 1e-5), law("LuGre")]);
    let before = read(&mut strut);
    let length = edge(&strut);
    strut.set("length", length);
    strut.step(1e-3);
    assert!(strut.get("force").is_finite());
    let row = strut.instance.row().to_vec();
    let text = strut.instance.get_by_name("step_limit").unwrap_err().to_string();
    assert!(text.starts_with("the advice would not be finite at length = "), "{text}");
    assert_eq!(strut.instance.row(), row);
    assert_eq!(strut.instance.computed(), Computed::Main);
    assert!(strut.instance.refresh().is_err());
    strut.step(1e-3);
    strut.set("length", 0.1775);
    strut.set("velocity", 0.0);
    assert_ne!(read(&mut strut), before);
    assert_eq!(read(&mut strut), at_once(&strut));

    let importer = Importer::in_state("ShockAbsorber", State::Initialization);
    for (name, value) in [("gas.V0", 1e-5), ("length", length)] {
        assert_eq!(importer.set(name, value), fmi2OK);
    }
    assert!(importer.get("force").is_finite());
    let mut values = [0.0; 2];
    let references = ["force", "step_limit"].map(|name| importer.vr(name));
    // SAFETY: two references, two values.
    assert_eq!(unsafe { fmi2GetReal(importer.c, references.as_ptr(), 2, values.as_mut_ptr()) }, fmi2Error);
    assert!(importer.last_message().contains("the advice would not be finite"), "{}", importer.last_message());
}

/// An importer reads what the library computes for a row at once: also from a restored state, after an error, and
/// together with other variables.
#[test]
fn importers_read_the_same_advice() {
    let mut reference = strut(&[]);
    let importer = Importer::ready("ShockAbsorber");
    for k in 0..5 {
        move_to(&mut reference, k);
        for name in ["length", "velocity"] {
            assert_eq!(importer.set(name, reference.get(name)), fmi2OK);
        }
        reference.step(1e-3);
        assert_eq!(importer.step(1e-3 * f64::from(k), 1e-3), fmi2OK);
    }
    let mut state = importer.save();
    let expected = ADVICE.map(|name| reference.get(name));
    assert_eq!(ADVICE.map(|name| importer.get(name)), expected);
    let mut later = importer.save();
    assert_eq!(importer.bytes(state), importer.bytes(later));
    assert_eq!(importer.step(0.0, 1e-3), fmi2Error);
    assert_eq!(ADVICE.map(|name| importer.get(name)), expected);
    // SAFETY: states of this test, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(importer.c, state), fmi2OK);
        assert_eq!(importer.step(0.0, 1e-3), fmi2Error);
        assert_eq!(importer.get("step_limit"), expected[2]);
        assert_eq!(fmi2SetFMUstate(importer.c, later), fmi2OK);
        let mut values = [0.0; 3];
        let references = ["step_limit", "length", "force"].map(|name| importer.vr(name));
        assert_eq!(fmi2GetReal(importer.c, references.as_ptr(), 3, values.as_mut_ptr()), fmi2OK);
        assert_eq!(values, [expected[2], reference.get("length"), reference.get("force")]);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut state), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut later), fmi2OK);
    }
}

/// Between events a result that jumps keeps its value; advice follows the motion, and reading it changes no result.
#[test]
fn advice_follows_between_events() {
    let importer = Importer::in_state_of("ShockAbsorber", Purpose::ModelExchange, State::ContinuousTimeMode);
    let is_bumped = || {
        let mut value = fmi2False;
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi2GetBoolean(importer.c, &importer.vr("bump_active"), 1, &mut value) }, fmi2OK);
        value != fmi2False
    };
    let seen = [0.17, 0.12].map(|length| {
        assert_eq!(importer.set("length", length), fmi2OK);
        let advice = importer.get("dforce_dlength");
        assert!(!is_bumped());
        advice
    });
    assert_ne!(seen[0], seen[1]);
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2EnterEventMode(importer.c) }, fmi2OK);
    assert_eq!(importer.get("dforce_dlength"), seen[1]);
    assert!(is_bumped());
}
