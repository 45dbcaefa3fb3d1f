//! Descriptions of jobs as users write them: on the command line, in a TOML file, in Python.
//!
//! A job is a struct of plain data. What was not given is empty, None or false in it, and is left out of its texts.

mod typed;

use std::borrow::Cow;
use std::fmt::{Formatter, Write};
use std::marker::PhantomData;
use std::path::PathBuf;
use std::str::FromStr;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{DeserializeOwned, Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use toml::{Table, Value};
use ts_rs::TS;

pub use typed::of_texts;

use crate::system::Fault;

/// A name with what is given for it: NAME=VALUE on the command line, an entry of a table elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<T>(pub String, pub T);

/// A value as the command line spells it.
pub trait Spelled: Sized {
    /// The value of an entry.
    fn spelled(name: &str, text: &str) -> Result<Self, Fault>;
}

impl Spelled for String {
    fn spelled(_: &str, text: &str) -> Result<String, Fault> {
        Ok(text.to_owned())
    }
}

impl Spelled for f64 {
    fn spelled(name: &str, text: &str) -> Result<f64, Fault> {
        text.parse().map_err(|_| Fault::value(format_args!("{name} = {text}: must be a number")))
    }
}

/// Both ends of a range: LOW:HIGH.
impl Spelled for [f64; 2] {
    fn spelled(name: &str, text: &str) -> Result<[f64; 2], Fault> {
        let numbers = text.split_once(':').map(|ends| [ends.0, ends.1].map(|end| end.trim().parse::<f64>()));
        match numbers {
            Some([Ok(low), Ok(high)]) => Ok([low, high]),
            _ => Err(Fault::value(format_args!("{name} = {text}: must be LOW:HIGH"))),
        }
    }
}

impl<T: Spelled> FromStr for Entry<T> {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Entry<T>, Fault> {
        let wrong = || Fault::value(format_args!("'{text}': must be NAME=VALUE"));
        let (name, value) = text.split_once('=').ok_or_else(wrong)?;
        let name = name.trim().to_owned();
        let value = T::spelled(&name, value.trim())?;
        Ok(Entry(name, value))
    }
}

/// Entries as a table, for `#[serde(with)]`.
pub mod table {
    use super::{Deserialize, Deserializer, Entry, Formatter, MapAccess, PhantomData, Serialize, Serializer, Visitor};

    /// Writes a table.
    pub fn serialize<T: Serialize, S: Serializer>(entries: &[Entry<T>], to: S) -> Result<S::Ok, S::Error> {
        to.collect_map(entries.iter().map(|Entry(name, value)| (name, value)))
    }

    struct Entries<T>(PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for Entries<T> {
        type Value = Vec<Entry<T>>;

        fn expecting(&self, to: &mut Formatter) -> std::fmt::Result {
            to.write_str("a table of names and values")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Vec<Entry<T>>, A::Error> {
            let mut entries = Vec::new();
            while let Some((name, value)) = map.next_entry()? {
                entries.push(Entry(name, value));
            }
            Ok(entries)
        }
    }

    /// Reads a table.
    pub fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(from: D) -> Result<Vec<Entry<T>>, D::Error> {
        from.deserialize_map(Entries(PhantomData))
    }
}

struct OneOrMore<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de> + From<String>> Visitor<'de> for OneOrMore<T> {
    type Value = Vec<T>;

    fn expecting(&self, to: &mut Formatter) -> std::fmt::Result {
        to.write_str("a name or a list of names")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Vec<T>, E> {
        Ok(vec![T::from(text.to_owned())])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Vec<T>, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items))
    }
}

/// Names of which a single one needs no list, for `#[serde(deserialize_with)]`.
pub fn names<'de, T: Deserialize<'de> + From<String>, D: Deserializer<'de>>(from: D) -> Result<Vec<T>, D::Error> {
    from.deserialize_seq(OneOrMore(PhantomData))
}

/// An option of a job.
#[derive(Clone, Debug, PartialEq, Serialize, TS)]
pub struct Choice {
    /// Its name.
    pub name: String,
    /// What it does.
    pub help: String,
    /// What it may be; empty if that is not one of a few words.
    pub choices: Vec<String>,
    /// Whether it is there or not, and has no value.
    pub is_flag: bool,
}

