//! What solvers ask of a law: rates of its states, its outputs with them, its bonds.

use super::friction_models;
use crate::common::random::Random;
use crate::common::{Bench, rows};
use approx::assert_abs_diff_eq;
use stribeck::catalogue::{self, by_name};
use stribeck::friction::FrictionalLag;
use stribeck::model::{Model, Visitor, output_and_rate_in, output_in, rate_in};

/// The filtered velocity of the variant without a delay follows by (v - w) / tau_L; with a delay it has no rate.
#[test]
fn a_filtered_velocity_follows() {
    let past = [("velocity", 0.03), ("lagged_velocity", 0.01), ("has_past", 1.0), ("time_lag", 5e-3)];
    for (variant, rate) in [(1.0, 0.0), (2.0, 4.0)] {
        let bench = Bench::new("FrictionalLag", &[&past[..], &[("variant", variant)]].concat());
        let mut rates = bench.instance.row().to_vec();
        rate_in::<FrictionalLag, f64>(bench.instance.row(), &mut rates);
        assert_abs_diff_eq!(rates[bench.column("lagged_velocity")], rate, epsilon = 1e-12);
    }
}

/// One law has bonds that a solver follows.
#[test]
fn only_bristle_gives_bonds_to_a_solver() {
    let with_bonds =
        friction_models().filter(|model| model.bonds(Bench::new(model.name, &[]).instance.row()).is_some());
    assert_eq!(with_bonds.map(|model| model.name).collect::<Vec<_>>(), ["Bristle"]);
}

/// Compares outputs and rates that are computed together with those computed each by itself.
struct Together {
    random: Random,
    compared: usize,
    moving: usize,
}

impl Visitor for Together {
    fn visit<M: Model>(&mut self) {
        let model = by_name(M::NAME).expect("a model of the catalogue");
        if !model.has_rates || !friction_models().any(|law| law.name == M::NAME) {
            return;
        }
        for _ in 0..40 {
            let mut row = rows::everyday(model, &mut self.random);
            if model.memory_in_use(&row) > 0 || !model.at_event(&mut row) {
                continue;
            }
            let nothing = || vec![0.0; row.len()];
            let (mut outputs, mut rates) = (row.clone(), nothing());
            output_in::<M, f64>(&mut outputs, &[]);
            rate_in::<M, f64>(&outputs, &mut rates);
            let (mut with_rates, mut both) = (row.clone(), nothing());
            output_and_rate_in::<M, f64>(&mut with_rates, &mut both);
            self.moving += usize::from(rates.iter().any(|rate| *rate != 0.0));
            assert_eq!((outputs, rates), (with_rates, both), "{}", M::NAME);
            self.compared += 1;
        }
    }
}

/// To the last bit, after an event from drawn states.
#[test]
fn outputs_with_rates_are_both_by_themselves() {
    let mut together = Together { random: Random(3), compared: 0, moving: 0 };
    catalogue::visit(&mut together);
    assert!(together.compared > 1000 && together.moving > 900, "{} {}", together.compared, together.moving);
}
