//! Rows in the lanes of one kind of register.

#![cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "aarch64")),
    allow(dead_code, reason = "other processors have no registers for it")
)]

use std::ops::Range;

use crate::memory::{self, OutOfMemory};
use crate::model::Kernel;
use crate::number::{Lanes, Register};
use crate::numerics::relaxation::{NUMBERS, Relaxation};

/// Rows in groups, one row in each lane: a group after the other, column after column.
pub(super) struct Groups<R> {
    kernel: Kernel<R>,
    columns: usize,
    rows: usize,
    lanes: Box<[Lanes<R>]>,
    /// How a state relaxes in each group, if there is room for it.
    relaxations: Box<[Lanes<R>]>,
}

impl<R: Register> Groups<R> {
    /// Rows of zeros. The processor must have the register.
    pub fn new(kernel: Kernel<R>, columns: usize, rows: usize) -> Result<Groups<R>, OutOfMemory> {
        let lanes = columns.checked_mul(rows.div_ceil(R::LANES)).ok_or(OutOfMemory)?;
        Ok(Groups {
            kernel,
            columns,
            rows,
            lanes: memory::filled(Lanes::from(0.0), lanes)?,
            relaxations: Box::default(),
        })
    }

    pub fn rows(&self) -> usize {
        self.rows
    }

    fn numbers(&self) -> &[f64] {
        numbers_of(&self.lanes)
    }

    fn numbers_mut(&mut self) -> &mut [f64] {
        numbers_of_mut(&mut self.lanes)
    }

    /// Writes a column. Lanes without a row follow the last one.
    #[inline]
    pub fn set(&mut self, column: usize, value: impl Fn(usize) -> f64) {
        let (columns, last) = (self.columns, self.rows - 1);
        for (group, numbers) in self.numbers_mut().chunks_exact_mut(columns * R::LANES).enumerate() {
            let lanes = &mut numbers[column * R::LANES..(column + 1) * R::LANES];
            for (lane, number) in lanes.iter_mut().enumerate() {
                *number = value((group * R::LANES + lane).min(last));
            }
        }
    }

    /// Writes all columns of some rows; lanes without a row follow the last one.
    pub fn load(&mut self, rows: Range<usize>, values: &[f64]) {
        let columns = self.columns;
        let end = if rows.end == self.rows { self.lanes.len() / columns * R::LANES } else { rows.end };
        let numbers = self.numbers_mut();
        for row in rows.start..end {
            let group = row / R::LANES * columns * R::LANES;
            for (column, value) in values.iter().enumerate() {
                numbers[group + column * R::LANES + row % R::LANES] = *value;
            }
        }
    }

    #[inline]
    pub fn get(&self, column: usize, mut show: impl FnMut(usize, f64)) {
        for (group, numbers) in self.numbers().chunks_exact(self.columns * R::LANES).enumerate() {
            let first = group * R::LANES;
            let lanes = &numbers[column * R::LANES..(column + 1) * R::LANES];
            for (lane, number) in lanes.iter().take(self.rows - first).enumerate() {
                show(first + lane, *number);
            }
        }
    }

    /// Writes a column; rows beyond the values follow the last one.
    #[inline]
    pub fn set_from(&mut self, column: usize, values: &[f64]) {
        let last = values[values.len() - 1];
        let mut groups = self.lanes.chunks_exact_mut(self.columns);
        let whole = values.chunks_exact(R::LANES);
        let rest = whole.remainder();
        for (part, group) in whole.zip(groups.by_ref()) {
            numbers_of_mut(&mut group[column..=column]).copy_from_slice(part);
        }
        for (number, group) in groups.enumerate() {
            let (lanes, rest) = (numbers_of_mut(&mut group[column..=column]), if number == 0 { rest } else { &[] });
            lanes.fill(last);
            lanes[..rest.len()].copy_from_slice(rest);
        }
    }

