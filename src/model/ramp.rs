//! A step with inputs that move linearly, for models whose states move continuously.
//!
//! Between two kinks a state obeys `y' = f(y, t)`, where the time stands for the inputs. Relative to its value y_0 at
//! the beginning of a piece, w = y - y_0 is drawn to a target w* that the inputs move, at a rate r that they move too:
//!
//! ```text
//! w' = r (w* - w),   r = -df/dy,   w* = f(y_0, t) / r
//! dw/dq = w* - w,    q = integral of r
//! ```
//!
//! With w* quadratic in q through the beginning, the middle and the end of a piece this is solved exactly: so are a
//! bristle that follows a moving level, however stiff it is, and the work of its force. Where f is not linear in y, r
//! is the slope of the chord to the approximate new value of y.

use crate::model::row::{view, view_mut};
use crate::model::{Meaning, Model, Role, Table, Variable, column_of, is_for_exchange, row_of, row_of_mut};
use crate::number::elementary::{exp, exp_m1, pow, square};

/// Error allowed in a piece, relative to the larger of the state and its nominal value (chosen). It is the error of a
/// target taken as linear; that of a quadratic one is far smaller.
const TOLERANCE: f64 = 5e-4;

/// Shortest piece, relative to the interval from one kink to the next (chosen), so that the time of a step is bounded.
const SHORTEST: f64 = 1.0 / 128.0;

/// Distance from the ends of a piece at which derivatives are taken, in parts of it (chosen): many laws have kinks at
/// the ends.
const INSIDE: f64 = 1e-9;

/// Columns of a table.
struct Selection<const MOST: usize> {
    columns: [usize; MOST],
    count: usize,
}

impl<const MOST: usize> Selection<MOST> {
    const NONE: Selection<MOST> = Selection { columns: [0; MOST], count: 0 };

    const fn with(mut self, column: usize) -> Self {
        self.columns[self.count] = column;
        self.count += 1;
        self
    }

    fn iter(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        self.columns[..self.count].iter().copied()
    }
}

/// Number of pieces with held inputs into which a step with slopes is divided (chosen).
pub(crate) const PIECES: u32 = 16;

/// Largest number of inputs.
const MOST_INPUTS: usize = 24;

/// Largest number of states, the energy excluded.
const MOST: usize = 2;

/// Whether the variable is a continuous state, the energy excluded.
const fn is_followed(variable: &Variable) -> bool {
    variable.is_continuous_state()
        && !(matches!(variable.meaning, Meaning::Energy) && variable.path.segments().len() == 1)
}

/// Columns of a model used here.
struct Columns {
    table: Table,
    inputs: Selection<MOST_INPUTS>,
    /// Continuous states of a model with rates, the energy excluded.
    states: Selection<MOST>,
    /// Number of continuous states, the energy excluded.
    count: usize,
    energy: Option<usize>,
    velocity: Option<usize>,
    normal_force: Option<usize>,
    plane: Option<[usize; 2]>,
}

impl Columns {
    const fn of(table: Table, declared: &[Variable], has_rates: bool) -> Columns {
        let (mut inputs, mut states, mut count, mut column) = (Selection::NONE, Selection::NONE, 0, 0);
        while column < declared.len() {
            let is_state = is_followed(&declared[column]);
            if is_state && has_rates && count < MOST {
                states = states.with(column);
            }
            count += is_state as usize;
            if matches!(declared[column].role, Role::Input) {
                inputs = inputs.with(column);
            }
            column += 1;
        }
        let [energy, normal_force] = [column_of(declared, Meaning::Energy), column_of(declared, Meaning::NormalForce)];
        let (velocity, plane) = match (column_of(declared, Meaning::Velocity), column_of(declared, Meaning::VelocityY))
        {
            (Some(x), Some(y)) => (None, Some([x, y])),
            (along, _) => (along, None),
        };
        Columns { table, inputs, states, count, energy, velocity, normal_force, plane }
    }

    const fn has_states(&self) -> bool {
        self.count > 0
    }

    fn is_unloaded(&self, row: &[f64]) -> bool {
        self.normal_force.is_some_and(|column| row[column] == 0.0)
    }

