//! Runs a system of FMUs in one of two importers written in Rust, or checks FMUs with one of them.
//! tests/python/test_importers.py compares it with other importers.

mod fmi_rs;
mod master;
mod plan;
mod rust_fmi;

use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use clap::{Parser, Subcommand};

/// Runs a system of FMUs in an importer written in Rust.
#[derive(Parser)]
enum Command {
    /// Run a system in the importer of the crate `fmi`.
    #[command(subcommand)]
    Run(Importer),
    /// Check descriptions with the crate `fmi-rs`.
    Check {
        /// The .fmu files.
        fmus: Vec<PathBuf>,
    },
}

/// The importer, and the text file that describes the system.
#[derive(Subcommand)]
enum Importer {
    /// The crate `fmi`.
    Fmi { plan: PathBuf },
    /// The crate `fmi-rs`.
    FmiRs { plan: PathBuf },
}

fn main() -> Result<()> {
    match Command::parse() {
        Command::Run(Importer::Fmi { plan }) => run::<rust_fmi::RustFmi>(&plan),
        Command::Run(Importer::FmiRs { plan }) => run::<fmi_rs::FmiRs>(&plan),
        Command::Check { fmus } => check(&fmus),
    }
}

fn run<S: master::Slave>(file: &PathBuf) -> Result<()> {
    let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut out = BufWriter::new(io::stdout().lock());
    let done = master::run::<S>(&plan::Plan::read(&text)?, &mut out);
    // Results before an error are written as well.
    out.flush()?;
    done
}

fn check(fmus: &[PathBuf]) -> Result<()> {
    let mut found = 0;
    for path in fmus {
        for problem in fmi_rs::problems(path)? {
            println!("{}: {problem}", path.display());
            found += 1;
        }
    }
    ensure!(found == 0, "{found} problems in {} FMUs", fmus.len());
    println!("{} FMUs, no problems", fmus.len());
    Ok(())
}
