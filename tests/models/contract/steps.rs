//! Steps: their division, rates of the states, ramps, and the same future from a saved state.

use super::{axes, for_all, friction_models, limit, set_velocity};
use crate::common::Bench;
use crate::common::random::Random;
use approx::abs_diff_eq;
use stribeck::catalogue;
use stribeck::model::{Kind, Role};

/// Without the memory of the last step's length, which `mass` switches on, every step is exact for held inputs.
#[test]
fn two_half_steps_are_one_step() {
    for_all(|bench, what| {
        if bench.has("mass") && bench.get("mass") > 0.0 {
            return;
        }
        let mut halves = Bench::new(bench.instance.model().name, &[]);
        halves.instance.restore(&bench.instance.save());
        let mut random = Random(13);
        for _ in 0..20 {
            let (velocity, mut speed) = (10f64.powf(-6.0 * random.next()) * random.signed(), 0.0);
            let mut h = 10f64.powf(-5.0 * random.next());
            if bench.has("bristle_count") && bench.get("mu_s") > bench.get("mu_k") {
                // A random law follows its bonds one by one over short slides; for long ones the result is drawn.
                let span = 3.0 * bench.get("delta") * (1.0 - bench.get("mu_k") / bench.get("mu_s"));
                h = h.min(20.0 * span / velocity.abs());
            }
            for (name, ..) in axes(bench) {
                let velocity = if name == "velocity" { velocity } else { velocity * random.signed() };
                bench.set(name, velocity);
                halves.set(name, velocity);
                speed += velocity.abs();
            }
            bench.step(h);
            halves.step(0.5 * h);
            halves.step(0.5 * h);
            // A force at constant speed is not larger than this, so differences are measured against it.
            let scale = 1e-3 + limit(bench, speed) + 1e4 * speed;
            for name in axes(bench).into_iter().map(|(_, force, _)| force).chain(["dissipated_energy"]) {
                let (one, two) = (bench.get(name), halves.get(name));
                assert!(
                    abs_diff_eq!(one, two, epsilon = 1e-10 * scale.max(one.abs())),
                    "{what}: {name} {one} against {two}"
                );
            }
        }
    });
}

/// States that jump from step to step, such as the records of a history; all others change continuously, at the rate
/// given by their model.
#[rustfmt::skip]
const DISCRETE: &[&str] = &[
    "step_size",
    "planning_step",
    "planned_force",
    "end_velocity",
    "end_external_force",
    "end_normal_force",
    "velocity_change",
    "external_force_change",
    "normal_force_change",
];

#[test]
fn rates_are_the_derivatives_of_the_states() {
    for model in catalogue::models() {
        let mut random = Random(23);
        for _ in 0..20 {
            let mut bench = Bench::new(model.name, &[]);
            for (column, variable) in model.table.iter().enumerate().filter(|(_, known)| known.role == Role::Input) {
                let change = 5e-3 * random.signed();
                let value = variable.start + if variable.admits(variable.start + change) { change } else { -change };
                bench.instance.set_column(column, value).unwrap();
            }
            bench.step(1e-3 * random.next());
            let rates: Vec<f64> = bench.instance.time_derivative().iter().map(|dual| dual.slope).collect();
            let before = bench.instance.row().to_vec();
            let h = 1e-7;
            bench.step(h);
            for (column, variable) in model.table.iter().enumerate() {
                let name = variable.path.to_string();
                let is_continuous = variable.role.is_state() && matches!(variable.kind, Kind::Real(_));
                if !is_continuous || DISCRETE.contains(&&*name) || name.starts_with("history[") {
                    continue;
                }
                let quotient = (bench.instance.row()[column] - before[column]) / h;
                let error = (quotient - rates[column]).abs();
                let scale = rates[column].abs().max(1e-3 * variable.nominal);
                assert!(error < 5e-3 * scale, "{} {name}: {quotient} against {}", model.name, rates[column]);
            }
        }
    }
}

