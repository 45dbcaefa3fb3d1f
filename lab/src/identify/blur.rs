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

use nalgebra::{DMatrix, DVector};

use super::Experiment;
use super::problem::Problem;

/// Covariance of the unknowns by the error of the velocity. `columns` are the sensitivities of the force, and `gain` times
/// them the shift of the unknowns by a force.
pub(super) fn blur(problem: &Problem, places: &[f64], columns: &[Vec<f64>], gain: &DMatrix<f64>) -> DMatrix<f64> {
    let count = columns.len();
    let mut sum = DMatrix::zeros(count, count);
    let Some(changes) = changes(problem, places) else { return sum };
    for window in windows(problem.experiments) {
        let pull = |column: &Vec<f64>| window.clone().map(|at| column[at] * changes[at]).sum::<f64>();
        let shift = gain * DVector::from_iterator(count, columns.iter().map(pull));
        sum += &shift * shift.transpose();
    }
    sum
}

/// Change of the force by a change of the velocity by its error, at the samples that count; None if no error is known.
/// An axis has none: its force and its motion are smoothed alike.
fn changes(problem: &Problem, places: &[f64]) -> Option<Vec<f64>> {
    let error = |one: &Experiment| if one.alike.is_none() { one.velocity_error } else { 0.0 };
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
    let (slower, faster) = (moved(-1.0)?, moved(1.0)?);
    Some(slower.iter().zip(&faster).map(|(slower, faster)| 0.5 * (faster - slower)).collect())
}

/// Samples that count, as they are numbered in the residuals, in windows of the filter of the motion.
fn windows(experiments: &[Experiment]) -> Vec<Range<usize>> {
    let mut list = Vec::new();
    let mut number = 0;
    for one in experiments {
        let counting = (0..one.time.len()).filter(|at| one.counts(*at));
        let mut begin = f64::NEG_INFINITY;
        for at in counting {
            let end = begin + 2.0 * one.reach;
            match list.last_mut() {
                Some(Range { end: last, .. }) if one.time[at] <= end => *last = number + 1,
                _ => {
                    begin = one.time[at];
                    list.push(number..number + 1);
                }
            }
            number += 1;
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::super::tests::{measured, standard, white_noise, whole_problem};
    use super::super::trust::trust;
    use super::super::unknown::Unknown;
    use super::super::{Experiment, Verdict};
    use approx::assert_relative_eq;

    /// Where an unknown has a value.
    fn place(unknown: &Unknown, value: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if unknown.value(middle)[0] < value { low = middle } else { high = middle }
        }
        low
    }

    /// Sliding at 1 and 2 m/s in turn with f = mu_k f_n + c v: an error e of the velocity looks like mu_k f_n higher by c e,
    /// and c the same; with errors of n windows, each shifts mu_k by a part 1/n of that, and they add up to 1 / sqrt(n).
    #[test]
    fn an_error_of_the_velocity_looks_like_another_level() {
        let even = standard(400);
        let velocity = (0..400).map(|at| 1.0 + f64::from(at % 2)).collect();
        let sliding = Experiment { velocity, normal_force: vec![20.0; 400], velocity_error: 0.01, ..even };
        let values = [("mu_k", 0.2), ("viscous_coefficient", 3.0)];
        let data = [measured("CoulombViscous", &values, &sliding, 0.0, 1)];
        let found = |reach: f64| {
            let data = [Experiment { reach, ..data[0].clone() }];
            let problem = whole_problem("CoulombViscous", &data);
            let places =
                values.map(|(name, value)| place(problem.unknowns.iter().find(|one| one.name == name).unwrap(), value));
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
        assert_relative_eq!(found(10.0), whole, max_relative = 1e-3);
        // 100 samples of 10 ms in each window.
        assert_relative_eq!(found(0.4975), whole / 2.0, max_relative = 1e-3);
    }

    #[test]
    fn a_steep_slope_at_rest_is_not_determined_where_the_velocity_is_not_known() {
        let data = measured("Threlfall", &[], &standard(1000), 0.01, 2);
        let verdict = |velocity_error: f64| {
            let data = [Experiment { velocity_error, reach: 0.01, ..data.clone() }];
            let problem = whole_problem("Threlfall", &data);
            let number = problem.unknowns.iter().position(|one| one.name == "transition_velocity").unwrap();
            let places: Vec<f64> = problem
                .unknowns
                .iter()
                .map(|one| {
                    let column = problem.law.find(&one.name).unwrap();
                    place(one, problem.law.table.at(column).start)
                })
                .collect();
            trust(&problem, &places, &white_noise(0.05)).verdicts.swap_remove(number)
        };
        assert_eq!(verdict(1e-6), Verdict::Determined);
        assert!(verdict(3e-3).to_string().contains("the velocity is not known well enough"), "{:?}", verdict(3e-3));
    }
}
