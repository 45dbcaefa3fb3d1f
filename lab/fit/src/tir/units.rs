//! Units of a tyre property file.

use super::lines::{Entry, Refusal};
use super::twice;

/// Units of the format and their SI values; the first of each list is assumed if the file has none.
const LENGTHS: &[(&str, f64)] = &[
    ("meter", 1.0),
    ("meters", 1.0),
    ("metre", 1.0),
    ("m", 1.0),
    ("mm", 1e-3),
    ("millimeter", 1e-3),
    ("millimetre", 1e-3),
    ("cm", 1e-2),
    ("centimeter", 1e-2),
    ("inch", 0.0254),
    ("in", 0.0254),
    ("foot", 0.3048),
    ("ft", 0.3048),
];
const FORCES: &[(&str, f64)] = &[
    ("newton", 1.0),
    ("newtons", 1.0),
    ("n", 1.0),
    ("kilo_newton", 1e3),
    ("knewton", 1e3),
    ("kn", 1e3),
    ("pound_force", 4.448_221_615_260_5),
    ("lbf", 4.448_221_615_260_5),
];
/// The coefficients of the formula are for angles in radians, whatever unit the file gives for its ranges.
const ANGLES: &[(&str, f64)] =
    &[("radians", 1.0), ("radian", 1.0), ("rad", 1.0), ("degrees", DEGREE), ("degree", DEGREE), ("deg", DEGREE)];
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const TIMES: &[(&str, f64)] = &[
    ("second", 1.0),
    ("seconds", 1.0),
    ("sec", 1.0),
    ("s", 1.0),
    ("millisecond", 1e-3),
    ("minute", 60.0),
    ("hour", 3600.0),
];

/// SI units per unit of the file.
pub(super) struct Units {
    pub length: f64,
    pub force: f64,
    pub time: f64,
}

impl Units {
    pub fn of(entries: &[Entry], notes: &mut Vec<String>) -> Result<Units, Refusal> {
        let mut unit = |key: &str, known: &[(&str, f64)]| {
            let is_unit = |entry: &&Entry| ["UNITS", ""].contains(&entry.section.as_str()) && entry.key == key;
            let Some(entry) = twice::last(entries.iter().filter(is_unit), notes) else {
                notes.push(format!("no unit of {key}: assumed to be {}", known[0].0));
                return Ok(1.0);
            };
            let factor = known.iter().find(|(name, _)| name.eq_ignore_ascii_case(entry.value));
            let names = || known.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
            factor.map(|(_, factor)| *factor).ok_or_else(|| entry.refused(format!("must be one of {}", names())))
        };
        let (length, force, time) = (unit("LENGTH", LENGTHS)?, unit("FORCE", FORCES)?, unit("TIME", TIMES)?);
        if unit("ANGLE", ANGLES)? == DEGREE {
            notes.push("ANGLE: degrees are for the ranges alone; the coefficients are for radians".into());
        }
        Ok(Units { length, force, time })
    }

    /// SI units per unit of a key. Coefficients have none.
    pub fn factor(&self, key: &str) -> f64 {
        match key {
            "FNOMIN" => self.force,
            "UNLOADED_RADIUS" => self.length,
            "LONGVL" => self.length / self.time,
            "VERTICAL_STIFFNESS" => self.force / self.length,
            "VERTICAL_DAMPING" => self.force * self.time / self.length,
            _ => 1.0,
        }
    }
}
