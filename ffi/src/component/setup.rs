//! Making an instance, and its experiment.

use std::ffi::{CStr, c_char};
use std::fmt;

use super::log;
use super::{Component, Experiment, Outcome, Purpose, Refusal, Version, refuse};
use crate::guard::{Internal, pointer};
use crate::models;
use stribeck::instance::Instance;
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::ModelType;

/// Why no instance was made.
pub(crate) struct NoInstance(pub String);

impl NoInstance {
    #[cold]
    pub fn because(why: impl fmt::Display) -> NoInstance {
        NoInstance(memory::text(why))
    }
}

impl From<Internal> for NoInstance {
    fn from(internal: Internal) -> NoInstance {
        NoInstance(internal.0)
    }
}

impl From<OutOfMemory> for NoInstance {
    fn from(error: OutOfMemory) -> NoInstance {
        NoInstance::because(error)
    }
}

/// Why a model is not for Model Exchange.
pub(crate) const ONLY_CO_SIMULATION: &str = "has states that no solver can integrate and is for co-simulation only";

/// Refuses an instance without a name.
pub(crate) fn check_name(name: &CStr) -> Result<(), NoInstance> {
    if name.to_bytes().trim_ascii().is_empty() {
        return Err(NoInstance::because("instanceName is NULL or blank"));
    }
    Ok(())
}

/// The model with this guid; name of the argument, and of what it holds.
pub(crate) fn model(guid: Option<&CStr>, [argument, what]: [&str; 2]) -> Result<&'static ModelType, NoInstance> {
    let guid = pointer::name(guid.ok_or_else(|| NoInstance::because(format_args!("{argument} is NULL")))?);
    models::by_guid(guid).ok_or_else(|| {
        NoInstance::because(format_args!(
            "{what} {guid} does not belong to a model of stribeck {}: modelDescription.xml and library differ in version",
            env!("CARGO_PKG_VERSION")
        ))
    })
}

/// A model at its start values.
pub(crate) fn instance(model: &'static ModelType, purpose: Purpose) -> Result<Instance, OutOfMemory> {
    match purpose {
        Purpose::CoSimulation => Instance::try_new(model),
        Purpose::ModelExchange => Instance::try_for_model_exchange(model),
    }
}

/// Switches these categories of the log; all of them if there are none.
///
/// # Safety
/// The categories must be NULL or zero-terminated texts.
pub(crate) unsafe fn switch_log<V: Version>(
    component: &mut Component<V>,
    enabled: bool,
    categories: &[*const c_char],
) -> Outcome {
    if categories.is_empty() {
        component.log.switch(log::ALL.name, enabled);
    }
    for category in categories {
        // SAFETY: the caller promises NULL or zero-terminated texts.
        let Some(category) = (unsafe { pointer::text(*category) }) else { return refuse("a category is NULL") };
        if component.log.switch(category, enabled).is_none() {
            return refuse(format_args!("unknown log category {}", category.to_string_lossy()));
        }
    }
    Ok(())
}

/// Sets an experiment up. The tolerance is only checked: the steps are exact or keep a tighter tolerance of their own.
pub(crate) fn set_up<V: Version>(
    component: &mut Component<V>,
    tolerance: Option<f64>,
    start: f64,
    stop: Option<f64>,
) -> Outcome {
    if let Some(tolerance) = tolerance
        && !(tolerance > 0.0 && tolerance.is_finite())
    {
        return refuse(format_args!("tolerance = {tolerance}: must be > 0 and finite"));
    }
    component.experiment = experiment(start, stop)?;
    component.instance.set_time(start);
    Ok(())
}

fn experiment(start: f64, stop: Option<f64>) -> Result<Experiment, Refusal> {
    if !start.is_finite() {
        return refuse(format_args!("startTime = {start}: must be finite"));
    }
    match stop {
        Some(stop) if !(stop.is_finite() && stop >= start) => {
            refuse(format_args!("stopTime = {stop}: must be finite and >= startTime = {start}"))
        }
        _ => Ok(Experiment { is_set_up: true, start, stop: stop.unwrap_or(f64::INFINITY) }),
    }
}
