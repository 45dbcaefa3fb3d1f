//! `stribeck identify`: parameters of laws from records of a rig.

use std::path::{Path, PathBuf};

use clap::Args;
use stribeck::model::ModelType;
use stribeck_fit::identify::{
    Answer, Data, Experiment, Exported, Files, Fit, Format, Inquiry, Rank, Ranking, Searches, Settings, Validation,
    Verdict, Watch, fit,
};
use stribeck_measured::{Quality, Record, average};
use stribeck_plot::picture::{Theme, friction_map};
use stribeck_plot::report::{Identification, identification};
use stribeck_solve::system::Fault;

use super::description::Description;
use super::watch::{Best, CANCELLED, heed_interrupts};
use super::{Failure, Verdict as Ending, write};
use crate::outputs;

/// An identification, and the files for its results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    inquiry: Inquiry,
    #[command(flatten)]
    description: Description,
    /// Only report the data quality of the records and which parameters they can determine
    #[arg(long)]
    check: bool,
    /// The best law: a parameter set (.toml for `run --config`, .csv, .ssv), a module of Python (.py), a joint of MuJoCo (.xml) or URDF (.urdf)
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

/// Budget of a search with --check, in evaluations (chosen).
const CHECK: u64 = 400;

impl Arguments {
    /// Rejects output files that cannot be written, before the search.
    fn refuse_outputs(&self) -> Result<(), Fault> {
        self.out.as_ref().map_or(Ok(()), |path| outputs::file(path, &endings()))?;
        self.report.as_ref().map_or(Ok(()), |path| outputs::file(path, &["html"]))?;
        self.curves.as_ref().map_or(Ok(()), |path| outputs::folder(path))?;
        if self.check && self.json { Err(Fault::value("--check: writes no JSON")) } else { Ok(()) }
    }
}

/// Fits laws to records and ranks them; prints the parameters with their uncertainty.
pub fn identify(arguments: &Arguments) -> Result<Ending, Failure> {
    arguments.refuse_outputs()?;
    arguments.inquiry.refuse_contradictions()?;
    let inquiry = arguments.description.complete(&arguments.inquiry)?;
    let (laws, task) = (inquiry.laws()?, inquiry.settings()?);
    let data = inquiry.data(&Files)?;
    inquiry.check_given()?;
    heed_interrupts();
    if !arguments.json {
        let records = data.records.iter().zip(&data.experiments);
        records.for_each(|((name, record), one)| println!("{}  {}", worth(name, record), one.beginning(&laws)));
        data.maps.iter().for_each(|(name, map)| print!("{}", map.worth(name)));
    }
    if arguments.check {
        return check(&laws, &data.experiments, &task);
    }
    let ranking = search(&inquiry, &data)?;
    remark(&inquiry, ranking.best());
    let (records, maps, command) = (&data.records, &data.maps, &command_line());
    tell(arguments, &Identification { records, maps, task: &task, command, ranking: &ranking }, &data)
}

fn search(inquiry: &Inquiry, data: &Data) -> Result<Ranking, Failure> {
    let bar = Best::new(data.experiments.first().map_or("", |one| one.movement.unit("N")));
    let watch = Watch { cancel: &CANCELLED, progress: &|rms, _| bar.reached(rms) };
    let ranking = inquiry.fits(data, &mut |law| bar.begin(law.name), watch)?;
    bar.finish();
    Ok(ranking)
}

/// Says if the reference is not for the best law.
fn remark(inquiry: &Inquiry, best: &Fit) {
    let Some(text) = &inquiry.reference else { return };
    match &best.judgement {
        None => eprintln!("stribeck: --reference {text}: has no values for {}, so nothing is compared", best.law.name),
        Some(judgement) => judgement.note.iter().for_each(|note| eprintln!("stribeck: --reference {note}")),
    }
}

/// Prints the result and writes the requested files.
fn tell(arguments: &Arguments, facts: &Identification, data: &Data) -> Result<Ending, Failure> {
    let Identification { records, ranking, .. } = *facts;
    let best = ranking.best();
    if arguments.json {
        println!("{}", serde_json::to_string(&Answer::of(ranking, data)).map_err(Fault::value)?);
    } else {
        print!("{}{}{}", table(ranking), best.table(), judged(best));
    }
    if let Some(folder) = &arguments.curves {
        super::folder(folder)?;
        curves(folder, records, facts)?;
    }
    if let Some(path) = &arguments.report {
        write(path, identification::html(facts)?)?;
    }
    save(arguments, best, &data.experiments)?;
    Ok(if best.is_cancelled { Ending::Cancelled } else { Ending::Done })
}

