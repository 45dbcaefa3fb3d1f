//! A function of WebAssembly as a function of C.
//!
//! Blocks become labels, and branches jumps to them. What a block leaves is in the variable of its place. A trap marks the
//! instance as broken and returns; whoever has called a function that may trap looks, and returns too.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::mem;

use anyhow::{Context, Result, bail, ensure};
use wasmparser::{BrTable, Operator};

use super::frame::{Frame, FrameSearch};
use super::kind::Kind;
use super::links::Target;
use super::module::Module;
use super::operators::{division, expression, load, store};
use super::stack::{Operand, Stack};

/// A block that has not ended.
struct Block {
    label: usize,
    is_loop: bool,
    is_if: bool,
    /// Number of operands before it.
    height: usize,
    result: Option<Kind>,
    is_target: bool,
}

/// Facts about all functions of a program, which decide what a function must check.
#[derive(Default)]
pub struct Rules {
    /// Functions that may trap.
    pub traps: BTreeSet<u32>,
    /// Functions that never return: a call of one is a trap.
    pub endless: BTreeSet<u32>,
    /// Whether the stack is large enough for every chain of calls.
    pub has_stack_for_all: bool,
}

/// A function as it is written.
pub struct Function<'a> {
    module: &'a Module<'a>,
    rules: &'a Rules,
    stack: Stack,
    locals: Vec<Kind>,
    blocks: Vec<Block>,
    labels: usize,
    /// Number of blocks within code that is never reached, if we are there.
    skipped: Option<usize>,
    /// Statement in C that follows a trap.
    exit: &'static str,
    /// Needs of the statements since the last jump, label or brace.
    recent: Needs,
    pub facts: Facts,
}

/// Functions and addresses that statements need.
#[derive(Default)]
pub struct Needs {
    /// Functions that are called.
    pub functions: BTreeSet<u32>,
    /// Types of the functions that are called by number.
    pub kinds: BTreeSet<u32>,
    /// Data and functions whose address is used.
    pub targets: BTreeSet<Target>,
}

impl Needs {
    fn append(&mut self, mut others: Needs) {
        self.functions.append(&mut others.functions);
        self.kinds.append(&mut others.kinds);
        self.targets.append(&mut others.targets);
    }
}

/// Facts about a function that its callers need to know.
#[derive(Default)]
pub struct Facts {
    pub needs: Needs,
    /// Whether it traps by itself, the stack apart.
    pub traps: bool,
    /// Whether it ever returns.
    pub returns: bool,
    /// Bytes of the stack that it takes.
    pub frame: Frame,
    /// Number of its variables in C.
    pub variables: usize,
}

/// Name of a function in C.
pub fn name(function: u32) -> String {
    format!("f{function}")
}

/// Name of the C function that calls a function of this type by its number.
pub fn name_of_kind(kind: u32) -> String {
    format!("by_number{kind}")
}

/// Result and arguments of a function, with names for the arguments if it is defined.
pub fn signature(module: &Module, function: u32, with_names: bool) -> Result<String> {
    let kind = module.type_of(function);
    let result = kind.results().first().map_or(Ok("void"), |kind| Kind::of(*kind).map(Kind::c))?;
    let mut arguments = vec![if with_names { "struct module *m" } else { "struct module *" }.to_owned()];
    for (at, kind) in kind.params().iter().enumerate() {
        let c = Kind::of(*kind)?.c();
        arguments.push(if with_names { format!("{c} l{at}") } else { c.to_owned() });
    }
    Ok(format!("{result} {}({})", name(function), arguments.join(", ")))
}

impl<'a> Function<'a> {
    /// Translates a function.
    pub fn of(module: &'a Module<'a>, function: u32, rules: &'a Rules) -> Result<(Facts, String)> {
        let mut this = Function {
            module,
            rules,
            stack: Stack::default(),
            locals: Vec::new(),
            blocks: Vec::new(),
            labels: 0,
            skipped: None,
            exit: "return;",
            recent: Needs::default(),
            facts: Facts::default(),
        };
        let text = this.translate(function).with_context(|| format!("function {function}"))?;
        Ok((this.facts, text))
    }

