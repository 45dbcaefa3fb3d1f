//! The interface that hosts and programs rely on, as one list: the variables of every model as in its description, and
//! the declarations of the header. The committed list makes every change visible in review.

use anyhow::{Context, Result};
use roxmltree::{Document, Node};
use serde::{Deserialize, Serialize};
use stribeck::model::ModelType;

use crate::declarations::{self, Declaration};
use crate::project::VERSION;

/// The committed list.
pub const FILE: &str = "interface.csv";

/// The owner of the header's declarations.
pub const HEADER: &str = "stribeck.h";

/// Attributes of a description's root that hosts rely on. Those of `<ModelExchange>` and `<CoSimulation>` all count.
const ROOT_ATTRIBUTES: [&str; 3] = ["fmiVersion", "modelName", "variableNamingConvention"];

/// One line of the list. Properties that an item does not have are empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// A model or the header.
    pub owner: String,
    /// Kind of item: `variable`, `choice`, `preset`, `log category`, `attribute`, `function`, `type` or
    /// `constant`.
    pub item: String,
    /// Name of the item; for a choice, preceded by its type.
    pub name: String,
    /// Value reference of a variable, number of a choice, value of an attribute or a constant, text of a declaration.
    pub value: String,
    /// Type of a variable: that of FMI, or the name of an enumeration.
    #[serde(rename = "type")]
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

/// A list, and the version of the library that it was written for.
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
    /// The interface of models with these descriptions, and of this header.
    pub fn of(descriptions: &[(&ModelType, String)], header: &str) -> Result<Interface> {
        let mut rows = Vec::new();
        for (model, description) in descriptions {
            rows.extend(of_model(model, description)?);
        }
        rows.extend(declarations::of(header).iter().map(of_declaration));
        Ok(Interface { version: VERSION.into(), rows })
    }

    /// Reads a list.
    pub fn read(text: &str) -> Result<Interface> {
        let version = text.lines().next().and_then(|line| line.strip_prefix("# "));
        let version = version.with_context(|| format!("{FILE} does not begin with `# ` and a version"))?.to_owned();
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let rows = reader.deserialize().collect::<Result<_, _>>().with_context(|| format!("cannot read {FILE}"))?;
        Ok(Interface { version, rows })
    }

    /// The text of the list.
    pub fn text(&self) -> Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        self.rows.iter().try_for_each(|row| writer.serialize(row))?;
        Ok(format!("# {}\n{}", self.version, String::from_utf8(writer.into_inner()?)?))
    }
}

fn of_model(model: &ModelType, description: &str) -> Result<Vec<Row>> {
    let document = Document::parse(description)?;
    let row = |item: &str, name: &str, value: &str| Row::new(model.name, item, name, value);
    let all = |tag: &'static str| document.descendants().filter(move |node| node.has_tag_name(tag));
    let root = document.root_element();
    let mut rows: Vec<Row> = ROOT_ATTRIBUTES.iter().map(|name| row("attribute", name, attribute(root, name))).collect();
    for interface in all("ModelExchange").chain(all("CoSimulation")) {
        let name = |attribute: &str| format!("{}.{attribute}", interface.tag_name().name());
        rows.extend(interface.attributes().map(|found| row("attribute", &name(found.name()), found.value())));
    }
    rows.extend(all("Category").map(|category| row("log category", attribute(category, "name"), "")));
    rows.extend(model.presets.iter().map(|preset| row("preset", preset.name, "")));
    for item in all("Item") {
        let of_type = item.ancestors().find(|node| node.has_tag_name("SimpleType")).context("an item has no type")?;
        let name = format!("{}.{}", attribute(of_type, "name"), attribute(item, "name"));
        rows.push(row("choice", &name, attribute(item, "value")));
    }
    rows.extend(all("ScalarVariable").map(|node| of_variable(model, node)));
    Ok(rows)
}

fn of_variable(model: &ModelType, variable: Node) -> Row {
    let of_type = variable.first_element_child().unwrap_or(variable);
    let kind = match of_type.tag_name().name() {
        "Enumeration" => attribute(of_type, "declaredType"),
        kind => kind,
    };
    Row {
        kind: kind.into(),
        unit: attribute(of_type, "unit").into(),
        causality: attribute(variable, "causality").into(),
        variability: attribute(variable, "variability").into(),
        start: attribute(of_type, "start").into(),
        ..Row::new(model.name, "variable", attribute(variable, "name"), attribute(variable, "valueReference"))
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
    use crate::project::{release_date, root};
    use crate::specimen::SPECIMEN;
    use crate::xml::{Choices, model_description};
    use std::fs;
    use std::sync::LazyLock;
    use stribeck::catalogue;
    use stribeck::model::Kind;

    /// The interface of the committed descriptions and the committed header.
    pub static NOW: LazyLock<Interface> = LazyLock::new(|| {
        let read = |path: String| fs::read_to_string(root().join(path)).unwrap();
        let descriptions: Vec<_> =
            catalogue::models().map(|model| (model, read(format!("modelDescription/{}.xml", model.name)))).collect();
        Interface::of(&descriptions, &read("include/stribeck.h".into())).unwrap()
    });

    #[test]
    fn variables_are_those_of_the_tables() {
        for model in catalogue::models() {
            let of_model = |row: &&Row| row.owner == model.name && row.item == "variable";
            let rows: Vec<_> = NOW.rows.iter().filter(of_model).collect();
            let columns = || rows.iter().filter_map(|row| Some((row, model.find(&row.name)?)));
            for (row, column) in columns() {
                assert_eq!(row.value, model.reference(column).to_string(), "{row:?}");
                match model.table[column].kind {
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
        let rows = of_model(&SPECIMEN, &model_description(&SPECIMEN, release_date(), Choices::Named).unwrap()).unwrap();
        for expected in [
            row("choice", "Behaviour.Rest", "1"),
            row("choice", "Behaviour.Motion", "2"),
            row("attribute", "CoSimulation.modelIdentifier", "Specimen"),
            row("attribute", "fmiVersion", "2.0"),
        ] {
            assert!(rows.contains(&expected), "{expected:?}");
        }
        let presets: usize = catalogue::models().map(|model| model.presets.len()).sum();
        assert_eq!(NOW.rows.iter().filter(|row| row.item == "preset").count(), presets);
    }

    #[test]
    fn a_list_reads_back_as_it_was_written() {
        assert_eq!(Interface::read(&NOW.text().unwrap()).unwrap(), *NOW);
        assert!(Interface::read("owner,item\n").unwrap_err().to_string().contains("version"));
        assert!(Interface::read("# 0.1.0\nowner,item\nLuGre\n").is_err());
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