/// Lines of the judgement of values that were given.
fn judged(best: &Fit) -> String {
    let Some(judgement) = &best.judgement else { return String::new() };
    let lines = judgement.lines(best.movement.unit("N"));
    lines.iter().map(|line| format!("{}: {line}\n", judgement.source)).collect()
}

/// The command line as it was typed, quoted for a shell; empty if it can't be.
fn command_line() -> String {
    let arguments: Option<Vec<String>> = std::env::args_os().skip(1).map(|one| one.into_string().ok()).collect();
    let words = arguments.and_then(|words| shlex::try_join(words.iter().map(String::as_str)).ok());
    words.map_or(String::new(), |words| format!("stribeck {words}"))
}

/// Describes the quality of a record.
fn worth(name: &str, record: &Record) -> String {
    let Quality { samples, duration, reversals, fastest, noise, findings, .. } = &record.quality;
    let plural = if *reversals == 1 { "" } else { "s" };
    let mut text = format!(
        "{name}: {samples} samples over {duration:.3} s, {reversals} reversal{plural}, up to {fastest:.4} {}; noise \
         of the {} {noise:.3e} {}\n",
        record.movement.unit("m/s"),
        record.movement.force(),
        record.movement.unit("N")
    );
    text += &prepared(record);
    findings.iter().for_each(|finding| text += &format!("  {finding}\n"));
    text
}

/// How the motion was filtered, and how far it lags the force.
fn prepared(record: &Record) -> String {
    let Record { window, velocity_error, acceleration_window, acceleration_error, clocks, .. } = record;
    let delay = clocks.delay;
    if record.matched_filter.is_some() {
        return format!(
            "  matched filter of force and motion, window {window:.4} s; the motion lags the force by about {delay:.5} \
             s\n"
        );
    }
    let mut text = String::new();
    if record.is_differentiated {
        text += &format!(
            "  velocity differentiated from the displacement, window {window:.4} s, error near rest \
             {velocity_error:.1e} {}; acceleration, window {acceleration_window:.4} s, error \
             {acceleration_error:.1e} {}\n",
            record.movement.unit("m/s"),
            record.movement.unit("m/s2")
        );
    }
    if clocks.deviation > 0.0 {
        text += &format!(
            "  the motion lags the force by about {delay:.5} s, and {:.1e} s more each second; friction that builds up \
             over a distance adds to this estimate: the fit of a law re-estimates the delay\n",
            clocks.drift
        );
    }
    text
}

