//! Friction levels that differ between speeding up and slowing down.

use crate::number::Real;

/// One branch of a non-reversible law: from `at_rest` at rest to `coulomb` at high speed.
///
/// ```text
/// f(v) = f_C + (f_0 - f_C) exp(-a |v|)
/// ```
///
/// With f_0 = f_s it is the upper curve and falls; with f_0 < f_C it is the lower curve and rises.
#[inline(always)]
pub fn level<T: Real>(velocity: T, coulomb: T, at_rest: T, decay: T) -> T {
    coulomb + (at_rest - coulomb) * (-(decay * velocity.abs())).exp()
}

/// Whether the contact slows down. Only then the lower curve counts; at constant speed the upper one does.
#[inline(always)]
pub fn slows_down<T: Real>(velocity: T, acceleration: T) -> T::Mask {
    (velocity.sign() * acceleration.sign()).below(T::zero())
}

/// a |v| up to which a branch differs from the Coulomb level by more than exp(-40), which no sum of levels can resolve.
pub const FADED: f64 = 40.0;

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn half_of_the_difference_is_left_at_ln_2_over_a() {
        let v = -std::f64::consts::LN_2 / 500.0;
        assert_abs_diff_eq!(level(v, 1.0, 1.5, 500.0), 1.25, epsilon = 1e-15);
        assert_abs_diff_eq!(level(v, 1.0, 0.0, 500.0), 0.5, epsilon = 1e-15);
        assert_eq!(level(0.0, 1.0, 0.25, 500.0), 0.25);
        assert_eq!(level(1e308, 1.0, 0.25, 500.0), 1.0);
    }

    #[test]
    fn slowing_down_needs_motion_and_an_opposite_acceleration() {
        assert!(slows_down(1e-300, -1e-300) && slows_down(-2.0, 3.0));
        assert!(!slows_down(0.0, -1.0) && !slows_down(1.0, 0.0) && !slows_down(-1.0, -1.0));
    }
}
