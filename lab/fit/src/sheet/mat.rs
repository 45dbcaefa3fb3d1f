//! Tables of MAT 5 files.

use std::collections::HashMap;
use std::path::Path;

use matrw::{MatVariable, MatlabType};

use super::guard::{refused, silently};
use super::{Channel, Sheet, SheetError};

/// The vectors of a MAT file and of the structures in it, as one table; vectors of other lengths end with empty cells.
/// Units are those that a structure gives for names: tyre machines write `channel`, with the cells `name` and `units`.
/// Scalars, matrices, complex numbers and texts are left out.
pub(super) fn read(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    super::not_too_large(path)?;
    let bytes = std::fs::read(path).map_err(|error| refused(path, error))?;
    // The reader counts on some lengths being what they should be.
    let parsed = silently(|| variables(&bytes)).ok_or_else(|| refused(path, "the file is damaged"))?;
    let mut found = Found::default();
    for (name, variable) in parsed.map_err(|why| refused(path, why))? {
        found.add(name, variable).map_err(|why| refused(path, why))?;
    }
    if found.channels.is_empty() {
        return Err(refused(path, "the file has no vectors"));
    }
    Ok(vec![Sheet::of_channels(found.named())])
}

/// Fields of a structure with the names, the units and the values of its channels.
const NAMES: [&str; 2] = ["name", "names"];
const UNITS: [&str; 2] = ["unit", "units"];
const VALUES: [&str; 3] = ["data", "value", "values"];

/// Vectors with their names, and units by names.
#[derive(Default)]
struct Found {
    channels: Vec<(String, Vec<f64>)>,
    units: HashMap<String, String>,
}

impl Found {
    fn named(mut self) -> Vec<Channel> {
        let mut channel = |(name, values): (String, Vec<f64>)| {
            let unit = self.units.remove(&name).unwrap_or_default();
            (name, unit, values)
        };
        self.channels.into_iter().map(&mut channel).collect()
    }

    fn add(&mut self, name: String, variable: MatVariable) -> Result<(), String> {
        match variable {
            MatVariable::Structure(one) => self.add_structure(&name, one.value.into_iter().collect()),
            MatVariable::StructureArray(all) => all.value.into_iter().try_for_each(|one| self.add(name.clone(), one)),
            other => {
                self.channels.extend(vector(other).map(|values| (name, values)));
                Ok(())
            }
        }
    }

    /// Adds the channels of a structure, whose fields are vectors or the cells that give names, units and values.
    fn add_structure(&mut self, structure: &str, fields: Vec<(String, MatVariable)>) -> Result<(), String> {
        let texts_of = |wanted: &[&str]| -> Vec<String> {
            let cells = fields.iter().filter(|(field, _)| is_one(field, wanted));
            cells.flat_map(|(_, cells)| texts(cells)).collect()
        };
        let (names, units) = (texts_of(&NAMES), texts_of(&UNITS));
        if !units.is_empty() && names.len() != units.len() {
            return Err(format!("{structure}: {} names, {} units; must be as many", names.len(), units.len()));
        }
        self.units.extend(names.iter().cloned().zip(units));
        for (field, variable) in fields {
            if is_one(&field, &VALUES) && !names.is_empty() {
                let all = vectors(variable, names.len());
                let all = all.ok_or_else(|| format!("{structure}.{field}: must have a vector for each name"))?;
                self.channels.extend(names.iter().cloned().zip(all));
            } else if !is_one(&field, &NAMES) && !is_one(&field, &UNITS) {
                self.channels.extend(vector(variable).map(|values| (field, values)));
            }
        }
        Ok(())
    }
}

fn is_one(field: &str, wanted: &[&str]) -> bool {
    wanted.iter().any(|known| known.eq_ignore_ascii_case(field))
}

/// The texts of a cell array, or one text.
fn texts(variable: &MatVariable) -> Vec<String> {
    match variable {
        MatVariable::CellArray(cells) => cells.value.iter().map(|cell| text(cell).unwrap_or_default()).collect(),
        other => text(other).into_iter().collect(),
    }
}

fn text(variable: &MatVariable) -> Option<String> {
    match variable.numeric_type()? {
        MatlabType::UTF8(letters) | MatlabType::UTF16(letters) => Some(letters.iter().collect()),
        _ => None,
    }
}

