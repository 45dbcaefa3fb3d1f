//! Every function in every state, against the tables of the standard, and without an instance.

use std::ptr::{null, null_mut};
use std::sync::{Arc, Mutex};

use super::importer::{Choice, Importer};
use stribeck::catalogue;
use stribeck::model::{Role, Variable};
use stribeck_ffi::fmi3::derivatives::*;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::{ALLOWED, Call, Purpose, STATES, State, functions};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::{self, *};
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::unused::*;
use stribeck_ffi::fmi3::values::*;

/// Arguments of a call: an instance, and what belongs to its model.
#[derive(Clone)]
struct Arguments {
    c: fmi3Instance,
    /// An output and an input, each with its number and the value of the input.
    output: (u32, usize),
    input: (u32, usize, f64),
    saved: fmi3FMUState,
    bytes: Vec<u8>,
    states: Vec<f64>,
    indicators: usize,
}

// SAFETY: used by one thread only.
unsafe impl Send for Arguments {}

impl Arguments {
    fn of(importer: &Importer, donor: &Importer, saved: fmi3FMUState) -> Arguments {
        let model = importer.model;
        let find = |is_wanted: &dyn Fn(&Variable) -> bool| {
            let mut found = super::reals(model, |_| true).into_iter().filter(|known| known.columns.len() == 1);
            found.find(|known| is_wanted(&known.first) && !known.first.jumps)
        };
        let output = find(&|variable| variable.role.is_output() && !variable.is_advice);
        let input = find(&|variable| variable.role == Role::Input);
        Arguments {
            c: importer.instance,
            output: output.map_or((0, 0), |known| (known.reference, 1)),
            input: input.map_or((0, 0, 0.0), |known| (known.reference, 1, known.first.start)),
            saved,
            bytes: donor.bytes(saved),
            states: model.continuous_states().map(|column| model.table.at(column).start).collect(),
            indicators: model.event_indicators,
        }
    }

    /// Makes the call with valid arguments.
    fn call(&self, call: Call) -> fmi3Status {
        self.change(call)
            .or_else(|| self.values(call))
            .or_else(|| self.nothing(call))
            .or_else(|| self.states(call))
            .or_else(|| self.solver(call))
            .unwrap_or_else(|| panic!("{call:?} is not called"))
    }