    /// Sets the inputs to their values at a time after that of the `first` ones.
    fn set_inputs(&self, row: &mut [f64], first: impl Iterator<Item = f64>, slope: &[f64], time: f64) {
        for (column, first) in self.inputs.iter().zip(first) {
            let change = slope[column] * time;
            let value = first + change;
            // By rounding, a ramp to a bound may end beyond it, and a ramp to zero may miss it.
            let is_rounding = value.abs() <= 4.0 * f64::EPSILON * change.abs();
            row[column] = if is_rounding { 0.0 } else { self.table.bound(column).nearest(value) };
        }
    }
}

/// The inputs of a model at the beginning of a step, in the order of its table. The stack of a host may be small, and the
/// row of a model long.
pub(crate) struct Inputs([f64; MOST_INPUTS]);

impl Inputs {
    pub(crate) fn of<M: Model>(model: &M) -> Inputs {
        let mut values = [0.0; MOST_INPUTS];
        Of::<M>::COLUMNS.inputs.iter().zip(&mut values).for_each(|(column, value)| *value = row_of(model)[column]);
        Inputs(values)
    }
}

/// Equations of a model on its row. What is done with them is not compiled again for each model.
struct Equations {
    columns: &'static Columns,
    is_linear: bool,
    kinks: fn(&[f64]) -> [f64; 2],
    step: fn(&mut [f64], f64),
    power: fn(&[f64]) -> f64,
    /// Rates of the states, and the chord; none for a model that has no rates.
    rates: fn(&[f64]) -> [f64; MOST],
    chord: fn(&mut [f64], [f64; MOST]) -> Chord,
}

/// Of a model.
struct Of<M>(std::marker::PhantomData<M>);

impl<M: Model> Of<M> {
    const COLUMNS: &'static Columns = &Columns::of(M::COLUMNS, M::TABLE, is_for_exchange::<M>());

    const HAS_FEW_STATES: bool = Self::COLUMNS.count <= MOST;

    const HAS_CHORDS: bool = is_for_exchange::<M>() && Self::COLUMNS.has_states() && Self::HAS_FEW_STATES;

    const EQUATIONS: &'static Equations = &Equations {
        columns: Self::COLUMNS,
        is_linear: M::LINEAR,
        kinks: |row| view::<M, f64>(row).kinks(),
        step: |row, dt| view_mut::<M, f64>(row).step(dt),
        power: |row| power(row_of(&rate(view::<M, f64>(row))), Self::COLUMNS),
        rates: if Self::HAS_CHORDS {
            |row| rates(row_of(&rate(view::<M, f64>(row))), Self::COLUMNS)
        } else {
            |_| [0.0; MOST]
        },
        chord: if Self::HAS_CHORDS {
            |row, guess| Chord::at(view_mut::<M, f64>(row), guess)
        } else {
            |_, _| Chord::NONE
        },
    };
}

/// The rate of the energy among all rates.
fn power(rate: &[f64], columns: &Columns) -> f64 {
    columns.energy.map_or(0.0, |energy| rate[energy])
}

/// The rates of the states among all rates.
fn rates(rate: &[f64], columns: &Columns) -> [f64; MOST] {
    let mut rates = [0.0; MOST];
    for (index, column) in columns.states.iter().enumerate() {
        rates[index] = rate[column];
    }
    rates
}

/// A row that moves along a ramp of its inputs, and its beginning.
struct Ramp<'a> {
    of: &'static Equations,
    row: &'a mut [f64],
    begin: &'a [f64],
    slope: &'a [f64],
}

/// Advances `model` by `dt` while its inputs change at the rates `slope`.
pub(crate) fn advance<M: Model>(model: &mut M, slope: &M, dt: f64) {
    const { assert!(!is_for_exchange::<M>() || Of::<M>::HAS_FEW_STATES, "too many states") };
    let begin = *model;
    let mut ramp = Ramp { of: Of::<M>::EQUATIONS, row: row_of_mut(model), begin: row_of(&begin), slope: row_of(slope) };
    if Of::<M>::COLUMNS.has_states() && !is_for_exchange::<M>() {
        // Rates do not describe a model whose states jump.
        ramp.in_pieces(dt, PIECES);
    } else {
        ramp.advance(dt);
    }
}

/// Advances `model` by `dt`, from one kink to the next, in equal pieces with the inputs held at their values in the
/// middle: a method of second order, for laws whose states act on each other.
pub(crate) fn in_pieces<M: Model>(model: &mut M, slope: &M, dt: f64, count: u32) {
    let begin = *model;
    let (row, begin, slope) = (row_of_mut(model), row_of(&begin), row_of(slope));
    Ramp { of: Of::<M>::EQUATIONS, row, begin, slope }.in_pieces(dt, count);
}

