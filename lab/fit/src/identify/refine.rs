//! Intervals between samples, divided until that no longer changes a fit.

use super::Settings;
use super::problem::{Found, Problem, minus};
use super::search::{Method, Watch, polish};
use super::uncertainty::{Residuals, uncertainty};

/// Most parts of an interval, and the shift of the parameters, in standard deviations, that may be left (chosen).
const MOST_PARTS: usize = 16;
pub(super) const SHIFT: f64 = 0.2;

/// A point after [`refine`].
pub(super) struct Refined {
    pub found: Found,
    /// Shift of the parameters if the intervals were divided once more, in standard deviations.
    pub shift: f64,
}

/// Divides the intervals between samples until that no longer shifts the parameters.
pub(super) fn refine(problem: &mut Problem, mut found: Found, task: &Settings, watch: Watch) -> Refined {
    let is_polished = task.method == Method::Evolution;
    loop {
        let finer = Problem { parts: 2 * problem.parts, ..problem.clone() };
        let both = problem.residuals(&found.point).zip(finer.residuals(&found.point));
        let Some((here, there)) = both else { return Refined { found, shift: f64::INFINITY } };
        let residuals = Residuals::of_fit(problem, &here);
        let shift = uncertainty(problem, &found.point, &residuals).shift(&minus(&here, &there));
        let is_ended = watch.is_cancelled();
        if shift <= SHIFT || finer.parts > MOST_PARTS || is_ended {
            let is_corrected = is_polished && problem.parts > 1 && !is_ended;
            return Refined { found: if is_corrected { polish(problem, &found) } else { found }, shift };
        }
        problem.parts = finer.parts;
        found = problem.judge(found);
        if is_polished {
            found = polish_by_corrections(problem, found);
        }
    }
}

/// Follows the slopes with intervals that are not divided, and with what that makes wrong at the best point taken from the
/// forces, until that point no longer gets better.
fn polish_by_corrections(problem: &Problem, mut best: Found) -> Found {
    for _ in 0..MOST_CORRECTIONS {
        let Some(quick) = problem.corrected(&best.point) else { break };
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
        let middle = Found { point: vec![0.4; problem.parameters.len()], cost: f64::INFINITY, evaluations: 0 };
        let whole = polish(&problem, &middle);
        let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
        let Refined { found: refined, shift } = refine(&mut problem, whole.clone(), &Settings::default(), watch);
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
