//! The parts of a system as instances that make steps.

use stribeck::catalogue::{self, Family};
use stribeck::instance::{Instance, Snapshot};
use stribeck::model::Meaning;

use crate::system::{Fault, Place, System, WireSource};

/// The times that were reached, and the recorded values, one array each.
pub type Recorded = (Vec<f64>, Vec<Vec<f64>>);

/// The instances of a system, in the order of their steps.
pub struct Train<'a> {
    /// The system.
    pub system: &'a System,
    instances: Vec<Instance>,
    /// Numbers of the parts: hosts in the direction of their connections, then what acts on them.
    pub order: Vec<usize>,
    /// Present time.
    pub time: f64,
}

impl<'a> Train<'a> {
    /// The parts at their start values.
    pub fn new(system: &'a System) -> Result<Train<'a>, Fault> {
        let mut instances = Vec::new();
        for part in &system.parts {
            let mut instance = Instance::new(part.model);
            for (column, variable) in part.model.table.iter().enumerate() {
                let value = part.row[column];
                if !variable.role.is_computed() && value != variable.start {
                    instance
                        .set_column(column, value)
                        .map_err(|refused| Fault::value(format_args!("{}: {refused}", part.name)))?;
                }
            }
            instances.push(instance);
        }
        Ok(Train { system, instances, order: order(system), time: 0.0 })
    }

    /// The value of a source at the present communication point.
    pub fn value(&mut self, source: WireSource) -> Result<f64, String> {
        match source {
            WireSource::Variable(place) => {
                let instance = &mut self.instances[place.part];
                instance.get_column(place.column).map_err(|refused| refused.to_string())
            }
            WireSource::Derivative(place) => {
                let instance = &mut self.instances[place.part];
                instance.rates().map(|rates| rates[place.column]).map_err(|fault| fault.0)
            }
        }
    }

    /// A variable that needs no computing: an input or a state.
    pub fn state(&self, place: Place) -> f64 {
        self.instances[place.part].row()[place.column]
    }

    /// Sets an input.
    pub fn put(&mut self, to: Place, value: f64) -> Result<(), String> {
        let name = || self.system.name(to);
        let refusal = |refused| format!("{}: {refused}", name());
        self.instances[to.part].set_column(to.column, value).map_err(refusal)
    }

    /// Gives an input a slope over the next step.
    pub fn slope(&mut self, to: Place, slope: f64) -> Result<(), String> {
        self.instances[to.part].set_slope(to.column, slope).map_err(|refused| refused.to_string())
    }

    /// Makes a step of a part.
    pub fn step(&mut self, part: usize, h: f64) -> Result<(), String> {
        let name = &self.system.parts[part].name;
        self.instances[part].step(h).map_err(|fault| format!("{name}: {}", fault.0))
    }

    /// Sets all inputs from their sources at the present time, again and again until nothing changes.
    pub fn settle(&mut self) -> Result<(), String> {
        for (place, signal) in self.system.signals.clone() {
            self.put(place, signal.at(self.time).0)?;
        }
        let wires = self.system.wires.clone();
        for _ in 0..=wires.len() {
            let mut changed = false;
            for wire in &wires {
                let value = self.value(wire.from)?;
                if value.to_bits() != self.state(wire.to).to_bits() {
                    self.put(wire.to, value)?;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        Ok(())
    }

    /// The state of all parts.
    pub fn save(&self) -> Vec<Snapshot> {
        self.instances.iter().map(Instance::save).collect()
    }

    /// Writes the state of all parts into saved ones.
    pub fn save_into(&self, saved: &mut [Snapshot]) {
        for (instance, saved) in self.instances.iter().zip(saved) {
            instance.save_into(saved);
        }
    }

    /// Restores the state of all parts.
    pub fn restore(&mut self, saved: &[Snapshot]) {
        for (instance, saved) in self.instances.iter_mut().zip(saved) {
            instance.restore(saved);
        }
    }

    /// The continuous states of all parts: motion and energies.
    pub fn states(&self) -> Vec<Place> {
        let mut states = Vec::new();
        for (part, made) in self.system.parts.iter().enumerate() {
            let is_host = is_host(self.system, part);
            for column in made.model.continuous_states() {
                if is_host || made.model.table.at(column).meaning == Meaning::Energy {
                    states.push(Place { part, column });
                }
            }
        }
        states
    }
}

/// Whether a part is a body that forces move.
pub fn is_host(system: &System, part: usize) -> bool {
    catalogue::documented(Family::Host).any(|(model, _)| model == system.parts[part].model)
}

/// Hosts in the direction of their connections, then the others.
fn order(system: &System) -> Vec<usize> {
    let parts = || 0..system.parts.len();
    let mut order: Vec<usize> = Vec::new();
    let mut rest: Vec<usize> = parts().filter(|part| is_host(system, *part)).collect();
    while !rest.is_empty() {
        let feeds = |from: usize, to: usize| {
            system.wires.iter().any(|wire| {
                wire.to.part == to && matches!(wire.from, WireSource::Variable(place) if place.part == from)
            })
        };
        let first = rest.iter().position(|to| !rest.iter().any(|from| from != to && feeds(*from, *to))).unwrap_or(0);
        order.push(rest.remove(first));
    }
    order.extend(parts().filter(|part| !is_host(system, *part)));
    order
}
