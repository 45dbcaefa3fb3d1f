//! A diagram as SVG: axes with units, a grid, curves, a legend.
//!
//! It is written here rather than by a crate for plots: those at hand place points on whole pixels, draw a dashed curve
//! as many short ones, and know no colours that follow the reader's choice of light or dark.

pub use stribeck_draw::axis::Axis;
use stribeck_draw::curve::{self, Point};
use stribeck_draw::frame::Frame;
use stribeck_draw::text::escape;

use super::quantity::Quantity;
use super::text::{FAMILY, fitted, width};
use crate::palette::{DASHES, Theme};

/// Width of the drawing in its own units, and millimetres per unit: 150 mm is a column of a thesis.
const WIDTH: f64 = 600.0;
const MILLIMETRES: f64 = 0.25;
/// Height of the frame of residuals, and space between the frames.
const RESIDUALS: f64 = 105.0;
const GAP: f64 = 14.0;
/// Height of the frame, space above it, space right of it, smallest space left of it.
const FRAME: f64 = 290.0;
const ABOVE: f64 = 34.0;
const RIGHT: f64 = 16.0;
const LEFT: f64 = 66.0;
/// Baselines below the frame: numbers of ticks, name of the axis, first row of the legend; distance of its rows; margin.
const TICKS: f64 = 17.0;
const NAME: f64 = 38.0;
const LEGEND: f64 = 64.0;
const ROW: f64 = 19.0;
const MARGIN: f64 = 10.0;
/// Sizes of letters: 9 to 10 points in print.
const TITLE_SIZE: f64 = 14.0;
const NAME_SIZE: f64 = 13.0;
const TICK_SIZE: f64 = 12.0;
/// Width and opacity of a band (chosen).
const BAND: f64 = 5.0;
const PALE: f64 = 0.4;
/// Legend: length of a sample, space behind it, between entries.
const SAMPLE: f64 = 34.0;
const BEHIND: f64 = 7.0;
const BETWEEN: f64 = 20.0;

/// Sample of a curve in the legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sample {
    /// A piece of its line.
    #[default]
    Line,
    /// One of its crosses.
    Cross,
    /// One of its error bars.
    Bar,
}

impl Sample {
    /// Its path, in the middle of the length of a sample that begins there.
    fn path(self, x: f64, y: f64) -> String {
        let middle = x + 0.5 * SAMPLE;
        match self {
            Sample::Line => format!("M{x:.2} {y:.2}H{:.2}", x + SAMPLE),
            Sample::Cross => cross(middle, y),
            Sample::Bar => format!("M{:.2} {:.2}h8m-4 0v12m-4 0h8m0 -6h-8", middle - 4.0, y - 6.0),
        }
    }
}

/// Path of a cross with its middle there.
fn cross(x: f64, y: f64) -> String {
    format!("M{:.2} {:.2}l9 9m0 -9l-9 9", x - 4.5, y - 4.5)
}

/// A curve with its name.
#[derive(Default)]
pub struct Line {
    /// Name in the legend; without one it has no entry.
    pub name: String,
    /// Points in the units of the axes.
    pub points: Vec<Point>,
    /// Whether its run ended early: the curve ends with a cross.
    pub is_cut: bool,
    /// Number of its colour and dashes; that of the curve in the picture if there is none.
    pub look: Option<usize>,
    /// Its sample in the legend.
    pub sample: Sample,
    /// Whether it is pale and wide: other curves show on it, even where they lie on its middle.
    pub is_band: bool,
}

/// Residuals in a frame of their own below the curves.
pub struct Residuals {
    /// Horizontal axis, that of the curves, and vertical axis.
    pub axes: [Axis; 2],
    /// Residuals, with the looks of their curves.
    pub lines: Vec<Line>,
}

/// A diagram.
pub struct Drawing<'a> {
    /// Title above the diagram.
    pub title: &'a str,
    /// Quantities of the horizontal and of the vertical axis.
    pub quantities: [Quantity; 2],
    /// Horizontal and vertical axis.
    pub axes: &'a [Axis; 2],
    /// Lines, in the order of the legend.
    pub lines: &'a [Line],
    /// Residuals, if there are some.
    pub residuals: Option<&'a Residuals>,
    /// Colours.
    pub theme: Theme,
}

/// A frame with its axes, the name of the vertical one, and its lines.
struct Pane<'a> {
    frame: Frame,
    axes: &'a [Axis; 2],
    up: String,
    lines: &'a [Line],
    /// Whether they are residuals: thin, and without dashes, which noise hides.
    is_below: bool,
}