/// The energy that leaves the motion is the integral of the power, so its rate is the power.
#[test]
fn the_rate_of_the_energy_is_the_power() {
    for_all(|bench, what| {
        for velocity in [-0.03, 4e-4, 1.0] {
            set_velocity(bench, velocity);
            bench.step(1e-3);
            let (energy, power) = (bench.column("dissipated_energy"), bench.get("dissipated_power"));
            let rate = bench.instance.time_derivative()[energy].slope;
            assert!(abs_diff_eq!(rate, power, epsilon = 1e-12 * power.abs()), "{what}: {rate} W against {power} W");
        }
    });
}

/// Every ramp ends: these three once did not, and random ones may find another.
#[test]
fn ramps_always_end() {
    let ramp = |model: &str, start: [f64; 2], slope: [f64; 2], h: f64| {
        let mut bench = Bench::new(model, &[("normal_force", start[1])]);
        let moving = axes(&bench)[0].0;
        bench.set(moving, start[0]);
        let (velocity, load) = (bench.column(moving), bench.column("normal_force"));
        bench.instance.set_slope(velocity, slope[0]).unwrap();
        bench.instance.set_slope(load, slope[1]).unwrap();
        bench.instance.step(h).unwrap_or_else(|fault| panic!("{model}: {fault}"));
        let (end, expected) = (bench.get(moving), start[0] + slope[0] * h);
        assert!(abs_diff_eq!(end, expected, epsilon = 1e-12 * expected.abs().max(1.0)), "{model}: {end} m/s");
    };
    ramp("LuGre", [-12.937681463492499, 9.81], [2.019351783521585, 0.0], 6.40688014535203);
    ramp("LuGre", [2.625636091642892, 9.81], [-3.3953052056993305, -12.685609209473386], 0.7733172162254742);
    ramp("LuGre", [-16.620360437482436, 9.81], [103.2993424978118, -60.969405775017975], 0.1608951231989189);
    for model in friction_models() {
        let mut random = Random(29);
        for _ in 0..10 {
            let h = 10f64.powf(-4.0 * random.next());
            let (velocity, end) = (random.signed(), random.signed());
            let (load, end_load) = (20.0 * random.next(), 20.0 * random.next());
            ramp(model.name, [velocity, load], [(end - velocity) / h, (end_load - load) / h], h);
        }
    }
}

#[test]
fn reset_is_fresh_and_restored_is_the_same_future() {
    for model in catalogue::models() {
        let fresh = Bench::new(model.name, &[]).instance.save();
        let inputs: Vec<usize> = (0..model.table.len()).filter(|c| model.table.at(*c).role == Role::Input).collect();
        let mut bench = Bench::new(model.name, &[]);
        if bench.has("external_force") && bench.has("mass") && inputs.len() == 3 {
            bench.set("mass", 1.0);
        }
        let future = |bench: &mut Bench, seed| {
            let mut random = Random(seed);
            for step in 0..1000 {
                for column in &inputs {
                    let start = model.table.at(*column).start;
                    let value = start + 0.01 * random.signed();
                    let value = if model.table.at(*column).admits(value) { value } else { 2.0 * start - value };
                    bench.instance.set_column(*column, value).unwrap();
                    if step % 7 == 0 {
                        bench.instance.set_slope(*column, 1e-3 * random.next()).unwrap();
                    }
                }
                bench.step(1e-3 * (0.5 + random.next()));
            }
            bench.instance.save()
        };
        future(&mut bench, 1);
        let saved = bench.instance.save();
        let once = future(&mut bench, 2);
        bench.instance.restore(&saved);
        assert_eq!(future(&mut bench, 2), once, "{}", model.name);
        bench.instance.reset();
        assert_eq!(bench.instance.save(), fresh, "{}", model.name);
    }
}

/// The time of an instance stays finite, however long its steps are.
#[test]
fn steps_to_an_infinite_time_are_rejected() {
    for model in catalogue::models() {
        let mut bench = Bench::new(model.name, &[]);
        bench.instance.set_time(f64::MAX);
        let before = bench.instance.save();
        assert!(bench.instance.step(f64::MAX).is_err(), "{}", model.name);
        assert_eq!(bench.instance.save(), before, "{}", model.name);
    }
}
