//! Motions with which others are compared.

use super::{POSITION, position};
use crate::run::{Passed, Settings, Solver, run};
use crate::system::{Fault, System};

/// A motion computed as exactly as possible.
#[derive(Clone, Debug)]
pub struct Reference {
    position: Vec<f64>,
    events: Vec<f64>,
    /// Tolerance at which it was computed.
    pub tolerance: f64,
    /// Its own error, in m, as the difference to a run at ten times its tolerance.
    pub uncertainty: f64,
}

/// Tolerances of a reference: with rates, and by steps of the models.
const TOLERANCES: [f64; 2] = [1e-12, 1e-8];

impl Reference {
    /// The reference of a system. None if it cannot be computed.
    pub fn of(system: &System, settings: &Settings) -> Result<Option<Reference>, Fault> {
        let solver = Solver::Auto.for_system(system);
        let tolerance = if solver == Solver::Steps { TOLERANCES[1] } else { TOLERANCES[0] };
        let at = |tolerance: f64| {
            run(system, &Settings { solver, tolerance, events: true, ..*settings }, &[POSITION.to_owned()])
        };
        let (coarse, fine) = (at(10.0 * tolerance)?, at(tolerance)?);
        if !(coarse.is_reached() && fine.is_reached()) {
            return Ok(None);
        }
        let mut reference = Reference {
            position: position(&fine).to_vec(),
            events: fine.events.iter().map(|event| event.time).collect(),
            tolerance,
            uncertainty: 0.0,
        };
        reference.uncertainty = reference.error(position(&coarse));
        Ok(Some(reference))
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
