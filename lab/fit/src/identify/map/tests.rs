//! Maps of a simulator of their own: curves of steady sliding written down here, with noise.

use std::path::Path;

use super::super::joint_tests::Text;
use super::super::tests::{estimate, noise, quick, quiet};
use super::super::{Answer, Inquiry, Ranking, Settings, Source, Verdict, fit_all};
use super::*;
use approx::assert_relative_eq;
use stribeck_sheet::{Sheet, SheetError};
use stribeck_solve::job::Entry;

fn inquiry(law: &[&str]) -> Inquiry {
    let law = law.iter().map(|name| (*name).to_owned()).collect();
    Inquiry { records: vec!["map.csv".into()], law, normal_force: Some(1.0), ..Inquiry::default() }
}

fn asked(text: &str, inquiry: &Inquiry) -> Result<(Ranking, Answer), Fault> {
    let data = inquiry.data(&Text(text.to_owned()))?;
    let task = Settings { repetitions: 0, ..inquiry.settings()? };
    let ranking = fit_all(&inquiry.laws()?, &data.experiments, &task, &mut |_| (), quiet())?;
    let answer = Answer::of(&ranking, &data);
    Ok((ranking, answer))
}

fn refusal(text: &str, inquiry: &Inquiry) -> String {
    asked(text, inquiry).unwrap_err().to_string()
}

/// Levels of 0.3 and 0.4 N, viscous friction of 2 and 3 N s/m, an offset of 0.02 N.
#[test]
fn a_map_tells_directions_and_no_offset_beside_their_levels() {
    let forces = SPEEDS.into_iter().flat_map(|v| [(v, 0.32 + 2.0 * v), (-v, -0.38 - 3.0 * v)]);
    let rows =
        forces.zip(noise(9, 2 * SPEEDS.len())).map(|((v, force), noise)| format!("{v},{}\n", force + 0.002 * noise));
    let map = format!("velocity [m/s],force [N]\n{}", rows.collect::<String>());
    let tie = [("mu_s_forward", "mu_k_forward"), ("mu_s_backward", "mu_k_backward")];
    let tie: Vec<Entry<String>> = tie.map(|(name, other)| Entry(name.to_owned(), other.to_owned())).into();
    let asked_for = Inquiry { tie, ..inquiry(&["DirectionalStribeck"]) };
    let (ranking, _) = asked(&map, &asked_for).unwrap();
    for (name, truth) in [
        ("mu_k_forward", 0.32),
        ("mu_k_backward", 0.38),
        ("viscous_coefficient_forward", 2.0),
        ("viscous_coefficient_backward", 3.0),
    ] {
        let one = estimate(&ranking.fits[0], name);
        let is_near = (one.value - truth).abs() < 4.0 * one.deviation && one.deviation < 0.01;
        assert!(one.verdict == Verdict::Determined && is_near, "{one:?}");
    }
    let (ranking, _) = asked(&map, &Inquiry { fit: vec!["offset".to_owned()], ..asked_for }).unwrap();
    for name in ["offset", "mu_k_forward", "mu_k_backward"] {
        let verdict = estimate(&ranking.fits[0], name).verdict.to_string();
        assert!(verdict.contains("a difference of the levels by direction cannot be told apart"), "{name}: {verdict}");
    }
}

/// Speeds of a map, in m/s.
const SPEEDS: [f64; 14] = [1e-3, 2e-3, 3e-3, 5e-3, 8e-3, 0.012, 0.018, 0.027, 0.04, 0.06, 0.09, 0.14, 0.2, 0.3];

/// A map of a curve of the speed, three times in both directions, with noise.
fn simulated(curve: impl Fn(f64) -> f64, scatter: f64, seed: u64) -> String {
    let rows: Vec<f64> = (0..3).flat_map(|_| SPEEDS).flat_map(|speed| [speed, -speed]).collect();
    let force =
        rows.iter().zip(noise(seed, rows.len())).map(|(v, noise)| v.signum() * curve(v.abs()) + scatter * noise);
    let lines: Vec<String> = rows.iter().zip(force).map(|(v, force)| format!("{v},{force}")).collect();
    format!("velocity [m/s],force [N]\n{}\n", lines.join("\n"))
}

