//! A step of a one-step method.

use super::recorder::Course;
use super::{Equations, Options, Statistics};

/// A step of a method: from the states at its beginning to those at its end, with an estimate of the error.
pub(super) trait Step<const N: usize>: Default {
    /// Motion within a step.
    type Course: Course + Copy;

    /// Power of the step size with which the estimate of the error grows.
    const ERROR_ORDER: i32;

    /// Coefficient of the Jacobian in the matrix of the stages.
    const GAMMA: f64;

    /// Largest defect at the end of a step, in parts of the tolerance.
    const DEFECT: f64;

    /// Takes note of an event, such as the beginning of a run.
    fn begin(&mut self, _equations: &mut dyn Equations, _options: &Options) {}

    /// Takes note of the step made last: it counts.
    fn accept(&mut self, _equations: &mut dyn Equations) {}

    /// Makes a step of length h. False if it is impossible, because a matrix is singular or a number not finite.
    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool;

    /// Evaluations of the rates in an attempt.
    fn evaluations(&self) -> u64;

    /// Whether the equations are what the attempt made last takes them for, up to the end of the step or to an event there.
    /// If they are not, the next attempt does without.
    fn is_confirmed(
        &mut self,
        _equations: &mut dyn Equations,
        _begin: &Beginning<N>,
        _to_event: bool,
        _statistics: &mut Statistics,
    ) -> bool {
        true
    }

    /// Whether the motion in the attempt made last is as exact as numbers are, if it is confirmed.
    fn is_exact(&self) -> bool {
        false
    }

    /// Whether steps end at output times, because the motion within them is not known as a course.
    fn ends_at_results(&self) -> bool {
        false
    }

    /// The states at the end of the step.
    fn end(&self) -> &[f64; N];

    /// Estimate of the error of the states at the end of the step.
    fn error(&self) -> &[f64; N];

    /// The error in parts of what is allowed, by a norm of errors beside the states at the end.
    fn excess(&self, norm: impl Fn(&[f64; N], &[f64; N]) -> f64) -> f64 {
        norm(self.error(), self.end())
    }

    /// The motion within the step.
    fn course(&self, begin: &Beginning<N>) -> Self::Course;
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
