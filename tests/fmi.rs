//! The FMI 2.0 functions from an importer's point of view: state machine, misuse, messages, snapshots, derivatives.

mod common;

use std::ffi::CStr;
use std::ops::Range;
use std::ptr::{null, null_mut};
use std::thread;

use common::NO_EVENT;
use common::importer::{Heard, Importer, NAME, callbacks, guid};
use common::random::Random;
use stribeck::c_api::stribeck_status::*;
use stribeck::c_api::*;
use stribeck::catalogue;
use stribeck::fmi2::exchange::*;
use stribeck::fmi2::lifecycle::{ALLOWED, Call, Purpose, State};
use stribeck::fmi2::setup::*;
use stribeck::fmi2::snapshot::*;
use stribeck::fmi2::step::*;
use stribeck::fmi2::types::fmi2Status::*;
use stribeck::fmi2::types::*;
use stribeck::fmi2::values::*;
use stribeck::model::{Kind, ModelType, Role, Variable};
use stribeck::reference::{self, Place};

/// The variable of a value reference.
fn variable_of(model: &ModelType, reference: fmi2ValueReference) -> Option<&'static Variable> {
    match model.place(reference) {
        Some(Place::Column(column)) => Some(&model.table[column]),
        _ => None,
    }
}

/// Makes the call with valid arguments, if there are any in this state.
fn call(importer: &Importer, purpose: Purpose, call: Call) -> fmi2Status {
    let c = importer.c;
    let order = 1;
    // A model need not have columns of every kind; the arrays are then empty.
    let input = importer.first(|variable| variable.role == Role::Input && matches!(variable.kind, Kind::Real(_)));
    let output = importer.first(|variable| variable.role.is_output() && matches!(variable.kind, Kind::Real(_)));
    let switch = importer.first(|variable| variable.kind == Kind::Boolean);
    let (inputs, outputs, switches) = (input.iter().len(), output.iter().len(), switch.iter().len());
    let (input, output, switch) = (input.unwrap_or_default(), output.unwrap_or_default(), switch.unwrap_or_default());
    let model = catalogue::by_name(importer.model).expect("a model");
    let start = variable_of(model, input).map_or(0.0, |variable| variable.start);
    let (mut value, mut size, mut status, mut flag, mut text) = (0.0, 0, fmi2OK, 0, null());
    let mut state: fmi2FMUstate = null_mut();
    let mut event = NO_EVENT;
    // A state of another instance, so that the calls on states have something to work on.
    let running = match purpose {
        Purpose::CoSimulation => State::StepComplete,
        Purpose::ModelExchange => State::EventMode,
    };
    let donor = Importer::in_state_of(importer.model, purpose, running);
    let (mut states, mut end) = (donor.states(), 0);
    let count = states.len();
    let mut indicators = vec![0.0; model.event_indicators];
    let saved = donor.save();
    let mut bytes = donor.bytes(saved);
    // SAFETY: an instance of this test, arrays of one element.
    let result = unsafe {
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
            Call::GetReal => fmi2GetReal(c, &output, outputs, &mut value),
            Call::GetInteger => fmi2GetInteger(c, null(), 0, null_mut()),
            Call::GetBoolean => fmi2GetBoolean(c, &switch, switches, &mut flag),
            Call::GetString => fmi2GetString(c, null(), 0, null_mut()),
            Call::SetReal => fmi2SetReal(c, &input, inputs, &start),
            Call::SetInteger => fmi2SetInteger(c, null(), 0, null()),
            Call::SetBoolean => fmi2SetBoolean(c, null(), 0, null()),
            Call::SetString => fmi2SetString(c, null(), 0, null()),
            Call::GetFMUstate => {
                let status = fmi2GetFMUstate(c, &mut state);
                fmi2FreeFMUstate(c, &mut state);
                status
            }
            Call::SetFMUstate => fmi2SetFMUstate(c, saved),
            Call::FreeFMUstate => fmi2FreeFMUstate(c, &mut state),
            Call::SerializedFMUstateSize => fmi2SerializedFMUstateSize(c, saved, &mut size),
            Call::SerializeFMUstate => fmi2SerializeFMUstate(c, saved, bytes.as_mut_ptr(), bytes.len()),
            Call::DeSerializeFMUstate => {
                let status = fmi2DeSerializeFMUstate(c, bytes.as_ptr(), bytes.len(), &mut state);
                fmi2FreeFMUstate(c, &mut state);
                status
            }
            Call::GetDirectionalDerivative => {
                fmi2GetDirectionalDerivative(c, &output, outputs, &input, inputs, &1.0, &mut value)
            }
            Call::SetRealInputDerivatives => fmi2SetRealInputDerivatives(c, &input, inputs, &order, &value),
            Call::GetRealOutputDerivatives => fmi2GetRealOutputDerivatives(c, &output, outputs, &order, &mut value),
            Call::DoStep => fmi2DoStep(c, 0.0, 1e-3, fmi2True),
            Call::CancelStep => fmi2CancelStep(c),
            Call::GetStatus => fmi2GetStatus(c, fmi2DoStepStatus, &mut status),
            Call::GetRealStatus => fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &mut value),
            Call::GetIntegerStatus => fmi2GetIntegerStatus(c, fmi2DoStepStatus, &mut flag),
            Call::GetBooleanStatus => fmi2GetBooleanStatus(c, fmi2Terminated, &mut flag),
            Call::GetStringStatus => fmi2GetStringStatus(c, fmi2PendingStatus, &mut text),
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
        }
    };
    let mut saved = saved;
    // SAFETY: freed once.
    unsafe { fmi2FreeFMUstate(donor.c, &mut saved) };
    result
}

