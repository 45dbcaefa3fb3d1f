//! Studies: many runs of a system with values from ranges, distributions or a table, whose results are few numbers each.
//!
//! Rows are made in chunks. Each chunk is a file that appears only when it is complete and names the study it belongs to,
//! so that an interrupted study goes on where it was, and several machines share one.

mod chunk;
mod description;
mod quantity;
mod sample;
#[cfg(test)]
mod tests;

use std::fmt;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

pub use chunk::merge;
pub use description::{Description, Spread};
pub use quantity::Quantity;

use crate::run::{Settings, run};
use crate::system::{Fault, Setting, Source, System};
use crate::work;
use chunk::{Chunk, chunks};
use sample::Samples;

/// A study that has passed all checks.
#[derive(Debug)]
pub struct Study {
    description: Description,
    source: Source,
    laws: Vec<Option<String>>,
    samples: Samples,
    quantities: Vec<Quantity>,
    /// Fingerprint of what determines the results.
    hash: String,
}

/// The part of a study that one machine does: `number` of `count`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Its number, from 1.
    pub number: usize,
    /// How many there are.
    pub count: usize,
}

/// Variables by which a cluster tells each job of an array its number: the number, the first one, the step from one to the
/// next, and how many there are. SLURM, AWS Batch, Grid Engine, PBS.
const ARRAYS: [[&str; 4]; 4] = [
    ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP", "SLURM_ARRAY_TASK_COUNT"],
    ["AWS_BATCH_JOB_ARRAY_INDEX", "", "", "AWS_BATCH_JOB_ARRAY_SIZE"],
    ["SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_STEPSIZE", ""],
    ["PBS_ARRAY_INDEX", "", "", ""],
];

impl std::str::FromStr for Shard {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Shard, Fault> {
        if text == "array" || text.starts_with("array/") {
            return Shard::of_array(text, &|name| std::env::var(name).ok());
        }
        let wrong = || Fault::value(format_args!("shard '{text}': must be i/n with i from 1 to n"));
        let (number, count) = text.split_once('/').ok_or_else(wrong)?;
        let (Ok(number), Ok(count)) = (number.trim().parse(), count.trim().parse()) else { return Err(wrong()) };
        if (1..=count).contains(&number) { Ok(Shard { number, count }) } else { Err(wrong()) }
    }
}

impl Shard {
    /// The part of a job in an array of jobs: `array`, or `array/n` where the cluster does not say how many there are.
    /// Numbers of a cluster that does not say where they begin begin at 1, those of AWS at 0.
    fn of_array(text: &str, variable: &dyn Fn(&str) -> Option<String>) -> Result<Shard, Fault> {
        let wrong = |why: fmt::Arguments| Fault::value(format_args!("shard '{text}': {why}"));
        let set = |name: &str| variable(name).filter(|value| !value.is_empty() && value != "undefined");
        let names = ARRAYS.iter().find(|names| set(names[0]).is_some()).ok_or_else(|| {
            let known = ARRAYS.map(|names| names[0]).join(", ");
            wrong(format_args!("this is not a job of an array: none of {known} is set"))
        })?;
        let unknown = || wrong(format_args!("{} does not say how many jobs there are: give array/n", names[0]));
        let number = |name: &str, otherwise: Option<usize>| match set(name) {
            None => otherwise.ok_or_else(unknown),
            Some(value) => value.parse().map_err(|_| wrong(format_args!("{name} = '{value}' is not a number"))),
        };
        let begins = if names[0].starts_with("AWS") { 0 } else { 1 };
        let [index, first, step] =
            [number(names[0], None)?, number(names[1], Some(begins))?, number(names[2], Some(1))?];
        let count = match text.split_once('/') {
            Some((_, count)) => count.trim().parse().ok(),
            None => Some(number(names[3], None)?),
        };
        let place = index.checked_sub(first).map(|distance| distance / step.max(1) + 1);
        match (place, count) {
            (Some(number), Some(count)) if (1..=count).contains(&number) => Ok(Shard { number, count }),
            _ => Err(wrong(format_args!("{} = {index} is not one of the jobs", names[0]))),
        }
    }
}

