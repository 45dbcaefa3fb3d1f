//! Motion under linear equations, as exact as numbers are.
//!
//! ```text
//! dx/dt = f + J (x - x_0)
//! x(t)  = x_0 + P(t) f,   P(t) = t phi_1(t J),   phi_1(z) = (exp(z) - 1) / z
//! ```

use stribeck::number::elementary::{exp, exp_m1};

use super::judge::balanced;
use super::moving::Moving;
use super::recorder::{Course, Times};
use super::series::Series;
use super::step::Beginning;

/// Largest number of states for which functions of a matrix cost no more than a power series (measured).
const FEW: usize = 4;

/// Number of output times from which on powers of a matrix cost less than a power series at each of them (chosen).
const MANY: usize = 128;

/// Largest norm of a matrix whose phi function is summed up (chosen): ten terms are then exact.
const SMALL: f64 = 0.125;

/// 1 / (k + 1)!, the coefficients of phi_1.
const SERIES: [f64; 10] = {
    let (mut coefficients, mut factorial, mut k) = ([0.0; 10], 1.0, 0);
    while k < coefficients.len() {
        factorial *= (k + 1) as f64;
        coefficients[k] = 1.0 / factorial;
        k += 1;
    }
    coefficients
};

/// Most doublings of a time: no finite matrix needs more.
const MOST_DOUBLINGS: u32 = 1100;

/// Most output times whose states are computed together (chosen).
const BLOCK: usize = 32;

/// Exponent beyond which an exponential is too large to go on with (chosen).
const MOST: f64 = 300.0;

/// Parts of a step at whose ends the motion is kept.
pub(super) const QUARTERS: usize = 4;

/// Row by row.
type Matrix<const N: usize> = [[f64; N]; N];

/// The motion within a step.
#[derive(Clone, Copy)]
pub(super) struct Flow<const N: usize> {
    begin: [f64; N],
    rates: [f64; N],
    jacobian: Matrix<N>,
    length: f64,
    /// Changes of the states from the beginning of the step to the end of each quarter.
    changes: [[f64; N]; QUARTERS],
}

impl<const N: usize> Flow<N> {
    /// The motion under the equations linearised at the beginning of a step. They must not depend on time.
    pub fn new(begin: &Beginning<N>, length: f64) -> Flow<N> {
        let Beginning { states, rates, jacobian, .. } = *begin;
        let mut flow = Flow { begin: states, rates, jacobian, length, changes: [[0.0; N]; QUARTERS] };
        flow.changes = match flow.series(length, &rates) {
            Some(series) => std::array::from_fn(|quarter| series.at((quarter + 1) as f64 / QUARTERS as f64)),
            None => flow.quarters(),
        };
        flow
    }

    /// The changes over a time from these rates on, if there are many states and the time is short enough for it.
    fn series(&self, time: f64, rates: &[f64; N]) -> Option<Series<N>> {
        if N > FEW { Series::over(time, rates, &self.jacobian) } else { None }
    }

    fn quarters(&self) -> [[f64; N]; QUARTERS] {
        let Transition { power, gain } = self.transition(self.length / QUARTERS as f64);
        let first = apply(&gain, &self.rates);
        let mut changes = [first; QUARTERS];
        for quarter in 1..QUARTERS {
            changes[quarter] = plus(&apply(&power, &changes[quarter - 1]), &first);
        }
        changes
    }

    /// How changes of the states that move go on over a time.
    fn transition(&self, t: f64) -> Transition<N> {
        if N <= FEW {
            return Transition::over(t, &self.jacobian);
        }
        let moving = Moving::of(&self.rates, &self.jacobian);
        match moving.count() {
            0..=3 => Transition::among::<3>(t, &self.jacobian, &moving),
            4 => Transition::among::<4>(t, &self.jacobian, &moving),
            _ => Transition::scaled(t, &self.jacobian),
        }
    }

    /// Time from the beginning of the step to the end of a quarter.
    pub fn time_at(&self, quarter: usize) -> f64 {
        (quarter + 1) as f64 / QUARTERS as f64 * self.length
    }

