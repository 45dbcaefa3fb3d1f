//! Published numbers and closed forms of the laws with hysteresis in pre-sliding, dwell time or two dimensions.

mod common;

use common::random::Random;
use common::{Bench, Exchange, belt};

/// f_C, f_s, v_S, sigma_0, sigma_1 = sqrt(sigma_0), sigma_2 of the thesis' Tables 6.1 and 7.1.
const F_C: f64 = 0.981;
const F_S: f64 = 1.4715;
const V_S: f64 = 0.001;
const SIGMA_0: f64 = 1e5;
const SIGMA_1: f64 = 316.227_766_016_837_94;
const SIGMA_2: f64 = 0.1;

fn level(velocity: f64) -> f64 {
    F_C + (F_S - F_C) * (-(velocity / V_S).powi(2)).exp()
}

/// Moves by `distance` at the speed `speed`.
fn travel(bench: &mut Bench, distance: f64, speed: f64) {
    bench.set("velocity", speed * distance.signum());
    bench.step(distance.abs() / speed);
}

fn after(model: &str, values: &[(&str, f64)], velocity: f64, time: f64) -> Bench {
    let mut bench = Bench::new(model, values);
    bench.set("velocity", velocity);
    bench.step(time);
    bench
}

/// The first maximum of the position with its time, and the lowest position after it.
fn first_slip(samples: impl Iterator<Item = (f64, f64)>) -> [f64; 3] {
    let after_start = samples.skip_while(|(time, _)| *time < 1.0);
    let (mut highest, mut lowest) = ((0.0, f64::MIN), f64::MAX);
    for (time, position) in after_start.take_while(|(time, _)| *time < 12.0) {
        if position > highest.1 {
            (highest, lowest) = ((time, position), f64::MAX);
        }
        lowest = lowest.min(position);
    }
    [highest.0, highest.1, lowest]
}

/// The belt benchmark (Table 6.1) with an independent implementation of the law, by Euler's method at 1 us: `law(v, h)`
/// advances the states of the law and returns its force.
fn euler_belt(mut law: impl FnMut(f64, f64) -> f64) -> [f64; 3] {
    let (h, mut x, mut dx) = (1e-6, 0.0, 0.1);
    let samples = (0..12_000_000).map(|k| {
        dx += h * (-2.0 * x - law(dx - 0.1, h));
        x += h * dx;
        (f64::from(k) * h, x)
    });
    first_slip(samples)
}

fn assert_belt(model: &str, values: &[(&str, f64)], expected: [f64; 3]) {
    for h in [1e-4, 1e-3] {
        let samples = belt(&mut Bench::new(model, values), h, 12.0, Exchange::Sequential);
        let found = first_slip(samples.iter().map(|sample| (sample.time, sample.position)));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.01, "{model} {h}: {found} against {expected}");
        }
    }
}

/// The block stays within the closed form, and the force within the limit of law and damping.
fn assert_bounded(model: &str, values: &[(&str, f64)]) {
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        for h in [1e-3, 5e-3, 1e-2] {
            let samples = belt(&mut Bench::new(model, values), h, 40.0, exchange);
            let highest = samples.iter().map(|s| s.position.abs()).fold(0.0, f64::max);
            let force = samples.iter().map(|s| s.friction_force.abs()).fold(0.0, f64::max);
            assert!(highest < 0.78, "{model} {h} {exchange:?}: {highest} m");
            assert!(force <= 1.3 * F_S, "{model} {h} {exchange:?}: {force} N");
        }
    }
}

/// Random strokes, after which the law has returned no more energy than it received: its elastic energy is not
/// negative.
fn assert_passive(model: &str, values: &[(&str, f64)], speed: f64) {
    let mut random = Random(23);
    for history in 0..1000 {
        let mut bench = Bench::new(model, values);
        for _ in 0..30 {
            bench.set("velocity", speed * 10f64.powf(-3.0 * random.next()) * random.signed());
            bench.step(10f64.powf(-2.0 - 2.0 * random.next()));
            let energy = bench.get("dissipated_energy");
            assert!(energy >= -1e-18, "{model}, history {history}: {energy} J");
        }
    }
}

