//! Facts of columns for calls on every step.

use super::{Computed, Kind, Role, Variable};

/// The facts about a column that get and set need on every step.
#[derive(Clone, Copy, Debug)]
pub struct Port {
    /// Place of its bounds, if it is a Real input.
    input: u8,
    /// The first of [`Computed`], as a number, with which it can be read; none of them if it is not Real.
    needs: u8,
}

/// No Real input.
const NO_INPUT: u8 = u8::MAX;

/// Bounds of a Real input.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    low: f64,
    high: f64,
}

/// The ports of a table, packed for the cache.
#[derive(Clone, Copy, Debug)]
pub struct Ports {
    columns: &'static [Port],
    inputs: &'static [Range],
}

impl Ports {
    /// Those of a table, made by [`ports`] and [`ranges`].
    pub const fn new(columns: &'static [Port], inputs: &'static [Range]) -> Ports {
        Ports { columns, inputs }
    }

    /// Whether `value` may be written to a column while stepping, with no rule but its range. True for admitted values
    /// of Real inputs, false for all other columns.
    #[inline(always)]
    pub fn takes(&self, column: usize, value: f64) -> bool {
        let range = self.columns.get(column).and_then(|port| self.inputs.get(usize::from(port.input)));
        range.is_some_and(|range| value >= range.low && value <= range.high)
    }

    /// [`Ports::takes`] of all values.
    pub fn takes_all(&self, column: usize, values: &[f64]) -> bool {
        let range = self.columns.get(column).and_then(|port| self.inputs.get(usize::from(port.input)));
        // Without a way out, so that several values are compared at once.
        let within = |range: &Range| {
            values.iter().fold(true, |within, value| within & (*value >= range.low) & (*value <= range.high))
        };
        range.is_some_and(within)
    }

    /// Whether a column is a Real input.
    #[inline(always)]
    pub fn is_real_input(&self, column: usize) -> bool {
        self.columns.get(column).is_some_and(|port| port.input != NO_INPUT)
    }

    /// Whether a column is Real and can be read in a row that holds so much.
    #[inline(always)]
    pub fn gives(&self, column: usize, computed: Computed) -> bool {
        self.columns.get(column).is_some_and(|port| port.needs <= computed as u8)
    }
}

const fn is_real_input(variable: &Variable) -> bool {
    matches!((variable.role, variable.kind), (Role::Input, Kind::Real(_)))
}

/// The ports of the columns of a table.
pub const fn ports<const COLUMNS: usize>(table: &[Variable]) -> [Port; COLUMNS] {
    let mut ports = [Port { input: NO_INPUT, needs: u8::MAX }; COLUMNS];
    let (mut inputs, mut column) = (0, 0);
    while column < COLUMNS {
        let variable = &table[column];
        if is_real_input(variable) {
            assert!(inputs < NO_INPUT, "too many inputs");
            ports[column].input = inputs;
            inputs += 1;
        }
        if matches!(variable.kind, Kind::Real(_)) {
            ports[column].needs = variable.needs() as u8;
        }
        column += 1;
    }
    ports
}

/// Number of Real inputs of a table.
pub const fn range_count(table: &[Variable]) -> usize {
    let (mut count, mut column) = (0, 0);
    while column < table.len() {
        count += is_real_input(&table[column]) as usize;
        column += 1;
    }
    count
}

/// Bounds of the Real inputs of a table, in their order.
pub const fn ranges<const INPUTS: usize>(table: &[Variable]) -> [Range; INPUTS] {
    let mut ranges = [Range { low: 0.0, high: 0.0 }; INPUTS];
    let (mut inputs, mut column) = (0, 0);
    while column < table.len() {
        let Variable { bound, .. } = table[column];
        if is_real_input(&table[column]) {
            ranges[inputs] = Range { low: bound.low, high: bound.high };
            inputs += 1;
        }
        column += 1;
    }
    ranges
}
