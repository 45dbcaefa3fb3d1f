//! The functions of a module that some of its exports need, as C.

use std::collections::BTreeMap;
use std::fmt::Write;

use anyhow::{Context, Result};

use super::function::{self, Function};
use super::graph::Graph;
use super::kind::Kind;
use super::memory;
use super::module::{ALIGNMENT, Module};

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
    /// Bytes of C's stack that a call needs at most, estimated; none if functions call themselves.
    pub stack: Option<u32>,
}

/// The functions that a module exports under these names, and those that they need.
pub fn of(bytes: &[u8], exports: &[String], with_texts: bool) -> Result<Program> {
    let module = Module::of(bytes)?;
    let mut roots = Vec::new();
    for name in exports {
        roots.push(*module.exports.get(name).with_context(|| format!("the module does not export {name}"))?);
    }
    let graph = Graph::of(&module, &roots, with_texts)?;
    let layout = Layout::of(&module, graph.stack(&roots))?;
    let mut text = layout.text(&module)?;
    text.push_str(RUNTIME);
    text.push('\n');
    for function in graph.functions.keys() {
        writeln!(text, "static {};", function::signature(&module, *function, false)?)?;
    }
    for (kind, functions) in graph.by_number() {
        text.push_str(&by_number(&module, kind, &functions)?);
    }
    let rules = graph.rules(layout.is_bounded);
    for function in graph.functions.keys() {
        text.push('\n');
        text.push_str(&match graph.end_of(*function) {
            Some(end) => cut_short(&module, *function, end)?,
            None => Function::of(&module, *function, &rules)?.1,
        });
    }
    text.push_str(&creation(&module, &graph, &layout)?);
    for (name, at) in exports.iter().zip(&roots) {
        writeln!(text, "#define {name} {}", function::name(*at))?;
    }
    Ok(Program { text, memory: layout.size(), stack: graph.stack_of_c(&roots) })
}

/// Statements that keep compilers from warning of arguments that are not used.
fn ignored(arguments: usize) -> String {
    (0..arguments).map(|at| format!("  (void)l{at};\n")).collect()
}

/// A function that ends at once.
fn cut_short(module: &Module, at: u32, end: &str) -> Result<String> {
    let ignored = ignored(module.type_of(at).params().len());
    Ok(format!("static {} {{\n  (void)m;\n{ignored}  {end}\n}}\n", function::signature(module, at, true)?))
}

/// The memory of an instance: the end of the stack, as far as it is needed, and the data behind it.
struct Layout {
    /// Bytes of the stack.
    stack: u32,
    /// Bytes of it that are needed.
    needed: u32,
    /// Whether no chain of calls needs more.
    is_bounded: bool,
    /// End of the data.
    end: u32,
}

impl Layout {
    fn of(module: &Module, needed: Option<u32>) -> Result<Layout> {
        let stack = *module.globals.first().context("the module has no stack")?;
        let is_bounded = needed.is_some_and(|needed| needed <= stack);
        let needed = needed.unwrap_or(stack).min(stack).next_multiple_of(ALIGNMENT);
        Ok(Layout { stack, needed, is_bounded, end: module.memory()? })
    }

    /// Bytes of the memory.
    fn size(&self) -> u32 {
        self.end - self.unused()
    }

    /// Bytes at the beginning of the stack that are never used.
    fn unused(&self) -> u32 {
        self.stack - self.needed
    }

    fn text(&self, module: &Module) -> Result<String> {
        let (size, stack, unused) = (self.size(), self.stack, self.unused());
        let mut text = format!(
            "/* Bytes of the memory, and address of its first byte; the stack ends at {stack}. */\n\
             #define MEMORY_SIZE {size}u\n#define MEMORY_BEGIN {unused}u\n#define STACK_END {stack}u\n\n\
             /* An instance of the model. */\nstruct module {{\n  int is_broken;\n"
        );
        for at in 0..module.globals.len() {
            writeln!(text, "  uint32_t g{at};")?;
        }
        text.push_str("  /* It aligns what follows. */\n  double alignment;\n  uint8_t memory[MEMORY_SIZE];\n};\n\n");
        Ok(text)
    }
}

/// The C function that calls a function of a type by its number.
fn by_number(module: &Module, kind: u32, functions: &BTreeMap<u32, u32>) -> Result<String> {
    let function = &module.types[kind as usize];
    let result = function.results().first().map_or(Ok("void"), |kind| Kind::of(*kind).map(Kind::c))?;
    let (mut arguments, mut passed) = (String::from("struct module *m"), String::from("m"));
    for (at, kind) in function.params().iter().enumerate() {
        write!(arguments, ", {} l{at}", Kind::of(*kind)?.c())?;
        write!(passed, ", l{at}")?;
    }
    let name = function::name_of_kind(kind);
    let mut text = format!("\nstatic {result} {name}({arguments}, u32 number) {{\n");
    text.push_str(&ignored(function.params().len()));
    text.push_str("  switch (number) {\n");
    for (number, function) in functions {
        let call = format!("{}({passed})", function::name(*function));
        let call = if result == "void" { format!("{call};\n    return") } else { format!("return {call}") };
        writeln!(text, "  case {number}:\n    {call};")?;
    }
    let end = if result == "void" { "return" } else { "return 0" };
    writeln!(text, "  default:\n    trap(m);\n    {end};\n  }}\n}}")?;
    Ok(text)
}

/// The memory as it is at first.
fn creation(module: &Module, graph: &Graph, layout: &Layout) -> Result<String> {
    let data = memory::pieces(module, &graph.targets);
    let mut text =
        String::from("\n/* Addresses of the parts of the memory that are not zero at first, and their bytes. */");
    text.push_str("\nstatic const u32 parts[][2] = {\n");
    for (address, bytes) in &data {
        let place = address.checked_sub(layout.unused()).context("data before the stack")?;
        writeln!(text, "  {{{place}u, {}u}},", bytes.len())?;
    }
    text.push_str("};\n\nstatic const u8 data[] = {");
    let bytes: Vec<u8> = data.into_iter().flat_map(|(_, bytes)| bytes).collect();
    for line in bytes.chunks(LINE) {
        let bytes: Vec<String> = line.iter().map(u8::to_string).collect();
        write!(text, "\n  {},", bytes.join(","))?;
    }
    text.push_str(
        "\n};\n\nSELDOM static void create_module(struct module *m) {\n  const u8 *from = data;\n  size_t at;\n",
    );
    text.push_str("  memset(m, 0, sizeof *m);\n");
    for (at, value) in module.globals.iter().enumerate() {
        writeln!(text, "  m->g{at} = {value}u;")?;
    }
    text.push_str("  for (at = 0; at < sizeof parts / sizeof *parts; at++) {\n");
    text.push_str("    memcpy(m->memory + parts[at][0], from, parts[at][1]);\n    from += parts[at][1];\n  }\n}\n\n");
    Ok(text)
}
