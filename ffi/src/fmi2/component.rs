//! The entry of every call on an instance: checks of pointer and state, panics, log.

use std::fmt;

use super::lifecycle::{Call, Purpose, State};
use super::log::{Log, Reason};
use super::types::{fmi2Component, fmi2Status};
use crate::guard::pointer::Null;
use crate::guard::{self, Handle, Internal};
use crate::models;
use stribeck::guid::GuidText;
use stribeck::instance::{Instance, Refused};
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::Fault;

/// The instance behind an importer's `fmi2Component`.
pub(super) struct Component {
    magic: u64,
    /// Address of the library in the last call.
    home: usize,
    /// Guid of the model, wherever the library is.
    pub guid: GuidText,
    pub instance: Instance,
    pub purpose: Purpose,
    pub state: State,
    pub experiment: Experiment,
    /// Whether states jumped in fmi2ExitInitializationMode; the next fmi2NewDiscreteStates must report it.
    pub has_jumped: bool,
    /// Number of steps of the run.
    steps: u64,
    pub log: Log,
}

/// The experiment as declared by fmi2SetupExperiment.
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

/// Marks the memory of a live instance, so that a pointer to anything else is refused.
const MAGIC: u64 = u64::from_le_bytes(*b"STRIBECK");

/// Address of the library.
fn home() -> usize {
    static HERE: u8 = 0;
    (&raw const HERE).addr()
}

impl Component {
    pub fn new(instance: Instance, purpose: Purpose, log: Log) -> Component {
        Component {
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

    /// Binds the instance to the library at its present address. An importer may unload and reload it while instances live, possibly
    /// to another address: Ecos 0.7.2 does so before each further instance of an FMU. Of all that an instance holds
    /// only its model is in the library; the rest is in the host's memory and stays.
    #[cold]
    #[inline(never)]
    fn rebind(&mut self) -> Option<()> {
        crate::guard::panics::silence();
        self.instance.set_model(models::by_guid(self.guid)?);
        self.home = home();
        Some(())
    }

    /// Rejects parameters that do not fit together, or that do not suit the interface type of this instance.
    pub fn check_parameters(&mut self) -> Result<(), Fault> {
        self.instance.check()?;
        match self.purpose {
            Purpose::CoSimulation => Ok(()),
            Purpose::ModelExchange => self.instance.model().check_model_exchange(self.instance.row()),
        }
    }

    /// Starts a run. Parameters with which the model is not passive are known now, whatever the inputs will be.
    pub fn begin(&mut self) {
        self.steps = 0;
        if let Some(warning) = self.instance.model().passivity(self.instance.row()) {
            self.log.note(&warning.0);
        }
    }

    /// Counts a step, and after steps 1, 2, 4, 8 and so on asks the model for warnings. The first step is not enough,
    /// because some hosts set inputs late and some faults show only with time; every step would cost too much.
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

    /// See [`Refusal::out_of_domain`].
    pub fn out_of_domain(&self, fault: Fault) -> Refusal {
        Refusal::out_of_domain(self.state, fault)
    }

    /// Why the instance refused to set or read a variable. Another value can be tried; anything else is an error.
    #[cold]
    pub fn refusal(&self, refused: Refused) -> Refusal {
        match refused {
            Refused::Value(fault) => Refusal::Discard(fault.0),
            Refused::NotFinite(fault) => self.out_of_domain(fault),
            Refused::NotNow(path) => Refusal::error(format_args!("{path} cannot be set in state {:?}", self.state)),
            Refused::Unknown(fault) | Refused::NotSettable(fault) => Refusal::Error(fault.0),
        }
    }
}

/// Why a call was refused. The text is truncated if memory runs out, possibly to nothing.
pub(super) enum Refusal {
    /// The value is refused; another one can be tried.
    Discard(String),
    /// As `Discard`, in the ordinary course of a run: a solver's trial, or a query for something that does not exist.
    Trial(String),
    /// The call is wrong.
    Error(String),
}

impl Refusal {
    pub fn error(text: impl fmt::Display) -> Refusal {
        Refusal::Error(memory::text(text))
    }

    /// Results that would not be finite: during a run a solver may try a smaller step or other inputs; elsewhere the
    /// run is over.
    pub fn out_of_domain(state: State, fault: Fault) -> Refusal {
        match state {
            State::EventMode | State::ContinuousTimeMode => Refusal::Trial(fault.0),
            _ => Refusal::Error(fault.0),
        }
    }
}

impl From<OutOfMemory> for Refusal {
    fn from(error: OutOfMemory) -> Refusal {
        Refusal::error(error)
    }
}

pub(super) type Outcome = Result<(), Refusal>;

impl From<Null> for Refusal {
    #[cold]
    fn from(null: Null) -> Refusal {
        Refusal::error(null)
    }
}

impl From<Internal> for Refusal {
    fn from(internal: Internal) -> Refusal {
        Refusal::Error(internal.0)
    }
}

/// A fault of the model, as a refusal.
impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Refusal {
        Refusal::Error(fault.0)
    }
}

pub(super) fn refuse<T>(text: impl fmt::Display) -> Result<T, Refusal> {
    Err(Refusal::error(text))
}

/// Runs `body` on the instance behind `c` if the call is allowed in its state, and turns the outcome into a status. A
/// refused call is logged; after an error only reset, free and restore are allowed, as in the standard.
///
/// The logger is called last: if it throws, the exception passes to the host as if the function of this library had
/// thrown it, and the instance is in the state implied by the status. See [`Log`] for what that requires of this
/// function and its callers: nothing in them may need to be dropped.
///
/// # Safety
/// `c` must be NULL or an instance made by `fmi2Instantiate` and not yet freed, not in use by another thread.
#[inline(always)]
pub(super) unsafe fn enter(c: fmi2Component, call: Call, body: impl FnOnce(&mut Component) -> Outcome) -> fmi2Status {
    // SAFETY: the caller's promise.
    let Some(component) = (unsafe { component(c) }) else { return fmi2Status::fmi2Error };
    let status = guarded(component, call, body);
    if component.log.is_waiting() {
        component.log.tell();
    }
    status
}

/// The part of [`enter`] before any message is logged.
#[inline(never)]
fn guarded(component: &mut Component, call: Call, body: impl FnOnce(&mut Component) -> Outcome) -> fmi2Status {
    guard::run(component, call, body)
}

impl Handle for Component {
    type Call = Call;
    type Refusal = Refusal;
    type Status = fmi2Status;
    const OK: fmi2Status = fmi2Status::fmi2OK;

