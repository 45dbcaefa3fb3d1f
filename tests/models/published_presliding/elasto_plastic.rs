//! The elasto-plastic law.

use super::{
    F_C, F_S, Row, SIGMA_0, after, assert_bounded_at_coarse_steps, assert_close, assert_closed_cycles_dissipate,
    assert_identical, assert_passive, velocity,
};
use crate::common::Bench;
use crate::common::random::Random;

/// g(v) of Table 7.1, and its force in steady sliding.
fn stribeck(velocity: f64) -> f64 {
    F_C + (F_S - F_C) * (-(velocity / 1e-3).powi(2)).exp()
}

/// Constant velocity from rest, integrated independently (9 digits): velocity, time, force, deflection.
#[test]
fn elasto_plastic_from_rest() {
    let rows = [
        (1e-4, 0.05, 0.531632777, 5e-6),
        (1e-4, 0.10, 1.03163278, 1e-5),
        (1e-4, 0.15, 1.3414317, 1.33242327e-5),
        (1e-4, 1.00, 1.46651202, 1.46649942e-5),
        (1e-3, 0.01, 1.17365673, 9.73517172e-6),
        (1e-2, 1e-3, 1.8055545, 8.90283669e-6),
        (1e-2, 5e-3, 0.983027338, 9.80546305e-6),
    ];
    for (velocity, time, force, deflection) in rows {
        for pieces in [1, 13, 500] {
            let mut bench = Bench::new("ElastoPlastic", &[("velocity", velocity)]);
            for _ in 0..pieces {
                bench.step(time / f64::from(pieces));
            }
            assert_close("force", bench.get("friction_force"), force, 5e-9);
            assert_close("deflection", bench.get("bristle_deflection"), deflection, 5e-9);
        }
    }
}

#[test]
fn elasto_plastic_steady_force_is_that_of_lugre() {
    for velocity in [1e-4, 5e-4, 1e-3, 2e-3, 0.1] {
        let expected = stribeck(velocity) + 0.1 * velocity;
        for model in ["ElastoPlastic", "LuGre"] {
            assert_close(model, after(model, &[], -velocity, 10.0).get("friction_force"), -expected, 1e-12);
        }
    }
}

/// Where the level is exceeded (|z| >= z_ss) alpha is 1, and the law is that of LuGre.
#[test]
fn elasto_plastic_with_alpha_1_is_lugre() {
    let start = [("bristle_deflection", 2e-5)];
    let mut benches = [Bench::new("ElastoPlastic", &start), Bench::new("LuGre", &start)];
    for velocity in [1e-6, 2e-4, 6e-4, 1e-3, 3e-3, 0.5] {
        for _ in 0..20 {
            let [a, b] = benches.each_mut().map(|bench| {
                bench.set("velocity", velocity);
                bench.step(1e-7 / velocity);
                [bench.get("friction_force"), bench.get("dissipated_energy"), bench.get("bristle_deflection")]
            });
            assert!(a.into_iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * b.abs()), "{a:?} {b:?}");
        }
    }
}

/// z_ba = z_ss and no damping: elastic and perfectly plastic, as Dahl's law with alpha = 0 and the reset integrator.
#[test]
fn elasto_plastic_without_transition_is_brittle_dahl() {
    let values = [("breakaway_ratio", 1.0), ("mu_s", 0.1), ("sigma_1", 0.0), ("viscous_coefficient", 0.0)];
    assert_identical(("ElastoPlastic", &values), ("Dahl", &[("alpha", 0.0)]), 1e-12);
    assert_identical(("ElastoPlastic", &values), ("ResetIntegrator", &[("mu_s", 0.1), ("sigma_1", 0.0)]), 1e-12);
}

/// Creep of 1 kg under a load that pulsates between 0 and 0.8 N at 1 Hz, in metres per cycle.
fn drift(model: &str, values: &[(&str, f64)]) -> f64 {
    let (mut law, h) = (Bench::new(model, values), 2e-5);
    let (mut x, mut v, mut force) = (0.0, 0.0, 0.0);
    let mut ends = Vec::new();
    for _ in 0..6 {
        for k in 0..50_000 {
            let load = 0.4 * (1.0 - (std::f64::consts::TAU * (f64::from(k) + 0.5) * h).cos());
            v += h * (load - force);
            x += h * v;
            law.set("velocity", v);
            law.step(h);
            force = law.get("friction_force");
        }
        ends.push(x);
    }
    ends[5] - ends[4]
}

