//! documentation/index.html of an FMU: the model's own page, its diagrams, and tables of its variables, presets and
//! capabilities.
//!
//! The page is self-contained: no script, no network, and colours that follow the reader's choice of light or dark.

use std::collections::BTreeSet;

use anyhow::Result;
use stribeck::catalogue::Family;
use stribeck::model::{Kind, ModelType, Preset, Variable};
use stribeck_draw::text::{escape, typeset_unit};

use crate::describe::entry::Entry;
use crate::describe::interface::Version;
use crate::describe::text;
use crate::describe::{fmi2, fmi3};
use crate::page::diagrams;
use crate::page::typeset;
use crate::project::{AUTHORS, LICENSE, VERSION};

const STYLE: &str = include_str!("style.css");

const ROLES: &str = "Inputs are set before each step. A fixed parameter stays constant during a run, a tunable one may \
    change between steps. States are advanced by the steps; their start values may be set before a run.";

/// The diagrams of a page, as HTML: those of the model, and those of each preset.
#[derive(Default)]
struct Pictures {
    model: String,
    presets: Vec<String>,
}

/// The page of a model, for all versions of FMI.
pub struct Page {
    model: &'static ModelType,
    documentation: &'static str,
    pictures: Pictures,
}

impl Page {
    /// The page of a model, with its diagrams.
    pub fn of(entry: &Entry) -> Result<Page> {
        let Entry { model, documentation, .. } = *entry;
        Ok(Page { model, documentation, pictures: pictures(entry)? })
    }

    /// The text in an FMU of this version.
    pub fn text(&self, version: Version) -> Result<String> {
        document(self.model, self.documentation, &self.pictures, version)
    }
}

fn pictures(entry: &Entry) -> Result<Pictures> {
    let Entry { model, family, .. } = *entry;
    let preset = |preset: &'static Preset| match family {
        Family::Friction if !holds_start_values(model, preset) => diagrams::preset(model, preset),
        _ => Ok(String::new()),
    };
    let presets = model.presets.iter().map(preset).collect::<Result<_>>()?;
    Ok(Pictures { model: diagrams::html(model, family)?, presets })
}

/// The icon, seen from the page.
fn icon(version: Version) -> &'static str {
    match version {
        Version::Two => "../model.png",
        Version::Three => "../terminalsAndIcons/icon.png",
    }
}

/// Whether a preset only repeats the start values.
fn holds_start_values(model: &ModelType, preset: &Preset) -> bool {
    let is_start = |(name, value): &(&str, f64)| model.find(name).is_some_and(|at| model.table.at(at).start == *value);
    preset.values.iter().all(is_start)
}

fn document(model: &ModelType, documentation: &str, pictures: &Pictures, version: Version) -> Result<String> {
    let text = typeset::html(model.name, documentation, &pictures.model)?;
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{name} - Stribeck</title>\n<style>\n{STYLE}</style>\n</head>\n\
         <body>\n<header>\n<img src=\"{}\" alt=\"\" width=\"96\" height=\"96\">\n\
         <div>\n<h1>{name}</h1>\n<p>{}</p>\n</div>\n</header>\n<main>\n{text}{}{}{}{}</main>\n\
         <footer>Stribeck {VERSION}, {AUTHORS}. Licence: {LICENSE}, \
         <a href=\"licenses/license.txt\">text</a>.</footer>\n</body>\n</html>\n",
        icon(version),
        escape(model.summary),
        variables(model),
        choices(model),
        presets(model, &pictures.presets),
        capabilities(model, version),
        name = model.name
    ))
}

fn table<R: AsRef<[String]>>(head: &[&str], rows: impl Iterator<Item = R>) -> String {
    let titles: String = head.iter().map(|title| format!("<th>{title}</th>")).collect();
    let cells = |row: R| row.as_ref().iter().map(|cell| format!("<td>{cell}</td>")).collect::<String>();
    let rows: String = rows.map(|row| format!("<tr>{}</tr>\n", cells(row))).collect();
    format!("<div class=\"wide\"><table>\n<thead><tr>{titles}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n")
}

fn variables(model: &ModelType) -> String {
    let head = ["Variable", "Unit", "Start", "Bound", "Meaning", "Role", "Type", "Value reference"];
    let rows = model.variables().map(|(column, shown)| variable(model.reference(column), &shown));
    format!("<h2>Variables</h2>\n<p>{ROLES}</p>\n{}", table(&head, rows))
}

