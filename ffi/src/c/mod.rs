//! The interface for C and C++ programs that do without an FMU.
//!
//! Conventions: a function returns a [`stribeck_status`]; results are written through pointers, and only on
//! `STRIBECK_OK`. A refused call changes nothing, and [`stribeck_last_error`] says why, if there is a handle. Every
//! handle made by [`stribeck_create`] is freed once with [`stribeck_free`]; texts belong to the library.
//!
//! For every function that takes a handle, it must be NULL or a handle from [`stribeck_create`] that was not yet freed
//! and that no other thread uses during the call; every other pointer must be NULL or valid for its purpose.
#![allow(non_camel_case_types, reason = "C names")]

use std::borrow::Cow;
use std::ffi::{CStr, CString};
use std::fmt;
use std::ptr::{null, null_mut};

use libc::{c_char, c_int};

use crate::guard::pointer::{Null, name, place};
use crate::guard::{self, Handle, Internal, pointer};
use crate::models;
use stribeck::instance::{Instance, Refused};
use stribeck::memory::{self, OUT_OF_MEMORY, OutOfMemory};
use stribeck::model::{Computed, Fault, Kind, ModelType, Role, Variable};

mod run;
mod state;
mod warning;
pub use run::{stribeck_results, stribeck_run, stribeck_run_many, stribeck_samples};
pub use state::{stribeck_restore, stribeck_save, stribeck_state_size};
pub use warning::stribeck_warning;

/// Result of a call.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum stribeck_status {
    /// Success.
    STRIBECK_OK = 0,
    /// A required pointer is NULL.
    STRIBECK_NULL = 1,
    /// The model or preset does not exist.
    STRIBECK_UNKNOWN_MODEL = 2,
    /// The variable does not exist in this model, or the requested derivative is not that of a result with respect to
    /// something that can be set.
    STRIBECK_UNKNOWN_VARIABLE = 3,
    /// The value is outside the bounds of its variable, or the parameters do not fit together.
    STRIBECK_REFUSED_VALUE = 4,
    /// The variable is computed and cannot be set.
    STRIBECK_NOT_SETTABLE = 5,
    /// The result would not be finite.
    STRIBECK_NOT_FINITE = 6,
    /// The buffer is too small, or does not contain a state of this model.
    STRIBECK_BAD_BUFFER = 7,
    /// Internal error; please report it.
    STRIBECK_INTERNAL = 8,
    /// Memory has run out.
    STRIBECK_OUT_OF_MEMORY = 9,
}
use stribeck_status::*;

/// Who writes a variable.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum stribeck_role {
    /// Set by the caller before each step.
    STRIBECK_INPUT = 0,
    /// Parameter that stays constant during a run.
    STRIBECK_FIXED = 1,
    /// Parameter that may change between steps.
    STRIBECK_TUNABLE = 2,
    /// State, advanced by steps.
    STRIBECK_STATE = 3,
    /// State that is also a result.
    STRIBECK_STATE_OUTPUT = 4,
    /// Result, computed from the other variables.
    STRIBECK_OUTPUT = 5,
}
use stribeck_role::*;

/// Meaning of the number in a variable.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum stribeck_kind {
    /// A physical quantity.
    STRIBECK_REAL = 0,
    /// A whole number.
    STRIBECK_INTEGER = 1,
    /// 0 or 1.
    STRIBECK_BOOLEAN = 2,
    /// The number of a choice, from 1.
    STRIBECK_ENUMERATION = 3,
}
use stribeck_kind::*;

/// Description of a variable, as given by stribeck_describe. The texts belong to the handle and are freed with it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stribeck_variable {
    /// Name, such as `velocity` or `element[3].stiffness`.
    pub name: *const c_char,
    /// Unit, `1` for a pure number; empty if the kind is not STRIBECK_REAL.
    pub unit: *const c_char,
    /// One-line description.
    pub help: *const c_char,
    /// Who writes it.
    pub role: stribeck_role,
    /// Meaning of the number.
    pub kind: stribeck_kind,
    /// Start value.
    pub start: f64,
    /// Smallest admitted value, `-DBL_MAX` if unbounded; 1e-300 if the value must be > 0 (stiffness).
    pub min: f64,
    /// Largest admitted value, `DBL_MAX` if unbounded.
    pub max: f64,
}

