//! The strut against the printed numbers of its law: golden points, worked example, golden traces.

use crate::common::Bench;
use crate::{NONE, TABLE, force, golden_trace, law, strut};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use stribeck::friction::LuGre;
use stribeck::model::{Law, Model};

#[test]
fn golden_points_without_friction() {
    let points = [
        (0.2000, 0.0, 288.3403, 288.3403),
        (0.1775, 0.0, 1325.2555, 1325.2555),
        (0.1775, 0.2, 865.2555, 785.2555),
        (0.1775, -0.2, 1625.2555, 1681.9222),
        (0.1520, -0.1, 3860.5289, 3920.5289),
        (0.1450, 0.0, 5088.5714, 5088.5714),
        (0.2010, 0.0, -757.6023, -757.6023),
    ];
    let (mut linear, mut table) = (strut(&[NONE]), strut(&[NONE, TABLE]));
    for (length, velocity, with_linear, with_table) in points {
        let got = [force(&mut linear, length, velocity), force(&mut table, length, velocity)];
        assert!(abs_diff_eq!(got[0], with_linear, epsilon = 5.1e-5), "{length} {velocity}: {got:?}");
        assert!(abs_diff_eq!(got[1], with_table, epsilon = 5.1e-5), "{length} {velocity}: {got:?}");
    }
    let mut progressive = strut(&[NONE, ("bump.mode", 2.0)]);
    force(&mut progressive, 0.152, 0.0);
    assert_abs_diff_eq!(progressive.get("force_bump"), 918.0984, epsilon = 5.1e-5);
}

/// R = (80, -30) N, M = (2, 6) N.m at a length of 180 mm, Coulomb friction, no regularisation, no offset of the spring.
#[test]
fn worked_example_of_sliding_friction() {
    let mut strut = strut(&[law("Coulomb"), ("geom.h_reg", 0.0), ("side.offset_m", 0.0), ("length", 0.18)]);
    for (input, value) in
        [("side_force_m", 80.0), ("side_force_n", -30.0), ("side_moment_m", 2.0), ("side_moment_n", 6.0)]
    {
        strut.set(input, value);
    }
    let friction = |strut: &mut Bench| strut.get("friction_1") + strut.get("friction_2");
    strut.set("velocity", 0.2);
    assert!((strut.get("normal_1") - 5.0).abs() < 1e-6 && (strut.get("normal_2") - 87.321246).abs() < 1e-6);
    assert_abs_diff_eq!(friction(&mut strut), 21.485700, epsilon = 1e-6);
    strut.set("spin_rate", 3.0);
    assert_abs_diff_eq!(friction(&mut strut), 21.216811, epsilon = 1e-6);
    assert_abs_diff_eq!(strut.get("friction_torque"), 0.036127, epsilon = 1e-6);
    strut.set("spin_rate", 0.0);
    strut.set("velocity", -0.2);
    assert_abs_diff_eq!(friction(&mut strut), -21.485700, epsilon = 1e-6);
}

const TRACE: [(usize, [f64; 5]); 5] = [
    (0, [70.294625, 34.726770, 15.044542, 8.793221, 859.824878]),
    (10, [66.088897, 37.067987, 14.570122, 9.000644, 792.940535]),
    (125, [30.368135, 68.080712, 11.079758, 11.409332, 748.929674]),
    (250, [70.294625, 34.726770, -15.096360, -8.776724, 1633.630076]),
    (500, [70.294625, 34.726770, 14.993054, 8.809113, 859.860475]),
];

#[test]
fn golden_trace_to_a_micronewton() {
    let mut seen = 0;
    let work = golden_trace(&[], |k, strut| {
        if let Some((_, expected)) = TRACE.iter().find(|(at, _)| *at == k) {
            let names = ["normal_1", "normal_2", "friction_1", "friction_2", "force"];
            for (name, expected) in names.iter().zip(expected) {
                let got = strut.get(name);
                assert!(abs_diff_eq!(got, expected, epsilon = 1e-6), "k = {k}: {name} = {got}, expected {expected}");
            }
            seen += 1;
        }
    });
    assert_eq!(seen, TRACE.len());
    assert_abs_diff_eq!(work, 1.150427, epsilon = 1e-6);
}

/// Held inputs: the internal steps compose exactly.
#[test]
fn trace_does_not_depend_on_the_internal_step() {
    let forces = |h_max: f64| {
        let mut forces = Vec::new();
        golden_trace(&[("num.h_max", h_max)], |_, strut| forces.push(strut.get("force")));
        forces
    };
    let reference = forces(1e-3);
    for h_max in [1e-4, 3e-4, 1e-5] {
        let worst = forces(h_max).iter().zip(&reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9, "{h_max}: {worst}");
    }
}

/// F_C = 20 N, F_S = 30 N, parameters of the thesis, 1 ms, v_k = 0.01 sin(2 pi k / 23): the law by itself, and the same
/// law inside the strut.
#[test]
fn golden_lugre_trace() {
    let expected = [
        (1, 1.10999993),
        (2, 2.35400725),
        (5, 5.73064391),
        (10, 6.90855681),
        (20, -3.32047907),
        (30, 5.74107226),
        (40, -2.81243747),
    ];
    let mut law = LuGre { normal_force: 200.0, ..LuGre::default() };
    let one_contact = [
        ("c1.mu_s", 0.0),
        ("c1.mu_k", 0.0),
        ("c1.preload_s", 30.0),
        ("c1.preload_k", 20.0),
        ("c2.mu_s", 0.0),
        ("c2.mu_k", 0.0),
        ("c2.preload_s", 0.0),
        ("c2.preload_k", 0.0),
        ("init.friction_state", 2.0),
    ];
    let mut strut = strut(&one_contact);
    for k in 0..=40 {
        let velocity = 0.01 * (2.0 * std::f64::consts::PI * f64::from(k) / 23.0).sin();
        law.velocity = velocity;
        law.step(1e-3);
        law.output();
        strut.set("velocity", velocity);
        strut.step(1e-3);
        if let Some((_, expected)) = expected.iter().find(|(at, _)| *at == k) {
            assert!(abs_diff_eq!(law.friction_force, expected, epsilon = 1e-8), "{k}: {}", law.friction_force);
            let got = strut.get("friction_1");
            assert!(abs_diff_eq!(got, expected, epsilon = 1e-8), "{k}: {got}");
        }
    }
    assert_abs_diff_eq!(law.bristle_deflection, 4.0779333550e-6, epsilon = 1e-15);
}
