//! `stribeck tyre`: turns a tyre property file into a parameter set, and a tyre test into a tyre property file.

use std::path::PathBuf;

use clap::ValueEnum;
use ssp::parameter_set::SetError;
use stribeck::host::Side;
use stribeck_fit::identify::tyre::{Axes, TyreTask, TyreTest, TyreTestError, fit_tyre, property_file, table};
use stribeck_fit::sheet::{Sheet, SheetError};
use stribeck_fit::tir::{self, TirError, TyreFile};
use stribeck_solve::system::{Fault, Setting};
use thiserror::Error;

use crate::outputs;

/// Input and output files.
#[derive(clap::Args)]
pub struct Arguments {
    /// The tyre property file (.tir), with coefficients of the Magic Formula 5; or a table of a tyre test, with the
    /// columns FZ, SA (alpha), FY, and perhaps SR (kappa), IA (gamma), FX and MZ.
    file: PathBuf,
    /// Parameter set to write, .csv or .ssv; from a test, a tyre property file, .tir. Without it, it is printed.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Name of a column in the table of a test: SA=Schraeglaufwinkel.
    #[arg(long, value_name = "NAME=COLUMN")]
    column: Vec<Setting>,
    /// Axes of the test.
    #[arg(long)]
    axes: Option<AxesChoice>,
    /// Radius of the tested tyre without load, in m.
    #[arg(long)]
    radius: Option<f64>,
    /// Nominal load of the coefficients, in N; the mean load of the test unless given.
    #[arg(long)]
    nominal_load: Option<f64>,
    /// Side of the car on which the tyre was tested.
    #[arg(long, value_enum, default_value_t = SideChoice::Left)]
    side: SideChoice,
    /// Coefficient that is held: PKY2=1.7
    #[arg(long, value_name = "KEY=VALUE")]
    fix: Vec<Setting>,
}

#[derive(Clone, Copy, ValueEnum)]
enum AxesChoice {
    /// ISO 8855: y to the left, z up, positive loads.
    Iso,
    /// SAE J670: y to the right, z down, negative loads.
    Sae,
}

#[derive(Clone, Copy, ValueEnum)]
enum SideChoice {
    Left,
    Right,
}

/// Reason why no file was written.
#[derive(Debug, Error)]
pub enum TyreError {
    /// The file cannot be read.
    #[error(transparent)]
    Tir(#[from] TirError),
    /// The set cannot be written.
    #[error(transparent)]
    Set(#[from] SetError),
    /// The table cannot be read.
    #[error("{}: {source}", path.display())]
    Test {
        /// The file.
        path: PathBuf,
        /// Why.
        source: TyreTestError,
    },
    /// No tyre was found.
    #[error(transparent)]
    Fit(#[from] Fault),
}

/// Writes the result to the file or to standard output, and messages to standard error.
pub fn run(arguments: &Arguments) -> Result<(), TyreError> {
    let is_property_file = outputs::has_ending(&arguments.file, "tir");
    let endings: &[&str] = if is_property_file { &["csv", "ssv"] } else { &["tir"] };
    arguments.out.as_ref().map_or(Ok(()), |out| outputs::file(out, endings))?;
    if is_property_file { convert(arguments) } else { fit(arguments) }
}

fn convert(arguments: &Arguments) -> Result<(), TyreError> {
    let is_of_test = arguments.axes.is_some() || arguments.radius.is_some() || arguments.nominal_load.is_some();
    if is_of_test || !arguments.column.is_empty() {
        let text = "--axes, --radius, --nominal-load and --column: are for a tyre test, not for a .tir file";
        return Err(Fault::value(text).into());
    }
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

/// The table with the names of columns as they are here.
fn renamed(mut sheet: Sheet, arguments: &Arguments) -> Result<Sheet, Fault> {
    for Setting { name, value } in &arguments.column {
        let is_named = |names: &&&[&str]| names.iter().any(|known| known.eq_ignore_ascii_case(name));
        let known = || TyreTest::COLUMNS.iter().flat_map(|names| names.iter().copied());
        let names = TyreTest::COLUMNS.iter().find(is_named);
        let names = names.ok_or_else(|| Fault::unknown("quantity of a tyre test", name, known()))?;
        if !sheet.has(value) {
            return Err(Fault::File(format!("{}: no column '{value}' for {name}", arguments.file.display())));
        }
        // The first name is looked for first, so that no other column takes its place.
        sheet.rename(value, names[0]);
    }
    Ok(sheet)
}

fn fit(arguments: &Arguments) -> Result<(), TyreError> {
    let path = &arguments.file;
    let axes = match arguments.axes {
        Some(AxesChoice::Iso) => Axes::Iso,
        Some(AxesChoice::Sae) => Axes::Sae,
        None => return Err(Fault::value("--axes: a tyre test needs iso or sae").into()),
    };
    let radius = arguments.radius.ok_or_else(|| Fault::value("--radius: a tyre test needs the radius without load"))?;
    let side = if let SideChoice::Left = arguments.side { Side::Left } else { Side::Right };
    let test = |source: TyreTestError| TyreError::Test { path: path.clone(), source };
    let sheet = renamed(Sheet::load(path).map_err(|error: SheetError| test(error.into()))?, arguments)?;
    let tyre_test = TyreTest::of(&sheet, axes).map_err(test)?;
    let fixed = arguments.fix.iter().map(Setting::number).collect::<Result<Vec<(String, f64)>, Fault>>()?;
    let found = fit_tyre(&tyre_test, &TyreTask { radius, nominal_load: arguments.nominal_load, side, fixed })?;
    let text = property_file(&found);
    // The reader is the judge of what is written.
    tir::parse("fitted.tir", &text)?;
    match &arguments.out {
        Some(out) => {
            std::fs::write(out, text).map_err(|source| TirError::File { path: out.clone(), source })?;
            print!("{}", table(&found));
            println!("\n{}", out.display());
        }
        None => print!("{text}"),
    }
    Ok(())
}
