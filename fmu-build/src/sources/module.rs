//! A WebAssembly module as it is read, and the rules that it must keep to become C.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, bail, ensure};
use wasmparser::{
    ConstExpr, Data, DataKind, Element, ElementItems, ElementKind, ExternalKind, FuncType, FunctionBody, KnownCustom,
    Name, NameSectionReader, Operator, Parser, Payload,
};

use super::links::{Links, Part};

/// Largest alignment in the memory of a module.
pub const ALIGNMENT: u32 = 16;

/// Start of the heap, as the linker names it: from here on nothing is used, because the module has its own room.
const END: &str = "__heap_base";

/// A module without imports, whose memory does not grow.
#[derive(Default)]
pub struct Module<'a> {
    /// Types of functions.
    pub types: Vec<FuncType>,
    /// Numbers of the types of the functions.
    pub functions: Vec<u32>,
    /// Bodies of the functions.
    pub bodies: Vec<FunctionBody<'a>>,
    /// Start values of the globals, all of them i32.
    pub globals: Vec<u32>,
    pub data: Vec<Part<'a>>,
    pub links: Links,
    /// Functions that are called by number: number and function.
    pub table: BTreeMap<u32, u32>,
    /// The function through which Rust writes all formatted texts.
    pub writer: Option<u32>,
    /// Functions that only that one calls, by number: those that format a value.
    pub formatters: BTreeSet<u32>,
    /// Exported functions by name.
    pub exports: BTreeMap<String, u32>,
    end: Option<u32>,
}

impl<'a> Module<'a> {
    /// Reads a module.
    pub fn of(bytes: &'a [u8]) -> Result<Module<'a>> {
        let mut module = Module::default();
        for payload in Parser::new(0).parse_all(bytes) {
            let payload = payload.context("not a WebAssembly module")?;
            if let Some((_, range)) = payload.as_section() {
                module.links.begin_section(range.start);
            }
            module.add(payload)?;
        }
        ensure!(module.functions.len() == module.bodies.len(), "a function has no body");
        ensure!(!module.links.is_empty(), "the linker has not listed what refers to data and functions");
        Ok(module)
    }

    /// The type of a function.
    pub fn type_of(&self, function: u32) -> &FuncType {
        &self.types[self.functions[function as usize] as usize]
    }

    /// The first of the types that are the same as this one.
    pub fn kind_of(&self, kind: u32) -> u32 {
        let wanted = &self.types[kind as usize];
        self.types.iter().position(|kind| kind == wanted).map_or(kind, |at| at as u32)
    }

    /// Bytes of the memory that are used.
    pub fn memory(&self) -> Result<u32> {
        let end = self.end.with_context(|| format!("the module does not export {END}"))?;
        Ok(self.globals[end as usize].next_multiple_of(ALIGNMENT))
    }

    fn add(&mut self, payload: Payload<'a>) -> Result<()> {
        match payload {
            Payload::TypeSection(types) => {
                self.types = types.into_iter_err_on_gc_types().collect::<Result<_, _>>()?;
            }
            Payload::ImportSection(imports) => ensure!(imports.count() == 0, "the module imports something"),
            Payload::FunctionSection(functions) => self.functions = functions.into_iter().collect::<Result<_, _>>()?,
            Payload::GlobalSection(globals) => {
                for global in globals {
                    self.globals.push(constant(&global?.init_expr)?);
                }
            }
            Payload::ExportSection(exports) => {
                for export in exports {
                    let export = export?;
                    match export.kind {
                        ExternalKind::Func => drop(self.exports.insert(export.name.to_owned(), export.index)),
                        ExternalKind::Global if export.name == END => self.end = Some(export.index),
                        _ => {}
                    }
                }
            }
            Payload::StartSection { .. } => bail!("the module has a start function"),
            Payload::ElementSection(elements) => {
                for element in elements {
                    self.add_element(&element?)?;
                }
            }
            Payload::DataSection(data) => {
                for data in data {
                    self.add_data(&data?)?;
                }
            }
            Payload::CustomSection(section) => match section.as_known() {
                KnownCustom::Name(names) => self.add_names(names)?,
                other => self.links.add(other, &self.data)?,
            },
            Payload::CodeSectionEntry(body) => self.bodies.push(body),
            _ => {}
        }
        Ok(())
    }

    /// Looks for the functions that write texts: `core::fmt::write`, and `fmt` of the traits of `core::fmt`, as rustc
    /// mangles them in one way or the other.
    fn add_names(&mut self, names: NameSectionReader) -> Result<()> {
        for name in names {
            if let Name::Function(functions) = name? {
                for function in functions {
                    let function = function?;
                    if function.name.ends_with("4core3fmt5write") {
                        self.writer = Some(function.index);
                    }
                    let is_trait = ["3fmt7Display", "3fmt5Debug", "3fmt8LowerExp", "core..fmt..", "4core3fmt"];
                    let is_method = ["3fmt", "3fmt17h", "3fmtB"].iter().any(|end| {
                        let name = function.name.rsplit_once(end);
                        name.is_some_and(|(_, hash)| hash.len() <= 18)
                    });
                    if is_method || is_trait.iter().any(|part| function.name.contains(part)) {
                        self.formatters.insert(function.index);
                    }
                }
            }
        }
        Ok(())
    }

    fn add_data(&mut self, data: &Data<'a>) -> Result<()> {
        let DataKind::Active { memory_index: 0, offset_expr } = &data.kind else {
            bail!("data that are copied later are not supported");
        };
        let place = data.range.end - data.data.len() as u64;
        self.data.push(Part { address: constant(offset_expr)?, place, bytes: data.data });
        Ok(())
    }

    fn add_element(&mut self, element: &Element) -> Result<()> {
        let ElementKind::Active { offset_expr, .. } = &element.kind else {
            bail!("tables that are filled later are not supported");
        };
        let ElementItems::Functions(functions) = &element.items else {
            bail!("tables of anything but functions are not supported");
        };
        for (number, function) in (constant(offset_expr)?..).zip(functions.clone()) {
            self.table.insert(number, function?);
        }
        Ok(())
    }
}

/// A start value, which must be a number.
fn constant(expression: &ConstExpr) -> Result<u32> {
    match expression.get_operators_reader().read()? {
        Operator::I32Const { value } => Ok(value as u32),
        other => bail!("the start value {other:?} is not supported"),
    }
}
