//! The FMI 3.0 functions from an importer's point of view.

mod arrays;
mod calls;
mod derivatives;
mod events;
mod importer;
mod intermediate;
mod model_exchange;
mod saved_states;
mod setup;
mod steps;

use stribeck::model::{Kind, ModelType, Role, Variable};
use stribeck::reference;
use stribeck_ffi::fmi3::types::fmi3ValueReference;

/// A variable of FMI 3.0: one column or an array of them.
struct Known {
    reference: fmi3ValueReference,
    derivatives: fmi3ValueReference,
    columns: Vec<usize>,
    first: Variable,
}

/// The variables of a model in the order of FMI 3.0, found with the arrays that describe it.
fn variables(model: &ModelType) -> Vec<Known> {
    let arrays = stribeck::arrays::of(model).expect("memory");
    let mut known = Vec::new();
    for (column, variable) in model.variables() {
        match arrays.iter().find(|array| array.columns.contains(&column)) {
            Some(array) if array.columns[0] == column => known.push(Known {
                reference: array.reference(),
                derivatives: array.derivative_reference(),
                columns: array.columns.to_vec(),
                first: variable,
            }),
            Some(_) => {}
            None => known.push(Known {
                reference: model.reference(column),
                derivatives: reference::of_derivative(&variable.path),
                columns: vec![column],
                first: variable,
            }),
        }
    }
    known
}

/// Those with real numbers that have this role.
fn reals(model: &ModelType, role: impl Fn(Role) -> bool) -> Vec<Known> {
    let is_wanted = |known: &Known| role(known.first.role) && matches!(known.first.kind, Kind::Real(_));
    variables(model).into_iter().filter(is_wanted).collect()
}

/// The value of an input in a step, as `crate::drive` sets it.
fn driven(variable: &Variable, k: i32) -> f64 {
    let swing = if variable.bound.admits(-1.0) { f64::from(k).sin() } else { 1.0 };
    variable.start + 0.01 * swing
}
