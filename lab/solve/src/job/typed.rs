//! Options as a user types them into fields: what a text means follows from the type that is asked for.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::str::FromStr;

use serde::de::value::{MapDeserializer, SeqDeserializer, StrDeserializer};
use serde::de::{DeserializeOwned, Error, IntoDeserializer, Visitor};
use serde::{Deserializer, forward_to_deserialize_any};

use crate::system::Fault;

type Refused = serde::de::value::Error;

/// The job of options as texts: `true` or `false`, numbers, names; several separated by commas, entries as NAME=VALUE, ends
/// of a range as LOW:HIGH.
pub fn of_texts<T: DeserializeOwned>(texts: &BTreeMap<String, String>) -> Result<T, Fault> {
    let entry = |(name, text): (&String, &String)| (name.clone(), Typed { name: name.clone(), text: text.clone() });
    T::deserialize(MapDeserializer::new(texts.iter().map(entry))).map_err(Fault::value)
}

/// A text, and the name of what it is given for.
struct Typed {
    name: String,
    text: String,
}

impl Typed {
    fn part(&self, text: &str) -> Typed {
        Typed { name: self.name.clone(), text: text.trim().to_owned() }
    }

    fn parts(&self, mark: char) -> Vec<Typed> {
        self.text.split(mark).map(|text| self.part(text)).collect()
    }

    fn refused(&self, wanted: impl Display) -> Refused {
        Refused::custom(format_args!("{} = {}: must be {wanted}", self.name, self.text))
    }

    fn number<T: FromStr>(&self, wanted: &str) -> Result<T, Refused> {
        self.text.trim().parse().map_err(|_| self.refused(wanted))
    }
}

impl IntoDeserializer<'_, Refused> for Typed {
    type Deserializer = Typed;

    fn into_deserializer(self) -> Typed {
        self
    }
}

impl<'de> Deserializer<'de> for Typed {
    type Error = Refused;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_str(self.text.trim())
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_bool(self.number("true or false")?)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_f64(self.number("a number")?)
    }

    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_u64(self.number("a whole number >= 0")?)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_some(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        visitor.visit_seq(SeqDeserializer::new(self.parts(',').into_iter()))
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, count: usize, visitor: V) -> Result<V::Value, Refused> {
        let parts = self.parts(':');
        if parts.len() != count {
            return Err(self.refused("LOW:HIGH"));
        }
        visitor.visit_seq(SeqDeserializer::new(parts.into_iter()))
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refused> {
        let entry = |one: Typed| {
            let (name, value) = one.text.split_once('=').ok_or_else(|| one.refused("NAME=VALUE"))?;
            Ok((name.trim().to_owned(), Typed { name: name.trim().to_owned(), text: value.trim().to_owned() }))
        };
        let entries = self.parts(',').into_iter().map(entry).collect::<Result<Vec<(String, Typed)>, Refused>>()?;
        visitor.visit_map(MapDeserializer::new(entries.into_iter()))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        choices: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refused> {
        if !choices.contains(&self.text.trim()) {
            return Err(self.refused(format_args!("one of {}", choices.join(", "))));
        }
        visitor.visit_enum(StrDeserializer::new(self.text.trim()))
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u32 u128 f32 char str string bytes byte_buf unit unit_struct newtype_struct
        tuple_struct struct identifier ignored_any
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::Job;
    use super::super::{Entry, entries};
    use super::*;

    fn typed(name: &str, text: &str) -> Result<Job, String> {
        of_texts(&BTreeMap::from([(name.to_owned(), text.to_owned())])).map_err(|fault| fault.to_string())
    }

    #[test]
    fn a_text_is_read_as_what_is_asked_for() {
        assert_eq!(typed("law", "LuGre, Dahl").unwrap().law, ["LuGre", "Dahl"]);
        assert_eq!(typed("fix", "m=1, k = 2e3").unwrap().fix, [Entry("m".into(), 1.0), Entry("k".into(), 2e3)]);
        assert_eq!(typed("range", "s - k=0.1:1").unwrap().range, [Entry("s - k".into(), [0.1, 1.0])]);
        assert_eq!(typed("tol", " 1e-8").unwrap().tol, Some(1e-8));
        assert_eq!(typed("seed", "18446744073709551615").unwrap().seed, Some(u64::MAX));
        assert!(typed("axis", "true").unwrap().axis);
        assert!(entries(&typed("axis", "false").unwrap()).unwrap().is_empty());
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        for (name, text, expected) in [
            ("seed", "2.5", "seed = 2.5: must be a whole number >= 0"),
            ("tol", "low", "tol = low: must be a number"),
            ("axis", "yes", "axis = yes: must be true or false"),
            ("fix", "m", "fix = m: must be NAME=VALUE"),
            ("fix", "m=x", "m = x: must be a number"),
            ("range", "k=1", "k = 1: must be LOW:HIGH"),
            ("seeds", "1", "unknown field `seeds`, expected one of `law`, `fix`, `range`, `tol`, `seed`, `axis`"),
        ] {
            assert_eq!(typed(name, text).unwrap_err(), expected);
        }
    }
}
