//! The parts of a system, for controls.

use std::collections::BTreeMap;

use serde::Serialize;
use stribeck::model::{Role, Variable};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, Place, Signal, System, WireSource};
use ts_rs::TS;

use crate::answer::Answer;

/// A system with one law.
#[derive(Debug, Serialize, TS)]
pub struct Parts {
    parts: Vec<Part>,
    signals: Vec<Moving>,
    until: f64,
    every: f64,
    tol: f64,
    results: Vec<String>,
}

/// A part with its present values.
#[derive(Debug, Serialize, TS)]
pub struct Part {
    name: String,
    model: &'static str,
    is_law: bool,
    #[ts(type = "Record<string, number>")]
    values: BTreeMap<String, f64>,
}

/// The signal of an input that moves, with the numbers by which it does.
#[derive(Debug, Serialize, TS)]
pub struct Moving {
    input: String,
    unit: String,
    properties: Vec<Property>,
}

/// A number by which a signal moves.
#[derive(Debug, Serialize, TS)]
pub struct Property {
    name: String,
    value: f64,
}

/// Parts with the start values of what is worth a control: parameters, start values of hosts, inputs with a constant.
pub fn parts(chosen: &Configuration) -> Result<Answer, Fault> {
    let source = chosen.source()?;
    let system = System::assemble(&source, chosen.law.first().map(String::as_str), &chosen.values())?;
    let settings = chosen.settings(&system)?;
    Ok(Answer::plain(Parts {
        parts: (0..system.parts.len()).map(|number| part(&system, number)).collect(),
        signals: signals(&system),
        until: settings.until,
        every: settings.every,
        tol: settings.tolerance,
        results: chosen.results(&source),
    }))
}

/// Signals that move, with the numbers by which they do.
fn signals(system: &System) -> Vec<Moving> {
    let mut inputs = system.description.input.clone();
    let moving = inputs.iter_mut().filter_map(|(input, signal)| {
        let place = system.place(input).ok()?;
        let unit = system.unit(WireSource::Variable(place)).name;
        let properties = signal.properties().into_iter();
        let properties: Vec<Property> =
            properties.map(|(name, value)| Property { name: name.to_string(), value: *value }).collect();
        (!properties.is_empty()).then(|| Moving { input: input.clone(), unit: unit.to_string(), properties })
    });
    moving.collect()
}

fn is_constant(signal: &Signal) -> bool {
    matches!(signal, Signal::Constant(_))
}

fn part(system: &System, number: usize) -> Part {
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
    let values = part
        .model
        .variables()
        .filter(|(column, variable)| can_be_set(*column, variable))
        .map(|(column, variable)| (variable.path.to_string(), part.row[column]))
        .collect();
    Part { name: part.name.clone(), model: part.model.name, is_law: part.is_law, values }
}