impl Ramp<'_> {
    fn advance(&mut self, dt: f64) {
        let columns = self.of.columns;
        let mut from = 0.0;
        while from < dt {
            let to = self.next_kink(from, dt);
            self.set_inputs(0.5 * (from + to));
            if columns.is_unloaded(self.row) {
                // A step releases an unloaded contact.
                (self.of.step)(self.row, to - from);
            } else if columns.has_states() {
                self.smooth(from, to);
            } else if let Some(energy) = columns.energy {
                self.row[energy] += self.quadrature([from, to], &self.of.power);
            }
            from = to;
        }
        self.set_inputs(dt);
        if columns.is_unloaded(self.row) {
            // An unloaded contact is released; a solver only approaches that.
            (self.of.step)(self.row, f64::MIN_POSITIVE);
        }
    }

    /// Advances from one kink to the next, in equal pieces with the inputs held at their values in the middle.
    fn in_pieces(&mut self, dt: f64, count: u32) {
        let mut from = 0.0;
        while from < dt {
            let to = self.next_kink(from, dt);
            let h = (to - from) / f64::from(count);
            for piece in 0..count {
                self.set_inputs(from + (f64::from(piece) + 0.5) * h);
                (self.of.step)(self.row, h);
            }
            from = to;
        }
        self.set_inputs(dt);
    }

    fn set_inputs(&mut self, time: f64) {
        let columns = self.of.columns;
        columns.set_inputs(self.row, columns.inputs.iter().map(|column| self.begin[column]), self.slope, time);
    }

    /// Integral of a power, for a row of which only the inputs move.
    fn integral(&mut self, dt: f64, power: &dyn Fn(&[f64]) -> f64) -> f64 {
        let (mut from, mut sum) = (0.0, 0.0);
        while from < dt {
            let to = self.next_kink(from, dt);
            sum += self.quadrature([from, to], power);
            from = to;
        }
        sum
    }

    /// The same over an interval without kinks.
    fn quadrature(&mut self, [from, to]: [f64; 2], power: &dyn Fn(&[f64]) -> f64) -> f64 {
        let mut at = |share: f64| {
            self.set_inputs(from + share * (to - from));
            power(self.row)
        };
        let ends = [at(INSIDE), at(0.5), at(1.0 - INSIDE)];
        boole(&mut at, [0.0, 1.0], ends, HALVINGS) * (to - from)
    }

    /// First instant after `from` at which an input changes sign, where most laws have a kink, or at which the velocity
    /// passes another kink of the law. Further cuts near rest: a long interval would miss what a law without memory does
    /// there.
    fn next_kink(&self, from: f64, dt: f64) -> f64 {
        let (columns, begin, slope) = (self.of.columns, self.begin, self.slope);
        let mut next = dt;
        let mut cut = |time: f64| {
            if time > from && time < next {
                next = time;
            }
        };
        if let Some(plane) = columns.plane {
            // In a plane, the velocity passes rest at a distance.
            let [v, a] = [begin, slope].map(|row| plane.map(|column| row[column]));
            cut(-(v[0] * a[0] + v[1] * a[1]) / (a[0] * a[0] + a[1] * a[1]));
        }
        let mut passes = |column: usize, level: f64| {
            let rate = slope[column];
            if rate != 0.0 {
                cut((level - begin[column]) / rate);
            }
        };
        for column in columns.inputs.iter().filter(|column| columns.plane.is_none_or(|plane| !plane.contains(column))) {
            passes(column, 0.0);
        }
        let load_moves = columns.normal_force.is_some_and(|column| slope[column] != 0.0);
        if let Some(column) = columns.velocity {
            let (first, rate) = (begin[column], slope[column]);
            let largest = first.abs().max((first + rate * dt).abs());
            let cuts: &[f64] = match (columns.has_states(), load_moves) {
                (false, _) => &NEAR_REST,
                // Starting from rest, distance grows with the square of time, so a moving load varies with the square root
                // of distance.
                (_, true) => &[0.25],
                (_, false) => &[],
            };
            for part in cuts {
                passes(column, part * largest);
                passes(column, -part * largest);
            }
        }
        for speed in (self.of.kinks)(begin).into_iter().filter(|speed| *speed > 0.0) {
            columns.velocity.into_iter().for_each(|column| [speed, -speed].into_iter().for_each(|v| passes(column, v)));
        }
        next
    }

    /// Advances over an interval in which the law is smooth.
    fn smooth(&mut self, from: f64, to: f64) {
        let shortest = SHORTEST * (to - from);
        let (mut at, mut length, mut known) = (from, to - from, UNKNOWN);
        let mut most = MOST_GROWTH;
        while at < to {
            // A remainder hardly longer than the piece is taken in one.
            let end = if at + 1.01 * length >= to { to } else { at + length };
            length = end - at;
            let chords = self.chords([at, end], known);
            let change = self.change(&chords, length);
            let is_accurate = change.error <= 1.0;
            if is_accurate {
                self.apply(&change);
                if end == to {
                    return;
                }
                known = known_beyond(&chords, &change, self.of.is_linear);
                at = end;
            } else if length > 2.0 * shortest {
                known = known_of_half(&chords, self.of.is_linear);
            } else {
                // A piece that cannot be divided further, as where the load vanishes, is a held step with its middle
                // inputs, which is always stable.
                self.set_inputs(0.5 * (at + end));
                (self.of.step)(self.row, length);
                known = UNKNOWN;
                at = end;
            }
            // A rejected piece is at least halved, so that the shortest is always reached, and exactly halved if its half
            // is known already. After a rejection, the next piece is not longer than the accurate one.
            let limits = match (is_accurate, self.of.is_linear) {
                (true, _) => [0.2, most],
                (false, true) => [0.5, 0.5],
                (false, false) => [0.2, 0.5],
            };
            length = shortest.max(length * growth(change.error, limits));
            most = if is_accurate { MOST_GROWTH } else { 1.0 };
        }
    }

    /// Chords of a piece. Computing an unknown one leaves the row with the inputs of its instant.
    fn chords(&mut self, [from, to]: [f64; 2], known: Known) -> Nodes<Chord> {
        let h = to - from;
        let mut at = |time: f64, guess: [f64; MOST]| {
            self.set_inputs(time);
            (self.of.chord)(self.row, guess)
        };
        let first = known[0].unwrap_or_else(|| at(from + INSIDE * h, [0.0; MOST]));
        let middle = known[1].unwrap_or_else(|| at(from + 0.5 * h, first.guess(0.5 * h)));
        let last = known[2].unwrap_or_else(|| at(to - INSIDE * h, first.guess(h)));
        [first, middle, last]
    }

    fn change(&mut self, chords: &Nodes<Chord>, h: f64) -> Change {
        let [first, middle, last] = chords;
        let columns = self.of.columns;
        let mut work = simpson([first.power, middle.power, last.power], h);
        let (mut states, mut errors) = ([0.0; MOST], [0.0; MOST]);
        for index in 0..columns.states.count {
            let nodes = |of: fn(&Chord) -> &[f64; MOST]| [of(first)[index], of(middle)[index], of(last)[index]];
            let drawn = Drawn::new(nodes(|chord| &chord.rate), nodes(|chord| &chord.pull), h);
            work += drawn.integral(nodes(|chord| &chord.power_by));
            (states[index], errors[index]) = (drawn.change[2], drawn.error);
        }
        let missed = if self.of.is_linear { [0.0; MOST] } else { self.missed(last, &states, h) };
        let mut error = 0f64;
        for (index, column) in columns.states.iter().enumerate() {
            let value = (self.row[column] + states[index]).abs();
            let off = (errors[index] + missed[index].abs()) / value.max(columns.table.nominal(column));
            // f64::max ignores NaN.
            error = if off.is_finite() { error.max(off) } else { f64::INFINITY };
            states[index] += missed[index];
        }
        Change { states, work, error: error / TOLERANCE }
    }

    fn apply(&mut self, change: &Change) {
        let columns = self.of.columns;
        for (index, column) in columns.states.iter().enumerate() {
            // The state may exceed its bound by less than the tolerance.
            self.row[column] = columns.table.bound(column).nearest(self.row[column] + change.states[index]);
        }
        if let Some(energy) = columns.energy {
            self.row[energy] += change.work;
        }
    }

    /// Deviation of a nonlinear law from the changes along its last chord; it begins with the square of the time.
    fn missed(&mut self, last: &Chord, change: &[f64; MOST], h: f64) -> [f64; MOST] {
        let states = self.of.columns.states.iter().enumerate();
        let (mut before, mut missed) = ([0.0; MOST], [0.0; MOST]);
        for (index, column) in states.clone() {
            before[index] = self.row[column];
            self.row[column] += change[index];
        }
        let reached = (self.of.rates)(self.row);
        for (index, column) in states {
            self.row[column] = before[index];
            let on_chord = last.rate[index] - last.pull[index] * change[index];
            missed[index] = h * (reached[index] - on_chord) / (3.0 + (h * last.pull[index]).max(0.0));
        }
        missed
    }
}