/// Stribeck's curve, with exponent 2.
fn falling([level, excess, speed, viscous]: [f64; 4]) -> impl Fn(f64) -> f64 {
    move |v: f64| level + excess * (-(v / speed).powi(2)).exp() + viscous * v
}

/// Number of intervals of a law, by parameter, that hold the truth, and of all, in maps with drawn truths.
fn held(law: &str, maps: u64) -> Vec<(&'static str, [u32; 2])> {
    let names = ["mu_k", "mu_s", "stribeck_velocity", "viscous_coefficient"];
    let mut counts = names.map(|name| (name, [0; 2]));
    for seed in 0..maps {
        let mut random = fastrand::Rng::with_seed(seed ^ 0x5EED);
        let mut drawn = |low: f64, high: f64| low + (high - low) * random.f64();
        let load = drawn(5.0, 40.0);
        let [level, excess, speed] = [drawn(0.1, 0.3), drawn(0.05, 0.15), drawn(5e-3, 0.04)];
        let has_fall = law != "CoulombViscous";
        let viscous = drawn(1.0, 3.0) * level * load;
        let curve = falling([level * load, if has_fall { excess * load } else { 0.0 }, speed, viscous]);
        let asked_for = Inquiry { normal_force: Some(load), ..inquiry(&[law]) };
        let data = asked_for.data(&Text(simulated(curve, 0.01 * load * level, 1000 + seed))).unwrap();
        let task = Settings { profiles: true, budget: 300, ..quick() };
        let fit = super::super::tests::fitted(law, &data.experiments, &task);
        for ((name, count), truth) in counts.iter_mut().zip([level, level + excess, speed, viscous]) {
            let Some(one) = fit.estimates.iter().find(|one| one.name == *name) else { continue };
            if one.verdict == Verdict::Determined {
                let [low, high] = one.interval();
                *count = [count[0] + u32::from((low..=high).contains(&truth)), count[1] + 1];
            }
        }
    }
    counts.into_iter().filter(|(_, count)| count[1] > 0).collect()
}

/// 100 maps: of 40 intervals of one parameter that hold in 95 %, fewer than 34 happen once in 200 times.
#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let found = [held("CoulombViscous", 55), held("Stribeck", 40), held("LuGre", 5)].concat();
    let total = found.iter().fold([0, 0], |sum, (_, count)| [sum[0] + count[0], sum[1] + count[1]]);
    let part = |[hits, all]: [u32; 2]| f64::from(hits) / f64::from(all);
    println!("figure: maps: {} of {} intervals hold the truth, {found:?}", total[0], total[1]);
    assert!(total[1] >= 280 && (0.93..=0.98).contains(&part(total)), "{total:?} {found:?}");
    for name in ["mu_k", "mu_s", "stribeck_velocity", "viscous_coefficient"] {
        let of = found.iter().filter(|one| one.0 == name);
        let of = of.fold([0, 0], |sum, (_, count)| [sum[0] + count[0], sum[1] + count[1]]);
        assert!(part(of) >= 0.9, "{name}: {of:?} of {found:?}");
    }
}

