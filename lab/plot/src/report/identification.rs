//! Report of an identification.

use super::html::Page;
use super::{STYLE, versions_of};
use crate::picture::{Kind, Picture, Theme, beside, friction_map, typeset_unit};
use stribeck_fit::identify::map::FrictionMap;
use stribeck_fit::identify::{
    Difference, EARLY, Estimate, Fit, Method, Rank, Ranking, Readable, Reference, Settings, Verdict, difference,
    digits, known, respond,
};
use stribeck_measured::{Record, average};
use stribeck_solve::system::Fault;

/// An identification and the records it was made from.
#[derive(Clone, Copy, Debug)]
pub struct Identification<'a> {
    /// The records with their names.
    pub records: &'a [(String, Record)],
    /// The maps of friction that were fitted instead, with their names.
    pub maps: &'a [(String, FrictionMap)],
    /// How they were fitted.
    pub task: &'a Settings,
    /// The command line that repeats it; omitted if empty.
    pub command: &'a str,
    /// The fits.
    pub ranking: &'a Ranking,
}

/// The report, as one HTML file.
pub fn html(facts: &Identification) -> Result<String, Fault> {
    let best = facts.ranking.best();
    let mut page = Page::new(&format!("Identification of {}", best.law.name), STYLE);
    for warning in best.is_cancelled.then_some(EARLY).into_iter().chain(best.warnings.iter().map(String::as_str)) {
        page.paragraph("warning", warning);
    }
    estimates(&mut page, best);
    judgement(&mut page, best);
    residuals(&mut page, best);
    pictures_of(&mut page, facts)?;
    ranking(&mut page, facts);
    if facts.maps.is_empty() {
        records(&mut page, facts);
    } else {
        maps(&mut page, facts);
    }
    correlations(&mut page, best);
    settings(&mut page, facts);
    if best.has_load() {
        page.heading("To run a system with it");
        page.listing("stribeck run --config fitted.toml      # with this in fitted.toml:");
        page.listing(&best.configuration().text());
    }
    versions_of(&mut page, [best.law]);
    Ok(page.end())
}

fn pictures_of(page: &mut Page, facts: &Identification) -> Result<(), Fault> {
    page.heading("Pictures");
    let mut pictures = Vec::new();
    for number in 0..facts.records.len() {
        pictures.extend(drawn(facts, number, Theme::Auto)?);
    }
    for (name, map) in facts.maps {
        pictures.push(friction_map(name, map, facts.ranking.best(), Theme::Auto)?);
    }
    page.figures(pictures);
    Ok(())
}

/// Heading of the table of parameters.
const HEAD: [&str; 8] = [
    "Parameter",
    "#Value \u{b1} 95 %",
    "Unit",
    "#Bootstrap interval",
    "#Reference",
    "#Off the reference, %",
    "#Off the mean, %",
    "Verdict",
];

fn estimates(page: &mut Page, best: &Fit) {
    let reference = best.reference();
    page.heading("Parameters");
    let row = |one: &Estimate| (one.verdict != Verdict::Determined, cells(one, best, reference));
    page.marked_table(&HEAD, best.estimates.iter().map(row));
    if let Some(note) = best.note() {
        page.paragraph("note", &note);
    }
}

/// Judgement of values that were given.
fn judgement(page: &mut Page, best: &Fit) {
    let Some(judgement) = &best.judgement else { return };
    page.heading("Values that were given");
    let lines = judgement.lines(best.movement.unit("N"));
    for (line, class) in lines.iter().zip(std::iter::once("note").chain(std::iter::repeat("warning"))) {
        page.paragraph(class, &format!("{}: {line}", judgement.source));
    }
    judgement.note.iter().for_each(|note| page.paragraph("warning", note));
    // As in the table of the parameters, where it is one of them.
    let of = |name: &str| best.estimates.iter().find(|one| one.name == name);
    let text = |name: &str, value: f64| of(name).map_or_else(|| digits(value), |one| one.beside(value));
    let row = |(name, value): (&String, &f64)| [name.clone(), text(name, *value)];
    page.table(&["Parameter", "#Value"], judgement.values.iter().map(row));
}

/// A row of the table of parameters, in one notation; without numbers if the parameter is not determined.
fn cells(one: &Estimate, best: &Fit, reference: Option<&Reference>) -> [String; 8] {
    let Estimate { name, unit, value, verdict, .. } = one;
    let (value_text, repeated) =
        Readable::of(one, best.searches).map_or_else(Default::default, |it| (it.value, it.repeated));
    let known = reference.and_then(|reference| known(reference, one));
    let apart =
        known.filter(|known| *verdict == Verdict::Determined && *known != 0.0).map(|known| difference(*value, known));
    let percent = |of: fn(Difference) -> f64| apart.map_or(String::new(), |apart| format!("{:.1}", of(apart)));
    [
        name.clone(),
        value_text,
        if *unit == "1" { String::new() } else { typeset_unit(unit) },
        repeated.unwrap_or_default(),
        known.map_or(String::new(), |known| one.beside(known)),
        percent(|apart| apart.to_reference),
        percent(|apart| apart.to_mean),
        verdict.to_string(),
    ]
}

