//! The contact: symmetry, dissipation, load, sticking and sliding.

use super::{axes, for_all, force, friction_models, is_resisting_on_average, limit, set_velocity};
use crate::common::Bench;
use crate::common::random::Random;
use stribeck::model::{Meaning, ModelType};

/// Exchanges what a law has for either direction.
fn turn_round(bench: &mut Bench) {
    let names: Vec<String> =
        bench.instance.model().variables().map(|(_, variable)| variable.path.to_string()).collect();
    for (forward, line) in names.iter().filter_map(|name| Some((name, name.strip_suffix("_forward")?))) {
        let backward = format!("{line}_backward");
        let [ahead, back] = [forward, &backward].map(|name| bench.get(name));
        bench.set(forward, back);
        bench.set(&backward, ahead);
    }
}

/// The force and every other odd column change their signs when the motion is mirrored, and a law that differs by
/// direction with it; the others stay.
#[test]
fn mirrored_motion_gives_the_mirrored_force() {
    for_all(|bench, what| {
        let mut mirror = Bench::new(bench.instance.model().name, &[]);
        mirror.instance.restore(&bench.instance.save());
        turn_round(&mut mirror);
        let mut random = Random(11);
        for _ in 0..20 {
            let scale = 10f64.powf(-6.0 * random.next());
            let moving = axes(bench).into_iter().map(|(name, ..)| (name, scale));
            let odd: Vec<_> = moving.chain([("external_force", 2.0), ("acceleration", 2.0)]).collect();
            for (name, scale) in odd {
                let value = scale * random.signed();
                if bench.has(name) {
                    bench.set(name, value);
                    mirror.set(name, -value);
                }
            }
            let h = 10f64.powf(-4.0 * random.next());
            bench.step(h);
            mirror.step(h);
            bench.instance.refresh().expect("outputs");
            mirror.instance.refresh().expect("outputs");
            let is_turned = |name: &str| name.ends_with("_forward") || name.ends_with("_backward");
            let variables = || bench.instance.model().table.iter().enumerate();
            for (column, variable) in variables().filter(|(_, variable)| !is_turned(&variable.path.to_string())) {
                let (value, mirrored) = (bench.instance.row()[column], mirror.instance.row()[column]);
                let expected = if variable.is_odd { -value } else { value };
                assert_eq!(mirrored, expected, "{what}: {}", variable.path);
            }
        }
    });
}

#[test]
fn steady_sliding_dissipates_within_the_static_level() {
    for_all(|bench, what| {
        // A law that plans for a body of known mass cannot follow a velocity impossible for such a body.
        if bench.has("mass") && bench.get("mass") > 0.0 && bench.get("exchange") == 2.0 {
            return;
        }
        for velocity in [-10.0, -0.1, -2e-3, 5e-4, 1e-2, 1.0] {
            set_velocity(bench, velocity);
            // With mass the force would stop the body in a long step.
            // Otherwise it is long enough for the softest contact to yield.
            let h = if bench.has("mass") && bench.get("mass") > 0.0 { 1e-9 } else { 1e9 };
            for _ in 0..3 {
                bench.step(h);
            }
            let force = force(bench);
            assert!(force * velocity >= 0.0 || is_resisting_on_average(bench), "{what}: {force} N at {velocity} m/s");
            let limit = limit(bench, velocity);
            assert!(force.abs() <= limit * (1.0 + 1e-12), "{what}: {force} N at {velocity} m/s, limit {limit} N");
            assert!((bench.get("dissipated_power") - force * velocity).abs() <= 1e-12 * (force * velocity).abs());
        }
    });
}

/// Takes all loads from the contact, those of its own as well.
fn unload(bench: &mut Bench) {
    bench.set("normal_force", 0.0);
    for column in bench.columns_of(Meaning::Preload) {
        bench.instance.set_column(column, 0.0).unwrap();
    }
}