    fn change(&self, call: Call) -> Option<fmi3Status> {
        let c = self.c;
        let ([mut a, mut b, mut d, mut e, mut f], mut time) = ([0; 5], 0.0);
        // SAFETY: an instance of this test, or NULL; places for all answers.
        Some(unsafe {
            match call {
                Call::SetDebugLogging => fmi3SetDebugLogging(c, 1, 0, null()),
                Call::EnterInitializationMode => fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0),
                Call::ExitInitializationMode => fmi3ExitInitializationMode(c),
                Call::EnterEventMode => fmi3EnterEventMode(c),
                Call::Terminate => fmi3Terminate(c),
                Call::Reset => fmi3Reset(c),
                Call::EnterConfigurationMode => fmi3EnterConfigurationMode(c),
                Call::ExitConfigurationMode => fmi3ExitConfigurationMode(c),
                Call::EvaluateDiscreteStates => fmi3EvaluateDiscreteStates(c),
                Call::UpdateDiscreteStates => {
                    fmi3UpdateDiscreteStates(c, &mut a, &mut b, &mut d, &mut e, &mut f, &mut time)
                }
                Call::EnterContinuousTimeMode => fmi3EnterContinuousTimeMode(c),
                Call::EnterStepMode => fmi3EnterStepMode(c),
                Call::DoStep => fmi3DoStep(c, 0.0, 1e-3, 1, &mut a, &mut b, &mut d, &mut time),
                Call::ActivateModelPartition => fmi3ActivateModelPartition(c, 0, 0.0),
                _ => return None,
            }
        })
    }

    fn values(&self, call: Call) -> Option<fmi3Status> {
        let ((output, m), (input, n, start), c) = (self.output, self.input, self.c);
        let mut value = 0.0;
        // SAFETY: an instance of this test, arrays of at most one element.
        Some(unsafe {
            match call {
                Call::GetFloat64 => fmi3GetFloat64(c, &output, m, &mut value, m),
                Call::SetFloat64 => fmi3SetFloat64(c, &input, n, &start, n),
                Call::GetInt32 => fmi3GetInt32(c, null(), 0, null_mut(), 0),
                Call::SetInt32 => fmi3SetInt32(c, null(), 0, null(), 0),
                Call::GetInt64 => fmi3GetInt64(c, null(), 0, null_mut(), 0),
                Call::SetInt64 => fmi3SetInt64(c, null(), 0, null(), 0),
                Call::GetUInt64 => fmi3GetUInt64(c, null(), 0, null_mut(), 0),
                Call::SetUInt64 => fmi3SetUInt64(c, null(), 0, null(), 0),
                Call::GetBoolean => fmi3GetBoolean(c, null(), 0, null_mut(), 0),
                Call::SetBoolean => fmi3SetBoolean(c, null(), 0, null(), 0),
                Call::GetDirectionalDerivative => {
                    fmi3GetDirectionalDerivative(c, &output, m, &input, n, &1.0, n, &mut value, m)
                }
                Call::GetAdjointDerivative => {
                    fmi3GetAdjointDerivative(c, &output, m, &input, n, &1.0, m, &mut value, n)
                }
                Call::GetOutputDerivatives => fmi3GetOutputDerivatives(c, &output, m, &1, &mut value, m),
                _ => return None,
            }
        })
    }

    /// Calls about no variable of types that no model has.
    fn nothing(&self, call: Call) -> Option<fmi3Status> {
        let c = self.c;
        let mut count = 0;
        // SAFETY: an instance of this test, arrays without elements.
        Some(unsafe {
            match call {
                Call::GetFloat32 => fmi3GetFloat32(c, null(), 0, null_mut(), 0),
                Call::SetFloat32 => fmi3SetFloat32(c, null(), 0, null(), 0),
                Call::GetInt8 => fmi3GetInt8(c, null(), 0, null_mut(), 0),
                Call::SetInt8 => fmi3SetInt8(c, null(), 0, null(), 0),
                Call::GetUInt8 => fmi3GetUInt8(c, null(), 0, null_mut(), 0),
                Call::SetUInt8 => fmi3SetUInt8(c, null(), 0, null(), 0),
                Call::GetInt16 => fmi3GetInt16(c, null(), 0, null_mut(), 0),
                Call::SetInt16 => fmi3SetInt16(c, null(), 0, null(), 0),
                Call::GetUInt16 => fmi3GetUInt16(c, null(), 0, null_mut(), 0),
                Call::SetUInt16 => fmi3SetUInt16(c, null(), 0, null(), 0),
                Call::GetUInt32 => fmi3GetUInt32(c, null(), 0, null_mut(), 0),
                Call::SetUInt32 => fmi3SetUInt32(c, null(), 0, null(), 0),
                Call::GetString => fmi3GetString(c, null(), 0, null_mut(), 0),
                Call::SetString => fmi3SetString(c, null(), 0, null(), 0),
                Call::GetBinary => fmi3GetBinary(c, null(), 0, null_mut(), null_mut(), 0),
                Call::SetBinary => fmi3SetBinary(c, null(), 0, null(), null(), 0),
                Call::GetClock => fmi3GetClock(c, null(), 0, null_mut()),
                Call::SetClock => fmi3SetClock(c, null(), 0, null()),
                Call::GetIntervalDecimal => fmi3GetIntervalDecimal(c, null(), 0, null_mut(), null_mut()),
                Call::GetIntervalFraction => fmi3GetIntervalFraction(c, null(), 0, null_mut(), null_mut(), null_mut()),
                Call::GetShiftDecimal => fmi3GetShiftDecimal(c, null(), 0, null_mut()),
                Call::GetShiftFraction => fmi3GetShiftFraction(c, null(), 0, null_mut(), null_mut()),
                Call::SetIntervalDecimal => fmi3SetIntervalDecimal(c, null(), 0, null()),
                Call::SetIntervalFraction => fmi3SetIntervalFraction(c, null(), 0, null(), null()),
                Call::SetShiftDecimal => fmi3SetShiftDecimal(c, null(), 0, null()),
                Call::SetShiftFraction => fmi3SetShiftFraction(c, null(), 0, null(), null()),
                Call::GetNumberOfVariableDependencies => fmi3GetNumberOfVariableDependencies(c, 0, &mut count),
                Call::GetVariableDependencies => {
                    fmi3GetVariableDependencies(c, 0, null_mut(), null_mut(), null_mut(), null_mut(), 0)
                }
                _ => return None,
            }
        })
    }

    fn states(&self, call: Call) -> Option<fmi3Status> {
        let (c, mut state, mut size) = (self.c, null_mut(), 0);
        let mut bytes = self.bytes.clone();
        // SAFETY: an instance of this test, states of its model, each freed once by an instance that is not in an error.
        Some(unsafe {
            let status = match call {
                Call::GetFMUState => fmi3GetFMUState(c, &mut state),
                Call::SetFMUState => fmi3SetFMUState(c, self.saved),
                Call::FreeFMUState => fmi3FreeFMUState(c, &mut state),
                Call::SerializedFMUStateSize => fmi3SerializedFMUStateSize(c, self.saved, &mut size),
                Call::SerializeFMUState => fmi3SerializeFMUState(c, self.saved, bytes.as_mut_ptr(), bytes.len()),
                Call::DeserializeFMUState => fmi3DeserializeFMUState(c, bytes.as_ptr(), bytes.len(), &mut state),
                _ => return None,
            };
            if !state.is_null() {
                assert_eq!(fmi3FreeFMUState(c, &mut state), fmi3OK);
            }
            status
        })
    }

    fn solver(&self, call: Call) -> Option<fmi3Status> {
        let (c, n) = (self.c, self.states.len());
        let (mut x, mut z) = (self.states.clone(), vec![0.0; self.indicators]);
        let ([mut event, mut end], mut count) = ([0; 2], 0);
        // SAFETY: an instance of this test, arrays of as many elements as given.
        Some(unsafe {
            match call {
                Call::CompletedIntegratorStep => fmi3CompletedIntegratorStep(c, 1, &mut event, &mut end),
                Call::SetTime => fmi3SetTime(c, 1.0),
                Call::SetContinuousStates => fmi3SetContinuousStates(c, x.as_ptr(), n),
                Call::GetContinuousStateDerivatives => fmi3GetContinuousStateDerivatives(c, x.as_mut_ptr(), n),
                Call::GetEventIndicators => fmi3GetEventIndicators(c, z.as_mut_ptr(), z.len()),
                Call::GetContinuousStates => fmi3GetContinuousStates(c, x.as_mut_ptr(), n),
                Call::GetNominalsOfContinuousStates => fmi3GetNominalsOfContinuousStates(c, x.as_mut_ptr(), n),
                Call::GetNumberOfEventIndicators => fmi3GetNumberOfEventIndicators(c, &mut count),
                Call::GetNumberOfContinuousStates => fmi3GetNumberOfContinuousStates(c, &mut count),
                _ => return None,
            }
        })
    }
}

