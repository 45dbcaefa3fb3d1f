//! Smooth replacements of the sign function.

use crate::number::{Real, choose};

/// Exponential transition: 1 - exp(-3) = 95 % of the sign function at `transition_velocity`.
///
/// ```text
/// (1 - exp(-3 |v| / v_0)) sgn(v)
/// ```
///
/// Threlfall (1978), Mechanism and Machine Theory 13, 475-483.
#[inline(always)]
pub fn exponential<T: Real>(velocity: T, transition_velocity: T) -> T {
    rise(velocity, T::from(3.0) / transition_velocity)
}

/// (1 - exp(-slope |v|)) sgn(v).
#[inline(always)]
pub fn rise<T: Real>(velocity: T, slope: T) -> T {
    // |v| has no derivative at rest, but the odd function has the same one on both sides.
    choose!(velocity.vanishes(), slope * velocity, (T::from(1.0) - (-(slope * velocity.abs())).exp()) * velocity.sign())
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::number::Dual;

    #[test]
    fn transition_reaches_95_percent() {
        assert_abs_diff_eq!(exponential(0.01, 0.01), 0.950_212_932, epsilon = 1e-9);
        assert_abs_diff_eq!(exponential(-1.0, 0.01), -1.0, epsilon = 1e-15);
    }

    #[test]
    fn slope_at_rest_is_that_of_both_sides() {
        for value in [0.0, 1e-12, -1e-12] {
            let slope = rise(Dual { value, slope: 1.0 }, Dual::from(7.0)).slope;
            assert!((slope - 7.0).abs() < 1e-9, "{value}: {slope}");
        }
    }
}
