//! Progress of runs that are parts of a longer work.

use crate::solve::Progress;

/// Listener to a run that is a part of the work.
#[derive(Debug)]
pub struct Share<'a> {
    /// Listener to the whole work.
    pub whole: &'a dyn Progress,
    /// Time that is told when the run begins.
    pub begin: f64,
    /// Part of the whole work.
    pub part: f64,
}

impl Progress for Share<'_> {
    fn reached(&self, time: f64) {
        self.whole.reached(self.begin + self.part * time);
    }
}
