//! Properties that every friction model promises, checked for all models of the catalogue over a grid of their
//! parameters.
//!
//! Models in a plane or in space promise the same for their vectors: the mirrored motion has all odd components
//! negated, the force is measured along the motion, and the dissipated power is the scalar product of force and
//! velocity.

mod common;

use std::collections::HashMap;

use common::Bench;
use common::random::Random;
use stribeck::catalogue::{self, Family};
use stribeck::model::{Kind, ModelType, Role, Variable};

fn friction_models() -> impl Iterator<Item = &'static ModelType> {
    catalogue::documented(Family::Friction).map(|(model, _)| model)
}

/// One of the values.
fn pick(random: &mut Random, values: &[f64]) -> f64 {
    values[(random.next() * values.len() as f64) as usize]
}

/// Parameter sets: the defaults, each parameter at each end and in the middle of its range, and random mixtures.
fn parameter_sets(model: &'static ModelType) -> Vec<Vec<(usize, f64)>> {
    let mut sets = vec![Vec::new()];
    let parameters: Vec<usize> = (0..model.table.len()).filter(|c| model.table[*c].role.is_parameter()).collect();
    for column in &parameters {
        sets.extend(candidates(&model.table[*column]).into_iter().map(|value| vec![(*column, value)]));
    }
    let mut random = Random(7);
    for _ in 0..200 {
        let mixture = parameters.iter().map(|column| (*column, pick(&mut random, &candidates(&model.table[*column]))));
        sets.push(mixture.collect());
    }
    sets.retain(|set| {
        let mut bench = Bench::new(model.name, &[]);
        apply(&mut bench, set);
        bench.instance.check().is_ok()
    });
    sets
}

/// Values of a parameter from one end of its range to the other, around its default and equal to other defaults.
fn candidates(variable: &Variable) -> Vec<f64> {
    let start = if variable.start == 0.0 { 1e-3 } else { variable.start };
    let values: Vec<f64> = match variable.kind {
        Kind::Real(_) => {
            vec![0.0, 1e-3 * start, 0.5 * start, start, 1.5 * start, 2.0 * start, 100.0 * start, 0.1, 0.15]
        }
        _ => (variable.bound.min() as i64..=(variable.bound.max() as i64).min(10)).map(|n| n as f64).collect(),
    };
    values.into_iter().filter(|value| variable.admits(*value)).collect()
}

fn apply(bench: &mut Bench, set: &[(usize, f64)]) {
    for (column, value) in set {
        bench.instance.put(*column, *value);
    }
}

fn describe(model: &ModelType, set: &[(usize, f64)]) -> String {
    let set: Vec<String> =
        set.iter().map(|(column, value)| format!("{} = {value}", model.table[*column].path)).collect();
    format!("{} with {}", model.name, set.join(", "))
}

/// Runs `check` on every friction model with every parameter set.
fn for_all(check: impl Fn(&mut Bench, &str)) {
    let mut cases = 0;
    for model in friction_models() {
        for set in parameter_sets(model) {
            let mut bench = Bench::new(model.name, &[]);
            apply(&mut bench, &set);
            check(&mut bench, &describe(model, &set));
            cases += 1;
        }
    }
    assert!(cases > 60 * friction_models().count(), "only {cases} cases");
}

/// Velocity and force of a model, by components, and the direction of its motion in tests along a line.
const AXES: [(&str, &str, f64); 4] = [
    ("velocity", "friction_force", 1.0),
    ("velocity_x", "friction_force_x", 0.6),
    ("velocity_y", "friction_force_y", -0.8),
    ("velocity_z", "friction_force_z", 0.0),
];

fn axes(bench: &Bench) -> Vec<(&'static str, &'static str, f64)> {
    AXES.into_iter().filter(|(velocity, ..)| bench.has(velocity)).collect()
}

/// Moves the model along a line.
fn set_velocity(bench: &mut Bench, velocity: f64) {
    for (name, _, share) in axes(bench) {
        bench.set(name, share * velocity);
    }
}

/// The force along that line.
fn force(bench: &mut Bench) -> f64 {
    axes(bench).into_iter().map(|(_, name, share)| share * bench.get(name)).sum()
}

