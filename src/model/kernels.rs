//! A law over several rows at once, in the registers of a processor.

#![cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "aarch64")),
    allow(dead_code, reason = "other processors have no registers for it")
)]

use super::model_type::first_result;
use super::row::view;
use super::{Fit, InLanes, Law, Steps, model_in};
use crate::number::register::For;
use crate::number::{Lanes, Register};

#[cfg(target_arch = "aarch64")]
use crate::number::register::neon::Two;
#[cfg(target_arch = "x86_64")]
use crate::number::register::x86::{Eight, Four};

/// The functions of a law that runs in lanes, for each kind of register that a processor may have. A law's own text is
/// compiled for each of them, so all have the same bits.
pub struct Kernels {
    /// For processors with AVX2.
    #[cfg(target_arch = "x86_64")]
    pub(crate) four: Kernel<Four>,
    /// For processors with AVX-512.
    #[cfg(target_arch = "x86_64")]
    pub(crate) eight: Kernel<Eight>,
    /// For 64-bit ARM.
    #[cfg(target_arch = "aarch64")]
    pub(crate) two: Kernel<Two>,
    /// How a row fits beside others.
    pub(crate) fit: fn(&[f64]) -> Fit,
}

/// Rows of a law in groups, one row in each lane: a group after the other, column after column.
pub(crate) type Groups<'a, R> = &'a mut [Lanes<R>];

/// Work on groups with one kind of register. Returns whether all results are finite.
#[derive(Clone, Copy)]
pub(crate) struct Kernel<R> {
    /// Computes the outputs. It must only be called where the processor has the register.
    pub output: unsafe fn(Groups<R>) -> bool,
    /// Advances the states by a time > 0 while the inputs are held. It must only be called where the processor has the
    /// register.
    pub advance: unsafe fn(Groups<R>, f64) -> bool,
}

impl Kernels {
    /// Those of a law.
    pub(crate) const fn of<M: InLanes>() -> Kernels {
        Kernels {
            #[cfg(target_arch = "x86_64")]
            four: Kernel { output: output_with_avx2::<M>, advance: advance_with_avx2::<M> },
            #[cfg(target_arch = "x86_64")]
            eight: Kernel { output: output_with_avx512::<M>, advance: advance_with_avx512::<M> },
            #[cfg(target_arch = "aarch64")]
            two: Kernel { output: output::<M, Two>, advance: advance::<M, Two> },
            fit: |row| view::<M, f64>(row).fit(),
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn output_with_avx2<M: InLanes>(groups: Groups<Four>) -> bool {
    output::<M, Four>(groups)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn advance_with_avx2<M: InLanes>(groups: Groups<Four>, dt: f64) -> bool {
    advance::<M, Four>(groups, dt)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn output_with_avx512<M: InLanes>(groups: Groups<Eight>) -> bool {
    output::<M, Eight>(groups)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn advance_with_avx512<M: InLanes>(groups: Groups<Eight>, dt: f64) -> bool {
    advance::<M, Eight>(groups, dt)
}

/// Uses of a register: see [`For`].
const OUTPUT: usize = 0;
const ADVANCE: usize = 1;

#[inline(always)]
fn output<M: InLanes, R: Register>(groups: Groups<R>) -> bool {
    let first = const { first_result(M::TABLE) };
    let mut found = Lanes::from(0.0);
    for row in For::<OUTPUT, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        model_in::<M, Lanes<For<OUTPUT, R>>>(row).output();
        found = not_finite(found, &row[first..]);
    }
    found == Lanes::from(0.0)
}

#[inline(always)]
fn advance<M: InLanes, R: Register>(groups: Groups<R>, dt: f64) -> bool {
    let first = const { first_result(M::TABLE) };
    let mut found = Lanes::from(0.0);
    for row in For::<ADVANCE, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        model_in::<M, Lanes<For<ADVANCE, R>>>(row).advance(Lanes::from(dt));
        found = not_finite(found, &row[first..]);
    }
    found == Lanes::from(0.0)
}

/// NaN from the first number on that is not finite: x 0 is 0 for the others.
#[inline(always)]
fn not_finite<R: Register>(mut found: Lanes<R>, numbers: &[Lanes<R>]) -> Lanes<R> {
    for number in numbers {
        found += *number * Lanes::from(0.0);
    }
    found
}
