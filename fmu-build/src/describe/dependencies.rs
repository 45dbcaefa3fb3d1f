//! Which output depends on which other column, found by trying.
//!
//! A dependency that is declared by hand can be wrong; this one is observed. Many rows are drawn at random, with zeros,
//! tiny and large values of both signs, limits and start values; then one column at a time is changed. An output depends
//! on a column if changing that column alone ever changed it.

use std::collections::BTreeSet;

use fastrand::Rng;
use stribeck::model::{Kind, ModelType, Role, Variable};

/// Rows that are tried per model (chosen: the rarest case of the present models without arrays, a contact of
/// `CoulombStiction` that sticks or slides for the only reason that it did so before, takes up to 2000; of those with
/// arrays, the strut whose lower contact asks for the acceleration takes some 30,000).
fn rows(model: &ModelType) -> usize {
    if has_elements(model) { 60_000 } else { 20_000 }
}

/// Whether the model has arrays, itself or in a part: trying does not find every one of their elements.
pub fn has_elements(model: &ModelType) -> bool {
    let is_element = |variable: &Variable| variable.path.segments().iter().any(|segment| segment.index > 0);
    model.table.iter().any(is_element)
}

/// Whether the derivatives of its states are tried, too.
fn has_rates(model: &ModelType) -> bool {
    model.model_exchange && !has_elements(model)
}

/// For each column, which of the `candidates` its value is computed from; empty for columns that are not computed. Then
/// the same for the time derivatives of the columns, if the model is offered for Model Exchange and has no arrays.
pub fn of(model: &ModelType, candidates: impl Fn(usize) -> bool) -> Vec<BTreeSet<usize>> {
    let columns = model.table.len();
    let (known, mut computed): (Vec<usize>, Vec<usize>) =
        (0..columns).partition(|column| !model.table[*column].role.is_computed());
    let known: Vec<usize> = known.into_iter().filter(|column| candidates(*column)).collect();
    if has_rates(model) {
        computed.extend(model.continuous_states().map(|state| columns + state));
    }
    let mut found = vec![BTreeSet::new(); 2 * columns];
    // Any seed will do; a fixed one makes every run the same.
    let mut rng = Rng::with_seed(1);
    for _ in 0..rows(model) {
        let mut row = draw_row(model, &mut rng);
        if !evaluate(model, &mut row) {
            continue;
        }
        for &column in &known {
            let mut changed = row[..columns].to_vec();
            changed[column] = draw(&model.table[column], &mut rng);
            if changed[column] == row[column] || !evaluate(model, &mut changed) {
                continue;
            }
            for &output in computed.iter().filter(|output| changed[**output] != row[**output]) {
                found[output].insert(column);
            }
        }
    }
    found
}

/// Computes the outputs of the row and appends its time derivatives; false if the model refuses it or asks for more.
fn evaluate(model: &ModelType, row: &mut Vec<f64>) -> bool {
    // A row by itself has no memory beside it.
    if model.check(row).is_err() || model.memory_in_use(row) > 0 || !model.output(row) {
        return false;
    }
    let columns = row.len();
    row.resize(2 * columns, 0.0);
    let (row, rate) = row.split_at_mut(columns);
    if has_rates(model) {
        model.rate(row, rate);
    }
    rate.iter().all(|rate| rate.is_finite())
}

/// A row in which some columns, from a few to all, have left their start values.
fn draw_row(model: &ModelType, rng: &mut Rng) -> Vec<f64> {
    let share = rng.f64();
    let value = |variable: &Variable| if rng.f64() < share { draw(variable, rng) } else { variable.start };
    let mut row: Vec<f64> = model.table.iter().map(value).collect();
    if rng.bool() {
        remember_inputs(model, &mut row, rng);
    }
    row
}

