//! include/stribeck.h: the C functions and types that cbindgen finds in the sources, and the tables of the models.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use cbindgen::{Builder, Config, DocumentationStyle, Language, Style};
use stribeck::catalogue;
use stribeck::model::{Enumeration, Kind, ModelType, Role, Variable};

use crate::describe::text;
use crate::project::VERSION;

/// Columns of a line.
const WIDTH: usize = 120;

const PROLOGUE: &str = include_str!("prologue.h");

/// The text of the header.
pub fn text(root: &Path) -> Result<String> {
    let mut builder = Builder::new().with_config(config(root)?);
    for file in sources(root)? {
        builder = builder.with_src(file);
    }
    let mut header = Vec::new();
    builder.generate().context("cbindgen cannot read the sources")?.write(&mut header);
    let header = plain(&String::from_utf8(header)?);
    ensure!(header.is_ascii(), "the header must be ASCII: {:?}", header.lines().find(|line| !line.is_ascii()));
    Ok(header)
}

fn config(root: &Path) -> Result<Config> {
    Ok(Config {
        language: Language::C,
        // cbindgen's own guard would end before the tables.
        header: Some(format!("{}\n\n#ifndef STRIBECK_H\n#define STRIBECK_H", PROLOGUE.trim_end())),
        no_includes: true,
        sys_includes: vec!["stddef.h".into(), "stdint.h".into()],
        after_includes: Some(version()),
        trailer: Some(format!("{}\n\n#endif /* STRIBECK_H */", tables(root)?)),
        cpp_compat: true,
        usize_is_size_t: true,
        style: Style::Type,
        documentation_style: DocumentationStyle::Doxy,
        line_length: WIDTH,
        ..Config::default()
    })
}

/// The files that declare something for C. The others contain nothing for it, and those that only list modules would
/// make cbindgen read these files twice; a file that itself declares something includes its modules.
fn sources(root: &Path) -> Result<Vec<PathBuf>> {
    let mut sources = Vec::new();
    for folder in ["ffi/src/c", "ffi/src/fmi2"] {
        let first = sources.len();
        for file in text::rust_files(&root.join(folder))? {
            let source = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
            if ["C", "C-unwind"].iter().any(|abi| source.contains(&format!("extern \"{abi}\" fn"))) {
                sources.push(file);
            }
        }
        if let Some(leading) = sources[first..].iter().find(|file| file.ends_with("mod.rs")).cloned() {
            sources.splice(first.., [leading]);
        }
    }
    Ok(sources)
}

fn version() -> String {
    format!("\n/** Version of the library that this header belongs to. */\n#define STRIBECK_VERSION \"{VERSION}\"")
}

/// The header as a C programmer reads it: without the marks of rustdoc and of unused arguments, with short comments on
/// one line. The prologue states once what every function demands under the heading "Safety".
fn plain(header: &str) -> String {
    let mut text = String::new();
    let mut in_safety = false;
    for line in header.lines() {
        in_safety = (in_safety || line.trim() == "* # Safety") && line.trim() != "*/";
        if in_safety {
            continue;
        }
        let is_code = !line.trim_start().starts_with(['#', '*', '/']);
        let line = line.replace("[`", "`").replace("`]", "`");
        text.push_str(&if is_code { line.replace(" _", " ").replace("*_", "*") } else { line });
        text.push('\n');
    }
    // The heading leaves an empty line.
    let mut text = text.replace(" *\n */", " */");
    while text.contains("\n\n\n") {
        text = text.replace("\n\n\n", "\n\n");
    }
    with_short_comments(&text)
}

/// Puts a comment of one sentence on one line, if it is not too long.
fn with_short_comments(header: &str) -> String {
    let lines: Vec<&str> = header.lines().collect();
    let mut text = String::new();
    let mut at = 0;
    while at < lines.len() {
        let short = match lines[at..] {
            [open, middle, close, ..] if open.trim() == "/**" && close.trim() == "*/" => {
                Some(format!("{open} {} */", middle.trim_start_matches([' ', '*'])))
            }
            _ => None,
        };
        let short = short.filter(|line| line.len() <= WIDTH);
        at += if short.is_some() { 3 } else { 1 };
        text.push_str(&short.unwrap_or_else(|| lines[at - 1].to_owned()));
        text.push('\n');
    }
    text
}

