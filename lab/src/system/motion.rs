//! Equations of motion of a system whose parts all support Model Exchange.

use stribeck::model::ModelType;
use stribeck::number::Dual;

use super::order::{Task, tasks};
use super::part::{System, WireSource};
use super::{Fault, Place, Signal};
use crate::solve::Equations;

/// A part under way.
struct Mover {
    model: &'static ModelType,
    row: Vec<f64>,
    rate: Vec<f64>,
    dual: Vec<Dual>,
    dual_rate: Vec<Dual>,
    name: String,
    /// Whether one of its states is integrated.
    moves: bool,
}

/// The equations of motion of a system.
pub struct Motion {
    movers: Vec<Mover>,
    states: Vec<Place>,
    scales: Vec<f64>,
    tasks: Vec<Task>,
    signals: Vec<(Place, Signal)>,
    moving_signals: bool,
    recorded: Vec<WireSource>,
}

/// Largest number of times that events are passed from part to part at one instant (chosen).
const PASSES: usize = 8;

impl Motion {
    /// The equations of a system, for results that are to be recorded. None of the parts may be for co-simulation only.
    pub fn new(system: &System, recorded: &[WireSource]) -> Result<Motion, Fault> {
        for part in &system.parts {
            if !part.model.model_exchange {
                let text = format_args!("{} ({}) has no rates: it is for steps only", part.name, part.model.name);
                return Err(Fault::value(text));
            }
            part.model
                .check_model_exchange(&part.row)
                .map_err(|fault| Fault::value(format_args!("{}: {}", part.name, fault.0)))?;
        }
        let tasks = tasks(system)?;
        let states = states(system, recorded);
        let scales = states.iter().map(|place| system.variable(*place).nominal).collect();
        let movers = system.parts.iter().enumerate().map(|(number, part)| {
            let zero = vec![Dual::default(); part.row.len()];
            Mover {
                model: part.model,
                rate: vec![0.0; part.row.len()],
                row: part.row.clone(),
                dual: zero.clone(),
                dual_rate: zero,
                name: part.name.clone(),
                moves: states.iter().any(|place| place.part == number),
            }
        });
        let moving_signals = system.signals.iter().any(|(_, signal)| !matches!(signal, Signal::Constant(_)));
        let mut motion = Motion {
            movers: movers.collect(),
            states,
            scales,
            tasks,
            signals: system.signals.clone(),
            moving_signals,
            recorded: recorded.to_vec(),
        };
        motion.spread();
        Ok(motion)
    }

    /// Records these results and no others.
    pub fn record_only(&mut self, recorded: Vec<WireSource>) {
        self.recorded = recorded;
    }

    /// The states at the start.
    pub fn start(&self) -> Vec<f64> {
        self.states.iter().map(|place| self.movers[place.part].row[place.column]).collect()
    }

    /// The variables that are states.
    pub fn places(&self) -> &[Place] {
        &self.states
    }

    /// All inputs at a time, for given states.
    fn put(&mut self, time: f64, states: &[f64]) {
        for (place, value) in self.states.iter().zip(states) {
            self.movers[place.part].row[place.column] = *value;
        }
        if self.moving_signals {
            for (place, signal) in &self.signals {
                self.movers[place.part].row[place.column] = signal.at(time).0;
            }
        }
        for task in &self.tasks {
            match task {
                Task::Output(part) => {
                    let mover = &mut self.movers[*part];
                    mover.model.output(&mut mover.row);
                }
                Task::Pass { from, to } => {
                    self.movers[to.part].row[to.column] = self.movers[from.part].row[from.column];
                }
            }
        }
    }

    /// The rows as dual numbers.
    fn spread(&mut self) {
        for mover in &mut self.movers {
            for (dual, value) in mover.dual.iter_mut().zip(&mover.row) {
                *dual = Dual::from(*value);
            }
        }
    }

    /// Derivatives of the rates, with the slopes that states and signals have.
    fn derive(&mut self, mut put: impl FnMut(usize, f64)) {
        for task in &self.tasks {
            match task {
                Task::Output(part) => {
                    let mover = &mut self.movers[*part];
                    mover.model.output_dual(&mut mover.dual);
                }
                Task::Pass { from, to } => {
                    self.movers[to.part].dual[to.column] = self.movers[from.part].dual[from.column];
                }
            }
        }
        for mover in self.movers.iter_mut().filter(|mover| mover.moves) {
            mover.model.rate_dual(&mover.dual, &mut mover.dual_rate);
        }
        for (number, place) in self.states.iter().enumerate() {
            put(number, self.movers[place.part].dual_rate[place.column].slope);
        }
    }

