//! Progress of runs that are parts of a longer work.

use crate::solve::Progress;

/// Listener to a run that is a part of the work.
#[derive(Debug)]
pub struct Share<'a> {
    /// Listener to the whole work.
    pub whole: &'a dyn Progress,
    /// Time that is reported when the run begins.
    pub begin: f64,
    /// Part of the whole work.
    pub part: f64,
}

impl Progress for Share<'_> {
    fn reached(&self, time: f64) {
        self.whole.reached(self.begin + self.part * time);
    }
}

/// Times that were reported, for tests.
#[cfg(test)]
#[derive(Debug, Default)]
pub struct Heard(pub std::sync::Mutex<Vec<f64>>);

#[cfg(test)]
impl Progress for Heard {
    fn reached(&self, time: f64) {
        self.0.lock().unwrap().push(time);
    }
}
