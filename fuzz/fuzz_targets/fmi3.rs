//! Sequences of calls of FMI 3.0 on two instances, for co-simulation and for Model Exchange, of any model.
#![no_main]

use std::ffi::CStr;

use arbitrary::Arbitrary;
use fuzz::argument::{Column, Instant, Number, Step, model};
use fuzz::fmi3::{Abilities, Fmi3, Within, arrays_of, columns, count, sizes_of};
use fuzz::misuse3::{self, instantiate, with_null};
use fuzz::saved::ROW;
use fuzz::slave::all_finite;
use fuzz::version::Answer;
use fuzz::world::Effect::{Changes, Reads};
use fuzz::world::{MOST_ACTIONS, MOST_ARGUMENTS, SLOTS, World, length};
use libfuzzer_sys::fuzz_target;
use stribeck::arrays::{Array, Size};
use stribeck::model::ModelType;
use stribeck::reference;
use stribeck_ffi::fmi3::derivatives::*;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::{Call, Purpose, STATES, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::unused::*;
use stribeck_ffi::fmi3::values::*;

fuzz_target!(|scenario: Scenario| Play::new(&scenario).all(scenario.actions));

#[derive(Arbitrary, Debug)]
struct Scenario {
    model: u8,
    /// Another model for the second instance.
    other: Option<u8>,
    exchange: [bool; 2],
    abilities: [Abilities; 2],
    actions: Vec<(bool, Action)>,
}

/// A variable, mostly one that exists.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Known {
    Column(Column),
    Array(u8),
    Derivatives(u8),
    Size(u8),
    Indicators,
}

impl Known {
    fn of(self, model: &'static ModelType) -> u32 {
        let arrays = arrays_of(model);
        let array = |which: u8, reference: fn(&Array) -> u32| {
            arrays.get(usize::from(which) % arrays.len().max(1)).map_or(0, reference)
        };
        match self {
            Known::Column(column) => column.of(model),
            Known::Array(which) => array(which, Array::reference),
            Known::Derivatives(which) => array(which, Array::derivative_reference),
            Known::Size(which) => {
                let sizes = sizes_of(model);
                sizes.get(usize::from(which) % sizes.len().max(1)).map_or(0, Size::reference)
            }
            Known::Indicators => reference::EVENT_INDICATORS,
        }
    }
}

/// Types of whole numbers that some model has.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Whole {
    Int32,
    Int64,
    UInt64,
    Boolean,
}

#[derive(Arbitrary, Debug)]
enum Action {
    /// The calls that usually lead to a state.
    Lead(u8),
    EnterInitialization {
        tolerance: Option<Number>,
        start: Number,
        stop: Option<Number>,
    },
    ExitInitialization,
    EnterConfiguration,
    ExitConfiguration,
    Terminate,
    Reset,
    Log {
        on: bool,
        categories: Vec<u8>,
    },
    GetReal {
        variables: Vec<Known>,
        more: i8,
    },
    SetReal {
        pairs: Vec<(Known, Number)>,
        more: i8,
    },
    GetWhole(Whole, Vec<Known>),
    SetWhole(Whole, Vec<(Known, i32)>),
    /// Types that no model has, and clocks.
    Unused {
        which: u8,
        variables: Vec<Known>,
    },
    GetSlopes {
        pairs: Vec<(Known, i8)>,
        more: i8,
    },
    Direction {
        is_adjoint: bool,
        unknowns: Vec<Known>,
        knowns: Vec<(Known, Number)>,
        more: i8,
    },
    Step {
        at: Instant,
        length: Step,
        within: Within,
    },
    EnterEventMode,
    EvaluateDiscreteStates,
    UpdateDiscreteStates,
    EnterStepMode,
    EnterContinuousTimeMode,
    CompletedIntegratorStep,
    SetTime(Instant),
    SetStates {
        more: i8,
        numbers: Vec<Number>,
    },
    GetArray {
        which: u8,
        more: i8,
    },
    Numbers,
    Save(u8),
    Restore(u8),
    Free(u8),
    Serialize {
        slot: u8,
        spare: i8,
    },
    Deserialize {
        slot: u8,
        damage: Option<(u16, u8)>,
    },
    Null(u8),
    Instantiate {
        kind: u8,
        token: Option<u8>,
        name: u8,
        required: Known,
    },
    Replay {
        steps: u8,
        length: Step,
        elsewhere: bool,
    },
}

