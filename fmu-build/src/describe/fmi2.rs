//! modelDescription.xml of FMI 2.0.5, written from a model's table. The order of the elements is prescribed by the
//! schema of the standard.

use std::collections::BTreeSet;
use std::io;

use anyhow::Result;
use jiff::Timestamp;
use stribeck::model::{Kind, ModelType, Variable};
use stribeck::reference;

use crate::describe::description::{
    CALCULATED, INDEPENDENT, causality, default_experiment, derivative_of, enumerations, interface,
    interface_attributes, items, log_categories, real_type, root_attributes, root_attributes_of_sources, second, start,
    unit_definitions, unit_of_rate, units, value_attributes, variable_attributes,
};
use crate::describe::only_law::{self, OnlyLaw};
use crate::describe::structure::{Structure, index, integrated};
use crate::describe::text::number;
use crate::describe::xml::{Attributes, Xml, document, leaf, parent};

/// Capabilities declared in `<ModelExchange>`.
pub const EXCHANGE_CAPABILITIES: [(&str, &str); 6] = [
    ("needsExecutionTool", "false"),
    ("canBeInstantiatedOnlyOncePerProcess", "false"),
    ("canNotUseMemoryManagementFunctions", "true"),
    ("canGetAndSetFMUstate", "true"),
    ("canSerializeFMUstate", "true"),
    ("providesDirectionalDerivative", "true"),
];

/// Capabilities declared in `<CoSimulation>`.
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

/// Types of the variables that are not physical quantities. The library accepts choices as enumerations and as integers,
/// because FMI 2.0 sets both by the same function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choices {
    /// As enumerations, whose choices have names.
    Named,
    /// As integers, for importers that do not support enumerations.
    Numbered,
    /// As Real, whole numbers and Booleans too, for importers that know no other type. The library knows by another guid
    /// that the importer does so.
    Plain,
}

/// The text of modelDescription.xml.
pub fn model_description(model: &ModelType, date: Timestamp, choices: Choices) -> Result<String> {
    let mut attributes = root_attributes(model, date, "2.0", "guid");
    if choices == Choices::Plain {
        say_plain(model, &mut attributes);
    }
    if model.model_exchange {
        attributes.push(("numberOfEventIndicators", model.event_indicators.to_string()));
    }
    describe(model, attributes, choices, None, |xml| {
        if model.model_exchange {
            interface(xml, "ModelExchange", model, &EXCHANGE_CAPABILITIES)?;
        }
        interface(xml, "CoSimulation", model, &CAPABILITIES)
    })
}

/// The text of modelDescription.xml for an FMU with C sources in these files in place of libraries, for co-simulation, with
/// one law if the model has a choice.
pub fn source_description(model: &ModelType, date: Timestamp, files: &[&str], law: Option<OnlyLaw>) -> Result<String> {
    let attributes = root_attributes_of_sources(model, date, "2.0", "guid", law);
    describe(model, attributes, Choices::Named, law, |xml| {
        parent(xml, "CoSimulation", interface_attributes(model, &CAPABILITIES), |xml| {
            parent(xml, "SourceFiles", Vec::new(), |xml| {
                files.iter().try_for_each(|file| leaf(xml, "File", vec![("name", (*file).to_owned())]))
            })
        })
    })
}

