//! Tyre property files (`.tir`) with coefficients of the Magic Formula, as values for the variables of a car.
//!
//! `FITTYP` decides the version of the formula: 5, 6, 21 and 52 are for 5.2, as are the formats `PAC2002`, `MF_05` and
//! `MF-TYRE`; 60 and 61 are for 6.1, 62 is for 6.2. Missing coefficients are 0 and missing scale factors 1, as the
//! format prescribes; no value of the built-in tyre remains. Vertical stiffness and damping are used for the tyres of
//! both axles; the coefficients of deflection and rolling radius change no force, but the radii of the tyres.
//!
//! Files are read as programs write them: sections and keys in any order, in any case, with any others between them. A
//! key without value counts as absent. Keys that are not used are listed, and so are those that would change
//! forces but are not modelled. Only what makes forces wrong is refused.

mod keys;
mod lines;
mod reader;
#[cfg(test)]
mod reference;
#[cfg(test)]
mod tests;
mod twice;
mod units;
mod version;

use std::fs;
use std::path::{Path, PathBuf};

use ssp::parameter_set::{ParameterSet, SetError};
use thiserror::Error;

pub use keys::Group;
pub(crate) use keys::missing_value;
use lines::Refusal;
use reader::Contents;

/// Contents of a file.
#[derive(Debug)]
pub struct TyreFile {
    /// Values for the tyres of `DoubleTrackCar`.
    pub set: ParameterSet,
    /// Keys that change no force and moment of the model.
    pub unused: Vec<Group>,
    /// Keys that would change forces or moments by effects which the model does not have.
    pub ignored: Vec<Group>,
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
    parse(&path.display().to_string(), &lines::decoded(bytes))
}

/// Reads the text of a file; `name` appears in errors.
pub fn parse(name: &str, text: &str) -> Result<TyreFile, TirError> {
    let fail = |Refusal { at, why }: Refusal| match at {
        Some((line, text)) => TirError::Line { name: name.into(), line, text, why },
        None => TirError::Missing { name: name.into(), why },
    };
    let text = lines::with_lines(text);
    let Contents { values, unused, ignored, notes } = reader::read(&text).map_err(fail)?;
    let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
    let set = ParameterSet::new(reader::car(), &stem, values);
    let set = set.map_err(|source| TirError::Set { name: name.into(), source })?;
    Ok(TyreFile { set, unused, ignored, notes })
}
