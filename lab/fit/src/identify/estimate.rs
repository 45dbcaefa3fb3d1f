//! The parameters after a fit, with their intervals.

use stribeck::model::Meaning;
use stribeck::number::Real;

use super::interval::{Ended, quantiles};
use super::parameter::{Parameter, Scale, Target};
use super::uncertainty::{DETERMINED, Verdict, WIDTH};

/// A parameter after a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: &'static str,
    /// Quantity that it stands for.
    pub target: Target,
    /// The part that it plays in the law.
    pub meaning: Meaning,
    /// Best value. Not to be shown unless the verdict is [`Verdict::Determined`].
    pub value: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Whether the data determine it.
    pub verdict: Verdict,
    /// Interval of 95 % from the sensitivities.
    pub linear: [f64; 2],
    /// Interval of 95 % from the profile likelihood.
    pub profile: Option<[f64; 2]>,
    /// Interval of 95 % from repetitions with blocks of residuals.
    pub repeated: Option<[f64; 2]>,
}

impl Estimate {
    /// Interval of 95 %: by the profile likelihood and by straight lines, whichever end is farther.
    pub fn interval(&self) -> [f64; 2] {
        let [low, high] = self.linear;
        self.profile.map_or(self.linear, |profile| [low.min(profile[0]), high.max(profile[1])])
    }

    /// Names of the two parameters whose difference it is, if it is one.
    pub fn difference_of(&self) -> Option<[&str; 2]> {
        let is_excess = matches!(self.target, Target::Excess { .. });
        self.name.split_once(" - ").filter(|_| is_excess).map(|(of, over)| [of, over])
    }

    /// Width of the interval.
    pub fn width(&self) -> f64 {
        let [low, high] = self.interval();
        high - low
    }

    /// The same with an upper limit in place of an interval that contains 0, below which there is nothing.
    fn or_limit(self) -> Estimate {
        let [low, high] = self.interval();
        let verdict = match self.verdict {
            Verdict::Determined if low <= 0.0 => Verdict::AtMost(high),
            other => other,
        };
        Estimate { verdict, ..self }
    }
}

/// Values of the parameters in repetitions of a fit.
struct Repeated(Vec<Vec<f64>>);

impl Repeated {
    /// Interval of a quantity; None without repetitions.
    fn interval(&self, of: impl Fn(&[f64]) -> f64) -> Option<[f64; 2]> {
        (!self.0.is_empty()).then(|| quantiles(self.0.iter().map(|values| of(values)).collect()))
    }
}

fn around(value: f64, deviation: f64) -> [f64; 2] {
    [value - WIDTH * deviation, value + WIDTH * deviation]
}

