//! Lines of a tyre property file: keys with their values, and numbers as programs of several languages write them.

use std::borrow::Cow;

/// A line with a key.
pub(super) struct Entry<'a> {
    pub line: usize,
    pub text: &'a str,
    /// In upper case; empty before the first section.
    pub section: String,
    /// In upper case.
    pub key: String,
    /// Without quotes and comment; empty if there is none.
    pub value: &'a str,
}

/// Why a file is rejected, with number and text of the line at fault.
pub(super) struct Refusal {
    pub at: Option<(usize, String)>,
    pub why: String,
}

impl Refusal {
    /// For what no line is at fault.
    pub fn of_file(why: impl Into<String>) -> Refusal {
        Refusal { at: None, why: why.into() }
    }
}

/// A finite number.
pub(super) struct Number {
    pub value: f64,
    /// The mark of its decimals, if it has any.
    pub mark: Option<char>,
}

impl Entry<'_> {
    pub fn refused(&self, why: impl Into<String>) -> Refusal {
        Refusal { at: Some((self.line, self.text.into())), why: why.into() }
    }

    pub fn number(&self) -> Result<Number, Refusal> {
        number(self.value).ok_or_else(|| self.refused("must be a finite number"))
    }

    /// Whether both have the same value, as numbers or as texts.
    pub fn agrees(&self, other: &Entry) -> bool {
        match (number(self.value), number(other.value)) {
            (Some(one), Some(another)) => one.value == another.value,
            _ => self.value.eq_ignore_ascii_case(other.value),
        }
    }
}

/// The bytes of a file as text: UTF-8, or else Latin-1.
pub(super) fn decoded(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| error.into_bytes().into_iter().map(char::from).collect())
}

/// The text with line ends that `lines` knows; programs of old end a line with a carriage return alone.
pub(super) fn with_lines(text: &str) -> Cow<'_, str> {
    if text.contains('\n') { text.into() } else { text.replace('\r', "\n").into() }
}

/// All lines with keys. Comments begin with $, ! or //. Lines without = belong to tables, which nothing here uses; but
/// a key that `is_needed` must have its value.
pub(super) fn entries<'a>(text: &'a str, is_needed: impl Fn(&str) -> bool) -> Result<Vec<Entry<'a>>, Refusal> {
    let mut entries = Vec::new();
    let mut section = String::new();
    for (at, text) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let (line, text) = (at + 1, text.trim());
        let content = before_comment(text);
        if let Some(rest) = content.strip_prefix('[') {
            section = rest.split(']').next().unwrap_or_default().trim().to_uppercase();
        } else if content.contains('=') {
            let (key, value) = key_and_value(text);
            entries.push(Entry { line, text, section: section.clone(), key, value });
        } else if content.split_whitespace().next().is_some_and(|word| is_needed(&word.to_uppercase())) {
            return Err(Refusal { at: Some((line, text.into())), why: "must be KEY = value".into() });
        }
    }
    Ok(entries)
}

/// The key in upper case, and the value without quotes and comment.
fn key_and_value(text: &str) -> (String, &str) {
    let (key, rest) = text.split_once('=').unwrap_or((text, ""));
    let rest = rest.trim();
    let quoted = rest.strip_prefix(['\'', '"']).map(|rest| rest.split(['\'', '"']).next().unwrap_or_default());
    (key.trim().to_uppercase(), quoted.unwrap_or_else(|| before_comment(rest)).trim())
}

fn before_comment(text: &str) -> &str {
    let end = text.find(['$', '!']).into_iter().chain(text.find("//")).min();
    text[..end.unwrap_or(text.len())].trim()
}

/// A finite number, also with the exponents of Fortran (`1.5D-3`, `1.5-103`) and a decimal comma.
fn number(text: &str) -> Option<Number> {
    let is_number = |one: char| one.is_ascii_digit() || "+-.,eEdD".contains(one);
    if !text.chars().all(is_number) || text.matches(['.', ',']).count() > 1 {
        return None;
    }
    let mut plain = text.replace(['d', 'D', 'E'], "e").replace(',', ".");
    let bare = plain.rfind(['+', '-']).filter(|at| *at > 0 && !plain[..*at].ends_with('e'));
    if let Some(at) = bare {
        plain.insert(at, 'e');
    }
    let value = plain.parse().ok().filter(|value: &f64| value.is_finite())?;
    Some(Number { value, mark: text.chars().find(|one| ".,".contains(*one)) })
}