/// The variables of every model and the numbers of every choice.
fn tables(root: &Path) -> Result<String> {
    let mut text = String::new();
    for choices in enumerations().values() {
        write_choices(&mut text, choices, "stribeck")?;
    }
    for model in catalogue::models() {
        write_model(&mut text, model, &text::snake_case(root, model)?)?;
    }
    Ok(text.trim_end().to_owned())
}

/// Enumerations of all models, each once, by name.
fn enumerations() -> BTreeMap<&'static str, &'static Enumeration> {
    catalogue::models().flat_map(enumerations_of).collect()
}

/// Enumerations of a model, by name.
fn enumerations_of(model: &ModelType) -> BTreeMap<&'static str, &'static Enumeration> {
    let of_variables = model.table.iter().filter_map(|variable| match variable.kind {
        Kind::Enumeration(choices) => Some((choices.name, choices)),
        _ => None,
    });
    of_variables.collect()
}

/// The variables and choices of one model, for a header of its own: all names begin with that of the model.
pub fn of_model(model: &ModelType, name: &str) -> Result<String> {
    let mut text = String::new();
    for choices in enumerations_of(model).values() {
        write_choices(&mut text, choices, name)?;
    }
    write_variables(&mut text, model, name)?;
    Ok(text)
}

fn write_choices(text: &mut String, choices: &Enumeration, prefix: &str) -> Result<()> {
    let name = snake(choices.name);
    let upper = format!("{prefix}_{name}").to_uppercase();
    writeln!(text, "/** Choices of a variable of the type {}. */\ntypedef enum {prefix}_{name} {{", choices.name)?;
    for (number, item) in choices.items.iter().enumerate() {
        writeln!(text, "  /** {} */", item.help)?;
        writeln!(text, "  {upper}_{} = {},", snake(item.name).to_uppercase(), number + 1)?;
    }
    writeln!(text, "}} {prefix}_{name};\n")?;
    Ok(())
}

fn write_model(text: &mut String, model: &ModelType, name: &str) -> Result<()> {
    let upper = name.to_uppercase();
    writeln!(text, "/** Guid of {} for fmi2Instantiate. */", model.name)?;
    writeln!(text, "#define STRIBECK_{upper}_GUID \"{}\"\n", model.guid())?;
    for preset in model.presets {
        writeln!(text, "/** Preset of {}: {}. */", model.name, preset.source.trim_end_matches('.'))?;
        writeln!(text, "#define STRIBECK_{upper}_PRESET_{} \"{}\"\n", preset.name.to_uppercase(), preset.name)?;
    }
    write_variables(text, model, &format!("stribeck_{name}"))
}

/// The variables of a model, with names that begin with this prefix.
fn write_variables(text: &mut String, model: &ModelType, prefix: &str) -> Result<()> {
    let upper = prefix.to_uppercase();
    let owner = prefix.strip_prefix("stribeck_").map_or(prefix, |_| "stribeck");
    writeln!(text, "/** {}: {}. Variables of \"{}\". */", model.name, model.summary, model.name)?;
    writeln!(text, "typedef enum {prefix}_variable {{")?;
    for (column, variable) in model.variables() {
        writeln!(text, "{}", comment(&variable, owner))?;
        writeln!(text, "  {upper}_{} = {},", constant(&variable), model.reference(column))?;
    }
    writeln!(text, "}} {prefix}_variable;\n")?;
    Ok(())
}

/// Role, unit or type, help text, bound and start value; on two lines if one is too short. Names of types begin with
/// `owner`.
fn comment(variable: &Variable, owner: &str) -> String {
    let role = role(variable.role);
    let measure = match variable.kind {
        Kind::Real(unit) => unit.name.to_owned(),
        Kind::Enumeration(choices) => format!("{owner}_{}", snake(choices.name)),
        Kind::Boolean | Kind::Integer => text::kind(variable).to_owned(),
    };
    let meaning = format!("  /** {role} [{measure}]: {}", variable.help);
    let start = (!variable.role.is_computed()).then(|| format!("default {}", text::start(variable)));
    let limits = [Some(text::bound(variable)).filter(|bound| !bound.is_empty()), start];
    let limits = limits.into_iter().flatten().collect::<Vec<_>>().join(", ");
    match limits.is_empty() {
        true => format!("{meaning} */"),
        false if meaning.len() + limits.len() + 6 <= WIDTH => format!("{meaning} ({limits}) */"),
        false => format!("{meaning}\n   *  ({limits}) */"),
    }
}

