//! The state machines of FMI 3.0.2 sections 2.3 (common states), 3.2 (Model Exchange) and 4.2 (co-simulation), as one
//! table: which function may be called in which state.

pub use crate::component::Purpose;

use stribeck::instance::Phase;

/// States that an instance can reach. It has no Reconfiguration Mode, because no size of an array can be changed during a
/// run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// After it was made, or after fmi3Reset.
    Instantiated,
    /// Where the sizes of arrays are set.
    ConfigurationMode,
    /// Between fmi3EnterInitializationMode and fmi3ExitInitializationMode.
    InitializationMode,
    /// Where inputs and discrete states may jump.
    EventMode,
    /// Model Exchange: where time and states move.
    ContinuousTimeMode,
    /// Co-simulation: ready for fmi3DoStep.
    StepMode,
    /// Co-simulation: within a step, in the callback of the importer.
    IntermediateUpdateMode,
    /// After fmi3Terminate.
    Terminated,
    /// Terminated by a call that returned fmi3Error.
    Error,
}

/// All states, in the order of the columns of [`ALLOWED`].
pub const STATES: [State; 9] = [
    State::Instantiated,
    State::ConfigurationMode,
    State::InitializationMode,
    State::EventMode,
    State::ContinuousTimeMode,
    State::StepMode,
    State::IntermediateUpdateMode,
    State::Terminated,
    State::Error,
];

/// Number of the first state in bytes: those of FMI 2.0 have smaller ones.
pub const FIRST_NUMBER: usize = 16;

impl State {
    /// Whether an instance of this interface type can be in this state.
    pub const fn is_for(self, purpose: Purpose) -> bool {
        match self {
            State::StepMode | State::IntermediateUpdateMode => matches!(purpose, Purpose::CoSimulation),
            State::ContinuousTimeMode => matches!(purpose, Purpose::ModelExchange),
            _ => true,
        }
    }

    /// The phase of the instance, which decides what may be set.
    pub(super) const fn phase(self) -> Phase {
        match self {
            State::Instantiated | State::ConfigurationMode | State::InitializationMode => Phase::Setup,
            State::ContinuousTimeMode => Phase::Integrating,
            _ => Phase::Stepping,
        }
    }
}

/// The functions that act on an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "they are the functions of the standard, by name")]
pub enum Call {
    SetDebugLogging,
    EnterInitializationMode,
    ExitInitializationMode,
    EnterEventMode,
    Terminate,
    Reset,
    GetFloat32,
    GetFloat64,
    GetInt8,
    GetUInt8,
    GetInt16,
    GetUInt16,
    GetInt32,
    GetUInt32,
    GetInt64,
    GetUInt64,
    GetBoolean,
    GetString,
    GetBinary,
    GetClock,
    SetFloat32,
    SetFloat64,
    SetInt8,
    SetUInt8,
    SetInt16,
    SetUInt16,
    SetInt32,
    SetUInt32,
    SetInt64,
    SetUInt64,
    SetBoolean,
    SetString,
    SetBinary,
    SetClock,
    GetNumberOfVariableDependencies,
    GetVariableDependencies,
    GetFMUState,
    SetFMUState,
    FreeFMUState,
    SerializedFMUStateSize,
    SerializeFMUState,
    DeserializeFMUState,
    GetDirectionalDerivative,
    GetAdjointDerivative,
    EnterConfigurationMode,
    ExitConfigurationMode,
    GetIntervalDecimal,
    GetIntervalFraction,
    GetShiftDecimal,
    GetShiftFraction,
    SetIntervalDecimal,
    SetIntervalFraction,
    SetShiftDecimal,
    SetShiftFraction,
    EvaluateDiscreteStates,
    UpdateDiscreteStates,
    EnterContinuousTimeMode,
    CompletedIntegratorStep,
    SetTime,
    SetContinuousStates,
    GetContinuousStateDerivatives,
    GetEventIndicators,
    GetContinuousStates,
    GetNominalsOfContinuousStates,
    GetNumberOfEventIndicators,
    GetNumberOfContinuousStates,
    EnterStepMode,
    GetOutputDerivatives,
    DoStep,
    ActivateModelPartition,
}

/// The functions that make or free an instance, or need none.
const WITHOUT_INSTANCE: [&str; 5] = [
    "fmi3GetVersion",
    "fmi3InstantiateModelExchange",
    "fmi3InstantiateCoSimulation",
    "fmi3InstantiateScheduledExecution",
    "fmi3FreeInstance",
];

/// The names of all functions of fmi3Functions.h.
pub fn functions() -> impl Iterator<Item = String> {
    let on_instance = ALLOWED.iter().map(|(call, ..)| format!("fmi3{call:?}"));
    WITHOUT_INSTANCE.into_iter().map(str::to_owned).chain(on_instance)
}

const X: bool = true;
const O: bool = false;

const BOTH: [Purpose; 2] = [Purpose::CoSimulation, Purpose::ModelExchange];
const CS: [Purpose; 2] = [Purpose::CoSimulation; 2];
const ME: [Purpose; 2] = [Purpose::ModelExchange; 2];

