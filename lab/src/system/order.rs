//! Order in which the outputs of a system are computed and passed on.

use stribeck::model::{Kind, ModelType, Role};
use stribeck::number::elementary::pow;

use super::part::{System, Wire, WireSource};
use super::{Fault, Place};

/// A step of evaluating a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// Computes the outputs of a part.
    Output(usize),
    /// Passes a value on.
    Pass { from: Place, to: Place },
}

/// Random rows on which the dependencies of a model are looked for (chosen).
const TRIALS: usize = 100;

/// The tasks that give every connected input its value.
pub(super) fn tasks(system: &System) -> Result<Vec<Task>, Fault> {
    let influences: Vec<Influence> = system.parts.iter().map(|part| Influence::of(part.model, &part.row)).collect();
    let mut open: Vec<(Wire, Place)> = Vec::new();
    for wire in &system.wires {
        match wire.from {
            WireSource::Variable(from) => open.push((*wire, from)),
            // Steps with slopes know the derivative of what they step along; there is nothing to pass on.
            WireSource::Derivative(_) => {}
        }
    }
    let mut tasks = Vec::new();
    while !open.is_empty() {
        let waits = |from: &Place| {
            influences[from.part]
                .inputs(from.column)
                .any(|column| open.iter().any(|(wire, _)| wire.to == Place { part: from.part, column }))
        };
        let ready: Vec<(Wire, Place)> = open.iter().filter(|(_, from)| !waits(from)).copied().collect();
        if ready.is_empty() {
            let names: Vec<String> = open.iter().map(|(_, from)| system.name(*from)).collect();
            return Err(Fault::Loop { outputs: names.join(", ") });
        }
        let mut computed = Vec::new();
        for (wire, from) in &ready {
            if system.variable(*from).role.is_computed() && !computed.contains(&from.part) {
                computed.push(from.part);
                tasks.push(Task::Output(from.part));
            }
            tasks.push(Task::Pass { from: *from, to: wire.to });
        }
        open.retain(|wire| !ready.contains(wire));
    }
    // The outputs of all parts come first in each round, so that a pass does not disturb them.
    Ok(tasks)
}

/// The inputs on which each output of a model depends.
struct Influence {
    /// Per column, the inputs that change it.
    on: Vec<Vec<usize>>,
}

impl Influence {
    /// Looks for dependencies by changing one input after the other, at random states.
    fn of(model: &ModelType, start: &[f64]) -> Influence {
        let inputs: Vec<usize> =
            (0..start.len()).filter(|column| model.table.at(*column).role == Role::Input).collect();
        let outputs: Vec<usize> =
            (0..start.len()).filter(|column| model.table.at(*column).role.is_computed()).collect();
        let mut on = vec![Vec::new(); start.len()];
        if model.memory_in_use(start) > 0 {
            // A model whose memory is beside the row: take every output to depend on every input.
            for output in &outputs {
                on[*output] = inputs.clone();
            }
            return Influence { on };
        }
        let mut random = Random(0x2545_f491_4f6c_dd1d);
        for _ in 0..TRIALS {
            let mut row = start.to_vec();
            for (value, variable) in row.iter_mut().zip(model.table) {
                if variable.role == Role::Input || variable.role.is_state() {
                    *value = random.value(&variable);
                }
            }
            let mut before = row.clone();
            model.output(&mut before);
            for input in &inputs {
                let mut changed = row.clone();
                changed[*input] = random.value(&model.table.at(*input));
                model.output(&mut changed);
                for output in &outputs {
                    if changed[*output].to_bits() != before[*output].to_bits() && !on[*output].contains(input) {
                        on[*output].push(*input);
                    }
                }
            }
        }
        Influence { on }
    }

    fn inputs(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
        self.on[column].iter().copied()
    }
}

/// A small generator of random numbers (xorshift), so that the order of a system is the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A value of either sign, of any size around the usual one.
    fn value(&mut self, variable: &stribeck::model::Variable) -> f64 {
        if let Kind::Enumeration(choices) = variable.kind {
            return 1.0 + (self.unit() * choices.items.len() as f64).floor();
        }
        let size = pow(10.0, 4.0 * self.unit() - 3.0) * variable.nominal.max(variable.start.abs());
        let value = if self.unit() < 0.5 { size } else { -size };
        let value = variable.bound.nearest(value);
        if matches!(variable.kind, Kind::Real(_)) { value } else { value.round() }
    }
}
