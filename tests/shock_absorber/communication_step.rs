//! Communication steps: the largest stable one, what the strut advises, and what it does not depend on.

use crate::common::{Bench, NO_CALLBACKS};
use crate::{LINEAR, NONE, TABLE, bare, law, strut};
use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};
use stribeck::catalogue::by_name;
use stribeck_ffi::c::stribeck_status::{STRIBECK_OK, STRIBECK_UNKNOWN_VARIABLE};
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// A free mass of 16.36 kg on the strut: by how much has a small velocity at rest length grown after 500 steps? The force
/// is held over each step; sequential: it belongs to the motion at its beginning, parallel: it is one step older.
fn velocity_ratio(strut: &mut Bench, h: f64, parallel: bool) -> f64 {
    const MASS: f64 = 16.36;
    let rest = strut.get("force");
    let length = strut.get("length");
    let (mut x, mut v, mut old) = (0.0, 1e-7, 0.0);
    let start = v;
    let mut largest = 0f64;
    for k in 0..600 {
        strut.set("length", length + x);
        strut.set("velocity", v);
        let now = strut.get("force") - rest;
        let force = if parallel { old } else { now };
        old = now;
        strut.set("acceleration", force / MASS);
        strut.step(h);
        x += h * (v + h * force / (2.0 * MASS));
        v += h * force / MASS;
        if k >= 500 {
            largest = largest.max(v.abs());
        }
        if v.abs() > 1e-3 {
            return f64::INFINITY;
        }
    }
    largest / start
}

