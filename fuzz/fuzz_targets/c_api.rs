//! Sequences of calls of the C interface on two models.
#![no_main]

use std::ffi::{CStr, CString};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use arbitrary::Arbitrary;
use fuzz::argument::{Column, Number, Step, column, model, variable};
use fuzz::saved;
use libfuzzer_sys::fuzz_target;
use stribeck::model::{ModelType, Role};
use stribeck_ffi::c::stribeck_status::*;
use stribeck_ffi::c::*;

fuzz_target!(|scenario: Scenario| World::new(&scenario).play(&scenario.actions));

#[derive(Arbitrary, Debug)]
struct Scenario {
    model: u8,
    /// Another model for the second handle.
    other: Option<u8>,
    actions: Vec<(bool, Action)>,
}

/// Steps with nonsensical numbers are expensive; longer sequences find nothing new.
const MOST_ACTIONS: usize = 48;

#[derive(Arbitrary, Debug)]
enum Action {
    Set(Column, Number),
    Get(Column),
    SetByName(Name, Number),
    GetByName(Name),
    Find(Name),
    Describe(Column),
    Preset(u8),
    ApplyPreset(Name),
    Step(Step),
    Output,
    Derivative(Column, Column),
    Reset,
    Save { spare: i8 },
    Restore { damage: Option<(u16, u8)>, cut: u8 },
    Replay { steps: u8, length: Step },
    Null(u8),
    Texts(i32, u8),
}

/// A name, mostly one that exists.
#[derive(Arbitrary, Debug)]
enum Name {
    Of(Column),
    Preset(u8),
    Text(Vec<u8>),
}

impl Name {
    fn of(&self, model: &ModelType) -> CString {
        let text = match self {
            Name::Of(column) => variable(model, column.of(model)).map(|variable| variable.path.to_string()),
            Name::Preset(which) => model.presets.get(usize::from(*which) % 4).map(|preset| preset.name.to_owned()),
            Name::Text(_) => None,
        };
        let bytes = match (self, text) {
            (Name::Text(bytes), _) => bytes.iter().copied().filter(|byte| *byte != 0).collect(),
            (_, text) => text.unwrap_or_default().into_bytes(),
        };
        CString::new(bytes).expect("no zero byte")
    }
}

struct Handle {
    pointer: *mut stribeck_instance,
    model: &'static ModelType,
}

impl Handle {
    fn new(model: &'static ModelType) -> Handle {
        let mut pointer = null_mut();
        // SAFETY: a terminated text and a place for the handle.
        assert_eq!(unsafe { stribeck_create(model.c_name.as_ptr(), &mut pointer) }, STRIBECK_OK);
        Handle { pointer, model }
    }

    fn bytes(&self) -> Vec<u8> {
        // SAFETY: a live handle, and as many bytes as it needs.
        unsafe {
            let mut bytes = vec![0u8; stribeck_state_size(self.pointer)];
            assert_eq!(stribeck_save(self.pointer, bytes.as_mut_ptr().cast(), bytes.len()), STRIBECK_OK);
            bytes
        }
    }

    fn restore(&self, bytes: &[u8]) -> stribeck_status {
        // SAFETY: a live handle, and as many bytes as given.
        unsafe { stribeck_restore(self.pointer, bytes.as_ptr().cast(), bytes.len()) }
    }

    fn get(&self, column: u32) -> (stribeck_status, f64) {
        let mut value = f64::NAN;
        // SAFETY: a live handle and a place for the value.
        let status = unsafe { stribeck_get(self.pointer, column, &mut value) };
        assert_eq!(status == STRIBECK_OK, value.is_finite(), "{} {column}: {value}", self.model.name);
        (status, value)
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        // SAFETY: made by `new`, freed once.
        unsafe { stribeck_free(self.pointer) };
    }
}

/// Every status has a text, every model a name, and past the last one there is none.
fn texts(status: i32, index: u8) {
    // SAFETY: texts of the library, or NULL past the last.
    unsafe {
        assert!(!text(stribeck_status_text(status)).is_empty());
        let name = stribeck_model_name(index.into());
        assert_eq!(name.is_null(), usize::from(index) >= stribeck_model_count());
    }
}

struct World {
    handles: [Handle; 2],
    /// Contents of the handles after the last call.
    seen: [Vec<f64>; 2],
    /// The last saved state.
    kept: Vec<u8>,
}

