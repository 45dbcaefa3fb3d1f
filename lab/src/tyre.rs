//! `stribeck tyre`: turns a tyre property file into a parameter set.

use std::path::PathBuf;

use lab::tir::{self, TirError, TyreFile};
use ssp::parameter_set::SetError;
use thiserror::Error;

/// Input and output files.
#[derive(clap::Args)]
pub struct Arguments {
    /// The tyre property file (.tir), with coefficients of the Magic Formula 5.
    file: PathBuf,
    /// Parameter set to write, .csv or .ssv; without it, the set is printed.
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Reason why no set was written.
#[derive(Debug, Error)]
pub enum TyreError {
    /// The file cannot be read.
    #[error(transparent)]
    Tir(#[from] TirError),
    /// The set cannot be written.
    #[error(transparent)]
    Set(#[from] SetError),
}

/// Writes the set to the file or to standard output, and messages to standard error.
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
