//! Slopes of inputs over a step.

use crate::memory::{self, OutOfMemory};

/// Slopes of the inputs. They are given for one step and then used up; after it they say how the inputs moved.
pub(super) struct Slopes {
    values: Box<[f64]>,
    step: Step,
}

/// The step that slopes belong to.
#[derive(Clone, Copy, PartialEq)]
enum Step {
    /// No slope is nonzero.
    None,
    Last,
    Next,
}

impl Slopes {
    pub fn none(columns: usize) -> Result<Slopes, OutOfMemory> {
        Ok(Slopes { values: memory::filled(0.0, columns)?, step: Step::None })
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    pub fn are_for_next_step(&self) -> bool {
        self.step == Step::Next
    }

    #[inline(always)]
    pub fn are_none(&self) -> bool {
        self.step == Step::None
    }

    pub fn clear(&mut self) {
        self.values.fill(0.0);
        self.step = Step::None;
    }

    pub fn set(&mut self, column: usize, slope: f64) {
        if self.step != Step::Next {
            self.clear();
        }
        self.step = Step::Next;
        self.values[column] = slope;
    }

    /// A step has been made.
    pub fn use_up(&mut self) {
        match self.step {
            Step::Next => self.step = Step::Last,
            Step::Last => self.clear(),
            Step::None => {}
        }
    }

    pub fn restore(&mut self, values: &[f64], are_for_next_step: bool) {
        self.values.copy_from_slice(values);
        self.step = if are_for_next_step { Step::Next } else { Step::Last };
    }
}
