//! modelDescription.xml of FMI 2.0.5, written from a model's table. The order of the elements is that of the standard's
//! schema, which is a sequence.

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use anyhow::Result;
use jiff::Timestamp;
use quick_xml::events::{BytesDecl, Event};
use quick_xml::writer::{ElementWriter, Writer};
use stribeck::model::{Enumeration, Kind, ModelType, Role, Variable};
use stribeck::unit::{UNITS, Unit};

use crate::project::{AUTHORS, LICENSE, VERSION, copyright};
use crate::text::{limits, number};
use crate::dependencies;

type Xml = Writer<Vec<u8>>;
type Attributes = Vec<(&'static str, String)>;

/// What `<CoSimulation>` promises.
pub const CAPABILITIES: [(&str, &str); 10] = [
    ("needsExecutionTool", "false"),
    ("canHandleVariableCommunicationStepSize", "true"),
    ("canInterpolateInputs", "true"),
    ("maxOutputDerivativeOrder", "1"),
    ("canRunAsynchronuously", "false"), // spelled as in the standard
    ("canBeInstantiatedOnlyOncePerProcess", "false"),
    ("canNotUseMemoryManagementFunctions", "true"),
    ("canGetAndSetFMUstate", "true"),
    ("canSerializeFMUstate", "true"),
    ("providesDirectionalDerivative", "true"),
];

/// Categories of the messages that the library logs.
const LOG_CATEGORIES: [(&str, &str); 3] = [
    ("logStatusDiscard", "Answers with status fmi2Discard: a value was refused and nothing was changed."),
    ("logStatusError", "Answers with status fmi2Error: a call was refused and nothing was changed."),
    ("logAll", "All messages."),
];

/// The text of modelDescription.xml.
pub fn model_description(model: &ModelType, date: Timestamp) -> Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    parent(&mut xml, "fmiModelDescription", root_attributes(model, date), |xml| {
        co_simulation(xml, model)?;
        unit_definitions(xml, model)?;
        type_definitions(xml, model)?;
        log_categories(xml)?;
        default_experiment(xml)?;
        model_variables(xml, model)?;
        model_structure(xml, model)
    })?;
    Ok(String::from_utf8(xml.into_inner())? + "\n")
}

fn parent(
    xml: &mut Xml,
    name: &'static str,
    attributes: Attributes,
    children: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    element(xml, name, &attributes).write_inner_content(children)?;
    Ok(())
}

fn leaf(xml: &mut Xml, name: &'static str, attributes: Attributes) -> io::Result<()> {
    element(xml, name, &attributes).write_empty()?;
    Ok(())
}

/// A tag with its attributes; one per line if there are many, so that a change of one is a change of one line.
fn element<'a>(xml: &'a mut Xml, name: &'static str, attributes: &Attributes) -> ElementWriter<'a, Vec<u8>> {
    let is_long = attributes.len() > 8;
    attributes.iter().fold(xml.create_element(name), |tag, (key, value)| {
        let tag = if is_long { tag.new_line() } else { tag };
        tag.with_attribute((*key, value.as_str()))
    })
}

fn root_attributes(model: &ModelType, date: Timestamp) -> Attributes {
    vec![
        ("fmiVersion", "2.0".into()),
        ("modelName", model.name.into()),
        ("guid", model.guid().into()),
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

fn co_simulation(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    let identifier = ("modelIdentifier", model.name.to_owned());
    let capabilities = CAPABILITIES.map(|(name, value)| (name, value.to_owned()));
    leaf(xml, "CoSimulation", [identifier].into_iter().chain(capabilities).collect())
}

/// The unit of the independent variable.
fn second() -> &'static Unit {
    UNITS.iter().find(|unit| unit.name == "s").expect("UNITS has the second")
}

/// Units of the variables and of time, each once, by name.
fn units(model: &ModelType) -> BTreeMap<&'static str, &'static Unit> {
    let of_variables = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Real(unit) => Some(unit),
        _ => None,
    });
    of_variables.chain([second()]).map(|unit| (unit.name, unit)).collect()
}

/// Enumerations of the variables, each once, by name.
fn enumerations(model: &ModelType) -> BTreeMap<&'static str, &'static Enumeration> {
    let of_variables = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Enumeration(items) => Some(items),
        _ => None,
    });
    of_variables.map(|items| (items.name, items)).collect()
}

fn unit_definitions(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    parent(xml, "UnitDefinitions", vec![], |xml| units(model).values().try_for_each(|unit| unit_definition(xml, unit)))
}

fn unit_definition(xml: &mut Xml, unit: &Unit) -> io::Result<()> {
    parent(xml, "Unit", vec![("name", unit.name.into())], |xml| {
        let exponents = [("kg", unit.kg), ("m", unit.m), ("s", unit.s)];
        let present = exponents.into_iter().filter(|(_, exponent)| *exponent != 0);
        leaf(xml, "BaseUnit", present.map(|(base, exponent)| (base, exponent.to_string())).collect())?;
        for display in unit.display {
            let factor = ("factor", number(display.factor));
            leaf(xml, "DisplayUnit", vec![("name", display.name.into()), factor])?;
        }
        Ok(())
    })
}

fn type_definitions(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    parent(xml, "TypeDefinitions", vec![], |xml| {
        for unit in units(model).values() {
            simple_type(xml, unit.quantity, |xml| {
                leaf(xml, "Real", vec![("quantity", unit.quantity.into()), ("unit", unit.name.into())])
            })?;
        }
        for enumeration in enumerations(model).values() {
            simple_type(xml, enumeration.name, |xml| {
                parent(xml, "Enumeration", vec![], |xml| items(xml, enumeration))
            })?;
        }
        Ok(())
    })
}

