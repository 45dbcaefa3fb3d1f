//! Properties that every friction model promises, checked for all models of the catalogue over a grid of their
//! parameters: one subject per file, and what they share.
//!
//! Models in a plane or in space promise the same for their vectors: the mirrored motion has all odd components
//! negated, the force is measured along the motion, and the dissipated power is the scalar product of force and
//! velocity.

mod breakaway;
mod contact;
mod events;
mod inputs;
mod passivity;
mod rates;
mod steps;
mod tables;

use crate::common::Bench;
use crate::common::random::Random;
use stribeck::catalogue::{self, Family};
use stribeck::model::{Kind, Meaning, ModelType, Variable};

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
    let parameters: Vec<usize> = (0..model.table.len()).filter(|c| model.table.at(*c).role.is_parameter()).collect();
    for column in &parameters {
        sets.extend(candidates(&model.table.at(*column)).into_iter().map(|value| vec![(*column, value)]));
    }
    let mut random = Random(7);
    for _ in 0..200 {
        let mixture =
            parameters.iter().map(|column| (*column, pick(&mut random, &candidates(&model.table.at(*column)))));
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
        bench.instance.set_column(*column, *value).unwrap();
    }
}

fn describe(model: &ModelType, set: &[(usize, f64)]) -> String {
    let set: Vec<String> =
        set.iter().map(|(column, value)| format!("{} = {value}", model.table.at(*column).path)).collect();
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
    let rolling = if bench.has("lever_arm") { bench.get("lever_arm") / bench.get("wheel_radius") } else { 0.0 };
    let levels = [Meaning::StaticLevel, Meaning::KineticLevel].map(|level| bench.of_meaning(level).unwrap_or(0.0));
    let (load, speed) = (bench.get("normal_force"), velocity.abs());
    let mu = rolling.max(levels[0]).max(levels[1] + logarithmic(bench, speed));
    // Specker's law passes through the static level and has its maximum, at most 11 % higher, beyond.
    let overshoot = if bench.has("peak_velocity") { 1.11 } else { 1.0 };
    let power = if value(bench, "variant") == 2.0 { value(bench, "viscous_exponent") } else { 0.0 };
    let viscous =
        bench.of_meaning(Meaning::Viscous).unwrap_or(0.0) * if power > 0.0 { speed.powf(power) } else { speed };
    let quadratic = value(bench, "quadratic_coefficient") * speed * speed;
    let warming = if bench.has("temperature") { bench.get("temperature") - 293.15 } else { 0.0 };
    let excess = value(bench, "excess_force") * (1.0 + value(bench, "excess_by_temperature") * warming);
    let without_load = value(bench, "kinetic_force") + excess;
    let thinning = if warming == 0.0 { 1.0 } else { (-warming / bench.get("viscous_temperature")).exp() };
    let cold = value(bench, "viscous_coefficient_cold") * thinning * speed;
    overshoot * mu * load + without_load + viscous + cold + quadratic + value(bench, "mu_v") * load * speed
}

/// Upper bound of what a logarithmic law adds to its level in steady sliding:
/// a asinh(y / 2) <= a ln(1 + y) <= max(0, a ln y) + a ln 2, with a ln y = mu_0 + (a - b) ln(v / v_0).
fn logarithmic(bench: &mut Bench, speed: f64) -> f64 {
    if !bench.has("direct_effect") {
        return 0.0;
    }
    let names = ["mu_0", "direct_effect", "evolution_effect", "reference_velocity"];
    let [mu_0, a, b, v_0] = names.map(|name| bench.get(name));
    ((a - b) * (speed / v_0).ln()).max(-mu_0) + a * 2f64.ln()
}

/// Whether the bonds of a random law reach so far that single ones push forwards. Its force is then a resistance only
/// on average.
fn is_resisting_on_average(bench: &mut Bench) -> bool {
    bench.has("bristle_count") && 3.0 * (1.0 - bench.get("mu_k") / bench.get("mu_s")) > 1.0
}
