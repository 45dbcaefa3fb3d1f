//! Least squares over points of a unit cube, whose coordinates are parameters scaled to their ranges, by `basin`.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::convert::Infallible;
use std::rc::Rc;

use basin::{
    BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, DenseMatrix,
    Executor, Jacobian, PointState, Residual,
};

/// A point of the unit cube and its cost, half the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub point: Vec<f64>,
    pub cost: f64,
    /// Evaluations of the law over all experiments.
    pub evaluations: u64,
}

/// Residuals as functions of a point.
pub(super) trait LeastSquares {
    /// Number of coordinates.
    fn count(&self) -> usize;

    /// Evaluations that the derivatives take.
    fn work(&self) -> u64;

    /// The residuals.
    fn weighted(&self, point: &[f64]) -> Vec<f64>;

    /// Their derivatives, a column for each coordinate.
    fn slopes(&self, point: &[f64]) -> Vec<Vec<f64>>;

    /// Half the sum of squares; it may be infinity where that is above a limit.
    fn cost(&self, point: &[f64], most: f64) -> f64;
}

/// Limits of the costs that matter, one for each of the points to come; none for those beyond them.
#[derive(Default)]
pub(super) struct Limits(RefCell<VecDeque<f64>>);

impl Limits {
    pub fn set(&self, costs: &[f64]) {
        self.0.replace(costs.iter().copied().collect());
    }

    fn next(&self) -> f64 {
        self.0.borrow_mut().pop_front().unwrap_or(f64::INFINITY)
    }
}

/// The same with the bounds of the coordinates.
pub(super) struct Bounded<'a, P> {
    problem: &'a P,
    low: Vec<f64>,
    high: Vec<f64>,
    limits: Rc<Limits>,
}

impl<'a, P: LeastSquares> Bounded<'a, P> {
    pub fn new(problem: &'a P) -> Bounded<'a, P> {
        let [low, high] = [0.0, 1.0].map(|end| vec![end; problem.count()]);
        Bounded { problem, low, high, limits: Rc::default() }
    }

    /// Limits of the costs to come.
    pub fn limits(&self) -> Rc<Limits> {
        Rc::clone(&self.limits)
    }

    /// Follows the slopes from a point, in at most so many steps, until one gains less than a part of the cost.
    pub fn solve(self, start: Vec<f64>, gain: f64, steps: u64) -> Option<Found> {
        let work = self.problem.work();
        let solver = BoundedLevenbergMarquardt::new().with_relative_cost_change_tolerance(gain);
        let result = Executor::new(self, solver, PointState::new(start)).max_iter(steps).run().ok()?;
        let evaluations = result.counts.residual_evals + work * result.counts.jacobian_evals;
        Some(Found { point: result.param().clone(), cost: result.cost(), evaluations })
    }
}

impl<P> Constraints for Bounded<'_, P> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.low), Some(&self.high)))
    }
}

impl<P: LeastSquares> CostFunction for Bounded<'_, P> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, point: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.problem.cost(point, self.limits.next()))
    }
}

impl<P: LeastSquares> Residual for Bounded<'_, P> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    fn residual(&self, point: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.problem.weighted(point))
    }
}

impl<P: LeastSquares> Jacobian for Bounded<'_, P> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, point: &Vec<f64>) -> Result<DenseMatrix, Infallible> {
        let columns = self.problem.slopes(point);
        let count = columns.first().map_or(0, Vec::len);
        let rows = (0..count).flat_map(|row| columns.iter().map(move |column| column[row]));
        Ok(DenseMatrix::from_row_slice(count, columns.len(), &rows.collect::<Vec<f64>>()))
    }
}
