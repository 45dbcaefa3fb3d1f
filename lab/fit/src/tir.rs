//! Tyre property files (`.tir`) with coefficients of the Magic Formula, as values for the variables of a car.
//!
//! Files for version 5 of the formula are supported: `FITTYP` 5, 6 or 21, or the formats `PAC2002`, `MF_05` and
//! `MF-TYRE`. Missing coefficients are 0 and missing scale factors 1, as the format prescribes; no value of the
//! built-in tyre remains. Vertical stiffness and damping are used for the tyres of both axles.

use std::fs;
use std::path::{Path, PathBuf};

use ssp::parameter_set::{ParameterSet, SetError};
use stribeck::catalogue;
use stribeck::model::ModelType;
use thiserror::Error;

/// Contents of a file.
#[derive(Debug)]
pub struct TyreFile {
    /// Values for the tyres of `DoubleTrackCar`.
    pub set: ParameterSet,
    /// Keys of the format that the model does not use.
    pub unused: Vec<String>,
    /// Assumptions that had to be made.
    pub notes: Vec<String>,
}

/// Reason why a file was rejected.
#[derive(Debug, Error)]
pub enum TirError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A line is wrong.
    #[error("{name}:{line}: {text}: {why}")]
    Line {
        /// The file.
        name: String,
        /// Number of the line, from 1.
        line: usize,
        /// Its text.
        text: String,
        /// The fault.
        why: String,
    },
    /// Something is missing.
    #[error("{name}: {why}")]
    Missing {
        /// The file.
        name: String,
        /// The missing item.
        why: String,
    },
    /// The values are inconsistent.
    #[error("{name}: {source}")]
    Set {
        /// The file.
        name: String,
        /// Why.
        source: SetError,
    },
}

/// Reads a file.
pub fn read(path: &Path) -> Result<TyreFile, TirError> {
    let bytes = fs::read(path).map_err(|source| TirError::File { path: path.into(), source })?;
    // Comments may be in any encoding; keys and values are ASCII.
    parse(&path.display().to_string(), &String::from_utf8_lossy(&bytes))
}

/// Reads the text of a file; `name` appears in errors.
pub fn parse(name: &str, text: &str) -> Result<TyreFile, TirError> {
    let fail = |Refusal { line, text, why }: Refusal| TirError::Line { name: name.into(), line, text, why };
    let missing = |why: String| TirError::Missing { name: name.into(), why };
    let entries = entries(text).map_err(fail)?;
    let mut reader = Reader { units: Units::of(&entries).map_err(fail)?, ..Reader::default() };
    let format = format(&entries).map_err(fail)?;
    reader
        .notes
        .push(format.ok_or_else(|| missing("neither FITTYP nor PROPERTY_FILE_FORMAT gives the version".into()))?);
    for entry in &entries {
        reader.take(entry).map_err(|why| fail(entry.refused(why)))?;
    }
    for key in REQUIRED {
        if reader.value(&tyre_variable(key)).is_none() {
            return Err(missing(format!("no {key}")));
        }
    }
    reader.fill();
    reader.check_axes().map_err(missing)?;
    let Reader { values, unused, notes, .. } = reader;
    let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
    let set = ParameterSet::new(car(), &stem, values).map_err(|source| TirError::Set { name: name.into(), source })?;
    Ok(TyreFile { set, unused, notes })
}

/// The model that has these tyres.
fn car() -> &'static ModelType {
    catalogue::by_name("DoubleTrackCar").expect("a model of the library")
}

/// Without these there is no lateral force.
const REQUIRED: [&str; 6] = ["FNOMIN", "UNLOADED_RADIUS", "PCY1", "PDY1", "PKY1", "PKY2"];

/// Sections whose keys describe features that the model does not have.
const UNUSED_SECTIONS: [&str; 10] = [
    "MDI_HEADER",
    "SHAPE",
    "LONG_SLIP_RANGE",
    "SLIP_ANGLE_RANGE",
    "INCLINATION_ANGLE_RANGE",
    "VERTICAL_FORCE_RANGE",
    "DEFLECTION_LOAD_CURVE",
    "BOTTOMING_CURVE",
    "OPERATING_CONDITIONS",
    "INERTIA",
];

/// Sections with tables, whose lines have no keys.
const TABLE_SECTIONS: [&str; 4] = ["MDI_HEADER", "SHAPE", "DEFLECTION_LOAD_CURVE", "BOTTOMING_CURVE"];

