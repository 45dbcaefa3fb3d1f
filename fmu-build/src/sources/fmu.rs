//! The source of an FMU: one file, with the functions of FMI 2.0 or 3.0.

use std::collections::BTreeMap;
use std::fmt::{Debug, Write};

use anyhow::{Context, Result, ensure};
use stribeck::arrays::{self, Array, Size};
use stribeck::model::ModelType;
use stribeck::reference::{self, Reference};
use stribeck::serial;
use stribeck_ffi::fmi2::lifecycle as two;
use stribeck_ffi::fmi2::log::{ALL, Category, DISCARD, ERROR, WARNING};
use stribeck_ffi::fmi3::lifecycle as three;

use super::{INCLUDES, beginning, called, program};
use crate::describe::interface::Version;

/// C that both versions have in common. Each of them has its types before it, and its functions after it.
const COMMON: &str = include_str!("fmi.c");
const TWO: [&str; 2] = [include_str!("fmi2.h"), include_str!("fmi2.c")];
const THREE: [&str; 2] = [include_str!("fmi3.h"), include_str!("fmi3.c")];

/// Most sizes of arrays that a model has: see `SIZES` in `sources/src/state.rs`.
const SIZES: usize = 4;

/// The files of a model by name.
pub fn files(model: &ModelType, version: Version, origin: &str, library: &[u8]) -> Result<BTreeMap<String, String>> {
    let [types, functions] = if version == Version::Three { THREE } else { TWO };
    let text = [types, COMMON, functions].join("\n");
    let program = program::of(library, &called(&text), true)?;
    let facts = match version {
        Version::Two => of_states(&two::STATES.map(is_two), 0) + &of_calls(&calls_of_two()) + &of_sizes(model, &[])?,
        Version::Three => {
            let arrays = arrays::of(model).ok().context("out of memory")?;
            let of_states = of_states(&three::STATES.map(is_three), three::FIRST_NUMBER);
            let sizes = sizes_of(&arrays);
            of_states + &of_calls(&calls_of_three()) + &of_sizes(model, &sizes)? + &of_arrays(model, &arrays, &sizes)?
        }
    };
    let includes: Vec<&str> = INCLUDES.into_iter().chain(["stdbool.h", "stdio.h", "stdlib.h"]).collect();
    let facts = of_model(model)? + &facts;
    let text = [beginning(model.name, origin, &includes), program.text, facts, text].join("\n");
    Ok(BTreeMap::from([(format!("{}.c", model.name), text)]))
}

fn of_model(model: &ModelType) -> Result<String> {
    let mut text = format!("#define MODEL_NAME \"{}\"\n#define MODEL_GUID \"{}\"\n", model.name, model.guid());
    writeln!(text, "#define HAS_RATES {}", u8::from(model.model_exchange))?;
    for (name, category) in [("WARNING", &WARNING), ("DISCARD", &DISCARD), ("ERROR", &ERROR), ("ALL", &ALL)] {
        let Category { name: value, .. } = category;
        writeln!(text, "#define CATEGORY_{name} \"{}\"", value.to_str()?)?;
    }
    Ok(text)
}

/// A state or function by name, and whether it is reached, or in which states it is allowed.
type Named<T> = (String, T);

fn named<T>(name: impl Debug, value: T) -> Named<T> {
    (format!("{name:?}"), value)
}

fn is_two(state: two::State) -> Named<bool> {
    named(state, state.is_for(two::Purpose::CoSimulation))
}

/// There is no Event Mode, and nothing is shown within a step.
fn is_three(state: three::State) -> Named<bool> {
    let is_left_out = matches!(state, three::State::EventMode | three::State::IntermediateUpdateMode);
    named(state, state.is_for(three::Purpose::CoSimulation) && !is_left_out)
}

/// The functions that an FMU for co-simulation has.
fn calls_of_two() -> Vec<Named<Vec<bool>>> {
    let calls = two::ALLOWED.iter().filter(|(call, ..)| call.is_for(two::Purpose::CoSimulation));
    calls.map(|(call, _, allowed)| named(call, allowed.to_vec())).collect()
}

/// All functions: those of Model Exchange exist, but are not allowed.
fn calls_of_three() -> Vec<Named<Vec<bool>>> {
    let calls = three::ALLOWED.iter();
    let allowed = |call: three::Call, may: bool| may && call.is_for(three::Purpose::CoSimulation);
    calls.map(|(call, _, states)| named(call, states.map(|may| allowed(*call, may)).to_vec())).collect()
}

