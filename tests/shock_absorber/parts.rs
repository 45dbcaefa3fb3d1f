//! Spring, damper, heat and energy.

use crate::common::Bench;
use crate::{NONE, TABLE, force, law, strut};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// Work of all motion = change of the energy in spring and gas + energy dissipated.
#[test]
fn energy_balance() {
    let mut strut = strut(&[TABLE, ("damper.k_series", 2e6), ("num.input_mode", 2.0), law("LuGre")]);
    strut.set("side_moment_n", 5.0);
    strut.set("spin_rate", 2.0);
    let (h, steps) = (1e-4, 20_000);
    let mut work = 0.0;
    let mut rotation = 0.0;
    for k in 0..steps {
        let phase = 4.0 * std::f64::consts::PI * h * f64::from(k);
        let velocity = 0.012 * 4.0 * std::f64::consts::PI * phase.cos();
        strut.set("length", 0.1775 + 0.012 * phase.sin());
        strut.set("velocity", velocity);
        let before = strut.get("force");
        let turning = strut.get("friction_torque");
        strut.step(h);
        // Over whole cycles, spring and gas give back what they took.
        work -= 0.5 * (before + strut.get("force")) * velocity * h;
        rotation += 0.5 * (turning + strut.get("friction_torque")) * 2.0 * h;
    }
    let dissipated = strut.get("dissipated_energy");
    assert!(
        abs_diff_eq!(work + rotation, dissipated, epsilon = 2e-3 * dissipated),
        "{work} + {rotation} = {dissipated}"
    );
}

/// Loads of the spring on the joint equal those that a host would give for it: the force F_s q along m, the moments
/// -e_n F_s and e_m F_s. Alone it ignores the inputs; and the contacts carry the distribution of pressure.
#[test]
fn side_load_of_the_spring() {
    let normals = |set: &[(&str, f64)]| {
        let mut strut = strut(set);
        ["normal_1", "normal_2"].map(|name| strut.get(name))
    };
    let spring = 150.0 + 45e3 * 0.0225;
    let given = normals(&[
        ("side.mode", 1.0),
        ("side_force_m", 0.02 * spring),
        ("side_moment_m", 0.001 * spring),
        ("side_moment_n", 0.002 * spring),
    ]);
    let offset = [("side.offset_m", 0.002), ("side.offset_n", -0.001), ("side.force_ratio", 0.02)];
    let inputs = [("side_force_m", 50.0), ("side_force_n", 70.0), ("side_moment_m", 3.0), ("side.mode", 2.0)];
    for set in [&offset[..], &[&offset[..], &inputs].concat()] {
        for c_geo in [1.0, 1.25] {
            let internal = normals(&[set, &[("side.c_geo", c_geo)]].concat());
            for (internal, given) in internal.iter().zip(given) {
                assert!(abs_diff_eq!(internal / (c_geo * given), 1.0, epsilon = 1e-12), "{internal} {given}");
            }
        }
    }
}

/// Straight lines bend at the points of the table, the cubic does not.
#[test]
fn cubic_damper_table_is_smooth() {
    let bend = |interpolation: f64| {
        let mut strut = strut(&[NONE, TABLE, ("damper.interpolation", interpolation)]);
        let mut at = |velocity: f64| force(&mut strut, 0.1775, velocity);
        let h = 1e-5;
        ((at(0.1 + h) - at(0.1)) / h - (at(0.1) - at(0.1 - h)) / h).abs()
    };
    // 160 N over 0.05 m/s below, 300 N over 0.15 m/s above.
    assert_abs_diff_eq!(bend(1.0), 3200.0 - 2000.0, epsilon = 1e-3);
    assert!(bend(2.0) < 10.0, "{}", bend(2.0));
}

/// Table of the start values: 45 N/mm, and 60 N/mm beyond 30 mm, on the preload of 150 N.
#[test]
fn progressive_spring() {
    let mut spring = Bench::new("CoilSpring", &[("spring.mode", 2.0)]);
    for (compression, force) in [(0.0, 150.0), (0.01, 600.0), (0.04, 2100.0), (0.06, 3300.0), (-0.01, -300.0)] {
        spring.set("compression", compression);
        assert!(abs_diff_eq!(spring.get("force"), force, epsilon = 1e-9), "{compression}: {}", spring.get("force"));
    }
}

/// Friction and damper heat the strut until the surroundings take what they give; no heat is lost in an insulated one.
#[test]
fn all_that_is_dissipated_heats() {
    let mut strut = strut(&[("thermal.enabled", 1.0), ("thermal.conductance", 0.0), ("velocity", 0.2)]);
    strut.set("spin_rate", 3.0);
    for _ in 0..100 {
        strut.step(0.01);
    }
    let heat = 600.0 * (strut.get("temperature") - 293.15);
    assert!(abs_diff_eq!(heat / strut.get("dissipated_energy"), 1.0, epsilon = 1e-9), "{heat} J");
    let power = strut.get("dissipated_power");
    let friction = strut.get("friction_1") + strut.get("friction_2");
    let work = friction * 0.2 + strut.get("friction_torque") * 3.0 - strut.get("force_damper") * 0.2;
    assert!(abs_diff_eq!(power / work, 1.0, epsilon = 1e-9), "{power} {work}");
}

/// Where the characteristic is level, the piston behind its stiffness follows the strut: an importer that integrates it
/// finds the force of co-simulation, to and fro over the level parts.
#[test]
fn a_level_characteristic_does_not_hold_the_piston() {
    let level = [
        TABLE,
        ("damper.tab_n", 5.0),
        ("damper.tab_v[2]", -0.2),
        ("damper.tab_f[2]", -300.0),
        ("damper.tab_v[3]", -0.1),
        ("damper.tab_f[3]", -300.0),
        ("damper.tab_v[4]", 0.0),
        ("damper.tab_f[4]", 0.0),
        ("damper.tab_v[5]", 0.5),
        ("damper.tab_f[5]", 900.0),
    ];
    let cases: [&[(&str, f64)]; 3] = [&level, &[("damper.c_comp", 0.0)], &[("damper.c_reb", 0.0)]];
    for (name, output) in [("HydraulicDamper", "force"), ("ShockAbsorber", "force_damper")] {
        for set in cases {
            let mut held = Bench::new(name, &[set, &[("damper.k_series", 1e6)]].concat());
            let [velocity, force, piston] = ["velocity", output, "piston_velocity"].map(|name| held.column(name));
            held.set("velocity", 0.0);
            held.step(1e-6);
            let model = held.instance.model();
            let mut row = held.instance.row().to_vec();
            let mut rate = row.clone();
            let (dt, mut worst, mut largest) = (1e-6, 0f64, 0f64);
            for k in 0..2_000 {
                let motion = |time: f64| 0.4 * (2.0 * std::f64::consts::PI * 10.0 * time).sin();
                for piece in 0..50 {
                    row[velocity] = motion(dt * (50.0 * f64::from(k) + f64::from(piece) + 0.5));
                    model.rate(&row, &mut rate);
                    row[piston] += dt * rate[piston];
                }
                held.set("velocity", motion(dt * 50.0 * (f64::from(k) + 0.5)));
                held.step(50.0 * dt);
                assert!(model.output(&mut row));
                worst = worst.max((row[force] - held.instance.row()[force]).abs());
                largest = largest.max(row[force].abs());
            }
            assert!(largest > 500.0 && worst < 1.0, "{name}, {set:?}: {worst} N of {largest} N");
        }
    }
}
