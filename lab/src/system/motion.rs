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
    /// Columns that change from one evaluation to the next: integrated states and inputs with a source.
    changing: Vec<usize>,
    /// Computed outputs that are passed on.
    passed: Vec<usize>,
    /// Whether a column that changes has a slope.
    has_slope: bool,
}

impl Mover {
    /// Takes the values of all columns over.
    fn spread(&mut self) {
        for (dual, value) in self.dual.iter_mut().zip(&self.row) {
            *dual = Dual::from(*value);
        }
    }

    /// Takes the values of those columns over that have changed since [`Mover::spread`], outputs apart.
    fn spread_changing(&mut self) {
        for column in &self.changing {
            self.dual[*column] = Dual::from(self.row[*column]);
        }
        self.has_slope = false;
    }

    /// Computes the slopes of the outputs.
    fn output_slopes(&mut self) {
        if self.has_slope {
            self.model.output_dual(&mut self.dual);
        } else {
            self.passed.iter().for_each(|column| self.dual[*column].slope = 0.0);
        }
    }

    /// Gives a column a slope.
    fn incline(&mut self, column: usize, slope: f64) {
        self.dual[column].slope = slope;
        self.has_slope |= slope != 0.0;
    }
}

/// The equations of motion of a system.
pub struct Motion {
    movers: Vec<Mover>,
    states: Vec<Place>,
    scales: Vec<f64>,
    tasks: Vec<Task>,
    /// Those of them that event indicators need, which depend on inputs and states.
    tasks_of_indicators: Vec<Task>,
    signals: Vec<(Place, Signal)>,
    moving_signals: bool,
    recorded: Vec<WireSource>,
    /// Whether columns that are not [`Mover::changing`] may have changed since they were taken over as dual numbers.
    stale: bool,
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
                changing: changing(system, &states, number),
                passed: passed(system, number),
                has_slope: false,
            }
        });
        let moving_signals = system.signals.iter().any(|(_, signal)| !matches!(signal, Signal::Constant(_)));
        Ok(Motion {
            movers: movers.collect(),
            states,
            scales,
            tasks_of_indicators: needed(&tasks, |part| system.parts[part].model.event_indicators > 0),
            tasks,
            signals: system.signals.clone(),
            moving_signals,
            recorded: recorded.to_vec(),
            stale: true,
        })
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

    /// States and signals at a time.
    fn put_states(&mut self, time: f64, states: &[f64]) {
        for (place, value) in self.states.iter().zip(states) {
            self.movers[place.part].row[place.column] = *value;
        }
        if self.moving_signals {
            for (place, signal) in &self.signals {
                self.movers[place.part].row[place.column] = signal.at(time).0;
            }
        }
    }

    /// All inputs at a time, for given states.
    fn put(&mut self, time: f64, states: &[f64]) {
        self.put_states(time, states);
        perform(&self.tasks, &mut self.movers);
    }

    /// Derivatives of the rates, with the slopes that states and signals have. A part without a slope has outputs and
    /// rates without slopes.
    fn derive(&mut self, mut put: impl FnMut(usize, f64)) {
        for task in &self.tasks {
            match task {
                Task::Output(part) => self.movers[*part].output_slopes(),
                Task::Pass { from, to } => {
                    let slope = self.movers[from.part].dual[from.column].slope;
                    self.movers[to.part].incline(to.column, slope);
                }
            }
        }
        for mover in self.movers.iter_mut().filter(|mover| mover.moves && mover.has_slope) {
            mover.model.rate_dual(&mover.dual, &mut mover.dual_rate);
        }
        for (number, place) in self.states.iter().enumerate() {
            let mover = &self.movers[place.part];
            put(number, if mover.has_slope { mover.dual_rate[place.column].slope } else { 0.0 });
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

/// Computes outputs and passes them on.
fn perform(tasks: &[Task], movers: &mut [Mover]) {
    for task in tasks {
        match task {
            Task::Output(part) => {
                let mover = &mut movers[*part];
                mover.model.output(&mut mover.row);
            }
            Task::Pass { from, to } => movers[to.part].row[to.column] = movers[from.part].row[from.column],
        }
    }
}

/// The tasks without which an input of one of these parts would not have its value.
fn needed(tasks: &[Task], wanted: impl Fn(usize) -> bool) -> Vec<Task> {
    let (mut found, mut outputs) = (Vec::new(), Vec::new());
    for task in tasks.iter().rev() {
        let is_needed = match task {
            Task::Output(part) => outputs.contains(part),
            Task::Pass { to, .. } => wanted(to.part) || outputs.contains(&to.part),
        };
        if is_needed {
            found.push(*task);
            if let Task::Pass { from, .. } = task {
                outputs.push(from.part);
            }
        }
    }
    found.reverse();
    found
}

/// The columns of a part that change from one evaluation to the next.
fn changing(system: &System, states: &[Place], part: usize) -> Vec<usize> {
    let inputs = system.wires.iter().map(|wire| wire.to).chain(system.signals.iter().map(|(to, _)| *to));
    states.iter().copied().chain(inputs).filter(|place| place.part == part).map(|place| place.column).collect()
}

/// The computed outputs of a part that are passed on.
fn passed(system: &System, part: usize) -> Vec<usize> {
    let sources = system.wires.iter().filter_map(|wire| match wire.from {
        WireSource::Variable(from) => Some(from),
        WireSource::Derivative(_) => None,
    });
    let computed = sources.filter(|from| from.part == part && system.variable(*from).role.is_computed());
    computed.map(|from| from.column).collect()
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
        if std::mem::take(&mut self.stale) {
            self.movers.iter_mut().for_each(Mover::spread);
        }
        let count = self.states.len();
        for column in 0..count {
            self.movers.iter_mut().for_each(Mover::spread_changing);
            let Place { part, column: at } = self.states[column];
            self.movers[part].incline(at, 1.0);
            self.derive(|row, slope| jacobian[row * count + column] = slope);
        }
        by_time.fill(0.0);
        if self.moving_signals {
            self.movers.iter_mut().for_each(Mover::spread_changing);
            for (place, signal) in &self.signals {
                self.movers[place.part].incline(place.column, signal.at(time).1);
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
        self.put_states(time, states);
        perform(&self.tasks_of_indicators, &mut self.movers);
        let mut rest = indicators;
        for mover in &self.movers {
            let (own, others) = rest.split_at_mut(mover.model.event_indicators);
            mover.model.indicate(&mover.row, own);
            rest = others;
        }
    }

    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String> {
        self.stale = true;
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
