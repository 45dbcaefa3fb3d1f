//! The guard of every call from C: state, floating-point mode, panic, message; [`pointer`] checks what a call is given.

use std::panic::{AssertUnwindSafe, catch_unwind};

use float_mode::DefaultMode;

mod float_mode;
pub(crate) mod panics;
pub(crate) mod pointer;

/// A panic in a call, as its message.
pub(crate) struct Internal(pub String);

/// The object behind a handle.
pub(crate) trait Handle {
    /// The call, as far as its admission or its message depends on it.
    type Call: Copy;
    /// Why a call was refused.
    type Refusal: From<Internal>;
    /// The result of a call, as C sees it.
    type Status;
    /// The status of a call that succeeded.
    const OK: Self::Status;

    /// Refuses a call that may not be made now.
    fn check(&self, call: Self::Call) -> Result<(), Self::Refusal>;

    /// Keeps the message of a refused call and returns its status.
    fn refuse(&mut self, call: Self::Call, refusal: Self::Refusal) -> Self::Status;
}

/// Runs `body` in the default floating-point mode if the call may be made now; turns refusals and panics into a status
/// and a message.
#[inline(always)]
pub(crate) fn run<H: Handle>(
    handle: &mut H,
    call: H::Call,
    body: impl FnOnce(&mut H) -> Result<(), H::Refusal>,
) -> H::Status {
    if let Err(refusal) = handle.check(call) {
        return handle.refuse(call, refusal);
    }
    let _mode = DefaultMode::enter();
    // A panic leaves row and memory as they were: see RollBack. Everything else that a body writes, it writes last.
    match catch_unwind(AssertUnwindSafe(|| body(handle))) {
        Ok(Ok(())) => H::OK,
        Ok(Err(refusal)) => handle.refuse(call, refusal),
        Err(panic) => handle.refuse(call, Internal(panics::text(&*panic)).into()),
    }
}

/// Makes the object behind a new handle; turns a panic into an error.
pub(crate) fn make<T, E: From<Internal>>(body: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    panics::silence();
    let internal = |panic: Box<dyn std::any::Any + Send>| Err(Internal(panics::text(&*panic)).into());
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(internal)
}
