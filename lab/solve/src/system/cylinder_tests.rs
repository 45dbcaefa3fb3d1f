//! A cylinder that speeds up and slows down: hysteresis of mixed lubrication.

use super::tests::solved;

const MEAN: f64 = 0.015;
const AMPLITUDE: f64 = 0.013;
const PERIOD: f64 = 2.0;
const F_C: f64 = 30.0;
const F_S: f64 = 60.0;
const SIGMA_0: f64 = 1e7;
const SIGMA_1: f64 = 300.0;
const SIGMA_2: f64 = 300.0;
const V_S: f64 = 0.015;
const V_B: f64 = 0.03;

fn velocity(t: f64) -> f64 {
    MEAN + AMPLITUDE * (std::f64::consts::TAU * t / PERIOD).sin()
}

/// Rates of deflection and film, and the force, as printed.
fn printed(t: f64, [z, h]: [f64; 2]) -> ([f64; 2], f64) {
    let v = velocity(t);
    let steady = (1.0 - F_C / F_S) * (v.min(V_B) / V_B).powf(2.0 / 3.0);
    let level = F_C + ((1.0 - h) * F_S - F_C) * (-(v / V_S) * (v / V_S)).exp();
    let rate = v - SIGMA_0 * v * z / level;
    let film = (steady - h) / if h <= steady { 0.1 } else { 0.2 };
    ([rate, film], SIGMA_0 * z + SIGMA_1 * rate + SIGMA_2 * v)
}

/// Film and force every millisecond, by the classical Runge-Kutta method.
fn integrated() -> (Vec<f64>, Vec<f64>) {
    let (step, mut at) = (5e-6, [0.0; 2]);
    let moved = |at: [f64; 2], by: [f64; 2], h: f64| [at[0] + h * by[0], at[1] + h * by[1]];
    let (mut films, mut forces) = (Vec::new(), Vec::new());
    for count in 0..=800_000 {
        let t = f64::from(count) * step;
        let (k_1, force) = printed(t, at);
        if count % 200 == 0 {
            films.push(at[1]);
            forces.push(force);
        }
        let (k_2, _) = printed(t + 0.5 * step, moved(at, k_1, 0.5 * step));
        let (k_3, _) = printed(t + 0.5 * step, moved(at, k_2, 0.5 * step));
        let (k_4, _) = printed(t + step, moved(at, k_3, step));
        let mean = [0, 1].map(|i| (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]) / 6.0);
        at = moved(at, mean, step);
    }
    (films, forces)
}

/// The loop of the last whole cycle, which begins at the least velocity: force rising and falling at the mean velocity,
/// and the area between both over the velocity.
fn hysteresis(force: &[f64]) -> ([f64; 2], f64) {
    let cycle = 1500..=3500;
    let area: f64 = cycle
        .clone()
        .zip(cycle.skip(1))
        .map(|(from, to)| {
            let [before, after] = [from, to].map(|at| velocity(1e-3 * at as f64));
            0.5 * (force[from] + force[to]) * (after - before)
        })
        .sum();
    ([force[2000], force[3000]], area)
}

#[test]
fn the_loop_is_that_of_the_printed_equations() {
    let results = ["friction.film_thickness", "friction.friction_force"];
    let outcome = solved("cylinder", "CylinderFriction", &[], 1e-11, &results);
    let (films, forces) = integrated();
    let [film, force] = results.map(|name| outcome.values(name).unwrap());
    assert_eq!((film.len(), force.len()), (films.len(), forces.len()));
    for at in 0..film.len() {
        assert!((film[at] - films[at]).abs() < 1e-9, "{} and {} at {at} ms", film[at], films[at]);
        assert!((force[at] - forces[at]).abs() < 1e-9 * F_S, "{} and {} at {at} ms", force[at], forces[at]);
    }
    let [(branches, area), (expected, expected_area)] = [force, &forces].map(hysteresis);
    assert!((area / expected_area - 1.0).abs() < 1e-8, "{area} {expected_area}");
    assert!(expected[0] - expected[1] > 2.0 && expected_area > 0.02, "{expected:?} {expected_area}");
    for (one, other) in branches.iter().zip(expected) {
        assert!((one - other).abs() < 1e-9 * F_S, "{one} {other}");
    }
}

/// Force rising above force falling at every velocity between the turns, and no such loop without a film.
#[test]
fn the_film_makes_the_loop() {
    let force = |law| solved("cylinder", law, &[], 1e-9, &["friction.friction_force"]);
    let [cylinder, lugre] = ["CylinderFriction", "LuGre"].map(force);
    let [cylinder, lugre] = [&cylinder, &lugre].map(|one| one.values("friction.friction_force").unwrap());
    for after in 1..1000 {
        // Both have the same velocity, on the way up and on the way down.
        let [up, down] = [1500 + after, 3500 - after];
        assert!(cylinder[up] > cylinder[down], "{} and {} N", cylinder[up], cylinder[down]);
    }
    let [(_, with), (_, without)] = [cylinder, lugre].map(hysteresis);
    assert!(without.abs() < 0.01 * with, "{without} against {with} W");
}
