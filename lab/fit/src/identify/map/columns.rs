//! Columns of a map.

use stribeck_measured::{MeasuredError, Movement, Setup, load};
use stribeck_sheet::{FORCE, Sheet, VELOCITY};

/// Columns of a map, in SI units.
pub(in crate::identify) struct MapColumns {
    pub movement: Movement,
    pub velocity: Vec<f64>,
    pub force: Vec<f64>,
    pub normal_force: Vec<f64>,
}

impl MapColumns {
    /// Reads a table whose columns have the names of their quantities.
    pub fn of(table: &Sheet, setup: &Setup, movement: Movement) -> Result<MapColumns, MeasuredError> {
        Ok(MapColumns {
            movement,
            velocity: table.required(VELOCITY.name, &movement.quantity(&VELOCITY))?,
            force: table.required(FORCE.name, &movement.quantity(&FORCE))?,
            normal_force: load(table, setup, movement)?,
        })
    }
}
