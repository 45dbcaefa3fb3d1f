//! The smooth curve of Specker, which passes through the static level at a given velocity.

use crate::number::elementary::{exp, tanh};
use crate::number::{Real, choose};
use crate::numerics::root::bisect;

/// Levels and velocities of the curve.
#[derive(Clone, Copy, Debug)]
pub struct SpeckerCurve<T> {
    /// f_C.
    pub coulomb: T,
    /// f_s.
    pub breakaway: T,
    /// v_0.
    pub transition_velocity: T,
    /// v_Sp.
    pub peak_velocity: T,
    /// c_v.
    pub viscous_coefficient: T,
}

impl<T: Real> SpeckerCurve<T> {
    /// f_p: the part of the static level at v_Sp that the other terms leave; not negative, because it would drive the
    /// motion.
    #[inline(always)]
    fn excess(&self) -> T {
        let sliding = self.coulomb * (self.peak_velocity / self.transition_velocity).tanh();
        let excess = self.breakaway - sliding - self.viscous_coefficient * self.peak_velocity;
        choose!(excess.is_positive(), excess, T::zero())
    }

    /// The friction force:
    ///
    /// ```text
    /// f = f_C tanh(v / v_0) + f_p (v / v_Sp) exp(1/2 (1 - (v / v_Sp)^2)) + c_v v
    /// f_p = f_s - f_C tanh(v_Sp / v_0) - c_v v_Sp
    /// ```
    #[inline(always)]
    pub fn force(&self, velocity: T) -> T {
        self.sum(velocity, self.excess())
    }

    #[inline(always)]
    fn sum(&self, velocity: T, excess: T) -> T {
        let [half, one] = [0.5, 1.0].map(T::from);
        let u = velocity / self.peak_velocity;
        self.coulomb * (velocity / self.transition_velocity).tanh()
            + excess * u * (half * (one - u * u)).exp()
            + self.viscous_coefficient * velocity
    }

    /// Largest force without the viscous part, relative to f_s, and at least 1. Both other terms have not gone beyond
    /// their own levels, so that it stays below
    ///
    /// ```text
    /// f_C + f_p = f_s + f_C (1 - tanh(v_Sp / v_0))    without viscous part; with it f_p is smaller
    /// ```
    #[inline(never)]
    pub fn overshoot(&self) -> T {
        let on = || {
            let SpeckerCurve { coulomb, breakaway, transition_velocity, peak_velocity, viscous_coefficient } = *self;
            [coulomb, breakaway, transition_velocity, peak_velocity, viscous_coefficient]
        };
        // Its place does not matter for the derivative: there the curve is level.
        let [at, _] = T::found(on, |lane| [self.lane(lane).summit(), 0.0]);
        let largest =
            SpeckerCurve { viscous_coefficient: T::zero(), ..*self }.sum(at * self.peak_velocity, self.excess());
        choose!(largest.above(self.breakaway), largest / self.breakaway, T::from(1.0))
    }

    fn lane(&self, lane: usize) -> SpeckerCurve<f64> {
        SpeckerCurve {
            coulomb: self.coulomb.lane(lane),
            breakaway: self.breakaway.lane(lane),
            transition_velocity: self.transition_velocity.lane(lane),
            peak_velocity: self.peak_velocity.lane(lane),
            viscous_coefficient: self.viscous_coefficient.lane(lane),
        }
    }

    /// Its slope at v = 0: K_0 = f_C / v_0 + f_p exp(1/2) / v_Sp + c_v.
    #[inline(always)]
    pub fn slope_at_rest(&self) -> T {
        self.coulomb / self.transition_velocity
            + self.excess() * T::from(0.5).exp() / self.peak_velocity
            + self.viscous_coefficient
    }
}

/// Velocity, relative to v_Sp, beyond which hardly anything is left of f_p (chosen: 3e-5 of it).
const FAR: f64 = 5.0;

/// Number of velocities at which the summit is looked for (chosen).
const LOOKS: u32 = 64;

