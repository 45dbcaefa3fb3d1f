//! A law whose force passes from one level to the other within a speed that no state resolves.

use super::tests::solved;
use super::{Motion, Setting, Source, System};
use crate::run::{Outcome, Settings, Solver, run};

const LAW: &str = "RateAndState";

const BELT: [&str; 4] = ["rig.position", "rig.block_velocity", "friction.friction_force", "friction.dissipated_energy"];

fn at(system: &str, solver: Solver, tolerance: f64, until: f64, results: &[&str]) -> Outcome {
    let system = System::assemble(&Source::open(system).unwrap(), Some(LAW), &[] as &[Setting]).unwrap();
    let settings = Settings { solver, tolerance, until, ..Settings::of(&system) };
    run(&system, &settings, &results.iter().map(|name| (*name).to_owned()).collect::<Vec<String>>()).unwrap()
}

/// Largest difference between the first results of two runs.
fn apart(one: &Outcome, other: &Outcome) -> f64 {
    let pairs = one.columns[0].values.iter().zip(&other.columns[0].values);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Slopes at the start, by which a solver is chosen, are those of a contact that carries its load: before the events at the
/// start that of a strut carries none, and the slope of its bristles is not a number.
#[test]
fn slopes_at_the_start_are_numbers() {
    for system in ["belt", "two-blocks", "quarter-car", "four-post"] {
        for law in ["Dahl", "LuGre", "Gonthier"] {
            let system = System::assemble(&Source::open(system).unwrap(), Some(law), &[] as &[Setting]).unwrap();
            let (_, slope) = Motion::new(&system, &[]).unwrap().steepest().unwrap();
            assert!(slope < 1e6, "{law} in {}: {slope}", system.description.title);
        }
    }
}

/// The block rides on the belt, its contact carrying the spring, until the spring is stronger than friction; then it slips
/// to the other side of rest. What the belt puts in is dissipated, in the spring, or moves the block.
#[test]
fn a_block_rides_on_the_belt_until_it_slips() {
    let outcome = solved("belt", LAW, &[], 1e-8, &BELT);
    assert_eq!(outcome.solver, Solver::Steps);
    let [position, velocity, force, heat] = BELT.map(|name| outcome.values(name).unwrap());
    let (spring, belt, load) = (2.0, 0.1, 9.81);
    let mut work = 0.0;
    for (i, time) in outcome.time.iter().enumerate() {
        if i > 0 {
            // The belt pulls with the negative of what the block feels.
            work -= 0.5 * (force[i] + force[i - 1]) * belt * (time - outcome.time[i - 1]);
        }
        if *time < 27.0 {
            assert!((position[i] - belt * time).abs() < 1e-8, "{time}: {}", position[i]);
            assert!((force[i] + spring * position[i]).abs() < 1e-6, "{time}: {}", force[i]);
        }
        let energy = 0.5 * (velocity[i].powi(2) - belt.powi(2) + spring * position[i].powi(2));
        assert!((work - energy - heat[i]).abs() < 2e-3, "{time}: {work} {energy} {}", heat[i]);
    }
    // Contacts of the age t break away at about mu_0 + b ln(v_0 t / D_c), and slide at that less (b - a) ln(v / v_0).
    let highest = force.iter().fold(0.0, |most: f64, force| most.max(-force));
    let oldest = load * (0.6 + 0.015 * f64::ln(1e-6 * 40.0 / 1e-5) + 0.010 * f64::ln(belt / 1e-6));
    assert!(highest > 0.6 * load && highest < oldest, "{highest} {oldest}");
    assert!(velocity.iter().any(|velocity| *velocity < -0.1));
}

/// Solvers that do not resolve the law say so, whatever the tolerance.
#[test]
fn a_solver_that_does_not_resolve_the_slope_says_so() {
    for tolerance in [1e-3, 1e-5, 1e-8, 1e-11] {
        for solver in [Solver::Rodas5P, Solver::Rosenbrock23] {
            let end = at("belt", solver, tolerance, 40.0, &BELT).end.to_string();
            assert!(
                end.contains("the rounding of rig.block_velocity decides on its rate"),
                "{solver} {tolerance}: {end}"
            );
        }
    }
}

#[cfg(feature = "foreign")]
#[test]
fn a_solver_that_would_not_notice_it_is_refused() {
    for solver in [Solver::Bdf, Solver::TrBdf2, Solver::Esdirk34, Solver::Dopri5] {
        for (name, state) in [("belt", "rig.block_velocity"), ("pulled-mass", "mass.velocity")] {
            let system = System::assemble(&Source::open(name).unwrap(), Some(LAW), &[] as &[Setting]).unwrap();
            let fault = run(&system, &Settings { solver, ..Settings::of(&system) }, &[]).unwrap_err().to_string();
            assert!(fault.contains(&format!("the rate of {state} has a slope of ")), "{fault}");
        }
    }
}

/// Where the velocity is a state, it is resolved, and what a step takes for small is tried; steps, which know no rates, pass
/// reversals too.
#[test]
fn a_velocity_that_is_a_state_is_resolved() {
    let results = ["axis.position"];
    let truth = at("axis", Solver::Rodas5P, 1e-9, 10.0, &results);
    for (solver, tolerance, most) in [
        (Solver::Rodas5P, 1e-3, 1e-4),
        (Solver::Rodas5P, 1e-5, 1e-5),
        (Solver::Rosenbrock23, 1e-5, 1e-5),
        (Solver::Steps, 1e-5, 1e-4),
        (Solver::Steps, 1e-7, 1e-6),
    ] {
        let found = at("axis", solver, tolerance, 10.0, &results);
        assert!(found.is_reached() && truth.is_reached(), "{} {}", found.end, truth.end);
        let error = apart(&found, &truth);
        assert!(error < most, "{solver} {tolerance}: {error}");
    }
}

/// Laws whose speed of transition is next to nothing: with a peak there, no solver finds the motion, and each says so;
/// without one, it is that of a speed which is resolved.
#[test]
fn a_peak_that_is_too_narrow_is_noticed() {
    let on_belt = |law: &str, transition: &str| {
        let setting = Setting { name: "friction.transition_velocity".to_owned(), value: transition.to_owned() };
        let system = System::assemble(&Source::open("belt").unwrap(), Some(law), &[setting]).unwrap();
        run(&system, &Settings::of(&system), &[BELT[0].to_owned()]).unwrap()
    };
    for (law, transition, solver, reason) in [
        ("BrownMcPhee", "1e-12", Solver::Steps, "steps do not see the peak"),
        ("Hollars", "1e-14", Solver::Steps, "steps do not see the peak"),
        ("BrownMcPhee", "1e-10", Solver::Rodas5P, "the rounding of rig.block_velocity decides on its rate"),
    ] {
        let outcome = on_belt(law, transition);
        assert_eq!(outcome.solver, solver, "{law} {transition}");
        assert!(outcome.end.to_string().contains(reason), "{law} {transition}: {}", outcome.end);
    }
    let [wide, narrow] = ["1e-8", "1e-13"].map(|transition| on_belt("Threlfall", transition));
    assert!(wide.solver == Solver::Rodas5P && narrow.solver == Solver::Steps && narrow.is_reached());
    assert!(apart(&narrow, &wide) < 1e-6);
}
