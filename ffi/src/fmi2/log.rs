//! Messages to the importer through the logger of FMI 2.0.

use std::ffi::{CStr, CString, c_void};

pub use crate::component::log::{ALL, CATEGORIES, Category, DISCARD, ERROR, WARNING};

use super::types::{fmi2CallbackFunctions, fmi2Status};
use crate::component::log::{Level, Logger};
use stribeck::memory::{self, OutOfMemory};

/// The importer's callbacks, and the name of the instance that its logger gets.
pub(super) struct Callbacks {
    functions: fmi2CallbackFunctions,
    instance_name: CString,
}

// The environment pointer is only passed back to the importer, which must accept calls from any thread it uses.
impl Callbacks {
    pub fn new(functions: fmi2CallbackFunctions, instance_name: &CStr) -> Result<Callbacks, OutOfMemory> {
        Ok(Callbacks { functions, instance_name: memory::c_copy(instance_name)? })
    }
}

impl Logger for Callbacks {
    fn is_given(&self) -> bool {
        self.functions.logger.is_some()
    }

    unsafe fn send(&self, level: Level, category: &Category, text: &CStr) {
        let status = match level {
            Level::Warning => fmi2Status::fmi2Warning,
            Level::Discard => fmi2Status::fmi2Discard,
            Level::Error => fmi2Status::fmi2Error,
        };
        // SAFETY: the caller's promise.
        unsafe { send(&self.functions, &self.instance_name, status, category, text) };
    }
}

/// Calls the importer's logger, if there is one. It may throw.
///
/// # Safety
/// The callbacks must be those of an importer.
pub(super) unsafe fn send(
    callbacks: &fmi2CallbackFunctions,
    instance_name: &CStr,
    status: fmi2Status,
    category: &Category,
    text: &CStr,
) {
    let Some(logger) = callbacks.logger else { return };
    let environment: *mut c_void = callbacks.componentEnvironment;
    // SAFETY: the importer passed this function for this purpose. The message is the format "%s" with one argument, so
    // that no character of the text can be taken for a format; all texts are zero-terminated and outlive the call.
    unsafe {
        logger(environment, instance_name.as_ptr(), status, category.name.as_ptr(), c"%s".as_ptr(), text.as_ptr());
    }
}