/// Keys of the other sections that the model does not use: relaxation, inertia, rim, rolling radius, simulation,
/// pressure, and the overturning couple and rolling resistance beyond version 5.2.
#[rustfmt::skip]
const UNUSED_KEYS: [&str; 65] = [
    "LENGTH", "FORCE", "ANGLE", "MASS", "TIME", "PRESSURE",
    "PROPERTY_FILE_FORMAT", "FITTYP", "TYPE", "USE_MODE", "VXLOW", "TYRESIDE", "ROAD_INCREMENT", "ROAD_DIRECTION",
    "FUNCTION_NAME", "USER_SUB_ID", "N_TIRE_STATES", "MFSAFE1", "MFSAFE2", "MFSAFE3", "HMAX_LOCAL", "SWITCH_INTEG",
    "WIDTH", "ASPECT_RATIO", "RIM_RADIUS", "RIM_WIDTH", "BREFF", "DREFF", "FREFF", "BOTTOMING_RADIUS", "BOTTOM_STIFF",
    "PTX1", "PTX2", "PTX3", "PTY1", "PTY2", "QTZ1", "MBELT", "LSGKP", "LSGAL", "LGYR", "LCZ", "LIP", "IP", "IP_NOM",
    "PPX1", "PPX2", "PPX3", "PPX4", "PPY1", "PPY2", "PPY3", "PPY4", "QPZ1", "QPZ2", "QPX1", "QPFZ1",
    "QSX4", "QSX5", "QSX6", "QSX7", "QSX8", "QSX9", "QSX10", "QSX11",
];

/// Keys of later versions, with the value at which they agree with version 5.2.
const LATER_KEYS: [(&str, f64); 12] = [
    ("PKY4", 2.0),
    ("PKY5", 0.0),
    ("PKY6", 0.0),
    ("PKY7", 0.0),
    ("PEY5", 0.0),
    ("PPY5", 0.0),
    ("RBX3", 0.0),
    ("RBY4", 0.0),
    ("QDZ10", 0.0),
    ("QDZ11", 0.0),
    ("LMUV", 0.0),
    ("QSX12", 0.0),
];

/// A line with a key.
struct Entry<'a> {
    line: usize,
    text: &'a str,
    section: String,
    /// In upper case.
    key: String,
    /// Without its quotes.
    value: &'a str,
}

/// A rejected line.
struct Refusal {
    line: usize,
    text: String,
    why: String,
}

impl Entry<'_> {
    fn refused(&self, why: String) -> Refusal {
        Refusal { line: self.line, text: self.text.into(), why }
    }

    /// A finite number; Fortran's D exponents too.
    fn number(&self) -> Result<f64, String> {
        let text = self.value.replace(['d', 'D'], "e");
        text.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| "must be a finite number".into())
    }
}

/// All lines with keys. Sections, keys and values do not span lines; comments begin with $ or !.
fn entries(text: &str) -> Result<Vec<Entry<'_>>, Refusal> {
    let mut entries: Vec<Entry> = Vec::new();
    let mut section = String::new();
    for (at, text) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let (line, text) = (at + 1, text.trim());
        let refused = |why: String| Refusal { line, text: text.into(), why };
        if text.is_empty() || text.starts_with(['$', '!']) {
            continue;
        }
        if let Some(rest) = text.strip_prefix('[') {
            section = section_name(rest).map_err(refused)?;
        } else if text.contains('=') || !TABLE_SECTIONS.contains(&section.as_str()) {
            let (key, value) = key_and_value(text, &section, &entries).map_err(refused)?;
            entries.push(Entry { line, text, section: section.clone(), key, value });
        }
    }
    Ok(entries)
}

fn section_name(text: &str) -> Result<String, String> {
    let (name, rest) = text.split_once(']').ok_or("the section has no ]")?;
    only_comment(rest)?;
    Ok(name.trim().to_uppercase())
}

fn key_and_value<'a>(text: &'a str, section: &str, entries: &[Entry]) -> Result<(String, &'a str), String> {
    let (name, rest) = text.split_once('=').ok_or("must be KEY = value")?;
    if section.is_empty() {
        return Err("is before the first section".into());
    }
    let key = name.trim().to_uppercase();
    match entries.iter().find(|other| other.key == key && other.section == section) {
        Some(other) => Err(format!("{key} is given twice, first in line {}", other.line)),
        None => Ok((key, value(rest)?)),
    }
}

