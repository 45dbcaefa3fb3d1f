//! Mass, friction and offset of axes.

use std::f64::consts::TAU;

use stribeck::catalogue::by_name;

use super::tests::{estimate, fitted, measured, noise, quick, quiet, standard};
use super::*;
use stribeck_measured::{Delay, Record, Setup};
use stribeck_sheet::{DISPLACEMENT, FORCE, Sheet, TIME};

#[test]
fn mass_friction_and_offset_of_an_axis_are_found_within_half_a_percent() {
    let mass = 95.1089;
    let mut data = measured(
        "CoulombViscous",
        &[("mu_k", 20.3935), ("viscous_coefficient", 203.5034)],
        &Experiment {
            normal_force: vec![1.0; 4000],
            velocity: standard(4000).velocity.iter().map(|v| 5.0 * v).collect(),
            ..standard(4000)
        },
        0.0,
        1,
    );
    data.acceleration.iter_mut().for_each(|a| *a *= 5.0);
    let noise = noise(8, 4000);
    for (at, force) in data.force.iter_mut().enumerate() {
        *force += mass * data.acceleration[at] - 3.1648 + 0.5 * noise[at];
    }
    let selection = Selection { fitted: vec!["mass".into(), "offset".into()], ..Selection::default() };
    let fit = fitted("CoulombViscous", &[data], &Settings { selection, ..quick() });
    for (name, truth) in [("mass", mass), ("mu_k", 20.3935), ("viscous_coefficient", 203.5034), ("offset", -3.1648)] {
        let one = estimate(&fit, name);
        assert!((one.value / truth - 1.0).abs() < 5e-3 || (one.value - truth).abs() < 0.05, "{one:?}");
        assert_eq!(one.verdict, Verdict::Determined);
    }
    // The law has a parameter mass too, that of the body it holds.
    let names: Vec<String> = fit.values().into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["mu_k", "viscous_coefficient"]);
}

/// The system `axis`, solved, as its controller would record it: force of the drive with noise, position of an encoder.
#[test]
fn a_record_of_the_axis_gives_back_its_parameters() {
    let source = stribeck_solve::system::Source::open("axis").unwrap();
    let system = stribeck_solve::system::System::assemble(&source, None, &[]).unwrap();
    let shown = ["axis.drive_force", "axis.position"].map(str::to_owned);
    let outcome = stribeck_solve::run::run(&system, &stribeck_solve::run::Settings::of(&system), &shown).unwrap();
    let [force, position] = shown.each_ref().map(|name| outcome.values(name).unwrap());
    let random = noise(3, force.len());
    let force = force.iter().zip(&random).map(|(force, noise)| force + 0.5 * noise).collect();
    let position = position.iter().map(|x| (x / 1e-6).round() * 1e-6).collect();
    let columns = [("time", outcome.time.clone()), ("force", force), ("displacement", position)];
    let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
    let rig = Setup { normal_force: Some(axis::NORMAL_FORCE), is_axis: true, ..Setup::default() };
    let record = Record::of(&sheet, None, &rig).unwrap();
    let mut selection = Selection::default();
    axis::fitted(&mut selection, 0.0);
    let experiment = axis::in_motion(Experiment::new("axis", &record), &[]).unwrap();
    let fit = fitted(axis::LAW, &[experiment], &Settings { selection, ..quick() });
    for (name, truth) in [("mass", 95.1089), ("mu_k", 20.3935), ("viscous_coefficient", 203.5034), ("offset", -3.1648)]
    {
        let one = estimate(&fit, name);
        let [low, high] = one.interval();
        assert!((one.value / truth - 1.0).abs() < 5e-3, "{one:?}");
        assert!((low..=high).contains(&truth), "{one:?}");
    }
    // What pictures show: the force without inertia and offset.
    let seen = fit.corrected(&record);
    let predicted = fit.predicted_in(&seen, 0);
    let fastest = seen.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let fast: Vec<usize> = (0..seen.time.len()).filter(|at| seen.velocity[*at].abs() > 0.2 * fastest).collect();
    assert!(fast.len() > 100);
    for at in fast {
        let friction = 20.3935 * seen.velocity[at].signum() + 203.5034 * seen.velocity[at];
        assert!((predicted.friction_force[at] - friction).abs() < 0.2, "{at} {friction}");
        assert!((seen.friction_force[at] - friction).abs() < 1.5, "{at} {friction} {}", seen.friction_force[at]);
    }
}

