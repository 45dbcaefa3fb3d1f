//! Bytes of external saved states, with and without a matching checksum, through both interfaces.
#![no_main]

use std::ptr::null_mut;

use arbitrary::Arbitrary;
use fuzz::argument::{Column, Number, Step, column, model};
use fuzz::fmi2::Fmi2;
use fuzz::fmi3::{self, Fmi3};
use fuzz::saved::{self, CHECKSUM, HEAD, STATE};
use fuzz::slave::{Slave, all_finite};
use fuzz::version::{Answer, Version};
use libfuzzer_sys::fuzz_target;
use stribeck::model::ModelType;
use stribeck_ffi::c::stribeck_status::*;
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::lifecycle::Purpose;

fuzz_target!(|input: Input| input.run());

#[derive(Arbitrary, Debug)]
struct Input {
    model: u8,
    /// Values of the state before the bytes are changed.
    values: Vec<(Column, Number)>,
    lifecycle: u8,
    edits: Vec<Edit>,
    /// Whether the checksum is made to match.
    seal: bool,
    step: Step,
}

#[derive(Arbitrary, Debug)]
enum Edit {
    /// Another byte.
    Byte(u16, u8),
    /// Another number among the numbers.
    Number(u16, Number),
    /// Fewer bytes.
    Cut(u16),
    /// More bytes.
    Append(Vec<u8>),
    /// The guid of another model.
    Guid(u8),
    /// Other bytes altogether.
    Replace(Vec<u8>),
}

impl Input {
    fn run(self) {
        // Numbers of states, one of which does not exist.
        self.run_with::<Fmi2>(f64::from(self.lifecycle % 8));
        self.run_with::<Fmi3>(f64::from(16 + self.lifecycle % 10));
    }

    fn run_with<V: Version>(&self, state: f64) {
        let model = model(self.model);
        let bytes = self.bytes::<V>(model, state);
        let is_readable = read_by_c(model, &bytes);
        for exchange in [false, true] {
            let slave = Slave::<V>::new(model, exchange, V::Choice::default());
            let is_read = read_by_fmi(&slave, &bytes, self.step.length());
            // The sizes of arrays are none of C's.
            let is_for_fmi_only =
                || saved::needs_events(model, &saved::numbers(&bytes)) || !fmi3::sizes_of(model).is_empty();
            assert!(is_readable || !is_read || is_for_fmi_only(), "read by FMI, rejected by C");
        }
    }

    /// The bytes of a valid state of the model, changed by the edits.
    fn bytes<V: Version>(&self, model: &'static ModelType, state: f64) -> Vec<u8> {
        let slave = Slave::<V>::new(model, false, V::Choice::default());
        let mut bytes = slave.bytes();
        for (wanted, number) in &self.values {
            let Some(column) = column(model, wanted.of(model)) else { continue };
            let (variable, place) = (&model.table.at(column), saved::ROW + column);
            if variable.admits(number.of(variable)) {
                put(&mut bytes, place, number.of(variable));
            }
        }
        put(&mut bytes, STATE, state);
        for edit in &self.edits {
            edit.apply(&mut bytes);
        }
        if self.seal {
            saved::seal(&mut bytes);
        }
        bytes
    }
}

impl Edit {
    fn apply(&self, bytes: &mut Vec<u8>) {
        match self {
            Edit::Byte(at, value) => {
                let length = bytes.len().max(1);
                if let Some(byte) = bytes.get_mut(usize::from(*at) % length) {
                    *byte = *value;
                }
            }
            Edit::Number(at, number) => {
                let count = bytes.len().saturating_sub(HEAD + CHECKSUM) / 8;
                put(bytes, usize::from(*at) % count.max(1), number.alone());
            }
            Edit::Cut(count) => bytes.truncate(bytes.len().saturating_sub((*count).into())),
            Edit::Append(more) => bytes.extend(more),
            Edit::Guid(other) => {
                if let Some(guid) = bytes.get_mut(12..HEAD) {
                    guid.copy_from_slice(model(*other).guid().as_bytes());
                }
            }
            Edit::Replace(others) => bytes.clone_from(others),
        }
    }
}

