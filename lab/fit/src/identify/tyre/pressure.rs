//! Inflation pressures of a tyre test.

use std::collections::BTreeMap;

use stribeck::host::FormulaVersion;

use super::columns::{Sample, TyreTest, TyreTestError};

/// Relative width in which pressures are counted, and part of the samples from which they are a level (chosen).
const WIDTH: f64 = 0.02;
const LEVEL: f64 = 0.02;

/// A level of the pressure: between levels it only passes.
struct Level {
    /// Mean pressure, Pa.
    mean: f64,
    /// Numbers of the samples.
    samples: Vec<usize>,
}

/// The levels of the pressures that were measured.
fn levels(all: &[Sample]) -> Vec<Level> {
    let pressures = || all.iter().enumerate().filter_map(|(at, one)| one.pressure.map(|pressure| (at, pressure)));
    let mut counts: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (at, one) in pressures() {
        counts.entry((one.ln() / WIDTH).round() as i64).or_default().push(at);
    }
    let least = LEVEL * pressures().count() as f64;
    let (mut levels, mut last): (Vec<Vec<usize>>, Option<i64>) = (Vec::new(), None);
    for (bin, samples) in counts.into_iter().filter(|(_, samples)| samples.len() as f64 >= least) {
        match levels.last_mut().filter(|_| last == Some(bin - 1)) {
            Some(level) => level.extend(samples),
            None => levels.push(samples),
        }
        last = Some(bin);
    }
    let level = |mut samples: Vec<usize>| {
        samples.sort_unstable();
        let sum: f64 = samples.iter().filter_map(|at| all[*at].pressure).sum();
        Level { mean: sum / samples.len() as f64, samples }
    };
    levels.into_iter().map(level).collect()
}

/// Levels in kPa.
fn shown(levels: &[Level]) -> String {
    levels.iter().map(|level| format!("{:.1}", 1e-3 * level.mean)).collect::<Vec<_>>().join(", ")
}

/// The levels of samples in kPa; none if no pressure was measured.
pub(super) fn in_words(samples: &[Sample]) -> Option<String> {
    Some(levels(samples)).filter(|levels| !levels.is_empty()).map(|levels| format!("{} kPa", shown(&levels)))
}

/// Levels from which on a test is for version 6.1, whose coefficients of pressure are up to the second order.
const FOR_SIX: usize = 3;

impl TyreTest {
    /// Prepares the test for a version of the formula: 5.2 gets one pressure, 6.1 all of them relative to a nominal one,
    /// by default the level that is nearest to their mean. Unless one is asked for, three pressures make it 6.1.
    pub fn for_version(
        &mut self,
        version: Option<FormulaVersion>,
        wanted: Option<f64>,
        nominal: Option<f64>,
    ) -> Result<(), TyreTestError> {
        let levels = levels(&self.samples);
        let count = self.samples.iter().filter(|one| one.pressure.is_none()).count();
        let is_told = wanted.is_none() && count == 0 && levels.len() >= FOR_SIX;
        let is_six = version.map_or(is_told || nominal.is_some(), |version| version == FormulaVersion::Six);
        if !is_six {
            return self.at_pressure(wanted);
        }
        if count > 0 {
            return Err(TyreTestError::NoPressure { count });
        }
        let mean = self.samples.iter().filter_map(|one| one.pressure).sum::<f64>() / self.samples.len() as f64;
        let distance = |level: &&Level| (level.mean - mean).abs();
        let level = levels.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map_or(mean, |level| level.mean);
        let nominal = nominal.unwrap_or(level);
        self.nominal_pressure = Some(nominal);
        self.notes.push(format!(
            "inflation pressures of {} kPa: fitted together by version 6.1 of the formula, with the nominal pressure {:.1} \
             kPa; --formula 5.2 fits one of them",
            shown(&levels),
            1e-3 * nominal
        ));
        Ok(())
    }

    /// Keeps the samples of one inflation pressure, in Pa; without one those of the pressure with the most samples.
    /// Samples whose pressure was not measured are kept.
    pub fn at_pressure(&mut self, wanted: Option<f64>) -> Result<(), TyreTestError> {
        let levels = levels(&self.samples);
        let shown = if levels.is_empty() { "none".to_owned() } else { format!("{} kPa", shown(&levels)) };
        let distance = |level: &&Level| wanted.map_or(0.0, |wanted| (level.mean / wanted).ln().abs());
        let chosen = match wanted {
            None => levels.iter().max_by_key(|level| level.samples.len()),
            Some(_) => levels.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))),
        };
        let Some(chosen) = chosen.filter(|level| distance(level) <= 2.0 * WIDTH) else {
            return wanted.map_or(Ok(()), |wanted| Err(TyreTestError::Pressure { wanted, levels: shown }));
        };
        if levels.len() > 1 {
            self.notes.push(format!(
                "inflation pressures of {shown}: fitted to the {} samples at {:.1} kPa, since version 5.2 of the formula \
                 has none; another one: --pressure, all of them: --formula 6.1",
                chosen.samples.len(),
                1e-3 * chosen.mean
            ));
            self.note_unknown_pressures();
            let is_kept = |at: usize| self.samples[at].pressure.is_none() || chosen.samples.binary_search(&at).is_ok();
            self.samples = (0..self.samples.len()).filter(|at| is_kept(*at)).map(|at| self.samples[at]).collect();
        }
        Ok(())
    }

    fn note_unknown_pressures(&mut self) {
        let unknown = self.samples.iter().filter(|one| one.pressure.is_none()).count();
        if unknown > 0 {
            self.notes.push(format!("{unknown} samples have no inflation pressure and are fitted as if at this one"));
        }
    }
}