/// Two instances and what is done with them.
struct Play(World<Fmi3>);

impl Play {
    fn new(scenario: &Scenario) -> Play {
        let first = model(scenario.model);
        let models = [first, scenario.other.map_or(first, model)];
        Play(World::new(models, scenario.exchange, scenario.abilities))
    }

    fn all(mut self, actions: Vec<(bool, Action)>) {
        for (who, action) in actions.into_iter().take(MOST_ACTIONS) {
            self.act(usize::from(who), action);
        }
    }

    fn act(&mut self, who: usize, action: Action) {
        let slot = |slot: u8| usize::from(slot) % SLOTS;
        let mut plain = |call, function, effect| _ = self.0.plain(who, call, function, effect);
        match action {
            Action::Lead(to) => self.lead(who, STATES[usize::from(to) % STATES.len()]),
            Action::EnterInitialization { tolerance, start, stop } => self.begin(who, tolerance, start, stop),
            Action::ExitInitialization => plain(Call::ExitInitializationMode, fmi3ExitInitializationMode, Changes),
            Action::EnterConfiguration => plain(Call::EnterConfigurationMode, fmi3EnterConfigurationMode, Reads),
            Action::ExitConfiguration => plain(Call::ExitConfigurationMode, fmi3ExitConfigurationMode, Reads),
            Action::Terminate => plain(Call::Terminate, fmi3Terminate, Reads),
            Action::Reset => plain(Call::Reset, fmi3Reset, Changes),
            Action::EnterEventMode => plain(Call::EnterEventMode, fmi3EnterEventMode, Reads),
            Action::EvaluateDiscreteStates => plain(Call::EvaluateDiscreteStates, fmi3EvaluateDiscreteStates, Reads),
            Action::EnterStepMode => plain(Call::EnterStepMode, fmi3EnterStepMode, Reads),
            Action::EnterContinuousTimeMode => plain(Call::EnterContinuousTimeMode, fmi3EnterContinuousTimeMode, Reads),
            Action::Log { on, categories } => self.log(who, on, &categories),
            Action::GetReal { variables, more } => self.get_real(who, &variables, more),
            Action::SetReal { pairs, more } => self.set_real(who, &pairs, more),
            Action::GetWhole(kind, variables) => self.get_whole(who, kind, &variables),
            Action::SetWhole(kind, pairs) => self.set_whole(who, kind, &pairs),
            Action::Unused { which, variables } => self.unused(who, which, &variables),
            Action::GetSlopes { pairs, more } => self.get_slopes(who, &pairs, more),
            Action::Direction { is_adjoint, unknowns, knowns, more } => {
                self.direction(who, is_adjoint, &unknowns, &knowns, more);
            }
            Action::Step { at, length, within } => self.step(who, at.of(self.0.time(who)), length.length(), within),
            Action::UpdateDiscreteStates => self.update_discrete_states(who),
            Action::CompletedIntegratorStep => self.completed_integrator_step(who),
            Action::SetTime(at) => self.0.set_time(who, at.of(self.0.time(who))),
            Action::SetStates { more, numbers } => self.0.set_states(who, more, &numbers),
            Action::GetArray { which, more } => self.0.get_array(who, which, more),
            Action::Numbers => self.numbers(who),
            Action::Save(at) => self.0.save(who, slot(at)),
            Action::Restore(at) => self.0.restore(who, slot(at)),
            Action::Free(at) => self.0.free(who, slot(at)),
            Action::Serialize { slot: at, spare } => self.0.serialize(who, slot(at), spare),
            Action::Deserialize { slot: at, damage } => self.0.deserialize(who, slot(at), damage),
            Action::Null(which) => self.call_with_null(who, which),
            Action::Instantiate { kind, token, name, required } => instantiate(kind, token, name, |of| required.of(of)),
            Action::Replay { steps, length, elsewhere } => {
                self.0.replay(who, 1 + steps % 4, length.length(), elsewhere)
            }
        }
    }