/// Upper limit of the force in steady sliding: the static level and the parts that grow with speed.
fn limit(bench: &mut Bench, velocity: f64) -> f64 {
    let value = |bench: &mut Bench, name: &str| if bench.has(name) { bench.get(name) } else { 0.0 };
    let mu = f64::max(value(bench, "mu_s"), value(bench, "mu_k"));
    let (load, speed) = (bench.get("normal_force"), velocity.abs());
    // Specker's law passes through the static level and has its maximum, at most 11 % higher, beyond.
    let overshoot = if bench.has("peak_velocity") { 1.11 } else { 1.0 };
    let power = if value(bench, "variant") == 2.0 { value(bench, "viscous_exponent") } else { 0.0 };
    let viscous = value(bench, "viscous_coefficient") * if power > 0.0 { speed.powf(power) } else { speed };
    let quadratic = value(bench, "quadratic_coefficient") * speed * speed;
    overshoot * mu * load + viscous + quadratic + value(bench, "mu_v") * load * speed
}

/// Columns that change sign when the motion is mirrored. A new model with a new state must be put on one of the lists.
#[rustfmt::skip]
const ODD: &[&str] = &[
    "velocity",
    "external_force",
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "bristle_deflection",
    "bristle_deflection_x",
    "bristle_deflection_y",
    "bristle_deflection_z",
    "element.force",
    "planned_force",
    "end_velocity",
    "end_external_force",
    "velocity_change",
    "external_force_change",
    "lagged_velocity",
    "acceleration",
    "velocity_slope",
    "history.begin",
    "history.end",
    "y_1",
    "y_2",
    "bristle.strain",
    "lagging_force",
    "slip_direction",
];
#[rustfmt::skip]
const EVEN: &[&str] = &[
    "normal_force",
    "normal_x",
    "normal_y",
    "normal_z",
    "dissipated_energy",
    "dwell",
    "element.slipping",
    "stuck",
    "phase",
    "step_size",
    "planning_step",
    "end_normal_force",
    "normal_force_change",
    "has_past",
    "slipping",
    "dwell_time",
    "stribeck_coefficient",
    "history.duration",
    "bristle.draws",
];

/// Whether the bonds of a random law reach so far that single ones push forwards. Its force is then a resistance only
/// on average.
fn is_resisting_on_average(bench: &mut Bench) -> bool {
    bench.has("bristle_count") && 3.0 * (1.0 - bench.get("mu_k") / bench.get("mu_s")) > 1.0
}

#[test]
fn mirrored_motion_gives_the_mirrored_force() {
    for model in friction_models() {
        for variable in model.table.iter().filter(|variable| variable.role.is_state() || variable.role == Role::Input) {
            // The elements of an array are one entry, as in `history.begin`.
            let names: Vec<&str> = variable.path.segments().iter().map(|segment| segment.name).collect();
            let name = names.join(".");
            assert!(ODD.contains(&&*name) != EVEN.contains(&&*name), "{}: put {name} on one list", model.name);
        }
    }
    for_all(|bench, what| {
        let mut mirror = Bench::new(bench.instance.model().name, &[]);
        mirror.instance.restore(&bench.instance.save());
        let mut random = Random(11);
        for _ in 0..20 {
            let scale = 10f64.powf(-6.0 * random.next());
            let moving = axes(bench).into_iter().map(|(name, ..)| (name, scale));
            let odd: Vec<_> = moving.chain([("external_force", 2.0), ("acceleration", 2.0)]).collect();
            for (name, scale) in odd {
                let value = scale * random.signed();
                if bench.has(name) {
                    bench.set(name, value);
                    mirror.set(name, -value);
                }
            }
            let h = 10f64.powf(-4.0 * random.next());
            bench.step(h);
            mirror.step(h);
            for (_, name, _) in axes(bench) {
                let (force, mirrored) = (bench.get(name), mirror.get(name));
                assert_eq!(force, -mirrored, "{what}");
            }
            assert_eq!(bench.get("dissipated_energy"), mirror.get("dissipated_energy"), "{what}");
        }
    });
}