    /// The states at the end of a quarter.
    pub fn end_of(&self, quarter: usize) -> [f64; N] {
        plus(&self.begin, &self.changes[quarter])
    }

    /// The rates at the end of a quarter, and the size of the terms of which they are sums.
    pub fn rates_at(&self, quarter: usize) -> [[f64; N]; 2] {
        let change = &self.changes[quarter];
        let size = std::array::from_fn(|i| {
            let term = |j: usize| self.jacobian[i][j].abs() * (self.begin[j].abs() + change[j].abs());
            self.rates[i].abs() + (0..N).map(term).sum::<f64>()
        });
        [self.rates_after(change), size]
    }

    fn rates_after(&self, change: &[f64; N]) -> [f64; N] {
        plus(&self.rates, &apply(&self.jacobian, change))
    }

    /// How far the states are from polynomials of degree 4 in the middle of the first and the last half, at most, in parts
    /// of their changes; less than `least` does not count. The polynomials have the values and rates at both ends and the
    /// values in the middle.
    pub fn bend(&self, least: &[f64; N]) -> f64 {
        let at_end = self.rates_after(&self.changes[QUARTERS - 1]);
        let part = |i: usize| {
            let [early, middle, late, end] = self.changes.map(|change| change[i]);
            let [first, last] = [self.rates[i], at_end[i]].map(|rate| rate * self.length);
            let polynomials = [
                (72.0 * middle - 16.0 * end + 9.0 * first + 3.0 * last) / 128.0,
                (72.0 * middle + 72.0 * end - 3.0 * first - 9.0 * last) / 128.0,
            ];
            let range = [early, middle, late, end].map(f64::abs).into_iter().fold(0.0, f64::max);
            let off = (polynomials[0] - early).abs().max((polynomials[1] - late).abs());
            if off <= least[i] { 0.0 } else { off / range }
        };
        (0..N).map(part).fold(0.0, f64::max)
    }

    /// Change of the states from the beginning of the step to a fraction of it.
    fn change_at(&self, fraction: f64) -> [f64; N] {
        let quarters = fraction * QUARTERS as f64;
        let done = (quarters as usize).min(QUARTERS);
        let change = if done == 0 { [0.0; N] } else { self.changes[done - 1] };
        let rest = (quarters - done as f64) * (self.length / QUARTERS as f64);
        if rest == 0.0 {
            return change;
        }
        let rates = self.rates_after(&change);
        let further = match self.series(rest, &rates) {
            Some(series) => series.at(1.0),
            None => apply(&self.transition(rest).gain, &rates),
        };
        plus(&change, &further)
    }
}

impl<const N: usize> Course for Flow<N> {
    fn at(&self, fraction: f64, states: &mut [f64]) {
        for (state, value) in states.iter_mut().zip(plus(&self.begin, &self.change_at(fraction))) {
            *state = value;
        }
    }

    fn end_slopes(&self, slopes: &mut [f64]) {
        let rates = self.rates_after(&self.changes[QUARTERS - 1]);
        slopes.iter_mut().zip(rates).for_each(|(slope, rate)| *slope = rate * self.length);
    }

    fn fill(&self, times: &Times, columns: &mut [Vec<f64>]) {
        let is_few = times.past < times.first + MANY;
        if let Some(series) = self.series(self.length, &self.rates).filter(|_| is_few) {
            for number in times.first..times.past {
                let states = plus(&self.begin, &series.at(times.fraction(number)));
                columns.iter_mut().zip(states).for_each(|(column, state)| column[number] = state);
            }
            return;
        }
        let mut change = self.change_at(times.fraction(times.first));
        if N > FEW && times.past <= times.first + BLOCK {
            let Transition { power, gain } = self.transition(times.spacing * self.length);
            let once = apply(&gain, &self.rates);
            for number in times.first..times.past {
                let states = plus(&self.begin, &change);
                columns.iter_mut().zip(states).for_each(|(column, state)| column[number] = state);
                change = plus(&apply(&power, &change), &once);
            }
            return;
        }
        let powers = Powers::of(self, times);
        for from in (times.first..times.past).step_by(powers.count) {
            let to = times.past.min(from + powers.count);
            for (state, column) in columns.iter_mut().enumerate() {
                powers.write(state, self.begin[state], &change, &mut column[from..to]);
            }
            change = powers.after_block(&change);
        }
    }
}

