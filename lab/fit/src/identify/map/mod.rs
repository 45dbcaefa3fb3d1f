//! Maps of friction: speed and force at constant speed, without time, perhaps with repeats and in both directions.
//!
//! Each row is fitted as steady sliding: by the force at which the law settles at that speed. What that force does not
//! depend on is held at its start value, and a map does not determine it. The repeats tell the scatter, from which
//! weights follow and by which a law is judged.

mod columns;
mod few;
mod judge;
#[cfg(test)]
mod load_tests;
mod scatter;
mod steady;
#[cfg(test)]
mod tests;
mod untold;

pub use judge::LackOfFit;
pub use scatter::{Band, Scatter};

pub(super) use columns::MapColumns;
pub(super) use few::{by_velocity, neighbours, student};
pub(super) use judge::{lack_of_fit, warnings};
pub(super) use steady::{Sliding, steady_forces};
pub(super) use untold::{estimates, hold_untold};

use stribeck::instance::Instance;
use stribeck_solve::system::Fault;

use super::output::{Reference, parameters};
use super::parameter::refused;
use super::ports::Ports;
use super::response::forces;
use super::uncertainty::digits;
use super::{Experiment, Fit, Inquiry};
use stribeck_measured::{Movement, extremes};
use stribeck_sheet::text;

/// A map of friction, in SI units; of a joint torques in N m and velocities in rad/s.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionMap {
    /// Whether the body slides or turns.
    pub movement: Movement,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Friction force, N.
    pub force: Vec<f64>,
    /// Normal force, N.
    pub normal_force: Vec<f64>,
    /// Number of the speed and load of each row; repeats have the same.
    pub settings: Vec<usize>,
    /// Scatter of the repeats, if there are some.
    pub scatter: Option<Scatter>,
    /// Remarks on it.
    pub findings: Vec<String>,
}

/// Mean of the rows of one speed and load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// Velocity, m/s.
    pub velocity: f64,
    /// Normal force, N.
    pub normal_force: f64,
    /// Friction force, N.
    pub force: f64,
    /// Standard deviation of a row there, N, if there are repeats.
    pub scatter: Option<f64>,
    /// Number of the rows.
    pub rows: usize,
}

/// The force that a fitted law explains in steady sliding, with the offset, at pairs of velocity and normal force.
pub fn steady_curve(fit: &Fit, inputs: &[[f64; 2]]) -> Result<Vec<f64>, Fault> {
    steady(fit, &fit.physical.columns, inputs)
}

/// The same with values that were given for the law, and the offset of the fit.
pub fn reference_curve(fit: &Fit, values: &Reference, inputs: &[[f64; 2]]) -> Result<Vec<f64>, Fault> {
    steady(fit, &parameters(fit.law, values)?, inputs)
}

fn steady(fit: &Fit, columns: &[(usize, f64)], inputs: &[[f64; 2]]) -> Result<Vec<f64>, Fault> {
    let ports = Ports::of(fit.law).ok_or_else(|| refused(fit.law, "slides in more than one direction"))?;
    let part = |number: usize| inputs.iter().map(|input| input[number]).collect();
    let rows = Experiment {
        time: part(0),
        velocity: part(0),
        normal_force: part(1),
        map: Some(Rows::default()),
        ..Experiment::default()
    };
    let found = forces(&mut Instance::new(fit.law), &ports, columns, &rows, 1);
    let found = found.map_err(|reason| refused(fit.law, reason))?;
    Ok(found.into_iter().map(|force| force + fit.physical.offset).collect())
}

/// The rows of a map as a fit needs them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Number of the speed and load of each row.
    pub settings: Vec<usize>,
    /// Weight of the residual of each row: the pooled scatter over that of its speed.
    pub weights: Vec<f64>,
    /// Pooled scatter of the repeats, N; 0 without repeats.
    pub scatter: f64,
}

