//! The symbols of a page, which may be words.

use std::collections::BTreeSet;

use super::token::{self, Token, Word};

/// Symbols that a page defines, as written: `v`, `f_C`, `sigma_0`.
#[derive(Clone, Debug, Default)]
pub struct Symbols(BTreeSet<String>);

impl Symbols {
    /// Whether it is one of them.
    pub fn contains(&self, name: &str) -> bool {
        self.0.contains(name)
    }

    /// Adds the symbols in a text such as the cell of a symbol table.
    pub fn add(&mut self, text: &str) {
        let Ok(tokens) = token::tokens(text) else { return };
        let mut name = String::new();
        for Token { word, .. } in tokens {
            match word {
                Word::Subscript(below) if !name.is_empty() => name = format!("{name}_{below}"),
                Word::Name(next) => self.insert(std::mem::replace(&mut name, next)),
                Word::Derivative(derivative) => self.insert(derivative.of),
                _ => self.insert(std::mem::take(&mut name)),
            }
        }
        self.insert(name);
    }

    fn insert(&mut self, name: String) {
        if !name.is_empty() && !token::is_function(&name) && !token::is_differential(&name) {
            self.0.insert(name);
        }
    }
}
