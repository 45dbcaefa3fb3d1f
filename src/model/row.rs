//! Rows of numbers seen as models, and steps that change all of a row or nothing.

use std::ops::Range;

use super::{Columns, Model, Numbers};
use crate::number::{Mask, Real};

/// Workspace for a copy of a row and its memory, or none: a row of many elements is too long for the stack of a host.
pub(crate) type Room<'a> = &'a mut [f64];

/// Works on row and memory and returns whether every number from column `first` on is finite. Otherwise, and if the
/// work panics, both are as before, provided that there is workspace for a copy. The work must not change anything
/// before that column. Idle columns and the part of the memory that is not in use cost nothing.
#[inline(always)]
pub(super) fn commit<M: Model>(
    row: &mut [f64],
    memory: &mut [f64],
    room: Room,
    first: usize,
    work: impl FnOnce(&mut M, &mut [f64]),
) -> bool {
    let model = view_mut::<M, f64>(row);
    let in_use = model.memory_in_use();
    assert!(in_use <= memory.len(), "a row that asks for the memory of an instance");
    let memory = &mut memory[..in_use];
    let spans = if M::HAS_IDLE { spans(model, first) } else { Default::default() };
    let has_room = room.len() == M::TABLE.len() + M::MEMORY;
    if has_room {
        let (row_copy, memory_copy) = room.split_at_mut(M::TABLE.len());
        copy::<M>(row_copy, row_of(model), first, &spans);
        memory_copy[..memory.len()].copy_from_slice(memory);
    }
    let mut guard = RollBack::<M> { row: model, memory, room, first, spans, keep: !has_room };
    work(guard.row, guard.memory);
    let row = row_of(guard.row);
    let is_finite = if M::HAS_IDLE {
        guard.spans.iter().all(|span| are_finite(&row[span.clone()]))
    } else {
        are_finite(&row[first..])
    };
    let is_finite = is_finite && are_finite(guard.memory);
    guard.keep |= is_finite;
    is_finite
}

/// The columns from `first` on that are not idle.
fn spans<M: Model>(model: &M, first: usize) -> [Range<usize>; 3] {
    let [a, b] = model.idle();
    [first..a.start, a.end..b.start, b.end..M::TABLE.len()]
}

/// x 0 is 0 for every finite x, and NaN for the others, whose exponent has all bits set. Bits can be gathered in any
/// order, so no number waits for the one before.
#[inline(always)]
fn are_finite(numbers: &[f64]) -> bool {
    const EXPONENT: u64 = f64::INFINITY.to_bits();
    numbers.iter().fold(0, |found, value| found | (value * 0.0).to_bits()) & EXPONENT == 0
}

/// Copies the columns from `first` on, or the spans of them that are not idle.
#[inline(always)]
fn copy<M: Model>(to: &mut [f64], from: &[f64], first: usize, spans: &[Range<usize>; 3]) {
    if !M::HAS_IDLE {
        return to[first..].copy_from_slice(&from[first..]);
    }
    for span in spans {
        to[span.clone()].copy_from_slice(&from[span.clone()]);
    }
}

/// Restores row and memory unless told to keep them. The work is done in place, not on a copy that is written back,
/// because processors stall where a vector copy reads numbers that were just written one by one.
struct RollBack<'a, M: Model> {
    row: &'a mut M,
    memory: &'a mut [f64],
    room: Room<'a>,
    first: usize,
    spans: [Range<usize>; 3],
    keep: bool,
}

impl<M: Model> Drop for RollBack<'_, M> {
    #[inline(always)]
    fn drop(&mut self) {
        if !self.keep {
            let (row, memory) = self.room.split_at(M::TABLE.len());
            copy::<M>(row_of_mut(self.row), row, self.first, &self.spans);
            self.memory.copy_from_slice(&memory[..self.memory.len()]);
        }
    }
}

/// The row of a model, as plain numbers.
pub fn row_of<M: Columns>(model: &M) -> &[f64] {
    const { assert!(size_of::<M>() == M::TABLE.len() * size_of::<f64>()) };
    // SAFETY: `Columns` promises a `#[repr(C)]` struct of exactly this many f64, checked above for size.
    unsafe { std::slice::from_raw_parts(std::ptr::from_ref(model).cast::<f64>(), M::TABLE.len()) }
}

/// The row of a model, mutable.
pub fn row_of_mut<M: Columns>(model: &mut M) -> &mut [f64] {
    const { assert!(size_of::<M>() == M::TABLE.len() * size_of::<f64>()) };
    // SAFETY: as in `row_of`; every bit pattern is a valid f64, so no write can break the model.
    unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(model).cast::<f64>(), M::TABLE.len()) }
}

