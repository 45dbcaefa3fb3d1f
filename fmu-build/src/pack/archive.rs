//! The zip archive of an FMU, written so that every importer can read it and equal contents give equal bytes.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::io::{Cursor, Write};

use anyhow::{Context, Result, ensure};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use zip::result::ZipResult;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipArchive, ZipWriter};

/// Contents of an archive by path; a map, so that they are sorted.
pub type Files = BTreeMap<String, Vec<u8>>;

/// An archive in memory.
type Archive = ZipWriter<Cursor<Vec<u8>>>;

/// Writes archives of one date. What several of them contain, such as the library, is compressed once.
pub struct Archiver {
    options: SimpleFileOptions,
    /// Archives of one file each, by the bytes of the file.
    compressed: RefCell<HashMap<Vec<u8>, Vec<u8>>>,
}

impl Archiver {
    /// An archiver by the rules of FMI 2.0.5 section 2.3 and of old unzip code: deflate only, no Zip64, no data
    /// descriptors (the writer can seek back and fill in the sizes), ASCII names, no entries for folders.
    pub fn new(date: Timestamp) -> Result<Archiver> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .compression_level(Some(9))
            .large_file(false)
            .system(System::Unix)
            .unix_permissions(0o644)
            .last_modified_time(dos_time(date)?);
        Ok(Archiver { options, compressed: RefCell::default() })
    }

    /// Packs the files.
    pub fn zip(&self, files: &Files) -> Result<Vec<u8>> {
        let mut archive = Archive::new(Cursor::default());
        for (path, bytes) in files {
            ensure!(path.is_ascii(), "{path}: names in an FMU must be ASCII");
            self.add(&mut archive, path, bytes).with_context(|| format!("cannot pack {path}"))?;
        }
        Ok(archive.finish()?.into_inner())
    }

    fn add(&self, archive: &mut Archive, path: &str, bytes: &[u8]) -> ZipResult<()> {
        let mut compressed = self.compressed.borrow_mut();
        if !compressed.contains_key(bytes) {
            compressed.insert(bytes.to_vec(), self.compress(bytes)?);
        }
        let mut alone = ZipArchive::new(Cursor::new(&compressed[bytes]))?;
        archive.raw_copy_file_rename(alone.by_index_raw(0)?, path)
    }

    fn compress(&self, bytes: &[u8]) -> ZipResult<Vec<u8>> {
        let mut archive = Archive::new(Cursor::default());
        archive.start_file("file", self.options)?;
        archive.write_all(bytes)?;
        Ok(archive.finish()?.into_inner())
    }
}

/// The date as a zip archive stores it, in UTC.
fn dos_time(date: Timestamp) -> Result<DateTime> {
    let date = date.to_zoned(TimeZone::UTC).datetime();
    let [month, day, hour, minute, second] =
        [date.month(), date.day(), date.hour(), date.minute(), date.second()].map(i8::unsigned_abs);
    let time = DateTime::from_date_and_time(date.year().unsigned_abs(), month, day, hour, minute, second);
    time.with_context(|| format!("{date}: a zip archive cannot store this date"))
}
