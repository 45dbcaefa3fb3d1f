//! A page of headings, paragraphs and tables, which is well-formed XML too. Every text is escaped here.

use super::escape;
use crate::picture::Picture;

/// A page under way.
pub struct Page {
    html: String,
}

/// Columns of numbers, whose titles begin with this sign, are aligned to the right.
const NUMBER: char = '#';

/// Columns that a narrow page has room for (chosen).
const FEW: usize = 4;

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

    /// Adds pictures, beside each other where there is room.
    pub fn figures(&mut self, pictures: impl IntoIterator<Item = Picture>) {
        self.raw("<div class=\"figures\">\n");
        pictures.into_iter().for_each(|picture| self.raw(&format!("<figure>\n{}</figure>\n", picture.svg)));
        self.raw("</div>\n");
    }

    /// Adds a table with the titles of its columns and the cells of its rows. On a narrow page each row of many cells is a
    /// list.
    pub fn table<C: AsRef<[String]>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = C>) {
        self.marked_table(head, rows.into_iter().map(|cells| (false, cells)));
    }

    /// As `table`; rows come with whether they have failed.
    pub fn marked_table<C: AsRef<[String]>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = (bool, C)>) {
        self.rows(if head.len() > FEW { "rows" } else { "few" }, head, rows);
    }

    /// Adds a table that stays one on a narrow page, where it is moved to and fro.
    pub fn matrix<C: AsRef<[String]>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = C>) {
        self.rows("matrix", head, rows.into_iter().map(|cells| (false, cells)));
    }

    /// Columns in which no row has an entry are left out.
    fn rows<C: AsRef<[String]>>(&mut self, kind: &str, head: &[&str], rows: impl IntoIterator<Item = (bool, C)>) {
        let rows: Vec<(bool, C)> = rows.into_iter().collect();
        let is_used = |at: &usize| {
            rows.is_empty()
                || rows.iter().any(|(_, cells)| cells.as_ref().get(*at).is_some_and(|cell| !cell.is_empty()))
        };
        let columns: Vec<usize> = (0..head.len()).filter(is_used).collect();
        let title = |at: usize| escape(head[at].trim_start_matches(NUMBER));
        self.raw(&format!("<div class=\"wide\"><table class=\"{kind}\">\n<thead><tr>"));
        for at in &columns {
            self.raw(&format!("<th{}>{}</th>", class(head[*at]), title(*at)));
        }
        self.raw("</tr></thead>\n<tbody>\n");
        for (has_failed, cells) in &rows {
            self.raw(if *has_failed { "<tr class=\"failed\">" } else { "<tr>" });
            for at in &columns {
                let cell = escape(cells.as_ref().get(*at).map_or("", String::as_str));
                self.raw(&format!("<td{} data-title=\"{}\">{cell}</td>", class(head[*at]), title(*at)));
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
