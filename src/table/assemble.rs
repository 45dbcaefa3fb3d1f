//! Tables put together from parts while the library is compiled.

use super::{Column, Path, Role, Segment, Variable, real};
use crate::unit;

/// Writes one variable into a table under construction and returns the next free column.
pub const fn place(table: &mut [Variable], at: usize, variable: Variable) -> usize {
    table[at] = variable;
    at + 1
}

/// Writes several variables of one name, with an index from 1, and returns the next free column.
pub const fn place_all<const N: usize>(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    role: Role,
    columns: &[Column; N],
    help: &'static str,
) -> usize {
    assert!(N <= u16::MAX as usize, "too many elements");
    let mut index = 0;
    while index < N {
        let path = Path::NONE.within(Segment { name, index: index as u16 + 1 });
        table[at + index] = columns[index].named(path, role, help);
        index += 1;
    }
    at + N
}

/// Writes the table of a part under its own names and returns the next free column.
pub const fn inline(table: &mut [Variable], at: usize, part: &[Variable]) -> usize {
    let mut column = 0;
    while column < part.len() {
        table[at + column] = part[column];
        column += 1;
    }
    at + column
}

/// Writes the table of a part under its name in this table and returns the next free column.
pub const fn graft(table: &mut [Variable], at: usize, place: Segment, part: &[Variable]) -> usize {
    let mut column = 0;
    while column < part.len() {
        table[at + column] = part[column];
        table[at + column].path = part[column].path.within(place);
        column += 1;
    }
    at + column
}

/// Writes the table of a part `count` times, with an index from 1, and returns the next free column.
pub const fn graft_all(
    table: &mut [Variable],
    mut at: usize,
    name: &'static str,
    count: usize,
    part: &[Variable],
) -> usize {
    assert!(count <= u16::MAX as usize, "too many elements");
    let mut index = 1;
    while index <= count {
        at = graft(table, at, Segment { name, index: index as u16 }, part);
        index += 1;
    }
    at
}

/// Start values by column name: those of the first parts of an array, in order.
pub type Starts<'a> = &'a [(&'a str, &'a [f64])];

/// As [`graft_all`]; then the first parts get their own start values. A name that the part does not have, more values
/// than parts, or a value outside its bound does not compile.
pub const fn graft_with(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    count: usize,
    part: &[Variable],
    starts: Starts,
) -> usize {
    let end = graft_all(table, at, name, count, part);
    let mut entry = 0;
    while entry < starts.len() {
        let (column, values) = starts[entry];
        assert!(values.len() <= count, "more start values than parts");
        let mut index = 0;
        while index < values.len() {
            restart(table, at + index * part.len(), part, column, values[index]);
            index += 1;
        }
        entry += 1;
    }
    end
}

/// As [`graft`]; then columns get their own start values, as in [`graft_with`].
pub const fn graft_one_with(
    table: &mut [Variable],
    at: usize,
    name: &'static str,
    part: &[Variable],
    starts: &[(&str, f64)],
) -> usize {
    let end = graft(table, at, Segment { name, index: 0 }, part);
    let mut entry = 0;
    while entry < starts.len() {
        let (column, value) = starts[entry];
        restart(table, at, part, column, value);
        entry += 1;
    }
    end
}

/// Gives another start value to a column of the part that was written at `at`.
const fn restart(table: &mut [Variable], at: usize, part: &[Variable], column: &str, value: f64) {
    let mut offset = 0;
    while !unit::same(part[offset].path.segments()[0].name, column) {
        offset += 1;
    }
    let variable = &mut table[at + offset];
    assert!(variable.bound.admits(value), "the start value is outside its bound");
    variable.start = value;
}

/// A table entry to be overwritten by [`place`] or [`graft`].
pub const BLANK: Variable = real("1", 0.0).named(Path::root(""), Role::Output, "");
