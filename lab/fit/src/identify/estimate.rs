//! The parameters after a fit, with their intervals.

use std::f64::consts::PI;

use stribeck::model::Meaning;
use stribeck::number::Real;

use super::interval::{Optimum, quantiles};
use super::parameter::{GRAVITY_COEFFICIENTS, Parameter, Scale, Target};
use super::problem::{Problem, dot};
use super::uncertainty::{DETERMINED, Notation, Uncertainty, Verdict, WIDTH, digits};
use stribeck_measured::Movement;

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

/// Ratios to a value at which another is as readable in its notation (chosen).
const LIKE: std::ops::Range<f64> = 0.01..100.0;

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

    /// How its numbers are written.
    pub fn notation(&self) -> Notation {
        let [low, high] = self.interval();
        Notation::of(self.value, high - low)
    }

    /// Text of a reference value: in the notation of the estimate where both are of like size, otherwise with four digits.
    pub fn beside(&self, known: f64) -> String {
        let is_like = self.verdict == Verdict::Determined && LIKE.contains(&(known / self.value).abs());
        if is_like { self.notation().text(known) } else { digits(known) }
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

/// Intervals besides those by straight lines.
pub(super) struct Intervals {
    /// Whether the profile likelihood is followed.
    pub has_profiles: bool,
    /// Values of the parameters in repetitions of the fit.
    repeated: Vec<Vec<f64>>,
}

impl Intervals {
    /// Interval of a quantity by the repetitions; None without any.
    pub fn repeated(&self, of: impl Fn(&[f64]) -> f64) -> Option<[f64; 2]> {
        (!self.repeated.is_empty()).then(|| quantiles(self.repeated.iter().map(|values| of(values)).collect()))
    }
}

pub(super) fn around(value: f64, deviation: f64) -> [f64; 2] {
    [value - WIDTH * deviation, value + WIDTH * deviation]
}

/// mu_s = mu_k + d as a sum of parameters.
struct StaticLevel {
    column: usize,
    excess: usize,
    kinetic: Option<usize>,
    /// mu_k where it is not parameter.
    held: f64,
}

impl StaticLevel {
    /// That of each direction.
    fn all(problem: &Problem) -> Vec<StaticLevel> {
        let parameters = &problem.parameters;
        let level = |(excess, one): (usize, &Parameter)| {
            let Target::Excess { of: column, over } = one.target else { return None };
            let over = problem.source(over);
            let kinetic = parameters.iter().position(|one| one.target == Target::Column(over));
            Some(StaticLevel { column, excess, kinetic, held: problem.kinetic(over) })
        };
        parameters.iter().enumerate().filter_map(level).collect()
    }

    fn value(&self, values: &[f64]) -> f64 {
        values[self.excess] + self.kinetic.map_or(self.held, |kinetic| values[kinetic])
    }

    fn deviation(&self, trust: &Uncertainty) -> f64 {
        let parts = || self.kinetic.into_iter().chain([self.excess]);
        let pairs = parts().flat_map(|a| parts().map(move |b| (a, b)));
        pairs.map(|at| trust.covariance[at]).sum::<f64>().max(0.0).sqrt()
    }

    /// It is known as well as the kinetic one, although their difference has a limit only.
    fn verdict(&self, known: &[Estimate]) -> Verdict {
        match (&known[self.excess].verdict, self.kinetic.map(|kinetic| &known[kinetic].verdict)) {
            (Verdict::Determined | Verdict::AtMost(_), other) => other.cloned().unwrap_or(Verdict::Determined),
            (other, _) => other.clone(),
        }
    }
}

impl Optimum<'_> {
    /// The estimates; mu_s, the sum of two parameters, comes after those, then what is tied to another one.
    pub fn estimates(&self, has_profiles: bool, repeated: &[Vec<f64>]) -> Vec<Estimate> {
        let repeated = repeated.iter().map(|point| self.problem.values(point)).collect();
        let intervals = Intervals { has_profiles, repeated };
        let values = self.problem.values(&self.best.point);
        let mut list: Vec<Estimate> =
            values.iter().enumerate().map(|(number, value)| self.estimate(number, *value, &intervals)).collect();
        let levels = StaticLevel::all(self.problem);
        list.extend(
            levels.iter().map(|level| self.static_level(level, &values, &list, &intervals)).collect::<Vec<_>>(),
        );
        list.extend(self.tied(&list));
        list.extend(self.gravity(&values, &list, &intervals));
        list
    }

    fn estimate(&self, number: usize, value: f64, intervals: &Intervals) -> Estimate {
        let parameter = &self.problem.parameters[number];
        let Parameter { name, target, meaning, .. } = parameter.clone();
        let unit = self.problem.movement().unit(parameter.unit);
        let deviation = self.trust.standard_deviations[number];
        let verdict = self.trust.verdicts[number].clone();
        let profile = (intervals.has_profiles && verdict.is_informative()).then(|| self.profile(number));
        let verdict = match profile.filter(|ends| is_open(parameter, value, *ends)) {
            Some([low, high]) => Verdict::Undetermined(format!(
                "the other parameters can compensate for it, with {name} from {low:.3e} to {high:.3e}"
            )),
            None => verdict,
        };
        let linear = around(value, deviation + self.problem.doubt_of_mass(parameter) * value / WIDTH);
        let repeated = intervals.repeated(|values| values[number]);
        let estimate = Estimate { name, unit, target, meaning, value, deviation, verdict, linear, profile, repeated };
        if parameter.can_be_zero() { estimate.or_limit() } else { estimate }
    }

    /// Estimates of the parameters that are tied to others: the same values under their own names.
    fn tied(&self, known: &[Estimate]) -> Vec<Estimate> {
        let table = &self.problem.law.table;
        let repeated = |(column, source): &(usize, usize)| {
            let source = known.iter().find(|one| one.target == Target::Column(*source))?.clone();
            let (name, meaning) = (table.at(*column).path.to_string(), table.at(*column).meaning);
            Some(Estimate { name, meaning, target: Target::Column(*column), ..source })
        };
        self.problem.tied.iter().filter_map(repeated).collect()
    }

    fn static_level(&self, level: &StaticLevel, values: &[f64], known: &[Estimate], intervals: &Intervals) -> Estimate {
        let (value, deviation) = (level.value(values), level.deviation(self.trust));
        let is_elsewhere = intervals.has_profiles && !self.trust.alternatives.is_empty();
        let covering = || self.covering(|values| level.value(values), [WIDTH * deviation; 2]);
        let mut estimate = Estimate {
            name: self.problem.law.table.at(level.column).path.to_string(),
            unit: known[level.excess].unit,
            target: Target::Column(level.column),
            meaning: Meaning::StaticLevel,
            value,
            deviation,
            verdict: level.verdict(known),
            linear: around(value, deviation),
            profile: is_elsewhere.then(covering),
            repeated: intervals.repeated(|values| level.value(values)),
        };
        // The limit of the kinetic level is not its own.
        if let Verdict::AtMost(_) = estimate.verdict {
            estimate.verdict = Verdict::AtMost(estimate.interval()[1]);
        }
        estimate
    }
}

