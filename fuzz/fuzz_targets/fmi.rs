//! Sequences of calls of FMI 2.0 on two instances, for co-simulation and for Model Exchange, of any model.
#![no_main]

use std::ffi::CStr;
use std::ptr::{null, null_mut};

use arbitrary::Arbitrary;
use fuzz::argument::{Column, Instant, Number, Step, column, model, variable};
use fuzz::fmi::{Slave, all_finite, future, same_bits, state};
use fuzz::misuse::{instantiate, with_null};
use fuzz::saved::{self, ROW, TIME};
use libfuzzer_sys::fuzz_target;
use stribeck::model::ModelType;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Call, Purpose, STATES, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

fuzz_target!(|scenario: Scenario| World::new(&scenario).play(scenario.actions));

#[derive(Arbitrary, Debug)]
struct Scenario {
    model: u8,
    /// Another model for the second instance.
    other: Option<u8>,
    exchange: [bool; 2],
    actions: Vec<(bool, Action)>,
}

/// Steps with nonsensical numbers are expensive; longer sequences find nothing new.
const MOST_ACTIONS: usize = 48;
/// Arguments of one call.
const MOST_ARGUMENTS: usize = 12;
/// Saved states that are kept.
const SLOTS: usize = 3;

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

/// A saved state and its contents.
struct Saved {
    state: fmi2FMUstate,
    model: &'static ModelType,
    numbers: Vec<f64>,
}

struct World {
    slaves: [Slave; 2],
    /// Contents of the instances after the last call.
    seen: [Vec<f64>; 2],
    slots: [Option<Saved>; SLOTS],
    bytes: [Vec<u8>; SLOTS],
}

/// Effect of a successful call on the instance.
enum Effect {
    /// It only reads: at most the results are computed.
    Reads,
    /// It changes the instance.
    Changes,
}
use Effect::{Changes, Reads};

impl Drop for World {
    fn drop(&mut self) {
        for slot in 0..SLOTS {
            let Some(saved) = &mut self.slots[slot] else { continue };
            let owner = Slave::new(saved.model, false);
            // SAFETY: a live state, freed once.
            assert_eq!(unsafe { fmi2FreeFMUstate(owner.c, &mut saved.state) }, fmi2OK);
        }
    }
}

/// The state after a successful call.
fn next(call: Call, from: State, purpose: Purpose) -> State {
    match (call, purpose) {
        (Call::EnterInitializationMode, _) => State::Initialization,
        (Call::ExitInitializationMode, Purpose::CoSimulation) => State::StepComplete,
        (Call::ExitInitializationMode, Purpose::ModelExchange) | (Call::EnterEventMode, _) => State::EventMode,
        (Call::EnterContinuousTimeMode, _) => State::ContinuousTimeMode,
        (Call::Terminate, _) => State::Terminated,
        (Call::Reset, _) => State::Instantiated,
        _ => from,
    }
}

impl World {
    fn new(scenario: &Scenario) -> World {
        let first = model(scenario.model);
        let second = scenario.other.map_or(first, model);
        let slaves = [Slave::new(first, scenario.exchange[0]), Slave::new(second, scenario.exchange[1])];
        let seen = [0, 1].map(|who: usize| saved::numbers(&slaves[who].bytes()));
        World { slaves, seen, slots: Default::default(), bytes: Default::default() }
    }

    fn play(mut self, actions: Vec<(bool, Action)>) {
        for (who, action) in actions.into_iter().take(MOST_ACTIONS) {
            self.act(usize::from(who), action);
        }
    }

    fn state(&self, who: usize) -> State {
        state(&self.seen[who])
    }

    fn time(&self, who: usize) -> f64 {
        self.seen[who][TIME]
    }

