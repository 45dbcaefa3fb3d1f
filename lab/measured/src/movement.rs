//! Whether a body slides or turns, and the units of either.
//!
//! Computations do not distinguish them: the torque of a joint stands in place of the force, its angle in place of the
//! displacement, its moment of inertia in place of the mass. Only the units that are read and shown differ.

use serde::Serialize;
use ts_rs::TS;

use crate::error::MeasuredError;
use stribeck_sheet::{ANGLE, ANGULAR_VELOCITY, DISPLACEMENT, FORCE, MOMENT, Quantity, SLIP, Sheet, VELOCITY};

/// Movement of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Movement {
    /// It slides: N, m, kg.
    #[default]
    Translation,
    /// It turns: N.m, rad, kg.m2.
    Rotation,
}

/// Units of a record and of what is fitted to it.
#[derive(Clone, Copy, Debug, Serialize, TS)]
pub struct Units {
    /// Of a force or torque.
    pub force: &'static str,
    /// Of a displacement or angle.
    pub displacement: &'static str,
    /// Of a velocity.
    pub velocity: &'static str,
}

/// Quantities of a record that tell a movement by their units.
const TELLING: [&Quantity; 3] = [&FORCE, &DISPLACEMENT, &VELOCITY];

/// Units of a body that slides, and those in their place for one that turns.
const UNITS: [(&str, &str); 24] = [
    ("N", "N.m"),
    ("m", "rad"),
    ("m/s", "rad/s"),
    ("m/s2", "rad/s2"),
    ("kg", "kg.m2"),
    ("N/m", "N.m/rad"),
    ("N.s/m", "N.m.s/rad"),
    ("N.s2/m2", "N.m.s2/rad2"),
    ("N/m2", "N.m/rad2"),
    ("N/m3", "N.m/rad3"),
    ("N/s", "N.m/s"),
    ("s/m", "s/rad"),
    ("1", "1"),
    ("s", "s"),
    ("1/s", "1/s"),
    ("J", "J"),
    ("K", "K"),
    ("1/K", "1/K"),
    ("V", "V"),
    ("rad", "rad"),
    ("1/N", "1/(N.m)"),
    ("1/m2", "1/rad2"),
    ("N/(m.V)", "N.m/(rad.V)"),
    ("N.s/(m.V)", "N.m.s/(rad.V)"),
];

impl Movement {
    /// The unit in place of one of a body that slides.
    pub fn unit(self, of_translation: &'static str) -> &'static str {
        let turned = UNITS.iter().find(|(unit, _)| *unit == of_translation).map(|(_, turned)| *turned);
        if self == Movement::Rotation { turned.unwrap_or(of_translation) } else { of_translation }
    }

    /// The units of a record.
    pub fn units(self) -> Units {
        let [force, displacement, velocity] = TELLING.map(|quantity| self.unit(quantity.units[0].0));
        Units { force, displacement, velocity }
    }

    /// Mass or moment of inertia, in words.
    pub fn inertia(self) -> &'static str {
        if self == Movement::Rotation { "moment of inertia" } else { "mass" }
    }

