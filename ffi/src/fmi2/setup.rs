//! From fmi2Instantiate to fmi2FreeInstance.

use std::ffi::CStr;
use std::ptr::null_mut;

use super::component::{self, Component, Experiment, Types, enter, refuse};
use super::lifecycle::{Call, Purpose, State};
use super::log::{self, Callbacks};
use super::types::*;
use crate::component::log::{Line, Log};
use crate::component::setup::{self, NoInstance};
use crate::guard;
use crate::guard::pointer::{self, array};
use crate::models;
use stribeck::memory;
use stribeck::model::{Computed, ModelType};

/// The platform of the types: "default".
#[unsafe(no_mangle)]
pub extern "C-unwind" fn fmi2GetTypesPlatform() -> fmi2String {
    c"default".as_ptr()
}

/// The version of the interface: "2.0".
#[unsafe(no_mangle)]
pub extern "C-unwind" fn fmi2GetVersion() -> fmi2String {
    c"2.0".as_ptr()
}

/// Makes an instance of the model whose guid is `fmuGUID`, to be freed once with fmi2FreeInstance.
///
/// `fmuType` must be `fmi2CoSimulation` or, for models that support it, `fmi2ModelExchange`. `callbacks` is copied; its
/// function pointers may all be NULL. `fmuResourceLocation` and `visible` are not used. Returns NULL, and logs the
/// reason, if the guid does not belong to a model of this library, if the model does not support that type, if the name
/// is blank, or if memory runs out. If `callbacks` is NULL it returns NULL without a message.
///
/// # Safety
/// Texts must be NULL or zero-terminated; `callbacks` must be NULL or point to a valid struct.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Instantiate(
    instanceName: fmi2String,
    fmuType: fmi2Type,
    fmuGUID: fmi2String,
    _fmuResourceLocation: fmi2String,
    callbacks: *const fmi2CallbackFunctions,
    _visible: fmi2Boolean,
    loggingOn: fmi2Boolean,
) -> fmi2Component {
    // SAFETY: the caller promises NULL or a valid struct; it is copied because it need not outlive this call.
    let Some(callbacks) = (unsafe { callbacks.as_ref() }).copied() else { return null_mut() };
    // SAFETY: the caller promises NULL or zero-terminated texts.
    let (name, guid) = unsafe { (pointer::text(instanceName), pointer::text(fmuGUID)) };
    let name = name.unwrap_or_default();
    let mut why = Line::EMPTY;
    let c = make(name, fmuType, guid, callbacks, loggingOn != fmi2False, &mut why);
    if c.is_null() {
        // The logger may throw: there is nothing to clean up, see `Log`.
        // SAFETY: the importer's callbacks.
        unsafe { log::send(&callbacks, name, fmi2Status::fmi2Error, &log::ERROR, why.text()) };
    }
    c
}

/// Makes an instance, or returns NULL with the reason in `line`.
#[inline(never)]
fn make(
    name: &CStr,
    kind: fmi2Type,
    guid: Option<&CStr>,
    callbacks: fmi2CallbackFunctions,
    debug: bool,
    line: &mut Line,
) -> fmi2Component {
    match guard::make(|| instantiate(name, kind, guid, callbacks, debug)) {
        Ok(component) => Box::into_raw(component).cast(),
        Err(NoInstance(why)) => {
            line.write(format_args!("fmi2Instantiate: {why}"));
            null_mut()
        }
    }
}

fn instantiate(
    name: &CStr,
    kind: fmi2Type,
    guid: Option<&CStr>,
    callbacks: fmi2CallbackFunctions,
    debug: bool,
) -> Result<Box<Component>, NoInstance> {
    setup::check_name(name)?;
    let (model, types) = model(guid)?;
    let purpose = purpose(kind, model)?;
    let instance = setup::instance(model, purpose)?;
    let log = Log::new(Callbacks::new(callbacks, name)?, debug);
    Ok(memory::boxed(Component::new(instance, purpose, log, types))?)
}