    #[inline(always)]
    fn check(&self, call: Call) -> Outcome {
        if call.is_allowed(self.state) && call.is_for(self.purpose) { Ok(()) } else { Err(not_allowed(self, call)) }
    }

    #[cold]
    #[inline(never)]
    fn refuse(&mut self, call: Call, refusal: Refusal) -> fmi2Status {
        let (reason, text) = match refusal {
            Refusal::Discard(text) => (Reason::Discard, text),
            Refusal::Trial(text) => (Reason::Trial, text),
            Refusal::Error(text) => (Reason::Error, text),
        };
        if reason == Reason::Error {
            self.state = State::Error;
        }
        self.log.keep(reason, format_args!("fmi2{call:?}: {text}"));
        if reason == Reason::Error { fmi2Status::fmi2Error } else { fmi2Status::fmi2Discard }
    }
}

/// The instance behind `c` if it is ready to step: the condition for the fast path, in which nothing can be refused.
/// Anything else goes through [`enter`].
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(super) unsafe fn stepping<'a>(c: fmi2Component) -> Option<&'a mut Component> {
    // SAFETY: the caller's promise.
    unsafe { component(c) }.filter(|component| component.state == State::StepComplete)
}

/// The live instance behind `c`.
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
unsafe fn component<'a>(c: fmi2Component) -> Option<&'a mut Component> {
    let component = c.cast::<Component>();
    // SAFETY: the caller promises NULL or a `Component` that is not in use elsewhere. Only its mark is read before it is
    // known to be one.
    let component = unsafe {
        let is_one = !component.is_null() && (&raw const (*component).magic).read() == MAGIC;
        is_one.then(|| &mut *component)
    }?;
    if component.home != home() {
        component.rebind()?;
    }
    Some(component)
}

/// Takes an instance back to free it. `None` for NULL and for memory that is not an instance.
///
/// # Safety
/// As for [`enter`]; `c` must not be used afterwards.
pub(super) unsafe fn take(c: fmi2Component) -> Option<Box<Component>> {
    // SAFETY: the caller's promise.
    let component = unsafe { component(c) }?;
    // A second free of the same pointer then finds no mark, as long as the memory has not been reused. Volatile, or the
    // compiler would drop the last write to memory that is freed.
    // SAFETY: a live instance.
    unsafe { (&raw mut component.magic).write_volatile(0) };
    // SAFETY: every `Component` behind an `fmi2Component` was made by `Box::into_raw` in `fmi2Instantiate`.
    Some(unsafe { Box::from_raw(component) })
}

#[cold]
#[inline(never)]
fn not_allowed(component: &Component, call: Call) -> Refusal {
    if call.is_for(component.purpose) {
        Refusal::error(format_args!("may not be called in state {:?}", component.state))
    } else {
        Refusal::error(format_args!("is not available on an instance for {:?}", component.purpose))
    }
}