impl Importer {
    /// The first variable of this kind.
    fn first(&self, is_wanted: impl Fn(&Variable) -> bool) -> Option<fmi2ValueReference> {
        let model = catalogue::by_name(self.model)?;
        model.variables().find(|(_, variable)| is_wanted(variable)).map(|(column, _)| model.reference(column))
    }

    /// The continuous states, of an instance for Model Exchange.
    fn states(&self) -> Vec<f64> {
        let model = catalogue::by_name(self.model).expect("a model");
        model.continuous_states().map(|column| model.table[column].start).collect()
    }

    /// fmi2EnterInitializationMode needs an experiment; in the state Instantiated the matrix sets one up.
    fn one_state_is_set_up(&self) -> bool {
        let mut state = self.save();
        let bytes = self.bytes(state);
        // SAFETY: a state of this instance, freed once.
        assert_eq!(unsafe { fmi2FreeFMUstate(self.c, &mut state) }, fmi2OK);
        // The first number behind head (50 bytes) and the three of the instance is the state.
        let number: Vec<u8> = bytes[50 + 24..50 + 32].iter().map(|byte| *byte as u8).collect();
        f64::from_le_bytes(number.try_into().expect("eight bytes")) == 0.0
    }
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
fn instantiation_rejects_what_it_cannot_serve() {
    let heard = Heard::default();
    let callbacks = callbacks(&heard);
    let (guid, bristle) = (guid("LuGre"), guid("Bristle"));
    let make = |name: fmi2String, kind, guid: fmi2String, callbacks: *const fmi2CallbackFunctions| {
        // SAFETY: valid texts and callbacks, or NULL.
        unsafe { fmi2Instantiate(name, kind, guid, null(), callbacks, fmi2False, fmi2False) }
    };
    let name = c"a".as_ptr();
    for (what, name, kind, guid) in [
        ("guid", name, fmi2CoSimulation, c"{00000000-0000-0000-0000-000000000000}".as_ptr()),
        ("fmuGUID is NULL", name, fmi2CoSimulation, null()),
        ("instanceName is NULL or blank", null(), fmi2CoSimulation, guid.as_ptr()),
        ("instanceName is NULL or blank", c" \t".as_ptr(), fmi2CoSimulation, guid.as_ptr()),
        ("fmuType is 0: Bristle has states that no solver", name, fmi2ModelExchange, bristle.as_ptr()),
        ("fmuType is 2: must be 0 (Model Exchange) or 1", name, 2, guid.as_ptr()),
    ] {
        let c = make(name, kind, guid, &callbacks);
        assert!(c.is_null(), "{what}");
        let (status, category, text) = heard.lock().expect("one thread").pop().expect("a message");
        assert_eq!((status, &*category), (fmi2Error, "logStatusError"));
        assert!(text.contains(what), "{text}");
    }
    assert!(make(name, fmi2CoSimulation, guid.as_ptr(), null()).is_null());
    // SAFETY: NULL is ignored.
    unsafe { fmi2FreeInstance(null_mut()) };
}

/// Texts of the importer are only valid during the call.
#[test]
fn the_name_of_an_instance_is_copied() {
    let heard = Heard::default();
    let callbacks = callbacks(&heard);
    let mut name = *b"first\0";
    // SAFETY: valid texts and callbacks; the instance is freed once.
    unsafe {
        let guid = guid("LuGre");
        let c = fmi2Instantiate(name.as_ptr().cast(), 1, guid.as_ptr(), null(), &callbacks, fmi2False, fmi2True);
        name.copy_from_slice(b"other\0");
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(NAME.take(), "first");
        fmi2FreeInstance(c);
    }
}

/// The struct of callbacks is only valid during fmi2Instantiate, and all its pointers may be NULL.
#[test]
fn callbacks_are_copied_and_optional() {
    let heard = Heard::default();
    let mut callbacks = callbacks(&heard);
    // SAFETY: valid texts and callbacks; the instance is freed once.
    unsafe {
        let name = c"a".as_ptr();
        let make = |callbacks: *const fmi2CallbackFunctions| {
            fmi2Instantiate(name, fmi2CoSimulation, guid("Dahl").as_ptr(), null(), callbacks, fmi2False, fmi2True)
        };
        let c = make(&callbacks);
        callbacks.logger = None;
        callbacks.componentEnvironment = null_mut();
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(heard.lock().expect("one thread").len(), 1);
        fmi2FreeInstance(c);
        let silent = make(&callbacks);
        assert_eq!(fmi2Terminate(silent), fmi2Error);
        fmi2FreeInstance(silent);
    }
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

#[test]
fn experiments_that_make_no_sense_are_rejected() {
    let cases = [
        (fmi2False, 0.0, 1.0, fmi2True, 0.5, "stopTime = 0.5: must be finite and >= startTime = 1"),
        (fmi2False, 0.0, f64::NAN, fmi2False, 0.0, "startTime = NaN"),
        (fmi2False, 0.0, 0.0, fmi2True, f64::INFINITY, "stopTime = inf"),
        (fmi2True, 0.0, 0.0, fmi2False, 0.0, "tolerance = 0"),
        (fmi2True, f64::NAN, 0.0, fmi2False, 0.0, "tolerance = NaN"),
        (fmi2True, f64::INFINITY, 0.0, fmi2False, 0.0, "tolerance = inf"),
    ];
    for (has_tolerance, tolerance, start, has_stop, stop, why) in cases {
        let importer = Importer::new("LuGre");
        // SAFETY: an instance of this test.
        let status = unsafe { fmi2SetupExperiment(importer.c, has_tolerance, tolerance, start, has_stop, stop) };
        assert_eq!(status, fmi2Error, "{why}");
        assert!(importer.one_message().2.contains(why));
    }
    let importer = Importer::new("LuGre");
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2EnterInitializationMode(importer.c) }, fmi2Error);
    assert!(importer.one_message().2.contains("fmi2SetupExperiment must be called first"));
}

