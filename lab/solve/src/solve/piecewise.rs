//! Steps that are exact as long as equations are linear.
//!
//! Between two events, a law made of straight lines has linear equations. What such equations do in a step is known in
//! closed form, however stiff they are and however long the step is; each is checked against the rates of the equations
//! themselves. Where they turn out not to be linear, another method goes on until the next event.

use super::flow::{Flow, QUARTERS};
use super::recorder::{Course, Times};
use super::statistics::Statistics;
use super::step::{Beginning, Step};
use super::{Equations, Options};

/// Deviation from polynomials of degree 4, in parts of the changes of the states, up to which a step is short enough for
/// events to be seen in a few places of it (chosen): about a third of the period of an oscillation.
const BEND: f64 = 1e-3;

/// Deviation in parts of a state's size that does not count (chosen): a stiff state at rest has nothing but rounding errors.
const LEAST: f64 = 1e-12;

/// Rounding errors of rates, in parts of the terms of which they are sums.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A step of the method.
pub(super) struct Piecewise<S, const N: usize> {
    /// Motion in the attempt made last, if the equations are taken for linear.
    flow: Option<Flow<N>>,
    end: [f64; N],
    /// Deviations of the states that do not count.
    least: [f64; N],
    /// Whether the equations are linear, as far as is known.
    is_linear: bool,
    otherwise: S,
}

impl<S: Default, const N: usize> Default for Piecewise<S, N> {
    fn default() -> Self {
        Piecewise { flow: None, end: [0.0; N], least: [0.0; N], is_linear: false, otherwise: S::default() }
    }
}

/// The motion within a step.
#[derive(Clone, Copy)]
pub(super) enum Motion<C, const N: usize> {
    Exact(Flow<N>),
    Otherwise(C),
}

impl<C: Course, const N: usize> Course for Motion<C, N> {
    fn at(&self, fraction: f64, states: &mut [f64]) {
        match self {
            Motion::Exact(flow) => flow.at(fraction, states),
            Motion::Otherwise(course) => course.at(fraction, states),
        }
    }

    fn end_slopes(&self, slopes: &mut [f64]) {
        match self {
            Motion::Exact(flow) => flow.end_slopes(slopes),
            Motion::Otherwise(course) => course.end_slopes(slopes),
        }
    }

    fn fill(&self, times: &Times, columns: &mut [Vec<f64>]) {
        match self {
            Motion::Exact(flow) => flow.fill(times, columns),
            Motion::Otherwise(course) => course.fill(times, columns),
        }
    }
}

impl<S: Step<N>, const N: usize> Step<N> for Piecewise<S, N> {
    type Course = Motion<S::Course, N>;
    const ERROR_ORDER: i32 = S::ERROR_ORDER;
    const GAMMA: f64 = S::GAMMA;
    const DEFECT: f64 = S::DEFECT;

    fn begin(&mut self, equations: &mut dyn Equations, options: &Options) {
        self.flow = None;
        self.least = std::array::from_fn(|i| LEAST * equations.scales()[i]);
        self.is_linear = options.events && equations.is_piecewise_linear();
    }

    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool {
        if !self.is_linear {
            self.flow = None;
            return self.otherwise.attempt(equations, begin, h);
        }
        let flow = Flow::new(begin, h);
        self.end = flow.end_of(QUARTERS - 1);
        self.flow = Some(flow);
        self.end.iter().all(|x| x.is_finite())
    }

    fn evaluations(&self) -> u64 {
        if self.flow.is_some() { 0 } else { self.otherwise.evaluations() }
    }

    fn is_confirmed(
        &mut self,
        equations: &mut dyn Equations,
        begin: &Beginning<N>,
        to_event: bool,
        statistics: &mut Statistics,
    ) -> bool {
        let Some(flow) = &self.flow else { return true };
        // Rates may jump at an event.
        for quarter in 0..if to_event { QUARTERS - 1 } else { QUARTERS } {
            let time = begin.time + flow.time_at(quarter);
            let [expected, size] = flow.rates_at(quarter);
            let mut rates = [0.0; N];
            equations.rates(time, &flow.end_of(quarter), &mut rates);
            statistics.evaluations += 1;
            self.is_linear &= (0..N).all(|i| (rates[i] - expected[i]).abs() <= ROUNDING * size[i]);
        }
        self.is_linear
    }

    fn is_exact(&self) -> bool {
        self.flow.is_some()
    }

    fn end(&self) -> &[f64; N] {
        if self.flow.is_some() { &self.end } else { self.otherwise.end() }
    }

    fn error(&self) -> &[f64; N] {
        self.otherwise.error()
    }

    fn excess(&self, norm: impl Fn(&[f64; N], &[f64; N]) -> f64) -> f64 {
        match &self.flow {
            Some(flow) => flow.bend(&self.least) / BEND,
            None => self.otherwise.excess(norm),
        }
    }

    fn course(&self, begin: &Beginning<N>) -> Motion<S::Course, N> {
        match self.flow {
            Some(flow) => Motion::Exact(flow),
            None => Motion::Otherwise(self.otherwise.course(begin)),
        }
    }
}
