//! Two clocks: that of the load cell and that of the camera.

use nalgebra::{SMatrix, SVector};
use stribeck::number::Real;

/// How far the motion is behind the force.
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
    /// Clocks of which the delay is known.
    pub fn known(delay: f64) -> Clocks {
        Clocks { delay, deviation: 0.0, drift: 0.0, middle: 0.0 }
    }

    /// The time on the clock of the motion.
    pub fn of_motion(&self, time: f64) -> f64 {
        time + self.delay + self.drift * (time - self.middle)
    }

    /// Times of the motion on the clock of the force.
    pub(super) fn ends(&self, of_motion: [f64; 2]) -> [f64; 2] {
        of_motion.map(|time| (time - self.delay + self.drift * self.middle) / (1.0 + self.drift))
    }
}

/// Range around a middle.
pub(super) fn around(middle: f64, half: f64) -> [f64; 2] {
    [middle - half, middle + half]
}

/// Places of the delays that are tried first, to each side (chosen).
const COARSE: i32 = 40;

/// Halvings of the step of a search.
const HALVINGS: usize = 12;

/// Force and motion, each on its own clock.
pub(super) struct Pair<'a> {
    time: &'a [f64],
    force: &'a [f64],
    /// Samples of the force that are looked at.
    chosen: Vec<usize>,
    /// Even grid on the clock of the motion, and what may explain the force there.
    begin: f64,
    step: f64,
    terms: Vec<[f64; TERMS]>,
}

/// Most samples that are looked at, and places of the grid (chosen).
const MOST_SAMPLES: usize = 4000;
const PLACES: usize = 8000;

/// Speeds within which friction turns, as parts of the largest one, and ways within which it turns, as parts of the
/// travel (chosen): regularised laws and bristles of any stiffness.
const SPEEDS: [f64; 2] = [3e-3, 3e-2];
const WAYS: [f64; 3] = [3e-3, 2e-2, 0.1];

/// Terms that explain the force: offset, velocity, acceleration, friction of each speed and way.
const TERMS: usize = 3 + SPEEDS.len() + WAYS.len();

impl<'a> Pair<'a> {
    /// Prepares what may explain the force: displacement, velocity and acceleration of the motion, between its ends.
    pub fn new(
        time: &'a [f64],
        force: &'a [f64],
        [begin, end]: [f64; 2],
        motion: &dyn Fn(f64) -> [f64; 3],
    ) -> Pair<'a> {
        let step = (end - begin) / (PLACES - 1) as f64;
        let moved: Vec<[f64; 3]> = (0..PLACES).map(|at| motion(begin + step * at as f64)).collect();
        let largest = |number: usize| moved.iter().map(|all| all[number].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let [fastest, steepest] = [largest(1), largest(2)];
        let ends = moved
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], all| [low.min(all[0]), high.max(all[0])]);
        let travel = ends[1] - ends[0];
        let mut hysteresis = [0.0; WAYS.len()];
        let mut before = moved[0][0];
        let term = |[x, v, a]: &[f64; 3]| {
            let change = x - before;
            before = *x;
            let mut terms = [1.0; TERMS];
            for ((state, way), term) in hysteresis.iter_mut().zip(WAYS).zip(&mut terms[3..]) {
                // Exact for dz = dx (1 - sgn(dx) z) / way.
                let steady = if change == 0.0 { *state } else { change.signum() };
                *state = steady + (*state - steady) * Real::exp(-change.abs() / (way * travel));
                *term = *state;
            }
            [terms[1], terms[2]] = [v / fastest, a / steepest];
            for (speed, term) in SPEEDS.iter().zip(&mut terms[3 + WAYS.len()..]) {
                *term = Real::tanh(v / (speed * fastest));
            }
            terms
        };
        let terms = moved.iter().map(term).collect();
        let chosen = (0..time.len()).step_by(time.len().div_ceil(MOST_SAMPLES)).collect();
        Pair { time, force, chosen, begin, step, terms }
    }

    /// Terms at a time on the clock of the motion, on straight lines between the places of the grid.
    fn at(&self, time: f64) -> SVector<f64, TERMS> {
        let place = ((time - self.begin) / self.step).clamp(0.0, (self.terms.len() - 1) as f64);
        let left = (place as usize).min(self.terms.len() - 2);
        let share = place - left as f64;
        let [low, high] = [left, left + 1].map(|at| SVector::from(self.terms[at]));
        low * (1.0 - share) + high * share
    }

    /// Sum of squares that the motion does not explain.
    pub fn unexplained(&self, clocks: &Clocks) -> f64 {
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

    /// Finds the delay, at most `longest`, with which the motion best explains the force as a sum of inertia, friction
    /// that turns within some way, viscous friction and offset; and its drift, at most a tenth of that over the record.
    pub fn find(&self, longest: f64) -> Clocks {
        let [first, last] = [self.time[0], self.time[self.time.len() - 1]];
        let clocks = |delay: f64, drift: f64| Clocks { delay, deviation: 0.0, drift, middle: 0.5 * (first + last) };
        let cost = |delay: f64, drift: f64| self.unexplained(&clocks(delay, drift));
        let mut step = [longest / f64::from(COARSE), 0.1 * longest / (last - first)];
        let places = (-COARSE..=COARSE).map(|k| f64::from(k) * step[0]);
        let mut best = places
            .map(|delay| (cost(delay, 0.0), [delay, 0.0]))
            .fold((f64::INFINITY, [0.0; 2]), |a, b| if b.0 < a.0 { b } else { a });
        for _ in 0..HALVINGS {
            for number in [0, 1] {
                let moved = |direction: f64| {
                    let mut place = best.1;
                    place[number] += direction * step[number];
                    (cost(place[0], place[1]), place)
                };
                let sides = [moved(-1.0), moved(1.0)];
                best = sides.into_iter().fold(best, |a, b| if b.0 < a.0 { b } else { a });
            }
            step = step.map(|step| 0.5 * step);
        }
        let [delay, drift] = best.1;
        let apart = longest / f64::from(COARSE);
        let bend = (cost(delay - apart, drift) - 2.0 * best.0 + cost(delay + apart, drift)) / (apart * apart);
        let variance = best.0 / self.chosen.len() as f64;
        let deviation = (2.0 * variance / bend.max(f64::MIN_POSITIVE)).sqrt().min(longest);
        Clocks { deviation, ..clocks(delay, drift) }
    }
}
