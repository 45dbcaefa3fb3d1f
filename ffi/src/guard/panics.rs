//! Panics must neither cross a C interface nor print to the host's console.

use std::any::Any;
use std::panic::{self, PanicHookInfo};
use std::sync::OnceLock;

/// Silences the report that Rust prints for a panic in this library's code; all other panics keep their report. Called
/// when an instance is made through a C interface or follows the library to another address: every panic there is
/// caught and reported to the caller.
///
/// The location of the panic decides, not a thread-local flag: that would cost as much as a friction law on each call.
pub(crate) fn silence() {
    // A closure that captured the previous hook would leak 16 bytes whenever the library is unloaded.
    static REPORT: OnceLock<Box<Report>> = OnceLock::new();
    REPORT.get_or_init(|| {
        let report = panic::take_hook();
        panic::set_hook(Box::new(|info| {
            if !is_ours(info)
                && let Some(report) = REPORT.get()
            {
                report(info);
            }
        }));
        report
    });
}

type Report = dyn Fn(&PanicHookInfo<'_>) + Send + Sync;

fn is_ours(info: &PanicHookInfo) -> bool {
    info.location().is_some_and(|location| is_own_file(location.file()) || stribeck::is_own_file(location.file()))
}

/// Whether a source file belongs to this crate.
fn is_own_file(file: &str) -> bool {
    // Unit tests are in the same folder and keep their reports; only their probe panics on purpose.
    let beginning = if cfg!(test) { "probe.rs" } else { "" };
    let folder = file!().strip_suffix("guard/panics.rs").unwrap_or_default();
    file.strip_prefix(folder).is_some_and(|file| file.starts_with(beginning))
}

/// The message of a caught panic.
pub(crate) fn text(panic: &(dyn Any + Send)) -> String {
    let said = panic.downcast_ref::<&str>().copied();
    let said = said.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    stribeck::memory::text(format_args!("internal error, please report it: {}", said.unwrap_or("no message")))
}
