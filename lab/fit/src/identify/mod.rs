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
#[cfg(test)]
mod component_tests;
pub mod damper;
#[cfg(test)]
mod direction_tests;
#[cfg(test)]
mod ended_tests;
mod estimate;
mod evaluated;
mod experiment;
mod export;
mod inquiry;
#[cfg(test)]
mod inquiry_tests;
mod interval;
#[cfg(test)]
mod joint_tests;
mod judgement;
#[cfg(test)]
mod judgement_tests;
mod least_squares;
mod levels;
mod loss;
pub mod map;
mod output;
mod parameter;
mod ports;
mod problem;
mod rank;
mod refine;
mod response;
mod search;
mod selection;
mod strut;
#[cfg(test)]
mod strut_tests;
#[cfg(test)]
mod tests;
mod tie;
pub mod tyre;
mod uncertainty;
mod validation;
mod velocity_error;
mod warnings;

use std::sync::OnceLock;

use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::ModelType;

pub use answer::{Answer, FittedLaw, FittedParameter, Readable, RefusedLaw};
pub use estimate::Estimate;
pub use evaluated::evaluate;
pub use experiment::{Experiment, Rest, names};
pub use export::{Exported, Format};

pub use inquiry::{Data, DelayChoice, Files, Inquiry, LossChoice, Source, Table};
pub use judgement::{Judgement, Outside};
pub use map::{FrictionMap, LackOfFit, reference_curve, steady_curve};
pub use output::{Difference, EARLY, Reference, difference, known, of_law, preset, respond};
pub use parameter::{Parameter, Scale, Target};
pub use ports::{Led, Ports};
pub use problem::Physical;
pub use rank::{APART, Rank, rank};
pub use search::{Method, Searches, Watch};
pub use selection::Selection;
pub use strut::{StrutFriction, strut_friction};
pub use uncertainty::{DETERMINED, Notation, Residuals, Verdict, digits};
pub use validation::{Validation, held_out};

use interval::Optimum;
use loss::Loss;
use parameter::refused;
use problem::{Found, Problem};
use refine::{Refined, refine};
use response::{Exact, Plain};
use search::{First, best, first_search, polish};
use selection::OF_RIG;
use stribeck_measured::Movement;
use stribeck_solve::system::Fault;
use stribeck_solve::work::share;
use uncertainty::{SYSTEMATIC, Uncertainty, uncertainty};
use validation::check_folds;
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
    /// Mass between load cell and contact, kg, or moment of inertia, kg m2, unless it is fitted.
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
    /// Largest force, N, or torque, N m.
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
    /// Values of law and rig.
    pub physical: Physical,
    /// The columns of the law among them that were held.
    pub held: Vec<(usize, f64)>,
    /// Whether the body slides or turns.
    pub movement: Movement,
    /// Normal force of an axis, N, whose coefficient of friction is a force if that is 1 N.
    pub axis_load: Option<f64>,
    /// Parts into which the intervals between samples were divided.
    pub parts: usize,
    /// Residuals in experiments that were not fitted.
    pub validation: Vec<Validation>,
    /// Misfit of a map with repeats, compared with their scatter.
    pub lack_of_fit: Option<LackOfFit>,
    /// Warnings for the user.
    pub warnings: Vec<String>,
    /// Judgement of values that were given for the law.
    pub judgement: Option<Judgement>,
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
    along(Family::Friction)
}

/// The laws and components that can be fitted.
pub fn fittable() -> impl Iterator<Item = &'static ModelType> {
    laws().chain(along(Family::Component))
}

fn along(family: Family) -> impl Iterator<Item = &'static ModelType> {
    catalogue::documented(family).map(|(model, _)| model).filter(|model| Ports::of(model).is_some())
}

/// The laws and components of these names, or all laws for the name `all`.
pub fn laws_named(names: &[String]) -> Result<Vec<&'static ModelType>, Fault> {
    if names.iter().any(|name| name == "all") {
        return Ok(laws().collect());
    }
    let known = || fittable().map(|law| law.name);
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

