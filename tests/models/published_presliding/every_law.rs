//! Ramped inputs and derivatives of the force, for each of the laws.

use super::{after, assert_close};
use approx::abs_diff_eq;

/// Velocity and load that vary linearly, through a reversal, compared with a dense sequence of short held steps.
#[test]
fn ramped_inputs_agree_with_many_short_steps() {
    for model in ["BlimanSorine", "ResetIntegrator", "Dankowicz", "ElastoPlastic", "SpeckerDynamic"] {
        let [mut ramp, mut dense] = [0; 2].map(|_| after(model, &[], -2e-3, 0.01));
        for step in 0..1000 {
            let time = 2e-5 * f64::from(step);
            for (name, begin, slope) in [("velocity", -2e-3, 0.5), ("normal_force", 9.81, 100.0)] {
                ramp.set(name, begin + slope * time);
                ramp.instance.set_slope(ramp.column(name), slope).unwrap();
            }
            ramp.step(2e-5);
        }
        let n = 100_000;
        for k in 0..n {
            let time = 0.02 * (f64::from(k) + 0.5) / f64::from(n);
            dense.set("velocity", -2e-3 + 0.5 * time);
            dense.set("normal_force", 9.81 + 100.0 * time);
            dense.step(0.02 / f64::from(n));
        }
        dense.set("velocity", 8e-3);
        dense.set("normal_force", 11.81);
        for name in ["friction_force", "dissipated_energy"] {
            assert_close(&format!("{model} {name}"), ramp.get(name), dense.get(name), 2e-6);
        }
    }
}

/// Exact derivatives of the force, compared with central differences, away from the kinks.
#[test]
fn derivatives_of_the_force_agree_with_differences() {
    for model in ["BlimanSorine", "ResetIntegrator", "Dankowicz", "ElastoPlastic", "Bristle", "SpeckerDynamic"] {
        for (velocity, time) in [(1e-4, 0.06), (3e-4, 0.03), (-8e-4, 0.013), (2e-3, 0.004), (-5e-3, 0.005)] {
            let mut bench = after(model, &[("normal_force", 12.0)], velocity, time);
            let force = bench.column("friction_force");
            for name in ["velocity", "normal_force", "bristle_deflection", "sigma_0", "breakaway_ratio", "mu_s", "y_1"]
            {
                if !bench.has(name) {
                    continue;
                }
                let (column, value) = (bench.column(name), bench.get(name));
                let exact = bench.instance.derivative([(column, 1.0)].into_iter())[force].slope;
                let h = 1e-5 * value.abs();
                let [below, above] = [value - h, value + h].map(|x| {
                    bench.set(name, x);
                    bench.get("friction_force")
                });
                bench.set(name, value);
                let scale = bench.get("friction_force").abs() / value.abs();
                let difference = (above - below) / (2.0 * h);
                assert!(
                    abs_diff_eq!(exact, difference, epsilon = 1e-5 * scale),
                    "{model} {name}: {exact} against {difference}"
                );
            }
        }
    }
}
