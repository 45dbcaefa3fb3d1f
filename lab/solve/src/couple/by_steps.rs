//! Steps of all models together, as long as two halves agree with the whole.
//!
//! Over a step every input moves linearly. What acts on a host depends on how the host moves within the same step: the
//! values at its end are found by iteration (Broyden's method), so that a stiff contact does not limit the step. Where a
//! law jumps at rest, no force of its equations brings the body to rest within a step; the force between the two sides of
//! the jump does, and it is found by bisection (the solution in the sense of Filippov). The coupling is of second order; a
//! step is made as a whole and in two halves, and divided where they differ. Results between communication points are those
//! of a part of the half step they lie in.

use stribeck::instance::Snapshot;
use stribeck::model::{Brief, Meaning, Variable};
use stribeck::number::elementary::pow;

use super::train::{Recorded, Train};
use crate::solve::{End, Grid, Options, Statistics};
use crate::system::{Fault, Part, Place, System, Wire, WireSource};

/// Shortest step, in s (chosen).
const SHORTEST: f64 = 1e-11;

/// Largest number of iterations of a step (chosen); after that it is divided.
const MOST_ITERATIONS: u32 = 25;

/// Longest step, in parts of the run (chosen): a motion that is given repeats itself unseen in a longer one.
const LONGEST: f64 = 1e-3;

/// Step, in s, up to which forces need not agree (chosen): right behind a reversal a force that follows the logarithm of the
/// speed differs in a step of any length, and moves nothing in one of this length.
const BRIEF: f64 = 1e-8;

/// Part of the tolerance that a step may err by (chosen): steps of second order are many, and what a stiff contact that
/// holds a body does not damp adds up from the one to the next.
const SHARE: f64 = 1e-2;

/// Part of the tolerance to which the iteration converges (chosen).
const CLOSURE: f64 = 1e-4;

/// Speed, in m/s, below which a peak of friction is not seen, and powers of ten in which it is looked for (chosen).
const NARROW: f64 = 1e-9;
const DECADES: i32 = 12;

/// Factor by which a force may be larger there (chosen).
const HIDDEN: f64 = 1.01;

/// Part of its size within which the force on a held body is first looked for (chosen).
const HELD: f64 = 1e-3;

const NO_CONVERGENCE: &str = "the iteration between the parts does not converge";

/// A run under way.
struct Coupling<'a> {
    train: Train<'a>,
    /// Connections whose source steps before their input.
    along: Vec<Wire>,
    /// Connections against the order: their values at the end of a step are what the iteration finds.
    back: Vec<Wire>,
    /// Values that must agree.
    compared: Vec<WireSource>,
    tolerance: f64,
    statistics: Statistics,
    begin: Vec<Snapshot>,
    /// The halves of the last step, and its end.
    halves: [Half; 2],
    end: Vec<Snapshot>,
    /// Whether the last force was found by bisection: so is the next one, most likely.
    bisects: bool,
    /// Approximation of the inverse Jacobian of the iteration.
    inverse: Vec<f64>,
}

/// Half of a step.
#[derive(Clone)]
struct Half {
    begin: Vec<Snapshot>,
    time: f64,
    length: f64,
    /// Values that the iteration found for the end.
    found: Found,
}

/// Values of the inputs that an iteration finds.
#[derive(Clone, Default)]
struct Found {
    values: Vec<f64>,
    /// Whether they lie between two values of their sources.
    by_bisection: bool,
}

/// Whether a part carries an external force at rest, which only an event finds. Steps of a law that follows its past know
/// nothing of that force; the iteration finds it.
fn rests_at_events(part: &Part) -> bool {
    if part.model.has_rates && !part.model.model_exchange {
        return false;
    }
    let is_carried =
        |(column, variable): (usize, Variable)| variable.meaning == Meaning::ExternalForce && part.uses(column);
    part.model.check_without_events(&part.row).is_err() && part.model.variables().any(is_carried)
}

/// Refuses a system with a part that only events bring to rest.
pub fn check_steps(system: &System) -> Result<(), Fault> {
    match system.parts.iter().find(|part| rests_at_events(part)) {
        None => Ok(()),
        Some(Part { name, model, .. }) => {
            Err(Fault::value(format_args!("{name}: {} sticks and slips at events, which steps do not see", model.name)))
        }
    }
}

