//! The number types a law is evaluated with: `f64` for values, [`Dual`] for values with an exact derivative, [`Gradient`]
//! for values with several of them, [`Lanes`] for several values at once, and their [`elementary`] functions.

mod differentiated;
pub mod elementary;
mod gradient;
mod lanes;
pub(crate) mod register;

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use differentiated::differentiated;
pub use gradient::{DIRECTIONS, Gradient};
pub use lanes::{Lanes, LanesMask};
pub use register::Register;

/// Answer of a comparison of numbers: yes or no, or as many answers as a number has lanes.
pub trait Mask<T>: Copy + From<bool> + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// The answer, if it is the same in all lanes.
    fn agreed(self) -> Option<bool>;

    /// Whether the answer is yes in a lane.
    fn any(self) -> bool;

    /// Whether the answer is yes in all lanes.
    fn all(self) -> bool;

    /// `yes` where the answer is yes, `no` elsewhere.
    fn select(self, yes: T, no: T) -> T;

    /// `yes()` where the answer is yes, `no()` elsewhere. Only the one that counts is evaluated, or both where lanes
    /// differ.
    fn choose(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T;

    /// As [`Mask::choose`], for several numbers.
    fn choose_all<const N: usize>(self, yes: impl FnOnce() -> [T; N], no: impl FnOnce() -> [T; N]) -> [T; N];
}

/// Answer that can decide the course of a computation: of a number of one lane.
pub trait Decision<T>: Mask<T> {
    /// Whether it is yes.
    fn holds(self) -> bool;
}

impl<T> Mask<T> for bool {
    #[inline(always)]
    fn agreed(self) -> Option<bool> {
        Some(self)
    }

    #[inline(always)]
    fn any(self) -> bool {
        self
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }

    #[inline(always)]
    fn select(self, yes: T, no: T) -> T {
        if self { yes } else { no }
    }

    #[inline(always)]
    fn choose(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        if self { yes() } else { no() }
    }

    #[inline(always)]
    fn choose_all<const N: usize>(self, yes: impl FnOnce() -> [T; N], no: impl FnOnce() -> [T; N]) -> [T; N] {
        if self { yes() } else { no() }
    }
}

impl<T> Decision<T> for bool {
    #[inline(always)]
    fn holds(self) -> bool {
        self
    }
}

/// `choose!(answer, yes, no)` is [`Mask::choose`] with expressions: of a number, only the one that counts is evaluated, or
/// both where lanes differ. Functions for registers must be free of calls, which closures are until they are inlined.
macro_rules! choose {
    ($answer:expr, $yes:expr, $no:expr) => {{
        let answer = $answer;
        let yes = if $crate::number::Mask::any(answer) { $yes } else { $crate::number::Real::zero() };
        if $crate::number::Mask::all(answer) { yes } else { $crate::number::Mask::select(answer, yes, $no) }
    }};
}
pub(crate) use choose;

/// A number as a law needs it. Written once for it, a law gives values (`f64`), exact derivatives ([`Dual`]) and the
/// values of several contacts at once ([`Lanes`]).
pub trait Real:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Answer of a comparison.
    type Mask: Mask<Self>;

    /// Whether laws may [search](Real::found). Registers are made for what needs no search: rows that do are not given to
    /// them.
    const SEARCHES: bool = true;

    /// Whether it has one lane, so that each choice is for one way or the other.
    const HAS_ONE_LANE: bool = true;

    /// The value in one of the lanes without its derivative; a [`Scalar`] has one lane. For a search on plain numbers.
    fn lane(self, lane: usize) -> f64;
    /// Whether this is the constant itself, not a value that only passes through it. Guards shortcuts, which would
    /// otherwise lose a derivative.
    fn is(self, constant: f64) -> Self::Mask;
    /// Whether it is greater than another number.
    fn above(self, other: Self) -> Self::Mask;
    /// Whether it is greater than another number or equal to it.
    fn at_least(self, other: Self) -> Self::Mask;
    /// Whether it equals another number in value.
    fn equals(self, other: Self) -> Self::Mask;
    /// Whether its derivative is positive. Shows in which direction a value at a limit leaves it.
    #[inline(always)]
    fn rises(self) -> Self::Mask {
        Self::Mask::from(false)
    }
    /// The same value without a derivative.
    fn as_constant(self) -> Self {
        self
    }
    /// A number that a search on plain numbers finds in each lane, and another one. They depend on the numbers `on`.
    #[inline(always)]
    fn found<const N: usize>(_on: impl FnOnce() -> [Self; N], search: impl Fn(usize) -> [f64; 2]) -> [Self; 2] {
        search(0).map(Self::from)
    }
    /// -1, 0 or 1: the sign function with sgn(0) = 0 of the friction literature (not `f64::signum`, where it is 1).
    fn sign(self) -> Self;
    /// e to the power of `self`.
    fn exp(self) -> Self;
    /// e to the power of `self`, minus 1, also accurate near 0.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Natural logarithm of 1 + `self`, also accurate near 0.
    fn ln_1p(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Sine.
    fn sin(self) -> Self;
    /// Cosine.
    fn cos(self) -> Self;
    /// Arc tangent.
    fn atan(self) -> Self;
    /// Square root; `self` must not be negative.
    fn sqrt(self) -> Self;
    /// `self` to a constant power; `self` must not be negative.
    fn powf(self, exponent: Self) -> Self;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::from(0.0)
    }

    /// Magnitude. At 0 its derivative is taken as 0, the middle of its two one-sided derivatives.
    #[inline(always)]
    fn abs(self) -> Self {
        self * self.sign()
    }

    /// 1 where the answer is yes, 0 elsewhere: the value of a Boolean column.
    #[inline(always)]
    fn truth(answer: Self::Mask) -> Self {
        answer.select(Self::from(1.0), Self::from(0.0))
    }

    /// Whether it is smaller than another number.
    #[inline(always)]
    fn below(self, other: Self) -> Self::Mask {
        other.above(self)
    }

    /// Whether it is smaller than another number or equal to it.
    #[inline(always)]
    fn at_most(self, other: Self) -> Self::Mask {
        other.at_least(self)
    }

    /// Whether it is greater than 0.
    #[inline(always)]
    fn is_positive(self) -> Self::Mask {
        self.above(Self::zero())
    }

    /// Whether its value is 0.
    #[inline(always)]
    fn vanishes(self) -> Self::Mask {
        self.equals(Self::zero())
    }

    /// The larger one of two numbers; the other one if this is NaN.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.at_least(other).select(self, other)
    }

    /// The value nearest to `self` in [-limit, limit]; `limit` must not be negative.
    #[inline(always)]
    fn limited(self, limit: Self) -> Self {
        self.above(limit).select(limit, self.below(-limit).select(-limit, self))
    }

    /// As [`Real::limited`], for what is pushed back by a limit that moves: where it stands on it, the one that goes
    /// inwards faster decides how it goes on.
    #[inline(always)]
    fn pushed_back(self, limit: Self) -> Self {
        let direction = self.sign();
        let excess = direction * self - limit;
        let leaves = excess.is_positive() | excess.vanishes() & excess.rises();
        leaves.select(direction * limit, self)
    }
}

