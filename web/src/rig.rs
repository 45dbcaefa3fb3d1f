//! Records of rigs, and laws fitted to them.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Deserialize;
use serde_json::{Value, json};
use stribeck::catalogue;
use stribeck::model::ModelType;
use stribeck_fit::identify::{
    self, EARLY, Experiment, Fit, Ranking, Task, Watch, Wishes, as_json, fit_all, laws_named,
};
use stribeck_fit::measured::{self, Delay, Record, average};
use stribeck_fit::rig::{Faults, VirtualRig};
use stribeck_fit::sheet::Sheet;
use stribeck_solve::system::Fault;

use crate::answer::Answer;
use crate::values::numbers;

/// A virtual rig.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Virtual {
    law: String,
    #[serde(default)]
    set: BTreeMap<String, f64>,
    mass: f64,
    normal_force: f64,
    duration: f64,
    /// Whether it has all faults, not noise alone.
    faults: bool,
    seed: f64,
}

/// Records and what is known of their rig.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// Table of the force, perhaps with the motion.
    table: String,
    /// Table of the motion on its own clock.
    motion: Option<String>,
    mass: f64,
    normal_force: Option<f64>,
    /// Longest delay of the motion that is looked for, in s; 0 for one clock.
    #[serde(default)]
    longest_delay: f64,
}

/// How laws are fitted.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wanted {
    laws: Vec<String>,
    #[serde(default)]
    fix: BTreeMap<String, f64>,
    #[serde(default)]
    fit: Vec<String>,
    budget: Option<f64>,
    repetitions: Option<f64>,
}

/// A count as a user writes it.
fn count(name: &str, value: f64) -> Result<u64, Fault> {
    // Above, not every whole number is one of a user's.
    const MOST: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && (0.0..=MOST).contains(&value) {
        return Ok(value as u64);
    }
    Err(Fault::value(format_args!("{name} = {value}: must be a whole number from 0 to {MOST}")))
}

fn law(name: &str) -> Result<&'static ModelType, Fault> {
    let known = || identify::laws().map(|law| law.name);
    let found = catalogue::by_name(name).filter(|law| known().any(|name| name == law.name));
    found.ok_or_else(|| Fault::unknown("friction law", name, known()))
}

/// The files of a virtual rig, and the values of its law.
pub fn record(given: &Virtual) -> Result<Answer, Fault> {
    let law = law(&given.law)?;
    let values = numbers(&given.set);
    let faults = if given.faults { Faults::ALL } else { Faults::NOISE };
    let Virtual { mass, normal_force, duration, seed, .. } = *given;
    let seed = count("seed", seed)?;
    let rig = VirtualRig { law, values: values.clone(), mass, normal_force, duration, faults, seed };
    let files = rig.record()?;
    let starts = law.variables().filter(|(_, variable)| variable.role.is_parameter());
    let mut truth: BTreeMap<String, f64> =
        starts.map(|(_, variable)| (variable.path.to_string(), variable.start)).collect();
    truth.extend(values);
    Ok(Answer::plain(json!({ "force": files.force, "camera": files.camera, "truth": truth })))
}

impl Known {
    fn record(&self) -> Result<Record, Fault> {
        let sheet =
            |what: &str, text: &str| Sheet::parse(text).map_err(|error| Fault::value(format_args!("{what}: {error}")));
        let table = sheet("record", &self.table)?;
        let motion = self.motion.as_deref().map(|text| sheet("motion", text)).transpose()?;
        let delay = if self.longest_delay > 0.0 { Delay::Find(self.longest_delay) } else { Delay::Known(0.0) };
        let rig = measured::Rig { mass: self.mass, normal_force: self.normal_force, delay, ..Default::default() };
        Record::of(&table, motion.as_ref(), &rig).map_err(Fault::value)
    }
}

/// Quality of a record, its samples, and its mean cycle.
pub fn quality(known: &Known) -> Result<Answer, Fault> {
    let record = known.record()?;
    let quality = &record.quality;
    let cycle = average(&record);
    let told = json!({
        "samples": quality.samples,
        "duration": quality.duration,
        "interval": quality.interval,
        "gaps": quality.gaps.len(),
        "saturated": quality.saturated,
        "noise": quality.noise,
        "resolution": quality.resolution,
        "fastest": quality.fastest,
        "slow": quality.slow,
        "reversals": quality.reversals,
        "loads": quality.loads,
        "findings": quality.findings,
        "window": record.window,
        "differentiated": record.is_differentiated,
        "velocity_error": record.velocity_error,
        "delay": record.clocks.delay,
        "cycles": cycle.as_ref().map_or(0, |cycle| cycle.count),
    });
    let mut arrays = vec![record.time, record.displacement, record.velocity, record.friction_force];
    if let Some(cycle) = cycle {
        arrays.extend([cycle.phase, cycle.displacement, cycle.velocity, cycle.friction_force, cycle.deviation]);
    }
    Ok(Answer::with(told, arrays))
}

/// Fits laws; `progress` hears of what is not explained so far, in N, and returns whether the search is to end with it.
pub fn fit(known: &Known, wanted: &Wanted, progress: &(dyn Fn(f64) -> bool + Sync)) -> Result<Answer, Fault> {
    let record = known.record()?;
    let usual = Task::default();
    let task = Task {
        wishes: Wishes { fixed: numbers(&wanted.fix), fitted: wanted.fit.clone(), ranges: Vec::new() },
        budget: wanted.budget.map_or(Ok(usual.budget), |value| count("budget", value))?,
        repetitions: wanted.repetitions.map_or(Ok(usual.repetitions as u64), |value| count("repetitions", value))?
            as usize,
        mass: known.mass,
        ..usual
    };
    let experiments = [Experiment::new("record", &record)];
    let cancel = AtomicBool::new(false);
    let heard = |level, _| {
        cancel.fetch_or(progress(level), Ordering::Relaxed);
    };
    let watch = Watch { cancel: &cancel, progress: &heard };
    let ranking = fit_all(&laws_named(&wanted.laws)?, &experiments, &task, &mut |_| {}, watch)?;
    let best = ranking.best();
    let fitted = best.explained_in(&best.seen(&record), 0);
    let cycle = average(&fitted).map(|cycle| cycle.friction_force);
    let arrays = std::iter::once(fitted.friction_force).chain(cycle).collect();
    Ok(Answer::with(told(&ranking, best)?, arrays))
}

fn told(ranking: &Ranking, best: &Fit) -> Result<Value, Fault> {
    let set = best.parameter_set(best.law.name)?;
    Ok(json!({
        "ranking": as_json(ranking),
        "best": best.law.name,
        "level": best.level,
        "early": best.is_cancelled.then_some(EARLY),
        "condition": best.condition,
        "toml": best.configuration().text(),
        "ssv": set.to_ssv(),
    }))
}