/// Linearly varying inputs in so many steps, compared with a dense sequence of short held steps. The load of these lags
/// by half a short step: raised at once, it would bond sliding elements.
fn assert_ramp(model: &str, values: &[(&str, f64)], steps: u32, tolerance: f64) {
    let mut ramp = Bench::new(model, values);
    let axis = if ramp.has("velocity") { "" } else { "_x" };
    let [velocity, force] = ["velocity", "friction_force"].map(|name| format!("{name}{axis}"));
    ramp.set(&velocity, -2e-3);
    ramp.step(0.01);
    let mut dense = Bench::new(model, values);
    dense.instance.restore(&ramp.instance.save());
    let (moving, load) = (ramp.column(&velocity), ramp.column("normal_force"));
    for _ in 0..steps {
        ramp.instance.put_slope(moving, 0.5);
        ramp.instance.put_slope(load, 100.0);
        ramp.step(0.02 / f64::from(steps));
    }
    let n = 300_000;
    for k in 0..n {
        let time = 0.02 * (f64::from(k) + 0.5) / f64::from(n);
        dense.set(&velocity, -2e-3 + 0.5 * time);
        dense.set("normal_force", 9.81 + 100.0 * time);
        dense.step(0.02 / f64::from(n));
    }
    dense.set(&velocity, 8e-3);
    for name in [&*force, "dissipated_energy"] {
        let (a, b) = (ramp.get(name), dense.get(name));
        assert!((a / b - 1.0).abs() < tolerance, "{model} {name}: {a} against {b}");
    }
}

// ---- MaxwellSlip

/// Speed at which the level is f_s to 1e-12.
const CREEP: f64 = 1e-9;

/// y(x) = sum_i min(k_i x, alpha_i f_s), of the four default elements.
fn virgin_curve(x: f64) -> f64 {
    let elements = [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)];
    elements.iter().map(|(k, alpha)| f64::min(k * SIGMA_0 * x, alpha * F_S)).sum()
}

#[test]
fn maxwell_slip_virgin_curve() {
    for (x, force) in [(1e-5, 0.64715), (2e-5, 0.94145), (3e-5, 1.1829), (6e-5, 1.4715)] {
        let mut law = Bench::new("MaxwellSlip", &[]);
        travel(&mut law, x, CREEP);
        assert!((law.get("friction_force") - force).abs() < 1e-11, "{x}: {}", law.get("friction_force"));
        assert!((virgin_curve(x) - force).abs() < 1e-14);
    }
}

/// Masing's rules: branches are the virgin curve, doubled; inner loops close and are erased by the outer branch.
#[test]
fn maxwell_slip_branches_follow_masing() {
    let mut law = Bench::new("MaxwellSlip", &[]);
    let top = 3e-5;
    travel(&mut law, top, CREEP);
    let mut x = top;
    for _ in 0..24 {
        travel(&mut law, -2.5e-6, CREEP);
        x -= 2.5e-6;
        let branch = virgin_curve(top) - 2.0 * virgin_curve(0.5 * (top - x));
        assert!((law.get("friction_force") - branch).abs() < 1e-12, "{x}");
        // An inner loop leaves no trace.
        if x < 0.0 {
            travel(&mut law, 1.3e-6, CREEP);
            travel(&mut law, -1.3e-6, CREEP);
            assert!((law.get("friction_force") - branch).abs() < 1e-12, "{x}, after an inner loop");
        }
    }
    travel(&mut law, 2.0 * top, CREEP);
    assert!((law.get("friction_force") - virgin_curve(top)).abs() < 1e-12);
}

/// Energy of the loop between -X and X: 8 int_0^X y dx - 4 X y(X).
#[test]
fn maxwell_slip_loop_energy() {
    let mut law = Bench::new("MaxwellSlip", &[]);
    travel(&mut law, 3e-5, CREEP);
    let mut before = law.get("dissipated_energy");
    for _ in 0..3 {
        travel(&mut law, -6e-5, CREEP);
        travel(&mut law, 6e-5, CREEP);
        let energy = law.get("dissipated_energy") - before;
        assert!((energy / 3.839025780e-5 - 1.0).abs() < 1e-9, "{energy}");
        before += energy;
    }
}

