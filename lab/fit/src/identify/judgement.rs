//! Values that are given, judged by the data: beside the fit of the same law, or alone.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;
use ssp::parameter_set::ParameterSet;
use stribeck::model::ModelType;
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, read};
use ts_rs::TS;

use super::evaluated::held;
use super::output::{known, of_law, preset};
use super::rank::rank;
use super::uncertainty::WIDTH;
use super::{
    Estimate, Experiment, Fit, Ranking, Reference, Searches, Selection, Settings, Verdict, Watch, digits, evaluate, fit,
};

/// Values that were given, judged by the data.
#[derive(Clone, Debug, PartialEq, Serialize, TS)]
pub struct Judgement {
    /// Where the values are from: a preset, a file, or `fix`.
    pub source: String,
    /// The values of the law.
    #[ts(type = "Record<string, number>")]
    pub values: BTreeMap<String, f64>,
    /// RMS residual of the values, in the unit of a force or torque.
    pub rms: f64,
    /// That of the best fit of the same law, if one was made.
    pub fit_rms: Option<f64>,
    /// Values outside the interval of the fit.
    pub outside: Vec<Outside>,
    /// The verdict, in words.
    pub verdict: String,
    /// Warnings of the values, as of a fit.
    pub warnings: Vec<String>,
    /// Note on values that are those of another law.
    pub note: Option<String>,
}

/// A value outside the interval of a fit.
#[derive(Clone, Debug, PartialEq, Serialize, TS)]
pub struct Outside {
    /// The parameter, or the difference of two.
    pub name: String,
    /// The value that was given.
    pub value: f64,
    /// Interval of 95 % of the fit.
    pub interval: [f64; 2],
}

impl Judgement {
    /// Of values in a fit in which all are held.
    fn alone(judged: &Fit, source: &str) -> Judgement {
        Judgement {
            source: source.to_owned(),
            values: judged.values().into_iter().collect(),
            rms: judged.residuals.rms,
            fit_rms: None,
            outside: Vec::new(),
            verdict: verdict(None, false, &judged.warnings).to_owned(),
            warnings: judged.warnings.clone(),
            note: None,
        }
    }

    /// Of values beside a fit.
    fn beside(fit: &Fit, judged: &Fit, given: &Reference, source: &str) -> Judgement {
        let has_interval = |verdict: &Verdict| *verdict == Verdict::Determined && fit.searches == Searches::Agree;
        let estimates = fit.estimates.iter().filter(|one| has_interval(&one.verdict));
        let compared: Vec<(&Estimate, f64)> = estimates.filter_map(|one| Some((one, known(given, one)?))).collect();
        let miss = |(one, value): &(&Estimate, f64)| {
            let (value, interval) = (*value, one.interval());
            let is_inside = (interval[0]..=interval[1]).contains(&value);
            let outside = || Outside { name: one.name.clone(), value, interval };
            (!is_inside).then(|| (outside(), distance(one.value, interval, value)))
        };
        let (outside, distances): (Vec<Outside>, Vec<f64>) = compared.iter().filter_map(miss).unzip();
        let contradicts = contradicts(&distances, compared.len());
        let verdict = verdict(Some(&outside), contradicts, &judged.warnings).to_owned();
        let (values, fit_rms) = (given.clone(), Some(fit.residuals.rms));
        Judgement { values, fit_rms, outside, verdict, ..Judgement::alone(judged, source) }
    }

    /// The judgement in lines for a reader, with forces in a unit.
    pub fn lines(&self, unit: &str) -> Vec<String> {
        let beside = self.fit_rms.map_or(String::new(), |rms| format!(", that of the fit {} {unit}", digits(rms)));
        let first = format!("RMS residual {} {unit}{beside}: {}", digits(self.rms), self.verdict);
        let outside = self.outside.iter().map(|one| {
            let [value, low, high] = [one.value, one.interval[0], one.interval[1]].map(digits);
            format!("{} = {value} is outside the interval of the fit, {low} to {high}", one.name)
        });
        std::iter::once(first).chain(outside).chain(self.warnings.iter().cloned()).collect()
    }
}

/// Distance of a value from an estimate, in parts of the interval on that side.
fn distance(estimate: f64, [low, high]: [f64; 2], value: f64) -> f64 {
    (value - estimate).abs() / if value < estimate { estimate - low } else { high - estimate }
}

