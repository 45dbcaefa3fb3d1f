//! Reads the table of a damper test.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// A damper test in SI units, with the signs of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Test {
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Force, N.
    pub force: Vec<f64>,
    /// Displacement, m.
    pub displacement: Option<Vec<f64>>,
    /// Temperature, K.
    pub temperature: Option<Vec<f64>>,
}

/// Reason why a file is not a damper test.
#[derive(Debug, Error)]
pub enum FileError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The rows of the table do not fit its heading.
    #[error("no table: {0}")]
    Table(#[from] csv::Error),
    /// A required column is missing.
    #[error("no column '{wanted}'; there are {found}")]
    Column {
        /// The column.
        wanted: &'static str,
        /// The headings of the file.
        found: String,
    },
    /// Two columns have the same name.
    #[error("two columns '{0}'")]
    Twice(&'static str),
    /// The unit in a heading is not known.
    #[error("{column}: unit '{unit}', must be one of {wanted}")]
    Unit {
        /// The column.
        column: &'static str,
        /// Its text.
        unit: String,
        /// The units that are known.
        wanted: String,
    },
    /// A cell is not a finite number.
    #[error("line {line}, {column}: '{text}' is not a finite number")]
    Number {
        /// Line of the file.
        line: u64,
        /// The column.
        column: &'static str,
        /// Its text.
        text: String,
    },
    /// The table has no rows.
    #[error("the table has no rows")]
    Empty,
}

/// A quantity, with its possible units in files: SI value = factor (value + offset). The first unit is the SI one.
struct Quantity {
    name: &'static str,
    units: &'static [(&'static str, f64, f64)],
}

const VELOCITY: Quantity =
    Quantity { name: "velocity", units: &[("m/s", 1.0, 0.0), ("mm/s", 1e-3, 0.0), ("in/s", 0.0254, 0.0)] };
const FORCE: Quantity =
    Quantity { name: "force", units: &[("N", 1.0, 0.0), ("kN", 1e3, 0.0), ("lbf", 4.448_221_615_260_5, 0.0)] };
const DISPLACEMENT: Quantity =
    Quantity { name: "displacement", units: &[("m", 1.0, 0.0), ("mm", 1e-3, 0.0), ("in", 0.0254, 0.0)] };
const TEMPERATURE: Quantity = Quantity {
    name: "temperature",
    units: &[("K", 1.0, 0.0), ("degC", 1.0, 273.15), ("C", 1.0, 273.15), ("degF", 5.0 / 9.0, 459.67)],
};

/// A required column of the file.
struct Column {
    at: usize,
    name: &'static str,
    factor: f64,
    offset: f64,
}

impl Test {
    /// Reads a file.
    pub fn load(path: &Path) -> Result<Test, FileError> {
        let bytes = fs::read(path).map_err(|source| FileError::Unreadable { path: path.into(), source })?;
        // Files of old programs are not UTF-8; the relevant parts are ASCII.
        Test::parse(&String::from_utf8_lossy(&bytes))
    }

    /// Reads a table: a heading that names the columns `velocity`, `force`, `displacement`, `temperature`, each with
    /// its unit in brackets if it is not the SI unit, then rows. Other columns are ignored. The separator (tab,
    /// semicolon or comma) is that of the heading; unless it is a comma, numbers may have a decimal comma. `#` begins a
    /// comment.
    ///
    /// ```
    /// let test = lab::dyno::Test::parse("velocity [mm/s];force [N]\n100;1,5\n-100;-2\n").unwrap();
    /// assert_eq!([test.velocity[0], test.force[0]], [0.1, 1.5]);
    /// ```
    pub fn parse(text: &str) -> Result<Test, FileError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let heading = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or_default();
        let separator = ['\t', ';'].into_iter().find(|mark| heading.contains(*mark)).unwrap_or(',');
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(separator as u8)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let names: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
        let find = |quantity: &Quantity| Column::find(&names, quantity);
        let must = |quantity: &Quantity| {
            let missing = || FileError::Column { wanted: quantity.name, found: names.join(", ") };
            find(quantity)?.ok_or_else(missing)
        };
        let [velocity, force] = [must(&VELOCITY)?, must(&FORCE)?];
        let [displacement, temperature] = [find(&DISPLACEMENT)?, find(&TEMPERATURE)?];
        let mut test = Test {
            displacement: displacement.is_some().then(Vec::new),
            temperature: temperature.is_some().then(Vec::new),
            ..Test::default()
        };
        for record in reader.records() {
            let record = record?;
            test.velocity.push(velocity.value(&record, separator)?);
            test.force.push(force.value(&record, separator)?);
            for (column, values) in [(&displacement, &mut test.displacement), (&temperature, &mut test.temperature)] {
                if let (Some(column), Some(values)) = (column, values) {
                    values.push(column.value(&record, separator)?);
                }
            }
        }
        if test.velocity.is_empty() { Err(FileError::Empty) } else { Ok(test) }
    }
}

