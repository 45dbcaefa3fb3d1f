//! Two instances, saved states, and the calls that both versions of FMI have. The invariants are checked after each.

use std::ffi::c_void;
use std::ptr::null_mut;

use stribeck::model::ModelType;
use stribeck_ffi::fmi2::lifecycle::Purpose;

use crate::argument::{Column, Number, variable};
use crate::saved::{self, ROW, STATE, TIME};
use crate::slave::{Slave, all_finite, same_bits};
use crate::version::{Answer, Version};

/// Steps with nonsensical numbers are expensive; longer sequences find nothing new.
pub const MOST_ACTIONS: usize = 48;
/// Arguments of one call.
pub const MOST_ARGUMENTS: usize = 12;
/// Saved states that are kept.
pub const SLOTS: usize = 3;

/// A saved state and its contents.
struct Saved {
    state: *mut c_void,
    model: &'static ModelType,
    numbers: Vec<f64>,
}

/// Two instances.
pub struct World<V: Version> {
    /// The instances.
    pub slaves: [Slave<V>; 2],
    /// Their contents after the last call.
    pub seen: [Vec<f64>; 2],
    slots: [Option<Saved>; SLOTS],
    bytes: [Vec<u8>; SLOTS],
}

/// Effect of a successful call on the instance.
pub enum Effect {
    /// It only reads: at most the results are computed.
    Reads,
    /// It changes the instance.
    Changes,
}
use Effect::{Changes, Reads};

impl<V: Version> Drop for World<V> {
    fn drop(&mut self) {
        for saved in self.slots.iter_mut().flatten() {
            let owner = Slave::<V>::new(saved.model, false, V::Choice::default());
            // SAFETY: a live state, freed once.
            assert_eq!(unsafe { V::free(owner.c, &mut saved.state) }, Answer::Ok);
        }
    }
}

