//! A table under its headings.

use std::borrow::Cow;
use std::fs;
use std::path::Path;

use crate::error::{LARGEST, SheetError};
use crate::heading::{
    NO_UNIT, SEPARATORS, between_blanks, is_of_units, plain, separator_of, with_heading_in_comment, without_lines_above,
};
use crate::time_stamp::Stamp;
use crate::units::{QUANTITIES, Quantity, TIME};

/// Most rows of a binary file, and most cells, of which short channels leave some empty (chosen: those of such a text).
#[cfg(any(feature = "mdf", feature = "mat"))]
const MOST_ROWS: usize = 1 << 24;
#[cfg(any(feature = "mdf", feature = "mat"))]
const MOST_CELLS: usize = 1 << 27;

/// Heading of a column.
#[derive(Debug)]
struct Heading {
    /// Name; empty if hidden.
    name: String,
    /// Name in the file.
    own: String,
    /// Unit; empty for the SI unit.
    unit: String,
}

impl Heading {
    fn new(name: &str, unit: &str) -> Heading {
        Heading { name: name.trim().to_owned(), own: name.trim().to_owned(), unit: plain(unit) }
    }

    /// The name in the file, and what the column was taken as.
    fn shown(&self) -> String {
        let is_renamed = !self.name.is_empty() && self.name != self.own;
        if is_renamed { format!("{} ({})", self.own, self.name) } else { self.own.clone() }
    }

    fn is(&self, name: &str) -> bool {
        self.name.eq_ignore_ascii_case(name)
    }
}

/// A channel of a binary file: name, unit, values.
#[cfg(any(feature = "mdf", feature = "mat"))]
pub(crate) type Channel = (String, String, Vec<f64>);

/// A table under its headings, as text.
#[derive(Debug)]
pub struct Sheet {
    separator: char,
    headings: Vec<Heading>,
    /// Factors of columns, by their names.
    factors: Vec<(String, f64)>,
    /// Whether columns without a unit are known to be in SI units.
    is_si: bool,
    /// Note on how it was read.
    note: Option<String>,
    rows: Vec<csv::StringRecord>,
}

impl Sheet {
    /// Reads a file.
    pub fn load(path: &Path) -> Result<Sheet, SheetError> {
        let unreadable = |source| SheetError::Unreadable { path: path.into(), source };
        not_too_large(path)?;
        // Files of old programs are not UTF-8; the relevant parts are ASCII.
        Sheet::parse(&String::from_utf8_lossy(&fs::read(path).map_err(unreadable)?))
    }

    /// Reads a text.
    pub fn parse(text: &str) -> Result<Sheet, SheetError> {
        let text = with_one_comment(text.strip_prefix('\u{feff}').unwrap_or(text));
        let (text, note) = match with_heading_in_comment(&text).or_else(|| without_lines_above(&text)) {
            Some((text, note)) => (Cow::Owned(text), Some(note)),
            None => (text, None),
        };
        let heading = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or_default();
        let tabbed = with_tabs(&text, heading);
        let (text, separator) = match &tabbed {
            Some(tabbed) => (tabbed.as_str(), '\t'),
            None => (&*text, separator_of(heading).unwrap_or(',')),
        };
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(separator as u8)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let headings = reader.headers()?.clone();
        let records = reader.records().collect::<Result<Vec<csv::StringRecord>, csv::Error>>();
        let rows = records.map_err(|error| of_rows(error, separator))?;
        Ok(Sheet { note, ..Sheet::under(headings.iter(), rows, separator) })
    }

