//! Exact solution of a linear relaxation.

use crate::number::{Real, choose};

/// x after a time h of `dx/dt = rate (steady - x)`, given `decay = rate h`:
///
/// ```text
/// x(h) = steady + (x(0) - steady) exp(-decay)
/// ```
#[inline(always)]
pub fn after<T: Real>(x: T, steady: T, decay: T) -> T {
    // The first form keeps its digits if little changes, the second if nothing of x(0) remains.
    choose!(decay.below(T::from(1.0)), x - (steady - x) * (-decay).exp_m1(), steady + (x - steady) * (-decay).exp())
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn two_half_steps_are_one_step() {
        for decay in [1e-9, 0.8, 1.7, 30.0] {
            let halves = after(after(1.0, -2.0, 0.5 * decay), -2.0, 0.5 * decay);
            assert!((after(1.0, -2.0, decay) - halves).abs() < 1e-15, "{decay}");
        }
    }

    #[test]
    fn long_steps_arrive_exactly_and_tiny_steps_keep_their_digits() {
        assert_eq!(after(1.0, 1e-300, 1e300), 1e-300);
        // For decay -> 0 from x = 0: steady decay (1 - decay / 2).
        assert_eq!(after(0.0, 1.0, 1e-12), 1e-12 * (1.0 - 0.5e-12));
    }

    #[test]
    fn the_two_forms_meet() {
        let (below, above) = (after(1.0, 3.0, 1.0 - 1e-15), after(1.0, 3.0, 1.0));
        assert_abs_diff_eq!(below, above, epsilon = 3e-15);
    }
}