impl Drawing<'_> {
    /// The picture.
    pub fn svg(&self) -> String {
        let panes = self.panes();
        let last = panes[panes.len() - 1].frame;
        let legend = Legend::of(&self.named(), &last);
        let height = last.bottom + LEGEND + ROW * (legend.rows as f64 - 1.0) + MARGIN;
        let (paper, texts) = (self.paper(height), self.texts(&panes));
        let grid: String = panes.iter().map(|pane| self.grid(pane)).collect();
        let curves: String = panes.iter().map(|pane| self.curves(pane)).collect();
        format!("{paper}{grid}{texts}{curves}{}</svg>\n", self.legend(&last, &legend))
    }

    /// The frame of the curves, and below it that of the residuals, which ends at the same left and right edge.
    fn panes(&self) -> Vec<Pane<'_>> {
        let ticks = || self.axes[1].ticks().chain(self.residuals.into_iter().flat_map(|below| below.axes[1].ticks()));
        let widest = ticks().map(|(_, text)| width(&text, TICK_SIZE)).fold(0.0, f64::max);
        let last = self.axes[0].ticks().last();
        let beyond = last.map_or(0.0, |(place, text)| 0.5 * width(&text, TICK_SIZE) - (1.0 - place) * WIDTH);
        let left = LEFT.max(widest + 38.0);
        let frame = Frame { left, right: WIDTH - RIGHT.max(beyond + 6.0), top: ABOVE, bottom: ABOVE + FRAME };
        let up = name(self.quantities[1], &self.axes[1]);
        let curves = Pane { frame, axes: self.axes, up, lines: self.lines, is_below: false };
        let below = self.residuals.map(|Residuals { axes, lines }| {
            let top = frame.bottom + GAP;
            let up = format!("Residual{}", escape(&axes[1].counted()));
            Pane { frame: Frame { top, bottom: top + RESIDUALS, ..frame }, axes, up, lines, is_below: true }
        });
        std::iter::once(curves).chain(below).collect()
    }

    /// The lines of the legend with their numbers.
    fn named(&self) -> Vec<(usize, &Line)> {
        self.lines.iter().enumerate().filter(|(_, line)| !line.name.is_empty()).collect()
    }

    /// The beginning of the picture with its background.
    fn paper(&self, height: f64) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"picture\" viewBox=\"0 0 {WIDTH} {height}\" \
             width=\"{}mm\" height=\"{}mm\" role=\"img\" aria-label=\"{}\" font-family=\"{FAMILY}\">\n{}\
             <rect class=\"paper\" width=\"{WIDTH}\" height=\"{}\" fill=\"{}\"/>\n",
            WIDTH * MILLIMETRES,
            height * MILLIMETRES,
            escape(self.title),
            self.theme.rules(),
            // A little more, so that it covers the last row of pixels of a PNG.
            height + ROW,
            self.theme.colours().paper
        )
    }

    fn grid(&self, Pane { frame, axes, .. }: &Pane) -> String {
        let colours = self.theme.colours();
        let (grid, edges, zero) = (frame.grid(axes), frame.edges(), frame.zero_up(axes));
        format!(
            "<path class=\"grid\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.7\" d=\"{grid}\"/>\n\
             <path class=\"axis\" fill=\"none\" stroke=\"{}\" d=\"{edges}{zero}\" stroke-width=\"0.9\"/>\n",
            colours.grid, colours.axis
        )
    }

    /// Title, numbers and names; those of the horizontal axis below the last frame.
    fn texts(&self, panes: &[Pane]) -> String {
        let Frame { left, right, bottom, .. } = panes[panes.len() - 1].frame;
        let title = escape(&fitted(self.title, TITLE_SIZE, WIDTH - left - MARGIN));
        let across = name(self.quantities[0], &self.axes[0]);
        let numbers = |Pane { frame, axes, .. }: &Pane| {
            let numbers = frame.numbers_up(axes, 7.0, 4.2);
            format!("<g class=\"y\" font-size=\"{TICK_SIZE}\" text-anchor=\"end\">\n{numbers}</g>\n")
        };
        let up = |Pane { frame, up, .. }: &Pane| {
            let middle = 0.5 * (frame.top + frame.bottom);
            format!("<text transform=\"translate(18 {middle}) rotate(-90)\">{up}</text>\n")
        };
        format!(
            "<g class=\"ink\" fill=\"{}\">\n\
             <text class=\"title\" x=\"{left:.2}\" y=\"20\" font-size=\"{TITLE_SIZE}\">{title}</text>\n\
             <g class=\"x\" font-size=\"{TICK_SIZE}\" text-anchor=\"middle\">\n{}</g>\n\
             {}<g class=\"names\" font-size=\"{NAME_SIZE}\" text-anchor=\"middle\">\n\
             <text x=\"{:.2}\" y=\"{}\">{across}</text>\n{}</g>\n</g>\n",
            self.theme.colours().ink,
            panes[panes.len() - 1].frame.numbers_across(self.axes, TICKS),
            panes.iter().map(numbers).collect::<String>(),
            0.5 * (left + right),
            bottom + NAME,
            panes.iter().map(up).collect::<String>()
        )
    }

    fn curves(&self, pane: &Pane) -> String {
        let Pane { frame, axes, lines, is_below, .. } = pane;
        let is_over_time = self.quantities[0] == Quantity::Time;
        let (class, wide) = if *is_below { ("residual", 1.0) } else { ("law", 1.8) };
        let curve = |(number, line): (usize, &Line)| {
            let points = line.points.iter().map(|point| frame.place(axes, *point));
            let data = if is_over_time { curve::over_time(points) } else { curve::going_round(points) };
            let look = line.look.unwrap_or(number);
            let stroke = if *is_below { self.colour(look) } else { self.stroke(line, look) };
            format!("<path class=\"{class} law-{}\" {stroke} d=\"{data}\"/>\n", look + 1)
        };
        let curves: String = lines.iter().enumerate().map(curve).collect();
        let cut = lines.iter().enumerate().filter(|(_, line)| line.is_cut);
        let crosses: String = cut.filter_map(|(number, line)| self.cross(pane, line, number)).collect();
        format!(
            "<g class=\"curves\" fill=\"none\" stroke-width=\"{wide}\" stroke-linejoin=\"round\">\n\
             {curves}{crosses}</g>\n"
        )
    }

    /// A cross at the end of a curve.
    fn cross(&self, Pane { frame, axes, .. }: &Pane, line: &Line, number: usize) -> Option<String> {
        let look = line.look.unwrap_or(number);
        let is_finite = |point: &&Point| point.iter().all(|value| value.is_finite());
        let [x, y] = frame.place(axes, *line.points.iter().rev().find(is_finite)?);
        Some(format!("<path class=\"stop law-{}\" {} d=\"{}\"/>\n", look + 1, self.colour(look), cross(x, y)))
    }

    fn colour(&self, look: usize) -> String {
        format!("stroke=\"{}\"", self.theme.colours().laws[look])
    }

    /// Colour, dashes and width of a line.
    fn stroke(&self, line: &Line, look: usize) -> String {
        let colour = self.colour(look);
        match DASHES[look] {
            _ if line.is_band => {
                format!("{colour} stroke-width=\"{BAND}\" stroke-linecap=\"round\" stroke-opacity=\"{PALE}\"")
            }
            "" => colour,
            dashes => format!("{colour} stroke-dasharray=\"{dashes}\""),
        }
    }

    fn legend(&self, frame: &Frame, legend: &Legend) -> String {
        let ink = self.theme.colours().ink;
        let entry = |(number, (line_number, line)): (usize, &(usize, &Line))| {
            let x = frame.left + legend.column * (number % legend.columns) as f64;
            let y = frame.bottom + LEGEND + ROW * (number / legend.columns) as f64;
            let (sample, text) = (line.sample.path(x, y - 4.2), x + SAMPLE + BEHIND);
            let look = line.look.unwrap_or(*line_number);
            let (class, stroke) = (look + 1, self.stroke(line, look));
            let name = escape(&fitted(&line.name, TICK_SIZE, legend.column - SAMPLE - BEHIND));
            format!(
                "<g class=\"entry\"><path class=\"law-{class}\" {stroke} d=\"{sample}\"/>\
                 <text class=\"ink\" fill=\"{ink}\" x=\"{text:.2}\" y=\"{y:.2}\">{name}</text></g>\n"
            )
        };
        let entries: String = self.named().iter().enumerate().map(entry).collect();
        format!("<g class=\"legend\" fill=\"none\" stroke-width=\"1.8\" font-size=\"{TICK_SIZE}\">\n{entries}</g>\n")
    }
}

