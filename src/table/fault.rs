//! The reason why something was refused.

use std::fmt;

use crate::memory::{self, OutOfMemory};

/// Why a value, or a set of parameters, was refused. The text names the variable, its value and the limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub String);

impl Fault {
    /// A fault with this text, truncated if memory runs out.
    pub fn new(text: impl fmt::Display) -> Fault {
        Fault(memory::text(text))
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

impl From<OutOfMemory> for Fault {
    fn from(error: OutOfMemory) -> Fault {
        Fault::new(error)
    }
}
