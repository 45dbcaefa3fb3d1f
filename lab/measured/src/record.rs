//! A record: force and motion on one clock, and the friction that follows from them.

use crate::clock::Clocks;
use crate::error::MeasuredError;
use crate::movement::Movement;
use stribeck::number::Real;
use stribeck_sheet::{Quantity, text};

/// Properties of a measurement that its file does not have.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Mass between load cell and contact, kg.
    pub mass: f64,
    /// Normal force, N, if the file does not have it.
    pub normal_force: Option<f64>,
    /// Window of the filter of the motion, s. By default one for the velocity and one for the acceleration, each with the
    /// least error, of 7 or 5 to 391 samples and at most a tenth of the record.
    pub window: Option<f64>,
    /// Delay of the motion behind the force.
    pub delay: Delay,
    /// Length of the start of the record to skip, s.
    pub skip: f64,
    /// Whether it is an axis, whose force is that of its drive: force and motion then pass a matched filter.
    pub is_axis: bool,
    /// Whether gravity turns it, so that cosine and sine of its angle are needed.
    pub has_gravity: bool,
    /// Whether the force may be that of a spring.
    pub is_elastic: bool,
    /// Further quantities that are read where the file has them.
    pub further: Vec<Quantity>,
}

/// Delay of the motion behind the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Delay {
    /// Known, in s.
    Known(f64),
    /// To be estimated, at most this long, in s.
    Find(f64),
    /// That of a controller which holds its force until the next sample: estimated, up to two samples of the record. Only
    /// for an axis.
    OfController,
}

impl Delay {
    /// Default limit of an estimated delay, s (chosen).
    pub const LONGEST: f64 = 0.1;
}

impl Default for Setup {
    /// No mass, one clock.
    fn default() -> Setup {
        Setup {
            mass: 0.0,
            normal_force: None,
            window: None,
            delay: Delay::Known(0.0),
            skip: 0.0,
            is_axis: false,
            has_gravity: false,
            is_elastic: false,
            further: Vec::new(),
        }
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
    /// Fraction of the samples at a limit of the range of the force, where the load cell may be saturated.
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
    /// Warnings about what the record cannot determine.
    pub findings: Vec<String>,
}

/// Samples of a further quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The quantity, in its unit for a body that slides or turns.
    pub quantity: Quantity,
    /// Its values, in the SI unit.
    pub values: Vec<f64>,
}

impl Channel {
    /// The same with some of its samples.
    pub fn with(&self, values: Vec<f64>) -> Channel {
        Channel { values, quantity: self.quantity }
    }

    /// Its name with its unit in brackets.
    fn heading(&self) -> String {
        format!("{} [{}]", self.quantity.name, self.quantity.units[0].0)
    }
}

/// Extra columns of a matched-filtered record.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MatchedFilter {
    /// Third derivative of the displacement, m/s3.
    pub jerk: Vec<f64>,
    /// Least speed within the reach of the filter, m/s, before filtering; 0 where the motion turns.
    pub least_speed: Vec<f64>,
    /// Noise of the filtered force, standard deviation in N.
    pub noise: f64,
}

/// Cosine and sine of the angle of a joint, filtered like its torque.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Direction {
    /// Cosine.
    pub cosine: Vec<f64>,
    /// Sine.
    pub sine: Vec<f64>,
}

impl Direction {
    /// Of angles.
    pub(crate) fn of(angles: &[f64]) -> Direction {
        let (cosine, sine) = angles.iter().map(|angle| (Real::cos(*angle), Real::sin(*angle))).unzip();
        Direction { cosine, sine }
    }

    /// The same, turned by these angles.
    pub fn turned(&self, by: impl Iterator<Item = f64>) -> Direction {
        let pairs = self.cosine.iter().zip(&self.sine).zip(by);
        let pairs = pairs.map(|((cosine, sine), by)| {
            let [c, s] = [Real::cos(by), Real::sin(by)];
            (cosine * c - sine * s, sine * c + cosine * s)
        });
        let (cosine, sine) = pairs.unzip();
        Direction { cosine, sine }
    }
}

/// Force and motion of a body, on the clock of the force. Units are those of one that slides; of one that turns it has
/// torque, angle and their derivatives, in N m and rad.
#[derive(Clone, Debug)]
pub struct Record {
    /// Whether the body slides or turns.
    pub movement: Movement,
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
    /// Further quantities that the file has.
    pub channels: Vec<Channel>,
    /// Direction of an arm that gravity turns.
    pub direction: Option<Direction>,
    /// Window of the filter of the velocity, s; 0 if the velocity was measured.
    pub window: f64,
    /// Window of the filter of the acceleration, s.
    pub acceleration_window: f64,
    /// Whether the velocity comes from the displacement.
    pub is_differentiated: bool,
    /// RMS error of the velocity near rest, m/s: its noise if it was measured, otherwise filtered noise plus filter bias.
    pub velocity_error: f64,
    /// RMS error of the acceleration near its zeros, m/s2: filtered noise.
    pub acceleration_error: f64,
    /// Fraction of the acceleration that its filter attenuates.
    pub acceleration_lost: f64,
    /// Median interval between samples of the motion, s.
    pub motion_interval: f64,
    /// First and last time of the motion on the clock of the force, s.
    pub motion_ends: [f64; 2],
    /// Clocks of force and motion.
    pub clocks: Clocks,
    /// Range of an estimated delay, s; None if it is known.
    pub delay_range: Option<[f64; 2]>,
    /// Extra columns of a matched-filtered record.
    pub matched_filter: Option<MatchedFilter>,
    /// Quality.
    pub quality: Quality,
}

impl Record {
    /// Rejects derived columns that overflow.
    pub(crate) fn finite(&self) -> Result<(), MeasuredError> {
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
        let columns: [(&str, &'static str, &[f64]); 7] = [
            ("time", "s", &self.time),
            ("force", "N", &self.force),
            ("displacement", "m", &self.displacement),
            ("velocity", "m/s", &self.velocity),
            ("acceleration", "m/s2", &self.acceleration),
            ("normal_force", "N", &self.normal_force),
            ("friction_force", "N", &self.friction_force),
        ];
        let own = columns.map(|(name, unit, values)| (self.movement.heading(name, unit), values));
        let further = self.channels.iter().map(|one| (one.heading(), &one.values[..]));
        let columns: Vec<(String, &[f64])> = own.into_iter().chain(further).collect();
        text(&columns.iter().map(|(heading, values)| (heading.as_str(), *values)).collect::<Vec<_>>())
    }
}
