//! The elements of MAT 5 files, as in "MAT-File Format" of The MathWorks (chapter 1).
//!
//! A file is a header and elements; an element is a tag with kind and length, and bytes. Variables are elements made of
//! elements, perhaps compressed. Every length is checked against the bytes that are there.

use std::io::Read;

use flate2::read::ZlibDecoder;

use super::value::{Array, Damage, Kind, Limit, Value, each, rows};
use crate::error::LARGEST;

/// Length of the header.
const HEADER: usize = 128;
/// Kinds of elements that are not numbers.
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Most dimensions of an array (chosen).
const MOST_DIMENSIONS: usize = 32;
/// How deep structures and cells may be nested (chosen).
const DEEPEST: usize = 64;

/// The order of bytes of a MAT 5 file, None for other files: whether the most significant byte comes first.
pub fn is_big(bytes: &[u8]) -> Option<bool> {
    match bytes.get(HEADER - 2..HEADER)? {
        b"IM" => Some(false),
        b"MI" => Some(true),
        _ => None,
    }
}

/// The variables of a file, by their names.
pub fn variables(bytes: &[u8], is_big: bool) -> Result<Vec<(String, Value)>, Damage> {
    let (header, rest) = bytes.split_at(HEADER.min(bytes.len()));
    // What belongs to objects has no name; files without it have spaces or zeros here.
    let objects = each(&header[HEADER - 12..HEADER - 4], is_big, u64::from_le_bytes)[0];
    let mut reader = Reader { limit: Limit::new(), unpacked: LARGEST };
    let mut elements = Elements { rest, at: HEADER, is_big };
    let mut found = Vec::new();
    while let Some(element) = elements.next()? {
        if element.tag as u64 == objects {
            continue;
        }
        match element.kind {
            MATRIX => found.push(reader.matrix(&element, 0)?),
            COMPRESSED => found.extend(reader.compressed(&element)?),
            _ => {}
        }
    }
    Ok(found)
}

/// Elements one after another.
struct Elements<'a> {
    rest: &'a [u8],
    /// Byte of the rest.
    at: usize,
    is_big: bool,
}

/// An element.
struct Element<'a> {
    kind: u32,
    bytes: &'a [u8],
    /// Byte of the tag.
    tag: usize,
    /// Byte of the content.
    at: usize,
    is_big: bool,
}

impl<'a> Elements<'a> {
    fn take(&mut self, count: usize, what: &str) -> Result<&'a [u8], Damage> {
        let Some((bytes, rest)) = self.rest.split_at_checked(count) else {
            let left = self.rest.len();
            return Err(Damage::new(self.at, format_args!("{what} has {count} bytes, but there are {left}")));
        };
        (self.rest, self.at) = (rest, self.at + count);
        Ok(bytes)
    }

    /// The next element; None at the end.
    fn next(&mut self) -> Result<Option<Element<'a>>, Damage> {
        if self.rest.is_empty() {
            return Ok(None);
        }
        let (tag, is_big) = (self.at, self.is_big);
        let word = |bytes: &[u8]| each(bytes, is_big, u32::from_le_bytes)[0];
        let first = word(self.take(4, "a tag")?);
        let (kind, length) = (first & 0xffff, (first >> 16) as usize);
        // A small element has its bytes in its tag.
        if length > 0 {
            let at = self.at;
            let bytes = self.take(4, "a small element")?;
            let wrong = || Damage::new(tag, format_args!("a small element has {length} bytes, must have at most 4"));
            let bytes = bytes.get(..length).ok_or_else(wrong)?;
            return Ok(Some(Element { kind, bytes, tag, at, is_big }));
        }
        let length = word(self.take(4, "a tag")?) as usize;
        let at = self.at;
        let bytes = self.take(length, "an element")?;
        // Some programs leave out the zeros at the end.
        let is_padded = kind != MATRIX && kind != COMPRESSED;
        let zeros = if is_padded { length.next_multiple_of(8) - length } else { 0 };
        self.take(zeros.min(self.rest.len()), "")?;
        Ok(Some(Element { kind, bytes, tag, at, is_big }))
    }

    fn required(&mut self, what: &str) -> Result<Element<'a>, Damage> {
        let at = self.at;
        self.next()?.ok_or_else(|| Damage::new(at, format_args!("ends before {what}")))
    }
}