#[test]
fn a_mass_that_is_known_is_not_fitted() {
    let fitted = |mass: f64| {
        let mut selection = Selection::default();
        axis::fitted(&mut selection, mass);
        selection.fitted
    };
    assert_eq!(fitted(0.0), ["mass", "offset"]);
    assert_eq!(fitted(35.0), ["offset"]);
}

/// Clocks of their own: each record has a delay of its own.
#[test]
fn delays_of_several_records_are_not_taken_for_one() {
    let one = |name: &str| {
        let data = measured("Coulomb", &[], &standard(400), 0.01, 1);
        Experiment { name: name.into(), delay_range: Some([-0.01, 0.01]), ..data }
    };
    let law = by_name("Coulomb").unwrap();
    let text = fit(law, &[one("first"), one("second")], &quick(), quiet()).unwrap_err().to_string();
    assert!(text.starts_with("second: its delay is another one than that of first"), "{text}");
    let selection = Selection { fixed: vec![("delay".into(), 0.01)], ..Selection::default() };
    let known = Experiment { delay_range: None, ..one("known") };
    let text = fit(law, &[known], &Settings { selection, ..quick() }, quiet()).unwrap_err().to_string();
    assert!(text.contains("held only where it is looked for"), "{text}");
}

/// An axis of 60 kg, 250 N s/m, 25 N and -2 N.
const AXIS: [(&str, f64); 4] = [("mass", 60.0), ("viscous_coefficient", 250.0), ("mu_k", 25.0), ("offset", -2.0)];

/// Motion of that axis under a force that is held for some time, in closed form; it sticks where it stops.
fn moved([mut x, mut v]: [f64; 2], force: f64, mut left: f64) -> [f64; 2] {
    let [mass, viscous, level, offset] = AXIS.map(|(_, value)| value);
    let (drive, time) = (force - offset, mass / viscous);
    while left > 0.0 {
        if v == 0.0 && drive.abs() <= level {
            return [x, v];
        }
        let sign = if v == 0.0 { drive.signum() } else { v.signum() };
        let last = (drive - sign * level) / viscous;
        // v(t) = last + (v - last) exp(-t / time) is 0 at this time, if it ever is.
        let stop = if last * sign < 0.0 && v != 0.0 { time * (1.0 - v / last).ln() } else { f64::INFINITY };
        let step = stop.min(left);
        let decay = (-step / time).exp();
        x += last * step + (v - last) * time * (1.0 - decay);
        v = if stop <= left { 0.0 } else { last + (v - last) * decay };
        left -= step;
    }
    [x, v]
}

/// A record over 20 s at 100 Hz: the force that is held after each sample, with noise, and an encoder of 1 um.
fn held(force: impl Fn(f64) -> f64) -> Sheet {
    const INTERVAL: f64 = 0.01;
    let time: Vec<f64> = (0..2000).map(|at| f64::from(at) * INTERVAL).collect();
    let mut state = [0.0_f64; 2];
    let displacement = time.iter().map(|t| {
        let x = (state[0] / 1e-6).round() * 1e-6;
        state = moved(state, force(*t), INTERVAL);
        x
    });
    let displacement: Vec<f64> = displacement.collect();
    let force = time.iter().zip(noise(5, time.len())).map(|(t, noise)| force(*t) + 0.1 * noise).collect();
    let columns = [("time", time.clone()), ("force", force), ("displacement", displacement)];
    Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap()
}

fn fit_of_axis(sheet: &Sheet, delay: Delay) -> Fit {
    fit_with(sheet, delay, Selection::default())
}

fn fit_with(sheet: &Sheet, delay: Delay, mut selection: Selection) -> Fit {
    let rig = Setup { normal_force: Some(axis::NORMAL_FORCE), is_axis: true, delay, ..Setup::default() };
    let record = Record::of(sheet, None, &rig).unwrap();
    let law = by_name(axis::LAW).unwrap();
    let experiment = axis::in_motion(Experiment::new("axis", &record), &[law]).unwrap();
    axis::fitted(&mut selection, 0.0);
    fitted(axis::LAW, &[experiment], &Settings { selection, ..quick() })
}

