//! The methods of this library.

use super::{End, Equations, Options, Recorder, Statistics, march, rodas5p, rosenbrock23};

/// A one-step method with exact Jacobian, dense output and located events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Rosenbrock method of order 5 (Rodas5P).
    Rodas5P,
    /// Modified Rosenbrock method of orders 2 and 3.
    Rosenbrock23,
}

/// A step of a method: from the states at its beginning to those at its end, with an estimate of the error.
pub(super) trait Step<const N: usize>: Default {
    /// Power of the step size with which the estimate of the error grows.
    const ERROR_ORDER: f64;

    /// Evaluations of the rates in an attempt whose beginning is known.
    const EVALUATIONS: u64;

    /// Makes a step of length h. False if it is impossible, because a matrix is singular or a number not finite.
    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool;

    /// The states at the end of the step.
    fn end(&self) -> &[f64; N];

    /// Estimate of the error of the states at the end of the step.
    fn error(&self) -> &[f64; N];

    /// The motion within the step.
    fn dense(&self, begin: &Beginning<N>) -> [[f64; 5]; N];
}

/// Beginning of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginning<const N: usize> {
    pub time: f64,
    pub states: [f64; N],
    pub rates: [f64; N],
    pub jacobian: [[f64; N]; N],
    pub by_time: [f64; N],
}

impl Method {
    /// Runs a method with as many states as the equations have; the workspace is on the stack, and the loops over few
    /// states are unrolled.
    pub(super) fn run(
        self,
        equations: &mut dyn Equations,
        states: &mut [f64],
        options: &Options,
        recorder: &mut Recorder,
    ) -> (End, Statistics) {
        macro_rules! sizes {
            ($($n:literal)+) => {
                match states.len() {
                    $($n => match self {
                        Method::Rodas5P => march::run::<rodas5p::Rodas5P<$n>, $n>(equations, states, options, recorder),
                        Method::Rosenbrock23 =>
                            march::run::<rosenbrock23::Rosenbrock23<$n>, $n>(equations, states, options, recorder),
                    },)+
                    count => {
                        let reason = format!("{count} states; the limit is {MOST_STATES}");
                        (End::Failed { time: options.begin, reason }, Statistics::default())
                    }
                }
            };
        }
        sizes!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32)
    }
}

/// Largest number of states.
const MOST_STATES: usize = 32;