/// Integral of a power over a ramp.
pub(crate) fn integral<M: Model>(begin: &M, slope: &M, dt: f64, power: impl Fn(&M) -> f64) -> f64 {
    let mut trial = *begin;
    let (row, begin, slope) = (row_of_mut(&mut trial), row_of(begin), row_of(slope));
    Ramp { of: Of::<M>::EQUATIONS, row, begin, slope }.integral(dt, &|row| power(view::<M, f64>(row)))
}

/// Limit of how often an interval between two kinks is halved (chosen), so that the time of a step is bounded.
const HALVINGS: u32 = 5;

/// Difference of the two rules, relative to the integral, above which an interval is divided (chosen). The error of
/// Boole's rule is far smaller.
const DIVIDED_FROM: f64 = 1e-5;

/// Boole's rule on an interval, which is halved as long as Simpson's rules on the halves and on the whole differ.
fn boole(at: &mut dyn FnMut(f64) -> f64, [from, to]: [f64; 2], [a, c, e]: Nodes<f64>, halvings: u32) -> f64 {
    let (middle, length) = (0.5 * (from + to), to - from);
    let (b, d) = (at(0.5 * (from + middle)), at(0.5 * (middle + to)));
    let whole = simpson([a, c, e], length);
    let halves = simpson([a, b, c], 0.5 * length) + simpson([c, d, e], 0.5 * length);
    let difference = halves - whole;
    if halvings == 0 || difference.abs() <= DIVIDED_FROM * halves.abs() {
        return halves + difference / 15.0;
    }
    boole(at, [from, middle], [a, b, c], halvings - 1) + boole(at, [middle, to], [c, d, e], halvings - 1)
}

