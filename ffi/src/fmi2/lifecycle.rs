//! The state machines of FMI 2.0.5 sections 3.2.3 (Model Exchange) and 4.2.4 (co-simulation), as one table: which
//! function may be called in which state.

pub use crate::component::Purpose;

use stribeck::instance::Phase;

/// States that an instance can reach. It never discards a step, and never fails irrecoverably.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// After fmi2Instantiate or fmi2Reset.
    Instantiated,
    /// Between fmi2EnterInitializationMode and fmi2ExitInitializationMode.
    Initialization,
    /// Ready for fmi2DoStep.
    StepComplete,
    /// After fmi2Terminate.
    Terminated,
    /// After a call that returned fmi2Error.
    Error,
    /// Model Exchange: where inputs and discrete states may jump.
    EventMode,
    /// Model Exchange: where time and states move.
    ContinuousTimeMode,
}

/// All states, in the order of the columns of [`ALLOWED`].
pub const STATES: [State; 7] = [
    State::Instantiated,
    State::Initialization,
    State::StepComplete,
    State::Terminated,
    State::Error,
    State::EventMode,
    State::ContinuousTimeMode,
];

impl State {
    /// Whether an instance of this interface type can be in this state.
    pub const fn is_for(self, purpose: Purpose) -> bool {
        match self {
            State::StepComplete => matches!(purpose, Purpose::CoSimulation),
            State::EventMode | State::ContinuousTimeMode => matches!(purpose, Purpose::ModelExchange),
            _ => true,
        }
    }

    /// The phase of the instance, which decides what may be set.
    pub(super) const fn phase(self) -> Phase {
        match self {
            State::Instantiated | State::Initialization => Phase::Setup,
            State::ContinuousTimeMode => Phase::Integrating,
            State::StepComplete | State::Terminated | State::Error | State::EventMode => Phase::Stepping,
        }
    }
}

/// The functions that act on an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "they are the functions of the standard, by name")]
pub enum Call {
    SetDebugLogging,
    SetupExperiment,
    EnterInitializationMode,
    ExitInitializationMode,
    Terminate,
    Reset,
    GetReal,
    GetInteger,
    GetBoolean,
    GetString,
    SetReal,
    SetInteger,
    SetBoolean,
    SetString,
    GetFMUstate,
    SetFMUstate,
    FreeFMUstate,
    SerializedFMUstateSize,
    SerializeFMUstate,
    DeSerializeFMUstate,
    GetDirectionalDerivative,
    SetRealInputDerivatives,
    GetRealOutputDerivatives,
    DoStep,
    CancelStep,
    GetStatus,
    GetRealStatus,
    GetIntegerStatus,
    GetBooleanStatus,
    GetStringStatus,
    EnterEventMode,
    NewDiscreteStates,
    EnterContinuousTimeMode,
    CompletedIntegratorStep,
    SetTime,
    SetContinuousStates,
    GetDerivatives,
    GetEventIndicators,
    GetContinuousStates,
    GetNominalsOfContinuousStates,
}

const X: bool = true;
const O: bool = false;

const BOTH: [Purpose; 2] = [Purpose::CoSimulation, Purpose::ModelExchange];
const CS: [Purpose; 2] = [Purpose::CoSimulation; 2];
const ME: [Purpose; 2] = [Purpose::ModelExchange; 2];