/// Places of the entries of a legend below the frame.
struct Legend {
    columns: usize,
    rows: usize,
    /// Width of a column.
    column: f64,
}

impl Legend {
    fn of(lines: &[(usize, &Line)], frame: &Frame) -> Legend {
        let room = frame.right - frame.left;
        let widest = lines.iter().map(|(_, line)| width(&line.name, TICK_SIZE)).fold(0.0, f64::max);
        let column = (SAMPLE + BEHIND + widest + 0.5).min(room);
        let columns = (((room + BETWEEN) / (column + BETWEEN)) as usize).clamp(1, lines.len().max(1));
        let rows = lines.len().div_ceil(columns).max(1);
        let columns = lines.len().div_ceil(rows).max(1);
        // Entries stand where those of a full width would.
        let spread =
            if columns > 1 { ((room - column) / (columns - 1) as f64).min(column + 2.0 * BETWEEN) } else { room };
        Legend { columns, rows, column: spread.max(column) }
    }
}

/// Name of an axis: quantity, letter in italics with its index, unit.
fn name(quantity: Quantity, axis: &Axis) -> String {
    let (name, letter, index) = quantity.names();
    let mut text = format!("{name} <tspan font-style=\"italic\">{letter}</tspan>");
    if !index.is_empty() {
        text += &format!("<tspan dy=\"3\" font-size=\"{}\">{index}</tspan>", 0.75 * NAME_SIZE);
    }
    let rest = escape(&axis.counted());
    match index {
        "" => text + &rest,
        // A space that begins an element is not drawn by all programs.
        _ => text + " <tspan dy=\"-3\">" + rest.trim_start() + "</tspan>",
    }
}
