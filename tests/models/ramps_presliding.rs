//! Laws with a memory of their path under rest, and under inputs that move linearly.
//!
//! The other road to a ramp is the same motion in many short steps with held inputs.

use crate::common::Bench;
use crate::common::random::Random;
use approx::abs_diff_eq;
use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};

fn friction_models() -> impl Iterator<Item = &'static ModelType> {
    catalogue::documented(Family::Friction).map(|(model, _)| model)
}

/// Name of the velocity that a motion along a line uses, and of the force along it.
fn axis(bench: &Bench) -> (&'static str, &'static str) {
    if bench.has("velocity") { ("velocity", "friction_force") } else { ("velocity_x", "friction_force_x") }
}

// ---- Rest

/// Whether the memory of a law lives in time and not in the path, since it has a time, be it a result, or knows the
/// acceleration: a rest changes the force, as its page says.
fn is_in_time(law: &ModelType) -> bool {
    let is_time = |one: &Variable| {
        matches!(one.role, Role::Fixed | Role::Tunable | Role::Output)
            && matches!(one.kind, Kind::Real(unit) if unit.name == "s")
    };
    law.table.of(Meaning::Acceleration).is_some() || law.table.iter().any(|one| is_time(&one))
}

/// Time that a dwell takes counts for nothing where the path is all that counts: the force of the rest, and the future
/// after it, are those without it. Forwards and backwards, bonded and sliding, and for both zeros.
#[test]
fn a_dwell_leaves_a_law_of_the_path_as_it_is() {
    for model in friction_models().filter(|model| !is_in_time(model)) {
        for (zero, seed) in [(0.0, 3), (-0.0, 5), (0.0, 7), (-0.0, 11)] {
            // Maxwell-slip elements follow a level that falls with the speed in time.
            let levels: &[(&str, f64)] = if model.name == "MaxwellSlip" { &[("mu_s", 0.1)] } else { &[] };
            let [mut still, mut dwelt] = [0; 2].map(|_| Bench::new(model.name, levels));
            let mut random = Random(seed);
            let (velocity, force) = axis(&still);
            for _ in 0..30 {
                still.set(velocity, 10f64.powf(-2.0 - 5.0 * random.next()) * random.signed());
                still.step(1e-3 * random.next());
            }
            dwelt.instance.restore(&still.instance.save());
            dwelt.set(velocity, zero);
            let at_rest = dwelt.get(force);
            for time in [1e-12, 1e-3, 10.0] {
                dwelt.step(time);
                assert_eq!(dwelt.get(force), at_rest, "{} after {time} s", model.name);
            }
            for bench in [&mut still, &mut dwelt] {
                bench.set(velocity, 2e-4);
                bench.step(1e-3);
            }
            let (a, b) = (dwelt.get(force), still.get(force));
            assert!(abs_diff_eq!(a, b, epsilon = 1e-12), "{}: {a} after the dwell, {b} without", model.name);
        }
    }
}

/// A slide, next to nothing, nothing.
#[test]
fn bonds_outlast_a_rest() {
    for rest in [0.0, -0.0, 5e-324, -5e-324] {
        let mut bench = Bench::new("Bristle", &[]);
        for velocity in [5e-3, 1e-9, rest] {
            bench.set("velocity", velocity);
            bench.step(1e-3);
            // 5 um on 1e5 N/m.
            assert!(
                abs_diff_eq!(bench.get("friction_force"), 0.5, epsilon = 1e-6),
                "{} N at {velocity} m/s",
                bench.get("friction_force")
            );
        }
    }
}

// ---- Inputs that move

/// A motion: what the inputs are at the beginning and at the end of each leg. Between legs they may jump, as the signals
/// of a sampled world do.
struct Motion {
    columns: Vec<usize>,
    legs: Vec<[Vec<f64>; 2]>,
}

/// Time that each leg takes.
const LEG: f64 = 1e-3;

impl Motion {
    /// Legs that speed up, slow down, turn back and dwell, slow and fast, under loads that rise, fall and stay.
    fn random(model: &'static ModelType, seed: u64, legs: usize) -> Motion {
        let mut random = Random(seed);
        let names = ["velocity", "velocity_x", "velocity_y", "velocity_z", "normal_force"];
        let columns: Vec<usize> = names.iter().filter_map(|name| model.find(name)).collect();
        let (load, mut at) = (columns.len() - 1, vec![0.0; columns.len()]);
        at[load] = 9.81;
        let legs = (0..legs).map(|_| {
            let speed = 10f64.powf(-1.5 - 2.5 * random.next());
            let dwells = random.next() < 0.15;
            if dwells || random.next() < 0.1 {
                at[..load].fill(0.0);
            }
            let begin = at.clone();
            for velocity in at[..load].iter_mut().filter(|_| !dwells) {
                *velocity = speed * random.signed();
            }
            at[load] = if random.next() < 0.3 { at[load] } else { (at[load] + 3.0 * random.signed()).clamp(2.0, 20.0) };
            [begin, at.clone()]
        });
        Motion { columns, legs: legs.collect() }
    }

