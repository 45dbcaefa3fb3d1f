//! Where the columns of a law's row come from: worked out for each law while the library is compiled.

use crate::model::{Column, Kind, Meaning, ModelType, Variable, real};
use crate::shock_absorber::law_list::{COUNT, Declared, GIVENS, HELD, LAWS, WIDEST, column, given, held};
use crate::shock_absorber::law_parameters::place_of;
use crate::unit::same;

/// Whether the variable is a state of the law. The energy is summed by the contact.
const fn is_remembered(variable: &Variable) -> bool {
    variable.role.is_state() && !matches!(variable.meaning, Meaning::Energy)
}

/// Most continuous states of a law with which a contact supports Model Exchange (chosen). FMI 2.0 fixes the number of
/// continuous states of a model, so that each contact has them with every law: with the elements of `Leuven` they would
/// be seventeen, nearly all of them idle with another law.
const MOST_MOVING: usize = 2;

const fn continuous_states(law: Declared) -> usize {
    let (mut count, mut at) = (0, 0);
    while at < law.table.len() {
        let variable = &law.table[at];
        count += (is_remembered(variable) && variable.is_continuous_state()) as usize;
        at += 1;
    }
    count
}

/// Whether a contact with the law supports Model Exchange.
const fn is_exchanged(law: Declared) -> bool {
    law.model.model_exchange && continuous_states(law) <= MOST_MOVING
}

/// Whether an importer that integrates the states itself integrates this one, if the law is exchanged.
const fn is_moving(is_exchanged: bool, variable: &Variable) -> bool {
    is_exchanged && is_remembered(variable) && variable.is_continuous_state()
}

/// Largest number of continuous states of a law in Model Exchange: they come first in the memory. A discrete state never
/// has such a place, where a solver may write anything.
const MOVING: usize = {
    let (mut most, mut law) = (0, 0);
    while law < COUNT {
        let count = if is_exchanged(LAWS[law]) { continuous_states(LAWS[law]) } else { 0 };
        if count > most {
            most = count;
        }
        law += 1;
    }
    most
};

/// First place for the discrete states of a law.
const fn first_jumping(is_exchanged: bool) -> usize {
    if is_exchanged { MOVING } else { 0 }
}

/// Number of places that suffices for the states of any law.
pub const MEMORY: usize = {
    let (mut most, mut at) = (0, 0);
    while at < COUNT {
        let is_exchanged = is_exchanged(LAWS[at]);
        let (mut places, mut column) = (first_jumping(is_exchanged), 0);
        while column < LAWS[at].table.len() {
            let variable = &LAWS[at].table[column];
            places += (is_remembered(variable) && !is_moving(is_exchanged, variable)) as usize;
            column += 1;
        }
        if places > most {
            most = places;
        }
        at += 1;
    }
    most
};

/// A column of a law's row, and its place in what it is copied from.
#[derive(Clone, Copy)]
pub(super) struct Link {
    pub(super) column: u16,
    pub(super) place: u16,
}

/// Some of all [`LINKS`], from the first to before the second.
#[derive(Clone, Copy)]
pub(super) struct Links(u16, u16);

impl Links {
    /// The links as columns and places.
    #[inline(always)]
    pub(super) fn pairs(self) -> impl Iterator<Item = (usize, usize)> + Clone {
        let links = LINKS.get(usize::from(self.0)..usize::from(self.1)).unwrap_or_default();
        links.iter().map(|link| (usize::from(link.column), usize::from(link.place)))
    }
}

/// Stands for a column that a law does not have; beyond every row.
const ABSENT: u16 = u16::MAX;

