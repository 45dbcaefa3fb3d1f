//! Reads the table of a damper test.

use std::path::Path;

use stribeck_sheet::{
    DISPLACEMENT, FORCE, Quantity, Sheet, SheetError, TEMPERATURE, TIME, VELOCITY, check_names, table,
};

/// Quantities of a test.
const QUANTITIES: [&Quantity; 5] = [&VELOCITY, &FORCE, &DISPLACEMENT, &TEMPERATURE, &TIME];

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
    /// Time, s.
    pub time: Option<Vec<f64>>,
    /// Note on how the file was read.
    pub note: Option<String>,
}

impl Test {
    /// Reads a file; of a spreadsheet the table of a sheet. `columns` are quantities with the columns that have them.
    pub fn load(path: &Path, sheet: Option<&str>, columns: &[(String, String)]) -> Result<Test, SheetError> {
        check_names(columns, &QUANTITIES)?;
        let mut table = table(path, sheet)?;
        for (name, column) in columns {
            if !table.has(column) {
                return Err(table.missing(column));
            }
            table.rename(column, name);
        }
        Test::of(&table)
    }

    /// Reads a [table](stribeck_sheet) with the columns `velocity`, `force`, and perhaps `displacement`, `temperature`
    /// and `time`.
    ///
    /// ```
    /// let test = stribeck_fit::dyno::Test::parse("velocity [mm/s];force [N]\n100;1,5\n-100;-2\n").unwrap();
    /// assert_eq!([test.velocity[0], test.force[0]], [0.1, 1.5]);
    /// ```
    pub fn parse(text: &str) -> Result<Test, SheetError> {
        Test::of(&Sheet::parse(text)?)
    }

    fn of(sheet: &Sheet) -> Result<Test, SheetError> {
        let [velocity, force] = [VELOCITY, FORCE].map(|quantity| sheet.required(quantity.name, &quantity));
        let test = Test {
            velocity: velocity?,
            force: force?,
            displacement: sheet.column(&DISPLACEMENT)?,
            temperature: sheet.column(&TEMPERATURE)?,
            time: sheet.column(&TIME)?,
            note: sheet.note().map(str::to_owned),
        };
        if sheet.is_empty() { Err(SheetError::Empty) } else { Ok(test) }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

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
            ..Test::default()
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
        assert_eq!(refusal(""), "no column 'velocity'; there are no columns");
        assert_eq!(refusal("velocity,force\n"), "the table has no rows");
        assert_eq!(refusal("velocity,force,velocity [mm/s]\n1,2,3\n"), "two columns 'velocity'");
        assert_eq!(
            refusal("velocity [kn],force\n1,2\n"),
            "velocity: unit 'kn', must be one of m/s, mm/s, in/s, km/h, kph, mph"
        );
        assert_eq!(refusal("velocity,force\n1,2\n3,x\n"), "line 3, force: 'x' is not a finite number");
        assert_eq!(refusal("velocity;force\n1;\n"), "line 2, force: '' is not a finite number");
        assert_eq!(refusal("velocity,force\n1,inf\n"), "line 2, force: 'inf' is not a finite number");
        assert!(refusal("velocity,force\n1,5,2\n").starts_with("no table: "), "a decimal comma between commas");
        let absent = Test::load(Path::new("absent.csv"), None, &[]).unwrap_err().to_string();
        assert!(absent.starts_with("absent.csv: "), "{absent}");
    }

    #[test]
    fn files_in_old_encodings_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("latin.csv");
        fs::write(&path, b"velocity;force;temperature [\xb0C]\n1;2;20\n").unwrap();
        assert_eq!(Test::load(&path, None, &[]).unwrap().temperature, Some(vec![293.15]));
    }

    /// Also a column that has a name of its own, which another one of the file has.
    #[test]
    fn columns_may_have_any_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("named.csv");
        fs::write(&path, "v1 [mm/s],Load [kN],force [N],Stroke [mm]\n100,0.5,7,2\n").unwrap();
        let load = |columns: &[(&str, &str)]| {
            let columns: Vec<_> = columns.iter().map(|(name, column)| ((*name).into(), (*column).into())).collect();
            Test::load(&path, None, &columns)
        };
        let test = load(&[("velocity", "v1"), ("force", "Load"), ("displacement", "stroke")]).unwrap();
        assert_eq!((test.velocity, test.force, test.displacement), (vec![0.1], vec![500.0], Some(vec![2e-3])));
        for (columns, expected) in [
            (&[("velocity", "v2")][..], "no column 'v2'; there are v1, Load, force, Stroke"),
            (&[("normal_force", "Load")], "quantity 'normal_force': must be one of velocity, force, displacement, "),
            (&[("force", "Load"), ("force", "v1")], "column force = v1: force is Load already"),
            (&[("velocity", "Load")], "velocity: unit 'kN', must be one of m/s, "),
        ] {
            let refused = load(columns).unwrap_err().to_string();
            assert!(refused.starts_with(expected), "{refused}");
        }
    }
}
