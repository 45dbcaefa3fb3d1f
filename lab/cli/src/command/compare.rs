//! `stribeck compare`: a system with several laws.

use std::io::Write;

use serde_json::json;
use stribeck::catalogue::{self, Family};
use stribeck_solve::run::{Outcome, Settings, run as run_system};
use stribeck_solve::solve::End;
use stribeck_solve::system::{Fault, System};

use super::choice::{Arguments, Choice};
use super::one::{as_json, line, verdict};
use super::watch::{Bar, CANCELLED, heed_interrupts};
use super::{Failure, Verdict};

/// Runs a system with each of several laws; with all of the catalogue if none is named.
pub fn compare(arguments: &Arguments) -> Result<Verdict, Failure> {
    let choice = arguments.choice()?;
    if choice.vary.is_some() {
        return Err(Fault::value("--vary: use `stribeck run`, for one law at a time").into());
    }
    let laws = laws(&choice);
    heed_interrupts();
    check(&choice, &laws)?;
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut bar = None;
    for (number, law) in laws.iter().enumerate() {
        let system = choice.system(Some(law), None)?;
        let settings = choice.run_settings(&system)?;
        let bar = bar.get_or_insert_with(|| Bar::new(laws.len(), settings.until));
        bar.begin(number, law);
        let settings = Settings { cancel: Some(&CANCELLED), progress: Some(&*bar), ..settings };
        let outcome = run_system(&system, &settings, &choice.results())?;
        let is_cancelled = matches!(outcome.end, End::Cancelled { .. });
        outcomes.push(outcome);
        if is_cancelled {
            break;
        }
    }
    if let Some(bar) = bar {
        bar.finish();
    }
    report(arguments, &choice, &outcomes)?;
    let verdict = outcomes.iter().map(verdict).max().unwrap_or(Verdict::Done);
    let labelled = outcomes
        .into_iter()
        .zip(&laws)
        .map(|(outcome, law)| Ok((law.clone(), choice.system(Some(law), None)?, outcome)));
    choice.illustrate(arguments, labelled.collect::<Result<_, Failure>>()?)?;
    Ok(verdict)
}

fn report(arguments: &Arguments, choice: &Choice, outcomes: &[Outcome]) -> Result<(), Failure> {
    if let Some(path) = &arguments.out {
        let file = std::fs::File::create(path).map_err(|source| Failure::File { path: path.clone(), source })?;
        let file = std::io::BufWriter::new(file);
        table(outcomes, file).map_err(|source| Failure::File { path: path.clone(), source })?;
    }
    if arguments.json {
        let runs: Vec<_> = outcomes.iter().map(|outcome| as_json(choice, None, outcome)).collect();
        println!("{}", json!({ "runs": runs }));
    } else {
        outcomes.iter().for_each(|outcome| println!("{}", line(choice, None, outcome)));
    }
    Ok(())
}

/// The chosen laws, or all.
fn laws(choice: &Choice) -> Vec<String> {
    let all = || catalogue::documented(Family::Friction).map(|(model, _)| model.name.to_owned()).collect();
    if choice.laws.is_empty() { all() } else { choice.laws.clone() }
}

/// Refuses what none of the laws can do, before the first run.
fn check(choice: &Choice, laws: &[String]) -> Result<(), Failure> {
    let systems = laws.iter().map(|law| choice.system(Some(law), None)).collect::<Result<Vec<System>, Failure>>()?;
    Ok(System::refuse_unused(&systems)?)
}

/// The results of all laws, one below the other, with the law in the first column.
fn table(outcomes: &[Outcome], to: impl Write) -> std::io::Result<()> {
    let mut to = csv::Writer::from_writer(to);
    for (number, outcome) in outcomes.iter().enumerate() {
        if number == 0 {
            to.write_record(["law".to_owned()].into_iter().chain(outcome.headings()))?;
        }
        let law = outcome.law.map_or("", |law| law.name);
        for row in 0..outcome.time.len() {
            to.write_record([law.to_owned()].into_iter().chain(outcome.row(row)))?;
        }
    }
    to.flush()
}