/// How changes of the states go on from one output time to those after it.
struct Powers<const N: usize> {
    /// Number of output times in a block.
    count: usize,
    /// Element by element, those of a block in a row, so that the loops run in vector registers.
    power: [[[f64; BLOCK]; N]; N],
    gained: [[f64; BLOCK]; N],
    /// Over a whole block.
    last: (Matrix<N>, [f64; N]),
}

impl<const N: usize> Powers<N> {
    fn of(flow: &Flow<N>, times: &Times) -> Powers<N> {
        // The making of a block and the blocks made of it then cost about the same.
        let count = (((times.past - times.first) as f64).sqrt().ceil() as usize).min(BLOCK);
        let mut powers = Powers {
            count,
            power: [[[0.0; BLOCK]; N]; N],
            gained: [[0.0; BLOCK]; N],
            last: (from(|i, j| if i == j { 1.0 } else { 0.0 }), [0.0; N]),
        };
        if count == 1 {
            powers.keep(0);
            return powers;
        }
        let Transition { power, gain } = flow.transition(times.spacing * flow.length);
        let once = apply(&gain, &flow.rates);
        for number in 0..count {
            powers.keep(number);
            powers.last = (product(&power, &powers.last.0), plus(&apply(&power, &powers.last.1), &once));
        }
        powers
    }

    /// Keeps what was gone through last as that of a number.
    fn keep(&mut self, number: usize) {
        for i in 0..N {
            self.gained[i][number] = self.last.1[i];
            for j in 0..N {
                self.power[i][j][number] = self.last.0[i][j];
            }
        }
    }

    fn write(&self, state: usize, begin: f64, change: &[f64; N], values: &mut [f64]) {
        for (value, gained) in values.iter_mut().zip(&self.gained[state]) {
            *value = *gained;
        }
        for (change, power) in change.iter().zip(&self.power[state]) {
            for (value, power) in values.iter_mut().zip(power) {
                *value += power * change;
            }
        }
        values.iter_mut().for_each(|value| *value += begin);
    }

    fn after_block(&self, change: &[f64; N]) -> [f64; N] {
        plus(&apply(&self.last.0, change), &self.last.1)
    }
}

/// How changes of the states go on over a time: exp(t J), and P(t).
struct Transition<const N: usize> {
    power: Matrix<N>,
    gain: Matrix<N>,
}

impl<const N: usize> Transition<N> {
    /// By the series at t / 2^n, and doubled n times.
    fn over(t: f64, jacobian: &Matrix<N>) -> Transition<N> {
        Transition::within(t, jacobian, norm(jacobian))
    }

    /// As [`Transition::over`], with fewer doublings where the states have units of very different sizes.
    fn scaled(t: f64, jacobian: &Matrix<N>) -> Transition<N> {
        Transition::within(t, jacobian, norm(&balanced(jacobian)))
    }

    /// Of the states that move, of which there are at most M; it does not act on the others.
    fn among<const M: usize>(t: f64, jacobian: &Matrix<N>, moving: &Moving<N>) -> Transition<N> {
        let Transition { power, gain } = Transition::<M>::scaled(t, &moving.gather(jacobian));
        Transition { power: moving.scatter(&power), gain: moving.scatter(&gain) }
    }

