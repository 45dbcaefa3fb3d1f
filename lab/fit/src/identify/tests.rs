//! Fits to data of known laws.

use std::f64::consts::TAU;
use std::slice;
use std::sync::atomic::AtomicBool;

use approx::assert_abs_diff_eq;
use stribeck::catalogue::by_name;

use super::*;

static NEVER: AtomicBool = AtomicBool::new(false);

pub(super) fn quiet() -> Watch<'static> {
    Watch { cancel: &NEVER, progress: &|_, _| {} }
}

/// Strokes with slow and fast reversals under a load that changes, over 4 s at 1 kHz.
pub(super) fn standard(samples: u32) -> Experiment {
    let time: Vec<f64> = (0..samples).map(|k| f64::from(k) / f64::from(samples) * 4.0).collect();
    let wave = |amplitude: f64, frequency: f64, t: f64| amplitude * (TAU * frequency * t).sin();
    let velocity = |t: f64| wave(0.02, 0.5, t) + wave(0.004, 3.7, t) + wave(0.001, 11.0, t);
    let slope = |t: f64| (velocity(t + 1e-6) - velocity(t - 1e-6)) / 2e-6;
    Experiment {
        name: "standard".into(),
        velocity: time.iter().map(|t| velocity(*t)).collect(),
        acceleration: time.iter().map(|t| slope(*t)).collect(),
        normal_force: time.iter().map(|t| 20.0 + wave(5.0, 0.3, *t)).collect(),
        force: vec![0.0; time.len()],
        time,
        ..Experiment::default()
    }
}

/// Numbers of the normal distribution.
pub(super) fn noise(seed: u64, count: usize) -> Vec<f64> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut one = || (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (TAU * random.f64()).cos();
    (0..count).map(|_| one()).collect()
}

/// The experiment with the force of a law and noise of a part of the largest force.
pub(super) fn measured(law: &str, values: &[(&str, f64)], experiment: &Experiment, part: f64, seed: u64) -> Experiment {
    let law = by_name(law).unwrap();
    let columns: Vec<(usize, f64)> = values.iter().map(|(name, value)| (law.find(name).unwrap(), *value)).collect();
    let mut instance = Instance::new(law);
    let forces = response::forces(&mut instance, &Ports::of(law).unwrap(), &columns, experiment, 8).unwrap();
    let level = forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    let noise = noise(seed, forces.len());
    let force = forces.iter().zip(noise).map(|(force, noise)| force + part * level * noise).collect();
    Experiment { force, ..experiment.clone() }
}

pub(super) fn white_noise(rms: f64) -> Residuals {
    Residuals { rms, loss: rms, noise: rms, softness: 1.0, neighbours: 0.0, correlation: 1.0, student: 1.0 }
}

pub(super) fn quick() -> Settings {
    Settings { budget: 1500, profiles: false, repetitions: 0, ..Settings::default() }
}

pub(super) fn fitted(law: &str, experiments: &[Experiment], task: &Settings) -> Fit {
    fit(by_name(law).unwrap(), experiments, task, quiet()).unwrap()
}

pub(super) fn estimate<'a>(fit: &'a Fit, name: &str) -> &'a Estimate {
    fit.estimates.iter().find(|one| one.name == name).unwrap()
}

fn is_undetermined(fit: &Fit, name: &str) -> bool {
    matches!(estimate(fit, name).verdict, Verdict::Undetermined(_))
}

pub(super) fn whole_problem<'a>(law: &str, experiments: &'a [Experiment]) -> Problem<'a> {
    problem(by_name(law).unwrap(), experiments, &Settings::default()).unwrap()
}

pub(super) fn fitter<'a>(problem: &Problem<'a>) -> Fitter<'a> {
    let (problem, task) = (problem.clone(), Box::leak(Box::default()));
    Fitter { problem, task, watch: quiet(), searches: Searches::Agree, ends: Vec::new() }
}

/// Truth of reference data: a slider of 20 N.
pub(super) const SLIDER: [(&str, f64); 6] = [
    ("mu_k", 0.21),
    ("mu_s", 0.28),
    ("sigma_0", 2e4),
    ("sigma_1", 60.0),
    ("viscous_coefficient", 4.0),
    ("stribeck_velocity", 0.004),
];