/// Steady sliding: s(v) sgn v + f_v v, whatever the distribution.
#[test]
fn maxwell_slip_steady_force() {
    for distribution in [1.0, 2.0] {
        for velocity in [1e-4, 5e-4, -1e-3, 2e-3, -0.1] {
            let values = [("distribution", distribution), ("element_count", 20.0), ("viscous_coefficient", SIGMA_2)];
            let force = after("MaxwellSlip", &values, velocity, 10.0).get("friction_force");
            let expected = level(velocity) * f64::signum(velocity) + SIGMA_2 * velocity;
            assert!((force - expected).abs() < 1e-12, "{velocity}: {force}");
        }
    }
}

/// With one element, equal levels and instant attraction: Dahl's law with alpha = 0.
#[test]
fn maxwell_slip_of_one_element_is_elastic_and_perfectly_plastic() {
    let values = [("element_count", 1.0), ("mu_s", 0.1), ("attraction", 1e12)];
    let (mut law, mut dahl) = (Bench::new("MaxwellSlip", &values), Bench::new("Dahl", &[("alpha", 0.0)]));
    let mut random = Random(3);
    for _ in 0..2000 {
        let distance = 1e-5 * random.signed();
        travel(&mut law, distance, 1e-2);
        travel(&mut dahl, distance, 1e-2);
        assert!((law.get("friction_force") - dahl.get("friction_force")).abs() < 1e-12);
    }
    assert!((law.get("dissipated_energy") / dahl.get("dissipated_energy") - 1.0).abs() < 1e-12);
}

#[test]
fn maxwell_slip_with_equal_levels_is_passive() {
    for sigma_1 in [0.0, 300.0] {
        assert_passive("MaxwellSlip", &[("mu_s", 0.1), ("sigma_1", sigma_1)], 1e-2);
        let uniform = [("mu_s", 0.1), ("sigma_1", sigma_1), ("distribution", 2.0), ("element_count", 64.0)];
        assert_passive("MaxwellSlip", &uniform, 1e-2);
    }
}

#[test]
fn maxwell_slip_with_ramped_inputs() {
    assert_ramp("MaxwellSlip", &[], 500, 1e-6);
    assert_ramp("MaxwellSlip", &[("sigma_1", SIGMA_1), ("viscous_coefficient", SIGMA_2)], 500, 1e-6);
}

/// The benchmark against the equations integrated together by Euler's method, with and without damping.
#[test]
fn maxwell_slip_on_the_belt() {
    for (sigma_1, sigma_2) in [(SIGMA_1, SIGMA_2), (0.0, 0.0)] {
        let mut elements =
            [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)].map(|(k, a)| (k * SIGMA_0, a, 0.0, false));
        let mut last = 0.0;
        let expected = euler_belt(|v, h| {
            let s = level(v);
            let mut force = sigma_2 * v;
            for (k, alpha, f, slips) in &mut elements {
                *slips &= v * last > 0.0;
                *slips |= *f * v.signum() >= *alpha * s;
                let rate = if *slips { 1000.0 * (*alpha * v.signum() - *f / s) } else { *k * v };
                *f += h * rate;
                force += *f + sigma_1 / SIGMA_0 * rate;
            }
            last = v;
            force
        });
        assert_belt("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", sigma_2)], expected);
        assert_bounded("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", sigma_2)]);
    }
}

/// A stuck block on elements without damping vibrates with sqrt((k + sigma_0) / m) and keeps its amplitude; with the
/// damping of 2003 it comes to rest.
#[test]
fn maxwell_slip_needs_damping_to_bring_a_stuck_block_to_rest() {
    for (sigma_1, remains) in [(0.0, true), (SIGMA_1, false)] {
        let mut law = Bench::new("MaxwellSlip", &[("sigma_1", sigma_1), ("viscous_coefficient", 0.0)]);
        let (h, mut x, mut v) = (1e-5, 0.0, 1e-4);
        let mut late = 0.0f64;
        for k in 0..100_000 {
            law.set("velocity", v);
            law.step(h);
            v -= h * law.get("friction_force");
            x += h * v;
            if k > 90_000 {
                late = late.max(f64::abs(v));
            }
        }
        let amplitude = 1e-4 / SIGMA_0.sqrt();
        assert!(x.abs() < 1.01 * amplitude);
        assert_eq!(late > 0.99e-4, remains, "{late}");
        assert_eq!(late < 1e-9, !remains, "{late}");
    }
}