    /// Checks the invariants after every call, and keeps the present contents.
    fn made(&mut self, who: usize, call: Call, status: fmi2Status, effect: Effect) {
        let slave = &self.slaves[who];
        let messages = slave.take_messages();
        let (before, after) = (&self.seen[who], saved::numbers(&slave.bytes()));
        let (from, to) = (state(before), state(&after));
        let context = || format!("fmi2{call:?} of {} in {from:?}: {status:?}, then {to:?}", slave.model.name);
        if !(call.is_allowed(from) && call.is_for(slave.purpose)) {
            assert_eq!(status, fmi2Error, "{}", context());
        }
        let expected = match status {
            // A restored state may be any; `restore` checks it.
            fmi2OK if call == Call::SetFMUstate => to,
            fmi2OK => next(call, from, slave.purpose),
            fmi2Discard => from,
            fmi2Error => State::Error,
            _ => panic!("{}", context()),
        };
        assert_eq!(to, expected, "{}", context());
        assert!(to.is_for(slave.purpose), "{}", context());
        assert!(messages <= u32::from(status != fmi2OK), "{messages} messages: {}", context());
        assert!(saved::is_finite(&after), "{}: {after:?}", context());
        let only_reads = matches!(effect, Reads);
        if status != fmi2OK || only_reads {
            assert!(saved::is_unchanged(slave.model, before, &after, !only_reads), "{}", context());
        }
        self.seen[who] = after;
        let (bystander, other) = (1 - who, saved::numbers(&self.slaves[1 - who].bytes()));
        assert!(same_bits(&self.seen[bystander], &other), "fmi2{call:?} has changed the other instance");
    }

    /// The value references of columns.
    fn references(&self, who: usize, columns: impl IntoIterator<Item = Column>) -> Vec<u32> {
        let model = self.slaves[who].model;
        columns.into_iter().take(MOST_ARGUMENTS).map(|column| column.of(model)).collect()
    }

    fn number(&self, who: usize, reference: u32, number: Number) -> f64 {
        let variable = variable(self.slaves[who].model, reference);
        variable.map_or_else(|| number.alone(), |variable| number.of(&variable))
    }

    fn act(&mut self, who: usize, action: Action) {
        let slot = |slot: u8| usize::from(slot) % SLOTS;
        let mut plain = |call, function, effect| self.plain(who, call, function, effect);
        match action {
            Action::Lead(to) => self.lead(who, STATES[usize::from(to) % STATES.len()]),
            Action::Setup { tolerance, start, stop } => self.set_up(who, tolerance, start, stop),
            Action::EnterInitialization => plain(Call::EnterInitializationMode, fmi2EnterInitializationMode, Reads),
            Action::ExitInitialization => plain(Call::ExitInitializationMode, fmi2ExitInitializationMode, Changes),
            Action::Terminate => plain(Call::Terminate, fmi2Terminate, Reads),
            Action::Reset => plain(Call::Reset, fmi2Reset, Changes),
            Action::Cancel => plain(Call::CancelStep, fmi2CancelStep, Reads),
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
            Action::Step { at, length } => self.step(who, at.of(self.time(who)), length.length()),
            Action::Status { which, kind } => self.ask(who, which, kind.into()),
            Action::NewDiscreteStates => self.new_discrete_states(who),
            Action::CompletedIntegratorStep => self.completed_integrator_step(who),
            Action::SetTime(at) => self.set_time(who, at.of(self.time(who))),
            Action::SetStates { more, numbers } => self.set_states(who, more, &numbers),
            Action::GetArray { which, more } => self.get_array(who, which, more),
            Action::Save(at) => self.save(who, slot(at)),
            Action::Restore(at) => self.restore(who, slot(at)),
            Action::Free(at) => self.free(who, slot(at)),
            Action::Serialize { slot: at, spare } => self.serialize(who, slot(at), spare),
            Action::Deserialize { slot: at, damage } => self.deserialize(who, slot(at), damage),
            Action::Null(which) => self.call_with_null(who, which),
            Action::Instantiate { kind, guid, name, callbacks } => instantiate(kind.into(), guid, name, callbacks),
            Action::Replay { steps, length, elsewhere } => self.replay(who, 1 + steps % 4, length.length(), elsewhere),
        }
    }

    /// A call without arguments.
    fn plain(
        &mut self,
        who: usize,
        call: Call,
        function: unsafe extern "C-unwind" fn(fmi2Component) -> fmi2Status,
        effect: Effect,
    ) {
        // SAFETY: a live instance.
        let status = unsafe { function(self.slaves[who].c) };
        assert!(call != Call::Reset || status == fmi2OK);
        assert!(call != Call::CancelStep || status == fmi2Error);
        self.made(who, call, status, effect);
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
        let status = unsafe { fmi2SetupExperiment(self.slaves[who].c, given, tolerance, start, ends, stop) };
        self.made(who, Call::SetupExperiment, status, Changes);
        assert!(status != fmi2OK || self.time(who) == start);
    }

