//! Numbers printed in papers and closed forms of the laws, with their source in the test's name or above it.

use crate::common::Bench;
use crate::common::thesis::{F_C, F_S, SIGMA_0, SIGMA_1, SIGMA_2, V_S, level};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// Divides `time` into irregular steps of a master.
fn run(model: &str, values: &[(&str, f64)], time: f64, steps: &[f64]) -> Bench {
    let mut bench = Bench::new(model, values);
    let total: f64 = steps.iter().sum();
    for part in steps {
        bench.step(time * part / total);
    }
    bench
}

fn divisions() -> Vec<Vec<f64>> {
    let ragged = (0..500).map(|k| 1.0 + (k as f64).sin() * 0.999).collect();
    vec![vec![1.0], vec![1.0; 10], vec![1.0; 1000], vec![1e-9, 1.0, 1e-3, 0.5], ragged]
}

#[test]
fn lugre_at_constant_velocity_is_its_exponential_whatever_the_steps() {
    for velocity in [1e-4, -1e-3, 1e-2] {
        for time in [1e-4, 5e-3, 0.15, 1.0] {
            let g = level(velocity);
            let z_ss = g * velocity.signum() / SIGMA_0;
            let z = -z_ss * (-SIGMA_0 * velocity.abs() * time / g).exp_m1();
            let rate = velocity - SIGMA_0 * velocity.abs() * z / g;
            let force = SIGMA_0 * z + SIGMA_1 * rate + SIGMA_2 * velocity;
            for steps in divisions() {
                let mut law = run("LuGre", &[("velocity", velocity)], time, &steps);
                let deflection = law.get("bristle_deflection");
                assert!(
                    abs_diff_eq!(deflection / z, 1.0, epsilon = 1e-12),
                    "{velocity} {time}: {deflection} against {z}"
                );
                let found = law.get("friction_force");
                assert!(
                    abs_diff_eq!(found / force, 1.0, epsilon = 1e-12),
                    "{velocity} {time}: {found} against {force}"
                );
            }
        }
    }
}

#[test]
fn dahl_at_constant_velocity_is_its_closed_form_whatever_the_steps() {
    let q = SIGMA_0 * 1.5e-5 / F_C;
    let forms = [
        (0.0, F_C * q.min(1.0)),
        (0.5, F_C * (1.0 - (1.0 - q / 2.0).max(0.0).powi(2))),
        (1.0, -F_C * (-q).exp_m1()),
        (2.0, F_C * q / (1.0 + q)),
        (3.0, F_C * (1.0 - (1.0 + 2.0 * q).powf(-0.5))),
    ];
    for (alpha, force) in forms {
        for steps in divisions() {
            let found = run("Dahl", &[("velocity", 1e-4), ("alpha", alpha)], 0.15, &steps).get("friction_force");
            assert!(abs_diff_eq!(found / force, 1.0, epsilon = 1e-12), "{alpha}: {found} against {force}");
        }
    }
}

/// Force and deflection from rest at constant velocity, integrated independently (9 digits).
#[test]
fn lugre_and_dahl_from_rest() {
    let rows = [
        (1e-4, 0.05, 0.391727654, 0.446180717, 4.23683262e-6),
        (1e-4, 0.10, 0.627032724, 0.740972285, 7.24971102e-6),
        (1e-4, 0.15, 0.768377037, 0.950603211, 9.39221629e-6),
        (1e-4, 1.00, 0.980963305, 1.46506032, 1.46501574e-5),
        (1e-3, 0.01, 0.627032724, 0.804237283, 6.70454968e-6),
        (1e-2, 1e-3, 0.627032724, 1.76905496, 6.27032724e-6),
        (1e-2, 5e-3, 0.975000162, 0.995340788, 9.75000162e-6),
    ];
    for (velocity, time, dahl, lugre, deflection) in rows {
        let found = run("Dahl", &[("velocity", velocity)], time, &[1.0]).get("friction_force");
        assert!(abs_diff_eq!(found / dahl, 1.0, epsilon = 2e-9), "Dahl {velocity} {time}: {found}");
        let mut law = run("LuGre", &[("velocity", velocity)], time, &[1.0]);
        assert!(abs_diff_eq!(law.get("friction_force") / lugre, 1.0, epsilon = 5e-9), "{}", law.get("friction_force"));
        assert_abs_diff_eq!(law.get("bristle_deflection") / deflection, 1.0, epsilon = 5e-9);
    }
}