// ---- Leuven

/// Identity: one element that is strong enough, n = 1, is LuGre.
#[test]
fn leuven_of_one_element_is_lugre() {
    let mut random = Random(5);
    let (mut law, mut lugre) = (Bench::new("Leuven", &[("element_count", 1.0)]), Bench::new("LuGre", &[]));
    for _ in 0..3000 {
        let (v, h) = (10f64.powf(-5.0 * random.next()) * random.signed(), 10f64.powf(-5.0 * random.next()));
        for bench in [&mut law, &mut lugre] {
            bench.set("velocity", v);
            bench.step(h);
        }
        for name in ["friction_force", "dissipated_energy"] {
            let (a, b) = (law.get(name), lugre.get(name));
            assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{name}: {a} against {b} at {v} m/s");
        }
    }
}

/// Steady sliding: s(v) sgn v + sigma_2 v for every exponent.
#[test]
fn leuven_steady_force() {
    for exponent in [0.5, 1.0, 2.0, 7.0] {
        for velocity in [1e-4, 5e-4, -1e-3, 2e-3, -0.1] {
            let force = after("Leuven", &[("approach_exponent", exponent)], velocity, 1e3).get("friction_force");
            let expected = level(velocity) * f64::signum(velocity) + SIGMA_2 * velocity;
            assert!((force - expected).abs() < 1e-11, "{exponent} {velocity}: {force}");
        }
    }
}

#[test]
fn leuven_without_damping_is_passive() {
    for exponent in [0.5, 1.0, 2.0] {
        assert_passive(
            "Leuven",
            &[("sigma_1", 0.0), ("viscous_coefficient", 0.0), ("approach_exponent", exponent)],
            1e-2,
        );
    }
}

/// With damping above sigma_2 f_C / (f_s - f_C) a jump to a high speed from full stiction returns power.
#[test]
fn leuven_is_active_above_the_stated_bound() {
    let bound = SIGMA_2 * F_C / (F_S - F_C);
    for (factor, active) in [(0.99, false), (1.2, true)] {
        let mut law = after("Leuven", &[("sigma_1", factor * bound)], 1e-9, 1e6);
        let mut lowest = f64::MAX;
        for k in 1..10_000 {
            law.set("velocity", f64::from(k));
            lowest = lowest.min(law.get("dissipated_power"));
        }
        assert_eq!(lowest < 0.0, active, "{factor}: {lowest} W");
    }
}

#[test]
fn leuven_with_ramped_inputs() {
    assert_ramp("Leuven", &[], 500, 1e-6);
    assert_ramp("Leuven", &[("approach_exponent", 2.0)], 500, 1e-6);
}

/// The benchmark against the equations with the deflections z and zeta_i, integrated together by Euler's method.
#[test]
fn leuven_on_the_belt() {
    let mut elements =
        [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)].map(|(k, w)| (k * SIGMA_0, w * 1.2 * F_S, 0.0));
    let mut z = 0.0f64;
    let expected = euler_belt(|v, h| {
        let hysteresis: f64 = elements.iter().map(|(k, _, zeta)| k * (z - zeta)).sum();
        let rate = v - v.abs() * hysteresis / level(v);
        z += h * rate;
        let mut force = SIGMA_1 * rate + SIGMA_2 * v;
        for (k, w, zeta) in &mut elements {
            let limit = *w / *k;
            *zeta = zeta.clamp(z - limit, z + limit);
            force += *k * (z - *zeta);
        }
        force
    });
    assert_belt("Leuven", &[], expected);
    assert_bounded("Leuven", &[]);
}

// ---- Gonthier

/// Force, deflection and dwell state from rest at constant velocity, integrated independently (9 digits).
#[test]
fn gonthier_from_rest() {
    let rows = [
        (1e-4, 0.05, 0.635958197, 6.00857592e-6, 0.0244444175),
        (1e-4, 0.10, 1.00469394, 1.11424565e-5, 0.0482853002),
        (1e-4, 0.15, 1.01609917, 1.55289751e-5, 0.0715375493),
        (1e-4, 1.00, 1.17208636, 3.950004e-5, 0.389554255),
        (1e-3, 0.01, 0.981999973, 1.00719945e-5, 1.83480637e-3),
        (1e-2, 1e-3, 0.982, 2.65955561e-6, 0.0),
        (1e-2, 5e-3, 0.982, 7.79168411e-6, 0.0),
    ];
    for (velocity, time, force, deflection, dwell) in rows {
        let mut law = after("Gonthier", &[], velocity, time);
        for (name, expected) in [("friction_force", force), ("bristle_deflection", deflection), ("dwell", dwell)] {
            let found = law.get(name);
            assert!((found - expected).abs() <= 6e-9 * expected + 1e-15, "{velocity} {time} {name}: {found}");
        }
    }
}

