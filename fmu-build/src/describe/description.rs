//! What the descriptions of all versions of FMI have in common.

use std::collections::BTreeMap;
use std::io;

use jiff::Timestamp;
use stribeck::model::{Enumeration, Kind, ModelType, Role, Variable};
use stribeck::reference::Reference;
use stribeck::unit::{UNITS, Unit};
use stribeck_ffi::fmi2::log::CATEGORIES;

use crate::describe::only_law::{self, OnlyLaw};
use crate::describe::structure::integrated;
use crate::describe::text::{limits, number};
use crate::describe::xml::{Attributes, Xml, leaf, parent};
use crate::project::{AUTHORS, LICENSE, VERSION, copyright};

/// Attributes of the root. `token` names the attribute with the guid.
pub fn root_attributes(model: &ModelType, date: Timestamp, version: &str, token: &'static str) -> Attributes {
    vec![
        ("fmiVersion", version.into()),
        ("modelName", model.name.into()),
        (token, model.guid().into()),
        ("description", model.summary.into()),
        ("author", AUTHORS.into()),
        ("version", VERSION.into()),
        ("copyright", copyright()),
        ("license", LICENSE.into()),
        ("generationTool", format!("Stribeck {VERSION}")),
        ("generationDateAndTime", date.to_string()),
        ("variableNamingConvention", "structured".into()),
    ]
}

/// The same for C sources, which may have only one law.
pub fn root_attributes_of_sources(
    model: &ModelType,
    date: Timestamp,
    version: &str,
    token: &'static str,
    law: Option<OnlyLaw>,
) -> Attributes {
    let mut attributes = root_attributes(model, date, version, token);
    for (_, value) in attributes.iter_mut().filter(|(name, _)| *name == "description") {
        value.extend(law.map(|law| format!("; C sources with one law, {}", law.name)));
    }
    attributes
}

/// `<ModelExchange>` or `<CoSimulation>`.
pub fn interface(
    xml: &mut Xml,
    element: &'static str,
    model: &ModelType,
    capabilities: &[(&'static str, &str)],
) -> io::Result<()> {
    leaf(xml, element, interface_attributes(model, capabilities))
}

/// The attributes of an interface: the name of its functions' library, and its capabilities.
pub fn interface_attributes(model: &ModelType, capabilities: &[(&'static str, &str)]) -> Attributes {
    let identifier = ("modelIdentifier", model.name.to_owned());
    let capabilities = capabilities.iter().map(|(name, value)| (*name, (*value).to_owned()));
    [identifier].into_iter().chain(capabilities).collect()
}

/// The unit of the time derivative of a state.
pub fn unit_of_rate(state: &Variable) -> Option<&'static Unit> {
    let Kind::Real(unit) = state.kind else { return None };
    let mut exponents = unit.exponents();
    exponents[2] -= 1;
    UNITS.iter().find(|rate| rate.exponents() == exponents)
}

/// The unit of the independent variable.
pub fn second() -> &'static Unit {
    UNITS.iter().find(|unit| unit.name == "s").expect("UNITS has the second")
}

/// Units of the variables and of time, each once, by name.
pub fn units(model: &ModelType) -> BTreeMap<&'static str, &'static Unit> {
    let of_variables = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Real(unit) => Some(unit),
        _ => None,
    });
    let of_rates = integrated(model).into_iter().filter_map(|state| unit_of_rate(&model.table.at(state)));
    of_variables.chain(of_rates).chain([second()]).map(|unit| (unit.name, unit)).collect()
}

/// Enumerations of the variables, each once, by name.
pub fn enumerations(model: &ModelType) -> BTreeMap<&'static str, &'static Enumeration> {
    let of_variables = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Enumeration(items) => Some(items),
        _ => None,
    });
    of_variables.map(|items| (items.name, items)).collect()
}

/// `<UnitDefinitions>`.
pub fn unit_definitions(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    parent(xml, "UnitDefinitions", vec![], |xml| units(model).values().try_for_each(|unit| unit_definition(xml, unit)))
}

fn unit_definition(xml: &mut Xml, unit: &Unit) -> io::Result<()> {
    parent(xml, "Unit", vec![("name", unit.name.into())], |xml| {
        leaf(xml, "BaseUnit", unit.base_units().map(|(base, exponent)| (base, exponent.to_string())).collect())?;
        for display in unit.display {
            let mut attributes = vec![("name", display.name.into()), ("factor", number(display.factor))];
            if display.offset != 0.0 {
                attributes.push(("offset", number(display.offset)));
            }
            leaf(xml, "DisplayUnit", attributes)?;
        }
        Ok(())
    })
}

