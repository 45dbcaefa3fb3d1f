//! The clocks of force and motion: delay and drift of a camera against a load cell.

use nalgebra::{SMatrix, SVector};
use stribeck::number::Real;

use crate::statistics::extremes;

/// Clock of the motion against that of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clocks {
    /// Delay in the middle of the record, s: the motion at time t + delay belongs to the force at t.
    pub delay: f64,
    /// Standard deviation of the delay, s; 0 if it was given.
    pub deviation: f64,
    /// Change of the delay per second.
    pub drift: f64,
    /// Middle of the record, s.
    pub middle: f64,
}

impl Clocks {
    /// Clocks with a known delay and no drift.
    pub fn known(delay: f64) -> Clocks {
        Clocks { delay, deviation: 0.0, drift: 0.0, middle: 0.0 }
    }

    /// Converts a time of the force to the clock of the motion, s.
    pub fn of_motion(&self, time: f64) -> f64 {
        time + self.delay + self.drift * (time - self.middle)
    }

    /// Converts times of the motion to the clock of the force, s.
    pub(crate) fn ends(&self, of_motion: [f64; 2]) -> [f64; 2] {
        of_motion.map(|time| (time - self.delay + self.drift * self.middle) / (1.0 + self.drift))
    }
}

/// The range middle +- half.
pub(crate) fn range_around(middle: f64, half: f64) -> [f64; 2] {
    [middle - half, middle + half]
}

/// Delays on each side of 0 in the coarse search (chosen).
const COARSE: i32 = 40;

/// Halvings of the step of a search.
const HALVINGS: usize = 12;

/// Force and motion, each on its own clock.
pub(crate) struct Pair<'a> {
    time: &'a [f64],
    force: &'a [f64],
    /// Samples of the force that are used.
    chosen: Vec<usize>,
    /// Even grid on the clock of the motion, and the regressors there.
    begin: f64,
    step: f64,
    terms: Vec<[f64; TERMS]>,
}

/// Most samples of the force that are used, and points of the grid (chosen).
const MOST_SAMPLES: usize = 4000;
const POINTS: usize = 8000;

/// Speeds, relative to the largest one, and displacements, relative to the travel, within which friction reverses
/// (chosen): regularised laws and bristles of any stiffness.
const SPEEDS: [f64; 2] = [3e-3, 3e-2];
const DISPLACEMENTS: [f64; 3] = [3e-3, 2e-2, 0.1];

/// Regressors of the force: offset, velocity, acceleration, friction of each displacement and speed.
const TERMS: usize = 3 + SPEEDS.len() + DISPLACEMENTS.len();

/// Regressors along a motion.
struct Regressors {
    /// Largest speed, m/s, and acceleration, m/s2.
    fastest: f64,
    steepest: f64,
    /// Range of the displacement, m.
    travel: f64,
    /// Displacement of the point before, m.
    before: f64,
    /// Friction of each displacement, relative to its steady level.
    hysteresis: [f64; DISPLACEMENTS.len()],
}

impl Regressors {
    fn new(motion: &[[f64; 3]]) -> Regressors {
        let largest = |number: usize| motion.iter().map(|all| all[number].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let [low, high] = extremes(motion.iter().map(|all| all[0]));
        let hysteresis = [0.0; DISPLACEMENTS.len()];
        Regressors { fastest: largest(1), steepest: largest(2), travel: high - low, before: motion[0][0], hysteresis }
    }

    /// Regressors at the next point.
    fn next(&mut self, [x, v, a]: &[f64; 3]) -> [f64; TERMS] {
        let change = x - self.before;
        self.before = *x;
        let mut terms = [1.0; TERMS];
        [terms[1], terms[2]] = [v / self.fastest, a / self.steepest];
        for ((state, width), term) in self.hysteresis.iter_mut().zip(DISPLACEMENTS).zip(&mut terms[3..]) {
            // Exact for dz = dx (1 - sgn(dx) z) / width.
            let steady = if change == 0.0 { *state } else { change.signum() };
            *state = steady + (*state - steady) * Real::exp(-change.abs() / (width * self.travel));
            *term = *state;
        }
        for (speed, term) in SPEEDS.iter().zip(&mut terms[3 + DISPLACEMENTS.len()..]) {
            *term = Real::tanh(v / (speed * self.fastest));
        }
        terms
    }
}

impl<'a> Pair<'a> {
    /// `motion`: displacement, velocity and acceleration at a time between `begin` and `end`.
    pub fn new(
        time: &'a [f64],
        force: &'a [f64],
        [begin, end]: [f64; 2],
        motion: &dyn Fn(f64) -> [f64; 3],
    ) -> Pair<'a> {
        let step = (end - begin) / (POINTS - 1) as f64;
        let sampled: Vec<[f64; 3]> = (0..POINTS).map(|at| motion(begin + step * at as f64)).collect();
        let mut regressors = Regressors::new(&sampled);
        let terms = sampled.iter().map(|point| regressors.next(point)).collect();
        let chosen = (0..time.len()).step_by(time.len().div_ceil(MOST_SAMPLES)).collect();
        Pair { time, force, chosen, begin, step, terms }
    }