struct Limit {
    name: &'static str,
    set: Vec<(&'static str, f64)>,
    sequential: f64,
    parallel: f64,
}

/// Elements of a strut, and the largest communication steps for a mass of 16.36 kg in seconds.
fn limits() -> Vec<Limit> {
    let element = |name, set: &[(&'static str, f64)], [sequential, parallel]: [f64; 2]| Limit {
        name,
        set: [bare(0.0, 0.0), set.to_vec()].concat(),
        sequential,
        parallel,
    };
    let friction = |level: f64| [("c1.preload_k", level), ("c1.preload_s", level)];
    let band =
        |width: f64| [&friction(40.0)[..], &[law("RooneyDeravi"), ("friction.transition_velocity", width)]].concat();
    let damper = |c: f64| [("damper.scale", 1.0), ("damper.c_comp", c), ("damper.c_reb", c)];
    let soft = ("spring.k", 45e3);
    // The friction of the last rows is stuck from the start.
    let lugre = [&friction(1000.0)[..], &[("friction.viscous_coefficient", 0.0)]].concat();
    vec![
        element("damper and spring", &[&damper(1500.0)[..], &[soft, NONE]].concat(), [21.7e-3, 8.7e-3]),
        element("strong damper", &[&damper(5000.0)[..], &[NONE]].concat(), [6.5e-3, 3.2e-3]),
        element("Coulomb over 1 mm/s", &band(1e-3), [0.82e-3, 0.41e-3]),
        element("Coulomb over 0.1 mm/s", &band(1e-4), [0.081e-3, 0.041e-3]),
        element("LuGre, damper and spring", &[&lugre[..], &damper(1500.0), &[soft]].concat(), [18e-3, 5.3e-3]),
        element("LuGre", &lugre, [6.3e-3, 2.1e-3]),
        element("end stop and damper", &[&damper(1500.0)[..], &STOP, &[NONE]].concat(), [2.9e-3, 0.91e-3]),
        element("end stop, weak damper", &[&damper(150.0)[..], &STOP, &[NONE]].concat(), [0.30e-3, 0.10e-3]),
    ]
}

/// On the stop, 10 mm deep.
const STOP: [(&str, f64); 2] = [("bump.k", 1e6), ("bump.gap", 0.0125)];

/// The advice of the strut itself.
fn advice(set: &[(&str, f64)], is_parallel: bool) -> f64 {
    let mut strut = strut(&[set, &[("num.mass_ref", 16.36)]].concat());
    strut.set("friction.exchange", if is_parallel { 2.0 } else { 1.0 });
    strut.get("step_limit")
}

/// The limits of the table hold where the strut sees the true displacement: length and velocity move within a step.
#[test]
fn limits_of_the_communication_step() {
    for Limit { name, set, sequential, parallel } in limits() {
        let set = [&set[..], &[LINEAR]].concat();
        for (limit, is_parallel) in [(sequential, false), (parallel, true)] {
            let order = if is_parallel { "parallel" } else { "sequential" };
            let below = velocity_ratio(&mut strut(&set), 0.9 * limit, is_parallel);
            let above = velocity_ratio(&mut strut(&set), 1.1 * limit, is_parallel);
            assert!(below < 1.0, "{name}, {order}: grows by {below} at 0.9 of {limit} s");
            assert!(above > 1.0, "{name}, {order}: dies to {above} at 1.1 of {limit} s");
            let advice = advice(&set, is_parallel) / limit;
            assert!((0.8..1.25).contains(&advice), "{name}, {order}: step_limit is {advice} of {limit} s");
        }
    }
}

/// With held inputs bristles see the velocity at the beginning of the step, and need a shorter one; step_limit knows.
#[test]
fn advice_for_held_inputs() {
    for Limit { name, set, .. } in limits() {
        for is_parallel in [false, true] {
            let advice = advice(&set, is_parallel);
            let below = velocity_ratio(&mut strut(&set), 0.8 * advice, is_parallel);
            let above = velocity_ratio(&mut strut(&set), 1.4 * advice, is_parallel);
            assert!(below < 1.0 && above > 1.0, "{name}, {is_parallel}: {below} {above} about {advice} s");
        }
    }
}

/// A cycle of 2 Hz and 12 mm under side load, with its acceleration; forces at each whole `every` s.
fn smooth_cycle(set: &[(&str, f64)], h: f64, every: f64) -> Vec<f64> {
    let mut strut = strut(set);
    strut.set("side_force_m", 80.0);
    let motion = |time: f64| {
        let phase = 4.0 * std::f64::consts::PI * time;
        let rate = 4.0 * std::f64::consts::PI;
        (0.1775 + 0.012 * phase.sin(), 0.012 * rate * phase.cos(), -0.012 * rate * rate * phase.sin())
    };
    let mut forces = Vec::new();
    let steps = (0.5 / h).round() as usize;
    for k in 0..=steps {
        let (length, velocity, acceleration) = motion(k as f64 * h);
        strut.set("length", length);
        strut.set("acceleration", acceleration);
        strut.set("velocity", velocity);
        if k % (every / h).round() as usize == 0 {
            forces.push(strut.get("force"));
        }
        strut.step(h);
    }
    forces
}

#[test]
fn force_does_not_depend_on_the_communication_step() {
    for set in [&[][..], &[TABLE], &[law("Dahl")], &[law("MaxwellSlip")]] {
        let set = [&[("num.input_mode", 2.0)], set].concat();
        let fine = smooth_cycle(&set, 1e-4, 5e-3);
        for h in [1e-3, 5e-3] {
            let worst = smooth_cycle(&set, h, 5e-3).iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(worst < 0.5, "{set:?}, {h} s: {worst} N");
        }
    }
}

/// Behind a series stiffness, from one softer than the damper to a rigid one, the advice is neither above the true
/// limit nor far below it.
#[test]
fn advice_with_a_series_stiffness() {
    for (law, exchange) in [(NONE, false), (NONE, true), (law("LuGre"), false), (law("LuGre"), true)] {
        for k_series in [1e5, 1e6, 1e9] {
            for input_mode in [1.0, 2.0] {
                let element = [
                    law,
                    ("damper.scale", 1.0),
                    ("damper.c_reb", 1500.0),
                    ("spring.k", 45e3),
                    ("c1.preload_k", 1000.0),
                    ("c1.preload_s", 1000.0),
                    ("damper.k_series", k_series),
                    ("num.input_mode", input_mode),
                ];
                let set = [&bare(0.0, 0.0)[..], &element].concat();
                let advice = advice(&set, exchange);
                let ratio = |part: f64| velocity_ratio(&mut strut(&set), part * advice, exchange);
                let case = format!("{law:?}, {exchange}, {k_series} N/m, {input_mode}: {advice} s");
                assert!(ratio(0.5) < 1.0 && ratio(0.95) < 1.0, "{case} grows by {} {}", ratio(0.5), ratio(0.95));
                assert!(ratio(3.5) > 1.0, "{case} dies to {}", ratio(3.5));
            }
        }
    }
}

#[test]
fn advice_has_no_derivatives() {
    let model = by_name("ShockAbsorber").unwrap();
    let without: Vec<String> =
        model.table.iter().filter(|variable| variable.is_advice).map(|variable| variable.path.to_string()).collect();
    assert_eq!(without, ["dforce_dlength", "dforce_dvelocity", "step_limit"]);
    let [limit, force, length] =
        ["step_limit", "force", "length"].map(|name| model.reference(model.find(name).unwrap()));
    let mut handle = null_mut();
    // SAFETY: a handle of this test, freed once.
    unsafe {
        assert_eq!(stribeck_create(c"ShockAbsorber".as_ptr(), &mut handle), STRIBECK_OK);
        assert_eq!(stribeck_derivative(handle, force, length, &mut 0.0), STRIBECK_OK);
        assert_eq!(stribeck_derivative(handle, limit, length, &mut 0.0), STRIBECK_UNKNOWN_VARIABLE);
        assert_eq!(CStr::from_ptr(stribeck_last_error(handle)).to_str(), Ok("step_limit has no derivatives"));
        stribeck_free(handle);
    }
    let guid = CString::new(model.guid()).unwrap();
    // SAFETY: texts that end, one reference and one value each; the last instance of this thread is freed once.
    unsafe {
        let name = c"ShockAbsorber".as_ptr();
        let start = |kind| {
            let c = fmi2Instantiate(name, kind, guid.as_ptr(), null(), &NO_CALLBACKS, fmi2False, fmi2False);
            assert_eq!(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
            assert_eq!(fmi2EnterInitializationMode(c), fmi2OK);
            assert_eq!(fmi2ExitInitializationMode(c), fmi2OK);
            c
        };
        for (unknown, expected) in [(force, fmi2OK), (limit, fmi2Discard)] {
            let c = start(fmi2CoSimulation);
            assert_eq!(fmi2GetDirectionalDerivative(c, &unknown, 1, &length, 1, &1.0, &mut 0.0), expected);
            fmi2FreeInstance(c);
            let c = start(fmi2CoSimulation);
            assert_eq!(fmi2DoStep(c, 0.0, 1e-3, fmi2True), fmi2OK);
            assert_eq!(fmi2GetRealOutputDerivatives(c, &unknown, 1, &1, &mut 0.0), expected);
            fmi2FreeInstance(c);
        }
    }
}