    fn translate(&mut self, function: u32) -> Result<String> {
        let module = self.module;
        let kind = module.type_of(function);
        ensure!(kind.results().len() < 2, "several results are not supported");
        let result = kind.results().first().map(|kind| Kind::of(*kind)).transpose()?;
        self.locals = kind.params().iter().map(|kind| Kind::of(*kind)).collect::<Result<_>>()?;
        let arguments = self.locals.len();
        let body = &module.bodies[function as usize];
        for local in body.get_locals_reader()? {
            let (count, kind) = local?;
            self.locals.extend(std::iter::repeat_n(Kind::of(kind)?, count as usize));
        }
        if result.is_some() {
            self.exit = "return 0;";
        }
        self.open(false, false, result);
        let mut frame = FrameSearch::default();
        let mut operators = body.get_operators_reader()?;
        while !operators.eof() {
            let begin = operators.original_position();
            let operator = operators.read()?;
            frame.add(&operator);
            self.add(&operator)?;
            if self.skipped.is_none() {
                self.recent.targets.extend(module.links.of(begin..operators.original_position()));
            }
        }
        self.facts.needs.append(mem::take(&mut self.recent));
        self.facts.frame = frame.found;
        self.facts.variables = self.locals.len() + self.stack.variables.len();
        let head = signature(module, function, true)?;
        Ok(format!("static {head} {{\n{}  (void)m;\n{}}}\n", self.declarations(arguments), self.stack.text))
    }

    /// The variables that the statements use. Compilers warn of those that are not read.
    fn declarations(&self, arguments: usize) -> String {
        let (mut text, mut ignored) = (String::new(), String::new());
        let locals = self.locals.iter().zip(0..).map(|(kind, at)| (kind, format!("l{at}")));
        let operands = self.stack.variables.iter().map(|(kind, place)| (kind, format!("{}{place}", kind.letter())));
        for (at, (kind, name)) in locals.chain(operands).enumerate() {
            let (is_used, is_read) = uses(&self.stack.text, &name);
            if at >= arguments && is_used {
                let _ = writeln!(text, "  {} {name} = 0;", kind.c());
            }
            if !is_read && (is_used || at < arguments) {
                let _ = writeln!(ignored, "  (void){name};");
            }
        }
        text + &ignored
    }

    fn open(&mut self, is_loop: bool, is_if: bool, result: Option<Kind>) {
        self.labels += 1;
        let (label, height) = (self.labels, self.stack.len());
        self.blocks.push(Block { label, is_loop, is_if, height, result, is_target: false });
    }

    fn add(&mut self, operator: &Operator) -> Result<()> {
        if let Some(depth) = self.skipped {
            return self.skip(operator, depth);
        }
        if let Some((operands, kind, text)) = expression(operator) {
            return self.compute(operands, kind, text);
        }
        if let Some((operands, kind, text)) = division(operator) {
            self.compute(operands, kind, text)?;
            self.stack.settle();
            self.facts.traps = true;
            self.return_if_broken();
            return Ok(());
        }
        if let Some((kind, function, offset)) = load(operator) {
            let address = self.stack.pop().text;
            self.stack.push(Operand::open(kind, format!("{function}(m, {address}, {offset}u)")));
            return Ok(());
        }
        if let Some((_, function, offset)) = store(operator) {
            let (address, value) = self.stack.pop_two();
            self.stack.settle();
            self.stack.line(format!("{function}(m, {}, {offset}u, {});", address.text, value.text));
            return Ok(());
        }
        self.add_other(operator)
    }

    /// Passes over code that is never reached, up to the end of its block.
    fn skip(&mut self, operator: &Operator, depth: usize) -> Result<()> {
        match operator {
            Operator::Block { .. } | Operator::Loop { .. } | Operator::If { .. } => self.skipped = Some(depth + 1),
            Operator::End if depth > 0 => self.skipped = Some(depth - 1),
            Operator::End | Operator::Else if depth == 0 => {
                self.skipped = None;
                return self.end(matches!(operator, Operator::Else), false);
            }
            _ => {}
        }
        Ok(())
    }

