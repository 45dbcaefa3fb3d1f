//! A run of a model on its own, whose inputs and results a user can compare with those of the FMU.

use std::f64::consts::TAU;

use anyhow::{Context, Result};
use stribeck::catalogue::Family;
use stribeck::instance::Instance;
use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};

use crate::describe::entry::Entry;
use crate::describe::only_law::OnlyLaw;
use crate::describe::text::number;
use crate::page::curve::Law;

/// Steps of the run, which is one period.
const STEPS: u32 = 50;

/// Period of a motion that shows no memory in s, and amplitudes: of a length in m, a velocity in m/s, a height of the
/// ground in m; and the load of a contact that has none by default, in N (all chosen).
const PERIOD: f64 = 0.5;
const STROKE: f64 = 0.02;
const SPEED: f64 = 0.1;
const BUMP: f64 = 0.002;
const LOAD: f64 = 100.0;

/// An input over time: `middle` + `amplitude` sin(w t), or the rate of such a motion.
struct Signal {
    column: usize,
    middle: f64,
    amplitude: f64,
    is_rate: bool,
}

/// The inputs that move, and the step.
pub struct Experiment {
    model: &'static ModelType,
    signals: Vec<Signal>,
    /// Communication step, s.
    pub step: f64,
}

/// Inputs and results as CSV.
pub struct Record {
    /// Inputs at the beginning of each step, and at the end; none if no input moves.
    pub inputs: Option<String>,
    /// Outputs at the start, and after each step.
    pub outputs: String,
}

impl Experiment {
    /// The experiment of a model: its contact or its strut moves to and fro, the ground under its wheels waves, or its
    /// first input does.
    pub fn of(entry: &Entry) -> Result<Experiment> {
        let model = entry.model;
        let mut experiment = Experiment { model, signals: Vec::new(), step: PERIOD / f64::from(STEPS) };
        if experiment.input("m", |variable| variable.meaning == Meaning::GroundHeight).is_some() {
            experiment.wave(Meaning::GroundHeight, 0.0, BUMP);
            experiment.wave(Meaning::GroundVelocity, 0.0, BUMP);
        } else if let Some((column, variable)) = experiment.input("m", |_| true) {
            // A compression begins at full extension.
            let middle = if variable.start == 0.0 { 1.5 * STROKE } else { variable.start };
            experiment.signals.push(Signal { column, middle, amplitude: STROKE, is_rate: false });
            experiment.wave(Meaning::Velocity, 0.0, STROKE);
        } else if let Some((column, _)) = experiment.input("m/s", |variable| variable.meaning == Meaning::Velocity) {
            let (amplitude, period) = stroke(entry)?;
            experiment.step = period / f64::from(STEPS);
            experiment.signals.push(Signal { column, middle: 0.0, amplitude, is_rate: false });
        } else if let Some((column, variable)) = experiment.first_input() {
            let amplitude = (0.1 * variable.start.abs()).max(0.5);
            experiment.signals.push(Signal { column, middle: variable.start, amplitude, is_rate: false });
        }
        experiment.load();
        Ok(experiment)
    }

    fn inputs(&self) -> impl Iterator<Item = (usize, Variable)> {
        self.model.variables().filter(|(_, variable)| variable.role == Role::Input)
    }

    /// The first input of a unit and a kind.
    fn input(&self, unit: &str, is_wanted: impl Fn(&Variable) -> bool) -> Option<(usize, Variable)> {
        let has_unit = |variable: &Variable| matches!(variable.kind, Kind::Real(own) if own.name == unit);
        self.inputs().find(|(_, variable)| has_unit(variable) && is_wanted(variable))
    }

    fn first_input(&self) -> Option<(usize, Variable)> {
        self.inputs().find(|(_, variable)| matches!(variable.kind, Kind::Real(_)))
    }

    /// Moves all inputs of a meaning alike: a velocity with the rate of the motion.
    fn wave(&mut self, meaning: Meaning, middle: f64, amplitude: f64) {
        let is_rate = meaning != Meaning::GroundHeight;
        let columns: Vec<usize> =
            self.inputs().filter(|(_, variable)| variable.meaning == meaning).map(|(column, _)| column).collect();
        self.signals.extend(columns.into_iter().map(|column| Signal { column, middle, amplitude, is_rate }));
    }

    /// Presses surfaces together that would not touch.
    fn load(&mut self) {
        let is_unloaded = |variable: &Variable| variable.meaning == Meaning::NormalForce && variable.start == 0.0;
        if let Some((column, _)) = self.input("N", is_unloaded) {
            self.signals.push(Signal { column, middle: LOAD, amplitude: 0.0, is_rate: false });
        }
    }

    fn values(&self, step: u32) -> impl Iterator<Item = (usize, f64)> {
        let frequency = TAU / (self.step * f64::from(STEPS));
        let phase = TAU * f64::from(step) / f64::from(STEPS);
        self.signals.iter().map(move |signal| {
            let moved = if signal.is_rate { frequency * phase.cos() } else { phase.sin() };
            (signal.column, signal.middle + signal.amplitude * moved)
        })
    }

    /// Columns of the results. Advice is computed on request, and no result of the run.
    fn results(&self) -> Vec<usize> {
        let is_result = |variable: &Variable| variable.role.is_output() && !variable.is_advice;
        self.model.variables().filter(|(_, variable)| is_result(variable)).map(|(column, _)| column).collect()
    }

    /// Runs the model as a master does that sets inputs, steps, and reads outputs; with this law, if there is only one.
    pub fn run(&self, law: Option<OnlyLaw>) -> Result<Record> {
        let results = self.results();
        let mut instance = Instance::new(self.model);
        if let Some((column, number)) = law.map(|law| law.start()) {
            instance.set_column(column, number)?;
        }
        let mut inputs = self.heading(self.signals.iter().map(|signal| signal.column));
        let mut outputs = self.heading(results.iter().copied());
        for step in 0..=STEPS {
            let time = f64::from(step) * self.step;
            if step > 0 {
                instance.step(self.step).with_context(|| format!("{} at {time} s", self.model.name))?;
                outputs += &line(time, values_of(&mut instance, &results)?);
            }
            for (column, value) in self.values(step) {
                instance.set_column(column, value)?;
            }
            if step == 0 {
                outputs += &line(time, values_of(&mut instance, &results)?);
            }
            inputs += &line(time, self.values(step).map(|(_, value)| value).collect());
        }
        Ok(Record { inputs: (!self.signals.is_empty()).then_some(inputs), outputs })
    }

    fn heading(&self, columns: impl Iterator<Item = usize>) -> String {
        let names = columns.map(|column| format!(",{}", self.model.table.at(column).path));
        format!("time{}\n", names.collect::<String>())
    }
}

/// Amplitude and period of a velocity that shows what a law is about.
fn stroke(entry: &Entry) -> Result<(f64, f64)> {
    if entry.family != Family::Friction {
        return Ok((SPEED, PERIOD));
    }
    let law = Law::new(entry.model, None)?;
    let range = law.velocity_range()?;
    Ok((range, law.period(range)?.unwrap_or(PERIOD)))
}

fn values_of(instance: &mut Instance, columns: &[usize]) -> Result<Vec<f64>> {
    columns.iter().map(|column| Ok(instance.get_column(*column)?)).collect()
}

fn line(time: f64, values: Vec<f64>) -> String {
    let words: Vec<String> = [time].into_iter().chain(values).map(number).collect();
    words.join(",") + "\n"
}
