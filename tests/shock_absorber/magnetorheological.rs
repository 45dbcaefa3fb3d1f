//! The magnetorheological damper in a strut, against its component, its own rates and its energy.

use crate::common::Bench;
use crate::{NONE, golden_trace, strut};

const MAGNETORHEOLOGICAL: (&str, f64) = ("damper.mode", 4.0);

/// The accumulator of the printed damper as the coil spring of a strut: k_1 (x_0 - x) with x = length - 177.5 mm.
const ACCUMULATOR: [(&str, f64); 2] = [("spring.k", 500.0), ("spring.preload", 500.0 * (0.143 + 0.1775 - 0.2))];

/// A strut with this damper and the accumulator, and nothing else.
fn alone(set: &[(&str, f64)]) -> Bench {
    let parts = ["gas.enabled", "bump.enabled", "rebound.enabled"].map(|part| (part, 0.0));
    strut(&[&[NONE, MAGNETORHEOLOGICAL][..], &parts, &ACCUMULATOR, set].concat())
}

/// Velocities and voltages of 1 ms each: to and fro by up to 0.3 m/s, between 0 and 2.25 V.
fn motion() -> impl Iterator<Item = [f64; 2]> {
    (0..120).map(|k| {
        let time = f64::from(k);
        [0.3 * (0.31 * time).sin() * (0.043 * time).cos(), 1.125 + 1.125 * (0.11 * time).sin()]
    })
}

#[test]
fn strut_has_the_force_of_the_component() {
    let mut component = Bench::new("MagnetorheologicalDamper", &[]);
    let mut part = Bench::new("HydraulicDamper", &[MAGNETORHEOLOGICAL]);
    let mut strut = alone(&[]);
    let (mut length, mut largest) = (0.1775, 0f64);
    for [velocity, voltage] in motion() {
        for bench in [&mut component, &mut part, &mut strut] {
            bench.set("velocity", velocity);
            bench.set("voltage", voltage);
            bench.step(1e-3);
        }
        length += 1e-3 * velocity;
        strut.set("length", length);
        let expected = -component.get("friction_force");
        let accumulator = 500.0 * (0.143 - component.get("displacement"));
        largest = largest.max(expected.abs());
        for (name, found) in [
            ("strut", strut.get("force")),
            ("damper of the strut", strut.get("force_damper") + accumulator),
            ("damper", part.get("force") + accumulator),
        ] {
            assert!((found - expected).abs() < 1e-6 * largest, "{name}: {found} {expected}");
        }
    }
    assert!(largest > 1000.0, "{largest}");
}

/// One step of the classical Runge-Kutta method.
fn runge_kutta(rates: impl Fn(f64, [f64; 4]) -> [f64; 4], at: [f64; 4], dt: f64) -> [f64; 4] {
    let along = |k: [f64; 4], part: f64| std::array::from_fn(|i| at[i] + part * dt * k[i]);
    let k_1 = rates(0.0, at);
    let k_2 = rates(0.5 * dt, along(k_1, 0.5));
    let k_3 = rates(0.5 * dt, along(k_2, 0.5));
    let k_4 = rates(dt, along(k_3, 1.0));
    std::array::from_fn(|i| at[i] + dt / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]))
}

/// Rates by the classical Runge-Kutta method, as an importer of Model Exchange would integrate them, against steps in
/// which velocity and voltage move linearly. The strut makes pieces of `num.h_max`, each with held inputs.
#[test]
fn rates_are_those_of_the_steps() {
    for (name, output, allowed) in [("HydraulicDamper", "force", 1e-3), ("ShockAbsorber", "force_damper", 0.3)] {
        let set = [MAGNETORHEOLOGICAL, ("num.h_max", 1e-5), NONE];
        let set: Vec<_> = set.into_iter().filter(|(column, _)| Bench::new(name, &[]).has(column)).collect();
        let mut stepped = Bench::new(name, &set);
        let inputs = ["velocity", "voltage"].map(|name| stepped.column(name));
        let states = ["mr.slip", "mr.z", "mr.filtered_voltage", "dissipated_energy"].map(|name| stepped.column(name));
        let (model, force) = (stepped.instance.model(), stepped.column(output));
        stepped.step(1e-9);
        let mut row = stepped.instance.row().to_vec();
        let (h, within) = (2e-4, 40);
        let drive = |step: u32| [0.2 * (8e-3 * f64::from(step)).sin(), 8e-3 * f64::from(step)];
        for step in 0..200 {
            let (from, to) = (drive(step), drive(step + 1));
            let slope = [0, 1].map(|i| (to[i] - from[i]) / h);
            for piece in 0..within {
                let begin = h * f64::from(piece) / f64::from(within);
                let rates = |time: f64, at: [f64; 4]| {
                    let (mut row, mut rate) = (row.clone(), row.clone());
                    (0..2).for_each(|i| row[inputs[i]] = from[i] + slope[i] * (begin + time));
                    states.into_iter().zip(at).for_each(|(column, value)| row[column] = value);
                    model.rate(&row, &mut rate);
                    states.map(|column| rate[column])
                };
                let next = runge_kutta(rates, states.map(|column| row[column]), h / f64::from(within));
                states.into_iter().zip(next).for_each(|(column, value)| row[column] = value);
            }
            for i in 0..2 {
                stepped.instance.set_column(inputs[i], from[i]).unwrap();
                stepped.instance.set_slope(inputs[i], slope[i]).unwrap();
                row[inputs[i]] = to[i];
            }
            stepped.step(h);
            assert!(model.output(&mut row));
            stepped.instance.refresh().unwrap();
            let found = stepped.instance.row();
            assert!((found[force] - row[force]).abs() < allowed, "{name}, {step}: {} {}", found[force], row[force]);
            let energies = [found[states[3]], row[states[3]]];
            assert!((energies[0] - energies[1]).abs() < 1e-3, "{name}, {step}: {energies:?}");
        }
        assert!(row[states[3]] > 3.0, "{name}: {} J", row[states[3]]);
    }
}

