//! How far a fit can be trusted: which parameters the data determine, and how well.
//!
//! # Equations
//! With the sensitivities J of the forces to the parameters p, the residuals r at n samples, and the correlation time tau
//! of the residuals in samples:
//!
//! ```text
//! s2   = tau r'r / (n - k)                           variance of the noise, as of independent samples
//! C    = (D J'J D / s2 + I)^-1                       D: a large change of each parameter
//! sd_i = sqrt(D_i2 C_ii + B_ii)                    B: covariance by the error of the velocity
//! tau  = 1 + 2 sum of the autocorrelations of r up to the first lag M >= 5 tau(M)
//! ```
//!
//! A large change is half the range on a linear scale and about the value itself on the others. I stands for the
//! knowledge before the data: a parameter is known up to a large change, or up to ten of them if the data turn out not
//! to determine it. The data determine a parameter if they reduce this to less than [`DETERMINED`] of it; otherwise no
//! number is given.
//!
//! # Source
//! Window of the autocorrelation: A. Sokal, "Monte Carlo methods in statistical mechanics: foundations and new
//! algorithms", in Functional Integration (1997), doi:10.1007/978-1-4899-0319-8_6. The limits are chosen.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use stribeck::model::Meaning;

use super::levels::levels_by_direction;
use super::loss::Loss;
use super::map::{by_velocity, neighbours, student};
use super::parameter::{Parameter, Target, is_level};
use super::ports::Ports;
use super::problem::{Found, Problem, dot, minus, moved};
use super::velocity_error;
use stribeck_measured::OF_MEDIAN;

/// Correlation time of the residuals from which the law does not explain them, in samples (chosen).
pub(super) const SYSTEMATIC: f64 = 3.0;

/// Part of a large change up to which the data must know a parameter.
pub const DETERMINED: f64 = 0.4;

/// Standard deviations of an interval that holds in 95 % of cases.
pub(super) const WIDTH: f64 = 1.959_963_984_540_054;

/// Distance from an end of a range, as a part of it, that counts as the end.
const AT_END: f64 = 1e-3;

/// Correlation of two parameters that the data tell only together.
const TOGETHER: f64 = 0.95;

/// Verdict on a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The data determine it.
    Determined,
    /// The data do not tell it from 0; it is at most this, in 97.5 % of cases.
    AtMost(f64),
    /// The data do not determine it, for this reason.
    Undetermined(String),
    /// It is at an end of the range in which it was searched: the range, or the law, is wrong.
    AtEnd(f64),
}

impl Verdict {
    /// Whether the data tell an interval or an upper limit.
    pub(super) fn is_informative(&self) -> bool {
        matches!(self, Verdict::Determined | Verdict::AtMost(_))
    }
}

/// The text of a verdict, wherever it is shown.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Verdict::Determined => f.write_str("determined"),
            Verdict::AtMost(most) => write!(f, "not distinguishable from 0; at most {}", digits(*most)),
            Verdict::Undetermined(reason) => write!(f, "not determined: {reason}"),
            Verdict::AtEnd(end) => write!(f, "at an end of its range: {}", digits(*end)),
        }
    }
}

/// A number with four digits.
pub fn digits(value: f64) -> String {
    Notation::of(value, f64::INFINITY).text(value)
}

/// How the numbers of a row are written, so that they can be compared at a glance: with the same power of ten and as many
/// decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Power of ten behind each number; none is written if it is 0.
    power: i32,
    decimals: usize,
}