fn simple_type(xml: &mut Xml, name: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> io::Result<()> {
    parent(xml, "SimpleType", vec![("name", name.into())], content)
}

fn items(xml: &mut Xml, enumeration: &Enumeration) -> io::Result<()> {
    for (item, value) in enumeration.items.iter().zip(1..) {
        let attributes =
            vec![("name", item.name.into()), ("value", i32::to_string(&value)), ("description", item.help.into())];
        leaf(xml, "Item", attributes)?;
    }
    Ok(())
}

fn log_categories(xml: &mut Xml) -> io::Result<()> {
    parent(xml, "LogCategories", vec![], |xml| {
        LOG_CATEGORIES.into_iter().try_for_each(|(name, description)| {
            leaf(xml, "Category", vec![("name", name.into()), ("description", description.into())])
        })
    })
}

/// Forty seconds show several cycles of stick-slip of the thesis' benchmark with the default parameters (chosen).
fn default_experiment(xml: &mut Xml) -> io::Result<()> {
    let attributes = [("startTime", 0.0), ("stopTime", 40.0), ("tolerance", 1e-8), ("stepSize", 1e-3)];
    leaf(xml, "DefaultExperiment", attributes.map(|(name, value)| (name, number(value))).into())
}

fn model_variables(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    parent(xml, "ModelVariables", vec![], |xml| {
        for (column, variable) in model.table.iter().enumerate() {
            let name = variable.path.to_string();
            let attributes = scalar_attributes(name, column, variable.help, causality(variable));
            parent(xml, "ScalarVariable", attributes, |xml| declaration(xml, variable))?;
        }
        let independent = ["independent", "continuous", ""];
        let attributes = scalar_attributes("time".into(), model.table.len(), "Time.", independent);
        parent(xml, "ScalarVariable", attributes, |xml| leaf(xml, "Real", real_type(second())))
    })
}

fn scalar_attributes(name: String, column: usize, help: &str, [causality, variability, initial]: [&str; 3]) -> Attributes {
    let mut attributes = vec![
        ("name", name),
        ("valueReference", column.to_string()),
        ("description", help.to_owned()),
        ("causality", causality.to_owned()),
        ("variability", variability.to_owned()),
    ];
    if !initial.is_empty() {
        attributes.push(("initial", initial.to_owned()));
    }
    attributes
}

/// Causality, variability and initial; the standard forbids `initial` for inputs.
fn causality(variable: &Variable) -> [&'static str; 3] {
    let changing = if matches!(variable.kind, Kind::Real(_)) { "continuous" } else { "discrete" };
    match variable.role {
        Role::Input => ["input", changing, ""],
        Role::Fixed => ["parameter", "fixed", "exact"],
        Role::Tunable => ["parameter", "tunable", "exact"],
        Role::State => ["local", changing, "exact"],
        Role::StateOutput => ["output", changing, "exact"],
        Role::Output => ["output", changing, "calculated"],
    }
}

fn real_type(unit: &Unit) -> Attributes {
    vec![("declaredType", unit.quantity.into()), ("unit", unit.name.into())]
}

/// The element inside `<ScalarVariable>`: type, limits and start value.
fn declaration(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let (element, mut attributes) = match variable.kind {
        Kind::Real(unit) => ("Real", real_type(unit)),
        Kind::Integer => ("Integer", vec![]),
        Kind::Boolean => ("Boolean", vec![]),
        Kind::Enumeration(items) => ("Enumeration", vec![("declaredType", items.name.into())]),
    };
    attributes.extend(variable.display.map(|display| ("displayUnit", display.into())));
    let (min, max) = limits(variable);
    attributes.extend(min.map(|min| ("min", number(min))));
    attributes.extend(max.map(|max| ("max", number(max))));
    if element == "Real" && variable.nominal != 1.0 {
        attributes.push(("nominal", number(variable.nominal)));
    }
    if !variable.role.is_computed() {
        attributes.push(("start", start(variable)));
    }
    leaf(xml, element, attributes)
}

fn start(variable: &Variable) -> String {
    match variable.kind {
        Kind::Boolean => (variable.start != 0.0).to_string(),
        _ => number(variable.start),
    }
}

fn model_structure(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    let dependencies = dependencies::of(model);
    let is_input = |column: &&usize| model.table[**column].role == Role::Input;
    parent(xml, "ModelStructure", vec![], |xml| {
        let outputs = || (0..model.table.len()).filter(|column| model.table[*column].role.is_output());
        if outputs().next().is_some() {
            parent(xml, "Outputs", vec![], |xml| {
                outputs().try_for_each(|output| {
                    unknown(xml, output, &dependencies[output].iter().filter(is_input).copied().collect())
                })
            })?;
        }
        let mut initial = outputs().filter(|output| model.table[*output].role.is_computed()).peekable();
        if initial.peek().is_some() {
            parent(xml, "InitialUnknowns", vec![], |xml| {
                initial.try_for_each(|output| unknown(xml, output, &dependencies[output]))
            })?;
        }
        Ok(())
    })
}

/// An entry of the model structure. Its indices count the variables from 1.
fn unknown(xml: &mut Xml, column: usize, dependencies: &BTreeSet<usize>) -> io::Result<()> {
    let index = |column: &usize| (column + 1).to_string();
    let indices: Vec<String> = dependencies.iter().map(index).collect();
    let mut attributes = vec![("index", index(&column)), ("dependencies", indices.join(" "))];
    if !dependencies.is_empty() {
        attributes.push(("dependenciesKind", vec!["dependent"; dependencies.len()].join(" ")));
    }
    leaf(xml, "Unknown", attributes)
}
