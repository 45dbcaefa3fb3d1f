//! Records of rigs, and laws fitted to them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};
use stribeck_fit::identify::map::FrictionMap;
use stribeck_fit::identify::{self, Data, EARLY, Fit, Inquiry, Source, Table, Watch};
use stribeck_fit::rig::{Faults, VirtualRig};
use stribeck_measured::{Cycle, Record, Units, average, extremes};
use stribeck_plot::picture::quantity::Quantity;
use stribeck_plot::picture::{Named, fitted_curves};
use stribeck_sheet::{Sheet, SheetError};
use stribeck_solve::job::{self, Entry};
use stribeck_solve::system::Fault;
use ts_rs::TS;

use crate::answer::Answer;

/// A virtual rig.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Virtual {
    law: String,
    #[serde(default, with = "job::table")]
    set: Vec<Entry<f64>>,
    mass: f64,
    normal_force: f64,
    duration: f64,
    /// Whether it has all faults, not noise alone.
    faults: bool,
    seed: u64,
}

/// An identification: its options as a user types them.
#[derive(Debug, Deserialize, TS)]
#[serde(transparent)]
#[ts(rename = "Fit")]
pub struct Asked(#[ts(type = "Record<string, string>")] BTreeMap<String, String>);

impl Asked {
    /// What it describes.
    pub fn inquiry(&self) -> Result<Inquiry, Fault> {
        job::of_texts(&self.0)
    }
}

/// Texts of files by their names.
#[derive(Debug, Deserialize, TS)]
#[serde(transparent)]
pub struct Texts(#[ts(type = "Record<string, string>")] BTreeMap<String, String>);

/// Files of a virtual rig, and the values of its law.
#[derive(Debug, Serialize, TS)]
pub struct Files {
    force: String,
    camera: Option<String>,
    #[ts(type = "Record<string, number>")]
    truth: BTreeMap<String, f64>,
}

/// Name of a quantity of the measurements and its unit.
#[derive(Debug, Serialize, TS)]
pub struct Label {
    name: &'static str,
    unit: &'static str,
}

/// Quantities of the measurements.
#[derive(Debug, Serialize, TS)]
pub struct Labels {
    time: Label,
    displacement: Label,
    velocity: Label,
    force: Label,
}

/// Quality of a record, or of a map of friction.
#[derive(Debug, Serialize, TS)]
pub struct Quality {
    labels: Labels,
    loads: [f64; 2],
    findings: Vec<String>,
    record: Option<RecordQuality>,
    map: Option<MapQuality>,
}

/// Quality of a record.
#[derive(Debug, Serialize, TS)]
pub struct RecordQuality {
    samples: usize,
    duration: f64,
    interval: f64,
    gaps: usize,
    noise: f64,
    fastest: f64,
    slow: f64,
    reversals: usize,
    differentiated: bool,
    velocity_error: f64,
    delay: f64,
    cycles: usize,
}

/// Quality of a map of friction.
#[derive(Debug, Serialize, TS)]
pub struct MapQuality {
    rows: usize,
    /// Number of different speeds and loads.
    settings: usize,
    velocities: [f64; 2],
    /// Standard deviation of the repeats, if there are some.
    scatter: Option<f64>,
}

/// Laws fitted to a record or map, and the best one as files.
#[derive(Debug, Serialize, TS)]
pub struct Fitted {
    ranking: identify::Answer,
    best: &'static str,
    level: f64,
    /// Number of the cycles of the record, as the fit corrects it.
    cycles: usize,
    /// Standard deviation of the noise of what was fitted, or of the scatter of repeats, if it is known.
    noise: Option<f64>,
    /// Names of the curves of steady sliding, if it is a map.
    curves: Vec<String>,
    /// Description of a fit that was cancelled.
    early: Option<&'static str>,
    condition: f64,
    /// The file for `stribeck run`; none for a component, which no system has in place of a law.
    toml: Option<String>,
    ssv: String,
}

impl Source for Texts {
    fn tables(&self, record: &Path, _sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        let text = self.0.iter().find(|(name, _)| Path::new(name) == record);
        Ok(vec![Sheet::parse(text.map_or("", |(_, text)| text))?])
    }
}

/// The files of a virtual rig, the values of its law, and its friction over time.
pub fn record(rig: &BTreeMap<String, String>) -> Result<Answer, Fault> {
    let given: Virtual = job::of_texts(rig)?;
    let law = VirtualRig::law(&given.law)?;
    let values: Vec<(String, f64)> = given.set.iter().map(|Entry(name, value)| (name.clone(), *value)).collect();
    let faults = if given.faults { Faults::ALL } else { Faults::NOISE };
    let Virtual { mass, normal_force, duration, seed, .. } = given;
    let rig = VirtualRig { law, values: values.clone(), mass, normal_force, duration, faults, seed };
    let files = rig.record()?;
    let starts = law.variables().filter(|(_, variable)| variable.role.is_parameter());
    let mut truth: BTreeMap<String, f64> =
        starts.map(|(_, variable)| (variable.path.to_string(), variable.start)).collect();
    truth.extend(values);
    Ok(Answer::with(Files { force: files.force, camera: files.camera, truth }, vec![files.time, files.friction]))
}

/// Quality of a record, its samples, and its mean cycle; or that of a map, and its rows.
pub fn quality(asked: &Asked, files: &Texts) -> Result<Answer, Fault> {
    let [mut tables, _] = asked.inquiry()?.tables(files)?;
    let (_, table) = tables.swap_remove(0);
    Ok(match table {
        Table::Record(record) => of_record(*record),
        Table::Map(map) => of_map(map),
    })
}

fn of_record(record: Record) -> Answer {
    let cycle = average(&record);
    let quality = record.quality.clone();
    let facts = RecordQuality {
        samples: quality.samples,
        duration: quality.duration,
        interval: quality.interval,
        gaps: quality.gaps.len(),
        noise: quality.noise,
        fastest: quality.fastest,
        slow: quality.slow,
        reversals: quality.reversals,
        differentiated: record.is_differentiated,
        velocity_error: record.velocity_error,
        delay: record.clocks.delay,
        cycles: cycle.as_ref().map_or(0, |cycle| cycle.count),
    };
    let answer = Quality {
        labels: Labels::of(record.movement.units()),
        loads: quality.loads,
        findings: quality.findings,
        record: Some(facts),
        map: None,
    };
    Answer::with(answer, samples(record).into_iter().chain(cycle.into_iter().flat_map(mean)).collect())
}

fn of_map(map: FrictionMap) -> Answer {
    let facts = MapQuality {
        rows: map.velocity.len(),
        settings: map.count(),
        velocities: extremes(map.velocity.iter().copied()),
        scatter: map.scatter.as_ref().map(|scatter| scatter.pooled),
    };
    let answer = Quality {
        labels: Labels::of(map.movement.units()),
        loads: extremes(map.normal_force.iter().copied()),
        findings: map.findings,
        record: None,
        map: Some(facts),
    };
    Answer::with(answer, vec![map.velocity, map.force])
}

impl Labels {
    fn of(Units { force, displacement, velocity }: Units) -> Labels {
        let label = |quantity: Quantity, unit| Label { name: quantity.in_unit(unit).names().0, unit };
        Labels {
            time: label(Quantity::Time, "s"),
            displacement: label(Quantity::Displacement, displacement),
            velocity: label(Quantity::Velocity, velocity),
            force: label(Quantity::Force, force),
        }
    }
}

/// Fits laws; `progress` gets the RMS residual so far, in N or N m, and returns whether to end the search.
pub fn fit(asked: &Asked, files: &Texts, progress: &(dyn Fn(f64) -> bool + Sync)) -> Result<Answer, Fault> {
    let inquiry = asked.inquiry()?;
    let data = inquiry.data(files)?;
    let cancel = AtomicBool::new(false);
    let report = |rms, _| {
        cancel.fetch_or(progress(rms), Ordering::Relaxed);
    };
    let ranking = inquiry.fits(&data, &mut |_| {}, Watch { cancel: &cancel, progress: &report })?;
    let best = ranking.best();
    let Explained { cycles, noise, curves, arrays } = match data.maps.first() {
        Some((_, map)) => {
            let noise = map.scatter.as_ref().map(|scatter| scatter.pooled);
            Explained { noise, ..steady(&fitted_curves(map, best)?, best) }
        }
        None => explained(&data, best),
    };
    let answer = Fitted {
        ranking: identify::Answer::of(&ranking, &data),
        best: best.law.name,
        level: best.level,
        cycles,
        noise,
        curves,
        early: best.is_cancelled.then_some(EARLY),
        condition: best.condition,
        toml: best.has_load().then(|| best.configuration().text()),
        ssv: best.parameter_set(best.law.name)?.to_ssv(),
    };
    Ok(Answer::with(answer, arrays))
}

/// Curves of the best law, and of the record that it was fitted to.
#[derive(Default)]
struct Explained {
    cycles: usize,
    noise: Option<f64>,
    curves: Vec<String>,
    arrays: Vec<Vec<f64>>,
}

/// The first record, corrected by what was found, and its mean cycle, each with the friction that a law explains.
fn explained(data: &Data, best: &Fit) -> Explained {
    let Some((_, record)) = data.records.first() else { return Explained::default() };
    let mut corrected = best.corrected(record);
    let fitted = best.predicted_in(&corrected, 0);
    let mut noise = record.quality.noise;
    if let Some(filter) = &corrected.matched_filter {
        noise = filter.noise;
        // An average that mixes both directions is not friction.
        let forces = corrected.friction_force.iter_mut().zip(&filter.least_speed);
        forces.filter(|(_, speed)| **speed == 0.0).for_each(|(force, _)| *force = f64::NAN);
    }
    let cycles = [&corrected, &fitted].map(average);
    let mut arrays = Vec::from(samples(corrected));
    arrays.push(fitted.friction_force);
    let mut explained = Explained { noise: Some(noise), arrays, ..Explained::default() };
    if let [Some(cycle), Some(fitted)] = cycles {
        explained.cycles = cycle.count;
        explained.arrays.extend(mean(cycle));
        explained.arrays.push(fitted.friction_force);
    }
    explained
}

/// Time, displacement, velocity and friction.
fn samples(record: Record) -> [Vec<f64>; 4] {
    [record.time, record.displacement, record.velocity, record.friction_force]
}

/// Phase, displacement, velocity and friction of a mean cycle.
fn mean(cycle: Cycle) -> [Vec<f64>; 4] {
    [cycle.phase, cycle.displacement, cycle.velocity, cycle.friction_force]
}

/// The friction that a law explains in each row of the first map; names of curves, and the coordinates of each.
fn steady(curves: &[Named], best: &Fit) -> Explained {
    let coordinates = |(_, points): &Named| [0, 1].map(|axis| points.iter().map(|point| point[axis]).collect());
    let names = curves.iter().map(|(name, _)| name.clone()).collect();
    let rows = best.predicted.first().cloned();
    let arrays = rows.into_iter().chain(curves.iter().flat_map(coordinates)).collect();
    Explained { curves: names, arrays, ..Explained::default() }
}
