//! The table of models in README.md.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result};
use stribeck::catalogue;
use stribeck::model::{ModelType, Role};

use crate::text;

const BEGIN: &str = "<!-- models:begin (written by fmu-build generate) -->\n";
const END: &str = "<!-- models:end -->";

/// The text of README.md with a fresh table.
pub fn with_table(readme: &str, root: &Path) -> Result<String> {
    let missing =
        |marker: &str| format!("README.md lacks the line `{}`: the table of models goes there", marker.trim());
    let (before, rest) = readme.split_once(BEGIN).with_context(|| missing(BEGIN))?;
    let (_, after) = rest.split_once(END).with_context(|| missing(END))?;
    Ok(format!("{before}{BEGIN}\n{}\n{END}{after}", table(root)?))
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
    fn only_the_block_between_the_markers_changes() {
        let readme = format!("# Title\n\n{BEGIN}a stale block\n{END}\n\nRest.\n");
        let fresh = with_table(&readme, root()).unwrap();
        assert!(fresh.starts_with("# Title\n\n<!-- models:begin") && fresh.ends_with("<!-- models:end -->\n\nRest.\n"));
        assert!(
            fresh.contains("| [`LuGre`](src/friction/lugre.rs) | Bristle friction with Stribeck effect (LuGre) | ")
        );
        assert!(!fresh.contains("stale"));
        assert_eq!(with_table(&fresh, root()).unwrap(), fresh);
    }

    #[test]
    fn missing_markers_are_named() {
        let error = with_table("# Title\n", root()).unwrap_err().to_string();
        assert!(error.contains("models:begin"), "{error}");
        let error = with_table(BEGIN, root()).unwrap_err().to_string();
        assert!(error.contains("models:end"), "{error}");
    }
}