    fn compute(&mut self, operands: &[Kind], kind: Kind, text: &str) -> Result<()> {
        let operand = if let [_, _] = operands {
            let (a, b) = self.stack.pop_two();
            Operand::of(kind, text.replace("{a}", &a.text).replace("{b}", &b.text), &[&a, &b])
        } else {
            let a = self.stack.pop();
            Operand::of(kind, text.replace("{a}", &a.text), &[&a])
        };
        self.stack.push(operand);
        Ok(())
    }

    fn add_other(&mut self, operator: &Operator) -> Result<()> {
        match operator {
            Operator::I32Const { value } => self.constant(Kind::I32, format!("{}u", *value as u32)),
            Operator::I64Const { value } => self.constant(Kind::I64, format!("UINT64_C({})", *value as u64)),
            Operator::F32Const { value } => {
                self.constant(Kind::F32, format!("float_from_bits({}u)", value.bits()));
            }
            Operator::F64Const { value } => self.constant(Kind::F64, double(f64::from_bits(value.bits()))),
            Operator::LocalGet { local_index } => {
                let kind = self.locals[*local_index as usize];
                self.stack.push(Operand::open(kind, format!("l{local_index}")));
            }
            Operator::LocalSet { local_index } => self.set_local(*local_index),
            Operator::LocalTee { local_index } => {
                self.set_local(*local_index);
                let kind = self.locals[*local_index as usize];
                self.stack.push(Operand::open(kind, format!("l{local_index}")));
            }
            Operator::GlobalGet { global_index } => {
                self.stack.push(Operand::open(Kind::I32, format!("m->g{global_index}")));
            }
            Operator::GlobalSet { global_index } => {
                let value = self.stack.pop();
                self.stack.settle();
                if !self.rules.has_stack_for_all {
                    self.stack.line(format!("if (!is_within_stack(m, {})) {}", value.text, self.exit));
                }
                self.stack.line(format!("m->g{global_index} = {};", value.text));
            }
            Operator::Drop => drop(self.stack.pop()),
            Operator::Select | Operator::TypedSelect { .. } => self.select(),
            Operator::MemoryCopy { .. } => self.three("copy"),
            Operator::MemoryFill { .. } => self.three("fill"),
            Operator::Call { function_index } => self.call(*function_index)?,
            Operator::CallIndirect { type_index, .. } => self.call_by_number(*type_index)?,
            other => return self.control(other),
        }
        Ok(())
    }

    fn constant(&mut self, kind: Kind, text: String) {
        self.stack.push(Operand::constant(kind, text));
    }

    fn set_local(&mut self, local: u32) {
        let value = self.stack.pop();
        self.stack.settle();
        self.stack.line(format!("l{local} = {};", value.text));
    }

    /// The second operand is computed even if it is not chosen, so that a compiler can do without a branch.
    fn select(&mut self) {
        let condition = self.stack.pop();
        let (a, b) = self.stack.pop_two();
        let text = format!("({} ? {} : {})", condition.text, a.text, b.text);
        self.stack.push(Operand::of(a.kind, text, &[&condition, &a, &b]));
    }

    /// Calls a function of the runtime with three numbers.
    fn three(&mut self, function: &str) {
        let (b, c) = self.stack.pop_two();
        let a = self.stack.pop();
        self.stack.settle();
        self.stack.line(format!("{function}(m, {}, {}, {});", a.text, b.text, c.text));
    }

    fn arguments(&mut self, count: usize) -> String {
        let mut arguments: Vec<String> = (0..count).map(|_| self.stack.pop().text).collect();
        arguments.push("m".to_owned());
        arguments.reverse();
        arguments.join(", ")
    }

