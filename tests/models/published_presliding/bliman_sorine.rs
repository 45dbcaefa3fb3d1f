//! Bliman and Sorine's law of first and second order.

use super::{
    BLIMAN_SORINE_SECOND, DAHL, DAHL_ROW, F_C, F_S, FIRST_ORDER, Row, SIGMA_0, after, assert_bounded_at_coarse_steps,
    assert_close, assert_closed_cycles_dissipate, assert_identical, assert_passive,
};
use crate::common::Bench;
use crate::common::random::Random;
use approx::{abs_diff_eq, assert_abs_diff_eq};

#[test]
fn bliman_sorine_from_rest() {
    for ((velocity, time, second), first) in BLIMAN_SORINE_SECOND.into_iter().zip(DAHL) {
        let found = after("BlimanSorine", &[], velocity, time).get("friction_force");
        assert_close("second order", found, second, 5e-9);
        let found = after("BlimanSorine", FIRST_ORDER, velocity, time).get("friction_force");
        assert_close("first order", found, first, 2e-9);
        let mirrored = after("BlimanSorine", &[], -velocity, time).get("friction_force");
        assert_close("mirrored", mirrored, -second, 5e-9);
    }
}

/// Calibrations to f_C = 0.981 N, f_peak = 1.4715 N and the initial stiffness 1e5 N/m: eta, f_2, eps_f. The peak is at
/// s_p = eta eps_f / (1 - eta) ln(f_1 / (eta f_2)); checked by a fine search of the maximum.
#[test]
fn bliman_sorine_has_the_calibrated_peak() {
    for (eta, f_2, eps_f) in
        [(0.5, 2.68014184, 4.64214184e-5), (0.2, 1.07784955, 9.21639818e-5), (0.1, 0.77110378, 1.67499341e-4)]
    {
        let values = [("eta", eta), ("mu_2", f_2 / 9.81), ("eps_f", eps_f)];
        let force = |distance: f64| after("BlimanSorine", &values, distance, 1.0).get("friction_force");
        let f_1 = F_C + f_2;
        let s_p = eta * eps_f / (1.0 - eta) * f64::ln(f_1 / (eta * f_2));
        let peak = f_1 - f_2 + (1.0 - eta) * f_2 * f64::powf(eta * f_2 / f_1, eta / (1.0 - eta));
        assert!(abs_diff_eq!(peak, F_S, epsilon = 2e-8), "{eta}: {peak}");
        assert!(abs_diff_eq!(force(s_p), peak, epsilon = 1e-12), "{eta}: {}", force(s_p));
        let scanned: Vec<f64> = (0..=2000).map(|k| force(s_p * (0.5 + f64::from(k) / 2000.0))).collect();
        let highest = scanned.iter().copied().fold(0.0, f64::max);
        assert_eq!(highest, scanned[1000], "{eta}");
        assert_close("initial stiffness", force(1e-12) / 1e-12, SIGMA_0, 1e-6);
        // Later it falls to f_C.
        assert_abs_diff_eq!(force(1e-2), F_C, epsilon = 1e-15);
    }
}

/// The defaults are the first of these calibrations, to all digits: the peak is f_s, and the preset's with eta = 0.1
/// too.
#[test]
fn bliman_sorine_defaults_and_presets_peak_at_the_static_level() {
    for (preset, s_p) in [(None, 4.665596443730539e-5), (Some("sharp_peak"), 5.8128498928797e-5)] {
        let mut bench = Bench::new("BlimanSorine", &[("velocity", s_p)]);
        assert!(preset.is_none_or(|preset| bench.instance.apply(preset)));
        bench.step(1.0);
        assert_abs_diff_eq!(bench.get("friction_force"), F_S, epsilon = 1e-14);
    }
}

/// For any division of a slide into steps: x_j = x_ss (1 - exp(-s / eps_j)).
#[test]
fn bliman_sorine_does_not_depend_on_the_steps() {
    let (f_1, f_2, eps) = (3.661_141_842_225_069, 2.680_141_842_225_069, 4.642_141_842_225_068e-5);
    let force = f_1 * (1.0 - f64::exp(-3e-5 / (0.5 * eps))) - f_2 * (1.0 - f64::exp(-3e-5 / eps));
    for pieces in [1, 7, 1000] {
        let mut bench = Bench::new("BlimanSorine", &[("velocity", 3e-4)]);
        for _ in 0..pieces {
            bench.step(0.1 / f64::from(pieces));
        }
        assert_close("force", bench.get("friction_force"), force, 1e-12);
    }
}

