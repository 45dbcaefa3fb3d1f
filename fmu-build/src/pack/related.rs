//! What belongs to a model beside its FMU: presets, and results to compare with, listed by the layered standard FMI-LS-REF
//! 1.0.0-beta.1 (whose text still asks for the version of the alpha in manifests); and the manifest of FMI-LS-STRUCT 1.0.0-rc.1, by which an importer knows tables for what they are.

use anyhow::Result;
use ssp::parameter_set::ParameterSet;
use stribeck::model::{ModelType, Preset};

use crate::describe::entry::Entry;
use crate::describe::only_law::OnlyLaw;
use crate::describe::terminals::STRUCT;
use crate::describe::text::number;
use crate::describe::xml::{Attributes, document, leaf};
use crate::pack::archive::Files;
use crate::pack::experiment::{Experiment, Record};

const REF: &str = "org.fmi-standard.fmi-ls-ref";

/// A file with what its manifest says about it.
struct Related {
    name: String,
    text: String,
    kind: &'static str,
    role: &'static str,
    description: String,
}

/// The files of both versions of FMI: presets, results and their manifest. The results are those of the law, if there is
/// only one.
pub fn files(entry: &Entry, law: Option<OnlyLaw>) -> Result<Files> {
    let mut related = Vec::new();
    for preset in entry.model.presets.iter().filter(|preset| !preset.values.is_empty()) {
        related.push(of_preset(entry.model, preset)?);
    }
    related.extend(of_experiment(entry, law)?);
    let manifest = manifest(&related)?;
    let mut files: Files = related.into_iter().map(|file| (path(&file.name), file.text.into_bytes())).collect();
    files.insert(path("fmi-ls-manifest.xml"), manifest.into());
    Ok(files)
}

fn path(name: &str) -> String {
    format!("extra/{REF}/{name}")
}

/// A preset as SSP 1.0 parameter set. One without values is the model as it is, and not a set.
fn of_preset(model: &'static ModelType, preset: &Preset) -> Result<Related> {
    let set = ParameterSet::new(model, preset.name, preset.values.iter().copied())?;
    Ok(Related {
        name: format!("{}.ssv", preset.name),
        text: set.to_ssv(),
        kind: "application/x-ssp-parameter-set",
        role: "parameter",
        description: preset.source.to_owned(),
    })
}

fn of_experiment(entry: &Entry, law: Option<OnlyLaw>) -> Result<Vec<Related>> {
    let experiment = Experiment::of(entry)?;
    let Record { inputs, outputs } = experiment.run(law)?;
    let name = entry.model.name;
    let file = |ending: &str, text, role, description| {
        let name = format!("{name}_{ending}.csv");
        Related { name, text, kind: "text/csv", role, description }
    };
    let step = number(experiment.step);
    let how = if inputs.is_some() { format!("the inputs of {name}_in.csv") } else { "the start values".to_owned() };
    let results = format!(
        "Outputs at the start and after each step of {step} s, with {how} held over each step: Co-Simulation, start values \
         of all other variables"
    );
    let given = |text| file("in", text, "testcase", format!("Inputs at the beginning of each step of {step} s"));
    Ok(inputs.map(given).into_iter().chain([file("out", outputs, "result", results)]).collect())
}

fn manifest(related: &[Related]) -> Result<String> {
    let about = "Layered Standard providing information on related files included in an FMU.";
    document("fmiReferences", root_of(REF, "1.0.0-alpha.1", about), |xml| {
        related.iter().try_for_each(|file| {
            let attributes = vec![
                ("type", file.kind.to_owned()),
                ("source", file.name.clone()),
                ("role", file.role.to_owned()),
                ("description", file.description.clone()),
            ];
            leaf(xml, "Related", attributes)
        })
    })
}

/// The attributes that every manifest has (FMI 3.0.2, section 2.6).
fn root_of(name: &str, version: &str, description: &str) -> Attributes {
    vec![
        ("xmlns:fmi-ls", "http://fmi-standard.org/fmi-ls-manifest".into()),
        ("fmi-ls:fmi-ls-name", name.into()),
        ("fmi-ls:fmi-ls-version", version.into()),
        ("fmi-ls:fmi-ls-description", description.into()),
    ]
}

/// The manifest of FMI-LS-STRUCT, for an FMU whose terminals hold tables.
pub fn manifest_of_tables() -> Result<(String, Vec<u8>)> {
    let root = root_of(STRUCT, "1.0.0-rc.1", "Layered standard for structuring of variables");
    let text = document("fmiLayeredStandardManifest", root, |_| Ok(()))?;
    Ok((format!("extra/{STRUCT}/fmi-ls-manifest.xml"), text.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::entry::entries;
    use roxmltree::Document;

    fn text<'a>(files: &'a Files, name: &str) -> &'a str {
        std::str::from_utf8(&files[&path(name)]).unwrap()
    }

    #[test]
    fn manifests_list_every_file() {
        for entry in entries() {
            let files = files(&entry, None).unwrap();
            let manifest = Document::parse(text(&files, "fmi-ls-manifest.xml")).unwrap();
            let related = manifest.root_element().children().filter(|node| node.has_tag_name("Related"));
            let mut listed: Vec<String> = related.map(|node| path(node.attribute("source").unwrap())).collect();
            listed.push(path("fmi-ls-manifest.xml"));
            listed.sort();
            assert_eq!(files.into_keys().collect::<Vec<_>>(), listed, "{}", entry.model.name);
        }
    }

    /// FMI 3.0 has no variables for the elements of arrays, so a preset that sets one would be for FMI 2.0 only.
    #[test]
    fn presets_are_for_both_versions() {
        for entry in entries() {
            let files = files(&entry, None).unwrap();
            for preset in entry.model.presets.iter().filter(|preset| !preset.values.is_empty()) {
                let set = ParameterSet::from_ssv(entry.model, text(&files, &format!("{}.ssv", preset.name))).unwrap();
                let values: Vec<(String, f64)> =
                    set.values().map(|(variable, value)| (variable.path.to_string(), value)).collect();
                let expected: Vec<(String, f64)> =
                    preset.values.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
                assert_eq!(values, expected, "{}: {}", entry.model.name, preset.name);
                assert!(set.values().all(|(variable, _)| variable.path.without_index().is_none()), "{}", preset.name);
            }
        }
    }

    /// Something happens in every experiment, unless the model is switched off: a damper does not heat by default.
    #[test]
    fn results_move() {
        for entry in entries().into_iter().filter(|entry| entry.model.name != "DamperTemperature") {
            let files = files(&entry, None).unwrap();
            let table = text(&files, &format!("{}_out.csv", entry.model.name));
            let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
            assert_eq!(rows.len(), 51);
            let moves = |column: &usize| rows.iter().any(|row| row[*column] != rows[0][*column]);
            assert!((1..rows[0].len()).any(|column| moves(&column)), "{}", entry.model.name);
        }
    }
}
