//! The importer's callback within a step.

use std::sync::{Arc, Mutex};

use super::importer::{Answer, Choice, Importer, Visit};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::values::*;

/// An instance that may be used within its own steps.
#[derive(Clone, Copy)]
struct Shared(*mut std::ffi::c_void);

// SAFETY: used by one thread only.
unsafe impl Send for Shared {}

impl Shared {
    fn get(self, reference: u32) -> Option<f64> {
        let mut value = f64::NAN;
        // SAFETY: one reference, one value.
        let status = unsafe { fmi3GetFloat64(self.0, &reference, 1, &mut value, 1) };
        (status == fmi3OK).then_some(value)
    }
}

fn law(early_return: bool) -> (Importer, u32) {
    let force = Importer::ready("LuGre").vr("friction_force");
    let choice = Choice { early_return, within: true, required: vec![force], ..Choice::default() };
    let law = Importer::ready_with("LuGre", &choice);
    assert_eq!(law.set("velocity", 1e-3), fmi3OK);
    (law, force)
}

fn within(law: &Importer, body: impl FnMut(&Visit) -> Option<f64> + Send + 'static) {
    *law.heard.within.lock().expect("one thread") = Some(Box::new(body));
}

/// The forces within a step are those at the ends of shorter steps, and the end is that of the whole step.
#[test]
fn forces_within_a_step_are_those_of_shorter_steps() {
    let (law, force) = law(false);
    let (seen, own) = (Arc::new(Mutex::new(Vec::new())), Shared(law.instance));
    let record = seen.clone();
    within(&law, move |visit| {
        assert_eq!(visit.flags, [false, true, true, false], "nothing to set, final results, no early return");
        record.lock().expect("one thread").push((visit.time, own.get(force).expect("a force")));
        Some(0.0)
    });
    assert_eq!(law.step(0.0, 8e-3), Answer { event: false, early: false, time: 8e-3 }, "not asked for");
    let seen = seen.lock().expect("one thread");
    assert_eq!(seen.len(), 4);
    for (part, (time, seen)) in (1..).zip(seen.iter()) {
        let other = Importer::ready("LuGre");
        assert_eq!(other.set("velocity", 1e-3), fmi3OK);
        let length = 8e-3 * (f64::from(part) / 4.0);
        other.step(0.0, length);
        assert_eq!((*time, seen.to_bits()), (length, other.get("friction_force").to_bits()));
    }
    assert_eq!(law.get("friction_force"), seen[3].1);
}

/// An importer that asks for it has the step end where it wants, not before what it has seen.
#[test]
fn an_importer_may_end_the_step() {
    for (asked, expected) in [(5e-3, 5e-3), (2e-3, 2e-3), (1e-3, 2e-3), (8e-3, 8e-3)] {
        let (law, _) = law(true);
        within(&law, move |visit| visit.flags[3].then_some(asked));
        assert_eq!(law.step(0.0, 8e-3), Answer { event: false, early: expected < 8e-3, time: expected });
        let other = Importer::ready("LuGre");
        assert_eq!(other.set("velocity", 1e-3), fmi3OK);
        other.step(0.0, expected);
        assert_eq!(law.get("friction_force").to_bits(), other.get("friction_force").to_bits());
        *law.heard.within.lock().expect("one thread") = None;
        law.step(expected, 1e-3);
    }
    for wrong in [f64::NAN, -1.0, 9e-3] {
        let (law, _) = law(true);
        within(&law, move |visit| visit.flags[3].then_some(wrong));
        assert_eq!(law.try_step(0.0, 8e-3), Err(fmi3Error));
        assert!(law.one_message().2.contains("earlyReturnTime = "));
    }
}

/// What is not allowed within a step ends it with an error, and the states are those of its beginning.
#[test]
fn other_calls_within_a_step_are_rejected() {
    let (reference, _) = law(false);
    let [velocity, mu_k] = ["velocity", "mu_k"].map(|name| reference.vr(name));
    for what in 0..3 {
        let (law, _) = law(false);
        let own = Shared(law.instance);
        within(&law, move |_| {
            // SAFETY: one reference, one value.
            unsafe {
                match what {
                    0 => assert_eq!(fmi3SetFloat64(own.0, &velocity, 1, &1.0, 1), fmi3Error),
                    1 => assert_eq!(own.get(mu_k), None, "not required"),
                    _ => assert_eq!(fmi3Reset(own.0), fmi3Error),
                }
            }
            None
        });
        assert_eq!(law.try_step(0.0, 8e-3), Err(fmi3Error));
        let text = law.heard.messages.lock().expect("one thread")[0].2.clone();
        assert!(text.contains(["IntermediateUpdateMode", "required", "IntermediateUpdateMode"][what]), "{text}");
        *law.heard.within.lock().expect("one thread") = None;
        assert_eq!(law.get("friction_force"), reference.get("friction_force"), "nothing has moved");
    }
}
