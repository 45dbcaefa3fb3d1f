//! Tables of files of any format: text, MDF 4 (feature `mdf`), MAT 4 and 5 (feature `mat`), spreadsheets
//! (feature `spreadsheet`).

use std::path::Path;

use crate::error::SheetError;
use crate::guard::refused;
use crate::sheet::Sheet;

/// The tables of a file, one for each group of channels with a clock of its own; of a text file there is one. The format
/// is that of the extension: `.mf4` and `.mdf` are MDF 4, `.mat` is MAT 4 or 5, `.xlsx`, `.xlsm` and `.ods` are
/// spreadsheets, everything else is text.
///
/// `sheet` is the one to read of a spreadsheet, the first one with a table if it is not given; other files have none.
pub fn tables(path: &Path, sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
    let extension = extension(path);
    if sheet.is_some() && !has_sheets(path) {
        return Err(refused(path, NO_SHEETS));
    }
    match extension.as_str() {
        "mf4" | "mdf" => mdf(path),
        "mat" => mat(path),
        _ if has_sheets(path) => spreadsheet(path, &extension, sheet),
        _ => Ok(vec![Sheet::load(path)?]),
    }
}

fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

/// Whether a file is a spreadsheet.
pub fn has_sheets(path: &Path) -> bool {
    ["xlsx", "xlsm", "ods"].contains(&extension(path).as_str())
}

/// Why a sheet cannot be chosen.
pub const NO_SHEETS: &str = "sheet: only spreadsheets have sheets (.xlsx, .xlsm, .ods)";

/// The table of a file that has a single one.
pub fn table(path: &Path, sheet: Option<&str>) -> Result<Sheet, SheetError> {
    let mut all = tables(path, sheet)?;
    match all.len() {
        1 => Ok(all.remove(0)),
        count => Err(refused(path, format_args!("has {count} groups of channels, must have one: export it alone"))),
    }
}

/// The error of a format whose reader was left out, as in the page for a browser.
#[cfg(not(all(feature = "mdf", feature = "mat", feature = "spreadsheet")))]
fn left_out(path: &Path, format: &str) -> Result<Vec<Sheet>, SheetError> {
    Err(refused(path, format_args!("{format} is read by the program stribeck and in Python; here give it as CSV")))
}

#[cfg(not(feature = "mdf"))]
fn mdf(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    left_out(path, "MDF")
}

#[cfg(not(feature = "mat"))]
fn mat(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    left_out(path, "MAT")
}

#[cfg(not(feature = "spreadsheet"))]
fn spreadsheet(path: &Path, extension: &str, _sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
    left_out(path, &extension.to_uppercase())
}

#[cfg(feature = "mat")]
fn mat(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    crate::mat::read(path)
}

#[cfg(feature = "spreadsheet")]
fn spreadsheet(path: &Path, extension: &str, sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
    crate::spreadsheet::read(path, extension, sheet)
}

/// The channel groups of an MDF file. Their master channels are called `time`; samples that the file declares invalid are
/// NaN, an error only if the column is used; channels of text are left out.
#[cfg(feature = "mdf")]
fn mdf(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    use std::collections::BTreeMap;

    use falcon_mdf::{Mf4File, SignalValues};

    let wrong = |error: falcon_mdf::Mf4Error| refused(path, error);
    crate::sheet::not_too_large(path)?;
    let file = Mf4File::open(path).map_err(wrong)?;
    let mut groups: BTreeMap<(usize, usize), Vec<crate::sheet::Channel>> = BTreeMap::new();
    for channel in file.channels() {
        let place = (channel.data_group_index, channel.channel_group_index);
        let master = file.master_channel(place.0, place.1);
        let signal = file.signal(channel).map_err(wrong)?;
        if matches!(signal.values().map_err(wrong)?, SignalValues::Str(_)) {
            continue;
        }
        let mut values = signal.values_f64().map_err(wrong)?;
        let validity = signal.validity().unwrap_or_default();
        values.iter_mut().zip(validity).filter(|(_, is_valid)| !is_valid).for_each(|(value, _)| *value = f64::NAN);
        let is_master = master.is_some_and(|master| master.index == channel.index);
        let (name, unit) = if is_master { ("time", "s") } else { (channel.name.as_str(), channel.unit.as_str()) };
        groups.entry(place).or_default().push((name.to_owned(), unit.to_owned(), values));
    }
    if groups.is_empty() {
        return Err(refused(path, "the file has no channels"));
    }
    groups.into_values().map(|group| Sheet::of_channels(group).map_err(|why| refused(path, why))).collect()
}
