//! Facts of columns for calls on every step.

use super::{BLANK, Kind, Role, Variable};

/// The outputs of a row that follow its other columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Computed {
    /// None.
    Nothing,
    /// All but advice.
    Main,
    /// All.
    All,
}

impl Computed {
    /// Outputs that must be computed before a column of that role can be read.
    pub(super) const fn before(role: Role, is_advice: bool) -> Computed {
        match role {
            Role::Output if is_advice => Computed::All,
            Role::Output => Computed::Main,
            _ => Computed::Nothing,
        }
    }
}

/// The per-column facts that get and set need on every step, packed for the cache.
#[derive(Clone, Copy, Debug)]
pub struct Port {
    low: f64,
    high: f64,
    /// The first of [`Computed`], as a number, with which it can be read; none of them if it is not Real.
    needs: u8,
}

impl Port {
    /// Whether `value` may be written while stepping, with no rule but its range. True for admitted values of Real
    /// inputs, false for all other columns.
    #[inline(always)]
    pub fn takes(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    /// Whether the column is Real and can be read in a row that holds so much.
    #[inline(always)]
    pub fn gives(&self, computed: Computed) -> bool {
        self.needs <= computed as u8
    }

    const fn of(variable: &Variable) -> Port {
        let (low, high) = match (variable.role, variable.kind) {
            (Role::Input, Kind::Real(_)) => (variable.bound.low, variable.bound.high),
            _ => (f64::INFINITY, f64::NEG_INFINITY),
        };
        let needs = if matches!(variable.kind, Kind::Real(_)) { variable.needs() as u8 } else { u8::MAX };
        Port { low, high, needs }
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