/// Row: function, in the order of [`Call`], and the interface types that have it. Column: instantiated, initialization,
/// stepComplete, terminated, error, event mode, continuous-time mode.
#[rustfmt::skip]
pub const ALLOWED: [(Call, [Purpose; 2], [bool; 7]); 40] = [
    (Call::SetDebugLogging,               BOTH, [X, X, X, X, X, X, X]),
    (Call::SetupExperiment,               BOTH, [X, O, O, O, O, O, O]),
    (Call::EnterInitializationMode,       BOTH, [X, O, O, O, O, O, O]),
    (Call::ExitInitializationMode,        BOTH, [O, X, O, O, O, O, O]),
    (Call::Terminate,                     BOTH, [O, O, X, O, O, X, X]),
    (Call::Reset,                         BOTH, [X, X, X, X, X, X, X]),
    (Call::GetReal,                       BOTH, [O, X, X, X, X, X, X]),
    (Call::GetInteger,                    BOTH, [O, X, X, X, X, X, X]),
    (Call::GetBoolean,                    BOTH, [O, X, X, X, X, X, X]),
    (Call::GetString,                     BOTH, [O, X, X, X, X, X, X]),
    (Call::SetReal,                       BOTH, [X, X, X, O, O, X, X]),
    (Call::SetInteger,                    BOTH, [X, X, X, O, O, X, O]),
    (Call::SetBoolean,                    BOTH, [X, X, X, O, O, X, O]),
    (Call::SetString,                     BOTH, [X, X, X, O, O, X, O]),
    (Call::GetFMUstate,                   BOTH, [X, X, X, X, X, X, X]),
    (Call::SetFMUstate,                   BOTH, [X, X, X, X, X, X, X]),
    (Call::FreeFMUstate,                  BOTH, [X, X, X, X, X, X, X]),
    (Call::SerializedFMUstateSize,        BOTH, [X, X, X, X, X, X, X]),
    (Call::SerializeFMUstate,             BOTH, [X, X, X, X, X, X, X]),
    (Call::DeSerializeFMUstate,           BOTH, [X, X, X, X, X, X, X]),
    (Call::GetDirectionalDerivative,      BOTH, [O, X, X, X, X, X, X]),
    (Call::SetRealInputDerivatives,       CS,   [X, X, X, O, O, O, O]),
    (Call::GetRealOutputDerivatives,      CS,   [O, O, X, X, X, O, O]),
    (Call::DoStep,                        CS,   [O, O, X, O, O, O, O]),
    (Call::CancelStep,                    CS,   [O, O, O, O, O, O, O]),
    (Call::GetStatus,                     CS,   [O, O, X, X, O, O, O]),
    (Call::GetRealStatus,                 CS,   [O, O, X, X, O, O, O]),
    (Call::GetIntegerStatus,              CS,   [O, O, X, X, O, O, O]),
    (Call::GetBooleanStatus,              CS,   [O, O, X, X, O, O, O]),
    (Call::GetStringStatus,               CS,   [O, O, X, X, O, O, O]),
    (Call::EnterEventMode,                ME,   [O, O, O, O, O, X, X]),
    (Call::NewDiscreteStates,             ME,   [O, O, O, O, O, X, O]),
    (Call::EnterContinuousTimeMode,       ME,   [O, O, O, O, O, X, O]),
    (Call::CompletedIntegratorStep,       ME,   [O, O, O, O, O, O, X]),
    (Call::SetTime,                       ME,   [O, O, O, O, O, X, X]),
    (Call::SetContinuousStates,           ME,   [O, O, O, O, O, O, X]),
    (Call::GetDerivatives,                ME,   [O, X, O, X, X, X, X]),
    (Call::GetEventIndicators,            ME,   [O, X, O, X, X, X, X]),
    (Call::GetContinuousStates,           ME,   [O, X, O, X, X, X, X]),
    (Call::GetNominalsOfContinuousStates, ME,   [X, X, O, X, X, X, X]),
];

impl Call {
    /// Whether it may be called in this state.
    #[inline]
    pub const fn is_allowed(self, state: State) -> bool {
        ALLOWED[self as usize].2[state as usize]
    }

    /// Whether instances of this interface type have it.
    #[inline]
    pub const fn is_for(self, purpose: Purpose) -> bool {
        purpose.is_among(ALLOWED[self as usize].1)
    }
}

const _: () = {
    let mut row = 0;
    while row < ALLOWED.len() {
        assert!(ALLOWED[row].0 as usize == row, "the rows of ALLOWED are in the order of Call");
        row += 1;
    }
};