/// An instance of a model. Made by stribeck_create, freed by stribeck_free.
pub struct stribeck_instance {
    instance: Instance,
    texts: Vec<[CString; 3]>,
    presets: Vec<[CString; 2]>,
    error: Cow<'static, CStr>,
    warning: Cow<'static, CStr>,
}

/// Why a call was refused: the status for the program, the text for the user.
pub(crate) struct Refusal(stribeck_status, String);

pub(crate) type Outcome = Result<(), Refusal>;

fn refuse<T>(status: stribeck_status, text: impl fmt::Display) -> Result<T, Refusal> {
    Err(Refusal::of(status, text))
}

impl Refusal {
    fn of(status: stribeck_status, text: impl fmt::Display) -> Refusal {
        Refusal(status, memory::text(text))
    }
}

fn fault(status: stribeck_status) -> impl FnOnce(Fault) -> Refusal {
    move |fault| Refusal(status, fault.0)
}

impl From<OutOfMemory> for Refusal {
    fn from(_: OutOfMemory) -> Refusal {
        // An empty text stands for lack of memory: see `enter`.
        Refusal(STRIBECK_OUT_OF_MEMORY, String::new())
    }
}

impl From<Refused> for Refusal {
    #[cold]
    fn from(refused: Refused) -> Refusal {
        match refused {
            Refused::Unknown(fault) => Refusal(STRIBECK_UNKNOWN_VARIABLE, fault.0),
            Refused::NotSettable(fault) => Refusal(STRIBECK_NOT_SETTABLE, fault.0),
            Refused::NotNow(_) => Refusal::of(STRIBECK_NOT_SETTABLE, refused),
            Refused::Value(fault) => Refusal(STRIBECK_REFUSED_VALUE, fault.0),
            Refused::NotFinite(fault) => Refusal(STRIBECK_NOT_FINITE, fault.0),
        }
    }
}

impl From<Null> for Refusal {
    #[cold]
    fn from(null: Null) -> Refusal {
        Refusal::of(STRIBECK_NULL, null)
    }
}

impl From<Internal> for Refusal {
    fn from(internal: Internal) -> Refusal {
        Refusal(STRIBECK_INTERNAL, internal.0)
    }
}

impl Handle for stribeck_instance {
    type Call = ();
    type Refusal = Refusal;
    type Status = stribeck_status;
    const OK: stribeck_status = STRIBECK_OK;

    #[inline(always)]
    fn check(&self, (): ()) -> Outcome {
        Ok(())
    }

    #[cold]
    #[inline(never)]
    fn refuse(&mut self, (): (), Refusal(status, text): Refusal) -> stribeck_status {
        let text = if text.is_empty() { Err(OutOfMemory) } else { memory::c_text(&text) };
        self.error = text.map_or(Cow::Borrowed(OUT_OF_MEMORY), Cow::Owned);
        status
    }
}

/// Runs `body` on the instance behind the handle.
///
/// # Safety
/// As in the documentation of the module.
unsafe fn enter(
    instance: *mut stribeck_instance,
    body: impl FnOnce(&mut stribeck_instance) -> Outcome,
) -> stribeck_status {
    // SAFETY: the caller's promise.
    unsafe { instance.as_mut() }.map_or(STRIBECK_NULL, |handle| guard::run(handle, (), body))
}

/// The name behind a pointer.
///
/// # Safety
/// `text` must be NULL or zero-terminated, and live as long as the result is used.
unsafe fn text<'a>(text: *const c_char, what: &'static str) -> Result<&'a str, Null> {
    // SAFETY: the caller's promise.
    unsafe { pointer::text(text) }.map(name).ok_or(Null(what))
}

/// Version of the library, such as "0.1.0".
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_version() -> *const c_char {
    const VERSION: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => c"",
    };
    VERSION.as_ptr()
}

/// Number of models of the library.
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_model_count() -> usize {
    models::all().count()
}

