//! Facts about the project that are in no table: its location, its version and its date.

use std::path::Path;

use anyhow::{Context, Result, ensure};
use jiff::Timestamp;

/// Version of the library and of every FMU: that of the workspace.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Holder of the copyright.
pub const AUTHORS: &str = "The Stribeck authors";

/// SPDX expression of the licence.
pub const LICENSE: &str = env!("CARGO_PKG_LICENSE");

/// Date of this release. Changed by hand with the version, so that the same sources give the same bytes on any day.
const RELEASED: &str = "2026-11-21T00:00:00Z";

/// Root of the project.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("fmu-build is a folder of the project")
}

/// Year and holder, for the XML.
pub fn copyright() -> String {
    format!("Copyright (c) {} {AUTHORS}", &RELEASED[..4])
}

/// Date in generated files.
pub fn release_date() -> Timestamp {
    RELEASED.parse().expect("RELEASED is a date")
}

/// Date in packed FMUs: SOURCE_DATE_EPOCH (seconds since 1970) if a distribution has set it, else the release.
pub fn packing_date() -> Result<Timestamp> {
    match std::env::var("SOURCE_DATE_EPOCH") {
        Ok(seconds) => date_of_epoch(&seconds),
        Err(_) => Ok(release_date()),
    }
}

fn date_of_epoch(seconds: &str) -> Result<Timestamp> {
    let date = seconds.parse().ok().and_then(|seconds| Timestamp::from_second(seconds).ok());
    let date = date.with_context(|| format!("SOURCE_DATE_EPOCH = {seconds}: must be a number of seconds"))?;
    // A zip archive cannot store other years.
    let year = date.to_string()[..4].parse::<u16>().unwrap_or_default();
    ensure!((1980..2108).contains(&year), "SOURCE_DATE_EPOCH = {seconds}: must lie in the years 1980 to 2107");
    Ok(date)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_have_the_form_that_fmi_requires() {
        assert_eq!(release_date().to_string(), RELEASED);
        assert_eq!(date_of_epoch("1700000000").unwrap().to_string(), "2023-11-14T22:13:20Z");
    }

    #[test]
    fn epochs_that_no_archive_can_store_are_rejected() {
        for seconds in ["", "soon", "0", "-1", "99999999999"] {
            assert!(date_of_epoch(seconds).is_err(), "{seconds}");
        }
    }
}
