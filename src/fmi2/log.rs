//! Messages to the importer, by category.

use std::ffi::{CStr, CString, c_void};
use std::fmt;

use super::types::{fmi2CallbackFunctions, fmi2Status};
use crate::memory::{self, OUT_OF_MEMORY, OutOfMemory};

/// A log category of FMI 2.0.5 section 2.2.4.
pub struct Category {
    /// Name, as it stands in modelDescription.xml.
    pub name: &'static CStr,
    /// What is reported under it.
    pub description: &'static str,
}

/// Refused values.
pub const DISCARD: Category =
    Category { name: c"logStatusDiscard", description: "Values that were refused, with the limit they break." };
/// Refused calls.
pub const ERROR: Category = Category { name: c"logStatusError", description: "Calls that failed, with the reason." };
/// The category that stands for all.
pub const ALL: Category = Category { name: c"logAll", description: "All messages." };

/// Every category of this library.
pub const CATEGORIES: [Category; 3] = [DISCARD, ERROR, ALL];

/// The importer's logger, and what it wants to hear.
pub(super) struct Log {
    callbacks: fmi2CallbackFunctions,
    instance_name: CString,
    pub discard: bool,
    pub error: bool,
}

// The environment pointer is only handed back to the importer, which must accept calls from any thread it uses.
impl Log {
    pub fn new(callbacks: fmi2CallbackFunctions, instance_name: &CStr, enabled: bool) -> Result<Log, OutOfMemory> {
        let instance_name = memory::c_copy(instance_name)?;
        Ok(Log { callbacks, instance_name, discard: enabled, error: enabled })
    }

    /// Switches the named category; `None` if there is none of that name.
    pub fn switch(&mut self, category: &CStr, enabled: bool) -> Option<()> {
        if category == DISCARD.name {
            self.discard = enabled;
        } else if category == ERROR.name {
            self.error = enabled;
        } else if category == ALL.name {
            (self.discard, self.error) = (enabled, enabled);
        } else {
            return None;
        }
        Some(())
    }

    /// Tells the importer why a call returned `status`, if it wants to hear of it.
    pub fn report(&self, status: fmi2Status, text: fmt::Arguments) {
        let (enabled, category) = match status {
            fmi2Status::fmi2Discard => (self.discard, &DISCARD),
            _ => (self.error, &ERROR),
        };
        if enabled {
            send(&self.callbacks, &self.instance_name, status, category, text);
        }
    }
}

/// Calls the importer's logger, if there is one.
pub(super) fn send(
    callbacks: &fmi2CallbackFunctions,
    instance_name: &CStr,
    status: fmi2Status,
    category: &Category,
    text: fmt::Arguments,
) {
    let Some(logger) = callbacks.logger else { return };
    let text = memory::c_text(&memory::text(Doubled(text)));
    let text = text.as_deref().unwrap_or(OUT_OF_MEMORY);
    let environment: *mut c_void = callbacks.componentEnvironment;
    // SAFETY: the importer passed this function for this purpose. The message is the format "%s" with one argument, so
    // that no character of the text can be taken for a format; all texts are zero-terminated and outlive the call.
    unsafe {
        logger(environment, instance_name.as_ptr(), status, category.name.as_ptr(), c"%s".as_ptr(), text.as_ptr());
    }
}

/// A text in which each `#` is doubled: a single one introduces a reference to a variable in FMI's messages.
struct Doubled<'a>(fmt::Arguments<'a>);

impl fmt::Display for Doubled<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        struct Doubling<'a, 'b>(&'a mut fmt::Formatter<'b>);
        impl fmt::Write for Doubling<'_, '_> {
            fn write_str(&mut self, text: &str) -> fmt::Result {
                for (at, piece) in text.split('#').enumerate() {
                    self.0.write_str(if at == 0 { "" } else { "##" })?;
                    self.0.write_str(piece)?;
                }
                Ok(())
            }
        }
        fmt::write(&mut Doubling(f), self.0)
    }
}