/// Speeds near rest at which an interval is cut, in parts of the largest speed (chosen).
const NEAR_REST: [f64; 2] = [1.0 / 8.0, 1.0 / 64.0];

/// Largest ratio of the lengths of a piece and the one before it (as usual in step-size control).
const MOST_GROWTH: f64 = 4.0;

/// Ratio of the lengths of the next piece and this one, for an error of order 2 and the usual safety factor.
fn growth(error: f64, [least, most]: [f64; 2]) -> f64 {
    // An infinite error gives the lower limit.
    (0.8 / pow(error, 1.0 / 3.0)).min(most).max(least)
}

/// Beginning, middle and end of a piece.
type Nodes<T> = [T; 3];

/// Simpson's rule on the interval of length `h`.
fn simpson([begin, middle, end]: Nodes<f64>, h: f64) -> f64 {
    h / 6.0 * (begin + 4.0 * middle + end)
}

/// Chords at the nodes of a piece, as far as they are known in advance.
type Known = Nodes<Option<Chord>>;

const UNKNOWN: Known = [None; 3];

/// Chords of the piece after an accepted one.
fn known_beyond(chords: &Nodes<Chord>, change: &Change, is_linear: bool) -> Known {
    [is_linear.then(|| chords[2].moved(&change.states)), None, None]
}

/// Chords of the first half of a rejected piece. A chord of a nonlinear law spans the length of its piece.
fn known_of_half([first, middle, _]: &Nodes<Chord>, is_linear: bool) -> Known {
    [Some(*first), None, is_linear.then_some(*middle)]
}

/// Changes over a piece.
struct Change {
    states: [f64; MOST],
    work: f64,
    /// In units of the tolerance.
    error: f64,
}

/// Time derivatives of the states.
// Inlined, so that terms depending only on the inputs are computed once for all rates of a chord.
#[inline(always)]
fn rate<M: Model>(model: &M) -> M {
    let mut rate = *model;
    row_of_mut(&mut rate).fill(0.0);
    model.rate(&mut rate);
    rate
}

