//! An arm with a load, moved by a servo with the friction models M1 to M6 of Duclusaud and others (2025).

use super::{Description, Source, System};
use crate::couple::{Exchange, Master};
use crate::run::{Outcome, Settings, Solver, run};

const MODELS: [&str; 6] = ["mx106_m1", "mx106_m2", "mx106_m3", "mx106_m4", "mx106_m5", "mx106_m6"];

/// Weight of the default load at the end of a level arm, in N.m.
const WEIGHT: f64 = 0.5 * 9.81 * 0.2;

/// Static level without load, and its coefficients by motor and load, as printed.
const LEVELS: [[f64; 3]; 6] = [
    [0.1035, 0.0, 0.0],
    [2.769e-6 + 0.1174, 0.0, 0.0],
    [0.1134, 0.1082, 0.1082],
    [0.1049, 0.00915 + 0.2224, 0.00915 + 0.2224],
    [0.1224, 0.2076 + 0.1952, 0.02268 + 0.0849],
    [1.023e-5 + 0.122, 0.198 + 0.1986, 0.02222 + 0.0871],
];

/// Torque by volt of the motor at rest, as printed.
const TORQUE_BY_VOLT: [f64; 6] =
    [2.191 / 2.965, 2.191 / 2.961, 2.204 / 2.653, 2.231 / 2.372, 2.209 / 2.014, 2.21 / 2.034];

fn moved(model: &str, angle: f64, target: &str, settings: Settings) -> Outcome {
    let (_, text) = super::BUILT_IN.iter().find(|(name, _)| *name == "servo-pendulum").unwrap();
    let mut description = Description::parse(&text.replace("mx106_m4", model)).unwrap();
    description.part.get_mut("arm").unwrap().set.insert("angle".to_owned(), super::file::Value::Number(angle));
    let targets =
        toml::from_str::<std::collections::BTreeMap<String, super::Signal>>(&format!("target = {target}")).unwrap();
    description.input.insert("arm.target_angle".to_owned(), targets["target"].clone());
    let system = System::assemble(&Source { description, folder: Default::default() }, None, &[]).unwrap();
    let results = ["arm.angle", "arm.velocity", "friction.friction_force", "friction.dissipated_energy"];
    let outcome = run(&system, &settings, &results.map(str::to_owned)).unwrap();
    assert!(outcome.is_reached(), "{model}: {}", outcome.end);
    outcome
}

fn settings(until: f64, every: f64) -> Settings<'static> {
    let system = System::assemble(&Source::open("servo-pendulum").unwrap(), None, &[]).unwrap();
    Settings { tolerance: 1e-10, until, every, ..Settings::of(&system) }
}

/// The event that ends the rest, after which the arm moves.
fn end_of_rest(outcome: &Outcome) -> f64 {
    let angle = &outcome.columns[0].values;
    let moves = angle.iter().position(|now| *now != angle[0]).unwrap();
    outcome.events.iter().map(|event| event.time).rfind(|time| *time < outcome.time[moves]).unwrap()
}

/// An arm at rest at 0.8 rad is lifted, or let down, by a target that moves slowly from where the motor carries the load:
/// it leaves its rest at the torques of the motor that the straight lines of driving and back-driving give. In M6 the
/// smaller torque counts by its square as well, as printed: 7.327e-5 f_l^2 when driving, 0.01 f_m^2 when back-driven.
#[test]
fn a_load_breaks_away_where_driving_and_back_driving_begin() {
    let angle: f64 = 0.8;
    let load = WEIGHT * angle.sin();
    for (model, ([free, motor, by_load], by_volt)) in MODELS.iter().zip(LEVELS.iter().zip(TORQUE_BY_VOLT)) {
        let quadratic = |of_motor: f64| if *model == "mx106_m6" { of_motor } else { 0.0 };
        let lifts = (free + load * (1.0 + by_load) + quadratic(7.327e-5 * load * load)) / (1.0 - motor);
        // In M6 f_m (1 + K) + 0.01 f_m^2 is given, a quadratic equation.
        let missing = load * (1.0 - by_load) - free;
        let gives_way = if *model == "mx106_m6" {
            let half = 0.5 * (1.0 + motor) / 0.01;
            (half * half + missing / 0.01).sqrt() - half
        } else {
            missing / (1.0 + motor)
        };
        for (torque, rate) in [(lifts, 0.01), (gives_way, -0.01)] {
            let begin = angle + load / (75.84 * by_volt);
            let target = format!("{{ ramp = {{ from = {begin}, rate = {rate} }} }}");
            let leaves = (angle + torque / (75.84 * by_volt) - begin) / rate;
            let outcome = moved(model, angle, &target, settings(leaves + 0.1, 0.01));
            let found = end_of_rest(&outcome);
            assert!((found - leaves).abs() < 1e-7, "{model} {rate}: leaves at {found} s, not {leaves} s");
        }
    }
}

