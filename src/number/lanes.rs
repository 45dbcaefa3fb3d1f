//! Several values that are computed with at once, each in a lane of its own.
//!
//! Every operation works on each lane as it works on an `f64`, so a lane has the same bits as a scalar would have. The
//! loops are over a fixed number of lanes, which a compiler turns into instructions for as many lanes as a processor
//! has.

use std::array::from_fn;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Mask, Real};

/// `N` values, each in a lane of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<const N: usize>(pub [f64; N]);

/// An answer in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LanesMask<const N: usize>(pub [bool; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn each(self, function: impl Fn(f64) -> f64) -> Self {
        Lanes(from_fn(|lane| function(self.0[lane])))
    }

    #[inline(always)]
    fn with(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        Lanes(from_fn(|lane| function(self.0[lane], other.0[lane])))
    }

    #[inline(always)]
    fn compared(self, other: Self, question: impl Fn(f64, f64) -> bool) -> LanesMask<N> {
        LanesMask(from_fn(|lane| question(self.0[lane], other.0[lane])))
    }
}

impl<const N: usize> From<f64> for Lanes<N> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Lanes([value; N])
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|a| -a)
    }
}

impl<const N: usize> Real for Lanes<N> {
    type Mask = LanesMask<N>;

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }
    #[inline(always)]
    fn is(self, constant: f64) -> LanesMask<N> {
        self.equals(Self::from(constant))
    }
    #[inline(always)]
    fn above(self, other: Self) -> LanesMask<N> {
        self.compared(other, |a, b| a > b)
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> LanesMask<N> {
        self.compared(other, |a, b| a >= b)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> LanesMask<N> {
        self.compared(other, |a, b| a == b)
    }
    fn found<const K: usize>(_on: impl FnOnce() -> [Self; K], search: impl Fn(usize) -> [f64; 2]) -> [Self; 2] {
        let found: [[f64; 2]; N] = from_fn(search);
        [0, 1].map(|number| Lanes(from_fn(|lane| found[lane][number])))
    }
    #[inline(always)]
    fn sign(self) -> Self {
        self.each(Real::sign)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.each(f64::abs)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        self.each(Real::exp)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        self.each(Real::exp_m1)
    }
    fn ln(self) -> Self {
        self.each(Real::ln)
    }
    fn ln_1p(self) -> Self {
        self.each(Real::ln_1p)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        self.each(Real::tanh)
    }
    fn sin(self) -> Self {
        self.each(Real::sin)
    }
    fn cos(self) -> Self {
        self.each(Real::cos)
    }
    fn atan(self) -> Self {
        self.each(Real::atan)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(f64::sqrt)
    }
    fn powf(self, exponent: Self) -> Self {
        self.with(exponent, Real::powf)
    }
}

impl<const N: usize> From<bool> for LanesMask<N> {
    #[inline(always)]
    fn from(answer: bool) -> Self {
        LanesMask([answer; N])
    }
}

impl<const N: usize> BitAnd for LanesMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        LanesMask(from_fn(|lane| self.0[lane] & other.0[lane]))
    }
}

impl<const N: usize> BitOr for LanesMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        LanesMask(from_fn(|lane| self.0[lane] | other.0[lane]))
    }
}

impl<const N: usize> Not for LanesMask<N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        LanesMask(self.0.map(|answer| !answer))
    }
}

impl<const N: usize> LanesMask<N> {
    #[inline(always)]
    fn select(self, yes: Lanes<N>, no: Lanes<N>) -> Lanes<N> {
        Lanes(from_fn(|lane| if self.0[lane] { yes.0[lane] } else { no.0[lane] }))
    }
}

impl<const N: usize> Mask<Lanes<N>> for LanesMask<N> {
    #[inline(always)]
    fn agreed(self) -> Option<bool> {
        let count = self.0.iter().filter(|answer| **answer).count();
        if count == N {
            Some(true)
        } else if count == 0 {
            Some(false)
        } else {
            None
        }
    }

