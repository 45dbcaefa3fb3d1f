//! A run as a user writes it: in a TOML file, on the command line, in Python.

use std::collections::BTreeMap;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

use super::Settings;
use crate::job;
use crate::system::{Fault, Setting, Source, System};

/// Settings of a run. All are optional; the system provides those that are missing.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize, TS)]
#[ts(rename = "Run", optional_fields)]
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
    #[ts(type = "Record<string, Value>")]
    pub set: BTreeMap<String, toml::Value>,
}

impl Configuration {
    /// As the text of a file.
    pub fn text(&self) -> String {
        toml::to_string(self).unwrap_or_else(|error| error.to_string())
    }

    /// The same as a command line.
    pub fn command(&self) -> Result<String, Fault> {
        let word = if self.law.len() > 1 { "compare" } else { "run" };
        job::command_line(&["stribeck", word], &job::entries(self)?)
    }

    /// The same in Python.
    pub fn python(&self) -> Result<String, Fault> {
        let mut entries = job::entries(self)?;
        let system = entries.remove("system").unwrap_or_else(|| self.name().into());
        if entries.remove("no-events").is_some() {
            entries.insert("events".to_owned(), false.into());
        }
        entries.remove("law");
        let (function, laws) = match self.law.as_slice() {
            [] => ("solve", None),
            [law] => ("solve", Some(law.as_str().into())),
            laws => ("compare", Some(laws.to_vec().into())),
        };
        let begin: Vec<toml::Value> = std::iter::once(system).chain(laws).collect();
        let call = job::python_call(&format!("stribeck.{function}"), &begin, &entries);
        let result = if function == "solve" { "solution" } else { "solutions" };
        Ok(format!("import stribeck\n\n{result} = {call}\n"))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_written_for_the_command_line_and_for_python() {
        let run = |text: &str| toml::from_str::<Configuration>(text).unwrap();
        let one = run("system = \"belt\"\nlaw = [\"LuGre\"]\nuntil = 15\ntol = 1e-7\nset = { \"rig.mass\" = 1.5 }");
        let command = "stribeck run --law LuGre --set rig.mass=1.5 --system belt --tol 1e-7 --until 15.0";
        assert_eq!(one.command().unwrap(), command);
        assert_eq!(
            one.python().unwrap(),
            "import stribeck\n\nsolution = stribeck.solve(\"belt\", \"LuGre\", set={\"rig.mass\": 1.5}, tol=1e-7, \
             until=15.0)\n"
        );
        let several = run("law = [\"LuGre\", \"Dahl\"]\nno-events = true\nset = { curve = \"Tustin\", flag = true }");
        assert_eq!(
            several.command().unwrap(),
            "stribeck compare --law LuGre --law Dahl --no-events --set curve=Tustin --set flag=true"
        );
        assert_eq!(
            several.python().unwrap(),
            "import stribeck\n\nsolutions = stribeck.compare(\"belt\", [\"LuGre\", \"Dahl\"], events=False, \
             set={\"curve\": \"Tustin\", \"flag\": True})\n"
        );
    }
}
