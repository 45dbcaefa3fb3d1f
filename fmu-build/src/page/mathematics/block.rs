//! A block of equations as a table: left sides, right sides, conditions and numbers.
//!
//! Two or more spaces divide a line into cells: the equation, the condition under which it holds, and its number in
//! brackets. A condition that ends with a colon stands before its equation. A cell that begins or ends with an operator belongs to its neighbour; a cell after a comma is another
//! equation. A line that begins with a relation or a sign continues the one before, as does an indented one without a
//! relation.

use stribeck_draw::text::escape;

use super::grammar::{self, Node};
use super::mathml::{self, Fractions};
use super::symbols::Symbols;
use super::token::{self, Token, Word, greek, is_differential, is_function};

const WIDE_SPACE: &str = "<mspace width=\"2em\"/>";
const NARROW_SPACE: &str = "<mspace width=\"1em\"/>";

/// The block as HTML with its plain text below, or the errors in its lines.
pub fn block(text: &str, symbols: &Symbols) -> Result<String, Vec<String>> {
    let mut faults = Vec::new();
    let mut rows = Vec::new();
    for line in lines(text) {
        match row(&line, symbols) {
            Ok(row) => rows.push(row),
            Err(fault) => faults.push(format!("{fault} in `{}`", line.text())),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let rows: String = rows.iter().map(Row::html).collect();
    Ok(format!(
        "<div class=\"equations\">\n<div class=\"wide\"><table>\n{rows}</table></div>\n\
         <details><summary>As text</summary><pre>{}</pre></details>\n</div>\n",
        escape(text.trim_end())
    ))
}

/// A line of the text, or several lines that belong together.
struct Line {
    indent: usize,
    cells: Vec<Cell>,
    number: Option<String>,
}

/// Text between wide gaps, and the column where it begins.
struct Cell {
    column: usize,
    text: String,
}

impl Line {
    fn new(line: &str) -> Line {
        let mut cells = cells(line);
        let is_last = cells.len() > 1;
        let number = cells.pop_if(|cell| is_last && is_number(&cell.text)).map(|cell| cell.text);
        Line { indent: line.len() - line.trim_start().len(), cells, number }
    }

    fn text(&self) -> String {
        self.cells.iter().map(|cell| cell.text.as_str()).collect::<Vec<_>>().join("  ")
    }

    fn first(&self) -> &str {
        self.cells.first().map_or("", |cell| cell.text.as_str())
    }

    fn has_condition(&self) -> bool {
        self.cells.len() > 1
    }
}

/// The lines; those that only make sense together are joined.
fn lines(text: &str) -> Vec<Line> {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    let margin = lines.iter().map(|line| line.len() - line.trim_start().len()).min().unwrap_or_default();
    let mut found: Vec<Line> = Vec::new();
    for line in lines {
        let line = Line::new(&line[margin..]);
        match found.last_mut() {
            Some(last) if is_wrapped_condition(last, &line) => join(last, line, true),
            Some(last) if belongs_to(last, &line) => join(last, line, false),
            _ => found.push(line),
        }
    }
    found
}

/// Whether the line begins where the condition of the last one begins.
fn is_wrapped_condition(last: &Line, line: &Line) -> bool {
    last.cells.last().is_some_and(|cell| last.has_condition() && line.indent >= cell.column) && !line.has_condition()
}

fn belongs_to(last: &Line, line: &Line) -> bool {
    let is_open = last.cells.iter().any(|cell| depth(&cell.text) > 0);
    let is_piece = line.indent > 0 && !leads_with_operator(line.first()) && !has_relation(line.first());
    let is_label = last.cells.len() == 1 && last.first().ends_with(':');
    is_open
        || line.first().starts_with(['*', '/', '^'])
        || is_piece && !is_label && !last.has_condition() && !line.has_condition()
}

fn join(last: &mut Line, line: Line, to_condition: bool) {
    let at = if to_condition { last.cells.len() - 1 } else { 0 };
    let mut cells = line.cells.into_iter();
    if let (Some(cell), Some(next)) = (last.cells.get_mut(at), cells.next()) {
        cell.text = format!("{} {}", cell.text, next.text);
    }
    last.cells.extend(cells);
    last.number = last.number.take().or(line.number);
}

/// Divides a line at wide gaps, unless an operator or an open bracket spans the gap.
fn cells(line: &str) -> Vec<Cell> {
    let mut cells: Vec<Cell> = Vec::new();
    let mut column = 0;
    for part in line.split("  ") {
        let text = part.trim();
        if !text.is_empty() {
            let begin = column + part.len() - part.trim_start().len();
            match cells.last_mut() {
                Some(last) if is_torn(&last.text, text) => last.text = format!("{} {text}", last.text),
                _ => cells.push(Cell { column: begin, text: text.to_owned() }),
            }
        }
        column += part.len() + 2;
    }
    cells
}

fn is_torn(left: &str, right: &str) -> bool {
    depth(left) > 0
        || left.ends_with(['=', '<', '>', '+', '-', '*', '/'])
        || right.starts_with(['=', '<', '>', '!', '~', '+', '*', '/', '^', ')'])
        || right.starts_with("- ")
        || right.starts_with("->")
        || right.starts_with(":=")
}

/// Number of open brackets at the end.
fn depth(text: &str) -> i32 {
    text.chars().map(|c| if "([{".contains(c) { 1 } else { -i32::from(")]}".contains(c)) }).sum()
}

/// Whether it is the number of an equation, such as `(5.1)` or `(7.30), (7.31)`.
fn is_number(text: &str) -> bool {
    let is_one = |part: &str| {
        let inner = part.trim().strip_prefix('(').and_then(|part| part.strip_suffix(')')).unwrap_or_default();
        let digits = inner.trim_end_matches(|c: char| c.is_ascii_lowercase());
        inner.len() - digits.len() <= 1
            && digits.starts_with(|c: char| c.is_ascii_digit())
            && digits.split('.').all(|part| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit()))
    };
    text.replace(" to ", ",").replace(" and ", ",").replace(")-(", "),(").split(',').all(is_one)
}

/// Whether a word is a plain one: letters that are neither a function nor a symbol.
fn is_plain(word: &str, symbols: &Symbols) -> bool {
    let word = word.trim_end_matches(['.', ',', ';', ':', '?']);
    let is_known = is_function(word) || greek(word).is_some() || is_differential(word) || symbols.contains(word);
    let is_spelled = word.split('-').all(|part| !part.is_empty() && part.bytes().all(|b| b.is_ascii_alphabetic()));
    word.len() > 1 && is_spelled && !is_known
}

fn leads_with_operator(text: &str) -> bool {
    matches!(token::tokens(text).ok().as_deref(), Some([first, ..]) if matches!(first.word, Word::Operator(_)))
}

/// Whether there is a relation outside brackets.
fn has_relation(text: &str) -> bool {
    let mut depth = 0;
    token::tokens(text).unwrap_or_default().iter().any(|token| {
        match token.word {
            Word::Open(_) => depth += 1,
            Word::Close(_) => depth -= 1,
            Word::Operator(sign) => return depth == 0 && grammar::is_relation(sign),
            _ => (),
        }
        false
    })
}

/// The elements of a row of the table.
#[derive(Default)]
struct Row {
    left: String,
    right: String,
    condition: String,
    number: String,
}

impl Row {
    fn html(&self) -> String {
        let math = |elements: &str| match elements {
            "" => String::new(),
            elements => format!("<math displaystyle=\"true\">{elements}</math>"),
        };
        let Row { left, right, condition, number } = self;
        let (left, right) = (math(left), math(right));
        let right = match condition.as_str() {
            // A cell without a condition has more room.
            "" => format!("<td class=\"right\" colspan=\"2\">{right}</td>"),
            condition => format!("<td class=\"right\">{right}</td><td class=\"condition\">{}</td>", math(condition)),
        };
        format!("<tr><td class=\"left\">{left}</td>{right}<td class=\"number\">{number}</td></tr>\n")
    }
}

fn row(line: &Line, symbols: &Symbols) -> Result<Row, String> {
    let mut row = Row { number: line.number.clone().unwrap_or_default(), ..Row::default() };
    let mut cells: Vec<&str> = line.cells.iter().map(|cell| cell.text.as_str()).collect();
    // A name before an equation says when it holds, as a condition after it does.
    if cells.len() > 1 && cells[0].ends_with(':') {
        cells.rotate_left(1);
    }
    (row.left, row.right) = equation(cells[0], line.indent > 0, symbols)?;
    for pair in cells.windows(2) {
        let is_equation = pair[0].ends_with([',', ';']) && has_relation(pair[1]);
        let (target, space) =
            if is_equation { (&mut row.right, WIDE_SPACE) } else { (&mut row.condition, NARROW_SPACE) };
        if !target.is_empty() {
            *target += space;
        }
        *target += &elements(&pieces(pair[1].trim_end_matches(':'), symbols)?);
    }
    Ok(row)
}

/// Left and right side of the first cell.
fn equation(text: &str, is_indented: bool, symbols: &Symbols) -> Result<(String, String), String> {
    if leads_with_operator(text) && (!has_relation(text) || starts_with_relation(text)) {
        return Ok((String::new(), continuation(text, symbols)?));
    }
    let pieces = pieces(text, symbols)?;
    let at = pieces.iter().position(|piece| match piece {
        Piece::Equation(node) => sides(node).is_some(),
        Piece::Relation(_) => true,
        Piece::Words(_) => false,
    });
    let Some(at) = at else {
        let is_right = is_indented || pieces.iter().any(|piece| matches!(piece, Piece::Equation(_)));
        let all = elements(&pieces);
        return Ok(if is_right { (String::new(), all) } else { (all, String::new()) });
    };
    let (left, right) = halves(&pieces[at]);
    Ok((elements(&pieces[..at]) + &left, right + &elements(&pieces[at + 1..])))
}

/// A piece, divided before its relation.
fn halves(piece: &Piece) -> (String, String) {
    let tall = |node: &Node| mathml::elements(node, Fractions::Tall);
    match piece {
        Piece::Equation(node) => {
            let (left, right) = sides(node).unwrap_or((node, Vec::new()));
            (tall(left), right.into_iter().map(tall).collect())
        }
        relation => (String::new(), elements(std::slice::from_ref(relation))),
    }
}

fn starts_with_relation(text: &str) -> bool {
    matches!(
        token::tokens(text).ok().as_deref(),
        Some([first, ..]) if matches!(first.word, Word::Operator(sign) if grammar::is_relation(sign))
    )
}

/// A line that begins with a relation or a sign; a sign is indented further.
fn continuation(text: &str, symbols: &Symbols) -> Result<String, String> {
    let tokens = token::tokens(text)?;
    let Some(Word::Operator(sign)) = tokens.first().map(|token| &token.word) else { return Ok(String::new()) };
    let rest = text.trim_start_matches(|c: char| c.is_ascii_punctuation() && !"(|[{_".contains(c));
    let space = if grammar::is_relation(sign) { "" } else { WIDE_SPACE };
    let sign = escape(sign);
    Ok(format!("{space}<mo form=\"infix\">{sign}</mo>{}", elements(&pieces(rest, symbols)?)))
}

/// The first operand of a relation, and the rest.
fn sides(node: &Node) -> Option<(&Node, Vec<&Node>)> {
    match node {
        Node::Chain(parts) => match parts.as_slice() {
            [left, Node::Operator(sign), ..] if grammar::is_relation(sign) => Some((left, parts[1..].iter().collect())),
            _ => None,
        },
        Node::List(parts) => {
            let (left, mut right) = sides(parts.first()?)?;
            right.extend(&parts[1..]);
            Some((left, right))
        }
        _ => None,
    }
}

/// A part of a cell.
enum Piece {
    Words(String),
    /// A relation one of whose sides is in words.
    Relation(&'static str),
    Equation(Node),
}

/// Divides a cell into plain words and equations.
fn pieces(text: &str, symbols: &Symbols) -> Result<Vec<Piece>, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut pieces = Vec::new();
    let mut rest = words.as_slice();
    while !rest.is_empty() {
        let plain = rest.iter().take_while(|word| is_plain(word, symbols)).count();
        if plain > 0 {
            pieces.push(Piece::Words(rest[..plain].join(" ")));
        }
        let (equation, after) = rest[plain..].split_at(equation_length(&rest[plain..], symbols));
        pieces.extend(mathematics(equation, [!pieces.is_empty(), !after.is_empty()], symbols)?);
        rest = after;
    }
    Ok(pieces)
}

/// Number of words up to a colon or, outside brackets, a plain word.
fn equation_length(words: &[&str], symbols: &Symbols) -> usize {
    let mut open = 0;
    for (at, word) in words.iter().enumerate() {
        if open <= 0 && is_plain(word, symbols) {
            return at;
        }
        open += depth(word);
        if word.ends_with(':') {
            return at + 1;
        }
    }
    words.len()
}

/// An equation between words (`ends` tells at which end there are words), which may be operands of its relations.
fn mathematics(words: &[&str], ends: [bool; 2], symbols: &Symbols) -> Result<Vec<Piece>, String> {
    let mut words = words.to_vec();
    let colon = words.last_mut().and_then(|last| {
        *last = last.strip_suffix(':')?;
        Some(Piece::Words(":".to_owned()))
    });
    let first = words.first().and_then(|word| relation(word)).filter(|_| ends[0]);
    words.drain(..first.iter().count());
    let last = words.last().and_then(|word| relation(word)).filter(|_| ends[1]);
    words.truncate(words.len() - last.iter().count());
    let equation = if words.is_empty() { None } else { Some(grammar::parse(&words.join(" "), symbols)?) };
    let between = [first.map(Piece::Relation), equation.map(Piece::Equation), last.map(Piece::Relation), colon];
    Ok(between.into_iter().flatten().collect())
}

/// The relation, if the word is only that.
fn relation(word: &str) -> Option<&'static str> {
    match token::tokens(word).ok()?.as_slice() {
        [Token { word: Word::Operator(sign), .. }] if grammar::is_relation(sign) => Some(sign),
        _ => None,
    }
}

