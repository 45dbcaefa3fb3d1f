//! Version of the Magic Formula of a tyre property file.

use super::lines::{Entry, Refusal};
use super::twice;

/// Values of `FITTYP` for version 5 of the formula.
const FIVE: [f64; 4] = [5.0, 6.0, 21.0, 52.0];

/// Formats for version 5 of the formula, without signs.
const FIVE_FORMATS: [&str; 4] = ["PAC2002", "MF05", "MF52", "MFTYRE"];

/// Checks that the version is supported, and notes which one it is.
pub(super) fn check(entries: &[Entry], notes: &mut Vec<String>) -> Result<(), Refusal> {
    let mut of = |key: &str| twice::last(entries.iter().filter(|entry| entry.key == key), notes);
    let (fittyp, format) = (of("FITTYP"), of("PROPERTY_FILE_FORMAT"));
    if let Some(entry) = fittyp {
        let version = entry.number()?.value;
        if !FIVE.contains(&version) {
            let why = "only 5, 6, 21 and 52 mean version 5 of the Magic Formula; 60 and above mean version 6";
            return Err(entry.refused(why));
        }
        notes.push(format!("FITTYP = {version}: read as Magic Formula 5.2"));
        return Ok(());
    }
    // Programs with their own subroutines write USER, which says nothing.
    let Some(entry) = format.filter(|entry| !entry.value.eq_ignore_ascii_case("USER")) else {
        return Err(Refusal::of_file("neither FITTYP nor PROPERTY_FILE_FORMAT gives the version"));
    };
    let plain: String = entry.value.to_uppercase().chars().filter(char::is_ascii_alphanumeric).collect();
    if !FIVE_FORMATS.contains(&plain.as_str()) {
        return Err(entry.refused("must be one of PAC2002, MF_05, MF_52, MF-TYRE"));
    }
    notes.push(format!("PROPERTY_FILE_FORMAT = {}: read as Magic Formula 5.2", entry.value.to_uppercase()));
    Ok(())
}
