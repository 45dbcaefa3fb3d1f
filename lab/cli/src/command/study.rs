//! `stribeck study`: many runs, one table.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Args;
use stribeck_solve::study::{Done, Shard, Study};
use stribeck_solve::system::read;

use super::watch::{CANCELLED, Rows, heed_interrupts};
use super::{Failure, Verdict};

/// A study, the part of it to do, and the folder for its results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// The study (.toml): samples, seed, vary, table, keep, and run as `stribeck run --save-config` writes it
    study: PathBuf,
    /// Folder for the chunks and, once all are there, for study.csv; what is there is not run again
    #[arg(long, short)]
    out: PathBuf,
    /// Part i of n, for a machine of several that share the folder; `array` or `array/n` takes i from the job array of
    /// SLURM, PBS, Grid Engine or AWS Batch
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    shard: Shard,
    /// End once more rows than this have not come to their end; what is done is kept
    #[arg(long, value_name = "N")]
    max_failures: Option<usize>,
    /// Threads; all processors if it is not given
    #[arg(long)]
    threads: Option<NonZeroUsize>,
    /// Only join the chunks that are in the folder
    #[arg(long)]
    merge: bool,
}

/// Makes a study, or its part, and joins it once it is complete.
pub fn study(arguments: &Arguments) -> Result<Verdict, Failure> {
    let folder = arguments.study.parent().unwrap_or(Path::new(""));
    let study = Study::new(read(&arguments.study)?, folder)?;
    let table = arguments.out.join("study.csv");
    if arguments.merge {
        let rows = study.merge(&arguments.out, &table)?;
        println!("{}: {rows} rows", table.display());
        return Ok(Verdict::Done);
    }
    heed_interrupts();
    let done = make(arguments, &study)?;
    println!("{} rows run, {} found, {} did not come to their end", done.rows, done.found, done.failed);
    if done.cancelled {
        return Ok(Verdict::Cancelled);
    }
    if arguments.shard.count == 1 {
        println!("{}: {} rows", table.display(), study.merge(&arguments.out, &table)?);
    }
    Ok(if done.failed > 0 { Verdict::Diverged } else { Verdict::Done })
}

fn make(Arguments { out, shard, threads, max_failures, .. }: &Arguments, study: &Study) -> Result<Done, Failure> {
    let threads = threads.or(std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let (bar, count) = (Rows::new(study.rows_of(*shard)), AtomicUsize::new(0));
    let progress = |rows: usize| bar.reached(count.fetch_add(rows, Ordering::Relaxed) + rows);
    let done = study.make(out, *shard, threads, *max_failures, &CANCELLED, &progress)?;
    bar.finish();
    Ok(done)
}
