//! Dependencies of the outputs of a model on its inputs and states.

use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};
use stribeck::number::elementary::exp;

/// Random rows on which the dependencies of a model are looked for (chosen).
pub(super) const TRIALS: usize = 100;

fn columns(model: &ModelType, wanted: impl Fn(Role) -> bool) -> Vec<usize> {
    (0..model.table.len()).filter(|column| wanted(model.table.at(*column).role)).collect()
}

/// The inputs and states on which each output of a model depends.
#[derive(Clone, Debug)]
pub(super) struct Influence {
    /// Per column, those that change it.
    on: Vec<Vec<usize>>,
}

impl Influence {
    /// Looks for dependencies by changing one input or state after the other, in random rows.
    pub fn of(model: &ModelType, row: &[f64]) -> Influence {
        let outputs = columns(model, Role::is_computed);
        let moved = columns(model, is_moved);
        let mut on = vec![Vec::new(); row.len()];
        if model.memory_in_use(row) > 0 {
            // A model whose memory is beside the row: take every output to depend on all of them.
            for output in &outputs {
                on[*output].clone_from(&moved);
            }
            return Influence { on };
        }
        let mut draw = Draw::of(model, row);
        let at_rest = AtRest::of(model, row);
        let [mut row, mut before, mut after] = [row.to_vec(), row.to_vec(), row.to_vec()];
        for trial in 0..TRIALS {
            draw.fill(&mut row);
            at_rest.put(&mut row, trial);
            before.copy_from_slice(&row);
            model.output(&mut before);
            for column in &moved {
                after.copy_from_slice(&row);
                after[*column] = draw.value(*column);
                model.output(&mut after);
                for output in &outputs {
                    if after[*output].to_bits() != before[*output].to_bits() && !on[*output].contains(column) {
                        on[*output].push(*column);
                    }
                }
            }
        }
        Influence { on }
    }

    /// The columns on which this one depends.
    pub fn of_column(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
        self.on[column].iter().copied()
    }
}

/// Factor by which an input is also tried beyond its usual size (chosen): a force between two levels has to reach them.
const BEYOND: f64 = 1e3;

/// Whether an output depends on an input of either sign while the contact slides or rests, whatever the other inputs, the
/// modes and the states, but for numbers that only a step sets: they may stand in for the input.
pub(super) fn is_used(model: &ModelType, row: &[f64], input: usize) -> bool {
    let mut draw = Draw::of(model, row);
    let at_rest = AtRest::of(model, row);
    let [mut before, mut after] = [row.to_vec(), row.to_vec()];
    (0..TRIALS).any(|trial| {
        draw.fill(&mut before);
        at_rest.free(&mut before);
        at_rest.put(&mut before, trial);
        if trial % 4 == 1 {
            before[input] *= BEYOND;
        }
        after.copy_from_slice(&before);
        after[input] = -before[input];
        [&mut before, &mut after].into_iter().for_each(|row| _ = model.output(row));
        columns(model, Role::is_computed).iter().any(|output| before[*output].to_bits() != after[*output].to_bits())
    })
}

/// Whether the rate of a state depends on an input, whatever the other inputs and the states. A model without rates may
/// depend on it.
pub(super) fn drives(model: &ModelType, row: &[f64], input: usize) -> bool {
    let mut draw = Draw::of(model, row);
    let [mut row, mut before, mut after] = [row.to_vec(), row.to_vec(), row.to_vec()];
    !model.model_exchange
        || (0..TRIALS).any(|_| {
            draw.fill(&mut row);
            model.rate(&row, &mut before);
            row[input] = draw.value(input);
            model.rate(&row, &mut after);
            columns(model, Role::is_state).iter().any(|state| before[*state].to_bits() != after[*state].to_bits())
        })
}

/// Rows of a contact at rest: its force may follow an input that the force of a sliding contact does not follow.
struct AtRest<'a> {
    start: &'a [f64],
    velocity: Option<usize>,
    /// Inputs other than those that decide how a contact at rest goes on.
    others: Vec<usize>,
    /// Numbers that only a step sets, such as the force that one has planned.
    planned: Vec<usize>,
}

impl AtRest<'_> {
    fn of<'a>(model: &ModelType, start: &'a [f64]) -> AtRest<'a> {
        let columns = |wanted: fn(&Variable) -> bool| {
            model.variables().filter(|(_, variable)| wanted(variable)).map(|(column, _)| column).collect()
        };
        AtRest {
            start,
            velocity: model.table.of(Meaning::Velocity),
            others: columns(|variable| {
                let goes_on = matches!(variable.meaning, Meaning::ExternalForce | Meaning::Acceleration);
                variable.role == Role::Input && !goes_on
            }),
            planned: columns(|variable| {
                let is_discrete = variable.role.is_state() && !variable.is_continuous_state();
                is_discrete && matches!(variable.kind, Kind::Real(_))
            }),
        }
    }

    /// Lets no step have gone before.
    fn free(&self, row: &mut [f64]) {
        self.planned.iter().for_each(|column| row[*column] = self.start[*column]);
    }

    /// Half of the rows are at rest, half of these with nothing else across or about the axis.
    fn put(&self, row: &mut [f64], trial: usize) {
        if !trial.is_multiple_of(2) {
            return;
        }
        self.free(row);
        if trial.is_multiple_of(4) {
            self.others.iter().for_each(|column| row[*column] = self.start[*column]);
        }
        if let Some(velocity) = self.velocity {
            row[velocity] = 0.0;
        }
    }
}

/// Whether something else than the parameters gives such a column its value.
fn is_moved(role: Role) -> bool {
    role == Role::Input || role.is_state()
}

/// Random values of inputs and states, by a small generator (xorshift), so that the order of a system is the same in every
/// run.
pub(super) struct Draw {
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
    pub fn of(model: &ModelType, row: &[f64]) -> Draw {
        let drawn = |column| {
            let variable = model.table.at(column);
            is_moved(variable.role).then(|| Drawn { size: variable.nominal.max(variable.start.abs()), variable })
        };
        Draw {
            columns: (0..row.len()).map(drawn).collect(),
            powers: std::array::from_fn(|number| exp((number as f64 / 8.0 - 3.0) * std::f64::consts::LN_10)),
            random: 0x2545_f491_4f6c_dd1d,
        }
    }

    /// Gives all inputs and states values.
    pub fn fill(&mut self, row: &mut [f64]) {
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
    pub fn value(&mut self, column: usize) -> f64 {
        let [first, second, third] = [self.unit(), self.unit(), self.unit()];
        let Some(Drawn { variable, size }) = &self.columns[column] else { return 0.0 };
        match variable.kind {
            Kind::Boolean => return first.round(),
            Kind::Enumeration(choices) => return 1.0 + (first * choices.items.len() as f64).floor(),
            _ => {}
        }
        let size = size * self.powers[(first * self.powers.len() as f64) as usize] * (1.0 + third);
        let is_negative = second >= 0.5 && variable.bound.min() < 0.0;
        let value = variable.bound.nearest(if is_negative { -size } else { size });
        if matches!(variable.kind, Kind::Real(_)) { value } else { value.round() }
    }
}
