//! What lies between the columns of a drive and its joint: the torque constant of the motor, and a gear.
//!
//! # Equations
//! With the current i of the motor, its torque constant K, and the turns N of the motor for one of the joint:
//!
//! ```text
//! torque of the joint = N K i,   angle of the joint = angle of the motor / N
//! ```

use crate::error::MeasuredError;
use stribeck_sheet::{DISPLACEMENT, FORCE, Quantity, VELOCITY};

/// Motor and gear of a joint.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drive {
    /// Torque constant of the motor whose current is in the column of the force, N m/A.
    pub torque_constant: Option<f64>,
    /// Turns of the motor for one of the joint.
    pub gear_ratio: Option<f64>,
    /// Quantities whose columns are of the motor, before the gear; by default the force.
    pub motor_side: Vec<String>,
}

/// Quantities that a gear converts.
const GEARED: [&Quantity; 3] = [&FORCE, &DISPLACEMENT, &VELOCITY];

impl Drive {
    /// Whether there is one.
    pub fn is_known(&self) -> bool {
        self.torque_constant.is_some() || self.gear_ratio.is_some()
    }

    /// Rejects values that are 0 or not finite, and columns of the motor that there are not.
    pub(crate) fn check(&self) -> Result<(), MeasuredError> {
        let values =
            [("torque_constant", self.torque_constant, "N m/A"), ("gear_ratio", self.gear_ratio, "turns per turn")];
        for (name, value, unit) in values {
            if let Some(value) = value.filter(|value| !(value.is_finite() && *value != 0.0)) {
                return Err(MeasuredError::Setup { name, value, wanted: format!("finite and not 0, in {unit}") });
            }
        }
        let is_geared = |name: &String| GEARED.iter().any(|known| known.name == name);
        match self.motor_side.iter().find(|name| !is_geared(name)) {
            Some(name) => {
                Err(MeasuredError::MotorSide { name: name.clone(), wanted: "force, displacement or velocity" })
            }
            None if self.gear_ratio.is_none() && !self.motor_side.is_empty() => {
                Err(MeasuredError::MotorSide { name: self.motor_side.join(", "), wanted: "given with gear_ratio" })
            }
            None => Ok(()),
        }
    }

    /// Factor of a column; None if it is that of the joint.
    pub(crate) fn factor(&self, name: &str) -> Option<f64> {
        let is_force = name == FORCE.name;
        let is_geared =
            if self.motor_side.is_empty() { is_force } else { self.motor_side.iter().any(|one| one == name) };
        let gear = self.gear_ratio.filter(|_| is_geared).map(|ratio| if is_force { ratio } else { 1.0 / ratio });
        let constant = self.torque_constant.filter(|_| is_force);
        if gear.is_none() && constant.is_none() { None } else { Some(gear.unwrap_or(1.0) * constant.unwrap_or(1.0)) }
    }
}