/// Outcome of a study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Rows that were run.
    pub rows: usize,
    /// Rows that were there already.
    pub found: usize,
    /// Rows that did not come to their end, of those that were run.
    pub failed: usize,
    /// Whether it was ended early.
    pub cancelled: bool,
}

impl Study {
    /// Checks a description; file names in it are relative to `folder`.
    pub fn new(description: Description, folder: &Path) -> Result<Study, Fault> {
        let source = description.run.source()?;
        let laws: Vec<Option<String>> = match description.run.law.as_slice() {
            [] => vec![None],
            laws => laws.iter().cloned().map(Some).collect(),
        };
        let samples = Samples::of(&description, folder)?;
        let quantities = description.keep.iter().map(|text| text.parse()).collect::<Result<Vec<Quantity>, Fault>>()?;
        if quantities.is_empty() {
            return Err(Fault::value("keep: must name at least one quantity, such as \"max rig.position\""));
        }
        let mut study = Study { description, source, laws, samples, quantities, hash: String::new() };
        let systems = study.check()?;
        study.hash = chunk::hash(&study.description, &study.samples, &systems);
        Ok(study)
    }

    /// Assembles the first sample of each law: names, and results to keep, that do not exist are refused at once.
    fn check(&self) -> Result<Vec<System>, Fault> {
        let mut systems = Vec::new();
        for law in 0..self.laws.len() {
            systems.push(self.system(law * self.samples.len())?);
        }
        System::refuse_unused(&systems)?;
        for system in &systems {
            self.description.run.settings(system)?.check()?;
            for quantity in &self.quantities {
                quantity.result().map_or(Ok(()), |name| system.source(name).map(|_| ()))?;
            }
        }
        Ok(systems)
    }

    /// Number of rows: all samples with each law.
    pub fn rows(&self) -> usize {
        self.laws.len() * self.samples.len()
    }

    /// Number of rows of a shard.
    pub fn rows_of(&self, shard: Shard) -> usize {
        chunks(self.rows(), shard).map(|chunk| chunk.rows.len()).sum()
    }

    fn law(&self, row: usize) -> Option<&str> {
        self.laws[row / self.samples.len()].as_deref()
    }

    fn system(&self, row: usize) -> Result<System, Fault> {
        let mut settings = self.description.run.values();
        let values = self.samples.row(row % self.samples.len());
        let named = self.samples.names().zip(values);
        settings.extend(named.map(|(name, value)| Setting { name: name.to_owned(), value: value.to_string() }));
        System::assemble(&self.source, self.law(row), &settings)
    }

    /// Heading of the table.
    fn heading(&self) -> Vec<String> {
        let fixed = ["row", "law"].map(str::to_owned);
        let kept = self.quantities.iter().map(Quantity::to_string);
        fixed.into_iter().chain(self.samples.names().map(str::to_owned)).chain(kept).chain(["end".to_owned()]).collect()
    }

    /// A row of the table, and whether the run came to its end. A run that did not has no results and its reason.
    fn row(&self, row: usize, cancel: &AtomicBool) -> (Vec<String>, bool) {
        let (kept, end) = match self.results(row, cancel) {
            Ok(results) => (results.iter().map(f64::to_string).collect(), "reached".to_owned()),
            Err(reason) => (vec![String::new(); self.quantities.len()], reason),
        };
        let values = self.samples.row(row % self.samples.len()).into_iter().map(|value| value.to_string());
        let is_reached = end == "reached";
        let law = self.law(row).unwrap_or("").to_owned();
        let cells = [row.to_string(), law].into_iter().chain(values).chain(kept).chain([end]);
        (cells.collect(), is_reached)
    }

