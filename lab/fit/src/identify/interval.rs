//! Intervals that do not rely on straight lines: profile likelihood, and repetition with blocks of residuals.
//!
//! # Source
//! Profiles: D. J. Venzon, S. H. Moolgavkar, "A method for computing profile-likelihood-based confidence intervals",
//! Applied Statistics 37 (1988), doi:10.2307/2347496. Blocks: H. R. Kuensch, "The jackknife and the bootstrap for
//! general stationary observations", Annals of Statistics 17 (1989), doi:10.1214/aos/1176347265.

use std::iter::repeat_with;

use stribeck::number::Real;

use super::parameter::Scale;
use super::problem::{Found, Problem, minus};
use super::search::{Watch, polish, polish_until};
use super::uncertainty::{Alternative, Residuals, Uncertainty, Verdict, WIDTH};

/// Rise of the sum of squares, in variances, at the ends of an interval that holds in 95 % of cases.
const RISE: f64 = WIDTH * WIDTH;

/// Rise from which noise is not the reason that an effect is seen (chosen: four standard deviations).
const SURE: f64 = 16.0;

/// Trials on the way to an end (chosen).
const TRIALS: usize = 12;

/// A fit at its end.
pub(super) struct Optimum<'a> {
    pub problem: &'a Problem<'a>,
    pub best: &'a Found,
    pub residuals: &'a Residuals,
    pub trust: &'a Uncertainty,
}

