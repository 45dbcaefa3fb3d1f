//! The FMI 2.0 functions as used by hosts that know little about a model: they set any value that the description
//! allows, leave inputs at 0, keep the time in single precision, and have logging off.

use std::fs;
use std::path::Path;
use std::ptr::null;

use crate::common::NO_EVENT;
use crate::common::importer::{Heard, Importer, callbacks, guid};
use stribeck::catalogue;
use stribeck::model::{self, Kind, ModelType, Role};
use stribeck::reference;
use stribeck_ffi::c::stribeck_status::*;
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// A variable as modelDescription.xml declares it.
struct Declared {
    name: String,
    reference: fmi2ValueReference,
    base: String,
    is_settable: bool,
    low: Option<f64>,
    high: Option<f64>,
}

/// The value of an attribute in a piece of XML.
fn attribute<'a>(xml: &'a str, name: &str) -> Option<&'a str> {
    let start = xml.find(&format!(" {name}=\""))? + name.len() + 3;
    xml[start..].split('"').next()
}

/// Number of items of each enumeration.
fn items(description: &str, kind: &str) -> usize {
    let types = description.split("<SimpleType ").skip(1);
    let found = types.filter(|text| attribute(&format!(" {text}"), "name") == Some(kind));
    found.map(|text| text.split("</SimpleType>").next().unwrap_or_default().matches("<Item ").count()).sum()
}

fn declared(model: &str) -> Vec<Declared> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("modelDescription").join(format!("{model}.xml"));
    // Attributes may be on separate lines.
    let text = fs::read_to_string(path).expect("a description");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let variables = text.split("<ScalarVariable ").skip(1);
    let variable = |piece: &str| {
        let piece = format!(" {}", piece.split("</ScalarVariable>").next().unwrap_or_default());
        let (head, of_type) = piece.split_once("> <").expect("the element of a type");
        let of_type = format!(" {of_type}");
        let number = |name: &str| attribute(&of_type, name).map(|text| text.parse::<f64>().expect("a number"));
        let base = of_type.split_whitespace().next().unwrap_or_default().to_owned();
        let choices =
            (base == "Enumeration").then(|| items(&text, attribute(&of_type, "declaredType").expect("a type")));
        Declared {
            name: attribute(head, "name").expect("a name").to_owned(),
            reference: attribute(head, "valueReference").expect("a reference").parse().expect("a number"),
            is_settable: attribute(&of_type, "start").is_some(),
            low: number("min").or(choices.map(|_| 1.0)),
            high: number("max").or(choices.map(|count| count as f64)),
            base,
        }
    };
    variables.map(variable).collect()
}

/// Sets a variable by the function of its type.
fn set(importer: &Importer, variable: &Declared, value: f64) -> fmi2Status {
    let (c, reference) = (importer.c, &raw const variable.reference);
    // SAFETY: one reference, one value.
    unsafe {
        match &*variable.base {
            "Real" => fmi2SetReal(c, reference, 1, &value),
            "Boolean" => fmi2SetBoolean(c, reference, 1, &(value as fmi2Boolean)),
            _ => fmi2SetInteger(c, reference, 1, &(value as fmi2Integer)),
        }
    }
}

/// The next number of the type.
fn beyond(variable: &Declared, end: f64, is_up: bool) -> f64 {
    match (variable.base == "Real", is_up) {
        (true, true) => end.next_up(),
        (true, false) => end.next_down(),
        (false, true) => end + 1.0,
        (false, false) => end - 1.0,
    }
}

/// FMI's `min` and `max` are permitted values: each declared one is accepted, and the next number beyond it is not.
/// Model Exchange comes first: co-simulation has no events to set a phase, and accepts only its start value. So a phase
/// is left out in laws that have no Model Exchange because they follow the past.
#[test]
fn every_declared_bound_is_accepted_and_nothing_beyond_it() {
    let (mut taken, mut refused) = (0, Vec::new());
    for model in catalogue::models() {
        let purpose = if model.model_exchange { Purpose::ModelExchange } else { Purpose::CoSimulation };
        let importer = Importer::in_state_of(model.name, purpose, State::Initialization);
        let may_be_set = |name: &str| model.model_exchange || name != "phase";
        for variable in declared(model.name).iter().filter(|one| one.is_settable && may_be_set(&one.name)) {
            for (end, is_up) in [(variable.low, false), (variable.high, true)] {
                let Some(end) = end else { continue };
                let at = format!("{}.{} = {end}", model.name, variable.name);
                if set(&importer, variable, end) == fmi2OK {
                    taken += 1
                } else {
                    refused.push(at.clone())
                }
                assert_eq!(set(&importer, variable, beyond(variable, end, is_up)), fmi2Discard, "beyond {at}");
            }
        }
    }
    assert!(refused.is_empty(), "{} of {} are rejected: {refused:?}", refused.len(), refused.len() + taken);
    println!("figure: {taken} declared bounds, each is accepted, and the next number beyond it rejected");
}

