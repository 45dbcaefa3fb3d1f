//! The values of each sample.

use std::f64::consts::TAU;
use std::path::Path;

use stribeck::number::Real;
use stribeck_sheet::{of_file, table};

use super::description::{Description, Spread};
use crate::system::Fault;

/// The samples of a study.
#[derive(Debug)]
pub(super) struct Samples {
    count: usize,
    seed: u64,
    drawn: Vec<(String, Spread)>,
    /// Columns of a table.
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

/// Largest number of samples (chosen).
const MOST: usize = 1_000_000_000;

/// The number of samples: that which is given, or that of the rows of the table.
fn count(given: Option<usize>, rows: Option<usize>) -> Result<usize, Fault> {
    match (given, rows) {
        (Some(count), Some(rows)) if count != rows => {
            Err(Fault::value(format_args!("samples = {count}: the table has {rows} rows")))
        }
        (None, None) => Err(Fault::value("samples: must be given, or a table")),
        (given, rows) => match rows.or(given).unwrap_or_default() {
            count @ 1..=MOST => Ok(count),
            count => Err(Fault::value(format_args!("samples = {count}: must be from 1 to {MOST}"))),
        },
    }
}

impl Samples {
    pub fn of(description: &Description, folder: &Path) -> Result<Samples, Fault> {
        let (names, rows) = match &description.table {
            Some(name) => read(&folder.join(name))?,
            None => (Vec::new(), Vec::new()),
        };
        for (name, spread) in &description.vary {
            spread.check(name)?;
            if names.contains(name) {
                return Err(Fault::value(format_args!("{name}: is in the table and in vary")));
            }
        }
        let rows_of_table = description.table.is_some().then_some(rows.len());
        let count = count(description.samples, rows_of_table)?;
        let drawn = description.vary.iter().map(|(name, spread)| (name.clone(), *spread)).collect();
        Ok(Samples { count, seed: description.seed, drawn, names, rows })
    }

    pub fn len(&self) -> usize {
        self.count
    }

    /// Names of the values.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.drawn.iter().map(|(name, _)| name.as_str()).chain(self.names.iter().map(String::as_str))
    }

    /// The values of a sample. They depend on the seed and on its number alone, whoever runs it and when.
    pub fn row(&self, number: usize) -> Vec<f64> {
        // Neighbouring numbers and seeds lead to generators that have nothing in common.
        let start = fastrand::Rng::with_seed(self.seed).u64(..);
        let mut random = fastrand::Rng::with_seed(fastrand::Rng::with_seed(start ^ number as u64).u64(..));
        let drawn = self.drawn.iter().map(|(_, spread)| draw(*spread, &mut random));
        drawn.chain(self.rows.get(number).into_iter().flatten().copied()).collect()
    }

    /// The numbers of the table, as text: for the fingerprint of the study.
    pub fn text(&self) -> String {
        format!("{:?} {:?}", self.names, self.rows)
    }
}

fn draw(spread: Spread, random: &mut fastrand::Rng) -> f64 {
    match spread {
        Spread::Uniform([low, high]) => low + (high - low) * random.f64(),
        Spread::Log([low, high]) => {
            let [from, to] = [low, high].map(Real::ln);
            // Rounding must not lead out of the range.
            Real::exp(from + (to - from) * random.f64()).clamp(low, high)
        }
        Spread::Normal([mean, deviation]) => {
            // Box and Muller (1958); 1 - u is never 0.
            let radius = Real::sqrt(-2.0 * Real::ln(1.0 - random.f64()));
            mean + deviation * radius * Real::cos(TAU * random.f64())
        }
    }
}

/// Names and rows of a table.
fn read(path: &Path) -> Result<(Vec<String>, Vec<Vec<f64>>), Fault> {
    let wrong = |error: &dyn std::fmt::Display| Fault::File(of_file(path, error));
    let sheet = table(path, None).map_err(|error| wrong(&error))?;
    let names: Vec<String> = sheet.names().map(str::to_owned).collect();
    let column = |name: &String| match sheet.unit(name) {
        Some(unit) if !unit.is_empty() => {
            Err(wrong(&format_args!("{name} [{unit}]: must have no unit: the values are in SI units")))
        }
        _ => sheet.values(name, "").map_err(|error| wrong(&error)),
    };
    let columns = names.iter().map(column).collect::<Result<Vec<_>, Fault>>()?;
    Ok((names, (0..sheet.len()).map(|row| columns.iter().map(|column| column[row]).collect()).collect()))
}
