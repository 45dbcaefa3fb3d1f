//! Tables as the library keeps them: without pointers, which a host would have to relocate whenever it loads the
//! library. Texts and numbers stand once in each table; its columns hold their places.

use std::ops::Range;

use super::{BaseType, Bound, Computed, Enumeration, Kind, Meaning, Path, Role, Segment, Variable};
use crate::unit::{self, UNITS};

/// The table of a model.
#[derive(Clone, Copy)]
pub struct Table {
    columns: &'static [Packed],
    /// All texts, one after the other.
    letters: &'static str,
    /// Where each text ends and the next one begins.
    ends: &'static [u16],
    numbers: &'static [f64],
    choices: &'static [&'static Enumeration],
}

/// A variable, with its texts, numbers and choices by their places in the table.
#[derive(Clone, Copy)]
pub struct Packed {
    names: [u16; Path::DEPTH],
    indices: [u16; Path::DEPTH],
    help: u16,
    display: u16,
    /// Start value, bounds and nominal value.
    numbers: [u16; 4],
    depth: u8,
    role: Role,
    kind: Tag,
    flags: u8,
    meaning: Meaning,
}

/// A [`Kind`]; units and choices by their places.
#[derive(Clone, Copy)]
enum Tag {
    Real(u8),
    Integer,
    Boolean,
    Enumeration(u8),
}

/// Bits of [`Packed::flags`].
const JUMPS: u8 = 1;
const REINIT: u8 = 2;
const ADVICE: u8 = 4;
const HIDDEN: u8 = 8;
const ODD: u8 = 16;

impl Packed {
    const BLANK: Packed = Packed {
        names: [0; Path::DEPTH],
        indices: [0; Path::DEPTH],
        help: 0,
        display: 0,
        numbers: [0; 4],
        depth: 0,
        role: Role::Output,
        kind: Tag::Integer,
        flags: 0,
        meaning: Meaning::Undeclared,
    };
}

impl Table {
    /// Number of columns.
    pub const fn len(&self) -> usize {
        self.columns.len()
    }

    /// Whether there are no columns.
    pub const fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    /// The variable of a column. Panics beyond the last one.
    pub const fn at(&self, column: usize) -> Variable {
        let Packed { names, indices, help, display, numbers, depth, role, kind, flags, meaning } = self.columns[column];
        let mut path = Path { depth: depth as usize, ..Path::NONE };
        let mut at = 0;
        while at < path.depth {
            path.segments[at] = Segment { name: self.text(names[at]), index: indices[at] };
            at += 1;
        }
        let kind = match kind {
            Tag::Real(unit) => Kind::Real(&UNITS[unit as usize]),
            Tag::Integer => Kind::Integer,
            Tag::Boolean => Kind::Boolean,
            Tag::Enumeration(choices) => Kind::Enumeration(self.choices[choices as usize]),
        };
        let [start, low, high, nominal] = numbers;
        let display = self.text(display);
        Variable {
            path,
            role,
            kind,
            start: self.number(start),
            bound: Bound { low: self.number(low), high: self.number(high) },
            nominal: self.number(nominal),
            display: if display.is_empty() { None } else { Some(display) },
            jumps: flags & JUMPS != 0,
            reinit: flags & REINIT != 0,
            is_advice: flags & ADVICE != 0,
            is_hidden: flags & HIDDEN != 0,
            is_odd: flags & ODD != 0,
            meaning,
            help: self.text(help),
        }
    }

    /// The variable of a column, if the column exists.
    pub fn get(&self, column: usize) -> Option<Variable> {
        (column < self.len()).then(|| self.at(column))
    }

    /// Start value of a column.
    #[inline]
    pub(crate) fn start(&self, column: usize) -> f64 {
        self.number(self.columns[column].numbers[0])
    }

    /// Bounds of a column.
    #[inline]
    pub(crate) fn bound(&self, column: usize) -> Bound {
        let [_, low, high, _] = self.columns[column].numbers;
        Bound { low: self.number(low), high: self.number(high) }
    }

