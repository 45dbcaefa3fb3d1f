//! The friction law of a strut, against the strut itself.

use std::sync::atomic::AtomicBool;

use stribeck::catalogue::by_name;
use stribeck::instance::{Instance, Phase};

use stribeck::model::{Kind, ModelType, Variable};

use super::strut::viscous;
use super::*;
use crate::dyno::{Options, Test};

/// Slow strokes of a strut on a dynamometer, then two fast ones: time and velocity.
fn course() -> Vec<[f64; 2]> {
    let mut rows = Vec::new();
    let mut time = 0.0;
    for (peak, count) in [(0.01, 1), (0.04, 2), (0.15, 2), (0.5, 2)] {
        // An amplitude of 20 mm.
        let rate: f64 = peak / 0.02;
        let period = std::f64::consts::TAU / rate;
        let step = period / if peak < 0.1 { 2000.0 } else { 600.0 };
        let samples = (f64::from(count) * period / step).round() as usize;
        rows.extend((0..samples).map(|k| {
            let t = k as f64 * step;
            [time + t, peak * (rate * t).sin()]
        }));
        time += samples as f64 * step;
    }
    rows
}

/// The strut with these values, driven along the course without its springs: force with noise.
fn driven(values: &[(String, f64)], noise: f64, seed: u64) -> (Test, Vec<f64>) {
    let strut = by_name("ShockAbsorber").unwrap();
    let column = |name: &str| strut.find(name).unwrap_or_else(|| panic!("{name}"));
    let mut instance = Instance::new(strut);
    let off = ["spring.enabled", "gas.enabled", "bump.enabled", "rebound.enabled"].map(|name| (column(name), 0.0));
    let middle = instance.row()[column("length")] - 0.03;
    instance.set_all(Phase::Setup, off.into_iter()).unwrap();
    instance.set_all(Phase::Setup, values.iter().map(|(name, value)| (column(name), *value))).unwrap();
    // The strut takes its first step to be one in steady motion: this one is at rest.
    instance.set_column(column("velocity"), 0.0).unwrap();
    instance.step(1e-9).unwrap();
    let mut random = fastrand::Rng::with_seed(seed);
    let (mut test, mut friction) = (Test { time: Some(vec![]), displacement: Some(vec![]), ..Test::default() }, vec![]);
    let (mut before, mut x) = ([0.0, 0.0], 0.0);
    for [time, velocity] in course() {
        let step = time - before[0];
        if step > 0.0 {
            instance.set_column(column("velocity"), 0.5 * (before[1] + velocity)).unwrap();
            instance.step(step).unwrap();
            x += 0.5 * (before[1] + velocity) * step;
        }
        instance.set_column(column("length"), middle + x).unwrap();
        instance.set_column(column("velocity"), velocity).unwrap();
        let of = |instance: &mut Instance, name: &str| instance.get_column(column(name)).unwrap();
        let parts = [of(&mut instance, "force_damper"), of(&mut instance, "force_friction")];
        let gauss = (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        test.time.as_mut().unwrap().push(time);
        test.displacement.as_mut().unwrap().push(x);
        test.velocity.push(velocity);
        // A resistance has the sign of the velocity; the forces of the strut push the eyes apart.
        test.force.push(noise * gauss - parts[0] - parts[1]);
        friction.push(parts[1]);
        before = [time, velocity];
    }
    (test, friction)
}

fn strut_values(law: &str, more: &[(&str, f64)]) -> Vec<(String, f64)> {
    let strut = by_name("ShockAbsorber").unwrap();
    let chosen = ssp::parameter_set::choice(strut, "friction.model", law).unwrap();
    let mut values = vec![("friction.model".to_owned(), chosen), ("damper.c_comp".to_owned(), 1500.0)];
    values.extend(more.iter().map(|(name, value)| ((*name).to_owned(), *value)));
    values
}

fn watch(never: &AtomicBool) -> Watch<'_> {
    Watch { cancel: never, progress: &|_, _| {} }
}

