//! Ratios of Stribeck's cost to that of the same law in plain C, measured in one run.
//!
//! There are two kinds of runs. *Coupled*, as in co-simulation: the next velocity depends on the force just read, so
//! one call cannot begin before the last one has ended; this measures the time from input to output. *Replay* uses
//! velocities that are known in advance: the processor then overlaps several calls, if they are short enough; this
//! measures the number of instructions. Both sides do the same work in both.
//!
//! Absolute times on a shared machine drift by tens of percent; a ratio measured within a round of a few milliseconds
//! does not. Each round runs both sides, in alternating order, and counts processor time; the median over the rounds is
//! reported.

mod support;

use cpu_time::ThreadTime;

use support::Slave;

/// Odd, so that the median is one of the rounds.
const ROUNDS: usize = 31;
const CALLS: usize = 100_000;

/// The laws that also exist in C: the model's name, and the file in `benches/floor`.
const PAIRS: [(&str, &str); 2] = [("BrownMcPhee", "brown_mcphee"), ("LuGre", "lugre")];

#[derive(Clone, Copy, Debug)]
enum Run {
    Coupled,
    Replay,
}

fn main() {
    let library = support::library();
    println!("set 2 inputs + step + get 2 outputs, {ROUNDS} rounds of {CALLS} calls; median ratio [quartiles]\n");
    println!(
        "{:12} {:8} {:>8} {:>8} {:>22} {:>22}",
        "model", "run", "ours, ns", "C, ns", "ours / same law in C", "ours / calls alone"
    );
    for (model, law) in PAIRS {
        for run in [Run::Coupled, Run::Replay] {
            let mut ours = Slave::ours(&library, model);
            let same = compare(run, &mut ours, &mut Slave::floor(law));
            let alone = compare(run, &mut ours, &mut Slave::floor("trivial"));
            let (kind, times) = (format!("{run:?}").to_lowercase(), format!("{:8.1} {:8.1}", same.ours, same.theirs));
            println!("{model:12} {kind:8} {times} {:>22} {:>22}", same.ratio(), alone.ratio());
        }
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

fn compare(run: Run, ours: &mut Slave, theirs: &mut Slave) -> Comparison {
    let velocities = support::velocities();
    // One round to warm up: pages, caches, branch predictors.
    nanoseconds_per_call(run, ours, &velocities);
    nanoseconds_per_call(run, theirs, &velocities);
    let mut rounds = Vec::with_capacity(ROUNDS);
    for round in 0..ROUNDS {
        let mut times = [0.0; 2];
        // The side that runs first in one round runs second in the next.
        for side in [round % 2, 1 - round % 2] {
            let slave = if side == 0 { &mut *ours } else { &mut *theirs };
            times[side] = nanoseconds_per_call(run, slave, &velocities);
        }
        rounds.push(times);
    }
    let quartile = |of: fn(&[f64; 2]) -> f64, quarter: usize| {
        let mut sorted: Vec<f64> = rounds.iter().map(of).collect();
        sorted.sort_by(f64::total_cmp);
        sorted[quarter * (ROUNDS - 1) / 4]
    };
    Comparison {
        ours: quartile(|[ours, _]| *ours, 2),
        theirs: quartile(|[_, theirs]| *theirs, 2),
        quartiles: [1, 2, 3].map(|quarter| quartile(|[ours, theirs]| ours / theirs, quarter)),
    }
}

fn nanoseconds_per_call(run: Run, slave: &mut Slave, velocities: &[f64]) -> f64 {
    match run {
        // Far below rounding, but the processor does not know that: it has to wait for the force.
        Run::Coupled => timed(slave, velocities, |velocity, force| velocity + 1e-300 * force),
        Run::Replay => timed(slave, velocities, |velocity, _| velocity),
    }
}

fn timed(slave: &mut Slave, velocities: &[f64], next: impl Fn(f64, f64) -> f64) -> f64 {
    let (mut last, mut sum, mut refused) = (0.0, 0.0, 0);
    let start = ThreadTime::now();
    for velocity in velocities.iter().cycle().take(CALLS) {
        let ([force, power], status) = slave.round_trip(next(*velocity, last));
        last = force;
        sum += force + power;
        refused |= status;
    }
    let elapsed = start.elapsed();
    assert!(refused == 0 && f64::is_finite(sum), "a call failed");
    elapsed.as_secs_f64() * 1e9 / CALLS as f64
}