/// The model with this guid, or with this guid of its plain FMU.
fn model(guid: Option<&CStr>) -> Result<(&'static ModelType, Types), NoInstance> {
    let plain = |why| guid.and_then(|guid| models::by_plain_guid(pointer::name(guid))).ok_or(why);
    setup::model(guid, ["fmuGUID", "guid"])
        .map(|model| (model, Types::Declared))
        .or_else(|why| plain(why).map(|model| (model, Types::Real)))
}

fn purpose(kind: fmi2Type, model: &ModelType) -> Result<Purpose, NoInstance> {
    let name = model.name;
    match kind {
        fmi2CoSimulation => Ok(Purpose::CoSimulation),
        fmi2ModelExchange if model.model_exchange => Ok(Purpose::ModelExchange),
        fmi2ModelExchange => {
            Err(NoInstance::because(format_args!("fmuType is {kind}: {name} {}", setup::ONLY_CO_SIMULATION)))
        }
        _ => Err(NoInstance::because(format_args!(
            "fmuType is {kind}: must be {fmi2ModelExchange} (Model Exchange) or {fmi2CoSimulation}"
        ))),
    }
}

/// Frees an instance. NULL is ignored.
///
/// # Safety
/// `c` must be NULL or an instance that is not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2FreeInstance(c: fmi2Component) {
    // SAFETY: the caller's promise. Freeing runs no code of a model, so there is no panic to catch.
    drop(unsafe { component::take(c) });
}

/// Switches log categories (`logStatusWarning`, `logStatusDiscard`, `logStatusError`, `logAll`); all of them if
/// `nCategories` is 0. Before this call, errors, refused values and warnings are logged even if `loggingOn` of
/// fmi2Instantiate was false; values refused in a solver's trials only if it was true.
///
/// # Safety
/// `c` as for every call on an instance; `categories` must hold `nCategories` zero-terminated texts.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetDebugLogging(
    c: fmi2Component,
    loggingOn: fmi2Boolean,
    nCategories: usize,
    categories: *const fmi2String,
) -> fmi2Status {
    let body = |component: &mut Component| {
        let enabled = loggingOn != fmi2False;
        // SAFETY: the caller promises `nCategories` pointers to texts.
        unsafe { setup::switch_log(component, enabled, array(categories, nCategories, "categories")?) }
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetDebugLogging, body) }
}

/// Declares start time and, if defined, stop time, which no step may exceed. The tolerance is only checked: the steps
/// are exact or keep a tighter tolerance of their own.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetupExperiment(
    c: fmi2Component,
    toleranceDefined: fmi2Boolean,
    tolerance: fmi2Real,
    startTime: fmi2Real,
    stopTimeDefined: fmi2Boolean,
    stopTime: fmi2Real,
) -> fmi2Status {
    let body = |component: &mut Component| {
        let tolerance = (toleranceDefined != fmi2False).then_some(tolerance);
        setup::set_up(component, tolerance, startTime, (stopTimeDefined != fmi2False).then_some(stopTime))
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetupExperiment, body) }
}

/// Enters initialization mode, in which inputs are set and outputs read at the start time.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2EnterInitializationMode(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        if !component.experiment.is_set_up {
            return refuse("fmi2SetupExperiment must be called first");
        }
        component.state = State::Initialization;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::EnterInitializationMode, body) }
}

/// Ends the initialization: parameters must now fit together, outputs must be finite. Model Exchange continues in event
/// mode; the states left undetermined by the start values are set, and the first fmi2NewDiscreteStates reports whether
/// states jumped.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2ExitInitializationMode(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        component.check_parameters()?;
        component.instance.refresh_to(Computed::Main)?;
        component.begin();
        component.state = match component.purpose {
            Purpose::CoSimulation => State::StepComplete,
            Purpose::ModelExchange => {
                component.has_jumped = component.instance.at_event()?;
                State::EventMode
            }
        };
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::ExitInitializationMode, body) }
}

/// Ends the simulation run. Results can still be read.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Terminate(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        component.state = State::Terminated;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::Terminate, body) }
}

/// Resets to the state after fmi2Instantiate: start values, no experiment, time 0. Log settings are kept.
///
/// # Safety
/// `c` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Reset(c: fmi2Component) -> fmi2Status {
    let body = |component: &mut Component| {
        component.instance.reset();
        component.experiment = Experiment::NONE;
        component.state = State::Instantiated;
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::Reset, body) }
}
