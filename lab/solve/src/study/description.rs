//! Studies as a user writes them.

use std::collections::BTreeMap;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use crate::run::Configuration;
use crate::system::Fault;

/// A study as it is written down.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Number of samples; as many as the table has, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<usize>,
    /// Seed of the random values.
    #[serde(default)]
    pub seed: u64,
    /// Results to keep: `max`, `min`, `mean` or `last` with the name of a result, or `events`.
    #[serde(default)]
    pub keep: Vec<String>,
    /// Values that are drawn, by the name of their variable.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty", deserialize_with = "spreads")]
    pub vary: BTreeMap<String, Spread>,
    /// CSV file with a column of values for each variable in its heading, and a row per sample.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<String>,
    /// The runs, as `stribeck run --save-config` writes them; several laws are run with the same samples.
    #[serde(default)]
    pub run: Configuration,
}

/// How a value is drawn.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Spread {
    /// Between two values, all equally likely.
    Uniform([f64; 2]),
    /// Between two positive values, their logarithms equally likely.
    Log([f64; 2]),
    /// Normal distribution: mean and standard deviation.
    Normal([f64; 2]),
}

/// The distributions by name. Anything else gets a clearer message than that
/// for an unknown variant of an enumeration.
fn spreads<'a, D: Deserializer<'a>>(all: D) -> Result<BTreeMap<String, Spread>, D::Error> {
    let spread = |(name, value): (String, toml::Value)| {
        if !value.is_table() {
            let text = "must be a distribution, such as { uniform = [0.1, 0.2] }";
            return Err(D::Error::custom(format_args!("{name} = {value}: {text}")));
        }
        let spread = Spread::deserialize(value);
        Ok((name.clone(), spread.map_err(|error| D::Error::custom(format_args!("{name}: {}", error.message())))?))
    };
    BTreeMap::<String, toml::Value>::deserialize(all)?.into_iter().map(spread).collect()
}

impl Spread {
    /// Refuses numbers that make no distribution.
    pub(super) fn check(self, name: &str) -> Result<(), Fault> {
        let (text, [a, b], fits) = match self {
            Spread::Uniform([low, high]) => {
                ("uniform: must be finite, and the first below the second", [low, high], low < high)
            }
            Spread::Log([low, high]) => {
                ("log: must be > 0, and the first below the second", [low, high], 0.0 < low && low < high)
            }
            Spread::Normal([mean, deviation]) => {
                ("normal: mean and standard deviation, which must be > 0", [mean, deviation], deviation > 0.0)
            }
        };
        if fits && a.is_finite() && b.is_finite() {
            Ok(())
        } else {
            Err(Fault::value(format_args!("vary.{name} = [{a}, {b}]: {text}")))
        }
    }
}
