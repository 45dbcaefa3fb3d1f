//! modelDescription.xml of FMI 3.0.2, written from a model's table. Variables that differ by an index are one array.

use std::collections::BTreeMap;
use std::io;

use anyhow::{Context, Result};
use jiff::Timestamp;
use stribeck::arrays::{self, Array, Size};
use stribeck::model::{Kind, ModelType, Variable};
use stribeck::reference::{self, Reference};

use crate::describe::description::{
    CALCULATED, INDEPENDENT, causality, default_experiment, derivative_of, enumerations, interface, items,
    log_categories, real_type, root_attributes, root_attributes_of_sources, second, start, unit_definitions,
    unit_of_rate, units, value_attributes, variable_attributes,
};
use crate::describe::only_law::{self, OnlyLaw};
use crate::describe::structure::{Structure, integrated};
use crate::describe::xml::{Attributes, Xml, document, leaf, parent};

/// Version of FMI.
pub const VERSION: &str = "3.0";

/// The attribute with the guid.
const TOKEN: &str = "instantiationToken";

/// Capabilities declared in `<ModelExchange>`.
pub fn exchange_capabilities(model: &ModelType) -> [(&'static str, &'static str); 8] {
    [
        ("needsExecutionTool", "false"),
        ("canBeInstantiatedOnlyOncePerProcess", "false"),
        ("canGetAndSetFMUState", "true"),
        ("canSerializeFMUState", "true"),
        ("providesDirectionalDerivatives", "true"),
        ("providesAdjointDerivatives", "true"),
        // Where no result jumps, a completed step asks for no event.
        ("needsCompletedIntegratorStep", truth(has_jumping_results(model))),
        ("providesEvaluateDiscreteStates", "false"),
    ]
}

/// Capabilities declared in `<CoSimulation>`.
pub fn capabilities(model: &ModelType) -> [(&'static str, &'static str); 13] {
    [
        ("needsExecutionTool", "false"),
        ("canBeInstantiatedOnlyOncePerProcess", "false"),
        ("canGetAndSetFMUState", "true"),
        ("canSerializeFMUState", "true"),
        ("providesDirectionalDerivatives", "true"),
        ("providesAdjointDerivatives", "true"),
        ("canHandleVariableCommunicationStepSize", "true"),
        ("maxOutputDerivativeOrder", "1"),
        ("providesIntermediateUpdate", "true"),
        ("mightReturnEarlyFromDoStep", truth(has_jumping_results(model) || model.event_indicators > 0)),
        ("canReturnEarlyAfterIntermediateUpdate", "true"),
        ("hasEventMode", "true"),
        ("providesEvaluateDiscreteStates", "false"),
    ]
}

fn truth(value: bool) -> &'static str {
    if value { "true" } else { "false" }
}

/// Whether a result, such as `sticking`, changes at events only.
fn has_jumping_results(model: &ModelType) -> bool {
    model.table.iter().any(|variable| variable.role.is_computed() && variable.jumps)
}

/// Those of C sources, which have no events and show nothing within a step.
fn capabilities_of_sources(model: &ModelType) -> [(&'static str, &'static str); 13] {
    let without = [
        "providesIntermediateUpdate",
        "mightReturnEarlyFromDoStep",
        "canReturnEarlyAfterIntermediateUpdate",
        "hasEventMode",
    ];
    capabilities(model).map(|(name, value)| (name, if without.contains(&name) { "false" } else { value }))
}

/// The text of modelDescription.xml.
pub fn model_description(model: &ModelType, date: Timestamp) -> Result<String> {
    describe(model, root_attributes(model, date, VERSION, TOKEN), Form::Library)
}

/// The same for an FMU with C sources in place of libraries, for co-simulation, with one law if the model has a choice.
pub fn source_description(model: &ModelType, date: Timestamp, law: Option<OnlyLaw>) -> Result<String> {
    describe(model, root_attributes_of_sources(model, date, VERSION, TOKEN, law), Form::Sources(law))
}

