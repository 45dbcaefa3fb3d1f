//! Descriptions of systems, as TOML.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use stribeck::model::Brief;

use super::{Fault, Signal};

/// The systems that come with the program: name and description.
pub const BUILT_IN: &[(&str, &str)] = &[
    ("belt", include_str!("built_in/belt.toml")),
    ("belt-drive", include_str!("built_in/belt-drive.toml")),
    ("two-blocks", include_str!("built_in/two-blocks.toml")),
    ("incline", include_str!("built_in/incline.toml")),
    ("pulled-mass", include_str!("built_in/pulled-mass.toml")),
    ("spring-slider", include_str!("built_in/spring-slider.toml")),
    ("axis", include_str!("built_in/axis.toml")),
    ("servo-pendulum", include_str!("built_in/servo-pendulum.toml")),
    ("servo", include_str!("built_in/servo.toml")),
    ("motion", include_str!("built_in/motion.toml")),
    ("cylinder", include_str!("built_in/cylinder.toml")),
    ("dyno", include_str!("built_in/dyno.toml")),
    ("dyno-ramps", include_str!("built_in/dyno-ramps.toml")),
    ("quarter-car", include_str!("built_in/quarter-car.toml")),
    ("quarter-car-mount", include_str!("built_in/quarter-car-mount.toml")),
    ("four-post", include_str!("built_in/four-post.toml")),
];

/// A system as it is written down.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// One line.
    pub title: String,
    /// Where it comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub source: String,
    /// End of a run, in s.
    pub until: f64,
    /// Interval of the results, in s.
    pub every: f64,
    /// The parts by name.
    pub part: BTreeMap<String, PartDescription>,
    /// Inputs with the outputs they are connected to.
    #[serde(default)]
    pub connect: BTreeMap<String, String>,
    /// Inputs with their signals.
    #[serde(default)]
    pub input: BTreeMap<String, Signal>,
    /// Start values that follow another variable unless they are set.
    #[serde(default)]
    pub start: BTreeMap<String, String>,
    /// Parameters that a law for co-simulation takes from another part, such as the mass of the body it holds.
    #[serde(default)]
    pub hold: BTreeMap<String, String>,
    /// Choices of parts that contain a law, such as `strut.friction.model`.
    #[serde(default, rename = "choose-law")]
    pub choose_law: Vec<String>,
    /// Values for single laws.
    #[serde(default)]
    pub law: BTreeMap<String, BTreeMap<String, Value>>,
    /// Quantities of the usual pictures, with the variables that have them.
    #[serde(default)]
    pub show: BTreeMap<String, String>,
}

/// A part of a system.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PartDescription {
    /// Its model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// For a part that any friction law can be: the law if no other one is chosen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub law: Option<String>,
    /// Preset of parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Values of variables.
    #[serde(default)]
    pub set: BTreeMap<String, Value>,
}

/// A value of a variable.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// True or false.
    Truth(bool),
    /// A number.
    Number(f64),
    /// The name of a choice.
    Choice(String),
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Value::Truth(value) => value.fmt(f),
            Value::Number(value) => value.fmt(f),
            Value::Choice(value) => value.fmt(f),
        }
    }
}

/// A description with the folder to which its file names are relative.
#[derive(Clone, Debug)]
pub struct Source {
    /// The description.
    pub description: Description,
    /// The folder.
    pub folder: PathBuf,
}

impl Source {
    /// A built-in system by its name, or a system file by its path.
    pub fn open(name: &str) -> Result<Source, Fault> {
        if let Some((_, text)) = BUILT_IN.iter().find(|(known, _)| *known == name) {
            return Ok(Source { description: Description::parse(text)?, folder: PathBuf::new() });
        }
        let path = Path::new(name);
        if path.extension().is_none() {
            return Err(Fault::unknown("system", name, BUILT_IN.iter().map(|(known, _)| *known)));
        }
        let text = std::fs::read_to_string(path).map_err(|error| spoilt(path, error))?;
        let description = Description::parse(&text).map_err(|error| spoilt(path, error))?;
        Ok(Source { description, folder: path.parent().unwrap_or(Path::new("")).to_owned() })
    }
}

/// Reads a TOML file.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, Fault> {
    let text = std::fs::read_to_string(path).map_err(|error| spoilt(path, error))?;
    toml::from_str(&text).map_err(|error| spoilt(path, error.to_string().trim_end()))
}

/// Fault of a file.
fn spoilt(path: &Path, error: impl std::fmt::Display) -> Fault {
    Fault::File(format!("{}: {error}", path.display()))
}

impl Description {
    /// Reads a description.
    pub fn parse(text: &str) -> Result<Description, Fault> {
        let description: Description =
            toml::from_str(text).map_err(|error| Fault::File(error.to_string().trim_end().to_owned()))?;
        for (name, value) in [("until", description.until), ("every", description.every)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Fault::value(format_args!("{name} = {} s: must be > 0 and finite", Brief(value))));
            }
        }
        Ok(description)
    }

    /// Whether the system has a place for a friction law: a part that can be any, or parts that contain one.
    pub fn takes_laws(&self) -> bool {
        !self.choose_law.is_empty() || self.part.values().any(|part| part.law.is_some())
    }
}
