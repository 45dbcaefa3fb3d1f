//! The interface that hosts and programs rely on, as one list: the variables of every model as in its description, and
//! the declarations of the header. The committed descriptions and header are those of the last commit.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use roxmltree::{Document, Node};

use crate::describe::declarations::{self, Declaration};

/// The committed header.
pub const HEADER_FILE: &str = "include/stribeck.h";

/// A version of FMI in which the models are described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

impl Version {
    /// All versions.
    pub const ALL: [Version; 2] = [Version::Two, Version::Three];

    /// The folder of the committed descriptions.
    pub fn folder(self) -> &'static str {
        match self {
            Version::Two => "modelDescription",
            Version::Three => "modelDescription/fmi3",
        }
    }

    /// The owner of what a description lists.
    pub fn owner(self, model: &str) -> String {
        match self {
            Version::Two => model.to_owned(),
            Version::Three => format!("{model} (FMI 3.0)"),
        }
    }
}

/// The owner of the header's declarations.
pub const HEADER: &str = "stribeck.h";

/// Attributes of a description's root that hosts rely on. Those of `<ModelExchange>` and `<CoSimulation>` all count.
const ROOT_ATTRIBUTES: [&str; 3] = ["fmiVersion", "modelName", "variableNamingConvention"];

/// One line of the list. Properties that an item does not have are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// A model, in a version of FMI, or the header.
    pub owner: String,
    /// Kind of item: `variable`, `choice`, `log category`, `attribute`, `function`, `type` or `constant`.
    pub item: String,
    /// Name of the item; for a choice, preceded by its type.
    pub name: String,
    /// Value reference of a variable, number of a choice, value of an attribute or a constant, text of a declaration.
    pub value: String,
    /// Type of a variable: that of FMI, or the name of an enumeration; of an array also its dimension.
    pub kind: String,
    /// Unit of a variable.
    pub unit: String,
    /// Causality of a variable.
    pub causality: String,
    /// Variability of a variable.
    pub variability: String,
    /// Start value of a variable.
    pub start: String,
}

/// A list, and the version of the library that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// Version.
    pub version: String,
    /// The lines.
    pub rows: Vec<Row>,
}

impl Row {
    fn new(owner: &str, item: &str, name: &str, value: &str) -> Row {
        Row { owner: owner.into(), item: item.into(), name: name.into(), value: value.into(), ..Row::default() }
    }
}

impl Interface {
    /// The interface of these owners with their descriptions, and of this header.
    pub fn of(descriptions: &[(String, String)], header: &str) -> Result<Interface> {
        let mut rows = Vec::new();
        for (model, description) in descriptions {
            rows.extend(of_model(model, description)?);
        }
        let declarations = declarations::of(header);
        let version = declarations.iter().find(|declaration| declaration.name == "STRIBECK_VERSION");
        let version = version.context("the header has no STRIBECK_VERSION")?.text.trim_matches('"').to_owned();
        rows.extend(declarations.iter().map(of_declaration));
        Ok(Interface { version, rows })
    }

    /// The interface of the committed files of a project.
    pub fn committed(root: &Path) -> Result<Interface> {
        let read = |file: &Path| fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()));
        let header = read(&root.join(HEADER_FILE))?;
        let mut descriptions = Vec::new();
        for version in Version::ALL {
            for file in committed_in(root, version)? {
                let model = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                descriptions.push((version.owner(&model), read(&root.join(&file))?));
            }
        }
        Interface::of(&descriptions, &header)
    }
}

/// The committed descriptions of a version, relative to the root; none if it has no folder yet.
pub fn committed_in(root: &Path, version: Version) -> Result<Vec<PathBuf>> {
    let folder = root.join(version.folder());
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let mut files = Vec::new();
    for entry in folder.read_dir().with_context(|| format!("cannot list {}", folder.display()))? {
        let name = PathBuf::from(entry?.file_name());
        files.extend(name.extension().is_some().then(|| Path::new(version.folder()).join(&name)));
    }
    files.sort();
    Ok(files)
}