#[test]
fn steps_that_make_no_sense_are_rejected() {
    for (t, h) in [
        (0.0, 0.0),
        (0.0, -1e-3),
        (0.0, f64::NAN),
        (0.0, f64::INFINITY),
        (f64::NAN, 1e-3),
        (f64::INFINITY, 1e-3),
        (5e-3, 1e-3),
        (-1e-3, 1e-3),
        (0.0, 100.1),
    ] {
        let importer = Importer::ready("LuGre");
        assert_eq!(importer.step(t, h), fmi2Error, "{t} {h}");
        importer.one_message();
        assert_eq!(importer.step(0.0, 1e-3), fmi2Error, "after an error");
    }
    let endless = Importer::new("LuGre");
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi2SetupExperiment(endless.c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(endless.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(endless.c), fmi2OK);
    }
    assert_eq!(endless.step(0.0, f64::INFINITY), fmi2Error, "an infinite step without a stop time");
}

/// Masters accumulate the time, multiply it, count nanoseconds, or make one tiny step at the end.
#[test]
fn communication_points_are_compared_with_a_relative_tolerance() {
    let h = 1e-3;
    let accumulated = Importer::ready("LuGre");
    let mut t = 0.0;
    for _ in 0..90_000 {
        assert_eq!(accumulated.step(t, h), fmi2OK);
        t += h;
    }
    let computed = Importer::ready("LuGre");
    for k in 0..90_000 {
        assert_eq!(computed.step(f64::from(k) * h, h), fmi2OK);
    }
    let counted = Importer::ready("LuGre");
    for k in 0..90_000i64 {
        let (t, next) = ((k * 1_000_000) as f64 * 1e-9, ((k + 1) * 1_000_000) as f64 * 1e-9);
        assert_eq!(counted.step(t, next - t), fmi2OK);
    }
    let ulp = Importer::ready("LuGre");
    let mut t: f64 = 0.0;
    for k in 0..90_000 {
        let t_off = if k % 2 == 0 { t.next_up() } else { t.next_down() };
        assert_eq!(ulp.step(t_off, h), fmi2OK);
        t = t_off + h;
    }
    assert_eq!(computed.step(90.0, 10.0 - 2e-13), fmi2OK);
    assert_eq!(computed.step(100.0 - 2e-13, 2e-13), fmi2OK, "a last step of 2e-13 s");
    assert_eq!(computed.step(100.0, 1e-3), fmi2Error, "past the stop time");
}

