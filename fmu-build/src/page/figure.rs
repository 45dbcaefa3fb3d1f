//! A diagram as SVG inside a page: axes with ticks and units, curves, a legend.
//!
//! Colours and font are those of the page (classes in style.css), so it follows the reader's choice of light or dark.

use stribeck_draw::axis::Axis;
use stribeck_draw::curve::{going_round, over_time};
use stribeck_draw::frame::Frame;
use stribeck_draw::text::escape;

use crate::page::curve::{Curve, limits};

/// Size of the drawing in its own units, which are pixels if the page has room.
const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 350.0;
/// The frame: beside it ticks and names have their place.
const FRAME: Frame = Frame { left: 62.0, right: WIDTH - 18.0, top: 34.0, bottom: HEIGHT - 48.0 };

/// Quantity on an axis.
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
}

/// Role of a curve; determines its colour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Style {
    /// The main curve.
    First,
    /// A second one.
    Second,
    /// A filled region.
    Region,
}

/// A curve or a region with its name; curves of the same name share a legend entry.
pub struct Line {
    /// Name in the legend; none if empty.
    pub name: String,
    /// Its style.
    pub style: Style,
    /// Its points.
    pub points: Curve,
}

/// A diagram.
pub struct Figure {
    /// Its caption.
    pub caption: String,
    /// The quantities on the axes: right, up.
    pub quantities: [Quantity; 2],
    /// The curves, in SI units.
    pub lines: Vec<Line>,
}

/// The diagram as a `figure` element: the drawing, the legend and the caption.
pub fn html(figure: &Figure) -> String {
    let caption = format!("<figcaption>{}</figcaption>\n", escape(&figure.caption));
    format!("<figure class=\"diagram\">\n{}{}{caption}</figure>\n", svg(figure), legend(&figure.lines))
}

fn svg(figure: &Figure) -> String {
    let Figure { caption, quantities, lines } = figure;
    let range = |axis: usize| limits(lines.iter().map(|line| &line.points), axis);
    let axes =
        [Axis::new(quantities[0].unit, range(0), 8.0, true), Axis::new(quantities[1].unit, range(1), 8.0, false)];
    // Regions below the curves.
    let (regions, curves): (Vec<_>, Vec<_>) = lines.iter().partition(|line| line.style == Style::Region);
    let paths: String = regions.into_iter().chain(curves).map(|line| path(line, &axes)).collect();
    format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" \
         aria-label=\"{}\">\n{}{}{paths}</svg>\n",
        escape(caption),
        grid(&axes),
        names(quantities, &axes)
    )
}

fn grid(axes: &[Axis; 2]) -> String {
    let (grid, edges, zero) = (FRAME.grid(axes), FRAME.edges(), FRAME.zero_across(axes) + &FRAME.zero_up(axes));
    let (across, up) = (FRAME.numbers_across(axes, 18.0), FRAME.numbers_up(axes, 8.0, 4.0));
    format!(
        "<path d=\"{grid}\"/>\n<path class=\"axis\" d=\"{edges}{zero}\"/>\n\
         <g class=\"x\">\n{across}</g>\n<g class=\"y\">\n{up}</g>\n"
    )
}

fn names(quantities: &[Quantity; 2], axes: &[Axis; 2]) -> String {
    let [right, up] = [0, 1].map(|axis| escape(&format!("{}{}", quantities[axis].name, axes[axis].counted())));
    let (x, y) = (0.5 * (FRAME.left + FRAME.right), HEIGHT - 8.0);
    format!("<text class=\"x\" x=\"{x:.2}\" y=\"{y}\">{right}</text>\n<text x=\"8\" y=\"16\">{up}</text>\n")
}

fn path(line: &Line, axes: &[Axis; 2]) -> String {
    let points = line.points.iter().map(|point| FRAME.place(axes, *point));
    let data = if line.style == Style::Region { over_time(points) + "Z" } else { going_round(points) };
    format!("<path class=\"{}\" d=\"{data}\"/>\n", class_name(line.style))
}

fn class_name(style: Style) -> &'static str {
    match style {
        Style::First => "first",
        Style::Second => "second",
        Style::Region => "region",
    }
}

