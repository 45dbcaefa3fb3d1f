//! A spring and a slider with rate-and-state friction: creep above a stiffness, stick-slip below.

use stribeck::numerics::root::bisect;

use super::tests::solved;
use super::{Setting, Source, System};
use crate::run::{Outcome, Settings, Solver, run};

const MASS: f64 = 10.0;
const LOAD: f64 = MASS * 9.81;
const PULL: f64 = 1e-4;
/// Direct effect of the law.
const A: f64 = 0.010;
/// Its evolution effect.
const B: f64 = 0.015;
const D_C: f64 = 1e-5;
const V_0: f64 = 1e-6;
const MU_0: f64 = 0.6;

/// Least stiffness of a spring with which the slider creeps steadily.
fn critical() -> f64 {
    (B - A) * LOAD / D_C * (1.0 + MASS * PULL * PULL / (LOAD * A * D_C))
}

/// Friction force of steady creep.
fn steady_force() -> f64 {
    LOAD * (MU_0 + (A - B) * f64::ln(PULL / V_0))
}

/// A complex number.
type Complex = [f64; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

fn over(x: f64, [a, b]: Complex) -> Complex {
    let size = a * a + b * b;
    [x * a / size, -x * b / size]
}

/// The eigenvalue with a positive frequency of the equations around steady creep, whose characteristic polynomial is
///
/// ```text
/// m s^3 + (m w + A') s^2 + (A' w + k - b f_n / D_c) s + k w,   w = u / D_c,   A' = a f_n / u
/// ```
///
/// The third eigenvalue is real and negative.
fn eigenvalue(stiffness: f64) -> Complex {
    let (w, slope) = (PULL / D_C, A * LOAD / PULL);
    let [c_2, c_1, c_0] = [MASS * w + slope, slope * w + stiffness - B * LOAD / D_C, stiffness * w].map(|c| c / MASS);
    let cubic = |s: f64| ((s + c_2) * s + c_1) * s + c_0;
    let real = bisect(cubic, -2.0 * c_2, 0.0);
    // What is left is s^2 + p s + q.
    let (p, q) = (c_2 + real, -c_0 / real);
    [-0.5 * p, (q - 0.25 * p * p).sqrt()]
}

const STATES: [&str; 3] = ["mass.elongation", "mass.velocity", "friction.log_age"];

/// Slider that creeps, its speed changed by a thousandth.
fn disturbed(variant: &str, stiffness: f64, until: f64) -> Outcome {
    let settings = [
        ("mass.stiffness", stiffness.to_string()),
        ("mass.preload", steady_force().to_string()),
        ("mass.velocity", (1.001 * PULL).to_string()),
        ("friction.log_age", (-f64::ln(PULL / V_0)).to_string()),
        ("friction.variant", variant.to_owned()),
    ];
    let settings: Vec<Setting> =
        settings.into_iter().map(|(name, value)| Setting { name: name.to_owned(), value }).collect();
    let system = System::assemble(&Source::open("spring-slider").unwrap(), None, &settings).unwrap();
    let settings = Settings { tolerance: 1e-12, until, every: 0.01 * until, ..Settings::of(&system) };
    let outcome = run(&system, &settings, &STATES.map(str::to_owned)).unwrap();
    assert!(outcome.is_reached(), "{}", outcome.end);
    outcome
}

/// The part of a small motion that has the eigenvalue s: the product with the left eigenvector, which grows as
/// exp(s t).
fn part(outcome: &Outcome, at: usize, stiffness: f64, s: Complex) -> Complex {
    let steady = [0.0, PULL, -f64::ln(PULL / V_0)];
    let [elongation, velocity, log_age] =
        std::array::from_fn(|state| outcome.values(STATES[state]).unwrap()[at] - steady[state]);
    let [x, y] = over(stiffness * elongation / MASS, s);
    let [z, w] = over(B * LOAD * log_age / MASS, [s[0] + PULL / D_C, s[1]]);
    [x + velocity - z, y - w]
}

/// 5 % above the critical stiffness a small motion dies out, 5 % below it grows, both at the rate and with the frequency
/// of the linear equations; by the ageing law as by the slip law, which are the same there.
#[test]
fn a_small_motion_grows_below_the_critical_stiffness_and_dies_out_above() {
    assert!(eigenvalue(critical())[0].abs() < 1e-9 * eigenvalue(critical())[1]);
    for variant in ["Ageing", "Slip"] {
        for (share, grows) in [(0.95, true), (1.05, false)] {
            let stiffness = share * critical();
            let s = eigenvalue(stiffness);
            assert_eq!(s[0] > 0.0, grows, "{s:?}");
            let until = 10.0;
            let outcome = disturbed(variant, stiffness, until);
            let [begin, end] = [0, outcome.time.len() - 1].map(|at| part(&outcome, at, stiffness, s));
            let (sine, cosine) = (s[1] * until).sin_cos();
            let factor = times(begin, [cosine, sine]).map(|x| x * f64::exp(s[0] * until));
            let error = f64::hypot(end[0] - factor[0], end[1] - factor[1]) / f64::hypot(factor[0], factor[1]);
            assert!(error < 3e-3, "{variant} {share}: {end:?} {factor:?}");
        }
    }
}

/// As it comes it slips in jerks; with a stiff spring it creeps at the steady level instead.
#[test]
fn a_soft_spring_gives_stick_slip_and_a_stiff_one_creep() {
    let results = ["mass.velocity", "friction.friction_force"];
    let soft = solved("spring-slider", "RateAndState", &[], 1e-8, &results);
    let velocity = soft.values("mass.velocity").unwrap();
    let jerks = velocity.windows(2).filter(|pair| pair[0] < 10.0 * PULL && pair[1] >= 10.0 * PULL).count();
    let slowest = velocity.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(jerks >= 3 && slowest > 0.0 && slowest < 0.01 * PULL, "{jerks} {slowest}");
    let stiff = solved("spring-slider", "RateAndState", &[("mass.stiffness", "1e5")], 1e-8, &results);
    let [velocity, force] = results.map(|name| *stiff.values(name).unwrap().last().unwrap());
    assert!((velocity / PULL - 1.0).abs() < 1e-6, "{velocity}");
    assert!((force / steady_force() - 1.0).abs() < 1e-9, "{force}");
}

/// Jerks over 20 s, against finer steps and a method of another crate.
#[test]
fn jerks_are_those_of_another_solver() {
    let system = System::assemble(&Source::open("spring-slider").unwrap(), None, &[]).unwrap();
    let names = ["mass.position".to_owned()];
    let position = |solver, tolerance| {
        let outcome = run(&system, &Settings { solver, tolerance, ..Settings::of(&system) }, &names).unwrap();
        assert!(outcome.is_reached(), "{}", outcome.end);
        outcome.columns[0].values.clone()
    };
    let ours = position(Solver::Rodas5P, 1e-9);
    for solver in [Solver::Rodas5P, Solver::Bdf] {
        let others = position(solver, 1e-10);
        let error = ours.iter().zip(&others).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
        assert!(error < 1e-9, "{solver:?}: {error} m");
    }
}
