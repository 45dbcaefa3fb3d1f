//! Identification: the parameters of a law from measured friction, and how far to trust them.
//!
//! A law is led through the motion and the load of the experiments. Its parameters are searched over a range that
//! follows from the data and their units, then by bounded least squares with exact sensitivities where the steps of the
//! law are written for dual numbers, and with central differences elsewhere. What the data do not determine gets no
//! number.
//!
//! # Source
//! Settings and figures: chapter 8 of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc
//! thesis, University of Minho (2024). Differential evolution: R. Storn, K. Price, Journal of Global Optimization 11
//! (1997), doi:10.1023/A:1008202821328.

mod answer;
pub mod axis;
#[cfg(test)]
mod axis_tests;
pub mod damper;
#[cfg(test)]
mod ended_tests;
mod estimate;
mod experiment;
mod inquiry;
#[cfg(test)]
mod inquiry_tests;
mod interval;
mod loss;
mod output;
mod parameter;
mod problem;
mod rank;
mod refine;
mod response;
mod search;
mod strut;
#[cfg(test)]
mod strut_tests;
#[cfg(test)]
mod tests;
pub mod tyre;
mod uncertainty;
mod validation;
mod velocity_error;
mod warnings;

use std::sync::Mutex;
use std::sync::atomic::Ordering;

use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::ModelType;

pub use answer::{Answer, FittedLaw, FittedParameter, RefusedLaw};
pub use estimate::Estimate;
pub use experiment::{Experiment, Rest, names};

pub use inquiry::{Data, DelayChoice, Files, Inquiry, LossChoice, Source};
pub use output::{Difference, EARLY, Reference, difference, known, of_law, preset, respond};
pub use parameter::{Parameter, Scale, Selection, Target};
pub use rank::{APART, Rank, rank};
pub use response::Ports;
pub use search::{Method, Searches, Watch};
pub use strut::{StrutFriction, strut_friction};
pub use uncertainty::{DETERMINED, Residuals, Verdict, digits, digits_within};
pub use validation::{Validation, held_out};

use interval::{Ended, repetitions};
use loss::Loss;
use parameter::OF_RIG;
use problem::Found;
use problem::Problem;
use refine::refine;
use response::Exact;
use search::{Best, best, first_look, polish};
use stribeck_solve::system::Fault;
use stribeck_solve::work::share;
use uncertainty::{Uncertainty, residuals, uncertainty};
use validation::{check_folds, folds};
use warnings::warnings;

/// How a law is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Choice of the parameters, and the ranges in which they are searched.
    pub selection: Selection,
    /// How the whole range is searched.
    pub method: Method,
    /// Seed of the search and of the repetitions.
    pub seed: u64,
    /// Evaluations of the law in each search over the whole range.
    pub budget: u64,
    /// Whether the profile likelihood is followed.
    pub profiles: bool,
    /// Number of repetitions with blocks of residuals; 0 for none.
    pub repetitions: usize,
    /// Mass between load cell and contact, kg, unless it is fitted.
    pub mass: f64,
    /// Whether outliers count less than by their squares.
    pub is_robust: bool,
    /// Parts into which the experiments are divided for cross-validation; 0 for none.
    pub folds: usize,
}

impl Settings {
    /// The task for one of several laws.
    fn of(&self, law: &ModelType, laws: &[&ModelType]) -> Settings {
        Settings { selection: self.selection.of(law, laws), ..self.clone() }
    }
}

impl Default for Settings {
    /// The usual number of evaluations, profiles, 40 repetitions (chosen).
    fn default() -> Settings {
        Settings {
            selection: Selection::default(),
            method: Method::Evolution,
            seed: 1,
            budget: BUDGET,
            profiles: true,
            repetitions: 40,
            mass: 0.0,
            is_robust: false,
            folds: 0,
        }
    }
}

/// Evaluations in a search, unless others are wanted (chosen).
const BUDGET: u64 = 3000;