impl Notation {
    /// Shows four digits of a value, or as many more as show two of the width of its interval; below 0.001 and from 100,000
    /// on with its power of ten.
    pub fn of(value: f64, width: f64) -> Notation {
        let has_width = width > 0.0 && width.is_finite();
        // Zero is as large as its interval.
        let value = if value != 0.0 {
            value
        } else if has_width {
            width
        } else {
            1.0
        };
        let order = |number: f64| number.abs().max(1e-300).log10().floor();
        let of_width = if has_width { order(value) - order(width) + 1.0 } else { 0.0 };
        // Beyond these a number of double precision has no more.
        let after_first = of_width.clamp(3.0, 15.0);
        if (1e-3..1e5).contains(&value.abs()) {
            return Notation { power: 0, decimals: (after_first - order(value)).max(0.0) as usize };
        }
        let decimals = after_first as usize;
        // Rounding may carry over: 9.9999e-4 is 1.000e-3.
        let text = format!("{value:.decimals$e}");
        Notation { power: text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0), decimals }
    }

    /// A number in this notation.
    pub fn text(self, number: f64) -> String {
        let Notation { power, decimals } = self;
        if number == 0.0 {
            return "0".to_owned();
        }
        if power == 0 {
            let text = format!("{number:.decimals$}");
            // What is rounded to 0 has no sign.
            let is_zero = !text.contains(|digit: char| matches!(digit, '1'..='9'));
            return if is_zero { text.trim_start_matches('-').to_owned() } else { text };
        }
        // Powers of ten above 1 are exact, those below are not.
        let scaled = if power < 0 { number * 10f64.powi(-power) } else { number / 10f64.powi(power) };
        format!("{scaled:.decimals$}e{power}")
    }

    /// Both ends of an interval.
    pub fn ends(self, [low, high]: [f64; 2]) -> String {
        format!("{} to {}", self.text(low), self.text(high))
    }

    /// A value with the distances of both ends of its interval: one number where they are the same as they are written.
    pub fn with_interval(self, value: f64, [low, high]: [f64; 2]) -> String {
        let [down, up] = [value - low, high - value].map(|distance| self.text(distance));
        let value = self.text(value);
        if down == up { format!("{value} \u{b1} {up}") } else { format!("{value} +{up} -{down}") }
    }
}

/// Size and correlation of the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// Root mean square, N.
    pub rms: f64,
    /// Root of twice the mean loss, N: the same unless the loss is robust.
    pub loss: f64,
    /// Standard deviation of the noise that counts, N: the same unless the loss is robust.
    pub noise: f64,
    /// Mean second derivative of the loss: 1 unless the loss is robust.
    pub softness: f64,
    /// Correlation of neighbours.
    pub neighbours: f64,
    /// Samples that count as one.
    pub correlation: f64,
    /// Width of an interval over that by the normal distribution: 1 unless the samples are few and independent.
    pub student: f64,
}

impl Residuals {
    /// Those of a fit.
    pub(super) fn of_fit(problem: &Problem, all: &[f64]) -> Residuals {
        let found = residuals(all, &problem.lengths(), problem.parameters.len(), problem.loss);
        if !problem.is_map() {
            return found;
        }
        let freedom = all.len().saturating_sub(problem.parameters.len()).max(1);
        let neighbours = neighbours(&by_velocity(&problem.velocities(), all));
        Residuals { correlation: 1.0, neighbours, student: student(WIDTH, freedom), ..found }
    }

    /// Variance of the noise, as of independent samples, which makes normal intervals as wide as those of few samples.
    pub(super) fn variance(&self) -> f64 {
        self.noise * self.noise * self.correlation * self.student * self.student
    }

    /// Rise of twice the cost that counts as much as the sum of squares rising by the variance.
    pub(super) fn rise(&self) -> f64 {
        self.variance() * self.softness
    }
}

/// Knowledge of parameters by the sensitivities alone.
pub(super) struct Known {
    /// Information of the data, in large changes of the parameters.
    information: DMatrix<f64>,
    /// Covariance, in large changes.
    scaled: DMatrix<f64>,
    /// Standard deviations as parts of a large change.
    pub parts: Vec<f64>,
}

impl Known {
    /// From sensitivities with noise of a variance.
    pub fn of(columns: &[Vec<f64>], large: &[f64], variance: f64, is_certain: &dyn Fn(usize) -> bool) -> Known {
        let information = DMatrix::from_fn(columns.len(), columns.len(), |a, b| {
            dot(&columns[a], &columns[b]) * large[a] * large[b] / variance
        });
        let scaled = spread(&information, is_certain);
        Known { parts: standard_deviations(&scaled), information, scaled }
    }

    /// Standard deviation as a part of a large change, if the other parameters were known.
    pub fn alone(&self, number: usize) -> f64 {
        1.0 / (1.0 + self.information[(number, number)]).sqrt()
    }
}