impl Ended<'_> {
    /// The estimates; mu_s, the sum of two parameters, comes last.
    pub fn estimates(&self, profiles: bool, places: &[Vec<f64>]) -> Vec<Estimate> {
        let values = self.problem.values(&self.best.places);
        let repeated = Repeated(places.iter().map(|places| self.problem.values(places)).collect());
        let one = |number: usize| self.estimate(number, values[number], profiles, &repeated);
        let mut list: Vec<Estimate> = (0..values.len()).map(one).collect();
        let level = self.static_level(&values, &list, profiles, &repeated);
        list.extend(level);
        list
    }

    fn estimate(&self, number: usize, value: f64, profiles: bool, repeated: &Repeated) -> Estimate {
        let parameter = &self.problem.parameters[number];
        let deviation = self.trust.deviations[number];
        let verdict = self.trust.verdicts[number].clone();
        let profile = (profiles && verdict.is_told()).then(|| self.profile(number));
        let verdict = match profile {
            Some(ends) if is_open(parameter, value, ends) => Verdict::Undetermined(format!(
                "the other parameters can compensate for it, with {} from {:.3e} to {:.3e}",
                parameter.name, ends[0], ends[1]
            )),
            _ => verdict,
        };
        let estimate = Estimate {
            name: parameter.name.clone(),
            unit: parameter.unit,
            target: parameter.target,
            meaning: parameter.meaning,
            value,
            deviation,
            linear: around(value, deviation + self.problem.doubt_of_mass(parameter) * value / WIDTH),
            profile,
            repeated: repeated.interval(|values| values[number]),
            verdict,
        };
        if parameter.can_be_zero() { estimate.or_limit() } else { estimate }
    }

    /// mu_s = mu_k + d.
    fn static_level(
        &self,
        values: &[f64],
        known: &[Estimate],
        profiles: bool,
        repeated: &Repeated,
    ) -> Option<Estimate> {
        let parameters = &self.problem.parameters;
        let (excess, of, over) =
            parameters.iter().enumerate().find_map(|(number, parameter)| match parameter.target {
                Target::Excess { of, over } => Some((number, of, over)),
                _ => None,
            })?;
        let kinetic = parameters.iter().position(|parameter| parameter.target == Target::Column(over));
        let held = self.problem.kinetic(over);
        let sum = |values: &[f64]| values[excess] + kinetic.map_or(held, |kinetic| values[kinetic]);
        let parts: Vec<usize> = kinetic.into_iter().chain([excess]).collect();
        let pairs = parts.iter().flat_map(|a| parts.iter().map(move |b| (*a, *b)));
        let deviation = pairs.map(|at| self.trust.covariance[at]).sum::<f64>().max(0.0).sqrt();
        let value = sum(values);
        let of_kinetic = kinetic.map_or(&Verdict::Determined, |kinetic| &known[kinetic].verdict);
        let level = Estimate {
            name: self.problem.law.table.at(of).path.to_string(),
            unit: parameters[excess].unit,
            target: Target::Column(of),
            meaning: Meaning::StaticLevel,
            value,
            deviation,
            verdict: match (&known[excess].verdict, of_kinetic) {
                // It is known as well as the kinetic one, although their difference has a limit only.
                (Verdict::Determined | Verdict::AtMost(_), other) | (other, _) => other.clone(),
            },
            linear: around(value, deviation),
            profile: (profiles && !self.trust.elsewhere.is_empty()).then(|| self.covering(sum, [WIDTH * deviation; 2])),
            repeated: repeated.interval(sum),
        };
        let limit = level.interval()[1];
        // The limit of the kinetic level is not its own.
        let verdict = if let Verdict::AtMost(_) = level.verdict { Verdict::AtMost(limit) } else { level.verdict };
        Some(Estimate { verdict, ..level })
    }
}

/// Whether an interval is wider than that of a value that the data determine.
fn is_open(parameter: &Parameter, value: f64, [low, high]: [f64; 2]) -> bool {
    let far = DETERMINED * WIDTH;
    match parameter.scale {
        Scale::Logarithmic => low <= 0.0 || 0.5 * Real::ln(high / low) > far,
        Scale::Linear | Scale::Mixed(_) => 0.5 * (high - low) > far * parameter.large(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The profile may go farther than straight lines: a coefficient has no negative values.
    #[test]
    fn an_interval_around_zero_is_a_limit() {
        let one = |low: f64, verdict: Verdict| Estimate {
            name: "mu_k".into(),
            unit: "1",
            target: Target::Column(0),
            meaning: Meaning::KineticLevel,
            value: 0.175,
            deviation: 0.05,
            verdict,
            linear: around(0.175, 0.05),
            profile: Some([low, 0.274]),
            repeated: None,
        };
        assert_eq!(one(-0.02, Verdict::Determined).or_limit().verdict, Verdict::AtMost(0.274));
        assert_eq!(one(0.02, Verdict::Determined).or_limit().verdict, Verdict::Determined);
        assert_eq!(one(-0.02, Verdict::AtEnd(0.175)).or_limit().verdict, Verdict::AtEnd(0.175));
    }

    /// 0.4 of a large change times 1.96: half a width of 0.784 for a logarithm, of 0.392 in a range of 1.
    #[test]
    fn an_interval_is_open_from_the_limit_of_what_is_determined() {
        let parameter = |scale| Parameter {
            name: "x".into(),
            unit: "1",
            target: Target::Offset,
            meaning: Meaning::Undeclared,
            range: [0.0, 1.0],
            scale,
        };
        let logarithmic = parameter(Scale::Logarithmic);
        assert!(!is_open(&logarithmic, 2.0, [1.0, 4.7]) && is_open(&logarithmic, 2.0, [1.0, 4.9]));
        let linear = parameter(Scale::Linear);
        assert!(!is_open(&linear, 0.5, [0.1, 0.88]) && is_open(&linear, 0.5, [0.1, 0.89]));
    }
}