/// f_f' = (f_1 / eps_f) (v - |v| f_f / f_1) is Dahl's law with sigma_0 = f_1 / eps_f.
#[test]
fn bliman_sorine_of_first_order_is_dahl() {
    assert_identical(("BlimanSorine", FIRST_ORDER), ("Dahl", &[]), 1e-12);
}

#[test]
fn bliman_sorine_is_rate_independent() {
    let path = [3e-6, -5e-6, 4e-5, -1e-5, -8e-5];
    let run = |rate: f64| {
        let mut bench = Bench::new("BlimanSorine", &[]);
        for leg in path {
            bench.set("velocity", rate * leg);
            bench.step(1.0 / rate);
        }
        [bench.get("friction_force"), bench.get("dissipated_energy")]
    };
    for rate in [1e-3, 1.0, 1e5] {
        for (a, b) in run(rate).into_iter().zip(run(10.0)) {
            assert_close("force or energy", a, b, 1e-12);
        }
    }
}

#[test]
fn bliman_sorine_of_first_order_on_the_belt() {
    Row::simulated("BlimanSorine", FIRST_ORDER).assert_close("co-simulation", &DAHL_ROW, 1e-2);
    assert_bounded_at_coarse_steps("BlimanSorine", FIRST_ORDER, |_| F_C + 1e-12);
}

/// The second order against the closed system in the states of the paper, x_1 and x_2. After the first slip the path
/// never starts anew, and the oscillation is that of Coulomb friction, with the period 2 pi / w.
#[test]
fn bliman_sorine_of_second_order_has_one_stick_slip_cycle_on_the_belt() {
    let (f_1, f_2, eta, eps) = (3.66114184, 2.68014184, 0.5, 4.64214184e-5);
    let expected = Row::integrated(|v, [x_1, x_2]| {
        (x_1 + x_2, [(f_1 * v - v.abs() * x_1) / (eta * eps), (-f_2 * v - v.abs() * x_2) / eps])
    });
    let found = Row::simulated("BlimanSorine", &[]);
    found.assert_close("co-simulation", &expected, 1e-2);
    assert!(found.first_maximum.1 > 0.745, "{}", found.first_maximum.1);
    assert_close("period", found.last_period, std::f64::consts::TAU / 2f64.sqrt(), 2e-3);
    assert_bounded_at_coarse_steps("BlimanSorine", &[], |_| 2.0 * F_S - F_C + 1e-9);
}

/// A reversal out of steady sliding doubles the response from rest, f_C - (f_1 a - f_2 b), so the next peak is
/// 2 f_peak - f_C = 1.962 N instead of f_peak. No path gives more: this is the integral of the magnitude of the impulse
/// response C exp(A s) B, which changes its sign once, at s_p.
#[test]
fn bliman_sorine_of_second_order_peaks_higher_after_a_reversal_but_never_above_that() {
    let mut bench = after("BlimanSorine", &[], -1.0, 1.0);
    bench.set("velocity", 4.665596443730539e-5);
    bench.step(1.0);
    assert_abs_diff_eq!(bench.get("friction_force"), 1.962, epsilon = 1e-12);
    let mut random = Random(31);
    let mut highest: f64 = 0.0;
    for _ in 0..20_000 {
        let leg = 2e-4 * (random.next() - 0.5);
        bench.set("velocity", leg);
        bench.step(1.0);
        highest = highest.max(bench.get("friction_force").abs());
    }
    assert!((1.7..=1.962 + 1e-12).contains(&highest), "{highest}");
}

#[test]
fn bliman_sorine_is_passive() {
    for values in [FIRST_ORDER, &[], &[("eta", 0.1), ("mu_2", 3.0)]] {
        assert_passive("BlimanSorine", values);
        assert_closed_cycles_dissipate("BlimanSorine", values);
    }
}
