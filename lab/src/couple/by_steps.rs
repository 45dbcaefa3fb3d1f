//! Steps of all models together, as long as two halves agree with the whole.
//!
//! Over a step every input moves linearly. What acts on a host depends on how the host moves within the same step: the
//! values at its end are found by iteration (Broyden's method), so that a stiff contact does not limit the step. Where a
//! law jumps at rest, no force of its equations brings the body to rest within a step; the force between the two sides of
//! the jump does, and it is found by bisection (the solution in the sense of Filippov). The coupling is of second order; a
//! step is made as a whole and in two halves, and divided where they differ.

use stribeck::instance::Snapshot;
use stribeck::number::elementary::pow;

use super::train::{Recorded, Train};
use crate::solve::{End, Grid, Options, Statistics};
use crate::system::{Fault, Place, System, Wire, WireSource};

/// Shortest step, in s (chosen).
const SHORTEST: f64 = 1e-11;

/// Largest number of iterations of a step (chosen); after that it is divided.
const MOST_ITERATIONS: u32 = 25;

/// Part of the tolerance to which the iteration converges (chosen).
const CLOSURE: f64 = 1e-3;

const NO_CONVERGENCE: &str = "the iteration between the parts does not converge";

/// A run under way.
struct Coupling<'a> {
    train: Train<'a>,
    /// Connections whose source steps before their input.
    along: Vec<Wire>,
    /// Connections against the order: their values at the end of a step are what the iteration finds.
    back: Vec<Wire>,
    states: Vec<Place>,
    tolerance: f64,
    statistics: Statistics,
    begin: Vec<Snapshot>,
    /// Approximation of the inverse Jacobian of the iteration.
    inverse: Vec<f64>,
}

