//! The search for the best values: over the whole range, then along the slopes.

use std::sync::atomic::{AtomicBool, Ordering};

use basin::{
    BoundedLevenbergMarquardt, De, DeMutation, Executor, PointState, PopulationProgress, Ssga, State, StepOutcome,
};

use super::problem::Problem;

/// How the whole range is searched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Differential evolution, then least squares from the best place.
    #[default]
    Evolution,
    /// A genetic algorithm alone, as the thesis does: for comparison.
    Genetic,
}

/// A place and its cost, half the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub places: Vec<f64>,
    pub cost: f64,
    /// Evaluations of the law over all experiments.
    pub evaluations: u64,
}

/// Hears of a search that is under way, and may end it.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Ends the search early; the best so far is kept.
    pub cancel: &'a AtomicBool,
    /// Root mean square of the residuals at the best place so far, N, and the evaluations that led there. It is called
    /// after each generation and each repetition.
    pub progress: &'a (dyn Fn(f64, u64) + Sync),
}

/// Members of a population for each unknown, the least of them all, and generations (chosen: twice what LuGre needs).
const MEMBERS: usize = 8;
const LEAST_MEMBERS: usize = 24;
const GENERATIONS: u64 = 60;
/// Generations without a gain of a thousandth of the cost after which the search ends (chosen).
const PATIENCE: u64 = 12;

/// Searches the whole range.
pub(super) fn search(problem: &Problem, method: Method, seed: u64, budget: u64, watch: Watch) -> Found {
    let members = (MEMBERS * problem.unknowns.len()).max(LEAST_MEMBERS);
    let empty = PopulationProgress::<Vec<f64>>::empty();
    match method {
        Method::Evolution => {
            let solver =
                De::new(seed).with_pop_size(members).with_mutation(DeMutation::CurrentToBest1).with_dither(0.5, 1.0);
            let generations = budget / members as u64;
            run(Executor::new(problem.clone(), solver, empty), generations.clamp(1, GENERATIONS), problem, watch)
        }
        Method::Genetic => {
            // It replaces two members at a time.
            let executor = Executor::new(problem.clone(), Ssga::new(seed), empty);
            run(executor, (budget.saturating_sub(60) / 2).max(1), problem, watch)
        }
    }
}

fn run<S>(
    executor: Executor<Problem<'_>, PopulationProgress<Vec<f64>>, S>,
    generations: u64,
    problem: &Problem,
    watch: Watch,
) -> Found
where
    S: for<'a> basin::Solver<Problem<'a>, PopulationProgress<Vec<f64>>>,
{
    let Ok(mut stepper) = executor.max_iter(generations).into_stepper() else { return nothing(problem) };
    let (mut last, mut idle) = (f64::INFINITY, 0);
    while let Ok(StepOutcome::Continue) = stepper.step() {
        let cost = stepper.state().cost();
        (watch.progress)((2.0 * cost / problem.samples() as f64).sqrt(), stepper.counts().cost_evals);
        idle = if cost < 0.999 * last { 0 } else { idle + 1 };
        last = last.min(cost);
        if idle >= PATIENCE * patience(generations) || watch.cancel.load(Ordering::Relaxed) {
            break;
        }
    }
    let evaluations = stepper.counts().cost_evals;
    let state = stepper.state();
    Found { places: problem.whole(state.param()), cost: state.cost(), evaluations }
}

/// A search that could not begin.
fn nothing(problem: &Problem) -> Found {
    Found { places: vec![0.5; problem.unknowns.len()], cost: f64::INFINITY, evaluations: 0 }
}

/// A method with many small generations waits longer.
fn patience(generations: u64) -> u64 {
    generations.div_ceil(GENERATIONS)
}

/// Steps of least squares (chosen).
const MOST_STEPS: u64 = 60;

/// Follows the slopes from a place; the free unknowns of the problem only.
pub(super) fn polish(problem: &Problem, from: &Found) -> Found {
    let is_free = |number: &usize| problem.pinned[*number].is_none();
    let start: Vec<f64> = (0..problem.unknowns.len()).filter(is_free).map(|number| from.places[number]).collect();
    if start.is_empty() {
        return from.clone();
    }
    let solver = BoundedLevenbergMarquardt::new().with_relative_cost_change_tolerance(1e-10);
    let executor = Executor::new(problem.clone(), solver, PointState::new(start)).max_iter(MOST_STEPS);
    let Ok(result) = executor.run() else { return from.clone() };
    let work = |count: u64| count * problem.unknowns.len() as u64;
    let evaluations = from.evaluations + result.counts.residual_evals + work(result.counts.jacobian_evals);
    if result.cost() < from.cost {
        Found { places: problem.whole(result.param()), cost: result.cost(), evaluations }
    } else {
        Found { evaluations, ..from.clone() }
    }
}