#[test]
fn no_load_releases_the_contact() {
    for_all(|bench, what| {
        set_velocity(bench, 0.02);
        bench.step(0.01);
        unload(bench);
        if bench.has("external_force") {
            bench.set("external_force", 3.0);
        }
        for velocity in [0.0, 0.02, -1.0] {
            set_velocity(bench, velocity);
            for (_, force, _) in axes(bench) {
                assert_eq!((bench.get(force), bench.get("sticking")), (0.0, 0.0), "{what} before a step");
            }
            bench.step(0.01);
            for (_, force, _) in axes(bench) {
                assert_eq!((bench.get(force), bench.get("sticking")), (0.0, 0.0), "{what} after a step");
            }
            for state in ["", "_x", "_y", "_z"].map(|axis| format!("bristle_deflection{axis}")) {
                if bench.has(&state) {
                    assert_eq!(bench.get(&state), 0.0, "{what}");
                }
            }
        }
    });
}

/// Laws with a band around rest report sticking inside it.
#[test]
fn a_band_around_rest_is_sticking_within_its_edge() {
    for (model, edge) in [
        ("Karnopp", "transition_velocity"),
        ("BrownMcPhee", "transition_velocity"),
        ("Hollars", "transition_velocity"),
        ("Threlfall", "transition_velocity"),
        ("Ambrosio", "sliding_velocity"),
        ("Specker", "peak_velocity"),
        ("RateAndState", "reference_velocity"),
    ] {
        let mut bench = Bench::new(model, &[]);
        let edge = bench.get(edge);
        for share in [0.01, 0.5, 0.99, 1.01, 1.5, 100.0] {
            for velocity in [share * edge, -share * edge] {
                bench.set("velocity", velocity);
                assert_eq!(bench.get("sticking") == 1.0, share < 1.0, "{model} at {velocity} m/s");
            }
        }
    }
}

/// From rest a law with bristles is elastic at first, and sticks; after a long distance it slides. Both directions are
/// equal.
#[test]
fn bristles_stick_at_first_and_slide_in_the_end() {
    let mut seen = 0;
    let has_bristles = |model: &&ModelType| model.find("sigma_0").is_some() || model.name == "BlimanSorine";
    for model in friction_models().filter(has_bristles) {
        for velocity in [1e-5, -1e-5] {
            let mut bench = Bench::new(model.name, &[]);
            set_velocity(&mut bench, velocity);
            bench.step(1e-6);
            assert_eq!(bench.get("sticking"), 1.0, "{} after 10 pm at {velocity} m/s", model.name);
            set_velocity(&mut bench, 5e3 * velocity);
            for _ in 0..1000 {
                bench.step(1e-3);
            }
            assert_eq!(bench.get("sticking"), 0.0, "{} after 50 mm towards {velocity}", model.name);
        }
        seen += 1;
    }
    assert!(seen >= 10, "{seen} laws");
}

/// Without the part caused by the load, the viscous part remains: its energy is that of a linear damper. The force of
/// Specker's dynamic law reaches it with a lag.
#[test]
fn a_loaded_contact_without_dry_friction_is_a_damper() {
    let mut seen = 0;
    let is_damped = |model: &&ModelType| model.find("viscous_coefficient").is_some() && model.name != "SpeckerDynamic";
    for model in friction_models().filter(is_damped) {
        let mut bench = Bench::new(model.name, &[("normal_force", 10.0), ("viscous_coefficient", 3.0)]);
        for name in ["mu_s", "mu_k"] {
            if model.find(name).is_some_and(|column| model.table.at(column).admits(0.0)) {
                bench.set(name, 0.0);
            }
        }
        if bench.instance.check().is_err() {
            continue;
        }
        seen += 1;
        set_velocity(&mut bench, 0.02);
        for _ in 0..4 {
            bench.step(0.125);
        }
        let (found, energy) = (bench.get("dissipated_energy"), 3.0 * 0.02 * 0.02 * 0.5);
        assert!((found - energy).abs() < 1e-12, "{}: {found} J instead of {energy} J", model.name);
        assert!((force(&mut bench) - 0.06).abs() < 1e-12, "{}", model.name);
    }
    assert!(seen >= 10, "{seen} laws");
}
