//! A tyre test as a user describes it, and what is found in it.

use std::cmp::Ordering::{Equal, Less};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde::{Deserialize, Serialize};
use stribeck::host::{FormulaVersion, Side};
use stribeck_solve::job::{self, Entry};
use stribeck_solve::system::Fault;
use thiserror::Error;

use super::super::experiment::names;
use super::files::joined;
use super::left_out::leave_out;
use super::{Axes, TyreTask, TyreTest, TyreTestError};
use stribeck_sheet::{Sheet, SheetError, of_file, table};

/// A tyre test, and what is known of it.
#[derive(Args, Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields, default)]
pub struct Inquiry {
    /// The tyre property file (.tir), with coefficients of the Magic Formula 5.2, 6.1 or 6.2; or the tables of a tyre
    /// test, one or several, with the columns FZ, SA (alpha), FY, and perhaps SR (kappa; SL if SR is constant), IA
    /// (gamma), FX, MZ and P; of braking and driving FZ, SR and FX, and perhaps the others
    #[serde(alias = "record", deserialize_with = "job::names")]
    pub records: Vec<PathBuf>,
    /// Name of a column in the tables of a test: SA=Schraeglaufwinkel
    #[arg(long, value_name = "NAME=COLUMN")]
    #[serde(with = "job::table")]
    pub column: Vec<Entry<String>>,
    /// Sheet of a spreadsheet (default: the first one with a table)
    #[arg(long, value_name = "NAME")]
    pub sheet: Option<String>,
    /// Seconds at the start of each table of a test that are skipped (default: 0)
    #[arg(long)]
    pub skip: Option<f64>,
    /// Samples of a test that are fitted: those in which a column is in a range, in the unit of its file: TSTC=50:70
    #[arg(long, value_name = "COLUMN=LOW:HIGH", allow_hyphen_values = true)]
    #[serde(with = "job::table")]
    pub only: Vec<Entry<[f64; 2]>>,
    /// Axes of the test
    #[arg(long, value_enum)]
    pub axes: Option<Axes>,
    /// Radius of the tested tyre without load, in m
    #[arg(long)]
    pub radius: Option<f64>,
    /// Version of the Magic Formula that is fitted (default: 6.1 if the test has at least three inflation pressures and
    /// none is chosen, else 5.2)
    #[arg(long, value_enum)]
    pub formula: Option<FormulaChoice>,
    /// Inflation pressure of the samples that are fitted by 5.2, in Pa (default: that with the most samples)
    #[arg(long)]
    pub pressure: Option<f64>,
    /// Nominal inflation pressure of the coefficients of 6.1, in Pa (default: that of the test nearest to the mean)
    #[arg(long)]
    pub nominal_pressure: Option<f64>,
    /// Nominal load of the coefficients, in N (default: the mean load of the test)
    #[arg(long)]
    pub nominal_load: Option<f64>,
    /// Side of the car on which the tyre was tested (default: left)
    #[arg(long, value_enum)]
    pub side: Option<SideChoice>,
    /// Coefficient that is held: PKY2=1.7
    #[arg(long, value_name = "KEY=VALUE")]
    #[serde(with = "job::table")]
    pub fix: Vec<Entry<f64>>,
}

/// Version of the Magic Formula.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
pub enum FormulaChoice {
    /// Without inflation pressure
    #[serde(rename = "5.2")]
    #[value(name = "5.2")]
    Five,
    /// With inflation pressure
    #[serde(rename = "6.1")]
    #[value(name = "6.1")]
    Six,
}

impl FormulaChoice {
    fn version(self) -> FormulaVersion {
        match self {
            FormulaChoice::Five => FormulaVersion::Five,
            FormulaChoice::Six => FormulaVersion::Six,
        }
    }
}

/// Side of the car.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum SideChoice {
    /// The left one
    Left,
    /// The right one
    Right,
}

