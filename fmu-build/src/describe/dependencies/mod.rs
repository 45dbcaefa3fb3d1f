//! Which output depends on which other column.
//!
//! A dependency that is declared by hand can be wrong; these follow from the equations.

mod exact;
mod expression;
mod tracked;

pub use exact::of;
pub use tracked::Found;

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use fastrand::Rng;
    use stribeck::catalogue;
    use stribeck::model::{Kind, ModelType, Role, Variable};

    use super::*;
    use crate::describe::text::limits;

    fn names(model: &ModelType, columns: Vec<usize>) -> Vec<String> {
        columns.into_iter().map(|column| model.table.at(column).path.to_string()).collect()
    }

    /// Asserts what an output depends on: the inputs, then the other columns, each in the order of the table.
    fn assert_depends(model: &str, output: &str, expected_inputs: &[&str], expected_others: &[&str]) {
        let model = stribeck::catalogue::by_name(model).unwrap();
        let all = of(model).unwrap()[model.find(output).unwrap()].clone();
        let is_input = |column: &usize| model.table.at(*column).role == Role::Input;
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

    /// Those of them that decide whether the contact sticks.
    const LAST_STEP: [&str; 8] = [
        "mass",
        "step_size",
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
        let sticking: Vec<_> = ["transition_velocity"].into_iter().chain(LAST_STEP).chain(["phase"]).collect();
        assert_depends("BrownMcPhee", "sticking", &inputs, &sticking);
    }

    /// The stuck contact carries the external force; the columns of time stepping count because `mass` may be given.
    #[test]
    fn laws_with_stiction_depend_on_the_external_force() {
        let inputs = ["velocity", "normal_force", "external_force"];
        for (model, band) in [("CoulombStiction", None), ("Karnopp", Some("transition_velocity"))] {
            let law: Vec<_> =
                ["mu_k", "mu_s"].into_iter().chain(band).chain(["stuck"]).chain(STEPPING).chain(["phase"]).collect();
            assert_depends(model, "friction_force", &inputs, &law);
            assert_depends(model, "dissipated_power", &inputs, &law);
            let sticking: Vec<_> =
                ["mu_s"].into_iter().chain(band).chain(["stuck"]).chain(LAST_STEP).chain(["phase"]).collect();
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

    /// Two roads to the same set: nothing that a change of one column changes is missing.
    #[test]
    fn equations_have_every_dependency_that_trials_find() {
        for model in catalogue::models() {
            let exact = of(model).unwrap_or_else(|| panic!("{}: a value decides", model.name));
            for (column, (exact, tried)) in exact.iter().zip(tried(model)).enumerate() {
                let missing = tried.difference(exact).copied().collect();
                assert!(tried.is_subset(exact), "{}: column {column}: {:?}", model.name, names(model, missing));
            }
        }
    }

    /// Rows that are tried per model (chosen).
    const ROWS: usize = 200;

    /// Dependencies found by changing one column of a random row at a time, in the order of [`of`].
    fn tried(model: &ModelType) -> Vec<BTreeSet<usize>> {
        let table: Vec<Variable> = model.table.iter().collect();
        let is_computed = |column: usize| column >= table.len() || table[column].role.is_computed();
        let mut found = vec![BTreeSet::new(); 2 * table.len()];
        // Any seed will do; a fixed one makes every run the same.
        let mut rng = Rng::with_seed(1);
        for _ in 0..ROWS {
            let row = draw_row(&table, &mut rng);
            let Some(results) = evaluated(model, row.clone()) else { continue };
            for column in (0..table.len()).filter(|column| !is_computed(*column)) {
                let mut changed = row.clone();
                changed[column] = draw(&table[column], &mut rng);
                let Some(others) = evaluated(model, changed) else { continue };
                let differs = |result: &usize| is_computed(*result) && others[*result] != results[*result];
                (0..results.len().min(others.len())).filter(differs).for_each(|result| {
                    found[result].insert(column);
                });
            }
        }
        found
    }

    /// Outputs of the row, then its time derivatives unless Model Exchange refuses it; none if the model does, or asks
    /// for more than a row.
    fn evaluated(model: &ModelType, mut row: Vec<f64>) -> Option<Vec<f64>> {
        if model.check(&row).is_err() || model.memory_in_use(&row) > 0 || !model.output(&mut row) {
            return None;
        }
        if model.model_exchange && model.check_model_exchange(&row).is_ok() {
            let mut rates = vec![0.0; row.len()];
            model.rate(&row, &mut rates);
            row.extend(rates);
        }
        row.iter().all(|number| number.is_finite()).then_some(row)
    }

    /// A row in which some columns, from a few to all, have left their start values.
    fn draw_row(table: &[Variable], rng: &mut Rng) -> Vec<f64> {
        let share = rng.f64();
        table.iter().map(|variable| if rng.f64() < share { draw(variable, rng) } else { variable.start }).collect()
    }

    /// A value within the bound of the variable: 0, a limit, near the start value, or of any magnitude and sign.
    fn draw(variable: &Variable, rng: &mut Rng) -> f64 {
        let (min, max) = limits(variable);
        let magnitude = variable.nominal.max(variable.start.abs()) * 10f64.powf(12.0 * rng.f64() - 9.0);
        let value = match variable.kind {
            Kind::Boolean => f64::from(rng.u8(0..2)),
            Kind::Integer => f64::from(rng.u8(0..20)),
            Kind::Enumeration(items) => 1.0 + rng.usize(0..items.items.len()) as f64,
            Kind::Real(_) => match rng.u8(0..6) {
                0 => 0.0,
                1 => min.or(max).unwrap_or(-magnitude),
                2 => max.unwrap_or(magnitude),
                3 => -magnitude,
                4 => variable.start * 2.0 * rng.f64(),
                _ => magnitude,
            },
        };
        if variable.admits(value) { value } else { variable.start }
    }
}