/// One entry per name, if there is more than one.
fn legend(lines: &[Line]) -> String {
    let mut entries: Vec<&Line> = Vec::new();
    for line in lines.iter().filter(|line| !line.name.is_empty()) {
        if entries.iter().all(|entry| entry.name != line.name) {
            entries.push(line);
        }
    }
    if entries.len() < 2 {
        return String::new();
    }
    entries.sort_by_key(|entry| entry.style);
    let entry = |line: &&Line| {
        let class = class_name(line.style);
        format!("<span class=\"key\"><span class=\"{class}\"></span>{}</span>", escape(&line.name))
    };
    format!("<p class=\"legend\">{}</p>\n", entries.iter().map(entry).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::abs_diff_eq;
    use roxmltree::{Document, Node};

    fn figure(points: Curve) -> Figure {
        let lines = vec![Line { name: "a < b".into(), style: Style::First, points }];
        let quantities = ["x", "y"].map(|name| Quantity { name: name.into(), unit: "m" });
        Figure { caption: "This & that.".into(), quantities, lines }
    }

    /// Places of the ticks of an axis and the numbers beside them.
    fn ticks(document: &Document, class: &str, attribute: &str) -> Vec<[f64; 2]> {
        let is_tick = |node: &Node| {
            let is_in_group = |group: Node| group.has_tag_name("g") && group.attribute("class") == Some(class);
            node.has_tag_name("text") && node.parent().is_some_and(is_in_group)
        };
        let number = |node: Node| node.text().unwrap().replace('\u{2212}', "-").parse::<f64>().unwrap();
        let place = |node: Node| node.attribute(attribute).unwrap().parse::<f64>().unwrap();
        document.descendants().filter(is_tick).map(|node| [place(node), number(node)]).collect()
    }

    /// The line through the outermost ticks.
    fn reader(ticks: Vec<[f64; 2]>) -> impl Fn(f64) -> f64 {
        let ([place_0, value_0], [place_1, value_1]) = (ticks[0], ticks[ticks.len() - 1]);
        move |place| value_0 + (place - place_0) * (value_1 - value_0) / (place_1 - place_0)
    }

    /// Reads the curve back from the drawing, using only the ticks, as a person with a ruler does.
    fn read_back(svg: &str) -> Curve {
        let document = Document::parse(svg).unwrap();
        let (right, up) = (reader(ticks(&document, "x", "x")), reader(ticks(&document, "y", "y")));
        let is_curve = |node: &Node| node.attribute("class") == Some("first");
        let path = document.descendants().find(is_curve).unwrap().attribute("d").unwrap();
        let points = path.split(['M', 'L']).skip(1);
        let point = |point: &str| {
            let (x, y) = point.split_once(' ').unwrap();
            // The number is a little below its line.
            [right(x.parse().unwrap()), up(y.parse::<f64>().unwrap() + 4.0)]
        };
        points.map(point).collect()
    }

    #[test]
    fn drawing_reproduces_the_data() {
        let points: Curve = (-50..=50).map(|k| [f64::from(k) * 1e-4, (f64::from(k) / 20.0).tanh() * 2e-3]).collect();
        let drawn = read_back(&svg(&figure(points)));
        assert!(drawn.len() > 10);
        for [x, y] in drawn {
            assert!(abs_diff_eq!(y, 2.0 * (x / 2.0).tanh(), epsilon = 1e-3), "{x} {y}");
        }
    }

    /// The curve of a page is that of the model.
    #[test]
    fn page_of_brown_mcphee_shows_its_force() {
        use stribeck::friction::BrownMcPhee;
        use stribeck::model::Law;
        let model = stribeck::catalogue::by_name("BrownMcPhee").unwrap();
        let html = crate::page::diagrams::html(model, stribeck::catalogue::Family::Friction).unwrap();
        let svg = &html[html.find("<svg").unwrap()..html.find("</svg>").unwrap() + 6];
        let drawn = read_back(svg);
        assert!(drawn.len() > 30);
        for [velocity, force] in drawn {
            let mut law = BrownMcPhee { velocity: velocity * 1e-3, ..Default::default() };
            law.output();
            // A fifth of a pixel upwards, and the effect of the slope for as much sideways.
            assert!(
                abs_diff_eq!(force, law.friction_force, epsilon = 0.01),
                "{velocity} mm/s: {force} N, {}",
                law.friction_force
            );
        }
    }

    #[test]
    fn texts_are_escaped_and_single_entries_need_no_legend() {
        let html = html(&figure(vec![[0.0, 0.0], [1.0, 1.0]]));
        assert!(Document::parse(&html).is_ok());
        assert!(html.contains("aria-label=\"This &amp; that.\"") && !html.contains("legend"));
        let line = |name: &str, style| Line { name: name.into(), style, points: Vec::new() };
        let legend = legend(&[line("b", Style::Second), line("a < b", Style::First), line("b", Style::Second)]);
        assert!(legend.find("a &lt; b") < legend.find(">b<").or(legend.find("b</span>")), "{legend}");
        assert_eq!(legend.matches("class=\"key\"").count(), 2);
    }
}
