//! Records of simulators that share no code with the virtual rig, and how many intervals of fits to them hold the truth.

mod damper;
mod joint;
mod mount;
mod servo;
mod slider;
mod transmission;

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use stribeck_fit::identify::{Estimate, Inquiry, Source, Verdict, Watch};
use stribeck_sheet::{Sheet, SheetError};

pub use damper::Damper;
pub use joint::Joint;
pub use mount::Mount;
pub use servo::Servo;
pub use slider::Slider;
pub use transmission::Transmission;

/// Something simulated that has friction.
pub trait Simulated {
    /// Question that is asked of its record, which it need not name.
    fn asked(&self) -> Inquiry;

    /// A record as a text.
    fn record(&self, random: &mut fastrand::Rng) -> String;

    /// The truth of a parameter, if it is one of the simulation.
    fn truth(&self, one: &Estimate) -> Option<f64>;
}

/// Two sines from rest: stroke, m, and frequency, Hz, of each.
pub struct Waves([[f64; 2]; 2]);

impl Waves {
    /// Displacement, velocity and acceleration.
    fn motion(&self, t: f64) -> [f64; 3] {
        self.0.iter().fold([0.0; 3], |[x, v, a], [stroke, rate]| {
            let (rate, half) = (TAU * rate, 0.5 * stroke);
            let (sine, cosine) = (rate * t).sin_cos();
            [x + half * (1.0 - cosine), v + half * rate * sine, a + half * rate * rate * cosine]
        })
    }

    /// Stroke of the first one, m.
    fn stroke(&self) -> f64 {
        self.0[0][0]
    }

    /// A speed that they do not exceed, m/s.
    fn fastest(&self) -> f64 {
        self.0.iter().map(|[stroke, rate]| 0.5 * stroke * TAU * rate).sum()
    }
}

/// A value by its name.
fn value(values: &[(&str, f64)], name: &str) -> f64 {
    values.iter().find(|(known, _)| *known == name).map_or(f64::NAN, |(_, value)| *value)
}

/// The truth of a parameter that has such a name.
fn truth(values: &[(&str, f64)], one: &Estimate) -> Option<f64> {
    values.iter().find(|(name, _)| *name == one.name).map(|(_, value)| *value)
}

/// How many intervals there are of each parameter, and how many of them hold the truth.
#[derive(Default)]
pub struct Held {
    /// By the names of the parameters.
    pub counts: BTreeMap<String, [u32; 2]>,
    /// Fits with warnings.
    pub warned: u32,
}

/// A record as a text.
struct Text(String);

impl Source for Text {
    fn tables(&self, _: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        Ok(vec![Sheet::parse(&self.0)?])
    }
}

impl Held {
    /// Counts the intervals of a fit to a record.
    pub fn look(&mut self, simulated: &dyn Simulated, random: &mut fastrand::Rng) {
        let asked = Inquiry { records: vec!["record.csv".into()], repetitions: Some(0), ..simulated.asked() };
        let data = asked.data(&Text(simulated.record(random))).expect("a record");
        let never = AtomicBool::new(false);
        let watch = Watch { cancel: &never, progress: &|_, _| {} };
        let ranking = asked.fits(&data, &mut |_| {}, watch).expect("a fit");
        self.warned += u32::from(!ranking.best().warnings.is_empty());
        let is_told = |one: &&Estimate| one.verdict == Verdict::Determined;
        for one in ranking.best().estimates.iter().filter(is_told) {
            let Some(truth) = simulated.truth(one) else { continue };
            let [low, high] = one.interval();
            let [told, held] = self.counts.entry(one.name.clone()).or_default();
            (*told, *held) = (*told + 1, *held + u32::from((low..=high).contains(&truth)));
        }
    }

    /// Of all parameters together.
    pub fn total(&self) -> [u32; 2] {
        self.counts.values().fold([0; 2], |[told, held], [more, hits]| [told + more, held + hits])
    }
}

/// A number of the normal distribution.
fn normal(random: &mut fastrand::Rng) -> f64 {
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (TAU * random.f64()).cos()
}
