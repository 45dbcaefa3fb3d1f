//! Specker's dynamic law.

use super::{F_C, F_S, Row, after, assert_bounded_at_coarse_steps, assert_close, velocity};
use crate::common::Bench;
use crate::common::random::Random;

/// Steady force of the dynamic law: the static curve of Specker at its default parameters (v_0 = v_S / 4,
/// v_Sp = v_S / 2).
#[test]
fn dynamic_specker_settles_on_the_static_curve() {
    let points = [
        (-3e-4, -1.2522623),
        (1e-5, 0.0565532065),
        (2e-4, 0.971512295),
        (5e-4, 1.4715),
        (7.5e-4, 1.39830053),
        (1e-3, 1.21498079),
        (1.25e-3, 1.07613099),
        (2e-3, 0.982163002),
        (1e-2, 0.981),
    ];
    for (velocity, force) in points {
        assert_close("steady", after("SpeckerDynamic", &[], velocity, 10.0).get("friction_force"), force, 1e-8);
        // Without lag the curve is reached at once.
        let instant = [("sigma_0", 1e15), ("slip_time", 1e-12)];
        assert_close("instant", after("SpeckerDynamic", &instant, velocity, 1e-6).get("friction_force"), force, 1e-8);
    }
}

/// A low-pass filter never exceeds its input: the maximum of the curve, 1.0043723 f_s.
#[test]
fn dynamic_specker_never_exceeds_the_maximum_of_its_curve() {
    let mut bench = Bench::new("SpeckerDynamic", &[]);
    let (mut random, mut highest) = (Random(43), 0.0f64);
    for _ in 0..100_000 {
        bench.set("velocity", velocity(&mut random));
        bench.step(10f64.powf(-5.0 + 4.0 * random.next()));
        highest = highest.max(bench.get("friction_force").abs());
    }
    assert!((1.0..=1.0043724).contains(&(highest / F_S)), "{highest}");
}

/// It is not passive: a closed cycle that reverses fast from f_s, returns as fast, and recovers slowly, gains energy.
/// At 1 m/s and T_slip = 1 ms the two fast legs give V T_slip (f_s - f_C L) - V T_slip f_C (L - f_s / (f_s + f_C)) with
/// L = ln(1 + f_s / f_C), 2.62e-4 J; the recovery over 50 um costs less than f_s times that, 0.74e-4 J.
#[test]
fn dynamic_specker_gains_energy_in_a_closed_cycle() {
    let mut bench = after("SpeckerDynamic", &[], 5e-4, 10.0);
    let log = (1.0 + F_S / F_C).ln();
    let (back, slow) = (1e-3 * log, 0.1);
    let fast = 1e-3 * (F_S - F_C * log) - 1e-3 * F_C * (log - F_S / (F_S + F_C));
    for _ in 0..5 {
        let before = bench.get("dissipated_energy");
        // 50 um of the return are those of the slow leg.
        for (velocity, time) in [(-1.0, back + 5e-4 * slow), (1.0, back), (5e-4, slow)] {
            bench.set("velocity", velocity);
            bench.step(time);
        }
        let gained = before - bench.get("dissipated_energy");
        assert!(gained > 0.0 && gained < fast, "{gained} of {fast}");
    }
}

/// The closed system as a whole, with f_stat and T(v) as in their equations.
#[test]
fn dynamic_specker_on_the_belt() {
    let expected = Row::integrated(|v, [f]| {
        let (u, missing) = (v / 5e-4, F_S - F_C * 2f64.tanh());
        let stationary = F_C * (v / 2.5e-4).tanh() + missing * u * (0.5 * (1.0 - u * u)).exp();
        let time = 1e-3 + (0.056577588 - 1e-3) * (-u * u).exp();
        (*f, [(stationary - f) / time])
    });
    Row::simulated("SpeckerDynamic", &[]).assert_close("co-simulation", &expected, 1e-2);
    assert_bounded_at_coarse_steps("SpeckerDynamic", &[], |_| 1.0043724 * F_S);
}