impl World {
    fn new(scenario: &Scenario) -> World {
        let first = model(scenario.model);
        let handles = [first, scenario.other.map_or(first, model)].map(Handle::new);
        let seen = handles.each_ref().map(|handle| saved::numbers(&handle.bytes()));
        World { handles, seen, kept: Vec::new() }
    }

    fn play(mut self, actions: &[(bool, Action)]) {
        for (who, action) in actions.iter().take(MOST_ACTIONS) {
            self.act(usize::from(*who), action);
        }
    }

    /// Checks the invariants after every call, and keeps the present contents.
    fn made(&mut self, who: usize, status: stribeck_status, only_reads: bool) {
        let handle = &self.handles[who];
        let after = saved::numbers(&handle.bytes());
        let context = || format!("{}: {status:?}", handle.model.name);
        assert_ne!(status, STRIBECK_INTERNAL, "{}", self.error(who));
        assert!(saved::is_finite(&after), "{}", context());
        if status != STRIBECK_OK || only_reads {
            assert!(saved::is_unchanged(handle.model, &self.seen[who], &after, !only_reads), "{}", context());
        }
        if status != STRIBECK_OK {
            assert!(!self.error(who).is_empty(), "{}", context());
        }
        self.seen[who] = after;
        let other = saved::numbers(&self.handles[1 - who].bytes());
        let same = other.iter().zip(&self.seen[1 - who]).all(|(a, b)| a.to_bits() == b.to_bits());
        assert!(same, "the other model has changed");
    }

    fn error(&self, who: usize) -> String {
        // SAFETY: a live handle; its text lives until the next call.
        unsafe { text(stribeck_last_error(self.handles[who].pointer)) }
    }

    fn act(&mut self, who: usize, action: &Action) {
        let Handle { pointer, model } = self.handles[who];
        match action {
            Action::Set(of, number) => {
                let reference = of.of(model);
                let value = variable(model, reference).map_or(0.0, |variable| number.of(&variable));
                // SAFETY: a live handle.
                let status = unsafe { stribeck_set(pointer, reference, value) };
                self.check_set(who, status, column(model, reference), value);
            }
            Action::Get(column) => {
                let (status, _) = self.handles[who].get(column.of(model));
                self.made(who, status, true);
            }
            Action::SetByName(name, number) => self.set_by_name(who, &name.of(model), number.alone()),
            Action::GetByName(name) => self.get_by_name(who, &name.of(model)),
            Action::Find(name) => self.find(who, &name.of(model)),
            Action::Describe(column) => self.describe(who, column.of(model)),
            Action::Preset(which) => self.preset(who, usize::from(*which)),
            Action::ApplyPreset(name) => {
                let name = name.of(model);
                // SAFETY: a live handle and a terminated text.
                let status = unsafe { stribeck_apply_preset(pointer, name.as_ptr()) };
                self.made(who, status, false);
            }
            Action::Step(step) => self.step(who, step.length()),
            Action::Output => {
                // SAFETY: a live handle.
                let status = unsafe { stribeck_output(pointer) };
                self.made(who, status, true);
            }
            Action::Derivative(output, input) => self.derive(who, output.of(model), input.of(model)),
            Action::Reset => self.reset(who),
            Action::Save { spare } => self.save(who, *spare),
            Action::Restore { damage, cut } => self.restore(who, *damage, usize::from(*cut)),
            Action::Replay { steps, length } => self.replay(who, 1 + steps % 4, length.length()),
            Action::Null(which) => self.call_with_null(who, *which),
            Action::Texts(status, index) => texts(*status, *index),
        }
    }

    fn reset(&mut self, who: usize) {
        let Handle { pointer, model } = self.handles[who];
        // SAFETY: a live handle.
        let status = unsafe { stribeck_reset(pointer) };
        assert_eq!(status, STRIBECK_OK);
        self.made(who, status, false);
        assert_eq!(self.seen[who], saved::numbers(&Handle::new(model).bytes()));
    }

    fn set_by_name(&mut self, who: usize, name: &CStr, value: f64) {
        let Handle { pointer, model } = self.handles[who];
        // SAFETY: a live handle and a terminated text.
        let status = unsafe { stribeck_set_by_name(pointer, name.as_ptr(), value) };
        self.check_set(who, status, name.to_str().ok().and_then(|name| model.find(name)), value);
    }

