//! Getting and setting variables. An array counts by its elements, in row-major order.

use std::slice::{from_raw_parts, from_raw_parts_mut};

use super::component::{self, Component, Outcome, Refusal, enter, refuse};
use super::layout::{Elements, Item, Type};
use super::lifecycle::{Call, State};
use super::types::fmi3Status::fmi3OK;
use super::types::*;
use crate::component::Lifecycle;
use crate::guard::pointer::{array, array_mut};
use stribeck::model::Computed;
use stribeck::reference::Place;

/// View of a number as one of FMI's types.
trait Base {
    type Value: Copy;
    const TYPE: Type;
    fn to_number(value: Self::Value) -> f64;
    fn from_number(number: f64) -> Self::Value;
}

macro_rules! bases {
    ($($Base:ident: $Value:ident, $to:expr, $from:expr;)+) => {
        $(
            struct $Base;

            impl Base for $Base {
                type Value = $Value;
                const TYPE: Type = Type::$Base;
                #[inline(always)]
                fn to_number(value: $Value) -> f64 {
                    let to: fn($Value) -> f64 = $to;
                    to(value)
                }
                #[inline(always)]
                fn from_number(number: f64) -> $Value {
                    let from: fn(f64) -> $Value = $from;
                    from(number)
                }
            }
        )+
    };
}

bases! {
    Float64: fmi3Float64, |value| value, |number| number;
    Int32: fmi3Int32, f64::from, |number| number as fmi3Int32;
    // A number that an f64 cannot hold is far from every bound, even rounded.
    Int64: fmi3Int64, |value| value as f64, |number| number as fmi3Int64;
    UInt64: fmi3UInt64, |value| value as f64, |number| number as fmi3UInt64;
    Boolean: fmi3Boolean, f64::from, |number| fmi3Boolean::from(number != 0.0);
}

/// Refuses a number of values that is not that of the elements.
pub(super) fn check_count(given: usize, wanted: usize, what: &str) -> Outcome {
    if given == wanted { Ok(()) } else { refuse(format_args!("{given} {what}: must be {wanted}")) }
}

impl Component {
    /// The elements of a variable; an error if it is of another type.
    pub fn elements_of(&self, reference: fmi3ValueReference, wanted: Type) -> Result<Elements<'_>, Refusal> {
        let elements = self.elements(reference)?;
        let found = elements.first().of_type(self.instance.model());
        if found == wanted { Ok(elements) } else { wrong_type(self, reference, elements, &format_args!("{wanted:?}")) }
    }

    /// The elements of variables that exist, one after the other.
    pub fn items<'a>(&'a self, references: &'a [fmi3ValueReference]) -> impl Iterator<Item = Item> + Clone + use<'a> {
        self.own.layout.items(self.instance.model(), references)
    }

    /// The results that must follow the other columns before these elements can be read.
    pub fn needs(&self, references: &[fmi3ValueReference]) -> Computed {
        let table = self.instance.model().table;
        let needs = |item: Item| match item {
            Item::Column(column) => table.needs(column),
            _ => Computed::Nothing,
        };
        self.items(references).map(needs).max().unwrap_or(Computed::Nothing)
    }

    /// Refuses a variable that the importer has not asked for when the instance was made.
    pub fn check_intermediate(&self, reference: fmi3ValueReference) -> Outcome {
        let is_asked_for = self.own.stepping.required.contains(&reference);
        if self.state != State::IntermediateUpdateMode || is_asked_for {
            return Ok(());
        }
        refuse(format_args!("value reference {reference} is not one of the required intermediate variables"))
    }
}

/// Says that a variable is of another type.
#[cold]
pub(super) fn wrong_type<T>(
    component: &Component,
    reference: fmi3ValueReference,
    elements: Elements,
    wanted: &dyn std::fmt::Display,
) -> Result<T, Refusal> {
    let (name, found) = (component.name(elements), elements.first().of_type(component.instance.model()));
    refuse(format_args!("{name} (value reference {reference}) is of type {found:?}, not {wanted}"))
}

/// Number of elements of variables of one type.
fn count<B: Base>(component: &Component, references: &[fmi3ValueReference]) -> Result<usize, Refusal> {
    references.iter().try_fold(0, |count, reference| {
        component.check_intermediate(*reference)?;
        Ok(count + component.elements_of(*reference, B::TYPE)?.len())
    })
}

