//! The one door through which every call on an instance passes: null pointer, state, panic, log.

use std::ffi::CStr;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::lifecycle::{Call, Purpose, State};
use super::log::{Log, Reason};
use super::types::{fmi2Component, fmi2Status};
use crate::catalogue;
use crate::float_mode::DefaultMode;
use crate::guid::GuidText;
use crate::instance::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::Fault;

/// What an importer holds as `fmi2Component`.
pub(super) struct Slave {
    magic: u64,
    /// Where the library was in the last call.
    home: usize,
    /// Which model it is of, wherever the library is.
    pub guid: GuidText,
    pub instance: Instance,
    pub purpose: Purpose,
    pub state: State,
    pub experiment: Experiment,
    /// Has the end of the initialization changed states, and fmi2NewDiscreteStates not told of it yet?
    pub has_jumped: bool,
    /// Number of steps of the run.
    steps: u64,
    pub log: Log,
}

/// What fmi2SetupExperiment declared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Experiment {
    pub is_set_up: bool,
    pub start: f64,
    /// Infinite if no stop time is defined.
    pub stop: f64,
}

impl Experiment {
    pub const NONE: Experiment = Experiment { is_set_up: false, start: 0.0, stop: f64::INFINITY };
}

/// Marks the memory of a live instance, so that a pointer to something else is refused.
const MAGIC: u64 = u64::from_le_bytes(*b"STRIBECK");

/// Where the library is.
fn home() -> usize {
    static HERE: u8 = 0;
    (&raw const HERE).addr()
}

impl Slave {
    pub fn new(instance: Instance, purpose: Purpose, log: Log) -> Slave {
        Slave {
            magic: MAGIC,
            home: home(),
            guid: instance.model().guid_text(),
            instance,
            purpose,
            state: State::Instantiated,
            experiment: Experiment::NONE,
            has_jumped: false,
            steps: 0,
            log,
        }
    }

    /// Follows the library to where it is now. An importer may unload it and load it again while instances live, and it
    /// may then be elsewhere: Ecos 0.7.2 does so before each further instance of an FMU. Of all that an instance holds
    /// only its model is in the library; the rest is in the host's memory and stays.
    #[cold]
    #[inline(never)]
    fn follow(&mut self) -> Option<()> {
        crate::panics::silence();
        self.instance.set_model(catalogue::by_guid(self.guid)?);
        self.home = home();
        Some(())
    }

    /// Refuses parameters that do not fit together, or that do not serve this instance's purpose.
    pub fn check(&mut self) -> Result<(), Fault> {
        self.instance.check()?;
        match self.purpose {
            Purpose::CoSimulation => Ok(()),
            Purpose::ModelExchange => self.instance.model().check_exchange(self.instance.row()),
        }
    }

    /// A run begins.
    pub fn begin(&mut self) {
        self.steps = 0;
    }

    /// Counts a step, and asks the model now and then whether it knows of values that make no sense: after the steps
    /// 1, 2, 4, 8 and so on. The first is not enough, for some hosts set inputs late, and some faults show in time; every
    /// one would cost time.
    #[inline(always)]
    pub fn count_step(&mut self) {
        self.steps += 1;
        if self.steps.is_power_of_two() {
            self.warn();
        }
    }

    #[cold]
    #[inline(never)]
    fn warn(&mut self) {
        if let Some(warning) = self.instance.warning() {
            self.log.warn(&warning.0);
        }
    }

    /// Results that would not be finite: a solver may try a smaller step, or other inputs. Elsewhere the run is over.
    pub fn out_of_domain(&self, fault: Fault) -> Refusal {
        match self.state {
            State::EventMode | State::ContinuousTimeMode => Refusal::Trial(fault.0),
            _ => Refusal::Error(fault.0),
        }
    }
}

/// Why a call was refused. Where there is no memory for a text it is cut, even to nothing.
pub(super) enum Refusal {
    /// The value cannot be taken; another one can be tried.
    Discard(String),
    /// As `Discard`, in the ordinary course of a run: a solver tries, or an importer asks for what there is not.
    Trial(String),
    /// The call is wrong.
    Error(String),
}

impl Refusal {
    pub fn discard(text: impl fmt::Display) -> Refusal {
        Refusal::Discard(memory::text(text))
    }

    pub fn error(text: impl fmt::Display) -> Refusal {
        Refusal::Error(memory::text(text))
    }
}

impl From<OutOfMemory> for Refusal {
    fn from(error: OutOfMemory) -> Refusal {
        Refusal::error(error)
    }
}

pub(super) type Outcome = Result<(), Refusal>;

/// A fault of the model, seen from the door.
impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Refusal {
        Refusal::Error(fault.0)
    }
}

pub(super) fn refuse<T>(text: impl fmt::Display) -> Result<T, Refusal> {
    Err(Refusal::error(text))
}

/// Runs `body` on the instance behind `c` if the call is allowed in its state, and turns the outcome into a status. A
/// refused call is logged; after an error only reset, free and restore lead on, as the standard has it.
///
/// The logger is called when all else is done: if it throws, the exception passes to the host as if the function of this
/// library had thrown it, and the instance is as the status would have said. See [`Log`] for what that asks of this
/// function and of those that call it: nothing in them may need to be dropped.
///
/// # Safety
/// `c` must be NULL or an instance made by `fmi2Instantiate` and not yet freed, not in use by another thread.
#[inline(always)]
pub(super) unsafe fn enter(c: fmi2Component, call: Call, body: impl FnOnce(&mut Slave) -> Outcome) -> fmi2Status {
    // SAFETY: the caller's promise.
    let Some(slave) = (unsafe { slave(c) }) else { return fmi2Status::fmi2Error };
    let status = guarded(slave, call, body);
    if slave.log.is_waiting() {
        slave.log.tell();
    }
    status
}