/// The text of sources/buildDescription.xml, for sources in these files.
pub fn build_description(model: &ModelType, files: &[&str]) -> Result<String> {
    let attributes = vec![("fmiVersion", VERSION.to_owned())];
    document("fmiBuildDescription", attributes, |xml| {
        let configuration = vec![("modelIdentifier", model.name.to_owned())];
        parent(xml, "BuildConfiguration", configuration, |xml| {
            parent(xml, "SourceFileSet", vec![("language", "C99".to_owned())], |xml| {
                files.iter().try_for_each(|file| leaf(xml, "SourceFile", vec![("name", (*file).to_owned())]))
            })
        })
    })
}

/// Contents of an FMU: libraries, or C sources, which have one law if the model has a choice.
#[derive(Clone, Copy)]
enum Form {
    Library,
    Sources(Option<OnlyLaw>),
}

impl Form {
    fn is_library(self) -> bool {
        matches!(self, Form::Library)
    }

    fn law(self) -> Option<OnlyLaw> {
        if let Form::Sources(law) = self { law } else { None }
    }
}

fn describe(model: &ModelType, attributes: Attributes, form: Form) -> Result<String> {
    let variables = Variables::of(model, form)?;
    document("fmiModelDescription", attributes, |xml| {
        if model.model_exchange && form.is_library() {
            interface(xml, "ModelExchange", model, &exchange_capabilities(model))?;
        }
        let capabilities = if form.is_library() { capabilities(model) } else { capabilities_of_sources(model) };
        interface(xml, "CoSimulation", model, &capabilities)?;
        unit_definitions(xml, model)?;
        type_definitions(xml, model, form.law())?;
        log_categories(xml)?;
        default_experiment(xml)?;
        parent(xml, "ModelVariables", vec![], |xml| variables.write(xml))?;
        parent(xml, "ModelStructure", vec![], |xml| variables.write_structure(xml))
    })
}

fn type_definitions(xml: &mut Xml, model: &ModelType, law: Option<OnlyLaw>) -> io::Result<()> {
    parent(xml, "TypeDefinitions", vec![], |xml| {
        for unit in units(model).values() {
            let quantity = unit.quantity;
            let attributes = vec![("name", quantity.into()), ("quantity", quantity.into()), ("unit", unit.name.into())];
            leaf(xml, "Float64Type", attributes)?;
        }
        for enumeration in enumerations(model).values() {
            let attributes = vec![("name", enumeration.name.into())];
            parent(xml, "EnumerationType", attributes, |xml| items(xml, enumeration, law))?;
        }
        Ok(())
    })
}

/// The name of a variable's element, and the attributes of its type.
fn element_of(kind: Kind) -> (&'static str, Attributes) {
    match kind {
        Kind::Real(unit) => ("Float64", real_type(unit)),
        Kind::Integer => ("Int32", vec![]),
        Kind::Boolean => ("Boolean", vec![]),
        Kind::Enumeration(items) => ("Enumeration", vec![("declaredType", items.name.into())]),
    }
}

/// Outputs that are continuous may be read within a step of co-simulation.
fn is_for_intermediate_update(variable: &Variable) -> bool {
    variable.role.is_output() && causality(variable)[1] == "continuous"
}

/// A number of elements in one direction.
fn dimension(array: &Array) -> (&'static str, String) {
    match array.size {
        Some(size) => ("valueReference", size.reference().to_string()),
        None => ("start", array.columns.len().to_string()),
    }
}

