//! Arguments that choose system, laws, values and solver.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, ValueEnum};
use stribeck_plot::picture::{self, Options, Theme};
use stribeck_plot::report::{self, Facts};
use stribeck_solve::couple::Exchange;
use stribeck_solve::run::{Configuration, Outcome, Settings, Solver};
use stribeck_solve::system::{Fault, Setting, Source, System, read};

use super::Failure;

/// Width of PNG pictures (chosen: a column of 85 mm at 600 dots per inch).
const PIXELS: u32 = 2000;

/// System, laws, values and solver of a run, and the files for its results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Built-in system (see `stribeck systems`) or path of a system file (.toml)
    #[arg(long)]
    system: Option<String>,
    /// Friction law; several for `compare`
    #[arg(long, num_args = 1.., value_delimiter = ',')]
    law: Vec<String>,
    /// Value of a variable: mass=2, or of one part: rig.mass=2
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// One run for each of n values of a variable
    #[arg(long, value_name = "NAME=FROM:TO:N")]
    vary: Option<Vary>,
    /// Solver
    #[arg(long, value_enum)]
    solver: Option<Solver>,
    /// Relative and absolute tolerance (default 1e-8)
    #[arg(long)]
    tol: Option<f64>,
    /// End of the run in s
    #[arg(long)]
    until: Option<f64>,
    /// Interval of the results in s
    #[arg(long)]
    every: Option<f64>,
    /// Communication step of co-simulation in s (default 1e-3)
    #[arg(long)]
    step: Option<f64>,
    /// Order of exchange in co-simulation
    #[arg(long, value_enum)]
    exchange: Option<Exchange>,
    /// Largest random part by which a communication step differs from the others
    #[arg(long)]
    jitter: Option<f64>,
    /// Let steps extend across events instead of locating them
    #[arg(long)]
    no_events: bool,
    /// Results to record, such as rig.position or der(rig.block_velocity)
    #[arg(long, num_args = 1.., value_delimiter = ',')]
    record: Vec<String>,
    /// File for the results (.csv)
    #[arg(long, short)]
    pub out: Option<PathBuf>,
    /// Folder for the pictures (SVG and PNG)
    #[arg(long, value_name = "FOLDER")]
    pub pictures: Option<PathBuf>,
    /// Dark pictures
    #[arg(long)]
    pub dark: bool,
    /// File for a report (.html)
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Print the outcome as JSON
    #[arg(long)]
    pub json: bool,
    /// Read all this from a TOML file; arguments take precedence
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Write what is run as a TOML file for --config
    #[arg(long, value_name = "FILE")]
    pub save_config: Option<PathBuf>,
}

/// A variable and the values it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// The variable.
    pub name: String,
    /// Its values.
    pub values: Vec<f64>,
    text: String,
}

/// Largest number of runs of one command (chosen).
const MOST_RUNS: usize = 100_000;

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
        Ok(Vary { name: name.trim().to_owned(), values, text: text.to_owned() })
    }
}

/// Choice of the user, from the command line and the file.
pub struct Choice {
    pub source: Source,
    pub laws: Vec<String>,
    pub settings: Vec<Setting>,
    pub vary: Option<Vary>,
    pub configuration: Configuration,
}

impl Arguments {
    /// The configuration: that of the file, with the arguments in it.
    fn configuration(&self) -> Result<Configuration, Failure> {
        let mut all = self.config.as_deref().map(read::<Configuration>).transpose()?.unwrap_or_default();
        let name = |value: &dyn ToString| Some(value.to_string());
        all.system = self.system.clone().or(all.system);
        all.solver = self.solver.as_ref().map_or(all.solver, |solver| name(solver));
        all.exchange = self
            .exchange
            .as_ref()
            .map_or(all.exchange, |exchange| exchange.to_possible_value().map(|value| value.get_name().to_owned()));
        all.vary = self.vary.as_ref().map_or(all.vary, |vary| Some(vary.text.clone()));
        all.tol = self.tol.or(all.tol);
        all.until = self.until.or(all.until);
        all.every = self.every.or(all.every);
        all.step = self.step.or(all.step);
        all.jitter = self.jitter.or(all.jitter);
        all.no_events |= self.no_events;
        if !self.law.is_empty() {
            all.law = self.law.clone();
        }
        if !self.record.is_empty() {
            all.record = self.record.clone();
        }
        for Setting { name, value } in &self.set {
            let number = value.parse::<f64>().map(toml::Value::Float);
            all.set.insert(name.clone(), number.unwrap_or_else(|_| toml::Value::String(value.clone())));
        }
        Ok(all)
    }

    /// The choice; writes it to a file if the user wants one.
    pub fn choice(&self) -> Result<Choice, Failure> {
        let configuration = self.configuration()?;
        if let Some(path) = &self.save_config {
            super::write(path, configuration.text())?;
        }
        Ok(Choice {
            source: configuration.source()?,
            laws: configuration.law.clone(),
            settings: configuration.values(),
            vary: configuration.vary.as_deref().map(Vary::from_str).transpose()?,
            configuration,
        })
    }
}

impl Choice {
    /// Name of the system.
    pub fn name(&self) -> &str {
        self.configuration.name()
    }

    /// The system with a law, or with its own, and with a value of the variable that varies.
    pub fn system(&self, law: Option<&str>, varied: Option<f64>) -> Result<System, Failure> {
        let mut settings = self.settings.clone();
        if let (Some(vary), Some(value)) = (&self.vary, varied) {
            settings.push(Setting { name: vary.name.clone(), value: value.to_string() });
        }
        Ok(System::assemble(&self.source, law, &settings)?)
    }

    /// How it is run.
    pub fn run_settings(&self, system: &System) -> Result<Settings<'static>, Failure> {
        Ok(self.configuration.settings(system)?)
    }

    /// The results to record.
    pub fn results(&self) -> Vec<String> {
        self.configuration.results(&self.source)
    }

    /// Pictures and report of the outcomes, each with its label and system.
    pub fn illustrate(&self, arguments: &Arguments, runs: Vec<(String, System, Outcome)>) -> Result<(), Failure> {
        let Some((_, system, _)) = runs.first() else { return Ok(()) };
        if (arguments.pictures.is_some() || arguments.report.is_some()) && !self.configuration.record.is_empty() {
            let text = "--record: pictures and reports show the results of the system; leave it out";
            return Err(Fault::value(text).into());
        }
        let (system, tolerance) = (system.clone(), self.configuration.tol.unwrap_or(1e-8));
        let (systems, outcomes): (Vec<System>, Vec<(String, Outcome)>) =
            runs.into_iter().map(|(label, system, outcome)| (system, (label, outcome))).unzip();
        if let Some(folder) = &arguments.pictures {
            let theme = if arguments.dark { Theme::Dark } else { Theme::Light };
            std::fs::create_dir_all(folder).map_err(|source| Failure::File { path: folder.clone(), source })?;
            for picture in picture::all(&system, &outcomes, &Options { theme, zoom: None }) {
                super::write(&folder.join(format!("{}.svg", picture.name())), &picture.svg)?;
                super::write(&folder.join(format!("{}.png", picture.name())), picture.png(PIXELS)?)?;
            }
        }
        if let Some(path) = &arguments.report {
            let toml = self.configuration.text();
            let command = if outcomes.len() > 1 { "stribeck compare" } else { "stribeck run" };
            let command = format!("{command} --config run.toml      # with this in run.toml:");
            let facts = Facts { systems: &systems, tolerance, command: &command, toml: &toml, ..Facts::default() };
            super::write(path, report::html(&system, &outcomes, &facts))?;
        }
        Ok(())
    }
}
