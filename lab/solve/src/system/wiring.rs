//! Evaluation of the parts of a system without lookups between them: their numbers stand in one row, and what is to be
//! done with it is a list.

use std::ops::Range;

use stribeck::number::Gradient;

use super::Place;
use super::mover::{Functions, Mover};
use super::order::Task;

/// A function of a part.
#[derive(Clone, Copy)]
enum Call<T> {
    /// Computes outputs.
    Output(fn(&mut [T])),
    /// Computes outputs and rates.
    Respond(fn(&mut [T], &mut [T])),
    /// Computes rates, of a part whose outputs were needed before it had all inputs.
    Rate(fn(&[T], &mut [T])),
    /// None: a part has its inputs.
    Nothing,
}

impl<T> Call<T> {
    #[inline(always)]
    fn on(&self, values: &mut [T], rates: &mut [T]) {
        match self {
            Call::Output(output) => output(values),
            Call::Respond(respond) => respond(values, rates),
            Call::Rate(rate) => rate(values, rates),
            Call::Nothing => {}
        }
    }
}

/// Results wanted of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Wanted {
    Outputs,
    /// Outputs and rates.
    Response,
    Rates,
    Nothing,
}

impl Wanted {
    fn of<T>(self, functions: &Functions<T>) -> Call<T> {
        match self {
            Wanted::Outputs => Call::Output(functions.output),
            Wanted::Response => Call::Respond(functions.respond),
            Wanted::Rates => Call::Rate(functions.rate),
            Wanted::Nothing => Call::Nothing,
        }
    }
}

/// A value that one part gives to another.
#[derive(Clone, Copy)]
struct Pass {
    from: usize,
    to: usize,
    /// The part that takes it.
    part: usize,
}

/// A step of an evaluation: values are passed on, then a function of a part is called.
struct Act {
    passes: Range<usize>,
    part: usize,
    columns: Range<usize>,
    level: Call<f64>,
    inclined: Call<Gradient>,
}

/// An evaluation.
pub(super) struct Plan {
    acts: Vec<Act>,
    passes: Vec<Pass>,
}

/// Column in the rows of all parts.
pub(super) fn column_of(movers: &[Mover], place: Place) -> usize {
    movers[place.part].columns.start + place.column
}

impl Plan {
    /// Gives inputs their values.
    pub fn of_inputs(tasks: &[Task], movers: &[Mover]) -> Plan {
        Plan::of(tasks, movers, |_| false)
    }

    /// Finds the rates of all parts that move, after the tasks; those of a part whose outputs are computed when all its
    /// inputs are known are found with them.
    pub fn of_rates(tasks: &[Task], movers: &[Mover]) -> Plan {
        let is_ready = |part: usize, rest: &[Task]| {
            rest.iter().all(|task| match task {
                Task::Output(other) => *other != part,
                Task::Pass { to, .. } => to.part != part,
            })
        };
        let responds = |number: usize| match tasks[number] {
            Task::Output(part) => movers[part].moves && is_ready(part, &tasks[number + 1..]),
            Task::Pass { .. } => false,
        };
        let mut plan = Plan::of(tasks, movers, responds);
        for (part, mover) in movers.iter().enumerate().filter(|(_, mover)| mover.moves) {
            match (0..tasks.len()).rev().find(|number| tasks[*number] == Task::Output(part)) {
                Some(last) if responds(last) => {}
                Some(_) => plan.push(Wanted::Rates, part, mover),
                None => plan.push(Wanted::Response, part, mover),
            }
        }
        plan
    }

    /// Of the tasks, some of which find rates as well.
    fn of(tasks: &[Task], movers: &[Mover], responds: impl Fn(usize) -> bool) -> Plan {
        let mut plan = Plan { acts: Vec::new(), passes: Vec::new() };
        for (number, task) in tasks.iter().enumerate() {
            match *task {
                Task::Output(part) => {
                    let wanted = if responds(number) { Wanted::Response } else { Wanted::Outputs };
                    plan.push(wanted, part, &movers[part]);
                }
                Task::Pass { from, to } => {
                    let [at_from, at_to] = [from, to].map(|place| column_of(movers, place));
                    plan.passes.push(Pass { from: at_from, to: at_to, part: to.part });
                }
            }
        }
        if let Some(last) = plan.passes.last() {
            plan.push(Wanted::Nothing, last.part, &movers[last.part]);
        }
        plan
    }

