//! Orders of the solvers: slopes of error over number of steps.

use std::sync::atomic::AtomicBool;

use stribeck_solve::run::{Settings, Solver as Name};
use stribeck_solve::solve::{
    End, Equations, Foreign, Grid, Method, Options, Recorder, Statistics, solve, solve_foreign,
};
use stribeck_solve::system::{Motion, Source, System};

#[path = "common/stick_slip.rs"]
mod stick_slip;
use stick_slip::StickSlip;

/// Any of the solvers.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Solver {
    Own(Method),
    Other(Foreign),
}

const RODAS5P: Solver = Solver::Own(Method::Rodas5P);
const ROSENBROCK23: Solver = Solver::Own(Method::Rosenbrock23);
const DOPRI5: Solver = Solver::Other(Foreign::Dopri5);
const DOP853: Solver = Solver::Other(Foreign::Dop853);
const BDF: Solver = Solver::Other(Foreign::Bdf);
const TR_BDF2: Solver = Solver::Other(Foreign::TrBdf2);
const ESDIRK34: Solver = Solver::Other(Foreign::Esdirk34);

/// A mass on a spring with preload, x'' = -x - a sgn(x): harmonic between passages through zero, where the
/// acceleration jumps by 2 a. Without preload it is an oscillator.
struct Preloaded {
    preload: f64,
    /// Sign of x, which changes at events only.
    side: Option<f64>,
}

const PRELOAD: f64 = 0.5;

impl Preloaded {
    /// From zero at unit velocity: x = sin t - a (1 - cos t) until 2 arctan(1 / a), then the same downwards, and so on.
    fn exact(&self, time: f64) -> f64 {
        let half = 2.0 * (1.0 / self.preload).atan();
        let (count, since) = ((time / half).floor(), time % half);
        let x = since.sin() - self.preload * (1.0 - since.cos());
        if count % 2.0 == 0.0 { x } else { -x }
    }
}

impl Equations for Preloaded {
    fn states(&self) -> usize {
        2
    }

    fn state_name(&self, state: usize) -> String {
        format!("x{state}")
    }

    fn scales(&self) -> &[f64] {
        &[1.0, 1.0]
    }

    fn rates(&mut self, _time: f64, x: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&[x[1], -x[0] - self.preload * self.side.unwrap_or(x[0].signum())]);
    }

    fn jacobian(&mut self, _time: f64, _x: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        jacobian.copy_from_slice(&[0.0, 1.0, -1.0, 0.0]);
        by_time.fill(0.0);
    }

    fn indicators(&self) -> usize {
        usize::from(self.side.is_some())
    }

    fn indicator_name(&self, _indicator: usize) -> String {
        "zero".to_owned()
    }

    fn indicate(&mut self, _time: f64, x: &[f64], indicators: &mut [f64]) {
        indicators.fill(x[0]);
    }

    fn at_event(&mut self, _time: f64, x: &mut [f64]) -> Result<(), String> {
        self.side = self.side.map(|_| x[1].signum());
        Ok(())
    }
}

/// A system that does not say that it is linear between events.
struct Curved(Motion);

impl Equations for Curved {
    fn states(&self) -> usize {
        self.0.states()
    }
    fn state_name(&self, state: usize) -> String {
        self.0.state_name(state)
    }
    fn scales(&self) -> &[f64] {
        self.0.scales()
    }
    fn rates(&mut self, time: f64, states: &[f64], rates: &mut [f64]) {
        self.0.rates(time, states, rates);
    }
    fn jacobian(&mut self, time: f64, states: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        self.0.jacobian(time, states, jacobian, by_time);
    }
    fn indicators(&self) -> usize {
        self.0.indicators()
    }
    fn indicator_name(&self, indicator: usize) -> String {
        self.0.indicator_name(indicator)
    }
    fn indicate(&mut self, time: f64, states: &[f64], indicators: &mut [f64]) {
        self.0.indicate(time, states, indicators);
    }
    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String> {
        self.0.at_event(time, states)
    }
}

