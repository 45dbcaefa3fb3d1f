//! Sequences of calls of FMI 2.0 on two instances, for co-simulation and for Model Exchange, of any model.
#![no_main]

use std::ffi::CStr;
use std::ptr::null;

use arbitrary::Arbitrary;
use fuzz::argument::{Column, Instant, Number, Step, column, model};
use fuzz::fmi2::Fmi2;
use fuzz::misuse::{instantiate, with_null};
use fuzz::saved::ROW;
use fuzz::slave::all_finite;
use fuzz::version::Answer;
use fuzz::world::Effect::{Changes, Reads};
use fuzz::world::{MOST_ACTIONS, SLOTS, World};
use libfuzzer_sys::fuzz_target;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Call, STATES, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

fuzz_target!(|scenario: Scenario| Play::new(&scenario).all(scenario.actions));

#[derive(Arbitrary, Debug)]
struct Scenario {
    model: u8,
    /// Another model for the second instance.
    other: Option<u8>,
    exchange: [bool; 2],
    actions: Vec<(bool, Action)>,
}

#[derive(Arbitrary, Debug)]
enum Action {
    /// The calls that usually lead to a state.
    Lead(u8),
    Setup {
        tolerance: Option<Number>,
        start: Number,
        stop: Option<Number>,
    },
    EnterInitialization,
    ExitInitialization,
    Terminate,
    Reset,
    Log {
        on: bool,
        categories: Vec<u8>,
    },
    GetReal(Vec<Column>),
    GetInteger(Vec<Column>),
    GetBoolean(Vec<Column>),
    GetString(Vec<Column>),
    SetReal(Vec<(Column, Number)>),
    SetInteger(Vec<(Column, i32)>),
    SetBoolean(Vec<(Column, i32)>),
    SetString(Vec<Column>),
    SetSlopes(Vec<(Column, i8, Number)>),
    GetSlopes(Vec<(Column, i8)>),
    Direction {
        unknowns: Vec<Column>,
        knowns: Vec<(Column, Number)>,
    },
    Step {
        at: Instant,
        length: Step,
    },
    Cancel,
    Status {
        which: u8,
        kind: i8,
    },
    EnterEventMode,
    NewDiscreteStates,
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
        kind: i8,
        guid: Option<u8>,
        name: u8,
        callbacks: bool,
    },
    Replay {
        steps: u8,
        length: Step,
        elsewhere: bool,
    },
}

/// Two instances and what is done with them.
struct Play(World<Fmi2>);

