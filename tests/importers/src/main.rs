//! Runs a system of FMUs in one of two importers written in Rust, with FMI 2.0 or 3.0, or checks FMUs with one of them.
//! tests/python/test_importers.py compares it with other importers.

mod fmi_rs;
mod fmi_rs3;
mod master;
mod plan;
mod rust_fmi;
mod rust_fmi3;

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

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
        /// The version of FMI.
        #[arg(value_parser = clap::value_parser!(u8).range(2..=3))]
        version: u8,
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
    /// The crate `fmi`, with FMI 3.0.
    Fmi3 { plan: PathBuf },
    /// The crate `fmi-rs`, with FMI 3.0.
    FmiRs3 { plan: PathBuf },
    /// The crate `fmi-rs`, with FMI 3.0 in event mode.
    FmiRs3Events { plan: PathBuf },
}

fn main() -> Result<()> {
    match Command::parse() {
        Command::Run(Importer::Fmi { plan }) => run::<rust_fmi::RustFmi>(&plan),
        Command::Run(Importer::FmiRs { plan }) => run::<fmi_rs::FmiRs>(&plan),
        Command::Run(Importer::Fmi3 { plan }) => run::<rust_fmi3::RustFmi3>(&plan),
        Command::Run(Importer::FmiRs3 { plan }) => run::<fmi_rs3::FmiRs3<false>>(&plan),
        Command::Run(Importer::FmiRs3Events { plan }) => run::<fmi_rs3::FmiRs3<true>>(&plan),
        Command::Check { version, fmus } => {
            check(&fmus, if version == 2 { fmi_rs::problems } else { fmi_rs3::problems })
        }
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

fn check(fmus: &[PathBuf], problems: impl Fn(&Path) -> Result<Vec<String>>) -> Result<()> {
    let mut found = 0;
    for path in fmus {
        for problem in problems(path)? {
            println!("{}: {problem}", path.display());
            found += 1;
        }
    }
    ensure!(found == 0, "{found} problems in {} FMUs", fmus.len());
    println!("{} FMUs, no problems", fmus.len());
    Ok(())
}