/// min{f_C + sigma_1 v / (exp(u^2) - 1), f_C + (f_s - f_C) exp(-u^2)} + sigma_2 v, u = v / v_S. For the defaults the
/// second is always the smaller one, by as little as 1.56697399 sigma_1 v_S / (f_s - f_C) = 1.0102; not so for half of
/// sigma_1.
#[test]
fn gonthier_steady_force() {
    let mut first_counts = 0;
    for sigma_1 in [SIGMA_1, 0.5 * SIGMA_1] {
        for velocity in [5e-4, 1e-3, -1.120_906_41e-3, 1.5e-3, 2e-3, -3e-3, 0.1] {
            let u: f64 = velocity / V_S;
            let bristle = F_C + sigma_1 * f64::abs(velocity) / (u * u).exp_m1();
            let expected = bristle.min(level(velocity)) * velocity.signum() + SIGMA_2 * velocity;
            let force = after("Gonthier", &[("sigma_1", sigma_1)], velocity, 1e3).get("friction_force");
            assert!((force - expected).abs() < 1e-12, "{velocity}: {force} against {expected}");
            first_counts += i32::from(bristle < level(velocity));
            assert!(sigma_1 < SIGMA_1 || bristle > level(velocity) || u.abs() > 30.0);
        }
    }
    assert!(first_counts > 1);
}

/// Breakaway after a rest of t: f_C + (f_s - f_C) (1 - exp(-t / tau_d)).
#[test]
fn gonthier_breakaway_rises_with_the_time_of_rest() {
    for rest in [0.01, 0.5, 2.0, 20.0] {
        let mut law = after("Gonthier", &[("viscous_coefficient", 0.0), ("sigma_1", 1e4)], 0.0, rest);
        // Twice the distance to full stiction, too fast for the level to change.
        law.set("velocity", 1e-4);
        law.set("normal_force", 9.81);
        law.step(1e-9);
        law.set("bristle_deflection", 3e-5);
        let breakaway = F_C - (F_S - F_C) * f64::exp_m1(-rest / 2.0);
        assert!((law.get("friction_force") - breakaway).abs() < 1e-9, "{rest}: {}", law.get("friction_force"));
    }
}

#[test]
fn gonthier_with_equal_levels_is_passive() {
    assert_passive("Gonthier", &[("mu_s", 0.1), ("viscous_coefficient", 0.0)], 1e-2);
    assert_passive("Gonthier", &[("mu_s", 0.1), ("viscous_coefficient", 0.0)], 1e-3);
}

/// With stiction the law is not passive; it returns at most (f_s - f_C) times the distance travelled.
#[test]
fn gonthier_returns_no_more_than_the_stated_bound() {
    let mut random = Random(29);
    let mut lowest = f64::MAX;
    for _ in 0..1000 {
        let mut law = Bench::new("Gonthier", &[("viscous_coefficient", 0.0)]);
        let mut distance = 0.0;
        for _ in 0..30 {
            let velocity = 5e-5 * random.signed();
            let time = random.next();
            law.set("velocity", velocity);
            law.step(time);
            distance += f64::abs(velocity) * time;
            law.set("velocity", 0.0);
            law.step(10.0 * random.next());
            let energy = law.get("dissipated_energy");
            assert!(energy >= -(F_S - F_C) * distance, "{energy} J after {distance} m");
            lowest = lowest.min(energy);
        }
    }
    assert!(lowest < 0.0, "{lowest}");
}

#[test]
fn gonthier_with_ramped_inputs() {
    assert_ramp("Gonthier", &[], 1, 1e-6);
}