    fn get_by_name(&mut self, who: usize, name: &CStr) {
        let mut value = f64::NAN;
        // SAFETY: a live handle, a terminated text and a place for the value.
        let status = unsafe { stribeck_get_by_name(self.handles[who].pointer, name.as_ptr(), &mut value) };
        assert_eq!(status == STRIBECK_OK, value.is_finite());
        self.made(who, status, true);
    }

    fn find(&mut self, who: usize, name: &CStr) {
        let Handle { pointer, model } = self.handles[who];
        let mut reference = u32::MAX;
        // SAFETY: a live handle, a terminated text and a place for the number.
        let status = unsafe { stribeck_find(pointer, name.as_ptr(), &mut reference) };
        let named = variable(model, reference).map(|variable| variable.path.to_string());
        assert_eq!(status == STRIBECK_OK, named.is_some());
        assert!(named.is_none_or(|named| named.as_bytes() == name.to_bytes()));
        self.made(who, status, true);
    }

    fn derive(&mut self, who: usize, output: u32, input: u32) {
        let mut value = f64::NAN;
        // SAFETY: a live handle and a place for the value.
        let status = unsafe { stribeck_derivative(self.handles[who].pointer, output, input, &mut value) };
        assert_eq!(status == STRIBECK_OK, value.is_finite());
        self.made(who, status, true);
    }

    /// An accepted value is within its bounds and is stored.
    fn check_set(&mut self, who: usize, status: stribeck_status, column: Option<usize>, value: f64) {
        self.made(who, status, false);
        if status == STRIBECK_OK {
            let column = column.expect("a column that was set");
            let variable = &self.handles[who].model.table.at(column);
            assert!(variable.admits(value) && variable.role != Role::Output, "{} = {value}", variable.path);
            assert_eq!(self.seen[who][saved::ROW + column].to_bits(), value.to_bits());
        }
    }

    fn describe(&mut self, who: usize, reference: u32) {
        let mut description = MaybeUninit::uninit();
        let model = self.handles[who].model;
        // SAFETY: a live handle and a place for the description, which is read only if it was written; its texts
        // live as long as the handle.
        unsafe {
            let status = stribeck_describe(self.handles[who].pointer, reference, description.as_mut_ptr());
            let described = variable(model, reference);
            assert_eq!(status == STRIBECK_OK, described.is_some());
            if let Some(described) = described {
                let description = description.assume_init();
                assert_eq!(text(description.name), described.path.to_string());
                assert!(description.min <= description.start && description.start <= description.max);
                assert!(!text(description.help).is_empty());
                text(description.unit);
            }
            self.made(who, status, true);
        }
    }

    fn preset(&mut self, who: usize, which: usize) {
        let Handle { pointer, model } = self.handles[who];
        // SAFETY: a live handle; the texts are its own.
        unsafe {
            assert_eq!(stribeck_preset_count(pointer), model.presets.len());
            let [name, source] = [stribeck_preset_name(pointer, which), stribeck_preset_source(pointer, which)];
            assert_eq!([name.is_null(), source.is_null()], [which >= model.presets.len(); 2]);
            if !name.is_null() {
                let status = stribeck_apply_preset(pointer, name);
                assert_eq!((status, text(source).is_empty()), (STRIBECK_OK, false));
                self.made(who, status, false);
            }
        }
    }

    fn step(&mut self, who: usize, length: f64) {
        let pointer = self.handles[who].pointer;
        // SAFETY: a live handle.
        let (before, status) = unsafe { (stribeck_time(pointer), stribeck_step(pointer, length)) };
        self.made(who, status, false);
        if status == STRIBECK_OK {
            assert!(length > 0.0 && length < f64::INFINITY, "a step of {length} s");
            // SAFETY: a live handle.
            assert_eq!(unsafe { stribeck_time(pointer) }, before + length);
        }
    }

    /// Writes the state into a buffer that is `spare` bytes longer, or shorter, than it must be.
    fn save(&mut self, who: usize, spare: i8) {
        let pointer = self.handles[who].pointer;
        // SAFETY: a live handle, and as many bytes as given.
        let status = unsafe {
            let size = stribeck_state_size(pointer);
            let mut bytes = vec![0x55u8; size.saturating_add_signed(spare.into())];
            let status = stribeck_save(pointer, bytes.as_mut_ptr().cast(), bytes.len());
            assert_eq!(status == STRIBECK_OK, bytes.len() >= size);
            if status == STRIBECK_OK {
                assert!(bytes[size..].iter().all(|byte| *byte == 0x55), "written beyond the state");
                bytes.truncate(size);
                self.kept = bytes;
            }
            status
        };
        self.made(who, status, true);
    }