/// Equal steps give equal results, however a master computes the time, even with rounding errors.
#[test]
fn results_do_not_depend_on_how_the_time_is_computed() {
    let h = 1e-3;
    let mut accumulated = vec![0.0];
    (0..500).for_each(|k| accumulated.push(accumulated[k] + h));
    assert_ne!(accumulated[500], 500.0 * h, "accumulated rounding errors");
    for model in catalogue::models() {
        let run = |time: &dyn Fn(i32) -> f64| drive(&Importer::ready(model.name), 0..500, h, time);
        let computed = run(&millisecond);
        let clocks: [(&str, &dyn Fn(i32) -> f64); 3] = [
            ("accumulated", &|k| accumulated[k as usize]),
            ("an ulp late", &|k| millisecond(k).next_up()),
            ("an ulp early", &|k| if k == 0 { 0.0 } else { millisecond(k).next_down() }),
        ];
        for (which, clock) in clocks {
            assert_eq!(run(clock), computed, "{} with time {which}", model.name);
        }
    }
}

#[test]
fn wrong_references_pointers_and_types_are_errors() {
    let too_far = 10_000;
    // SAFETY: arrays of one element, or NULL where the library must notice.
    unsafe {
        let check = |what: &str, wrong: &dyn Fn(&Importer) -> fmi2Status| {
            let importer = Importer::ready("LuGre");
            assert_eq!(wrong(&importer), fmi2Error, "{what}");
            importer.one_message();
        };
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
fn messages_can_be_switched_by_category_and_keep_percent_signs() {
    let importer = Importer::ready("LuGre");
    let switch = |category: &CStr, on| {
        // SAFETY: one category.
        assert_eq!(unsafe { fmi2SetDebugLogging(importer.c, on, 1, &category.as_ptr()) }, fmi2OK);
    };
    switch(c"logStatusDiscard", fmi2False);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    assert!(importer.heard.lock().expect("one thread").is_empty());
    switch(c"logAll", fmi2True);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    importer.one_message();
    switch(c"logStatusError", fmi2False);
    assert_eq!(importer.set("normal_force", -1.0), fmi2Discard);
    importer.one_message();
    let silent = Importer::in_state("LuGre", State::StepComplete);
    // SAFETY: one category.
    assert_eq!(unsafe { fmi2SetDebugLogging(silent.c, fmi2False, 1, &c"logStatusError".as_ptr()) }, fmi2OK);
    assert_eq!(silent.step(0.0, -1.0), fmi2Error);
    assert!(silent.heard.lock().expect("one thread").is_empty());
    switch(c"logStatusError", fmi2True);
    // SAFETY: one category.
    assert_eq!(unsafe { fmi2SetDebugLogging(importer.c, fmi2True, 1, &c"100%s#".as_ptr()) }, fmi2Error);
    assert!(importer.one_message().2.contains("unknown log category 100%s##"));
}

#[test]
fn outputs_follow_a_set_at_once() {
    let importer = Importer::in_state("BrownMcPhee", State::Initialization);
    for velocity in [1e-3, -1e-3, 0.0] {
        assert_eq!(importer.set("velocity", velocity), fmi2OK);
        let peak = 0.981 * 4f64.tanh() + 0.4905;
        let expected = peak * velocity / 1e-3;
        assert!((importer.get("friction_force") - expected).abs() < 1e-14);
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

#[test]
fn a_ramp_out_of_a_bound_is_rejected_and_one_onto_it_is_not() {
    let importer = Importer::ready("LuGre");
    let slope = |value: f64| {
        // SAFETY: one reference, one value.
        let status = unsafe { fmi2SetRealInputDerivatives(importer.c, &importer.vr("normal_force"), 1, &1, &value) };
        assert_eq!(status, fmi2OK);
    };
    let (mut t, mut random) = (0.0, Random(1));
    for _ in 0..500 {
        let (load, h) = (16.0 * random.next() + 1e-3, (1000.0 * random.next()).ceil() / 30_000.0);
        assert_eq!(importer.set("normal_force", load), fmi2OK);
        slope(-load / h);
        assert_eq!(importer.step(t, h), fmi2OK, "{load} N to 0 in {h} s");
        assert!(importer.get("normal_force") < 1e-12);
        t += h;
    }
    assert_eq!(importer.set("normal_force", 1.0), fmi2OK);
    slope(-1001.0);
    assert_eq!(importer.step(t, 1e-3), fmi2Error);
    assert!(importer.one_message().2.contains("at the end of its ramp normal_force = -0.001"));
}

#[test]
fn the_clock_is_the_masters() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.step(0.0, 0.1), fmi2OK);
    let t = 0.1f64.next_up();
    assert_eq!(importer.step(t, 0.2), fmi2OK);
    let mut time = f64::NAN;
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi2GetRealStatus(importer.c, fmi2LastSuccessfulTime, &mut time) }, fmi2OK);
    assert_eq!(time, t + 0.2);
    // A repeated or skipped step is detected however small it is.
    let tiny = Importer::ready("LuGre");
    assert_eq!(tiny.step(0.0, 99.0), fmi2OK);
    assert_eq!(tiny.step(99.0, 1e-6), fmi2OK);
    assert_eq!(tiny.step(99.0, 1e-6), fmi2Error);
}

