//! `stribeck identify`: parameters of laws from records of a rig.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{Args, ValueEnum};
use ssp::parameter_set::ParameterSet;
use stribeck::model::ModelType;
use stribeck_fit::identify::{
    Experiment, Fit, Method, Ranking, Reference, Searches, Task, Unseen, Verdict, Watch, Wishes, as_json, axis, fit,
    fit_all, held_out, laws_named, names, of_law, preset,
};
use stribeck_fit::measured::{Columns, Delay, MeasuredError, Record, Rig, average};
use stribeck_fit::sheet::{DISPLACEMENT, FORCE, Sheet, SheetError, VELOCITY, tables};
use stribeck_plot::report::{Identification, identification};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, Setting, read};

use super::watch::{Best, CANCELLED, heed_interrupts};
use super::{Failure, Verdict as Ending, write};
use crate::outputs;

/// Records, laws, what is known of the rig, and the files for the results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Records: tables with time, force, and displacement or velocity, perhaps normal_force; units in brackets
    #[arg(required = true)]
    records: Vec<PathBuf>,
    /// Name of a column in the files: force=Kraft_1; for binary files (.mf4, .mat) that of a channel or variable
    #[arg(long, value_name = "NAME=COLUMN")]
    column: Vec<Setting>,
    /// Factor of a column: force=35.15 if it has volts of an amplifier with 35.15 N/V, displacement=-1 if it is reversed
    #[arg(long, value_name = "NAME=FACTOR", allow_hyphen_values = true)]
    scale: Vec<Setting>,
    /// Table of the motion on its own clock (a camera), for a single record
    #[arg(long, value_name = "FILE")]
    motion: Option<PathBuf>,
    /// Friction laws; several, or `all`, are ranked
    #[arg(long, alias = "laws", required_unless_present = "axis", num_args = 1.., value_delimiter = ',')]
    law: Vec<String>,
    /// The records are of an axis, M a = F - f - offset: fit mass and offset too, with Coulomb and viscous friction
    /// unless --law is given, at a normal force of 1 N unless one is known
    #[arg(long)]
    axis: bool,
    /// Mass between load cell and contact in kg (default: 0)
    #[arg(long)]
    mass: Option<f64>,
    /// Normal force in N, if the record has none
    #[arg(long)]
    normal_force: Option<f64>,
    /// Window in s for smoothing and differentiating the motion, 0 for the shortest (default: 5 to 391 samples, at most a
    /// tenth of the record, with the least error of velocity and acceleration; for an axis 9 to 191 samples, force and
    /// motion alike)
    #[arg(long)]
    window: Option<f64>,
    /// Delay of the motion behind the force in s; or `find`, or `find:LONGEST` (default: 0; for an axis that of a
    /// controller, up to two samples, is found)
    #[arg(long)]
    delay: Option<DelayChoice>,
    /// Start of the record that is left out, in s
    #[arg(long, default_value_t = 0.0)]
    skip: f64,
    /// Speed in m/s below which samples are left out (default: three times the error of the velocity, and for Coulomb and
    /// viscous friction of an axis a twentieth of the highest speed; 0 for none)
    #[arg(long)]
    rest: Option<f64>,
    /// Parameter that is held, in those of several laws that have it: sigma_1=0; also mass and offset of the rig
    #[arg(long, value_name = "NAME=VALUE")]
    fix: Vec<Setting>,
    /// Parameter that is fitted although it usually is not: an exponent, mass, offset
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    fit: Vec<String>,
    /// Range instead of the one that follows from the data
    #[arg(long, value_name = "NAME=LOW:HIGH")]
    range: Vec<RangeChoice>,
    /// Search over the whole range
    #[arg(long, value_enum, default_value_t = MethodChoice::Evolution)]
    method: MethodChoice,
    /// Cost of a residual: squares, or less for outliers
    #[arg(long, value_enum, default_value_t = LossChoice::Squares)]
    loss: LossChoice,
    /// Records that are not fitted: the laws are held against them
    #[arg(long, value_name = "FILE", num_args = 1..)]
    hold_out: Vec<PathBuf>,
    /// Cross-validation: fit all parts of the records but one, in turn, and hold the law against that part
    #[arg(long, value_name = "PARTS", default_value_t = 0)]
    folds: usize,
    /// Evaluations of the law in a search over the whole range, before least squares; at least those of its first
    /// generations are made, 48 or 16 for each unknown (62 by the genetic algorithm)
    #[arg(long, default_value_t = Task::default().budget)]
    budget: u64,
    /// Seed of the search and of the repetitions
    #[arg(long, default_value_t = Task::default().seed)]
    seed: u64,
    /// Repetitions with blocks of residuals
    #[arg(long, default_value_t = Task::default().repetitions)]
    repetitions: usize,
    /// Only say what the record is worth and which parameters it can determine
    #[arg(long)]
    check: bool,
    /// Values to compare with: a preset of the law, or a parameter set (.toml, .csv, .ssv)
    #[arg(long, value_name = "PRESET|FILE")]
    reference: Option<String>,
    /// Parameter set of the best law (.toml for `run --config`, .csv, .ssv)
    #[arg(long, short)]
    out: Option<PathBuf>,
    /// Folder for friction over time, displacement and velocity: tables and pictures
    #[arg(long, value_name = "FOLDER")]
    curves: Option<PathBuf>,
    /// File for a report (.html)
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Print the outcome as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum MethodChoice {
    /// Differential evolution, then bounded least squares
    Evolution,
    /// A genetic algorithm alone, for comparison
    Genetic,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum LossChoice {
    /// Half the squares
    Squares,
    /// Squares of small residuals, magnitudes of those well above 1.3 times the noise
    Robust,
}

#[derive(Clone, Copy, Debug)]
struct DelayChoice(Delay);

impl FromStr for DelayChoice {
    type Err = Fault;

    fn from_str(text: &str) -> Result<DelayChoice, Fault> {
        let number = |text: &str| {
            let wrong = || Fault::value(format_args!("'{text}': must be a number in s, find, or find:LONGEST"));
            text.trim().parse::<f64>().map_err(|_| wrong())
        };
        Ok(DelayChoice(match text.split_once(':') {
            Some(("find", longest)) => Delay::Find(number(longest)?),
            None if text == "find" => Delay::Find(Delay::LONGEST),
            _ => Delay::Known(number(text)?),
        }))
    }
}

#[derive(Clone, Debug)]
struct RangeChoice(String, [f64; 2]);

impl FromStr for RangeChoice {
    type Err = Fault;

    fn from_str(text: &str) -> Result<RangeChoice, Fault> {
        let wrong = || Fault::value(format_args!("'{text}': must be name=low:high"));
        let (name, range) = text.split_once('=').ok_or_else(wrong)?;
        let (low, high) = range.split_once(':').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
        Ok(RangeChoice(name.trim().to_owned(), [number(low)?, number(high)?]))
    }
}

/// Evaluations with which it is looked at what a record can determine (chosen).
const CHECK: u64 = 400;

impl Arguments {
    fn mass(&self) -> f64 {
        self.mass.unwrap_or(0.0)
    }

    fn rig(&self) -> Rig {
        let usual = if self.axis { Delay::OfController } else { Delay::Known(0.0) };
        let delay = self.delay.map_or(usual, |DelayChoice(delay)| delay);
        let normal_force = self.normal_force.or(self.axis.then_some(axis::NORMAL_FORCE));
        Rig { mass: self.mass(), normal_force, window: self.window, delay, skip: self.skip, is_axis: self.axis }
    }

    /// Refuses a file that is given twice: it would count twice, or be held against itself.
    fn refuse_twice(&self) -> Result<(), Fault> {
        let records = self.records.iter().map(|path| (path, false));
        let mut known: Vec<(PathBuf, bool)> = Vec::new();
        for (path, is_held_out) in records.chain(self.hold_out.iter().map(|path| (path, true))) {
            // A file that is not there is refused when it is read.
            let Ok(real) = path.canonicalize() else { continue };
            if let Some((_, was_held_out)) = known.iter().find(|(other, _)| *other == real) {
                let why = if is_held_out == *was_held_out { "is given twice" } else { "is a record and held out too" };
                return Err(Fault::File(format!("{}: {why}", path.display())));
            }
            known.push((real, is_held_out));
        }
        Ok(())
    }

    /// The records, and those that are not fitted.
    fn all_records(&self) -> Result<[Vec<(String, Record)>; 2], Failure> {
        self.refuse_twice()?;
        let files: Vec<&Path> = self.records.iter().chain(&self.hold_out).map(PathBuf::as_path).collect();
        let mut names = names(&files).into_iter();
        let mut named = |files: &'_ [PathBuf]| self.read_all(files, names.by_ref());
        Ok([named(&self.records)?, named(&self.hold_out)?])
    }

    fn read_all(
        &self,
        files: &[PathBuf],
        names: &mut dyn Iterator<Item = String>,
    ) -> Result<Vec<(String, Record)>, Failure> {
        if self.motion.is_some() && self.records.len() + self.hold_out.len() > 1 {
            return Err(Fault::value("--motion: is for a single record").into());
        }
        let (rig, columns) = (self.rig(), self.columns()?);
        let read = |(path, name): (&PathBuf, String)| {
            let mut own = tables(path).map_err(|error| unreadable(path, &error))?;
            let motion = self.motion.as_ref();
            let motion = motion.map(|path| tables(path).map_err(|error| unreadable(path, &error))).transpose()?;
            let mut motion = motion.unwrap_or_default();
            let refused = |error: MeasuredError| match (error, &self.motion) {
                (MeasuredError::Motion(error), Some(camera)) => unreadable(camera, &told(&error)),
                (error, _) => unreadable(path, &told(&error)),
            };
            let said = columns.apply(&mut own, &mut motion, &rig).map_err(refused)?;
            let (own, others) = with_force(own);
            let motion = with_motion(motion);
            // The channels of a file may have several clocks.
            let apart = if is_of_motion(&own) { None } else { with_motion(others) };
            let record = Record::of(&own, motion.as_ref().or(apart.as_ref()), &rig);
            let mut record = record.map_err(refused)?;
            record.quality.findings.splice(0..0, said);
            Ok((name, record))
        };
        files.iter().zip(names).map(read).collect()
    }

    fn columns(&self) -> Result<Columns, Fault> {
        let names = self.column.iter().map(|Setting { name, value }| (name.clone(), value.clone())).collect();
        let factors = self.scale.iter().map(Setting::number).collect::<Result<Vec<(String, f64)>, Fault>>()?;
        let columns = Columns { names, factors };
        columns.check().map_err(Fault::value)?;
        Ok(columns)
    }

    fn experiments(&self, records: &[(String, Record)], laws: &[&'static ModelType]) -> Result<Vec<Experiment>, Fault> {
        let experiment = |(name, record): &(String, Record)| {
            let all = Experiment::new(name, record);
            match self.rest {
                Some(rest) => all.without_rest(rest),
                None if self.axis => axis::in_motion(all, laws),
                None => Ok(all),
            }
        };
        records.iter().map(experiment).collect()
    }

    /// Refuses files that could not be written, before the work for them is done.
    fn refuse_outputs(&self) -> Result<(), Fault> {
        self.out.as_ref().map_or(Ok(()), |path| outputs::file(path, &["toml", "csv", "ssv"]))?;
        self.report.as_ref().map_or(Ok(()), |path| outputs::file(path, &["html"]))?;
        self.curves.as_ref().map_or(Ok(()), |path| outputs::folder(path))
    }

    fn laws(&self) -> Result<Vec<&'static ModelType>, Fault> {
        if self.law.is_empty() { laws_named(&[axis::LAW.to_owned()]) } else { laws_named(&self.law) }
    }

    /// Refuses a parameter that is held at two values, or held and fitted.
    fn refuse_contradictions(&self, fixed: &[(String, f64)]) -> Result<(), Fault> {
        for (name, value) in fixed {
            let contradicts =
                |other: String| Err(Fault::value(format_args!("--fix {name}={value} contradicts {other}")));
            if let Some(mass) = self.mass.filter(|mass| name == "mass" && mass != value) {
                return contradicts(format!("--mass {mass}"));
            }
            if self.fit.contains(name) {
                return contradicts(format!("--fit {name}"));
            }
            if let Some((_, other)) = fixed.iter().find(|(known, other)| known == name && other != value) {
                return contradicts(format!("--fix {name}={other}"));
            }
        }
        Ok(())
    }

    fn task(&self) -> Result<Task, Fault> {
        let fixed = self.fix.iter().map(Setting::number).collect::<Result<Vec<(String, f64)>, Fault>>()?;
        self.refuse_contradictions(&fixed)?;
        let ranges = self.range.iter().map(|RangeChoice(name, ends)| (name.clone(), *ends)).collect();
        let mut wishes = Wishes { fixed, fitted: self.fit.clone(), ranges };
        if self.axis {
            axis::fitted(&mut wishes, self.mass());
        }
        Ok(Task {
            wishes,
            method: match self.method {
                MethodChoice::Evolution => Method::Evolution,
                MethodChoice::Genetic => Method::Genetic,
            },
            seed: self.seed,
            budget: self.budget,
            repetitions: self.repetitions,
            mass: self.mass(),
            is_robust: self.loss == LossChoice::Robust,
            folds: self.folds,
            ..Task::default()
        })
    }

    /// The reference for each of the laws; None for a law that it does not fit. An error if it fits none of them.
    fn references(&self, laws: &[&'static ModelType]) -> Result<Vec<Option<Reference>>, Failure> {
        let Some(text) = &self.reference else { return Ok(laws.iter().map(|_| None).collect()) };
        let mut all: Vec<Result<Option<Reference>, Failure>> =
            laws.iter().map(|law| self.reference(law, text)).collect();
        if all.iter().all(Result::is_err) {
            return Err(all.swap_remove(0).err().unwrap_or_else(|| Fault::value("no law was given").into()));
        }
        let all: Vec<Option<Reference>> = all.into_iter().map(|found| found.ok().flatten()).collect();
        if all.iter().all(Option::is_none) {
            return Err(Fault::File(format!("{text}: has no parameter of these laws")).into());
        }
        Ok(all)
    }

    /// The reference of the best law; says so if there is none for it.
    fn of_best<'a>(
        &self,
        best: &Fit,
        mut references: impl Iterator<Item = (&'a &'static ModelType, Option<Reference>)>,
    ) -> Option<Reference> {
        let found = references.find(|(law, _)| law.name == best.law.name).and_then(|(_, found)| found);
        if let Some(text) = self.reference.as_ref().filter(|_| found.is_none()) {
            eprintln!("stribeck: --reference {text}: has no values for {}, so nothing is compared", best.law.name);
        }
        if let Some((text, other)) = self.reference.as_ref().zip(found.as_ref().and_then(|_| self.other_law(best.law)))
        {
            eprintln!(
                "stribeck: --reference {text}: is a set of {other}, not of {}; compared where names are the same",
                best.law.name
            );
        }
        found
    }

    /// The laws that the file of the reference is for, if this one is not among them.
    fn other_law(&self, law: &ModelType) -> Option<String> {
        let path = self.reference.as_ref().map(Path::new).filter(|path| outputs::has_ending(path, "toml"))?;
        let known: Configuration = read(path).ok()?;
        let is_other = !known.law.is_empty() && known.law.iter().all(|name| name != law.name);
        is_other.then(|| known.law.join(", "))
    }

    fn reference(&self, law: &'static ModelType, text: &str) -> Result<Option<Reference>, Failure> {
        let path = Path::new(text);
        if path.extension().is_none() {
            return Ok(of_law(law, &preset(law, text)?));
        }
        if outputs::has_ending(path, "toml") {
            let known: Configuration = read(path)?;
            let number = |(name, value): (String, toml::Value)| {
                value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64)).map(|value| (name, value))
            };
            return Ok(of_law(law, &known.set.into_iter().filter_map(number).collect()));
        }
        let set = ParameterSet::load(law, path).map_err(|error| Fault::File(error.to_string()))?;
        Ok(of_law(law, &set.values().map(|(variable, value)| (variable.path.to_string(), value)).collect()))
    }
}