fn run(solver: Solver, equations: &mut dyn Equations, states: &mut [f64], options: &Options) -> (Statistics, Recorder) {
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: options.end, intervals: 1000 }, equations);
    let (end, statistics) = match solver {
        Solver::Own(method) => solve(method, equations, states, options, &mut recorder),
        Solver::Other(foreign) => solve_foreign(foreign, equations, states, options, &mut recorder),
    };
    assert_eq!(end, End::Reached, "{solver:?}");
    assert_eq!(recorder.len(), 1001, "{solver:?}");
    (statistics, recorder)
}

/// Steps and largest error.
fn preloaded(solver: Solver, preload: f64, side: Option<f64>, options: &Options) -> (f64, f64) {
    let mut equations = Preloaded { preload, side };
    let (statistics, recorder) = run(solver, &mut equations, &mut [0.0, 1.0], options);
    let exact = |time: f64| if preload == 0.0 { time.sin() } else { equations.exact(time) };
    let error = recorder.times().zip(&recorder.states[0]).map(|(time, x)| (x - exact(time)).abs()).fold(0.0, f64::max);
    (statistics.steps as f64, error)
}

/// Steps and largest error of the block on the belt that sticks and slips.
fn stick_slip(solver: Solver, options: &Options) -> (f64, f64) {
    let system = System::assemble(&Source::open("belt").unwrap(), Some("CoulombStiction"), &[]).unwrap();
    let mut motion = Motion::new(&system, &[]).unwrap();
    let position = motion.places().iter().position(|place| *place == system.place("rig.position").unwrap()).unwrap();
    let mut states = motion.start();
    let (statistics, recorder) = run(solver, &mut motion, &mut states, options);
    assert_eq!(statistics.events.len(), 9, "{solver:?} {options:?}");
    let exact = StickSlip::table_6_1();
    let of_time = recorder.times().zip(&recorder.states[position]);
    let error = of_time.map(|(time, x)| (x - exact.position(time)).abs()).fold(0.0, f64::max);
    (statistics.steps as f64, error)
}

/// Slope of the straight line through logarithms, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<(f64, f64)> = points.iter().map(|(steps, error)| (steps.ln(), error.ln())).collect();
    let count = logarithms.len() as f64;
    let (x, y) = logarithms.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
    let (above, below) = logarithms.iter().fold((0.0, 0.0), |(above, below), point| {
        (above + (point.0 - x) * (point.1 - y), below + (point.0 - x).powi(2))
    });
    above / below
}

/// Fixed steps: the tolerance lets all of them pass.
fn fixed(longest: f64, end: f64, events: bool) -> Options<'static> {
    Options { longest, events, ..Options::new(end, 1e3) }
}

/// Equal ratios from a longest step.
fn lengths(longest: f64) -> impl Iterator<Item = f64> {
    (0..8).map(move |number| longest * 0.8f64.powi(number))
}

/// Tolerances from 1e-5 to 1e-9.
fn tolerances() -> impl Iterator<Item = f64> {
    (10..=18).map(|number| 10f64.powf(-0.5 * f64::from(number)))
}

/// An order more or less would be a slope more or less. The motion is linear and its steps not yet short, which may make
/// the slope steeper by part of an order.
fn assert_order(solver: Solver, what: &str, order: f64, points: &[(f64, f64)]) {
    let slope = -slope(points);
    assert!(slope > order - 0.3 && slope < order + 0.9, "{solver:?}, {what}: order {slope:.2}: {points:?}");
}