/// Dual numbers give the bits of the instance and, for every law that has them, the slopes of its differences.
#[test]
fn sensitivities_are_those_of_differences() {
    let mut exact_laws = 0;
    for law in laws() {
        let experiments = [measured(law.name, &[], &standard(400), 0.0, 1)];
        let problem = whole_problem(law.name, &experiments);
        let Some(exact) = problem.exact else { continue };
        exact_laws += 1;
        let mut random = fastrand::Rng::with_seed(5);
        let coordinate = || 0.3 + 0.4 * random.f64();
        let point: Vec<f64> = std::iter::repeat_with(coordinate).take(problem.parameters.len()).collect();
        let mut instance = Instance::new(law);
        let physical = problem.physical(&point);
        let Ok(values) = problem.predicted(&mut instance, &physical, 1) else { continue };
        instance.reset();
        instance.set_all(stribeck::instance::Phase::Setup, physical.columns.into_iter()).unwrap();
        let duals = exact.forces(instance.row(), &problem.ports, &[], &experiments[0], 1);
        assert!(duals.iter().zip(&values).all(|(dual, value)| dual.value == *value), "{}", law.name);
        for (number, exactly) in problem.sensitivities(&point).into_iter().enumerate() {
            let differences = problem.differences(&point, number, 1e-6);
            let size = |values: &[f64]| values.iter().map(|one| one * one).sum::<f64>().sqrt();
            let apart: Vec<f64> = exactly.iter().zip(&differences).map(|(a, b)| a - b).collect();
            let part = size(&apart) / size(&exactly).max(1e-6 * size(&values));
            assert!(
                part < 1e-3,
                "{} {}: {part} {:?}",
                law.name,
                problem.parameters[number].name,
                (size(&exactly), size(&values), size(&apart), size(&differences))
            );
        }
    }
    assert!(exact_laws >= 20, "{exact_laws}");
}

#[test]
fn a_law_is_found_again_with_intervals_three_ways() {
    let data = [measured("LuGre", &SLIDER, &standard(1000), 0.01, 11)];
    let fit = fitted("LuGre", &data, &Settings { profiles: true, repetitions: 20, ..quick() });
    assert!(fit.searches == Searches::Agree && fit.is_exact && fit.warnings.is_empty(), "{:?}", fit.warnings);
    assert!((fit.residuals.rms / (0.01 * fit.level) - 1.0).abs() < 0.1, "{:?}", fit.residuals);
    for (name, truth) in SLIDER {
        let one = estimate(&fit, name);
        assert_eq!(one.verdict, Verdict::Determined, "{name}");
        assert!((one.value - truth).abs() < 3.0 * one.deviation, "{name}: {one:?}");
        let width = |[low, high]: [f64; 2]| high - low;
        let linear = width(one.linear);
        if let Some(profile) = one.profile {
            assert!((0.85..1.2).contains(&(width(profile) / linear)), "{name}: {one:?}");
        }
        let repeated = one.repeated.unwrap();
        assert!((0.4..1.7).contains(&(width(repeated) / linear)), "{name}: {one:?}");
    }
    assert!(fit.estimates.iter().filter(|one| one.profile.is_some()).count() >= 6);
}

/// In 60 repetitions of an interval that holds in 95 %, fewer than 52 hits happen once in a thousand times.
#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let experiment = standard(500);
    let mut hits = [0; 2];
    for seed in 0..60 {
        let data = [measured("Dahl", &[], &experiment, 0.01, 100 + seed)];
        let fit = fitted("Dahl", &data, &Settings { budget: 200, ..quick() });
        for (hits, (name, truth)) in hits.iter_mut().zip([("mu_k", 0.1), ("sigma_0", 1e5)]) {
            let [low, high] = estimate(&fit, name).linear;
            *hits += i32::from((low..=high).contains(&truth));
        }
    }
    assert!(hits.iter().all(|hits| *hits >= 52), "{hits:?}");
}

/// Steady sliding at 10 v_S: f = mu_k f_n + sigma_2 v, the rest of the Stribeck curve being exp(-100); at rest 0.
#[test]
fn a_record_that_begins_in_motion_begins_in_steady_sliding() {
    let constant = |value| vec![value; 10];
    let moving = Experiment { velocity: constant(0.04), normal_force: constant(20.0), ..standard(10) };
    let first = measured("LuGre", &SLIDER, &moving, 0.0, 1).force[0];
    assert!((first - (0.21 * 20.0 + 4.0 * 0.04)).abs() < 1e-12, "{first}");
    let resting = Experiment { velocity: [vec![0.0], vec![0.04; 9]].concat(), ..moving };
    assert_eq!(measured("LuGre", &SLIDER, &resting, 0.0, 1).force[0], 0.0);
}

#[test]
fn steady_sliding_tells_nothing_about_bristles() {
    let constant = |value| vec![value; 500];
    let steady = Experiment { velocity: constant(0.01), normal_force: constant(20.0), ..standard(500) };
    let data = [measured("LuGre", &SLIDER, &steady, 0.01, 1)];
    let fit = fitted("LuGre", &data, &quick());
    for name in ["sigma_0", "sigma_1", "stribeck_velocity", "mu_s - mu_k", "mu_s"] {
        assert!(is_undetermined(&fit, name), "{name}: {:?}", estimate(&fit, name));
    }
}

#[test]
fn a_level_not_told_from_zero_has_an_upper_limit_only() {
    let data = [measured("CoulombViscous", &[("viscous_coefficient", 0.0)], &standard(500), 0.01, 1)];
    let fit = fitted("CoulombViscous", &data, &Settings { budget: 400, ..quick() });
    let Verdict::AtMost(most) = estimate(&fit, "viscous_coefficient").verdict else { panic!("{:?}", fit.estimates) };
    // A tenth of the force at the highest speed, 0.025 m/s, is 10 N s/m.
    assert!((0.0..5.0).contains(&most), "{most}");
    assert_eq!(fit.undetermined().collect::<Vec<&str>>(), ["viscous_coefficient"]);
    assert!(fit.values().iter().all(|(name, _)| name != "viscous_coefficient"));
}

