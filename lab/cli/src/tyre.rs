//! `stribeck tyre`: converts a tyre property file into a parameter set, and a tyre test into a tyre property file.

use std::path::{Path, PathBuf};

use stribeck_fit::identify::tyre::{Inquiry, TyreInquiryError, fit_tyre, property_file, table};
use stribeck_fit::tir::{self, Group, TyreFile};
use stribeck_plot::picture::{Theme, tyre};
use stribeck_solve::system::Fault;

use crate::command::{Description, Failure, draw, folder, write};
use crate::outputs;

/// A tyre property file or a tyre test, and the file for the result.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    inquiry: Inquiry,
    #[command(flatten)]
    description: Description,
    /// File to write: a parameter set (.csv, .ssv), from a test a tyre property file (.tir); standard output if not given
    #[arg(long)]
    out: Option<PathBuf>,
    /// Folder for pictures of the test and of what was fitted to it
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
}

/// Writes the result to the file or to standard output, and messages to standard error.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let inquiry = arguments.description.complete(&arguments.inquiry)?;
    let property_file = inquiry.property_file()?;
    let is_property_file = property_file.is_some();
    let endings: &[&str] = if is_property_file { &["csv", "ssv"] } else { &["tir"] };
    let out = arguments.out.as_deref();
    out.map_or(Ok(()), |out| outputs::file(out, endings))?;
    arguments.pictures.as_ref().map_or(Ok(()), |folder| outputs::folder(folder))?;
    if is_property_file && arguments.pictures.is_some() {
        return Err(Fault::value("--pictures: is for a tyre test, not for a .tir file").into());
    }
    match property_file {
        Some(path) => {
            inquiry.refuse_test()?;
            convert(path, out)
        }
        None => fit(arguments, &inquiry),
    }
}

fn convert(path: &Path, out: Option<&Path>) -> Result<(), Failure> {
    let TyreFile { set, unused, ignored, notes } = tir::read(path).map_err(refused)?;
    for note in notes {
        eprintln!("{note}");
    }
    tell("would change forces, but not here", &ignored);
    tell("not used", &unused);
    match out {
        Some(path) => set.save(path).map_err(refused)?,
        None => print!("{}", set.to_csv()),
    }
    Ok(())
}

/// Writes groups of keys in one line to standard error.
fn tell(what: &str, groups: &[Group]) {
    if !groups.is_empty() {
        let groups: Vec<String> = groups.iter().map(ToString::to_string).collect();
        eprintln!("{what}: {}", groups.join("; "));
    }
}

fn fit(arguments: &Arguments, inquiry: &Inquiry) -> Result<(), Failure> {
    let task = inquiry.task()?;
    let test = inquiry.test().map_err(|error| match error {
        TyreInquiryError::Fault(fault) => fault,
        error => Fault::File(error.to_string()),
    })?;
    // The notes may say why there is no fit.
    let told = |_: &Fault| test.notes.iter().for_each(|note| eprintln!("{note}"));
    let answer = fit_tyre(&test, &task).inspect_err(told)?;
    if let Some(path) = &arguments.pictures {
        folder(path)?;
        for picture in tyre(&test, &answer.formula, Theme::Light) {
            draw(&picture, &path.join(picture.name()))?;
        }
    }
    let text = property_file(&answer);
    // What is written must be readable.
    tir::parse("fitted.tir", &text).map_err(refused)?;
    match arguments.out.as_deref() {
        Some(out) => {
            write(out, text)?;
            print!("{}", table(&answer));
            println!("\n{}", out.display());
        }
        None => print!("{text}"),
    }
    Ok(())
}

/// An error that names its file.
fn refused(error: impl std::fmt::Display) -> Failure {
    Fault::File(error.to_string()).into()
}
