//! What an error of the velocity makes of the parameters.
//!
//! # Equation
//! The error is that of the slope of a displacement with white noise, in the windows of the filter of the motion. With
//! the change b of the force by a change of the velocity by its error, the correlation r of the error between the times
//! of two samples, the sensitivities J and the covariance C by the noise of the force, of variance s2:
//!
//! ```text
//! shift of the parameters by a change e of the force    d = C J' e / s2
//! covariance by the error                             B = sum of r(t_i - t_j) d_i d_j'    d_i: by b at sample i
//! ```
//!
//! Friction changes steeply around rest: there a small error of the velocity counts more than the noise of the force, and
//! the residuals do not show it, since they are few or since a parameter makes up for it.

use nalgebra::DMatrix;
use stribeck::model::Meaning;

use super::levels::columns_of;
use super::problem::{Problem, dot};
use super::{Experiment, Target, tie};
use stribeck_measured::correlation_of_slopes;

/// Error of the velocity, as a part of the speed at which friction falls, from which parameters are biased (chosen: a
/// camera of 100 Hz with 0.013 of it makes the static level 1 % and that speed 7 % wrong, with 0.026 4 % and 11 %, and
/// sigma_1 three times too large with both).
pub(super) const BLURRED: f64 = 0.01;

/// The speed at which friction falls, with its name: as it is known to be, held, or the start value; None for a law that
/// has none.
pub(super) fn speed_of_fall(problem: &Problem, known: impl Fn(Target) -> Option<f64>) -> Option<(String, f64)> {
    [Meaning::FallSpeed, Meaning::TransitionSpeed].into_iter().find_map(|meaning| {
        let idle = tie::idle_speeds(problem.law, &problem.tied);
        let column = columns_of(problem.law, meaning).find(|column| !idle.contains(column))?;
        let variable = problem.law.table.at(column);
        let held = || problem.held.iter().find(|(held, _)| *held == column).map(|(_, value)| *value);
        Some((variable.path.to_string(), known(Target::Column(column)).or_else(held).unwrap_or(variable.start)))
    })
}

/// Covariance of the parameters by the error of the velocity. `columns` are the sensitivities of the force, and `gain` times
/// them the shift of the parameters by a force.
pub(super) fn blur(problem: &Problem, point: &[f64], columns: &[Vec<f64>], gain: &DMatrix<f64>) -> DMatrix<f64> {
    let count = columns.len();
    let Some(changes) = changes(problem, point) else { return DMatrix::zeros(count, count) };
    let pulls = |column: &Vec<f64>| column.iter().zip(&changes).map(|(slope, change)| slope * change).collect();
    let pulls: Vec<Vec<f64>> = columns.iter().map(pulls).collect();
    let passed: Vec<Vec<f64>> = pulls.iter().map(|pull| correlated(problem.experiments, pull)).collect();
    gain * DMatrix::from_fn(count, count, |a, b| dot(&pulls[a], &passed[b])) * gain.transpose()
}

/// For each sample that counts the sum over all of them, times the correlation of the error of the velocity.
fn correlated(experiments: &[Experiment], pull: &[f64]) -> Vec<f64> {
    let mut found = Vec::with_capacity(pull.len());
    for one in experiments {
        let from = found.len();
        let times: Vec<f64> = (0..one.time.len()).filter(|at| one.counts(*at)).map(|at| one.time[at]).collect();
        let mut first = 0;
        for time in &times {
            first += times[first..].iter().take_while(|other| **other < time - one.window).count();
            let near = times.iter().enumerate().skip(first).take_while(|(_, other)| **other <= time + one.window);
            found.push(near.map(|(at, other)| pull[from + at] * correlation_of_slopes(other - time, one.window)).sum());
        }
    }
    found
}

/// Error of the velocity; 0 if none is known. An axis has none: its force and its motion are smoothed alike.
pub(super) fn error(experiment: &Experiment) -> f64 {
    let is_known = experiment.matched_filter.is_none() && experiment.velocity_error.is_finite();
    if is_known { experiment.velocity_error } else { 0.0 }
}

