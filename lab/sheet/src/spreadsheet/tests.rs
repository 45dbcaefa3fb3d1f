//! Spreadsheets made part by part.

use std::io::Write;
use std::path::Path;

use crate::{DISPLACEMENT, FORCE, Sheet, TIME};

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

/// Cells of a row: numbers as such, days as a date after `@` and as a duration after `+`, a formula with its value
/// after `=`, anything else as text, also what follows an apostrophe; none if empty.
fn cells(row: usize, line: &str) -> String {
    let cell = |(letter, text): (char, &str)| {
        let at = format!("r='{letter}{row}'");
        match text.split_at(text.len().min(1)) {
            ("", _) => String::new(),
            ("@", days) => format!("<c {at} s='1'><v>{days}</v></c>"),
            ("+", days) => format!("<c {at} s='2'><v>{days}</v></c>"),
            ("=", value) => format!("<c {at}><f>A1*2</f><v>{value}</v></c>"),
            ("'", text) => format!("<c {at} t='inlineStr'><is><t>{text}</t></is></c>"),
            _ if text.parse::<f64>().is_ok() => format!("<c {at}><v>{text}</v></c>"),
            _ => format!("<c {at} t='inlineStr'><is><t>{text}</t></is></c>"),
        }
    };
    ('A'..).zip(line.split('|')).map(cell).collect()
}

/// A file with these parts.
fn zipped(ending: &str, parts: &[(String, String)]) -> tempfile::NamedTempFile {
    let file = tempfile::NamedTempFile::with_suffix(ending).unwrap();
    let mut zip = zip::ZipWriter::new(file.reopen().unwrap());
    for (name, text) in parts {
        zip.start_file(name.as_str(), zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap();
    file
}

/// A workbook with sheets of these names and rows of cells; those whose names begin with `~` are hidden.
fn workbook_of(first_year: &str, sheets: &[(&str, &str)]) -> tempfile::NamedTempFile {
    let target = |number: usize| format!("worksheets/s{number}.xml");
    let one = |(number, (name, _)): (usize, &(&str, &str))| {
        let state = if name.starts_with('~') { "hidden" } else { "visible" };
        format!("<sheet name='{name}' sheetId='{number}' r:id='r{number}' state='{state}'/>")
    };
    let listed: String = (1..).zip(sheets).map(one).collect();
    let is_1904 = u8::from(first_year == "1904");
    let properties = format!("<workbookPr date1904='{is_1904}'/>");
    let book = format!("<workbook xmlns='{MAIN}' xmlns:r='{OFFICE}'>{properties}<sheets>{listed}</sheets></workbook>");
    let styles = format!(
        "<styleSheet xmlns='{MAIN}'><numFmts><numFmt numFmtId='170' formatCode='yyyy-mm-dd hh:mm:ss.000'/>\
         <numFmt numFmtId='171' formatCode='[h]:mm:ss.000'/></numFmts>\
         <cellXfs><xf numFmtId='0'/><xf numFmtId='170'/><xf numFmtId='171'/></cellXfs></styleSheet>"
    );
    let mut targets: Vec<_> = (1..=sheets.len()).map(|number| ("worksheet", target(number))).collect();
    targets.push(("styles", "styles.xml".to_owned()));
    let mut parts = vec![
        ("[Content_Types].xml".to_owned(), format!("<Types xmlns='{PACKAGE}/content-types'/>")),
        ("_rels/.rels".to_owned(), relationships(&[("officeDocument", "xl/workbook.xml".to_owned())])),
        ("xl/workbook.xml".to_owned(), book),
        ("xl/styles.xml".to_owned(), styles),
        ("xl/_rels/workbook.xml.rels".to_owned(), relationships(&targets)),
    ];
    parts.extend((1..).zip(sheets).map(|(number, (_, text))| (format!("xl/{}", target(number)), worksheet(text))));
    zipped(".xlsx", &parts)
}

fn workbook(sheets: &[(&str, &str)]) -> tempfile::NamedTempFile {
    workbook_of("1900", sheets)
}

fn table(path: &Path) -> Result<Sheet, String> {
    let name = format!("{}: ", path.display());
    crate::table(path, None).map_err(|error| error.to_string().replace(&name, ""))
}

fn times(file: &tempfile::NamedTempFile) -> Vec<f64> {
    table(file.path()).unwrap().column(&TIME).unwrap().unwrap()
}

#[test]
fn the_first_sheet_with_a_table_is_read() {
    let notes = "Rig|A12\nOperator|someone\nRemarks|none of them a number\nDate|today\nMass [kg]|2.5\nLoad [N]|20";
    let data = "Run of the rig\n\n|time|force [kN]|note|displacement\n|ms|||mm\n|1|0.25|first|-3\n\n|2|1e-3||4";
    let old = ("~old", "time|force\n5|6\n7|8");
    let file = workbook(&[("notes", notes), old, ("data", data), ("later", "a|b\n1|2")]);
    let sheet = table(file.path()).unwrap();
    assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
    assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![250.0, 1.0]));
    assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![-3e-3, 4e-3]));
    let note = "the table was read from sheet 'data', the first of 4 that has one; --sheet NAME chooses another";
    assert_eq!(sheet.note(), Some(note));
    // Only hidden sheets have one.
    assert_eq!(table(workbook(&[("notes", notes), old]).path()).unwrap().column(&FORCE).unwrap(), Some(vec![6.0, 8.0]));
}

