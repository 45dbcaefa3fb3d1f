//! Equations of the documentation, which are ASCII text, as MathML.

mod block;
mod grammar;
mod mathml;
mod prose;
mod symbols;
mod token;

pub use block::block;
pub use prose::{Part, prose, symbol};
pub use symbols::Symbols;