impl Rows {
    /// Every so many of them.
    pub(super) fn coarser(&self, parts: usize) -> Rows {
        Rows {
            settings: self.settings.iter().copied().step_by(parts).collect(),
            weights: self.weights.iter().copied().step_by(parts).collect(),
            scatter: self.scatter,
        }
    }
}

impl FrictionMap {
    /// From the columns of a table, with what was said of them.
    pub(super) fn of(columns: MapColumns, findings: Vec<String>) -> Result<FrictionMap, Fault> {
        let MapColumns { movement, velocity, force, normal_force } = columns;
        let settings = scatter::settings(&velocity, &normal_force);
        let scatter = Scatter::of(&velocity, &force, &settings);
        let map = FrictionMap { movement, velocity, force, normal_force, settings, scatter, findings: Vec::new() };
        map.check()?;
        let found = ["no column time: taken as a map of steady sliding, whose rows are at constant speed".to_owned()];
        let findings = found.into_iter().chain(findings).chain(map.told()).collect();
        Ok(FrictionMap { findings, ..map })
    }

    /// Refuses rows that tell nothing of friction.
    fn check(&self) -> Result<(), Fault> {
        let speeds: Vec<f64> = self.velocity.iter().map(|v| v.abs()).filter(|speed| *speed > 0.0).collect();
        let Some(first) = speeds.first() else {
            return Err(Fault::value("velocity is 0 in all rows: a map needs rows of sliding"));
        };
        if speeds.iter().all(|speed| scatter::is_same(*speed, *first, 0.0)) {
            let unit = self.movement.unit("m/s");
            let text = format_args!("velocity: all rows slide at {first} {unit}; a map needs at least two speeds");
            return Err(Fault::value(text));
        }
        let power: f64 = self.velocity.iter().zip(&self.force).map(|(v, force)| v * force).sum();
        if power <= 0.0 {
            let text = "force: friction would drive the motion: force and velocity are positive in opposite \
                        directions, which --scale force=-1 turns round";
            return Err(Fault::value(text));
        }
        Ok(())
    }

    /// Remarks on what the rows tell and what they cannot.
    fn told(&self) -> Vec<String> {
        let at_rest = self.velocity.iter().filter(|v| **v == 0.0).count();
        let is_one_way = [1.0, -1.0].iter().any(|sign| self.velocity.iter().all(|v| sign * v >= 0.0));
        let rest = (at_rest > 0).then(|| {
            let rows = if at_rest == 1 { "1 row at rest is" } else { &format!("{at_rest} rows at rest are") };
            format!("{rows} left out: there friction is whatever holds the contact")
        });
        let one_way = is_one_way.then(|| {
            "one direction only: an offset of the force cannot be told apart from a level of friction".to_owned()
        });
        let is_unit = self.normal_force.iter().all(|load| *load == 1.0);
        let (force, unit) = (self.movement.force(), self.movement.unit("N"));
        let unit = is_unit.then(|| format!("at a load of 1 {unit} a coefficient of friction is a {force} in {unit}"));
        [rest, one_way, unit, Some(self.of_scatter())].into_iter().flatten().collect()
    }

    fn of_scatter(&self) -> String {
        let Some(Scatter { pooled, freedom, bands }) = &self.scatter else {
            return "no repeats: the scatter is taken from the residuals, so that a law cannot be judged by it"
                .to_owned();
        };
        let [force, velocity] = ["N", "m/s"].map(|unit| self.movement.unit(unit));
        let text = format!("scatter of the repeats {} {force} ({freedom} degrees of freedom)", digits(*pooled));
        if bands.is_empty() {
            return text;
        }
        let one = |band: &Band| format!("{} {force} up to {} {velocity}", digits(band.scatter), digits(band.up_to));
        let each = bands.iter().map(one);
        format!("{text}, not the same at all speeds: {}; rows are weighted by it", each.collect::<Vec<_>>().join(", "))
    }