/// An error about the tables of a file, with its name.
fn unreadable(path: &Path, error: &impl Display) -> Fault {
    let (text, name) = (error.to_string(), path.display().to_string());
    Fault::File(if text.starts_with(&name) { text } else { format!("{name}: {text}") })
}

/// An error about a record; how to name a column that was not found.
fn told(error: &MeasuredError) -> String {
    match error {
        MeasuredError::Sheet(SheetError::Column { wanted, .. }) if Columns::knows(wanted) => {
            format!("{error}; --column {wanted}=NAME names it, --scale {wanted}=FACTOR turns it into the SI unit")
        }
        _ => error.to_string(),
    }
}

fn is_of_motion(table: &Sheet) -> bool {
    [DISPLACEMENT, VELOCITY].iter().any(|quantity| table.has(quantity.name))
}

/// The table of the force, or the first one if none has a force; and the others.
fn with_force(mut tables: Vec<Sheet>) -> (Sheet, Vec<Sheet>) {
    let at = tables.iter().position(|table| table.has(FORCE.name)).unwrap_or(0);
    (tables.remove(at), tables)
}

/// The table of the motion, or the first one if none has a motion.
fn with_motion(mut tables: Vec<Sheet>) -> Option<Sheet> {
    let at = tables.iter().position(is_of_motion).unwrap_or(0);
    (!tables.is_empty()).then(|| tables.remove(at))
}

