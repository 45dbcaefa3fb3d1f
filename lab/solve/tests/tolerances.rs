//! At loose tolerances, too, a run is right or says that it is not. `cargo bench --bench tolerances` draws many more systems.

use stribeck_solve::run::Solver;

#[path = "common/drawn.rs"]
mod drawn;
use drawn::{Case, Tally, laws, tallies};

/// Sets of parameters for each law: the defaults and two drawn ones.
const DRAWS: usize = 3;

fn check(solver: Solver, tolerances: &[f64]) {
    for case in [Case { system: "belt", until: 20.0 }, Case { system: "pulled-mass", until: 5.0 }] {
        let mut all = Tally::default();
        for law in laws() {
            let found = tallies(case, law, DRAWS, solver, tolerances, |wrong| panic!("{wrong}"));
            found.into_iter().flatten().for_each(|tally| all += tally);
        }
        println!("{}: {} runs, {} not reached, {} off", case.system, all.runs, all.refused, all.off);
        assert!(all.runs > 40 * tolerances.len() && all.refused * 20 < all.runs, "{}", all.runs);
        assert!(all.off * 100 <= all.runs, "{} of {}", all.off, all.runs);
    }
}

#[test]
fn rodas5p_is_right_at_every_tolerance() {
    check(Solver::Rodas5P, &[1e-3, 1e-4, 1e-5, 1e-7]);
}

#[test]
fn rosenbrock23_is_right_at_loose_tolerances() {
    check(Solver::Rosenbrock23, &[1e-3, 1e-4, 1e-5, 1e-6]);
}
