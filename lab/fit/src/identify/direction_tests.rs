//! Friction that differs by direction, in joints of a simulator of their own.

use stribeck_solve::job::Entry;

use super::joint_tests::{INERTIA, JOINT, Joint, SI, Text, asked, assert_told, fitted, text};
use super::tests::{estimate, measured, quick, quiet, standard};
use super::*;

const LAW: &str = "DirectionalStribeck";
const VISCOUS: [f64; 2] = [0.56, 0.48];

/// Viscous friction by direction, and one level.
const VISCOUS_JOINT: Joint =
    Joint { viscous: VISCOUS[0], offset: 0.012, backward: [0.0, VISCOUS[1] - VISCOUS[0]], ..JOINT };

/// The same with a level of 0.95 N m backward.
const UNEVEN_JOINT: Joint = Joint { backward: [0.05, VISCOUS[1] - VISCOUS[0]], ..VISCOUS_JOINT };

fn record(joint: Joint, seed: u64) -> Text {
    text(SI, &joint.record(seed), [1.0; 3])
}

fn ties(pairs: &[[&str; 2]]) -> Vec<Entry<String>> {
    pairs.iter().map(|[name, other]| Entry((*name).to_owned(), (*other).to_owned())).collect()
}

fn with(tie: Vec<Entry<String>>) -> Inquiry {
    Inquiry { law: vec![LAW.to_owned()], tie, ..asked() }
}

/// One level for everything.
fn one_level() -> Inquiry {
    let others = ["mu_k_backward", "mu_s_forward", "mu_s_backward"];
    with(ties(&others.map(|name| [name, "mu_k_forward"])))
}

/// No static friction, and a level of each direction.
fn two_levels() -> Inquiry {
    with(ties(&[["mu_s_forward", "mu_k_forward"], ["mu_s_backward", "mu_k_backward"]]))
}

#[test]
fn viscous_friction_by_direction_and_the_offset_of_one_level_are_found() {
    let truth = [
        ("mu_k_forward", 0.9),
        ("viscous_coefficient_forward", VISCOUS[0]),
        ("viscous_coefficient_backward", VISCOUS[1]),
        ("offset", 0.012),
        ("mass", INERTIA),
    ];
    let (mut held, mut count) = (0, 0);
    for seed in 20..24 {
        let record = record(VISCOUS_JOINT, seed);
        let (_, fit) = fitted(&one_level(), &record);
        for (name, truth) in truth {
            let one = estimate(&fit, name);
            let [low, high] = one.interval();
            assert!(one.verdict == Verdict::Determined && high - low < 0.02, "{one:?}");
            held += u32::from((low..=high).contains(&truth));
            count += 1;
        }
        // A law without directions takes the difference for an offset.
        let (_, even) = fitted(&asked(), &record);
        let offset = estimate(&even, "offset").interval();
        assert!(offset[0] > 0.03, "{offset:?}");
        assert!(fit.residuals.rms < 0.9 * even.residuals.rms, "{} {}", fit.residuals.rms, even.residuals.rms);
    }
    // 19 of 20 are expected, and 17 or more in 98 of 100 cases.
    assert!(held >= 17 && count == 20, "{held} of {count}");
}

/// The levels of an axis contain the offset of the load cell, and the fit says so.
#[test]
fn an_offset_is_held_beside_the_levels_of_both_directions() {
    let record = record(UNEVEN_JOINT, 30);
    let (_, fit) = fitted(&two_levels(), &record);
    for (name, truth, unit) in [
        ("mu_k_forward", 0.9 + 0.012, "1"),
        ("mu_k_backward", 0.95 - 0.012, "1"),
        ("viscous_coefficient_forward", VISCOUS[0], "N.m.s/rad"),
        ("viscous_coefficient_backward", VISCOUS[1], "N.m.s/rad"),
    ] {
        assert_told(&fit, (name, unit), truth, 0.02);
    }
    assert!(fit.estimates.iter().all(|one| one.name != "offset") && fit.physical.offset == 0.0);
    let says = |fit: &Fit| fit.warnings.iter().any(|one| one.contains("cannot be told apart from a difference"));
    assert!(says(&fit), "{:?}", fit.warnings);
    // An offset that is known.
    let fix = vec![Entry("offset".to_owned(), 0.012)];
    let (_, fit) = fitted(&Inquiry { fix, ..two_levels() }, &record);
    assert_told(&fit, ("mu_k_forward", "1"), 0.9, 0.02);
    assert_told(&fit, ("mu_k_backward", "1"), 0.95, 0.02);
    assert!(!says(&fit), "{:?}", fit.warnings);
}

#[test]
fn an_offset_and_levels_of_both_directions_are_not_told_apart() {
    let both = Inquiry { fit: vec!["offset".to_owned()], ..two_levels() };
    let (_, fit) = fitted(&both, &record(UNEVEN_JOINT, 31));
    for name in ["offset", "mu_k_forward", "mu_k_backward", "mu_s_backward"] {
        let verdict = estimate(&fit, name).verdict.to_string();
        assert!(verdict.contains("a difference of the levels by direction cannot be told apart"), "{name}: {verdict}");
    }
    assert_told(&fit, ("viscous_coefficient_forward", "N.m.s/rad"), VISCOUS[0], 0.02);
    assert_told(&fit, ("viscous_coefficient_backward", "N.m.s/rad"), VISCOUS[1], 0.02);
}

