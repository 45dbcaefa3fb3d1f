//! Getting and setting variables.

use std::slice::{from_raw_parts, from_raw_parts_mut};

use super::component::{self, Component, Outcome, Refusal, Types, enter, refuse};
use super::lifecycle::{Call, State};
use super::types::fmi2Status::fmi2OK;
use super::types::*;
use crate::component::Lifecycle;
use crate::guard::pointer::{array, array_mut};
use stribeck::model::{BaseType, Computed, Fault, ModelType, Role, Variable};
use stribeck::reference::Place;

/// View of a column as one of FMI's base types.
trait Base {
    type Value: Copy;
    const TYPE: BaseType;
    fn to_number(value: Self::Value) -> f64;
    fn from_number(number: f64) -> Self::Value;
}

struct Real;
struct Integer;
struct Boolean;

impl Base for Real {
    type Value = fmi2Real;
    const TYPE: BaseType = BaseType::Real;
    #[inline(always)]
    fn to_number(value: fmi2Real) -> f64 {
        value
    }
    #[inline(always)]
    fn from_number(number: f64) -> fmi2Real {
        number
    }
}

impl Base for Integer {
    type Value = fmi2Integer;
    const TYPE: BaseType = BaseType::Integer;
    fn to_number(value: fmi2Integer) -> f64 {
        f64::from(value)
    }
    fn from_number(number: f64) -> fmi2Integer {
        number as fmi2Integer
    }
}

impl Base for Boolean {
    type Value = fmi2Boolean;
    const TYPE: BaseType = BaseType::Boolean;
    fn to_number(value: fmi2Boolean) -> f64 {
        f64::from(value)
    }
    fn from_number(number: f64) -> fmi2Boolean {
        fmi2Boolean::from(number != 0.0)
    }
}

impl Component {
    /// The column or other quantity with this value reference; derivatives only of the states that a solver integrates.
    #[inline]
    fn place(&self, reference: fmi2ValueReference) -> Option<Place> {
        let is_known = |place: &Place| match place {
            Place::Derivative(state) => self.instance.continuous_states().contains(state),
            Place::Column(_) | Place::Time => true,
        };
        self.instance.model().place(reference).filter(is_known)
    }

    /// The column of a value reference; an error if it is of another type, or if there is none.
    fn column<B: Base>(&self, reference: fmi2ValueReference) -> Result<usize, Refusal> {
        match self.place(reference) {
            Some(Place::Column(column)) if self.instance.model().table.base_type(column) == B::TYPE => Ok(column),
            _ => Err(wrong_reference(self, reference, B::TYPE)),
        }
    }

    /// The same, or any column as Real in an instance of an FMU that has no other type.
    fn shown_as<B: Base>(&self, reference: fmi2ValueReference) -> Result<usize, Refusal> {
        match self.place(reference) {
            Some(Place::Column(column)) if self.own == Types::Real && B::TYPE == BaseType::Real => Ok(column),
            _ => self.column::<B>(reference),
        }
    }

    fn variable(&self, column: usize) -> Variable {
        self.instance.model().table.at(column)
    }

    /// The results that must follow the other columns before these variables can be read.
    fn needs(&self, references: &[fmi2ValueReference]) -> Computed {
        let needs = |reference: &fmi2ValueReference| match self.place(*reference) {
            Some(Place::Column(column)) => self.instance.model().table.needs(column),
            _ => Computed::Nothing,
        };
        references.iter().map(needs).max().unwrap_or(Computed::Nothing)
    }

    /// Whether it is the time derivative of a state.
    fn is_derivative(&self, reference: fmi2ValueReference) -> bool {
        matches!(self.place(reference), Some(Place::Derivative(_)))
    }
}

/// The column with this value reference.
#[inline(always)]
fn column_of(model: &ModelType, reference: fmi2ValueReference) -> Option<usize> {
    match model.place(reference) {
        Some(Place::Column(column)) => Some(column),
        _ => None,
    }
}

fn wrong_reference(component: &Component, reference: fmi2ValueReference, wanted: BaseType) -> Refusal {
    match component.place(reference) {
        None => Refusal::error(format_args!("value reference {reference} does not belong to any variable")),
        Some(Place::Column(column)) => {
            let name = &component.variable(column).path;
            Refusal::error(format_args!("{name} (value reference {reference}) is not of type {wanted:?}"))
        }
        Some(Place::Time | Place::Derivative(_)) => {
            let text = "is time or a derivative, which this call does not take";
            Refusal::error(format_args!("value reference {reference} {text}"))
        }
    }
}