    /// As a law is led through it; rows at rest, or below a speed, are left out.
    pub(super) fn experiment(&self, name: &str, rest: Option<f64>) -> Result<Experiment, Fault> {
        let rest = rest.unwrap_or(0.0);
        if !(rest >= 0.0 && rest.is_finite()) {
            let unit = self.movement.unit("m/s");
            return Err(Fault::value(format_args!("rest = {rest}: must be >= 0 and finite, in {unit}")));
        }
        let is_at_rest = |v: &f64| *v == 0.0 || v.abs() < rest;
        let left_out = self.velocity.iter().map(is_at_rest).collect();
        let count = self.velocity.len();
        let weight = |v: &f64| self.scatter.as_ref().map_or(1.0, |scatter| scatter.weight(*v));
        let weights = self.velocity.iter().map(weight).collect();
        let scatter = self.scatter.as_ref().map_or(0.0, |scatter| scatter.pooled);
        Ok(Experiment {
            movement: self.movement,
            name: name.to_owned(),
            // Rows have no time: their numbers stand for it.
            time: (0..count).map(|row| row as f64).collect(),
            velocity: self.velocity.clone(),
            acceleration: vec![0.0; count],
            normal_force: self.normal_force.clone(),
            force: self.force.clone(),
            left_out,
            map: Some(Rows { settings: self.settings.clone(), weights, scatter }),
            ..Experiment::default()
        })
    }

    /// Means over the rows of each speed and load, by ascending velocity.
    pub fn means(&self) -> Vec<Mean> {
        let of = |setting: usize| {
            let rows: Vec<usize> = (0..self.settings.len()).filter(|row| self.settings[*row] == setting).collect();
            let mean = |values: &[f64]| rows.iter().map(|row| values[*row]).sum::<f64>() / rows.len() as f64;
            let [velocity, normal_force, force] =
                [&self.velocity, &self.normal_force, &self.force].map(|all| mean(all));
            let scatter = self.scatter.as_ref().map(|scatter| scatter.at(velocity));
            Mean { velocity, normal_force, force, scatter, rows: rows.len() }
        };
        (0..self.count()).map(of).collect()
    }

    /// The map and the force that a law explains in its rows, as a table with units in the heading.
    pub fn csv(&self, fitted: &[f64]) -> csv::Result<String> {
        let headings = [("velocity", "m/s"), ("normal_force", "N"), ("force", "N"), ("fitted", "N")];
        let [velocity, load, force, explained] = headings.map(|(name, unit)| self.movement.heading(name, unit));
        text(&[(&velocity, &self.velocity), (&load, &self.normal_force), (&force, &self.force), (&explained, fitted)])
    }

    /// Number of different speeds and loads.
    pub fn count(&self) -> usize {
        self.settings.iter().max().map_or(0, |most| most + 1)
    }

    /// A line on it, and what was found, for a terminal.
    pub fn worth(&self, name: &str) -> String {
        let [low, high] = extremes(self.velocity.iter().copied()).map(digits);
        let mut text = format!(
            "{name}: a map of {} rows at {} speeds from {low} to {high} {}\n",
            self.velocity.len(),
            self.count(),
            self.movement.unit("m/s")
        );
        self.findings.iter().for_each(|finding| text += &format!("  {finding}\n"));
        text
    }
}

/// How to give a map a normal force.
pub(super) const LOAD: &str = "give normal_force; with 1 the coefficients are forces, or torques of a joint";

/// Refuses what a question has and a map, which has no time, does not heed.
pub(super) fn refuse_unheeded(inquiry: &Inquiry) -> Result<(), Fault> {
    let asked = [
        ("mass", inquiry.mass.is_some()),
        ("window", inquiry.window.is_some()),
        ("delay", inquiry.delay.is_some()),
        ("skip", inquiry.skip.is_some()),
        ("gravity", inquiry.setup().has_gravity),
        ("loss = robust", inquiry.loss == Some(super::LossChoice::Robust)),
    ];
    match asked.iter().find(|(_, is_asked)| *is_asked) {
        Some((name, _)) => Err(Fault::value(format_args!("{name}: is not for a map of friction, which has no time"))),
        None => Ok(()),
    }
}