/// A law fitted to experiments.
#[derive(Clone, Debug)]
pub struct Fit {
    /// The law.
    pub law: &'static ModelType,
    /// The parameters; mu_s, which follows from two of them, after them.
    pub estimates: Vec<Estimate>,
    /// Correlations among the parameters.
    pub correlation: Vec<Vec<f64>>,
    /// Ratio of the best to the worst known direction.
    pub condition: f64,
    /// The residuals.
    pub residuals: Residuals,
    /// Number of samples.
    pub samples: usize,
    /// Largest force, N.
    pub level: f64,
    /// Evaluations of the law.
    pub evaluations: u64,
    /// Whether several searches over the whole range found the same values.
    pub searches: Searches,
    /// Whether it was ended early.
    pub is_cancelled: bool,
    /// Whether the sensitivities are exact.
    pub is_exact: bool,
    /// Forces that the law explains, for each experiment.
    pub predicted: Vec<Vec<f64>>,
    /// Whether each sample of each experiment was fitted.
    pub fitted: Vec<Vec<bool>>,
    /// Values of the columns of the law.
    pub columns: Vec<(usize, f64)>,
    /// The columns among them that were held.
    pub held: Vec<(usize, f64)>,
    /// Mass of the rig, as given or fitted, kg.
    pub mass: f64,
    /// Offset of the load cell, N.
    pub offset: f64,
    /// Delay of the motion behind the force, if it was fitted or held, s.
    pub delay: Option<f64>,
    /// Normal force of an axis, N, whose coefficient of friction is a force if that is 1 N.
    pub axis_load: Option<f64>,
    /// Parts into which the intervals between samples were divided.
    pub parts: usize,
    /// Residuals in experiments that were not fitted.
    pub validation: Vec<Validation>,
    /// Warnings for the user.
    pub warnings: Vec<String>,
}

impl Fit {
    /// Number of parameters.
    pub fn parameters(&self) -> usize {
        self.correlation.len()
    }

    /// Adds what is left in experiments that were not fitted, with a warning where that is more.
    pub fn saw(&mut self, validation: Vec<Validation>) {
        self.warnings.extend(validation.iter().filter_map(Validation::warning));
        self.validation.extend(validation);
    }
}

/// The laws that can be fitted: those of one sliding direction.
pub fn laws() -> impl Iterator<Item = &'static ModelType> {
    catalogue::documented(Family::Friction).map(|(law, _)| law).filter(|law| Ports::of(law).is_some())
}

/// The laws of these names, or all that can be fitted for the name `all`.
pub fn laws_named(names: &[String]) -> Result<Vec<&'static ModelType>, Fault> {
    if names.iter().any(|name| name == "all") {
        return Ok(laws().collect());
    }
    let known = || laws().map(|law| law.name);
    if let Some(twice) = (1..names.len()).map(|at| &names[at]).zip(1..).find(|(name, at)| names[..*at].contains(name)) {
        return Err(Fault::value(format_args!("friction law '{}' is given twice", twice.0)));
    }
    let find = |name: &String| catalogue::by_name(name).ok_or_else(|| Fault::unknown("friction law", name, known()));
    names.iter().map(find).collect()
}

