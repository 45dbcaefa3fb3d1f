//! The smooth curve of Specker, which passes through the static level at a given velocity.

use crate::number::{Real, choose};

/// Levels and velocities of the curve.
#[derive(Clone, Copy)]
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
        let [half, one] = [0.5, 1.0].map(T::from);
        let u = velocity / self.peak_velocity;
        self.coulomb * (velocity / self.transition_velocity).tanh()
            + self.excess() * u * (half * (one - u * u)).exp()
            + self.viscous_coefficient * velocity
    }

    /// Its slope at v = 0: K_0 = f_C / v_0 + f_p exp(1/2) / v_Sp + c_v.
    #[inline(always)]
    pub fn slope_at_rest(&self) -> T {
        self.coulomb / self.transition_velocity
            + self.excess() * T::from(0.5).exp() / self.peak_velocity
            + self.viscous_coefficient
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

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
}