    fn log(&mut self, who: usize, on: bool, categories: &[u8]) {
        const CATEGORIES: [&CStr; 6] =
            [c"logStatusWarning", c"logStatusDiscard", c"logStatusError", c"logAll", c"100%s", c""];
        let texts: Vec<_> =
            categories.iter().map(|which| CATEGORIES[usize::from(*which) % CATEGORIES.len()].as_ptr()).collect();
        // SAFETY: a live instance and as many texts as given.
        let status = unsafe { fmi2SetDebugLogging(self.slaves[who].c, on.into(), texts.len(), texts.as_ptr()) };
        self.made(who, Call::SetDebugLogging, status, Reads);
    }

    fn get_real(&mut self, who: usize, columns: &[Column]) {
        let references = self.references(who, columns.iter().copied());
        let mut values = vec![f64::NAN; references.len()];
        let c = self.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2GetReal(c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        assert!(status != fmi2OK || all_finite(&values), "{references:?}: {values:?}");
        self.made(who, Call::GetReal, status, Reads);
    }

    fn get_whole(&mut self, who: usize, columns: &[Column], call: Call) {
        let references = self.references(who, columns.iter().copied());
        let mut values = vec![i32::MIN; references.len()];
        let get = if call == Call::GetInteger { fmi2GetInteger } else { fmi2GetBoolean };
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { get(self.slaves[who].c, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        self.made(who, call, status, Reads);
        if status == fmi2OK {
            for (reference, value) in references.iter().zip(values) {
                let column = column(self.slaves[who].model, *reference).expect("a column that was read");
                assert_eq!(f64::from(value), self.seen[who][ROW + column]);
            }
        }
    }

    fn get_string(&mut self, who: usize, columns: &[Column]) {
        let references = self.references(who, columns.iter().copied());
        let mut texts = vec![null(); references.len()];
        let c = self.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2GetString(c, references.as_ptr(), references.len(), texts.as_mut_ptr()) };
        self.made(who, Call::GetString, status, Reads);
    }

    fn set_string(&mut self, who: usize, columns: &[Column]) {
        let references = self.references(who, columns.iter().copied());
        let texts = vec![c"text".as_ptr(); references.len()];
        let c = self.slaves[who].c;
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2SetString(c, references.as_ptr(), references.len(), texts.as_ptr()) };
        self.made(who, Call::SetString, status, Reads);
    }

    fn set_real(&mut self, who: usize, pairs: &[(Column, Number)]) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let numbers = references.iter().zip(pairs);
        let values: Vec<f64> = numbers.map(|(reference, pair)| self.number(who, *reference, pair.1)).collect();
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { fmi2SetReal(self.slaves[who].c, references.as_ptr(), references.len(), values.as_ptr()) };
        self.made(who, Call::SetReal, status, Changes);
        if status == fmi2OK {
            self.check_set(who, &references, &values);
        }
    }

