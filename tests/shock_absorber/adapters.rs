//! The same strut as other hosts see it.

use crate::{LINEAR, force, laws, strut};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// The same strut seen by four hosts: metres of length, millimetres of compression, wheel travel, tension positive.
#[test]
fn adapters_of_the_hosts() {
    let mut own = strut(&[]);
    own.set("velocity", -0.2);
    let force = force(&mut own, 0.17, -0.2);
    let mut millimetres = strut(&[("adapter.length_offset", 0.2), ("adapter.length_gain", -1e-3)]);
    millimetres.set("velocity", 200.0);
    millimetres.set("length", 30.0);
    assert_abs_diff_eq!(millimetres.get("force"), force, epsilon = 1e-9 * force);
    let mut wheel = strut(&[("adapter.length_offset", 0.1775), ("adapter.length_gain", -1.25)]);
    wheel.set("length", 0.006);
    wheel.set("velocity", 0.16);
    assert_abs_diff_eq!(wheel.get("force"), force, epsilon = 1e-9 * force);
    assert!(
        abs_diff_eq!(wheel.get("force_travel"), -1.25 * force, epsilon = 1e-9 * force),
        "resists the jounce of the wheel"
    );
    assert_abs_diff_eq!(own.get("force_tension"), -force, epsilon = 1e-12);
    // The self-test of any host: compress, and the force grows.
    let slower = self::force(&mut own, 0.18, 0.0);
    assert!(self::force(&mut own, 0.17, 0.0) > slower && self::force(&mut own, 0.17, -0.1) > slower);
}

/// A host in millimetres of compression that drives any law, also by its acceleration, sees the same friction.
#[test]
fn adapters_drive_every_law_alike() {
    for (number, name) in laws().skip(1) {
        let run = |adapter: &[(&str, f64)], offset: f64, gain: f64| {
            let mut strut = strut(&[adapter, &[("friction.model", number), LINEAR]].concat());
            let step = |k: i32| {
                let phase = 0.05 * f64::from(k);
                strut.set("length", (0.1775 + 1e-3 * phase.sin() - offset) / gain);
                strut.set("velocity", 0.05 * phase.cos() / gain);
                strut.set("acceleration", -2.5 * phase.sin() / gain);
                strut.step(1e-3);
                strut.get("force_friction")
            };
            (0..150).map(step).collect::<Vec<f64>>()
        };
        let own = run(&[], 0.0, 1.0);
        let adapter = [("adapter.length_offset", 0.2), ("adapter.length_gain", -1e-3)];
        let worst = run(&adapter, 0.2, -1e-3).iter().zip(&own).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-6, "{name}: {worst} N");
    }
}
