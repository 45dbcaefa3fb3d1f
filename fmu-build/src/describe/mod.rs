//! The committed files that state the interface of the models, and the rules for the tables they come from.

pub mod block;
pub mod compatibility;
pub mod declarations;
pub mod defaults;
pub mod dependencies;
pub mod description;
pub mod entry;
pub mod fmi2;
pub mod fmi3;
pub mod generated;
pub mod header;
pub mod interface;
pub mod models;
pub mod only_law;
pub mod rules;
pub mod structure;
pub mod terminals;
pub mod text;
pub mod xml;