/// The choices of an enumeration that there are with this law, or all of them.
pub fn items(xml: &mut Xml, enumeration: &Enumeration, law: Option<OnlyLaw>) -> io::Result<()> {
    for (item, value) in enumeration.items.iter().zip(1..).filter(|(item, _)| only_law::has(law, enumeration, item)) {
        let attributes =
            vec![("name", item.name.into()), ("value", i32::to_string(&value)), ("description", item.help.into())];
        leaf(xml, "Item", attributes)?;
    }
    Ok(())
}

/// `<LogCategories>`.
pub fn log_categories(xml: &mut Xml) -> io::Result<()> {
    parent(xml, "LogCategories", vec![], |xml| {
        CATEGORIES.iter().try_for_each(|category| {
            let name = category.name.to_string_lossy().into_owned();
            leaf(xml, "Category", vec![("name", name), ("description", category.description.into())])
        })
    })
}

/// `<DefaultExperiment>`. Forty seconds show several stick-slip cycles of the thesis' benchmark with the default
/// parameters (chosen).
pub fn default_experiment(xml: &mut Xml) -> io::Result<()> {
    let attributes = [("startTime", 0.0), ("stopTime", 40.0), ("tolerance", 1e-6), ("stepSize", 1e-3)];
    leaf(xml, "DefaultExperiment", attributes.map(|(name, value)| (name, number(value))).into())
}

/// Attributes of a variable of any type.
pub fn variable_attributes(
    name: String,
    reference: Reference,
    help: &str,
    [causality, variability, initial]: [&str; 3],
) -> Attributes {
    let mut attributes = vec![
        ("name", name),
        ("valueReference", reference.to_string()),
        ("description", help.to_owned()),
        ("causality", causality.to_owned()),
        ("variability", variability.to_owned()),
    ];
    if !initial.is_empty() {
        attributes.push(("initial", initial.to_owned()));
    }
    attributes
}

/// Causality, variability and initial; FMI 2.0 forbids `initial` for inputs, and FMI 3.0 knows it to be exact.
pub fn causality(variable: &Variable) -> [&'static str; 3] {
    let jumps = if variable.role.is_state() { variable.jumps } else { !matches!(variable.kind, Kind::Real(_)) };
    let changing = if jumps { "discrete" } else { "continuous" };
    match variable.role {
        Role::Input => ["input", changing, ""],
        Role::Fixed => ["parameter", "fixed", "exact"],
        Role::Tunable => ["parameter", "tunable", "exact"],
        Role::State => ["local", changing, "exact"],
        Role::StateOutput => ["output", changing, "exact"],
        Role::Output => ["output", changing, "calculated"],
    }
}

/// Causality, variability and initial of the independent variable.
pub const INDEPENDENT: [&str; 3] = ["independent", "continuous", ""];

/// Causality, variability and initial of a derivative or an event indicator.
pub const CALCULATED: [&str; 3] = ["local", "continuous", "calculated"];

/// Name and description of the time derivative of a state.
pub fn derivative_of(state: &impl std::fmt::Display) -> (String, String) {
    (format!("der({state})"), format!("Time derivative of {state}."))
}

/// Attributes of the type of a physical quantity.
pub fn real_type(unit: &Unit) -> Attributes {
    vec![("declaredType", unit.quantity.into()), ("unit", unit.name.into())]
}

/// Attributes of what a variable may be: display unit, limits, nominal value, start values of its elements, whether
/// an event may set it.
pub fn value_attributes(model: &ModelType, variable: &Variable, is_real: bool, starts: &str) -> Attributes {
    let mut attributes = Attributes::new();
    attributes.extend(variable.display.map(|display| ("displayUnit", display.into())));
    let (min, max) = limits(variable);
    attributes.extend(min.map(|min| ("min", number(min))));
    attributes.extend(max.map(|max| ("max", number(max))));
    if is_real && variable.nominal != 1.0 {
        attributes.push(("nominal", number(variable.nominal)));
    }
    if !variable.role.is_computed() {
        attributes.push(("start", starts.to_owned()));
    }
    if model.model_exchange && variable.reinit {
        attributes.push(("reinit", "true".into()));
    }
    attributes
}

/// The start value, as XML has it.
pub fn start(variable: &Variable) -> String {
    match variable.kind {
        Kind::Boolean => (variable.start != 0.0).to_string(),
        _ => number(variable.start),
    }
}
