//! The words of an equation.

/// A word of an equation.
#[derive(Clone, Debug, PartialEq)]
pub enum Word {
    /// A number as it is written, such as `6.7e-4`.
    Number(String),
    /// Letters and digits, such as `sigma`, `tanh` or `x1`.
    Name(String),
    /// A subscript after an underscore: letters and digits, `+` or `-`; empty if a bracket follows.
    Subscript(String),
    /// A derivative such as `d2x/dt2`.
    Derivative(Derivative),
    /// An operator or relation; the characters to typeset.
    Operator(&'static str),
    /// An opening bracket.
    Open(char),
    /// A closing bracket.
    Close(char),
    /// A vertical bar, which opens or closes an absolute value.
    Bar,
    /// A comma or semicolon.
    Separator(char),
    /// A caret.
    Power,
    /// A division.
    Slash,
    /// A prime.
    Prime,
}

/// `d2x/dt2`: order, function and variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivative {
    /// `2` for a second derivative, empty for a first one.
    pub order: String,
    /// The function; empty in `d/dt`.
    pub of: String,
    /// The variable.
    pub by: String,
}

/// A word and whether a space precedes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// The word.
    pub word: Word,
    /// Whether there is white space before it.
    pub spaced: bool,
}

/// Spelling and characters of the operators; of two that begin alike the longer one comes first.
const OPERATORS: [(&str, &str); 23] = [
    ("<=>", "\u{21d4}"),
    ("...", "\u{2026}"),
    ("..", "\u{2026}"),
    ("!=", "\u{2260}"),
    (">=", "\u{2265}"),
    ("<=", "\u{2264}"),
    ("==", "="),
    ("=>", "\u{21d2}"),
    ("->", "\u{2192}"),
    (":=", "\u{2254}"),
    ("~=", "\u{2248}"),
    ("<<", "\u{226a}"),
    (">>", "\u{226b}"),
    ("+-", "\u{b1}"),
    ("-+", "\u{2213}"),
    ("<- ", "\u{2190}"),
    ("+", "+"),
    ("-", "\u{2212}"),
    ("*", "\u{22c5}"),
    ("=", "="),
    ("<", "<"),
    (">", ">"),
    ("~", "\u{223c}"),
];

const GREEK: [(&str, char); 35] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("eps", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("inf", '∞'),
];

/// The letter of that name.
pub fn greek(name: &str) -> Option<char> {
    GREEK.iter().find(|(known, _)| *known == name).map(|(_, letter)| *letter)
}

/// A single letter, Latin or Greek by its name.
pub fn is_letter(name: &str) -> bool {
    name.len() == 1 && name.bytes().all(|byte| byte.is_ascii_alphabetic()) || greek(name).is_some()
}

/// Functions that take the next factor without brackets.
const FUNCTIONS: [&str; 32] = [
    "abs", "acos", "arccos", "arcsin", "arctan", "asin", "atan", "atan2", "ceil", "clamp", "cos", "cosh", "div", "erf",
    "exp", "floor", "lim", "ln", "log", "max", "min", "mod", "round", "sat", "sgn", "sign", "sin", "sinh", "sqrt",
    "tan", "tanh", "trunc",
];

/// Large operators with limits.
const LARGE: [(&str, &str); 3] = [("sum", "\u{2211}"), ("prod", "\u{220f}"), ("int", "\u{222b}")];

/// Whether it is the name of a function.
pub fn is_function(name: &str) -> bool {
    FUNCTIONS.contains(&name) || large(name).is_some()
}

/// The sign of the large operator of that name.
pub fn large(name: &str) -> Option<&'static str> {
    LARGE.iter().find(|(known, _)| *known == name).map(|(_, sign)| *sign)
}

/// `dt`: a `d` and a letter.
pub fn is_differential(name: &str) -> bool {
    name.strip_prefix('d').is_some_and(is_letter)
}

/// The words of a text; the error names a character that is not part of an equation.
pub fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    let mut rest = text;
    loop {
        let trimmed = rest.trim_start();
        let spaced = trimmed.len() < rest.len();
        if trimmed.is_empty() {
            return Ok(tokens);
        }
        let (word, length) = word(trimmed)?;
        tokens.push(Token { word, spaced });
        rest = &trimmed[length..];
    }
}

/// The first word and its length in bytes.
fn word(text: &str) -> Result<(Word, usize), String> {
    let first = text.chars().next().unwrap_or_default();
    if first.is_ascii_alphabetic() {
        return Ok(derivative(text).unwrap_or_else(|| name(text)));
    }
    if first.is_ascii_digit() {
        let length = number_length(text);
        return Ok((Word::Number(text[..length].to_owned()), length));
    }
    if let Some((spelled, shown)) = OPERATORS.iter().find(|(spelled, _)| text.starts_with(spelled)) {
        return Ok((Word::Operator(shown), spelled.trim_end().len()));
    }
    if first == '_' { subscript(text) } else { Ok((mark(first)?, 1)) }
}

/// A word of one character that is not an operator.
fn mark(character: char) -> Result<Word, String> {
    Ok(match character {
        '(' | '[' | '{' => Word::Open(character),
        ')' | ']' | '}' => Word::Close(character),
        ',' | ';' => Word::Separator(character),
        '|' => Word::Bar,
        '^' => Word::Power,
        '/' => Word::Slash,
        '\'' => Word::Prime,
        _ => return Err(format!("'{character}' is not part of an equation")),
    })
}

