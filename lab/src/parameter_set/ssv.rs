//! The parameter set of SSP 1.0 (System Structure and Parameterization, section "System Structure Parameter Values").

use std::collections::BTreeMap;

use quick_xml::escape::escape;
use quick_xml::events::Event;
use quick_xml::reader::Reader;
use serde::Deserialize;
use stribeck::model::{Kind, ModelType};
use stribeck::unit::Unit;

use super::{ParameterSet, SetError, settable, text_of, value_of};

const VALUES: &str = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";
const COMMON: &str = "http://ssp-standard.org/SSP1/SystemStructureCommon";

pub fn write(set: &ParameterSet) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <ssv:ParameterSet xmlns:ssv=\"{VALUES}\" xmlns:ssc=\"{COMMON}\" version=\"1.0\" name=\"{}\">\n\
         \x20 <ssv:Parameters>\n",
        escape(set.name()),
    );
    let mut units = BTreeMap::new();
    for (variable, value) in set.values() {
        let mut description = String::new();
        let element = match variable.kind {
            Kind::Real(unit) => {
                units.insert(unit.name, unit);
                format!("Real value=\"{value}\" unit=\"{}\"", unit.name)
            }
            Kind::Integer => format!("Integer value=\"{value}\""),
            Kind::Boolean => format!("Boolean value=\"{}\"", text_of(variable, value)),
            // FMI 2.0 sets choices by their number, and libcosim and Ecos reject a file with an ssv:Enumeration.
            Kind::Enumeration(_) => {
                description = format!(" description=\"{}\"", text_of(variable, value));
                format!("Integer value=\"{value}\"")
            }
        };
        let name = variable.path;
        text += &format!("    <ssv:Parameter name=\"{name}\"{description}><ssv:{element}/></ssv:Parameter>\n");
    }
    text += "  </ssv:Parameters>\n";
    if !units.is_empty() {
        let units: String = units.values().map(|unit| unit_definition(unit)).collect();
        text += &format!("  <ssv:Units>\n{units}  </ssv:Units>\n");
    }
    text + "</ssv:ParameterSet>\n"
}

/// A unit as a product of powers of base units, as SSP writes it.
pub fn unit_definition(unit: &Unit) -> String {
    let base: String = unit.base_units().map(|(name, exponent)| format!(" {name}=\"{exponent}\"")).collect();
    format!("    <ssc:Unit name=\"{}\"><ssc:BaseUnit{base}/></ssc:Unit>\n", unit.name)
}

#[derive(Deserialize)]
#[serde(rename = "ParameterSet")]
struct Document {
    #[serde(rename = "@version")]
    version: String,
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "Parameters")]
    parameters: Parameters,
}

#[derive(Deserialize)]
struct Parameters {
    #[serde(rename = "Parameter", default)]
    parameters: Vec<Parameter>,
}

#[derive(Deserialize)]
struct Parameter {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "$value")]
    value: Value,
}

#[derive(Deserialize)]
enum Value {
    Real(Number),
    Integer(Number),
    Boolean(Number),
    Enumeration(Number),
}

#[derive(Deserialize)]
struct Number {
    #[serde(rename = "@value")]
    value: String,
    #[serde(rename = "@unit", default)]
    unit: String,
}

pub fn read(model: &'static ModelType, text: &str) -> Result<ParameterSet, SetError> {
    let root = root_name(text).map_err(|error| SetError::Ssv(error.to_string()))?;
    if root != "ParameterSet" {
        return Err(SetError::Ssv(format!("the root is '{root}', must be ParameterSet")));
    }
    let document: Document = quick_xml::de::from_str(text).map_err(|error| SetError::Ssv(error.to_string()))?;
    if document.version != "1.0" {
        return Err(SetError::Ssv(format!("version '{}', must be 1.0", document.version)));
    }
    let mut values = Vec::new();
    for parameter in document.parameters.parameters {
        let column = settable(model, &parameter.name)?;
        let variable = &model.table[column];
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