/// Knowledge of the parameters, in the order of the problem.
pub(super) struct Uncertainty {
    /// Standard deviations, by the noise of the force and by the error of the velocity.
    pub standard_deviations: Vec<f64>,
    /// The part of them by the error of the velocity.
    pub blurs: Vec<f64>,
    /// Covariance of the values, by both.
    pub covariance: DMatrix<f64>,
    /// The part of it by the noise of the force.
    noise_covariance: DMatrix<f64>,
    known: Known,
    pub verdicts: Vec<Verdict>,
    /// Whether the force changes in jumps with a parameter that it determines otherwise.
    pub is_discontinuous: Vec<bool>,
    /// Points that explain the force as well; empty unless they were looked for.
    pub alternatives: Vec<Alternative>,
    /// Sensitivities of the forces.
    pub columns: Vec<Vec<f64>>,
    /// Variance of the noise, as of independent samples.
    pub variance: f64,
    /// Correlations among the parameters.
    pub correlation: DMatrix<f64>,
    /// Ratio of the best to the worst known direction.
    pub condition: f64,
}

/// A point that explains the force about as well as the best one, with one parameter held there.
pub(super) struct Alternative {
    pub number: usize,
    pub end: Found,
    /// Rise of the sum of squares, in variances.
    pub rise: f64,
}

fn squares(values: &[f64]) -> f64 {
    values.iter().map(|one| one * one).sum()
}

/// Sum of the products of values a lag apart within each experiment.
fn products(mut values: &[f64], lengths: &[usize], lag: usize) -> f64 {
    let of_experiment = |length: &usize| {
        let (part, others) = values.split_at(*length);
        values = others;
        part.iter().zip(part.iter().skip(lag)).map(|(a, b)| a * b).sum::<f64>()
    };
    lengths.iter().map(of_experiment).sum()
}

/// Residuals of several experiments, one after the other.
pub(super) fn residuals(all: &[f64], lengths: &[usize], parameters: usize, loss: Loss) -> Residuals {
    let freedom = (all.len().saturating_sub(parameters)).max(1) as f64;
    let (found, softness) = loss.influence(all);
    let square = squares(&found);
    let lag = |lag: usize| if square > 0.0 { products(&found, lengths, lag) / square } else { 0.0 };
    let longest = usize::min(all.len() / 10, lengths.iter().copied().max().unwrap_or(0));
    let mut correlation = 1.0;
    for at in 1..=longest {
        correlation += 2.0 * lag(at);
        if at as f64 >= 5.0 * correlation {
            break;
        }
    }
    Residuals {
        rms: (squares(all) / freedom).sqrt(),
        loss: (2.0 * loss.cost(all) / freedom).sqrt(),
        noise: (square / freedom).sqrt(),
        softness,
        neighbours: lag(1),
        correlation: correlation.max(1.0),
        student: 1.0,
    }
}

/// Knowledge before the data about a parameter that the data do not determine, in large changes (chosen): what depends
/// on it is not determined either.
const UNKNOWN: f64 = 10.0;

/// Standard deviations.
fn standard_deviations(covariance: &DMatrix<f64>) -> Vec<f64> {
    covariance.diagonal().iter().map(|one| one.sqrt()).collect()
}

fn correlations(covariance: &DMatrix<f64>) -> DMatrix<f64> {
    let all = standard_deviations(covariance);
    DMatrix::from_fn(all.len(), all.len(), |a, b| covariance[(a, b)] / (all[a] * all[b]))
}

/// Whether a parameter is a speed below the error of the velocity, or the reciprocal of one.
fn is_within(parameter: &Parameter, value: f64, error: f64) -> bool {
    match parameter.unit {
        "m/s" => value < error,
        "s/m" => value * error > 1.0,
        _ => false,
    }
}

/// Whether the error of the velocity hides a parameter, whatever the noise of the force.
fn is_lost(problem: &Problem, values: &[f64], number: usize) -> bool {
    let error = problem.experiments.iter().map(velocity_error::error).fold(0.0, f64::max);
    is_within(&problem.parameters[number], values[number], error) || hides_damping(problem, values, number, error)
}

/// Whether a parameter is the damping of bristles, and the error of the velocity hides it.
fn hides_damping(problem: &Problem, values: &[f64], number: usize, error: f64) -> bool {
    let known = |target: Target| problem.parameters.iter().position(|one| one.target == target).map(|at| values[at]);
    let is_slow = |(_, speed): (String, f64)| error > velocity_error::BLURRED * speed;
    problem.parameters[number].meaning == Meaning::Damping
        && velocity_error::speed_of_fall(problem, known).is_some_and(is_slow)
}

