//! The past of quantities that laws follow a time lag later.
//!
//! A solver gives every step that it has made. What a law remembers of it is kept as polynomials over parts of the step,
//! so short that they agree with the motion itself between their nodes. No step is longer than the lag, so that a law only
//! asks for what is kept already. Where the quantity jumps, as a velocity of slip does where a contact breaks away, a new
//! stretch begins: a law reads the old one, extended beyond its end if need be, up to the event of a lag later. As long as
//! the quantity rests, its value at the beginning of the rest stands for all that follows, and steps may be longer.

use std::collections::VecDeque;

/// Nodes of a polynomial, evenly spaced.
const NODES: usize = 5;

/// Deviation of a polynomial from the quantity, in parts of its size or of its largest value at the nodes if that is
/// larger, up to which a piece is not divided (chosen). A difference of two velocities that is next to nothing has hardly
/// a digit that is not rounded: no division would bring a polynomial closer to it than to the velocities.
const CLOSE: f64 = 1e-12;

/// Most halvings of a step (chosen): the deviation falls by 32 with each.
const HALVINGS: u32 = 8;

/// Difference of two times, in parts of the lag, that counts as none (chosen).
const SLACK: f64 = 1e-9;

/// A polynomial in Newton's form over a time.
#[derive(Clone, Copy, Debug)]
struct Piece {
    stretch: u32,
    begin: f64,
    length: f64,
    differences: [f64; NODES],
}

impl Piece {
    /// Through values at the nodes.
    fn through(stretch: u32, begin: f64, length: f64, values: [f64; NODES]) -> Piece {
        let mut differences = values;
        for order in 1..NODES {
            for at in (order..NODES).rev() {
                differences[at] = (differences[at] - differences[at - 1]) / order as f64;
            }
        }
        Piece { stretch, begin, length, differences }
    }

    /// Value and slope at a time.
    fn at(&self, time: f64) -> (f64, f64) {
        let scale = (NODES - 1) as f64 / self.length;
        let u = (time - self.begin) * scale;
        let (mut value, mut slope) = (0.0, 0.0);
        for (node, difference) in self.differences.iter().enumerate().rev() {
            slope = value + slope * (u - node as f64);
            value = difference + value * (u - node as f64);
        }
        (value, slope * scale)
    }
}

/// What a part remembers, as far back as it may ask.
pub(super) struct Line {
    /// The part.
    pub part: usize,
    /// Column that holds the value of a lag ago.
    pub column: usize,
    /// The lag.
    pub lag: f64,
    /// The usual size of the quantity.
    size: f64,
    pieces: VecDeque<Piece>,
    /// Stretch that is read now.
    read: u32,
    /// Stretch that is written now.
    written: u32,
    /// Whether the quantity rests until the next event.
    rests: bool,
}

impl Line {
    /// Without a past, of a quantity of this size.
    pub fn new(part: usize, column: usize, lag: f64, size: f64) -> Line {
        Line { part, column, lag, size, pieces: VecDeque::new(), read: 0, written: 0, rests: false }
    }

    /// Difference of two times near this one that counts as none.
    pub fn slack(&self, time: f64) -> f64 {
        SLACK * self.lag + 8.0 * f64::EPSILON * time.abs()
    }

    /// Value and slope a lag before this time, if there is a past.
    pub fn at(&self, time: f64) -> Option<(f64, f64)> {
        let ago = time - self.lag;
        let reached = ago + self.slack(time);
        // No step ends where another stretch is to be read while the quantity rests.
        let read = if self.rests { self.next(time) } else { self.read };
        let first = self.pieces.partition_point(|piece| piece.stretch < read);
        let in_time = |piece: &&Piece| piece.stretch == read && piece.begin <= reached;
        let (mut found, mut rest) = (self.pieces.get(first)?, self.pieces.range(first + 1..));
        while let Some(later) = rest.next().filter(in_time) {
            found = later;
        }
        Some(found.at(ago))
    }

    /// Whether there is no past.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Whether the quantity rests until the next event.
    pub fn rests(&self) -> bool {
        self.rests
    }

    /// Forgets everything.
    pub fn forget(&mut self) {
        self.pieces.clear();
        self.rests = false;
    }

