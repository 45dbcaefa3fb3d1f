//! Missing units in files, and contradictory quantities.

use crate::error::MeasuredError;
use crate::movement::Movement;
use crate::reduce::integral;
use stribeck_sheet::{DISPLACEMENT, Quantity, Sheet, SheetError, TIME, VELOCITY};

/// A note on the quantities without a unit in their file, which are assumed to be SI.
pub(crate) fn assumed(columns: &[(&Sheet, Quantity)]) -> Option<String> {
    let mut found: Vec<&Quantity> = Vec::new();
    for (table, quantity) in columns {
        if table.assumes_unit(quantity.name) && found.iter().all(|known| known.name != quantity.name) {
            found.push(quantity);
        }
    }
    let names: Vec<&str> = found.iter().map(|quantity| quantity.name).collect();
    let units: Vec<&str> = found.iter().map(|quantity| quantity.units[0].0).collect();
    (!found.is_empty()).then(|| format!("{}: no unit in the file, taken as {}", names.join(", "), units.join(", ")))
}

/// Ratios of the displacement to the integral of the velocity at which the two agree (chosen).
const CONSISTENT: [f64; 2] = [0.8, 1.2];

/// A note on which of displacement and velocity is used if a table has both; an error if they contradict each other.
pub(crate) fn motion(table: &Sheet, movement: Movement) -> Result<Option<String>, MeasuredError> {
    let column = |quantity: &'static Quantity| -> Result<Vec<f64>, SheetError> {
        table.required(quantity.name, &movement.quantity(quantity))
    };
    if [&TIME, &DISPLACEMENT, &VELOCITY].iter().any(|quantity| !table.has(quantity.name)) {
        return Ok(None);
    }
    let (time, displacement, velocity) = (column(&TIME)?, column(&DISPLACEMENT)?, column(&VELOCITY)?);
    let is_consistent = |factor: &f64| (CONSISTENT[0]..=CONSISTENT[1]).contains(factor) || !factor.is_finite();
    let factors = ratios(&time, &displacement, &velocity);
    if !factors.iter().any(is_consistent) {
        return Err(MeasuredError::Contradiction {
            factor: format!("{:.2e}", factors[0]).parse().unwrap_or(factors[0]),
        });
    }
    Ok(Some("displacement and velocity in the file: the velocity is taken as measured, not differentiated".to_owned()))
}

/// Slopes of the displacement over the integral of the velocity: as they are, and detrended, since the integral of a small
/// offset is a trend. Not finite for a motion that is 0.
fn ratios(time: &[f64], displacement: &[f64], velocity: &[f64]) -> [f64; 2] {
    if time.windows(2).any(|pair| pair[1] <= pair[0]) {
        return [f64::NAN; 2];
    }
    let [time, x, s] = [time, displacement, &integral(time, velocity)].map(centred);
    let without_trend = |values: &[f64]| {
        let slope = dot(values, &time) / dot(&time, &time);
        values.iter().zip(&time).map(|(value, time)| value - slope * time).collect::<Vec<f64>>()
    };
    let [bent_x, bent_s] = [&x, &s].map(|values| without_trend(values));
    let is_straight = dot(&bent_s, &bent_s) < STRAIGHT * dot(&s, &s);
    let plain = dot(&x, &s) / dot(&s, &s);
    [plain, if is_straight { plain } else { dot(&bent_x, &bent_s) / dot(&bent_s, &bent_s) }]
}

/// Detrended squares of a motion, relative to all of them, below which its speed is steady (chosen).
const STRAIGHT: f64 = 1e-4;

fn centred(values: &[f64]) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter().map(|value| value - mean).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A table of 0.1 m sin(t), with a velocity that is this many times as large and has an offset.
    fn table(heading: &str, factor: f64, offset: f64) -> Sheet {
        let rows = (0..2000).map(|k| 0.01 * f64::from(k));
        let rows = rows.map(|t| format!("{t},{},{}\n", 0.1 * t.sin(), factor * 0.1 * t.cos() + offset));
        Sheet::parse(&(heading.to_owned() + "\n" + &rows.collect::<String>())).unwrap()
    }

    #[test]
    fn a_velocity_of_another_unit_contradicts_the_displacement() {
        let heading = "time,displacement,velocity";
        let refused =
            |factor: f64| motion(&table(heading, factor, 0.0), Movement::Translation).unwrap_err().to_string();
        assert!(refused(1000.0).contains("changes by 0.001 times the integral of the velocity"), "{}", refused(1000.0));
        assert!(refused(-1.0).contains("by -1 times"), "{}", refused(-1.0));
        assert!(refused(1.3).contains("by 0.769") && refused(0.8).contains("by 1.25 times"), "{}", refused(1.3));
        let said =
            motion(&table("time,displacement,velocity [mm/s]", 1000.0, 0.0), Movement::Translation).unwrap().unwrap();
        assert!(said.contains("the velocity is taken as measured"), "{said}");
        // The integral of the offset is ten times as long as the strokes.
        for (factor, offset) in [(1.1, 0.0), (0.9, 0.0), (1.0, 0.1), (1.0, -0.1)] {
            assert!(motion(&table(heading, factor, offset), Movement::Translation).is_ok(), "{factor} {offset}");
        }
        assert!(motion(&table(heading, 1000.0, 10.0), Movement::Translation).is_err());
        assert_eq!(motion(&table("time,displacement,v", 1.0, 0.0), Movement::Translation).unwrap(), None);
    }

    #[test]
    fn a_motion_at_a_steady_speed_is_compared_as_it_is() {
        let of = |velocity: f64| {
            let rows = (0..100).map(|k| format!("{k},{},{velocity}\n", 0.01 * f64::from(k)));
            let text = "time,displacement,velocity\n".to_owned() + &rows.collect::<String>();
            motion(&Sheet::parse(&text).unwrap(), Movement::Translation)
        };
        assert!(of(0.01).is_ok() && of(10.0).is_err());
        assert!(of(0.0).is_ok(), "nothing can be said");
    }

    #[test]
    fn units_that_the_file_lacks_are_listed_in_one_note() {
        let sheet = Sheet::parse("time,force [kN],displacement\n1,2,3\n").unwrap();
        let all = [TIME, DISPLACEMENT, DISPLACEMENT, VELOCITY].map(|quantity| (&sheet, quantity));
        assert_eq!(assumed(&all).unwrap(), "time, displacement: no unit in the file, taken as s, m");
        let of_a_program = Sheet::of_columns(&[("time".into(), vec![1.0])]).unwrap();
        assert_eq!(assumed(&[(&of_a_program, TIME)]), None);
    }
}
