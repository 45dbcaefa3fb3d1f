//! `stribeck tyre`: a tyre property file becomes a parameter set.

use std::path::PathBuf;

use lab::parameter_set::SetError;
use lab::tir::{self, TirError, TyreFile};
use thiserror::Error;

/// What to read and where to write.
#[derive(clap::Args)]
pub struct Arguments {
    /// The tyre property file (.tir), with coefficients of the Magic Formula 5.
    file: PathBuf,
    /// Parameter set to write, .csv or .ssv; without it, the set is shown.
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Why there is no set.
#[derive(Debug, Error)]
pub enum TyreError {
    /// The file cannot be read.
    #[error(transparent)]
    Tir(#[from] TirError),
    /// The set cannot be written.
    #[error(transparent)]
    Set(#[from] SetError),
}

/// The set goes to the file or to standard output, what else there is to say to standard error.
pub fn run(arguments: &Arguments) -> Result<(), TyreError> {
    let TyreFile { set, unused, notes } = tir::read(&arguments.file)?;
    for note in notes {
        eprintln!("{note}");
    }
    if !unused.is_empty() {
        eprintln!("not used: {}", unused.join(", "));
    }
    match &arguments.out {
        Some(path) => set.save(path)?,
        None => print!("{}", set.to_csv()),
    }
    Ok(())
}