/// Each direction has its pair of levels, and a parameter set has what was tied.
#[test]
fn each_direction_has_its_pair_of_levels() {
    let truth = [
        ("mu_k_forward", 0.2),
        ("mu_s_forward", 0.3),
        ("mu_k_backward", 0.25),
        ("mu_s_backward", 0.4),
        ("stribeck_velocity_forward", 0.01),
        ("stribeck_velocity_backward", 0.01),
    ];
    let data = [measured(LAW, &truth, &standard(2000), 0.02, 5)];
    let tied = vec![("stribeck_velocity_backward".to_owned(), "stribeck_velocity_forward".to_owned())];
    let task = Settings { selection: Selection { tied, ..Selection::default() }, ..quick() };
    let law = laws_named(&[LAW.to_owned()]).unwrap()[0];
    let fit = fit(law, &data, &task, quiet()).unwrap();
    let values = fit.values();
    for (name, truth) in truth {
        let one = estimate(&fit, name);
        let [low, high] = one.interval();
        assert!(one.verdict == Verdict::Determined && (low..=high).contains(&truth), "{one:?}");
        assert!(high - low < 0.1 * truth, "{one:?}");
        assert!(values.contains(&(name.to_owned(), one.value)), "{name}: {values:?}");
    }
    assert!(fit.estimates.iter().any(|one| one.name == "mu_s_backward - mu_k_backward"));
    let Exported { text, lost } = fit.exported(Format::Urdf, &data).unwrap();
    let load = data[0].normal_force.iter().sum::<f64>() / 2000.0;
    let (_, level) = text.split_once("friction=\"").unwrap();
    let level: f64 = level.split_once('"').unwrap().0.parse().unwrap();
    assert!((level / (0.225 * load) - 1.0).abs() < 0.01, "the mean of both: {text}");
    assert!(lost.iter().any(|one| one.starts_with("mu_k_backward = ")), "{lost:?}");
}

/// By differences, where levels are tied across the directions.
#[test]
fn sensitivities_follow_the_ties() {
    let data = [measured(LAW, &[], &standard(400), 0.02, 5)];
    let law = laws_named(&[LAW.to_owned()]).unwrap()[0];
    for tied in [
        &[["mu_k_backward", "mu_k_forward"]][..],
        &[["mu_s_backward", "mu_s_forward"]],
        &[["mu_k_backward", "mu_k_forward"], ["mu_s_forward", "mu_k_forward"]],
    ] {
        let tied = tied.iter().map(|[name, other]| ((*name).to_owned(), (*other).to_owned())).collect();
        let task = Settings { selection: Selection { tied, ..Selection::default() }, ..quick() };
        let problem = problem(law, &data, &task).unwrap();
        let point: Vec<f64> = (0..problem.parameters.len()).map(|at| 0.3 + 0.05 * at as f64).collect();
        for (number, exact) in problem.sensitivities(&point).into_iter().enumerate() {
            let size = exact.iter().fold(1e-6, |most: f64, one| most.max(one.abs()));
            let apart = exact.iter().zip(problem.differences(&point, number, 1e-5)).map(|(a, b)| (a - b).abs());
            let apart = apart.fold(0.0, f64::max);
            assert!(apart < 1e-3 * size, "{}: {apart} of {size}", problem.parameters[number].name);
        }
    }
}

#[test]
fn ties_that_cannot_hold_are_refused() {
    let record = text(SI, &JOINT.record(1)[..400].to_vec(), [1.0; 3]);
    let level = ["mu_k_backward", "mu_k_forward"];
    let fix = |name: &str| vec![Entry(name.to_owned(), 0.5)];
    for (asked, expected) in [
        (with(ties(&[["mu_k", "mu_k_forward"]])), "parameter 'mu_k' does not exist"),
        (with(ties(&[["mu_k_forward", "mu"]])), "parameter 'mu' does not exist"),
        (with(ties(&[["mu_k_forward", "stribeck_velocity_forward"]])), "must be parameters of the same unit"),
        (with(ties(&[["mu_k_backward", "mu_s_forward"]])), "tie the static level to the kinetic one instead"),
        (with(ties(&[["offset", "mu_k_forward"]])), "both must be parameters of the law"),
        (with(ties(&[level, ["mu_k_forward", "mu_k_backward"]])), "mu_k_forward is tied itself"),
        (with(ties(&[["mu_k_forward", "mu_k_forward"]])), "mu_k_forward is tied itself"),
        (Inquiry { fix: fix("mu_k_backward"), ..with(ties(&[level])) }, "it is held or fitted too"),
        (Inquiry { law: vec!["CoulombViscous".to_owned()], ..with(ties(&[level])) }, "'mu_k_backward' does not exist"),
    ] {
        let data = asked.data(&record).unwrap();
        let found = asked.fits(&data, &mut |_| {}, quiet()).unwrap_err().to_string();
        assert!(found.contains(expected), "{expected}: {found}");
    }
    // To a level that is held.
    let asked = Inquiry { fix: fix("mu_k_forward"), ..one_level() };
    let (_, fit) = fitted(&asked, &record);
    let value = |name: &str| fit.values().into_iter().find(|(known, _)| known == name).map(|(_, value)| value);
    assert_eq!([value("mu_k_backward"), value("mu_s_backward")], [Some(0.5); 2]);
}
