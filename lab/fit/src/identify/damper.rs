//! A damper test as a user describes it, and what is found in it.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Args;
use serde::{Deserialize, Serialize};
use stribeck_sheet::{FORCE, SheetError, VELOCITY};
use stribeck_solve::job::{self, Entry};
use stribeck_solve::system::Fault;
use thiserror::Error;

use super::{Settings, StrutFriction, Watch, laws_named, strut_friction};
use crate::dyno::{Damper, DynoError, ForceSign, Options, Test, find_damper};

/// A damper test, and what is known of it.
#[derive(Args, Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields, default)]
pub struct Inquiry {
    /// Table with the columns velocity and force, optionally displacement and temperature; units in brackets
    pub record: Option<PathBuf>,
    /// Name of a column in the table: force=Kraft_1; in binary files (.mf4, .mat) that of a channel or variable
    #[arg(long, value_name = "NAME=COLUMN")]
    #[serde(with = "job::table")]
    pub column: Vec<Entry<String>>,
    /// Sheet of a spreadsheet (default: the first one with a table)
    #[arg(long, value_name = "NAME")]
    pub sheet: Option<String>,
    /// Number of points of the damper table, including 0: 3 to 16 (default: a curve of at most 16 points as it is, else
    /// 11)
    #[arg(long)]
    pub points: Option<usize>,
    /// Velocity and displacement in the file are positive in compression
    #[arg(long)]
    pub compression_positive: bool,
    /// Reject a file unless its force has this sign
    #[arg(long, value_enum)]
    pub force_sign: Option<ForceSign>,
    /// Speed below which samples distinguish friction from damping, in m/s (default: 0.05)
    #[arg(long)]
    pub low_speed: Option<f64>,
    /// Gas force in N, mean of both ends of the stroke; separates the friction of the two directions
    #[arg(long)]
    pub gas_force: Option<f64>,
    /// Friction law of the strut, fitted to the strokes below the low speed; the file needs a column time
    #[arg(long)]
    pub law: Option<String>,
    /// Seed of the search for its parameters (default: 1)
    #[arg(long)]
    pub seed: Option<u64>,
}

/// What was found in a damper test.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The test.
    pub test: Test,
    /// The damper.
    pub damper: Damper,
    /// The friction law of the strut, if one was asked for.
    pub friction: Option<StrutFriction>,
}

/// Reason why nothing was found.
#[derive(Debug, Error)]
pub enum DamperError {
    /// No damper was found.
    #[error(transparent)]
    Dyno(#[from] DynoError),
    /// No friction law was found, or the test is not described.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl Inquiry {
    /// The file of the test.
    pub fn file(&self) -> Result<&Path, Fault> {
        self.record.as_deref().ok_or_else(|| Fault::value("no record was given"))
    }

    fn options(&self) -> Options {
        let usual = Options::default();
        Options {
            compression_positive: self.compression_positive,
            force_sign: self.force_sign,
            points: self.points,
            low_speed: self.low_speed.unwrap_or(usual.low_speed),
            gas_force: self.gas_force,
            ..usual
        }
    }

    /// Finds the damper, and the friction law if one was asked for.
    pub fn answer(&self) -> Result<Answer, DamperError> {
        let columns: Vec<(String, String)> =
            self.column.iter().map(|Entry(name, column)| (name.clone(), column.clone())).collect();
        let (options, test) =
            (self.options(), Test::load(self.file()?, self.sheet.as_deref(), &columns).map_err(with_remedy)?);
        let damper = find_damper(&test, &options)?;
        let friction = self.law.as_deref().map(|law| self.friction(law, &test, &options)).transpose()?;
        let damper = friction.as_ref().map_or(damper, |friction| friction.damper.clone());
        Ok(Answer { test, damper, friction })
    }

    fn friction(&self, law: &str, test: &Test, options: &Options) -> Result<StrutFriction, Fault> {
        let [law] = laws_named(&[law.to_owned()])?[..] else {
            return Err(Fault::value(format_args!("law = {law}: must be one law")));
        };
        let usual = Settings::default();
        let task = Settings { seed: self.seed.unwrap_or(usual.seed), ..usual };
        let never = AtomicBool::new(false);
        strut_friction(law, test, options, &task, Watch { cancel: &never, progress: &|_, _| {} })
    }
}

/// An error about a test; how to name a column that was not found.
fn with_remedy(error: SheetError) -> DamperError {
    match &error {
        SheetError::Column { wanted, .. } if [VELOCITY, FORCE].iter().any(|known| known.name == wanted) => {
            Fault::value(format_args!("{error}; --column {wanted}=NAME names it")).into()
        }
        _ => DynoError::from(error).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_description_says_what_the_options_are() {
        let all = "record = \"a.csv\"\npoints = 7\ncompression_positive = true\nforce_sign = \"reaction\"\nlow_speed = 0.1\n\
                   gas_force = 90\nlaw = \"Dahl\"\nseed = 3\n[column]\nforce = \"Load\"";
        let Options { compression_positive, force_sign, points, low_speed, falling, gas_force } =
            toml::from_str::<Inquiry>(all).unwrap().options();
        assert_eq!((compression_positive, force_sign, points), (true, Some(ForceSign::Reaction), Some(7)));
        assert_eq!((low_speed, falling, gas_force), (0.1, 0.0, Some(90.0)));
        let refusal = |text: &str| toml::from_str::<Inquiry>(text).unwrap().answer().unwrap_err().to_string();
        assert_eq!(refusal(""), "no record was given");
        assert!(toml::from_str::<Inquiry>("axes = 1").is_err());
        let entry = Entry("force".to_owned(), "Load".to_owned());
        assert_eq!(toml::from_str::<Inquiry>(all).unwrap().column, [entry]);
    }
}
