//! Friction of steady sliding.

use std::sync::atomic::AtomicBool;

use stribeck::instance::{Instance, Phase, Refused};
use stribeck::model::Fault;
use stribeck::series::{Ended, settle};

use super::super::Experiment;

/// Columns of a law in steady sliding.
pub(in crate::identify) struct Sliding<'a> {
    /// Columns and values of the inputs at a velocity and a load.
    pub inputs: &'a dyn Fn([f64; 2]) -> Vec<(usize, f64)>,
    /// Column of the friction force.
    pub force: usize,
}

/// Settled force at the velocity and load of each row; rows of the same are computed once.
pub(in crate::identify) fn steady_forces(
    instance: &mut Instance,
    sliding: &Sliding,
    values: &[(usize, f64)],
    experiment: &Experiment,
) -> Result<Vec<f64>, Refused> {
    let mut known: Vec<([f64; 2], f64)> = Vec::new();
    let one = |at: usize| {
        let inputs = [experiment.velocity[at], experiment.normal_force[at]];
        if let Some((_, force)) = known.iter().find(|(other, _)| *other == inputs) {
            return Ok(*force);
        }
        let force = settled(instance, sliding, values, inputs)?;
        known.push((inputs, force));
        Ok(force)
    };
    (0..experiment.time.len()).map(one).collect()
}

/// The force of a law that has settled.
fn settled(
    instance: &mut Instance,
    Sliding { inputs, force }: &Sliding,
    values: &[(usize, f64)],
    [v, n]: [f64; 2],
) -> Result<f64, Refused> {
    instance.reset();
    instance.set_all(Phase::Setup, values.iter().copied())?;
    instance.check().map_err(Refused::Value)?;
    let inputs = inputs([v, n]);
    // At rest the force is whatever holds, and such rows are left out.
    if v == 0.0 {
        inputs.iter().try_for_each(|(column, value)| instance.set_column(*column, *value))?;
        return instance.get_column(*force);
    }
    let mut found = [0.0];
    match settle(instance, &inputs, &[*force], &mut found, &AtomicBool::new(false)) {
        Ok(()) => Ok(found[0]),
        Err(Ended::Setup(reason)) => Err(*reason),
        Err(other) => Err(Refused::Value(Fault::new(format_args!("{other}")))),
    }
}
