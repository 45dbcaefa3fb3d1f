//! The instance of the module, and what its functions pass to C.

use std::cell::UnsafeCell;
use std::fmt::{self, Write};

use stribeck::instance::{Instance, Refused};
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::Fault;
use stribeck::serial;

use crate::model::{COLUMNS, MODEL};

/// Result of a call, with the numbers of `stribeck_status`.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Ok = 0,
    UnknownModel = 2,
    UnknownVariable = 3,
    RefusedValue = 4,
    NotSettable = 5,
    NotFinite = 6,
    BadBuffer = 7,
    Internal = 8,
    OutOfMemory = 9,
}

/// Why a call was refused.
pub struct Refusal(pub Status, pub String);

pub type Outcome = Result<(), Refusal>;

impl From<OutOfMemory> for Refusal {
    fn from(error: OutOfMemory) -> Refusal {
        Refusal(Status::OutOfMemory, memory::text(error))
    }
}

impl From<Refused> for Refusal {
    fn from(refused: Refused) -> Refusal {
        match refused {
            Refused::Unknown(fault) => Refusal(Status::UnknownVariable, fault.0),
            Refused::NotSettable(fault) => Refusal(Status::NotSettable, fault.0),
            Refused::NotNow(_) => Refusal(Status::NotSettable, memory::text(refused)),
            Refused::Value(fault) => Refusal(Status::RefusedValue, fault.0),
            Refused::NotFinite(fault) => Refusal(Status::NotFinite, fault.0),
        }
    }
}

/// A fault that has this status.
pub fn fault(status: Status) -> impl FnOnce(Fault) -> Refusal {
    move |fault| Refusal(status, fault.0)
}

pub fn refuse<T>(status: Status, text: impl fmt::Display) -> Result<T, Refusal> {
    Err(Refusal(status, memory::text(text)))
}

/// A text for C, of a fixed length; longer ones are truncated.
pub struct Text {
    bytes: [u8; 384],
    length: usize,
}

impl Text {
    pub fn say(&mut self, text: &str) {
        self.length = 0;
        // An error says that the text is truncated, as intended.
        let _ = self.write_str(text);
        self.bytes[self.length] = 0;
    }

    pub fn address(&self) -> usize {
        self.bytes.as_ptr().addr()
    }
}

impl Write for Text {
    fn write_str(&mut self, more: &str) -> fmt::Result {
        let room = self.bytes.len() - 1 - self.length;
        let fits = (0..=more.len().min(room)).rev().find(|end| more.is_char_boundary(*end)).unwrap_or_default();
        self.bytes[self.length..self.length + fits].copy_from_slice(&more.as_bytes()[..fits]);
        self.length += fits;
        if fits == more.len() { Ok(()) } else { Err(fmt::Error) }
    }
}

/// Most sizes of arrays that a model has.
const SIZES: usize = 4;

/// The instance, with the arguments and results that are no numbers.
pub struct Module {
    pub instance: Instance,
    /// Result of a call that returns a number.
    pub value: f64,
    /// A state as bytes.
    pub bytes: Box<[u8]>,
    /// Numbers that C adds to a state.
    pub owners: [f64; serial::OWNERS],
    /// Sizes of arrays, which C adds as well.
    pub sizes: [f64; SIZES],
    /// Direction of a derivative, by column.
    pub direction: Box<[f64]>,
    /// The slopes of the columns, then those of their rates.
    pub slopes: Box<[f64]>,
}

impl Module {
    pub fn new() -> Result<Module, OutOfMemory> {
        Ok(Module {
            instance: Instance::try_new(&MODEL)?,
            value: 0.0,
            bytes: memory::filled(0, serial::size_with(&MODEL, SIZES))?,
            owners: [0.0; serial::OWNERS],
            sizes: [0.0; SIZES],
            direction: memory::filled(0.0, COLUMNS)?,
            slopes: memory::filled(0.0, 2 * COLUMNS)?,
        })
    }
}

/// What belongs to the module for its whole life.
pub struct Only {
    module: UnsafeCell<Option<Module>>,
    text: UnsafeCell<Text>,
}

// SAFETY: the module has one thread, and C makes one call at a time.
unsafe impl Sync for Only {}

static ONLY: Only = Only { module: UnsafeCell::new(None), text: UnsafeCell::new(Text { bytes: [0; 384], length: 0 }) };

/// The instance; none before it has been made.
pub fn module() -> Option<&'static mut Module> {
    // SAFETY: each function of the module takes the reference once and drops it when it returns.
    unsafe { &mut *ONLY.module.get() }.as_mut()
}

/// The last text.
pub fn text() -> &'static mut Text {
    // SAFETY: as in `module`.
    unsafe { &mut *ONLY.text.get() }
}

/// Puts the instance into its place.
pub fn place(made: Module) {
    // SAFETY: as in `module`.
    unsafe { *ONLY.module.get() = Some(made) };
}

/// Runs a call on the instance, and keeps why it was refused.
#[inline(always)]
pub fn enter(body: impl FnOnce(&mut Module) -> Outcome) -> Status {
    let Some(module) = module() else { return Status::Internal };
    match body(module) {
        Ok(()) => Status::Ok,
        Err(refusal) => refused(refusal),
    }
}

#[cold]
#[inline(never)]
pub fn refused(Refusal(status, why): Refusal) -> Status {
    text().say(&why);
    status
}