/// f = a + b v is linear: normal equations by hand give values and standard errors, a table the quantile.
#[test]
fn a_linear_law_has_the_errors_of_ordinary_least_squares() {
    let [v, f] = [[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7], [2.1, 2.2, 2.6, 2.7, 3.1, 3.1, 3.5]];
    let lines: String = v.iter().zip(f).map(|(v, f)| format!("{v},{f},2\n")).collect();
    let text = format!("velocity [m/s],force [N],normal_force [N]\n{lines}");
    let (ranking, _) = asked(&text, &Inquiry { normal_force: None, ..inquiry(&["CoulombViscous"]) }).unwrap();
    let mean = |values: [f64; 7]| values.iter().sum::<f64>() / 7.0;
    let (v_mean, f_mean) = (mean(v), mean(f));
    let across: f64 = v.iter().map(|v| (v - v_mean).powi(2)).sum();
    let slope = v.iter().zip(f).map(|(v, f)| (v - v_mean) * (f - f_mean)).sum::<f64>() / across;
    let level = f_mean - slope * v_mean;
    let left: f64 = v.iter().zip(f).map(|(v, f)| (f - level - slope * v).powi(2)).sum();
    let noise = (left / 5.0).sqrt();
    let [of_slope, of_level] = [noise / across.sqrt(), noise * (1.0 / 7.0 + v_mean * v_mean / across).sqrt()];
    let fit = ranking.best();
    for (name, value, error) in [("mu_k", 0.5 * level, 0.5 * of_level), ("viscous_coefficient", slope, of_slope)] {
        let one = estimate(fit, name);
        assert_relative_eq!(one.value, value, max_relative = 1e-5);
        // A profile is followed to 2 %, and what is known before the data shortens an interval by less.
        for (end, sign) in one.interval().into_iter().zip([-1.0, 1.0]) {
            assert_relative_eq!(end - value, sign * 2.5706 * error, max_relative = 0.02);
        }
    }
    assert_relative_eq!(fit.residuals.rms, noise, max_relative = 1e-6);
    assert!(fit.lack_of_fit.is_none() && fit.warnings.is_empty(), "{:?}", fit.warnings);
}

/// A joint: 12 rows of velocity in rad/s and moment in N.m.
const JOINT: &str = "velocity [rad/s],torque [N.m]\n-6,-3.62\n-3,-2.11\n-1.5,-1.37\n-0.75,-1.03\n-0.4,-0.93\n\
                     -0.04,-1.19\n0.04,1.21\n0.4,0.95\n0.75,1.01\n1.5,1.4\n3,2.09\n6,3.64\n";

#[test]
fn a_map_of_a_joint_is_explained_by_stribecks_curve() {
    let (ranking, answer) = asked(JOINT, &inquiry(&["Stribeck", "CoulombViscous", "LuGre"])).unwrap();
    assert_eq!(ranking.fits[ranking.ranks.last().unwrap().fit].law.name, "CoulombViscous");
    let fit = ranking.fits.iter().find(|fit| fit.law.name == "Stribeck").unwrap();
    let [level, viscous] = ["mu_k", "viscous_coefficient"].map(|name| estimate(fit, name).value);
    assert!((level - 0.6).abs() < 0.1 && (viscous - 0.5).abs() < 0.03, "{level} {viscous}");
    assert!(fit.residuals.rms < 0.05, "{}", fit.residuals.rms);
    let said = answer.findings["map"].join("\n");
    assert!(said.contains("at a load of 1 N.m a coefficient of friction is a torque in N.m"), "{said}");
    // Other names of the same columns.
    let (named, _) = asked(&JOINT.replace("velocity", "dq").replace("torque", "tau"), &inquiry(&["Stribeck"])).unwrap();
    assert_eq!(estimate(named.best(), "mu_k").value, level);
    for part in ["each row is taken as steady sliding", "no column time", "'torque' was taken as force"] {
        assert!(said.contains(part), "{said}");
    }
    assert!(said.contains("no repeats"), "{said}");
}

