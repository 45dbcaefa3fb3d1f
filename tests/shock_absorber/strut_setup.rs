//! Set-up of the strut and its surroundings by a host: inputs that are not set yet, parts that the host itself has, and
//! published levels of friction.

use crate::common::Bench;
use approx::{abs_diff_eq, assert_abs_diff_eq};
use stribeck::catalogue::{Family, documented};
use stribeck::model::Role;

/// Variables and their values.
type Values<'a> = &'a [(&'a str, f64)];

/// A bench of that model with 0 in every input.
fn with_zeros(name: &str, set: &[(&str, f64)]) -> Bench {
    let mut bench = Bench::new(name, set);
    let model = bench.instance.model();
    for (column, variable) in model.table.iter().enumerate().filter(|(_, variable)| variable.role == Role::Input) {
        assert!(variable.admits(0.0), "{name}: {} = 0 is rejected", variable.path);
        bench.instance.set_column(column, 0.0).unwrap();
    }
    bench
}

fn warning(bench: &Bench) -> Option<String> {
    bench.instance.model().warning(bench.instance.row()).map(|fault| fault.to_string())
}

/// Hosts start with zeros: every model makes steps with them, with finite results and rates.
#[test]
fn every_model_steps_from_zeros() {
    let mut tested = 0;
    for family in [Family::ShockAbsorber, Family::Host, Family::Component] {
        for (model, _) in documented(family) {
            let settings: &[&[(&str, f64)]] = match model.name {
                "ShockAbsorber" => {
                    &[&[], &[("thermal.enabled", 1.0)], &[("num.input_mode", 2.0)], &[("friction.mass", 5.0)]]
                }
                "DamperTemperature" => &[&[], &[("thermal.enabled", 1.0)]],
                _ => &[&[]],
            };
            for set in settings {
                let mut bench = with_zeros(model.name, set);
                let mut rate = vec![0.0; model.table.len()];
                for _ in 0..10 {
                    bench.step(1e-3);
                    bench.instance.refresh().unwrap();
                    model.rate(bench.instance.row(), &mut rate);
                    assert!(rate.iter().chain(bench.instance.row()).all(|x| x.is_finite()), "{} {set:?}", model.name);
                }
                tested += 1;
            }
        }
    }
    assert!(tested > 14, "{tested}");
}

/// An impossible zero is reported with name and value, and with the value used instead; a possible one is not.
#[test]
fn zeros_that_make_no_sense_warn() {
    let warned = |name: &str, set: &[(&str, f64)]| warning(&with_zeros(name, set));
    let text = warned("ShockAbsorber", &[]).unwrap();
    assert!(
        text.starts_with("length = 0: ") && text.contains("full extension, geom.length_extended = 0.2 m"),
        "{text}"
    );
    assert!(warned("TelescopicJoint", &[]).unwrap().starts_with("length = 0 m: "));
    let hot = [("thermal.enabled", 1.0)];
    assert!(warned("DamperTemperature", &hot).unwrap().starts_with("temperature_ambient = 0 K: "));
    assert_eq!(warned("DamperTemperature", &[]), None);
    let mut strut = with_zeros("ShockAbsorber", &hot);
    strut.set("length", 0.18);
    assert!(warning(&strut).unwrap().starts_with("temperature_ambient = 0 K: "));
    strut.set("temperature_ambient", 293.15);
    assert_eq!(warning(&strut), None);
    // With the adapter of a host that counts its travel, 0 is a length like any other, and one that makes it 0 warns.
    let travel = [("adapter.length_offset", 0.1775), ("adapter.length_gain", -0.8)];
    assert_eq!(warned("ShockAbsorber", &travel), None);
    let made = [("adapter.length_offset", 0.125), ("adapter.length_gain", -1.0), ("length", 0.125)];
    let text = warning(&Bench::new("ShockAbsorber", &made)).unwrap();
    assert!(text.starts_with("length = 0.125: gives a distance of the eyes of 0; until it is > 0, "), "{text}");
    let negative = warning(&Bench::new("ShockAbsorber", &[("adapter.length_gain", -1.0), ("length", 0.125)])).unwrap();
    assert_eq!(negative, "length = 0.125: gives a distance of the eyes of -0.125 m; it must be > 0");
}

/// The strut whose length is not set yet is that at full extension, to the last digit, and its slopes are.
#[test]
fn a_strut_without_a_length_is_at_full_extension() {
    let outputs = ["force", "compression", "overlap", "dforce_dlength", "normal_1"];
    let read = |length: f64| {
        let mut strut = Bench::new("ShockAbsorber", &[("length", length), ("rebound.gap", -0.01)]);
        strut.step(1e-3);
        let (force, length) = (strut.column("force"), strut.column("length"));
        let slope = strut.instance.derivative([(length, 1.0)].into_iter())[force].slope;
        (outputs.map(|name| strut.get(name)), slope)
    };
    let ((here, slope), (extended, its_slope)) = (read(0.0), read(0.2));
    assert_eq!(here, extended);
    assert!(abs_diff_eq!(slope / its_slope, 1.0, epsilon = 1e-9), "{slope} {its_slope}");
    assert_abs_diff_eq!(read(0.2).0[0], 288.3403, epsilon = 5.1e-5);
}

/// A part that is switched off acts as if its force were 0, and does not affect the rest of the strut.
#[test]
fn parts_can_be_switched_off_one_by_one() {
    let zeroed: [(&str, &str, Values); 4] = [
        ("spring.enabled", "force_spring", &[("spring.k", 0.0), ("spring.preload", 0.0)]),
        ("bump.enabled", "force_bump", &[("bump.k", 0.0)]),
        ("rebound.enabled", "force_rebound", &[("rebound.k", 0.0)]),
        ("damper.enabled", "force_damper", &[("damper.scale", 0.0)]),
    ];
    for (switch, output, zero) in zeroed {
        for (length, velocity) in [(0.15, -0.1), (0.18, 0.1), (0.201, 0.05)] {
            let forces = |set: &[(&str, f64)]| {
                let motion = [("length", length), ("velocity", velocity), ("damper.k_series", 1e6)];
                let mut strut = Bench::new("ShockAbsorber", &[set, &motion].concat());
                strut.step(1e-3);
                [output, "force", "normal_1", "step_limit"].map(|name| strut.get(name))
            };
            let off = forces(&[(switch, 0.0)]);
            assert_eq!(off[0], 0.0, "{switch}");
            let zeroed = forces(zero);
            // A rigid damper that is switched off has no piston to keep stable: only the advice may differ.
            let compared = if switch == "damper.enabled" { 3 } else { 4 };
            for (a, b) in off.into_iter().zip(zeroed).take(compared) {
                assert!(abs_diff_eq!(a, b, epsilon = 1e-9 * b.abs()), "{switch} at {length} m: {off:?} {zeroed:?}");
            }
        }
    }
}

/// Damper and friction for a host with its own spring and stops: one preset, and length and stroke.
#[test]
fn damper_and_friction_alone() {
    let set = preset("damper_and_friction");
    for (extended, stroke) in [(0.2, 0.055), (0.52, 0.17), (0.3, 0.1)] {
        let set = [&set[..], &[("geom.length_extended", extended), ("geom.stroke", stroke)]].concat();
        for part in 0..=4 {
            let length = extended - stroke * f64::from(part) / 4.0;
            for velocity in [-0.2, 0.2] {
                let motion = [("length", length), ("velocity", velocity)];
                let mut strut = Bench::new("ShockAbsorber", &[&set[..], &motion].concat());
                strut.step(1e-3);
                let damper = if velocity < 0.0 { 300.0 } else { -460.0 };
                assert_abs_diff_eq!(strut.get("force") - damper, strut.get("force_friction"), epsilon = 1e-9);
                // Only seals: 8 N and 6 N.
                assert_abs_diff_eq!(strut.get("force_friction"), -14.0 * velocity.signum(), epsilon = 0.5);
                // The piston never leaves the guide and hits neither end.
                let overlap = strut.get("overlap");
                assert!(overlap > 0.1 * (extended - 2.0 * stroke), "{extended} {stroke} {length}: {overlap}");
            }
        }
    }
    let mut strut = Bench::new("ShockAbsorber", &[("geom.guidance_derived", 1.0)]);
    let given = Bench::new("ShockAbsorber", &[]).get("overlap");
    assert!(abs_diff_eq!(strut.get("overlap"), given, epsilon = 1e-15), "the start values are derived in the same way");
    strut.set("geom.stroke", 0.1);
    let text = strut.instance.check().unwrap_err().to_string();
    assert!(text.starts_with("geom.stroke = 0.1 m: must be < 0.1 m, half of geom.length_extended"), "{text}");
}

fn preset(name: &str) -> Vec<(&'static str, f64)> {
    let strut = stribeck::catalogue::by_name("ShockAbsorber").unwrap();
    strut.presets.iter().find(|preset| preset.name == name).unwrap().values.to_vec()
}

/// Friction in slow strokes of 20 mm under spring and side load: in compression, in extension.
#[test]
fn published_levels_are_reached_in_both_directions() {
    let published = [
        ("koelsch_1994", 25.0, 25.0),
        ("manger_1995_low", 30.0, 30.0),
        ("manger_1995_high", 45.0, 45.0),
        ("lizarraga_2008_measured", 22.0, 15.0),
        ("lizarraga_2008_simulated", 32.0, 23.0),
        ("fujimoto_2018_low", 20.0, 20.0),
        ("fujimoto_2018_high", 150.0, 150.0),
        ("wegener_2020_low", 37.5, 37.5),
        ("wegener_2020_high", 175.0, 175.0),
        ("koerner_mayer_2020_low", 20.0, 10.0),
        ("koerner_mayer_2020_high", 70.0, 40.0),
        ("herzog_augsburg_2021", 35.0, 30.0),
        ("deubel_prokop_2024_low", 62.0, 62.0),
        ("deubel_prokop_2024_high", 134.0, 134.0),
    ];
    for (name, compression, extension) in published {
        let mut strut = Bench::new("ShockAbsorber", &preset(name));
        strut.set("side_force_m", 50.0);
        for (velocity, level) in [(-0.02, compression), (0.02, -extension), (-0.02, compression)] {
            let mut friction = 0.0;
            for k in 0..1000 {
                strut.set("length", 0.1775 + velocity * (1e-3 * f64::from(k) - 0.5));
                strut.set("velocity", velocity);
                strut.step(1e-3);
                friction = strut.get("force_friction");
            }
            assert!(
                abs_diff_eq!(friction, level, epsilon = 0.01),
                "{name}: {friction} N at {velocity} m/s, published {level} N"
            );
        }
    }
}
