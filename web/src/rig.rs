//! Records of rigs, and laws fitted to them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};
use stribeck_fit::identify::{self, EARLY, Inquiry, Source, Watch, no_record};
use stribeck_fit::measured::{Units, average};
use stribeck_fit::rig::{Faults, VirtualRig};
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

/// Quality of a record.
#[derive(Debug, Serialize, TS)]
pub struct Quality {
    units: Units,
    samples: usize,
    duration: f64,
    interval: f64,
    gaps: usize,
    saturated: f64,
    noise: f64,
    resolution: f64,
    fastest: f64,
    slow: f64,
    reversals: usize,
    loads: [f64; 2],
    findings: Vec<String>,
    window: f64,
    differentiated: bool,
    velocity_error: f64,
    delay: f64,
    cycles: usize,
}

/// Laws fitted to a record, and the best one as files.
#[derive(Debug, Serialize, TS)]
pub struct Fitted {
    ranking: identify::Answer,
    best: &'static str,
    level: f64,
    /// Description of a fit that was cancelled.
    early: Option<&'static str>,
    condition: f64,
    toml: String,
    ssv: String,
}

impl Source for Texts {
    fn tables(&self, record: &Path, _sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        let text = self.0.iter().find(|(name, _)| Path::new(name) == record);
        Ok(vec![Sheet::parse(text.map_or("", |(_, text)| text))?])
    }
}

/// The files of a virtual rig, and the values of its law.
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
    Ok(Answer::plain(Files { force: files.force, camera: files.camera, truth }))
}

/// Quality of a record, its samples, and its mean cycle.
pub fn quality(asked: &Asked, files: &Texts) -> Result<Answer, Fault> {
    let [mut records, _] = asked.inquiry()?.records(files)?;
    let (_, record) = records.swap_remove(0);
    let cycle = average(&record);
    let quality = &record.quality;
    let answer = Quality {
        units: record.movement.units(),
        samples: quality.samples,
        duration: quality.duration,
        interval: quality.interval,
        gaps: quality.gaps.len(),
        saturated: quality.saturated,
        noise: quality.noise,
        resolution: quality.resolution,
        fastest: quality.fastest,
        slow: quality.slow,
        reversals: quality.reversals,
        loads: quality.loads,
        findings: quality.findings.clone(),
        window: record.window,
        differentiated: record.is_differentiated,
        velocity_error: record.velocity_error,
        delay: record.clocks.delay,
        cycles: cycle.as_ref().map_or(0, |cycle| cycle.count),
    };
    let mut arrays = vec![record.time, record.displacement, record.velocity, record.friction_force];
    if let Some(cycle) = cycle {
        arrays.extend([cycle.phase, cycle.displacement, cycle.velocity, cycle.friction_force, cycle.deviation]);
    }
    Ok(Answer::with(answer, arrays))
}

/// Fits laws; `progress` gets the RMS residual so far, in N or N m, and returns whether to end the search.
pub fn fit(asked: &Asked, files: &Texts, progress: &(dyn Fn(f64) -> bool + Sync)) -> Result<Answer, Fault> {
    let inquiry = asked.inquiry()?;
    let data = inquiry.data(files)?;
    // The page shows a record beside the fit; that there is none is said before the search.
    let Some((_, record)) = data.records.first() else {
        return Err(no_record(data.maps.first().map_or("", |(name, _)| name)));
    };
    let cancel = AtomicBool::new(false);
    let report = |rms, _| {
        cancel.fetch_or(progress(rms), Ordering::Relaxed);
    };
    let ranking = inquiry.fits(&data, &mut |_| {}, Watch { cancel: &cancel, progress: &report })?;
    let best = ranking.best();
    let fitted = best.predicted_in(&best.corrected(record), 0);
    let cycle = average(&fitted).map(|cycle| cycle.friction_force);
    let arrays = std::iter::once(fitted.friction_force).chain(cycle).collect();
    let answer = Fitted {
        ranking: identify::Answer::of(&ranking, &data),
        best: best.law.name,
        level: best.level,
        early: best.is_cancelled.then_some(EARLY),
        condition: best.condition,
        toml: best.configuration().text(),
        ssv: best.parameter_set(best.law.name)?.to_ssv(),
    };
    Ok(Answer::with(answer, arrays))
}