#[test]
fn a_sheet_may_be_chosen() {
    let file = workbook(&[("one", "time|force\n1|2"), ("~two", "time|force\n3|4"), ("three", "Rig|A12")]);
    let chosen = |name| crate::table(file.path(), Some(name));
    let two = chosen("~two").unwrap();
    assert_eq!((two.column(&FORCE).unwrap(), two.note()), (Some(vec![4.0]), None));
    let [unknown, empty] = ["four", "three"].map(|name| chosen(name).unwrap_err().to_string());
    assert!(unknown.ends_with(": no sheet 'four'; there are 'one', 'three', '~two'"), "{unknown}");
    assert!(empty.ends_with(": sheet 'three' has no heading over numbers"), "{empty}");
    let text = crate::table(Path::new("a.csv"), Some("one")).unwrap_err().to_string();
    assert_eq!(text, "a.csv: sheet: only spreadsheets have sheets (.xlsx, .xlsm, .ods)");
}

#[test]
fn errors_name_the_row_of_the_sheet() {
    let file = workbook(&[("data", "A record\n\ntime|force\n0|1\n\n1|broken")]);
    let sheet = table(file.path()).unwrap();
    assert_eq!(sheet.note(), None, "there is but one");
    assert_eq!(sheet.column(&FORCE).unwrap_err().to_string(), "line 6, force: 'broken' is not a finite number");
    let none = table(workbook(&[("notes", "Rig|A12"), ("empty", "")]).path()).unwrap_err();
    assert_eq!(none, "no sheet has a heading over numbers; there are 'notes', 'empty'");
    std::fs::write(file.path(), "not a workbook").unwrap();
    assert!(table(file.path()).is_err());
}

/// Numbers as text, with decimal points or commas; values of formulas; a heading merged with the cell above it.
#[test]
fn cells_are_understood_as_other_programs_write_them() {
    let file = workbook(&[("data", "time|sensors|\n|force|displacement\n'0,5|=3|'1e-3\n1.5|=4|'2e-3")]);
    let sheet = table(file.path()).unwrap();
    assert_eq!(sheet.names().collect::<Vec<_>>(), ["time", "force", "displacement"]);
    assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![0.5, 1.5]));
    assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3.0, 4.0]));
    assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![1e-3, 2e-3]));
    let numbers = table(workbook(&[("data", "time|force\n'1|'2\n'3|'4")]).path()).unwrap();
    assert_eq!(numbers.column(&FORCE).unwrap(), Some(vec![2.0, 4.0]));
}

