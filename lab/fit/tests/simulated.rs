//! Intervals of fits to records that the virtual rig has not made hold the truth as often as they say. The benchmark
//! `identify` counts those of more records.

#[path = "../benches/simulated/mod.rs"]
mod simulated;

use stribeck_fit::identify::{Estimate, Inquiry};
use stribeck_solve::job::Entry;

use simulated::{Damper, Held, Joint, Mount, Servo, Simulated, Slider, Transmission};

/// A damper of which only the length of the accumulator is to be found, in few evaluations: all other parameters are held at
/// the truth.
struct OfAccumulator(Damper);

impl Simulated for OfAccumulator {
    fn asked(&self) -> Inquiry {
        let held = self.0.values.into_iter().filter(|(name, _)| *name != "x_0");
        let fix = held.map(|(name, value)| Entry(name.to_owned(), value)).collect();
        Inquiry { fix, budget: Some(20), ..self.0.asked() }
    }

    fn record(&self, random: &mut fastrand::Rng) -> String {
        self.0.record(random)
    }

    fn truth(&self, one: &Estimate) -> Option<f64> {
        self.0.truth(one)
    }
}

/// The intervals of several simulated things; none has a reason to be warned of.
fn held(seeds: u64, of: impl Fn(u64, &mut fastrand::Rng) -> Box<dyn Simulated>) -> [u32; 2] {
    let all = looked(seeds, of);
    assert_eq!(all.warned, 0, "{:?}", all.counts);
    all.total()
}

fn looked(seeds: u64, of: impl Fn(u64, &mut fastrand::Rng) -> Box<dyn Simulated>) -> Held {
    let mut all = Held::default();
    for seed in 0..seeds {
        let mut random = fastrand::Rng::with_seed(seed);
        all.look(&*of(seed, &mut random), &mut random);
    }
    all
}

/// Of intervals half as wide, two thirds would hold the truth.
#[test]
fn intervals_of_joints_and_arms_hold_the_truth() {
    let [told, held] = held(12, |seed, random| Box::new(Joint::drawn(seed, random)));
    assert!(told >= 54 && f64::from(held) >= 0.85 * f64::from(told), "{held} of {told}");
}

#[test]
fn intervals_of_sliders_hold_the_truth() {
    let [told, held] = held(4, |_, random| Box::new(Slider::drawn(random)));
    assert!(told >= 24 && f64::from(held) >= 0.8 * f64::from(told), "{held} of {told}");
}

/// One of the four is warned of, and gets no numbers.
#[test]
fn intervals_of_mounts_hold_the_truth() {
    let all = looked(4, |_, random| Box::new(Mount::drawn(random)));
    let [told, held] = all.total();
    assert!(told >= 12 && f64::from(held) >= 0.8 * f64::from(told), "{held} of {told}");
    assert!(all.warned <= 1, "{:?}", all.counts);
}

#[test]
fn intervals_of_gears_and_ropes_hold_the_truth() {
    for (seeds, of) in [(4, Transmission::gear as fn(&mut fastrand::Rng) -> Transmission), (1, Transmission::rope)] {
        let [told, intervals] = held(seeds, |_, random| Box::new(of(random)));
        assert!(told >= 3 * seeds as u32 - 1 && intervals + 1 >= told, "{intervals} of {told}");
    }
}

#[test]
fn intervals_of_a_servo_hold_the_truth() {
    let [told, intervals] = held(1, |_, random| Box::new(Servo::drawn(random)));
    assert!(told == 8 && intervals >= 7, "{intervals} of {told}");
}

/// The other values are held at the truth. A fit without a warning has residuals that are noise: simulator and law agree.
#[test]
fn a_damper_whose_other_parameters_are_known_tells_its_accumulator() {
    let [told, held] = held(1, |_, random| Box::new(OfAccumulator(Damper::drawn(random))));
    assert_eq!([told, held], [1, 1]);
}
