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

/// Largest number of events at one instant (chosen): parts in a chain may change one after the other.
const MOST_EVENTS: usize = 32;

/// Number of events (chosen) that are chatter if they lie within this part of a run (chosen).
const CHATTER: usize = 1000;
const CHATTER_SPAN: f64 = 1e-3;

impl Statistics {
    /// Notes an event of a run of this duration. Refused if events do not get on: at one instant, or ever closer, as those
    /// of a law that jumps where no force between the two sides is a solution of its equations.
    pub(super) fn pass(&mut self, event: Event, name: &str, duration: f64) -> Result<(), String> {
        let time = event.time;
        let same = |event: &&Event| (time - event.time).abs() <= 64.0 * f64::EPSILON * time.abs();
        let count = self.events.iter().rev().take_while(same).count();
        if count >= MOST_EVENTS {
            return Err(format!("{count} events at one instant, the last one of {name}"));
        }
        self.events.push(event);
        let first = self.events.len().checked_sub(CHATTER).map(|first| self.events[first].time);
        match first.map(|first| time - first) {
            Some(span) if span <= CHATTER_SPAN * duration => {
                Err(format!("{name} chatters: {CHATTER} events within {span:.3e} s"))
            }
            _ => Ok(()),
        }
    }
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
