//! Exponential Rosenbrock-Euler method: the equations linearised at the beginning of a step, solved exactly.
//!
//! Between two events a law made of straight lines has linear equations, so that the steps are exact, however stiff and
//! long they are; elsewhere the method is of order 2. The phi functions act on the Jacobian J:
//!
//! ```text
//! x(t + h) = x + h phi_1(h J) f + h^2 phi_2(h J) df/dt
//! phi_1(z) = (exp(z) - 1) / z,   phi_2(z) = (phi_1(z) - 1) / z
//! ```
//!
//! M. Hochbruck, A. Ostermann (2010), Exponential integrators, Acta Numerica 19, 209-286,
//! doi:10.1017/S0962492910000048. A step is made of four quarters, whose ends the polynomial of the dense output is
//! compared with. The estimate of the error is their difference, and what the rates have that their linearisation has not.

use super::Equations;
use super::matrix::{Matrix, apply, from, product, with_diagonal};
use super::method::{Beginning, Step};
use super::recorder::Polynomials;

/// Largest norm of a matrix whose phi functions are summed up (chosen): ten terms are then exact.
const SMALL: f64 = 0.125;

/// 1 / (k + 2)!, the coefficients of phi_2.
const SERIES: [f64; 11] = {
    let (mut coefficients, mut factorial, mut k) = ([0.0; 11], 1.0, 0);
    while k < 11 {
        factorial *= (k + 2) as f64;
        coefficients[k] = 1.0 / factorial;
        k += 1;
    }
    coefficients
};

const QUARTERS: usize = 4;

/// A step of the method.
pub(super) struct Exponential<const N: usize> {
    /// Changes of the states from the beginning to the end of each quarter.
    changes: [[f64; N]; QUARTERS],
    /// Rates of the linearised equations at the end.
    rates: [f64; N],
    h: f64,
    end: [f64; N],
    error: [f64; N],
}

impl<const N: usize> Default for Exponential<N> {
    fn default() -> Self {
        let zero = [0.0; N];
        Exponential { changes: [zero; QUARTERS], rates: zero, h: 0.0, end: zero, error: zero }
    }
}

impl<const N: usize> Exponential<N> {
    /// Solves the linearised equations. Returns their rates in the middle.
    fn solve(&mut self, begin: &Beginning<N>, h: f64) -> [f64; N] {
        let Beginning { rates, jacobian, by_time, .. } = begin;
        let quarter = h / QUARTERS as f64;
        let [phi_1, phi_2] = phi(jacobian, quarter);
        let driven = apply(&phi_2, by_time);
        let (mut change, mut rate, mut middle) = ([0.0; N], *rates, *rates);
        for (number, end) in self.changes.iter_mut().enumerate() {
            let moved = apply(&phi_1, &rate);
            for i in 0..N {
                change[i] += quarter * (moved[i] + quarter * driven[i]);
            }
            let turned = apply(jacobian, &change);
            let time = (number + 1) as f64 * quarter;
            rate = std::array::from_fn(|i| rates[i] + turned[i] + time * by_time[i]);
            *end = change;
            if number == 1 {
                middle = rate;
            }
        }
        (self.rates, self.h) = (rate, h);
        self.end = std::array::from_fn(|i| begin.states[i] + change[i]);
        middle
    }

    /// Coefficients of a state's polynomial: value and rate at both ends, value in the middle.
    fn polynomial(&self, begin: &Beginning<N>, state: usize) -> [f64; 5] {
        let [_, middle, _, end] = self.changes.map(|change| change[state]);
        let [first, last] = [begin.rates[state], self.rates[state]].map(|rate| rate * self.h);
        let (a, b, c) = (end - first, last - first, middle - 0.5 * first);
        let fourth = 16.0 * c - 8.0 * a + 2.0 * b;
        let third = b - 2.0 * a - 2.0 * fourth;
        [begin.states[state], first, a - third - fourth, third, fourth]
    }
}

impl<const N: usize> Step<N> for Exponential<N> {
    type Course = Polynomials<N>;
    const ERROR_ORDER: i32 = 5;

    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool {
        let linear = self.solve(begin, h);
        if !self.end.iter().all(|x| x.is_finite()) {
            return false;
        }
        let [mut at_middle, mut at_end] = [[0.0; N]; 2];
        let middle: [f64; N] = std::array::from_fn(|i| begin.states[i] + self.changes[1][i]);
        equations.rates(begin.time + 0.5 * h, &middle, &mut at_middle);
        equations.rates(begin.time + h, &self.end, &mut at_end);
        for i in 0..N {
            let [_, c1, c2, c3, c4] = self.polynomial(begin, i);
            let off =
                |s: f64, quarter: usize| ((((c4 * s + c3) * s + c2) * s + c1) * s - self.changes[quarter][i]).abs();
            // Simpson's rule over the rates that the linearised equations lack.
            let lacking = h * (4.0 * (at_middle[i] - linear[i]).abs() + (at_end[i] - self.rates[i]).abs()) / 6.0;
            self.error[i] = off(0.25, 0).max(off(0.75, 2)) + lacking;
        }
        true
    }

    fn end(&self) -> &[f64; N] {
        &self.end
    }

    fn error(&self) -> &[f64; N] {
        &self.error
    }

    fn evaluations(&self) -> u64 {
        2
    }

    fn course(&self, begin: &Beginning<N>) -> Polynomials<N> {
        std::array::from_fn(|state| self.polynomial(begin, state))
    }
}

/// phi_1(t J) and phi_2(t J): by the series at t / 2^n, and doubled n times.
fn phi<const N: usize>(jacobian: &Matrix<N>, t: f64) -> [Matrix<N>; 2] {
    let norm = jacobian.iter().map(|row| row.iter().map(|value| value.abs()).sum::<f64>()).fold(0.0, f64::max) * t;
    let (mut scale, mut doublings) = (t, 0);
    while norm * scale > SMALL * t && doublings < 1000 {
        scale *= 0.5;
        doublings += 1;
    }
    let z = jacobian.map(|row| row.map(|value| value * scale));
    let mut phi_2 = [[0.0; N]; N];
    for coefficient in SERIES.iter().rev() {
        phi_2 = with_diagonal(&product(&z, &phi_2), *coefficient);
    }
    let mut phi_1 = with_diagonal(&product(&z, &phi_2), 1.0);
    let mut power = with_diagonal(&product(&z, &phi_1), 1.0);
    for _ in 0..doublings {
        let [times_1, times_2] = [product(&power, &phi_1), product(&power, &phi_2)];
        phi_2 = from(|i, j| 0.25 * (times_2[i][j] + phi_1[i][j] + phi_2[i][j]));
        phi_1 = from(|i, j| 0.5 * (times_1[i][j] + phi_1[i][j]));
        power = product(&power, &power);
    }
    [phi_1, phi_2]
}