#[test]
fn lugre_steady_force() {
    let forces = [(1e-4, 1.466629443), (5e-4, 1.363051784), (1e-3, 1.161544866), (2e-3, 0.990183821), (0.1, 0.991)];
    for (velocity, force) in forces {
        let found = run("LuGre", &[("velocity", velocity)], 10.0, &[1.0; 20]).get("friction_force");
        assert!(abs_diff_eq!(found, force, epsilon = 1e-9), "{velocity}: {found}");
    }
}

/// Brown-McPhee at default parameters, and its peak of 0.99956503 f_s at 1.00681878 v_0.
#[test]
fn brown_mcphee_curve() {
    let force = |velocity: f64| Bench::new("BrownMcPhee", &[("velocity", velocity)]).get("friction_force");
    let points = [
        (-3e-4, -1.06439826),
        (1e-5, 0.0479385041),
        (2e-4, 0.821260792),
        (5e-4, 1.31721401),
        (7.5e-4, 1.43992711),
        (1e-3, 1.47084204),
        (1.25e-3, 1.45217383),
        (2e-3, 1.30132631),
        (1e-2, 0.988397493),
    ];
    for (velocity, expected) in points {
        assert!(abs_diff_eq!(force(velocity) / expected, 1.0, epsilon = 1e-8), "{velocity}: {}", force(velocity));
    }
    let peak = (0..20_001).map(|k| force(0.9e-3 + 2e-4 * f64::from(k) / 20_000.0)).fold(0.0, f64::max);
    assert!(abs_diff_eq!(peak / F_S, 0.999_565_03, epsilon = 1e-8), "{peak}");
    assert_abs_diff_eq!(peak, force(1.006_818_78e-3), epsilon = 1e-12);
}

/// Drift per load cycle 0 -> 0.8 -> 0 N, quasi-static: (f_s / sigma_0) ln(f_s^2 / (f_s^2 - F^2)), 5.15563e-6 m for
/// LuGre; with f_C instead 1.07294e-5 m for Dahl. A mass of 1 kg is loaded at 1 Hz.
#[test]
fn drift_under_a_pulsating_load() {
    for (model, drift, h) in [("LuGre", 5.15563e-6, 2e-5), ("Dahl", 1.07294e-5, 2e-5)] {
        let mut law = Bench::new(model, &[]);
        let (mut x, mut v, mut force) = (0.0, 0.0, 0.0);
        let mut ends = Vec::new();
        for cycle in 0..6 {
            for k in 0..(1.0 / h) as usize {
                let load = 0.4 * (1.0 - (std::f64::consts::TAU * (k as f64 + 0.5) * h).cos());
                v += h * (load - force);
                x += h * v;
                law.set("velocity", v);
                law.step(h);
                force = law.get("friction_force");
            }
            ends.push(x);
            assert!(cycle < 6);
        }
        let found = ends[5] - ends[4];
        assert!(abs_diff_eq!(found / drift, 1.0, epsilon = 0.03), "{model}: {found}");
    }
}

