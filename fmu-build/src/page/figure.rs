//! A diagram as SVG inside a page: axes with ticks and units, curves, a legend.
//!
//! Colours and font are those of the page (classes in style.css), so it follows the reader's choice of light or dark.

use std::fmt::Write;

use stribeck::model::{Kind, Variable};
use stribeck::unit::{UNITS, Unit};

use crate::describe::text;
use crate::page::curve::{Curve, limits};
use crate::page::mathematics::escape;

/// Size of the drawing in its own units, which are pixels if the page has room.
const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 350.0;
/// Space for ticks and names left of the curves, below, above and right of them.
const LEFT: f64 = 62.0;
const BELOW: f64 = 48.0;
const ABOVE: f64 = 34.0;
const RIGHT: f64 = 18.0;

/// An axis: what it shows and in which unit.
pub struct Axis {
    name: String,
    unit: String,
    /// Values shown per SI value.
    factor: f64,
}

/// Role of a curve; determines its colour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Style {
    /// The main curve.
    First,
    /// A second one.
    Second,
    /// A third one.
    Third,
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
    /// The axes: right, up.
    pub axes: [Axis; 2],
    /// The curves.
    pub lines: Vec<Line>,
}

impl Axis {
    /// The axis of a variable with values up to `largest`, in the display unit that gives handy numbers.
    pub fn new(name: &str, variable: &Variable, largest: f64) -> Axis {
        match variable.kind {
            Kind::Real(unit) => Axis::of(name, unit, largest),
            _ => Axis { name: name.to_owned(), unit: String::new(), factor: 1.0 },
        }
    }

    /// The axis of a displacement, which need not be a variable of the model.
    pub fn length(name: &str, largest: f64) -> Axis {
        let unit = UNITS.iter().find(|unit| unit.name == "m").expect("UNITS has the metre");
        Axis::of(name, unit, largest)
    }

    fn of(name: &str, unit: &'static Unit, largest: f64) -> Axis {
        let shown = unit.display.iter().map(|shown| (shown.name, shown.factor));
        let units = [(unit.name, 1.0)].into_iter().chain(shown);
        // From one to a thousand; the SI unit, which is the first, wins a tie.
        let clumsiness = |factor: f64| (largest * factor / 30.0).log10().abs().max(1.5);
        let best = units.min_by(|a, b| clumsiness(a.1).total_cmp(&clumsiness(b.1)));
        let (unit, factor) = best.unwrap_or((unit.name, 1.0));
        Axis { name: name.to_owned(), unit: text::typeset_unit(unit), factor }
    }

    /// The axis of time.
    pub fn time() -> Axis {
        Axis { name: "time".to_owned(), unit: "s".to_owned(), factor: 1.0 }
    }

    fn label(&self) -> String {
        let Axis { name, unit, .. } = self;
        if matches!(unit.as_str(), "" | "1") { name.clone() } else { format!("{name} in {unit}") }
    }
}

/// The range of one axis and its place in the drawing.
struct Scale {
    low: f64,
    high: f64,
    begin: f64,
    end: f64,
    step: f64,
}

impl Scale {
    /// Ends on ticks; about `count` of them.
    fn new([low, high]: [f64; 2], [begin, end]: [f64; 2], count: f64) -> Scale {
        let step = tick_step((high - low) / count);
        // A curve may touch the frame, but its thick line should not lie on it.
        let room = 0.02 * (high - low);
        let (below, above) = (((low - room) / step).floor() * step, ((high + room) / step).ceil() * step);
        // Values that are never negative start on the axis.
        let is_on_axis = low >= 0.0 && below < 0.0;
        Scale { low: if is_on_axis { 0.0 } else { below }, high: above, begin, end, step }
    }

    /// Exactly from end to end, with ticks inside.
    fn tight([low, high]: [f64; 2], [begin, end]: [f64; 2], count: f64) -> Scale {
        Scale { low, high, begin, end, step: tick_step((high - low) / count) }
    }

    fn place(&self, value: f64) -> f64 {
        self.begin + (value - self.low) / (self.high - self.low) * (self.end - self.begin)
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let slack = 1e-9;
        let first = (self.low / self.step - slack).ceil() as i64;
        let last = (self.high / self.step + slack).floor() as i64;
        let step = self.step;
        (first..=last).map(move |k| k as f64 * step)
    }

