//! Types, clocks and queries that no model has: calls about no variable succeed, all others say why not.

use super::component::{Component, Outcome, enter, refuse};
use super::lifecycle::Call;
use super::types::*;
use super::values::wrong_type;
use crate::guard::pointer::array;

/// Refuses variables of a type that no model has.
fn check_none(component: &Component, references: *const fmi3ValueReference, count: usize, wanted: &str) -> Outcome {
    // SAFETY: the importer promises `count` value references.
    match unsafe { array(references, count, "valueReferences") }? {
        [] => Ok(()),
        [reference, ..] => wrong_type(component, *reference, component.elements(*reference)?, &wanted),
    }
}

/// As [`check_none`], for a call with values.
fn check_no_values(
    component: &Component,
    references: *const fmi3ValueReference,
    [count, values]: [usize; 2],
    wanted: &str,
) -> Outcome {
    check_none(component, references, count, wanted)?;
    super::values::check_count(values, 0, "values")
}

macro_rules! without_variables {
    ($($get:ident $set:ident: $Get:ident, $Set:ident, $Value:ident, $name:literal;)+) => {
        $(
            #[doc = concat!("Reads ", $name, " variables; no model has any, so only `nValueReferences` = 0 succeeds.")]
            ///
            /// # Safety
            /// `instance` as for every call on an instance; `valueReferences` must have `nValueReferences` elements.
            #[unsafe(no_mangle)]
            pub unsafe extern "C-unwind" fn $get(
                instance: fmi3Instance,
                valueReferences: *const fmi3ValueReference,
                nValueReferences: usize,
                _values: *mut $Value,
                nValues: usize,
            ) -> fmi3Status {
                let count = [nValueReferences, nValues];
                // SAFETY: the caller's promise about `instance`.
                unsafe {
                    enter(instance, Call::$Get, |component| check_no_values(component, valueReferences, count, $name))
                }
            }

            #[doc = concat!("Sets ", $name, " variables; no model has any, so only `nValueReferences` = 0 succeeds.")]
            ///
            /// # Safety
            /// `instance` as for every call on an instance; `valueReferences` must have `nValueReferences` elements.
            #[unsafe(no_mangle)]
            pub unsafe extern "C-unwind" fn $set(
                instance: fmi3Instance,
                valueReferences: *const fmi3ValueReference,
                nValueReferences: usize,
                _values: *const $Value,
                nValues: usize,
            ) -> fmi3Status {
                let count = [nValueReferences, nValues];
                // SAFETY: the caller's promise about `instance`.
                unsafe {
                    enter(instance, Call::$Set, |component| check_no_values(component, valueReferences, count, $name))
                }
            }
        )+
    };
}

without_variables! {
    fmi3GetFloat32 fmi3SetFloat32: GetFloat32, SetFloat32, fmi3Float32, "Float32";
    fmi3GetInt8 fmi3SetInt8: GetInt8, SetInt8, fmi3Int8, "Int8";
    fmi3GetUInt8 fmi3SetUInt8: GetUInt8, SetUInt8, fmi3UInt8, "UInt8";
    fmi3GetInt16 fmi3SetInt16: GetInt16, SetInt16, fmi3Int16, "Int16";
    fmi3GetUInt16 fmi3SetUInt16: GetUInt16, SetUInt16, fmi3UInt16, "UInt16";
    fmi3GetUInt32 fmi3SetUInt32: GetUInt32, SetUInt32, fmi3UInt32, "UInt32";
    fmi3GetString fmi3SetString: GetString, SetString, fmi3String, "String";
}

/// Reads Binary variables; no model has any, so only `nValueReferences` = 0 succeeds.
///
/// # Safety
/// `instance` as for every call on an instance; `valueReferences` must have `nValueReferences` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetBinary(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    _valueSizes: *mut usize,
    _values: *mut fmi3Binary,
    nValues: usize,
) -> fmi3Status {
    let count = [nValueReferences, nValues];
    // SAFETY: the caller's promise about `instance`.
    unsafe {
        enter(instance, Call::GetBinary, |component| check_no_values(component, valueReferences, count, "Binary"))
    }
}

