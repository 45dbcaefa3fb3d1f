//! Headings of tables with their units, and the lines above them that testing machines and recorders write.

use std::ops::Range;

use crate::units::QUANTITIES;

/// Most lines above a heading (chosen).
const MOST: usize = 200;

/// A text whose lines above the heading are comments, so that all lines keep their numbers, and a note that says so. Tables
/// with the same heading below continue the first one. None if it begins with its heading, or has no heading over numbers.
/// A first line with as many cells as the heading is one itself: of two headings none is taken.
pub(crate) fn without_lines_above(text: &str) -> Option<(String, String)> {
    let is_row = |line: &str| !line.trim().is_empty() && !line.starts_with('#');
    let lines = text.lines().enumerate().filter(|(_, line)| is_row(line)).take(MOST);
    let rows: Vec<(usize, &str)> = lines.collect();
    let at = (0..rows.len()).find(|at| is_heading(rows[*at].1, &rows[at + 1..]))?;
    let (number, heading) = rows[at];
    let width = |line: &str| cells(line, separator_of(heading)).len();
    if at == 0 || width(rows[0].1) == width(heading) {
        return None;
    }
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let later = later_headings(&lines, number);
    for at in later.iter().cloned().flatten().chain(0..number) {
        lines[at].insert(0, '#');
    }
    let mut note = format!("the table begins with the heading in line {}; what is above it is not read", number + 1);
    if !later.is_empty() {
        let headings = if later.len() == 1 { "another heading" } else { "more headings" };
        note += &format!("; it goes on below {headings} like it ({})", later.len());
    }
    Some((lines.join("\n") + "\n", note))
}

/// A text whose heading is a comment right above its numbers, as programs for arrays and robots write it, with the heading
/// as a line of its own, and a note that says so. None for other texts.
pub(crate) fn with_heading_in_comment(text: &str) -> Option<(String, String)> {
    let bare = |line: &'_ str| line.trim_start_matches(['#', '%', ' ']).to_owned();
    let first = text.lines().position(|line| !line.trim().is_empty() && !line.starts_with('#'))?;
    // With a row of units below it or without.
    let at = (1..=2.min(first)).rev().map(|up| first - up).find(|at| {
        let lines: Vec<String> = text.lines().skip(*at).take(3).map(bare).collect();
        let below: Vec<(usize, &str)> = lines.iter().skip(1).map(|line| (0, line.as_str())).collect();
        is_heading(&lines[0], &below)
    })?;
    let own = |(number, line): (usize, &str)| if (at..first).contains(&number) { bare(line) } else { line.to_owned() };
    let lines: Vec<String> = text.lines().enumerate().map(own).collect();
    Some((lines.join("\n") + "\n", format!("the comment in line {} is the heading", at + 1)))
}

/// For each repetition of the heading in a line its lines and those above it, back to the last row, with its row of units.
fn later_headings(lines: &[String], number: usize) -> Vec<Range<usize>> {
    let (heading, separator) = (&lines[number], separator_of(&lines[number]));
    let is_as_wide = |line: &str| cells(line, separator).len() == cells(heading, separator).len();
    let are_units = |line: &&String| is_of_units(&csv::StringRecord::from(cells(line, separator)));
    let units = lines.get(number + 1).filter(are_units);
    let later = (number + 1..lines.len()).filter(|at| lines[*at] == *heading);
    let part = |at: usize| {
        let begin = (number..at).rev().find(|row| is_as_wide(&lines[*row])).map_or(at, |row| row + 1);
        let has_units = units.is_some() && lines.get(at + 1) == units;
        begin..at + 1 + usize::from(has_units)
    };
    later.map(part).collect()
}

/// Cells of a line; between blanks without a separator.
fn cells(line: &str, separator: Option<char>) -> Vec<String> {
    match separator {
        Some(mark) => line.split(mark).map(|cell| cell.trim().trim_matches('"').to_owned()).collect(),
        None => between_blanks(line),
    }
}

