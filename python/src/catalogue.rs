//! The models and their variables, as dictionaries.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck::catalogue::{Family, documented, models};
use stribeck::model::{ModelType, Variable};
use stribeck_solve::system::Fault;

use crate::refused;

/// The model of this name, or a refusal with the most similar name.
pub fn find(name: &str) -> PyResult<&'static ModelType> {
    let unknown = || refused(Fault::unknown("model", name, models().map(|model| model.name)));
    models().find(|model| model.name == name).ok_or_else(unknown)
}

/// The column of a variable, or a refusal with the most similar name.
pub fn column(model: &'static ModelType, name: &str) -> PyResult<usize> {
    let visible = || model.table.iter().filter(|variable| !variable.is_hidden);
    match model.find(name).filter(|column| !model.table.at(*column).is_hidden) {
        Some(column) => Ok(column),
        None => {
            let known: Vec<String> = visible().map(|variable| variable.path.to_string()).collect();
            let what = format!("variable of {}", model.name);
            Err(refused(Fault::unknown(what, name, known.iter().map(String::as_str))))
        }
    }
}

/// The name of a preset that exists, or a refusal with the most similar name.
pub fn preset<'a>(model: &'static ModelType, name: Option<&'a str>) -> PyResult<Option<&'a str>> {
    let known = || model.presets.iter().map(|preset| preset.name);
    match name {
        Some(name) if !known().any(|other| other == name) => {
            Err(refused(Fault::unknown(format!("preset of {}", model.name), name, known())))
        }
        _ => Ok(name),
    }
}

const FAMILIES: [(Family, &str); 4] = [
    (Family::Friction, "friction"),
    (Family::ShockAbsorber, "shock absorber"),
    (Family::Host, "host"),
    (Family::Component, "component"),
];

/// Name, family and one line on each model.
#[pyfunction]
pub fn names() -> Vec<(&'static str, &'static str, &'static str)> {
    let of = |(family, name): (Family, &'static str)| {
        documented(family).map(move |(model, _)| (model.name, name, model.summary))
    };
    FAMILIES.into_iter().flat_map(of).collect()
}

/// A model: its page, variables and presets.
#[pyfunction]
pub fn describe<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyDict>> {
    let model = find(name)?;
    let pages = FAMILIES.into_iter().flat_map(|(family, _)| documented(family));
    let page = pages.into_iter().find(|(other, _)| other.name == model.name).map_or("", |(_, page)| page);
    let described = PyDict::new(py);
    described.set_item("page", page)?;
    let visible = model.table.iter().filter(|variable| !variable.is_hidden);
    let variables = visible.map(|variable| as_dict(py, &variable)).collect::<PyResult<Vec<_>>>()?;
    described.set_item("variables", variables)?;
    let presets: Vec<_> =
        model.presets.iter().map(|preset| (preset.name, preset.source, preset.values.to_vec())).collect();
    described.set_item("presets", presets)?;
    Ok(described)
}

fn as_dict<'py>(py: Python<'py>, variable: &Variable) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("name", variable.path.to_string())?;
    dict.set_item("role", format!("{:?}", variable.role))?;
    let [kind, unit] = variable.kind.words();
    dict.set_item("kind", kind)?;
    dict.set_item("unit", unit)?;
    dict.set_item("display_unit", variable.display)?;
    dict.set_item("start", variable.start)?;
    dict.set_item("bound", variable.bound.to_string())?;
    dict.set_item("minimum", Some(variable.bound.min()).filter(|low| *low > f64::MIN))?;
    dict.set_item("maximum", Some(variable.bound.max()).filter(|high| *high < f64::MAX))?;
    dict.set_item("help", variable.help)?;
    let choices: Vec<(&str, &str)> = variable.kind.choices().iter().map(|item| (item.name, item.help)).collect();
    dict.set_item("choices", choices).map(|()| dict)
}