/// A law and the sources of the columns of its row. Columns without one are 0.
pub(super) struct Plan {
    pub(super) model: &'static ModelType,
    /// Whether a contact with the law supports Model Exchange.
    pub(super) is_exchanged: bool,
    /// Columns of the quantities of the contact.
    pub(super) given: [u16; GIVENS],
    /// Parameters, by their places among those of all laws.
    pub(super) parameters: Links,
    /// States, by their places in the memory.
    pub(super) memory: Links,
    /// Columns that have the law's own start value.
    pub(super) starts: Links,
    /// Columns of the forces of elements, if they carry the load.
    pub(super) elements: Links,
    pub(super) friction_force: usize,
    pub(super) sticking: usize,
    pub(super) dissipated_energy: usize,
    /// Place of its viscous coefficient among the parameters of all laws.
    pub(super) viscous: Option<usize>,
    /// State of the carried force.
    pub(super) carrier: Carrier,
    /// Number of places that it uses of the memory.
    pub(super) memory_in_use: usize,
}

/// State of the force that a law carries, which may come from a larger load than the present one.
#[derive(Clone, Copy)]
pub(super) enum Carrier {
    /// Nothing, or a share of the load, which falls with it.
    Share,
    /// Columns of the mean deflection of its bristles and of their stiffness.
    Deflection(usize, usize),
    /// Column of the force, viscous part included.
    Force(usize),
    /// Forces of elements, and the column of their total strength as a multiple of the static level, if the law has
    /// one.
    Elements(Option<usize>),
}

/// Source of the value of a column of a law's row.
#[derive(Clone, Copy)]
enum Source {
    /// The law's own start value.
    Start,
    /// A quantity of the contact.
    Given,
    /// A parameter of the law, by its place among those of all laws.
    Parameter(u16),
    /// A state of the law, by its place in the memory.
    Memory(u16),
}

static SOURCES: [[Source; WIDEST]; COUNT] = {
    let mut all = [[Source::Start; WIDEST]; COUNT];
    let mut at = 0;
    while at < COUNT {
        all[at] = sources(at);
        at += 1;
    }
    all
};

const fn sources(which: usize) -> [Source; WIDEST] {
    let law = LAWS[which];
    let is_exchanged = is_exchanged(law);
    let mut sources = [Source::Start; WIDEST];
    let (mut moving, mut jumping, mut at) = (0, first_jumping(is_exchanged), 0);
    while at < law.table.len() {
        let variable = &law.table[at];
        if given(variable).is_some() {
            sources[at] = Source::Given;
        } else if is_moving(is_exchanged, variable) {
            sources[at] = Source::Memory(moving);
            moving += 1;
        } else if is_remembered(variable) {
            sources[at] = Source::Memory(jumping as u16);
            jumping += 1;
        } else if let Some(place) = place_of(which, at) {
            sources[at] = Source::Parameter(place);
        }
        at += 1;
    }
    sources
}

/// The kinds of links of a law, in their order.
const KINDS: usize = 4;

/// Place to which a column is linked by links of a kind.
const fn place(law: usize, column: usize, kind: usize) -> Option<u16> {
    let variable = &LAWS[law].table[column];
    match (kind, SOURCES[law][column]) {
        (0, Source::Parameter(place)) | (1, Source::Memory(place)) => Some(place),
        (2, Source::Start) if variable.start != 0.0 => Some(0),
        (3, _) if is_carried_force(variable) && matches!(carrier(LAWS[law]), Carrier::Elements(_)) => Some(0),
        _ => None,
    }
}

/// All links of the laws that the library holds, and the first link of each kind of each law.
const fn link<const LINKS: usize>() -> ([Link; LINKS], [[u16; KINDS + 1]; COUNT], usize) {
    let mut links = [Link { column: ABSENT, place: 0 }; LINKS];
    let mut firsts = [[0; KINDS + 1]; COUNT];
    let (mut count, mut law) = (0, HELD.start);
    while law < HELD.end {
        let mut kind = 0;
        while kind < KINDS {
            firsts[law][kind] = count as u16;
            let mut column = 0;
            while column < LAWS[law].table.len() {
                if let Some(place) = place(law, column, kind) {
                    if count < LINKS {
                        links[count] = Link { column: column as u16, place };
                    }
                    count += 1;
                }
                column += 1;
            }
            kind += 1;
        }
        firsts[law][KINDS] = count as u16;
        law += 1;
    }
    (links, firsts, count)
}

