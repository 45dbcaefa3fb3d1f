//! The search for the best values: over the whole range, then along the slopes.

use std::sync::atomic::{AtomicBool, Ordering};

use basin::{De, DeMutation, Executor, PopulationProgress, Ssga, State, StepOutcome};
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

use super::least_squares::Bounded;
use super::problem::{Found, Problem};
use super::uncertainty::{Residuals, SYSTEMATIC};
use super::{BUDGET, Experiment, Settings};

/// How the whole range is searched.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize, ValueEnum, TS)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Differential evolution, then bounded least squares
    #[default]
    Evolution,
    /// A genetic algorithm alone, as the thesis does: for comparison
    Genetic,
}

/// Hears of a search that is under way, and may end it.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Ends the search early; the best so far is kept.
    pub cancel: &'a AtomicBool,
    /// Root mean square of the residuals at the best point so far, N, and the evaluations that led there. It is called
    /// after each generation and each repetition.
    pub progress: &'a (dyn Fn(f64, u64) + Sync),
}

impl Watch<'_> {
    pub(super) fn is_cancelled(self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

/// Ends of searches over the whole range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Searches {
    /// Two of them have found the same.
    Agree,
    /// No two of them have.
    Disagree,
    /// There was one: another law explains far more.
    One,
    /// They were ended early.
    Ended,
}

impl Searches {
    /// The same for judging values: one genetic algorithm hardly ever ends where another one does.
    pub(super) fn believed(self, method: Method) -> Searches {
        if method == Method::Genetic { Searches::Agree } else { self }
    }

    /// Reason for which nothing is determined.
    pub(super) fn doubt(self) -> Option<&'static str> {
        match self {
            Searches::Agree | Searches::Ended => None,
            Searches::Disagree => {
                Some("searches over the whole range end at different values; narrow the ranges, or raise the budget")
            }
            Searches::One => Some("another law explains far more, so that this one was searched once only"),
        }
    }

    /// Note in a ranking.
    pub fn note(self) -> Option<&'static str> {
        match self {
            Searches::Agree => None,
            Searches::Disagree => Some("the searches did not agree"),
            Searches::One => Some("far behind, searched once"),
            Searches::Ended => Some("ended early"),
        }
    }
}

/// Knowledge about a law before its search.
#[derive(Default)]
pub(super) struct First {
    /// Where the first search over the whole range ended.
    pub found: Option<Found>,
    /// Whether another law explains far more: no other search is made then.
    pub is_far: bool,
}

/// Where the first search over the whole range ends.
pub(super) fn first_search(problem: &Problem, task: &Settings, watch: Watch) -> Found {
    let fewer = coarser(problem, task);
    one_search(&coarse(problem, fewer.as_deref()), task, 0, watch)
}

/// Rounds of searches, each with twice the budget of the one before, until two of them agree (chosen).
const ROUNDS: u32 = 3;

/// Part of the sum of squares of the force below which costs do not differ (chosen).
const ROUNDING: f64 = 1e-9;

/// The experiments with fewer samples, for searches; None if they have few, or if the search shall see all.
fn coarser(problem: &Problem, task: &Settings) -> Option<Vec<Experiment>> {
    let parts = problem.samples().div_ceil(SEARCHED);
    let coarser: Vec<Experiment> = problem.experiments.iter().map(|one| one.coarser(parts)).collect();
    let is_thinned = parts > 1 && task.method == Method::Evolution && coarser.iter().all(|one| one.time.len() > 2);
    is_thinned.then_some(coarser)
}

fn coarse<'a>(problem: &Problem<'a>, coarser: Option<&'a [Experiment]>) -> Problem<'a> {
    Problem { experiments: coarser.unwrap_or(problem.experiments), ..problem.clone() }
}

/// Outcome of the searches over the whole range.
pub(super) struct Best {
    /// The best point.
    pub found: Found,
    /// Whether two searches with different seeds have found it: it is then hardly one of several.
    pub searches: Searches,
    /// Points at which the two best searches ended.
    pub ends: Vec<Vec<f64>>,
}

