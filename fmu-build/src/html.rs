//! documentation/index.html of an FMU: the model's own page and tables of its variables and capabilities.
//!
//! The page stands alone: no script, no network, colours that follow the reader's choice of light or dark.

use std::fmt::Write;

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};
use stribeck::model::{Kind, ModelType, Variable};

use crate::project::{AUTHORS, LICENSE, VERSION};
use crate::text;
use crate::xml::CAPABILITIES;

const STYLE: &str = include_str!("style.css");

const ROLES: &str = "Inputs are set before each step. A fixed parameter stays constant during a run, a tunable one may \
    change between steps. States are advanced by the steps; their start values may be set before a run.";

/// The page of a model; `documentation` is its Markdown text.
pub fn page(model: &ModelType, documentation: &str) -> String {
    let mut page = String::new();
    push(&mut page, format_args!("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"));
    push(&mut page, format_args!("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"));
    push(&mut page, format_args!("<title>{} - Stribeck</title>\n<style>\n{STYLE}</style>\n</head>\n", model.name));
    push(&mut page, format_args!("<body>\n<header>\n<img src=\"../model.png\" alt=\"\" width=\"96\" height=\"96\">\n"));
    push(&mut page, format_args!("<div>\n<h1>{}</h1>\n<p>{}</p>\n</div>\n", model.name, escape(model.summary)));
    push(&mut page, format_args!("</header>\n<main>\n{}", markdown(documentation)));
    variables(&mut page, model);
    choices(&mut page, model);
    capabilities(&mut page, model);
    push(&mut page, format_args!("</main>\n<footer>Stribeck {VERSION}, {AUTHORS}. Licence: {LICENSE}, "));
    push(&mut page, format_args!("<a href=\"licenses/license.txt\">text</a>.</footer>\n</body>\n</html>\n"));
    page
}

