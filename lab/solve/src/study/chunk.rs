//! Files of finished rows.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::Shard;
use super::description::Description;
use super::sample::Samples;
use crate::system::{Fault, System};

/// Rows of a chunk (chosen): a second of work for the fastest runs.
const ROWS: usize = 1000;

/// Files written by this process: several threads of it may write the same one.
static WRITTEN: AtomicUsize = AtomicUsize::new(0);

/// Rows that are run and written together.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chunk {
    number: usize,
    /// Numbers of its rows.
    pub rows: Range<usize>,
}

/// The chunks of a shard: every n-th one.
pub(super) fn chunks(rows: usize, shard: Shard) -> impl Iterator<Item = Chunk> {
    let all = (0..rows.div_ceil(ROWS)).map(move |number| at(number, rows));
    all.skip(shard.number - 1).step_by(shard.count)
}

fn at(number: usize, rows: usize) -> Chunk {
    Chunk { number, rows: number * ROWS..rows.min((number + 1) * ROWS) }
}

/// Fingerprint of a study: of its description, its table, its systems with their signals, and the version of the program
/// (FNV-1a with 64 bits, G. Fowler, L. C. Noll, K.-P. Vo; RFC 9923). A file that was changed makes another study.
pub(super) fn hash(description: &Description, samples: &Samples, systems: &[System]) -> String {
    let described = toml::to_string(description).unwrap_or_default();
    let mut text = format!("{}\n{described}\n{}", env!("CARGO_PKG_VERSION"), samples.text());
    for system in systems {
        text += &toml::to_string(&system.description).unwrap_or_default();
        text += &format!("{:?}\n", system.signals);
    }
    let hash = text
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    format!("{hash:016x}")
}

fn wrong(path: &Path, error: impl std::fmt::Display) -> Fault {
    Fault::File(format!("{}: {error}", path.display()))
}

impl Chunk {
    fn path(&self, folder: &Path) -> PathBuf {
        folder.join(format!("chunk-{:06}.csv", self.number))
    }

    /// First line of its file.
    fn mark(&self, hash: &str) -> String {
        format!("# study {hash}, rows {} to {}", self.rows.start, self.rows.end - 1)
    }

    /// Whether its file is there. One of another study is refused.
    pub fn is_made(&self, folder: &Path, hash: &str) -> Result<bool, Fault> {
        let path = self.path(folder);
        let Ok(file) = File::open(&path) else { return Ok(false) };
        let mut first = String::new();
        BufReader::new(file).read_line(&mut first).map_err(|error| wrong(&path, error))?;
        if first.trim_end() == self.mark(hash) {
            return Ok(true);
        }
        Err(wrong(&path, "belongs to another study: choose another folder, or remove it"))
    }

    /// Writes its file: under another name first, so that it is never there by half.
    pub fn write<'a>(
        &self,
        folder: &Path,
        hash: &str,
        heading: &[String],
        rows: impl Iterator<Item = &'a Vec<String>>,
    ) -> Result<(), Fault> {
        fs::create_dir_all(folder).map_err(|error| wrong(folder, error))?;
        whole(&self.path(folder), |mut file| {
            writeln!(file, "{}", self.mark(hash))?;
            let mut table = csv::Writer::from_writer(file);
            table.write_record(heading)?;
            for row in rows {
                table.write_record(row)?;
            }
            table.into_inner().map_err(|error| error.into_error())
        })
    }

    /// Copies its rows to a table, and its heading if it is the first one.
    fn copy(&self, folder: &Path, table: &mut impl Write) -> io::Result<()> {
        let path = self.path(folder);
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{}: {error}", path.display()));
        // The heading of the first one stands for all.
        let skipped = if self.number == 0 { 1 } else { 2 };
        let mut lines = BufReader::new(File::open(&path).map_err(named)?).lines().skip(skipped);
        lines.try_for_each(|line| writeln!(table, "{}", line.map_err(named)?))
    }
}

/// Writes a file under another name first, so that it is never there by half.
fn whole(path: &Path, write: impl FnOnce(BufWriter<File>) -> io::Result<BufWriter<File>>) -> Result<(), Fault> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let number = WRITTEN.fetch_add(1, Ordering::Relaxed);
    let temporary = path.with_file_name(format!(".{name}-{}-{number}", std::process::id()));
    let written = File::create(&temporary).map(BufWriter::new).and_then(write).and_then(|file| {
        file.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        fs::rename(&temporary, path)
    });
    written.map_err(|error| {
        // What is left of it is of no use; that it is there does no harm.
        let _ = fs::remove_file(&temporary);
        wrong(path, error)
    })
}

/// Joins all chunks into one table; each must be there. Returns the number of rows.
pub fn merge(folder: &Path, to: &Path, rows: usize, hash: &str) -> Result<usize, Fault> {
    let all: Vec<Chunk> = chunks(rows, Shard { number: 1, count: 1 }).collect();
    let missing =
        all.iter().map(|chunk| Ok((chunk, chunk.is_made(folder, hash)?))).collect::<Result<Vec<_>, Fault>>()?;
    let missing: Vec<&Chunk> = missing.into_iter().filter(|(_, is_made)| !is_made).map(|(chunk, _)| chunk).collect();
    if let Some(first) = missing.first() {
        let text =
            format_args!("{} of {} chunks are missing, the first one is {}", missing.len(), all.len(), first.number);
        return Err(wrong(folder, text));
    }
    whole(to, |mut table| {
        all.iter().try_for_each(|chunk| chunk.copy(folder, &mut table))?;
        Ok(table)
    })?;
    Ok(rows)
}