#[test]
fn one_load_tells_nothing_about_the_influence_of_the_load() {
    let truth = [("transition_normal_force", 30.0), ("viscous_coefficient", 50.0)];
    let held = Experiment { normal_force: vec![20.0; 2000], ..standard(2000) };
    let alone = [measured("BrownMcPhee", &truth, &held, 0.002, 1)];
    let one = fitted("BrownMcPhee", &alone, &Settings { profiles: true, ..quick() });
    let is_informative = ["transition_normal_force", "viscous_coefficient"].map(|name| !is_undetermined(&one, name));
    assert_eq!(is_informative, [false; 2], "{:?}", one.estimates);
    let other = Experiment { normal_force: vec![5.0; 2000], ..held.clone() };
    let both = [&held, &other].map(|load| measured("BrownMcPhee", &truth, load, 0.002, 2));
    let two = fitted("BrownMcPhee", &both, &quick());
    for (name, truth) in truth {
        let found = estimate(&two, name);
        assert!(found.verdict == Verdict::Determined && (found.value / truth - 1.0).abs() < 0.1, "{found:?}");
    }
}

/// Two parameters of which the data know only a sum: on the line x_1 = 0.3 x_0, with ten units of each admitted.
#[test]
fn what_depends_on_the_undetermined_is_not_determined() {
    let along = nalgebra::DVector::from_vec(vec![300.0, -1000.0, 0.0]);
    let mut information = &along * along.transpose();
    information[(2, 2)] = 1e3;
    let known = uncertainty::spread(&information, &|_| false);
    let deviation = |number: usize| known[(number, number)].sqrt();
    let first = 1.0 / (0.01 + 0.09 * 0.01f64).sqrt();
    assert!((deviation(0) - first).abs() < 1e-2 && (deviation(1) - 0.3 * first).abs() < 1e-2, "{known}");
    assert_abs_diff_eq!(deviation(2), 1.0 / 1001f64.sqrt(), epsilon = 1e-12);
}

/// r_k = 0.8 r_(k-1) + noise has the correlation time (1 + 0.8) / (1 - 0.8) = 9 samples; white noise has one.
#[test]
fn correlated_residuals_count_as_fewer_samples() {
    let white = noise(3, 40_000);
    let mut last = 0.0;
    let red: Vec<f64> = white
        .iter()
        .map(|one| {
            last = 0.8 * last + one;
            last
        })
        .collect();
    let seen = |values: &[f64]| uncertainty::residuals(values, &[20_000, 20_000], 2, Loss::SQUARES);
    assert!((seen(&white).correlation - 1.0).abs() < 0.1 && seen(&white).neighbours.abs() < 0.02);
    assert!((seen(&red).correlation / 9.0 - 1.0).abs() < 0.15, "{:?}", seen(&red));
    assert!((seen(&red).neighbours - 0.8).abs() < 0.01 && (seen(&white).rms - 1.0).abs() < 0.02);
    // The intervals grow with the root of it.
    let data = [measured("Dahl", &[], &standard(500), 0.01, 6)];
    let problem = whole_problem("Dahl", &data);
    let best = best(&problem, &quick(), quiet(), First::default()).found;
    let plain = white_noise(0.02);
    let [narrow, wide] =
        [plain, Residuals { correlation: 9.0, ..plain }].map(|seen| uncertainty(&problem, &best.point, &seen));
    for (narrow, wide) in narrow.standard_deviations.iter().zip(&wide.standard_deviations) {
        assert!((wide / narrow - 3.0).abs() < 0.01, "{narrow} {wide}");
    }
}

/// The bonds of Bristle snap one by one: the force changes with its parameters in jumps, which no slope foresees.
#[test]
fn a_force_that_changes_in_jumps_has_no_interval() {
    let data = [measured("Bristle", &[], &standard(500), 0.0, 1)];
    let problem = whole_problem("Bristle", &data);
    let point = vec![0.5; problem.parameters.len()];
    let seen = white_noise(1e-4);
    let jumps =
        uncertainty(&problem, &point, &seen).verdicts.iter().any(|verdict| verdict.to_string().contains("in jumps"));
    assert!(jumps, "{:?}", uncertainty(&problem, &point, &seen).verdicts);
    let smooth = [measured("Dahl", &[], &standard(500), 0.0, 1)];
    let problem = whole_problem("Dahl", &smooth);
    let verdicts = uncertainty(&problem, &[0.25, 0.6], &seen).verdicts;
    assert!(verdicts.iter().all(|verdict| *verdict == Verdict::Determined), "{verdicts:?}");
}

/// The slope of Coulomb friction has the sign of the velocity; read backwards it has the other one, and the same size.
#[test]
fn a_force_that_changes_elsewhere_than_foreseen_is_not_smooth() {
    let data = [measured("Coulomb", &[], &standard(400), 0.01, 1)];
    let problem = whole_problem("Coulomb", &data);
    let mut slopes = problem.sensitivities(&[0.5]).remove(0);
    let is_smooth = |slopes: &[f64]| uncertainty::is_smooth(&problem, &[0.5], 0.01, 0, 0.01, slopes);
    assert!(is_smooth(&slopes));
    slopes.reverse();
    assert!(!is_smooth(&slopes));
}