/// Reason why no tyre was found.
#[derive(Debug, Error)]
pub enum TyreInquiryError {
    /// The table cannot be read.
    #[error("{}", of_file(path, source))]
    Test {
        /// The file.
        path: PathBuf,
        /// Why.
        source: TyreTestError,
    },
    /// The test is not described, or no tyre was found.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl Inquiry {
    /// The tyre property file, if the record is one; it stands alone.
    pub fn property_file(&self) -> Result<Option<&Path>, Fault> {
        let is_one = |path: &&PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("tir"));
        match (&self.records[..], self.records.iter().find(is_one)) {
            ([], _) => Err(Fault::value("no record was given")),
            ([_], found) => Ok(found.map(PathBuf::as_path)),
            (_, Some(one)) => {
                let text = format_args!("{}: a tyre property file stands alone, without other files", one.display());
                Err(Fault::value(text))
            }
            _ => Ok(None),
        }
    }

    /// Refuses what only a test has.
    pub fn refuse_test(&self) -> Result<(), Fault> {
        if *self == (Inquiry { records: self.records.clone(), ..Inquiry::default() }) {
            return Ok(());
        }
        Err(Fault::value(
            "axes, radius, formula, pressure, nominal_pressure, nominal_load, side, column, sheet, skip, only and fix: are \
             for a tyre test, not for a .tir file",
        ))
    }

    /// Reads the test.
    pub fn test(&self) -> Result<TyreTest, TyreInquiryError> {
        if self.records.is_empty() {
            return Err(Fault::value("no record was given").into());
        }
        let axes = self.axes.ok_or_else(|| Fault::value("axes: a tyre test needs iso or sae"))?;
        let paths: Vec<&Path> = self.records.iter().map(PathBuf::as_path).collect();
        let sheets = paths.iter().map(|path| self.read(path)).collect::<Result<Vec<Sheet>, TyreInquiryError>>()?;
        self.check_columns(&sheets)?;
        self.check_left_out()?;
        self.check_pressures()?;
        let tests = paths.iter().zip(sheets).map(|(path, mut sheet)| {
            let refused = |source| TyreInquiryError::Test { path: (*path).into(), source };
            let note = leave_out(&mut sheet, self.skip, &self.only).map_err(refused)?;
            let mut test = TyreTest::of(&self.renamed(sheet), axes).map_err(refused)?;
            test.notes.extend(note);
            Ok(test)
        });
        let tests = tests.collect::<Result<Vec<TyreTest>, TyreInquiryError>>()?;
        let mut test = joined(names(&paths).into_iter().zip(tests).collect());
        let refused = |source| TyreInquiryError::Test { path: paths[0].into(), source };
        let version = self.formula.map(FormulaChoice::version);
        test.for_version(version, self.pressure, self.nominal_pressure).map_err(refused)?;
        Ok(test)
    }

    fn read(&self, path: &Path) -> Result<Sheet, TyreInquiryError> {
        let refused = |error: SheetError| TyreInquiryError::Test { path: path.into(), source: error.into() };
        table(path, self.sheet.as_deref()).map_err(refused)
    }

    /// Properties of the tyre that the test does not show.
    pub fn task(&self) -> Result<TyreTask, Fault> {
        let radius = self.radius.ok_or_else(|| Fault::value("radius: a tyre test needs the radius without load"))?;
        let side = if self.side == Some(SideChoice::Right) { Side::Right } else { Side::Left };
        let fixed = self.fix.iter().map(|Entry(key, value)| (key.clone(), *value)).collect();
        Ok(TyreTask { radius, nominal_load: self.nominal_load, side, fixed })
    }

    /// Refuses times and ranges that nothing can be in.
    fn check_left_out(&self) -> Result<(), Fault> {
        if let Some(skip) = self.skip.filter(|skip| !(*skip >= 0.0 && skip.is_finite())) {
            return Err(Fault::value(format_args!("skip = {skip}: must be >= 0 and finite, in s")));
        }
        match self.only.iter().find(|Entry(_, [low, high])| !matches!(low.partial_cmp(high), Some(Less | Equal))) {
            Some(Entry(name, [low, high])) => {
                Err(Fault::value(format_args!("only: {name} = {low}:{high}: must be LOW:HIGH with LOW <= HIGH")))
            }
            None => Ok(()),
        }
    }

    /// Refuses pressures that the version does not know.
    fn check_pressures(&self) -> Result<(), Fault> {
        if let Some(one) = self.nominal_pressure.filter(|one| !(*one > 0.0 && one.is_finite())) {
            return Err(Fault::value(format_args!("nominal_pressure = {one}: must be > 0 and finite, in Pa")));
        }
        let is_six = self.formula == Some(FormulaChoice::Six) || self.nominal_pressure.is_some();
        if is_six && self.pressure.is_some() {
            return Err(Fault::value("pressure: is for formula 5.2; 6.1 is fitted to all inflation pressures"));
        }
        if self.formula == Some(FormulaChoice::Five) && self.nominal_pressure.is_some() {
            return Err(Fault::value("nominal_pressure: is for formula 6.1; 5.2 has no inflation pressure"));
        }
        Ok(())
    }

    /// Refuses names of columns that no file has.
    fn check_columns(&self, sheets: &[Sheet]) -> Result<(), Fault> {
        for Entry(name, column) in &self.column {
            let known = || TyreTest::COLUMNS.iter().flat_map(|names| names.iter().copied());
            quantity(name).ok_or_else(|| Fault::unknown("quantity of a tyre test", name, known()))?;
            if !sheets.iter().any(|sheet| sheet.has(column)) {
                let files: Vec<String> = self.records.iter().map(|path| path.display().to_string()).collect();
                return Err(Fault::File(format!("{}: no column '{column}' for {name}", files.join(", "))));
            }
        }
        Ok(())
    }

    /// The table with the names of columns as they are here; each file may have its own.
    fn renamed(&self, mut sheet: Sheet) -> Sheet {
        for Entry(name, column) in &self.column {
            // The first name is looked for first, so that no other column takes its place.
            quantity(name).into_iter().for_each(|names| sheet.rename(column, names[0]));
        }
        sheet
    }
}

