//! The models in README.md, a line per family, and on their page, a line per model.

use std::fmt::Write;
use std::path::Path;

use anyhow::Result;
use stribeck::catalogue::{self, Family};
use stribeck::model::{ModelType, Role};

use crate::describe::{block, text};

/// The page, relative to the root of the project.
pub const PAGE: &str = "docs/models.md";

/// The families in the order of the catalogue, with their headings.
const FAMILIES: [(Family, &str); 4] = [
    (Family::Friction, "Friction laws"),
    (Family::ShockAbsorber, "Shock absorber and its parts"),
    (Family::Host, "Hosts"),
    (Family::Component, "Components"),
];

/// The text of README.md with fresh lines.
pub fn with_families(readme: &str) -> Result<String> {
    block::replaced("README.md", readme, "models", &families()?)
}

/// The text of the page with fresh tables.
pub fn with_tables(page: &str, root: &Path) -> Result<String> {
    block::replaced(PAGE, page, "models", &tables(root)?)
}

fn families() -> Result<String> {
    let mut table = String::from("| family | models |\n|---|---|\n");
    for (family, heading) in FAMILIES {
        let names: Vec<_> = catalogue::documented(family).map(|(model, _)| format!("`{}`", model.name)).collect();
        let anchor = heading.to_lowercase().replace(' ', "-");
        writeln!(table, "| [{heading}]({PAGE}#{anchor}) | {} |", names.join(", "))?;
    }
    Ok(table)
}

fn tables(root: &Path) -> Result<String> {
    let mut page = String::new();
    for (family, heading) in FAMILIES {
        let gap = if page.is_empty() { "" } else { "\n" };
        writeln!(page, "{gap}## {heading}\n\n| model | what it is | inputs |\n|---|---|---|")?;
        for (model, _) in catalogue::documented(family) {
            let file = text::source_file(root, model)?.display().to_string().replace('\\', "/");
            writeln!(page, "| [`{}`](../{file}) | {} | {} |", model.name, model.summary, inputs(model))?;
        }
    }
    Ok(page)
}

fn inputs(model: &ModelType) -> String {
    let inputs = model.table.iter().filter(|variable| variable.role == Role::Input);
    inputs.map(|variable| format!("`{}`", variable.path)).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::root;

    #[test]
    fn page_links_each_model_to_its_source() {
        let page = tables(root()).unwrap();
        let row = "| [`LuGre`](../src/friction/lugre.rs) | Bristle friction with Stribeck effect (LuGre) | ";
        assert!(page.contains(row), "{page}");
        let rows = page.lines().filter(|line| line.starts_with("| [`"));
        assert_eq!(rows.count(), catalogue::models().count());
    }

    #[test]
    fn lines_of_the_families_name_every_model_and_lead_to_headings_of_the_page() {
        let (lines, page) = (families().unwrap(), tables(root()).unwrap());
        let named: Vec<&str> = lines.split('`').skip(1).step_by(2).collect();
        assert_eq!(named, catalogue::models().map(|model| model.name).collect::<Vec<_>>());
        let headings: Vec<String> = page
            .lines()
            .filter_map(|line| line.strip_prefix("## "))
            .map(|heading| heading.to_lowercase().split(' ').collect::<Vec<_>>().join("-"))
            .collect();
        let anchors: Vec<&str> = lines.lines().filter_map(|line| line.split(['#', ')']).nth(1)).collect();
        assert_eq!(anchors, headings);
    }
}