    /// Adds an act, after the passes that no act has yet.
    fn push(&mut self, wanted: Wanted, part: usize, mover: &Mover) {
        // Passes without a function wait for the next one.
        let waiting = self.acts.pop_if(|last| matches!(last.level, Call::Nothing)).map(|last| last.passes.start);
        let first = waiting.or(self.acts.last().map(|last| last.passes.end)).unwrap_or(0);
        self.acts.push(Act {
            passes: first..self.passes.len(),
            part,
            columns: mover.columns.clone(),
            level: wanted.of(&mover.level),
            inclined: wanted.of(&mover.inclined),
        });
    }
}

/// The numbers of all parts, one part after the other: values and rates, and both with slopes.
pub(super) struct Rows {
    pub values: Vec<f64>,
    pub rates: Vec<f64>,
    /// The values with slopes, as far as they change.
    inclined: Vec<Gradient>,
    inclined_rates: Vec<Gradient>,
    /// Per part, whether a column that changes has a slope.
    has_slope: Vec<bool>,
}

impl Rows {
    /// Of these parts, with their start values.
    pub fn new(rows: impl Iterator<Item = Vec<f64>>) -> Rows {
        let (mut values, mut parts) = (Vec::new(), 0);
        for row in rows {
            values.extend(row);
            parts += 1;
        }
        let zero = vec![Gradient::default(); values.len()];
        Rows {
            rates: vec![0.0; values.len()],
            inclined: zero.clone(),
            inclined_rates: zero,
            has_slope: vec![false; parts],
            values,
        }
    }

    /// The values of a part.
    pub fn of(&self, mover: &Mover) -> &[f64] {
        &self.values[mover.columns.clone()]
    }

    /// The values of a part, mutable.
    pub fn of_mut(&mut self, mover: &Mover) -> &mut [f64] {
        &mut self.values[mover.columns.clone()]
    }

    /// Makes an evaluation with values.
    #[inline]
    pub fn perform(&mut self, plan: &Plan) {
        let (values, rates) = (self.values.as_mut_slice(), self.rates.as_mut_slice());
        for act in &plan.acts {
            for pass in &plan.passes[act.passes.clone()] {
                values[pass.to] = values[pass.from];
            }
            act.level.on(&mut values[act.columns.clone()], &mut rates[act.columns.clone()]);
        }
    }

    /// Takes all values over without slopes.
    pub fn spread(&mut self) {
        for (inclined, value) in self.inclined.iter_mut().zip(&self.values) {
            *inclined = Gradient::from(*value);
        }
    }

    /// Takes the values in some columns over. No part has a slope then.
    pub fn level(&mut self, columns: &[usize]) {
        self.has_slope.fill(false);
        columns.iter().for_each(|column| self.lay(*column));
    }

    fn lay(&mut self, column: usize) {
        self.inclined[column] = Gradient::from(self.values[column]);
    }

    /// Gives a column of a part a slope in a direction.
    pub fn incline(&mut self, part: usize, column: usize, direction: usize, slope: f64) {
        self.inclined[column].slopes[direction] = slope;
        self.has_slope[part] |= slope != 0.0;
    }

    /// The rate in a column of a part.
    pub fn inclined_rate(&self, part: usize, column: usize) -> Gradient {
        if self.has_slope[part] { self.inclined_rates[column] } else { Gradient::from(self.rates[column]) }
    }

    /// Makes an evaluation with slopes, in parts that have some, and with values in the others.
    pub fn perform_inclined(&mut self, plan: &Plan, movers: &[Mover]) {
        for act in &plan.acts {
            for Pass { from, to, part } in &plan.passes[act.passes.clone()] {
                let value = self.inclined[*from];
                self.values[*to] = value.value;
                self.inclined[*to] = value;
                self.has_slope[*part] |= value.has_slope();
            }
            let columns = act.columns.clone();
            if self.has_slope[act.part] {
                act.inclined.on(&mut self.inclined[columns.clone()], &mut self.inclined_rates[columns]);
            } else {
                act.level.on(&mut self.values[columns.clone()], &mut self.rates[columns]);
                movers[act.part].passed.iter().for_each(|column| self.lay(*column));
            }
        }
    }
}
