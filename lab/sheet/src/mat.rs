//! Tables of MAT files, of version 4 and 5.

mod elements;
mod value;
mod version_4;

use std::collections::HashMap;
use std::path::Path;

use value::{Array, Value};

use crate::error::SheetError;
use crate::guard::refused;
use crate::sheet::{Channel, Sheet, not_too_large};

/// The vectors of a MAT file and of the structures and cells in it, as one table; vectors of other lengths end with
/// empty cells. Units are those that a structure gives for names: tyre machines write `channel`, with the cells `name`
/// and `units`. Scalars, matrices and texts are left out; a note says so of complex numbers and objects.
pub(super) fn read(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    not_too_large(path)?;
    let bytes = std::fs::read(path).map_err(|error| refused(path, error))?;
    let mut found = Found::default();
    for (name, value) in variables(&bytes).map_err(|why| refused(path, why))? {
        let place = Place { name: name.clone(), path: name };
        found.add(place, value).map_err(|why| refused(path, why))?;
    }
    if found.vectors.is_empty() {
        return Err(refused(path, format_args!("the file has no vectors{}", found.others())));
    }
    let sheet = found.channels().and_then(Sheet::of_channels).map_err(|why| refused(path, why))?;
    Ok(vec![sheet.with(found.note())])
}

/// The variables of a file, by their names.
fn variables(bytes: &[u8]) -> Result<Vec<(String, Value)>, String> {
    // HDF5 begins with this, after a header of 512 bytes in files of MATLAB.
    if [0, 512].iter().any(|at| bytes.get(*at..).is_some_and(|rest| rest.starts_with(b"\x89HDF\r\n"))) {
        return Err("the file is MAT 7.3, which is HDF5: save it in MATLAB with -v7".to_owned());
    }
    let found = if let Some(is_big) = elements::is_big(bytes) {
        elements::variables(bytes, is_big)
    } else if let Some(is_big) = version_4::is_big(bytes) {
        version_4::variables(bytes, is_big)
    } else {
        return Err("the file is not MAT 4 or 5 (save it in MATLAB with -v7)".to_owned());
    };
    found.map_err(|damage| damage.to_string())
}

/// Fields of a structure with the names, the units and the values of its channels.
const NAMES: [&str; 3] = ["name", "names", "label"];
const UNITS: [&str; 2] = ["unit", "units"];
const VALUES: [&str; 3] = ["data", "value", "values"];

/// Most values that are named in a message.
const MOST_NAMED: usize = 8;

/// Where a value is: the name of its variable or field, and with those of the structures around it.
#[derive(Clone)]
struct Place {
    name: String,
    path: String,
}

impl Place {
    fn field(&self, name: &str) -> Place {
        Place { name: name.to_owned(), path: format!("{}.{name}", self.path) }
    }

    /// An element of several, counted as MATLAB does.
    fn element(&self, brackets: [char; 2], number: usize) -> Place {
        let [open, close] = brackets;
        let [name, path] = [&self.name, &self.path].map(|name| format!("{name}{open}{number}{close}"));
        Place { name, path }
    }
}

/// Vectors with their places, units, and what is neither.
#[derive(Default)]
struct Found {
    vectors: Vec<(Place, Vec<f64>)>,
    /// Units by the places of channels in the structure that gives them, and by their names alone.
    units: HashMap<String, String>,
    units_of_names: HashMap<String, Vec<String>>,
    /// Places and kinds of other values, and whether a user may miss them.
    others: Vec<(String, String, bool)>,
}

impl Found {
    /// The vectors by their names, or by their places if several have the same name.
    fn channels(&mut self) -> Result<Vec<Channel>, String> {
        let mut counts: HashMap<String, usize> = HashMap::new();
        for (place, _) in &self.vectors {
            *counts.entry(place.name.to_lowercase()).or_default() += 1;
        }
        let vectors = std::mem::take(&mut self.vectors);
        let channel = |(place, values): (Place, Vec<f64>)| {
            let unit = self.unit(&place)?;
            let is_alone = counts[&place.name.to_lowercase()] == 1;
            Ok((if is_alone { place.name } else { place.path }, unit, values))
        };
        vectors.into_iter().map(channel).collect()
    }

    /// The unit of a vector: that of its structure, or the one that another structure gives for its name.
    fn unit(&self, place: &Place) -> Result<String, String> {
        if let Some(unit) = self.units.get(&place.path) {
            return Ok(unit.clone());
        }
        match self.units_of_names.get(&place.name).map_or(&[][..], Vec::as_slice) {
            [] => Ok(String::new()),
            [unit, others @ ..] if others.iter().all(|other| other == unit) => Ok(unit.clone()),
            all => Err(format!("{}: the file gives several units, {}", place.path, few(all))),
        }
    }

    fn others(&self) -> String {
        let all: Vec<String> = self.others.iter().map(|(path, kind, _)| format!("{path} ({kind})")).collect();
        if all.is_empty() { String::new() } else { format!("; it has {}", few(&all)) }
    }