/// As many vectors as there are names: those of a cell array, the columns of a matrix, or one vector.
fn vectors(variable: MatVariable, count: usize) -> Option<Vec<Vec<f64>>> {
    match variable {
        MatVariable::CellArray(cells) if cells.value.len() == count => cells.value.into_iter().map(vector).collect(),
        MatVariable::NumericArray(array) if count > 1 && array.dim.last() == Some(&count) && array.dim.len() == 2 => {
            let rows = array.dim[0].max(1);
            Some(numbers(array)?.chunks(rows).map(<[f64]>::to_vec).collect())
        }
        other => vector(other).filter(|_| count == 1).map(|values| vec![values]),
    }
}

/// The numbers of a variable, if it is a real vector.
fn vector(variable: MatVariable) -> Option<Vec<f64>> {
    let MatVariable::NumericArray(array) = variable else { return None };
    let longest = array.dim.iter().copied().max().unwrap_or(0);
    if longest < 2 || array.dim.iter().product::<usize>() != longest {
        return None;
    }
    numbers(array)
}

/// The numbers of an array, if it is real.
fn numbers(array: matrw::NumericArray) -> Option<Vec<f64>> {
    if array.value_cmp.is_some() {
        return None;
    }
    macro_rules! numbers {
        ($($kind:ident),+) => {
            match array.value {
                MatlabType::F64(values) => Some(values),
                $(MatlabType::$kind(values) => Some(values.into_iter().map(f64::from).collect()),)+
                MatlabType::U64(values) => Some(values.into_iter().map(|value| value as f64).collect()),
                MatlabType::I64(values) => Some(values.into_iter().map(|value| value as f64).collect()),
                MatlabType::BOOL(values) => Some(values.into_iter().map(|value| f64::from(u8::from(value))).collect()),
                MatlabType::UTF8(_) | MatlabType::UTF16(_) => None,
            }
        };
    }
    numbers!(U8, I8, U16, I16, U32, I32, F32)
}