/// Laws fitted to the same experiments.
#[derive(Clone, Debug)]
pub struct Ranking {
    /// The fits.
    pub fits: Vec<Fit>,
    /// Their places, the best first; there is at least one.
    pub ranks: Vec<Rank>,
    /// Laws that cannot be fitted, with the reason.
    pub refused: Vec<(&'static str, String)>,
}

impl Ranking {
    /// The best fit.
    pub fn best(&self) -> &Fit {
        &self.fits[self.ranks[0].fit]
    }
}

/// Root mean square left by a law after one search, as a multiple of the least among the laws, from which it is not
/// searched again (chosen). In six records of each law, one search for the law that made the data ended within 1.2 of
/// the best one, and within 1.7 for `FrictionalLag`.
const FAR: f64 = 2.0;

/// Fits laws to the same experiments and ranks them; the best of several once more with all intervals. Each law is
/// searched once, then those that may be the best again, as if they were alone. `begin` hears of each law. As many laws
/// are under way at once as the machine has cores; their number changes no result.
pub fn fit_all(
    laws: &[&'static ModelType],
    experiments: &[Experiment],
    task: &Settings,
    begin: &mut (dyn FnMut(&'static ModelType) + Send),
    watch: Watch,
) -> Result<Ranking, Fault> {
    let is_ranked = laws.len() > 1 && task.method == Method::Evolution;
    let quick =
        if laws.len() > 1 { Settings { profiles: false, repetitions: 0, ..task.clone() } } else { task.clone() };
    let look = |law| Some(first_look(&problem(law, experiments, &quick.of(law, laws)).ok()?, &quick, watch));
    let looked = if is_ranked { side_by_side(laws, begin, watch, true, |_, law| look(law)) } else { Vec::new() };
    let seen: Vec<Option<Found>> = looked.iter().cloned().map(Option::flatten).collect();
    let least = seen.iter().flatten().map(|found| found.cost).fold(f64::INFINITY, f64::min);
    let one = |number: usize, law: &'static ModelType| {
        let first = seen.get(number).cloned().flatten();
        let is_far = first.as_ref().is_some_and(|first| first.cost > FAR * FAR * least);
        let was_reached = !is_ranked || looked.get(number).is_some_and(Option::is_some);
        was_reached.then(|| fit_from(law, experiments, &quick.of(law, laws), watch, first, is_far))
    };
    let (mut fits, mut refused, mut reason) = (Vec::new(), Vec::new(), Fault::value("no law was given"));
    // After an early end, what was found by then is ranked.
    for (law, found) in laws.iter().zip(side_by_side(laws, begin, watch, !is_ranked, one)) {
        match found.flatten() {
            Some(Ok(fit)) => fits.push(fit),
            Some(Err(fault)) => {
                refused.push((law.name, fault.to_string()));
                reason = fault;
            }
            None => refused.push((law.name, format!("{}: not reached before the end", law.name))),
        }
    }
    let mut ranks = rank(&fits);
    let Some(best) = ranks.first().map(|place| place.fit) else { return Err(reason) };
    if laws.len() > 1 && !fits[best].is_cancelled {
        let law = fits[best].law;
        begin(law);
        let first = laws.iter().position(|other| other.name == law.name).and_then(|at| seen.get(at).cloned());
        let whole = fit_from(law, experiments, &task.of(law, laws), watch, first.flatten(), false)?;
        ranks = with_whole(&mut fits, best, whole).unwrap_or(ranks);
    }
    Ok(Ranking { fits, ranks, refused })
}

/// Puts the whole fit of the best law into its place, and ranks anew: it may have been searched again. None if the ranking
/// stays, because the whole fit leaves other samples out.
fn with_whole(fits: &mut [Fit], best: usize, whole: Fit) -> Option<Vec<Rank>> {
    let is_of_the_same = whole.samples == fits[best].samples;
    fits[best] = whole;
    let ranks = rank(fits);
    (is_of_the_same && ranks[0].fit == best).then_some(ranks)
}

/// Work on laws, in their order; None for those that were not begun before an early end, if it stops there.
fn side_by_side<T: Send>(
    laws: &[&'static ModelType],
    begin: &mut (dyn FnMut(&'static ModelType) + Send),
    watch: Watch,
    stops: bool,
    work: impl Fn(usize, &'static ModelType) -> T + Sync,
) -> Vec<Option<T>> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let found = Mutex::new(laws.iter().map(|_| None).collect::<Vec<Option<T>>>());
    let one = |number: usize| {
        let one = work(number, laws[number]);
        if let Ok(mut found) = found.lock() {
            found[number] = Some(one);
        }
    };
    let begins = |number: usize| {
        let is_begun = !(stops && number > 0 && watch.cancel.load(Ordering::Relaxed));
        if is_begun {
            begin(laws[number]);
        }
        is_begun
    };
    share(laws.len(), cores, begins, || one);
    found.into_inner().unwrap_or_default()
}

/// Fits a law to experiments.
pub fn fit(law: &'static ModelType, experiments: &[Experiment], task: &Settings, watch: Watch) -> Result<Fit, Fault> {
    fit_from(law, experiments, task, watch, None, false)
}

/// As [`fit`], with the end of the first search if it is known; no other search is made for a law that is far behind.
fn fit_from(
    law: &'static ModelType,
    experiments: &[Experiment],
    task: &Settings,
    watch: Watch,
    first: Option<Found>,
    is_far: bool,
) -> Result<Fit, Fault> {
    let prepared = prepared(law, experiments, task);
    let experiments = prepared.as_deref().unwrap_or(experiments);
    let mut problem = problem(law, experiments, task)?;
    let found = best(&problem, task, watch, first, is_far);
    let again = if is_far { None } else { searched_again(&problem, &found.found, task, watch) };
    let Best { found: best, searches, mut ends } = again.unwrap_or(found);
    if task.method == Method::Genetic {
        // One hardly ever ends where another one does.
        ends.clear();
    }
    if !best.cost.is_finite() {
        return Err(Fault::value(format_args!("{}: the law is refused everywhere in the ranges", law.name)));
    }
    let settled;
    let (mut best, mut shift) = refine(&mut problem, best, task, watch);
    if let Some(experiments) = at_rest_anew(&problem, &best.places) {
        settled = experiments;
        problem.experiments = &settled;
        best = polish(&problem, &problem.judge(best));
        (best, shift) = refine(&mut problem, best, task, watch);
    }
    let mut judged = judge(&problem, &best, task, watch, searches, &ends)?;
    // A genetic algorithm alone stays where it ended.
    let returns = if task.method == Method::Evolution { RETURNS } else { 0 };
    for _ in 0..returns {
        let Some(better) = judged.better(&best) else { break };
        best = polish(&problem, better);
        (best, shift) = refine(&mut problem, best, task, watch);
        judged = judge(&problem, &best, task, watch, searches, &ends)?;
    }
    let mut fit = finish(&problem, task, watch, &best, &judged, shift)?;
    fit.warnings.extend(fit.static_warning());
    if task.folds > 0 && !fit.is_cancelled && !is_far {
        fit.saw(folds(law, experiments, task.folds, task, watch)?);
    }
    Ok(fit)
}

/// The experiments as a law needs them; None if that is as they are. For a law that differs then, without samples of which
/// it is not known whether the contact speeds up or slows down; for fits with intervals only, since laws are ranked by the
/// samples that count for all of them. For a mass that is fitted, with all of the acceleration.
fn prepared(law: &ModelType, experiments: &[Experiment], task: &Settings) -> Option<Vec<Experiment>> {
    let differs = task.profiles && Ports::of(law)?.acceleration.is_some();
    let is_weighed = task.selection.fitted.iter().any(|name| name == "mass");
    let prepare = |one: &Experiment| {
        let one = if differs { one.of_known_branch() } else { one.clone() };
        if is_weighed { one.with_all_acceleration() } else { one }
    };
    (differs || is_weighed).then(|| experiments.iter().map(prepare).collect())
}

/// The ends of other searches, if the residuals of the best place are not noise and these explain more: two searches may
/// agree on a local minimum. For fits with intervals only; many laws are ranked although they do not fit.
fn searched_again(problem: &Problem, found: &Found, task: &Settings, watch: Watch) -> Option<Best> {
    if !task.profiles || task.method != Method::Evolution || watch.cancel.load(Ordering::Relaxed) {
        return None;
    }
    let seen =
        residuals(&problem.residuals(&found.places)?, &problem.lengths(), problem.parameters.len(), problem.loss);
    if seen.correlation <= SYSTEMATIC {
        return None;
    }
    let other = Settings { seed: !task.seed, ..task.clone() };
    let again = best(problem, &other, watch, None, false);
    (2.0 * (found.cost - again.found.cost) > seen.rise()).then_some(again)
}

/// How often a fit goes on from a better place that is found while it is judged (chosen): the searches see fewer samples
/// and intervals that are not divided, and may agree on another place.
const RETURNS: usize = 3;

/// The experiments with the samples left out that are at rest with the delay that was found; None if they are the same.
fn at_rest_anew(problem: &Problem, places: &[f64]) -> Option<Vec<Experiment>> {
    let delay = problem.point(places).delay?;
    let doubted = |one: &Experiment| if one.delay_range.is_some() { one.at_delay(delay) } else { one.clone() };
    let anew: Vec<Experiment> = problem.experiments.iter().map(doubted).collect();
    let are_others = anew.iter().zip(problem.experiments).any(|(anew, before)| anew.left_out != before.left_out);
    are_others.then_some(anew)
}

/// Refuses experiments and tasks with which nothing can be fitted.
fn check(experiments: &[Experiment], task: &Settings) -> Result<(), Fault> {
    if experiments.is_empty() {
        return Err(Fault::value("no experiment was given"));
    }
    if task.budget == 0 {
        return Err(Fault::value("budget = 0: must be at least 1 evaluation"));
    }
    if !(task.mass >= 0.0 && task.mass.is_finite()) {
        return Err(Fault::value(format_args!("mass = {}: must be >= 0 and finite", task.mass)));
    }
    if task.folds > 0 {
        check_folds(task.folds, experiments.len())?;
    }
    experiments.iter().try_for_each(Experiment::check)
}

fn too_few(samples: usize, experiments: &[Experiment], parameters: usize, law: &ModelType) -> Fault {
    let all: usize = experiments.iter().map(|one| one.time.len()).sum();
    let at_rest = match all - samples {
        0 => String::new(),
        left_out => format!(" ({left_out} of {all} are left out, at rest or at the ends)"),
    };
    let these = if parameters == 1 { "parameter" } else { "parameters" };
    let least = 2 * parameters + 1;
    Fault::value(format_args!(
        "{samples} samples{at_rest} for {parameters} {these} of {}; at least {least} are needed",
        law.name
    ))
}

/// Problem of a fit, with everything checked.
fn problem<'a>(law: &'static ModelType, experiments: &'a [Experiment], task: &Settings) -> Result<Problem<'a>, Fault> {
    let Some(ports) = Ports::of(law) else {
        return Err(Fault::value(format_args!("{}: only laws of one sliding direction can be fitted", law.name)));
    };
    check(experiments, task)?;
    let parameters = parameter::parameters(law, experiments, &task.selection)?;
    let samples: usize = experiments.iter().map(Experiment::samples).sum();
    if samples <= 2 * parameters.len() {
        return Err(too_few(samples, experiments, parameters.len(), law));
    }
    let named = |name: &str| task.selection.fixed.iter().find(|(fixed, _)| fixed == name).map(|(_, value)| *value);
    let of_law = task.selection.fixed.iter().filter(|(name, _)| !OF_RIG.contains(&name.as_str()));
    let held = of_law.filter_map(|(name, value)| Some((law.find(name)?, *value))).collect();
    let count = parameters.len();
    Ok(Problem {
        law,
        ports,
        exact: Exact::of(law),
        experiments,
        held,
        mass: named("mass").unwrap_or(task.mass),
        offset: named("offset").unwrap_or(0.0),
        delay: named("delay"),
        loss: if task.is_robust { Loss::robust(experiments) } else { Loss::SQUARES },
        parts: 1,
        pinned: vec![None; count],
        instead: None,
        low: vec![0.0; count],
        high: vec![1.0; count],
        parameters,
    })
}

/// A best place with what is left there, and how far it can be trusted.
struct Judged {
    searches: Searches,
    seen: Residuals,
    trust: Uncertainty,
}

impl Judged {
    /// A place that explains the force better, by more than the noise of a sample.
    fn better(&self, best: &Found) -> Option<&Found> {
        let ends = self.trust.elsewhere.iter().map(|place| &place.end);
        let least = ends.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
        (2.0 * (best.cost - least.cost) > self.seen.rise()).then_some(least)
    }
}

/// Judges a best place. `ends` are the places at which the two best searches ended.
fn judge(
    problem: &Problem,
    best: &Found,
    task: &Settings,
    watch: Watch,
    searches: Searches,
    ends: &[Vec<f64>],
) -> Result<Judged, Fault> {
    let Some(left) = problem.residuals(&best.places) else {
        return Err(Fault::value(format_args!("{}: the law is refused at the best place", problem.law.name)));
    };
    let seen = residuals(&left, &problem.lengths(), problem.parameters.len(), problem.loss);
    let profiles = task.profiles && !watch.cancel.load(Ordering::Relaxed);
    let trust = doubted(problem, best, &seen, profiles, searches.believed(task.method), ends);
    Ok(Judged { searches, seen, trust })
}

/// Everything about a best place. `shift` is that of the parameters if the intervals between samples are divided once more,
/// in standard deviations.
fn finish(
    problem: &Problem,
    task: &Settings,
    watch: Watch,
    best: &Found,
    judged: &Judged,
    shift: f64,
) -> Result<Fit, Fault> {
    let Judged { searches, seen, trust } = judged;
    let undivided = if problem.parts > 1 { problem.undivided(&best.places) } else { None };
    let quick = undivided.as_ref().unwrap_or(problem);
    let best_quick = quick.judge(best.clone());
    let repeated = repetitions(quick, &best_quick, seen, task.repetitions, task.seed, watch);
    let is_cancelled = watch.cancel.load(Ordering::Relaxed);
    let ended = Ended { problem: quick, best: &best_quick, seen, trust };
    let estimates = ended.estimates(task.profiles && !is_cancelled, &repeated);
    let point = problem.point(&best.places);
    let predicted = problem.predicted(&mut Instance::new(problem.law), &point, problem.parts);
    let predicted = predicted.map_err(|reason| Fault::value(format_args!("{}: {reason}", problem.law.name)))?;
    let of_matrix = |row: usize| trust.correlation.row(row).iter().copied().collect();
    Ok(Fit {
        law: problem.law,
        correlation: (0..problem.parameters.len()).map(of_matrix).collect(),
        condition: trust.condition,
        residuals: *seen,
        samples: problem.samples(),
        level: problem.measured().iter().fold(0.0, |most: f64, force| most.max(force.abs())),
        evaluations: best.evaluations,
        searches: *searches,
        is_cancelled,
        is_exact: problem.exact.is_some(),
        mass: point.mass,
        offset: point.offset,
        delay: point.delay,
        axis_load: axis::load(problem.experiments),
        parts: problem.parts,
        validation: Vec::new(),
        columns: point.columns,
        held: problem.held.clone(),
        fitted: problem.experiments.iter().map(Experiment::fitted).collect(),
        predicted: split(&predicted, &problem.experiments.iter().map(|one| one.time.len()).collect::<Vec<usize>>()),
        warnings: warnings(problem, seen, &estimates, *searches, shift),
        estimates,
    })
}

/// Uncertainty by the sensitivities, less what they do not see.
fn doubted(
    problem: &Problem,
    best: &Found,
    seen: &Residuals,
    profiles: bool,
    searches: Searches,
    ends: &[Vec<f64>],
) -> Uncertainty {
    let mut trust = uncertainty(problem, &best.places, seen);
    if let Some(reason) = searches.doubt() {
        trust.verdicts.iter_mut().for_each(|verdict| *verdict = Verdict::Undetermined(reason.to_owned()));
    } else if profiles {
        for (number, end) in (Ended { problem, best, seen, trust: &trust }).without_effect() {
            let reason = format!("at {}, an end of its range, the force is predicted almost as well", digits(end));
            trust.verdicts[number] = Verdict::Undetermined(reason);
        }
        trust.elsewhere = Ended { problem, best, seen, trust: &trust }.elsewhere();
        for (number, other) in (Ended { problem, best, seen, trust: &trust }).dependent() {
            let name = &problem.parameters[other].name;
            trust.verdicts[number] = Verdict::Undetermined(format!("it depends on {name}, which is not determined"));
        }
    }
    if let [first, second] = ends {
        trust.doubt_ends([problem.values(first), problem.values(second)]);
    }
    // Residuals that are correlated are warned of: there the law is wrong, and not a few samples.
    if seen.correlation <= SYSTEMATIC
        && let Some(left) = problem.residuals(&best.places)
    {
        trust.doubt_outliers(&problem.loss.influence(&left).0, Loss::noise(problem.experiments));
    }
    trust
}

fn split(mut values: &[f64], lengths: &[usize]) -> Vec<Vec<f64>> {
    let part = |length: &usize| {
        let (one, rest) = values.split_at(*length);
        values = rest;
        one.to_vec()
    };
    lengths.iter().map(part).collect()
}

/// Correlation time of the residuals from which the law does not explain them, in samples (chosen).
const SYSTEMATIC: f64 = 3.0;