    /// Nominal value of a column.
    #[inline]
    pub fn nominal(&self, column: usize) -> f64 {
        self.number(self.columns[column].numbers[3])
    }

    /// Role of a column.
    #[inline]
    pub(crate) fn role(&self, column: usize) -> Role {
        self.columns[column].role
    }

    /// FMI's type of a column.
    #[inline]
    pub fn base_type(&self, column: usize) -> BaseType {
        match self.columns[column].kind {
            Tag::Real(_) => BaseType::Real,
            Tag::Integer | Tag::Enumeration(_) => BaseType::Integer,
            Tag::Boolean => BaseType::Boolean,
        }
    }

    /// The column that plays a part in a law of friction, not within one of its parts.
    pub fn of(&self, meaning: Meaning) -> Option<usize> {
        self.columns.iter().position(|column| column.meaning == meaning && column.depth == 1)
    }

    /// Outputs that must be computed before a column can be read.
    #[inline]
    pub fn needs(&self, column: usize) -> Computed {
        let Packed { role, flags, .. } = self.columns[column];
        Computed::before(role, flags & ADVICE != 0)
    }

    /// The variables in the order of their columns.
    pub fn iter(&self) -> Variables {
        Variables { table: *self, columns: 0..self.len() }
    }

    const fn text(&self, place: u16) -> &'static str {
        let from = if place == 0 { 0 } else { self.ends[place as usize - 1] as usize };
        self.letters.split_at(self.ends[place as usize] as usize).0.split_at(from).1
    }

    const fn number(&self, place: u16) -> f64 {
        self.numbers[place as usize]
    }
}

impl IntoIterator for Table {
    type Item = Variable;
    type IntoIter = Variables;

    fn into_iter(self) -> Variables {
        self.iter()
    }
}

/// Iterator over the variables of a table.
#[derive(Clone)]
pub struct Variables {
    table: Table,
    columns: Range<usize>,
}

impl Iterator for Variables {
    type Item = Variable;

    fn next(&mut self) -> Option<Variable> {
        self.columns.next().map(|column| self.table.at(column))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.columns.size_hint()
    }
}

impl DoubleEndedIterator for Variables {
    fn next_back(&mut self) -> Option<Variable> {
        self.columns.next_back().map(|column| self.table.at(column))
    }
}

impl ExactSizeIterator for Variables {}

/// Largest number of different texts, and of different numbers, in a table; too small a value does not compile.
const MOST: usize = 1 << 11;

