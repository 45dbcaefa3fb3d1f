//! The laws that a contact can have, and the columns that it gives them.
//!
//! They are those models of sliding friction that are scalar, so that a new law can be chosen without any further code.

use std::ops::Range;
use std::ptr;

use crate::friction::{MODELS, TABLES, record};
use crate::model::{Enumeration, Item, Kind, Meaning, ModelType, Variable, column_of};
use crate::unit::same;

/// A law with its table as it was declared.
#[derive(Clone, Copy)]
pub(super) struct Declared {
    pub(super) model: &'static ModelType,
    pub(super) table: &'static [Variable],
}

impl Declared {
    const fn of(place: usize) -> Declared {
        Declared { model: &MODELS[place], table: TABLES[place] }
    }
}

/// Whether a contact of the law slides along a line.
const fn is_along(law: Declared) -> bool {
    column(law, Meaning::Velocity).is_some() && column(law, Meaning::VelocityY).is_none()
}

/// Whether the law is one of sliding along a line, whose level the contact sets by the coefficient of friction: one for
/// both directions, none without load, and not that of one speed only.
const fn is_scalar(law: Declared) -> bool {
    let has_others = column(law, Meaning::Preload).is_some() || column(law, Meaning::ReferenceSpeed).is_some();
    let follows_load = kinetic_levels(law) == 1 && !has_others;
    is_along(law) && column(law, Meaning::FrictionForce).is_some() && follows_load
}

const fn kinetic_levels(law: Declared) -> usize {
    let (mut count, mut at) = (0, 0);
    while at < law.table.len() {
        count += matches!(law.table[at].meaning, Meaning::KineticLevel) as usize;
        at += 1;
    }
    count
}

/// Column that plays a part, not within a part of the law.
pub(super) const fn column(law: Declared, meaning: Meaning) -> Option<usize> {
    column_of(law.table, meaning)
}

/// Number of laws.
pub(super) const COUNT: usize = {
    let (mut count, mut at) = (0, 0);
    while at < MODELS.len() {
        count += is_scalar(Declared::of(at)) as usize;
        at += 1;
    }
    count
};

/// The laws, in the order of the catalogue.
pub(super) static LAWS: [Declared; COUNT] = {
    let mut laws = [Declared::of(0); COUNT];
    let (mut count, mut at) = (0, 0);
    while at < MODELS.len() {
        if is_scalar(Declared::of(at)) {
            laws[count] = Declared::of(at);
            count += 1;
        }
        at += 1;
    }
    laws
};

/// Name of the only law that the library holds, if C sources are made of it. Every other library holds all.
const ONLY: Option<&str> = if cfg!(stribeck_one_law) { option_env!("STRIBECK_LAW") } else { None };

/// The laws that the library holds, by their places among all.
pub(super) const HELD: Range<usize> = match ONLY {
    Some(name) => position(name)..position(name) + 1,
    None => 0..COUNT,
};

/// The record of the only law.
static RECORD: Option<ModelType> = match ONLY {
    Some(name) => Some(record(name)),
    None => None,
};

/// The record of a law that the library holds: not the one in the list of all, if it is the only one.
pub(super) const fn held(law: usize) -> &'static ModelType {
    match &RECORD {
        Some(record) => record,
        None => LAWS[law].model,
    }
}

/// Largest number of columns of any law.
pub(super) const WIDEST: usize = {
    let (mut widest, mut at) = (0, 0);
    while at < COUNT {
        if LAWS[at].table.len() > widest {
            widest = LAWS[at].table.len();
        }
        at += 1;
    }
    widest
};

/// The choice without friction: the first one of a law.
pub const NO_LAW: Item = Item { name: "None", help: "No friction." };

/// Choices of a law: none, then the laws in the order of the catalogue.
pub static FRICTION_MODEL: Enumeration = Enumeration { name: "FrictionModel", items: &ITEMS };

static ITEMS: [Item; COUNT + 1] = {
    let mut items = [NO_LAW; COUNT + 1];
    let mut at = 0;
    while at < COUNT {
        items[at + 1] = Item { name: LAWS[at].model.name, help: LAWS[at].model.summary };
        at += 1;
    }
    items
};

/// Column of the variable that chooses a law, in a model that has a choice.
pub fn choice_of_law(model: &ModelType) -> Option<usize> {
    let is_choice =
        |variable: &Variable| matches!(variable.kind, Kind::Enumeration(items) if ptr::eq(items, &FRICTION_MODEL));
    model.table.iter().position(|variable| is_choice(&variable))
}

/// The default law.
pub(crate) const LUGRE: i32 = position("LuGre") as i32 + 2;

pub(super) const fn position(name: &str) -> usize {
    let mut at = 0;
    while !same(LAWS[at].model.name, name) {
        at += 1;
    }
    at
}

/// Columns that a contact provides to its law, in the order of [`Given::values`](super::law::Given::values).
const GIVEN: [Meaning; 8] = [
    Meaning::Velocity,
    Meaning::NormalForce,
    Meaning::KineticLevel,
    Meaning::StaticLevel,
    Meaning::Mass,
    Meaning::Exchange,
    Meaning::ExternalForce,
    Meaning::Acceleration,
];

/// Number of columns that a contact provides.
pub(super) const GIVENS: usize = GIVEN.len();

/// Which of the quantities of a contact the variable is, if it is one.
pub(super) const fn given(variable: &Variable) -> Option<usize> {
    if variable.path.segments().len() > 1 {
        return None;
    }
    let mut at = 0;
    while at < GIVENS {
        if variable.meaning as u8 == GIVEN[at] as u8 {
            return Some(at);
        }
        at += 1;
    }
    None
}
