//! Work-precision diagrams: what accuracy costs with each solver.

use super::Measurement;
use super::page::solvers;
use stribeck_plot::palette::{MOST_LAWS, Theme};
use stribeck_plot::picture::drawing::{Axis, Drawing, Line};
use stribeck_plot::picture::quantity::Quantity;
use stribeck_solve::run::Solver;

/// Error that a diagram shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Of the motion.
    Motion,
    /// Of the times of switching.
    Switching,
}

impl Precision {
    /// The error of a trial.
    fn of(self, one: &Measurement) -> Option<f64> {
        match self {
            Precision::Motion => one.error,
            Precision::Switching => one.switching,
        }
    }

    /// Quantity, unit and title.
    fn shown(self) -> (Quantity, &'static str, &'static str) {
        match self {
            Precision::Motion => (Quantity::Error, "m", "Error of the motion"),
            Precision::Switching => (Quantity::SwitchingError, "s", "Error of the switching"),
        }
    }
}

/// Least error that is shown, in SI units (chosen): below it the rounding of the reference decides.
const LEAST: f64 = 1e-15;

/// Error over evaluations for the trials of a law with events located, or stepped over; a line for each solver. None if
/// no solver came to its end at two tolerances.
pub fn work_precision(
    measurements: &[Measurement],
    law: &str,
    events: bool,
    precision: Precision,
    theme: Theme,
) -> Option<String> {
    let of_law: Vec<&Measurement> =
        measurements.iter().filter(|one| one.law == law && one.trial.events == events).collect();
    // A solver has the same colour in all diagrams, whichever solvers can run the law.
    let all = solvers(measurements)
        .into_iter()
        .take(MOST_LAWS)
        .enumerate()
        .map(|(look, solver)| line(&of_law, solver, precision, look));
    let lines: Vec<Line> = all.filter(|line| line.points.len() > 1).collect();
    lines.first()?;
    let (quantity, unit, what) = precision.shown();
    let quantities = [Quantity::Evaluations, quantity];
    let axes = [Axis::powers("1", range(&lines, 0)), Axis::powers(unit, range(&lines, 1))];
    let title = format!("{law}: {what}, events {}", if events { "located" } else { "stepped over" });
    Some(Drawing { title: &title, quantities, axes: &axes, lines: &lines, residuals: None, theme }.svg())
}

/// The least and the largest value on an axis.
fn range(lines: &[Line], axis: usize) -> [f64; 2] {
    let points = lines.iter().flat_map(|line| &line.points);
    points.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| [low.min(point[axis]), high.max(point[axis])])
}

/// The trials of a solver, from the loosest tolerance on.
fn line(measurements: &[&Measurement], solver: Solver, precision: Precision, look: usize) -> Line {
    let mut trials: Vec<&&Measurement> = measurements.iter().filter(|one| one.trial.solver == solver).collect();
    trials.sort_by(|a, b| b.trial.tolerance.total_cmp(&a.trial.tolerance));
    let point = |one: &&Measurement| Some([one.counts[2] as f64, precision.of(one)?.max(LEAST)]);
    let points = trials.into_iter().filter_map(point).collect();
    Line { name: solver.to_string(), points, look: Some(look), ..Line::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::benchmark::tests::trial;

    #[test]
    fn each_solver_with_two_runs_has_a_line() {
        let trials = [
            trial(Solver::Bdf, 1e-6, 300, 1e-5),
            trial(Solver::Rodas5P, 1e-4, 100, 1e-3),
            trial(Solver::Rodas5P, 1e-6, 200, 1e-6),
            trial(Solver::Bdf, 1e-4, 90, 2e-3),
            trial(Solver::Dopri5, 1e-4, 800, 1e-4),
        ];
        let of_law = trials.each_ref();
        assert_eq!(line(&of_law, Solver::Bdf, Precision::Motion, 0).points, [[90.0, 2e-3], [300.0, 1e-5]]);
        let draw = |law, events, precision| work_precision(&trials, law, events, precision, Theme::Light);
        let svg = draw("LuGre", true, Precision::Motion).expect("a picture");
        assert!(svg.contains("bdf") && svg.contains("rodas5p") && !svg.contains("dopri5"), "{svg}");
        // The first solver of all has the first look, here and where the second one has no line.
        assert!(svg.contains("law-1") && svg.contains("law-2") && !svg.contains("law-3"), "{svg}");
        let others = trials[1..].iter().filter(|one| one.trial.solver != Solver::Bdf);
        let others = others.map(|one| Measurement { law: "Dahl".to_owned(), ..one.clone() });
        let both: Vec<Measurement> = trials.iter().cloned().chain(others).collect();
        let svg = work_precision(&both, "Dahl", true, Precision::Motion, Theme::Light).expect("a picture");
        assert!(svg.contains("law-2") && !svg.contains("law-1"), "{svg}");
        let svg = draw("LuGre", true, Precision::Motion).expect("a picture");
        assert!(svg.contains("10⁻⁶") && svg.contains("10³"), "{svg}");
        let absent = [("Dahl", true, Precision::Motion), ("LuGre", false, Precision::Motion)];
        assert!(absent.into_iter().all(|(law, events, precision)| draw(law, events, precision).is_none()));
        assert!(draw("LuGre", true, Precision::Switching).is_none());
    }
}
