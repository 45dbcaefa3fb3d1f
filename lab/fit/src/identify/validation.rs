//! Experiments that a fit has not seen: what it leaves unexplained there says more than what it leaves where it was
//! fitted.

use stribeck::instance::Instance;
use stribeck::model::ModelType;

use super::ports::Ports;
use super::response::forces;
use super::{Experiment, Fit, Settings, Watch, fit};
use stribeck_solve::system::Fault;

/// An experiment that a fit has not seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Validation {
    /// Its name.
    pub name: String,
    /// RMS residual in it, N or N m.
    pub rms: f64,
    /// Its unit.
    pub unit: &'static str,
    /// The same in the experiments that were fitted, N.
    pub fitted: f64,
}

/// Factor between both from which a law does not hold in an experiment (chosen).
const WORSE: f64 = 1.5;

impl Validation {
    /// Whether clearly more is left than where the law was fitted.
    pub fn is_worse(&self) -> bool {
        self.rms > WORSE * self.fitted
    }

    /// Text for the user if it is.
    pub(super) fn warning(&self) -> Option<String> {
        self.is_worse().then(|| {
            format!(
                "{}: the RMS residual is {:.3e} {unit} in this validation record, {:.3e} {unit} in those that were fitted: the \
                 law or its values do not hold there",
                self.name,
                self.rms,
                self.fitted,
                unit = self.unit,
            )
        })
    }
}

/// Holds experiments against a fit that has not seen them.
pub fn held_out(fit: &Fit, experiments: &[Experiment]) -> Result<Vec<Validation>, Fault> {
    let refused = |name: &str, reason: String| Fault::value(format_args!("{name}: {}: {reason}", fit.law.name));
    let one = |experiment: &Experiment| {
        experiment.check(fit.law)?;
        let name = &experiment.name;
        let ports = Ports::of(fit.law).ok_or_else(|| refused(name, "slides in more than one direction".into()))?;
        let experiment = &as_fitted(fit, &ports, experiment);
        let friction = forces(&mut Instance::new(fit.law), &ports, &fit.physical.columns, experiment, fit.parts);
        let friction = friction.map_err(|reason| refused(name, reason.to_string()))?;
        let left = |at: usize| {
            let inertia = fit.physical.mass * experiment.acceleration[at];
            let gravity = fit.physical.gravity_at(experiment.direction.as_ref(), at);
            friction[at] + inertia + fit.physical.offset - experiment.force[at] + gravity
        };
        let counting: Vec<f64> = (0..friction.len()).filter(|at| experiment.counts(*at)).map(left).collect();
        if counting.is_empty() {
            return Err(refused(name, "all its samples are left out, at rest or at its ends".into()));
        }
        let square: f64 = counting.iter().map(|one| one * one).sum();
        let rms = (square / counting.len() as f64).sqrt();
        let unit = experiment.movement.unit("N");
        Ok(Validation { name: name.clone(), rms, unit, fitted: fit.residuals.rms })
    };
    experiments.iter().map(one).collect()
}

/// A record as those that were fitted: with the delay that was found, if its own is not known; for a law with two
/// branches without samples whose branch is not known, and for a mass that was found with all of the acceleration.
fn as_fitted(fit: &Fit, ports: &Ports, experiment: &Experiment) -> Experiment {
    let found = match fit.physical.delay {
        Some(delay) if experiment.delay_range.is_some() => {
            experiment.at_delay(delay).with_delay(fit.physical.delay).into_owned()
        }
        _ => experiment.clone(),
    };
    let found = if ports.acceleration.is_some() { found.of_known_branch() } else { found };
    let is_weighed = fit.estimates.iter().any(|one| one.name == "mass");
    if is_weighed { found.with_all_acceleration() } else { found }
}

/// Refuses a number of parts that experiments cannot be divided into.
pub(super) fn check_folds(parts: usize, count: usize) -> Result<(), Fault> {
    if (2..=count).contains(&parts) {
        return Ok(());
    }
    let text = format_args!("folds = {parts}: must be from 2 to the number of records, {count}");
    Err(Fault::value(text))
}

/// Fits a law to all parts but one, in turn, and holds the fit against that part: k-fold cross-validation by
/// experiment. Experiment i belongs to part i modulo `parts`.
pub(super) fn folds(
    law: &'static ModelType,
    experiments: &[Experiment],
    parts: usize,
    task: &Settings,
    watch: Watch,
) -> Result<Vec<Validation>, Fault> {
    let count = experiments.len();
    check_folds(parts, count)?;
    let quick = Settings { folds: 0, profiles: false, repetitions: 0, ..task.clone() };
    let mut found = Vec::with_capacity(count);
    for part in 0..parts {
        let take = |inside: bool| -> Vec<Experiment> {
            let chosen = experiments.iter().enumerate().filter(|(number, _)| (number % parts == part) == inside);
            chosen.map(|(_, one)| one.clone()).collect()
        };
        let fit = fit(law, &take(false), &quick, watch)?;
        found.extend(held_out(&fit, &take(true))?);
        if watch.is_cancelled() {
            break;
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{fitted, measured, quick, standard};
    use super::*;

    /// A motion that lags behind the force by 5 ms, of which the first guess is 0.
    #[test]
    fn a_record_is_judged_with_the_delay_that_was_found() {
        let clean = measured("Coulomb", &[], &standard(2000), 0.01, 1);
        let early = Experiment { delay: 0.0, delay_range: Some([-0.02, 0.02]), ..clean.shifted(-5e-3) };
        let force = clean.force.clone();
        let late = Experiment { force, ..early };
        let fit = fitted("Coulomb", std::slice::from_ref(&late), &quick());
        assert!((fit.physical.delay.unwrap() - 5e-3).abs() < 1e-3, "{:?}", fit.physical.delay);
        let validation = held_out(&fit, std::slice::from_ref(&late)).unwrap().swap_remove(0);
        assert!((validation.rms / fit.residuals.rms - 1.0).abs() < 0.05, "{validation:?} {}", fit.residuals.rms);
    }

    #[test]
    fn a_record_without_samples_that_count_is_refused() {
        let data = measured("Coulomb", &[], &standard(400), 0.01, 1);
        let fit = fitted("Coulomb", std::slice::from_ref(&data), &quick());
        let rest = Experiment { left_out: vec![true; 400], ..data };
        let text = held_out(&fit, &[rest]).unwrap_err().to_string();
        assert!(text.contains("all its samples are left out"), "{text}");
    }
}
