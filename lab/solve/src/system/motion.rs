//! Equations of motion of a system whose parts all have rates.

use stribeck::model::Past;
use stribeck::number::DIRECTIONS;
use stribeck::table::{Meaning, Variable};

use super::bonds::{Bundle, bundles};
use super::mover::Mover;
use super::order::{Task, moving, moving_parts, tasks};
use super::part::{Part, System, Wire, WireSource};
use super::past::{Breaks, Line};
use super::wiring::{Plan, Rows, column_of};
use super::{Fault, Place, Signal};
use crate::solve::{Equations, Track};

/// The equations of motion of a system.
pub struct Motion {
    movers: Vec<Mover>,
    rows: Rows,
    states: Vec<Place>,
    /// Columns of the states in the rows of all parts.
    columns: Vec<usize>,
    runs: Vec<Run>,
    scales: Vec<f64>,
    /// Evaluation that gives all inputs their values.
    all: Plan,
    /// Evaluation that finds all rates.
    of_rates: Plan,
    /// Evaluation that gives the parts with event indicators their inputs.
    of_indicators: Plan,
    signals: Vec<(Place, Signal)>,
    moving_signals: bool,
    /// Time at which the signals have been looked at.
    time_of_signals: f64,
    /// What laws follow a time lag later.
    lines: Vec<Line>,
    /// Evaluation that gives these laws their inputs.
    of_lines: Plan,
    breaks: Breaks,
    /// Bonds that snap within steps, and where a step has brought them.
    bundles: Vec<Bundle>,
    tracks: Vec<Track>,
    /// Whether evaluations need more than the states.
    has_more: bool,
    /// Columns of what laws follow at once, because their lag is 0.
    present: Vec<Place>,
    recorded: Vec<WireSource>,
    /// Columns that change in time and are not given by another part.
    changing: Vec<usize>,
    /// Whether other columns may have changed since they were taken over with slopes.
    stale: bool,
}

/// States that are neighbours in the rows of all parts as well.
#[derive(Clone, Copy, Debug)]
struct Run {
    column: usize,
    first: usize,
    count: usize,
}

/// Runs of states with these columns.
fn runs(columns: &[usize]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (first, column) in columns.iter().copied().enumerate() {
        match runs.last_mut() {
            Some(run) if run.column + run.count == column => run.count += 1,
            _ => runs.push(Run { column, first, count: 1 }),
        }
    }
    runs
}

/// Copies some values: two at once where a model is likely to read two at once, since processors stall if they were
/// written singly.
#[inline(always)]
fn copy(from: &[f64], to: &mut [f64], count: usize) {
    match count {
        1 => to[0] = from[0],
        2 => to[..2].copy_from_slice(&from[..2]),
        _ => to[..count].copy_from_slice(&from[..count]),
    }
}

/// Largest number of times that events are passed from part to part at one instant (chosen).
const PASSES: usize = 8;

impl Motion {
    /// Refuses a system that has no equations of motion: a part is for co-simulation only, or outputs depend on each other.
    pub fn check(system: &System) -> Result<(), Fault> {
        Motion::order(system).map(|_| ())
    }

    /// The tasks that give every connected input its value, in a system with equations of motion.
    fn order(system: &System) -> Result<Vec<Task>, Fault> {
        for part in &system.parts {
            if !part.model.has_rates {
                let text = format_args!("{} ({}) has no rates: it is for steps only", part.name, part.model.name);
                return Err(Fault::value(text));
            }
            part.model
                .check_model_exchange(&part.row)
                .map_err(|fault| Fault::value(format_args!("{}: {}", part.name, fault.0)))?;
        }
        let is_used = |wire: &&Wire| {
            matches!(wire.from, WireSource::Derivative(_)) && system.parts[wire.to.part].uses(wire.to.column)
        };
        if let Some(wire) = system.wires.iter().find(is_used) {
            let text = format_args!(
                "{} is the rate of a state, which the force itself decides: it is for steps only; for other solvers set \
                 acceleration_source = Balance",
                system.name(wire.to)
            );
            return Err(Fault::value(text));
        }
        tasks(system, system.influences())
    }

