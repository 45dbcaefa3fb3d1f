//! Value references, values within and outside their bounds, and outputs after a set.

use std::ptr::{null, null_mut};

use crate::common::importer::Importer;
use approx::assert_abs_diff_eq;
use stribeck::model::{Kind, Role};
use stribeck::{catalogue, reference};
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// A call that is wrong ends with an error and one message.
fn check(what: &str, wrong: &dyn Fn(&Importer) -> fmi2Status) {
    let importer = Importer::ready("LuGre");
    assert_eq!(wrong(&importer), fmi2Error, "{what}");
    importer.one_message();
}

#[test]
fn wrong_references_pointers_and_types_are_errors() {
    let too_far = 10_000;
    // SAFETY: arrays of one element, or NULL where the library must notice.
    unsafe {
        check("unknown reference, get", &|i| fmi2GetReal(i.c, &too_far, 1, &mut 0.0));
        check("unknown reference, set", &|i| fmi2SetReal(i.c, &too_far, 1, &0.0));
        check("vr NULL", &|i| fmi2GetReal(i.c, null(), 1, &mut 0.0));
        check("value NULL", &|i| fmi2GetReal(i.c, &i.vr("velocity"), 1, null_mut()));
        check("vr NULL, set", &|i| fmi2SetReal(i.c, null(), 1, &0.0));
        check("value NULL, set", &|i| fmi2SetReal(i.c, &i.vr("velocity"), 1, null()));
        check("Boolean vr NULL", &|i| fmi2GetBoolean(i.c, null(), 1, &mut 0));
        check("Boolean value NULL", &|i| fmi2GetBoolean(i.c, &i.vr("sticking"), 1, null_mut()));
        check("Integer value NULL", &|i| fmi2GetInteger(i.c, &i.vr("velocity"), 1, null_mut()));
        check("String", &|i| fmi2GetString(i.c, &i.vr("velocity"), 1, &mut null()));
        check("set String", &|i| fmi2SetString(i.c, &i.vr("velocity"), 1, &null()));
        check("Real as Integer", &|i| fmi2SetInteger(i.c, &i.vr("velocity"), 1, &0));
        check("Boolean as Real", &|i| fmi2GetReal(i.c, &i.vr("sticking"), 1, &mut 0.0));
        check("set an output", &|i| i.set("friction_force", 1.0));
        check("set a state while stepping", &|i| i.set("bristle_deflection", 0.0));
    }
}

#[test]
fn wrong_derivatives_and_categories_are_errors() {
    // SAFETY: arrays of one element, or NULL where the library must notice.
    unsafe {
        check("category NULL", &|i| fmi2SetDebugLogging(i.c, fmi2True, 1, &null()));
        check("unknown category", &|i| fmi2SetDebugLogging(i.c, fmi2True, 1, &c"logNothing".as_ptr()));
        check("derivative of a parameter", &|i| fmi2SetRealInputDerivatives(i.c, &i.vr("mu_k"), 1, &1, &0.0));
        check("derivative of order 2", &|i| fmi2SetRealInputDerivatives(i.c, &i.vr("velocity"), 1, &2, &0.0));
        check("output derivative of an input", &|i| {
            fmi2GetRealOutputDerivatives(i.c, &i.vr("velocity"), 1, &1, &mut 0.0)
        });
        check("output derivative of order 0", &|i| {
            fmi2GetRealOutputDerivatives(i.c, &i.vr("friction_force"), 1, &0, &mut 0.0)
        });
        check("unknown that is an input", &|i| {
            fmi2GetDirectionalDerivative(i.c, &i.vr("velocity"), 1, &i.vr("normal_force"), 1, &1.0, &mut 0.0)
        });
    }
}

#[test]
fn wrong_states_and_places_for_results_are_errors() {
    // SAFETY: arrays of one element, or NULL where the library must notice.
    unsafe {
        check("status value NULL", &|i| fmi2GetRealStatus(i.c, fmi2LastSuccessfulTime, null_mut()));
        check("FMUstate NULL", &|i| fmi2GetFMUstate(i.c, null_mut()));
        check("set FMUstate NULL", &|i| fmi2SetFMUstate(i.c, null_mut()));
        check("size of NULL", &|i| fmi2SerializedFMUstateSize(i.c, null_mut(), &mut 0));
        check("deserialise nothing", &|i| fmi2DeSerializeFMUstate(i.c, null(), 0, &mut null_mut()));
        let owner = Importer::ready("LuGre");
        let mut saved = owner.save();
        let mut bytes = owner.bytes(saved);
        check("size NULL", &|i| fmi2SerializedFMUstateSize(i.c, saved, null_mut()));
        check("deserialise to NULL", &|i| fmi2DeSerializeFMUstate(i.c, bytes.as_ptr(), bytes.len(), null_mut()));
        let (start, too_few) = (bytes.as_mut_ptr(), bytes.len() - 1);
        check("too few bytes", &|i| fmi2SerializeFMUstate(i.c, saved, start, too_few));
        assert_eq!(fmi2FreeFMUstate(owner.c, &mut saved), fmi2OK);
    }
}

#[test]
fn places_for_the_results_of_events_must_not_be_null() {
    // SAFETY: NULL where the library must notice.
    unsafe {
        let integrating = |state| Importer::in_state_of("LuGre", Purpose::ModelExchange, state);
        let importer = integrating(State::EventMode);
        assert_eq!(fmi2NewDiscreteStates(importer.c, null_mut()), fmi2Error);
        assert!(importer.one_message().2.contains("eventInfo is NULL"));
        for is_first in [true, false] {
            let importer = integrating(State::ContinuousTimeMode);
            let mut flag = fmi2True;
            let (event, end): (*mut _, *mut _) =
                if is_first { (null_mut(), &mut flag) } else { (&mut flag, null_mut()) };
            assert_eq!(fmi2CompletedIntegratorStep(importer.c, fmi2True, event, end), fmi2Error);
            assert!(importer.one_message().2.contains("is NULL"));
        }
    }
}