/// Gives three of four states the value of an input with the same unit: a model may do something else as long as an input
/// is what it was at the end of a step. A state that carries the name of an input, as `end_normal_force`, gets that one.
fn remember_inputs(model: &ModelType, row: &mut [f64], rng: &mut Rng) {
    for (column, variable) in model.table.iter().enumerate() {
        if !variable.role.is_state() || !matches!(variable.kind, Kind::Real(_)) || rng.u8(0..4) == 0 {
            continue;
        }
        let is_alike = |other: &usize| {
            let other = &model.table[*other];
            other.role == Role::Input && other.kind == variable.kind
        };
        let mut alike: Vec<usize> = (0..row.len()).filter(is_alike).collect();
        let is_named = |input: &usize| variable.path.to_string().ends_with(&model.table[*input].path.to_string());
        if let Some(named) = alike.iter().copied().find(is_named) {
            alike = vec![named];
        }
        if let Some(input) = rng.choice(alike).filter(|input| variable.admits(row[*input])) {
            row[column] = row[input];
        }
    }
}

/// A value within the bound of the variable.
fn draw(variable: &Variable, rng: &mut Rng) -> f64 {
    let value = match variable.kind {
        Kind::Real(_) => draw_real(variable, rng),
        Kind::Integer => f64::from(rng.i32(-100..=100)),
        Kind::Boolean => f64::from(rng.i32(0..=1)),
        Kind::Enumeration(items) => f64::from(rng.i32(1..=items.items.len() as i32)),
    };
    if variable.admits(value) { value } else { variable.start }
}

