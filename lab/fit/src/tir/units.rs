//! Units of a tyre property file.

use stribeck::host::FormulaVersion;

use super::keys;
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

const PRESSURES: &[(&str, f64)] =
    &[("pascal", 1.0), ("pa", 1.0), ("kpa", 1e3), ("mpa", 1e6), ("bar", 1e5), ("psi", 6_894.757_293_168_36)];

/// SI units per unit of the file.
pub(super) struct Units {
    pub length: f64,
    pub force: f64,
    pub time: f64,
    pub pressure: f64,
}

impl Units {
    pub fn of(entries: &[Entry], version: FormulaVersion, notes: &mut Vec<String>) -> Result<Units, Refusal> {
        let mut unit = |key: &str, known: &[(&str, f64)], default: Option<&str>| {
            let is_unit = |entry: &&Entry| ["UNITS", ""].contains(&entry.section.as_str()) && entry.key == key;
            let Some(entry) = twice::last(entries.iter().filter(is_unit), notes) else {
                notes.extend(default.map(|default| format!("no unit of {key}: assumed to be {default}")));
                return Ok(None);
            };
            let factor = known.iter().find(|(name, _)| name.eq_ignore_ascii_case(entry.value));
            let names = || known.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
            let refused = || entry.refused(format!("must be one of {}", names()));
            factor.map(|(_, factor)| Some(*factor)).ok_or_else(refused)
        };
        let mut basic = |key: &str, known: &[(&str, f64)]| Ok(unit(key, known, Some(known[0].0))?.unwrap_or(1.0));
        let (length, force, time) = (basic("LENGTH", LENGTHS)?, basic("FORCE", FORCES)?, basic("TIME", TIMES)?);
        let angle = basic("ANGLE", ANGLES)?;
        // The format derives pressures from force and length where it gives them no unit.
        let own = if version == FormulaVersion::Six { unit("PRESSURE", PRESSURES, None)? } else { None };
        if angle == DEGREE {
            notes.push("ANGLE: degrees are for the ranges alone; the coefficients are for radians".into());
        }
        Ok(Units { length, force, time, pressure: own.unwrap_or(force / (length * length)) })
    }

    /// SI units per unit of a key. Coefficients have none.
    pub fn factor(&self, key: &str) -> f64 {
        match key {
            _ if keys::is_pressure(key) => self.pressure,
            "FNOMIN" | "Q_FYS1" | "Q_FYS2" | "Q_FYS3" => self.force,
            "UNLOADED_RADIUS" | "RIM_RADIUS" | "WIDTH" | "BOTTOM_OFFST" => self.length,
            "Q_CAM2" => 1.0 / self.length,
            "LONGVL" => self.length / self.time,
            "VERTICAL_STIFFNESS" | "BOTTOM_STIFF" => self.force / self.length,
            "VERTICAL_DAMPING" => self.force * self.time / self.length,
            _ => 1.0,
        }
    }
}
