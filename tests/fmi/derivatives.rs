//! Slopes of inputs and outputs, derivatives of states and in directions.

use crate::common::NO_EVENT;
use crate::common::importer::Importer;
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role};
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// Input slopes are used for one step; output derivatives of order 1 are compared with differences of outputs.
#[test]
fn slopes_of_inputs_and_outputs() {
    let importer = Importer::ready("LuGre");
    let (velocity, force) = (importer.vr("velocity"), importer.vr("friction_force"));
    let derivative = |order: fmi2Integer| {
        let mut value = f64::NAN;
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi2GetRealOutputDerivatives(importer.c, &force, 1, &order, &mut value) }, fmi2OK);
        value
    };
    let mut t = 0.0;
    let mut ramp = |h: f64| {
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi2SetRealInputDerivatives(importer.c, &velocity, 1, &1, &0.3) }, fmi2OK);
        assert_eq!(importer.step(t, h), fmi2OK);
        t += h;
        (importer.get("friction_force"), derivative(1))
    };
    ramp(2e-3);
    assert!((importer.get("velocity") - 6e-4).abs() < 1e-18, "the input has moved to the end of its ramp");
    let h = 1e-6;
    let [(before, _), (_, exact), (after, _)] = [ramp(h), ramp(h), ramp(h)];
    let difference = (after - before) / (2.0 * h);
    assert!((exact / difference - 1.0).abs() < 1e-4, "{exact} against {difference}");
    assert_eq!(derivative(2), 0.0, "higher orders are 0");
    let velocity = importer.get("velocity");
    let mut saved = importer.save();
    assert_eq!(importer.step(t, h), fmi2OK);
    assert_eq!(importer.get("velocity"), velocity, "a slope serves one step");
    let held = derivative(1);
    assert!((held - exact).abs() > 0.1 * exact.abs(), "the old slope is no longer in it");
    // SAFETY: a state of this instance, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
    }
    assert_eq!(importer.step(t, h), fmi2OK);
    assert_eq!((importer.get("velocity"), derivative(1)), (velocity, held), "nor after a restored state");
}

/// A slope or a state that is not finite is discarded, and the run continues; so is a ramp that would overflow.
#[test]
fn slopes_and_states_must_be_finite() {
    let stepping = Importer::ready("LuGre");
    let integrating = Importer::in_state_of("LuGre", Purpose::ModelExchange, State::ContinuousTimeMode);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        // SAFETY: arrays of the length given.
        unsafe {
            let velocity = stepping.vr("velocity");
            assert_eq!(fmi2SetRealInputDerivatives(stepping.c, &velocity, 1, &1, &value), fmi2Discard);
            assert!(stepping.one_message().2.contains("derivative of velocity = "));
            let mut states = vec![0.0; catalogue::by_name("LuGre").expect("a law").continuous_states().count()];
            assert_eq!(fmi2GetContinuousStates(integrating.c, states.as_mut_ptr(), states.len()), fmi2OK);
            let before = states.clone();
            states[0] = value;
            assert_eq!(fmi2SetContinuousStates(integrating.c, states.as_ptr(), states.len()), fmi2Discard);
            assert!(integrating.one_message().2.contains("x[0] = "));
            assert_eq!(fmi2GetContinuousStates(integrating.c, states.as_mut_ptr(), states.len()), fmi2OK);
            assert_eq!(states, before);
        }
    }
    assert_eq!(stepping.step(0.0, 1e-3), fmi2OK);
    assert_eq!(stepping.get("velocity"), 0.0, "no slope was accepted");
}

