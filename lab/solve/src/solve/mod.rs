//! Solvers of differential equations with events.
//!
//! Equations come as [`Equations`]; a solver advances them, gives the motion of every step to a [`Recorder`] and says how
//! it ended.

mod elimination;
mod event;
mod flow;
#[cfg(feature = "foreign")]
mod foreign;
mod judge;
mod march;
mod method;
mod moving;
mod piecewise;
mod recorder;
mod rodas5p;
mod rosenbrock23;
mod series;
mod snapping;
mod statistics;
mod step;

use std::sync::atomic::{AtomicBool, Ordering};

use stribeck::model::Bonds;

#[cfg(feature = "foreign")]
pub use foreign::{Foreign, solve_foreign};
pub use method::Method;
pub use recorder::{Grid, Recorder};
pub use statistics::{End, Event, Statistics};

/// Equations of motion dx/dt = f(t, x), whose course may change at events.
pub trait Equations {
    /// Number of states.
    fn states(&self) -> usize;

    /// Name of a state, for messages.
    fn state_name(&self, state: usize) -> String;

    /// Size of each state, by which an absolute tolerance is multiplied.
    fn scales(&self) -> &[f64];

    /// Writes the rates of the states. They may be NaN where the equations have no value.
    fn rates(&mut self, time: f64, states: &[f64], rates: &mut [f64]);

    /// Writes the derivatives of the rates with respect to the states, `jacobian[i n + j]` = df_i/dx_j, and to time.
    fn jacobian(&mut self, time: f64, states: &[f64], jacobian: &mut [f64], by_time: &mut [f64]);

    /// Writes the rates and what [`Equations::jacobian`] writes.
    fn linearise(&mut self, time: f64, states: &[f64], rates: &mut [f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        self.rates(time, states, rates);
        self.jacobian(time, states, jacobian, by_time);
    }

    /// Number of event indicators.
    fn indicators(&self) -> usize;

    /// Name of an event indicator, for messages.
    fn indicator_name(&self, indicator: usize) -> String;

    /// Writes the event indicators: an event is where one changes its sign.
    fn indicate(&mut self, time: f64, states: &[f64], indicators: &mut [f64]);

    /// Makes what changes at events change; may move states. A run begins with an event.
    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String>;

    /// Whether, between events, the rates are linear in the states and do not depend on time. Solvers check it in every step.
    fn is_piecewise_linear(&self) -> bool {
        false
    }

    /// The next time after `time` at which an input has a kink; infinite if there is none. No step extends across it.
    fn next_break(&self, _time: f64) -> f64 {
        f64::INFINITY
    }

    /// Takes note of a step that was made, with the states at each fraction of it.
    fn accept(&mut self, _begin: f64, _end: f64, _states_at: &dyn Fn(f64, &mut [f64])) {}

    /// Whether the equations change at a time at which a step has ended, although no indicator has changed its sign.
    fn is_due(&self, _time: f64) -> bool {
        false
    }

    /// Bonds that snap as a step goes on, where the step has come to. The rates depend on their mean strain, as if it were
    /// the state.
    fn tracks(&mut self) -> &mut [Track] {
        &mut []
    }

    /// Takes the work of the bonds in a step as energy, after the rates at the end of the step were evaluated.
    fn renew_tracks(&mut self) {}

    /// Number of further values to be recorded.
    fn recorded(&self) -> usize {
        0
    }

    /// Writes the further values to be recorded.
    fn record(&mut self, _time: f64, _states: &[f64], _values: &mut [f64]) -> Result<(), String> {
        Ok(())
    }
}

/// Bonds that snap within steps.
#[derive(Clone, Copy, Debug)]
pub struct Track {
    /// The state that is the strain of the first bond.
    pub state: usize,
    /// The bonds.
    pub bonds: Bonds,
}

/// Accuracy and limits of a run.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// Time at which the run begins.
    pub begin: f64,
    /// Time at which it ends.
    pub end: f64,
    /// Relative tolerance.
    pub relative: f64,
    /// Absolute tolerance, in parts of the size of each state.
    pub absolute: f64,
    /// Whether events are located. Otherwise a step may extend across them.
    pub events: bool,
    /// Largest number of steps, rejected ones included.
    pub most_steps: u64,
    /// Longest step.
    pub longest: f64,
    /// Set from outside to end the run early.
    pub cancel: Option<&'a AtomicBool>,
    /// Called now and then with the present time.
    pub progress: Option<&'a dyn Progress>,
}

/// Listener to the progress of a run.
pub trait Progress: Sync + std::fmt::Debug {
    /// The run has come to this time.
    fn reached(&self, time: f64);
}

/// Steps of a run after which it ends, if nothing else is said (chosen: a minute or more).
pub const MOST_STEPS: u64 = 100_000_000;

impl<'a> Options<'a> {
    /// A run from 0 to `end` with equal tolerances.
    pub fn new(end: f64, tolerance: f64) -> Options<'a> {
        Options {
            begin: 0.0,
            end,
            relative: tolerance,
            absolute: tolerance,
            events: true,
            most_steps: MOST_STEPS,
            longest: f64::INFINITY,
            cancel: None,
            progress: None,
        }
    }

    /// Whether the run is to end early.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

/// Solves the equations with one of our methods.
pub fn solve(
    method: Method,
    equations: &mut dyn Equations,
    states: &mut [f64],
    options: &Options,
    recorder: &mut Recorder,
) -> (End, Statistics) {
    method.run(equations, states, options, recorder)
}

#[cfg(test)]
mod tests;
