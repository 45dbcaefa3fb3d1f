//! Instances of FMI 2.0.

use super::lifecycle::{Call, STATES, State};
use super::log::Callbacks;
use super::types::{fmi2Component, fmi2Status};
use crate::component::{self, Lifecycle, Purpose, Version};

pub(super) use crate::component::{Experiment, Outcome, Refusal, refuse};

/// The instance behind an importer's `fmi2Component`.
pub(super) type Component = component::Component<Fmi2>;

/// The types in which an instance shows its variables.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Types {
    /// As they are declared.
    Declared,
    /// All as Real, for FMUs of hosts that know no other type.
    Real,
}

/// FMI 2.0.
pub(super) enum Fmi2 {}

impl Version for Fmi2 {
    type Call = Call;
    type State = State;
    type Status = fmi2Status;
    type Logger = Callbacks;
    type Own = Types;
    const PREFIX: &'static str = "fmi2";
    const MAGIC: u64 = u64::from_le_bytes(*b"STRIBECK");
    const SAVED: u64 = u64::from_le_bytes(*b"STRISAVE");
    const NAME_OF_SAVED: &'static str = "FMUstate";
    const OK: fmi2Status = fmi2Status::fmi2OK;
    const DISCARD: fmi2Status = fmi2Status::fmi2Discard;
    const ERROR: fmi2Status = fmi2Status::fmi2Error;

    #[inline(always)]
    fn is_allowed(call: Call, state: State) -> bool {
        call.is_allowed(state)
    }

    #[inline(always)]
    fn is_for(call: Call, purpose: Purpose) -> bool {
        call.is_for(purpose)
    }

    fn check_saved(component: &Component, state: State) -> Outcome {
        if state.is_for(component.purpose) {
            return Ok(());
        }
        refuse(format_args!("FMUstate is in state {state:?}, which {:?} does not have", component.purpose))
    }
}

impl Lifecycle for State {
    const ALL: &'static [(State, f64)] = &component::numbered(STATES, 0);
    const INSTANTIATED: State = State::Instantiated;
    const FAILED: State = State::Error;
    const EVENT_MODE: State = State::EventMode;
    const CONTINUOUS_TIME_MODE: State = State::ContinuousTimeMode;
}

/// See [`component::enter`].
///
/// # Safety
/// `c` must be NULL or an instance made by `fmi2Instantiate` and not yet freed, not in use by another thread.
#[inline(always)]
pub(super) unsafe fn enter(c: fmi2Component, call: Call, body: impl FnOnce(&mut Component) -> Outcome) -> fmi2Status {
    // SAFETY: the caller's promise.
    unsafe { component::enter::<Fmi2>(c, call, body) }
}

/// See [`component::stepping`].
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(super) unsafe fn stepping<'a>(c: fmi2Component) -> Option<&'a mut Component> {
    // SAFETY: the caller's promise.
    unsafe { component::stepping::<Fmi2>(c, State::StepComplete) }
}

/// See [`component::take`].
///
/// # Safety
/// As for [`enter`]; `c` must not be used afterwards.
pub(super) unsafe fn take(c: fmi2Component) -> Option<Box<Component>> {
    // SAFETY: the caller's promise.
    unsafe { component::take::<Fmi2>(c) }
}
