//! The contents of an FMU, and the command that packs them.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use jiff::Timestamp;
use stribeck::catalogue::{self, Family};
use stribeck::model::ModelType;

use crate::archive::{self, Files};
use crate::library::Library;
use crate::{html, icon, xml};

/// A model with what its FMU says about it.
pub struct Entry {
    /// The model.
    pub model: &'static ModelType,
    family: Family,
    documentation: &'static str,
}

/// The models of these names, or all of them if there are none.
pub fn select(names: &[String]) -> Result<Vec<Entry>> {
    for name in names {
        if catalogue::by_name(name).is_none() {
            let known: Vec<_> = catalogue::models().map(|model| model.name).collect();
            bail!("there is no model {name}; there are {}", known.join(", "));
        }
    }
    let is_wanted = |entry: &Entry| names.is_empty() || names.iter().any(|name| name == entry.model.name);
    Ok(entries().into_iter().filter(is_wanted).collect())
}

/// All models.
pub fn entries() -> Vec<Entry> {
    let of = |family| {
        let entry = move |(model, documentation)| Entry { model, family, documentation };
        catalogue::documented(family).map(entry)
    };
    of(Family::Friction).chain(of(Family::Host)).collect()
}

/// Writes one FMU and returns its size in bytes.
pub fn write(entry: &Entry, library: &Library, root: &Path, date: Timestamp, folder: &Path) -> Result<usize> {
    let bytes = archive::zip(&contents(entry, library, root, date)?, date)?;
    let file = folder.join(format!("{}.fmu", entry.model.name));
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    fs::write(&file, &bytes).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(bytes.len())
}

fn contents(entry: &Entry, library: &Library, root: &Path, date: Timestamp) -> Result<Files> {
    let Entry { model, family, documentation } = *entry;
    let binary = format!("binaries/{}/{}{}", library.platform, model.name, library.suffix);
    let files = [
        (binary, library.bytes.clone()),
        ("documentation/index.html".into(), html::page(model, documentation).into()),
        ("documentation/licenses/license.txt".into(), license(root)?.into()),
        ("model.png".into(), icon::png(model, family)?),
        ("modelDescription.xml".into(), xml::model_description(model, date)?.into()),
    ];
    Ok(files.into())
}

/// Both licences in one text.
fn license(root: &Path) -> Result<String> {
    let read = |name: &str| fs::read_to_string(root.join(name)).with_context(|| format!("cannot read {name}"));
    let rule = "-".repeat(80);
    Ok(format!(
        "Stribeck is licensed under the MIT licence or the Apache License 2.0, at your choice.\n\n{rule}\n\n{}\n{rule}\n\n{}",
        read("LICENSE-MIT")?,
        read("LICENSE-APACHE")?,
    ))
}
