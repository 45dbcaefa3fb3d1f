//! Sources for controllers: a header and a file, whose names begin with that of the model.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};
use stribeck::model::{ModelType, Role, Variable};
use stribeck::serial;

use super::program::{self, Program};
use super::{INCLUDES, beginning, called};
use crate::describe::only_law::OnlyLaw;
use crate::describe::{header, text};
use crate::project::VERSION;

const HEADER: &str = include_str!("law.h");
const FUNCTIONS: &str = include_str!("law.c");

/// Most bytes of an instance beside the memory of the model: whether it is broken, globals, and what aligns the memory.
const BESIDE: u32 = 32;

/// Text of the header about the stack. It is left out if a function calls itself, as a quadrature does: then no bound is
/// known.
const STACK: &str = "\
/** Bytes of the program's own stack that a call needs, estimated from the longest chain of calls. For LuGre it is more
 * than gcc 12 takes without optimisation. */
#define LAW_STACK BYTESu

";

/// Text of the header about the only law of a model that has a choice.
const LAW: &str =
    " * Friction: These sources contain one law, NAME. After law_create, law_reset and presets that say nothing else
 * LAW_VARIABLE is NUMBER, NAME. It can be set to 1, no friction, and to NUMBER; any other value, and a state with
 * another one, are refused.
 *
";

/// The stack is an estimate, in multiples of so many bytes.
const STACK_UNIT: u32 = 256;

/// The files of a model by name.
pub fn files(
    model: &ModelType,
    law: Option<OnlyLaw>,
    name: &str,
    origin: &str,
    library: &[u8],
) -> Result<BTreeMap<String, String>> {
    let Program { text, memory, stack } = program::of(library, &called(FUNCTIONS), false)?;
    let stack = stack.map(|bytes| STACK.replace("BYTES", &bytes.next_multiple_of(STACK_UNIT).to_string()));
    let constant = |wanted: fn(&Variable) -> bool| {
        let found = model.table.iter().find(|variable| !variable.is_hidden && wanted(variable));
        found.map(|variable| header::constant(&variable))
    };
    // A model may have no input: then the example in the header sets a parameter.
    let input = constant(|variable| variable.role == Role::Input)
        .or_else(|| constant(|variable| variable.role == Role::Tunable))
        .context("nothing can be set")?;
    let output = constant(|variable| variable.role == Role::Output).context("a model has outputs")?;
    let header = HEADER
        .replace("TITLE", &format!("{}: {}", model.name, model.summary))
        .replace("ORIGIN", origin)
        .replace("VERSION_TEXT", VERSION)
        .replace("ONLY\n", &law.map(|law| only(model, law)).unwrap_or_default())
        .replace("MEMORY_BYTES", &(memory + BESIDE).to_string())
        .replace("STACK\n", &stack.unwrap_or_default())
        .replace("STATE_BYTES", &serial::size(model).to_string())
        .replace("FIRST_INPUT", &format!("LAW_{input}"))
        .replace("FIRST_OUTPUT", &format!("LAW_{output}"));
    let variables = with_law(model, law, header::of_model(model, name)?)?;
    let header = named(&header, name).replace("VARIABLES\n", &variables);
    let includes = format!("#include \"{name}.h\"\n\n");
    let source = beginning(model.name, origin, &INCLUDES) + &includes + &text + "\n" + &named(FUNCTIONS, name);
    Ok(BTreeMap::from([(format!("{name}.h"), header), (format!("{name}.c"), source)]))
}

/// Paragraph of the header about the only law.
fn only(model: &ModelType, law: OnlyLaw) -> String {
    let text = LAW.replace("NAME", law.name).replace("VARIABLE", &header::constant(&law.variable(model)));
    text.replace("NUMBER", &law.number.to_string())
}

/// The variables, of which that with the choice begins with the only law.
fn with_law(model: &ModelType, law: Option<OnlyLaw>, variables: String) -> Result<String> {
    let Some(law) = law else { return Ok(variables) };
    let start = format!("default {}", text::start(&law.variable(model)));
    ensure!(variables.matches(&start).count() == 1, "{}: not one variable has the {start}", model.name);
    Ok(variables.replace(&start, &format!("default {}", law.name)))
}

/// A text in which the name of the model stands for "law".
fn named(text: &str, name: &str) -> String {
    let upper = name.to_uppercase();
    let pairs = [
        ("LAW_", format!("{upper}_")),
        ("law_", format!("{name}_")),
        ("law.h", format!("{name}.h")),
        ("struct law law;", format!("struct {name} {name};")),
        ("struct law", format!("struct {name}")),
        ("law *", format!("{name} *")),
    ];
    pairs.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::root;
    use std::fs;

    /// Names and numbers of the lines `<prefix><NAME> = <number>,` of an enumeration, names in capitals without underscores.
    fn numbers(text: &str, begin: &str, prefix: &str) -> BTreeMap<String, u32> {
        let (_, enumeration) = text.split_once(begin).expect("the enumeration");
        let (enumeration, _) = enumeration.split_once('}').expect("its end");
        let lines = enumeration.lines().filter_map(|line| line.trim().trim_end_matches(',').split_once(" = "));
        let items = lines.filter_map(|(name, number)| Some((name.strip_prefix(prefix)?, number.parse().ok()?)));
        items.map(|(name, number)| (name.replace('_', "").to_uppercase(), number)).collect()
    }

    /// Statuses are numbers between the module, the C sources and the library.
    #[test]
    fn statuses_have_the_numbers_of_the_library() {
        let read = |file: &str| fs::read_to_string(root().join(file)).expect(file);
        let library = numbers(&read("include/stribeck.h"), "typedef enum {", "STRIBECK_");
        assert_eq!(library.len(), 10);
        let module = numbers(&read("sources/src/state.rs"), "pub enum Status", "");
        assert_eq!(module.len(), 9);
        for (name, number) in &module {
            assert_eq!(library.get(name), Some(number), "{name} of the module");
        }
        let header = numbers(HEADER, "typedef enum law_status", "LAW_");
        assert_eq!(header.len(), 10);
        for (name, number) in &header {
            let known = if name == "UNKNOWNPRESET" { "UNKNOWNMODEL" } else { name };
            match library.get(known) {
                Some(of_library) => assert_eq!(number, of_library, "{name} of the header"),
                None => assert!(name == "OTHERARITHMETIC" && !library.values().any(|taken| taken == number), "{name}"),
            }
        }
        let [refused, internal] = ["REFUSEDVALUE", "INTERNAL"].map(|name| library[name]);
        let of_fmus = format!("enum {{ OK, REFUSED_VALUE = {refused}, INTERNAL = {internal} }};");
        assert!(include_str!("fmi.c").contains(&of_fmus));
    }
}
