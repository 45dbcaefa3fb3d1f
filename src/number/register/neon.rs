//! Registers of 64-bit ARM, each of which has them.

#![allow(unused_unsafe, reason = "some instructions are safe where the target is known to have NEON")]

use std::arch::aarch64::*;
use std::array::from_fn;
use std::fmt;

use super::Register;

/// Two numbers, with NEON.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Two(float64x2_t);

/// Answers in two lanes: all bits of a lane are set, or none.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct TwoAnswers(uint64x2_t);

/// Instructions of a processor.
macro_rules! instructions {
    ($work:expr) => {
        // SAFETY: NEON is a part of every 64-bit ARM processor that Rust has a target for.
        unsafe { $work }
    };
}

impl Two {
    #[inline(always)]
    fn lanes(self) -> [f64; 2] {
        let mut numbers = [0.0; 2];
        // SAFETY: two numbers are written.
        unsafe { vst1q_f64(numbers.as_mut_ptr(), self.0) };
        numbers
    }

    #[inline(always)]
    fn bits(self) -> uint64x2_t {
        instructions!(vreinterpretq_u64_f64(self.0))
    }

    #[inline(always)]
    fn from_bits(bits: uint64x2_t) -> Two {
        Two(instructions!(vreinterpretq_f64_u64(bits)))
    }
}

// SAFETY: the register of a processor with two numbers.
unsafe impl Register for Two {
    type Mask = TwoAnswers;
    const LANES: usize = 2;

    #[inline(always)]
    fn splat(value: f64) -> Two {
        Two(instructions!(vdupq_n_f64(value)))
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.lanes()[lane]
    }
    #[inline(always)]
    fn each(value: impl FnMut(usize) -> f64) -> Two {
        let numbers: [f64; 2] = from_fn(value);
        // SAFETY: two numbers are read.
        Two(unsafe { vld1q_f64(numbers.as_ptr()) })
    }
    #[inline(always)]
    fn plus(self, other: Two) -> Two {
        Two(instructions!(vaddq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn minus(self, other: Two) -> Two {
        Two(instructions!(vsubq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn times(self, other: Two) -> Two {
        Two(instructions!(vmulq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn over(self, other: Two) -> Two {
        Two(instructions!(vdivq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn negated(self) -> Two {
        Two(instructions!(vnegq_f64(self.0)))
    }
    #[inline(always)]
    fn magnitude(self) -> Two {
        Two(instructions!(vabsq_f64(self.0)))
    }
    #[inline(always)]
    fn with_sign(self, of: Two) -> Two {
        Two(instructions!(vbslq_f64(vdupq_n_u64(1 << 63), of.0, self.0)))
    }
    #[inline(always)]
    fn root(self) -> Two {
        Two(instructions!(vsqrtq_f64(self.0)))
    }
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> Two {
        let [least, most] = [least, most].map(Two::splat);
        let above = Two::select(least.above(self), least, self);
        Two::select(above.above(most), most, above)
    }
    #[inline(always)]
    fn power(self, offset: u64) -> Two {
        Two::from_bits(instructions!(vshlq_n_u64::<52>(vsubq_u64(self.bits(), vdupq_n_u64(offset)))))
    }
    #[inline(always)]
    fn halves(self) -> [Two; 2] {
        let [first, second] = instructions!({
            let exponents = vandq_u64(self.bits(), vdupq_n_u64(0xfff));
            let first = vshrq_n_u64::<1>(exponents);
            [first, vsubq_u64(exponents, first)]
        });
        [first, second].map(|part| Two::from_bits(instructions!(vshlq_n_u64::<52>(part))))
    }
    #[inline(always)]
    fn above(self, other: Two) -> TwoAnswers {
        TwoAnswers(instructions!(vcgtq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn at_least(self, other: Two) -> TwoAnswers {
        TwoAnswers(instructions!(vcgeq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn equals(self, other: Two) -> TwoAnswers {
        TwoAnswers(instructions!(vceqq_f64(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: TwoAnswers, yes: Two, no: Two) -> Two {
        Two(instructions!(vbslq_f64(mask.0, yes.0, no.0)))
    }
    #[inline(always)]
    fn answer(answer: bool) -> TwoAnswers {
        TwoAnswers(instructions!(vdupq_n_u64(if answer { u64::MAX } else { 0 })))
    }
    #[inline(always)]
    fn both(a: TwoAnswers, b: TwoAnswers) -> TwoAnswers {
        TwoAnswers(instructions!(vandq_u64(a.0, b.0)))
    }
    #[inline(always)]
    fn one_of(a: TwoAnswers, b: TwoAnswers) -> TwoAnswers {
        TwoAnswers(instructions!(vorrq_u64(a.0, b.0)))
    }
    #[inline(always)]
    fn inverse(mask: TwoAnswers) -> TwoAnswers {
        TwoAnswers(instructions!(veorq_u64(mask.0, vdupq_n_u64(u64::MAX))))
    }
    #[inline(always)]
    fn all(mask: TwoAnswers) -> bool {
        instructions!(vgetq_lane_u64::<0>(mask.0) & vgetq_lane_u64::<1>(mask.0)) != 0
    }
    #[inline(always)]
    fn any(mask: TwoAnswers) -> bool {
        instructions!(vgetq_lane_u64::<0>(mask.0) | vgetq_lane_u64::<1>(mask.0)) != 0
    }
}

impl PartialEq for Two {
    fn eq(&self, other: &Two) -> bool {
        self.lanes() == other.lanes()
    }
}

impl fmt::Debug for Two {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.lanes().fmt(f)
    }
}

impl PartialEq for TwoAnswers {
    fn eq(&self, other: &TwoAnswers) -> bool {
        let differ = instructions!(veorq_u64(self.0, other.0));
        !Two::any(TwoAnswers(differ))
    }
}

impl fmt::Debug for TwoAnswers {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        Two::from_bits(self.0).lanes().map(f64::to_bits).fmt(f)
    }
}