/// Writing to a `String` cannot fail.
fn push(page: &mut String, text: std::fmt::Arguments) {
    let _ = page.write_fmt(text);
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The model's text as HTML, one heading level down, and without the example: it is in Rust, and this reader has an FMU.
fn markdown(documentation: &str) -> String {
    let mut is_example = false;
    let events: Vec<Event> = Parser::new_ext(documentation, Options::ENABLE_TABLES).collect();
    let kept = events.iter().enumerate().filter(|(at, event)| {
        if matches!(event, Event::Start(Tag::Heading { .. })) {
            is_example = matches!(events.get(at + 1), Some(Event::Text(title)) if &**title == "Example");
        }
        !is_example
    });
    let mut page = String::new();
    html::push_html(&mut page, kept.map(|(_, event)| lowered(event.clone())));
    page
}

/// A first-level heading as a second-level one: the page's own title is the first.
fn lowered(event: Event) -> Event {
    match event {
        Event::Start(Tag::Heading { level: HeadingLevel::H1, id, classes, attrs }) => {
            Event::Start(Tag::Heading { level: HeadingLevel::H2, id, classes, attrs })
        }
        Event::End(TagEnd::Heading(HeadingLevel::H1)) => Event::End(TagEnd::Heading(HeadingLevel::H2)),
        other => other,
    }
}

fn table<R: AsRef<[String]>>(page: &mut String, head: &[&str], rows: impl Iterator<Item = R>) {
    push(page, format_args!("<div class=\"wide\"><table>\n<thead><tr>"));
    head.iter().for_each(|title| push(page, format_args!("<th>{title}</th>")));
    push(page, format_args!("</tr></thead>\n<tbody>\n"));
    for row in rows {
        push(page, format_args!("<tr>"));
        row.as_ref().iter().for_each(|cell| push(page, format_args!("<td>{cell}</td>")));
        push(page, format_args!("</tr>\n"));
    }
    push(page, format_args!("</tbody>\n</table></div>\n"));
}

fn variables(page: &mut String, model: &ModelType) {
    push(page, format_args!("<h2>Variables</h2>\n<p>{ROLES}</p>\n"));
    let head = ["Variable", "Unit", "Start", "Bound", "Meaning", "Role", "Type", "Value reference"];
    table(page, &head, model.table.iter().enumerate().map(variable));
}

fn variable((column, variable): (usize, &Variable)) -> [String; 8] {
    let start = if variable.role.is_computed() { String::new() } else { text::start(variable) };
    [
        format!("<code>{}</code>", variable.path),
        text::unit(variable).to_owned(),
        start,
        escape(&text::bound(variable)),
        escape(variable.help),
        text::role(variable.role).to_owned(),
        text::kind(variable).to_owned(),
        column.to_string(),
    ]
}

/// One table per enumeration of the model.
fn choices(page: &mut String, model: &ModelType) {
    let mut seen = Vec::new();
    for variable in model.table {
        let Kind::Enumeration(choices) = variable.kind else { continue };
        if seen.contains(&choices.name) {
            continue;
        }
        seen.push(choices.name);
        push(page, format_args!("<h2>Choices of {}</h2>\n", choices.name));
        let row = |(number, item): (usize, &stribeck::model::Item)| {
            [(number + 1).to_string(), format!("<code>{}</code>", item.name), escape(item.help)]
        };
        table(page, &["Number", "Choice", "Meaning"], choices.items.iter().enumerate().map(row));
    }
}

fn capabilities(page: &mut String, model: &ModelType) {
    push(page, format_args!("<h2>This FMU</h2>\n"));
    let facts = [
        ("Interface", "FMI 2.0 for Co-Simulation".to_owned()),
        ("Version", VERSION.to_owned()),
        ("Model identifier", format!("<code>{}</code>", model.name)),
        ("Guid", format!("<code>{}</code>", model.guid())),
    ];
    let capabilities = CAPABILITIES.map(|(name, value)| (name, value.to_owned()));
    let rows = facts.into_iter().chain(capabilities).map(|(name, value)| [name.to_owned(), value]);
    table(page, &["Property", "Value"], rows);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::specimen::{SPECIMEN, Specimen};
    use stribeck::catalogue::{Family, documented};
    use stribeck::model::Described;

    #[test]
    fn every_page_is_well_formed_and_lists_every_variable() {
        let specimen = (&SPECIMEN, <Specimen as Described>::DOCUMENTATION);
        for (model, documentation) in documented(Family::Friction).chain(documented(Family::Host)).chain([specimen]) {
            let page = page(model, documentation);
            // The page closes what it opens, so that with closed void elements it is also XML.
            let mut closed = page.clone();
            for void in ["<meta ", "<img "] {
                closed = close(&closed, void);
            }
            let body = closed.trim_start_matches("<!DOCTYPE html>\n");
            let document = roxmltree::Document::parse(body).unwrap_or_else(|error| panic!("{}: {error}", model.name));
            let cells: Vec<_> = document.descendants().filter_map(|node| node.text()).collect();
            for variable in model.table {
                assert!(cells.contains(&variable.path.to_string().as_str()), "{}", variable.path);
            }
        }
    }

    fn close(page: &str, void: &str) -> String {
        let mut parts = page.split(void);
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + void + &part.replacen('>', "/>", 1))
    }

    #[test]
    fn example_is_dropped_and_what_follows_is_kept() {
        let page = markdown("Intro.\n\n# Example\n```\ncode\n```\n# Source\nPaper.\n");
        assert_eq!(page, "<p>Intro.</p>\n<h2>Source</h2>\n<p>Paper.</p>\n");
    }

    #[test]
    fn pages_need_no_network() {
        for (model, documentation) in documented(Family::Friction).chain(documented(Family::Host)) {
            let page = page(model, documentation);
            assert!(!page.contains("src=\"http") && !page.contains("<script") && !page.contains("@import"));
        }
    }
}
