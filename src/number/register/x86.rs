//! Registers of x86-64. They are only made where the processor has their instructions: by the functions of
//! [`crate::model::Kernels`], which [`crate::batch`] calls after it has asked.

use std::arch::x86_64::*;
use std::array::from_fn;
use std::fmt;

use super::Register;

/// Four numbers, with AVX2.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Four(__m256d);

/// Eight numbers, with AVX-512.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Eight(__m512d);

/// Answers in four lanes: all bits of a lane are set, or none.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct FourAnswers(__m256d);

/// Instructions of a processor.
macro_rules! instructions {
    ($work:expr) => {
        // SAFETY: registers exist only where the processor has the instructions: see the module.
        unsafe { $work }
    };
}

/// Operations that both registers have under names that differ in the width only.
macro_rules! register {
    ($Register:ident, $Answers:ty, $lanes:literal, $set:ident, $add:ident, $sub:ident, $mul:ident, $div:ident,
     $sqrt:ident, $min:ident, $max:ident, $logic:ident) => {
        const LANES: usize = $lanes;
        type Mask = $Answers;

        #[inline(always)]
        fn splat(value: f64) -> Self {
            $Register(instructions!($set(value)))
        }
        #[inline(always)]
        fn lane(self, lane: usize) -> f64 {
            self.lanes()[lane]
        }
        #[inline(always)]
        fn each(value: impl FnMut(usize) -> f64) -> Self {
            Self::of(from_fn(value))
        }
        #[inline(always)]
        fn plus(self, other: Self) -> Self {
            $Register(instructions!($add(self.0, other.0)))
        }
        #[inline(always)]
        fn minus(self, other: Self) -> Self {
            $Register(instructions!($sub(self.0, other.0)))
        }
        #[inline(always)]
        fn times(self, other: Self) -> Self {
            $Register(instructions!($mul(self.0, other.0)))
        }
        #[inline(always)]
        fn over(self, other: Self) -> Self {
            $Register(instructions!($div(self.0, other.0)))
        }
        #[inline(always)]
        fn negated(self) -> Self {
            $logic::xor(self, Self::splat(-0.0))
        }
        #[inline(always)]
        fn magnitude(self) -> Self {
            $logic::and_not(Self::splat(-0.0), self)
        }
        #[inline(always)]
        fn with_sign(self, of: Self) -> Self {
            $logic::or(self.magnitude(), $logic::and(Self::splat(-0.0), of))
        }
        #[inline(always)]
        fn root(self) -> Self {
            $Register(instructions!($sqrt(self.0)))
        }
        #[inline(always)]
        fn within(self, least: f64, most: f64) -> Self {
            // Of two numbers that are not in order, as one that is NaN, these instructions give the second one.
            let [least, most] = [least, most].map(Self::splat);
            $Register(instructions!($min(most.0, $max(least.0, self.0))))
        }
        #[inline(always)]
        fn power(self, offset: u64) -> Self {
            $logic::shifted(self, offset)
        }
        #[inline(always)]
        fn halves(self) -> [Self; 2] {
            $logic::halves(self)
        }
    };
}

