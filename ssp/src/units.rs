//! Units of the values in a file.

use std::collections::BTreeMap;

use serde::Serialize;
use stribeck::model::{Kind, Variable};
use stribeck::unit;

/// Definitions of units, sorted by name.
#[derive(Serialize)]
pub struct Units {
    #[serde(rename = "ssc:Unit")]
    units: Vec<Unit>,
}

/// A unit as a product of powers of base units.
#[derive(Serialize)]
struct Unit {
    #[serde(rename = "@name")]
    name: &'static str,
    #[serde(rename = "ssc:BaseUnit")]
    base: BaseUnit,
}

#[derive(Serialize)]
struct BaseUnit {
    #[serde(rename = "@kg", skip_serializing_if = "is_zero")]
    kg: i8,
    #[serde(rename = "@m", skip_serializing_if = "is_zero")]
    m: i8,
    #[serde(rename = "@s", skip_serializing_if = "is_zero")]
    s: i8,
    #[serde(rename = "@A", skip_serializing_if = "is_zero")]
    ampere: i8,
    #[serde(rename = "@K", skip_serializing_if = "is_zero")]
    kelvin: i8,
    #[serde(rename = "@rad", skip_serializing_if = "is_zero")]
    rad: i8,
}

fn is_zero(exponent: &i8) -> bool {
    *exponent == 0
}

impl Units {
    /// The definitions of these units, each once; none if there are no units.
    pub fn of(units: impl IntoIterator<Item = &'static unit::Unit>) -> Option<Units> {
        let sorted: BTreeMap<&str, &unit::Unit> = units.into_iter().map(|unit| (unit.name, unit)).collect();
        let definition = |unit: &unit::Unit| {
            let unit::Unit { name, kg, m, s, ampere, kelvin, rad, .. } = *unit;
            Unit { name, base: BaseUnit { kg, m, s, ampere, kelvin, rad } }
        };
        (!sorted.is_empty()).then(|| Units { units: sorted.into_values().map(definition).collect() })
    }
}

/// The unit of a variable; none if it is not a physical quantity.
pub fn unit_of(variable: &Variable) -> Option<&'static unit::Unit> {
    match variable.kind {
        Kind::Real(unit) => Some(unit),
        _ => None,
    }
}
