//! Order in which the outputs of a system are computed and passed on.

use stribeck::catalogue::{Family, documented};

use super::influence::{Draw, Influence, TRIALS};
use super::part::{Part, System, Wire, WireSource};
use super::{Fault, Place};

/// A step of evaluating a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// Computes the outputs of a part.
    Output(usize),
    /// Passes a value on.
    Pass { from: Place, to: Place },
}

impl Task {
    /// The part that computes or gives something.
    pub fn giver(self) -> usize {
        match self {
            Task::Output(part) => part,
            Task::Pass { from, .. } => from.part,
        }
    }
}

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
    let mut moving = vec![Vec::new(); system.parts.len()];
    for Place { part, column } in states.iter().copied().chain(system.moving_signals()) {
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

/// Whether each part moves between events: it has a column that changes, or an input from a part that moves.
pub(super) fn moving_parts(system: &System, changing: &[Place]) -> Vec<bool> {
    let mut moving = vec![false; system.parts.len()];
    changing.iter().copied().chain(system.moving_signals()).for_each(|place| moving[place.part] = true);
    loop {
        let moves = |from: WireSource| match from {
            WireSource::Variable(place) => moving[place.part],
            WireSource::Derivative(_) => true,
        };
        let is_new = |wire: &&Wire| !moving[wire.to.part] && moves(wire.from);
        let Some(to) = system.wires.iter().find(is_new).map(|wire| wire.to) else { return moving };
        moving[to.part] = true;
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
    let mut draw = Draw::of(part.model, &part.row);
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
