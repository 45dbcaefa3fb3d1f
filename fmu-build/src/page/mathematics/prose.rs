//! Symbols and short equations in running text.
//!
//! They are not marked, so they are distinguished from words by their parts, and typeset only if one of these cannot be
//! a word: a symbol of the page, a subscript, a derivative, a relation.

use stribeck_draw::text::escape;

use super::block::is_number;
use super::grammar;
use super::mathml::{self, Fractions};
use super::symbols::Symbols;
use super::token::{self, Token, Word, is_differential, is_function, is_letter};

/// Maximum number of words of an equation in running text.
const LONGEST: usize = 40;

/// Letters of units; a number and a unit are not a product.
const UNITS: [&str; 22] = [
    "m", "s", "kg", "N", "J", "W", "Hz", "kHz", "rad", "mm", "um", "nm", "ms", "us", "kN", "mN", "Pa", "MPa", "K", "g",
    "min", "h",
];

/// A symbol as MathML, for the cell of a symbol table.
pub fn symbol(text: &str, symbols: &Symbols) -> Result<String, String> {
    Ok(inline(&mathml::elements(&grammar::parse(text, symbols)?, Fractions::Flat)))
}

fn inline(elements: &str) -> String {
    format!("<math>{elements}</math>")
}

/// Part of a paragraph: unchanged text or MathML.
#[derive(Debug, PartialEq)]
pub enum Part {
    /// Plain text, not escaped.
    Text(String),
    /// An equation: its text, and its HTML.
    Equation(String, String),
}

/// Finds the equations in running text.
pub fn prose(text: &str, symbols: &Symbols) -> Vec<Part> {
    let words = words(text);
    let mut parts = Vec::new();
    let (mut at, mut kept) = (0, 0);
    while at < words.len() {
        match equation(text, &words, at, symbols) {
            Some((begin, end, elements)) => {
                let (outer_begin, outer_end) = with_punctuation(text, begin, end);
                parts.push(Part::Text(text[kept..outer_begin].to_owned()));
                let [before, after] = [&text[outer_begin..begin], &text[end..outer_end]].map(escape);
                let html = format!("<span class=\"math\">{before}{}{after}</span>", inline(&elements));
                parts.push(Part::Equation(text[begin..end].to_owned(), html));
                kept = outer_end;
                at += words[at..].iter().take_while(|(begin, _)| *begin < end).count();
            }
            None => at += 1,
        }
    }
    parts.push(Part::Text(text[kept..].to_owned()));
    parts.retain(|part| *part != Part::Text(String::new()));
    parts
}

/// Beginning and end of each word.
fn words(text: &str) -> Vec<(usize, usize)> {
    let begin = |word: &str| word.as_ptr() as usize - text.as_ptr() as usize;
    text.split_whitespace().map(|word| (begin(word), begin(word) + word.len())).collect()
}

/// The longest equation that begins with a word: beginning, end and elements.
fn equation(text: &str, words: &[(usize, usize)], at: usize, symbols: &Symbols) -> Option<(usize, usize, String)> {
    let spelled: Vec<&str> = words.iter().map(|(begin, end)| &text[*begin..*end]).collect();
    let last = words.len().min(at + LONGEST);
    let count = (at..last).take_while(|word| may_be_mathematics(&spelled, *word, *word == at, symbols)).count();
    (1..=count).rev().find_map(|count| {
        let (begin, end) = trimmed(text, words[at].0, words[at + count - 1].1);
        let candidate = &text[begin..end];
        let node = grammar::parse(candidate, symbols).ok().filter(|_| is_certain(candidate, symbols))?;
        Some((begin, end, mathml::elements(&node, Fractions::Flat)))
    })
}

/// The range without the punctuation of the sentence, and without brackets whose other half is elsewhere.
fn trimmed(text: &str, mut begin: usize, mut end: usize) -> (usize, usize) {
    loop {
        let part = &text[begin..end];
        let count = |sign: char| part.matches(sign).count();
        if part.ends_with(['.', ',', ';', ':']) || part.ends_with(')') && count(')') > count('(') {
            end -= 1;
        } else if part.starts_with('(') && count('(') > count(')') {
            begin += 1;
        } else {
            return (begin, end);
        }
    }
}

/// The range with the brackets and the punctuation that no line break may separate from it.
fn with_punctuation(text: &str, begin: usize, end: usize) -> (usize, usize) {
    let before = text[..begin].len() - text[..begin].trim_end_matches('(').len();
    let after = text[end..].len() - text[end..].trim_start_matches(['.', ',', ';', ':', ')', '?']).len();
    (begin - before, end + after)
}

/// Whether the word could be part of an equation.
fn may_be_mathematics(words: &[&str], at: usize, is_first: bool, symbols: &Symbols) -> bool {
    let word = words[at].trim_matches(['.', ',', ';', ':', '?']);
    // A number in brackets refers to an equation.
    if word.is_empty()
        || is_number(word)
        || !is_first && words[at - 1].ends_with([':', ';', '.'])
        || is_unit(words, at, symbols)
    {
        return false;
    }
    // An article, unless an operator is beside it.
    if matches!(word, "a" | "A" | "I") {
        let is_operator = |at: usize| words.get(at).is_some_and(|word| is_operator(word));
        return is_operator(at + 1) || at > 0 && is_operator(at - 1);
    }
    let Ok(tokens) = token::tokens(word) else { return false };
    let subscripted = |at: usize| matches!(tokens.get(at + 1), Some(Token { word: Word::Subscript(_), .. }));
    tokens.iter().enumerate().all(|(at, token)| match &token.word {
        Word::Name(name) => {
            let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
            is_letter(base) || is_function(name) || symbols.contains(name) || is_differential(name) && !subscripted(at)
        }
        _ => true,
    })
}

