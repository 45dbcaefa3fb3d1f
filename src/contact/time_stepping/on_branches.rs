//! A contact with one curve for speeding up and another for slowing down.
//!
//! In a balance of forces both curves together are a set-valued law: between them the body keeps its velocity, because
//! it would slow down on the upper curve and speed up on the lower one,
//!
//! ```text
//! f = f_u   f_e > f_u              speeds up
//! f = f_e   f_l <= f_e <= f_u      keeps its velocity
//! f = f_l   f_e < f_l              slows down
//! ```
//!
//! with all forces in the direction of sliding. At rest f = f_e up to f_s, where the upper curve begins.

use super::on_curve::{Curve, OnCurve};
use super::phase::{NO_EVENT, Phase, resting};
use crate::number::{Mask, Real, choose};

/// Methods supplied by a law with two curves. [`Curve::curve`] is the one of the known acceleration.
pub(crate) trait Branches<T: Real>: Curve<T> {
    /// Levels while slowing down and while speeding up.
    fn levels(&self, velocity: T) -> [T; 2];
    /// Whether the balance of forces decides between them.
    fn is_by_balance(&self) -> T::Mask;
}

/// Event indicators of a law with two curves: of its phase, of the change between the curves twice, and of its load.
pub(crate) const EVENTS_ON_BRANCHES: usize = 4;

/// Acceleration, and part of the level, whose sign counts as that of 0 (chosen), so that no indicator stays at 0: on the
/// lower curve a body comes ever closer to a steady velocity.
const LEAST: f64 = 1e-9;

impl<T: Real, L: Branches<T>> OnCurve<'_, T, L> {
    /// Force of the balance while sliding.
    fn balanced(&self, velocity: T, direction: T) -> T {
        let [lower, upper] = self.law.levels(velocity);
        let along = (direction * self.external_force).larger(lower);
        direction * choose!(along.above(upper), upper, along)
    }

    /// Force of a law with two curves.
    pub(crate) fn on_branches(&self) -> T {
        let resting = || resting(self.phase, self.external_force, self.law.level());
        self.rests().choose(resting, || self.sliding_on_branches())
    }

    /// Its force while it slides.
    pub(crate) fn sliding_on_branches(&self) -> T {
        let slides = self.phase.slides();
        let velocity = choose!(slides, self.extended(), self.velocity);
        let direction = choose!(slides, self.phase.direction(), velocity.sign());
        self.law.is_by_balance().choose(|| self.balanced(velocity, direction), || self.law.curve(velocity))
    }
}

impl<L: Branches<f64>> OnCurve<'_, f64, L> {
    pub(crate) fn write_indicators_on_branches(&self, acceleration: f64, indicators: &mut [f64]) {
        self.write_indicators(indicators);
        indicators[1..3].copy_from_slice(&self.changes_of_branch(acceleration));
    }

    /// Event indicators of the change between the curves. `acceleration` is the one that is known if the balance does
    /// not decide.
    pub(crate) fn changes_of_branch(&self, acceleration: f64) -> [f64; 2] {
        match Phase::of(self.phase.0).direction() {
            None => [NO_EVENT; 2],
            Some(_) if !self.law.is_by_balance() => [acceleration + LEAST, NO_EVENT],
            Some(direction) => {
                let along = direction * self.external_force;
                let size = self.law.level() + along.abs();
                let excess = |level: f64| if size > 0.0 { (along - level) / size - LEAST } else { NO_EVENT };
                self.law.levels(self.extended()).map(excess)
            }
        }
    }
}
