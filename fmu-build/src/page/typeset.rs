//! The text of a model's page: Markdown to HTML, with equations and symbols as MathML.

use anyhow::{Result, ensure};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeStream, html};
use stribeck_draw::text::typeset_unit;

use crate::page::mathematics::{self, Symbols};

/// The model's text as HTML, one heading level down, and without the example, which is in Rust, whereas this reader has
/// an FMU. The diagrams come before the first heading. Equations in running text stand between dollar signs.
pub fn html(model: &str, documentation: &str, diagrams: &str) -> Result<String> {
    let events = without_example(events(documentation));
    let mut setter = Setter { symbols: symbols(&events), ..Setter::default() };
    let mut set: Vec<Event> = events.into_iter().flat_map(|event| setter.set(event)).collect();
    ensure!(setter.faults.is_empty(), "{model}: not an equation: {}", setter.faults.join("; "));
    let is_heading = |event: &Event| matches!(event, Event::Start(Tag::Heading { .. }));
    let at = set.iter().position(is_heading).unwrap_or(set.len());
    set.insert(at, Event::Html(diagrams.into()));
    let mut page = String::new();
    html::push_html(&mut page, set.into_iter());
    Ok(with_punctuation(&page))
}

const BEGIN: &str = "<span class=\"math\">";
const END: &str = "</span>";

/// Extends equations in running text by the punctuation that no line break may separate from them.
fn with_punctuation(page: &str) -> String {
    let mut parts = page.split(END);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let rest = part.trim_start_matches(['.', ',', ';', ':', ')', '?']);
        text += &part[..part.len() - rest.len()];
        text += END;
        text += rest;
    }
    text.replace(&format!("({BEGIN}"), &format!("{BEGIN}("))
}

/// The parts of the text; a paragraph is one run of text, regardless of line ends.
fn events(documentation: &str) -> Vec<Event<'_>> {
    let parts = Parser::new_ext(documentation, Options::ENABLE_TABLES | Options::ENABLE_MATH);
    let joined = parts.map(|event| match event {
        Event::SoftBreak => Event::Text(" ".into()),
        Event::Start(Tag::Heading { level: HeadingLevel::H1, id, classes, attrs }) => {
            // The page's own title is the first level.
            Event::Start(Tag::Heading { level: HeadingLevel::H2, id, classes, attrs })
        }
        Event::End(TagEnd::Heading(HeadingLevel::H1)) => Event::End(TagEnd::Heading(HeadingLevel::H2)),
        other => other,
    });
    TextMergeStream::new(joined).collect()
}

fn without_example(events: Vec<Event>) -> Vec<Event> {
    let is_example = |at: usize| matches!(&events[at + 1], Event::Text(title) if &**title == "Example");
    let mut keeps = true;
    let mut kept = Vec::new();
    for (at, event) in events.iter().enumerate() {
        if matches!(event, Event::Start(Tag::Heading { .. })) {
            keeps = !is_example(at);
        }
        if keeps {
            kept.push(event.clone());
        }
    }
    kept
}

/// The symbols that the symbol tables define.
fn symbols(events: &[Event]) -> Symbols {
    let mut place = Place::default();
    let mut symbols = Symbols::default();
    for event in events {
        place.enter(event);
        if let Event::Text(text) = event
            && place.is_symbol()
        {
            symbols.add(text);
        }
    }
    symbols
}

/// Place of an event in the text.
#[derive(Default)]
struct Place {
    in_head: bool,
    column: usize,
    /// The column of symbols of the table, and that of units.
    symbols: Option<usize>,
    units: Option<usize>,
    in_equations: bool,
    in_table: bool,
}

impl Place {
    fn enter(&mut self, event: &Event) {
        match event {
            Event::Start(Tag::Table(_)) => (self.in_table, self.symbols, self.units) = (true, None, None),
            Event::End(TagEnd::Table) => self.in_table = false,
            Event::Start(Tag::TableHead) => (self.in_head, self.column) = (true, 0),
            Event::End(TagEnd::TableHead) => self.in_head = false,
            Event::Start(Tag::TableRow) => self.column = 0,
            Event::End(TagEnd::TableCell) => self.column += 1,
            Event::Text(title) if self.in_head && &**title == "symbol" => self.symbols = Some(self.column),
            Event::Text(title) if self.in_head && &**title == "unit" => self.units = Some(self.column),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) if &**language == "text" => {
                self.in_equations = true;
            }
            Event::End(TagEnd::CodeBlock) => self.in_equations = false,
            _ => (),
        }
    }

    fn is_symbol(&self) -> bool {
        self.in_table && !self.in_head && self.symbols == Some(self.column)
    }

    fn is_unit(&self) -> bool {
        self.in_table && !self.in_head && self.units == Some(self.column)
    }
}