/// Searches the whole range; for a fit with intervals again, if the residuals of the best point are not noise: two
/// searches may agree on a local minimum. Many laws are ranked although they do not fit.
pub(super) fn best(problem: &Problem, task: &Settings, watch: Watch, first: First) -> Best {
    let is_once = !task.profiles || task.method != Method::Evolution || first.is_far;
    let best = once(problem, task, watch, first);
    let left = if is_once || watch.is_cancelled() { None } else { problem.residuals(&best.found.point) };
    let Some(residuals) =
        left.map(|left| Residuals::of_fit(problem, &left)).filter(|residuals| residuals.correlation > SYSTEMATIC)
    else {
        return best;
    };
    let other = once(problem, &Settings { seed: !task.seed, ..task.clone() }, watch, First::default());
    if 2.0 * (best.found.cost - other.found.cost) > residuals.rise() { other } else { best }
}

/// The searches go over fewer samples; only the best of their ends is followed on all of them.
fn once(problem: &Problem, task: &Settings, watch: Watch, First { found, is_far }: First) -> Best {
    let fewer = coarser(problem, task);
    let coarse = coarse(problem, fewer.as_deref());
    let (mut ends, searches) = match found.map(|found| coarse.judge(found)) {
        Some(first) if is_far => (vec![first], Searches::One),
        Some(first) if watch.is_cancelled() => (vec![first], Searches::Ended),
        first => several(&coarse, task, watch, first),
    };
    let compared = if searches == Searches::Ended { 0 } else { 2 };
    let point = ends.iter().take(compared).map(|found| found.point.clone()).collect();
    let evaluations = ends.iter().map(|found| found.evaluations).sum();
    let mut found = Found { evaluations, ..ends.swap_remove(0) };
    if fewer.is_some() {
        found = problem.judge(found);
        if !watch.is_cancelled() {
            found = polish(problem, &found);
        }
    }
    Best { found, searches, ends: point }
}

/// Ends of searches, the best first, made until two of them agree.
fn several(coarse: &Problem, task: &Settings, watch: Watch, mut first: Option<Found>) -> (Vec<Found>, Searches) {
    let rounding = ROUNDING * coarse.measured().iter().map(|force| force * force).sum::<f64>();
    let mut ends: Vec<Found> = Vec::new();
    for round in 0..ROUNDS {
        ends.extend(two_searches(coarse, task, round, first.take(), watch));
        ends.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let variance = 2.0 * ends[0].cost / coarse.samples() as f64;
        if 2.0 * (ends[1].cost - ends[0].cost) <= variance.max(rounding) {
            return (ends, Searches::Agree);
        }
        if watch.is_cancelled() {
            return (ends, Searches::Ended);
        }
        if task.method == Method::Genetic {
            break;
        }
    }
    (ends, Searches::Disagree)
}

/// Samples on which the whole range is searched (chosen): more only make it slower.
const SEARCHED: usize = 2000;

/// A search and what least squares make of its end. Each number has its seed, each pair of numbers its budget.
fn one_search(problem: &Problem, task: &Settings, number: u32, watch: Watch) -> Found {
    let seed = task.seed ^ u64::from(number).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let seed = fastrand::Rng::with_seed(seed).u64(..);
    let found = search(problem, task.method, seed, task.budget << (number / 2), watch);
    if task.method == Method::Genetic || watch.is_cancelled() { found } else { polish(problem, &found) }
}

/// Two searches with different seeds, side by side; the first one may be known.
fn two_searches(problem: &Problem, task: &Settings, round: u32, first: Option<Found>, watch: Watch) -> Vec<Found> {
    let run = |number: u32| one_search(problem, task, 2 * round + number, watch);
    if let Some(first) = first {
        return vec![first, run(1)];
    }
    // In a browser this library has no threads.
    if cfg!(target_family = "wasm") {
        return vec![run(0), run(1)];
    }
    std::thread::scope(|scope| {
        let second = scope.spawn(move || run(1));
        let first = run(0);
        std::iter::once(first).chain(second.join()).collect()
    })
}

/// Members of a population for each parameter, the least of them all, and generations in the usual budget, or in
/// proportion to a larger one (chosen: twice what LuGre needs).
const MEMBERS: usize = 8;
const LEAST_MEMBERS: usize = 24;
const GENERATIONS: u64 = 60;
/// Generations without a gain of a thousandth of the cost after which the search ends (chosen).
const PATIENCE: u64 = 12;

