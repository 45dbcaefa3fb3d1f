//! A run as a user writes it: in a TOML file, on the command line, in Python.

use std::collections::BTreeMap;
use std::str::FromStr;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum};
use serde::{Deserialize, Serialize};
use ts_rs::TS;

use super::{Search, Settings, Solver, Step};
use crate::couple::Exchange;
use crate::job;
use crate::system::{Fault, Setting, Source, System};

/// Settings of a run. All are optional; the system provides those that are missing.
#[derive(Args, Clone, Debug, Default, Deserialize, PartialEq, Serialize, TS)]
#[ts(rename = "Run", optional_fields)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Configuration {
    /// Built-in system (see `stribeck systems`) or path of a system file (.toml)
    #[arg(long)]
    pub system: Option<String>,
    /// Friction law; several for `compare`
    #[arg(long, num_args = 1.., value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub law: Vec<String>,
    /// Solver
    #[arg(long, value_parser = PossibleValuesParser::new(words::<Solver>()))]
    pub solver: Option<String>,
    /// Relative and absolute tolerance (default 1e-8)
    #[arg(long)]
    pub tol: Option<f64>,
    /// End of the run in s
    #[arg(long)]
    pub until: Option<f64>,
    /// Interval of the results in s
    #[arg(long)]
    pub every: Option<f64>,
    /// Communication step of co-simulation in s (default 1e-3); `find` searches for the largest one that is close to
    /// the solution
    #[arg(long)]
    #[ts(optional, type = "number | \"find\"")]
    pub step: Option<Step>,
    /// Part by which co-simulation with the step that is found may differ from the solution (default 0.01)
    #[arg(long)]
    pub within: Option<f64>,
    /// Order of exchange in co-simulation
    #[arg(long, value_parser = PossibleValuesParser::new(words::<Exchange>()))]
    pub exchange: Option<String>,
    /// Largest random part by which a communication step differs from the others
    #[arg(long)]
    pub jitter: Option<f64>,
    /// Let steps extend across events instead of locating them
    #[arg(long)]
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub no_events: bool,
    /// Repeat the run at a tenth of its steps' tolerance (in co-simulation, of its step), and report the difference
    #[arg(long)]
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub check: bool,
    /// Results to record, such as rig.position or der(rig.block_velocity)
    #[arg(long, num_args = 1.., value_delimiter = ',')]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub record: Vec<String>,
    /// One run for each of n values of a variable
    #[arg(long, value_name = "NAME=FROM:TO:N", value_parser = Vary::checked, display_order = 1)]
    pub vary: Option<String>,
    /// Values of variables; the command line gives them one by one.
    #[arg(skip)]
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[ts(type = "Record<string, Value>")]
    pub set: BTreeMap<String, toml::Value>,
}

/// Largest number of runs of one command (chosen).
const MOST_RUNS: usize = 100_000;

/// Part by which a motion may differ from the solution (chosen).
const WITHIN: f64 = 0.01;

const IS_SEARCH: &str =
    "step = find: is a search and no run: `stribeck run --step find`, or stribeck.find_step in Python";

/// A variable and the values it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// The variable.
    pub name: String,
    /// Its values.
    pub values: Vec<f64>,
}

impl Vary {
    /// A text that can be read as one.
    fn checked(text: &str) -> Result<String, Fault> {
        text.parse::<Vary>().map(|_| text.to_owned())
    }
}

impl FromStr for Vary {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Vary, Fault> {
        let wrong = || Fault::value(format_args!("'{text}': must be name=from:to:n, with n from 2 to {MOST_RUNS}"));
        let (name, range) = text.split_once('=').ok_or_else(wrong)?;
        let parts: Vec<&str> = range.split(':').collect();
        let [from, to, count] = parts.as_slice() else { return Err(wrong()) };
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(wrong);
        let (from, to) = (number(from)?, number(to)?);
        let count: usize = count.trim().parse().map_err(|_| wrong())?;
        if !(2..=MOST_RUNS).contains(&count) {
            return Err(wrong());
        }
        let last = (count - 1) as f64;
        let values = (0..count).map(|at| from + (to - from) * at as f64 / last).collect();
        Ok(Vary { name: name.trim().to_owned(), values })
    }
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
        if self.step == Some(Step::Find) {
            return self.python_search(system, &mut entries);
        }
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

