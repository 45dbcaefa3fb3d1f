//! A record: force and motion on one clock, and the friction that follows from them.

use super::MeasuredError;
use super::clock::Clocks;
use crate::sheet::text;

/// Properties of a rig.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// Mass between load cell and contact, kg.
    pub mass: f64,
    /// Normal force, N, if the file does not have it.
    pub normal_force: Option<f64>,
    /// Window in which the motion is smoothed and differentiated, s; if it is not given, 5 to 391 samples and at most
    /// a tenth of the record, one for the velocity and one for the acceleration, with the least error of each.
    pub window: Option<f64>,
    /// How far the motion is behind the force.
    pub delay: Delay,
    /// Start of the record that is left out, s.
    pub skip: f64,
    /// Whether it is an axis, whose force is that of its drive: force and motion are then smoothed alike, in the window.
    pub is_axis: bool,
}

/// Delay of the motion behind the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Delay {
    /// It is known, in s.
    Known(f64),
    /// It is to be found, at most this long, in s.
    Find(f64),
    /// It is that of a controller which holds its force until the next sample: up to two samples of the record, to be
    /// found. Only of an axis.
    OfController,
}

impl Delay {
    /// Longest delay that is looked for unless another one is given, s (chosen).
    pub const LONGEST: f64 = 0.1;
}

impl Default for Rig {
    /// No mass, one clock.
    fn default() -> Rig {
        Rig { mass: 0.0, normal_force: None, window: None, delay: Delay::Known(0.0), skip: 0.0, is_axis: false }
    }
}

/// A gap between samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Where it begins, s.
    pub time: f64,
    /// Its length, s.
    pub length: f64,
}

/// Quality of a record.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Quality {
    /// Number of samples.
    pub samples: usize,
    /// Length, s.
    pub duration: f64,
    /// Median interval, s.
    pub interval: f64,
    /// Gaps between samples.
    pub gaps: Vec<Gap>,
    /// Share of the samples at an end of the range of the force, where the load cell may be saturated.
    pub saturated: f64,
    /// Noise of the force, standard deviation in N.
    pub noise: f64,
    /// Least change of the displacement, m.
    pub resolution: f64,
    /// Largest speed, m/s.
    pub fastest: f64,
    /// Samples per reversal in which the speed is below a tenth of the largest one.
    pub slow: f64,
    /// Number of reversals.
    pub reversals: usize,
    /// Least and largest normal force, N.
    pub loads: [f64; 2],
    /// Sentences on what is missing or doubtful.
    pub findings: Vec<String>,
}

/// Data for each sample of a record whose force and motion are smoothed alike.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Alike {
    /// Third derivative of the displacement, m/s3.
    pub jerk: Vec<f64>,
    /// Least speed within the reach of the filter, m/s, of a velocity that is smoothed less; 0 where it turns.
    pub least_speed: Vec<f64>,
    /// Noise of the force that the filter leaves, standard deviation in N.
    pub noise: f64,
}

/// Force and motion of a slider, on the clock of the force.
#[derive(Clone, Debug)]
pub struct Record {
    /// Time, s.
    pub time: Vec<f64>,
    /// Force of the load cell, N.
    pub force: Vec<f64>,
    /// Displacement, m.
    pub displacement: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Acceleration, m/s2.
    pub acceleration: Vec<f64>,
    /// Normal force, N.
    pub normal_force: Vec<f64>,
    /// Friction force f_f = F - m a, N.
    pub friction_force: Vec<f64>,
    /// Window of the filter of the velocity, s; 0 if that was measured.
    pub window: f64,
    /// Window of the filter of the acceleration, s.
    pub acceleration_window: f64,
    /// Whether the velocity comes from the displacement.
    pub is_differentiated: bool,
    /// Error of the velocity around rest, m/s, root mean square: its noise if it was measured; otherwise what the filter
    /// lets pass of the noise of the displacement and swallows of the motion.
    pub velocity_error: f64,
    /// Error of the acceleration where it passes through 0, m/s2, root mean square: what the filter lets pass of noise.
    pub acceleration_error: f64,
    /// Part of the acceleration that its filter takes away.
    pub acceleration_lost: f64,
    /// Median interval between samples of the motion, s.
    pub motion_interval: f64,
    /// First and last time of the motion on the clock of the force, s.
    pub motion_ends: [f64; 2],
    /// Clocks of force and motion.
    pub clocks: Clocks,
    /// Range in which the delay is, s; None if it is known.
    pub delay_range: Option<[f64; 2]>,
    /// Further data of a record whose force and motion are smoothed alike.
    pub alike: Option<Alike>,
    /// Quality.
    pub quality: Quality,
}

impl Record {
    /// Refuses what sums and quotients of extreme numbers give.
    pub(super) fn finite(&self) -> Result<(), MeasuredError> {
        let computed: [(&'static str, &[f64]); 4] = [
            ("displacement", &self.displacement),
            ("velocity", &self.velocity),
            ("acceleration", &self.acceleration),
            ("friction_force", &self.friction_force),
        ];
        for (name, values) in computed {
            if let Some(at) = values.iter().position(|value| !value.is_finite()) {
                return Err(MeasuredError::OutOfRange { name, time: self.time[at], value: values[at] });
            }
        }
        Ok(())
    }

    /// The record as a table, with units in the heading.
    pub fn csv(&self) -> csv::Result<String> {
        text(&[
            ("time [s]", &self.time),
            ("force [N]", &self.force),
            ("displacement [m]", &self.displacement),
            ("velocity [m/s]", &self.velocity),
            ("acceleration [m/s2]", &self.acceleration),
            ("normal_force [N]", &self.normal_force),
            ("friction_force [N]", &self.friction_force),
        ])
    }
}