#[test]
fn steady_sliding_dissipates_within_the_static_level() {
    for_all(|bench, what| {
        // A law that plans for a body of known mass cannot follow a velocity impossible for such a body.
        if bench.has("mass") && bench.get("mass") > 0.0 && bench.get("exchange") == 2.0 {
            return;
        }
        for velocity in [-10.0, -0.1, -2e-3, 5e-4, 1e-2, 1.0] {
            set_velocity(bench, velocity);
            // With mass the force would stop the body in a long step.
            // Otherwise it is long enough for the softest contact to yield.
            let h = if bench.has("mass") && bench.get("mass") > 0.0 { 1e-9 } else { 1e9 };
            for _ in 0..3 {
                bench.step(h);
            }
            let force = force(bench);
            assert!(force * velocity >= 0.0 || is_resisting_on_average(bench), "{what}: {force} N at {velocity} m/s");
            let limit = limit(bench, velocity);
            assert!(force.abs() <= limit * (1.0 + 1e-12), "{what}: {force} N at {velocity} m/s, limit {limit} N");
            assert!((bench.get("dissipated_power") - force * velocity).abs() <= 1e-12 * (force * velocity).abs());
        }
    });
}

#[test]
fn no_load_releases_the_contact() {
    for_all(|bench, what| {
        set_velocity(bench, 0.02);
        bench.step(0.01);
        bench.set("normal_force", 0.0);
        if bench.has("external_force") {
            bench.set("external_force", 3.0);
        }
        for velocity in [0.0, 0.02, -1.0] {
            set_velocity(bench, velocity);
            for (_, force, _) in axes(bench) {
                assert_eq!((bench.get(force), bench.get("sticking")), (0.0, 0.0), "{what} before a step");
            }
            bench.step(0.01);
            for (_, force, _) in axes(bench) {
                assert_eq!((bench.get(force), bench.get("sticking")), (0.0, 0.0), "{what} after a step");
            }
            for state in ["", "_x", "_y", "_z"].map(|axis| format!("bristle_deflection{axis}")) {
                if bench.has(&state) {
                    assert_eq!(bench.get(&state), 0.0, "{what}");
                }
            }
        }
    });
}

/// The same in Model Exchange: an event indicator changes its sign where the load vanishes, and the event releases the
/// contact. Its changes are declared.
#[test]
fn an_event_without_load_releases_the_contact() {
    let mut tested = 0;
    for model in friction_models().filter(|model| model.model_exchange && model.find("normal_force").is_some()) {
        let mut bench = Bench::new(model.name, &[]);
        let axes = axes(&bench);
        set_velocity(&mut bench, 0.01);
        bench.step(1e-2);
        let mut row = bench.instance.row().to_vec();
        let put = |row: &mut [f64], name: &str, value: f64| row[model.find(name).unwrap()] = value;
        assert!(model.at_event(&mut row), "{}", model.name);
        let signs = |row: &[f64]| {
            let mut indicators = vec![f64::NAN; model.event_indicators];
            model.indicate(row, &mut indicators);
            assert!(indicators.iter().all(|indicator| *indicator != 0.0), "{} {indicators:?}", model.name);
            indicators.iter().map(|indicator| *indicator > 0.0).collect::<Vec<_>>()
        };
        let loaded = signs(&row);
        put(&mut row, "normal_force", 0.0);
        assert_ne!(signs(&row), loaded, "{} does not detect the loss of its load", model.name);
        let before = row.clone();
        assert!(model.at_event(&mut row), "{}", model.name);
        for (column, variable) in model.table.iter().enumerate() {
            let is_declared = variable.reinit || variable.jumps || row[column] == before[column];
            assert!(is_declared, "{} changes {} at an event", model.name, variable.path);
        }
        let unloaded = signs(&row);
        put(&mut row, "normal_force", 9.81);
        assert_ne!(signs(&row), unloaded, "{} does not detect the return of its load", model.name);
        for (velocity, force, _) in axes {
            put(&mut row, velocity, 0.0);
            assert!(model.at_event(&mut row) && model.output(&mut row), "{}", model.name);
            assert_eq!(row[model.find(force).unwrap()], 0.0, "{} remembers its old load", model.name);
        }
        tested += 1;
    }
    assert!(tested > 20);
}

