//! Solvers of other crates, for comparison.
//!
//! A crate's solver runs from event to event and from break to break of the inputs, and is started anew there. Step sizes,
//! errors and motion within a step are the crate's.

mod bridge;
mod diffsol;
mod ode_solvers;

use super::{End, Equations, Event, Options, Recorder, Statistics};
use bridge::Bridge;

/// A solver of another crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Foreign {
    /// Explicit Runge-Kutta method of order 5 of Dormand and Prince, of ode_solvers: the class of ode45.
    Dopri5,
    /// Explicit Runge-Kutta method of order 8 of Dormand and Prince, of ode_solvers: the class of ode78. Without events.
    Dop853,
    /// Backward differentiation formulas of orders 1 to 5, of diffsol: the class of ode15s.
    Bdf,
    /// Trapezoidal rule and backward differentiation formula in one step, of diffsol: the class of ode23tb.
    TrBdf2,
    /// Diagonally implicit Runge-Kutta method of order 3, of diffsol.
    Esdirk34,
}

impl Foreign {
    /// Whether it locates events.
    pub fn has_events(self) -> bool {
        self != Foreign::Dop853
    }
}

/// A run under way.
struct Run<'r, 'e> {
    bridge: &'r Bridge<'e>,
    options: &'r Options<'r>,
    recorder: &'r mut Recorder,
    statistics: Statistics,
    scales: &'r [f64],
    time: f64,
    states: Vec<f64>,
}

/// Where a solver stopped.
enum Stop {
    /// At the time to which it was to run.
    Wall,
    /// Before that, to go on from there.
    Between,
    /// At an event of this indicator.
    Event(usize),
    /// Cancelled.
    Cancelled,
}

/// Steps between two reports of progress (chosen).
const LOOK: u64 = 256;

/// Solves the equations with a solver of another crate.
pub fn solve_foreign(
    kind: Foreign,
    equations: &mut dyn Equations,
    states: &mut [f64],
    options: &Options,
    recorder: &mut Recorder,
) -> (End, Statistics) {
    let scales = equations.scales().to_vec();
    let bridge = Bridge::new(equations);
    let mut run = Run {
        scales: &scales,
        bridge: &bridge,
        options,
        recorder,
        statistics: Statistics::default(),
        time: options.begin,
        states: states.to_vec(),
    };
    let end = match run.go(kind) {
        Ok(end) => end,
        Err(reason) => End::Failed { time: run.time, reason: bridge.reason(reason) },
    };
    states.copy_from_slice(&run.states);
    (run.statistics.evaluations, run.statistics.jacobians) = bridge.counts();
    (end, run.statistics)
}

impl Run<'_, '_> {
    fn go(&mut self, kind: Foreign) -> Result<End, String> {
        if self.options.events && self.has_indicators() && !kind.has_events() {
            return Err("the solver does not locate events".to_owned());
        }
        self.at_event()?;
        self.record_due()?;
        while self.time < self.options.end {
            let wall = self.bridge.with(|equations| equations.next_break(self.time)).min(self.options.end);
            let stop = match kind {
                Foreign::Dopri5 => ode_solvers::dopri5(self, wall)?,
                Foreign::Dop853 => ode_solvers::dop853(self, wall)?,
                Foreign::Bdf | Foreign::TrBdf2 | Foreign::Esdirk34 => diffsol::piece(self, kind, wall)?,
            };
            if let Stop::Wall = stop {
                self.time = wall;
            }
            self.record_due()?;
            match stop {
                Stop::Wall | Stop::Between => {}
                Stop::Event(indicator) => {
                    let name = self.bridge.with(|equations| equations.indicator_name(indicator));
                    let duration = self.options.end - self.options.begin;
                    self.statistics.pass(Event { time: self.time, indicator }, &name, duration)?;
                    self.at_event()?;
                }
                Stop::Cancelled => return Ok(End::Cancelled { time: self.time }),
            }
        }
        Ok(End::Reached)
    }

    fn has_indicators(&self) -> bool {
        self.bridge.with(|equations| equations.indicators()) > 0
    }

    /// Whether events are to be located.
    fn has_events(&self) -> bool {
        self.options.events && self.has_indicators()
    }

    fn at_event(&mut self) -> Result<(), String> {
        self.bridge.with(|equations| equations.at_event(self.time, &mut self.states))
    }

    /// Records the output times that the run has come to.
    fn record_due(&mut self) -> Result<(), String> {
        while self.recorder.is_due(self.time) {
            self.bridge.with(|equations| self.recorder.point(equations, &self.states))?;
        }
        Ok(())
    }

    /// Steps that may still be made.
    fn steps_left(&self) -> u64 {
        self.options.most_steps.saturating_sub(self.statistics.steps + self.statistics.rejected)
    }

    fn too_many_steps(&self) -> String {
        format!("more than {} steps", self.options.most_steps)
    }

    /// Goes to the end of a step.
    fn arrive(&mut self, time: f64, states: &[f64]) -> Result<(), String> {
        if let Some(state) = states.iter().position(|state| !state.is_finite()) {
            let name = self.bridge.with(|equations| equations.state_name(state));
            return Err(format!("{name} is not finite"));
        }
        self.time = time;
        self.states.copy_from_slice(states);
        report(self.options, self.statistics.steps, time);
        Ok(())
    }
}

/// Reports progress now and then.
fn report(options: &Options, steps: u64, time: f64) {
    if let (0, Some(progress)) = (steps % LOOK, options.progress) {
        progress.reached(time);
    }
}
