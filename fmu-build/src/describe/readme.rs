//! The table of models in README.md.

use std::fmt::Write;
use std::path::Path;

use anyhow::Result;
use stribeck::catalogue;
use stribeck::model::{ModelType, Role};

use crate::describe::{block, text};

/// The text of README.md with a fresh table.
pub fn with_table(readme: &str, root: &Path) -> Result<String> {
    block::replaced("README.md", readme, "models", &table(root)?)
}

fn table(root: &Path) -> Result<String> {
    let mut table = String::from("| model | what it is | inputs |\n|---|---|---|\n");
    for model in catalogue::models() {
        let file = text::source_file(root, model)?.display().to_string().replace('\\', "/");
        writeln!(table, "| [`{}`]({file}) | {} | {} |", model.name, model.summary, inputs(model))?;
    }
    Ok(table)
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
    fn table_links_each_model_to_its_source() {
        let table = table(root()).unwrap();
        let row = "| [`LuGre`](src/friction/lugre.rs) | Bristle friction with Stribeck effect (LuGre) | ";
        assert!(table.contains(row), "{table}");
        assert_eq!(table.lines().count(), 2 + catalogue::models().count());
    }
}
