//! Every function in every state, against the tables of the standard, and without an instance.

use std::ptr::{null, null_mut};

use crate::common::NO_EVENT;
use crate::common::importer::Importer;
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role, Variable};
use stribeck::reference::Place;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{ALLOWED, Call, Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// The variable of a value reference.
fn variable_of(model: &ModelType, reference: fmi2ValueReference) -> Option<Variable> {
    match model.place(reference) {
        Some(Place::Column(column)) => Some(model.table.at(column)),
        _ => None,
    }
}

/// Makes the call with valid arguments, if there are any in this state.
fn call(importer: &Importer, purpose: Purpose, call: Call) -> fmi2Status {
    change_of_state(importer, call)
        .or_else(|| on_values(importer, call))
        .or_else(|| on_saved_states(importer, purpose, call))
        .or_else(|| while_stepping(importer, call))
        .or_else(|| of_a_solver(importer, purpose, call))
        .unwrap_or_else(|| panic!("{call:?} is not called"))
}

/// A running instance of the same model, whose states and saved states serve as arguments.
fn donor(importer: &Importer, purpose: Purpose) -> Importer {
    let running = match purpose {
        Purpose::CoSimulation => State::StepComplete,
        Purpose::ModelExchange => State::EventMode,
    };
    Importer::in_state_of(importer.model, purpose, running)
}

fn change_of_state(importer: &Importer, call: Call) -> Option<fmi2Status> {
    let c = importer.c;
    // SAFETY: an instance of this test, or NULL.
    Some(unsafe {
        match call {
            Call::SetDebugLogging => fmi2SetDebugLogging(c, fmi2True, 0, null()),
            Call::SetupExperiment => fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0),
            Call::EnterInitializationMode => {
                if !c.is_null() && importer.one_state_is_set_up() {
                    fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0);
                }
                fmi2EnterInitializationMode(c)
            }
            Call::ExitInitializationMode => fmi2ExitInitializationMode(c),
            Call::Terminate => fmi2Terminate(c),
            Call::Reset => fmi2Reset(c),
            _ => return None,
        }
    })
}

/// Calls with one value each. A model need not have columns of every kind; the arrays are then empty.
fn on_values(importer: &Importer, call: Call) -> Option<fmi2Status> {
    let c = importer.c;
    let order = 1;
    let input = importer.first(|variable| variable.role == Role::Input && matches!(variable.kind, Kind::Real(_)));
    let output = importer.first(|variable| variable.role.is_output() && matches!(variable.kind, Kind::Real(_)));
    let switch = importer.first(|variable| variable.kind == Kind::Boolean);
    let (inputs, outputs, switches) = (input.iter().len(), output.iter().len(), switch.iter().len());
    let (input, output, switch) = (input.unwrap_or_default(), output.unwrap_or_default(), switch.unwrap_or_default());
    let model = catalogue::by_name(importer.model).expect("a model");
    let start = variable_of(model, input).map_or(0.0, |variable| variable.start);
    let (mut value, mut flag) = (0.0, 0);
    // SAFETY: an instance of this test, arrays of at most one element.
    Some(unsafe {
        match call {
            Call::GetReal => fmi2GetReal(c, &output, outputs, &mut value),
            Call::GetInteger => fmi2GetInteger(c, null(), 0, null_mut()),
            Call::GetBoolean => fmi2GetBoolean(c, &switch, switches, &mut flag),
            Call::GetString => fmi2GetString(c, null(), 0, null_mut()),
            Call::SetReal => fmi2SetReal(c, &input, inputs, &start),
            Call::SetInteger => fmi2SetInteger(c, null(), 0, null()),
            Call::SetBoolean => fmi2SetBoolean(c, null(), 0, null()),
            Call::SetString => fmi2SetString(c, null(), 0, null()),
            Call::GetDirectionalDerivative => {
                fmi2GetDirectionalDerivative(c, &output, outputs, &input, inputs, &1.0, &mut value)
            }
            Call::SetRealInputDerivatives => fmi2SetRealInputDerivatives(c, &input, inputs, &order, &value),
            Call::GetRealOutputDerivatives => fmi2GetRealOutputDerivatives(c, &output, outputs, &order, &mut value),
            _ => return None,
        }
    })
}

