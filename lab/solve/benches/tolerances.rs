//! How often a run that says that it reached its end is wrong: every law that has rates, drawn parameters, tolerances from
//! 1e-3 to 1e-10, on four systems, against two methods at 1e-11 that agree.
//!
//! Arguments are the number of draws (200) and names of laws (all).

use stribeck_solve::run::Solver;

#[path = "../tests/common/drawn.rs"]
mod drawn;
use drawn::{Case, Tally, laws, tallies};

const CASES: [Case; 4] = [
    Case { system: "belt", until: 20.0 },
    Case { system: "pulled-mass", until: 5.0 },
    Case { system: "two-blocks", until: 1.0 },
    Case { system: "quarter-car", until: 1.0 },
];

/// Left out: once the blocks move together, this law acts on a relative velocity of 1e-32 m/s, which is the difference of
/// two velocities of 0.5 m/s. Rounding errors decide on its force, and a run hardly proceeds.
const LEFT_OUT: (&str, &str) = ("two-blocks", "RateAndState");

const TOLERANCES: [f64; 8] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let draws = arguments.first().and_then(|argument| argument.parse().ok()).unwrap_or(200);
    let wanted: Vec<&str> = arguments.iter().skip(1).map(String::as_str).collect();
    for case in CASES {
        let mut all = [Tally::default(); TOLERANCES.len()];
        for law in laws().filter(|law| wanted.is_empty() || wanted.contains(law)) {
            if (case.system, law) == LEFT_OUT {
                println!("  {law:20} left out: its force is decided by rounding errors once the blocks move together");
                continue;
            }
            let spoil = |wrong: String| println!("  {wrong}");
            let Some(found) = tallies(case, law, draws, Solver::Rodas5P, &TOLERANCES, spoil) else {
                println!("  {law:20} left out: not solved by its rates there, or not by the solver of the reference");
                continue;
            };
            let off: Vec<String> = found.iter().map(|tally| format!("{}/{}", tally.gross, tally.off)).collect();
            println!("  {law:20} {:4} runs at each; gross / off: {}", found[0].runs, off.join(" "));
            all.iter_mut().zip(found).for_each(|(all, tally)| *all += tally);
        }
        println!("{}, {} s, {} draws of each law", case.system, case.until, draws);
        for (tolerance, Tally { runs, off, gross, refused }) in TOLERANCES.iter().zip(all) {
            println!(
                "  {tolerance:e}: {runs} runs, {refused} not reached, {off} off by more than 1,000 tolerances, {gross} by \
                 more than a twentieth"
            );
        }
    }
}
