//! Registers: as many numbers as a processor works on at once.
//!
//! Each operation gives every lane the bits that it gives an `f64`: what IEEE 754 rounds is the same in a register, and
//! nothing is fused.

#![cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "aarch64")),
    allow(dead_code, reason = "other processors have no registers for it")
)]

#[cfg(target_arch = "aarch64")]
pub(crate) mod neon;
// Elsewhere it was not measured.
#[cfg(any(target_arch = "x86_64", test))]
pub(crate) mod pair;
#[cfg(target_arch = "x86_64")]
pub(crate) mod x86;

use std::array::from_fn;
use std::fmt::Debug;

use super::Lanes;

/// Numbers that are worked on together, one in each lane.
///
/// # Safety
/// The type must consist of exactly `LANES` numbers of the type f64, for each of which every bit pattern is valid.
pub unsafe trait Register: Copy + Debug + PartialEq + 'static {
    /// Answer in each lane.
    type Mask: Copy + Debug + PartialEq;
    /// Number of lanes.
    const LANES: usize;
    /// See [`Real::SEARCHES`](super::Real::SEARCHES).
    const SEARCHES: bool = false;

    /// The same number in all lanes.
    fn splat(value: f64) -> Self;
    /// The number of a lane.
    fn lane(self, lane: usize) -> f64;
    /// A number for each lane.
    fn each(value: impl FnMut(usize) -> f64) -> Self;
    /// Sum.
    fn plus(self, other: Self) -> Self;
    /// Difference.
    fn minus(self, other: Self) -> Self;
    /// Product.
    fn times(self, other: Self) -> Self;
    /// Quotient.
    fn over(self, other: Self) -> Self;
    /// The number with the opposite sign bit.
    fn negated(self) -> Self;
    /// The number without its sign bit.
    fn magnitude(self) -> Self;
    /// The number with the sign bit of another one.
    fn with_sign(self, of: Self) -> Self;
    /// Square root.
    fn root(self) -> Self;
    /// `least` where this is smaller, `most` where it is greater; NaN stays NaN.
    fn within(self, least: f64, most: f64) -> Self;
    /// [`f64::to_bits`] less `offset`, moved by the 52 bits of a fraction: a power of 2 from its exponent.
    fn power(self, offset: u64) -> Self;
    /// The last 12 bits as the sum of two exponents, each moved by the 52 bits of a fraction.
    fn halves(self) -> [Self; 2];
    /// Where this is greater.
    fn above(self, other: Self) -> Self::Mask;
    /// Where this is greater or equal.
    fn at_least(self, other: Self) -> Self::Mask;
    /// Where both are equal.
    fn equals(self, other: Self) -> Self::Mask;
    /// The one where the answer is yes, the other one elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The same answer in all lanes.
    fn answer(answer: bool) -> Self::Mask;
    /// Where both answers are yes.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Where one answer is yes, or both are.
    fn one_of(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Where the answer is no.
    fn inverse(mask: Self::Mask) -> Self::Mask;
    /// Whether the answer is yes in all lanes.
    fn all(mask: Self::Mask) -> bool;
    /// Whether the answer is yes in a lane.
    fn any(mask: Self::Mask) -> bool;
}

