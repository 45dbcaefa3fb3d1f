//! Inputs: extreme ones are rejected without a trace, everyday ones are not.

use super::{for_all, pick, set_velocity};
use crate::common::random::Random;

#[test]
fn finite_inputs_give_finite_results_or_a_rejection_that_changes_nothing() {
    let extremes = [0.0, 5e-324, 1e-310, 1e-160, 1e-12, 1e-3, 1.0, 1e6, 1e150, 1e308];
    let steps = [1e-300, 1e-12, 1e-6, 1.0, 1e6, 1e300];
    for_all(|bench, what| {
        let mut random = Random(17);
        for _ in 0..30 {
            let scalars = ["velocity", "normal_force", "external_force", "acceleration"];
            let vectors = ["velocity_x", "velocity_y", "velocity_z", "normal_x", "normal_y", "normal_z"];
            for name in scalars.into_iter().chain(vectors) {
                if bench.has(name) {
                    let sign = if name == "normal_force" { 1.0 } else { pick(&mut random, &[-1.0, 1.0]) };
                    bench.set(name, sign * pick(&mut random, &extremes));
                }
            }
            let before = bench.instance.save();
            match bench.instance.step(pick(&mut random, &steps)) {
                Ok(()) => assert!(bench.instance.row().iter().all(|value| value.is_finite()), "{what}"),
                Err(_) => {
                    assert_eq!(bench.instance.save(), before, "{what}");
                    bench.instance.reset();
                }
            }
        }
    });
}

/// Realistic inputs, as from a vehicle, are never rejected, at any step that a master can choose.
#[test]
fn everyday_inputs_are_never_rejected() {
    for_all(|bench, what| {
        let mut random = Random(19);
        for _ in 0..50 {
            set_velocity(
                bench,
                pick(&mut random, &[0.0, 1e-9, 1e-4, 0.1, 2.0, 20.0]) * pick(&mut random, &[-1.0, 1.0]),
            );
            bench.set("normal_force", pick(&mut random, &[0.0, 1e-9, 1e-3, 10.0, 2e4]));
            let h = pick(&mut random, &[2e-13, 1e-6, 1e-4, 1e-3, 0.1, 1.0]);
            bench.instance.step(h).unwrap_or_else(|fault| panic!("{what}: {fault}"));
        }
    });
}
