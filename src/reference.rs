//! Value references: the numbers by which FMI and C know variables.
//!
//! A reference is a fingerprint of the variable's name. It stays the same wherever the variable stands in its table, and
//! whatever is added before or behind it: an interface can grow anywhere.

use crate::table::{Path, Segment, Variable};

/// Number of a variable in FMI and C.
pub type Reference = u32;

/// Quantity with a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A column of the row.
    Column(usize),
    /// The independent variable of FMI.
    Time,
    /// The time derivative of the continuous state in this column.
    Derivative(usize),
}

/// Reference of the independent variable.
pub const TIME: Reference = Fnv::START.text("time").reference();

/// Reference of the array of event indicators, which FMI 3.0 has as a variable.
pub const EVENT_INDICATORS: Reference = Fnv::START.text("event_indicators").reference();

/// Reference of the variable of that name.
pub const fn of(path: &Path) -> Reference {
    Fnv::START.path(path).reference()
}

/// Reference of the variable of that name, as spelled by [`Path`]'s `Display`.
pub(crate) const fn of_name(name: &str) -> Reference {
    Fnv::START.text(name).reference()
}

/// Reference of the variable whose name is that of `stem` with this ending.
pub(crate) const fn of_ending(stem: &Path, ending: &str) -> Reference {
    Fnv::START.path(stem).text(ending).reference()
}

/// Reference of the time derivative of a state, FMI's `der(name)`.
pub const fn of_derivative(state: &Path) -> Reference {
    Fnv::START.text("der(").path(state).text(")").reference()
}

/// FNV-1a of 32 bits (G. Fowler, L. C. Noll, K.-P. Vo; RFC 9923): offset basis and prime are those of its authors.
#[derive(Clone, Copy)]
struct Fnv(u32);

impl Fnv {
    const START: Fnv = Fnv(0x811c_9dc5);
    const PRIME: u64 = 0x0100_0193;

    const fn text(mut self, text: &str) -> Fnv {
        let bytes = text.as_bytes();
        let (mut at, end) = (0, bytes.len());
        while at < end {
            // As the wrapping product, which would be one more call to interpret.
            self = Fnv(((self.0 ^ bytes[at] as u32) as u64 * Fnv::PRIME) as u32);
            at += 1;
        }
        self
    }

    const fn number(self, number: u16) -> Fnv {
        const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
        let before = if number < 10 { self } else { self.number(number / 10) };
        before.text(DIGITS[(number % 10) as usize])
    }

    /// The name as it is displayed, such as `front.element[3].stiffness`.
    const fn path(mut self, path: &Path) -> Fnv {
        let segments = path.segments();
        let (mut at, end) = (0, segments.len());
        while at < end {
            let Segment { name, index } = segments[at];
            self = (if at > 0 { self.text(".") } else { self }).text(name);
            if index > 0 {
                self = self.text("[").number(index).text("]");
            }
            at += 1;
        }
        self
    }

    /// Without the highest bit: C's enumerators are of type `int`.
    const fn reference(self) -> Reference {
        self.0 & 0x7fff_ffff
    }
}

/// The references of a table, and the way back.
#[derive(Clone, Copy)]
pub struct References {
    /// Places of the references, in a hash table with open addressing; at least half of its slots are empty, so every
    /// search ends.
    slots: &'static [u16],
    /// References by place: of the columns, of time, of the derivatives of the states.
    places: &'static [Reference],
    /// Columns of the states.
    states: &'static [u16],
}

/// No place.
const EMPTY: u16 = u16::MAX;

impl References {
    /// For what [`slots`], [`places`] and [`states`] have found.
    pub const fn new(slots: &'static [u16], places: &'static [Reference], states: &'static [u16]) -> References {
        References { slots, places, states }
    }

    /// The quantity with this reference, in a table with so many columns.
    #[inline(always)]
    pub fn find(&self, reference: Reference, columns: usize) -> Option<Place> {
        let place = self.place(reference)?;
        if place < columns {
            return Some(Place::Column(place));
        }
        match place - columns {
            0 => Some(Place::Time),
            behind => self.states.get(behind - 1).map(|state| Place::Derivative(usize::from(*state))),
        }
    }