/// No drift while the load stays below sigma_0 z_ba = 1.030 N, where LuGre creeps by 5.16e-6 m per cycle.
#[test]
fn elasto_plastic_does_not_drift_below_breakaway() {
    let [elasto_plastic, lugre] = ["ElastoPlastic", "LuGre"].map(|model| drift(model, &[]));
    assert!(elasto_plastic.abs() < 1e-14, "{elasto_plastic}");
    assert_close("LuGre", lugre, 5.16e-6, 0.03);
}

/// With z_ba = 0.7 f_C / sigma_0 the load exceeds sigma_0 z_ba = 0.687 N: 1.03e-8 m per cycle.
#[test]
fn elasto_plastic_drifts_above_breakaway() {
    assert_close("drift", drift("ElastoPlastic", &[("breakaway_ratio", 0.7 * F_C / F_S)]), 1.03e-8, 0.03);
}

/// The closed system with z' = v (1 - alpha sgn(v) z / z_ss), as a whole; with alpha = 1 it gives the reference
/// solution of LuGre (LSODA at 1e-10 and Radau at 1e-8 agree), which checks the integration.
#[test]
fn elasto_plastic_on_the_belt() {
    let closed = |alpha: fn(f64) -> f64| {
        Row::integrated(move |v, [z]: &[f64; 1]| {
            let u = z * v.signum() * SIGMA_0 / stribeck(v);
            let rate = v * (1.0 - alpha(u) * u);
            (SIGMA_0 * z + SIGMA_0.sqrt() * rate + 0.1 * v, [rate])
        })
    };
    let lugre = Row {
        first_maximum: (7.502448, 0.739936),
        first_minimum: 0.276776,
        last_period: 7.073670,
        end: 0.463150,
        maxima: 5,
    };
    closed(|_| 1.0).assert_close("LuGre", &lugre, 3e-6);
    let expected = closed(|u| match u {
        u if u <= 0.7 => 0.0,
        u if u < 1.0 => 0.5 + 0.5 * (std::f64::consts::PI * (u - 0.85) / 0.3).sin(),
        _ => 1.0,
    });
    Row::simulated("ElastoPlastic", &[]).assert_close("co-simulation", &expected, 1e-2);
    assert_bounded_at_coarse_steps("ElastoPlastic", &[], |_| 1.3 * F_S);
}

/// Passive without stiction, without damping of the bristles, and with sigma_2 >= sigma_1 (f_s / f_C - 1)^i.
#[test]
fn elasto_plastic_is_passive_under_its_condition() {
    let sets: [&[(&str, f64)]; 5] = [
        &[("mu_s", 0.1)],
        &[("sigma_1", 0.0)],
        &[("viscous_coefficient", 158.2)],
        &[("viscous_coefficient", 39.6), ("plastic_exponent", 3.0)],
        &[("mu_s", 0.1), ("plastic_exponent", 3.0), ("breakaway_ratio", 0.2)],
    ];
    for values in sets {
        assert_passive("ElastoPlastic", values);
        assert_closed_cycles_dissipate("ElastoPlastic", values);
    }
}

/// With the values of the thesis it is not passive: the power of the bristles' damping falls to at least -sigma_1 (f_s
/// / f_C - 1)^i v^2, and a jump out of full stiction comes close to that.
#[test]
fn elasto_plastic_violates_passivity_within_the_stated_bound() {
    for (exponent, share) in [(1.0, 0.5), (3.0, 0.125)] {
        let mut random = Random(37);
        let mut worst: f64 = 0.0;
        for _ in 0..200 {
            let mut bench = Bench::new("ElastoPlastic", &[("plastic_exponent", exponent)]);
            // Up to full stiction, slowly; then a jump.
            bench.set("velocity", 1e-5);
            bench.step(1e4);
            for _ in 0..10 {
                let velocity = velocity(&mut random);
                bench.set("velocity", velocity);
                let stored = SIGMA_0 * bench.get("bristle_deflection") * velocity;
                // The springs return stored energy; only more than that is a violation.
                let power = bench.get("dissipated_power") - stored.min(0.0);
                let bound = SIGMA_0.sqrt() * share * velocity * velocity;
                assert!(power >= -bound, "{exponent}: {power} W at {velocity} m/s");
                worst = worst.min(power / bound);
                bench.step(10f64.powf(-5.0 + 4.0 * random.next()));
            }
        }
        assert!(worst < -0.85, "{exponent}: {worst}");
    }
}
