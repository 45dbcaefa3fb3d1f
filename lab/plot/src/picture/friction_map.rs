//! Picture of a map of friction and of the law that was fitted to it.

use stribeck_draw::text::{digits, typeset_unit};
use stribeck_fit::identify::map::{FrictionMap, Mean};
use stribeck_fit::identify::{Fit, reference_curve, steady_curve};
use stribeck_solve::system::Fault;

use super::drawing::{Drawing, Line, Sample};
use super::tyre::{loads, near};
use super::{Kind, Named, Picture, Theme, axes};

/// Intervals of a curve in each direction (chosen); they are shorter near rest.
const INTERVALS: u32 = 150;

/// Half the width of a mark, as a part of the largest speed, and half the size of a cross, as parts of the largest speed and
/// force (chosen).
const HALF: f64 = 0.006;
const CROSS: [f64; 2] = [0.008, 0.014];

/// Standard deviations to each side of a mean that an error bar shows (chosen: 95 %).
const BAR: f64 = 1.96;

/// Looks of the marks and of the curve of each load: those of marks have no dashes, or long ones. Curves of given values have
/// those of the loads that are not there.
const LOOKS: [[usize; 2]; 4] = [[0, 1], [4, 3], [6, 5], [2, 7]];

/// Draws the means of a map with error bars of its scatter, of 95 % of single rows, and the steady sliding of a law, as
/// fitted and with given values, as curves between the slowest and the fastest row, for at most four loads. Without repeats
/// there are crosses.
pub fn friction_map(name: &str, map: &FrictionMap, fit: &Fit, theme: Theme) -> Result<Picture, Fault> {
    let means = of_sliding(map);
    let largest = |of: fn(&Mean) -> f64| means.iter().fold(0.0, |most: f64, mean| most.max(of(mean).abs()));
    let size = [largest(|mean| mean.velocity), largest(|mean| mean.force)];
    let (mut lines, loads) = (Vec::new(), by_load(&means));
    let (sample, shown_as) = match map.scatter {
        Some(_) => (Sample::Bar, "means, with 95 % of the scatter"),
        None => (Sample::Cross, "measured"),
    };
    for (number, ((load, near), [marks, curve])) in loads.iter().zip(LOOKS).enumerate() {
        let named = |name: &str| with_load(name, map, *load);
        let line = |name, points, look| Line { name, points, look: Some(look), ..Line::default() };
        let measured = line(named("measured"), near.iter().flat_map(|mean| mark(mean, size)).collect(), marks);
        lines.push(Line { sample, ..measured });
        let fitted = curves(&named(fit.law.name), near, &|inputs| steady_curve(fit, inputs))?;
        lines.extend(fitted.into_iter().map(|(name, points)| line(name, points, curve)));
        if let (Some(values), Some([_, look])) = (fit.reference(), LOOKS.get(loads.len() + number)) {
            let given = curves(&named("reference"), near, &|inputs| reference_curve(fit, values, inputs))?;
            lines.extend(given.into_iter().map(|(name, points)| line(name, points, *look)));
        }
    }
    let title = format!("{name}: {shown_as}, and {} fitted", fit.law.name);
    let units = Kind::ForceOverVelocity.quantities().map(|quantity| map.movement.unit(quantity.unit()));
    let quantities = Kind::ForceOverVelocity.quantities_in(units);
    let axes = axes(quantities, units, &lines, &None);
    let svg = Drawing { title: &title, quantities, axes: &axes, lines: &lines, residuals: None, theme }.svg();
    Ok(Picture { kind: Kind::ForceOverVelocity, part: 1, parts: 1, title, svg })
}

/// The curves of a fitted law in such a picture, one for each load, with a gap between the directions.
pub fn fitted_curves(map: &FrictionMap, fit: &Fit) -> Result<Vec<Named>, Fault> {
    let means = of_sliding(map);
    let curve = |(load, near): (f64, Vec<&Mean>)| {
        let directions = curves("", &near, &|inputs| steady_curve(fit, inputs))?;
        let points: Vec<Vec<[f64; 2]>> = directions.into_iter().map(|(_, points)| points).collect();
        Ok((with_load(fit.law.name, map, load), points.join(&[f64::NAN; 2])))
    };
    by_load(&means).into_iter().map(curve).collect()
}

/// The means of rows that slide.
fn of_sliding(map: &FrictionMap) -> Vec<Mean> {
    map.means().into_iter().filter(|mean| mean.velocity != 0.0).collect()
}

/// At most four loads, and the means near each.
fn by_load(means: &[Mean]) -> Vec<(f64, Vec<&Mean>)> {
    let all: Vec<f64> = means.iter().map(|mean| mean.normal_force).collect();
    let shown: Vec<usize> = (0..means.len()).filter(|at| all[*at] > 0.0).collect();
    let near = |load: f64| near(&shown, &all, load).into_iter().map(|at| &means[at]).collect();
    loads(&shown, &all).into_iter().map(|load| (load, near(load))).collect()
}