/// Row: function, in the order of [`Call`], and the interface types that have it. Column: instantiated, configuration,
/// initialization, event, continuous-time, step, intermediate update, terminated, error.
///
/// More than the standard allows: numbers of states and indicators at any time, and fmi3SetTime in Event Mode.
#[rustfmt::skip]
pub const ALLOWED: [(Call, [Purpose; 2], [bool; 9]); 70] = [
    (Call::SetDebugLogging,                 BOTH, [X, X, X, X, X, X, X, X, X]),
    (Call::EnterInitializationMode,         BOTH, [X, O, O, O, O, O, O, O, O]),
    (Call::ExitInitializationMode,          BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::EnterEventMode,                  BOTH, [O, O, O, O, X, X, O, O, O]),
    (Call::Terminate,                       BOTH, [O, O, O, X, X, X, O, O, O]),
    (Call::Reset,                           BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::GetFloat32,                      BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetFloat64,                      BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetInt8,                         BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetUInt8,                        BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetInt16,                        BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetUInt16,                       BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetInt32,                        BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetUInt32,                       BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetInt64,                        BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetUInt64,                       BOTH, [X, X, X, X, X, X, X, X, X]),
    (Call::GetBoolean,                      BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetString,                       BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetBinary,                       BOTH, [X, O, X, X, X, X, X, X, X]),
    (Call::GetClock,                        BOTH, [O, O, O, X, O, O, O, O, O]),
    (Call::SetFloat32,                      BOTH, [X, O, X, X, X, X, O, O, O]),
    (Call::SetFloat64,                      BOTH, [X, O, X, X, X, X, O, O, O]),
    (Call::SetInt8,                         BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetUInt8,                        BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetInt16,                        BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetUInt16,                       BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetInt32,                        BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetUInt32,                       BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetInt64,                        BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetUInt64,                       BOTH, [X, X, X, X, O, X, O, O, O]),
    (Call::SetBoolean,                      BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetString,                       BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetBinary,                       BOTH, [X, O, X, X, O, X, O, O, O]),
    (Call::SetClock,                        BOTH, [O, O, O, X, O, O, O, O, O]),
    (Call::GetNumberOfVariableDependencies, BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::GetVariableDependencies,         BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::GetFMUState,                     BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::SetFMUState,                     BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::FreeFMUState,                    BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::SerializedFMUStateSize,          BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::SerializeFMUState,               BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::DeserializeFMUState,             BOTH, [X, X, X, X, X, X, O, X, X]),
    (Call::GetDirectionalDerivative,        BOTH, [O, O, X, X, X, X, O, X, X]),
    (Call::GetAdjointDerivative,            BOTH, [O, O, X, X, X, X, O, X, X]),
    (Call::EnterConfigurationMode,          BOTH, [X, O, O, O, O, O, O, O, O]),
    (Call::ExitConfigurationMode,           BOTH, [O, X, O, O, O, O, O, O, O]),
    (Call::GetIntervalDecimal,              BOTH, [O, O, X, X, O, O, O, O, O]),
    (Call::GetIntervalFraction,             BOTH, [O, O, X, X, O, O, O, O, O]),
    (Call::GetShiftDecimal,                 BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::GetShiftFraction,                BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::SetIntervalDecimal,              BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::SetIntervalFraction,             BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::SetShiftDecimal,                 BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::SetShiftFraction,                BOTH, [O, O, X, O, O, O, O, O, O]),
    (Call::EvaluateDiscreteStates,          BOTH, [O, O, O, X, O, O, O, O, O]),
    (Call::UpdateDiscreteStates,            BOTH, [O, O, O, X, O, O, O, O, O]),
    (Call::EnterContinuousTimeMode,         ME,   [O, O, O, X, O, O, O, O, O]),
    (Call::CompletedIntegratorStep,         ME,   [O, O, O, O, X, O, O, O, O]),
    (Call::SetTime,                         ME,   [O, O, O, X, X, O, O, O, O]),
    (Call::SetContinuousStates,             ME,   [O, O, O, O, X, O, O, O, O]),
    (Call::GetContinuousStateDerivatives,   ME,   [O, O, X, X, X, O, O, X, X]),
    (Call::GetEventIndicators,              ME,   [O, O, X, X, X, O, O, X, X]),
    (Call::GetContinuousStates,             ME,   [O, O, X, X, X, O, O, X, X]),
    (Call::GetNominalsOfContinuousStates,   ME,   [O, O, X, X, X, O, O, X, X]),
    (Call::GetNumberOfEventIndicators,      ME,   [X, X, X, X, X, O, O, X, X]),
    (Call::GetNumberOfContinuousStates,     ME,   [X, X, X, X, X, O, O, X, X]),
    (Call::EnterStepMode,                   CS,   [O, O, O, X, O, O, O, O, O]),
    (Call::GetOutputDerivatives,            CS,   [O, O, O, O, O, X, X, X, X]),
    (Call::DoStep,                          CS,   [O, O, O, O, O, X, O, O, O]),
    (Call::ActivateModelPartition,          CS,   [O, O, O, O, O, O, O, O, O]),
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