/// Reads `n` variables. After an error the values must not be used.
#[inline(never)]
unsafe fn get<B: Base>(
    c: fmi2Component,
    call: Call,
    vr: *const fmi2ValueReference,
    n: usize,
    value: *mut B::Value,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the importer promises `n` value references and room for `n` values.
        let (references, values) = unsafe { (array(vr, n, "vr")?, array_mut(value, n, "value")?) };
        references.iter().try_for_each(|reference| check_readable::<B>(component, *reference))?;
        refresh(component, references)?;
        read::<B>(component, references, values)
    };
    // SAFETY: the importer's promise about `c`.
    unsafe { enter(c, call, body) }
}

/// Refuses a reference that is not to a variable of this type. Time and derivatives are Real.
fn check_readable<B: Base>(component: &Component, reference: fmi2ValueReference) -> Outcome {
    match component.place(reference) {
        Some(Place::Time | Place::Derivative(_)) if B::TYPE == BaseType::Real => Ok(()),
        _ => component.shown_as::<B>(reference).map(|_| ()),
    }
}

/// Computes what the references need.
fn refresh(component: &mut Component, references: &[fmi2ValueReference]) -> Outcome {
    let needed = component.needs(references);
    let refreshed = match component.state {
        // After an error the last results are read, for debugging; advice may not be among them yet.
        State::Error if needed == Computed::All => component.instance.compute_advice(),
        State::Error => Ok(()),
        _ => component.instance.refresh_to(needed),
    };
    refreshed.map_err(|fault| component.out_of_domain(fault))
}

/// Reads variables whose results have been computed.
fn read<B: Base>(component: &mut Component, references: &[fmi2ValueReference], values: &mut [B::Value]) -> Outcome {
    let (model, time) = (component.instance.model(), component.instance.time());
    if references.iter().any(|reference| component.is_derivative(*reference)) {
        let rates = component.instance.rates();
        let rates = rates.map_err(|fault| Refusal::out_of_domain(component.state.is_tried(), fault))?;
        for (reference, value) in references.iter().zip(&mut *values) {
            if let Some(Place::Derivative(state)) = model.place(*reference) {
                *value = B::from_number(rates[state]);
            }
        }
    }
    for (reference, value) in references.iter().zip(values) {
        match model.place(*reference) {
            Some(Place::Column(column)) => *value = B::from_number(component.instance.row()[column]),
            Some(Place::Time) => *value = B::from_number(time),
            Some(Place::Derivative(_)) | None => {}
        }
    }
    Ok(())
}

/// Writes `n` variables: all, or none if one is refused.
#[inline(never)]
unsafe fn set<B: Base>(
    c: fmi2Component,
    call: Call,
    vr: *const fmi2ValueReference,
    n: usize,
    value: *const B::Value,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the importer promises `n` value references and `n` values.
        let (references, values) = unsafe { (array(vr, n, "vr")?, array(value, n, "value")?) };
        references.iter().try_for_each(|reference| component.shown_as::<B>(*reference).map(drop))?;
        let model = component.instance.model();
        let columns = references.iter().filter_map(|reference| column_of(model, *reference));
        let values = columns.zip(values.iter().map(|value| B::to_number(*value)));
        component.instance.set_all(component.state.phase(), values).map_err(|refused| component.refusal(refused))
    };
    // SAFETY: the importer's promise about `c`.
    unsafe { enter(c, call, body) }
}

/// The fast path of fmi2GetReal: results that need no computing. False if there is anything else among them; the values
/// written so far are then overwritten by the slow path, or must not be used.
///
/// # Safety
/// `vr` and `value` must be NULL or have `n` elements.
#[inline(always)]
unsafe fn read_at_once(component: &Component, vr: *const fmi2ValueReference, n: usize, value: *mut fmi2Real) -> bool {
    if n == 0 || vr.is_null() || value.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(vr, n), from_raw_parts_mut(value, n)) };
    component.instance.read_at_once(references, values)
}

/// The fast path of fmi2SetReal: admitted values of inputs with no rule but their range. False, with nothing changed,
/// if there is anything else among them.
///
/// # Safety
/// `vr` and `value` must be NULL or have `n` elements.
#[inline(always)]
unsafe fn write_at_once(
    component: &mut Component,
    vr: *const fmi2ValueReference,
    n: usize,
    value: *const fmi2Real,
) -> bool {
    if n == 0 || vr.is_null() || value.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(vr, n), from_raw_parts(value, n)) };
    component.instance.write_at_once(references, values)
}

