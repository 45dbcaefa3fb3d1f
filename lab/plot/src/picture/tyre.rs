//! Pictures of a tyre test and of the formula that was fitted to it.

use stribeck::host::{Contact, FormulaVersion, MagicFormula, Wrench};
use stribeck_fit::identify::tyre::{PURE, Sample, TyreTest};

use super::drawing::{Drawing, Line};
use super::{Kind, Picture, Theme, axes, in_words};
use crate::picture::quantity::Quantity;
use stribeck_draw::text::digits;

/// Loads in a picture, at most; each has a colour (chosen).
const LOADS: usize = 4;

/// Part by which a load may differ from the one of its curve (chosen).
const NEAR: f64 = 0.05;

/// Camber, in rad, by which a sample may differ from that of its picture (chosen: half a degree).
const UPRIGHT: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// Dots of a load, at most (chosen).
const DOTS: usize = 400;

/// Points of a curve (chosen).
const POINTS: usize = 201;

/// Measured values over one slip, while the other is 0.
struct View<'a> {
    kind: Kind,
    samples: &'a [Sample],
    slip: fn(&Sample) -> f64,
    /// Whether the other slip is 0.
    is_pure: fn(&Sample) -> bool,
    measured: fn(&Sample) -> Option<f64>,
    of: fn(&Wrench) -> f64,
}

/// Draws the test as dots and the formula as curves, at the loads of the test, the least camber and, of several inflation
/// pressures, the nominal one: side force and aligning moment in pure side slip, longitudinal force in pure longitudinal
/// slip.
pub fn tyre(test: &TyreTest, formula: &MagicFormula, theme: Theme) -> Vec<Picture> {
    let samples = &test.samples[..];
    let over_side = |kind, measured, of| View {
        kind,
        samples,
        slip: |one| one.side_slip,
        is_pure: Sample::is_rolling,
        measured,
        of,
    };
    let over_along = |kind, measured, of| View {
        kind,
        samples,
        slip: |one| one.longitudinal_slip,
        is_pure: Sample::is_straight,
        measured,
        of,
    };
    let views = [
        over_side(Kind::SideForce, |one| one.force_y, |wrench| wrench.force_y),
        over_side(Kind::AligningMoment, |one| one.moment_z, |wrench| wrench.moment_z),
        over_along(Kind::LongitudinalForce, |one| one.force_x, |wrench| wrench.force_x),
    ];
    views.into_iter().filter_map(|view| view.picture(formula, theme)).collect()
}

