//! Passivity: where a law says that it can give energy back, and with which value it cannot.

use super::{axes, friction_models, parameter_sets, pick, set_velocity};
use crate::common::Bench;
use crate::common::random::Random;

fn said(bench: &Bench) -> Option<String> {
    bench.instance.model().passivity(bench.instance.row()).map(|fault| fault.to_string())
}

/// The parameter that a text names, and the value that it gives as the limit.
fn limit(text: &str) -> (String, f64) {
    let words: Vec<&str> = text.split_whitespace().collect();
    let after = |word: &str| words.iter().position(|one| *one == word).map(|at| words[at + 1..].to_vec());
    let value = after("below").map_or_else(|| after("above").unwrap()[2], |rest| rest[0]);
    (words[0].to_owned(), value.parse().unwrap())
}

/// Least energy that a law has dissipated in random motions that jump, from its start values.
fn least_energy(bench: &Bench, motions: usize) -> f64 {
    let (saved, mut random, mut least) = (bench.instance.save(), Random(41), 0.0f64);
    let mut moved = Bench::new(bench.instance.model().name, &[]);
    for _ in 0..motions {
        moved.instance.restore(&saved);
        // Up to full stiction, slowly, in which the contact stores the most.
        set_velocity(&mut moved, 1e-5);
        moved.step(10.0);
        for _ in 0..20 {
            let speed = 10f64.powf(-5.0 + 5.0 * random.next());
            set_velocity(&mut moved, speed * pick(&mut random, &[-1.0, 1.0]));
            moved.step(10f64.powf(-7.0 + 4.0 * random.next()));
            least = least.min(moved.get("dissipated_energy"));
        }
    }
    least
}

/// With the value that a law names it says nothing, and takes energy out of all motions that were tried.
#[test]
fn the_value_that_a_law_names_keeps_it_passive() {
    let (mut named, mut laws) = (0, Vec::new());
    for model in friction_models() {
        for set in parameter_sets(model).iter().take(60) {
            let mut bench = Bench::new(model.name, &[]);
            super::apply(&mut bench, set);
            let Some(text) = said(&bench) else { continue };
            if text.starts_with("mu_k = 0: ") {
                assert_eq!(bench.get("mu_k"), 0.0, "{}", model.name);
                continue;
            }
            let (name, value) = limit(&text);
            bench.set(&name, value);
            assert_eq!(said(&bench), None, "{} after {text}", model.name);
            if bench.instance.check().is_ok() && axes(&bench).len() == 1 {
                let energy = least_energy(&bench, 3);
                assert!(energy >= -1e-15, "{}: {energy} J after {text}", super::describe(model, set));
            }
            named += 1;
            laws.push(model.name);
        }
    }
    laws.dedup();
    assert!(named > 200 && laws.len() >= 7, "{named} {laws:?}");
}

/// Bristles that are deflected up to the static level, and then moved by 0.1 m/s: the damping pushes by
/// sigma_1 (f_s / f_C - 1) v, more than the bristles and the viscous part take.
#[test]
fn start_values_that_are_not_passive_give_energy_back() {
    let active = ["LuGre", "ElastoPlastic", "Leuven", "CylinderFriction"].map(|name| (name, true));
    for (name, is_said) in active.into_iter().chain([("Dahl", false), ("Coulomb", false)]) {
        let mut bench = Bench::new(name, &[]);
        assert_eq!(said(&bench).is_some(), is_said, "{name}");
        assert_eq!(bench.instance.warning_or_passivity().is_some(), is_said, "{name}");
        set_velocity(&mut bench, 1e-5);
        bench.step(1e4);
        set_velocity(&mut bench, 0.1);
        assert_eq!(bench.get("dissipated_power") < 0.0, is_said, "{name}");
    }
}
