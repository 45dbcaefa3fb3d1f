//! MAT 4 files: a header of five integers for each variable, its name, its numbers.

use super::value::{Array, Damage, Kind, Limit, Value, each, rows};

/// Length of a header.
const HEADER: usize = 20;

/// The order of bytes of a MAT 4 file, None for other files: whether the most significant byte comes first.
pub fn is_big(bytes: &[u8]) -> Option<bool> {
    [false, true].into_iter().find(|is_big| {
        let header = bytes.get(..HEADER).map(|header| each(header, *is_big, u32::from_le_bytes));
        header.is_some_and(|header| {
            let [kind, rows, columns, is_complex, name] = header[..] else { return false };
            // The thousands are the order of bytes.
            let is_order = kind / 1000 == u32::from(*is_big) && is_known(kind);
            is_order && rows.max(columns) < 1 << 31 && is_complex < 2 && (1..1 << 16).contains(&name)
        })
    })
}

/// Whether the last digits are a precision and a type, with nothing in the hundreds.
fn is_known(kind: u32) -> bool {
    (kind / 100).is_multiple_of(10) && kind / 10 % 10 < 6 && kind % 10 < 3
}

/// The variables of a file, by their names.
pub fn variables(bytes: &[u8], is_big: bool) -> Result<Vec<(String, Value)>, Damage> {
    let mut reader = Reader { rest: bytes, at: 0, is_big, limit: Limit::new() };
    let mut found = Vec::new();
    while !reader.rest.is_empty() {
        found.push(reader.variable()?);
    }
    Ok(found)
}

struct Reader<'a> {
    rest: &'a [u8],
    /// Byte of the rest.
    at: usize,
    is_big: bool,
    limit: Limit,
}

impl<'a> Reader<'a> {
    fn take(&mut self, count: Option<usize>, what: &str) -> Result<&'a [u8], Damage> {
        let Some((bytes, rest)) = count.and_then(|count| self.rest.split_at_checked(count)) else {
            let left = self.rest.len();
            return Err(Damage::new(self.at, format_args!("{what} is longer than the {left} bytes that are there")));
        };
        (self.rest, self.at) = (rest, self.at + bytes.len());
        Ok(bytes)
    }

    fn variable(&mut self) -> Result<(String, Value), Damage> {
        let at = self.at;
        let header = each(self.take(Some(HEADER), "the header of a variable")?, self.is_big, u32::from_le_bytes);
        let (kind, is_complex) = (header[0], header[3] != 0);
        let [height, width, length] = [header[1], header[2], header[4]].map(|count| count as usize);
        if kind / 1000 != u32::from(self.is_big) || !is_known(kind) {
            return Err(Damage::new(at, format_args!("kind {kind} of a variable, which MAT 4 does not have")));
        }
        let name = self.take(Some(length), "a name")?.split(|byte| *byte == 0).next().unwrap_or_default();
        let name = String::from_utf8_lossy(name).into_owned();
        let stored = [Kind::F64, Kind::F32, Kind::I32, Kind::I16, Kind::U16, Kind::U8][(kind / 10 % 10) as usize];
        let size = height.checked_mul(width).and_then(|count| count.checked_mul(stored.size()));
        let content = self.take(size, "a matrix")?;
        if is_complex {
            self.take(size, "an imaginary part")?;
        }
        Ok((name, self.value(at, kind % 10, is_complex, stored, content, [height, width])?))
    }

    fn value(
        &mut self,
        at: usize,
        kind: u32,
        is_complex: bool,
        stored: Kind,
        content: &[u8],
        dimensions: [usize; 2],
    ) -> Result<Value, Damage> {
        if kind == 2 || is_complex {
            return Ok(Value::Other(if kind == 2 { "sparse matrix" } else { "complex numbers" }));
        }
        self.limit.take(at, dimensions[0] * dimensions[1])?;
        let values = stored.numbers(content, self.is_big);
        if kind == 0 {
            return Ok(Value::Numbers(Array { dimensions: dimensions.to_vec(), values }));
        }
        let letter = |code: &f64| char::from_u32(*code as u32).unwrap_or(char::REPLACEMENT_CHARACTER);
        let letters: Vec<char> = values.iter().map(letter).collect();
        Ok(Value::Texts(rows(&letters, dimensions[0], letters.len())))
    }
}
