//! Steady sliding in closed form against steps until nothing changes.

use super::settled::by_steps;
use super::*;
use crate::catalogue::{by_name, models};
use crate::model::{Kind, ModelType, Role};
use crate::numerics::random::uniform;

static NEVER: AtomicBool = AtomicBool::new(false);

/// Velocities in m/s and loads in N.
const VELOCITIES: [f64; 9] = [0.0, 1e-6, -4e-4, 2e-3, -0.03, 0.3, -2.0, 40.0, -1e-9];
const LOADS: [f64; 5] = [0.0, 1e-9, 3.0, 800.0, 1e6];

/// Changes an instance to drawn parameters: factors from 1/2 to 2, and any choice that admits them. False if the law does
/// not admit them together.
fn draw(instance: &mut Instance, seed: i32) -> bool {
    let model = instance.model();
    for (column, variable) in model.variables().filter(|(_, variable)| variable.role.is_parameter()) {
        let share = uniform(seed, 1, column as u64);
        let value = match variable.kind {
            // With a mass there is no steady sliding.
            Kind::Real(_) if variable.start != 0.0 => {
                variable.bound.nearest(variable.start * f64::powf(4.0, share - 0.5))
            }
            Kind::Enumeration(_) => 1.0 + f64::from(share > 0.5),
            _ => continue,
        };
        // Refused: a choice that the list does not have.
        let _ = instance.set_column(column, value);
    }
    instance.check().is_ok()
}

fn along(model: &ModelType, name: &str) -> Vec<usize> {
    [name.into(), format!("{name}_x"), format!("{name}_y")].iter().filter_map(|name| model.find(name)).collect()
}

/// Holds drawn inputs from the state that other ones have left. Returns the results by both ways.
fn both_ways(instance: &mut Instance, seed: i32) -> Option<[Vec<f64>; 2]> {
    let model = instance.model();
    let pick = |list: &[f64], sequence| list[(uniform(seed, sequence, 0) * list.len() as f64 - 1e-9) as usize];
    let mut inputs: Vec<(usize, f64)> = Vec::new();
    for (column, variable) in model.variables().filter(|(_, variable)| variable.role == Role::Input) {
        let list = if variable.path.is_spelled("normal_force") { &LOADS[..] } else { &VELOCITIES[..] };
        inputs.push((column, pick(list, column as u64)));
    }
    let before = inputs.iter().map(|(column, value)| (*column, value.abs() * 0.7 + 1e-4));
    instance.set_all(crate::instance::Phase::Stepping, before).ok()?;
    instance.step(3e-3).ok()?;
    let results = along(model, "friction_force");
    instance.set_all(crate::instance::Phase::Stepping, inputs.iter().copied()).ok()?;
    let start = instance.save();
    let mut stepped = vec![f64::NAN; results.len()];
    by_steps(instance, &inputs, &results, &mut stepped, &NEVER).ok()?;
    instance.restore(&start);
    assert!(instance.slide_steadily().unwrap(), "{}", model.name);
    let read = |instance: &mut Instance| results.iter().map(|column| instance.get_column(*column).unwrap()).collect();
    let closed: Vec<f64> = read(instance);
    // What slides steadily goes on to.
    instance.step(1e-3).unwrap();
    let later: Vec<f64> = read(instance);
    let is_same = closed.iter().zip(&later).all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs());
    assert!(is_same, "{} {seed}: {closed:?}, then {later:?}", model.name);
    Some([closed, stepped])
}

/// Of every law with a closed form, over drawn parameters, velocities and loads.
#[test]
fn closed_forms_are_what_steps_lead_to() {
    let mut tried = 0;
    for model in models().filter(|model| !along(model, "friction_force").is_empty()) {
        let mut instance = Instance::new(model);
        if !model.slides_steadily(instance.row()) {
            continue;
        }
        let mut compared = 0;
        for seed in 0..60 {
            instance.reset();
            if !draw(&mut instance, seed) {
                continue;
            }
            let Some([closed, stepped]) = both_ways(&mut instance, seed) else { continue };
            let scale = stepped.iter().map(|force| force.abs()).fold(1e-300, f64::max);
            let differ = closed.iter().zip(&stepped).any(|(a, b)| (a - b).abs() > 1e-7 * scale);
            assert!(!differ, "{} {seed}: {closed:?} {stepped:?} at {:?}", model.name, instance.row());
            compared += 1;
        }
        assert!(compared >= 15, "{}: {compared}", model.name);
        tried += 1;
    }
    assert!(tried >= 36, "{tried}");
}

/// A law with mass, which has a force per step, and the bristles that snap at random have no closed form.
#[test]
fn some_have_no_closed_form() {
    let mut held = Instance::new(by_name("Coulomb").unwrap());
    assert!(held.slide_steadily().unwrap());
    held.set_by_name("mass", 1.0).unwrap();
    assert!(!held.slide_steadily().unwrap());
    assert!(!Instance::new(by_name("Bristle").unwrap()).slide_steadily().unwrap());
}

/// Parameters that do not fit together, and forces beyond the largest number.
#[test]
fn refusals_change_nothing() {
    let mut instance = Instance::new(by_name("LuGre").unwrap());
    instance.set_by_name("mu_s", 0.05).unwrap();
    let before = instance.save();
    assert!(instance.slide_steadily().unwrap_err().to_string().starts_with("mu_s = 0.05: must be"));
    assert_eq!(instance.save(), before);
    instance.set_by_name("mu_s", 0.2).unwrap();
    instance.set_by_name("velocity", 1e200).unwrap();
    let before = instance.save();
    let text = instance.slide_steadily().unwrap_err().to_string();
    assert!(text.starts_with("the outputs of steady sliding would not be finite at velocity = 1e200"), "{text}");
    assert_eq!(instance.save(), before);
}