impl SpeckerCurve<f64> {
    /// Velocity, relative to v_Sp, of the largest force without the viscous part. Below v_Sp both terms rise.
    fn summit(&self) -> f64 {
        let (ratio, excess) = (self.peak_velocity / self.transition_velocity, self.excess());
        let dry = SpeckerCurve { viscous_coefficient: 0.0, ..*self };
        let force = |u: f64| dry.sum(u * self.peak_velocity, excess);
        let fall = |u: f64| {
            let level = tanh(ratio * u);
            excess * (u * u - 1.0) * exp(0.5 * (1.0 - u * u)) - self.coulomb * ratio * (1.0 - level * level)
        };
        let length = (FAR - 1.0) / f64::from(LOOKS);
        let places = (0..=LOOKS).map(|look| 1.0 + length * f64::from(look));
        let highest = places.max_by(|a, b| force(*a).total_cmp(&force(*b))).unwrap_or(1.0);
        let (low, high) = ((highest - length).max(1.0), highest + length);
        if fall(low) < 0.0 && fall(high) > 0.0 { bisect(fall, low, high) } else { highest }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::number::Dual;

    const DEFAULT: SpeckerCurve<f64> = SpeckerCurve {
        coulomb: 0.981,
        breakaway: 1.4715,
        transition_velocity: 2.5e-4,
        peak_velocity: 5e-4,
        viscous_coefficient: 0.0,
    };

    #[test]
    fn passes_through_the_static_level_for_any_velocities_and_viscosity() {
        for (transition_velocity, peak_velocity, viscous_coefficient) in
            [(1e-4, 1e-3, 0.0), (2e-3, 1e-3, 5.0), (2.5e-4, 5e-4, 100.0)]
        {
            let curve = SpeckerCurve { transition_velocity, peak_velocity, viscous_coefficient, ..DEFAULT };
            assert_abs_diff_eq!(curve.force(-peak_velocity), -1.4715, epsilon = 1e-14);
        }
    }

    #[test]
    fn slope_at_rest_is_that_of_the_curve() {
        assert_abs_diff_eq!(DEFAULT.slope_at_rest(), 5657.7588, epsilon = 1e-4);
        assert_abs_diff_eq!(DEFAULT.force(1e-9) / 1e-9 / DEFAULT.slope_at_rest(), 1.0, epsilon = 1e-9);
    }

    /// Against a fine scan of the curve; the bound of the text; and 1 where nothing is higher than f_s.
    #[test]
    fn overshoot_is_the_largest_force_of_the_curve() {
        for (breakaway, transition_velocity, viscous_coefficient) in [
            (1.4715, 2.5e-4, 0.0),
            (0.981, 2.5e-4, 0.0),
            (0.981, 5e-4, 0.0),
            (0.981, 1e-3, 0.0),
            (0.981, 5e-4, 400.0),
            (0.981, 5e-4, 1e4),
            (3.0, 1e-4, 100.0),
        ] {
            let curve = SpeckerCurve { breakaway, transition_velocity, viscous_coefficient, ..DEFAULT };
            let dry = |k: u32| {
                let velocity = f64::from(k) * 1e-7;
                curve.force(velocity) - viscous_coefficient * velocity
            };
            let largest = (0..100_000).map(dry).fold(breakaway, f64::max) / breakaway;
            let bound = 1.0 + 0.981 / breakaway * (1.0 - (5e-4 / transition_velocity).tanh());
            let found = curve.overshoot();
            assert!((found - largest).abs() < 1e-6, "{curve:?}: {found}, by scanning {largest}");
            assert!(found <= bound, "{curve:?}: {found} above {bound}");
        }
    }

    /// The derivative by mu_s against a difference quotient.
    #[test]
    fn overshoot_has_its_derivative() {
        let at = |breakaway: f64| SpeckerCurve { breakaway, ..DEFAULT }.overshoot();
        let dual = |value: f64, slope: f64| Dual { value, slope };
        let curve = SpeckerCurve {
            coulomb: dual(0.981, 0.0),
            breakaway: dual(1.2, 1.0),
            transition_velocity: dual(2.5e-4, 0.0),
            peak_velocity: dual(5e-4, 0.0),
            viscous_coefficient: dual(0.0, 0.0),
        };
        let quotient = (at(1.2 + 1e-5) - at(1.2 - 1e-5)) / 2e-5;
        assert!((curve.overshoot().slope / quotient - 1.0).abs() < 1e-5, "{quotient}");
    }
}