/// The other parameter with which the data tell a parameter only together.
fn partner(correlation: &DMatrix<f64>, number: usize) -> Option<usize> {
    let size = |other: &usize| correlation[(number, *other)].abs();
    let others = (0..correlation.nrows()).filter(|other| *other != number && size(other) > TOGETHER);
    others.max_by(|a, b| size(a).total_cmp(&size(b)))
}

/// Part of itself by which a parameter must follow another one that the data do not determine, where that changes by as
/// much as its value, to be told only together with it (chosen): straight lines end long before the other one does.
const FOLLOWS: f64 = 0.5;

/// The parameter that the data do not determine and that a parameter follows.
fn followed(covariance: &DMatrix<f64>, values: &[f64], open: &[bool], number: usize) -> Option<usize> {
    let slope = |other: usize| covariance[(number, other)] / covariance[(other, other)];
    let shift = |other: usize| (slope(other) * values[other]).abs();
    // The deviation where the other one is known.
    let alone =
        |other: usize| (covariance[(number, number)] - slope(other) * covariance[(number, other)]).max(0.0).sqrt();
    let least = |other: usize| FOLLOWS * values[number].abs().max(alone(other));
    let others = (0..values.len()).filter(|other| *other != number && open[*other] && shift(*other) > least(*other));
    others.max_by(|a, b| shift(*a).total_cmp(&shift(*b)))
}

/// Uncertainties of the parameters at a point.
pub(super) fn uncertainty(problem: &Problem, point: &[f64], residuals: &Residuals) -> Uncertainty {
    let mut trust = by_sensitivities(problem, point, residuals);
    let large = problem.large_changes(&problem.values(point));
    let is_jumpy = |number: usize| {
        let deviation = trust.known.parts[number] * large[number];
        let slopes = &trust.columns[number];
        !trust.is_open(number) && !is_smooth(problem, point, residuals.noise, number, deviation, slopes)
    };
    trust.is_discontinuous = (0..large.len()).map(is_jumpy).collect();
    trust.verdicts = (0..large.len()).map(|number| trust.verdict(problem, point, number)).collect();
    trust
}

/// The same before verdicts.
fn by_sensitivities(problem: &Problem, point: &[f64], residuals: &Residuals) -> Uncertainty {
    let large = problem.large_changes(&problem.values(point));
    let columns = problem.sensitivities(point);
    let variance = residuals.variance().max(f64::MIN_POSITIVE);
    // The delay of an axis is searched wherever it can be.
    let is_axis = problem.experiments.iter().any(|one| one.matched_filter.is_some());
    let is_certain = |number: usize| is_axis && problem.parameters[number].target == Target::Delay;
    let known = Known::of(&columns, &large, variance, &is_certain);
    let spectrum = known.information.clone().symmetric_eigen().eigenvalues;
    let noise_covariance =
        DMatrix::from_fn(large.len(), large.len(), |a, b| known.scaled[(a, b)] * large[a] * large[b]);
    let blur = velocity_error::blur(problem, point, &columns, &noise_covariance.map(|one| one / variance));
    let covariance = &noise_covariance + &blur;
    Uncertainty {
        verdicts: Vec::new(),
        is_discontinuous: Vec::new(),
        alternatives: Vec::new(),
        condition: (spectrum.max() / spectrum.min().max(f64::MIN_POSITIVE)).sqrt(),
        standard_deviations: standard_deviations(&covariance),
        blurs: standard_deviations(&blur),
        covariance,
        noise_covariance,
        correlation: correlations(&known.scaled),
        known,
        columns,
        variance,
    }
}

impl Uncertainty {
    /// Whether the noise of the force leaves a parameter open.
    fn is_open(&self, number: usize) -> bool {
        self.known.parts[number] > DETERMINED
    }

    /// The verdict on a parameter.
    fn verdict(&self, problem: &Problem, point: &[f64], number: usize) -> Verdict {
        let values = problem.values(point);
        let [value, half] = [values[number], WIDTH * self.standard_deviations[number]];
        if let Some(reason) = self.reason(problem, &values, number) {
            Verdict::Undetermined(reason)
        } else if problem.parameters[number].can_be_zero() && value < half {
            Verdict::AtMost(value + half)
        } else if !(AT_END..=1.0 - AT_END).contains(&point[number]) {
            Verdict::AtEnd(value)
        } else {
            Verdict::Determined
        }
    }