/// By fixed steps; those of diffsol by tolerances, since it solves the equations of a stage to a part of the tolerance.
#[test]
fn errors_fall_with_the_order_where_events_are_located() {
    for (solver, order, longest) in [(RODAS5P, 5.0, 0.25), (ROSENBROCK23, 2.0, 0.1), (DOPRI5, 5.0, 0.25)] {
        let points = |preload: f64, side: Option<f64>| -> Vec<(f64, f64)> {
            lengths(longest).map(|h| preloaded(solver, preload, side, &fixed(h, 20.0, true))).collect()
        };
        assert_order(solver, "oscillator", order, &points(0.0, None));
        assert_order(solver, "preload", order, &points(PRELOAD, Some(1.0)));
        let belt: Vec<(f64, f64)> = lengths(longest).map(|h| stick_slip(solver, &fixed(h, 40.0, true))).collect();
        if solver == RODAS5P {
            // Exact: what is left is that the law holds up to a force that is 1e-11 above its limit.
            assert!(belt.iter().all(|(_, error)| *error < 1e-10), "{belt:?}");
        } else {
            assert_order(solver, "stick-slip", order, &belt);
        }
    }
    for (solver, order) in [(TR_BDF2, 2.0), (ESDIRK34, 3.0)] {
        let points = |preload: f64, side: Option<f64>| -> Vec<(f64, f64)> {
            tolerances().map(|tolerance| preloaded(solver, preload, side, &Options::new(20.0, tolerance))).collect()
        };
        assert_order(solver, "oscillator", order, &points(0.0, None));
        assert_order(solver, "preload", order, &points(PRELOAD, Some(1.0)));
        let belt: Vec<(f64, f64)> = tolerances().map(|it| stick_slip(solver, &Options::new(40.0, it))).collect();
        assert_order(solver, "stick-slip", order, &belt);
    }
    let smooth: Vec<(f64, f64)> = lengths(1.2).map(|h| preloaded(DOP853, 0.0, None, &fixed(h, 20.0, false))).collect();
    assert_order(DOP853, "oscillator", 8.0, &smooth);
}