fn of_model(model: &str, description: &str) -> Result<Vec<Row>> {
    let document = Document::parse(description).with_context(|| format!("description of {model}"))?;
    let row = |item: &str, name: &str, value: &str| Row::new(model, item, name, value);
    let all = |tag: &'static str| document.descendants().filter(move |node| node.has_tag_name(tag));
    let root = document.root_element();
    let mut rows: Vec<Row> = ROOT_ATTRIBUTES.iter().map(|name| row("attribute", name, attribute(root, name))).collect();
    for interface in all("ModelExchange").chain(all("CoSimulation")) {
        let name = |attribute: &str| format!("{}.{attribute}", interface.tag_name().name());
        rows.extend(interface.attributes().map(|found| row("attribute", &name(found.name()), found.value())));
    }
    rows.extend(all("Category").map(|category| row("log category", attribute(category, "name"), "")));
    for item in all("Item") {
        let is_type = |node: &Node| node.has_tag_name("SimpleType") || node.has_tag_name("EnumerationType");
        let of_type = item.ancestors().find(is_type).context("an item has no type")?;
        let name = format!("{}.{}", attribute(of_type, "name"), attribute(item, "name"));
        rows.push(row("choice", &name, attribute(item, "value")));
    }
    let variables = all("ModelVariables").flat_map(|list| list.children()).filter(Node::is_element);
    rows.extend(variables.map(|node| of_variable(model, node)));
    Ok(rows)
}

fn of_variable(model: &str, variable: Node) -> Row {
    let is_typed = variable.has_tag_name("ScalarVariable");
    let of_type = variable.first_element_child().filter(|_| is_typed).unwrap_or(variable);
    let kind = match of_type.tag_name().name() {
        "Enumeration" => attribute(of_type, "declaredType"),
        kind => kind,
    };
    // Importers ask an instance for the number of its event indicators: it may grow.
    let may_grow = attribute(variable, "name") == "event_indicators";
    let dimensions = variable.children().filter(|node| node.has_tag_name("Dimension") && !may_grow);
    let sizes = dimensions.flat_map(|dimension| dimension.attributes()).map(|size| format!("[{}]", size.value()));
    Row {
        kind: format!("{kind}{}", sizes.collect::<String>()),
        unit: attribute(of_type, "unit").into(),
        causality: attribute(variable, "causality").into(),
        variability: attribute(variable, "variability").into(),
        start: attribute(of_type, "start").into(),
        ..Row::new(model, "variable", attribute(variable, "name"), attribute(variable, "valueReference"))
    }
}

/// The value of an attribute; empty if there is none.
fn attribute<'a>(node: Node<'a, '_>, name: &str) -> &'a str {
    node.attribute(name).unwrap_or_default()
}

