//! An instance behind a handle of FMI, whatever its version: the entry of every call with its checks of pointer and
//! state, panics and log, how an instance is made, its steps, its saved states.

use std::ffi::c_void;
use std::fmt;

use crate::guard::pointer::Null;
use crate::guard::{self, Handle, Internal};
use crate::models;
use stribeck::guid::GuidText;
use stribeck::instance::{Instance, Refused};
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::Fault;

pub(crate) mod clock;
pub(crate) mod log;
pub(crate) mod saved;
pub(crate) mod setup;

use log::{Log, Logger, Reason};

/// Interface type requested by the importer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The instance makes steps.
    CoSimulation,
    /// The importer integrates the states.
    ModelExchange,
}

impl Purpose {
    /// Whether it is one of these.
    pub const fn is_among(self, [one, other]: [Purpose; 2]) -> bool {
        one as u8 == self as u8 || other as u8 == self as u8
    }
}

/// A version of FMI: its functions, states and status, and what only its instances have.
pub(crate) trait Version: Sized {
    /// The functions that act on an instance.
    type Call: Copy + fmt::Debug;
    /// States that an instance can reach.
    type State: Lifecycle;
    /// Result of a call.
    type Status;
    /// The logger of an importer.
    type Logger: Logger;
    /// Data that only instances of this version have.
    type Own;
    /// Beginning of the names of its functions.
    const PREFIX: &'static str;
    /// Marks the memory of a live instance, so that a pointer to anything else is refused.
    const MAGIC: u64;
    /// Marks the memory of a saved state.
    const SAVED: u64;
    /// Name of the arguments that are saved states.
    const NAME_OF_SAVED: &'static str;
    /// The status of a call that succeeded.
    const OK: Self::Status;
    /// The status of a refused value.
    const DISCARD: Self::Status;
    /// The status of a refused call.
    const ERROR: Self::Status;

    /// Whether a function may be called in this state.
    fn is_allowed(call: Self::Call, state: Self::State) -> bool;

    /// Whether instances of this interface type have a function.
    fn is_for(call: Self::Call, purpose: Purpose) -> bool;

    /// Refuses a saved state that this instance cannot reach.
    fn check_saved(component: &Component<Self>, state: Self::State) -> Outcome;

    /// Sizes of arrays that the importer has chosen.
    fn sizes(_own: &Self::Own) -> &[usize] {
        &[]
    }

    /// As [`Version::sizes`], to be restored.
    fn sizes_mut(_own: &mut Self::Own) -> &mut [usize] {
        &mut []
    }

    /// The largest of each.
    fn largest_sizes(_own: &Self::Own) -> &[usize] {
        &[]
    }
}

/// The states of a version of FMI.
pub(crate) trait Lifecycle: Copy + fmt::Debug + PartialEq + 'static {
    /// All of them, with the numbers by which saved states know them.
    const ALL: &'static [(Self, f64)];
    /// The first one.
    const INSTANTIATED: Self;
    /// After an error.
    const FAILED: Self;
    /// Where inputs and discrete states may jump.
    const EVENT_MODE: Self;
    /// Where time and states of Model Exchange move.
    const CONTINUOUS_TIME_MODE: Self;

    /// Whether results that are not finite belong to the ordinary course of a run.
    fn is_tried(self) -> bool {
        self.is_at_event() || self.is_between_events()
    }

    /// Whether inputs and discrete states may jump.
    fn is_at_event(self) -> bool {
        self == Self::EVENT_MODE
    }

    /// Whether time and states of Model Exchange move.
    fn is_between_events(self) -> bool {
        self == Self::CONTINUOUS_TIME_MODE
    }
}

/// States with consecutive numbers.
pub(crate) const fn numbered<S: Copy, const N: usize>(states: [S; N], first: usize) -> [(S, f64); N] {
    let mut numbered = [(states[0], 0.0); N];
    let mut at = 0;
    while at < N {
        numbered[at] = (states[at], (first + at) as f64);
        at += 1;
    }
    numbered
}

/// The instance behind a handle. The mark comes first, whatever the version.
#[repr(C)]
pub(crate) struct Component<V: Version> {
    magic: u64,
    /// Address of the library in the last call.
    home: usize,
    /// Guid of the model, wherever the library is.
    pub guid: GuidText,
    pub instance: Instance,
    pub purpose: Purpose,
    pub state: V::State,
    pub experiment: Experiment,
    /// Whether states jumped at the end of the initialization; the next event must report it.
    pub has_jumped: bool,
    /// Number of steps of the run.
    steps: u64,
    pub log: Log<V::Logger>,
    /// Data of this version alone.
    pub own: V::Own,
}

/// The experiment as declared by the importer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Experiment {
    pub is_set_up: bool,
    pub start: f64,
    /// Infinite if no stop time is defined.
    pub stop: f64,
}

impl Experiment {
    pub const NONE: Experiment = Experiment { is_set_up: false, start: 0.0, stop: f64::INFINITY };
}