impl Play {
    fn new(scenario: &Scenario) -> Play {
        let first = model(scenario.model);
        Play(World::new([first, scenario.other.map_or(first, model)], scenario.exchange, [(); 2]))
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
            Action::Setup { tolerance, start, stop } => self.set_up(who, tolerance, start, stop),
            Action::EnterInitialization => plain(Call::EnterInitializationMode, fmi2EnterInitializationMode, Reads),
            Action::ExitInitialization => plain(Call::ExitInitializationMode, fmi2ExitInitializationMode, Changes),
            Action::Terminate => plain(Call::Terminate, fmi2Terminate, Reads),
            Action::Reset => plain(Call::Reset, fmi2Reset, Changes),
            Action::Cancel => assert_eq!(self.0.plain(who, Call::CancelStep, fmi2CancelStep, Reads), Answer::Error),
            Action::EnterEventMode => plain(Call::EnterEventMode, fmi2EnterEventMode, Reads),
            Action::EnterContinuousTimeMode => plain(Call::EnterContinuousTimeMode, fmi2EnterContinuousTimeMode, Reads),
            Action::Log { on, categories } => self.log(who, on, &categories),
            Action::GetReal(columns) => self.get_real(who, &columns),
            Action::GetInteger(columns) => self.get_whole(who, &columns, Call::GetInteger),
            Action::GetBoolean(columns) => self.get_whole(who, &columns, Call::GetBoolean),
            Action::GetString(columns) => self.get_string(who, &columns),
            Action::SetReal(pairs) => self.set_real(who, &pairs),
            Action::SetInteger(pairs) => self.set_whole(who, &pairs, Call::SetInteger),
            Action::SetBoolean(pairs) => self.set_whole(who, &pairs, Call::SetBoolean),
            Action::SetString(columns) => self.set_string(who, &columns),
            Action::SetSlopes(triples) => self.set_slopes(who, &triples),
            Action::GetSlopes(pairs) => self.get_slopes(who, &pairs),
            Action::Direction { unknowns, knowns } => self.direction(who, &unknowns, &knowns),
            Action::Step { at, length } => self.step(who, at.of(self.0.time(who)), length.length()),
            Action::Status { which, kind } => self.ask(who, which, kind.into()),
            Action::NewDiscreteStates => self.new_discrete_states(who),
            Action::CompletedIntegratorStep => self.completed_integrator_step(who),
            Action::SetTime(at) => self.0.set_time(who, at.of(self.0.time(who))),
            Action::SetStates { more, numbers } => self.0.set_states(who, more, &numbers),
            Action::GetArray { which, more } => self.0.get_array(who, which, more),
            Action::Save(at) => self.0.save(who, slot(at)),
            Action::Restore(at) => self.0.restore(who, slot(at)),
            Action::Free(at) => self.0.free(who, slot(at)),
            Action::Serialize { slot: at, spare } => self.0.serialize(who, slot(at), spare),
            Action::Deserialize { slot: at, damage } => self.0.deserialize(who, slot(at), damage),
            Action::Null(which) => self.call_with_null(who, which),
            Action::Instantiate { kind, guid, name, callbacks } => instantiate(kind.into(), guid, name, callbacks),
            Action::Replay { steps, length, elsewhere } => {
                self.0.replay(who, 1 + steps % 4, length.length(), elsewhere)
            }
        }
    }

    /// Brings the instance into a state in the usual way.
    fn lead(&mut self, who: usize, to: State) {
        self.act(who, Action::Reset);
        if to == State::Instantiated {
            return;
        }
        self.set_up(who, None, Number::Start, None);
        self.act(who, Action::EnterInitialization);
        if to == State::Initialization {
            return;
        }
        self.act(who, Action::ExitInitialization);
        match to {
            State::ContinuousTimeMode => self.act(who, Action::EnterContinuousTimeMode),
            State::Terminated => self.act(who, Action::Terminate),
            State::Error => self.act(who, Action::Cancel),
            _ => {}
        }
    }

    fn set_up(&mut self, who: usize, tolerance: Option<Number>, start: Number, stop: Option<Number>) {
        let number = |number: Option<Number>| number.map_or(0.0, Number::alone);
        let (given, ends) = (tolerance.is_some().into(), stop.is_some().into());
        let (tolerance, start, stop) = (number(tolerance), start.alone(), number(stop));
        // SAFETY: a live instance.
        let status = unsafe { fmi2SetupExperiment(self.0.slaves[who].c, given, tolerance, start, ends, stop) };
        self.0.made(who, Call::SetupExperiment, status, Changes);
        assert!(status != fmi2OK || self.0.time(who) == start);
    }

    fn log(&mut self, who: usize, on: bool, categories: &[u8]) {
        const CATEGORIES: [&CStr; 6] =
            [c"logStatusWarning", c"logStatusDiscard", c"logStatusError", c"logAll", c"100%s", c""];
        let texts: Vec<_> =
            categories.iter().map(|which| CATEGORIES[usize::from(*which) % CATEGORIES.len()].as_ptr()).collect();
        // SAFETY: a live instance and as many texts as given.
        let status = unsafe { fmi2SetDebugLogging(self.0.slaves[who].c, on.into(), texts.len(), texts.as_ptr()) };
        self.0.made(who, Call::SetDebugLogging, status, Reads);
    }

    fn get_real(&mut self, who: usize, columns: &[Column]) {
        let references = self.0.references(who, columns.iter().copied());
        let mut values = vec![f64::NAN; references.len()];
        let c = self.0.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2GetReal(c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        assert!(status != fmi2OK || all_finite(&values), "{references:?}: {values:?}");
        self.0.made(who, Call::GetReal, status, Reads);
    }

    fn get_whole(&mut self, who: usize, columns: &[Column], call: Call) {
        let references = self.0.references(who, columns.iter().copied());
        let mut values = vec![i32::MIN; references.len()];
        let get = if call == Call::GetInteger { fmi2GetInteger } else { fmi2GetBoolean };
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { get(self.0.slaves[who].c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        self.0.made(who, call, status, Reads);
        if status == fmi2OK {
            for (reference, value) in references.iter().zip(values) {
                let column = column(self.0.slaves[who].model, *reference).expect("a column that was read");
                assert_eq!(f64::from(value), self.0.seen[who][ROW + column]);
            }
        }
    }

    fn get_string(&mut self, who: usize, columns: &[Column]) {
        let references = self.0.references(who, columns.iter().copied());
        let mut texts = vec![null(); references.len()];
        let c = self.0.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2GetString(c, references.as_ptr(), references.len(), texts.as_mut_ptr()) };
        self.0.made(who, Call::GetString, status, Reads);
    }

    fn set_string(&mut self, who: usize, columns: &[Column]) {
        let references = self.0.references(who, columns.iter().copied());
        let texts = vec![c"text".as_ptr(); references.len()];
        let c = self.0.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2SetString(c, references.as_ptr(), references.len(), texts.as_ptr()) };
        self.0.made(who, Call::SetString, status, Reads);
    }

    fn set_real(&mut self, who: usize, pairs: &[(Column, Number)]) {
        let references = self.0.references(who, pairs.iter().map(|pair| pair.0));
        let numbers = references.iter().zip(pairs);
        let values: Vec<f64> = numbers.map(|(reference, pair)| self.0.number(who, *reference, pair.1)).collect();
        // SAFETY: a live instance, and arrays of that length.
        let status =
            unsafe { fmi2SetReal(self.0.slaves[who].c, references.as_ptr(), references.len(), values.as_ptr()) };
        self.0.made(who, Call::SetReal, status, Changes);
        if status == fmi2OK {
            self.check_set(who, &references, &values);
        }
    }

    fn set_whole(&mut self, who: usize, pairs: &[(Column, i32)], call: Call) {
        let references = self.0.references(who, pairs.iter().map(|pair| pair.0));
        let values: Vec<i32> = pairs.iter().map(|pair| pair.1).take(references.len()).collect();
        let set = if call == Call::SetInteger { fmi2SetInteger } else { fmi2SetBoolean };
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { set(self.0.slaves[who].c, references.as_ptr(), references.len(), values.as_ptr()) };
        self.0.made(who, call, status, Changes);
        if status == fmi2OK {
            self.check_set(who, &references, &values.iter().map(|value| f64::from(*value)).collect::<Vec<_>>());
        }
    }

    fn check_set(&self, who: usize, references: &[u32], values: &[f64]) {
        let model = self.0.slaves[who].model;
        let columns: Vec<usize> =
            references.iter().map(|reference| column(model, *reference).expect("a column that was set")).collect();
        self.0.check_set(who, &columns, values);
    }

    fn set_slopes(&mut self, who: usize, triples: &[(Column, i8, Number)]) {
        let references = self.0.references(who, triples.iter().map(|triple| triple.0));
        let orders: Vec<i32> = triples.iter().map(|triple| triple.1.into()).take(references.len()).collect();
        let numbers = references.iter().zip(triples);
        let values: Vec<f64> = numbers.map(|(reference, triple)| self.0.number(who, *reference, triple.2)).collect();
        let (c, count) = (self.0.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of that length.
        let status =
            unsafe { fmi2SetRealInputDerivatives(c, references.as_ptr(), count, orders.as_ptr(), values.as_ptr()) };
        self.0.made(who, Call::SetRealInputDerivatives, status, Changes);
    }

    fn get_slopes(&mut self, who: usize, pairs: &[(Column, i8)]) {
        let references = self.0.references(who, pairs.iter().map(|pair| pair.0));
        let orders: Vec<i32> = pairs.iter().map(|pair| pair.1.into()).take(references.len()).collect();
        let mut values = vec![f64::NAN; references.len()];
        let (c, count) = (self.0.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe {
            fmi2GetRealOutputDerivatives(c, references.as_ptr(), count, orders.as_ptr(), values.as_mut_ptr())
        };
        assert!(status != fmi2OK || all_finite(&values), "{references:?}: {values:?}");
        self.0.made(who, Call::GetRealOutputDerivatives, status, Reads);
    }

    fn direction(&mut self, who: usize, unknowns: &[Column], knowns: &[(Column, Number)]) {
        let unknowns = self.0.references(who, unknowns.iter().copied());
        let references = self.0.references(who, knowns.iter().map(|known| known.0));
        let seed: Vec<f64> = knowns.iter().map(|known| known.1.alone()).take(references.len()).collect();
        let mut values = vec![f64::NAN; unknowns.len()];
        let (c, unknown, known) = (self.0.slaves[who].c, unknowns.as_ptr(), references.as_ptr());
        let (counts, result) = ([unknowns.len(), references.len()], values.as_mut_ptr());
        // SAFETY: a live instance, and arrays of these lengths.
        let status =
            unsafe { fmi2GetDirectionalDerivative(c, unknown, counts[0], known, counts[1], seed.as_ptr(), result) };
        assert!(status != fmi2OK || all_finite(&values), "{unknowns:?}: {values:?}");
        self.0.made(who, Call::GetDirectionalDerivative, status, Reads);
    }

    fn step(&mut self, who: usize, at: f64, length: f64) {
        // SAFETY: a live instance.
        let status = unsafe { fmi2DoStep(self.0.slaves[who].c, at, length, fmi2True) };
        self.0.made(who, Call::DoStep, status, Changes);
        if status == fmi2OK {
            assert!(length > 0.0 && length < f64::INFINITY, "a step of {length} s");
            assert_eq!(self.0.time(who), at + length);
        }
    }

    fn ask(&mut self, who: usize, which: u8, kind: fmi2StatusKind) {
        let c = self.0.slaves[who].c;
        let (mut status, mut real, mut whole, mut text) = (fmi2OK, f64::NAN, 7, null());
        // SAFETY: a live instance and a place for the answer.
        let (call, answer) = unsafe {
            match which % 5 {
                0 => (Call::GetStatus, fmi2GetStatus(c, kind, &mut status)),
                1 => (Call::GetRealStatus, fmi2GetRealStatus(c, kind, &mut real)),
                2 => (Call::GetIntegerStatus, fmi2GetIntegerStatus(c, kind, &mut whole)),
                3 => (Call::GetBooleanStatus, fmi2GetBooleanStatus(c, kind, &mut whole)),
                _ => (Call::GetStringStatus, fmi2GetStringStatus(c, kind, &mut text)),
            }
        };
        match (answer, call) {
            (fmi2OK, Call::GetRealStatus) => assert_eq!(real, self.0.time(who)),
            (fmi2OK, call) => assert!(call == Call::GetBooleanStatus && whole == fmi2False),
            _ => {}
        }
        self.0.made(who, call, answer, Reads);
    }

    fn new_discrete_states(&mut self, who: usize) {
        let mut event = fmi2EventInfo {
            newDiscreteStatesNeeded: 7,
            terminateSimulation: 7,
            nominalsOfContinuousStatesChanged: 7,
            valuesOfContinuousStatesChanged: 7,
            nextEventTimeDefined: 7,
            nextEventTime: f64::NAN,
        };
        // SAFETY: a live instance and a place for the answer.
        let status = unsafe { fmi2NewDiscreteStates(self.0.slaves[who].c, &mut event) };
        assert!(status != fmi2OK || (event.newDiscreteStatesNeeded, event.terminateSimulation) == (0, 0));
        self.0.made(who, Call::NewDiscreteStates, status, Changes);
    }

    fn completed_integrator_step(&mut self, who: usize) {
        let (mut event, mut end) = (7, 7);
        // SAFETY: a live instance and two places for the answers.
        let status = unsafe { fmi2CompletedIntegratorStep(self.0.slaves[who].c, fmi2True, &mut event, &mut end) };
        assert!(status != fmi2OK || (event, end) == (fmi2False, fmi2False));
        self.0.made(who, Call::CompletedIntegratorStep, status, Reads);
    }

    /// A call with a NULL where there must be none.
    fn call_with_null(&mut self, who: usize, which: u8) {
        let (call, status) = with_null(&self.0.slaves[who], which);
        assert_eq!(status, fmi2Error, "fmi2{call:?} with NULL, {which}");
        if !which.is_multiple_of(24) {
            self.0.made(who, call, status, Reads);
        }
    }
}