impl Optimum<'_> {
    /// Interval of a parameter: as far as the sum of squares, at the best values of the others, rises by less than noise
    /// can make it, and farther by the error of the velocity. An end at an end of the range is open.
    pub fn profile(&self, number: usize) -> [f64; 2] {
        let value = self.problem.parameters[number].value(self.best.point[number])[0];
        let blur = WIDTH * self.trust.blurs[number];
        let distance = |direction| ((self.end(number, direction) - value).powi(2) + blur * blur).sqrt();
        self.covering(|values| values[number], [-1.0, 1.0].map(distance))
    }

    /// An interval, by the distances of its ends from the best value, that covers what explains the force as well
    /// elsewhere too: along the joint profile of two parameters, the width of one is that of an ellipse.
    pub fn covering(&self, of: impl Fn(&[f64]) -> f64, [low, high]: [f64; 2]) -> [f64; 2] {
        let at = |found: &Found, part: f64| {
            let value = of(&self.problem.values(&found.point));
            [value - part * low, value + part * high]
        };
        let near = self.trust.alternatives.iter().filter(|other| other.rise < RISE);
        let others = near.map(|other| at(&other.end, (1.0 - other.rise.max(0.0) / RISE).sqrt()));
        others.fold(at(self.best, 1.0), |[least, most], [low, high]| [least.min(low), most.max(high)])
    }

    /// Value at which the sum of squares has risen to its limit.
    fn end(&self, number: usize, direction: f64) -> f64 {
        let Optimum { problem, best, trust, .. } = *self;
        let mut last: Option<(f64, Found)> = None;
        let rise = |distance: f64| {
            let coordinate = best.point[number] + direction * distance;
            let from = match &last {
                Some((farther, end)) => part_of_the_way(best, end, distance / farther),
                None => along(problem, best, trust, number, coordinate),
            };
            let end = held(problem, &from, number, coordinate, self.gain());
            let rise = self.rise(&end);
            last = Some((distance, end));
            rise
        };
        let most = if direction > 0.0 { 1.0 - best.point[number] } else { best.point[number] };
        let distance = crossing(rise, WIDTH * self.step(number), most);
        problem.parameters[number].value(best.point[number] + direction * distance)[0]
    }

    /// Unknowns on a logarithmic scale that may as well be at an end of their range, where they have no effect, with the
    /// value there. If noise is what tells a parameter, which it does in one of twenty records, its interval is wrong.
    pub fn without_effect(&self) -> Vec<(usize, f64)> {
        let Optimum { problem, trust, .. } = *self;
        let is_candidate = |number: &usize| {
            problem.parameters[*number].scale == Scale::Logarithmic && trust.verdicts[*number] == Verdict::Determined
        };
        let is_alike = |number: usize, coordinate: f64| self.elsewhere(number, coordinate, SURE).is_some();
        let alike = |number: usize| {
            let coordinate = [0.0, 1.0].into_iter().find(|coordinate| is_alike(number, *coordinate))?;
            Some((number, problem.parameters[number].value(coordinate)[0]))
        };
        (0..problem.parameters.len()).filter(is_candidate).filter_map(alike).collect()
    }

    /// Points that explain the force as well, with each parameter that the data do not determine held elsewhere: far from
    /// the best point, and close to it if the force changes with it in jumps.
    pub fn alternatives(&self) -> Vec<Alternative> {
        let Optimum { problem, best, trust, .. } = *self;
        let is_free = |number: &usize| matches!(trust.verdicts[*number], Verdict::Undetermined(_));
        let mut found = Vec::new();
        if !trust.verdicts.iter().any(Verdict::is_informative) {
            return found;
        }
        for number in (0..problem.parameters.len()).filter(is_free) {
            let steps =
                DISTANCES.iter().flat_map(|distance| [-distance, *distance]).filter(|_| trust.is_discontinuous[number]);
            let close = steps.map(|distance| best.point[number] + distance * self.step(number));
            let close = close.filter(|coordinate| (0.0..=1.0).contains(coordinate));
            let most = joint_rise(problem.parameters.len());
            found
                .extend(FAR.into_iter().chain(close).filter_map(|coordinate| self.elsewhere(number, coordinate, most)));
        }
        found
    }

    /// The best point with a parameter held at a coordinate, if the sum of squares rises by less than a limit, in variances.
    /// The slopes are not followed to their end where they hardly lead down from far above it.
    fn elsewhere(&self, number: usize, coordinate: f64, most: f64) -> Option<Alternative> {
        let rough = Problem { is_rough: true, ..self.problem.clone() };
        let first =
            held(&rough, &self.start(number, coordinate), number, coordinate, self.part_of_cost(most / HOPELESS));
        if self.rise(&first) > HOPELESS * most {
            return None;
        }
        let end = held(self.problem, &first, number, coordinate, self.gain());
        let rise = self.rise(&end);
        (rise < most).then_some(Alternative { number, end, rise })
    }

    /// The best of three points with a parameter at a coordinate: with the others as they are, where straight lines expect them,
    /// and where powers of the parameter do, such as its multiples where the data tell a ratio only.
    fn start(&self, number: usize, coordinate: f64) -> Found {
        let Optimum { problem, best, trust, .. } = *self;
        let mut same = best.clone();
        same.point[number] = coordinate;
        let [before, after] = [&best.point, &same.point].map(|point| problem.values(point));
        let ratio = after[number] / before[number];
        let mut scaled = same.clone();
        for other in (0..before.len()).filter(|other| *other != number) {
            let power = trust.follows(other, number) * before[number] / before[other];
            let value = before[other] * Real::exp(power * Real::ln(ratio));
            if value.is_finite() {
                scaled.point[other] = problem.parameters[other].coordinate(value);
            }
        }
        let starts = [same, along(problem, best, trust, number, coordinate), scaled].map(|found| problem.judge(found));
        starts.into_iter().min_by(|a, b| a.cost.total_cmp(&b.cost)).unwrap_or_else(|| best.clone())
    }

    /// Rise of the sum of squares from the best point, in variances.
    fn rise(&self, end: &Found) -> f64 {
        2.0 * (end.cost - self.best.cost) / self.residuals.rise()
    }

    /// Standard deviation of the coordinate of a parameter by the noise of the force.
    fn step(&self, number: usize) -> f64 {
        let [_, slope] = self.problem.parameters[number].value(self.best.point[number]);
        (self.trust.by_noise(number) / slope.abs().max(f64::MIN_POSITIVE)).clamp(1e-9, 0.5)
    }

    /// Unknowns that move when one that the data do not determine is held elsewhere: pairs of the one that moves and the
    /// one it depends on.
    pub fn dependent(&self) -> Vec<(usize, usize)> {
        let values = self.problem.values(&self.best.point);
        let mut found: Vec<(usize, usize)> = Vec::new();
        for alternative in &self.trust.alternatives {
            for (other, (value, moved)) in values.iter().zip(self.problem.values(&alternative.end.point)).enumerate() {
                let change = (moved - value).abs();
                let is_far = change > MOVED[0] * self.trust.standard_deviations[other]
                    && change > MOVED[1] * self.problem.parameters[other].large_change(*value);
                if other != alternative.number && is_far && found.iter().all(|(known, _)| *known != other) {
                    found.push((other, alternative.number));
                }
            }
        }
        found
    }

    /// Points of the parameters in fits to the predicted forces with [`noise`]; none if they are ended early, since some
    /// of the repetitions do not make an interval.
    pub fn repetitions(&self, count: usize, seed: u64, watch: Watch) -> Vec<Vec<f64>> {
        let Optimum { problem, best, residuals, .. } = *self;
        let Some(left) = problem.residuals(&best.point) else { return Vec::new() };
        let measured = problem.measured();
        let from = Found { cost: f64::INFINITY, ..best.clone() };
        let mut random = fastrand::Rng::with_seed(seed);
        let again = || {
            let change = minus(
                &left,
                &noise(&left, problem.parameters.len(), problem.block(residuals.correlation), &mut random),
            );
            let change = problem.without_weights(change);
            let forces = measured.iter().zip(change).map(|(measured, change)| measured + change).collect();
            let found = polish(&Problem { substitute: Some(forces), ..problem.clone() }, &from).point;
            (watch.progress)(residuals.rms, best.evaluations);
            (!watch.is_cancelled()).then_some(found)
        };
        let all = if watch.is_cancelled() { None } else { repeat_with(again).take(count).collect() };
        all.unwrap_or_default()
    }

    /// Gain of a step of least squares, as a part of the cost, from which another one follows.
    fn gain(&self) -> f64 {
        self.part_of_cost(UNSEEN * RISE)
    }

    /// A rise of the sum of squares, in variances, as a part of the cost.
    fn part_of_cost(&self, rise: f64) -> f64 {
        rise * self.residuals.rise() / (2.0 * self.best.cost).max(f64::MIN_POSITIVE)
    }
}