    fn results(&self, row: usize, cancel: &AtomicBool) -> Result<Vec<f64>, String> {
        let system = self.system(row).map_err(|fault| fault.to_string())?;
        let settings = self.description.run.settings(&system).map_err(|fault| fault.to_string())?;
        let names: Vec<String> = self.quantities.iter().filter_map(|one| one.result().map(str::to_owned)).collect();
        let settings = Settings { cancel: Some(cancel), ..settings };
        let outcome = run(&system, &settings, &names).map_err(|fault| fault.to_string())?;
        if let Some(fault) = outcome.fault() {
            return Err(fault);
        }
        Ok(self.quantities.iter().map(|quantity| quantity.of(&outcome)).collect())
    }

    /// Number of chunks; and the number and the rows of each that is not in the folder yet. Each is a shard by itself: the
    /// chunk `n` of `count` is that of the shard `n + 1` of `count`.
    pub fn missing(&self, folder: &Path) -> Result<(usize, Vec<(usize, usize)>), Fault> {
        let all: Vec<Chunk> = chunks(self.rows(), Shard { number: 1, count: 1 }).collect();
        let mut missing = Vec::new();
        for (number, chunk) in all.iter().enumerate() {
            if !chunk.is_made(folder, &self.hash)? {
                missing.push((number, chunk.rows.len()));
            }
        }
        Ok((all.len(), missing))
    }

    /// Makes the chunks of a shard that are not in the folder yet, with some threads. `progress` hears of each row. Refused
    /// once more rows than `most_failures` have not come to their end; the chunks up to there are kept.
    pub fn make(
        &self,
        folder: &Path,
        shard: Shard,
        threads: NonZeroUsize,
        most_failures: Option<usize>,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Done, Fault> {
        let mut done = Done::default();
        for chunk in chunks(self.rows(), shard) {
            if chunk.is_made(folder, &self.hash)? {
                done.found += chunk.rows.len();
                progress(chunk.rows.len());
                continue;
            }
            let rows = self.chunk(&chunk, threads, cancel, progress);
            if cancel.load(Ordering::Relaxed) {
                done.cancelled = true;
                break;
            }
            done.rows += rows.len();
            done.failed += rows.iter().filter(|(_, is_reached)| !is_reached).count();
            chunk.write(folder, &self.hash, &self.heading(), rows.iter().map(|(cells, _)| cells))?;
            if let Some(most) = most_failures.filter(|most| done.failed > *most) {
                return Err(too_many(done.failed, most, &rows));
            }
        }
        Ok(done)
    }

    /// The rows of a chunk, in their order.
    fn chunk(
        &self,
        chunk: &Chunk,
        threads: NonZeroUsize,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Vec<(Vec<String>, bool)> {
        let made = Mutex::new(Vec::new());
        let row = |number: usize| {
            let result = self.row(chunk.rows.start + number, cancel);
            made.lock().unwrap_or_else(PoisonError::into_inner).push((number, result));
            progress(1);
        };
        work::share(chunk.rows.len(), threads.get(), |_| !cancel.load(Ordering::Relaxed), || row);
        let mut made = made.into_inner().unwrap_or_else(PoisonError::into_inner);
        made.sort_by_key(|(row, _)| *row);
        made.into_iter().map(|(_, result)| result).collect()
    }

    /// Joins the chunks of all shards into one table.
    pub fn merge(&self, folder: &Path, to: &Path) -> Result<usize, Fault> {
        merge(folder, to, self.rows(), &self.hash)
    }
}

/// Refusal to go on, with the last reason.
fn too_many(failed: usize, most: usize, rows: &[(Vec<String>, bool)]) -> Fault {
    let last = rows.iter().rev().find(|(_, is_reached)| !is_reached);
    let reason = last.and_then(|(cells, _)| Some((cells.first()?, cells.last()?)));
    let (row, reason) = reason.map_or(("?", "?"), |(row, reason)| (row.as_str(), reason.as_str()));
    Fault::value(format_args!(
        "{failed} rows did not come to their end, more than {most} (max-failures); the last one is row {row}: {reason}"
    ))
}