/// LuGre's bristles do not change its steady curve, which has Stribeck's form with the exponent that it is held at.
#[test]
fn what_steady_sliding_does_not_depend_on_is_held() {
    let truth = [3.0, 1.0, 0.01, 6.0];
    let task = Inquiry { normal_force: Some(10.0), ..inquiry(&["LuGre"]) };
    let (ranking, answer) = asked(&simulated(falling(truth), 0.02, 4), &task).unwrap();
    let fit = ranking.best();
    for name in ["sigma_0", "sigma_1"] {
        let verdict = estimate(fit, name).verdict.to_string();
        assert!(verdict.contains("a map cannot tell it; it is held at its start value"), "{verdict}");
        assert!(!answer.laws[0].values.contains_key(name));
    }
    for (name, truth) in [("mu_k", 0.3), ("mu_s", 0.4), ("stribeck_velocity", 0.01), ("viscous_coefficient", 6.0)] {
        let one = estimate(fit, name);
        assert!(one.verdict == Verdict::Determined && (one.value - truth).abs() < 4.0 * one.deviation, "{one:?}");
    }
    assert_eq!(fit.parameters(), 4);
}

/// A static level that acts at rest only, below the kinetic level at its start value, is held above it.
#[test]
fn a_level_of_rest_follows_the_kinetic_level() {
    let text = simulated(|_| 9.0, 0.02, 5);
    let (ranking, _) = asked(&text, &Inquiry { normal_force: Some(10.0), ..inquiry(&["CoulombStiction"]) }).unwrap();
    let fit = ranking.best();
    assert!((estimate(fit, "mu_k").value - 0.9).abs() < 2e-3);
    assert!(estimate(fit, "mu_s - mu_k").verdict.to_string().contains("a map cannot tell it"));
}

/// Backwards it has a tenth less viscous friction: an offset and a level cannot make up for that.
#[test]
fn signs_judge_the_law_without_repeats() {
    let speeds = SPEEDS.iter().flat_map(|v| [-v, *v]);
    let rows = speeds.map(|v| format!("{v},{}\n", v.signum() * 2.0 + if v > 0.0 { 10.0 } else { 8.0 } * v));
    let text = format!("velocity [m/s],force [N]\n{}", rows.collect::<String>());
    let (ranking, _) = asked(&text, &inquiry(&["CoulombViscous"])).unwrap();
    let warnings = &ranking.best().warnings;
    assert!(
        warnings.iter().any(|one| one.contains("does not explain the map") && one.contains("of 27")),
        "{warnings:?}"
    );
}

/// Means of repeats, and the curve at any speed, by hand.
#[test]
fn pictures_have_means_and_a_curve() {
    let text = "velocity [m/s],force [N]\n0.1,2.4\n0.1,2.6\n0.2,3\n0.4,4\n0.6,5\n-0.1,-2.5\n-0.3,-3.5\n";
    let data = inquiry(&["CoulombViscous"]).data(&Text(text.to_owned())).unwrap();
    let (ranking, _) = asked(text, &inquiry(&["CoulombViscous"])).unwrap();
    let means = data.maps[0].1.means();
    let one = means.iter().find(|one| one.velocity == 0.1).unwrap();
    assert_eq!([means.len(), one.rows], [6, 2]);
    assert_relative_eq!(one.force, 2.5, epsilon = 1e-12);
    assert_relative_eq!(one.scatter.unwrap(), 0.02f64.sqrt(), max_relative = 1e-9);
    let curve = steady_curve(ranking.best(), &[[0.5, 1.0], [-0.5, 1.0]]).unwrap();
    assert_relative_eq!(curve[0], 4.5, max_relative = 1e-3);
    assert_relative_eq!(curve[1], -4.5, max_relative = 1e-3);
    let csv = data.maps[0].1.csv(&ranking.best().predicted[0]).unwrap();
    assert!(csv.starts_with("velocity [m/s],normal_force [N],force [N],fitted [N]\n0.1,1,2.4,2.5"), "{csv}");
}

