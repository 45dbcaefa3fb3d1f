//! `stribeck run --step find`: the largest communication step of a co-simulation.

use serde_json::{Value, json};
use stribeck_solve::run::{CommunicationSteps, Deviation, Order, communication_steps};
use stribeck_solve::solve::End;
use stribeck_solve::system::{Fault, System};

use super::choice::Choice;
use super::watch::{Bar, CANCELLED};
use super::{Failure, Verdict};

/// Searches for each of the systems until the user ends it, and prints what was found.
pub fn find_steps(choice: &Choice, systems: &[System]) -> Result<Verdict, Failure> {
    if choice.vary.is_some() || choice.writes_files() {
        let text =
            "step = find: is a search, without --vary and without results to write; take the step it finds for them";
        return Err(Fault::value(text).into());
    }
    let results = choice.results();
    let (mut all, mut bar) = (Vec::new(), None);
    for (number, system) in systems.iter().enumerate() {
        let (settings, search) = choice.run.search(system)?;
        let bar = bar.get_or_insert_with(|| Bar::new(systems.len(), settings.until));
        bar.begin(number, system.law.map_or("", |law| law.name));
        let settings = stribeck_solve::run::Settings { cancel: Some(&CANCELLED), progress: Some(&*bar), ..settings };
        all.push(communication_steps(system, &settings, &results, &search)?);
        if verdict(all.last()) == Verdict::Cancelled {
            break;
        }
    }
    bar.iter().for_each(Bar::finish);
    if choice.is_json() {
        let steps: Vec<Value> = all.iter().map(|found| json!(found)).collect();
        println!("{}", json!({ "steps": steps }));
    } else {
        all.iter().for_each(|found| print(choice.run.name(), found));
    }
    Ok(all.iter().map(|found| verdict(Some(found))).max().unwrap_or(Verdict::Done))
}

/// Verdict on a search: without a solution it did not converge; that no step holds in an order of exchange is a result.
fn verdict(found: Option<&CommunicationSteps>) -> Verdict {
    match found.map(|found| &found.end) {
        Some(End::Failed { .. }) => Verdict::Diverged,
        Some(End::Cancelled { .. }) => Verdict::Cancelled,
        _ => Verdict::Done,
    }
}

fn print(system: &str, found: &CommunicationSteps) {
    let CommunicationSteps { law, within, solver, tolerance, end, orders } = found;
    let what = law.unwrap_or(system);
    let part = 100.0 * within;
    println!("{what}: communication steps within {part} % of the solution ({solver} at {tolerance:e}): {end}");
    orders.iter().for_each(print_order);
}

fn print_order(order: &Order) {
    let exchange = order.exchange.to_string();
    match order.step {
        Some(step) => println!("  {exchange}: {step} s"),
        None => println!("  {exchange}: none"),
    }
    if let Some(limit) = order.limit() {
        println!("    at {} s {}", limit.step, limit.fault.as_deref().unwrap_or_default());
    }
    let by_chance: Vec<String> = order.by_chance().iter().map(|step| format!("{step} s")).collect();
    if !by_chance.is_empty() {
        println!("    {} by chance: smaller steps do not hold", by_chance.join(", "));
    }
    let deviations = order.found().map_or(&[][..], |trial| &trial.deviations);
    let width = deviations.iter().map(|one| one.name.len()).max().unwrap_or(0);
    for Deviation { name, unit, value, solution, part } in deviations {
        let (unit, part) = (if unit == "1" { "" } else { unit }, 100.0 * part);
        println!("    {name:<width$}  {value:11.4e} {unit:<4} solution {solution:11.4e}  {part:5.2} % off");
    }
}