    /// Why the data do not determine a parameter, if they do not.
    fn reason(&self, problem: &Problem, values: &[f64], number: usize) -> Option<String> {
        let parameter = &problem.parameters[number];
        let open: Vec<bool> = (0..values.len()).map(|number| self.is_open(number)).collect();
        let followed = followed(&self.noise_covariance, values, &open, number);
        let is_blurred = self.standard_deviations[number] > DETERMINED * parameter.large_change(values[number]);
        if let Some(reason) = not_apart(problem, number).filter(|_| open[number] || followed.is_some()) {
            Some(reason)
        } else if open[number] || followed.is_some() {
            let why = match partner(&self.correlation, number).or(followed) {
                _ if self.known.alone(number) > DETERMINED => "it hardly changes the force".to_owned(),
                Some(other) => format!("only in combination with {}", problem.parameters[other].name),
                None => "only in combination with others".to_owned(),
            };
            Some(format!("{why}; {}", remedy(parameter, &problem.ports)))
        } else if is_blurred || is_lost(problem, values, number) {
            Some("the velocity is not known well enough; measure it, or sample the motion faster".to_owned())
        } else {
            self.is_discontinuous[number]
                .then(|| "the force changes with it in jumps, so that no interval can be given".to_owned())
        }
    }

    /// Standard deviation of a parameter by the noise of the force alone.
    pub fn by_noise(&self, number: usize) -> f64 {
        self.noise_covariance[(number, number)].sqrt()
    }

    /// Change of the best value of one parameter with the value of another.
    pub fn follows(&self, one: usize, other: usize) -> f64 {
        self.noise_covariance[(one, other)] / self.noise_covariance[(other, other)]
    }

    /// Shift of the parameters that an error of the predicted forces causes, in standard deviations; the largest one.
    pub fn shift(&self, error: &[f64]) -> f64 {
        self.shifts(error).into_iter().fold(0.0, f64::max)
    }

    /// The shift of each parameter.
    fn shifts(&self, error: &[f64]) -> Vec<f64> {
        let pull = |column: &Vec<f64>| dot(column, error) / self.variance;
        let pull = DVector::from_iterator(self.columns.len(), self.columns.iter().map(pull));
        let shifts = &self.noise_covariance * pull;
        shifts.iter().zip(&self.standard_deviations).map(|(shift, deviation)| (shift / deviation).abs()).collect()
    }

    /// Marks as not determined each parameter for which two searches end at different values, although they explain the
    /// force alike: where a force changes in jumps, there are many ends, and straight lines around one of them do not
    /// know the others.
    pub fn doubt_ends(&mut self, [first, second]: [Vec<f64>; 2]) {
        let ends = first.iter().zip(&second);
        for ((verdict, deviation), (first, second)) in self.verdicts.iter_mut().zip(&self.standard_deviations).zip(ends)
        {
            if verdict.is_informative() && (first - second).abs() > deviation.max(ROUNDING * first.abs()) {
                *verdict = Verdict::Undetermined(format!(
                    "two searches end at {} and at {}, which explain the force alike",
                    digits(*first),
                    digits(*second)
                ));
            }
        }
    }

    /// Calls what a few samples decide not determined: their residuals are far larger than the others, such as those of
    /// a law that jumps where the sign of the velocity is not known. `noise` is that of the force.
    pub fn doubt_outliers(&mut self, residuals: &[f64], noise: f64) {
        let mut sizes: Vec<f64> = residuals.iter().map(|one| one.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let usual = noise.max(OF_MEDIAN * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0));
        let is_far = |one: f64| one.abs() > OUTLIER * usual;
        let count = residuals.iter().filter(|one| is_far(**one)).count();
        let far: Vec<f64> = residuals.iter().map(|one| if is_far(*one) { *one } else { 0.0 }).collect();
        let shifts = self.shifts(&far);
        for (verdict, shift) in self.verdicts.iter_mut().zip(shifts) {
            if shift > MOVED && verdict.is_informative() {
                *verdict = Verdict::Undetermined(format!(
                    "{count} of {} samples, more than {OUTLIER} times the noise off, shift it by {shift:.1} standard \
                     deviations; use the robust loss, or leave out rest",
                    residuals.len()
                ));
            }
        }
    }
}

/// Part of a value by which two ends may differ without noise.
const ROUNDING: f64 = 1e-6;

