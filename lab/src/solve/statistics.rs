//! What a run has cost and how it ended.

/// Cost of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Steps that became part of the motion.
    pub steps: u64,
    /// Steps that were made again, because their error was too large or to end at an event.
    pub rejected: u64,
    /// Evaluations of the rates.
    pub evaluations: u64,
    /// Evaluations of the Jacobian.
    pub jacobians: u64,
    /// Events, in order.
    pub events: Vec<Event>,
}

/// An event.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// When it occurred.
    pub time: f64,
    /// Number of the indicator that changed its sign.
    pub indicator: usize,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// It came to its end.
    Reached,
    /// It did not converge.
    Failed {
        /// Where it stopped.
        time: f64,
        /// Why.
        reason: String,
    },
    /// It was ended from outside.
    Cancelled {
        /// Where it stopped.
        time: f64,
    },
}

impl End {
    /// Whether the run came to its end.
    pub fn is_reached(&self) -> bool {
        *self == End::Reached
    }
}

impl std::fmt::Display for End {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            End::Reached => write!(f, "reached"),
            End::Failed { time, reason } => write!(f, "did not converge at {time} s: {reason}"),
            End::Cancelled { time } => write!(f, "cancelled at {time} s"),
        }
    }
}
