//! The only law of a model that has a choice: the others are not in the module, and are refused.

use stribeck::model::{Fault, Variable};
use stribeck::shock_absorber::{NO_LAW, choice_of_law};

use crate::model::{LAW, MODEL};
use crate::state::{Module, Outcome, Status, fault, refuse};

/// The number of a choice.
fn number(column: usize, name: &str) -> Option<f64> {
    let place = MODEL.table.at(column).kind.choices().iter().position(|item| item.name == name)?;
    Some((place + 1) as f64)
}

/// The column of the choice, and the number of the law.
fn only() -> Option<(usize, f64)> {
    let (law, column) = (LAW?, choice_of_law(&MODEL)?);
    Some((column, number(column, law)?))
}

/// Refuses another law than the only one.
pub fn check(column: usize, value: f64) -> Result<(), Fault> {
    match only() {
        Some((choice, law)) if choice == column && value != law && Some(value) != number(column, NO_LAW.name) => {
            let Variable { path, kind, .. } = MODEL.table.at(column);
            let name = |number: f64| kind.choices().get((number as usize).wrapping_sub(1)).map_or("", |item| item.name);
            let none = format_args!("{} ({})", number(column, NO_LAW.name).unwrap_or_default(), NO_LAW.name);
            let available = format_args!("must be {none} or {law} ({})", name(law));
            Err(Fault::new(format_args!(
                "{path} = {value} ({}): {available}; no other law is in these sources",
                name(value)
            )))
        }
        _ => Ok(()),
    }
}

/// Refuses a row in which another law is chosen.
pub fn check_row(row: &[f64]) -> Result<(), Fault> {
    only().map_or(Ok(()), |(column, _)| check(column, row[column]))
}

/// Chooses the law, as at the beginning.
pub fn choose(module: &mut Module) -> Outcome {
    match (LAW, only()) {
        (None, _) => Ok(()),
        (Some(law), None) => refuse(Status::UnknownModel, format_args!("{} has no law {law}", MODEL.name)),
        (Some(_), Some((column, law))) => Ok(module.instance.set_column(column, law)?),
    }
}

/// Applies the preset with this number: with the law, unless it is one without friction.
pub fn apply(module: &mut Module, preset: u32) -> Outcome {
    let Some(preset) = MODEL.presets.get(preset as usize) else {
        return refuse(Status::UnknownModel, format_args!("{} has no preset {preset}", MODEL.name));
    };
    let column = only().map(|(column, _)| column);
    let chosen = preset.values.iter().find(|(name, _)| column.is_some() && MODEL.find(name) == column);
    if let (Some((_, value)), Some(column)) = (chosen, column) {
        check(column, *value).map_err(fault(Status::RefusedValue))?;
    }
    module.instance.apply(preset.name);
    if chosen.is_none() { choose(module) } else { Ok(()) }
}