fn variable(reference: u32, variable: &Variable) -> [String; 8] {
    let start = if variable.role.is_computed() { String::new() } else { text::start(variable) };
    [
        format!("<code>{}</code>", variable.path),
        typeset_unit(text::unit(variable)),
        start,
        escape(&text::bound(variable)),
        escape(variable.help),
        text::role(variable.role).to_owned(),
        text::kind(variable).to_owned(),
        reference.to_string(),
    ]
}

/// One table per enumeration of the model.
fn choices(model: &ModelType) -> String {
    let mut seen = BTreeSet::new();
    let enumerations = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Enumeration(choices) => Some(choices),
        _ => None,
    });
    let choices = enumerations.filter(|choices| seen.insert(choices.name)).map(|choices| {
        let row = |(number, item): (usize, &stribeck::model::Item)| {
            [(number + 1).to_string(), format!("<code>{}</code>", item.name), escape(item.help)]
        };
        let rows = table(&["Number", "Choice", "Meaning"], choices.items.iter().enumerate().map(row));
        format!("<h2>Choices of {}</h2>\n{rows}", choices.name)
    });
    choices.collect()
}

/// One table per preset, with the diagrams for its values.
fn presets(model: &ModelType, pictures: &[String]) -> String {
    let preset = |(at, preset): (usize, &Preset)| {
        let row = |(name, value): &(&str, f64)| {
            let (shown, unit) = match model.find(name) {
                Some(column) => (text::value(&model.table.at(column), *value), text::unit(&model.table.at(column))),
                None => (text::number(*value), ""),
            };
            [format!("<code>{name}</code>"), shown, typeset_unit(unit)]
        };
        let rows = Some(preset.values).filter(|values| !values.is_empty());
        let values = rows.map_or(String::new(), |rows| table(&["Variable", "Value", "Unit"], rows.iter().map(row)));
        let pictures = pictures.get(at).map_or("", String::as_str);
        format!("<h3><code>{}</code></h3>\n<p>{}</p>\n{values}{pictures}", preset.name, escape(preset.source))
    };
    if model.presets.is_empty() {
        return String::new();
    }
    let presets: String = model.presets.iter().enumerate().map(preset).collect();
    format!("<h2>Presets</h2>\n<p>Sets of values; other variables keep their start values.</p>\n{presets}")
}

/// Meaning of the capability flags of FMI 2.0 for a user.
fn meaning(capability: &str) -> &'static str {
    match capability {
        "needsExecutionTool" => "The FMU is self-contained; it needs no other program.",
        "canHandleVariableCommunicationStepSize" => "Communication steps may differ in length.",
        "canInterpolateInputs" => "Inputs may move linearly within a step: fmi2SetRealInputDerivatives, order 1.",
        "maxOutputDerivativeOrder" => "Exact first derivatives of the outputs.",
        "canRunAsynchronuously" => "fmi2DoStep returns when the step is done.",
        "canBeInstantiatedOnlyOncePerProcess" => "A process may have any number of instances.",
        "canNotUseMemoryManagementFunctions" => "The memory callbacks of the importer are not used.",
        "canGetAndSetFMUstate" | "canGetAndSetFMUState" => "The state may be saved and restored between steps.",
        "canSerializeFMUstate" | "canSerializeFMUState" => {
            "A saved state may be written to a file and read by another process."
        }
        "providesDirectionalDerivative" => "fmi2GetDirectionalDerivative gives exact derivatives.",
        "providesDirectionalDerivatives" => "fmi3GetDirectionalDerivative gives exact derivatives.",
        "providesAdjointDerivatives" => "fmi3GetAdjointDerivative gives exact derivatives.",
        "providesIntermediateUpdate" => "Continuous outputs may be read within a step.",
        "mightReturnEarlyFromDoStep" => "Whether a step may end at an event, if the importer allows it.",
        "canReturnEarlyAfterIntermediateUpdate" => "The importer may end a step where it reads results within it.",
        "hasEventMode" => "The importer may handle events itself.",
        "providesEvaluateDiscreteStates" => "Discrete states have one value at an event.",
        _ => "",
    }
}