    /// Reads a column of the first rows.
    #[inline]
    pub fn read(&self, column: usize, values: &mut [f64]) {
        let mut groups = self.lanes.chunks_exact(self.columns).map(|group| numbers_of(&group[column..=column]));
        let mut whole = values.chunks_exact_mut(R::LANES);
        for (part, lanes) in whole.by_ref().zip(groups.by_ref()) {
            part.copy_from_slice(lanes);
        }
        if let Some(lanes) = groups.next() {
            whole.into_remainder().iter_mut().zip(lanes).for_each(|(value, lane)| *value = *lane);
        }
    }

    /// The number of a column that all rows have, with the same bits, if there is one.
    #[inline]
    pub fn same(&self, column: usize) -> Option<f64> {
        let first = self.numbers().get(column * R::LANES)?.to_bits();
        let mut differ = 0;
        for group in self.lanes.chunks_exact(self.columns) {
            for number in numbers_of(&group[column..=column]) {
                differ |= number.to_bits() ^ first;
            }
        }
        (differ == 0).then_some(f64::from_bits(first))
    }

    #[inline]
    pub fn slide_steadily(&mut self) -> bool {
        // SAFETY: the processor has the register: the promise to `new`.
        unsafe { (self.kernel.slide_steadily)(&mut self.lanes) }
    }

    /// Makes room for what [`Groups::relax`] finds.
    pub fn make_room_to_relax(&mut self) -> Result<(), OutOfMemory> {
        self.relaxations = memory::filled(Lanes::from(0.0), NUMBERS * self.rows.div_ceil(R::LANES))?;
        Ok(())
    }

    /// How the state that relaxes does so in each row over a step. There must be room for it.
    #[inline]
    pub fn relax(&mut self, dt: f64, mut show: impl FnMut(usize, Relaxation<f64>)) {
        assert!(!self.relaxations.is_empty(), "room to relax");
        // SAFETY: the processor has the register: the promise to `new`.
        unsafe { (self.kernel.relax)(&mut self.lanes, dt, &mut self.relaxations) };
        for (group, numbers) in numbers_of(&self.relaxations).chunks_exact(NUMBERS * R::LANES).enumerate() {
            let first = group * R::LANES;
            let lanes = |number: usize| &numbers[number * R::LANES..(number + 1) * R::LANES];
            let numbers: [&[f64]; NUMBERS] = std::array::from_fn(lanes);
            for lane in 0..R::LANES.min(self.rows - first) {
                show(first + lane, numbers.map(|lanes| lanes[lane]).into());
            }
        }
    }

    #[inline]
    pub fn output(&mut self) -> bool {
        // SAFETY: the processor has the register: the promise to `new`.
        unsafe { (self.kernel.output)(&mut self.lanes) }
    }

    #[inline]
    pub fn advance(&mut self, dt: f64) -> bool {
        // SAFETY: the processor has the register: the promise to `new`.
        unsafe { (self.kernel.advance)(&mut self.lanes, dt) }
    }

    #[inline]
    pub fn advance_and_output(&mut self, dt: f64) -> bool {
        match self.kernel.advance_and_output {
            // SAFETY: the processor has the register: the promise to `new`.
            Some(both) => unsafe { both(&mut self.lanes, dt) },
            None => self.advance(dt) & self.output(),
        }
    }
}

fn numbers_of<R: Register>(lanes: &[Lanes<R>]) -> &[f64] {
    // SAFETY: a register consists of so many numbers, and `Lanes` of a register.
    unsafe { std::slice::from_raw_parts(lanes.as_ptr().cast::<f64>(), lanes.len() * R::LANES) }
}

fn numbers_of_mut<R: Register>(lanes: &mut [Lanes<R>]) -> &mut [f64] {
    // SAFETY: as in `numbers_of`; the borrow is exclusive and passes on to the result.
    unsafe { std::slice::from_raw_parts_mut(lanes.as_mut_ptr().cast::<f64>(), lanes.len() * R::LANES) }
}