impl View<'_> {
    /// None without samples in which the other slip is 0 and this one is swept.
    fn picture(&self, formula: &MagicFormula, theme: Theme) -> Option<Picture> {
        let is_six = FormulaVersion::of(formula.version) == FormulaVersion::Six;
        let is_nominal = |pressure: f64| !is_six || (pressure / formula.nompres - 1.0).abs() <= NEAR;
        let is_seen = |one: &&Sample| {
            (self.is_pure)(one) && (self.measured)(one).is_some() && one.pressure.is_none_or(is_nominal)
        };
        let pure: Vec<Sample> = self.samples.iter().filter(is_seen).copied().collect();
        let least = pure.iter().map(|one| one.camber).min_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let shown: Vec<Sample> = pure.into_iter().filter(|one| (one.camber - least).abs() <= UPRIGHT).collect();
        let [low, high] = self.ends(&shown);
        if high - low <= PURE {
            return None;
        }
        let all: Vec<f64> = shown.iter().map(|one| one.load).collect();
        let numbers: Vec<usize> = (0..shown.len()).collect();
        let at_load = |load: f64| near(&numbers, &all, load).into_iter().map(|at| shown[at]).collect::<Vec<Sample>>();
        let loads = loads(&numbers, &all).into_iter().enumerate();
        let lines: Vec<Line> = loads.flat_map(|(look, load)| self.lines(&at_load(load), formula, look)).collect();
        let (kind, quantities) = (self.kind, self.kind.quantities());
        let title = format!("{}: measured (dots) and fitted", in_words(quantities));
        let axes = axes(quantities, quantities.map(Quantity::unit), &lines, &None);
        let svg = Drawing { title: &title, quantities, axes: &axes, lines: &lines, residuals: None, theme }.svg();
        Some(Picture { kind, part: 1, parts: 1, title, svg })
    }

    /// The least and the largest slip.
    fn ends(&self, samples: &[Sample]) -> [f64; 2] {
        let slips = || samples.iter().map(self.slip);
        [slips().fold(f64::INFINITY, f64::min), slips().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The samples of a load as dots, without a name, and the formula at their mean load and camber.
    fn lines(&self, samples: &[Sample], formula: &MagicFormula, look: usize) -> [Line; 2] {
        let every = samples.len().div_ceil(DOTS).max(1);
        let apart = |one: &Sample| [[(self.slip)(one), (self.measured)(one).unwrap_or(f64::NAN)], [f64::NAN; 2]];
        let dots = samples.iter().step_by(every).flat_map(apart).collect();
        let mean = |of: fn(&Sample) -> f64| samples.iter().map(of).sum::<f64>() / samples.len() as f64;
        let [low, high] = self.ends(samples);
        let (load, camber) = (mean(|one| one.load), mean(|one| one.camber));
        let curve = (0..POINTS).map(|number| {
            let slip = low + (high - low) * number as f64 / (POINTS - 1) as f64;
            let [longitudinal_slip, side_slip] =
                if self.kind == Kind::LongitudinalForce { [slip, 0.0] } else { [0.0, slip] };
            let contact = Contact { load, longitudinal_slip, side_slip, camber, speed: 1.0 };
            [slip, (self.of)(&formula.wrench(&contact))]
        });
        let line = |name: String, points| Line { name, points, look: Some(look), ..Line::default() };
        [Line { is_band: true, ..line(String::new(), dots) }, line(format!("{} N", digits(load, 3)), curve.collect())]
    }
}

/// Samples whose load is near this one.
pub(super) fn near(samples: &[usize], all: &[f64], load: f64) -> Vec<usize> {
    samples.iter().copied().filter(|at| (all[*at] / load - 1.0).abs() <= NEAR).collect()
}

/// Loads spread over those of the samples, from the least to the largest, at least twice as far apart as a load is wide.
pub(super) fn loads(samples: &[usize], all: &[f64]) -> Vec<f64> {
    let mut sorted: Vec<f64> = samples.iter().map(|at| all[*at]).collect();
    sorted.sort_by(f64::total_cmp);
    let mut loads: Vec<f64> = Vec::new();
    for number in 0..LOADS {
        // The middle of each part of the samples.
        let load = sorted[(2 * number + 1) * sorted.len() / (2 * LOADS)];
        if loads.last().is_none_or(|last| load > last * (1.0 + 2.0 * NEAR)) {
            loads.push(load);
        }
    }
    loads
}

#[cfg(test)]
pub(super) mod tests {
    use stribeck::model::start;

    use super::*;

    /// A test of the start values of the formula: side slip swept at two loads and two cambers.
    fn swept() -> (TyreTest, MagicFormula) {
        let formula: MagicFormula = start();
        let mut samples = Vec::new();
        let (speed, longitudinal_slip) = (1.0, 0.0);
        for (camber, load) in [(0.0, 400.0), (0.0, 900.0), (0.05, 400.0), (0.05, 900.0)] {
            for at in 0..50 {
                let side_slip = 0.006 * (f64::from(at) - 25.0);
                let wrench = formula.wrench(&Contact { load, longitudinal_slip, side_slip, camber, speed });
                samples.push(Sample {
                    load,
                    side_slip,
                    longitudinal_slip,
                    camber,
                    force_x: Some(0.0),
                    force_y: Some(wrench.force_y),
                    moment_z: Some(wrench.moment_z),
                    pressure: None,
                    time: None,
                    temperature: None,
                    file: 0,
                    line: samples.len() as u64,
                });
            }
        }
        (TyreTest { samples, ..TyreTest::default() }, formula)
    }

    /// The numbers of the paths of a picture: pairs of places.
    pub(in crate::picture) fn places(svg: &str, class: &str) -> Vec<Vec<[f64; 2]>> {
        let paths = svg.split("<path ").filter(|path| path.starts_with(&format!("class=\"law {class}\"")));
        let data = paths.map(|path| path.split(" d=\"").nth(1).unwrap().split('"').next().unwrap());
        let pair = |text: &str| {
            let (x, y) = text.split_once(' ').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        };
        data.map(|data| data.split(['M', 'L']).filter(|one| !one.is_empty()).map(pair).collect()).collect()
    }

    /// Without noise every dot is on the curve of its load.
    #[test]
    fn dots_are_on_the_curves_of_the_formula_that_made_them() {
        let (test, formula) = swept();
        let pictures = tyre(&test, &formula, Theme::Light);
        assert_eq!(
            pictures.iter().map(|picture| picture.name()).collect::<Vec<_>>(),
            ["side-force", "aligning-moment"]
        );
        for picture in &pictures {
            assert!(picture.svg.contains(">400 N<") && picture.svg.contains(">900 N<"));
            for class in ["law-1", "law-2"] {
                let [dots, curve] = places(&picture.svg, class).try_into().unwrap();
                assert_eq!(dots.len(), 100, "50 samples, each a short line");
                for dot in dots.chunks(2).map(|ends| [0.5 * (ends[0][0] + ends[1][0]), ends[0][1]]) {
                    let right = curve.partition_point(|point| point[0] < dot[0]).clamp(1, curve.len() - 1);
                    let [[x_0, y_0], [x_1, y_1]] = [curve[right - 1], curve[right]];
                    let there = y_0 + (y_1 - y_0) * (dot[0] - x_0) / (x_1 - x_0);
                    assert!((there - dot[1]).abs() < 0.5, "{dot:?} beside {there}");
                }
            }
        }
    }

    #[test]
    fn a_test_without_side_slip_has_no_picture_of_it() {
        let (mut test, formula) = swept();
        test.samples.iter_mut().for_each(|one| one.side_slip = 0.0);
        assert!(tyre(&test, &formula, Theme::Light).is_empty());
    }
}