fn draw_real(variable: &Variable, rng: &mut Rng) -> f64 {
    let scale = variable.nominal.max(variable.start.abs());
    // Half of the magnitudes are near the usual one, where the laws bend; the others reach far, mostly down.
    let decades = if rng.bool() { 2.0 * rng.f64() - 1.0 } else { 12.0 * rng.f64() - 9.0 };
    let magnitude = scale * 10f64.powf(decades);
    let (min, max) = crate::describe::text::limits(variable);
    match rng.u8(0..8) {
        0 => 0.0,
        1 => min.or(max).unwrap_or(-magnitude),
        2 => max.unwrap_or(magnitude),
        3 => min.zip(max).map_or(variable.start, |(min, max)| min + (max - min) * rng.f64()),
        4 => -magnitude,
        5 => variable.start * 2.0 * rng.f64(),
        _ => magnitude,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(model: &ModelType, columns: Vec<usize>) -> Vec<String> {
        columns.into_iter().map(|column| model.table[column].path.to_string()).collect()
    }

    /// Asserts what an output depends on: the inputs, then the other columns, each in the order of the table.
    fn assert_depends(model: &str, output: &str, expected_inputs: &[&str], expected_others: &[&str]) {
        let model = stribeck::catalogue::by_name(model).unwrap();
        let all = of(model, |_| true).swap_remove(model.find(output).unwrap());
        let is_input = |column: &usize| model.table[*column].role == Role::Input;
        let (inputs, others): (Vec<_>, Vec<_>) = all.into_iter().partition(is_input);
        assert_eq!(names(model, inputs), expected_inputs, "{}: inputs of {output}", model.name);
        assert_eq!(names(model, others), expected_others, "{}: others of {output}", model.name);
    }

    /// Columns a friction force depends on where `mass` may be given: the last step, and the course of the inputs in it.
    const STEPPING: [&str; 10] = [
        "mass",
        "exchange",
        "step_size",
        "planned_force",
        "end_velocity",
        "end_external_force",
        "end_normal_force",
        "velocity_change",
        "external_force_change",
        "normal_force_change",
    ];

    /// Positions and velocities are states: a host that fed its input through would close an algebraic loop.
    #[test]
    fn belt_rig_feeds_no_input_through() {
        assert_depends("BeltRig", "velocity", &[], &["belt_velocity", "block_velocity"]);
        assert_depends("BeltRig", "external_force", &[], &["stiffness", "position"]);
        assert_depends("BeltRig", "position", &[], &[]);
    }

    /// The force depends on all symbols of eq. (6.30), and with `mass` on the step ahead. Whether the contact sticks
    /// depends on v_0 alone, unless there is no load; after a step with `mass`, on the velocity at its beginning.
    #[test]
    fn brown_mcphee() {
        let inputs = ["velocity", "normal_force", "external_force"];
        let law = ["mu_k", "mu_s", "transition_velocity", "viscous_coefficient", "transition_normal_force"];
        let law: Vec<_> = law.into_iter().chain(STEPPING).collect();
        assert_depends("BrownMcPhee", "friction_force", &inputs, &law);
        assert_depends("BrownMcPhee", "dissipated_power", &inputs, &law);
        let step = [
            "mass",
            "step_size",
            "end_velocity",
            "end_external_force",
            "end_normal_force",
            "velocity_change",
            "normal_force_change",
        ];
        let sticking: Vec<_> = ["transition_velocity"].into_iter().chain(step).chain(["phase"]).collect();
        assert_depends("BrownMcPhee", "sticking", &inputs, &sticking);
    }

    /// The stuck contact carries the external force; the columns of time stepping count because `mass` may be given.
    #[test]
    fn laws_with_stiction_depend_on_the_external_force() {
        let inputs = ["velocity", "normal_force", "external_force"];
        let step =
            ["mass", "step_size", "end_velocity", "end_external_force", "end_normal_force", "normal_force_change"];
        for (model, band) in [("CoulombStiction", None), ("Karnopp", Some("transition_velocity"))] {
            let law: Vec<_> =
                ["mu_k", "mu_s"].into_iter().chain(band).chain(["stuck"]).chain(STEPPING).chain(["phase"]).collect();
            assert_depends(model, "friction_force", &inputs, &law);
            assert_depends(model, "dissipated_power", &inputs, &law);
            let sticking: Vec<_> =
                ["mu_s"].into_iter().chain(band).chain(["stuck"]).chain(step).chain(["phase"]).collect();
            assert_depends(model, "sticking", &inputs, &sticking);
        }
    }

    /// The force of Dahl's law is that of the deflected bristles: it follows the velocity only by way of a step.
    #[test]
    fn dahl_does_not_feed_the_velocity_through_to_the_force() {
        assert_depends("Dahl", "friction_force", &["normal_force"], &["sigma_0", "bristle_deflection"]);
        let inputs = ["velocity", "normal_force"];
        assert_depends("Dahl", "dissipated_power", &inputs, &["sigma_0", "bristle_deflection"]);
        assert_depends("Dahl", "sticking", &inputs, &["mu_k", "sigma_0", "alpha", "bristle_deflection"]);
    }

    /// An array inside a part is one, too: a few of its elements, found by chance, are not the dependencies.
    #[test]
    fn arrays_of_parts_are_arrays() {
        for (model, expected) in [("CoilSpring", true), ("HydraulicDamper", true), ("GasSpring", false)] {
            assert_eq!(has_elements(stribeck::catalogue::by_name(model).unwrap()), expected, "{model}");
        }
    }

    /// The damping enters the force but not the question whether the bristles still move; the energy enters nothing.
    #[test]
    fn lugre() {
        let inputs = ["velocity", "normal_force"];
        let level = ["mu_k", "mu_s", "stribeck_velocity", "stribeck_exponent", "sigma_0"];
        let damping = ["sigma_1", "viscous_coefficient", "damping_velocity"];
        let law: Vec<_> = level.into_iter().chain(damping).chain(["bristle_deflection"]).collect();
        assert_depends("LuGre", "friction_force", &inputs, &law);
        assert_depends("LuGre", "dissipated_power", &inputs, &law);
        let sticking: Vec<_> = level.into_iter().chain(["bristle_deflection"]).collect();
        assert_depends("LuGre", "sticking", &inputs, &sticking);
    }
}