/// The first link of each kind of each law, and the number of all links.
static FIRSTS: ([[u16; KINDS + 1]; COUNT], usize) = {
    let (_, firsts, count) = link::<0>();
    (firsts, count)
};

static LINKS: [Link; FIRSTS.1] = link().0;

/// The laws that the library holds in their order, with the sources of their columns.
pub(super) static PLANS: [Plan; HELD.end - HELD.start] = {
    let mut plans = [const { plan(0, [0; KINDS + 1]) }; HELD.end - HELD.start];
    let mut at = HELD.start;
    while at < HELD.end {
        plans[at - HELD.start] = plan(at, FIRSTS.0[at]);
        at += 1;
    }
    plans
};

const fn plan(at: usize, firsts: [u16; KINDS + 1]) -> Plan {
    let law = LAWS[at];
    let mut givens = [ABSENT; GIVENS];
    let (mut memory_in_use, mut column) = (0, 0);
    while column < law.table.len() {
        match SOURCES[at][column] {
            Source::Given => {
                if let Some(which) = given(&law.table[column]) {
                    givens[which] = column as u16;
                }
            }
            Source::Memory(place) if place as usize >= memory_in_use => memory_in_use = place as usize + 1,
            _ => {}
        }
        column += 1;
    }
    Plan {
        model: held(at),
        is_exchanged: is_exchanged(law),
        given: givens,
        parameters: Links(firsts[0], firsts[1]),
        memory: Links(firsts[1], firsts[2]),
        starts: Links(firsts[2], firsts[3]),
        elements: Links(firsts[3], firsts[4]),
        friction_force: named(law, Meaning::FrictionForce),
        sticking: named(law, Meaning::Sticking),
        dissipated_energy: named(law, Meaning::Energy),
        viscous: viscous(at),
        carrier: carrier(law),
        memory_in_use,
    }
}

const fn named(law: Declared, meaning: Meaning) -> usize {
    column(law, meaning).expect("every law has a force, says whether it sticks and counts its energy")
}

/// Place of the viscous coefficient of a law.
const fn viscous(law: usize) -> Option<usize> {
    match column(LAWS[law], Meaning::Viscous) {
        Some(at) => match SOURCES[law][at] {
            Source::Parameter(place) => Some(place as usize),
            _ => None,
        },
        None => None,
    }
}

/// Whether the variable is a state that holds the force of an element or the whole force.
const fn is_carried_force(variable: &Variable) -> bool {
    let is_force = match variable.kind {
        Kind::Real(unit) => same(unit.name, "N"),
        _ => false,
    };
    is_force && is_remembered(variable) && variable.is_continuous_state()
}

const fn carrier(law: Declared) -> Carrier {
    let mut at = 0;
    while at < law.table.len() {
        if is_carried_force(&law.table[at]) {
            let is_element = law.table[at].path.segments()[0].index > 0;
            return if is_element { Carrier::Elements(column(law, Meaning::Strength)) } else { Carrier::Force(at) };
        }
        at += 1;
    }
    match (column(law, Meaning::Deflection), column(law, Meaning::Stiffness)) {
        (Some(deflection), Some(stiffness)) => Carrier::Deflection(deflection, stiffness),
        _ => Carrier::Share,
    }
}

/// Columns of a memory; `nominal` is the typical size of its continuous states. Only these are variables: a law that
/// remembers more changes no interface.
pub(crate) const fn blank_memory(nominal: f64) -> [Column; MEMORY] {
    let mut memory = [real("1", 0.0).discrete().hidden(); MEMORY];
    let mut at = 0;
    while at < MOVING {
        memory[at] = real("1", 0.0).nominal(nominal).reinit();
        at += 1;
    }
    memory
}