/// Whether a line of texts is the heading of the lines below it: of numbers in two columns, with a row of units between
/// them or none. Sentences are texts between blanks too, so that those must be over nothing but numbers.
fn is_heading(line: &str, below: &[(usize, &str)]) -> bool {
    let separator = separator_of(line);
    let heading = cells(line, separator);
    let decimal = |cell: &String| if separator == Some(',') { cell.clone() } else { cell.replace(',', ".") };
    let is_number = |cell: &&String| decimal(cell).parse::<f64>().is_ok();
    let is_over_numbers = |row: &(usize, &str)| {
        let row = cells(row.1, separator);
        let least = if separator.is_none() { heading.len() } else { 2 };
        row.len() == heading.len() && row.iter().filter(|cell| is_number(cell)).count() >= least
    };
    let is_over_units = |row: &(usize, &str)| is_of_units(&csv::StringRecord::from(cells(row.1, separator)));
    let texts = heading.iter().filter(|cell| !cell.is_empty()).count();
    texts > 1
        && !heading.iter().any(|cell| is_number(&cell))
        && match below {
            [next, ..] if is_over_numbers(next) => true,
            [units, next, ..] => is_over_units(units) && is_over_numbers(next),
            _ => false,
        }
}

/// Columns of a heading that are separated by blanks; a unit in brackets belongs to the name before it.
pub(crate) fn between_blanks(heading: &str) -> Vec<String> {
    let mut columns: Vec<String> = Vec::new();
    for word in heading.split_whitespace() {
        match columns.last_mut() {
            Some(column) if word.starts_with(['[', '(']) => *column += word,
            _ => columns.push(word.to_owned()),
        }
    }
    columns
}

/// Marks between columns besides blanks.
pub(crate) const SEPARATORS: [char; 3] = ['\t', ';', ','];

/// The separator of a heading, outside of quotation marks.
pub(crate) fn separator_of(heading: &str) -> Option<char> {
    let bare: String = heading.split('"').step_by(2).collect();
    SEPARATORS.into_iter().find(|mark| bare.contains(*mark))
}

/// A unit in ASCII: the micro sign and the Greek letter become u, a raised dot becomes a dot, a degree sign alone is deg
/// and before a letter is left out; anything else stays and is an error. A first sign that was not UTF-8 is a micro or
/// degree sign.
pub(crate) fn plain(unit: &str) -> String {
    let packed: String = unit.chars().filter(|letter| !letter.is_whitespace()).collect();
    let letters = packed.replace(['\u{b5}', '\u{3bc}'], "u").replace(['\u{b7}', '\u{22c5}'], ".");
    let is_lost = letters.starts_with(char::REPLACEMENT_CHARACTER);
    match letters.strip_prefix(['\u{b0}', '\u{ba}', char::REPLACEMENT_CHARACTER]) {
        Some(rest) if rest.is_empty() || rest.starts_with('/') => format!("deg{rest}"),
        Some("m" | "s") if !is_lost => letters,
        Some(unit @ ("m" | "s")) => format!("u{unit}"),
        Some(unit) => unit.to_owned(),
        // As testing machines write it.
        None if letters == "Sec" => letters.to_lowercase(),
        None => letters,
    }
}

/// Words that stand for no unit.
pub(crate) const NO_UNIT: [&str; 3] = ["", "-", "none"];

/// Whether a row has units: at least one that is known, and no number but the unit 1.
pub(crate) fn is_of_units(row: &csv::StringRecord) -> bool {
    let cells: Vec<String> = row.iter().map(|text| plain(text.trim_matches(['[', ']', '(', ')']))).collect();
    let is_known = |text: &String| {
        text != "1" && QUANTITIES.iter().any(|quantity| quantity.units.iter().any(|unit| unit.0 == text))
    };
    cells.iter().any(is_known) && cells.iter().all(|text| text == "1" || text.parse::<f64>().is_err())
}