/// Hears of each law that is begun.
type Begin<'a> = &'a mut (dyn FnMut(&'static ModelType) + Send);

/// Fits laws to the same experiments and ranks them; the best of several once more with all intervals. Each law is
/// searched once, then those that may be the best again, as if they were alone. `begin` hears of each law. As many laws
/// are under way at once as the machine has cores; their number changes no result.
pub fn fit_all(
    laws: &[&'static ModelType],
    experiments: &[Experiment],
    task: &Settings,
    begin: Begin,
    watch: Watch,
) -> Result<Ranking, Fault> {
    if let [law] = laws {
        begin(law);
        let fits = vec![fit(law, experiments, &task.of(law, laws), watch)?];
        return Ok(Ranking { ranks: rank(&fits), fits, refused: Vec::new() });
    }
    Contest { laws, experiments, task, watch }.ranking(begin)
}

/// Several laws for the same experiments.
struct Contest<'a> {
    laws: &'a [&'static ModelType],
    experiments: &'a [Experiment],
    task: &'a Settings,
    watch: Watch<'a>,
}

impl Contest<'_> {
    fn ranking(&self, begin: Begin) -> Result<Ranking, Fault> {
        let first = self.first_searches(begin);
        let (mut fits, mut refused, mut reason) = (Vec::new(), Vec::new(), Fault::value("no law was given"));
        // After an early end, what was found by then is ranked.
        for (law, found) in self.laws.iter().zip(self.without_intervals(&first, begin)) {
            match found {
                Some(Ok(fit)) => fits.push(fit),
                Some(Err(fault)) => {
                    refused.push((law.name, fault.to_string()));
                    reason = fault;
                }
                None => refused.push((law.name, format!("{}: not reached before the end", law.name))),
            }
        }
        let ranks = rank(&fits);
        let best = ranks.first().ok_or(reason)?.fit;
        let anew = if fits[best].is_cancelled { None } else { self.with_intervals(&mut fits, best, &first, begin)? };
        Ok(Ranking { ranks: anew.unwrap_or(ranks), fits, refused })
    }

    /// The settings for a law without intervals.
    fn quick(&self, law: &ModelType) -> Settings {
        Settings { profiles: false, repetitions: 0, ..self.task.of(law, self.laws) }
    }

    /// Where the first search for each law that was reached ends, if the laws are compared by it and it can be begun.
    fn first_searches(&self, begin: Begin) -> Vec<Option<Option<Found>>> {
        if self.task.method != Method::Evolution {
            return vec![Some(None); self.laws.len()];
        }
        self.side_by_side(begin, true, |_, law| {
            let task = self.quick(law);
            let problem = problem(law, self.experiments, &task).ok();
            let fitted = problem.filter(|problem| !problem.parameters.is_empty());
            fitted.map(|problem| first_search(&problem, &task, self.watch))
        })
    }

    /// The fits of the laws that were reached.
    fn without_intervals(&self, first: &[Option<Option<Found>>], begin: Begin) -> Vec<Option<Result<Fit, Fault>>> {
        let least = first.iter().flatten().flatten().map(|found| found.cost).fold(f64::INFINITY, f64::min);
        let one = |number: usize, law: &'static ModelType| {
            let first = first[number].clone()?;
            let is_far = first.as_ref().is_some_and(|first| first.cost > FAR * FAR * least);
            Some(fit_from(law, self.experiments, &self.quick(law), self.watch, First { found: first, is_far }))
        };
        let stops = self.task.method != Method::Evolution;
        self.side_by_side(begin, stops, one).into_iter().map(Option::flatten).collect()
    }

    /// Puts the whole fit of the best law into its place, and ranks anew: it may have been searched again. None if the
    /// ranking stays, because the whole fit leaves other samples out.
    fn with_intervals(
        &self,
        fits: &mut [Fit],
        best: usize,
        first: &[Option<Option<Found>>],
        begin: Begin,
    ) -> Result<Option<Vec<Rank>>, Fault> {
        let law = fits[best].law;
        begin(law);
        let number = self.laws.iter().position(|other| other.name == law.name);
        let found = number.and_then(|number| first[number].clone().flatten());
        let task = self.task.of(law, self.laws);
        let whole = fit_from(law, self.experiments, &task, self.watch, First { found, is_far: false })?;
        let is_of_the_same = whole.samples == fits[best].samples;
        fits[best] = whole;
        let ranks = rank(fits);
        Ok((is_of_the_same && ranks[0].fit == best).then_some(ranks))
    }

    /// Work on laws, in their order; None for those that were not begun before an early end, if it stops there.
    fn side_by_side<T: Send + Sync>(
        &self,
        begin: Begin,
        stops: bool,
        work: impl Fn(usize, &'static ModelType) -> T + Sync,
    ) -> Vec<Option<T>> {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let found: Vec<OnceLock<T>> = self.laws.iter().map(|_| OnceLock::new()).collect();
        let one = |number: usize| {
            let _ = found[number].set(work(number, self.laws[number]));
        };
        let begins = |number: usize| {
            let is_begun = !(stops && number > 0 && self.watch.is_cancelled());
            if is_begun {
                begin(self.laws[number]);
            }
            is_begun
        };
        share(self.laws.len(), cores, begins, || one);
        found.into_iter().map(OnceLock::into_inner).collect()
    }
}