#[test]
fn empty_arrays_the_time_and_states_that_do_not_exist_are_accepted() {
    // SAFETY: empty arrays, and one element.
    unsafe {
        let importer = Importer::ready("LuGre");
        assert_eq!(fmi2GetReal(importer.c, null(), 0, null_mut()), fmi2OK);
        assert_eq!(fmi2SetBoolean(importer.c, null(), 0, null()), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, null_mut()), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut null_mut()), fmi2OK);
        let time = reference::TIME;
        let mut value = f64::NAN;
        assert_eq!(importer.step(0.0, 0.25), fmi2OK);
        assert_eq!(fmi2GetReal(importer.c, &time, 1, &mut value), fmi2OK);
        assert_eq!(value, 0.25, "the independent variable");
    }
}

#[test]
fn a_fixed_parameter_is_not_set_while_stepping() {
    let host = Importer::ready("BeltRig");
    assert_eq!(host.set("mass", 2.0), fmi2Error, "a fixed parameter while stepping");
    assert!(host.one_message().2.contains("mass cannot be set in state StepComplete"));
}

/// Every settable Real of every model: values outside its bound, NaN and infinities are discarded, named, and change
/// nothing; afterwards the instance continues.
#[test]
fn values_outside_their_bounds_are_discarded_by_name() {
    for model in catalogue::models() {
        let importer = Importer::in_state(model.name, State::Initialization);
        for (column, variable) in model.variables() {
            if variable.role == Role::Output || !matches!(variable.kind, Kind::Real(_)) {
                continue;
            }
            let mut refused = vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
            if variable.bound.min() > f64::MIN {
                refused.push(variable.bound.min().next_down());
                refused.push(-1.0);
            }
            if variable.bound.is_positive() {
                refused.push(0.0);
            }
            for value in refused {
                if variable.bound.admits(value) {
                    continue;
                }
                let name = variable.path.to_string();
                let before = importer.get(&name);
                let (references, values) = ([model.reference(column); 2], [before, value]);
                // SAFETY: two references, two values.
                let status = unsafe { fmi2SetReal(importer.c, references.as_ptr(), 2, values.as_ptr()) };
                assert_eq!(status, fmi2Discard, "{} {name} = {value}", model.name);
                let (_, category, text) = importer.one_message();
                assert_eq!(category, "logStatusDiscard");
                let shown = if value.abs() < 1e-5 && value != 0.0 { format!("{value:e}") } else { value.to_string() };
                assert!(text.contains(&format!("{name} = {shown}: must be ")), "{text}");
                assert_eq!(importer.get(&name), before, "{} {name}", model.name);
            }
        }
        // SAFETY: an instance of this test.
        assert_eq!(unsafe { fmi2ExitInitializationMode(importer.c) }, fmi2OK);
    }
}

#[test]
fn outputs_follow_a_set_at_once() {
    let importer = Importer::in_state("BrownMcPhee", State::Initialization);
    for velocity in [1e-3, -1e-3, 0.0] {
        assert_eq!(importer.set("velocity", velocity), fmi2OK);
        let peak = 0.981 * 4f64.tanh() + 0.4905;
        let expected = peak * velocity / 1e-3;
        assert_abs_diff_eq!(importer.get("friction_force"), expected, epsilon = 1e-14);
    }
}

/// Also while stepping, although the standard allows otherwise: an output never belongs to old inputs.
#[test]
fn outputs_follow_a_set_while_stepping() {
    let importer = Importer::ready("BrownMcPhee");
    assert_eq!(importer.set("velocity", 1e-3), fmi2OK);
    assert_eq!(importer.step(0.0, 1e-3), fmi2OK);
    let force = importer.get("friction_force");
    assert_eq!(importer.set("velocity", -1e-3), fmi2OK);
    assert_eq!(importer.get("friction_force"), -force);
}

/// Each is valid alone, but together they are inconsistent: reported when it matters, with both names.
#[test]
fn inconsistent_parameters_are_rejected() {
    let why = "mu_s = 0.05: must be >= mu_k = 0.1";
    let initial = Importer::in_state("LuGre", State::Initialization);
    assert_eq!(initial.set("mu_s", 0.05), fmi2OK);
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2ExitInitializationMode(initial.c) }, fmi2Error);
    assert!(initial.one_message().2.contains(why));
    let running = Importer::ready("LuGre");
    assert_eq!(running.step(0.0, 1e-3), fmi2OK);
    assert_eq!(running.set("mu_s", 0.05), fmi2OK);
    assert_eq!(running.step(1e-3, 1e-3), fmi2Error);
    assert!(running.one_message().2.contains(why));
}

/// A value that is not finite is rejected, but everything else can still be read.
#[test]
fn inputs_can_be_read_where_results_cannot() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.set("velocity", 1e308), fmi2OK);
    assert_eq!(importer.get("velocity"), 1e308);
    // SAFETY: one reference, one value.
    let status = unsafe { fmi2GetReal(importer.c, &importer.vr("friction_force"), 1, &mut 0.0) };
    assert_eq!(status, fmi2Error);
    assert!(importer.one_message().2.contains("the outputs would not be finite at velocity = 1"));
    assert_eq!(importer.get("normal_force"), 9.81);
    assert_eq!(importer.get("friction_force"), 0.0, "after the error the last result, for debugging");
}