    /// The equations of a system, for results that are to be recorded.
    pub fn new(system: &System, recorded: &[WireSource]) -> Result<Motion, Fault> {
        let tasks = Motion::order(system)?;
        let states = states(system, recorded);
        let scales = scales(system, &states);
        let (lines, present) = lines(system);
        let lagged = lines.iter().map(|line| Place { part: line.part, column: line.column });
        let (bundles, tracks): (Vec<Bundle>, Vec<Track>) = bundles(system, &states).into_iter().unzip();
        let strains = bundles.iter().flat_map(Bundle::places);
        let changing: Vec<Place> = states.iter().copied().chain(lagged).chain(strains).collect();
        let moving = moving(system, system.influences(), &changing);
        let movers = Mover::all(system, &states, &moving);
        let moving_parts = moving_parts(system, &changing);
        // The others keep what they give from event to event.
        let mut used = used(&tasks, system);
        used.retain(|task| moving_parts[task.giver()]);
        let moving_signals: Vec<Place> = system.moving_signals().collect();
        let columns: Vec<usize> = states.iter().map(|place| column_of(&movers, *place)).collect();
        let mut motion = Motion {
            rows: Rows::new(system.parts.iter().map(|part| part.row.clone())),
            all: Plan::of_inputs(&tasks, &movers),
            of_rates: Plan::of_rates(&used, &movers),
            of_indicators: Plan::of_inputs(&needed(&used, |part| movers[part].indicators > 0), &movers),
            of_lines: Plan::of_inputs(&needed(&used, |part| lines.iter().any(|line| line.part == part)), &movers),
            changing: changing.iter().chain(&moving_signals).map(|place| column_of(&movers, *place)).collect(),
            has_more: !(moving_signals.is_empty() && lines.is_empty() && bundles.is_empty()),
            lines,
            breaks: Breaks::default(),
            bundles,
            tracks,
            present,
            movers,
            runs: runs(&columns),
            columns,
            states,
            scales,
            signals: system.signals.clone(),
            moving_signals: !moving_signals.is_empty(),
            time_of_signals: f64::NAN,
            recorded: recorded.to_vec(),
            stale: true,
        };
        motion.rows.perform(&motion.all);
        Ok(motion)
    }

    /// Records these results and no others.
    pub fn record_only(&mut self, recorded: Vec<WireSource>) {
        self.recorded = recorded;
    }

    /// The states at the start.
    pub fn start(&self) -> Vec<f64> {
        self.columns.iter().map(|column| self.rows.values[*column]).collect()
    }

