//! Reports of runs and of identifications: one HTML file with everything about them, which can be mailed.
//!
//! It needs no script and no network, and follows the reader's choice of light or dark.

mod html;
pub mod identification;

use std::collections::BTreeSet;

use stribeck::model::{ModelType, Role};
use stribeck::unit::UNITS;

use crate::picture::{self, Options, Theme, escape, typeset_unit};
use html::Page;
pub use identification::Identification;
use stribeck_solve::run::{Check, Difference, Outcome};
use stribeck_solve::system::{Part, Place, Signal, System, WireSource};

const STYLE: &str = include_str!("style.css");

/// Contents of a report besides the outcomes.
#[derive(Clone, Copy, Debug)]
pub struct Facts<'a> {
    /// The system of each outcome, with its law; empty if the system is that of all of them.
    pub systems: &'a [System],
    /// Relative and absolute tolerance of the runs.
    pub tolerance: f64,
    /// The command line that repeats the runs; omitted if empty.
    pub command: &'a str,
    /// The description of the system; omitted if empty.
    pub toml: &'a str,
    /// Time range of the zoom, in s; found automatically if none is given.
    pub zoom: Option<[f64; 2]>,
    /// Largest number of events that are listed for each law.
    pub events: usize,
}

impl Default for Facts<'_> {
    fn default() -> Self {
        Facts { systems: &[], tolerance: 1e-8, command: "", toml: "", zoom: None, events: 12 }
    }
}

/// The report of the outcomes, each with the name of its law.
pub fn html(system: &System, outcomes: &[(String, Outcome)], facts: &Facts) -> String {
    let mut page = Page::new(&system.description.title, STYLE);
    if !system.description.source.is_empty() {
        page.paragraph("source", &system.description.source);
    }
    warnings(&mut page, outcomes);
    pictures(&mut page, system, outcomes, facts);
    solver(&mut page, outcomes, facts);
    checks(&mut page, outcomes);
    events(&mut page, outcomes, facts.events);
    parts(&mut page, system, facts);
    connections(&mut page, system);
    parameters(&mut page, system, outcomes, facts);
    if !(facts.command.is_empty() && facts.toml.is_empty()) {
        page.heading("To repeat it");
        page.listing(facts.command);
        page.listing(facts.toml);
    }
    versions(&mut page, system, facts);
    page.end()
}

/// Runs that did not come to their end, or whose tolerance does not hold, before anything else.
fn warnings(page: &mut Page, outcomes: &[(String, Outcome)]) {
    for (law, outcome) in outcomes {
        let Some(fault) = outcome.fault() else { continue };
        let curves = if outcome.is_reached() { "" } else { " Its curves end there." };
        page.paragraph("warning", &format!("{law}: {fault}.{curves}"));
    }
}

fn pictures(page: &mut Page, system: &System, outcomes: &[(String, Outcome)], facts: &Facts) {
    page.heading("Pictures");
    page.figures(picture::all(system, outcomes, &Options { theme: Theme::Auto, zoom: facts.zoom }));
}

fn solver(page: &mut Page, outcomes: &[(String, Outcome)], facts: &Facts) {
    page.heading("Solver");
    let head = ["Law", "Solver", "Tolerance", "#Steps", "#Rejected", "#Evaluations", "#Jacobians", "#Events", "End"];
    let row = |(law, outcome): &(String, Outcome)| {
        let statistics = &outcome.statistics;
        let counts = [statistics.steps, statistics.rejected, statistics.evaluations, statistics.jacobians];
        let mut cells = vec![law.clone(), outcome.solver.to_string(), format!("{:e}", facts.tolerance)];
        cells.extend(counts.map(|count| count.to_string()));
        cells.extend([outcome.events.len().to_string(), outcome.end.to_string()]);
        (!outcome.is_reached(), cells)
    };
    page.marked_table(&head, outcomes.iter().map(row));
}

/// Differences from the finer runs, where there are some.
fn checks(page: &mut Page, outcomes: &[(String, Outcome)]) {
    let checks = || outcomes.iter().filter_map(|(law, outcome)| Some((law, outcome.check.as_ref()?)));
    let Some((_, Check { of, finer, .. })) = checks().next() else { return };
    page.heading("Check");
    page.paragraph("note", &format!("Largest differences from {}.", of.run(*finer)));
    let head = ["Law", "Result", "#Difference", "Unit", "#Part of its range", "#Time in s"];
    let rows = checks().flat_map(|(law, check)| {
        check.differences.iter().map(move |one| {
            let Difference { name, unit, largest, part, .. } = one;
            let unit = if unit == "1" { String::new() } else { typeset_unit(unit) };
            let [largest, part] = [largest, part].map(|number| format!("{number:.2e}"));
            (check.fault.is_some(), [law.clone(), name.clone(), largest, unit, part, one.shown_time()])
        })
    });
    page.marked_table(&head, rows);
}

fn events(page: &mut Page, outcomes: &[(String, Outcome)], most: usize) {
    page.heading("Events");
    let head = ["Law", "#Number", "#Time in s", "Part"];
    let rows = outcomes.iter().flat_map(|(law, outcome)| {
        let events = outcome.events.iter().take(most).enumerate();
        events.map(|(at, event)| [law.clone(), (at + 1).to_string(), event.time.to_string(), event.part.clone()])
    });
    page.table(&head, rows);
    for (law, outcome) in outcomes {
        let (count, shown) = (outcome.events.len(), outcome.events.len().min(most));
        let text = match count {
            0 => format!("{law}: no events."),
            1 if shown == 1 => format!("{law}: 1 event."),
            _ if shown < count => format!("{law}: the first {shown} of {count} events."),
            _ => format!("{law}: all {count} events."),
        };
        page.paragraph("note", &text);
    }
}

