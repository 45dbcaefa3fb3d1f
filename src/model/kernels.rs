//! A law over several rows at once, in the registers of a processor.

#![cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "aarch64")),
    allow(dead_code, unused_macros, reason = "other processors have no registers for it")
)]

use super::row::{numbers_of, view};
use super::{Fit, InLanes, Law, Shared, Steps, model_in};
use crate::number::register::For;
use crate::number::{Lanes, Register};
use crate::numerics::relaxation::NUMBERS;
use crate::table::{Role, Variable};

#[cfg(target_arch = "aarch64")]
use crate::number::register::neon::Two;
#[cfg(target_arch = "x86_64")]
use crate::number::register::pair::Pair;
#[cfg(target_arch = "x86_64")]
use crate::number::register::x86::{Eight, Four};

/// The functions of a law that runs in lanes, for each kind of register that a processor may have. A law's own text is
/// compiled for each of them, so all have the same bits.
pub struct Kernels {
    /// For processors with AVX2.
    #[cfg(target_arch = "x86_64")]
    pub(crate) four: Kernel<Pair<Four>>,
    /// For processors with AVX-512.
    #[cfg(target_arch = "x86_64")]
    pub(crate) eight: Kernel<Eight>,
    /// For 64-bit ARM.
    #[cfg(target_arch = "aarch64")]
    pub(crate) two: Kernel<Two>,
    /// How a row fits beside others.
    pub(crate) fit: fn(&[f64]) -> Fit,
    /// The state that relaxes over a step: [`InLanes::RELAXES`].
    pub(crate) relaxes: Option<usize>,
}

/// Rows of a law in groups, one row in each lane: a group after the other, column after column.
pub(crate) type Groups<'a, R> = &'a mut [Lanes<R>];

/// Work on groups with one kind of register. Returns whether all results are finite.
#[derive(Clone, Copy)]
pub(crate) struct Kernel<R> {
    /// Computes the outputs. It must only be called where the processor has the register.
    pub output: unsafe fn(Groups<R>) -> bool,
    /// Advances the states by a time > 0 while the inputs are held, and may compute the outputs as well. It must only be
    /// called where the processor has the register.
    pub advance: unsafe fn(Groups<R>, f64) -> bool,
    /// Advances the states and computes the outputs, where one function for both costs less than two. It must only be
    /// called where the processor has the register.
    pub advance_and_output: Option<unsafe fn(Groups<R>, f64) -> bool>,
    /// Computes the outputs of steady sliding, and leaves the states. It must only be called where the processor has the
    /// register.
    pub slide_steadily: unsafe fn(Groups<R>) -> bool,
    /// Finds how the state that relaxes moves in a step: for each group the numbers of a `Relaxation`.
    /// It must only be called where the processor has the register.
    pub relax: unsafe fn(Groups<R>, f64, Groups<R>),
}

/// The functions of a law for one kind of register, of which it needs some.
macro_rules! kernel {
    ($M:ident: $output:expr, $advance:expr, $both:expr, $slide_steadily:expr, $relax:expr) => {
        Kernel {
            output: $output,
            advance: if shared::<$M>(Shared::All) { $both } else { $advance },
            advance_and_output: if shared::<$M>(Shared::Nothing) { None } else { Some($both) },
            slide_steadily: if $M::STEADY_SLIDING { $slide_steadily } else { $output },
            relax: if $M::RELAXES.is_some() { $relax } else { |_, _, _| {} },
        }
    };
}