/// Capabilities in Model Exchange.
fn exchange(model: &ModelType) -> String {
    let start: Vec<f64> = model.table.iter().map(|variable| variable.start).collect();
    if model.bonds(&start).is_some() {
        return "Co-simulation only: its bonds snap far too often for the events of an importer.".to_owned();
    }
    if model.has_rates && !model.model_exchange {
        return "Co-simulation only: its rates need the past, which an importer does not give.".to_owned();
    }
    if !model.model_exchange {
        return "Co-simulation only: its memory cannot be expressed as continuous states.".to_owned();
    }
    let states = counted(model.continuous_states().count(), "continuous state");
    let events = match model.event_indicators {
        0 => "no event indicators".to_owned(),
        count => counted(count, "event indicator") + " at its jumps and kinks",
    };
    let mut text = format!("In Model Exchange {states}, {events}.");
    if model.find("mass").is_some() {
        text += " <code>mass</code> must be 0 in Model Exchange, because no force is held over a step.";
    }
    if model.table.iter().any(|variable| variable.reinit) {
        text += " An event may change states: read them again.";
    }
    text
}

fn counted(count: usize, one: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") }
}

fn capabilities(model: &ModelType, version: Version) -> String {
    let kinds = if model.model_exchange { "Co-Simulation and Model Exchange" } else { "Co-Simulation" };
    let (number, declared) = match version {
        Version::Two => ("2.0", fmi2::CAPABILITIES.to_vec()),
        Version::Three => (fmi3::VERSION, fmi3::capabilities(model).to_vec()),
    };
    let facts = [
        ["Interface".to_owned(), format!("FMI {number} for {kinds}"), exchange(model)],
        ["Version".to_owned(), VERSION.to_owned(), String::new()],
        ["Model identifier".to_owned(), format!("<code>{}</code>", model.name), String::new()],
        [
            "Guid".to_owned(),
            format!("<code>{}</code>", model.guid()),
            "Fingerprint of the table of variables.".to_owned(),
        ],
    ];
    let capability =
        |(name, value): (&str, &str)| [format!("<code>{name}</code>"), value.to_owned(), meaning(name).to_owned()];
    let rows = facts.into_iter().chain(declared.into_iter().map(capability));
    format!("<h2>This FMU</h2>\n{}", table(&["Property", "Value", "Meaning"], rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::entry::entries;
    use crate::specimen::{SPECIMEN, Specimen};
    use std::sync::LazyLock;
    use stribeck::model::Described;

    fn made(entry: &Entry) -> String {
        Page::of(entry).unwrap().text(Version::Two).unwrap()
    }

    /// Every entry with its page.
    static PAGES: LazyLock<Vec<(Entry, String)>> = LazyLock::new(|| {
        let with_page = |entry: Entry| {
            let page = made(&entry);
            (entry, page)
        };
        entries().into_iter().map(with_page).collect()
    });

    /// Every page, and that of a model with features that no shipped model has.
    fn pages() -> impl Iterator<Item = (&'static ModelType, String)> {
        let specimen =
            document(&SPECIMEN, <Specimen as Described>::DOCUMENTATION, &Pictures::default(), Version::Two).unwrap();
        PAGES.iter().map(|(entry, page)| (entry.model, page.clone())).chain([(&SPECIMEN, specimen)])
    }

    /// The page closes what it opens, so that with closed void elements it is also XML.
    fn as_xml(page: &str) -> String {
        let mut closed = page.to_owned();
        for void in ["<meta ", "<img "] {
            closed = close(&closed, void);
        }
        closed.trim_start_matches("<!DOCTYPE html>\n").to_owned()
    }

    fn close(page: &str, void: &str) -> String {
        let mut parts = page.split(void);
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + void + &part.replacen('>', "/>", 1))
    }

    #[test]
    fn every_page_is_well_formed_and_lists_every_variable() {
        for (model, page) in pages() {
            let xml = as_xml(&page);
            let document = roxmltree::Document::parse(&xml).unwrap_or_else(|error| panic!("{}: {error}", model.name));
            let cells: Vec<_> = document.descendants().filter_map(|node| node.text()).collect();
            for (_, variable) in model.variables() {
                assert!(cells.contains(&variable.path.to_string().as_str()), "{}", variable.path);
            }
        }
    }

    /// A line that begins with a sign would be read as a list item, and its code as text.
    #[test]
    fn sentences_are_whole() {
        for (model, page) in pages() {
            assert!(!page.contains('`'), "{}: {:?}", model.name, page.lines().find(|line| line.contains('`')));
        }
        for entry in entries() {
            let begins_with_sign = |line: &&str| line.starts_with(['*', '+']) || line.starts_with("- ");
            let prose = entry.documentation.split("```").step_by(2).flat_map(str::lines);
            assert_eq!(prose.map(str::trim).find(begins_with_sign), None, "{}", entry.model.name);
        }
    }

    /// A reader without a network sees the same page: nothing but the icon is loaded, and nothing runs.
    #[test]
    fn pages_need_no_network() {
        for (model, page) in pages() {
            let xml = as_xml(&page);
            let document = roxmltree::Document::parse(&xml).unwrap();
            for node in document.descendants().filter(roxmltree::Node::is_element) {
                assert!(!["script", "link", "iframe", "object", "embed"].contains(&node.tag_name().name()));
                for attribute in node.attributes() {
                    assert!(!attribute.name().starts_with("on"), "{}: {attribute:?}", model.name);
                    let is_address = ["src", "href", "srcset", "data", "action"].contains(&attribute.name());
                    let is_known = ["../model.png", "licenses/license.txt"].contains(&attribute.value());
                    assert!(!is_address || is_known, "{}: {attribute:?}", model.name);
                }
            }
            assert!(!page.contains("url(") && !page.contains("@import") && !page.contains("://"), "{}", model.name);
        }
    }

    /// Every line of every block of equations is on the page as MathML, and as text beside it.
    #[test]
    fn every_block_of_equations_is_typeset() {
        for (entry, page) in &*PAGES {
            let kept = entry.documentation.split(" # Example").next().unwrap();
            let blocks: Vec<&str> =
                kept.split("```text\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
            assert!(!blocks.is_empty(), "{}", entry.model.name);
            assert_eq!(page.matches("<div class=\"equations\">").count(), blocks.len(), "{}", entry.model.name);
            assert!(page.matches("<math displaystyle=\"true\">").count() >= blocks.len(), "{}", entry.model.name);
            for line in blocks.iter().flat_map(|block| block.lines()) {
                assert!(page.contains(&escape(line.trim())), "{}: {line}", entry.model.name);
            }
        }
    }

    #[test]
    fn every_page_has_a_diagram_and_is_the_same_twice() {
        for (entry, page) in &*PAGES {
            assert!(page.contains("<svg ") && page.contains("<figcaption>"), "{}", entry.model.name);
            assert_eq!(*page, made(entry), "{}", entry.model.name);
        }
    }

    #[test]
    fn capabilities_are_explained() {
        let lugre = stribeck::catalogue::by_name("LuGre").unwrap();
        for (name, _) in fmi2::CAPABILITIES.into_iter().chain(fmi3::capabilities(lugre)) {
            assert_ne!(meaning(name), "", "{name}");
        }
    }

    #[test]
    fn a_page_is_about_its_version() {
        let lugre = entries().into_iter().find(|entry| entry.model.name == "LuGre").unwrap();
        let text = Page::of(&lugre).unwrap().text(Version::Three).unwrap();
        for part in ["FMI 3.0 for Co-Simulation", "<code>hasEventMode</code>", "../terminalsAndIcons/icon.png"] {
            assert!(text.contains(part), "{part}");
        }
        assert!(!text.contains("canInterpolateInputs") && !text.contains("model.png"));
    }

    #[test]
    fn presets_are_listed_with_their_source_values_and_units() {
        let lugre = stribeck::catalogue::by_name("LuGre").unwrap();
        let text = presets(lugre, &[]);
        for preset in lugre.presets {
            assert!(text.contains(&format!("<h3><code>{}</code></h3>\n<p>{}</p>", preset.name, escape(preset.source))));
            for (name, value) in preset.values {
                let unit = typeset_unit(text::unit(&lugre.table.at(lugre.find(name).unwrap())));
                let row = format!("<td><code>{name}</code></td><td>{}</td><td>{unit}</td>", text::number(*value));
                assert!(text.contains(&row), "{row}");
            }
        }
        assert!(!lugre.presets.is_empty());
    }
}
