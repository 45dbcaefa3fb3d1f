//! The model, and the memory that its instance needs.

use stribeck::model::{Columns, ModelType};

include!(concat!(env!("OUT_DIR"), "/model.rs"));

/// The record of the model.
pub static MODEL: ModelType =
    if HAS_SLOPES { ModelType::of_steps::<Chosen>() } else { ModelType::of_held_steps::<Chosen>() };

/// Number of its columns.
pub const COLUMNS: usize = <Chosen as Columns>::TABLE.len();