/// An element of `<ModelVariables>`, with its dimension if it is an array.
fn element(
    xml: &mut Xml,
    name: &'static str,
    attributes: Attributes,
    dimension: Option<(&'static str, String)>,
) -> io::Result<()> {
    let Some(dimension) = dimension else { return leaf(xml, name, attributes) };
    parent(xml, name, attributes, |xml| leaf(xml, "Dimension", vec![dimension]))
}

/// The variables of a description.
struct Variables<'a> {
    model: &'a ModelType,
    form: Form,
    arrays: Box<[Array]>,
    /// Places of the arrays by their columns.
    owners: BTreeMap<usize, usize>,
}

impl Variables<'_> {
    fn of(model: &ModelType, form: Form) -> Result<Variables<'_>> {
        let arrays = arrays::of(model).ok().context("out of memory")?;
        let owned = |(at, array): (usize, &Array)| array.columns.iter().map(move |column| (*column, at)).collect();
        let owners: Vec<Vec<(usize, usize)>> = arrays.iter().enumerate().map(owned).collect();
        Ok(Variables { model, form, owners: owners.into_iter().flatten().collect(), arrays })
    }

    /// The array of a column.
    fn array(&self, column: usize) -> Option<&Array> {
        self.owners.get(&column).map(|at| &self.arrays[*at])
    }

    /// Whether a column is a variable by itself, or the first element of one.
    fn is_first(&self, column: usize) -> bool {
        self.array(column).is_none_or(|array| array.columns[0] == column)
    }

    /// Value reference of a column or, behind the columns and time, of the derivative of a state.
    fn reference(&self, place: usize) -> Reference {
        let columns = self.model.table.len();
        if place < columns {
            return self.array(place).map_or_else(|| self.model.reference(place), Array::reference);
        }
        let state = integrated(self.model)[place - columns - 1];
        let of_state = || reference::of_derivative(&self.model.table.at(state).path);
        self.array(state).map_or_else(of_state, Array::derivative_reference)
    }

    fn write(&self, xml: &mut Xml) -> io::Result<()> {
        for (column, variable) in self.model.variables().filter(|(column, _)| self.is_first(*column)) {
            self.write_size(xml, column)?;
            self.write_variable(xml, column, &variable)?;
        }
        let mut time = variable_attributes("time".into(), reference::TIME, "Time.", INDEPENDENT);
        time.extend(real_type(second()));
        leaf(xml, "Float64", time)?;
        let states = integrated(self.model).into_iter().filter(|state| self.is_first(*state));
        states.into_iter().try_for_each(|state| self.write_derivative(xml, state))?;
        self.write_event_indicators(xml)
    }

    /// The size of the array that begins at a column, unless an array before it has the same.
    fn write_size(&self, xml: &mut Xml, column: usize) -> io::Result<()> {
        let Some(size) = self.array(column).and_then(|array| array.size) else { return Ok(()) };
        let sized: Vec<&Array> = self.arrays.iter().filter(|array| array.size == Some(size)).collect();
        if sized[0].columns[0] == column { leaf(xml, "UInt64", self.size_attributes(&size, &sized)) } else { Ok(()) }
    }

    fn size_attributes(&self, size: &Size, sized: &[&Array]) -> Attributes {
        let names: Vec<String> = sized.iter().map(|array| array.path.to_string()).collect();
        let in_use = self.model.table.at(size.in_use).path;
        let help = format!("Number of elements of {}; at least {in_use}.", names.join(", "));
        let causality = ["structuralParameter", "fixed", "exact"];
        let mut attributes = variable_attributes(size.to_string(), size.reference(), &help, causality);
        let most = size.most.to_string();
        attributes.extend([("min", "1".into()), ("max", most.clone()), ("start", most)]);
        attributes
    }

    fn write_variable(&self, xml: &mut Xml, column: usize, variable: &Variable) -> io::Result<()> {
        let array = self.array(column);
        let name = array.map_or(variable.path, |array| array.path).to_string();
        let columns = array.map_or_else(|| vec![column], |array| array.columns.to_vec());
        let begun = |column: usize| only_law::begun(self.form.law(), column, self.model.table.at(column));
        let starts: Vec<String> = columns.iter().map(|column| start(&begun(*column))).collect();
        let (tag, type_attributes) = element_of(variable.kind);
        let mut attributes = variable_attributes(name, self.reference(column), variable.help, causality(variable));
        if is_for_intermediate_update(variable) && self.form.is_library() {
            attributes.push(("intermediateUpdate", "true".into()));
        }
        attributes.extend(type_attributes);
        attributes.extend(value_attributes(self.model, variable, tag == "Float64", &starts.join(" ")));
        element(xml, tag, attributes, array.map(dimension))
    }

    /// The variable that is the time derivative of a state, or of the states of an array.
    fn write_derivative(&self, xml: &mut Xml, state: usize) -> io::Result<()> {
        let (array, variable) = (self.array(state), self.model.table.at(state));
        let path = array.map_or(variable.path, |array| array.path);
        let (name, help) = derivative_of(&path);
        let mut attributes = variable_attributes(name, reference::of_derivative(&path), &help, CALCULATED);
        attributes.extend(unit_of_rate(&variable).map(real_type).unwrap_or_default());
        attributes.push(("derivative", self.reference(state).to_string()));
        element(xml, "Float64", attributes, array.map(dimension))
    }

    fn event_indicators(&self) -> usize {
        if self.model.model_exchange && self.form.is_library() { self.model.event_indicators } else { 0 }
    }

    fn write_event_indicators(&self, xml: &mut Xml) -> io::Result<()> {
        let count = self.event_indicators();
        if count == 0 {
            return Ok(());
        }
        let help = "Functions of the variables that change sign at events.";
        let name = "event_indicators".to_owned();
        let attributes = variable_attributes(name, reference::EVENT_INDICATORS, help, CALCULATED);
        element(xml, "Float64", attributes, Some(("start", count.to_string())))
    }

    fn write_structure(&self, xml: &mut Xml) -> io::Result<()> {
        let structure = Structure::of(self.model);
        self.write_unknowns(xml, "Output", &structure.outputs(), |place| structure.at_any_time(place))?;
        let derivatives = structure.derivatives();
        self.write_unknowns(xml, "ContinuousStateDerivative", &derivatives, |place| structure.at_any_time(place))?;
        self.write_unknowns(xml, "InitialUnknown", &structure.initial(), |place| structure.initially(place))?;
        if self.event_indicators() > 0 {
            let reference = reference::EVENT_INDICATORS.to_string();
            leaf(xml, "EventIndicator", vec![("valueReference", reference)])?;
        }
        Ok(())
    }

    /// Unknowns in the order of their first elements. An array depends on what any of its elements depends on.
    fn write_unknowns<Places: IntoIterator<Item = usize>>(
        &self,
        xml: &mut Xml,
        element: &'static str,
        unknowns: &[usize],
        dependencies: impl Fn(usize) -> Option<Places>,
    ) -> io::Result<()> {
        for reference in self.references(unknowns) {
            let elements = unknowns.iter().filter(|place| self.reference(**place) == reference);
            let known: Option<Vec<Places>> = elements.map(|place| dependencies(*place)).collect();
            let mut attributes = vec![("valueReference", reference.to_string())];
            if let Some(known) = known {
                let mut places: Vec<usize> = known.into_iter().flatten().collect();
                places.sort_unstable();
                let references: Vec<String> = self.references(&places).iter().map(Reference::to_string).collect();
                attributes.push(("dependencies", references.join(" ")));
            }
            leaf(xml, element, attributes)?;
        }
        Ok(())
    }

    /// References of the places, each once, in their order.
    fn references(&self, places: &[usize]) -> Vec<Reference> {
        let mut references = Vec::new();
        for reference in places.iter().map(|place| self.reference(*place)) {
            if !references.contains(&reference) {
                references.push(reference);
            }
        }
        references
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::fmi2::{self, Choices};
    use crate::project::release_date;
    use crate::specimen::SPECIMEN;
    use roxmltree::{Document, Node};
    use std::collections::BTreeSet;
    use std::sync::LazyLock;
    use stribeck::catalogue;

    /// Runs a test on the descriptions of every model, in FMI 3.0 and 2.0.
    fn on_every_description(test: impl Fn(&ModelType, &Document, &Document)) {
        static TEXTS: LazyLock<Vec<(&ModelType, String, String)>> = LazyLock::new(|| {
            let texts = |model| {
                let date = release_date();
                let old = fmi2::model_description(model, date, Choices::Named).unwrap();
                (model, model_description(model, date).unwrap(), old)
            };
            catalogue::models().chain([&SPECIMEN]).map(texts).collect()
        });
        for (model, new, old) in TEXTS.iter() {
            test(model, &Document::parse(new).unwrap(), &Document::parse(old).unwrap());
        }
    }

    fn children<'a>(document: &'a Document, list: &str) -> Vec<Node<'a, 'a>> {
        let list = document.descendants().find(|node| node.has_tag_name(list)).unwrap();
        list.children().filter(Node::is_element).collect()
    }

    fn text<'a>(node: Node<'a, '_>, attribute: &str) -> &'a str {
        node.attribute(attribute).unwrap_or_else(|| panic!("{node:?} without {attribute}"))
    }

    fn by_reference<'a>(document: &'a Document, reference: &str) -> Node<'a, 'a> {
        let mut variables = children(document, "ModelVariables").into_iter();
        variables.find(|node| text(*node, "valueReference") == reference).unwrap_or_else(|| panic!("no {reference}"))
    }

    /// The number of elements of an array; none of a scalar.
    fn length(document: &Document, variable: Node) -> Option<usize> {
        let dimension = variable.first_element_child()?;
        let size = dimension.attribute("start").map(str::to_owned);
        let of_parameter = || {
            let size = by_reference(document, text(dimension, "valueReference"));
            assert_eq!((size.tag_name().name(), text(size, "causality")), ("UInt64", "structuralParameter"));
            assert_eq!(size.attribute("start"), size.attribute("max"));
            text(size, "start").to_owned()
        };
        Some(size.unwrap_or_else(of_parameter).parse().unwrap())
    }

    /// The names that an array has in FMI 2.0, where each element is a variable.
    fn names_of_elements(model: &ModelType, name: &str, length: usize) -> Vec<String> {
        let (before, inner, after) = match name.strip_prefix("der(").and_then(|rest| rest.strip_suffix(')')) {
            Some(inner) => ("der(", inner, ")"),
            None => ("", name, ""),
        };
        let arrays = arrays::of(model).unwrap();
        let array = arrays.iter().find(|array| array.path.to_string() == inner).unwrap();
        assert_eq!(array.columns.len(), length);
        array.columns.iter().map(|column| format!("{before}{}{after}", model.table.at(*column).path)).collect()
    }

    #[test]
    fn variables_are_those_of_fmi_2_with_the_same_references() {
        on_every_description(|model, new, old| {
            let mut left: BTreeMap<&str, Node> =
                children(old, "ModelVariables").into_iter().map(|node| (text(node, "name"), node)).collect();
            for variable in children(new, "ModelVariables") {
                let name = text(variable, "name");
                match length(new, variable) {
                    Some(length) if name == "event_indicators" => assert_eq!(length, model.event_indicators),
                    Some(length) => {
                        for (name, start) in names_of_elements(model, name, length).iter().zip(starts(variable)) {
                            let scalar = left.remove(name.as_str()).unwrap_or_else(|| panic!("no {name}"));
                            assert_eq!(scalar.first_element_child().unwrap().attribute("start"), start, "{name}");
                        }
                    }
                    None if text(variable, "causality") == "structuralParameter" => {}
                    None => {
                        let scalar = left.remove(name).unwrap_or_else(|| panic!("no {name}"));
                        for attribute in ["valueReference", "description", "causality", "variability", "initial"] {
                            assert_eq!(variable.attribute(attribute), scalar.attribute(attribute), "{name}");
                        }
                        let declared = scalar.first_element_child().unwrap();
                        for attribute in ["start", "min", "max", "unit", "displayUnit", "nominal", "reinit"] {
                            assert_eq!(variable.attribute(attribute), declared.attribute(attribute), "{name}");
                        }
                    }
                }
            }
            assert!(left.is_empty(), "{}: {left:?}", model.name);
        });
    }

    /// Start values of the elements of an array.
    fn starts<'a>(variable: Node<'a, '_>) -> impl Iterator<Item = Option<&'a str>> {
        let words: Vec<&str> = variable.attribute("start").unwrap_or_default().split(' ').collect();
        let none = words == [""];
        words.into_iter().cycle().map(move |word| Some(word).filter(|_| !none))
    }

    #[test]
    fn arrays_have_as_many_start_values_as_elements() {
        on_every_description(|_, new, _| {
            for variable in children(new, "ModelVariables") {
                let (length, start) = (length(new, variable), variable.attribute("start"));
                assert_eq!(start.map_or(length.unwrap_or(1), |list| list.split(' ').count()), length.unwrap_or(1));
            }
        });
    }

    #[test]
    fn names_and_references_are_unique() {
        on_every_description(|_, new, _| {
            let variables = children(new, "ModelVariables");
            for attribute in ["name", "valueReference"] {
                let different: BTreeSet<&str> = variables.iter().map(|node| text(*node, attribute)).collect();
                assert_eq!(different.len(), variables.len(), "{attribute}");
            }
        });
    }

    /// An importer's vector of states is that of FMI 2.0, where arrays stand side by side.
    #[test]
    fn states_are_in_the_order_of_their_derivatives() {
        on_every_description(|model, new, _| {
            let structure = children(new, "ModelStructure");
            let derivatives = structure.iter().filter(|node| node.has_tag_name("ContinuousStateDerivative"));
            let mut states = Vec::new();
            for entry in derivatives {
                let derivative = by_reference(new, text(*entry, "valueReference"));
                let state = by_reference(new, text(derivative, "derivative"));
                assert_eq!(length(new, derivative), length(new, state));
                let name = text(state, "name").to_owned();
                states.extend(match length(new, state) {
                    Some(length) => names_of_elements(model, &name, length),
                    None => vec![name],
                });
            }
            let expected = integrated(model).into_iter().map(|state| model.table.at(state).path.to_string());
            assert_eq!(states, expected.collect::<Vec<_>>(), "{}", model.name);
        });
    }

    #[test]
    fn model_structure_is_complete() {
        on_every_description(|model, new, _| {
            let listed = |tag: &str| -> Vec<&str> {
                let entries = children(new, "ModelStructure").into_iter().filter(|node| node.has_tag_name(tag));
                entries.map(|node| text(node, "valueReference")).collect()
            };
            let of = |condition: &dyn Fn(Node) -> bool| -> Vec<&str> {
                let variables = children(new, "ModelVariables").into_iter().filter(|node| condition(*node));
                variables.map(|node| text(node, "valueReference")).collect()
            };
            let indicators = reference::EVENT_INDICATORS.to_string();
            assert_eq!(listed("Output"), of(&|node| text(node, "causality") == "output"));
            assert_eq!(listed("ContinuousStateDerivative"), of(&|node| node.has_attribute("derivative")));
            let is_unknown = |node: Node| {
                node.attribute("initial") == Some("calculated") && text(node, "valueReference") != indicators
            };
            assert_eq!(listed("InitialUnknown"), of(&is_unknown));
            let has_indicators = model.model_exchange && model.event_indicators > 0;
            assert_eq!(listed("EventIndicator"), if has_indicators { vec![indicators.as_str()] } else { vec![] });
        });
    }

    /// In FMI 3.0 also parameters and discrete states are known.
    #[test]
    fn dependencies_are_on_known_values() {
        on_every_description(|model, new, _| {
            for entry in children(new, "ModelStructure") {
                let listed = entry.attribute("dependencies");
                let is_found = *model != SPECIMEN && !entry.has_tag_name("EventIndicator");
                assert_eq!(listed.is_some(), is_found, "{entry:?}");
                for reference in listed.unwrap_or_default().split_whitespace() {
                    let known = by_reference(new, reference);
                    let is_exact = known.attribute("initial") == Some("exact");
                    assert!(text(known, "causality") == "input" || is_exact, "{entry:?}: {known:?}");
                }
            }
        });
    }

    #[test]
    fn every_kind_of_variable_is_written_as_the_standard_requires() {
        let text = model_description(&SPECIMEN, release_date()).unwrap();
        for line in [
            "variability=\"discrete\" start=\"true\"/>",
            "initial=\"exact\" declaredType=\"Behaviour\" start=\"2\"/>",
            "initial=\"exact\" min=\"0\" max=\"9\" start=\"3\"/>",
            "initial=\"exact\" declaredType=\"Length\" unit=\"m\" displayUnit=\"um\" nominal=\"1e-5\" start=\"0 0\">",
            "<Float64 name=\"element.stiffness\"",
            "<Dimension start=\"2\"/>",
            "<EnumerationType name=\"Behaviour\">",
            "<Float64Type name=\"Length\" quantity=\"Length\" unit=\"m\"/>",
        ] {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
    }

    /// `sticking` jumps in a law; the rig has no result that jumps.
    #[test]
    fn only_models_with_events_return_early() {
        let of = |name: &str| catalogue::by_name(name).unwrap();
        assert!(capabilities(of("LuGre")).contains(&("mightReturnEarlyFromDoStep", "true")));
        assert!(capabilities(of("BeltRig")).contains(&("mightReturnEarlyFromDoStep", "false")));
        assert!(exchange_capabilities(of("BeltRig")).contains(&("needsCompletedIntegratorStep", "false")));
    }

    /// Otherwise their description is that of the FMU with a library.
    #[test]
    fn sources_declare_neither_events_nor_what_needs_them() {
        on_every_description(|model, new, _| {
            let text = source_description(model, release_date(), None).unwrap();
            let sources = Document::parse(&text).unwrap();
            assert!(!text.contains("<ModelExchange") && !text.contains("ntermediateUpdate=\"true\""), "{}", model.name);
            let interface = sources.descendants().find(|node| node.has_tag_name("CoSimulation")).unwrap();
            for (name, value) in capabilities(model) {
                let is_less =
                    name.contains("arly") || name.contains("EventMode") || name.contains("IntermediateUpdate");
                assert_eq!(interface.attribute(name), Some(if is_less { "false" } else { value }), "{name}");
            }
            let names = |document: &Document| -> Vec<String> {
                let variables = children(document, "ModelVariables").into_iter();
                let names = variables.map(|node| node.attribute("name").unwrap_or_default().to_owned());
                names.filter(|name| name != "event_indicators").collect()
            };
            assert_eq!(names(&sources), names(new));
        });
    }

    #[test]
    fn the_build_description_lists_the_files() {
        let text = build_description(&SPECIMEN, &["a.c", "b.c"]).unwrap();
        let document = Document::parse(&text).unwrap();
        let files: Vec<_> = document.descendants().filter(|node| node.has_tag_name("SourceFile")).collect();
        assert_eq!(files.iter().map(|node| node.attribute("name").unwrap()).collect::<Vec<_>>(), ["a.c", "b.c"]);
        let configuration = files[0].ancestors().nth(2).unwrap();
        assert_eq!(configuration.attribute("modelIdentifier"), Some(SPECIMEN.name));
    }
}
