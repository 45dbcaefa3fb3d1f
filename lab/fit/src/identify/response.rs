//! The response of a law to an experiment, and its sensitivities.
//!
//! Between two samples the law is led at their mean velocity, load and acceleration, which is exact in the displacement;
//! at a sample it has those of the sample. A record that begins in motion begins in steady sliding; one that
//! begins at rest begins with the start values of the law, such as unloaded bristles.

use stribeck::instance::{Instance, Phase, Refused};
use stribeck::model::{InLanes, Law, Meaning, Model, ModelType, Steps, Visitor, model_in};
use stribeck::number::Dual;

use super::Experiment;

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

/// Friction force at the samples of an experiment, with each interval divided into `parts`.
pub(super) fn forces(
    instance: &mut Instance,
    ports: Ports,
    values: &[(usize, f64)],
    experiment: &Experiment,
    parts: usize,
) -> Result<Vec<f64>, Refused> {
    instance.reset();
    instance.set_all(Phase::Setup, values.iter().copied())?;
    instance.check().map_err(Refused::Value)?;
    let Experiment { velocity: v, normal_force: n, acceleration: a, .. } = experiment;
    let set = |instance: &mut Instance, v: f64, n: f64, a: f64| {
        if let Some(acceleration) = ports.acceleration {
            instance.set_column(acceleration, a)?;
        }
        instance.set_column(ports.velocity, v)?;
        instance.set_column(ports.load, n)
    };
    set(instance, v[0], n[0], a[0])?;
    if let Some(time) = run_up(experiment) {
        instance.step(time).map_err(Refused::NotFinite)?;
    }
    let mut found = Vec::with_capacity(v.len());
    found.push(instance.get_column(ports.force)?);
    for at in 1..v.len() {
        let step = (experiment.time[at] - experiment.time[at - 1]) / parts as f64;
        for part in 0..parts {
            let [v, n, a] = [v, n, a].map(|values| between(values, at, part, parts));
            set(instance, v, n, a)?;
            instance.step(step).map_err(Refused::NotFinite)?;
        }
        set(instance, v[at], n[at], a[at])?;
        found.push(instance.get_column(ports.force)?);
    }
    Ok(found)
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
        let Experiment { velocity: v, normal_force: n, acceleration: a, .. } = experiment;
        let set = |row: &mut [Dual], v: f64, n: f64, a: f64| {
            if let Some(acceleration) = ports.acceleration {
                row[acceleration] = Dual::from(a);
            }
            row[ports.velocity] = Dual::from(v);
            row[ports.load] = Dual::from(n);
        };
        set(&mut row, v[0], n[0], a[0]);
        if let Some(time) = run_up(experiment) {
            (self.step)(&mut row, time);
        }
        (self.output)(&mut row);
        let mut found = vec![row[ports.force]];
        for at in 1..v.len() {
            let step = (experiment.time[at] - experiment.time[at - 1]) / parts as f64;
            for part in 0..parts {
                let [v, n, a] = [v, n, a].map(|values| between(values, at, part, parts));
                set(&mut row, v, n, a);
                (self.step)(&mut row, step);
            }
            set(&mut row, v[at], n[at], a[at]);
            (self.output)(&mut row);
            found.push(row[ports.force]);
        }
        found
    }
}
