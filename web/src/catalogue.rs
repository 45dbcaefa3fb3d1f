//! Everything the page shows choices of: models, systems, solvers.

use std::collections::BTreeMap;

use clap::ValueEnum;
use serde::Serialize;
use ssp::parameter_set::text_of;
use stribeck::catalogue::{Family, documented};
use stribeck::model::{ModelType, Variable};
use stribeck_fit::identify::{self, Led, Ports};
use stribeck_fit::thesis::{CLASSES, TABLE_6_5};
use stribeck_measured::Movement;
use stribeck_plot::palette::{self, DARK, DASHES, LIGHT};
use stribeck_solve::run::Solver;
use stribeck_solve::system::{BUILT_IN, Description, Fault};
use ts_rs::TS;

use crate::answer::Answer;

/// Models by family, systems, solvers, and what else the page shows.
#[derive(Debug, Serialize, TS)]
pub struct Catalogue {
    version: &'static str,
    laws: Vec<Model>,
    shock_absorber: Vec<Model>,
    hosts: Vec<Model>,
    components: Vec<Model>,
    systems: Vec<SystemEntry>,
    solvers: Vec<Named>,
    /// Laws and components that can be fitted.
    fitted: Vec<Fittable>,
    thesis: Thesis,
    palette: Palette,
}

/// A law or component that can be fitted.
#[derive(Debug, Serialize, TS)]
pub struct Fittable {
    name: &'static str,
    /// Whether a normal force presses it together; a component has none.
    has_load: bool,
    /// Quantities that drive it, beside its motion and normal force.
    drives: Vec<Drive>,
}

/// A quantity that drives a model: a column of a record, or a value at which it is held.
#[derive(Debug, Serialize, TS)]
pub struct Drive {
    name: &'static str,
    /// Its units for a body that slides and for one that turns.
    units: [&'static str; 2],
    /// Its value where a record has no such column; none if it must be given.
    usual: Option<f64>,
    help: &'static str,
}

/// Solvers of the thesis, and its times in s for each law; null where it did not converge.
#[derive(Debug, Serialize, TS)]
pub struct Thesis {
    classes: [&'static str; 4],
    times: &'static [(&'static str, [Option<f64>; 4])],
}

