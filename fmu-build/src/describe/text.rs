//! Spelling of numbers, names and roles in all generated files.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use stribeck::model::{Kind, ModelType, Role, Variable};

/// The shortest decimal text that reads back as the same number; valid as xs:double, in C and in Rust.
pub fn number(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// The ends of the bound that narrow the variable's type; `None` where the type itself is the limit.
pub fn limits(variable: &Variable) -> (Option<f64>, Option<f64>) {
    let (lowest, highest) = match variable.kind {
        Kind::Real(_) => (f64::MIN, f64::MAX),
        Kind::Integer => (i32::MIN.into(), i32::MAX.into()),
        Kind::Boolean => (0.0, 1.0),
        Kind::Enumeration(items) => (1.0, items.items.len() as f64),
    };
    let (min, max) = (variable.bound.min(), variable.bound.max());
    (Some(min).filter(|min| *min > lowest), Some(max).filter(|max| *max < highest))
}

/// The bound in words, such as `> 0` or `>= 0, <= 1`; empty if there is none.
pub fn bound(variable: &Variable) -> String {
    let (min, max) = limits(variable);
    let above = |min| if variable.bound.is_positive() { "> 0".to_owned() } else { format!(">= {}", number(min)) };
    let ends = [min.map(above), max.map(|max| format!("<= {}", number(max)))];
    ends.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The start value for readers.
pub fn start(variable: &Variable) -> String {
    value(variable, variable.start)
}

/// A value for readers: true or false, the name of a choice, or a number.
pub fn value(variable: &Variable, value: f64) -> String {
    match variable.kind {
        Kind::Boolean => (value != 0.0).to_string(),
        Kind::Enumeration(items) => items.items[value as usize - 1].name.to_owned(),
        Kind::Real(_) | Kind::Integer => number(value),
    }
}

/// The type in one word.
pub fn kind(variable: &Variable) -> &'static str {
    match variable.kind {
        Kind::Real(_) => "Real",
        Kind::Integer => "Integer",
        Kind::Boolean => "Boolean",
        Kind::Enumeration(items) => items.name,
    }
}

/// The name of the unit; empty if there is none.
pub fn unit(variable: &Variable) -> &'static str {
    match variable.kind {
        Kind::Real(unit) => unit.name,
        _ => "",
    }
}

/// The role in plain words.
pub fn role(role: Role) -> &'static str {
    match role {
        Role::Input => "input",
        Role::Fixed => "fixed parameter",
        Role::Tunable => "tunable parameter",
        Role::State => "state",
        Role::StateOutput => "state, output",
        Role::Output => "output",
    }
}

/// The source file of a model, relative to the root of the project: the file under src/ whose name is the model's name
/// apart from capitals and underscores (`LuGre` is in `lugre.rs`, `BeltRig` in `belt_rig.rs`).
pub fn source_file(root: &Path, model: &ModelType) -> Result<PathBuf> {
    let wanted = model.name.to_lowercase();
    let is_wanted = |file: &PathBuf| stem(file).replace('_', "") == wanted;
    let file = rust_files(&root.join("src"))?.into_iter().find(is_wanted);
    let file = file.with_context(|| format!("no file under src is named after the model {}", model.name))?;
    Ok(file.strip_prefix(root)?.to_owned())
}

/// The model's name in snake case, divided as its source file is: `BrownMcPhee` is `brown_mcphee`.
pub fn snake_case(root: &Path, model: &ModelType) -> Result<String> {
    Ok(stem(&source_file(root, model)?))
}

fn stem(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// All Rust files of a folder and its subfolders, sorted.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in folder.read_dir().with_context(|| format!("cannot list {}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::model::{Path as Name, integer, real};

    #[test]
    fn numbers_are_short_and_read_back() {
        for (value, text) in [(0.0, "0"), (9.81, "9.81"), (1e5, "100000"), (1e-5, "1e-5"), (-2.5e300, "-2.5e300")] {
            assert_eq!(number(value), text);
            assert_eq!(text.parse(), Ok(value));
        }
    }

    #[test]
    fn bounds_name_only_the_ends_that_exist() {
        let spelled = |column: stribeck::model::Column| bound(&column.named(Name::root("x"), Role::Fixed, "Help."));
        assert_eq!(spelled(real("m", 0.0)), "");
        assert_eq!(spelled(real("m", 1.0).positive()), "> 0");
        assert_eq!(spelled(integer(3).at_least(0.0).at_most(9.0)), ">= 0, <= 9");
        assert_eq!(spelled(integer(3)), "");
    }

    #[test]
    fn snake_case_follows_the_source_file() {
        let root = crate::project::root();
        let model = stribeck::catalogue::by_name("BrownMcPhee").unwrap();
        assert_eq!(snake_case(root, model).unwrap(), "brown_mcphee");
    }
}
