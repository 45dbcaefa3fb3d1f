//! The types of the FMI 3.0 headers (fmi3PlatformTypes.h, fmi3FunctionTypes.h), under their own names.

use std::ffi::c_void;

use libc::c_char;

/// An instance of a model.
pub type fmi3Instance = *mut c_void;
/// Pointer that the importer gets back in its callbacks.
pub type fmi3InstanceEnvironment = *mut c_void;
/// A saved state of an instance.
pub type fmi3FMUState = *mut c_void;
/// Handle of a variable.
pub type fmi3ValueReference = u32;
/// Floating-point number of 32 bits. No model has such variables.
pub type fmi3Float32 = f32;
/// Floating-point number of 64 bits.
pub type fmi3Float64 = f64;
/// Integer of 8 bits. No model has such variables.
pub type fmi3Int8 = i8;
/// Unsigned integer of 8 bits. No model has such variables.
pub type fmi3UInt8 = u8;
/// Integer of 16 bits. No model has such variables.
pub type fmi3Int16 = i16;
/// Unsigned integer of 16 bits. No model has such variables.
pub type fmi3UInt16 = u16;
/// Integer of 32 bits.
pub type fmi3Int32 = i32;
/// Unsigned integer of 32 bits. No model has such variables.
pub type fmi3UInt32 = u32;
/// Integer of 64 bits, for enumerations.
pub type fmi3Int64 = i64;
/// Unsigned integer of 64 bits, for sizes of arrays.
pub type fmi3UInt64 = u64;
/// `fmi3False` or `fmi3True`: C's `bool`, of which any byte may arrive.
pub type fmi3Boolean = u8;
/// Zero-terminated text.
pub type fmi3String = *const c_char;
/// Byte of a serialised state.
pub type fmi3Byte = u8;
/// Bytes of a binary variable. No model has such variables.
pub type fmi3Binary = *const fmi3Byte;
/// Activation of a clock, C's `bool`. No model has clocks.
pub type fmi3Clock = u8;

/// True.
pub const fmi3True: fmi3Boolean = 1;
/// False.
pub const fmi3False: fmi3Boolean = 0;

/// Result of a call.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmi3Status {
    /// Success.
    fmi3OK,
    /// Success, with a warning in the log.
    fmi3Warning,
    /// Refused; nothing was changed and the simulation can continue.
    fmi3Discard,
    /// Refused; the instance must be reset, freed or given a saved state.
    fmi3Error,
    /// The instance cannot be used any more (never returned).
    fmi3Fatal,
}

/// Kind of a dependency, an element of an array of the importer; never written.
pub type fmi3DependencyKind = libc::c_int;
/// State of the interval of a clock, an element of an array of the importer; never written.
pub type fmi3IntervalQualifier = libc::c_int;

/// Receives a message.
pub type fmi3LogMessageCallback = Option<
    unsafe extern "C-unwind" fn(
        instanceEnvironment: fmi3InstanceEnvironment,
        status: fmi3Status,
        category: fmi3String,
        message: fmi3String,
    ),
>;
/// Informs the importer of a clock. Not used by this library.
pub type fmi3ClockUpdateCallback = Option<unsafe extern "C-unwind" fn(instanceEnvironment: fmi3InstanceEnvironment)>;
/// Gives the importer access to results within a step, and lets it end the step.
pub type fmi3IntermediateUpdateCallback = Option<
    unsafe extern "C-unwind" fn(
        instanceEnvironment: fmi3InstanceEnvironment,
        intermediateUpdateTime: fmi3Float64,
        intermediateVariableSetRequested: fmi3Boolean,
        intermediateVariableGetAllowed: fmi3Boolean,
        intermediateStepFinished: fmi3Boolean,
        canReturnEarly: fmi3Boolean,
        earlyReturnRequested: *mut fmi3Boolean,
        earlyReturnTime: *mut fmi3Float64,
    ),
>;
/// Prevents a task switch. Not used by this library.
pub type fmi3LockPreemptionCallback = Option<unsafe extern "C-unwind" fn()>;
/// Allows a task switch. Not used by this library.
pub type fmi3UnlockPreemptionCallback = Option<unsafe extern "C-unwind" fn()>;
