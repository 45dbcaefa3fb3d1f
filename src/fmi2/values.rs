//! Getting and setting variables. The value reference is the column of the row.

use super::door::{Outcome, Refusal, Slave, array, array_mut, enter, refuse};
use super::lifecycle::{Call, State};
use super::types::*;
use crate::model::{Kind, Role, Variable};

/// How one of FMI's base types looks at a column.
trait Base {
    type Value: Copy;
    const NAME: &str;
    fn serves(kind: Kind) -> bool;
    fn to_number(value: Self::Value) -> f64;
    fn from_number(number: f64) -> Self::Value;
}

struct Real;
struct Integer;
struct Boolean;

impl Base for Real {
    type Value = fmi2Real;
    const NAME: &str = "Real";
    #[inline(always)]
    fn serves(kind: Kind) -> bool {
        matches!(kind, Kind::Real(_))
    }
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
    const NAME: &str = "Integer";
    fn serves(kind: Kind) -> bool {
        matches!(kind, Kind::Integer | Kind::Enumeration(_))
    }
    fn to_number(value: fmi2Integer) -> f64 {
        f64::from(value)
    }
    fn from_number(number: f64) -> fmi2Integer {
        number as fmi2Integer
    }
}

impl Base for Boolean {
    type Value = fmi2Boolean;
    const NAME: &str = "Boolean";
    fn serves(kind: Kind) -> bool {
        matches!(kind, Kind::Boolean)
    }
    fn to_number(value: fmi2Boolean) -> f64 {
        f64::from(value)
    }
    fn from_number(number: f64) -> fmi2Boolean {
        fmi2Boolean::from(number != 0.0)
    }
}

impl Slave {
    /// The variable behind a value reference; an error if there is none or if it is of another base type.
    #[inline(always)]
    fn variable<B: Base>(&self, reference: fmi2ValueReference) -> Result<&'static Variable, Refusal> {
        match self.instance.variable(reference as usize) {
            Some(variable) if B::serves(variable.kind) => Ok(variable),
            other => Err(wrong_reference(reference, B::NAME, other)),
        }
    }

    /// The independent variable `time` has the value reference behind the last column.
    #[inline(always)]
    fn is_time(&self, reference: fmi2ValueReference) -> bool {
        reference as usize == self.instance.model().table.len()
    }

    /// FMI 2.0.5 section 4.2.4, conditions 1, 3 and 6 of the table: what may be set in this state.
    #[inline(always)]
    fn may_set(&self, variable: &Variable) -> Outcome {
        let may = match self.state {
            State::StepComplete => matches!(variable.role, Role::Input | Role::Tunable),
            _ => variable.role != Role::Output,
        };
        if may { Ok(()) } else { Err(not_settable(self.state, variable)) }
    }
}

#[cold]
fn wrong_reference(reference: fmi2ValueReference, wanted: &str, found: Option<&Variable>) -> Refusal {
    Refusal::Error(match found {
        None => format!("value reference {reference} is that of no {wanted} variable"),
        Some(variable) => format!("{} (value reference {reference}) is not of type {wanted}", variable.path),
    })
}

#[cold]
fn not_settable(state: State, variable: &Variable) -> Refusal {
    Refusal::Error(match variable.role {
        Role::Output => format!("{} is computed and cannot be set", variable.path),
        _ => format!("{} is neither input nor tunable and cannot be set in state {state:?}", variable.path),
    })
}

/// Reads `n` variables; writes the results only if all can be read.
#[inline(always)]
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
            if !(slave.is_time(*reference) && B::NAME == Real::NAME) {
                slave.variable::<B>(*reference)?;
            }
        }
        slave.instance.refresh()?;
        for (reference, value) in references.iter().zip(values) {
            *value = B::from_number(match slave.is_time(*reference) {
                true => slave.instance.time(),
                false => slave.instance.row()[*reference as usize],
            });
        }
        Ok(())
    };
    // SAFETY: the importer's promise about `c`.
    unsafe { enter(c, call, body) }
}

/// Writes `n` variables: all, or none if one is refused.
#[inline(always)]
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
        for (reference, value) in references.iter().zip(values) {
            let variable = slave.variable::<B>(*reference)?;
            slave.may_set(variable)?;
            let number = B::to_number(*value);
            if !variable.admits(number) {
                return Err(Refusal::Discard(variable.fault(number).0));
            }
        }
        for (reference, value) in references.iter().zip(values) {
            slave.instance.put(*reference as usize, B::to_number(*value));
        }
        Ok(())
    };
    // SAFETY: the importer's promise about `c`.
    unsafe { enter(c, call, body) }
}