    /// Brings the instance into a state in the usual way.
    fn lead(&mut self, who: usize, to: State) {
        self.act(who, Action::Reset);
        match to {
            State::Instantiated => return,
            State::ConfigurationMode => return self.act(who, Action::EnterConfiguration),
            _ => self.begin(who, None, Number::Start, None),
        }
        if to == State::InitializationMode {
            return;
        }
        self.act(who, Action::ExitInitialization);
        match to {
            State::ContinuousTimeMode => self.act(who, Action::EnterContinuousTimeMode),
            State::StepMode if self.0.state(who) == State::EventMode => self.act(who, Action::EnterStepMode),
            State::Terminated => self.act(who, Action::Terminate),
            State::Error => self.act(who, Action::ExitConfiguration),
            _ => {}
        }
    }

    fn begin(&mut self, who: usize, tolerance: Option<Number>, start: Number, stop: Option<Number>) {
        let number = |number: Option<Number>| number.map_or(0.0, Number::alone);
        let (given, ends) = (tolerance.is_some().into(), stop.is_some().into());
        let (tolerance, start, stop) = (number(tolerance), start.alone(), number(stop));
        let c = self.0.slaves[who].c;
        // SAFETY: a live instance.
        let status = unsafe { fmi3EnterInitializationMode(c, given, tolerance, start, ends, stop) };
        self.0.made(who, Call::EnterInitializationMode, status, Changes);
        assert!(status != fmi3OK || self.0.time(who) == start);
    }

    fn log(&mut self, who: usize, on: bool, categories: &[u8]) {
        const CATEGORIES: [&CStr; 6] =
            [c"logStatusWarning", c"logStatusDiscard", c"logStatusError", c"logAll", c"100%s", c""];
        let texts: Vec<_> =
            categories.iter().map(|which| CATEGORIES[usize::from(*which) % CATEGORIES.len()].as_ptr()).collect();
        // SAFETY: a live instance and as many texts as given.
        let status = unsafe { fmi3SetDebugLogging(self.0.slaves[who].c, on.into(), texts.len(), texts.as_ptr()) };
        self.0.made(who, Call::SetDebugLogging, status, Reads);
    }

    /// The value references of variables.
    fn references(&self, who: usize, variables: impl IntoIterator<Item = Known>) -> Vec<u32> {
        let model = self.0.slaves[who].model;
        variables.into_iter().take(MOST_ARGUMENTS).map(|known| known.of(model)).collect()
    }

    /// Number of elements of a variable.
    fn count(&self, who: usize, reference: u32) -> usize {
        count(self.0.slaves[who].model, &self.0.seen[who], reference)
    }

    /// Number of elements of all of them.
    fn counts(&self, who: usize, references: &[u32]) -> usize {
        references.iter().map(|reference| self.count(who, *reference)).sum()
    }

    /// The columns of variables.
    fn columns(&self, who: usize, references: &[u32]) -> Vec<usize> {
        let (model, numbers) = (self.0.slaves[who].model, &self.0.seen[who]);
        references.iter().flat_map(|reference| columns(model, numbers, *reference).unwrap_or_default()).collect()
    }