    /// For a matrix of this norm, in whatever units.
    fn within(t: f64, jacobian: &Matrix<N>, norm: f64) -> Transition<N> {
        let (mut part, mut doublings) = (t, 0);
        while norm * part > SMALL && doublings < MOST_DOUBLINGS {
            part *= 0.5;
            doublings += 1;
        }
        if N == 2 {
            return Transition::apart(jacobian, t).unwrap_or_else(|| Transition::of_two(jacobian, part, doublings));
        }
        let z = jacobian.map(|row| row.map(|value| value * part));
        let mut phi = [[0.0; N]; N];
        for coefficient in SERIES.iter().rev() {
            phi = with_diagonal(&product(&z, &phi), *coefficient);
        }
        // exp(t J) - 1, which keeps its digits where it is small.
        let mut rise = product(&z, &phi);
        let mut gain = phi.map(|row| row.map(|value| value * part));
        for _ in 0..doublings {
            let (more, square) = (product(&rise, &gain), product(&rise, &rise));
            gain = from(|i, j| 2.0 * gain[i][j] + more[i][j]);
            rise = from(|i, j| 2.0 * rise[i][j] + square[i][j]);
        }
        Transition { power: with_diagonal(&rise, 1.0), gain }
    }

    /// Two states, by the eigenvalues a and b, if they are real and so far apart that their exponentials differ:
    /// g(J) = (g(a) (J - b I) - g(b) (J - a I)) / (a - b).
    fn apart(jacobian: &Matrix<N>, t: f64) -> Option<Transition<N>> {
        let half = 0.5 * (jacobian[0][0] + jacobian[1][1]);
        let determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
        let root = (half * half - determinant).max(0.0).sqrt();
        let large = half + root.copysign(half);
        if root * t < 1.0 || large * t > MOST {
            return None;
        }
        let small = determinant / large;
        let (unlike_large, unlike_small) = (with_diagonal(jacobian, -large), with_diagonal(jacobian, -small));
        let of = |at_large: f64, at_small: f64| {
            let [at_large, at_small] = [at_large, at_small].map(|value| value / (large - small));
            from(|i, j| at_large * unlike_small[i][j] - at_small * unlike_large[i][j])
        };
        let integral = |value: f64| if value == 0.0 { t } else { exp_m1(value * t) / value };
        Some(Transition { power: of(exp(large * t), exp(small * t)), gain: of(integral(large), integral(small)) })
    }

    /// Two states: any function of J is a I + b J, and J^2 = tr(J) J - det(J) I.
    fn of_two(jacobian: &Matrix<N>, part: f64, doublings: u32) -> Transition<N> {
        let trace = jacobian[0][0] + jacobian[1][1];
        let determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
        let times = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
            let square = b * d;
            [a * c - square * determinant, (a * d + b * c) + square * trace]
        };
        let z = [0.0, part];
        let phi = SERIES.iter().rev().fold([0.0; 2], |[a, b], coefficient| {
            let [a, b] = times(z, [a, b]);
            [a + coefficient, b]
        });
        let mut rise = times(z, phi);
        let mut gain = phi.map(|value| value * part);
        for _ in 0..doublings {
            let (more, square) = (times(rise, gain), times(rise, rise));
            gain = [2.0 * gain[0] + more[0], 2.0 * gain[1] + more[1]];
            rise = [2.0 * rise[0] + square[0], 2.0 * rise[1] + square[1]];
        }
        let of = |[a, b]: [f64; 2]| with_diagonal(&from(|i, j| b * jacobian[i][j]), a);
        Transition { power: of([1.0 + rise[0], rise[1]]), gain: of(gain) }
    }
}

/// A matrix of these elements.
#[inline(always)]
fn from<const N: usize>(value: impl Fn(usize, usize) -> f64) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| value(i, j)))
}

fn norm<const N: usize>(matrix: &Matrix<N>) -> f64 {
    matrix.iter().map(|row| row.iter().map(|value| value.abs()).sum::<f64>()).fold(0.0, f64::max)
}

/// A product.
#[inline(always)]
fn product<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from(|i, j| (0..N).map(|k| a[i][k] * b[k][j]).sum())
}

