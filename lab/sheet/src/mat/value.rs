//! Values of MAT files, of version 4 and 5.

use std::fmt;

/// Most numbers that are read from a file: those of the largest text, in eight bytes each.
const MOST_NUMBERS: usize = (crate::error::LARGEST / 8) as usize;

/// Fault of a file, and its place.
#[derive(Debug)]
pub struct Damage {
    /// Byte of the file, from 0; in a compressed variable byte of its content.
    pub at: usize,
    pub why: String,
}

impl Damage {
    pub fn new(at: usize, why: impl fmt::Display) -> Damage {
        Damage { at, why: why.to_string() }
    }
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "byte {}: {}", self.at, self.why)
    }
}

/// Value of a variable, a field or a cell.
#[derive(Debug)]
pub enum Value {
    Numbers(Array),
    /// One text for each row of an array of characters.
    Texts(Vec<String>),
    Cells(Vec<Value>),
    /// The fields of each element of a structure.
    Structures(Vec<Vec<(String, Value)>>),
    /// Kind of a variable that is not read.
    Other(&'static str),
}

/// Real numbers, column after column.
#[derive(Debug)]
pub struct Array {
    pub dimensions: Vec<usize>,
    pub values: Vec<f64>,
}

impl Array {
    /// The numbers of a vector.
    pub fn into_vector(self) -> Option<Vec<f64>> {
        let longest = self.dimensions.iter().copied().max().unwrap_or(0);
        (longest > 1 && self.values.len() == longest).then_some(self.values)
    }
}

/// How numbers are stored.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Kind {
    pub fn size(self) -> usize {
        match self {
            Kind::I8 | Kind::U8 => 1,
            Kind::I16 | Kind::U16 => 2,
            Kind::I32 | Kind::U32 | Kind::F32 => 4,
            Kind::I64 | Kind::U64 | Kind::F64 => 8,
        }
    }

    /// The numbers in bytes; those of 64 bits are rounded.
    pub fn numbers(self, bytes: &[u8], is_big: bool) -> Vec<f64> {
        match self {
            Kind::I8 => each(bytes, is_big, |number| f64::from(i8::from_le_bytes(number))),
            Kind::U8 => each(bytes, is_big, |number| f64::from(u8::from_le_bytes(number))),
            Kind::I16 => each(bytes, is_big, |number| f64::from(i16::from_le_bytes(number))),
            Kind::U16 => each(bytes, is_big, |number| f64::from(u16::from_le_bytes(number))),
            Kind::I32 => each(bytes, is_big, |number| f64::from(i32::from_le_bytes(number))),
            Kind::U32 => each(bytes, is_big, |number| f64::from(u32::from_le_bytes(number))),
            Kind::I64 => each(bytes, is_big, |number| i64::from_le_bytes(number) as f64),
            Kind::U64 => each(bytes, is_big, |number| u64::from_le_bytes(number) as f64),
            Kind::F32 => each(bytes, is_big, |number| f64::from(f32::from_le_bytes(number))),
            Kind::F64 => each(bytes, is_big, f64::from_le_bytes),
        }
    }
}

/// Values of so many bytes each; a rest is left out.
pub fn each<const SIZE: usize, T>(bytes: &[u8], is_big: bool, value: impl Fn([u8; SIZE]) -> T) -> Vec<T> {
    let in_order = |chunk: &[u8; SIZE]| {
        let mut chunk = *chunk;
        if is_big {
            chunk.reverse();
        }
        value(chunk)
    };
    bytes.as_chunks().0.iter().map(in_order).collect()
}

/// Texts of the rows of an array of characters; of characters that are more than one unit long there is one row.
pub fn rows(letters: &[char], rows: usize, count: usize) -> Vec<String> {
    if rows < 2 || letters.is_empty() || letters.len() != count {
        return vec![letters.iter().collect()];
    }
    let row = |row: usize| letters.iter().skip(row).step_by(rows).collect::<String>();
    (0..rows).map(|at| row(at).trim_end().to_owned()).collect()
}

/// Limit of the numbers of a file: a small file may be large where it is not compressed.
#[derive(Debug)]
pub struct Limit(usize);

impl Limit {
    pub fn new() -> Limit {
        Limit(MOST_NUMBERS)
    }

    pub fn take(&mut self, at: usize, count: usize) -> Result<(), Damage> {
        let rest = self.0.checked_sub(count);
        self.0 = rest.ok_or_else(|| Damage::new(at, format_args!("the file has more than {MOST_NUMBERS} numbers")))?;
        Ok(())
    }
}