fn role(role: Role) -> &'static str {
    match role {
        Role::Input => "in",
        Role::Fixed => "fixed",
        Role::Tunable => "tunable",
        Role::State => "state",
        Role::StateOutput => "state, out",
        Role::Output => "out",
    }
}

/// A variable's name as part of a C constant: `element[3].stiffness` is `ELEMENT_3_STIFFNESS`.
pub fn constant(variable: &Variable) -> String {
    variable.path.to_string().replace(['.', '['], "_").replace(']', "").to_uppercase()
}

/// `PreSliding` is `pre_sliding`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for (at, letter) in name.char_indices() {
        if letter.is_uppercase() && at > 0 {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

/// Complaints about items of the header without a comment.
pub fn without_comment(header: &str) -> Vec<String> {
    let mut bare = Vec::new();
    let (mut is_explained, mut in_comment, mut in_arguments) = (false, false, false);
    for line in header.lines().map(str::trim) {
        if in_comment || line.starts_with("/*") {
            in_comment = !line.ends_with("*/");
            is_explained = !in_comment;
        } else if in_arguments {
            in_arguments = !line.ends_with(';');
        } else if is_item(line) {
            if !is_explained {
                bare.push(format!("include/stribeck.h: no comment explains `{line}`"));
            }
            is_explained = false;
            in_arguments = line.contains('(') && !line.ends_with(';');
        }
    }
    bare
}

/// Whether the line begins an item. All lines do except those that frame items: guards, includes, ends of lists.
fn is_item(line: &str) -> bool {
    let frames = ["#if", "#endif", "#include", "extern \"C\"", "}"];
    let is_frame = frames.iter().any(|frame| line.starts_with(frame));
    !(line.is_empty() || is_frame || line == "#define STRIBECK_H")
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::model::{Path as Name, integer, real};

    #[test]
    fn comments_give_role_unit_meaning_bound_and_default() {
        let stiffness = real("N/m", 1e5).positive().named(Name::root("sigma_0"), Role::Tunable, "Stiffness.");
        assert_eq!(comment(&stiffness, "stribeck"), "  /** tunable [N/m]: Stiffness. (> 0, default 100000) */");
        let count = integer(3).named(Name::root("count"), Role::State, "Count.");
        assert_eq!(comment(&count, "stribeck"), "  /** state [Integer]: Count. (default 3) */");
        let force = real("N", 0.0).named(Name::root("force"), Role::Output, "Force.");
        assert_eq!(comment(&force, "stribeck"), "  /** out [N]: Force. */");
    }

    #[test]
    fn items_without_a_comment_are_found() {
        let header = "#ifndef STRIBECK_H\n#define STRIBECK_H\n/** Version. */\n#define VERSION 1\n#define BARE 2\n\
            typedef enum { /* not a comment above */\n  A = 0,\n  /**\n   * B.\n   */\n  B = 1,\n} e;\n\
            /** Function. */\nint f(int a,\n      int b);\nint g(void);\n#endif\n";
        let bare = without_comment(header);
        let named = ["#define BARE 2", "typedef enum { /* not a comment above */", "A = 0,", "int g(void);"];
        assert_eq!(bare.len(), named.len(), "{bare:?}");
        for (bare, line) in bare.iter().zip(named) {
            assert_eq!(*bare, format!("include/stribeck.h: no comment explains `{line}`"));
        }
    }

    #[test]
    fn safety_conditions_of_rust_are_not_repeated() {
        let header =
            "/**\n * Frees. See [`f`].\n *\n * # Safety\n * As the module says.\n */\nvoid free(void *_a, int _b);\n";
        assert_eq!(plain(header), "/** Frees. See `f`. */\nvoid free(void *a, int b);\n");
    }

    #[test]
    fn long_comments_keep_their_lines() {
        let header = format!("/**\n * {}\n */\nint a;\n/**\n * One.\n *\n * Two.\n */\nint b;\n", "x".repeat(115));
        assert_eq!(with_short_comments(&header), header);
    }
}
