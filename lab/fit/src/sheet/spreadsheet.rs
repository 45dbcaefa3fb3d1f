//! Tables of spreadsheets.

use std::io::Cursor;
use std::path::Path;

use calamine::{Data, Ods, Range, Reader, Xlsx};

use super::guard::{refused, silently};
use super::{Sheet, SheetError, is_of_units};

/// A row of a sheet: its number, from 1, and its cells as text.
type Row = (u64, Vec<String>);

/// The first sheet of a file that has a table: a heading over numbers, perhaps with a row of units between them.
pub(super) fn read(path: &Path, extension: &str) -> Result<Vec<Sheet>, SheetError> {
    super::not_too_large(path)?;
    let bytes = Cursor::new(std::fs::read(path).map_err(|error| refused(path, error))?);
    let found = match extension {
        "ods" => silently(|| Ods::new(bytes).map_err(|error| error.to_string()).and_then(first_table)),
        _ => silently(|| Xlsx::new(bytes).map_err(|error| error.to_string()).and_then(first_table)),
    };
    found
        .unwrap_or_else(|| Err("the file is damaged".to_owned()))
        .map(|sheet| vec![sheet])
        .map_err(|why| refused(path, why))
}

fn first_table<R: Reader<Cursor<Vec<u8>>>>(mut book: R) -> Result<Sheet, String> {
    let names = book.sheet_names();
    for name in &names {
        let range = book.worksheet_range(name).map_err(|error| format!("sheet '{name}': {error:?}"))?;
        if let Some(sheet) = of_range(&range) {
            let note = format!("the table was read from sheet '{name}', the first of {} that has one", names.len());
            return Ok(Sheet { note: Some(note).filter(|_| names.len() > 1), ..sheet });
        }
    }
    Err(format!("no sheet has a heading over numbers; there are '{}'", names.join("', '")))
}

fn of_range(range: &Range<Data>) -> Option<Sheet> {
    let first = u64::from(range.start()?.0) + 1;
    let filled = (first..).zip(range.rows()).filter(|(_, cells)| cells.iter().any(|cell| !matches!(cell, Data::Empty)));
    let rows: Vec<(u64, &[Data])> = filled.collect();
    let at = (1..rows.len()).find(|at| is_heading(rows[at - 1].1, rows[*at].1))?;
    let heading = rows[at - 1].1;
    let columns: Vec<usize> = (0..heading.len()).filter(|at| !matches!(heading[*at], Data::Empty)).collect();
    let row = |(number, cells): &(u64, &[Data])| (*number, columns.iter().map(|at| text(&cells[*at])).collect());
    let headings: Vec<String> = columns.iter().map(|at| text(&heading[*at])).collect();
    Some(Sheet::under(headings.iter().map(String::as_str), rows[at..].iter().map(row).map(record).collect(), ';'))
}

