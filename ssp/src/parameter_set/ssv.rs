//! The parameter set of SSP 1.0 (System Structure and Parameterization, section "System Structure Parameter Values").

use quick_xml::events::Event;
use quick_xml::reader::Reader;
use serde::{Deserialize, Serialize};
use stribeck::model::{Kind, ModelType, Variable};

use super::{ParameterSet, SetError, settable, text_of, unit_name, value_of};
use crate::units::{Units, unit_of};
use crate::xml::{self, COMMON};

const VALUES: &str = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";
const VERSION: &str = "1.0";

/// The file. It is read whatever its prefixes are, and written with those of the standard, for which libcosim and Ecos
/// look.
#[derive(Serialize, Deserialize)]
#[serde(rename(serialize = "ssv:ParameterSet", deserialize = "ParameterSet"))]
struct Document {
    #[serde(rename = "@xmlns:ssv", skip_deserializing)]
    values: &'static str,
    #[serde(rename = "@xmlns:ssc", skip_deserializing)]
    common: &'static str,
    #[serde(rename = "@version")]
    version: String,
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename(serialize = "ssv:Parameters", deserialize = "Parameters"))]
    parameters: Parameters,
    #[serde(rename = "ssv:Units", skip_deserializing, skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
}

#[derive(Serialize, Deserialize)]
struct Parameters {
    #[serde(rename(serialize = "ssv:Parameter", deserialize = "Parameter"), default)]
    parameters: Vec<Parameter>,
}

#[derive(Serialize, Deserialize)]
struct Parameter {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@description", skip_deserializing, skip_serializing_if = "String::is_empty")]
    description: String,
    #[serde(rename = "$value")]
    value: Value,
}

#[derive(Serialize, Deserialize)]
enum Value {
    #[serde(rename(serialize = "ssv:Real", deserialize = "Real"))]
    Real(Number),
    #[serde(rename(serialize = "ssv:Integer", deserialize = "Integer"))]
    Integer(Number),
    #[serde(rename(serialize = "ssv:Boolean", deserialize = "Boolean"))]
    Boolean(Number),
    #[serde(rename(serialize = "ssv:Enumeration", deserialize = "Enumeration"))]
    Enumeration(Number),
}

#[derive(Serialize, Deserialize)]
struct Number {
    #[serde(rename = "@value")]
    value: String,
    #[serde(rename = "@unit", default, skip_serializing_if = "String::is_empty")]
    unit: String,
}

pub fn write(set: &ParameterSet) -> String {
    let units = set.values().filter_map(|(variable, _)| unit_of(&variable));
    xml::text(&Document {
        values: VALUES,
        common: COMMON,
        version: VERSION.to_owned(),
        name: set.name().to_owned(),
        parameters: Parameters {
            parameters: set.values().map(|(variable, value)| parameter(&variable, value)).collect(),
        },
        units: Units::of(units),
    })
}

fn parameter(variable: &Variable, value: f64) -> Parameter {
    let number = |value: String| Number { value, unit: unit_name(variable).to_owned() };
    let mut description = String::new();
    let value = match variable.kind {
        Kind::Real(_) => Value::Real(number(value.to_string())),
        Kind::Integer => Value::Integer(number(value.to_string())),
        Kind::Boolean => Value::Boolean(number(text_of(variable, value))),
        // FMI 2.0 sets choices by their number, and libcosim and Ecos reject a file with an ssv:Enumeration.
        Kind::Enumeration(_) => {
            description = text_of(variable, value);
            Value::Integer(number(value.to_string()))
        }
    };
    Parameter { name: variable.path.to_string(), description, value }
}

pub fn read(model: &'static ModelType, text: &str) -> Result<ParameterSet, SetError> {
    let root = root_name(text).map_err(|error| SetError::Ssv(error.to_string()))?;
    if root != "ParameterSet" {
        return Err(SetError::Ssv(format!("the root is '{root}', must be ParameterSet")));
    }
    let document: Document = quick_xml::de::from_str(text).map_err(|error| SetError::Ssv(error.to_string()))?;
    if document.version != VERSION {
        return Err(SetError::Ssv(format!("version '{}', must be {VERSION}", document.version)));
    }
    let mut values = Vec::new();
    for parameter in document.parameters.parameters {
        let column = settable(model, &parameter.name)?;
        let variable = &model.table.at(column);
        let (element, Number { value, unit }) = match parameter.value {
            Value::Real(number) => ("Real", number),
            Value::Integer(number) => ("Integer", number),
            Value::Boolean(number) => ("Boolean", number),
            Value::Enumeration(number) => ("Enumeration", number),
        };
        let fits = match variable.kind {
            Kind::Real(_) => element == "Real",
            Kind::Integer => element == "Integer",
            Kind::Boolean => element == "Boolean",
            Kind::Enumeration(_) => ["Enumeration", "Integer"].contains(&element),
        };
        if !fits {
            return Err(SetError::Ssv(format!("{} is not of type {element}", parameter.name)));
        }
        values.push((column, value_of(variable, value.trim(), &unit)?));
    }
    ParameterSet::of_columns(model, &document.name, values)
}

/// Local name of the root element, which the deserializer does not check.
fn root_name(text: &str) -> Result<String, quick_xml::Error> {
    let mut reader = Reader::from_str(text);
    loop {
        match reader.read_event()? {
            Event::Start(tag) | Event::Empty(tag) => {
                return Ok(tag.local_name().as_ref().to_owned());
            }
            Event::Eof => return Ok(String::new()),
            _ => {}
        }
    }
}
