//! The motion on the grid of output times.

use super::Equations;

/// Output times: multiples of an interval from the beginning of a run, and its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// First time.
    pub begin: f64,
    /// Last time.
    pub end: f64,
    /// Number of intervals.
    pub intervals: usize,
}

impl Grid {
    /// The output time of this number.
    #[inline]
    pub fn time(&self, number: usize) -> f64 {
        if number == self.intervals {
            return self.end;
        }
        self.begin + (self.end - self.begin) * (number as f64 / self.intervals as f64)
    }

    /// Number of output times.
    pub fn len(&self) -> usize {
        self.intervals + 1
    }

    /// Whether there are no output times; never.
    pub fn is_empty(&self) -> bool {
        false
    }
}

/// Output times whose states are computed together (chosen).
const BLOCK: usize = 128;

/// The states within a step.
pub(super) trait Course {
    /// The states at a fraction of the step.
    fn at(&self, fraction: f64, states: &mut [f64]);

    /// Writes the slopes of the states at the end of the step, times its length.
    fn end_slopes(&self, slopes: &mut [f64]);

    /// Writes the states at output times into their columns.
    fn fill(&self, times: &Times, columns: &mut [Vec<f64>]);
}

/// Output times within a step, as fractions of it.
pub(super) struct Times {
    /// Number of the first one.
    pub first: usize,
    /// Number of the one after the last.
    pub past: usize,
    /// Fraction between two of them.
    pub spacing: f64,
    /// Fraction of number 0.
    pub offset: f64,
}

impl Times {
    /// The fraction of a number.
    #[inline(always)]
    pub fn fraction(&self, number: usize) -> f64 {
        self.offset + self.spacing * number as f64
    }
}

/// A step and the motion within it.
pub(super) struct Piece<'a> {
    /// Time at which the step begins.
    pub begin: f64,
    /// Its length.
    pub length: f64,
    /// The states.
    pub course: &'a dyn Course,
    /// Fraction of the step to which the states at an event are to be found by the course.
    pub precision: f64,
}

/// States that are polynomials in the fraction of the step, lowest power first.
pub(super) type Polynomials<const N: usize> = [[f64; 5]; N];

impl<const N: usize> Course for Polynomials<N> {
    fn at(&self, fraction: f64, states: &mut [f64]) {
        for (state, coefficients) in states.iter_mut().zip(self) {
            *state = horner(coefficients, fraction);
        }
    }

    fn end_slopes(&self, slopes: &mut [f64]) {
        for (slope, [_, b, c, d, e]) in slopes.iter_mut().zip(self) {
            *slope = b + 2.0 * c + 3.0 * d + 4.0 * e;
        }
    }

    /// In blocks, one array after the other, so that the loops run in vector registers.
    fn fill(&self, times: &Times, columns: &mut [Vec<f64>]) {
        let mut fractions = [0.0; BLOCK];
        for from in (times.first..times.past).step_by(BLOCK) {
            let to = times.past.min(from + BLOCK);
            let fractions = &mut fractions[..to - from];
            for (number, fraction) in fractions.iter_mut().enumerate() {
                // Processors convert integers of 32 bits at once.
                *fraction = times.offset + times.spacing * (from as f64 + f64::from(number as u8));
            }
            for (column, coefficients) in columns.iter_mut().zip(self) {
                for (value, fraction) in column[from..to].iter_mut().zip(&*fractions) {
                    *value = horner(coefficients, *fraction);
                }
            }
        }
    }
}

#[inline(always)]
fn horner(c: &[f64; 5], x: f64) -> f64 {
    (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0]
}

/// The recorded motion: one array per state and per further value.
#[derive(Clone, Debug)]
pub struct Recorder {
    grid: Grid,
    filled: usize,
    /// The states at the output times.
    pub states: Vec<Vec<f64>>,
    /// The further values at the output times.
    pub values: Vec<Vec<f64>>,
    row: Vec<f64>,
    at: Vec<f64>,
}

impl Recorder {
    /// Room for the motion of these equations.
    pub fn new(grid: Grid, equations: &dyn Equations) -> Recorder {
        Recorder::of(grid, equations.states(), equations.recorded())
    }

    /// Room for a motion.
    pub fn of(grid: Grid, states: usize, values: usize) -> Recorder {
        Recorder {
            grid,
            filled: 0,
            states: vec![vec![0.0; grid.len()]; states],
            values: vec![vec![0.0; grid.len()]; values],
            row: vec![0.0; values],
            at: vec![0.0; states],
        }
    }

    /// All output times.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// The output times that have been recorded.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.filled).map(|number| self.grid.time(number))
    }

    /// Number of output times that have been recorded.
    pub fn len(&self) -> usize {
        self.filled
    }

    /// Whether nothing has been recorded.
    pub fn is_empty(&self) -> bool {
        self.filled == 0
    }

    /// Cuts the arrays down to what was recorded.
    pub fn finish(&mut self) {
        for column in self.states.iter_mut().chain(&mut self.values) {
            column.truncate(self.filled);
        }
    }

    /// Whether the next output time is at or before `time`.
    pub fn is_due(&self, time: f64) -> bool {
        self.filled < self.grid.len() && self.grid.time(self.filled) <= time
    }

    /// The next output time, if there is one.
    pub fn next(&self) -> Option<f64> {
        (self.filled < self.grid.len()).then(|| self.grid.time(self.filled))
    }

    /// Records the states at the next output time.
    pub fn point(&mut self, equations: &mut dyn Equations, states: &[f64]) -> Result<(), String> {
        for (column, value) in self.states.iter_mut().zip(states) {
            column[self.filled] = *value;
        }
        if !self.values.is_empty() {
            equations.record(self.grid.time(self.filled), states, &mut self.row)?;
            for (column, value) in self.values.iter_mut().zip(&self.row) {
                column[self.filled] = *value;
            }
        }
        self.filled += 1;
        Ok(())
    }

    /// Records the row of states and values at the next output time.
    pub fn row(&mut self, states: &[f64], values: &[f64]) {
        for (column, value) in self.states.iter_mut().zip(states) {
            column[self.filled] = *value;
        }
        for (column, value) in self.values.iter_mut().zip(values) {
            column[self.filled] = *value;
        }
        self.filled += 1;
    }

    /// Records the output times up to the end of a piece.
    pub(super) fn piece(&mut self, equations: &mut dyn Equations, piece: &Piece) -> Result<(), String> {
        let Grid { begin, end, intervals } = self.grid;
        let (first, past) = (self.filled, self.first_after(piece.begin + piece.length));
        if past <= first {
            return Ok(());
        }
        let spacing = (end - begin) / intervals as f64 / piece.length;
        let offset = (begin - piece.begin) / piece.length;
        piece.course.fill(&Times { first, past, spacing, offset }, &mut self.states);
        if self.values.is_empty() {
            self.filled = past;
            return Ok(());
        }
        for number in first..past {
            let mut at = std::mem::take(&mut self.at);
            for (value, column) in at.iter_mut().zip(&self.states) {
                *value = column[number];
            }
            let done = self.point(equations, &at);
            self.at = at;
            done?;
        }
        Ok(())
    }

    /// Number of the first output time after `time`.
    fn first_after(&self, time: f64) -> usize {
        let Grid { begin, end, intervals } = self.grid;
        if time >= end {
            return intervals + 1;
        }
        let guess = ((time - begin) / (end - begin) * intervals as f64).max(0.0) as usize;
        // The guess is off by one at most.
        let mut number = guess.saturating_sub(1).max(self.filled);
        while number <= intervals && self.grid.time(number) <= time {
            number += 1;
        }
        number
    }
}