    /// Place of a reference.
    #[inline(always)]
    fn place(&self, reference: Reference) -> Option<usize> {
        let mut at = reference as usize;
        loop {
            let slot = *self.slots.get(at & (self.slots.len() - 1))?;
            // An empty slot leads to no place.
            let found = self.places.get(usize::from(slot))?;
            if *found == reference {
                return Some(usize::from(slot));
            }
            at += 1;
        }
    }
}

/// Number of the continuous states of a table.
pub const fn state_count(table: &[Variable]) -> usize {
    let (mut count, mut column) = (0, 0);
    while column < table.len() {
        count += table[column].is_continuous_state() as usize;
        column += 1;
    }
    count
}

/// Columns of the continuous states of a table.
pub const fn states<const STATES: usize>(table: &[Variable]) -> [u16; STATES] {
    let mut states = [0; STATES];
    let (mut count, mut column) = (0, 0);
    while column < table.len() {
        if table[column].is_continuous_state() {
            states[count] = column as u16;
            count += 1;
        }
        column += 1;
    }
    states
}

/// The references of a table: of its columns, of time, and of the derivatives of its states.
pub const fn places<const PLACES: usize>(table: &[Variable]) -> [Reference; PLACES] {
    assert!(PLACES < EMPTY as usize, "too many columns");
    let mut places = [TIME; PLACES];
    let (mut behind, mut column) = (table.len() + 1, 0);
    while column < table.len() {
        let variable = &table[column];
        places[column] = of(&variable.path);
        if variable.is_continuous_state() {
            assert!(!variable.is_hidden, "an importer that integrates needs the state");
            places[behind] = of_derivative(&variable.path);
            behind += 1;
        }
        column += 1;
    }
    places
}

/// Number of slots for so many references: a power of two, and at least twice their number.
pub const fn slot_count(places: &[Reference]) -> usize {
    (2 * places.len()).next_power_of_two()
}

/// The filled slots of a table. Two variables with one reference do not compile.
pub const fn slots<const COUNT: usize>(table: &[Variable], places: &[Reference]) -> [u16; COUNT] {
    let mut slots = [EMPTY; COUNT];
    let mut place = 0;
    while place < places.len() {
        // A hidden column is not found.
        if place >= table.len() || !table[place].is_hidden {
            insert(&mut slots, places, place);
        }
        place += 1;
    }
    slots
}

const fn insert(slots: &mut [u16], places: &[Reference], place: usize) {
    let mut at = places[place] as usize & (slots.len() - 1);
    while slots[at] != EMPTY {
        let other = places[slots[at] as usize];
        assert!(other != places[place], "two variables have the same value reference: rename one of them");
        at = (at + 1) & (slots.len() - 1);
    }
    slots[at] = place as u16;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;

    /// The published check values of FNV-1a 32, and the names as they are displayed.
    #[test]
    fn references_are_fingerprints_of_the_names() {
        assert_eq!(Fnv::START.text("").0, 0x811c_9dc5);
        assert_eq!(Fnv::START.text("foobar").0, 0xbf9c_f968);
        for model in catalogue::models() {
            for variable in model.table {
                let name = variable.path.to_string();
                assert_eq!(of(&variable.path), of_name(&name), "{name}");
                let derivative = Fnv::START.text(&format!("der({name})")).reference();
                assert_eq!(of_derivative(&variable.path), derivative, "{name}");
            }
        }
    }

    #[test]
    fn every_reference_leads_back_to_its_variable() {
        for model in catalogue::models() {
            assert_eq!(model.place(TIME), Some(Place::Time));
            for (column, variable) in model.table.iter().enumerate() {
                let shown = (!variable.is_hidden).then_some(Place::Column(column));
                assert_eq!(model.place(of(&variable.path)), shown);
                let derivative = variable.is_continuous_state().then_some(Place::Derivative(column));
                assert_eq!(model.place(of_derivative(&variable.path)), derivative, "{}", variable.path);
            }
            assert_eq!(model.place(of(&Path::root("no such variable"))), None);
            assert_eq!(model.place(u32::MAX), None);
        }
    }
}