/// Found by fuzzing: without a stop time, two steps of the longest length led to an infinite time.
#[test]
fn time_stays_finite() {
    let importer = Importer::new("EndStops");
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi2SetupExperiment(importer.c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(importer.c), fmi2OK);
    }
    assert_eq!(importer.step(0.0, f64::MAX), fmi2OK);
    assert_eq!(importer.step(f64::MAX, f64::MAX), fmi2Error);
    assert!(importer.one_message().2.contains("to inf s passes the stop time"));
}

/// A saved state includes its experiment, and can be overwritten by a later one.
#[test]
fn a_state_holds_the_experiment_and_can_be_overwritten() {
    let importer = Importer::ready("LuGre");
    let mut saved = importer.save();
    assert_eq!(importer.set("velocity", 2e-3), fmi2OK);
    assert_eq!(importer.step(0.0, 0.01), fmi2OK);
    let deflection = importer.get("bristle_deflection");
    // SAFETY: an instance and a state of this test; the state is freed once.
    unsafe {
        assert_eq!(fmi2GetFMUstate(importer.c, &mut saved), fmi2OK);
        assert_eq!(fmi2Reset(importer.c), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2Error, "a reset forgets the experiment");
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.get("bristle_deflection"), deflection);
        assert_eq!(importer.step(0.01, 50.0), fmi2OK);
        assert_eq!(importer.step(50.01, 50.0), fmi2Error, "the stop time 100 s was restored");
        let earlier = Importer::ready("LuGre");
        let mut first = earlier.save();
        let bytes = earlier.bytes(first);
        assert_eq!(fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr(), bytes.len(), &mut saved), fmi2OK);
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.get("bristle_deflection"), 0.0, "read into the existing state");
        assert_eq!(fmi2FreeFMUstate(earlier.c, &mut first), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
    }
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