/// The systems of the outcomes.
fn systems<'a>(system: &'a System, facts: &Facts<'a>) -> &'a [System] {
    if facts.systems.is_empty() { std::slice::from_ref(system) } else { facts.systems }
}

fn parts(page: &mut Page, system: &System, facts: &Facts) {
    page.heading("Parts");
    let head = ["Part", "Model", "Meaning"];
    let mut listed = BTreeSet::new();
    let parts = systems(system, facts).iter().flat_map(|system| &system.parts);
    let parts = parts.filter(|part| listed.insert((&part.name, part.model.name)));
    page.table(&head, parts.map(|part| [&part.name, part.model.name, part.model.summary].map(str::to_owned)));
}

/// Inputs with the outputs that they are connected to, and with their signals.
fn connections(page: &mut Page, system: &System) {
    page.heading("Connections");
    let head = ["Input", "Comes from"];
    let wires = system.wires.iter().map(|wire| {
        let from = match wire.from {
            WireSource::Variable(place) => system.name(place),
            WireSource::Derivative(place) => format!("der({})", system.name(place)),
        };
        [system.name(wire.to), from]
    });
    let signals = system.signals.iter();
    let signals = signals.map(|(place, signal)| [system.name(*place), course(system, *place, signal)]);
    page.table(&head, wires.chain(signals));
}

/// A signal as it is written down.
fn course(system: &System, place: Place, signal: &Signal) -> String {
    if let Signal::Constant(value) = signal {
        let unit = system.unit(WireSource::Variable(place)).name;
        return if unit == "1" { value.to_string() } else { format!("{value} {}", typeset_unit(&unit)) };
    }
    let inputs = &system.description.input;
    let written = inputs.iter().find(|(name, _)| system.place(name).is_ok_and(|known| known == place));
    let text = written.and_then(|(_, signal)| toml::Value::try_from(signal).ok()).map(|value| value.to_string());
    text.unwrap_or_else(|| "a signal".to_owned())
}

/// Parameters and start values that differ from those of the models: what all laws share once, the others for each law.
fn parameters(page: &mut Page, system: &System, outcomes: &[(String, Outcome)], facts: &Facts) {
    page.heading("Parameters that differ from the defaults");
    let of_system = |system: &System| -> Vec<[String; 5]> { system.parts.iter().flat_map(differences).collect() };
    let all: Vec<Vec<[String; 5]>> = systems(system, facts).iter().map(of_system).collect();
    let is_shared = |row: &[String; 5]| all.iter().all(|rows| rows.contains(row));
    let shared = all.iter().take(1).flatten().filter(|row| is_shared(row)).map(|row| ("all", row));
    let labels = outcomes.iter().map(|(label, _)| label.as_str());
    let own = labels.zip(&all).flat_map(|(label, rows)| rows.iter().map(move |row| (label, row)));
    let rows: Vec<(&str, &[String; 5])> = shared.chain(own.filter(|(_, row)| !is_shared(row))).collect();
    if rows.is_empty() {
        page.paragraph("note", "None: all parameters have the values of their models.");
        return;
    }
    let head = ["Parameter", "#Value", "Unit", "#Default", "Meaning", "Law"];
    let cells = |(label, row): (&str, &[String; 5])| [row.as_slice(), &[label.to_owned()]].concat();
    page.table(&head, rows.into_iter().map(cells));
}

/// The parameters and start values of a part that differ from those of its model: name, value, unit, default, meaning.
fn differences(part: &Part) -> Vec<[String; 5]> {
    let mut rows = Vec::new();
    for (variable, value) in part.model.table.iter().zip(&part.row) {
        if matches!(variable.role, Role::Input | Role::Output) || *value == variable.start {
            continue;
        }
        let text = |value: f64| ssp::parameter_set::text_of(&variable, value);
        let unit = match variable.kind {
            stribeck::model::Kind::Real(unit) if unit != &UNITS[0] => typeset_unit(unit.name),
            _ => String::new(),
        };
        let name = format!("{}.{}", part.name, variable.path);
        rows.push([name, text(*value), unit, text(variable.start), variable.help.to_owned()]);
    }
    rows
}

/// Versions: of the program, and of the interface of each model.
fn versions(page: &mut Page, system: &System, facts: &Facts) {
    let parts = systems(system, facts).iter().chain([system]).flat_map(|system| &system.parts);
    versions_of(page, parts.map(|part| part.model));
}

/// Version of the program, and the guid of each of the models.
fn versions_of(page: &mut Page, models: impl IntoIterator<Item = &'static ModelType>) {
    page.heading("Versions");
    page.paragraph("", &format!("Stribeck {}", env!("CARGO_PKG_VERSION")));
    let head = ["Model", "Guid"];
    let mut listed = BTreeSet::new();
    let models = models.into_iter().filter(|model| listed.insert(model.name));
    page.table(&head, models.map(|model| [model.name, model.guid()].map(str::to_owned)));
}

#[cfg(test)]
mod tests;