impl<'a> Element<'a> {
    fn parts(&self) -> Elements<'a> {
        Elements { rest: self.bytes, at: self.at, is_big: self.is_big }
    }

    fn damage(&self, why: impl std::fmt::Display) -> Damage {
        Damage::new(self.tag, why)
    }

    fn words(&self, what: &str) -> Result<Vec<u32>, Damage> {
        if !matches!(self.kind, 5 | 6) || !self.bytes.len().is_multiple_of(4) {
            return Err(self.damage(format_args!("{what}: must be integers of 4 bytes")));
        }
        Ok(each(self.bytes, self.is_big, u32::from_le_bytes))
    }

    /// Lengths in all directions, and their product.
    fn dimensions(&self) -> Result<(Vec<usize>, usize), Damage> {
        let words = self.words("dimensions")?;
        if words.len() > MOST_DIMENSIONS {
            let count = words.len();
            return Err(self.damage(format_args!("{count} dimensions, must be at most {MOST_DIMENSIONS}")));
        }
        let lengths: Vec<usize> = words.iter().map(|length| *length as usize).collect();
        let count = lengths.iter().try_fold(1usize, |count, length| count.checked_mul(*length));
        let count = count.filter(|_| lengths.len() > 1 && words.iter().all(|length| i32::try_from(*length).is_ok()));
        let count = count.ok_or_else(|| self.damage(format_args!("dimensions {lengths:?} are impossible")))?;
        Ok((lengths, count))
    }

    fn name(&self) -> String {
        text_before_zero(self.bytes)
    }

    fn number_kind(&self) -> Result<Kind, Damage> {
        Ok(match self.kind {
            1 => Kind::I8,
            2 => Kind::U8,
            3 => Kind::I16,
            4 => Kind::U16,
            5 => Kind::I32,
            6 => Kind::U32,
            7 => Kind::F32,
            9 => Kind::F64,
            12 => Kind::I64,
            13 => Kind::U64,
            kind => return Err(self.damage(format_args!("kind {kind}, must be one of numbers"))),
        })
    }

    fn letters(&self) -> Result<Vec<char>, Damage> {
        let known = |unit: u32| char::from_u32(unit).unwrap_or(char::REPLACEMENT_CHARACTER);
        Ok(match self.kind {
            1 | 2 => self.bytes.iter().copied().map(char::from).collect(),
            4 | 17 => {
                let units = each(self.bytes, self.is_big, u16::from_le_bytes);
                char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
            }
            16 => String::from_utf8_lossy(self.bytes).chars().collect(),
            6 | 18 => each(self.bytes, self.is_big, u32::from_le_bytes).into_iter().map(known).collect(),
            kind => return Err(self.damage(format_args!("kind {kind}, must be one of characters"))),
        })
    }
}

fn text_before_zero(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes.split(|byte| *byte == 0).next().unwrap_or_default()).into_owned()
}

/// Limits of a file.
struct Reader {
    limit: Limit,
    /// Bytes that compressed variables may still have.
    unpacked: u64,
}

impl Reader {
    fn compressed(&mut self, element: &Element) -> Result<Option<(String, Value)>, Damage> {
        let mut bytes = Vec::new();
        let mut decoder = ZlibDecoder::new(element.bytes).take(self.unpacked + 1);
        decoder
            .read_to_end(&mut bytes)
            .map_err(|error| element.damage(format_args!("a compressed variable is damaged ({error})")))?;
        let rest = self.unpacked.checked_sub(bytes.len() as u64);
        let too_large = || element.damage(format_args!("compressed variables have more than {LARGEST} bytes"));
        self.unpacked = rest.ok_or_else(too_large)?;
        let mut elements = Elements { rest: &bytes, at: 0, is_big: element.is_big };
        let within = |damage: Damage| element.damage(format_args!("compressed, {damage}"));
        match elements.next().map_err(within)? {
            Some(inner) if inner.kind == MATRIX => self.matrix(&inner, 0).map(Some).map_err(within),
            _ => Ok(None),
        }
    }