/// At constant voltage nothing comes from nowhere: what the motion lost, less what springs and hysteresis have stored,
/// never falls; and it is the work of the force.
#[test]
fn damper_in_a_strut_is_passive() {
    for voltage in [0.0, 2.0] {
        let mut strut = alone(&[("voltage", voltage), ("mr.filtered_voltage", voltage)]);
        let (mut work, mut lost_before) = (0.0, 0.0);
        for k in 0..4000 {
            let velocity = 0.2 * (0.02 * f64::from(k)).sin();
            strut.set("velocity", velocity);
            let before = strut.get("force_damper");
            strut.step(1e-4);
            work -= 0.5 * (before + strut.get("force_damper")) * velocity * 1e-4;
            let alpha = 14_000.0 + 69_500.0 * voltage;
            let [slip, z] = ["mr.slip", "mr.z"].map(|name| strut.get(name));
            let lost = strut.get("dissipated_energy") - 0.5 * (alpha / 301.0 * z * z + 4690.0 * slip * slip);
            assert!(lost > lost_before - 1e-9, "{voltage} V, step {k}: {lost} {lost_before}");
            lost_before = lost;
        }
        let taken = strut.get("dissipated_energy");
        assert!(taken > 2.0 && (work / taken - 1.0).abs() < 3e-3, "{voltage} V: {work} {taken}");
    }
}

/// A damper that is twice as strong, or hot, multiplies the force and what it takes.
#[test]
fn scale_and_temperature_multiply_the_force() {
    let read = |set: &[(&str, f64)]| {
        let mut strut = alone(set);
        for [velocity, voltage] in motion().take(30) {
            strut.set("velocity", velocity);
            strut.set("voltage", voltage);
            strut.step(1e-3);
        }
        ["force_damper", "dissipated_energy"].map(|name| strut.get(name))
    };
    let plain = read(&[]);
    let isothermal = [("thermal.enabled", 1.0), ("thermal.capacity", 1e12), ("temperature", 393.15)];
    for (set, factor) in [(&[("damper.scale", 2.0)][..], 2.0), (&isothermal, (-0.3f64).exp())] {
        for (found, plain) in read(set).into_iter().zip(plain) {
            assert!((found / (factor * plain) - 1.0).abs() < 1e-6, "{set:?}: {found} {plain}");
        }
    }
}

#[test]
fn other_dampers_do_not_feel_the_voltage() {
    let trace = |set: &[(&str, f64)]| {
        let mut forces = Vec::new();
        golden_trace(set, |_, strut| forces.push(strut.get("force")));
        forces
    };
    assert_eq!(trace(&[]), trace(&[("voltage", 2.0), ("damper.mr.k_0", 1e6), ("mr.z", 1e-3)]));
}

#[test]
fn impossible_fluids_are_refused_by_name() {
    for (set, expected) in [
        (("damper.k_series", 1e6), "damper.k_series = 1000000: must be 0 with damper.mode = MagnetorheologicalDamper"),
        (
            ("damper.mr.hysteresis_beta", -4e6),
            "damper.mr.hysteresis_beta = -4000000: must be > -damper.mr.hysteresis_gamma = -3630000, or ",
        ),
    ] {
        let refused =
            |mode: (&'static str, f64)| strut(&[mode, set]).instance.check().map_err(|fault| fault.to_string());
        let text = refused(MAGNETORHEOLOGICAL).unwrap_err();
        assert!(text.starts_with(expected), "{text}");
        assert_eq!(refused(("damper.mode", 1.0)), Ok(()));
    }
}

/// Exact derivatives against central differences.
#[test]
fn derivatives_of_force_and_rate() {
    let mut strut = alone(&[("voltage", 1.5), ("velocity", 0.02), ("mr.filtered_voltage", 1.2)]);
    strut.step(1e-3);
    for input in ["velocity", "mr.slip", "mr.z", "mr.filtered_voltage", "damper.mr.c_0a"] {
        let value = strut.get(input);
        let half = 1e-5 * value.abs();
        let mut at = |value: f64| {
            strut.set(input, value);
            strut.get("force")
        };
        let difference = (at(value + half) - at(value - half)) / (2.0 * half);
        at(value);
        let [seed, force] = [strut.column(input), strut.column("force")];
        let exact = strut.instance.derivative([(seed, 1.0)].into_iter())[force].slope;
        assert!(difference != 0.0 && (exact / difference - 1.0).abs() < 1e-6, "{input}: {exact} {difference}");
    }
}

/// A mass that the strut carries is stable at the step that the strut advises, in the stiffest state: at rest.
#[test]
fn advised_step_is_stable() {
    for voltage in [0.0, 2.0] {
        let mut strut = alone(&[("voltage", voltage), ("mr.filtered_voltage", voltage), ("num.mass_ref", 16.4)]);
        let step = strut.get("step_limit");
        assert!(step > 1e-5 && step < 0.02, "{voltage} V: {step}");
        let (mut x, mut velocity) = (0.1775, 1e-4);
        let mut force = strut.get("force");
        let rest = force;
        for _ in 0..3000 {
            strut.set("velocity", velocity);
            strut.step(step);
            let acceleration = (force - rest) / 16.4;
            x += step * (velocity + 0.5 * step * acceleration);
            velocity += step * acceleration;
            strut.set("length", x);
            strut.set("velocity", velocity);
            force = strut.get("force");
        }
        assert!(velocity.abs() < 1e-4, "{voltage} V: {velocity} after steps of {step} s");
    }
}