/// Name of the model with this index, from 0; NULL beyond the last. The text lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_model_name(index: usize) -> *const c_char {
    models::all().nth(index).map_or(null(), |model| model.c_name.as_ptr())
}

/// Meaning of a status, in a few words. The text lives as long as the library.
///
/// Takes an `int`, because a number outside the enum must be harmless.
#[unsafe(no_mangle)]
pub extern "C" fn stribeck_status_text(status: c_int) -> *const c_char {
    const TEXTS: [&CStr; 10] = [
        c"success",
        c"a pointer is NULL",
        c"unknown model or preset",
        c"unknown variable",
        c"value refused",
        c"variable cannot be set",
        c"result not finite",
        c"buffer too small, or not a state of this model",
        c"internal error",
        OUT_OF_MEMORY,
    ];
    let index = usize::try_from(status).unwrap_or(usize::MAX);
    TEXTS.get(index).unwrap_or(&c"unknown status").as_ptr()
}

/// Makes an instance at its start values and writes its handle to `*instance`, or NULL on failure. The handle must be freed
/// once with stribeck_free.
///
/// # Safety
/// `name` must be NULL or zero-terminated; `instance` must be NULL or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_create(
    name: *const c_char,
    instance: *mut *mut stribeck_instance,
) -> stribeck_status {
    // SAFETY: the caller's promises.
    let (name, place) = unsafe { (text(name, "name"), instance.as_mut()) };
    let Some(place) = place else { return STRIBECK_NULL };
    *place = null_mut();
    let Ok(name) = name else { return STRIBECK_NULL };
    let Some(model) = models::by_name(name) else { return STRIBECK_UNKNOWN_MODEL };
    match guard::make(|| make(model)) {
        Ok(made) => {
            *place = Box::into_raw(made);
            STRIBECK_OK
        }
        Err(NoModel(status)) => status,
    }
}

/// Why no instance was made.
struct NoModel(stribeck_status);

impl From<Internal> for NoModel {
    fn from(_: Internal) -> NoModel {
        NoModel(STRIBECK_INTERNAL)
    }
}

impl From<OutOfMemory> for NoModel {
    fn from(_: OutOfMemory) -> NoModel {
        NoModel(STRIBECK_OUT_OF_MEMORY)
    }
}

fn make(model: &'static ModelType) -> Result<Box<stribeck_instance>, NoModel> {
    let texts = memory::each(model.table.iter(), |variable| {
        let unit = if let Kind::Real(unit) = variable.kind { unit.name } else { "" };
        let name = memory::c_text(&memory::whole_text(variable.path)?)?;
        Ok([name, memory::c_text(unit)?, memory::c_text(variable.help)?])
    })?;
    let presets = memory::each(model.presets.iter(), |preset| {
        Ok([memory::c_text(preset.name)?, memory::c_text(preset.source)?])
    })?;
    let nothing = Cow::Borrowed(c"");
    let (error, warning) = (nothing.clone(), nothing);
    Ok(memory::boxed(stribeck_instance { instance: Instance::try_new(model)?, texts, presets, error, warning })?)
}

/// Frees an instance. NULL is ignored.
///
/// # Safety
/// The handle must not be used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_free(instance: *mut stribeck_instance) {
    if !instance.is_null() {
        // SAFETY: handles come from `Box::into_raw` in `stribeck_create`, and the caller promises that this is the last
        // use.
        drop(unsafe { Box::from_raw(instance) });
    }
}

/// Reason why the last refused call on this handle was refused. The text lives until the next call on the handle. For
/// NULL it says that the handle is NULL; the only reason given by a failed stribeck_create is its status.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_last_error(instance: *const stribeck_instance) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { instance.as_ref() }.map_or(c"the handle is NULL".as_ptr(), |handle| handle.error.as_ptr())
}

/// Resets the instance to its start values and to time 0.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_reset(instance: *mut stribeck_instance) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        handle.instance.reset();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Number of variables; 0 for NULL.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_variable_count(instance: *const stribeck_instance) -> u32 {
    // SAFETY: the caller's promise.
    unsafe { instance.as_ref() }.map_or(0, |handle| handle.instance.model().variables().count() as u32)
}