/// Finds the parameters of laws, ranks the laws if there are several, and tells how far to trust them.
pub fn identify(arguments: &Arguments) -> Result<Ending, Failure> {
    arguments.refuse_outputs()?;
    let (laws, task) = (arguments.laws()?, arguments.task()?);
    let [records, unseen] = arguments.all_records()?;
    let unseen = arguments.experiments(&unseen, &laws)?;
    let experiments = arguments.experiments(&records, &laws)?;
    let references = arguments.references(&laws)?;
    if arguments.check && arguments.json {
        return Err(Fault::value("--check: writes no JSON").into());
    }
    heed_interrupts();
    if !arguments.json {
        for ((name, record), experiment) in records.iter().zip(&experiments) {
            println!("{}  {}", worth(name, record), experiment.beginning());
        }
    }
    if arguments.check {
        return check(&laws, &experiments, &task);
    }
    let bar = Best::new();
    let watch = Watch { cancel: &CANCELLED, progress: &|rms, _| bar.reached(rms) };
    let mut ranking = fit_all(&laws, &experiments, &task, &mut |law| bar.begin(law.name), watch)?;
    bar.finish();
    hold_against(&mut ranking, &unseen)?;
    let reference = arguments.of_best(ranking.best(), laws.iter().zip(references));
    let command = command_line();
    tell(
        arguments,
        &Identification {
            records: &records,
            task: &task,
            command: &command,
            ranking: &ranking,
            reference: reference.as_ref(),
        },
    )
}