/// Bristles whose level is set to 0 while they are deflected: a solver would keep a force that a step drops at once,
/// because it only integrates rates. So the shortest step changes little, or the law rejects such a level in Model
/// Exchange.
#[test]
fn a_solver_keeps_no_force_that_a_step_drops() {
    let mut refusing = Vec::new();
    for model in friction_models().filter(|model| model.model_exchange) {
        let Some(mu_k) = model.find("mu_k").filter(|column| model.table[*column].admits(0.0)) else { continue };
        let mut bench = Bench::new(model.name, &[]);
        let axes = axes(&bench);
        set_velocity(&mut bench, 0.01);
        bench.step(1e-2);
        set_velocity(&mut bench, 0.0);
        let mut row = bench.instance.row().to_vec();
        assert_eq!(model.check_exchange(&row), Ok(()), "{}", model.name);
        for column in [Some(mu_k), model.find("mu_s")].into_iter().flatten() {
            row[column] = 0.0;
        }
        assert_eq!(model.check(&row), Ok(()), "{}", model.name);
        if let Err(fault) = model.check_exchange(&row) {
            assert!(fault.to_string().contains(" = 0: must be > 0 in Model Exchange"), "{fault}");
            refusing.push(model.name);
            continue;
        }
        assert!(model.at_event(&mut row) && model.output(&mut row), "{}", model.name);
        let mut stepped = row.clone();
        assert!(model.advance(&mut stepped, 1e-9), "{}", model.name);
        for force in axes.iter().map(|(_, force, _)| model.find(force).unwrap()) {
            let (kept, left) = (row[force], stepped[force]);
            assert!((kept - left).abs() < 1e-4, "{} keeps {kept} N, a step leaves {left} N", model.name);
        }
    }
    assert_eq!(refusing, ["Dahl", "ElastoPlastic", "SpeckerDynamic", "LuGrePlanar", "ElastoPlasticPlanar"]);
}

/// A step ignores the phase found by an event of Model Exchange: it uses the velocity, from the first step on.
#[test]
fn steps_ignore_the_phase_found_by_an_event() {
    let mut tested = 0;
    for model in friction_models().filter(|model| model.find("phase").is_some()) {
        for (mass, exchange) in [(0.0, 1.0), (1.0, 1.0), (1.0, 2.0)] {
            let run = |phase: f64| {
                let values = [
                    ("mass", mass),
                    ("exchange", exchange),
                    ("external_force", 1000.0),
                    ("velocity", 0.02),
                    ("phase", phase),
                ];
                let mut bench = Bench::new(model.name, &values);
                bench.step(1e-3);
                assert_eq!(bench.get("phase"), 1.0, "{}", model.name);
                ["friction_force", "dissipated_energy", "sticking"].map(|name| bench.get(name))
            };
            let free = run(1.0);
            assert!(free[0] != 0.0 && free[0].abs() < 100.0, "{} {free:?}", model.name);
            for phase in [2.0, 3.0, 4.0] {
                assert_eq!(run(phase), free, "{}: phase {phase}, mass {mass}, exchange {exchange}", model.name);
            }
            tested += 1;
        }
    }
    assert!(tested > 20);
}

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
                assert!((one - two).abs() <= 1e-10 * scale.max(one.abs()), "{what}: {name} {one} against {two}");
            }
        }
    });
}

#[test]
fn finite_inputs_give_finite_results_or_a_rejection_that_changes_nothing() {
    let extremes = [0.0, 5e-324, 1e-310, 1e-160, 1e-12, 1e-3, 1.0, 1e6, 1e150, 1e308];
    let steps = [1e-300, 1e-12, 1e-6, 1.0, 1e6, 1e300];
    for_all(|bench, what| {
        let mut random = Random(17);
        for _ in 0..30 {
            let scalars = ["velocity", "normal_force", "external_force", "acceleration"];
            let vectors = ["velocity_x", "velocity_y", "velocity_z", "normal_x", "normal_y", "normal_z"];
            for name in scalars.into_iter().chain(vectors) {
                if bench.has(name) {
                    let sign = if name == "normal_force" { 1.0 } else { pick(&mut random, &[-1.0, 1.0]) };
                    bench.set(name, sign * pick(&mut random, &extremes));
                }
            }
            let before = bench.instance.save();
            match bench.instance.step(pick(&mut random, &steps)) {
                Ok(()) => assert!(bench.instance.row().iter().all(|value| value.is_finite()), "{what}"),
                Err(_) => {
                    assert_eq!(bench.instance.save(), before, "{what}");
                    bench.instance.reset();
                }
            }
        }
    });
}

