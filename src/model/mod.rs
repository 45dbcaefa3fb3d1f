//! A model is one row of `f64` with a declared table: the [`model!`](crate::model!) block writes both.
//!
//! Get, set, reset, save and restore work on rows and need not know the model; a model cannot have a state that its table
//! does not list. FMI and C identify a variable by a number that follows from its name: see
//! [`reference`](crate::reference).

mod bonds;
mod declare;
mod equations;
mod evaluate;
mod family;
pub(crate) mod integrate;
mod kernels;
mod model_type;
pub(crate) mod passivity;
pub(crate) mod ramp;
mod row;
mod steps;

pub use crate::table::*;
pub use bonds::{Bond, Bonds, MOST_BONDS, Surface};
pub use declare::{list, start};
pub use equations::{
    CoSimulation, Columns, Derivatives, Described, Interface, Law, Model, ModelExchange, Numbers, Past, Preset, Width,
    WithHistory,
};
pub(crate) use equations::{is_for_exchange, rests_at_events};
pub use evaluate::{Evaluate, advise_in, memory_in, output_and_rate_in, output_in, rate_in};
pub use family::Visitor;
pub(crate) use family::family;
pub(crate) use kernels::Kernel;
pub use kernels::Kernels;
pub use model_type::ModelType;
pub use passivity::GivesBack;
pub(crate) use row::{change, either, mix, parts, parts_mut};
pub use row::{row_of, row_of_mut};
pub(crate) use steps::in_lanes;
pub use steps::{Fit, InLanes, Shared, Steps, model_in, model_of};