fn on_saved_states(importer: &Importer, purpose: Purpose, call: Call) -> Option<fmi2Status> {
    let c = importer.c;
    let donor = donor(importer, purpose);
    let mut saved = donor.save();
    let mut bytes = donor.bytes(saved);
    let (mut state, mut size): (fmi2FMUstate, usize) = (null_mut(), 0);
    // SAFETY: an instance of this test, states of its model, each freed once.
    let status = unsafe {
        match call {
            Call::GetFMUstate => Some(fmi2GetFMUstate(c, &mut state)),
            Call::SetFMUstate => Some(fmi2SetFMUstate(c, saved)),
            Call::FreeFMUstate => Some(fmi2FreeFMUstate(c, &mut state)),
            Call::SerializedFMUstateSize => Some(fmi2SerializedFMUstateSize(c, saved, &mut size)),
            Call::SerializeFMUstate => Some(fmi2SerializeFMUstate(c, saved, bytes.as_mut_ptr(), bytes.len())),
            Call::DeSerializeFMUstate => Some(fmi2DeSerializeFMUstate(c, bytes.as_ptr(), bytes.len(), &mut state)),
            _ => None,
        }
    };
    // SAFETY: as above.
    unsafe {
        if !state.is_null() {
            fmi2FreeFMUstate(c, &mut state);
        }
        fmi2FreeFMUstate(donor.c, &mut saved);
    }
    status
}

fn while_stepping(importer: &Importer, call: Call) -> Option<fmi2Status> {
    let c = importer.c;
    let (mut value, mut status, mut flag, mut text) = (0.0, fmi2OK, 0, null());
    // SAFETY: an instance of this test, places for one value.
    Some(unsafe {
        match call {
            Call::DoStep => fmi2DoStep(c, 0.0, 1e-3, fmi2True),
            Call::CancelStep => fmi2CancelStep(c),
            Call::GetStatus => fmi2GetStatus(c, fmi2DoStepStatus, &mut status),
            Call::GetRealStatus => fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &mut value),
            Call::GetIntegerStatus => fmi2GetIntegerStatus(c, fmi2DoStepStatus, &mut flag),
            Call::GetBooleanStatus => fmi2GetBooleanStatus(c, fmi2Terminated, &mut flag),
            Call::GetStringStatus => fmi2GetStringStatus(c, fmi2PendingStatus, &mut text),
            _ => return None,
        }
    })
}

fn of_a_solver(importer: &Importer, purpose: Purpose, call: Call) -> Option<fmi2Status> {
    let c = importer.c;
    let mut event = NO_EVENT;
    let (mut states, mut flag, mut end) = (donor(importer, purpose).states(), 0, 0);
    let count = states.len();
    let mut indicators = vec![0.0; catalogue::by_name(importer.model).expect("a model").event_indicators];
    // SAFETY: an instance of this test, arrays of as many elements as given.
    Some(unsafe {
        match call {
            Call::EnterEventMode => fmi2EnterEventMode(c),
            Call::NewDiscreteStates => fmi2NewDiscreteStates(c, &mut event),
            Call::EnterContinuousTimeMode => fmi2EnterContinuousTimeMode(c),
            Call::CompletedIntegratorStep => fmi2CompletedIntegratorStep(c, fmi2True, &mut flag, &mut end),
            Call::SetTime => fmi2SetTime(c, 1.0),
            Call::SetContinuousStates => fmi2SetContinuousStates(c, states.as_ptr(), count),
            Call::GetDerivatives => fmi2GetDerivatives(c, states.as_mut_ptr(), count),
            Call::GetEventIndicators => fmi2GetEventIndicators(c, indicators.as_mut_ptr(), indicators.len()),
            Call::GetContinuousStates => fmi2GetContinuousStates(c, states.as_mut_ptr(), count),
            Call::GetNominalsOfContinuousStates => fmi2GetNominalsOfContinuousStates(c, states.as_mut_ptr(), count),
            _ => return None,
        }
    })
}

/// The states of the columns of [`CO_SIMULATION`].
const STATES_OF_CO_SIMULATION: [State; 5] =
    [State::Instantiated, State::Initialization, State::StepComplete, State::Terminated, State::Error];

/// The table of FMI 2.0.5 section 4.2.4, typed in from the standard a second time: one letter per state; `d` where the
/// call is allowed but has no result.
const CO_SIMULATION: [(&str, &str); 30] = [
    ("SetDebugLogging", "xxxxx"),
    ("SetupExperiment", "x----"),
    ("EnterInitializationMode", "x----"),
    ("ExitInitializationMode", "-x---"),
    ("Terminate", "--x--"),
    ("Reset", "xxxxx"),
    ("GetReal", "-xxxx"),
    ("GetInteger", "-xxxx"),
    ("GetBoolean", "-xxxx"),
    ("GetString", "-xxxx"),
    ("SetReal", "xxx--"),
    ("SetInteger", "xxx--"),
    ("SetBoolean", "xxx--"),
    ("SetString", "xxx--"),
    ("GetFMUstate", "xxxxx"),
    ("SetFMUstate", "xxxxx"),
    ("FreeFMUstate", "xxxxx"),
    ("SerializedFMUstateSize", "xxxxx"),
    ("SerializeFMUstate", "xxxxx"),
    ("DeSerializeFMUstate", "xxxxx"),
    ("GetDirectionalDerivative", "-xxxx"),
    ("SetRealInputDerivatives", "xxx--"),
    ("GetRealOutputDerivatives", "--xxx"),
    ("DoStep", "--x--"),
    ("CancelStep", "-----"),
    ("GetStatus", "--dd-"),
    ("GetRealStatus", "--xx-"),
    ("GetIntegerStatus", "--dd-"),
    ("GetBooleanStatus", "--xx-"),
    ("GetStringStatus", "--dd-"),
];

