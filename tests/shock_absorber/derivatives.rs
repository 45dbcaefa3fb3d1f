//! Derivatives of the outputs, in time and in directions.

use crate::common::Bench;
use crate::{NONE, TABLE, law, strut};
use approx::abs_diff_eq;
use stribeck::model::output_in;
use stribeck::number::Gradient;
use stribeck::shock_absorber::ShockAbsorber;

/// Exact derivatives against central differences, with friction of both kinds, side load and all forces at work.
#[test]
fn directional_derivatives_of_force_and_torque() {
    let inputs = ["length", "velocity", "side_force_m", "side_force_n", "side_moment_m", "side_moment_n", "spin_rate"];
    let start = [0.156, -0.07, 80.0, -30.0, 2.0, 6.0, 1.5];
    let mut checked = 0;
    for model in ["LuGre", "BrownMcPhee", "Stribeck", "Dahl"] {
        let set = [law(model), TABLE, ("damper.interpolation", 2.0), ("bump.mode", 2.0), ("friction.asymmetry", 0.1)];
        let mut strut = strut(&set);
        let put = |strut: &mut Bench, values: &[f64; 7]| {
            inputs.iter().zip(values).for_each(|(name, value)| strut.set(name, *value));
        };
        put(&mut strut, &start);
        strut.step(1e-3);
        for (at, input) in inputs.iter().enumerate() {
            let half = 1e-6 * start[at].abs();
            for output in ["force", "friction_torque"] {
                let mut value = |side: f64| {
                    let mut values = start;
                    values[at] += side * half;
                    put(&mut strut, &values);
                    strut.get(output)
                };
                let difference = (value(1.0) - value(-1.0)) / (2.0 * half);
                put(&mut strut, &start);
                let [seed, answer] = [strut.column(input), strut.column(output)];
                strut.instance.refresh().unwrap();
                let exact = strut.instance.derivative([(seed, 1.0)].into_iter())[answer].slope;
                let scale = difference.abs().max(1e-3 * strut.get(output).abs() / start[at].abs()).max(1e-9);
                assert!(
                    abs_diff_eq!(exact, difference, epsilon = 1e-5 * scale),
                    "{model} {output} {input}: {exact} {difference}"
                );
                checked += usize::from(difference.abs() > 1e-6);
            }
        }
    }
    assert!(checked > 40, "only {checked} derivatives are not 0");
}

/// Behind a series stiffness the force goes on while the motion is held: its rate is that of the run.
#[test]
fn output_derivative_of_the_force_behind_a_series_stiffness() {
    for set in [&[NONE][..], &[NONE, TABLE], &[NONE, ("thermal.enabled", 1.0), ("temperature", 393.15)]] {
        let mut strut = strut(&[set, &[("damper.k_series", 4e5), ("num.h_max", 1e-6)]].concat());
        strut.set("velocity", 0.0);
        strut.step(1e-3);
        strut.set("velocity", -0.3);
        strut.step(2e-3);
        let force = strut.column("force");
        let rate = strut.instance.time_derivative()[force].slope;
        let before = strut.get("force");
        strut.step(1e-6);
        let difference = (strut.get("force") - before) / 1e-6;
        assert!(rate > 1e4 && (rate / difference - 1.0).abs() < 1e-3, "{set:?}: {rate} {difference}");
    }
}

/// Before the run the friction is that of a second of motion: what changes the motion changes it, too.
#[test]
fn directional_derivatives_before_the_run() {
    let inputs = ["length", "velocity", "side_force_m", "c1.mu_k", "friction.sigma_0", "memory_1[1]"];
    for state in [1.0, 2.0, 3.0] {
        for velocity in [0.0, 2e-4, 0.1] {
            let start = |strut: &mut Bench| {
                for (name, value) in [("velocity", velocity), ("side_force_m", 80.0), ("memory_1[1]", 1e-5)] {
                    strut.set(name, value);
                }
            };
            let mut strut = strut(&[("init.friction_state", state), ("damper.c_reb", 1500.0)]);
            start(&mut strut);
            for input in inputs {
                let value = strut.get(input);
                let half = 1e-5 * value.abs().max(1e-4);
                let mut at = |value: f64| {
                    strut.set(input, value);
                    strut.get("force")
                };
                let difference = (at(value + half) - at(value - half)) / (2.0 * half);
                at(value);
                let [seed, force] = [strut.column(input), strut.column("force")];
                for scale in [1.0, 1e-3, 1e6] {
                    let exact = strut.instance.derivative([(seed, scale)].into_iter())[force].slope / scale;
                    let size = difference.abs().max(1e-4 / value.abs().max(1e-4));
                    let case = format!("{state}, {velocity} m/s, {input} by {scale}");
                    assert!(abs_diff_eq!(exact, difference, epsilon = 2e-3 * size), "{case}: {exact} {difference}");
                }
            }
        }
    }
}

/// Before the run the friction follows from a search that knows one direction only: with several at once its slopes are
/// no numbers, not 0.
#[test]
fn several_directions_before_the_run_are_refused() {
    let mut strut = strut(&[law("LuGre")]);
    strut.set("velocity", -0.07);
    let [velocity, force] = ["velocity", "force"].map(|name| strut.column(name));
    let mut row: Vec<Gradient> = strut.instance.row().iter().map(|value| Gradient::from(*value)).collect();
    output_in::<ShockAbsorber, Gradient>(&mut row, &[]);
    assert_eq!(row[force].slopes, [0.0; 4]);
    row[velocity].slopes[1] = 1.0;
    output_in::<ShockAbsorber, Gradient>(&mut row, &[]);
    assert!(row[force].slopes[1].is_nan(), "{:?}", row[force]);
    strut.step(1e-3);
    let mut row: Vec<Gradient> = strut.instance.row().iter().map(|value| Gradient::from(*value)).collect();
    row[velocity].slopes[1] = 1.0;
    output_in::<ShockAbsorber, Gradient>(&mut row, &[]);
    let expected = strut.instance.derivative([(velocity, 1.0)].into_iter())[force].slope;
    assert!(expected != 0.0 && row[force].slopes == [0.0, expected, 0.0, 0.0], "{:?} {expected}", row[force]);
}