/// Change of a state over a piece, drawn towards a target.
#[derive(Clone, Copy)]
struct Drawn {
    /// At the nodes.
    change: Nodes<f64>,
    error: f64,
    h: f64,
    /// r at the nodes.
    pulls: Nodes<f64>,
    /// q at middle and end, and the target at the nodes, if the pull is strong.
    strong: Option<([f64; 2], Nodes<f64>)>,
}

/// Largest q at the end of a piece with a weak pull (chosen): the exponential is smooth enough for Simpson's rule.
const WEAK: f64 = 0.1;

/// Up to this q over half a piece (chosen) a draw that is absent from part of the piece is followed as a weak one.
const STEEP: f64 = 2.0;

impl Drawn {
    const NONE: Drawn = Drawn { change: [0.0; 3], error: 0.0, h: 0.0, pulls: [0.0; 3], strong: None };

    /// From the rate f(y_0, t) and the pull r at the nodes.
    fn new(rates: Nodes<f64>, pulls: Nodes<f64>, h: f64) -> Drawn {
        let [r_0, r_1, r_2] = pulls;
        let drawn = Drawn { h, pulls, ..Drawn::NONE };
        let q = [h / 24.0 * (5.0 * r_0 + 8.0 * r_1 - r_2), simpson(pulls, h)];
        if q[1] <= WEAK || !pulls.iter().all(|pull| *pull > 0.0) {
            return drawn.weakly(rates);
        }
        let targets = [rates[0] / r_0, rates[1] / r_1, rates[2] / r_2];
        if q[0] > 0.0 && q[0] < q[1] {
            return drawn.strongly(q, targets);
        }
        // The pull is not a parabola: it grows without limit where the load vanishes.
        let q = [0.25 * h * (r_0 + r_1), 0.25 * h * (r_0 + 2.0 * r_1 + r_2)];
        Drawn { error: f64::MAX, ..drawn.strongly(q, targets) }
    }

    fn weakly(self, rates: Nodes<f64>) -> Drawn {
        let [r_0, r_1, r_2] = self.pulls;
        // Decay, until the end, of the contributions of beginning and middle.
        let (first, second) = (-0.25 * self.h * (r_0 + r_1), -0.25 * self.h * (r_1 + r_2));
        let middle = self.h / 24.0 * (5.0 * rates[0] * exp(first) + 8.0 * rates[1] - rates[2] * exp(-second));
        let weighted = [rates[0] * exp(first + second), rates[1] * exp(second), rates[2]];
        let end = simpson(weighted, self.h);
        let error = (end - 0.5 * self.h * (weighted[0] + weighted[2])).abs();
        // A draw that sets in within the piece, as at the end of elastic motion, may be too strong for these rules: its
        // change at the middle would have no limit.
        let error = if first.min(second) < -STEEP { f64::MAX } else { error };
        Drawn { change: [0.0, middle, end], error, ..self }
    }

    fn strongly(self, q: [f64; 2], targets: Nodes<f64>) -> Drawn {
        let [c_0, c_1, c_2] = parabola(q, targets);
        let [at_middle, at_end] = q.map(|q| phi(-q));
        let change = |q: f64, [one, two, three]: [f64; 3]| q * (c_0 * one + q * (c_1 * two + 2.0 * q * c_2 * three));
        let (middle, end) = (change(q[0], at_middle), change(q[1], at_end));
        let trapezoid = 0.5 * self.h * (self.pulls[0] + self.pulls[2]);
        // Errors of a target and of a pull that are taken as linear between the ends.
        let [_, two, three] = at_end;
        let error =
            (c_2 * (q[1] * square(q[1])) * (2.0 * three - two)).abs() + ((targets[2] - end) * (q[1] - trapezoid)).abs();
        Drawn { change: [0.0, middle, end], error, strong: Some((q, targets)), ..self }
    }

    /// Integral over time of the change times a weight given at the nodes.
    fn integral(&self, weight: Nodes<f64>) -> f64 {
        let [_, middle, end] = self.change;
        let Some((q, targets)) = self.strong else {
            return simpson([0.0, weight[1] * middle, weight[2] * end], self.h);
        };
        // With k = weight / r, by parts: integral of k w dq = integral of k w* dq - [k w] + integral of k' w dq.
        let per_pull: Nodes<f64> = std::array::from_fn(|node| weight[node] / self.pulls[node]);
        let product = |by: Nodes<f64>| area(q, std::array::from_fn(|node| by[node] * targets[node]));
        let [_, k_1, k_2] = parabola(q, per_pull);
        let sum = product([1.0; 3]) - end;
        let moment = product([0.0, q[0], q[1]]) - q[1] * end + sum;
        product(per_pull) - per_pull[2] * end + k_1 * sum + 2.0 * k_2 * moment
    }
}