#[test]
fn repeats_judge_the_law() {
    let text = simulated(falling([3.0, 1.0, 0.01, 6.0]), 0.03, 6);
    let task = Inquiry { normal_force: Some(10.0), ..inquiry(&["Stribeck", "CoulombViscous"]) };
    let (ranking, answer) = asked(&text, &task).unwrap();
    let [right, wrong] =
        ["Stribeck", "CoulombViscous"].map(|name| ranking.fits.iter().find(|fit| fit.law.name == name).unwrap());
    let judged = |fit: &super::super::Fit| fit.lack_of_fit.unwrap();
    assert!(judged(right).explained && judged(right).freedom == [28 - 4, 56], "{:?}", judged(right));
    assert!(!judged(wrong).explained && judged(wrong).ratio > 10.0);
    let warning = wrong.warnings.iter().find(|one| one.contains("does not explain the map within the scatter"));
    assert!(warning.is_some() && right.warnings.is_empty(), "{:?} {:?}", wrong.warnings, right.warnings);
    assert_eq!(ranking.best().law.name, "Stribeck");
    assert_eq!(answer.laws[0].correlation, 1.0);
    assert!(right.table().contains("the law explains the map within the scatter"));
    // The scatter that was made, known to a tenth.
    let scatter = answer.findings["map"].iter().find(|one| one.contains("scatter of the repeats")).unwrap();
    assert!(scatter.contains("56 degrees of freedom") && !scatter.contains("weighted"), "{scatter}");
}

/// Slow rows scatter five times as much; their settings are told from the others, and count less.
#[test]
fn rows_that_scatter_more_count_less() {
    let repeats = |seed: u64, speed: f64| {
        let scatter = if speed < 0.05 { 0.1 } else { 0.02 };
        noise(seed, 6).into_iter().map(move |noise| (speed, 2.0 + 5.0 * speed + scatter * noise))
    };
    let rows: Vec<(f64, f64)> =
        (1..=12).flat_map(|at| repeats(at, 0.01 * at as f64 * if at > 4 { 1.5 } else { 1.0 })).collect();
    let (v, f): (Vec<f64>, Vec<f64>) = rows.into_iter().unzip();
    let settings = scatter::settings(&v, &vec![1.0; v.len()]);
    let found = Scatter::of(&v, &f, &settings).unwrap();
    assert!((0.07..0.13).contains(&found.at(0.01)) && (0.013..0.027).contains(&found.at(-0.18)), "{found:?}");
    assert!(found.weight(0.18) > 2.0 * found.weight(0.02));
    assert_eq!(found.freedom, 60);
}

#[test]
fn repeats_are_rows_of_the_same_speed_and_load_but_for_rounding() {
    let velocity = [0.100, 0.101, 0.103, -0.1, 0.1, 8.0, 8.0];
    assert_eq!(scatter::settings(&velocity, &[1.0, 1.0, 1.0, 1.0, 2.0, 1.0, 1.0]), [1, 1, 3, 0, 2, 4, 4]);
}

#[test]
fn what_is_no_map_is_refused_with_the_reason() {
    let head = "velocity [m/s],force [N]\n";
    let law = inquiry(&["CoulombViscous"]);
    let open = Inquiry { normal_force: None, ..law.clone() };
    let cases = [
        ("0.1,1\n0.2,2\n", &law, "2 samples for 2 parameters of CoulombViscous; at least 5 are needed"),
        ("0.1,1\n-0.1,-2\n0.1,1\n", &law, "all rows slide at 0.1 m/s; a map needs at least two speeds"),
        ("0,1\n0,2\n", &law, "velocity is 0 in all rows"),
        ("0.1,1\nNaN,2\n", &law, "line 3, velocity: 'NaN'"),
        ("0.1,-1\n0.2,-2\n", &law, "force and velocity are positive in opposite directions"),
        ("0.1,1\n0.2,2\n", &open, "with 1 the coefficients are forces"),
        ("0.1,1\n0.2,2\n", &Inquiry { mass: Some(2.0), ..law.clone() }, "mass: is not for a map of friction"),
    ];
    for (rows, inquiry, part) in cases {
        let text = refusal(&format!("{head}{rows}"), inquiry);
        assert!(text.contains(part) && text.contains("map.csv") | text.contains("samples"), "{rows}: {text}");
    }
    let mixed = refusal("velocity [m/s],torque [N.m]\n0.1,1\n0.2,2\n", &law);
    assert!(mixed.contains("torque [N.m] and velocity [m/s]: one is of a body that slides"), "{mixed}");
    let seen = law.records(&Text(format!("{head}0.1,1\n0.2,2\n"))).unwrap_err().to_string();
    assert!(seen.ends_with("a motion over time is needed"), "{seen}");
}

