//! What an error of the velocity makes of the unknowns.
//!
//! # Equation
//! The error is taken to have one sign within a window of the filter of the motion, and any sign in the next one. With
//! the change b of the force by a change of the velocity by its error, the sensitivities J and the covariance C by the
//! noise of the force, of variance s2:
//!
//! ```text
//! shift of the unknowns by a window w    d_w = C J_w' b_w / s2
//! covariance by the error                B = sum of d_w d_w'
//! ```
//!
//! Friction changes steeply around rest: there a small error of the velocity counts more than the noise of the force, and
//! the residuals do not show it, since they are few or since an unknown makes up for it.

use std::ops::Range;

use nalgebra::DMatrix;

use super::Experiment;
use super::problem::Problem;

/// Places at which the windows may begin, as parts of them, over which the covariance is averaged (chosen): a sensitivity
/// that changes its sign within a window cancels in that window alone.
const PHASES: usize = 8;

/// Covariance of the unknowns by the error of the velocity. `columns` are the sensitivities of the force, and `gain` times
/// them the shift of the unknowns by a force.
pub(super) fn blur(problem: &Problem, places: &[f64], columns: &[Vec<f64>], gain: &DMatrix<f64>) -> DMatrix<f64> {
    let count = columns.len();
    let mut sum = DMatrix::zeros(count, count);
    let Some(changes) = changes(problem, places) else { return sum };
    for phase in 0..PHASES {
        for window in windows(problem.experiments, phase as f64 / PHASES as f64) {
            let pull = |column: &Vec<f64>| window.clone().map(|at| column[at] * changes[at]).sum::<f64>();
            let pulls: Vec<f64> = columns.iter().map(pull).collect();
            let shift =
                |one: usize| pulls.iter().enumerate().map(|(other, pull)| gain[(one, other)] * pull).sum::<f64>();
            let shifts: Vec<f64> = (0..count).map(shift).collect();
            for (a, b) in (0..count).flat_map(|a| (0..count).map(move |b| (a, b))) {
                sum[(a, b)] += shifts[a] * shifts[b] / PHASES as f64;
            }
        }
    }
    sum
}

/// Error of the velocity; 0 if none is known. An axis has none: its force and its motion are smoothed alike.
pub(super) fn error(experiment: &Experiment) -> f64 {
    let is_known = experiment.alike.is_none() && experiment.velocity_error.is_finite();
    if is_known { experiment.velocity_error } else { 0.0 }
}

/// Change of the force by a change of the velocity by its error, at the samples that count; None if no error is known.
fn changes(problem: &Problem, places: &[f64]) -> Option<Vec<f64>> {
    if problem.experiments.iter().all(|one| error(one) == 0.0) {
        return None;
    }
    let moved = |sign: f64| {
        let faster = |one: &Experiment| {
            let velocity = one.velocity.iter().map(|v| v + sign * error(one)).collect();
            Experiment { velocity, ..one.clone() }
        };
        let experiments: Vec<Experiment> = problem.experiments.iter().map(faster).collect();
        Problem { experiments: &experiments, ..problem.clone() }.residuals(places)
    };
    let half = |slower: &[f64], faster: &[f64], part: f64| {
        slower.iter().zip(faster).map(|(slower, faster)| part * (faster - slower)).collect()
    };
    // Where the law is refused on one side, the other one must do.
    match (moved(-1.0), moved(1.0)) {
        (Some(slower), Some(faster)) => Some(half(&slower, &faster, 0.5)),
        (Some(slower), None) => Some(half(&slower, &problem.residuals(places)?, 1.0)),
        (None, Some(faster)) => Some(half(&problem.residuals(places)?, &faster, 1.0)),
        (None, None) => None,
    }
}

/// Samples that count, as they are numbered in the residuals, in windows of the filter of the motion; the first one is
/// shorter by a part of itself.
fn windows(experiments: &[Experiment], phase: f64) -> Vec<Range<usize>> {
    let mut list = Vec::new();
    let mut number = 0;
    for one in experiments {
        let mut current = None;
        for at in (0..one.time.len()).filter(|at| one.counts(*at)) {
            let is_white = one.window == 0.0;
            let passed = if is_white { number as f64 } else { (one.time[at] - one.time[0]) / one.window + phase };
            match list.last_mut() {
                Some(Range { end, .. }) if current == Some(passed.floor()) => *end = number + 1,
                _ => list.push(number..number + 1),
            }
            current = Some(passed.floor());
            number += 1;
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::super::tests::{measured, standard, white_noise, whole_problem};
    use super::super::trust::trust;
    use super::super::{Experiment, Verdict};
    use approx::assert_relative_eq;

    /// Sliding at 1 and 2 m/s in turn with f = mu_k f_n + c v: an error e of the velocity looks like mu_k f_n higher by c e,
    /// and c the same; with errors of n windows, each shifts mu_k by a part 1/n of that, and they add up to 1 / sqrt(n).
    #[test]
    fn an_error_of_the_velocity_looks_like_another_level() {
        let even = standard(1600);
        let velocity = (0..1600).map(|at| 1.0 + f64::from(at % 2)).collect();
        let sliding = Experiment { velocity, normal_force: vec![20.0; 1600], velocity_error: 0.01, ..even };
        let values = [("mu_k", 0.2), ("viscous_coefficient", 3.0)];
        let data = [measured("CoulombViscous", &values, &sliding, 0.0, 1)];
        let found = |window: f64| {
            let data = [Experiment { window, ..data[0].clone() }];
            let problem = whole_problem("CoulombViscous", &data);
            let places =
                values.map(|(name, value)| problem.unknowns.iter().find(|one| one.name == name).unwrap().place(value));
            let trust = trust(&problem, &places, &white_noise(1e-3));
            assert_eq!(trust.verdicts, [Verdict::Determined, Verdict::Determined]);
            assert!(trust.blurs[1] < 1e-6, "{:?}", trust.blurs);
            assert_relative_eq!(
                trust.deviations[0].powi(2),
                trust.by_noise(0).powi(2) + trust.blurs[0].powi(2),
                max_relative = 1e-9
            );
            trust.blurs[0]
        };
        let whole = 3.0 * 0.01 / 20.0;
        assert_relative_eq!(found(1000.0), whole, max_relative = 1e-3);
        // Windows of 1 s: four, or three and two parts of one, k/8 and 1 - k/8.
        let squares = 3.0 + (140.0 + 204.0) / 512.0;
        assert_relative_eq!(found(1.0), whole * f64::sqrt(squares) / 4.0, max_relative = 0.02);
    }

    #[test]
    fn a_steep_slope_at_rest_is_not_determined_where_the_velocity_is_not_known() {
        let data = measured("Threlfall", &[], &standard(1000), 0.01, 2);
        let verdict = |velocity_error: f64| {
            let data = [Experiment { velocity_error, window: 0.02, ..data.clone() }];
            let problem = whole_problem("Threlfall", &data);
            let number = problem.unknowns.iter().position(|one| one.name == "transition_velocity").unwrap();
            let places: Vec<f64> = problem
                .unknowns
                .iter()
                .map(|one| {
                    let column = problem.law.find(&one.name).unwrap();
                    one.place(problem.law.table.at(column).start)
                })
                .collect();
            trust(&problem, &places, &white_noise(0.05)).verdicts.swap_remove(number)
        };
        assert_eq!(verdict(1e-6), Verdict::Determined);
        assert!(verdict(3e-3).to_string().contains("the velocity is not known well enough"), "{:?}", verdict(3e-3));
    }
}
