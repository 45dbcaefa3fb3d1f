//! From instantiation to fmi3FreeInstance.

use std::ffi::CStr;
use std::ptr::null_mut;

use super::component::{self, Component, Experiment, Outcome, Own, Stepping, enter, refuse};
use super::layout::Item;
use super::lifecycle::{Call, Purpose, State};
use super::log::Messages;
use super::types::*;
use crate::component::log::{self, Level, Line, Log, Logger};
use crate::component::setup::{self, NoInstance};
use crate::guard;
use crate::guard::pointer::{self, array};
use stribeck::instance::Trial;
use stribeck::memory;
use stribeck::model::{Computed, ModelType, Role, Variable};

/// The version of the interface: "3.0".
#[unsafe(no_mangle)]
pub extern "C-unwind" fn fmi3GetVersion() -> fmi3String {
    c"3.0".as_ptr()
}

/// Makes an instance for Model Exchange of the model whose instantiation token this is, to be freed once with
/// fmi3FreeInstance.
///
/// `logMessage` may be NULL; `resourcePath` and `visible` are not used. Returns NULL, and with `loggingOn` logs the reason, if the token
/// does not belong to a model of this library, if the model is for co-simulation only, if the name is blank, or if memory
/// runs out.
///
/// # Safety
/// Texts must be NULL or zero-terminated.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3InstantiateModelExchange(
    instanceName: fmi3String,
    instantiationToken: fmi3String,
    _resourcePath: fmi3String,
    _visible: fmi3Boolean,
    loggingOn: fmi3Boolean,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: fmi3LogMessageCallback,
) -> fmi3Instance {
    let messages = Messages { environment: instanceEnvironment, callback: logMessage };
    // SAFETY: the caller promises NULL or zero-terminated texts.
    let (name, token) = unsafe { (pointer::text(instanceName), pointer::text(instantiationToken)) };
    make((messages, loggingOn), "ModelExchange", || {
        let model = model(name, token)?;
        if !model.model_exchange {
            return Err(NoInstance::because(format_args!("{} {}", model.name, setup::ONLY_CO_SIMULATION)));
        }
        instantiate(model, Purpose::ModelExchange, messages, loggingOn, Stepping::none())
    })
}

/// Makes an instance for co-simulation, as fmi3InstantiateModelExchange does.
///
/// With `eventModeUsed` a step reports that results have jumped; it ends there if `earlyReturnAllowed`. `intermediateUpdate`
/// may be NULL; if it is not, it is called within each step, and can then read `requiredIntermediateVariables`, which must
/// be continuous.
///
/// # Safety
/// Texts must be NULL or zero-terminated; `requiredIntermediateVariables` must have `nRequiredIntermediateVariables`
/// elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3InstantiateCoSimulation(
    instanceName: fmi3String,
    instantiationToken: fmi3String,
    _resourcePath: fmi3String,
    _visible: fmi3Boolean,
    loggingOn: fmi3Boolean,
    eventModeUsed: fmi3Boolean,
    earlyReturnAllowed: fmi3Boolean,
    requiredIntermediateVariables: *const fmi3ValueReference,
    nRequiredIntermediateVariables: usize,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: fmi3LogMessageCallback,
    intermediateUpdate: fmi3IntermediateUpdateCallback,
) -> fmi3Instance {
    let messages = Messages { environment: instanceEnvironment, callback: logMessage };
    // SAFETY: the caller promises NULL or zero-terminated texts, and that many elements.
    let (name, token, required) = unsafe {
        let required =
            array(requiredIntermediateVariables, nRequiredIntermediateVariables, "requiredIntermediateVariables");
        (pointer::text(instanceName), pointer::text(instantiationToken), required)
    };
    make((messages, loggingOn), "CoSimulation", || {
        let model = model(name, token)?;
        let (has_event_mode, may_return_early) = (eventModeUsed != fmi3False, earlyReturnAllowed != fmi3False);
        let has_trials = has_event_mode || intermediateUpdate.is_some();
        let stepping = Stepping {
            has_event_mode,
            may_return_early,
            update: intermediateUpdate,
            environment: instanceEnvironment,
            required: memory::copied(required.map_err(NoInstance::because)?)?,
            trial: if has_trials { Some(memory::boxed(Trial::of(model)?)?) } else { None },
        };
        let component = instantiate(model, Purpose::CoSimulation, messages, loggingOn, stepping)?;
        check_required(&component)?;
        Ok(component)
    })
}

