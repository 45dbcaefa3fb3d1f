//! Steps of co-simulation are those of FMI 2.0.

use super::importer::{Answer, Choice, Importer};
use super::{driven, reals};
use crate::{drive, millisecond};
use stribeck::catalogue;
use stribeck::model::Role;
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;

/// As `crate::drive`: the bits of all real outputs after each step, in the order of the table.
fn drive_three(importer: &Importer, steps: i32) -> Vec<u64> {
    let model = importer.model;
    let (inputs, outputs) = (reals(model, |role| role == Role::Input), reals(model, Role::is_output));
    let references: Vec<u32> = outputs.iter().map(|output| output.reference).collect();
    let mut columns: Vec<(usize, usize)> =
        outputs.iter().flat_map(|output| output.columns.iter().copied()).enumerate().map(|(at, c)| (c, at)).collect();
    columns.sort_unstable();
    let mut values = vec![f64::NAN; columns.len()];
    let mut bits = Vec::new();
    for k in 0..steps {
        for input in &inputs {
            let values: Vec<f64> = input.columns.iter().map(|column| driven(&model.table.at(*column), k)).collect();
            assert_eq!(importer.set_all(&[input.reference], &values), fmi3OK, "{}", importer.last_message());
        }
        let answer = importer.step(millisecond(k), 1e-3);
        assert!(!answer.early && answer.time == millisecond(k) + 1e-3);
        assert_eq!(importer.get_all(&references, &mut values), fmi3OK, "{}", importer.last_message());
        bits.extend(columns.iter().map(|(_, at)| values[*at].to_bits()));
    }
    bits
}

/// Whatever else the importer can do: without early return a step goes to its end.
#[test]
fn every_model_has_the_bits_of_fmi_2() {
    let mut count = 0;
    for model in catalogue::models() {
        let two = drive(&crate::Importer::ready(model.name), 0..12, 1e-3, millisecond);
        for choice in [
            Choice::default(),
            Choice { event_mode: true, ..Choice::default() },
            Choice { early_return: true, within: true, ..Choice::default() },
        ] {
            let three = drive_three(&Importer::ready_with(model.name, &choice), 12);
            assert_eq!(two, three, "{}", model.name);
            count += three.len();
        }
    }
    println!("figure: {count} results of FMI 3.0 have the bits of FMI 2.0");
}

#[test]
fn steps_that_make_no_sense_are_rejected() {
    for (t, h) in [(0.0, 0.0), (0.0, -1e-3), (0.0, f64::NAN), (f64::NAN, 1e-3), (5e-3, 1e-3), (0.0, 100.1)] {
        for choice in [Choice::default(), Choice::events(), Choice { within: true, ..Choice::default() }] {
            let importer = Importer::ready_with("LuGre", &choice);
            assert_eq!(importer.try_step(t, h), Err(fmi3Error), "{t} {h}");
            let (status, category, text) = importer.one_message();
            assert_eq!((status, category.as_str()), (fmi3Error, "logStatusError"));
            assert!(text.starts_with("fmi3DoStep: "), "{text}");
            assert_eq!(importer.try_step(0.0, 1e-3), Err(fmi3Error), "after an error");
            // SAFETY: an instance of this test.
            assert_eq!(unsafe { fmi3Reset(importer.instance) }, fmi3OK);
        }
    }
}

#[test]
fn places_for_answers_must_not_be_null() {
    for missing in 0..4 {
        let importer = Importer::ready("LuGre");
        let ([mut event, mut end, mut early], mut time) = ([9; 3], f64::NAN);
        let [a, b, c] = [&raw mut event, &raw mut end, &raw mut early];
        let null = std::ptr::null_mut();
        let place = |at: usize, place| if at == missing { null } else { place };
        let d = if missing == 3 { std::ptr::null_mut() } else { &raw mut time };
        // SAFETY: NULL or places for all answers.
        let status = unsafe { fmi3DoStep(importer.instance, 0.0, 1e-3, 1, place(0, a), place(1, b), place(2, c), d) };
        assert_eq!(status, fmi3Error);
        assert!(importer.one_message().2.ends_with(" is NULL"));
    }
}

#[test]
fn an_answer_is_complete() {
    let importer = Importer::ready("Coulomb");
    assert_eq!(importer.step(0.0, 0.25), Answer { event: false, early: false, time: 0.25 });
}