    /// A search for the communication step in Python.
    fn python_search(&self, system: toml::Value, entries: &mut toml::Table) -> Result<String, Fault> {
        if self.law.len() > 1 {
            return Err(Fault::value("step = find: in Python for one law at a time"));
        }
        entries.remove("step");
        entries.remove("solver");
        let laws = self.law.iter().map(|law| law.as_str().into());
        let begin: Vec<toml::Value> = std::iter::once(system).chain(laws).collect();
        Ok(format!("import stribeck\n\nfound = {}\n", job::python_call("stribeck.find_step", &begin, entries)))
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

    /// The system with each of the laws, or with its own, and its description. An error if a value is for none of them.
    pub fn systems(&self) -> Result<(Vec<System>, Source), Fault> {
        let (source, values) = (self.source()?, self.values());
        let assembled = |law| System::assemble(&source, law, &values);
        let systems = if self.law.is_empty() {
            vec![assembled(None)?]
        } else {
            self.law.iter().map(|law| assembled(Some(law))).collect::<Result<_, Fault>>()?
        };
        System::refuse_unused(&systems)?;
        Ok((systems, source))
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
        settings.master.step = match self.step {
            Some(Step::Of(step)) => step,
            Some(Step::Find) => return Err(Fault::value(IS_SEARCH)),
            None => settings.master.step,
        };
        if self.within.is_some() {
            return Err(Fault::value("within: is for step = find only"));
        }
        settings.master.jitter = self.jitter.unwrap_or(settings.master.jitter);
        settings.events = !self.no_events;
        settings.is_checked = self.check;
        Ok(settings)
    }

    /// How a search for the communication step runs the system, and what is searched for.
    pub fn search(&self, system: &System) -> Result<(Settings<'static>, Search), Fault> {
        let run = Configuration { step: None, within: None, ..self.clone() };
        let settings = run.settings(system)?;
        if settings.solver != Solver::CoSimulation {
            let solver = settings.solver;
            return Err(Fault::value(format_args!("solver {solver}: step = find is for co-simulation")));
        }
        if self.check {
            return Err(Fault::value("check: step = find compares with the solution anyway"));
        }
        let within = self.within.unwrap_or(WITHIN);
        if !(1e-4..=0.5).contains(&within) {
            return Err(Fault::value(format_args!("within = {within}: must be between 0.0001 and 0.5")));
        }
        let asked = self.exchange.is_some().then_some(settings.master.exchange);
        let exchanges = asked.map_or_else(|| Exchange::value_variants().to_vec(), |one| vec![one]);
        Ok((settings, Search { within, exchanges }))
    }

    /// The results to record: those that were asked for, or those that the system shows.
    pub fn results(&self, source: &Source) -> Vec<String> {
        if self.record.is_empty() { source.description.show.values().cloned().collect() } else { self.record.clone() }
    }
}

/// The choice of this name.
fn named<T: ValueEnum + 'static>(what: &str, name: &str) -> Result<T, Fault> {
    T::from_str(name, false).map_err(|_| {
        let known: Vec<PossibleValue> = words::<T>().collect();
        Fault::unknown(what, name, known.iter().map(PossibleValue::get_name))
    })
}

/// Names of the choices, with one line on each.
pub fn words<T: ValueEnum + 'static>() -> impl Iterator<Item = PossibleValue> {
    T::value_variants().iter().filter_map(T::to_possible_value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_written_for_the_command_line_and_for_python() {
        let run = |text: &str| toml::from_str::<Configuration>(text).unwrap();
        let one = run(
            "system = \"belt\"\nlaw = [\"LuGre\"]\nuntil = 15\ntol = 1e-7\ncheck = true\nset = { \"rig.mass\" = 1.5 }",
        );
        let command = "stribeck run --check --law LuGre --set rig.mass=1.5 --system belt --tol 1e-7 --until 15.0";
        assert_eq!(one.command().unwrap(), command);
        assert_eq!(
            one.python().unwrap(),
            "import stribeck\n\nsolution = stribeck.solve(\"belt\", \"LuGre\", check=True, set={\"rig.mass\": 1.5}, \
             tol=1e-7, until=15.0)\n"
        );
        let search = run("law = [\"LuGre\"]\nsolver = \"co-simulation\"\nstep = \"find\"\nwithin = 0.02");
        let command = "stribeck run --law LuGre --solver co-simulation --step find --within 0.02";
        assert_eq!(search.command().unwrap(), command);
        let python = "import stribeck\n\nfound = stribeck.find_step(\"belt\", \"LuGre\", within=0.02)\n";
        assert_eq!(search.python().unwrap(), python);
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

    #[test]
    fn a_step_is_a_number_or_a_search() {
        let run = |text: &str| toml::from_str::<Configuration>(text);
        for (text, step) in [("1e-3", Step::Of(1e-3)), ("1", Step::Of(1.0)), ("\"find\"", Step::Find)] {
            let read = run(&format!("step = {text}")).unwrap();
            assert_eq!((read.step, run(&read.text()).unwrap()), (Some(step), read));
        }
        let refused = run("step = \"soon\"").unwrap_err().to_string();
        assert!(refused.contains("step = soon: must be a number of seconds, or find"), "{refused}");
        let system = System::assemble(&Source::open("belt").unwrap(), None, &[]).unwrap();
        let refusal = |text: &str| {
            let run = run(text).unwrap();
            let searched = run.search(&system).unwrap_err().to_string();
            (run.settings(&system).map(|_| ()).unwrap_err().to_string(), searched)
        };
        let (run_refused, search_refused) = refusal("step = \"find\"");
        assert!(run_refused.starts_with("step = find: is a search and no run: "), "{run_refused}");
        assert_eq!(search_refused, "solver auto: step = find is for co-simulation");
        let (run_refused, search_refused) = refusal("within = 0.7\nsolver = \"co-simulation\"");
        assert_eq!(run_refused, "within: is for step = find only");
        assert_eq!(search_refused, "within = 0.7: must be between 0.0001 and 0.5");
    }
}