/// A value without quotes and without the comment after it.
fn value(text: &str) -> Result<&str, String> {
    let text = text.trim();
    if let Some(rest) = text.strip_prefix('\'') {
        let (value, rest) = rest.split_once('\'').ok_or("the quote does not end")?;
        only_comment(rest)?;
        return Ok(value.trim());
    }
    let value = text.split(['$', '!']).next().unwrap_or_default().trim();
    if value.is_empty() { Err("has no value".into()) } else { Ok(value) }
}

fn only_comment(text: &str) -> Result<(), String> {
    let text = text.trim();
    if text.is_empty() || text.starts_with(['$', '!']) { Ok(()) } else { Err(format!("unexpected '{text}'")) }
}

/// Units of the format and their SI values.
const LENGTHS: &[(&str, f64)] = &[
    ("meter", 1.0),
    ("metre", 1.0),
    ("m", 1.0),
    ("mm", 1e-3),
    ("millimeter", 1e-3),
    ("cm", 1e-2),
    ("centimeter", 1e-2),
    ("inch", 0.0254),
    ("foot", 0.3048),
];
const FORCES: &[(&str, f64)] = &[
    ("newton", 1.0),
    ("n", 1.0),
    ("kilo_newton", 1e3),
    ("knewton", 1e3),
    ("kn", 1e3),
    ("pound_force", 4.448_221_615_260_5),
];
// The coefficients of the formula are for angles in radians, whatever unit the file gives for its ranges.
const ANGLES: &[(&str, f64)] = &[("radians", 1.0), ("radian", 1.0), ("rad", 1.0)];
const TIMES: &[(&str, f64)] = &[("second", 1.0), ("seconds", 1.0), ("sec", 1.0), ("s", 1.0)];

/// SI units per unit of the file.
#[derive(Default)]
struct Units {
    length: f64,
    force: f64,
    notes: Vec<String>,
}

impl Units {
    fn of(entries: &[Entry]) -> Result<Units, Refusal> {
        let mut notes = Vec::new();
        let mut unit = |key: &str, known: &[(&str, f64)]| {
            let Some(entry) = entries.iter().find(|entry| entry.section == "UNITS" && entry.key == key) else {
                notes.push(format!("no unit of {key}: assumed to be {}", known[0].0));
                return Ok(1.0);
            };
            let factor = known.iter().find(|(name, _)| name.eq_ignore_ascii_case(entry.value));
            let names = || known.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
            factor.map(|(_, factor)| *factor).ok_or_else(|| entry.refused(format!("must be one of {}", names())))
        };
        let (length, force) = (unit("LENGTH", LENGTHS)?, unit("FORCE", FORCES)?);
        unit("ANGLE", ANGLES)?;
        unit("TIME", TIMES)?;
        Ok(Units { length, force, notes })
    }

    /// SI units per unit of a key. Coefficients have none.
    fn factor(&self, key: &str) -> f64 {
        match key {
            "FNOMIN" => self.force,
            "UNLOADED_RADIUS" | "LONGVL" => self.length,
            "VERTICAL_STIFFNESS" | "VERTICAL_DAMPING" => self.force / self.length,
            _ => 1.0,
        }
    }
}

/// The version of the file, if it is supported. `None` if the file does not give one.
fn format(entries: &[Entry]) -> Result<Option<String>, Refusal> {
    let of = |key: &str| entries.iter().find(|entry| entry.section == "MODEL" && entry.key == key);
    if let Some(entry) = of("FITTYP") {
        let version = entry.number().map_err(|why| entry.refused(why))?;
        if ![5.0, 6.0, 21.0].contains(&version) {
            let why = "only 5, 6 and 21 mean version 5 of the Magic Formula for cars; 60 and above mean version 6";
            return Err(entry.refused(why.into()));
        }
        return Ok(Some(format!("FITTYP = {version}: read as Magic Formula 5.2")));
    }
    let Some(entry) = of("PROPERTY_FILE_FORMAT") else { return Ok(None) };
    let known = ["PAC2002", "MF_05", "MF-TYRE"];
    if !known.iter().any(|name| name.eq_ignore_ascii_case(entry.value)) {
        return Err(entry.refused(format!("must be one of {}", known.join(", "))));
    }
    Ok(Some(format!("PROPERTY_FILE_FORMAT = {}: read as Magic Formula 5.2", entry.value.to_uppercase())))
}