/// The table of FMI 3.0.2, sections 2.3, 3.2 and 4.2, typed in from the standard a second time: one letter per state, in
/// the order Instantiated, Configuration, Initialization, Event, Continuous-Time, Step, Intermediate Update, Terminated;
/// `+` where this library allows more, `e` where a call is an error because it is not provided. An error terminates.
#[rustfmt::skip]
const STANDARD: [(&str, &str, &str); 36] = [
    // Function(s)                                      for      I C N E T S U D
    ("SetDebugLogging",                                 "both", "xxxxxx+x"),
    ("Reset",                                           "both", "xxxxxx-x"),
    ("GetFMUState SetFMUState FreeFMUState",            "both", "xxxxxx-x"),
    ("SerializedFMUStateSize SerializeFMUState",        "both", "xxxxxx-x"),
    ("DeserializeFMUState",                             "both", "xxxxxx-x"),
    ("EnterConfigurationMode",                          "both", "x-------"),
    ("ExitConfigurationMode",                           "both", "-x------"),
    ("EnterInitializationMode",                         "both", "x-------"),
    ("ExitInitializationMode",                          "both", "--x-----"),
    ("EnterEventMode",                                  "both", "----xx--"),
    ("Terminate",                                       "both", "---xxx--"),
    ("EvaluateDiscreteStates UpdateDiscreteStates",     "both", "---x----"),
    ("EnterContinuousTimeMode",                         "me",   "---x----"),
    ("EnterStepMode",                                   "cs",   "---x----"),
    ("GetFloat32 GetFloat64 GetInt8 GetUInt8 GetInt16", "both", "x-xxxxxx"),
    ("GetUInt16 GetInt32 GetUInt32 GetInt64",           "both", "x-xxxxxx"),
    ("GetBoolean GetString GetBinary",                  "both", "x-xxxxxx"),
    ("GetUInt64",                                       "both", "x+xxxxxx"),
    ("SetFloat32 SetFloat64",                           "both", "x-xxxx--"),
    ("SetInt8 SetUInt8 SetInt16 SetUInt16 SetInt32",    "both", "x-xx-x--"),
    ("SetUInt32 SetInt64 SetBoolean SetString",         "both", "x-xx-x--"),
    ("SetBinary",                                       "both", "x-xx-x--"),
    ("SetUInt64",                                       "both", "xxxx-x--"),
    ("GetClock SetClock",                               "both", "---x----"),
    ("GetIntervalDecimal GetIntervalFraction",          "both", "--xx----"),
    ("GetShiftDecimal GetShiftFraction",                "both", "--x-----"),
    ("SetIntervalDecimal SetIntervalFraction",          "both", "--x-----"),
    ("SetShiftDecimal SetShiftFraction",                "both", "--x-----"),
    ("GetDirectionalDerivative GetAdjointDerivative",   "both", "--xxxx-x"),
    ("GetOutputDerivatives",                            "cs",   "-----xxx"),
    ("DoStep",                                          "cs",   "-----x--"),
    ("GetNumberOfVariableDependencies GetVariableDependencies", "both", "eeeeeeee"),
    ("SetTime",                                         "me",   "---+x---"),
    ("SetContinuousStates CompletedIntegratorStep",     "me",   "----x---"),
    ("GetContinuousStates GetContinuousStateDerivatives GetEventIndicators GetNominalsOfContinuousStates",
                                                        "me",   "--xxx--x"),
    ("GetNumberOfContinuousStates GetNumberOfEventIndicators", "me", "x++x+--+"),
];