/// Rise of the sum of squares, in variances, within which all parameters together are in 95 % of cases: where one of several
/// local minima is the best, the others may be as likely. Approximation of chi square: E. B. Wilson, M. M. Hilferty,
/// Proceedings of the National Academy of Sciences 17 (1931), doi:10.1073/pnas.17.12.684.
fn joint_rise(parameters: usize) -> f64 {
    chi_square(parameters as f64, 1.644_853_626_951_472)
}

/// Chi square of so many degrees of freedom where a normal distribution has a quantile.
pub(super) fn chi_square(freedom: f64, normal: f64) -> f64 {
    let part = 2.0 / (9.0 * freedom);
    freedom * (1.0 - part + normal * part.sqrt()).powi(3)
}

/// Multiple of a limit from which the sum of squares does not fall below it, where a step of least squares gains less than
/// the limit divided by this (chosen).
const HOPELESS: f64 = 4.0;

/// Distances, in standard deviations, at which a parameter is held with which the force changes in jumps (chosen): what the
/// slopes know of it is too much.
const DISTANCES: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];

/// Coordinates at which a parameter that the data do not determine is held.
const FAR: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// The best point, with the others where straight lines expect them for a parameter at a coordinate.
fn along(problem: &Problem, best: &Found, trust: &Uncertainty, number: usize, coordinate: f64) -> Found {
    let mut moved = best.clone();
    moved.point[number] = coordinate.clamp(0.0, 1.0);
    let change = problem.values(&moved.point)[number] - problem.values(&best.point)[number];
    for other in (0..moved.point.len()).filter(|other| *other != number) {
        let [_, slope] = problem.parameters[other].value(best.point[other]);
        let expected = change * trust.follows(other, number) / slope.abs().max(f64::MIN_POSITIVE);
        moved.point[other] = (moved.point[other] + expected).clamp(0.0, 1.0);
    }
    moved
}

/// A point on the line from the best point to an end.
fn part_of_the_way(best: &Found, end: &Found, part: f64) -> Found {
    let point = best.point.iter().zip(&end.point);
    let point = point.map(|(best, end)| (best + part * (end - best)).clamp(0.0, 1.0)).collect();
    Found { point, ..best.clone() }
}