/// Standard deviations from which a sample is an outlier, and shift by all of them, in standard deviations, from which a
/// value is theirs (chosen).
const OUTLIER: f64 = 5.0;
const MOVED: f64 = 1.0;

/// (information + knowledge before the data)^-1, with less knowledge about what the data do not determine, unless its
/// range is known for certain.
pub(super) fn spread(information: &DMatrix<f64>, is_certain: &dyn Fn(usize) -> bool) -> DMatrix<f64> {
    let count = information.nrows();
    let mut before = vec![1.0; count];
    loop {
        let known = DMatrix::from_fn(count, count, |a, b| if a == b { 1.0 / (before[a] * before[a]) } else { 0.0 });
        let spread =
            (information + &known).cholesky().map_or_else(|| known.map(|one| one.recip()), |all| all.inverse());
        let is_open = |number: usize| spread[(number, number)].sqrt() > DETERMINED && !is_certain(number);
        let is_new = |number: &usize| before[*number] == 1.0 && is_open(*number);
        let Some(number) = (0..count).find(is_new) else { return spread };
        before[number] = UNKNOWN;
    }
}

/// Part of the foreseen change of the force that the true one must reach for straight lines to be believed, and part by
/// which it may differ from the foreseen one (chosen): it is then at most twice as large.
const REACHED: f64 = 1.0 / 3.0;
const ASTRAY: f64 = 1.0;

/// Whether the force changes as the sensitivities foresee, when a parameter alone moves by a standard deviation: as much,
/// and at the same samples. A law with memory of random numbers changes as much and elsewhere: its sum of squares
/// has local minima everywhere.
pub(super) fn is_smooth(
    problem: &Problem,
    point: &[f64],
    noise: f64,
    number: usize,
    deviation: f64,
    slopes: &[f64],
) -> bool {
    let [value, slope] = problem.parameters[number].value(point[number]);
    let step = (deviation / slope.abs().max(f64::MIN_POSITIVE)).min(0.1);
    let Some(here) = problem.residuals(point) else { return false };
    let agrees = |direction: f64| {
        let moved = moved(point, number, direction * step);
        let distance = problem.parameters[number].value(moved[number])[0] - value;
        let foreseen: Vec<f64> = slopes.iter().map(|slope| slope * distance).collect();
        problem.residuals(&moved).is_some_and(|there| is_foreseen(&minus(&there, &here), &foreseen, noise))
    };
    // At an end of the range one side is enough.
    [-1.0, 1.0].into_iter().filter(|side| (0.0..=1.0).contains(&(point[number] + side * step))).all(agrees)
}

/// Whether a change of the force is about the foreseen one. Less than the noise does not matter.
fn is_foreseen(found: &[f64], foreseen: &[f64], noise: f64) -> bool {
    let [change, expected, astray] = [found, foreseen, &minus(found, foreseen)].map(|change| squares(change).sqrt());
    change.max(expected) < 0.1 * noise || (change >= REACHED * expected && astray <= ASTRAY * expected)
}

/// Why the data do not tell an offset or a level of one direction, if both levels and the offset are parameters.
fn not_apart(problem: &Problem, number: usize) -> Option<String> {
    let levels = levels_by_direction(problem.law)?;
    let of_three = [Target::Offset, Target::Column(levels[0]), Target::Column(levels[1])];
    let has = |target: &Target| problem.parameters.iter().any(|one| one.target == *target);
    let is_one = of_three.contains(&problem.parameters[number].target) && of_three.iter().all(has);
    is_one.then(|| {
        let [forward, backward] = levels.map(|column| problem.law.table.at(column).path);
        format!(
            "an offset of the force and a difference of the levels by direction cannot be told apart; hold the offset \
             (fix offset=0: the levels contain it then) or tie the levels (tie {backward}={forward})"
        )
    })
}

/// The experiment that would determine a parameter.
fn remedy(parameter: &Parameter, ports: &Ports) -> String {
    let text = match (parameter.target, parameter.meaning) {
        (Target::Excess { .. }, _) => "move more slowly around rest, and break away from rest",
        (Target::Delay, _) => "move with several frequencies",
        (Target::Mass, _) => "accelerate more",
        (Target::Cosine | Target::Sine, _) => "turn through a wider range of angles",
        (_, meaning) if is_level(meaning) => "slide longer at several speeds",
        (_, Meaning::Damping) => "reverse faster, and sample the reversals more often",
        (_, Meaning::Viscous | Meaning::GrowsWithSpeed) => "slide faster",
        _ => return remedy_by_unit(parameter.unit, ports),
    };
    text.to_owned()
}

