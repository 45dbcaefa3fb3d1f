//! Runs that the user chooses by arguments: system, laws, values and solver.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Map, Value, json};
use stribeck_plot::picture::{self, Options, Theme};
use stribeck_plot::report::{self, Facts};
use stribeck_solve::job;
use stribeck_solve::run::{Check, Column, Configuration, Difference, Outcome, Settings, Vary, run};
use stribeck_solve::solve::{End, Statistics};
use stribeck_solve::system::{Fault, Setting, Source, System, read};

use super::watch::{Bar, CANCELLED};
use super::{Failure, Verdict};

/// System, laws, values and solver of a run, and the files for its results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    run: Configuration,
    /// Value of a variable: mass=2, or of one part: rig.mass=2
    #[arg(long, value_name = "NAME=VALUE", display_order = 1)]
    set: Vec<Setting>,
    /// File for the results (.csv)
    #[arg(long, short)]
    out: Option<PathBuf>,
    /// Folder for the pictures (SVG and PNG)
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    /// Dark pictures
    #[arg(long)]
    dark: bool,
    /// File for a report (.html)
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Print the outcome as JSON
    #[arg(long)]
    json: bool,
    /// Read all this from a TOML file; arguments take precedence
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Write what is run as a TOML file for --config
    #[arg(long, value_name = "FILE")]
    save_config: Option<PathBuf>,
}

impl Arguments {
    /// The configuration: that of the file, with the arguments in it.
    fn configuration(&self) -> Result<Configuration, Failure> {
        let mut given = self.run.clone();
        for Setting { name, value } in &self.set {
            let number = value.parse().map(toml::Value::Float);
            given.set.insert(name.clone(), number.unwrap_or_else(|_| value.as_str().into()));
        }
        match &self.config {
            Some(path) => Ok(job::given_over(&given, &read(path)?)?),
            None => Ok(given),
        }
    }

    /// The choice; writes it to a file if the user wants one.
    pub fn choice(&self) -> Result<Choice<'_>, Failure> {
        let run = self.configuration()?;
        if let Some(path) = &self.save_config {
            super::write(path, run.text())?;
        }
        let vary = run.vary.as_deref().map(str::parse).transpose()?;
        Ok(Choice { source: run.source()?, settings: run.values(), vary, run, arguments: self })
    }
}

/// Choice of the user, from the command line and the file.
pub struct Choice<'a> {
    source: Source,
    settings: Vec<Setting>,
    arguments: &'a Arguments,
    pub vary: Option<Vary>,
    pub run: Configuration,
}

/// A run and what came of it, with the value of the variable that varies.
struct Ran {
    value: Option<f64>,
    system: System,
    outcome: Outcome,
}

