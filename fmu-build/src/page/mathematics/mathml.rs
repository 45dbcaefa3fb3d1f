//! Equations as MathML Core, the part of MathML that present browsers support.

use stribeck_draw::text::escape;

use super::grammar::{self, Node};
use super::symbols::Symbols;
use super::token::greek;

/// Form of fractions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fractions {
    /// One above the other.
    Tall,
    /// On the line, with a slash: in running text, and inside other fractions.
    Flat,
}

const THIN_SPACE: &str = "<mspace width=\"0.17em\"/>";

/// A symbol or an equation on a line of text.
pub fn inline(text: &str, symbols: &Symbols) -> Result<String, String> {
    Ok(format!("<math>{}</math>", elements(&grammar::parse(text, symbols)?, Fractions::Flat)))
}

/// The elements of a part of an equation.
pub fn elements(node: &Node, fractions: Fractions) -> String {
    match node {
        Node::Number(text) => number(text),
        Node::Letter(name) => letter(name),
        Node::Function(name) => format!("<mi>{name}</mi>"),
        Node::Differential(of) => format!("<mrow>{UPRIGHT_D}{}</mrow>", letter(of)),
        Node::Scripted { base, below, above, primes } => {
            scripted(&elements(base, fractions), below, above.as_deref(), *primes)
        }
        Node::Subscript(text) => subscript(text),
        Node::Derivative(order, of, by) => derivative(order, of.as_deref(), by, fractions),
        Node::Fraction(above, below) => fraction(above, below, fractions),
        Node::Root(inner) => format!("<msqrt>{}</msqrt>", elements(inner, fractions)),
        Node::Fence(open, inner, close) => fence([*open, *close], inner, fractions),
        Node::Application(function, argument) => application(function, argument, fractions),
        Node::Product(factors) => format!("<mrow>{}</mrow>", product(factors, fractions)),
        Node::Chain(parts) | Node::List(parts) => format!("<mrow>{}</mrow>", run(parts, fractions)),
        Node::Operator(sign) => operator(sign),
        Node::Words(words) => text(&format!(" {words} ")),
    }
}

/// Parts one after the other.
pub fn run(parts: &[Node], fractions: Fractions) -> String {
    parts.iter().map(|part| elements(part, fractions)).collect()
}

/// Plain words inside an equation, with their spaces.
pub fn text(words: &str) -> String {
    format!("<mtext>{}</mtext>", escape(words).replace(' ', "\u{a0}"))
}

fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", escape(sign))
}

const UPRIGHT_D: &str = "<mi mathvariant=\"normal\">d</mi>";

fn letter(name: &str) -> String {
    match greek(name) {
        Some('∞') => "<mi mathvariant=\"normal\">∞</mi>".to_owned(),
        Some(letter) => format!("<mi>{letter}</mi>"),
        None => format!("<mi>{name}</mi>"),
    }
}

/// `6.7e-4` as 6.7 times a power of ten.
fn number(text: &str) -> String {
    let Some((mantissa, exponent)) = text.split_once('e') else { return format!("<mn>{text}</mn>") };
    let exponent = exponent.trim_start_matches('+').replace('-', "\u{2212}");
    let power = format!("<msup><mn>10</mn><mn>{exponent}</mn></msup>");
    if mantissa == "1" { power } else { format!("<mrow><mn>{mantissa}</mn><mo>\u{d7}</mo>{power}</mrow>") }
}

/// Letters of descriptive subscripts are upright, those of indices are slanted.
fn subscript(text: &str) -> String {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_other = |c: char| c.is_ascii_digit() != first.is_ascii_digit();
        let (part, next) = rest.split_at(rest.find(is_other).unwrap_or(rest.len()));
        parts.push(subscript_part(part));
        rest = next;
    }
    if parts.len() == 1 { parts.remove(0) } else { format!("<mrow>{}</mrow>", parts.concat()) }
}

/// Letters, or digits, or a sign.
fn subscript_part(text: &str) -> String {
    match text {
        "+" => "<mo>+</mo>".to_owned(),
        "-" => "<mo>\u{2212}</mo>".to_owned(),
        "i" | "j" => format!("<mi>{text}</mi>"),
        digits if digits.starts_with(|c: char| c.is_ascii_digit()) => format!("<mn>{digits}</mn>"),
        one if one.len() == 1 => format!("<mi mathvariant=\"normal\">{one}</mi>"),
        // Several letters in one element are upright anyway.
        letters => match greek(letters) {
            Some(letter) => format!("<mi mathvariant=\"normal\">{letter}</mi>"),
            None => format!("<mi>{letters}</mi>"),
        },
    }
}

