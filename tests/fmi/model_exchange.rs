//! Model Exchange: events, phases, and a solver that leaves the domain or makes an error.

use std::ffi::CStr;
use std::ptr::null_mut;

use crate::common::NO_EVENT;
use crate::common::importer::Importer;
use approx::assert_abs_diff_eq;
use stribeck::catalogue;
use stribeck::model::Kind;
use stribeck_ffi::c::stribeck_status::*;
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// Changes of the given states by the first event are reported once.
#[test]
fn states_that_the_first_event_changes_are_reported() {
    for (load, jumps) in [(0.0, fmi2True), (9.81, fmi2False)] {
        let starting = Importer::in_state_of("Dahl", Purpose::ModelExchange, State::Initialization);
        assert_eq!(starting.set("normal_force", load), fmi2OK);
        assert_eq!(starting.set("bristle_deflection", 5e-6), fmi2OK);
        let mut states = starting.states();
        let mut event = NO_EVENT;
        // SAFETY: an instance of this test, arrays of the number of states, a writable struct.
        unsafe {
            assert_eq!(fmi2ExitInitializationMode(starting.c), fmi2OK);
            assert_eq!(fmi2NewDiscreteStates(starting.c, &mut event), fmi2OK);
            assert_eq!(event.valuesOfContinuousStatesChanged, jumps, "{load} N");
            assert_eq!(fmi2GetContinuousStates(starting.c, states.as_mut_ptr(), states.len()), fmi2OK);
            assert_eq!(states[0] != 5e-6, jumps == fmi2True, "{load} N");
            assert_eq!(fmi2NewDiscreteStates(starting.c, &mut event), fmi2OK);
            assert_eq!(event.valuesOfContinuousStatesChanged, fmi2False, "said once");
        }
    }
}

/// A phase belongs to Model Exchange; in co-simulation it would hold a contact that cannot be held.
#[test]
fn phases_set_by_events_are_rejected_in_co_simulation() {
    let stepping = Importer::in_state("CoulombStiction", State::Initialization);
    let integrating = Importer::in_state_of("CoulombStiction", Purpose::ModelExchange, State::Initialization);
    let (phase, force) = (stepping.vr("phase"), stepping.vr("external_force"));
    // SAFETY: one reference, one value in each call.
    unsafe {
        assert_eq!(fmi2SetReal(stepping.c, &force, 1, &1000.0), fmi2OK);
        assert_eq!(fmi2SetInteger(stepping.c, &phase, 1, &1), fmi2OK, "its start value");
        assert_eq!(fmi2SetInteger(stepping.c, &phase, 1, &2), fmi2Discard);
        let (_, _, text) = stepping.one_message();
        assert!(text.contains("phase = 2: must be 1 without events"), "{text}");
        assert_eq!(fmi2SetInteger(integrating.c, &phase, 1, &2), fmi2OK);
        assert_eq!(fmi2SetInteger(integrating.c, &phase, 1, &5), fmi2Discard);
    }
    // f_s = mu_s f_n
    assert_abs_diff_eq!(stepping.get("friction_force"), 0.15 * 9.81, epsilon = 1e-12);
    assert_eq!(integrating.set("external_force", 1000.0), fmi2OK);
    let mut saved = null_mut();
    // SAFETY: instances of this test, a state that is freed once.
    unsafe {
        assert_eq!(fmi2GetFMUstate(integrating.c, &mut saved), fmi2OK);
        assert_eq!(fmi2SetFMUstate(stepping.c, saved), fmi2Error);
        let (_, _, text) = stepping.one_message();
        assert!(text.contains("phase = 2: must be 1 without events"), "{text}");
        let bytes = integrating.bytes(saved);
        let mut handle = null_mut();
        assert_eq!(stribeck_create(c"CoulombStiction".as_ptr(), &mut handle), STRIBECK_OK);
        assert_eq!(stribeck_restore(handle, bytes.as_ptr().cast(), bytes.len()), STRIBECK_BAD_BUFFER);
        let text = CStr::from_ptr(stribeck_last_error(handle)).to_string_lossy().into_owned();
        assert!(text.contains("phase = 2: must be 1 without events"), "{text}");
        stribeck_free(handle);
        assert_eq!(fmi2FreeFMUstate(integrating.c, &mut saved), fmi2OK);
    }
    assert_abs_diff_eq!(integrating.get("friction_force"), 1000.0, epsilon = 1e-9);
    let mut left = 0;
    // SAFETY: one reference, one value.
    assert_eq!(unsafe { fmi2GetInteger(stepping.c, &phase, 1, &mut left) }, fmi2OK);
    assert_eq!(left, 1, "nothing was changed");
}