/// Reads Real variables.
///
/// # Safety
/// `c` as for every call on an instance; `vr` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Real,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe {
        if let Some(component) = component::stepping(c)
            && read_at_once(component, vr, nvr, value)
        {
            return fmi2OK;
        }
        get::<Real>(c, Call::GetReal, vr, nvr, value)
    }
}

/// Reads Integer and Enumeration variables.
///
/// # Safety
/// As for fmi2GetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetInteger(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Integer,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { get::<Integer>(c, Call::GetInteger, vr, nvr, value) }
}

/// Reads Boolean variables.
///
/// # Safety
/// As for fmi2GetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetBoolean(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Boolean,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { get::<Boolean>(c, Call::GetBoolean, vr, nvr, value) }
}

/// Reads String variables; no model has any, so only `nvr` = 0 succeeds.
///
/// # Safety
/// As for fmi2GetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    _value: *mut fmi2String,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { enter(c, Call::GetString, |_| no_strings(vr, nvr)) }
}

/// Sets Real variables: all, or none if one is refused. fmi2Discard if a value is outside its bound.
///
/// # Safety
/// `c` as for every call on an instance; `vr` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Real,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe {
        if let Some(component) = component::stepping(c)
            && write_at_once(component, vr, nvr, value)
        {
            return fmi2OK;
        }
        set::<Real>(c, Call::SetReal, vr, nvr, value)
    }
}

/// Sets Integer and Enumeration variables, as fmi2SetReal does.
///
/// # Safety
/// As for fmi2SetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetInteger(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Integer,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { set::<Integer>(c, Call::SetInteger, vr, nvr, value) }
}

/// Sets Boolean variables, as fmi2SetReal does; only `fmi2False` and `fmi2True` are accepted.
///
/// # Safety
/// As for fmi2SetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetBoolean(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Boolean,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { set::<Boolean>(c, Call::SetBoolean, vr, nvr, value) }
}

/// Sets String variables; no model has any, so only `nvr` = 0 succeeds.
///
/// # Safety
/// As for fmi2SetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    _value: *const fmi2String,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { enter(c, Call::SetString, |_| no_strings(vr, nvr)) }
}

fn no_strings(vr: *const fmi2ValueReference, n: usize) -> Outcome {
    // SAFETY: the importer promises `n` value references.
    match unsafe { array(vr, n, "vr") }? {
        [] => Ok(()),
        [reference, ..] => refuse(format_args!("value reference {reference} does not belong to any String variable")),
    }
}

fn set_slopes(component: &mut Component, references: &[fmi2ValueReference], orders: &[i32], values: &[f64]) -> Outcome {
    for ((reference, order), value) in references.iter().zip(orders).zip(values) {
        let column = component.column::<Real>(*reference)?;
        component.instance.check_slope(column, *value).map_err(|refused| component.refusal(refused))?;
        if *order != 1 {
            let path = component.variable(column).path;
            return refuse(format_args!("order {order} of {path}: only order 1 is supported"));
        }
    }
    for (reference, value) in references.iter().zip(values) {
        let column = component.column::<Real>(*reference)?;
        component.instance.set_slope(column, *value).map_err(|refused| component.refusal(refused))?;
    }
    Ok(())
}

/// Gives inputs a slope over the next step (order 1 only). It is used for that step, and then forgotten.
///
/// # Safety
/// `c` as for every call on an instance; `vr`, `order` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetRealInputDerivatives(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    order: *const fmi2Integer,
    value: *const fmi2Real,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises `nvr` elements in each array.
        let (references, orders, values) =
            unsafe { (array(vr, nvr, "vr")?, array(order, nvr, "order")?, array(value, nvr, "value")?) };
        set_slopes(component, references, orders, values)
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetRealInputDerivatives, body) }
}

/// Time derivatives of outputs at the present time: order 1 exact, higher orders 0 as the standard requires.
///
/// # Safety
/// `c` as for every call on an instance; `vr`, `order` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetRealOutputDerivatives(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    order: *const fmi2Integer,
    value: *mut fmi2Real,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises `nvr` elements in each array.
        let (references, orders, values) =
            unsafe { (array(vr, nvr, "vr")?, array(order, nvr, "order")?, array_mut(value, nvr, "value")?) };
        write_slopes(component, references, orders, values)
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetRealOutputDerivatives, body) }
}

/// An output that has derivatives; `otherwise` says why another variable is refused.
fn differentiated(component: &Component, reference: fmi2ValueReference, otherwise: &str) -> Result<Variable, Refusal> {
    let variable = component.variable(component.column::<Real>(reference)?);
    if !variable.role.is_output() {
        return refuse(format_args!("{} {otherwise}", variable.path));
    }
    variable.check_derivatives().map_err(|fault| Refusal::Discard(fault.0))?;
    Ok(variable)
}