#[test]
fn searches_that_disagree_leave_no_number() {
    let data = [measured("Dahl", &[], &standard(1000), 0.01, 1)];
    let problem = whole_problem("Dahl", &data);
    let found = best(&problem, &quick(), quiet(), First::default()).found;
    let verdicts = |searches, ends: &[Vec<f64>]| {
        Fitter { searches, ends: ends.to_vec(), ..fitter(&problem) }.trust(&found, &white_noise(0.02), false).verdicts
    };
    let judged = verdicts(Searches::Agree, &[found.point.clone(), found.point.clone()]);
    assert!(judged.iter().all(|verdict| *verdict == Verdict::Determined), "{judged:?}");
    // Alike in cost, but elsewhere in the stiffness.
    let mut elsewhere = found.point.clone();
    elsewhere[1] += 0.1;
    let judged = verdicts(Searches::Agree, &[found.point.clone(), elsewhere]);
    assert!(judged[0] == Verdict::Determined && matches!(judged[1], Verdict::Undetermined(_)), "{judged:?}");
    assert!(verdicts(Searches::Disagree, &[]).iter().all(|verdict| matches!(verdict, Verdict::Undetermined(_))));
}

/// 110 instead of 100: 10 % of the reference, 10 / 105 of the mean.
#[test]
fn differences_have_both_definitions() {
    let found = difference(110.0, 100.0);
    assert!((found.to_reference - 10.0).abs() < 1e-12 && (found.to_mean - 1000.0 / 105.0).abs() < 1e-12, "{found:?}");
}

#[test]
fn a_start_at_an_end_of_the_range_does_not_stop_the_search() {
    let data = [measured("LuGre", &SLIDER, &standard(1000), 0.01, 4)];
    let problem = whole_problem("LuGre", &data);
    let floor = problem.judge(best(&problem, &quick(), quiet(), First::default()).found).cost;
    let count = problem.parameters.len();
    for ends in [vec![0.0; count], vec![1.0; count]] {
        let start = problem.judge(Found { point: ends, cost: 0.0, evaluations: 0 });
        let end = polish(&problem, &start);
        assert!(end.cost < 0.5 * start.cost, "{} of {}", end.cost, start.cost);
        assert!(end.cost >= 0.999 * floor);
    }
}

/// M a = F - f - offset with the published values of the EMPS drive (Janot, Gautier, Brunot 2019): 95.1089 kg,
/// 203.5034 N s/m, 20.3935 N, offset -3.1648 N.
#[test]
fn the_law_that_made_the_data_ranks_first_or_is_tied() {
    let candidates = ["Coulomb", "Stribeck", "Dahl", "LuGre"];
    for truth in ["Coulomb", "Stribeck", "LuGre"] {
        let values: &[(&str, f64)] = if truth == "LuGre" { &SLIDER } else { &[] };
        let data = [measured(truth, values, &standard(600), 0.01, 9)];
        let fits: Vec<Fit> =
            candidates.iter().map(|law| fitted(law, &data, &Settings { budget: 800, ..quick() })).collect();
        let ranks = rank(&fits);
        let own = ranks.iter().find(|rank| fits[rank.fit].law.name == truth).unwrap();
        assert!(own.is_tied, "{truth}: {ranks:?}");
        if truth == "LuGre" {
            assert!(ranks[1].delta_bic > APART, "{ranks:?}");
        }
        if truth == "Coulomb" {
            // Stribeck's law explains as much with four parameters more: 4 ln 600 = 26, less what they take of the noise.
            let more = ranks.iter().find(|rank| fits[rank.fit].law.name == "Stribeck").unwrap();
            assert!(ranks[0].fit == own.fit && (10.0..30.0).contains(&more.delta_bic), "{ranks:?}");
        }
    }
}

/// The records of the virtual rig follow slopes of the velocity; a fit leads the law through its samples. Where the
/// acceleration changes its sign, noise may take the other curve; without an acceleration, eight times the noise was left.
#[test]
fn laws_that_differ_as_the_contact_speeds_up_explain_their_own_records() {
    for law in ["NonReversible", "Wojewoda"] {
        let rig = crate::rig::VirtualRig {
            law: by_name(law).unwrap(),
            values: Vec::new(),
            mass: 2.0,
            normal_force: 20.0,
            duration: 2.0,
            faults: crate::rig::Faults::NOISE,
            seed: 1,
        };
        let known = stribeck_measured::Setup { mass: 2.0, normal_force: Some(20.0), ..Default::default() };
        let sheet = stribeck_sheet::Sheet::parse(&rig.record().unwrap().force).unwrap();
        let data = Experiment::new(law, &stribeck_measured::Record::of(&sheet, None, &known).unwrap());
        let fit = fitted(law, slice::from_ref(&data), &Settings { mass: 2.0, ..quick() });
        let noise = stribeck_measured::noise(&data.force);
        assert!(fit.residuals.rms < 3.0 * noise, "{law}: {} N, noise {noise} N", fit.residuals.rms);
    }
}