fn of_states(states: &[Named<bool>], first: usize) -> String {
    let names: Vec<&str> = states.iter().map(|(name, _)| name.as_str()).collect();
    let reached: Vec<String> = states.iter().map(|(_, is_reached)| u8::from(*is_reached).to_string()).collect();
    format!(
        "\nenum state {{ {}, STATES }};\n\nstatic const char *const states[] = {{\"{}\"}};\n\n/* Whether an instance can be \
         in these states, and the number of the first one in a saved state. */\nstatic const unsigned char is_reached[] = \
         {{{}}};\n#define FIRST_STATE {first}\n\n",
        names.join(", "),
        names.join("\", \""),
        reached.join(", "),
    )
}

/// Functions, and in which states they may be called.
fn of_calls(calls: &[Named<Vec<bool>>]) -> String {
    let names: Vec<&str> = calls.iter().map(|(name, _)| name.as_str()).collect();
    let states = calls.first().map_or(0, |(_, allowed)| allowed.len());
    let mut text = format!(
        "enum call {{\n  {}\n}};\n\n/* Functions, and whether they may be called in each of the states. */\nstatic const struct \
         {{\n  const char *name;\n  unsigned char is_allowed[{states}];\n}} calls[] = {{\n",
        names.join(",\n  ")
    );
    for (name, allowed) in calls {
        let allowed: Vec<String> = allowed.iter().map(|may| u8::from(*may).to_string()).collect();
        text.push_str(&format!("  {{\"{name}\", {{{}}}}},\n", allowed.join(", ")));
    }
    text + "};\n\n"
}

/// Different sizes of the arrays.
fn sizes_of(arrays: &[Array]) -> Vec<Size> {
    let mut sizes: Vec<Size> = Vec::new();
    for size in arrays.iter().filter_map(|array| array.size) {
        if sizes.iter().all(|other| other.reference() != size.reference()) {
            sizes.push(size);
        }
    }
    sizes
}

/// The sizes of arrays. As all lists, it ends with an entry that does not count: no list of C is empty.
fn of_sizes(model: &ModelType, sizes: &[Size]) -> Result<String> {
    ensure!(sizes.len() <= SIZES, "{} has {} sizes of arrays, more than {SIZES}", model.name, sizes.len());
    let mut text =
        format!("#define SIZES {}\n#define STATE_SIZE {}u\n\n", sizes.len(), serial::size_with(model, sizes.len()));
    text.push_str("/* Sizes of arrays, and the numbers of their elements in use, by their references and names. */\n");
    text.push_str("static const struct {\n  uint32_t reference, in_use;\n  double most;\n");
    text.push_str("  const char *name, *name_in_use;\n} sizes[] = {\n");
    for size in sizes {
        let (in_use, name) = (model.reference(size.in_use), model.table.at(size.in_use).path);
        writeln!(text, "  {{{}u, {in_use}u, {}.0, \"{size}\", \"{name}\"}},", size.reference(), size.most)?;
    }
    Ok(text + "  {0u, 0u, 0.0, NULL, NULL}};\n\n")
}

/// The arrays: variables of the model that differ by an index, and the derivatives of states that do.
fn of_arrays(model: &ModelType, arrays: &[Array], sizes: &[Size]) -> Result<String> {
    let (mut elements, mut rows) = (Vec::new(), Vec::new());
    for array in arrays {
        let size = array.size.and_then(|size| sizes.iter().position(|other| other.reference() == size.reference()));
        let size = size.map_or("-1".to_owned(), |place| place.to_string());
        let row = |reference: Reference, first: usize| {
            format!("  {{{reference}u, {first}, {}, {size}}},\n", array.columns.len())
        };
        rows.push(row(array.reference(), elements.len()));
        elements.extend(array.columns.iter().map(|column| model.reference(*column)));
        if model.model_exchange && model.table.at(array.columns[0]).is_continuous_state() {
            rows.push(row(array.derivative_reference(), elements.len()));
            let of_derivative = |column: &usize| reference::of_derivative(&model.table.at(*column).path);
            elements.extend(array.columns.iter().map(of_derivative));
        }
    }
    let mut text =
        String::from("/* References of the elements of arrays, and where the elements of an array begin. */\n");
    writeln!(text, "#define ELEMENTS {}\nstatic const uint32_t elements[] = {{", elements.len())?;
    elements.iter().for_each(|reference| text.push_str(&format!("  {reference}u,\n")));
    writeln!(text, "  0u}};\n\n#define ARRAYS {}\nstatic const struct {{", rows.len())?;
    text.push_str("  uint32_t reference;\n  size_t first, most;\n  int size;\n} arrays[] = {\n");
    Ok(text + &rows.concat() + "  {0u, 0, 0, -1}};\n\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::root;
    use std::fs;

    #[test]
    fn the_module_has_room_for_as_many_sizes() {
        let text = fs::read_to_string(root().join("sources/src/state.rs")).expect("the state of the module");
        assert!(text.contains(&format!("const SIZES: usize = {SIZES};")));
    }
}
