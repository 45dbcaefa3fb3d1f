//! A virtual rig: simulated records of a slider with a known law, with the faults of a real rig.
//!
//! A slider is dragged to and fro along
//!
//! ```text
//! x(t) = - sum of a_i cos(2 pi f_i t) / (2 pi f_i),   a = 20, 4, 1 mm/s,   f = 0.5, 3.7, 11 Hz
//! ```
//!
//! so that it slides, turns slowly and turns fast. The load cell measures F = m a + f_f, with
//!
//! | fault      | size                | meaning                                                                    |
//! |------------|---------------------|----------------------------------------------------------------------------|
//! | noise      | 1 % of the force    | white noise of the load cell                                               |
//! | hysteresis | 0.2 % of the force  | play of the load cell                                                      |
//! | ripple     | 2 %                 | the normal force changes at 7 Hz; the file has its mean                    |
//! | drift      | 0.1 % of the force  | of the load cell, over the record                                          |
//! | camera     | 100 Hz, 20 um       | displacement on a clock that is 12 ms late and gains 0.1 ms per second     |
//!
//! all chosen, and each can be left out; without a camera the displacement is that of an encoder, 1 kHz and 0.1 um. The
//! seed also chooses the zero of encoder or camera within their resolution.

use std::f64::consts::TAU;
use std::fmt::Write;

use stribeck::instance::{Instance, Phase};
use stribeck::model::ModelType;
use stribeck::number::Real;
use stribeck::series::{Between, Course, Input, Times, follow};

use stribeck_solve::system::Fault;

use crate::identify::{Ports, laws};

/// A rig and what it drags.
#[derive(Clone, Debug, PartialEq)]
pub struct VirtualRig {
    /// The law of the contact.
    pub law: &'static ModelType,
    /// Values of its parameters; the others have their start values.
    pub values: Vec<(String, f64)>,
    /// Mass between load cell and contact, kg.
    pub mass: f64,
    /// Mean normal force, N.
    pub normal_force: f64,
    /// Length of the record, s.
    pub duration: f64,
    /// Its faults.
    pub faults: Faults,
    /// Seed of the noise.
    pub seed: u64,
}

/// Faults of a rig; 0 for none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults {
    /// Standard deviation of the noise, relative to the largest force.
    pub noise: f64,
    /// Play of the load cell, relative to the largest force.
    pub hysteresis: f64,
    /// Amplitude of the normal force, relative to its mean.
    pub ripple: f64,
    /// Drift of the force over the record, relative to the largest force.
    pub drift: f64,
    /// Whether a camera measures the motion.
    pub camera: bool,
}

impl Faults {
    /// Noise only.
    pub const NOISE: Faults = Faults { noise: 0.01, hysteresis: 0.0, ripple: 0.0, drift: 0.0, camera: false };
    /// All faults.
    pub const ALL: Faults = Faults { noise: 0.01, hysteresis: 0.002, ripple: 0.02, drift: 0.001, camera: true };
}

/// Files of a record, and what they do not tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Files {
    /// Table of the load cell; with the displacement unless there is a camera.
    pub force: String,
    /// Table of the camera.
    pub camera: Option<String>,
    /// Times of the load cell, s.
    pub time: Vec<f64>,
    /// Friction force then, without the faults of the load cell, N.
    pub friction: Vec<f64>,
}

/// Amplitudes of the velocity, m/s, and frequencies, Hz.
const WAVES: [[f64; 2]; 3] = [[0.02, 0.5], [0.004, 3.7], [0.001, 11.0]];

/// Interval of the load cell and of the camera, s.
const INTERVAL: f64 = 1e-3;
const FRAME: f64 = 1e-2;
/// Resolution of encoder and camera, m.
const ENCODER: f64 = 1e-7;
const PIXEL: f64 = 2e-5;
/// Delay of the camera, s, and its gain per second.
const DELAY: f64 = 0.012;
const GAIN: f64 = 1e-4;
/// Frequency of the ripple, Hz.
const RIPPLE: f64 = 7.0;

/// Samples of the law between two samples of the load cell.
const FINER: usize = 8;

/// Longest record, s (chosen: a million samples).
const LONGEST: f64 = 1000.0;

/// Displacement, velocity and acceleration of the slider.
fn motion(t: f64) -> [f64; 3] {
    WAVES.iter().fold([0.0; 3], |[x, v, a], [amplitude, frequency]| {
        let rate = TAU * frequency;
        let (sine, cosine) = (Real::sin(rate * t), Real::cos(rate * t));
        [x - amplitude / rate * cosine, v + amplitude * sine, a + amplitude * rate * cosine]
    })
}

fn rounded(value: f64, step: f64) -> f64 {
    (value / step).round() * step
}

