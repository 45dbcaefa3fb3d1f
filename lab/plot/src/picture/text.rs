//! Texts of pictures: font, widths.

use std::sync::{Arc, LazyLock};

use resvg::usvg::fontdb::Database;
use resvg::usvg::{Node, Options, Tree};
use stribeck_draw::text::escape;

/// Fonts of texts in a picture, the first that a viewer has. Widths are those of the first, which is among the wide ones.
pub const FAMILY: &str = "'Noto Sans', Arial, Helvetica, sans-serif";

/// Reads pictures with the fonts that come with the program, not those of the machine.
pub static READER: LazyLock<Options> = LazyLock::new(|| {
    let mut fonts = Database::new();
    fonts.load_font_data(include_bytes!("font/noto_sans.ttf").to_vec());
    fonts.load_font_data(include_bytes!("font/noto_sans_italic.ttf").to_vec());
    fonts.set_sans_serif_family("Noto Sans");
    Options { fontdb: Arc::new(fonts), font_family: "Noto Sans".to_owned(), ..Options::default() }
});

/// Size in which texts are measured.
const MEASURED: f64 = 100.0;

/// Width of a text in a font of this size.
pub fn width(text: &str, size: f64) -> f64 {
    let shown = escape(text);
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">\
         <text font-family=\"{FAMILY}\" font-size=\"{MEASURED}\">{shown}</text></svg>"
    );
    let tree = Tree::from_str(&svg, &READER).ok();
    let measured = tree.and_then(|tree| match tree.root().children().first() {
        Some(Node::Text(text)) => Some(f64::from(text.bounding_box().width())),
        _ => None,
    });
    // Letters that the font does not have are as wide as high.
    measured.unwrap_or(MEASURED * text.chars().count() as f64) * size / MEASURED
}

/// A text cut to a width, with an ellipsis if something is missing.
pub fn fitted(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    let cut = |count: usize| letters[..count].iter().collect::<String>() + "\u{2026}";
    let (mut fits, mut too_long) = (0, letters.len());
    while too_long - fits > 1 {
        let middle = (fits + too_long) / 2;
        if width(&cut(middle), size) <= room { fits = middle } else { too_long = middle }
    }
    cut(fits)
}