/// The same through the C interface, which describes the bounds itself.
#[test]
fn every_described_bound_is_accepted_and_nothing_beyond_it() {
    for model in catalogue::models() {
        let mut handle = std::ptr::null_mut();
        // SAFETY: a text of the library, and a handle that is freed below.
        unsafe { assert_eq!(stribeck_create(model.c_name.as_ptr(), &mut handle), STRIBECK_OK) };
        for (column, variable) in model.variables() {
            let reference = model.reference(column);
            let mut about = std::mem::MaybeUninit::uninit();
            // SAFETY: written on success.
            let about = unsafe {
                assert_eq!(stribeck_describe(handle, reference, about.as_mut_ptr()), STRIBECK_OK);
                about.assume_init()
            };
            if about.role == stribeck_role::STRIBECK_OUTPUT {
                continue;
            }
            let is_real = about.kind == stribeck_kind::STRIBECK_REAL;
            let below = if is_real { about.min.next_down() } else { about.min - 1.0 };
            let above = if is_real { about.max.next_up() } else { about.max + 1.0 };
            let wanted = [
                (about.min, STRIBECK_OK),
                (below, STRIBECK_REFUSED_VALUE),
                (about.max, STRIBECK_OK),
                (above, STRIBECK_REFUSED_VALUE),
                (about.start, STRIBECK_OK),
            ];
            for (value, status) in wanted {
                // SAFETY: a live handle.
                let found = unsafe { stribeck_set(handle, reference, value) };
                assert_eq!(found, status, "{}.{} = {value}", model.name, variable.path);
            }
        }
        // SAFETY: freed once.
        unsafe { stribeck_free(handle) };
    }
}

fn real_columns(model: &ModelType, is_wanted: fn(Role) -> bool) -> Vec<fmi2ValueReference> {
    let wanted =
        model.variables().filter(|(_, variable)| is_wanted(variable.role) && matches!(variable.kind, Kind::Real(_)));
    wanted.map(|(column, _)| model.reference(column)).collect()
}

/// Sets every Real input to 0; returns the error message, if there is one.
fn ground(importer: &Importer, model: &ModelType) -> Result<(), String> {
    for input in real_columns(model, |role| role == Role::Input) {
        // SAFETY: one reference, one value.
        if unsafe { fmi2SetReal(importer.c, &input, 1, &0.0) } != fmi2OK {
            return Err(importer.last_message());
        }
    }
    Ok(())
}

/// The outputs are read, and are finite.
fn read(importer: &Importer, model: &ModelType) -> Result<(), String> {
    let outputs = real_columns(model, Role::is_output);
    let mut values = vec![f64::NAN; outputs.len()];
    // SAFETY: as many references as values.
    let status = unsafe { fmi2GetReal(importer.c, outputs.as_ptr(), outputs.len(), values.as_mut_ptr()) };
    let is_sound = status == fmi2OK && values.iter().all(|value| value.is_finite());
    if is_sound { Ok(()) } else { Err(format!("{status:?} {values:?} {}", importer.last_message())) }
}

/// Simulink grounds unconnected ports, fmpy's runner of SSP packages first sets every connector to 0, and the true
/// values later.
#[derive(Clone, Copy, Debug)]
enum Habit {
    Never,
    InInitialization,
    BeforeTheFirstStep,
    Later,
}