/// The options of a job.
pub fn options<T: clap::Args>() -> Vec<Choice> {
    let option = |option: &clap::Arg| {
        let is_flag = !option.get_action().takes_values();
        let choices = if is_flag { Vec::new() } else { option.get_possible_values() };
        Choice {
            name: option.get_id().to_string(),
            help: option.get_long_help().or(option.get_help()).map_or(String::new(), ToString::to_string),
            choices: choices.iter().map(|choice| choice.get_name().to_owned()).collect(),
            is_flag,
        }
    };
    T::augment_args(clap::Command::new("job")).get_arguments().map(option).collect()
}

/// The job that a value describes; an error names the entry.
pub fn of_value<T: DeserializeOwned>(value: Value) -> Result<T, Fault> {
    value.try_into().map_err(|error: toml::de::Error| Fault::value(error.to_string().trim().replace('\n', " ")))
}

/// What was given, by name.
pub fn entries<T: Serialize>(job: &T) -> Result<Table, Fault> {
    let mut all = Table::try_from(job).map_err(Fault::value)?;
    all.retain(|_, value| match value {
        Value::Array(items) => !items.is_empty(),
        Value::Table(entries) => !entries.is_empty(),
        Value::Boolean(is_given) => *is_given,
        _ => true,
    });
    Ok(all)
}

/// The job of a file with what is given besides, which takes precedence: tables entry by entry, all else as a whole.
pub fn given_over<T: Serialize + DeserializeOwned>(given: &T, file: &T) -> Result<T, Fault> {
    let mut all = entries(file)?;
    for (name, value) in entries(given)? {
        match (all.get_mut(&name), value) {
            (Some(Value::Table(known)), Value::Table(given)) => known.extend(given),
            (_, value) => {
                all.insert(name, value);
            }
        }
    }
    of_value(Value::Table(all))
}

/// The job as the text of a file.
pub fn text<T: Serialize>(job: &T) -> Result<String, Fault> {
    toml::to_string(&entries(job)?).map_err(Fault::value)
}

/// Entries as arguments of a command line, after what stands before them.
pub fn command_line(begin: &[&str], entries: &Table) -> Result<String, Fault> {
    let mut words: Vec<String> = begin.iter().map(|word| (*word).to_owned()).collect();
    for (name, value) in entries {
        let option = format!("--{}", name.replace('_', "-"));
        let values = match value {
            Value::Boolean(_) => {
                words.push(option);
                continue;
            }
            Value::Array(items) => items.iter().map(word).collect(),
            Value::Table(entries) => entries.iter().map(|(name, value)| format!("{name}={}", word(value))).collect(),
            one => vec![word(one)],
        };
        words.extend(values.into_iter().flat_map(|value| [option.clone(), value]));
    }
    let quoted = words.iter().map(|word| quoted_word(word)).collect::<Result<Vec<Cow<str>>, Fault>>()?;
    Ok(quoted.join(" "))
}

/// A word with quotes only where every shell would need some.
fn quoted_word(word: &str) -> Result<Cow<'_, str>, Fault> {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "_-+=.,:/".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) {
        Ok(word.into())
    } else {
        shlex::try_quote(word).map_err(Fault::value)
    }
}

/// A value as a word of a command line.
fn word(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Float(number) => format!("{number:?}"),
        Value::Array(items) => items.iter().map(word).collect::<Vec<String>>().join(":"),
        other => other.to_string(),
    }
}

/// A call in Python: the arguments that have no names, then the entries.
pub fn python_call(function: &str, begin: &[Value], entries: &Table) -> String {
    let named = entries.iter().map(|(name, value)| format!("{}={}", name.replace('-', "_"), literal(value)));
    let all: Vec<String> = begin.iter().map(literal).chain(named).collect();
    format!("{function}({})", all.join(", "))
}

/// A value as Python writes it.
pub fn literal(value: &Value) -> String {
    let several = |items: Vec<String>| items.join(", ");
    match value {
        Value::Boolean(true) => "True".to_owned(),
        Value::Boolean(false) => "False".to_owned(),
        Value::Float(number) if !number.is_finite() => format!("float('{number}')"),
        Value::Float(number) => format!("{number:?}"),
        Value::String(text) => quoted(text),
        Value::Array(items) => format!("[{}]", several(items.iter().map(literal).collect())),
        Value::Table(entries) => {
            let entry = |(name, value): (&String, &Value)| format!("{}: {}", quoted(name), literal(value));
            format!("{{{}}}", several(entries.iter().map(entry).collect()))
        }
        other => other.to_string(),
    }
}

