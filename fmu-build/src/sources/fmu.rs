//! The source of an FMU: one file, with the functions of FMI 2.0.

use std::collections::BTreeMap;
use std::fmt::Write;

use anyhow::Result;
use stribeck::model::ModelType;
use stribeck_ffi::fmi2::lifecycle::{ALLOWED, Purpose, STATES};
use stribeck_ffi::fmi2::log::{ALL, Category, DISCARD, ERROR, WARNING};

use super::{INCLUDES, beginning, called, program};

const FUNCTIONS: &str = include_str!("fmi2.c");

/// The files of a model by name.
pub fn files(model: &ModelType, origin: &str, library: &[u8]) -> Result<BTreeMap<String, String>> {
    let program = program::of(library, &called(FUNCTIONS), true)?;
    let includes: Vec<&str> = INCLUDES.into_iter().chain(["stdio.h", "stdlib.h"]).collect();
    let text = beginning(model.name, origin, &includes) + &program.text + "\n" + &facts(model)? + FUNCTIONS;
    Ok(BTreeMap::from([(format!("{}.c", model.name), text)]))
}

/// Facts that the functions of FMI need: the model, its states, and which function may be called in which of them.
fn facts(model: &ModelType) -> Result<String> {
    let mut text = format!("#define MODEL_GUID \"{}\"\n", model.guid());
    writeln!(text, "#define HAS_RATES {}", u8::from(model.model_exchange))?;
    for (name, category) in [("WARNING", &WARNING), ("DISCARD", &DISCARD), ("ERROR", &ERROR), ("ALL", &ALL)] {
        let Category { name: value, .. } = category;
        writeln!(text, "#define CATEGORY_{name} \"{}\"", value.to_str()?)?;
    }
    let names: Vec<String> = STATES.iter().map(|state| format!("{state:?}")).collect();
    writeln!(text, "\nenum state {{ {} }};\n", names.join(", "))?;
    writeln!(text, "static const char *const states[] = {{\"{}\"}};\n", names.join("\", \""))?;
    let calls: Vec<_> = ALLOWED.iter().filter(|(call, ..)| call.is_for(Purpose::CoSimulation)).collect();
    let names: Vec<String> = calls.iter().map(|(call, ..)| format!("{call:?}")).collect();
    writeln!(text, "enum call {{\n  {}\n}};\n", names.join(",\n  "))?;
    text.push_str("/* Functions, and whether they may be called in each of the states. */\n");
    writeln!(text, "static const struct {{\n  const char *name;\n  unsigned char is_allowed[{}];", STATES.len())?;
    text.push_str("} calls[] = {\n");
    for (call, _, allowed) in calls {
        let allowed: Vec<String> = allowed.iter().map(|may| u8::from(*may).to_string()).collect();
        writeln!(text, "  {{\"{call:?}\", {{{}}}}},", allowed.join(", "))?;
    }
    text.push_str("};\n\n");
    Ok(text)
}