    /// Rows under a heading; the first of them may be a row of units.
    pub(crate) fn under<'a>(
        headings: impl Iterator<Item = &'a str>,
        mut rows: Vec<csv::StringRecord>,
        separator: char,
    ) -> Sheet {
        let mut headings: Vec<Heading> = headings.map(split).collect();
        if rows.first().is_some_and(is_of_units) {
            for (heading, text) in headings.iter_mut().zip(rows.remove(0).iter()) {
                let unit = plain(text.trim_matches(['[', ']', '(', ')']));
                if heading.unit.is_empty() && !NO_UNIT.contains(&unit.as_str()) {
                    heading.unit = unit;
                }
            }
        }
        Sheet { separator, headings, factors: Vec::new(), is_si: false, note: None, rows }
    }

    /// A table of arrays in SI units.
    pub fn of_columns(columns: &[(String, Vec<f64>)]) -> Result<Sheet, SheetError> {
        let columns: Vec<(&str, &[f64])> = columns.iter().map(|(name, values)| (name.as_str(), &values[..])).collect();
        Ok(Sheet { is_si: true, ..Sheet::parse(&text(&columns)?)? })
    }

    /// A table of channels.
    #[cfg(any(feature = "mdf", feature = "mat"))]
    pub(crate) fn of_channels(channels: Vec<Channel>) -> Result<Sheet, String> {
        let count = channels.iter().map(|(_, _, values)| values.len()).max().unwrap_or(0);
        if count > MOST_ROWS || count.saturating_mul(channels.len()) > MOST_CELLS {
            let columns = channels.len();
            return Err(format!(
                "{columns} channels of up to {count} values, must be at most {MOST_ROWS} values, and {MOST_CELLS} cells \
                 of a table: export fewer"
            ));
        }
        let cell = |values: &Vec<f64>, row: usize| values.get(row).map_or(String::new(), f64::to_string);
        let row = |row: usize| channels.iter().map(|(_, _, values)| cell(values, row)).collect();
        let rows = (0..count).map(row).collect();
        let unit = |unit: String| if NO_UNIT.contains(&unit.trim()) { String::new() } else { unit };
        let headings = channels.into_iter().map(|(name, of, _)| Heading::new(&name, &unit(of))).collect();
        Ok(Sheet { headings, ..Sheet::under([].into_iter(), rows, ',') })
    }

    /// Whether it has a column.
    pub fn has(&self, name: &str) -> bool {
        self.headings.iter().any(|heading| heading.is(name))
    }

    /// Renames a column, if it exists; a column that had the new name is hidden.
    pub fn rename(&mut self, from: &str, to: &str) {
        let is_here = self.has(from);
        for heading in &mut self.headings {
            if heading.is(from) {
                to.clone_into(&mut heading.name);
            } else if is_here && heading.is(to) {
                heading.name.clear();
            }
        }
    }

    /// Unit of a column in the file, empty if it has none; None if the column does not exist.
    pub fn unit(&self, name: &str) -> Option<&str> {
        self.headings.iter().find(|heading| heading.is(name)).map(|heading| heading.unit.as_str())
    }

    /// Name of a column in the file, whatever it was renamed.
    pub fn own_name<'a>(&'a self, name: &'a str) -> &'a str {
        self.headings.iter().find(|heading| heading.is(name)).map_or(name, |heading| heading.own.as_str())
    }

    #[cfg(any(feature = "mat", feature = "spreadsheet"))]
    pub(crate) fn with(self, note: Option<String>) -> Sheet {
        Sheet { note, ..self }
    }

    /// Note on how it was read.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// Whether a column has no unit and is assumed to be SI.
    pub fn assumes_unit(&self, name: &str) -> bool {
        let has_stamps = |at| name.eq_ignore_ascii_case(TIME.name) && self.first_stamp(at).is_some();
        let is_plain = |at: usize| self.headings[at].unit.is_empty() && !has_stamps(at);
        !self.is_si && (0..self.headings.len()).find(|at| self.headings[*at].is(name)).is_some_and(is_plain)
    }

    /// Names of its columns.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.headings.iter().map(|heading| heading.name.as_str())
    }

    /// Multiplies the column of a quantity, if it is there, by a factor: its SI values, or its numbers if they have the
    /// unit of a signal, such as volts, or of one of some quantities.
    pub fn scale(&mut self, quantity: &Quantity, signals: &[&Quantity], factor: f64) {
        for Heading { name, unit, .. } in &mut self.headings {
            let has = |known: &Quantity| known.units.iter().any(|known| known.0 == unit);
            let is_signal = !QUANTITIES.iter().any(|known| has(known)) || signals.iter().any(|known| has(known));
            if name.eq_ignore_ascii_case(quantity.name) && is_signal && !has(quantity) {
                unit.clear();
            }
        }
        self.factors.push((quantity.name.to_owned(), factor));
    }

    /// Makes another quantity of a column: its values in SI units of its own quantity, times a factor, in a new unit.
    pub fn convert(&mut self, name: &str, own: &Quantity, factor: f64, unit: &str) -> Result<(), SheetError> {
        let Some(heading) = self.headings.iter_mut().find(|heading| heading.is(name)) else { return Ok(()) };
        let known = own.units.iter().find(|known| heading.unit.is_empty() || known.0 == heading.unit);
        let Some((_, of_unit, _)) = known else {
            let wanted = own.units.iter().map(|known| known.0).collect::<Vec<_>>().join(", ");
            return Err(SheetError::Unit { column: heading.own.clone(), unit: heading.unit.clone(), wanted });
        };
        unit.clone_into(&mut heading.unit);
        self.factors.push((name.to_owned(), of_unit * factor));
        Ok(())
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Line of a row in the file, from 1; in a binary file the number of the sample.
    pub fn line(&self, row: usize) -> u64 {
        let position = self.rows.get(row).and_then(csv::StringRecord::position);
        position.map_or(row as u64 + 1, csv::Position::line)
    }

    /// Values of the column of a quantity in SI units, if there is one.
    pub fn column(&self, quantity: &Quantity) -> Result<Option<Vec<f64>>, SheetError> {
        self.column_named(quantity.name, quantity)
    }

    /// As [`Sheet::column`], for a column with another name.
    pub fn column_named(&self, name: &str, quantity: &Quantity) -> Result<Option<Vec<f64>>, SheetError> {
        self.column_in(name, quantity.units, quantity.name == TIME.name)
    }

    /// Numbers of a column as they stand in the file, in its unit.
    pub fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, SheetError> {
        let Some(at) = (0..self.headings.len()).find(|at| self.headings[*at].is(name)) else { return Ok(None) };
        (0..self.rows.len()).map(|row| self.number(row, at)).collect::<Result<Vec<f64>, SheetError>>().map(Some)
    }

    /// Keeps some of the rows, which keep their lines.
    pub fn keep(&mut self, is_kept: &[bool]) {
        let lines: Vec<u64> = (0..self.rows.len()).map(|row| self.line(row)).collect();
        for (row, line) in self.rows.iter_mut().zip(lines) {
            let mut position = csv::Position::new();
            position.set_line(line);
            row.set_position(Some(position));
        }
        let mut kept = is_kept.iter();
        self.rows.retain(|_| kept.next().is_none_or(|kept| *kept));
    }

    /// Values of a column that must be there, in an SI unit.
    pub fn values(&self, name: &str, unit: &str) -> Result<Vec<f64>, SheetError> {
        let own = [(unit, 1.0, 0.0)];
        let units = QUANTITIES.iter().find(|known| known.units[0].0 == unit).map_or(&own[..], |known| known.units);
        self.column_in(name, units, false)?.ok_or_else(|| self.missing(name))
    }

    /// Values of a column that has one of these units, or the first one if it has none.
    fn column_in(
        &self,
        name: &str,
        units: &[(&str, f64, f64)],
        may_be_stamps: bool,
    ) -> Result<Option<Vec<f64>>, SheetError> {
        let mut columns = (0..self.headings.len()).filter(|at| self.headings[*at].is(name));
        let Some(at) = columns.next() else { return Ok(None) };
        if columns.next().is_some() {
            return Err(SheetError::Twice(name.to_owned()));
        }
        if let Some(first) = self.first_stamp(at).filter(|_| may_be_stamps) {
            return self.stamped(at, first).map(Some);
        }
        let unit = &self.headings[at].unit;
        let known = units.iter().find(|known| unit.is_empty() || known.0 == unit);
        let Some((_, factor, offset)) = known else {
            let wanted: Vec<&str> = units.iter().map(|known| known.0).collect();
            let [column, unit] = [name, unit].map(str::to_owned);
            return Err(SheetError::Unit { column, unit, wanted: wanted.join(", ") });
        };
        let scales = self.factors.iter().filter(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, scale)| scale);
        let scale: f64 = scales.product();
        let values = (0..self.rows.len()).map(|row| Ok(scale * (factor * (self.number(row, at)? + offset))));
        values.collect::<Result<Vec<f64>, SheetError>>().map(Some)
    }

    /// As [`Sheet::column_named`], for a column that must be there.
    pub fn required(&self, name: &str, quantity: &Quantity) -> Result<Vec<f64>, SheetError> {
        self.column_named(name, quantity)?.ok_or_else(|| self.missing(name))
    }

    /// The error for a column that is not there.
    pub fn missing(&self, name: &str) -> SheetError {
        let mut names: Vec<String> = self.headings.iter().map(Heading::shown).collect();
        names.retain(|name| !name.is_empty());
        let found = if names.is_empty() { "no columns".to_owned() } else { names.join(", ") };
        let hint = self.headings.iter().find_map(|heading| unit_in_name(&heading.own, name));
        let hint = hint.or_else(|| self.note.as_ref().map(|note| format!("; {note}"))).unwrap_or_default();
        SheetError::Column { wanted: name.to_owned(), found, hint }
    }

    /// The time stamp with which a column begins, if it has time stamps.
    fn first_stamp(&self, at: usize) -> Option<Stamp> {
        self.rows.first().and_then(|row| Stamp::parse(row.get(at)?))
    }

    /// Times of a column of time stamps, in s since midnight of the first one.
    fn stamped(&self, at: usize, first: Stamp) -> Result<Vec<f64>, SheetError> {
        let second = |row: usize| {
            let stamp = Stamp::parse(self.text(row, at)).and_then(|stamp| stamp.since_midnight_of(first));
            stamp.ok_or_else(|| self.no_number(row, at, "a time stamp like the first one"))
        };
        (0..self.rows.len()).map(second).collect()
    }

    fn text(&self, row: usize, at: usize) -> &str {
        self.rows[row].get(at).unwrap_or_default()
    }

    fn number(&self, row: usize, at: usize) -> Result<f64, SheetError> {
        let text = self.text(row, at);
        let number = if self.separator == ',' { text.parse() } else { text.replace(',', ".").parse::<f64>() };
        number.ok().filter(|number| number.is_finite()).ok_or_else(|| self.no_number(row, at, "a finite number"))
    }

    fn no_number(&self, row: usize, at: usize, wanted: &'static str) -> SheetError {
        let (column, text) = (self.headings[at].name.clone(), self.text(row, at).to_owned());
        SheetError::Number { line: self.line(row), column, text, wanted }
    }
}

