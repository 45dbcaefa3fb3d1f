//! Quantities fitted to the records of an axis, M a = F - f - offset (the model `Axis`).

use super::experiment::UNKNOWN_DIRECTION;
use super::{Experiment, Fault, ModelType, Selection};
use stribeck_measured::SLOW;

/// Law of its guides, unless another one is given.
pub const LAW: &str = "CoulombViscous";
/// Normal force in N, if none is known: a coefficient of friction is then the friction force in N.
pub const NORMAL_FORCE: f64 = 1.0;

/// Normal force of experiments that all are of an axis; None for others.
pub(super) fn load(experiments: &[Experiment]) -> Option<f64> {
    let load = *experiments.first()?.normal_force.first()?;
    let is_of_axis =
        |one: &Experiment| one.matched_filter.is_some() && one.normal_force.iter().all(|other| *other == load);
    experiments.iter().all(is_of_axis).then_some(load)
}

/// Adds mass and offset to the parameters, unless they are held; a mass that is known, other than 0 kg, is. The offset is
/// left out of laws with levels of both directions, which contain it.
pub fn fitted(selection: &mut Selection, mass: f64) {
    selection.is_offset_usual = !selection.fits("offset");
    for name in ["mass", "offset"] {
        let is_known = name == "mass" && mass != 0.0;
        if !is_known && selection.fixed(name).is_none() && !selection.fits(name) {
            selection.fitted.push(name.to_owned());
        }
    }
}

/// An experiment without its samples at rest: there the guides carry whatever force there is, and the sign of the
/// velocity is noise. If only [`LAW`] is fitted, without those that are slow either.
pub fn in_motion(experiment: Experiment, laws: &[&'static ModelType]) -> Result<Experiment, Fault> {
    let fastest = experiment.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let slow = if laws.iter().all(|law| law.name == LAW) { SLOW * fastest } else { 0.0 };
    let rest = f64::max(UNKNOWN_DIRECTION * experiment.velocity_error, slow);
    experiment.without_rest(rest)
}