/// The states of the letters of [`STANDARD`].
const COLUMNS: [State; 8] = [
    State::Instantiated,
    State::ConfigurationMode,
    State::InitializationMode,
    State::EventMode,
    State::ContinuousTimeMode,
    State::StepMode,
    State::IntermediateUpdateMode,
    State::Terminated,
];

/// The status that the standard asks for.
fn expected(call: Call, purpose: Purpose, state: State) -> fmi3Status {
    let function = format!("{call:?}");
    let row = STANDARD.iter().find(|(names, ..)| names.split(' ').any(|name| name == function));
    let state = if state == State::Error { State::Terminated } else { state };
    let column = COLUMNS.iter().position(|column| *column == state).expect("a column");
    let is_one = |kind: &str| kind == "both" || (kind == "me") == (purpose == Purpose::ModelExchange);
    // A function without a row, such as those of scheduled execution, has no state.
    match row {
        Some((_, kind, letters)) if is_one(kind) && "x+".contains(letters.as_bytes()[column] as char) => fmi3OK,
        _ => fmi3Error,
    }
}

/// Makes the call in a state; the status with the message, if there is one.
fn made(model: &str, purpose: Purpose, state: State, call: Call) -> (fmi3Status, String) {
    let choice = Choice { event_mode: true, within: state == State::IntermediateUpdateMode, ..Choice::default() };
    let donor = Importer::in_state(model, purpose, &choice, State::EventMode);
    let saved = donor.save();
    let status = if state == State::IntermediateUpdateMode {
        let required = Arguments::of(&donor, &donor, saved).output;
        let choice = Choice { required: [required.0][..required.1].to_vec(), ..choice };
        let importer = Importer::in_state(model, purpose, &choice, State::StepMode);
        let (arguments, answer) = (Arguments::of(&importer, &donor, saved), Arc::new(Mutex::new(None)));
        let place = answer.clone();
        *importer.heard.within.lock().expect("one thread") = Some(Box::new(move |_| {
            place.lock().expect("one thread").get_or_insert_with(|| arguments.call(call));
            None
        }));
        let _ = importer.try_step(0.0, 1e-3);
        let first = importer.heard.messages.lock().expect("one thread").first().cloned();
        let status = answer.lock().expect("one thread").expect("a callback");
        (status, first.map(|(.., text)| text).unwrap_or_default())
    } else {
        let importer = Importer::in_state(model, purpose, &choice, state);
        let status = Arguments::of(&importer, &donor, saved).call(call);
        (status, importer.last_message())
    };
    donor.free(saved);
    status
}