/// The states of the columns of [`MODEL_EXCHANGE`].
const STATES_OF_MODEL_EXCHANGE: [State; 6] = [
    State::Instantiated,
    State::Initialization,
    State::EventMode,
    State::ContinuousTimeMode,
    State::Terminated,
    State::Error,
];

/// The table of FMI 2.0.5 section 3.2.3, as [`CO_SIMULATION`].
const MODEL_EXCHANGE: [(&str, &str); 31] = [
    ("SetDebugLogging", "xxxxxx"),
    ("SetupExperiment", "x-----"),
    ("EnterInitializationMode", "x-----"),
    ("ExitInitializationMode", "-x----"),
    ("Terminate", "--xx--"),
    ("Reset", "xxxxxx"),
    ("GetReal", "-xxxxx"),
    ("GetInteger", "-xxxxx"),
    ("GetBoolean", "-xxxxx"),
    ("GetString", "-xxxxx"),
    ("SetReal", "xxxx--"),
    ("SetInteger", "xxx---"),
    ("SetBoolean", "xxx---"),
    ("SetString", "xxx---"),
    ("GetFMUstate", "xxxxxx"),
    ("SetFMUstate", "xxxxxx"),
    ("FreeFMUstate", "xxxxxx"),
    ("SerializedFMUstateSize", "xxxxxx"),
    ("SerializeFMUstate", "xxxxxx"),
    ("DeSerializeFMUstate", "xxxxxx"),
    ("GetDirectionalDerivative", "-xxxxx"),
    ("EnterEventMode", "--xx--"),
    ("NewDiscreteStates", "--x---"),
    ("EnterContinuousTimeMode", "--x---"),
    ("CompletedIntegratorStep", "---x--"),
    ("SetTime", "--xx--"),
    ("SetContinuousStates", "---x--"),
    ("GetDerivatives", "-xxxxx"),
    ("GetEventIndicators", "-xxxxx"),
    ("GetContinuousStates", "-xxxxx"),
    ("GetNominalsOfContinuousStates", "xxxxxx"),
];

/// Calls each function in each state of a model; returns the number of calls. A function that is not in the table is
/// not available on such an instance, whatever its state.
fn every_function_answers(model: &'static str, purpose: Purpose, states: &[State], standard: &[(&str, &str)]) -> usize {
    for (found, ..) in ALLOWED {
        let function = format!("{found:?}");
        let row = standard.iter().find(|(name, _)| *name == function).map(|(_, row)| *row);
        for (at, state) in states.iter().enumerate() {
            let importer = Importer::in_state_of(model, purpose, *state);
            let expected = match row.map(|row| row.as_bytes()[at]) {
                Some(b'x') => fmi2OK,
                Some(b'd') => fmi2Discard,
                _ => fmi2Error,
            };
            let answer = call(&importer, purpose, found);
            assert_eq!(answer, expected, "fmi2{function} of {model} in {state:?} for {purpose:?}");
            if expected != fmi2OK {
                let (status, category, text) = importer.one_message();
                assert_eq!(status, expected);
                assert!(category.starts_with("logStatus") && text.contains(&function), "{category}: {text}");
            }
        }
    }
    let is_known = |name: &str| ALLOWED.iter().any(|(call, ..)| format!("{call:?}") == name);
    assert!(standard.iter().all(|(name, row)| is_known(name) && row.len() == states.len()));
    ALLOWED.len() * states.len()
}

#[test]
fn every_function_in_every_state_has_the_status_of_the_standard() {
    let mut calls = 0;
    for model in catalogue::models() {
        let name = model.name;
        calls += every_function_answers(name, Purpose::CoSimulation, &STATES_OF_CO_SIMULATION, &CO_SIMULATION);
        if model.model_exchange {
            calls += every_function_answers(name, Purpose::ModelExchange, &STATES_OF_MODEL_EXCHANGE, &MODEL_EXCHANGE);
        }
    }
    println!(
        "figure: {calls} calls, one of each function in each state of each model, for each purpose that it serves"
    );
}

#[test]
fn null_components_are_errors() {
    for (function, ..) in ALLOWED {
        let nobody = Importer { c: null_mut(), model: "LuGre", heard: Box::default() };
        for purpose in [Purpose::CoSimulation, Purpose::ModelExchange] {
            assert_eq!(call(&nobody, purpose, function), fmi2Error, "fmi2{function:?}");
        }
    }
    // Memory that is not an instance is rejected too, as long as it is readable.
    let mut other = [0u64; 64];
    // SAFETY: readable and writable memory, large enough to be checked.
    assert_eq!(unsafe { fmi2Reset(other.as_mut_ptr().cast()) }, fmi2Error);
}
