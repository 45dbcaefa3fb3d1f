//! The functions of the module.

use stribeck::instance::Phase;
use stribeck::memory;
use stribeck::model::{BaseType, Computed, Fault, Kind, Role};
use stribeck::reference::{Place, Reference};
use stribeck::serial;

use crate::law;
use crate::model::{COLUMNS, HAS_SLOPES, MODEL};
use crate::state::{self, Module, Outcome, Refusal, Status, enter, fault, refuse, refused};

/// Makes the instance, at its start values and at time 0.
#[unsafe(no_mangle)]
pub extern "C" fn model_create() -> Status {
    match Module::new() {
        Ok(module) => {
            state::place(module);
            #[cfg(target_arch = "wasm32")]
            crate::room::keep();
            enter(law::choose)
        }
        Err(error) => refused(error.into()),
    }
}

/// Resets it to its start values and to time 0.
#[unsafe(no_mangle)]
pub extern "C" fn model_reset() -> Status {
    enter(|module| {
        module.instance.reset();
        law::choose(module)
    })
}

/// Address of the reason why the last refused call was refused, or of the last warning.
#[unsafe(no_mangle)]
pub extern "C" fn model_text() -> usize {
    state::text().address()
}

/// The number that the last call has found.
#[unsafe(no_mangle)]
pub extern "C" fn model_value() -> f64 {
    state::module().map_or(f64::NAN, |module| module.value)
}

/// Sets a variable, whatever the phase.
#[unsafe(no_mangle)]
pub extern "C" fn model_set(reference: Reference, value: f64) -> Status {
    enter(|module| {
        if module.instance.write_at_once(&[reference], &[value]) {
            return Ok(());
        }
        let column = module.instance.column(reference)?;
        law::check(column, value).map_err(fault(Status::RefusedValue))?;
        Ok(module.instance.set_column(column, value)?)
    })
}

/// Sets a Real input that has no rule but its range. False, with nothing changed, for anything else.
#[unsafe(no_mangle)]
pub extern "C" fn model_set_input(reference: Reference, value: f64) -> bool {
    state::module().is_some_and(|module| module.instance.write_at_once(&[reference], &[value]))
}

/// Type of a variable: 0 Real, 1 Integer, 2 Boolean, 3 any.
fn is_of(column: usize, kind: u32) -> bool {
    match MODEL.table.base_type(column) {
        BaseType::Real => kind == 0 || kind == 3,
        BaseType::Integer => kind == 1 || kind == 3,
        BaseType::Boolean => kind == 2 || kind == 3,
    }
}

/// The column of a variable of this type.
fn column(reference: Reference, kind: u32) -> Result<usize, Refusal> {
    let wanted = ["Real", "Integer", "Boolean", "any"].get(kind as usize).copied().unwrap_or_default();
    match MODEL.place(reference) {
        Some(Place::Column(column)) if is_of(column, kind) => Ok(column),
        Some(Place::Column(column)) => {
            let path = MODEL.table.at(column).path;
            refuse(
                Status::UnknownVariable,
                format_args!("{path} (value reference {reference}) is not of type {wanted}"),
            )
        }
        Some(Place::Time) => is_no_variable(reference),
        Some(Place::Derivative(_)) if MODEL.model_exchange => is_no_variable(reference),
        _ => {
            refuse(Status::UnknownVariable, format_args!("value reference {reference} does not belong to any variable"))
        }
    }
}

fn is_no_variable<T>(reference: Reference) -> Result<T, Refusal> {
    let text = "is time or a derivative, which this call does not take";
    refuse(Status::UnknownVariable, format_args!("value reference {reference} {text}"))
}

/// Whether a variable of this type may be set to a value: during a run, or before it.
#[unsafe(no_mangle)]
pub extern "C" fn model_check(reference: Reference, kind: u32, value: f64, is_running: bool) -> Status {
    enter(|module| {
        let phase = if is_running { Phase::Stepping } else { Phase::Setup };
        let column = column(reference, kind)?;
        module.instance.check_value(phase, column, value)?;
        law::check(column, value).map_err(fault(Status::RefusedValue))
    })
}

