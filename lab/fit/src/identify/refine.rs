//! Intervals between samples, divided until that no longer changes a fit.

use std::sync::atomic::Ordering;

use super::Settings;
use super::problem::Found;
use super::problem::Problem;
use super::search::{Method, Watch, polish};
use super::uncertainty::{residuals, uncertainty};

/// Most parts of an interval, and the shift of the parameters, in standard deviations, that may be left (chosen).
const MOST_PARTS: usize = 16;
pub(super) const SHIFT: f64 = 0.2;

/// Divides the intervals between samples until that no longer shifts the parameters; the shift that is left, in standard
/// deviations.
pub(super) fn refine(problem: &mut Problem, mut best: Found, task: &Settings, watch: Watch) -> (Found, f64) {
    let is_polished = task.method == Method::Evolution;
    loop {
        let Some(here) = problem.residuals(&best.places) else { return (best, f64::INFINITY) };
        let finer = Problem { parts: 2 * problem.parts, ..problem.clone() };
        let Some(there) = finer.residuals(&best.places) else { return (best, f64::INFINITY) };
        let seen = residuals(&here, &problem.lengths(), problem.parameters.len(), problem.loss);
        let error: Vec<f64> = here.iter().zip(&there).map(|(here, there)| here - there).collect();
        let shift = uncertainty(problem, &best.places, &seen).shift(&error);
        let is_ended = watch.cancel.load(Ordering::Relaxed);
        if shift <= SHIFT || finer.parts > MOST_PARTS || is_ended {
            let is_corrected = is_polished && problem.parts > 1 && !is_ended;
            return (if is_corrected { polish(problem, &best) } else { best }, shift);
        }
        problem.parts = finer.parts;
        best = problem.judge(best);
        if is_polished {
            best = polish_by_corrections(problem, best);
        }
    }
}

/// Follows the slopes with intervals that are not divided, and with what that makes wrong at the best place taken from the
/// forces, until that place no longer gets better.
fn polish_by_corrections(problem: &Problem, mut best: Found) -> Found {
    for _ in 0..MOST_CORRECTIONS {
        let Some(quick) = problem.corrected(&best.places) else { break };
        let moved = problem.judge(polish(&quick, &quick.judge(best.clone())));
        if moved.cost >= (1.0 - CORRECTED) * best.cost {
            break;
        }
        best = moved;
    }
    best
}

/// Most corrections of the forces, and the part of the cost that one must gain for another one to follow (chosen).
const MOST_CORRECTIONS: usize = 6;
const CORRECTED: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::super::tests::{measured, standard, whole_problem};
    use super::*;

    /// Coarse samples of a fast relaxation: corrections with slopes of whole intervals gain nearly all that there is to gain,
    /// and the fit ends where the slopes of divided intervals lead.
    #[test]
    fn corrections_lead_to_the_least_squares_of_divided_intervals() {
        let data = [measured("MaxwellSlip", &[], &standard(600), 0.01, 3)];
        let mut problem = whole_problem("MaxwellSlip", &data);
        let middle = Found { places: vec![0.4; problem.parameters.len()], cost: f64::INFINITY, evaluations: 0 };
        let whole = polish(&problem, &middle);
        let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
        let (refined, shift) = refine(&mut problem, whole.clone(), &Settings::default(), watch);
        assert!(problem.parts >= 8 && shift <= SHIFT, "{} {shift}", problem.parts);
        let start = problem.judge(whole);
        let slow = polish(&problem, &start);
        let corrected = polish_by_corrections(&problem, start.clone());
        let gain = start.cost - slow.cost;
        let variance = 2.0 * slow.cost / problem.samples() as f64;
        let [left_of_corrected, left] = [&corrected, &refined].map(|found| found.cost - slow.cost);
        assert!(gain > variance && left_of_corrected < 1e-3 * gain, "{gain:e} {left_of_corrected:e} {variance:e}");
        assert!(left.abs() < 0.01 * variance, "{left:e} {variance:e}");
    }
}
