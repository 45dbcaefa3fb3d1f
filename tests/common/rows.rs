//! Random rows of a model.

use stribeck::model::{Kind, ModelType, Role, Variable};

use super::random::Random;

/// An admitted row in which every column that is not a result is drawn, or has its start value where `share` of the
/// columns leave it.
pub fn row(model: &ModelType, share: f64, random: &mut Random) -> Vec<f64> {
    loop {
        let mut value = |variable: &Variable| {
            let is_drawn = random.next() < share && variable.role != Role::Output;
            if is_drawn { value(variable, random) } else { variable.start }
        };
        let row: Vec<f64> = model.table.iter().map(|variable| value(&variable)).collect();
        if model.check(&row).is_ok() {
            return row;
        }
    }
}

/// An admitted row in which the real columns that are no results have a magnitude near the usual one.
pub fn everyday(model: &ModelType, random: &mut Random) -> Vec<f64> {
    loop {
        let mut near = |variable: &Variable| {
            let size = if variable.start == 0.0 { variable.nominal } else { variable.start.abs() };
            let value = size * 10f64.powf(random.signed()) * random.signed().signum();
            [value, -value].into_iter().find(|value| variable.admits(*value)).unwrap_or(variable.start)
        };
        let is_drawn = |variable: &Variable| matches!(variable.kind, Kind::Real(_)) && variable.role != Role::Output;
        let mut value = |variable: &Variable| if is_drawn(variable) { near(variable) } else { variable.start };
        let row: Vec<f64> = model.table.iter().map(|variable| value(&variable)).collect();
        if model.check(&row).is_ok() {
            return row;
        }
    }
}

/// A value within the bound of the variable: mostly near the usual magnitude, sometimes far from it, at a limit or 0.
pub fn value(variable: &Variable, random: &mut Random) -> f64 {
    let (min, max) = (variable.bound.min(), variable.bound.max());
    let value = match variable.kind {
        Kind::Real(_) => {
            let scale = variable.nominal.max(variable.start.abs());
            let decades = if random.next() < 0.8 { 2.0 * random.signed() } else { 8.0 * random.signed() };
            let magnitude = scale * 10f64.powf(decades);
            match (random.next() * 8.0) as u32 {
                0 => 0.0,
                1 => variable.start,
                2 => min.max(-magnitude),
                3..5 => -magnitude,
                _ => magnitude,
            }
        }
        _ => (min.max(-9.0) + random.next() * (max.min(9.0) - min.max(-9.0) + 1.0)).floor(),
    };
    if variable.admits(value) { value } else { variable.start }
}
