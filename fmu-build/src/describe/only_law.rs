//! The only law of C sources that are made of a model with a choice.

use std::ptr;

use anyhow::{Result, bail};
use stribeck::model::{Enumeration, Item, Kind, ModelType, Variable};
use stribeck::shock_absorber::{NO_LAW, choice_of_law};

/// The law that sources contain.
#[derive(Clone, Copy)]
pub struct OnlyLaw {
    /// Name of the law.
    pub name: &'static str,
    /// Its number among the choices.
    pub number: usize,
    column: usize,
    choices: &'static Enumeration,
}

impl OnlyLaw {
    /// The law of this name; none for a model that has no choice. An error says which laws there are.
    pub fn of(model: &ModelType, law: Option<&str>) -> Result<Option<OnlyLaw>> {
        let name = model.name;
        let choice = choice_of_law(model).map(|column| (column, model.table.at(column).kind));
        let Some((column, Kind::Enumeration(choices))) = choice else {
            return law.map_or(Ok(None), |law| bail!("{name}: --law {law}: it has no choice of law"));
        };
        let laws: Vec<&str> = choices.items.iter().map(|item| item.name).filter(|name| *name != NO_LAW.name).collect();
        let Some(law) = law else { bail!("{name}: C sources contain one law: --law with one of {}", laws.join(", ")) };
        match choices.items.iter().position(|item| item.name == law && law != NO_LAW.name) {
            Some(at) => Ok(Some(OnlyLaw { name: choices.items[at].name, number: at + 1, column, choices })),
            None => bail!("{name}: --law {law}: must be one of {}", laws.join(", ")),
        }
    }

    /// The variable that chooses it.
    pub fn variable(&self, model: &ModelType) -> Variable {
        model.table.at(self.column)
    }

    /// Column of the choice, and its start value.
    pub fn start(&self) -> (usize, f64) {
        (self.column, self.number as f64)
    }
}

/// Whether sources with this law, or all laws, have this choice.
pub fn has(law: Option<OnlyLaw>, choices: &Enumeration, item: &Item) -> bool {
    law.is_none_or(|law| !ptr::eq(choices, law.choices) || [NO_LAW.name, law.name].contains(&item.name))
}

/// The variable of a column, as it begins with this law.
pub fn begun(law: Option<OnlyLaw>, column: usize, variable: Variable) -> Variable {
    match law.map(|law| law.start()) {
        Some((choice, start)) if choice == column => Variable { start, ..variable },
        _ => variable,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::catalogue;

    #[test]
    fn strut_and_contact_have_a_choice_and_no_other_model() {
        let has_choice = |model: &&ModelType| OnlyLaw::of(model, None).is_err();
        let names: Vec<&str> = catalogue::models().filter(has_choice).map(|model| model.name).collect();
        assert_eq!(names, ["ShockAbsorber", "GuideContact"]);
    }
}