/// The benchmark against the equations integrated together by Euler's method.
#[test]
fn gonthier_on_the_belt() {
    let (mut z, mut dwell) = (0.0, 0.0);
    let expected = euler_belt(|v, h| {
        let s = (-(v / V_S).powi(2)).exp();
        let u = f64::clamp(v / 1e-5, -1.0, 1.0);
        let rate = s * v + (1.0 - s) / SIGMA_1 * (F_C * (1.5 * u - 0.5 * u.powi(3)) - SIGMA_0 * z);
        z += h * rate;
        dwell += h * (s - dwell) / if s >= dwell { 2.0 } else { SIGMA_1 / SIGMA_0 };
        let limit = F_C + (F_S - F_C) * dwell;
        (SIGMA_0 * z + SIGMA_1 * rate).clamp(-limit, limit) + SIGMA_2 * v
    });
    assert_belt("Gonthier", &[], expected);
    assert_bounded("Gonthier", &[]);
}

// ---- Liang

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
                assert!((found - share * force).abs() < 6e-9 * force, "{velocity} {time} {name}: {found}");
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
                assert!((a - b).abs() < 1e-9 * size, "{variant}: {a} against {b} at {scale}");
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
        assert!((law.get("friction_force_y") - SIGMA_0 * z).abs() < 1e-12, "{v}");
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
            assert!((law.get("friction_force_x") - dahl.get("friction_force")).abs() < 1e-12);
        }
        assert!((law.get("dissipated_energy") / dahl.get("dissipated_energy") - 1.0).abs() < 1e-12);
    }
}

/// Random strokes in a plane, after which a law has returned no more energy than it received.
fn assert_passive_in_a_plane(model: &str, values: &[(&str, f64)], speed: f64) {
    let mut random = Random(43);
    for history in 0..1000 {
        let mut bench = Bench::new(model, values);
        for _ in 0..30 {
            let size = speed * 10f64.powf(-3.0 * random.next());
            bench.set("velocity_x", size * random.signed());
            bench.set("velocity_y", size * random.signed());
            bench.step(10f64.powf(-2.0 - 2.0 * random.next()));
            let energy = bench.get("dissipated_energy");
            assert!(energy >= -1e-18, "{model}, history {history}: {energy} J");
        }
    }
}

#[test]
fn liang_is_passive() {
    for (variant, sigma_1) in [(1.0, 0.0), (1.0, SIGMA_1), (2.0, 0.0), (2.0, SIGMA_1)] {
        assert_passive_in_a_plane("Liang", &[("variant", variant), ("sigma_1", sigma_1)], 1e-2);
    }
}

/// The benchmark with a law in the plane, moving along its first axis.
fn planar_belt(model: &str, values: &[(&str, f64)], h: f64, end: f64) -> Vec<[f64; 3]> {
    let (mut rig, mut law) = (Bench::new("BeltRig", &[]), Bench::new(model, values));
    (0..(end / h).round() as usize)
        .map(|k| {
            law.set("velocity_x", rig.get("velocity"));
            law.step(h);
            let force = law.get("friction_force_x");
            let sample = [k as f64 * h, rig.get("position"), force];
            rig.set("friction_force", force);
            rig.step(h);
            sample
        })
        .collect()
}

/// `peak(h)` is the largest possible force when the velocity is sampled with the step h.
fn assert_planar_belt(model: &str, expected: [f64; 3], peak: impl Fn(f64) -> f64) {
    let values = &[];
    for h in [1e-4, 1e-3] {
        let samples = planar_belt(model, values, h, 12.0);
        let found = first_slip(samples.iter().map(|[time, position, _]| (*time, *position)));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.01, "{model} {h}: {found} against {expected}");
        }
    }
    for h in [1e-3, 5e-3, 1e-2] {
        for [time, position, force] in planar_belt(model, values, h, 40.0) {
            assert!(position.abs() < 0.78 && force.abs() < peak(h), "{model} {h}: {position} m, {force} N at {time}");
        }
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

// ---- LuGrePlanar, ElastoPlasticPlanar

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
                assert!((found / force - 1.0).abs() < 6e-9, "{model} {velocity} {time}: {found}");
                let found = law.get(&format!("bristle_deflection_{axis}")) / share;
                assert!((found / deflection - 1.0).abs() < 6e-9, "{model} {velocity} {time}: {found}");
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
        assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
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
