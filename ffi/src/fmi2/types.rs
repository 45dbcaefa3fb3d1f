//! The types of the FMI 2.0 headers (fmi2TypesPlatform.h, fmi2FunctionTypes.h), under their own names.

use std::ffi::c_void;

use libc::{c_char, c_int, c_uint};

/// An instance of a model.
pub type fmi2Component = *mut c_void;
/// Pointer that the importer gets back in its logger.
pub type fmi2ComponentEnvironment = *mut c_void;
/// A saved state of an instance.
pub type fmi2FMUstate = *mut c_void;
/// Handle of a variable: its column in the table of the model.
pub type fmi2ValueReference = c_uint;
/// Floating-point number.
pub type fmi2Real = f64;
/// Integer, also used for enumerations.
pub type fmi2Integer = c_int;
/// `fmi2False` or `fmi2True`.
pub type fmi2Boolean = c_int;
/// Character.
pub type fmi2Char = c_char;
/// Zero-terminated text.
pub type fmi2String = *const fmi2Char;
/// Byte of a serialised state.
pub type fmi2Byte = c_char;

/// True.
pub const fmi2True: fmi2Boolean = 1;
/// False.
pub const fmi2False: fmi2Boolean = 0;

/// Result of a call.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmi2Status {
    /// Success.
    fmi2OK,
    /// Success, with a warning in the log.
    fmi2Warning,
    /// Refused; nothing was changed and the simulation can continue.
    fmi2Discard,
    /// Refused; the instance must be reset, freed or given a saved state.
    fmi2Error,
    /// The instance cannot be used any more.
    fmi2Fatal,
    /// Still running (never returned: all calls are synchronous).
    fmi2Pending,
}

/// Interface type of an FMU, an argument of fmi2Instantiate: `fmi2ModelExchange` or `fmi2CoSimulation`.
pub type fmi2Type = c_int;
/// Model exchange.
pub const fmi2ModelExchange: fmi2Type = 0;
/// Co-simulation.
pub const fmi2CoSimulation: fmi2Type = 1;

/// Kinds of status for fmi2GetStatus, fmi2GetRealStatus and the functions of the other types.
pub type fmi2StatusKind = c_int;
/// Result of an asynchronous step.
pub const fmi2DoStepStatus: fmi2StatusKind = 0;
/// Text about an asynchronous step.
pub const fmi2PendingStatus: fmi2StatusKind = 1;
/// End of the last completed step.
pub const fmi2LastSuccessfulTime: fmi2StatusKind = 2;
/// Whether the instance wants to end the simulation.
pub const fmi2Terminated: fmi2StatusKind = 3;

/// Receives a message. `message` is a printf format; this library passes "%s" and the text.
pub type fmi2CallbackLogger = Option<
    unsafe extern "C-unwind" fn(
        componentEnvironment: fmi2ComponentEnvironment,
        instanceName: fmi2String,
        status: fmi2Status,
        category: fmi2String,
        message: fmi2String,
        ...
    ),
>;
/// Allocates zeroed memory. Not used by this library; may be NULL.
pub type fmi2CallbackAllocateMemory = Option<unsafe extern "C" fn(nobj: usize, size: usize) -> *mut c_void>;
/// Frees memory. Not used by this library; may be NULL.
pub type fmi2CallbackFreeMemory = Option<unsafe extern "C" fn(obj: *mut c_void)>;
/// Signals the end of an asynchronous step. Not used by this library; may be NULL.
pub type fmi2StepFinished =
    Option<unsafe extern "C" fn(componentEnvironment: fmi2ComponentEnvironment, status: fmi2Status)>;

/// Changes and requests of an event.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmi2EventInfo {
    /// Whether fmi2NewDiscreteStates must be called again.
    pub newDiscreteStatesNeeded: fmi2Boolean,
    /// Whether the simulation must end.
    pub terminateSimulation: fmi2Boolean,
    /// Whether the states have new nominal values.
    pub nominalsOfContinuousStatesChanged: fmi2Boolean,
    /// Whether the states have jumped.
    pub valuesOfContinuousStatesChanged: fmi2Boolean,
    /// Whether the time of the next event is known.
    pub nextEventTimeDefined: fmi2Boolean,
    /// Time of the next event.
    pub nextEventTime: fmi2Real,
}

/// Functions of the importer. The struct is copied by fmi2Instantiate and need not outlive that call.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmi2CallbackFunctions {
    /// Receives messages; NULL for none.
    pub logger: fmi2CallbackLogger,
    /// Not used; may be NULL.
    pub allocateMemory: fmi2CallbackAllocateMemory,
    /// Not used; may be NULL.
    pub freeMemory: fmi2CallbackFreeMemory,
    /// Not used; may be NULL.
    pub stepFinished: fmi2StepFinished,
    /// Passed back to the logger.
    pub componentEnvironment: fmi2ComponentEnvironment,
}