fn put(bytes: &mut [u8], place: usize, number: f64) {
    let at = HEAD + 8 * place;
    if let Some(place) = bytes.get_mut(at..at + 8) {
        place.copy_from_slice(&number.to_le_bytes());
    }
}

/// Whether it is a state of the model for the C interface. A rejected one changes nothing.
fn read_by_c(model: &'static ModelType, bytes: &[u8]) -> bool {
    let mut handle = null_mut();
    // SAFETY: a terminated text, a handle that is freed once, and as many bytes as given.
    unsafe {
        assert_eq!(stribeck_create(model.c_name.as_ptr(), &mut handle), STRIBECK_OK);
        let mut before = vec![0u8; stribeck_state_size(handle)];
        let mut after = before.clone();
        assert_eq!(stribeck_save(handle, before.as_mut_ptr().cast(), before.len()), STRIBECK_OK);
        let status = stribeck_restore(handle, bytes.as_ptr().cast(), bytes.len());
        assert_eq!(stribeck_save(handle, after.as_mut_ptr().cast(), after.len()), STRIBECK_OK);
        if status == STRIBECK_OK {
            // The numbers of the FMI layer have no meaning here.
            assert_eq!(after[..saved::HEAD + 24], bytes[..saved::HEAD + 24]);
            let row = saved::HEAD + 8 * saved::ROW;
            assert_eq!(after[row..bytes.len() - CHECKSUM], bytes[row..bytes.len() - CHECKSUM]);
            let numbers = saved::numbers(&after);
            assert!(saved::is_finite(&numbers) && !saved::needs_events(model, &numbers));
        } else {
            assert_eq!(status, STRIBECK_BAD_BUFFER);
            assert_eq!(after, before);
        }
        stribeck_free(handle);
        status == STRIBECK_OK
    }
}

/// Whether it is a state of the model for the FMI layer. If so, everything that can be done with it follows the rules.
fn read_by_fmi<V: Version>(slave: &Slave<V>, bytes: &[u8], length: f64) -> bool {
    let (c, before) = (slave.c, slave.numbers());
    let mut read = null_mut();
    // SAFETY: a live instance, and a state that is freed once.
    unsafe {
        let status = V::read(c, bytes, &mut read);
        assert_eq!(status == Answer::Ok, !read.is_null());
        if status != Answer::Ok {
            let is_unchanged = saved::is_unchanged(slave.model, &before, &slave.numbers(), true);
            assert!(status == Answer::Error && is_unchanged);
            return false;
        }
        assert_eq!(slave.bytes_of(read), bytes, "the written state differs from the one read");
        let numbers = saved::numbers(bytes);
        assert!(saved::is_finite(&numbers), "{numbers:?}");
        let status = V::restore(c, read);
        let is_event_missing = slave.purpose == Purpose::CoSimulation && saved::needs_events(slave.model, &numbers);
        let can_be = V::can_be(V::state(numbers[STATE]), (slave.purpose, slave.choice));
        assert_eq!(status == Answer::Ok, can_be && !is_event_missing);
        if status == Answer::Ok {
            assert_eq!(slave.bytes(), bytes, "the restored state differs from the one read");
            go_on(slave, length);
        }
        assert_eq!(V::free(c, &mut read), Answer::Ok);
    }
    true
}

/// Reads everything and makes a step, if the instance is in a state for that.
fn go_on<V: Version>(slave: &Slave<V>, length: f64) {
    // SAFETY: a live instance.
    unsafe {
        let (status, values) = V::read_all(slave.c, slave.model, &slave.numbers());
        assert!(status != Answer::Ok || all_finite(&values));
        // A fault that a solver may correct.
        let is_between = slave.purpose == Purpose::ModelExchange;
        assert!(status != Answer::Discard || is_between);
        let before = slave.numbers();
        let status = V::step(slave.c, &slave.ears, before[saved::TIME], length);
        let after = slave.numbers();
        assert!(saved::is_finite(&after));
        let [from, to] = [&before, &after].map(|numbers| V::state(numbers[STATE]));
        match status {
            Answer::Ok => assert!(V::can_step(from) && from == to && slave.purpose == Purpose::CoSimulation),
            _ => assert!(status == Answer::Error && saved::is_unchanged(slave.model, &before, &after, true)),
        }
    }
}
