//! The tyre of a tyre property file.

use std::path::PathBuf;

use pyo3::prelude::*;
use stribeck::host::{Contact, FormulaVersion, MagicFormula, Side, Wrench};
use stribeck::model::{Columns, row_of_mut, start};
use stribeck_fit::tir::{self, TyreFile};

use crate::refused;

/// A tyre that is read once and asked many times.
#[pyclass(frozen, module = "stribeck._stribeck")]
pub struct Tyre {
    formula: MagicFormula,
    stiffness: Option<f64>,
    damping: Option<f64>,
    notes: Vec<String>,
    unused: Vec<String>,
    ignored: Vec<String>,
}

#[pymethods]
impl Tyre {
    /// Reads a file.
    #[new]
    fn new(path: PathBuf) -> PyResult<Tyre> {
        let TyreFile { set, unused, ignored, notes } = tir::read(&path).map_err(refused)?;
        let mut formula: MagicFormula = start();
        let row = row_of_mut(&mut formula);
        for (column, variable) in MagicFormula::TABLE.iter().enumerate() {
            let name = format!("tyre.{}", variable.path);
            row[column] = set.get(&name).ok_or_else(|| refused(format!("{}: no {name}", path.display())))?;
        }
        let [stiffness, damping] = ["front.tyre_stiffness", "front.tyre_damping"].map(|name| set.get(name));
        let [unused, ignored] = [unused, ignored].map(|groups| groups.iter().map(ToString::to_string).collect());
        Ok(Tyre { formula, stiffness, damping, notes, unused, ignored })
    }

    /// Radius without load, and vertical stiffness and damping if the file gives them.
    fn vertical(&self) -> (f64, Option<f64>, Option<f64>) {
        (self.formula.unloaded_radius, self.stiffness, self.damping)
    }

    /// Assumptions about what the file does not say.
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// Inflation pressure, or none in a version without it.
    fn pressure(&self) -> Option<f64> {
        self.has_pressure().then_some(self.formula.inflpres)
    }

    /// Keys that change no force, by what they are for.
    fn unused(&self) -> Vec<String> {
        self.unused.clone()
    }

    /// Keys that would change forces, but belong to what is not modelled.
    fn ignored(&self) -> Vec<String> {
        self.ignored.clone()
    }

    /// Forces along x and y and moments about x, y and z of the road on a left or right tyre; the contact is load,
    /// longitudinal slip, side slip, camber and speed. The inflation pressure is that of the file if not given.
    fn wrench(&self, left: bool, contact: [f64; 5], pressure: Option<f64>) -> PyResult<[f64; 5]> {
        const NAMES: [&str; 5] = ["load", "longitudinal_slip", "side_slip", "camber", "speed"];
        if let Some((name, value)) = NAMES.iter().zip(contact).find(|(_, value)| !value.is_finite()) {
            return Err(refused(format!("{name} = {value}: must be finite")));
        }
        let [load, longitudinal_slip, side_slip, camber, speed] = contact;
        let contact = Contact { load, longitudinal_slip, side_slip, camber, speed };
        let side = if left { Side::Left } else { Side::Right };
        let Wrench { force_x, force_y, moment_x, moment_y, moment_z } = self.at(pressure)?.wrench_on(side, &contact);
        Ok([force_x, force_y, moment_x, moment_y, moment_z])
    }
}

impl Tyre {
    fn has_pressure(&self) -> bool {
        FormulaVersion::of(self.formula.version) == FormulaVersion::Six
    }

    /// The formula at an inflation pressure.
    fn at(&self, pressure: Option<f64>) -> PyResult<MagicFormula> {
        let Some(inflpres) = pressure else { return Ok(self.formula) };
        if !self.has_pressure() {
            return Err(refused("pressure: the tyre file is of Magic Formula 5.2, which has none"));
        }
        if !(inflpres > 0.0 && inflpres.is_finite()) {
            return Err(refused(format!("pressure = {inflpres}: must be > 0 and finite")));
        }
        Ok(MagicFormula { inflpres, ..self.formula })
    }
}
