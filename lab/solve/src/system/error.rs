//! Why a system is refused.

/// Why a system, or a value for it, is refused; nothing was done.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Something is named that does not exist.
    #[error("{what} '{name}' does not exist{}", hint(.closest))]
    Unknown {
        /// What was looked for: a model, a variable of a part ...
        what: String,
        /// The name.
        name: String,
        /// The most similar name that exists.
        closest: Option<String>,
    },
    /// The units at the ends of a connection differ.
    #[error("{to} [{to_unit}] cannot be connected to {from} [{from_unit}]: the units differ")]
    Unit {
        /// The input.
        to: String,
        /// Its unit.
        to_unit: String,
        /// The output.
        from: String,
        /// Its unit.
        from_unit: String,
    },
    /// An input has neither a connection nor a signal.
    #[error("{input} is open: it needs a connection or a signal")]
    Open {
        /// The input.
        input: String,
    },
    /// A law with a balance of forces gets none.
    #[error(
        "{input} is held at 0, but with acceleration_source = Balance friction follows it: connect it, or set Input"
    )]
    Unbalanced {
        /// The external force.
        input: String,
    },
    /// Outputs depend on each other in a circle.
    #[error("{outputs} depend on each other at one instant: such a loop cannot be solved")]
    Loop {
        /// The outputs in the circle.
        outputs: String,
    },
    /// A value is not admitted.
    #[error("{0}")]
    Value(String),
    /// The file is not a system.
    #[error("{0}")]
    File(String),
}

fn hint(closest: &Option<String>) -> String {
    closest.as_ref().map_or(String::new(), |name| format!(" (did you mean '{name}'?)"))
}

impl Fault {
    /// Something is named that does not exist.
    pub fn unknown<'a>(what: impl Into<String>, name: &str, known: impl IntoIterator<Item = &'a str>) -> Fault {
        Fault::Unknown { what: what.into(), name: name.to_owned(), closest: super::closest(name, known) }
    }

    /// A value is refused.
    pub fn value(text: impl std::fmt::Display) -> Fault {
        Fault::Value(text.to_string())
    }
}
