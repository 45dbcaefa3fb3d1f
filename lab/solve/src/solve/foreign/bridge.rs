//! Equations as other crates want them: by shared reference.

use std::cell::{Cell, RefCell};

use crate::solve::Equations;

/// Equations that count how often they are evaluated.
pub(super) struct Bridge<'a> {
    equations: RefCell<&'a mut dyn Equations>,
    evaluations: Cell<u64>,
    jacobians: Cell<u64>,
    /// State whose rate was not finite at the last evaluation.
    broken: Cell<Option<usize>>,
}

impl<'a> Bridge<'a> {
    pub fn new(equations: &'a mut dyn Equations) -> Bridge<'a> {
        Bridge {
            equations: RefCell::new(equations),
            evaluations: Cell::new(0),
            jacobians: Cell::new(0),
            broken: Cell::new(None),
        }
    }

    /// The equations themselves, for what a crate does not ask for.
    pub fn with<T>(&self, act: impl FnOnce(&mut dyn Equations) -> T) -> T {
        act(&mut **self.equations.borrow_mut())
    }

    pub fn rates(&self, time: f64, states: &[f64], rates: &mut [f64]) {
        self.evaluations.set(self.evaluations.get() + 1);
        self.equations.borrow_mut().rates(time, states, rates);
        self.broken.set(rates.iter().position(|rate| !rate.is_finite()));
    }

    pub fn jacobian(&self, time: f64, states: &[f64], jacobian: &mut [f64]) {
        self.jacobians.set(self.jacobians.get() + 1);
        let mut by_time = vec![0.0; states.len()];
        self.equations.borrow_mut().jacobian(time, states, jacobian, &mut by_time);
    }

    /// Evaluations of rates and Jacobian so far.
    pub fn counts(&self) -> (u64, u64) {
        (self.evaluations.get(), self.jacobians.get())
    }

    /// A crate's reason to give up, with the rate that was not finite when it did.
    pub fn reason(&self, text: String) -> String {
        match self.broken.get() {
            Some(state) => format!("{text}; the rate of {} is not finite", self.with(|it| it.state_name(state))),
            None => text,
        }
    }
}