/// Sets Binary variables; no model has any, so only `nValueReferences` = 0 succeeds.
///
/// # Safety
/// As for fmi3GetBinary.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3SetBinary(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    _valueSizes: *const usize,
    _values: *const fmi3Binary,
    nValues: usize,
) -> fmi3Status {
    let count = [nValueReferences, nValues];
    // SAFETY: the caller's promise about `instance`.
    unsafe {
        enter(instance, Call::SetBinary, |component| check_no_values(component, valueReferences, count, "Binary"))
    }
}

macro_rules! without_clocks {
    ($($function:ident: $Call:ident, ($($argument:ident: $Type:ty),+);)+) => {
        $(
            #[doc = concat!(
                "`", stringify!($Call), "` of clocks; no model has any, so only `nValueReferences` = 0 succeeds."
            )]
            ///
            /// # Safety
            /// `instance` as for every call on an instance; `valueReferences` must have `nValueReferences` elements.
            #[unsafe(no_mangle)]
            pub unsafe extern "C-unwind" fn $function(
                instance: fmi3Instance,
                valueReferences: *const fmi3ValueReference,
                nValueReferences: usize,
                $($argument: $Type),+
            ) -> fmi3Status {
                // SAFETY: the caller's promise about `instance`.
                unsafe {
                    enter(instance, Call::$Call, |component| {
                        check_none(component, valueReferences, nValueReferences, "Clock")
                    })
                }
            }
        )+
    };
}

without_clocks! {
    fmi3GetClock: GetClock, (_values: *mut fmi3Clock);
    fmi3SetClock: SetClock, (_values: *const fmi3Clock);
    fmi3GetIntervalDecimal: GetIntervalDecimal,
        (_intervals: *mut fmi3Float64, _qualifiers: *mut fmi3IntervalQualifier);
    fmi3GetIntervalFraction: GetIntervalFraction,
        (_counters: *mut fmi3UInt64, _resolutions: *mut fmi3UInt64, _qualifiers: *mut fmi3IntervalQualifier);
    fmi3GetShiftDecimal: GetShiftDecimal, (_shifts: *mut fmi3Float64);
    fmi3GetShiftFraction: GetShiftFraction, (_counters: *mut fmi3UInt64, _resolutions: *mut fmi3UInt64);
    fmi3SetIntervalDecimal: SetIntervalDecimal, (_intervals: *const fmi3Float64);
    fmi3SetIntervalFraction: SetIntervalFraction, (_counters: *const fmi3UInt64, _resolutions: *const fmi3UInt64);
    fmi3SetShiftDecimal: SetShiftDecimal, (_shifts: *const fmi3Float64);
    fmi3SetShiftFraction: SetShiftFraction, (_counters: *const fmi3UInt64, _resolutions: *const fmi3UInt64);
}

/// Reason why dependencies are not answered.
const NO_DEPENDENCIES: &str = "dependencies of single elements are not provided: those of modelDescription.xml hold";

/// Always an error: `providesPerElementDependencies` is false.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetNumberOfVariableDependencies(
    instance: fmi3Instance,
    _valueReference: fmi3ValueReference,
    _nDependencies: *mut usize,
) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetNumberOfVariableDependencies, |_| refuse(NO_DEPENDENCIES)) }
}

/// Always an error: `providesPerElementDependencies` is false.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetVariableDependencies(
    instance: fmi3Instance,
    _dependent: fmi3ValueReference,
    _elementIndicesOfDependent: *mut usize,
    _independents: *mut fmi3ValueReference,
    _elementIndicesOfIndependents: *mut usize,
    _dependencyKinds: *mut fmi3DependencyKind,
    _nDependencies: usize,
) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetVariableDependencies, |_| refuse(NO_DEPENDENCIES)) }
}

/// Always an error: no model has partitions that can be scheduled.
///
/// # Safety
/// `instance` as for every call on an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3ActivateModelPartition(
    instance: fmi3Instance,
    _clockReference: fmi3ValueReference,
    _activationTime: fmi3Float64,
) -> fmi3Status {
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::ActivateModelPartition, |_| Ok(())) }
}
