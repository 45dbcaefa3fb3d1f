//! Exact solution of a linear relaxation.

/// Change of x over a time h for `dx/dt = rate (steady - x)`, given `decay = rate h`:
///
/// ```text
/// x(h) - x(0) = (steady - x(0)) (1 - exp(-decay))
/// ```
///
/// The change, and not x(h), because it keeps its relative accuracy when `decay` is tiny.
#[inline]
pub fn change(x: f64, steady: f64, decay: f64) -> f64 {
    -(steady - x) * (-decay).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_half_steps_are_one_step() {
        let whole = 1.0 + change(1.0, -2.0, 0.8);
        let half = 1.0 + change(1.0, -2.0, 0.4);
        let halves = half + change(half, -2.0, 0.4);
        assert!((whole - halves).abs() < 1e-15);
    }

    #[test]
    fn long_steps_arrive_and_tiny_steps_keep_their_digits() {
        assert_eq!(1.0 + change(1.0, 3.0, 1e300), 3.0);
        // For decay -> 0 the change is (steady - x) decay (1 - decay / 2).
        assert_eq!(change(0.0, 1.0, 1e-12), 1e-12 * (1.0 - 0.5e-12));
    }
}