#[test]
fn an_error_is_left_by_reset_or_by_a_saved_state() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.set("velocity", 1e-3), fmi2OK);
    assert_eq!(importer.step(0.0, 0.01), fmi2OK);
    let force = importer.get("friction_force");
    let mut saved = importer.save();
    assert_eq!(importer.step(0.01, -1.0), fmi2Error);
    assert_eq!(importer.step(0.01, 0.01), fmi2Error);
    assert_eq!(importer.get("friction_force"), force, "values can be read for debugging");
    // SAFETY: a state of this instance, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
        assert_eq!(importer.step(0.01, 0.01), fmi2OK, "time is part of the state");
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
        assert!(saved.is_null());
        assert_eq!(importer.step(0.5, 0.01), fmi2Error);
        assert_eq!(fmi2Reset(importer.c), fmi2OK);
        assert_eq!(fmi2SetupExperiment(importer.c, fmi2False, 0.0, 7.0, fmi2False, 0.0), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(importer.c), fmi2OK);
        assert_eq!(fmi2ExitInitializationMode(importer.c), fmi2OK);
    }
    assert_eq!((importer.get("velocity"), importer.get("bristle_deflection")), (0.0, 0.0));
    assert_eq!(importer.step(7.0, 200.0), fmi2OK, "the old stop time no longer holds");
}

/// Makes steps of `h` with inputs that depend only on the number of the step, each at the time that `time` gives for
/// its number, and returns the bits of all readable values after each of them.
fn drive(importer: &Importer, steps: Range<i32>, h: f64, time: impl Fn(i32) -> f64) -> Vec<u64> {
    let model = catalogue::by_name(importer.model).expect("a model");
    let reals = |role: fn(Role) -> bool| {
        let table = model.table.iter().enumerate();
        table.filter(move |(_, variable)| role(variable.role) && matches!(variable.kind, Kind::Real(_)))
    };
    let outputs: Vec<u32> = reals(Role::is_output).map(|(column, _)| model.reference(column)).collect();
    let mut values = vec![f64::NAN; outputs.len()];
    let mut bits = Vec::new();
    for k in steps {
        for (column, variable) in reals(|role| role == Role::Input) {
            let swing = if variable.bound.admits(-1.0) { f64::from(k).sin() } else { 1.0 };
            let value = variable.start + 0.01 * swing;
            // SAFETY: one reference, one value.
            assert_eq!(unsafe { fmi2SetReal(importer.c, &model.reference(column), 1, &value) }, fmi2OK);
        }
        assert_eq!(importer.step(time(k), h), fmi2OK, "{} in step {k}", importer.model);
        // SAFETY: as many references as values.
        let status = unsafe { fmi2GetReal(importer.c, outputs.as_ptr(), outputs.len(), values.as_mut_ptr()) };
        assert_eq!(status, fmi2OK, "{}", importer.model);
        bits.extend(values.iter().map(|value| value.to_bits()));
    }
    bits
}

/// The time of a step of 1 ms.
fn millisecond(k: i32) -> f64 {
    f64::from(k) * 1e-3
}