    fn get_real(&mut self, who: usize, variables: &[Known], more: i8) {
        let references = self.references(who, variables.iter().copied());
        let right = self.counts(who, &references);
        let mut values = vec![f64::NAN; length(right, more)];
        let (c, n) = (self.0.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of these lengths.
        let status = unsafe { fmi3GetFloat64(c, references.as_ptr(), n, values.as_mut_ptr(), values.len()) };
        assert!(status != fmi3OK || all_finite(&values), "{references:?}: {values:?}");
        assert!(status != fmi3OK || values.len() == right, "{} values of {references:?}", values.len());
        self.0.made(who, Call::GetFloat64, status, Reads);
    }

    fn set_real(&mut self, who: usize, pairs: &[(Known, Number)], more: i8) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let mut values = Vec::new();
        for (reference, pair) in references.iter().zip(pairs) {
            // Elements of an array have the bounds of the first one.
            let first = self.columns(who, &[*reference]).first().copied();
            let variable = first.map(|column| self.0.slaves[who].model.table.at(column));
            let value = variable.map_or_else(|| pair.1.alone(), |variable| pair.1.of(&variable));
            values.extend(std::iter::repeat_n(value, self.count(who, *reference)));
        }
        let right = values.len();
        values.resize(length(right, more), 0.0);
        let (c, n) = (self.0.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of these lengths.
        let status = unsafe { fmi3SetFloat64(c, references.as_ptr(), n, values.as_ptr(), values.len()) };
        self.0.made(who, Call::SetFloat64, status, Changes);
        if status == fmi3OK {
            self.0.check_set(who, &self.columns(who, &references), &values);
        }
    }

    fn get_whole(&mut self, who: usize, kind: Whole, variables: &[Known]) {
        let references = self.references(who, variables.iter().copied());
        let (c, n, right) = (self.0.slaves[who].c, references.len(), self.counts(who, &references));
        let at = references.as_ptr();
        macro_rules! get {
            ($get:ident, $Value:ty) => {{
                let mut values = vec![<$Value>::MAX; right];
                let status = $get(c, at, n, values.as_mut_ptr(), right);
                (status, values.into_iter().map(|value| value as f64).collect::<Vec<f64>>())
            }};
        }
        // SAFETY: a live instance, and arrays of these lengths.
        let ((status, values), call) = unsafe {
            match kind {
                Whole::Int32 => (get!(fmi3GetInt32, i32), Call::GetInt32),
                Whole::Int64 => (get!(fmi3GetInt64, i64), Call::GetInt64),
                Whole::UInt64 => (get!(fmi3GetUInt64, u64), Call::GetUInt64),
                Whole::Boolean => (get!(fmi3GetBoolean, u8), Call::GetBoolean),
            }
        };
        self.0.made(who, call, status, Reads);
        if status == fmi3OK && !matches!(kind, Whole::UInt64) {
            let columns = self.columns(who, &references);
            assert_eq!(columns.len(), values.len());
            for (column, value) in columns.iter().zip(values) {
                assert_eq!(value, self.0.seen[who][ROW + column]);
            }
        }
    }

    fn set_whole(&mut self, who: usize, kind: Whole, pairs: &[(Known, i32)]) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let (c, n, at) = (self.0.slaves[who].c, references.len(), references.as_ptr());
        let numbers = references.iter().zip(pairs);
        let values: Vec<i32> =
            numbers.flat_map(|(reference, pair)| std::iter::repeat_n(pair.1, self.count(who, *reference))).collect();
        macro_rules! set {
            ($set:ident, $Value:ty) => {{
                let values: Vec<$Value> = values.iter().map(|value| *value as $Value).collect();
                let status = $set(c, at, n, values.as_ptr(), values.len());
                (status, values.into_iter().map(|value| value as f64).collect::<Vec<f64>>())
            }};
        }
        // SAFETY: a live instance, and arrays of these lengths.
        let ((status, values), call) = unsafe {
            match kind {
                Whole::Int32 => (set!(fmi3SetInt32, i32), Call::SetInt32),
                Whole::Int64 => (set!(fmi3SetInt64, i64), Call::SetInt64),
                Whole::UInt64 => (set!(fmi3SetUInt64, u64), Call::SetUInt64),
                Whole::Boolean => (set!(fmi3SetBoolean, u8), Call::SetBoolean),
            }
        };
        self.0.made(who, call, status, Changes);
        if status == fmi3OK && !matches!(kind, Whole::UInt64) {
            self.0.check_set(who, &self.columns(who, &references), &values);
        }
    }

