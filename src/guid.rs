//! The fingerprint of a model's table, computed while the library is compiled.
//!
//! An FMU's XML carries the guid of the table it was written from; a library built from another table refuses it.

use crate::table::{Kind, Role, Segment, Variable};

/// A guid in the registry form `{xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx}`, as ASCII.
pub type GuidText = [u8; 38];

/// Fingerprint of a model: its name, everything about its columns that a caller depends on (name, role, type, unit,
/// start, bounds, nominal value, whether a state jumps), and the number of its event indicators if it supports Model
/// Exchange. Help texts, display units and the documentation of the model are left out: rewording them breaks nothing.
pub const fn fingerprint(model: &str, table: &[Variable], event_indicators: Option<usize>) -> GuidText {
    let mut hash = text(Fnv::START, model);
    let mut column = 0;
    while column < table.len() {
        hash = variable(hash, &table[column]);
        column += 1;
    }
    if let Some(count) = event_indicators {
        hash = byte(hash, count as u8);
    }
    spell(hash.0)
}

/// The guid of a description in which all variables are Real, which follows from that of the model.
pub const fn plain(guid: &GuidText) -> GuidText {
    spell(text(bytes(Fnv::START, guid), "all variables are Real").0)
}

/// FNV-1a with 128 bits (G. Fowler, L. C. Noll, K.-P. Vo; RFC 9923): offset basis and prime as published.
#[derive(Clone, Copy)]
struct Fnv(u128);

impl Fnv {
    const START: Fnv = Fnv(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
}

const fn byte(hash: Fnv, byte: u8) -> Fnv {
    Fnv((hash.0 ^ byte as u128).wrapping_mul(Fnv::PRIME))
}

const fn bytes(mut hash: Fnv, bytes: &[u8]) -> Fnv {
    let (mut at, end) = (0, bytes.len());
    while at < end {
        hash = byte(hash, bytes[at]);
        at += 1;
    }
    hash
}

/// The terminating zero keeps ("ab", "c") and ("a", "bc") apart.
const fn text(hash: Fnv, text: &str) -> Fnv {
    byte(bytes(hash, text.as_bytes()), 0)
}

const fn number(hash: Fnv, value: f64) -> Fnv {
    bytes(hash, &value.to_bits().to_le_bytes())
}

const fn variable(mut hash: Fnv, variable: &Variable) -> Fnv {
    let segments = variable.path.segments();
    let mut at = 0;
    while at < segments.len() {
        let Segment { name, index } = segments[at];
        hash = bytes(text(hash, name), &index.to_le_bytes());
        at += 1;
    }
    hash = byte(hash, role(variable.role));
    hash = match variable.kind {
        Kind::Real(unit) => text(byte(hash, 0), unit.name),
        Kind::Integer => byte(hash, 1),
        Kind::Boolean => byte(hash, 2),
        Kind::Enumeration(items) => {
            hash = text(byte(hash, 3), items.name);
            let mut at = 0;
            while at < items.items.len() {
                hash = text(hash, items.items[at].name);
                at += 1;
            }
            hash
        }
    };
    if variable.role.is_state() && variable.jumps && matches!(variable.kind, Kind::Real(_)) {
        hash = byte(hash, 1);
    }
    let Variable { start, bound, nominal, .. } = *variable;
    number(number(number(number(hash, start), bound.min()), bound.max()), nominal)
}

const fn role(role: Role) -> u8 {
    match role {
        Role::Input => 0,
        Role::Fixed => 1,
        Role::Tunable => 2,
        Role::State => 3,
        Role::StateOutput => 4,
        Role::Output => 5,
    }
}

const fn spell(hash: u128) -> GuidText {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let mut out = [b'-'; 38];
    out[0] = b'{';
    out[37] = b'}';
    let mut at = 1;
    let mut digit = 0;
    while at < 37 {
        if !(at == 9 || at == 14 || at == 19 || at == 24) {
            out[at] = DIGITS[((hash >> (124 - 4 * digit)) & 0xf) as usize];
            digit += 1;
        }
        at += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Column, Enumeration, Item, Path, boolean, choice, integer, real};

    /// The published check value of FNV-1a 128 for the text "foobar".
    #[test]
    fn hash_agrees_with_its_authors_test_vector() {
        let hash = bytes(Fnv::START, b"foobar");
        assert_eq!(hash.0, 0x343e_1662_793c_64bf_6f0d_3597_ba44_6f18);
    }

    #[test]
    fn plain_guids_are_as_different_as_the_others() {
        let guids = ["M", "N"].map(|model| fingerprint(model, &[], None));
        let [a, b] = guids.map(|guid| plain(&guid));
        assert!(a != b && !guids.contains(&a) && !guids.contains(&b));
        assert_eq!(a[0], b'{');
    }

    #[test]
    fn any_change_that_a_caller_sees_changes_the_guid() {
        let column = |name, start, unit| real(unit, start).named(Path::root(name), Role::Input, "help");
        let base = fingerprint("M", &[column("a", 0.0, "m")], None);
        assert_ne!(base, fingerprint("N", &[column("a", 0.0, "m")], None));
        assert_ne!(base, fingerprint("M", &[column("b", 0.0, "m")], None));
        assert_ne!(base, fingerprint("M", &[column("a", 1.0, "m")], None));
        assert_ne!(base, fingerprint("M", &[column("a", 0.0, "N")], None));
        assert_ne!(base, fingerprint("M", &[], None));
        let seen = |column: Column, role| fingerprint("M", &[column.named(Path::root("a"), role, "help")], None);
        const CHOICES: Enumeration = Enumeration { name: "Side", items: &[Item { name: "Left", help: "Left." }] };
        assert_ne!(base, fingerprint("M", &[column("a", 0.0, "m")], Some(0)));
        let all = [
            seen(real("m", 1.0), Role::Input),
            seen(real("m", 1.0), Role::Fixed),
            seen(real("m", 1.0), Role::Tunable),
            seen(real("m", 1.0), Role::State),
            seen(real("m", 1.0).discrete(), Role::State),
            seen(real("m", 1.0), Role::StateOutput),
            seen(real("m", 1.0), Role::Output),
            seen(real("m", 1.0).at_least(0.0), Role::Input),
            seen(real("m", 1.0).positive(), Role::Input),
            seen(real("m", 1.0).at_most(2.0), Role::Input),
            seen(real("m", 1.0).nominal(2.0), Role::Input),
            seen(integer(1), Role::Input),
            seen(boolean(true), Role::Input),
            seen(choice(&CHOICES, 1), Role::Input),
        ];
        for (at, one) in all.iter().enumerate() {
            assert!(!all[..at].contains(one), "{at}");
        }
    }
}