/// Between samples 10 ms apart the axis goes on to accelerate: a filter of the motion alone, or a delay of 0, would shift
/// the viscous friction by some percent.
#[test]
fn a_force_that_is_held_between_samples_shifts_no_parameter_of_an_axis() {
    let force = |t: f64| 90.0 * (TAU * 0.31 * t).sin() + 60.0 * (TAU * 1.3 * t).sin();
    let fit = fit_of_axis(&held(force), Delay::OfController);
    for (name, truth) in AXIS {
        let one = estimate(&fit, name);
        let [low, high] = one.interval();
        assert!((one.value / truth - 1.0).abs() < 5e-3 || (one.value - truth).abs() < 0.02, "{one:?}");
        assert!(one.verdict == Verdict::Determined && (low..=high).contains(&truth), "{one:?}");
    }
    assert!((estimate(&fit, "delay").value - 0.005).abs() < 3e-4);
    // The system of the workbench takes all of it.
    let known = fit.configuration();
    assert_eq!((known.system.as_deref(), known.law.as_slice()), (Some("axis"), &["CoulombViscous".to_owned()][..]));
    let names: Vec<&str> = known.set.keys().map(String::as_str).collect();
    assert_eq!(names, ["axis.guide_force", "axis.mass", "axis.offset", "mu_k", "viscous_coefficient"]);
    assert!(fit.note().is_some_and(|note| note.contains("friction force in N")));
    assert!(fit.warnings.is_empty(), "{:?}", fit.warnings);
}

/// However late the motion looks at first, the fit looks for its delay where that of a controller can be.
#[test]
fn the_delay_of_a_controller_is_looked_for_from_half_a_sample_early_to_two_late() {
    // The motion is half a sample late, or one and a half: neither is the middle of the range.
    for late in [0, 1] {
        let sheet = held(|t| 90.0 * (TAU * 0.31 * t).sin() + 60.0 * (TAU * 1.3 * t).sin());
        let [time, force, displacement] =
            [&TIME, &FORCE, &DISPLACEMENT].map(|quantity| sheet.column(quantity).unwrap().unwrap());
        let count = time.len() - late;
        let columns = [
            ("time", time[..count].to_vec()),
            ("force", force[late..].to_vec()),
            ("displacement", displacement[..count].to_vec()),
        ];
        let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
        let rig = Setup {
            normal_force: Some(axis::NORMAL_FORCE),
            is_axis: true,
            delay: Delay::OfController,
            ..Setup::default()
        };
        let record = Record::of(&sheet, None, &rig).unwrap();
        assert!((record.clocks.delay - 0.0075).abs() > 1e-3, "{late}: {}", record.clocks.delay);
        let [low, high] = record.delay_range.unwrap();
        assert!((low + 0.005).abs() < 1e-9 && (high - 0.02).abs() < 1e-9, "{late}: {low} to {high}");
    }
}

/// Motion of one frequency w without Coulomb friction: d later, it has M w^2 d more of viscous friction and f_v d less
/// of mass, and nothing tells one from the other.
#[test]
fn a_delay_that_looks_like_friction_leaves_the_friction_open() {
    let rate = TAU * 0.5;
    let motion = |t: f64| [-0.1 * (rate * t).cos() / rate, 0.1 * (rate * t).sin(), 0.1 * rate * (rate * t).cos()];
    let [mass, viscous, ..] = AXIS.map(|(_, value)| value);
    let time: Vec<f64> = (0..4000).map(|at| f64::from(at) * 2e-3).collect();
    let noise = noise(7, time.len());
    let force = |at: usize| {
        let [_, v, a] = motion(time[at] - 0.03);
        mass * a + viscous * v + 0.2 * noise[at]
    };
    let columns = [
        ("time", time.clone()),
        ("force", (0..time.len()).map(force).collect()),
        ("displacement", time.iter().map(|t| (motion(*t)[0] / 1e-6).round() * 1e-6).collect()),
    ];
    let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
    let fit = fit_of_axis(&sheet, Delay::Find(0.1));
    // The noise of the encoder alone must not decide between them.
    for (name, truth) in [("mass", mass), ("viscous_coefficient", viscous), ("delay", -0.03)] {
        let one = estimate(&fit, name);
        let [low, high] = one.interval();
        let is_open = low < truth && truth < high && high - low > 0.05 * truth.abs();
        assert!(one.verdict != Verdict::Determined || is_open, "{one:?}");
    }
}

