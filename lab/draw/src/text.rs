//! Texts of diagrams: escapes, units, numbers.

/// A text inside XML or HTML, in elements and in attributes; characters that XML does not admit are replaced.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&#39;",
            '\t' | '\n' | '\r' => escaped.push(character),
            '\0'..='\x1f' | '\x7f'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ => escaped.push(character),
        }
    }
    escaped
}

/// A unit as it is printed: N.s2/m2 is N·s²/m².
pub fn typeset_unit(unit: &str) -> String {
    let unit = unit.replace("um", "\u{b5}m").replace('.', "\u{b7}");
    unit.replace('2', "\u{b2}").replace('3', "\u{b3}")
}

/// A number with as many decimals, and a minus sign instead of a hyphen.
pub fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.bytes().all(|letter| matches!(letter, b'-' | b'0' | b'.'));
    if is_zero { text.replace('-', "") } else { text.replace('-', "\u{2212}") }
}

/// A number with as many digits, without zeros at its end.
pub fn digits(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.max(1) - 1).parse().unwrap_or(value);
    rounded.to_string().replace('-', "\u{2212}")
}
