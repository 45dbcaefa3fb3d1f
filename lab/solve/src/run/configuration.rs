//! A run as a user writes it: in a TOML file, on the command line, in Python.

use std::collections::BTreeMap;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::Settings;
use crate::system::{Fault, Setting, Source, System};

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
    /// As the text of a file.
    pub fn text(&self) -> String {
        toml::to_string(self).unwrap_or_else(|error| error.to_string())
    }

    /// Name of the system.
    pub fn name(&self) -> &str {
        self.system.as_deref().unwrap_or("belt")
    }

    /// Description of the system.
    pub fn source(&self) -> Result<Source, Fault> {
        Source::open(self.name())
    }

    /// The values of variables in it.
    pub fn values(&self) -> Vec<Setting> {
        let plain = |value: &toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        self.set.iter().map(|(name, value)| Setting { name: name.clone(), value: plain(value) }).collect()
    }

    /// How a system is run.
    pub fn settings(&self, system: &System) -> Result<Settings<'static>, Fault> {
        let mut settings = Settings::of(system);
        if let Some(name) = &self.solver {
            settings.solver = named("solver", name)?;
        }
        if let Some(name) = &self.exchange {
            settings.master.exchange = named("order of exchange", name)?;
        }
        settings.tolerance = self.tol.unwrap_or(settings.tolerance);
        settings.until = self.until.unwrap_or(settings.until);
        settings.every = self.every.unwrap_or(settings.every);
        settings.master.step = self.step.unwrap_or(settings.master.step);
        settings.master.jitter = self.jitter.unwrap_or(settings.master.jitter);
        settings.events = !self.no_events;
        Ok(settings)
    }

    /// The results to record: those that were asked for, or those that the system shows.
    pub fn results(&self, source: &Source) -> Vec<String> {
        if self.record.is_empty() { source.description.show.values().cloned().collect() } else { self.record.clone() }
    }
}

/// The choice of this name.
fn named<T: ValueEnum>(what: &str, name: &str) -> Result<T, Fault> {
    T::from_str(name, false).map_err(|_| {
        let known: Vec<String> = T::value_variants()
            .iter()
            .filter_map(|value| value.to_possible_value())
            .map(|value| value.get_name().to_owned())
            .collect();
        Fault::unknown(what, name, known.iter().map(String::as_str))
    })
}