    fn call(&mut self, function: u32) -> Result<()> {
        let kind = self.module.type_of(function);
        let arguments = self.arguments(kind.params().len());
        if self.rules.endless.contains(&function) {
            self.trap();
            return Ok(());
        }
        self.recent.functions.insert(function);
        self.finish_call(format!("{}({arguments})", name(function)), kind.results())?;
        if self.rules.traps.contains(&function) {
            self.return_if_broken();
        }
        Ok(())
    }

    fn call_by_number(&mut self, kind: u32) -> Result<()> {
        let kind = self.module.kind_of(kind);
        self.recent.kinds.insert(kind);
        self.facts.traps = true;
        let number = self.stack.pop();
        let function = &self.module.types[kind as usize];
        let arguments = self.arguments(function.params().len());
        self.finish_call(format!("{}({arguments}, {})", name_of_kind(kind), number.text), function.results())?;
        self.return_if_broken();
        Ok(())
    }

    /// Ends the call, without the statements that lead here: nobody looks into a broken instance, or reads what a panic
    /// says.
    fn trap(&mut self) {
        self.facts.traps = true;
        self.recent = Needs::default();
        self.stack.forget();
        self.stack.line("trap(m);");
        self.turn(self.exit);
        self.skipped = Some(0);
    }

    /// Writes a line from which or to which control jumps: what stands before it is needed.
    fn turn(&mut self, line: impl AsRef<str>) {
        self.facts.needs.append(mem::take(&mut self.recent));
        self.stack.turn(line);
    }

    fn return_if_broken(&mut self) {
        self.stack.line(format!("if (m->is_broken) {}", self.exit));
    }

    fn finish_call(&mut self, call: String, results: &[wasmparser::ValType]) -> Result<()> {
        self.stack.settle();
        match results {
            [] => self.stack.line(format!("{call};")),
            [kind] => self.stack.assign(Kind::of(*kind)?, &call),
            _ => bail!("several results are not supported"),
        }
        Ok(())
    }

    fn control(&mut self, operator: &Operator) -> Result<()> {
        match operator {
            Operator::Nop => {}
            Operator::Unreachable => self.trap(),
            Operator::Block { blockty } => {
                self.stack.settle();
                self.open(false, false, Kind::of_block(*blockty)?);
            }
            Operator::Loop { blockty } => {
                self.stack.settle();
                self.open(true, false, Kind::of_block(*blockty)?);
                // A label that nothing jumps to is a warning only.
                let label = self.labels;
                self.turn(format!("L{label}:;"));
            }
            Operator::If { blockty } => {
                let condition = self.stack.pop();
                self.stack.settle();
                self.turn(format!("if ({}) {{", condition.text));
                self.open(false, true, Kind::of_block(*blockty)?);
                self.stack.depth += 1;
            }
            Operator::Else => self.end(true, true)?,
            Operator::End => self.end(false, true)?,
            other => return self.branch(other),
        }
        Ok(())
    }

    /// Ends a block, or the first part of one.
    fn end(&mut self, is_else: bool, is_reached: bool) -> Result<()> {
        let Block { label, is_loop, is_if, height, result, is_target } =
            self.blocks.pop().context("an end too many")?;
        if is_reached && let Some(kind) = result {
            let value = self.stack.pop();
            self.stack.truncate(height);
            self.stack.settle();
            self.keep(kind, height, &value);
        } else if is_reached {
            self.stack.settle();
        }
        self.stack.truncate(height);
        if is_else {
            self.stack.depth -= 1;
            self.turn("} else {");
            self.stack.depth += 1;
            self.blocks.push(Block { label, is_loop, is_if, height, result, is_target });
            return Ok(());
        }
        if is_if {
            self.stack.depth -= 1;
            self.turn("}");
        }
        if is_target && !is_loop {
            self.turn(format!("L{label}:;"));
        }
        self.facts.returns = self.blocks.is_empty() && (is_reached || is_target);
        if let Some(kind) = result {
            let variable = self.stack.variable(kind, height);
            if !self.blocks.is_empty() {
                self.stack.push(Operand::open(kind, variable));
            } else if self.facts.returns {
                self.stack.line(format!("return {variable};"));
            }
        }
        Ok(())
    }