/// A description with these interfaces.
fn describe(
    model: &ModelType,
    attributes: Attributes,
    choices: Choices,
    law: Option<OnlyLaw>,
    interfaces: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> Result<String> {
    document("fmiModelDescription", attributes, |xml| {
        interfaces(xml)?;
        unit_definitions(xml, model)?;
        type_definitions(xml, model, choices, law)?;
        log_categories(xml)?;
        default_experiment(xml)?;
        model_variables(xml, model, choices, law)?;
        model_structure(xml, model)
    })
}

/// Says in name and description that all variables are Real.
fn say_plain(model: &ModelType, attributes: &mut Attributes) {
    for (name, value) in attributes {
        match *name {
            "modelName" => value.push_str(" (plain)"),
            "description" => value.push_str("; all variables are Real, Booleans 0 and 1, choices by number"),
            "guid" => *value = String::from_utf8_lossy(&model.plain_guid()).into_owned(),
            _ => {}
        }
    }
}

/// The description of a variable. In a plain description it says what its numbers stand for.
fn help(variable: &Variable, choices: Choices) -> String {
    let meanings = match variable.kind {
        _ if choices != Choices::Plain => return variable.help.to_owned(),
        Kind::Boolean => "0 = false, 1 = true".to_owned(),
        Kind::Integer => "A whole number".to_owned(),
        Kind::Enumeration(items) => {
            let named = items.items.iter().zip(1..).map(|(item, number): (_, i32)| format!("{number} = {}", item.name));
            named.collect::<Vec<_>>().join(", ")
        }
        Kind::Real(_) => return variable.help.to_owned(),
    };
    format!("{} {meanings}.", variable.help)
}

fn type_definitions(xml: &mut Xml, model: &ModelType, choices: Choices, law: Option<OnlyLaw>) -> io::Result<()> {
    parent(xml, "TypeDefinitions", vec![], |xml| {
        for unit in units(model).values() {
            simple_type(xml, unit.quantity, |xml| {
                leaf(xml, "Real", vec![("quantity", unit.quantity.into()), ("unit", unit.name.into())])
            })?;
        }
        for enumeration in enumerations(model).values().filter(|_| choices != Choices::Plain) {
            simple_type(xml, enumeration.name, |xml| {
                parent(xml, "Enumeration", vec![], |xml| items(xml, enumeration, law))
            })?;
        }
        Ok(())
    })
}

fn simple_type(xml: &mut Xml, name: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> io::Result<()> {
    parent(xml, "SimpleType", vec![("name", name.into())], content)
}

fn model_variables(xml: &mut Xml, model: &ModelType, choices: Choices, law: Option<OnlyLaw>) -> io::Result<()> {
    parent(xml, "ModelVariables", vec![], |xml| {
        for (column, variable) in model.variables() {
            let variable = only_law::begun(law, column, variable);
            let name = variable.path.to_string();
            let help = help(&variable, choices);
            let attributes = variable_attributes(name, model.reference(column), &help, causality(&variable));
            parent(xml, "ScalarVariable", attributes, |xml| declaration(xml, model, &variable, choices))?;
        }
        let attributes = variable_attributes("time".into(), reference::TIME, "Time.", INDEPENDENT);
        parent(xml, "ScalarVariable", attributes, |xml| leaf(xml, "Real", real_type(second())))?;
        integrated(model).into_iter().try_for_each(|state| derivative(xml, model, state))
    })
}

/// The variable behind the independent one that is the time derivative of a state.
fn derivative(xml: &mut Xml, model: &ModelType, state: usize) -> io::Result<()> {
    let variable = &model.table.at(state);
    let (name, help) = derivative_of(&variable.path);
    let attributes = variable_attributes(name, reference::of_derivative(&variable.path), &help, CALCULATED);
    parent(xml, "ScalarVariable", attributes, |xml| {
        let mut attributes = unit_of_rate(variable).map(real_type).unwrap_or_default();
        attributes.push(("derivative", index(model, state).to_string()));
        leaf(xml, "Real", attributes)
    })
}

/// The element inside `<ScalarVariable>`: type, limits and start value.
fn declaration(xml: &mut Xml, model: &ModelType, variable: &Variable, choices: Choices) -> io::Result<()> {
    let (element, mut attributes) = element_of(variable.kind, choices);
    let is_plain = choices == Choices::Plain;
    let start = if is_plain { number(variable.start) } else { start(variable) };
    attributes.extend(value_attributes(model, variable, element == "Real", &start));
    if is_plain {
        limit(variable, &mut attributes);
    }
    leaf(xml, element, attributes)
}

/// Adds the limits that the type of a variable has, where they are not narrower ones already.
fn limit(variable: &Variable, attributes: &mut Attributes) {
    let (low, high) = match variable.kind {
        Kind::Boolean => (0.0, 1.0),
        Kind::Enumeration(items) => (1.0, items.items.len() as f64),
        Kind::Real(_) | Kind::Integer => return,
    };
    let is_given = |name| attributes.iter().any(|(known, _)| *known == name);
    let missing = [("min", low), ("max", high)].into_iter().filter(|(name, _)| !is_given(*name));
    let missing: Attributes = missing.map(|(name, value)| (name, number(value))).collect();
    attributes.splice(0..0, missing);
}

/// The name of the element for a type, and the attributes of the type.
fn element_of(kind: Kind, choices: Choices) -> (&'static str, Attributes) {
    match kind {
        Kind::Real(unit) => ("Real", real_type(unit)),
        _ if choices == Choices::Plain => ("Real", vec![]),
        Kind::Boolean => ("Boolean", vec![]),
        Kind::Enumeration(items) if choices == Choices::Named => {
            ("Enumeration", vec![("declaredType", items.name.into())])
        }
        Kind::Integer | Kind::Enumeration(_) => ("Integer", vec![]),
    }
}

fn model_structure(xml: &mut Xml, model: &ModelType) -> io::Result<()> {
    let structure = Structure::of(model);
    let while_stepping = |xml: &mut Xml, place| unknown(xml, model, place, structure.while_stepping(place).as_ref());
    parent(xml, "ModelStructure", vec![], |xml| {
        list(xml, "Outputs", &structure.outputs(), while_stepping)?;
        list(xml, "Derivatives", &structure.derivatives(), while_stepping)?;
        list(xml, "InitialUnknowns", &structure.initial(), |xml, place| {
            unknown(xml, model, place, structure.initially(place).as_ref())
        })
    })
}

/// A list of the model structure, unless it is empty.
fn list(
    xml: &mut Xml,
    name: &'static str,
    entries: &[usize],
    mut entry: impl FnMut(&mut Xml, usize) -> io::Result<()>,
) -> io::Result<()> {
    if entries.is_empty() {
        return Ok(());
    }
    parent(xml, name, vec![], |xml| entries.iter().try_for_each(|column| entry(xml, *column)))
}

/// An entry of the model structure.
fn unknown(xml: &mut Xml, model: &ModelType, place: usize, dependencies: Option<&BTreeSet<usize>>) -> io::Result<()> {
    let index = |place: &usize| index(model, *place).to_string();
    let mut attributes = vec![("index", index(&place))];
    if let Some(dependencies) = dependencies {
        let indices: Vec<String> = dependencies.iter().map(index).collect();
        attributes.push(("dependencies", indices.join(" ")));
        if !dependencies.is_empty() {
            attributes.push(("dependenciesKind", vec!["dependent"; dependencies.len()].join(" ")));
        }
    }
    leaf(xml, "Unknown", attributes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::release_date;
    use crate::specimen::SPECIMEN;
    use roxmltree::{Document, Node};
    use std::sync::LazyLock;

    /// Runs a test on the description of every model and of one with all features that no shipped model has yet.
    fn on_every_description(test: impl Fn(&ModelType, &Document)) {
        static TEXTS: LazyLock<Vec<(&ModelType, String)>> = LazyLock::new(|| {
            let models = stribeck::catalogue::models().chain([&SPECIMEN]);
            models.map(|model| (model, model_description(model, release_date(), Choices::Named).unwrap())).collect()
        });
        for (model, text) in TEXTS.iter() {
            test(model, &Document::parse(text).unwrap());
        }
    }

    fn all<'a>(document: &'a Document, name: &str) -> Vec<Node<'a, 'a>> {
        document.descendants().filter(|node| node.has_tag_name(name)).collect()
    }

    /// Each `<ScalarVariable>` with the element inside it.
    fn variables<'a>(document: &'a Document) -> Vec<(Node<'a, 'a>, Node<'a, 'a>)> {
        let with_type = |node: Node<'a, 'a>| (node, node.first_element_child().unwrap());
        all(document, "ScalarVariable").into_iter().map(with_type).collect()
    }

    fn text<'a>(node: Node<'a, '_>, attribute: &str) -> &'a str {
        node.attribute(attribute).unwrap_or_else(|| panic!("{} without {attribute}", node.tag_name().name()))
    }

    fn number_of(node: Node, attribute: &str) -> Option<f64> {
        node.attribute(attribute).map(|text| text.parse().unwrap())
    }

    fn assert_unique<T: Ord + std::fmt::Debug>(values: impl Iterator<Item = T>) {
        let mut seen = BTreeSet::new();
        for value in values {
            assert!(!seen.contains(&value), "{value:?} twice");
            seen.insert(value);
        }
    }

    #[test]
    fn numbered_choices_are_integers_with_the_same_range() {
        let count = SPECIMEN.table.iter().filter(|variable| matches!(variable.kind, Kind::Enumeration(_))).count();
        assert!(count > 0);
        let [named, numbered] = [Choices::Named, Choices::Numbered]
            .map(|choices| model_description(&SPECIMEN, release_date(), choices).unwrap());
        let [named, numbered] = [&named, &numbered].map(|text| Document::parse(text).unwrap());
        let mut changed = 0;
        for ((_, a), (_, b)) in variables(&named).into_iter().zip(variables(&numbered)) {
            changed += usize::from(a.tag_name() != b.tag_name());
            for attribute in ["start", "min", "max"] {
                assert_eq!(a.attribute(attribute), b.attribute(attribute));
            }
        }
        assert_eq!(changed, count);
        assert!(variables(&numbered).iter().all(|(_, kind)| !kind.has_tag_name("Enumeration")));
    }

    #[test]
    fn plain_variables_are_real_and_say_what_their_numbers_mean() {
        let [named, plain] = [Choices::Named, Choices::Plain]
            .map(|choices| model_description(&SPECIMEN, release_date(), choices).unwrap());
        let [named, plain] = [&named, &plain].map(|text| Document::parse(text).unwrap());
        assert_eq!(all(&plain, "SimpleType").len(), all(&named, "SimpleType").len() - 1);
        for ((old, a), (new, b)) in variables(&named).into_iter().zip(variables(&plain)) {
            assert!(b.has_tag_name("Real"), "{new:?}");
            assert_eq!(old.attribute("valueReference"), new.attribute("valueReference"));
            let start = a.attribute("start").map(|start| start.replace("true", "1").replace("false", "0"));
            assert_eq!(b.attribute("start"), start.as_deref(), "{new:?}");
        }
        let of = |name: &str| variables(&plain).into_iter().find(|(node, _)| text(*node, "name") == name).unwrap();
        let (enabled, behaviour) = (of("enabled"), of("behaviour"));
        assert_eq!(text(enabled.0, "description"), "Is it switched on? 0 = false, 1 = true.");
        assert_eq!([text(enabled.1, "min"), text(enabled.1, "max")], ["0", "1"]);
        assert_eq!(text(behaviour.0, "description"), "Behaviour of the specimen. 1 = Rest, 2 = Motion.");
        assert_eq!([text(behaviour.1, "min"), text(behaviour.1, "max")], ["1", "2"]);
        let root = plain.root_element();
        assert_eq!(root.attribute("modelName"), Some("Specimen (plain)"));
        assert_ne!(root.attribute("guid"), Some(SPECIMEN.guid()));
        assert_eq!(text(all(&plain, "CoSimulation")[0], "modelIdentifier"), "Specimen");
    }

    #[test]
    fn elements_are_in_the_order_of_the_schema() {
        on_every_description(|model, document| {
            let children: Vec<_> = document
                .root_element()
                .children()
                .filter(Node::is_element)
                .map(|node| node.tag_name().name())
                .collect();
            let schema = [
                "ModelExchange",
                "CoSimulation",
                "UnitDefinitions",
                "TypeDefinitions",
                "LogCategories",
                "DefaultExperiment",
                "ModelVariables",
                "ModelStructure",
            ];
            assert_eq!(children, schema[usize::from(!model.model_exchange)..]);
            assert_eq!(document.root_element().has_attribute("numberOfEventIndicators"), model.model_exchange);
        });
    }

    #[test]
    fn model_identifier_is_the_name_and_a_c_identifier() {
        on_every_description(|model, document| {
            for interface in all(document, "CoSimulation").into_iter().chain(all(document, "ModelExchange")) {
                let identifier = text(interface, "modelIdentifier");
                assert_eq!(identifier, model.name);
                assert!(identifier.starts_with(|first: char| first.is_ascii_alphabetic()), "{identifier}");
                assert!(
                    identifier.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_'),
                    "{identifier}"
                );
            }
        });
    }

    #[test]
    fn names_and_value_references_are_unique_and_in_the_order_of_the_columns() {
        on_every_description(|model, document| {
            let variables = variables(document);
            let types = all(document, "SimpleType");
            assert_unique(
                variables.iter().map(|(node, _)| *node).chain(types).map(|node| text(node, "name").to_owned()),
            );
            let columns = model.variables().map(|(_, variable)| variable.path.to_string());
            let states = model.continuous_states().filter(|_| model.model_exchange);
            let derivatives = states.map(|state| format!("der({})", model.table.at(state).path));
            let names: Vec<String> = columns.chain(["time".to_owned()]).chain(derivatives).collect();
            assert_eq!(variables.len(), names.len());
            assert_unique(variables.iter().map(|(node, _)| text(*node, "valueReference").to_owned()));
            for ((node, _), name) in variables.iter().zip(names) {
                assert_eq!(text(*node, "name"), name);
            }
        });
    }

    #[test]
    fn start_values_are_given_where_required_and_lie_within_their_limits() {
        on_every_description(|_, document| {
            for (node, declaration) in variables(document) {
                let initial = node.attribute("initial");
                let wants_start = text(node, "causality") == "input" || initial == Some("exact");
                assert_eq!(declaration.has_attribute("start"), wants_start, "{node:?}");
                let may_be_initial = !["input", "independent"].contains(&text(node, "causality"));
                assert_eq!(initial.is_some(), may_be_initial, "{node:?}");
                if declaration.has_tag_name("Boolean") {
                    continue;
                }
                let min = number_of(declaration, "min").unwrap_or(f64::NEG_INFINITY);
                let max = number_of(declaration, "max").unwrap_or(f64::INFINITY);
                let start = number_of(declaration, "start").unwrap_or(min.max(-1e300).min(max));
                assert!(min <= start && start <= max, "{node:?}");
                assert!(number_of(declaration, "nominal").is_none_or(|nominal| nominal > 0.0), "{node:?}");
            }
        });
    }

    #[test]
    fn only_real_variables_are_continuous() {
        on_every_description(|_, document| {
            for (node, declaration) in variables(document) {
                let is_continuous = text(node, "variability") == "continuous";
                assert!(declaration.has_tag_name("Real") || !is_continuous, "{node:?}");
            }
        });
    }

    #[test]
    fn units_and_types_are_defined_once_and_used() {
        on_every_description(|_, document| {
            let names = |element| all(document, element).into_iter().map(|node| text(node, "name"));
            assert_unique(names("Unit"));
            assert_unique(names("SimpleType"));
            let used =
                |attribute| variables(document).into_iter().filter_map(move |(_, node)| node.attribute(attribute));
            assert_eq!(names("Unit").collect::<BTreeSet<_>>(), used("unit").collect());
            assert_eq!(names("SimpleType").collect::<BTreeSet<_>>(), used("declaredType").collect());
            for (_, declaration) in variables(document) {
                let Some(shown) = declaration.attribute("displayUnit") else { continue };
                let units = all(document, "Unit");
                let unit = units.iter().find(|unit| text(**unit, "name") == text(declaration, "unit")).unwrap();
                let mut displays = unit.children().filter(|node| node.has_tag_name("DisplayUnit"));
                assert!(displays.any(|display| text(display, "name") == shown), "{shown}");
            }
        });
    }

    /// Indices of the entries of a list in the model structure.
    fn unknowns(document: &Document, list: &str) -> Vec<usize> {
        let list = all(document, list);
        let entries = list.iter().flat_map(|list| list.children()).filter(Node::is_element);
        entries.map(|node| text(node, "index").parse().unwrap()).collect()
    }

    #[test]
    fn model_structure_is_complete_and_ordered() {
        on_every_description(|_, document| {
            let variables = variables(document);
            let indices = |condition: &dyn Fn(Node) -> bool| -> Vec<usize> {
                (1..=variables.len()).filter(|index| condition(variables[index - 1].0)).collect()
            };
            let is_output = |node: Node| text(node, "causality") == "output";
            assert_eq!(unknowns(document, "Outputs"), indices(&is_output));
            let is_derivative = |node: Node| node.first_element_child().unwrap().has_attribute("derivative");
            assert_eq!(unknowns(document, "Derivatives"), indices(&is_derivative));
            let is_unknown = |node: Node| node.attribute("initial") == Some("calculated");
            assert_eq!(unknowns(document, "InitialUnknowns"), indices(&is_unknown));
        });
    }

    /// A derivative is that of a continuous state, in the state's unit per second.
    #[test]
    fn derivatives_are_those_of_continuous_states() {
        on_every_description(|_, document| {
            let variables = variables(document);
            for (_, declaration) in &variables {
                let Some(state) = number_of(*declaration, "derivative") else { continue };
                let (node, state) = variables[state as usize - 1];
                assert_eq!([text(node, "variability"), text(node, "initial")], ["continuous", "exact"], "{node:?}");
                let exponent = |declaration: Node, base: &str| {
                    let units = all(document, "BaseUnit");
                    let is_its = |unit: &&Node| {
                        unit.parent_element().unwrap().attribute("name") == declaration.attribute("unit")
                    };
                    number_of(*units.iter().find(is_its).unwrap(), base).unwrap_or(0.0)
                };
                assert_eq!(exponent(*declaration, "s"), exponent(state, "s") - 1.0, "{node:?}");
                assert!(
                    ["kg", "m", "A", "K", "rad"]
                        .iter()
                        .all(|base| exponent(*declaration, base) == exponent(state, base))
                );
            }
        });
    }

    #[test]
    fn dependencies_are_on_known_values() {
        on_every_description(|model, document| {
            let variables = variables(document);
            let states = variables.iter().filter_map(|(_, declaration)| number_of(*declaration, "derivative"));
            let states: BTreeSet<usize> = states.map(|index| index as usize).collect();
            for entry in all(document, "Unknown") {
                let is_initial = entry.parent_element().unwrap().has_tag_name("InitialUnknowns");
                let mut before = 0;
                let listed = entry.attribute("dependencies");
                // Dependencies are those of the catalogue's models.
                assert_eq!(listed.is_some(), *model != SPECIMEN, "{entry:?}");
                let indices: Vec<usize> =
                    listed.unwrap_or_default().split_whitespace().map(|index| index.parse().unwrap()).collect();
                let kinds = entry.attribute("dependenciesKind").unwrap_or_default();
                assert_eq!(kinds.split_whitespace().count(), indices.len());
                for index in indices {
                    let known = variables[index - 1].0;
                    let is_exact = is_initial && known.attribute("initial") == Some("exact");
                    let is_state = states.contains(&index);
                    assert!(text(known, "causality") == "input" || is_exact || is_state, "{entry:?}");
                    assert!(index > before, "{entry:?}");
                    before = index;
                }
            }
        });
    }

    #[test]
    fn default_experiment_makes_sense() {
        on_every_description(|_, document| {
            let experiment = all(document, "DefaultExperiment")[0];
            let value = |attribute| number_of(experiment, attribute).unwrap();
            assert!(value("startTime") < value("stopTime") && value("stepSize") > 0.0 && value("tolerance") > 0.0);
        });
    }

    #[test]
    fn every_kind_of_variable_is_written_as_the_standard_requires() {
        let text = model_description(&SPECIMEN, release_date(), Choices::Named).unwrap();
        for line in [
            "<Boolean start=\"true\"/>",
            "<Enumeration declaredType=\"Behaviour\" start=\"2\"/>",
            "<Integer min=\"0\" max=\"9\" start=\"3\"/>",
            "<Integer start=\"-7\"/>",
            "<Integer/>",
            "<Real declaredType=\"Ratio\" unit=\"1\" min=\"0\" max=\"1\" start=\"0.5\"/>",
            "<Real declaredType=\"Length\" unit=\"m\" displayUnit=\"um\" nominal=\"1e-5\" start=\"0\"/>",
            "name=\"element[2].stiffness\"",
        ] {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
    }

    #[test]
    fn texts_are_escaped() {
        let text = model_description(&SPECIMEN, release_date(), Choices::Named).unwrap();
        let document = Document::parse(&text).unwrap();
        assert_eq!(document.root_element().attribute("description"), Some(SPECIMEN.summary));
        let share = all(&document, "ScalarVariable")[0];
        assert_eq!(share.attribute("description"), Some("A value that is < 1 & > 0, \"quoted\"."));
        let item = all(&document, "Item")[1];
        assert_eq!(item.attribute("description"), Some("In motion, \"fast\" & furious."));
    }
}
