//! The tables of variables: names, common columns, consistent parameters and presets.

use std::collections::HashMap;

use super::{axes, friction_models};
use crate::common::Bench;
use stribeck::catalogue;
use stribeck::model::{Meaning, Role, Variable};

/// One quantity, one name: if two models have the same name, its unit, type and help text are the same. Only the help
/// of the Stribeck velocity gives the fraction of its own law.
#[test]
fn equal_names_mean_equal_things() {
    let mut seen: HashMap<String, (&str, Variable)> = HashMap::new();
    for model in friction_models() {
        for variable in model.table {
            let name = variable.path.to_string();
            let (other, first) = *seen.entry(name.clone()).or_insert((model.name, variable));
            // Every model has variants of its own.
            if name != "variant" {
                assert_eq!(first.kind, variable.kind, "{name} in {other} and {}", model.name);
            }
            if name != "stribeck_velocity" {
                assert_eq!(first.help, variable.help, "{name} in {other} and {}", model.name);
            }
            assert_eq!(first.role, variable.role, "{name} in {other} and {}", model.name);
        }
    }
    assert!(seen.len() > 10);
}

#[test]
fn every_friction_model_has_the_common_columns() {
    for model in friction_models() {
        let role = |name: &str| model.find(name).map(|column| model.table.at(column).role);
        let axes = axes(&Bench::new(model.name, &[]));
        assert!([1, 2, 3].contains(&axes.len()), "{}", model.name);
        for input in axes.iter().map(|(velocity, ..)| *velocity).chain(["normal_force"]) {
            assert_eq!(role(input), Some(Role::Input), "{} {input}", model.name);
        }
        for output in axes.iter().map(|(_, force, _)| *force).chain(["dissipated_power", "sticking"]) {
            assert_eq!(role(output), Some(Role::Output), "{} {output}", model.name);
        }
        assert_eq!(role("dissipated_energy"), Some(Role::StateOutput), "{}", model.name);
        let start = model.find("normal_force").map(|column| model.table.at(column).start);
        assert_eq!(start, Some(9.81), "{}: m g of the benchmark", model.name);
    }
}

/// The static coefficient must not be below the kinetic one; the message names both.
#[test]
fn inverted_coefficients_are_rejected_by_name() {
    for model in friction_models() {
        for column in Bench::new(model.name, &[]).columns_of(Meaning::StaticLevel) {
            let name = model.table.at(column).path.to_string();
            let mut bench = Bench::new(model.name, &[(name.as_str(), 0.05)]);
            let before = bench.instance.save();
            let fault = bench.instance.step(1e-3).expect_err("mu_s < mu_k").to_string();
            let kinetic = name.replace("mu_s", "mu_k");
            assert_eq!(fault, format!("{name} = 0.05: must be >= {kinetic} = 0.1"), "{}", model.name);
            assert_eq!(bench.instance.save(), before, "{}", model.name);
        }
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
                let variable = &model.table.at(bench.column(name));
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
