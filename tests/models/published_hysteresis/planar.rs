//! LuGre's and the elasto-plastic law in a plane, and ramped inputs of every law in a plane.

use super::{
    F_C, F_S, SIGMA_0, SIGMA_1, SIGMA_2, assert_passive_in_a_plane, assert_planar_belt, assert_ramp, euler_belt, level,
};
use crate::common::Bench;
use crate::common::random::Random;
use approx::abs_diff_eq;

const PLANAR: [&str; 2] = ["LuGrePlanar", "ElastoPlasticPlanar"];

/// Force and deflection of the scalar laws from rest at constant velocity, integrated independently (9 digits); in the
/// plane in a direction of Pythagoras' triangle 8, 15, 17.
#[test]
fn planar_laws_from_rest_along_a_line() {
    let rows = [
        (1e-4, 0.05, [(0.446180717, 4.23683262e-6), (0.531632777, 5e-6)]),
        (1e-4, 0.10, [(0.740972285, 7.24971102e-6), (1.03163278, 1e-5)]),
        (1e-4, 0.15, [(0.950603211, 9.39221629e-6), (1.3414317, 1.33242327e-5)]),
        (1e-4, 1.00, [(1.46506032, 1.46501574e-5), (1.46651202, 1.46649942e-5)]),
        (1e-3, 0.01, [(0.804237283, 6.70454968e-6), (1.17365673, 9.73517172e-6)]),
        (1e-2, 1e-3, [(1.76905496, 6.27032724e-6), (1.8055545, 8.90283669e-6)]),
        (1e-2, 5e-3, [(0.995340788, 9.75000162e-6), (0.983027338, 9.80546305e-6)]),
    ];
    for (velocity, time, values) in rows {
        for (model, (force, deflection)) in PLANAR.into_iter().zip(values) {
            let shares = [("x", -8.0 / 17.0), ("y", 15.0 / 17.0)];
            let mut law = Bench::new(model, &[]);
            for (axis, share) in shares {
                law.set(&format!("velocity_{axis}"), share * velocity);
            }
            law.step(time);
            for (axis, share) in shares {
                let found = law.get(&format!("friction_force_{axis}")) / share;
                assert!(abs_diff_eq!(found / force, 1.0, epsilon = 6e-9), "{model} {velocity} {time}: {found}");
                let found = law.get(&format!("bristle_deflection_{axis}")) / share;
                assert!(abs_diff_eq!(found / deflection, 1.0, epsilon = 6e-9), "{model} {velocity} {time}: {found}");
            }
        }
    }
}

/// Steady sliding: (g(|v|) + sigma_2 |v|) v / |v|, whatever the history.
#[test]
fn planar_laws_steady_force() {
    for model in PLANAR {
        let mut law = Bench::new(model, &[]);
        for (speed, angle) in [(1e-4, 0.3), (1e-3, 2.0), (0.1, 4.4), (5e-4, 5.0), (2e-3, 1.8)] {
            let [x, y] = [f64::cos(angle), f64::sin(angle)];
            law.set("velocity_x", speed * x);
            law.set("velocity_y", speed * y);
            law.step(10.0);
            let expected = level(speed) + SIGMA_2 * speed;
            let (found_x, found_y) = (law.get("friction_force_x"), law.get("friction_force_y"));
            assert!(
                (found_x - expected * x).abs() < 1e-11 && (found_y - expected * y).abs() < 1e-11,
                "{model} {speed}"
            );
        }
    }
}

/// Rotating the inputs rotates the force.
#[test]
fn planar_laws_are_isotropic() {
    let (sin, cos) = 0.9f64.sin_cos();
    for model in PLANAR {
        let mut random = Random(47);
        let [mut plain, mut rotated] = [(); 2].map(|()| Bench::new(model, &[]));
        for _ in 0..1000 {
            let scale = 10f64.powf(-4.0 * random.next());
            let (x, y, h) = (scale * random.signed(), scale * random.signed(), 1e-2 * random.next());
            for (bench, [x, y]) in [(&mut plain, [x, y]), (&mut rotated, [cos * x - sin * y, sin * x + cos * y])] {
                bench.set("velocity_x", x);
                bench.set("velocity_y", y);
                bench.step(h);
            }
            let [a, b] =
                [&mut plain, &mut rotated].map(|bench| [bench.get("friction_force_x"), bench.get("friction_force_y")]);
            let size = 1.0 + SIGMA_1 * scale;
            let turned = [cos * a[0] - sin * a[1], sin * a[0] + cos * a[1]];
            assert!((turned[0] - b[0]).abs().max((turned[1] - b[1]).abs()) < 1e-10 * size, "{model}: {turned:?} {b:?}");
        }
    }
}

#[test]
fn laws_in_a_plane_with_ramped_inputs() {
    for model in ["Liang", "LuGrePlanar", "ElastoPlasticPlanar"] {
        assert_ramp(model, &[("velocity_y", 3e-4)], 100, 1e-5);
    }
}

#[test]
fn planar_laws_without_damping_are_passive() {
    for model in PLANAR {
        assert_passive_in_a_plane(model, &[("sigma_1", 0.0), ("viscous_coefficient", 0.0)], 1e-2);
    }
}

/// A jump from full stiction to a high speed returns power above sigma_1 = sigma_2 f_C / (f_s - f_C), not below.
#[test]
fn planar_laws_are_active_above_the_stated_bound() {
    let bound = SIGMA_2 * F_C / (F_S - F_C);
    for model in PLANAR {
        for (factor, active) in [(0.99, false), (1.2, true)] {
            let mut law = Bench::new(model, &[("sigma_1", factor * bound), ("velocity_x", 1e-9)]);
            law.step(1e6);
            let mut lowest = f64::MAX;
            for k in 1..10_000 {
                law.set("velocity_x", f64::from(k));
                lowest = lowest.min(law.get("dissipated_power"));
            }
            assert_eq!(lowest < 0.0, active, "{model} {factor}: {lowest} W");
        }
    }
}

#[test]
fn planar_laws_on_the_belt() {
    let mut z = 0.0f64;
    let lugre = euler_belt(|v, h| {
        let rate = v - SIGMA_0 * v.abs() * z / level(v);
        z += h * rate;
        SIGMA_0 * z + SIGMA_1 * rate + SIGMA_2 * v
    });
    // Integrated independently: Radau at 1e-8 and LSODA at 1e-10 agree.
    for (found, expected) in lugre.into_iter().zip([7.502448, 0.739936, 0.276776]) {
        assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 1e-4), "{found} {expected}");
    }
    assert_planar_belt("LuGrePlanar", lugre, |_| 1.3 * F_S);
    let mut z = 0.0f64;
    let elasto_plastic = euler_belt(|v, h| {
        let z_ss = level(v) / SIGMA_0;
        let share = ((z.abs() / z_ss - 0.7) / 0.3).clamp(0.0, 1.0);
        let alpha = if v * z > 0.0 { 0.5 - 0.5 * (std::f64::consts::PI * share).cos() } else { 0.0 };
        let rate = v * (1.0 - alpha * v.signum() * z / z_ss);
        z += h * rate;
        SIGMA_0 * z + SIGMA_1 * rate + SIGMA_2 * v
    });
    assert_planar_belt("ElastoPlasticPlanar", elasto_plastic, |_| 1.3 * F_S);
}
