//! How many bytes of the module's stack a function takes: how far below the end of the stack it counts.

use std::collections::{BTreeMap, BTreeSet};

use wasmparser::Operator;

/// The global variable that holds the end of the stack.
const END_OF_STACK: u32 = 0;

/// Bytes of the stack that a function takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    #[default]
    None,
    /// At most so many.
    Bytes(u32),
    /// It is not known.
    Unknown,
}

/// The operand that the last operator has left, as far as it is known.
#[derive(Clone, Copy)]
enum Last {
    /// An address so many bytes below the end of the stack before the call.
    Below(u32),
    /// A constant, after such an address.
    Constant(u32, i32),
    Other,
}

/// A search through the operators of a function, from the first to the last.
pub struct FrameSearch {
    pub found: Frame,
    last: Last,
    /// Local variables with addresses below the end of the stack.
    below: BTreeMap<u32, u32>,
    /// Local variables that have got a value. One that gets another is known no longer.
    assigned: BTreeSet<u32>,
}

impl Default for FrameSearch {
    fn default() -> FrameSearch {
        FrameSearch { found: Frame::None, last: Last::Other, below: BTreeMap::new(), assigned: BTreeSet::new() }
    }
}

impl FrameSearch {
    /// Looks at the next operator.
    pub fn add(&mut self, operator: &Operator) {
        self.last = match (self.last, operator) {
            (_, Operator::GlobalGet { global_index: END_OF_STACK }) => self.begin(),
            (last, Operator::GlobalSet { global_index: END_OF_STACK }) => self.move_to(last),
            (last, Operator::LocalSet { local_index }) => {
                self.assign(*local_index, last);
                Last::Other
            }
            (last, Operator::LocalTee { local_index }) => {
                self.assign(*local_index, last);
                last
            }
            (_, Operator::LocalGet { local_index }) => {
                self.below.get(local_index).map_or(Last::Other, |at| Last::Below(*at))
            }
            (Last::Below(at), Operator::I32Const { value }) => Last::Constant(at, *value),
            (Last::Constant(at, value), Operator::I32Sub) if value >= 0 => self.reach(at.saturating_add(value as u32)),
            (Last::Constant(at, value), Operator::I32Add) if value < 0 => {
                self.reach(at.saturating_add(value.unsigned_abs()))
            }
            (Last::Constant(at, value), Operator::I32Add) if value as u32 <= at => Last::Below(at - value as u32),
            // An alignment to a power of two.
            (Last::Constant(at, value), Operator::I32And) if value < 0 && value.unsigned_abs().is_power_of_two() => {
                self.reach(at.saturating_add(value.unsigned_abs() - 1))
            }
            _ => Last::Other,
        };
    }

    /// The end of the stack is read. Once it has moved, it is no longer that before the call.
    fn begin(&mut self) -> Last {
        if self.found != Frame::None {
            self.found = Frame::Unknown;
        }
        self.reach(0)
    }

    /// The end of the stack is moved.
    fn move_to(&mut self, last: Last) -> Last {
        if !matches!(last, Last::Below(_)) {
            self.found = Frame::Unknown;
        }
        Last::Other
    }

    /// An address so many bytes below the end of the stack: a function that calls no other takes it without moving the
    /// end.
    fn reach(&mut self, below: u32) -> Last {
        self.found = match self.found {
            Frame::None => Frame::Bytes(below),
            Frame::Bytes(known) => Frame::Bytes(known.max(below)),
            Frame::Unknown => Frame::Unknown,
        };
        Last::Below(below)
    }

    fn assign(&mut self, local: u32, last: Last) {
        self.below.remove(&local);
        if let (true, Last::Below(at)) = (self.assigned.insert(local), last) {
            self.below.insert(local, at);
        }
    }
}

#[cfg(test)]
mod tests {
    use Operator::{GlobalGet, GlobalSet, I32Add, I32And, I32Const, I32Sub, LocalGet, LocalSet, LocalTee};

    use super::*;

    const GET: Operator = GlobalGet { global_index: 0 };
    const SET: Operator = GlobalSet { global_index: 0 };

    fn frame(operators: &[Operator]) -> Frame {
        let mut search = FrameSearch::default();
        operators.iter().for_each(|operator| search.add(operator));
        search.found
    }

    /// As compilers begin and end a function.
    #[test]
    fn a_frame_is_known_if_the_stack_moves_by_constants() {
        let begin = [GET, I32Const { value: 48 }, I32Sub, LocalTee { local_index: 2 }, SET];
        let end = [LocalGet { local_index: 2 }, I32Const { value: 48 }, I32Add, SET];
        assert_eq!(frame(&[]), Frame::None);
        assert_eq!(frame(&begin), Frame::Bytes(48));
        assert_eq!(frame(&[&begin[..], &end].concat()), Frame::Bytes(48));
        assert_eq!(frame(&begin[..4]), Frame::Bytes(48), "below the end");
        assert_eq!(frame(&[GET, I32Const { value: -48 }, I32Add]), Frame::Bytes(48), "below the end");
        assert_eq!(frame(&[begin.clone(), begin].concat()), Frame::Unknown);
        assert_eq!(frame(&[Operator::Nop, GET]), Frame::Bytes(0));
    }

    /// The end of the stack is kept, and used later.
    #[test]
    fn frames_may_begin_late_and_be_aligned() {
        let keep = [GET, LocalSet { local_index: 4 }, LocalGet { local_index: 1 }];
        let begin = [LocalGet { local_index: 4 }, I32Const { value: 160 }, I32Sub];
        let align = [I32Const { value: -64 }, I32And];
        assert_eq!(frame(&[&keep[..], &begin, &[SET]].concat()), Frame::Bytes(160));
        assert_eq!(frame(&[&keep[..], &begin, &align, &[SET]].concat()), Frame::Bytes(160 + 63));
        assert_eq!(frame(&[&keep[..], &begin, &[SET, LocalGet { local_index: 4 }, SET]].concat()), Frame::Bytes(160));
    }

    #[test]
    fn what_moves_the_stack_otherwise_is_not_known() {
        let keep = [GET, LocalSet { local_index: 4 }];
        let by_another = [GET, LocalGet { local_index: 1 }, I32Sub, SET];
        assert_eq!(frame(&by_another), Frame::Unknown);
        let changed = [LocalGet { local_index: 1 }, LocalSet { local_index: 4 }, LocalGet { local_index: 4 }, SET];
        assert_eq!(frame(&[&keep[..], &changed].concat()), Frame::Unknown);
        let upwards = [GET, I32Const { value: -16 }, I32Sub, SET];
        assert_eq!(frame(&upwards), Frame::Unknown);
    }
}
