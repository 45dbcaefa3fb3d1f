//! Coupled steps against the solver that knows the rates, and against laws of conservation.

use stribeck::friction::Bristle;
use stribeck::model::Model;

use super::*;
use crate::solve::{Grid, Method, Options, Recorder, solve};
use crate::system::{Motion, Setting, Source, System, WireSource};

const GRID: Grid = Grid { begin: 0.0, end: 40.0, intervals: 4000 };

fn belt(law: &str, settings: &[Setting]) -> System {
    System::assemble(&Source::open("belt").unwrap(), Some(law), settings).unwrap()
}

/// Position of the block at the end.
fn last_position(law: &str, tolerance: f64) -> f64 {
    let system = belt(law, &[]);
    let recorded = [system.source("rig.position").unwrap()];
    let (end, _, (_, values)) = by_steps(&system, GRID, &Options::new(40.0, tolerance), &recorded).unwrap();
    assert!(end.is_reached(), "{law}: {end}");
    *values[0].last().unwrap()
}

/// Positions at the end, computed by another program from the printed equations: LuGre and Dahl with Radau, the reset
/// integrator (a = 0.5) with Runge-Kutta steps of 2 us and its own modes. LuGre's own steps with moving inputs are
/// accurate to 5e-4 of its deflection.
#[test]
fn steps_of_all_models_together_solve_the_belt() {
    for (law, expected, error) in
        [("LuGre", 0.463_150, 2e-5), ("Dahl", 0.448_751, 1e-6), ("ResetIntegrator", 0.238_214, 5e-6)]
    {
        let last = last_position(law, 1e-8);
        assert!((last - expected).abs() < error, "{law}: {last}");
    }
}

/// A smaller tolerance brings the motion nearer: the coupling is of second order.
#[test]
fn the_error_falls_with_the_tolerance() {
    let errors = [1e-5, 1e-8].map(|tolerance| (last_position("LuGre", tolerance) - 0.463_150_29).abs());
    assert!(errors[1] < 0.1 * errors[0], "{errors:?}");
}

/// Strain and number of breaks of each bond at the end of a run, and the distance slid.
fn bonds(tolerance: f64) -> (Vec<[f64; 2]>, f64) {
    let (system, end) = (belt("Bristle", &[]), 7.6);
    let grid = Grid { begin: 0.0, end, intervals: 100 };
    let mut names = vec![String::from("rig.position")];
    for bond in 1..=BONDS {
        names.extend(["strain", "draws"].map(|name| format!("friction.bristle[{bond}].{name}")));
    }
    let recorded: Vec<WireSource> = names.iter().map(|name| system.source(name).unwrap()).collect();
    let (reached, _, (_, values)) = by_steps(&system, grid, &Options::new(end, tolerance), &recorded).unwrap();
    assert!(reached.is_reached(), "{reached}");
    let last: Vec<f64> = values.iter().map(|column| *column.last().unwrap()).collect();
    (last[1..].chunks(2).map(|bond| [bond[0], bond[1]]).collect(), last[0] - 0.1 * end)
}

const BONDS: usize = 25;

/// The law itself after a distance, in parts of less than 20 Delta.
fn slid(distance: f64) -> Vec<[f64; 2]> {
    let mut law = Bristle::default();
    for _ in 0..1000 {
        law.velocity = distance / 1000.0;
        law.step(1.0);
    }
    law.bristle[..BONDS].iter().map(|bond| [bond.strain, bond.draws]).collect()
}

/// Within the first slip, at three tolerances: each bond is where the law has it after the same distance, with the same
/// random numbers. The distance that the law has slid is known from one bond.
#[test]
fn bonds_draw_the_same_numbers_at_any_tolerance() {
    for tolerance in [1e-3, 1e-4, 1e-5] {
        let (found, distance) = bonds(tolerance);
        let shift = found[0][0] - slid(distance)[0][0];
        let expected = slid(distance + shift);
        assert!(shift.abs() < 2e-6 && found[0][1] > 1000.0, "{tolerance}: {shift} m, {:?}", found[0]);
        for (bond, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert_eq!(found[1], expected[1], "{tolerance}: bond {bond}");
            assert!((found[0] - expected[0]).abs() < 1e-10, "{tolerance}: bond {bond}: {found:?} {expected:?}");
        }
    }
}

fn co_simulated(law: &str, step: f64, exchange: Exchange) -> f64 {
    let system = belt(law, &[]);
    let recorded = [system.source("rig.position").unwrap()];
    let master = Master { step, exchange, jitter: 0.0 };
    let options = Options::new(40.0, 1e-8);
    let (end, _, (_, values)) = co_simulation(&system, &master, GRID, &options, &recorded).unwrap();
    assert!(end.is_reached(), "{law}: {end}");
    *values[0].last().unwrap()
}

