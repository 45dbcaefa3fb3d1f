//! The zip archive of an FMU, written so that every importer can read it and equal contents give equal bytes.

use std::collections::BTreeMap;
use std::io::{Cursor, Write};

use anyhow::{Context, Result, ensure};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipWriter};

/// Contents of an archive by path; a map, so that they are sorted.
pub type Files = BTreeMap<String, Vec<u8>>;

/// Packs the files. FMI 2.0.5 section 2.3 and old unzip code require: deflate only, no Zip64, no data descriptors (the
/// writer can seek back and fill in the sizes), ASCII names, no entries for folders.
pub fn zip(files: &Files, date: Timestamp) -> Result<Vec<u8>> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(9))
        .large_file(false)
        .system(System::Unix)
        .unix_permissions(0o644)
        .last_modified_time(dos_time(date)?);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, bytes) in files {
        ensure!(path.is_ascii(), "{path}: names in an FMU must be ASCII");
        archive.start_file(path.as_str(), options).with_context(|| format!("cannot pack {path}"))?;
        archive.write_all(bytes).with_context(|| format!("cannot pack {path}"))?;
    }
    Ok(archive.finish()?.into_inner())
}

/// The date as a zip archive stores it, in UTC.
fn dos_time(date: Timestamp) -> Result<DateTime> {
    let date = date.to_zoned(TimeZone::UTC).datetime();
    let [month, day, hour, minute, second] =
        [date.month(), date.day(), date.hour(), date.minute(), date.second()].map(i8::unsigned_abs);
    let time = DateTime::from_date_and_time(date.year().unsigned_abs(), month, day, hour, minute, second);
    time.with_context(|| format!("{date}: a zip archive cannot store this date"))
}