/// Address of the library.
fn home() -> usize {
    static HERE: u8 = 0;
    (&raw const HERE).addr()
}

impl<V: Version> Component<V> {
    pub fn new(instance: Instance, purpose: Purpose, log: Log<V::Logger>, own: V::Own) -> Component<V> {
        Component {
            magic: V::MAGIC,
            home: home(),
            guid: instance.model().guid_text(),
            instance,
            purpose,
            state: V::State::INSTANTIATED,
            experiment: Experiment::NONE,
            has_jumped: false,
            steps: 0,
            log,
            own,
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
        Refusal::out_of_domain(self.state.is_tried(), fault)
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
pub(crate) enum Refusal {
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
    pub fn out_of_domain(is_tried: bool, fault: Fault) -> Refusal {
        if is_tried { Refusal::Trial(fault.0) } else { Refusal::Error(fault.0) }
    }
}

impl From<OutOfMemory> for Refusal {
    fn from(error: OutOfMemory) -> Refusal {
        Refusal::error(error)
    }
}

pub(crate) type Outcome = Result<(), Refusal>;

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

pub(crate) fn refuse<T>(text: impl fmt::Display) -> Result<T, Refusal> {
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
/// `c` must be NULL or an instance made by this version's functions and not yet freed, not in use by another thread.
#[inline(always)]
pub(crate) unsafe fn enter<V: Version>(
    c: *mut c_void,
    call: V::Call,
    body: impl FnOnce(&mut Component<V>) -> Outcome,
) -> V::Status {
    // SAFETY: the caller's promise.
    let Some(component) = (unsafe { live::<V>(c) }) else { return V::ERROR };
    let status = guarded(component, call, body);
    if component.log.is_waiting() {
        component.log.tell();
    }
    status
}

/// The part of [`enter`] before any message is logged.
#[inline(never)]
fn guarded<V: Version>(
    component: &mut Component<V>,
    call: V::Call,
    body: impl FnOnce(&mut Component<V>) -> Outcome,
) -> V::Status {
    guard::run(component, call, body)
}

impl<V: Version> Handle for Component<V> {
    type Call = V::Call;
    type Refusal = Refusal;
    type Status = V::Status;
    const OK: V::Status = V::OK;

    #[inline(always)]
    fn check(&self, call: V::Call) -> Outcome {
        if V::is_allowed(call, self.state) && V::is_for(call, self.purpose) {
            Ok(())
        } else {
            Err(not_allowed(self, call))
        }
    }

    #[cold]
    #[inline(never)]
    fn refuse(&mut self, call: V::Call, refusal: Refusal) -> V::Status {
        let (reason, text) = match refusal {
            Refusal::Discard(text) => (Reason::Discard, text),
            Refusal::Trial(text) => (Reason::Trial, text),
            Refusal::Error(text) => (Reason::Error, text),
        };
        if reason == Reason::Error {
            self.state = V::State::FAILED;
        }
        self.log.keep(reason, format_args!("{}{call:?}: {text}", V::PREFIX));
        if reason == Reason::Error { V::ERROR } else { V::DISCARD }
    }
}

/// The instance behind `c` if it is in this state, the one for steps: the condition for the fast path, in which nothing
/// can be refused. Anything else goes through [`enter`].
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(crate) unsafe fn stepping<'a, V: Version>(c: *mut c_void, state: V::State) -> Option<&'a mut Component<V>> {
    // SAFETY: the caller's promise.
    unsafe { live::<V>(c) }.filter(|component| component.state == state)
}

/// The live instance behind `c`.
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(crate) unsafe fn live<'a, V: Version>(c: *mut c_void) -> Option<&'a mut Component<V>> {
    let component = c.cast::<Component<V>>();
    // SAFETY: the caller promises NULL or a `Component` that is not in use elsewhere. Only its mark is read before it is
    // known to be one.
    let component = unsafe {
        let is_one = !component.is_null() && (&raw const (*component).magic).read() == V::MAGIC;
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
pub(crate) unsafe fn take<V: Version>(c: *mut c_void) -> Option<Box<Component<V>>> {
    // SAFETY: the caller's promise.
    let component = unsafe { live::<V>(c) }?;
    // A second free of the same pointer then finds no mark, as long as the memory has not been reused. Volatile, or the
    // compiler would drop the last write to memory that is freed.
    // SAFETY: a live instance.
    unsafe { (&raw mut component.magic).write_volatile(0) };
    // SAFETY: every `Component` behind a handle was made by `Box::into_raw` when it was instantiated.
    Some(unsafe { Box::from_raw(component) })
}

#[cold]
#[inline(never)]
fn not_allowed<V: Version>(component: &Component<V>, call: V::Call) -> Refusal {
    if V::is_for(call, component.purpose) {
        Refusal::error(format_args!("may not be called in state {:?}", component.state))
    } else {
        Refusal::error(format_args!("is not available on an instance for {:?}", component.purpose))
    }
}
