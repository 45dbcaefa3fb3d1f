//! Names of columns, in parts and with indices.

use std::fmt;

use crate::unit;

/// One step of a variable's name: `element[3]` has the name `element` and the index 3; index 0 means "no index".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Name.
    pub name: &'static str,
    /// Index from 1, or 0 for none.
    pub index: u16,
}

impl Segment {
    /// Rest of a name that begins with this step.
    fn strip_from<'a>(&self, name: &'a str) -> Option<&'a str> {
        let rest = name.strip_prefix(self.name)?;
        if self.index == 0 {
            return Some(rest);
        }
        let (index, rest) = rest.strip_prefix('[')?.split_once(']')?;
        let is_plain = index.starts_with(|first: char| matches!(first, '1'..='9'));
        (is_plain && index.parse() == Ok(self.index)).then_some(rest)
    }
}

/// The name of a variable, such as `velocity` or `element[3].stiffness` (FMI's structured naming).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path {
    pub(super) segments: [Segment; Path::DEPTH],
    pub(super) depth: usize,
}

impl Path {
    /// Maximum depth of nested parts.
    pub(super) const DEPTH: usize = 4;

    pub(super) const NONE: Path = Path { segments: [Segment { name: "", index: 0 }; Path::DEPTH], depth: 0 };

    /// The name of a column outside any part.
    pub const fn root(name: &'static str) -> Path {
        Path::NONE.within(Segment { name, index: 0 })
    }

    /// Its steps, outermost first.
    pub const fn segments(&self) -> &[Segment] {
        self.segments.split_at(self.depth).0
    }

    /// The name without its index, and the index, if exactly one of its steps has one.
    pub fn without_index(&self) -> Option<(Path, u16)> {
        let mut indexed = (0..self.depth).filter(|at| self.segments[*at].index > 0);
        let (Some(at), None) = (indexed.next(), indexed.next()) else { return None };
        let mut path = *self;
        let index = std::mem::take(&mut path.segments[at].index);
        Some((path, index))
    }

    /// The name of the table that an element belongs to: `damper.tab` for `damper.tab_v[1]`, `element` for
    /// `element[1].force`.
    pub(crate) fn stem(&self) -> Path {
        let at = self.segments().iter().position(|step| step.index > 0).unwrap_or_default();
        let name = self.segments[at].name;
        let is_last = at + 1 == self.depth;
        let name = name.rsplit_once('_').filter(|_| is_last).map_or(name, |(stem, _)| stem);
        // What lies deeper is no part of the name, and would tell equal names apart.
        let mut path = Path { depth: at + 1, ..Path::NONE };
        path.segments[..at].copy_from_slice(&self.segments[..at]);
        path.segments[at] = Segment { name, index: 0 };
        path
    }

    /// Whether both are the same name.
    pub(crate) const fn is(&self, other: &Path) -> bool {
        let mut at = 0;
        while at < self.depth && at < other.depth {
            let (a, b) = (self.segments[at], other.segments[at]);
            if a.index != b.index || !unit::same(a.name, b.name) {
                return false;
            }
            at += 1;
        }
        self.depth == other.depth
    }

    /// Whether this is the name, as spelled by [`Path`]'s `Display`. Nothing is written for that: C sources for controllers
    /// write no texts, but have presets by name.
    pub(crate) fn is_spelled(&self, name: &str) -> bool {
        let mut rest = Some(name);
        for (at, segment) in self.segments().iter().enumerate() {
            let after = if at == 0 { rest } else { rest.and_then(|rest| rest.strip_prefix('.')) };
            rest = after.and_then(|rest| segment.strip_from(rest));
        }
        rest == Some("")
    }

    /// This name inside a part.
    pub(crate) const fn within(&self, part: Segment) -> Path {
        assert!(self.depth < Path::DEPTH, "parts are nested too deeply");
        let mut path = Path { depth: self.depth + 1, ..Path::NONE };
        path.segments[0] = part;
        let mut at = 0;
        while at < self.depth {
            path.segments[at + 1] = self.segments[at];
            at += 1;
        }
        path
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (at, Segment { name, index }) in self.segments().iter().enumerate() {
            let dot = if at == 0 { "" } else { "." };
            match index {
                0 => write!(f, "{dot}{name}")?,
                _ => write!(f, "{dot}{name}[{index}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn element(index: u16) -> Path {
        Path::root("stiffness").within(Segment { name: "element", index })
    }

    #[test]
    fn names_are_equal_step_by_step() {
        assert!(element(3).is(&element(3)));
        assert!(!element(3).is(&element(2)));
        assert!(!element(3).is(&Path::root("element")), "another length");
        assert!(!Path::root("stiffness").is(&Path::root("stiffness").within(Segment { name: "stiffness", index: 0 })));
    }

    #[test]
    fn a_name_is_spelled_in_full() {
        assert!(element(3).is_spelled("element[3].stiffness"));
        for other in ["", "element", "element[3]", "element[3].stiffness ", "element[2].stiffness", "stiffness"] {
            assert!(!element(3).is_spelled(other), "{other}");
        }
        for other in ["element[03].stiffness", "element[+3].stiffness", "element[3]stiffness", "element.stiffness"] {
            assert!(!element(3).is_spelled(other), "{other}");
        }
        assert!(element(0).is_spelled("element.stiffness"));
        assert!(!element(0).is_spelled("element[0].stiffness"));
    }

    #[test]
    fn one_index_can_be_left_out() {
        let part = Segment { name: "part", index: 2 };
        let (path, index) = element(3).without_index().unwrap();
        assert_eq!((path.to_string().as_str(), index), ("element.stiffness", 3));
        assert_eq!(element(3).within(part).without_index(), None, "it has two");
        assert_eq!(Path::root("stiffness").without_index(), None);
    }

    #[test]
    fn elements_of_one_table_have_one_stem() {
        let table = Segment { name: "damper", index: 0 };
        for name in ["tab_v", "tab_f"] {
            let mut path = Path::root(name);
            path.segments[0].index = 4;
            assert_eq!(path.within(table).stem().to_string(), "damper.tab");
        }
        assert_eq!(element(3).stem().to_string(), "element");
    }

    #[test]
    #[should_panic(expected = "nested too deeply")]
    fn parts_are_nested_to_a_limit() {
        let part = Segment { name: "part", index: 0 };
        let _ = element(1).within(part).within(part).within(part);
    }
}
