//! Which output depends on which other column.
//!
//! A dependency that is declared by hand can be wrong; these follow from the equations.

mod exact;
mod expression;
mod tracked;
mod trials;

use std::collections::BTreeSet;

use stribeck::model::{ModelType, Variable};

/// Whether the model has arrays, itself or in a part: trying does not find every one of their elements.
pub fn has_elements(model: &ModelType) -> bool {
    let is_element = |variable: Variable| variable.path.segments().iter().any(|segment| segment.index > 0);
    model.table.iter().any(is_element)
}

/// Whether the derivatives of its states are described, too.
fn has_rates(model: &ModelType) -> bool {
    model.model_exchange && !has_elements(model)
}

/// For each column, which of the `candidates` its value is computed from; empty for columns that are not computed. Then
/// the same for the time derivatives of the columns, if the model is offered for Model Exchange and has no arrays.
pub fn of(model: &ModelType, candidates: impl Fn(usize) -> bool) -> Vec<BTreeSet<usize>> {
    let Some(mut found) = exact::of(model, has_rates(model)) else { return trials::of(model, candidates) };
    found.iter_mut().for_each(|columns| columns.retain(|column| candidates(*column)));
    found
}

#[cfg(test)]
mod tests {
    use stribeck::catalogue;
    use stribeck::model::Role;

    use super::*;

    fn names(model: &ModelType, columns: Vec<usize>) -> Vec<String> {
        columns.into_iter().map(|column| model.table.at(column).path.to_string()).collect()
    }

    /// Asserts what an output depends on: the inputs, then the other columns, each in the order of the table.
    fn assert_depends(model: &str, output: &str, expected_inputs: &[&str], expected_others: &[&str]) {
        let model = stribeck::catalogue::by_name(model).unwrap();
        let all = of(model, |_| true).swap_remove(model.find(output).unwrap());
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

    /// Two roads to the same set: nothing that a change of one column changes is missing.
    #[test]
    fn equations_have_every_dependency_that_trials_find() {
        for model in catalogue::models().filter(|model| !has_elements(model)) {
            let exact = exact::of(model, has_rates(model)).unwrap();
            for (column, (exact, tried)) in exact.iter().zip(trials::of(model, |_| true)).enumerate() {
                let missing = tried.difference(exact).copied().collect();
                assert!(tried.is_subset(exact), "{}: column {column}: {:?}", model.name, names(model, missing));
            }
        }
    }

    /// The contacts that look up a law by its record, and the law whose elements beyond the listed ones have no columns.
    #[test]
    fn few_models_need_trials() {
        let models = catalogue::models().filter(|model| exact::of(model, has_rates(model)).is_none());
        let names: Vec<_> = models.map(|model| model.name).collect();
        assert_eq!(names, ["MaxwellSlip", "ShockAbsorber", "GuideContact"]);
    }
}
