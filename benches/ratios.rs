//! Ratios of Stribeck's cost to that of the same law in plain C, measured in one run.
//!
//! Absolute times on a shared machine wander by tens of percent; a ratio taken within a round of a few milliseconds does
//! not. Each round runs both sides, in alternating order, and counts processor time; the median over the rounds is
//! reported.

mod support;

use cpu_time::ThreadTime;

use support::Slave;

/// Odd, so that the median is one of the rounds.
const ROUNDS: usize = 31;
const CALLS: usize = 100_000;

/// The laws that exist in C too: the model's name, and the file in `benches/floor`.
const PAIRS: [(&str, &str); 2] = [("BrownMcPhee", "brown_mcphee"), ("LuGre", "lugre")];

fn main() {
    let library = support::build_release_library();
    println!("set 2 inputs + step + get 2 outputs, {ROUNDS} rounds of {CALLS} calls; median ratio [quartiles]\n");
    println!(
        "{:14} {:>9} {:>9} {:>24} {:>24}",
        "model", "ours, ns", "C, ns", "ours / same law in C", "ours / calls alone"
    );
    for (model, law) in PAIRS {
        let mut ours = Slave::ours(&library, model);
        let same = compare(&mut ours, &mut Slave::floor(law));
        let alone = compare(&mut ours, &mut Slave::floor("trivial"));
        println!("{model:14} {:9.1} {:9.1} {:>24} {:>24}", same.ours, same.theirs, same.ratio(), alone.ratio());
    }
}

/// Quartiles of the ratio, and median times of a call in nanoseconds.
struct Comparison {
    ours: f64,
    theirs: f64,
    quartiles: [f64; 3],
}

impl Comparison {
    fn ratio(&self) -> String {
        let [low, median, high] = self.quartiles;
        format!("{median:.2} [{low:.2}, {high:.2}]")
    }
}

fn compare(ours: &mut Slave, theirs: &mut Slave) -> Comparison {
    let velocities = support::velocities();
    // One round to warm up: pages, caches, branch predictors.
    nanoseconds_per_call(ours, &velocities);
    nanoseconds_per_call(theirs, &velocities);
    let rounds: Vec<(f64, f64)> = (0..ROUNDS)
        .map(|round| {
            if round % 2 == 0 {
                let first = nanoseconds_per_call(ours, &velocities);
                (first, nanoseconds_per_call(theirs, &velocities))
            } else {
                let first = nanoseconds_per_call(theirs, &velocities);
                (nanoseconds_per_call(ours, &velocities), first)
            }
        })
        .collect();
    let quartile = |of: fn(&(f64, f64)) -> f64, quarter: usize| {
        let mut sorted: Vec<f64> = rounds.iter().map(of).collect();
        sorted.sort_by(f64::total_cmp);
        sorted[quarter * (ROUNDS - 1) / 4]
    };
    Comparison {
        ours: quartile(|round| round.0, 2),
        theirs: quartile(|round| round.1, 2),
        quartiles: [1, 2, 3].map(|quarter| quartile(|(ours, theirs)| ours / theirs, quarter)),
    }
}

fn nanoseconds_per_call(slave: &mut Slave, velocities: &[f64]) -> f64 {
    let (mut sum, mut refused) = (0.0, 0);
    let start = ThreadTime::now();
    for velocity in velocities.iter().cycle().take(CALLS) {
        let ([force, power], status) = slave.round_trip(*velocity);
        sum += force + power;
        refused |= status;
    }
    let elapsed = start.elapsed();
    assert!(refused == 0 && f64::is_finite(sum), "a call was refused");
    elapsed.as_secs_f64() * 1e9 / CALLS as f64
}