/// Reads variables. After an error the values must not be used.
#[inline(never)]
unsafe fn get<B: Base>(
    instance: fmi3Instance,
    call: Call,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *mut B::Value,
    nValues: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the importer promises `nValueReferences` value references and room for `nValues` values.
        let (references, values) = unsafe {
            (array(valueReferences, nValueReferences, "valueReferences")?, array_mut(values, nValues, "values")?)
        };
        check_count(nValues, count::<B>(component, references)?, "values")?;
        refresh(component, references)?;
        read::<B>(component, references, values)
    };
    // SAFETY: the importer's promise about `instance`.
    unsafe { enter(instance, call, body) }
}

/// Computes what the variables need.
fn refresh(component: &mut Component, references: &[fmi3ValueReference]) -> Outcome {
    let needs = component.needs(references);
    if needs > Computed::Nothing {
        component.instance.refresh_to(needs).map_err(|fault| component.out_of_domain(fault))?;
    }
    if component.items(references).any(|item| matches!(item, Item::Indicator(_))) {
        let (instance, indicators) = (&component.instance, &mut component.own.indicators);
        instance.indicate(indicators).map_err(|fault| Refusal::out_of_domain(component.state.is_tried(), fault))?;
    }
    Ok(())
}

/// Writes the values of the elements.
fn read<B: Base>(component: &mut Component, references: &[fmi3ValueReference], values: &mut [B::Value]) -> Outcome {
    let model = component.instance.model();
    if component.items(references).any(|item| matches!(item, Item::Derivative(_))) {
        let rates = component.instance.rates();
        let rates = rates.map_err(|fault| Refusal::out_of_domain(component.state.is_tried(), fault))?;
        for (item, value) in component.own.layout.items(model, references).zip(&mut *values) {
            if let Item::Derivative(state) = item {
                *value = B::from_number(rates[state]);
            }
        }
    }
    for (item, value) in component.items(references).zip(values) {
        *value = B::from_number(match item {
            Item::Column(column) => component.instance.row()[column],
            Item::Time => component.instance.time(),
            Item::Indicator(at) => component.own.indicators[at],
            Item::Size(at) => component.own.layout.sizes[at] as f64,
            Item::Derivative(_) => continue,
        });
    }
    Ok(())
}

/// Refuses elements that are never set.
fn check_settable(component: &Component, references: &[fmi3ValueReference]) -> Outcome {
    for reference in references {
        let elements = component.elements(*reference)?;
        let name = component.name(elements);
        match elements.first() {
            Item::Column(_) => {}
            Item::Size(_) => return refuse(format_args!("{name} can be set in state ConfigurationMode only")),
            Item::Time | Item::Derivative(_) | Item::Indicator(_) => {
                return refuse(format_args!("{name} is computed and cannot be set"));
            }
        }
    }
    Ok(())
}

/// Sets variables: all, or none if one is refused.
#[inline(never)]
unsafe fn set<B: Base>(
    instance: fmi3Instance,
    call: Call,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *const B::Value,
    nValues: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the importer promises `nValueReferences` value references and `nValues` values.
        let (references, values) = unsafe {
            (array(valueReferences, nValueReferences, "valueReferences")?, array(values, nValues, "values")?)
        };
        check_count(nValues, count::<B>(component, references)?, "values")?;
        if component.state == State::ConfigurationMode {
            return set_sizes(component, references, values.iter().map(|value| B::to_number(*value)));
        }
        check_settable(component, references)?;
        let (layout, model, phase) = (&component.own.layout, component.instance.model(), component.state.phase());
        let columns = layout.items(model, references).filter_map(Item::column);
        let values = columns.zip(values.iter().map(|value| B::to_number(*value)));
        component.instance.set_all(phase, values).map_err(|refused| component.refusal(refused))
    };
    // SAFETY: the importer's promise about `instance`.
    unsafe { enter(instance, call, body) }
}

/// Sets sizes of arrays, in Configuration Mode.
fn set_sizes(
    component: &mut Component,
    references: &[fmi3ValueReference],
    values: impl Iterator<Item = f64> + Clone,
) -> Outcome {
    for (reference, value) in references.iter().zip(values.clone()) {
        let elements = component.elements(*reference)?;
        let Item::Size(at) = elements.first() else { return refuse("only sizes of arrays are set here") };
        let most = component.own.layout.most[at];
        if !(value >= 1.0 && value <= most as f64) {
            let text = format_args!("{} = {value}: must be from 1 to {most}", component.name(elements));
            return Err(Refusal::Discard(stribeck::memory::text(text)));
        }
    }
    for (reference, value) in references.iter().zip(values) {
        if let Item::Size(at) = component.elements(*reference)?.first() {
            component.own.layout.sizes[at] = value as usize;
        }
    }
    Ok(())
}