fn is_operator(word: &str) -> bool {
    let tokens = token::tokens(word).unwrap_or_default();
    tokens.first().is_some_and(|token| matches!(token.word, Word::Operator(_) | Word::Slash))
}

/// Whether the word is a unit after a number, or a unit divided by another.
fn is_unit(words: &[&str], at: usize, symbols: &Symbols) -> bool {
    let word = words[at].trim_matches(['.', ',', ';', ':', '(', ')']);
    let atoms = || word.split(['/', '.', '^', '2', '3']).filter(|atom| !atom.is_empty() && *atom != "1");
    if atoms().count() == 0 || !atoms().all(|atom| UNITS.contains(&atom)) {
        return false;
    }
    let follows_number = at > 0 && words[at - 1].parse::<f64>().is_ok();
    let goes_on = words.get(at + 1).is_some_and(|next| is_operator(next));
    match atoms().count() {
        1 => follows_number && !(goes_on && symbols.contains(word)) || at > 0 && words[at - 1] == "in",
        _ => true,
    }
}

/// Whether something in it cannot be a word.
fn is_certain(text: &str, symbols: &Symbols) -> bool {
    let tokens = token::tokens(text).unwrap_or_default();
    let is_name = |token: &Token| matches!(token.word, Word::Name(_) | Word::Derivative(_));
    let has_name = tokens.iter().any(is_name);
    tokens.iter().enumerate().any(|(at, token)| match &token.word {
        Word::Derivative(_) | Word::Subscript(_) | Word::Prime => true,
        Word::Operator(sign) => has_name && grammar::is_relation(sign),
        Word::Name(name) => {
            let is_symbol = symbols.contains(name) && !matches!(name.as_str(), "a" | "A" | "I");
            let is_applied = matches!(tokens.get(at + 1), Some(Token { word: Word::Open(_), spaced: false }));
            is_symbol || is_letter(name) && is_applied
        }
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The equations found in a text, separated by bars.
    fn found(text: &str) -> String {
        let mut symbols = Symbols::default();
        for symbol in ["v", "v_0", "f_C", "f_s", "sigma_0", "z", "m", "a", "alpha"] {
            symbols.add(symbol);
        }
        let parts = prose(text, &symbols);
        // Nothing of the text is lost or added.
        let sources = parts.iter().map(|part| match part {
            Part::Text(text) => text.clone(),
            Part::Equation(source, html) => {
                let (before, rest) = html.split_once("<math>").unwrap();
                let after = rest.split_once("</math>").unwrap().1;
                format!("{}{source}{}", before.replace("<span class=\"math\">", ""), after.replace("</span>", ""))
            }
        });
        assert_eq!(sources.collect::<String>(), text);
        let equations = parts.into_iter().filter_map(|part| match part {
            Part::Equation(source, _) => Some(source),
            Part::Text(_) => None,
        });
        equations.collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn symbols_and_equations_are_found() {
        assert_eq!(
            found("creeps with |v| < v_0. The peak is f(v_0), or f_s - 6.7e-4 f_C, as"),
            "|v| < v_0 | f(v_0) | f_s - 6.7e-4 f_C"
        );
        assert_eq!(
            found("below 2 m / f'(0), where f'(0) = (4 f_C + 16/9 (f_s - f_C)) / v_0; above"),
            "2 m / f'(0) | f'(0) = (4 f_C + 16/9 (f_s - f_C)) / v_0"
        );
        assert_eq!(
            found("For alpha = 1 this is dz/dt = v - sigma_0 |v| z / f_C (7.5)."),
            "alpha = 1 | dz/dt = v - sigma_0 |v| z / f_C"
        );
        assert_eq!(found("because tanh 4 = 0.99933 (chosen)"), "tanh 4 = 0.99933");
        assert_eq!(found("(of the size of v_0)"), "v_0");
    }

    #[test]
    fn words_numbers_and_units_are_left_alone() {
        for text in [
            "A stuck body, a sliding one; I do.",
            "from 1 us to 1 s, 0.1 m/s and 5 m of it in N/m",
            "(5.1) and (7.2), Table 6.1",
            "and/or, 0 -> 1, 1 % (chosen)",
            "Brown and McPhee (2016), doi:10.1115/1.4033658",
            "lambda functions in beta",
        ] {
            assert_eq!(found(text), "", "{text}");
        }
    }

    #[test]
    fn an_article_is_not_a_factor() {
        assert_eq!(found("needs a v_0 above"), "v_0");
        assert_eq!(found("with 1 + a = f_s"), "1 + a = f_s");
    }

    #[test]
    fn a_number_and_its_unit_stay_text() {
        assert_eq!(found("m = 1 kg, v_0 = 0.1 m/s, z(0) = 0"), "m = 1 | v_0 = 0.1 | z(0) = 0");
    }

    #[test]
    fn punctuation_stays_with_the_equation() {
        let parts = prose("(see v_0).", &{
            let mut symbols = Symbols::default();
            symbols.add("v_0");
            symbols
        });
        let Part::Equation(_, html) = &parts[1] else { panic!("{parts:?}") };
        assert!(html.ends_with("</math>).</span>"), "{html}");
    }
}