/// Searches the whole range.
fn search(problem: &Problem, method: Method, seed: u64, budget: u64, watch: Watch) -> Found {
    match method {
        Method::Evolution => {
            let members = (MEMBERS * problem.parameters.len()).max(LEAST_MEMBERS);
            let solver =
                De::new(seed).with_pop_size(members).with_mutation(DeMutation::CurrentToBest1).with_dither(0.5, 1.0);
            let most = GENERATIONS.saturating_mul(budget.max(BUDGET)) / BUDGET;
            run(solver, (budget / members as u64).clamp(1, most), true, problem, watch)
        }
        // It replaces two members at a time.
        Method::Genetic => run(Ssga::new(seed), (budget.saturating_sub(60) / 2).max(1), false, problem, watch),
    }
}

/// Generations of a method. If it `replaces_each` member only by a better point, one for each in their order, the costs of
/// the members are the limits above which those of the points do not matter.
fn run<S>(solver: S, generations: u64, replaces_each: bool, problem: &Problem, watch: Watch) -> Found
where
    S: for<'a, 'b> basin::Solver<Bounded<'a, Problem<'b>>, PopulationProgress<Vec<f64>>>,
{
    let bounded = Bounded::new(problem);
    let limits = bounded.limits();
    let executor = Executor::new(bounded, solver, PopulationProgress::empty());
    let Ok(mut stepper) = executor.max_iter(generations).into_stepper() else {
        let point = vec![0.5; problem.parameters.len()];
        return Found { point, cost: f64::INFINITY, evaluations: 0 };
    };
    // A method with many small generations waits longer.
    let patience = PATIENCE * generations.div_ceil(GENERATIONS);
    let (mut last, mut idle) = (f64::INFINITY, 0);
    loop {
        if replaces_each {
            limits.set(stepper.state().costs());
        }
        let Ok(StepOutcome::Continue) = stepper.step() else { break };
        let cost = stepper.state().cost();
        (watch.progress)((2.0 * cost / problem.samples() as f64).sqrt(), stepper.counts().cost_evals);
        idle = if cost < 0.999 * last { 0 } else { idle + 1 };
        last = last.min(cost);
        if idle >= patience || watch.is_cancelled() {
            break;
        }
    }
    let evaluations = stepper.counts().cost_evals;
    let state = stepper.state();
    Found { point: problem.whole(state.param()), cost: state.cost(), evaluations }
}

/// Steps of least squares (chosen).
const MOST_STEPS: u64 = 60;

/// Part of the cost that a step of least squares must gain for another one to follow (chosen).
const GAIN: f64 = 1e-8;

/// Follows the slopes from a point; the free parameters of the problem only.
pub(super) fn polish(problem: &Problem, from: &Found) -> Found {
    polish_until(problem, from, GAIN)
}

/// The same until a step gains less than a part of the cost. A step that leads a parameter out of its range is cut short,
/// and with it those of the others: they go on without the parameters that have come to ends of their ranges, and then with
/// them again.
pub(super) fn polish_until(problem: &Problem, from: &Found, gain: f64) -> Found {
    let mut found = follow(problem, from, gain);
    for _ in 0..DETOURS {
        let Some(inside) = without_ends(problem, &found.point) else { break };
        let moved = follow(&inside, &found, gain);
        let is_better = moved.cost < (1.0 - gain) * found.cost;
        found = moved;
        if !is_better {
            break;
        }
        found = follow(problem, &found, gain);
    }
    found
}

/// How often least squares go on without the parameters at ends of their ranges (chosen).
const DETOURS: usize = 4;

/// Distance from an end of a range, as a part of it, at which a parameter stops the others (chosen).
const EDGE: f64 = 1e-4;

/// A problem in which the parameters at ends of their ranges are held; None if there are none.
fn without_ends<'a>(problem: &Problem<'a>, point: &[f64]) -> Option<Problem<'a>> {
    let mut inside = problem.clone();
    let at_ends = problem.free().filter(|number| !(EDGE..=1.0 - EDGE).contains(&point[*number]));
    at_ends.for_each(|number| inside.pin(number, point[number]));
    (inside.pinned != problem.pinned).then_some(inside)
}

