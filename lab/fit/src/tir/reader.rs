//! Values for a car from the keys of a tyre property file.

use std::collections::BTreeMap;

use stribeck::catalogue;
use stribeck::host::FormulaVersion;
use stribeck::model::ModelType;

use super::keys::{self, Group};
use super::lines::{self, Entry, Refusal};
use super::units::Units;
use super::{twice, version};

/// The model that has these tyres.
pub(super) fn car() -> &'static ModelType {
    catalogue::by_name("DoubleTrackCar").expect("a model of the library")
}

/// Keys without which there is no lateral force.
const REQUIRED: [&str; 6] = ["FNOMIN", "UNLOADED_RADIUS", "PCY1", "PDY1", "PKY1", "PKY2"];

/// Keys for the tyres of both axles, with the names of the variables.
const BOTH: [(&str, &str); 2] = [("VERTICAL_STIFFNESS", "tyre_stiffness"), ("VERTICAL_DAMPING", "tyre_damping")];

/// Keys that are read on their own.
const SAID: [&str; 3] = ["FITTYP", "PROPERTY_FILE_FORMAT", "TYRESIDE"];

/// Values and notes from a file.
#[derive(Default)]
pub(super) struct Contents {
    pub values: Vec<(String, f64)>,
    pub unused: Vec<Group>,
    pub ignored: Vec<Group>,
    pub notes: Vec<String>,
}

/// Reads the text of a file.
pub(super) fn read(text: &str) -> Result<Contents, Refusal> {
    let entries = lines::entries(text, is_used)?;
    let mut contents = Contents::default();
    let version = version::of(&entries, &mut contents.notes)?;
    contents.values.push((variable("VERSION"), version.number()));
    let units = Units::of(&entries, version, &mut contents.notes)?;
    contents.note_marks(&entries)?;
    contents.take_side(&entries)?;
    contents.take_all(&entries, version, &units)?;
    contents.check_required(&entries)?;
    contents.check_axes()?;
    contents.fill_pressures(version);
    contents.drop_progression();
    contents.fill(version);
    Ok(contents)
}

/// Name of the variable of the car that a key is for.
fn variable(key: &str) -> String {
    format!("tyre.{}", keys::canonical(key).to_lowercase())
}

fn is_coefficient(key: &str) -> bool {
    !["SIDE", "VERSION"].contains(&key) && car().find(&variable(key)).is_some()
}

/// Whether the model needs the number of a key.
fn is_used(key: &str) -> bool {
    is_coefficient(key) || BOTH.iter().any(|(name, _)| *name == key)
}

