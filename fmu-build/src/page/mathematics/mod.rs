//! Equations of the documentation, which are ASCII text, as MathML.

mod block;
mod grammar;
mod mathml;
mod symbols;
mod token;

pub use block::block;
pub use mathml::inline;
pub use symbols::Symbols;
