//! Columns of a tyre test, turned into the axes of the library.

use std::collections::BTreeMap;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::super::uncertainty::digits;
use stribeck_sheet::{ANGLE, FORCE, MOMENT, PRESSURE, Quantity, SLIP, Sheet, SheetError};

/// Axes of a tyre test.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Axes {
    /// ISO 8855: x forward, y left, z up; the load is positive
    Iso,
    /// SAE J670: x forward, y right, z down; the load is negative
    Sae,
}

/// A tyre test in the axes of the library, ISO 8855, with a side slip that is positive to the left.
#[derive(Clone, Debug, PartialEq)]
pub struct TyreTest {
    /// Load F_z, N.
    pub load: Vec<f64>,
    /// Side slip, rad.
    pub side_slip: Vec<f64>,
    /// Longitudinal slip.
    pub longitudinal_slip: Vec<f64>,
    /// Camber, rad.
    pub camber: Vec<f64>,
    /// Force along x, N, if it was measured.
    pub force_x: Option<Vec<f64>>,
    /// Force along y, N.
    pub force_y: Vec<f64>,
    /// Moment about z, N.m, if it was measured.
    pub moment_z: Option<Vec<f64>>,
    /// Inflation pressure, Pa, if it was measured.
    pub pressure: Option<Vec<f64>>,
    /// Notes on data that were ignored, with the reason.
    pub notes: Vec<String>,
}

/// Reason why a table is not a tyre test.
#[derive(Debug, thiserror::Error)]
pub enum TyreTestError {
    /// The table cannot be read.
    #[error(transparent)]
    Sheet(#[from] SheetError),
    /// A load has the wrong sign.
    #[error("line {line}, {name}: {value} N: must be {wanted} with these axes")]
    Load {
        /// Line of the file.
        line: u64,
        /// Name of the column.
        name: String,
        /// The value.
        value: f64,
        /// The condition.
        wanted: &'static str,
    },
    /// An angle is larger than a tyre can have.
    #[error("line {line}, {name}: {value} rad: must be at most pi/2 in magnitude{hint}")]
    Angle {
        /// Line of the file.
        line: u64,
        /// Name of the column.
        name: String,
        /// The value.
        value: f64,
        /// Possible reason, if the file gives no unit.
        hint: String,
    },
    /// There are too few samples.
    #[error("{count} samples; at least {LEAST} are needed")]
    Short {
        /// Their number.
        count: usize,
    },
    /// No sample has the pressure that was asked for.
    #[error("pressure = {wanted} Pa: must be one of those of the test, {levels} kPa")]
    Pressure {
        /// The pressure.
        wanted: f64,
        /// Those of the test, in kPa.
        levels: String,
    },
    /// The side force has the wrong sign.
    #[error(
        "the side force rises with the side slip: in both ISO and SAE axes a tyre that slips to one side is pushed to \
         the other; reverse the side slip, or the force"
    )]
    SideForce,
}

/// Least number of samples (chosen: twice the coefficients of the side force).
pub(super) const LEAST: usize = 40;

/// A column under one of its names.
fn named<'a>(sheet: &Sheet, names: &[&'a str], quantity: &Quantity) -> Result<Option<(&'a str, Vec<f64>)>, SheetError> {
    for name in names {
        if let Some(values) = sheet.column_named(name, quantity)? {
            return Ok(Some((name, values)));
        }
    }
    Ok(None)
}

fn required<'a>(sheet: &Sheet, names: &[&'a str], quantity: &Quantity) -> Result<(&'a str, Vec<f64>), SheetError> {
    match named(sheet, names, quantity)? {
        Some(found) => Ok(found),
        None => Err(sheet.missing(&names.join("', '"))),
    }
}

/// Largest slip angle and camber, rad (chosen); a hair more, since 90 degrees are that.
const LARGEST_ANGLE: f64 = std::f64::consts::FRAC_PI_2 + 1e-9;