    /// Writes a value into the variable of a place.
    fn keep(&mut self, kind: Kind, place: usize, value: &Operand) {
        let variable = self.stack.variable(kind, place);
        if value.text != variable {
            self.stack.line(format!("{variable} = {};", value.text));
        }
    }

    fn branch(&mut self, operator: &Operator) -> Result<()> {
        match operator {
            Operator::Br { relative_depth } => {
                self.jump(*relative_depth as usize)?;
                self.skipped = Some(0);
            }
            Operator::Return => {
                self.jump(self.blocks.len() - 1)?;
                self.skipped = Some(0);
            }
            Operator::BrIf { relative_depth } => {
                let condition = self.stack.pop();
                self.stack.settle();
                self.turn(format!("if ({}) {{", condition.text));
                self.stack.depth += 1;
                self.jump(*relative_depth as usize)?;
                self.stack.depth -= 1;
                self.turn("}");
            }
            Operator::BrTable { targets } => {
                self.switch(targets)?;
                self.skipped = Some(0);
            }
            other => bail!("the operator {other:?} is not supported"),
        }
        Ok(())
    }

    fn jump(&mut self, depth: usize) -> Result<()> {
        let at = self.blocks.len().checked_sub(depth + 1).context("a branch too far")?;
        self.stack.settle();
        let Block { label, is_loop, height, result, .. } = self.blocks[at];
        if let Some(kind) = result.filter(|_| !is_loop) {
            let value = self.stack.pop();
            self.keep(kind, height, &value);
            self.stack.push(value);
        }
        self.blocks[at].is_target = true;
        self.turn(format!("goto L{label};"));
        Ok(())
    }

    fn switch(&mut self, targets: &BrTable) -> Result<()> {
        let number = self.stack.pop();
        self.stack.settle();
        self.turn(format!("switch ({}) {{", number.text));
        self.stack.depth += 1;
        for (number, target) in targets.targets().enumerate() {
            self.turn(format!("case {number}:"));
            self.jump(target? as usize)?;
        }
        self.turn("default:");
        self.jump(targets.default() as usize)?;
        self.stack.depth -= 1;
        self.turn("}");
        Ok(())
    }
}

/// Whether statements use a variable, and whether they read it.
fn uses(text: &str, name: &str) -> (bool, bool) {
    let is_of_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let parts = text.match_indices(name).map(|(at, _)| (&text[..at], &text[at + name.len()..]));
    let mut rests = parts
        .filter(|(before, rest)| !before.ends_with(is_of_name) && !rest.starts_with(is_of_name))
        .map(|(_, rest)| rest)
        .peekable();
    (rests.peek().is_some(), rests.any(|rest| !rest.starts_with(" = ")))
}

/// A number in C, exactly: in hexadecimal digits, or by its bits if it is not finite.
pub fn double(value: f64) -> String {
    let bits = value.to_bits();
    if !value.is_finite() {
        return format!("from_bits(UINT64_C({bits}))");
    }
    let (sign, exponent, mantissa) = (bits >> 63, (bits >> 52) & 0x7ff, bits & 0x000f_ffff_ffff_ffff);
    let (lead, power) = if exponent == 0 { (0, -1022) } else { (1, exponent as i64 - 1023) };
    let text = if mantissa == 0 && lead == 0 { "0.0".to_owned() } else { format!("0x{lead}.{mantissa:013x}p{power}") };
    if sign == 1 { format!("(-{text})") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_are_told_from_what_contains_their_names() {
        assert_eq!(uses("l4 = load8(m, l14, 4u);", "l4"), (true, false));
        assert_eq!(uses("l4 = load8(m, l14, 4u);", "d8"), (false, false));
        assert_eq!(uses("l4 = 1u;\n  if (l4 == 2u) {", "l4"), (true, true));
        assert_eq!(uses("l5 = l4 + 1u;", "l4"), (true, true));
    }
}