/// Words are separated from their neighbours by a space.
fn elements(pieces: &[Piece]) -> String {
    let element = |piece: &Piece| match piece {
        Piece::Equation(node) => mathml::elements(node, Fractions::Tall),
        Piece::Relation(sign) => format!("<mo form=\"infix\">{}</mo>", escape(sign)),
        Piece::Words(words) if words == ":" => mathml::text(": "),
        Piece::Words(words) => mathml::text(&format!(" {words} ")),
    };
    pieces.iter().map(element).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of each row of a block: the text in them, without the invisible signs of MathML.
    fn rows(text: &str) -> Vec<[String; 4]> {
        let html = block(text, &Symbols::default()).unwrap();
        let document = roxmltree::Document::parse(&html).unwrap();
        let rows = document.descendants().filter(|node| node.has_tag_name("tr"));
        rows.map(|row| {
            let mut cells = row.children().flat_map(|cell| {
                let text: String =
                    cell.descendants().filter_map(|node| node.text().filter(|_| node.is_text())).collect();
                let text = text.replace(['\u{2061}', '\n'], "").replace('\u{a0}', " ").trim().to_owned();
                let empty = cell.has_attribute("colspan").then(String::new);
                [Some(text), empty].into_iter().flatten()
            });
            [(); 4].map(|()| cells.next().unwrap())
        })
        .collect()
    }

    #[test]
    fn conditions_and_numbers_have_their_columns() {
        let rows = rows("f_f = f_C sgn(v)      v != 0      (5.1)\nf_f = min(|f_e|, f_s)  v  = 0\n");
        assert_eq!(rows[0], ["ff", "=fCsgn(v)", "v\u{2260}0", "(5.1)"]);
        assert_eq!(rows[1], ["ff", "=min(|fe|,fs)", "v=0", ""]);
    }

    #[test]
    fn aligned_relations_do_not_divide_an_equation() {
        assert_eq!(rows("v   = x - y")[0], ["v", "=x\u{2212}y", "", ""]);
        assert_eq!(rows("a = b +  c   d  > 0")[0], ["a", "=b+c", "d>0", ""]);
    }

    #[test]
    fn lines_that_begin_with_a_sign_or_a_relation_continue() {
        let rows = rows("f = a     (1.2)\n  + b\n  - c c > 0\n  = d    otherwise\n");
        assert_eq!(rows[0], ["f", "=a", "", "(1.2)"]);
        assert_eq!(rows[1], ["", "+b", "", ""]);
        assert_eq!(rows[2], ["\u{2212}cc", ">0", "", ""], "with a relation inside it is an equation of its own");
        assert_eq!(rows[3], ["", "=d", "otherwise", ""]);
    }

    #[test]
    fn indented_lines_are_joined_or_are_cases() {
        assert_eq!(rows("f = a\n    b").len(), 1);
        assert_eq!(rows("f = (a +\nb)")[0][1], "=(a+b)");
        assert_eq!(rows("f = a\n  / b")[0], ["f", "=ab", "", ""]);
        let cases = rows("f = a    if v > 0\n    b    else\n         w > 0");
        assert_eq!(cases[1], ["", "b", "else w>0", ""]);
        assert_eq!(cases.len(), 2);
    }

    #[test]
    fn names_before_an_equation_are_conditions() {
        assert_eq!(rows("stuck:  z = x")[0], ["z", "=x", "stuck", ""]);
        assert_eq!(rows("initial stiffness:  1 / x")[0], ["", "1x", "initial stiffness", ""]);
        assert_eq!(rows("v >= w:  z = x")[0], ["z", "=x", "v\u{2265}w", ""]);
    }

    #[test]
    fn words_may_be_operands() {
        assert_eq!(rows("s = integral of |v| dt")[0], ["s", "= integral of |v|dt", "", ""]);
        assert_eq!(rows("stuck -> slipping    f > f_s")[0], ["stuck", "\u{2192} slipping", "f>fs", ""]);
        assert_eq!(rows("a = b    all at x(0)")[0][2], "all at x(0)");
    }

    #[test]
    fn several_equations_share_a_line() {
        assert_eq!(rows("a = b,   c = d,  e = f    g > 0")[0], ["a", "=b,c=d,e=f", "g>0", ""]);
    }

    #[test]
    fn numbers_of_equations_are_known() {
        for number in ["(5.1)", "(7.12a)", "(3)", "(6.8), (6.9)", "(7.30)-(7.32)", "(6.8) to (6.10)"] {
            assert!(is_number(number), "{number}");
        }
        for other in ["(v > 0)", "(x)", "()", "5.1", "(5.)", "(stuck)"] {
            assert!(!is_number(other), "{other}");
        }
    }

    #[test]
    fn faults_name_the_line() {
        let faults = block("a = b\nf = a +\ng = (b\nh = sigam x\n", &Symbols::default()).unwrap_err();
        assert_eq!(faults.len(), 2, "{faults:?}");
        assert_eq!(faults[0], "an operand is missing at the end in `f = a +`");
        assert!(faults[1].contains("`g = (b h = sigam x`"), "{}", faults[1]);
    }
}
