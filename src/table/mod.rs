//! The table of a model: its variables, and how they are put together from parts.

mod assemble;
mod bound;
mod fault;
mod meaning;
mod packed;
mod path;
mod port;
mod variable;

pub use assemble::{BLANK, Starts, graft, graft_all, graft_one_with, graft_with, inline, place, place_all};
pub use bound::{Bound, Brief};
pub use fault::Fault;
pub use meaning::Meaning;
pub use packed::{Packed, Parts, Pool, Table, Variables};
pub use path::{Path, Segment};
pub use port::{Port, Ports, Range, ports, range_count, ranges};
pub use variable::{
    BaseType, Column, Computed, Enumeration, Item, Kind, Role, Variable, boolean, choice, column_of, integer,
    is_declared, real,
};