/// A name with a load behind it.
fn with_load(name: &str, map: &FrictionMap, load: f64) -> String {
    format!("{name}, {} {}", digits(load, 3), typeset_unit(map.movement.unit("N")))
}

/// A mean: a short line with an error bar and its caps if there are repeats, a cross if there are none. `size` is the largest
/// speed and force of the map.
fn mark(mean: &Mean, size: [f64; 2]) -> Vec<[f64; 2]> {
    let Mean { velocity: v, force, scatter, .. } = *mean;
    let gap = [f64::NAN; 2];
    let Some(reach) = scatter.map(|scatter| BAR * scatter) else {
        let [wide, high] = [CROSS[0] * size[0], CROSS[1] * size[1]];
        let stroke = |high: f64| [[v - wide, force - high], [v + wide, force + high], gap];
        return [stroke(high), stroke(-high)].concat();
    };
    let half = HALF * size[0];
    let across = |force: f64| [[v - half, force], [v + half, force], gap];
    let bar = [[v, force - reach], [v, force + reach], gap];
    [across(force), bar, across(force - reach), across(force + reach)].concat()
}

/// Force of steady sliding at pairs of velocity and normal force.
type Steady<'a> = &'a dyn Fn(&[[f64; 2]]) -> Result<Vec<f64>, Fault>;