/// A record of friction in which the measured velocity has noise of 0.1 mm/s.
fn record_of_noisy_velocity(law: &str) -> Experiment {
    let clean = measured(law, &[], &standard(2000), 0.01, 1);
    let rows = clean.time.iter().zip(&clean.force).zip(&clean.normal_force).zip(&clean.velocity);
    let text = rows.zip(noise(2, 2000)).fold("time,force,normal_force,velocity\n".to_owned(), |text, (row, noise)| {
        let (((t, force), load), v) = row;
        text + &format!("{t},{force},{load},{}\n", v + 1e-4 * noise)
    });
    let sheet = stribeck_sheet::Sheet::parse(&text).unwrap();
    Experiment::new(law, &stribeck_measured::Record::of(&sheet, None, &stribeck_measured::Setup::default()).unwrap())
}

/// Some of 2000 samples have a velocity that may have either sign. With them, laws that are smooth there explain
/// Coulomb's friction far better than Coulomb's law.
#[test]
fn samples_of_unknown_direction_do_not_rank_laws() {
    let data = record_of_noisy_velocity("Coulomb");
    let inside = data.time.iter().zip(&data.left_out).filter(|(t, _)| (0.1..3.9).contains(*t));
    let count = inside.filter(|(_, is_left_out)| **is_left_out).count();
    assert!((3..60).contains(&count), "{count}");
    let all = Experiment { left_out: Vec::new(), rest: Rest::default(), ..data.clone() };
    let behind = |data: Experiment| {
        let task = Settings { budget: 600, ..quick() };
        let fits = ["Coulomb", "Threlfall"].map(|law| fitted(law, slice::from_ref(&data), &task));
        let ranks = rank(&fits);
        let own = ranks.iter().find(|one| one.fit == 0).unwrap();
        (own.delta_bic, own.is_tied)
    };
    let (with, without) = (behind(all), behind(data));
    assert!(with.0 > 100.0 && !with.1, "{with:?}");
    assert_eq!(without, (0.0, true));
}

/// Ten samples on a straight line through rest, none of them slow: the filter reaches across rest all the same.
#[test]
fn a_turn_between_two_samples_is_rest_for_a_filter() {
    let line: Vec<f64> = (0..10).map(|at| f64::from(at) - 4.5).collect();
    let moved = Experiment { time: line.clone(), velocity: line, reach: 1.6, ..standard(10) };
    let numbers = |found: Experiment| (0..10).filter(|at| !found.counts(*at)).collect::<Vec<usize>>();
    assert_eq!(numbers(moved.clone().without_rest(0.1).unwrap()), [3, 4, 5]);
    assert_eq!(numbers(Experiment { reach: 0.0, ..moved.clone() }.without_rest(0.6).unwrap()), [4, 5]);
    assert!(numbers(Experiment { reach: 0.0, ..moved.clone() }.without_rest(0.1).unwrap()).is_empty());
    // Nothing is at rest below 0 m/s, but the filter has samples on both sides from the second to the eighth only.
    assert!(numbers(moved.clone().without_rest(0.0).unwrap()).is_empty());
    let ends = [moved.time[1], moved.time[7]];
    assert_eq!(numbers(Experiment { ends: Some(ends), ..moved }.without_rest(0.0).unwrap()), [0, 8, 9]);
}

/// A motion that is known before and after the force has no ends there.
#[test]
fn only_samples_at_the_ends_of_the_motion_are_left_out() {
    let rows = |from: i32, to: i32, name: &str, of: &dyn Fn(f64) -> f64| {
        let row = |k: i32| format!("{},{}\n", f64::from(k) * 1e-3, of(f64::from(k) * 1e-3));
        format!("time,{name}\n") + &(from..to).map(row).collect::<String>()
    };
    let moved = |t: f64| 0.01 * (3.0 * t).sin();
    let force = rows(0, 2000, "force", &|t| 2.0 * (1e3 * (3.0 * t).cos()).tanh());
    let counted = |motion: String| {
        let [force, motion] = [&force, &motion].map(|text| stribeck_sheet::Sheet::parse(text).unwrap());
        let rig = stribeck_measured::Setup { normal_force: Some(20.0), window: Some(0.1), ..Default::default() };
        Experiment::new("rig", &stribeck_measured::Record::of(&force, Some(&motion), &rig).unwrap())
    };
    let [short, long] = [(0, 2000), (-100, 2100)].map(|(from, to)| counted(rows(from, to, "displacement", &moved)));
    assert!(!short.counts(49) && short.counts(51) && !short.counts(1951));
    assert!(long.counts(0) && long.counts(1999));
}