/// Fits a law to experiments.
pub fn fit(law: &'static ModelType, experiments: &[Experiment], task: &Settings, watch: Watch) -> Result<Fit, Fault> {
    fit_from(law, experiments, task, watch, First::default())
}

/// As [`fit`], after a first search.
fn fit_from(
    law: &'static ModelType,
    experiments: &[Experiment],
    task: &Settings,
    watch: Watch,
    first: First,
) -> Result<Fit, Fault> {
    let (prepared, anew) = (prepared(law, experiments, task), OnceLock::new());
    let folds = if first.is_far { 0 } else { task.folds };
    let problem = problem(law, prepared.as_deref().unwrap_or(experiments), task)?;
    if problem.parameters.is_empty() {
        return evaluated::evaluated(problem);
    }
    let (mut fitter, found) = Fitter::of(problem, task, watch, first)?;
    let mut best = fitter.refine(found);
    if let Some(experiments) = at_rest_anew(&fitter.problem, &best.found.point) {
        fitter.problem.experiments = anew.get_or_init(|| experiments);
        let found = fitter.problem.judge(best.found);
        best = fitter.follow(&found);
    }
    let (best, judged) = fitter.settle(best)?;
    let mut fit = fitter.finish(&best, &judged)?;
    fit.warnings.extend(fit.static_warnings());
    fit.warnings.extend(tie::without_offset(law, &task.selection));
    if folds > 0 && !fit.is_cancelled {
        fit.saw(validation::folds(law, experiments, folds, task, watch)?);
    }
    Ok(fit)
}

/// The experiments as a law needs them; None if that is as they are. For a law that differs then, without samples of which
/// it is not known whether the contact speeds up or slows down; for fits with intervals only, since laws are ranked by the
/// samples that count for all of them. For a mass that is fitted, with all of the acceleration.
fn prepared(law: &ModelType, experiments: &[Experiment], task: &Settings) -> Option<Vec<Experiment>> {
    let differs = task.profiles && Ports::of(law)?.acceleration.is_some();
    let is_weighed = task.selection.fits("mass");
    let prepare = |one: &Experiment| {
        let one = if differs { one.of_known_branch() } else { one.clone() };
        if is_weighed { one.with_all_acceleration() } else { one }
    };
    (differs || is_weighed).then(|| experiments.iter().map(prepare).collect())
}

/// How often a fit goes on from a better point that is found while it is judged (chosen): the searches see fewer samples
/// and intervals that are not divided, and may agree on another point.
const RETURNS: usize = 3;

/// The experiments with the samples left out that are at rest with the delay that was found; None if they are the same.
fn at_rest_anew(problem: &Problem, point: &[f64]) -> Option<Vec<Experiment>> {
    let delay = problem.physical(point).delay?;
    let doubted = |one: &Experiment| if one.delay_range.is_some() { one.at_delay(delay) } else { one.clone() };
    let anew: Vec<Experiment> = problem.experiments.iter().map(doubted).collect();
    let are_others = anew.iter().zip(problem.experiments).any(|(anew, before)| anew.left_out != before.left_out);
    are_others.then_some(anew)
}

/// Refuses experiments and tasks with which nothing can be fitted.
fn check(law: &ModelType, experiments: &[Experiment], task: &Settings) -> Result<(), Fault> {
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
    check_movements(experiments)?;
    experiments.iter().try_for_each(|one| one.check(law))
}