/// Guids and the version are meant to change.
fn of_declaration(declaration: &Declaration) -> Row {
    let Declaration { kind, name, text } = declaration;
    let is_there_to_change = name.ends_with("_GUID") || name == "STRIBECK_VERSION";
    Row::new(HEADER, kind.name(), name, if is_there_to_change { "" } else { text })
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::describe::fmi2::{Choices, model_description};
    use crate::project::{release_date, root};
    use crate::specimen::SPECIMEN;
    use std::sync::LazyLock;
    use stribeck::catalogue;
    use stribeck::model::Kind;

    /// The interface of the committed descriptions and the committed header.
    pub static NOW: LazyLock<Interface> = LazyLock::new(|| Interface::committed(root()).unwrap());

    #[test]
    fn variables_are_those_of_the_tables() {
        for model in catalogue::models() {
            let of_model = |row: &&Row| row.owner == model.name && row.item == "variable";
            let rows: Vec<_> = NOW.rows.iter().filter(of_model).collect();
            let columns = || rows.iter().filter_map(|row| Some((row, model.find(&row.name)?)));
            for (row, column) in columns() {
                assert_eq!(row.value, model.reference(column).to_string(), "{row:?}");
                match model.table.at(column).kind {
                    Kind::Real(unit) => assert_eq!((row.kind.as_str(), row.unit.as_str()), ("Real", unit.name)),
                    Kind::Integer => assert_eq!(row.kind, "Integer"),
                    Kind::Boolean => assert_eq!(row.kind, "Boolean"),
                    Kind::Enumeration(choices) => assert_eq!(row.kind, choices.name),
                }
            }
            let columns = columns().count();
            assert_eq!(columns, model.variables().count(), "{}", model.name);
            assert_eq!(
                rows.len(),
                columns + 1 + if model.model_exchange { model.continuous_states().count() } else { 0 }
            );
        }
    }

    #[test]
    fn constants_of_the_header_are_the_value_references() {
        let value = |name: &str| {
            let row = NOW.rows.iter().find(|row| row.owner == HEADER && row.item == "constant" && row.name == name);
            row.unwrap_or_else(|| panic!("no constant {name}")).value.clone()
        };
        let reference = |name: &str| {
            let row = NOW.rows.iter().find(|row| row.owner == "LuGre" && row.item == "variable" && row.name == name);
            row.unwrap_or_else(|| panic!("no variable {name}")).value.clone()
        };
        for variable in stribeck::catalogue::by_name("LuGre").unwrap().table {
            let name = variable.path.to_string();
            assert_eq!(value(&format!("STRIBECK_LUGRE_{}", name.to_uppercase())), reference(&name));
        }
        assert_eq!((value("STRIBECK_LUGRE_GUID").as_str(), value("fmi2Pending").as_str()), ("", "5"));
    }

    #[test]
    fn choices_presets_and_attributes_are_listed() {
        let row = |item: &str, name: &str, value: &str| Row::new("Specimen", item, name, value);
        let rows =
            of_model(SPECIMEN.name, &model_description(&SPECIMEN, release_date(), Choices::Named).unwrap()).unwrap();
        for expected in [
            row("choice", "Behaviour.Rest", "1"),
            row("choice", "Behaviour.Motion", "2"),
            row("attribute", "CoSimulation.modelIdentifier", "Specimen"),
            row("attribute", "fmiVersion", "2.0"),
        ] {
            assert!(rows.contains(&expected), "{expected:?}");
        }
        let presets: usize = catalogue::models().map(|model| model.presets.len()).sum();
        let is_preset = |row: &&Row| row.item == "constant" && row.name.contains("_PRESET_");
        assert_eq!(NOW.rows.iter().filter(is_preset).count(), presets);
    }

    /// With the length of an array, or the reference of its size: a host relies on both.
    #[test]
    fn descriptions_of_fmi_3_are_listed_too() {
        let row = |item: &str, name: &str| {
            let is_it = |row: &&Row| row.owner == "ShockAbsorber (FMI 3.0)" && row.item == item && row.name == name;
            NOW.rows.iter().find(is_it).unwrap_or_else(|| panic!("no {item} {name}"))
        };
        let size = row("variable", "damper.tab_size");
        assert_eq!(
            (size.kind.as_str(), size.causality.as_str(), size.start.as_str()),
            ("UInt64", "structuralParameter", "16")
        );
        let table = row("variable", "damper.tab_v");
        assert_eq!(table.kind, format!("Float64[{}]", size.value));
        assert_eq!(table.start.split(' ').count(), 16);
        assert_eq!(row("variable", "event_indicators").kind, "Float64", "their number may grow");
        assert_eq!(row("attribute", "fmiVersion").value, "3.0");
        assert_eq!(row("attribute", "CoSimulation.hasEventMode").value, "true");
        let choices = NOW.rows.iter().filter(|row| row.item == "choice");
        let of = |owner: &str| choices.clone().filter(|row| row.owner == owner).count();
        assert!(of("ShockAbsorber") > 0);
        assert_eq!(of("ShockAbsorber"), of("ShockAbsorber (FMI 3.0)"));
    }

    #[test]
    fn the_version_is_that_of_the_header() {
        assert_eq!(NOW.version, crate::project::VERSION);
        assert!(Interface::of(&[], "int call(void);").unwrap_err().to_string().contains("STRIBECK_VERSION"));
    }

    #[test]
    fn no_item_is_listed_twice() {
        let mut keys: Vec<_> = NOW.rows.iter().map(|row| (&row.owner, &row.item, &row.name)).collect();
        keys.sort();
        for pair in keys.windows(2) {
            assert_ne!(pair[0], pair[1]);
        }
    }
}