/// Torque and angle of two coefficients.
fn polar([a, b]: [f64; 2]) -> [f64; 2] {
    let torque = (a * a + b * b).sqrt();
    // The tangent of half the angle, in the form that does not cancel.
    let angle = match () {
        () if a >= 0.0 => 2.0 * Real::atan(b / (torque + a).max(f64::MIN_POSITIVE)),
        () if b == 0.0 => PI,
        () => 2.0 * Real::atan((torque - a) / b),
    };
    [torque, angle]
}

impl Optimum<'_> {
    /// m g l and q_0, if both coefficients are fitted.
    fn gravity(&self, values: &[f64], known: &[Estimate], intervals: &Intervals) -> Vec<Estimate> {
        let number = |target: Target| self.problem.parameters.iter().position(|one| one.target == target);
        let [Some(cosine), Some(sine)] = GRAVITY_COEFFICIENTS.map(|(_, target)| number(target)) else {
            return Vec::new();
        };
        let numbers = [cosine, sine];
        let at = |values: &[f64]| polar(numbers.map(|number| values[number]));
        let [a, b] = numbers.map(|number| values[number]);
        let torque = at(values)[0].max(f64::MIN_POSITIVE);
        let slopes = [[a / torque, b / torque], [-b / torque / torque, a / torque / torque]];
        let open =
            numbers.iter().map(|number| &known[*number].verdict).find(|verdict| **verdict != Verdict::Determined);
        let verdict = open.cloned().unwrap_or(Verdict::Determined);
        // An angle may be one turn away.
        let angle = at(values)[1];
        let near = |values: &[f64]| angle + (at(values)[1] - angle + PI).rem_euclid(2.0 * PI) - PI;
        let mut found = [
            self.of_both(("gravity", "N"), numbers, slopes[0], &|values| at(values)[0], intervals, values),
            self.of_both(("gravity_angle", "m"), numbers, slopes[1], &near, intervals, values),
        ];
        found.iter_mut().for_each(|one| one.verdict = verdict.clone());
        let [low, high] = found[0].interval();
        if verdict == Verdict::Determined && low <= 0.0 {
            found[0].verdict = Verdict::AtMost(high);
            found[1].verdict = Verdict::Undetermined("the gravity is not distinguishable from 0".to_owned());
        }
        found.into()
    }

    /// A quantity of both coefficients, with its slopes by them.
    fn of_both(
        &self,
        (name, unit): (&str, &'static str),
        numbers: [usize; 2],
        slopes: [f64; 2],
        of: &dyn Fn(&[f64]) -> f64,
        intervals: &Intervals,
        values: &[f64],
    ) -> Estimate {
        let covariance = |a: usize, b: usize| self.trust.covariance[(numbers[a], numbers[b])];
        let rows = [0, 1].map(|a| dot(&slopes, &[covariance(a, 0), covariance(a, 1)]));
        let (value, deviation) = (of(values), dot(&slopes, &rows).max(0.0).sqrt());
        let is_elsewhere = intervals.has_profiles && !self.trust.alternatives.is_empty();
        Estimate {
            name: name.to_owned(),
            unit: Movement::Rotation.unit(unit),
            target: Target::Gravity,
            meaning: Meaning::Undeclared,
            value,
            deviation,
            verdict: Verdict::Determined,
            linear: around(value, deviation),
            profile: is_elsewhere.then(|| self.covering(of, [WIDTH * deviation; 2])),
            repeated: intervals.repeated(of),
        }
    }
}

/// Whether an interval is wider than that of a value that the data determine.
fn is_open(parameter: &Parameter, value: f64, [low, high]: [f64; 2]) -> bool {
    let far = DETERMINED * WIDTH;
    match parameter.scale {
        Scale::Logarithmic => low <= 0.0 || 0.5 * Real::ln(high / low) > far,
        Scale::Linear | Scale::Mixed(_) => 0.5 * (high - low) > far * parameter.large_change(value),
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

    #[test]
    fn coefficients_have_a_torque_and_an_angle_in_all_quadrants() {
        for degrees in -180..=180 {
            let angle = f64::from(degrees).to_radians();
            let [torque, found] = polar([2.5 * angle.cos(), 2.5 * angle.sin()]);
            let apart = (found - angle + PI).rem_euclid(2.0 * PI) - PI;
            assert!((torque - 2.5).abs() < 1e-14 && apart.abs() < 1e-14, "{degrees}: {torque} {found}");
        }
        assert_eq!(polar([0.0; 2]), [0.0; 2]);
        assert_eq!(polar([-3.0, 0.0]), [3.0, PI]);
    }
}
