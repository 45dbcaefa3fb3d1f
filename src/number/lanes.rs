//! Several values that are computed with at once, each in a lane of its own.
//!
//! Every operation works on each lane as it works on an `f64`, so a lane has the same bits as a scalar would have.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::elementary::{self, Kernel};
use super::register::Register;
use super::{Mask, Real};

/// Values in the lanes of a register: `Lanes<[f64; 4]>` is four of them on any processor.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<R>(pub R);

/// An answer in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct LanesMask<R: Register>(R::Mask);

impl<R: Register> Lanes<R> {
    /// Each lane as the function of an `f64`: for what no register has.
    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        Lanes(R::each(|lane| function(self.0.lane(lane))))
    }
}

impl<R: Register> From<f64> for Lanes<R> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Lanes(R::splat(value))
    }
}

impl<R: Register> Add for Lanes<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Lanes(self.0.plus(other.0))
    }
}

impl<R: Register> Sub for Lanes<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Lanes(self.0.minus(other.0))
    }
}

impl<R: Register> Mul for Lanes<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Lanes(self.0.times(other.0))
    }
}

impl<R: Register> Div for Lanes<R> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Lanes(self.0.over(other.0))
    }
}

impl<R: Register> Neg for Lanes<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(self.0.negated())
    }
}

impl<R: Register> Kernel for Lanes<R> {
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> Self {
        Lanes(self.0.within(least, most))
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        Lanes(self.0.magnitude())
    }
    #[inline(always)]
    fn with_sign(self, of: Self) -> Self {
        Lanes(self.0.with_sign(of.0))
    }
    #[inline(always)]
    fn power(self, offset: u64) -> Self {
        Lanes(self.0.power(offset))
    }
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        self.0.halves().map(Lanes)
    }
}

impl<R: Register> Real for Lanes<R> {
    type Mask = LanesMask<R>;
    const SEARCHES: bool = R::SEARCHES;
    const HAS_ONE_LANE: bool = false;

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0.lane(lane)
    }
    #[inline(always)]
    fn is(self, constant: f64) -> LanesMask<R> {
        self.equals(Self::from(constant))
    }
    #[inline(always)]
    fn above(self, other: Self) -> LanesMask<R> {
        LanesMask(self.0.above(other.0))
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> LanesMask<R> {
        LanesMask(self.0.at_least(other.0))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> LanesMask<R> {
        LanesMask(self.0.equals(other.0))
    }
    fn found<const K: usize>(_on: impl FnOnce() -> [Self; K], search: impl Fn(usize) -> [f64; 2]) -> [Self; 2] {
        let [mut first, mut second] = [Self::from(0.0).0; 2];
        for lane in 0..R::LANES {
            let found = search(lane);
            let with = |numbers: R, one: f64| R::each(|other| if other == lane { one } else { numbers.lane(other) });
            (first, second) = (with(first, found[0]), with(second, found[1]));
        }
        [Lanes(first), Lanes(second)]
    }
    #[inline(always)]
    fn sign(self) -> Self {
        let size = R::select(self.vanishes().0, R::splat(0.0), R::splat(1.0));
        Lanes(size.with_sign(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Lanes(self.0.magnitude())
    }
    #[inline(always)]
    fn exp(self) -> Self {
        elementary::exp_of(self)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        elementary::exp_m1_of(self)
    }
    fn ln(self) -> Self {
        self.map(Real::ln)
    }
    fn ln_1p(self) -> Self {
        self.map(Real::ln_1p)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        elementary::tanh_of(self)
    }
    fn sin(self) -> Self {
        self.map(Real::sin)
    }
    fn cos(self) -> Self {
        self.map(Real::cos)
    }
    fn atan(self) -> Self {
        self.map(Real::atan)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Lanes(self.0.root())
    }
    fn powf(self, exponent: Self) -> Self {
        Lanes(R::each(|lane| Real::powf(self.0.lane(lane), exponent.0.lane(lane))))
    }
}

impl<R: Register> From<bool> for LanesMask<R> {
    #[inline(always)]
    fn from(answer: bool) -> Self {
        LanesMask(R::answer(answer))
    }
}

impl<R: Register> BitAnd for LanesMask<R> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        LanesMask(R::both(self.0, other.0))
    }
}

impl<R: Register> BitOr for LanesMask<R> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        LanesMask(R::one_of(self.0, other.0))
    }
}

impl<R: Register> Not for LanesMask<R> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        LanesMask(R::inverse(self.0))
    }
}

impl<R: Register> Mask<Lanes<R>> for LanesMask<R> {
    #[inline(always)]
    fn agreed(self) -> Option<bool> {
        if R::all(self.0) {
            Some(true)
        } else if R::any(self.0) {
            None
        } else {
            Some(false)
        }
    }

    #[inline(always)]
    fn any(self) -> bool {
        R::any(self.0)
    }

    #[inline(always)]
    fn all(self) -> bool {
        R::all(self.0)
    }

    #[inline(always)]
    fn select(self, yes: Lanes<R>, no: Lanes<R>) -> Lanes<R> {
        Lanes(R::select(self.0, yes.0, no.0))
    }

    // Each way is compiled in one place: where choices lie within choices, two places would be four, and so on.
    #[inline(always)]
    fn choose(self, yes: impl FnOnce() -> Lanes<R>, no: impl FnOnce() -> Lanes<R>) -> Lanes<R> {
        let yes = if R::any(self.0) { yes() } else { Lanes::from(0.0) };
        if R::all(self.0) { yes } else { Lanes(R::select(self.0, yes.0, no().0)) }
    }

    #[inline(always)]
    fn choose_all<const K: usize>(
        self,
        yes: impl FnOnce() -> [Lanes<R>; K],
        no: impl FnOnce() -> [Lanes<R>; K],
    ) -> [Lanes<R>; K] {
        let yes = if R::any(self.0) { yes() } else { [Lanes::from(0.0); K] };
        if R::all(self.0) {
            return yes;
        }
        let mut chosen = no();
        for (no, yes) in chosen.iter_mut().zip(yes) {
            no.0 = R::select(self.0, yes.0, no.0);
        }
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Four = Lanes<[f64; 4]>;

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