/// Criterion of two fits with k = 1: (n / tau) 2 ln(ratio of what is left).
#[test]
fn a_ranking_counts_effective_samples() {
    let data = [measured("Coulomb", &[], &standard(600), 0.01, 9)];
    let fit = fitted("Coulomb", &data, &Settings { budget: 50, ..quick() });
    let behind = |ratio: f64, correlation: f64| {
        let best = Fit { residuals: Residuals { correlation, ..white_noise(0.02) }, ..fit.clone() };
        let other = Fit { residuals: Residuals { loss: 0.02 * ratio, ..best.residuals }, ..fit.clone() };
        let ranks = rank(&[other, best]);
        assert_eq!((ranks[0].fit, ranks[0].delta_bic), (1, 0.0));
        (ranks[1].delta_bic, ranks[1].is_tied)
    };
    for (ratio, correlation, is_tied) in [(1.008, 1.0, true), (1.009, 1.0, false), (1.009, 2.0, true)] {
        let (found, tied) = behind(ratio, correlation);
        let expected = 600.0 / correlation * 2.0 * ratio.ln();
        assert!((found - expected).abs() < 1e-9 && tied == is_tied, "{found} instead of {expected}");
    }
}

/// The genetic algorithm with as many evaluations does not reach 1.02 of the noise.
#[test]
fn evolution_and_slopes_reach_the_noise_where_a_genetic_algorithm_does_not() {
    let data = [measured("LuGre", &SLIDER, &standard(1000), 0.01, 21)];
    let ours = fitted("LuGre", &data, &quick());
    let genetic =
        fitted("LuGre", &data, &Settings { method: Method::Genetic, budget: ours.evaluations / 2, ..quick() });
    let floor = 0.01 * ours.level;
    assert!(ours.residuals.rms < 1.05 * floor, "{} of {floor}", ours.residuals.rms);
    assert!(genetic.residuals.rms > 1.02 * ours.residuals.rms, "{:?}", genetic.residuals);
}

#[test]
fn a_velocity_that_is_known_too_badly_is_warned_of() {
    let data = measured("LuGre", &SLIDER, &standard(1000), 0.01, 2);
    let sharp = fitted("LuGre", std::slice::from_ref(&data), &quick());
    assert!(sharp.warnings.is_empty(), "{:?}", sharp.warnings);
    let smooth = fitted("LuGre", &[Experiment { velocity_error: 1e-4, ..data.clone() }], &quick());
    assert!(
        smooth.warnings.iter().any(|text| {
            text.contains("the static level is found too low") && text.contains("sigma_1 gets no number")
        }),
        "{:?}",
        smooth.warnings
    );
    let damping = [&sharp, &smooth].map(|fit| estimate(fit, "sigma_1").verdict.to_string());
    assert!(damping[0] == "determined" && damping[1].contains("not known well enough"), "{damping:?}");
    let fixed = Selection { fixed: vec![("stribeck_velocity".into(), 0.004)], ..Selection::default() };
    let held =
        fitted("LuGre", &[Experiment { velocity_error: 1e-4, ..data }], &Settings { selection: fixed, ..quick() });
    assert!(!estimate(&held, "sigma_1").verdict.is_informative(), "{:?}", held.estimates);
}

#[test]
fn impossible_wishes_are_refused() {
    let data = [measured("Dahl", &[], &standard(100), 0.01, 1)];
    let refusal = |law: &str, selection: Selection| {
        let task = Settings { selection, ..quick() };
        fit(by_name(law).unwrap(), &data, &task, quiet()).map(|_| ()).unwrap_err().to_string()
    };
    let fixed = |name: &str, value| Selection { fixed: vec![(name.into(), value)], ..Selection::default() };
    let range = |name: &str, ends| Selection { ranges: vec![(name.into(), ends)], ..Selection::default() };
    let none = Selection::default;
    let cases = [
        ("LuGrePlanar", none(), "LuGrePlanar: only laws of one sliding direction can be fitted"),
        ("Dahl", fixed("sigma", 1.0), "Dahl: parameter 'sigma' does not exist (did you mean 'sigma_0'?)"),
        ("Dahl", fixed("sigma_0", -1.0), "sigma_0 = -1: must be > 0 and finite"),
        ("Dahl", fixed("mass", f64::NAN), "mass = NaN: must be a finite number"),
        (
            "Dahl",
            Selection { fitted: vec!["mass".into()], ..fixed("mass", 3.0) },
            "mass = 3: is held, and to be fitted too",
        ),
        (
            "Dahl",
            Selection { fitted: vec!["mas".into()], ..none() },
            "parameter 'mas' does not exist (did you mean 'mass'?)",
        ),
        ("Dahl", range("mu_k", [0.2, 0.1]), "mu_k = 0.2:0.1: must be LOW:HIGH with LOW < HIGH, both finite"),
        ("Dahl", range("mu_k", [-0.2, 0.1]), "mu_k = -0.2:0.1: both must be >= 0 and finite"),
        ("Dahl", range("alpha", [0.5, 2.0]), "Dahl: alpha has a range and is not fitted"),
    ];
    for (law, selection, wanted) in cases {
        let found = refusal(law, selection);
        assert!(found.contains(wanted), "{found} instead of {wanted}");
    }
}

