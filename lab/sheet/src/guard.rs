//! Refusals of files that are not text.

use std::path::Path;

use crate::error::SheetError;

/// The error for a file that cannot be read.
pub(super) fn refused(path: &Path, why: impl std::fmt::Display) -> SheetError {
    SheetError::Format { path: path.into(), why: why.to_string() }
}

/// The outcome of a function that may panic, without the report that Rust prints for a panic; None if it did.
#[cfg(feature = "spreadsheet")]
pub(super) fn silently<T>(read: impl FnOnce() -> T + std::panic::UnwindSafe) -> Option<T> {
    use std::cell::Cell;
    use std::panic::{catch_unwind, set_hook, take_hook};
    use std::sync::Once;

    thread_local!(static IS_SILENT: Cell<bool> = const { Cell::new(false) });
    static ONCE: Once = Once::new();
    // Panics of other threads, and of this one at other times, keep their report.
    ONCE.call_once(|| {
        let report = take_hook();
        set_hook(Box::new(move |info| {
            if !IS_SILENT.get() {
                report(info);
            }
        }));
    });
    IS_SILENT.set(true);
    let outcome = catch_unwind(read);
    IS_SILENT.set(false);
    outcome.ok()
}
