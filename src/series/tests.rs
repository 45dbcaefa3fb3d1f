//! Series against closed forms, and against an instance that is stepped by hand.

use super::*;
use crate::catalogue::{Family, by_name, documented};

static NEVER: AtomicBool = AtomicBool::new(false);

fn column(instance: &Instance, name: &str) -> usize {
    instance.model().find(name).unwrap()
}

/// A contact that follows a velocity over 1000 samples of a millisecond.
fn forces(law: &str, between: Between, velocity: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut instance = Instance::new(by_name(law).unwrap());
    let velocities: Vec<f64> = (0..1000).map(|sample| velocity(f64::from(sample) * 1e-3)).collect();
    let [v, load, force] = ["velocity", "normal_force", "friction_force"].map(|name| column(&instance, name));
    let inputs = [Input { column: v, samples: &velocities }, Input { column: load, samples: &[10.0] }];
    let course = Course { inputs: &inputs, times: Times::Every(1e-3), samples: 1000, between };
    let mut row = vec![0.0; 1000];
    follow(&mut instance, &course, &[force], &mut [&mut row], &NEVER).unwrap();
    row
}

/// Dahl's law with exponent 1 at a rising displacement x: f = f_C (1 - exp(-sigma_0 x / f_C)), whatever the velocity. With
/// held inputs the displacement is off by half a step.
#[test]
fn dahls_curve_over_a_ramp_of_the_velocity() {
    let law = by_name("Dahl").unwrap();
    let start = |name: &str| law.table.at(law.find(name).unwrap()).start;
    let level = 10.0 * start("mu_k");
    let slope = 2.0 * level / start("sigma_0");
    for (between, tolerance) in [(Between::Linear, 1e-12), (Between::Held, 2e-3)] {
        let row = forces("Dahl", between, |time| slope * time);
        for (sample, force) in row.iter().enumerate() {
            let time = sample as f64 * 1e-3;
            let displacement = 0.5 * slope * time * time;
            let exact = level * (1.0 - (-start("sigma_0") * displacement / level).exp());
            assert!((force - exact).abs() < tolerance * level, "{between:?} {time}: {force} {exact}");
        }
    }
}

#[test]
fn refusals_name_the_sample() {
    let mut instance = Instance::new(by_name("LuGre").unwrap());
    let (v, force) = (column(&instance, "velocity"), column(&instance, "friction_force"));
    let inputs = [Input { column: v, samples: &[0.0, 1e-3, f64::NAN] }];
    let course = Course { inputs: &inputs, times: Times::At(&[0.0, 0.1, 0.3]), samples: 3, between: Between::Held };
    let ended = follow(&mut instance, &course, &[force], &mut [&mut [0.0; 3]], &NEVER).unwrap_err();
    assert_eq!(ended.to_string(), "sample 2 (t = 0.3 s): velocity = NaN: must be a finite number");
    assert_eq!(instance.time(), 0.0, "nothing has run");
    let mu = column(&instance, "mu_k");
    assert_eq!(set_up(&mut instance, &[(mu, -1.0)]).unwrap_err().to_string(), "mu_k = -1: must be > 0 and finite");
}

/// The Stribeck curve of LuGre, g(v) + sigma_2 v, by hand.
#[test]
fn settled_force_of_lugre() {
    let law = by_name("LuGre").unwrap();
    let start = |name: &str| law.table.at(law.find(name).unwrap()).start;
    for v in [1e-9, 1e-5, 1e-3, 0.2, -30.0] {
        let mut instance = Instance::new(law);
        let [velocity, load, force] =
            ["velocity", "normal_force", "friction_force"].map(|name| column(&instance, name));
        let mut settled = [0.0];
        settle(&mut instance, &[(velocity, v), (load, 10.0)], &[force], &mut settled, &NEVER).unwrap();
        let fade = (-(f64::abs(v) / start("stribeck_velocity")).powf(start("stribeck_exponent"))).exp();
        let g = 10.0 * (start("mu_k") + (start("mu_s") - start("mu_k")) * fade);
        let exact = g * v.signum() + start("viscous_coefficient") * v;
        assert!((settled[0] - exact).abs() < 1e-8 * exact.abs(), "{v}: {} {exact}", settled[0]);
    }
}

/// Only the bristles that snap at random keep fluctuating.
#[test]
fn forces_of_all_other_laws_settle() {
    for (law, _) in documented(Family::Friction) {
        let mut instance = Instance::new(law);
        let along = |name: &str| law.find(name).or_else(|| law.find(&format!("{name}_x"))).unwrap();
        let (velocity, force) = (along("velocity"), along("friction_force"));
        let inputs = [(velocity, 0.3), (column(&instance, "normal_force"), 10.0)];
        let mut settled = [0.0];
        let result = settle(&mut instance, &inputs, &[force], &mut settled, &NEVER);
        assert_eq!(result.is_err(), law.name == "Bristle", "{}: {result:?}", law.name);
        assert!(result.is_err() || settled[0] > 0.0, "{}: {settled:?}", law.name);
    }
}

/// A contact at rest has settled from the beginning, and an unsettled one can be left.
#[test]
fn rest_settles_and_settling_can_be_cancelled() {
    let mut instance = Instance::new(by_name("LuGre").unwrap());
    let [velocity, load, force] = ["velocity", "normal_force", "friction_force"].map(|name| column(&instance, name));
    let mut settled = [1.0];
    settle(&mut instance, &[(velocity, 0.0), (load, 10.0)], &[force], &mut settled, &NEVER).unwrap();
    assert_eq!(settled, [0.0]);
    // A law without a closed form.
    let mut instance = Instance::new(by_name("Leuven").unwrap());
    let [velocity, force] = ["velocity", "friction_force"].map(|name| column(&instance, name));
    let ended = settle(&mut instance, &[(velocity, 0.1)], &[force], &mut settled, &AtomicBool::new(true)).unwrap_err();
    assert_eq!(ended.to_string(), "cancelled");
}