#[test]
fn experiments_and_tasks_without_sense_are_refused() {
    let data = [measured("Dahl", &[], &standard(100), 0.01, 1)];
    let spoilt = Experiment { force: vec![f64::NAN; 100], ..data[0].clone() };
    let refused = fit(by_name("Dahl").unwrap(), &[spoilt], &quick(), quiet()).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused, "standard: force[0] = NaN: must be finite");
    let still = Experiment { velocity: vec![0.0; 100], ..data[0].clone() };
    let bare = Experiment { normal_force: vec![0.0; 100], ..data[0].clone() };
    let tiny = Experiment { velocity: vec![1e-320; 100], ..data[0].clone() };
    for (experiment, wanted) in [
        (still, "standard: velocity is 0 throughout, so that no friction can be seen"),
        (bare, "standard: normal_force is 0 throughout, so that no friction can be seen"),
        (tiny, "Dahl: the data give no range for sigma_0"),
    ] {
        let refused = fit(by_name("Dahl").unwrap(), &[experiment], &quick(), quiet()).map(|_| ()).unwrap_err();
        assert!(refused.to_string().starts_with(wanted), "{refused}");
    }
    let resting = Experiment { left_out: vec![true; 100], ..data[0].clone() };
    let refused = fit(by_name("Coulomb").unwrap(), &[resting], &quick(), quiet()).map(|_| ()).unwrap_err();
    let wanted =
        "0 samples (100 of 100 are left out, at rest or at the ends) for 1 parameter of Coulomb; at least 3 are needed";
    assert_eq!(refused.to_string(), wanted);
    let refused = fit(by_name("Dahl").unwrap(), &[], &quick(), quiet()).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused, "no experiment was given");
    for (task, wanted) in [
        (Settings { budget: 0, ..quick() }, "budget = 0: must be at least 1 evaluation"),
        (Settings { mass: -1.0, ..quick() }, "mass = -1: must be >= 0 and finite"),
    ] {
        let refused = fit(by_name("Dahl").unwrap(), &data, &task, quiet()).map(|_| ()).unwrap_err().to_string();
        assert_eq!(refused, wanted);
    }
}

/// Eight samples of 1200, all at high speed, are half as large again: the viscous part is theirs. With the robust loss
/// it is that of the truth.
#[test]
fn a_value_that_a_few_samples_decide_has_no_number() {
    let mut data = measured("CoulombViscous", &[("viscous_coefficient", 20.0)], &standard(1200), 0.01, 4);
    let fastest = data.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let at: Vec<usize> = (0..1200).filter(|at| data.velocity[*at].abs() > 0.9 * fastest).step_by(10).take(8).collect();
    at.iter().for_each(|at| data.force[*at] *= 1.5);
    let plain = fitted("CoulombViscous", slice::from_ref(&data), &quick());
    let verdict = estimate(&plain, "viscous_coefficient").verdict.to_string();
    assert!(verdict.contains("8 of 1200 samples") && verdict.contains("robust loss"), "{verdict}");
    let robust = fitted("CoulombViscous", &[data], &Settings { is_robust: true, ..quick() });
    let [low, high] = estimate(&robust, "viscous_coefficient").interval();
    assert!(estimate(&robust, "viscous_coefficient").verdict == Verdict::Determined && low < 20.0 && 20.0 < high);
}

/// The others have all their searches, as if they were alone.
#[test]
fn a_law_that_is_far_behind_is_searched_once_and_has_no_number() {
    // So many samples are thinned for the searches.
    let data = [measured("Dahl", &[], &standard(4200), 0.01, 1)];
    let laws = laws_named(&["Coulomb".into(), "Dahl".into(), "LuGre".into()]).unwrap();
    let ranking = fit_all(&laws, &data, &quick(), &mut |_| {}, quiet()).unwrap();
    assert_eq!(ranking.best().law.name, "Dahl");
    let [far, _, close] = ["Coulomb", "Dahl", "LuGre"].map(|name| {
        let found = ranking.fits.iter().find(|fit| fit.law.name == name);
        found.unwrap()
    });
    assert!(far.searches == Searches::One && far.values().is_empty(), "{:?}", far.estimates);
    assert!(far.warnings.iter().all(|text| !text.contains("raise the budget")), "{:?}", far.warnings);
    for fit in [ranking.best(), close] {
        let alone = fitted(fit.law.name, &data, &quick());
        assert_eq!(fit.physical.columns, alone.physical.columns, "{}", fit.law.name);
        assert_eq!(fit.searches, alone.searches, "{}", fit.law.name);
    }
}

#[test]
fn a_law_that_cannot_be_fitted_does_not_stop_the_others() {
    let data = [measured("Dahl", &[], &standard(200), 0.01, 1)];
    let selection = Selection { fixed: vec![("sigma_0".into(), 1e5)], ..Selection::default() };
    let task = Settings { selection, ..quick() };
    let laws = laws_named(&["Coulomb".into(), "Dahl".into()]).unwrap();
    let mut begun = Vec::new();
    let ranking = fit_all(&laws, &data, &task, &mut |law| begun.push(law.name), quiet()).unwrap();
    // A first look at each, then each of them, then the best once more; which one begins first is left to the threads.
    begun.sort_unstable();
    assert_eq!(begun, ["Coulomb", "Coulomb", "Dahl", "Dahl", "Dahl"]);
    assert_eq!(ranking.best().law.name, "Dahl");
    assert_eq!(
        ranking.best().values(),
        [("sigma_0".to_owned(), 1e5), ("mu_k".to_owned(), ranking.best().estimates[0].value)]
    );
    // The other law does not have the parameter that is held.
    assert!(ranking.refused.is_empty(), "{:?}", ranking.refused);
    let none = fit_all(&laws[..1], &data, &task, &mut |_| {}, quiet()).map(|_| ()).unwrap_err();
    assert!(none.to_string().starts_with("Coulomb: parameter 'sigma_0' does not exist"), "{none}");
}

