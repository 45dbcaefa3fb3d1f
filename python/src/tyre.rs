//! The tyre of a tyre property file.

use std::path::PathBuf;

use pyo3::prelude::*;
use stribeck::host::{Contact, FormulaVersion, MagicFormula, Radii, Rolling, Side, Wrench};
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
        let contact = contact_of(contact)?;
        let Wrench { force_x, force_y, moment_x, moment_y, moment_z } =
            self.at(pressure)?.wrench_on(side(left), &contact);
        Ok([force_x, force_y, moment_x, moment_y, moment_z])
    }

    /// Free, loaded and effective radius and the deflection of a left or right tyre; the contact is that of `wrench`.
    /// The effective radius is none if the file does not tell it.
    fn radii(&self, left: bool, contact: [f64; 5], pressure: Option<f64>) -> PyResult<(f64, f64, Option<f64>, f64)> {
        let contact = contact_of(contact)?;
        let (formula, stiffness) = (self.at(pressure)?, self.spring()?);
        let wrench = formula.wrench_on(side(left), &contact);
        let Radii { free, loaded, effective, deflection } = formula
            .checked_radii_on(side(left), stiffness, &contact, &wrench)
            .map_err(|why| refused(format!("load = {}: {why}", contact.load)))?;
        let is_told = formula.spring.dreff != 0.0 || formula.spring.freff != 0.0;
        Ok((free, loaded, is_told.then_some(effective), deflection))
    }

    /// Load of a left or right tyre; the state is loaded radius, forces along x and y, camber and spin.
    fn load(&self, left: bool, state: [f64; 5], pressure: Option<f64>) -> PyResult<f64> {
        all_finite(["loaded_radius", "force_x", "force_y", "camber", "spin"], state)?;
        let [loaded_radius, force_x, force_y, camber, spin] = state;
        let rolling = Rolling { force_x, force_y, camber, spin };
        let load = self.at(pressure)?.load_on(side(left), self.spring()?, &rolling, loaded_radius);
        if load.is_finite() {
            Ok(load)
        } else {
            Err(refused(format!("loaded_radius = {loaded_radius}: load = {load}")))
        }
    }
}

fn side(left: bool) -> Side {
    if left { Side::Left } else { Side::Right }
}

/// The contact, which must be finite.
fn contact_of(contact: [f64; 5]) -> PyResult<Contact> {
    all_finite(["load", "longitudinal_slip", "side_slip", "camber", "speed"], contact)?;
    let [load, longitudinal_slip, side_slip, camber, speed] = contact;
    Ok(Contact { load, longitudinal_slip, side_slip, camber, speed })
}

fn all_finite(names: [&str; 5], values: [f64; 5]) -> PyResult<()> {
    match names.iter().zip(values).find(|(_, value)| !value.is_finite()) {
        Some((name, value)) => Err(refused(format!("{name} = {value}: must be finite"))),
        None => Ok(()),
    }
}

impl Tyre {
    fn has_pressure(&self) -> bool {
        FormulaVersion::of(self.formula.version) == FormulaVersion::Six
    }

    /// The vertical stiffness, without which a tyre has no deflection.
    fn spring(&self) -> PyResult<f64> {
        self.stiffness
            .ok_or_else(|| refused("the tyre file gives no VERTICAL_STIFFNESS: no deflection follows from a load"))
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
