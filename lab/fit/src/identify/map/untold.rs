//! Parameters that a map does not tell.

use stribeck::instance::Instance;
use stribeck_solve::system::Fault;

use super::super::Estimate;
use super::super::parameter::{Parameter, Target, refused};
use super::super::problem::Problem;
use super::super::response::forces;
use super::super::uncertainty::{Verdict, digits};

/// Part of the largest force below which a large change of a parameter changes nothing (chosen: settled forces are
/// known to 1e-9, and their differences to about 1e-6).
const NOTHING: f64 = 1e-5;

/// Points all over the ranges at which the force is looked at (chosen).
const POINTS: usize = 8;

/// Points that fill the ranges evenly: multiples of the square roots of primes, without their whole parts.
fn points(count: usize) -> impl Iterator<Item = Vec<f64>> {
    let is_prime = |number: &usize| (2..*number).all(|part| !number.is_multiple_of(part));
    let roots: Vec<f64> = (2..).filter(is_prime).take(count).map(|prime| (prime as f64).sqrt()).collect();
    (1..=POINTS).map(move |number| roots.iter().map(|root| (number as f64 * root).fract()).collect())
}

/// Holds the parameters at their start values on which the force of steady sliding does not depend, anywhere in the
/// ranges. An error for a law without such a force.
pub(in crate::identify) fn hold_untold(problem: &mut Problem) -> Result<(), Fault> {
    for one in problem.experiments.iter() {
        forces(&mut Instance::new(problem.law), &problem.ports, &[], one, 1).map_err(|reason| {
            refused(problem.law, format_args!("has no force of steady sliding, which a map needs: {reason}"))
        })?;
    }
    let told = told(problem);
    let mut parameters = std::mem::take(&mut problem.parameters).into_iter().zip(told);
    let (told, untold): (Vec<_>, Vec<_>) = parameters.by_ref().partition(|(_, is_told)| *is_told);
    problem.parameters = told.into_iter().map(|(one, _)| one).collect();
    problem.pinned = vec![None; problem.parameters.len()];
    for (one, _) in untold {
        let start = start(problem, &one);
        if let Target::Excess { of, over } = one.target {
            problem.excess.push((of, over, start));
        }
        problem.untold.push((one, start));
    }
    Ok(())
}

/// Whether the force depends on each parameter.
fn told(problem: &Problem) -> Vec<bool> {
    let level = problem.measured().iter().fold(f64::MIN_POSITIVE, |most: f64, force| most.max(force.abs()));
    let mut told = vec![false; problem.parameters.len()];
    for point in points(told.len()).filter(|point| problem.residuals(point).is_some()) {
        let large = problem.large_changes(&problem.values(&point));
        for ((told, column), large) in told.iter_mut().zip(problem.sensitivities(&point)).zip(large) {
            *told |= column.iter().any(|slope| (slope * large).abs() > NOTHING * level);
        }
    }
    told
}

/// Start value of a parameter; 0 for what the rig has.
fn start(problem: &Problem, one: &Parameter) -> f64 {
    let start = |column: usize| problem.law.table.at(column).start;
    match one.target {
        Target::Column(column) => start(column),
        Target::Excess { of, over } => (start(of) - start(over)).max(0.0),
        Target::Mass | Target::Offset | Target::Delay => 0.0,
        Target::Cosine | Target::Sine | Target::Gravity => 0.0,
    }
}

/// The parameters that a map does not tell.
pub(in crate::identify) fn estimates<'a>(problem: &'a Problem) -> impl Iterator<Item = Estimate> + 'a {
    problem.untold.iter().map(|(one, start)| {
        let reason = "the force of steady sliding does not depend on it, so that a map cannot tell it; it is held at \
                      its start value";
        let unit = if one.unit == "1" { String::new() } else { format!(" {}", one.unit) };
        let Parameter { name, unit: of, target, meaning, .. } = one.clone();
        Estimate {
            name,
            unit: of,
            target,
            meaning,
            value: *start,
            deviation: f64::INFINITY,
            verdict: Verdict::Undetermined(format!("{reason}, {}{unit}", digits(*start))),
            linear: [f64::NEG_INFINITY, f64::INFINITY],
            profile: None,
            repeated: None,
        }
    })
}