    /// Largest derivative of a rate by its own state, after the events at the start, in 1/s, and the number of the state.
    pub fn steepest(&mut self) -> Option<(usize, f64)> {
        let (mut states, count) = (self.start(), self.states());
        self.at_event(0.0, &mut states).ok()?;
        let (mut jacobian, mut by_time) = (vec![0.0; count * count], vec![0.0; count]);
        self.jacobian(0.0, &states, &mut jacobian, &mut by_time);
        let slope = |state: usize| (state, jacobian[state * (count + 1)].abs());
        (0..count).map(slope).max_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// The variables that are states.
    pub fn places(&self) -> &[Place] {
        &self.states
    }

    /// Whether laws follow the past, which a solver must have given to [`Equations::accept`].
    pub fn has_past(&self) -> bool {
        !self.lines.is_empty()
    }

    /// Whether laws have bonds that snap, which only our own methods follow.
    pub fn has_bonds(&self) -> bool {
        !self.bundles.is_empty()
    }

    /// What the law of a line remembers.
    fn past(&self, line: &Line) -> Option<Past> {
        let mover = &self.movers[line.part];
        mover.model.past(self.rows.of(mover))
    }

    /// Reads and writes the past on from an event, before which laws have remembered these values.
    fn pass_lines(&mut self, time: f64, before: &[Option<Past>]) {
        let mut lines = std::mem::take(&mut self.lines);
        for (line, before) in lines.iter_mut().zip(before) {
            match (self.past(line), before) {
                (Some(past), Some(before)) if past.is_kept => {
                    let last = if line.is_empty() { past.before } else { before.now };
                    line.pass(time, [last, past.now], past.rests);
                }
                _ => line.forget(),
            }
        }
        self.breaks.add(time, &lines);
        self.lines = lines;
    }

    /// States, signals and what laws follow of the past, at a time.
    fn put_states(&mut self, time: f64, states: &[f64]) {
        for Run { column, first, count } in &self.runs {
            copy(&states[*first..], &mut self.rows.values[*column..], *count);
        }
        if self.has_more {
            self.put_more(time, states);
        }
    }

    /// Bonds, signals and what laws follow of the past, at a time.
    fn put_more(&mut self, time: f64, states: &[f64]) {
        for (bundle, track) in self.bundles.iter().zip(&self.tracks) {
            bundle.put(track, states[track.state], &self.movers[bundle.part], &mut self.rows);
        }
        if self.moving_signals && time != self.time_of_signals {
            self.time_of_signals = time;
            for (place, signal) in &self.signals {
                self.rows.values[column_of(&self.movers, *place)] = signal.at(time).0;
            }
        }
        for line in &self.lines {
            if let Some((value, _)) = line.at(time) {
                let place = Place { part: line.part, column: line.column };
                self.rows.values[column_of(&self.movers, place)] = value;
            }
        }
    }

    /// All inputs at a time, for given states.
    fn put(&mut self, time: f64, states: &[f64]) {
        self.put_states(time, states);
        self.rows.perform(&self.all);
    }

    /// Gives a state a slope, and the strains that follow it.
    fn incline_state(&mut self, number: usize, direction: usize) {
        self.rows.incline(self.states[number].part, self.columns[number], direction, 1.0);
        for (bundle, track) in self.bundles.iter().zip(&self.tracks) {
            if track.state == number {
                let columns = bundle.places().map(|place| column_of(&self.movers, place));
                columns.for_each(|column| self.rows.incline(bundle.part, column, direction, 1.0));
            }
        }
    }

    /// Gives signals and what laws follow of the past their slopes.
    fn incline_by_time(&mut self, time: f64, direction: usize) {
        let Motion { rows, movers, .. } = self;
        let mut incline = |place: Place, slope| rows.incline(place.part, column_of(movers, place), direction, slope);
        for (place, signal) in &self.signals {
            incline(*place, signal.at(time).1);
        }
        for line in &self.lines {
            let slope = line.at(time).map_or(0.0, |(_, slope)| slope);
            incline(Place { part: line.part, column: line.column }, slope);
        }
    }

    /// The next time at which the rate of a signal jumps.
    fn next_kink(&self, time: f64) -> f64 {
        self.signals.iter().map(|(_, signal)| signal.next_break(time)).fold(f64::INFINITY, f64::min)
    }

    fn find_rates(&mut self) {
        let Rows { values, rates, .. } = &mut self.rows;
        for mover in self.movers.iter().filter(|mover| mover.moves) {
            (mover.level.rate)(&values[mover.columns.clone()], &mut rates[mover.columns.clone()]);
        }
    }

    fn outputs(&mut self) -> Result<(), String> {
        for mover in &self.movers {
            if !mover.model.output(self.rows.of_mut(mover)) {
                return Err(format!("an output of {} is not finite", mover.name));
            }
        }
        Ok(())
    }
}

/// The past that laws follow, and the columns of what they follow without a lag.
fn lines(system: &System) -> (Vec<Line>, Vec<Place>) {
    let (mut lines, mut present) = (Vec::new(), Vec::new());
    for (part, Part { model, row, .. }) in system.parts.iter().enumerate() {
        let (Some(past), Some(column)) = (model.past(row), model.table.of(Meaning::Lagged)) else { continue };
        if past.lag > 0.0 {
            lines.push(Line::new(part, column, past.lag, model.table.at(column).nominal));
        } else {
            present.push(Place { part, column });
        }
    }
    (lines, present)
}

/// The tasks without those that only give an external force to a law that needs none: they would cost each evaluation the
/// outputs of the parts on both sides once more.
fn used(tasks: &[Task], system: &System) -> Vec<Task> {
    let is_idle =
        |to: &Place| system.variable(*to).meaning == Meaning::ExternalForce && !system.parts[to.part].uses(to.column);
    let is_used = |task: &&Task| !matches!(task, Task::Pass { to, .. } if is_idle(to));
    let used: Vec<Task> = tasks.iter().filter(is_used).copied().collect();
    needed(&used, |_| true)
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

/// The continuous states that matter: energies that nobody reads need not be integrated.
fn states(system: &System, recorded: &[WireSource]) -> Vec<Place> {
    let sources: Vec<WireSource> = system.wires.iter().map(|wire| wire.from).chain(recorded.iter().copied()).collect();
    let is_read = |place: Place| {
        sources.contains(&WireSource::Variable(place)) || sources.contains(&WireSource::Derivative(place))
    };
    let (mut states, mut unread) = (Vec::new(), Vec::new());
    for (part, made) in system.parts.iter().enumerate() {
        let follows = made.model.past(&made.row).is_some();
        for column in made.model.states_in_use(&made.row) {
            let place = Place { part, column };
            let meaning = made.model.table.at(column).meaning;
            let is_carried = Bundle::carries(made.model, &made.row, column);
            if is_carried || meaning == Meaning::History || follows && meaning == Meaning::Lagged {
                continue;
            }
            if meaning != Meaning::Energy || is_read(place) {
                states.push(place);
            } else {
                unread.push(place);
            }
        }
    }
    // A motion that is given has no other state.
    if states.is_empty() { unread } else { states }
}

/// Sizes of the states, for the absolute tolerance. That of a velocity is at most the lowest speed at which a law of the
/// system, chosen in a strut or not, passes from rest to sliding, or to which it refers: an error of that size would carry
/// the contact across.
fn scales(system: &System, states: &[Place]) -> Vec<f64> {
    let is_passed = |variable: &Variable| {
        matches!(variable.meaning, Meaning::FallSpeed | Meaning::TransitionSpeed | Meaning::ReferenceSpeed)
    };
    let speeds = system.parts.iter().flat_map(|part| {
        let passed = part.model.variables().filter(|(_, variable)| is_passed(variable));
        passed.map(|(column, _)| part.row[column])
    });
    let least = speeds.filter(|speed| *speed > 0.0).fold(f64::INFINITY, f64::min);
    let scale = |place: &Place| {
        let nominal = system.variable(*place).nominal;
        let is_velocity = system.unit(WireSource::Variable(*place)).name == "m/s";
        if is_velocity { nominal.min(least) } else { nominal }
    };
    states.iter().map(scale).collect()
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
        self.put_states(time, states);
        self.rows.perform(&self.of_rates);
        for Run { column, first, count } in &self.runs {
            let (found, rates) = (&self.rows.rates[*column..], &mut rates[*first..]);
            match *count {
                1 => rates[0] = found[0],
                // One by one, as the model has written them.
                2 => (rates[0], rates[1]) = (found[0], found[1]),
                count => rates[..count].copy_from_slice(&found[..count]),
            }
        }
    }

    fn jacobian(&mut self, time: f64, states: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        self.linearise(time, states, &mut vec![0.0; states.len()], jacobian, by_time);
    }

    fn linearise(&mut self, time: f64, states: &[f64], rates: &mut [f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        self.put_states(time, states);
        if std::mem::take(&mut self.stale) {
            self.rows.spread();
        }
        let count = self.states.len();
        by_time.fill(0.0);
        // Time comes after the states.
        let past = count + usize::from(self.moving_signals || !self.lines.iter().all(Line::rests));
        for first in (0..past).step_by(DIRECTIONS) {
            let directions = first..past.min(first + DIRECTIONS);
            self.rows.level(&self.changing);
            for (direction, number) in directions.clone().enumerate() {
                if number < count {
                    self.incline_state(number, direction);
                } else {
                    self.incline_by_time(time, direction);
                }
            }
            self.rows.perform_inclined(&self.of_rates, &self.movers);
            let of_states = count.min(directions.end) - first;
            for (row, (place, column)) in self.states.iter().zip(&self.columns).enumerate() {
                let rate = self.rows.inclined_rate(place.part, *column);
                rates[row] = rate.value;
                let (of_states, of_time) = rate.slopes[..directions.len()].split_at(of_states);
                jacobian[row * count + first..][..of_states.len()].copy_from_slice(of_states);
                if let [slope] = of_time {
                    by_time[row] = *slope;
                }
            }
        }
    }

    fn indicators(&self) -> usize {
        self.movers.iter().map(|mover| mover.indicators).sum()
    }

    fn indicator_name(&self, indicator: usize) -> String {
        let mut before = 0;
        for mover in &self.movers {
            if indicator < before + mover.indicators {
                return mover.name.clone();
            }
            before += mover.indicators;
        }
        String::new()
    }

    fn indicate(&mut self, time: f64, states: &[f64], indicators: &mut [f64]) {
        self.put_states(time, states);
        self.rows.perform(&self.of_indicators);
        let mut rest = indicators;
        for mover in &self.movers {
            let (own, others) = rest.split_at_mut(mover.indicators);
            if !own.is_empty() {
                mover.model.indicate(self.rows.of(mover), own);
            }
            rest = others;
        }
    }

    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String> {
        self.stale = true;
        self.lines.iter_mut().for_each(|line| line.turn(time));
        self.put(time, states);
        let past: Vec<Option<Past>> = self.lines.iter().map(|line| self.past(line)).collect();
        for _ in 0..PASSES {
            self.put(time, states);
            let before = self.rows.values.clone();
            for mover in &self.movers {
                if !mover.model.at_event(self.rows.of_mut(mover)) {
                    return Err(format!("the states of {} after an event are not finite", mover.name));
                }
            }
            for (value, column) in states.iter_mut().zip(&self.columns) {
                *value = self.rows.values[*column];
            }
            for (bundle, track) in self.bundles.iter().zip(&mut self.tracks) {
                bundle.take(track, &self.movers[bundle.part], &self.rows);
            }
            if self.rows.values == before {
                break;
            }
        }
        self.pass_lines(time, &past);
        Ok(())
    }

    fn is_piecewise_linear(&self) -> bool {
        !self.moving_signals && self.movers.iter().all(|mover| mover.model.is_linear(self.rows.of(mover)))
    }

    fn next_break(&self, time: f64) -> f64 {
        self.next_kink(time).min(self.breaks.next(time, &self.lines))
    }

    fn accept(&mut self, begin: f64, end: f64, states_at: &dyn Fn(f64, &mut [f64])) {
        if self.lines.is_empty() {
            return;
        }
        let mut lines = std::mem::take(&mut self.lines);
        let mut states = vec![0.0; self.states.len()];
        for line in &mut lines {
            let part = line.part;
            line.keep(begin, end, &mut |fraction| {
                states_at(fraction, &mut states);
                self.put_states(begin + (end - begin) * fraction, &states);
                self.rows.perform(&self.of_lines);
                let mover = &self.movers[part];
                mover.model.past(self.rows.of(mover)).map_or(0.0, |past| past.now)
            });
        }
        if self.next_kink(begin) <= end {
            self.breaks.add(end, &lines);
        }
        self.lines = lines;
    }

    fn is_due(&self, time: f64) -> bool {
        self.lines.iter().any(|line| line.is_due(time))
    }

    fn tracks(&mut self) -> &mut [Track] {
        &mut self.tracks
    }

    fn renew_tracks(&mut self) {
        for (bundle, track) in self.bundles.iter().zip(&mut self.tracks) {
            bundle.renew(track, &self.movers[bundle.part], &self.rows);
        }
    }

    fn recorded(&self) -> usize {
        self.recorded.len()
    }

    fn record(&mut self, time: f64, states: &[f64], values: &mut [f64]) -> Result<(), String> {
        self.put(time, states);
        for Place { part, column } in &self.present {
            let mover = &self.movers[*part];
            let row = self.rows.of_mut(mover);
            row[*column] = mover.model.past(row).map_or(row[*column], |past| past.now);
        }
        self.outputs()?;
        self.find_rates();
        for (value, source) in values.iter_mut().zip(&self.recorded) {
            *value = match source {
                WireSource::Variable(place) => self.rows.values[column_of(&self.movers, *place)],
                WireSource::Derivative(place) => self.rows.rates[column_of(&self.movers, *place)],
            };
        }
        Ok(())
    }
}