/// Colours and dashes.
#[derive(Debug, Serialize, TS)]
pub struct Palette {
    light: Colours,
    dark: Colours,
    dashes: [&'static str; palette::MOST_LAWS],
}

/// Colours of a picture.
#[derive(Debug, Serialize, TS)]
pub struct Colours {
    paper: &'static str,
    ink: &'static str,
    grid: &'static str,
    axis: &'static str,
    #[ts(type = "string[]")]
    laws: [&'static str; palette::MOST_LAWS],
}

/// A name with one line on it.
#[derive(Debug, Serialize, TS)]
pub struct Named {
    name: String,
    help: String,
}

/// A built-in system.
#[derive(Debug, Serialize, TS)]
pub struct SystemEntry {
    name: &'static str,
    title: String,
    source: String,
    until: f64,
    every: f64,
    #[ts(type = "Record<string, string>")]
    show: BTreeMap<String, String>,
    /// The law of the part that any law can be; none if laws are chosen inside of parts.
    law: Option<String>,
}

/// A model.
#[derive(Debug, Serialize, TS)]
pub struct Model {
    name: &'static str,
    summary: &'static str,
    variables: Vec<Described>,
    presets: Vec<Preset>,
}

/// A preset of a model.
#[derive(Debug, Serialize, TS)]
pub struct Preset {
    name: &'static str,
    source: &'static str,
    /// Values as a user writes them.
    #[ts(type = "Record<string, string>")]
    values: BTreeMap<&'static str, String>,
}

/// A variable of a model.
#[derive(Debug, Serialize, TS)]
#[ts(rename = "Variable")]
pub struct Described {
    name: String,
    role: String,
    #[ts(type = "\"real\" | \"integer\" | \"boolean\" | \"choice\"")]
    kind: &'static str,
    unit: &'static str,
    start: f64,
    nominal: f64,
    bound: String,
    minimum: Option<f64>,
    maximum: Option<f64>,
    help: String,
    choices: Vec<Named>,
    /// The part that it plays in a law of friction.
    meaning: String,
}

/// Models by family, systems and solvers.
pub fn catalogue() -> Result<Answer, Fault> {
    let family = |family: Family| documented(family).map(|(model, _)| described(model)).collect();
    let solver = |solver: clap::builder::PossibleValue| Named {
        name: solver.get_name().to_owned(),
        help: solver.get_help().map_or(String::new(), ToString::to_string),
    };
    // In one loop, from which the compiler sees that the pages of the models are not read: they stay out of the library.
    let mut fitted = Vec::new();
    identify::fittable().for_each(|model| fitted.extend(fittable(model)));
    Ok(Answer::plain(Catalogue {
        version: env!("CARGO_PKG_VERSION"),
        laws: family(Family::Friction),
        shock_absorber: family(Family::ShockAbsorber),
        hosts: family(Family::Host),
        components: family(Family::Component),
        systems: BUILT_IN
            .iter()
            .filter_map(|(name, text)| system(name, text).transpose())
            .collect::<Result<_, Fault>>()?,
        solvers: Solver::value_variants().iter().filter_map(ValueEnum::to_possible_value).map(solver).collect(),
        fitted,
        thesis: Thesis { classes: CLASSES, times: TABLE_6_5 },
        palette: Palette { light: colours(&LIGHT), dark: colours(&DARK), dashes: DASHES },
    }))
}

fn colours(&palette::Colours { paper, ink, grid, axis, laws }: &palette::Colours) -> Colours {
    Colours { paper, ink, grid, axis, laws }
}

fn fittable(model: &'static ModelType) -> Option<Fittable> {
    let Ports { load, led, .. } = Ports::of(model)?;
    let drive = |Led { column, name, unit, is_input }: Led| {
        let variable = model.table.at(column);
        let units = [Movement::Translation, Movement::Rotation].map(|movement| movement.unit(unit));
        Drive { name, units, usual: (!is_input).then_some(variable.start), help: variable.help }
    };
    Some(Fittable { name: model.name, has_load: load.is_some(), drives: led.into_iter().map(drive).collect() })
}

/// A system in which laws can be compared.
fn system(name: &'static str, text: &str) -> Result<Option<SystemEntry>, Fault> {
    let description = Description::parse(text)?;
    if !description.takes_laws() {
        return Ok(None);
    }
    let Description { title, source, until, every, show, part, .. } = description;
    // Either a part is a law, or parts contain one that can be chosen.
    let law = part.values().find_map(|part| part.law.clone());
    Ok(Some(SystemEntry { name, title, source, until, every, show, law }))
}

fn described(model: &'static ModelType) -> Model {
    let preset = |preset: &stribeck::model::Preset| {
        let values = preset.values.iter().map(|(name, value)| (*name, spelling(model, name, *value)));
        Preset { name: preset.name, source: preset.source, values: values.collect() }
    };
    Model {
        name: model.name,
        summary: model.summary,
        variables: model.variables().map(|(_, variable)| variable_of(&variable)).collect(),
        presets: model.presets.iter().map(preset).collect(),
    }
}

/// A value as a user writes it.
fn spelling(model: &ModelType, name: &str, value: f64) -> String {
    model.find(name).map_or_else(|| value.to_string(), |column| text_of(&model.table.at(column), value))
}

fn variable_of(variable: &Variable) -> Described {
    let [kind, unit] = variable.kind.words();
    let choices = variable.kind.choices().iter();
    let named = choices.map(|item| Named { name: item.name.to_string(), help: item.help.to_string() });
    Described {
        name: variable.path.to_string(),
        role: format!("{:?}", variable.role),
        kind,
        unit,
        start: variable.start,
        nominal: variable.nominal,
        bound: variable.bound.to_string(),
        minimum: Some(variable.bound.min()).filter(|low| *low > f64::MIN),
        maximum: Some(variable.bound.max()).filter(|high| *high < f64::MAX),
        help: variable.help.to_string(),
        choices: named.collect(),
        meaning: format!("{:?}", variable.meaning),
    }
}