fn alphanumeric_length(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_alphanumeric).count()
}

fn digits_length(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

fn name(text: &str) -> (Word, usize) {
    let length = alphanumeric_length(text);
    (Word::Name(text[..length].to_owned()), length)
}

fn subscript(text: &str) -> Result<(Word, usize), String> {
    let rest = &text[1..];
    let length = match rest.chars().next() {
        Some('+' | '-') => 1,
        Some('(' | '{') => 0,
        _ => match alphanumeric_length(rest) {
            0 => return Err("an underscore without a subscript".to_owned()),
            length => length,
        },
    };
    Ok((Word::Subscript(rest[..length].to_owned()), 1 + length))
}

/// Digits, a fraction and an exponent; `1..4` is a range of whole numbers.
fn number_length(text: &str) -> usize {
    let mut length = digits_length(text);
    if let Some(fraction) = text[length..].strip_prefix('.')
        && digits_length(fraction) > 0
    {
        length += 1 + digits_length(fraction);
    }
    if let Some(exponent) = text[length..].strip_prefix('e') {
        let sign = usize::from(exponent.starts_with(['+', '-']));
        let digits = digits_length(&exponent[sign..]);
        if digits > 0 {
            length += 1 + sign + digits;
        }
    }
    length
}

/// `d`, the order if it is not 1, a letter with its subscript, `/d`, a letter and the order again.
fn derivative(text: &str) -> Option<(Word, usize)> {
    let (order, rest) = order(text.strip_prefix('d')?);
    let of = symbol_length(rest)?;
    let (of, rest) = rest.split_at(of);
    let rest = rest.strip_prefix("/d")?;
    let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (by, rest) = rest.split_at(letters);
    let (order_below, rest) = self::order(rest);
    let ends = !rest.starts_with(|next: char| next.is_ascii_alphanumeric() || next == '_');
    let fits = order == order_below && is_letter(by) && ends;
    let derivative = Derivative { order: order.to_owned(), of: of.to_owned(), by: by.to_owned() };
    fits.then(|| (Word::Derivative(derivative), text.len() - rest.len()))
}

/// An order, with or without caret, and what follows it.
fn order(text: &str) -> (&str, &str) {
    let digits = text.strip_prefix('^').unwrap_or(text);
    digits.split_at(digits_length(digits))
}

/// The length of a letter with subscripts, 0 for none; `None` for anything longer.
fn symbol_length(text: &str) -> Option<usize> {
    let letters = text.bytes().take_while(u8::is_ascii_alphabetic).count();
    if letters > 0 && !is_letter(&text[..letters]) {
        return None;
    }
    let mut length = letters;
    while letters > 0 && text[length..].starts_with('_') {
        length += 1 + alphanumeric_length(&text[length + 1..]);
    }
    Some(length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<Word> {
        tokens(text).unwrap().into_iter().map(|token| token.word).collect()
    }

    fn derivative(order: &str, of: &str, by: &str) -> Word {
        Word::Derivative(Derivative { order: order.into(), of: of.into(), by: by.into() })
    }

    #[test]
    fn derivatives_are_distinguished_from_quotients() {
        assert_eq!(words("d2x/dt2"), [derivative("2", "x", "t")]);
        assert_eq!(words("d^2x/dt^2"), [derivative("2", "x", "t")]);
        assert_eq!(words("df_f/dt"), [derivative("", "f_f", "t")]);
        assert_eq!(words("dtheta_1/dtau"), [derivative("", "theta_1", "tau")]);
        assert_eq!(words("d/dt"), [derivative("", "", "t")]);
        for quotient in ["delta/d", "d2x/dt", "d/d_0", "d_v/dt", "depth/dt", "dx/dt_1"] {
            assert!(!matches!(words(quotient)[0], Word::Derivative(_)), "{quotient}");
        }
    }

    #[test]
    fn numbers_end_where_they_should() {
        let number = |text: &str| Word::Number(text.into());
        assert_eq!(words("6.7e-4"), [number("6.7e-4")]);
        assert_eq!(words("1..4"), [number("1"), Word::Operator("\u{2026}"), number("4")]);
        assert_eq!(words("2e"), [number("2"), Word::Name("e".into())]);
        assert_eq!(words("1e5x"), [number("1e5"), Word::Name("x".into())]);
    }

    #[test]
    fn longer_operators_win() {
        let operator = |shown| vec![Word::Operator(shown)];
        assert_eq!(words("<=>"), operator("\u{21d4}"));
        assert_eq!(words("<="), operator("\u{2264}"));
        assert_eq!(words("<"), operator("<"));
        assert_eq!(words("z <- 0")[1], Word::Operator("\u{2190}"));
        assert_eq!(words("v <-1")[1..3], [Word::Operator("<"), Word::Operator("\u{2212}")]);
    }

    #[test]
    fn subscripts_are_one_word() {
        assert_eq!(words("k_0i"), [Word::Name("k".into()), Word::Subscript("0i".into())]);
        assert_eq!(words("(x)_+")[3], Word::Subscript("+".into()));
        assert!(tokens("f_ = 1").is_err());
        assert!(tokens("a # b").is_err());
    }
}
