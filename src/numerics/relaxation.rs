//! Exact solution of a linear relaxation.

use crate::number::{Mask, Real, choose};

/// x after a time h of `dx/dt = rate (steady - x)`, given `decay = rate h`:
///
/// ```text
/// x(h) = steady + (x(0) - steady) exp(-decay)
/// ```
#[inline(always)]
pub fn after<T: Real>(x: T, steady: T, decay: T) -> T {
    // The first form keeps its digits if little changes, the second if nothing of x(0) remains.
    choose!(decay.below(SHORT.into()), short(x, steady, (-decay).exp_m1()), long(x, steady, (-decay).exp()))
}

const SHORT: f64 = 1.0;

#[inline(always)]
fn short<T: Real>(x: T, steady: T, change: T) -> T {
    x - (steady - x) * change
}

#[inline(always)]
fn long<T: Real>(x: T, steady: T, rest: T) -> T {
    steady + (x - steady) * rest
}

/// A relaxation over a time, whatever x it begins with.
#[derive(Clone, Copy, Debug)]
pub struct Relaxation<T> {
    /// The steady x.
    pub steady: T,
    /// exp(-decay) - 1 if the time is short, otherwise exp(-decay).
    pub factor: T,
    /// 1 if the time is short, otherwise 0.
    pub is_short: T,
}

/// Numbers of a [`Relaxation`].
pub const NUMBERS: usize = 3;

impl<T> From<[T; NUMBERS]> for Relaxation<T> {
    #[inline(always)]
    fn from([steady, factor, is_short]: [T; NUMBERS]) -> Relaxation<T> {
        Relaxation { steady, factor, is_short }
    }
}

impl<T> From<Relaxation<T>> for [T; NUMBERS] {
    #[inline(always)]
    fn from(Relaxation { steady, factor, is_short }: Relaxation<T>) -> [T; NUMBERS] {
        [steady, factor, is_short]
    }
}

impl<T: Real> Relaxation<T> {
    /// That with a decay; where the answer is no, x is dropped, whatever it was.
    #[inline(always)]
    pub fn of(steady: T, decay: T, goes_on: T::Mask) -> Relaxation<T> {
        let is_short = decay.below(SHORT.into());
        let factor = choose!(is_short, (-decay).exp_m1(), (-decay).exp());
        let zero = T::zero();
        Relaxation {
            steady: goes_on.select(steady, zero),
            factor: goes_on.select(factor, zero),
            is_short: T::truth(is_short & goes_on),
        }
    }
}

impl Relaxation<f64> {
    /// [`after`], with the same bits. The numbers of many times are found first, side by side; this is what is left to be
    /// done one after the other.
    #[inline(always)]
    pub fn after(self, x: f64) -> f64 {
        let [short, long] = [short(x, self.steady, self.factor), long(x, self.steady, self.factor)];
        if self.is_short == 0.0 { long } else { short }
    }
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
