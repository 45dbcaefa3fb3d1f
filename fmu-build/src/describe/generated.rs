//! The committed files that are generated from the tables: written on request, reviewed, and compared on every check.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use stribeck::catalogue;
use stribeck::model::ModelType;

use crate::describe::interface::{HEADER_FILE, Interface, Version, committed_in};
use crate::describe::{defaults, fmi2, fmi3, header, models};
use crate::project;

/// A file with its expected contents.
pub struct File {
    /// Path, relative to the root.
    pub path: PathBuf,
    /// Its text; `None` if there should be no such file.
    text: Option<String>,
}

impl File {
    fn new(path: impl Into<PathBuf>, text: String) -> File {
        File { path: path.into(), text: Some(text) }
    }

    fn is_stale(&self, root: &Path) -> bool {
        fs::read_to_string(root.join(&self.path)).ok() != self.text
    }

    /// Brings the file up to date.
    pub fn write(&self, root: &Path) -> Result<()> {
        let file = root.join(&self.path);
        let Some(text) = &self.text else {
            return fs::remove_file(&file).with_context(|| format!("cannot remove {}", file.display()));
        };
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
        }
        fs::write(&file, text).with_context(|| format!("cannot write {}", file.display()))
    }
}

/// Everything generated from the tables.
pub struct Generated {
    /// The files that are out of date.
    pub stale: Vec<File>,
    /// The interface.
    pub interface: Interface,
}

/// Generates everything and compares it with the files.
pub fn of(root: &Path) -> Result<Generated> {
    let mut descriptions = Vec::new();
    for model in catalogue::models() {
        let date = project::release_date();
        descriptions.push((Version::Two, model, fmi2::model_description(model, date, fmi2::Choices::Named)?));
        descriptions.push((Version::Three, model, fmi3::model_description(model, date)?));
    }
    let header = header::text(root)?;
    let owned = |(version, model, text): &(Version, &ModelType, String)| (version.owner(model.name), text.clone());
    let interface = Interface::of(&descriptions.iter().map(owned).collect::<Vec<_>>(), &header)?;
    let described = descriptions.into_iter();
    let mut stale: Vec<File> =
        described.map(|(version, model, text)| File::new(description(version, model.name), text)).collect();
    stale.push(File::new(HEADER_FILE, header));
    stale.push(File::new("README.md", models::with_families(&read(root, "README.md")?)?));
    stale.push(File::new(models::PAGE, models::with_tables(&read(root, models::PAGE)?, root)?));
    stale.push(File::new(defaults::PAGE, defaults::with_tables(&read(root, defaults::PAGE)?)?));
    stale.extend(left_over(root)?);
    stale.retain(|file| file.is_stale(root));
    Ok(Generated { stale, interface })
}

fn read(root: &Path, file: &str) -> Result<String> {
    fs::read_to_string(root.join(file)).with_context(|| format!("cannot read {file}"))
}

fn description(version: Version, model: &str) -> PathBuf {
    Path::new(version.folder()).join(format!("{model}.xml"))
}

/// Descriptions of models that no longer exist.
fn left_over(root: &Path) -> Result<Vec<File>> {
    let mut files = Vec::new();
    for version in Version::ALL {
        let is_gone = |path: &PathBuf| !catalogue::models().any(|model| description(version, model.name) == *path);
        let gone = committed_in(root, version)?.into_iter().filter(is_gone);
        files.extend(gone.map(|path| File { path, text: None }));
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_stale_until_it_is_written() {
        let root = tempfile::tempdir().unwrap();
        let file = File::new("folder/file.txt", "text".into());
        assert!(file.is_stale(root.path()));
        file.write(root.path()).unwrap();
        assert!(!file.is_stale(root.path()));
        let no_more = File { path: file.path, text: None };
        assert!(no_more.is_stale(root.path()));
        no_more.write(root.path()).unwrap();
        assert!(!no_more.is_stale(root.path()));
    }

    #[test]
    fn description_of_a_removed_model_is_stale() {
        let root = tempfile::tempdir().unwrap();
        for (version, name) in Version::ALL.into_iter().flat_map(|version| [(version, "LuGre"), (version, "Removed")]) {
            File::new(description(version, name), String::new()).write(root.path()).unwrap();
        }
        let left: Vec<_> = left_over(root.path()).unwrap().into_iter().map(|file| file.path).collect();
        assert_eq!(left, Version::ALL.map(|version| description(version, "Removed")));
    }
}