/// The variables of a MAT 5 file. Of its header only the kind and the order of bytes count: programs other than MATLAB,
/// such as scipy, write texts into it that the reader would refuse.
fn variables(bytes: &[u8]) -> Result<matrw::MatFile, String> {
    use binrw::{BinRead, Endian};
    use matrw::parser::{header::HEADER_SIZE, v7::matfile7::MatFile7};

    if bytes.starts_with(b"MATLAB 7.3 MAT-file") || bytes.starts_with(b"\x89HDF\r\n") {
        return Err("the file is MAT 7.3, which is HDF5: save it in MATLAB with -v7".to_owned());
    }
    if !bytes.starts_with(b"MATLAB 5.0 MAT-file") || bytes.len() < HEADER_SIZE {
        return Err("the file is not MAT 5 (save it in MATLAB with -v7)".to_owned());
    }
    let (endian, number): (Endian, fn([u8; 8]) -> u64) = match &bytes[HEADER_SIZE - 2..HEADER_SIZE] {
        b"IM" => (Endian::Little, u64::from_le_bytes),
        b"MI" => (Endian::Big, u64::from_be_bytes),
        _ => return Err("the header of the file does not give its byte order".to_owned()),
    };
    // What belongs to objects comes last; files without it have spaces or zeros here.
    let objects = bytes[HEADER_SIZE - 12..HEADER_SIZE - 4].try_into().map_or(0, number);
    let end = usize::try_from(objects).ok().filter(|end| (HEADER_SIZE..bytes.len()).contains(end));
    let mut data = std::io::Cursor::new(&bytes[HEADER_SIZE..end.unwrap_or(bytes.len())]);
    let file = MatFile7::read_options(&mut data, endian, ()).map_err(|error| error.root_cause().to_string())?;
    Ok(file.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sheet::{DISPLACEMENT, FORCE, TIME};

    /// An element of a file: kind, length, bytes, up to a multiple of eight.
    fn element(kind: u32, bytes: &[u8]) -> Vec<u8> {
        let mut all = [kind.to_le_bytes(), (bytes.len() as u32).to_le_bytes()].concat();
        all.extend(bytes);
        all.resize(all.len().next_multiple_of(8), 0);
        all
    }

    /// A variable of a class, with its dimensions and what the class has after its name.
    fn variable(class: u8, name: &str, dimensions: [u32; 2], rest: &[Vec<u8>]) -> Vec<u8> {
        let dimensions = dimensions.map(u32::to_le_bytes).concat();
        let head = [element(6, &[class, 0, 0, 0, 0, 0, 0, 0]), element(5, &dimensions), element(1, name.as_bytes())];
        element(14, &[head.concat(), rest.concat()].concat())
    }

    fn matrix(name: &str, columns: &[&[f64]]) -> Vec<u8> {
        let bytes: Vec<u8> = columns.concat().iter().flat_map(|value| value.to_le_bytes()).collect();
        variable(6, name, [columns[0].len() as u32, columns.len() as u32], &[element(9, &bytes)])
    }

    fn cells(name: &str, texts: &[&str]) -> Vec<u8> {
        let text = |text: &&str| {
            let letters: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
            variable(4, "", [1, text.len() as u32], &[element(17, &letters)])
        };
        variable(1, name, [1, texts.len() as u32], &texts.iter().map(text).collect::<Vec<_>>())
    }

    fn structure(name: &str, fields: &[(&str, Vec<u8>)]) -> Vec<u8> {
        let padded = |(field, _): &(&str, Vec<u8>)| {
            let mut bytes = field.as_bytes().to_vec();
            bytes.resize(32, 0);
            bytes
        };
        let names: Vec<u8> = fields.iter().flat_map(padded).collect();
        let values: Vec<u8> = fields.iter().flat_map(|(_, value)| value.clone()).collect();
        // The length of the names is a small element.
        let length = [[5, 0, 4, 0], 32u32.to_le_bytes()].concat();
        variable(2, name, [1, 1], &[length, element(1, &names), values])
    }

    fn loaded(header: &str, variables: &[Vec<u8>]) -> Result<Sheet, String> {
        let file = tempfile::NamedTempFile::with_suffix(".mat").unwrap();
        let mut bytes = format!("{header:<124}").into_bytes();
        bytes.extend([0, 1, b'I', b'M']);
        bytes.extend(variables.concat());
        std::fs::write(file.path(), bytes).unwrap();
        crate::sheet::table(file.path()).map_err(|error| error.to_string())
    }

    const PLAIN: &str = "MATLAB 5.0 MAT-file, Platform: PCWIN64";

    /// As tyre machines write it: vectors, and their units in a structure.
    #[test]
    fn units_come_from_the_structure_of_the_channels() {
        let fields = [("name", cells("", &["time", "force", "SR"])), ("units", cells("", &["ms", "kN", "none"]))];
        let vectors = [matrix("time", &[&[1.0, 2.0]]), matrix("force", &[&[3.0, 4.0]]), matrix("SR", &[&[5.0, 6.0]])];
        let all = [&vectors[..], &[structure("channel", &fields)]].concat();
        let sheet = loaded(PLAIN, &all).unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
        assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3e3, 4e3]));
        assert_eq!(sheet.unit("SR"), Some(""));
    }

    /// Vectors as fields, as the columns of a matrix, and one structure for each channel.
    #[test]
    fn vectors_may_be_in_the_structure() {
        let head = || vec![("name", cells("", &["time", "force"])), ("units", cells("", &["ms", "kN"]))];
        let with = |more: Vec<(&'static str, Vec<u8>)>| structure("channel", &[head(), more].concat());
        let fields = with(vec![("time", matrix("", &[&[1.0, 2.0]])), ("force", matrix("", &[&[3.0, 4.0]]))]);
        let data = with(vec![("data", matrix("", &[&[1.0, 2.0], &[3.0, 4.0]]))]);
        for one in [fields, data] {
            let sheet = loaded(PLAIN, &[one, matrix("displacement", &[&[7.0, 8.0]])]).unwrap();
            assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
            assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3e3, 4e3]));
            assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![7.0, 8.0]));
        }
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_a_way_out() {
        let hdf5 = "MATLAB 7.3 MAT-file, Platform: PCWIN64";
        assert!(
            loaded(hdf5, &[]).unwrap_err().ends_with("the file is MAT 7.3, which is HDF5: save it in MATLAB with -v7")
        );
        let uneven = structure("channel", &[("name", cells("", &["a", "b"])), ("units", cells("", &["s"]))]);
        let error = loaded(PLAIN, &[uneven]).unwrap_err();
        assert!(error.ends_with("channel: 2 names, 1 units; must be as many"), "{error}");
        let short =
            structure("channel", &[("name", cells("", &["a"])), ("data", matrix("", &[&[1.0, 2.0], &[3.0, 4.0]]))]);
        let error = loaded(PLAIN, &[short]).unwrap_err();
        assert!(error.ends_with("channel.data: must have a vector for each name"), "{error}");
        assert!(loaded(PLAIN, &[]).unwrap_err().ends_with("the file has no vectors"));
    }
}