fn scripted(base: &str, below: &[Node], above: Option<&Node>, primes: usize) -> String {
    let subscripts: Vec<String> = below.iter().map(|node| elements(node, Fractions::Flat)).collect();
    let subscripts = match subscripts.as_slice() {
        [one] => one.clone(),
        several => format!("<mrow>{}</mrow>", several.join("<mo separator=\"true\">,</mo>")),
    };
    let marks = ["", "\u{2032}", "\u{2033}", "\u{2034}"].get(primes).map_or("\u{2057}", |sign| sign);
    let exponent = above.map(|node| elements(node, Fractions::Flat));
    let superscript = match (primes, exponent) {
        (0, exponent) => exponent,
        (_, None) => Some(format!("<mo>{marks}</mo>")),
        (_, Some(exponent)) => Some(format!("<mrow><mo>{marks}</mo>{exponent}</mrow>")),
    };
    match (below.is_empty(), superscript) {
        (true, None) => base.to_owned(),
        (false, None) => format!("<msub>{base}{subscripts}</msub>"),
        (true, Some(above)) => format!("<msup>{base}{above}</msup>"),
        (false, Some(above)) => format!("<msubsup>{base}{subscripts}{above}</msubsup>"),
    }
}

fn derivative(order: &str, of: Option<&Node>, by: &Node, fractions: Fractions) -> String {
    let with_order = |base: &str| match order {
        "" => base.to_owned(),
        order => format!("<msup>{base}<mn>{order}</mn></msup>"),
    };
    let of = of.map(|node| elements(node, Fractions::Flat)).unwrap_or_default();
    let above = format!("<mrow>{}{of}</mrow>", with_order(UPRIGHT_D));
    let by = with_order(&elements(by, Fractions::Flat));
    quotient(&above, &format!("<mrow>{UPRIGHT_D}{by}</mrow>"), fractions)
}

/// A tall fraction drops the brackets of its halves; inside it, fractions are flat.
fn fraction(above: &Node, below: &Node, fractions: Fractions) -> String {
    let half = |node: &Node| match (fractions, node) {
        (Fractions::Tall, Node::Fence('(', inner, ')')) => elements(inner, Fractions::Flat),
        _ => elements(node, Fractions::Flat),
    };
    quotient(&half(above), &half(below), fractions)
}

fn quotient(above: &str, below: &str, fractions: Fractions) -> String {
    match fractions {
        Fractions::Tall => format!("<mfrac>{above}{below}</mfrac>"),
        Fractions::Flat => {
            format!("<mrow>{above}<mo lspace=\"0.05em\" rspace=\"0.05em\" stretchy=\"false\">/</mo>{below}</mrow>")
        }
    }
}

/// Brackets grow with tall contents; a subscript or an exponent alone does not count as tall.
fn fence([open, close]: [char; 2], inner: &Node, fractions: Fractions) -> String {
    let stretchy = fractions == Fractions::Tall && has_fraction(inner);
    let side =
        |sign: char, form: &str| format!("<mo form=\"{form}\" fence=\"true\" stretchy=\"{stretchy}\">{sign}</mo>");
    format!("<mrow>{}{}{}</mrow>", side(open, "prefix"), elements(inner, fractions), side(close, "postfix"))
}

fn has_fraction(node: &Node) -> bool {
    match node {
        Node::Fraction(..) | Node::Derivative(..) => true,
        Node::Root(inner) | Node::Fence(_, inner, _) | Node::Scripted { base: inner, .. } => has_fraction(inner),
        Node::Application(_, argument) => has_fraction(argument),
        Node::Product(parts) | Node::Chain(parts) | Node::List(parts) => parts.iter().any(has_fraction),
        _ => false,
    }
}

fn application(function: &Node, argument: &Node, fractions: Fractions) -> String {
    let space = if begins_with_bracket(argument) { "" } else { THIN_SPACE };
    let [function, argument] = [function, argument].map(|node| elements(node, fractions));
    format!("<mrow>{function}<mo>\u{2061}</mo>{space}{argument}</mrow>")
}

fn begins_with_bracket(node: &Node) -> bool {
    match node {
        Node::Fence('(', ..) => true,
        Node::Scripted { base, .. } => begins_with_bracket(base),
        _ => false,
    }
}

/// Factors close together, except for the names of functions, and with a dot between numbers.
fn product(factors: &[Node], fractions: Fractions) -> String {
    let mut text = String::new();
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            text += between(&factors[at - 1], factor);
        }
        text += &elements(factor, fractions);
    }
    text
}

