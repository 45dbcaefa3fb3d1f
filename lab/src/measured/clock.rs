//! Two clocks: that of the load cell and that of the camera.

use nalgebra::{SMatrix, SVector};

use super::polynomial::Local;

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
}

/// Places of the delays that are tried first, to each side (chosen).
const COARSE: i32 = 40;

/// Parts into which the record is divided to see a drift (chosen).
const PARTS: usize = 4;

/// Finds the delay, at most `longest`, by which the motion best explains the force as a sum of inertia, friction that
/// turns with the velocity, viscous friction, stiffness and offset; and its drift over the parts of the record.
pub(super) fn find(time: &[f64], force: &[f64], motion: &Local, longest: f64) -> Clocks {
    let middle = 0.5 * (time[0] + time[time.len() - 1]);
    let size = time.len().div_ceil(PARTS);
    let found: Vec<(f64, f64)> = (0..PARTS)
        .map(|part| part * size..((part + 1) * size).min(time.len()))
        .filter(|range| range.len() > 20)
        .map(|range| {
            let t = &time[range.clone()];
            (0.5 * (t[0] + t[t.len() - 1]), best(t, &force[range], motion, longest))
        })
        .collect();
    line(&found, middle)
}

/// A straight line through the delays of the parts.
fn line(found: &[(f64, f64)], middle: f64) -> Clocks {
    let count = found.len() as f64;
    let delay = found.iter().map(|(_, delay)| delay).sum::<f64>() / count;
    let spread: f64 = found.iter().map(|(time, _)| (time - middle).powi(2)).sum();
    let drift = found.iter().map(|(time, part)| (time - middle) * (part - delay)).sum::<f64>() / spread;
    let rest = found.iter().map(|(time, part)| (part - delay - drift * (time - middle)).powi(2)).sum::<f64>();
    Clocks { delay, deviation: (rest / (count - 2.0) / count).sqrt(), drift, middle }
}

/// The best delay: on a grid, then by parabolas through three places.
fn best(time: &[f64], force: &[f64], motion: &Local, longest: f64) -> f64 {
    let mut step = longest / f64::from(COARSE);
    let cost = |delay: f64| unexplained(time, force, motion, delay);
    let places = (-COARSE..=COARSE).map(|k| f64::from(k) * step);
    let mut best =
        places.map(|delay| (cost(delay), delay)).fold((f64::INFINITY, 0.0), |a, b| if b.0 < a.0 { b } else { a });
    for _ in 0..8 {
        let [low, high] = [cost(best.1 - step), cost(best.1 + step)];
        let bend = low - 2.0 * best.0 + high;
        let shift = if bend > 0.0 { (0.5 * (low - high) / bend).clamp(-1.0, 1.0) * step } else { 0.0 };
        let next = (cost(best.1 + shift), best.1 + shift);
        best = if next.0 < best.0 { next } else { best };
        step *= 0.5;
    }
    best.1
}

/// Most samples that are looked at for one delay (chosen).
const MOST_SAMPLES: usize = 4000;

/// Terms that explain the force.
const TERMS: usize = 5;

/// Sum of squares that the motion does not explain.
fn unexplained(time: &[f64], force: &[f64], motion: &Local, delay: f64) -> f64 {
    let every = time.len().div_ceil(MOST_SAMPLES);
    let chosen: Vec<usize> = (0..time.len()).step_by(every).collect();
    let moved: Vec<[f64; 3]> = chosen.iter().map(|at| motion.at(time[*at] + delay)).collect();
    let largest = |number: usize| moved.iter().map(|all| all[number].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let scale = [0, 1, 2].map(largest);
    let (mut gram, mut right) = (SMatrix::<f64, TERMS, TERMS>::zeros(), SVector::<f64, TERMS>::zeros());
    let mut total = 0.0;
    for (at, all) in chosen.iter().zip(&moved) {
        let [x, v, a] = [0, 1, 2].map(|number| all[number] / scale[number]);
        let terms = SVector::from([1.0, (50.0 * v).tanh(), v, x, a]);
        gram += terms * terms.transpose();
        right += terms * force[*at];
        total += force[*at] * force[*at];
    }
    gram.cholesky().map_or(f64::INFINITY, |gram| total - right.dot(&gram.solve(&right)))
}