/// Laws that jump or have other memory have no derivatives to integrate, and without steps no force can be held over a
/// step.
#[test]
fn features_of_steps_only_are_rejected_by_name() {
    let initial = |model| Importer::in_state_of(model, Purpose::ModelExchange, State::Initialization);
    let (coulomb, strut) = (initial("Coulomb"), initial("ShockAbsorber"));
    assert_eq!(coulomb.set("mass", 1.0), fmi2OK);
    let model = catalogue::by_name("ShockAbsorber").expect("the strut");
    let column = model.find("friction.model").expect("its law");
    let Kind::Enumeration(laws) = model.table.at(column).kind else { panic!("the laws are choices") };
    let bristle = laws.items.iter().position(|law| law.name == "Bristle").expect("a law of random bonds") as i32 + 1;
    // SAFETY: one reference, one value; instances of this test.
    unsafe {
        assert_eq!(fmi2ExitInitializationMode(coulomb.c), fmi2Error);
        assert_eq!(fmi2SetInteger(strut.c, &model.reference(column), 1, &bristle), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(strut.c), fmi2Error);
    }
    assert!(coulomb.one_message().2.contains("mass = 1: must be 0 in Model Exchange"));
    assert!(strut.one_message().2.contains("friction.model = Bristle: must be a law that supports Model Exchange"));
}

/// Condition 5 of the table: between events only inputs change.
#[test]
fn parameters_change_only_at_events() {
    let moving = Importer::in_state_of("LuGre", Purpose::ModelExchange, State::ContinuousTimeMode);
    assert_eq!(moving.set("velocity", 1e-3), fmi2OK);
    assert_eq!(moving.set("mu_k", 0.12), fmi2Error);
    assert!(moving.one_message().2.contains("mu_k cannot be set in state ContinuousTimeMode"));
    let at_event = Importer::in_state_of("LuGre", Purpose::ModelExchange, State::EventMode);
    assert_eq!(at_event.set("mu_k", 0.12), fmi2OK);
    assert_eq!(at_event.set("bristle_deflection", 0.0), fmi2Error, "states are set with fmi2SetContinuousStates");
}

/// An instance in continuous-time mode, as used by a solver.
fn integrated(model: &'static str) -> Importer {
    Importer::in_state_of(model, Purpose::ModelExchange, State::ContinuousTimeMode)
}

#[test]
fn a_solver_that_leaves_the_domain_may_return() {
    let solver = integrated("ShockAbsorber");
    // The gas has no volume left.
    assert_eq!(solver.set("length", 1e-3), fmi2OK);
    let mut force = 0.0;
    // SAFETY: one reference, one value.
    let status = unsafe { fmi2GetReal(solver.c, &solver.vr("force"), 1, &mut force) };
    assert_eq!(status, fmi2Discard);
    let (_, category, text) = solver.one_message();
    assert!(category == "logStatusDiscard" && text.contains("length = 0.001"), "{category}: {text}");
    assert_eq!(solver.set("length", 0.17), fmi2OK);
    assert!(solver.get("force").is_finite());
}

/// The same for derivatives in a direction, of outputs and of the states' derivatives, alone and together.
#[test]
fn derivatives_outside_the_domain_are_discarded_and_the_run_continues() {
    let solver = integrated("ShockAbsorber");
    let model = catalogue::by_name("ShockAbsorber").expect("a model");
    let (force, length) = (solver.vr("force"), solver.vr("length"));
    let rates: Vec<u32> = model.derivative_references().collect();
    let both: Vec<u32> = [force].into_iter().chain(rates.iter().copied()).collect();
    let mut found = vec![f64::NAN; both.len()];
    let mut derive = |unknowns: &[u32]| {
        let (n, place) = (unknowns.len(), found.as_mut_ptr());
        // SAFETY: as many unknowns as values at most, one known.
        unsafe { fmi2GetDirectionalDerivative(solver.c, unknowns.as_ptr(), n, &length, 1, &1.0, place) }
    };
    // A length that leaves the gas no volume, and one at which nothing is finite.
    for (name, value, back) in [("length", 1e-3, 0.17), ("velocity", 1e308, 0.0)] {
        assert_eq!(solver.set(name, value), fmi2OK);
        for unknowns in [&[force][..], &both, &rates] {
            if derive(unknowns) == fmi2OK {
                assert!(unknowns == rates && name == "length", "{name}: the derivatives ignore the gas");
                continue;
            }
            let (status, category, text) = solver.one_message();
            assert_eq!((status, &*category), (fmi2Discard, "logStatusDiscard"), "{text}");
            assert!(text.contains(name), "{text}");
        }
        assert_eq!(solver.set(name, back), fmi2OK);
        assert_eq!(derive(&both), fmi2OK, "back from {name} = {value}");
    }
}

