//! Pictures of runs: the usual seven diagrams, with all laws in one, as SVG and PNG.

pub mod drawing;
mod friction_map;
pub mod quantity;
mod text;
mod tyre;
mod zoom;

use std::fmt;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::Tree;

pub use crate::palette::{MOST_LAWS, Theme};
pub(crate) use stribeck_draw::text::{escape, typeset_unit};

use drawing::{Drawing, Line, Residuals};
pub use friction_map::{fitted_curves, friction_map};
pub use tyre::tyre;

use quantity::Quantity;
use stribeck_draw::axis::Axis;
use stribeck_draw::text::digits;
use stribeck_solve::run::Outcome;
use stribeck_solve::solve::End;
use stribeck_solve::system::{Fault, System};
use zoom::Range;

/// Which diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Position over time.
    Position,
    /// Relative velocity over time.
    Velocity,
    /// Acceleration over time.
    Acceleration,
    /// Friction force over time.
    Force,
    /// Friction force over a short time.
    Zoom,
    /// Friction force over relative velocity.
    ForceOverVelocity,
    /// Friction force over displacement.
    ForceOverDisplacement,
    /// Side force of a tyre over side slip.
    SideForce,
    /// Aligning moment of a tyre over side slip.
    AligningMoment,
    /// Longitudinal force of a tyre over longitudinal slip.
    LongitudinalForce,
}

impl Kind {
    /// Those of a run.
    pub const ALL: [Kind; 7] = [
        Kind::Position,
        Kind::Velocity,
        Kind::Acceleration,
        Kind::Force,
        Kind::Zoom,
        Kind::ForceOverVelocity,
        Kind::ForceOverDisplacement,
    ];

    /// What the axes show: to the right, upwards.
    fn quantities(self) -> [Quantity; 2] {
        match self {
            Kind::Position => [Quantity::Time, Quantity::Position],
            Kind::Velocity => [Quantity::Time, Quantity::Velocity],
            Kind::Acceleration => [Quantity::Time, Quantity::Acceleration],
            Kind::Force | Kind::Zoom => [Quantity::Time, Quantity::Force],
            Kind::ForceOverVelocity => [Quantity::Velocity, Quantity::Force],
            Kind::ForceOverDisplacement => [Quantity::Displacement, Quantity::Force],
            Kind::SideForce => [Quantity::SideSlip, Quantity::SideForce],
            Kind::AligningMoment => [Quantity::SideSlip, Quantity::AligningMoment],
            Kind::LongitudinalForce => [Quantity::LongitudinalSlip, Quantity::LongitudinalForce],
        }
    }

    /// Quantities on the axes in these units.
    fn quantities_in(self, [across, up]: [&str; 2]) -> [Quantity; 2] {
        let [to_the_right, upwards] = self.quantities();
        [to_the_right.in_unit(across), upwards.in_unit(up)]
    }
}

/// A diagram of quantities in words.
fn in_words(quantities: [Quantity; 2]) -> String {
    let [across, up] = quantities.map(|quantity| quantity.names().0);
    format!("{up} over {}", across.to_lowercase())
}

/// The name of a kind as part of the name of a file.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Kind::Position => "position",
            Kind::Velocity => "velocity",
            Kind::Acceleration => "acceleration",
            Kind::Force => "force",
            Kind::Zoom => "zoom",
            Kind::ForceOverVelocity => "force-over-velocity",
            Kind::ForceOverDisplacement => "force-over-displacement",
            Kind::SideForce => "side-force",
            Kind::AligningMoment => "aligning-moment",
            Kind::LongitudinalForce => "longitudinal-force",
        })
    }
}

/// How pictures are made.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Light or dark.
    pub theme: Theme,
    /// Time range of the zoom, in s; found automatically if none is given.
    pub zoom: Option<[f64; 2]>,
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Which diagram it is.
    pub kind: Kind,
    /// Its number among those of this kind, from 1.
    pub part: usize,
    /// Number of pictures of this kind: more than one if there are more than [`MOST_LAWS`] laws.
    pub parts: usize,
    /// Its title.
    pub title: String,
    /// The picture.
    pub svg: String,
}

/// Widest PNG, in pixels (chosen).
const WIDEST: u32 = 10_000;

impl Picture {
    /// The picture as PNG of this width in pixels. A picture for light or dark surroundings is light.
    pub fn png(&self, width: u32) -> Result<Vec<u8>, Fault> {
        let wrong = |text: String| Fault::value(format_args!("PNG, width = {width}: {text}"));
        if width == 0 || width > WIDEST {
            return Err(wrong(format!("must be between 1 and {WIDEST} pixels")));
        }
        let tree = Tree::from_str(&self.svg, &text::READER).map_err(|error| wrong(error.to_string()))?;
        let scale = width as f32 / tree.size().width();
        let height = ((tree.size().height() * scale).round() as u32).max(1);
        let mut pixels = Pixmap::new(width, height).ok_or_else(|| wrong("no memory".to_owned()))?;
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| wrong(error.to_string()))
    }

    /// The picture's name as part of the name of a file.
    pub fn name(&self) -> String {
        if self.parts > 1 { format!("{}-{}", self.kind, self.part) } else { self.kind.to_string() }
    }
}

