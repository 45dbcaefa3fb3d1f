//! Many rows of one law at once, in the lanes of the processor's registers, with the bits of a row by itself.
//!
//! The kind of [`Registers`] is chosen when the program runs. Laws with modes have no such form; their runs, and whatever
//! else cannot be made side by side, are made one after the other by the same calls: see [`Worker`].

mod derivatives;
mod groups;
mod registers;
mod steady;
mod stepped;
mod worker;

use std::fmt;
use std::ops::Range;

use crate::memory::{self, OutOfMemory};
use crate::model::{Fit, ModelType, Role};
use crate::numerics::relaxation::Relaxation;
use groups::Groups;

pub use derivatives::Wanted;
pub use registers::Registers;
pub use steady::{Points, Steady};
pub use stepped::{Given, Stepped, Stopped, Take};
pub use worker::{Begin, Rows, Runs, Worker};

#[cfg(target_arch = "aarch64")]
use crate::number::register::neon::Two;
#[cfg(target_arch = "x86_64")]
use crate::number::register::pair::Pair;
#[cfg(target_arch = "x86_64")]
use crate::number::register::x86::{Eight, Four};

/// Rows of one law, which are worked on together.
///
/// ```
/// use stribeck::batch::{Batch, Registers};
///
/// let law = stribeck::catalogue::by_name("Coulomb").expect("a law");
/// let columns = ["velocity", "normal_force", "friction_force"].map(|name| law.find(name).expect("a variable"));
/// // None on a processor without such registers, and for a law with modes.
/// if let Some(mut batch) = Batch::new(law, Registers::best(), 3).expect("memory") {
///     batch.set(columns[0], |row| [-0.2, 0.1, 0.4][row]);
///     batch.set(columns[1], |_| 10.0);
///     assert!(batch.output());
///     let mut forces = [0.0; 3];
///     batch.get(columns[2], |row, force| forces[row] = force);
///     assert_eq!(forces, [-1.0, 1.0, 1.0]);
/// }
/// ```
pub struct Batch {
    model: &'static ModelType,
    groups: Kind,
}

/// Rows in one kind of registers.
enum Kind {
    #[cfg(target_arch = "x86_64")]
    Fours(Groups<Pair<Four>>),
    #[cfg(target_arch = "x86_64")]
    Eight(Groups<Eight>),
    #[cfg(target_arch = "aarch64")]
    Two(Groups<Two>),
    /// Other processors have none; never made.
    #[allow(dead_code, reason = "an enumeration needs a variant")]
    #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
    None(Groups<[f64; 1]>),
}

/// The same work on whichever groups there are.
macro_rules! on_groups {
    ($kind:expr, $groups:ident => $work:expr) => {
        match $kind {
            #[cfg(target_arch = "x86_64")]
            Kind::Fours($groups) => $work,
            #[cfg(target_arch = "x86_64")]
            Kind::Eight($groups) => $work,
            #[cfg(target_arch = "aarch64")]
            Kind::Two($groups) => $work,
            #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
            Kind::None($groups) => $work,
        }
    };
}

impl fmt::Debug for Batch {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} rows of {}", self.rows(), self.model.name)
    }
}

