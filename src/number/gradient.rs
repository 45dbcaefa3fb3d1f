//! A value and its derivatives in several directions, for a Jacobian in one evaluation.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::differentiated::{compared, differentiated};
use super::{Dual, Real, elementary};

/// Number of directions of a [`Gradient`] (chosen): a bench with a law has two to four states.
pub const DIRECTIONS: usize = 4;

/// A value and its derivatives in [`DIRECTIONS`] directions, each of them that of a [`Dual`].
///
/// A question about all directions at once has one answer: [`Real::is`] is false if the number changes in any of them.
/// [`Real::rises`] has none, and is false; laws that have rates use [`Real::pushed_back`], which looks at each direction.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gradient {
    /// The value.
    pub value: f64,
    /// Its derivatives.
    pub slopes: [f64; DIRECTIONS],
}

impl Gradient {
    /// Whether it changes in any direction.
    pub fn has_slope(self) -> bool {
        self.slopes.iter().any(|slope| *slope != 0.0)
    }

    /// The number in one direction.
    pub fn along(self, direction: usize) -> Dual {
        Dual { value: self.value, slope: self.slopes[direction] }
    }

    /// Result of an operation in each direction; its value is the same in all.
    #[inline(always)]
    fn each(along: impl Fn(usize) -> Dual) -> Gradient {
        Gradient::of(along(0).value, |i| along(i).slope)
    }

    #[inline(always)]
    fn of(value: f64, slope: impl Fn(usize) -> f64) -> Gradient {
        Gradient { value, slopes: std::array::from_fn(slope) }
    }

    /// As for a [`Dual`].
    fn chain(self, value: f64, derivative: f64) -> Gradient {
        Gradient::of(value, |i| if self.slopes[i] == 0.0 { 0.0 } else { derivative * self.slopes[i] })
    }

    /// As for a [`Dual`].
    fn with_slope_of(self, other: Gradient) -> Gradient {
        Gradient::of(self.value, |i| self.slopes[i] + other.slopes[i])
    }
}

impl From<f64> for Gradient {
    fn from(value: f64) -> Gradient {
        Gradient { value, slopes: [0.0; DIRECTIONS] }
    }
}

compared!(Gradient);

impl Add for Gradient {
    type Output = Gradient;
    fn add(self, other: Gradient) -> Gradient {
        Gradient::each(|i| self.along(i) + other.along(i))
    }
}

impl Sub for Gradient {
    type Output = Gradient;
    fn sub(self, other: Gradient) -> Gradient {
        Gradient::each(|i| self.along(i) - other.along(i))
    }
}

impl Mul for Gradient {
    type Output = Gradient;
    fn mul(self, other: Gradient) -> Gradient {
        Gradient::each(|i| self.along(i) * other.along(i))
    }
}

impl Div for Gradient {
    type Output = Gradient;
    fn div(self, other: Gradient) -> Gradient {
        Gradient::each(|i| self.along(i) / other.along(i))
    }
}

impl Neg for Gradient {
    type Output = Gradient;
    fn neg(self) -> Gradient {
        Gradient::of(-self.value, |i| -self.slopes[i])
    }
}

impl Real for Gradient {
    differentiated!();

    /// Each direction by itself: the limit may retreat in one of them and not in another.
    fn pushed_back(self, limit: Gradient) -> Gradient {
        Gradient::each(|i| self.along(i).pushed_back(limit.along(i)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every operation beside the same one in each direction alone.
    #[test]
    fn directions_are_those_of_dual_numbers() {
        fn expression<T: Real>(x: T, y: T) -> T {
            let two = T::from(2.0);
            (-x.abs() / two).exp() * (x * y).tanh() * (x + y).sin()
                - x.abs().powf(T::from(1.5) + y) / (x + T::from(5.0))
                + x.limited(T::from(0.25))
                + (x * two).cos() * (y / x).atan()
                + (x / two).exp_m1() * (x + T::from(3.0)).ln() / (y / T::from(4.0)).ln_1p()
                + (x - y).abs().sqrt()
                + y.pushed_back(x.abs())
        }
        for (x, y) in [(-2.0, 0.3), (-0.7, 1.4), (0.2, 0.2), (1.3, 0.6)] {
            let x = Gradient { value: x, slopes: [1.0, 0.0, 0.0, -0.4] };
            let y = Gradient { value: y, slopes: [0.0, 1.0, 0.0, 2.5] };
            let found = expression(x, y);
            for direction in 0..DIRECTIONS {
                let expected = expression(x.along(direction), y.along(direction));
                let along = found.along(direction);
                assert_eq!([along.value, along.slope], [expected.value, expected.slope], "{x:?} {y:?} {direction}");
            }
        }
    }
}