/// A curve with its name.
pub type Named = (String, Vec<[f64; 2]>);

/// A picture of measured friction forces beside others of the same motion, in SI units, as a diagram of this kind, with the
/// residuals, measured less other, below; `title` puts it in words, given those for the diagram, and `unit` has the units of
/// joints in place of those of bodies that slide, if it is of one. As many others as there are colours. None without a
/// finite point.
pub fn beside(
    kind: Kind,
    title: impl FnOnce(&str) -> String,
    measured: Named,
    mut others: Vec<Named>,
    unit: impl Fn(&'static str) -> &'static str,
    theme: Theme,
) -> Option<Picture> {
    others.truncate(MOST_LAWS - 1);
    let less =
        |other: &[[f64; 2]]| measured.1.iter().zip(other).map(|([x, of], [_, other])| [*x, of - other]).collect();
    let residual = |(number, (_, points)): (usize, &Named)| Line {
        points: less(points),
        look: Some(number + 1),
        ..Line::default()
    };
    let residuals: Vec<Line> = others.iter().enumerate().map(residual).collect();
    let line = |(name, points)| Line { name, points, ..Line::default() };
    let mut lines: Vec<Line> = std::iter::once(measured).chain(others).map(line).collect();
    lines[0].is_band = true;
    let is_finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
    lines.iter().flat_map(|line| &line.points).find(|point| is_finite(point))?;
    let units = kind.quantities().map(|quantity| unit(quantity.unit()));
    let quantities = kind.quantities_in(units);
    let title = title(&in_words(quantities));
    let axes = axes(quantities, units, &lines, &None);
    let residuals = Residuals { axes: below(quantities, units, [&lines, &residuals]), lines: residuals };
    let svg =
        Drawing { title: &title, quantities, axes: &axes, lines: &lines, residuals: Some(&residuals), theme }.svg();
    Some(Picture { kind, part: 1, parts: 1, title, svg })
}

/// The name of the variable that a system shows as this quantity.
fn shown(system: &System, quantity: Quantity) -> Option<&str> {
    let show = &system.description.show;
    let named = |key: &str| show.get(key).map(String::as_str);
    match quantity {
        Quantity::Time => None,
        Quantity::Position => named("position"),
        Quantity::Displacement => named("displacement").or_else(|| named("position")),
        Quantity::Velocity => named("velocity"),
        Quantity::Acceleration => named("acceleration"),
        Quantity::Force => named("force"),
        // Of runs, not in them.
        Quantity::Evaluations | Quantity::Error | Quantity::SwitchingError => None,
        Quantity::SideSlip | Quantity::LongitudinalSlip => None,
        Quantity::SideForce | Quantity::LongitudinalForce | Quantity::AligningMoment => None,
        // A system shows them as position, displacement, velocity, acceleration and force.
        Quantity::Angle | Quantity::AngularVelocity | Quantity::AngularAcceleration | Quantity::Torque => None,
    }
}

/// The results of a run that its pictures need.
pub fn needed(system: &System) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for quantity in Kind::ALL.iter().flat_map(|kind| kind.quantities()) {
        if let Some(name) = shown(system, quantity)
            && names.iter().all(|known| known != name)
        {
            names.push(name.to_owned());
        }
    }
    names
}

/// Values and unit of a quantity.
fn values<'a>(system: &System, outcome: &'a Outcome, quantity: Quantity) -> Option<(&'a [f64], &'a str)> {
    if quantity == Quantity::Time {
        return Some((&outcome.time, "s"));
    }
    let name = shown(system, quantity)?;
    let column = outcome.columns.iter().find(|column| column.name == name)?;
    Some((&column.values, &column.unit))
}

/// The pictures of the outcomes, each with the name of its law. Kinds for which the system shows no variable, or no
/// outcome has it, are left out; more than [`MOST_LAWS`] laws are split evenly among pictures with the same axes.
pub fn all(system: &System, outcomes: &[(String, Outcome)], options: &Options) -> Vec<Picture> {
    Kind::ALL.iter().flat_map(|kind| pictures(*kind, system, outcomes, options)).collect()
}