impl VirtualRig {
    /// The law of this name, if it can be that of a rig.
    pub fn law(name: &str) -> Result<&'static ModelType, Fault> {
        let unknown = || Fault::unknown("friction law", name, laws().map(|law| law.name));
        laws().find(|law| law.name == name).ok_or_else(unknown)
    }

    /// The files of a record.
    pub fn record(&self) -> Result<Files, Fault> {
        self.check()?;
        let count = (self.duration / INTERVAL).round() as usize + 1;
        let friction = self.friction(count)?;
        let clean = |at: usize| self.mass * motion(at as f64 * INTERVAL)[2] + friction[at];
        let level = (0..count).map(|at| clean(at).abs()).fold(0.0, f64::max);
        let mut random = fastrand::Rng::with_seed(self.seed);
        let zero = self.zero();
        let Faults { noise, hysteresis, drift, camera, .. } = self.faults;
        let mut shown = clean(0);
        let mut force =
            if camera { "time [s],force [N]\n" } else { "time [s],force [N],displacement [m]\n" }.to_owned();
        for at in 0..count {
            let t = at as f64 * INTERVAL;
            let play = 0.5 * hysteresis * level;
            shown = shown.clamp(clean(at) - play, clean(at) + play);
            // Box and Muller (1958); 1 - u is never 0.
            let radius = Real::sqrt(-2.0 * Real::ln(1.0 - random.f64()));
            let gauss = radius * Real::cos(TAU * random.f64());
            let measured = shown + level * (noise * gauss + drift * t / self.duration);
            let _ = write!(force, "{t:.3},{measured:.6}");
            let position = rounded(motion(t)[0] + zero * ENCODER, ENCODER);
            let _ = if camera { writeln!(force) } else { writeln!(force, ",{position:.7}") };
        }
        let time = (0..count).map(|at| at as f64 * INTERVAL).collect();
        Ok(Files { force, camera: camera.then(|| self.camera()), time, friction })
    }

    /// The friction force at the samples of the load cell.
    fn friction(&self, count: usize) -> Result<Vec<f64>, Fault> {
        let along = Ports::of(self.law).and_then(|ports| Some((ports.load?, ports)));
        let (load, Ports { velocity, force, .. }) =
            along.ok_or_else(|| self.refused("only laws of one sliding direction have a rig"))?;
        let mut instance = self.instance()?;
        let samples = (count - 1) * FINER + 1;
        let time = |at: usize| at as f64 * INTERVAL / FINER as f64;
        let velocities: Vec<f64> = (0..samples).map(|at| motion(time(at))[1]).collect();
        let ripple = |t: f64| self.normal_force * (1.0 + self.faults.ripple * Real::sin(TAU * RIPPLE * t));
        let loads: Vec<f64> = (0..samples).map(|at| ripple(time(at))).collect();
        let inputs = [Input { column: velocity, samples: &velocities }, Input { column: load, samples: &loads }];
        let times = Times::Every(INTERVAL / FINER as f64);
        let course = Course { inputs: &inputs, times, samples, between: Between::Linear };
        let mut forces = vec![0.0; samples];
        let never = std::sync::atomic::AtomicBool::new(false);
        let followed = follow(&mut instance, &course, &[force], &mut [&mut forces], &never);
        followed.map_err(|reason| self.refused(reason))?;
        Ok(forces.into_iter().step_by(FINER).collect())
    }

    /// The law with its values.
    fn instance(&self) -> Result<Instance, Fault> {
        let law = self.law;
        let column = |name: &str| {
            let all: Vec<String> = law.variables().map(|(_, variable)| variable.path.to_string()).collect();
            let unknown = || Fault::unknown(format!("{}: variable", law.name), name, all.iter().map(String::as_str));
            law.find(name).ok_or_else(unknown)
        };
        let all = self.values.iter().map(|(name, value)| Ok((column(name)?, *value)));
        let values = all.collect::<Result<Vec<(usize, f64)>, Fault>>()?;
        let mut instance = Instance::new(law);
        instance.set_all(Phase::Setup, values.into_iter()).map_err(|reason| self.refused(reason))?;
        instance.check().map_err(|reason| self.refused(reason))?;
        Ok(instance)
    }

    fn refused(&self, reason: impl std::fmt::Display) -> Fault {
        Fault::value(format_args!("{}: {reason}", self.law.name))
    }

    /// Zero of encoder and camera, relative to their resolution.
    fn zero(&self) -> f64 {
        fastrand::Rng::with_seed(!self.seed).f64()
    }

    /// Table of the camera, from a little before the record to a little after it.
    fn camera(&self) -> String {
        let mut text = "time [s],displacement [m]\n".to_owned();
        let frames = ((self.duration + 0.2) / FRAME).round() as usize;
        for frame in 0..=frames {
            let t = frame as f64 * FRAME - 0.1;
            let shown = t + DELAY + GAIN * (t - 0.5 * self.duration);
            let _ = writeln!(text, "{shown:.6},{:.6}", rounded(motion(t)[0] + self.zero() * PIXEL, PIXEL));
        }
        text
    }

    fn check(&self) -> Result<(), Fault> {
        let Faults { noise, hysteresis, ripple, drift, .. } = self.faults;
        let numbers = [
            ("mass", self.mass),
            ("normal_force", self.normal_force),
            ("noise", noise),
            ("hysteresis", hysteresis),
            ("drift", drift),
        ];
        let wrong = |text: std::fmt::Arguments| Err(Fault::value(text));
        match numbers.into_iter().find(|(_, value)| !(*value >= 0.0 && value.is_finite())) {
            Some((name, value)) => wrong(format_args!("{name} = {value}: must be >= 0 and finite")),
            None if !(0.0..=1.0).contains(&ripple) => wrong(format_args!("ripple = {ripple}: must be from 0 to 1")),
            None if !(0.1..=LONGEST).contains(&self.duration) => {
                wrong(format_args!("duration = {} s: must be from 0.1 s to {LONGEST} s", self.duration))
            }
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::catalogue::by_name;
    use stribeck_measured::{Delay, Record, Setup};
    use stribeck_sheet::Sheet;

    fn rig(faults: Faults) -> VirtualRig {
        VirtualRig {
            law: by_name("Coulomb").unwrap(),
            values: vec![("mu_k".into(), 0.2)],
            mass: 2.0,
            normal_force: 20.0,
            duration: 4.0,
            faults,
            seed: 1,
        }
    }

    /// Coulomb friction of 4 N: the record gives it back in both strokes, within the noise.
    #[test]
    fn a_record_gives_back_the_friction_of_the_rig() {
        let files = rig(Faults::NOISE).record().unwrap();
        assert_eq!(files.camera, None);
        let known = Setup { mass: 2.0, normal_force: Some(20.0), ..Setup::default() };
        let record = Record::of(&Sheet::parse(&files.force).unwrap(), None, &known).unwrap();
        let sliding = record.velocity.iter().zip(&record.friction_force).filter(|(v, _)| v.abs() > 5e-3);
        let rest: Vec<f64> = sliding.map(|(v, force)| force - 4.0 * v.signum()).collect();
        let rms = (rest.iter().map(|one| one * one).sum::<f64>() / rest.len() as f64).sqrt();
        // Noise of 1 % of 4.4 N, and the inertia of a differentiated encoder.
        assert!((0.03..0.06).contains(&rms), "{rms}");
        // Without the noise it is that of the law.
        assert!(files.time.iter().zip(&record.time).all(|(one, other)| (one - other).abs() < 1e-9));
        let slides = files.friction.iter().zip(&record.velocity).filter(|(_, v)| v.abs() > 5e-3);
        assert!(slides.into_iter().all(|(force, v)| (force - 4.0 * v.signum()).abs() < 1e-9));
    }

    #[test]
    fn the_clock_of_the_camera_is_found() {
        let files = rig(Faults::ALL).record().unwrap();
        let sheets = [Some(files.force), files.camera].map(|text| Sheet::parse(&text.unwrap()).unwrap());
        let known = Setup {
            mass: 2.0,
            normal_force: Some(20.0),
            window: Some(0.1),
            delay: Delay::Find(0.05),
            ..Setup::default()
        };
        let record = Record::of(&sheets[0], Some(&sheets[1]), &known).unwrap();
        assert!((record.clocks.delay - DELAY).abs() < 0.2 * FRAME, "{:?}", record.clocks);
        assert!((record.quality.resolution - PIXEL).abs() < PIXEL, "{:?}", record.quality);
    }

    #[test]
    fn the_same_seed_gives_the_same_files() {
        let first = rig(Faults::ALL).record().unwrap();
        assert_eq!(rig(Faults::ALL).record().unwrap(), first);
        assert_ne!(VirtualRig { seed: 2, ..rig(Faults::ALL) }.record().unwrap(), first);
    }

    #[test]
    fn impossible_rigs_are_refused() {
        let refusal = |rig: VirtualRig| rig.record().map(|_| ()).unwrap_err().to_string();
        let plain = || rig(Faults::NOISE);
        assert_eq!(refusal(VirtualRig { mass: -1.0, ..plain() }), "mass = -1: must be >= 0 and finite");
        assert_eq!(
            refusal(VirtualRig { duration: 1e9, ..plain() }),
            "duration = 1000000000 s: must be from 0.1 s to 1000 s"
        );
        let values = vec![("mu".to_owned(), 0.1)];
        assert!(refusal(VirtualRig { values, ..plain() }).contains("did you mean 'mu_k'?"));
        let values = vec![("mu_k".to_owned(), -0.1)];
        assert!(refusal(VirtualRig { values, ..plain() }).contains("mu_k = -0.1"));
        let faults = Faults { ripple: 2.0, ..Faults::NOISE };
        assert_eq!(refusal(rig(faults)), "ripple = 2: must be from 0 to 1");
    }
}