/// Prints the outcome, and writes the files that were asked for.
fn tell(arguments: &Arguments, facts: &Identification) -> Result<Ending, Failure> {
    let Identification { records, ranking, reference, .. } = *facts;
    let best = ranking.best();
    if arguments.json {
        println!("{}", with_findings(as_json(ranking), records));
    } else {
        print!("{}{}", table(ranking), best.table(reference));
    }
    if let Some(folder) = &arguments.curves {
        std::fs::create_dir_all(folder).map_err(|source| Failure::File { path: folder.clone(), source })?;
        curves(folder, records, facts)?;
    }
    if let Some(path) = &arguments.report {
        write(path, identification::html(facts)?)?;
    }
    save(arguments, best)?;
    Ok(if best.is_cancelled { Ending::Cancelled } else { Ending::Done })
}

/// The command line as it was typed, quoted for a shell; empty if it can't be.
fn command_line() -> String {
    let arguments: Option<Vec<String>> = std::env::args_os().skip(1).map(|one| one.into_string().ok()).collect();
    let words = arguments.and_then(|words| shlex::try_join(words.iter().map(String::as_str)).ok());
    words.map_or(String::new(), |words| format!("stribeck {words}"))
}

/// Holds the laws against records that were not fitted. An error if the best one is refused there; another one that is
/// has no figure.
fn hold_against(ranking: &mut Ranking, unseen: &[Experiment]) -> Result<(), Fault> {
    let best = ranking.best().law.name;
    for fit in &mut ranking.fits {
        match held_out(fit, unseen) {
            Ok(found) => fit.saw(found),
            Err(fault) if fit.law.name == best => return Err(fault),
            Err(fault) => ranking.refused.push((fit.law.name, format!("not held against other records: {fault}"))),
        }
    }
    Ok(())
}