/// Prints which parameters the data can determine, without their values.
fn check(laws: &[&'static ModelType], experiments: &[Experiment], task: &Settings) -> Result<Ending, Failure> {
    let task = Settings { budget: CHECK.min(task.budget), profiles: false, repetitions: 0, ..task.clone() };
    let is_ended = || CANCELLED.load(std::sync::atomic::Ordering::Relaxed);
    for law in laws.iter().filter(|_| !is_ended()) {
        let bar = Best::new(experiments.first().map_or("", |one| one.movement.unit("N")));
        bar.begin(law.name);
        let found = fit(law, experiments, &task, Watch { cancel: &CANCELLED, progress: &|rms, _| bar.reached(rms) })?;
        bar.finish();
        print!("{}:\n{}", law.name, outlook(&found));
    }
    Ok(if is_ended() { Ending::Cancelled } else { Ending::Done })
}

/// Which parameters a search has shown to be determined.
fn outlook(found: &Fit) -> String {
    if found.searches != Searches::Agree {
        return "  inconclusive after this short search: run without --check\n".to_owned();
    }
    let verdict = |verdict: &Verdict| match verdict {
        Verdict::Determined => "can be determined".to_owned(),
        Verdict::AtMost(_) => "not distinguishable from 0".to_owned(),
        Verdict::Undetermined(reason) => format!("cannot be determined: {reason}"),
        Verdict::AtEnd(_) => "is beyond its range".to_owned(),
    };
    found.estimates.iter().map(|one| format!("  {}: {}\n", one.name, verdict(&one.verdict))).collect()
}

/// The laws, the best first.
fn table(ranking: &Ranking) -> String {
    if ranking.ranks.len() + ranking.refused.len() < 2 {
        return String::new();
    }
    let mut text = "\n  law                  RMS residual parameters     dBIC".to_owned();
    let is_held_out = ranking.fits.iter().any(|fit| !fit.validation.is_empty());
    text += if is_held_out { "  validation RMS\n" } else { "\n" };
    let ranks = ranking.ranks.iter().enumerate();
    ranks.for_each(|(place, rank)| text += &row(&ranking.fits[rank.fit], rank, place));
    ranking.refused.iter().for_each(|(_, reason)| text += &format!("  {reason}\n"));
    text + "\n"
}

fn row(fit: &Fit, rank: &Rank, place: usize) -> String {
    let unit = fit.movement.unit("N");
    format!(
        "  {:<20} {:>10.3e} {unit} {:>10} {:>8.1}{}{}\n",
        fit.law.name,
        fit.residuals.rms,
        fit.parameters(),
        rank.delta_bic,
        worst(&fit.validation).map_or(String::new(), |rms| format!("  {rms:>12.3e} {unit}")),
        identification::note(fit, rank, place).map_or(String::new(), |note| format!("  {note}"))
    )
}

/// The largest root mean square of the validation records.
fn worst(validation: &[Validation]) -> Option<f64> {
    validation.iter().map(|one| one.rms).reduce(f64::max)
}

/// Endings of the files for a law.
fn endings() -> Vec<&'static str> {
    ["toml", "csv", "ssv"].into_iter().chain(Format::ALL.map(|(ending, _)| ending)).collect()
}

fn save(arguments: &Arguments, best: &Fit, experiments: &[Experiment]) -> Result<(), Failure> {
    let Some(path) = &arguments.out else { return Ok(()) };
    let notice = |text: &str| eprintln!("stribeck: {}: {text}", path.display());
    if let Some((_, format)) = Format::ALL.into_iter().find(|(ending, _)| outputs::has_ending(path, ending)) {
        let Exported { text, lost } =
            best.exported(format, experiments).map_err(|error| Failure::of_file(path, &error))?;
        lost.iter().for_each(|one| notice(&format!("not carried over: {one}")));
        return write(path, text);
    }
    let left: Vec<&str> = best.undetermined().filter(|name| best.law.find(name).is_some()).collect();
    if outputs::has_ending(path, "toml") {
        best.refuse_component("a system with a friction law").map_err(|error| Failure::of_file(path, &error))?;
        write(path, best.configuration().text())?;
        if best.physical.gravity != [0.0; 2] {
            notice("not carried over: the gravity of the arm, which the system axis does not have");
        }
    } else {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        best.parameter_set(&name)?.save(path).map_err(|error| Fault::File(error.to_string()))?;
        if best.axis_load.is_some() {
            notice("the law only; mass and offset of the axis go into a .toml file");
        }
    }
    if !left.is_empty() {
        notice(&format!("left out, because it is not determined: {}", left.join(", ")));
    }
    Ok(())
}

fn curves(folder: &Path, records: &[(String, Record)], facts: &Identification) -> Result<(), Failure> {
    for (number, (name, record)) in records.iter().enumerate() {
        let record = &facts.ranking.best().corrected(record);
        write(&folder.join(format!("{name}.csv")), record.csv().map_err(Fault::value)?)?;
        if let Some(cycle) = average(record) {
            write(&folder.join(format!("{name}-cycle.csv")), cycle.csv().map_err(Fault::value)?)?;
        }
        for picture in identification::pictures(facts, number)? {
            super::draw(&picture, &folder.join(format!("{name}-{}", picture.name())))?;
        }
    }
    for ((name, map), fitted) in facts.maps.iter().zip(&facts.ranking.best().predicted) {
        write(&folder.join(format!("{name}.csv")), map.csv(fitted).map_err(Fault::value)?)?;
        let picture = friction_map(name, map, facts.ranking.best(), Theme::Light)?;
        super::draw(&picture, &folder.join(format!("{name}-{}", picture.name())))?;
    }
    Ok(())
}