/// Save, 1000 steps, restore, 1000 steps: the same bits, also through bytes and in another instance.
#[test]
fn a_restored_state_has_the_same_future() {
    for model in catalogue::models() {
        let drive = |importer: &Importer, from| drive(importer, from..from + 1000, 1e-3, millisecond);
        let importer = Importer::ready(model.name);
        drive(&importer, 0);
        let mut saved = importer.save();
        let bytes = importer.bytes(saved);
        let future = drive(&importer, 1000);
        // SAFETY: states of this test, freed once.
        unsafe {
            assert_eq!(fmi2SetFMUstate(importer.c, saved), fmi2OK);
            assert_eq!(drive(&importer, 1000), future, "{}", model.name);

            let other = Importer::new(model.name);
            let mut read = null_mut();
            assert_eq!(fmi2DeSerializeFMUstate(other.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2OK);
            assert_eq!(fmi2SetFMUstate(other.c, read), fmi2OK, "an instance restores state and lifecycle");
            assert_eq!(drive(&other, 1000), future, "{} in another instance", model.name);
            assert_eq!(fmi2SetFMUstate(other.c, saved), fmi2OK);
            assert_eq!(other.bytes(read), bytes, "equal states give equal bytes");

            let mut garbage = vec![0x55; bytes.len()];
            assert_eq!(fmi2DeSerializeFMUstate(other.c, garbage.as_ptr(), garbage.len(), &mut read), fmi2Error);
            garbage.copy_from_slice(&bytes);
            garbage[60] ^= 1;
            assert_eq!(fmi2DeSerializeFMUstate(other.c, garbage.as_ptr(), garbage.len(), &mut read), fmi2Error);
            assert_eq!(fmi2FreeFMUstate(other.c, &mut read), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
        }
    }
}

/// A state saved by one thread is restored by another, in its own instance, and freed there.
#[test]
fn a_saved_state_continues_in_another_thread() {
    struct Carried(fmi2FMUstate);
    // SAFETY: a saved state belongs to no thread.
    unsafe impl Send for Carried {}
    for model in catalogue::models() {
        let importer = Importer::ready(model.name);
        drive(&importer, 0..100, 1e-3, millisecond);
        let carried = Carried(importer.save());
        let future = drive(&importer, 100..200, 1e-3, millisecond);
        let elsewhere = thread::spawn(move || {
            let Carried(mut saved) = { carried };
            let other = Importer::new(model.name);
            // SAFETY: a state of this library, freed once.
            unsafe {
                assert_eq!(fmi2SetFMUstate(other.c, saved), fmi2OK);
                assert_eq!(fmi2FreeFMUstate(other.c, &mut saved), fmi2OK);
            }
            drive(&other, 100..200, 1e-3, millisecond)
        });
        assert_eq!(elsewhere.join().expect("no panic"), future, "{}", model.name);
    }
}

/// FNV-1a of 64 bits, as in RFC 9923: it ends every serialised state.
fn seal(bytes: &mut [u8]) {
    let (body, checksum) = bytes.split_at_mut(bytes.len() - 8);
    let mut hash: u64 = 14_695_981_039_346_656_037;
    for byte in body {
        hash = (hash ^ u64::from(*byte)).wrapping_mul(1_099_511_628_211);
    }
    checksum.copy_from_slice(&hash.to_le_bytes());
}

/// States that are valid, but of another version of the model: the error says so, and nothing changes.
#[test]
fn states_of_other_versions_are_rejected_as_such() {
    let importer = Importer::ready("LuGre");
    let mut state = importer.save();
    let own: Vec<u8> = importer.bytes(state).iter().map(|byte| *byte as u8).collect();
    let (format, guid) = (8, 12..50);
    let changed = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = own.clone();
        change(&mut bytes);
        seal(&mut bytes);
        bytes
    };
    let of_format = |number: u8| changed(&|bytes| bytes[format] = number);
    let of_other_model = |length: usize| {
        changed(&|bytes| {
            bytes[guid.clone()].copy_from_slice(b"{00000000-0000-0000-0000-000000000000}");
            bytes.truncate(length);
        })
    };
    let short = |length: usize| changed(&|bytes| bytes.truncate(length));
    let (other_format, other_model) = ("another format by another version", "another model or another version of it");
    let cases = [
        (own.clone(), None),
        (of_format(0), Some(other_format)),
        (of_format(2), Some(other_format)),
        (of_other_model(own.len()), Some(other_model)),
        // An older one had fewer variables.
        (of_other_model(own.len() - 32), Some(other_model)),
        (short(own.len() - 8), Some("bytes, ")),
        (short(40), Some("not a state of this library")),
    ];
    for (bytes, why) in cases {
        let mut read = null_mut();
        // SAFETY: bytes of this test; states freed once.
        let status = unsafe { fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr().cast(), bytes.len(), &mut read) };
        match why {
            None => assert_eq!(status, fmi2OK),
            Some(why) => {
                assert_eq!(status, fmi2Error, "{why}");
                assert!(read.is_null());
                let text = importer.one_message().2;
                assert!(text.contains("serialised state of LuGre: ") && text.contains(why), "{text}");
                // SAFETY: a state of this instance.
                assert_eq!(unsafe { fmi2SetFMUstate(importer.c, state) }, fmi2OK, "the way out of an error");
            }
        }
        // SAFETY: freed once, or NULL.
        unsafe { fmi2FreeFMUstate(importer.c, &mut read) };
    }
    // SAFETY: freed once.
    unsafe { fmi2FreeFMUstate(importer.c, &mut state) };
}

