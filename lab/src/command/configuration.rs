//! What is run, as a TOML file: the same as on the command line.

use std::collections::BTreeMap;
use std::path::Path;

use lab::system::{Fault, Setting};
use serde::{Deserialize, Serialize};

use super::Failure;

/// Settings of a run. All are optional; the system provides those that are missing.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Configuration {
    /// Name of a built-in system, or path of a system file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub system: Option<String>,
    /// Friction laws.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub law: Vec<String>,
    /// Solver.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub solver: Option<String>,
    /// Relative and absolute tolerance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tol: Option<f64>,
    /// End of the run in s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// Interval of the results in s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub every: Option<f64>,
    /// Communication step in s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// Order of exchange.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exchange: Option<String>,
    /// Random part of the communication step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jitter: Option<f64>,
    /// Whether steps extend across events.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub no_events: bool,
    /// Results.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub record: Vec<String>,
    /// A variable and its values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vary: Option<String>,
    /// Values of variables.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub set: BTreeMap<String, toml::Value>,
}

impl Configuration {
    /// Reads a file.
    pub fn load(path: &Path) -> Result<Configuration, Failure> {
        let text = std::fs::read_to_string(path).map_err(|source| Failure::File { path: path.into(), source })?;
        let wrong =
            |error: toml::de::Error| Fault::File(format!("{}: {}", path.display(), error.to_string().trim_end()));
        Ok(toml::from_str(&text).map_err(wrong)?)
    }

    /// As the text of a file.
    pub fn text(&self) -> String {
        toml::to_string(self).unwrap_or_else(|error| error.to_string())
    }

    /// The settings in it.
    pub fn settings(&self) -> Vec<Setting> {
        let plain = |value: &toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        self.set.iter().map(|(name, value)| Setting { name: name.clone(), value: plain(value) }).collect()
    }
}