    #[inline(always)]
    fn choose(self, yes: impl FnOnce() -> Lanes<N>, no: impl FnOnce() -> Lanes<N>) -> Lanes<N> {
        match self.agreed() {
            Some(true) => yes(),
            Some(false) => no(),
            None => self.select(yes(), no()),
        }
    }

    #[inline(always)]
    fn choose_all<const K: usize>(
        self,
        yes: impl FnOnce() -> [Lanes<N>; K],
        no: impl FnOnce() -> [Lanes<N>; K],
    ) -> [Lanes<N>; K] {
        match self.agreed() {
            Some(true) => yes(),
            Some(false) => no(),
            None => {
                let (yes, no) = (yes(), no());
                from_fn(|number| self.select(yes[number], no[number]))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Four = Lanes<4>;

    fn bits(lanes: Four) -> [u64; 4] {
        lanes.0.map(f64::to_bits)
    }

    /// A number of lanes, each of which is what an f64 is.
    #[test]
    fn every_function_gives_each_lane_the_bits_of_a_scalar() {
        type Pair = (fn(Four) -> Four, fn(f64) -> f64);
        let functions: [Pair; 12] = [
            (Real::exp, Real::exp),
            (Real::exp_m1, Real::exp_m1),
            (Real::tanh, Real::tanh),
            (Real::ln, Real::ln),
            (Real::ln_1p, Real::ln_1p),
            (Real::sin, Real::sin),
            (Real::cos, Real::cos),
            (Real::atan, Real::atan),
            (Real::sqrt, Real::sqrt),
            (Real::sign, Real::sign),
            (Real::abs, Real::abs),
            (|x| x.limited(Four::from(0.5)), |x| x.limited(0.5)),
        ];
        let special = Lanes([0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY]);
        let share = |k: u32| f64::from(k) * 0.618_033_988_749_894_9 % 1.0;
        let usual = |k: u32| Lanes([0, 1, 2, 3].map(|lane| (-1.0f64).powi(lane) * 800.0 * share(k + 7 * lane as u32)));
        for number in [special].into_iter().chain((0..2_000).map(usual)) {
            for (in_lanes, alone) in functions {
                for (lane, bits) in bits(in_lanes(number)).into_iter().enumerate() {
                    let alone = alone(number.0[lane]);
                    assert!(bits == alone.to_bits() || alone.is_nan() && f64::from_bits(bits).is_nan(), "{number:?}");
                }
            }
        }
    }

    #[test]
    fn a_choice_on_which_lanes_agree_is_lazy() {
        let (small, large) = (Four::from(1.0), Lanes([2.0, 3.0, 4.0, 5.0]));
        assert_eq!(large.above(small).choose(|| large, || panic!()), large);
        assert_eq!(small.above(large).choose_all(|| panic!(), || [large, small]), [large, small]);
    }

    #[test]
    fn lanes_that_differ_get_what_each_of_them_asks_for() {
        let numbers = Lanes([2.0, -3.0, f64::NAN, 5.0]);
        let is_positive = numbers.is_positive();
        assert_eq!(is_positive.agreed(), None);
        assert_eq!(is_positive.choose(|| numbers, Four::zero), Lanes([2.0, 0.0, 0.0, 5.0]));
        let [yes, no] = (!is_positive).choose_all(|| [Four::zero(), numbers], || [numbers, Four::zero()]);
        assert_eq!((yes.0, no.0[1], no.0[3]), ([2.0, 0.0, 0.0, 5.0], -3.0, 0.0));
    }

    #[test]
    fn each_lane_is_searched_alone() {
        let numbers = Lanes([4.0, 9.0, 16.0, 25.0]);
        let [root, lane] = Four::found(|| [numbers], |lane| [numbers.lane(lane).sqrt(), lane as f64]);
        assert_eq!((root.0, lane.0), ([2.0, 3.0, 4.0, 5.0], [0.0, 1.0, 2.0, 3.0]));
    }
}