/// Whether a variable of this type can be read.
#[unsafe(no_mangle)]
pub extern "C" fn model_check_readable(reference: Reference, kind: u32) -> Status {
    enter(|_| match MODEL.place(reference) {
        Some(Place::Time) if kind == 0 => Ok(()),
        Some(Place::Derivative(_)) if kind == 0 && MODEL.model_exchange => Ok(()),
        _ => column(reference, kind).map(|_| ()),
    })
}

/// Reads a variable of this type, time or, if the model supports Model Exchange, a derivative: [`model_value`]. After an
/// error the last results are read.
#[unsafe(no_mangle)]
pub extern "C" fn model_get(reference: Reference, kind: u32, is_after_error: bool) -> Status {
    enter(|module| {
        let instance = &mut module.instance;
        module.value = match MODEL.place(reference) {
            Some(Place::Time) if kind == 0 => instance.time(),
            Some(Place::Derivative(state)) if kind == 0 && MODEL.model_exchange => {
                instance.rates().map_err(fault(Status::NotFinite))?[state]
            }
            _ => {
                let column = column(reference, kind)?;
                let needed = MODEL.table.needs(column);
                if !is_after_error {
                    instance.refresh_to(needed).map_err(fault(Status::NotFinite))?;
                } else if needed == Computed::All {
                    instance.compute_advice().map_err(fault(Status::NotFinite))?;
                }
                instance.row()[column]
            }
        };
        Ok(())
    })
}

/// Checks the parameters against each other, and computes the results.
#[unsafe(no_mangle)]
pub extern "C" fn model_output() -> Status {
    enter(|module| {
        module.instance.check().map_err(fault(Status::RefusedValue))?;
        module.instance.refresh_to(Computed::Main).map_err(fault(Status::NotFinite))
    })
}

/// Advances by `dt` > 0 seconds.
#[unsafe(no_mangle)]
pub extern "C" fn model_step(dt: f64) -> Status {
    enter(|module| {
        if !(dt > 0.0 && dt.is_finite()) {
            return refuse(Status::RefusedValue, format_args!("dt = {dt}: must be > 0 and finite"));
        }
        module.instance.check().map_err(fault(Status::RefusedValue))?;
        module.instance.step(dt).map_err(fault(Status::NotFinite))
    })
}

/// Present time.
#[unsafe(no_mangle)]
pub extern "C" fn model_time() -> f64 {
    state::module().map_or(f64::NAN, |module| module.instance.time())
}

/// Sets the time.
#[unsafe(no_mangle)]
pub extern "C" fn model_set_time(time: f64) -> Status {
    enter(|module| {
        module.instance.set_time(time);
        Ok(())
    })
}

/// Whether an input may have this slope, of order 1, over the next step; `is_final` gives it.
#[unsafe(no_mangle)]
pub extern "C" fn model_slope(reference: Reference, order: i32, slope: f64, is_final: bool) -> Status {
    enter(|module| {
        let column = column(reference, 0)?;
        module.instance.check_slope(column, slope)?;
        if order != 1 {
            let path = MODEL.table.at(column).path;
            return refuse(Status::NotSettable, format_args!("order {order} of {path}: only order 1 is supported"));
        }
        if is_final {
            module.instance.set_slope(column, slope)?;
        }
        Ok(())
    })
}

/// Whether there is a warning: [`model_text`]. That of parameters with which the model is not passive is asked for by
/// itself.
#[unsafe(no_mangle)]
pub extern "C" fn model_warning(is_of_passivity: bool) -> bool {
    let Some(module) = state::module() else { return false };
    let warning = if is_of_passivity { MODEL.passivity(module.instance.row()) } else { module.instance.warning() };
    if let Some(Fault(text)) = &warning {
        state::text().say(text);
    }
    warning.is_some()
}

/// Applies the preset with this number, in the order of the model.
#[unsafe(no_mangle)]
pub extern "C" fn model_apply(preset: u32) -> Status {
    enter(|module| law::apply(module, preset))
}

