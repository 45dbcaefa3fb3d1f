//! Time of the belt benchmark with each law: the solver alone (4,001 outputs) and with the 400,001 outputs of the thesis.
//!
//! Processor time of the thread, medians of seven runs at 1e-8.

use cpu_time::ThreadTime;
use lab::solve::{Grid, Method, Options, Recorder, Statistics, solve};
use lab::system::{Motion, Source, System};
use stribeck::catalogue::{Family, documented};

const RUNS: usize = 7;
const UNTIL: f64 = 40.0;

fn main() {
    let source = Source::open("belt").expect("a built-in system");
    println!(
        "{:20} {:>8} {:>8} {:>12} {:>12} {:>14}",
        "law", "steps", "events", "core, ms", "full, ms", "evaluation, ns"
    );
    for (law, _) in documented(Family::Friction) {
        let system = System::assemble(&source, Some(law.name), &[]).expect("a law");
        let Ok(mut motion) = Motion::new(&system, &[]) else { continue };
        let [(core, statistics), (full, _)] = [4_000, 400_000].map(|intervals| median(&mut motion, intervals));
        let Statistics { steps, evaluations, ref events, .. } = statistics;
        let each = core / evaluations as f64 * 1e9;
        let [core, full] = [core, full].map(|seconds| seconds * 1e3);
        println!("{:20} {steps:8} {:8} {core:12.3} {full:12.3} {each:14.1}", law.name, events.len());
    }
}

/// Median time of a run in s, and its statistics.
fn median(motion: &mut Motion, intervals: usize) -> (f64, Statistics) {
    let grid = Grid { begin: 0.0, end: UNTIL, intervals };
    let start = motion.start();
    let mut last = Statistics::default();
    let mut times: Vec<f64> = (0..RUNS)
        .map(|_| {
            let (mut states, mut recorder) = (start.clone(), Recorder::new(grid, motion));
            let begin = ThreadTime::now();
            last = solve(Method::Rodas5P, motion, &mut states, &Options::new(UNTIL, 1e-8), &mut recorder).1;
            begin.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[RUNS / 2], last)
}