/// Returns NULL, and with `loggingOn` logs the reason: no model has partitions to be scheduled.
///
/// # Safety
/// `logMessage` must be NULL or the importer's logger.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3InstantiateScheduledExecution(
    _instanceName: fmi3String,
    _instantiationToken: fmi3String,
    _resourcePath: fmi3String,
    _visible: fmi3Boolean,
    loggingOn: fmi3Boolean,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: fmi3LogMessageCallback,
    _clockUpdate: fmi3ClockUpdateCallback,
    _lockPreemption: fmi3LockPreemptionCallback,
    _unlockPreemption: fmi3UnlockPreemptionCallback,
) -> fmi3Instance {
    let messages = Messages { environment: instanceEnvironment, callback: logMessage };
    let why = "no model has partitions that can be scheduled; co-simulation is available";
    make((messages, loggingOn), "ScheduledExecution", || Err(NoInstance::because(why)))
}

/// Makes an instance, or returns NULL and logs why there is none.
fn make(
    (messages, is_logged): (Messages, fmi3Boolean),
    kind: &str,
    body: impl FnOnce() -> Result<Box<Component>, NoInstance>,
) -> fmi3Instance {
    let mut why = Line::EMPTY;
    let instance = made(kind, body, &mut why);
    if instance.is_null() && is_logged != fmi3False {
        // The logger may throw: there is nothing to clean up, see `Log`.
        // SAFETY: the importer's logger.
        unsafe { messages.send(Level::Error, &log::ERROR, why.text()) };
    }
    instance
}

/// The part of [`make`] before any message is logged.
#[inline(never)]
fn made(kind: &str, body: impl FnOnce() -> Result<Box<Component>, NoInstance>, line: &mut Line) -> fmi3Instance {
    match guard::make(body) {
        Ok(component) => Box::into_raw(component).cast(),
        Err(NoInstance(why)) => {
            line.write(format_args!("fmi3Instantiate{kind}: {why}"));
            null_mut()
        }
    }
}

fn model(name: Option<&CStr>, token: Option<&CStr>) -> Result<&'static ModelType, NoInstance> {
    setup::check_name(name.unwrap_or_default())?;
    setup::model(token, ["instantiationToken", "instantiationToken"])
}

fn instantiate(
    model: &'static ModelType,
    purpose: Purpose,
    messages: Messages,
    debug: fmi3Boolean,
    stepping: Stepping,
) -> Result<Box<Component>, NoInstance> {
    let own = Own::of(model, stepping)?;
    let mut instance = setup::instance(model, purpose)?;
    instance.order_continuous_states(|column| own.layout.order(column));
    Ok(memory::boxed(Component::new(instance, purpose, Log::strict(messages, debug != fmi3False), own))?)
}

/// Whether it is a continuous input or output.
fn is_port(variable: &Variable) -> bool {
    (variable.role == Role::Input || variable.role.is_output()) && !variable.jumps
}

/// Refuses variables that cannot be read within a step.
fn check_required(component: &Component) -> Result<(), NoInstance> {
    let table = component.instance.model().table;
    for reference in &component.own.stepping.required {
        let elements = component.elements(*reference);
        let is_continuous = elements.is_ok_and(|elements| match elements.first() {
            Item::Column(column) => is_port(&table.at(column)),
            _ => false,
        });
        if !is_continuous {
            return Err(NoInstance::because(format_args!(
                "required intermediate variable {reference} does not belong to a continuous input or output"
            )));
        }
    }
    Ok(())
}

/// Frees an instance. NULL is ignored.
///
/// # Safety
/// `instance` must be NULL or an instance that is not used afterwards, not even by a step that is in its callback.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3FreeInstance(instance: fmi3Instance) {
    // SAFETY: the caller's promise. Freeing runs no code of a model, so there is no panic to catch.
    drop(unsafe { component::take(instance) });
}

