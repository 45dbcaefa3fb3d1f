//! Everything the page shows choices of: models, systems, solvers.

use std::collections::BTreeMap;

use clap::ValueEnum;
use serde_json::{Value, json};
use ssp::parameter_set::text_of;
use stribeck::catalogue::{Family, documented};
use stribeck::model::{Kind, ModelType, Variable};
use stribeck_fit::identify::Inquiry;
use stribeck_fit::thesis::{CLASSES, TABLE_6_5};
use stribeck_plot::palette::{Colours, DARK, DASHES, LIGHT};
use stribeck_solve::job;
use stribeck_solve::run::Solver;
use stribeck_solve::system::{BUILT_IN, Description, Fault};

use crate::answer::Answer;

/// Models by family, systems and solvers.
pub fn catalogue() -> Result<Answer, Fault> {
    let family = |family: Family| documented(family).map(|(model, _)| described(model)).collect::<Vec<_>>();
    let systems = BUILT_IN.iter().map(|(name, text)| system(name, text)).collect::<Result<Vec<_>, _>>()?;
    let solvers: Vec<_> = Solver::value_variants().iter().filter_map(ValueEnum::to_possible_value).collect();
    let fitted = stribeck_fit::identify::laws().map(|law| law.name).collect::<Vec<_>>();
    let solvers = solvers.iter().map(|solver| {
        json!({ "name": solver.get_name(), "help": solver.get_help().map_or(String::new(), ToString::to_string) })
    });
    Ok(Answer::plain(json!({
        "version": env!("CARGO_PKG_VERSION"),
        "laws": family(Family::Friction),
        "shock_absorber": family(Family::ShockAbsorber),
        "hosts": family(Family::Host),
        "systems": systems,
        "solvers": solvers.collect::<Vec<_>>(),
        "fitted": fitted,
        "identification": job::options::<Inquiry>(),
        "thesis": { "classes": CLASSES, "times": TABLE_6_5 },
        "palette": { "light": colours(&LIGHT), "dark": colours(&DARK), "dashes": DASHES },
    })))
}

fn colours(Colours { paper, ink, grid, axis, laws }: &Colours) -> Value {
    json!({ "paper": paper, "ink": ink, "grid": grid, "axis": axis, "laws": laws })
}

fn system(name: &str, text: &str) -> Result<Value, Fault> {
    let Description { title, source, until, every, show, part, .. } = Description::parse(text)?;
    // Either a part is a law, or parts contain one that can be chosen.
    let law = part.values().find_map(|part| part.law.clone());
    Ok(json!({
        "name": name, "title": title, "source": source, "until": until, "every": every, "show": show, "law": law,
    }))
}

fn described(model: &'static ModelType) -> Value {
    let variables: Vec<_> = model.variables().map(|(_, variable)| variable_as_json(&variable)).collect();
    let presets: Vec<_> = model
        .presets
        .iter()
        .map(|preset| {
            let values = preset.values.iter().map(|(name, value)| (*name, spelling(model, name, *value)));
            let values: BTreeMap<&str, String> = values.collect();
            json!({ "name": preset.name, "source": preset.source, "values": values })
        })
        .collect();
    json!({ "name": model.name, "summary": model.summary, "variables": variables, "presets": presets })
}

/// A value as a user writes it.
fn spelling(model: &ModelType, name: &str, value: f64) -> String {
    model.find(name).map_or_else(|| value.to_string(), |column| text_of(&model.table.at(column), value))
}

fn variable_as_json(variable: &Variable) -> Value {
    let (kind, unit) = match variable.kind {
        Kind::Real(unit) => ("real", unit.name),
        Kind::Integer => ("integer", ""),
        Kind::Boolean => ("boolean", ""),
        Kind::Enumeration(_) => ("choice", ""),
    };
    let choices: Vec<_> = match variable.kind {
        Kind::Enumeration(choices) => {
            choices.items.iter().map(|item| json!({ "name": item.name, "help": item.help })).collect()
        }
        _ => Vec::new(),
    };
    json!({
        "name": variable.path.to_string(),
        "role": format!("{:?}", variable.role),
        "kind": kind,
        "unit": unit,
        "start": variable.start,
        "nominal": variable.nominal,
        "bound": variable.bound.to_string(),
        "minimum": Some(variable.bound.min()).filter(|low| *low > f64::MIN),
        "maximum": Some(variable.bound.max()).filter(|high| *high < f64::MAX),
        "help": variable.help,
        "choices": choices,
    })
}