impl Choice<'_> {
    /// The system with a law, or with its own, and with a value of the variable that varies.
    pub fn system(&self, law: Option<&str>, varied: Option<f64>) -> Result<System, Fault> {
        let mut settings = self.settings.clone();
        if let (Some(vary), Some(value)) = (&self.vary, varied) {
            settings.push(Setting { name: vary.name.clone(), value: value.to_string() });
        }
        System::assemble(&self.source, law, &settings)
    }

    /// Runs the systems until the user ends it, and writes and prints the results. The value or law by which
    /// the runs differ has a column of this name.
    pub fn conclude(&self, systems: Vec<System>, column: Option<&str>) -> Result<Verdict, Failure> {
        let all = self.outcomes(systems)?;
        if let Some(path) = &self.arguments.out {
            let failed = |source| Failure::File { path: path.clone(), source };
            let file = std::fs::File::create(path).map_err(failed)?;
            table(&all, column, std::io::BufWriter::new(file)).map_err(failed)?;
        }
        if self.arguments.json {
            let runs: Vec<Value> = all.iter().map(|one| self.as_json(one)).collect();
            println!("{}", json!({ "runs": runs }));
        } else {
            for one in &all {
                println!("{}", self.line(one));
                one.outcome.check.iter().for_each(print_check);
            }
        }
        let verdict = all.iter().map(Ran::verdict).max().unwrap_or(Verdict::Done);
        self.illustrate(all)?;
        Ok(verdict)
    }

    /// The results to record.
    pub fn results(&self) -> Vec<String> {
        self.run.results(&self.source)
    }

    /// Whether results, pictures or a report are to be written.
    pub fn writes_files(&self) -> bool {
        let Arguments { out, pictures, report, .. } = self.arguments;
        out.is_some() || pictures.is_some() || report.is_some()
    }

    /// Whether the outcome is to be printed as JSON.
    pub fn is_json(&self) -> bool {
        self.arguments.json
    }

    fn outcomes(&self, systems: Vec<System>) -> Result<Vec<Ran>, Failure> {
        let results = self.results();
        let (runs, mut all, mut bar) = (systems.len(), Vec::new(), None);
        for (number, system) in systems.into_iter().enumerate() {
            let settings = self.run.settings(&system)?;
            let bar = bar.get_or_insert_with(|| Bar::new(runs, settings.until));
            bar.begin(number, system.law.map_or("", |law| law.name));
            let settings = Settings { cancel: Some(&CANCELLED), progress: Some(&*bar), ..settings };
            let outcome = run(&system, &settings, &results)?;
            let value = self.vary.as_ref().map(|vary| vary.values[number]);
            all.push(Ran { value, system, outcome });
            if all.last().is_some_and(|one| one.verdict() == Verdict::Cancelled) {
                break;
            }
        }
        bar.iter().for_each(Bar::finish);
        Ok(all)
    }

    /// The value of the variable that varies.
    fn varied(&self, one: &Ran) -> Option<(&str, f64)> {
        Some((self.vary.as_ref()?.name.as_str(), one.value?))
    }

    /// The law of a run; the system, if that has none to choose.
    fn law(&self, outcome: &Outcome) -> &str {
        outcome.law.map_or_else(|| self.run.name(), |law| law.name)
    }

    /// Name of a run in the pictures.
    fn label(&self, one: &Ran) -> String {
        let varied = self.varied(one).map(|(name, value)| format!("{name} = {value}"));
        varied.unwrap_or_else(|| self.law(&one.outcome).to_owned())
    }

    /// One line on a run.
    fn line(&self, one: &Ran) -> String {
        let Outcome { end, solver, events, elapsed, .. } = &one.outcome;
        let Statistics { steps, rejected, evaluations, .. } = &one.outcome.statistics;
        let varied = self.varied(one).map_or(String::new(), |(name, value)| format!(" {name} = {value}"));
        format!(
            "{}{varied}: {end}; {solver}, steps: {steps}, rejected: {rejected}, evaluations: {evaluations}, events: \
             {}, {:.3} s",
            self.law(&one.outcome),
            events.len(),
            elapsed.as_secs_f64()
        )
    }

    /// A run as JSON; the results are arrays.
    fn as_json(&self, one: &Ran) -> Value {
        let varied = self.varied(one).map(|(name, value)| json!({ "name": name, "value": value }));
        let Outcome { law, solver, time, columns, end, statistics, events, elapsed, check } = &one.outcome;
        let result = |column: &Column| (column.name.clone(), json!({ "unit": column.unit, "values": column.values }));
        json!({
            "law": law.map(|law| law.name),
            "varied": varied,
            "solver": solver.to_string(),
            "end": end.to_string(),
            "reached": end.is_reached(),
            "steps": statistics.steps,
            "rejected": statistics.rejected,
            "evaluations": statistics.evaluations,
            "jacobians": statistics.jacobians,
            "events": events,
            "seconds": elapsed.as_secs_f64(),
            "check": check,
            "time": time,
            "results": columns.iter().map(result).collect::<Map<String, Value>>(),
        })
    }

    /// Pictures and report of the runs.
    fn illustrate(&self, runs: Vec<Ran>) -> Result<(), Failure> {
        let Arguments { pictures, report, dark, .. } = self.arguments;
        if (pictures.is_some() || report.is_some()) && !self.run.record.is_empty() {
            let text = "--record: pictures and reports show the results of the system; leave it out";
            return Err(Fault::value(text).into());
        }
        let (systems, outcomes): (Vec<System>, Vec<(String, Outcome)>) = runs
            .into_iter()
            .map(|one| (self.label(&one), one))
            .map(|(label, one)| (one.system, (label, one.outcome)))
            .unzip();
        if let Some(folder) = pictures {
            let theme = if *dark { Theme::Dark } else { Theme::Light };
            super::folder(folder)?;
            for picture in picture::all(&systems[0], &outcomes, &Options { theme, zoom: None }) {
                super::draw(&picture, &folder.join(picture.name()))?;
            }
        }
        report.as_ref().map_or(Ok(()), |path| super::write(path, self.report(&systems, &outcomes)))
    }

    fn report(&self, systems: &[System], outcomes: &[(String, Outcome)]) -> String {
        let command = if outcomes.len() > 1 { "stribeck compare" } else { "stribeck run" };
        let command = format!("{command} --config run.toml      # with this in run.toml:");
        let (tolerance, toml) = (self.run.tol.unwrap_or(1e-8), self.run.text());
        let facts = Facts { systems, tolerance, command: &command, toml: &toml, ..Facts::default() };
        report::html(&systems[0], outcomes, &facts)
    }
}

impl Ran {
    fn verdict(&self) -> Verdict {
        let end = self.outcome.check.as_ref().map_or(&self.outcome.end, |check| &check.end);
        match end {
            End::Cancelled { .. } => Verdict::Cancelled,
            _ if self.outcome.fault().is_some() => Verdict::Diverged,
            _ => Verdict::Done,
        }
    }

    /// Law or value that distinguishes this run from the others.
    fn what(&self) -> String {
        self.value.map_or_else(|| self.outcome.law.map_or("", |law| law.name).to_owned(), |value| value.to_string())
    }
}

/// Prints a check: the difference of each result from the finer run, and whether the tolerance holds.
fn print_check(check: &Check) {
    println!("  {} differs by at most", check.of.run(check.finer));
    let width = check.differences.iter().map(|one| one.name.len()).max().unwrap_or(0);
    for one in &check.differences {
        let Difference { name, unit, largest, part, .. } = one;
        let (unit, time) = (if unit == "1" { "" } else { unit }, one.shown_time());
        println!("    {name:<width$}  {largest:9.2e} {unit:<5} {part:8.1e} of its range, at {time} s");
    }
    if let Some(fault) = &check.fault {
        println!("  {fault}");
    }
}

/// The results of all runs, one below the other, with what differs between them in the first column if that has a name.
fn table(runs: &[Ran], column: Option<&str>, to: impl std::io::Write) -> std::io::Result<()> {
    let mut to = csv::Writer::from_writer(to);
    for (number, one) in runs.iter().enumerate() {
        if number == 0 {
            to.write_record(column.map(str::to_owned).into_iter().chain(one.outcome.headings()))?;
        }
        let first = column.map(|_| one.what());
        for row in 0..one.outcome.time.len() {
            to.write_record(first.clone().into_iter().chain(one.outcome.row(row)))?;
        }
    }
    to.flush()
}