/// Steps of least squares until one gains less than a part of the cost.
fn follow(problem: &Problem, from: &Found, gain: f64) -> Found {
    let start: Vec<f64> = problem.free().map(|number| from.point[number]).collect();
    if start.is_empty() {
        return from.clone();
    }
    let Some(end) = Bounded::new(problem).solve(start, gain, MOST_STEPS) else { return from.clone() };
    let evaluations = from.evaluations + end.evaluations;
    if end.cost < from.cost {
        Found { point: problem.whole(&end.point), cost: end.cost, evaluations }
    } else {
        Found { evaluations, ..from.clone() }
    }
}

#[cfg(test)]
mod tests {
    use stribeck::catalogue::by_name;

    use super::super::Experiment;
    use super::super::tests::{fitted, measured, standard, whole_problem};
    use super::*;
    use crate::rig::{Faults, VirtualRig};
    use stribeck_measured::{Delay, Record, Setup};
    use stribeck_sheet::Sheet;

    /// From points without viscous friction: to hold it at 0 does not lead farther down.
    #[test]
    fn an_unknown_at_an_end_of_its_range_does_not_stop_the_others() {
        for (law, seed) in [("Andersson", 2), ("LuGre", 5), ("MaxwellSlip", 6), ("SpeckerDynamic", 7)] {
            let data = [measured(law, &[], &standard(1000), 0.01, seed)];
            let problem = whole_problem(law, &data);
            let mut random = fastrand::Rng::with_seed(seed);
            let viscous = problem.parameters.iter().position(|one| one.name == "viscous_coefficient").unwrap();
            let coordinate = |number: usize| if number == viscous { 0.0 } else { 0.3 + 0.4 * random.f64() };
            let point = (0..problem.parameters.len()).map(coordinate).collect();
            let start = Found { point, cost: f64::INFINITY, evaluations: 0 };
            let end = polish(&problem, &start);
            let mut without = problem.clone();
            without.pin(viscous, 0.0);
            let mut held = end.clone();
            held.point[viscous] = 0.0;
            let held = polish(&without, &Found { cost: f64::INFINITY, ..held });
            assert!(end.cost < (1.0 + 1e-6) * held.cost, "{law} {seed}: {} {}", end.cost, held.cost);
        }
    }

    /// Members that are left as soon as they are worse than those before them are the ones that would not have stayed.
    #[test]
    fn a_search_that_leaves_bad_points_early_finds_the_same() {
        let data = [measured("Leuven", &[], &standard(300), 0.01, 5)];
        let problem = whole_problem("Leuven", &data);
        let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
        let [early, late] = [true, false].map(|replaces_each| {
            let solver = De::new(8).with_pop_size(30).with_mutation(DeMutation::CurrentToBest1).with_dither(0.5, 1.0);
            run(solver, 25, replaces_each, &problem, watch)
        });
        assert!(early.cost.is_finite() && early.evaluations > 30 * 20);
        assert_eq!(early, late);
    }

    /// A record for which two searches agree on a local minimum.
    #[test]
    fn residuals_that_are_not_noise_are_searched_again() {
        let faults = Faults::NOISE;
        let law = by_name("Leuven").unwrap();
        let rig =
            VirtualRig { law, values: Vec::new(), mass: 2.0, normal_force: 20.0, duration: 4.0, faults, seed: 31_014 };
        let known = Setup { mass: 2.0, normal_force: Some(20.0), delay: Delay::Known(0.0), ..Setup::default() };
        let record = Record::of(&Sheet::parse(&rig.record().unwrap().force).unwrap(), None, &known).unwrap();
        let experiment = Experiment::new(law.name, &record);
        let without = Settings { mass: 2.0, profiles: false, repetitions: 0, ..Settings::default() };
        let fits = [without.clone(), Settings { profiles: true, ..without }]
            .map(|task| fitted("Leuven", std::slice::from_ref(&experiment), &task));
        assert!(fits.iter().all(|fit| fit.searches == Searches::Agree));
        let [local, found] = fits.map(|fit| fit.residuals);
        assert!(local.correlation > 3.0 && found.correlation < 2.0, "{local:?} {found:?}");
        assert!(found.rms < 0.99 * local.rms, "{local:?} {found:?}");
    }
}