/// Coefficients of the parabola through the values at 0 and at the two q.
fn parabola([middle, end]: [f64; 2], [a, b, c]: Nodes<f64>) -> [f64; 3] {
    let first = (b - a) / middle;
    let second = ((c - b) / (end - middle) - first) / end;
    [a, first - second * middle, second]
}

/// Integral of that parabola up to the second q.
fn area(q: [f64; 2], values: Nodes<f64>) -> f64 {
    let [c_0, c_1, c_2] = parabola(q, values);
    q[1] * (c_0 + q[1] * (0.5 * c_1 + q[1] / 3.0 * c_2))
}

/// Equations of a model at an instant, for the states at the beginning of a piece, and the chord to their approximate
/// new values.
#[derive(Clone, Copy)]
struct Chord {
    /// f(y_0, t).
    rate: [f64; MOST],
    /// r, the decrease of the rate of a state with the state itself.
    pull: [f64; MOST],
    power: f64,
    power_by: [f64; MOST],
}

/// Smallest change of a state over which a chord is taken, relative to the larger of its value and its nominal value
/// (chosen), to keep enough digits.
const SHORTEST_CHORD: f64 = 1e-5;

impl Chord {
    const NONE: Chord = Chord { rate: [0.0; MOST], pull: [0.0; MOST], power: 0.0, power_by: [0.0; MOST] };

    fn at<M: Model>(model: &mut M, guess: [f64; MOST]) -> Chord {
        let (columns, mut chord, here) = (Of::<M>::COLUMNS, Chord::NONE, rate(model));
        let energy = |rate: &M| power(row_of(rate), columns);
        chord.power = energy(&here);
        for (index, column) in columns.states.iter().enumerate() {
            let value = row_of(model)[column];
            let shortest = SHORTEST_CHORD * value.abs().max(columns.table.nominal(column));
            let reach = if guess[index].abs() > shortest { guess[index] } else { shortest };
            row_of_mut(model)[column] = value + reach;
            let there = rate(model);
            row_of_mut(model)[column] = value;
            chord.rate[index] = row_of(&here)[column];
            chord.pull[index] = (row_of(&here)[column] - row_of(&there)[column]) / reach;
            chord.power_by[index] = (energy(&there) - energy(&here)) / reach;
        }
        chord
    }

    /// Change of the states within a time, by an implicit step, which is a good and stable guess.
    fn guess(&self, time: f64) -> [f64; MOST] {
        std::array::from_fn(|index| time * self.rate[index] / (1.0 + (time * self.pull[index]).max(0.0)))
    }

    /// Chord at the same instant for changed states.
    fn moved(mut self, change: &[f64; MOST]) -> Chord {
        for (index, change) in change.iter().enumerate() {
            self.rate[index] -= self.pull[index] * change;
            self.power += self.power_by[index] * change;
        }
        self
    }
}

/// phi_1, phi_2 and phi_3 of x: `phi_0 = e^x`, `phi_k = (phi_(k-1) - 1 / (k - 1)!) / x`.
pub(crate) fn phi(x: f64) -> [f64; 3] {
    if x.abs() < 0.5 {
        // Horner's form of the series sum x^n / (n + 3)!; the remainder is below rounding.
        let three = (1..=11).rev().fold(1.0, |sum, n| 1.0 + x * sum / f64::from(n + 3)) / 6.0;
        let two = 0.5 + x * three;
        return [1.0 + x * two, two, three];
    }
    let one = exp_m1(x) / x;
    let two = (one - 1.0) / x;
    [one, two, (two - 0.5) / x]
}

/// Sets the inputs to their values at a time after `begin`.
pub(crate) fn set_inputs<M: Model>(model: &mut M, begin: &Inputs, slope: &M, time: f64) {
    Of::<M>::COLUMNS.set_inputs(row_of_mut(model), begin.0.iter().copied(), row_of(slope), time);
}

/// Slopes of inputs that do not move.
pub(crate) fn held_inputs<M: Model>(model: &M) -> M {
    let mut slope = *model;
    for column in Of::<M>::COLUMNS.inputs.iter() {
        row_of_mut(&mut slope)[column] = 0.0;
    }
    slope
}
