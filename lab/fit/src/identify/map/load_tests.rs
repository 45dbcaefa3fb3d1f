//! Maps of a joint at several loads, of curves written down here, with noise.

use super::super::joint_tests::Text;
use super::super::tests::{estimate, fitted, noise, quick};
use super::super::{Inquiry, Settings, Verdict};

const SPEEDS: [f64; 12] = [0.002, 0.004, 0.008, 0.015, 0.03, 0.06, 0.12, 0.25, 0.5, 1.0, 1.5, 2.0];
const LOADS: [f64; 4] = [0.0, 20.0, 50.0, 100.0];

/// Parameters of the law that a map at 20 degC tells.
const NAMES: [&str; 7] = [
    "mu_k",
    "mu_s",
    "stribeck_velocity",
    "kinetic_force",
    "excess_force",
    "stribeck_velocity_unloaded",
    "viscous_coefficient",
];

/// A joint with these values, every speed in both directions.
fn simulated([mu_k, mu_s, fall, level, excess, slow, viscous]: [f64; 7], loads: &[f64], seed: u64) -> String {
    let rows: Vec<[f64; 2]> =
        loads.iter().flat_map(|load| SPEEDS.iter().flat_map(|v| [[*v, *load], [-*v, *load]])).collect();
    let force = |[v, load]: [f64; 2]| {
        let falling = |height: f64, speed: f64| height * (-(v / speed).powi(2)).exp();
        let size = level + mu_k * load + falling((mu_s - mu_k) * load, fall) + falling(excess, slow);
        v.signum() * size + viscous * v
    };
    let lines = rows.iter().zip(noise(seed, rows.len())).map(|(row, noise)| {
        let [v, load] = row;
        format!("{v},{load},{}\n", force(*row) + 0.1 * noise)
    });
    "velocity [rad/s],normal_force [N.m],force [N.m]\n".to_owned() + &lines.collect::<String>()
}

fn inquiry() -> Inquiry {
    Inquiry { records: vec!["map.csv".into()], law: vec!["JointFriction".to_owned()], ..Inquiry::default() }
}

/// Of 100 maps with drawn values 640 to 660 of 700 intervals are expected; the test draws fewer.
#[test]
fn intervals_of_a_joint_hold_the_truth_as_often_as_they_say() {
    let maps = std::env::var("MAPS").map_or(12, |maps| maps.parse().unwrap());
    let mut counts = NAMES.map(|name| (name, [0u32; 2]));
    for seed in 0..maps {
        let mut random = fastrand::Rng::with_seed(seed ^ 0x10AD);
        let mut drawn = |low: f64, high: f64| low + (high - low) * random.f64();
        let [mu_k, fall] = [drawn(0.02, 0.06), drawn(0.1, 0.4)];
        let truth = [
            mu_k,
            mu_k + drawn(0.05, 0.15),
            fall,
            drawn(4.0, 12.0),
            drawn(3.0, 8.0),
            drawn(0.01, 0.04),
            drawn(2.0, 8.0),
        ];
        let data = inquiry().data(&Text(simulated(truth, &LOADS, seed))).unwrap();
        let task = Settings { profiles: true, budget: 600, ..quick() };
        let fit = fitted("JointFriction", &data.experiments, &task);
        for ((name, count), truth) in counts.iter_mut().zip(truth) {
            let one = estimate(&fit, name);
            if one.verdict == Verdict::Determined {
                let [low, high] = one.interval();
                *count = [count[0] + u32::from((low..=high).contains(&truth)), count[1] + 1];
            }
        }
    }
    let total = counts.iter().fold([0, 0], |sum, (_, count)| [sum[0] + count[0], sum[1] + count[1]]);
    println!("figure: joints at four loads: {} of {} intervals hold the truth, {counts:?}", total[0], total[1]);
    let told = f64::from(total[1]);
    assert!(told >= 6.5 * maps as f64 && f64::from(total[0]) >= 0.9 * told, "{total:?} {counts:?}");
}

/// At one load, what it causes and what is there without it are one level and one curve.
#[test]
fn one_load_does_not_tell_what_it_causes() {
    let truth = [0.04, 0.12, 0.3, 8.0, 5.0, 0.3, 4.0];
    let data = inquiry().data(&Text(simulated(truth, &[50.0], 3))).unwrap();
    let fit = fitted("JointFriction", &data.experiments, &Settings { budget: 600, ..quick() });
    for name in ["mu_k", "kinetic_force"] {
        assert_ne!(estimate(&fit, name).verdict, Verdict::Determined, "{name}");
    }
    assert_eq!(estimate(&fit, "viscous_coefficient").verdict, Verdict::Determined);
}