/// An output that has derivatives, or the derivative of a state.
fn check_unknown(reference: Reference, otherwise: &str) -> Outcome {
    let variable = MODEL.table.at(column(reference, 0)?);
    if !variable.role.is_output() {
        return refuse(Status::UnknownVariable, format_args!("{} {otherwise}", variable.path));
    }
    // Another variable can be asked for.
    variable.check_derivatives().map_err(fault(Status::RefusedValue))
}

/// Begins a direction.
#[unsafe(no_mangle)]
pub extern "C" fn model_direct() -> Status {
    enter(|module| {
        module.direction.fill(0.0);
        Ok(())
    })
}

/// Adds a component to the direction.
#[unsafe(no_mangle)]
pub extern "C" fn model_direct_to(reference: Reference, component: f64) -> Status {
    enter(|module| {
        let column = column(reference, 0)?;
        let variable = MODEL.table.at(column);
        if variable.role == Role::Output {
            let text = "is computed: nothing can be differentiated with respect to it";
            return refuse(Status::UnknownVariable, format_args!("{} {text}", variable.path));
        }
        module.direction[column] += component;
        Ok(())
    })
}

/// Whether a quantity has a derivative in a direction.
#[unsafe(no_mangle)]
pub extern "C" fn model_check_unknown(reference: Reference) -> Status {
    enter(|_| match MODEL.place(reference) {
        Some(Place::Derivative(_)) if MODEL.model_exchange => Ok(()),
        _ => check_unknown(reference, "is neither an output nor a derivative"),
    })
}

/// Differentiates results, and the rates of the states, in the direction.
#[unsafe(no_mangle)]
pub extern "C" fn model_differentiate(with_rates: bool) -> Status {
    enter(|Module { instance, direction, slopes, .. }| {
        instance.refresh_to(Computed::Main).map_err(fault(Status::NotFinite))?;
        let (of_columns, of_rates) = slopes.split_at_mut(COLUMNS);
        let seeds = direction.iter().copied().enumerate().filter(|(_, component)| *component != 0.0);
        if with_rates {
            instance.rates().map_err(fault(Status::NotFinite))?;
            let (columns, rates) = instance.derivatives(seeds);
            of_columns.iter_mut().zip(columns).for_each(|(place, dual)| *place = dual.slope);
            of_rates.iter_mut().zip(rates).for_each(|(place, dual)| *place = dual.slope);
        } else {
            let columns = instance.derivative(seeds);
            of_columns.iter_mut().zip(columns).for_each(|(place, dual)| *place = dual.slope);
        }
        Ok(())
    })
}

/// The derivative of a quantity that has one: [`model_value`].
#[unsafe(no_mangle)]
pub extern "C" fn model_derivative(reference: Reference) -> Status {
    enter(|module| {
        let slope = match MODEL.place(reference) {
            Some(Place::Derivative(state)) => module.slopes[COLUMNS + state],
            Some(Place::Column(column)) => module.slopes[column],
            Some(Place::Time) | None => f64::NAN,
        };
        if !slope.is_finite() {
            let text = format_args!("the derivative of value reference {reference} is not finite");
            return refuse(Status::NotFinite, text);
        }
        module.value = slope;
        Ok(())
    })
}

/// The derivative of an output with respect to time: [`model_value`]; 0 of higher orders.
#[unsafe(no_mangle)]
pub extern "C" fn model_time_derivative(reference: Reference, order: i32) -> Status {
    enter(|module| {
        check_unknown(reference, "is not an output")?;
        let column = column(reference, 0)?;
        let path = MODEL.table.at(column).path;
        if order < 1 {
            return refuse(Status::UnknownVariable, format_args!("order {order} of {path}: must be >= 1"));
        }
        module.instance.refresh_to(Computed::Main).map_err(fault(Status::NotFinite))?;
        let slope = module.instance.time_derivative()[column].slope;
        if !slope.is_finite() {
            return refuse(Status::NotFinite, format_args!("the derivative of {path} is not finite"));
        }
        module.value = if order == 1 { slope } else { 0.0 };
        Ok(())
    })
}

/// Address of the bytes of a state, for [`model_save`] and [`model_read`].
#[unsafe(no_mangle)]
pub extern "C" fn model_state() -> usize {
    state::module().map_or(0, |module| module.bytes.as_ptr().addr())
}