/// Adds a multiple of the unit matrix.
#[inline(always)]
fn with_diagonal<const N: usize>(a: &Matrix<N>, diagonal: f64) -> Matrix<N> {
    from(|i, j| if i == j { a[i][j] + diagonal } else { a[i][j] })
}

/// Product with a column.
#[inline(always)]
fn apply<const N: usize>(a: &Matrix<N>, x: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i].iter().zip(x).map(|(a, x)| a * x).sum())
}

/// A sum.
#[inline(always)]
fn plus<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] + b[i])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn flow<const N: usize>(jacobian: Matrix<N>, states: [f64; N], rates: [f64; N], length: f64) -> Flow<N> {
        Flow::new(&Beginning { time: 0.0, states, rates, jacobian, by_time: [0.0; N] }, length)
    }

    fn at<const N: usize>(flow: &Flow<N>, fraction: f64) -> [f64; N] {
        let mut states = [f64::NAN; N];
        flow.at(fraction, &mut states);
        states
    }

    /// x = e^(-d t) cos(w t), as a position and a velocity, within a step of any length.
    #[test]
    fn oscillations_are_followed() {
        let (decay, w) = (0.3, 1.7);
        let matrix = [[0.0, 1.0], [-(decay * decay + w * w), -2.0 * decay]];
        for length in [1e-3, 0.4, 2.0, 9.0] {
            let flow = flow(matrix, [1.0, -decay], [-decay, decay * decay - w * w], length);
            for fraction in [0.0, 1e-6, 0.1, 0.25, 0.4, 0.6, 0.99, 1.0] {
                let t: f64 = fraction * length;
                let [sin, cos, fade] = [(w * t).sin(), (w * t).cos(), (-decay * t).exp()];
                let [x, v] = at(&flow, fraction);
                assert!((x - fade * cos).abs() < 2e-14, "{t}: {x}");
                assert!((v + fade * (decay * cos + w * sin)).abs() < 2e-14, "{t}: {v}");
            }
        }
    }

    /// v' = -1e4 (v - 1) + x, x' = 0.5: fast and slow at once, and a third state that doubles in each unit of time.
    #[test]
    fn stiff_and_unstable_motions_are_followed() {
        let expected = |t: f64| {
            let slow = |t: f64| 1.0 + 1e-4 * (0.5 * t) - 0.5e-8;
            let v = slow(t) + (0.2 - slow(0.0)) * (-1e4 * t).exp();
            [0.5 * t, v, (2f64.ln() * t).exp()]
        };
        let ln_2 = 2f64.ln();
        let three = [[0.0, 0.0, 0.0], [1.0, -1e4, 0.0], [0.0, 0.0, ln_2]];
        let two = [[0.0, 0.0], [1.0, -1e4]];
        let rate = 1e4 * (1.0 - 0.2);
        for length in [1e-5, 1e-3, 0.2, 3.0] {
            let of_three = flow(three, [0.0, 0.2, 1.0], [0.5, rate, ln_2], length);
            let of_two = flow(two, [0.0, 0.2], [0.5, rate], length);
            for fraction in [1e-4, 0.3, 0.5, 0.77, 1.0] {
                let [x, v, y] = expected(fraction * length);
                for (found, expected) in at(&of_three, fraction).into_iter().zip([x, v, y]) {
                    assert_relative_eq!(found, expected, max_relative = 1e-13);
                }
                for (found, expected) in at(&of_two, fraction).into_iter().zip([x, v]) {
                    assert_relative_eq!(found, expected, max_relative = 1e-13);
                }
            }
        }
    }

    /// v' = -1e4 (v - 1) + x, x' = 0.5 y, y' = 0.1, once or twice among six states. With v = 1 at first, v has no rate of its
    /// own.
    fn among_six(twice: bool, begin: f64, length: f64) -> (Flow<6>, [[usize; 3]; 2]) {
        let places = [[4, 1, 3], [0, 5, 2]];
        let (mut matrix, mut states, mut rates) = ([[0.0; 6]; 6], [0.0; 6], [0.0; 6]);
        for (at, [x, v, y]) in places.into_iter().enumerate().take(if twice { 2 } else { 1 }) {
            (matrix[v][v], matrix[v][x], matrix[x][y]) = (-1e4, 1.0, 0.5);
            (states[v], states[y]) = (begin + at as f64, 1.0);
            (rates[v], rates[x], rates[y]) = (1e4 * (1.0 - states[v]), 0.5, 0.1);
        }
        (flow(matrix, states, rates, length), places)
    }

    /// Short steps have power series; in long ones, those that move are told apart.
    #[test]
    fn six_states_go_on_as_their_parts_do() {
        let path = |t: f64| 0.5 * t + 0.025 * t * t;
        let slow = |t: f64| 1.0 + 1e-4 * path(t) - 1e-8 * (0.5 + 0.05 * t) + 0.05e-12;
        let cases = [(false, 0.2), (false, 1.0), (true, 0.2)];
        for (length, (twice, first)) in
            [1e-5, 2e-4, 1e-3, 0.2, 3.0].into_iter().flat_map(|h| cases.map(|case| (h, case)))
        {
            let (flow, places) = among_six(twice, first, length);
            assert_eq!(flow.series(length, &flow.rates).is_some(), length < 2.5e-4);
            for fraction in [1e-4, 0.25, 0.3, 0.5, 0.77, 1.0] {
                let (found, t) = (at(&flow, fraction), fraction * length);
                for (number, [x, v, y]) in places.into_iter().enumerate() {
                    let begin = first + number as f64;
                    let expected = [path(t), slow(t) + (begin - slow(0.0)) * (-1e4 * t).exp(), 1.0 + 0.1 * t];
                    let expected = if number == 0 || twice { expected } else { [0.0; 3] };
                    for (found, expected) in [found[x], found[v], found[y]].into_iter().zip(expected) {
                        assert_relative_eq!(found, expected, max_relative = 1e-13);
                    }
                }
            }
        }
    }

    /// Eigenvalues that are equal, or nearly so, and one that is 0, beside the power series of all matrices.
    #[test]
    fn two_states_agree_with_three() {
        for [a, b, c, d] in
            [[0.0, 1.0, -4.0, -4.0], [-3.0, 1e-7, 1e-7, -3.0], [0.0, 1.0, 0.0, -700.0], [2.0, 5.0, 1.0, -4.0]]
        {
            for t in [1e-3, 0.1, 0.5, 1.0] {
                let two = Transition::over(t, &[[a, b], [c, d]]);
                let three = Transition::over(t, &[[a, b, 0.0], [c, d, 0.0], [0.0, 0.0, 0.0]]);
                for i in 0..2 {
                    for j in 0..2 {
                        let [power, gain] = [(two.power, three.power), (two.gain, three.gain)]
                            .map(|(two, three)| (two[i][j] - three[i][j]).abs());
                        assert!(power < 1e-13 && gain < 1e-13, "{:?} {t}: {power:e} {gain:e}", [a, b, c, d]);
                    }
                }
            }
        }
    }

    /// Output times in blocks beside the states at each of them.
    #[test]
    fn outputs_are_those_of_the_flow() {
        outputs(&flow([[0.0, 1.0], [-2.0, -0.4]], [0.3, 0.1], [0.1, -0.7], 1.5));
        for length in [2e-4, 1e-3, 0.2] {
            [false, true].into_iter().for_each(|twice| outputs(&among_six(twice, 0.2, length).0));
        }
    }

    fn outputs<const N: usize>(flow: &Flow<N>) {
        for (first, past) in [(7, 8), (7, 12), (3, 400), (0, 5000)] {
            let times = Times { first, past, spacing: 1.0 / 5000.0, offset: 0.0 };
            let mut columns = vec![vec![f64::NAN; 5000]; N];
            flow.fill(&times, &mut columns);
            for number in first..past {
                for (column, expected) in columns.iter().zip(at(flow, times.fraction(number))) {
                    assert!((column[number] - expected).abs() < 1e-13, "{number}");
                }
            }
        }
    }
}