/// Numbers side by side, as any processor has them.
// SAFETY: an array of so many numbers.
unsafe impl<const N: usize> Register for [f64; N] {
    type Mask = [bool; N];
    const LANES: usize = N;
    const SEARCHES: bool = true;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        [value; N]
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self[lane]
    }
    #[inline(always)]
    fn each(value: impl FnMut(usize) -> f64) -> Self {
        from_fn(value)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        from_fn(|lane| self[lane] + other[lane])
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        from_fn(|lane| self[lane] - other[lane])
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        from_fn(|lane| self[lane] * other[lane])
    }
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        from_fn(|lane| self[lane] / other[lane])
    }
    #[inline(always)]
    fn negated(self) -> Self {
        self.map(|value| -value)
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.map(f64::abs)
    }
    #[inline(always)]
    fn with_sign(self, of: Self) -> Self {
        from_fn(|lane| self[lane].copysign(of[lane]))
    }
    #[inline(always)]
    fn root(self) -> Self {
        self.map(f64::sqrt)
    }
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> Self {
        self.map(|value| {
            let value = if value < least { least } else { value };
            if value > most { most } else { value }
        })
    }
    #[inline(always)]
    fn power(self, offset: u64) -> Self {
        self.map(|value| f64::from_bits(value.to_bits().wrapping_sub(offset) << 52))
    }
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        let exponents = self.map(|value| value.to_bits() & 0xfff);
        let first = |exponents: u64| exponents >> 1;
        [
            exponents.map(|exponents| f64::from_bits(first(exponents) << 52)),
            exponents.map(|exponents| f64::from_bits((exponents - first(exponents)) << 52)),
        ]
    }
    #[inline(always)]
    fn above(self, other: Self) -> [bool; N] {
        from_fn(|lane| self[lane] > other[lane])
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> [bool; N] {
        from_fn(|lane| self[lane] >= other[lane])
    }
    #[inline(always)]
    fn equals(self, other: Self) -> [bool; N] {
        from_fn(|lane| self[lane] == other[lane])
    }
    #[inline(always)]
    fn select(mask: [bool; N], yes: Self, no: Self) -> Self {
        from_fn(|lane| if mask[lane] { yes[lane] } else { no[lane] })
    }
    #[inline(always)]
    fn answer(answer: bool) -> [bool; N] {
        [answer; N]
    }
    #[inline(always)]
    fn both(a: [bool; N], b: [bool; N]) -> [bool; N] {
        from_fn(|lane| a[lane] & b[lane])
    }
    #[inline(always)]
    fn one_of(a: [bool; N], b: [bool; N]) -> [bool; N] {
        from_fn(|lane| a[lane] | b[lane])
    }
    #[inline(always)]
    fn inverse(mask: [bool; N]) -> [bool; N] {
        mask.map(|answer| !answer)
    }
    #[inline(always)]
    fn all(mask: [bool; N]) -> bool {
        mask.iter().all(|answer| *answer)
    }
    #[inline(always)]
    fn any(mask: [bool; N]) -> bool {
        mask.iter().any(|answer| *answer)
    }
}

/// A register for one use: what is compiled for it is compiled for that use alone. A compiler inlines what is called in
/// one place, however long it is, and only what is inlined into a function with the instructions of a processor has them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub(crate) struct For<const USE: usize, R>(R);

impl<const USE: usize, R: Register> For<USE, R> {
    /// Numbers of a register for this use.
    #[inline(always)]
    pub fn groups(lanes: &mut [Lanes<R>]) -> &mut [Lanes<Self>] {
        // SAFETY: both types are transparent; the borrow is exclusive and passes on to the result.
        unsafe { std::slice::from_raw_parts_mut(lanes.as_mut_ptr().cast::<Lanes<Self>>(), lanes.len()) }
    }
}

/// Methods of a register that pass on to another one.
macro_rules! passed_on {
    ({ $($name:ident($($argument:ident),*) -> Self;)+ } { $($compare:ident)+ }) => {
        $(
            #[inline(always)]
            fn $name(self $(, $argument: Self)*) -> Self {
                For(self.0.$name($($argument.0),*))
            }
        )+
        $(
            #[inline(always)]
            fn $compare(self, other: Self) -> R::Mask {
                self.0.$compare(other.0)
            }
        )+
    };
}

// SAFETY: transparent.
unsafe impl<const USE: usize, R: Register> Register for For<USE, R> {
    type Mask = R::Mask;
    const LANES: usize = R::LANES;
    const SEARCHES: bool = R::SEARCHES;

    passed_on! {
        {
            plus(other) -> Self;
            minus(other) -> Self;
            times(other) -> Self;
            over(other) -> Self;
            with_sign(of) -> Self;
            negated() -> Self;
            magnitude() -> Self;
            root() -> Self;
        }
        { above at_least equals }
    }

    #[inline(always)]
    fn splat(value: f64) -> Self {
        For(R::splat(value))
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0.lane(lane)
    }
    #[inline(always)]
    fn each(value: impl FnMut(usize) -> f64) -> Self {
        For(R::each(value))
    }
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> Self {
        For(self.0.within(least, most))
    }
    #[inline(always)]
    fn power(self, offset: u64) -> Self {
        For(self.0.power(offset))
    }
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        let [first, second] = self.0.halves();
        [For(first), For(second)]
    }
    #[inline(always)]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        For(R::select(mask, yes.0, no.0))
    }
    #[inline(always)]
    fn answer(answer: bool) -> R::Mask {
        R::answer(answer)
    }
    #[inline(always)]
    fn both(a: R::Mask, b: R::Mask) -> R::Mask {
        R::both(a, b)
    }
    #[inline(always)]
    fn one_of(a: R::Mask, b: R::Mask) -> R::Mask {
        R::one_of(a, b)
    }
    #[inline(always)]
    fn inverse(mask: R::Mask) -> R::Mask {
        R::inverse(mask)
    }
    #[inline(always)]
    fn all(mask: R::Mask) -> bool {
        R::all(mask)
    }
    #[inline(always)]
    fn any(mask: R::Mask) -> bool {
        R::any(mask)
    }
}
