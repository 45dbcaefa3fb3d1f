//! Columns by which a record leads a law.

use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};

use super::levels::columns_of;

/// Columns of a law that a rig drives and reads.
#[derive(Clone, Debug)]
pub struct Ports {
    /// Input: velocity.
    pub velocity: usize,
    /// Input: normal force. None of a component, which no normal force presses together.
    pub load: Option<usize>,
    /// Output: friction force.
    pub force: usize,
    /// Input of the laws that differ as the contact speeds up or slows down.
    pub acceleration: Option<usize>,
    /// Further columns that a record may lead.
    pub led: Vec<Led>,
    /// States: the displacement of the host, from which a record begins.
    pub(super) displacements: Vec<usize>,
}

/// A column that a record leads by a channel of its name.
#[derive(Clone, Copy, Debug)]
pub struct Led {
    /// The column.
    pub column: usize,
    /// Its name, and that of the channel.
    pub name: &'static str,
    /// Its unit, for a body that slides.
    pub unit: &'static str,
    /// Whether it is an input, without which the law is not driven, and not a parameter, which has a value anyway.
    pub is_input: bool,
}

impl Led {
    /// The column, if it is an input for which a rig has nothing else, or a condition of the surroundings.
    fn of((column, variable): (usize, Variable)) -> Option<Led> {
        const KNOWN: [Meaning; 4] =
            [Meaning::Velocity, Meaning::NormalForce, Meaning::ExternalForce, Meaning::Acceleration];
        let ([segment], Kind::Real(unit)) = (variable.path.segments(), variable.kind) else { return None };
        let is_input = variable.role == Role::Input && !KNOWN.contains(&variable.meaning);
        let is_led = is_input || variable.meaning == Meaning::Condition;
        is_led.then_some(Led { column, name: segment.name, unit: unit.name, is_input })
    }
}

impl Ports {
    /// None for a law of a contact that slides in two directions.
    pub fn of(law: &ModelType) -> Option<Ports> {
        let of = |meaning| law.table.of(meaning);
        if of(Meaning::VelocityY).is_some() {
            return None;
        }
        Some(Ports {
            velocity: of(Meaning::Velocity)?,
            load: of(Meaning::NormalForce),
            force: of(Meaning::FrictionForce)?,
            acceleration: of(Meaning::Acceleration),
            led: law.variables().filter_map(Led::of).collect(),
            displacements: columns_of(law, Meaning::Displacement).collect(),
        })
    }

    /// Whether the law integrates the displacement of its host, so that no run-up may move it.
    pub fn has_displacement(&self) -> bool {
        !self.displacements.is_empty()
    }
}