    /// Decimals that distinguish one tick from the next.
    fn decimals(&self) -> usize {
        (-(self.step * 1.000_001).log10().floor()).max(0.0) as usize
    }
}

/// 1, 2 or 5 times a power of ten, at least `least`.
fn tick_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let digit = [1.0, 2.0, 5.0, 10.0].into_iter().find(|digit| digit * power >= least * (1.0 - 1e-9));
    digit.unwrap_or(10.0) * power
}

/// The diagram as a `figure` element: the drawing, the legend and the caption.
pub fn html(figure: &Figure) -> String {
    let caption = format!("<figcaption>{}</figcaption>\n", escape(&figure.caption));
    format!("<figure class=\"diagram\">\n{}{}{caption}</figure>\n", svg(figure), legend(&figure.lines))
}

fn svg(figure: &Figure) -> String {
    let shown: Vec<Line> = figure.lines.iter().map(|line| in_units(line, &figure.axes)).collect();
    let curves = || shown.iter().map(|line| &line.points);
    let right = Scale::tight(limits(curves(), 0), [LEFT, WIDTH - RIGHT], 8.0);
    let up = Scale::new(limits(curves(), 1), [HEIGHT - BELOW, ABOVE], 6.0);
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" \
         aria-label=\"{}\">\n",
        escape(&figure.caption).replace('"', "&quot;")
    );
    svg += &grid(&right, &up);
    svg += &labels(&figure.axes);
    // Regions below the curves.
    let (regions, lines): (Vec<_>, Vec<_>) = shown.iter().partition(|line| line.style == Style::Region);
    regions.into_iter().chain(lines).for_each(|line| svg += &path(line, &right, &up));
    svg + "</svg>\n"
}

fn in_units(line: &Line, axes: &[Axis; 2]) -> Line {
    let points = line.points.iter().map(|[x, y]| [x * axes[0].factor, y * axes[1].factor]).collect();
    Line { name: line.name.clone(), style: line.style, points }
}

/// Writing to a `String` cannot fail.
fn push(svg: &mut String, text: std::fmt::Arguments) {
    let _ = svg.write_fmt(text);
}

fn grid(right: &Scale, up: &Scale) -> String {
    let mut svg = String::new();
    let (left, bottom, top, end) = (right.begin, up.begin, up.end, right.end);
    for tick in right.ticks() {
        let (x, class) = (right.place(tick), class_of(tick));
        push(&mut svg, format_args!("<path class=\"{class}\" d=\"M{x:.2} {top:.2}V{bottom:.2}\"/>\n"));
        let text = tick_text(tick, right.decimals());
        push(&mut svg, format_args!("<text class=\"x\" x=\"{x:.2}\" y=\"{:.2}\">{text}</text>\n", bottom + 18.0));
    }
    for tick in up.ticks() {
        let (y, class) = (up.place(tick), class_of(tick));
        push(&mut svg, format_args!("<path class=\"{class}\" d=\"M{left:.2} {y:.2}H{end:.2}\"/>\n"));
        let text = tick_text(tick, up.decimals());
        push(&mut svg, format_args!("<text class=\"y\" x=\"{:.2}\" y=\"{:.2}\">{text}</text>\n", left - 8.0, y + 4.0));
    }
    svg
}

fn class_of(tick: f64) -> &'static str {
    if tick == 0.0 { "zero" } else { "grid" }
}

fn tick_text(tick: f64, decimals: usize) -> String {
    // No negative zero.
    format!("{:.decimals$}", tick + 0.0).replace('-', "\u{2212}")
}

fn labels(axes: &[Axis; 2]) -> String {
    let [right, up] = axes.each_ref().map(|axis| escape(&axis.label()));
    let (x, y) = (0.5 * (LEFT + WIDTH - RIGHT), HEIGHT - 8.0);
    format!(
        "<text class=\"x name\" x=\"{x:.2}\" y=\"{y:.2}\">{right}</text>\n\
         <text class=\"name\" x=\"8\" y=\"16\">{up}</text>\n"
    )
}

fn path(line: &Line, right: &Scale, up: &Scale) -> String {
    let points: Vec<[f64; 2]> = line.points.iter().map(|[x, y]| [right.place(*x), up.place(*y)]).collect();
    let mut d = String::new();
    for (at, [x, y]) in thinned(&points).into_iter().enumerate() {
        push(&mut d, format_args!("{}{x:.2} {y:.2}", if at == 0 { "M" } else { "L" }));
    }
    let close = if line.style == Style::Region { "Z" } else { "" };
    format!("<path class=\"{}\" d=\"{d}{close}\"/>\n", class_name(line.style))
}