/// A strut with other levels in its two contacts than in their halves: the set gives the same friction over time.
#[test]
fn a_law_in_a_strut_is_found_in_slow_strokes() {
    let truth = [
        ("c1.preload_k", 18.0),
        ("c2.preload_k", 12.0),
        ("c1.preload_s", 24.0),
        ("c2.preload_s", 16.0),
        ("friction.sigma_0", 1.2e5),
        ("friction.sigma_1", 300.0),
        ("friction.stribeck_velocity", 0.004),
        ("friction.viscous_coefficient", 0.0),
    ];
    let (test, _) = driven(&strut_values("LuGre", &truth), 0.15, 5);
    let options = Options { gas_force: Some(0.0), ..Options::default() };
    let never = AtomicBool::new(false);
    let task = Settings { budget: 1500, repetitions: 0, profiles: false, ..Settings::default() };
    let found = strut_friction(by_name("LuGre").unwrap(), &test, &options, &task, watch(&never)).unwrap();
    println!("{:?} {}", found.damper, found.fit.table());
    let set = found.damper.parameter_set_with("found", &found.values).unwrap();
    let total = |name: &str| set.get(&format!("c1.{name}")).unwrap() + set.get(&format!("c2.{name}")).unwrap();
    assert!((total("preload_k") / 30.0 - 1.0).abs() < 0.02, "{}", total("preload_k"));
    assert!((total("preload_s") / 40.0 - 1.0).abs() < 0.05, "{}", total("preload_s"));
    let velocity = set.get("friction.stribeck_velocity").unwrap();
    assert!((velocity / 0.004 - 1.0).abs() < 0.15, "{velocity}");
    let stiffness = set.get("friction.sigma_0").unwrap();
    assert!((stiffness / 1.2e5 - 1.0).abs() < 0.1, "{stiffness}");
    // The friction of the strut with the set, over the slow strokes.
    let all: Vec<(String, f64)> = set.values().map(|(variable, value)| (variable.path.to_string(), value)).collect();
    let [(_, wanted), (_, given)] = [strut_values("LuGre", &truth), all].map(|values| driven(&values, 0.0, 5));
    let slow = test.velocity.iter().position(|v| v.abs() > 0.05).unwrap();
    let rms = wanted.iter().zip(&given).take(slow).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / slow as f64;
    assert!(rms.sqrt() < 0.4, "{}", rms.sqrt());
}

/// Every law that a strut can have, with values of its own: the friction of the strut is that of the law alone.
#[test]
fn the_two_contacts_of_a_strut_are_together_the_fitted_law() {
    const LOAD: f64 = 160.0;
    let strut = by_name("ShockAbsorber").unwrap();
    let never = AtomicBool::new(false);
    let (test, _) = driven(&strut_values("LuGre", &[]), 0.0, 3);
    let options = Options { gas_force: Some(0.0), ..Options::default() };
    let task = Settings { budget: 1, repetitions: 0, profiles: false, ..Settings::default() };
    let any = strut_friction(by_name("Dahl").unwrap(), &test, &options, &task, watch(&never)).unwrap();
    let (mut laws, mut wrong) = (0, Vec::new());
    for (law, _) in stribeck::catalogue::documented(stribeck::catalogue::Family::Friction) {
        // The bonds of Bristle snap at random, each contact's at other times. The strut bounds what a bristle carries by
        // the static level, which BlimanSorine does not have.
        let Ok(chosen) = ssp::parameter_set::choice(strut, "friction.model", law.name) else { continue };
        if ["None", "Bristle", "BlimanSorine"].contains(&law.name) {
            continue;
        }
        let estimates = changed(law);
        let known = estimates.clone();
        let mut found = StrutFriction {
            damper: any.damper.clone(),
            fit: Fit { law, estimates, ..any.fit.clone() },
            values: vec![("friction.model".to_owned(), chosen)],
            left: Vec::new(),
            load: LOAD,
        };
        found.transfer(strut, 0.1).unwrap();
        let (_, given) = driven(&found.values, 0.0, 1);
        let alone = alone(law, &known, LOAD);
        let level = alone.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let apart = given.iter().zip(&alone).fold(0.0, |most: f64, (a, b)| most.max((a + b).abs()));
        if !(level > 1.0 && apart < 1e-9 * level) {
            wrong.push(format!("{}: {apart} N of {level} N", law.name));
        }
        laws += 1;
    }
    assert!(wrong.is_empty(), "{wrong:?}");
    assert!(laws >= 30, "{laws}");
}

