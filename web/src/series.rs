//! Single models: their results at held inputs and along samples of inputs.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use stribeck::catalogue;
use stribeck::instance::Instance;
use stribeck::model::ModelType;
use stribeck::series::{Between, Course, Input, Times, follow, set_up, settle};
use stribeck_solve::system::{Fault, spelled};

use crate::values::texts;

/// A model, values of its parameters, and samples of its inputs.
#[derive(Debug)]
pub struct Series {
    /// Name of the model.
    pub model: String,
    /// Values of its parameters.
    pub set: BTreeMap<String, toml::Value>,
    /// Inputs: one value, or one per sample.
    pub inputs: BTreeMap<String, Vec<f64>>,
    /// Names of the results.
    pub results: Vec<String>,
}

impl Series {
    /// The model.
    pub fn model(&self) -> Result<&'static ModelType, Fault> {
        let known = || catalogue::models().map(|model| model.name);
        catalogue::by_name(&self.model).ok_or_else(|| Fault::unknown("model", &self.model, known()))
    }

    fn columns<'a>(&self, names: impl Iterator<Item = &'a String>) -> Result<Vec<usize>, Fault> {
        let model = self.model()?;
        names.map(|name| column(model, name)).collect()
    }

    /// Columns and values of the parameters.
    pub fn parameters(&self) -> Result<Vec<(usize, f64)>, Fault> {
        let model = self.model()?;
        let value = |(name, text): (String, String)| {
            let column = column(model, &name)?;
            Ok((column, spelled(&model.table.at(column), &text)?))
        };
        texts(&self.set).map(value).collect()
    }

    fn samples(&self) -> Result<usize, Fault> {
        let longest = self.inputs.values().map(Vec::len).max().unwrap_or(0);
        match self.inputs.iter().find(|(_, values)| values.len() != 1 && values.len() != longest) {
            Some((name, values)) => {
                Err(Fault::value(format_args!("{name} has {} samples: must have 1 or {longest}", values.len())))
            }
            None => Ok(longest),
        }
    }
}

fn column(model: &'static ModelType, name: &str) -> Result<usize, Fault> {
    let known: Vec<String> = model.variables().map(|(_, variable)| variable.path.to_string()).collect();
    let unknown = || Fault::unknown(format!("variable of {}", model.name), name, known.iter().map(String::as_str));
    model.find(name).ok_or_else(unknown)
}

/// Results at held inputs, once they have settled; each sample begins anew.
pub fn settled(series: &Series) -> Result<Vec<Vec<f64>>, Fault> {
    let (inputs, results) = (series.columns(series.inputs.keys())?, series.columns(series.results.iter())?);
    let parameters = series.parameters()?;
    let samples = series.samples()?;
    let mut instance = Instance::new(series.model()?);
    let mut rows = vec![Vec::with_capacity(samples); results.len()];
    let mut values = vec![0.0; results.len()];
    for sample in 0..samples {
        instance.reset();
        set_up(&mut instance, &parameters).map_err(Fault::value)?;
        let at = |values: &Vec<f64>| values[if values.len() == 1 { 0 } else { sample }];
        let held: Vec<(usize, f64)> = inputs.iter().copied().zip(series.inputs.values().map(at)).collect();
        settle(&mut instance, &held, &results, &mut values, &AtomicBool::new(false)).map_err(Fault::value)?;
        rows.iter_mut().zip(&values).for_each(|(row, value)| row.push(*value));
    }
    Ok(rows)
}

/// Results along samples `every` seconds apart.
pub fn followed(series: &Series, every: f64) -> Result<Vec<Vec<f64>>, Fault> {
    if !(every > 0.0 && every.is_finite()) {
        return Err(Fault::value(format_args!("every = {every} s: must be > 0 and finite")));
    }
    let (inputs, results) = (series.columns(series.inputs.keys())?, series.columns(series.results.iter())?);
    let samples = series.samples()?;
    let mut instance = Instance::new(series.model()?);
    set_up(&mut instance, &series.parameters()?).map_err(Fault::value)?;
    let inputs = inputs.iter().zip(series.inputs.values()).map(|(column, samples)| Input { column: *column, samples });
    let inputs: Vec<Input> = inputs.collect();
    let course = Course { inputs: &inputs, times: Times::Every(every), samples, between: Between::Linear };
    let mut rows = vec![vec![0.0; samples]; results.len()];
    let mut places: Vec<&mut [f64]> = rows.iter_mut().map(Vec::as_mut_slice).collect();
    follow(&mut instance, &course, &results, &mut places, &AtomicBool::new(false)).map_err(Fault::value)?;
    Ok(rows)
}
