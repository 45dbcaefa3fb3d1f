//! Parameters of all friction laws, as offered by a contact.

use crate::model::{Columns, Meaning, Path, Segment, Variable, Width};
use crate::shock_absorber::law_list::{COUNT, Declared, LAWS, WIDEST, given, position};

/// Largest number of Maxwell-slip elements of a law here.
const ELEMENTS: u16 = 16;

/// Whether the parameter is offered here: not if the contact provides it, nor for elements beyond the last.
const fn is_offered(variable: &Variable) -> bool {
    variable.role.is_parameter() && given(variable).is_none() && variable.path.segments()[0].index <= ELEMENTS
}

/// Help text of the Stribeck velocity, which is not the same in all laws.
const STRIBECK_VELOCITY: &str = "Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 \
                                 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).";

/// Capacity for the parameters of all laws while they are merged; too small a value does not compile.
const MOST_PARAMETERS: usize = 128;

/// The parameters of laws: one for all laws with the same default, and one of its own for each law with another default,
/// so that a law starts here as it does alone.
struct Merged<const LAWS: usize> {
    variables: [Variable; MOST_PARAMETERS],
    count: usize,
    /// Places of the columns of each law among them.
    places: [[Option<u16>; WIDEST]; LAWS],
}

impl<const LAWS: usize> Merged<LAWS> {
    /// Merges the parameters of laws. Start values of shared parameters are those of LuGre, otherwise of the first law
    /// that has them.
    const fn of(laws: &[Declared; LAWS]) -> Merged<LAWS> {
        let variables = [crate::model::BLANK; MOST_PARAMETERS];
        let mut merged = Merged { variables, count: 0, places: [[None; WIDEST]; LAWS] };
        merged.add(laws, position("LuGre"));
        let mut at = 0;
        while at < LAWS {
            merged.add(laws, at);
            at += 1;
        }
        merged
    }

    /// Adds the parameters of a law.
    const fn add(&mut self, laws: &[Declared; LAWS], law: usize) {
        let table = laws[law].table;
        let (mut at, end) = (0, table.len());
        while at < end {
            if is_offered(&table[at]) {
                self.places[law][at] = Some(self.place(laws[law].model.name, &table[at]));
            }
            at += 1;
        }
    }

    /// Place of a parameter of the law of that name, which is added if it is new.
    const fn place(&mut self, law: &'static str, variable: &Variable) -> u16 {
        let offered = self.offered(law, variable);
        let place = self.find(&offered.path);
        if place < self.count {
            self.variables[place].bound = self.variables[place].bound.or(offered.bound);
        } else {
            self.variables[place] = offered;
            self.count += 1;
        }
        place as u16
    }

    /// Parameter of a law as offered here.
    const fn offered(&self, law: &'static str, variable: &Variable) -> Variable {
        let mut offered = *variable;
        if self.is_own(variable) {
            offered.path = variable.path.within(Segment { name: law, index: 0 });
        }
        if matches!(variable.meaning, Meaning::ElementCount) {
            offered.bound = variable.bound.up_to(ELEMENTS as f64);
        }
        if matches!(variable.meaning, Meaning::FallSpeed) {
            offered.help = STRIBECK_VELOCITY;
        }
        offered
    }

    /// Whether a law needs its own parameter of that name, because its default differs from the shared one. Variants of
    /// different laws are different choices under one name.
    const fn is_own(&self, variable: &Variable) -> bool {
        let shared = self.find(&variable.path);
        shared < self.count && self.variables[shared].start != variable.start
            || matches!(variable.meaning, Meaning::Variant)
    }

    /// Place of a name; the number of names if it is not there.
    const fn find(&self, path: &Path) -> usize {
        let mut at = 0;
        while at < self.count && !self.variables[at].path.is(path) {
            at += 1;
        }
        at
    }
}

static MERGED: Merged<COUNT> = Merged::of(&LAWS);

/// Number of parameters of all laws together.
const PARAMETERS: usize = MERGED.count;

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
    const TABLE: &'static [Variable] = MERGED.variables.split_at(PARAMETERS).0;
}

