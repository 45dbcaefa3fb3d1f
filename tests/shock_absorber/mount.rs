//! The top mount in a strut: springs in series, a stuck strut, energy, rates, and what is refused.

use std::f64::consts::TAU;

use crate::common::Bench;
use crate::{NONE, bare, golden_trace, law, laws, strut};

const MOUNTED: (&str, f64) = ("mount.enabled", 1.0);

/// A mount that is a spring of 500 N/mm.
const SPRING: [(&str, f64); 3] = [MOUNTED, ("mount.k_v", 0.0), ("mount.F_max", 0.0)];

/// A strut of 45 N/mm and 150 N of preload on a mount that is a spring.
fn springs(set: &[(&str, f64)]) -> Bench {
    strut(&[&[NONE, ("gas.enabled", 0.0)][..], &SPRING, set].concat())
}

/// Two springs in series: at the start, and where damper and mass have come to rest.
#[test]
fn springs_in_series_share_the_compression() {
    for preload in [0.0, 900.0] {
        let mut strut = springs(&[("mount.preload", preload)]);
        for length in [0.1775, 0.19, 0.16] {
            strut.set("length", length);
            if length != 0.1775 {
                (0..200).for_each(|_| strut.step(1e-3));
            }
            // k (d_0 - d - u) + F_p = k_e u + F_0
            let displacement = (45e3 * (0.2 - length) + 150.0 - preload) / (45e3 + 5e5);
            let expected = 5e5 * displacement + preload;
            for (name, value, allowed) in [
                ("force", expected, 1e-5),
                ("force_mount", expected, 1e-5),
                ("rod_force", 0.0, 1e-5),
                ("compression", 0.2 - length - displacement, 1e-10),
            ] {
                assert!((strut.get(name) - value).abs() < allowed, "{length}, {name}: {} {value}", strut.get(name));
            }
        }
    }
}

/// Without friction and damper the rod swings between the two springs.
#[test]
fn rod_swings_between_two_springs() {
    let mut strut = springs(&[("damper.enabled", 0.0), ("num.h_max", 5e-6), ("bump.enabled", 0.0)]);
    strut.step(1e-6);
    strut.set("mount.velocity", 0.1);
    let (mut crossings, mut before, rest) = (Vec::new(), 0.1, strut.get("mount.displacement"));
    for step in 1..=12_000 {
        strut.step(5e-6);
        let velocity = strut.get("mount.velocity");
        if velocity * before < 0.0 {
            crossings.push(5e-6 * (f64::from(step) - velocity / (velocity - before)));
        }
        before = velocity;
    }
    let count = crossings.len();
    let period = 2.0 * (crossings[count - 1] - crossings[0]) / (count as f64 - 1.0);
    let expected = TAU * (0.3f64 / (45e3 + 5e5)).sqrt();
    assert!(count > 20 && (period / expected - 1.0).abs() < 1e-4, "{count}: {period} {expected}");
    assert!((strut.get("mount.displacement") - rest).abs() < 1e-4);
}

/// A strut that sticks is its bristles beside its spring, behind the mount.
#[test]
fn stuck_strut_has_the_stiffness_of_the_mount_in_series() {
    let set = [&bare(20.0, 30.0)[..], &SPRING, &[law("LuGre"), ("damper.enabled", 0.0), ("spring.k", 45e3)]].concat();
    let mut strut = strut(&[&set[..], &[("friction.sigma_0", 1e6), ("friction.viscous_coefficient", 0.0)]].concat());
    strut.step(1e-3);
    let before = strut.get("force");
    for step in 1..=400 {
        strut.set("length", 0.1775 - 5e-9 * f64::from(step));
        strut.set("velocity", -5e-6);
        strut.step(1e-3);
    }
    strut.set("velocity", 0.0);
    strut.step(0.1);
    // One of the two contacts has a level, 20 N: bristles of 1e6 N/m, deflected by 2 um less what the mount yields.
    let stiffness = (strut.get("force_mount") - before) / 2e-6;
    let expected = 1.0 / (1.0 / 1.045e6 + 1.0 / 5e5);
    assert!((stiffness / expected - 1.0).abs() < 0.05, "{stiffness} {expected}");
}