/// Linearly varying inputs, compared with a dense sequence of short held steps.
#[test]
fn ramped_inputs_agree_with_many_short_steps() {
    for model in ["LuGre", "Dahl", "BrownMcPhee", "CoulombStiction", "Karnopp"] {
        let mut ramp = Bench::new(model, &[("velocity", -2e-3)]);
        let (velocity, load) = (ramp.column("velocity"), ramp.column("normal_force"));
        ramp.step(0.01);
        let mut dense = Bench::new(model, &[("velocity", -2e-3)]);
        dense.step(0.01);
        for step in 0..200 {
            let time = 1e-4 * f64::from(step);
            ramp.set("velocity", -2e-3 + 0.5 * time);
            ramp.set("normal_force", 9.81 + 100.0 * time);
            ramp.instance.set_slope(velocity, 0.5).unwrap();
            ramp.instance.set_slope(load, 100.0).unwrap();
            ramp.step(1e-4);
        }
        let n = 200_000;
        for k in 0..n {
            let time = 0.02 * (f64::from(k) + 0.5) / f64::from(n);
            dense.set("velocity", -2e-3 + 0.5 * time);
            dense.set("normal_force", 9.81 + 100.0 * time);
            dense.step(0.02 / f64::from(n));
        }
        dense.set("velocity", -2e-3 + 0.5 * 0.02);
        dense.set("normal_force", 9.81 + 100.0 * 0.02);
        assert_abs_diff_eq!(ramp.get("velocity"), 8e-3, epsilon = 1e-15);
        for name in ["friction_force", "dissipated_energy"] {
            let (a, b) = (ramp.get(name), dense.get(name));
            assert!(abs_diff_eq!(a / b, 1.0, epsilon = 1e-6), "{model} {name}: {a} against {b}");
        }
    }
}

/// Exact derivatives, compared with formulas derived by hand.
#[test]
fn directional_derivatives_of_the_friction_force() {
    let slope = |bench: &mut Bench, with: &str| {
        let (force, with) = (bench.column("friction_force"), bench.column(with));
        bench.instance.derivative([(with, 1.0)].into_iter())[force].slope
    };
    let agree = |found: f64, by_hand: f64| {
        assert_abs_diff_eq!(found, by_hand, epsilon = 1e-12 * by_hand.abs());
    };

    for v in [-3e-3, -2e-4, 7e-4, 5e-2] {
        // LuGre: d/dv of sigma_0 z + sigma_1 (v - sigma_0 |v| z / g) + sigma_2 v.
        let z = 6e-6;
        let mut law = Bench::new("LuGre", &[("velocity", v), ("bristle_deflection", z)]);
        let g = level(v);
        let dg = -2.0 * v / (V_S * V_S) * (g - F_C);
        let by_hand = SIGMA_1 * (1.0 - SIGMA_0 * z * (v.signum() / g - v.abs() * dg / (g * g))) + SIGMA_2;
        agree(slope(&mut law, "velocity"), by_hand);
        agree(slope(&mut law, "bristle_deflection"), SIGMA_0 - SIGMA_1 * SIGMA_0 * v.abs() / g);
        agree(slope(&mut law, "normal_force"), SIGMA_1 * SIGMA_0 * v.abs() * z / (g * 9.81));

        // d/d delta of g: -(f_s - f_C) exp(-u^2) u^2 ln u, through the rate of z.
        let u = v.abs() / V_S;
        let dg = -(g - F_C) * u * u * u.ln();
        agree(slope(&mut law, "stribeck_exponent"), SIGMA_1 * SIGMA_0 * v.abs() * z / (g * g) * dg);

        // Brown-McPhee: the rational term u / b^2 with b = (u^2 + 3) / 4 has the derivative (b - u^2) / b^3.
        let (mut law, u) = (Bench::new("BrownMcPhee", &[("velocity", v)]), v / 1e-3);
        let b = (u * u + 3.0) / 4.0;
        let by_hand = (F_C * 4.0 / (4.0 * u).cosh().powi(2) + (F_S - F_C) * (b - u * u) / b.powi(3)) / 1e-3;
        let found = slope(&mut law, "velocity");
        // tanh' = 1 - tanh^2 loses digits where tanh is 1, so the scale of the sum is what counts.
        assert_abs_diff_eq!(found, by_hand, epsilon = 1e-12 * F_C * 4e3);
        agree(slope(&mut law, "viscous_coefficient"), v * (4.0f64 * 9.81).tanh());
    }

    let mut held = Bench::new("CoulombStiction", &[("mass", 2.0), ("external_force", 0.3)]);
    held.step(1e-3);
    agree(slope(&mut held, "velocity"), 2.0 / 1e-3);
    agree(slope(&mut held, "external_force"), 1.0);
    let mut sliding = Bench::new("CoulombStiction", &[("velocity", -0.3)]);
    agree(slope(&mut sliding, "normal_force"), -0.1);
}
