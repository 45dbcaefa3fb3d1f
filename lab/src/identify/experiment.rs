//! Experiments as a fit needs them.

use crate::measured::Record;
use crate::system::Fault;

/// A run of a rig: the motion and the load that the law is led through, and the force it shall give.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// Its name.
    pub name: String,
    /// Time, s.
    pub time: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Acceleration, m/s2.
    pub acceleration: Vec<f64>,
    /// Normal force, N.
    pub normal_force: Vec<f64>,
    /// Force of the load cell: m a + f_f + offset, N.
    pub force: Vec<f64>,
    /// Error of the velocity around rest, m/s; 0 if it is not known.
    pub velocity_error: f64,
}

impl Experiment {
    /// A record of a rig.
    pub fn new(name: &str, record: &Record) -> Experiment {
        Experiment {
            name: name.to_owned(),
            time: record.time.clone(),
            velocity: record.velocity.clone(),
            acceleration: record.acceleration.clone(),
            normal_force: record.normal_force.clone(),
            force: record.force.clone(),
            velocity_error: record.velocity_error,
        }
    }

    /// The same with `parts` intervals joined to one; the force is the one at the samples that are left.
    pub(super) fn coarser(&self, parts: usize) -> Experiment {
        let take = |values: &[f64]| values.iter().copied().step_by(parts).collect();
        Experiment {
            name: self.name.clone(),
            time: take(&self.time),
            velocity: take(&self.velocity),
            acceleration: take(&self.acceleration),
            normal_force: take(&self.normal_force),
            force: take(&self.force),
            velocity_error: self.velocity_error,
        }
    }

    /// Length, s.
    pub fn duration(&self) -> f64 {
        self.time[self.time.len() - 1] - self.time[0]
    }

    /// Whether it begins in motion: faster than a hundredth of the highest speed, below which it is noise (chosen).
    pub fn begins_in_motion(&self) -> bool {
        let fastest = self.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        self.velocity[0].abs() > 0.01 * fastest
    }

    /// Range of the displacement, m.
    pub(super) fn travel(&self) -> f64 {
        let (mut x, mut low, mut high) = (0.0, 0.0f64, 0.0f64);
        for at in 1..self.time.len() {
            x += self.mean_velocity(at - 1) * (self.time[at] - self.time[at - 1]);
            (low, high) = (low.min(x), high.max(x));
        }
        high - low
    }

    /// Mean velocity between a sample and the next one.
    pub(super) fn mean_velocity(&self, at: usize) -> f64 {
        0.5 * (self.velocity[at] + self.velocity[at + 1])
    }

    /// Refuses columns that do not fit each other, and values that no rig has.
    pub(super) fn check(&self) -> Result<(), Fault> {
        let name = &self.name;
        let count = self.time.len();
        let columns: [(&str, &[f64]); 5] = [
            ("time", &self.time),
            ("velocity", &self.velocity),
            ("acceleration", &self.acceleration),
            ("normal_force", &self.normal_force),
            ("force", &self.force),
        ];
        for (column, values) in columns {
            if values.len() != count || count < 2 {
                let text = format_args!("{name}: {column} has {} values, time has {count}; at least 2", values.len());
                return Err(Fault::value(text));
            }
            if let Some(at) = values.iter().position(|value| !value.is_finite()) {
                return Err(Fault::value(format_args!("{name}: {column}[{at}] = {}: must be finite", values[at])));
            }
        }
        if let Some(at) = (1..count).find(|at| self.time[*at] <= self.time[at - 1]) {
            return Err(Fault::value(format_args!("{name}: time[{at}] = {}: times must ascend", self.time[at])));
        }
        for (column, values) in [("velocity", &self.velocity), ("normal_force", &self.normal_force)] {
            if values.iter().all(|value| *value == 0.0) {
                return Err(Fault::value(format_args!(
                    "{name}: {column} is 0 throughout, so that no friction can be seen"
                )));
            }
        }
        if let Some(at) = self.normal_force.iter().position(|load| *load < 0.0) {
            let text = format_args!("{name}: normal_force[{at}] = {}: must be >= 0", self.normal_force[at]);
            return Err(Fault::value(text));
        }
        Ok(())
    }
}