/// A number of one lane, whose value can decide the course of a computation: for the laws that have modes.
pub trait Scalar: Real<Mask: Decision<Self>> + PartialOrd {
    /// The value without its derivative: for a choice or a discrete state.
    #[inline(always)]
    fn value(self) -> f64 {
        self.lane(0)
    }
}

impl Scalar for f64 {}
impl Scalar for Dual {}
impl Scalar for Gradient {}

impl Real for f64 {
    type Mask = bool;

    #[inline(always)]
    fn lane(self, _lane: usize) -> f64 {
        self
    }
    fn is(self, constant: f64) -> bool {
        self == constant
    }
    #[inline(always)]
    fn above(self, other: f64) -> bool {
        self > other
    }
    #[inline(always)]
    fn at_least(self, other: f64) -> bool {
        self >= other
    }
    #[inline(always)]
    fn equals(self, other: f64) -> bool {
        self == other
    }
    fn exp(self) -> f64 {
        elementary::exp(self)
    }
    fn exp_m1(self) -> f64 {
        elementary::exp_m1(self)
    }
    fn ln(self) -> f64 {
        elementary::ln(self)
    }
    fn ln_1p(self) -> f64 {
        elementary::ln_1p(self)
    }
    fn tanh(self) -> f64 {
        elementary::tanh(self)
    }
    fn sin(self) -> f64 {
        elementary::sin(self)
    }
    fn cos(self) -> f64 {
        elementary::cos(self)
    }
    fn atan(self) -> f64 {
        elementary::atan(self)
    }
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    fn powf(self, exponent: f64) -> f64 {
        elementary::pow(self, exponent)
    }
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    fn sign(self) -> f64 {
        // Without a branch: the sign of a velocity is hard to predict.
        f64::from(u8::from(self != 0.0)).copysign(self)
    }
}

/// A value and its derivative in one direction (forward automatic differentiation).
#[derive(Clone, Copy, Debug, Default)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative in the chosen direction.
    pub slope: f64,
}

impl Dual {
    fn has_slope(self) -> bool {
        self.slope != 0.0
    }

    /// `f(self)`, given the value and the derivative of f there. A zero derivative stays zero, even where f' is
    /// infinite.
    fn chain(self, value: f64, derivative: f64) -> Dual {
        let slope = if self.slope == 0.0 { 0.0 } else { derivative * self.slope };
        Dual { value, slope }
    }

    /// The number with the derivatives of another one added to its own.
    fn with_slope_of(self, other: Dual) -> Dual {
        Dual { value: self.value, slope: self.slope + other.slope }
    }
}

impl From<f64> for Dual {
    fn from(value: f64) -> Dual {
        Dual { value, slope: 0.0 }
    }
}

differentiated::compared!(Dual);

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        Dual { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}

impl Div for Dual {
    type Output = Dual;
    fn div(self, other: Dual) -> Dual {
        let value = self.value / other.value;
        Dual { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual { value: -self.value, slope: -self.slope }
    }
}

impl Real for Dual {
    differentiated!();

    fn rises(self) -> bool {
        self.slope > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every operation against a central difference of the same expression in f64.
    #[test]
    fn derivatives_agree_with_central_differences() {
        fn expression<T: Real>(x: T) -> T {
            let two = T::from(2.0);
            (-x.abs() / two).exp() * (x * two).tanh() * (x + two).sin()
                - x.abs().powf(T::from(1.5) + x / T::from(10.0)) / (x + T::from(5.0))
                + x.limited(T::from(0.25))
                + (x * two).cos() * (x / two).atan()
                + (x / two).exp_m1() * (x + T::from(3.0)).ln() / (x / T::from(4.0)).ln_1p()
        }
        for x in [-2.0, -0.7, 0.2, 1.3] {
            let exact = expression(Dual { value: x, slope: 1.0 }).slope;
            let h = 1e-6;
            let difference = (expression(x + h) - expression(x - h)) / (2.0 * h);
            assert!((exact - difference).abs() < 1e-8, "at {x}: {exact} against {difference}");
        }
    }

    #[test]
    fn sign_of_zero_is_zero() {
        assert_eq!((0.0f64).sign(), 0.0);
        assert_eq!((-0.0f64).sign(), 0.0);
        assert_eq!((-3.0f64).sign(), -1.0);
    }
}
