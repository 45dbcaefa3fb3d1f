//! At loose tolerances, too, a run is right or says that it is not. `cargo bench --bench tolerances` draws many more systems.

use stribeck_solve::run::Solver;

#[path = "common/drawn.rs"]
mod drawn;
use drawn::{Case, Tally, laws, tallies};

/// Sets of parameters for each law: the defaults and two drawn ones.
const DRAWS: usize = 3;

/// Law whose motion, with some parameters, amplifies every error: see docs/benchmark.md.
const AMPLIFIES: &str = "BlimanSorine";

fn check(solver: Solver, tolerances: &[f64]) {
    for case in [Case { system: "belt", until: 20.0 }, Case { system: "pulled-mass", until: 5.0 }] {
        let mut all = Tally::default();
        for law in laws().filter(|law| *law != AMPLIFIES) {
            let found = tallies(case, law, DRAWS, solver, tolerances, |wrong| panic!("{wrong}"));
            found.into_iter().flatten().for_each(|tally| all += tally);
        }
        println!("{}: {} runs, {} not reached", case.system, all.runs, all.refused);
        assert!(all.runs > 40 * tolerances.len() && all.refused * 20 < all.runs, "{}", all.runs);
    }
}

#[test]
fn rodas5p_is_right_at_every_tolerance() {
    check(Solver::Rodas5P, &[1e-3, 1e-4, 1e-5, 1e-7]);
}

/// At 1e-3 the errors of its many steps add up to as much as a tenth of the amplitude.
#[test]
fn rosenbrock23_is_right_from_1e_4_on() {
    check(Solver::Rosenbrock23, &[1e-4, 1e-6]);
}