/// The outcome with what was found out about each record.
fn with_findings(mut told: serde_json::Value, records: &[(String, Record)]) -> serde_json::Value {
    for (name, record) in records {
        told["findings"][name.as_str()] = record.quality.findings.clone().into();
    }
    told
}

/// Describes the quality of a record.
fn worth(name: &str, record: &Record) -> String {
    let quality = &record.quality;
    let mut text = format!(
        "{name}: {} samples over {:.3} s, {} reversal{}, up to {:.4} m/s; noise of the force {:.3e} N\n",
        quality.samples,
        quality.duration,
        quality.reversals,
        if quality.reversals == 1 { "" } else { "s" },
        quality.fastest,
        quality.noise
    );
    if record.alike.is_some() {
        text += &format!(
            "  force and motion averaged alike, over {:.4} s; the motion is about {:.5} s behind the force\n",
            record.window, record.clocks.delay
        );
    } else if record.is_differentiated {
        text += &format!(
            "  velocity from the displacement, in a window of {:.4} s; known to {:.1e} m/s around rest; acceleration in a \
             window of {:.4} s, known to {:.1e} m/s2\n",
            record.window, record.velocity_error, record.acceleration_window, record.acceleration_error
        );
    }
    let clocks = record.clocks;
    if clocks.deviation > 0.0 && record.alike.is_none() {
        text += &format!(
            "  the motion looks {:.5} s behind the force, {:.1e} s more each second; friction that builds up over a \
             distance also looks late, so this may be an overestimate: the fit of a law looks for the delay again\n",
            clocks.delay, clocks.drift
        );
    }
    quality.findings.iter().for_each(|finding| text += &format!("  {finding}\n"));
    text
}