fn between(left: &Node, right: &Node) -> &'static str {
    let is_named = |node: &Node| match node {
        Node::Application(function, _) => match &**function {
            Node::Scripted { base, .. } => matches!(**base, Node::Function(_)),
            function => matches!(function, Node::Function(_)),
        },
        Node::Function(_) | Node::Differential(_) | Node::Derivative(..) => true,
        _ => false,
    };
    match (left, right) {
        (_, Node::Number(_)) => "<mo>\u{22c5}</mo>",
        (Node::Operator(_), _) => THIN_SPACE,
        _ if is_named(left) || is_named(right) => THIN_SPACE,
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::super::grammar::parse;
    use super::*;

    fn mathml(text: &str, fractions: Fractions) -> String {
        elements(&parse(text, &Symbols::default()).unwrap(), fractions)
    }

    #[test]
    fn small_equations_are_correct() {
        for (text, expected) in [
            ("v", "<mi>v</mi>"),
            ("f_C", "<msub><mi>f</mi><mi mathvariant=\"normal\">C</mi></msub>"),
            ("f_nt", "<msub><mi>f</mi><mi>nt</mi></msub>"),
            ("sigma_0", "<msub><mi>\u{3c3}</mi><mn>0</mn></msub>"),
            ("k_i", "<msub><mi>k</mi><mi>i</mi></msub>"),
            ("k_0i", "<msub><mi>k</mi><mrow><mn>0</mn><mi>i</mi></mrow></msub>"),
            ("x1", "<msub><mi>x</mi><mn>1</mn></msub>"),
            ("x''", "<msup><mi>x</mi><mo>\u{2033}</mo></msup>"),
            ("z_1^2", "<msubsup><mi>z</mi><mn>1</mn><mn>2</mn></msubsup>"),
            ("-x", "<mrow><mo>\u{2212}</mo><mi>x</mi></mrow>"),
            ("a != b", "<mrow><mi>a</mi><mo>\u{2260}</mo><mi>b</mi></mrow>"),
            ("a < b", "<mrow><mi>a</mi><mo>&lt;</mo><mi>b</mi></mrow>"),
            ("a * b", "<mrow><mi>a</mi><mi>b</mi></mrow>"),
            ("2 * 3", "<mrow><mn>2</mn><mo>\u{22c5}</mo><mn>3</mn></mrow>"),
            ("1e-5", "<msup><mn>10</mn><mn>\u{2212}5</mn></msup>"),
            ("6.7e-4", "<mrow><mn>6.7</mn><mo>\u{d7}</mo><msup><mn>10</mn><mn>\u{2212}4</mn></msup></mrow>"),
            ("sqrt(x)", "<msqrt><mi>x</mi></msqrt>"),
            ("inf", "<mi mathvariant=\"normal\">\u{221e}</mi>"),
        ] {
            assert_eq!(mathml(text, Fractions::Tall), expected, "{text}");
        }
    }

    #[test]
    fn fractions_are_tall_or_flat() {
        let derivative = "<mfrac><mrow><msup><mi mathvariant=\"normal\">d</mi><mn>2</mn></msup><mi>x</mi></mrow>\
                          <mrow><mi mathvariant=\"normal\">d</mi><msup><mi>t</mi><mn>2</mn></msup></mrow></mfrac>";
        assert_eq!(mathml("d2x/dt2", Fractions::Tall), derivative);
        assert_eq!(
            mathml("(a + b) / (c)", Fractions::Tall),
            "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mi>c</mi></mfrac>"
        );
        let flat = mathml("a / b", Fractions::Flat);
        assert!(flat.starts_with("<mrow><mi>a</mi><mo ") && flat.ends_with(">/</mo><mi>b</mi></mrow>"), "{flat}");
        // The brackets of a flat fraction are needed.
        assert!(mathml("(a + b) / c", Fractions::Flat).contains(">(</mo>"));
        // Inside a tall fraction others are flat.
        assert_eq!(mathml("a / (b / c)", Fractions::Tall).matches("<mfrac>").count(), 1);
    }

    #[test]
    fn only_brackets_around_something_tall_grow() {
        assert!(mathml("(a / b)", Fractions::Tall).contains("stretchy=\"true\">("));
        assert!(mathml("(a_1 b^2)", Fractions::Tall).contains("stretchy=\"false\">("));
        assert!(mathml("exp(-(|v| / v_S)^2)", Fractions::Tall).matches("stretchy=\"true\"").count() == 4);
    }

    #[test]
    fn functions_keep_a_distance_from_arguments_without_brackets() {
        let space = "<mspace width=\"0.17em\"/>";
        assert_eq!(
            mathml("sgn v", Fractions::Tall),
            format!("<mrow><mi>sgn</mi><mo>\u{2061}</mo>{space}<mi>v</mi></mrow>")
        );
        assert_eq!(mathml("a exp(x)", Fractions::Tall).matches(space).count(), 1);
        assert_eq!(mathml("g(v)", Fractions::Tall).matches(space).count(), 0);
    }
}