/// Part of its half width to which an end of an interval is found (chosen).
const NEAR: f64 = 0.02;

/// The distance, at most `most`, at which the rise reaches its limit. The rise is about a parabola.
fn crossing(mut rise: impl FnMut(f64) -> f64, first: f64, most: f64) -> f64 {
    let (mut inside, mut outside) = (0.0, None);
    let mut distance = first.min(most);
    for _ in 0..TRIALS {
        let found = rise(distance);
        if (found / RISE - 1.0).abs() < 2.0 * NEAR {
            return distance;
        }
        if found < RISE {
            inside = distance;
            if distance >= most {
                return most;
            }
        } else {
            outside = Some(distance);
        }
        // Where the force changes in jumps, no distance has that rise.
        if let Some(outside) = outside.filter(|outside| outside - inside < NEAR * outside) {
            return outside;
        }
        let guess = if found > 0.0 { distance * (RISE / found).sqrt() } else { 2.0 * distance };
        distance = match outside {
            Some(outside) if guess <= inside || guess >= outside => 0.5 * (inside + outside),
            Some(_) => guess,
            None => guess.clamp((1.0 + NEAR) * distance, 4.0 * distance).min(most),
        };
    }
    distance
}

/// Movement, in standard deviations and as a part of a large change, from which a parameter depends on another (chosen).
const MOVED: [f64; 2] = [3.0, 0.1];

/// Part of the rise at the end of an interval that a step of least squares on the way there need not gain (chosen).
const UNSEEN: f64 = 1e-2;

/// The best point with a parameter held at a coordinate, from a point on.
fn held(problem: &Problem, from: &Found, number: usize, coordinate: f64, gain: f64) -> Found {
    let mut pinned = problem.clone();
    pinned.pin(number, coordinate);
    let mut from = from.clone();
    from.point[number] = coordinate.clamp(0.0, 1.0);
    from.cost = f64::INFINITY;
    polish_until(&pinned, &from, gain)
}

/// Blocks of residuals from random places; a fit takes a part of the noise away.
fn noise(residuals: &[f64], parameters: usize, length: usize, random: &mut fastrand::Rng) -> Vec<f64> {
    let count = residuals.len();
    let freedom = count as f64 / (count - parameters.min(count - 1)) as f64;
    let length = length.clamp(1, count);
    let mut noise = Vec::with_capacity(count + length);
    while noise.len() < count {
        // A usize of 32 bits, as in a browser, would take other numbers.
        let from = random.u64(0..=(count - length) as u64) as usize;
        noise.extend(residuals[from..from + length].iter().map(|one| freedom.sqrt() * one));
    }
    noise
}