/// A table on the way to its packed form: its columns, and its texts, numbers and choices, each once.
///
/// The compiler interprets this for every model, slowly: a call costs most. That is why lengths are asked for once, and
/// products are taken in wider integers.
pub struct Pool<const COLUMNS: usize> {
    columns: [Packed; COLUMNS],
    texts: [&'static str; MOST],
    text_count: usize,
    /// Hash table of the places of the texts, plus 1; 0 for an empty slot.
    slots: [u16; 2 * MOST],
    /// By their bits, so that -0 and 0 are two.
    numbers: [u64; MOST],
    number_count: usize,
    choices: [Option<&'static Enumeration>; u8::MAX as usize],
    choice_count: usize,
}

impl<const COLUMNS: usize> Pool<COLUMNS> {
    /// Packs a table.
    pub const fn of(table: &[Variable]) -> Pool<COLUMNS> {
        let mut pool = Pool {
            columns: [Packed::BLANK; COLUMNS],
            texts: [""; MOST],
            text_count: 0,
            slots: [0; 2 * MOST],
            numbers: [0; MOST],
            number_count: 0,
            choices: [None; u8::MAX as usize],
            choice_count: 0,
        };
        pool.text(""); // so that there is a first text
        let mut column = 0;
        while column < COLUMNS {
            pool.columns[column] = pool.pack(&table[column]);
            column += 1;
        }
        pool
    }

    /// Numbers of letters, texts, numbers and choices.
    pub const fn sizes(&self) -> [usize; 4] {
        let (mut letters, mut at) = (0, 0);
        while at < self.text_count {
            letters += self.texts[at].len();
            at += 1;
        }
        [letters, self.text_count, self.number_count, self.choice_count]
    }

    /// The choices.
    pub const fn choices<const CHOICES: usize>(&self) -> [&'static Enumeration; CHOICES] {
        let mut choices = [&Enumeration { name: "", items: &[] }; CHOICES];
        let mut place = 0;
        while place < CHOICES {
            choices[place] = self.choices[place].expect("as many as were counted");
            place += 1;
        }
        choices
    }

    const fn pack(&mut self, variable: &Variable) -> Packed {
        let Variable { path, role, kind, start, bound, nominal, help, .. } = *variable;
        let mut packed = Packed { role, meaning: variable.meaning, depth: path.depth as u8, ..Packed::BLANK };
        let segments = path.segments();
        let mut at = 0;
        while at < segments.len() {
            packed.names[at] = self.text(segments[at].name);
            packed.indices[at] = segments[at].index;
            at += 1;
        }
        packed.help = self.text(help);
        packed.display = match variable.display {
            Some(display) => self.text(display),
            None => self.text(""),
        };
        packed.numbers = [self.number(start), self.number(bound.low), self.number(bound.high), self.number(nominal)];
        packed.kind = match kind {
            Kind::Real(unit) => Tag::Real(unit::place(unit.name) as u8),
            Kind::Integer => Tag::Integer,
            Kind::Boolean => Tag::Boolean,
            Kind::Enumeration(choices) => Tag::Enumeration(self.choice(choices)),
        };
        packed.flags = variable.jumps as u8 * JUMPS
            + variable.reinit as u8 * REINIT
            + variable.is_advice as u8 * ADVICE
            + variable.is_hidden as u8 * HIDDEN
            + variable.is_odd as u8 * ODD;
        packed
    }

    const fn text(&mut self, text: &'static str) -> u16 {
        let mut slot = hash(text) as usize % (2 * MOST);
        while self.slots[slot] != 0 {
            let place = self.slots[slot] - 1;
            if unit::same(self.texts[place as usize], text) {
                return place;
            }
            slot = (slot + 1) % (2 * MOST);
        }
        self.texts[self.text_count] = text;
        self.text_count += 1;
        self.slots[slot] = self.text_count as u16;
        self.text_count as u16 - 1
    }

    const fn number(&mut self, number: f64) -> u16 {
        let (bits, mut place) = (number.to_bits(), 0);
        while place < self.number_count {
            if self.numbers[place] == bits {
                return place as u16;
            }
            place += 1;
        }
        self.numbers[place] = bits;
        self.number_count += 1;
        place as u16
    }

    const fn choice(&mut self, choices: &'static Enumeration) -> u8 {
        let mut place = 0;
        while let Some(known) = self.choices[place] {
            if unit::same(known.name, choices.name) {
                return place as u8;
            }
            place += 1;
        }
        self.choices[place] = Some(choices);
        self.choice_count += 1;
        place as u8
    }
}

const fn hash(text: &str) -> u32 {
    let (bytes, mut hash, mut at) = (text.as_bytes(), 0x811c_9dc5u32, 0);
    let end = bytes.len();
    while at < end {
        hash = ((hash ^ bytes[at] as u32) as u64 * 0x0100_0193) as u32;
        at += 1;
    }
    hash ^ (hash >> 15)
}

/// The parts of a [`Table`] that have no pointers, with the sizes that [`Pool::sizes`] has found.
pub struct Parts<const COLUMNS: usize, const LETTERS: usize, const TEXTS: usize, const NUMBERS: usize> {
    columns: [Packed; COLUMNS],
    letters: [u8; LETTERS],
    ends: [u16; TEXTS],
    numbers: [f64; NUMBERS],
}

impl<const COLUMNS: usize, const LETTERS: usize, const TEXTS: usize, const NUMBERS: usize>
    Parts<COLUMNS, LETTERS, TEXTS, NUMBERS>
{
    /// The parts of a table with this pool.
    pub const fn of(pool: &Pool<COLUMNS>) -> Self {
        let (letters, ends) = Self::spell(pool);
        let (mut numbers, mut place) = ([0.0; NUMBERS], 0);
        while place < NUMBERS {
            numbers[place] = f64::from_bits(pool.numbers[place]);
            place += 1;
        }
        Parts { columns: pool.columns, letters, ends, numbers }
    }

    /// All texts, and where they end.
    const fn spell(pool: &Pool<COLUMNS>) -> ([u8; LETTERS], [u16; TEXTS]) {
        let (mut letters, mut ends) = ([0; LETTERS], [0; TEXTS]);
        let (mut end, mut place) = (0, 0);
        while place < TEXTS {
            let text = pool.texts[place].as_bytes();
            letters.split_at_mut(end).1.split_at_mut(text.len()).0.copy_from_slice(text);
            end += text.len();
            assert!(end <= u16::MAX as usize, "too many texts for a table");
            ends[place] = end as u16;
            place += 1;
        }
        (letters, ends)
    }

    /// The table, with its choices.
    pub const fn with(&'static self, choices: &'static [&'static Enumeration]) -> Table {
        let letters = match str::from_utf8(&self.letters) {
            Ok(letters) => letters,
            Err(_) => panic!("texts one after the other are a text"),
        };
        let Parts { columns, ends, numbers, .. } = self;
        Table { columns, letters, ends, numbers, choices }
    }
}

/// Packs a table that is a constant.
#[macro_export]
macro_rules! packed {
    ($table:expr) => {{
        const COLUMNS: usize = $table.len();
        const POOL: &$crate::table::Pool<COLUMNS> = &$crate::table::Pool::of($table);
        const SIZES: [usize; 4] = POOL.sizes();
        const PARTS: &$crate::table::Parts<COLUMNS, { SIZES[0] }, { SIZES[1] }, { SIZES[2] }> =
            &$crate::table::Parts::of(POOL);
        PARTS.with(const { &POOL.choices::<{ SIZES[3] }>() })
    }};
}

#[cfg(test)]
mod tests {
    use crate::catalogue;
    use crate::model::{Model, Visitor};

    struct Comparison(usize);

    impl Visitor for Comparison {
        fn visit<M: Model>(&mut self) {
            assert_eq!(M::COLUMNS.len(), M::TABLE.len());
            for (packed, declared) in M::COLUMNS.iter().zip(M::TABLE) {
                assert_eq!(format!("{packed:?}"), format!("{declared:?}"), "{}", M::NAME);
                self.0 += 1;
            }
        }
    }

    #[test]
    fn packed_tables_say_what_was_declared() {
        let mut compared = Comparison(0);
        catalogue::visit(&mut compared);
        assert!(compared.0 > 2000);
    }

    #[test]
    fn short_answers_agree_with_the_variables() {
        for table in catalogue::models().map(|model| model.table) {
            for (column, variable) in table.iter().enumerate() {
                assert_eq!(table.start(column), variable.start);
                assert_eq!((table.nominal(column), table.bound(column)), (variable.nominal, variable.bound));
                assert_eq!((table.role(column), table.needs(column)), (variable.role, variable.needs()));
                assert_eq!(table.base_type(column), variable.kind.base_type());
                assert!(table.get(column).is_some_and(|found| found.path == variable.path));
            }
            assert!(table.get(table.len()).is_none());
            assert_eq!(
                table.iter().next_back().map(|last| last.path),
                table.get(table.len() - 1).map(|last| last.path)
            );
        }
    }
}