/// What [`enter`] does before anything is told.
#[inline(never)]
fn guarded(slave: &mut Slave, call: Call, body: impl FnOnce(&mut Slave) -> Outcome) -> fmi2Status {
    if !call.is_allowed(slave.state) || !call.is_for(slave.purpose) {
        return refused(slave, call, not_allowed(slave, call));
    }
    let _mode = DefaultMode::enter();
    // A panic leaves row and memory as they were: see RollBack. Everything else that a body writes, it writes last.
    match catch_unwind(AssertUnwindSafe(|| body(slave))) {
        Ok(Ok(())) => fmi2Status::fmi2OK,
        Ok(Err(refusal)) => refused(slave, call, refusal),
        Err(panic) => refused(slave, call, Refusal::Error(crate::panics::text(&*panic))),
    }
}

/// The instance behind `c` if it is ready to step: what a call needs to know before it may take the short way, in which
/// nothing can be refused. Everything unusual takes the long way through [`enter`].
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(super) unsafe fn stepping<'a>(c: fmi2Component) -> Option<&'a mut Slave> {
    // SAFETY: the caller's promise.
    unsafe { slave(c) }.filter(|slave| slave.state == State::StepComplete)
}

/// The live instance behind `c`.
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
unsafe fn slave<'a>(c: fmi2Component) -> Option<&'a mut Slave> {
    let slave = c.cast::<Slave>();
    // SAFETY: the caller promises NULL or a `Slave` that nobody else uses now. Only its mark is read before it is known
    // to be one.
    let slave = unsafe {
        let is_one = !slave.is_null() && (&raw const (*slave).magic).read() == MAGIC;
        is_one.then(|| &mut *slave)
    }?;
    if slave.home != home() {
        slave.follow()?;
    }
    Some(slave)
}

/// Takes an instance back to free it. `None` for NULL and for memory that is no instance.
///
/// # Safety
/// As for [`enter`]; `c` must not be used afterwards.
pub(super) unsafe fn take(c: fmi2Component) -> Option<Box<Slave>> {
    // SAFETY: the caller's promise.
    let slave = unsafe { slave(c) }?;
    // A second free of the same pointer then finds no mark, as long as the memory has not been reused. Volatile, or the
    // compiler would drop the last write to memory that is freed.
    // SAFETY: a live instance.
    unsafe { (&raw mut slave.magic).write_volatile(0) };
    // SAFETY: every `Slave` behind an `fmi2Component` was made by `Box::into_raw` in `fmi2Instantiate`.
    Some(unsafe { Box::from_raw(slave) })
}

#[cold]
#[inline(never)]
fn not_allowed(slave: &Slave, call: Call) -> Refusal {
    if call.is_for(slave.purpose) {
        Refusal::error(format_args!("may not be called in state {:?}", slave.state))
    } else {
        Refusal::error(format_args!("is no function of an instance for {:?}", slave.purpose))
    }
}

#[cold]
#[inline(never)]
fn is_null(name: &str) -> Refusal {
    Refusal::error(format_args!("{name} is NULL"))
}

#[cold]
#[inline(never)]
fn refused(slave: &mut Slave, call: Call, refusal: Refusal) -> fmi2Status {
    let (reason, text) = match refusal {
        Refusal::Discard(text) => (Reason::Discard, text),
        Refusal::Trial(text) => (Reason::Trial, text),
        Refusal::Error(text) => (Reason::Error, text),
    };
    if reason == Reason::Error {
        slave.state = State::Error;
    }
    slave.log.keep(reason, format_args!("fmi2{call:?}: {text}"));
    if reason == Reason::Error { fmi2Status::fmi2Error } else { fmi2Status::fmi2Discard }
}

/// The `n` elements at `pointer`. FMI leaves the pointer undefined for n = 0.
///
/// # Safety
/// `pointer` must be NULL or point to `n` readable elements that nobody writes during the call.
#[inline(always)]
pub(super) unsafe fn array<'a, T>(pointer: *const T, n: usize, name: &str) -> Result<&'a [T], Refusal> {
    if n == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(is_null(name));
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, n) })
}

/// As [`array`], to write.
///
/// # Safety
/// `pointer` must be NULL or point to `n` writable elements that nobody else uses during the call.
#[inline(always)]
pub(super) unsafe fn array_mut<'a, T>(pointer: *mut T, n: usize, name: &str) -> Result<&'a mut [T], Refusal> {
    if n == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return Err(is_null(name));
    }
    // SAFETY: not NULL, and the caller promises `n` elements.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, n) })
}

/// A zero-terminated text of the importer, or `None` for NULL.
///
/// # Safety
/// `text` must be NULL or point to a zero-terminated text that lives as long as the result is used.
pub(super) unsafe fn text<'a>(text: super::types::fmi2String) -> Option<&'a CStr> {
    // SAFETY: not NULL, and the caller promises a terminated text.
    (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) })
}