    /// Force or torque, in words.
    pub fn force(self) -> &'static str {
        if self == Movement::Rotation { "torque" } else { "force" }
    }

    /// A name with its unit in brackets.
    pub fn heading(self, name: &str, of_translation: &'static str) -> String {
        format!("{name} [{}]", self.unit(of_translation))
    }

    /// The quantity in place of one of a body that slides.
    pub fn quantity(self, of_translation: &Quantity) -> Quantity {
        let turned = Quantity::of(of_translation.name, self.unit(of_translation.units[0].0));
        turned.filter(|_| self == Movement::Rotation).unwrap_or(*of_translation)
    }

    /// Quantities of signals, which a factor converts: the torque of a drive, its angle, its current in percent; for a
    /// body that turns, the force at a lever, and the way of a rope.
    pub(crate) fn signals(self) -> [&'static Quantity; 4] {
        match self {
            Movement::Translation => [&ANGLE, &SLIP, &MOMENT, &ANGULAR_VELOCITY],
            Movement::Rotation => [&FORCE, &SLIP, &DISPLACEMENT, &VELOCITY],
        }
    }

    /// Movement of a record, by the units of its force and its motion; columns without a unit take that of the others.
    pub(crate) fn of(record: &Sheet, motion: Option<&Sheet>) -> Result<Movement, MeasuredError> {
        let told = Movement::told(&[record], &motion.into_iter().collect::<Vec<_>>(), |_| true)?;
        Ok(told.map_or(Movement::Translation, |(movement, _)| movement))
    }

    /// The movement that units tell, with the first column that does. `motion` has the motion if that is apart; `tells` is
    /// whether the unit of a quantity counts.
    pub(crate) fn told(
        record: &[&Sheet],
        motion: &[&Sheet],
        tells: impl Fn(&Quantity) -> bool,
    ) -> Result<Option<(Movement, String)>, MeasuredError> {
        let moving = if motion.is_empty() { record } else { motion };
        let mut known: Option<(Movement, String)> = None;
        for quantity in TELLING.into_iter().filter(|quantity| tells(quantity)) {
            let tables = if quantity.name == FORCE.name { record } else { moving };
            for (movement, column) in tables.iter().filter_map(|table| told(table, quantity)) {
                match &known {
                    Some((other, first)) if *other != movement => {
                        return Err(MeasuredError::Mixture { first: first.clone(), second: column });
                    }
                    Some(_) => {}
                    None => known = Some((movement, column)),
                }
            }
        }
        Ok(known)
    }
}

/// The movement that the unit of a column tells, and the column with its unit.
fn told(table: &Sheet, quantity: &'static Quantity) -> Option<(Movement, String)> {
    let unit = table.unit(quantity.name)?;
    let has = |movement: &Movement| movement.quantity(quantity).units.iter().any(|known| known.0 == unit);
    let movement = [Movement::Translation, Movement::Rotation].into_iter().find(has)?;
    Some((movement, format!("{} [{unit}]", table.own_name(quantity.name))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_of_both_movements_have_their_units() {
        for quantity in TELLING {
            let turned = Movement::Rotation.quantity(quantity);
            assert_eq!((turned.name, turned.units[0].0), (quantity.name, Movement::Rotation.unit(quantity.units[0].0)));
        }
    }

    #[test]
    fn units_tell_a_movement_and_are_not_mixed() {
        let told = |text: &str| {
            let sheet = Sheet::parse(text).unwrap();
            Movement::of(&sheet, None).map_err(|error| error.to_string())
        };
        for text in ["force [N],displacement\n1,2\n", "force,velocity [mm/s]\n1,2\n", "force,velocity\n1,2\n"] {
            assert_eq!(told(text), Ok(Movement::Translation), "{text}");
        }
        for text in [
            "force [N m],displacement\n1,2\n",
            "force,displacement [\u{b0}]\n1,2\n",
            "force,velocity [rpm]\n1,2\n",
            "force [N cm],velocity [deg/s],displacement [rev]\n1,2,3\n",
        ] {
            assert_eq!(told(text), Ok(Movement::Rotation), "{text}");
        }
        let mut sheet = Sheet::parse("force [kN],displacement,speed [rpm]\n1,2,3\n").unwrap();
        sheet.rename("speed", "velocity");
        let refusal = Movement::of(&sheet, None).unwrap_err().to_string();
        assert!(refusal.starts_with("force [kN] and speed [rpm]: one is of a body that slides"), "{refusal}");
        // The force of one table and the motion of another; what else the first one has does not matter.
        let [force, motion] = ["force [Nm],displacement [m]\n1,2\n", "displacement [deg]\n1\n"].map(Sheet::parse);
        let movement = Movement::of(&force.unwrap(), Some(&motion.unwrap())).unwrap();
        assert_eq!(movement, Movement::Rotation);
    }
}
