//! The shock absorber: one subject per file, and what they share.

#![allow(non_upper_case_globals, reason = "the names of the standard")]

#[path = "../common/mod.rs"]
mod common;

mod adapters;
mod advice;
mod communication_step;
mod derivatives;
mod friction;
mod golden;
mod guide_contact;
mod magnetorheological;
mod mount;
mod parts;
mod passivity;
mod refusals;
mod side_loads;
mod strut_setup;

use common::Bench;
use stribeck::catalogue::by_name;
use stribeck::model::Kind;

/// Variables and their values.
type Values<'a> = &'a [(&'a str, f64)];

/// A shock absorber with its default parameters but for these.
fn strut(set: Values) -> Bench {
    Bench::new("ShockAbsorber", set)
}

/// Numbers and names of the friction laws.
fn laws() -> impl Iterator<Item = (f64, &'static str)> {
    let variable = strut(&[]).column("friction.model");
    let Kind::Enumeration(laws) = by_name("ShockAbsorber").unwrap().table.at(variable).kind else { panic!() };
    laws.items.iter().enumerate().map(|(at, law)| (at as f64 + 1.0, law.name))
}

fn law(name: &str) -> (&'static str, f64) {
    ("friction.model", laws().find(|law| law.1 == name).unwrap().0)
}

const NONE: (&str, f64) = ("friction.model", 1.0);

const TABLE: (&str, f64) = ("damper.mode", 2.0);

fn force(strut: &mut Bench, length: f64, velocity: f64) -> f64 {
    strut.set("length", length);
    strut.set("velocity", velocity);
    strut.get("force")
}

/// The complete default strut over half a second of 2 Hz, the inputs held over each step of 1 ms and
/// the forces read at its end.
fn golden_trace(set: &[(&str, f64)], mut see: impl FnMut(usize, &mut Bench)) -> f64 {
    let mut strut = strut(&[&[TABLE], set].concat());
    for (input, value) in
        [("side_force_m", 80.0), ("side_force_n", -30.0), ("side_moment_m", 2.0), ("side_moment_n", 6.0)]
    {
        strut.set(input, value);
    }
    let mut work = 0.0;
    for k in 0..=500usize {
        let phase = 4.0 * std::f64::consts::PI * 1e-3 * k as f64;
        strut.set("length", 0.1775 + 0.012 * phase.sin());
        strut.set("velocity", 0.012 * 4.0 * std::f64::consts::PI * phase.cos());
        strut.step(1e-3);
        see(k, &mut strut);
        work += (strut.get("friction_1") + strut.get("friction_2")) * strut.get("velocity") * 1e-3;
    }
    work
}

/// One contact with these levels and nothing else: no spring, gas, stops, damper or side load.
fn bare(kinetic: f64, breakaway: f64) -> Vec<(&'static str, f64)> {
    let mut set = vec![
        ("spring.k", 0.0),
        ("spring.preload", 0.0),
        ("gas.enabled", 0.0),
        ("damper.scale", 0.0),
        ("side.offset_m", 0.0),
        ("c1.preload_s", breakaway),
        ("c1.preload_k", kinetic),
        ("c2.preload_s", 0.0),
        ("c2.preload_k", 0.0),
    ];
    // At rest, whatever the first velocity.
    set.push(("init.friction_state", 2.0));
    set.extend(["c1.mu_s", "c1.mu_k", "c2.mu_s", "c2.mu_k"].map(|name| (name, 0.0)));
    set
}

const LINEAR: (&str, f64) = ("num.input_mode", 2.0);