impl Four {
    #[inline(always)]
    fn of(numbers: [f64; 4]) -> Four {
        // SAFETY: four numbers are read, wherever they are; the instructions exist, see the module.
        Four(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn lanes(self) -> [f64; 4] {
        let mut numbers = [0.0; 4];
        // SAFETY: four numbers are written, wherever they are; the instructions exist, see the module.
        unsafe { _mm256_storeu_pd(numbers.as_mut_ptr(), self.0) };
        numbers
    }
}

/// Bits of four numbers.
mod four {
    use super::*;

    #[inline(always)]
    pub fn and(a: Four, b: Four) -> Four {
        Four(instructions!(_mm256_and_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn or(a: Four, b: Four) -> Four {
        Four(instructions!(_mm256_or_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn xor(a: Four, b: Four) -> Four {
        Four(instructions!(_mm256_xor_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn and_not(a: Four, b: Four) -> Four {
        Four(instructions!(_mm256_andnot_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn shifted(a: Four, offset: u64) -> Four {
        Four(instructions!({
            let bits = _mm256_sub_epi64(_mm256_castpd_si256(a.0), _mm256_set1_epi64x(offset.cast_signed()));
            _mm256_castsi256_pd(_mm256_slli_epi64::<52>(bits))
        }))
    }
    #[inline(always)]
    pub fn halves(a: Four) -> [Four; 2] {
        let [first, second] = instructions!({
            let exponents = _mm256_and_si256(_mm256_castpd_si256(a.0), _mm256_set1_epi64x(0xfff));
            let first = _mm256_srli_epi64::<1>(exponents);
            [first, _mm256_sub_epi64(exponents, first)]
        });
        [first, second].map(|part| Four(instructions!(_mm256_castsi256_pd(_mm256_slli_epi64::<52>(part)))))
    }
}

// SAFETY: the register of a processor with four numbers.
unsafe impl Register for Four {
    register!(
        Four,
        FourAnswers,
        4,
        _mm256_set1_pd,
        _mm256_add_pd,
        _mm256_sub_pd,
        _mm256_mul_pd,
        _mm256_div_pd,
        _mm256_sqrt_pd,
        _mm256_min_pd,
        _mm256_max_pd,
        four
    );

    #[inline(always)]
    fn above(self, other: Four) -> FourAnswers {
        FourAnswers(instructions!(_mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn at_least(self, other: Four) -> FourAnswers {
        FourAnswers(instructions!(_mm256_cmp_pd::<_CMP_GE_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn equals(self, other: Four) -> FourAnswers {
        FourAnswers(instructions!(_mm256_cmp_pd::<_CMP_EQ_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: FourAnswers, yes: Four, no: Four) -> Four {
        Four(instructions!(_mm256_blendv_pd(no.0, yes.0, mask.0)))
    }
    #[inline(always)]
    fn answer(answer: bool) -> FourAnswers {
        FourAnswers(Four::splat(f64::from_bits(if answer { u64::MAX } else { 0 })).0)
    }
    #[inline(always)]
    fn both(a: FourAnswers, b: FourAnswers) -> FourAnswers {
        FourAnswers(four::and(Four(a.0), Four(b.0)).0)
    }
    #[inline(always)]
    fn one_of(a: FourAnswers, b: FourAnswers) -> FourAnswers {
        FourAnswers(four::or(Four(a.0), Four(b.0)).0)
    }
    #[inline(always)]
    fn inverse(mask: FourAnswers) -> FourAnswers {
        FourAnswers(four::xor(Four(mask.0), Four(Self::answer(true).0)).0)
    }
    #[inline(always)]
    fn all(mask: FourAnswers) -> bool {
        instructions!(_mm256_movemask_pd(mask.0)) == 0xf
    }
    #[inline(always)]
    fn any(mask: FourAnswers) -> bool {
        instructions!(_mm256_movemask_pd(mask.0)) != 0
    }
}

impl Eight {
    #[inline(always)]
    fn of(numbers: [f64; 8]) -> Eight {
        // SAFETY: eight numbers are read, wherever they are; the instructions exist, see the module.
        Eight(unsafe { _mm512_loadu_pd(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn lanes(self) -> [f64; 8] {
        let mut numbers = [0.0; 8];
        // SAFETY: eight numbers are written, wherever they are; the instructions exist, see the module.
        unsafe { _mm512_storeu_pd(numbers.as_mut_ptr(), self.0) };
        numbers
    }
}

/// Bits of eight numbers.
mod eight {
    use super::*;

    #[inline(always)]
    pub fn and(a: Eight, b: Eight) -> Eight {
        Eight(instructions!(_mm512_and_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn or(a: Eight, b: Eight) -> Eight {
        Eight(instructions!(_mm512_or_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn xor(a: Eight, b: Eight) -> Eight {
        Eight(instructions!(_mm512_xor_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn and_not(a: Eight, b: Eight) -> Eight {
        Eight(instructions!(_mm512_andnot_pd(a.0, b.0)))
    }
    #[inline(always)]
    pub fn shifted(a: Eight, offset: u64) -> Eight {
        Eight(instructions!({
            let bits = _mm512_sub_epi64(_mm512_castpd_si512(a.0), _mm512_set1_epi64(offset.cast_signed()));
            _mm512_castsi512_pd(_mm512_slli_epi64::<52>(bits))
        }))
    }
    #[inline(always)]
    pub fn halves(a: Eight) -> [Eight; 2] {
        let [first, second] = instructions!({
            let exponents = _mm512_and_si512(_mm512_castpd_si512(a.0), _mm512_set1_epi64(0xfff));
            let first = _mm512_srli_epi64::<1>(exponents);
            [first, _mm512_sub_epi64(exponents, first)]
        });
        [first, second].map(|part| Eight(instructions!(_mm512_castsi512_pd(_mm512_slli_epi64::<52>(part)))))
    }
}

// SAFETY: the register of a processor with eight numbers.
unsafe impl Register for Eight {
    register!(
        Eight,
        __mmask8,
        8,
        _mm512_set1_pd,
        _mm512_add_pd,
        _mm512_sub_pd,
        _mm512_mul_pd,
        _mm512_div_pd,
        _mm512_sqrt_pd,
        _mm512_min_pd,
        _mm512_max_pd,
        eight
    );

    #[inline(always)]
    fn above(self, other: Eight) -> __mmask8 {
        instructions!(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn at_least(self, other: Eight) -> __mmask8 {
        instructions!(_mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn equals(self, other: Eight) -> __mmask8 {
        instructions!(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn select(mask: __mmask8, yes: Eight, no: Eight) -> Eight {
        Eight(instructions!(_mm512_mask_blend_pd(mask, no.0, yes.0)))
    }
    #[inline(always)]
    fn answer(answer: bool) -> __mmask8 {
        if answer { 0xff } else { 0 }
    }
    #[inline(always)]
    fn both(a: __mmask8, b: __mmask8) -> __mmask8 {
        a & b
    }
    #[inline(always)]
    fn one_of(a: __mmask8, b: __mmask8) -> __mmask8 {
        a | b
    }
    #[inline(always)]
    fn inverse(mask: __mmask8) -> __mmask8 {
        !mask
    }
    #[inline(always)]
    fn all(mask: __mmask8) -> bool {
        mask == 0xff
    }
    #[inline(always)]
    fn any(mask: __mmask8) -> bool {
        mask != 0
    }
}

/// Equality and text, by lane.
macro_rules! shown {
    ($($Register:ident)+) => {
        $(
            impl PartialEq for $Register {
                #[inline(always)]
                fn eq(&self, other: &Self) -> bool {
                    <$Register as Register>::all(Register::equals(*self, *other))
                }
            }

            impl fmt::Debug for $Register {
                fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
                    self.lanes().fmt(f)
                }
            }
        )+
    };
}

shown!(Four Eight);

impl PartialEq for FourAnswers {
    fn eq(&self, other: &FourAnswers) -> bool {
        instructions!(_mm256_movemask_pd(self.0) == _mm256_movemask_pd(other.0))
    }
}

impl fmt::Debug for FourAnswers {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:04b}", instructions!(_mm256_movemask_pd(self.0)))
    }
}