    fn set(&self, instance: &mut Instance, leg: &[Vec<f64>; 2], share: f64) {
        for (index, column) in self.columns.iter().enumerate() {
            instance.set_column(*column, leg[0][index] + share * (leg[1][index] - leg[0][index])).unwrap();
        }
    }

    /// A leg in `steps` steps with slopes.
    fn ramp(&self, bench: &mut Bench, leg: &[Vec<f64>; 2], steps: u32) {
        for step in 0..steps {
            self.set(&mut bench.instance, leg, f64::from(step) / f64::from(steps));
            for (index, column) in self.columns.iter().enumerate() {
                bench.instance.set_slope(*column, (leg[1][index] - leg[0][index]) / LEG).unwrap();
            }
            bench.step(LEG / f64::from(steps));
        }
    }

    /// A leg in `steps` steps with the inputs held in the middle of each, and then the velocity of its end. The load
    /// stays behind by half a short step: raised at once, it would bond what slides.
    fn held(&self, bench: &mut Bench, leg: &[Vec<f64>; 2], steps: u32) {
        for step in 0..steps {
            self.set(&mut bench.instance, leg, (f64::from(step) + 0.5) / f64::from(steps));
            bench.step(LEG / f64::from(steps));
        }
        for (column, value) in self.columns.iter().zip(&leg[1]).take(self.columns.len() - 1) {
            bench.instance.set_column(*column, *value).unwrap();
        }
    }
}

fn results(bench: &mut Bench) -> Vec<f64> {
    let names = ["friction_force", "friction_force_x", "friction_force_y", "friction_force_z", "dissipated_energy"];
    let known: Vec<&str> = names.into_iter().filter(|name| bench.has(name)).collect();
    known.into_iter().map(|name| bench.get(name)).collect()
}

/// Results at the ends of the legs of a random motion.
fn trace(
    model: &str,
    values: &[(&str, f64)],
    seed: u64,
    run: impl Fn(&Motion, &mut Bench, &[Vec<f64>; 2]),
) -> Vec<Vec<f64>> {
    let mut bench = Bench::new(model, values);
    let motion = Motion::random(bench.instance.model(), seed, 40);
    let legs = motion.legs.iter().map(|leg| {
        run(&motion, &mut bench, leg);
        results(&mut bench)
    });
    legs.collect()
}

/// Largest differences of the forces and of the energy between two traces.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> [f64; 2] {
    a.iter().zip(b).fold([0.0f64; 2], |[forces, energy], (a, b)| {
        let differences: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - b).abs()).collect();
        let (last, others) = differences.split_last().expect("an energy");
        [others.iter().fold(forces, |largest, value| largest.max(*value)), energy.max(*last)]
    })
}