/// The exact motion ends at 0.239487569431 m.
#[test]
fn co_simulation_comes_to_the_exact_motion_as_its_step_falls() {
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        let errors =
            [1e-2, 1e-3, 1e-4].map(|step| (co_simulated("CoulombStiction", step, exchange) - 0.239_487_569_431).abs());
        assert!(errors[2] < 1e-4 && errors[2] < 0.2 * errors[0], "{exchange:?}: {errors:?}");
    }
}

/// 40,000 steps of 1 ms, and 200,000 of 10 us: every result is that of its own time, not of a step later.
#[test]
fn communication_points_meet_the_times_of_the_results() {
    let system = belt("Coulomb", &[]);
    for (step, end) in [(1e-3, 40.0), (1e-5, 2.0)] {
        let grid = Grid { begin: 0.0, end, intervals: 4000 };
        let master = Master { step, exchange: Exchange::Sequential, jitter: 0.0 };
        let (_, _, (times, _)) = co_simulation(&system, &master, grid, &Options::new(end, 1e-8), &[]).unwrap();
        let late = (0..grid.len()).map(|number| (times[number] - grid.time(number)).abs()).fold(0.0, f64::max);
        assert!(times.len() == grid.len() && late < 1e-13, "{late} s");
    }
}

#[test]
fn steps_that_make_no_sense_are_refused() {
    let system = belt("LuGre", &[]);
    for (step, jitter, expected) in [
        (-1e-3, 0.0, "step = -0.001 s: must be > 0 and finite"),
        (f64::NAN, 0.0, "step = NaN s: must be > 0 and finite"),
        (1e-3, 1.0, "jitter = 1: must be >= 0 and < 1"),
    ] {
        let master = Master { step, exchange: Exchange::Parallel, jitter };
        let fault = co_simulation(&system, &master, GRID, &Options::new(40.0, 1e-8), &[]).unwrap_err();
        assert_eq!(fault.to_string(), expected);
    }
}

/// The setting with which a law follows the acceleration of the block.
fn by_acceleration() -> Setting {
    Setting { name: "acceleration_source".to_owned(), value: "Input".to_owned() }
}

/// A law that jumps at rest holds the block at belt speed until the spring exceeds its level, and then repeats itself.
/// The periods are those of co-simulation as its step falls to 1 us.
#[test]
fn laws_that_jump_at_rest_hold_the_block() {
    for (law, settings, period) in [("FrictionalLag", vec![], 7.627), ("Wojewoda", vec![by_acceleration()], 7.565)] {
        let system = belt(law, &settings);
        let recorded = [system.source("rig.position").unwrap()];
        let (end, _, (time, values)) = by_steps(&system, GRID, &Options::new(40.0, 1e-6), &recorded).unwrap();
        assert!(end.is_reached(), "{law}: {end}");
        let x = &values[0];
        let at_five = x[time.iter().position(|t| *t >= 5.0).unwrap()];
        assert!((at_five - 0.5).abs() < 1e-4, "{law}: {at_five}");
        let maxima: Vec<f64> =
            (1..x.len() - 1).filter(|n| x[*n] > x[n - 1] && x[*n] >= x[n + 1]).map(|n| time[n]).collect();
        let last = maxima[maxima.len() - 1] - maxima[maxima.len() - 2];
        assert!((last - period).abs() < 0.02, "{law}: {maxima:?}");
    }
}