    fn note(&self) -> Option<String> {
        let missed = self.others.iter().filter(|(_, _, is_missed)| *is_missed);
        let missed: Vec<String> = missed.map(|(path, kind, _)| format!("{path} ({kind})")).collect();
        (!missed.is_empty()).then(|| format!("not read: {}", few(&missed)))
    }

    fn add(&mut self, place: Place, value: Value) -> Result<(), String> {
        match value {
            Value::Structures(mut all) if all.len() == 1 => self.add_structure(&place, all.remove(0))?,
            Value::Structures(all) => {
                (1..)
                    .zip(all)
                    .try_for_each(|(number, one)| self.add_structure(&place.element(['(', ')'], number), one))?;
            }
            Value::Cells(all) => {
                (1..).zip(all).try_for_each(|(number, one)| self.add(place.element(['{', '}'], number), one))?;
            }
            Value::Numbers(array) => {
                let kind = dimensions(&array);
                match array.into_vector() {
                    Some(values) => self.vectors.push((place, values)),
                    None => self.others.push((place.path, kind, false)),
                }
            }
            Value::Texts(_) => self.others.push((place.path, "text".to_owned(), false)),
            Value::Other(kind) => self.others.push((place.path, kind.to_owned(), true)),
        }
        Ok(())
    }

    /// Adds the channels of a structure, whose fields are vectors or the cells that give names, units and values.
    fn add_structure(&mut self, place: &Place, fields: Vec<(String, Value)>) -> Result<(), String> {
        let (names, units) = (texts_of(&fields, &NAMES), texts_of(&fields, &UNITS));
        if !units.is_empty() && names.len() != units.len() {
            let (path, names, units) = (&place.path, names.len(), units.len());
            return Err(format!("{path}: {names} names, {units} units; must be as many"));
        }
        for (name, unit) in names.iter().zip(units) {
            self.units.insert(place.field(name).path, unit.clone());
            self.units_of_names.entry(name.clone()).or_default().push(unit);
        }
        for (field, value) in fields {
            let inner = place.field(&field);
            let has_texts = is_one(&field, &NAMES) || is_one(&field, &UNITS);
            if is_one(&field, &VALUES) && !names.is_empty() && !matches!(value, Value::Structures(_)) {
                self.add_values(place, inner, &names, value);
            } else if !has_texts || !matches!(value, Value::Texts(_) | Value::Cells(_)) {
                self.add(inner, value)?;
            }
        }
        Ok(())
    }

    /// Adds the values of channels whose names are given.
    fn add_values(&mut self, place: &Place, inner: Place, names: &[String], value: Value) {
        match vectors(value, names.len()) {
            Some(all) => self.vectors.extend(names.iter().map(|name| place.field(name)).zip(all)),
            None => self.others.push((inner.path, format!("not a vector for each of {} names", names.len()), true)),
        }
    }
}

/// The first of some texts, and how many more there are.
fn few(all: &[String]) -> String {
    let more = all.len().saturating_sub(MOST_NAMED);
    let shown = all[..all.len() - more].join(", ");
    if more == 0 { shown } else { format!("{shown} and {more} more") }
}

fn dimensions(array: &Array) -> String {
    let lengths: Vec<String> = array.dimensions.iter().map(usize::to_string).collect();
    lengths.join(" x ")
}

fn is_one(field: &str, wanted: &[&str]) -> bool {
    wanted.iter().any(|known| known.eq_ignore_ascii_case(field))
}

/// The texts of the fields of these names.
fn texts_of(fields: &[(String, Value)], wanted: &[&str]) -> Vec<String> {
    fields.iter().filter(|(field, _)| is_one(field, wanted)).flat_map(|(_, value)| texts(value)).collect()
}

/// The texts of a cell array, or of the rows of an array of characters.
fn texts(value: &Value) -> Vec<String> {
    match value {
        Value::Cells(cells) => cells.iter().map(|cell| texts(cell).join(" ")).collect(),
        Value::Texts(texts) => texts.iter().filter(|text| !text.is_empty()).cloned().collect(),
        _ => Vec::new(),
    }
}

/// As many vectors as there are names: those of a cell array, the columns of a matrix, or one vector.
fn vectors(value: Value, count: usize) -> Option<Vec<Vec<f64>>> {
    let one = |value: Value| if let Value::Numbers(array) = value { array.into_vector() } else { None };
    match value {
        Value::Cells(cells) if cells.len() == count => cells.into_iter().map(one).collect(),
        Value::Numbers(array) if count > 1 && array.dimensions.len() == 2 && array.dimensions[1] == count => {
            let rows = array.dimensions[0].max(1);
            Some(array.values.chunks(rows).map(<[f64]>::to_vec).collect())
        }
        other => one(other).filter(|_| count == 1).map(|values| vec![values]),
    }
}

#[cfg(test)]
mod tests;
