//! Errors of tables.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Largest file that is read, in bytes (chosen: some ten million rows).
pub(crate) const LARGEST: u64 = 1 << 30;

/// An error about a file, with its name unless it has it already.
pub fn of_file(path: &Path, error: &dyn std::fmt::Display) -> String {
    let (name, text) = (path.display().to_string(), error.to_string());
    if text.starts_with(&name) { text } else { format!("{name}: {text}") }
}

/// Error in a table.
#[derive(Debug, Error)]
pub enum SheetError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is too large.
    #[error("{}: has {bytes} bytes, must be at most {LARGEST}: record fewer samples a second", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Its size.
        bytes: u64,
    },
    /// The file has another format, or is damaged.
    #[error("{}: {why}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// Why.
        why: String,
    },
    /// The text is not a table.
    #[error("no table: {0}")]
    Table(#[from] csv::Error),
    /// A row has not as many cells as the heading.
    #[error("no table: line {line}, columns: {cells}, must be {headings} as in the heading{hint}")]
    Row {
        /// Line of the file.
        line: u64,
        /// Number of its cells.
        cells: u64,
        /// Number of the headings.
        headings: u64,
        /// Possible reason.
        hint: &'static str,
    },
    /// A required column is missing.
    #[error("no column '{wanted}'; there are {found}{hint}")]
    Column {
        /// The column.
        wanted: String,
        /// The headings of the file.
        found: String,
        /// How a heading is to be written, if one of them looks like the column.
        hint: String,
    },
    /// Several columns may be the wanted one.
    #[error("{wanted}: '{candidates}' may be it; say which: --column {wanted}=...")]
    Ambiguous {
        /// The quantity.
        wanted: String,
        /// The columns.
        candidates: String,
    },
    /// A column may be the force, but its unit is not that of a force.
    #[error(
        "'{column}' may be the force, but not in N: give the factor to N, --scale force=..., or --column force=... if it is \
         another column; for the current of a joint --torque-constant"
    )]
    NoFactor {
        /// The column.
        column: String,
    },
    /// A record has no such quantity.
    #[error("quantity '{name}': must be one of {wanted}")]
    Quantity {
        /// Its name.
        name: String,
        /// The quantities of a record.
        wanted: String,
    },
    /// A quantity is named for two columns.
    #[error("column {name} = {column}: {name} is {other} already")]
    NamedTwice {
        /// The quantity.
        name: String,
        /// The second column.
        column: String,
        /// The first one.
        other: String,
    },
    /// A factor is 0 or not finite.
    #[error("scale {name} = {factor}: must be finite and not 0")]
    Factor {
        /// The quantity.
        name: String,
        /// The factor.
        factor: f64,
    },
    /// Two columns have the same name.
    #[error("two columns '{0}'")]
    Twice(String),
    /// The unit in a heading is not known.
    #[error("{column}: unit '{unit}', must be one of {wanted}")]
    Unit {
        /// The column.
        column: String,
        /// Its text.
        unit: String,
        /// The units that are known.
        wanted: String,
    },
    /// A cell is not a finite number, or not a time stamp among such.
    #[error("line {line}, {column}: '{text}' is not {wanted}")]
    Number {
        /// Line of the file.
        line: u64,
        /// The column.
        column: String,
        /// Its text.
        text: String,
        /// Requirement that it fails.
        wanted: &'static str,
    },
    /// The table has no rows.
    #[error("the table has no rows")]
    Empty,
}