    /// Regressors at a time on the clock of the motion, by linear interpolation.
    fn at(&self, time: f64) -> SVector<f64, TERMS> {
        let position = ((time - self.begin) / self.step).clamp(0.0, (self.terms.len() - 1) as f64);
        let left = (position as usize).min(self.terms.len() - 2);
        let share = position - left as f64;
        let [low, high] = [left, left + 1].map(|at| SVector::from(self.terms[at]));
        low * (1.0 - share) + high * share
    }

    /// Sum of the squared residuals of the regression of the force.
    pub fn residual(&self, clocks: &Clocks) -> f64 {
        let (mut gram, mut right) = (SMatrix::<f64, TERMS, TERMS>::identity() * 1e-9, SVector::<f64, TERMS>::zeros());
        let mut total = 0.0;
        for at in &self.chosen {
            let terms = self.at(clocks.of_motion(self.time[*at]));
            gram += terms * terms.transpose();
            right += terms * self.force[*at];
            total += self.force[*at] * self.force[*at];
        }
        gram.cholesky().map_or(f64::INFINITY, |gram| total - right.dot(&gram.solve(&right)))
    }

    /// Estimates delay, at most `longest`, and drift, at most a tenth of that over the record: those with which the motion
    /// best explains the force as a sum of inertia, hysteretic friction, viscous friction and offset.
    pub fn find(&self, longest: f64) -> Clocks {
        let (least, [delay, drift]) = self.minimum(longest);
        let apart = longest / f64::from(COARSE);
        let cost = |delay: f64| self.residual(&self.clocks([delay, drift]));
        let curvature = (cost(delay - apart) - 2.0 * least + cost(delay + apart)) / (apart * apart);
        let variance = least / self.chosen.len() as f64;
        let deviation = (2.0 * variance / curvature.max(f64::MIN_POSITIVE)).sqrt().min(longest);
        Clocks { deviation, ..self.clocks([delay, drift]) }
    }

    /// Clocks with a delay in the middle of the record.
    fn clocks(&self, [delay, drift]: [f64; 2]) -> Clocks {
        let [first, last] = [self.time[0], self.time[self.time.len() - 1]];
        Clocks { delay, deviation: 0.0, drift, middle: 0.5 * (first + last) }
    }

    /// Least residual, and delay and drift there: a coarse search of the delay, then a pattern search of both.
    fn minimum(&self, longest: f64) -> (f64, [f64; 2]) {
        let [first, last] = [self.time[0], self.time[self.time.len() - 1]];
        let cost = |point: [f64; 2]| (self.residual(&self.clocks(point)), point);
        let lower = |a: (f64, [f64; 2]), b: (f64, [f64; 2])| if b.0 < a.0 { b } else { a };
        let mut step = [longest / f64::from(COARSE), 0.1 * longest / (last - first)];
        let coarse = (-COARSE..=COARSE).map(|k| cost([f64::from(k) * step[0], 0.0]));
        let mut best = coarse.fold((f64::INFINITY, [0.0; 2]), lower);
        for _ in 0..HALVINGS {
            for number in [0, 1] {
                let neighbours = [-1.0, 1.0].map(|direction| {
                    let mut point = best.1;
                    point[number] += direction * step[number];
                    cost(point)
                });
                best = neighbours.into_iter().fold(best, lower);
            }
            step = step.map(|step| 0.5 * step);
        }
        best
    }
}