/// Realistic inputs, as from a vehicle, are never rejected, at any step that a master can choose.
#[test]
fn everyday_inputs_are_never_rejected() {
    for_all(|bench, what| {
        let mut random = Random(19);
        for _ in 0..50 {
            set_velocity(
                bench,
                pick(&mut random, &[0.0, 1e-9, 1e-4, 0.1, 2.0, 20.0]) * pick(&mut random, &[-1.0, 1.0]),
            );
            bench.set("normal_force", pick(&mut random, &[0.0, 1e-9, 1e-3, 10.0, 2e4]));
            let h = pick(&mut random, &[2e-13, 1e-6, 1e-4, 1e-3, 0.1, 1.0]);
            bench.instance.step(h).unwrap_or_else(|fault| panic!("{what}: {fault}"));
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
            for (column, _) in model.table.iter().enumerate().filter(|(_, variable)| variable.role == Role::Input) {
                let value = bench.instance.row()[column] + 5e-3 * random.signed();
                bench.instance.put(column, value);
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
            assert!((rate - power).abs() <= 1e-12 * power.abs(), "{what}: {rate} W against {power} W");
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
        bench.instance.put_slope(velocity, slope[0]);
        bench.instance.put_slope(load, slope[1]);
        bench.instance.step(h).unwrap_or_else(|fault| panic!("{model}: {fault}"));
        let (end, expected) = (bench.get(moving), start[0] + slope[0] * h);
        assert!((end - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{model}: {end} m/s");
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
        let inputs: Vec<usize> = (0..model.table.len()).filter(|c| model.table[*c].role == Role::Input).collect();
        let mut bench = Bench::new(model.name, &[]);
        if bench.has("external_force") && bench.has("mass") && inputs.len() == 3 {
            bench.set("mass", 1.0);
        }
        let future = |bench: &mut Bench, seed| {
            let mut random = Random(seed);
            for step in 0..1000 {
                for column in &inputs {
                    let start = model.table[*column].start;
                    let value = start + 0.01 * random.signed();
                    let value = if model.table[*column].admits(value) { value } else { 2.0 * start - value };
                    bench.instance.put(*column, value);
                    if step % 7 == 0 {
                        bench.instance.put_slope(*column, 1e-3 * random.next());
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

/// One quantity, one name: if two models have the same name, its unit, type and help text are the same.
#[test]
fn equal_names_mean_equal_things() {
    let mut seen: HashMap<String, (&str, &Variable)> = HashMap::new();
    for model in friction_models() {
        for variable in model.table {
            let name = variable.path.to_string();
            let (other, first) = *seen.entry(name.clone()).or_insert((model.name, variable));
            // Every model has variants of its own.
            if name != "variant" {
                assert_eq!(first.kind, variable.kind, "{name} in {other} and {}", model.name);
            }
            assert_eq!(first.help, variable.help, "{name} in {other} and {}", model.name);
            assert_eq!(first.role, variable.role, "{name} in {other} and {}", model.name);
        }
    }
    assert!(seen.len() > 10);
}

#[test]
fn every_friction_model_has_the_common_columns() {
    for model in friction_models() {
        let role = |name: &str| model.find(name).map(|column| model.table[column].role);
        let axes = axes(&Bench::new(model.name, &[]));
        assert!([1, 2, 3].contains(&axes.len()), "{}", model.name);
        for input in axes.iter().map(|(velocity, ..)| *velocity).chain(["normal_force"]) {
            assert_eq!(role(input), Some(Role::Input), "{} {input}", model.name);
        }
        for output in axes.iter().map(|(_, force, _)| *force).chain(["dissipated_power", "sticking"]) {
            assert_eq!(role(output), Some(Role::Output), "{} {output}", model.name);
        }
        assert_eq!(role("dissipated_energy"), Some(Role::StateOutput), "{}", model.name);
        let start = model.find("normal_force").map(|column| model.table[column].start);
        assert_eq!(start, Some(9.81), "{}: m g of the benchmark", model.name);
    }
}

/// The static coefficient must not be below the kinetic one; the message names both.
#[test]
fn inverted_coefficients_are_rejected_by_name() {
    for model in friction_models().filter(|model| model.find("mu_s").is_some()) {
        let mut bench = Bench::new(model.name, &[("mu_s", 0.05)]);
        let before = bench.instance.save();
        let fault = bench.instance.step(1e-3).expect_err("mu_s < mu_k");
        assert_eq!(fault.to_string(), "mu_s = 0.05: must be >= mu_k = 0.1", "{}", model.name);
        assert_eq!(bench.instance.save(), before, "{}", model.name);
    }
}

/// A preset names variables of its model, with permitted and consistent values, and gives its source.
#[test]
fn presets_are_valid_parameter_sets_with_a_source() {
    for model in catalogue::models() {
        for preset in model.presets {
            assert!(!preset.source.is_empty() && preset.source.is_ascii(), "{} {}", model.name, preset.name);
            let mut bench = Bench::new(model.name, &[]);
            for (name, value) in preset.values {
                let variable = &model.table[bench.column(name)];
                assert!(variable.admits(*value), "{} {}: {name} = {value}", model.name, preset.name);
                assert_ne!(variable.role, Role::Output, "{} {}: {name}", model.name, preset.name);
            }
            assert!(bench.instance.apply(preset.name));
            for (name, value) in preset.values {
                assert_eq!(bench.get(name), *value);
            }
            bench.instance.check().unwrap_or_else(|fault| panic!("{} {}: {fault}", model.name, preset.name));
        }
        assert!(!Bench::new(model.name, &[]).instance.apply("no such preset"));
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

/// At an event a contact at rest is held as long as the static level carries the load. Until the next event its phase
/// does not change, even where a solver tries values beyond; its indicator falls below zero there: past the rest of a
/// sliding body, beyond the static level, and for a held body that is moved otherwise.
#[test]
fn events_catch_and_release_contacts_at_rest() {
    let mut seen = 0;
    for model in friction_models().filter(|model| model.model_exchange && model.event_indicators >= 2) {
        let mut bench = Bench::new(model.name, &[("normal_force", 10.0)]);
        let level = if bench.has("mu_s") { 10.0 * bench.get("mu_s") } else { 10.0 * bench.get("mu_k") };
        let goes_on = |bench: &Bench| {
            let mut indicators = vec![f64::NAN; model.event_indicators];
            bench.instance.indicate(&mut indicators).expect("finite indicators");
            assert_ne!(indicators[0], 0.0, "{}", model.name);
            indicators[0] > 0.0
        };
        bench.set("external_force", 0.5 * level);
        // A law with a band around rest does not hold a body.
        if bench.get("friction_force") != 0.5 * level || bench.has("transition_velocity") {
            continue;
        }
        seen += 1;
        for velocity in [2e-3, -3e-4] {
            bench.set("velocity", velocity);
            bench.instance.at_event().expect("an event");
            assert_eq!(bench.get("sticking"), 0.0, "{}", model.name);
            assert!(goes_on(&bench), "{}", model.name);
            bench.set("velocity", -1e-8 * velocity.signum());
            assert!(bench.get("friction_force") * velocity > 0.0, "{}: as before the event", model.name);
            assert!(!goes_on(&bench), "{}: past its rest", model.name);
        }
        for share in [0.2, -0.7, 0.999] {
            bench.set("velocity", 0.0);
            bench.set("external_force", share * level);
            bench.instance.at_event().expect("an event");
            assert_eq!((bench.get("sticking"), bench.get("friction_force")), (1.0, share * level), "{}", model.name);
            for nearly in [1.0 - 3e-8, 1.0 + 3e-8] {
                bench.set("external_force", nearly * level);
                assert_eq!(goes_on(&bench), nearly < 1.0, "{} {share}", model.name);
            }
            bench.set("external_force", share * level);
            bench.set("velocity", 2e-6);
            assert!(!goes_on(&bench), "{}: moved otherwise", model.name);
        }
        bench.set("velocity", 0.0);
        bench.set("external_force", 1.01 * level);
        bench.instance.at_event().expect("an event");
        let force = bench.get("friction_force");
        assert!(bench.get("sticking") == 0.0 && force > 0.0 && force <= level, "{}: {force} N", model.name);
    }
    assert!(seen >= 4, "{seen} laws");
}

/// The events of Karnopp's law are at the edge of its band, on the way out and on the way in.
#[test]
fn leaving_and_entering_the_band_are_events() {
    let mut bench = Bench::new("Karnopp", &[]);
    let edge = bench.get("transition_velocity");
    let mut indicators = vec![f64::NAN; bench.instance.model().event_indicators];
    for share in [0.5, -0.5, 1.5, -1.5] {
        bench.set("velocity", share * edge);
        bench.instance.at_event().expect("an event");
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        assert!(indicators[0] > 0.0, "{indicators:?}");
        bench.set("velocity", (2.0 - share.abs()) * share.signum() * edge);
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        assert!(indicators[0] < 0.0, "{indicators:?}");
    }
}

/// Laws with a band around rest report sticking inside it.
#[test]
fn a_band_around_rest_is_sticking_within_its_edge() {
    for (model, edge) in [
        ("Karnopp", "transition_velocity"),
        ("BrownMcPhee", "transition_velocity"),
        ("Hollars", "transition_velocity"),
        ("Threlfall", "transition_velocity"),
        ("Ambrosio", "sliding_velocity"),
        ("Specker", "peak_velocity"),
    ] {
        let mut bench = Bench::new(model, &[]);
        let edge = bench.get(edge);
        for share in [0.01, 0.5, 0.99, 1.01, 1.5, 100.0] {
            for velocity in [share * edge, -share * edge] {
                bench.set("velocity", velocity);
                assert_eq!(bench.get("sticking") == 1.0, share < 1.0, "{model} at {velocity} m/s");
            }
        }
    }
}

/// From rest a law with bristles is elastic at first, and sticks; after a long distance it slides. Both directions are
/// equal.
#[test]
fn bristles_stick_at_first_and_slide_in_the_end() {
    let mut seen = 0;
    let has_bristles = |model: &&ModelType| model.find("sigma_0").is_some() || model.name == "BlimanSorine";
    for model in friction_models().filter(has_bristles) {
        for velocity in [1e-5, -1e-5] {
            let mut bench = Bench::new(model.name, &[]);
            set_velocity(&mut bench, velocity);
            bench.step(1e-6);
            assert_eq!(bench.get("sticking"), 1.0, "{} after 10 pm at {velocity} m/s", model.name);
            set_velocity(&mut bench, 5e3 * velocity);
            for _ in 0..1000 {
                bench.step(1e-3);
            }
            assert_eq!(bench.get("sticking"), 0.0, "{} after 50 mm towards {velocity}", model.name);
        }
        seen += 1;
    }
    assert!(seen >= 10, "{seen} laws");
}

/// Without the part caused by the load, the viscous part remains: its energy is that of a linear damper. The force of
/// Specker's dynamic law reaches it with a lag.
#[test]
fn a_loaded_contact_without_dry_friction_is_a_damper() {
    let mut seen = 0;
    let is_damped = |model: &&ModelType| model.find("viscous_coefficient").is_some() && model.name != "SpeckerDynamic";
    for model in friction_models().filter(is_damped) {
        let mut bench = Bench::new(model.name, &[("normal_force", 10.0), ("viscous_coefficient", 3.0)]);
        for name in ["mu_s", "mu_k"] {
            if bench.has(name) {
                bench.set(name, 0.0);
            }
        }
        if bench.instance.check().is_err() {
            continue;
        }
        seen += 1;
        set_velocity(&mut bench, 0.02);
        for _ in 0..4 {
            bench.step(0.125);
        }
        let (found, energy) = (bench.get("dissipated_energy"), 3.0 * 0.02 * 0.02 * 0.5);
        assert!((found - energy).abs() < 1e-12, "{}: {found} J instead of {energy} J", model.name);
        assert!((force(&mut bench) - 0.06).abs() < 1e-12, "{}", model.name);
    }
    assert!(seen >= 10, "{seen} laws");
}