/// Writes the state, with four numbers that C adds, and the first sizes of arrays.
#[unsafe(no_mangle)]
pub extern "C" fn model_save(a: f64, b: f64, c: f64, d: f64, sizes: usize) -> Status {
    enter(|module| {
        let (Some(further), size) = (module.sizes.get(..sizes), serial::size_with(&MODEL, sizes)) else {
            return refuse(Status::Internal, "too many sizes");
        };
        let snapshot = module.instance.try_save()?;
        let bytes = &mut module.bytes[..size];
        serial::write_with(&MODEL, &snapshot, [a, b, c, d], further.iter().copied(), bytes);
        Ok(())
    })
}

/// Reads a state of so many bytes with so many sizes of arrays, and continues with it if `is_final`.
#[unsafe(no_mangle)]
pub extern "C" fn model_read(size: usize, sizes: usize, is_final: bool) -> Status {
    enter(|module| {
        let (Some(bytes), Some(further)) = (module.bytes.get(..size), module.sizes.get_mut(..sizes)) else {
            let text = format_args!("{size} bytes, {} are expected", serial::size_with(&MODEL, sizes));
            return refuse(Status::BadBuffer, format_args!("serialised state of {}: {text}", MODEL.name));
        };
        let (snapshot, owners) = serial::read_with(&MODEL, further, bytes).map_err(fault(Status::BadBuffer))?;
        if !HAS_SLOPES && snapshot.slopes_are_new {
            let text = format_args!("serialised state of {}: slopes of inputs are not available here", MODEL.name);
            return refuse(Status::BadBuffer, text);
        }
        law::check_row(&snapshot.row).map_err(fault(Status::BadBuffer))?;
        module.owners = owners;
        if is_final {
            module.instance.check_without_events(&snapshot).map_err(fault(Status::BadBuffer))?;
            module.instance.restore(&snapshot);
        }
        Ok(())
    })
}

/// A number that C has added to the state that was read.
#[unsafe(no_mangle)]
pub extern "C" fn model_owner(index: u32) -> f64 {
    state::module().and_then(|module| module.owners.get(index as usize).copied()).unwrap_or(f64::NAN)
}

/// Sets the size of an array, which belongs to the state.
#[unsafe(no_mangle)]
pub extern "C" fn model_resize(index: u32, size: f64) -> Status {
    enter(|module| match module.sizes.get_mut(index as usize) {
        Some(place) => {
            *place = size;
            Ok(())
        }
        None => refuse(Status::UnknownVariable, "too many sizes"),
    })
}

/// The size of an array in the state that was read.
#[unsafe(no_mangle)]
pub extern "C" fn model_size(index: u32) -> f64 {
    state::module().and_then(|module| module.sizes.get(index as usize).copied()).unwrap_or(f64::NAN)
}

/// Type of a variable in FMI 3.0: 1 Float64, 2 Int32, 3 Int64, 4 Boolean; 5 the derivative of a state, 6 time; 0 if there is
/// none.
#[unsafe(no_mangle)]
pub extern "C" fn model_type(reference: Reference) -> u32 {
    match MODEL.place(reference) {
        Some(Place::Column(column)) => match MODEL.table.at(column).kind {
            Kind::Real(_) => 1,
            Kind::Integer => 2,
            Kind::Enumeration(_) => 3,
            Kind::Boolean => 4,
        },
        Some(Place::Derivative(_)) if MODEL.model_exchange => 5,
        Some(Place::Time) => 6,
        _ => 0,
    }
}

/// Names a variable, or the array to which it belongs: [`model_text`].
#[unsafe(no_mangle)]
pub extern "C" fn model_name(reference: Reference) -> Status {
    enter(|_| {
        let path = |column: usize| {
            let path = MODEL.table.at(column).path;
            path.without_index().map_or(path, |(path, _)| path)
        };
        let name = match MODEL.place(reference) {
            Some(Place::Column(column)) => memory::text(path(column)),
            Some(Place::Derivative(state)) => memory::text(format_args!("der({})", path(state))),
            Some(Place::Time) => memory::text("time"),
            None => return is_no_variable(reference),
        };
        state::text().say(&name);
        Ok(())
    })
}