impl Contents {
    fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|(other, _)| other == name).map(|(_, value)| *value)
    }

    /// Refuses decimal commas beside decimal points: one of them may be for thousands.
    fn note_marks(&mut self, entries: &[Entry]) -> Result<(), Refusal> {
        let numbers = entries.iter().filter(|entry| is_used(&entry.key));
        let first = |mark| numbers.clone().find(|entry| entry.number().is_ok_and(|number| number.mark == Some(mark)));
        match (first(','), first('.')) {
            (Some(comma), Some(point)) => {
                let why = format!("has a decimal comma, and line {} has a decimal point", point.line);
                return Err(comma.refused(why));
            }
            (Some(comma), None) => self.notes.push(format!("line {}: the comma is for decimals", comma.line)),
            _ => {}
        }
        Ok(())
    }

    fn take_side(&mut self, entries: &[Entry]) -> Result<(), Refusal> {
        let entry = twice::last(entries.iter().filter(|entry| entry.key == "TYRESIDE"), &mut self.notes);
        let side = entry.map_or("UNKNOWN".to_owned(), |entry| entry.value.to_uppercase());
        let number = match (side.as_str(), entry) {
            ("LEFT" | "SYMMETRIC", _) => 1.0,
            ("RIGHT", _) => 2.0,
            ("UNKNOWN", _) => {
                self.notes.push("TYRESIDE unknown: assumed to be LEFT".into());
                1.0
            }
            (_, Some(entry)) => return Err(entry.refused("must be LEFT, RIGHT, SYMMETRIC or UNKNOWN")),
            (_, None) => 1.0,
        };
        self.values.push(("tyre.side".into(), number));
        Ok(())
    }

    /// Takes the numbers of the keys that the model uses, and sorts the other keys.
    fn take_all(&mut self, entries: &[Entry], version: FormulaVersion, units: &Units) -> Result<(), Refusal> {
        let at_pressure = may_differ(entries, "INFLPRES", "NOMPRES");
        let mut empty: Vec<&str> = Vec::new();
        for (key, entries) in by_key(entries) {
            let Some(last) = entries.iter().rfind(|entry| !entry.value.is_empty()) else {
                empty.push(key);
                continue;
            };
            if is_used(key) && !keys::is_foreign(key, version) {
                twice::last(entries.iter().copied(), &mut self.notes);
                self.take(last, units)?;
            } else {
                self.sort(last, version, at_pressure)?;
            }
        }
        if !empty.is_empty() {
            self.notes.push(format!("without value, as if absent: {}", empty.join(", ")));
        }
        Ok(())
    }

    fn take(&mut self, entry: &Entry, units: &Units) -> Result<(), Refusal> {
        let (key, value) = (entry.key.as_str(), entry.number()?.value * units.factor(&entry.key));
        match BOTH.iter().find(|(name, _)| *name == key) {
            Some((_, name)) => ["front", "rear"].iter().try_for_each(|axle| self.put(format!("{axle}.{name}"), value)),
            None => self.put(variable(key), value),
        }
        .map_err(|why| entry.refused(why))
    }

    fn put(&mut self, name: String, value: f64) -> Result<(), String> {
        let column = car().find(&name).ok_or("unknown variable")?;
        let variable = &car().table.at(column);
        if !variable.admits(value) {
            return Err(variable.fault(value).to_string());
        }
        self.values.push((name, value));
        Ok(())
    }

    /// Tells apart what changes no force and what does, but is not modelled.
    fn sort(&mut self, entry: &Entry, version: FormulaVersion, at_pressure: bool) -> Result<(), Refusal> {
        let (key, value) = (entry.key.as_str(), entry.number().map_or(f64::NAN, |number| number.value));
        if key == "PCY2" && value != 0.0 {
            return Err(entry.refused("is for the camber thrust of a motorcycle tyre, which is not modelled"));
        }
        if version == FormulaVersion::Six && keys::is_foreign(key, version) {
            keys::add(&mut self.unused, "Magic Formula 5.2", key);
            return Ok(());
        }
        if version == FormulaVersion::Five && keys::is_foreign(key, version) && !keys::is_pressure(key) {
            let lost = keys::is_lost_by_five(key, value, at_pressure);
            keys::add(if lost { &mut self.ignored } else { &mut self.unused }, "Magic Formula 6", key);
            return Ok(());
        }
        let about = keys::about(key, &entry.section);
        // The scale of the moment at rest has no effect of its own.
        let turns = about == keys::TURN_SLIP && key != "LMP" && value != 0.0;
        keys::add(if turns { &mut self.ignored } else { &mut self.unused }, about, key);
        Ok(())
    }

    fn check_required(&self, entries: &[Entry]) -> Result<(), Refusal> {
        let Some(key) = REQUIRED.iter().find(|key| self.value(&variable(key)).is_none()) else { return Ok(()) };
        let empty = entries.iter().find(|entry| entry.key == *key);
        Err(empty.map_or_else(|| Refusal::of_file(format!("no {key}")), |entry| entry.refused("has no value")))
    }

    /// Takes a missing pressure from the other one: without both, pressure has no effect.
    fn fill_pressures(&mut self, version: FormulaVersion) {
        let [actual, nominal] = ["INFLPRES", "NOMPRES"].map(|key| self.value(&variable(key)));
        if version == FormulaVersion::Five || (actual.is_some() && nominal.is_some()) {
            return;
        }
        let (missing, said) = match (actual, nominal) {
            (Some(pressure), _) => (vec![("NOMPRES", pressure)], "NOMPRES: not in the file, set to INFLPRES"),
            (_, Some(pressure)) => (vec![("INFLPRES", pressure)], "INFLPRES: not in the file, set to NOMPRES"),
            _ => (vec![], "neither INFLPRES nor NOMPRES in the file: pressure has no effect"),
        };
        self.notes.push(said.into());
        self.values.extend(missing.into_iter().map(|(key, pressure)| (variable(key), pressure)));
    }

    /// Drops what only makes sense beside the stiffness of the tyre: that of another tyre may be too small for it.
    fn drop_progression(&mut self) {
        let is_alone = self.value(&format!("front.{}", BOTH[0].1)).is_none();
        let name = variable("Q_FZ2");
        if is_alone && self.value(&name).is_some_and(|value| value != 0.0) {
            self.values.retain(|(other, _)| *other != name);
            self.notes.push(format!("Q_FZ2: not used without {}", BOTH[0].0));
        }
    }

    /// Gives missing entries the values prescribed by the format: scale factors 1, coefficients 0. Those that the
    /// version does not have get them silently.
    fn fill(&mut self, version: FormulaVersion) {
        let mut told: Vec<(f64, Vec<String>)> = Vec::new();
        for one in car().table.iter() {
            let name = one.path.to_string();
            let Some(key) = name.strip_prefix("tyre.").map(str::to_uppercase) else { continue };
            if self.value(&name).is_some() {
                continue;
            }
            let value = if key == "LONGVL" { one.start } else { keys::missing_value(&key, one.start) };
            self.values.push((name, value));
            // Files do not have LMUV: it is of the book only.
            let is_needless = version == FormulaVersion::Five && keys::is_of_spring(&key);
            if is_needless || keys::is_foreign(&key, version) || keys::is_pressure(&key) || key == "LMUV" {
                continue;
            }
            match told.iter_mut().find(|(number, _)| *number == value) {
                Some((_, keys)) => keys.push(key),
                None => told.push((value, vec![key])),
            }
        }
        told.sort_by(|one, other| one.0.total_cmp(&other.0));
        let note = |(value, keys): &(f64, Vec<String>)| format!("not in the file, set to {value}: {}", keys.join(", "));
        self.notes.extend(told.iter().map(note));
        for (key, name) in BOTH {
            if self.value(&format!("front.{name}")).is_none() {
                self.notes.push(format!("{key}: not in the file, a car keeps its own"));
            }
        }
    }

    /// Rejects coefficients for other axes.
    fn check_axes(&self) -> Result<(), Refusal> {
        let [pky1, pky2] = ["PKY1", "PKY2"].map(|key| self.value(&variable(key)).unwrap_or_default());
        if pky1 * pky2 > 0.0 {
            return Err(Refusal::of_file(format!(
                "PKY1 = {pky1}, PKY2 = {pky2}: the cornering stiffness must be negative with the axes of the format"
            )));
        }
        Ok(())
    }
}

/// The entries of each key that is not read on its own, in the order of the file.
fn by_key<'a, 'b>(entries: &'a [Entry<'b>]) -> Vec<(&'a str, Vec<&'a Entry<'b>>)> {
    let mut all: Vec<(&str, Vec<&Entry>)> = Vec::new();
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    for entry in entries {
        if SAID.contains(&entry.key.as_str()) || ["UNITS", "MDI_HEADER"].contains(&entry.section.as_str()) {
            continue;
        }
        let place = *places.entry(keys::canonical(&entry.key)).or_insert(all.len());
        if place == all.len() {
            all.push((&entry.key, Vec::new()));
        }
        all[place].1.push(entry);
    }
    all
}

/// Whether the values of two keys are not said to be equal.
fn may_differ(entries: &[Entry], key: &str, other: &str) -> bool {
    let value = |key| entries.iter().rfind(|entry| keys::canonical(&entry.key) == key)?.number().ok();
    match (value(key), value(other)) {
        (Some(one), Some(other)) => one.value != other.value,
        _ => true,
    }
}