/// Place of a column of a law among the parameters of all laws; `None` if it is not offered.
pub(super) const fn place_of(law: usize, column: usize) -> Option<u16> {
    MERGED.places[law][column]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;
    use crate::model::{Law, Model, ModelType, real};
    use crate::reference::{self, Place, References};

    crate::model! {
        /// A law that no one has thought of, behind all others.
        Newcomer: "Law of a later version" {
            /// Velocity.
            velocity: input = real("m/s", 0.0).means(Meaning::Velocity),
            /// Stiffness, with a start value of its own.
            sigma_0: tunable = real("N/m", 7.0).means(Meaning::Stiffness),
            /// Parameter that no law has.
            novelty: tunable = real("1", 0.5).means(Meaning::Own),
            /// More numbers than any law remembers.
            past: [state; 200] = [real("N", 0.0).discrete(); 200],
            /// Dissipated energy.
            dissipated_energy: state_output = real("J", 0.0).means(Meaning::Energy),
            /// Friction force.
            friction_force: output = real("N", 0.0).means(Meaning::FrictionForce),
            /// Is the contact sticking?
            sticking: output = crate::model::boolean(false).means(Meaning::Sticking),
        }
    }

    impl<T: Copy> Law for Newcomer<T> {
        type Interface = crate::model::CoSimulation;

        fn output(&mut self) {}
    }

    impl Model for Newcomer {
        fn step(&mut self, _dt: f64) {}
    }

    static NEWCOMER: ModelType = ModelType::of::<Newcomer>();

    /// The table of a host of laws, in a library that has one law more, and remembers more.
    fn table_with_newcomer(host: &ModelType) -> Vec<Variable> {
        let newcomer = Declared { model: &NEWCOMER, table: Newcomer::TABLE };
        let laws: [Declared; COUNT + 1] = std::array::from_fn(|law| LAWS.get(law).copied().unwrap_or(newcomer));
        let Merged { variables, count, .. } = Merged::of(&laws);
        let own =
            |variable: Variable| LawParameters::TABLE.iter().any(|of_law| is_inside(&variable.path, &of_law.path));
        let first = host.table.iter().position(own).expect("parameters of laws");
        let mut table = host.table.iter().take(first).collect::<Vec<_>>();
        let place = host.table.at(first).path.segments()[0];
        table.extend(
            variables[..count].iter().map(|variable| Variable { path: variable.path.within(place), ..*variable }),
        );
        for variable in host.table.iter().skip(first + PARAMETERS) {
            table.push(variable);
            if variable.is_hidden {
                table.extend([variable; 3]);
            }
        }
        table
    }

    fn is_inside(path: &Path, name: &Path) -> bool {
        path.segments().len() > 1 && path.is(&name.within(path.segments()[0]))
    }

    /// A law with a parameter that no law has, and with a longer memory, adds variables and changes none.
    #[test]
    fn a_new_law_changes_no_variable_of_its_hosts() {
        for host in ["GuideContact", "ShockAbsorber"].map(|name| catalogue::by_name(name).expect("a model")) {
            let table = table_with_newcomer(host);
            assert!(table.len() > host.table.len());
            let states = table.iter().enumerate().filter(|(_, variable)| variable.is_continuous_state());
            let (columns, states): (Vec<u16>, Vec<&Variable>) = states.map(|(at, state)| (at as u16, state)).unzip();
            let columns_first = table.iter().map(|variable| reference::of(&variable.path)).chain([reference::TIME]);
            let derivatives = states.iter().map(|state| reference::of_derivative(&state.path));
            let places: Vec<u32> = columns_first.chain(derivatives).collect();
            let slots = reference::slots::<8192>(&table, &places);
            let references = References::new(slots.to_vec().leak(), places.leak(), columns.leak());
            for (column, variable) in host.variables() {
                let reference = host.reference(column);
                let Some(Place::Column(found)) = references.find(reference, table.len()) else {
                    panic!("{}: {} is gone", host.name, variable.path)
                };
                let found = &table[found];
                assert!(found.path.is(&variable.path) && found.role == variable.role && found.kind == variable.kind);
                assert_eq!(found.start, variable.start, "{}", variable.path);
            }
            let names: Vec<String> = table.iter().map(|variable| variable.path.to_string()).collect();
            let added: Vec<&String> = names.iter().filter(|name| host.find(name).is_none()).collect();
            let shown = added
                .iter()
                .filter(|name| !name.starts_with("memory") && !["started", "step_size"].contains(&name.as_str()));
            assert_eq!(
                shown.map(|name| name.as_str()).collect::<Vec<_>>(),
                ["friction.Newcomer.sigma_0", "friction.novelty"]
            );
        }
    }
}