/// A rigid mount changes nothing but for its mass: the force of a strut on very stiff rubber is that without.
#[test]
fn stiff_mount_is_no_mount() {
    let run = |set: &[(&str, f64)]| {
        let mut forces = Vec::new();
        golden_trace(set, |k, strut| forces.extend((k % 50 == 25).then(|| strut.get("force_mount"))));
        forces
    };
    let stiff = [MOUNTED, ("mount.k_e", 1e10), ("mount.k_v", 0.0), ("mount.F_max", 0.0), ("mount.mass", 1e-3)];
    for (stiff, rigid) in run(&stiff).into_iter().zip(run(&[])) {
        assert!((stiff - rigid).abs() < 0.05, "{stiff} {rigid}");
    }
}

/// A solver of the workbench has the states of mount and fluid only where they move.
#[test]
fn only_states_of_present_parts_are_in_use() {
    let count = |name: &str, set: &[(&str, f64)]| {
        let bench = Bench::new(name, set);
        bench.instance.model().states_in_use(bench.instance.row()).count()
    };
    let fluid = ("damper.mode", 4.0);
    assert_eq!(
        [&[][..], &[fluid], &[MOUNTED], &[fluid, MOUNTED]].map(|set| count("ShockAbsorber", set)),
        [7, 10, 11, 14]
    );
    assert_eq!([&[][..], &[fluid]].map(|set| count("HydraulicDamper", set)), [2, 5]);
}

/// Switched off, it does not change a bit, whatever its parameters.
#[test]
fn absent_mount_changes_nothing() {
    let trace = |set: &[(&str, f64)]| {
        let mut forces = Vec::new();
        golden_trace(set, |_, strut| forces.push(["force", "force_mount", "rod_force"].map(|name| strut.get(name))));
        forces
    };
    let plain = trace(&[]);
    assert!(plain.iter().all(|[force, mount, rod]| force == mount && *rod == 0.0));
    assert_eq!(plain, trace(&[("mount.preload", 500.0), ("mount.k_e", 1e4), ("mount.displacement", 1e-3)]));
}

/// Force on both eyes over the motion of the golden trace, with all parts of the rubber.
fn mounted_trace(set: &[(&str, f64)]) -> Vec<[f64; 2]> {
    let mut forces = Vec::new();
    golden_trace(&[&[MOUNTED, ("num.input_mode", 2.0)], set].concat(), |_, strut| {
        forces.push(["force", "force_mount"].map(|name| strut.get(name)));
    });
    forces
}

/// The internal step is of first order, and stable far beyond the time constants of rod and mount.
#[test]
fn internal_steps_converge() {
    let exact = mounted_trace(&[("num.h_max", 5e-6)]);
    let error = |h_max: f64| {
        let found = mounted_trace(&[("num.h_max", h_max)]);
        found.iter().zip(&exact).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max)
    };
    let errors = [1e-3, 1e-4, 2e-5].map(error);
    assert!(errors[0] < 60.0 && errors[1] < 0.2 * errors[0] && errors[2] < 0.4 * errors[1], "{errors:?}");
    let light = mounted_trace(&[("mount.mass", 1e-6), ("num.h_max", 1e-3)]);
    assert!(light.iter().flatten().all(|force| force.abs() < 1e4));
}

