//! Keys of tyre property files that the model does not use, by what they are for.

use std::fmt;

use stribeck::host::{FormulaVersion, TyreSpring};
use stribeck::model::Columns;

/// Keys that belong together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Their purpose.
    pub about: &'static str,
    /// The keys, in the order of the file.
    pub keys: Vec<String>,
}

impl fmt::Display for Group {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.about, self.keys.join(", "))
    }
}

/// Adds a key to its group.
pub(super) fn add(groups: &mut Vec<Group>, about: &'static str, key: &str) {
    let at = groups.iter().position(|group| group.about == about).unwrap_or_else(|| {
        groups.push(Group { about, keys: Vec::new() });
        groups.len() - 1
    });
    groups[at].keys.push(key.into());
}

pub(super) const TURN_SLIP: &str = "turn slip";
const PRESSURE: &str = "inflation pressure";
const STRUCTURE: &str = "relaxation and structure";
const DEFLECTION: &str = "deflection and rolling radius";

/// Beginnings of keys.
#[rustfmt::skip]
const BEGINNINGS: [(&str, &[&str]); 4] = [
    (TURN_SLIP, &["PDXP", "PKYP", "PDYP", "PHYP", "PECP", "QDTP", "QCRP", "QBRP", "QDRP", "LMP"]),
    (PRESSURE, &["IP", "LIP", "INFLPRES", "NOMPRES"]),
    (STRUCTURE, &[
        "PTX", "PTY", "QTZ1", "MBELT", "LSGKP", "LSGAL", "LGYR", "LKG", "PCF", "PCMZ", "Q_BV", "FREQ_", "DAMP_", "YAW_",
        "LATERAL_STIFF", "LONGITUDINAL_STIFF",
    ]),
    (DEFLECTION, &[
        "BREFF", "DREFF", "FREFF", "Q_RE0", "Q_V", "Q_F", "Q_CAM", "PFZ1", "QPFZ1", "QFZ", "BOTTOM", "MC_CONTOUR",
        "LCZ", "DYNAMIC_",
    ]),
];

/// Purpose of a key that the model does not use, by the beginning of its name, otherwise by its section.
pub(super) fn about(key: &str, section: &str) -> &'static str {
    let begins = |(_, all): &&(&str, &[&str])| all.iter().any(|begin| key.starts_with(begin));
    if let Some((about, _)) = BEGINNINGS.iter().find(begins) {
        return about;
    }
    match section {
        "MDI_HEADER" | "MODEL" => "program that wrote or reads the file",
        "DIMENSION" | "INERTIA" | "SHAPE" => "size and mass",
        "STRUCTURAL" => STRUCTURE,
        "CONTACT_PATCH" | "ROAD" => "contact patch and road",
        "VERTICAL" => DEFLECTION,
        _ if section.ends_with("_RANGE") => "ranges",
        _ => "unknown",
    }
}

/// The name of a key that has several: PAC2002 has its own for pressures and radii, and the book for the camber.
pub(super) fn canonical(key: &str) -> &str {
    match key {
        "IP" => "INFLPRES",
        "IP_NOM" => "NOMPRES",
        "QRE0" => "Q_RE0",
        "QV1" => "Q_V1",
        "QV2" => "Q_V2",
        "Q_FZ3" => "Q_CAM",
        _ => key,
    }
}

/// Whether only the other version of the formula has a coefficient.
pub(super) fn is_foreign(key: &str, version: FormulaVersion) -> bool {
    match version {
        FormulaVersion::Five => is_of_six(key),
        FormulaVersion::Six => ["LGAX", "LGAY", "LGAZ", "PHY3"].contains(&key),
    }
}

/// The value of a coefficient that a file does not give: scale factors are 1, the others 0, and those of version 6 what
/// they are in version 5.2, which is what the model starts with, as it does with a linear spring.
pub(crate) fn missing_value(key: &str, start: f64) -> f64 {
    match key {
        _ if is_of_six(key) || is_of_spring(key) => start,
        _ if key.starts_with('L') => 1.0,
        _ => 0.0,
    }
}

/// Whether version 6 of the formula has a coefficient that version 5.2 has not.
pub(super) fn is_of_six(key: &str) -> bool {
    is_of_pressure(key) || is_pressure(key) || SIX.contains(&key)
}

/// Whether a coefficient changes no force, but the radii under load, in all versions.
pub(super) fn is_of_spring(key: &str) -> bool {
    TyreSpring::TABLE.iter().any(|variable| variable.path.to_string().eq_ignore_ascii_case(key))
}

pub(super) fn is_pressure(key: &str) -> bool {
    ["INFLPRES", "NOMPRES"].contains(&canonical(key))
}

fn is_of_pressure(key: &str) -> bool {
    ["PP", "QPX", "QPZ"].iter().any(|begin| key.starts_with(begin))
}

/// Whether this value of a coefficient of version 6 changes forces, so that version 5.2 loses something without it.
/// `at_pressure` says whether the inflation pressure may differ from the nominal one.
pub(super) fn is_lost_by_five(key: &str, value: f64, at_pressure: bool) -> bool {
    match key {
        _ if is_of_pressure(key) => at_pressure && value != 0.0,
        "PKY4" => value != 2.0,
        "LKYC" | "LKZC" => value != 1.0,
        "QSY7" => value != 0.0 && value != 1.0,
        _ => value != 0.0,
    }
}

#[rustfmt::skip]
const SIX: [&str; 27] = [
    "LMUV", "LKYC", "LKZC", "RBX3", "PEY5", "PKY4", "PKY5", "PKY6", "PKY7", "RBY4", "QDZ10", "QDZ11", "QSX4", "QSX5",
    "QSX6", "QSX7", "QSX8", "QSX9", "QSX10", "QSX11", "QSX12", "QSX13", "QSX14", "QSY5", "QSY6", "QSY7", "QSY8",
];
