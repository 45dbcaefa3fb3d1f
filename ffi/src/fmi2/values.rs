//! Getting and setting variables.

use std::slice::{from_raw_parts, from_raw_parts_mut};

use super::door::{self, Outcome, Refusal, Slave, enter, refuse};
use super::lifecycle::{Call, Purpose, State};
use super::types::fmi2Status::fmi2OK;
use super::types::*;
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

impl Slave {
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
            Some(Place::Column(column)) if self.variable(column).kind.base_type() == B::TYPE => Ok(column),
            _ => Err(wrong_reference(self, reference, B::TYPE)),
        }
    }

    fn variable(&self, column: usize) -> &'static Variable {
        &self.instance.model().table[column]
    }

    /// The results that must follow the other columns before these variables can be read.
    fn needs(&self, references: &[fmi2ValueReference]) -> Computed {
        let needs = |reference: &fmi2ValueReference| match self.place(*reference) {
            Some(Place::Column(column)) => self.variable(column).needs(),
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

/// FMI 2.0.5, conditions of the tables in sections 3.2.3 (1, 3, 4 and 5) and 4.2.4 (1, 3 and 6): whether the variable
/// may be set in a state.
fn may_set(state: State, variable: &Variable) -> bool {
    match variable.role {
        Role::Input => true,
        Role::Tunable => state != State::ContinuousTimeMode,
        Role::State | Role::StateOutput if state == State::ContinuousTimeMode => variable.is_continuous_state(),
        Role::Fixed | Role::State | Role::StateOutput => {
            matches!(state, State::Instantiated | State::Initialization)
        }
        Role::Output => false,
    }
}

fn wrong_reference(slave: &Slave, reference: fmi2ValueReference, wanted: BaseType) -> Refusal {
    match slave.place(reference) {
        None => Refusal::error(format_args!("value reference {reference} does not belong to any variable")),
        Some(Place::Column(column)) => {
            let name = &slave.variable(column).path;
            Refusal::error(format_args!("{name} (value reference {reference}) is not of type {wanted:?}"))
        }
        Some(Place::Time | Place::Derivative(_)) => {
            let text = "is time or a derivative, which this call does not take";
            Refusal::error(format_args!("value reference {reference} {text}"))
        }
    }
}

/// Refuses a value that may not be set now, or that is not admitted by its variable.
fn check_value(slave: &Slave, variable: &Variable, value: f64) -> Outcome {
    let state = slave.state;
    if variable.role == Role::Output {
        return refuse(format_args!("{} is computed and cannot be set", variable.path));
    }
    if !may_set(state, variable) {
        let text = "cannot be set in state";
        return refuse(format_args!("{} {text} {state:?}", variable.path));
    }
    let checked = match slave.purpose {
        Purpose::CoSimulation => variable.check_for_steps(value),
        Purpose::ModelExchange if variable.admits(value) => Ok(()),
        Purpose::ModelExchange => Err(variable.fault(value)),
    };
    checked.map_err(|fault| Refusal::Discard(fault.0))
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
    let body = |slave: &mut Slave| {
        // SAFETY: the importer promises `n` value references and room for `n` values.
        let (references, values) = unsafe { (array(vr, n, "vr")?, array_mut(value, n, "value")?) };
        for reference in references {
            match slave.place(*reference) {
                Some(Place::Time | Place::Derivative(_)) if B::TYPE == BaseType::Real => {}
                _ => {
                    slave.column::<B>(*reference)?;
                }
            }
        }
        let needed = slave.needs(references);
        let refreshed = match slave.state {
            // After an error the last results are read, for debugging; advice may not be among them yet.
            State::Error if needed == Computed::All => slave.instance.compute_advice(),
            State::Error => Ok(()),
            _ => slave.instance.refresh_to(needed),
        };
        refreshed.map_err(|fault| slave.out_of_domain(fault))?;
        if references.iter().any(|reference| slave.is_derivative(*reference)) {
            slave.instance.compute_rates().map_err(|fault| slave.out_of_domain(fault))?;
        }
        let (row, rates) = (slave.instance.row(), slave.instance.rates());
        for (reference, value) in references.iter().zip(values) {
            *value = B::from_number(match slave.place(*reference) {
                Some(Place::Column(column)) => row[column],
                Some(Place::Derivative(state)) => rates[state],
                Some(Place::Time) | None => slave.instance.time(),
            });
        }
        Ok(())
    };
    // SAFETY: the importer's promise about `c`.
    unsafe { enter(c, call, body) }
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
    let body = |slave: &mut Slave| {
        // SAFETY: the importer promises `n` value references and `n` values.
        let (references, values) = unsafe { (array(vr, n, "vr")?, array(value, n, "value")?) };
        let mut parameters = false;
        for (reference, value) in references.iter().zip(values) {
            let variable = slave.variable(slave.column::<B>(*reference)?);
            check_value(slave, variable, B::to_number(*value))?;
            parameters |= variable.role.is_parameter();
        }
        let model = slave.instance.model();
        let row = slave.instance.row_to_set(parameters);
        for (reference, value) in references.iter().zip(values) {
            if let Some(column) = column_of(model, *reference) {
                row[column] = B::to_number(*value);
            }
        }
        Ok(())
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
unsafe fn read_at_once(slave: &Slave, vr: *const fmi2ValueReference, n: usize, value: *mut fmi2Real) -> bool {
    if n == 0 || vr.is_null() || value.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(vr, n), from_raw_parts_mut(value, n)) };
    let (row, model, computed) = (slave.instance.row(), slave.instance.model(), slave.instance.computed());
    for (reference, value) in references.iter().zip(values) {
        let Some(column) = column_of(model, *reference) else { return false };
        match (row.get(column), model.ports.get(column)) {
            (Some(found), Some(port)) if port.gives(computed) => *value = *found,
            _ => return false,
        }
    }
    true
}

/// The fast path of fmi2SetReal: admitted values of inputs with no rule but their range. False, with nothing changed,
/// if there is anything else among them.
///
/// # Safety
/// `vr` and `value` must be NULL or have `n` elements.
#[inline(always)]
unsafe fn write_at_once(slave: &mut Slave, vr: *const fmi2ValueReference, n: usize, value: *const fmi2Real) -> bool {
    if n == 0 || vr.is_null() || value.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(vr, n), from_raw_parts(value, n)) };
    let model = slave.instance.model();
    for (reference, value) in references.iter().zip(values) {
        let Some(column) = column_of(model, *reference) else { return false };
        if !model.ports.get(column).is_some_and(|port| port.takes(*value)) {
            return false;
        }
    }
    let row = slave.instance.row_to_set(false);
    for (reference, value) in references.iter().zip(values) {
        if let Some(column) = column_of(model, *reference)
            && let Some(place) = row.get_mut(column)
        {
            *place = *value;
        }
    }
    true
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
        if let Some(slave) = door::stepping(c)
            && read_at_once(slave, vr, nvr, value)
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
        if let Some(slave) = door::stepping(c)
            && write_at_once(slave, vr, nvr, value)
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
    let body = |slave: &mut Slave| {
        // SAFETY: the caller promises `nvr` elements in each array.
        let (references, orders, values) =
            unsafe { (array(vr, nvr, "vr")?, array(order, nvr, "order")?, array(value, nvr, "value")?) };
        for ((reference, order), value) in references.iter().zip(orders).zip(values) {
            let variable = slave.variable(slave.column::<Real>(*reference)?);
            if variable.role != Role::Input {
                return refuse(format_args!("{} is not an input", variable.path));
            }
            if *order != 1 {
                return refuse(format_args!("order {order} of {}: only order 1 is supported", variable.path));
            }
            if !value.is_finite() {
                return Err(Refusal::discard(format_args!(
                    "derivative of {} = {value}: must be finite",
                    variable.path
                )));
            }
        }
        for (reference, value) in references.iter().zip(values) {
            let column = slave.column::<Real>(*reference)?;
            slave.instance.put_slope(column, *value);
        }
        Ok(())
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
    let body = |slave: &mut Slave| {
        // SAFETY: the caller promises `nvr` elements in each array.
        let (references, orders, values) =
            unsafe { (array(vr, nvr, "vr")?, array(order, nvr, "order")?, array_mut(value, nvr, "value")?) };
        for (reference, order) in references.iter().zip(orders) {
            let variable = slave.variable(slave.column::<Real>(*reference)?);
            if !variable.role.is_output() {
                return refuse(format_args!("{} is not an output", variable.path));
            }
            variable.check_derivatives().map_err(|fault| Refusal::Discard(fault.0))?;
            if *order < 1 {
                return refuse(format_args!("order {order} of {}: must be >= 1", variable.path));
            }
        }
        slave.instance.refresh_to(Computed::Main)?;
        let model = slave.instance.model();
        let derivative = slave.instance.time_derivative();
        let columns = || references.iter().filter_map(|reference| column_of(model, *reference));
        if let Some(column) = columns().find(|column| !derivative[*column].slope.is_finite()) {
            return refuse(format_args!("the derivative of {} is not finite", model.table[column].path));
        }
        for ((column, order), value) in columns().zip(orders).zip(values) {
            *value = if *order == 1 { derivative[column].slope } else { 0.0 };
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetRealOutputDerivatives, body) }
}

impl Slave {
    /// Refuses unknowns that have no derivative.
    fn check_unknown(&self, reference: fmi2ValueReference) -> Outcome {
        let variable = self.variable(self.column::<Real>(reference)?);
        if !variable.role.is_output() {
            return refuse(format_args!("{} is neither an output nor a derivative", variable.path));
        }
        variable.check_derivatives().map_err(|fault| Refusal::Discard(fault.0))
    }

    /// Refuses results as directions.
    fn check_known(&self, reference: fmi2ValueReference) -> Outcome {
        let variable = self.variable(self.column::<Real>(reference)?);
        if variable.role == Role::Output {
            let path = variable.path;
            return refuse(format_args!("{path} is computed: nothing can be differentiated with respect to it"));
        }
        Ok(())
    }

    /// Writes the derivatives of these unknowns as computed last.
    fn read_derivatives(&self, unknowns: &[fmi2ValueReference], result: &mut [f64]) -> Outcome {
        let (outputs, rates) = self.instance.last_derivatives();
        let slope = |reference: &fmi2ValueReference| match self.place(*reference) {
            Some(Place::Derivative(state)) => rates[state].slope,
            Some(Place::Column(column)) => outputs[column].slope,
            Some(Place::Time) | None => 0.0,
        };
        if let Some(reference) = unknowns.iter().find(|unknown| !slope(unknown).is_finite()) {
            let text = format_args!("the derivative of value reference {reference} is not finite");
            return Err(self.out_of_domain(Fault::new(text)));
        }
        for (reference, value) in unknowns.iter().zip(result) {
            *value = slope(reference);
        }
        Ok(())
    }
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
    let body = |slave: &mut Slave| {
        // SAFETY: the caller promises `nUnknown` and `nKnown` elements.
        let (unknowns, knowns, seed, result) = unsafe {
            (
                array(vUnknown_ref, nUnknown, "vUnknown_ref")?,
                array(vKnown_ref, nKnown, "vKnown_ref")?,
                array(dvKnown, nKnown, "dvKnown")?,
                array_mut(dvUnknown, nUnknown, "dvUnknown")?,
            )
        };
        for reference in unknowns.iter().filter(|reference| !slave.is_derivative(**reference)) {
            slave.check_unknown(*reference)?;
        }
        for reference in knowns {
            slave.check_known(*reference)?;
        }
        slave.instance.refresh_to(slave.needs(unknowns)).map_err(|fault| slave.out_of_domain(fault))?;
        let model = slave.instance.model();
        let columns = || knowns.iter().filter_map(|reference| column_of(model, *reference));
        let seeds = || columns().zip(seed.iter().copied());
        if unknowns.iter().any(|reference| slave.is_derivative(*reference)) {
            slave.instance.compute_rates().map_err(|fault| slave.out_of_domain(fault))?;
            slave.instance.rate_derivative(seeds());
        }
        slave.instance.derivative(seeds());
        slave.read_derivatives(unknowns, result)
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetDirectionalDerivative, body) }
}