/// Chance that a normal distribution is so many standard deviations or more from its mean, within a hundredth beyond 1.9;
/// the upper bound of M. R. Sampford (1953), Some inequalities on Mill's ratio and related functions, Annals of
/// Mathematical Statistics 24, 130-132.
fn chance(deviations: f64) -> f64 {
    let density = (-0.5 * deviations * deviations).exp() / (0.5 * std::f64::consts::PI).sqrt();
    density * 4.0 / (3.0 * deviations + (deviations * deviations + 8.0).sqrt())
}

/// Whether one of the values is so far outside that in 95 of 100 cases none of so many intervals misses by as much
/// (Bonferroni): of seven intervals of 95 % one misses in three of ten cases.
fn contradicts(distances: &[f64], intervals: usize) -> bool {
    // On the end of an interval the bound is 0.3 % too large.
    distances.iter().any(|distance| chance(distance * WIDTH) * intervals as f64 <= 0.05 * 1.003)
}

/// Verdict on values with these warnings, and with those outside the intervals of a fit, if there is one.
fn verdict(outside: Option<&[Outside]>, contradicts: bool, warnings: &[String]) -> &'static str {
    match (outside, warnings.is_empty()) {
        _ if contradicts => "the values contradict the fit",
        (Some([_, ..]), true) => "the values do not contradict the fit: of so many intervals one may miss by as much",
        (_, true) => "the values explain the data",
        (Some(_), false) => "the values do not contradict the fit, but see the warnings",
        (None, false) => "the values are not confirmed: see the warnings",
    }
}

/// Values of laws in a preset or a file.
pub(super) struct Given<'a>(pub &'a str);

