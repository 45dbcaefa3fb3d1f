//! Colours and dashes of the laws in pictures and on the page.

/// For light or dark surroundings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Theme {
    /// Dark curves on white, for print.
    #[default]
    Light,
    /// Light curves on black.
    Dark,
    /// Light or dark as the reader's program is set; light where it does not say.
    Auto,
}

/// Largest number of laws in one picture: so many curves can be told apart.
pub const MOST_LAWS: usize = 8;

/// Dashes of the laws. The first is solid: where curves coincide, it shows between the dashes of the others.
pub const DASHES: [&str; MOST_LAWS] =
    ["", "9 3.5", "2.2 2.2", "10 3 2.2 3", "15 4", "5 2.5", "10 2.5 2 2.5 2 2.5", "1.2 3.2"];

/// Colours of a picture.
pub struct Colours {
    /// Background.
    pub paper: &'static str,
    /// Texts.
    pub ink: &'static str,
    /// Lines of the grid.
    pub grid: &'static str,
    /// Axes.
    pub axis: &'static str,
    /// Curves.
    pub laws: [&'static str; MOST_LAWS],
}

/// The laws have the colours of M. Okabe and K. Ito, "Color universal design" (2008), which the colour-blind can tell
/// apart, but for their yellow, which does not show on white: wine instead.
pub const LIGHT: Colours = Colours {
    paper: "#ffffff",
    ink: "#1a1a1a",
    grid: "#dedede",
    axis: "#7a7a7a",
    laws: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#882255"],
};

/// The same with white for black, which does not show on black.
pub const DARK: Colours = Colours {
    paper: "#11161d",
    ink: "#e6e6e6",
    grid: "#2d343d",
    axis: "#858d97",
    laws: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#ffffff", "#e69f00", "#56b4e9", "#f0e442"],
};

impl Theme {
    /// The colours that a picture is drawn in.
    pub fn colours(self) -> &'static Colours {
        match self {
            Theme::Light | Theme::Auto => &LIGHT,
            Theme::Dark => &DARK,
        }
    }

    /// Rules that override the colours in dark surroundings.
    pub fn rules(self) -> String {
        if self != Theme::Auto {
            return String::new();
        }
        let Colours { paper, ink, grid, axis, laws } = DARK;
        let mut rules = format!(
            ".picture .paper{{fill:{paper}}}.picture .ink{{fill:{ink}}}.picture .grid{{stroke:{grid}}}\
             .picture .axis{{stroke:{axis}}}"
        );
        for (number, colour) in laws.iter().enumerate() {
            rules += &format!(".picture .law-{}{{stroke:{colour}}}", number + 1);
        }
        format!("<style>@media screen and (prefers-color-scheme: dark){{{rules}}}</style>\n")
    }
}
