//! Functions of both versions of FMI under the same names, for one interpreter of sequences of calls.

use std::cell::Cell;
use std::ffi::{CStr, c_char, c_void};
use std::fmt::Debug;

use stribeck::model::ModelType;
use stribeck_ffi::fmi2::lifecycle::Purpose;

/// Status of a call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// Success.
    Ok,
    /// Refused; nothing has changed.
    Discard,
    /// Refused; the instance must be reset.
    Error,
}

/// The functions that the interpreter calls.
pub struct Calls<C> {
    /// Saves a state.
    pub save: C,
    /// Restores it.
    pub restore: C,
    /// Frees it.
    pub free: C,
    /// Asks for the number of its bytes.
    pub size: C,
    /// Writes them.
    pub write: C,
    /// Reads them.
    pub read: C,
    /// Sets the time.
    pub set_time: C,
    /// Sets the continuous states.
    pub set_states: C,
    /// Reads derivatives, event indicators, states, nominal values.
    pub arrays: [C; 4],
    /// Returns to the state after the instance was made.
    pub reset: C,
}

/// A version of FMI. The functions without an explanation are those of the standard, of [`Calls`]' names.
///
/// # Safety
/// `c` must be a live instance, a state NULL or one that has not been freed, and each array as long as said.
#[allow(clippy::missing_safety_doc, reason = "that of the trait holds for each")]
pub trait Version: Sized + 'static {
    /// A function.
    type Call: Copy + Debug + PartialEq + 'static;
    /// A state of an instance.
    type State: Copy + Debug + PartialEq;
    /// Abilities of the importer.
    type Choice: Copy + Default;
    /// Callbacks of the importer beside its logger.
    type Callbacks: Default;
    /// Beginning of the names of functions.
    const PREFIX: &'static str;
    /// The functions that the interpreter calls.
    const CALLS: Calls<Self::Call>;
    /// The state after an error.
    const FAILED: Self::State;

    /// The state with this number in the bytes of a saved state.
    fn state(number: f64) -> Self::State;
    /// Whether the standard allows a call.
    fn is_allowed(call: Self::Call, from: Self::State, purpose: Purpose) -> bool;
    /// The state after a successful call.
    fn next(call: Self::Call, from: Self::State, slave: (Purpose, Self::Choice)) -> Self::State;
    /// Whether such an instance can be in this state.
    fn can_be(state: Self::State, slave: (Purpose, Self::Choice)) -> bool;
    /// Columns of the continuous states, in the order in which a solver gets them.
    fn continuous_states(model: &'static ModelType) -> Vec<usize>;
    /// Whether steps can be made in this state.
    fn can_step(state: Self::State) -> bool;

    /// Makes an instance, with a logger that calls [`hear`].
    fn make(
        model: &'static ModelType,
        purpose: Purpose,
        choice: Self::Choice,
        ears: &Ears<Self::Callbacks>,
    ) -> *mut c_void;
    /// See [`Version`].
    unsafe fn drop(c: *mut c_void);
    /// See [`Version`].
    unsafe fn save(c: *mut c_void, state: &mut *mut c_void) -> Answer;
    /// See [`Version`].
    unsafe fn restore(c: *mut c_void, state: *mut c_void) -> Answer;
    /// See [`Version`].
    unsafe fn free(c: *mut c_void, state: &mut *mut c_void) -> Answer;
    /// See [`Version`].
    unsafe fn size(c: *mut c_void, state: *mut c_void, size: &mut usize) -> Answer;
    /// See [`Version`].
    unsafe fn write(c: *mut c_void, state: *mut c_void, bytes: &mut [u8]) -> Answer;
    /// See [`Version`].
    unsafe fn read(c: *mut c_void, bytes: &[u8], state: &mut *mut c_void) -> Answer;
    /// See [`Version`].
    unsafe fn set_time(c: *mut c_void, time: f64) -> Answer;
    /// See [`Version`].
    unsafe fn set_states(c: *mut c_void, values: &[f64]) -> Answer;
    /// See [`Version`]; `which` of [`Calls::arrays`].
    unsafe fn get_array(c: *mut c_void, which: usize, values: &mut [f64]) -> Answer;
    /// A step of co-simulation from the present time, without surprises by the importer.
    unsafe fn step(c: *mut c_void, ears: &Ears<Self::Callbacks>, time: f64, length: f64) -> Answer;
    /// All real variables.
    unsafe fn read_all(c: *mut c_void, model: &'static ModelType, numbers: &[f64]) -> (Answer, Vec<f64>);
}

/// The importer's side of an instance.
#[derive(Default)]
pub struct Ears<X> {
    /// Number of errors since they were taken.
    pub messages: Cell<u32>,
    /// Callbacks of the version beside its logger.
    pub callbacks: X,
}

impl<X> Ears<X> {
    /// The pointer that the importer gets back.
    pub fn environment(&self) -> *mut c_void {
        std::ptr::from_ref(self).cast_mut().cast()
    }
}

/// Counts an error that an instance reports, and checks its texts. A warning accompanies a call that succeeds.
///
/// # Safety
/// The texts must be zero-terminated.
pub unsafe fn hear(messages: &Cell<u32>, is_warning: bool, category: *const c_char, text: *const c_char) {
    // SAFETY: the caller's promise.
    let (category, text) = unsafe { (CStr::from_ptr(category), CStr::from_ptr(text).to_string_lossy()) };
    messages.set(messages.get() + u32::from(!is_warning));
    assert!(!is_warning || category == c"logStatusWarning");
    assert!(category.to_bytes().starts_with(b"logStatus"));
    assert!(!text.contains("internal error"), "a panic was caught: {text}");
}