    /// A variable, with its name.
    fn matrix(&mut self, element: &Element, depth: usize) -> Result<(String, Value), Damage> {
        if depth > DEEPEST {
            return Err(element.damage(format_args!("nested more than {DEEPEST} levels deep")));
        }
        if element.kind != MATRIX {
            return Err(element.damage(format_args!("kind {}, must be {MATRIX}: a variable", element.kind)));
        }
        if element.bytes.is_empty() {
            return Ok((String::new(), Value::Numbers(Array { dimensions: vec![0, 0], values: Vec::new() })));
        }
        let mut parts = element.parts();
        let flags = parts.required("the class of a variable")?;
        let flags = flags.words("the class of a variable")?.first().copied().unwrap_or(0);
        let (class, is_complex) = (flags & 0xff, flags & 0x800 != 0);
        if class == 17 {
            return Ok((parts.required("the name")?.name(), Value::Other("object")));
        }
        let (dimensions, count) = parts.required("the dimensions")?.dimensions()?;
        let name = parts.required("the name")?.name();
        let value = match class {
            1 => Value::Cells(self.values(&mut parts, count, depth)?),
            2 => Value::Structures(self.structures(&mut parts, count, depth)?),
            3 => Value::Other("object"),
            4 => Value::Texts(rows(&parts.required("the characters")?.letters()?, dimensions[0], count)),
            5 => Value::Other("sparse matrix"),
            6..=15 if is_complex => Value::Other("complex numbers"),
            6..=15 => Value::Numbers(self.numbers(&parts.required("the numbers")?, dimensions, count)?),
            16 => Value::Other("function"),
            _ => Value::Other("unknown class"),
        };
        Ok((name, value))
    }

    fn numbers(&mut self, element: &Element, dimensions: Vec<usize>, count: usize) -> Result<Array, Damage> {
        let kind = element.number_kind()?;
        if count.checked_mul(kind.size()) != Some(element.bytes.len()) {
            let (bytes, size) = (element.bytes.len(), kind.size());
            return Err(element.damage(format_args!("{bytes} bytes, must be {count} numbers of {size} bytes")));
        }
        self.limit.take(element.tag, count)?;
        Ok(Array { dimensions, values: kind.numbers(element.bytes, element.is_big) })
    }

    fn values(&mut self, parts: &mut Elements, count: usize, depth: usize) -> Result<Vec<Value>, Damage> {
        let one = |_| Ok(self.matrix(&parts.required("a cell or field")?, depth + 1)?.1);
        (0..count).map(one).collect()
    }

    fn structures(
        &mut self,
        parts: &mut Elements,
        count: usize,
        depth: usize,
    ) -> Result<Vec<Vec<(String, Value)>>, Damage> {
        let length = parts.required("the length of the names of fields")?;
        let width = length.words("the length of the names of fields")?.first().map_or(0, |width| *width as usize);
        let names = parts.required("the names of fields")?;
        if names.bytes.is_empty() {
            return Ok(Vec::new());
        }
        if width == 0 || !names.bytes.len().is_multiple_of(width) {
            let bytes = names.bytes.len();
            return Err(names.damage(format_args!("the names of fields have {bytes} bytes, in names of {width}")));
        }
        let names: Vec<String> = names.bytes.chunks(width).map(text_before_zero).collect();
        let one = |_| Ok(names.iter().cloned().zip(self.values(parts, names.len(), depth)?).collect());
        (0..count).map(one).collect()
    }
}