impl Column {
    /// The column of a quantity, by the heading `name`, `name [unit]` or `name (unit)`.
    fn find(names: &[String], quantity: &Quantity) -> Result<Option<Column>, FileError> {
        let mut found = names.iter().enumerate().filter_map(|(at, heading)| {
            let (name, unit) = heading.split_once(['[', '(']).unwrap_or((heading, ""));
            name.trim().eq_ignore_ascii_case(quantity.name).then(|| (at, unit.trim_end_matches([']', ')'])))
        });
        let Some((at, unit)) = found.next() else { return Ok(None) };
        if found.next().is_some() {
            return Err(FileError::Twice(quantity.name));
        }
        // A degree sign is ignored, whatever its encoding.
        let unit: String = unit.chars().filter(|letter| letter.is_ascii() && !letter.is_whitespace()).collect();
        let known = quantity.units.iter().find(|known| unit.is_empty() || known.0 == unit);
        let Some((_, factor, offset)) = known else {
            let wanted: Vec<&str> = quantity.units.iter().map(|known| known.0).collect();
            return Err(FileError::Unit { column: quantity.name, unit, wanted: wanted.join(", ") });
        };
        Ok(Some(Column { at, name: quantity.name, factor: *factor, offset: *offset }))
    }

    /// The value in SI units.
    fn value(&self, record: &csv::StringRecord, separator: char) -> Result<f64, FileError> {
        let text = record.get(self.at).unwrap_or_default();
        let number = if separator == ',' { text.parse() } else { text.replace(',', ".").parse::<f64>() };
        match number {
            Ok(number) if number.is_finite() => Ok(self.factor * (number + self.offset)),
            _ => Err(FileError::Number {
                line: record.position().map_or(0, csv::Position::line),
                column: self.name,
                text: text.to_owned(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    fn refusal(text: &str) -> String {
        Test::parse(text).unwrap_err().to_string()
    }

    #[test]
    fn separators_decimal_commas_comments_and_marks_are_understood() {
        let wanted = Test {
            velocity: vec![0.1, -0.25],
            force: vec![150.5, -200.0],
            displacement: Some(vec![0.001, 0.002]),
            temperature: Some(vec![293.15, 313.15]),
        };
        for text in [
            "velocity,force,displacement,temperature\n0.1,150.5,0.001,293.15\n-0.25,-200,0.002,313.15\n",
            "\u{feff}# a test\n\nVelocity [mm/s]; force [kN]; displacement [mm]; temperature [degC]\n\
             # 1\n100;0,1505;1;20\n-250;-0,2;2;40\n",
            "time\ttemperature (\u{b0}C)\tforce [N]\tvelocity [m/s]\tdisplacement [mm]\r\n\
             0\t20\t150,5\t0,1\t1\r\n1\t40\t-2e2\t-0.25\t2\r\n",
        ] {
            let found = Test::parse(text).unwrap();
            let close = |a: &[f64], b: &[f64]| {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12 * b.abs())
            };
            assert!(close(&found.velocity, &wanted.velocity) && close(&found.force, &wanted.force), "{found:?}");
            assert!(close(found.displacement.as_ref().unwrap(), wanted.displacement.as_ref().unwrap()), "{found:?}");
            assert!(close(found.temperature.as_ref().unwrap(), wanted.temperature.as_ref().unwrap()), "{found:?}");
        }
    }

    #[test]
    fn american_units_are_converted() {
        let test =
            Test::parse("velocity [in/s],force [lbf],displacement [in],temperature [degF]\n10,100,1,68\n").unwrap();
        assert_abs_diff_eq!(test.velocity[0], 0.254, epsilon = 1e-15);
        assert_abs_diff_eq!(test.force[0], 444.822_161_526_05, epsilon = 1e-9);
        assert_abs_diff_eq!(test.displacement.unwrap()[0], 0.0254, epsilon = 1e-15);
        assert_abs_diff_eq!(test.temperature.unwrap()[0], 293.15, epsilon = 1e-9);
    }

    #[test]
    fn mistakes_are_rejected_with_their_place() {
        assert_eq!(refusal("speed,force\n1,2\n"), "no column 'velocity'; there are speed, force");
        assert_eq!(refusal(""), "no column 'velocity'; there are ");
        assert_eq!(refusal("velocity,force\n"), "the table has no rows");
        assert_eq!(refusal("velocity,force,velocity [mm/s]\n1,2,3\n"), "two columns 'velocity'");
        assert_eq!(refusal("velocity [km/h],force\n1,2\n"), "velocity: unit 'km/h', must be one of m/s, mm/s, in/s");
        assert_eq!(refusal("velocity,force\n1,2\n3,x\n"), "line 3, force: 'x' is not a finite number");
        assert_eq!(refusal("velocity;force\n1;\n"), "line 2, force: '' is not a finite number");
        assert_eq!(refusal("velocity,force\n1,inf\n"), "line 2, force: 'inf' is not a finite number");
        assert!(refusal("velocity,force\n1,5,2\n").starts_with("no table: "), "a decimal comma between commas");
        let absent = Test::load(Path::new("absent.csv")).unwrap_err().to_string();
        assert!(absent.starts_with("absent.csv: "), "{absent}");
    }

    #[test]
    fn files_in_old_encodings_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("latin.csv");
        fs::write(&path, b"velocity;force;temperature [\xb0C]\n1;2;20\n").unwrap();
        assert_eq!(Test::load(&path).unwrap().temperature, Some(vec![293.15]));
    }
}