/// Runs a model; true if a warning was logged.
fn run_from_zeros(model: &ModelType, name: &'static str, habit: Habit) -> Result<bool, String> {
    let importer = Importer::in_state(name, State::Initialization);
    if matches!(habit, Habit::InInitialization) {
        ground(&importer, model)?;
        read(&importer, model)?;
    }
    // SAFETY: an instance of this test.
    if unsafe { fmi2ExitInitializationMode(importer.c) } != fmi2OK {
        return Err(importer.last_message());
    }
    for k in 0..20 {
        let is_now = match habit {
            Habit::Never | Habit::InInitialization => false,
            Habit::BeforeTheFirstStep => k == 0,
            Habit::Later => k == 10,
        };
        if is_now {
            ground(&importer, model)?;
            read(&importer, model)?;
        }
        if importer.step(f64::from(k) * 1e-3, 1e-3) != fmi2OK {
            return Err(importer.last_message());
        }
        read(&importer, model)?;
    }
    let heard = importer.heard.lock().expect("one thread");
    // The start values of some laws are not passive, which does not depend on the inputs.
    let is_of_inputs = |text: &str| !text.contains("can give back more energy");
    Ok(heard.iter().any(|(status, _, text)| *status == fmi2Warning && is_of_inputs(text)))
}

