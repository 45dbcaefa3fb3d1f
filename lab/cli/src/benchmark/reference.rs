//! Motions with which others are compared.

use super::{POSITION, RIGHT, position};
use stribeck_solve::run::{Outcome, Passed, Settings, Solver, run};
use stribeck_solve::system::{Fault, System};

/// A motion computed as exactly as possible.
#[derive(Clone, Debug)]
pub struct Reference {
    position: Vec<f64>,
    events: Vec<f64>,
    /// Solver and tolerance by which it was computed.
    pub by: (Solver, f64),
    /// Its own error, in m, as the difference from a run at ten times its tolerance.
    pub uncertainty: f64,
    /// Largest difference from it, in m, of a run with [`Reference::OTHER`], or why there is none.
    pub other: Result<f64, String>,
    /// Largest difference from it, in m, of a motion that starts [`Reference::SHIFT`] beside it.
    pub growth: f64,
}

/// The outcome of a run that comes to its end.
fn reached(system: &System, settings: &Settings) -> Result<Outcome, String> {
    let outcome = run(system, settings, &[POSITION.to_owned()]).map_err(|fault: Fault| fault.to_string())?;
    if outcome.is_reached() { Ok(outcome) } else { Err(format!("at {:e}: {}", settings.tolerance, outcome.end)) }
}

impl Reference {
    /// Solver and tolerance of the reference of a system: steps are of second order.
    fn ours(system: &System) -> (Solver, f64) {
        match Solver::Auto.for_system(system) {
            Solver::Steps => (Solver::Steps, 1e-9),
            other => (other, 1e-12),
        }
    }

    /// Solver and tolerance of a second opinion: another method, from another library.
    pub const OTHER: (Solver, f64) = (Solver::Dopri5, 1e-11);

    /// Error of the start, in m, whose growth is measured (chosen: well above rounding and below all that matters).
    pub const SHIFT: f64 = 1e-9;

    /// The reference of a system, or why it has none.
    pub fn of(system: &System, settings: &Settings) -> Result<Reference, String> {
        let at = |(solver, tolerance)| Settings { solver, tolerance, events: true, ..*settings };
        let by = Reference::ours(system);
        let fine = reached(system, &at(by))?;
        let mut reference = Reference {
            position: position(&fine).to_vec(),
            events: fine.events.iter().map(|event| event.time).collect(),
            by,
            uncertainty: 0.0,
            other: Err(String::new()),
            growth: 0.0,
        };
        let error = |outcome: Outcome| reference.error(position(&outcome));
        let uncertainty = error(reached(system, &at((by.0, 10.0 * by.1)))?);
        let other = reached(system, &at(Reference::OTHER)).map(error);
        let growth = error(reached(&beside(system)?, &at(by))?);
        (reference.uncertainty, reference.other, reference.growth) = (uncertainty, other, growth);
        Ok(reference)
    }

    /// Whether the motion is known well enough to judge others by it: neither a tolerance, another code nor a nanometre
    /// at the start changes whether it is right.
    pub fn is_certain(&self) -> bool {
        let other = self.other.as_ref().map_or(0.0, |other| *other);
        [self.uncertainty, other, self.growth].into_iter().all(|difference| difference <= RIGHT)
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

/// The system with its block shifted.
fn beside(system: &System) -> Result<System, String> {
    let mut shifted = system.clone();
    let place = shifted.place(POSITION).map_err(|fault| fault.to_string())?;
    shifted.parts[place.part].row[place.column] += Reference::SHIFT;
    Ok(shifted)
}