/// The entries read so far.
#[derive(Default)]
struct Reader {
    units: Units,
    values: Vec<(String, f64)>,
    unused: Vec<String>,
    notes: Vec<String>,
}

fn tyre_variable(key: &str) -> String {
    format!("tyre.{}", key.to_lowercase())
}

impl Reader {
    fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|(other, _)| other == name).map(|(_, value)| *value)
    }

    /// Adds an entry, or returns why it is rejected.
    fn take(&mut self, entry: &Entry) -> Result<(), String> {
        let key = entry.key.as_str();
        if key == "TYRESIDE" {
            self.put_side(entry.value)?;
        }
        if UNUSED_SECTIONS.contains(&entry.section.as_str()) || UNUSED_KEYS.contains(&key) {
            // Units, format and side have already been used.
            if !["UNITS", "MODEL", "MDI_HEADER"].contains(&entry.section.as_str()) {
                self.unused.push(entry.key.clone());
            }
            return Ok(());
        }
        if let Some((_, neutral)) = LATER_KEYS.iter().find(|(name, _)| *name == key) {
            let is_neutral = entry.number()? == *neutral;
            let why = || format!("is of a later version; in version 5.2 it is {neutral}");
            return is_neutral.then_some(()).ok_or_else(why);
        }
        let value = entry.number()? * self.units.factor(key);
        match key {
            "VERTICAL_STIFFNESS" => self.put_both("tyre_stiffness", value),
            "VERTICAL_DAMPING" => self.put_both("tyre_damping", value),
            _ => self.put(tyre_variable(key), value),
        }
    }

    fn put_both(&mut self, name: &str, value: f64) -> Result<(), String> {
        self.put(format!("front.{name}"), value)?;
        self.put(format!("rear.{name}"), value)
    }

    fn put(&mut self, name: String, value: f64) -> Result<(), String> {
        let car = car();
        let column = car.find(&name).ok_or("unknown key")?;
        let variable = &car.table.at(column);
        if !variable.admits(value) {
            return Err(variable.fault(value).to_string());
        }
        if self.value(&name).is_some() {
            return Err("is given twice, in two sections".into());
        }
        self.values.push((name, value));
        Ok(())
    }

    fn put_side(&mut self, side: &str) -> Result<(), String> {
        let number = match side.to_uppercase().as_str() {
            "LEFT" | "SYMMETRIC" => 1.0,
            "RIGHT" => 2.0,
            "UNKNOWN" => {
                self.notes.push("TYRESIDE unknown: assumed to be LEFT".into());
                1.0
            }
            _ => return Err("must be LEFT, RIGHT, SYMMETRIC or UNKNOWN".into()),
        };
        self.put("tyre.side".into(), number)
    }

    /// Gives missing entries the values prescribed by the format: scale factors 1, coefficients 0.
    fn fill(&mut self) {
        self.notes.append(&mut self.units.notes);
        let absent: Vec<String> = car().table.iter().map(|variable| variable.path.to_string()).collect();
        for name in absent.into_iter().filter(|name| name.starts_with("tyre.")) {
            if self.value(&name).is_some() {
                continue;
            }
            let value = match name.as_str() {
                "tyre.longvl" => 16.7,
                "tyre.side" => 1.0,
                _ if name.starts_with("tyre.l") => 1.0,
                _ => 0.0,
            };
            self.notes.push(format!("{}: not in the file, set to {value}", name["tyre.".len()..].to_uppercase()));
            self.values.push((name, value));
        }
    }

    /// Rejects coefficients for other axes.
    fn check_axes(&self) -> Result<(), String> {
        let [pky1, pky2] = ["PKY1", "PKY2"].map(|key| self.value(&tyre_variable(key)).unwrap_or_default());
        if pky1 * pky2 > 0.0 {
            return Err(format!(
                "PKY1 = {pky1}, PKY2 = {pky2}: the cornering stiffness must be negative with the axes of the format"
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::abs_diff_eq;

    const SAMPLE: &str = include_str!("../../../examples/tyres/formula_student.tir");

    /// A minimal file, with `more` at its end.
    fn small(more: &str) -> String {
        let units = "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\nTIME = 'second'\n";
        let model = "[MODEL]\nPROPERTY_FILE_FORMAT = 'PAC2002'\nTYRESIDE = 'LEFT'\nLONGVL = 16.7\n";
        let tyre = "[DIMENSION]\nUNLOADED_RADIUS = 0.24\n[VERTICAL]\nFNOMIN = 800\n";
        format!("{units}{model}{tyre}[LATERAL_COEFFICIENTS]\nPCY1=1.4\nPDY1=1.5\nPKY1=-30\nPKY2=1.6\n{more}")
    }

    fn get(text: &str, name: &str) -> f64 {
        parse("x.tir", text).unwrap().set.get(name).unwrap()
    }

    fn refusal(text: &str) -> String {
        parse("x.tir", text).unwrap_err().to_string()
    }

    /// The file in `examples` is the built-in tyre, number by number.
    #[test]
    fn sample_file_is_the_built_in_tyre() {
        let file = parse("formula_student.tir", SAMPLE).unwrap();
        assert_eq!(file.set.name(), "formula_student");
        let mut tyres = 0;
        for variable in car().table.iter().filter(|variable| variable.path.to_string().starts_with("tyre.")) {
            let name = variable.path.to_string();
            let value = file.set.get(&name).unwrap();
            assert!(abs_diff_eq!(value, variable.start, epsilon = 1e-15 * variable.start.abs()), "{name}: {value}");
            tyres += 1;
        }
        assert!(tyres > 100, "{tyres}");
        for name in ["front.tyre_stiffness", "rear.tyre_stiffness", "front.tyre_damping", "rear.tyre_damping"] {
            assert_eq!(file.set.get(name), Some(car().table.at(car().find(name).unwrap()).start), "{name}");
        }
        assert_eq!(file.notes, ["PROPERTY_FILE_FORMAT = PAC2002: read as Magic Formula 5.2"]);
    }

    #[test]
    fn missing_entries_are_neutral_and_not_built_in() {
        let text = small("");
        for (name, value) in [("tyre.pdy1", 1.5), ("tyre.pey1", 0.0), ("tyre.lmuy", 1.0), ("tyre.lhy", 1.0)] {
            assert_eq!(get(&text, name), value, "{name}");
        }
        let notes = parse("x.tir", &text).unwrap().notes;
        assert!(notes.contains(&"LFZO: not in the file, set to 1".into()), "{notes:?}");
    }

    #[test]
    fn comments_case_line_ends_and_byte_order_mark_do_not_matter() {
        let text = small("[SCALING_COEFFICIENTS]\n$ a comment\n! another = 3\nLMUY = 6.5D-1 $grip!\n");
        let expected = parse("x.tir", &text).unwrap().set;
        assert_eq!(expected.get("tyre.lmuy"), Some(0.65));
        assert_eq!(parse("x.tir", &text.to_lowercase()).unwrap().set, expected);
        let windows = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        assert_eq!(parse("x.tir", &windows).unwrap().set, expected);
        let quoted = text.replace("'LEFT'", "'LEFT' ! $ not right");
        assert_eq!(parse("x.tir", &quoted).unwrap().set, expected);
    }

    #[test]
    fn comments_in_other_encodings_do_not_matter() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("umlaut.tir");
        let mut bytes = b"! gemessen f\xfcr Stra\xdfe\n".to_vec();
        bytes.extend(small("").bytes());
        fs::write(&path, bytes).unwrap();
        assert_eq!(read(&path).unwrap().set.get("tyre.pdy1"), Some(1.5));
        assert!(read(&folder.path().join("absent.tir")).unwrap_err().to_string().contains("absent.tir: "));
    }

    #[test]
    fn units_are_converted() {
        let text = small("").replace("'meter'", "'mm'").replace("'newton'", "'kilo_newton'").replace("= 0.24", "= 240");
        let text = text.replace("LONGVL = 16.7", "LONGVL = 16700").replace("FNOMIN = 800", "FNOMIN = 0.8");
        let text = text.replace("[VERTICAL]", "[VERTICAL]\nVERTICAL_STIFFNESS = 0.1\nVERTICAL_DAMPING = 1E-4");
        let expected = [
            ("tyre.unloaded_radius", 0.24),
            ("tyre.longvl", 16.7),
            ("tyre.fnomin", 800.0),
            ("front.tyre_stiffness", 1e5),
            ("rear.tyre_damping", 100.0),
            ("tyre.pky1", -30.0),
        ];
        for (name, value) in expected {
            assert!(abs_diff_eq!(get(&text, name) / value, 1.0, epsilon = 1e-15), "{name}: {}", get(&text, name));
        }
    }

    #[test]
    fn the_side_is_heeded() {
        assert_eq!(get(&small(""), "tyre.side"), 1.0);
        assert_eq!(get(&small("").replace("'LEFT'", "'Right'"), "tyre.side"), 2.0);
    }

    #[test]
    fn keys_that_the_model_does_not_use_are_listed() {
        let more = "PTY1 = 2.1\n[SHAPE]\n{radial width}\n1.0 0.0\n[LONG_SLIP_RANGE]\nKPUMIN = -1.5\n";
        assert_eq!(parse("x.tir", &small(more)).unwrap().unused, ["PTY1", "KPUMIN"]);
    }

    #[test]
    fn wrong_lines_are_rejected_with_number_and_text() {
        for (more, answer) in [
            ("PDYl = 1", "x.tir:20: PDYl = 1: unknown key"),
            ("PEY1 = 0.1.2", "x.tir:20: PEY1 = 0.1.2: must be a finite number"),
            ("PEY1 = inf", "x.tir:20: PEY1 = inf: must be a finite number"),
            ("PEY1 = nan $", "x.tir:20: PEY1 = nan $: must be a finite number"),
            ("PEY1 =", "x.tir:20: PEY1 =: has no value"),
            ("PEY1 = $ 0.1", "x.tir:20: PEY1 = $ 0.1: has no value"),
            ("PEY1 0.1", "x.tir:20: PEY1 0.1: must be KEY = value"),
            ("pcy1 = 1.4", "x.tir:20: pcy1 = 1.4: PCY1 is given twice, first in line 16"),
            ("[X]\nPCY1 = 1.4", "x.tir:21: PCY1 = 1.4: is given twice, in two sections"),
            ("[X", "x.tir:20: [X: the section has no ]"),
            ("[X] Y", "x.tir:20: [X] Y: unexpected 'Y'"),
            ("PKY4 = 1.8", "x.tir:20: PKY4 = 1.8: is of a later version; in version 5.2 it is 2"),
            ("LMUY = 0", "x.tir:20: LMUY = 0: tyre.lmuy = 0: must be > 0 and finite"),
        ] {
            assert_eq!(refusal(&small(more)), answer);
        }
        assert_eq!(refusal("A = 1"), "x.tir:1: A = 1: is before the first section");
        assert_eq!(get(&small("PKY4 = 2"), "tyre.pky1"), -30.0);
    }

    #[test]
    fn other_versions_units_and_axes_are_rejected() {
        let change = |from: &str, to: &str| {
            let text = small("");
            assert!(text.contains(from), "{from}");
            refusal(&text.replace(from, to))
        };
        let version = change("PROPERTY_FILE_FORMAT = 'PAC2002'", "FITTYP = 61");
        assert!(version.starts_with("x.tir:8: FITTYP = 61: only 5, 6 and 21 mean version 5"), "{version}");
        assert_eq!(
            change("'PAC2002'", "'FTIRE'"),
            "x.tir:8: PROPERTY_FILE_FORMAT = 'FTIRE': must be one of PAC2002, MF_05, MF-TYRE"
        );
        assert_eq!(
            change("PROPERTY_FILE_FORMAT = 'PAC2002'\n", ""),
            "x.tir: neither FITTYP nor PROPERTY_FILE_FORMAT gives the version"
        );
        assert_eq!(change("'radians'", "'deg'"), "x.tir:4: ANGLE = 'deg': must be one of radians, radian, rad");
        assert!(change("'meter'", "'furlong'").starts_with("x.tir:2: LENGTH = 'furlong': must be one of meter, "));
        assert!(change("'meter'", "'meter").ends_with("the quote does not end"));
        assert!(change("'LEFT'", "'UP'").ends_with("must be LEFT, RIGHT, SYMMETRIC or UNKNOWN"));
        assert_eq!(change("FNOMIN = 800\n", ""), "x.tir: no FNOMIN");
        assert!(change("FNOMIN = 800", "FNOMIN = -800").ends_with("tyre.fnomin = -800: must be > 0 and finite"));
        assert!(change("PKY1=-30", "PKY1=30").contains("the cornering stiffness must be negative"));
        assert_eq!(change("PKY2=1.6", "PKY2=0"), "x.tir: tyre.pky2 = 0: must not be 0");
    }
}