/// A coarse tolerance changes nothing. Events and motions, against the closed form and steps of order 5.
#[test]
fn laws_made_of_straight_lines_are_solved_exactly() {
    let belt = |law: &str| {
        let system = System::assemble(&Source::open("belt").unwrap(), Some(law), &[]).unwrap();
        Motion::new(&system, &[]).unwrap()
    };
    let solved = |equations: &mut dyn Equations, start: &[f64], tolerance: f64| {
        let (statistics, recorder) = run(RODAS5P, equations, &mut start.to_vec(), &Options::new(40.0, tolerance));
        let events: Vec<f64> = statistics.events.iter().map(|event| event.time).collect();
        (events, recorder.states.concat())
    };
    let exact = |law: &str, tolerance: f64| {
        let mut motion = belt(law);
        let start = motion.start();
        solved(&mut motion, &start, tolerance)
    };
    let worst = |a: &[f64], b: &[f64]| {
        assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    // First slip, first stick and so on of Coulomb friction with stiction. The law itself holds up to a force that is
    // 1e-11 above its limit.
    let (period, slip) = (7.523_422_246_570, 2.618_422_246_570);
    let expected: Vec<f64> =
        (0..9).map(|n| 7.3575 + period * f64::from(n / 2) + if n % 2 == 1 { slip } else { 0.0 }).collect();
    let (found, _) = exact("CoulombStiction", 1e-3);
    assert!(worst(&found, &expected) < 1e-9, "{found:?}");
    let stuck = ["LinearStiction"].as_slice();
    // Here the block swings just up to the speed of the belt, so that it depends on the last digits which kinks it meets.
    let touching = ["Ambrosio", "Bernard"].as_slice();
    for law in [stuck, touching].concat() {
        let [coarse, fine] = [1e-3, 1e-9].map(|tolerance| exact(law, tolerance));
        let mut other = Curved(belt(law));
        let start = other.0.start();
        let other = solved(&mut other, &start, 1e-12);
        let off = [worst(&coarse.1, &fine.1), worst(&coarse.1, &other.1)];
        assert!(off[0] < 1e-9 && off[1] < 1e-7, "{law}: {off:?}");
        if stuck.contains(&law) {
            assert!(worst(&coarse.0, &other.0) < 1e-8, "{law}: {:?} {:?}", coarse.0, other.0);
        }
    }
}

/// The order of the formulas varies from 1 to 5: their error follows the tolerance.
#[test]
fn errors_of_formulas_of_variable_order_follow_the_tolerance() {
    let errors = [1e-4, 1e-6, 1e-8, 1e-10].map(|tolerance| stick_slip(BDF, &Options::new(40.0, tolerance)).1);
    assert!(errors.windows(2).all(|pair| pair[1] < pair[0] / 30.0), "{errors:?}");
}

/// A step across a jump of the acceleration errs by h, wherever in the step the jump is: the error scatters, but a slope
/// of 1 is told from one of 2.
#[test]
fn errors_fall_with_order_one_where_steps_extend_across_jumps() {
    for solver in [RODAS5P, ROSENBROCK23, DOPRI5, DOP853, TR_BDF2, ESDIRK34] {
        let lengths = || (0..16).map(|number| 0.1 * 0.8f64.powi(number));
        let across: Vec<(f64, f64)> =
            lengths().map(|h| preloaded(solver, PRELOAD, None, &fixed(h, 20.0, false))).collect();
        let slope = -slope(&across);
        assert!((slope - 1.0).abs() < 0.35, "{solver:?}: order {slope:.2}: {across:?}");
    }
}

/// Recorded positions of the block on the belt.
fn belt(law: &str, solver: Solver, tolerance: f64) -> Vec<f64> {
    let system = System::assemble(&Source::open("belt").unwrap(), Some(law), &[]).unwrap();
    let mut motion = Motion::new(&system, &[]).unwrap();
    let position = motion.places().iter().position(|place| *place == system.place("rig.position").unwrap()).unwrap();
    let mut states = motion.start();
    let options = Options { events: solver != DOP853, ..Options::new(40.0, tolerance) };
    run(solver, &mut motion, &mut states, &options).1.states.swap_remove(position)
}

/// A law that follows the past needs a solver that keeps it, and one with bonds a solver that follows them.
#[test]
fn solvers_of_other_crates_refuse_laws_that_need_more_than_rates() {
    let past = "keeps no past, which a law follows";
    let bonds = "follows no bonds that snap one by one";
    for (law, reason) in [("FrictionalLag", past), ("Armstrong", past), ("Bristle", bonds)] {
        let system = System::assemble(&Source::open("motion").unwrap(), Some(law), &[]).unwrap();
        let settings = |solver| Settings { solver, until: 0.1, ..Settings::of(&system) };
        let fault = stribeck_solve::run::run(&system, &settings(Name::Dopri5), &[]).unwrap_err().to_string();
        assert_eq!(fault, format!("solver dopri5: {reason}"));
        assert!(stribeck_solve::run::run(&system, &settings(Name::Rosenbrock23), &[]).unwrap().is_reached());
    }
}

/// Regularised and bristle laws are stiff, but have no jumps: solvers of both crates agree with ours.
#[test]
fn other_crates_agree_on_laws_without_jumps() {
    for law in ["ThrelfallModified", "BrownMcPhee", "LuGre", "Dahl"] {
        let reference = belt(law, RODAS5P, 1e-11);
        for solver in [DOPRI5, DOP853, BDF, TR_BDF2, ESDIRK34] {
            let motion = belt(law, solver, 1e-8);
            let error = motion.iter().zip(&reference).map(|(x, exact)| (x - exact).abs()).fold(0.0, f64::max);
            assert!(error < 1e-4, "{law}, {solver:?}: {error:e}");
        }
    }
}

/// x' = -k (x - u), u = min(t, 1), and NaN after a time. A second state rests, with an indicator that is always zero.
struct Follower {
    stiffness: f64,
    lost: f64,
}

impl Equations for Follower {
    fn states(&self) -> usize {
        2
    }

    fn state_name(&self, state: usize) -> String {
        ["follower", "rest"][state].to_owned()
    }

    fn scales(&self) -> &[f64] {
        &[1.0, 1.0]
    }

    fn rates(&mut self, time: f64, x: &[f64], rates: &mut [f64]) {
        let rate = -self.stiffness * (x[0] - time.min(1.0));
        rates.copy_from_slice(&[if time > self.lost { f64::NAN } else { rate }, 0.0]);
    }

    fn jacobian(&mut self, time: f64, _x: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        jacobian.copy_from_slice(&[-self.stiffness, 0.0, 0.0, 0.0]);
        by_time.copy_from_slice(&[if time < 1.0 { self.stiffness } else { 0.0 }, 0.0]);
    }

    fn indicators(&self) -> usize {
        1
    }

    fn indicator_name(&self, _indicator: usize) -> String {
        "rest".to_owned()
    }

    fn indicate(&mut self, _time: f64, x: &[f64], indicators: &mut [f64]) {
        indicators.fill(x[1]);
    }

    fn at_event(&mut self, _time: f64, _x: &mut [f64]) -> Result<(), String> {
        Ok(())
    }

    fn next_break(&self, time: f64) -> f64 {
        if time < 1.0 { 1.0 } else { f64::INFINITY }
    }
}

fn follow(solver: Foreign, mut equations: Follower, options: &Options) -> (End, Statistics, Recorder) {
    let options = Options { events: solver.has_events(), ..*options };
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: options.end, intervals: 300 }, &equations);
    let (end, statistics) = solve_foreign(solver, &mut equations, &mut [0.0, 0.0], &options, &mut recorder);
    (end, statistics, recorder)
}