impl Batch {
    /// Rows at their start values, if the law runs in lanes, and the processor has the registers.
    #[cfg_attr(
        not(any(target_arch = "x86_64", target_arch = "aarch64")),
        allow(unreachable_code, unused_variables, reason = "other processors have no registers for it")
    )]
    pub fn new(model: &'static ModelType, registers: Registers, rows: usize) -> Result<Option<Batch>, OutOfMemory> {
        let Some(kernels) = model.kernels.as_ref().filter(|_| registers.are_here()) else { return Ok(None) };
        let groups = match registers {
            #[cfg(target_arch = "x86_64")]
            Registers::Avx2 => Kind::Fours(Groups::new(kernels.four, model.table.len(), rows)?),
            #[cfg(target_arch = "x86_64")]
            Registers::Avx512 => Kind::Eight(Groups::new(kernels.eight, model.table.len(), rows)?),
            #[cfg(target_arch = "aarch64")]
            Registers::Neon => Kind::Two(Groups::new(kernels.two, model.table.len(), rows)?),
            _ => return Ok(None),
        };
        let mut batch = Batch { model, groups };
        let start = memory::each(0..model.table.len(), |column| Ok(model.table.start(column)))?;
        let fits = rows > 0 && batch.load(0..rows, &start);
        Ok(fits.then_some(batch))
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        on_groups!(&self.groups, groups => groups.rows())
    }

    /// Writes the column of an input, with a value for each row, which must be admitted. Panics at any other column.
    #[inline]
    pub fn set(&mut self, column: usize, value: impl Fn(usize) -> f64) {
        assert!(self.model.table.role(column) == Role::Input, "only inputs are set in all rows");
        on_groups!(&mut self.groups, groups => groups.set(column, value));
    }

    /// Writes the same value into the column of an input, in every row.
    #[inline]
    pub fn fill(&mut self, column: usize, value: f64) {
        self.set(column, |_| value);
    }

    /// Writes all columns of some rows: those of a row of the law, which must be admitted. False, with nothing changed, if
    /// the row can only be worked on by itself, as that of a contact that knows the mass of its body.
    #[must_use]
    pub fn load(&mut self, rows: Range<usize>, row: &[f64]) -> bool {
        let fits = self.model.kernels.as_ref().is_some_and(|kernels| (kernels.fit)(row) != Fit::Alone);
        if fits {
            on_groups!(&mut self.groups, groups => groups.load(rows, row));
        }
        fits
    }

    /// Shows a column, row by row.
    #[inline]
    pub fn get(&self, column: usize, show: impl FnMut(usize, f64)) {
        on_groups!(&self.groups, groups => groups.get(column, show));
    }

    /// Writes the column of an input in the first rows, one value for each, which must be admitted; the other rows follow
    /// the last one.
    #[inline]
    fn set_from(&mut self, column: usize, values: &[f64]) {
        on_groups!(&mut self.groups, groups => groups.set_from(column, values));
    }

    /// Reads a column of the first rows.
    #[inline]
    fn read(&self, column: usize, values: &mut [f64]) {
        on_groups!(&self.groups, groups => groups.read(column, values));
    }

    /// The value of a column, if all rows have the same one.
    #[inline]
    fn same(&self, column: usize) -> Option<f64> {
        on_groups!(&self.groups, groups => groups.same(column))
    }

    /// Computes the outputs of steady sliding, except advice; the states stay as they are. False if one is not finite.
    #[inline]
    fn slide_steadily(&mut self) -> bool {
        on_groups!(&mut self.groups, groups => groups.slide_steadily())
    }

    /// Makes room for [`Batch::relax`], if the law has a state that relaxes.
    fn make_room_to_relax(&mut self) -> Result<(), OutOfMemory> {
        if self.model.kernels.as_ref().is_none_or(|kernels| kernels.relaxes.is_none()) {
            return Ok(());
        }
        on_groups!(&mut self.groups, groups => groups.make_room_to_relax())
    }

    /// Shows how the state that relaxes does so in each row over `dt` > 0, while the inputs are held. There must be room.
    #[inline]
    fn relax(&mut self, dt: f64, show: impl FnMut(usize, Relaxation<f64>)) {
        on_groups!(&mut self.groups, groups => groups.relax(dt, show));
    }

    /// Computes the outputs of all rows, except advice. False if one is not finite.
    #[inline]
    pub fn output(&mut self) -> bool {
        on_groups!(&mut self.groups, groups => groups.output())
    }

    /// Advances all rows by `dt` > 0, while their inputs are held; whether outputs lag behind is not said. False if a
    /// number is not finite.
    #[inline]
    pub fn advance(&mut self, dt: f64) -> bool {
        on_groups!(&mut self.groups, groups => groups.advance(dt))
    }

    /// [`Batch::advance`], and [`Batch::output`] after it. False if a state or an output is not finite.
    #[inline]
    pub fn advance_and_output(&mut self, dt: f64) -> bool {
        on_groups!(&mut self.groups, groups => groups.advance_and_output(dt))
    }
}