    /// Functions of types that no model has, and of clocks: they succeed without variables only.
    fn unused(&mut self, who: usize, which: u8, variables: &[Known]) {
        let references = self.references(who, variables.iter().copied());
        let (c, n, at) = (self.0.slaves[who].c, references.len(), references.as_ptr());
        let (mut bytes, mut sizes, mut count) = ([0u64; MOST_ARGUMENTS], [0usize; MOST_ARGUMENTS], 7);
        let (to, real) = (bytes.as_mut_ptr(), bytes.as_mut_ptr().cast::<f64>());
        // SAFETY: a live instance, and arrays with at least as many elements as there can be.
        let (call, status) = unsafe {
            match which % 12 {
                0 => (Call::GetFloat32, fmi3GetFloat32(c, at, n, to.cast(), n)),
                1 => (Call::SetFloat32, fmi3SetFloat32(c, at, n, to.cast(), n)),
                2 => (Call::GetInt8, fmi3GetInt8(c, at, n, to.cast(), n)),
                3 => (Call::SetUInt16, fmi3SetUInt16(c, at, n, to.cast(), n)),
                4 => (Call::GetUInt32, fmi3GetUInt32(c, at, n, to.cast(), n)),
                5 => (Call::SetString, fmi3SetString(c, at, n, [c"text".as_ptr(); MOST_ARGUMENTS].as_ptr(), n)),
                6 => (Call::GetBinary, fmi3GetBinary(c, at, n, sizes.as_mut_ptr(), to.cast(), n)),
                7 => (Call::GetClock, fmi3GetClock(c, at, n, to.cast())),
                8 => (Call::GetShiftDecimal, fmi3GetShiftDecimal(c, at, n, real)),
                9 => (Call::SetIntervalDecimal, fmi3SetIntervalDecimal(c, at, n, real)),
                10 => (Call::ActivateModelPartition, fmi3ActivateModelPartition(c, 0, 0.0)),
                _ => {
                    let call = Call::GetNumberOfVariableDependencies;
                    (call, fmi3GetNumberOfVariableDependencies(c, references.first().copied().unwrap_or(1), &mut count))
                }
            }
        };
        assert!(status == fmi3Error || (n == 0 && status == fmi3OK), "{call:?}: {references:?}");
        self.0.made(who, call, status, Reads);
    }