/// Reference of the variable with that index, from 0, in the order of the enums of this header.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_reference(
    instance: *mut stribeck_instance,
    index: u32,
    reference: *mut u32,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promise.
        let place = unsafe { place(reference, "reference") }?;
        let model = handle.instance.model();
        let Some((column, _)) = model.variables().nth(index as usize) else {
            let count = model.variables().count();
            let text = format_args!("{} has {count} variables, none with the index {index}", model.name);
            return refuse(STRIBECK_UNKNOWN_VARIABLE, text);
        };
        *place = model.reference(column);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Reference of the variable with this name. The enums of this header hold the same numbers.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_find(
    instance: *mut stribeck_instance,
    variable: *const c_char,
    reference: *mut u32,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promises.
        let (name, place) = unsafe { (text(variable, "variable")?, place(reference, "reference")?) };
        *place = handle.instance.model().reference(handle.instance.column_by_name(name)?);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Describes a variable: name, unit, help text, role, kind, start value and bounds.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_describe(
    instance: *mut stribeck_instance,
    reference: u32,
    variable: *mut stribeck_variable,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        let column = handle.instance.column(reference)?;
        let known = &handle.instance.model().table.at(column);
        let [min, max] = [known.bound.min(), known.bound.max()];
        // Without events no other value is accepted: see `check_for_steps`.
        let [min, max] = if known.is_settled_by_events() { [known.start; 2] } else { [min, max] };
        let [name, unit, help] = handle.texts[column].each_ref().map(|text| text.as_ptr());
        // SAFETY: the caller's promise.
        let place = unsafe { place(variable, "variable") }?;
        let (role, kind, start) = (role(known.role), kind(known.kind), known.start);
        *place = stribeck_variable { name, unit, help, role, kind, start, min, max };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

fn role(role: Role) -> stribeck_role {
    match role {
        Role::Input => STRIBECK_INPUT,
        Role::Fixed => STRIBECK_FIXED,
        Role::Tunable => STRIBECK_TUNABLE,
        Role::State => STRIBECK_STATE,
        Role::StateOutput => STRIBECK_STATE_OUTPUT,
        Role::Output => STRIBECK_OUTPUT,
    }
}

fn kind(kind: Kind) -> stribeck_kind {
    match kind {
        Kind::Real(_) => STRIBECK_REAL,
        Kind::Integer => STRIBECK_INTEGER,
        Kind::Boolean => STRIBECK_BOOLEAN,
        Kind::Enumeration(_) => STRIBECK_ENUMERATION,
    }
}

/// Number of presets, that is, named parameter sets, of the model; 0 for NULL.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_preset_count(instance: *const stribeck_instance) -> usize {
    // SAFETY: the caller's promise.
    unsafe { instance.as_ref() }.map_or(0, |handle| handle.presets.len())
}

/// Name of the preset with this index, from 0; NULL beyond the last. The text belongs to the handle.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_preset_name(instance: *const stribeck_instance, index: usize) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { preset_text(instance, index, 0) }
}

/// Source of the values of the preset with this index; NULL beyond the last. The text belongs to the handle.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_preset_source(instance: *const stribeck_instance, index: usize) -> *const c_char {
    // SAFETY: the caller's promise.
    unsafe { preset_text(instance, index, 1) }
}

/// # Safety
/// As the module says of handles.
unsafe fn preset_text(instance: *const stribeck_instance, index: usize, which: usize) -> *const c_char {
    // SAFETY: the caller's promise.
    let preset = unsafe { instance.as_ref() }.and_then(|handle| handle.presets.get(index));
    preset.map_or(null(), |texts| texts[which].as_ptr())
}

