//! The parts of a system, for controls.

use serde_json::{Value, json};
use stribeck::model::{Role, Variable};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, Place, Signal, System, WireSource};

use crate::answer::Answer;

/// Parts with the start values of what is worth a control: parameters, start values of hosts, inputs with a constant.
pub fn parts(chosen: &Configuration) -> Result<Answer, Fault> {
    let source = chosen.source()?;
    let system = System::assemble(&source, chosen.law.first().map(String::as_str), &chosen.values())?;
    let parts = (0..system.parts.len()).map(|number| part(&system, number)).collect::<Vec<_>>();
    let settings = chosen.settings(&system)?;
    Ok(Answer::plain(json!({
        "parts": parts,
        "signals": signals(&system),
        "until": settings.until,
        "every": settings.every,
        "tol": settings.tolerance,
        "results": chosen.results(&source),
    })))
}

/// Signals that move, with the numbers by which they do.
fn signals(system: &System) -> Vec<Value> {
    let mut inputs = system.description.input.clone();
    let moving = inputs.iter_mut().filter_map(|(input, signal)| {
        let place = system.place(input).ok()?;
        let unit = system.unit(WireSource::Variable(place)).name;
        let properties: Vec<Value> =
            signal.properties().into_iter().map(|(name, value)| json!({ "name": name, "value": *value })).collect();
        (!properties.is_empty()).then(|| json!({ "input": input, "unit": unit, "properties": properties }))
    });
    moving.collect()
}

fn is_constant(signal: &Signal) -> bool {
    matches!(signal, Signal::Constant(_))
}

fn part(system: &System, number: usize) -> Value {
    let part = &system.parts[number];
    let can_be_set = |column: usize, variable: &Variable| {
        let place = Place { part: number, column };
        match variable.role {
            Role::Output => false,
            Role::Input => system.signals.iter().any(|(to, signal)| *to == place && is_constant(signal)),
            Role::State | Role::StateOutput => !part.is_law,
            // What is taken from another part has no value of its own.
            Role::Fixed | Role::Tunable => !system.description.hold.contains_key(&system.name(place)),
        }
    };
    let values: serde_json::Map<String, Value> = part
        .model
        .variables()
        .filter(|(column, variable)| can_be_set(*column, variable))
        .map(|(column, variable)| (variable.path.to_string(), json!(part.row[column])))
        .collect();
    json!({ "name": part.name, "model": part.model.name, "is_law": part.is_law, "values": values })
}
