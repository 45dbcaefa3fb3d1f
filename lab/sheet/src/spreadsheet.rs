//! Tables of spreadsheets.

use std::fmt::Display;
use std::io::Cursor;
use std::path::Path;

use calamine::{Data, ExcelDateTime, ExcelDateTimeType, Ods, Range, Reader, SheetType, SheetVisible, Xlsx};

use crate::error::SheetError;
use crate::guard::{refused, silently};
use crate::heading::is_of_units;
use crate::sheet::{Sheet, not_too_large};
use crate::time_stamp::Stamp;

/// A row of a sheet: its number, from 1, and its cells as text.
type Row = (u64, Vec<String>);

/// The table of a sheet, or of the first one that has a table: a heading over numbers, perhaps with a row of units
/// between them. Hidden sheets come last.
pub(super) fn read(path: &Path, extension: &str, wanted: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
    not_too_large(path)?;
    let bytes = Cursor::new(std::fs::read(path).map_err(|error| refused(path, error))?);
    let text = |error: &dyn Display| format!("the file is not a spreadsheet, or is damaged ({error})");
    let found = match extension {
        "ods" => silently(|| table_of(Ods::new(bytes).map_err(|error| text(&error))?, wanted)),
        _ => silently(|| table_of(Xlsx::new(bytes).map_err(|error| text(&error))?, wanted)),
    };
    found
        .unwrap_or_else(|| Err("the file is damaged".to_owned()))
        .map(|sheet| vec![sheet])
        .map_err(|why| refused(path, why))
}

fn table_of<R: Reader<Cursor<Vec<u8>>>>(mut book: R, wanted: Option<&str>) -> Result<Sheet, String>
where
    R::Error: Display,
{
    let sheets = book.sheets_metadata().iter().filter(|sheet| sheet.typ == SheetType::WorkSheet);
    let (seen, hidden): (Vec<_>, Vec<_>) = sheets.partition(|sheet| sheet.visible == SheetVisible::Visible);
    let names: Vec<String> = seen.into_iter().chain(hidden).map(|sheet| sheet.name.clone()).collect();
    let all = names.join("', '");
    let mut table = |name: &str| {
        let range = book.worksheet_range(name).map_err(|error| format!("sheet '{name}': {error}"))?;
        Ok::<_, String>(of_range(&range))
    };
    if let Some(name) = wanted {
        if !names.iter().any(|known| known == name) {
            return Err(format!("no sheet '{name}'; there are '{all}'"));
        }
        return table(name)?.ok_or_else(|| format!("sheet '{name}' has no heading over numbers"));
    }
    for name in &names {
        if let Some(sheet) = table(name)? {
            let note = format!(
                "the table was read from sheet '{name}', the first of {} that has one; --sheet NAME chooses another",
                names.len()
            );
            return Ok(sheet.with(Some(note).filter(|_| names.len() > 1)));
        }
    }
    Err(format!("no sheet has a heading over numbers; there are '{all}'"))
}

fn of_range(range: &Range<Data>) -> Option<Sheet> {
    let first = u64::from(range.start()?.0) + 1;
    let filled = (first..).zip(range.rows()).filter(|(_, cells)| cells.iter().any(|cell| !is_empty(cell)));
    let rows: Vec<(u64, &[Data])> = filled.collect();
    let at = (1..rows.len()).find(|at| is_heading(rows[at - 1].1, &rows[*at..]))?;
    let above = at.checked_sub(2).map(|above| rows[above]).filter(|(number, _)| number + 1 == rows[at - 1].0);
    let heading = |column: usize| match &rows[at - 1].1[column] {
        // A heading may be merged with the cell above it, which then has the text.
        Data::Empty if is_number(&rows[at].1[column]) => above.map_or(&Data::Empty, |(_, cells)| &cells[column]),
        cell => cell,
    };
    let columns: Vec<usize> = (0..range.width()).filter(|column| !is_empty(heading(*column))).collect();
    let row = |(number, cells): &(u64, &[Data])| (*number, columns.iter().map(|at| text(&cells[*at])).collect());
    let headings: Vec<String> = columns.iter().map(|column| text(heading(*column))).collect();
    Some(Sheet::under(headings.iter().map(String::as_str), rows[at..].iter().map(row).map(record).collect(), ';'))
}