/// A map, and a record beside it.
struct Both;

impl Source for Both {
    fn tables(&self, name: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        if name == Path::new("map.csv") {
            return Ok(vec![Sheet::parse(JOINT)?]);
        }
        let row = |at: u32| f64::from(at) * 0.01;
        let rows = (0..200).map(|at| format!("{},{},{}\n", row(at), 2.0 + 0.01 * row(at), 0.1 + row(at)));
        Ok(vec![Sheet::parse(&format!("time [s],force [N],velocity [m/s]\n{}", rows.collect::<String>()))?])
    }
}

#[test]
fn a_map_beside_a_record_is_refused() {
    let records = vec!["map.csv".into(), "record.csv".into()];
    let text = Inquiry { records, ..inquiry(&["Coulomb"]) }.data(&Both).unwrap_err().to_string();
    assert_eq!(text, "map: has no column time, and is a map of friction; record is a record: fit them one at a time");
}

#[test]
fn rows_at_rest_are_left_out_and_one_direction_is_said() {
    let curve = falling([2.0, 0.0, 1.0, 4.0]);
    let rows: String = (0..12).map(|at| 0.02 * f64::from(at)).map(|v| format!("{v},{}\n", curve(v))).collect();
    let text = format!("velocity [m/s],force [N]\n{rows}");
    let task = Inquiry { fit: vec!["offset".into()], ..inquiry(&["CoulombViscous"]) };
    let (ranking, answer) = asked(&text, &task).unwrap();
    let fit = ranking.best();
    assert_eq!(fit.samples, 11);
    assert!(estimate(fit, "offset").verdict.to_string().contains("only in combination"), "{:?}", fit.estimates);
    let said = answer.findings["map"].join("\n");
    assert!(said.contains("1 row at rest is left out") && said.contains("one direction only"), "{said}");
    // Both directions determine the offset.
    let both: String = [-1.0, 1.0]
        .iter()
        .flat_map(|sign| (1..9).map(move |at| 0.02 * sign * f64::from(at)))
        .map(|v| {
            let force = v.signum() * falling([2.0, 0.0, 1.0, 4.0])(v.abs()) + 0.3 + 1e-3 * (977.0 * v).sin();
            format!("{v},{force}\n")
        })
        .collect();
    let (ranking, _) = asked(&format!("velocity [m/s],force [N]\n{both}"), &task).unwrap();
    assert!((estimate(ranking.best(), "offset").value - 0.3).abs() < 2e-3, "{:?}", ranking.best().estimates);
}

/// Every law gives an answer for a map or is refused by name.
#[test]
fn a_law_has_a_steady_curve_or_is_refused_by_name() {
    let experiment = FrictionMap::of(
        MapColumns {
            movement: Movement::Translation,
            velocity: SPEEDS.iter().flat_map(|v| [*v, -v]).collect(),
            force: SPEEDS
                .iter()
                .flat_map(|v| [falling([2.0, 1.0, 0.01, 5.0])(*v), -falling([2.0, 1.0, 0.01, 5.0])(*v)])
                .collect(),
            normal_force: vec![10.0; 28],
        },
        Vec::new(),
    );
    let experiments = [experiment.unwrap().experiment("map", None).unwrap()];
    for law in super::super::laws() {
        match super::super::problem(law, &experiments, &Settings::default()) {
            Ok(problem) => assert!(!problem.parameters.is_empty() && law.name != "Bristle", "{}", law.name),
            Err(fault) => {
                let text = fault.to_string();
                assert!(text.starts_with("Bristle: has no force of steady sliding, which a map needs: "), "{text}");
            }
        }
    }
}
