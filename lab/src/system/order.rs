//! Order in which the outputs of a system are computed and passed on.

use stribeck::catalogue::{Family, documented};
use stribeck::model::{Kind, Role, Variable};
use stribeck::number::elementary::pow;

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
pub(super) fn tasks(system: &System) -> Result<Vec<Task>, Fault> {
    let influence = |part: &Part| Influence::of(part, &columns(part, |role| role == Role::Input));
    let influences: Vec<Influence> = system.parts.iter().map(influence).collect();
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
                .of_column(from.column)
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

/// The columns of each part that change in time: integrated states, inputs that are given as signals, and what they
/// change through the parts.
pub(super) fn moving(system: &System, states: &[Place]) -> Vec<Vec<usize>> {
    let signals = system.signals.iter().filter(|(_, signal)| !matches!(signal, Signal::Constant(_)));
    let mut moving = vec![Vec::new(); system.parts.len()];
    for Place { part, column } in states.iter().copied().chain(signals.map(|(place, _)| *place)) {
        moving[part].push(column);
    }
    loop {
        let outputs: Vec<Influence> =
            system.parts.iter().zip(&moving).map(|(part, moving)| Influence::of(part, moving)).collect();
        let moves = |from: WireSource| match from {
            WireSource::Variable(Place { part, column }) => {
                moving[part].contains(&column) || outputs[part].of_column(column).next().is_some()
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
    let [mut before, mut after] = [vec![0.0; count], vec![0.0; count]];
    try_columns(part, moving, |row, changed, _| {
        part.model.indicate(row, &mut before);
        part.model.indicate(changed, &mut after);
        before.iter().zip(&after).any(|(before, after)| before.to_bits() != after.to_bits())
    })
}

fn columns(part: &Part, wanted: impl Fn(Role) -> bool) -> Vec<usize> {
    (0..part.row.len()).filter(|column| wanted(part.model.table.at(*column).role)).collect()
}

/// Shows pairs of random rows that differ in one of some columns, and that column, until a look at them is enough.
fn try_columns(part: &Part, some: &[usize], mut look: impl FnMut(&[f64], &[f64], usize) -> bool) -> bool {
    let table = &part.model.table;
    let moved = columns(part, |role| role == Role::Input || role.is_state());
    let variables: Vec<(usize, Variable)> = moved.into_iter().map(|column| (column, table.at(column))).collect();
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    (0..TRIALS).any(|_| {
        let mut row = part.row.clone();
        variables.iter().for_each(|(column, variable)| row[*column] = random.value(variable));
        some.iter().any(|column| {
            let mut changed = row.clone();
            changed[*column] = random.value(&table.at(*column));
            look(&row, &changed, *column)
        })
    })
}

/// The columns on which each output of a model depends.
struct Influence {
    /// Per column, those that change it.
    on: Vec<Vec<usize>>,
}

impl Influence {
    /// Looks for dependencies by changing one of some columns after the other, at random states.
    fn of(part: &Part, some: &[usize]) -> Influence {
        let outputs = columns(part, Role::is_computed);
        let mut on = vec![Vec::new(); part.row.len()];
        if part.model.memory_in_use(&part.row) > 0 {
            // A model whose memory is beside the row: take every output to depend on all of them.
            for output in &outputs {
                on[*output] = some.to_vec();
            }
            return Influence { on };
        }
        try_columns(part, some, |row, changed, column| {
            let [mut before, mut after] = [row.to_vec(), changed.to_vec()];
            part.model.output(&mut before);
            part.model.output(&mut after);
            for output in &outputs {
                if after[*output].to_bits() != before[*output].to_bits() && !on[*output].contains(&column) {
                    on[*output].push(column);
                }
            }
            false
        });
        Influence { on }
    }

    fn of_column(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
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
    fn value(&mut self, variable: &Variable) -> f64 {
        if let Kind::Enumeration(choices) = variable.kind {
            return 1.0 + (self.unit() * choices.items.len() as f64).floor();
        }
        let size = pow(10.0, 4.0 * self.unit() - 3.0) * variable.nominal.max(variable.start.abs());
        let value = if self.unit() < 0.5 { size } else { -size };
        let value = variable.bound.nearest(value);
        if matches!(variable.kind, Kind::Real(_)) { value } else { value.round() }
    }
}