/// Whether a row of texts is the heading of the row below it: of numbers, or of units.
fn is_heading(row: &[Data], below: &[Data]) -> bool {
    let is_text = |cell: &Data| matches!(cell, Data::String(_));
    let texts = row.iter().filter(|cell| is_text(cell)).count();
    let is_number = |cell: &Data| !matches!(cell, Data::Empty | Data::String(_) | Data::Error(_));
    let is_over_numbers = || below.iter().any(is_number);
    let is_over_units = || is_of_units(&record((1, below.iter().map(text).collect())));
    texts > 1
        && row.iter().all(|cell| is_text(cell) || matches!(cell, Data::Empty))
        && (is_over_numbers() || is_over_units())
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
        Data::DateTime(moment) => {
            let (year, month, day, hour, minute, second, milli) = moment.to_ymd_hms_milli();
            let time = format!("{hour:02}:{minute:02}:{second:02}.{milli:03}");
            // Times of day are on the day before the first.
            if moment.as_f64() < 1.0 { time } else { format!("{year:04}-{month:02}-{day:02}T{time}") }
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use crate::sheet::{DISPLACEMENT, FORCE, TIME, table};

    const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006";

    fn relationships(all: &[(&str, String)]) -> String {
        let one = |(number, (kind, target)): (usize, &(&str, String))| {
            format!("<Relationship Id='r{number}' Type='{OFFICE}/{kind}' Target='{target}'/>")
        };
        let all: String = (1..).zip(all).map(one).collect();
        format!("<Relationships xmlns='{PACKAGE}/relationships'>{all}</Relationships>")
    }

    fn worksheet(text: &str) -> String {
        let row = |(number, line)| format!("<row r='{number}'>{}</row>", cells(number, line));
        let rows: String = (1..).zip(text.lines()).map(row).collect();
        format!("<worksheet xmlns='{MAIN}'><sheetData>{rows}</sheetData></worksheet>")
    }

    /// A workbook with sheets of these names and rows of cells: numbers as such, anything else as text, none if empty.
    fn workbook(sheets: &[(&str, &str)]) -> tempfile::NamedTempFile {
        let file = tempfile::NamedTempFile::with_suffix(".xlsx").unwrap();
        let mut zip = zip::ZipWriter::new(file.reopen().unwrap());
        let mut add = |name: &str, text: &str| {
            zip.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
            zip.write_all(text.as_bytes()).unwrap();
        };
        let target = |number: usize| format!("worksheets/s{number}.xml");
        let one = |(number, (name, _)): (usize, &(&str, &str))| {
            format!("<sheet name='{name}' sheetId='{number}' r:id='r{number}'/>")
        };
        let listed: String = (1..).zip(sheets).map(one).collect();
        let book = format!("<workbook xmlns='{MAIN}' xmlns:r='{OFFICE}'><sheets>{listed}</sheets></workbook>");
        let targets: Vec<_> = (1..=sheets.len()).map(|number| ("worksheet", target(number))).collect();
        add("[Content_Types].xml", &format!("<Types xmlns='{PACKAGE}/content-types'/>"));
        add("_rels/.rels", &relationships(&[("officeDocument", "xl/workbook.xml".to_owned())]));
        add("xl/workbook.xml", &book);
        add("xl/_rels/workbook.xml.rels", &relationships(&targets));
        (1..).zip(sheets).for_each(|(number, (_, text))| add(&format!("xl/{}", target(number)), &worksheet(text)));
        zip.finish().unwrap();
        file
    }

    fn cells(row: usize, line: &str) -> String {
        let cell = |(letter, text): (char, &str)| match text.parse::<f64>() {
            _ if text.is_empty() => String::new(),
            Ok(_) => format!("<c r='{letter}{row}'><v>{text}</v></c>"),
            Err(_) => format!("<c r='{letter}{row}' t='inlineStr'><is><t>{text}</t></is></c>"),
        };
        ('A'..).zip(line.split('|')).map(cell).collect()
    }

    #[test]
    fn the_first_sheet_with_a_table_is_read() {
        let notes = "Rig|A12\nOperator|someone\nRemarks|none of them a number";
        let data = "Run of the rig\n\n|time|force [kN]|note|displacement\n|ms|||mm\n|1|0.25|first|-3\n\n|2|1e-3||4";
        let file = workbook(&[("notes", notes), ("data", data), ("later", "a|b\n1|2")]);
        let sheet = table(file.path()).unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
        assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![250.0, 1.0]));
        assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![-3e-3, 4e-3]));
        assert_eq!(sheet.note(), Some("the table was read from sheet 'data', the first of 3 that has one"));
    }

    #[test]
    fn errors_name_the_row_of_the_sheet() {
        let file = workbook(&[("data", "A record\n\ntime|force\n0|1\n\n1|broken")]);
        let sheet = table(file.path()).unwrap();
        assert_eq!(sheet.note(), None, "there is but one");
        assert_eq!(sheet.column(&FORCE).unwrap_err().to_string(), "line 6, force: 'broken' is not a finite number");
        let none = table(workbook(&[("notes", "Rig|A12"), ("empty", "")]).path()).unwrap_err().to_string();
        assert!(none.ends_with("no sheet has a heading over numbers; there are 'notes', 'empty'"), "{none}");
        std::fs::write(file.path(), "not a workbook").unwrap();
        assert!(table(file.path()).is_err());
    }
}