/// A load cell before a slider of 2 kg that moves fast: the filter takes half a percent of the acceleration away, which
/// is not to be found in the mass.
#[test]
fn a_mass_behind_a_load_cell_is_weighed_with_all_of_its_acceleration() {
    let sine = |t: f64, size: f64, rate: f64| {
        let (sine, cosine) = (TAU * rate * t).sin_cos();
        [size * sine, size * TAU * rate * cosine, -size * (TAU * rate).powi(2) * sine]
    };
    let motion = |t: f64| [0, 1, 2].map(|order| sine(t, 1e-2, 0.8)[order] + sine(t, 4e-3, 4.3)[order]);
    let time: Vec<f64> = (0..4000).map(|at| f64::from(at) * 1e-3).collect();
    let [random, shaken] = [noise(4, time.len()), noise(5, time.len())];
    let force = |t: f64| 2.0 * motion(t)[2] + 4.0 * motion(t)[1].signum() + 5.0 * motion(t)[1];
    let columns = [
        ("time", time.clone()),
        ("force", time.iter().zip(&random).map(|(t, noise)| force(*t) + 0.03 * noise).collect()),
        ("displacement", time.iter().zip(&shaken).map(|(t, noise)| motion(*t)[0] + 1e-6 * noise).collect()),
    ];
    let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
    let record = Record::of(&sheet, None, &Setup { normal_force: Some(20.0), ..Setup::default() }).unwrap();
    assert!((0.003..0.01).contains(&record.acceleration_lost), "{}", record.acceleration_lost);
    let selection = Selection { fitted: vec!["mass".into()], ..Selection::default() };
    let experiments = [Experiment::new("fast", &record)];
    let fit = fitted("CoulombViscous", &experiments, &Settings { selection, ..quick() });
    let one = estimate(&fit, "mass");
    assert!((one.value - 2.0).abs() < 3e-3 && is_open_or_true(one, 2.0), "{one:?}");
    // The same but for the degrees of freedom.
    let left = &held_out(&fit, &experiments).unwrap()[0];
    assert!((left.rms / left.fitted - 1.0).abs() < 1e-3, "{left:?}");
}

/// The same axis under a controller that holds its force between samples of an encoder of 5 um: its answers to the
/// rounding look like a delay.
#[test]
fn rounding_that_a_controller_answers_is_not_taken_for_a_delay() {
    const INTERVAL: f64 = 0.004;
    let [mass, ..] = AXIS.map(|(_, value)| value);
    let (corner, rate) = (TAU * 12.0, TAU * 1.05);
    let time: Vec<f64> = (0..3000).map(|at| f64::from(at) * INTERVAL).collect();
    let random = noise(9, time.len());
    let mut state = [0.0_f64; 2];
    let (mut force, mut displacement) = (Vec::new(), Vec::new());
    for (t, noise) in time.iter().zip(&random) {
        let rounded = (state[0] / 5e-6).round() * 5e-6;
        let [x, v] = [0.04 * (1.0 - (rate * t).cos()), 0.04 * rate * (rate * t).sin()];
        let drive = mass * corner * (corner * (x - rounded) + 1.6 * (v - state[1]));
        force.push(drive + 0.06 * noise);
        displacement.push(rounded);
        state = moved(state, drive, INTERVAL);
    }
    let columns = [("time", time), ("force", force), ("displacement", displacement)];
    let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
    let fit = fit_of_axis(&sheet, Delay::OfController);
    assert!(matches!(estimate(&fit, "delay").verdict, Verdict::Undetermined(_)), "{:?}", estimate(&fit, "delay"));
    for (name, truth) in AXIS {
        let one = estimate(&fit, name);
        assert!(is_open_or_true(one, truth), "{one:?}");
    }
}

/// A slide that is pushed one way ever faster: M a is as constant as Coulomb friction, and noise must not tell them apart.
#[test]
fn a_constant_acceleration_tells_no_mass() {
    let [mass, viscous, level, offset] = AXIS.map(|(_, value)| value);
    let time: Vec<f64> = (0..2000).map(|at| f64::from(at) * 1e-3).collect();
    let [random, shaken] = [noise(2, time.len()), noise(3, time.len())];
    let force = |t: f64| mass * 0.05 + level + offset + viscous * (0.02 + 0.05 * t);
    let columns = [
        ("time", time.clone()),
        ("force", time.iter().zip(&random).map(|(t, noise)| force(*t) + 0.05 * noise).collect()),
        ("displacement", time.iter().zip(&shaken).map(|(t, noise)| 0.02 * t + 0.025 * t * t + 1e-7 * noise).collect()),
    ];
    let sheet = Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
    let selection = Selection { fixed: vec![("offset".into(), offset)], ..Selection::default() };
    let fit = fit_with(&sheet, Delay::OfController, selection);
    for (name, truth) in [("mass", mass), ("mu_k", level)] {
        let one = estimate(&fit, name);
        assert!(is_open_or_true(one, truth), "{one:?}");
    }
    assert!(!matches!(estimate(&fit, "mass").verdict, Verdict::Determined));
}

/// Whether an interval or a limit contains the truth, if there is one.
fn is_open_or_true(one: &Estimate, truth: f64) -> bool {
    let [low, high] = one.interval();
    match one.verdict {
        Verdict::Determined => (low..=high).contains(&truth),
        Verdict::AtMost(limit) => truth <= limit,
        _ => true,
    }
}