/// RMS residuals of the validation records, and statistics of the fit.
fn residuals(page: &mut Page, best: &Fit) {
    for one in &best.validation {
        let text = format!("Validation record {}: RMS residual {} {}.", one.name, digits(one.rms), one.unit);
        page.paragraph("note", &text);
    }
    if let Some(found) = &best.lack_of_fit {
        page.paragraph("note", &format!("{}.", found.text()));
    }
    let (statistics, unit) = (&best.residuals, best.movement.unit("N"));
    page.paragraph(
        "note",
        &format!(
            "RMS residual: {} {unit} of {} {unit}. Correlation of neighbouring residuals {:.2}, correlation time \
             {:.1} of {} samples. Condition {:.1e}. {} evaluations; sensitivities {}.",
            digits(statistics.rms),
            digits(best.level),
            statistics.neighbours,
            statistics.correlation,
            best.samples,
            best.condition,
            best.evaluations,
            if best.is_exact { "exact" } else { "by central differences" }
        ),
    );
}

/// Remark on a law at a place in the ranking, if there is one.
pub fn note(fit: &Fit, rank: &Rank, place: usize) -> Option<&'static str> {
    let is_tied = rank.is_tied && place > 0;
    fit.searches.note().or(is_tied.then_some("cannot be distinguished from the first"))
}

fn ranking(page: &mut Page, facts: &Identification) {
    if facts.ranking.ranks.len() < 2 {
        return;
    }
    page.heading("Laws");
    let residual = format!("#RMS residual in {}", facts.ranking.best().movement.unit("N"));
    let head = ["Law", residual.as_str(), "#Parameters", "#ΔBIC", "Verdict"];
    let row = |(place, rank): (usize, &Rank)| {
        let fit = &facts.ranking.fits[rank.fit];
        let verdict = note(fit, rank, place).unwrap_or("");
        let count = fit.parameters().to_string();
        [fit.law.name.into(), digits(fit.residuals.rms), count, format!("{:.1}", rank.delta_bic), verdict.into()]
    };
    page.table(&head, facts.ranking.ranks.iter().enumerate().map(row));
    for (_, reason) in &facts.ranking.refused {
        page.paragraph("note", reason);
    }
}

fn records(page: &mut Page, facts: &Identification) {
    page.heading("Records");
    let noise = format!("#Noise in {}", facts.ranking.best().movement.unit("N"));
    let head =
        ["Record", "#Samples", "#Length in s", "#Reversals", noise.as_str(), "#Delay of the motion in s", "Findings"];
    let row = |(name, record): &(String, Record)| {
        let quality = &record.quality;
        [
            name.clone(),
            quality.samples.to_string(),
            format!("{:.3}", quality.duration),
            quality.reversals.to_string(),
            digits(quality.noise),
            format!("{:.5}", record.clocks.delay),
            quality.findings.join("; "),
        ]
    };
    page.table(&head, facts.records.iter().map(row));
}

fn maps(page: &mut Page, facts: &Identification) {
    page.heading("Maps");
    let scatter = format!("#Scatter of the repeats in {}", facts.ranking.best().movement.unit("N"));
    let head = ["Map", "#Rows", "#Speeds", scatter.as_str(), "#Its degrees of freedom", "Findings"];
    let row = |(name, map): &(String, FrictionMap)| {
        let scatter = map.scatter.as_ref();
        [
            name.clone(),
            map.velocity.len().to_string(),
            map.count().to_string(),
            scatter.map_or(String::new(), |scatter| digits(scatter.pooled)),
            scatter.map_or(String::new(), |scatter| scatter.freedom.to_string()),
            map.findings.join("; "),
        ]
    };
    page.table(&head, facts.maps.iter().map(row));
}

fn correlations(page: &mut Page, best: &Fit) {
    page.heading("Correlations");
    let names: Vec<&str> = best.estimates.iter().take(best.parameters()).map(|one| one.name.as_str()).collect();
    let titles: Vec<String> = names.iter().map(|name| format!("#{name}")).collect();
    let head: Vec<&str> = std::iter::once("").chain(titles.iter().map(String::as_str)).collect();
    page.matrix(
        &head,
        names.iter().zip(&best.correlation).map(|(name, row)| {
            let values = row.iter().map(|value| format!("{value:.2}"));
            std::iter::once((*name).to_owned()).chain(values).collect::<Vec<String>>()
        }),
    );
}