    /// Takes note of an event: the first one, or one that lets the quantity jump, or one after which it rests.
    pub fn pass(&mut self, time: f64, [before, now]: [f64; 2], rests: bool) {
        let jumps = before.to_bits() != now.to_bits();
        if self.pieces.is_empty() {
            self.push_constant(time - self.lag, before);
            self.read = self.written;
        }
        if jumps {
            self.written += 1;
        }
        if rests && (jumps || !self.rests) {
            self.push_constant(time, now);
        }
        self.rests = rests;
    }

    fn push_constant(&mut self, begin: f64, value: f64) {
        self.pieces.push_back(Piece::through(self.written, begin, self.lag, [value; NODES]));
    }

    /// Keeps a step, from the quantity at each fraction of it.
    pub fn keep(&mut self, begin: f64, end: f64, quantity: &mut dyn FnMut(f64) -> f64) {
        if self.rests {
            return;
        }
        self.divide([begin, end - begin], [0.0, 1.0], HALVINGS, quantity);
        let oldest = end - self.lag - self.slack(end);
        let is_old = |next: &Piece| next.begin <= oldest && next.stretch <= self.read;
        while self.pieces.get(1).is_some_and(is_old) {
            self.pieces.pop_front();
        }
    }

    /// Keeps a part of a step, which begins at a fraction of it. Fractions are exact, so that a motion that is known at the
    /// quarters of a step is asked for there.
    fn divide(&mut self, step: [f64; 2], [from, part]: [f64; 2], halvings: u32, quantity: &mut dyn FnMut(f64) -> f64) {
        let node = |at: f64| from + part * at / (NODES - 1) as f64;
        let values = std::array::from_fn(|at| quantity(node(at as f64)));
        let time = |fraction: f64| step[0] + step[1] * fraction;
        let piece = Piece::through(self.written, time(from), step[1] * part, values);
        let most = values.iter().fold(self.size, |most, value| most.max(value.abs()));
        // What is the same at all nodes to the last digit rests.
        let rests = values.iter().all(|value| *value == values[0]);
        let mut is_close = |at: f64| (piece.at(time(node(at))).0 - quantity(node(at))).abs() <= CLOSE * most;
        if halvings == 0 || rests || is_close(0.5) && is_close(3.5) {
            self.pieces.push_back(piece);
            return;
        }
        let half = 0.5 * part;
        self.divide(step, [from, half], halvings - 1, quantity);
        self.divide(step, [from + half, half], halvings - 1, quantity);
    }

    /// Whether the stretch that is read ends a lag before this time.
    pub fn is_due(&self, time: f64) -> bool {
        !self.rests && self.next(time) != self.read
    }

    /// Reads on in the stretch of a lag before this time.
    pub fn turn(&mut self, time: f64) {
        self.read = self.next(time);
    }

    /// The stretch that has begun a lag before this time.
    fn next(&self, time: f64) -> u32 {
        let reached = time - self.lag + self.slack(time);
        let begun = self.pieces.iter().take_while(|piece| piece.begin <= reached).last();
        begun.map_or(self.read, |piece| piece.stretch.max(self.read))
    }
}

/// Lags after an event up to which the motion is not as smooth as a method of order 5 takes it for, one derivative more
/// after each.
const GENERATIONS: u32 = 6;

/// Times at which steps must end: lags after events and kinks of inputs.
#[derive(Default)]
pub(super) struct Breaks(Vec<f64>);

impl Breaks {
    /// Takes note of an event or a kink. Those that this list has foretold have successors already.
    pub fn add(&mut self, time: f64, lines: &[Line]) {
        self.0.retain(|at| lines.iter().any(|line| *at >= time - line.slack(time)));
        for line in lines {
            let is_known = self.0.iter().any(|at| (at - time).abs() <= line.slack(time));
            if !is_known {
                self.0.extend((1..=GENERATIONS).map(|lags| time + f64::from(lags) * line.lag));
            }
        }
    }

    /// The end of the longest step from this time: infinite if all quantities rest.
    pub fn next(&self, time: f64, lines: &[Line]) -> f64 {
        if lines.iter().all(Line::rests) {
            return f64::INFINITY;
        }
        let slack = lines.iter().map(|line| line.slack(time)).fold(f64::INFINITY, f64::min);
        let longest = lines.iter().filter(|line| !line.rests()).map(|line| time + line.lag);
        self.0.iter().copied().filter(|at| *at > time + slack).chain(longest).fold(f64::INFINITY, f64::min)
    }
}