/// A row seen as the model it belongs to. `M` is the model in the number type `T`.
#[inline(always)]
pub(super) fn view<M, T>(row: &[T]) -> &M {
    const { assert!(align_of::<M>() == align_of::<T>() && size_of::<M>().is_multiple_of(size_of::<T>())) };
    assert!(size_of_val(row) == size_of::<M>(), "a row of another model");
    // SAFETY: models are `#[repr(C)]` structs of T (the promise of `Columns`), T is a plain number for which every bit
    // pattern is valid, and size and alignment were just checked.
    unsafe { &*row.as_ptr().cast::<M>() }
}

/// As [`view`], mutable.
#[inline(always)]
pub(super) fn view_mut<M, T>(row: &mut [T]) -> &mut M {
    const { assert!(align_of::<M>() == align_of::<T>() && size_of::<M>().is_multiple_of(size_of::<T>())) };
    assert!(size_of_val(row) == size_of::<M>(), "a row of another model");
    // SAFETY: as in `view`; the borrow of `row` is exclusive and passes on to the result.
    unsafe { &mut *row.as_mut_ptr().cast::<M>() }
}

/// The numbers of a model or part, mutable.
#[inline(always)]
pub(super) fn numbers_of<P: Numbers>(part: &mut P) -> &mut [P::Number] {
    const { assert!(align_of::<P>() == align_of::<P::Number>() && size_of::<P::Number>() > 0) };
    let count = size_of::<P>() / size_of::<P::Number>();
    // SAFETY: `Numbers` promises a `#[repr(C)]` struct that consists only of these numbers, which are this many; the
    // borrow of `part` is exclusive and passes on to the result.
    unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(part).cast::<P::Number>(), count) }
}

/// Changes a model in one way where the answer is yes, and in the other way elsewhere. Only the way that counts is taken,
/// or both where lanes differ.
#[inline(always)]
pub(crate) fn either<M: Numbers<Number: Real>>(
    model: &mut M,
    answer: <M::Number as Real>::Mask,
    yes: impl FnOnce(&mut M),
    no: impl FnOnce(&mut M),
) {
    match answer.agreed() {
        Some(true) => yes(model),
        Some(false) => no(model),
        None => {
            let mut other = *model;
            yes(&mut other);
            no(model);
            for (number, other) in numbers_of(model).iter_mut().zip(numbers_of(&mut other)) {
                *number = answer.choose(|| *other, || *number);
            }
        }
    }
}

/// Takes the numbers of another model where the answer is no.
#[inline(always)]
pub(crate) fn mix<M: Numbers<Number: Real>>(model: &mut M, answer: <M::Number as Real>::Mask, other: &mut M) {
    for (number, other) in numbers_of(model).iter_mut().zip(numbers_of(other)) {
        *number = answer.select(*number, *other);
    }
}

/// [`either`] with statements, which no compiler has to inline first.
macro_rules! change {
    ($model:expr, $answer:expr, |$yes:ident| $with:expr, |$no:ident| $without:expr) => {{
        let (model, answer) = ($model, $answer);
        if T::HAS_ONE_LANE {
            if $crate::number::Mask::<T>::any(answer) {
                let $yes = model;
                $with;
            } else {
                let $no = model;
                $without;
            }
        } else {
            let mut other = *model;
            if $crate::number::Mask::<T>::any(answer) {
                let $yes = &mut *model;
                $with;
            }
            if !$crate::number::Mask::<T>::all(answer) {
                let $no = &mut other;
                $without;
                $crate::model::mix(model, answer, &mut other);
            }
        }
    }};
}
pub(crate) use change;

/// Numbers viewed as consecutive parts; a remainder is ignored.
pub(crate) fn parts<P: Numbers>(numbers: &[P::Number]) -> &[P] {
    const { assert!(align_of::<P>() == align_of::<P::Number>() && size_of::<P>() > 0) };
    let count = size_of_val(numbers) / size_of::<P>();
    // SAFETY: `Numbers` promises a `#[repr(C)]` struct that consists only of these numbers; the alignment was just
    // checked, and the slice contains this many parts.
    unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast::<P>(), count) }
}

/// As [`parts`], mutable.
pub(crate) fn parts_mut<P: Numbers>(numbers: &mut [P::Number]) -> &mut [P] {
    const { assert!(align_of::<P>() == align_of::<P::Number>() && size_of::<P>() > 0) };
    let count = size_of_val(numbers) / size_of::<P>();
    // SAFETY: as in `parts`; a part consists only of numbers, so no write can break the slice, and its borrow is
    // exclusive and passes on to the result.
    unsafe { std::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast::<P>(), count) }
}
