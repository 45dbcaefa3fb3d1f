//! One model over given inputs.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use lab::system::{Fault, spelled};
use serde::Deserialize;
use serde_json::{Value, json};
use stribeck::catalogue::models;
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType};
use stribeck::series::{self, Between, Course, Input, Times, set_up};

use crate::answer::Answer;

/// A model, its parameters and its inputs.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Motion {
    /// Name of the model.
    model: String,
    /// Preset of parameters.
    #[serde(default)]
    preset: Option<String>,
    /// Values of parameters and start values.
    #[serde(default)]
    set: BTreeMap<String, Value>,
    /// Inputs: samples, or one value.
    inputs: BTreeMap<String, Vec<f64>>,
    /// Interval of the samples, in s.
    #[serde(default)]
    dt: f64,
    /// Results.
    results: Vec<String>,
}

/// Number of samples that a motion may have (chosen).
const MOST_SAMPLES: usize = 1_000_000;

impl Motion {
    fn model(&self) -> Result<&'static ModelType, Fault> {
        let unknown = || Fault::unknown("model", &self.model, models().map(|model| model.name));
        models().find(|model| model.name == self.model).ok_or_else(unknown)
    }

    fn instance(&self, model: &'static ModelType) -> Result<Instance, Fault> {
        let mut instance = Instance::new(model);
        if let Some(preset) = &self.preset {
            let known = || model.presets.iter().map(|preset| preset.name);
            if !known().any(|name| name == preset) {
                return Err(Fault::unknown(format!("preset of {}", model.name), preset, known()));
            }
            instance.apply(preset);
        }
        let values = self.set.iter().map(|(name, value)| {
            let column = column(model, name)?;
            let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            Ok((column, spelled(&model.table.at(column), &text)?))
        });
        set_up(&mut instance, &values.collect::<Result<Vec<_>, Fault>>()?).map_err(Fault::value)?;
        Ok(instance)
    }

    /// Columns and samples of the inputs, and how many samples there are.
    fn inputs(&self, model: &'static ModelType) -> Result<(Vec<Input<'_>>, usize), Fault> {
        let samples = self.inputs.values().map(Vec::len).max().unwrap_or(0);
        if samples > MOST_SAMPLES {
            return Err(Fault::value(format_args!("{samples} samples: at most {MOST_SAMPLES}")));
        }
        let input = |(name, values): (&String, &'_ Vec<f64>)| {
            if values.len() != 1 && values.len() != samples {
                let count = values.len();
                return Err(Fault::value(format_args!("{name}: {count} samples: must be 1 or {samples}")));
            }
            column(model, name)
        };
        let columns = self.inputs.iter().map(input).collect::<Result<Vec<usize>, Fault>>()?;
        let inputs = columns.into_iter().zip(self.inputs.values());
        Ok((inputs.map(|(column, samples)| Input { column, samples }).collect(), samples))
    }

    fn results(&self, model: &'static ModelType) -> Result<Vec<usize>, Fault> {
        self.results.iter().map(|name| column(model, name)).collect()
    }

    fn answer(&self, model: &ModelType, columns: &[usize], values: Vec<Vec<f64>>) -> Answer {
        let unit = |column: &usize| match model.table.at(*column).kind {
            Kind::Real(unit) => unit.name,
            _ => "1",
        };
        let described = self.results.iter().zip(columns);
        let described = described.map(|(name, column)| json!({ "name": name, "unit": unit(column) }));
        Answer::with(json!({ "columns": described.collect::<Vec<_>>() }), values)
    }
}

fn column(model: &'static ModelType, name: &str) -> Result<usize, Fault> {
    let unknown = || {
        let known: Vec<String> = model.variables().map(|(_, variable)| variable.path.to_string()).collect();
        Fault::unknown(format!("variable of {}", model.name), name, known.iter().map(String::as_str))
    };
    let is_visible = |column: &usize| !model.table.at(*column).is_hidden;
    model.find(name).filter(is_visible).ok_or_else(unknown)
}

/// Results along the inputs.
pub fn follow(motion: &Motion) -> Result<Answer, Fault> {
    let model = motion.model()?;
    let mut instance = motion.instance(model)?;
    let (inputs, samples) = motion.inputs(model)?;
    if !(motion.dt > 0.0 && motion.dt.is_finite()) {
        return Err(Fault::value(format_args!("dt = {} s: must be > 0 and finite", motion.dt)));
    }
    let columns = motion.results(model)?;
    let mut values = vec![vec![0.0; samples]; columns.len()];
    let mut rows: Vec<&mut [f64]> = values.iter_mut().map(Vec::as_mut_slice).collect();
    let course = Course { inputs: &inputs, times: Times::Every(motion.dt), samples, between: Between::Linear };
    let cancel = AtomicBool::new(false);
    series::follow(&mut instance, &course, &columns, &mut rows, &cancel).map_err(Fault::value)?;
    Ok(motion.answer(model, &columns, values))
}

/// Settled results at each of the inputs.
pub fn settle(motion: &Motion) -> Result<Answer, Fault> {
    let model = motion.model()?;
    let (inputs, samples) = motion.inputs(model)?;
    let columns = motion.results(model)?;
    let mut values = vec![Vec::with_capacity(samples); columns.len()];
    let mut row = vec![0.0; columns.len()];
    let cancel = AtomicBool::new(false);
    for sample in 0..samples {
        let mut instance = motion.instance(model)?;
        let at = |input: &Input| input.samples[if input.samples.len() == 1 { 0 } else { sample }];
        let held: Vec<(usize, f64)> = inputs.iter().map(|input| (input.column, at(input))).collect();
        series::settle(&mut instance, &held, &columns, &mut row, &cancel).map_err(Fault::value)?;
        values.iter_mut().zip(&row).for_each(|(values, value)| values.push(*value));
    }
    Ok(motion.answer(model, &columns, values))
}