/// Refuses experiments of bodies that slide together with those of bodies that turn.
fn check_movements(experiments: &[Experiment]) -> Result<(), Fault> {
    let text = |one: &Experiment| format!("{} in {}", one.name, one.movement.unit("N"));
    let first = &experiments[0];
    match experiments.iter().find(|other| other.movement != first.movement) {
        Some(other) => Err(Fault::value(format_args!(
            "{} and {}: one body slides, the other turns: fit them one at a time",
            text(first),
            text(other)
        ))),
        None => Ok(()),
    }
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
    let ports = Ports::of(law).ok_or_else(|| refused(law, "only laws of one sliding direction can be fitted"))?;
    check(law, experiments, task)?;
    let parameters = parameter::parameters(law, experiments, &task.selection)?;
    let selection = &task.selection;
    let of_law = selection.fixed.iter().filter(|(name, _)| !OF_RIG.contains(&name.as_str()));
    let is_map = experiments.iter().any(|one| one.map.is_some());
    let mut problem = Problem {
        law,
        ports,
        exact: if is_map { None } else { Exact::of(law) },
        plain: if is_map { None } else { Plain::of(law) },
        experiments,
        held: of_law.filter_map(|(name, value)| Some((law.find(name)?, *value))).collect(),
        mass: selection.fixed("mass").unwrap_or(task.mass),
        offset: selection.fixed("offset").unwrap_or(0.0),
        delay: selection.fixed("delay"),
        gravity: parameter::GRAVITY_COEFFICIENTS.map(|(name, _)| selection.fixed(name).unwrap_or(0.0)),
        loss: if task.is_robust { Loss::robust(experiments) } else { Loss::SQUARES },
        parts: 1,
        is_rough: false,
        pinned: vec![None; parameters.len()],
        substitute: None,
        parameters,
        excess: Vec::new(),
        tied: tie::columns(law, selection),
        untold: Vec::new(),
    };
    problem.hold_tied();
    if is_map {
        map::hold_untold(&mut problem)?;
    }
    let [samples, parameters] = [problem.samples(), problem.parameters.len()];
    if samples <= 2 * parameters { Err(too_few(samples, experiments, parameters, law)) } else { Ok(problem) }
}

/// A best point with what is left there, and how far it can be trusted.
struct Judged {
    left: Vec<f64>,
    residuals: Residuals,
    trust: Uncertainty,
}

impl Judged {
    /// A point that explains the force better, by more than the noise of a sample.
    fn better(&self, best: &Found) -> Option<&Found> {
        let ends = self.trust.alternatives.iter().map(|other| &other.end);
        let least = ends.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
        (2.0 * (best.cost - least.cost) > self.residuals.rise()).then_some(least)
    }
}

/// A fit under way, after the searches over the whole range.
struct Fitter<'a> {
    problem: Problem<'a>,
    task: &'a Settings,
    watch: Watch<'a>,
    searches: Searches,
    /// Points at which the two best searches ended.
    ends: Vec<Vec<f64>>,
}

impl<'a> Fitter<'a> {
    /// Searches the whole range; the best point too.
    fn of(problem: Problem<'a>, task: &'a Settings, watch: Watch<'a>, first: First) -> Result<(Self, Found), Fault> {
        let best = best(&problem, task, watch, first);
        if !best.found.cost.is_finite() {
            return Err(refused(problem.law, "the law is refused everywhere in the ranges"));
        }
        // A genetic algorithm hardly ever ends where another one does.
        let ends = if task.method == Method::Genetic { Vec::new() } else { best.ends };
        Ok((Fitter { problem, task, watch, searches: best.searches, ends }, best.found))
    }

    /// Divides the intervals between samples as far as that shifts a point.
    fn refine(&mut self, found: Found) -> Refined {
        refine(&mut self.problem, found, self.task, self.watch)
    }

    /// The same for where the slopes lead from a point.
    fn follow(&mut self, from: &Found) -> Refined {
        let found = polish(&self.problem, from);
        self.refine(found)
    }

    /// Judges the best point, and goes on from better ones that are found so.
    fn settle(&mut self, mut best: Refined) -> Result<(Refined, Judged), Fault> {
        let mut judged = self.judge(&best.found)?;
        // A genetic algorithm alone stays where it ended.
        let returns = if self.task.method == Method::Evolution { RETURNS } else { 0 };
        for _ in 0..returns {
            let Some(better) = judged.better(&best.found) else { break };
            best = self.follow(better);
            judged = self.judge(&best.found)?;
        }
        Ok((best, judged))
    }

    /// Judges a best point.
    fn judge(&self, best: &Found) -> Result<Judged, Fault> {
        let left = self.problem.residuals(&best.point);
        let left = left.ok_or_else(|| refused(self.problem.law, "the law is refused at the best place"))?;
        let residuals = Residuals::of_fit(&self.problem, &left);
        let profiles = self.task.profiles && !self.watch.is_cancelled();
        let mut trust = self.trust(best, &residuals, profiles);
        // Residuals that are correlated are warned of: there the law is wrong, and not a few samples.
        if residuals.correlation <= SYSTEMATIC {
            trust.doubt_outliers(&self.problem.loss.influence(&left).0, Loss::noise(self.problem.experiments));
        }
        Ok(Judged { left, residuals, trust })
    }