/// Two roads to the same motion: rates with located events, and the steps of the laws, halved until they agree.
#[test]
fn bristles_move_in_steps_as_between_their_events() {
    let damped = [("sigma_1", "316.2"), ("viscous_coefficient", "0.1")];
    let damped = damped.map(|(name, value)| Setting { name: name.to_owned(), value: value.to_owned() });
    let grid = Grid { begin: 0.0, end: 14.0, intervals: 1400 };
    for (law, settings, events) in [("MaxwellSlip", &damped[..], 9), ("Leuven", &[], 9), ("Liang", &[], 3)] {
        let system = belt(law, settings);
        let recorded = [system.source("rig.position").unwrap()];
        let (end, _, (_, steps)) = by_steps(&system, grid, &Options::new(14.0, 1e-6), &recorded).unwrap();
        assert!(end.is_reached(), "{law}: {end}");
        for (tolerance, most) in [(1e-3, 5e-4), (1e-10, 5e-6)] {
            let mut motion = Motion::new(&system, &recorded).unwrap();
            let (mut states, mut recorder) = (motion.start(), Recorder::new(grid, &motion));
            let options = Options::new(14.0, tolerance);
            let (end, statistics) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
            assert!(end.is_reached() && statistics.events.len() == events, "{law}: {end} {:?}", statistics.events);
            let largest = steps[0].iter().zip(&recorder.values[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(largest < most, "{law} {tolerance:e}: {largest:e}");
        }
    }
}

/// Two roads to the same motion: the past in the dense output of a solver, and in the columns of the laws, which steps fill.
/// What steps differ by falls with their tolerance.
#[test]
fn laws_that_lag_move_in_steps_as_by_their_rates() {
    let grid = Grid { begin: 0.0, end: 14.0, intervals: 1400 };
    for (law, tolerances, most) in [("FrictionalLag", [1e-4, 1e-6], 3e-5), ("Armstrong", [1e-5, 1e-7], 2e-5)] {
        let system = belt(law, &[]);
        let recorded = [system.source("rig.position").unwrap()];
        let mut motion = Motion::new(&system, &recorded).unwrap();
        let (mut states, mut recorder) = (motion.start(), Recorder::new(grid, &motion));
        let options = Options::new(14.0, 1e-8);
        let (end, _) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
        assert!(end.is_reached(), "{law}: {end}");
        let off = |tolerance: f64| {
            let (end, _, (_, steps)) = by_steps(&system, grid, &Options::new(14.0, tolerance), &recorded).unwrap();
            assert!(end.is_reached(), "{law}: {end}");
            steps[0].iter().zip(&recorder.values[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let [loose, tight] = tolerances.map(off);
        assert!(tight < most && tight < 0.3 * loose, "{law}: {loose:e} {tight:e}");
    }
}

/// Two roads to the same motion: the balance of forces with located events, and the acceleration of the block as an input
/// to steps that are halved until they agree. The block slips as the spring reaches the static level, at 7.3575 s.
#[test]
fn a_balance_of_forces_is_the_acceleration_it_leads_to() {
    let by_acceleration = belt("NonReversible", &[by_acceleration()]);
    let recorded = [by_acceleration.source("rig.position").unwrap()];
    let (end, _, (_, steps)) = by_steps(&by_acceleration, GRID, &Options::new(40.0, 1e-6), &recorded).unwrap();
    assert!(end.is_reached(), "{end}");
    let mut motion = Motion::new(&belt("NonReversible", &[]), &recorded).unwrap();
    let (mut states, mut recorder) = (motion.start(), Recorder::new(GRID, &motion));
    let options = Options::new(40.0, 1e-10);
    let (end, statistics) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
    assert!(end.is_reached(), "{end}");
    let slip = statistics.events.iter().find(|event| event.time > 1.0).unwrap().time;
    assert!((slip - 1.4715 / 2.0 / 0.1).abs() < 1e-9, "{slip}");
    let largest = steps[0].iter().zip(&recorder.states[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(largest < 1e-5, "{largest:e}");
    assert!(Motion::check(&by_acceleration).unwrap_err().to_string().contains("acceleration_source = Balance"));
}

/// The same of a spring that breaks. The block then never rests again, and what differs in how it creeps grows with the
/// next slip.
#[test]
fn a_spring_that_breaks_moves_alike_by_events_and_by_steps() {
    let (end, until) = (14.0, Grid { begin: 0.0, end: 14.0, intervals: 1400 });
    let stepped = belt("Wojewoda", &[by_acceleration()]);
    let recorded = [stepped.source("rig.position").unwrap()];
    let (reached, _, (_, steps)) = by_steps(&stepped, until, &Options::new(end, 1e-8), &recorded).unwrap();
    assert!(reached.is_reached(), "{reached}");
    for (tolerance, most) in [(1e-3, 1e-3), (1e-10, 2e-4)] {
        let mut motion = Motion::new(&belt("Wojewoda", &[]), &recorded).unwrap();
        let position = motion.places().iter().position(|place| *place == stepped.place("rig.position").unwrap());
        let (mut states, mut recorder) = (motion.start(), Recorder::new(until, &motion));
        let options = Options::new(end, tolerance);
        let (reached, _) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
        assert!(reached.is_reached(), "{reached}");
        let solved = &recorder.states[position.unwrap()];
        let largest = steps[0].iter().zip(solved).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(largest < most, "{tolerance:e}: {largest:e} m");
    }
}

#[test]
fn laws_with_events_are_not_run_by_steps() {
    let fault = by_steps(&belt("CoulombStiction", &[]), GRID, &Options::new(40.0, 1e-6), &[]).unwrap_err();
    assert_eq!(fault.to_string(), "friction: CoulombStiction sticks and slips at events, which steps do not see");
}
