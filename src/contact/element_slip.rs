//! Onset of slip of Maxwell-slip elements at the events of Model Exchange.

use crate::contact::time_stepping::{MOVED, NO_EVENT, PASSED, Phase, REACHED};
use crate::contact::unloading;
use crate::number::Real;

/// Event indicators of a law with elements: of the onset of slip, of its end, and of the load.
pub(crate) const EVENTS_OF_ELEMENTS: usize = 3;

/// A spring that slips at its strength.
pub(crate) struct Onset {
    /// Direction of slip that the last event has found.
    pub slip: Phase,
    pub force: f64,
    pub strength: f64,
    /// Rate of its deflection.
    pub speed: f64,
}

impl Onset {
    /// Force in the direction in which it may begin to slip, in parts of the strength, and speed, in parts of the least one
    /// that counts.
    fn outward(&self) -> [f64; 2] {
        let direction = self.slip.direction().unwrap_or(self.force.sign());
        [direction * self.force / self.strength, direction * self.speed / MOVED]
    }

    /// Positive until it slips.
    fn indicator(&self) -> f64 {
        let [stretch, speed] = self.outward();
        (1.0 + REACHED - stretch).max(PASSED - speed)
    }

    /// Whether it begins to slip at an event. The limits lie between those of the indicator.
    pub(crate) fn is_due(&self) -> bool {
        let [stretch, speed] = self.outward();
        stretch >= 1.0 + 0.5 * REACHED && speed > 0.5 * PASSED
    }
}

/// The indicators for the elements that stick; `onward` is positive until the slip of the others ends.
pub(crate) fn indicators(
    sticking: impl Iterator<Item = Onset>,
    onward: Option<f64>,
    normal_force: f64,
) -> [f64; EVENTS_OF_ELEMENTS] {
    let onset = sticking.map(|element| element.indicator()).fold(NO_EVENT, f64::min);
    [onset, onward.unwrap_or(NO_EVENT), unloading::load(normal_force)]
}