/// After an error the derivatives are those of the present row: neither leftovers of an event nor values that are not
/// finite.
#[test]
fn derivatives_after_an_error_are_those_of_the_last_states() {
    let rates = |solver: &Importer| {
        let mut rates = solver.states();
        // SAFETY: arrays of the number of states.
        let status = unsafe { fmi2GetDerivatives(solver.c, rates.as_mut_ptr(), rates.len()) };
        (status, rates)
    };
    let solver = integrated("Dahl");
    assert_eq!(solver.set("bristle_deflection", 4e-6), fmi2OK);
    assert_eq!(solver.set("velocity", 2e-3), fmi2OK);
    let before = rates(&solver);
    // dz/dt = v (1 - sigma_0 z / f_C)
    assert!((before.1[0] / (2e-3 * (1.0 - 0.4 / 0.981)) - 1.0).abs() < 1e-12, "{before:?}");
    let mut event = NO_EVENT;
    // SAFETY: an instance of this test, a writable struct.
    unsafe {
        assert_eq!(fmi2EnterEventMode(solver.c), fmi2OK);
        assert_eq!(fmi2NewDiscreteStates(solver.c, &mut event), fmi2OK);
        assert_eq!(fmi2SetTime(solver.c, f64::NAN), fmi2Error);
    }
    assert_eq!(rates(&solver), before);

    let solver = integrated("ShockAbsorber");
    assert_eq!(solver.set("velocity", 1e308), fmi2OK);
    assert_eq!(rates(&solver).0, fmi2Discard);
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2SetTime(solver.c, f64::NAN) }, fmi2Error);
    assert_eq!(rates(&solver).0, fmi2Error, "there are none");
}

#[test]
fn a_solver_may_set_one_state_by_its_reference() {
    let solver = integrated("LuGre");
    assert_eq!(solver.set("bristle_deflection", 1e-6), fmi2OK);
    // sigma_0 z
    assert_abs_diff_eq!(solver.get("friction_force"), 0.1, epsilon = 1e-12);
    // Discontinuous results wait for an event.
    let solver = integrated("CoulombStiction");
    assert_eq!(solver.set("stuck", 1.0), fmi2Error);
}

#[test]
fn mass_is_rejected_at_events_too() {
    let solver = Importer::in_state_of("Coulomb", Purpose::ModelExchange, State::EventMode);
    let mut event = NO_EVENT;
    assert_eq!(solver.set("mass", 1.0), fmi2OK);
    // SAFETY: an instance of this test, a writable struct.
    assert_eq!(unsafe { fmi2NewDiscreteStates(solver.c, &mut event) }, fmi2Error);
    let (_, _, text) = solver.one_message();
    assert!(text.contains("mass = 1: must be 0"), "{text}");
}

/// Between events discontinuous results stay constant; the end of a solver's step requests the event that changes them.
#[test]
fn discontinuous_results_change_only_at_events() {
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let (Some(velocity), Some(sticking)) = (model.find("velocity"), model.find("sticking")) else { continue };
        let integrating = Importer::in_state_of(model.name, Purpose::ModelExchange, State::ContinuousTimeMode);
        let (mut event, mut enters, mut ends) = (NO_EVENT, fmi2False, fmi2False);
        let sticks = || {
            let mut flag = -1;
            // SAFETY: one reference, one value.
            assert_eq!(unsafe { fmi2GetBoolean(integrating.c, &model.reference(sticking), 1, &mut flag) }, fmi2OK);
            flag
        };
        assert_eq!(sticks(), fmi2True, "{} at rest", model.name);
        // SAFETY: one reference, one value; flags of this test; a state of this instance, freed once.
        unsafe {
            assert_eq!(fmi2SetReal(integrating.c, &model.reference(velocity), 1, &0.3), fmi2OK);
            assert_eq!(sticks(), fmi2True, "{} between events", model.name);
            let mut saved = integrating.save();
            assert_eq!(fmi2SetFMUstate(integrating.c, saved), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(integrating.c, &mut saved), fmi2OK);
            assert_eq!(sticks(), fmi2True, "{} restored", model.name);
            assert_eq!(fmi2CompletedIntegratorStep(integrating.c, fmi2True, &mut enters, &mut ends), fmi2OK);
            assert_eq!(fmi2EnterEventMode(integrating.c), fmi2OK);
            assert_eq!(fmi2NewDiscreteStates(integrating.c, &mut event), fmi2OK);
            assert_eq!(fmi2EnterContinuousTimeMode(integrating.c), fmi2OK);
        }
        let slides = sticks() == fmi2False;
        let [has_phase, has_bristles] = ["phase", "bristle_deflection"].map(|name| model.find(name).is_some());
        // Bristles are not yet deflected.
        assert!(!has_phase || slides != has_bristles, "{} slides", model.name);
        // A phase has its own event indicator.
        assert_eq!(enters == fmi2True, slides && !has_phase, "{}", model.name);
    }
}