/// Runs a system.
pub fn by_steps(
    system: &System,
    grid: Grid,
    options: &Options,
    recorded: &[WireSource],
) -> Result<(End, Statistics, Recorded), Fault> {
    for part in &system.parts {
        if part.model.table.iter().any(|variable| variable.is_settled_by_events()) {
            let (name, model) = (&part.name, part.model.name);
            return Err(Fault::value(format_args!(
                "{name}: {model} sticks and slips at events, which steps do not see"
            )));
        }
    }
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
        let states = train.states();
        let begin = train.save();
        let count = back.len();
        let inverse = identity(count);
        let statistics = Statistics::default();
        Ok(Coupling { train, along, back, states, tolerance: options.relative, statistics, begin, inverse })
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
        let mut h = (grid.end - grid.begin) / grid.intervals as f64;
        for number in 1..grid.len() {
            if options.is_cancelled() {
                return Ok(End::Cancelled { time: self.train.time });
            }
            if let Some(progress) = options.progress {
                progress.reached(self.train.time);
            }
            let end = grid.time(number);
            while self.train.time < end {
                if self.statistics.steps + self.statistics.rejected > options.most_steps {
                    return Err(format!("more than {} steps", options.most_steps));
                }
                h = self.advance(h, end, options)?;
            }
            self.record(recorded, table)?;
        }
        Ok(End::Reached)
    }

    fn record(&mut self, recorded: &[WireSource], (times, values): &mut Recorded) -> Result<(), String> {
        times.push(self.train.time);
        for (column, source) in values.iter_mut().zip(recorded) {
            // What was found by bisection is between two values of its source.
            let found = self.back.iter().find(|wire| wire.from == *source).map(|wire| self.train.state(wire.to));
            column.push(found.map_or_else(|| self.train.value(*source), Ok)?);
        }
        Ok(())
    }

    /// Makes the next step; returns the length proposed for the one after it.
    fn advance(&mut self, h: f64, end: f64, options: &Options) -> Result<f64, String> {
        let breaks = self.train.system.signals.iter().map(|(_, signal)| signal.next_break(self.train.time));
        let wall = breaks.fold(end, f64::min);
        let mut h = h.min(options.longest);
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
        let guess = self.slopes_back()?;
        self.couple(h, &guess)?;
        let whole: Vec<f64> = self.states.iter().map(|place| self.train.state(*place)).collect();
        self.restore(from);
        let half = 0.5 * h;
        let guess = self.slopes_back()?;
        self.couple(half, &guess)?;
        self.train.time = from + half;
        let guess = self.slopes_back()?;
        self.couple_from_here(half, &guess)?;
        self.train.time = from + h;
        let mut worst: f64 = 0.0;
        for (place, whole) in self.states.iter().zip(&whole) {
            let (value, nominal) = (self.train.state(*place), self.train.system.variable(*place).nominal);
            let error = (value - whole).abs() / (self.tolerance * (nominal + value.abs()));
            worst = if error > worst || error.is_nan() { error } else { worst };
        }
        // The halves are three times better than their difference from the whole.
        Ok(worst / 3.0)
    }

    /// The present values of the inputs that the iteration finds.
    fn slopes_back(&self) -> Result<Vec<f64>, String> {
        Ok(self.back.iter().map(|wire| self.train.state(wire.to)).collect())
    }

    fn couple_from_here(&mut self, h: f64, guess: &[f64]) -> Result<(), String> {
        let outer = std::mem::replace(&mut self.begin, self.train.save());
        let done = self.couple(h, guess);
        self.begin = outer;
        done
    }

    /// Makes a coupled step from the state in `begin`, which is the present one.
    fn couple(&mut self, h: f64, guess: &[f64]) -> Result<(), String> {
        let mut ends = guess.to_vec();
        let mut residual = self.pass_through(h, &ends)?;
        for _ in 0..MOST_ITERATIONS {
            if self.is_closed(&ends, &residual) {
                return self.close();
            }
            let change = multiply(&self.inverse, &residual);
            let next: Vec<f64> = ends.iter().zip(&change).map(|(end, change)| end - change).collect();
            let time = self.train.time;
            self.restore(time);
            let after = self.pass_through(h, &next)?;
            broyden(&mut self.inverse, &ends, &next, &residual, &after);
            (ends, residual) = (next, after);
        }
        if self.is_closed(&ends, &residual) {
            return self.close();
        }
        self.inverse = identity(self.back.len());
        if let [guess] = guess { self.bisect(h, *guess) } else { Err(NO_CONVERGENCE.to_owned()) }
    }

    /// Finds the one force at whose sides the law asks for less and for more.
    fn bisect(&mut self, h: f64, guess: f64) -> Result<(), String> {
        let time = self.train.time;
        let residual = |coupling: &mut Self, end: f64| -> Result<f64, String> {
            coupling.restore(time);
            Ok(coupling.pass_through(h, &[end])?[0])
        };
        let nominal = self.train.system.variable(self.back[0].to).nominal;
        let mut width = nominal + guess.abs();
        let (mut low, mut high) = (guess - width, guess + width);
        while residual(self, low)? > 0.0 || residual(self, high)? < 0.0 {
            width *= 4.0;
            (low, high) = (guess - width, guess + width);
            if width > 1e12 * (nominal + guess.abs()) {
                return Err(NO_CONVERGENCE.to_owned());
            }
        }
        while high - low > 1e-14 * (nominal + low.abs()) {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if residual(self, middle)? < 0.0 { low = middle } else { high = middle }
        }
        residual(self, high)?;
        self.train.put(self.back[0].to, high)
    }

    fn is_closed(&self, ends: &[f64], residual: &[f64]) -> bool {
        let sizes = self.back.iter().map(|wire| self.train.system.variable(wire.to).nominal);
        let mut all = ends.iter().zip(residual).zip(sizes);
        all.all(|((end, residual), nominal)| {
            residual.abs() <= (CLOSURE * self.tolerance).max(1e-13) * (nominal + end.abs())
        })
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
    fn pass_through(&mut self, h: f64, ends: &[f64]) -> Result<Vec<f64>, String> {
        self.statistics.evaluations += 1;
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
        let mut residual = Vec::with_capacity(ends.len());
        for (wire, end) in self.back.clone().iter().zip(ends) {
            residual.push(end - self.train.value(wire.from)?);
        }
        Ok(residual)
    }

    fn ramp(&mut self, to: Place, from: f64, end: f64, h: f64) -> Result<(), String> {
        if end == from { Ok(()) } else { self.train.slope(to, (end - from) / h) }
    }
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
