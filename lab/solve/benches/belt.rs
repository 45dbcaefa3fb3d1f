//! Time of the belt benchmark with each law that is solved by its rates, beside CVODE on the same equations.
//!
//! First at 1e-8: the solver alone (4,001 results) and with the 400,001 results of the thesis, and by how much the position
//! is off at most, beside `rosenbrock23` at 1e-11. Then at equal error: both
//! solvers at tolerances from 1e-3 to 1e-12, and the time, between the tolerances along a line in logarithms, at which the
//! position is off by 1e-6 m. Processor time of the thread; both solvers in turn in each round, ratios within the round,
//! medians over the rounds. Without SUNDIALS (Debian: libsundials-dev) the columns of CVODE
//! are NaN.

mod support;

use cpu_time::ThreadTime;
use stribeck::catalogue::{Family, documented};
use stribeck_solve::run::Solver;
use stribeck_solve::solve::{Grid, Method, Options, Recorder, Statistics, solve};
use stribeck_solve::system::{Motion, Source, System};
use support::Sundials;

const ROUNDS: usize = 5;
const UNTIL: f64 = 40.0;
const CORE: usize = 4_000;
const FULL: usize = 400_000;
/// Tolerance of the run by which the error at 1e-8 is found.
const REFERENCE: f64 = 1e-11;
/// Error in m at which the times are compared.
const ERROR: f64 = 1e-6;

fn main() {
    let other = Sundials::open();
    if other.is_none() {
        println!("SUNDIALS 6 is not installed (Debian: libsundials-dev): no comparison with CVODE");
    }
    println!(
        "{:20} {:>7} {:>7} {:>9} {:>9} {:>9} {:>9} | {:>9} {:>9} {:>9} {:>9} | {:>9}",
        "law",
        "steps",
        "events",
        "off, m",
        "core, ms",
        "full, ms",
        "1e-6, ms",
        "CVODE",
        "core / C",
        "full / C",
        "C at 1e-6",
        "factor"
    );
    let source = Source::open("belt").expect("a built-in system");
    // Arguments name the laws; cargo adds its own, which begin with a dash.
    let wanted: Vec<String> = std::env::args().skip(1).filter(|name| !name.starts_with('-')).collect();
    for (law, _) in documented(Family::Friction) {
        if !wanted.is_empty() && !wanted.iter().any(|name| name == law.name) {
            continue;
        }
        let system = System::assemble(&source, Some(law.name), &[]).expect("a law");
        if Solver::Auto.for_system(&system) == Solver::Steps {
            println!("{:20} by steps", law.name);
            continue;
        }
        let Ok(motion) = Motion::new(&system, &[]) else { continue };
        let place = system.place("rig.position").expect("a variable of the rig");
        let position = motion.places().iter().position(|state| *state == place).expect("a state");
        let contest = Contest { system, position, other: other.as_ref() };
        println!("{:20} {}", law.name, contest.line());
    }
}

/// Both solvers on the belt with one law.
struct Contest<'a> {
    system: System,
    /// Number of the state that is the position.
    position: usize,
    other: Option<&'a Sundials>,
}