/// A law with its parameters, the motions that it makes, and the largest differences of forces and energy.
type Case = (&'static str, &'static [(&'static str, f64)], &'static [u64], [f64; 2]);

/// Ramps are of second order: in eight steps instead of one, they are that much nearer to short held steps, as far as
/// these tell, which are of first order themselves; and one step is near enough. Dwells, reversals, loads that rise and
/// fall. The printed rule of Liang turns the bristle at any excess over its circle, be it that of half a short step, so
/// that after a rest under a falling load short steps tell nothing: such a motion is left out for it.
#[test]
fn ramps_agree_with_short_held_steps() {
    const UNIFORM: &[(&str, f64)] = &[("mu_s", 0.1), ("distribution", 2.0), ("element_count", 20.0)];
    let cases: [Case; 9] = [
        ("Bristle", &[], &[1, 2, 3], [1e-3, 1e-6]),
        ("Liang", &[], &[1, 2, 3], [1e-2, 1e-6]),
        ("Liang", &[("variant", 2.0)], &[1, 2], [1e-2, 1e-6]),
        ("MaxwellSlip", &[], &[1, 2, 3], [1e-2, 1e-6]),
        ("MaxwellSlip", &[("sigma_1", 316.0)], &[1, 2, 3], [3e-2, 1e-6]),
        ("MaxwellSlip", UNIFORM, &[1, 2, 3], [1e-2, 1e-6]),
        ("Leuven", &[], &[1, 2, 3], [1e-2, 1e-6]),
        ("Leuven", &[("approach_exponent", 2.0)], &[1, 2, 3], [3e-2, 1e-6]),
        ("Leuven", UNIFORM, &[1, 2, 3], [1e-2, 1e-6]),
    ];
    for (model, values, seeds, largest) in cases {
        for seed in seeds {
            let ramps = |n| trace(model, values, *seed, move |motion, bench, leg| motion.ramp(bench, leg, n));
            let held = |n| trace(model, values, *seed, move |motion, bench, leg| motion.held(bench, leg, n));
            let (fine, finer) = (held(1000), held(2000));
            let [known, far, near] = [&fine, &ramps(1), &ramps(8)].map(|other| difference(other, &finer));
            for k in [0, 1] {
                let what = format!("{model} {values:?} {seed}: {far:?}, then {near:?}, known to {known:?}");
                assert!(far[k] <= largest[k] && near[k] <= far[k] / 12.0 + 3.0 * known[k], "{what}");
            }
        }
    }
}

/// Sliding at 50 mm/s under 10 N at mu_k = 0.1, whatever slope the load has: 1 N, and no bonding.
#[test]
fn a_rising_load_does_not_bond_what_slides() {
    for slope in [0.0, 1e-6, 1e-3, 1.0, 100.0, -1e-6, -1.0, -100.0] {
        let mut bench = Bench::new("Liang", &[("velocity_x", 0.05), ("normal_force", 10.0)]);
        bench.step(0.1);
        for _ in 0..3 {
            bench.instance.set_slope(bench.column("normal_force"), slope).unwrap();
            bench.step(1e-3);
            let expected = 0.1 * bench.get("normal_force");
            let force = bench.get("friction_force_x");
            assert!((force / expected - 1.0).abs() < 1e-12 && bench.get("sticking") == 0.0, "{slope} N/s: {force} N");
        }
    }
}

/// The time derivatives of the results against differences along the very run, from random states on, under loads that
/// rise and fall. Where a law jumps or bends within the differences there is nothing to compare.
#[test]
fn time_derivatives_are_those_of_the_run() {
    for model in friction_models() {
        compare_derivatives(model, &[], 17);
    }
}

/// A bond that a falling load pushes back stands on its limit, also where a contact makes the step in parts: with a
/// reversal in it.
#[test]
fn time_derivatives_are_those_of_a_bond_that_is_pushed_back() {
    let guide = catalogue::by_name("GuideContact").expect("a contact");
    let Kind::Enumeration(laws) = guide.table.at(guide.find("friction.model").expect("its law")).kind else { panic!() };
    for law in ["Armstrong", "Wojewoda", "ResetIntegrator"] {
        let place = laws.items.iter().position(|item| item.name == law).expect("a choice");
        for seed in [17, 24, 45] {
            compare_derivatives(catalogue::by_name(law).expect("a law"), &[], seed);
            compare_derivatives(guide, &[("friction.model", place as f64 + 1.0)], seed);
        }
    }
}

fn compare_derivatives(model: &'static ModelType, values: &[(&str, f64)], seed: u64) {
    let motion = Motion::random(model, seed, 200);
    let mut bench = Bench::new(model.name, values);
    let (mut compared, mut wrong) = (0, Vec::new());
    for leg in &motion.legs {
        motion.ramp(&mut bench, leg, 1);
        for (exact, quotient) in derivatives(&mut bench, &motion, leg) {
            let Some(quotient) = quotient else { continue };
            compared += 1;
            if (quotient - exact).abs() > 1e-3 * exact.abs().max(quotient.abs()).max(1.0) {
                wrong.push((exact, quotient));
            }
        }
    }
    assert!(wrong.is_empty(), "{} {values:?} {seed}: {} of {compared}: {wrong:?}", model.name, wrong.len());
    assert!(compared > 300, "{} {values:?} {seed}: only {compared}", model.name);
}

/// Time derivatives of the force and of its power at the end of a leg, and what the run goes on by, if it does so
/// smoothly.
fn derivatives(bench: &mut Bench, motion: &Motion, leg: &[Vec<f64>; 2]) -> Vec<(f64, Option<f64>)> {
    const H: f64 = 1e-7;
    let names = ["friction_force", "friction_force_x", "friction_force_y", "dissipated_power"];
    let columns: Vec<usize> = names.iter().filter_map(|name| bench.instance.model().find(name)).collect();
    let saved = bench.instance.save();
    let exact: Vec<f64> = bench.instance.time_derivative().iter().map(|dual| dual.slope).collect();
    let samples: Vec<Vec<f64>> = (0..4)
        .map(|step| {
            if step > 0 {
                for (index, column) in motion.columns.iter().enumerate() {
                    bench.instance.set_slope(*column, (leg[1][index] - leg[0][index]) / LEG).unwrap();
                }
                bench.step(H);
            }
            bench.instance.row().to_vec()
        })
        .collect();
    bench.instance.restore(&saved);
    let compare = |column: &usize| {
        let at = |step: usize| samples[step][*column];
        let slope = |step: usize| (at(step + 1) - at(step)) / H;
        let quotient = (11.0 * slope(0) - 7.0 * slope(1) + 2.0 * slope(2)) / 6.0;
        let scale = 1e-2 * quotient.abs().max(exact[*column].abs()).max(1.0);
        let is_smooth = (slope(1) - slope(0)).abs() < scale && (slope(2) - slope(1)).abs() < scale;
        (exact[*column], is_smooth.then_some(quotient))
    };
    columns.iter().map(compare).collect()
}

// ---- Ends of ramps

/// A load that a ramp takes off is gone, for all that rounding leaves: no law ends with a tiny load of either sign.
#[test]
fn a_load_that_a_ramp_takes_off_is_gone() {
    for model in friction_models() {
        let mut random = Random(41);
        let mut bench = Bench::new(model.name, &[]);
        let [velocity, load] = [axis(&bench).0, "normal_force"].map(|name| bench.column(name));
        for _ in 0..200 {
            let (dt, from, speed) = (1e-3 * random.next(), 20.0 * random.next(), 0.05 * random.signed());
            bench.instance.set_column(load, from).unwrap();
            bench.instance.set_column(velocity, speed).unwrap();
            bench.step(dt);
            bench.instance.set_slope(load, -from / dt).unwrap();
            bench.instance.set_slope(velocity, speed / dt).unwrap();
            bench.step(dt);
            let (name, left) = (model.name, bench.instance.row()[load]);
            assert_eq!(left, 0.0, "{name}: {left} N left of {from} N after {dt} s");
            let force = bench.get(axis(&bench).1);
            assert_eq!(force, 0.0, "{name}: {force} N without a load");
        }
    }
}

/// Energy of one step with slopes against that of 128 parts of it, over random motions with rests, reversals and a load
/// that vanishes and returns. It may be wrong by far less than what such a step can dissipate, some 0.3 mJ.
#[test]
fn a_ramp_dissipates_what_its_parts_do() {
    for model in friction_models() {
        let mut random = Random(77);
        let mut bench = Bench::new(model.name, &[]);
        let columns = [axis(&bench).0, "normal_force"].map(|name| bench.column(name));
        let (mut now, mut sum, mut largest) = ([0.0, model.table.at(columns[1]).start], 0.0, 0f64);
        let sections = 300;
        for section in 0..sections {
            let from = now;
            let speed = 0.1 * random.signed() * 10f64.powf(-4.0 * random.next());
            now = [if section % 10 == 0 { 0.0 } else { speed }, (24.0 * random.next() - 4.0).max(0.0)];
            let h = 1e-3 * (0.2 + random.next());
            let begin = bench.instance.save();
            let mut energy = [1, 128].map(|parts| {
                bench.instance.restore(&begin);
                for part in 0..parts {
                    for (at, column) in columns.into_iter().enumerate() {
                        let value = |part: i32| match part == parts {
                            true => now[at],
                            false => from[at] + f64::from(part) / f64::from(parts) * (now[at] - from[at]),
                        };
                        bench.instance.set_column(column, value(part)).unwrap();
                        bench
                            .instance
                            .set_slope(column, (value(part + 1) - value(part)) * f64::from(parts) / h)
                            .unwrap();
                    }
                    bench.step(h / f64::from(parts));
                }
                bench.get("dissipated_energy")
            });
            energy.sort_by(f64::total_cmp);
            sum += energy[1] - energy[0];
            largest = largest.max(energy[1] - energy[0]);
        }
        let mean = sum / f64::from(sections);
        assert!(mean < 1e-6 && largest < 1e-4, "{}: {mean} J on average, {largest} J at most", model.name);
    }
}
