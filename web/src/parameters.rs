//! Parameter sets for FMUs.

use std::collections::BTreeMap;

use ssp::parameter_set::ParameterSet;
use stribeck::catalogue;
use stribeck_solve::system::{Fault, spelled};

use crate::answer::{Answer, Text};
use crate::values::texts;

/// The parameter set of a model as a file for SSP (.ssv).
pub fn ssv(model: &str, set: &BTreeMap<String, toml::Value>) -> Result<Answer, Fault> {
    let known = || catalogue::models().map(|model| model.name);
    let model = catalogue::by_name(model).ok_or_else(|| Fault::unknown("model", model, known()))?;
    let all: Vec<String> = model.variables().map(|(_, variable)| variable.path.to_string()).collect();
    let value = |(name, text): (String, String)| {
        let unknown = || Fault::unknown(format!("variable of {}", model.name), &name, all.iter().map(String::as_str));
        let column = model.find(&name).ok_or_else(unknown)?;
        let value = spelled(&model.table.at(column), &text)?;
        Ok((name, value))
    };
    let values = texts(set).map(value).collect::<Result<Vec<(String, f64)>, Fault>>()?;
    let set = ParameterSet::new(model, model.name, values).map_err(Fault::value)?;
    Ok(Answer::plain(Text { text: set.to_ssv() }))
}