/// Refuses angles that are too large for radians.
fn check_angle(sheet: &Sheet, name: &str, angles: &[f64]) -> Result<(), TyreTestError> {
    let Some(row) = angles.iter().position(|angle| angle.abs() > LARGEST_ANGLE) else { return Ok(()) };
    let has_unit = sheet.unit(name).is_some_and(|unit| !unit.is_empty());
    let hint = if has_unit { String::new() } else { format!("; is the unit deg? Then write {name} [deg]") };
    Err(TyreTestError::Angle { line: sheet.line(row), name: name.to_owned(), value: angles[row], hint })
}

/// Least change of a slip that was measured, and largest one that may be meant where it is constant (chosen).
const MEASURED: f64 = 0.005;

/// Longitudinal slip, and a note if it is a constant that stands for no measurement, as machines write it in cornering.
fn measured_slip(name: &str, slip: Vec<f64>) -> (Vec<f64>, Option<String>) {
    let mean = slip.iter().sum::<f64>() / slip.len().max(1) as f64;
    let square = slip.iter().map(|one| (one - mean).powi(2)).sum::<f64>() / slip.len().max(1) as f64;
    if mean.abs() <= MEASURED || square.sqrt() >= MEASURED {
        return (slip, None);
    }
    let note = format!("{name} is {} throughout and is ignored as not measured: free rolling is assumed", digits(mean));
    (vec![0.0; slip.len()], Some(note))
}

/// Relative width in which pressures are counted, and part of the samples from which they are a level (chosen).
const WIDTH: f64 = 0.02;
const LEVEL: f64 = 0.02;

/// The levels of a pressure: between them it only passes. Each has its samples.
fn levels(pressure: &[f64]) -> Vec<Vec<usize>> {
    let mut counts: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (at, one) in pressure.iter().enumerate() {
        counts.entry((one.ln() / WIDTH).round() as i64).or_default().push(at);
    }
    let least = LEVEL * pressure.len() as f64;
    let (mut levels, mut last): (Vec<Vec<usize>>, Option<i64>) = (Vec::new(), None);
    for (bin, samples) in counts.into_iter().filter(|(_, samples)| samples.len() as f64 >= least) {
        match levels.last_mut().filter(|_| last == Some(bin - 1)) {
            Some(level) => level.extend(samples),
            None => levels.push(samples),
        }
        last = Some(bin);
    }
    levels.iter_mut().for_each(|level| level.sort_unstable());
    levels
}

/// Refuses loads with the sign of other axes.
fn check_load(sheet: &Sheet, name: &str, load: &[f64], axes: Axes) -> Result<(), TyreTestError> {
    let (sign, wanted) = if axes == Axes::Sae { (-1.0, "<= 0") } else { (1.0, ">= 0") };
    let Some(row) = load.iter().position(|load| sign * load < 0.0) else { return Ok(()) };
    Err(TyreTestError::Load { line: sheet.line(row), name: name.to_owned(), value: load[row], wanted })
}

/// Names of the columns: those of rigs and that of the library. Headings are compared without regard to case.
const LOAD: &[&str] = &["F_z", "FZ", "normal_force"];
const SIDE_SLIP: &[&str] = &["alpha", "SA", "side_slip"];
const FORCE_Y: &[&str] = &["F_y", "FY", "force_y"];
const LONGITUDINAL_SLIP: &[&str] = &["kappa", "SR", "SL", "longitudinal_slip"];
const CAMBER: &[&str] = &["gamma", "IA", "camber"];
const FORCE_X: &[&str] = &["F_x", "FX", "force_x"];
const MOMENT_Z: &[&str] = &["M_z", "MZ", "moment_z"];
const INFLATION: &[&str] = &["P", "pressure", "inflation_pressure"];

impl TyreTest {
    /// Names of the columns of a test, those of one quantity together.
    pub const COLUMNS: [&[&str]; 8] =
        [LOAD, SIDE_SLIP, FORCE_Y, LONGITUDINAL_SLIP, CAMBER, FORCE_X, MOMENT_Z, INFLATION];

