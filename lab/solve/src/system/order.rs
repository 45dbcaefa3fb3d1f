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
pub(super) fn moving(system: &System, influences: &[Influence], states: &[Place]) -> Vec<Vec<usize>> {
    let signals = system.signals.iter().filter(|(_, signal)| !matches!(signal, Signal::Constant(_)));
    let mut moving = vec![Vec::new(); system.parts.len()];
    for Place { part, column } in states.iter().copied().chain(signals.map(|(place, _)| *place)) {
        moving[part].push(column);
    }
    loop {
        let moves = |from: WireSource| match from {
            WireSource::Variable(Place { part, column }) => {
                moving[part].contains(&column)
                    || influences[part].of_column(column).any(|other| moving[part].contains(&other))
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
    let mut draw = Draw::of(part);
    let mut row = part.row.clone();
    let [mut before, mut after] = [vec![0.0; count], vec![0.0; count]];
    (0..TRIALS).any(|_| {
        draw.fill(&mut row);
        part.model.indicate(&row, &mut before);
        moving.iter().any(|column| {
            let mut changed = row.clone();
            changed[*column] = draw.value(*column);
            part.model.indicate(&changed, &mut after);
            before.iter().zip(&after).any(|(before, after)| before.to_bits() != after.to_bits())
        })
    })
}

fn columns(part: &Part, wanted: impl Fn(Role) -> bool) -> Vec<usize> {
    (0..part.row.len()).filter(|column| wanted(part.model.table.at(*column).role)).collect()
}

/// The inputs and states on which each output of a model depends.
#[derive(Clone, Debug)]
pub(super) struct Influence {
    /// Per column, those that change it.
    on: Vec<Vec<usize>>,
}

impl Influence {
    /// Looks for dependencies by changing one input or state after the other, in random rows.
    pub fn of(part: &Part) -> Influence {
        let outputs = columns(part, Role::is_computed);
        let moved = columns(part, is_moved);
        let mut on = vec![Vec::new(); part.row.len()];
        if part.model.memory_in_use(&part.row) > 0 {
            // A model whose memory is beside the row: take every output to depend on all of them.
            for output in &outputs {
                on[*output].clone_from(&moved);
            }
            return Influence { on };
        }
        let mut draw = Draw::of(part);
        let [mut row, mut before, mut after] = [part.row.clone(), part.row.clone(), part.row.clone()];
        for _ in 0..TRIALS {
            draw.fill(&mut row);
            before.copy_from_slice(&row);
            part.model.output(&mut before);
            for column in &moved {
                after.copy_from_slice(&row);
                after[*column] = draw.value(*column);
                part.model.output(&mut after);
                for output in &outputs {
                    if after[*output].to_bits() != before[*output].to_bits() && !on[*output].contains(column) {
                        on[*output].push(*column);
                    }
                }
            }
        }
        Influence { on }
    }

    fn of_column(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
        self.on[column].iter().copied()
    }
}

/// Whether something else than the parameters gives such a column its value.
fn is_moved(role: Role) -> bool {
    role == Role::Input || role.is_state()
}

/// Random values of inputs and states, by a small generator (xorshift), so that the order of a system is the same in every
/// run.
struct Draw {
    columns: Vec<Option<Drawn>>,
    /// Powers of ten, so that none is computed twice.
    powers: [f64; 32],
    random: u64,
}

/// A column that gets random values.
struct Drawn {
    variable: Variable,
    /// The usual size.
    size: f64,
}

impl Draw {
    fn of(part: &Part) -> Draw {
        let drawn = |column| {
            let variable = part.model.table.at(column);
            is_moved(variable.role).then(|| Drawn { size: variable.nominal.max(variable.start.abs()), variable })
        };
        Draw {
            columns: (0..part.row.len()).map(drawn).collect(),
            powers: std::array::from_fn(|number| exp((number as f64 / 8.0 - 3.0) * std::f64::consts::LN_10)),
            random: 0x2545_f491_4f6c_dd1d,
        }
    }

    /// Gives all inputs and states values.
    fn fill(&mut self, row: &mut [f64]) {
        for (column, value) in row.iter_mut().enumerate() {
            if self.columns[column].is_some() {
                *value = self.value(column);
            }
        }
    }

    fn unit(&mut self) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A value of an input or state, of either sign, of any size around the usual one.
    fn value(&mut self, column: usize) -> f64 {
        let [first, second, third] = [self.unit(), self.unit(), self.unit()];
        let Some(Drawn { variable, size }) = &self.columns[column] else { return 0.0 };
        if let Kind::Enumeration(choices) = variable.kind {
            return 1.0 + (first * choices.items.len() as f64).floor();
        }
        let size = size * self.powers[(first * self.powers.len() as f64) as usize] * (1.0 + third);
        let value = variable.bound.nearest(if second < 0.5 { size } else { -size });
        if matches!(variable.kind, Kind::Real(_)) { value } else { value.round() }
    }
}