#[test]
fn every_model_steps_with_all_inputs_at_zero_and_with_none_set() {
    let (mut failed, mut warned) = (Vec::new(), Vec::new());
    for model in catalogue::models() {
        for habit in [Habit::Never, Habit::InInitialization, Habit::BeforeTheFirstStep, Habit::Later] {
            match run_from_zeros(model, model.name, habit) {
                Ok(true) if matches!(habit, Habit::Later) => warned.push(model.name),
                Ok(_) => {}
                Err(why) => failed.push(format!("{} {habit:?}: {why}", model.name)),
            }
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
    // The models in which an input of 0 makes no sense by default; the temperature of an unheated damper does not matter.
    assert_eq!(warned, ["Liang", "ShockAbsorber", "TelescopicJoint"]);
}

/// A solver that starts from zeros gets derivatives as well.
#[test]
fn every_model_is_integrated_from_inputs_at_zero() {
    let mut failed = Vec::new();
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let importer = Importer::in_state_of(model.name, Purpose::ModelExchange, State::EventMode);
        let run = || {
            ground(&importer, model)?;
            let mut rates = vec![f64::NAN; model.continuous_states().count()];
            // SAFETY: an instance of this test, as many values as states.
            let status = unsafe {
                assert_eq!(fmi2NewDiscreteStates(importer.c, &mut { NO_EVENT }), fmi2OK);
                assert_eq!(fmi2EnterContinuousTimeMode(importer.c), fmi2OK);
                fmi2GetDerivatives(importer.c, rates.as_mut_ptr(), rates.len())
            };
            let is_sound = status == fmi2OK && rates.iter().all(|rate| rate.is_finite());
            if is_sound { read(&importer, model) } else { Err(format!("{rates:?} {}", importer.last_message())) }
        };
        if let Err(why) = run() {
            failed.push(format!("{}: {why}", model.name));
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

/// Masters that keep the time in single precision: i h, and h summed up, which after a minute is off by many steps.
/// Their clock is accepted as long as each step begins where the last one ended on this clock.
#[test]
fn a_clock_in_single_precision_is_accepted() {
    for h in [1e-3f32, 1e-4] {
        for is_step_single in [true, false] {
            let step = if is_step_single { f64::from(h) } else { exact(h) };
            let computed = Importer::ready("Coulomb");
            let summed = Importer::ready("Coulomb");
            let (mut sum, count) = (0f32, (60.0 / h).round() as u32);
            for k in 0..count {
                let t = f64::from(k as f32 * h);
                assert_eq!(computed.step(t, step), fmi2OK, "k h in step {k} of {h} s: {}", computed.last_message());
                assert_eq!(
                    summed.step(f64::from(sum), step),
                    fmi2OK,
                    "sum in step {k} of {h} s: {}",
                    summed.last_message()
                );
                sum += h;
            }
            assert!(h > 5e-4 || (f64::from(sum) - 60.0).abs() > 10.0 * exact(h), "{sum}: it has drifted by many steps");
        }
    }
}

/// The decimal number that a step in single precision represents.
fn exact(h: f32) -> f64 {
    h.to_string().parse().expect("a number")
}

/// However coarse the clock: a step that is repeated, skipped, or begins half a step off is rejected, early and late.
#[test]
fn a_wrong_step_is_rejected_with_a_coarse_clock_too() {
    for h in [1e-3, 1e-4, 1e-5] {
        for begin in [0.0, 1.0, 59.0] {
            for wrong in [-1.0, 1.0, -0.5, 0.5, 2.0] {
                let importer = Importer::ready("Coulomb");
                if begin > 0.0 {
                    assert_eq!(importer.step(0.0, begin), fmi2OK);
                }
                assert_eq!(importer.step(begin, h), fmi2OK);
                let t = begin + h + wrong * h;
                assert_eq!(importer.step(t, h), fmi2Error, "{wrong} steps off at {begin} s, h = {h} s");
            }
        }
    }
}

/// A host that makes a step at each evaluation of its integrator, 21 times in each of its own steps, at consecutive
/// times: every step returns fmi2OK, and the log reports the fault once. A host that steps once gets no message.
#[test]
fn a_strut_that_is_stepped_too_often_warns() {
    for often in [1, 21] {
        let importer = Importer::ready("ShockAbsorber");
        let mut steps = 0;
        for k in 0..1000 {
            let angle = 10.0 * 1e-3 * f64::from(k);
            assert_eq!(importer.set("length", 0.1775 + 0.02 * angle.sin()), fmi2OK);
            assert_eq!(importer.set("velocity", 0.2 * angle.cos()), fmi2OK);
            for _ in 0..often {
                assert_eq!(importer.step(f64::from(steps) * 1e-3, 1e-3), fmi2OK);
                steps += 1;
            }
        }
        let heard = std::mem::take(&mut *importer.heard.lock().expect("one thread"));
        if often == 1 {
            assert!(heard.is_empty(), "{heard:?}");
        } else {
            assert!(!heard.is_empty() && heard.len() < 6, "{heard:?}");
            let (status, category, text) = &heard[heard.len() - 1];
            assert_eq!((*status, &**category), (fmi2Warning, "logStatusWarning"));
            assert!(text.contains("21.0 times as far as length"), "{text}");
        }
    }
}

/// `loggingOn` switches debug logging. The reason of a failed call does not belong to it; rejected trials of a solver
/// do.
#[test]
fn reasons_are_logged_even_with_logging_off() {
    let heard = Heard::default();
    let callbacks = callbacks(&heard);
    let instance = |kind, debug| {
        // SAFETY: valid texts and callbacks.
        unsafe { fmi2Instantiate(c"a".as_ptr(), kind, guid("LuGre").as_ptr(), null(), &callbacks, fmi2False, debug) }
    };
    let count = || std::mem::take(&mut *heard.lock().expect("one thread")).len();
    // SAFETY: instances of this test, each freed once.
    unsafe {
        let c = instance(fmi2CoSimulation, fmi2False);
        let velocity = reference::of(&model::Path::root("velocity"));
        assert_eq!(fmi2SetReal(c, &velocity, 1, &f64::NAN), fmi2Discard);
        assert_eq!(count(), 1, "a value");
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(count(), 1, "a call");
        assert_eq!(fmi2SetDebugLogging(c, fmi2False, 1, &c"logStatusDiscard".as_ptr()), fmi2OK);
        assert_eq!(fmi2Reset(c), fmi2OK);
        let velocity = reference::of(&model::Path::root("velocity"));
        assert_eq!(fmi2SetReal(c, &velocity, 1, &f64::NAN), fmi2Discard);
        assert_eq!(count(), 0, "switched off");
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(count(), 1, "another category");
        assert_eq!(fmi2SetDebugLogging(c, fmi2False, 0, null()), fmi2OK);
        assert_eq!(fmi2Terminate(c), fmi2Error);
        assert_eq!(count(), 0, "all switched off");
        fmi2FreeInstance(c);
        for debug in [fmi2False, fmi2True] {
            let c = instance(fmi2ModelExchange, debug);
            assert_eq!(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
            assert_eq!(fmi2EnterInitializationMode(c), fmi2OK);
            assert_eq!(fmi2ExitInitializationMode(c), fmi2OK);
            assert_eq!(count(), debug as usize, "parameters that are not passive");
            assert_eq!(fmi2NewDiscreteStates(c, &mut { NO_EVENT }), fmi2OK);
            assert_eq!(fmi2EnterContinuousTimeMode(c), fmi2OK);
            let velocity = reference::of(&model::Path::root("velocity"));
            assert_eq!(fmi2SetReal(c, &velocity, 1, &1e308), fmi2OK);
            assert_eq!(fmi2GetDerivatives(c, [0.0; 2].as_mut_ptr(), 2), fmi2Discard);
            assert_eq!(count(), debug as usize, "a trial");
            fmi2FreeInstance(c);
        }
    }
}