    /// Reads a table with the columns F_z, alpha and F_y, and perhaps kappa, gamma, F_x, M_z and P.
    pub fn of(sheet: &Sheet, axes: Axes) -> Result<TyreTest, TyreTestError> {
        let (load_name, load) = required(sheet, LOAD, &FORCE)?;
        let (slip_name, side_slip) = required(sheet, SIDE_SLIP, &ANGLE)?;
        let (_, force_y) = required(sheet, FORCE_Y, &FORCE)?;
        let slip = named(sheet, LONGITUDINAL_SLIP, &SLIP)?;
        let camber = named(sheet, CAMBER, &ANGLE)?;
        let force_x = named(sheet, FORCE_X, &FORCE)?.map(|(_, values)| values);
        let moment_z = named(sheet, MOMENT_Z, &MOMENT)?.map(|(_, values)| values);
        let pressure = named(sheet, INFLATION, &PRESSURE)?.map(|(_, values)| values);
        let count = load.len();
        if count < LEAST {
            return Err(TyreTestError::Short { count });
        }
        check_angle(sheet, slip_name, &side_slip)?;
        camber.as_ref().map_or(Ok(()), |(name, angles)| check_angle(sheet, name, angles))?;
        check_load(sheet, load_name, &load, axes)?;
        let camber = camber.map_or_else(|| vec![0.0; count], |(_, values)| values);
        let slip = slip.map(|(name, values)| measured_slip(name, values));
        let (longitudinal_slip, note) = slip.unwrap_or_else(|| (vec![0.0; count], None));
        let notes = sheet.note().map(str::to_owned).into_iter().chain(note).collect();
        let mut test =
            TyreTest { load, side_slip, longitudinal_slip, camber, force_x, force_y, moment_z, pressure, notes };
        if axes == Axes::Sae {
            test.turn();
        }
        // Each sample by itself may be on the wrong side, by a shift or at large camber.
        let work: f64 = test.side_slip.iter().zip(&test.force_y).map(|(slip, force)| slip * force).sum();
        if work > 0.0 { Err(TyreTestError::SideForce) } else { Ok(test) }
    }

    /// Keeps the samples of one inflation pressure, in Pa; without one those of the pressure with the most samples.
    pub fn at_pressure(&mut self, wanted: Option<f64>) -> Result<(), TyreTestError> {
        let Some(pressure) = self.pressure.as_ref().filter(|all| all.iter().all(|one| *one > 0.0)) else {
            let levels = "none".to_owned();
            return wanted.map_or(Ok(()), |wanted| Err(TyreTestError::Pressure { wanted, levels }));
        };
        let levels = levels(pressure);
        let mean = |level: &Vec<usize>| level.iter().map(|at| pressure[*at]).sum::<f64>() / level.len() as f64;
        let shown = levels.iter().map(|level| format!("{:.1}", 1e-3 * mean(level))).collect::<Vec<_>>().join(", ");
        let distance = |level: &&Vec<usize>| wanted.map_or(0.0, |wanted| (mean(level) / wanted).ln().abs());
        let chosen = match wanted {
            None => levels.iter().max_by_key(|level| level.len()),
            Some(_) => levels.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))),
        };
        let Some(chosen) = chosen.filter(|level| distance(level) <= 2.0 * WIDTH) else {
            return wanted.map_or(Ok(()), |wanted| Err(TyreTestError::Pressure { wanted, levels: shown }));
        };
        if levels.len() > 1 {
            self.notes.push(format!(
                "inflation pressures of {shown} kPa: fitted to the {} samples at {:.1} kPa, for version 5.2 of the \
                 formula has none; another one: --pressure",
                chosen.len(),
                1e-3 * mean(chosen)
            ));
            self.keep(&chosen.clone());
        }
        Ok(())
    }

    /// Keeps samples.
    fn keep(&mut self, samples: &[usize]) {
        let TyreTest { load, side_slip, longitudinal_slip, camber, force_x, force_y, moment_z, pressure, .. } = self;
        let given = [load, side_slip, longitudinal_slip, camber, force_y].into_iter();
        let measured = [force_x, moment_z, pressure].into_iter().flatten();
        for column in given.chain(measured) {
            *column = samples.iter().map(|at| column[*at]).collect();
        }
    }

    /// A half turn about x: y and z change their signs, and with them what is measured along them. A camber is a turn
    /// about x.
    fn turn(&mut self) {
        let moment = self.moment_z.iter_mut().flatten();
        let turned = self.load.iter_mut().chain(&mut self.side_slip).chain(&mut self.force_y).chain(moment);
        turned.for_each(|value| *value = -*value);
    }
}