/// Values of the parameters of a law that are not those it starts with, as if they had been found.
fn changed(law: &'static ModelType) -> Vec<Estimate> {
    let parameters = law.variables().filter(|(_, variable)| {
        variable.role.is_parameter() && matches!(variable.kind, Kind::Real(_)) && !variable.is_hidden
    });
    let estimate = |(column, variable): (usize, Variable)| Estimate {
        value: match variable.path.to_string().as_str() {
            name if viscous(law).iter().any(|one| one == name) => 0.0,
            // Shares of elements add up.
            name if name.contains('[') => variable.start,
            _ => 1.2 * variable.start,
        },
        name: variable.path.to_string(),
        unit: if let Kind::Real(unit) = variable.kind { unit.name } else { "" },
        target: Target::Column(column),
        meaning: variable.meaning,
        deviation: 0.0,
        verdict: Verdict::Determined,
        linear: [0.0; 2],
        profile: None,
        repeated: None,
    };
    parameters
        .filter(|(_, variable)| !["mass", "external_force"].contains(&variable.path.to_string().as_str()))
        .map(estimate)
        .filter(|one| law.table.at(law.find(&one.name).unwrap()).admits(one.value))
        .collect()
}

/// Friction force of a law over the course.
fn alone(law: &'static ModelType, values: &[Estimate], load: f64) -> Vec<f64> {
    let mut instance = Instance::new(law);
    let columns = values.iter().map(|one| (law.find(&one.name).unwrap(), one.value));
    instance.set_all(Phase::Setup, columns).unwrap();
    let [velocity, normal_force, force] =
        ["velocity", "normal_force", "friction_force"].map(|name| law.find(name).unwrap());
    instance.set_column(normal_force, load).unwrap();
    instance.step(1e-9).unwrap();
    let mut before = [0.0, 0.0];
    let one = |[time, v]: [f64; 2]| {
        if time > before[0] {
            instance.set_column(velocity, 0.5 * (before[1] + v)).unwrap();
            instance.step(time - before[0]).unwrap();
        }
        instance.set_column(velocity, v).unwrap();
        before = [time, v];
        instance.get_column(force).unwrap()
    };
    course().into_iter().map(one).collect()
}

#[test]
fn tests_without_times_or_slow_strokes_are_refused() {
    let (test, _) = driven(&strut_values("LuGre", &[]), 0.0, 1);
    let options = Options { gas_force: Some(0.0), ..Options::default() };
    let never = AtomicBool::new(false);
    let refusal = |law: &str, test: &Test, options: &Options| {
        let law = by_name(law).unwrap();
        let found = strut_friction(law, test, options, &Settings::default(), watch(&never));
        found.map(|_| ()).unwrap_err().to_string()
    };
    let timeless = Test { time: None, ..test.clone() };
    assert_eq!(refusal("LuGre", &timeless, &options), "no column 'time': a friction law needs it");
    let mut backwards = test.clone();
    backwards.time.as_mut().unwrap()[5] = 0.0;
    assert!(refusal("LuGre", &backwards, &options).starts_with("row 6, time: 0 s after "));
    let slower = Options { low_speed: 0.005, ..options };
    assert!(refusal("LuGre", &test, &slower).starts_with("no strokes at up to 0.005 m/s that turn at least twice"));
    assert!(refusal("RollingResistance", &test, &options).contains("RollingResistance"));
}