/// Says what the data can determine, without a number.
fn check(laws: &[&'static ModelType], experiments: &[Experiment], task: &Task) -> Result<Ending, Failure> {
    let task = Task { budget: CHECK.min(task.budget), profiles: false, repetitions: 0, ..task.clone() };
    let is_ended = || CANCELLED.load(std::sync::atomic::Ordering::Relaxed);
    for law in laws.iter().filter(|_| !is_ended()) {
        let bar = Best::new();
        bar.begin(law.name);
        let found = fit(law, experiments, &task, Watch { cancel: &CANCELLED, progress: &|rms, _| bar.reached(rms) })?;
        bar.finish();
        println!("{}:", law.name);
        if found.searches != Searches::Agree {
            println!("  not decided by so short a search: leave out --check");
            continue;
        }
        for one in &found.estimates {
            let verdict = match &one.verdict {
                Verdict::Determined => "can be determined".to_owned(),
                Verdict::AtMost(_) => "not distinguishable from 0".to_owned(),
                Verdict::Undetermined(reason) => format!("cannot be determined: {reason}"),
                Verdict::AtEnd(_) => "is beyond its range".to_owned(),
            };
            println!("  {}: {verdict}", one.name);
        }
    }
    Ok(if is_ended() { Ending::Cancelled } else { Ending::Done })
}

/// The laws, the best first.
fn table(ranking: &Ranking) -> String {
    if ranking.ranks.len() + ranking.refused.len() < 2 {
        return String::new();
    }
    let mut text = "\n  law                  RMS residual parameters     dBIC".to_owned();
    let is_held_out = ranking.fits.iter().any(|fit| !fit.unseen.is_empty());
    text += if is_held_out { "  validation RMS\n" } else { "\n" };
    for (number, place) in ranking.ranks.iter().enumerate() {
        let fit = &ranking.fits[place.fit];
        let is_tied = place.is_tied && number > 0;
        let note = fit.searches.note().or(is_tied.then_some("cannot be told apart from the first"));
        let note = note.map_or(String::new(), |note| format!("  {note}"));
        text += &format!(
            "  {:<20} {:>10.3e} N {:>10} {:>8.1}{}{note}\n",
            fit.law.name,
            fit.residuals.rms,
            fit.unknowns(),
            place.delta_bic,
            worst(&fit.unseen).map_or(String::new(), |rms| format!("  {rms:>12.3e} N"))
        );
    }
    ranking.refused.iter().for_each(|(_, reason)| text += &format!("  {reason}\n"));
    text + "\n"
}

/// The largest root mean square of the validation records.
fn worst(unseen: &[Unseen]) -> Option<f64> {
    unseen.iter().map(|one| one.rms).reduce(f64::max)
}

fn save(arguments: &Arguments, best: &Fit) -> Result<(), Failure> {
    let Some(path) = &arguments.out else { return Ok(()) };
    let left: Vec<&str> = best.undetermined().filter(|name| best.law.find(name).is_some()).collect();
    if outputs::has_ending(path, "toml") {
        write(path, best.configuration().text())?;
    } else {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        best.parameter_set(&name)?.save(path).map_err(|error| Fault::File(error.to_string()))?;
        if best.axis_load.is_some() {
            eprintln!("stribeck: {}: the law only; mass and offset of the axis go into a .toml file", path.display());
        }
    }
    if !left.is_empty() {
        eprintln!("stribeck: {}: left out, because it is not determined: {}", path.display(), left.join(", "));
    }
    Ok(())
}

/// Width of PNG pictures (chosen: a column of 85 mm at 600 dots per inch).
const PIXELS: u32 = 2000;

fn curves(folder: &Path, records: &[(String, Record)], facts: &Identification) -> Result<(), Failure> {
    for (number, (name, record)) in records.iter().enumerate() {
        let record = &facts.ranking.best().seen(record);
        write(&folder.join(format!("{name}.csv")), record.csv().map_err(Fault::value)?)?;
        if let Some(cycle) = average(record) {
            write(&folder.join(format!("{name}-cycle.csv")), cycle.csv().map_err(Fault::value)?)?;
        }
        for picture in identification::pictures(facts, number)? {
            let path = folder.join(format!("{name}-{}", picture.name()));
            write(&path.with_extension("svg"), &picture.svg)?;
            write(&path.with_extension("png"), picture.png(PIXELS)?)?;
        }
    }
    Ok(())
}