fn class_name(style: Style) -> &'static str {
    match style {
        Style::First => "first",
        Style::Second => "second",
        Style::Third => "third",
        Style::Region => "region",
    }
}

/// Removes points that make no visible difference: those less than a twentieth of a pixel off the line through others
/// (the method of Ramer, Douglas and Peucker).
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept = vec![false; points.len()];
    let mut spans: Vec<_> = points.len().checked_sub(1).map(|last| (0, last)).into_iter().collect();
    while let Some((begin, end)) = spans.pop() {
        kept[begin] = true;
        kept[end] = true;
        let off = |at: &usize| distance_to_line(points[*at], points[begin], points[end]);
        let farthest = (begin + 1..end).max_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some(at) = farthest.filter(|at| off(at) > 0.05) {
            spans.extend([(begin, at), (at, end)]);
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

fn distance_to_line([x, y]: [f64; 2], [x_0, y_0]: [f64; 2], [x_1, y_1]: [f64; 2]) -> f64 {
    let [right, up] = [x_1 - x_0, y_1 - y_0];
    let length = right.hypot(up);
    let share = if length > 0.0 { ((x - x_0) * right + (y - y_0) * up) / (length * length) } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    (x - x_0 - share * right).hypot(y - y_0 - share * up)
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
        let axes = ["x", "y"].map(|name| Axis { name: name.into(), unit: "m".into(), factor: 1e3 });
        Figure { caption: "This & that.".into(), axes, lines }
    }

    /// Places of the ticks of an axis and the numbers beside them.
    fn ticks(document: &Document, class: &str, attribute: &str) -> Vec<[f64; 2]> {
        let is_tick = |node: &Node| node.has_tag_name("text") && node.attribute("class") == Some(class);
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
    fn ticks_are_round_and_inside() {
        for [low, high] in [[-3.0, 3.0], [-0.004, 0.004], [-4.0, 4.0], [0.0, 0.74], [-1.6e-5, 1.1e-5], [1e3, 9e4]] {
            for scale in [Scale::new([low, high], [0.0, 300.0], 6.0), Scale::tight([low, high], [0.0, 300.0], 8.0)] {
                let ticks: Vec<f64> = scale.ticks().collect();
                assert!((3..=12).contains(&ticks.len()), "{ticks:?}");
                assert!(ticks.iter().all(|tick| (-0.01..=300.01).contains(&scale.place(*tick))), "{ticks:?}");
                let texts: Vec<String> = ticks.iter().map(|tick| tick_text(*tick, scale.decimals())).collect();
                assert!(texts.windows(2).all(|pair| pair[0] != pair[1]), "{texts:?}");
                for (tick, text) in ticks.iter().zip(&texts) {
                    let read: f64 = text.replace('\u{2212}', "-").parse().unwrap();
                    assert!(abs_diff_eq!(read, tick, epsilon = 1e-9 * (high - low)), "{tick} is {text}");
                }
            }
        }
        assert_eq!(tick_text(-0.0, 1), "0.0");
    }

    #[test]
    fn handy_units_are_chosen() {
        let velocity = stribeck::catalogue::by_name("LuGre").unwrap();
        let variable = &velocity.table.at(velocity.find("velocity").unwrap());
        assert_eq!(Axis::new("velocity", variable, 5e-3).label(), "velocity in mm/s");
        assert_eq!(Axis::new("velocity", variable, 1.0).label(), "velocity in m/s");
        assert_eq!(Axis::length("displacement", 3e-5).label(), "displacement in \u{b5}m");
        assert_eq!(Axis::length("displacement", 0.7).label(), "displacement in mm");
    }

    #[test]
    fn thinning_keeps_ends_and_corners() {
        let points = [[0.0, 0.0], [1.0, 0.01], [2.0, 0.0], [3.0, 5.0], [4.0, 5.0]];
        assert_eq!(thinned(&points), [[0.0, 0.0], [2.0, 0.0], [3.0, 5.0], [4.0, 5.0]]);
        assert_eq!(thinned(&[]), Vec::<[f64; 2]>::new());
        // A curve that returns to where it began.
        assert_eq!(thinned(&[[0.0, 0.0], [9.0, 0.0], [0.0, 0.0]]).len(), 3);
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
