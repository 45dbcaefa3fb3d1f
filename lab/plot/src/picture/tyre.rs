//! Pictures of a tyre test and of the formula that was fitted to it.

use stribeck::host::{Contact, MagicFormula, Wrench};
use stribeck_fit::identify::tyre::{PURE, TyreTest};

use super::drawing::{Drawing, Line};
use super::{Kind, Picture, Theme, axes};
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
    slip: &'a [f64],
    /// The slip that is 0.
    other: &'a [f64],
    measured: &'a [f64],
    of: fn(&Wrench) -> f64,
}

/// Draws the test as dots and the formula as curves, at the loads of the test and the least camber in it: side force and
/// aligning moment in pure side slip, longitudinal force in pure longitudinal slip.
pub fn tyre(test: &TyreTest, formula: &MagicFormula, theme: Theme) -> Vec<Picture> {
    let (side, along) = (&test.side_slip[..], &test.longitudinal_slip[..]);
    let over_side = |kind, measured, of| View { kind, slip: side, other: along, measured, of };
    let over_along = |kind, measured, of| View { kind, slip: along, other: side, measured, of };
    let (moment_z, force_x) = (test.moment_z.as_deref(), test.force_x.as_deref());
    let views = [
        Some(over_side(Kind::SideForce, &test.force_y, |wrench| wrench.force_y)),
        moment_z.map(|measured| over_side(Kind::AligningMoment, measured, |wrench| wrench.moment_z)),
        force_x.map(|measured| over_along(Kind::LongitudinalForce, measured, |wrench| wrench.force_x)),
    ];
    views.into_iter().flatten().filter_map(|view| view.picture(test, formula, theme)).collect()
}

impl View<'_> {
    /// None without samples in which the other slip is 0 and this one is swept.
    fn picture(&self, test: &TyreTest, formula: &MagicFormula, theme: Theme) -> Option<Picture> {
        let pure: Vec<usize> = (0..test.load.len()).filter(|at| self.other[*at].abs() <= PURE).collect();
        let least = pure.iter().map(|at| test.camber[*at]).min_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let shown: Vec<usize> = pure.into_iter().filter(|at| (test.camber[*at] - least).abs() <= UPRIGHT).collect();
        let [low, high] = self.ends(&shown);
        if high - low <= PURE {
            return None;
        }
        let lines: Vec<Line> = loads(&shown, &test.load)
            .into_iter()
            .enumerate()
            .flat_map(|(look, load)| self.lines(&near(&shown, &test.load, load), test, formula, look))
            .collect();
        let (kind, quantities) = (self.kind, self.kind.quantities());
        let title = format!("{}: measured (dots) and fitted", kind.title());
        let axes = axes(quantities, quantities.map(Quantity::unit), &lines, &None);
        let svg = Drawing { title: &title, quantities, axes: &axes, lines: &lines, theme }.svg();
        Some(Picture { kind, part: 1, parts: 1, title, svg })
    }

    /// The least and the largest slip.
    fn ends(&self, samples: &[usize]) -> [f64; 2] {
        let slips = || samples.iter().map(|at| self.slip[*at]);
        [slips().fold(f64::INFINITY, f64::min), slips().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The samples of a load as dots, without a name, and the formula at their mean load and camber.
    fn lines(&self, samples: &[usize], test: &TyreTest, formula: &MagicFormula, look: usize) -> [Line; 2] {
        let every = samples.len().div_ceil(DOTS).max(1);
        let apart = |at: &usize| [[self.slip[*at], self.measured[*at]], [f64::NAN; 2]];
        let dots = samples.iter().step_by(every).flat_map(apart).collect();
        let mean = |values: &[f64]| samples.iter().map(|at| values[*at]).sum::<f64>() / samples.len() as f64;
        let [low, high] = self.ends(samples);
        let (load, camber) = (mean(&test.load), mean(&test.camber));
        let curve = (0..POINTS).map(|number| {
            let slip = low + (high - low) * number as f64 / (POINTS - 1) as f64;
            let [longitudinal_slip, side_slip] =
                if self.kind == Kind::LongitudinalForce { [slip, 0.0] } else { [0.0, slip] };
            let contact = Contact { load, longitudinal_slip, side_slip, camber, speed: 1.0 };
            [slip, (self.of)(&formula.wrench(&contact))]
        });
        let line = |name: String, points| Line { name, points, is_cut: false, look: Some(look) };
        [line(String::new(), dots), line(format!("{} N", digits(load, 3)), curve.collect())]
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
        let all = |values: [f64; 2]| values.into_iter().flat_map(move |value| (0..50).map(move |at| (value, at)));
        let (mut load, mut side_slip, mut camber, mut force_y, mut moment_z) = (vec![], vec![], vec![], vec![], vec![]);
        for tilt in [0.0, 0.05] {
            for (one, at) in all([400.0, 900.0]) {
                let slip = 0.006 * (f64::from(at) - 25.0);
                let contact = Contact { load: one, longitudinal_slip: 0.0, side_slip: slip, camber: tilt, speed: 1.0 };
                let wrench = formula.wrench(&contact);
                load.push(one);
                side_slip.push(slip);
                camber.push(tilt);
                force_y.push(wrench.force_y);
                moment_z.push(wrench.moment_z);
            }
        }
        let zero = vec![0.0; load.len()];
        let (force_x, moment_z) = (Some(zero.clone()), Some(moment_z));
        let test = TyreTest {
            load,
            side_slip,
            longitudinal_slip: zero,
            camber,
            force_x,
            force_y,
            moment_z,
            pressure: None,
            notes: vec![],
        };
        (test, formula)
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
        test.side_slip.fill(0.0);
        assert!(tyre(&test, &formula, Theme::Light).is_empty());
    }
}