/// Without noise nothing but the division of the intervals is left.
#[test]
fn data_without_noise_give_the_truth() {
    let data = [measured("Dahl", &[], &standard(1000), 0.0, 1)];
    let fit = fitted("Dahl", &data, &Settings { profiles: true, repetitions: 3, budget: 400, ..quick() });
    for (name, truth) in [("mu_k", 0.1), ("sigma_0", 1e5)] {
        let one = estimate(&fit, name);
        assert!((one.value / truth - 1.0).abs() < 1e-3, "{one:?}");
        assert!(one.verdict == Verdict::Determined && one.interval().iter().all(|end| end.is_finite()), "{one:?}");
    }
}

/// One force in 25 is spoilt by 20 to 60 standard deviations to one side. With squares they pull the values away by far
/// more than the noise of the others allows; a robust loss finds the truth within its intervals, which are hardly wider
/// than without outliers.
#[test]
fn outliers_hardly_count_with_a_robust_loss() {
    let clean = measured("Dahl", &[], &standard(1000), 0.01, 5);
    let level = clean.force.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    let mut spoilt = clean.clone();
    for at in (7..1000).step_by(25) {
        spoilt.force[at] += 0.01 * level * (20.0 + (at % 41) as f64);
    }
    let task = Settings { budget: 400, profiles: true, ..quick() };
    let robust = Settings { is_robust: true, ..task.clone() };
    let [without, squares, robust] = [(&clean, &task), (&spoilt, &task), (&spoilt, &robust)]
        .map(|(data, task)| fitted("Dahl", std::slice::from_ref(data), task));
    for (name, truth) in [("mu_k", 0.1), ("sigma_0", 1e5)] {
        let one = estimate(&robust, name);
        let [low, high] = one.interval();
        assert!((low..=high).contains(&truth), "{one:?}");
        assert!(one.deviation < 1.5 * estimate(&without, name).deviation, "{one:?}");
        assert!(one.deviation < 0.4 * estimate(&squares, name).deviation, "{one:?}");
        let profile = one.profile.unwrap();
        let ratio = (profile[1] - profile[0]) / (one.linear[1] - one.linear[0]);
        assert!((0.8..1.25).contains(&ratio), "{one:?}");
    }
    // The mean of the outliers, 1.6 standard deviations of the noise, is far more than the noise of a mean.
    assert!(
        robust.residuals.noise < 1.5 * without.residuals.noise && robust.residuals.rms > 5.0 * robust.residuals.noise
    );
}

/// Three loads: in a run that was not fitted the law leaves the noise, and where mu is another one, its difference.
#[test]
fn experiments_that_were_not_fitted_judge_a_law() {
    let loads = [10.0, 20.0, 30.0].map(|load| Experiment { normal_force: vec![load; 600], ..standard(600) });
    let data = loads.clone().map(|load| measured("Coulomb", &[("mu_k", 0.2)], &load, 0.0, 7));
    let spread = noise(12, 1800);
    let noisy = |number: usize| {
        let own = &spread[600 * number..];
        let force = data[number].force.iter().zip(own).map(|(force, noise)| force + 0.05 * noise).collect();
        Experiment { name: format!("run {number}"), force, ..data[number].clone() }
    };
    let data = [0, 1, 2].map(noisy);
    let task = Settings { folds: 3, budget: 100, ..quick() };
    let fit = fitted("Coulomb", &data, &task);
    assert_eq!(fit.validation.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["run 0", "run 1", "run 2"]);
    assert!(
        fit.validation.iter().all(|one| (one.rms / 0.05 - 1.0).abs() < 0.1 && !one.is_worse()),
        "{:?}",
        fit.validation
    );
    assert!(fit.warnings.is_empty(), "{:?}", fit.warnings);
    let other = measured("Coulomb", &[("mu_k", 0.3)], &loads[1], 0.0, 7);
    let validation = held_out(&fit, &[other]).unwrap();
    // Off by 0.1 of 20 N.
    assert!((validation[0].rms - 2.0).abs() < 0.02 && validation[0].is_worse(), "{validation:?}");
    // Before anything is fitted.
    let watch = Watch { cancel: &NEVER, progress: &|_, _| panic!("a search has begun") };
    let refused = super::fit(by_name("Coulomb").unwrap(), &data, &Settings { folds: 4, ..task }, watch);
    let text = refused.map(|_| ()).unwrap_err().to_string();
    assert_eq!(text, "folds = 4: must be from 2 to the number of records, 3");
}
