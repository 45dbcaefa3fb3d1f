//! The communication step as a user writes it.

use std::fmt::{self, Formatter};
use std::str::FromStr;

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::system::Fault;

/// A communication step, or the wish to find the largest one with which co-simulation is close to the solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A step in s.
    Of(f64),
    /// The search for one.
    Find,
}

/// The word for a search.
const FIND: &str = "find";

impl FromStr for Step {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Step, Fault> {
        match text.parse() {
            Ok(step) => Ok(Step::Of(step)),
            Err(_) if text == FIND => Ok(Step::Find),
            Err(_) => Err(Fault::value(format_args!("step = {text}: must be a number of seconds, or {FIND}"))),
        }
    }
}

impl Serialize for Step {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Step::Of(step) => to.serialize_f64(*step),
            Step::Find => to.serialize_str(FIND),
        }
    }
}

struct NumberOrWord;

impl Visitor<'_> for NumberOrWord {
    type Value = Step;

    fn expecting(&self, to: &mut Formatter) -> fmt::Result {
        write!(to, "a number of seconds, or {FIND}")
    }

    fn visit_f64<E: Error>(self, step: f64) -> Result<Step, E> {
        Ok(Step::Of(step))
    }

    fn visit_i64<E: Error>(self, step: i64) -> Result<Step, E> {
        Ok(Step::Of(step as f64))
    }

    fn visit_u64<E: Error>(self, step: u64) -> Result<Step, E> {
        Ok(Step::Of(step as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Step, E> {
        text.parse().map_err(E::custom)
    }
}

impl<'de> Deserialize<'de> for Step {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Step, D::Error> {
        from.deserialize_any(NumberOrWord)
    }
}
