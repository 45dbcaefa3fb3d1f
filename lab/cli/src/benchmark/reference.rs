//! Motions with which others are compared.

use std::time::Duration;

use super::{POSITION, counts, position};
use stribeck_solve::run::{Outcome, Passed, Settings, Solver, run};
use stribeck_solve::system::{Fault, System};

/// A motion computed as exactly as possible.
#[derive(Clone, Debug)]
pub struct Reference {
    position: Vec<f64>,
    events: Vec<f64>,
    /// Tolerance at which it was computed.
    pub tolerance: f64,
    /// Its own error, in m, as the difference from a run at ten times its tolerance.
    pub uncertainty: f64,
    /// Steps, rejected steps, evaluations of the rates, Jacobians, events.
    pub counts: [u64; 5],
    /// Time on the clock.
    pub time: Duration,
    /// Largest difference from it, in m, of a run with [`Reference::OTHER`], or why there is none.
    pub other: Result<f64, String>,
}

/// Tolerances of a reference: with rates, and by steps of the models.
const TOLERANCES: [f64; 2] = [1e-12, 1e-8];

/// The outcome of a run that comes to its end.
fn reached(system: &System, settings: &Settings) -> Result<Outcome, String> {
    let outcome = run(system, settings, &[POSITION.to_owned()]).map_err(|fault: Fault| fault.to_string())?;
    if outcome.is_reached() { Ok(outcome) } else { Err(format!("at {:e}: {}", settings.tolerance, outcome.end)) }
}

impl Reference {
    /// Solver and tolerance of a second opinion: another method, from another library.
    pub const OTHER: (Solver, f64) = (Solver::Dopri5, 1e-11);

    /// The reference of a system, or why it has none.
    pub fn of(system: &System, settings: &Settings) -> Result<Reference, String> {
        let solver = Solver::Auto.for_system(system);
        let tolerance = if solver == Solver::Steps { TOLERANCES[1] } else { TOLERANCES[0] };
        let at = |solver, tolerance| reached(system, &Settings { solver, tolerance, events: true, ..*settings });
        let (coarse, fine) = (at(solver, 10.0 * tolerance)?, at(solver, tolerance)?);
        let mut reference = Reference {
            position: position(&fine).to_vec(),
            events: fine.events.iter().map(|event| event.time).collect(),
            tolerance,
            uncertainty: 0.0,
            counts: counts(&fine),
            time: fine.elapsed,
            other: Err("its steps are its own".to_owned()),
        };
        reference.uncertainty = reference.error(position(&coarse));
        if solver != Solver::Steps {
            let (other, tolerance) = Reference::OTHER;
            reference.other = at(other, tolerance).map(|outcome| reference.error(position(&outcome)));
        }
        Ok(reference)
    }

    /// Largest difference of a position from this one.
    pub fn error(&self, position: &[f64]) -> f64 {
        position.iter().zip(&self.position).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// Largest difference of the times of events; none if there are none, or more or fewer of them.
    pub fn switching(&self, events: &[Passed]) -> Option<f64> {
        if events.is_empty() || events.len() != self.events.len() {
            return None;
        }
        Some(events.iter().zip(&self.events).map(|(event, time)| (event.time - time).abs()).fold(0.0, f64::max))
    }
}
