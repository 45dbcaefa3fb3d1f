//! Least squares over places from 0 to 1, for the solvers of `basin`.

use std::convert::Infallible;

use basin::{
    BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, DenseMatrix,
    Executor, Jacobian, PointState, Residual,
};

/// A place and its cost, half the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub places: Vec<f64>,
    pub cost: f64,
    /// Evaluations of the law over all experiments.
    pub evaluations: u64,
}

/// Residuals as functions of places.
pub(super) trait LeastSquares {
    /// Number of places.
    fn count(&self) -> usize;

    /// Evaluations that the derivatives take.
    fn work(&self) -> u64;

    /// The residuals.
    fn weighted(&self, places: &[f64]) -> Vec<f64>;

    /// Their derivatives, a column for each place.
    fn slopes(&self, places: &[f64]) -> Vec<Vec<f64>>;

    /// Half the sum of squares.
    fn cost(&self, places: &[f64]) -> f64;
}

/// The same with the bounds of the places.
pub(super) struct Bounded<'a, P> {
    problem: &'a P,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl<'a, P: LeastSquares> Bounded<'a, P> {
    pub fn new(problem: &'a P) -> Bounded<'a, P> {
        let [low, high] = [0.0, 1.0].map(|end| vec![end; problem.count()]);
        Bounded { problem, low, high }
    }

    /// Follows the slopes from places, in at most so many steps, until one gains less than a part of the cost.
    pub fn solve(self, start: Vec<f64>, gain: f64, steps: u64) -> Option<Found> {
        let work = self.problem.work();
        let solver = BoundedLevenbergMarquardt::new().with_relative_cost_change_tolerance(gain);
        let result = Executor::new(self, solver, PointState::new(start)).max_iter(steps).run().ok()?;
        let evaluations = result.counts.residual_evals + work * result.counts.jacobian_evals;
        Some(Found { places: result.param().clone(), cost: result.cost(), evaluations })
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

    fn cost(&self, places: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.problem.cost(places))
    }
}

impl<P: LeastSquares> Residual for Bounded<'_, P> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    fn residual(&self, places: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.problem.weighted(places))
    }
}

impl<P: LeastSquares> Jacobian for Bounded<'_, P> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, places: &Vec<f64>) -> Result<DenseMatrix, Infallible> {
        let columns = self.problem.slopes(places);
        let count = columns.first().map_or(0, Vec::len);
        let rows = (0..count).flat_map(|row| columns.iter().map(move |column| column[row]));
        Ok(DenseMatrix::from_row_slice(count, columns.len(), &rows.collect::<Vec<f64>>()))
    }
}
