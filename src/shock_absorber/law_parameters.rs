//! Parameters of all friction laws, as offered by a contact.

use crate::model::{Columns, ModelType, Path, Segment, Variable, Width};
use crate::shock_absorber::law::{COUNT, LAWS, given, position};
use crate::unit::same;

/// Largest number of Maxwell-slip elements of a law here.
const ELEMENTS: u16 = 16;

/// Whether the parameter is offered here: not if the contact provides it, nor for elements beyond the last.
const fn is_offered(variable: &Variable) -> bool {
    variable.role.is_parameter() && given(variable).is_none() && variable.path.segments()[0].index <= ELEMENTS
}

/// Start value of the shared parameter of that name: that of LuGre, otherwise of the first law that has it.
const fn shared_start(path: &Path) -> Option<f64> {
    let mut at = 0;
    while at <= COUNT {
        let table = if at == 0 { LAWS[position("LuGre")].table } else { LAWS[at - 1].table };
        let mut column = 0;
        while column < table.len() {
            if table[column].path.is(path) && is_offered(&table[column]) {
                return Some(table[column].start);
            }
            column += 1;
        }
        at += 1;
    }
    None
}

/// Whether the law needs its own parameter of that name, because its default differs from the shared one. Variants of
/// different laws are different choices under one name.
const fn is_own(variable: &Variable) -> bool {
    let differs = match shared_start(&variable.path) {
        Some(start) => start != variable.start,
        None => false,
    };
    differs || same(variable.path.segments()[0].name, "variant")
}

/// Parameter of a law as offered here; `None` if it is not offered.
const fn offered(law: &ModelType, variable: &Variable) -> Option<Variable> {
    if !is_offered(variable) {
        return None;
    }
    let mut offered = *variable;
    if is_own(variable) {
        offered.path = variable.path.within(Segment { name: law.name, index: 0 });
    }
    if same(variable.path.segments()[0].name, "element_count") {
        offered.bound = variable.bound.up_to(ELEMENTS as f64);
    }
    Some(offered)
}

/// The parameters of all laws: one for all laws with the same default, and one of its own for each law with another
/// default, so that a law starts here as it does alone.
const fn merge() -> ([Variable; MOST_PARAMETERS], usize) {
    let mut merged = [crate::model::BLANK; MOST_PARAMETERS];
    let mut count = add_parameters(&mut merged, 0, LAWS[position("LuGre")]);
    let mut at = 0;
    while at < COUNT {
        count = add_parameters(&mut merged, count, LAWS[at]);
        at += 1;
    }
    (merged, count)
}

/// Adds the parameters of a law to the first `count` ones.
const fn add_parameters(merged: &mut [Variable; MOST_PARAMETERS], mut count: usize, law: &ModelType) -> usize {
    let mut at = 0;
    while at < law.table.len() {
        if let Some(offered) = offered(law, &law.table[at]) {
            let place = find(merged, count, &offered.path);
            if place < count {
                merged[place].bound = merged[place].bound.or(offered.bound);
            } else {
                merged[count] = offered;
                count += 1;
            }
        }
        at += 1;
    }
    count
}

/// Place of a name among the first `count` variables; `count` if it is not there.
const fn find(variables: &[Variable; MOST_PARAMETERS], count: usize, path: &Path) -> usize {
    let mut at = 0;
    while at < count && !variables[at].path.is(path) {
        at += 1;
    }
    at
}

/// Capacity for the parameters of all laws while they are merged; too small a value does not compile.
const MOST_PARAMETERS: usize = 128;

const MERGED: ([Variable; MOST_PARAMETERS], usize) = merge();

/// Number of parameters of all laws together.
const PARAMETERS: usize = MERGED.1;

/// The parameters of all laws.
#[derive(Debug)]
#[repr(C)]
pub struct LawParameters<T = f64> {
    /// Their values, in the order of the table.
    pub values: [T; PARAMETERS],
}

impl<T: Copy> Clone for LawParameters<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy> Copy for LawParameters<T> {}

impl<T: Copy> LawParameters<T> {
    /// The same columns in another number type.
    pub fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> LawParameters<U> {
        LawParameters { values: self.values.map(convert) }
    }
}

impl Width for LawParameters {
    const WIDTH: usize = PARAMETERS;
}

// SAFETY: `#[repr(C)]` and an array of numbers; the table has one entry for each by its type.
unsafe impl Columns for LawParameters {
    const TABLE: &'static [Variable] = MERGED.0.split_at(PARAMETERS).0;
}

/// Place of a law's parameter among those of all laws; `None` if it is not offered.
pub(super) const fn place_of(law: &ModelType, variable: &Variable) -> Option<u16> {
    match offered(law, variable) {
        Some(offered) => Some(find(&MERGED.0, PARAMETERS, &offered.path) as u16),
        None => None,
    }
}
