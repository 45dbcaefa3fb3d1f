//! Modified Rosenbrock method of order 2 with an error estimate of order 3, the class of ode23s.
//!
//! L. F. Shampine, M. W. Reichelt (1997), The MATLAB ODE suite, SIAM Journal on Scientific Computing 18, 1-22,
//! doi:10.1137/S1064827594276424, section 3:
//!
//! ```text
//! W = I - h d J,   d = 1 / (2 + sqrt 2),   e = 6 + sqrt 2,   T = df/dt
//! W k_1 = F_0 + h d T
//! W (k_2 - k_1) = F_1 - k_1,                        F_1 = f(t + h / 2, x + h k_1 / 2)
//! x_1 = x + h k_2
//! W k_3 = F_2 - e (k_2 - F_1) - 2 (k_1 - F_0) + h d T,   F_2 = f(t + h, x_1)
//! error = h (k_1 - 2 k_2 + k_3) / 6
//! ```

use super::Equations;
use super::elimination::Factors;
use super::recorder::Polynomials;
use super::step::{Beginning, Step};

/// d = 1 / (2 + sqrt 2).
const D: f64 = 1.0 / (2.0 + std::f64::consts::SQRT_2);

/// e = 6 + sqrt 2.
const E: f64 = 6.0 + std::f64::consts::SQRT_2;

/// Part of the tolerance that a step may be off (chosen).
const PART: f64 = 0.1;

/// A step of the method.
pub(super) struct Rosenbrock23<const N: usize> {
    k: [[f64; N]; 2],
    h: f64,
    end: [f64; N],
    error: [f64; N],
}

impl<const N: usize> Default for Rosenbrock23<N> {
    fn default() -> Self {
        Rosenbrock23 { k: [[0.0; N]; 2], h: 0.0, end: [0.0; N], error: [0.0; N] }
    }
}

impl<const N: usize> Step<N> for Rosenbrock23<N> {
    type Course = Polynomials<N>;
    const ERROR_ORDER: i32 = 3;
    const GAMMA: f64 = D;
    // The polynomial is one of degree 2.
    const DEFECT: f64 = 1.0;

    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool {
        let hd = h * D;
        let matrix =
            std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j)) - hd * begin.jacobian[i][j]));
        let Some(factors) = Factors::of(matrix) else { return false };
        let slope: [f64; N] = begin.by_time.map(|t| hd * t);
        let f0 = &begin.rates;
        let k1 = factors.solve(std::array::from_fn(|i| f0[i] + slope[i]));
        let middle: [f64; N] = std::array::from_fn(|i| begin.states[i] + 0.5 * h * k1[i]);
        let mut f1 = [0.0; N];
        equations.rates(begin.time + 0.5 * h, &middle, &mut f1);
        let change = factors.solve(std::array::from_fn(|i| f1[i] - k1[i]));
        let k2: [f64; N] = std::array::from_fn(|i| k1[i] + change[i]);
        self.end = std::array::from_fn(|i| begin.states[i] + h * k2[i]);
        let mut f2 = [0.0; N];
        equations.rates(begin.time + h, &self.end, &mut f2);
        let right = |i: usize| f2[i] - E * (k2[i] - f1[i]) - 2.0 * (k1[i] - f0[i]) + slope[i];
        let k3 = factors.solve(std::array::from_fn(right));
        self.error = std::array::from_fn(|i| h / 6.0 * (k1[i] - 2.0 * k2[i] + k3[i]));
        (self.k, self.h) = ([k1, k2], h);
        self.end.iter().chain(&self.error).all(|x| x.is_finite())
    }

    fn evaluations(&self) -> u64 {
        2
    }

    fn end(&self) -> &[f64; N] {
        &self.end
    }

    fn error(&self) -> &[f64; N] {
        &self.error
    }

    /// A method of order 2 makes many steps, whose errors add up.
    fn excess(&self, norm: impl Fn(&[f64; N], &[f64; N]) -> f64) -> f64 {
        norm(&self.error, &self.end) / PART
    }

    /// x(s) = x + h (s (1 - s) k_1 + s (s - 2 d) k_2) / (1 - 2 d).
    fn course(&self, begin: &Beginning<N>) -> Polynomials<N> {
        let scale = self.h / (1.0 - 2.0 * D);
        std::array::from_fn(|i| {
            let [k1, k2] = [self.k[0][i], self.k[1][i]];
            [begin.states[i], scale * (k1 - 2.0 * D * k2), scale * (k2 - k1), 0.0, 0.0]
        })
    }
}