/// Runs a system.
pub fn by_steps(
    system: &System,
    grid: Grid,
    options: &Options,
    recorded: &[WireSource],
) -> Result<(End, Statistics, Recorded), Fault> {
    check_steps(system)?;
    let mut coupling = Coupling::new(system, options)?;
    let mut table = (Vec::new(), vec![Vec::new(); recorded.len()]);
    let end = match coupling.go(grid, options, recorded, &mut table) {
        Ok(end) => end,
        Err(reason) => End::Failed { time: coupling.train.time, reason },
    };
    Ok((end, coupling.statistics, table))
}

impl<'a> Coupling<'a> {
    fn new(system: &'a System, options: &Options) -> Result<Coupling<'a>, Fault> {
        let train = Train::new(system)?;
        let at = |part: usize| train.order.iter().position(|known| *known == part);
        let (mut along, mut back) = (Vec::new(), Vec::new());
        for wire in &system.wires {
            // A step with slopes knows the derivative of what it moves along.
            let WireSource::Variable(from) = wire.from else { continue };
            if at(from.part) < at(wire.to.part) { along.push(*wire) } else { back.push(*wire) }
        }
        let begin = train.save();
        let half = Half { begin: begin.clone(), time: 0.0, length: 0.0, found: Found::default() };
        Ok(Coupling {
            compared: compared(&train, &back),
            inverse: identity(back.len()),
            along,
            back,
            tolerance: options.relative,
            statistics: Statistics::default(),
            halves: [half.clone(), half],
            end: begin.clone(),
            begin,
            bisects: false,
            train,
        })
    }

    fn go(
        &mut self,
        grid: Grid,
        options: &Options,
        recorded: &[WireSource],
        table: &mut Recorded,
    ) -> Result<End, String> {
        self.train.settle()?;
        self.record(recorded, table)?;
        let span = grid.end - grid.begin;
        let longest = options.longest.min(LONGEST * span).max(span / grid.intervals as f64);
        let (mut h, mut number) = (span / grid.intervals as f64, 1);
        while number < grid.len() {
            if options.is_cancelled() {
                return Ok(End::Cancelled { time: self.train.time });
            }
            if let Some(progress) = options.progress {
                progress.reached(self.train.time);
            }
            if self.statistics.steps + self.statistics.rejected > options.most_steps {
                return Err(format!("more than {} steps", options.most_steps));
            }
            h = self.advance(h.min(longest), grid.end)?;
            let reached = self.train.time;
            self.train.save_into(&mut self.end);
            while number < grid.len() && grid.time(number) < reached {
                self.go_back_to(grid.time(number))?;
                self.record(recorded, table)?;
                number += 1;
            }
            let end = std::mem::take(&mut self.end);
            self.train.restore(&end);
            self.end = end;
            self.train.time = reached;
            if number < grid.len() && grid.time(number) == reached {
                self.record(recorded, table)?;
                number += 1;
            }
        }
        Ok(End::Reached)
    }

    /// Goes to a time within the last step, in the half in which it lies.
    fn go_back_to(&mut self, time: f64) -> Result<(), String> {
        let half = &self.halves[usize::from(time > self.halves[1].time)];
        let Half { time: from, length, ref found, .. } = *half;
        self.train.restore(&half.begin);
        self.train.time = from;
        let part = (time - from) / length;
        let begin = self.back.iter().map(|wire| self.train.state(wire.to));
        let ends: Vec<f64> = begin.zip(&found.values).map(|(begin, end)| begin + part * (end - begin)).collect();
        let by_bisection = found.by_bisection;
        if time > from {
            self.pass_through(time - from, &ends)?;
            if !by_bisection {
                self.close()?;
            }
        }
        self.train.time = time;
        Ok(())
    }

    fn record(&mut self, recorded: &[WireSource], (times, values): &mut Recorded) -> Result<(), String> {
        times.push(self.train.time);
        for (column, source) in values.iter_mut().zip(recorded) {
            column.push(self.result(*source)?);
        }
        Ok(())
    }

    /// Makes the next step; returns the length proposed for the one after it.
    fn advance(&mut self, h: f64, end: f64) -> Result<f64, String> {
        let breaks = self.train.system.signals.iter().map(|(_, signal)| signal.next_break(self.train.time));
        let wall = breaks.fold(end, f64::min);
        let mut h = h;
        let mut reason = String::from("two halves of a step do not agree with the whole");
        self.train.save_into(&mut self.begin);
        let from = self.train.time;
        loop {
            let room = wall - from;
            let (length, target) = if h >= room / 1.01 { (room, wall) } else { (h, from + h) };
            match self.attempt(length) {
                Ok(error) => {
                    let factor = 0.9 * pow(error, -1.0 / 3.0);
                    let factor = if factor.is_nan() { 0.25 } else { factor.clamp(0.2, 4.0) };
                    if error <= 1.0 {
                        self.train.time = target;
                        self.statistics.steps += 1;
                        return Ok(if length < h && factor > 1.0 { h } else { length * factor });
                    }
                    h = length * factor.min(0.7);
                }
                Err(text) => {
                    reason = text;
                    h = 0.25 * length;
                }
            }
            self.statistics.rejected += 1;
            self.restore(from);
            if h < SHORTEST.max(4.0 * f64::EPSILON * from) {
                return Err(format!("a step of {h:e} s is still too long: {reason}"));
            }
        }
    }

    fn restore(&mut self, time: f64) {
        let begin = std::mem::take(&mut self.begin);
        self.train.restore(&begin);
        self.begin = begin;
        self.train.time = time;
    }

    /// Makes a step as a whole and in two halves, which are kept; their difference in parts of the tolerance.
    fn attempt(&mut self, h: f64) -> Result<f64, String> {
        let from = self.train.time;
        let found = self.couple(h)?;
        let (whole, forces) = (self.values()?, self.forces()?);
        self.restore(from);
        let half = 0.5 * h;
        for number in 0..2 {
            let time = from + number as f64 * half;
            self.train.time = time;
            let Half { begin, .. } = &mut self.halves[number];
            self.train.save_into(begin);
            std::mem::swap(&mut self.begin, begin);
            let found = self.couple(half);
            std::mem::swap(&mut self.begin, &mut self.halves[number].begin);
            let kept = &mut self.halves[number];
            (kept.time, kept.length, kept.found) = (time, half, found?);
        }
        self.train.time = from + h;
        let pairs = self.values()?.into_iter().zip(whole);
        let sources = self.compared.iter().copied().zip(pairs);
        let mut worst = sources.fold(0.0, |worst, (source, pair)| self.worse(worst, source, pair));
        // The force that brings a body to rest at the end of a step depends on the step. Others show what a law remembers.
        if h > BRIEF && !(found.by_bisection || self.halves.iter().any(|half| half.found.by_bisection)) {
            let pairs = self.forces()?.into_iter().zip(forces);
            worst = self.back.iter().zip(pairs).fold(worst, |worst, (wire, pair)| self.worse(worst, wire.from, pair));
        }
        // The halves are three times better than their difference from the whole.
        Ok(worst / 3.0)
    }

    /// The larger of an error and that of a further value, in parts of the tolerance.
    fn worse(&self, worst: f64, source: WireSource, (value, whole): (f64, f64)) -> f64 {
        let error = (value - whole).abs() / (SHARE * self.tolerance * (self.nominal(source) + value.abs()));
        if error > worst || error.is_nan() { error } else { worst }
    }

    /// Present values of the sources whose inputs the iteration finds.
    fn forces(&mut self) -> Result<Vec<f64>, String> {
        (0..self.back.len()).map(|index| self.train.value(self.back[index].from)).collect()
    }

    /// The values that must agree.
    fn values(&mut self) -> Result<Vec<f64>, String> {
        (0..self.compared.len()).map(|index| self.result(self.compared[index])).collect()
    }

    /// A result at the present time. What was found by bisection is between two values of its source.
    fn result(&mut self, source: WireSource) -> Result<f64, String> {
        let found = self.back.iter().find(|wire| wire.from == source).map(|wire| self.train.state(wire.to));
        found.map_or_else(|| self.train.value(source), Ok)
    }

    fn nominal(&self, source: WireSource) -> f64 {
        let (WireSource::Variable(place) | WireSource::Derivative(place)) = source;
        self.train.system.variable(place).nominal
    }

    /// Makes a coupled step from the state in `begin`, which is the present one.
    fn couple(&mut self, h: f64) -> Result<Found, String> {
        let guess: Vec<f64> = self.back.iter().map(|wire| self.train.state(wire.to)).collect();
        if let ([first], true) = (&*guess, self.bisects) {
            // Where a body is held, the force is near that of the step before.
            let found = self.bisect(h, *first, HELD)?;
            if found.by_bisection {
                return Ok(found);
            }
        }
        self.bisects = false;
        let found = self.iterate(h, &guess)?;
        if let Some(values) = found {
            self.close()?;
            return Ok(Found { values, by_bisection: false });
        }
        self.inverse = identity(self.back.len());
        let [first] = &*guess else { return Err(NO_CONVERGENCE.to_owned()) };
        let found = self.bisect(h, *first, 1.0)?;
        if found.by_bisection {
            self.check_peak()?;
        }
        self.bisects = true;
        Ok(found)
    }

    /// Refuses a law whose force has a peak at a speed that steps hardly tell from rest: it carries more than they find.
    fn check_peak(&mut self) -> Result<(), String> {
        let WireSource::Variable(force) = self.back[0].from else { return Ok(()) };
        let Part { name, model, .. } = &self.train.system.parts[force.part];
        let Some(column) = model.table.of(Meaning::Velocity) else { return Ok(()) };
        let place = Place { column, ..force };
        let velocity = self.train.state(place);
        let at = |train: &mut Train, speed: f64| -> Result<f64, String> {
            train.put(place, speed.copysign(velocity))?;
            Ok(train.value(WireSource::Variable(force))?.abs())
        };
        let beyond = at(&mut self.train, NARROW)?;
        let mut speed = NARROW;
        for _ in 0..DECADES {
            speed *= 0.1;
            let peak = at(&mut self.train, speed)?;
            if peak > HIDDEN * beyond {
                return Err(format!(
                    "{name}: the friction force of {} is {} N at {speed:.0e} m/s and {} N at {NARROW:.0e} m/s: steps do \
                     not see the peak",
                    model.name,
                    Brief(peak),
                    Brief(beyond),
                ));
            }
        }
        at(&mut self.train, velocity.abs()).map(|_| ())
    }

    /// Finds the values at the end of a step at which the parts agree; none if the iteration does not converge.
    fn iterate(&mut self, h: f64, guess: &[f64]) -> Result<Option<Vec<f64>>, String> {
        let time = self.train.time;
        self.restore(time);
        let mut ends = guess.to_vec();
        let mut residual = self.try_ends(h, &ends)?;
        for _ in 0..MOST_ITERATIONS {
            if self.is_closed(&ends, &residual) {
                return Ok(Some(ends));
            }
            let change = multiply(&self.inverse, &residual);
            let next: Vec<f64> = ends.iter().zip(&change).map(|(end, change)| end - change).collect();
            self.restore(time);
            let after = self.try_ends(h, &next)?;
            broyden(&mut self.inverse, &ends, &next, &residual, &after);
            (ends, residual) = (next, after);
        }
        Ok(self.is_closed(&ends, &residual).then_some(ends))
    }

    /// Finds the one force at whose sides the law asks for less and for more. The search begins within `part` of the size
    /// of a guess.
    fn bisect(&mut self, h: f64, guess: f64, part: f64) -> Result<Found, String> {
        let time = self.train.time;
        let residual = |coupling: &mut Self, end: f64| -> Result<f64, String> {
            coupling.restore(time);
            Ok(coupling.try_ends(h, &[end])?[0])
        };
        let size = self.train.system.variable(self.back[0].to).nominal + guess.abs();
        let mut width = part * size;
        let (mut low, mut high) = (guess - width, guess + width);
        let (mut at_low, mut at_high) = (residual(self, low)?, residual(self, high)?);
        while at_low > 0.0 || at_high < 0.0 {
            width *= 8.0;
            if width > 1e12 * size {
                return Err(NO_CONVERGENCE.to_owned());
            }
            if at_low > 0.0 {
                low = guess - width;
                at_low = residual(self, low)?;
            } else {
                high = guess + width;
                at_high = residual(self, high)?;
            }
        }
        while high - low > self.closure() * size {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let found = residual(self, middle)?;
            if found < 0.0 { (low, at_low) = (middle, found) } else { (high, at_high) = (middle, found) }
        }
        // A jump stays a jump however narrow the interval is.
        let by_bisection = at_high - at_low > 1e3 * self.closure() * size;
        residual(self, high)?;
        self.train.put(self.back[0].to, high)?;
        Ok(Found { values: vec![high], by_bisection })
    }

    /// Part of its size to which a force is found.
    fn closure(&self) -> f64 {
        (CLOSURE * self.tolerance).max(1e-13)
    }

    fn is_closed(&self, ends: &[f64], residual: &[f64]) -> bool {
        let sizes = self.back.iter().map(|wire| self.train.system.variable(wire.to).nominal);
        let mut all = ends.iter().zip(residual).zip(sizes);
        all.all(|((end, residual), nominal)| residual.abs() <= self.closure() * (nominal + end.abs()))
    }

    /// Inputs at the end of the step take the values of their sources there.
    fn close(&mut self) -> Result<(), String> {
        for wire in self.back.clone() {
            let value = self.train.value(wire.from)?;
            self.train.put(wire.to, value)?;
        }
        Ok(())
    }

    /// Steps all parts one after the other, with these values at the end; how far their sources are from them.
    fn try_ends(&mut self, h: f64, ends: &[f64]) -> Result<Vec<f64>, String> {
        self.statistics.evaluations += 1;
        self.pass_through(h, ends)?;
        let sources = self.back.iter().map(|wire| wire.from).zip(ends);
        sources.map(|(from, end)| Ok(end - self.train.value(from)?)).collect()
    }

    /// Steps all parts one after the other, with these values at the end.
    fn pass_through(&mut self, h: f64, ends: &[f64]) -> Result<(), String> {
        let time = self.train.time;
        let system = self.train.system;
        for (place, signal) in &system.signals {
            let now = self.train.state(*place);
            self.ramp(*place, now, signal.at(time + h).0, h)?;
        }
        for (wire, end) in self.back.clone().iter().zip(ends) {
            let now = self.train.state(wire.to);
            self.ramp(wire.to, now, *end, h)?;
        }
        for part in self.train.order.clone() {
            for wire in self.along.clone().iter().filter(|wire| wire.to.part == part) {
                let now = self.train.state(wire.to);
                let end = self.train.value(wire.from)?;
                self.ramp(wire.to, now, end, h)?;
            }
            self.train.step(part, h)?;
        }
        Ok(())
    }

    fn ramp(&mut self, to: Place, from: f64, end: f64, h: f64) -> Result<(), String> {
        if end == from { Ok(()) } else { self.train.slope(to, (end - from) / h) }
    }
}

/// Motion and energies, and the forces of contacts whose motion is given.
fn compared(train: &Train, back: &[Wire]) -> Vec<WireSource> {
    let mut sources: Vec<WireSource> = train.states().into_iter().map(WireSource::Variable).collect();
    for (part, made) in train.system.parts.iter().enumerate() {
        let force = made
            .model
            .table
            .of(Meaning::FrictionForce)
            .filter(|column| made.model.table.at(*column).role.is_computed());
        let force = force.map(|column| WireSource::Variable(Place { part, column }));
        sources.extend(force.filter(|source| back.iter().all(|wire| wire.from != *source)));
    }
    sources
}

fn identity(count: usize) -> Vec<f64> {
    (0..count * count).map(|at| f64::from(u8::from(at / count == at % count))).collect()
}

fn multiply(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    if vector.is_empty() {
        return Vec::new();
    }
    matrix.chunks(vector.len()).map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum()).collect()
}

/// Broyden's update of the inverse Jacobian, in the form of Sherman and Morrison.
fn broyden(inverse: &mut [f64], before: &[f64], after: &[f64], residual: &[f64], next: &[f64]) {
    let count = before.len();
    let moved: Vec<f64> = after.iter().zip(before).map(|(a, b)| a - b).collect();
    let changed: Vec<f64> = next.iter().zip(residual).map(|(a, b)| a - b).collect();
    let image = multiply(inverse, &changed);
    let row: Vec<f64> = (0..count).map(|j| (0..count).map(|i| moved[i] * inverse[i * count + j]).sum()).collect();
    let scale: f64 = row.iter().zip(&changed).map(|(a, b)| a * b).sum();
    if scale == 0.0 || !scale.is_finite() {
        return;
    }
    for i in 0..count {
        for j in 0..count {
            inverse[i * count + j] += (moved[i] - image[i]) * row[j] / scale;
        }
    }
}