const OTHERS: [Foreign; 5] = [Foreign::Dopri5, Foreign::Dop853, Foreign::Bdf, Foreign::TrBdf2, Foreign::Esdirk34];

/// With k = 1: x = t - 1 + exp(-t) until the break, then 1 - x falls as exp(-t). The zero indicator is no event.
#[test]
fn breaks_of_an_input_are_met_and_zeros_are_no_events() {
    let options = Options { longest: 0.1, ..Options::new(3.0, 1e-9) };
    for solver in OTHERS {
        let (end, statistics, recorder) = follow(solver, Follower { stiffness: 1.0, lost: f64::INFINITY }, &options);
        assert_eq!((end, statistics.events.len(), recorder.len()), (End::Reached, 0, 301), "{solver:?}");
        assert!(statistics.steps >= 30, "{solver:?}: {statistics:?}");
        for (time, x) in recorder.times().zip(&recorder.states[0]) {
            let until = time.min(1.0);
            let exact = 1.0 + (until - 2.0 + (-until).exp()) * (until - time).exp();
            assert!((x - exact).abs() < 3e-6, "{solver:?} at {time}: {x} instead of {exact}");
        }
    }
}

/// dopri5 is started anew after each 200,000 steps; x = t - 1 + exp(-t) up to 1, as above.
#[test]
fn a_run_of_many_steps_goes_on_where_it_was_started_anew() {
    let options = Options { longest: 2e-6, ..Options::new(0.9, 1e-9) };
    let equations = Follower { stiffness: 1.0, lost: f64::INFINITY };
    let (end, statistics, recorder) = follow(Foreign::Dopri5, equations, &options);
    assert!(end.is_reached() && recorder.len() == 301, "{end}");
    assert!(statistics.steps > 400_000 && statistics.steps < 460_000, "{statistics:?}");
    for (time, x) in recorder.times().zip(&recorder.states[0]) {
        assert!((x - (time - 1.0 + (-time).exp())).abs() < 1e-12, "{x} at {time}");
    }
}

