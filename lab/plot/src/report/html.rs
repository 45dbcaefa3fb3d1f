//! A page of headings, paragraphs and tables, which is well-formed XML too. Every text is escaped here.

use super::escape;

/// A page under way.
pub struct Page {
    html: String,
}

/// Columns of numbers, whose titles begin with this sign, are aligned to the right.
const NUMBER: char = '#';

impl Page {
    /// A page with a title.
    pub fn new(title: &str, style: &str) -> Page {
        let title = escape(title);
        let html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <title>{title} - Stribeck</title>\n<style>\n{style}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        );
        Page { html }
    }

    /// Begins a chapter.
    pub fn heading(&mut self, text: &str) {
        self.raw(&format!("<h2>{}</h2>\n", escape(text)));
    }

    /// Adds a paragraph of a class.
    pub fn paragraph(&mut self, class: &str, text: &str) {
        self.raw(&format!("<p class=\"{class}\">{}</p>\n", escape(text)));
    }

    /// Adds a text as it is written, unless it is empty.
    pub fn listing(&mut self, text: &str) {
        if !text.is_empty() {
            self.raw(&format!("<pre>{}</pre>\n", escape(text)));
        }
    }

    /// Adds a table with the titles of its columns and the cells of its rows.
    pub fn table<C: AsRef<[String]>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = C>) {
        self.marked_table(head, rows.into_iter().map(|cells| (false, cells)));
    }

    /// As `table`; rows come with whether they have failed.
    pub fn marked_table<C: AsRef<[String]>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = (bool, C)>) {
        self.raw("<div class=\"wide\"><table>\n<thead><tr>");
        for title in head {
            let text = escape(title.trim_start_matches(NUMBER));
            self.raw(&format!("<th{}>{text}</th>", class(title)));
        }
        self.raw("</tr></thead>\n<tbody>\n");
        for (has_failed, cells) in rows {
            self.raw(if has_failed { "<tr class=\"failed\">" } else { "<tr>" });
            for (title, cell) in head.iter().zip(cells.as_ref()) {
                self.raw(&format!("<td{}>{}</td>", class(title), escape(cell)));
            }
            self.raw("</tr>\n");
        }
        self.raw("</tbody>\n</table></div>\n");
    }

    /// Adds HTML.
    pub fn raw(&mut self, html: &str) {
        self.html += html;
    }

    /// The whole page.
    pub fn end(self) -> String {
        self.html + "</body>\n</html>\n"
    }
}

fn class(title: &str) -> &'static str {
    if title.starts_with(NUMBER) { " class=\"number\"" } else { "" }
}
