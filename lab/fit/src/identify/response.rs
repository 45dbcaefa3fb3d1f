//! The response of a law to an experiment, and its sensitivities.
//!
//! Between two samples the law is led at their mean velocity, load and acceleration, which is exact in the displacement;
//! at a sample it has those of the sample. A record that begins in motion begins in steady sliding; one that
//! begins at rest begins with the start values of the law, such as unloaded bristles.

use std::convert::Infallible;

use stribeck::instance::{Instance, Phase, Refused};
use stribeck::model::{InLanes, Law, Meaning, Model, ModelType, Steps, Visitor, model_in};
use stribeck::number::Dual;

use super::Experiment;
use super::map::{Sliding, steady_forces};

/// Columns of a law that a rig drives and reads.
#[derive(Clone, Copy, Debug)]
pub struct Ports {
    /// Input: velocity.
    pub velocity: usize,
    /// Input: normal force.
    pub load: usize,
    /// Output: friction force.
    pub force: usize,
    /// Input of the laws that differ as the contact speeds up or slows down.
    pub acceleration: Option<usize>,
}

impl Ports {
    /// None for a law of a contact that slides in two directions.
    pub fn of(law: &ModelType) -> Option<Ports> {
        let of = |meaning| law.table.of(meaning);
        if of(Meaning::VelocityY).is_some() {
            return None;
        }
        let [velocity, load, force] = [Meaning::Velocity, Meaning::NormalForce, Meaning::FrictionForce].map(of);
        let acceleration = of(Meaning::Acceleration);
        Some(Ports { velocity: velocity?, load: load?, force: force?, acceleration })
    }

    /// Columns and values of the inputs for velocity, load and acceleration.
    fn inputs(self, [v, n, a]: [f64; 3]) -> impl Iterator<Item = (usize, f64)> {
        self.acceleration.map(|column| (column, a)).into_iter().chain([(self.velocity, v), (self.load, n)])
    }
}

/// Way in m and time in s after which sliding is steady (chosen).
const WAY: f64 = 0.1;
const TIME: f64 = 1.0;

/// Time for which the first velocity is held before the record begins, if it begins in motion.
fn run_up(experiment: &Experiment) -> Option<f64> {
    experiment.begins_in_motion().then(|| f64::max(TIME, WAY / experiment.velocity[0].abs()))
}

/// Mean over a part of the interval that ends at a sample.
fn between(values: &[f64], at: usize, part: usize, parts: usize) -> f64 {
    let share = (part as f64 + 0.5) / parts as f64;
    values[at - 1] + share * (values[at] - values[at - 1])
}

/// Leads a contact through an experiment, with each interval divided into `parts`: its force at the samples. `drive` sets
/// velocity, load and acceleration.
fn lead<C, F, E>(
    contact: &mut C,
    (experiment, parts): (&Experiment, usize),
    drive: impl Fn(&mut C, [f64; 3]) -> Result<(), E>,
    step: impl Fn(&mut C, f64) -> Result<(), E>,
    force: impl Fn(&mut C) -> Result<F, E>,
) -> Result<Vec<F>, E> {
    let Experiment { time, velocity: v, normal_force: n, acceleration: a, .. } = experiment;
    drive(contact, [v[0], n[0], a[0]])?;
    if let Some(time) = run_up(experiment) {
        step(contact, time)?;
    }
    let mut found = Vec::with_capacity(time.len());
    found.push(force(contact)?);
    for at in 1..time.len() {
        for part in 0..parts {
            drive(contact, [v, n, a].map(|values| between(values, at, part, parts)))?;
            step(contact, (time[at] - time[at - 1]) / parts as f64)?;
        }
        drive(contact, [v[at], n[at], a[at]])?;
        found.push(force(contact)?);
    }
    Ok(found)
}

/// Friction force at the samples of an experiment, with each interval divided into `parts`.
pub(super) fn forces(
    instance: &mut Instance,
    ports: Ports,
    values: &[(usize, f64)],
    experiment: &Experiment,
    parts: usize,
) -> Result<Vec<f64>, Refused> {
    if experiment.map.is_some() {
        let inputs = |[v, n]: [f64; 2]| ports.inputs([v, n, 0.0]).collect();
        let sliding = Sliding { inputs: &inputs, force: ports.force };
        return steady_forces(instance, &sliding, values, experiment);
    }
    instance.reset();
    instance.set_all(Phase::Setup, values.iter().copied())?;
    instance.check().map_err(Refused::Value)?;
    let drive = |instance: &mut Instance, motion: [f64; 3]| {
        ports.inputs(motion).try_for_each(|(column, value)| instance.set_column(column, value))
    };
    let step = |instance: &mut Instance, dt: f64| instance.step(dt).map_err(Refused::NotFinite);
    lead(instance, (experiment, parts), drive, step, |instance| instance.get_column(ports.force))
}

/// A law whose steps are written for every number: its response carries exact derivatives.
#[derive(Clone, Copy)]
pub(super) struct Exact {
    step: fn(&mut [Dual], f64),
    output: fn(&mut [Dual]),
}

impl Exact {
    /// None for a law whose steps have modes: its sensitivities are differences.
    pub fn of(law: &ModelType) -> Option<Exact> {
        struct Search<'a>(&'a str, Option<Exact>);
        impl Visitor for Search<'_> {
            fn visit<M: Model>(&mut self) {}

            fn visit_in_lanes<M: InLanes>(&mut self) {
                if M::NAME == self.0 {
                    self.1 = Some(Exact {
                        step: |row, dt| Steps::advance(model_in::<M, Dual>(row), Dual::from(dt)),
                        output: |row| Law::output(model_in::<M, Dual>(row)),
                    });
                }
            }
        }
        let mut search = Search(law.name, None);
        stribeck::catalogue::visit(&mut search);
        search.1
    }

    /// As [`forces`], with its derivative in the direction of `seeds` (column, component), from the row of an instance
    /// that has the values of the parameters.
    pub fn forces(
        self,
        start: &[f64],
        ports: Ports,
        seeds: &[(usize, f64)],
        experiment: &Experiment,
        parts: usize,
    ) -> Vec<Dual> {
        let mut row: Vec<Dual> = start.iter().map(|value| Dual::from(*value)).collect();
        for (column, component) in seeds {
            row[*column].slope += component;
        }
        let drive = |row: &mut Vec<Dual>, motion: [f64; 3]| {
            ports.inputs(motion).for_each(|(column, value)| row[column] = Dual::from(value));
            Ok(())
        };
        let step = |row: &mut Vec<Dual>, dt: f64| {
            (self.step)(row, dt);
            Ok(())
        };
        let force = |row: &mut Vec<Dual>| {
            (self.output)(row);
            Ok(row[ports.force])
        };
        let Ok(found) = lead::<_, _, Infallible>(&mut row, (experiment, parts), drive, step, force);
        found
    }
}