/// Sets all parameters: those in the named preset to its values, the others to their start values. Inputs in the preset
/// are set as well.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_apply_preset(
    instance: *mut stribeck_instance,
    preset: *const c_char,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promise.
        let name = unsafe { text(preset, "preset") }?;
        if !handle.instance.apply(name) {
            let model = handle.instance.model().name;
            return refuse(STRIBECK_UNKNOWN_MODEL, format_args!("{model} has no preset '{name}'"));
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Sets a variable. Everything except computed results can be set at any time; outputs follow at once.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_set(instance: *mut stribeck_instance, reference: u32, value: f64) -> stribeck_status {
    // SAFETY: the caller's promise.
    unsafe { enter(instance, |handle| Ok(handle.instance.set(reference, value)?)) }
}

/// Reads a variable; results are computed first if anything has been set since.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_get(
    instance: *mut stribeck_instance,
    reference: u32,
    value: *mut f64,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promise.
        let place = unsafe { place(value, "value") }?;
        *place = handle.instance.get(reference)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// As stribeck_set, by name. Slower: look the reference up once with stribeck_find if it is set often.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_set_by_name(
    instance: *mut stribeck_instance,
    variable: *const c_char,
    value: f64,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promise.
        let name = unsafe { text(variable, "variable") }?;
        Ok(handle.instance.set_by_name(name, value)?)
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// As stribeck_get, by name.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_get_by_name(
    instance: *mut stribeck_instance,
    variable: *const c_char,
    value: *mut f64,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        // SAFETY: the caller's promises.
        let (name, place) = unsafe { (text(variable, "variable")?, place(value, "value")?) };
        *place = handle.instance.get_by_name(name)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Advances the instance by `dt` > 0 seconds with held inputs and computes the results.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_step(instance: *mut stribeck_instance, dt: f64) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        if !(dt > 0.0 && dt.is_finite()) {
            return refuse(STRIBECK_REFUSED_VALUE, format_args!("dt = {dt}: must be > 0 and finite"));
        }
        handle.instance.check().map_err(fault(STRIBECK_REFUSED_VALUE))?;
        handle.instance.step(dt).map_err(fault(STRIBECK_NOT_FINITE))
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Computes the results now, and checks that the parameters fit together and the results are finite. Advice, such as a
/// `step_limit`, is computed when it is read.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_output(instance: *mut stribeck_instance) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        handle.instance.check().map_err(fault(STRIBECK_REFUSED_VALUE))?;
        handle.instance.refresh_to(Computed::Main).map_err(fault(STRIBECK_NOT_FINITE))
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}

/// Time since creation or reset, in seconds; NaN for NULL.
///
/// # Safety
/// As the module says of handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_time(instance: *const stribeck_instance) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { instance.as_ref() }.map_or(f64::NAN, |handle| handle.instance.time())
}

/// The result of a derivative that exists.
fn differentiable(instance: &Instance, output: usize, input: usize) -> Result<Variable, Refusal> {
    let table = instance.model().table;
    let (result, varied) = (table.at(output), table.at(input));
    if !result.role.is_output() || varied.role == Role::Output {
        let text = format_args!("{} cannot be differentiated with respect to {}", result.path, varied.path);
        return refuse(STRIBECK_UNKNOWN_VARIABLE, text);
    }
    result.check_derivatives().map_err(fault(STRIBECK_UNKNOWN_VARIABLE))?;
    Ok(result)
}

/// Partial derivative of a result with respect to an input, parameter or state, at the present values: exact, except
/// for the friction of ShockAbsorber before its first step, which is differentiated numerically.
///
/// # Safety
/// As the module says of handles and pointers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stribeck_derivative(
    instance: *mut stribeck_instance,
    output: u32,
    input: u32,
    value: *mut f64,
) -> stribeck_status {
    let body = |handle: &mut stribeck_instance| {
        let (output, input) = (handle.instance.column(output)?, handle.instance.column(input)?);
        let result = differentiable(&handle.instance, output, input)?;
        // SAFETY: the caller's promise.
        let place = unsafe { place(value, "value") }?;
        let slope = handle.instance.derivative([(input, 1.0)].into_iter())[output].slope;
        if !slope.is_finite() {
            return refuse(STRIBECK_NOT_FINITE, format_args!("the derivative of {} is not finite", result.path));
        }
        *place = slope;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { enter(instance, body) }
}