/// The error for a row that cannot be read.
fn of_rows(error: csv::Error, separator: char) -> SheetError {
    let csv::ErrorKind::UnequalLengths { pos: Some(ref place), expected_len: headings, len: cells } = *error.kind()
    else {
        return error.into();
    };
    let hint = if separator == ',' && cells > headings {
        "; if its numbers have decimal commas, columns are separated by semicolons, tabs or blanks"
    } else {
        ""
    };
    let line = place.line();
    SheetError::Row { line, cells, headings, hint }
}

pub(crate) fn not_too_large(path: &Path) -> Result<(), SheetError> {
    let unreadable = |source| SheetError::Unreadable { path: path.into(), source };
    let bytes = fs::metadata(path).map_err(unreadable)?.len();
    if bytes > LARGEST { Err(SheetError::TooLarge { path: path.into(), bytes }) } else { Ok(()) }
}

/// Refuses names of columns for what is none of some quantities, and two columns for one of them: pairs of a quantity and
/// of the column that has it.
pub fn check_names(names: &[(String, String)], known: &[&Quantity]) -> Result<(), SheetError> {
    for (at, (name, column)) in names.iter().enumerate() {
        if !known.iter().any(|quantity| quantity.name == name) {
            let wanted: Vec<&str> = known.iter().map(|quantity| quantity.name).collect();
            return Err(SheetError::Quantity { name: name.clone(), wanted: wanted.join(", ") });
        }
        if let Some((_, other)) = names[..at].iter().find(|(before, other)| before == name && other != column) {
            return Err(SheetError::NamedTwice { name: name.clone(), column: column.clone(), other: other.clone() });
        }
    }
    Ok(())
}

