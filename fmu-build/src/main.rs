//! Writes the files that derive from the tables of the models, checks them, and packs FMUs.

mod archive;
mod block;
mod curve;
mod defaults;
mod dependencies;
mod diagrams;
mod figure;
mod four_post;
mod generated;
mod header;
mod html;
mod icon;
mod library;
mod mathematics;
mod package;
mod project;
mod readme;
mod rules;
#[cfg(test)]
mod specimen;
mod ssp;
mod sweep;
mod text;
mod typeset;
mod xml;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, bail};
use clap::{Parser, Subcommand};

/// Writes what derives from the tables of Stribeck's models, and packs its FMUs.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write modelDescription/*.xml, include/stribeck.h and the tables in README.md and docs.
    Generate,
    /// Write nothing; fail if one of these files is stale or a table breaks a rule.
    Check,
    /// Write the documentation pages of the FMUs alone, to look at them.
    Pages {
        /// Models whose page is wanted; all if none is named.
        models: Vec<String>,
        /// Folder for the pages.
        #[arg(long, default_value = "out/pages")]
        out: PathBuf,
    },
    /// Build the library for this machine and write the four-post rig as SSP package, with its FMUs and parameter sets.
    Ssp {
        /// Folder for the package.
        #[arg(long, default_value = "dist")]
        out: PathBuf,
    },
    /// Build the library for this machine and pack one FMU per model.
    Pack {
        /// Models to pack; all if none is named.
        models: Vec<String>,
        /// Folder for the FMUs.
        #[arg(long, default_value = "dist")]
        out: PathBuf,
    },
}

fn main() -> ExitCode {
    let root = project::root();
    let result = match Arguments::parse().command {
        Command::Generate => generate(root),
        Command::Check => check(root),
        Command::Pages { models, out } => pages(&models, &out),
        Command::Ssp { out } => ssp(root, &out),
        Command::Pack { models, out } => pack(root, &models, &out),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn generate(root: &Path) -> Result<()> {
    let stale = generated::stale(root)?;
    for file in &stale {
        file.write(root)?;
        println!("wrote {}", file.path.display());
    }
    if stale.is_empty() {
        println!("nothing to do: all generated files are up to date");
    }
    Ok(())
}

fn check(root: &Path) -> Result<()> {
    let stale = generated::stale(root)?;
    let breaches = rules::breaches(root)?;
    for file in &stale {
        println!("stale: {}", file.path.display());
    }
    for breach in &breaches {
        println!("{breach}");
    }
    if !stale.is_empty() {
        bail!("stale files: {}; run `cargo run -p fmu-build -- generate`", stale.len());
    }
    if !breaches.is_empty() {
        bail!("broken rules: {}", breaches.len());
    }
    println!("generated files are up to date, and the tables keep the rules");
    Ok(())
}

fn pages(models: &[String], out: &Path) -> Result<()> {
    for entry in &package::select(models)? {
        package::write_page(entry, out)?;
        println!("{}", out.join(entry.model.name).join("documentation/index.html").display());
    }
    Ok(())
}

fn pack(root: &Path, models: &[String], out: &Path) -> Result<()> {
    let entries = package::select(models)?;
    refuse_stale(root)?;
    let date = project::packing_date()?;
    let library = library::build(root)?;
    for entry in &entries {
        let size = package::write(entry, &library, root, date, out)?;
        println!("{:<20} {:>9} bytes", format!("{}.fmu", entry.model.name), size);
    }
    println!("{} FMUs for {} in {}", entries.len(), library.platform, out.display());
    Ok(())
}

/// The library refuses an FMU whose XML was written from another table.
fn refuse_stale(root: &Path) -> Result<()> {
    if let Some(file) = generated::stale(root)?.first() {
        bail!("{} is stale: run `cargo run -p fmu-build -- generate` and review the change", file.path.display());
    }
    Ok(())
}

fn ssp(root: &Path, out: &Path) -> Result<()> {
    refuse_stale(root)?;
    let date = project::packing_date()?;
    let library = library::build(root)?;
    let mut files = archive::Files::new();
    let models: Vec<String> = four_post::add_to(&mut files, root)?.into_iter().map(str::to_owned).collect();
    for entry in package::select(&models)? {
        // libcosim and Ecos know no enumerations.
        let bytes = package::fmu(&entry, &library, root, date, xml::Choices::Numbered)?;
        files.insert(ssp::fmu(entry.model.name), bytes);
    }
    let file = format!("{}.ssp", four_post::NAME);
    let size = package::save(out, &file, &archive::zip(&files, date)?)?;
    println!("{file:<20} {size:>9} bytes");
    Ok(())
}