/// The force of steady sliding at the mean load, in each direction that was measured; only the first one has the name.
fn curves(name: &str, means: &[&Mean], steady: Steady) -> Result<Vec<Named>, Fault> {
    let load = means.iter().map(|mean| mean.normal_force).sum::<f64>() / means.len() as f64;
    let mut found = Vec::new();
    for sign in [1.0, -1.0] {
        let speeds = || means.iter().map(|mean| sign * mean.velocity).filter(|speed| *speed > 0.0);
        let [Some(slowest), Some(fastest)] = [speeds().reduce(f64::min), speeds().reduce(f64::max)] else { continue };
        let part = |point: u32| f64::from(point) / f64::from(INTERVALS);
        let at = |point: u32| sign * (slowest + (fastest - slowest) * part(point).powi(3));
        let inputs: Vec<[f64; 2]> = (0..=INTERVALS).map(|point| [at(point), load]).collect();
        let forces = steady(&inputs)?;
        let name = if found.is_empty() { name.to_owned() } else { String::new() };
        found.push((name, inputs.into_iter().zip(forces).map(|([v, _], force)| [v, force]).collect()));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::atomic::AtomicBool;

    use stribeck_fit::identify::{Data, Inquiry, Judgement, Ranking, Source, Watch};
    use stribeck_measured::Movement;
    use stribeck_sheet::{Sheet, SheetError};

    use super::super::tyre::tests::places;
    use super::*;

    struct Text(String);

    impl Source for Text {
        fn tables(&self, _: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
            Ok(vec![Sheet::parse(&self.0)?])
        }
    }

    /// Rows of 2 N + 5 N.s/m, as much above it as below it where they are repeated.
    fn fitted(apart: f64) -> (Data, Ranking) {
        let speeds = [-0.3, -0.2, -0.1, 0.1, 0.2, 0.4, 0.6];
        let force = |v: f64| 2.0 * v.signum() + 5.0 * v;
        let row = |v: f64, apart: f64| format!("{v},{}\n", force(v) + apart);
        let rows: String = speeds.iter().map(|v| row(*v, apart) + &row(*v, -apart)).collect();
        let rows = if apart == 0.0 { speeds.iter().map(|v| row(*v, 0.0)).collect() } else { rows };
        let asked = Inquiry {
            records: vec!["map.csv".into()],
            law: vec!["CoulombViscous".into()],
            normal_force: Some(1.0),
            repetitions: Some(0),
            ..Inquiry::default()
        };
        let data = asked.data(&Text(format!("velocity [m/s],force [N]\n{rows}"))).unwrap();
        let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
        let ranking = asked.fits(&data, &mut |_| (), watch).unwrap();
        (data, ranking)
    }

    #[test]
    fn a_map_of_a_joint_shows_torque_over_angular_velocity() {
        let (mut data, ranking) = fitted(0.0);
        let (name, map) = &mut data.maps[0];
        map.movement = Movement::Rotation;
        let svg = friction_map(name, map, ranking.best(), Theme::Light).unwrap().svg;
        let names = svg.split("class=\"names\"").nth(1).unwrap();
        assert!(names.contains(">Angular velocity <") && names.contains(">Friction torque <"), "{names}");
    }

    /// The place of a curve at a horizontal place.
    fn height(curve: &[[f64; 2]], x: f64) -> f64 {
        let mut sorted = curve.to_vec();
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let right = sorted.partition_point(|point| point[0] < x).clamp(1, sorted.len() - 1);
        let [[x_0, y_0], [x_1, y_1]] = [sorted[right - 1], sorted[right]];
        y_0 + (y_1 - y_0) * (x - x_0) / (x_1 - x_0)
    }

    /// The samples of a legend: how they go on from their first place, without the end of a line across.
    fn in_legend(svg: &str) -> Vec<&str> {
        let entries = svg.split("class=\"entry\"").skip(1);
        let data = entries.map(|entry| entry.split(" d=\"").nth(1).unwrap().split('"').next().unwrap());
        let onwards = data.map(|data| data.trim_start_matches(|letter| "M0123456789. ".contains(letter)));
        onwards.map(|data| if data.starts_with('H') { "H" } else { data }).collect()
    }

    #[test]
    fn means_are_on_the_curve_and_bars_are_as_long_as_the_scatter() {
        let (data, ranking) = fitted(0.1);
        let (name, map) = &data.maps[0];
        let picture = friction_map(name, map, ranking.best(), Theme::Light).unwrap();
        assert!(picture.svg.contains(">measured, 1 N<") && picture.svg.contains(">CoulombViscous, 1 N<"));
        assert_eq!(picture.title, "map: means, with 95 % of the scatter, and CoulombViscous fitted");
        assert_eq!(in_legend(&picture.svg), ["h8m-4 0v12m-4 0h8m0 -6h-8", "H"]);
        let [marks] = places(&picture.svg, "law-1").try_into().unwrap();
        let [forwards, backwards] = places(&picture.svg, "law-2").try_into().unwrap();
        assert_eq!(marks.len(), 7 * 8, "a line, a bar and two caps for each speed");
        // Two rows 0.1 N from their mean: a variance of 0.02 N2.
        let newtons = 1.96 * 2.0 * 0.02f64.sqrt();
        let scale = (height(&forwards, marks[32][0]) - height(&forwards, marks[48][0])) / 2.0;
        for mark in marks.chunks(8) {
            let middle = [0.5 * (mark[0][0] + mark[1][0]), mark[0][1]];
            let curve = if middle[0] < 0.5 * (backwards[0][0] + forwards[0][0]) { &backwards } else { &forwards };
            assert!((height(curve, middle[0]) - middle[1]).abs() < 0.5, "{mark:?}");
            assert!(((mark[2][1] - mark[3][1]).abs() / scale - newtons).abs() < 0.05, "{mark:?} {scale}");
        }
    }

    /// The middle of each cross is on the curve of what was measured.
    #[test]
    fn a_map_without_repeats_has_crosses() {
        let (data, ranking) = fitted(0.0);
        let (name, map) = &data.maps[0];
        let picture = friction_map(name, map, ranking.best(), Theme::Light).unwrap();
        let marks = places(&picture.svg, "law-1").concat();
        assert_eq!(marks.len(), 7 * 4);
        let [forwards, backwards] = places(&picture.svg, "law-2").try_into().unwrap();
        for cross in marks.chunks(4) {
            let middle = [0, 1].map(|axis| cross.iter().map(|end| end[axis]).sum::<f64>() / 4.0);
            let curve = if middle[0] < 0.5 * (backwards[0][0] + forwards[0][0]) { &backwards } else { &forwards };
            assert!((height(curve, middle[0]) - middle[1]).abs() < 0.5, "{cross:?}");
            assert!((cross[1][0] - cross[0][0] - (cross[3][0] - cross[2][0])).abs() < 0.1 && cross[1][1] < cross[0][1]);
        }
        assert_eq!(picture.title, "map: measured, and CoulombViscous fitted");
        assert_eq!(in_legend(&picture.svg), ["l9 9m0 -9l-9 9", "H"]);
    }

    /// 2.5 N and 5 N.s/m: a parallel that is half a newton farther from rest than the law that was fitted.
    #[test]
    fn given_values_have_a_curve_of_their_own() {
        let (data, ranking) = fitted(0.1);
        let values = [("mu_k", 2.5), ("viscous_coefficient", 5.0)].map(|(name, value)| (name.to_owned(), value)).into();
        let judgement = Judgement {
            source: "given.toml".to_owned(),
            values,
            rms: 0.5,
            fit_rms: Some(0.1),
            outside: Vec::new(),
            verdict: String::new(),
            warnings: Vec::new(),
            note: None,
        };
        let fit = Fit { judgement: Some(judgement), ..ranking.best().clone() };
        let (name, map) = &data.maps[0];
        let picture = friction_map(name, map, &fit, Theme::Light).unwrap();
        assert!(picture.svg.contains(">reference, 1 N<"), "{}", picture.svg);
        let [marks] = places(&picture.svg, "law-1").try_into().unwrap();
        let newton = (marks[3][1] - marks[2][1]).abs() / (2.0 * 1.96 * 0.02f64.sqrt());
        let [fitted, given] = ["law-2", "law-4"].map(|class| places(&picture.svg, class));
        for (fitted, given, sign) in [(&fitted[0], &given[0], 1.0), (&fitted[1], &given[1], -1.0)] {
            for (fitted, given) in fitted.iter().zip(given) {
                assert!((sign * (fitted[1] - given[1]) / newton - 0.5).abs() < 0.02, "{fitted:?} {given:?} {newton}");
            }
        }
    }
}