impl Given<'_> {
    /// Values that the preset or the file has for a law, of parameters and others, by their names.
    fn all(&self, law: &'static ModelType) -> Result<Reference, Fault> {
        let path = Path::new(self.0);
        if path.extension().is_none() {
            return preset(law, self.0);
        }
        if is_toml(path) {
            let number = |(name, value): (String, toml::Value)| {
                value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64)).map(|value| (name, value))
            };
            return Ok(read::<Configuration>(path)?.set.into_iter().filter_map(number).collect());
        }
        let set = ParameterSet::load(law, path).map_err(|error| Fault::File(error.to_string()))?;
        Ok(set.values().map(|(variable, value)| (variable.path.to_string(), value)).collect())
    }

    /// The values of each law; None for a law that has none of them. An error if no law has any.
    pub fn values(&self, laws: &[&'static ModelType]) -> Result<Vec<Option<Reference>>, Fault> {
        let of = |law: &&'static ModelType| self.all(law).map(|all| of_law(law, &all));
        let mut all: Vec<Result<Option<Reference>, Fault>> = laws.iter().map(of).collect();
        if all.iter().all(Result::is_err) {
            return Err(all.swap_remove(0).err().unwrap_or_else(|| Fault::value("no law was given")));
        }
        let all: Vec<Option<Reference>> = all.into_iter().map(|found| found.ok().flatten()).collect();
        if all.iter().all(Option::is_none) {
            return Err(Fault::File(format!("{}: has no parameter of these laws", self.0)));
        }
        Ok(all)
    }

    /// Says that the file has a set of other laws than this one, if it does.
    fn other_law(&self, law: &ModelType) -> Option<String> {
        let known: Configuration =
            Some(Path::new(self.0)).filter(|path| is_toml(path)).and_then(|path| read(path).ok())?;
        let is_other = !known.law.is_empty() && known.law.iter().all(|name| name != law.name);
        is_other.then(|| {
            let other = known.law.join(", ");
            format!("{}: is a set of {other}, not of {}", self.0, law.name)
        })
    }

    /// Judges the values beside the fits of a ranking: those of each law that the set is of, and of the best law.
    pub fn judge(
        &self,
        ranking: &mut Ranking,
        laws: &[&'static ModelType],
        values: &[Option<Reference>],
        (experiments, task): (&[Experiment], &Settings),
    ) -> Result<(), Fault> {
        let best = ranking.best().law.name;
        for fit in &mut ranking.fits {
            let place = laws.iter().position(|law| law.name == fit.law.name);
            let Some(values) = place.and_then(|place| values[place].as_ref()) else { continue };
            let other = self.other_law(fit.law);
            let note = other.map(|other| format!("{other}; compared where names are the same"));
            if note.is_some() && fit.law.name != best {
                continue;
            }
            match evaluate(fit, values, experiments, task) {
                Ok(judged) => {
                    fit.judgement = Some(Judgement { note, ..Judgement::beside(fit, &judged, values, self.0) })
                }
                Err(fault) if fit.law.name == best => return Err(fault),
                Err(fault) => fit.warnings.push(format!("{}: not judged: {fault}", self.0)),
            }
        }
        Ok(())
    }

    /// Laws at these values, nothing fitted, ranked by their residuals.
    pub fn evaluated(
        &self,
        laws: &[&'static ModelType],
        experiments: &[Experiment],
        task: &Settings,
        watch: Watch,
    ) -> Result<Ranking, Fault> {
        let (mut fits, mut refused, mut reason) = (Vec::new(), Vec::new(), Fault::value("no law was given"));
        let values = self.values(laws)?;
        for (law, values) in laws.iter().zip(values) {
            let none = || Fault::File(format!("{}: has no parameter of {}", self.0, law.name));
            let found = values
                .ok_or_else(none)
                .and_then(|values| self.at(law, &values, experiments, &task.of(law, laws), watch));
            match found {
                Ok(fit) => fits.push(fit),
                Err(fault) => {
                    refused.push((law.name, fault.to_string()));
                    reason = fault;
                }
            }
        }
        if fits.is_empty() { Err(reason) } else { Ok(Ranking { ranks: rank(&fits), fits, refused }) }
    }

    /// A law at its values.
    fn at(
        &self,
        law: &'static ModelType,
        values: &Reference,
        experiments: &[Experiment],
        task: &Settings,
        watch: Watch,
    ) -> Result<Fit, Fault> {
        if let Some(other) = self.other_law(law) {
            return Err(Fault::File(other));
        }
        let fixed = self.fixed(law, values, &task.selection)?;
        let task = Settings { selection: Selection { fixed, ..Selection::default() }, folds: 0, ..task.clone() };
        // The delay is that of the records.
        let as_is = |one: &Experiment| Experiment { delay_range: None, ..one.clone() };
        let experiments: Vec<Experiment> = experiments.iter().map(as_is).collect();
        let judged = fit(law, &experiments, &task, watch)?;
        Ok(Fit { judgement: Some(Judgement::alone(&judged, self.0)), ..judged })
    }

    /// Every parameter of a law with its value, and what else is held; of an axis also what would be fitted.
    pub fn fixed(
        &self,
        law: &'static ModelType,
        values: &Reference,
        selection: &Selection,
    ) -> Result<Vec<(String, f64)>, Fault> {
        for (name, value) in &selection.fixed {
            if let Some(other) = values.get(name).filter(|other| *other != value) {
                return Err(Fault::value(format_args!(
                    "fix {name} = {value} contradicts {}: {name} = {other}",
                    self.0
                )));
            }
        }
        let all = self.all(law)?;
        let of_axis = |name: &String| {
            let unknown = || Fault::value(format_args!("evaluate: {name} is not known: --fix {name}=VALUE gives it"));
            Ok((name.clone(), *all.get(&format!("axis.{name}")).ok_or_else(unknown)?))
        };
        let of_axis = selection.fitted.iter().map(of_axis).collect::<Result<Vec<_>, Fault>>()?;
        let of_law = held(law, values, selection);
        let is_other = |(name, _): &&(String, f64)| of_law.iter().all(|(known, _)| known != name);
        let others: Vec<_> = selection.fixed.iter().filter(is_other).cloned().collect();
        Ok([of_law, others, of_axis].concat())
    }
}

/// Judges fits in which everything was held.
pub(super) fn judge_held(ranking: &mut Ranking) {
    for fit in ranking.fits.iter_mut().filter(|fit| fit.estimates.is_empty() && fit.judgement.is_none()) {
        fit.judgement = Some(Judgement::alone(fit, "fix"));
    }
}

fn is_toml(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Beside tables of the normal distribution: two-sided 5 % of one interval, and 5 % / 7 of each of seven.
    #[test]
    fn one_of_many_intervals_may_miss() {
        for (deviations, expected) in [(1.959_964, 0.05), (2.575_829, 0.01), (3.290_527, 0.001)] {
            assert!((chance(deviations) / expected - 1.0).abs() < 0.01, "{deviations}");
        }
        assert!(contradicts(&[1.001], 1) && !contradicts(&[], 7));
        // 2.690 standard deviations.
        assert!(!contradicts(&[1.01, 1.36], 7) && contradicts(&[1.01, 1.385], 7));
        assert_eq!([0.5, 1.4].map(|value| distance(1.0, [0.9, 1.2], value)).map(|one| one.round()), [5.0, 2.0]);
        assert!(contradicts(&[f64::INFINITY], 3), "an interval without width");
    }
}
