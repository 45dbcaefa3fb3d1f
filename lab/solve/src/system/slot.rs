//! Laws in a system: how the variables of any friction law meet those of a contact along one line.

use stribeck::catalogue::{self, Family};
use stribeck::model::{Meaning, ModelType};

use super::Fault;

/// Inputs of laws in the plane and in space whose value follows from a contact along x, on a plane across z.
const ACROSS: &[(&str, f64)] = &[
    ("velocity_y", 0.0),
    ("velocity_z", 0.0),
    ("normal_x", 0.0),
    ("normal_y", 0.0),
    ("normal_z", 1.0),
    ("spin_rate", 0.0),
];

/// The friction law of this name.
pub(super) fn law(name: &str) -> Result<&'static ModelType, Fault> {
    let laws = || catalogue::documented(Family::Friction).map(|(model, _)| model);
    laws()
        .find(|model| model.name == name)
        .or_else(|| catalogue::by_name(name).filter(|model| gives_friction(model)))
        .ok_or_else(|| Fault::unknown("friction law", name, laws().map(|model| model.name)))
}

/// The variable of a law that stands for a variable of a contact along one line: in the plane and in space its
/// component along x.
pub(super) fn along(model: &ModelType, name: &str) -> Option<usize> {
    model.find(name).or_else(|| model.find(&format!("{name}_x")))
}

/// The value of an input that a contact along one line does not have.
pub(super) fn across(name: &str) -> Option<f64> {
    ACROSS.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
}

fn gives_friction(model: &ModelType) -> bool {
    model.table.of(Meaning::FrictionForce).is_some_and(|column| model.table.at(column).role.is_output())
}