/// Time derivatives of states are unknowns too; computed variables are not knowns.
#[test]
fn directional_derivatives_of_time_derivatives() {
    let importer = Importer::in_state_of("Dahl", Purpose::ModelExchange, State::EventMode);
    let model = catalogue::by_name("Dahl").expect("a law");
    let velocity = importer.vr("velocity");
    assert_eq!(importer.set("velocity", 2e-3), fmi2OK);
    for rate in model.derivative_references() {
        let at = |value: f64| {
            assert_eq!(importer.set("velocity", value), fmi2OK);
            let mut found = f64::NAN;
            // SAFETY: one reference, one value.
            assert_eq!(unsafe { fmi2GetReal(importer.c, &rate, 1, &mut found) }, fmi2OK);
            found
        };
        let h = 1e-7;
        let difference = (at(2e-3 + h) - at(2e-3 - h)) / (2.0 * h);
        at(2e-3);
        let mut exact = f64::NAN;
        // SAFETY: one unknown, one known.
        unsafe {
            assert_eq!(fmi2GetDirectionalDerivative(importer.c, &rate, 1, &velocity, 1, &1.0, &mut exact), fmi2OK);
        }
        assert!((exact - difference).abs() <= 1e-6 * difference.abs() + 1e-9, "{exact} against {difference}");
    }
    let force = importer.vr("friction_force");
    // SAFETY: one unknown, one known.
    let status = unsafe { fmi2GetDirectionalDerivative(importer.c, &force, 1, &force, 1, &1.0, &mut 0.0) };
    assert_eq!(status, fmi2Error);
    assert!(importer.one_message().2.contains("friction_force is computed"));
}

/// The derivatives of every model are those of its own steps, and are also variables.
#[test]
fn derivatives_are_the_changes_over_short_steps() {
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let integrating = Importer::in_state_of(model.name, Purpose::ModelExchange, State::EventMode);
        let states: Vec<usize> = model.continuous_states().collect();
        let mut row: Vec<f64> = model.table.iter().map(|variable| variable.start).collect();
        assert!(model.at_event(&mut row), "{}", model.name);
        let mut x = vec![f64::NAN; states.len()];
        for (column, variable) in model.table.iter().enumerate() {
            if variable.role == Role::Input && matches!(variable.kind, Kind::Real(_)) {
                row[column] += if variable.bound.admits(-1.0) { 1.3e-3 } else { 0.02 };
                // SAFETY: one reference, one value.
                assert_eq!(unsafe { fmi2SetReal(integrating.c, &model.reference(column), 1, &row[column]) }, fmi2OK);
            }
        }
        let (c, n) = (integrating.c, states.len());
        let (mut rates, mut variables, mut event) = (x.clone(), x.clone(), NO_EVENT);
        let references: Vec<u32> = model.derivative_references().collect();
        // SAFETY: arrays of the number of states.
        unsafe {
            assert_eq!(fmi2NewDiscreteStates(c, &mut event), fmi2OK);
            assert_eq!(fmi2EnterContinuousTimeMode(c), fmi2OK);
            assert_eq!(fmi2GetContinuousStates(c, x.as_mut_ptr(), n), fmi2OK);
            assert_eq!(fmi2GetDerivatives(c, rates.as_mut_ptr(), n), fmi2OK);
            assert_eq!(fmi2GetReal(c, references.as_ptr(), n, variables.as_mut_ptr()), fmi2OK);
            assert_eq!(fmi2SetContinuousStates(c, x.as_ptr(), n + 1), fmi2Error, "{}: one too many", model.name);
        }
        assert_eq!(rates, variables, "{}", model.name);
        assert!(model.at_event(&mut row), "{}", model.name);
        assert!(states.iter().zip(&x).all(|(state, value)| row[*state] == *value), "{}", model.name);
        assert_are_changes(model, row, &states, &rates);
    }
}

/// These rates of the states are the changes over a step of 1 ns.
fn assert_are_changes(model: &ModelType, mut row: Vec<f64>, states: &[usize], rates: &[f64]) {
    let begin = row.clone();
    let dt = 1e-9;
    assert!(model.advance(&mut row, dt), "{}", model.name);
    for (state, rate) in states.iter().zip(rates) {
        let change = (row[*state] - begin[*state]) / dt;
        let rounding = 4.0 * f64::EPSILON * begin[*state].abs() / dt;
        let (name, nominal) = (model.table.at(*state).path.to_string(), model.table.at(*state).nominal);
        // Without a stiffness in series the piston follows the strut at once, and its state has no meaning.
        if name == "piston_velocity" {
            continue;
        }
        // The second order of a step of 1 ns is a millionth of the usual size per second at most.
        assert!(
            (change - rate).abs() <= 1e-4 * rate.abs() + rounding + 1e-6 * nominal,
            "{} {name}: {change} {rate}",
            model.name
        );
    }
}