/// Columns under their headings as a table of values separated by commas. A number in its shortest form is read back
/// with the same bits; a column that is too short ends with empty cells.
pub fn text(columns: &[(&str, &[f64])]) -> csv::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(|(name, _)| name))?;
    let count = columns.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    for row in 0..count {
        writer.write_record(columns.iter().map(|(_, values)| values.get(row).map_or(String::new(), f64::to_string)))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Name and unit of a heading `name`, `name [unit]` or `name (unit)`.
fn split(heading: &str) -> Heading {
    let (name, unit) = heading.split_once(['[', '(']).unwrap_or((heading, ""));
    Heading::new(name, unit.trim_end_matches([']', ')']))
}

/// A hint for a heading such as `time_ms` that looks like the wanted column.
fn unit_in_name(heading: &str, wanted: &str) -> Option<String> {
    let (name, unit) = heading.rsplit_once(['_', ' ', '-', '.'])?;
    let is_unit = QUANTITIES.iter().any(|quantity| quantity.units.iter().any(|known| known.0 == unit));
    (is_unit && name.eq_ignore_ascii_case(wanted))
        .then(|| format!("; units stand in brackets: '{wanted} [{unit}]' instead of '{heading}'"))
}

/// A text whose comments all begin with `#`. A `%` before a separator is the unit of the first column.
fn with_one_comment(text: &str) -> Cow<'_, str> {
    let is_comment = |line: &str| line.strip_prefix('%').is_some_and(|rest| !rest.trim_start().starts_with(SEPARATORS));
    if !text.lines().any(is_comment) {
        return Cow::Borrowed(text);
    }
    let line = |line: &str| if is_comment(line) { format!("#{line}") } else { line.to_owned() };
    Cow::Owned(text.split('\n').map(line).collect::<Vec<String>>().join("\n"))
}

