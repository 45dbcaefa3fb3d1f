//! Bonds of laws that snap within the steps of a solver.

use stribeck::model::{Meaning, ModelType};

use super::Place;
use super::mover::Mover;
use super::part::System;
use super::wiring::Rows;
use crate::solve::Track;

/// The bonds of a part as the solver follows them. One state, the strain of the first bond, stands for all strains.
pub(super) struct Bundle {
    /// The part.
    pub part: usize,
    /// Columns of the strains of the bonds in use.
    pub strains: Vec<usize>,
}

impl Bundle {
    /// Whether a state of a part with bonds moves with them: all do but the strain of the first one.
    pub fn carries(model: &ModelType, row: &[f64], column: usize) -> bool {
        model.bonds(row).is_some() && strains(model).next() != Some(column)
    }

    /// The variables that move with the states.
    pub fn places(&self) -> impl Iterator<Item = Place> + '_ {
        self.strains.iter().map(|column| Place { part: self.part, column: *column })
    }

    /// Lets the strains follow the state.
    pub fn put(&self, track: &Track, state: f64, mover: &Mover, rows: &mut Rows) {
        mover.model.put_bonds(rows.of_mut(mover), &track.bonds, state - track.bonds.first());
    }

    /// Takes the bonds from the row after an event.
    pub fn take(&self, track: &mut Track, mover: &Mover, rows: &Rows) {
        if let Some(bonds) = mover.model.bonds(rows.of(mover)) {
            track.bonds = bonds;
        }
    }

    /// Takes the bonds from the row after a step, and its work as energy.
    pub fn renew(&self, track: &mut Track, mover: &Mover, rows: &Rows) {
        if let Some(bonds) = mover.model.bonds(rows.of(mover)) {
            track.bonds = track.bonds.renewed(bonds);
        }
    }
}

/// Columns of the strains of all bonds.
fn strains(model: &ModelType) -> impl Iterator<Item = usize> {
    let table = model.table;
    (0..table.len()).filter(move |column| table.at(*column).meaning == Meaning::Strain)
}

/// The bonds of a system that integrates these states.
pub(super) fn bundles(system: &System, states: &[Place]) -> Vec<(Bundle, Track)> {
    let mut bundles = Vec::new();
    for (part, made) in system.parts.iter().enumerate() {
        let Some(bonds) = made.model.bonds(&made.row) else { continue };
        let strains: Vec<usize> = strains(made.model).take(bonds.iter().count()).collect();
        if let Some(state) = states.iter().position(|place| place.part == part && strains.contains(&place.column)) {
            bundles.push((Bundle { part, strains }, Track { state, bonds }));
        }
    }
    bundles
}
