//! The operands of a function: expressions in C that have not been computed yet, or variables that have been.
//!
//! An expression is written where its value is used. What changes a value on which it depends, or may not be passed by
//! it, computes it first: into the variable of its place, which no other operand of that type uses.

use std::fmt::Write;

use super::kind::Kind;

/// An expression in C and its dependencies.
#[derive(Clone)]
pub struct Operand {
    pub text: String,
    pub kind: Kind,
    /// Whether it depends on anything but constants: variables of operands, locals, memory, globals.
    is_open: bool,
}

impl Operand {
    /// A constant.
    pub fn constant(kind: Kind, text: String) -> Operand {
        Operand { text, kind, is_open: false }
    }

    /// An expression of these operands.
    pub fn of(kind: Kind, text: String, operands: &[&Operand]) -> Operand {
        Operand { text, kind, is_open: operands.iter().any(|operand| operand.is_open) }
    }

    /// An expression that depends on something that changes.
    pub fn open(kind: Kind, text: String) -> Operand {
        Operand { text, kind, is_open: true }
    }
}

/// Longest expression that is not computed before it is used.
const LONGEST: usize = 400;

/// The operands, and the text of the function so far.
#[derive(Default)]
pub struct Stack {
    operands: Vec<Operand>,
    /// Statements.
    pub text: String,
    /// Depth of the statements, in blocks of C.
    pub depth: usize,
    /// Variables of operands: kind and place.
    pub variables: Vec<(Kind, usize)>,
    /// Length of the text at the last jump, label or brace.
    straight: usize,
}

impl Stack {
    pub fn len(&self) -> usize {
        self.operands.len()
    }

    pub fn line(&mut self, text: impl AsRef<str>) {
        let _ = writeln!(self.text, "{:1$}{2}", "", 2 * (self.depth + 1), text.as_ref());
    }

    /// A line that is a jump, a label or a brace: what follows is executed one after another from here on.
    pub fn turn(&mut self, text: impl AsRef<str>) {
        self.line(text);
        self.straight = self.text.len();
    }

    /// Removes the statements since the last jump, label or brace.
    pub fn forget(&mut self) {
        self.text.truncate(self.straight);
    }

    pub fn push(&mut self, operand: Operand) {
        let is_long = operand.text.len() > LONGEST;
        self.operands.push(operand);
        if is_long {
            self.settle();
        }
    }

    pub fn pop(&mut self) -> Operand {
        self.operands.pop().expect("the module is valid")
    }

    /// Two operands, in the order in which they were pushed.
    pub fn pop_two(&mut self) -> (Operand, Operand) {
        let second = self.pop();
        (self.pop(), second)
    }

    pub fn truncate(&mut self, length: usize) {
        self.operands.truncate(length);
    }

    /// The variable of a place.
    pub fn variable(&mut self, kind: Kind, place: usize) -> String {
        if !self.variables.contains(&(kind, place)) {
            self.variables.push((kind, place));
        }
        format!("{}{place}", kind.letter())
    }

    /// Computes every operand that depends on something, from below.
    pub fn settle(&mut self) {
        for place in 0..self.operands.len() {
            let Operand { text, kind, is_open } = self.operands[place].clone();
            if !is_open {
                continue;
            }
            let variable = self.variable(kind, place);
            if text != variable {
                self.line(format!("{variable} = {text};"));
                self.operands[place].text = variable;
            }
        }
    }

    /// Gives the variable of the place a value, as the last operand.
    pub fn assign(&mut self, kind: Kind, value: &str) {
        let variable = self.variable(kind, self.operands.len());
        self.line(format!("{variable} = {value};"));
        self.operands.push(Operand::open(kind, variable));
    }
}
