//! Instances of FMI 3.0.

use super::layout::{Elements, Layout, Name};
use super::lifecycle::{Call, FIRST_NUMBER, STATES, State};
use super::log::Messages;
use super::types::{
    fmi3Instance, fmi3InstanceEnvironment, fmi3IntermediateUpdateCallback, fmi3Status, fmi3ValueReference,
};
use crate::component::{self, Lifecycle, Purpose, Version};
use stribeck::instance::Trial;
use stribeck::memory::{self, OutOfMemory};
use stribeck::model::ModelType;

pub(super) use crate::component::{Experiment, Outcome, Refusal, refuse};

/// The instance behind an importer's `fmi3Instance`.
pub(super) type Component = component::Component<Fmi3>;

/// FMI 3.0.
pub(super) enum Fmi3 {}

/// Data that only instances of FMI 3.0 have.
pub(super) struct Own {
    pub layout: Layout,
    /// Workspace.
    pub indicators: Box<[f64]>,
    pub stepping: Stepping,
}

/// Abilities of the importer of an instance for co-simulation, and what they require.
pub(super) struct Stepping {
    /// Whether it handles events.
    pub has_event_mode: bool,
    /// Whether it handles steps that end early.
    pub may_return_early: bool,
    /// Its callback within a step.
    pub update: fmi3IntermediateUpdateCallback,
    pub environment: fmi3InstanceEnvironment,
    /// Variables that it reads there.
    pub required: Box<[fmi3ValueReference]>,
    /// Workspace, if it handles events or has a callback.
    pub trial: Option<Box<Trial>>,
}

impl Stepping {
    /// For Model Exchange.
    pub fn none() -> Stepping {
        Stepping {
            has_event_mode: false,
            may_return_early: false,
            update: None,
            environment: std::ptr::null_mut(),
            required: Box::default(),
            trial: None,
        }
    }
}

impl Own {
    pub fn of(model: &ModelType, stepping: Stepping) -> Result<Own, OutOfMemory> {
        let indicators = memory::filled(0.0, model.event_indicators)?;
        Ok(Own { layout: Layout::of(model)?, indicators, stepping })
    }
}

impl Component {
    /// The elements of a variable; an error if there is none with this reference.
    pub fn elements(&self, reference: fmi3ValueReference) -> Result<Elements<'_>, Refusal> {
        self.own.layout.find(self.instance.model(), reference).ok_or_else(|| unknown(reference))
    }

    /// The name of a variable.
    pub fn name<'a>(&'a self, elements: Elements<'a>) -> Name<'a> {
        Name(self.instance.model(), &self.own.layout, elements)
    }

    /// Refuses parameters that do not fit together, or numbers of elements beyond the sizes of their arrays.
    pub fn check_all(&mut self) -> Outcome {
        self.check_sizes()?;
        Ok(self.check_parameters()?)
    }

    /// Refuses numbers of elements beyond the sizes of their arrays.
    #[inline]
    pub fn check_sizes(&self) -> Outcome {
        match self.own.layout.too_small(self.instance.row()) {
            None => Ok(()),
            Some((column, size)) => Err(too_many(self, column, size)),
        }
    }
}

#[cold]
fn unknown(reference: fmi3ValueReference) -> Refusal {
    Refusal::error(format_args!("value reference {reference} does not belong to any variable"))
}

#[cold]
#[inline(never)]
fn too_many(component: &Component, column: usize, size: usize) -> Refusal {
    let path = component.instance.model().table.at(column).path;
    let (value, most) = (component.instance.row()[column], component.own.layout.sizes[size]);
    let name = component.name(Elements::One(super::layout::Item::Size(size)));
    Refusal::error(format_args!("{path} = {value}: must be at most {name} = {most}"))
}

impl Version for Fmi3 {
    type Call = Call;
    type State = State;
    type Status = fmi3Status;
    type Logger = Messages;
    type Own = Own;
    const PREFIX: &'static str = "fmi3";
    const MAGIC: u64 = u64::from_le_bytes(*b"STRIFMI3");
    const SAVED: u64 = u64::from_le_bytes(*b"STRISAV3");
    const NAME_OF_SAVED: &'static str = "FMUState";
    const OK: fmi3Status = fmi3Status::fmi3OK;
    const DISCARD: fmi3Status = fmi3Status::fmi3Discard;
    const ERROR: fmi3Status = fmi3Status::fmi3Error;

    #[inline(always)]
    fn is_allowed(call: Call, state: State) -> bool {
        call.is_allowed(state)
    }

    #[inline(always)]
    fn is_for(call: Call, purpose: Purpose) -> bool {
        call.is_for(purpose)
    }

    fn check_saved(component: &Component, state: State) -> Outcome {
        let purpose = component.purpose;
        // None is saved there, and nothing would lead out of it.
        if state == State::IntermediateUpdateMode {
            return refuse(format_args!("FMUState is in state {state:?}, which only a step enters"));
        }
        if !state.is_for(purpose) {
            return refuse(format_args!("FMUState is in state {state:?}, which {purpose:?} does not have"));
        }
        if state == State::EventMode && purpose == Purpose::CoSimulation && !component.own.stepping.has_event_mode {
            return refuse("FMUState is in state EventMode, and eventModeUsed was fmi3False");
        }
        Ok(())
    }

    fn sizes(own: &Own) -> &[usize] {
        &own.layout.sizes
    }

    fn sizes_mut(own: &mut Own) -> &mut [usize] {
        &mut own.layout.sizes
    }

    fn largest_sizes(own: &Own) -> &[usize] {
        &own.layout.most
    }
}

impl Lifecycle for State {
    const ALL: &'static [(State, f64)] = &component::numbered(STATES, FIRST_NUMBER);
    const INSTANTIATED: State = State::Instantiated;
    const FAILED: State = State::Error;
    const EVENT_MODE: State = State::EventMode;
    const CONTINUOUS_TIME_MODE: State = State::ContinuousTimeMode;
}

/// See [`component::enter`].
///
/// # Safety
/// `instance` must be NULL or an instance of FMI 3.0 that is not yet freed, not in use by another thread.
#[inline(always)]
pub(super) unsafe fn enter(
    instance: fmi3Instance,
    call: Call,
    body: impl FnOnce(&mut Component) -> Outcome,
) -> fmi3Status {
    // SAFETY: the caller's promise.
    unsafe { component::enter::<Fmi3>(instance, call, body) }
}

/// See [`component::stepping`].
///
/// # Safety
/// As for [`enter`].
#[inline(always)]
pub(super) unsafe fn stepping<'a>(instance: fmi3Instance) -> Option<&'a mut Component> {
    // SAFETY: the caller's promise.
    unsafe { component::stepping::<Fmi3>(instance, State::StepMode) }
}

/// See [`component::take`].
///
/// # Safety
/// As for [`enter`]; `instance` must not be used afterwards.
pub(super) unsafe fn take(instance: fmi3Instance) -> Option<Box<Component>> {
    // SAFETY: the caller's promise.
    unsafe { component::take::<Fmi3>(instance) }
}

/// See [`component::live`].
///
/// # Safety
/// As for [`enter`].
pub(super) unsafe fn live<'a>(instance: fmi3Instance) -> Option<&'a mut Component> {
    // SAFETY: the caller's promise.
    unsafe { component::live::<Fmi3>(instance) }
}