impl Contest<'_> {
    fn line(&self) -> String {
        let mut times: [Vec<f64>; 4] = Default::default();
        let (mut statistics, mut positions) = (Statistics::default(), Vec::new());
        for _ in 0..ROUNDS {
            for (number, intervals) in [CORE, FULL].into_iter().enumerate() {
                let (time, found, counts) = self.ours(Method::Rodas5P, intervals, 1e-8);
                if intervals == CORE {
                    positions = found;
                }
                statistics = counts;
                times[number].push(time);
                times[2 + number].extend(self.theirs(intervals, 1e-8).map(|(theirs, _)| theirs));
            }
        }
        let ratio = |ours: usize| median(times[ours].iter().zip(&times[2 + ours]).map(|(a, b)| a / b).collect());
        let [core, full, core_of_other] = [0, 1, 2].map(|which| median(times[which].clone()) * 1e3);
        let Statistics { steps, ref events, .. } = statistics;
        let off = distance(&positions, &self.ours(Method::Rosenbrock23, CORE, REFERENCE).1);
        let (equal, equal_of_other) = self.at_equal_error();
        format!(
            "{steps:7} {:7} {off:9.0e} {core:9.3} {full:9.3} {equal:9.3} | {core_of_other:9.3} {:9.4} {:9.4} {equal_of_other:9.3} | {:9.1}",
            events.len(),
            ratio(0),
            ratio(1),
            equal_of_other / equal
        )
    }

    fn motion(&self) -> Motion {
        Motion::new(&self.system, &[]).expect("a law with rates")
    }

    /// Time in s, positions, statistics of a run.
    fn ours(&self, method: Method, intervals: usize, tolerance: f64) -> (f64, Vec<f64>, Statistics) {
        let grid = Grid { begin: 0.0, end: UNTIL, intervals };
        let mut motion = self.motion();
        let (mut states, mut recorder) = (motion.start(), Recorder::new(grid, &motion));
        let options = Options::new(UNTIL, tolerance);
        let begin = ThreadTime::now();
        let (end, statistics) = solve(method, &mut motion, &mut states, &options, &mut recorder);
        let time = begin.elapsed().as_secs_f64();
        assert!(end.is_reached(), "{end} at a tolerance of {tolerance:e}");
        (time, recorder.states.swap_remove(self.position), statistics)
    }

    fn theirs(&self, intervals: usize, tolerance: f64) -> Option<(f64, Vec<f64>)> {
        let other = self.other?;
        let grid = Grid { begin: 0.0, end: UNTIL, intervals };
        let mut motion = self.motion();
        let start = motion.start();
        let begin = ThreadTime::now();
        let found = other.run(&mut motion, &start, (grid, self.position), tolerance)?;
        Some((begin.elapsed().as_secs_f64(), found))
    }

    /// Times in ms at which both solvers are off by `ERROR`; NaN where one is not that good at any tolerance.
    fn at_equal_error(&self) -> (f64, f64) {
        let (_, reference, _) = self.ours(Method::Rodas5P, CORE, 1e-12);
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for exponent in 3..=12 {
            let tolerance = 10f64.powi(-exponent);
            let (mut times, mut others, mut errors) = (Vec::new(), Vec::new(), [f64::NAN; 2]);
            for _ in 0..ROUNDS {
                let (time, found, _) = self.ours(Method::Rodas5P, CORE, tolerance);
                errors[0] = distance(&found, &reference);
                times.push(time * 1e3);
                if let Some((time, found)) = self.theirs(CORE, tolerance) {
                    errors[1] = distance(&found, &reference);
                    others.push(time * 1e3);
                }
            }
            ours.push((errors[0], median(times)));
            theirs.push((errors[1], median(others)));
        }
        (time_at(&ours), time_at(&theirs))
    }
}

/// The least time at which the error is `ERROR`, between two tolerances along a line in logarithms.
fn time_at(points: &[(f64, f64)]) -> f64 {
    let between = points.windows(2).filter_map(|pair| {
        let [(coarse, before), (fine, after)] = [pair[0], pair[1]];
        let part = (coarse.ln() - ERROR.ln()) / (coarse.ln() - fine.ln());
        (coarse > ERROR && fine <= ERROR).then(|| (before.ln() + part * (after.ln() - before.ln())).exp())
    });
    // A solver that is better than that at the coarsest tolerance has the time of that one at most.
    let coarsest = points.first().filter(|(error, _)| *error <= ERROR).map(|(_, time)| *time);
    between.chain(coarsest).fold(f64::NAN, f64::min)
}

/// Largest difference of two motions.
fn distance(found: &[f64], reference: &[f64]) -> f64 {
    found.iter().zip(reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