    fn find_rates(&mut self) {
        for mover in self.movers.iter_mut().filter(|mover| mover.moves) {
            mover.model.rate(&mover.row, &mut mover.rate);
        }
    }

    fn outputs(&mut self) -> Result<(), String> {
        for mover in &mut self.movers {
            if !mover.model.output(&mut mover.row) {
                return Err(format!("an output of {} is not finite", mover.name));
            }
        }
        Ok(())
    }
}

/// The continuous states that matter: energies that nobody reads need not be integrated.
fn states(system: &System, recorded: &[WireSource]) -> Vec<Place> {
    let sources: Vec<WireSource> = system.wires.iter().map(|wire| wire.from).chain(recorded.iter().copied()).collect();
    let is_read = |place: Place| {
        sources.contains(&WireSource::Variable(place)) || sources.contains(&WireSource::Derivative(place))
    };
    let (mut states, mut unread) = (Vec::new(), Vec::new());
    for (part, made) in system.parts.iter().enumerate() {
        for column in made.model.continuous_states() {
            let place = Place { part, column };
            let last = made.model.table.at(column).path.segments().last().map_or("", |segment| segment.name);
            if last != "dissipated_energy" || is_read(place) {
                states.push(place);
            } else {
                unread.push(place);
            }
        }
    }
    // A motion that is given has no other state.
    if states.is_empty() { unread } else { states }
}

impl Equations for Motion {
    fn states(&self) -> usize {
        self.states.len()
    }

    fn state_name(&self, state: usize) -> String {
        let Place { part, column } = self.states[state];
        let mover = &self.movers[part];
        format!("{}.{}", mover.name, mover.model.table.at(column).path)
    }

    fn scales(&self) -> &[f64] {
        &self.scales
    }

    fn rates(&mut self, time: f64, states: &[f64], rates: &mut [f64]) {
        self.put(time, states);
        self.find_rates();
        for (rate, place) in rates.iter_mut().zip(&self.states) {
            *rate = self.movers[place.part].rate[place.column];
        }
    }

    fn jacobian(&mut self, time: f64, states: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        self.put(time, states);
        self.spread();
        let count = self.states.len();
        for column in 0..count {
            let Place { part, column: at } = self.states[column];
            self.movers[part].dual[at].slope = 1.0;
            self.derive(|row, slope| jacobian[row * count + column] = slope);
            self.movers[part].dual[at].slope = 0.0;
        }
        by_time.fill(0.0);
        if self.moving_signals {
            for (place, signal) in &self.signals {
                self.movers[place.part].dual[place.column].slope = signal.at(time).1;
            }
            self.derive(|row, slope| by_time[row] = slope);
        }
    }

    fn indicators(&self) -> usize {
        self.movers.iter().map(|mover| mover.model.event_indicators).sum()
    }

    fn indicator_name(&self, indicator: usize) -> String {
        let mut before = 0;
        for mover in &self.movers {
            if indicator < before + mover.model.event_indicators {
                return mover.name.clone();
            }
            before += mover.model.event_indicators;
        }
        String::new()
    }

    fn indicate(&mut self, time: f64, states: &[f64], indicators: &mut [f64]) {
        self.put(time, states);
        let mut rest = indicators;
        for mover in &self.movers {
            let (own, others) = rest.split_at_mut(mover.model.event_indicators);
            mover.model.indicate(&mover.row, own);
            rest = others;
        }
    }

    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String> {
        for _ in 0..PASSES {
            self.put(time, states);
            let before: Vec<Vec<f64>> = self.movers.iter().map(|mover| mover.row.clone()).collect();
            for mover in &mut self.movers {
                if !mover.model.at_event(&mut mover.row) {
                    return Err(format!("the states of {} after an event are not finite", mover.name));
                }
            }
            for (value, place) in states.iter_mut().zip(&self.states) {
                *value = self.movers[place.part].row[place.column];
            }
            if self.movers.iter().zip(&before).all(|(mover, before)| mover.row == *before) {
                break;
            }
        }
        Ok(())
    }

    fn next_break(&self, time: f64) -> f64 {
        self.signals.iter().map(|(_, signal)| signal.next_break(time)).fold(f64::INFINITY, f64::min)
    }

    fn recorded(&self) -> usize {
        self.recorded.len()
    }

    fn record(&mut self, time: f64, states: &[f64], values: &mut [f64]) -> Result<(), String> {
        self.put(time, states);
        self.outputs()?;
        self.find_rates();
        for (value, source) in values.iter_mut().zip(&self.recorded) {
            *value = match source {
                WireSource::Variable(place) => self.movers[place.part].row[place.column],
                WireSource::Derivative(place) => self.movers[place.part].rate[place.column],
            };
        }
        Ok(())
    }
}
