//! What a fit warns of.

use stribeck::model::Meaning;

use super::experiment::UNKNOWN_DIRECTION;
use super::problem::Problem;
use super::refine::SHIFT;
use super::search::Searches;
use super::uncertainty::{Residuals, SYSTEMATIC, Verdict, digits};
use super::velocity_error::{self, BLURRED};
use super::{Estimate, Experiment, Target, map};

/// Correlation of neighbours from which it is not noise that is left, although it swings so often that few samples count
/// as one (chosen).
const ALIKE: f64 = 0.3;

/// Everything to warn of in a fit with what is `left`; `shift` is that of [`super::refine`].
pub(super) fn warnings(
    problem: &Problem,
    (left, residuals): (&[f64], &Residuals),
    estimates: &[Estimate],
    searches: Searches,
    shift: f64,
) -> Vec<String> {
    let not_noise = if problem.is_map() { map::warnings(problem, left) } else { not_noise(residuals) };
    let of_fit = [not_found(searches), too_coarse(shift), not_noise].into_iter().flatten();
    let experiments = || problem.experiments.iter();
    let systematic = experiments().filter(|_| residuals.correlation > SYSTEMATIC);
    let relaxed = systematic.filter_map(|one| relaxed(one, estimates));
    let blurred = experiments().filter_map(|one| blurred(problem, one, estimates));
    of_fit.chain(relaxed).chain(estimates.iter().filter_map(at_end)).chain(blurred).collect()
}

fn not_found(searches: Searches) -> Option<String> {
    let text = "searches over the whole range ended at different values: raise the budget, or narrow the ranges";
    (searches == Searches::Disagree).then(|| text.to_owned())
}

fn too_coarse(shift: f64) -> Option<String> {
    (shift > SHIFT).then(|| {
        format!(
            "the samples are too far apart: dividing their intervals once more shifts a value by {shift:.1} standard \
             deviations"
        )
    })
}

fn not_noise(Residuals { correlation, neighbours, .. }: &Residuals) -> Option<String> {
    if *correlation > SYSTEMATIC {
        Some(format!(
            "the residuals are not noise (correlation time {correlation:.0} samples): law, clocks or mass are not those \
             of the rig, and the intervals may not hold"
        ))
    } else {
        (*neighbours > ALIKE).then(|| {
            format!(
                "the residuals are not noise (neighbours are correlated by {neighbours:.2}): an effect outside the law \
                 acts, such as a ripple along the way or another delay, and the intervals may not hold"
            )
        })
    }
}

fn at_end(estimate: &Estimate) -> Option<String> {
    let Verdict::AtEnd(end) = estimate.verdict else { return None };
    let unit = if estimate.unit == "1" { String::new() } else { format!(" {}", estimate.unit) };
    Some(format!("{} is at an end of its range ({}{unit})", estimate.name, digits(end)))
}

/// Way to and fro at rest, as a part of the way by which the contact yields, from which its friction is taken to relax
/// (chosen).
const RELAXED: f64 = 0.1;

/// Warns of noise of a measured velocity that moves a contact at rest to and fro: friction that builds up over a distance
/// then relaxes in the law, although the rig held it.
fn relaxed(experiment: &Experiment, estimates: &[Estimate]) -> Option<String> {
    let error = velocity_error::error(experiment);
    if experiment.window > 0.0 || error == 0.0 {
        return None;
    }
    let value = |meaning: Meaning| estimates.iter().find(|one| one.meaning == meaning).map(|one| one.value);
    let (stiffness, level) = (value(Meaning::Stiffness)?, value(Meaning::KineticLevel)?);
    let load = experiment.normal_force.iter().fold(0.0, |most: f64, load| most.max(*load));
    let yields = level * load / stiffness;
    let is_at_rest = |at: usize| experiment.velocity[at].abs() < UNKNOWN_DIRECTION * error;
    let rest = (0..experiment.time.len() - 1).filter(|at| is_at_rest(*at) && is_at_rest(at + 1));
    let step = |at: usize| experiment.mean_velocity(at).abs() * (experiment.time[at + 1] - experiment.time[at]);
    let way: f64 = rest.map(step).sum();
    (way > RELAXED * yields).then(|| {
        format!(
            "{}: noise of the velocity, {error:.1e} {}, moves the resting contact to and fro by {way:.1e} {length} in all, \
             with a pre-sliding displacement of {yields:.1e} {length}: its friction relaxes in the law although the rig held it; give \
             the displacement instead of the velocity",
            experiment.name,
            experiment.movement.unit("m/s"),
            length = experiment.movement.unit("m")
        )
    })
}

/// Warns of a velocity that is not known well enough where friction falls with it: the static level then looks lower
/// and the Stribeck velocity higher than they are, while the residuals look fine.
fn blurred(problem: &Problem, experiment: &Experiment, estimates: &[Estimate]) -> Option<String> {
    let known = |target: Target| estimates.iter().find(|one| one.target == target).map(|one| one.value);
    let (name, speed) = velocity_error::speed_of_fall(problem, known)?;
    let error = experiment.velocity_error;
    let damping = estimates.iter().find(|one| one.meaning == Meaning::Damping);
    let damping = damping.map_or(String::new(), |one| format!(", {} gets no number", one.name));
    (error > BLURRED * speed).then(|| {
        format!(
            "{}: the velocity around rest is known to {error:.1e} {unit} only, with {name} = {speed:.1e} {unit}: the static \
             level is found too low and {name} too high{damping}; measure the velocity, or sample the motion faster",
            experiment.name,
            unit = experiment.movement.unit("m/s")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::{fitted, measured, noise, quick, standard};
    use super::*;

    /// Strokes of 0.25 s and pauses of 0.75 s, in which the contact holds its force.
    #[test]
    fn a_velocity_that_is_noise_at_rest_is_warned_of() {
        let even = standard(2000);
        let stroke = |t: f64| {
            let (part, direction) = (t % 1.0, if t % 2.0 < 1.0 { 1.0 } else { -1.0 });
            if part < 0.25 { 0.02 * direction * (part * std::f64::consts::TAU * 2.0).sin() } else { 0.0 }
        };
        let velocity = even.time.iter().map(|t| stroke(*t)).collect();
        let clean = measured("Dahl", &[], &Experiment { velocity, ..even }, 0.01, 2);
        let error = 2e-5;
        let velocity = clean.velocity.iter().zip(noise(5, 2000)).map(|(v, noise)| v + error * noise).collect();
        let noisy = Experiment { velocity, velocity_error: error, ..clean.clone() };
        let [clean, filtered, noisy] = [clean, Experiment { window: 0.02, ..noisy.clone() }, noisy]
            .map(|experiment| fitted("Dahl", &[experiment], &quick()).warnings);
        let is_warned = |list: &[String]| list.iter().any(|one| one.contains("give the displacement"));
        assert!(is_warned(&noisy), "{noisy:?}");
        assert!(!is_warned(&filtered) && !is_warned(&clean), "{filtered:?} {clean:?}");
    }
}