/// A table whose columns are separated by blanks, with tabs instead; None for other tables.
fn with_tabs(text: &str, heading: &str) -> Option<String> {
    let columns = between_blanks(heading);
    if heading.contains(SEPARATORS) || columns.len() < 2 {
        return None;
    }
    let row = |line: &str| {
        let is_heading = std::ptr::eq(line, heading);
        let cells =
            if is_heading { columns.join("\t") } else { line.split_whitespace().collect::<Vec<_>>().join("\t") };
        cells + "\n"
    };
    Some(text.lines().map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{ANGLE, DISPLACEMENT, FORCE, MOMENT, PRESSURE, SLIP, VELOCITY};

    #[test]
    fn units_may_be_in_a_row_of_their_own() {
        let sheet = Sheet::parse("time;force;note;displacement\n[ms];N;-;(mm)\n1,5;2;3;4\n").unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1.5e-3]));
        assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![4e-3]));
        assert_eq!([sheet.line(0), sheet.len() as u64], [3, 1]);
        assert_eq!(sheet.column(&VELOCITY).unwrap(), None);
    }

    /// Units of columns that nobody reads may be any; what is read must have one that is known.
    #[test]
    fn a_row_of_units_may_have_any_for_other_columns() {
        let sheet = Sheet::parse("ET,V,N,P,FZ,MZ,SR,TSTC\nsec,kph,rpm,psi,lb,ft-lb,none,deg C\n1,36,7,10,1,1,0.5,20\n");
        let sheet = sheet.unwrap();
        let read = |name: &str, quantity: &Quantity| sheet.column_named(name, quantity).unwrap().unwrap()[0];
        let close = |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-6, "{value} {expected}");
        close(read("V", &VELOCITY), 10.0);
        close(read("P", &PRESSURE), 68_947.57);
        close(read("FZ", &FORCE), 4.448_222);
        close(read("MZ", &MOMENT), 1.355_818);
        assert_eq!([read("ET", &TIME), read("SR", &SLIP)], [1.0, 0.5]);
        let text = sheet.column_named("N", &VELOCITY).unwrap_err().to_string();
        assert!(text.starts_with("N: unit 'rpm', must be one of m/s, "), "{text}");
        assert_eq!(Sheet::parse("time,note\ns,first\n1,a\n").unwrap().len(), 1);
        assert_eq!(Sheet::parse("slip,note\n1,first\n1,a\n").unwrap().len(), 2);
    }

    /// In UTF-8, as a Greek letter, and in Latin-1.
    #[test]
    fn micro_is_not_left_out() {
        for sign in ["\u{b5}", "\u{3bc}", "\u{fffd}", "u"] {
            let sheet = Sheet::parse(&format!("time [{sign}s],displacement\n,{sign}m\n3,4\n")).unwrap();
            let heading = Sheet::parse(&format!("time [{sign}s],displacement [{sign}m]\n3,4\n")).unwrap();
            assert_eq!(heading.column(&TIME).unwrap(), Some(vec![3e-6]), "{sign}");
            assert_eq!(heading.column(&DISPLACEMENT).unwrap(), Some(vec![4e-6]), "{sign}");
            assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![3e-6]), "{sign}");
        }
        assert_eq!(
            ["\u{b0}", "\u{fffd}", "\u{b0}C", "\u{fffd}C", "N\u{b7}m"].map(plain),
            ["deg", "deg", "C", "C", "N.m"]
        );
        assert_eq!(plain("\u{b0}m"), "\u{b0}m");
        let other = Sheet::parse("displacement [\u{e4}m]\n1\n").unwrap();
        assert!(other.column(&DISPLACEMENT).unwrap_err().to_string().contains("unit '\u{e4}m'"));
    }

    #[test]
    fn columns_keep_their_bits() {
        let values = vec![0.1 + 0.2, -1e-300, f64::MAX];
        let sheet = Sheet::of_columns(&[("time".into(), values.clone()), ("force".into(), vec![1.0])]).unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(values.clone()));
        assert_eq!(sheet.column(&FORCE).unwrap_err().to_string(), "line 3, force: '' is not a finite number");
        let sheet =
            Sheet::of_columns(&[("time".into(), values.clone()), ("left, upper \"A\"".into(), values)]).unwrap();
        assert_eq!(sheet.len(), 3);
    }

    #[test]
    fn blanks_separate_columns_if_nothing_else_does() {
        let sheet =
            Sheet::parse("# a rig\n\n time  [ms] force (kN)  displacement\n  1,5   2  -3e-1 \n1 2 x\n").unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1.5e-3, 1e-3]));
        assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![2e3, 2e3]));
        let text = sheet.column(&DISPLACEMENT).unwrap_err().to_string();
        assert_eq!(text, "line 5, displacement: 'x' is not a finite number");
        let sheet = Sheet::parse("time force\nms N\n1 2\n").unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3]));
    }

    #[test]
    fn refusals_say_what_the_file_says() {
        let mut sheet = Sheet::parse("Pos [mm];Millis [ms];x\n1;2;3\n").unwrap();
        sheet.rename("Pos", "x");
        assert_eq!(sheet.missing("time").to_string(), "no column 'time'; there are Pos (x), Millis, x");
        let sheet = Sheet::parse("time_ms,Force N\n1,2\n").unwrap();
        let [time, force] = ["time", "force"].map(|name| sheet.missing(name).to_string());
        assert!(
            time.ends_with("time_ms, Force N; units stand in brackets: 'time [ms]' instead of 'time_ms'"),
            "{time}"
        );
        assert!(force.ends_with("'force [N]' instead of 'Force N'"), "{force}");
        let rows = |text: &str| Sheet::parse(text).unwrap_err().to_string();
        assert_eq!(
            rows("time,force\n0,1,2\n"),
            "no table: line 2, columns: 3, must be 2 as in the heading; if its numbers have decimal commas, columns are separated by \
             semicolons, tabs or blanks"
        );
        assert_eq!(rows("time;force\n1;2\n1\n"), "no table: line 3, columns: 1, must be 2 as in the heading");
    }

    #[test]
    fn a_second_heading_is_not_a_row_of_units() {
        let sheet = Sheet::parse("time,force\ntime,force\n1,2\n").unwrap();
        let text = sheet.column(&TIME).unwrap_err().to_string();
        assert_eq!(text, "line 2, time: 'time' is not a finite number");
    }

    #[test]
    fn headings_of_programs_are_understood() {
        let wanted = [Some(vec![1e-3, 2e-3]), Some(vec![1500.0, -200.0])];
        for text in [
            "\u{feff}% a rig; run 3\n\"time (ms)\",\"force [kN]\",\"note; remark\"\n1,1.5,a\n% paused\n2,-0.2,b\n",
            "time;force\n(ms);[kN]\n1,0;1,5\n#\n2,0;-0,2\n",
            "slip,time,force\r\n%,ms,kN\r\n3,1,1.5\r\n3,2,-0.2\r\n",
        ] {
            let sheet = Sheet::parse(text).unwrap();
            assert_eq!([&TIME, &FORCE].map(|quantity| sheet.column(quantity).unwrap()), wanted, "{text}");
        }
        let percent = Sheet::parse("slip,force\n%,N\n3,1\n").unwrap();
        assert_eq!(percent.column(&SLIP).unwrap(), Some(vec![0.03]));
        let late = Sheet::parse("% one\n% two\ntime,force\n1,x\n").unwrap();
        assert_eq!(late.column(&FORCE).unwrap_err().to_string(), "line 4, force: 'x' is not a finite number");
    }

    #[test]
    fn time_stamps_are_times_in_seconds() {
        let times = |rows: &str| Sheet::parse(&format!("time;force\n{rows}")).unwrap().column(&TIME);
        assert_eq!(times("00:01:00.25;1\n00:01:01,5;2\n").unwrap(), Some(vec![60.25, 61.5]));
        let dated = times("2024-02-29T23:59:59.5Z;1\n2024-03-01T00:00:00.25Z;2\n").unwrap();
        assert_eq!(dated, Some(vec![86_399.5, 86_400.25]));
        let refusal = times("00:01:00;1\n2024-03-01T00:00:00;2\n").unwrap_err().to_string();
        assert_eq!(refusal, "line 3, time: '2024-03-01T00:00:00' is not a time stamp like the first one");
        let sheet = Sheet::parse("time,force\n00:01:00,00:01:00\n").unwrap();
        assert!(sheet.column(&FORCE).is_err() && !sheet.assumes_unit("time") && sheet.assumes_unit("force"));
    }

    #[test]
    fn units_of_turned_bodies_are_known() {
        let sheet = Sheet::parse("angle [rev],moment [N mm],force\n0.5,7,1\n").unwrap();
        assert_eq!(sheet.column(&ANGLE).unwrap(), Some(vec![std::f64::consts::PI]));
        assert_eq!(sheet.column(&MOMENT).unwrap(), Some(vec![7e-3]));
        assert_eq!(["\u{b0}/s", "\u{fffd}/s"].map(plain), ["deg/s"; 2]);
    }

    fn read(text: &str) -> (Vec<f64>, Vec<f64>, Option<String>) {
        let sheet = Sheet::parse(text).unwrap();
        let column = |quantity| sheet.column(quantity).unwrap().unwrap();
        (column(&TIME), column(&FORCE), sheet.note().map(str::to_owned))
    }

    /// As a testing machine, a servo drive and a tribometer write them: marks, notes with numbers, units below or in
    /// the heading, an empty last column.
    #[test]
    fn lines_above_a_heading_are_not_read() {
        for (text, line) in [
            ("RIG7|MPT|1|2|.|/|:\n\nAcquisition\t\tTime:\t1.5\tSec\nforce\tnote\ttime\nkN\tx\tms\n2\t3\t4\n", 4),
            ("Axis1\nNumber of data,1\nInterval(ms),0.5\ntime,force,x,\nms,kN,not selected,\n\n4,2,0,\n", 4),
            ("Run date 12 May 2022 12:21:50\nSet force = -200\ntime (ms);force [kN]\n4,0;2,0\n", 3),
            ("Tested on a rig of ours\nStep 3 of 4\ntime [ms] force [kN]\n4 2\n", 3),
        ] {
            let note = format!("the table begins with the heading in line {line}; what is above it is not read");
            assert_eq!(read(text), (vec![0.004], vec![2000.0], Some(note)), "{text}");
        }
        let twice = "RIG\n\nRun 1\nforce\ttime\nkN\tSec\n2\t1\n\nRun 2\nforce\ttime\nkN\tSec\n3\t2\n4\t3\n";
        let (time, force, note) = read(twice);
        assert_eq!((time, force), (vec![1.0, 2.0, 3.0], vec![2000.0, 3000.0, 4000.0]));
        assert!(note.unwrap().ends_with("; it goes on below another heading like it (1)"));
        let spoilt = Sheet::parse(&twice.replace("4\t3", "4\tx")).unwrap().column(&TIME).unwrap_err();
        assert_eq!(spoilt.to_string(), "line 12, time: 'x' is not a finite number");
        let spoilt = Sheet::parse("A rig\n\ntime,force\n1,2\n2,x\n").unwrap().column(&FORCE).unwrap_err();
        assert_eq!(spoilt.to_string(), "line 5, force: 'x' is not a finite number");
    }

    /// As NumPy, MATLAB and the recorder of ROS write them; with a row of units, and below other comments.
    #[test]
    fn a_comment_right_above_the_numbers_is_the_heading() {
        for (text, line) in [
            ("# time [ms] force [kN]\n4 2\n5 3\n", 1),
            ("%time,force,field.seq\n0.004,2000,1\n", 1),
            ("% measured on Tuesday\n% of all rigs\n#\n# time;force\n# ms;kN\n4,0;2,0\n", 4),
            ("#time\tforce\n#ms\tkN\n4\t2\n", 1),
        ] {
            let (time, force, note) = read(text);
            assert_eq!((time[0], force[0]), (0.004, 2000.0), "{text}");
            assert_eq!(note.unwrap(), format!("the comment in line {line} is the heading"), "{text}");
        }
        for text in ["# of rig two\ntime,force\n1,2\n", "# time,force\n\ntime,force\n1,2\n", "time,force\n# x,y\n1,2\n"]
        {
            assert_eq!(read(text), (vec![1.0], vec![2.0], None), "{text}");
        }
        let spoilt = Sheet::parse("# time,force\n1,2\n2,x\n").unwrap().column(&FORCE).unwrap_err();
        assert_eq!(spoilt.to_string(), "line 3, force: 'x' is not a finite number");
        // No words for each column: nothing is guessed.
        assert!(!Sheet::parse("# time and force\n1,2\n").unwrap().has(TIME.name));
    }

    #[test]
    fn a_table_that_begins_with_its_heading_is_as_it_was() {
        for text in ["time,force,note\n4,2,a\n", "\"time, of all\",force,x\n1,2,3\n1,2,3\n", "time,force\nms,kN\n1,2\n"]
        {
            assert_eq!(Sheet::parse(text).unwrap().note(), None, "{text}");
        }
        let twice = Sheet::parse("time,force\nTime,Force\n1,2\n").unwrap();
        assert_eq!(twice.column(&TIME).unwrap_err().to_string(), "line 2, time: 'Time' is not a finite number");
        let no_heading = Sheet::parse("rig\n1,2\n").unwrap_err().to_string();
        assert!(no_heading.starts_with("no table: line 2, columns: 2, must be 1 as in the heading"), "{no_heading}");
        assert!(!Sheet::parse("a rig\nof ours\n").unwrap().has(DISPLACEMENT.name));
    }
}
