//! Published numbers and closed forms of the laws with hysteresis in pre-sliding, dwell time or two dimensions: one law
//! per file, and what they share.

mod gonthier;
mod leuven;
mod liang;
mod maxwell_slip;
mod planar;

use crate::common::random::Random;
use crate::common::thesis::{F_C, F_S, SIGMA_0, SIGMA_1, SIGMA_2, V_S, level};
use crate::common::{Bench, Exchange, belt};
use approx::abs_diff_eq;

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
            assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 0.01), "{model} {h}: {found} against {expected}");
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
        ramp.instance.set_slope(moving, 0.5).unwrap();
        ramp.instance.set_slope(load, 100.0).unwrap();
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
        assert!(abs_diff_eq!(a / b, 1.0, epsilon = tolerance), "{model} {name}: {a} against {b}");
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
            assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 0.01), "{model} {h}: {found} against {expected}");
        }
    }
    for h in [1e-3, 5e-3, 1e-2] {
        for [time, position, force] in planar_belt(model, values, h, 40.0) {
            assert!(position.abs() < 0.78 && force.abs() < peak(h), "{model} {h}: {position} m, {force} N at {time}");
        }
    }
}