    fn set_whole(&mut self, who: usize, pairs: &[(Column, i32)], call: Call) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let values: Vec<i32> = pairs.iter().map(|pair| pair.1).take(references.len()).collect();
        let set = if call == Call::SetInteger { fmi2SetInteger } else { fmi2SetBoolean };
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe { set(self.slaves[who].c, references.as_ptr(), references.len(), values.as_ptr()) };
        self.made(who, call, status, Changes);
        if status == fmi2OK {
            self.check_set(who, &references, &values.iter().map(|value| f64::from(*value)).collect::<Vec<_>>());
        }
    }

    /// Accepted values are within their bounds, and the last value of each column is stored.
    fn check_set(&self, who: usize, references: &[u32], values: &[f64]) {
        let model = self.slaves[who].model;
        for (place, (reference, value)) in references.iter().zip(values).enumerate() {
            let column = column(model, *reference).expect("a column that was set");
            assert!(model.table.at(column).admits(*value), "{reference} = {value}");
            if !references[place + 1..].contains(reference) {
                assert_eq!(self.seen[who][ROW + column].to_bits(), value.to_bits());
            }
        }
    }

    fn set_slopes(&mut self, who: usize, triples: &[(Column, i8, Number)]) {
        let references = self.references(who, triples.iter().map(|triple| triple.0));
        let orders: Vec<i32> = triples.iter().map(|triple| triple.1.into()).take(references.len()).collect();
        let numbers = references.iter().zip(triples);
        let values: Vec<f64> = numbers.map(|(reference, triple)| self.number(who, *reference, triple.2)).collect();
        let (c, count) = (self.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of that length.
        let status =
            unsafe { fmi2SetRealInputDerivatives(c, references.as_ptr(), count, orders.as_ptr(), values.as_ptr()) };
        self.made(who, Call::SetRealInputDerivatives, status, Changes);
    }

    fn get_slopes(&mut self, who: usize, pairs: &[(Column, i8)]) {
        let references = self.references(who, pairs.iter().map(|pair| pair.0));
        let orders: Vec<i32> = pairs.iter().map(|pair| pair.1.into()).take(references.len()).collect();
        let mut values = vec![f64::NAN; references.len()];
        let (c, count) = (self.slaves[who].c, references.len());
        // SAFETY: a live instance, and arrays of that length.
        let status = unsafe {
            fmi2GetRealOutputDerivatives(c, references.as_ptr(), count, orders.as_ptr(), values.as_mut_ptr())
        };
        assert!(status != fmi2OK || all_finite(&values), "{references:?}: {values:?}");
        self.made(who, Call::GetRealOutputDerivatives, status, Reads);
    }

    fn direction(&mut self, who: usize, unknowns: &[Column], knowns: &[(Column, Number)]) {
        let unknowns = self.references(who, unknowns.iter().copied());
        let references = self.references(who, knowns.iter().map(|known| known.0));
        let seed: Vec<f64> = knowns.iter().map(|known| known.1.alone()).take(references.len()).collect();
        let mut values = vec![f64::NAN; unknowns.len()];
        let (c, unknown, known) = (self.slaves[who].c, unknowns.as_ptr(), references.as_ptr());
        let (counts, result) = ([unknowns.len(), references.len()], values.as_mut_ptr());
        // SAFETY: a live instance, and arrays of these lengths.
        let status =
            unsafe { fmi2GetDirectionalDerivative(c, unknown, counts[0], known, counts[1], seed.as_ptr(), result) };
        assert!(status != fmi2OK || all_finite(&values), "{unknowns:?}: {values:?}");
        self.made(who, Call::GetDirectionalDerivative, status, Reads);
    }

    fn step(&mut self, who: usize, at: f64, length: f64) {
        // SAFETY: a live instance.
        let status = unsafe { fmi2DoStep(self.slaves[who].c, at, length, fmi2True) };
        self.made(who, Call::DoStep, status, Changes);
        if status == fmi2OK {
            assert!(length > 0.0 && length < f64::INFINITY, "a step of {length} s");
            assert_eq!(self.time(who), at + length);
        }
    }

    fn ask(&mut self, who: usize, which: u8, kind: fmi2StatusKind) {
        let c = self.slaves[who].c;
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
            (fmi2OK, Call::GetRealStatus) => assert_eq!(real, self.time(who)),
            (fmi2OK, call) => assert!(call == Call::GetBooleanStatus && whole == fmi2False),
            _ => {}
        }
        self.made(who, call, answer, Reads);
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
        let status = unsafe { fmi2NewDiscreteStates(self.slaves[who].c, &mut event) };
        assert!(status != fmi2OK || (event.newDiscreteStatesNeeded, event.terminateSimulation) == (0, 0));
        self.made(who, Call::NewDiscreteStates, status, Changes);
    }

    fn completed_integrator_step(&mut self, who: usize) {
        let (mut event, mut end) = (7, 7);
        // SAFETY: a live instance and two places for the answers.
        let status = unsafe { fmi2CompletedIntegratorStep(self.slaves[who].c, fmi2True, &mut event, &mut end) };
        assert!(status != fmi2OK || (event, end) == (fmi2False, fmi2False));
        self.made(who, Call::CompletedIntegratorStep, status, Reads);
    }

    fn set_time(&mut self, who: usize, time: f64) {
        // SAFETY: a live instance.
        let status = unsafe { fmi2SetTime(self.slaves[who].c, time) };
        self.made(who, Call::SetTime, status, Changes);
        assert!(status != fmi2OK || self.time(who) == time);
    }

    /// Columns of the continuous states, if the instance has them.
    fn states(&self, who: usize) -> Vec<usize> {
        let slave = &self.slaves[who];
        slave.model.continuous_states().filter(|_| slave.model.model_exchange).collect()
    }

    fn set_states(&mut self, who: usize, more: i8, numbers: &[Number]) {
        let columns = self.states(who);
        let count = length(columns.len(), more);
        let number = |place: usize| match (columns.get(place), numbers.get(place)) {
            (Some(column), Some(number)) => number.of(&self.slaves[who].model.table.at(*column)),
            (Some(column), None) => self.seen[who][ROW + column],
            _ => 0.0,
        };
        let values: Vec<f64> = (0..count).map(number).collect();
        // SAFETY: a live instance and an array of that length.
        let status = unsafe { fmi2SetContinuousStates(self.slaves[who].c, values.as_ptr(), count) };
        self.made(who, Call::SetContinuousStates, status, Changes);
        if status == fmi2OK {
            for (column, value) in columns.iter().zip(&values) {
                assert_eq!(self.seen[who][ROW + column].to_bits(), value.to_bits());
            }
        }
    }

    /// The arrays of Model Exchange.
    fn get_array(&mut self, who: usize, which: u8, more: i8) {
        let states = self.states(who).len();
        let (call, wanted, get): (_, _, unsafe extern "C-unwind" fn(fmi2Component, *mut f64, usize) -> fmi2Status) =
            match which % 4 {
                0 => (Call::GetDerivatives, states, fmi2GetDerivatives),
                1 => (Call::GetEventIndicators, self.slaves[who].model.event_indicators, fmi2GetEventIndicators),
                2 => (Call::GetContinuousStates, states, fmi2GetContinuousStates),
                _ => (Call::GetNominalsOfContinuousStates, states, fmi2GetNominalsOfContinuousStates),
            };
        let mut values = vec![f64::NAN; length(wanted, more)];
        // SAFETY: a live instance and an array of that length.
        let status = unsafe { get(self.slaves[who].c, values.as_mut_ptr(), values.len()) };
        assert!(status != fmi2OK || (values.len() == wanted && all_finite(&values)), "{values:?}");
        self.made(who, call, status, Reads);
    }

    fn save(&mut self, who: usize, slot: usize) {
        let slave = &self.slaves[who];
        let mut state = self.slots[slot].as_ref().map_or(null_mut(), |saved| saved.state);
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { fmi2GetFMUstate(slave.c, &mut state) };
        let is_taken = self.slots[slot].as_ref().is_some_and(|saved| saved.model != slave.model);
        assert_eq!(status, if is_taken { fmi2Error } else { fmi2OK });
        if status == fmi2OK {
            self.slots[slot] = Some(Saved { state, model: slave.model, numbers: self.seen[who].clone() });
        }
        self.made(who, Call::GetFMUstate, status, Reads);
    }

    fn restore(&mut self, who: usize, slot: usize) {
        let slave = &self.slaves[who];
        let saved = self.slots[slot].as_ref();
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { fmi2SetFMUstate(slave.c, saved.map_or(null_mut(), |saved| saved.state)) };
        let has_events = slave.purpose == Purpose::ModelExchange;
        let fits = |saved: &&Saved| {
            let is_kind = saved.model == slave.model && state(&saved.numbers).is_for(slave.purpose);
            is_kind && (has_events || !saved::needs_events(saved.model, &saved.numbers))
        };
        let fitting = saved.filter(fits).map(|saved| saved.numbers.clone());
        assert_eq!(status == fmi2OK, fitting.is_some());
        self.made(who, Call::SetFMUstate, status, Changes);
        if let Some(numbers) = fitting {
            assert!(same_bits(&numbers, &self.seen[who]), "the restored state differs from the saved one");
        }
    }

    fn free(&mut self, who: usize, slot: usize) {
        let slave = &self.slaves[who];
        let mut state = self.slots[slot].as_ref().map_or(null_mut(), |saved| saved.state);
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { fmi2FreeFMUstate(slave.c, &mut state) };
        let is_foreign = self.slots[slot].as_ref().is_some_and(|saved| saved.model != slave.model);
        assert_eq!(status == fmi2OK, !is_foreign);
        if status == fmi2OK {
            assert!(state.is_null());
            self.slots[slot] = None;
        }
        self.made(who, Call::FreeFMUstate, status, Reads);
    }

    /// Writes a saved state into a buffer that is `spare` bytes longer, or shorter, than it must be.
    fn serialize(&mut self, who: usize, slot: usize, spare: i8) {
        let slave = &self.slaves[who];
        let saved = self.slots[slot].as_ref().map_or(null_mut(), |saved| saved.state);
        let mut size = usize::MAX;
        // SAFETY: a live instance, and NULL or a live state.
        let status = unsafe { fmi2SerializedFMUstateSize(slave.c, saved, &mut size) };
        self.made(who, Call::SerializedFMUstateSize, status, Reads);
        if status != fmi2OK {
            return;
        }
        let mut bytes = vec![0x55u8; length(size, spare)];
        // SAFETY: a live instance, a live state, and a buffer of that length.
        let status =
            unsafe { fmi2SerializeFMUstate(self.slaves[who].c, saved, bytes.as_mut_ptr().cast(), bytes.len()) };
        assert_eq!(status == fmi2OK, bytes.len() >= size);
        if status == fmi2OK {
            assert!(bytes[size..].iter().all(|byte| *byte == 0x55), "written beyond the state");
            bytes.truncate(size);
            self.bytes[slot] = bytes;
        }
        self.made(who, Call::SerializeFMUstate, status, Reads);
    }

    fn deserialize(&mut self, who: usize, slot: usize, damage: Option<(u16, u8)>) {
        let mut bytes = self.bytes[slot].clone();
        if let Some((at, by)) = damage.filter(|_| !bytes.is_empty()) {
            let at = usize::from(at) % bytes.len();
            bytes[at] ^= by.max(1);
        }
        let model = self.slaves[who].model;
        let mut state = self.slots[slot].as_ref().map_or(null_mut(), |saved| saved.state);
        let is_taken = self.slots[slot].as_ref().is_some_and(|saved| saved.model != model);
        let is_sound = damage.is_none() && bytes.get(12..saved::HEAD) == Some(model.guid().as_bytes());
        let c = self.slaves[who].c;
        // SAFETY: a live instance, as many bytes as given, and NULL or a live state.
        let status = unsafe { fmi2DeSerializeFMUstate(c, bytes.as_ptr().cast(), bytes.len(), &mut state) };
        assert_eq!(status == fmi2OK, is_sound && !is_taken, "bytes of a saved state of {}", model.name);
        if status == fmi2OK {
            self.slots[slot] = Some(Saved { state, model, numbers: saved::numbers(&bytes) });
        }
        self.made(who, Call::DeSerializeFMUstate, status, Reads);
    }

    /// A call with a NULL where there must be none.
    fn call_with_null(&mut self, who: usize, which: u8) {
        let (call, status) = with_null(&self.slaves[who], which);
        assert_eq!(status, fmi2Error, "fmi2{call:?} with NULL, {which}");
        if !which.is_multiple_of(24) {
            self.made(who, call, status, Reads);
        }
    }

    /// Continues from the present, and then once more from a saved state, in this or in a new instance: the same bits.
    fn replay(&mut self, who: usize, steps: u8, length: f64, elsewhere: bool) {
        if !matches!(self.state(who), State::StepComplete | State::ContinuousTimeMode) {
            return;
        }
        let slave = &self.slaves[who];
        let bytes = slave.bytes();
        let future = future(slave, steps, length);
        if elsewhere {
            let other = Slave::new(slave.model, slave.purpose == Purpose::ModelExchange);
            other.read(&bytes);
            assert_eq!(self::future(&other, steps, length), future, "{} in another instance", slave.model.name);
        }
        slave.read(&bytes);
        assert_eq!(self::future(slave, steps, length), future, "{}", slave.model.name);
        slave.read(&bytes);
        slave.take_messages();
        assert!(same_bits(&saved::numbers(&slave.bytes()), &self.seen[who]), "not back in the saved state");
    }
}

/// A length, or one that differs from it.
fn length(right: usize, more: i8) -> usize {
    right.saturating_add_signed(more.into())
}