/// The whole course, against a method of another crate and its own finer steps; friction takes the energy that the motor
/// puts in and the load does not keep. With load-dependent friction more of the way up is lost than in M1 and M2.
#[test]
fn up_and_down_is_the_motion_of_another_solver() {
    let target = "{ points = { time = [0.5, 1.5, 2.5, 3.5], value = [0.0, 1.6, 1.6, 0.0] } }";
    let mut lost = Vec::new();
    for model in MODELS {
        let base = settings(4.0, 0.01);
        let ours = moved(model, 0.0, target, Settings { tolerance: 1e-8, ..base });
        for solver in [Solver::Rodas5P, Solver::Bdf] {
            let other = moved(model, 0.0, target, Settings { solver, ..base });
            let pairs = ours.columns[0].values.iter().zip(&other.columns[0].values);
            let error = pairs.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
            assert!(error < 2e-6, "{model} {solver:?}: {error} rad");
        }
        let energy = &ours.columns[3].values;
        // The load is up at 2 s.
        lost.push(energy[200]);
        assert!(energy.windows(2).all(|pair| pair[1] >= pair[0] - 1e-12), "{model}");
    }
    let (load_free, by_load) = lost.split_at(2);
    let most = load_free.iter().copied().fold(0.0, f64::max);
    assert!(by_load.iter().all(|energy| *energy > 1.5 * most), "{lost:?}");
}

/// Every servo and every model of its friction is solved to the end, also with an exponent below 1, whose level falls
/// infinitely fast at rest, and of servos that are too weak for the load.
#[test]
fn every_servo_is_solved_to_its_end() {
    let target = "{ points = { time = [0.5, 1.5, 2.5, 3.5], value = [0.0, 1.6, 1.6, 0.0] } }";
    let arm = stribeck::catalogue::by_name("ServoArm").unwrap();
    for preset in arm.presets {
        let outcome = moved(preset.name, 0.0, target, Settings { tolerance: 1e-8, ..settings(4.0, 0.1) });
        assert!(outcome.columns[0].values.iter().all(|angle| angle.abs() < 1.7), "{}", preset.name);
    }
}

/// Held for 1,000 s at a step of 10 ms, whatever the order of exchange: a load at 0.8 rad whose motor carries half of it.
#[test]
fn a_held_load_does_not_creep() {
    let by_volt = TORQUE_BY_VOLT[3];
    let target = 0.8 + 0.7 * WEIGHT * f64::sin(0.8) / (75.84 * by_volt);
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        let master = Master { step: 0.01, exchange, jitter: 0.0 };
        let base = Settings { solver: Solver::CoSimulation, master, ..settings(1000.0, 10.0) };
        let outcome = moved("mx106_m4", 0.8, &target.to_string(), base);
        let [angle, velocity] = [0, 1].map(|column| *outcome.columns[column].values.last().unwrap());
        assert!((angle - 0.8).abs() < 1e-12 && velocity.abs() < 1e-12, "{exchange:?}: {angle} rad, {velocity} rad/s");
    }
}