/// Rates of Model Exchange by steps of Euler, with an event where the rubber turns, against the steps of the strut.
#[test]
fn rates_are_those_of_the_steps() {
    let set = [MOUNTED, ("num.h_max", 2e-6), ("mount.preload", 1300.0), ("friction.sigma_0", 1e5)];
    let mut stepped = strut(&set);
    stepped.step(1e-9);
    let model = stepped.instance.model();
    let mut row = stepped.instance.row().to_vec();
    let [length, velocity, force] = ["length", "velocity", "force_mount"].map(|name| stepped.column(name));
    let states: Vec<usize> = (0..row.len())
        .filter(|column| model.table.at(*column).role.is_state() && model.table.at(*column).is_continuous_state())
        .collect();
    let (mut worst, mut largest, mut turns) = (0f64, 0f64, 0);
    let mut indicators = vec![0.0; model.event_indicators];
    let mut rate = row.clone();
    for step in 0..20_000 {
        let phase = TAU * 25.0 * 2e-6 * f64::from(step);
        let now = [0.1775 + 1e-3 * phase.sin(), 1e-3 * TAU * 25.0 * phase.cos()];
        [row[length], row[velocity]] = now;
        model.indicate(&row, &mut indicators);
        if indicators[model.event_indicators - 1] < 0.0 {
            model.at_event(&mut row);
            turns += 1;
        }
        model.rate(&row, &mut rate);
        states.iter().for_each(|column| row[*column] += 2e-6 * rate[*column]);
        stepped.set("length", now[0]);
        stepped.set("velocity", now[1]);
        stepped.step(2e-6);
        assert!(model.output(&mut row));
        let found = stepped.get("force_mount");
        worst = worst.max((found - row[force]).abs());
        largest = largest.max((found - 1300.0).abs());
    }
    assert!(turns >= 2 && largest > 100.0 && worst < 0.01 * largest, "{turns}: {worst} of {largest}");
}

/// Laws that a mass sticks by at events, or that follow its acceleration, need what only the host of a rigid mount has.
#[test]
fn laws_that_need_other_forces_are_refused() {
    let is_refused = |set: &[(&str, f64)]| strut(set).instance.check().is_err();
    let refused: Vec<&str> =
        laws().filter(|law| is_refused(&[MOUNTED, ("friction.model", law.0)])).map(|law| law.1).collect();
    let expected = [
        "Coulomb",
        "CoulombStiction",
        "CoulombViscous",
        "Stribeck",
        "Karnopp",
        "FrictionalLag",
        "NonReversible",
        "Wojewoda",
    ];
    assert_eq!(refused, expected);
    for (set, text) in [
        (&[MOUNTED, law("Coulomb")][..], "friction.model = Coulomb: must be a law that holds no mass by an event"),
        (&[MOUNTED, law("Wojewoda")], "friction.model = Wojewoda: must be a law that follows no acceleration"),
        (&[MOUNTED, law("Threlfall"), ("friction.mass", 5.0)], "friction.mass = 5: must be 0 if mount.enabled is true"),
        (&[MOUNTED, ("mount.k_e", 0.0)], "mount.k_e = 0: must be > 0 if mount.enabled is true"),
    ] {
        let fault = strut(set).instance.check().unwrap_err().to_string();
        assert!(fault.starts_with(text), "{fault}");
    }
}

/// A preload that pushes the rod until no gas volume is left is named; that of the gas alone is the reason where the eyes
/// are too close.
#[test]
fn a_preload_that_nothing_carries_is_named() {
    let refused = |set: &[(&str, f64)]| {
        let mut strut = strut(set);
        [strut.instance.refresh().unwrap_err().to_string(), strut.instance.step(1e-3).unwrap_err().to_string()]
    };
    for text in refused(&[MOUNTED, ("mount.preload", 1e6)]) {
        assert!(
            text.contains("mount.preload = 1000000 N: must be a force that the strut carries with compression < "),
            "{text}"
        );
    }
    for text in refused(&[MOUNTED, ("mount.preload", 1e6), ("gas.V0", 1e-5), ("length", 0.12)]) {
        assert!(text.contains("m: must be < 0.06496") && !text.contains("mount.preload"), "{text}");
    }
    strut(&[MOUNTED, ("mount.preload", 1e4)]).instance.refresh().unwrap();
}