/// Settings of the fit, including defaults.
fn settings(page: &mut Page, facts: &Identification) {
    let Settings { selection, method, seed, budget, repetitions, mass, is_robust, folds, .. } = facts.task;
    page.heading("How it was fitted");
    let best = facts.ranking.best();
    let head = ["Setting", "Value"];
    let mut rows = vec![
        ("Search", if *method == Method::Genetic { "genetic algorithm" } else { "differential evolution" }.to_owned()),
        ("Seed", seed.to_string()),
        ("Evaluations in a search", budget.to_string()),
        ("Loss", if *is_robust { "robust" } else { "squares" }.to_owned()),
        ("Bootstrap repetitions", repetitions.to_string()),
        ("Parts for cross-validation", folds.to_string()),
    ];
    // A map has no inertia.
    rows.extend(facts.maps.is_empty().then(|| {
        let unit = best.movement.unit("kg");
        ("Mass between load cell and contact", format!("{mass} {unit}, unless it was fitted or held"))
    }));
    rows.extend(selection.fixed.iter().map(|(name, value)| ("Held", format!("{name} = {value}"))));
    rows.extend(selection.fitted.iter().map(|name| ("Fitted as well", name.clone())));
    rows.extend(selection.tied.iter().map(|(name, source)| ("Tied", format!("{name} = {source}"))));
    rows.extend(selection.ranges.iter().map(|(name, [low, high])| ("Range", format!("{name} from {low} to {high}"))));
    page.table(&head, rows.into_iter().map(|(setting, value)| [setting.to_owned(), value]));
    page.listing(facts.command);
}

/// Friction of a record over time, velocity and displacement: measured, of the reference, and fitted (the thesis'
/// Figures 8.7 to 8.11), with the residuals below. Over velocity and displacement it is the mean cycle, if the record is
/// periodic.
pub fn pictures(facts: &Identification, number: usize) -> Result<Vec<Picture>, Fault> {
    drawn(facts, number, Theme::Light)
}

fn drawn(facts: &Identification, number: usize, theme: Theme) -> Result<Vec<Picture>, Fault> {
    let Some((name, record)) = facts.records.get(number) else { return Ok(Vec::new()) };
    let best = facts.ranking.best();
    let corrected = best.corrected(record);
    let mut all = vec![("measured".to_owned(), corrected.clone())];
    if let Some(reference) = best.reference() {
        let friction_force = respond(best.law, reference, &corrected, best.parts)?;
        all.push(("reference".to_owned(), Record { friction_force, ..corrected.clone() }));
    }
    all.push((format!("{} fitted", best.law.name), best.predicted_in(&corrected, number)));
    let cycles = average(&corrected).map_or(0, |cycle| cycle.count);
    let cycled: Vec<(String, Record)> = all.iter().map(|(name, record)| (name.clone(), mean(record))).collect();
    let kinds = [Kind::Force, Kind::ForceOverVelocity, Kind::ForceOverDisplacement];
    let picture = |kind: Kind| {
        let source = if kind == Kind::Force { &all } else { &cycled };
        let of = if kind == Kind::Force || cycles == 0 { String::new() } else { format!(" (mean of {cycles} cycles)") };
        let mut lines = source.iter().map(|(name, record)| (name.clone(), points(kind, record)));
        let measured = lines.next()?;
        let (others, title) = (lines.collect(), |words: &str| format!("{name}: {words}{of}"));
        beside(kind, title, measured, others, |unit| best.movement.unit(unit), theme)
    };
    Ok(kinds.into_iter().filter_map(picture).collect())
}

/// The mean cycle; the record itself if it has none, or if its cycles are different motions.
fn mean(record: &Record) -> Record {
    let Some(cycle) = average(record) else { return record.clone() };
    let mut mean = record.clone();
    mean.time = cycle.phase;
    (mean.displacement, mean.velocity, mean.friction_force) =
        (cycle.displacement, cycle.velocity, cycle.friction_force);
    mean
}

fn points(kind: Kind, record: &Record) -> Vec<[f64; 2]> {
    let across = match kind {
        Kind::ForceOverVelocity => &record.velocity,
        Kind::ForceOverDisplacement => &record.displacement,
        _ => &record.time,
    };
    // An average that mixes both directions is not friction: the curve has a gap there.
    let is_mixed = |at: usize| record.matched_filter.as_ref().is_some_and(|filter| filter.least_speed[at] == 0.0);
    let force = |at: usize| if is_mixed(at) { f64::NAN } else { record.friction_force[at] };
    across.iter().enumerate().map(|(at, x)| [*x, force(at)]).collect()
}
