//! `stribeck run`: a system with one law.

use std::io::Write;

use serde_json::json;
use stribeck_solve::run::{Outcome, Settings, run as run_system};
use stribeck_solve::solve::End;
use stribeck_solve::system::{Fault, System};

use super::choice::{Arguments, Choice};
use super::watch::{Bar, CANCELLED, heed_interrupts};
use super::{Failure, Verdict};

/// Runs a system, once or for each value of a variable.
pub fn run(arguments: &Arguments) -> Result<Verdict, Failure> {
    let choice = arguments.choice()?;
    if choice.laws.len() > 1 {
        return Err(Fault::value("several laws: use `stribeck compare`").into());
    }
    heed_interrupts();
    let law = choice.laws.first().map(String::as_str);
    let values: Vec<Option<f64>> =
        choice.vary.as_ref().map_or_else(|| vec![None], |vary| vary.values.iter().copied().map(Some).collect());
    // Whatever is refused is refused before the first run.
    for value in &values {
        system(&choice, law, *value)?;
    }
    let mut outcomes = Vec::new();
    let mut bar = None;
    for (number, value) in values.iter().enumerate() {
        let system = system(&choice, law, *value)?;
        let settings = choice.run_settings(&system)?;
        let bar = bar.get_or_insert_with(|| Bar::new(values.len(), settings.until));
        bar.begin(number, system.law.map_or("", |law| law.name));
        let settings = Settings { cancel: Some(&CANCELLED), progress: Some(&*bar), ..settings };
        let outcome = run_system(&system, &settings, &choice.results())?;
        let is_cancelled = matches!(outcome.end, End::Cancelled { .. });
        outcomes.push((*value, outcome));
        if is_cancelled {
            break;
        }
    }
    if let Some(bar) = bar {
        bar.finish();
    }
    report(arguments, &choice, &outcomes)?;
    let verdict = outcomes.iter().map(|(_, outcome)| verdict(outcome)).max().unwrap_or(Verdict::Done);
    let labelled = outcomes.into_iter().map(|(value, outcome)| {
        let name = outcome.law.map_or_else(|| choice.name(), |law| law.name).to_owned();
        let varied = choice.vary.as_ref().zip(value).map(|(vary, value)| format!("{} = {value}", vary.name));
        Ok((varied.unwrap_or(name), choice.system(law, value)?, outcome))
    });
    choice.illustrate(arguments, labelled.collect::<Result<_, Failure>>()?)?;
    Ok(verdict)
}

fn system(choice: &Choice, law: Option<&str>, value: Option<f64>) -> Result<System, Failure> {
    let system = choice.system(law, value)?;
    System::refuse_unused(std::slice::from_ref(&system))?;
    Ok(system)
}

pub(super) fn verdict(outcome: &Outcome) -> Verdict {
    match outcome.end {
        End::Reached => Verdict::Done,
        End::Failed { .. } => Verdict::Diverged,
        End::Cancelled { .. } => Verdict::Cancelled,
    }
}

fn report(arguments: &Arguments, choice: &Choice, outcomes: &[(Option<f64>, Outcome)]) -> Result<(), Failure> {
    if let Some(path) = &arguments.out {
        let file = std::fs::File::create(path).map_err(|source| Failure::File { path: path.clone(), source })?;
        let file = std::io::BufWriter::new(file);
        table(choice, outcomes, file).map_err(|source| Failure::File { path: path.clone(), source })?;
    }
    if arguments.json {
        let runs: Vec<_> = outcomes.iter().map(|(value, outcome)| as_json(choice, *value, outcome)).collect();
        println!("{}", json!({ "runs": runs }));
    } else {
        outcomes.iter().for_each(|(value, outcome)| println!("{}", line(choice, *value, outcome)));
    }
    Ok(())
}

/// The results; with the varied value in the first column if there is one.
fn table(choice: &Choice, outcomes: &[(Option<f64>, Outcome)], to: impl Write) -> std::io::Result<()> {
    let [(None, outcome)] = outcomes else {
        let mut to = csv::Writer::from_writer(to);
        let name = choice.vary.as_ref().map_or("", |vary| vary.name.as_str());
        for (number, (value, outcome)) in outcomes.iter().enumerate() {
            if number == 0 {
                to.write_record([name.to_owned()].into_iter().chain(outcome.headings()))?;
            }
            for row in 0..outcome.time.len() {
                to.write_record([value.unwrap_or(0.0).to_string()].into_iter().chain(outcome.row(row)))?;
            }
        }
        return to.flush();
    };
    outcome.write_csv(to)
}

/// One line on a run.
pub(super) fn line(choice: &Choice, value: Option<f64>, outcome: &Outcome) -> String {
    let law = outcome.law.map_or_else(|| choice.name(), |law| law.name);
    let varied = match (&choice.vary, value) {
        (Some(vary), Some(value)) => format!(" {} = {value}", vary.name),
        _ => String::new(),
    };
    let stribeck_solve::solve::Statistics { steps, rejected, evaluations, .. } = outcome.statistics;
    format!(
        "{law}{varied}: {}; {}, steps: {steps}, rejected: {rejected}, evaluations: {evaluations}, events: {}, {:.3} s",
        outcome.end,
        outcome.solver,
        outcome.events.len(),
        outcome.elapsed.as_secs_f64()
    )
}

/// A run as JSON; the results are arrays.
pub(super) fn as_json(choice: &Choice, value: Option<f64>, outcome: &Outcome) -> serde_json::Value {
    let varied = choice.vary.as_ref().zip(value).map(|(vary, value)| json!({ "name": vary.name, "value": value }));
    let columns: serde_json::Map<String, serde_json::Value> = outcome
        .columns
        .iter()
        .map(|column| (column.name.clone(), json!({ "unit": column.unit, "values": column.values })))
        .collect();
    let events: Vec<_> = outcome.events.iter().map(|event| json!({ "time": event.time, "part": event.part })).collect();
    json!({
        "law": outcome.law.map(|law| law.name),
        "varied": varied,
        "solver": outcome.solver.to_string(),
        "end": outcome.end.to_string(),
        "reached": outcome.is_reached(),
        "steps": outcome.statistics.steps,
        "rejected": outcome.statistics.rejected,
        "evaluations": outcome.statistics.evaluations,
        "jacobians": outcome.statistics.jacobians,
        "events": events,
        "seconds": outcome.elapsed.as_secs_f64(),
        "time": outcome.time,
        "results": columns,
    })
}