    /// Uncertainty by the sensitivities, less what they do not see.
    fn trust(&self, best: &Found, residuals: &Residuals, profiles: bool) -> Uncertainty {
        let mut trust = uncertainty(&self.problem, &best.point, residuals);
        if let Some(reason) = self.searches.believed(self.task.method).doubt() {
            trust.verdicts.fill(Verdict::Undetermined(reason.to_owned()));
        } else if profiles {
            let undivided = self.undivided(best);
            let problem = undivided.as_ref().unwrap_or(&self.problem);
            doubt_straight_lines(problem, &problem.judge(best.clone()), residuals, &mut trust);
            trust.alternatives.iter_mut().for_each(|other| other.end = self.problem.judge(other.end.clone()));
        }
        if let [first, second] = &self.ends[..] {
            trust.doubt_ends([first, second].map(|point| self.problem.values(point)));
        }
        trust
    }

    /// The problem with intervals that are not divided, for what is compared with a best point; None if they are not anyway.
    fn undivided(&self, best: &Found) -> Option<Problem<'_>> {
        if self.problem.parts > 1 { self.problem.undivided(&best.point) } else { None }
    }

    /// Everything about a best point.
    fn finish(&self, best: &Refined, judged: &Judged) -> Result<Fit, Fault> {
        let Judged { left, residuals, trust } = judged;
        let (mut estimates, is_cancelled) = self.estimates(&best.found, judged);
        let warnings = warnings(&self.problem, (left, residuals), &estimates, self.searches, best.shift);
        estimates.extend(map::estimates(&self.problem));
        let correlation = trust.correlation.row_iter().map(|row| row.iter().copied().collect()).collect();
        let as_is = as_is(&self.problem, &best.found, *residuals)?;
        let (searches, condition) = (self.searches, trust.condition);
        Ok(Fit { estimates, correlation, condition, searches, is_cancelled, warnings, ..as_is })
    }

    /// The parameters at a best point, and whether the fit was ended before all intervals were found.
    fn estimates(&self, best: &Found, Judged { residuals, trust, .. }: &Judged) -> (Vec<Estimate>, bool) {
        let undivided = self.undivided(best);
        let problem = undivided.as_ref().unwrap_or(&self.problem);
        let optimum = Optimum { problem, best: &problem.judge(best.clone()), residuals, trust };
        let repeated = optimum.repetitions(self.task.repetitions, self.task.seed, self.watch);
        let is_cancelled = self.watch.is_cancelled();
        (optimum.estimates(self.task.profiles && !is_cancelled, &repeated), is_cancelled)
    }
}

/// A fit at a point, without estimates or uncertainty.
fn as_is(problem: &Problem, at: &Found, residuals: Residuals) -> Result<Fit, Fault> {
    let physical = problem.physical(&at.point);
    let lack_of_fit = problem.residuals(&at.point).and_then(|left| map::lack_of_fit(problem, &left));
    let predicted = problem.predicted(&mut Instance::new(problem.law), &physical, problem.parts);
    let mut predicted = predicted.map_err(|reason| refused(problem.law, reason))?.into_iter();
    let part = |one: &Experiment| predicted.by_ref().take(one.time.len()).collect();
    Ok(Fit {
        law: problem.law,
        estimates: Vec::new(),
        correlation: Vec::new(),
        condition: 1.0,
        residuals,
        samples: problem.samples(),
        level: problem.measured().iter().fold(0.0, |most: f64, force| most.max(force.abs())),
        evaluations: at.evaluations,
        searches: Searches::Agree,
        is_cancelled: false,
        is_exact: problem.exact.is_some(),
        predicted: problem.experiments.iter().map(part).collect(),
        fitted: problem.experiments.iter().map(Experiment::fitted).collect(),
        physical,
        held: problem.held.clone(),
        movement: problem.movement(),
        axis_load: axis::load(problem.experiments),
        parts: problem.parts,
        validation: Vec::new(),
        lack_of_fit,
        warnings: Vec::new(),
        judgement: None,
    })
}

/// Calls not determined what depends on more than straight lines around the best point show.
fn doubt_straight_lines(problem: &Problem, best: &Found, residuals: &Residuals, trust: &mut Uncertainty) {
    for (number, end) in (Optimum { problem, best, residuals, trust }).without_effect() {
        let reason = format!("at {}, an end of its range, the force is predicted almost as well", digits(end));
        trust.verdicts[number] = Verdict::Undetermined(reason);
    }
    trust.alternatives = Optimum { problem, best, residuals, trust }.alternatives();
    for (number, other) in (Optimum { problem, best, residuals, trust }).dependent() {
        let name = &problem.parameters[other].name;
        trust.verdicts[number] = Verdict::Undetermined(format!("it depends on {name}, which is not determined"));
    }
}
