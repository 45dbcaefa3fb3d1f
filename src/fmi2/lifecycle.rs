//! The state machine of FMI 2.0.5 section 4.2.4, as one table: which function may be called in which state.

/// States that a synchronous slave can reach. It never discards a step, and never fails beyond repair.
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
}

/// All states, in the order of the columns of [`ALLOWED`].
pub const STATES: [State; 5] =
    [State::Instantiated, State::Initialization, State::StepComplete, State::Terminated, State::Error];

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
}

const X: bool = true;
const O: bool = false;

/// Row: function, in the order of [`Call`]. Column: instantiated, initialization, stepComplete, terminated, error.
#[rustfmt::skip]
pub const ALLOWED: [(Call, [bool; 5]); 30] = [
    (Call::SetDebugLogging,          [X, X, X, X, X]),
    (Call::SetupExperiment,          [X, O, O, O, O]),
    (Call::EnterInitializationMode,  [X, O, O, O, O]),
    (Call::ExitInitializationMode,   [O, X, O, O, O]),
    (Call::Terminate,                [O, O, X, O, O]),
    (Call::Reset,                    [X, X, X, X, X]),
    (Call::GetReal,                  [O, X, X, X, X]),
    (Call::GetInteger,               [O, X, X, X, X]),
    (Call::GetBoolean,               [O, X, X, X, X]),
    (Call::GetString,                [O, X, X, X, X]),
    (Call::SetReal,                  [X, X, X, O, O]),
    (Call::SetInteger,               [X, X, X, O, O]),
    (Call::SetBoolean,               [X, X, X, O, O]),
    (Call::SetString,                [X, X, X, O, O]),
    (Call::GetFMUstate,              [X, X, X, X, X]),
    (Call::SetFMUstate,              [X, X, X, X, X]),
    (Call::FreeFMUstate,             [X, X, X, X, X]),
    (Call::SerializedFMUstateSize,   [X, X, X, X, X]),
    (Call::SerializeFMUstate,        [X, X, X, X, X]),
    (Call::DeSerializeFMUstate,      [X, X, X, X, X]),
    (Call::GetDirectionalDerivative, [O, X, X, X, X]),
    (Call::SetRealInputDerivatives,  [X, X, X, O, O]),
    (Call::GetRealOutputDerivatives, [O, O, X, X, X]),
    (Call::DoStep,                   [O, O, X, O, O]),
    (Call::CancelStep,               [O, O, O, O, O]),
    (Call::GetStatus,                [O, O, X, X, O]),
    (Call::GetRealStatus,            [O, O, X, X, O]),
    (Call::GetIntegerStatus,         [O, O, X, X, O]),
    (Call::GetBooleanStatus,         [O, O, X, X, O]),
    (Call::GetStringStatus,          [O, O, X, X, O]),
];

impl Call {
    /// May it be called in that state?
    #[inline]
    pub const fn is_allowed(self, state: State) -> bool {
        ALLOWED[self as usize].1[state as usize]
    }
}

const _: () = {
    let mut row = 0;
    while row < ALLOWED.len() {
        assert!(ALLOWED[row].0 as usize == row, "the rows of ALLOWED are in the order of Call");
        row += 1;
    }
};