/// Interval that holds 95 % of values.
pub(super) fn quantiles(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let beyond = (0.025 * values.len() as f64) as usize;
    [values[beyond], values[values.len() - 1 - beyond]]
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::super::parameter::{Parameter, Target};
    use super::super::tests::{estimate, fitted, fitter, measured, quick, standard, white_noise, whole_problem};
    use super::super::uncertainty::{residuals, uncertainty};
    use super::super::{Experiment, Settings, Verdict};
    use super::*;

    /// Point of the start values of a law, but for some of them.
    fn point(problem: &Problem, others: &[(&str, f64)]) -> Vec<f64> {
        let start = |name: &str| problem.law.table.at(problem.law.find(name).unwrap()).start;
        let of = |parameter: &Parameter| {
            let usual = if let Target::Excess { .. } = parameter.target {
                start("mu_s") - start("mu_k")
            } else {
                start(&parameter.name)
            };
            parameter
                .coordinate(others.iter().find(|(name, _)| *name == parameter.name).map_or(usual, |(_, value)| *value))
        };
        problem.parameters.iter().map(of).collect()
    }

    fn polished(problem: &Problem, point: Vec<f64>) -> Found {
        polish(problem, &problem.judge(Found { point, cost: 0.0, evaluations: 0 }))
    }

    /// Quantiles of 95 % of chi square from tables.
    #[test]
    fn the_joint_rise_is_that_of_tables() {
        for (parameters, quantile) in [(1, 3.841), (2, 5.991), (4, 9.488), (7, 14.067)] {
            assert!((joint_rise(parameters) / quantile - 1.0).abs() < 0.03, "{parameters} {}", joint_rise(parameters));
        }
    }

    /// One and one of forty lie beyond the ends.
    #[test]
    fn as_many_values_lie_beyond_both_ends() {
        let values: Vec<f64> = (0..40).map(f64::from).collect();
        assert_eq!(quantiles(values), [1.0, 38.0]);
        assert_eq!(quantiles(vec![2.0]), [2.0; 2]);
    }

    /// Noise with rare large values above the predicted force: the level is repeated with the same skewness.
    #[test]
    fn repetitions_have_noise_like_that_of_the_measured_force() {
        let even = standard(600);
        let sliding = Experiment { velocity: vec![0.01; 600], normal_force: vec![20.0; 600], ..even };
        let clean = measured("Coulomb", &[], &sliding, 0.0, 1);
        let force =
            clean.force.iter().enumerate().map(|(at, f)| if at % 40 == 7 { f + 3.9 } else { f - 0.1 }).collect();
        let data = [Experiment { force, ..clean }];
        let problem = whole_problem("Coulomb", &data);
        let best = polished(&problem, vec![problem.parameters[0].coordinate(0.1)]);
        let left = problem.residuals(&best.point).unwrap();
        let residuals = residuals(&left, &problem.lengths(), 1, problem.loss);
        let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
        let trust = uncertainty(&problem, &best.point, &residuals);
        let optimum = Optimum { problem: &problem, best: &best, residuals: &residuals, trust: &trust };
        let found = optimum.repetitions(400, 5, watch);
        let levels: Vec<f64> = found.iter().map(|point| problem.values(point)[0]).collect();
        let mean = levels.iter().sum::<f64>() / 400.0;
        let skewness: f64 = levels.iter().map(|one| (one - mean).powi(3)).sum();
        assert!(skewness > 0.0, "{skewness}");
    }

    /// A residual sum that rises as a parabola or in stairs.
    #[test]
    fn an_end_is_found_near_a_given_rise() {
        let parabola = crossing(|distance| RISE * (distance / 3.0).powi(2), 1.0, 100.0);
        assert!((parabola / 3.0 - 1.0).abs() <= NEAR, "{parabola}");
        // A stair of 0.2 has no such rise; the limit is passed at 5.
        let mut calls = 0;
        let mut stairs = |distance: f64| {
            calls += 1;
            if distance < 5.0 { 0.1 * distance } else { 2.0 * RISE }
        };
        let end = crossing(&mut stairs, 1.0, 100.0);
        assert!((5.0..=5.0 * (1.0 + NEAR)).contains(&end) && calls < TRIALS, "{end} {calls}");
        assert_eq!(crossing(|_| 0.0, 1.0, 2.5), 2.5);
    }

    /// Best at 0.1, as good at 0.2 with half the width left, worse at 0.3.
    #[test]
    fn an_interval_covers_places_within_the_rise() {
        let data = [measured("Coulomb", &[], &standard(400), 0.01, 1)];
        let problem = whole_problem("Coulomb", &data);
        let at = |value: f64| Found { point: vec![problem.parameters[0].coordinate(value)], cost: 0.0, evaluations: 0 };
        let residuals = white_noise(0.02);
        let mut trust = uncertainty(&problem, &at(0.1).point, &residuals);
        let others = [(0.2, 0.75 * RISE), (0.3, 1.01 * RISE)];
        trust.alternatives = others.map(|(value, rise)| Alternative { number: 0, end: at(value), rise }).into();
        let optimum = Optimum { problem: &problem, best: &at(0.1), residuals: &residuals, trust: &trust };
        let [low, high] = optimum.covering(|values| values[0], [0.01, 0.02]);
        assert!((low - 0.09).abs() < 1e-12 && (high - 0.21).abs() < 1e-12, "{low} {high}");
    }

    /// Coarse samples of a fast relaxation: whole intervals are far off, and yet they give the same ends.
    #[test]
    fn intervals_that_are_not_divided_give_the_same_ends() {
        let data = [measured("MaxwellSlip", &[], &standard(600), 0.01, 3)];
        let mut problem = whole_problem("MaxwellSlip", &data);
        problem.parts = 8;
        let best = polished(&problem, point(&problem, &[]));
        let left = problem.residuals(&best.point).unwrap();
        let residuals = residuals(&left, &problem.lengths(), problem.parameters.len(), problem.loss);
        let trust = fitter(&problem).trust(&best, &residuals, false);
        let quick = problem.undivided(&best.point).unwrap();
        let coarse = Problem { parts: 1, ..problem.clone() }.judge(best.clone());
        let number = problem.parameters.iter().position(|one| one.name == "sigma_0").unwrap();
        assert!(2.0 * (coarse.cost - best.cost) / residuals.rise() > RISE, "{} {}", coarse.cost, best.cost);
        let [whole, quick] = [&problem, &quick].map(|problem| {
            let best = problem.judge(best.clone());
            Optimum { problem, best: &best, residuals: &residuals, trust: &trust }.profile(number)
        });
        let width = whole[1] - whole[0];
        assert!(whole.iter().zip(quick).all(|(a, b)| (a - b).abs() < 0.03 * width), "{whole:?} {quick:?}");
    }

    /// Friction that has almost fallen where the motion is slowest: a fall at a speed that does not occur explains the
    /// force almost as well, and noise would decide between them.
    #[test]
    fn an_effect_that_noise_may_feign_is_not_told() {
        let even = standard(400);
        let fast = |v: &f64| v + 0.1_f64.copysign(*v);
        let sliding = Experiment { velocity: even.velocity.iter().map(fast).collect(), ..even };
        for seed in [0, 2] {
            let data = measured("Stribeck", &[("stribeck_velocity", 0.06)], &sliding, 0.01, seed);
            let fit = fitted("Stribeck", &[data], &Settings { profiles: true, ..quick() });
            let verdict = estimate(&fit, "stribeck_velocity").verdict.to_string();
            assert!(verdict.ends_with("an end of its range, the force is predicted almost as well"), "{verdict}");
        }
    }

    /// A curve without transition behind a stiff spring is the best of all points around it, and far from the truth.
    #[test]
    fn a_place_that_explains_more_is_found_elsewhere() {
        let data = [measured("SpeckerDynamic", &[], &standard(2000), 0.01, 3)];
        let problem = whole_problem("SpeckerDynamic", &data);
        let [truth, other] = [&[][..], &[("transition_velocity", 3e-6), ("sigma_0", 7e6)]]
            .map(|others| polished(&problem, point(&problem, others)));
        let judged = |best: &Found| fitter(&problem).judge(best).unwrap();
        let wrong = judged(&other);
        assert!(other.cost - truth.cost > 10.0 * wrong.residuals.rise(), "{} {}", other.cost, truth.cost);
        let found = polish(&problem, wrong.better(&other).unwrap());
        assert!((found.cost / truth.cost - 1.0).abs() < 1e-6, "{} {}", found.cost, truth.cost);
        assert!(judged(&truth).better(&truth).is_none());
    }

    /// Short rests tell the rise of the static level and its time only by their ratio: values a hundred times as large
    /// explain the force as well.
    #[test]
    fn what_the_data_tell_by_a_ratio_only_is_not_determined() {
        let data = [measured("Armstrong", &[], &standard(2000), 0.01, 4)];
        let problem = whole_problem("Armstrong", &data);
        let best = polished(&problem, point(&problem, &[("gamma", 0.03), ("mu_s - mu_k", 0.0015)]));
        let judged = fitter(&problem).judge(&best).unwrap();
        let number = |name: &str| problem.parameters.iter().position(|one| one.name == name).unwrap();
        let [excess, gamma] = ["mu_s - mu_k", "gamma"].map(number);
        assert!(!judged.trust.verdicts[excess].is_informative(), "{:?}", judged.trust.verdicts);
        let most = judged.trust.alternatives.iter().map(|other| problem.values(&other.end.point)[excess]);
        let most = most.fold(0.0, f64::max);
        assert!(most > 10.0 * problem.values(&best.point)[excess], "{most} {:?}", problem.values(&best.point));
        assert!(!judged.trust.verdicts[gamma].is_informative());
        // Where the time is a little longer than the rests, slopes alone show it.
        let slopes =
            uncertainty(&problem, &point(&problem, &[("gamma", 0.03), ("mu_s - mu_k", 0.0015)]), &judged.residuals);
        let reason = slopes.verdicts[excess].to_string();
        assert!(reason.contains("only in combination with"), "{reason}");
    }

    /// Viscous friction ends at 0, where the steps of the others end with it: a scan of one of them goes on.
    #[test]
    fn an_end_of_a_range_does_not_stop_the_others() {
        let data = [measured("Armstrong", &[], &standard(2000), 0.01, 4)];
        let problem = whole_problem("Armstrong", &data);
        let best = polished(&problem, point(&problem, &[("gamma", 0.03), ("mu_s - mu_k", 0.0015)]));
        let residuals = white_noise(0.02);
        let trust = uncertainty(&problem, &best.point, &residuals);
        let optimum = Optimum { problem: &problem, best: &best, residuals: &residuals, trust: &trust };
        let number = |name: &str| problem.parameters.iter().position(|one| one.name == name).unwrap();
        let [gamma, excess] = ["gamma", "mu_s - mu_k"].map(number);
        let mut start = best.clone();
        start.point[gamma] = problem.parameters[gamma].coordinate(0.3);
        start.point[number("viscous_coefficient")] = 0.0;
        let scan = |part: u32| {
            let mut moved = start.clone();
            moved.point[excess] = problem.parameters[excess].coordinate(1e-3 * f64::from(part));
            problem.judge(moved).cost
        };
        let least = (1..50).map(scan).fold(f64::INFINITY, f64::min);
        let end = held(&problem, &start, gamma, start.point[gamma], optimum.gain());
        assert!(end.cost <= least, "{} {least}", end.cost);
    }

    /// The bond of ResetIntegrator breaks between two samples: its stiffness moves the force in jumps, and the damping is
    /// known only as far as the stiffness is.
    #[test]
    fn an_interval_covers_what_explains_the_force_as_well_nearby() {
        let data = [measured("ResetIntegrator", &[], &standard(2000), 0.01, 2)];
        let fit = fitted("ResetIntegrator", &data, &Settings { profiles: true, ..quick() });
        assert!(
            estimate(&fit, "sigma_0").verdict.to_string().contains("in jumps"),
            "{:?}",
            estimate(&fit, "sigma_0").verdict
        );
        let damping = estimate(&fit, "sigma_1");
        assert_eq!(damping.verdict, Verdict::Determined);
        let [low, high] = damping.interval();
        // Other pairs of both on a grid, with the levels at their best values: a part of the joint region.
        let problem = whole_problem("ResetIntegrator", &data);
        let column = |name: &str| problem.law.find(name).unwrap();
        let cost = |stiffness: f64, damping: f64| {
            let mut columns = fit.physical.columns.clone();
            columns.push((column("sigma_0"), stiffness));
            columns.push((column("sigma_1"), damping));
            let mut instance = stribeck::instance::Instance::new(problem.law);
            let forces = super::super::response::forces(&mut instance, &problem.ports, &columns, &data[0], fit.parts);
            forces.unwrap().iter().zip(&data[0].force).map(|(a, b)| (a - b).powi(2)).sum::<f64>()
        };
        let stiffness = estimate(&fit, "sigma_0").value;
        let (least, variance) = (cost(stiffness, damping.value), fit.residuals.variance());
        let mut reached = [damping.value; 2];
        for part in -30..=30 {
            for other in 0..=60 {
                let [stiffness, damping] = [stiffness * (1.0 + 5e-4 * f64::from(part)), 200.0 + 4.0 * f64::from(other)];
                if cost(stiffness, damping) - least < 0.5 * RISE * variance {
                    reached = [reached[0].min(damping), reached[1].max(damping)];
                }
            }
        }
        assert!(reached[1] - reached[0] > 4.0, "{reached:?}");
        assert!(low <= reached[0] && reached[1] <= high, "{low} {high} {reached:?}");
    }
}
