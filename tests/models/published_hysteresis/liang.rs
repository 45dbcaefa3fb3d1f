//! Liang's law, in space.

use super::{F_C, F_S, SIGMA_0, SIGMA_1, assert_passive_in_a_plane, assert_planar_belt, euler_belt};
use crate::common::Bench;
use crate::common::random::Random;
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// From rest at constant velocity, in a direction of the tangent plane (9 digits).
#[test]
fn liang_from_rest() {
    let rows = [
        (1e-4, 0.05, 0.531622777),
        (1e-4, 0.10, 1.03162278),
        (1e-4, 0.15, 1.4715),
        (1e-4, 1.0, 1.4715),
        (1e-3, 0.01, 1.31622777),
        (1e-2, 1e-3, 0.981),
        (1e-2, 5e-3, 0.981),
    ];
    for variant in [1.0, 2.0] {
        for (velocity, time, force) in rows {
            let mut law = Bench::new("Liang", &[("variant", variant)]);
            // 0.001 m/s is the limit of the static level, so it must not be rounded up.
            let direction = if velocity == 1e-3 { [1.0, 0.0] } else { [0.6, -0.8] };
            law.set("velocity_x", direction[0] * velocity);
            law.set("velocity_y", direction[1] * velocity);
            law.step(time);
            for (name, share) in [("friction_force_x", direction[0]), ("friction_force_y", direction[1])] {
                let found = law.get(name);
                assert!(
                    abs_diff_eq!(found, share * force, epsilon = 6e-9 * force),
                    "{velocity} {time} {name}: {found}"
                );
            }
        }
    }
}

/// Rotating all inputs rotates the force.
#[test]
fn liang_is_invariant_under_rotation() {
    let (angle, axis) = (0.7f64, [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]);
    let rotate = |v: [f64; 3]| -> [f64; 3] {
        let dot: f64 = (0..3).map(|i| axis[i] * v[i]).sum();
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            v[i] * angle.cos() + (axis[j] * v[k] - axis[k] * v[j]) * angle.sin() + axis[i] * dot * (1.0 - angle.cos())
        })
    };
    for variant in [1.0, 2.0] {
        let mut random = Random(31);
        let mut benches = [(); 2].map(|()| Bench::new("Liang", &[("variant", variant)]));
        for _ in 0..3000 {
            let scale = 10f64.powf(-5.0 * random.next());
            let velocity = [(); 3].map(|()| scale * random.signed());
            let normal = [0.3 * random.signed(), 0.3 * random.signed(), 1.0];
            let h = 1e-2 * random.next();
            let inputs = [(velocity, normal), (rotate(velocity), rotate(normal))];
            for (bench, (velocity, normal)) in benches.iter_mut().zip(inputs) {
                for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
                    bench.set(&format!("velocity_{axis}"), velocity[i]);
                    bench.set(&format!("normal_{axis}"), normal[i]);
                }
                bench.step(h);
            }
            let [plain, rotated] = benches
                .each_mut()
                .map(|bench| ["friction_force_x", "friction_force_y", "friction_force_z"].map(|name| bench.get(name)));
            let size = 1.0 + scale * SIGMA_1;
            for (a, b) in rotate(plain).into_iter().zip(rotated) {
                assert!(abs_diff_eq!(a, b, epsilon = 1e-9 * size), "{variant}: {a} against {b} at {scale}");
            }
        }
    }
}

/// Along a line: the reset integrator with a = 0 and a limit that switches with the speed; z is a clamped integral.
#[test]
fn liang_along_a_line_is_a_clamped_integral() {
    let mut random = Random(37);
    let mut law = Bench::new("Liang", &[("sigma_1", 0.0)]);
    let mut z = 0.0f64;
    for _ in 0..3000 {
        let (v, h) = (10f64.powf(-4.0 * random.next()) * random.signed(), 1e-2 * random.next());
        let limit = if v.abs() > 1e-3 { F_C } else { F_S } / SIGMA_0;
        z = (z.clamp(-limit, limit) + v * h).clamp(-limit, limit);
        law.set("velocity_y", v);
        law.step(h);
        assert!(abs_diff_eq!(law.get("friction_force_y"), SIGMA_0 * z, epsilon = 1e-12), "{v}");
    }
}

/// Identity: along a line with equal levels, without damping, Dahl's law with alpha = 0, energy included.
#[test]
fn liang_with_equal_levels_is_elastic_and_perfectly_plastic() {
    for variant in [1.0, 2.0] {
        let mut law = Bench::new("Liang", &[("mu_s", 0.1), ("sigma_1", 0.0), ("variant", variant)]);
        let mut dahl = Bench::new("Dahl", &[("alpha", 0.0)]);
        let mut random = Random(41);
        for _ in 0..2000 {
            let v = 1e-2 * random.signed();
            law.set("velocity_x", v);
            dahl.set("velocity", v);
            law.step(2e-3);
            dahl.step(2e-3);
            assert_abs_diff_eq!(law.get("friction_force_x"), dahl.get("friction_force"), epsilon = 1e-12);
        }
        assert_abs_diff_eq!(law.get("dissipated_energy") / dahl.get("dissipated_energy"), 1.0, epsilon = 1e-12);
    }
}

#[test]
fn liang_is_passive() {
    for (variant, sigma_1) in [(1.0, 0.0), (1.0, SIGMA_1), (2.0, 0.0), (2.0, SIGMA_1)] {
        assert_passive_in_a_plane("Liang", &[("variant", variant), ("sigma_1", sigma_1)], 1e-2);
    }
}

/// The benchmark against the printed equations integrated together by Euler's method.
#[test]
fn liang_on_the_belt() {
    let mut z = 0.0f64;
    let expected = euler_belt(|v, h| {
        let limit = if v.abs() > 1e-3 { F_C } else { F_S } / SIGMA_0;
        let free = z + h * v;
        let slides = free.abs() > limit;
        z = if slides { limit * v.signum() } else { free };
        SIGMA_0 * z + if slides { 0.0 } else { SIGMA_1 * v }
    });
    // The damping acts while the bristle moves from one limit to the other, for at least one step.
    assert_planar_belt("Liang", expected, |h| F_S + SIGMA_1 * 2.0 * F_S / SIGMA_0 / h);
}
