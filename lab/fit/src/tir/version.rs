//! Version of the Magic Formula of a tyre property file.

use stribeck::host::FormulaVersion;

use super::lines::{Entry, Refusal};
use super::twice;

/// Values of `FITTYP` and formats, without signs, with the version that they mean and its name.
const FITTYPS: [(f64, FormulaVersion, &str); 7] = [
    (5.0, FormulaVersion::Five, "5.2"),
    (6.0, FormulaVersion::Five, "5.2"),
    (21.0, FormulaVersion::Five, "5.2"),
    (52.0, FormulaVersion::Five, "5.2"),
    (60.0, FormulaVersion::Six, "6.1"),
    (61.0, FormulaVersion::Six, "6.1"),
    (62.0, FormulaVersion::Six, "6.2"),
];
const FORMATS: [(&str, FormulaVersion, &str); 7] = [
    ("PAC2002", FormulaVersion::Five, "5.2"),
    ("MF05", FormulaVersion::Five, "5.2"),
    ("MF52", FormulaVersion::Five, "5.2"),
    ("MFTYRE", FormulaVersion::Five, "5.2"),
    ("MF60", FormulaVersion::Six, "6.1"),
    ("MF61", FormulaVersion::Six, "6.1"),
    ("MF62", FormulaVersion::Six, "6.2"),
];

/// The version, which is noted.
pub(super) fn of(entries: &[Entry], notes: &mut Vec<String>) -> Result<FormulaVersion, Refusal> {
    let mut of = |key: &str| twice::last(entries.iter().filter(|entry| entry.key == key), notes);
    let (fittyp, format) = (of("FITTYP"), of("PROPERTY_FILE_FORMAT"));
    if let Some(entry) = fittyp {
        let number = entry.number()?.value;
        let known = FITTYPS.iter().find(|(value, ..)| *value == number);
        let why = "must be 5, 6, 21 or 52 for Magic Formula 5.2, 60, 61 or 62 for 6.1 and 6.2";
        let (_, version, name) = known.ok_or_else(|| entry.refused(why))?;
        notes.push(format!("FITTYP = {number}: read as Magic Formula {name}"));
        return Ok(*version);
    }
    // Programs with their own subroutines write USER, which says nothing.
    let Some(entry) = format.filter(|entry| !entry.value.eq_ignore_ascii_case("USER")) else {
        return Err(Refusal::of_file("neither FITTYP nor PROPERTY_FILE_FORMAT gives the version"));
    };
    let plain: String = entry.value.to_uppercase().chars().filter(char::is_ascii_alphanumeric).collect();
    let known = FORMATS.iter().find(|(format, ..)| *format == plain);
    let why = "must be one of PAC2002, MF_05, MF_52, MF-TYRE, MF_60, MF_61, MF_62";
    let (_, version, name) = known.ok_or_else(|| entry.refused(why))?;
    notes.push(format!("PROPERTY_FILE_FORMAT = {}: read as Magic Formula {name}", entry.value.to_uppercase()));
    Ok(*version)
}
