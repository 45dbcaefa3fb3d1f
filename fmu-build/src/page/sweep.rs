//! Response of a part to motion: force over velocity, over travel, or over the input it depends on.

use std::f64::consts::TAU;

use anyhow::{Context, Result};
use stribeck::instance::{Instance, Refused};
use stribeck::model::{Kind, ModelType, Role};

use crate::page::curve::Curve;

/// Fraction of the travel, and period of the motion.
const STEPS: u32 = 1000;
const PERIOD: f64 = 0.5;

/// One cycle of a moved model.
pub struct Sweep {
    /// Column along the abscissa: the moved input.
    pub across: usize,
    /// Column along the ordinate: the first output.
    pub answer: usize,
    /// The points.
    pub curve: Curve,
}

/// The moved input, and its amplitude about its start value.
enum Motion {
    /// A travel, and its velocity if that is also an input.
    Travel { travel: usize, velocity: Option<usize>, shown: usize, amplitude: f64 },
    /// A velocity to and fro, for a part that follows the displacement itself.
    Strokes { velocity: usize, displacement: usize, amplitude: f64 },
    /// A single input, slowly.
    Slow { input: usize, amplitude: f64 },
}

/// Moves a model over one cycle, with the values of its first preset if it has one.
pub fn of(model: &'static ModelType) -> Result<Sweep> {
    let motion = Motion::of(model)?;
    let is_result = |column: &usize| model.table.at(*column).role == Role::Output;
    let answer = (0..model.table.len()).find(is_result).context("a part needs an output")?;
    let across = motion.shown();
    let mut instance = Instance::new(model);
    if let Some(preset) = model.presets.first() {
        instance.apply(preset.name);
    }
    let start: Vec<f64> = instance.row().to_vec();
    let mut curve = Curve::new();
    // The first cycle removes the effect of the initial state.
    for step in 0..=2 * STEPS {
        motion.set(&mut instance, &start, f64::from(step) * PERIOD / f64::from(STEPS))?;
        instance.step(motion.time_step())?;
        if step >= STEPS {
            curve.push([instance.row()[across], instance.row()[answer]]);
        }
    }
    Ok(Sweep { across, answer, curve })
}

impl Motion {
    fn of(model: &ModelType) -> Result<Motion> {
        let velocity = model.find("velocity");
        if let Some(travel) = model.find("length").or_else(|| model.find("compression")) {
            // Force over velocity shows most about a whole strut, force over travel about parts that stop a
            // compression.
            let shown = velocity.filter(|_| model.find("length").is_some()).unwrap_or(travel);
            // Over the stroke and a little beyond, if the travel begins at 0; else to both sides of the start.
            return Ok(Motion::Travel { travel, velocity, shown, amplitude: 0.02 });
        }
        if let Some((velocity, displacement)) = velocity.zip(model.find("displacement")) {
            let amplitude = 2.0 * model.table.at(displacement).nominal;
            return Ok(Motion::Strokes { velocity, displacement, amplitude });
        }
        if let Some(input) = velocity {
            return Ok(Motion::Slow { input, amplitude: 0.3 });
        }
        let is_input = |column: &usize| {
            model.table.at(*column).role == Role::Input && matches!(model.table.at(*column).kind, Kind::Real(_))
        };
        let input = (0..model.table.len()).find(is_input).context("a part needs an input")?;
        Ok(Motion::Slow { input, amplitude: 50.0 })
    }

    /// The abscissa of the force.
    fn shown(&self) -> usize {
        match *self {
            Motion::Travel { shown, .. } => shown,
            Motion::Strokes { displacement, .. } => displacement,
            Motion::Slow { input, .. } => input,
        }
    }

    fn set(&self, instance: &mut Instance, start: &[f64], time: f64) -> Result<(), Refused> {
        let phase = TAU * time / PERIOD;
        match *self {
            Motion::Travel { travel, velocity, amplitude, .. } => {
                // A compression begins at full extension.
                let middle = if start[travel] == 0.0 { 0.03 } else { start[travel] };
                instance.set_column(travel, middle + amplitude * phase.sin())?;
                velocity.map_or(Ok(()), |column| instance.set_column(column, amplitude * TAU / PERIOD * phase.cos()))
            }
            Motion::Strokes { velocity, amplitude, .. } => {
                instance.set_column(velocity, amplitude * TAU / PERIOD * phase.cos())
            }
            Motion::Slow { input, amplitude } => instance.set_column(input, start[input] + amplitude * phase.sin()),
        }
    }

    /// Slow motion has settled at each point.
    fn time_step(&self) -> f64 {
        match self {
            Motion::Travel { .. } | Motion::Strokes { .. } => PERIOD / f64::from(STEPS),
            Motion::Slow { .. } => 1e4,
        }
    }
}