/// The same for a parameter that plays no part of its own.
fn remedy_by_unit(unit: &str, ports: &Ports) -> String {
    let text = match unit {
        "N/m" | "m" => "reverse often, with strokes shorter than the pre-sliding displacement",
        "m/s" | "s/m" => "move more slowly around rest",
        "s" => "let it rest for different times, and change the speed quickly",
        "N" if ports.load.is_some() => "add runs with other normal forces",
        "N" if !ports.led.is_empty() => {
            let names: Vec<&str> = ports.led.iter().map(|led| led.name).collect();
            return format!("add runs with other values of {}", names.join(", "));
        }
        _ => "excite it more",
    };
    text.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_has_four_digits_or_those_of_its_interval() {
        assert_eq!(
            [0.0, 0.12344, -49.99777, 1e-4, 123_456.0].map(digits),
            ["0", "0.1234", "-50.00", "1.000e-4", "1.235e5"]
        );
        // Widths of 0.0034, of more than the value, and of a millionth of it.
        let within = |value: f64, width: f64| Notation::of(value, width).text(value);
        assert_eq!(within(49.99777, 0.0034), "49.9978");
        assert_eq!(within(49.99777, 80.0), "50.00");
        assert_eq!(within(123_456.0, 0.123), "1.2345600e5");
        assert_eq!(within(1.0, 0.0), "1.000");
        assert_eq!(within(9.9999e-4, f64::INFINITY), "1.000e-3");
    }

    #[test]
    fn the_numbers_of_a_row_have_one_notation() {
        let low = Notation::of(9.757e-4, 6e-5);
        assert_eq!(
            [9.757e-4, 0.001_035, 0.0, -3e-5].map(|one| low.text(one)),
            ["9.757e-4", "10.350e-4", "0", "-0.300e-4"].map(str::to_owned)
        );
        let high = Notation::of(98_817.0, 1900.0);
        assert_eq!(high.ends([98_817.0, 100_700.0]), "98817 to 100700");
        assert_eq!(Notation::of(1.002e5, 1900.0).ends([98_817.0, 100_700.0]), "0.988e5 to 1.007e5");
        assert_eq!(Notation::of(1.0, 0.01).text(-1e-6).trim_matches('0'), ".");
        assert_eq!(Notation::of(0.2, 2e-4).with_interval(0.2, [0.1999, 0.2001]), "0.20000 \u{b1} 0.00010");
        assert_eq!(Notation::of(9.7e-4, 1e-4).with_interval(9.7e-4, [9e-4, 1e-3]), "9.700e-4 +0.300e-4 -0.700e-4");
    }

    /// Each residual is 0.8 of the one before and noise: (1 + 0.8) / (1 - 0.8) samples count as one, also beside an
    /// experiment with few samples.
    #[test]
    fn a_short_experiment_does_not_hide_the_correlation_of_a_long_one() {
        let mut one = 0.0;
        let noise = super::super::tests::noise(3, 8000);
        let mut all: Vec<f64> = noise
            .into_iter()
            .map(|noise| {
                one = 0.8 * one + noise;
                one
            })
            .collect();
        all.extend([1.0; 8]);
        let residuals = residuals(&all, &[8000, 8], 2, Loss::SQUARES);
        assert!((residuals.correlation / 9.0 - 1.0).abs() < 0.2, "{}", residuals.correlation);
    }

    /// The second parameter is known up to ten of its values; the first follows it, or has a deviation of its own.
    #[test]
    fn what_is_known_for_another_one_only_follows_it() {
        let values = [0.007, 0.24];
        let follows = |slope: f64, alone: f64| {
            let open: f64 = 2.4 * 2.4;
            let covariance = [slope * slope * open + alone * alone, slope * open, slope * open, open];
            followed(&DMatrix::from_row_slice(2, 2, &covariance), &values, &[false, true], 0)
        };
        assert_eq!(follows(0.025, 1e-4), Some(1));
        assert_eq!(follows(0.025, 2e-2), None);
        assert_eq!(follows(0.01, 1e-4), None);
    }
}