/// Switches log categories (`logStatusWarning`, `logStatusDiscard`, `logStatusError`, `logAll`); all of them if
/// `nCategories` is 0. Before this call, `loggingOn` of the function that made the instance decides for all of them.
///
/// # Safety
/// `instance` as for every call on an instance; `categories` must hold `nCategories` zero-terminated texts.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetDebugLogging(
    instance: fmi3Instance,
    loggingOn: fmi3Boolean,
    nCategories: usize,
    categories: *const fmi3String,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises `nCategories` pointers to texts.
        unsafe { setup::switch_log(component, loggingOn != fmi3False, array(categories, nCategories, "categories")?) }
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::SetDebugLogging, body) }
}

/// Runs `body`, then enters `state`.
unsafe fn go(
    instance: fmi3Instance,
    call: Call,
    state: State,
    body: impl FnOnce(&mut Component) -> Outcome,
) -> fmi3Status {
    let body = |component: &mut Component| {
        body(component)?;
        component.state = state;
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, call, body) }
}

/// Enters Configuration Mode, in which the sizes of arrays are set.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EnterConfigurationMode(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| match component.own.layout.sizes.is_empty() {
        false => Ok(()),
        true => refuse(format_args!("{} has no structural parameters", component.instance.model().name)),
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { go(instance, Call::EnterConfigurationMode, State::ConfigurationMode, body) }
}

/// Leaves Configuration Mode; arrays have their new sizes.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3ExitConfigurationMode(instance: fmi3Instance) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { go(instance, Call::ExitConfigurationMode, State::Instantiated, |_| Ok(())) }
}

/// Declares start time and, if defined, stop time, which no step may exceed, and enters Initialization Mode, in which
/// inputs are set and outputs read at the start time. The tolerance is only checked: the steps are exact or keep a tighter
/// tolerance of their own.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3EnterInitializationMode(
    instance: fmi3Instance,
    toleranceDefined: fmi3Boolean,
    tolerance: fmi3Float64,
    startTime: fmi3Float64,
    stopTimeDefined: fmi3Boolean,
    stopTime: fmi3Float64,
) -> fmi3Status {
    let body = |component: &mut Component| {
        let tolerance = (toleranceDefined != fmi3False).then_some(tolerance);
        setup::set_up(component, tolerance, startTime, (stopTimeDefined != fmi3False).then_some(stopTime))
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { go(instance, Call::EnterInitializationMode, State::InitializationMode, body) }
}

/// Ends the initialization: parameters must now fit together, no more elements of an array be in use than it has, outputs
/// be finite. Model Exchange continues in Event Mode, where the first fmi3UpdateDiscreteStates reports whether states
/// jumped; so does co-simulation if `eventModeUsed`.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3ExitInitializationMode(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| {
        component.check_all()?;
        component.instance.refresh_to(Computed::Main)?;
        component.begin();
        component.state = match component.purpose {
            Purpose::CoSimulation if component.own.stepping.has_event_mode => State::EventMode,
            Purpose::CoSimulation => State::StepMode,
            Purpose::ModelExchange => {
                component.has_jumped = component.instance.at_event()?;
                State::EventMode
            }
        };
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::ExitInitializationMode, body) }
}

/// Ends the simulation run. Results can still be read.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3Terminate(instance: fmi3Instance) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { go(instance, Call::Terminate, State::Terminated, |_| Ok(())) }
}

/// Resets to the state after the instance was made: start values, sizes of arrays too, no experiment, time 0. Log settings
/// are kept.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3Reset(instance: fmi3Instance) -> fmi3Status {
    let body = |component: &mut Component| {
        component.instance.reset();
        component.experiment = Experiment::NONE;
        component.has_jumped = false;
        let layout = &mut component.own.layout;
        layout.sizes.copy_from_slice(&layout.most);
        Ok(())
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { go(instance, Call::Reset, State::Instantiated, body) }
}