    fn restore(&mut self, who: usize, damage: Option<(u16, u8)>, cut: usize) {
        let mut bytes = self.kept.clone();
        bytes.truncate(bytes.len().saturating_sub(cut % 8));
        if let Some((at, by)) = damage.filter(|_| !bytes.is_empty()) {
            let at = usize::from(at) % bytes.len();
            bytes[at] ^= by.max(1);
        }
        let guid = self.handles[who].model.guid().as_bytes();
        let is_sound = bytes == self.kept && bytes.get(12..saved::HEAD) == Some(guid);
        let status = self.handles[who].restore(&bytes);
        assert_eq!(status == STRIBECK_OK, is_sound, "{}", self.error(who));
        self.made(who, status, false);
        if is_sound {
            assert_eq!(self.handles[who].bytes(), bytes, "the restored state differs from the saved one");
        }
    }

    /// Continues from the present, and then once more in a new handle from the saved state: the same bits.
    fn replay(&mut self, who: usize, steps: u8, length: f64) {
        let handle = &self.handles[who];
        let (bytes, other) = (handle.bytes(), Handle::new(handle.model));
        assert_eq!(other.restore(&bytes), STRIBECK_OK);
        let future = future(handle, steps, length);
        assert_eq!(self::future(&other, steps, length), future, "{}", handle.model.name);
        assert_eq!(handle.restore(&bytes), STRIBECK_OK);
        assert_eq!(handle.bytes(), bytes, "not back in the saved state");
    }

    /// A call with a NULL where there must be none.
    fn call_with_null(&mut self, who: usize, which: u8) {
        let Handle { pointer, model } = self.handles[who];
        let (first, name) = (model.reference(0), model.table.at(0).path.to_string());
        let name = CString::new(name).expect("no zero byte");
        let (mut value, nobody, no_value) = (0.0, null_mut(), null_mut::<f64>());
        // SAFETY: these calls must reject NULL; the other arguments are valid.
        let status = unsafe {
            match which % 15 {
                0 => stribeck_create(null(), null_mut()),
                1 => stribeck_create(null(), &mut null_mut()),
                2 => stribeck_set(nobody, 0, 0.0),
                3 => stribeck_step(nobody, 1.0),
                4 => stribeck_get(pointer, first, no_value),
                5 => stribeck_get_by_name(pointer, null(), &mut value),
                6 => stribeck_get_by_name(pointer, name.as_ptr(), no_value),
                7 => stribeck_set_by_name(pointer, null(), 0.0),
                8 => stribeck_find(pointer, name.as_ptr(), null_mut()),
                9 => stribeck_describe(pointer, first, null_mut()),
                10 => stribeck_apply_preset(pointer, null()),
                11 => stribeck_save(pointer, null_mut(), usize::MAX),
                12 => stribeck_restore(pointer, null(), 8),
                13 => stribeck_reference(pointer, 0, null_mut()),
                _ => stribeck_reset(nobody),
            }
        };
        assert_eq!(status, STRIBECK_NULL, "call {which} with NULL");
        if (4..14).contains(&(which % 15)) {
            self.made(who, status, true);
        }
    }
}

/// Results of a model in some steps, bit by bit.
fn future(handle: &Handle, steps: u8, length: f64) -> Vec<u8> {
    let mut trace = Vec::new();
    for _ in 0..steps {
        // SAFETY: a live handle.
        let status = unsafe { stribeck_step(handle.pointer, length) };
        trace.push(status as u8);
        for column in (0..handle.model.table.len()).map(|column| handle.model.reference(column)) {
            let (status, value) = handle.get(column);
            trace.push(status as u8);
            trace.extend(value.to_le_bytes());
        }
    }
    trace.extend(handle.bytes());
    trace
}

/// A text of the library.
///
/// # Safety
/// `pointer` must be a terminated text that lives during the call.
unsafe fn text(pointer: *const std::ffi::c_char) -> String {
    // SAFETY: the caller's promise.
    unsafe { CStr::from_ptr(pointer) }.to_str().expect("UTF-8").to_owned()
}