/// Reads Real variables.
///
/// # Safety
/// `c` as for every call on an instance; `vr` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Real,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { get::<Real>(c, Call::GetReal, vr, nvr, value) }
}

/// Reads Integer and Enumeration variables.
///
/// # Safety
/// As for fmi2GetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
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
pub unsafe extern "C" fn fmi2GetBoolean(
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
pub unsafe extern "C" fn fmi2GetString(
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
pub unsafe extern "C" fn fmi2SetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Real,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { set::<Real>(c, Call::SetReal, vr, nvr, value) }
}

/// Sets Integer and Enumeration variables, as fmi2SetReal does.
///
/// # Safety
/// As for fmi2SetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Integer,
) -> fmi2Status {
    // SAFETY: the caller's promises.
    unsafe { set::<Integer>(c, Call::SetInteger, vr, nvr, value) }
}

/// Sets Boolean variables, as fmi2SetReal does; only `fmi2False` and `fmi2True` are taken.
///
/// # Safety
/// As for fmi2SetReal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
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
pub unsafe extern "C" fn fmi2SetString(
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
        [reference, ..] => refuse(format!("value reference {reference} is that of no String variable")),
    }
}

/// Gives inputs a slope over the next step (order 1 only). It is used for that step, and then forgotten.
///
/// # Safety
/// `c` as for every call on an instance; `vr`, `order` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
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
            let variable = slave.variable::<Real>(*reference)?;
            if variable.role != Role::Input {
                return refuse(format!("{} is not an input", variable.path));
            }
            if *order != 1 {
                return refuse(format!("order {order} of {}: only order 1 is taken", variable.path));
            }
            if !value.is_finite() {
                return Err(Refusal::Discard(format!("derivative of {} = {value}: must be finite", variable.path)));
            }
        }
        for (reference, value) in references.iter().zip(values) {
            slave.instance.put_slope(*reference as usize, *value);
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::SetRealInputDerivatives, body) }
}

/// Time derivatives of outputs at the present time: order 1 exact, higher orders 0 as the standard asks.
///
/// # Safety
/// `c` as for every call on an instance; `vr`, `order` and `value` must have `nvr` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
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
            let variable = slave.variable::<Real>(*reference)?;
            if !variable.role.is_output() {
                return refuse(format!("{} is not an output", variable.path));
            }
            if *order < 1 {
                return refuse(format!("order {order} of {}: must be >= 1", variable.path));
            }
        }
        slave.instance.refresh()?;
        let derivative = slave.instance.time_derivative();
        let first = |reference: &fmi2ValueReference| derivative[*reference as usize].slope;
        if let Some(reference) = references.iter().find(|reference| !first(reference).is_finite()) {
            return refuse(format!("the derivative of value reference {reference} is not finite"));
        }
        for ((reference, order), value) in references.iter().zip(orders).zip(values) {
            *value = if *order == 1 { first(reference) } else { 0.0 };
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetRealOutputDerivatives, body) }
}

/// Derivative of outputs in a direction of inputs, parameters and states: exact, by automatic differentiation.
///
/// # Safety
/// `c` as for every call on an instance; the arrays must have `nUnknown` and `nKnown` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
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
        for reference in unknowns {
            let variable = slave.variable::<Real>(*reference)?;
            if !variable.role.is_output() {
                return refuse(format!("{} is not an output", variable.path));
            }
        }
        for reference in knowns {
            let variable = slave.variable::<Real>(*reference)?;
            if variable.role == Role::Output {
                return refuse(format!("{} is computed: outputs are differentiated, not varied", variable.path));
            }
        }
        slave.instance.refresh()?;
        let seeds = knowns.iter().map(|reference| *reference as usize).zip(seed.iter().copied());
        let derivative = slave.instance.derivative(seeds);
        if let Some(reference) = unknowns.iter().find(|unknown| !derivative[**unknown as usize].slope.is_finite()) {
            return refuse(format!("the derivative of value reference {reference} is not finite"));
        }
        for (reference, value) in unknowns.iter().zip(result) {
            *value = derivative[*reference as usize].slope;
        }
        Ok(())
    };
    // SAFETY: the caller's promise about `c`.
    unsafe { enter(c, Call::GetDirectionalDerivative, body) }
}