/// A solver may overshoot a bound; a state saved there can be read back.
#[test]
fn states_beyond_their_bounds_are_saved_too() {
    let importer = Importer::in_state_of("Gonthier", Purpose::ModelExchange, State::ContinuousTimeMode);
    let model = catalogue::by_name("Gonthier").expect("a model");
    let mut states = importer.states();
    let dwell = model.continuous_states().position(|column| model.table[column].path.to_string() == "dwell");
    states[dwell.expect("a state")] = 1.0 + 1e-9;
    // SAFETY: an instance of this test, as many states and bytes as given, states that are freed once.
    unsafe {
        assert_eq!(fmi2SetContinuousStates(importer.c, states.as_ptr(), states.len()), fmi2OK);
        let mut saved = importer.save();
        let bytes = importer.bytes(saved);
        let mut read = null_mut();
        assert_eq!(fmi2DeSerializeFMUstate(importer.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2OK);
        assert_eq!(importer.bytes(read), bytes);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut read), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(importer.c, &mut saved), fmi2OK);
    }
}

#[test]
fn a_state_of_another_model_is_rejected() {
    let (lugre, dahl) = (Importer::ready("LuGre"), Importer::ready("Dahl"));
    let mut saved = lugre.save();
    // SAFETY: a live state, freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(dahl.c, saved), fmi2Error);
        assert!(dahl.one_message().2.contains("FMUstate belongs to LuGre, not to Dahl"));
        let bytes = lugre.bytes(saved);
        let mut read = null_mut();
        assert_eq!(fmi2DeSerializeFMUstate(dahl.c, bytes.as_ptr(), bytes.len(), &mut read), fmi2Error);
        assert!(read.is_null());
        assert_eq!(fmi2FreeFMUstate(lugre.c, &mut saved), fmi2OK);
    }
}

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
    assert!((stepping.get("friction_force") - 0.15 * 9.81).abs() < 1e-12);
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
    assert!((integrating.get("friction_force") - 1000.0).abs() < 1e-9);
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
    let Kind::Enumeration(laws) = model.table[column].kind else { panic!("the laws are choices") };
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

#[test]
fn states_of_stepping_and_of_integrating_instances_are_not_exchanged() {
    let stepping = Importer::ready("LuGre");
    let integrating = Importer::in_state_of("LuGre", Purpose::ModelExchange, State::ContinuousTimeMode);
    let mut saved = stepping.save();
    // SAFETY: an instance and a state of this test; the state is freed once.
    unsafe {
        assert_eq!(fmi2SetFMUstate(integrating.c, saved), fmi2Error);
        assert!(integrating.one_message().2.contains("FMUstate is in state StepComplete"));
        assert_eq!(fmi2FreeFMUstate(stepping.c, &mut saved), fmi2OK);
    }
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
        let begin = row.clone();
        let dt = 1e-9;
        assert!(model.advance(&mut row, dt), "{}", model.name);
        for (state, rate) in states.iter().zip(&rates) {
            let change = (row[*state] - begin[*state]) / dt;
            let rounding = 4.0 * f64::EPSILON * begin[*state].abs() / dt;
            let (name, nominal) = (model.table[*state].path.to_string(), model.table[*state].nominal);
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
    assert!((solver.get("friction_force") - 0.1).abs() < 1e-12);
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
        // Bristles are not yet deflected.
        let slides = sticks() == fmi2False;
        assert!(slides || model.find("phase").is_none(), "{} slides", model.name);
        // A phase has its own event indicator.
        assert_eq!(enters == fmi2True, slides && model.find("phase").is_none(), "{}", model.name);
    }
}