    fn get_slopes(&mut self, who: usize, pairs: &[(Known, i8)], more: i8) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let orders: Vec<i32> = pairs.iter().map(|pair| pair.1.into()).take(references.len()).collect();
        let mut values = vec![f64::NAN; length(self.counts(who, &references), more)];
        let (c, at, n) = (self.0.slaves[who].c, references.as_ptr(), references.len());
        // SAFETY: a live instance, and arrays of these lengths.
        let status = unsafe { fmi3GetOutputDerivatives(c, at, n, orders.as_ptr(), values.as_mut_ptr(), values.len()) };
        assert!(status != fmi3OK || all_finite(&values), "{references:?}: {values:?}");
        self.0.made(who, Call::GetOutputDerivatives, status, Reads);
    }

    fn direction(&mut self, who: usize, is_adjoint: bool, unknowns: &[Known], knowns: &[(Known, Number)], more: i8) {
        let unknown = self.references(who, unknowns.iter().copied());
        let known = self.references(who, knowns.iter().map(|known| known.0));
        let counts = [self.counts(who, &unknown), self.counts(who, &known)];
        let [seeds, sensitivities] = if is_adjoint { counts } else { [counts[1], counts[0]] };
        let numbers = knowns.iter().map(|known| known.1.alone()).chain(std::iter::repeat(1.0));
        let seed: Vec<f64> = numbers.take(seeds).collect();
        let mut values = vec![f64::NAN; length(sensitivities, more)];
        let (c, of, by, to) = (self.0.slaves[who].c, unknown.as_ptr(), known.as_ptr(), values.as_mut_ptr());
        let (call, function) = match is_adjoint {
            false => (Call::GetDirectionalDerivative, fmi3GetDirectionalDerivative as Derivative),
            true => (Call::GetAdjointDerivative, fmi3GetAdjointDerivative as Derivative),
        };
        // SAFETY: a live instance, and arrays of these lengths.
        let status = unsafe { function(c, of, unknown.len(), by, known.len(), seed.as_ptr(), seeds, to, values.len()) };
        assert!(status != fmi3OK || all_finite(&values), "{unknowns:?}: {values:?}");
        self.0.made(who, call, status, Reads);
    }

    fn step(&mut self, who: usize, at: f64, length: f64, within: Within) {
        let slave = &self.0.slaves[who];
        let (choice, callback) = (slave.choice, &slave.ears.callbacks);
        callback.within.set(within);
        callback.visits.set(0);
        let ([mut event, mut end, mut early], mut reached) = ([9; 3], f64::NAN);
        // SAFETY: a live instance, and places for the answers.
        let status = unsafe { fmi3DoStep(slave.c, at, length, 1, &mut event, &mut end, &mut early, &mut reached) };
        let visits = callback.visits.get();
        self.0.made(who, Call::DoStep, status, Changes);
        if status != fmi3OK {
            return;
        }
        assert!(length > 0.0 && length < f64::INFINITY, "a step of {length} s");
        assert!(event <= u8::from(choice.event_mode) && end == 0 && early <= u8::from(choice.early_return));
        assert_eq!(self.0.time(who), reached);
        assert!((early == 1) == (reached < at + length) && reached <= at + length && reached >= at);
        assert!((visits > 0) == choice.callback, "{visits} visits");
    }

    fn update_discrete_states(&mut self, who: usize) {
        let ([mut more, mut end, mut nominals, mut values, mut is_known], mut time) = ([7; 5], f64::NAN);
        let c = self.0.slaves[who].c;
        // SAFETY: a live instance, and places for the answers.
        let status = unsafe {
            fmi3UpdateDiscreteStates(c, &mut more, &mut end, &mut nominals, &mut values, &mut is_known, &mut time)
        };
        assert!(status != fmi3OK || ([more, end, nominals, is_known], time) == ([0; 4], 0.0));
        assert!(values == 0 || status != fmi3OK || self.0.slaves[who].purpose == Purpose::ModelExchange);
        self.0.made(who, Call::UpdateDiscreteStates, status, Changes);
    }

    fn completed_integrator_step(&mut self, who: usize) {
        let (mut event, mut end) = (7, 7);
        // SAFETY: a live instance and two places for the answers.
        let status = unsafe { fmi3CompletedIntegratorStep(self.0.slaves[who].c, 1, &mut event, &mut end) };
        assert!(status != fmi3OK || (event <= 1 && end == 0));
        self.0.made(who, Call::CompletedIntegratorStep, status, Reads);
    }

    /// Numbers of states and of event indicators.
    fn numbers(&mut self, who: usize) {
        let model = self.0.slaves[who].model;
        for (call, function, wanted) in [
            (
                Call::GetNumberOfContinuousStates,
                fmi3GetNumberOfContinuousStates as unsafe extern "C-unwind" fn(fmi3Instance, *mut usize) -> fmi3Status,
                model.continuous_states().count(),
            ),
            (Call::GetNumberOfEventIndicators, fmi3GetNumberOfEventIndicators, model.event_indicators),
        ] {
            let mut found = usize::MAX;
            // SAFETY: a live instance and a place for the answer.
            let status = unsafe { function(self.0.slaves[who].c, &mut found) };
            assert!(status != fmi3OK || found == wanted);
            self.0.made(who, call, status, Reads);
        }
    }

    /// A call with a NULL where there must be none.
    fn call_with_null(&mut self, who: usize, which: u8) {
        let (call, status) = with_null(&self.0.slaves[who], which);
        assert_eq!(Answer::from(status), Answer::Error, "fmi3{call:?} with NULL, {which}");
        if !which.is_multiple_of(misuse3::CALLS) {
            self.0.made(who, call, status, Reads);
        }
    }
}

type Derivative = unsafe extern "C-unwind" fn(
    fmi3Instance,
    *const u32,
    usize,
    *const u32,
    usize,
    *const f64,
    usize,
    *mut f64,
    usize,
) -> fmi3Status;
