//! Facts of columns for calls on every step.

use super::{BLANK, BaseType, Kind, Role, Variable};

/// The per-column facts that get and set need on every step, packed for the cache.
#[derive(Clone, Copy, Debug)]
pub struct Port {
    low: f64,
    high: f64,
    /// Type of the column.
    pub base_type: BaseType,
}

impl Port {
    /// Whether `value` may be written while stepping, with no rule but its range. True for admitted values of Real
    /// inputs, false for all other columns.
    #[inline(always)]
    pub fn takes(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    const fn of(variable: &Variable) -> Port {
        let (low, high) = match (variable.role, variable.kind) {
            (Role::Input, Kind::Real(_)) => (variable.bound.low, variable.bound.high),
            _ => (f64::INFINITY, f64::NEG_INFINITY),
        };
        Port { low, high, base_type: variable.kind.base_type() }
    }
}

/// The ports of a table.
pub const fn ports<const COLUMNS: usize>(table: &[Variable]) -> [Port; COLUMNS] {
    let mut ports = [Port::of(&BLANK); COLUMNS];
    let mut column = 0;
    while column < COLUMNS {
        ports[column] = Port::of(&table[column]);
        column += 1;
    }
    ports
}
