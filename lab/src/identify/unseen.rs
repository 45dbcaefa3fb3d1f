//! Experiments that a fit has not seen: what it leaves unexplained there says more than what it leaves where it was
//! fitted.

use std::sync::atomic::Ordering;

use stribeck::instance::Instance;
use stribeck::model::ModelType;

use super::response::{Ports, forces};
use super::{Experiment, Fit, Task, Watch, fit};
use crate::system::Fault;

/// An experiment that a fit has not seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Unseen {
    /// Its name.
    pub name: String,
    /// Root mean square of what is not explained in it, N.
    pub rms: f64,
    /// The same in the experiments that were fitted, N.
    pub fitted: f64,
}

/// Factor between both from which a law does not hold in an experiment (chosen).
const WORSE: f64 = 1.5;

impl Unseen {
    /// Whether clearly more is left than where the law was fitted.
    pub fn is_worse(&self) -> bool {
        self.rms > WORSE * self.fitted
    }

    /// Text for the user if it is.
    pub(super) fn warning(&self) -> Option<String> {
        self.is_worse().then(|| {
            format!(
                "{}: {:.3e} N is not explained in this record, which was not fitted, {:.3e} N in those that were: the \
                 law or its values do not hold there",
                self.name, self.rms, self.fitted
            )
        })
    }
}

/// Holds experiments against a fit that has not seen them.
pub fn held_out(fit: &Fit, experiments: &[Experiment]) -> Result<Vec<Unseen>, Fault> {
    let refused = |name: &str, reason: String| Fault::value(format_args!("{name}: {}: {reason}", fit.law.name));
    let one = |experiment: &Experiment| {
        experiment.check()?;
        let name = &experiment.name;
        let ports = Ports::of(fit.law).ok_or_else(|| refused(name, "slides in more than one direction".into()))?;
        let experiment = &if ports.acceleration.is_some() { experiment.of_known_branch() } else { experiment.clone() };
        let friction = forces(&mut Instance::new(fit.law), ports, &fit.columns, experiment, fit.parts);
        let friction = friction.map_err(|reason| refused(name, reason.to_string()))?;
        let left =
            |at: usize| friction[at] + fit.mass * experiment.acceleration[at] + fit.offset - experiment.force[at];
        let counting: Vec<f64> = (0..friction.len()).filter(|at| experiment.counts(*at)).map(left).collect();
        let square: f64 = counting.iter().map(|one| one * one).sum();
        let rms = (square / counting.len().max(1) as f64).sqrt();
        Ok(Unseen { name: name.clone(), rms, fitted: fit.residuals.rms })
    };
    experiments.iter().map(one).collect()
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
    task: &Task,
    watch: Watch,
) -> Result<Vec<Unseen>, Fault> {
    let count = experiments.len();
    check_folds(parts, count)?;
    let quick = Task { folds: 0, profiles: false, repetitions: 0, ..task.clone() };
    let mut found = Vec::with_capacity(count);
    for part in 0..parts {
        let take = |inside: bool| -> Vec<Experiment> {
            let chosen = experiments.iter().enumerate().filter(|(number, _)| (number % parts == part) == inside);
            chosen.map(|(_, one)| one.clone()).collect()
        };
        let fit = fit(law, &take(false), &quick, watch)?;
        found.extend(held_out(&fit, &take(true))?);
        if watch.cancel.load(Ordering::Relaxed) {
            break;
        }
    }
    Ok(found)
}
