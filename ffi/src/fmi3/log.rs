//! Messages to the importer through the callback of FMI 3.0.

use std::ffi::CStr;

use super::types::{fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3Status};
use crate::component::log::{Category, Level, Logger};

/// The importer's callback and the pointer that it gets back.
#[derive(Clone, Copy)]
pub(super) struct Messages {
    pub environment: fmi3InstanceEnvironment,
    pub callback: fmi3LogMessageCallback,
}

impl Logger for Messages {
    fn is_given(&self) -> bool {
        self.callback.is_some()
    }

    unsafe fn send(&self, level: Level, category: &Category, text: &CStr) {
        let Some(callback) = self.callback else { return };
        let status = match level {
            Level::Warning => fmi3Status::fmi3Warning,
            Level::Discard => fmi3Status::fmi3Discard,
            Level::Error => fmi3Status::fmi3Error,
        };
        // SAFETY: the importer passed this function for this purpose; the texts are zero-terminated and outlive the call.
        unsafe { callback(self.environment, status, category.name.as_ptr(), text.as_ptr()) };
    }
}
