//! Tables of measurements as rigs and dynamometers write them.
//!
//! A heading names the columns, each with its unit in brackets if it is not the SI unit; a row of units may follow it
//! instead, with any units for columns that nobody reads. What testing machines write above the heading is not read, which
//! a note says. The separator (tab, semicolon, comma, or blanks if there is none of these) is that of the heading; unless
//! it is a comma, numbers may have a decimal comma. `#` or `%` at the start of a line begins a comment, which is the heading
//! where it names the columns right above the numbers; unused columns are ignored. A column of time may have time stamps:
//! times of day, or dates and times by ISO 8601.

mod binary;
mod error;
mod guard;
mod heading;
#[cfg(feature = "mat")]
mod mat;
mod sheet;
#[cfg(feature = "spreadsheet")]
mod spreadsheet;
mod time_stamp;
mod units;

pub use binary::{NO_SHEETS, has_sheets, table, tables};
pub use error::{SheetError, of_file};
pub use sheet::{Sheet, check_names, text};
pub use units::{
    ANGLE, ANGULAR_VELOCITY, CURRENT, DISPLACEMENT, FORCE, MOMENT, NORMAL_FORCE, PRESSURE, Quantity, SLIP, TEMPERATURE,
    TIME, VELOCITY,
};
