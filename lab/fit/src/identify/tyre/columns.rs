//! Columns of a tyre test, turned into the axes of the library.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use stribeck::host::FormulaVersion;

use super::super::uncertainty::digits;
use stribeck_sheet::{ANGLE, FORCE, MOMENT, PRESSURE, Quantity, SLIP, Sheet, SheetError, TEMPERATURE, TIME};

/// Axes of a tyre test.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Axes {
    /// ISO 8855: x forward, y left, z up; the load is positive
    Iso,
    /// SAE J670: x forward, y right, z down; the load is negative
    Sae,
}

/// A sample of a tyre test in the axes of the library, ISO 8855, with a side slip that is positive to the left. What its
/// file does not have is None.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Load F_z, N.
    pub load: f64,
    /// Side slip, rad.
    pub side_slip: f64,
    /// Longitudinal slip.
    pub longitudinal_slip: f64,
    /// Camber, rad.
    pub camber: f64,
    /// Force along x, N.
    pub force_x: Option<f64>,
    /// Force along y, N.
    pub force_y: Option<f64>,
    /// Moment about z, N.m.
    pub moment_z: Option<f64>,
    /// Inflation pressure, Pa.
    pub pressure: Option<f64>,
    /// Time, s.
    pub time: Option<f64>,
    /// Temperature of the tread, K: the mean of the places where it was measured.
    pub temperature: Option<f64>,
    /// Number of its file.
    pub file: usize,
    /// Line in its file.
    pub line: u64,
}

/// A tyre test: the samples of its files, one file after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TyreTest {
    /// The samples.
    pub samples: Vec<Sample>,
    /// Notes on data that were ignored, with the reason, and on what each file has.
    pub notes: Vec<String>,
    /// Names of the files.
    pub files: Vec<String>,
    /// Nominal pressure of version 6.1 of the formula, Pa; None for version 5.2, which has no pressure.
    pub nominal_pressure: Option<f64>,
}

/// Reason why a table is not a tyre test.
#[derive(Debug, thiserror::Error)]
pub enum TyreTestError {
    /// The table cannot be read.
    #[error(transparent)]
    Sheet(#[from] SheetError),
    /// The table has no force that can be fitted.
    #[error("{missing}; a test without side force needs a longitudinal force over a longitudinal slip that is swept")]
    Force {
        /// The columns.
        missing: SheetError,
    },
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
    #[error("pressure = {wanted} Pa: must be one of those of the test, {levels}")]
    Pressure {
        /// The pressure.
        wanted: f64,
        /// Those of the test.
        levels: String,
    },
    /// Samples have no pressure, which version 6.1 needs.
    #[error("formula 6.1 needs the inflation pressure of all samples; {count} have none")]
    NoPressure {
        /// Their number.
        count: usize,
    },
    /// The side force has the wrong sign.
    #[error(
        "the side force rises with the side slip: in both ISO and SAE axes a tyre that slips to one side is pushed to \
         the other; reverse the side slip, or the force"
    )]
    SideForce,
}

/// Slips up to which the other slip counts as pure (chosen).
pub const PURE: f64 = 0.01;

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

/// Mean of a slip, and whether it changes.
fn sweep(slip: &[f64]) -> (f64, bool) {
    let mean = slip.iter().sum::<f64>() / slip.len().max(1) as f64;
    let square = slip.iter().map(|one| (one - mean).powi(2)).sum::<f64>() / slip.len().max(1) as f64;
    (mean, square.sqrt() >= MEASURED)
}

