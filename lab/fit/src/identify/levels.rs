//! Levels of a law: one static and one kinetic one, or a pair for each direction.

use stribeck::model::{Meaning, ModelType, Variable};

/// The columns of a law that play a part: one of each direction where the law differs by direction.
pub(super) fn columns_of(law: &ModelType, meaning: Meaning) -> impl Iterator<Item = usize> {
    let plays =
        move |(_, variable): &(usize, Variable)| variable.meaning == meaning && variable.path.segments().len() == 1;
    law.variables().filter(plays).map(|(column, _)| column)
}

/// The columns of static and kinetic level, those of each direction together.
pub(super) fn pairs_of_levels(law: &ModelType) -> Vec<[usize; 2]> {
    let [of, over] = [Meaning::StaticLevel, Meaning::KineticLevel].map(|meaning| columns_of(law, meaning));
    of.zip(over).map(|(of, over)| [of, over]).collect()
}

/// The kinetic level of a static one.
pub(super) fn kinetic_of(law: &ModelType, level: usize) -> Option<usize> {
    pairs_of_levels(law).into_iter().find(|[of, _]| *of == level).map(|[_, over]| over)
}

/// The kinetic levels of a law that has one for each direction.
pub(super) fn levels_by_direction(law: &ModelType) -> Option<[usize; 2]> {
    let levels: Vec<usize> = columns_of(law, Meaning::KineticLevel).collect();
    levels.try_into().ok()
}