fn is_empty(cell: &Data) -> bool {
    matches!(cell, Data::Empty)
}

/// Whether a cell has a number or a moment, perhaps as text.
fn is_number(cell: &Data) -> bool {
    match cell {
        Data::Empty | Data::Error(_) => false,
        Data::String(text) => {
            let is_plain = text.contains(|letter: char| letter.is_ascii_digit());
            is_plain && text.trim().replace(',', ".").parse::<f64>().is_ok() || Stamp::parse(text).is_some()
        }
        _ => true,
    }
}

/// Whether a row of texts is the heading of the rows below it: of units, or of numbers in two columns. Notes often have
/// a number beside its name.
fn is_heading(row: &[Data], below: &[(u64, &[Data])]) -> bool {
    let is_text = |cell: &Data| matches!(cell, Data::String(_)) && !is_number(cell);
    let texts = row.iter().filter(|cell| is_text(cell)).count();
    let next = below[0].1;
    let has_number = |column: &usize| below.iter().take(2).any(|(_, cells)| is_number(&cells[*column]));
    let is_over_numbers = || next.iter().any(is_number) && (0..row.len()).filter(has_number).count() > 1;
    let is_over_units = || is_of_units(&record((1, next.iter().map(text).collect())));
    texts > 1 && row.iter().all(|cell| is_text(cell) || is_empty(cell)) && (is_over_numbers() || is_over_units())
}

fn record((number, cells): Row) -> csv::StringRecord {
    let mut record = csv::StringRecord::from(cells);
    let mut position = csv::Position::new();
    position.set_line(number);
    record.set_position(Some(position));
    record
}

/// A cell as text; a date or a time of day as a time stamp.
fn text(cell: &Data) -> String {
    match cell {
        Data::Float(number) => number.to_string(),
        Data::Bool(is_true) => u8::from(*is_true).to_string(),
        Data::DateTime(moment) => stamp(moment),
        Data::DurationIso(duration) => micros(duration).map_or_else(|| duration.clone(), clock),
        other => other.to_string(),
    }
}

/// Microseconds of a second, and of a day.
const SECOND: i64 = 1_000_000;
const DAY: i64 = 86_400 * SECOND;

/// A moment as a time stamp. Times of day, and longer durations, have no date: their days are those of the first year.
/// The days of a date resolve about a microsecond, so that what is as near to ten of them is taken as these.
fn stamp(moment: &ExcelDateTime) -> String {
    let days = moment.as_f64();
    let all = (days * DAY as f64).round() as i64;
    if days < 366.0 || moment.is_duration() {
        return clock(all);
    }
    let kind = ExcelDateTimeType::DateTime;
    let is_1904 = *moment != ExcelDateTime::new(days, kind, false);
    let tens = (all + 5).div_euclid(10) * 10;
    let all = if (all - tens).abs() > 1 { all } else { tens };
    let (year, month, day, ..) = ExcelDateTime::new((all / DAY) as f64, kind, is_1904).to_ymd_hms_milli();
    format!("{year:04}-{month:02}-{day:02}T{}", clock(all % DAY))
}

/// A time in microseconds as hours, minutes and seconds.
fn clock(micros: i64) -> String {
    let sign = if micros < 0 { "-" } else { "" };
    let (seconds, rest) = (micros.abs() / SECOND, micros.abs() % SECOND);
    format!("{sign}{:02}:{:02}:{:02}.{rest:06}", seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// Microseconds of a duration by ISO 8601, `PT14H03M27.25S`, without days and longer parts.
fn micros(duration: &str) -> Option<i64> {
    let mut rest = duration.strip_prefix("PT")?;
    let mut seconds = 0.0;
    for (mark, factor) in [('H', 3600.0), ('M', 60.0), ('S', 1.0)] {
        if let Some((part, after)) = rest.split_once(mark) {
            seconds += factor * part.replace(',', ".").parse::<f64>().ok().filter(|part| *part >= 0.0)?;
            rest = after;
        }
    }
    (rest.is_empty() && seconds < 1e9).then(|| (seconds * SECOND as f64).round() as i64)
}

#[cfg(test)]
mod tests;
