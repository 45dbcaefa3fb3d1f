//! The answer of an identification, for programs: command line, Python and page give it out as it is.

use std::collections::BTreeMap;

use serde::Serialize;
use stribeck::model::ModelType;
use ts_rs::TS;

use super::output::{EARLY, text_of};
use super::{Data, Estimate, Fit, Judgement, LackOfFit, Rank, Ranking, Searches, Verdict, digits};
use stribeck_measured::Units;

/// Laws fitted to records.
#[derive(Clone, Debug, Serialize, TS)]
#[ts(rename = "Ranking")]
pub struct Answer {
    /// The units of the records.
    pub units: Units,
    /// The laws, the best first.
    pub laws: Vec<FittedLaw>,
    /// Laws that cannot be fitted.
    pub refused: Vec<RefusedLaw>,
    /// For each record what is to be known of it, first how it is taken to begin.
    #[ts(type = "Record<string, string[]>")]
    pub findings: BTreeMap<String, Vec<String>>,
}

/// A law that cannot be fitted.
#[derive(Clone, Debug, Serialize, TS)]
pub struct RefusedLaw {
    /// The law.
    pub law: &'static str,
    /// Why.
    pub reason: String,
}

/// A law after a fit. What the data do not determine has no value.
#[derive(Clone, Debug, Serialize, TS)]
pub struct FittedLaw {
    /// The law.
    pub law: &'static str,
    /// Bayesian information criterion above that of the best law.
    pub delta_bic: f64,
    /// Whether it cannot be told apart from the best law.
    pub tied: bool,
    /// RMS residual, in the unit of a force or torque.
    pub rms: f64,
    /// The same without outliers.
    pub noise: f64,
    /// RMS residual in each validation record.
    #[ts(type = "Record<string, number>")]
    pub validation: BTreeMap<String, f64>,
    /// Number of samples.
    pub samples: usize,
    /// Correlation time of the residuals, in samples.
    pub correlation: f64,
    /// Whether several searches found the same values.
    pub repeatable: bool,
    /// Whether the sensitivities are exact.
    pub exact: bool,
    /// Ratio of the best to the worst known direction.
    pub condition: f64,
    /// Correlations among the parameters.
    pub correlations: Vec<Vec<f64>>,
    /// Evaluations of the law.
    pub evaluations: u64,
    /// Misfit of a map with repeats, compared with their scatter.
    pub lack_of_fit: Option<LackOfFit>,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Judgement of values that were given: a reference, or values that were all held.
    pub judgement: Option<Judgement>,
    /// The parameters that were held or that the data determine.
    #[ts(type = "Record<string, number>")]
    pub values: BTreeMap<String, f64>,
    /// Description of a fit that was cancelled.
    pub early: Option<&'static str>,
    /// The parameters.
    pub estimates: Vec<FittedParameter>,
}

/// A parameter after a fit.
#[derive(Clone, Debug, Serialize, TS)]
#[ts(rename = "Estimate")]
pub struct FittedParameter {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// The two parameters whose difference it is, if it is one.
    pub difference_of: Option<[String; 2]>,
    /// `determined`, or why there is no value.
    pub verdict: String,
    /// Its value.
    pub value: Option<f64>,
    /// Interval of 95 %, by the sensitivities and the profile likelihood.
    pub interval: Option<[f64; 2]>,
    /// Interval of 95 %, from repetitions with blocks of residuals.
    pub repeated: Option<[f64; 2]>,
    /// Value and intervals for a reader, or why there are none.
    pub text: String,
    /// Value and intervals in one notation, for a cell of a table; none without a value.
    pub readable: Option<Readable>,
}

/// A value and its intervals in one notation, for a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, TS)]
pub struct Readable {
    /// The value with the distances of both ends of its interval; without them if the search ended early.
    pub value: String,
    /// Interval from repetitions.
    pub repeated: Option<String>,
}

impl Readable {
    /// None without a value.
    pub fn of(one: &Estimate, searches: Searches) -> Option<Readable> {
        let notation = one.notation();
        let value = match searches {
            Searches::Ended => digits(one.value),
            _ => notation.with_interval(one.value, one.interval()),
        };
        let repeated = one.repeated.map(|ends| notation.ends(ends));
        (one.verdict == Verdict::Determined).then_some(Readable { value, repeated })
    }
}

impl Answer {
    /// The answer of a ranking, with what was found out about each record.
    pub fn of(ranking: &Ranking, data: &Data) -> Answer {
        let of_records = data.records.iter().map(|(name, record)| (name, &record.quality.findings));
        let of_maps = data.maps.iter().map(|(name, map)| (name, &map.findings));
        let laws: Vec<&ModelType> = ranking.ranks.iter().map(|place| ranking.fits[place.fit].law).collect();
        let findings = of_records.chain(of_maps).zip(&data.experiments).map(|((name, found), experiment)| {
            let found = found.iter().cloned();
            (name.clone(), std::iter::once(experiment.beginning(&laws)).chain(found).collect())
        });
        let refused = ranking.refused.iter().map(|(law, reason)| RefusedLaw { law, reason: reason.clone() });
        Answer {
            units: ranking.best().movement.units(),
            laws: ranking.ranks.iter().map(|place| law(&ranking.fits[place.fit], place)).collect(),
            refused: refused.collect(),
            findings: findings.collect(),
        }
    }
}

fn law(fit: &Fit, place: &Rank) -> FittedLaw {
    FittedLaw {
        law: fit.law.name,
        delta_bic: place.delta_bic,
        tied: place.is_tied,
        rms: fit.residuals.rms,
        noise: fit.residuals.noise,
        validation: fit.validation.iter().map(|one| (one.name.clone(), one.rms)).collect(),
        samples: fit.samples,
        correlation: fit.residuals.correlation,
        repeatable: fit.searches == Searches::Agree,
        exact: fit.is_exact,
        condition: fit.condition,
        correlations: fit.correlation.clone(),
        evaluations: fit.evaluations,
        lack_of_fit: fit.lack_of_fit,
        warnings: fit.warnings.clone(),
        judgement: fit.judgement.clone(),
        values: fit.accepted().into_iter().collect(),
        early: fit.is_cancelled.then_some(EARLY),
        estimates: fit.estimates.iter().map(|one| parameter(one, fit.searches)).collect(),
    }
}

fn parameter(one: &Estimate, searches: Searches) -> FittedParameter {
    let is_determined = one.verdict == Verdict::Determined;
    FittedParameter {
        name: one.name.clone(),
        unit: one.unit,
        difference_of: one.difference_of().map(|names| names.map(str::to_owned)),
        verdict: one.verdict.to_string(),
        value: is_determined.then_some(one.value),
        interval: (is_determined && searches != Searches::Ended).then(|| one.interval()),
        repeated: one.repeated.filter(|_| is_determined),
        text: text_of(one, searches),
        readable: Readable::of(one, searches),
    }
}
