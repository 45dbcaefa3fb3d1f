//! Order in which the outputs of a system are computed and passed on.

use stribeck::catalogue::{Family, documented};
use stribeck::model::{Kind, Role, Variable};
use stribeck::number::elementary::exp;

use super::part::{Part, System, Wire, WireSource};
use super::{Fault, Place, Signal};

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
pub(super) fn tasks(system: &System, influences: &[Influence]) -> Result<Vec<Task>, Fault> {
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
            influences[from.part].on[from.column]
                .iter()
                .any(|column| open.iter().any(|(wire, _)| wire.to == Place { part: from.part, column: *column }))
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

/// The columns of each part that change in time: integrated states, inputs that are given as signals, and what they
/// change through the parts.
pub(super) fn moving(system: &System, influences: &[Influence], states: &[Place]) -> Vec<Vec<usize>> {
    let signals = system.signals.iter().filter(|(_, signal)| !matches!(signal, Signal::Constant(_)));
    let mut moving = vec![Vec::new(); system.parts.len()];
    for Place { part, column } in states.iter().copied().chain(signals.map(|(place, _)| *place)) {
        moving[part].push(column);
    }
    loop {
        let moves = |from: WireSource| match from {
            WireSource::Variable(Place { part, column }) => {
                let on = &influences[part].on[column];
                moving[part].contains(&column) || on.iter().any(|column| moving[part].contains(column))
            }
            WireSource::Derivative(_) => true,
        };
        let is_new = |wire: &&Wire| !moving[wire.to.part].contains(&wire.to.column) && moves(wire.from);
        let Some(to) = system.wires.iter().find(is_new).map(|wire| wire.to) else { return moving };
        moving[to.part].push(to.column);
    }
}

/// Whether event indicators of a part depend on one of these columns. Those of laws are looked at, whose indicators are
/// simple; the others are taken to.
pub(super) fn indicators_move(part: &Part, moving: &[usize]) -> bool {
    let is_law = documented(Family::Friction).any(|(law, _)| law.name == part.model.name);
    let count = part.model.event_indicators;
    if !is_law || part.model.memory_in_use(&part.row) > 0 {
        return count > 0;
    }
    let indicators = |row: &mut Vec<f64>| {
        let mut values = vec![0.0; count];
        part.model.indicate(row, &mut values);
        *row = values;
    };
    let mut found = false;
    try_columns(part, moving, indicators, |_, _| found = true);
    found
}

fn columns(part: &Part, wanted: impl Fn(Role) -> bool) -> Vec<usize> {
    (0..part.row.len()).filter(|column| wanted(part.model.table.at(*column).role)).collect()
}

/// Inputs and states.
fn free(part: &Part) -> Vec<usize> {
    columns(part, |role| role == Role::Input || role.is_state())
}

/// Changes one of some columns after the other in random rows; `answer` replaces a row by values that follow from it, and
/// `differs` hears of each value that a column changes.
fn try_columns(part: &Part, some: &[usize], answer: impl Fn(&mut Vec<f64>), mut differs: impl FnMut(usize, usize)) {
    let table = &part.model.table;
    let of_column = |column: usize| (column, table.at(column));
    let variables: Vec<(usize, Variable)> = free(part).into_iter().map(of_column).collect();
    let some: Vec<(usize, Variable)> = some.iter().copied().map(of_column).collect();
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for _ in 0..TRIALS {
        let mut row = part.row.clone();
        variables.iter().for_each(|(column, variable)| row[*column] = random.value(variable));
        let mut before = row.clone();
        answer(&mut before);
        for (column, variable) in &some {
            let mut after = row.clone();
            after[*column] = random.value(variable);
            answer(&mut after);
            let values = before.iter().zip(&after).enumerate();
            let others = values.filter(|(_, (before, after))| before.to_bits() != after.to_bits());
            others.for_each(|(value, _)| differs(value, *column));
        }
    }
}

/// The inputs and states on which each output of a model depends.
pub(super) struct Influence {
    /// Per column, those that change it.
    on: Vec<Vec<usize>>,
}

impl Influence {
    /// Looks for dependencies by changing one column after the other, at random states.
    pub fn of(part: &Part) -> Influence {
        let (outputs, some) = (columns(part, Role::is_computed), free(part));
        let mut on = vec![Vec::new(); part.row.len()];
        if part.model.memory_in_use(&part.row) > 0 {
            // A model whose memory is beside the row: take every output to depend on all of them.
            for output in &outputs {
                on[*output] = some.clone();
            }
            return Influence { on };
        }
        let output = |row: &mut Vec<f64>| {
            part.model.output(row);
        };
        try_columns(part, &some, output, |value, column| {
            if outputs.contains(&value) && !on[value].contains(&column) {
                on[value].push(column);
            }
        });
        Influence { on }
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
    fn value(&mut self, variable: &Variable) -> f64 {
        if let Kind::Enumeration(choices) = variable.kind {
            return 1.0 + (self.unit() * choices.items.len() as f64).floor();
        }
        let size = exp(9.0 * self.unit() - 7.0) * variable.nominal.max(variable.start.abs());
        let value = if self.unit() < 0.5 { size } else { -size };
        let value = variable.bound.nearest(value);
        if matches!(variable.kind, Kind::Real(_)) { value } else { value.round() }
    }
}