impl Kernels {
    /// Those of a law.
    pub(crate) const fn of<M: InLanes>() -> Kernels {
        Kernels {
            #[cfg(target_arch = "x86_64")]
            four: kernel!(
                M: output_with_avx2::<M>,
                advance_with_avx2::<M>,
                advance_and_output_with_avx2::<M>,
                slide_steadily_with_avx2::<M>,
                relax_with_avx2::<M>
            ),
            #[cfg(target_arch = "x86_64")]
            eight: kernel!(
                M: output_with_avx512::<M>,
                advance_with_avx512::<M>,
                advance_and_output_with_avx512::<M>,
                slide_steadily_with_avx512::<M>,
                relax_with_avx512::<M>
            ),
            #[cfg(target_arch = "aarch64")]
            two: kernel!(
                M: output::<M, Two>,
                advance::<M, Two>,
                advance_and_output::<M, Two>,
                slide_steadily::<M, Two>,
                relax::<M, Two>
            ),
            fit: |row| view::<M, f64>(row).fit(),
            relaxes: M::RELAXES,
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn output_with_avx2<M: InLanes>(groups: Groups<Pair<Four>>) -> bool {
    output::<M, Pair<Four>>(groups)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn advance_with_avx2<M: InLanes>(groups: Groups<Pair<Four>>, dt: f64) -> bool {
    advance::<M, Pair<Four>>(groups, dt)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn advance_and_output_with_avx2<M: InLanes>(groups: Groups<Pair<Four>>, dt: f64) -> bool {
    advance_and_output::<M, Pair<Four>>(groups, dt)
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

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn advance_and_output_with_avx512<M: InLanes>(groups: Groups<Eight>, dt: f64) -> bool {
    advance_and_output::<M, Eight>(groups, dt)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn slide_steadily_with_avx2<M: InLanes>(groups: Groups<Pair<Four>>) -> bool {
    slide_steadily::<M, Pair<Four>>(groups)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn slide_steadily_with_avx512<M: InLanes>(groups: Groups<Eight>) -> bool {
    slide_steadily::<M, Eight>(groups)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn relax_with_avx2<M: InLanes>(groups: Groups<Pair<Four>>, dt: f64, found: Groups<Pair<Four>>) {
    relax::<M, Pair<Four>>(groups, dt, found);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn relax_with_avx512<M: InLanes>(groups: Groups<Eight>, dt: f64, found: Groups<Eight>) {
    relax::<M, Eight>(groups, dt, found);
}

/// Uses of a register: see [`For`].
const OUTPUT: usize = 0;
const ADVANCE: usize = 1;
const STEADY: usize = 2;
const RELAX: usize = 3;
const BOTH: usize = 4;

/// Whether a step and the outputs of a law have so much in common.
const fn shared<M: InLanes>(much: Shared) -> bool {
    <M::Of<f64> as Steps>::SHARED as u8 == much as u8
}

#[inline(always)]
fn output<M: InLanes, R: Register>(groups: Groups<R>) -> bool {
    let outputs = const { columns(M::TABLE, Role::Output, Role::Output) };
    let mut found = Lanes::from(0.0);
    for row in For::<OUTPUT, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        model_in::<M, Lanes<For<OUTPUT, R>>>(row).output();
        found += not_finite(&row[outputs.0..outputs.1]);
    }
    found == Lanes::from(0.0)
}

#[inline(always)]
fn advance<M: InLanes, R: Register>(groups: Groups<R>, dt: f64) -> bool {
    let states = const { columns(M::TABLE, Role::State, Role::StateOutput) };
    let mut found = Lanes::from(0.0);
    for row in For::<ADVANCE, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        model_in::<M, Lanes<For<ADVANCE, R>>>(row).advance(Lanes::from(dt));
        found += not_finite(&row[states.0..states.1]);
    }
    found == Lanes::from(0.0)
}

#[inline(always)]
fn advance_and_output<M: InLanes, R: Register>(groups: Groups<R>, dt: f64) -> bool {
    let outputs = const { columns(M::TABLE, Role::Output, Role::Output) };
    let states = const { columns(M::TABLE, Role::State, Role::StateOutput) };
    let mut found = Lanes::from(0.0);
    for row in For::<BOTH, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        model_in::<M, Lanes<For<BOTH, R>>>(row).advance_and_output(Lanes::from(dt));
        found += not_finite(&row[states.0..states.1]) + not_finite(&row[outputs.0..outputs.1]);
    }
    found == Lanes::from(0.0)
}

#[inline(always)]
fn slide_steadily<M: InLanes, R: Register>(groups: Groups<R>) -> bool {
    let outputs = const { columns(M::TABLE, Role::Output, Role::Output) };
    let mut found = Lanes::from(0.0);
    for row in For::<STEADY, R>::groups(groups).chunks_exact_mut(M::TABLE.len()) {
        // The states stay as they are: a contact at rest begins with them at the next point.
        let mut sliding = *model_in::<M, Lanes<For<STEADY, R>>>(row);
        sliding.slide_steadily();
        sliding.output();
        let outputs = outputs.0..outputs.1;
        row[outputs.clone()].copy_from_slice(&numbers_of(&mut sliding)[outputs.clone()]);
        found += not_finite(&row[outputs]);
    }
    found == Lanes::from(0.0)
}

#[inline(always)]
fn relax<M: InLanes, R: Register>(groups: Groups<R>, dt: f64, found: Groups<R>) {
    let rows = For::<RELAX, R>::groups(groups).chunks_exact_mut(M::TABLE.len());
    for (row, found) in rows.zip(For::<RELAX, R>::groups(found).chunks_exact_mut(NUMBERS)) {
        if let Some(relaxation) = model_in::<M, Lanes<For<RELAX, R>>>(row).relaxation(Lanes::from(dt)) {
            found.copy_from_slice(&<[_; NUMBERS]>::from(relaxation));
        }
    }
}

/// The columns from the first to the last one with one of two roles, as a range: all others keep their numbers.
const fn columns(table: &[Variable], one: Role, other: Role) -> (usize, usize) {
    let (mut first, mut end, mut column) = (table.len(), table.len(), 0);
    while column < table.len() {
        let role = table[column].role as u8;
        if role == one as u8 || role == other as u8 {
            if first == table.len() {
                first = column;
            }
            end = column + 1;
        }
        column += 1;
    }
    (first, end)
}

/// NaN if one of the numbers is not finite: x 0 is 0 for the others. They are added to each other first, so that no row
/// waits for the one before.
#[inline(always)]
fn not_finite<R: Register>(numbers: &[Lanes<R>]) -> Lanes<R> {
    let mut found = Lanes::from(0.0);
    for number in numbers {
        found += *number * Lanes::from(0.0);
    }
    found
}