/// Longitudinal slip, and a note if it is a constant that stands for no measurement, as machines write it in cornering.
fn measured_slip(name: &str, slip: Vec<f64>) -> (Vec<f64>, Option<String>) {
    let (mean, is_swept) = sweep(&slip);
    if mean.abs() <= MEASURED || is_swept {
        return (slip, None);
    }
    let note = format!("{name} is {} throughout and is ignored as not measured: free rolling is assumed", digits(mean));
    (vec![0.0; slip.len()], Some(note))
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
const TIMES: &[&str] = &["time", "ET", "t"];
/// Temperatures of the tread: in the middle, inside, outside.
const TEMPERATURES: [&[&str]; 3] = [&["TSTC", "temperature"], &["TSTI"], &["TSTO"]];

/// Longitudinal slip, if there is one: machines write several, of which the first one that changes is meant, or else the
/// first one.
fn longitudinal_slip(sheet: &Sheet, notes: &mut Vec<String>) -> Result<Option<Vec<f64>>, SheetError> {
    let is_here = |name: &&&str| !matches!(sheet.column_named(name, &SLIP), Ok(None));
    let names: Vec<&str> = LONGITUDINAL_SLIP.iter().filter(is_here).copied().collect();
    let Some((mut name, mut slip)) = named(sheet, &names, &SLIP)? else { return Ok(None) };
    if let [first, others @ ..] = names.as_slice()
        && !others.is_empty()
    {
        let mut swept = None;
        if !sweep(&slip).1 {
            let read = others.iter().filter_map(|other| Some((*other, sheet.column_named(other, &SLIP).ok()??)));
            swept = read.into_iter().find(|(_, slip)| sweep(slip).1);
        }
        if let Some((other, values)) = swept {
            notes.push(format!("{first} is constant: {other} is read as the longitudinal slip"));
            (name, slip) = (other, values);
        } else {
            notes.push(format!("{first} is read as the longitudinal slip, and {} is not", others.join(", ")));
        }
    }
    let (slip, note) = measured_slip(name, slip);
    notes.extend(note);
    Ok(Some(slip))
}

/// Side slip; braking and driving straight on need none.
fn side_slip(sheet: &Sheet, is_driven: bool, notes: &mut Vec<String>) -> Result<Option<Named>, SheetError> {
    match named(sheet, SIDE_SLIP, &ANGLE)? {
        None if is_driven => {
            notes.push(format!("no column '{}': the side slip is 0", SIDE_SLIP.join("', '")));
            Ok(None)
        }
        None => Err(sheet.missing(&SIDE_SLIP.join("', '"))),
        found => Ok(found),
    }
}

/// Inflation pressure, if it was measured.
fn inflation(sheet: &Sheet, notes: &mut Vec<String>) -> Result<Option<Vec<f64>>, SheetError> {
    let Some((name, pressure)) = named(sheet, INFLATION, &PRESSURE)? else { return Ok(None) };
    let is_measured = pressure.iter().all(|one| *one > 0.0);
    if !is_measured {
        notes.push(format!("{name} is not > 0 throughout and is ignored as not measured"));
    }
    Ok(Some(pressure).filter(|_| is_measured))
}

/// The error for a table without a force that can be fitted.
fn without_force(sheet: &Sheet) -> TyreTestError {
    let missing = sheet.missing(&FORCE_Y.join("', '"));
    TyreTestError::Force { missing }
}

/// Times, in s.
pub(super) fn times(sheet: &Sheet) -> Result<Vec<f64>, TyreTestError> {
    Ok(required(sheet, TIMES, &TIME)?.1)
}

/// A column that says something about the samples and is not fitted: the test does without one that cannot be read.
fn beside(sheet: &Sheet, names: &[&str], quantity: &Quantity, notes: &mut Vec<String>) -> Option<Vec<f64>> {
    match named(sheet, names, quantity) {
        Ok(found) => found.map(|(_, values)| values),
        Err(error) => {
            notes.push(format!("{error}; the column is ignored"));
            None
        }
    }
}

/// Mean temperature of the tread, from the columns that have units, of which kelvin is hardly ever meant without one.
fn temperature(sheet: &Sheet, notes: &mut Vec<String>) -> Option<Vec<f64>> {
    let mut all = Vec::new();
    for names in TEMPERATURES {
        match names.iter().find(|name| sheet.assumes_unit(name)) {
            Some(name) => notes.push(format!("{name} has no unit; the column is ignored")),
            None => all.extend(beside(sheet, names, &TEMPERATURE, notes)),
        }
    }
    let mean = |row: usize| all.iter().map(|column| column[row]).sum::<f64>() / all.len() as f64;
    Some((0..all.first()?.len()).map(mean).collect())
}

/// A column under its name.
type Named = (&'static str, Vec<f64>);

/// The columns of a table, in its axes.
struct Measured {
    load: Named,
    side_slip: Option<Named>,
    longitudinal_slip: Option<Vec<f64>>,
    camber: Option<Named>,
    force_x: Option<Vec<f64>>,
    force_y: Option<Vec<f64>>,
    moment_z: Option<Vec<f64>>,
    pressure: Option<Vec<f64>>,
    time: Option<Vec<f64>>,
    temperature: Option<Vec<f64>>,
}

impl Measured {
    fn of(sheet: &Sheet, notes: &mut Vec<String>) -> Result<Measured, TyreTestError> {
        let load = required(sheet, LOAD, &FORCE)?;
        let values = |names, quantity| Ok::<_, SheetError>(named(sheet, names, quantity)?.map(|(_, values)| values));
        let longitudinal_slip = longitudinal_slip(sheet, notes)?;
        // Beside a slip that was not swept, the force along x is the drag of a wheel that rolls freely.
        let is_swept = longitudinal_slip.iter().flatten().any(|slip| slip.abs() > PURE);
        let force_x = values(FORCE_X, &FORCE)?.filter(|_| is_swept);
        let force_y = values(FORCE_Y, &FORCE)?;
        if force_x.is_none() && force_y.is_none() {
            return Err(without_force(sheet));
        }
        let side_slip = side_slip(sheet, force_x.is_some(), notes)?;
        let (camber, moment_z) = (named(sheet, CAMBER, &ANGLE)?, values(MOMENT_Z, &MOMENT)?);
        let pressure = inflation(sheet, notes)?;
        let (time, temperature) = (beside(sheet, TIMES, &TIME, notes), temperature(sheet, notes));
        #[rustfmt::skip]
        let measured = Measured {
            load, side_slip, longitudinal_slip, camber, force_x, force_y, moment_z, pressure, time, temperature,
        };
        Ok(measured)
    }

    fn sample(&self, row: usize, line: u64) -> Sample {
        let at = |values: &Option<Vec<f64>>| values.as_ref().map(|values| values[row]);
        let angle = |angles: &Option<Named>| angles.as_ref().map_or(0.0, |(_, angles)| angles[row]);
        Sample {
            load: self.load.1[row],
            side_slip: angle(&self.side_slip),
            longitudinal_slip: at(&self.longitudinal_slip).unwrap_or(0.0),
            camber: angle(&self.camber),
            force_x: at(&self.force_x),
            force_y: at(&self.force_y),
            moment_z: at(&self.moment_z),
            pressure: at(&self.pressure),
            time: at(&self.time),
            temperature: at(&self.temperature),
            file: 0,
            line,
        }
    }
}

impl TyreTest {
    /// Names of the columns of a test, those of one quantity together.
    pub const COLUMNS: [&[&str]; 12] = [
        LOAD,
        SIDE_SLIP,
        FORCE_Y,
        LONGITUDINAL_SLIP,
        CAMBER,
        FORCE_X,
        MOMENT_Z,
        INFLATION,
        TIMES,
        TEMPERATURES[0],
        TEMPERATURES[1],
        TEMPERATURES[2],
    ];

    /// Reads a table with the columns F_z, alpha and F_y, and perhaps kappa, gamma, F_x, M_z and P; a table of braking
    /// and driving needs kappa and F_x, but neither alpha nor F_y.
    pub fn of(sheet: &Sheet, axes: Axes) -> Result<TyreTest, TyreTestError> {
        let mut notes: Vec<String> = sheet.note().map(str::to_owned).into_iter().collect();
        let measured = Measured::of(sheet, &mut notes)?;
        let count = measured.load.1.len();
        if count < LEAST {
            return Err(TyreTestError::Short { count });
        }
        for (name, angles) in [&measured.side_slip, &measured.camber].into_iter().flatten() {
            check_angle(sheet, name, angles)?;
        }
        check_load(sheet, measured.load.0, &measured.load.1, axes)?;
        let samples = (0..count).map(|row| measured.sample(row, sheet.line(row)));
        let samples = samples.map(|one| if axes == Axes::Sae { one.turned() } else { one }).collect();
        let test = TyreTest { samples, notes, ..TyreTest::default() };
        if test.is_mirrored() { Err(TyreTestError::SideForce) } else { Ok(test) }
    }

    /// Version of the formula that is fitted.
    pub fn version(&self) -> FormulaVersion {
        if self.nominal_pressure.is_some() { FormulaVersion::Six } else { FormulaVersion::Five }
    }

    /// Whether the side force rises with the side slip. Each sample by itself may be on the wrong side, by a shift or at
    /// large camber, and so are many without side slip.
    fn is_mirrored(&self) -> bool {
        let slips = self.samples.iter().filter(|one| one.side_slip.abs() > PURE);
        slips.map(|one| one.side_slip * one.force_y.unwrap_or(0.0)).sum::<f64>() > 0.0
    }
}

impl Sample {
    /// After a half turn about x: y and z change their signs, and with them what is measured along them. A camber is a
    /// turn about x.
    fn turned(self) -> Sample {
        let [force_y, moment_z] = [self.force_y, self.moment_z].map(|value| value.map(|value| -value));
        Sample { load: -self.load, side_slip: -self.side_slip, force_y, moment_z, ..self }
    }

    /// Whether the wheel rolls freely.
    pub fn is_rolling(&self) -> bool {
        self.longitudinal_slip.abs() <= PURE
    }

    /// Whether the wheel does not slip sideways.
    pub fn is_straight(&self) -> bool {
        self.side_slip.abs() <= PURE
    }
}
