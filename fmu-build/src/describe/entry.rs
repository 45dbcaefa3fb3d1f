//! The models, each with its family and its documentation.

use anyhow::{Result, bail};
use stribeck::catalogue::{self, Family};
use stribeck::model::ModelType;

/// A model with the documentation in its FMU.
pub struct Entry {
    /// The model.
    pub model: &'static ModelType,
    /// Its family.
    pub family: Family,
    /// Its page, in Markdown.
    pub documentation: &'static str,
}

/// The models of these names, or all of them if there are none.
pub fn select(names: &[String]) -> Result<Vec<Entry>> {
    for name in names {
        if catalogue::by_name(name).is_none() {
            let known: Vec<_> = catalogue::models().map(|model| model.name).collect();
            bail!("unknown model {name}; known are {}", known.join(", "));
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
    let families = [Family::Friction, Family::ShockAbsorber, Family::Host, Family::Component];
    families.into_iter().flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_models_are_rejected_with_the_known_names() {
        let error = select(&["LuGre".into(), "Lugre".into()]).err().unwrap().to_string();
        assert!(error.starts_with("unknown model Lugre; known are ") && error.contains("LuGre"), "{error}");
        assert_eq!(select(&["LuGre".into()]).unwrap().len(), 1);
        assert_eq!(select(&[]).unwrap().len(), catalogue::models().count());
    }
}