/// Change of the force by a change of the velocity by its error, at the samples that count; None if no error is known.
fn changes(problem: &Problem, point: &[f64]) -> Option<Vec<f64>> {
    if problem.experiments.iter().all(|one| error(one) == 0.0) {
        return None;
    }
    let moved = |sign: f64| {
        let faster = |one: &Experiment| {
            let velocity = one.velocity.iter().map(|v| v + sign * error(one)).collect();
            Experiment { velocity, ..one.clone() }
        };
        let experiments: Vec<Experiment> = problem.experiments.iter().map(faster).collect();
        Problem { experiments: &experiments, ..problem.clone() }.residuals(point)
    };
    let half = |slower: &[f64], faster: &[f64], part: f64| {
        slower.iter().zip(faster).map(|(slower, faster)| part * (faster - slower)).collect()
    };
    // Where the law is refused on one side, the other one must do.
    match (moved(-1.0), moved(1.0)) {
        (Some(slower), Some(faster)) => Some(half(&slower, &faster, 0.5)),
        (Some(slower), None) => Some(half(&slower, &problem.residuals(point)?, 1.0)),
        (None, Some(faster)) => Some(half(&problem.residuals(point)?, &faster, 1.0)),
        (None, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{measured, standard, white_noise, whole_problem};
    use super::super::uncertainty::uncertainty;
    use super::super::{Experiment, Verdict};
    use approx::assert_relative_eq;

    /// Sliding at 1 and 2 m/s in turn with f = mu_k f_n + c v: an error e of the velocity looks like mu_k f_n higher by c e,
    /// and c the same, so that mu_k shifts by the mean error.
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
            let point = values
                .map(|(name, value)| problem.parameters.iter().find(|one| one.name == name).unwrap().coordinate(value));
            let trust = uncertainty(&problem, &point, &white_noise(1e-3));
            assert_eq!(trust.verdicts, [Verdict::Determined, Verdict::Determined]);
            assert_relative_eq!(
                trust.standard_deviations[0].powi(2),
                trust.by_noise(0).powi(2) + trust.blurs[0].powi(2),
                max_relative = 1e-9
            );
            [trust.blurs[0], trust.blurs[1]]
        };
        let whole = 3.0 * 0.01 / 20.0;
        let [level, viscous] = found(1e5);
        assert_relative_eq!(level, whole, max_relative = 1e-3);
        assert!(viscous < 1e-6, "{viscous}");
        // The mean over a time T has the variance 2 / T2 int (T - t) r(t) dt over a window w, with the integrals of r and
        // of t r over it 0 and -6/91 (w/2)2.
        let mean = f64::sqrt(2.0 * 6.0 / 91.0 * 0.25) / 4.0;
        assert_relative_eq!(found(1.0)[0], whole * mean, max_relative = 0.02);
    }

    #[test]
    fn a_steep_slope_at_rest_is_not_determined_where_the_velocity_is_not_known() {
        let data = measured("Threlfall", &[], &standard(1000), 0.01, 2);
        let verdict = |velocity_error: f64| {
            let data = [Experiment { velocity_error, window: 0.02, ..data.clone() }];
            let problem = whole_problem("Threlfall", &data);
            let number = problem.parameters.iter().position(|one| one.name == "transition_velocity").unwrap();
            let point: Vec<f64> = problem
                .parameters
                .iter()
                .map(|one| {
                    let column = problem.law.find(&one.name).unwrap();
                    one.coordinate(problem.law.table.at(column).start)
                })
                .collect();
            uncertainty(&problem, &point, &white_noise(0.05)).verdicts.swap_remove(number)
        };
        assert_eq!(verdict(1e-6), Verdict::Determined);
        assert!(verdict(3e-3).to_string().contains("the velocity is not known well enough"), "{:?}", verdict(3e-3));
    }
}