fn pictures(kind: Kind, system: &System, outcomes: &[(String, Outcome)], options: &Options) -> Vec<Picture> {
    let quantities = kind.quantities();
    let zoom = if kind == Kind::Zoom { zoom_of(system, outcomes, options) } else { None };
    let units = units(system, outcomes, quantities).filter(|_| kind != Kind::Zoom || zoom.is_some());
    let Some(units) = units else { return Vec::new() };
    let line = |(name, outcome): &(String, Outcome)| line(system, quantities, name, outcome, &zoom);
    let lines: Vec<Line> = outcomes.iter().map(line).collect();
    let axes = axes(quantities, units, &lines, &zoom);
    let quantities = kind.quantities_in(units);
    let parts = lines.len().div_ceil(MOST_LAWS);
    let size = lines.len().div_ceil(parts);
    let force = quantities[1].names().0;
    let whole = zoom.as_ref().map_or_else(|| in_words(quantities), |range| format!("{force} {}", range.words()));
    let picture = |(number, lines): (usize, &[Line])| {
        let (first, last) = (number * size + 1, number * size + lines.len());
        let part = if parts > 1 { format!(" (laws {first} to {last} of {})", outcomes.len()) } else { String::new() };
        let title = format!("{whole}{part}");
        let svg =
            Drawing { title: &title, quantities, axes: &axes, lines, residuals: None, theme: options.theme }.svg();
        Picture { kind, part: number + 1, parts, title, svg }
    };
    lines.chunks(size).enumerate().map(picture).collect()
}

/// The units of the quantities in the first outcome that has them.
fn units<'a>(system: &System, outcomes: &'a [(String, Outcome)], quantities: [Quantity; 2]) -> Option<[&'a str; 2]> {
    outcomes.iter().find_map(|(_, outcome)| {
        let [across, up] = quantities.map(|quantity| values(system, outcome, quantity));
        Some([across?.1, up?.1])
    })
}

/// The time range of the zoom: the one that was asked for, or the one about the first breakaway.
fn zoom_of(system: &System, outcomes: &[(String, Outcome)], options: &Options) -> Option<Range> {
    if let Some([from, to]) = options.zoom.filter(|[from, to]| from < to && (to - from).is_finite()) {
        return Some(Range::given([from, to]));
    }
    Range::find(outcomes, shown(system, Quantity::Force)?, shown(system, Quantity::Velocity))
}

/// The curve of a law.
fn line(system: &System, quantities: [Quantity; 2], name: &str, outcome: &Outcome, zoom: &Option<Range>) -> Line {
    let [across, up] =
        quantities.map(|quantity| values(system, outcome, quantity).map_or(&[][..], |(values, _)| values));
    let points = across.iter().zip(up).map(|(x, y)| [*x, *y]);
    let (name, end) = match outcome.end {
        End::Reached => (name.to_owned(), None),
        End::Failed { time, .. } | End::Cancelled { time } => {
            (format!("{name} (stopped at {} s)", digits(time, 4)), Some(time))
        }
    };
    match zoom {
        None => Line { name, points: points.collect(), is_cut: end.is_some(), ..Line::default() },
        Some(Range { from, to, .. }) => {
            let is_cut = end.is_some_and(|end| (*from..*to).contains(&end));
            Line { name, points: within(points.collect(), *from, *to), is_cut, ..Line::default() }
        }
    }
}

/// The part of a curve over time in a range, with its ends.
fn within(points: Vec<[f64; 2]>, from: f64, to: f64) -> Vec<[f64; 2]> {
    let first = points.partition_point(|point| point[0] < from);
    let past = points.partition_point(|point| point[0] <= to);
    let between = |right: usize, time: f64| {
        let [[x_0, y_0], [x_1, y_1]] = [points.get(right.checked_sub(1)?)?, points.get(right)?];
        Some([time, y_0 + (y_1 - y_0) * (time - x_0) / (x_1 - x_0)])
    };
    let inside = points.get(first..past).unwrap_or(&[]).iter().copied();
    between(first, from).into_iter().chain(inside).chain(between(past, to)).collect()
}

fn axes(quantities: [Quantity; 2], units: [&str; 2], lines: &[Line], zoom: &Option<Range>) -> [Axis; 2] {
    let is_time = quantities[0] == Quantity::Time;
    let across = zoom.as_ref().map_or_else(|| range(lines, 0), |zoom| [zoom.from, zoom.to]);
    [Axis::new(units[0], across, 8.0, is_time), Axis::new(units[1], range(lines, 1), 6.0, false)]
}

/// Axes of residuals: the horizontal one is that of the curves.
fn below(quantities: [Quantity; 2], units: [&str; 2], [curves, residuals]: [&[Line]; 2]) -> [Axis; 2] {
    let [across, _] = axes(quantities, units, curves, &None);
    [across, Axis::new(units[1], range(residuals, 1), 3.0, false)]
}

/// Range of the finite values of lines over an axis.
fn range(lines: &[Line], axis: usize) -> [f64; 2] {
    let values = lines.iter().flat_map(|line| &line.points).map(|point| point[axis]).filter(|value| value.is_finite());
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low <= high { [low, high] } else { [0.0, 0.0] }
}

#[cfg(test)]
mod tests;