/// A text as Python writes it.
fn quoted(text: &str) -> String {
    let mut all = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => all.extend(['\\', letter]),
            letter if letter.is_control() => {
                let _ = write!(all, "\\u{:04x}", u32::from(letter));
            }
            letter => all.push(letter),
        }
    }
    all + "\""
}

/// Paths as names.
pub fn shown(paths: &[PathBuf]) -> Vec<String> {
    paths.iter().map(|path| path.display().to_string()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, Default, Deserialize, PartialEq, Serialize)]
    #[serde(default, deny_unknown_fields)]
    pub(super) struct Job {
        #[serde(deserialize_with = "names")]
        pub law: Vec<String>,
        #[serde(with = "table")]
        pub fix: Vec<Entry<f64>>,
        #[serde(with = "table")]
        pub range: Vec<Entry<[f64; 2]>>,
        pub tol: Option<f64>,
        pub seed: Option<u64>,
        pub axis: bool,
    }

    fn job(text: &str) -> Job {
        toml::from_str(text).unwrap()
    }

    #[test]
    fn a_file_has_what_was_given_and_no_more() {
        let all =
            "axis = true\nlaw = [\"a\", \"b\"]\nseed = 7\ntol = 1e-8\n\n[fix]\nm = 1.0\n\n[range]\nk = [0.5, 1e6]\n";
        let text = text(&job(all)).unwrap();
        assert_eq!(job(&text), job(all));
        assert_eq!(super::text(&Job::default()).unwrap(), "");
        assert_eq!(job("law = \"a\"").law, ["a"]);
    }

    #[test]
    fn what_is_given_takes_precedence_entry_by_entry() {
        let file = job("law = [\"a\"]\ntol = 1e-3\nfix = { m = 1, k = 2 }");
        let given = job("law = [\"b\", \"c\"]\nfix = { k = 3 }");
        let both = job("law = [\"b\", \"c\"]\ntol = 1e-3\nfix = { k = 3, m = 1 }");
        assert_eq!(given_over(&given, &file).unwrap(), both);
        let large = Job { seed: Some(u64::MAX), ..Job::default() };
        assert!(given_over(&large, &file).is_err(), "no file can hold it");
    }

    #[test]
    fn texts_are_quoted_for_their_readers() {
        let given = job("law = [\"a b\", \"it's\"]\naxis = true\ntol = 1e-8\nrange = { \"s - k\" = [0, 1e6] }");
        let entries = entries(&given).unwrap();
        let line = command_line(&["stribeck", "identify", "my file.csv"], &entries).unwrap();
        let words = shlex::split(&line).unwrap();
        let options = ["--axis", "--law", "a b", "--law", "it's", "--range", "s - k=0.0:1000000.0", "--tol", "1e-8"];
        assert_eq!(words, [&["stribeck", "identify", "my file.csv"], &options[..]].concat());
        let begin = [Value::String("C:\\new \"one\"\n".into()), Value::Float(f64::NEG_INFINITY)];
        assert_eq!(
            python_call("f", &begin, &entries),
            "f(\"C:\\\\new \\\"one\\\"\\u000a\", float('-inf'), axis=True, law=[\"a b\", \"it's\"], range={\"s - k\": \
             [0.0, 1000000.0]}, tol=1e-8)"
        );
    }

    #[test]
    fn entries_of_the_command_line_name_what_is_wrong() {
        let refusal = |error: Fault| error.to_string();
        assert_eq!("k = 1e3 ".parse::<Entry<f64>>().unwrap(), Entry("k".into(), 1e3));
        assert_eq!("k=1:2e3".parse::<Entry<[f64; 2]>>().unwrap(), Entry("k".into(), [1.0, 2e3]));
        assert_eq!(refusal("k=x".parse::<Entry<f64>>().unwrap_err()), "k = x: must be a number");
        assert_eq!(refusal("k".parse::<Entry<String>>().unwrap_err()), "'k': must be NAME=VALUE");
        assert_eq!(refusal("k=1".parse::<Entry<[f64; 2]>>().unwrap_err()), "k = 1: must be LOW:HIGH");
    }
}