/// The rod has no finite place, whatever the preload.
#[test]
fn a_preload_is_not_blamed_for_what_happens_without_it() {
    let given = [("init.friction_state", 3.0), ("mount.displacement", 1e308), ("length", 1e308)];
    for set in [&[("gas.p0", 1e300)][..], &[("mount.k_e", 1e-300)], &given] {
        for preload in [0.0, 1e6] {
            let mut strut = strut(&[set, &[MOUNTED, ("mount.preload", preload)]].concat());
            for fault in [strut.instance.refresh().unwrap_err(), strut.instance.step(1e-3).unwrap_err()] {
                assert!(!fault.to_string().contains("mount.preload"), "{set:?}: {fault}");
            }
        }
    }
}

/// Exact derivatives against central differences, before the run and within it.
#[test]
fn derivatives_of_both_forces() {
    for steps in [0, 20] {
        let mut strut = strut(&[MOUNTED, ("velocity", -0.05), ("mount.preload", 1000.0)]);
        (0..steps).for_each(|_| strut.step(1e-3));
        for (input, half) in [("length", 1e-7), ("velocity", 1e-6), ("mount.k_e", 1.0), ("mount.preload", 1e-2)] {
            for output in ["force", "force_mount"] {
                let value = strut.get(input);
                let mut at = |value: f64| {
                    strut.set(input, value);
                    strut.get(output)
                };
                let difference = (at(value + half) - at(value - half)) / (2.0 * half);
                at(value);
                let [seed, answer] = [strut.column(input), strut.column(output)];
                let exact = strut.instance.derivative([(seed, 1.0)].into_iter())[answer].slope;
                let allowed = 1e-4 * difference.abs() + 1e-9 / half;
                assert!((exact - difference).abs() < allowed, "{steps}, {output} by {input}: {exact} {difference}");
            }
        }
    }
}

/// A wheel on the strut is stable at the step that the strut advises.
#[test]
fn advised_step_is_stable() {
    for set in [&[NONE][..], &[law("LuGre")], &[NONE, ("damper.c_comp", 5000.0), ("damper.c_reb", 5000.0)]] {
        let mut strut = strut(&[set, &[MOUNTED, ("num.mass_ref", 16.4)]].concat());
        let step = strut.get("step_limit");
        assert!(step > 2e-4 && step < 0.02, "{set:?}: {step}");
        let (mut x, mut velocity) = (0.1775, 1e-4);
        let (rest, mut force) = (strut.get("force"), strut.get("force"));
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
        assert!(velocity.abs() < 1e-4, "{set:?}: {velocity} after steps of {step} s");
    }
}

/// Height of the body of a quarter car that stands on the mounted strut, on a road of 2 mm at 10 Hz, every 10 ms.
fn body_heights(step: f64) -> Vec<f64> {
    let mut car = Bench::new("QuarterCar", &[]);
    let mut strut = strut(&[MOUNTED, ("mount.preload", 1325.2555)]);
    let mut heights = Vec::new();
    let every = (1e-2 / step).round() as usize;
    for k in 0..50 * every {
        let phase = TAU * 10.0 * step * k as f64;
        for name in ["length", "velocity"] {
            let value = car.get(name);
            strut.set(name, value);
        }
        for (input, output) in [("strut_force", "force"), ("rod_force", "rod_force")] {
            let value = strut.get(output);
            car.set(input, value);
        }
        car.set("road_height", 2e-3 * phase.sin());
        car.set("road_velocity", 2e-3 * TAU * 10.0 * phase.cos());
        strut.step(step);
        car.step(step);
        if k % every == every - 1 {
            heights.push(car.get("body_height"));
        }
    }
    heights
}

/// Between the FMUs of a car and a strut a step of 1 ms is short enough: the rod moves in steps of its own.
#[test]
fn master_needs_no_short_steps() {
    let exact = body_heights(2e-5);
    let largest = exact.iter().fold(0f64, |largest, height| largest.max(height.abs()));
    let error =
        |step: f64| body_heights(step).iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
    let errors = [1e-3, 5e-4, 2.5e-4].map(error);
    assert!(largest > 2e-4, "{largest}");
    assert!(errors[0] < 0.1 && errors[1] < 0.65 * errors[0] && errors[2] < 0.65 * errors[1], "{errors:?}");
}
