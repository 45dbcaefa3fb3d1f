//! A load that falls while bristles slide: what the printed equations give, and what a contact makes of it.

use crate::common::Bench;
use stribeck::model::Kind;

const SPEED: f64 = 0.015;
/// Start values of the laws: sigma_0, sigma_1, sigma_2, mu_k and mu_s.
const STIFFNESS: f64 = 1e5;
const DAMPING: f64 = 316.227_766;
const VISCOUS: f64 = 0.1;
const KINETIC: f64 = 0.1;
const STATIC: f64 = 0.15;

/// A load that falls linearly.
#[derive(Clone, Copy)]
struct Fall {
    from: f64,
    to: f64,
    time: f64,
}

/// Those of the pages, and one towards no load at all.
const FALLS: [Fall; 3] = [
    Fall { from: 100.0, to: 10.0, time: 1e-2 },
    Fall { from: 100.0, to: 1.0, time: 1e-3 },
    Fall { from: 100.0, to: 0.1, time: 1e-3 },
];

/// The laws of one bristle deflection along x.
const LAWS: [&str; 4] = ["LuGre", "ElastoPlastic", "LuGrePlanar", "ElastoPlasticPlanar"];

#[derive(Clone, Copy, Debug)]
enum Steps {
    Held(u32),
    Sloped(u32),
}

/// The force at the end of a fall in steady sliding.
fn force_after(bench: &mut Bench, fall: Fall, steps: Steps) -> f64 {
    let [velocity, force] = [["velocity", "velocity_x"], ["friction_force", "friction_force_x"]]
        .map(|names| names.into_iter().find(|name| bench.has(name)).expect("one of them"));
    bench.set(velocity, SPEED);
    bench.set("normal_force", fall.from);
    for _ in 0..10 {
        bench.step(0.1);
    }
    let (Steps::Held(count) | Steps::Sloped(count)) = steps;
    let at = |step: u32| fall.from + (fall.to - fall.from) * f64::from(step) / f64::from(count);
    for step in 0..count {
        match steps {
            Steps::Held(_) => bench.set("normal_force", at(step + 1)),
            Steps::Sloped(_) => {
                bench.set("normal_force", at(step));
                let load = bench.column("normal_force");
                bench.instance.set_slope(load, (fall.to - fall.from) / fall.time).unwrap();
            }
        }
        bench.step(fall.time / f64::from(count));
    }
    bench.get(force)
}

/// By the formula of the pages: with s = sigma_0 z / f_C the equation of the bristles is df_C/dt s + f_C ds/dt =
/// sigma_0 v (1 - s), which a power of f_C solves.
fn by_hand(fall: Fall) -> f64 {
    let [first, last] = [fall.from, fall.to].map(|load| KINETIC * load);
    let a = STIFFNESS * SPEED * fall.time / (first - last);
    let k = (1.0 - (last / first).powf(a - 1.0)) / (a - 1.0);
    last * (1.0 + k) - DAMPING * SPEED * k + VISCOUS * SPEED
}

#[test]
fn bristles_push_by_the_formula_of_their_pages() {
    for (fall, printed) in FALLS.into_iter().zip([-3.4, -267.0, f64::NAN]) {
        assert!(printed.is_nan() || (by_hand(fall) / printed - 1.0).abs() < 2e-3, "{} N", by_hand(fall));
        for law in LAWS {
            for (steps, error) in [(Steps::Sloped(1000), 2e-3), (Steps::Held(100_000), 2e-3)] {
                let found = force_after(&mut Bench::new(law, &[]), fall, steps);
                let expected = by_hand(fall);
                assert!((found / expected - 1.0).abs() < error, "{law} {steps:?}: {found} N for {expected} N");
            }
        }
    }
}

/// One element is one deflection; four lag more.
#[test]
fn elements_push_too() {
    for (fall, printed) in FALLS.into_iter().zip([-7.1, -278.0]) {
        for (count, expected) in [(1.0, by_hand(fall)), (4.0, printed)] {
            let mut law = Bench::new("Leuven", &[("element_count", count)]);
            let found = force_after(&mut law, fall, Steps::Held(100_000));
            assert!((found / expected - 1.0).abs() < 7e-3, "{count}: {found} N for {expected} N");
        }
    }
}

/// Where nothing damps the bristles, and in one long held step, they carry no less than the level.
#[test]
fn nothing_pushes_without_damping_or_in_a_long_held_step() {
    for fall in FALLS {
        let level = KINETIC * fall.to;
        for law in LAWS {
            for (values, steps) in [
                (("damping_velocity", 1e-3), Steps::Sloped(100)),
                (("sigma_1", 0.0), Steps::Held(1000)),
                (("sigma_1", DAMPING), Steps::Held(1)),
            ] {
                let found = force_after(&mut Bench::new(law, &[values]), fall, steps);
                assert!(found >= level - 1e-3, "{law} {values:?} {steps:?}: {found} N for {level} N");
            }
        }
    }
}

/// In a contact of the strut the push has the bound of the pages, down to no load.
#[test]
fn a_contact_lets_bristles_slip() {
    let bound = DAMPING * SPEED * (STATIC / KINETIC - 1.0);
    for law in ["LuGre", "ElastoPlastic", "Leuven"] {
        for to in [10.0, 1.0, 1e-2, 1e-4] {
            let fall = Fall { from: 100.0, to, time: 1e-3 };
            for steps in [Steps::Held(1000), Steps::Sloped(1), Steps::Sloped(1000)] {
                let mut guide = Bench::new("GuideContact", &[("levels.preload_s", 0.0), ("levels.preload_k", 0.0)]);
                guide.set("levels.mu_s", STATIC);
                guide.set("levels.mu_k", KINETIC);
                let column = guide.column("friction.model");
                let Kind::Enumeration(laws) = guide.instance.model().table.at(column).kind else { panic!("a choice") };
                let number = laws.items.iter().position(|item| item.name == law).expect("a law");
                guide.instance.set_column(column, number as f64 + 1.0).unwrap();
                let found = force_after(&mut guide, fall, steps);
                assert!(found >= -bound, "{law} {to} {steps:?}: {found} N, bound {bound} N");
            }
        }
    }
}