/// Whether none of these is an element of an array, which has no reference of its own here.
#[inline(always)]
fn are_plain(component: &Component, references: &[fmi3ValueReference]) -> bool {
    let (layout, model) = (&component.own.layout, component.instance.model());
    let is_plain = |reference: &fmi3ValueReference| match model.place(*reference) {
        Some(Place::Column(column)) => !layout.is_element(column),
        _ => false,
    };
    !layout.has_arrays() || references.iter().all(is_plain)
}

/// The fast path of fmi3GetFloat64: results that need no computing. False if there is anything else among them; the values
/// written so far are then overwritten by the slow path, or must not be used.
///
/// # Safety
/// `references` and `values` must be NULL or have `n` elements.
#[inline(always)]
unsafe fn read_at_once(
    component: &Component,
    references: *const fmi3ValueReference,
    n: usize,
    values: *mut fmi3Float64,
) -> bool {
    if n == 0 || references.is_null() || values.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(references, n), from_raw_parts_mut(values, n)) };
    are_plain(component, references) && component.instance.read_at_once(references, values)
}

/// The fast path of fmi3SetFloat64: admitted values of inputs with no rule but their range. False, with nothing changed,
/// if there is anything else among them.
///
/// # Safety
/// `references` and `values` must be NULL or have `n` elements.
#[inline(always)]
unsafe fn write_at_once(
    component: &mut Component,
    references: *const fmi3ValueReference,
    n: usize,
    values: *const fmi3Float64,
) -> bool {
    if n == 0 || references.is_null() || values.is_null() {
        return false;
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    let (references, values) = unsafe { (from_raw_parts(references, n), from_raw_parts(values, n)) };
    are_plain(component, references) && component.instance.write_at_once(references, values)
}

/// Reads Float64 variables: real variables, time, derivatives of states, event indicators.
///
/// # Safety
/// `instance` as for every call on an instance; the arrays must have `nValueReferences` and `nValues` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetFloat64(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *mut fmi3Float64,
    nValues: usize,
) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe {
        if nValues == nValueReferences
            && let Some(component) = component::stepping(instance)
            && read_at_once(component, valueReferences, nValueReferences, values)
        {
            return fmi3OK;
        }
        get::<Float64>(instance, Call::GetFloat64, valueReferences, nValueReferences, values, nValues)
    }
}

/// Sets Float64 variables: all, or none if one is refused. fmi3Discard if a value is outside its bound.
///
/// # Safety
/// As for fmi3GetFloat64.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetFloat64(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *const fmi3Float64,
    nValues: usize,
) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe {
        if nValues == nValueReferences
            && let Some(component) = component::stepping(instance)
            && write_at_once(component, valueReferences, nValueReferences, values)
        {
            return fmi3OK;
        }
        set::<Float64>(instance, Call::SetFloat64, valueReferences, nValueReferences, values, nValues)
    }
}

macro_rules! functions {
    ($($get:ident $set:ident: $Base:ident, $Get:ident, $Set:ident, $Value:ident, $what:literal;)+) => {
        $(
            #[doc = concat!("Reads ", $what, ".")]
            ///
            /// # Safety
            /// As for fmi3GetFloat64.
            #[unsafe(no_mangle)]
            pub unsafe extern "C-unwind" fn $get(
                instance: fmi3Instance,
                valueReferences: *const fmi3ValueReference,
                nValueReferences: usize,
                values: *mut $Value,
                nValues: usize,
            ) -> fmi3Status {
                // SAFETY: the caller's promises.
                unsafe { get::<$Base>(instance, Call::$Get, valueReferences, nValueReferences, values, nValues) }
            }

            #[doc = concat!("Sets ", $what, ", as fmi3SetFloat64 does.")]
            ///
            /// # Safety
            /// As for fmi3GetFloat64.
            #[unsafe(no_mangle)]
            pub unsafe extern "C-unwind" fn $set(
                instance: fmi3Instance,
                valueReferences: *const fmi3ValueReference,
                nValueReferences: usize,
                values: *const $Value,
                nValues: usize,
            ) -> fmi3Status {
                // SAFETY: the caller's promises.
                unsafe { set::<$Base>(instance, Call::$Set, valueReferences, nValueReferences, values, nValues) }
            }
        )+
    };
}

functions! {
    fmi3GetInt32 fmi3SetInt32: Int32, GetInt32, SetInt32, fmi3Int32, "Int32 variables";
    fmi3GetInt64 fmi3SetInt64: Int64, GetInt64, SetInt64, fmi3Int64, "enumerations";
    fmi3GetUInt64 fmi3SetUInt64: UInt64, GetUInt64, SetUInt64, fmi3UInt64, "sizes of arrays";
    fmi3GetBoolean fmi3SetBoolean: Boolean, GetBoolean, SetBoolean, fmi3Boolean, "Boolean variables (0 or 1)";
}
