//! Tables of binary files of measurements: MDF 4 (feature `mdf`) and MAT 5 (feature `mat`).

use std::path::Path;

use super::{Sheet, SheetError};

/// The tables of a file, one for each group of channels with a clock of its own; of a text file there is one. The format
/// is that of the extension: `.mf4` and `.mdf` are MDF 4, `.mat` is MAT 5, everything else is text.
pub fn tables(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match extension.as_str() {
        "mf4" | "mdf" => mdf(path),
        "mat" => mat(path),
        _ => Ok(vec![Sheet::load(path)?]),
    }
}

fn refused(path: &Path, why: impl std::fmt::Display) -> SheetError {
    SheetError::Format { path: path.into(), why: why.to_string() }
}

#[cfg(not(feature = "mdf"))]
fn mdf(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    Err(refused(path, "this program was built without MDF: build it with --features mdf"))
}

#[cfg(not(feature = "mat"))]
fn mat(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    Err(refused(path, "this program was built without MAT: build it with --features mat"))
}

/// The channel groups of an MDF file. Their master channels are called `time`; samples that the file declares invalid are
/// NaN, an error only if the column is used; channels of text are left out.
#[cfg(feature = "mdf")]
fn mdf(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    use std::collections::BTreeMap;

    use falcon_mdf::{Mf4File, SignalValues};

    let wrong = |error: falcon_mdf::Mf4Error| refused(path, error);
    super::not_too_large(path)?;
    let file = Mf4File::open(path).map_err(wrong)?;
    let mut groups: BTreeMap<(usize, usize), Vec<super::Channel>> = BTreeMap::new();
    for channel in file.channels() {
        let place = (channel.data_group_index, channel.channel_group_index);
        let master = file.master_channel(place.0, place.1);
        let signal = file.signal(channel).map_err(wrong)?;
        if matches!(signal.values().map_err(wrong)?, SignalValues::Str(_)) {
            continue;
        }
        let mut values = signal.values_f64().map_err(wrong)?;
        let validity = signal.validity().unwrap_or_default();
        values.iter_mut().zip(validity).filter(|(_, is_valid)| !is_valid).for_each(|(value, _)| *value = f64::NAN);
        let is_master = master.is_some_and(|master| master.index == channel.index);
        let (name, unit) = if is_master { ("time", "s") } else { (channel.name.as_str(), channel.unit.as_str()) };
        groups.entry(place).or_default().push((name.to_owned(), unit.to_owned(), values));
    }
    if groups.is_empty() {
        return Err(refused(path, "the file has no channels"));
    }
    Ok(groups.into_values().map(Sheet::of_channels).collect())
}

/// The vectors of a MAT file, as one table; vectors of other lengths end with empty cells. Scalars, matrices, complex
/// numbers, texts and structures are left out.
#[cfg(feature = "mat")]
fn mat(path: &Path) -> Result<Vec<Sheet>, SheetError> {
    super::not_too_large(path)?;
    let bytes = std::fs::read(path).map_err(|error| refused(path, error))?;
    // The reader counts on some lengths being what they should be.
    let parsed = silently(|| variables(&bytes)).ok_or_else(|| refused(path, "the file is damaged"))?;
    let file = parsed.map_err(|why| refused(path, why))?;
    let channel = |(name, variable)| vector(variable).map(|values| (name, String::new(), values));
    let channels: Vec<super::Channel> = file.into_iter().filter_map(channel).collect();
    if channels.is_empty() {
        return Err(refused(path, "the file has no vectors"));
    }
    Ok(vec![Sheet::of_channels(channels)])
}

/// The numbers of a variable, if it is a real vector.
#[cfg(feature = "mat")]
fn vector(variable: matrw::MatVariable) -> Option<Vec<f64>> {
    use matrw::{MatVariable, MatlabType};

    let MatVariable::NumericArray(array) = variable else { return None };
    let longest = array.dim.iter().copied().max().unwrap_or(0);
    if array.value_cmp.is_some() || longest < 2 || array.dim.iter().product::<usize>() != longest {
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

/// The outcome of a function that may panic, without the report that Rust prints for a panic; None if it did.
#[cfg(feature = "mat")]
fn silently<T>(read: impl FnOnce() -> T + std::panic::UnwindSafe) -> Option<T> {
    use std::cell::Cell;
    use std::panic::{catch_unwind, set_hook, take_hook};
    use std::sync::Once;

    thread_local!(static IS_SILENT: Cell<bool> = const { Cell::new(false) });
    static ONCE: Once = Once::new();
    // Panics of other threads, and of this one at other times, keep their report.
    ONCE.call_once(|| {
        let report = take_hook();
        set_hook(Box::new(move |info| {
            if !IS_SILENT.get() {
                report(info);
            }
        }));
    });
    IS_SILENT.set(true);
    let outcome = catch_unwind(read);
    IS_SILENT.set(false);
    outcome.ok()
}

/// The variables of a MAT 5 file. Of its header only the kind and the order of bytes count: programs other than MATLAB,
/// such as scipy, write texts into it that the reader would refuse.
#[cfg(feature = "mat")]
fn variables(bytes: &[u8]) -> Result<matrw::MatFile, String> {
    use binrw::{BinRead, Endian};
    use matrw::parser::{header::HEADER_SIZE, v7::matfile7::MatFile7};

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