#[test]
fn implicit_solvers_alone_are_fit_for_stiff_equations() {
    let stiff = || Follower { stiffness: 1e6, lost: f64::INFINITY };
    for solver in OTHERS {
        let options = Options { most_steps: 10_000, ..Options::new(3.0, 1e-6) };
        let (end, statistics, recorder) = follow(solver, stiff(), &options);
        if matches!(solver, Foreign::Dopri5 | Foreign::Dop853) {
            let End::Failed { time, reason } = end else { panic!("{solver:?}: {end}") };
            assert_eq!(reason, "more than 10000 steps");
            assert!(time > 0.0 && time < 1.0 && recorder.len() < 301, "{solver:?}: {time}");
        } else {
            assert!(end.is_reached() && statistics.steps < 1000, "{solver:?}: {end} {statistics:?}");
            assert!((recorder.states[0][300] - 1.0).abs() < 1e-5, "{solver:?}");
        }
    }
}

#[test]
fn rates_that_are_not_finite_end_a_run() {
    for solver in OTHERS {
        let (end, _, recorder) = follow(solver, Follower { stiffness: 1.0, lost: 2.0 }, &Options::new(3.0, 1e-6));
        let End::Failed { time, reason } = end else { panic!("{solver:?}: {end}") };
        assert!(reason.ends_with("the rate of follower is not finite"), "{solver:?}: {reason}");
        assert!(time > 1.5 && time <= 2.0, "{solver:?}: {time}");
        let recorded = recorder.len();
        let is_finite = recorder.states[0][..recorded].iter().all(|x| x.is_finite());
        assert!(is_finite && recorded <= 201, "{solver:?}: {recorded} times, {:?}", &recorder.states[0][..recorded]);
    }
}

#[test]
fn a_run_can_be_cancelled() {
    let flag = AtomicBool::new(true);
    for solver in OTHERS {
        let options = Options { cancel: Some(&flag), ..Options::new(3.0, 1e-6) };
        let (end, statistics, _) = follow(solver, Follower { stiffness: 1.0, lost: f64::INFINITY }, &options);
        assert!(matches!(end, End::Cancelled { .. }) && statistics.steps <= 1, "{solver:?}: {end} {statistics:?}");
    }
}

#[test]
fn what_cannot_be_run_without_events_or_with_them_is_refused() {
    for (law, solver, events, text) in [
        ("LinearStiction", Name::Dop853, true, "solver dop853: does not locate events; run it without"),
        (
            "CoulombStiction",
            Name::Bdf,
            false,
            "friction: CoulombStiction: comes to rest at an event; without events it would never stick",
        ),
    ] {
        let system = System::assemble(&Source::open("belt").unwrap(), Some(law), &[]).unwrap();
        let settings = Settings { solver, events, ..Settings::of(&system) };
        let fault = stribeck_solve::run::run(&system, &settings, &["rig.position".to_owned()]).unwrap_err();
        assert_eq!(fault.to_string(), text);
    }
}

/// A system with more states than the crate has code of its own for.
#[test]
fn other_solvers_agree_on_a_quarter_car() {
    let system = System::assemble(&Source::open("quarter-car").unwrap(), Some("LuGre"), &[]).unwrap();
    let at_end = |solver| {
        let settings = Settings { solver, tolerance: 1e-9, until: 0.05, ..Settings::of(&system) };
        let outcome = stribeck_solve::run::run(&system, &settings, &["car.body_height".to_owned()]).unwrap();
        assert!(outcome.is_reached(), "{solver}: {}", outcome.end);
        outcome.columns[0].values[50]
    };
    let expected = at_end(Name::Rodas5P);
    for solver in [Name::Dopri5, Name::Bdf, Name::TrBdf2, Name::Esdirk34, Name::Rosenbrock23] {
        let difference = at_end(solver) - expected;
        assert!(difference.abs() < 1e-8, "{solver}: {difference:e}");
    }
}