/// The names of the quantity that has this one.
fn quantity(name: &str) -> Option<&'static [&'static str]> {
    TyreTest::COLUMNS.into_iter().find(|names| names.iter().any(|known| known.eq_ignore_ascii_case(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_test_needs_and_a_property_file_does_not_have_is_refused() {
        let described = |text: &str| toml::from_str::<Inquiry>(text).unwrap();
        let refusal = |text: &str| described(text).test().unwrap_err().to_string();
        assert_eq!(refusal(""), "no record was given");
        assert_eq!(refusal("record = \"a\""), "axes: a tyre test needs iso or sae");
        let refusal = described("axes = \"sae\"").task().unwrap_err().to_string();
        assert_eq!(refusal, "radius: a tyre test needs the radius without load");
        assert!(described("record = \"a.tir\"").refuse_test().is_ok());
        let several = described("records = [\"a.csv\", \"b.TIR\"]").property_file().unwrap_err().to_string();
        assert_eq!(several, "b.TIR: a tyre property file stands alone, without other files");
        assert_eq!(described("records = \"b.TIR\"").property_file().unwrap(), Some(Path::new("b.TIR")));
        assert_eq!(described("records = [\"a.csv\", \"b.csv\"]").property_file().unwrap(), None);
        for option in [
            "axes = \"iso\"",
            "radius = 0.3",
            "side = \"left\"",
            "fix = { PKY2 = 1.7 }",
            "column = { SA = \"a\" }",
            "sheet = \"a\"",
            "skip = 1.0",
            "formula = \"6.1\"",
            "nominal_pressure = 8e4",
            "only = { ET = [0, 1] }",
        ] {
            assert!(described(option).refuse_test().is_err(), "{option}");
        }
    }
}