/// Writes the time derivatives of outputs.
fn write_slopes(
    component: &mut Component,
    references: &[fmi2ValueReference],
    orders: &[fmi2Integer],
    values: &mut [fmi2Real],
) -> Outcome {
    for (reference, order) in references.iter().zip(orders) {
        let variable = differentiated(component, *reference, "is not an output")?;
        if *order < 1 {
            return refuse(format_args!("order {order} of {}: must be >= 1", variable.path));
        }
    }
    component.instance.refresh_to(Computed::Main)?;
    let model = component.instance.model();
    let derivative = component.instance.time_derivative();
    let columns = || references.iter().filter_map(|reference| column_of(model, *reference));
    if let Some(column) = columns().find(|column| !derivative[*column].slope.is_finite()) {
        return refuse(format_args!("the derivative of {} is not finite", model.table.at(column).path));
    }
    for ((column, order), value) in columns().zip(orders).zip(values) {
        *value = if *order == 1 { derivative[column].slope } else { 0.0 };
    }
    Ok(())
}

/// Refuses derivatives that do not exist.
fn check_directions(component: &Component, unknowns: &[fmi2ValueReference], knowns: &[fmi2ValueReference]) -> Outcome {
    for reference in unknowns.iter().filter(|reference| !component.is_derivative(**reference)) {
        differentiated(component, *reference, "is neither an output nor a derivative")?;
    }
    for reference in knowns {
        let variable = component.variable(component.column::<Real>(*reference)?);
        if variable.role == Role::Output {
            let text = "is computed: nothing can be differentiated with respect to it";
            return refuse(format_args!("{} {text}", variable.path));
        }
    }
    Ok(())
}

/// Writes the derivatives in the direction given by `seeds` (column, component).
fn write_derivatives(
    component: &mut Component,
    unknowns: &[fmi2ValueReference],
    seeds: impl Iterator<Item = (usize, f64)>,
    result: &mut [f64],
) -> Outcome {
    let (model, state) = (component.instance.model(), component.state);
    component.instance.refresh_to(component.needs(unknowns)).map_err(|fault| component.out_of_domain(fault))?;
    let (outputs, rates) = if unknowns.iter().any(|reference| component.is_derivative(*reference)) {
        component.instance.rates().map_err(|fault| Refusal::out_of_domain(state.is_tried(), fault))?;
        component.instance.derivatives(seeds)
    } else {
        (component.instance.derivative(seeds), &[][..])
    };
    let slope = |reference: &fmi2ValueReference| match model.place(*reference) {
        Some(Place::Derivative(state)) => rates[state].slope,
        Some(Place::Column(column)) => outputs[column].slope,
        Some(Place::Time) | None => 0.0,
    };
    if let Some(reference) = unknowns.iter().find(|unknown| !slope(unknown).is_finite()) {
        let text = format_args!("the derivative of value reference {reference} is not finite");
        return Err(Refusal::out_of_domain(state.is_tried(), Fault::new(text)));
    }
    for (reference, value) in unknowns.iter().zip(result) {
        *value = slope(reference);
    }
    Ok(())
}

/// Derivative of outputs, and of the time derivatives of the states, in a direction of inputs, parameters and states:
/// exact, by automatic differentiation, except for the friction of ShockAbsorber before the run, which is
/// differentiated numerically.
///
/// # Safety
/// `c` as for every call on an instance; the arrays must have `nUnknown` and `nKnown` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetDirectionalDerivative(
    c: fmi2Component,
    vUnknown_ref: *const fmi2ValueReference,
    nUnknown: usize,
    vKnown_ref: *const fmi2ValueReference,
    nKnown: usize,
    dvKnown: *const fmi2Real,
    dvUnknown: *mut fmi2Real,
) -> fmi2Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises `nUnknown` and `nKnown` elements.
        let (unknowns, knowns, seed, result) = unsafe {
            (
                array(vUnknown_ref, nUnknown, "vUnknown_ref")?,
                array(vKnown_ref, nKnown, "vKnown_ref")?,
                array(dvKnown, nKnown, "dvKnown")?,
                array_mut(dvUnknown, nUnknown, "dvUnknown")?,
            )
        };
        check_directions(component, unknowns, knowns)?;
        let model = component.instance.model();
        let columns = knowns.iter().filter_map(|reference| column_of(model, *reference));
        write_derivatives(component, unknowns, columns.zip(seed.iter().copied()), result)
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetDirectionalDerivative, body) }
}
