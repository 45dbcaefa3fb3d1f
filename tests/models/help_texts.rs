//! Numbers in the help texts of columns, compared with the behaviour of the laws.

use crate::common::Bench;
use stribeck::catalogue::{self, Family};

/// Fraction of the excess f_s - f_C that remains in steady sliding at the Stribeck velocity, without viscous parts.
fn left_at_stribeck_velocity(model: &str, curve: Option<f64>) -> f64 {
    let mut law = Bench::new(model, &[("mu_k", 0.1), ("mu_s", 0.15), ("normal_force", 10.0)]);
    if let Some(curve) = curve {
        law.set("curve", curve);
    }
    for (name, value) in [
        ("viscous_coefficient", 0.0),
        ("transition_slope", 1e6),      // a regularised law far outside its band
        ("time_lag", 0.0),              // no lag
        ("stribeck_coefficient", 0.05), // a contact that has rested long
        ("dwell", 1.0),
        ("film_velocity", 1e12), // no film forms
    ] {
        if law.has(name) {
            law.set(name, value);
        }
    }
    let along_x = law.has("velocity_x");
    law.set(if along_x { "velocity_x" } else { "velocity" }, 0.001);
    for _ in 0..1000 {
        law.step(0.001);
    }
    (law.get(if along_x { "friction_force_x" } else { "friction_force" }) - 1.0) / 0.5
}

/// 1/e for exponentials, one half for fractions; the strut, which offers all laws under one name, gives both.
#[test]
fn the_stribeck_velocity_is_what_its_help_says() {
    let e = (-1.0_f64).exp();
    let mut seen = 0;
    for model in catalogue::models().filter(|model| model.find("mu_k").is_some()) {
        let Some(column) = model.find("stribeck_velocity") else { continue };
        let help = model.table.at(column).help;
        let (expected, text) = match model.name {
            "Armstrong" => (0.5, "half of the excess of static over kinetic friction is left."),
            "Stribeck" => (e, "1/e of the excess is left; one half with HessSoom and PoppStelter."),
            _ => (e, "the excess of static over kinetic friction has fallen to 1/e."),
        };
        assert!(help.ends_with(text), "{}: {help}", model.name);
        let left = left_at_stribeck_velocity(model.name, None);
        assert!((left - expected).abs() < 1e-3, "{}: {left}", model.name);
        seen += 1;
    }
    assert!(seen >= 10, "{seen}");
    for strut in ["GuideContact", "ShockAbsorber"] {
        let bench = Bench::new(strut, &[]);
        let help = bench.instance.model().table.at(bench.column("friction.stribeck_velocity")).help;
        assert!(help.ends_with("1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter)."), "{help}");
    }
    // Tustin, BoPavelescu, HessSoom, PoppStelter, Gaussian.
    for (curve, expected) in [(1.0, e), (2.0, e), (3.0, 0.5), (4.0, 0.5), (5.0, e)] {
        assert!((left_at_stribeck_velocity("Stribeck", Some(curve)) - expected).abs() < 1e-12, "curve {curve}");
    }
}

/// Published values that a help text must not call chosen: Table 6.2 of the thesis.
#[test]
fn values_from_a_table_of_the_thesis_are_not_called_chosen() {
    for (model, name, value) in [
        ("Threlfall", "transition_velocity", 0.001),
        ("ThrelfallModified", "transition_velocity", 0.001),
        ("RooneyDeravi", "transition_velocity", 0.001),
        ("Ambrosio", "transition_velocity", 0.0001),
        ("Ambrosio", "sliding_velocity", 0.001),
        ("Bernard", "transition_slope", 2000.0),
    ] {
        let bench = Bench::new(model, &[]);
        let column = &bench.instance.model().table.at(bench.column(name));
        assert!(column.start == value && !column.help.contains("chosen"), "{model}: {}", column.help);
    }
}

/// Below it Ambrosio's law has no friction at all.
#[test]
fn the_transition_velocity_of_ambrosio_is_the_end_of_no_friction() {
    let mut law = Bench::new("Ambrosio", &[("velocity", 0.99e-4)]);
    assert_eq!(law.get("friction_force"), 0.0);
    law.set("velocity", 1.01e-4);
    assert!(law.get("friction_force") > 0.0);
}

/// A page recommends Model Exchange only if the model supports it.
#[test]
fn pages_recommend_model_exchange_only_where_it_is_supported() {
    let families = [Family::Friction, Family::ShockAbsorber, Family::Host, Family::Component];
    for (model, page) in families.into_iter().flat_map(catalogue::documented) {
        let text = page.split_whitespace().collect::<Vec<_>>().join(" ");
        let recommends =
            text.contains("friction first, or Model Exchange") || text.contains("In Model Exchange a contact");
        assert!(model.model_exchange || !recommends, "{}", model.name);
    }
}