/// Replaces equations and symbols by MathML, one event after the other.
#[derive(Default)]
struct Setter {
    place: Place,
    symbols: Symbols,
    faults: Vec<String>,
}

impl Setter {
    fn set<'a>(&mut self, event: Event<'a>) -> Vec<Event<'a>> {
        let was_equations = self.place.in_equations;
        self.place.enter(&event);
        match event {
            Event::Text(text) if self.place.in_equations => vec![self.block(&text)],
            // The block has its own elements.
            Event::Start(Tag::CodeBlock(_)) if self.place.in_equations => Vec::new(),
            Event::End(TagEnd::CodeBlock) if was_equations => Vec::new(),
            // A dash stands for a missing symbol.
            Event::Text(text) if self.place.is_symbol() && &*text != "-" => {
                vec![Event::InlineHtml(self.inline(&text).into())]
            }
            Event::InlineMath(text) => {
                vec![Event::InlineHtml(format!("{BEGIN}{}{END}", self.inline(&text)).into())]
            }
            Event::Text(text) if self.place.is_unit() => vec![Event::Text(typeset_unit(&text).into())],
            other => vec![other],
        }
    }

    fn block(&mut self, text: &str) -> Event<'static> {
        let html = mathematics::block(text, &self.symbols).unwrap_or_else(|faults| {
            self.faults.extend(faults);
            String::new()
        });
        Event::Html(html.into())
    }

    fn inline(&mut self, text: &str) -> String {
        mathematics::inline(text, &self.symbols).unwrap_or_else(|fault| {
            self.faults.push(format!("{fault} in `{text}`"));
            String::new()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str =
        "| symbol | unit | meaning |\n|---|---|---|\n| v_0 | N.s/m | more than $v_0$ |\n| - | m | none |\n";

    #[test]
    fn symbols_are_set_in_tables_and_in_the_text() {
        let page = html("Model", &format!("See ($v_0$), not `v_0`.\n\n{TABLE}"), "").unwrap();
        let symbol = "<math><msub><mi>v</mi><mn>0</mn></msub></math>";
        let text = format!("See <span class=\"math\">({symbol}),</span> not <code>v_0</code>.");
        assert!(page.contains(&text), "{page}");
        let row =
            format!("<td>{symbol}</td><td>N\u{b7}s/m</td><td>more than <span class=\"math\">{symbol}</span></td>");
        assert!(page.contains(&row), "{page}");
        assert!(page.contains("<td>-</td><td>m</td>"), "{page}");
    }

    #[test]
    fn an_equation_may_cross_the_end_of_a_line() {
        let page = html("Model", "where $f(v_0)$ is\n$v_0 -\nv_1$ at most", "").unwrap();
        assert_eq!(page.matches("<math>").count(), 2, "{page}");
    }

    #[test]
    fn faults_name_model_and_line() {
        let text = format!("```text\nf = (a\n```\n\n{}", TABLE.replace("| v_0 |", "| v_ 0 |"));
        let fault = html("Model", &text, "").unwrap_err().to_string();
        assert!(fault.starts_with("Model: not an equation: '(' is never closed in `f = (a`; "), "{fault}");
        assert!(fault.contains("in `v_ 0`"), "{fault}");
    }

    #[test]
    fn example_is_dropped_and_what_follows_is_kept() {
        let page =
            html("Model", "Intro.\n\n# Example\n```\ncode\n```\n# Source\nPaper.\n", "<p>Diagrams</p>\n").unwrap();
        assert_eq!(page, "<p>Intro.</p>\n<p>Diagrams</p>\n<h2>Source</h2>\n<p>Paper.</p>\n");
    }

    /// A symbol with a subscript is code or an equation: no underscore is left in running text, but in addresses.
    #[test]
    fn symbols_in_running_text_are_marked() {
        for entry in crate::describe::entry::entries() {
            let page = format!("<main>{}</main>", html(entry.model.name, entry.documentation, "").unwrap());
            let document = roxmltree::Document::parse(&page).unwrap();
            let paragraphs = document.descendants().filter(|node| node.has_tag_name("p"));
            let texts = paragraphs.flat_map(|paragraph| paragraph.children());
            let texts = texts.filter(roxmltree::Node::is_text).filter_map(|node| node.text());
            let unmarked =
                texts.flat_map(str::split_whitespace).find(|word| word.contains('_') && !word.contains("doi:"));
            assert_eq!(unmarked, None, "{}", entry.model.name);
        }
    }
}
