//! The functions of a module that some of its exports need, as C.

use std::collections::BTreeSet;
use std::fmt::Write;

use anyhow::{Context, Result};

use super::function::{self, Function};
use super::module::Module;

/// The runtime, in C.
const RUNTIME: &str = include_str!("runtime.c");

/// Bytes of a line of data.
const LINE: usize = 32;

/// Functions of a module as C.
pub struct Program {
    /// The text, with `static` functions only: `create_module` and the exports.
    pub text: String,
    /// Bytes of the module's memory.
    pub memory: u32,
}

/// The functions that a module exports under these names, and those that they need.
pub fn of(bytes: &[u8], exports: &[String], with_texts: bool) -> Result<Program> {
    let module = Module::of(bytes)?;
    let mut roots = Vec::new();
    for name in exports {
        roots.push(*module.exports.get(name).with_context(|| format!("the module does not export {name}"))?);
    }
    let functions = needed(&module, &roots, with_texts)?;
    let memory = module.memory()?;
    let mut text = structure(&module, memory)?;
    text.push_str(RUNTIME);
    text.push('\n');
    for (at, _) in &functions {
        // Within a function that calls setjmp every variable would be kept in memory.
        let apart = if roots.contains(at) { "APART " } else { "" };
        writeln!(text, "{apart}static {};", function::signature(&module, *at, false)?)?;
    }
    text.push_str(&table(&module, &functions)?);
    for (_, body) in &functions {
        text.push('\n');
        text.push_str(body);
    }
    text.push_str(&creation(&module)?);
    for (name, at) in exports.iter().zip(roots) {
        writeln!(text, "#define {name} {}", function::name(at))?;
    }
    Ok(Program { text, memory })
}

/// The translated functions that these need: those that they call, and those of the types that are called by number. Without
/// texts the function that writes them writes nothing, and its callers take that for success. Nobody reads what a panic
/// says.
fn needed(module: &Module, roots: &[u32], with_texts: bool) -> Result<Vec<(u32, String)>> {
    let (mut found, mut kinds, mut waiting) = (BTreeSet::new(), BTreeSet::new(), roots.to_vec());
    let silent = if with_texts { None } else { Some(module.writer.context("no function writes texts")?) };
    let mut functions = Vec::new();
    while let Some(at) = waiting.pop() {
        if !found.insert(at) {
            continue;
        }
        if silent == Some(at) || module.panics.contains(&at) {
            let end = if silent == Some(at) { "return 0" } else { "trap(m)" };
            functions.push((at, cut_short(module, at, end)?));
            continue;
        }
        let (function, text) = Function::of(module, at)?;
        waiting.extend(&function.calls);
        for kind in function.calls_by_number {
            if kinds.insert(kind) {
                let is_of = |at: &&u32| {
                    let is_silent = silent.is_some() && module.formatters.contains(*at);
                    !is_silent && module.kind_of(module.functions[**at as usize]) == kind
                };
                waiting.extend(module.table.values().filter(is_of));
            }
        }
        functions.push((at, text));
    }
    functions.sort_by_key(|(at, _)| *at);
    Ok(functions)
}

/// A function that ends at once.
fn cut_short(module: &Module, at: u32, end: &str) -> Result<String> {
    let arguments = module.type_of(at).params().len();
    let ignored: String = (0..arguments).map(|at| format!("  (void)l{at};\n")).collect();
    Ok(format!("static {} {{\n  (void)m;\n{ignored}  {end};\n}}\n", function::signature(module, at, true)?))
}

fn structure(module: &Module, memory: u32) -> Result<String> {
    let stack = module.globals.first().context("the module has no stack")?;
    let mut text = format!(
        "/* Bytes of the memory, and of the stack at its beginning. */\n#define MEMORY_SIZE {memory}u\n\
         #define STACK_SIZE {stack}u\n\n/* An instance of the model. */\nstruct module {{\n  jmp_buf way_out;\n  \
         int is_broken;\n"
    );
    for at in 0..module.globals.len() {
        writeln!(text, "  uint32_t g{at};")?;
    }
    text.push_str("  /* It aligns what follows. */\n  double alignment;\n  uint8_t memory[MEMORY_SIZE];\n};\n\n");
    Ok(text)
}

/// The functions that are called by number, with the numbers of their types.
fn table(module: &Module, functions: &[(u32, String)]) -> Result<String> {
    let is_there = |function: &u32| functions.binary_search_by_key(function, |(at, _)| *at).is_ok();
    let last = module.table.iter().filter(|(_, function)| is_there(function)).map(|(number, _)| *number).max();
    let mut text = String::from(
        "\ntypedef void (*function)(void);\n\nstatic const struct {\n  function call;\n  u32 kind;\n} functions[] = {\n",
    );
    for number in 0..=last.unwrap_or(0) {
        match module.table.get(&number).filter(|function| is_there(function)) {
            Some(at) => {
                let kind = module.kind_of(module.functions[*at as usize]);
                writeln!(text, "  {{(function){}, {kind}u}},", function::name(*at))?;
            }
            None => text.push_str("  {NULL, 0u},\n"),
        }
    }
    text.push_str(
        "};\n\n/* The function with this number, if it has this type. */\n\
         static inline function by_number(struct module *m, u32 number, u32 kind) {\n  \
         if (number >= sizeof functions / sizeof functions[0] || functions[number].call == NULL ||\n      \
         functions[number].kind != kind)\n    trap(m);\n  return functions[number].call;\n}\n",
    );
    Ok(text)
}

/// The memory as it is at first.
fn creation(module: &Module) -> Result<String> {
    let mut text = String::new();
    for (at, (_, data)) in module.data.iter().enumerate() {
        write!(text, "\nstatic const u8 data{at}[] = {{")?;
        for line in data.chunks(LINE) {
            let bytes: Vec<String> = line.iter().map(u8::to_string).collect();
            write!(text, "\n  {},", bytes.join(","))?;
        }
        text.push_str("\n};\n");
    }
    text.push_str("\nSELDOM static void create_module(struct module *m) {\n  memset(m, 0, sizeof *m);\n");
    for (at, value) in module.globals.iter().enumerate() {
        writeln!(text, "  m->g{at} = {value}u;")?;
    }
    for (at, (address, _)) in module.data.iter().enumerate() {
        writeln!(text, "  memcpy(m->memory + {address}u, data{at}, sizeof data{at});")?;
    }
    text.push_str("}\n\n");
    Ok(text)
}