/// Days since 1899-12-30 or 1904-01-01: the second of these moments is 0.2 ms after the first, the third 5 us, and the
/// last past midnight.
#[test]
fn moments_of_both_date_systems_are_read_to_the_microsecond() {
    for (first_year, day) in [("1900", 45_418.0), ("1904", 43_956.0)] {
        let moments = [0.75, 0.75 + 0.0002 / 86_400.0, 0.75 + 5e-6 / 86_400.0, 1.25]
            .map(|fraction| format!("@{}|1", day + fraction));
        let file = workbook_of(first_year, &[("data", &format!("time|force\n{}", moments.join("\n")))]);
        let found = times(&file);
        assert_eq!([found[0], found[1], found[3]], [64_800.0, 64_800.000_2, 108_000.0]);
        assert!((found[2] - 64_800.000_005).abs() < 2e-6, "{found:?}");
        let text = table(file.path()).unwrap().column_named("time", &FORCE).unwrap_err().to_string();
        assert!(text.contains("'2024-05-06T18:00:00.000000'"), "{first_year}: {text}");
    }
    // Times of day, and a duration that becomes longer than a day.
    assert_eq!(times(&workbook(&[("data", "time|force\n@0.5|1\n@0.75|2")])), [43_200.0, 64_800.0]);
    assert_eq!(times(&workbook(&[("data", "time|force\n+0.75|1\n+1.5|2")])), [64_800.0, 129_600.0]);
}

/// A cell of an OpenDocument sheet with a value of a kind.
fn open_cell(kind: &str, value: &str) -> String {
    let attribute = if kind == "float" { "value".to_owned() } else { format!("{kind}-value") };
    let text = format!("<text:p>{value}</text:p>");
    format!("<table:table-cell office:value-type='{kind}' office:{attribute}='{value}'>{text}</table:table-cell>")
}

/// An OpenDocument sheet with these rows of two cells, after two empty ones, and many empty rows at its end.
fn open_document(rows: &[[String; 2]]) -> tempfile::NamedTempFile {
    let empty = |count| format!("<table:table-cell table:number-columns-repeated='{count}'/>");
    let row = |cells: &[String; 2]| format!("<table:table-row>{}{}</table:table-row>", empty(2), cells.concat());
    let rows: String = rows.iter().map(row).collect();
    let end = format!("<table:table-row table:number-rows-repeated='1048000'>{}</table:table-row>", empty(1000));
    let space = "urn:oasis:names:tc:opendocument:xmlns";
    let spaces = ["office", "table", "text"].map(|name| format!(" xmlns:{name}='{space}:{name}:1.0'")).concat();
    let table = format!("<table:table table:name='data'>{rows}{end}</table:table>");
    let body = format!("<office:body><office:spreadsheet>{table}</office:spreadsheet></office:body>");
    let parts = [
        ("mimetype", "application/vnd.oasis.opendocument.spreadsheet".to_owned()),
        ("META-INF/manifest.xml", format!("<manifest:manifest xmlns:manifest='{space}:manifest:1.0'/>")),
        ("content.xml", format!("<office:document-content{spaces}>{body}</office:document-content>")),
    ];
    zipped(".ods", &parts.map(|(name, text)| (name.to_owned(), text)))
}

/// OpenDocument: dates and times by ISO 8601, cells and rows that are repeated.
#[test]
fn moments_of_open_documents_are_read() {
    let document = |kind: &str, moments: [&str; 2]| {
        let heading = ["time", "force"].map(|text| open_cell("string", text));
        let rows = moments.map(|moment| [open_cell(kind, moment), open_cell("float", "1")]);
        open_document(&[&[heading][..], &rows].concat())
    };
    let dates = document("date", ["2024-05-06T18:00:00", "2024-05-07T06:00:00.0002"]);
    assert_eq!(times(&dates), [64_800.0, 108_000.000_2]);
    assert_eq!(times(&document("time", ["PT14H03M27.25S", "PT26H"])), [50_607.25, 93_600.0]);
    let strange = table(document("time", ["PT1H", "P1D"]).path()).unwrap().column(&TIME).unwrap_err().to_string();
    assert_eq!(strange, "line 3, time: 'P1D' is not a time stamp like the first one");
}