impl<V: Version> World<V> {
    /// Instances of these models.
    pub fn new(models: [&'static ModelType; 2], exchange: [bool; 2], choices: [V::Choice; 2]) -> World<V> {
        let slaves = [0, 1].map(|who| Slave::new(models[who], exchange[who], choices[who]));
        let seen = [0, 1].map(|who: usize| slaves[who].numbers());
        World { slaves, seen, slots: Default::default(), bytes: Default::default() }
    }

    /// The state of an instance.
    pub fn state(&self, who: usize) -> V::State {
        V::state(self.seen[who][STATE])
    }

    /// The time of an instance.
    pub fn time(&self, who: usize) -> f64 {
        self.seen[who][TIME]
    }

    /// Checks the invariants after every call, and keeps the present contents.
    pub fn made(&mut self, who: usize, call: V::Call, status: impl Into<Answer>, effect: Effect) {
        let (slave, status) = (&self.slaves[who], status.into());
        let messages = slave.take_messages();
        let (before, after) = (&self.seen[who], slave.numbers());
        let (from, to) = (V::state(before[STATE]), V::state(after[STATE]));
        let (prefix, name, kind) = (V::PREFIX, slave.model.name, (slave.purpose, slave.choice));
        let context = || format!("{prefix}{call:?} of {name} in {from:?}: {status:?}, then {to:?}");
        if !V::is_allowed(call, from, slave.purpose) {
            assert_eq!(status, Answer::Error, "{}", context());
        }
        let expected = match status {
            // A restored state may be any; `restore` checks it.
            Answer::Ok if call == V::CALLS.restore => to,
            Answer::Ok => V::next(call, from, kind),
            Answer::Discard => from,
            Answer::Error => V::FAILED,
        };
        assert_eq!(to, expected, "{}", context());
        assert!(V::can_be(to, kind), "{}", context());
        assert!(messages <= u32::from(status != Answer::Ok), "{messages} messages: {}", context());
        assert!(saved::is_finite(&after), "{}: {after:?}", context());
        let only_reads = matches!(effect, Reads);
        if status != Answer::Ok || only_reads {
            assert!(saved::is_unchanged(slave.model, before, &after, !only_reads), "{}", context());
        }
        self.seen[who] = after;
        let (bystander, other) = (1 - who, self.slaves[1 - who].numbers());
        assert!(same_bits(&self.seen[bystander], &other), "{prefix}{call:?} has changed the other instance");
    }

    /// A call without arguments.
    pub fn plain<S: Into<Answer>>(
        &mut self,
        who: usize,
        call: V::Call,
        function: unsafe extern "C-unwind" fn(*mut c_void) -> S,
        effect: Effect,
    ) -> Answer {
        // SAFETY: a live instance.
        let status = unsafe { function(self.slaves[who].c) }.into();
        assert!(call != V::CALLS.reset || status == Answer::Ok);
        self.made(who, call, status, effect);
        status
    }

    /// The value references of columns.
    pub fn references(&self, who: usize, columns: impl IntoIterator<Item = Column>) -> Vec<u32> {
        let model = self.slaves[who].model;
        columns.into_iter().take(MOST_ARGUMENTS).map(|column| column.of(model)).collect()
    }

    /// A number for the variable of a value reference.
    pub fn number(&self, who: usize, reference: u32, number: Number) -> f64 {
        let variable = variable(self.slaves[who].model, reference);
        variable.map_or_else(|| number.alone(), |variable| number.of(&variable))
    }

    /// Accepted values are within their bounds, and the last value of each column is stored.
    pub fn check_set(&self, who: usize, columns: &[usize], values: &[f64]) {
        let model = self.slaves[who].model;
        assert_eq!(columns.len(), values.len());
        for (place, (column, value)) in columns.iter().zip(values).enumerate() {
            assert!(model.table.at(*column).admits(*value), "column {column} = {value}");
            if !columns[place + 1..].contains(column) {
                assert_eq!(self.seen[who][ROW + column].to_bits(), value.to_bits());
            }
        }
    }

    /// Sets the time of a solver.
    pub fn set_time(&mut self, who: usize, time: f64) {
        // SAFETY: a live instance.
        let status = unsafe { V::set_time(self.slaves[who].c, time) };
        self.made(who, V::CALLS.set_time, status, Changes);
        assert!(status != Answer::Ok || self.time(who) == time);
    }

    /// Columns of the continuous states in their order, if the instance has them.
    fn states(&self, who: usize) -> Vec<usize> {
        let model = self.slaves[who].model;
        if model.model_exchange { V::continuous_states(model) } else { Vec::new() }
    }

    /// Sets the continuous states, `more` than there are.
    pub fn set_states(&mut self, who: usize, more: i8, numbers: &[Number]) {
        let columns = self.states(who);
        let number = |place: usize| match (columns.get(place), numbers.get(place)) {
            (Some(column), Some(number)) => number.of(&self.slaves[who].model.table.at(*column)),
            (Some(column), None) => self.seen[who][ROW + column],
            _ => 0.0,
        };
        let values: Vec<f64> = (0..length(columns.len(), more)).map(number).collect();
        // SAFETY: a live instance.
        let status = unsafe { V::set_states(self.slaves[who].c, &values) };
        self.made(who, V::CALLS.set_states, status, Changes);
        if status == Answer::Ok {
            for (column, value) in columns.iter().zip(&values) {
                assert_eq!(self.seen[who][ROW + column].to_bits(), value.to_bits());
            }
        }
    }

    /// The arrays of Model Exchange, with room for `more` than they have.
    pub fn get_array(&mut self, who: usize, which: u8, more: i8) {
        let which = usize::from(which) % V::CALLS.arrays.len();
        let indicators = self.slaves[who].model.event_indicators;
        let wanted = if which == 1 { indicators } else { self.states(who).len() };
        let mut values = vec![f64::NAN; length(wanted, more)];
        // SAFETY: a live instance.
        let status = unsafe { V::get_array(self.slaves[who].c, which, &mut values) };
        assert!(status != Answer::Ok || (values.len() == wanted && all_finite(&values)), "{values:?}");
        self.made(who, V::CALLS.arrays[which], status, Reads);
    }

    /// The saved state of a slot, or NULL.
    fn saved(&self, slot: usize) -> *mut c_void {
        self.slots[slot].as_ref().map_or(null_mut(), |saved| saved.state)
    }

    /// Whether a slot has a state of another model.
    fn is_foreign(&self, who: usize, slot: usize) -> bool {
        self.slots[slot].as_ref().is_some_and(|saved| saved.model != self.slaves[who].model)
    }

    /// Saves a state, over that of the slot if it has one.
    pub fn save(&mut self, who: usize, slot: usize) {
        let (slave, mut state) = (&self.slaves[who], self.saved(slot));
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { V::save(slave.c, &mut state) };
        assert_eq!(status, if self.is_foreign(who, slot) { Answer::Error } else { Answer::Ok });
        if status == Answer::Ok {
            self.slots[slot] = Some(Saved { state, model: slave.model, numbers: self.seen[who].clone() });
        }
        self.made(who, V::CALLS.save, status, Reads);
    }

    /// Restores a state.
    pub fn restore(&mut self, who: usize, slot: usize) {
        let slave = &self.slaves[who];
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { V::restore(slave.c, self.saved(slot)) };
        let has_events = slave.purpose == Purpose::ModelExchange;
        let fits = |saved: &&Saved| {
            let kind = (slave.purpose, slave.choice);
            let is_kind = saved.model == slave.model && V::can_be(V::state(saved.numbers[STATE]), kind);
            is_kind && (has_events || !saved::needs_events(saved.model, &saved.numbers))
        };
        let fitting = self.slots[slot].as_ref().filter(fits).map(|saved| saved.numbers.clone());
        assert_eq!(status == Answer::Ok, fitting.is_some());
        self.made(who, V::CALLS.restore, status, Changes);
        if let Some(numbers) = fitting {
            assert!(same_bits(&numbers, &self.seen[who]), "the restored state differs from the saved one");
        }
    }

    /// Frees a state.
    pub fn free(&mut self, who: usize, slot: usize) {
        let mut state = self.saved(slot);
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { V::free(self.slaves[who].c, &mut state) };
        assert_eq!(status == Answer::Ok, !self.is_foreign(who, slot));
        if status == Answer::Ok {
            assert!(state.is_null());
            self.slots[slot] = None;
        }
        self.made(who, V::CALLS.free, status, Reads);
    }

    /// Writes a saved state into a buffer that is `spare` bytes longer, or shorter, than it must be.
    pub fn serialize(&mut self, who: usize, slot: usize, spare: i8) {
        let (saved, mut size) = (self.saved(slot), usize::MAX);
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { V::size(self.slaves[who].c, saved, &mut size) };
        self.made(who, V::CALLS.size, status, Reads);
        if status != Answer::Ok {
            return;
        }
        let mut bytes = vec![0x55u8; length(size, spare)];
        // SAFETY: a live instance and a live state.
        let status = unsafe { V::write(self.slaves[who].c, saved, &mut bytes) };
        assert_eq!(status == Answer::Ok, bytes.len() >= size);
        if status == Answer::Ok {
            assert!(bytes[size..].iter().all(|byte| *byte == 0x55), "written beyond the state");
            bytes.truncate(size);
            self.bytes[slot] = bytes;
        }
        self.made(who, V::CALLS.write, status, Reads);
    }

    /// Makes a state from bytes, of which one may be damaged.
    pub fn deserialize(&mut self, who: usize, slot: usize, damage: Option<(u16, u8)>) {
        let mut bytes = self.bytes[slot].clone();
        if let Some((at, by)) = damage.filter(|_| !bytes.is_empty()) {
            let at = usize::from(at) % bytes.len();
            bytes[at] ^= by.max(1);
        }
        let (model, mut state) = (self.slaves[who].model, self.saved(slot));
        let is_sound = damage.is_none() && bytes.get(12..saved::HEAD) == Some(model.guid().as_bytes());
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { V::read(self.slaves[who].c, &bytes, &mut state) };
        let is_read = is_sound && !self.is_foreign(who, slot);
        assert_eq!(status == Answer::Ok, is_read, "bytes of a saved state of {}", model.name);
        if status == Answer::Ok {
            self.slots[slot] = Some(Saved { state, model, numbers: saved::numbers(&bytes) });
        }
        self.made(who, V::CALLS.read, status, Reads);
    }

    /// Continues from the present, and then once more from a saved state, in this or in a new instance: the same bits.
    pub fn replay(&mut self, who: usize, steps: u8, length: f64, elsewhere: bool) {
        if !V::can_step(self.state(who)) {
            return;
        }
        let slave = &self.slaves[who];
        let bytes = slave.bytes();
        let future = slave.future(steps, length);
        if elsewhere {
            let other = Slave::<V>::new(slave.model, slave.purpose == Purpose::ModelExchange, slave.choice);
            other.read(&bytes);
            assert_eq!(other.future(steps, length), future, "{} in another instance", slave.model.name);
        }
        slave.read(&bytes);
        assert_eq!(slave.future(steps, length), future, "{}", slave.model.name);
        slave.read(&bytes);
        slave.take_messages();
        assert!(same_bits(&slave.numbers(), &self.seen[who]), "not back in the saved state");
    }
}

/// A length, or one that differs from it.
pub fn length(right: usize, more: i8) -> usize {
    right.saturating_add_signed(more.into())
}