#[test]
fn every_function_in_every_state_has_the_status_of_the_standard() {
    let mut count = 0;
    for model in catalogue::models() {
        let has_sizes = stribeck::arrays::of(model).expect("memory").iter().any(|array| array.size.is_some());
        for purpose in [Purpose::CoSimulation, Purpose::ModelExchange] {
            let is_offered = purpose == Purpose::CoSimulation || model.model_exchange;
            for state in STATES.into_iter().filter(|state| is_offered && state.is_for(purpose)) {
                if state == State::ConfigurationMode && !has_sizes {
                    continue;
                }
                for (call, ..) in ALLOWED {
                    if call == Call::EnterConfigurationMode && !has_sizes {
                        continue;
                    }
                    let (status, text) = made(model.name, purpose, state, call);
                    let wanted = expected(call, purpose, state);
                    assert_eq!(status, wanted, "fmi3{call:?} of {} in {state:?} for {purpose:?}: {text}", model.name);
                    assert_eq!(text.contains(&format!("fmi3{call:?}: ")), status != fmi3OK, "{text}");
                    count += 1;
                }
            }
        }
    }
    println!("figure: {count} calls of FMI 3.0, one of each function in each state of each model");
}

/// The rows name each function once, and no other.
#[test]
fn the_standard_is_typed_in_completely() {
    let mut typed: Vec<String> =
        STANDARD.iter().flat_map(|(names, ..)| names.split(' ')).map(|name| format!("fmi3{name}")).collect();
    typed.extend(["GetVersion", "InstantiateModelExchange", "InstantiateCoSimulation", "FreeInstance"].map(prefixed));
    typed.extend(["InstantiateScheduledExecution", "ActivateModelPartition"].map(prefixed));
    typed.sort();
    let mut found: Vec<String> = functions().collect();
    found.sort();
    assert_eq!(typed, found);
    assert_eq!(found.len(), 75, "functions of fmi3Functions.h");
}

fn prefixed(name: &str) -> String {
    format!("fmi3{name}")
}

#[test]
fn null_instances_are_errors() {
    let donor = Importer::ready("LuGre");
    let saved = donor.save();
    let arguments = Arguments { c: null_mut(), ..Arguments::of(&donor, &donor, saved) };
    for (call, ..) in ALLOWED {
        assert_eq!(arguments.call(call), fmi3Error, "fmi3{call:?}");
    }
    donor.free(saved);
    // Memory that is not an instance is rejected too, as long as it is readable; so is an instance of FMI 2.0.
    let mut other = [0u64; 64];
    // SAFETY: readable and writable memory, large enough to be checked.
    assert_eq!(unsafe { fmi3Reset(other.as_mut_ptr().cast()) }, fmi3Error);
    let two = crate::Importer::ready("LuGre");
    // SAFETY: a living instance, of another version.
    assert_eq!(unsafe { fmi3Reset(two.c) }, fmi3Error);
}

/// NULL where elements are promised.
#[test]
fn null_arrays_are_errors_by_name() {
    for what in 0..4 {
        let importer = Importer::ready("LuGre");
        let (c, velocity) = (importer.instance, importer.vr("velocity"));
        // SAFETY: NULL is checked.
        let (status, name) = unsafe {
            match what {
                0 => (fmi3GetFloat64(c, null(), 1, &mut 0.0, 1), "valueReferences"),
                1 => (fmi3GetFloat64(c, &velocity, 1, null_mut(), 1), "values"),
                2 => (fmi3SetFloat64(c, &velocity, 1, null(), 1), "values"),
                _ => (fmi3GetInt64(c, null(), 3, null_mut(), 3), "valueReferences"),
            }
        };
        assert_eq!(status, fmi3Error);
        assert!(importer.one_message().2.ends_with(&format!("{name} is NULL")));
    }
}
